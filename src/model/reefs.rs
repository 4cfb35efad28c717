//! Coral reefs about islands that rise out of a deep warm sea (Tahiti, Mauritius).
//!
//! ```text
//!  ashore     lagoon             flat  crest
//!  ___                                            ~~~ the sea's level
//!     \\___                 ____/¯¯¯¯¯\\
//!          \\___  channel __/           \\  fore reef
//!              ¯¯¯¯¯¯¯¯¯                  |  deep
//!      0 ................. 1 - flat ..... c        distance to the shore
//! ```
//! Data of the sea's depth whose cells are kilometres wide know nothing of them: the crest, up to which corals grow, is a hundred metres wide. It lies some
//! hundred metres to two kilometres off the shore, by a noise of the place; behind it waves are low. Passes break it along the lines where a sum of two noises is none. All numbers are ours, of the
//! look of the Society Islands, Mauritius and the Cooks.
//!
//! Places are those of Mercator's map. `shaders/lib/reefs.wgsl` is the same in single precision.

use super::noise::map_noise;
use super::rugged;
use super::sea_bed::{smoothstep, trusted_m};

/// Data whose cells are as wide, metres, or wider, do not tell islands in a deep sea from the edges of continents. Ours: some twice those of the bundled world.
pub const COARSEST_M: f64 = 20_000.0;
/// Sines of 23 and 25.5 degrees, between which the sea becomes too cold for them.
pub const WARM: [f64; 2] = [0.391, 0.431];
/// Where there are none: middles and half axes of ellipses on Mercator's square. From the Marquesas to the Americas, and from Cape Verde and Fernando de
/// Noronha to Africa, cold water wells up; the Bahamas are a bank, shallow far out.
pub const WITHOUT: [[f64; 4]; 3] =
    [[0.197, 0.5111, 0.0972, 0.0563], [0.4722, 0.4889, 0.0667, 0.0735], [0.2894, 0.4313, 0.0181, 0.013]];
/// Between these squares of the way from their middles, of the axes, it goes over.
pub const WITHOUT_ENDS: [f64; 2] = [0.9, 1.15];
/// Cells of noises over two to these powers units of the map: 4.9 km and 1.2 km at the equator, by which the crest is farther off or nearer, that of passes, and a third for the crest, 306 m.
pub const BITS: [u32; 4] = [19, 17, 19, 15];
/// How far off the crest is in the mean, metres.
pub const CREST_M: f64 = 750.0;
/// By how many powers of two noises change that.
pub const CREST_VARIES: [f64; 3] = [2.4, 0.7, 0.35];
/// No crest is farther off, metres.
pub const FARTHEST_M: f64 = 3_000.0;
/// How wide the flat behind it is, metres, and the part of a narrow reef that it is at most.
pub const FLAT_M: f64 = 150.0;
/// See [`FLAT_M`].
pub const FLAT_MOST: f64 = 0.6;
/// Depth of the crest, and of passes, metres.
pub const CREST_DEPTH_M: [f64; 2] = [0.7, 22.0];
/// By how much the noises but the broadest change the first.
pub const CREST_ROUGH_M: [f64; 2] = [0.6, 0.5];
/// How far from the middle of a pass it is whole, and its sides end, metres.
pub const PASS_M: [f64; 2] = [60.0, 170.0];
/// What the finer noise bends passes' lines by, of their own.
pub const PASS_BENDS: f64 = 0.2;
/// By how many powers of two the finest noise makes passes wider or narrower.
pub const PASS_UNEVEN: f64 = 1.2;
/// By so much of its way the crest draws nearer to the shore where a pass is: its ends are curled.
pub const PASS_CURLS: f64 = 0.2;
/// Crests nearer than the first have none, farther than the second all, metres.
pub const PASS_CREST_M: [f64; 2] = [150.0, 400.0];
/// Depth of the channel of a lagoon that is so wide, and a narrow one's, metres.
pub const CHANNEL_M: [f64; 2] = [18.0, 1.0];
/// See [`CHANNEL_M`]: between these widths, metres.
pub const CHANNEL_WIDE_M: [f64; 2] = [150.0, 1_300.0];
/// Depth of the fringing reef along the shore of a lagoon, metres.
pub const FRINGE_M: f64 = 1.6;
/// Parts of the way from the shore to the flat between which that falls to the channel, and from the second to the flat the bed rises again.
pub const LAGOON: [f64; 2] = [0.12, 0.45];
/// How steeply the fore reef begins to fall, and over which way, metres, it is as much deeper as that way's cube.
pub const FORE: [f64; 2] = [0.05, 50.0];
/// How steeply it goes on, where the data have the bed less deep.
pub const GOES_ON: f64 = 0.35;
/// From the shore between which the beach goes over into the reef, metres.
pub const BEACH_M: [f64; 2] = [5.0, 60.0];
/// Shares of a reef between which the shore's own profile gives way to it.
pub const BEGINS: [f64; 2] = [0.02, 0.3];
/// Level of the water tiles whose mean distance to the shore tells waters between two shores, which are no deeper than a lagoon: it is less than the
/// place's own.
pub const WIDE_LEVEL: u8 = 6;
/// So much less where that begins, and is, metres.
pub const ENCLOSED_M: [f64; 2] = [40.0, 240.0];
/// Between these distances from the shore there are no longer any, metres: bays are not enclosed.
pub const ENCLOSED_TO_M: [f64; 2] = [1_100.0, 1_700.0];
/// How much deeper than a lagoon the bed may be where it is half enclosed, metres.
pub const OPEN_M: f64 = 40.0;
/// What of the waves' height comes over it, and how near to passes they are higher, metres.
pub const COMES_OVER: f64 = 0.12;
/// Part of the flat over which they break.
pub const CALMED: f64 = 0.6;
/// See [`COMES_OVER`].
pub const BY_PASS_M: [f64; 2] = [100.0, 600.0];
/// So far ashore, metres, what comes in to a beach is what the reef before it leaves: no wave runs up farther.
pub const ASHORE_M: f64 = 500.0;
/// No farther off a shore, metres, the bed is less deep than data have it: 600 m out of the farthest crest the fore reef is deeper than any bed about islands.
pub const REACH_M: f64 = FARTHEST_M + 600.0;

