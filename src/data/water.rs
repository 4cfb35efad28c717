//! Water tiles: what covers the ground, and how far the shores are, so that a coarse texel still gives a sharp coast.
//!
//! An archive holds polygons ([`super::coast`]), or pictures: 8-bit RGB PNGs, red the signed distance to the shore of the ocean (positive
//! in the ocean), green to the shore of lakes (positive in lakes and ponds), both `128 + round(16 d)` with d in texels of the tile (true
//! ground metres over ground metres per texel), clamped to ±127/16 texels, and never 128: above 128 is in, below is out. Blue is the
//! [`WaterClass`].
//!
//! At hand, a tile is four bytes a texel ([`packed`]): 32nds of a texel, with enough bits for 1,023 texels to the ocean and 255 to lakes. What is beyond the reach of a tile's own shores is taken from its parent ([`OwnShores::within`]), so that distances are as
//! good far away as near, at any level. Interpolation of a distance and its sign draw the shore at sub-texel precision.

use super::png_tile::{decode_rgb, encode_rgb};
use super::tile::{TILE_TEXELS, TileId};
use crate::error::{Error, Result};

/// Steps of a distance at hand per texel.
pub const STEPS_PER_TEXEL: f64 = 32.0;
/// Steps at hand of one step of a picture's distance.
const STEPS_OF_A_BYTE: i16 = 2;
/// The stored value of a picture that would lie exactly on the shore.
pub const SHORE: u8 = 128;
/// The largest distance that a tile's own shores or picture state, steps; this means "at least this".
pub const SATURATION_STEPS: i16 = 254;
/// The same, texels.
pub const SATURATION_TEXELS: f64 = SATURATION_STEPS as f64 / STEPS_PER_TEXEL;
/// The largest distances to the ocean's and the lakes' shores that a tile at hand can hold, steps.
pub const MOST_STEPS: [i32; 2] = [32_767, 8_191];
/// From this distance on, steps, the parent's counts more and more.
const BLENDED_FROM: i32 = 160;
/// From this distance on, steps, the parent's counts alone: a texel less than the saturation, so that there is no seam towards a neighbour
/// that does not exist since its shores are farther than that.
const BLENDED_TO: i32 = 216;

/// What covers the ground. GSHHG's levels in brackets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[repr(u8)]
pub enum WaterClass {
    /// Dry land (level 1).
    Land = 0,
    /// The ocean and the seas joined to it (level 0).
    Ocean = 1,
    /// Standing water: lakes (level 2) and ponds on islands (level 4).
    Lake = 2,
    /// An island in a lake (level 3).
    Island = 3,
    /// Running water: a river outside of lakes' polygons, which hold its widest stretches.
    River = 4,
}

impl WaterClass {
    /// The class of a stored byte; pictures hold no rivers.
    pub fn from_byte(byte: u8) -> Option<Self> {
        [Self::Land, Self::Ocean, Self::Lake, Self::Island].get(usize::from(byte)).copied()
    }

    /// Whether the ground lies under water.
    pub fn is_wet(self) -> bool {
        matches!(self, Self::Ocean | Self::Lake | Self::River)
    }
}

/// The stored byte of a signed distance in texels; never [`SHORE`], so that the sign survives.
pub fn byte_from_distance(texels: f64, inside: bool) -> u8 {
    let steps = (texels.abs() * STEPS_PER_TEXEL / f64::from(STEPS_OF_A_BYTE)).round().clamp(1.0, 127.0) as u8;
    if inside { SHORE + steps } else { SHORE - steps }
}

/// The signed distance in texels that a picture's byte stores.
pub fn distance_from_byte(byte: u8) -> f64 {
    (f64::from(byte) - f64::from(SHORE)) * f64::from(STEPS_OF_A_BYTE) / STEPS_PER_TEXEL
}

/// Mark of a texel at hand whose nearest inland water is a river.
pub const BY_RIVER: u8 = 1;
/// Mark of a texel at hand on an island in a lake.
pub const ON_ISLAND: u8 = 2;

/// A texel at hand: signed steps to the shores of the ocean and of inland waters, of which as much is kept as [`MOST_STEPS`] allows, and what
/// they do not tell: the marks [`BY_RIVER`] and [`ON_ISLAND`]. Red and alpha are the ocean's steps over 2^15, high and low byte; green and the
/// upper six bits of blue the inland waters' over 2^13; the lower two the marks.
pub fn packed([ocean, lake]: [i32; 2], marks: u8) -> [u8; 4] {
    let most = MOST_STEPS;
    let ocean = ocean.clamp(-most[0], most[0]) + 0x8000;
    let lake = lake.clamp(-most[1], most[1]) + 0x2000;
    [(ocean >> 8) as u8, (lake >> 6) as u8, ((lake & 63) << 2) as u8 | marks & 3, ocean as u8]
}

