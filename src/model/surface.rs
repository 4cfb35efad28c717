//! The water's surface from its amplitudes, in f64: what the GPU's transform must reproduce.
//!
//! Signs ([`waves`](super::waves) gives the rest): D = +i k/|k| coth kh H with X = x + λD, so that λ > 0 gathers points at the crests.

use super::{
    dispersion,
    fft::{self, Complex, mul},
    waves::{Patch, angular_frequencies, cycles_per_tick, phase_u32},
};

/// The fields of one patch at a moment, element (i, j) at j·n + i standing at (i/n, j/m) of the patch's lengths.
#[derive(Debug, Clone, PartialEq)]
pub struct Fields {
    /// Height η, m.
    pub eta: Vec<f64>,
    /// Displacement along x before λ, m.
    pub dx: Vec<f64>,
    /// Displacement along y before λ, m.
    pub dy: Vec<f64>,
    /// ∂η/∂x.
    pub eta_x: Vec<f64>,
    /// ∂η/∂y.
    pub eta_y: Vec<f64>,
    /// ∂Dx/∂x.
    pub dx_x: Vec<f64>,
    /// ∂Dy/∂y.
    pub dy_y: Vec<f64>,
    /// ∂Dx/∂y = ∂Dy/∂x.
    pub dx_y: Vec<f64>,
    /// ∂η/∂t, m/s.
    pub eta_t: Vec<f64>,
}

/// The fields of deep water at a tick of the wave clock: the phases are the GPU's own, to 2⁻³² of a cycle.
pub fn fields(h0: &[Complex], patch: impl Into<Patch>, ticks: u64) -> Fields {
    let patch = patch.into();
    let omega = angular_frequencies(patch, f64::INFINITY);
    fields_with(h0, patch, f64::INFINITY, &omega, |index| phase_at(cycles_per_tick(omega[index]), ticks))
}

/// The fields at a time in seconds over water `depth_m` deep (infinite: deep), for given frequencies, rad/s: for oracles with a dispersion of their own.
pub fn fields_at(h0: &[Complex], patch: impl Into<Patch>, depth_m: f64, omega: &[f64], t: f64) -> Fields {
    fields_with(h0, patch.into(), depth_m, omega, |index| omega[index] * t)
}

/// ωt in radians at a tick.
pub fn phase_at(cycles_per_tick: u64, ticks: u64) -> f64 {
    f64::from(phase_u32(cycles_per_tick, ticks)) / 4_294_967_296.0 * std::f64::consts::TAU
}

/// H(k) and ∂H/∂t at a phase ωt, from h0(k) and h0(−k).
pub fn evolve(h0: Complex, h0_minus: Complex, omega: f64, phase: f64) -> (Complex, Complex) {
    let (sin, cos) = libm::sincos(phase);
    let forward = mul(h0, [cos, -sin]);
    let backward = mul([h0_minus[0], -h0_minus[1]], [cos, sin]);
    let h = [forward[0] + backward[0], forward[1] + backward[1]];
    // −iω(forward − backward)
    let h_t = [omega * (forward[1] - backward[1]), -omega * (forward[0] - backward[0])];
    (h, h_t)
}

/// What makes up for the linear interpolation between the samples of a patch: between two of them, e^{ikx} with `cycles` = n/N of a
/// turn from one to the next has the mean square (2 + cos 2πn/N)/3, so this is the square root of its inverse. Along both axes, the
/// variance of an interpolated surface is then that of its waves.
pub fn interpolation_gain(cycles: f64) -> f64 {
    libm::sqrt(3.0 / (2.0 + libm::cos(std::f64::consts::TAU * cycles)))
}

/// [`interpolation_gain`] of an element of a patch, both axes together.
pub fn gain_of(patch: impl Into<Patch>, index: usize) -> f64 {
    let [n, m] = patch.into().samples;
    let axis = |i: usize, n: usize| interpolation_gain(i as f64 / n as f64);
    axis(index % n, n) * axis(index / n, m)
}

