//! The least and the greatest value of a tile's texels, whole and in blocks.

use crate::data::TileTexels;
use crate::data::tile::TILE_TEXELS;
use crate::data::water::{STEPS_PER_TEXEL, unpacked};

/// Texels along a side of the smallest block.
const BLOCK: usize = 2;
/// Texels along a side of a block of inland waters.
const INLAND_BLOCK: usize = 16;

/// Least and greatest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub greatest: f64,
}

impl Range {
    /// What holds both.
    pub fn union(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), greatest: self.greatest.max(other.greatest) }
    }
}

/// A pyramid over one tile: of blocks of 2 x 2 texels, of 4 x 4, and so on to the whole tile.
pub struct TileRange {
    /// Least and greatest in steps, rounded outwards; row by row, the finest level first.
    levels: Vec<Vec<[i16; 2]>>,
    /// Of a step: metres of elevation, or texels of distance.
    step: f64,
    /// The greatest distance to an inland water's shore in blocks of [`INLAND_BLOCK`], steps; none of other tiles.
    inland: Vec<i16>,
}

impl TileRange {
    /// Of elevations in metres, or of distances to the ocean's shore in texels of the tile, positive in the ocean.
    pub fn new(texels: &TileTexels) -> Self {
        let (finest, step) = match texels {
            TileTexels::Terrain(metres) => (blocks(|at| [metres[at].floor() as i16, metres[at].ceil() as i16]), 1.0),
            TileTexels::Water(texels) => {
                let steps = |at: usize| [unpacked(texels[at]).0[0] as i16; 2];
                (blocks(steps), 1.0 / STEPS_PER_TEXEL)
            }
            // Nobody asks how bright a tile is.
            TileTexels::Imagery(_) => (blocks(|_| [0; 2]), 1.0),
        };
        let inland = if let TileTexels::Water(texels) = texels { inland(texels) } else { Vec::new() };
        let mut levels = vec![finest];
        let mut side = TILE_TEXELS / BLOCK;
        while side > 1 {
            side /= 2;
            let finer = &levels[levels.len() - 1];
            let of = |i: usize| {
                let corner = (i / side) * 4 * side + (i % side) * 2;
                [1, 2 * side, 2 * side + 1]
                    .iter()
                    .fold(finer[corner], |range, next| widened(range, finer[corner + next]))
            };
            let coarser = (0..side * side).map(of).collect();
            levels.push(coarser);
        }
        Self { levels, step, inland }
    }

    /// Of all texels between two, these included, and of some beside them: blocks are not cut. Columns and rows beyond the tile's
    /// edge count as the edge.
    pub fn between(&self, first: [i64; 2], last: [i64; 2]) -> Range {
        let inside = |at: i64| at.clamp(0, TILE_TEXELS as i64 - 1) as usize;
        let (first, last) = (first.map(inside), last.map(inside));
        let widest = (last[0] - first[0]).max(last[1] - first[1]);
        let level = (0..self.levels.len()).find(|level| widest <= 4 * (BLOCK << level)).unwrap_or(0);
        let (block, side) = (BLOCK << level, TILE_TEXELS / (BLOCK << level));
        let rows = first[1] / block..=last[1] / block;
        let blocks = rows.flat_map(|row| (first[0] / block..=last[0] / block).map(move |column| row * side + column));
        let [least, greatest] = blocks
            .map(|at| self.levels[level][at])
            .reduce(widened)
            .unwrap_or_default()
            .map(|x| f64::from(x) * self.step);
        Range { least, greatest }
    }

    /// The greatest distance to an inland water's shore, positive in it, as [`TileRange::between`]; minus infinity where none is told.
    pub fn inland(&self, first: [i64; 2], last: [i64; 2]) -> f64 {
        let blocks = |at: i64| at.clamp(0, TILE_TEXELS as i64 - 1) as usize / INLAND_BLOCK;
        let ([left, top], [right, bottom]) = (first.map(blocks), last.map(blocks));
        let side = TILE_TEXELS / INLAND_BLOCK;
        let rows = self.inland.chunks_exact(side).skip(top).take(bottom + 1 - top);
        let steps = rows.flat_map(|row| row.iter().skip(left).take(right + 1 - left)).max();
        steps.map_or(f64::NEG_INFINITY, |steps| f64::from(*steps) * self.step)
    }

