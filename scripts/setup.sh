#!/usr/bin/env bash
# Installs what a fresh machine lacks: `setup.sh compiler` for compiling the page, `run` for serving it, `build` for making it
# small, `test` for what tests need besides a page. Nothing that is there already, so a second run takes a second. Needs rustup's
# Rust, Node with npm and, for tests, root or sudo for apt-get, or Firefox, Chromium and a Vulkan driver that are there already.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"

TRUNK=0.21.14     # 0.22 needs Rust 1.96
BINARYEN=132.0.0  # Trunk.toml names it too; Debian's version 108 makes a page that does not start
WASM_BINDGEN=$(awk '/^name = "wasm-bindgen"$/ { getline; gsub(/[^0-9.]/, ""); print; exit }' Cargo.lock)
RUST=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
NODE=20
TARGET=wasm32-unknown-unknown

fail() { printf '\nSet-up failed: %s\n  What to do: %s\n' "$1" "$2" >&2; exit 1; }

# step NAME CHECK INSTALL REMEDY [CRATES MINUTES]: installs what the check does not find, tells the seconds, and shows the end of the
# log on failure. With the last two it is a compilation, which tells how far it is.
step() {
  if $2 >/dev/null 2>&1; then printf '  ready    %s\n' "$1"; return; fi
  printf '  install  %s …\n' "$1"
  local start=$SECONDS log="$CACHE/log/$3.log"
  mkdir -p "$CACHE/bin" "$CACHE/log"
  if ! installed "$1" "$log" "$3" "${@:5}" || ! $2 >>"$log" 2>&1; then tail -n 20 "$log" >&2; fail "$1 (log: $log)" "$4"; fi
  printf '           %s installed in %s s\n' "$1" $((SECONDS - start))
}

installed() {  # NAME LOG INSTALL [CRATES MINUTES]
  if [ $# -gt 3 ]; then compiling "$1" "$2" "$4" "$5" "$3"; else $3 >"$2" 2>&1; fi
}

# grep without -q, throughout: it would close the pipe early, and pipefail counts that as a failure.
at_least() { [ "$(printf '%s\n%s\n' "$1" "$2" | sort -V | head -n 1)" = "$1" ]; }
is_version() { command -v "$1" && "$1" --version | grep -w -- "$2"; }

# ---- WebAssembly's standard library -------------------------------------------------------------------------------------
has_wasm_std() { ls "$(web rustc --print sysroot)/lib/rustlib/$TARGET/lib/"libstd-*.rlib; }
get_wasm_std() { rustup target add $TARGET || scripts/setup-wasm-debian.sh "$CACHE" $TARGET; }

# ---- Programs written in Rust: a prebuilt one where cargo-binstall finds one, else compiled the quick way ---------------------
# Compiled without optimisation, except where a minute of work is done with them: half the time of their own release profiles.
cargo_install() {  # CRATE VERSION [cargo install's options]
  local crate=$1 version=$2; shift 2
  if command -v cargo-binstall &&
    cargo binstall "$crate@$version" --no-confirm --disable-strategies compile --install-path "$CACHE/cargo/bin"; then return; fi
  export CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
  export CARGO_PROFILE_RELEASE_DEBUG=0 CARGO_INCREMENTAL=0 CARGO_TARGET_DIR="$CACHE/build"
  # A mirror of the registry may lag behind the program's own lock file; then its version requirements must do.
  cargo install "$crate" --version "$version" --root "$CACHE/cargo" --force --locked "$@" ||
    cargo install "$crate" --version "$version" --root "$CACHE/cargo" --force "$@"
}
link_tool() { ln -sfn "$CACHE/cargo/bin/$1" "$CACHE/bin/$1"; }
has_wasm_bindgen() { is_version wasm-bindgen "$WASM_BINDGEN"; }
get_wasm_bindgen() {
  local fast=() name
  for name in walrus wasmparser wasm-encoder wasm-bindgen-cli-support; do
    fast+=(--config "profile.release.package.$name.opt-level=2")
  done
  (cargo_install wasm-bindgen-cli "$WASM_BINDGEN" --bin wasm-bindgen "${fast[@]}") && link_tool wasm-bindgen
}
has_trunk() { is_version trunk "$TRUNK"; }
# Its TLS is for `trunk serve` and for downloading the tools that stand here already.
get_trunk() { (cargo_install trunk "$TRUNK" --no-default-features) && link_tool trunk; }

# ---- Programs from npm ------------------------------------------------------------------------------------------------------
has_wasm_opt() { is_version wasm-opt "${BINARYEN%%.*}"; }
get_wasm_opt() {
  npm install --prefix "$CACHE/npm" --no-audit --no-fund --save-exact "binaryen@$BINARYEN" &&
    ln -sfn "$CACHE/npm/node_modules/.bin/wasm-opt" "$CACHE/bin/wasm-opt"
}
# What a folder's packages were installed from stands beside them: each checkout has its own.
has_packages() { cmp "$1/package-lock.json" "$1/node_modules/.installed-from.json"; }
get_packages() { npm ci --prefix "$1" --no-audit --no-fund && cp "$1/package-lock.json" "$1/node_modules/.installed-from.json"; }
has_server() { has_packages scripts/serve; }
get_server() { get_packages scripts/serve; }
has_test_packages() { has_packages tests/browser; }
get_test_packages() { get_packages tests/browser; }

# ---- For tests: two browsers and a Vulkan driver ---------------------------------------------------------------------------------
apt_install() {
  local root=""
  command -v apt-get || { echo "no apt-get here"; return 1; }
  [ "$(id -u)" = 0 ] || { sudo -n true && root=sudo; } || { echo "neither root nor sudo without a password"; return 1; }
  $root apt-get update || true
  $root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
}
has_firefox() { node tests/browser/lib/find.mjs firefox; }
get_firefox() { apt_install firefox-esr; }
has_chromium() { node tests/browser/lib/find.mjs chromium; }
get_chromium() { apt_install chromium; }
# A driver for the hardware that is there, or Mesa's lavapipe, which needs none. macOS has Metal.
has_vulkan() {
  [ "$(uname)" != Linux ] && return
  [ -n "${VK_DRIVER_FILES:-${VK_ICD_FILENAMES:-}}" ] && return
  { ldconfig -p 2>/dev/null || /sbin/ldconfig -p; } | grep 'libvulkan\.so\.1' || return 1
  driver 'lvp_icd*' || { { [ -e /dev/dri/renderD128 ] || [ -e /dev/nvidia0 ]; } && driver '*.json'; }
}
driver() {
  local folder
  for folder in /usr/share/vulkan/icd.d /usr/local/share/vulkan/icd.d /etc/vulkan/icd.d; do
    compgen -G "$folder/$1" && return
  done
  return 1
}
get_vulkan() { apt_install libvulkan1 mesa-vulkan-drivers; }

# ---- The steps ------------------------------------------------------------------------------------------------------------
what=${1:-run}
case $what in compiler | run | build | test) ;; *) fail "unknown argument $what" "scripts/setup.sh compiler, run, build or test" ;; esac
printf 'Set-up (own tools in %s)\n' "$CACHE"

