//! Where the eye of a picture is, over the sea, in it or inland, and what is near enough to show from there.

use crate::data::sample::Sample;
use crate::data::water::WaterClass;
use crate::model::earth::WGS84;
use crate::pass::kind::Kind;
use crate::scene::frame::uniform::{Output, SHOWS_LAND};
use crate::scene::frame::{CUT_M, Frame};
use crate::scene::sea::shores::ShoreWaves;

/// Waves of lakes that are farther from the eye's foot, metres, are roughness alone.
const LAKES_SEEN_M: f64 = 20_000.0;

/// Where the eye of a picture is, as only the world knows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// Depth of the ocean at its place, metres; `None` on land.
    pub(super) depth_m: Option<f64>,
    /// What is drawn first: from above, or from below.
    pub(super) kind: Kind,
    /// Whether the water may cut through the picture: then both are drawn.
    pub(super) is_cut: bool,
    /// Whether shores are so near that their surf shows.
    pub(super) shows_surf: bool,
    /// Whether lakes are so near that their waves show.
    pub(super) shows_lakes: bool,
    /// Whether the lake around the eye has a mesh of its own.
    pub(super) meshes_lake: bool,
    /// And whether the eye is so far out on it that no other inland water is near.
    pub(super) is_amid_lake: bool,
    /// Whether land is so near to an eye over the sea that this mirrors it.
    pub(super) mirrors_land: bool,
    /// Whether any of the ocean may be seen: not from far inland.
    pub(super) shows_ocean: bool,
    /// Whether an eye over the water may see light that waves gather on the bed.
    pub(super) lights_bed: bool,
}

/// From an eye so far out on a lake, metres, the waves of other inland waters do not show: it is at most some kilometres up where its lake is a mesh.
const AMID_LAKE_M: f64 = 5_000.0;
/// No mirrored land is looked for whose shore is farther from the eye than this, metres: it is a degree high.
const MIRRORED_FROM_M: f64 = 30_000.0;
/// An eye sees no ocean whose shore is farther away than this many times the ellipsoid's horizon, and metres: coarse tiles tell distances to a few
/// kilometres.
const INLAND: f64 = 1.5;
/// See [`INLAND`].
const INLAND_M: f64 = 50_000.0;

impl Side {
    /// That of a frame over the ocean, or over land, with the trains of waves of a shore. Whether the radiance has what is blended, and
    /// whether software draws.
    pub(super) fn of(
        frame: &Frame,
        place: Option<&Sample>,
        shore: Option<&ShoreWaves>,
        [blends, software]: [bool; 2],
    ) -> Self {
        let depth_m = place.and_then(|place| place.depth_m);
        let shore_m = place.and_then(|place| place.shore_distance_m).map_or(f64::INFINITY, f64::abs);
        let lake_m = place.and_then(|place| place.lake_distance_m).unwrap_or(f64::NEG_INFINITY);
        let is_lake = place.is_some_and(|place| matches!(place.class, WaterClass::Lake | WaterClass::River));
        let near_lake = is_lake || lake_m > -LAKES_SEEN_M;
        let shows_lakes = frame.has_waves() && near_lake;
        let over_m = |shore| depth_m.map_or(f64::INFINITY, |depth_m| frame.over_water_m(depth_m, shore));
        // At the lens and from below the waves are those of the open sea: so they are all over a picture that these cut.
        let is_cut = blends && frame.has_light() && over_m(None).abs() < CUT_M;
        let shows_surf = frame.shows_surf(shore_m) && !is_cut;
        let over_m = over_m(shore.filter(|_| shows_surf));
        let kind = Kind::of(frame, over_m < 0.0 && !is_cut);
        let lights_bed = blends && kind.fine && !kind.under_water && frame.lights_bed(software, depth_m, shore_m);
        // Albedos are of the ground, under lakes too.
        let u = &frame.uniform;
        let shows_land = u.layers & SHOWS_LAND != 0 && u.output != Output::Albedo as u32;
        let meshes_lake = near_lake && shows_land && kind.meshes_lakes() && frame.lake.is_some();
        let mirrors_land = shows_land && shore_m < MIRRORED_FROM_M;
        let is_amid_lake = meshes_lake && is_lake && lake_m > AMID_LAKE_M;
        let inland_m = place.and_then(|place| place.shore_distance_m).map_or(0.0, |shore_m| -shore_m);
        let shows_ocean = inland_m < INLAND * WGS84.horizon_distance(frame.camera.altitude_m.max(0.0)) + INLAND_M;
        Self {
            depth_m,
            kind,
            is_cut,
            shows_surf,
            shows_lakes,
            meshes_lake,
            is_amid_lake,
            mirrors_land,
            shows_ocean,
            lights_bed,
        }
    }

    /// The kind of the picture from below, if there is one.
    pub(super) fn below(&self) -> Option<Kind> {
        let is_below = self.is_cut || (self.kind.under_water && !self.kind.measured);
        is_below.then_some(Kind { under_water: true, ..self.kind })
    }
}
