//! Pictures of an eye in the sea, and of one that the surface cuts through.

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::exposure::{Found, Water};
use ocean_globe::data::tile::Layer;
use ocean_globe::data::world::World;
use ocean_globe::gpu::texture::{self, Shape};
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::model::optics::WATER_INDEX;
use ocean_globe::model::sun;
use ocean_globe::renderer::{Radiance, Renderer, TARGET_FORMAT};
use ocean_globe::scene::frame::{Frame, LENS_M};
use ocean_globe::scene::sea::shelter::of_patches;
use ocean_globe::scene::view::camera::Camera;
use ocean_globe::scene::view::state::ViewState;

pub const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// Off the Exumas, Bahamas: 3.8 m of water.
pub const SHALLOWS: &str = "24.31,-76.561";
/// Where the bed is 3.8 m deep: the net of light is the sharper the deeper, down to some ten metres.
const NET: &str = "24.31,-76.562";
const SHALLOWS_BELOW: &str = "24.31,-76.561,-1.5";
pub const NOON: &str = "time=2026-06-21T17:00:00Z&clouds=0";

pub fn state(link: &str) -> ViewState {
    render::parse_state(link).unwrap()
}

/// Of a half float that is no subnormal, infinity or NaN.
pub fn half(bits: u16) -> f64 {
    let exponent = i32::from(bits >> 10 & 31);
    assert!(exponent < 31, "not finite");
    let sign = if bits >> 15 == 1 { -1.0 } else { 1.0 };
    let fraction = f64::from(bits & 1023) / 1024.0;
    sign * if exponent == 0 { fraction * 2f64.powi(-14) } else { (1.0 + fraction) * 2f64.powi(exponent - 15) }
}

/// Mean and deviation of the caustics over the bed about an eye, by area.
fn caustics(renderer: &mut Renderer, link: &str) -> [f64; 2] {
    // Of `shaders/lib/caustic_map.wgsl`: a texel is as long as the hyperbolic cosine says along each axis. The outer fifth is not asked, as
    // light from beyond the map's net is missing there.
    let ends = f64::asinh(36.0 / 2.5);
    render::picture(renderer, &state(link), [64, 36]).unwrap();
    let map = renderer.caustics();
    let side = map.width() as usize;
    let bytes = renderer.gpu().read_texture(map, 0, 0).unwrap();
    let length = |i: usize| {
        let at = 2.0 * (i as f64 + 0.5) / side as f64 - 1.0;
        if at.abs() < 0.8 { (at * ends).cosh() } else { 0.0 }
    };
    let [mut area, mut sum, mut squares] = [0.0; 3];
    for (i, texel) in bytes.chunks_exact(2).enumerate() {
        let weight = length(i % side) * length(i / side);
        let light = half(u16::from_le_bytes([texel[0], texel[1]]));
        area += weight;
        sum += weight * light;
        squares += weight * light * light;
    }
    let mean = sum / area;
    [mean, (squares / area - mean * mean).max(0.0).sqrt()]
}

/// How much more of the sun's light falls on the bed than on a level one, of the same area on the map: it rises to the shore by 3 %.
fn facing_sun(link: &str) -> f64 {
    let state = state(link);
    let Geodetic { lat, lon, .. } = state.camera.geodetic();
    let sun = earth::ecef_from_enu(lat, lon).transpose() * sun::sun_direction_ecef(render::instant(&state));
    let level = DVec2::new(sun.x, sun.y) / WATER_INDEX;
    let mut world = World::open(DATA);
    let mut depth = |metres: f64| {
        let way = metres * level.normalize();
        let place = (lat + way.y / WGS84.a, lon + way.x / (WGS84.a * lat.cos()));
        world.sample_blocking(place.0, place.1).unwrap().depth_m.unwrap()
    };
    let fall = (depth(10.0) - depth(-10.0)) / 20.0;
    1.0 + fall * level.length() / (1.0 - level.length_squared()).sqrt()
}

