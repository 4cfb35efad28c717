//! The shape of the ground near a coast: a coarse elevation made to agree with a sharp shoreline.
//!
//! ```text
//!        land 2 m _______/¯   rises at m
//!  ocean ~~~~~~~~~~~~~~~/     planar face of slope m, then Dean's h = A d^⅔:  d = h/m + (h/A)^1.5
//!                   _.-'      over R a blend of the two depths, by their logarithms
//!  the grid _____.-'          d distance to the shore, h depth, R width of the grid's cells
//! ```
//! Elevation grids are minutes of arc wide, the shoreline is known to hundreds of metres. Near the shore the grid's cell mixes land and sea, so
//! its value is trusted only from one cell's width on, and where no cell about it is dry (in pixels from a quarter of a cell on shaders trust it all
//! the same: `COASTS_APART` in `shaders/lib/world.wgsl`); and in the sea it is that of wet texels alone. Closer, the bed is the profile that waves give to sand
//! ([Dean](crate::bibliography::Dean1991)): its A follows from the depth that the grid has off the coast, the grains from A, and the slope m of
//! the beach from the grains ([Sunamura](crate::bibliography::Sunamura1984)) under the waves of a usual climate, never those of the wind of the day. High
//! land and deep sea beside a coast make it steeper: rock, and no beach. `shaders/lib/shore_shape.wgsl` does the same in 32 bits.
//!
//! What the coast is like is told by the four cells of the grid around a place, wet and dry ones apart, weighed as in a bilinear interpolation: one
//! look at a coarse level, and no jump anywhere. Rejected: a look at the grid a cell off the shore (the way there jumps between two shores), slopes of
//! the interpolated grid (they jump at its texels), the grid's own values about the place (they do not reach as far as the sea from a broad beach).

/// Hermite's smooth step: 0 below `a`, 1 above `b`.
pub fn smoothstep(a: f64, b: f64, x: f64) -> f64 {
    let t = if b > a { ((x - a) / (b - a)).clamp(0.0, 1.0) } else { f64::from(x >= a) };
    t * t * (3.0 - 2.0 * t)
}

/// Least depth of the ocean off its shores, metres: where the grid has none of it (fjords, straits), and where it has.
pub const LEAST_M: [f64; 2] = [30.0, 4.0];
/// How steeply usual beaches fall from the waterline until the water is a metre deep, metres per metre: what a user's slope is measured by.
pub const USUAL_SLOPE: f64 = 0.03;
/// The ground rises from a shore with its beach up to this height, metres.
pub const BERM_M: f64 = 2.0;
/// Width of a texel of level 0 at the equator, metres.
pub const EQUATOR_TEXEL_M: f64 = std::f64::consts::TAU * 6_378_137.0 / 256.0;
/// Shares of the four values, below which wet or dry ones among them count for less than their mean.
pub const LEAST_SHARE: f64 = 0.25;

/// A of usual sand, m^⅓, off which the grid's sea is so deep, metres, a cell of so many metres from the shore; its cube root goes with the depth.
pub const DEAN: [f64; 3] = [0.1, 50.0, 9_277.0];
/// Least and greatest A of sand, m^⅓.
pub const SAND: [f64; 2] = [0.05, 0.25];
/// Shares of the grid's wet values about a place of the sea from which its own elevation is trusted, and is without reserve: where dry ones are beside
/// it grids have a coast that lies elsewhere, and between them and the deep an arc of shallows that are none.
pub const WET: [f64; 2] = [0.8, 1.0];
/// No farther from a shore the profile has a say, metres, however coarse the grid is.
pub const WIDEST_M: f64 = 20_000.0;
/// Slope of a coast, from the shore to a cell off it, at which its A is twice that of sand: rock begins to show through.
pub const ROCKY_SLOPE: f64 = 0.086;
/// How many times A of sand is added to that of a cliff, and the greatest A of all, m^⅓: 10 m deep 6 m off, if it were not for m.
pub const ROCK: [f64; 2] = [4.0, 3.0];
/// Slopes of the land within a cell of the shore between which a beach gives way to a cliff.
pub const CLIFF: [f64; 2] = [0.09, 0.15];
/// Slope of the bed and the ground at the foot of a cliff.
pub const CLIFF_SLOPE: f64 = 0.3;
/// Sines of the southern latitudes, 63° and 66°, between which shores become fronts of ice.
pub const ICE: [f64; 2] = [0.891, 0.914];
/// m of sand by its A: the line through [`sunamura`](super::sand::sunamura) of [`grain_mm`](super::sand::grain_mm), within 0.3 %.
pub const FACE: [f64; 2] = [0.0409, 0.304];

