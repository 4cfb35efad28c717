//! From a place on the map to the water that stands there: which patches move it, and the inversion of their chop.
//!
//! All of it follows `waves.wgsl`, `wave_patches.wgsl` and `domain.wgsl` of `shaders/lib`, in f64: the same cells, weights, patches and
//! linear interpolation between texels.

use std::ops::AddAssign;

use glam::{DMat3, DVec2, DVec3};

use super::earth::{self, Geodetic, WGS84};
use super::sea_tables::SeaTables;
use super::surface::ChopGradient;
use super::wave_domain::{self, Cell, Plane, cells_near};
use super::waves::CASCADES;

/// How the waves move a point at rest; in a patch's axes, or east and north.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Height η, m.
    pub height: f64,
    /// Horizontal displacement D before λ, m.
    pub shift: DVec2,
    /// ∇η at rest.
    pub slope: DVec2,
    /// ∂Dx/∂x, ∂Dy/∂y, ∂Dx/∂y.
    pub stretch: DVec3,
}

impl AddAssign for Motion {
    fn add_assign(&mut self, other: Self) {
        self.height += other.height;
        self.shift += other.shift;
        self.slope += other.slope;
        self.stretch += other.stretch;
    }
}

impl Motion {
    /// The motion in axes in which this one's are `x` and `y`, times `weight`.
    fn turned(self, x: DVec2, y: DVec2, weight: f64) -> Self {
        let s = self.stretch;
        Self {
            height: weight * self.height,
            shift: weight * (self.shift.x * x + self.shift.y * y),
            slope: weight * (self.slope.x * x + self.slope.y * y),
            stretch: weight
                * DVec3::new(
                    s.x * x.x * x.x + s.y * y.x * y.x + 2.0 * s.z * x.x * y.x,
                    s.x * x.y * x.y + s.y * y.y * y.y + 2.0 * s.z * x.y * y.y,
                    s.x * x.x * x.y + s.y * y.x * y.y + s.z * (x.x * y.y + x.y * y.x),
                ),
        }
    }

    /// The motion of waves that are `gain` times as high.
    pub fn gained(self, gain: f64) -> Self {
        let Self { height, shift, slope, stretch } = self;
        Self { height: gain * height, shift: gain * shift, slope: gain * slope, stretch: gain * stretch }
    }

    /// The choppy map's gradient at a λ.
    pub fn chop_gradient(&self, chop: f64) -> ChopGradient {
        ChopGradient::new(self.stretch.x, self.stretch.y, self.stretch.z, chop)
    }
}

/// A place on the ellipsoid with the cells around it. Points near it are metres east and north of it.
pub struct Place {
    foot: DVec3,
    ecef_from_enu: DMat3,
    cells: Vec<Cell>,
    /// Those that serve here, by their addresses, with the planes' axes as they are level here.
    serving: Vec<([i32; 3], Plane, [DVec2; 2])>,
    patches_m: [f64; CASCADES],
}

impl Place {
    /// The place at geodetic `lat` and `lon`, radians, in a sea under a wind from bearing `wind_from` (radians clockwise from north).
    pub fn new(tables: &SeaTables, wind_from: f64, lat: f64, lon: f64) -> Self {
        let ecef_from_enu = earth::ecef_from_enu(lat, lon);
        let enu_from_ecef = ecef_from_enu.transpose();
        let foot = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
        let cells = cells_near(lat, lon);
        let serving = wave_domain::blend(&cells, foot).into_iter().map(|(cell, _)| {
            let plane = Plane::new(cell, tables.sea.seed, wind_from);
            (cell.address, plane, plane.axes.map(|axis| (enu_from_ecef * axis).truncate()))
        });
        let patches_m = tables.cascades.map(|cascade| cascade.patch_m);
        Self { foot, ecef_from_enu, serving: serving.collect(), cells, patches_m }
    }

    /// The motion of the point at rest `rest` metres east and north. `patch` gives that of a cascade at its own coordinates, m.
    pub fn motion(&self, rest: DVec2, mut patch: impl FnMut(usize, DVec2) -> Motion) -> Motion {
        let point = self.foot + self.ecef_from_enu * rest.extend(0.0);
        let weights = wave_domain::blend(&self.cells, point);
        let mut sum = Motion::default();
        for (address, plane, [x, y]) in &self.serving {
            let Some(&(_, weight)) = weights.iter().find(|(found, _)| found.address == *address) else { continue };
            let at = plane.point(point);
            for (index, patch_m) in self.patches_m.into_iter().enumerate() {
                for placed in plane.placements(index, patch_m, at) {
                    let [along, left] = placed.axes.map(|axis| axis.x * *x + axis.y * *y);
                    sum += patch(index, placed.at).turned(along, left, weight * placed.weight);
                }
            }
        }
        sum
    }

    /// The rest point, metres east and north, whose chop λ carries it to this place, and its motion: r + λD(r) = 0.
    ///
    /// First by substitution, which leaves the local stretch, some 0.3, of the error each time and does not mind that short
    /// waves differ along the way; then by Newton's steps, which also converge where the crests are about to fold. Where they
    /// have folded and several points are over the place, it is one of them.
    pub fn invert(&self, chop: f64, patch: impl FnMut(usize, DVec2) -> Motion) -> (DVec2, Motion) {
        // A twentieth of a millimetre: nothing on a slope below 1.
        self.invert_from(DVec2::ZERO, chop, 5e-5, patch)
    }

    /// As [`Place::invert`], from a rest point that may be known to be near, until the water comes within `near_m` metres of the place.
    pub fn invert_from(
        &self,
        start: DVec2,
        chop: f64,
        near_m: f64,
        mut patch: impl FnMut(usize, DVec2) -> Motion,
    ) -> (DVec2, Motion) {
        const STEPS: usize = 30;
        let substitutions = if start == DVec2::ZERO { 6 } else { 0 };
        let mut rest = start;
        let mut best = (f64::INFINITY, rest, Motion::default());
        for step in 0..STEPS {
            let motion = self.motion(rest, &mut patch);
            let residual = rest + chop * motion.shift;
            if residual.length() < best.0 {
                best = (residual.length(), rest, motion);
            }
            if best.0 < near_m {
                break;
            }
            let gradient = motion.chop_gradient(chop);
            rest -= if step < substitutions || gradient.jacobian() < 0.1 {
                residual
            } else {
                let r = DVec2::new(
                    gradient.yy * residual.x - gradient.xy * residual.y,
                    gradient.xx * residual.y - gradient.xy * residual.x,
                );
                r / gradient.jacobian()
            };
        }
        (best.1, best.2)
    }
}

/// Where a patch coordinate in metres falls between samples: the lower index, within one period of `n`, and the way to the next,
/// 0 to 1. Sample i stands at i/n of `patch_m`.
pub fn between_samples(at: f64, patch_m: f64, n: usize) -> (usize, f64) {
    let x = at / patch_m * n as f64;
    let low = x.floor();
    ((low.rem_euclid(n as f64)) as usize % n, x - low)
}
