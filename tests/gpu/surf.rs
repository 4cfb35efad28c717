//! White water of surf as the sea's shader has it.

use std::f64::consts::TAU;

use ocean_globe::data::world::World;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::wave_trains::{TRAINS, trains};
use ocean_globe::scene::frame::{Frame, SURF_HIGHEST_M, SURF_SEEN_M};
use ocean_globe::scene::settings::{Settings, Swell, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::beside_shore::{Asker, made};
use crate::kernel;

const SHARES: &str = "#import surf
@group(2) @binding(0) var<storage, read> asked: array<vec2f>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let waves = ShoreWaves(0.0, vec2f(0.0), 1.0, asked[id.x].x, 2.0, 1.0, 0.0, vec2f(0.0));
    found[id.x] = surf_at(waves, 30.0, 1.0, 1.4, asked[id.x].y, 0.0).x;
}";

/// Between one crest of the trains and the next white water becomes less and less, though a swell's crests come more seldom than those of
/// the wind's waves.
#[test]
fn white_water_is_made_by_the_crests_that_are_drawn() {
    let mut world = World::open("www/data");
    let camera = Camera::from_degrees(52.0986, 4.2520, 30.0, 0.0, 60.0);
    let settings = Settings {
        wind: Wind { speed_mps: 5.0, from_deg: 310.0 },
        swell: Some(Swell { height_m: 1.5, period_s: 12.0, from_deg: 300.0 }),
        ..Settings::default()
    };
    let tables = SeaTables::of(&settings);
    let period = TAU * TRAINS as f64 / trains(&tables).unwrap().iter().map(|train| train.omega).sum::<f64>();
    let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
    let shores = made(&mut world, &frame);
    let age = |step: usize| (step as f64 / 100.0 * period) as f32;
    let mut asker = Asker::new(SHARES);
    let [narrow, wide] = [0.01f32, 1.2].map(|footprint_m| {
        let asked: Vec<[f32; 2]> = (0..100).map(|step| [age(step), footprint_m]).collect();
        asker.found::<_, f32>(&shores, &frame, &asked)
    });
    let peak = narrow.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    println!("{period:.2} s from crest to crest; {:.2} white at most, {:.2} s after a crest", peak.1, age(peak.0));
    // A front is white a twentieth of a second after its crest; the steps are 0.09 s long.
    assert!(age(peak.0) < 0.2 && peak.1 > 0.9, "{narrow:?}");
    // The last step is in the next front.
    assert!(narrow[peak.0..99].windows(2).all(|pair| pair[1] <= pair[0]), "{narrow:?}");
    assert!(narrow[98] < 0.6, "{narrow:?}");
    // Wide pixels see fronts less sharp, and no less white.
    let [narrow, wide] = [narrow, wide].map(|shares| shares.iter().sum::<f32>() / 100.0);
    println!("in the mean {narrow:.3} are white, to wide pixels {wide:.3}");
    assert!((wide / narrow - 1.0).abs() < 0.03, "{wide} for {narrow}");
}

const COMING_IN: &str = "#import surf
@group(2) @binding(0) var<storage, read> asked: array<f32>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    found[id.x] = height_coming_in(OPEN_SEA, asked[id.x]);
}";

/// Far off, and from far above, surf goes before pictures leave it out: no white line stands where it begins.
#[test]
fn surf_has_no_seam_where_pictures_leave_it_out() {
    let settings = Settings { wind: Wind { speed_mps: 15.0, from_deg: 310.0 }, ..Settings::default() };
    for altitude_m in [2.0, 500.0, 6_000.0, 19_000.0, 19_990.0] {
        let frame = Frame::new(&settings, &Camera::from_degrees(0.0, 0.0, altitude_m, 0.0, 60.0), 0.0, [64; 2]);
        let ends_m = SURF_SEEN_M + 2.0 * altitude_m;
        assert!(frame.shows_surf(ends_m - 1.0) && !frame.shows_surf(ends_m + 1.0), "{altitude_m}");
        let asked: Vec<f32> = (0..=110).map(|percent| (0.01 * f64::from(percent) * ends_m) as f32).collect();
        let found = kernel::answers_in::<_, f32>(COMING_IN, &asked, |uniform| *uniform = frame.uniform);
        let open = frame.uniform.wave_height;
        println!("{altitude_m} m: {} m near the eye of {open} m, {:?} m at the end", found[0], &found[97..=100]);
        assert!(found[100..].iter().all(|height| *height == 0.0), "{altitude_m}: {found:?}");
        // A smooth step over four tenths of the way has nowhere a slope of more than 1.5 / 0.4.
        assert!(
            found.windows(2).all(|pair| (0.0..=0.038 * open).contains(&(pair[0] - pair[1]))),
            "{altitude_m}: {found:?}"
        );
        // From the highest eye that sees any there is next to none anywhere.
        if altitude_m > 19_900.0 {
            assert!(found[0] < 0.001 * open, "{found:?}");
        } else if altitude_m < 10_000.0 {
            assert_eq!(found[0], open);
        }
    }
    let higher = Frame::new(&settings, &Camera::from_degrees(0.0, 0.0, SURF_HIGHEST_M, 0.0, 60.0), 0.0, [64; 2]);
    assert!(!higher.shows_surf(0.0));
}
