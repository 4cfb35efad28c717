//! How much work a picture may be, so that the eye's moves are answered at once on any machine.
//!
//! While something moves, a picture of `quality=auto` may be coarser than the screen: each `RUNGS` entry says by how much, and the time
//! that the device took for the last pictures says which one serves. At rest every picture is drawn in full, so that a link shows the
//! same everywhere. A quality that the user has chosen is kept as it is.

use crate::scene::settings::Quality;

/// What one picture is made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Pixels of the picture along a pixel of the canvas, over 0 to 1.
    pub scale: f64,
    /// Quality that gives the wave patches their samples and the grid its cells.
    pub quality: Quality,
    /// Least width of a cell of the projected grid, pixels of the picture; 0: the quality's own.
    pub cell_pixels: u32,
}

/// What moves in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Nothing: this picture stays for a while.
    Rest,
    /// Nothing but what is still to come: map tiles, the foam's past.
    Settling,
    /// The eye or the water.
    Moving,
}

/// The efforts of `quality=auto`, the best first: render scale, wave samples (256 and 128), width of a cell.
const RUNGS: [(f64, Quality, u32); 6] = [
    (1.0, Quality::Auto, 0),
    (0.8, Quality::Auto, 0),
    (0.63, Quality::Auto, 0),
    (0.5, Quality::Auto, 0),
    (0.4, Quality::Auto, 6),
    (0.4, Quality::Low, 8),
];
/// The last of them that a machine begins with: those with other waves are for what proves too slow.
const LAST_FIRST: usize = 4;
/// Pictures on a rung before the next change for the worse and for the better: who waits for a picture must not wait for more of them, and
/// a better one has time.
const PATIENCE: [u32; 2] = [1, 8];
/// Weight of the latest picture in the smoothed time.
const WEIGHT: f64 = 0.4;

/// The kind of machine, as far as it matters here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adapter {
    /// A processor stands in for the graphics card.
    Software,
    /// A graphics card, or nobody knows.
    Hardware,
}

impl Adapter {
    /// Time that a moving picture shall take, milliseconds: 40 pictures a second of a graphics card, and more than 4 of a processor, which
    /// also has to paint the panel.
    fn target_ms(self) -> f64 {
        match self {
            Self::Hardware => 25.0,
            Self::Software => 150.0,
        }
    }

    /// Physical pixels per point of the screen beyond which a moving picture is no better to the eye.
    fn finest_ratio(self) -> f64 {
        match self {
            Self::Hardware => 2.0,
            Self::Software => 1.0,
        }
    }

    /// Pixels of a moving picture that such a machine may be expected to draw in time, before anything has been measured.
    fn expected_pixels(self) -> f64 {
        match self {
            Self::Hardware => 4e6,
            Self::Software => 5e4,
        }
    }
}

/// The rung that a canvas begins with: the best one whose pictures have no more pixels than the machine is expected to draw in time.
fn first_rung(adapter: Adapter, canvas: [u32; 2], pixels_per_point: f64) -> usize {
    let fits = |&rung: &usize| pixels(rung, adapter, canvas, pixels_per_point) <= adapter.expected_pixels();
    (0..LAST_FIRST).find(fits).unwrap_or(LAST_FIRST)
}

fn scale(rung: usize, adapter: Adapter, pixels_per_point: f64) -> f64 {
    RUNGS[rung].0 * (adapter.finest_ratio() / pixels_per_point).min(1.0)
}

fn pixels(rung: usize, adapter: Adapter, canvas: [u32; 2], pixels_per_point: f64) -> f64 {
    f64::from(canvas[0]) * f64::from(canvas[1]) * scale(rung, adapter, pixels_per_point).powi(2)
}

/// A picture's work on a rung, as a share of the full one's: its pixels and its waves.
fn work(rung: usize) -> f64 {
    RUNGS[rung].0.powi(2) * if RUNGS[rung].1 == Quality::Low { 0.7 } else { 1.0 }
}