#[test]
fn caustics_gather_the_suns_light_and_lose_none() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Four instants, between which the waves have changed.
    let mut at = |rest: &str| {
        let link = |second: usize| format!("#view={NET},-1.5,0,90&{}", rest.replace(":00Z", &format!(":{second:02}Z")));
        let found = [0, 15, 30, 45].map(|second| caustics(&mut renderer, &link(second)));
        let [mean, deviation] = [0, 1].map(|part| found.iter().map(|one| one[part]).sum::<f64>() / 4.0);
        let mean = mean / facing_sun(&link(0));
        println!("{rest}: mean {mean:.4}, deviation {deviation:.3}");
        // Light that is brought in and out over the rim of 24 m by the slopes of waves: 0.05 of the depth on each side, a hundredth of the area
        // at random at an instant; what is cut off at BRIGHTEST is less.
        assert!((mean - 1.0).abs() < 0.02, "{rest}: mean {mean}");
        deviation
    };
    let noon = at(&format!("wind=4@90&{NOON}"));
    assert!(noon > 0.4, "a net of light: {noon}");
    at("wind=4@90&time=2026-06-21T21:30:00Z");
    at(&format!("wind=9@90&{NOON}"));
    assert_eq!(at(&format!("wind=0@0&{NOON}")), 0.0, "a flat surface gathers nothing");
    assert_eq!(at(&format!("wind=4@90&quality=low&{NOON}")), 0.0, "nor does the quality for slow machines");
}

/// Mean of the green radiance that an eye so high over shallow water sees straight below it, and its deviation over the mean.
fn seen_from_above(renderer: &mut Renderer, altitude_m: f64, rest: &str) -> [f64; 2] {
    let link = format!("#view={SHALLOWS},{altitude_m},0,0&quality=high&time=2026-06-21T21:00:00Z&{rest}");
    render::picture(renderer, &state(&link), SIZE).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let greens: Vec<f64> = bytes.chunks_exact(8).map(|pixel| half(u16::from_le_bytes([pixel[2], pixel[3]]))).collect();
    let count = greens.len() as f64;
    let mean = greens.iter().sum::<f64>() / count;
    [mean, (greens.iter().map(|green| (green - mean).powi(2)).sum::<f64>() / count).sqrt() / mean]
}

#[test]
fn an_eye_over_shallow_water_sees_the_net_of_light_on_the_bed() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut seen = |altitude_m: f64, rest: &str| seen_from_above(&mut renderer, altitude_m, rest);
    let [_, plain] = seen(8.0, "wind=0@0&clouds=0");
    let [_, net] = seen(8.0, "wind=3@90&clouds=0");
    let [_, grey] = seen(8.0, "wind=3@90&clouds=1");
    println!("deviations: a flat surface {plain:.3}, waves {net:.3}, waves under clouds {grey:.3}");
    // Seagrass and, beside it, facets that glint of the sun make .24 of it. Closed clouds leave no disc of the sun.
    assert!(net > 0.6, "a net of light: {net}");
    assert!(grey < 1.1 * plain, "under clouds there is none: {grey}");
    // No light is lost: 16 by 29 m of the bed have as much as under a flat surface, but for what the bed's slope of 3 % faces the sun, and the glint.
    let [flat, waves] = ["wind=0@0&clouds=0", "wind=3@90&clouds=0"].map(|rest| seen(20.0, rest)[0]);
    println!("means: a flat surface {flat:.4}, waves {waves:.4}");
    assert!((waves / flat - 1.0).abs() < 0.07, "{waves} of {flat}");
}

/// Radiance along the picture's middle column of an eye in calm water that looks up, by degrees from the zenith.
fn column(renderer: &mut Renderer, tilt_deg: f64, rest: &str) -> Vec<(f64, [f64; 3])> {
    const SIZE: [u32; 2] = [9, 361];
    let link = format!("#view={SHALLOWS},-2,0,{tilt_deg}&wind=0@0&{rest}");
    let measured = render::measure(renderer, &state(&link), SIZE, LayerName::Radiance).unwrap();
    let row = |y: usize| {
        let slope = (1.0 - 2.0 * (y as f64 + 0.5) / f64::from(SIZE[1])) * f64::to_radians(22.5).tan();
        let from_zenith = 180.0 - tilt_deg - slope.atan().to_degrees();
        let i = 3 * (y * SIZE[0] as usize + 4);
        (from_zenith, [0, 1, 2].map(|colour| measured.values[i + colour]))
    };
    (0..SIZE[1] as usize).map(row).collect()
}