command -v cargo >/dev/null || fail "no Rust here" "install it from https://rustup.rs, then open a new shell"
rust=$(rustc --version | cut -d ' ' -f 2)
at_least "$RUST" "$rust" || fail "Rust $rust is too old" "rustup update stable (at least $RUST)"
command -v npm >/dev/null || fail "no Node.js with npm here" "install Node.js $NODE or newer, from https://nodejs.org or your system"
node=$(node --version); at_least "$NODE" "${node#v}" || fail "Node.js $node is too old" "install version $NODE or newer"

online="see the log; with a network that reaches the crate and npm registries, run it again: it goes on where it stopped"
step "Rust's $TARGET" has_wasm_std get_wasm_std "install Rust with rustup, then: rustup target add $TARGET"
if [ "$what" = run ] || [ "$what" = build ]; then
  step "wasm-bindgen $WASM_BINDGEN" has_wasm_bindgen get_wasm_bindgen "$online" 160 '1 to 2'
  if [ "$what" = build ]; then step "Trunk $TRUNK" has_trunk get_trunk "$online" 370 '2 to 5'; fi
  rm -rf "$CACHE/build"
fi
if [ "$what" = run ] || [ "$what" = test ]; then step "server of make run" has_server get_server "$online"; fi
if [ "$what" = build ]; then step "wasm-opt ${BINARYEN%%.*} (binaryen)" has_wasm_opt get_wasm_opt "$online"; fi
if [ "$what" = test ]; then
  step "Firefox" has_firefox get_firefox "install Firefox, or set FIREFOX=/path/to/its/program"
  step "Chromium" has_chromium get_chromium "install Chromium or Chrome, or set CHROMIUM=/path/to/its/program"
  step "Vulkan driver" has_vulkan get_vulkan "install your graphics card's driver or Mesa's lavapipe (Fedora: mesa-vulkan-drivers, Arch: vulkan-swrast)"
  step "test packages" has_test_packages get_test_packages "$online"
fi
printf 'Set-up ready after %s s\n\n' "$SECONDS"
