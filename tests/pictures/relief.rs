//! The relief that shades the land, against the elevations that it stands for.

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName, headless, parse_state};
use ocean_globe::data::world::World;
use ocean_globe::model::earth::WGS84;
use ocean_globe::renderer::Radiance;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [48, 48];
/// Relief is drawn so much steeper than it is (`shaders/land.wgsl`).
const STEEPER: f64 = 1.5;
/// Half the way over which a slope is taken from the elevations, m: half a texel of the deepest terrain tiles, about. A quadratic B-spline
/// rises at a place by what the texels, joined by straight lines, rise from half a texel before it to half a texel behind.
const STEP_M: f64 = 2_250.0;

/// Mountains in each of the map's squares, at longitudes all round the pole.
const MOUNTAINS: [&str; 6] = ["-33,-70", "46,8", "-84.9,-165", "-85.6,-80", "-86.3,-150", "-84.6,165"];

#[test]
fn slopes_are_those_of_the_ground_to_the_east_and_north() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    for place in MOUNTAINS {
        let state = parse_state(&format!("#view={place},40000&clouds=0&time=2026-12-21T12:00:00Z")).unwrap();
        let mut measured = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
        let (places, normals) = (measured(LayerName::Lonlat), measured(LayerName::Normal));
        let (mut products, mut drawn_power, mut true_power) = (0.0, 0.0, 0.0);
        for (place, normal) in places.chunks_exact(2).zip(normals.chunks_exact(3)) {
            let (lat, lon) = (place[1].to_radians(), place[0].to_radians());
            let mut elevation = |north: f64, east: f64| {
                let (lat, lon) = (lat + north / WGS84.a, lon + east / (WGS84.a * lat.cos()));
                world.sample_blocking(lat, lon).unwrap().elevation_m
            };
            let rise = DVec2::new(
                elevation(0.0, STEP_M) - elevation(0.0, -STEP_M),
                elevation(STEP_M, 0.0) - elevation(-STEP_M, 0.0),
            );
            let slope = rise / (2.0 * STEP_M);
            // Normals are those of the eye's axes: the ground's own up leans away by its distance from the eye's foot.
            let away = DVec2::new((lon - state.camera.lon) * lat.cos(), lat - state.camera.lat);
            let drawn = (away - DVec2::new(normal[0], normal[1]) / normal[2]) / STEEPER;
            products += drawn.dot(slope);
            drawn_power += drawn.length_squared();
            true_power += slope.length_squared();
        }
        let (alike, size) = (products / (drawn_power * true_power).sqrt(), (drawn_power / true_power).sqrt());
        let steepness = (true_power / f64::from(SIZE[0] * SIZE[1])).sqrt();
        println!("{place}: slopes of {steepness:.4} are drawn {size:.3} times as steep, correlation {alike:.4}");
        assert!(steepness > 0.005, "{place}: {steepness} is no mountain");
        // The spline smooths across the slope as well, and polar texels are narrower than the step: some hundredths. The eye's axes are
        // turned against the pixel's by up to 3°, a twentieth. Axes of the map taken for east and north turn them by the longitude.
        assert!(alike > 0.98 && (0.95..1.1).contains(&size), "{place}: {alike}, {size}");
    }
}