/// The rung after one whose pictures take `ms`. Down where they take a quarter too long, as far as it may need if time went with work; up
/// by one, only where the better ones, whose time grows at most with their work, would be a quarter quicker than they must: what goes
/// up does not come down again.
fn next_rung(rung: usize, adapter: Adapter, ms: f64) -> usize {
    let target_ms = adapter.target_ms();
    let predicted_ms = |other: usize| ms * work(other) / work(rung);
    if ms > 1.25 * target_ms {
        let last = RUNGS.len() - 1;
        return (rung + 1..last).find(|&worse| predicted_ms(worse) < target_ms).unwrap_or(last);
    }
    rung.checked_sub(1).filter(|&better| predicted_ms(better) < 0.75 * target_ms).unwrap_or(rung)
}

/// The best rung that may draw in time on a machine whose full pictures take `ms`.
fn rung_for_full(adapter: Adapter, ms: f64) -> usize {
    let last = RUNGS.len() - 1;
    (0..last).find(|&rung| ms * work(rung) < adapter.target_ms()).unwrap_or(last)
}

/// The effort of moving pictures, as it has turned out so far.
#[derive(Clone, Debug)]
pub struct Pace {
    adapter: Adapter,
    rung: Option<usize>,
    /// Smoothed time of pictures on this rung, milliseconds.
    ms: f64,
    /// Pictures on this rung.
    count: u32,
}

impl Pace {
    /// Nothing measured yet.
    pub fn new(adapter: Adapter) -> Self {
        Self { adapter, rung: None, ms: 0.0, count: 0 }
    }

    /// The effort of the next picture of a canvas of so many physical pixels.
    pub fn effort(&mut self, quality: Quality, motion: Motion, canvas: [u32; 2], pixels_per_point: f64) -> Effort {
        let rung = *self.rung.get_or_insert_with(|| first_rung(self.adapter, canvas, pixels_per_point));
        if quality != Quality::Auto || motion == Motion::Rest {
            return Effort { scale: 1.0, quality, cell_pixels: 0 };
        }
        let (_, samples, cell_pixels) = RUNGS[rung];
        // The foam's past is that of the full picture's waves.
        let quality = if motion == Motion::Settling { quality } else { samples };
        Effort { scale: scale(rung, self.adapter, pixels_per_point), quality, cell_pixels }
    }

    /// Takes in what a processor took for a picture at rest, milliseconds: where that was long, the next move begins coarse. A graphics
    /// card finds its effort in a moment.
    pub fn measured_full(&mut self, ms: f64) {
        let Some(rung) = self.rung.filter(|_| self.adapter == Adapter::Software) else { return };
        let needed = rung_for_full(self.adapter, ms);
        if needed > rung {
            (self.rung, self.count) = (Some(needed), 0);
        }
    }

    /// Takes in what the device took for a moving picture, milliseconds.
    pub fn measured(&mut self, ms: f64) {
        let Some(rung) = self.rung else { return };
        // The first picture of a rung pays for its textures, and of the program for its pipelines.
        self.count += 1;
        match self.count {
            1 => return,
            2 => self.ms = ms,
            _ => self.ms += (ms - self.ms) * WEIGHT,
        }
        let next = next_rung(rung, self.adapter, self.ms);
        if next != rung && self.count > PATIENCE[usize::from(next < rung)] {
            (self.rung, self.count) = (Some(next), 0);
        }
    }
}

