//! Tile addresses and map coordinates.
//!
//! Conventions: angles are geodetic radians on WGS84; a map is the unit square, x to the right, y down, and one map
//! coordinate is a `u32` of which 2^32 spans the whole square, so that a tile, a texel or a fraction of a texel is a
//! shift away. Three maps exist:
//!
//! - [`Projection::Mercator`]: Web Mercator, the XYZ scheme (row 0 = north), cut at latitude 85.0511 degrees;
//! - [`Projection::North`], [`Projection::South`]: stereographic on the geodetic normal
//!   n = (cos lat cos lon, cos lat sin lon, sin lat); north p = (n.x, n.y) / (1 + n.z), south p = (n.x, n.y) / (1 - n.z).
//!   The square spans p in [-E, E]², E = [`POLAR_HALF_SIDE`]; x grows with p.x, y grows with -p.y.
//!
//! The polar maps serve |latitude| >= [`POLAR_LATITUDE_DEG`], Mercator the rest.

use std::f64::consts::PI;

use glam::DVec2;

/// Texels along one side of a tile.
pub const TILE_TEXELS: usize = 256;
/// The deepest level that an address may have: one texel is then a step of 2^-24 of the map.
pub const MAX_ZOOM: u8 = 24;
/// From this latitude on, north and south, the polar maps are used, degrees.
pub const POLAR_LATITUDE_DEG: f64 = 84.0;
/// tan(15°/2): the polar square reaches latitude 75 degrees at the middle of each edge.
pub const POLAR_HALF_SIDE: f64 = 0.131_652_497_587_395_83;
/// Latitude where Web Mercator becomes a square, atan(sinh π), radians.
pub const MERCATOR_LATITUDE_LIMIT: f64 = 1.484_422_229_745_332_4;
/// Length of the WGS84 equator, metres (2 π · 6,378,137).
pub const EQUATOR_M: f64 = 40_075_016.685_578_49;
/// Equatorial radius of WGS84, metres.
const EQUATORIAL_RADIUS_M: f64 = 6_378_137.0;

/// Which of the three maps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Projection {
    /// Web Mercator.
    Mercator,
    /// The stereographic map around the North Pole.
    North,
    /// The stereographic map around the South Pole.
    South,
}

impl Projection {
    /// All maps.
    pub const ALL: [Self; 3] = [Self::Mercator, Self::North, Self::South];

    /// The map that serves a latitude (radians).
    pub fn for_latitude(lat: f64) -> Self {
        let limit = POLAR_LATITUDE_DEG.to_radians();
        if lat >= limit {
            Self::North
        } else if lat <= -limit {
            Self::South
        } else {
            Self::Mercator
        }
    }

    /// A way on the map, to the right and down, as one to the east and north at longitude `lon` (radians): the same on Mercator's map, on
    /// a polar one turned with the longitude.
    pub fn east_north(self, [right, down]: [f64; 2], lon: f64) -> DVec2 {
        let way = DVec2::new(right, -down);
        let out = DVec2::new(libm::cos(lon), libm::sin(lon));
        match self {
            Self::Mercator => way,
            Self::North => DVec2::new(way.dot(out.perp()), -way.dot(out)),
            Self::South => DVec2::new(way.dot(out.perp()), way.dot(out)),
        }
    }

    /// The name used in archive metadata: `mercator`, `north` or `south`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mercator => "mercator",
            Self::North => "north",
            Self::South => "south",
        }
    }
}

/// What a tile holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Layer {
    /// Elevation, see [`super::terrarium`].
    Terrain,
    /// Water class and signed distances to the shores, see [`super::water`].
    Water,
    /// The land's colour, see [`super::imagery`]. A world may lack it.
    Imagery,
}

impl Layer {
    /// How many there are.
    pub const COUNT: usize = 3;
    /// All layers.
    pub const ALL: [Self; Self::COUNT] = [Self::Terrain, Self::Water, Self::Imagery];
    /// Those without which there is no world: the ground's shape.
    pub const SHAPE: [Self; 2] = [Self::Terrain, Self::Water];

