//! The drawn surface of the sea at a place, measured on the CPU: for boats, buoys and everything else that floats.

use glam::{DVec2, DVec3};

use crate::model::moved_water::Place;
use crate::model::sea_tables::SeaTables;
use crate::model::surf::SurfWave;
use crate::model::waves::{self, CASCADES};
use crate::scene::sea::Seas;
use crate::scene::sea::shores::ShoreWaves;
use crate::scene::settings::Settings;

/// The Jacobian that the drawn slope divides by is at least this, so that a fold has a normal.
pub const LEAST_JACOBIAN: f64 = 0.25;
/// Significant height that water holds, as a share of its depth: random waves break at 0.4 to 0.5 of it.
pub const HELD_BY_DEPTH: f64 = 0.5;

/// The surface of the sea at a place and an instant.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct SurfaceSample {
    /// Height over the ellipsoid, m: that of the waves over the resting sea, and of that by the settings' datum.
    pub height_m: f64,
    /// Unit normal of the water: east, north, up.
    pub normal_enu: [f64; 3],
    /// How far the waves have carried the water that is now here from where it rests: east, north, up, m.
    pub displacement_enu_m: [f64; 3],
    /// Jacobian of the choppy displacement: area per area at rest, below 0 where a crest has folded.
    pub jacobian: f64,
}

/// The share of the waves that water `depth_m` deep holds: see [`HELD_BY_DEPTH`].
pub fn allowed_by_depth(depth_m: f64, hs_m: f64) -> f64 {
    if hs_m > 0.0 { (HELD_BY_DEPTH * depth_m / hs_m).clamp(0.0, 1.0) } else { 1.0 }
}

/// Significant height in m of the waves that are drawn over water `depth_m` deep: of the patches, as high as `gains` say and the depth allows, and of
/// the trains of a shore, which break.
pub fn height_here_m(tables: &SeaTables, depth_m: f64, gains: [f64; CASCADES], shore: Option<&ShoreWaves>) -> f64 {
    let Some(shore) = shore else {
        let height_m = tables.height_gain(gains) * tables.sea.hs_m;
        return allowed_by_depth(depth_m, height_m) * height_m;
    };
    let allowed = allowed_by_depth(depth_m, shore.level * tables.height_gain(gains) * tables.sea.hs_m);
    let left = std::array::from_fn(|index| gains[index] * shore.patches[index]);
    libm::hypot(allowed * tables.height_gain(left) * tables.sea.hs_m, shore.hs_m)
}

impl Seas {
    /// The surface at geodetic `lat`, `lon` (radians) at a UTC instant, over water `depth_m` deep (infinity: the open sea), with no land in
    /// the sea's way.
    ///
    /// These are the numbers that are drawn where the Perlin field has no weight, within 2 km of the eye: within a centimetre and
    /// 0.1°, except where a crest has folded over the place and there is more than one surface. The first sample of an instant
    /// transforms the patches (some tenths of a second); further ones cost microseconds.
    pub fn sample(
        &mut self,
        settings: &Settings,
        lat: f64,
        lon: f64,
        unix_seconds: f64,
        depth_m: f64,
    ) -> SurfaceSample {
        self.sample_in(settings, (lat, lon), unix_seconds, depth_m, [1.0; CASCADES])
    }

    /// As [`Seas::sample`], where the waves of each patch are `gains` times as high as those of the open sea
    /// ([`Shelter`](crate::scene::sea::shelter::Shelter)).
    pub fn sample_in(
        &mut self,
        settings: &Settings,
        place: (f64, f64),
        unix_seconds: f64,
        depth_m: f64,
        gains: [f64; CASCADES],
    ) -> SurfaceSample {
        self.sample_by_shore(settings, place, unix_seconds, depth_m, gains, None)
    }

    /// As [`Seas::sample_in`], with the trains of waves of a shore.
    pub fn sample_by_shore(
        &mut self,
        settings: &Settings,
        (lat, lon): (f64, f64),
        unix_seconds: f64,
        depth_m: f64,
        gains: [f64; CASCADES],
        shore: Option<ShoreWaves>,
    ) -> SurfaceSample {
        let (tables, rest_m) = (self.tables(settings), settings.datum.rest_m(lat, lon));
        let left = shore.map_or([1.0; CASCADES], |shore| shore.patches);
        let level = shore.map_or(1.0, |shore| shore.level);
        let wave = shore.map_or_else(SurfWave::default, |shore| shore.wave);
        let allowed = allowed_by_depth(depth_m, level * tables.height_gain(gains) * tables.sea.hs_m);
        let gains: [f64; CASCADES] = std::array::from_fn(|index| gains[index] * left[index]);
        if tables.sea.hs_m == 0.0 || allowed == 0.0 {
            return SurfaceSample {
                height_m: rest_m,
                normal_enu: [0.0, 0.0, 1.0],
                displacement_enu_m: [0.0; 3],
                jacobian: 1.0,
            };
        }
        let patches = self.patches(&tables, waves::ticks_from_unix(unix_seconds));
        let place = Place::new(&tables, settings.wind_from(), lat, lon);
        let chop = tables.sea.chop;
        let (rest, motion) = place.invert(allowed * chop, |index, at| patches.motion(index, at).gained(gains[index]));
        let gradient = motion.chop_gradient(chop);
        let jacobian = gradient.jacobian();
        let slope = allowed * jacobian / jacobian.max(LEAST_JACOBIAN)
            * DVec2::from(gradient.true_slope(motion.slope.x, motion.slope.y))
            + DVec2::from(wave.slope);
        let height_m = allowed * (motion.height - tables.level_in_m(gains)) + wave.rise;
        SurfaceSample {
            height_m: rest_m + height_m,
            normal_enu: DVec3::new(-slope.x, -slope.y, 1.0).normalize().to_array(),
            displacement_enu_m: [-rest.x, -rest.y, height_m],
            jacobian,
        }
    }
}