/// Whether elevations of a resolution (metres; 0: not known) leave reefs to be made up, and tell where.
pub fn are_in(resolution_m: f64) -> bool {
    rugged::is_coarse(resolution_m) && resolution_m < COARSEST_M
}

/// How far there is a reef about islands, 0 to 1, at a place of Mercator's map, `x` and `y` from 0 to 1, at a latitude of this sine, where the mean elevation in texels
/// `texel_m` wide, of level [`rugged::ISLAND_LEVEL`], is `mean_m`: on shelves waters are muddy, and reefs others.
pub fn share([x, y]: [f64; 2], sin_lat: f64, mean_m: f64, texel_m: f64) -> f64 {
    let warm = 1.0 - smoothstep(WARM[0], WARM[1], sin_lat.abs());
    let without = WITHOUT.map(|[east, south, wide, high]| {
        let off = [(x - east) / wide, (y - south) / high];
        smoothstep(WITHOUT_ENDS[0], WITHOUT_ENDS[1], off[0] * off[0] + off[1] * off[1])
    });
    warm * without.iter().product::<f64>() * rugged::oceanic(mean_m, texel_m)
}

/// How near a place is to a pass whose middle is so far away, 0 to 1.
fn by_pass(pass_m: f64) -> f64 {
    1.0 - smoothstep(BY_PASS_M[0], BY_PASS_M[1], pass_m)
}

/// What a reef is like about a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reef {
    /// How far there is one, 0 to 1.
    pub share: f64,
    /// How far off the shore its crest is, metres.
    pub crest_m: f64,
    /// How deep that is but for passes, metres.
    pub shallow_m: f64,
    /// Way to the middle of the nearest pass, metres.
    pub pass_m: f64,
    /// Mean distance to the shore about the place, metres.
    pub wide_m: f64,
}

impl Reef {
    /// At a place of the map in units of 2^-32 of its side, where there is so much of one, at a latitude of this cosine.
    pub fn new(share: f64, at: [u32; 2], cos_lat: f64, wide_m: f64) -> Self {
        let [wide, fine, pass, rough] = [0, 1, 2, 3].map(|k| map_noise(at, BITS[k], 111 + k as u32));
        let cell_m = std::f64::consts::TAU * 6_378_137.0 * cos_lat / f64::from(1u32 << (32 - BITS[2]));
        let varied = libm::exp2(CREST_VARIES[0] * wide[0] + CREST_VARIES[1] * fine[0] + CREST_VARIES[2] * rough[0]);
        // The finer one rises within so much shorter cells.
        let steeper = f64::from(1u32 << (BITS[2] - BITS[1]));
        let line = [0, 1, 2].map(|k| pass[k] + PASS_BENDS * if k == 0 { 1.0 } else { steeper } * fine[k]);
        let straight_m = cell_m * line[0].abs() / libm::hypot(line[1], line[2]).max(0.3);
        let pass_m = straight_m * libm::exp2(PASS_UNEVEN * rough[0]);
        let by_pass = by_pass(pass_m);
        let crest_m = (share * CREST_M * varied).min(FARTHEST_M);
        let curled = PASS_CURLS * by_pass * by_pass * smoothstep(PASS_CREST_M[0], PASS_CREST_M[1], crest_m);
        Self {
            share,
            crest_m: crest_m * (1.0 - curled),
            shallow_m: CREST_DEPTH_M[0] + CREST_ROUGH_M[0] * fine[0] + CREST_ROUGH_M[1] * rough[0],
            pass_m,
            wide_m,
        }
    }