    /// The name used in file names: `terrain`, `water` or `imagery`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Terrain => "terrain",
            Self::Water => "water",
            Self::Imagery => "imagery",
        }
    }
}

/// The address of one tile: level `z` has 2^z by 2^z tiles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TileId {
    /// The map.
    pub projection: Projection,
    /// The level; 0 is the whole map in one tile.
    pub z: u8,
    /// Column, from the left.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
}

impl TileId {
    /// The tile, or `None` where the level is deeper than [`MAX_ZOOM`] or the column or row lies off the map.
    pub fn new(projection: Projection, z: u8, x: u32, y: u32) -> Option<Self> {
        let fits = z <= MAX_ZOOM && x >> z == 0 && y >> z == 0;
        fits.then_some(Self { projection, z, x, y })
    }

    /// The one tile that is the whole map.
    pub fn root(projection: Projection) -> Self {
        Self { projection, z: 0, x: 0, y: 0 }
    }

    /// The tile one level up, `None` at the root.
    pub fn parent(self) -> Option<Self> {
        self.ancestor(self.z.checked_sub(1)?)
    }

    /// The tile of level `z` that contains this one; itself at its own level, `None` below it.
    pub fn ancestor(self, z: u8) -> Option<Self> {
        let up = self.z.checked_sub(z)?;
        Some(Self { projection: self.projection, z, x: self.x >> up, y: self.y >> up })
    }

    /// The four tiles one level down, in reading order; `None` at [`MAX_ZOOM`].
    pub fn children(self) -> Option<[Self; 4]> {
        (self.z < MAX_ZOOM).then(|| {
            [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| Self {
                projection: self.projection,
                z: self.z + 1,
                x: 2 * self.x + i,
                y: 2 * self.y + j,
            })
        })
    }

    /// The centre of texel (column, row) as a position on the unit map; columns and rows may lie outside the tile.
    pub fn texel_centre(self, column: f64, row: f64) -> (f64, f64) {
        let side = texels_across(self.z);
        let origin = |tile: u32| f64::from(tile) * TILE_TEXELS as f64 + 0.5;
        ((origin(self.x) + column) / side, (origin(self.y) + row) / side)
    }
}

impl std::fmt::Display for TileId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}/{}/{}", self.projection.name(), self.z, self.x, self.y)
    }
}

/// Texels across the whole map at level `z`.
pub fn texels_across(z: u8) -> f64 {
    TILE_TEXELS as f64 * 2f64.powi(i32::from(z))
}

/// A position on one of the maps; 2^32 units span the square, x to the right, y down.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct MapPoint {
    /// The map.
    pub projection: Projection,
    /// Position from the left edge, in 2^-32 of the side.
    pub u: u32,
    /// Position from the top edge, in 2^-32 of the side.
    pub v: u32,
}

impl MapPoint {
    /// The point at geodetic `lat`, `lon` (radians) on the map that serves that latitude. Latitude is clamped to ±90°,
    /// longitude wraps; a value that is not finite counts as 0.
    pub fn from_lat_lon(lat: f64, lon: f64) -> Self {
        Self::on(Projection::for_latitude(lat), lat, lon)
    }

    /// The point at geodetic `lat`, `lon` (radians) on a given map, clamped to its square.
    pub fn on(projection: Projection, lat: f64, lon: f64) -> Self {
        let (x, y) = map_from_lat_lon(projection, lat, lon);
        Self { projection, u: fixed(x), v: fixed(y) }
    }

    /// Geodetic (latitude, longitude), radians.
    pub fn to_lat_lon(self) -> (f64, f64) {
        lat_lon_from_map(self.projection, f64::from(self.u) / SPAN, f64::from(self.v) / SPAN)
    }

