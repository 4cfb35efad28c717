//! Where foam is born on the sea whose foam map is drawn: thresholds that take a simulation, made at once or a part a frame.

use std::sync::Arc;

use crate::model::foam::{Fold, POINTS, Simulation};
use crate::model::sea_tables::SeaTables;
use crate::scene::sea::foam::{LEVELS, breaking_m, softness};

/// Points that are simulated in a frame; the first guess is made from so many. Its thresholds miss the wanted share by a third at most.
pub const POINTS_A_FRAME: usize = POINTS / 16;

/// The thresholds of the last sea.
#[derive(Default)]
pub struct Thresholds {
    simulated: Option<(Arc<SeaTables>, Simulation<LEVELS>)>,
    /// Chop, share, lifetime in seconds; `None` while no map is drawn.
    wanted: Option<[f64; 3]>,
    guess: [Option<Fold>; LEVELS],
    /// Those of the first levels, by all points.
    found: Vec<Fold>,
}

impl Thresholds {
    /// The thresholds of a sea for foam that covers `share` of it and lives `lifetime_s` seconds: the right ones, or, with the work
    /// spread, a guess until they have been found. `steps` counts the simulation's.
    pub fn of(
        &mut self,
        sea: &Arc<SeaTables>,
        share: f64,
        lifetime_s: f64,
        is_spread: bool,
        steps: &mut usize,
    ) -> [Fold; LEVELS] {
        if share <= 0.0 {
            self.rest();
            return [Fold::NEVER; LEVELS];
        }
        if self.simulated.as_ref().is_none_or(|(of, _)| !of.has_waves_of(sea)) {
            let (texels_m, patches) = (breaking_m(&sea.sea), &sea.cascades);
            let simulation = Simulation::new(&sea.sea.drawn_spectrum(), sea.sea.depth_m, patches, texels_m);
            self.simulated = Some((sea.clone(), simulation.with_modes(&sea.sea.modes(), patches, texels_m)));
            self.wanted = None;
        }
        let wanted = Some([sea.sea.chop, share, lifetime_s]);
        if self.wanted != wanted {
            self.wanted = wanted;
            self.found.clear();
            self.guess = [None; LEVELS];
        }
        while !is_spread && self.is_busy() {
            self.advance(steps);
        }
        let Some((_, simulation)) = &mut self.simulated else { return [Fold::NEVER; LEVELS] };
        if self.found.len() < LEVELS && simulation.points() < POINTS_A_FRAME {
            *steps += simulation.advance(POINTS_A_FRAME);
        }
        std::array::from_fn(|level| {
            let found = self.found.get(level).filter(|_| self.found.len() == LEVELS);
            let guess = || fold(sea, simulation, level, POINTS_A_FRAME, [sea.sea.chop, share, lifetime_s]);
            *found.unwrap_or_else(|| self.guess[level].get_or_insert_with(guess))
        })
    }

    /// No map is drawn: nothing needs to be found.
    pub fn rest(&mut self) {
        self.wanted = None;
    }

    /// Does a frame's part of the work. True when it was the last one.
    pub fn advance(&mut self, steps: &mut usize) -> bool {
        if !self.is_busy() {
            return false;
        }
        let (Some(wanted), Some((sea, simulation))) = (self.wanted, &mut self.simulated) else { return false };
        if simulation.points() < POINTS {
            *steps += simulation.advance(POINTS_A_FRAME);
        } else {
            self.found.push(fold(sea, simulation, self.found.len(), POINTS, wanted));
        }
        self.found.len() == LEVELS
    }

    /// Whether there is more to find.
    pub fn is_busy(&self) -> bool {
        self.wanted.is_some() && self.found.len() < LEVELS
    }
}

fn fold(
    sea: &SeaTables,
    simulation: &Simulation<LEVELS>,
    level: usize,
    points: usize,
    [chop, share, lifetime_s]: [f64; 3],
) -> Fold {
    let softness = softness(breaking_m(&sea.sea)[level]);
    simulation.fold(level, points, chop, softness, share, lifetime_s)
}
