//! The lace of foam: one tile of it, made once, that the drawn water carries in several sizes.
//!
//! Foam that decays is a net: bubbles gather along lines between patches of water that wells up. The walls between the cells of a
//! Voronoi diagram ([Worley](crate::bibliography::Worley1996): its second distance less its first) have that shape; the tile sums those
//! of three sizes of cells, on ground that smooth noise bends.
//!
//! # Why a normal level?
//! A share s of the water is covered where the level g lies above a threshold. With g normal that is −Φ⁻¹(s), sums of tiles of any sizes
//! are normal again, and what a pixel cannot show of g is one number, the variance h that is left of it: the pixel is covered by
//! Φ((g + Φ⁻¹(s))/√h), whose mean over the water is s, whatever the pixel is wide. `shaders/lib/lace.wgsl` does that. Rejected: a
//! uniform level, equalised in every mip level. It keeps the share on texels alone, not between them, and makes specks of what should be
//! grey.

use std::sync::OnceLock;

use super::noise;

/// Texels along a side.
pub const TEXELS: usize = 512;
/// Mip levels.
pub const MIPS: usize = TEXELS.ilog2() as usize + 1;
/// Level that the greatest byte stands for, in deviations; the least stands for its negative.
pub const GREATEST_LEVEL: f32 = 3.5;
/// Slope of the level that the greatest byte stands for, per texel.
pub const GREATEST_SLOPE: f32 = 1.0;

/// Cells along a side and how much their walls count.
const NETS: [(usize, f32); 3] = [(7, 1.0), (19, 0.7), (53, 0.42)];
/// Cells along a side of the noise that bends the ground, and by how much, tiles.
const BENDS: [(usize, f32); 2] = [(6, 0.05), (17, 0.014)];
/// As [`NETS`], of the noise that makes some walls thicker than others, and breaks them.
const UNEVEN: [(usize, f32); 3] = [(5, 0.8), (13, 0.75), (37, 0.3)];
/// Steps of the distribution function that is taken.
const BINS: usize = 1 << 12;

/// Uniform numbers, −½…½, of the cells of a torus, from `beyond` cells before the tile to as many after it, so that no index wraps.
fn lattice(cells: usize, beyond: usize, salt: u32) -> Vec<f32> {
    let row = cells + 2 * beyond;
    let number = |k: usize| {
        let [i, j] = [k % row, k / row].map(|cell| ((cell + cells - beyond) % cells) as u32);
        (noise::hash([i, j, salt]) >> 8) as f32 / (1u32 << 24) as f32 - 0.5
    };
    (0..row * row).map(number).collect()
}

/// Smooth noise, −½…½, on a torus.
struct Smooth {
    cells: usize,
    /// With a cell beyond the tile.
    lattice: Vec<f32>,
}

impl Smooth {
    fn new(cells: usize, salt: u32) -> Self {
        Self { cells, lattice: lattice(cells, 1, salt) }
    }

    /// The noise at a place in tiles, 0…1.
    fn at(&self, at: [f32; 2]) -> f32 {
        let [x, y] = at.map(|k| k * self.cells as f32 + 1.0);
        let (i, j) = (x as usize, y as usize);
        let ease = |t: f32| t * t * (3.0 - 2.0 * t);
        let (u, v) = (ease(x - i as f32), ease(y - j as f32));
        let row = |j: usize| {
            let first = j * (self.cells + 2) + i;
            self.lattice[first] + (self.lattice[first + 1] - self.lattice[first]) * u
        };
        row(j) + (row(j + 1) - row(j)) * v
    }
}

/// A Voronoi diagram on a torus: one point in each cell of a square grid.
struct Net {
    cells: usize,
    /// Places in cells, from the first one's corner. The cells go on for [`BEYOND`] before and after the tile, so that no index wraps.
    points: Vec<[f32; 2]>,
}

/// Cells that a net goes on beyond the tile: those that are searched around a place that [`BENDS`] takes off the tile.
const BEYOND: usize = 4;

impl Net {
    fn new(cells: usize, salt: u32) -> Self {
        let [x, y] = [salt, salt + 1].map(|salt| lattice(cells, BEYOND, salt));
        let row = cells + 2 * BEYOND;
        let place = |cell: usize, offset: f32| cell as f32 + 0.5 + 0.9 * offset;
        Self { cells, points: (0..row * row).map(|k| [place(k % row, x[k]), place(k / row, y[k])]).collect() }
    }

