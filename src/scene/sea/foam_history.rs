//! How the foam map comes to an instant: by one step from the last frame, or by a replay.
//!
//! What has a history must be told how to begin: after a load, a jump in time or place, or a new wind, the foam is rebuilt by
//! replaying three lifetimes of the sea at instants that depend on UTC alone, so that a still picture has the same foam
//! everywhere.
//!
//! An eye that comes down asks for finer levels. A moving picture fills them from the coarser ones, and time does the rest: a replay would
//! show the foam of past instants for as long as it takes. Where time stands still the replay is made once the picture is at rest.

use bytemuck::{Pod, Zeroable};

use crate::model::foam;
use crate::model::waves::TICKS_PER_SECOND;
use crate::scene::sea::foam::{FoamEye, LEVELS, TEXELS, TEXELS_M};

/// Lifetimes that a replay goes back: e⁻³ is 5 %.
const LIFETIMES: u64 = 3;
/// Steps shorter than this are saved up, s: no eye sees them.
const SHORTEST_STEP_S: f64 = 1.0 / 120.0;

/// One step of the foam map; mirrors `FoamStep` in `shaders/foam.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct FoamStep {
    pub previous: [[i32; 4]; LEVELS],
    pub grow: [f32; LEVELS],
    pub keep: [f32; LEVELS],
    pub keep_young: [f32; LEVELS],
    pub empty: u32,
    pub cells: u32,
    pub due: u32,
    pub unused: u32,
}

/// Up to when the map and each of its levels are right, and where the eye was then.
#[derive(Clone, Copy, Debug)]
struct State {
    ticks: u64,
    levels: [u64; LEVELS],
    eye: FoamEye,
    empty: bool,
    /// Since when the finest level has a history of its own, if it was filled from a coarser one.
    filled: Option<u64>,
    /// On its way through the past: then no step may be longer than the replay's.
    replaying: bool,
}

impl State {
    /// Nothing is known yet.
    fn empty(ticks: u64, eye: &FoamEye) -> Self {
        Self { ticks, levels: [ticks; LEVELS], eye: *eye, empty: true, filled: None, replaying: false }
    }

    /// Whether a level still holds foam that it was filled with.
    fn is_filled(&self, lifetime_s: f64) -> bool {
        self.filled.is_some_and(|since| self.ticks.wrapping_sub(since) < replay_span(lifetime_s))
    }
}

/// What the foam map has been through.
#[derive(Debug, Default)]
pub struct History {
    state: Option<State>,
}

impl History {
    /// Forgets it all: the next frame starts a replay.
    pub fn reset(&mut self) {
        self.state = None;
    }

    /// The instant up to which a map that is to show `ticks` must be brought next, and None when it shows them already. The first
    /// of a replay has no history; a step from a recent state leads straight to `ticks`. `moving`: more frames follow this one.
    pub fn next_instant(&mut self, ticks: u64, eye: &FoamEye, lifetime_s: f64, moving: bool) -> Option<u64> {
        let usable = |state: &State| {
            let age = ticks.wrapping_sub(state.ticks);
            // Half of the widest level: nothing that the map knows would be left in the finer ones.
            let near = state.eye.at.distance(eye.at) < 0.25 * f64::from(TEXELS) * TEXELS_M[LEVELS - 1];
            let fine = moving || (state.eye.finest <= eye.finest && !(age == 0 && state.is_filled(lifetime_s)));
            age <= 2 * replay_span(lifetime_s) && state.eye.frame == eye.frame && near && fine
        };
        let Some(state) = self.state.filter(usable) else {
            let ticks = replay_start(ticks, lifetime_s);
            self.state = Some(State { replaying: true, ..State::empty(ticks, eye) });
            return Some(ticks);
        };
        let age = ticks.wrapping_sub(state.ticks);
        let seconds = age as f64 / TICKS_PER_SECOND;
        if state.empty {
            return Some(state.ticks);
        }
        // Saved up, unless the eye has moved on to texels that the map does not know.
        let is_known = state.eye.finest <= eye.finest && state.eye.has_same_texels(eye);
        if seconds < SHORTEST_STEP_S && (age == 0 || is_known) {
            return (!is_known).then_some(ticks);
        }
        // A picture that follows the last one late, on a slow machine, is a step all the same.
        let straight = !state.replaying && seconds <= 0.5 * lifetime_s;
        let next = if straight { ticks } else { replay_next(state.ticks, ticks, lifetime_s) };
        self.state = Some(State { replaying: next != ticks, ..state });
        Some(next)
    }

