//! Swash as the land's shader has it, against the model in f64.

use std::f64::consts::TAU;

use ocean_globe::data::tile::{MapPoint, Projection};
use ocean_globe::data::world::World;
use ocean_globe::model::GRAVITY;
use ocean_globe::model::swash::{Arriving, CRESTS, RAYLEIGH_FIFTIETH, RunUp, Sheet, crests};
use ocean_globe::model::wave_trains::{TRAINS, trains};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::beside_shore::{Asker, made, places};
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

const FRONTS: &str = "#import swash
struct Asked { at: vec2u, x: f32, height: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    found[id.x] = swash_at(MapPoint(MERCATOR, a.at), vec2f(0.0), a.x, a.height, 0.06, 1.2, 0.02).covered;
}";

/// Slope of the beach, as shaders are told.
const SLOPE: f64 = 0.06;

fn dutch_beach() -> Camera {
    Camera::from_degrees(52.0986, 4.2520, 30.0, 0.0, 60.0)
}

/// What a camera sees so many seconds after an instant, in one sea, whose wind blows on to the beach.
fn frames(camera: &Camera, seed: u32) -> impl FnMut(f64) -> Frame {
    let settings = Settings { wind: Wind { speed_mps: 9.0, from_deg: 310.0 }, seed, ..Settings::default() };
    let mut seas = Seas::default();
    move |second| Frame::of(&mut seas, &settings, camera, 1_782_039_600.0 + second, [64; 2])
}

/// Places in the water about a camera, latitude and longitude, those nearest to the waterline first.
fn by_the_waterline(world: &mut World, camera: &Camera, spread_m: f64) -> Vec<(f64, f64)> {
    let mut found = places(world, camera, spread_m);
    found.sort_by(|a, b| a.2.d.abs().total_cmp(&b.2.d.abs()));
    found.into_iter().map(|(lat, lon, _)| (lat, lon)).collect()
}

/// Fronts of the water on a beach by the trains that come to it, at instants 0.2 s apart: each runs up and back as a ball thrown up the slope.
#[test]
fn fronts_move_as_the_models_sheets_do() {
    const STEP_S: f64 = 0.2;
    const LAG: usize = 5;
    let (mut world, camera) = (World::open("www/data"), dutch_beach());
    let mut at_second = frames(&camera, Settings::default().seed);
    let (lat, lon) = by_the_waterline(&mut world, &camera, 23.0)[0];
    let point = MapPoint::on(Projection::Mercator, lat, lon);
    let shores = made(&mut world, &at_second(0.0));
    let mut asker = Asker::new(FRONTS);
    let xs: Vec<f32> = (1..260).map(|i| 0.04 * i as f32).collect();
    let asked: Vec<[u32; 4]> = xs.iter().map(|x| [point.u, point.v, x.to_bits(), 2f32.to_bits()]).collect();
    let fronts: Vec<f64> = (0..160)
        .map(|instant| {
            let covered: Vec<f32> = asker.found(&shores, &at_second(STEP_S * f64::from(instant)), &asked);
            covered.iter().rposition(|covered| *covered > 0.5).map_or(0.0, |last| f64::from(xs[last]))
        })
        .collect();
    let slows = GRAVITY * SLOPE;
    // Over a second to either side, where the front is one wave's: a new one comes in with a jump, or overtakes the last with a kink.
    let bends = fronts.windows(2 * LAG + 1).filter_map(|way| {
        let is_one = way.windows(2).all(|pair| pair[1] > 0.0 && (pair[1] - pair[0]).abs() < 0.7);
        let bend = way[0] - 2.0 * way[LAG] + way[2 * LAG];
        (is_one && bend < 0.1).then_some(bend / (STEP_S * LAG as f64).powi(2))
    });
    let mut bends: Vec<f64> = bends.collect();
    bends.sort_by(f64::total_cmp);
    let (count, most) = (bends.len(), fronts.iter().copied().fold(0.0, f64::max));
    assert!(count > 60 && most > 5.0, "{fronts:?}");
    let median = bends[count / 2];
    println!(
        "fronts up to {most:.1} m slow down by {median:.3} m/s², in {count} of {} instants; the slope by {slows:.3}",
        fronts.len()
    );
    // A crest's age runs within some hundredths of a second of the clock (`crests`), at 2 m/s: some hundredths of a metre in 0.77.
    assert!((median / -slows - 1.0).abs() < 0.15, "{bends:?}");
}

