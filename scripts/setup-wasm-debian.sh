#!/usr/bin/env bash
# setup-wasm-debian.sh CACHE TARGET: a WebAssembly standard library where rustup's server cannot be reached, but Debian's can.
# Unpacks Debian's rustc-web (nothing is installed in the system), builds its std for TARGET once, about a minute, and
# registers the result with rustup. The toolchain's name is left in CACHE/wasm-toolchain; web builds then use it.
set -euo pipefail
cache=$1 target=$2
name=ocean-globe-wasm home=$cache/debian-rust usr=$cache/debian-rust/usr

command -v apt-get && command -v dpkg || { echo "rustup failed, and this is no Debian"; exit 1; }
std=$(apt-cache depends libstd-rust-web-dev | awk '/Depends: libstd-rust-web-/ { print $2; exit }')
[ -n "$std" ] || { echo "apt knows no libstd-rust-web: run apt-get update as root"; exit 1; }
llvm=$(apt-cache depends "$std" | awk '/Depends: libllvm/ { print $2; exit }')

rm -rf "$home"; mkdir -p "$home/debs"
(cd "$home/debs" && apt-get download -q rustc-web "$std" libstd-rust-web-dev rust-web-src ${llvm:+"$llvm" libz3-4})
for deb in "$home"/debs/*.deb; do dpkg -x "$deb" "$home"; done
rm -r "$home/debs"

# rustup sets LD_LIBRARY_PATH to the toolchain's lib folder: every library must be reachable there.
host=$(rustc -vV | sed -n 's/^host: //p')
for library in "$usr"/lib/*-linux-gnu/*.so*; do ln -sf "$library" "$usr/lib/"; done
# There is no cargo in it, as Debian's needs libraries of the system: rustup takes the default toolchain's.
# Debian ships no rust-lld; the installed toolchain's does.
lld=$(rustc --print sysroot)/lib/rustlib/$host/bin/rust-lld
mkdir -p "$usr/lib/rustlib/$host/bin"
printf '#!/bin/sh\nexec "%s" "$@"\n' "$lld" > "$usr/lib/rustlib/$host/bin/rust-lld"
chmod +x "$usr/lib/rustlib/$host/bin/rust-lld"
rustup toolchain link $name "$usr"

# Without embedded bitcode a build with LTO ends in "Can't find section .llvmbc".
build=$cache/build-std; rm -rf "$build"; mkdir -p "$build/src"; : > "$build/src/lib.rs"
cat > "$build/Cargo.toml" <<'TOML'
[package]
name = "build-std"
edition = "2021"
[workspace]
[profile.release]
codegen-units = 1
TOML
(cd "$build" && RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Cembed-bitcode=yes CARGO_TARGET_DIR="$build/target" \
  cargo +$name build --release -Zbuild-std=std,panic_abort --target "$target")
mkdir -p "$usr/lib/rustlib/$target/lib"
cp "$build/target/$target"/release/deps/*.rlib "$usr/lib/rustlib/$target/lib/"
rm -rf "$usr/lib/rustlib/$target/lib"/libbuild_std-*.rlib "$build"
echo $name > "$cache/wasm-toolchain"