    /// Root of how much farther the second nearest point is than the nearest, in cells: 0 on the walls, and steep there. The place
    /// is in tiles, not farther off the tile than [`BENDS`] takes it.
    fn wall(&self, at: [f32; 2]) -> f32 {
        let row = self.cells + 2 * BEYOND;
        let [x, y] = at.map(|k| k * self.cells as f32 + BEYOND as f32);
        let (i, j) = (x as usize, y as usize);
        let (mut first, mut second) = (f32::MAX, f32::MAX);
        for points in self.points.chunks_exact(row).skip(j - 1).take(3) {
            for [px, py] in &points[i - 1..i + 2] {
                let (dx, dy) = (px - x, py - y);
                let square = dx * dx + dy * dy;
                second = second.min(first.max(square));
                first = first.min(square);
            }
        }
        (second.sqrt() - first.sqrt()).sqrt()
    }
}

/// Level of every texel, standard normal, row by row. Only exact operations of f32 and libm: the same on every platform.
pub fn levels() -> Vec<f32> {
    let nets: Vec<_> = NETS.iter().zip(0..).map(|(&(cells, weight), k)| (Net::new(cells, 10 * k), weight)).collect();
    let bend =
        |(&(cells, by), k): (&(usize, f32), u32)| ([0, 1].map(|axis| Smooth::new(cells, 100 + 10 * k + axis)), by);
    let bends: Vec<_> = BENDS.iter().zip(0..).map(bend).collect();
    let uneven: Vec<_> =
        UNEVEN.iter().zip(200..).map(|(&(cells, weight), salt)| (Smooth::new(cells, salt), weight)).collect();
    let level = |k: usize| {
        let at = [k % TEXELS, k / TEXELS].map(|k| (k as f32 + 0.5) / TEXELS as f32);
        let mut bent = at;
        for (axes, by) in &bends {
            for (place, axis) in bent.iter_mut().zip(axes) {
                *place += by * axis.at(at);
            }
        }
        let walls: f32 = nets.iter().map(|(net, weight)| weight * net.wall(bent)).sum();
        let thickness: f32 = uneven.iter().map(|(noise, weight)| weight * noise.at(at)).sum();
        thickness - walls
    };
    let mut field: Vec<f32> = (0..TEXELS * TEXELS).map(level).collect();
    made_normal(&mut field);
    field
}

/// Gives a field the standard normal distribution, keeping its order.
fn made_normal(field: &mut [f32]) {
    let (low, high) = field.iter().fold((f32::MAX, f32::MIN), |(low, high), &x| (low.min(x), high.max(x)));
    let bin = |x: f32| (x - low) / (high - low) * (BINS as f32 * 0.999_999);
    let mut below = vec![0u32; BINS + 1];
    for &x in field.iter() {
        below[bin(x) as usize + 1] += 1;
    }
    for i in 0..BINS {
        below[i + 1] += below[i];
    }
    // Half a texel is left beyond either end.
    let count = field.len() as f64;
    let normal: Vec<f32> =
        below.iter().map(|&below| quantile((f64::from(below).clamp(0.5, count - 0.5)) / count) as f32).collect();
    for x in field {
        let at = bin(*x);
        let (low, high) = (normal[at as usize], normal[at as usize + 1]);
        *x = low + (high - low) * (at - at.floor());
    }
}

/// The standard normal quantile Φ⁻¹(p), 0 < p < 1, within 4.5e-4 ([Abramowitz and Stegun](crate::bibliography::AbramowitzStegun1964),
/// 26.2.23).
pub fn quantile(p: f64) -> f64 {
    let t = libm::sqrt(-2.0 * libm::log(p.min(1.0 - p)));
    let tail = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    if p < 0.5 { -tail } else { tail }
}

/// Texels of all mip levels, the finest first: the level, its slopes along the row and along the column in texels of the finest, and the
/// variance of the level that the mip level keeps (0…1; 1 is the whole). Made when they are first asked for.
pub fn texels() -> &'static [Vec<[u8; 4]>] {
    static TEXELS: OnceLock<Vec<Vec<[u8; 4]>>> = OnceLock::new();
    TEXELS.get_or_init(made)
}

