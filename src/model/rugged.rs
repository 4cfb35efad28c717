//! How much relief a place has that its elevation data do not hold ([`super::relief`]), as those data themselves tell: the more they vary
//! around it.
//!
//! Plains, shores, lakes, land below the sea and ice sheets have none, but for islands that the data have lost, drowned hills among them: these are raised. `shaders/lib/rugged.wgsl` is the same in single precision.

use super::relief::GULLIED_M;
use super::sea_bed::smoothstep;
use super::towers;

/// Level of the terrain tiles that is looked at wherever the eye is, so that nothing moves with it: the deepest that is there all over the
/// bundled world. Texels are 9.8 km wide at the equator, as the data's own.
pub const LEVEL: u8 = 4;

/// Strength for the data's slope, metres: real mountains vary by 300 m within data cells that differ by a twentieth of their width.
pub const GAIN_M: f64 = 17_000.0;
/// Strength for what an island is raised by.
pub const LIFT_GAIN: f64 = 1.0;
/// It grows no more far beyond this.
pub const MOST_M: f64 = 1_800.0;
/// Slopes below this are none.
pub const LEAST_SLOPE: f64 = 0.001;
/// Ground no higher than the sea has no relief; from this height on it has all of it, metres.
pub const LOW_M: f64 = 2.0;
/// Strength of what lies low, of the height over the sea.
pub const OF_HEIGHT: f64 = 1.2;
/// At steep coasts, where the ground is lowered to meet the shore, of this much of the data's mean.
pub const OF_MEAN: f64 = 0.5;
/// Slope that is none on an ice sheet.
pub const ICE_SLOPE: f64 = 0.02;
/// How far from the ocean's shore the relief is whole, metres; from a lake's.
pub const OCEAN_FADE_M: f64 = 700.0;
/// See [`OCEAN_FADE_M`].
pub const LAKE_FADE_M: f64 = 700.0;
/// Sine of the latitude where the polar maps begin, whose data are others: there is no relief, so that no step shows.
pub const SEAM_SIN_LAT: f64 = 0.994_521_895_368_273_3;
/// Sine from there on which the relief is whole: 0.2 degrees.
pub const SEAM_FADE: f64 = 3.7e-4;
/// No summit is made higher than this, metres.
pub const HIGHEST_M: f64 = 9_000.0;

/// Level of the terrain tiles that tells islands in a deep sea.
pub const ISLAND_LEVEL: u8 = 1;
/// Level of the water tiles whose distances tell how far inland a place is, smoothly.
pub const SHORE_LEVEL: u8 = 5;
/// Sines of 48 and 52 degrees, between which islands on shelves begin to be raised: from there on ice has left rock on most of these, and deep
/// water beside it.
pub const HIGH_LATITUDES: [f64; 2] = [0.743, 0.788];
/// Level of the terrain tiles whose mean, of land and sea together, tells how deep such a shelf is.
pub const SHELF_LEVEL: u8 = 0;
/// How far below the sea that mean is where they begin to be raised, and are, metres: in shallower seas low land is sand and marsh.
pub const SHELF_M: [f64; 2] = [65.0, 95.0];
/// How much the heights of that level deviate where coasts begin to be ones that ice has scoured, and are, metres: glaciers have come down from mountains
/// there, and left rock, also where the shelf is not so deep.
pub const BOLD_M: [f64; 2] = [50.0, 100.0];
/// Mean heights of the data between which these know the land, metres.
pub const KNOWN_M: [f64; 2] = [10.0, 200.0];
/// How steep they are, of islands in a deep sea.
pub const SHELF: f64 = 0.8;
/// They are flat far beyond this from their shores, metres: the data know wider ones.
pub const ROCKY_WIDE_M: f64 = 2_500.0;
/// How steep islands in a deep sea are at least.
pub const ISLAND_RISE: f64 = 0.17;
/// They are flat far beyond this from their shores, metres.
pub const ISLAND_WIDE_M: f64 = 9_000.0;
/// How softly they leave the data's ground, metres.
pub const ISLAND_SOFT_M: f64 = 100.0;

