//! One sea from 2 m to 30,000 km: its mean luminance has no step at any height.

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::earth::{Geodetic, WGS84};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::camera::{Basis, Camera};
use ocean_globe::scene::view_state::ViewState;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const HEIGHTS: usize = 200;

fn height_m(index: usize) -> f64 {
    2.0 * (1.5e7f64).powf(index as f64 / (HEIGHTS - 1) as f64)
}

/// The eye `altitude_m` above the ellipsoid that sees a place in the middle of the picture, `zenith` radians off its zenith.
fn eye_on(lat: f64, lon: f64, zenith: f64, heading: f64, altitude_m: f64) -> Camera {
    let target = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
    let look = Camera { lat, lon, altitude_m: 0.0, heading, tilt: zenith };
    let basis: Basis = look.basis();
    let height = |distance: f64| WGS84.geodetic_from_ecef(target - basis.forward * distance).unwrap().height;
    let (mut near, mut far) = (0.0, 3.0 * altitude_m + 10.0);
    for _ in 0..80 {
        let middle = 0.5 * (near + far);
        if height(middle) < altitude_m { near = middle } else { far = middle }
    }
    Camera::from_ecef(target - basis.forward * far, &basis).unwrap()
}

/// Luminance and weight, summed over the water in a circle around the middle of the picture, for each of some radii in half heights.
fn water<const N: usize>(renderer: &mut Renderer, state: &ViewState, side: u32, radii: [f64; N]) -> [DVec2; N] {
    let luminance = render::measure(renderer, state, [side; 2], LayerName::Luminance).unwrap();
    let half = f64::from(side) / 2.0;
    let mut sums = [DVec2::ZERO; N];
    for (index, luminance) in (0..).zip(&luminance.values) {
        let pixel = DVec2::new(f64::from(index % side) + 0.5, f64::from(index / side) + 0.5);
        for (sum, radius) in sums.iter_mut().zip(radii) {
            // Pixels on the circle count in part.
            let weight = (radius * half - pixel.distance(DVec2::splat(half)) + 0.5).clamp(0.0, 1.0);
            *sum += weight * DVec2::new(*luminance, 1.0);
        }
    }
    sums
}

/// A sweep straight over places of the open ocean, or past their zenith.
struct Sweep {
    zenith_deg: f64,
    /// Of the circle that is measured, in half heights of the picture.
    radius: f64,
    side: u32,
    highest_m: f64,
}

impl Sweep {
    /// Mean luminance at each height, and the part by which that of the same water has changed since the height before.
    fn steps(&self, renderer: &mut Renderer, sea: &str, places: usize) -> Vec<[f64; 3]> {
        let mut state = render::parse_state(&format!("#{sea}&quality=low&time=2026-06-21T21:00:00Z")).unwrap();
        let ratio = height_m(1) / height_m(0);
        let heights: Vec<_> = (0..HEIGHTS).map(height_m).filter(|h| *h <= self.highest_m).collect();
        let mut sums = vec![[DVec2::ZERO; 2]; heights.len()];
        for place in 0..places {
            let [x, y] = [0.754_877_666, 0.569_840_291].map(|step| 1e-3 * (step * place as f64).fract());
            renderer.forget();
            // From high up a picture holds water enough.
            for (altitude_m, sums) in heights.iter().zip(&mut sums).filter(|(h, _)| place == 0 || **h < 4e3) {
                state.camera = eye_on(-0.17 + x, -2.1 + y, self.zenith_deg.to_radians(), 0.5, *altitude_m);
                let found = water(renderer, &state, self.side, [self.radius / ratio, self.radius]);
                sums.iter_mut().zip(found).for_each(|(sum, found)| *sum += found);
            }
        }
        let means: Vec<_> = sums.iter().map(|sums| sums.map(|sum| sum.x / sum.y)).collect();
        heights.iter().skip(1).zip(means.windows(2)).map(|(h, m)| [*h, m[1][1], m[1][0] / m[0][1] - 1.0]).collect()
    }
}

const DOWN: Sweep = Sweep { zenith_deg: 0.0, radius: 0.4, side: 64, highest_m: 4e7 };
/// From higher up, a place 60° off is close to the limb.
const OBLIQUE: Sweep = Sweep { zenith_deg: 60.0, radius: 0.25, side: 96, highest_m: 3e6 };

#[test]
fn the_mean_luminance_of_the_water_has_no_steps() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let env = |name: &str, or: &str| std::env::var(name).unwrap_or(or.into());
    let places = env("P", "2").parse().unwrap();
    for (name, sweep) in [("down", &DOWN), ("oblique", &OBLIQUE)].iter().filter(|(n, _)| n.contains(&env("W", ""))) {
        for sea in env("SEA", "bft=5 bft=8").split(' ') {
            let start = std::time::Instant::now();
            for [height_m, mean, step] in sweep.steps(&mut renderer, sea, places) {
                println!("{height_m:12.1} {mean:.5} {:+.2}", 100.0 * step);
            }
            println!("# {name} {sea} {:.1?}", start.elapsed());
        }
    }
}
