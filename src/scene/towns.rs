//! How far the ground about an eye lies in towns: two windows of Mercator's map, a fine and a coarse one, whose texels are the same wherever the eye is.

use crate::data::tile::{EQUATOR_M, Projection, map_from_lat_lon};
use crate::data::towns::{Town, towns};

/// Texels along a side of a window; equals `TOWN_SIDE` in `shaders/lib/built_up.wgsl`.
pub const SIDE: usize = 512;
/// log2 of the units of a texel, of which a side of the map has 2^32; as `TOWN_SHIFTS` there.
pub const SHIFTS: [u32; 2] = [15, 18];
/// A window moves by so many texels at a time.
const STEP: u32 = 64;
/// Of a window, along a side, by which it is known which tiles have towns.
const BLOCKS: usize = 64;
/// Towns as wide as this have the densest hearts, m, and the smallest so much of that.
const CITY_M: f64 = 5_000.0;
/// See [`CITY_M`].
const VILLAGE: f64 = 0.65;
/// Towns whose radius is less, texels, do not show in a window.
const LEAST_TEXELS: f64 = 0.6;

/// A town on Mercator's map.
struct OnMap {
    at: [u32; 2],
    /// Units.
    radius: f64,
    /// What the texel at its middle tells.
    heart: f64,
}

/// Texels about the eye.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// The north-western texel's, on the map, units.
    pub corner: [u32; 2],
    /// How far each lies in a town, 255 for the heart of a city; row by row from the north-west.
    pub texels: Vec<u8>,
    /// A bit for each block of a row that has some of a town.
    blocks: [u64; BLOCKS],
}

impl Window {
    fn new(towns: &[OnMap], corner: [u32; 2], shift: u32) -> Self {
        let unit = 1.0 / f64::from(1u32 << shift);
        let mut window = Self { corner, texels: vec![0; SIDE * SIDE], blocks: [0; BLOCKS] };
        for town in towns.iter().filter(|town| town.radius * unit >= LEAST_TEXELS) {
            let radius = town.radius * unit;
            // Of the texels' middles; the map goes round.
            let middle = [0, 1].map(|axis| f64::from(town.at[axis].wrapping_sub(corner[axis]) as i32) * unit - 0.5);
            let [columns, rows] = middle.map(|at| {
                let [first, end] =
                    [at - radius, at + radius + 1.0].map(|edge| edge.ceil().clamp(0.0, SIDE as f64) as usize);
                first..end
            });
            for y in rows {
                for x in columns.clone() {
                    let [dx, dy] = [x as f64 - middle[0], y as f64 - middle[1]];
                    let told = 255.0 * town.heart * (1.0 - (dx * dx + dy * dy) / (radius * radius));
                    let texel = &mut window.texels[y * SIDE + x];
                    *texel = (*texel).max(told as u8);
                    if told >= 1.0 {
                        window.blocks[y * BLOCKS / SIDE] |= 1 << (x * BLOCKS / SIDE);
                    }
                }
            }
        }
        window
    }

    /// Whether there is some of a town in a square of the map, or in the blocks beside it: its north-western corner and side in units, log2 of a texel's.
    pub fn has_town(&self, corner: [u32; 2], side: u64, shift: u32) -> bool {
        let block = (SIDE / BLOCKS) as i64;
        let [columns, rows] = [0, 1].map(|axis| {
            let first = i64::from(corner[axis].wrapping_sub(self.corner[axis]) as i32) >> shift;
            let last = first + (side >> shift) as i64;
            let [first, last] = [first.div_euclid(block) - 1, last.div_euclid(block) + 1];
            first.clamp(0, BLOCKS as i64)..(last + 1).clamp(0, BLOCKS as i64)
        });
        let mask = columns.fold(0u64, |mask, column| mask | 1 << column);
        rows.into_iter().any(|row| self.blocks[row as usize] & mask != 0)
    }
}

/// All towns on Mercator's map.
pub struct TownMap(Vec<OnMap>);

impl TownMap {
    /// The bundled ones.
    pub fn bundled() -> Self {
        let on_map = |town: Town| {
            let radius = town.radius_m / (EQUATOR_M * libm::cos(town.lat)) * 2f64.powi(32);
            let heart = VILLAGE + (1.0 - VILLAGE) * (town.radius_m / CITY_M).min(1.0);
            OnMap { at: units(town.lat, town.lon), radius, heart }
        };
        Self(towns().map(on_map).collect())
    }

    /// The finer (0) or the coarser (1) window about a place of Mercator's map, units.
    pub fn window(&self, index: usize, eye: [u32; 2]) -> Window {
        let shift = SHIFTS[index];
        Window::new(&self.0, corner_about(eye, shift), shift)
    }
}

/// A place of Mercator's map, units; latitude and longitude in radians.
pub fn units(lat: f64, lon: f64) -> [u32; 2] {
    let (x, y) = map_from_lat_lon(Projection::Mercator, lat, lon);
    [x, y].map(|part| (part * 2f64.powi(32)) as u32)
}

/// The corner of the window about a place, all in units; `shift`: log2 of a texel's.
pub fn corner_about(eye: [u32; 2], shift: u32) -> [u32; 2] {
    eye.map(|at| ((at >> shift) & !(STEP - 1)).wrapping_sub(SIDE as u32 / 2) << shift)
}
