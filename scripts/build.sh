#!/usr/bin/env bash
# Builds the page into dist/ and the native program, both for release; does nothing when nothing has changed.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"

program=$TARGET_DIR/release/ocean-globe
# Trunk empties dist/, so the mark goes with the page that it speaks of. Folders count: their time changes with what is deleted.
mark=dist/.built
if [ -x "$program" ] && [ -e "$mark" ] &&
  [ -z "$(find src shaders www scripts Cargo.toml Cargo.lock Trunk.toml -newer "$mark" -print -quit)" ]; then exit; fi

scripts/setup.sh run
start=$SECONDS begun=$(mktemp)
printf 'Building the page (a first time takes several minutes) …\n'
web trunk build --release
printf 'Building the native program …\n'
cargo build --release --locked
# What was edited during the build is newer than the mark, and so is built the next time.
touch -r "$begun" "$mark"; rm "$begun"
printf 'Built after %s s: dist/ and %s\n\n' $((SECONDS - start)) "$program"
