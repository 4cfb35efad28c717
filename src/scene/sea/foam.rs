//! The foam map: four levels of texels around the eye, each three times as coarse as the one before, fixed to the world.
//!
//! ```text
//!  +-----------------------------+   A texel is a square of rest coordinates in the plane of the wave cell nearest to the
//!  |              3              |   eye, so waves, foam and eye move past each other as water does.
//!  |      +---------------+      |   Texel (i, j) of the world lies in the texture at (i mod 256, j mod 256): when the
//!  |      |     2         |      |   eye moves, only the texels that come into the level are made anew, from the
//!  |      |   +-------+   |      |   next coarser level.
//!  |      |   |1 +-+  |   |      |
//!  |      |   |  |0|e |   |      |   The four levels share one texture, a channel each.
//! ```
//! How it moves on in time: [`crate::scene::sea::foam_history`].

use glam::DVec2;

use crate::model::GRAVITY;
use crate::model::foam::{self, Fold, Simulation};
use crate::model::sea::Sea;
use crate::model::sea_state;
use crate::model::sea_tables::SeaTables;
use crate::model::wave_domain::BLEND_WIDTH_M;
use crate::scene::settings::{Foam, FoamRule};

/// Squares of the map; equals `FOAM_LEVELS` in `shaders/lib/frame.wgsl`.
pub const LEVELS: usize = 4;
/// Texels along a side; equals `FOAM_TEXELS` in `shaders/lib/frame.wgsl`.
pub const TEXELS: i32 = 256;
/// Sides of the texels, metres.
pub const TEXELS_M: [f64; LEVELS] = [0.25, 0.75, 2.25, 6.75];
/// Whitecaps belong to waves of some length and more, of the wind sea's longest: shorter folds are the lace's. Ours, by what photographs show.
const BREAKING_SHARE: f64 = 0.015;
/// No foam map from above this altitude, metres: its widest level would be smaller than what is seen as a texture.
pub const HIGHEST_M: f64 = 4_000.0;
/// A wave cell serves the map if it is no farther from the eye's foot than the nearest and this: the blend's width, and twice as far
/// as the map's corners are.
pub const SERVED_M: f64 = BLEND_WIDTH_M + 2.0 * 1_300.0;

/// Where whitecaps are on a sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whitecaps {
    /// Share of the surface that they cover.
    pub share: f64,
    /// Share of it under the film that outlives them, and its opacity.
    pub film: [f64; 2],
    /// Width of what breaks as one, metres, by level.
    pub breaking_m: [f64; LEVELS],
    /// Where foam is born, by level.
    pub folds: [Fold; LEVELS],
    /// Height above which foam lies, and above which it covers all, metres; for [`FoamRule::Height`].
    pub heights_m: [f64; 2],
}

/// Widths of the parts of the water that break as one, metres, of each level: its texels, or more among long waves.
pub fn breaking_m(sea: &Sea) -> [f64; LEVELS] {
    let wave_m = sea.grown().map_or(0.0, |grown| std::f64::consts::TAU * GRAVITY / (grown.omega_p * grown.omega_p));
    TEXELS_M.map(|side| side.max(BREAKING_SHARE * wave_m))
}

/// How gradually water breaks, in root mean squares of its eigenvalue, seen in parts `breaking_m` wide: more gradually, the more crests
/// they hold.
pub fn softness(breaking_m: f64) -> f64 {
    libm::cbrt(breaking_m / 2.0)
}

impl Whitecaps {
    /// The whitecaps of a sea, at once. [`Seas`](crate::scene::sea::Seas) keeps them, and finds them while drawing goes on.
    pub fn new(foam: Foam, sea: &SeaTables) -> Self {
        let whitecaps = Self::without_map(foam, sea);
        if foam.rule == FoamRule::Height {
            return whitecaps;
        }
        let (share, lifetime_s) = (whitecaps.share, foam.lifetime_s);
        let texels_m = whitecaps.breaking_m;
        let simulation = Simulation::new(&sea.sea.drawn_spectrum(), sea.sea.depth_m, &sea.cascades, texels_m);
        let simulation = simulation.with_modes(&sea.sea.modes(), &sea.cascades, texels_m);
        let folds = simulation.folds(sea.sea.chop, texels_m.map(softness), share, lifetime_s);
        Self { folds, ..whitecaps }
    }

    /// The whitecaps of a sea whose foam map is not drawn. [`Foam::amount`] scales the share that is measured at sea
    /// ([Monahan and O'Muircheartaigh](crate::bibliography::Monahan1980)).
    pub fn without_map(foam: Foam, sea: &SeaTables) -> Self {
        let sea = &sea.sea;
        let amount = if sea.hs_m > 0.0 { foam.amount } else { 0.0 };
        let share = (amount * sea_state::whitecap_fraction(sea.speed_mps)).min(0.6);
        let deviation = sea.hs_m / 4.0;
        let from = foam::ramp_start(share);
        Self {
            share,
            film: foam::film(amount * sea_state::breaking_fraction(sea.speed_mps)),
            breaking_m: breaking_m(sea),
            folds: [Fold::NEVER; LEVELS],
            heights_m: [from * deviation, (from + 1.0) * deviation],
        }
    }
}

/// A place in the foam map's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoamEye {
    /// Which cell's plane, and under which wind: another one is another map.
    pub frame: ([i32; 3], u64),
    /// The eye in it, metres.
    pub at: DVec2,
    /// The first level that the picture shows: from high up the finest are smaller than pixels.
    pub finest: usize,
    /// How many of the frame's wave cells, nearest first, serve the map.
    pub cells: u32,
}

impl FoamEye {
    /// Texel of the eye in the lace, along the wind and across it, and how far into it the eye is.
    pub fn lace(&self, wind_from: f64) -> ([i32; 2], [f32; 2]) {
        let (sin, cos) = libm::sincos(wind_from);
        let along = DVec2::new(-sin, -cos).dot(self.at);
        let across = DVec2::new(cos, -sin).dot(self.at);
        in_texels(DVec2::new(along, across) / TEXELS_M[0])
    }

    /// Whether the map about both eyes holds the same texels.
    pub fn has_same_texels(&self, other: &Self) -> bool {
        let texels = |eye: &Self| std::array::from_fn::<_, LEVELS, _>(|level| eye.texel(level).0);
        self.frame == other.frame && self.cells == other.cells && texels(self) == texels(other)
    }

    /// Texel of the eye on a level, and how far into it the eye is, 0…1 texels.
    pub fn texel(&self, level: usize) -> ([i32; 2], [f32; 2]) {
        in_texels(self.at / TEXELS_M[level])
    }
}

/// A place in texels as a texel and the way into it.
fn in_texels(at: DVec2) -> ([i32; 2], [f32; 2]) {
    let whole = at.floor();
    ([whole.x as i32, whole.y as i32], (at - whole).as_vec2().to_array())
}

/// The first level that an eye whose nearest water has pixels `footprint_m` wide needs; `foam_share` in `shaders/lib/foam.wgsl`
/// reads no level whose texels are narrower than 1 / 2.5 of that.
pub fn finest_level(footprint_m: f64) -> usize {
    TEXELS_M.iter().position(|side| footprint_m < 2.5 * side).unwrap_or(LEVELS - 1)
}
