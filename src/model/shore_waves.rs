//! How a train of waves comes to a shore: the phase with which it arrives everywhere, its direction and its energy, on a grid around a
//! piece of coast.
//!
//! ```text
//!  ·  ·  ·  ·  ·  ·      |∇S| = k(ω, h)            S arrival phase, from the window's up-wave border
//!  ·  ·  · ╱▒▒▒▒ ·       ∇·(E cg ∇S/|∇S|) = 0      E energy; land takes it up, a lee has what comes round
//!  ·  · ╱▒▒▒▒▒▒▒ ·
//!  waves ↗  lee          S = R + F(h, d): F has all that is singular at the shore, where k grows beyond bounds, R is smooth
//! ```
//! The phase is found by [fast sweeping](crate::bibliography::Zhao2005), so waves that a headland blocks come round it: what is in its lee
//! arrives from its end. The grid is as coarse as tens of metres, a wave at the beach is shorter: so the grid holds the rest R, and whoever
//! looks adds [`regular`] of the depth and the distance to the shore that he finds at his own place, down to centimetres.
//!
//! Rejected: the distance to the shore as the phase (surf from all sides of an island, no lee, no direction), the phase itself on the grid
//! (k is then 18 % off at the shore), rays (caustics, and places that none reaches).

use super::GRAVITY;
use super::dispersion::wavenumber;
use super::sea_bed::smoothstep;

/// π²/8, towards which the phase that a plane beach adds tends, over its slope.
pub const ADDED: f64 = 1.233_700_550_136_169_7;
/// Towards which the phase that Dean's profile adds tends, over 1.5 A^-1.5 √g/ω.
pub const ADDED_BY_DEAN: f64 = 0.561_787;
/// The shallowest water that waves are followed into, m.
pub const SHALLOWEST_M: f64 = 0.05;
/// Energy over the open sea's, at most: where rays meet, waves break, and so does this theory.
const MOST: f64 = 4.0;
/// Rounds of four sweeps, at most. A straight coast takes two, a labyrinth of islands six.
const ROUNDS: usize = 12;
/// A round that changes no phase by more is the last, radians.
const SETTLED: f64 = 1e-3;

/// The water at a place by a shore.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shallows {
    /// Depth, m.
    pub h: f64,
    /// Distance to the shore, m.
    pub d: f64,
    /// Slope of the beach.
    pub m: f64,
    /// Depth, m, that there is but for a coral reef ([`super::reefs`]).
    pub plain_h: f64,
    /// What such a reef leaves of the waves' height.
    pub left: f64,
}

impl Shallows {
    /// Where there is no reef.
    pub fn new(h: f64, d: f64, m: f64) -> Self {
        Self { h, d, m, plain_h: h, left: 1.0 }
    }

    /// The same place without its reef.
    fn plain(self) -> Self {
        Self::new(self.plain_h, self.d, self.m)
    }

    /// Which parts of the distance are a plane beach's and Dean's profile's: d = h/m + (h/A)^1.5.
    fn parts(self) -> [f64; 2] {
        let plane = (self.h.max(SHALLOWEST_M) / self.m).min(self.d.max(0.0));
        [plane, self.d.max(0.0) - plane]
    }

    /// Slope of the bed where the depth here is `over` of that there: Dean's profile has one that goes with the inverse root of the depth.
    pub fn slope_where(self, over: f64) -> f64 {
        let [plane, curved] = self.parts();
        self.slope() * libm::pow(over, 0.5 * curved / (plane + curved).max(1e-9))
    }

    /// Slope of the bed there, as of that profile.
    pub fn slope(self) -> f64 {
        let [plane, curved] = self.parts();
        self.h.max(SHALLOWEST_M) / (plane + 1.5 * curved).max(1.0)
    }
}

/// The part of the arrival phase that grows without bounds in its slope towards the shore, radians: over the bed of
/// [`Coast`](super::sea_bed::Coast), that of the waves there less that of deep water, within what is smooth. It knows of no reef: what that adds is bounded.
pub fn regular(omega: f64, place: Shallows) -> f64 {
    let place = place.plain();
    let h = place.h.max(SHALLOWEST_M);
    let ([plane, curved], u) = (place.parts(), omega * omega * h / GRAVITY);
    let of_plane = ADDED * libm::tanh(2.0 * libm::sqrt(u) / ADDED);
    let of_curved = 1.5 * ADDED_BY_DEAN * (1.0 - libm::exp(-u / ADDED_BY_DEAN)) / libm::sqrt(u);
    -(plane * of_plane + curved * of_curved) / h
}