fn made() -> Vec<Vec<[u8; 4]>> {
    let level = levels();
    let at = |i: usize, j: usize| level[j % TEXELS * TEXELS + i % TEXELS];
    let slopes = |k: usize| {
        let (i, j) = (k % TEXELS, k / TEXELS);
        let x = 0.5 * (at(i + 1, j) - at(i + TEXELS - 1, j));
        let y = 0.5 * (at(i, j + 1) - at(i, j + TEXELS - 1));
        [level[k], x, y]
    };
    let mut mip: Vec<[f32; 3]> = (0..TEXELS * TEXELS).map(slopes).collect();
    let mut side = TEXELS;
    let mut mips = Vec::with_capacity(MIPS);
    loop {
        mips.push(encoded(&mip, side));
        if side == 1 {
            return mips;
        }
        let half = side / 2;
        let mean = |k: usize| {
            let corner = 2 * (k / half) * side + 2 * (k % half);
            let four = [corner, corner + 1, corner + side, corner + side + 1].map(|k| mip[k]);
            std::array::from_fn(|channel| 0.25 * four.iter().map(|texel| texel[channel]).sum::<f32>())
        };
        mip = (0..half * half).map(mean).collect();
        side = half;
    }
}

/// Variance between the texels of a mip level, linearly interpolated: on each axis two thirds of a texel's own variance and a third of its
/// covariance with the next.
fn kept_variance(level: &[f32], side: usize) -> f32 {
    let covariance = |di: usize, dj: usize| {
        // Sides are powers of two.
        let next = |k: usize| ((k / side + dj) & (side - 1)) * side + ((k + di) & (side - 1));
        (0..side * side).map(|k| f64::from(level[k] * level[next(k)])).sum::<f64>() / (side * side) as f64
    };
    let diagonal = 0.5 * (covariance(1, 1) + covariance(1, side - 1));
    ((4.0 * covariance(0, 0) + 2.0 * (covariance(0, 1) + covariance(1, 0)) + diagonal) / 9.0).clamp(0.0, 1.0) as f32
}

/// The bytes of a mip level. Means of walls and holes have shorter tails than a normal number: the level is made normal again, with the
/// variance that it has. 128 is 0, so that flat foam is flat.
fn encoded(mip: &[[f32; 3]], side: usize) -> Vec<[u8; 4]> {
    let mut level: Vec<f32> = mip.iter().map(|texel| texel[0]).collect();
    let deviation = (level.iter().map(|x| f64::from(x * x)).sum::<f64>() / level.len() as f64).sqrt() as f32;
    if side > 1 && side < TEXELS {
        made_normal(&mut level);
        level.iter_mut().for_each(|x| *x *= deviation);
    }
    let kept = (255.0 * kept_variance(&level, side)).round() as u8;
    let byte = |value: f32, greatest: f32| (128.0 + (127.0 * (value / greatest).clamp(-1.0, 1.0)).round()) as u8;
    let texel = |(level, slope): (&f32, &[f32; 3])| {
        [byte(*level, GREATEST_LEVEL), byte(slope[1], GREATEST_SLOPE), byte(slope[2], GREATEST_SLOPE), kept]
    };
    level.iter().zip(mip).map(texel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_of_the_tile_lies_above_its_threshold() {
        let level = levels();
        for share in [0.003, 0.01, 0.1, 0.3, 0.5, 0.8, 0.97] {
            let threshold = -quantile(share) as f32;
            let found = level.iter().filter(|level| **level > threshold).count() as f64 / level.len() as f64;
            // The quantile is within 4.5e-4, which is less than 2e-4 of the water.
            assert!((found - share).abs() < 3e-4, "{found} of {share}");
        }
    }

    #[test]
    fn the_tile_has_no_edge() {
        let level = levels();
        let at = |i: usize, j: usize| level[j % TEXELS * TEXELS + i % TEXELS];
        let step = |i: usize, turned: bool| {
            let change = |j| if turned { at(j, i + 1) - at(j, i) } else { at(i + 1, j) - at(i, j) };
            (0..TEXELS).map(|j| change(j).powi(2)).sum::<f32>()
        };
        for turned in [false, true] {
            let steepest = (0..TEXELS - 1).map(|i| step(i, turned)).fold(0.0, f32::max);
            assert!(step(TEXELS - 1, turned) < steepest, "{} of {steepest}", step(TEXELS - 1, turned));
        }
    }

    #[test]
    fn mip_levels_keep_ever_less_of_the_level() {
        let mips = texels();
        assert_eq!(mips.len(), MIPS);
        let kept: Vec<u8> = mips.iter().map(|texels| texels[0][3]).collect();
        println!("{kept:?}");
        assert!(kept[0] > 245 && kept[MIPS - 1] == 0 && kept.windows(2).all(|pair| pair[1] < pair[0] || pair[1] == 0));
    }
}