/// Level of the terrain tiles whose heights tell of hills about drowned ones: texels are 39 km wide at the equator.
pub const DROWNED_LEVEL: u8 = 2;
/// How much they deviate there where there begin to be drowned hills, and are, metres: less about lagoons and skerries before a plain.
pub const DROWNED_HILLS_M: [f64; 2] = [45.0, 65.0];
/// Mean elevations of [`ISLAND_LEVEL`], land and sea together, metres, of coasts that have none and may have some: before a deep sea lie cays and sandbanks.
pub const DROWNED_SEA_M: [f64; 2] = [-120.0, -20.0];
/// Level of the water tiles that tell how broken a coast is: texels are 2.4 km wide at the equator.
pub const DROWNED_SHORE_LEVEL: u8 = 6;
/// How much the distances to the shore deviate there, in those texels, where a coast is so broken, and where it no longer is: by .5 along a straight one, by .3 on a
/// bar of sand.
pub const DROWNED_BROKEN: [f64; 2] = [0.2, 0.3];
/// How far inland of a smoothed shore that is so, in those texels: all, and none.
pub const DROWNED_INLAND: [f64; 2] = [1.0, 2.4];
/// Sines of 24 and 28 degrees: towards the equator rock weathers to towers and domes.
pub const TOWERS: [f64; 2] = [0.407, 0.469];
/// How steep drowned hills are, and towers.
pub const DROWNED_RISE: [f64; 2] = [0.3, 1.6];
/// They are level far beyond this from their shores, metres.
pub const DROWNED_WIDE_M: f64 = 110.0;
/// Between their shores and this far inland they begin to rise, metres: the smallest are rocks and cays.
pub const DROWNED_FOOT_M: f64 = 60.0;
/// How far from a lake's or a river's shore they stand, metres.
pub const DROWNED_LAKE_FADE_M: f64 = 60.0;
/// Strength of their own relief, of what they are raised by.
pub const DROWNED_ROUGH: f64 = 0.8;
/// How softly they leave the data's ground, metres.
pub const DROWNED_SOFT_M: f64 = 15.0;

/// How far streams carve islands in a deep sea beyond [`TOWERS`], where it rains less.
pub const CARVED_DRY: f64 = 0.4;

/// Values of three by three texels as a quadratic B-spline weighs them at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Around {
    /// Their mean, metres.
    pub mean_m: f64,
    /// Their standard deviation, metres.
    pub deviation_m: f64,
    /// How the mean rises to the right and down on the map, metres a texel.
    pub rise_m: [f64; 2],
}

impl Around {
    /// Of `metres`, row by row; `[x, y]` is the place within the middle texel, -1/2 to 1/2. Beds count as the sea's level: a deep sea
    /// beside a plain makes no mountains of it.
    pub fn of(metres: [[f64; 3]; 3], [x, y]: [f64; 2]) -> Self {
        let metres = metres.map(|row| row.map(|metres| metres.max(0.0)));
        Self::any(metres, [x, y])
    }

    /// As [`Around::of`], of values of any sign.
    pub fn any(metres: [[f64; 3]; 3], [x, y]: [f64; 2]) -> Self {
        let weights = |t: f64| [0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)];
        let rises = |t: f64| [t - 0.5, -2.0 * t, t + 0.5];
        let middle = metres[1][1];
        let [mut mean, mut square, mut right, mut down] = [0.0; 4];
        for (row, (wy, ry)) in metres.iter().zip(weights(y).into_iter().zip(rises(y))) {
            for (metres, (wx, rx)) in row.iter().zip(weights(x).into_iter().zip(rises(x))) {
                let over = metres - middle;
                mean += wx * wy * over;
                square += wx * wy * over * over;
                right += rx * wy * over;
                down += wx * ry * over;
            }
        }
        let deviation_m = (square - mean * mean).max(0.0).sqrt();
        Self { mean_m: middle + mean, deviation_m, rise_m: [right, down] }
    }
}

/// The shores near a place: signed distances in metres, positive in the ocean, and in lakes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shores {
    /// The ocean's.
    pub ocean_m: f64,
    /// The nearest lake's.
    pub lake_m: f64,
}

