//! Waves that the wind raises off a lee shore, as they are drawn: against Young and Verhagen's growth with the fetch.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::GRAVITY;
use ocean_globe::model::sheltered_sea::young_verhagen;
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::time::SceneTime;

use crate::plane_beach::{DEGREE_M, SHORE_DEG, WITHIN_DEG};
use crate::small_world;

const SIZE: [u32; 2] = [320, 320];

/// Significant height where the wind blows straight off a straight shore so far away: each direction's part of a wind sea (cos²ˢ of half the angle,
/// s = 10) as high as the fetch in that direction lets it grow.
fn off_a_straight_shore(speed_mps: f64, way_m: f64) -> f64 {
    let (mut sum, mut whole) = (0.0, 0.0);
    for i in 0..2_000 {
        let angle = PI * ((f64::from(i) + 0.5) / 1_000.0 - 1.0);
        let weight = (0.5 * angle).cos().powi(20);
        whole += weight;
        if angle.abs() < FRAC_PI_2 {
            sum += weight * young_verhagen(speed_mps, way_m / angle.cos(), f64::INFINITY).0.powi(2);
        }
    }
    (sum / whole).sqrt()
}

#[test]
fn drawn_waves_off_a_lee_shore_are_as_high_as_the_fetch_lets_them_grow() {
    let folder = small_world::baked("fetch");
    let mut renderer = render::headless(folder.path().to_str().unwrap(), Radiance::Single).unwrap();
    for (speed_mps, way_m) in [(12.0, 12e3), (20.0, 40e3)] {
        // Five waves across a picture, of cells that hold a fiftieth of one.
        let length_m = GRAVITY * young_verhagen(speed_mps, way_m, f64::INFINITY).1.powi(2) / TAU;
        let link = format!(
            "#view={WITHIN_DEG},{},{:.0},0,0&wind={speed_mps}@270&surf=1,0.3&clouds=0",
            SHORE_DEG + way_m / DEGREE_M,
            6.0 * length_m
        );
        let mut state = render::parse_state(&link).unwrap();
        let (mut square, mut count) = (0.0, 0);
        // A patch of the sea holds few waves that are a third of its width: seas of one seed are a tenth higher or lower.
        for seed in 0..8 {
            state.settings.seed = seed;
            state.time = SceneTime::At(1_782_000_000.0 + 97.0 * f64::from(seed));
            let heights = render::measure(&mut renderer, &state, SIZE, LayerName::Height).unwrap().values;
            square += heights.iter().map(|height| height * height).sum::<f64>();
            count += heights.len();
        }
        let (found, wanted) = (4.0 * (square / count as f64).sqrt(), off_a_straight_shore(speed_mps, way_m));
        println!("{speed_mps} m/s over {way_m} m: {found:.3} m for {wanted:.3}");
        // As the model's gains (`sheltered_sea`), 6 %; cells lose 4 % and eight seas leave 4.
        assert!((found / wanted - 1.0).abs() < 0.1, "{found} {wanted}");
    }
}