    /// The tile of level `z` (at most [`MAX_ZOOM`]) that holds the point.
    pub fn tile(self, z: u8) -> TileId {
        let z = z.min(MAX_ZOOM);
        let shift = 32 - u32::from(z);
        let cut = |a: u32| (u64::from(a) >> shift) as u32;
        TileId { projection: self.projection, z, x: cut(self.u), y: cut(self.v) }
    }

    /// The world texel (column, row) of level `z` that holds the point.
    pub fn texel(self, z: u8) -> (u32, u32) {
        let shift = 24 - u32::from(z.min(MAX_ZOOM));
        (self.u >> shift, self.v >> shift)
    }
}

const SPAN: f64 = 4_294_967_296.0;

fn fixed(unit: f64) -> u32 {
    (unit * SPAN).floor().clamp(0.0, SPAN - 1.0) as u32
}

/// Position on the unit map of geodetic `lat`, `lon` (radians); Mercator's x lies in [0, 1), y is clamped to the square;
/// a polar position outside its square is returned as it is.
pub fn map_from_lat_lon(projection: Projection, lat: f64, lon: f64) -> (f64, f64) {
    let lat = if lat.is_finite() { lat.clamp(-PI / 2.0, PI / 2.0) } else { 0.0 };
    let lon = if lon.is_finite() { lon } else { 0.0 };
    let polar = |pole: f64| {
        // tan of half the distance from the pole; (n.x, n.y) / (1 ± n.z) without cancellation.
        let p = ((PI / 2.0 - pole * lat) / 2.0).tan() / POLAR_HALF_SIDE;
        (0.5 + 0.5 * p * lon.cos(), 0.5 - 0.5 * p * lon.sin())
    };
    match projection {
        Projection::Mercator => {
            let turns = (lon / (2.0 * PI) + 0.5).rem_euclid(1.0);
            let lat = lat.clamp(-MERCATOR_LATITUDE_LIMIT, MERCATOR_LATITUDE_LIMIT);
            let y = 0.5 - lat.tan().asinh() / (2.0 * PI);
            // rem_euclid of a tiny negative number rounds to 1.0.
            (if turns >= 1.0 { 0.0 } else { turns }, y.clamp(0.0, 1.0))
        }
        Projection::North => polar(1.0),
        Projection::South => polar(-1.0),
    }
}

/// Geodetic (latitude, longitude in -π..π), radians, of a position on the unit map. Mercator's x wraps.
pub fn lat_lon_from_map(projection: Projection, x: f64, y: f64) -> (f64, f64) {
    let polar = |pole: f64| {
        let (px, py) = ((2.0 * x - 1.0) * POLAR_HALF_SIDE, (1.0 - 2.0 * y) * POLAR_HALF_SIDE);
        (pole * (PI / 2.0 - 2.0 * px.hypot(py).atan()), py.atan2(px))
    };
    match projection {
        Projection::Mercator => (((0.5 - y) * 2.0 * PI).sinh().atan(), ((x.rem_euclid(1.0)) - 0.5) * 2.0 * PI),
        Projection::North => polar(1.0),
        Projection::South => polar(-1.0),
    }
}