/// Level of the terrain's tiles whose texels are about as wide as cells of `resolution_m`, at the equator: what is looked at for [`Grid`].
pub fn grid_level(resolution_m: f64) -> u8 {
    libm::floor(libm::log2(EQUATOR_TEXEL_M / resolution_m.max(1.0))).max(0.0) as u8
}

/// From how far from a shore on a grid with cells of `resolution_m` is trusted, metres.
pub fn trusted_m(resolution_m: f64) -> f64 {
    resolution_m.min(WIDEST_M)
}

/// What a grid of elevations has around a place: its four cells, weighed as in a bilinear interpolation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Their mean, metres.
    pub elevation_m: f64,
    /// Mean depth, metres, where dry ones have none.
    pub depth_m: f64,
    /// Share of those below the sea's level.
    pub wet: f64,
}

impl Grid {
    /// Where all values are this one, metres.
    pub fn level(elevation_m: f64) -> Self {
        Self { elevation_m, depth_m: (-elevation_m).max(0.0), wet: f64::from(elevation_m < 0.0) }
    }

    /// Between the values of a row and of the next, so far on along them, 0 to 1.
    pub fn between(values: [f64; 4], [x, y]: [f64; 2]) -> Self {
        let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
        let among = |part: fn(Self) -> f64| {
            let [a, b, c, d] = values.map(|value| part(Self::level(value)));
            mix(mix(a, b, x), mix(c, d, x), y)
        };
        Self { elevation_m: among(|at| at.elevation_m), depth_m: among(|at| at.depth_m), wet: among(|at| at.wet) }
    }

    /// Depth of the sea around, metres.
    pub fn sea_m(self) -> f64 {
        self.depth_m / self.wet.max(LEAST_SHARE)
    }

    /// Elevation, metres, of a place so far from the ocean's shore, metres, positive in the ocean, where the four are the nearest values: there of the wet ones alone. Between a high coast and
    /// the deep lie values of neither, a texel off the shore, which would be an arc of shallows.
    pub fn elevation_at(self, ocean_shore_m: f64) -> f64 {
        if ocean_shore_m > 0.0 { -self.sea_m() } else { self.elevation_m }
    }

    /// Height of the land around, metres.
    pub fn land_m(self) -> f64 {
        (self.elevation_m + self.depth_m).max(0.0) / (1.0 - self.wet).max(LEAST_SHARE)
    }
}

/// How the ground falls from a coast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coast {
    /// A of Dean's profile, m^⅓.
    pub a: f64,
    /// Slope at the waterline.
    pub m: f64,
    /// 0 a beach, 1 a cliff or a front of ice.
    pub cliff: f64,
    /// How deep the profile goes, metres.
    pub deepest_m: f64,
    /// Depth off the coast, metres.
    pub far_m: f64,
    /// Least depth of the water off it, metres.
    pub least_m: f64,
    /// How far the grid's own values are trusted where they are far from the shore, 0 to 1: by [`WET`].
    pub trust: f64,
}

impl Coast {
    /// Where a grid with cells of `resolution_m` has this, at a latitude of this sine.
    pub fn new(grid: Grid, resolution_m: f64, sin_lat: f64) -> Self {
        let (sea_m, land_m, cell_m) = (grid.sea_m(), grid.land_m(), resolution_m.max(1.0));
        let least_m = LEAST_M[0] + (LEAST_M[1] - LEAST_M[0]) * smoothstep(0.0, 0.5, grid.wet);
        // A coast goes on below the water as it is above.
        let off_m = sea_m + land_m;
        // As deep as Dean's profile is a cell of the usual grid from the shore.
        let usual_m = off_m * libm::pow(DEAN[2] / cell_m, 2.0 / 3.0);
        let sand = (DEAN[0] * libm::cbrt(usual_m / DEAN[1])).clamp(SAND[0], SAND[1]);
        let ice = smoothstep(ICE[0], ICE[1], -sin_lat);
        let cliff = smoothstep(CLIFF[0], CLIFF[1], 2.0 * land_m / cell_m).max(ice);
        let steep = off_m / (ROCKY_SLOPE * cell_m);
        let face = FACE[0] + FACE[1] * sand;
        Self {
            a: (sand * (1.0 + steep * steep + ROCK[0] * cliff)).min(ROCK[1]),
            m: face + (CLIFF_SLOPE - face) * cliff,
            cliff,
            deepest_m: off_m.max(least_m),
            far_m: sea_m,
            least_m,
            trust: smoothstep(WET[0], WET[1], grid.wet),
        }
    }

