//! Swash: what becomes of a wave that reaches the waterline of a beach. It runs up the sand as a thin sheet, slows down, runs back and leaves
//! the sand wet.
//!
//! ```text
//!         film h(x, t)             front  x(t) = u₀t − ½gβt²,  u₀ = √(2gR)
//!  sea  ~~~~~~~~~~~___             reach  R/β, after u₀/(gβ);  back at 0 after 2u₀/(gβ)
//!  ─────0──────────x──── R/β       wet    where fronts have been, up to the run-up that a fiftieth of the waves pass
//! ```
//! Letters: R height of a run-up over the still water, m; β slope of the beach where waves run up; x way up the beach from the still water's
//! line, m; H₀ significant height in deep water, m; L₀ = 2πg/ω² its length there. How high waves run up is
//! [Stockdon's](crate::bibliography::Stockdon2006), the sheet [Shen and Meyer's](crate::bibliography::Shen1963) for a bore that
//! collapses at the line: without friction, and as if no other wave met it on its way back. Everything is a function of place and time:
//! when the last waves came is found again from the trains each time. `shaders/lib/swash.wgsl` does the same in 32 bits.
//!
//! Rejected: a line that moves to and fro like a sine (swash rises fast and falls slowly, and a new wave overtakes the last one's water);
//! a height that a simulation remembers (no jump in time would show the same beach).

use super::GRAVITY;
use super::sea_bed::smoothstep;

/// A steeper shore is no beach, and no beach is steeper.
pub const STEEPEST: f64 = 0.15;
/// Crests that are looked for: no sheet lasts for longer than so many waves.
pub const CRESTS: usize = 4;
/// Quarters of a mean period in which they are looked for.
pub const STEPS: usize = 16;
/// Wet sand shines for so long, s.
pub const SHINES_S: f64 = 8.0;
/// Iribarren's numbers between which Stockdon's formula for flat beaches gives way to that for steeper ones: he says 0.3, where the two are
/// a third apart.
pub const FLAT: [f64; 2] = [0.25, 0.35];
/// Run-up over √(H₀L₀) of flat beaches, that a fiftieth of the waves pass.
pub const FLAT_RUNUP: f64 = 0.043;

/// Slope of a beach where waves run up, whose ground rises by `m` ([`Coast`](super::sea_bed::Coast)).
pub fn foreshore(m: f64) -> f64 {
    m.min(STEEPEST)
}

/// How high waves run up a beach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunUp {
    /// What all of them have, m.
    pub setup_m: f64,
    /// What a wave adds that is as high as the significant height, m.
    pub of_height_m: f64,
}

impl RunUp {
    /// Of a sea `hs` m high in deep water with the frequency `omega`, rad/s, on a beach of slope `beta`.
    pub fn new(hs: f64, omega: f64, beta: f64) -> Self {
        let length = std::f64::consts::TAU * GRAVITY / (omega * omega);
        let root = libm::sqrt(hs * length);
        let setup = 1.1 * 0.35 * beta * root;
        // Of Rayleigh's heights a fiftieth pass 1.3985 Hs, where this is half of the swash.
        let swash = 1.1 * 0.5 / RAYLEIGH_FIFTIETH * root * libm::sqrt(0.563 * beta * beta + 0.004);
        let steep = smoothstep(FLAT[0], FLAT[1], beta / libm::sqrt((hs / length).max(1e-9)));
        let whole = setup + RAYLEIGH_FIFTIETH * swash;
        let scale = 1.0 + (1.0 - steep) * (FLAT_RUNUP * root / whole.max(1e-9) - 1.0);
        Self { setup_m: scale * setup, of_height_m: scale * swash }
    }

    /// R of a wave whose height is `relative` times the significant one, m.
    pub fn of(self, relative: f64) -> f64 {
        self.setup_m + self.of_height_m * relative
    }

    /// R that a fiftieth of the waves pass, m.
    pub fn fiftieth(self) -> f64 {
        self.of(RAYLEIGH_FIFTIETH)
    }
}

