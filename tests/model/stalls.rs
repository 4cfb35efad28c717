//! What a change of the settings costs a frame, counted, not timed; and that work spread over frames comes to what is made at once.

use ocean_globe::model::foam::{Fold, INSTANTS};
use ocean_globe::model::wave_data::{Making, WaveData};
use ocean_globe::model::waves;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::sea::foam::{LEVELS, Whitecaps};
use ocean_globe::scene::sea::seas::{WAVE_WORK, Work};
use ocean_globe::scene::sea::thresholds::POINTS_A_FRAME;
use ocean_globe::scene::settings::{Foam, Quality, Settings, Wind};
use ocean_globe::scene::view::camera::Camera;
use ocean_globe::scene::view::state::ViewState;

/// 2026-11-20T12:00:00Z.
const NOON: f64 = 1_795_176_000.0;
/// Waves of the simulation of foam: bands and directions.
const SIMULATED: usize = 12 * 6;
/// A row of patches of 256 samples is at most its cells by 64 evaluations; a batch is sixteen.
const OVER: usize = 16 * 256 * 64;

fn windy(speed_mps: f64) -> Settings {
    Settings { wind: Wind { speed_mps, from_deg: 250.0 }, ..Settings::default() }
}

fn deck() -> Camera {
    Camera::from_degrees(35.0, -30.0, 12.0, 270.0, 80.0)
}

fn spread() -> Seas {
    let mut seas = Seas::default();
    seas.spread();
    seas
}

/// A frame as the program makes it; what it cost.
fn frame(seas: &mut Seas, settings: &Settings, camera: &Camera) -> (Frame, Work) {
    let before = seas.work();
    seas.begin(settings);
    let frame = Frame::of(seas, settings, camera, NOON, [64, 64]);
    let now = seas.work();
    let work = Work {
        evaluations: now.evaluations - before.evaluations,
        wave_steps: now.wave_steps - before.wave_steps,
        lifted: now.lifted - before.lifted,
    };
    (frame, work)
}

/// Frames until nothing is left to do; the most that one of them cost, and how many they were.
fn settle(seas: &mut Seas, settings: &Settings, camera: &Camera) -> (Work, usize) {
    let (mut most, mut frames) = (Work::default(), 0);
    while frames == 0 || seas.is_busy() {
        let (_, work) = frame(seas, settings, camera);
        most.evaluations = most.evaluations.max(work.evaluations);
        most.wave_steps = most.wave_steps.max(work.wave_steps);
        frames += 1;
        assert!(frames < 10_000, "it never settles");
    }
    (most, frames)
}

#[test]
fn a_move_of_a_slider_costs_a_frame_a_sixteenth_of_the_simulation() {
    let mut seas = spread();
    settle(&mut seas, &windy(12.0), &deck());
    let foamy = Settings { foam: Foam { amount: 1.7, ..Foam::default() }, ..windy(14.0) };
    // Another wind has other waves; another amount of foam and another chop need neither amplitudes nor a simulation.
    let choppy = Settings { chop: 1.4, ..foamy.clone() };
    for (name, settings, waves) in [("wind", windy(14.0), true), ("foam", foamy, false), ("chop", choppy, false)] {
        let (most, frames) = settle(&mut seas, &settings, &deck());
        println!("{name}: {most:?} a frame at most, {frames} frames");
        // A guess and a frame's part may fall into one frame.
        assert!(most.wave_steps <= 2 * POINTS_A_FRAME * INSTANTS * SIMULATED, "{name}: {most:?}");
        assert!(most.evaluations <= WAVE_WORK + OVER, "{name}: {most:?}");
        assert_eq!(most.wave_steps > 0, waves, "{name}: {most:?}");
        assert!(waves || most.evaluations == 0, "{name}: {most:?}");
    }
}

#[test]
fn no_thresholds_are_simulated_where_no_foam_map_is_drawn() {
    let mut seas = spread();
    let high = Camera { altitude_m: 2e7, ..deck() };
    for speed in [8.0, 12.0, 16.0] {
        settle(&mut seas, &windy(speed), &high);
    }
    assert_eq!(seas.work().wave_steps, 0);
    settle(&mut seas, &windy(16.0), &deck());
    assert!(seas.work().wave_steps > 0, "the check sees nothing");
}

#[test]
fn what_is_spread_comes_to_what_is_made_at_once() {
    for (name, settings) in [
        ("wind", windy(12.0)),
        ("chop", Settings { chop: 1.5, ..windy(12.0) }),
        ("lifetime", Settings { foam: Foam { lifetime_s: 9.0, ..Foam::default() }, ..windy(12.0) }),
        ("quality", Settings { quality: Quality::High, ..windy(12.0) }),
    ] {
        let mut seas = spread();
        settle(&mut seas, &windy(7.0), &deck());
        settle(&mut seas, &settings, &deck());
        let (spread, _) = frame(&mut seas, &settings, &deck());
        let at_once = Frame::new(&settings, &deck(), NOON, [64, 64]);
        assert_eq!(spread.sea, at_once.sea, "{name}");
        assert_eq!(spread.whitecaps, at_once.whitecaps, "{name}");
        assert_eq!(spread.whitecaps, Whitecaps::new(settings.foam, &at_once.sea), "{name}");
        assert_eq!(bytemuck::bytes_of(&spread.uniform), bytemuck::bytes_of(&at_once.uniform), "{name}");
        let (spread, at_once) = (seas.waves(&spread.sea), WaveData::of(&at_once.sea));
        assert!(spread.amplitudes == at_once.amplitudes && spread.frequencies == at_once.frequencies, "{name}");
        assert_eq!(spread.scales, at_once.scales, "{name}");
    }
}

