//! `ocean-globe render --flight`: a flight from one view to another, as numbered pictures in a folder.
//!
//! Each frame is what `render` draws of its view and instant, whatever came before it: a flight can be stopped and taken up again.
//! A frame gets its name when all of it is on the disk, and the folder's `flight.json` says which flight its frames show.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use clap::Args;
use serde::{Deserialize, Serialize};

use super::{headless, instant, parse_size, parse_state, picture, write_png};
use crate::cli::progress::bar;
use crate::error::{Error, Result};
use crate::renderer::{Radiance, Renderer};
use crate::scene::time::SceneTime;
use crate::scene::view::camera::Camera;
use crate::scene::view::flight::Flight;
use crate::scene::view::named::VIEWS;
use crate::scene::view::state::ViewState;

/// The options of a flight.
#[derive(Args, Debug)]
pub struct FlightArgs {
    /// Fly from one view to another: ids of named views (globe, ocean, mediterranean, islands, lagoon, coast, bridge, surf, calm, breeze, gale, hurricane, sunset, moonlit,
    /// underwater) or fragments.
    #[arg(long, num_args = 2, value_names = ["FROM", "TO"], conflicts_with_all = ["state", "layer"])]
    pub flight: Option<Vec<String>>,
    /// Pictures of a flight.
    #[arg(long, default_value_t = 300, requires = "flight", value_parser = clap::value_parser!(u32).range(2..=99_999))]
    pub frames: u32,
    /// Pictures of a flight in a second.
    #[arg(long, default_value_t = 30.0, requires = "flight")]
    pub fps: f64,
}

/// Name of the record beside the frames.
const RECORD: &str = "flight.json";
/// What one does about a folder that holds something else.
const ANOTHER_FOLDER: &str = "name an empty folder with -o";

/// What the frames of a folder show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Record {
    program: String,
    from: String,
    to: String,
    frames: u32,
    fps: f64,
    size: [u32; 2],
    /// Instant of the first frame, UTC seconds since 1970.
    start_unix_s: f64,
}

impl Record {
    /// The first field, by name, in which another record differs. The start counts where the first view has an instant.
    fn difference(&self, other: &Self, starts_now: bool) -> Option<&'static str> {
        let fields = [
            ("program's version", self.program != other.program),
            ("first view", self.from != other.from),
            ("second view", self.to != other.to),
            ("number of frames", self.frames != other.frames),
            ("frames per second", self.fps != other.fps),
            ("size", self.size != other.size),
            ("time", !starts_now && self.start_unix_s != other.start_unix_s),
        ];
        fields.into_iter().find(|(_, differs)| *differs).map(|(name, _)| name)
    }
}

/// The state of a named view's id, or of a link's fragment.
fn end(text: &str) -> Result<ViewState> {
    if let Some(view) = VIEWS.iter().find(|view| view.id == text) {
        return Ok(view.state());
    }
    if !text.contains(['=', '/']) {
        let ids: Vec<_> = VIEWS.iter().map(|view| view.id).collect();
        return Err(Error::bad_value("flight", text, format!("give a link's fragment or one of {}", ids.join(", "))));
    }
    parse_state(text)
}

/// Keys of the sea and the clock in which two states differ.
fn differences(a: &ViewState, b: &ViewState) -> Vec<String> {
    let pairs = |state: &ViewState| {
        let bare = ViewState { camera: Camera::default(), ride: false, unknown: Vec::new(), ..state.clone() };
        bare.format_fragment(None).split('&').map(str::to_owned).collect::<Vec<_>>()
    };
    let (a, b) = (pairs(a), pairs(b));
    let apart = a.iter().filter(|pair| !b.contains(pair)).chain(b.iter().filter(|pair| !a.contains(pair)));
    let mut keys: Vec<_> = apart.filter_map(|pair| Some(pair.split_once('=')?.0.to_owned())).collect();
    keys.sort();
    keys.dedup();
    keys
}

/// The frames of a flight in the sea of its first view, under that view's clock.
struct Frames {
    from: ViewState,
    to: ViewState,
    flight: Flight,
    record: Record,
}

impl Frames {
    /// The state that frame `index` (0…frames − 1) shows: exactly the ends at the ends.
    fn state(&self, index: u32, renderer: &mut Renderer) -> ViewState {
        let last = self.record.frames - 1;
        let along_s = self.flight.duration_s() * f64::from(index) / f64::from(last);
        let unix_seconds = self.record.start_unix_s + self.from.rate * f64::from(index) / self.record.fps;
        let mut camera = self.flight.at(along_s);
        let rides = [&self.from, &self.to].map(|state| f64::from(u8::from(state.ride)));
        let riding = rides[0] + (rides[1] - rides[0]) * self.flight.eased(along_s);
        // An eye that begins or ends its ride on the way is lifted by a part of the wave below it.
        if riding > 0.0 && riding < 1.0 {
            camera = renderer.lifted(&self.from.settings, &camera, riding, unix_seconds);
        }
        ViewState { camera, ride: riding == 1.0, time: SceneTime::At(unix_seconds), ..self.from.clone() }
    }
}

