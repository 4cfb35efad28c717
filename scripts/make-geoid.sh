#!/usr/bin/env bash
# Makes src/data/geoid.bin, the height of the geoid EGM96 over the ellipsoid WGS84, of the grid of 15' that Debian's package proj-data has
# (egm96_15.gtx). Needs apt-get, which downloads the package and installs nothing, and node. The same input gives the same bytes.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
fail() { printf 'The geoid could not be made: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$folder" && apt-get download -q proj-data >/dev/null 2>&1 && dpkg-deb -x proj-data_*.deb .) ||
  fail 'proj-data could not be had' 'see whether apt-get download proj-data works'
# Every second node in steps of 0.1 m, from the south-west; each row as its change from west to east less that of the row before, zigzag,
# base 128, deflated; src/data/geoid.rs reads it. Cubic interpolation is then 0.07 m off the whole grid in the mean, 2 m at a trench.
node - "$folder/usr/share/proj/egm96_15.gtx" src/data/geoid.bin <<'JS'
const fs = require('node:fs');
const zlib = require('node:zlib');
const [, , from, to] = process.argv;
const file = fs.readFileSync(from);
const head = [0, 8, 16, 24].map(at => file.readDoubleBE(at)).join();
const [rows, columns] = [32, 36].map(at => file.readInt32BE(at));
if (head !== '-90,-180,0.25,0.25' || rows !== 721 || columns !== 1440) throw new Error('egm96_15.gtx is another grid');
const bytes = [];
let above = new Int32Array(columns / 2);
for (let row = 0; row < rows; row += 2) {
  const changes = new Int32Array(columns / 2);
  let last = 0;
  for (let column = 0; column < columns; column += 2) {
    const value = Math.round(file.readFloatBE(40 + 4 * (row * columns + column)) * 10);
    changes[column / 2] = value - last;
    last = value;
  }
  changes.forEach((change, i) => {
    const difference = change - above[i];
    for (let rest = (difference << 1) ^ (difference >> 31); ; rest >>>= 7) {
      bytes.push(rest & 127 | (rest > 127 ? 128 : 0));
      if (rest < 128) break;
    }
  });
  above = changes;
}
fs.writeFileSync(to, zlib.deflateSync(Buffer.from(bytes), { level: 9 }));
console.log(`${to}: ${fs.statSync(to).size} bytes`);
JS