/// The sea's bed on a square grid; rows run from north to south, columns from west to east.
#[derive(Clone, Debug, PartialEq)]
pub struct Bed {
    /// Nodes along a side.
    pub side: usize,
    /// From a node of each row to its neighbours, m.
    pub step_m: Vec<f64>,
    /// Depth, m; at most 0 on land.
    pub depth_m: Vec<f64>,
    /// Distance to the ocean's shore, m, positive in the ocean.
    pub shore_m: Vec<f64>,
    /// Slope of the beach.
    pub face: Vec<f64>,
    /// Depth but for coral reefs, m.
    pub plain_m: Vec<f64>,
}

/// Bytes of vectors' elements.
macro_rules! bytes {
    ($($of:expr),+) => { 0 $(+ size_of_val(&$of[..]))+ };
}

impl Bed {
    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        bytes!(self.step_m, self.depth_m, self.shore_m, self.face, self.plain_m)
    }

    fn is_wet(&self, at: usize) -> bool {
        self.shore_m[at] > 0.0
    }

    fn at(&self, at: usize) -> Shallows {
        let place = Shallows::new(self.depth_m[at], self.shore_m[at], self.face[at]);
        Shallows { plain_h: self.plain_m[at], ..place }
    }

    fn wavenumber(&self, omega: f64, at: usize) -> f64 {
        wavenumber(omega, self.depth_m[at].max(SHALLOWEST_M))
    }

    /// ∇F of [`regular`] at a node, east and south: by differences, but near the shore from the distance alone.
    fn regular_slope(&self, omega: f64, at: usize) -> [f64; 2] {
        let (n, step) = (self.side, self.step_m[at / self.side]);
        let (i, j) = (at % n, at / n);
        let pairs = [(at - usize::from(i > 0), at + usize::from(i + 1 < n)), {
            (at - n * usize::from(j > 0), at + n * usize::from(j + 1 < n))
        }];
        let width = [[i > 0, i + 1 < n], [j > 0, j + 1 < n]]
            .map(|sides| sides.iter().filter(|side| **side).count() as f64 * step);
        let (h, d) = (self.plain_m[at].max(SHALLOWEST_M), self.shore_m[at]);
        if d > 2.5 * step {
            let found = |at: usize| regular(omega, self.at(at));
            return [0, 1].map(|axis| (found(pairs[axis].1) - found(pairs[axis].0)) / width[axis]);
        }
        let k = omega * omega / GRAVITY;
        let root = libm::sqrt(k * h);
        // dF/dh over dd/dh, of both parts.
        let falling = 1.0 / libm::cosh(2.0 * root / ADDED);
        let [plane, curved] = self.at(at).plain().parts();
        let by_depth = plane * falling * falling + 1.5 * curved * libm::exp(-k * h / ADDED_BY_DEAN);
        let slope = -k / root * by_depth / (plane + 1.5 * curved);
        let rise = [0, 1].map(|axis: usize| (self.shore_m[pairs[axis].1] - self.shore_m[pairs[axis].0]) / width[axis]);
        let length = libm::hypot(rise[0], rise[1]).max(0.3);
        rise.map(|rise| slope * rise / length)
    }
}

impl Bed {
    /// How a train that travels to the unit vector `toward` in deep water comes to a node, if contours run along the shore as far as the open sea: its way
    /// by Snell's law, and its energy over that in deep water, without shoaling. Waves that run along the shore or away from it have come another
    /// way, and keep theirs.
    fn arriving(&self, omega: f64, toward: [f64; 2], at: usize) -> ([f64; 2], f64) {
        let n = self.side;
        let rise = [(at % n, 1), (at / n, n)].map(|(place, stride)| {
            let (before, after) = (usize::from(place > 0), usize::from(place + 1 < n));
            (self.shore_m[at + after * stride] - self.shore_m[at - before * stride])
                / ((before + after) as f64 * self.step_m[at / n])
        });
        let length = libm::hypot(rise[0], rise[1]);
        // Beyond where a shore is known, and midway between two.
        if !self.is_wet(at) || !(0.5..2.0).contains(&length) {
            return (toward, 1.0);
        }
        let inward = rise.map(|rise| -rise / length);
        let cos = (toward[0] * inward[0] + toward[1] * inward[1]).min(1.0);
        let shorter = omega * omega / GRAVITY / self.wavenumber(omega, at);
        let ratio = 1.0 + (shorter - 1.0) * smoothstep(0.0, 0.3, cos);
        let along = [0, 1].map(|axis| ratio * (toward[axis] - cos * inward[axis]));
        let cos_here = libm::sqrt((1.0 - along[0] * along[0] - along[1] * along[1]).max(0.0));
        if cos <= 0.0 {
            return (toward, 1.0);
        }
        ([0, 1].map(|axis| along[axis] + cos_here * inward[axis]), cos / cos_here.max(1e-6))
    }
}

