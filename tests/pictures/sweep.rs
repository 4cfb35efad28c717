//! From 30,000 km down to 2 m off a coast, time standing still: nothing pops, nothing cracks, nothing is black.

use glam::DVec2;
use ocean_globe::cli::render::{self, headless};
use ocean_globe::data::world::World;
use ocean_globe::gpu::texture::{self, Shape};
use ocean_globe::model::earth::WGS84;
use ocean_globe::renderer::{Radiance, Renderer, TARGET_FORMAT};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::layers::Layer;
use ocean_globe::scene::view::camera::Camera;
use ocean_globe::scene::view::flight::Flight;
use ocean_globe::scene::view::state::ViewState;

use crate::tone::displayed;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// At an instant at which no crest stands before the eye at the end: where one is level with the horizon a whole row of pixels changes with it,
/// as coarse pictures have no smooth edges.
const SEA: &str = "bft=8&quality=low&time=2026-11-26T12:00:00Z&rate=0";
/// Off the Canary Islands: the shore is a kilometre away and in the last pictures.
const ENDS: [&str; 2] = ["view=28,-14,3e7&clouds=0", "view=28.825,-13.79,2,285,80&clouds=0"];
const CLOUDY_ENDS: [&str; 2] = ["view=28,-14,3e7&clouds=0.45", "view=28.825,-13.79,2,285,80&clouds=0.45"];
const FRAMES: usize = 600;
/// The 99.9th percentile is the ninth pixel: one that flips is no pop.
const SIZE: [u32; 2] = [128, 72];
/// Frames whose sea is drawn alone and searched for holes: every so manieth.
const SEARCHED: usize = 10;
/// Radiance of pixels that nothing was drawn into: far above the sun's glitter.
const UNDRAWN: f64 = 2e4;
const MAGENTA: wgpu::Color = wgpu::Color { r: UNDRAWN, g: 0.0, b: UNDRAWN, a: 1.0 };

/// A flight's cameras at even steps of its way in height, so that the eye's own motion has neither start nor end.
fn cameras(ends: [Camera; 2], frames: usize) -> Vec<Camera> {
    let [from, to] = ends;
    let flight = Flight::new(from, to);
    let at = |share: f64| {
        let (mut early, mut late) = (0.0, flight.duration_s());
        for _ in 0..60 {
            let middle = 0.5 * (early + late);
            if flight.eased(middle) < share { early = middle } else { late = middle }
        }
        flight.at(late)
    };
    (0..frames).map(|index| at(index as f64 / (frames - 1) as f64)).collect()
}

/// Draws into one target; the mesh and the foam have a moving picture's few updates.
struct Film {
    renderer: Renderer,
    target: wgpu::TextureView,
}

impl Film {
    /// A film without clouds has single precision; clouds need a colour that blends.
    fn new(clouds: bool) -> Self {
        let radiance = if clouds { Radiance::Half } else { Radiance::Single };
        let mut renderer = headless(DATA, radiance).unwrap();
        renderer.set_moving(true);
        renderer.set_clear_colour(MAGENTA);
        let shape = Shape::picture(SIZE[0], SIZE[1]);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let target = texture::view(&renderer.gpu().texture("picture", shape, TARGET_FORMAT, usage));
        Self { renderer, target }
    }

    /// The frame of a state, all of its tiles at hand.
    fn frame(&mut self, state: &ViewState) -> Frame {
        let instant = render::instant(state);
        loop {
            let eye = self.renderer.eye(state, instant);
            let frame = self.renderer.frame(&state.settings, &eye, instant, SIZE);
            if self.renderer.load(&frame) && self.renderer.eye(state, instant) == eye {
                return frame;
            }
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
    }

    /// Exposed radiance of each pixel: red, green, blue.
    fn draw(&mut self, frame: &Frame) -> Vec<[f32; 3]> {
        let gpu = self.renderer.gpu().clone();
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        self.renderer.render(&mut encoder, frame, &self.target);
        gpu.queue.submit([encoder.finish()]);
        let radiance = self.renderer.radiance().unwrap();
        let bytes = gpu.read_texture(radiance, 0, 0).unwrap();
        if radiance.format() == wgpu::TextureFormat::Rgba16Float {
            let halves = bytes.chunks_exact(8).map(bytemuck::pod_read_unaligned::<[u16; 4]>);
            return halves.map(|[r, g, b, _]| [r, g, b].map(|bits| half::f16::from_bits(bits).to_f32())).collect();
        }
        let texels = bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned::<[f32; 4]>);
        texels.map(|[r, g, b, _]| [r, g, b]).collect()
    }

    /// Changes in each part of a step of a way that has [`CUT`] cameras a step.
    fn parts(&mut self, from: &ViewState, path: &[Camera], step: usize) -> Vec<[f64; 2]> {
        let mut changes = Changes::default();
        for (index, camera) in path[CUT * step..=CUT * (step + 1)].iter().enumerate() {
            let frame = self.frame(&ViewState { camera: *camera, ..from.clone() });
            if index == 0 {
                self.renderer.settle(&frame);
            }
            changes.add(&self.draw(&frame));
        }
        changes.series
    }
}

