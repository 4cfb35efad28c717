//! The native command line. In the browser `src/web.rs` is the entrance and this does nothing.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    use clap::Parser;
    #[derive(Parser)]
    #[command(version, about)]
    enum T { Render(ocean_globe::cli::render::RenderArgs) }
    match T::parse() { T::Render(a) => if let Err(e) = ocean_globe::cli::render::run(&a) { eprintln!("error: {e}"); return std::process::ExitCode::FAILURE } }
    std::process::ExitCode::SUCCESS
}

#[cfg(target_arch = "wasm32")]
fn main() {}