const HIGHEST: &str = "#import swash
struct Asked { at: vec2u, x: f32, height: f32 }
struct Found { covered: f32, square: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let point = MapPoint(MERCATOR, a.at);
    var trains: Arriving;
    let share = arriving_at(point, false, &trains);
    var square = 0.0;
    for (var t = 0u; t < SHORE_TRAINS; t++) { square += dot(trains[t].yz, trains[t].yz); }
    found[id.x] = Found(swash_at(point, vec2f(0.0), a.x, a.height, 0.06, 0.05, 0.02).covered, 0.5 * square);
}";

/// The water's highest places, as a camera on a beach finds them, against Stockdon's height that a fiftieth of the waves pass.
#[test]
fn a_fiftieth_of_the_waves_runs_up_as_far_as_stockdon_has_it() {
    // A front turns at its highest place: half a second before, it is 7 cm farther down the beach.
    const STEP_S: f64 = 1.0;
    const INSTANTS: usize = 400;
    // What the highest waves reach.
    const FROM_M: f32 = 5.0;
    const CELL_M: f32 = 0.25;
    const CELLS: usize = 32;
    let (mut world, camera) = (World::open("www/data"), dutch_beach());
    // Places of the waterline so far apart that tongues of one do not reach the next.
    let mut line: Vec<(f64, f64)> = Vec::new();
    for (lat, lon) in by_the_waterline(&mut world, &camera, 60.0) {
        let away_m = |&(lat2, lon2): &(f64, f64)| 6.37e6 * (lat - lat2).hypot((lon - lon2) * lat.cos());
        if line.len() < 10 && line.iter().all(|other| away_m(other) > 70.0) {
            line.push((lat, lon));
        }
    }
    assert_eq!(line.len(), 10, "places of the waterline");
    // Highest places over Stockdon's, of all seas.
    let (mut highest, mut waves) = (Vec::new(), 0.0);
    for seed in 1..=4 {
        let mut at_second = frames(&camera, seed);
        let frame = at_second(0.0);
        let (shores, mut asker) = (made(&mut world, &frame), Asker::new(HIGHEST));
        let height = frame.sea.sea.hs_m;
        let omega = trains(&frame.sea).unwrap().iter().map(|train| train.omega / TRAINS as f64).sum::<f64>();
        let asked: Vec<[u32; 4]> = (line.iter().map(|&(lat, lon)| MapPoint::on(Projection::Mercator, lat, lon)))
            .flat_map(|point| (1..=CELLS).map(move |cell| (point, FROM_M + cell as f32 * CELL_M)))
            .map(|(point, x)| [point.u, point.v, x.to_bits(), (height as f32).to_bits()])
            .collect();
        // Of each place, where its front is by the instant, and the energy that comes to it.
        let mut fronts = vec![Vec::new(); line.len()];
        let mut energy = vec![0.0; line.len()];
        for instant in 0..INSTANTS {
            let found: Vec<[f32; 2]> = asker.found(&shores, &at_second(STEP_S * instant as f64), &asked);
            for (place, cells) in found.chunks(CELLS).enumerate() {
                let last = cells.iter().rposition(|[covered, _]| *covered > 0.5);
                fronts[place].push(last.map_or(0.0, |last| FROM_M + (last as f32 + 1.5) * CELL_M));
                energy[place] += f64::from(cells[0][1]) / INSTANTS as f64;
            }
        }
        waves += STEP_S * INSTANTS as f64 * omega / TAU * line.len() as f64;
        for (fronts, energy) in fronts.iter().zip(&energy) {
            // As high as the waves are that come here.
            let wanted = RunUp::new(height, omega, SLOPE).of(RAYLEIGH_FIFTIETH * 4.0 * energy.sqrt() / height);
            let turns = fronts.windows(3).filter(|three| three[1] > three[0] && three[1] >= three[2]);
            highest.extend(turns.map(|three| SLOPE * f64::from(three[1]) / wanted));
        }
    }
    highest.sort_by(|a, b| b.total_cmp(a));
    let found = highest[(waves / 50.0).round() as usize];
    println!("a fiftieth of {waves:.0} waves runs up {found:.3} times as far as Stockdon has it");
    // The model's 5 %; of so many waves, those of neighbouring places alike in part, chance makes 3 %.
    assert!((found - 1.0).abs() < 0.05, "{found}");
}
