//! `ocean-globe bench`: what a frame costs on this machine, as tables and as JSON.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;

use super::render::{draw, headless, parse_size, parse_state};
use crate::error::{Error, Result};
use crate::gpu::texture::{self, Shape};
use crate::renderer::{Cost, Radiance, Renderer, TARGET_FORMAT};
use crate::scene::frame::{Frame, Output};
use crate::scene::view::named::VIEWS;
use crate::scene::view::state::ViewState;

mod effects;
mod heights;
mod shores;
mod stages;
use effects::Effects;
use heights::{Height, Heights};
use shores::{ShoreCost, ShoreCosts};

/// Measure the time of a frame at every named view, and what heights, meshes and effects cost.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  ocean-globe bench                            five tables, 640x360
  ocean-globe bench --size 1920x1080 -o bench.json
  ocean-globe bench --state '#view=35.68,-14.25,9,262,75&bft=8&time=2026-11-20T12:00:00Z&quality=extreme' --size 1920x1080
                                               more than a million triangles, waves of 2048 x 2048

The second table says how long each stage of a frame takes by the device's own clock, where it has one.
The third draws one gale from five heights while the eye moves. Its shares say how much longer a frame takes
  tessellation   than on a grid of a sixteenth of the vertices
  updates        than with the same bisected triangles at rest
  noise          than where the wave patches make the far sea as well, without the noise
The fourth says what share of a named view's frame goes when an effect of light is switched off, the fifth what waves by shores take:
  windows        of wave trains, their memory on the device and in the program, and a frame with and without them
  window, node   the processor's time for such a window and for a node of lees; for a water tile from polygons: tile")]
pub struct BenchArgs {
    /// Width and height in pixels.
    #[arg(long, default_value = "640x360")]
    pub size: String,
    /// Frames per view, back to back; the median counts.
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub frames: u16,
    /// This view, a link's fragment, instead of the named ones.
    #[arg(long)]
    pub state: Option<String>,
    /// A JSON file to write as well.
    #[arg(short, long)]
    pub output: Option<PathBuf>,
    /// The folder of the world's archives.
    #[arg(long, default_value = "www/data")]
    pub data: String,
}

/// Scene seconds from one timed frame to the next: nothing may be kept from the frame before.
const STEP_S: f64 = 0.1;

/// Named views whose heights are compared, from the lowest.
const HEIGHTS: [&str; 5] = ["gale", "coast", "islands", "ocean", "globe"];

/// Milliseconds from recording a frame until the device has finished it, and the part of it spent recording.
fn frame_ms(renderer: &mut Renderer, frame: &Frame, target: &wgpu::TextureView) -> Result<[f64; 2]> {
    let gpu = renderer.gpu().clone();
    let wait = || gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| Error::gpu(e, "try again"));
    wait()?;
    let start = Instant::now();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    renderer.render(&mut encoder, frame, target);
    let commands = encoder.finish();
    let encoded = start.elapsed();
    gpu.queue.submit([commands]);
    wait()?;
    Ok([start.elapsed(), encoded].map(|time| time.as_secs_f64() * 1e3))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The views to measure, by name, and those whose heights are compared.
fn views(state: Option<&str>) -> Result<[Vec<(&'static str, ViewState)>; 2]> {
    if let Some(fragment) = state {
        let given = vec![("state", parse_state(fragment)?)];
        return Ok([given.clone(), given]);
    }
    // One sea for all heights: they shall differ in nothing else.
    let heights = HEIGHTS.iter().filter_map(|id| VIEWS.iter().find(|view| view.id == *id)).map(|view| {
        let mut state = view.state();
        state.settings.beaufort = Some(8);
        (view.id, state)
    });
    Ok([VIEWS.iter().map(|view| (view.id, view.state())).collect(), heights.collect()])
}

/// Runs the command.
///
/// # Errors
/// What was wrong with the options, the data or the device.
pub fn run(args: &BenchArgs) -> Result<()> {
    let (size, [views, heights]) = (parse_size(&args.size)?, views(args.state.as_deref())?);
    let mut renderer = headless(&args.data, Radiance::Half)?;
    let gpu = renderer.gpu().clone();
    let target =
        gpu.texture("bench", Shape::picture(size[0], size[1]), TARGET_FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT);
    let target = texture::view(&target);
    println!("{}, {}x{}, median of {} frames", gpu.adapter, size[0], size[1], args.frames);
    let head = ["frame ms", "encode ms", "triangles", "land", "map tiles", "waves"];
    println!("{:<12}{}", "view", head.map(|column| format!(" {column:>10}")).concat());
    let (mut rows, mut staged) = (Vec::new(), Vec::new());
    for (name, state) in &views {
        let (mut frame, _) = draw(&mut renderer, state, size, Output::Picture)?;
        let mut times = Vec::new();
        for _ in 0..args.frames {
            frame.unix_seconds += STEP_S;
            times.push(frame_ms(&mut renderer, &frame, &target)?);
        }
        let [whole, encode] = [0, 1].map(|part| median(times.iter().map(|t| t[part]).collect()));
        let (Cost { triangles, land_triangles, map_tiles, .. }, samples) = (renderer.cost()?, frame.sea.cascades[0].n);
        let waves = format!("4x{samples}²");
        println!(
            "{name:<12} {whole:>10.2} {encode:>10.3} {triangles:>10} {land_triangles:>10} {map_tiles:>10} {waves:>10}"
        );
        rows.push(serde_json::json!({
            "view": name, "frame_ms": whole, "encode_ms": encode, "triangles": triangles,
            "land_triangles": land_triangles, "map_tiles": map_tiles, "samples": samples,
        }));
        staged.push((*name, stages::measure(&mut renderer, &mut frame, &target, args.frames)?));
    }
    drop(renderer);
    print!("\n{}", stages::table(&staged));
    println!("\n{}", Height::head());
    let mut compared = Heights::new(&gpu, &args.data, target.clone(), size)?;
    let mut records = Vec::new();
    for (name, state) in &heights {
        for height in compared.measure(state, args.frames)? {
            println!("{}", height.row());
            records.push(height.json(name));
        }
    }
    drop(compared);
    println!("\n{}", Effects::head());
    let mut effects = Effects::new(&gpu, &args.data, target.clone(), size)?;
    let mut shares = Vec::new();
    for (name, state) in &views {
        let measured = effects.measure(state, args.frames)?;
        println!("{}", Effects::row(name, &measured));
        shares.push(Effects::json(name, &measured));
    }
    drop(effects);
    println!("\n{}", ShoreCost::head());
    let mut costs = ShoreCosts::new(&gpu, &args.data, target, size)?;
    let mut shores = Vec::new();
    for (name, state) in &views {
        if let Some(cost) = costs.measure(state, args.frames)? {
            println!("{}", cost.row(name));
            shores.push(cost.json(name));
        }
    }
    let Some(path) = &args.output else { return Ok(()) };
    let record = serde_json::json!({
        "adapter": gpu.adapter, "size": size, "frames": args.frames, "views": rows, "heights": records,
        "effects": shares, "shores": shores, "stages": stages::json(&staged),
    });
    std::fs::write(path, format!("{record:#}\n"))
        .map_err(|e| Error::io(path.display().to_string(), e, "choose another place with -o"))
}
