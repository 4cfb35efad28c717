//! The same sea on two threads of the CPU: heights and slopes by rustfft, and Perlin octaves with differences of four neighbours.

use std::sync::Arc;

use ocean_globe::model::noise;
use ocean_globe::model::waves::{self, Cascade};
use rustfft::num_complex::Complex32;
use rustfft::{Fft, FftPlanner};

pub const THREADS: usize = 2;
const OCTAVES: u32 = 4;
const FIRST_CELLS: usize = 8;
const GAIN: f32 = 0.5;

/// Calls `work` with the index and contents of every line, on all threads.
fn lines<T: Send>(data: &mut [T], width: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    let share = (data.len() / width).div_ceil(THREADS);
    std::thread::scope(|scope| {
        for (part, chunk) in data.chunks_mut(share * width).enumerate() {
            let work = &work;
            scope.spawn(move || chunk.chunks_mut(width).enumerate().for_each(|(i, line)| work(part * share + i, line)));
        }
    });
}

pub struct CpuSea {
    n: usize,
    dk: f32,
    h0: Vec<[f32; 2]>,
    cycles: Vec<u64>,
    plan: Arc<dyn Fft<f32>>,
    grids: [Vec<Complex32>; 2],
    turned: Vec<Complex32>,
    lattices: Vec<Vec<[f32; 2]>>,
    /// Height and two slopes of the noise.
    pub noise: Vec<[f32; 3]>,
    heights: Vec<f32>,
}

impl CpuSea {
    pub fn new(cascade: &Cascade, h0: &[[f64; 2]], omegas: &[f64]) -> Self {
        let n = cascade.n;
        let lattice = |octave: u32| {
            let cells = FIRST_CELLS << octave;
            let gradient = |index: usize| {
                let [x, y] = noise::gaussian_pair(1, octave, (index % cells) as i32, (index / cells) as i32);
                let length = x.hypot(y);
                [x / length, y / length].map(|x| x as f32)
            };
            (0..cells * cells).map(gradient).collect()
        };
        Self {
            n,
            dk: cascade.dk() as f32,
            h0: h0.iter().map(|h| h.map(|x| x as f32)).collect(),
            cycles: omegas.iter().map(|&omega| waves::cycles_per_tick(omega)).collect(),
            plan: FftPlanner::new().plan_fft_inverse(n),
            grids: std::array::from_fn(|_| vec![Complex32::default(); n * n]),
            turned: vec![Complex32::default(); n * n],
            lattices: (0..OCTAVES).map(lattice).collect(),
            noise: vec![[0.0; 3]; n * n],
            heights: vec![0.0; n * n],
        }
    }

    /// Heights and slopes at an instant.
    pub fn waves(&mut self, ticks: u64) {
        let Self { n, dk, h0, cycles, plan, grids, turned, .. } = self;
        let (n, dk) = (*n, *dk);
        let signed = |i: usize| if i < n / 2 { i as f32 } else { i as f32 - n as f32 };
        let evolved = |i: usize, j: usize| {
            let index = j * n + i;
            let mirror = h0[(n - j) % n * n + (n - i) % n];
            let phase = waves::phase_u32(cycles[index], ticks) as f32 * (std::f32::consts::TAU / 4_294_967_296.0);
            let turn = Complex32::cis(phase);
            Complex32::new(h0[index][0], h0[index][1]) * turn.conj() + Complex32::new(mirror[0], -mirror[1]) * turn
        };
        let [height, slopes] = grids;
        lines(height, n, |j, line| line.iter_mut().enumerate().for_each(|(i, h)| *h = evolved(i, j)));
        let (spectrum, plan) = (&*height, &*plan);
        lines(slopes, n, |j, line| {
            for (i, slope) in line.iter_mut().enumerate() {
                // hx and hy in one transform: i kx h + i (i ky h).
                *slope = Complex32::new(-signed(j) * dk, signed(i) * dk) * spectrum[j * n + i];
            }
        });
        for grid in grids {
            for _axis in 0..2 {
                lines(grid, n, |_, line| plan.process(line));
                let from = &*grid;
                // Sixteen lines of the result at a time: a whole cache line of each source row is used.
                lines(turned, 16 * n, |block, lines| {
                    for j in 0..n {
                        for (i, line) in lines.chunks_mut(n).enumerate() {
                            line[j] = from[j * n + block * 16 + i];
                        }
                    }
                });
                std::mem::swap(grid, turned);
            }
        }
    }

    /// Height, slope along x and along y as the last [`CpuSea::waves`] has left them.
    pub fn fields(&self) -> [Vec<f64>; 3] {
        let part = |grid: usize, part: fn(&Complex32) -> f32| {
            self.grids[grid].iter().map(|c| f64::from(part(c))).collect::<Vec<f64>>()
        };
        [part(0, |c| c.re), part(1, |c| c.re), part(1, |c| c.im)]
    }

    /// The octaves and their slopes, drifted by a share of the patch.
    pub fn perlin(&mut self, drift: f32) {
        let Self { n, lattices, noise, heights, .. } = self;
        let n = *n;
        lines(heights, n, |j, line| {
            for (i, height) in line.iter_mut().enumerate() {
                let mut amplitude = 1.0;
                *height = 0.0;
                for lattice in lattices.iter() {
                    *height += amplitude * gradient_noise(lattice, i as f32 / n as f32 + drift, j as f32 / n as f32);
                    amplitude *= GAIN;
                }
            }
        });
        let heights = &*heights;
        let scale = n as f32 / 2.0;
        lines(noise, n, |j, line| {
            for (i, out) in line.iter_mut().enumerate() {
                let at = |i: usize, j: usize| heights[j % n * n + i % n];
                *out = [at(i, j), scale * (at(i + 1, j) - at(i + n - 1, j)), scale * (at(i, j + 1) - at(i, j + n - 1))];
            }
        });
    }
}

/// Gradient noise at a place of the unit patch.
fn gradient_noise(lattice: &[[f32; 2]], x: f32, y: f32) -> f32 {
    let cells = lattice.len().isqrt();
    let (x, y) = (x * cells as f32, y * cells as f32);
    let (i, j) = (x as usize, y as usize);
    let (u, v) = (x - i as f32, y - j as f32);
    let fade = |t: f32| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let corner = |a: usize, b: usize| {
        let g = lattice[(j + b) % cells * cells + (i + a) % cells];
        g[0] * (u - a as f32) + g[1] * (v - b as f32)
    };
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    mix(mix(corner(0, 0), corner(1, 0), fade(u)), mix(corner(0, 1), corner(1, 1), fade(u)), fade(v))
}
