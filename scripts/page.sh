#!/usr/bin/env bash
# Builds the page quickly, for make run and the browser tests: little optimised and without wasm-opt, which makes it no faster, only
# smaller (make build makes the small one). Does nothing when nothing has changed.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"

mark=$QUICK_PAGE/.built
if is_built "$mark"; then exit; fi
begun=$(mktemp)

# The program compiles while the tools do, as each leaves a core idle at times.
compile() { web cargo build --locked --target wasm32-unknown-unknown --profile web-test --bin ocean-globe; }
log=$CACHE/log/page.log
scripts/setup.sh compiler
compiling "the page" "$log" 150 '2 to 5' compile & page=$!
trap 'kill $page 2>/dev/null || true' EXIT
scripts/setup.sh run
wait $page || { cat "$log" >&2; exit 1; }
rm -rf "$QUICK_PAGE"
wasm-bindgen --target web --no-typescript --out-dir "$QUICK_PAGE" --out-name ocean-globe \
  "$TARGET_DIR/wasm32-unknown-unknown/web-test/ocean-globe.wasm"
node scripts/assemble.mjs "$QUICK_PAGE"
# What was edited during the build is newer than the mark, and so is built the next time.
touch -r "$begun" "$mark"; rm "$begun"
printf 'The page is built after %s s: %s\n\n' "$SECONDS" "$QUICK_PAGE"