#[test]
fn a_calm_sea_shows_the_sky_within_snells_window_and_mirrors_the_bed_around_it() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let seen = column(&mut renderer, 131.4, NOON);
    // Sky is bright in red, of which water leaves little: the rim is where it ends.
    let edge = seen.windows(2).max_by(|a, b| {
        let fall = |pair: &[(f64, [f64; 3])]| (pair[0].1[0] - pair[1].1[0]).abs();
        fall(a).total_cmp(&fall(b))
    });
    let edge = edge.map(|pair| 0.5 * (pair[0].0 + pair[1].0)).unwrap();
    println!("the window ends {edge:.2} degrees from the zenith");
    // asin(1 / 1.333); a row is 0.13 degrees wide, and two degrees within the rim the mirror has taken over by half.
    assert!((edge - 48.6066).abs() < 0.3, "{edge}");

    let bare = column(&mut renderer, 131.4, &format!("{NOON}&layers=-land"));
    let ratio = |at: f64| {
        let near = |list: &[(f64, [f64; 3])]| {
            list.iter().min_by(|a, b| (a.0 - at).abs().total_cmp(&(b.0 - at).abs())).map(|row| row.1[1]).unwrap()
        };
        near(&seen) / near(&bare)
    };
    let (inside, outside) = (ratio(35.0), ratio(60.0));
    println!("green with a bed over that without: {inside:.3} within the window, {outside:.3} beyond");
    // At 35 degrees 3 % is mirrored, of a bed half as bright again as the sky; beyond the rim all is.
    assert!((inside - 1.0).abs() < 0.06, "{inside}");
    assert!(outside > 1.5, "{outside}");
}

pub const SIZE: [u32; 2] = [320, 180];

/// Instants over one wave's period of a light breeze, s.
fn instants(state: &ViewState) -> impl Iterator<Item = f64> + use<> {
    let start = render::instant(state);
    (0..8).map(move |step| start + 0.4 * f64::from(step))
}

pub struct Film {
    pub renderer: Renderer,
    target: wgpu::Texture,
}

impl Film {
    pub fn new() -> Self {
        let renderer = render::headless(DATA, Radiance::Half).unwrap();
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let target = renderer.gpu().texture("picture", Shape::picture(SIZE[0], SIZE[1]), TARGET_FORMAT, usage);
        Self { renderer, target }
    }

    /// A state's picture at an instant: its eye, display values and whether all radiance is finite.
    pub fn draw(&mut self, state: &ViewState, instant: f64) -> (Camera, Vec<u8>) {
        let frame: Frame = loop {
            let eye = self.renderer.eye(state, instant);
            let frame = self.renderer.frame(&state.settings, &eye, instant, SIZE);
            if self.renderer.load(&frame) && self.renderer.eye(state, instant) == eye {
                break frame;
            }
            std::thread::sleep(std::time::Duration::from_millis(1));
        };
        let gpu = self.renderer.gpu().clone();
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        self.renderer.render(&mut encoder, &frame, &texture::view(&self.target));
        gpu.queue.submit([encoder.finish()]);
        let radiance = gpu.read_texture(self.renderer.radiance().unwrap(), 0, 0).unwrap();
        for texel in radiance.chunks_exact(8) {
            for part in texel[..6].chunks_exact(2) {
                let value = half(u16::from_le_bytes([part[0], part[1]]));
                assert!(value >= 0.0, "{value}");
            }
        }
        (frame.camera, gpu.read_texture(&self.target, 0, 0).unwrap())
    }
}

/// The row where the model's water stands in a column of a picture, at the lens; from 0 to 1, downwards.
fn model_row(film: (&mut Renderer, &mut World), state: &ViewState, eye: &Camera, instant: f64, x: f64) -> f64 {
    let (renderer, world) = film;
    let seas = renderer.seas_mut();
    let tables = seas.tables(&state.settings);
    let mut look = |id| match world.tile_blocking(Layer::Water, id) {
        Ok(Some(texels)) => Found::Tile(texels),
        _ => Found::Absent,
    };
    let sea = (&tables, state.settings.wind_from());
    let gains = of_patches(seas.shelter.at(sea, (Water::Ocean, eye.lat, eye.lon), &mut look).unwrap());
    let axes = eye.basis_enu();
    let half = f64::to_radians(22.5).tan();
    let from_enu = earth::ecef_from_enu(eye.lat, eye.lon);
    let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
    let mut up = 0.0;
    for _ in 0..4 {
        let lens = LENS_M * (axes.forward + (2.0 * x - 1.0) * half * aspect * axes.right + up * half * axes.up);
        let place = WGS84.geodetic_from_ecef(eye.eye_ecef() + from_enu * DVec3::new(lens.x, lens.y, 0.0)).unwrap();
        let water = seas.sample_in(&state.settings, (place.lat, place.lon), instant, 3.47, gains).height_m;
        up += (water - eye.altitude_m - lens.z) / (LENS_M * half * axes.up.z);
    }
    0.5 - 0.5 * up
}