/// What a grid holds of one train.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arrivals {
    /// R = S - F, radians. On land by a shore it goes on as in the water, so that it can be interpolated up to the shore.
    pub rest: Vec<f64>,
    /// Where the waves travel to, east and south, as long as their height is over the open sea's, without shoaling.
    pub way: Vec<[f64; 2]>,
}

impl Arrivals {
    /// Bytes that they hold.
    pub fn bytes(&self) -> usize {
        bytes!(self.rest, self.way)
    }
}

/// A train that is being followed, a round of sweeps at a time.
#[derive(Clone, Debug)]
pub struct Following {
    omega: f64,
    toward: [f64; 2],
    slope: Vec<[f64; 2]>,
    k: Vec<f64>,
    rest: Vec<f64>,
    is_seed: Vec<bool>,
    rounds: usize,
}

impl Following {
    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        bytes!(self.slope, self.k, self.rest, self.is_seed)
    }

    /// A train of frequency `omega` that travels to the unit vector `toward`, east and south, where nothing is in its way.
    pub fn new(bed: &Bed, omega: f64, toward: [f64; 2]) -> Self {
        let n = bed.side;
        let slope = (0..n * n).map(|at| if bed.is_wet(at) { bed.regular_slope(omega, at) } else { [0.0; 2] }).collect();
        let k: Vec<f64> = (0..n * n)
            .map(|at| if bed.is_wet(at) { bed.wavenumber(omega, at) } else { omega * omega / GRAVITY })
            .collect();
        let (mut rest, mut is_seed) = (vec![f64::INFINITY; n * n], vec![false; n * n]);
        // From the corner that the waves reach first, along both sides that meet there: as long as there, and turned as far.
        let (first_i, first_j) = (if toward[0] > 0.0 { 0 } else { n - 1 }, if toward[1] > 0.0 { 0 } else { n - 1 });
        let corner = first_j * n + first_i;
        for along in [true, false] {
            let mut phase = 0.0;
            let mut last = corner;
            for step in 0..n {
                let away = |first: usize| if first == 0 { step } else { n - 1 - step };
                let at = if along { first_j * n + away(first_i) } else { away(first_j) * n + first_i };
                let axis = usize::from(!along);
                let part =
                    |at: usize| k[at] * (bed.arriving(omega, toward, at).0[axis] * toward[axis].signum()).max(0.0);
                phase += if at == last { 0.0 } else { 0.5 * (part(at) + part(last)) * bed.step_m[at / n] };
                last = at;
                if bed.is_wet(at) {
                    rest[at] = phase - regular(omega, bed.at(at));
                    is_seed[at] = true;
                }
            }
        }
        Self { omega, toward, slope, k, rest, is_seed, rounds: 0 }
    }

    /// R as the neighbours of a node on an axis have it, and which way the waves come along that: infinite where none do.
    fn along_axis(&self, bed: &Bed, at: usize, axis: usize) -> (f64, f64) {
        let n = bed.side;
        let (place, stride) = if axis == 0 { (at % n, 1) } else { (at / n, n) };
        let drift = self.slope[at][axis] * bed.step_m[at / n];
        let before = if place > 0 { self.rest[at - stride] - drift } else { f64::INFINITY };
        let after = if place + 1 < n { self.rest[at + stride] + drift } else { f64::INFINITY };
        if before <= after { (before, 1.0) } else { (after, -1.0) }
    }

    /// Godunov's upwind difference.
    fn update(&mut self, bed: &Bed, at: usize) -> f64 {
        if self.is_seed[at] || !bed.is_wet(at) {
            return 0.0;
        }
        let ((x, _), (y, _)) = (self.along_axis(bed, at, 0), self.along_axis(bed, at, 1));
        if x.min(y) == f64::INFINITY {
            return 0.0;
        }
        let way = self.k[at] * bed.step_m[at / bed.side];
        let found = if (x - y).abs() < way {
            0.5 * (x + y + libm::sqrt(2.0 * way * way - (x - y) * (x - y)))
        } else {
            x.min(y) + way
        };
        let change = self.rest[at] - found;
        if change <= 0.0 {
            return 0.0;
        }
        self.rest[at] = found;
        change
    }

    /// One round of four sweeps; true when there is nothing left to find.
    pub fn advance(&mut self, bed: &Bed) -> bool {
        let n = bed.side;
        let mut most = 0.0f64;
        for order in 0..4 {
            for row in 0..n {
                let j = if order & 1 == 0 { row } else { n - 1 - row };
                for column in 0..n {
                    let i = if order & 2 == 0 { column } else { n - 1 - column };
                    most = most.max(self.update(bed, j * n + i));
                }
            }
        }
        self.rounds += 1;
        most < SETTLED || self.rounds >= ROUNDS
    }

    /// Directions and energies, in the order in which the waves arrive, and what lies beyond the shores.
    pub fn finish(mut self, bed: &Bed) -> Arrivals {
        let n = bed.side;
        let arrival = |at: usize| self.rest[at] + regular(self.omega, bed.at(at));
        let mut order: Vec<(f64, usize)> =
            (0..n * n).filter(|&at| self.rest[at].is_finite()).map(|at| (arrival(at), at)).collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut found: Vec<Option<([f64; 2], f64)>> = vec![None; n * n];
        for (_, at) in order {
            if self.is_seed[at] {
                found[at] = Some(bed.arriving(self.omega, self.toward, at));
                continue;
            }
            let mut way = [0.0; 2];
            let mut from = [at; 2];
            for axis in 0..2 {
                let (rest, sign) = self.along_axis(bed, at, axis);
                let stride = if axis == 0 { 1 } else { n };
                way[axis] = if rest.is_finite() { sign * (self.rest[at] - rest).max(0.0) } else { 0.0 };
                from[axis] = if sign > 0.0 { at.saturating_sub(stride) } else { (at + stride).min(n * n - 1) };
            }
            let length = libm::hypot(way[0], way[1]).max(1e-12);
            let way = way.map(|part| part / length);
            // What flows in over both sides flows out over the others.
            let inflow: f64 = (0..2)
                .filter_map(|axis| {
                    let (other, energy) = found[from[axis]]?;
                    Some(if way[axis] == 0.0 { 0.0 } else { energy * (other[axis] * way[axis].signum()).max(0.0) })
                })
                .sum();
            found[at] = Some((way, (inflow / (way[0].abs() + way[1].abs()).max(0.5)).min(MOST)));
        }
        let mut way: Vec<[f64; 2]> = found
            .iter()
            .map(|found| found.map_or([0.0; 2], |(way, energy)| way.map(|part| part * libm::sqrt(energy))))
            .collect();
        continue_on_land(n, &mut self.rest, &mut way);
        Arrivals { rest: self.rest, way }
    }
}

