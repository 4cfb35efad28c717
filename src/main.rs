//! The native command line. In the browser `src/web.rs` is the entrance and this does nothing.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    ocean_globe::cli::main()
}

// Without this the linker would leave out the library, and the page would find nothing to call.
#[cfg(target_arch = "wasm32")]
use ocean_globe as _;

#[cfg(target_arch = "wasm32")]
fn main() {}
