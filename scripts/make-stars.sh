#!/usr/bin/env bash
# Makes what the night shows, from the npm package d3-celestial: src/data/stars.bin, the stars to magnitude 6 of the catalogue XHIP
# (E. Anderson and C. Francis 2012, VizieR V/137D), and src/data/milky_way.bin, from its outlines of the Milky Way at five brightnesses.
# Needs npm and node. The same input gives the same bytes.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
PACKAGE=d3-celestial@0.7.35
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$folder" && npm pack --silent "$PACKAGE" >/dev/null && tar xzf d3-celestial-*.tgz package/data/stars.6.json package/data/mw.json) || {
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
# A digit, 0 to 15, for each of 16,384 places spread evenly over the sky (src/data/milky_way.rs): how many of the outlines a place lies in, in the
# mean of the places around it; two to a byte, the first one low.
node - "$folder/package/data/mw.json" src/data/milky_way.bin <<'JS'
const fs = require('node:fs');
const [, , from, to] = process.argv;
const PLACES = 16384, SPREAD = 0.9, RAD = Math.PI / 180;
const outlines = JSON.parse(fs.readFileSync(from, 'utf8')).features.map(feature => feature.geometry.coordinates.flat());
// Inside an odd number of rings, by the crossings of the meridian south of the place; a step over 180 degrees is one to the other side.
const wrap = degrees => ((degrees + 540) % 360) - 180;
const inside = (rings, ra, dec) => {
  let odd = false;
  for (const ring of rings) for (let i = 1; i < ring.length; i++) {
    const a = wrap(ring[i - 1][0] - ra), b = a + wrap(ring[i][0] - ring[i - 1][0]);
    if ((a < 0) === (b < 0) || Math.abs(a) > 90) continue;
    if (ring[i - 1][1] + (ring[i][1] - ring[i - 1][1]) * a / (a - b) < dec) odd = !odd;
  }
  return odd;
};
const around = [[0, 0], ...Array.from({ length: 8 }, (_, i) => [Math.cos(i * Math.PI / 4), Math.sin(i * Math.PI / 4)])];
const digits = Array.from({ length: PLACES }, (_, i) => {
  const dec = Math.asin(1 - (2 * i + 1) / PLACES) / RAD, ra = (i * 137.50776405003785) % 360;
  let sum = 0;
  for (const [x, y] of around) {
    const d = Math.max(-89.9, Math.min(89.9, dec + SPREAD * y)), r = ra + SPREAD * x / Math.max(Math.cos(dec * RAD), 0.02);
    for (const rings of outlines) sum += inside(rings, r, d) ? 1 : 0;
  }
  return Math.round(sum / around.length / outlines.length * 15);
});
fs.writeFileSync(to, Buffer.from(Array.from({ length: PLACES / 2 }, (_, i) => digits[2 * i] | digits[2 * i + 1] << 4)));
console.log(`${to}: ${digits.filter(d => d > 0).length} of ${PLACES} places shine`);
JS
