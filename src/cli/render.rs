//! Pictures and measured layers without a window; [`command`] is `ocean-globe render`, [`flight`] its pictures of a flight.

use std::time::{Duration, Instant};

use clap::ValueEnum;
use glam::DVec2;

use crate::data::world::World;
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::model::earth::{Ellipsoid, WGS84};
use crate::renderer::{Radiance, Renderer, TARGET_FORMAT};
use crate::scene::frame::{Frame, Output};
use crate::scene::settings::Datum;
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

pub use crate::scene::link::fragment::parse_state;

pub mod command;
pub mod flight;

/// A measured layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LayerName {
    /// Degrees east and north of each pixel; NaN in the sky.
    Lonlat,
    /// Metres of water, 0 on land; NaN in the sky.
    Depth,
    /// Opacity of the water, 0 on land; NaN in the sky.
    Mask,
    /// Metres of the surface over the ellipsoid; NaN in the sky.
    Height,
    /// Unit normal: east, north, up at the eye; NaN in the sky.
    Normal,
    /// Relative luminance of the radiance, before it is exposed.
    Luminance,
    /// Radiance, linear sRGB, before it is exposed: per steradian, in units of the sun's irradiance beyond the air, by moonlight in units of the moon's. One sample a pixel, in
    /// floats of 16 bits where the device blends no others. Not physical: the sun's disc is no brighter than 16 bits hold, the moon's, stars and the Milky Way are as bright as
    /// pictures show them, and under water all is as bright as a camera makes it.
    Radiance,
    /// 0 land, 1 ocean, 2 lake, 3 river; NaN in the sky.
    Class,
    /// Weight of the far (Perlin) field; NaN in the sky.
    PerlinWeight,
    /// Albedo of the ground, linear sRGB, 0 where the sea covers it; NaN in the sky.
    Albedo,
}

impl LayerName {
    /// Whether it is of the picture's light.
    pub fn is_of_light(self) -> bool {
        self.output() == Output::Picture
    }

    fn output(self) -> Output {
        match self {
            Self::Lonlat => Output::LonLat,
            Self::Depth => Output::Depth,
            Self::Mask => Output::Mask,
            Self::Height => Output::Height,
            Self::Normal => Output::Normal,
            Self::Luminance | Self::Radiance => Output::Picture,
            Self::Class => Output::Class,
            Self::PerlinWeight => Output::PerlinWeight,
            Self::Albedo => Output::Albedo,
        }
    }
}

/// A measured layer: `channels` numbers per pixel, rows from the top.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Rows, columns, channels.
    pub shape: [usize; 3],
    /// The values; all but lonlat come from 32-bit floats.
    pub values: Vec<f64>,
    /// Whether 32 bits would lose something: degrees need more.
    pub double: bool,
}

/// Longest side of a picture.
const LARGEST: u32 = 8192;
/// Of JPEGs, 1 to 100.
const JPEG_QUALITY: u8 = 90;
/// How long a render waits for tiles.
const PATIENCE: Duration = Duration::from_secs(120);

/// Width and height from `640x360`.
///
/// # Errors
/// [`Error::BadValue`] for anything else, or sides outside 1 to 8192.
pub fn parse_size(text: &str) -> Result<[u32; 2]> {
    let side = |part: &str| part.trim().parse::<u32>().ok().filter(|n| (1..=LARGEST).contains(n));
    text.split_once(['x', 'X', '×'])
        .and_then(|(w, h)| Some([side(w)?, side(h)?]))
        .ok_or_else(|| Error::bad_value("size", text, format!("give WIDTHxHEIGHT, each 1 to {LARGEST}, e.g. 1280x720")))
}

/// A headless renderer over the world in `data`.
///
/// # Errors
/// [`Error::Gpu`] without a usable device, [`Error::Io`] without the folder.
pub fn headless(data: &str, radiance: Radiance) -> Result<Renderer> {
    std::fs::read_dir(data).map_err(|e| Error::io(data, e, "name the folder of terrain.pmtiles with --data"))?;
    let gpu = pollster::block_on(Gpu::headless())?;
    pollster::block_on(Renderer::with_radiance(gpu, World::open(data), radiance))
}

/// The instant of a state, UTC seconds since 1970; the clock's where the state says `now`.
pub fn instant(state: &ViewState) -> f64 {
    let clock = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0.0, |d| d.as_secs_f64());
    state.time.unix_seconds(clock)
}

