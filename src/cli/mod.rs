//! Floor 6: the native command line; one file per command.

pub mod bake;
pub mod bench;
pub mod progress;
pub mod render;
pub mod run;
pub mod sample;
pub mod serve;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use render::command::{self, RenderArgs};

use crate::error::Result;

/// A living ocean on the whole WGS84 globe: render it, measure it, serve it.
#[derive(Parser, Debug)]
#[command(version, about)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand, Debug)]
enum Command {
    Render(RenderArgs),
    Sample(sample::SampleArgs),
    Serve(serve::ServeArgs),
    Run(run::RunArgs),
    Bench(bench::BenchArgs),
    Bake(Box<bake::BakeArgs>),
}

fn run(command: &Command) -> Result<()> {
    match command {
        Command::Render(args) => command::run(args),
        Command::Sample(args) => sample::sample(args).map(|found| println!("{found:#}")),
        Command::Serve(args) => serve::run(args),
        Command::Run(args) => run::run(args),
        Command::Bench(args) => bench::run(args),
        Command::Bake(args) => bake::bake(args),
    }
}

/// Reads the command line, runs the command and returns the process's exit code: 0 done, 1 failed, 2 misused.
pub fn main() -> ExitCode {
    env_logger::Builder::from_env(env_logger::Env::default().default_filter_or("ocean_globe=warn,error"))
        .filter_module("wgpu_hal", log::LevelFilter::Off)
        .format_target(false)
        .format_timestamp(None)
        .init();
    match run(&Cli::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