/// Into so many parts a step is cut whose change is sudden, to see whether it is motion.
const CUT: usize = 8;

/// Luma of the display, 0…1, before it is rounded to 8 bits: what an eye sees of a change.
fn luma(pixel: &[f32; 3]) -> f64 {
    let [r, g, b] = displayed(pixel.map(f64::from));
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Centre of the pixel `index`.
fn centre(index: usize) -> DVec2 {
    let width = SIZE[0] as usize;
    DVec2::new((index % width) as f64 + 0.5, (index / width) as f64 + 0.5)
}

/// Pixels whose rays meet the ellipsoid, and so do those two pixels away: beside the limb crests decide.
fn inside_limb(camera: &Camera) -> Vec<bool> {
    let extent = DVec2::from(SIZE.map(f64::from));
    let [width, height] = SIZE.map(|side| side as usize);
    let hits: Vec<_> = (0..width * height).map(|i| camera.unproject_ecef(centre(i), extent).is_some()).collect();
    let inside = |i: usize| {
        let (x, y) = (i % width, i / width);
        let rows = y.saturating_sub(2)..(y + 3).min(height);
        rows.flat_map(|y| (x.saturating_sub(2)..(x + 3).min(width)).map(move |x| y * width + x)).all(|i| hits[i])
    };
    (0..width * height).map(inside).collect()
}

/// Open ocean: so far from any shore that the water tiles' rounding and the crests' parallax cannot reach it.
fn is_open_ocean(world: &mut World, camera: &Camera, index: usize) -> bool {
    let extent = DVec2::from(SIZE.map(f64::from));
    let Some(point) = camera.unproject_ecef(centre(index), extent) else { return false };
    let place = WGS84.geodetic_from_ecef(point).unwrap();
    let sample = world.sample_blocking(place.lat, place.lon).unwrap();
    // Four pixels, and two texels of the deepest water tiles, 1.1 km each.
    let pixel_m = point.distance(camera.eye_ecef()) / f64::from(SIZE[1]);
    sample.depth_m.is_some() && sample.shore_distance_m.is_none_or(|d| d.abs() > 2_140.0 + 4.0 * pixel_m)
}

fn sweep(mesh: &str) {
    let [from, to] = ENDS.map(|view| render::parse_state(&format!("#{view}&{SEA}&mesh={mesh}")).unwrap());
    let (mut film, mut world) = (Film::new(false), World::open(DATA));
    let mut changes = Changes::default();
    let mut searched = 0;
    let path = cameras([from.camera, to.camera], CUT * (FRAMES - 1) + 1);
    for (index, camera) in path.iter().copied().step_by(CUT).enumerate() {
        let mut state = ViewState { camera, ..from.clone() };
        let frame = film.frame(&state);
        if index == 0 {
            film.renderer.settle(&frame);
        }
        let picture = film.draw(&frame);
        let inside = inside_limb(&frame.camera);
        for (pixel, rgb) in picture.iter().enumerate() {
            // Formatted for a fault alone: there are millions of pixels.
            let here = || {
                let at = centre(pixel);
                format!("{mesh}, frame {index} from {:.1} m, pixel {at}: {rgb:?}", frame.camera.altitude_m)
            };
            assert!(rgb.iter().all(|x| x.is_finite() && *x >= 0.0), "{}", here());
            assert!(f64::from(rgb[0]) < UNDRAWN / 2.0, "a crack: {}", here());
            // A night is too dark for the display, not without light.
            assert!(!inside[pixel] || rgb.iter().any(|x| *x > 0.0), "black: {}", here());
        }
        changes.add(&picture);
        if index % SEARCHED == 0 {
            // The sea alone, over nothing.
            state.settings.layers.set(Layer::Land, false);
            state.settings.layers.set(Layer::Sky, false);
            let alone = film.renderer.frame(&state.settings, &frame.camera, frame.unix_seconds, SIZE);
            for (pixel, rgb) in film.draw(&alone).iter().enumerate() {
                if inside[pixel] && is_open_ocean(&mut world, &frame.camera, pixel) {
                    searched += 1;
                    assert!(
                        f64::from(rgb[0]) < UNDRAWN / 2.0,
                        "{mesh}: a hole in the sea: frame {index} from {:.1} m, pixel {}",
                        frame.camera.altitude_m,
                        centre(pixel)
                    );
                }
            }
        }
    }
    println!("{mesh}: {searched} pixels of open ocean searched");
    assert!(searched > 50_000, "{mesh}: only {searched} pixels of open ocean");
    changes.assert_even(mesh, |index| film.parts(&from, &path, index));
}

/// How much each picture of a film differs from the one before: the 99.9th percentile of its pixels sees what pops in a corner, the mean
/// what pops everywhere by little.
#[derive(Default)]
struct Changes {
    last: Option<Vec<f64>>,
    series: Vec<[f64; 2]>,
}

impl Changes {
    fn add(&mut self, picture: &[[f32; 3]]) {
        let lumas: Vec<_> = picture.iter().map(luma).collect();
        if let Some(last) = &self.last {
            let mut change: Vec<_> = lumas.iter().zip(last).map(|(now, was)| (now - was).abs()).collect();
            change.sort_by(f64::total_cmp);
            let mean = change.iter().sum::<f64>() / change.len() as f64;
            self.series.push([change[(0.999 * change.len() as f64) as usize], mean]);
        }
        self.last = Some(lumas);
    }

    /// Asserts that no step is sudden, or that what is, is motion: a limb that leaves the picture, a cloud that is passed. What moves does so by less in
    /// each part of a step; what pops does all of it in one. `parts` are the changes in those of a step. No part may change the picture by as much as a whole
    /// step there does as a rule, of which even motion would make a fifth.
    fn assert_even(&self, film: &str, mut parts: impl FnMut(usize) -> Vec<[f64; 2]>) {
        for (which, name) in ["99.9th percentile", "mean"].into_iter().enumerate() {
            let series: Vec<_> = self.series.iter().map(|change| change[which]).collect();
            let ratios = suddenness(&series);
            let most = ratios.iter().copied().fold(0.0, f64::max);
            println!("{film}: the {name} of the change is at most {most:.2} times its neighbours'");
            for (index, ratio) in ratios.into_iter().enumerate().filter(|(_, ratio)| *ratio > 1.5) {
                let most = parts(index).iter().map(|change| change[which]).fold(0.0, f64::max);
                let usual = series[index] / ratio;
                println!("{film}: frame {}: {name} {ratio:.2}; in parts {:.2} at most", index + 1, most / usual);
                assert!(
                    most < usual,
                    "{film}: frame {} pops: {name} {ratio:.2}, a part {:.2}",
                    index + 1,
                    most / usual
                );
            }
        }
    }
}

/// The ratio of each value to the median of its ten neighbours on either side.
fn suddenness(changes: &[f64]) -> Vec<f64> {
    let ratio = |index: usize| {
        let around = index.saturating_sub(10)..(index + 11).min(changes.len());
        let mut neighbours: Vec<_> = around.filter(|at| *at != index).map(|at| changes[at]).collect();
        neighbours.sort_by(f64::total_cmp);
        let n = neighbours.len();
        changes[index] / (0.5 * (neighbours[(n - 1) / 2] + neighbours[n / 2]))
    };
    (0..changes.len()).map(ratio).collect()
}

#[test]
fn the_grid_descends_from_orbit_to_the_deck_without_pop_or_crack() {
    sweep("grid");
}

#[test]
fn the_bisected_mesh_descends_from_orbit_to_the_deck_without_pop_or_crack() {
    sweep("bisect,12,6000");
}

#[test]
fn mountains_are_come_near_without_pop_or_crack() {
    // Down to 700 m over the ground of the Bernese Alps, a step of 3 % in height a picture.
    let ends = ["view=46.3,8.0,3e5,0,20", "view=46.5,8.05,3300,200,80"];
    let [from, to] =
        ends.map(|view| render::parse_state(&format!("#{view}&quality=low&time=2026-06-21T09:00:00Z&rate=0")).unwrap());
    let mut film = Film::new(false);
    let mut changes = Changes::default();
    let path = cameras([from.camera, to.camera], CUT * 149 + 1);
    for camera in path.iter().copied().step_by(CUT) {
        let frame = film.frame(&ViewState { camera, ..from.clone() });
        let picture = film.draw(&frame);
        let inside = inside_limb(&frame.camera);
        let bare =
            picture.iter().zip(&inside).filter(|(rgb, inside)| **inside && f64::from(rgb[0]) >= UNDRAWN / 2.0).count();
        assert_eq!(bare, 0, "cracks from {:.0} m", frame.camera.altitude_m);
        changes.add(&picture);
    }
    changes.assert_even("mountains", |index| film.parts(&from, &path, index));
}

#[test]
fn an_eye_comes_down_to_clouds_among_them_and_from_below_them_without_a_pop() {
    // At this hour it goes through a cloud.
    let sea = SEA.replace("T12", "T10");
    let [from, to] = CLOUDY_ENDS.map(|view| render::parse_state(&format!("#{view}&{sea}")).unwrap());
    let mut film = Film::new(true);
    let path = cameras([from.camera, to.camera], CUT * (FRAMES - 1) + 1);
    let mut changes = Changes::default();
    for camera in path.iter().copied().step_by(CUT) {
        let frame = film.frame(&ViewState { camera, ..from.clone() });
        let picture = film.draw(&frame);
        let is_drawn = |rgb: &[f32; 3]| rgb.iter().all(|x| x.is_finite()) && f64::from(rgb[0]) < UNDRAWN / 2.0;
        assert!(picture.iter().all(is_drawn), "a crack from {:.0} m", frame.camera.altitude_m);
        changes.add(&picture);
    }
    // An eye that passes a cloud comes near it many times as quickly as it comes near the sea, and among clouds it is grey at one moment and clear
    // at the next.
    changes.assert_even("clouds", |index| film.parts(&from, &path, index));
}
