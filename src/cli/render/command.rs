//! `ocean-globe render`: a picture, a measured layer or a flight's pictures.

use std::path::{Path, PathBuf};

use clap::Args;

use super::flight::{self, FlightArgs};
use super::{LayerName, headless, measure, parse_size, parse_state, picture, write_jpeg, write_npy, write_png};
use crate::error::{Error, Result};
use crate::renderer::Radiance;
use crate::scene::view::named::{VIEWS, View};
use crate::scene::view::state::ViewState;

/// Draw a view into a PNG, a flight into numbered PNGs, or measure a view into a NumPy array.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  ocean-globe render --state '#view=38.5,-28.6,560,300,78&wind=12@240&time=2026-06-21T15:00:00Z' -o sea.png
  ocean-globe render --state '#view=20,-30,2e7' --size 1024x1024 -o globe.jpg
  ocean-globe render --views --size 320x180 -o views.jpg
  ocean-globe render --state '#view=38.5,-28.6,560,300,78' --layer depth -o depth.npy
  ocean-globe render --flight globe gale --frames 300 --size 1920x1080 -o flight
  ocean-globe render --flight '#view=28,-14,3e7&bft=8&time=2026-11-20T12:00:00Z&rate=0' '#view=28.8545,-13.792,2,253,80' -o dive
  ocean-globe render --flight surf surf --frames 10 --fps 1.25 -o wave      ten pictures of one view, 0.8 s apart
  ffmpeg -framerate 30 -i flight/%05d.png -pix_fmt yuv420p flight.mp4     makes a film of a flight

A flight rises and falls in an arc. Sea and clock are those of its first view: the clock runs from that view's time at that view's
rate, --fps frames to the second; rate=0 stands still. Given again, the command draws only the frames that are missing or damaged; a
folder with the frames of another flight, size or version is refused. flight.json in it says what the frames show.")]
pub struct RenderArgs {
    /// The view: a link's fragment, as the page's address shows it.
    #[arg(long, default_value = "")]
    pub state: String,
    #[command(flatten)]
    #[expect(missing_docs, reason = "its options have their own")]
    pub flight: FlightArgs,
    /// Width and height in pixels.
    #[arg(long, default_value = "1280x720")]
    pub size: String,
    /// What to write instead of the picture.
    #[arg(long, value_enum)]
    pub layer: Option<LayerName>,
    /// All named views, one below another, instead of one view.
    #[arg(long, conflicts_with_all = ["state", "layer", "flight"])]
    pub views: bool,
    /// The file to write: .png or .jpg for a picture, .npy for a layer; of a flight the folder.
    #[arg(short, long)]
    pub output: PathBuf,
    /// The folder of the world's archives.
    #[arg(long, default_value = "www/data")]
    pub data: String,
}

/// Pictures of a sheet are drawn so many times as wide and high first.
const FINER: u32 = 4;

/// Runs the command.
///
/// # Errors
/// What was wrong with the options, the data or the device.
pub fn run(args: &RenderArgs) -> Result<()> {
    if let Some([from, to]) = args.flight.flight.as_deref() {
        return flight::run([from, to], &args.flight, &args.size, &args.output, &args.data);
    }
    let size = parse_size(&args.size)?;
    let Some(layer) = args.layer else {
        let states = if args.views { VIEWS.iter().map(View::state).collect() } else { vec![parse_state(&args.state)?] };
        return pictures(&states, size, &args.output, &args.data);
    };
    let state = parse_state(&args.state)?;
    is_named(&args.output, &["npy"])?;
    let radiance = if layer.is_of_light() { Radiance::Whole } else { Radiance::Single };
    let mut renderer = headless(&args.data, radiance)?;
    write_npy(&args.output, &measure(&mut renderer, &state, size, layer)?)
}

/// Pictures of states, one below another, in a file.
fn pictures(states: &[ViewState], size: [u32; 2], output: &Path, data: &str) -> Result<()> {
    let write = if is_named(output, &["png", "jpg", "jpeg"])? == "png" { write_png } else { write_jpeg };
    let mut renderer = headless(data, Radiance::Half)?;
    let mut all = Vec::new();
    // Stars, foam and crests of a small picture are those of a larger one seen from farther away.
    let times = if states.len() > 1 { FINER } else { 1 };
    for state in states {
        let fine = size.map(|side| side * times);
        all.extend(shrunk(&picture(&mut renderer, state, fine)?, fine[0] as usize, times as usize));
    }
    write(output, [size[0], size[1] * states.len() as u32], &all)
}

/// An RGBA picture of rows of `width` pixels with one pixel, their mean, for each square of `times` by `times`.
fn shrunk(rgba: &[u8], width: usize, times: usize) -> Vec<u8> {
    let row = 4 * width;
    let mean = |top: usize, left: usize, part: usize| {
        let values =
            (0..times * times).map(|i| usize::from(rgba[(top + i / times) * row + 4 * (left + i % times) + part]));
        (values.sum::<usize>() / (times * times)) as u8
    };
    let rows = (0..rgba.len() / row).step_by(times);
    rows.flat_map(|top| (0..width).step_by(times).flat_map(move |left| (0..4).map(move |part| (top, left, part))))
        .map(|(top, left, part)| mean(top, left, part))
        .collect()
}

/// The ending of a file's name, which must be one of these.
fn is_named<'a>(output: &Path, endings: &[&'a str]) -> Result<&'a str> {
    let found = output.extension().and_then(|found| endings.iter().find(|ending| found.eq_ignore_ascii_case(ending)));
    let wanted = || format!("name a file that ends in .{}", endings.join(" or ."));
    found.copied().ok_or_else(|| Error::bad_value("output", output.display(), wanted()))
}
