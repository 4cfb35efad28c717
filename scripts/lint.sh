#!/usr/bin/env bash
# Format, lints and documentation, with every warning an error.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/env.sh"
cargo fmt --check
cargo clippy --locked --all-targets -- -D warnings
web cargo clippy --locked --target wasm32-unknown-unknown --lib -- -D warnings
RUSTDOCFLAGS="-D warnings" cargo doc --locked --no-deps
