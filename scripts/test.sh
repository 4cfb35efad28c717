#!/usr/bin/env bash
# Runs every test. All stages run, so that one report shows all that is wrong; the exit code is 0 only when none is.
set -uo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
scripts/setup.sh test || exit

failed=()
stage() {  # NAME COMMAND...
  local name=$1 start=$SECONDS; shift
  printf '\n== %s\n' "$name"
  "$@" || failed+=("$name")
  printf '== %s: %s s\n' "$name" $((SECONDS - start))
}
native() {
  if cargo nextest --version >/dev/null 2>&1; then
    cargo nextest run --locked --no-fail-fast && cargo test --locked --doc
  else
    cargo test --locked --no-fail-fast
  fi
}
# The same page, built quickly: the profile web-test, and no wasm-opt as it is no release.
page() { web trunk build --dist "$TARGET_DIR/test-page"; }
browser() {
  OCEAN_GLOBE_PAGE=$TARGET_DIR/test-page OCEAN_GLOBE=$TARGET_DIR/debug/ocean-globe \
    node --test --test-concurrency=1 --test-reporter=spec tests/browser/*.test.mjs
}

stage "the page" page
stage "native tests" native
stage "browser tests" browser
if [ ${#failed[@]} -gt 0 ]; then printf '\nFailed: %s\n' "$(IFS=,; echo "${failed[*]}")"; exit 1; fi
printf '\nAll tests passed after %s s\n' "$SECONDS"
