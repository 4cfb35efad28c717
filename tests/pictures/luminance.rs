//! One sea from 2 m to 30,000 km: its mean luminance has no step at any height.

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::earth::{Geodetic, WGS84};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::view::camera::{Basis, Camera};
use ocean_globe::scene::view::state::ViewState;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const HEIGHTS: usize = 200;
/// The most that the mean changes from one height to the next.
const STEP: f64 = 0.03;
/// Up to here, where the foam map ends, a picture holds few waves and whitecaps, and large parts of it are compared, over several places: the
/// squares of the foam map have whitecaps of their own, so that those of one place come and go by up to 5 % a height while one square takes
/// over from another, over four places by 2.5 %.
const FEW_WAVES_M: f64 = 4_000.0;
/// And up to here a few cells of their lace, which is another from one factor of two in height to the next.
const FEW_FLECKS_M: f64 = 15.0;
/// Places below these heights.
const PLACES: usize = 10;
const SOME_PLACES: usize = 4;
/// From 30,000 km still without the limb and any land.
const HIGH: [f64; 2] = [0.25; 2];

fn height_m(index: usize) -> f64 {
    2.0 * (1.5e7f64).powf(index as f64 / (HEIGHTS - 1) as f64)
}

/// The eye `altitude_m` above a place at `target`, which it sees in the middle of the picture, `zenith` radians off its zenith.
fn eye_on(target: Geodetic, zenith: f64, heading: f64, altitude_m: f64) -> Camera {
    let look = Camera { lat: target.lat, lon: target.lon, altitude_m: 0.0, heading, tilt: zenith };
    let basis: Basis = look.basis();
    let position = WGS84.ecef_from_geodetic(target);
    let rise =
        |distance: f64| WGS84.geodetic_from_ecef(position - basis.forward * distance).unwrap().height - target.height;
    let (mut near, mut far) = (0.0, 3.0 * altitude_m + 10.0);
    for _ in 0..80 {
        let middle = 0.5 * (near + far);
        if rise(middle) < altitude_m { near = middle } else { far = middle }
    }
    Camera::from_ecef(position - basis.forward * far, &basis).unwrap()
}

/// Luminance and weight, summed over the water in ellipses around the middle of the picture; radii across and up in half heights.
fn water<const N: usize>(
    renderer: &mut Renderer,
    state: &ViewState,
    size: [u32; 2],
    radii: [[f64; 2]; N],
) -> [DVec2; N] {
    let luminance = render::measure(renderer, state, size, LayerName::Luminance).unwrap();
    let half = f64::from(size[1]) / 2.0;
    let middle = 0.5 * DVec2::new(f64::from(size[0]), f64::from(size[1]));
    let mut sums = [DVec2::ZERO; N];
    for (index, luminance) in (0..).zip(&luminance.values) {
        let pixel = DVec2::new(f64::from(index % size[0]) + 0.5, f64::from(index / size[0]) + 0.5) - middle;
        for (sum, [across, up]) in sums.iter_mut().zip(radii) {
            // Pixels on the edge count in part.
            let inside = up * half - (pixel * DVec2::new(up / across, 1.0)).length();
            let weight = (inside + 0.5).clamp(0.0, 1.0);
            *sum += weight * DVec2::new(*luminance, 1.0);
        }
    }
    sums
}

/// A sweep straight over places of the open ocean, or past their zenith.
struct Sweep {
    name: &'static str,
    zenith_deg: f64,
    size: [u32; 2],
    /// What is measured up to [`FEW_WAVES_M`]: radii across and up, in half heights of the picture. Above, it is [`HIGH`].
    low: [f64; 2],
    highest_m: f64,
}

