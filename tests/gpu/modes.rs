//! Sines and Gerstner waves as they are drawn, against their sum in f64.

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::earth::{self, WGS84};
use ocean_globe::model::moved_water::Place;
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::sea::Seas;

use crate::summed::summed;
use crate::water::NOON;

const SIDE: u32 = 65;
/// Latitudes of places with waves of their own.
const PLACES: [f64; 6] = [35.68, 34.3, 33.1, 31.2, 29.7, 27.6];

#[test]
fn heights_and_slopes_of_pictures_are_those_of_the_sums() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let mut renderer = render::headless(data, Radiance::Single).unwrap();
    for spectrum in ["sines", "gerstner"] {
        let ([mut heights, mut slopes], mut ripples) = ([[0.0; 3]; 2], [0.0; 2]);
        for lat in PLACES {
            // From 30 m cells of the mesh are 4 m wide and see all waves but ripples, pixels half a metre.
            let link = format!(
                "#view={lat},-14.25,30,0,0&clouds=0&bft=7&chop=0.9&quality=high&spectrum={spectrum}&time=2026-11-20T12:00:00Z"
            );
            let state = render::parse_state(&link).unwrap();
            let height = render::measure(&mut renderer, &state, [SIDE; 2], LayerName::Height).unwrap();
            let normal = render::measure(&mut renderer, &state, [SIDE; 2], LayerName::Normal).unwrap();
            let (eye, tables) = (renderer.eye(&state, NOON), Seas::default().tables(&state.settings));
            let (modes, chop, rest) = (tables.sea.modes(), tables.sea.chop, tables.sea.drawn_spectrum());
            ripples = [rest.variance_between(0.0, f64::INFINITY), rest.mss_between(0.0, std::f64::consts::PI / 0.5)];
            for index in (0..height.values.len()).step_by(7) {
                let drawn_m = height.values[index];
                let level = earth::Ellipsoid { a: WGS84.a + drawn_m, b: WGS84.b + drawn_m };
                let [row, column] = [index / SIDE as usize, index % SIDE as usize].map(|i| i as f64 + 0.5);
                let hit = eye.unproject_onto(&level, DVec2::new(column, row), DVec2::splat(f64::from(SIDE))).unwrap();
                let at = WGS84.geodetic_from_ecef(hit).unwrap();
                let place = Place::new(&tables, state.settings.wind_from(), at.lat, at.lon);
                let (_, motion) = place.invert(chop, |cascade, at| summed(&modes, cascade, at, NOON));
                let wanted_m = motion.height - tables.chop_level_m;
                let slope = DVec2::from(motion.chop_gradient(chop).true_slope(motion.slope.x, motion.slope.y));
                let drawn = DVec3::from_slice(&normal.values[3 * index..3 * index + 3]);
                let drawn = -drawn.truncate() / drawn.z;
                add(&mut heights, [drawn_m * drawn_m, drawn_m * wanted_m, wanted_m * wanted_m]);
                add(&mut slopes, [drawn.dot(drawn), drawn.dot(slope), slope.dot(slope)]);
            }
        }
        let ((gain, apart_m, rms_m), (tilt, off, steep)) = (fit(heights), fit(slopes));
        let [ripples_m, ripples] = ripples.map(f64::sqrt);
        println!(
            "{spectrum}: heights {gain:.4} of {rms_m:.3} m, {apart_m:.4} m apart, ripples {ripples_m:.4} m; slopes {tilt:.4} of \
             {steep:.4}, {off:.4} apart, ripples {ripples:.4}"
        );
        // Ripples are independent of the waves: their part of the ratio is theirs to the waves', over the root of the 500 or so
        // that these pixels see. The mesh takes off a hundredth of the shortest waves' heights.
        assert!((gain - 1.0).abs() < 0.01 + 0.05 * ripples_m / rms_m, "{spectrum}: heights are {gain} of the sum");
        assert!((tilt - 1.0).abs() < 0.01 + 0.05 * ripples / steep, "{spectrum}: slopes are {tilt} of the sum");
        // And what is apart are the ripples.
        assert!(apart_m < 1.1 * ripples_m && off < 1.1 * ripples, "{spectrum}: {apart_m} m, {off}");
    }
}

/// Adds to the sums of a pixel's drawn² · drawn × wanted · wanted².
fn add(sums: &mut [f64; 3], of_pixel: [f64; 3]) {
    let pixels = f64::from(SIDE * SIDE) / 7.0 * PLACES.len() as f64;
    sums.iter_mut().zip(of_pixel).for_each(|(sum, more)| *sum += more / pixels);
}

/// The share of what is wanted that is drawn, the rms of what is drawn besides, and that of what is wanted.
fn fit([drawn, both, wanted]: [f64; 3]) -> (f64, f64, f64) {
    (both / wanted, (drawn - 2.0 * both + wanted).max(0.0).sqrt(), wanted.sqrt())
}