/// Goes on with R by its slope, and with the way as it is, three nodes beyond what the waves reach.
fn continue_on_land(n: usize, rest: &mut [f64], way: &mut [[f64; 2]]) {
    for _ in 0..3 {
        let known: Vec<f64> = rest.to_vec();
        let is_known = |i: i64, j: i64| {
            let inside = (0..n as i64).contains(&i) && (0..n as i64).contains(&j);
            inside.then(|| (j * n as i64 + i) as usize).filter(|&at| known[at].is_finite())
        };
        for at in (0..n * n).filter(|&at| !known[at].is_finite()) {
            let (i, j) = ((at % n) as i64, (at / n) as i64);
            let (mut sum, mut ways, mut weights) = (0.0, [0.0; 2], 0.0);
            for (di, dj) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
                let Some(near) = is_known(i + di, j + dj) else { continue };
                // The next one in the same line, a step beyond.
                let slope = is_known(i + 2 * di, j + 2 * dj).map_or(0.0, |far| known[near] - known[far]);
                let weight = if di == 0 || dj == 0 { 1.0 } else { 0.5 };
                sum += weight * (known[near] + slope);
                ways = [0, 1].map(|axis| ways[axis] + weight * way[near][axis]);
                weights += weight;
            }
            if weights > 0.0 {
                rest[at] = sum / weights;
                way[at] = ways.map(|way| way / weights);
            }
        }
    }
    rest.iter_mut().filter(|rest| !rest.is_finite()).for_each(|rest| *rest = 0.0);
}

/// A train on a bed, all at once.
pub fn arrivals(bed: &Bed, omega: f64, toward: [f64; 2]) -> Arrivals {
    let mut following = Following::new(bed, omega, toward);
    while !following.advance(bed) {}
    following.finish(bed)
}