/// Whether a file is a whole picture of the size.
fn is_complete(path: &Path, size: [u32; 2]) -> bool {
    let Ok(bytes) = std::fs::read(path) else { return false };
    let Ok(mut reader) = png::Decoder::new(Cursor::new(bytes)).read_info() else { return false };
    let fits = [reader.info().width, reader.info().height] == size;
    let Some(room) = reader.output_buffer_size().filter(|_| fits) else { return false };
    reader.next_frame(&mut vec![0; room]).is_ok() && reader.finish().is_ok()
}

/// Gives a file its name when `write` has written all of it.
fn put(path: &Path, write: impl FnOnce(&Path) -> Result<()>) -> Result<()> {
    let part = path.with_added_extension("part");
    write(&part)?;
    std::fs::rename(&part, path).map_err(|e| Error::io(path.display().to_string(), e, "choose another place with -o"))
}

/// Makes the folder ready for a flight: the record that counts, the old one's where the flight goes on.
fn take_up(folder: &Path, wanted: Record, starts_now: bool) -> Result<Record> {
    let name = folder.display().to_string();
    std::fs::create_dir_all(folder).map_err(|e| Error::io(&name, e, ANOTHER_FOLDER))?;
    let path = folder.join(RECORD);
    let Ok(bytes) = std::fs::read(&path) else {
        let frame = (0..wanted.frames).map(|index| frame_name(folder, index)).find(|frame| frame.exists());
        if let Some(frame) = frame {
            let why = format!("no {RECORD} beside it says what it shows");
            return Err(Error::bad_data(frame.display().to_string(), why, ANOTHER_FOLDER));
        }
        let text =
            serde_json::to_string_pretty(&wanted).map_err(|e| Error::bad_data(RECORD, e.to_string(), "report this"))?;
        let failed = |e| Error::io(path.display().to_string(), e, ANOTHER_FOLDER);
        put(&path, |part| std::fs::write(part, text + "\n").map_err(failed))?;
        return Ok(wanted);
    };
    let kept: Record = serde_json::from_slice(&bytes)
        .map_err(|e| Error::bad_data(path.display().to_string(), e.to_string(), ANOTHER_FOLDER))?;
    match kept.difference(&wanted, starts_now) {
        Some(field) => Err(Error::bad_data(name, format!("holds frames with another {field}"), ANOTHER_FOLDER)),
        None => Ok(kept),
    }
}

fn frame_name(folder: &Path, index: u32) -> PathBuf {
    folder.join(format!("{index:05}.png"))
}

/// Draws the frames that are missing of a flight between two views, ids or fragments, into the folder `folder`.
///
/// # Errors
/// What was wrong with the options, the folder, the data or the device.
pub fn run(ends: [&String; 2], args: &FlightArgs, size: &str, folder: &Path, data: &str) -> Result<()> {
    let ([from, to], size) = ([end(ends[0])?, end(ends[1])?], parse_size(size)?);
    if folder.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png")) {
        return Err(Error::bad_value("output", folder.display(), "a flight is a folder of pictures: name one"));
    }
    if !(args.fps.is_finite() && args.fps > 0.0) {
        return Err(Error::bad_value("fps", args.fps, "give frames per second, e.g. 30"));
    }
    let unused = differences(&from, &to);
    if !unused.is_empty() {
        log::warn!("flight: {} of the second view not used; sea and clock are those of the first", unused.join(", "));
    }
    let starts_now = from.time == SceneTime::Now;
    let wanted = Record {
        program: env!("CARGO_PKG_VERSION").into(),
        from: from.format_fragment(None),
        to: to.format_fragment(None),
        frames: args.frames,
        fps: args.fps,
        size,
        start_unix_s: instant(&from),
    };
    let record = take_up(folder, wanted, starts_now)?;
    let frames = Frames { flight: Flight::new(from.camera, to.camera), from, to, record };
    let paths = (0..args.frames).map(|index| (index, frame_name(folder, index)));
    let missing: Vec<_> = paths.filter(|(_, path)| !is_complete(path, size)).collect();
    let kept = args.frames as usize - missing.len();
    if !missing.is_empty() {
        let mut renderer = headless(data, Radiance::Half)?;
        let bar = bar("frames", args.frames as usize).with_position(kept as u64);
        for (index, path) in &missing {
            renderer.forget();
            let state = frames.state(*index, &mut renderer);
            let rgba = picture(&mut renderer, &state, size)?;
            put(path, |part| write_png(part, size, &rgba))?;
            bar.inc(1);
        }
        bar.finish_and_clear();
    }
    println!("{}: {} frames drawn, {kept} were there", folder.display(), missing.len());
    Ok(())
}