    /// Slope of the beach where usual ones fall by `slope`.
    pub fn beach(&self, slope: f64) -> f64 {
        slope / USUAL_SLOPE * self.m
    }

    /// How far from the shore the profile is `h` m deep: h/m + (h/A)^1.5, m.
    pub fn distance_m(&self, h: f64) -> f64 {
        h / self.m + libm::pow(h / self.a, 1.5)
    }

    /// How deep the profile is `d` m from the shore, m: with h = A³/m² s², s² + s³ = d (m/A)³. From above Newton's steps stay above, and four leave 1e-9.
    pub fn profile_m(&self, d: f64) -> f64 {
        let ratio = self.m / self.a;
        let q = (d * ratio * ratio * ratio).max(1e-12);
        let mut s = libm::sqrt(q).min(libm::cbrt(q));
        for _ in 0..4 {
            s -= (s * s * (1.0 + s) - q) / (s * (2.0 + 3.0 * s));
        }
        self.a / (ratio * ratio) * s * s
    }

    /// Depth `d` m from the shore, m, over ground that the grid has at `elevation_m`, where the bed is `steeper` times as steep as by nature.
    pub fn depth_m(&self, d: f64, elevation_m: f64, resolution_m: f64, steeper: f64) -> f64 {
        let trusted_m = trusted_m(resolution_m);
        let w = smoothstep(0.1 * trusted_m, trusted_m, d);
        // Nearer, the place's own value is partly land, and so it is far from the shore where the grid has a coast all the same.
        let own = w * (1.0 - w * w * w * (1.0 - self.trust));
        let far_m = (self.far_m + (-elevation_m - self.far_m) * own).max(self.least_m);
        if w >= 1.0 {
            return far_m;
        }
        let near_m = (steeper * self.profile_m(d)).min(self.deepest_m);
        near_m * libm::pow(far_m / near_m.max(0.1), w)
    }
}

/// As [`shaped_on`], at the equator in the midst of a level grid, on beaches of the [`USUAL_SLOPE`].
pub fn shaped_elevation(elevation_m: f64, ocean_shore_m: f64, resolution_m: f64) -> f64 {
    shaped_on(elevation_m, Grid::level(elevation_m), ocean_shore_m, [resolution_m, USUAL_SLOPE], 0.0)
}

/// Elevation in metres, shaped so that it is below zero in the ocean and meets zero at the shore.
///
/// * `elevation_m`: the grid's value, as [`Grid::elevation_at`] has it.
/// * `grid`: what it has around the place, of the level of [`grid_level`].
/// * `ocean_shore_m`: signed distance to the ocean's shore, positive in the ocean.
/// * `resolution_m`: how wide a cell of the elevation's source is.
/// * `slope`: how steeply beaches fall where they usually do by [`USUAL_SLOPE`]: all depths of the profile go with it.
/// * `sin_lat`: sine of the latitude.
///
/// In the ocean the bed is [`Coast`]'s, farther off than a cell the grid's, with some least water. Land rises as steeply as the beach up to 2 m;
/// ground below sea level (polders, the Dead Sea) stays below, and meets zero at the ocean's shore.
pub fn shaped_on(
    elevation_m: f64,
    grid: Grid,
    ocean_shore_m: f64,
    [resolution_m, slope]: [f64; 2],
    sin_lat: f64,
) -> f64 {
    let (d, steeper) = (ocean_shore_m.abs(), slope / USUAL_SLOPE);
    let coast = Coast::new(grid, resolution_m, sin_lat);
    if ocean_shore_m > 0.0 {
        return -coast.depth_m(d, elevation_m, resolution_m, steeper);
    }
    let scaled = elevation_m * smoothstep(0.0, resolution_m / 3.0, d);
    if elevation_m < 0.0 {
        return scaled;
    }
    // Where the grid is below the sea there is no berm, and beside that a low one.
    scaled.max((coast.beach(slope) * d).min(BERM_M * smoothstep(0.0, 1.0, elevation_m)))
}
