//! `ocean-globe bench`: what a frame costs on this machine, as a table and as JSON.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;

use super::render::{draw, headless, parse_size, parse_state};
use crate::error::{Error, Result};
use crate::gpu::texture::{self, Shape};
use crate::renderer::{Radiance, Renderer, TARGET_FORMAT};
use crate::scene::frame::{Frame, Output};
use crate::scene::views::VIEWS;

/// Measure the time of a frame at every named view.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  ocean-globe bench                            a table, 640x360
  ocean-globe bench --size 1920x1080 -o bench.json")]
pub struct BenchArgs {
    /// Width and height in pixels.
    #[arg(long, default_value = "640x360")]
    pub size: String,
    /// Frames per view, back to back; the median counts.
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub frames: u16,
    /// A JSON file to write as well.
    #[arg(short, long)]
    pub output: Option<PathBuf>,
    /// The folder of the world's archives.
    #[arg(long, default_value = "www/data")]
    pub data: String,
}

/// Milliseconds from recording a frame until the device has finished it, and the part of it spent recording.
fn frame_ms(renderer: &mut Renderer, frame: &Frame, target: &wgpu::TextureView) -> Result<[f64; 2]> {
    let gpu = renderer.gpu().clone();
    let start = Instant::now();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    renderer.render(&mut encoder, frame, target);
    let commands = encoder.finish();
    let encoded = start.elapsed();
    gpu.queue.submit([commands]);
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| Error::gpu(e, "try again"))?;
    Ok([start.elapsed(), encoded].map(|time| time.as_secs_f64() * 1e3))
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Runs the command.
///
/// # Errors
/// What was wrong with the options, the data or the device.
pub fn run(args: &BenchArgs) -> Result<()> {
    let size = parse_size(&args.size)?;
    let mut renderer = headless(&args.data, Radiance::Half)?;
    let gpu = renderer.gpu().clone();
    let target =
        gpu.texture("bench", Shape::picture(size[0], size[1]), TARGET_FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT);
    let target = texture::view(&target);
    println!("{}, {}x{}, median of {} frames", gpu.adapter, size[0], size[1], args.frames);
    println!("{:<12} {:>10} {:>12}", "view", "frame ms", "encode ms");
    let mut rows = Vec::new();
    for view in &VIEWS {
        let state = parse_state(&format!("#{}", view.fragment))?;
        let (mut frame, _) = draw(&mut renderer, &state, size, Output::Picture)?;
        let mut times = Vec::new();
        for _ in 0..args.frames {
            // A tenth of a second later each time: nothing may be kept from the frame before.
            frame.unix_seconds += 0.1;
            times.push(frame_ms(&mut renderer, &frame, &target)?);
        }
        let [whole, encode] = [0, 1].map(|part| median(times.iter().map(|t| t[part]).collect()));
        println!("{:<12} {whole:>10.2} {encode:>12.3}", view.id);
        rows.push(serde_json::json!({ "view": view.id, "frame_ms": whole, "encode_ms": encode }));
    }
    let Some(path) = &args.output else { return Ok(()) };
    let record = serde_json::json!({ "adapter": gpu.adapter, "size": size, "frames": args.frames, "views": rows });
    std::fs::write(path, format!("{record:#}\n"))
        .map_err(|e| Error::io(path.display().to_string(), e, "choose another place with -o"))
}
