//! Whitecaps: as many as are measured at sea, however the time is cut into frames and wherever the eye has been.

use std::f64::consts::TAU;

use glam::DVec2;
use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture;
use ocean_globe::model::foam::{self, Fold, GROWTH_S, LIFETIME_S};
use ocean_globe::model::sea_state::whitecap_fraction;
use ocean_globe::model::waves::{self, TICKS_PER_SECOND};
use ocean_globe::pass::fft::{Fft, Precision, WaveData};
use ocean_globe::pass::foam::Foam;
use ocean_globe::scene::camera::Camera;
use ocean_globe::scene::foam::{FoamEye, LEVELS, TEXELS, TEXELS_M, Whitecaps};
use ocean_globe::scene::foam_history::History;
use ocean_globe::scene::frame::{Frame, FrameUniform};
use ocean_globe::scene::sea::SeaTables;
use ocean_globe::scene::settings::{self, FoamRule, Settings, Wind};
use ocean_globe::scene::wave_domain;

/// 2026-11-20T12:00:00Z.
const NOON: f64 = 1_795_176_000.0;

fn blown(speed_mps: f64) -> Settings {
    Settings { wind: Wind { speed_mps, from_deg: 250.0 }, ..Settings::default() }
}

fn ticks(seconds: f64) -> u64 {
    (seconds * TICKS_PER_SECOND) as u64
}

fn mean(values: &[f32]) -> f64 {
    values.iter().map(|&x| f64::from(x)).sum::<f64>() / values.len() as f64
}

fn correlation(a: &[f32], b: &[f32]) -> f64 {
    let (ma, mb) = (mean(a), mean(b));
    let product = |a: &[f32], ma: f64, b: &[f32], mb: f64| {
        a.iter().zip(b).map(|(&x, &y)| (f64::from(x) - ma) * (f64::from(y) - mb)).sum::<f64>()
    };
    product(a, ma, b, mb) / (product(a, ma, a, ma) * product(b, mb, b, mb)).sqrt()
}

/// The waves of a sea, and foam maps on them.
struct Sea {
    gpu: Gpu,
    frame: Frame,
    fft: Fft,
    layouts: [wgpu::BindGroupLayout; 2],
    lifetime_s: f64,
}

/// A foam map with the frame that it is made under.
struct Map {
    foam: Foam,
    history: History,
    uniform: wgpu::Buffer,
    frame: wgpu::BindGroup,
    surfaces: [wgpu::BindGroup; 2],
}

impl Sea {
    /// The eye is over the middle of a wave cell.
    fn new(settings: &Settings) -> Self {
        use wgpu::TextureViewDimension::*;
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let cell = wave_domain::cells_near(0.6, -0.5)[0];
        let camera = Camera::from_degrees(cell.lat.to_degrees(), cell.lon.to_degrees(), 10.0, 0.0, 0.0);
        let frame = Frame::new(settings, &camera, NOON, [64, 64]);
        let stages = wgpu::ShaderStages::COMPUTE;
        let layouts = [
            gpu.layout("frame", stages, &[Bind::Uniform, Bind::Uniform, Bind::Sampler, Bind::Sampler]),
            gpu.layout("surface", stages, &[D2Array, D2Array, D2Array, D2, D2].map(Bind::Texture)),
        ];
        let mut fft = Fft::new(&gpu, frame.sea.cascades[0].n, waves::CASCADES, Precision::Half);
        fft.set_waves(&gpu, &frame.sea.cascades, &WaveData::of(&frame.sea));
        Self { gpu, frame, fft, layouts, lifetime_s: settings.foam.lifetime_s }
    }

