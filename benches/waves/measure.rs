//! Times that can be compared: frames back to back to completion, contenders in turns.

use std::time::Instant;

use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::timing::Timer;

/// Frames of a measurement at most.
const MOST_FRAMES: u32 = 200;
/// Submissions whose timestamps are read.
const TIMED: usize = 5;

/// What a contender records into a frame's compute pass.
pub type Work<'a> = &'a dyn Fn(&mut wgpu::ComputePass);

pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

pub fn finish(gpu: &Gpu) {
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device answers");
}

/// Records and submits one frame of one pass.
pub fn submit(gpu: &Gpu, work: Work) {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    work(&mut encoder.begin_compute_pass(&Default::default()));
    gpu.queue.submit([encoder.finish()]);
}

/// Milliseconds per frame of as many frames as fit into some `budget_s`, submitted back to back, to the last one's completion.
pub fn wall_ms(gpu: &Gpu, budget_s: f64, work: Work) -> f64 {
    let frames = |count: u32| {
        let start = Instant::now();
        (0..count).for_each(|_| submit(gpu, work));
        finish(gpu);
        start.elapsed().as_secs_f64() * 1e3 / f64::from(count)
    };
    // The first warms up, the second says how many fit.
    frames(1);
    let one = frames(1);
    let count = (budget_s * 1e3 / one) as u32;
    if count < 2 { one } else { frames(count.min(MOST_FRAMES)) }
}

/// Milliseconds of each of some passes by the device's own clock, the median of five frames; None where it gives none.
pub fn pass_ms(gpu: &Gpu, passes: &[Work]) -> Vec<Option<f64>> {
    let Some(timer) = Timer::new(gpu, passes.len() as u32) else { return vec![None; passes.len()] };
    let once = || {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        for (index, work) in (0..).zip(passes) {
            let timestamp_writes = Some(timer.writes(index));
            work(&mut encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: None, timestamp_writes }));
        }
        timer.resolve(&mut encoder);
        gpu.queue.submit([encoder.finish()]);
        timer.read(gpu).expect("the device answers")
    };
    let rounds: Vec<_> = (0..TIMED).map(|_| once()).collect();
    (0..passes.len())
        .map(|pass| {
            let times: Option<Vec<f64>> = rounds.iter().map(|round| round[pass]).collect();
            times.map(median)
        })
        .collect()
}

/// The time of `b` over that of `a`, once per round A B B A: median, least and greatest.
pub fn ratio(rounds: usize, a: &mut dyn FnMut() -> f64, b: &mut dyn FnMut() -> f64) -> [f64; 3] {
    let round = || {
        let (first, second, third, fourth) = (a(), b(), b(), a());
        (second + third) / (first + fourth)
    };
    let ratios: Vec<f64> = std::iter::repeat_with(round).take(rounds).collect();
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = ratios.iter().copied().fold(0.0, f64::max);
    [median(ratios), least, greatest]
}

/// A number, or what is to be said where there is none.
pub fn shown(value: Option<f64>) -> String {
    value.map_or("not measured".into(), |ms| format!("{ms:.3}"))
}

/// Asserts that the root mean square of an error, over that of what is wanted, is below `most`.
pub fn assert_close(what: &str, got: &[f64], want: &[f64], most: f64) {
    assert_eq!(got.len(), want.len(), "{what}");
    let power = |x: &mut dyn Iterator<Item = f64>| x.map(|x| x * x).sum::<f64>();
    let error = power(&mut got.iter().zip(want).map(|(a, b)| a - b)) / power(&mut want.iter().copied());
    assert!(error.sqrt() < most, "{what}: error over RMS {:e}, allowed {most:e}", error.sqrt());
}