/// Signed steps to both shores, and the marks, of a texel at hand.
pub fn unpacked([r, g, b, a]: [u8; 4]) -> ([i32; 2], u8) {
    let [r, g, b4, a] = [r, g, b >> 2, a].map(i32::from);
    ([(r << 8 | a) - 0x8000, (g << 6 | b4) - 0x2000], b & 3)
}

/// What a tile's own shores or picture tell, 65,536 of each.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnShores {
    /// Signed steps to the shores of ocean and lakes, within ±[`SATURATION_STEPS`] and never zero.
    pub steps: Vec<[i16; 2]>,
    /// Each a [`WaterClass`].
    pub classes: Vec<u8>,
    /// Of each, whether the nearest inland water is a river; none of a tile without rivers.
    pub by_river: Vec<bool>,
}

impl OwnShores {
    /// The texels at hand of tile `id`. What is far is taken from the texels of its parent, which a tile of level 0 lacks. `Ocean` and
    /// lakes keep their side.
    pub fn within(&self, id: TileId, parent: Option<&[[u8; 4]]>) -> Vec<[u8; 4]> {
        let own = |at: usize| self.steps[at].map(i32::from);
        let marks = |at: usize| {
            let island = if self.classes[at] == WaterClass::Island as u8 { ON_ISLAND } else { 0 };
            if self.by_river.get(at) == Some(&true) { island | BY_RIVER } else { island }
        };
        let Some(parent) = parent.filter(|parent| parent.len() == TILE_TEXELS * TILE_TEXELS) else {
            return (0..self.steps.len()).map(|at| packed(own(at), marks(at))).collect();
        };
        let quarter = Quarter::of(parent, id);
        let texel = |at: usize| {
            let own = own(at);
            if own.iter().all(|steps| steps.abs() <= BLENDED_FROM) {
                return packed(own, marks(at));
            }
            let far = quarter.at(at % TILE_TEXELS, at / TILE_TEXELS);
            let steps = [0, 1].map(|shore| {
                let (near, far) = (own[shore].abs(), (own[shore].signum() * far[shore]).max(BLENDED_FROM));
                let share = (near - BLENDED_FROM).clamp(0, BLENDED_TO - BLENDED_FROM);
                let all = BLENDED_TO - BLENDED_FROM;
                own[shore].signum() * (near + ((far - near) * share + all / 2) / all)
            });
            // Whose shore is far the parent knows.
            let is_far = own[1] < -BLENDED_FROM && quarter.is_by_river(at % TILE_TEXELS, at / TILE_TEXELS);
            packed(steps, marks(at) | if is_far { BY_RIVER } else { 0 })
        };
        (0..self.steps.len()).map(texel).collect()
    }
}

/// The quarter of a parent that a tile covers.
struct Quarter {
    /// Its steps, with one texel around it. Beyond the parent's border they go on as they did.
    steps: Vec<[i32; 2]>,
    /// Whether the nearest inland water is a river.
    by_river: Vec<bool>,
}

impl Quarter {
    const SIDE: usize = TILE_TEXELS / 2 + 2;

    fn of(parent: &[[u8; 4]], id: TileId) -> Self {
        let corner = [id.x, id.y].map(|tile| (tile & 1) as i64 * (TILE_TEXELS / 2) as i64 - 1);
        let last = TILE_TEXELS as i64 - 1;
        let steps = |x: i64, y: i64| unpacked(parent[(y * (last + 1) + x) as usize]).0;
        let mut quarter = Vec::with_capacity(Self::SIDE * Self::SIDE);
        for at in 0..Self::SIDE * Self::SIDE {
            let [x, y] = [corner[0] + (at % Self::SIDE) as i64, corner[1] + (at / Self::SIDE) as i64];
            let [inner_x, inner_y] = [x, y].map(|at| at.clamp(0, last));
            let edge = steps(inner_x, inner_y);
            let before = steps(2 * inner_x - x, 2 * inner_y - y);
            quarter.push([0, 1].map(|shore| 2 * edge[shore] - before[shore]));
        }
        let marks = |at: usize| {
            let [x, y] = [corner[0] + (at % Self::SIDE) as i64, corner[1] + (at / Self::SIDE) as i64]
                .map(|at| at.clamp(0, last));
            unpacked(parent[(y * (last + 1) + x) as usize]).1 & BY_RIVER != 0
        };
        Self { steps: quarter, by_river: (0..Self::SIDE * Self::SIDE).map(marks).collect() }
    }