#[test]
fn the_water_before_the_lens_stands_where_the_waves_are() {
    // With no layer at all the picture from above is the clear colour, and the one from below is water.
    let mut film = Film::new();
    film.renderer.set_clear_colour(wgpu::Color { r: 1.0, g: 0.0, b: 0.0, a: 1.0 });
    let state = state(&format!("#view={SHALLOWS},-0.02,120,90&wind=3@90&{NOON}&layers=-land,-sea,-sky"));
    let mut world = World::open(DATA);
    world.sample_blocking(state.camera.lat, state.camera.lon).unwrap();
    let mut rows = Vec::new();
    let mut worst: f64 = 0.0;
    for instant in instants(&state) {
        let (eye, picture) = film.draw(&state, instant);
        for column in [20, 90, 160, 230, 300] {
            let is_air = |y: u32| picture[4 * (y * SIZE[0] + column) as usize] > 128;
            let drawn = (0..SIZE[1]).take_while(|&y| is_air(y)).count() as f64 / f64::from(SIZE[1]);
            let x = (f64::from(column) + 0.5) / f64::from(SIZE[0]);
            let model = model_row((&mut film.renderer, &mut world), &state, &eye, instant, x).clamp(0.0, 1.0);
            worst = worst.max((drawn - model).abs());
            rows.push(drawn);
        }
        // Nothing but water lies below the line.
        for column in 0..SIZE[0] {
            let is_air = |y: u32| picture[4 * (y * SIZE[0] + column) as usize] > 128;
            let changes = (1..SIZE[1]).filter(|&y| is_air(y) != is_air(y - 1)).count();
            assert!(changes <= 1, "column {column} changes {changes} times");
        }
    }
    let (least, most) = rows.iter().fold((1.0f64, 0.0f64), |(a, b), &r| (a.min(r), b.max(r)));
    println!("the line goes from {least:.2} to {most:.2} of the picture's height; the model is {worst:.3} off at most");
    assert!(most - least > 0.3, "a wave goes by: {least} to {most}");
    // The height of the picture is 0.166 m at the lens. Heights agree within a centimetre (`SurfaceSample`); the meniscus adds 0.016 at most.
    assert!(worst < 0.01 / 0.166 + 0.01, "{worst}");
}

#[test]
fn the_surface_goes_by_without_holes() {
    let mut film = Film::new();
    film.renderer.set_clear_colour(wgpu::Color { r: 2.0, g: 0.0, b: 2.0, a: 1.0 });
    // Level, and at a tilt that shows much of either side; waves also hide the far sea.
    // Without the land no bed fills them.
    let views =
        [("0,120,90", 3, ""), ("0.05,30,70", 5, ""), ("-0.05,210,110", 5, ""), ("0,250,86", 2, "&layers=-land")];
    for (view, wind, layers) in views {
        let state = state(&format!("#view={SHALLOWS},{view}&ride=1&wind={wind}@90&{NOON}{layers}"));
        let mut last: Option<f64> = None;
        for instant in instants(&state) {
            let (_, picture) = film.draw(&state, instant);
            let holes =
                picture.chunks_exact(4).filter(|p| p[0] > 200 && p[2] > 200 && i32::from(p[1]) < i32::from(p[0]) - 60);
            assert_eq!(holes.count(), 0, "{view}: holes");
            let black = picture.chunks_exact(4).filter(|p| p[..3].iter().all(|part| *part < 4)).count();
            assert_eq!(black, 0, "{view}: black pixels");
            // Water has lost its red.
            let water = picture.chunks_exact(4).filter(|p| f64::from(p[0]) < 0.45 * f64::from(p[2])).count();
            let share = water as f64 / f64::from(SIZE[0] * SIZE[1]);
            if let Some(last) = last {
                assert!((share - last).abs() < 0.35, "{view}: from {last} to {share}");
            }
            println!("{view}: {share:.3} of the picture is water");
            last = Some(share);
        }
    }
}

#[test]
fn pictures_from_below_are_whole_by_either_mesh() {
    // `Film::draw` finds what is not finite. Down, level and up, in deep water and in shallows.
    let mut film = Film::new();
    for place in ["45,-30,-2", SHALLOWS_BELOW] {
        for (tilt, mesh) in [(60, "bisect,8,60000"), (88, "bisect,8,60000"), (88, "grid"), (150, "grid")] {
            let state = state(&format!("#view={place},60,{tilt}&mesh={mesh}&wind=6@90&{NOON}"));
            let (_, picture) = film.draw(&state, render::instant(&state));
            let black = picture.chunks_exact(4).filter(|p| p[..3].iter().all(|part| *part < 4)).count();
            assert_eq!(black, 0, "{place}, tilt {tilt}, {mesh}: black pixels");
        }
    }
}
