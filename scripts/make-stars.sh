#!/usr/bin/env bash
# Makes src/data/stars.bin, the stars to magnitude 6 that the night shows, from the catalogue XHIP (E. Anderson and C. Francis 2012,
# VizieR V/137D) as the npm package d3-celestial has it. Needs npm and node. The same input gives the same bytes.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
PACKAGE=d3-celestial@0.7.35
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$folder" && npm pack --silent "$PACKAGE" >/dev/null && tar xzf d3-celestial-*.tgz package/data/stars.6.json) || {
  printf 'The catalogue could not be fetched: npm pack %s failed\n  What to do: see whether npm reaches its registry\n' "$PACKAGE" >&2; exit 1; }
# Six bytes each, the brightest first: right ascension, declination (J2000.0), magnitude, B-V; src/data/stars.rs reads them.
node - "$folder/package/data/stars.6.json" src/data/stars.bin <<'JS'
const fs = require('node:fs');
const [, , from, to] = process.argv;
const stars = JSON.parse(fs.readFileSync(from, 'utf8')).features
  .map(({ properties: { mag, bv }, geometry: { coordinates: [ra, dec] } }) => ({ ra: (ra + 360) % 360, dec, mag: +mag, bv: +bv || 0 }))
  .sort((a, b) => a.mag - b.mag || a.ra - b.ra);
const bytes = Buffer.alloc(6 * stars.length);
const byte = x => Math.max(0, Math.min(255, Math.round(x)));
stars.forEach(({ ra, dec, mag, bv }, i) => {
  bytes.writeUInt16LE(Math.round(ra / 360 * 65536) & 65535, 6 * i);
  bytes.writeInt16LE(Math.round(dec / 90 * 32767), 6 * i + 2);
  bytes[6 * i + 4] = byte((mag + 2) * 30);
  bytes[6 * i + 5] = byte((bv + 0.5) * 100);
});
fs.writeFileSync(to, bytes);
console.log(`${to}: ${stars.length} stars, ${bytes.length} bytes`);
JS
