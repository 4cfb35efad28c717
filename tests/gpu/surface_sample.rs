//! The surface that the CPU measures is the one that the GPU draws.

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::gpu::shader;
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::pass::fft::{Precision, WaveData};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::sea::surface_sample::SurfaceSample;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::water::{NOON, Water};

/// What the drawing shaders make of points at rest: displacement, then slope and Jacobian.
const KERNEL: &str = "#import waves
const WAVES = true;
const NOISE = true;
@group(2) @binding(0) var<storage, read> points: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> moved: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> sloped: array<vec4f>;
@compute @workgroup_size(64)
fn drawn(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let p = points[id.x].xyz;
    let slopes = slopes_in(OPEN_SEA, p, length(p), 0.0, 1.0);
    let up = normal_delta(p);
    moved[id.x] = vec4f(displacement_in(OPEN_SEA, p, length(p), 0.0), mix_weights(length(p)).y);
    sloped[id.x] = vec4f(up.xy - slopes.slope, 1.0 + up.z, slopes.fold);
}";

/// Displacement (east, north, up at the eye), Perlin weight; normal (not unit), Jacobian.
fn drawn(water: &mut Water, frame: &Frame, points: &[DVec3]) -> Vec<([f32; 4], [f32; 4])> {
    water.set_waves(&frame.sea.cascades, &WaveData::of(&frame.sea), frame.ticks());
    let kernel = water.kernel::<2>(&shader::composed(KERNEL, ""), "drawn");
    let list: Vec<[f32; 4]> = points.iter().map(|p| p.as_vec3().extend(0.0).to_array()).collect();
    let [moved, sloped] = kernel.run(&water.gpu, &water.groups(frame).each_ref(), &list);
    moved.into_iter().zip(sloped).collect()
}

/// Places around an eye, latitude and longitude in radians, as far as the waves are the patches' alone.
fn places(camera: &Camera) -> Vec<(f64, f64)> {
    let enu = earth::ecef_from_enu(camera.lat, camera.lon);
    let foot = WGS84.ecef_from_geodetic(Geodetic { height: 0.0, ..camera.geodetic() });
    let at = |i: usize| {
        // A spiral from the eye to 1.8 km.
        let (sin, cos) = (2.4 * i as f64).sin_cos();
        let out = 1800.0 * (i as f64 / 100.0).powi(2);
        let place = WGS84.geodetic_from_ecef(foot + enu * DVec3::new(out * cos, out * sin, 0.0)).unwrap();
        (place.lat, place.lon)
    };
    (0..=100).map(at).collect()
}

#[test]
fn height_and_normal_are_those_of_the_shaders_in_a_gale() {
    let mut water = Water::new(256, Precision::Half, |source| source);
    // Cells blend at the first four: open sea, the cube's middle, the antimeridian, beside the pole.
    for (lat, lon) in [(35.6812, -14.25), (0.0, 0.0), (-20.0, -179.9999), (89.9, 30.0), (0.352, 0.352)] {
        let settings = Settings { beaufort: Some(8), ..Settings::default() };
        let camera = Camera::from_degrees(lat, lon, 3.0, 0.0, 0.0);
        let mut seas = Seas::default();
        let frame = Frame::of(&mut seas, &settings, &camera, NOON, [64, 64]);
        let eye_from_ecef = earth::ecef_from_enu(camera.lat, camera.lon).transpose();
        let places = places(&camera);
        let samples: Vec<SurfaceSample> =
            places.iter().map(|&(lat, lon)| seas.sample(&settings, lat, lon, NOON, f64::INFINITY)).collect();
        let feet: Vec<(DVec3, glam::DMat3)> = places
            .iter()
            .map(|&(lat, lon)| {
                let foot = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
                (eye_from_ecef * (foot - camera.eye_ecef()), eye_from_ecef * earth::ecef_from_enu(lat, lon))
            })
            .collect();
        let rests: Vec<DVec3> = samples
            .iter()
            .zip(&feet)
            .map(|(sample, (foot, axes))| {
                let [east, north, _] = sample.displacement_enu_m;
                *foot - *axes * DVec3::new(east, north, 0.0)
            })
            .collect();
        let (mut worst_m, mut worst_deg, mut worst_landing, mut folded) = (0.0f64, 0.0f64, 0.0f64, 0);
        for (((sample, (foot, axes)), rest), (moved, sloped)) in
            samples.iter().zip(&feet).zip(&rests).zip(drawn(&mut water, &frame, &rests))
        {
            let [x, y, z, perlin] = moved.map(f64::from);
            assert_eq!(perlin, 0.0);
            let landing = DVec2::new(rest.x + x, rest.y + y).distance(foot.truncate());
            let normal = DVec3::new(sloped[0].into(), sloped[1].into(), sloped[2].into()).normalize();
            let angle = normal.angle_between(*axes * DVec3::from(sample.normal_enu)).to_degrees();
            // Where the crest has folded the inversion may end between the surfaces; such places are few.
            if sample.jacobian < 0.1 {
                folded += 1;
                continue;
            }
            worst_m = worst_m.max((z - sample.height_m).abs());
            // Farther off, the 32-bit coordinates of the drawing move a point by a hundredth of the finest texel, and pixels
            // are wider than many texels anyway.
            if rest.length() < 300.0 {
                worst_deg = worst_deg.max(angle);
            }
            worst_landing = worst_landing.max(landing);
        }
        println!(
            "{lat},{lon}: {} cells, height within {:.2} cm, normal {worst_deg:.3} deg, inverted to {:.2} cm, {folded} folded",
            frame.uniform.wave_cell_count,
            100.0 * worst_m,
            100.0 * worst_landing
        );
        // 16-bit floats keep heights up to 8 m to 2 mm and each gradient up to 1 to 2.4e-4; the filter's fractions of 1/256
        // texel shift by 4 cm in the longest patch, 4 mm on its slopes of 0.1.
        assert!(worst_m < 0.01, "{lat},{lon}: {worst_m} m");
        assert!(worst_deg < 0.1, "{lat},{lon}: {worst_deg} deg");
        assert!(worst_landing < 0.02, "{lat},{lon}: the chop brings the water {worst_landing} m beside the place");
        assert!(folded <= 3, "{lat},{lon}: {folded}");
    }
}

