//! Swash as the land's shader has it, against the model in f64.

use ocean_globe::model::swash::{Arriving, CRESTS, RunUp, Sheet, crests};

use crate::kernel;

const SHEETS: &str = "#import swash
struct Found { rises: vec4f, ages: vec4f, heights: vec4f }
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let rises = run_up(a.x, WHOLE_TURN / a.y, a.z);
    let s = sheet_of(rises.x + rises.y, a.z);
    let x = 0.3 * (rises.x + rises.y) / a.z;
    var trains: Arriving;
    for (var t = 0u; t < SHORE_TRAINS; t++) {
        let phase = fract(a.w * f32(t + 1u) * 0.381966) * WHOLE_TURN;
        trains[t] = vec3f((0.8 + 0.06 * f32(t)) * WHOLE_TURN / a.y, 0.1 * a.x * cos(phase), 0.1 * a.x * sin(phase));
    }
    let crests = last_crests(&trains, 1.01 * WHOLE_TURN / a.y, false);
    found[id.x] = Found(vec4f(rises, front_of(s, a.w), film_of(s, x, a.w)), crests.ages, crests.heights);
}";

#[test]
fn sheets_and_crests_are_those_of_the_model() {
    let mut asked = Vec::new();
    for height in [0.1f32, 1.0, 4.0] {
        for period in [4.0f32, 8.0, 14.0] {
            for slope in [0.02f32, 0.06, 0.15] {
                asked.extend([0.4f32, 1.7, 3.3, 7.1].map(|seconds| [height, period, slope, seconds]));
            }
        }
    }
    let found = kernel::answers::<_, [f32; 12]>(SHEETS, &asked);
    let mut compared = 0;
    for (asked, found) in asked.iter().zip(&found) {
        let [height, period, slope, seconds] = asked.map(f64::from);
        let mean = std::f64::consts::TAU / period;
        let rises = RunUp::new(height, mean, slope);
        let sheet = Sheet::new(rises.of(1.0), slope);
        let x = 0.3 * rises.of(1.0) / slope;
        let wanted = [rises.setup_m, rises.of_height_m, sheet.front(seconds), sheet.film(x, seconds)];
        for (what, (wanted, found)) in wanted.iter().zip(found).enumerate() {
            // A few operations in 32 bits, which lose 6e-8 each of what is added: of the way at first speed, and of the film there.
            let scale = [0.02, 0.02, sheet.speed * seconds, sheet.speed * sheet.speed / 9.8][what].max(wanted.abs());
            let error = (f64::from(*found) - wanted).abs() / scale;
            assert!(error < 2e-6, "{what}: {found} for {wanted}, {asked:?}");
        }
        let trains: Vec<Arriving> = (0..8)
            .map(|t| Arriving {
                omega: (0.8 + 0.06 * f64::from(t)) * mean,
                amplitude: 0.1 * height,
                phase: (seconds * f64::from(t + 1) * 0.381966).fract() * std::f64::consts::TAU,
            })
            .collect();
        for (k, crest) in
            crests(&trains, 1.01 * mean).iter().enumerate().filter(|(_, crest)| crest.height > 0.05 * height)
        {
            // The phase of a sum of eight in 32 bits, whose 17 turns each lose a bit.
            let (age, high) = (f64::from(found[4 + k]), f64::from(found[4 + CRESTS + k]));
            assert!((age - crest.age).abs() < 1e-3 * period, "crest {k}: {age} s for {}, {asked:?}", crest.age);
            assert!((high - crest.height).abs() < 1e-3 * height, "crest {k}: {high} m for {}, {asked:?}", crest.height);
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

/// What a multisampled pixel has whose middle lies beside its triangle, between vertices where no waves come in.
#[test]
fn less_than_no_waves_run_up_nowhere() {
    let asked = [-1e-3f32, -1e-9, 0.0].map(|height| [height, 8.0, 0.06, 3.3]);
    for (asked, found) in asked.iter().zip(kernel::answers::<_, [f32; 12]>(SHEETS, &asked)) {
        assert_eq!(found[..2], [0.0, 0.0], "run-up, {asked:?}");
        assert_eq!(found[3], 0.0, "film, {asked:?}");
        assert!(found.iter().all(|value| value.is_finite()), "{found:?}, {asked:?}");
    }
}