    /// The parent's mark of rivers at a texel of the tile.
    fn is_by_river(&self, column: usize, row: usize) -> bool {
        self.by_river[(row / 2 + 1) * Self::SIDE + column / 2 + 1]
    }

    /// The parent's distances at a texel of the tile, in steps of the tile.
    fn at(&self, column: usize, row: usize) -> [i32; 2] {
        let [x, y] = [column, row].map(|at| at.div_ceil(2));
        let [wx, wy] = [column, row].map(|at| if at % 2 == 0 { [1, 3] } else { [3, 1] });
        let mut sum = [0; 2];
        for (j, i) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let steps = self.steps[(y + j) * Self::SIDE + x + i];
            sum = [0, 1].map(|shore| sum[shore] + wx[i] * wy[j] * steps[shore]);
        }
        sum.map(|sum| (sum + 4) >> 3)
    }
}

/// What a picture of a water tile tells. `what` names the tile in errors.
///
/// # Errors
/// [`Error::BadData`] where the bytes are not an 8-bit RGB(A) PNG of 256 x 256 texels, or hold an unknown class.
pub fn decode(what: &str, bytes: &[u8]) -> Result<OwnShores> {
    let texels = decode_rgb(what, bytes)?;
    if let Some(at) = texels.iter().position(|t| WaterClass::from_byte(t[2]).is_none()) {
        let why = format!("texel {at} has water class {}", texels[at][2]);
        return Err(Error::bad_data(what, why, "the classes are 0 land, 1 ocean, 2 lake, 3 island"));
    }
    let steps = |byte: u8| STEPS_OF_A_BYTE * (i16::from(byte) - i16::from(SHORE)).max(-127);
    let side = |byte: u8| if byte == SHORE { 1 } else { steps(byte) };
    Ok(OwnShores {
        steps: texels.iter().map(|[r, g, _]| [side(*r), side(*g)]).collect(),
        classes: texels.iter().map(|texel| texel[2]).collect(),
        by_river: Vec::new(),
    })
}

/// The PNG of 65,536 texels.
///
/// # Errors
/// [`Error::BadData`] if there are not 65,536 texels.
pub fn encode(texels: &[[u8; 3]]) -> Result<Vec<u8>> {
    encode_rgb(texels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_survives_its_byte_and_never_loses_its_side() {
        for i in 0..2000 {
            let d = f64::from(i) * 0.005;
            for inside in [false, true] {
                let back = distance_from_byte(byte_from_distance(d, inside));
                assert_eq!(back > 0.0, inside, "{d}");
                // Half a step, or a whole one at the shore itself, where the value may not be zero.
                let tolerance = if d < 1.0 / 16.0 { 1.0 / 16.0 } else { 1.0 / 32.0 };
                let expected = d.min(SATURATION_TEXELS);
                assert!((back.abs() - expected).abs() <= tolerance + 1e-12, "{d} {back}");
            }
        }
    }

    #[test]
    fn of_a_far_bank_the_parent_knows_that_it_is_a_rivers() {
        // Dry land whose own shores are far, in a parent whose western half lies beside a river.
        let texels = TILE_TEXELS * TILE_TEXELS;
        let own = OwnShores {
            steps: vec![[-SATURATION_STEPS; 2]; texels],
            classes: vec![WaterClass::Land as u8; texels],
            by_river: Vec::new(),
        };
        let west = |at: usize| at % TILE_TEXELS < TILE_TEXELS / 4;
        let parent: Vec<_> = (0..texels).map(|at| packed([-900, -400], if west(at) { BY_RIVER } else { 0 })).collect();
        let id = TileId { projection: crate::data::tile::Projection::Mercator, z: 9, x: 10, y: 20 };
        let found = own.within(id, Some(&parent));
        for (at, texel) in found.into_iter().enumerate() {
            let (steps, marks) = unpacked(texel);
            assert_eq!(steps, [-1800, -800]);
            assert_eq!(marks == BY_RIVER, at % TILE_TEXELS < TILE_TEXELS / 2, "{at}");
        }
    }
}