#[test]
fn height_and_normal_are_those_of_a_picture() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let mut renderer = render::headless(data, Radiance::Single).unwrap();
    let mut seas = Seas::default();
    let (mut heights, mut angles) = (Vec::new(), Vec::new());
    for (lat, lon) in [(35.6812, -14.25), (-20.0, -179.9999), (0.0, 0.0)] {
        // The eye is lifted to a metre over the water, where pixels of 2 mm and mesh cells of 7 mm see all that the finest texels hold.
        let state = render::parse_state(&format!("#view={lat},{lon},0.5,0,0&clouds=0&bft=8&time=2026-11-20T12:00:00Z"))
            .unwrap();
        let height = render::measure(&mut renderer, &state, [513, 513], LayerName::Height).unwrap();
        let normal = render::measure(&mut renderer, &state, [513, 513], LayerName::Normal).unwrap();
        let eye = renderer.eye(&state, NOON);
        assert!(eye.altitude_m > -4.0 && height.values.iter().all(|h| *h < eye.altitude_m));
        for (row, column) in
            (16..500).step_by(48).flat_map(|row| (16..500).step_by(48).map(move |column| (row, column)))
        {
            let index = row * 513 + column;
            let drawn_m = height.values[index];
            // Where the pixel's ray meets a level as high as the drawn surface.
            let level = earth::Ellipsoid { a: WGS84.a + drawn_m, b: WGS84.b + drawn_m };
            let pixel = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
            let hit = eye.unproject_onto(&level, pixel, DVec2::splat(513.0)).unwrap();
            let place = WGS84.geodetic_from_ecef(hit).unwrap();
            let sample = seas.sample(&state.settings, place.lat, place.lon, NOON, f64::INFINITY);
            let drawn = DVec3::from_slice(&normal.values[3 * index..3 * index + 3]);
            heights.push((sample.height_m - drawn_m).abs());
            angles.push(drawn.angle_between(DVec3::from(sample.normal_enu)).to_degrees());
        }
    }
    let quantile = |list: &mut Vec<f64>, q: f64| {
        list.sort_by(f64::total_cmp);
        list[((list.len() - 1) as f64 * q) as usize]
    };
    let h = [0.5, 0.95].map(|q| quantile(&mut heights, q));
    let a = [0.5, 0.95].map(|q| quantile(&mut angles, q));
    println!("height: median {:.4} m, 95 % {:.4} m; normal: median {:.2} deg, 95 % {:.2} deg", h[0], h[1], a[0], a[1]);
    // The mesh interpolates the displacement over 7 mm: the water is a millimetre beside where it should be, where the finest
    // slopes, 0.2 per texel of 1 cm, differ by 0.02, that is 1.2 degrees; before a crest folds it is several times as much.
    assert!(h[0] < 0.004 && h[1] < 0.01);
    assert!(a[0] < 2.0 && a[1] < 8.0);
}

#[test]
fn the_ride_is_the_sample_but_for_the_smallest_waves() {
    for grade in [3, 8, 12] {
        let settings = Settings { beaufort: Some(grade), ..Settings::default() };
        let camera = Camera::from_degrees(35.6812, -14.25, 3.0, 0.0, 0.0);
        let (mut worst, mut seas) = (0.0f64, Seas::default());
        for (lat, lon) in places(&camera).into_iter().step_by(5) {
            let ridden = seas.surface_height(&settings, &Camera { lat, lon, ..camera }, NOON);
            let sample = seas.sample(&settings, lat, lon, NOON, f64::INFINITY);
            worst = worst.max((ridden - sample.height_m).abs());
        }
        let hs = seas.tables(&settings).sea.hs_m;
        println!("grade {grade}: within {worst:.4} m of Hs {hs}");
        assert!(worst < 0.02 * hs, "grade {grade}: {worst} m");
    }
}
