# Sourced by the other scripts: goes to the project's folder and puts its tools first on PATH.

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

# Tools of the project's own live here and nowhere else; delete it to start afresh.
CACHE=${OCEAN_GLOBE_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/ocean-globe}
TARGET_DIR=${CARGO_TARGET_DIR:-target}
export PATH="$CACHE/bin:$PATH"

# For web builds: the wasm32 standard library may come from a toolchain of its own (setup-wasm-debian.sh).
web() {
  if [ -f "$CACHE/wasm-toolchain" ]; then RUSTUP_TOOLCHAIN=$(cat "$CACHE/wasm-toolchain") "$@"; else "$@"; fi
}