/// Strength of the relief, metres, of ground at `elevation_m`, `lift_m` of it raised, with such data `around`, whose texels are `texel_m` wide.
pub fn strength_m(around: Around, texel_m: f64, sin_lat: f64, [elevation_m, lift_m]: [f64; 2]) -> f64 {
    // The spline's weights deviate by half a texel along each axis.
    let slope = around.deviation_m / (0.5 * texel_m);
    // Heights are rounded to steps of a sixteenth at most, and of 32 m.
    let rounding = 0.5 * (around.mean_m / 16.0).min(32.0) / texel_m;
    let high = smoothstep(700.0, 1_500.0, around.mean_m);
    let ice = smoothstep(0.866, 0.9, -sin_lat).max(high * smoothstep(0.85, 0.92, sin_lat));
    let least = LEAST_SLOPE + rounding + ICE_SLOPE * ice;
    let raw = GAIN_M * slope * smoothstep(least, 2.5 * least, slope) + LIFT_GAIN * lift_m;
    let bounded = raw / (1.0 + raw / MOST_M);
    let most = OF_HEIGHT * elevation_m.max(0.0).max(OF_MEAN * around.mean_m);
    smoothstep(0.0, LOW_M, elevation_m) * bounded * most / (bounded + most).max(1.0)
}

/// What there is of all but drowned hills that is made this near to shores and to the border of the maps, 0 to 1.
pub fn fade(sin_lat: f64, shores: Shores) -> f64 {
    smoothstep(0.0, OCEAN_FADE_M, -shores.ocean_m)
        * smoothstep(0.0, LAKE_FADE_M, -shores.lake_m)
        * smoothstep(0.0, SEAM_FADE, (sin_lat.abs() - SEAM_SIN_LAT).abs())
}

/// Data finer than this, metres, have the mountains' own ridges and valleys, and get none made up. Ours: half of the broadest that are.
pub const MEASURED_M: f64 = 2_000.0;

/// Whether elevations of a resolution (metres; 0: not known) leave relief to be made up.
pub fn is_coarse(resolution_m: f64) -> bool {
    !(0.0 < resolution_m && resolution_m < MEASURED_M)
}

/// How far a place is one of islands in a deep sea, 0 to 1: `mean_m` is the mean elevation about it in texels `texel_m` wide, of level
/// [`ISLAND_LEVEL`]. Beds beside land are kept no deeper than a hundredth of their texels.
pub fn oceanic(mean_m: f64, texel_m: f64) -> f64 {
    smoothstep(0.5, 0.95, -100.0 * mean_m / texel_m)
}

/// How far a place is one of rocky islands on a shelf of high latitudes (Faroes, Shetland), 0 to [`SHELF`]: `wide_m` is the mean elevation about it of
/// level [`SHELF_LEVEL`], `mean_m` that of [`Around::of`].
pub fn rocky(wide_m: f64, mean_m: f64, sin_lat: f64) -> f64 {
    let unknown = 1.0 - smoothstep(KNOWN_M[0], KNOWN_M[1], mean_m);
    let high = smoothstep(HIGH_LATITUDES[0], HIGH_LATITUDES[1], sin_lat.abs());
    SHELF * unknown * high * smoothstep(SHELF_M[0], SHELF_M[1], -wide_m)
}

/// The way inland that counts for [`lift`], metres, where a place is so far `oceanic` and so far `rocky`, and how that grows by metres inland.
pub fn counted_inland(inland_m: f64, oceanic: f64, rocky: f64) -> (f64, f64) {
    let flattening = 1.0 + (inland_m / ROCKY_WIDE_M).powi(2);
    let root = flattening.sqrt();
    let share = rocky / (rocky + oceanic).max(1e-3);
    (inland_m + share * (inland_m / root - inland_m), 1.0 + share * (1.0 / (flattening * root) - 1.0))
}

/// How far ground at `elevation_m` is raised that is so far (`island`) one of an island's, metres, `inland_m` from the shore, and how that rises by metres inland. The
/// data have lowered or lost islands narrower than a few of their cells; those out of deep sea, and wider than an atoll's are, are volcanoes,
/// which rise by a sixth of the way inland; rocks on shelves by a seventh, where that is short ([`counted_inland`]).
pub fn lift(island: f64, inland_m: f64, elevation_m: f64) -> (f64, f64) {
    let x = inland_m.max(0.0);
    let flattening = 1.0 + (x / ISLAND_WIDE_M).powi(2);
    let root = flattening.sqrt();
    let lack = (island * ISLAND_RISE * x / root - elevation_m.max(0.0)).max(0.0);
    let raised = lack / (lack + ISLAND_SOFT_M);
    (raised * lack, raised * (2.0 - raised) * island * ISLAND_RISE / (flattening * root))
}