    /// Depth at a place `shore_m` off the shore (less than 0: the ground's ashore), in the mean about it `wide_m`, where without a reef it is `plain_m` and the data's cells are `resolution_m` wide, and what is left of the
    /// waves' height; the rest as for the others.
    pub fn depth_on(
        share: f64,
        at: [u32; 2],
        cos_lat: f64,
        [shore_m, wide_m]: [f64; 2],
        plain_m: f64,
        resolution_m: f64,
        far_m: f64,
    ) -> (f64, f64) {
        let trusted_m = trusted_m(resolution_m);
        if share <= 0.0 || !(-ASHORE_M..=trusted_m).contains(&shore_m) {
            return (plain_m, 1.0);
        }
        let reef = Self::new(share, at, cos_lat, wide_m);
        if shore_m <= 0.0 {
            return (plain_m, reef.waves_left(0.0));
        }
        let trusted = smoothstep(0.1 * trusted_m, trusted_m, shore_m);
        (reef.depth_m(shore_m, plain_m, trusted, far_m), reef.waves_left(shore_m))
    }

    /// How far a place lies between two shores, 0 to 1.
    fn enclosed(&self, d: f64) -> f64 {
        smoothstep(ENCLOSED_M[0], ENCLOSED_M[1], d - self.wide_m)
            * (1.0 - smoothstep(ENCLOSED_TO_M[0], ENCLOSED_TO_M[1], d))
    }

    /// How wide its flat is, metres.
    fn flat_m(&self) -> f64 {
        FLAT_M.min(FLAT_MOST * self.crest_m)
    }

    /// How far a place is in a pass, 0 to 1.
    fn in_pass(&self) -> f64 {
        (1.0 - smoothstep(PASS_M[0], PASS_M[1], self.pass_m))
            * smoothstep(PASS_CREST_M[0], PASS_CREST_M[1], self.crest_m)
    }

    /// Depth `d` metres from the shore, where without a reef it is `plain_m`; so far out (`trusted`, 0 to 1) data are trusted, and the sea about is `far_m` deep.
    pub fn depth_m(&self, d: f64, plain_m: f64, trusted: f64, far_m: f64) -> f64 {
        let out = d - self.crest_m;
        let crest_m = self.shallow_m + (CREST_DEPTH_M[1] - self.shallow_m) * self.in_pass();
        let fore_m = crest_m + FORE[0] * out + (out.max(0.0) / FORE[1]).powi(3);
        let outside_m = plain_m.max(crest_m.max(GOES_ON * out).min(far_m * (1.0 - trusted))).min(fore_m);
        let across = d / (self.crest_m - self.flat_m()).max(1.0);
        let channel_m = CHANNEL_M[1]
            + (CHANNEL_M[0] - CHANNEL_M[1]) * smoothstep(CHANNEL_WIDE_M[0], CHANNEL_WIDE_M[1], self.crest_m);
        let bed_m = FRINGE_M + (channel_m - FRINGE_M).max(0.0) * smoothstep(LAGOON[0], LAGOON[1], across);
        let inside_m = bed_m + (crest_m - bed_m) * smoothstep(LAGOON[1], 1.0, across);
        // Between two shores it goes on as a lagoon, in front of others as the open sea.
        let enclosed = self.enclosed(d);
        let floor_m = channel_m.max(crest_m) + OPEN_M * (1.0 - enclosed) / enclosed.max(1e-3);
        let made_m = if out > 0.0 { outside_m.min(floor_m) } else { inside_m };
        let is = smoothstep(BEGINS[0], BEGINS[1], self.share) * smoothstep(BEACH_M[0], BEACH_M[1], d);
        plain_m + (made_m - plain_m) * is
    }

    /// What is left of the waves' height `d` metres from the shore.
    pub fn waves_left(&self, d: f64) -> f64 {
        let behind = smoothstep(0.0, CALMED * self.flat_m().max(1.0), self.crest_m - d);
        let by_pass = by_pass(self.pass_m);
        let passes = by_pass * by_pass * smoothstep(PASS_CREST_M[0], PASS_CREST_M[1], self.crest_m);
        1.0 - (1.0 - COMES_OVER)
            * behind
            * (1.0 - 0.5 * passes)
            * (1.0 - self.in_pass())
            * smoothstep(BEGINS[0], BEGINS[1], self.share)
    }
}