    /// The step that brings the map to `ticks` with the eye at `eye`; it counts as made.
    /// `breaking_m` as of [`Whitecaps`](crate::scene::sea::foam::Whitecaps).
    pub fn step(&mut self, ticks: u64, eye: &FoamEye, lifetime_s: f64, breaking_m: &[f64; LEVELS]) -> FoamStep {
        let last = self.state.unwrap_or(State::empty(ticks, eye));
        let on_the_way = last.replaying && !last.empty;
        let due: [bool; LEVELS] = std::array::from_fn(|level| {
            level >= eye.finest && (!on_the_way || ticks.is_multiple_of(replay_stride(level, lifetime_s)))
        });
        let dt_s = |level: usize| ticks.wrapping_sub(last.levels[level.max(last.eye.finest)]) as f64 / TICKS_PER_SECOND;
        let passes = |level: usize| last.empty || (due[level] && dt_s(level) > 0.0);
        // A level that is not due stays as it is.
        let each = |left: &dyn Fn(usize) -> f64| std::array::from_fn(|l| if due[l] { left(l) as f32 } else { 1.0 });
        let levels = std::array::from_fn(|level| if due[level] || last.empty { ticks } else { last.levels[level] });
        let filled = if eye.finest < last.eye.finest { Some(ticks) } else { last.filled };
        self.state = Some(State { ticks, levels, eye: *eye, empty: false, filled, ..last });
        FoamStep {
            previous: std::array::from_fn(|level| {
                let ([x, y], _) = last.eye.texel(level);
                [x, y, i32::from(level < last.eye.finest), 0]
            }),
            // The first instant of a replay has no time before it: crests that break then count as white.
            grow: if last.empty { [0.0; LEVELS] } else { each(&|level| foam::ungrown(breaking_m[level], dt_s(level))) },
            keep: each(&|level| (-dt_s(level) / lifetime_s).exp()),
            keep_young: each(&|level| (-dt_s(level) / foam::young_s(lifetime_s)).exp()),
            empty: u32::from(last.empty),
            cells: eye.cells,
            due: (0..LEVELS).filter(|&level| passes(level)).map(|level| 1 << level).sum(),
            ..FoamStep::default()
        }
    }
}

/// Distance of a replay's instants late, in the middle and early in it, ticks: powers of two, so that they lie at the same instants
/// of UTC for everyone. A quarter of a second late in it, for a lifetime of 3.5 s: a crest that breaks for less than that is caught by
/// chance, and the share that it covers is right in the mean.
fn replay_steps(lifetime_s: f64) -> [u64; 3] {
    let late = 1 << (lifetime_s / 14.0 * TICKS_PER_SECOND).max(1.0).log2().round() as u64;
    [late, 2 * late, 4 * late]
}

/// A level is brought up to date at multiples of so many ticks on the way of a replay: coarse ones hold long waves alone, which take
/// their time.
fn replay_stride(level: usize, lifetime_s: f64) -> u64 {
    replay_steps(lifetime_s)[(level / 2).min(1)]
}

/// How far back a replay to an instant goes, ticks.
fn replay_span(lifetime_s: f64) -> u64 {
    LIFETIMES * (lifetime_s * TICKS_PER_SECOND) as u64
}

/// The first instant of a replay to `ticks`.
fn replay_start(ticks: u64, lifetime_s: f64) -> u64 {
    let step = replay_steps(lifetime_s)[2];
    ticks.wrapping_sub(replay_span(lifetime_s)) / step * step
}

/// The instant that follows `from` in a replay to `to`: the next multiple of the step that its age asks for, at most `to`.
fn replay_next(from: u64, to: u64, lifetime_s: f64) -> u64 {
    let age = to.wrapping_sub(from);
    let lifetime = replay_span(lifetime_s) / LIFETIMES;
    let step = replay_steps(lifetime_s)[(age.saturating_sub(1) / lifetime.max(1)).min(2) as usize];
    let next = (from / step).wrapping_add(1).wrapping_mul(step);
    if to.wrapping_sub(next) < age { next } else { to }
}
