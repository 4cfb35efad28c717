# Sourced by the other scripts: goes to the project's folder and puts its tools first on PATH.

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

# Tools of the project's own live here and nowhere else; delete it to start afresh.
CACHE=${OCEAN_GLOBE_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/ocean-globe}
TARGET_DIR=${CARGO_TARGET_DIR:-target}
# The page that make run serves and the browser tests visit (page.sh).
QUICK_PAGE=$TARGET_DIR/page
export PATH="$CACHE/bin:$PATH"

# For web builds: the wasm32 standard library may come from a toolchain of its own (setup-wasm-debian.sh).
web() {
  if [ -f "$CACHE/wasm-toolchain" ]; then RUSTUP_TOOLCHAIN=$(cat "$CACHE/wasm-toolchain") "$@"; else "$@"; fi
}

# True when nothing that a page is made of is newer than this mark. Folders count: their time changes with what is deleted.
is_built() {
  [ -e "$1" ] && [ -z "$(find .cargo src shaders www scripts Cargo.toml Cargo.lock Trunk.toml -path scripts/serve -prune -o -newer "$1" -print -quit)" ]
}

# compiling NAME LOG CRATES MINUTES COMMAND...: runs a compilation of about so many crates into a log, and tells every 20 s how far it is.
compiling() {
  local name=$1 log=$2 crates=$3 minutes=$4 start=$SECONDS told=$SECONDS job
  shift 4
  mkdir -p "$(dirname "$log")"
  printf '  %s: compiles; a first time usually takes %s minutes on two cores\n' "$name" "$minutes"
  # A group of its own, to end with all that it has started: Ctrl-C does not reach what runs in the background.
  set -m; "$@" >"$log" 2>&1 </dev/null & job=$!; set +m
  trap "kill -- -$job 2>/dev/null || true" EXIT
  while kill -0 $job 2>/dev/null; do
    sleep 0.2
    if [ $((SECONDS - told)) -ge 20 ]; then
      told=$SECONDS
      printf '  %s: %s of about %s crates after %s s\n' "$name" "$(grep -c '^ *Compiling' "$log")" "$crates" $((SECONDS - start))
    fi
  done
  trap - EXIT
  wait $job
}