    fn map(&self, uniform: &FrameUniform) -> Map {
        use wgpu::BufferUsages as B;
        let gpu = &self.gpu;
        let foam = Foam::new(gpu, &self.layouts[0], &self.layouts[1]);
        let uniform = gpu.buffer("frame", B::UNIFORM, bytemuck::bytes_of(uniform));
        let nodes = gpu.buffer("nodes", B::UNIFORM, bytemuck::cast_slice(&self.frame.nodes));
        let clamped = gpu.sampler("clamped", wgpu::AddressMode::ClampToEdge);
        let repeated = gpu.sampler("repeated", wgpu::AddressMode::Repeat);
        let frame = gpu.bind(
            "frame",
            &self.layouts[0],
            &[
                uniform.as_entire_binding(),
                nodes.as_entire_binding(),
                wgpu::BindingResource::Sampler(&clamped),
                wgpu::BindingResource::Sampler(&repeated),
            ],
        );
        let surfaces = foam.maps.each_ref().map(|map| {
            let waves = [&self.fft.displacements, &self.fft.slopes, &self.fft.stretches].map(texture::array_view);
            // No noise is read: its place is taken by the map itself.
            let views = [&waves[0], &waves[1], &waves[2], map, map].map(wgpu::BindingResource::TextureView);
            gpu.bind("surface", &self.layouts[1], &views)
        });
        Map { foam, history: History::default(), uniform, frame, surfaces }
    }

    fn own_map(&self) -> Map {
        self.map(&self.frame.uniform)
    }