    /// Of all texels.
    pub fn whole(&self) -> Range {
        self.between([0; 2], [TILE_TEXELS as i64 - 1; 2])
    }
}

fn inland(texels: &[[u8; 4]]) -> Vec<i16> {
    let side = TILE_TEXELS / INLAND_BLOCK;
    let mut greatest = vec![i16::MIN; side * side];
    for (at, texel) in texels.iter().enumerate() {
        let block = &mut greatest[at / TILE_TEXELS / INLAND_BLOCK * side + at % TILE_TEXELS / INLAND_BLOCK];
        *block = (*block).max(unpacked(*texel).0[1] as i16);
    }
    greatest
}

fn widened(a: [i16; 2], b: [i16; 2]) -> [i16; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The finest level, from what is known of each texel.
fn blocks(of: impl Fn(usize) -> [i16; 2]) -> Vec<[i16; 2]> {
    let side = TILE_TEXELS / BLOCK;
    let mut blocks = vec![[i16::MAX, i16::MIN]; side * side];
    for at in 0..TILE_TEXELS * TILE_TEXELS {
        let block = &mut blocks[(at / TILE_TEXELS / BLOCK) * side + at % TILE_TEXELS / BLOCK];
        *block = widened(*block, of(at));
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::water::packed;

    #[test]
    fn a_range_holds_every_texel_of_its_place() {
        let metres = |at: usize| ((at * 7919) % 20_011) as f32 * 0.7 - 9_000.0;
        let all: Vec<f32> = (0..TILE_TEXELS * TILE_TEXELS).map(metres).collect();
        let range = TileRange::new(&TileTexels::Terrain(all.clone()));
        for (first, last) in [([0, 0], [255, 255]), ([-3, 17], [40, 300]), ([8, 9], [8, 9]), ([100, 3], [131, 3])] {
            let found = range.between(first, last);
            let inside = |a: [i64; 2]| a.map(|x: i64| x.clamp(0, 255) as usize);
            let ([x0, y0], [x1, y1]) = (inside(first), inside(last));
            for (x, y) in (y0..=y1).flat_map(|y| (x0..=x1).map(move |x| (x, y))) {
                let value = f64::from(all[y * TILE_TEXELS + x]);
                assert!(found.least <= value && value <= found.greatest, "{first:?} to {last:?}: {value}, {found:?}");
            }
        }
        // One texel stands out, in each corner of a block and of the blocks above it.
        for bit in (0..8).map(|i| 1usize << i) {
            for [x, y] in [[bit, 0], [0, bit], [bit, bit], [255 - bit, 255]] {
                let mut flat = vec![0.0; TILE_TEXELS * TILE_TEXELS];
                flat[y * TILE_TEXELS + x] = 500.0;
                let range = TileRange::new(&TileTexels::Terrain(flat));
                let [column, row] = [x, y].map(|at| at as i64);
                assert_eq!(range.whole().greatest, 500.0, "{x}, {y}");
                assert_eq!(range.between([column - 9, row - 9], [column, row]).greatest, 500.0, "{x}, {y}");
            }
        }
        // A lake is found where it is, and nowhere else.
        let lake = |at: usize| packed([-900, if at == 100 * TILE_TEXELS + 40 { 7 } else { -500 }], 0);
        let water = TileRange::new(&TileTexels::Water((0..TILE_TEXELS * TILE_TEXELS).map(lake).collect()));
        let steps = |first, last| water.inland(first, last) * STEPS_PER_TEXEL;
        assert_eq!([steps([0; 2], [255; 2]), steps([39, 99], [41, 101]), steps([40, 100], [40, 100])], [7.0; 3]);
        assert_eq!([steps([0; 2], [31, 255]), steps([48, 0], [300, 255]), steps([-9, 112], [255, 255])], [-500.0; 3]);
        // The whole tile's is tight: rounded to a metre.
        let (least, greatest) = all.iter().fold((f32::MAX, f32::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
        assert_eq!(range.whole(), Range { least: least.floor().into(), greatest: greatest.ceil().into() });
    }
}