/// Ground metres that one texel of level `z` spans at a position with latitude `lat` (radians). Mercator:
/// equator · cos lat / (256 · 2^z); polar: the stereographic scale 2 / (1 + |p|²) on the equatorial radius.
pub fn texel_size_m(projection: Projection, z: u8, lat: f64) -> f64 {
    let polar = |pole: f64| {
        let p = ((PI / 2.0 - pole * lat) / 2.0).tan();
        2.0 * POLAR_HALF_SIDE * EQUATORIAL_RADIUS_M * 2.0 / (1.0 + p * p) / texels_across(z)
    };
    match projection {
        Projection::Mercator => EQUATOR_M * lat.cos().max(1e-3) / texels_across(z),
        Projection::North => polar(1.0),
        Projection::South => polar(-1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn map_positions_round_trip() {
        for lat_deg in [-90.0, -89.9, -84.0, -60.0, -0.1, 0.0, 33.0, 83.9, 84.0, 89.999, 90.0f64] {
            for lon_deg in [-180.0, -179.999, -77.0, 0.0, 1e-6, 90.0, 179.999f64] {
                let (lat, lon) = (lat_deg.to_radians(), lon_deg.to_radians());
                let (lat2, lon2) = MapPoint::from_lat_lon(lat, lon).to_lat_lon();
                // One unit is 40,075 km / 2^32 = 9.3 mm on the equator, 1.5e-9 rad.
                assert!((lat - lat2).abs() < 2e-9, "{lat_deg} {lon_deg}: {}", lat2.to_degrees());
                let across = (lon - lon2 + PI).rem_euclid(2.0 * PI) - PI;
                assert!((across * lat.cos()).abs() < 2e-9, "{lat_deg} {lon_deg}: {}", lon2.to_degrees());
            }
        }
    }

    #[test]
    fn constants_follow_from_their_definitions() {
        assert_eq!(POLAR_HALF_SIDE, 7.5f64.to_radians().tan());
        assert!((MERCATOR_LATITUDE_LIMIT - PI.sinh().atan()).abs() < 1e-15);
        assert!((EQUATOR_M - 2.0 * PI * EQUATORIAL_RADIUS_M).abs() < 1e-8);
    }

    #[test]
    fn rows_grow_southwards_and_tiles_nest() {
        let lisbon = MapPoint::from_lat_lon(38.7f64.to_radians(), -9.1f64.to_radians());
        assert_eq!(lisbon.tile(7), TileId { projection: Projection::Mercator, z: 7, x: 60, y: 49 });
        let deep = lisbon.tile(24);
        assert_eq!(deep.ancestor(7), Some(lisbon.tile(7)));
        assert_eq!(lisbon.texel(16).0 >> 8, lisbon.tile(16).x);
        let children = lisbon.tile(7).children().unwrap();
        assert!(children.contains(&lisbon.tile(8)) && children.iter().all(|c| c.parent() == Some(lisbon.tile(7))));
        assert!(deep.children().is_none() && TileId::root(Projection::North).parent().is_none());
    }

    #[test]
    fn polar_maps_have_the_documented_orientation() {
        let (x, y) = map_from_lat_lon(Projection::North, 80f64.to_radians(), 0.0);
        assert!(x > 0.7 && (y - 0.5).abs() < 1e-12);
        let (x, y) = map_from_lat_lon(Projection::South, -80f64.to_radians(), 90f64.to_radians());
        assert!((x - 0.5).abs() < 1e-12 && y < 0.3);
        let edge = map_from_lat_lon(Projection::North, 75f64.to_radians(), 0.0).0;
        assert!((edge - 1.0).abs() < 1e-12);
    }

    #[test]
    fn texel_size_is_the_ground_distance_between_texel_centres() {
        for (projection, lat_deg) in [
            (Projection::Mercator, 60.0),
            (Projection::Mercator, -3.0),
            (Projection::North, 85.0),
            (Projection::South, -89.0),
        ] {
            let tile = MapPoint::on(projection, f64::to_radians(lat_deg), 0.3).tile(9);
            let at = |i: f64| {
                let (x, y) = tile.texel_centre(i, 7.0);
                lat_lon_from_map(projection, x, y)
            };
            let ((lat, lon), (lat2, lon2)) = (at(3.0), at(4.0));
            let haversine =
                ((lat2 - lat) / 2.0).sin().powi(2) + lat.cos() * lat2.cos() * ((lon2 - lon) / 2.0).sin().powi(2);
            let metres = 2.0 * EQUATORIAL_RADIUS_M * haversine.sqrt().asin();
            let size = texel_size_m(projection, 9, lat);
            assert!((metres / size - 1.0).abs() < 1e-3, "{tile}: {metres} {size}");
        }
    }
}
