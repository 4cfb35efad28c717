//! The periodic patches that a sea is summed from: their sizes, their grids and which wave numbers each of them holds.
//!
//! # Why four patches, and why always the same
//! One patch that holds the storm's kilometre waves has texels of metres. Four patches share the wave numbers in half-open rings
//! with independent noise, so their variances add, and no two lengths have a common multiple, so their sum does not repeat
//! with any of them. Their lengths depend on nothing: another wind changes amplitudes, but neither the waves' places on the
//! grid nor their frequencies, so that the sea changes smoothly with every setting. Rejected: lengths that follow the peak
//! (the sea jumps to another one as the wind changes), every patch carrying the whole spectrum (counts the same energy four
//! times) and cross-fades (need weights whose squares sum to one, and gain nothing in a sum of Gaussians).
//!
//! ```text
//!  k  0 ──────── 6 dk₂ ─────── 6 dk₃ ─────── 6 dk₄ ─────── 0.9 π N/patch₄
//!     |  5030 m   |    522 m    |   36.3 m    |   2.52 m    |  below the texels: mss_above
//! ```

/// How many patches a sea is made of.
pub const CASCADES: usize = 4;

/// Lengths of the patches, m. √93 and 15 − 0.618…: q times any ratio of two of them stays 0.159/q or more from a whole number for
/// q up to 8. The first holds five of the longest waves that any grade has; the last has texels below 1 cm from N = 256 on.
pub const PATCHES_M: [f64; CASCADES] =
    [FIRST_M, FIRST_M / RATIO_A, FIRST_M / RATIO_A / RATIO_B, { FIRST_M / RATIO_A / RATIO_B / RATIO_B }];
const FIRST_M: f64 = 5030.0;
const RATIO_A: f64 = 9.643_650_760_992_955;
const RATIO_B: f64 = 14.381_966_011_250_105;

/// A ring starts this many steps of its own patch from the origin: fewer would be too coarse to look random.
const RING_START: f64 = 6.0;
/// Share of a patch's highest wave number that is used; the rest would alias under the choppy displacement.
const USED_BAND: f64 = 0.9;

/// A periodic grid and a ring of wave numbers: `samples` over `patch_m` along x and y. The model takes any; a [`Cascade`] is
/// the square one that the GPU draws.
///
/// Element (i, j) stands at j·samples\[0\] + i; its wave vector is (n·dk\[0\], m·dk\[1\]) with n = i below half of the samples, else
/// i − samples\[0\], and m likewise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Samples along x and y, powers of two.
    pub samples: [usize; 2],
    /// Lengths along x and y, m.
    pub patch_m: [f64; 2],
    /// Its waves have k_min ≤ |k| < k_max, rad/m.
    pub k_min: f64,
    /// See `k_min`.
    pub k_max: f64,
}

impl Patch {
    /// Steps between wave numbers along x and y, rad/m.
    pub fn dk(&self) -> [f64; 2] {
        self.patch_m.map(|length| std::f64::consts::TAU / length)
    }

    /// How many elements it has.
    pub fn count(&self) -> usize {
        self.samples[0] * self.samples[1]
    }

    /// The signed wave indices of an element.
    pub fn signed(&self, index: usize) -> [i32; 2] {
        let at = |i: usize, n: usize| if i < n / 2 { i as i32 } else { i as i32 - n as i32 };
        [at(index % self.samples[0], self.samples[0]), at(index / self.samples[0], self.samples[1])]
    }

    /// The element of −k.
    pub fn mirror(&self, index: usize) -> usize {
        let [n, m] = self.samples;
        (m - index / n) % m * n + (n - index % n) % n
    }

    /// Whether the element is the mean or has no partner −k: row or column at half of the samples.
    pub fn is_alone(&self, index: usize) -> bool {
        let [n, m] = self.samples;
        index == 0 || index % n == n / 2 || index / n == m / 2
    }

    /// (kx, ky) of an element, rad/m.
    pub fn wave_vector(&self, index: usize) -> (f64, f64) {
        let ([n, m], [dx, dy]) = (self.signed(index), self.dk());
        (f64::from(n) * dx, f64::from(m) * dy)
    }

    /// (kx, ky) of every element, in order.
    pub fn wave_vectors(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let patch = *self;
        (0..patch.count()).map(move |index| patch.wave_vector(index))
    }
}

/// One square patch of waves, periodic over `patch_m`, and its ring of wave numbers. The GPU knows no other kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cascade {
    /// Samples along each side, a power of two.
    pub n: usize,
    /// Side, m.
    pub patch_m: f64,
    /// Its waves have k_min ≤ |k| < k_max, rad/m.
    pub k_min: f64,
    /// See `k_min`.
    pub k_max: f64,
}

impl From<&Cascade> for Patch {
    fn from(c: &Cascade) -> Self {
        Self { samples: [c.n; 2], patch_m: [c.patch_m; 2], k_min: c.k_min, k_max: c.k_max }
    }
}

impl Cascade {
    /// Step between wave numbers, rad/m.
    pub fn dk(&self) -> f64 {
        std::f64::consts::TAU / self.patch_m
    }

    /// (kx, ky) of every element, in order: see [`Patch`].
    pub fn wave_vectors(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        Patch::from(self).wave_vectors()
    }
}

/// The rings of the four patches, the longest first, with `n` samples along each side (a power of two, at least 32).
///
/// Each ring starts `RING_START` steps of its own patch from the origin. The longer patch reaches as far from n = 256 on; at
/// n = 128 the rings of the two shortest start at 4 steps, at n = 64 at 2, which still holds all the energy but looks coarse.
pub fn cascades(n: usize) -> [Cascade; CASCADES] {
    let highest = |i: usize| USED_BAND * std::f64::consts::PI * n as f64 / PATCHES_M[i];
    let edge = |i: usize| match i {
        0 => 0.0,
        CASCADES => highest(CASCADES - 1),
        _ => (RING_START * std::f64::consts::TAU / PATCHES_M[i]).min(highest(i - 1)),
    };
    std::array::from_fn(|i| Cascade { n, patch_m: PATCHES_M[i], k_min: edge(i), k_max: edge(i + 1) })
}
