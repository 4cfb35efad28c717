//! The quadtree over each map square: its tiles in view, refined where they lack most.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::DVec3;

use crate::data::tile::{POLAR_LATITUDE_DEG, Projection, TileId, lat_lon_from_map, texel_size_m};
use crate::model::earth::{self, Geodetic, WGS84};
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// Tiles that one frame may draw.
const MOST_TILES: usize = 420;
/// With those into which steep ones are divided for their ridges.
const MOST_RUGGED: usize = 1_000;
/// Nothing is drawn more finely than at this distance, metres: ground that is a little higher than its tile's middle.
const NEAREST_M: f64 = 1.0;

pub(super) struct Bounds {
    pub(super) centre: DVec3,
    pub(super) radius: f64,
    pub(super) lat: f64,
}

pub(super) fn bounds(id: TileId) -> Bounds {
    let side = 2f64.powi(-i32::from(id.z));
    let at = |x: f64, y: f64| {
        let (lat, lon) = lat_lon_from_map(id.projection, (f64::from(id.x) + x) * side, (f64::from(id.y) + y) * side);
        (lat, WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 }))
    };
    let (lat, centre) = at(0.5, 0.5);
    // Of a small tile a corner is the farthest point, to a thousandth; a large one is bent.
    let steps: &[f64] = if id.z < 4 { &[0.0, 0.25, 0.5, 0.75, 1.0] } else { &[0.0, 1.0] };
    let farthest = steps
        .iter()
        .flat_map(|&x| steps.iter().map(move |&y| (x, y)))
        .map(|(x, y)| at(x, y).1.distance(centre))
        .fold(0.0, f64::max);
    Bounds { centre, radius: farthest * 1.02, lat }
}

/// Tests bounding spheres against the pyramid of the view and the horizon.
pub(super) struct Visibility {
    pub(super) eye: DVec3,
    pub(super) planes: [DVec3; 4],
    pub(super) eye_normal: DVec3,
    pub(super) horizon_angle: f64,
    pub(super) pixel_angle: f64,
}

impl Visibility {
    pub(super) fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let [width, height] = size.map(|side| f64::from(side.max(1)));
        let axes = camera.basis();
        let half = (FIELD_OF_VIEW_Y / 2.0).tan();
        let slanted = |axis: DVec3, slope: f64| (axes.forward * slope + axis).normalize();
        Self {
            eye: camera.eye_ecef(),
            planes: [
                slanted(axes.right, half * width / height),
                slanted(-axes.right, half * width / height),
                slanted(axes.up, half),
                slanted(-axes.up, half),
            ],
            eye_normal: earth::normal(camera.lat, camera.lon),
            horizon_angle: horizon_angle(camera.altitude_m.max(10.0)),
            pixel_angle: 2.0 * half / height,
        }
    }

    /// `low` and `high` are the heights of what stands on the tile, metres.
    pub(super) fn sees(&self, b: &Bounds, [low, high]: [f64; 2]) -> bool {
        let up = b.centre.normalize();
        // What stands on the tile leans away from its middle's vertical by the tile's bend.
        let reach = b.radius * (1.0 + high.max(-low) / WGS84.b);
        let away = b.centre - self.eye;
        let nearest = |plane: &DVec3| plane.dot(away) + (plane.dot(up) * low).max(plane.dot(up) * high);
        if self.planes.iter().any(|plane| nearest(plane) < -reach) {
            return false;
        }
        let angle = self.eye_normal.dot(b.centre.normalize()).clamp(-1.0, 1.0).acos();
        // A chord of the globe spans twice the arcsine of half of it; the whole map spans all.
        let spread = 2.0 * (b.radius / (2.0 * WGS84.b)).min(1.0).asin();
        angle < self.horizon_angle + horizon_angle(high) + spread + 0.005
    }
}

/// How far the horizon of a height is, as an angle at the earth's centre.
fn horizon_angle(height_m: f64) -> f64 {
    (WGS84.b / (WGS84.b + height_m.max(0.0))).min(1.0).acos()
}

/// What is to become of a tile of the quadtree.
pub(super) struct Judged {
    /// It is there at all.
    pub(super) shows: bool,
    /// It may be refined.
    pub(super) divisible: bool,
    /// How many times finer than usual it shall be.
    pub(super) finer: f64,
    /// It is divided for its ridges: there is more room for such.
    pub(super) is_steep: bool,
    /// How high its ground is, metres; 0 where that does not matter.
    pub(super) ground_m: f64,
}

/// A tile of the quadtree that may be refined.
struct Open {
    id: TileId,
    /// How many times wider its texels are than wanted.
    lack: f64,
    judged: Judged,
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        let place = |id: TileId| (id.z, id.projection as u8, id.y, id.x);
        self.lack.total_cmp(&other.lack).then_with(|| place(other.id).cmp(&place(self.id)))
    }
}

/// The quadtree's leaves, coarse ones first: where there is no room for all, those that lack most are refined, and steep ones leave others theirs. `judge` says of a tile, whose farthest point is
/// some metres from the eye, what is to become of it.
pub(super) fn refined(
    camera: &Camera,
    size: [u32; 2],
    judge: impl Fn(TileId, f64, &Visibility, &Bounds) -> Judged,
) -> Vec<TileId> {
    let visibility = Visibility::new(camera, size);
    let looked_at = |id: TileId| {
        let b = bounds(id);
        let centre_m = b.centre.distance(visibility.eye);
        let judged = judge(id, centre_m + b.radius, &visibility, &b);
        if !judged.shows || !serves(id, &b) {
            return None;
        }
        // The middle of the ground under the eye is nearer than any bounding sphere tells.
        let over_m = (camera.altitude_m - judged.ground_m).abs();
        let to_ground_m = if judged.ground_m > 0.0 {
            (b.centre + b.centre.normalize() * judged.ground_m).distance(visibility.eye)
        } else {
            centre_m
        };
        let distance = (to_ground_m - b.radius).max(over_m).max(NEAREST_M);
        let lack = judged.finer * texel_size_m(id.projection, id.z, b.lat) / (distance * visibility.pixel_angle);
        Some(Open { id, lack, judged })
    };
    let mut open: BinaryHeap<Open> = Projection::ALL.iter().filter_map(|&p| looked_at(TileId::root(p))).collect();
    let mut chosen = Vec::new();
    // Tiles that there are more since steep ones have been divided.
    let mut of_steep = 0;
    while let Some(Open { id, lack, judged }) = open.pop() {
        let others = open.len();
        let all = chosen.len() + others;
        let room = if judged.is_steep { all < MOST_RUGGED } else { all < MOST_TILES + of_steep };
        match id.children().filter(|_| lack > 1.0 && judged.divisible && room) {
            Some(children) => {
                open.extend(children.into_iter().filter_map(looked_at));
                of_steep += if judged.is_steep { open.len().saturating_sub(others + 1) } else { 0 };
            }
            None => chosen.push(id),
        }
    }
    chosen.sort_by_key(|id| id.z);
    chosen
}

/// Whether any part of a tile lies where its square is the one that serves (the polar squares beyond 84 degrees).
fn serves(id: TileId, b: &Bounds) -> bool {
    let reach = 2.0 * (b.radius / (2.0 * WGS84.b)).min(1.0).asin();
    let limit = POLAR_LATITUDE_DEG.to_radians();
    match id.projection {
        Projection::Mercator => b.lat.abs() - reach < limit,
        Projection::North => b.lat + reach > limit,
        Projection::South => b.lat - reach < -limit,
    }
}
