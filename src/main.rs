//! The native command line. In the browser `src/web.rs` is the entrance and this does nothing.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    ocean_globe::cli::main()
}

#[cfg(target_arch = "wasm32")]
fn main() {}
