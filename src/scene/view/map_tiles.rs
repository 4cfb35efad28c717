//! Which map tiles a view needs: a quadtree per map square, refined until a texel is no wider than a pixel.

use glam::DVec3;

use crate::data::tile::{Projection, TileId, lat_lon_from_map, texel_size_m};
use crate::model::earth::{self, Geodetic, WGS84};
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// Deepest level of the ground's mesh: cells of 76 m at the equator.
pub const DEEPEST_MESH: u8 = 14;
/// Highest and lowest ground, metres, with a margin.
const RELIEF_M: f64 = 9_500.0;
/// Tiles that one frame may draw.
const MOST_TILES: usize = 420;

struct Bounds {
    centre: DVec3,
    radius: f64,
    lat: f64,
}

fn bounds(id: TileId) -> Bounds {
    let side = 2f64.powi(-i32::from(id.z));
    let at = |x: f64, y: f64| {
        let (lat, lon) = lat_lon_from_map(id.projection, (f64::from(id.x) + x) * side, (f64::from(id.y) + y) * side);
        (lat, WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 }))
    };
    let (lat, centre) = at(0.5, 0.5);
    let steps = [0.0, 0.25, 0.5, 0.75, 1.0];
    let farthest = steps
        .iter()
        .flat_map(|&x| steps.iter().map(move |&y| (x, y)))
        .map(|(x, y)| at(x, y).1.distance(centre))
        .fold(0.0, f64::max);
    Bounds { centre, radius: farthest * 1.02, lat }
}

/// Tests bounding spheres against the pyramid of the view and the horizon.
struct Visibility {
    eye: DVec3,
    planes: [DVec3; 4],
    eye_normal: DVec3,
    horizon_angle: f64,
}

impl Visibility {
    fn new(camera: &Camera, aspect: f64) -> Self {
        let axes = camera.basis();
        let half = (FIELD_OF_VIEW_Y / 2.0).tan();
        let slanted = |axis: DVec3, slope: f64| (axes.forward * slope + axis).normalize();
        let height = camera.altitude_m.max(10.0);
        Self {
            eye: camera.eye_ecef(),
            planes: [
                slanted(axes.right, half * aspect),
                slanted(-axes.right, half * aspect),
                slanted(axes.up, half),
                slanted(-axes.up, half),
            ],
            eye_normal: earth::normal(camera.lat, camera.lon),
            horizon_angle: (WGS84.b / (WGS84.b + height)).acos() + (WGS84.b / (WGS84.b + RELIEF_M)).acos(),
        }
    }

    fn sees(&self, b: &Bounds) -> bool {
        let reach = b.radius + RELIEF_M;
        let away = b.centre - self.eye;
        if self.planes.iter().any(|plane| plane.dot(away) < -reach) {
            return false;
        }
        let angle = self.eye_normal.dot(b.centre.normalize()).clamp(-1.0, 1.0).acos();
        // A chord of the globe spans twice the arcsine of half of it; the whole map spans all.
        let spread = 2.0 * (b.radius / (2.0 * WGS84.b)).min(1.0).asin();
        angle < self.horizon_angle + spread + 0.005
    }
}

/// Tiles of the ground to draw, each place once; coarse tiles come first.
pub fn visible_tiles(camera: &Camera, size: [u32; 2]) -> Vec<TileId> {
    let visibility = Visibility::new(camera, f64::from(size[0].max(1)) / f64::from(size[1].max(1)));
    let pixel_angle = 2.0 * (FIELD_OF_VIEW_Y / 2.0).tan() / f64::from(size[1].max(1));
    let mut open: std::collections::VecDeque<TileId> = Projection::ALL.iter().map(|&p| TileId::root(p)).collect();
    let mut chosen = Vec::new();
    while let Some(id) = open.pop_front() {
        let b = bounds(id);
        if !serves(id, &b) || !visibility.sees(&b) {
            continue;
        }
        // The middle of the ground under the eye is nearer than any bounding sphere tells.
        let distance = (b.centre.distance(visibility.eye) - b.radius).max(camera.altitude_m.abs()).max(1.0);
        let texel = texel_size_m(id.projection, id.z, b.lat);
        let fine = texel <= distance * pixel_angle;
        let room = chosen.len() + open.len() < MOST_TILES;
        match id.children().filter(|_| !fine && id.z < DEEPEST_MESH && room) {
            Some(children) => open.extend(children),
            None => chosen.push(id),
        }
    }
    chosen
}

/// Whether any part of a tile lies where its square is the one that serves (the polar squares beyond 84 degrees).
fn serves(id: TileId, b: &Bounds) -> bool {
    let reach = 2.0 * (b.radius / (2.0 * WGS84.b)).min(1.0).asin();
    let limit = crate::data::tile::POLAR_LATITUDE_DEG.to_radians();
    match id.projection {
        Projection::Mercator => b.lat.abs() - reach < limit,
        Projection::North => b.lat + reach > limit,
        Projection::South => b.lat - reach < -limit,
    }
}