#[test]
fn waves_made_by_rows_are_the_models() {
    let tables = Seas::default().tables(&windy(11.0));
    let mut making = Making::new(&tables, None);
    let mut parts = 0;
    while !making.is_complete() {
        making.advance(1_000);
        parts += 1;
    }
    assert!(parts > 20, "{parts} parts");
    let data = making.finish();
    for (index, patch) in tables.cascades.iter().enumerate() {
        let want = waves::initial_amplitudes(&tables.sea, index, patch);
        let want: Vec<_> = want.into_iter().map(|h| h.map(|x| x as f32)).collect();
        assert!(data.amplitudes_of(index, patch.n) == want, "patch {index}");
        let cycles = data.frequencies_of(index, patch.n);
        for (element, omega) in tables.frequencies(patch).into_iter().enumerate() {
            assert_eq!(cycles(element), waves::cycles_per_tick(omega), "patch {index} element {element}");
        }
    }
}

#[test]
fn the_last_sea_is_drawn_until_the_new_one_is_there() {
    let mut seas = spread();
    settle(&mut seas, &windy(7.0), &deck());
    let fine = Settings { quality: Quality::Ultra, ..windy(15.0) };
    let (mut seen, mut frames) = (Vec::new(), 0);
    while frames == 0 || seas.is_busy() {
        let (frame, work) = frame(&mut seas, &fine, &deck());
        assert!(work.evaluations <= WAVE_WORK + 4 * OVER, "{work:?}");
        let now = (frame.sea.sea.speed_mps, frame.sea.cascades[0].n);
        if seen.last() != Some(&now) {
            seen.push(now);
        }
        // A frame is of one sea.
        assert_eq!(f64::from(frame.uniform.wave_height), f64::from(frame.sea.sea.hs_m as f32));
        frames += 1;
    }
    assert_eq!(seen, [(7.0, 256), (15.0, 256), (15.0, 1024)]);
}

#[test]
fn the_sea_follows_a_hand_that_never_rests() {
    let mut seas = spread();
    settle(&mut seas, &windy(7.0), &deck());
    let mut speeds = Vec::new();
    for step in 0..60 {
        speeds.push(frame(&mut seas, &windy(8.0 + 0.1 * f64::from(step)), &deck()).0.sea.sea.speed_mps);
    }
    speeds.dedup();
    println!("{speeds:?}");
    assert!(speeds.len() > 10, "{speeds:?}");
}

#[test]
fn the_first_guess_of_a_threshold_is_near() {
    for speed in [8.0, 14.0, 20.0] {
        let mut seas = spread();
        settle(&mut seas, &windy(speed), &Camera { altitude_m: 2e7, ..deck() });
        let guess = frame(&mut seas, &windy(speed), &deck()).0.whitecaps.folds;
        settle(&mut seas, &windy(speed), &deck());
        let right = frame(&mut seas, &windy(speed), &deck()).0.whitecaps.folds;
        let off: [f64; LEVELS] = std::array::from_fn(|l| (guess[l].threshold - right[l].threshold) / right[l].softness);
        println!("{speed} m/s: off by {off:.2?} of the ramp");
        assert!(right.iter().all(|fold| *fold != Fold::NEVER) && guess != right);
        // A sixteenth of the points errs by four times as much as all of them.
        assert!(off.iter().all(|off| off.abs() < 0.5), "{speed} m/s: {off:?}");
    }
}

#[test]
fn a_frame_lifts_one_place_and_none_from_far_up() {
    let mut seas = spread();
    let mut ride = |altitude_m: f64| {
        let state = ViewState {
            camera: Camera { altitude_m, ..deck() },
            ride: true,
            settings: windy(16.0),
            ..ViewState::default()
        };
        let before = seas.work().lifted;
        for _ in 0..2 {
            seas.begin(&state.settings);
            let eye = seas.eye(&state, NOON + altitude_m);
            // Low enough to ask whether it is in the water.
            let low = Camera { altitude_m: -0.1, ..eye };
            Frame::of(&mut seas, &state.settings, &low, NOON + altitude_m, [64, 64]);
            assert_ne!(eye.altitude_m == altitude_m, altitude_m < 1e4);
        }
        seas.work().lifted - before
    };
    assert_eq!(ride(2.0), 1);
    assert_eq!(ride(560.0), 1);
    // The frame's question alone.
    assert_eq!(ride(30_000.0), 1);
    let orbit = ViewState {
        camera: Camera { altitude_m: 2e7, ..deck() },
        ride: true,
        settings: windy(16.0),
        ..ViewState::default()
    };
    let before = seas.work();
    let eye = seas.eye(&orbit, NOON);
    Frame::of(&mut seas, &orbit.settings, &eye, NOON, [64, 64]);
    assert_eq!((seas.work().lifted, eye), (before.lifted, orbit.camera));
}

#[test]
fn a_ride_leaves_the_waves_behind_smoothly() {
    let mut seas = Seas::default();
    let settings = windy(16.0);
    let crest_m = seas.tables(&settings).crest_m();
    let mut lift = |crests: f64| {
        let camera = Camera { altitude_m: crests * crest_m, ..deck() };
        seas.lifted(&settings, &camera, 1.0, NOON).altitude_m - camera.altitude_m
    };
    let whole = lift(0.0);
    // Altitudes of some kilometres have 12 digits behind the point.
    assert!(whole.abs() > 0.05 && (lift(999.0) - whole).abs() < 1e-9);
    assert!((lift(1500.0) / whole - 0.5).abs() < 1e-6 && lift(2000.0) == 0.0);
}