/// How steep hills are that the sea has drowned (Halong's towers), metres a metre, none elsewhere: where what land is left of them is so broken (`inland`: ways to
/// the shore, of [`DROWNED_SHORE_LEVEL`], in its texels), and the land about is so hilly (`deviation_m`, of [`DROWNED_LEVEL`]) and the sea so shallow
/// (`mean_m`, of [`ISLAND_LEVEL`]). The data have lost them as they have islands in a deep sea, but these are steeper and narrower.
pub fn drowned_rise(inland: Around, deviation_m: f64, mean_m: f64, sin_lat: f64) -> f64 {
    let broken = 1.0 - smoothstep(DROWNED_BROKEN[0], DROWNED_BROKEN[1], inland.deviation_m);
    let near = 1.0 - smoothstep(DROWNED_INLAND[0], DROWNED_INLAND[1], inland.mean_m);
    let hills = smoothstep(DROWNED_HILLS_M[0], DROWNED_HILLS_M[1], deviation_m);
    let shelf = smoothstep(DROWNED_SEA_M[0], DROWNED_SEA_M[1], mean_m);
    let towers = 1.0 - smoothstep(TOWERS[0], TOWERS[1], sin_lat.abs());
    (DROWNED_RISE[0] + (DROWNED_RISE[1] - DROWNED_RISE[0]) * towers) * broken * near * hills * shelf
}

/// How far ground at `elevation_m` is raised that is one of drowned hills which rise so steeply, metres, so far from the shores themselves: lakes and rivers lie level
/// between them. `towers`: how high these stand there ([`towers::height`]).
pub fn drowned_lift_m(rise: f64, shores: Shores, sin_lat: f64, elevation_m: f64, towers: f64) -> f64 {
    let x = (-shores.ocean_m).max(0.0);
    let dry = smoothstep(0.0, DROWNED_LAKE_FADE_M, -shores.lake_m)
        * smoothstep(0.0, SEAM_FADE, (sin_lat.abs() - SEAM_SIN_LAT).abs());
    let begun = smoothstep(0.0, DROWNED_FOOT_M, x);
    let share = towers::share(sin_lat);
    let round = rise * begun * x / (1.0 + (x / DROWNED_WIDE_M).powi(2)).sqrt();
    let ground_m = (1.0 - share) * round + share * rise / DROWNED_RISE[1] * towers::ground_m(x, towers);
    let lack = (ground_m - elevation_m.max(0.0)).max(0.0);
    dry * lack * lack / (lack + DROWNED_SOFT_M)
}

/// Strength of their own relief, metres, of ground that is now at `elevation_m`.
pub fn drowned_strength_m(lift_m: f64, elevation_m: f64) -> f64 {
    DROWNED_ROUGH * lift_m * smoothstep(0.0, LOW_M, elevation_m)
}

/// How far ground is one of a volcano's out of deep sea, which streams have carved, 0 to 1, where it is so far (`island`) one of an island's and has relief of such a
/// strength. On those that ice has shaped there is none.
pub fn carved(island: f64, sin_lat: f64, fade: f64, strength_m: f64) -> f64 {
    let high = smoothstep(HIGH_LATITUDES[0], HIGH_LATITUDES[1], sin_lat.abs());
    let rains = 1.0 + (CARVED_DRY - 1.0) * smoothstep(TOWERS[0], TOWERS[1], sin_lat.abs());
    rains * fade * island * (1.0 - high) * smoothstep(0.25 * GULLIED_M, GULLIED_M, strength_m)
}

/// What relief of `height_m` comes to on ground at `elevation_m` over the sea, metres, and the share of its slope: valleys do not reach down
/// to the sea's level, nor summits beyond [`HIGHEST_M`].
pub fn bounded(elevation_m: f64, height_m: f64) -> (f64, f64) {
    let room = if height_m < 0.0 { elevation_m } else { HIGHEST_M - elevation_m }.max(0.01);
    let share = 1.0 / (1.0 + height_m.abs() / room);
    (height_m * share, share * share)
}
