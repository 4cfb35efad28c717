#!/usr/bin/env bash
# Makes src/data/city_lights.bin, the lights of the night side, from NASA's picture of them (DMSP; Visible Earth) as Debian's package
# xplanet-images has it. Needs apt-get, which downloads the package and installs nothing but djpeg, and node. The same input gives the
# same bytes.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
fail() { printf 'The lights could not be made: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }
if ! command -v djpeg >/dev/null; then
  $([ "$(id -u)" = 0 ] || echo sudo) apt-get install -yq --no-install-recommends libjpeg-turbo-progs >/dev/null ||
    fail 'there is no djpeg' 'apt-get install libjpeg-turbo-progs'
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$folder" && apt-get download -q xplanet-images >/dev/null 2>&1 && dpkg-deb -x xplanet-images_*.deb .) ||
  fail 'xplanet-images could not be had' 'see whether apt-get download xplanet-images works'
djpeg -grayscale -dct int -pnm "$folder/usr/share/xplanet/images/night.jpg" >"$folder/night.pgm"
# Row by row from the north-west: texels from the last one that is lit to the next, base 128, and its value; src/data/city_lights.rs
# reads them.
node - "$folder/night.pgm" src/data/city_lights.bin <<'JS'
const fs = require('node:fs');
const [, , from, to] = process.argv;
const FAINTEST = 12; // what fainter texels show is mostly noise of the picture's compression
const file = fs.readFileSync(from);
const head = file.subarray(0, 32).toString('latin1').match(/^P5\s+2048\s+1024\s+255\s/);
if (!head) throw new Error('night.jpg is not of 2048 x 1024 texels');
const texels = file.subarray(head[0].length);
const bytes = [];
let last = -1, count = 0;
texels.forEach((value, i) => {
  if (value < FAINTEST) return;
  for (let gap = i - last - 1; ; gap >>>= 7) {
    bytes.push(gap & 127 | (gap > 127 ? 128 : 0));
    if (gap < 128) break;
  }
  bytes.push(value);
  last = i;
  count++;
});
fs.writeFileSync(to, Buffer.from(bytes));
console.log(`${to}: ${count} texels, ${bytes.length} bytes`);
JS