impl Sweep {
    /// Height, mean luminance there, and the part by which it has changed since the height before.
    ///
    /// It is the same water whose means are compared: the ellipse shrinks as the eye rises. That water is then seen a little less
    /// slantwise at its edges. What this does to the large parts that are compared low down is known from the ellipses of one picture,
    /// whose means differ by it and by chance, which the mean over all low heights takes away. So that the water stays in the middle,
    /// the eye rises from its surface.
    fn steps(&self, renderer: &mut Renderer, sea: &str) -> Vec<[f64; 3]> {
        const TIME: &str = "2026-06-21T21:00:00Z";
        let mut state = render::parse_state(&format!("#{sea}&quality=low&time={TIME}")).unwrap();
        let ratio = height_m(1) / height_m(0);
        let shrunk = |radii: [f64; 2]| radii.map(|radius| radius / ratio);
        let radii = [shrunk(self.low), self.low, shrunk(HIGH), HIGH];
        let heights: Vec<_> = (0..HEIGHTS).map(height_m).filter(|height| *height <= self.highest_m).collect();
        let places = |height: f64| match height {
            _ if height < FEW_FLECKS_M => PLACES,
            _ if height < FEW_WAVES_M => SOME_PLACES,
            _ => 1,
        };
        let mut sums = vec![[[DVec2::ZERO; 4]; PLACES]; heights.len()];
        for place in 0..PLACES {
            // Within 6 km of each other, evenly, in the open South Pacific.
            let [x, y] = [0.754_877_666, 0.569_840_291].map(|step| 1e-3 * (step * place as f64).fract());
            let (lat, lon) = (-0.17 + x, -2.1 + y);
            let height =
                renderer.seas_mut().sample(&state.settings, lat, lon, render::instant(&state), f64::INFINITY).height_m;
            for (&altitude_m, sums) in heights.iter().zip(&mut sums).filter(|(height, _)| place < places(**height)) {
                state.camera = eye_on(Geodetic { lat, lon, height }, self.zenith_deg.to_radians(), 0.5, altitude_m);
                sums[place] = water(renderer, &state, self.size, radii);
            }
        }
        let is_low = |height: f64| height <= FEW_WAVES_M;
        // At the height `at`, of the part and as many places as the height `of` has, shrunk (0) or whole (1).
        let mean = |at: usize, of: usize, whole: usize| {
            let first = if is_low(heights[of]) { 0 } else { 2 };
            let sum: DVec2 = sums[at][..places(heights[of])].iter().map(|sums| sums[first + whole]).sum();
            sum.x / sum.y
        };
        let low = heights.iter().filter(|height| is_low(**height)).count();
        let slant = (0..low).map(|i| (mean(i, i, 1) / mean(i, i, 0)).ln()).sum::<f64>() / low as f64;
        let change = |i: usize| {
            let same_water = mean(i, i, 0) / mean(i - 1, i, 1);
            if i < low { slant.exp() * same_water } else { same_water }
        };
        (1..heights.len()).map(|i| [heights[i], mean(i, i, 1), change(i) - 1.0]).collect()
    }

    fn check(&self, sea: &str) {
        let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
        let start = std::time::Instant::now();
        let steps = self.steps(&mut renderer, sea);
        for [height_m, mean, step] in &steps {
            println!("{height_m:12.1} m {mean:.5} {:+.2} %", 100.0 * step);
        }
        let [height_m, mean, step] = *steps.iter().max_by(|a, b| a[2].abs().total_cmp(&b[2].abs())).unwrap();
        println!("{} {sea}: at most {:+.2} % at {height_m:.1} m, {:.1?}", self.name, 100.0 * step, start.elapsed());
        assert!(step.abs() < STEP, "{} {sea}: {:+.2} % at {height_m:.1} m, mean {mean}", self.name, 100.0 * step);
    }
}

const DOWN: Sweep = Sweep { name: "down", zenith_deg: 0.0, size: [96; 2], low: [0.9; 2], highest_m: 4e7 };
/// From higher up, a place 60° off is close to the limb. Low down a band across: all of it is seen at about the same slant.
const OBLIQUE: Sweep = Sweep { name: "oblique", zenith_deg: 60.0, size: [192, 48], low: [2.4, 0.3], highest_m: 3e6 };

// In a breeze roughness makes the luminance, in a gale whitecaps: a sweep of each takes minutes.

#[test]
fn a_fresh_breeze_seen_from_above_has_one_luminance() {
    DOWN.check("bft=5&clouds=0");
}

#[test]
fn a_gale_seen_aslant_has_one_luminance() {
    OBLIQUE.check("bft=8");
}