/// √(-½ ln 0.02): the height that a fiftieth of Rayleigh's pass, over the significant one.
pub const RAYLEIGH_FIFTIETH: f64 = 1.398_544_1;

/// The sheet of one wave on a beach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// u₀, m/s.
    pub speed: f64,
    /// gβ, m/s².
    pub slows: f64,
}

impl Sheet {
    /// That of a run-up of `r` m on a beach of slope `beta`.
    pub fn new(r: f64, beta: f64) -> Self {
        Self { speed: libm::sqrt(2.0 * GRAVITY * r.max(0.0)), slows: GRAVITY * beta }
    }

    /// Where its front is, m up the beach, `t` s after it has passed the still water's line; at most 0 when it is back.
    pub fn front(self, t: f64) -> f64 {
        t * (self.speed - 0.5 * self.slows * t)
    }

    /// How far up it comes, m.
    pub fn reach(self) -> f64 {
        0.5 * self.speed * self.speed / self.slows
    }

    /// When its front is back, s.
    pub fn flight(self) -> f64 {
        2.0 * self.speed / self.slows
    }

    /// How deep it is `x` m up the beach, m.
    pub fn film(self, x: f64, t: f64) -> f64 {
        let behind = self.front(t) - x;
        if t <= 0.0 || behind <= 0.0 {
            return 0.0;
        }
        // (4t - t² - 2x)²/36t² in units of u₀/2gβ, u₀²/4gβ and u₀²/4g.
        let over = behind / (3.0 * t);
        over * over / GRAVITY
    }

    /// For how long a place `x` m up the beach has been left by its water, s: negative while that is still to come, `None` where it does not come.
    pub fn left_for(self, x: f64, t: f64) -> Option<f64> {
        let below = self.speed * self.speed - 2.0 * self.slows * x;
        (below > 0.0).then(|| t - (self.speed + libm::sqrt(below)) / self.slows)
    }
}

/// A train of waves as it comes to a place of the waterline.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arriving {
    /// Its frequency, rad/s.
    pub omega: f64,
    /// Its amplitude in deep water, m.
    pub amplitude: f64,
    /// Its phase now, radians: 0 at a crest, growing with time.
    pub phase: f64,
}

/// A crest of a sum of trains.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crest {
    /// For how long it has been past, s.
    pub age: f64,
    /// Twice the size of the sum when it came, m.
    pub height: f64,
}

/// The last crests of a sum of trains, the youngest first, as far as there are any within [`STEPS`]; the others have no height. `mean` is the
/// trains' mean frequency, rad/s. The sum is looked at every quarter of a mean period, and its phase and size taken to be straight between
/// two looks: a crest's age grows with time and its height stays, both within some hundredths, without a jump where it passes a look.
pub fn crests(trains: &[Arriving], mean: f64) -> [Crest; CRESTS] {
    let quarter = 0.25 * std::f64::consts::TAU / mean;
    let sum_at = |ago: f64| {
        let parts = trains.iter().map(|train| {
            let (sin, cos) = libm::sincos(train.phase - train.omega * ago);
            [cos, sin].map(|part| train.amplitude * part)
        });
        let [x, y] = parts.fold([0.0; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
        [libm::hypot(x, y), libm::atan2(y, x)]
    };
    let mut found = [Crest { age: 1e6, height: 0.0 }; CRESTS];
    let mut count = 0;
    let mut after = sum_at(0.0);
    for step in 1..=STEPS {
        let before = sum_at(step as f64 * quarter);
        let turned = after[1] - before[1];
        // Its phase has passed 0, and not π.
        if after[1] >= 0.0 && before[1] < 0.0 && turned < std::f64::consts::PI && count < CRESTS {
            let part = after[1] / turned;
            let age = ((step - 1) as f64 + part) * quarter;
            found[count] = Crest { age, height: 2.0 * (after[0] + part * (before[0] - after[0])) };
            count += 1;
        }
        after = before;
    }
    found
}
