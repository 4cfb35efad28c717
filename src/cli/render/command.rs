//! `ocean-globe render`: a picture, a measured layer or a flight's pictures.

use std::path::PathBuf;

use clap::Args;

use super::flight::{self, FlightArgs};
use super::{LayerName, headless, measure, parse_size, parse_state, picture, write_npy, write_png};
use crate::error::{Error, Result};
use crate::renderer::Radiance;

/// Draw a view into a PNG, a flight into numbered PNGs, or measure a view into a NumPy array.
#[derive(Args, Debug)]
#[command(after_help = "Examples:
  ocean-globe render --state '#view=38.5,-28.6,560,300,78&wind=12@240&time=2026-06-21T15:00:00Z' -o sea.png
  ocean-globe render --state '#view=20,-30,2e7' --size 1024x1024 -o globe.png
  ocean-globe render --state '#view=38.5,-28.6,560,300,78' --layer depth -o depth.npy
  ocean-globe render --flight globe gale --frames 300 --size 1920x1080 -o flight
  ocean-globe render --flight '#view=28,-14,3e7&bft=8&time=2026-11-20T12:00:00Z&rate=0' '#view=28.8545,-13.792,2,253,80' -o dive
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
    /// The file to write: .png for a picture, .npy for a layer; of a flight the folder.
    #[arg(short, long)]
    pub output: PathBuf,
    /// The folder of the world's archives.
    #[arg(long, default_value = "www/data")]
    pub data: String,
}

/// Runs the command.
///
/// # Errors
/// What was wrong with the options, the data or the device.
pub fn run(args: &RenderArgs) -> Result<()> {
    if let Some([from, to]) = args.flight.flight.as_deref() {
        return flight::run([from, to], &args.flight, &args.size, &args.output, &args.data);
    }
    let (state, size) = (parse_state(&args.state)?, parse_size(&args.size)?);
    let wanted = if args.layer.is_some() { "npy" } else { "png" };
    if args.output.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case(wanted)) {
        return Err(Error::bad_value("output", args.output.display(), format!("name a file that ends in .{wanted}")));
    }
    match args.layer {
        None => {
            let mut renderer = headless(&args.data, Radiance::Half)?;
            write_png(&args.output, size, &picture(&mut renderer, &state, size)?)
        }
        Some(layer) => {
            let mut renderer = headless(&args.data, Radiance::Single)?;
            write_npy(&args.output, &measure(&mut renderer, &state, size, layer)?)
        }
    }
}