    /// Waves at an instant.
    fn run(&self, now: u64) {
        self.fft.set_time(&self.gpu, now);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.fft.dispatch(&mut pass);
            self.fft.dispatch_mips(&mut pass);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Brings a map to an instant whose waves are there.
    fn step(&self, map: &mut Map, now: u64, eye: &FoamEye) {
        map.foam.prepare(&self.gpu, &map.history.step(now, eye, self.lifetime_s));
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            let surface = &map.surfaces[map.foam.current()];
            map.foam.dispatch(&mut pass, &map.frame, surface);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// As a frame does: as many steps as the map asks for. Returns their number.
    fn bring(&self, map: &mut Map, now: u64, eye: &FoamEye) -> usize {
        let mut uniform = self.frame.uniform;
        for (level, square) in uniform.foam_levels.iter_mut().enumerate() {
            (square.texel, square.fraction) = eye.texel(level);
        }
        // The frame's cells stay where its own eye is: the squares are laid out from there.
        let moved = eye.at - self.frame.foam_eye.at;
        for (level, square) in uniform.foam_levels.iter_mut().enumerate() {
            let shift = (moved / TEXELS_M[level]).as_vec2();
            square.fraction = [square.fraction[0] - shift.x, square.fraction[1] - shift.y];
        }
        self.gpu.queue.write_buffer(&map.uniform, 0, bytemuck::bytes_of(&uniform));
        let mut steps = 0;
        while let Some(instant) = map.history.next_instant(now, eye, self.lifetime_s) {
            self.run(instant);
            self.step(map, instant, eye);
            steps += 1;
        }
        steps
    }

    /// Foam of one level of a map, by slot.
    fn foam(&self, map: &Map, level: usize) -> Vec<f32> {
        let bytes = self.gpu.read_texture(&map.foam.textures[map.foam.current()], 0, 0).unwrap();
        bytes.chunks_exact(16).map(|texel| bytemuck::pod_read_unaligned::<[f32; 4]>(texel)[level]).collect()
    }
}

/// The world's texels of a level about an eye, with their slots.
fn texels(eye: &FoamEye, level: usize) -> impl Iterator<Item = ([i32; 2], usize)> + use<> {
    let [x, y] = eye.texel(level).0;
    let half = TEXELS / 2;
    let slot = |x: i32, y: i32| (y.rem_euclid(TEXELS) * TEXELS + x.rem_euclid(TEXELS)) as usize;
    (y - half..y + half).flat_map(move |y| (x - half..x + half).map(move |x| ([x, y], slot(x, y))))
}

#[test]
fn foam_does_not_depend_on_the_frame_rate() {
    // A crest that breaks wholly for half a second, then decay for 4 s, at 60, 30, 15 and 3.75 frames a second.
    let run = |step: &dyn Fn(f64, f64, f64) -> f64, fps: f64| {
        let mut foam = 0.1;
        for frame in 0..(4.5 * fps).round() as usize {
            let breaking = if (frame as f64) < 0.5 * fps - 1e-9 { 1.0 } else { 0.0 };
            foam = step(foam, breaking, 1.0 / fps);
        }
        foam
    };
    let exact = |foam: f64, breaking: f64, dt: f64| foam::evolve(foam, breaking, dt, LIFETIME_S);
    let euler = |foam: f64, breaking: f64, dt: f64| {
        foam + (breaking - foam) * dt / if breaking > foam { GROWTH_S } else { LIFETIME_S }
    };
    // Closed form, and what rates may differ by: rounding.
    let want = (1.0 - 0.9 * (-0.5 / GROWTH_S).exp()) * (-4.0 / LIFETIME_S).exp();
    let spread = |step: &dyn Fn(f64, f64, f64) -> f64| {
        [60.0, 30.0, 16.0, 4.0].map(|fps| (run(step, fps) - want).abs()).into_iter().fold(0.0, f64::max)
    };
    assert!(spread(&exact) < 1e-12);
    assert!(spread(&euler) > 0.01, "the check lets explicit Euler pass");
    // Any cut of a step, and no lifetime at all.
    for (foam, breaking, dt, lifetime) in [(0.9, 0.2, 3.0, 0.5), (0.1, 0.8, 0.7, 60.0), (0.4, 0.4, 1.0, 3.5)] {
        let whole = foam::evolve(foam, breaking, dt, lifetime);
        let halves = foam::evolve(foam::evolve(foam, breaking, 0.3 * dt, lifetime), breaking, 0.7 * dt, lifetime);
        assert!((whole - halves).abs() < 1e-15);
    }
    assert_eq!(foam::relaxed(0.7, 0.2, 0.0, 0.0), 0.2);
    assert_eq!(foam::relaxed(0.7, 0.2, 0.0, 3.5), 0.7);
}

#[test]
fn thresholds_rise_with_the_foam_that_is_wanted() {
    let sea = waves::Sea::from_wind(12.0, 0, 1.0);
    let (spectrum, tiles) = (sea.spectrum(), waves::cascades(256));
    let folds = |wanted| foam::folds(&spectrum, &tiles, 1.0, [0.25, 2.25], [0.2, 1.0], wanted, LIFETIME_S);
    let by_share = [0.001, 0.01, 0.03, 0.1].map(folds);
    for pair in by_share.windows(2) {
        assert!((0..2).all(|level| pair[0][level].threshold < pair[1][level].threshold), "{pair:?}");
    }
    assert_eq!(folds(0.0), [Fold::NEVER; 2]);
    // Foam that lives longer needs fewer crests that break.
    let long = foam::folds(&spectrum, &tiles, 1.0, [0.25, 2.25], [0.2, 1.0], 0.03, 10.0);
    assert!((0..2).all(|level| long[level].threshold < by_share[2][level].threshold));
}

#[test]
fn foam_on_high_water_covers_the_share_that_is_wanted() {
    for speed in [8.0, 14.0, 20.0] {
        let foam = settings::Foam { rule: FoamRule::Height, ..settings::Foam::default() };
        let sea = SeaTables::new(waves::Sea::from_wind(speed, 0, 1.0), 128);
        let whitecaps = Whitecaps::new(foam, &sea);
        let deviation = sea.sea.hs_m / 4.0;
        let [from, to] = whitecaps.heights_m;
        // The ramp's mean over a Gaussian height: midpoints of 1/1000 deviation err by 1e-7.
        let share: f64 = (-8000..8000)
            .map(|i| (f64::from(i) + 0.5) / 1000.0)
            .map(|x| {
                ((x * deviation - from) / (to - from)).clamp(0.0, 1.0) * (-0.5 * x * x).exp() / TAU.sqrt() / 1000.0
            })
            .sum();
        println!("{speed} m/s: {share:.5} of {:.5}", whitecap_fraction(speed));
        assert!((share / whitecap_fraction(speed) - 1.0).abs() < 1e-3, "{speed} m/s: {share}");
        assert_eq!(whitecaps.folds, [Fold::NEVER; LEVELS]);
        // Beyond the map: a log-normal share of the height, whose mean does not depend on its contrast.
        for contrast in [0.0f64, 0.4, 0.8] {
            let mean: f64 = (-8000..8000)
                .map(|i| (f64::from(i) + 0.5) / 1000.0)
                .map(|x| {
                    let share = whitecaps.share * (contrast * x - 0.5 * contrast * contrast).exp();
                    share.min(1.0) * (-0.5 * x * x).exp() / TAU.sqrt() / 1000.0
                })
                .sum();
            // What the cap at 1 takes from the tail.
            assert!((mean / whitecaps.share - 1.0).abs() < 0.02, "{speed} m/s {contrast}: {mean}");
        }
    }
}

/// Mean foam of each level under a wind, over places and instants.
fn coverage(settings: &Settings) -> [f64; LEVELS] {
    let sea = Sea::new(settings);
    let uniform = sea.frame.uniform;
    // The finest square is smaller than a long wave: it is looked at in four places, laid out by their fractions, the second in two.
    let elsewhere = |levels: [usize; 4], first: usize| {
        let mut elsewhere = uniform;
        for (index, square) in elsewhere.foam_levels.iter_mut().enumerate() {
            *square = uniform.foam_levels[levels[index]];
            let turn = 2.4 * (first + index) as f64;
            let out = 350.0 + 300.0 * (first + index) as f64;
            square.fraction[0] -= (out * turn.cos() / TEXELS_M[levels[index]]) as f32;
            square.fraction[1] -= (out * turn.sin() / TEXELS_M[levels[index]]) as f32;
        }
        elsewhere
    };
    let mut maps = [elsewhere([0; 4], 0), elsewhere([1, 1, 2, 3], 4)].map(|uniform| sea.map(&uniform));
    let levels = [[0; 4], [1, 1, 2, 3]];
    let (mut sums, mut counts) = ([0.0; LEVELS], [0.0; LEVELS]);
    let start = waves::ticks_from_unix(NOON);
    // Two and a half lifetimes to forget all but a twelfth of the beginning, then instants two seconds apart.
    let settled = (2.5 * settings.foam.lifetime_s / 0.125) as u64;
    for index in 0..settled + 80 {
        let now = start + index * ticks(0.125);
        sea.run(now);
        for (map, levels) in maps.iter_mut().zip(levels) {
            sea.step(map, now, &sea.frame.foam_eye);
            if index >= settled && index % 16 == 0 {
                for (channel, level) in levels.into_iter().enumerate() {
                    sums[level] += mean(&sea.foam(map, channel));
                    counts[level] += 1.0;
                }
            }
        }
    }
    std::array::from_fn(|level| sums[level] / counts[level])
}

fn check_coverage(speed: f64) {
    let settings = blown(speed);
    let start = std::time::Instant::now();
    let found = coverage(&settings);
    let want = whitecap_fraction(speed);
    let whitecaps = Whitecaps::new(settings.foam, &SeaTables::of(&settings));
    println!(
        "{speed} m/s: {want:.4}: {:.2?} of it, {:?}, {:.1} s",
        found.map(|f| f / want),
        whitecaps.folds,
        start.elapsed().as_secs_f64()
    );
    for (level, found) in found.into_iter().enumerate() {
        if whitecaps.folds[level] != Fold::NEVER {
            assert!(found > want / 1.5 && found < want * 1.5, "{speed} m/s level {level}: {found} of {want}");
        }
    }
}

#[test]
fn whitecaps_cover_what_is_measured_at_8_mps() {
    check_coverage(8.0);
}

#[test]
fn whitecaps_cover_what_is_measured_at_12_mps() {
    check_coverage(12.0);
}

#[test]
fn whitecaps_cover_what_is_measured_at_16_mps() {
    check_coverage(16.0);
}

#[test]
fn whitecaps_cover_what_is_measured_at_20_mps() {
    check_coverage(20.0);
}

#[test]
fn long_lived_foam_covers_no_more_since_fewer_crests_break() {
    let foam = settings::Foam { lifetime_s: 10.0, ..settings::Foam::default() };
    let found = coverage(&Settings { foam, ..blown(16.0) });
    let want = whitecap_fraction(16.0);
    println!("10 s: {:.2?} of {want:.4}", found.map(|f| f / want));
    assert!(found.into_iter().all(|found| found > want / 1.5 && found < want * 1.5), "{found:?} of {want}");
}

#[test]
fn foam_that_no_crest_renews_decays_with_its_lifetime() {
    let sea = Sea::new(&blown(16.0));
    let mut map = sea.own_map();
    let (start, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    sea.bring(&mut map, start, &eye);
    let before = sea.foam(&map, 1);
    let mut calm = sea.frame.uniform;
    for square in &mut calm.foam_levels {
        square.threshold = -1e3;
    }
    sea.gpu.queue.write_buffer(&map.uniform, 0, bytemuck::bytes_of(&calm));
    sea.step(&mut map, start + ticks(0.7), &eye);
    sea.step(&mut map, start + ticks(2.0), &eye);
    let after = sea.foam(&map, 1);
    let want = (-2.0 / sea.lifetime_s).exp();
    let mut seen = 0;
    for (before, after) in before.into_iter().zip(after).filter(|(before, _)| *before > 0.01) {
        seen += 1;
        // Two values of 11 bits, cut off or rounded.
        let ratio = f64::from(after / before);
        assert!((ratio / want - 1.0).abs() < 2.0 * 2f64.powi(-10), "{before} to {after}: {ratio} of {want}");
    }
    assert!(seen > 1000, "{seen} texels had foam");
}

#[test]
fn frames_of_60_and_of_15_a_second_make_the_same_foam() {
    let sea = Sea::new(&blown(16.0));
    let (start, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let mut maps = [sea.own_map(), sea.own_map()];
    let begun = start - ticks(1.0);
    for map in &mut maps {
        sea.bring(map, begun, &eye);
    }
    // Two seconds: whatever is white has been born or has grown old meanwhile.
    for frame in 1..=120u64 {
        let now = begun + frame * ticks(1.0) / 60;
        sea.run(now);
        sea.step(&mut maps[0], now, &eye);
        if frame % 4 == 0 {
            sea.step(&mut maps[1], now, &eye);
        }
    }
    for level in 0..LEVELS {
        let [fast, slow] = [0, 1].map(|map| sea.foam(&maps[map], level));
        let (difference, alike) = (mean(&slow) / mean(&fast) - 1.0, correlation(&fast, &slow));
        println!("level {level}: {:+.2} %, correlation {alike:.4}", 100.0 * difference);
        assert!(difference.abs() < 0.05, "level {level}: {difference}");
        assert!(alike > 0.97, "level {level}: {alike}");
    }
}

#[test]
fn foam_stays_where_it_is_when_the_eye_moves() {
    let sea = Sea::new(&blown(16.0));
    let (now, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let mut map = sea.own_map();
    sea.bring(&mut map, now, &eye);
    let start: Vec<Vec<f32>> = (0..LEVELS).map(|level| sea.foam(&map, level)).collect();
    // 10 m sideways, then forth and back to the same place another way.
    let moved = |x: f64, y: f64| FoamEye { at: eye.at + DVec2::new(x, y), ..eye };
    let mut last = eye;
    for stop in [moved(0.0, 10.0), moved(7.3, 10.0), moved(7.3, -3.0), moved(0.0, 10.0)] {
        assert_eq!(sea.bring(&mut map, now, &stop), 1, "time stands still: one step that takes no time");
        last = stop;
    }
    for (level, start) in start.iter().enumerate() {
        let here = sea.foam(&map, level);
        // What every square on the way has held.
        let reach = |at: &FoamEye, [x, y]: [i32; 2]| {
            let [ex, ey] = at.texel(level).0;
            (-TEXELS / 2..TEXELS / 2).contains(&(x - ex)) && (-TEXELS / 2..TEXELS / 2).contains(&(y - ey))
        };
        let stops = [eye, moved(0.0, 10.0), moved(7.3, 10.0), moved(7.3, -3.0)];
        let (mut known, mut foamy, mut fresh) = (0, 0, 0);
        for (world, slot) in texels(&last, level) {
            if stops.iter().all(|stop| reach(stop, world)) {
                known += 1;
                foamy += usize::from(start[slot] > 0.1);
                // Steps without time leave each value, but for a rounding to 11 bits in each of four.
                let error = (here[slot] - start[slot]).abs();
                assert!(
                    error <= 4.0 * 2f32.powi(-10) * start[slot],
                    "level {level} {world:?}: {} was {}",
                    here[slot],
                    start[slot]
                );
            } else {
                fresh += 1;
            }
        }
        println!("level {level}: {known} texels known, {foamy} white, {fresh} new");
        assert!(known > 40_000 && foamy > 500, "level {level}: {known}, {foamy}");
        assert!(fresh > 0, "level {level}: the eye has moved");
    }
}

#[test]
fn a_replay_makes_the_foam_that_time_would_have_made() {
    let sea = Sea::new(&blown(16.0));
    let (now, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let all = |map: &Map| -> Vec<Vec<f32>> { (0..LEVELS).map(|level| sea.foam(map, level)).collect() };
    let mut map = sea.own_map();
    let steps = sea.bring(&mut map, now, &eye);
    let replayed = all(&map);
    // Again, on a map of its own: to the last bit.
    let mut again = sea.own_map();
    assert_eq!(sea.bring(&mut again, now, &eye), steps);
    assert!(all(&again) == replayed, "two replays differ");
    // A jump of an hour and back: no history is left, so it is rebuilt.
    assert!(sea.bring(&mut again, now + ticks(3600.0), &eye) > 10);
    let later = all(&again);
    assert!(sea.bring(&mut again, now, &eye) > 10);
    assert!(all(&again) == replayed, "a jump leaves traces");
    // In frames of 1/8 s, from further back than a replay goes.
    let mut run = sea.own_map();
    for frame in (0..=120u64).rev() {
        let instant = now - frame * ticks(0.125);
        sea.run(instant);
        sea.step(&mut run, instant, &eye);
    }
    for (level, (run, replayed)) in all(&run).iter().zip(&replayed).enumerate() {
        let (difference, alike) = (mean(replayed) / mean(run) - 1.0, correlation(run, replayed));
        let other = correlation(&later[level], replayed);
        println!(
            "level {level}: {:+.1} %, correlation {alike:.3}, with another hour's {other:.3}; {steps} steps",
            100.0 * difference
        );
        // It forgets e⁻³ = 5 %. Its steps of 1/4 s meet by chance the crests of level 0, which break for some 0.15 s: two in five are
        // missed, the others count more, and half as much again where crests break longer than that.
        assert!(difference.abs() < 0.12, "level {level}: {difference}");
        assert!(alike > if level == 0 { 0.85 } else { 0.95 }, "level {level}: {alike}");
        assert!(other.abs() < 0.3, "level {level}: foam of another hour correlates by {other}");
    }
}