/// The size of a picture of `canvas` at a scale, pixels.
pub fn scaled(canvas: [u32; 2], scale: f64) -> [u32; 2] {
    canvas.map(|side| ((f64::from(side) * scale).round() as u32).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CANVAS: [u32; 2] = [1280, 720];

    /// The scale after many pictures on a machine that takes `fixed_ms` and `ms` for a full picture's pixels, and how often it changed in
    /// the second half.
    fn settled(adapter: Adapter, fixed_ms: f64, ms: f64) -> (Effort, usize) {
        let mut pace = Pace::new(adapter);
        let mut efforts = Vec::new();
        for picture in 0..200 {
            let effort = pace.effort(Quality::Auto, Motion::Moving, CANVAS, 1.0);
            // Every fifth picture is half as slow again.
            let noise = if picture % 5 == 0 { 1.5 } else { 1.0 };
            pace.measured(noise * (fixed_ms + ms * effort.scale.powi(2)));
            efforts.push(effort);
        }
        let late = &efforts[100..];
        (efforts[199], late.windows(2).filter(|pair| pair[0] != pair[1]).count())
    }

    #[test]
    fn at_rest_every_machine_draws_in_full() {
        for adapter in [Adapter::Software, Adapter::Hardware] {
            let mut pace = Pace::new(adapter);
            for _ in 0..50 {
                pace.effort(Quality::Auto, Motion::Moving, CANVAS, 3.0);
                pace.measured(1e4);
            }
            let effort = pace.effort(Quality::Auto, Motion::Rest, CANVAS, 3.0);
            assert_eq!(effort, Effort { scale: 1.0, quality: Quality::Auto, cell_pixels: 0 });
        }
    }

    #[test]
    fn a_chosen_quality_is_kept_however_long_it_takes() {
        let mut pace = Pace::new(Adapter::Software);
        for _ in 0..50 {
            let effort = pace.effort(Quality::Ultra, Motion::Moving, CANVAS, 2.0);
            assert_eq!(effort, Effort { scale: 1.0, quality: Quality::Ultra, cell_pixels: 0 });
            pace.measured(1e4);
        }
    }

    #[test]
    fn a_fast_card_draws_moving_pictures_in_full_and_a_slow_one_coarser_ones() {
        assert_eq!(settled(Adapter::Hardware, 1.0, 4.0).0.scale, 1.0);
        // 25 ms of 60 for the pixels: between 0.5 and 0.65 of a side.
        let (effort, _) = settled(Adapter::Hardware, 4.0, 60.0);
        assert!((0.5..0.65).contains(&effort.scale) && effort.quality == Quality::Auto, "{effort:?}");
        let (effort, _) = settled(Adapter::Hardware, 60.0, 600.0);
        assert_eq!((effort.scale, effort.quality), (0.4, Quality::Low));
    }

    #[test]
    fn a_picture_does_not_flicker_between_two_efforts() {
        for adapter in [Adapter::Software, Adapter::Hardware] {
            for step in 0..60 {
                let ms = 1.15f64.powi(step);
                for fixed in [0.0, 0.2, 1.0] {
                    let (effort, changes) = settled(adapter, fixed * ms, ms);
                    assert_eq!(changes, 0, "{adapter:?}, {ms} ms and {fixed} of it fixed: {effort:?}");
                }
            }
        }
    }

    #[test]
    fn a_move_after_a_slow_full_picture_begins_coarse_and_finds_its_effort() {
        let mut pace = Pace::new(Adapter::Software);
        pace.effort(Quality::Auto, Motion::Settling, CANVAS, 1.0);
        pace.measured_full(5_000.0);
        let effort = pace.effort(Quality::Auto, Motion::Moving, CANVAS, 1.0);
        assert_eq!((effort.scale, effort.quality), (0.4, Quality::Low));
        // It was slow for another reason: moving pictures are quick.
        (0..100).for_each(|_| pace.measured(20.0));
        assert_eq!(pace.effort(Quality::Auto, Motion::Moving, CANVAS, 1.0).scale, 1.0);
        // A quick full picture changes nothing.
        pace.measured_full(30.0);
        assert_eq!(pace.effort(Quality::Auto, Motion::Moving, CANVAS, 1.0).scale, 1.0);
    }

    #[test]
    fn a_processor_begins_coarse_and_a_card_in_full() {
        let first =
            |adapter, canvas, ratio| Pace::new(adapter).effort(Quality::Auto, Motion::Moving, canvas, ratio).scale;
        assert_eq!(first(Adapter::Software, CANVAS, 1.0), 0.4);
        assert!(first(Adapter::Software, [320, 180], 1.0) > 0.7);
        assert_eq!(first(Adapter::Hardware, CANVAS, 1.0), 1.0);
        assert!(first(Adapter::Hardware, [7680, 4320], 1.0) < 0.5);
    }

    #[test]
    fn a_moving_picture_has_no_more_pixels_than_the_eye_can_follow() {
        // A telephone with three pixels to a point draws two while it moves.
        let mut pace = Pace::new(Adapter::Hardware);
        let effort = pace.effort(Quality::Auto, Motion::Moving, [1170, 2532], 3.0);
        assert!((effort.scale - 2.0 / 3.0).abs() < 1e-12, "{effort:?}");
        assert_eq!(scaled([1170, 2532], effort.scale), [780, 1688]);
    }
}
