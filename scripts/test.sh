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
# Not nextest, even where it is: it starts every test in a process of its own, and the tests of a program share one device, one set
# of pipelines and the bundled world.
native() { cargo test --locked --no-fail-fast; }
built_page() { wait $page; local code=$?; cat "$page_log"; return $code; }
browser() {
  OCEAN_GLOBE_PAGE=$QUICK_PAGE OCEAN_GLOBE=$TARGET_DIR/debug/ocean-globe \
    node --test --test-reporter=spec tests/browser/pages.test.mjs
}

# The page is built meanwhile: compilers and native tests leave a core idle at times. What it had to say comes after the tests.
page_log=$(mktemp)
scripts/page.sh >"$page_log" 2>&1 & page=$!
trap 'kill $page 2>/dev/null; rm -f "$page_log"' EXIT
stage "native tests" native
stage "the page" built_page
stage "browser tests" browser
if [ ${#failed[@]} -gt 0 ]; then printf '\nFailed: %s\n' "$(IFS=,; echo "${failed[*]}")"; exit 1; fi
printf '\nAll tests passed after %s s\n' "$SECONDS"
