#!/usr/bin/env bash
# Builds the page into dist/, small for its visitors, and the native program; does nothing when nothing has changed.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"

program=$TARGET_DIR/release/ocean-globe
# Trunk empties dist/, so the mark goes with the page that it speaks of.
mark=dist/.built
if [ -x "$program" ] && is_built "$mark"; then exit; fi

scripts/setup.sh build
start=$SECONDS begun=$(mktemp)
printf 'Building the page (a first time takes about 5 minutes on two cores) …\n'
web trunk build --release
printf 'Building the native program (a first time takes about 14 minutes on two cores) …\n'
cargo build --release --locked
# What was edited during the build is newer than the mark, and so is built the next time.
touch -r "$begun" "$mark"; rm "$begun"
printf 'Built after %s s: dist/ and %s\n\n' $((SECONDS - start)) "$program"