/// Loads what a state needs, then draws it into a new texture of [`TARGET_FORMAT`].
///
/// # Errors
/// [`Error::BadData`] or [`Error::Fetch`] when the world's archives cannot be had or do not come in time.
pub fn draw(
    renderer: &mut Renderer,
    state: &ViewState,
    size: [u32; 2],
    output: Output,
) -> Result<(Frame, wgpu::Texture)> {
    let (start, unix_seconds) = (Instant::now(), instant(state));
    let frame = loop {
        // The eye depends on its ground, which may still have to come.
        let eye = renderer.eye(state, unix_seconds);
        let frame = renderer.frame(&state.settings, &eye, unix_seconds, size).measuring(output);
        if renderer.load(&frame) && renderer.eye(state, unix_seconds) == eye {
            break frame;
        }
        if start.elapsed() > PATIENCE {
            return Err(Error::Fetch {
                url: "the world's tiles".into(),
                why: "did not arrive within two minutes".into(),
            });
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    if let Some(why) = renderer.world_mut().failure() {
        return Err(Error::bad_data("the world", why, "name the folder of its archives with --data"));
    }
    let gpu = renderer.gpu().clone();
    let shape = crate::gpu::texture::Shape::picture(size[0], size[1]);
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    let target = gpu.texture("picture", shape, TARGET_FORMAT, usage);
    renderer.settle(&frame);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    renderer.render(&mut encoder, &frame, &crate::gpu::texture::view(&target));
    gpu.queue.submit([encoder.finish()]);
    Ok((frame, target))
}

/// RGBA bytes of a state's picture, rows from the top.
///
/// # Errors
/// As [`draw`], or a lost device.
pub fn picture(renderer: &mut Renderer, state: &ViewState, size: [u32; 2]) -> Result<Vec<u8>> {
    let (_, target) = draw(renderer, state, size, Output::Picture)?;
    renderer.gpu().read_texture(&target, 0, 0)
}

/// A measured layer of a state.
///
/// # Errors
/// As [`picture`]; [`Error::Gpu`] where the renderer holds 16-bit floats and the layer is other than radiance and luminance.
pub fn measure(renderer: &mut Renderer, state: &ViewState, size: [u32; 2], layer: LayerName) -> Result<Measured> {
    let (frame, _) = draw(renderer, state, size, layer.output())?;
    let Some(texture) = renderer.radiance() else {
        return Err(Error::gpu("nothing was drawn", "report this"));
    };
    let is_single = texture.format() == wgpu::TextureFormat::Rgba32Float;
    if !is_single && !layer.is_of_light() {
        return Err(Error::gpu(
            "this layer is measured in floats of 32 bits, this renderer has others",
            "make it with Radiance::Single",
        ));
    }
    let bytes = renderer.gpu().read_texture(texture, 0, 0)?;
    let texel = |texel: &[u8]| -> [f64; 4] {
        if is_single {
            bytemuck::pod_read_unaligned::<[f32; 4]>(texel).map(f64::from)
        } else {
            bytemuck::pod_read_unaligned::<[u16; 4]>(texel).map(|part| half::f16::from_bits(part).to_f64())
        }
    };
    let texels = bytes.chunks_exact(if is_single { 16 } else { 8 }).map(texel);
    let sky = |t: &[f64; 4]| t[3] == 0.0;
    // By moonlight the unit of radiance is the moon's.
    let exposure = f64::from(frame.uniform.exposure) * f64::from(frame.uniform.night);
    let (channels, values): (usize, Vec<f64>) = match layer {
        LayerName::Radiance => (3, texels.flat_map(|t| [t[0], t[1], t[2]].map(|part| part / exposure)).collect()),
        LayerName::Luminance => {
            (1, texels.map(|t| (0.2126 * t[0] + 0.7152 * t[1] + 0.0722 * t[2]) / exposure).collect())
        }
        LayerName::Lonlat => {
            // The GPU gives differences from the eye's foot, which 32 bits hold; the sum needs 64.
            let (lon, lat) = (frame.camera.lon.to_degrees(), frame.camera.lat.to_degrees());
            let wrapped = |x: f64| (x + 180.0).rem_euclid(360.0) - 180.0;
            let absolute = |t: [f64; 4]| if sky(&t) { [f64::NAN; 2] } else { [wrapped(lon + t[0]), lat + t[1]] };
            (2, texels.flat_map(absolute).collect())
        }
        LayerName::Normal | LayerName::Albedo => {
            (3, texels.flat_map(|t| if sky(&t) { [f64::NAN; 3] } else { [t[0], t[1], t[2]] }).collect())
        }
        LayerName::Height => {
            let rest = |pixel: u32, height_m: f64| rest_m(&frame.camera, state.settings.datum, size, pixel, height_m);
            let over_ellipsoid =
                |(pixel, t): (u32, [f64; 4])| if sky(&t) { f64::NAN } else { t[0] + rest(pixel, t[0]) };
            (1, (0..).zip(texels).map(over_ellipsoid).collect())
        }
        _ => (1, texels.map(|t| if sky(&t) { f64::NAN } else { t[0] }).collect()),
    };
    let shape = [size[1] as usize, size[0] as usize, channels];
    Ok(Measured { shape, values, double: layer == LayerName::Lonlat })
}

/// Height of the resting sea over the ellipsoid at the place that a pixel shows, `height_m` over the resting sea, m.
fn rest_m(camera: &Camera, datum: Datum, size: [u32; 2], pixel: u32, height_m: f64) -> f64 {
    if datum == Datum::Ellipsoid {
        return 0.0;
    }
    let at = DVec2::new(f64::from(pixel % size[0]) + 0.5, f64::from(pixel / size[0]) + 0.5);
    let level = Ellipsoid { a: WGS84.a + height_m, b: WGS84.b + height_m };
    let hit = camera.unproject_onto(&level, at, DVec2::new(f64::from(size[0]), f64::from(size[1])));
    let place = hit.and_then(|hit| WGS84.geodetic_from_ecef(hit).ok());
    // A pixel of the limb may miss: the foot of the eye is as good there.
    place.map_or_else(|| datum.rest_m(camera.lat, camera.lon), |place| datum.rest_m(place.lat, place.lon))
}

/// An 8-bit RGBA PNG.
///
/// # Errors
/// [`Error::Io`] or [`Error::BadData`] when it cannot be written.
pub fn write_png(path: &std::path::Path, size: [u32; 2], rgba: &[u8]) -> Result<()> {
    let name = path.display().to_string();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size[0], size[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(rgba));
    written.map_err(|e| Error::bad_data(&name, e.to_string(), "report this"))?;
    std::fs::write(path, bytes).map_err(|e| Error::io(name, e, "choose another place with -o"))
}

/// A JPEG of an RGBA picture, of a quality at which nothing is seen of it.
///
/// # Errors
/// [`Error::Io`] or [`Error::BadData`] when it cannot be written.
pub fn write_jpeg(path: &std::path::Path, size: [u32; 2], rgba: &[u8]) -> Result<()> {
    let name = path.display().to_string();
    let mut bytes = Vec::new();
    // LARGEST is less than what 16 bits hold.
    let [width, height] = size.map(|side| side as u16);
    let encoder = jpeg_encoder::Encoder::new(&mut bytes, JPEG_QUALITY);
    let written = encoder.encode(rgba, width, height, jpeg_encoder::ColorType::Rgba);
    written.map_err(|e| Error::bad_data(&name, e.to_string(), "report this"))?;
    std::fs::write(path, bytes).map_err(|e| Error::io(name, e, "choose another place with -o"))
}

/// A NumPy file (format 1.0) of little-endian floats in C order, of 32 bits, or 64 where the layer needs them.
///
/// # Errors
/// [`Error::Io`] when it cannot be written.
pub fn write_npy(path: &std::path::Path, measured: &Measured) -> Result<()> {
    let [rows, columns, channels] = measured.shape;
    let shape = if channels == 1 { format!("({rows}, {columns})") } else { format!("({rows}, {columns}, {channels})") };
    let kind = if measured.double { "<f8" } else { "<f4" };
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // Magic, version and length take 10 bytes; the whole header ends with a line feed on a multiple of 64.
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    if measured.double {
        bytes.extend(measured.values.iter().flat_map(|v| v.to_le_bytes()));
    } else {
        bytes.extend(measured.values.iter().flat_map(|&v| (v as f32).to_le_bytes()));
    }
    std::fs::write(path, bytes).map_err(|e| Error::io(path.display().to_string(), e, "choose another place with -o"))
}