/// The eight drawn fields of a patch, two to a grid as real and imaginary part, element by element: (Dx, Dy), (η, ∂Dx/∂y),
/// (∂η/∂x, ∂η/∂y), (∂Dx/∂x, ∂Dy/∂y). D is i k̂ coth kh times η over water `depth_m` deep (infinite: deep). `gain` multiplies height and
/// displacement of a wave (by its element), see [`interpolation_gain`]; not their derivatives.
///
/// # Panics
/// If `h0` does not hold as many elements as the patch: both come from the same cascade.
pub fn packed_fields(
    h0: &[Complex],
    patch: impl Into<Patch>,
    depth_m: f64,
    gain: impl Fn(usize) -> f64,
    phase: impl Fn(usize) -> f64,
) -> [Vec<Complex>; 4] {
    let patch = patch.into();
    assert_eq!(h0.len(), patch.count(), "amplitudes are not those of the patch");
    let mut spectra: [Vec<Complex>; 4] = std::array::from_fn(|_| vec![[0.0; 2]; patch.count()]);
    for index in 0..patch.count() {
        let minus = h0[patch.mirror(index)];
        if h0[index] == [0.0; 2] && minus == [0.0; 2] {
            continue;
        }
        let (h, _) = evolve(h0[index], minus, 0.0, phase(index));
        let (kx, ky) = patch.wave_vector(index);
        let k = libm::sqrt(kx * kx + ky * ky);
        let per_k = if k > 0.0 { dispersion::orbit_ratio(k, depth_m) / k } else { 0.0 };
        let (ux, uy) = (per_k * kx, per_k * ky);
        let times_i = |s: f64| [-s * h[1], s * h[0]];
        let times = |s: f64| [s * h[0], s * h[1]];
        // a + ib of two Hermitian spectra: the transform brings both real fields at once.
        let pack = |a: Complex, b: Complex| [a[0] - b[1], a[1] + b[0]];
        let gain = gain(index);
        spectra[0][index] = pack(times_i(gain * ux), times_i(gain * uy));
        spectra[1][index] = pack(times(gain), times(-kx * uy));
        spectra[2][index] = pack(times_i(kx), times_i(ky));
        spectra[3][index] = pack(times(-kx * ux), times(-ky * uy));
    }
    spectra.iter_mut().for_each(|grid| fft::inverse_2d(grid, patch.samples[0]));
    spectra
}

fn fields_with(h0: &[Complex], patch: Patch, depth_m: f64, omega: &[f64], phase: impl Fn(usize) -> f64) -> Fields {
    let parts = |grid: Vec<Complex>| grid.into_iter().map(|[re, im]| (re, im)).unzip::<f64, f64, Vec<_>, Vec<_>>();
    let mut rates: Vec<Complex> =
        (0..patch.count()).map(|i| evolve(h0[i], h0[patch.mirror(i)], omega[i], phase(i)).1).collect();
    fft::inverse_2d(&mut rates, patch.samples[0]);
    let [(dx, dy), (eta, dx_y), (eta_x, eta_y), (dx_x, dy_y)] =
        packed_fields(h0, patch, depth_m, |_| 1.0, phase).map(parts);
    Fields { eta, dx, dy, eta_x, eta_y, dx_x, dy_y, dx_y, eta_t: parts(rates).0 }
}

/// ∂(X, Y)/∂(x, y) of the choppy map, as its three numbers (it is symmetric): 1 + λDx_x, 1 + λDy_y, λDx_y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChopGradient {
    /// 1 + λ ∂Dx/∂x.
    pub xx: f64,
    /// 1 + λ ∂Dy/∂y.
    pub yy: f64,
    /// λ ∂Dx/∂y.
    pub xy: f64,
}

impl ChopGradient {
    /// From the summed gradients of all cascades and λ. Sum first: the determinant of a sum is not a sum.
    pub fn new(dx_x: f64, dy_y: f64, dx_y: f64, chop: f64) -> Self {
        Self { xx: 1.0 + chop * dx_x, yy: 1.0 + chop * dy_y, xy: chop * dx_y }
    }

    /// The Jacobian J: area per area at rest; below 0 the surface has folded over.
    pub fn jacobian(&self) -> f64 {
        self.xx * self.yy - self.xy * self.xy
    }

    /// The smaller eigenvalue: below 0 exactly where the map folds along some direction.
    pub fn min_eigenvalue(&self) -> f64 {
        0.5 * (self.xx + self.yy) - libm::hypot(0.5 * (self.xx - self.yy), self.xy)
    }

    /// The slope of the displaced surface from the slopes at rest, (I + λ∇D)⁻ᵀ ∇η; not finite where J is 0.
    pub fn true_slope(&self, eta_x: f64, eta_y: f64) -> [f64; 2] {
        let j = self.jacobian();
        [(self.yy * eta_x - self.xy * eta_y) / j, (self.xx * eta_y - self.xy * eta_x) / j]
    }
}

impl Fields {
    /// The choppy map's gradient at an element, for this patch alone.
    pub fn chop_gradient(&self, index: usize, chop: f64) -> ChopGradient {
        ChopGradient::new(self.dx_x[index], self.dy_y[index], self.dx_y[index], chop)
    }
}
