//! Which map tiles a view needs: those of the quadtree until a texel is no wider than a pixel, and which it draws: where the ground shows, in cells as narrow as
//! its relief asks for.

use super::quadtree::{Bounds, Judged, Visibility, bounds, refined};
use crate::data::streaming::{Range, Streaming};
use crate::data::tile::{Layer, Projection, TILE_TEXELS, TileId, lat_lon_from_map, texel_size_m};
use crate::model::earth::{Geodetic, WGS84};
use crate::model::reefs;
use crate::model::relief::WIDEST_M;
use crate::model::rugged;
use crate::model::sea_bed::{BERM_M, Coast, Grid, LEAST_M, USUAL_SLOPE, grid_level, trusted_m};
use crate::model::towers;
use crate::scene::view::camera::Camera;

/// Deepest level of the ground's mesh, whatever the archives hold: cells of 76 m at the equator.
const DEEPEST_MESH: u8 = 15;
/// Levels of the mesh below the archives' deepest tiles, whose texels are as wide as the mesh's cells four levels down: four cells to a
/// texel follow what a sharp coast makes of it (`model::sea_bed`), and finer ones show nothing more.
const LEVELS_BELOW: u8 = 6;
/// Highest and lowest ground, metres, with a margin.
pub const RELIEF_M: f64 = 9_500.0;
/// Deepest level of tiles with relief: cells of 9.5 m at the equator, which hold all that [`crate::model::relief::MESH_FOOTPRINT_M`] asks for.
const DEEPEST_RUGGED: u8 = 18;
/// Range of elevations near a tile below which it has no relief of its own, metres: their deviation is half of it at most, over texels of
/// 5 km or more that is less than `rugged::LEAST_SLOPE`.
const FLAT_M: f64 = 5.0;
/// From which on the ground is drawn in finer cells than the data ask for: twice as wide as usual ones, since on gentle slopes waves of
/// less than four cells of 32 pixels stand a pixel or two high, and shading is enough.
const RUGGED_M: f64 = 60.0;
/// From which on ridges show as such, in cells half as wide as usual.
const STEEP_M: f64 = 800.0;
/// Slope of a tile from which on its cells are as narrow as usual, 8 to 16 pixels: chords over hills that are as steep and as wide as the tile are half a
/// pixel off, and no more in cells that are as much wider as slopes are gentler.
const GENTLE_SLOPE: f64 = 0.125;
/// Cells of the gentlest are so many times finer than usual ones: as wide as all are in a coarse picture, whose eye may move without a pop.
const GENTLEST: f64 = 0.5;
/// Coarser tiles than those of this level bend with the globe, and a bed that the sea hides is told from others in small ones.
const GENTLE_LEVEL: u8 = 8;
/// Nearer to a shore than this, metres, its profile shapes the ground, whatever the data say; wide triangles would bare the bed before it.
const SHORE_SHAPED_M: f64 = 500.0;
/// The tile of this level around an island that may be raised, 156 km wide at the equator, has deep water, or is a shelf's.
const AROUND: u8 = 8;
/// No wave runs farther up a beach, m; as `SWASH_WIDEST` of `shaders/lib/swash.wgsl`.
const BEACH_M: f64 = 60.0;
/// So deep, metres: out of a deep sea, and on a shelf, which is deeper than `rugged::SHELF_M` in the mean of still wider tiles; no raised land of the bundled world
/// is missed.
const ISLAND_BED_M: f64 = -500.0;
const SHELF_BED_M: f64 = -40.0;
/// How far apart the elevations of [`rugged::DROWNED_LEVEL`] reach where hills may be drowned, metres: they deviate by half of it at most.
const HILLS_M: f64 = 2.0 * rugged::DROWNED_HILLS_M[0];
/// No drowned hill is farther inland, metres: [`rugged::DROWNED_INLAND`], with as much again for what the smoothed distance leaves out.
const DROWNED_TO_M: f64 = 12_000.0;
/// Walls that are seen against the sea or the sky are no farther inland, metres.
const WALLS_TO_M: f64 = 2_000.0;
/// Relief stands no higher over the data, metres.
const HIGHEST_RELIEF_M: f64 = 2_000.0;
/// Cells of tiles with relief are at most so many pixels wide, and [`Frame::wider_ground`](crate::scene::frame::Frame::wider_ground) times that in a coarse
/// picture; as in `shaders/lib/rugged.wgsl` and `shaders/land.wgsl`.
const CELL_PIXELS: f64 = 8.0;

/// A tile of the ground to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DrawnTile {
    /// Which one.
    pub id: TileId,
    /// Whether relief that the data do not hold may be seen on it.
    pub is_rugged: bool,
    /// A bit for each block that the sea does not hide.
    pub shown: u32,
    /// A bit for each of them that has the sea's bed alone, without land or the sand of its shore.
    pub bed: u32,
}

/// Blocks along a side of a tile, two levels of tiles down: each may be hidden, and have beaches, by itself; equals `BLOCKS` in `shaders/land.wgsl`.
pub const BLOCKS: u32 = 4;
/// Bits of all of a tile's blocks.
pub const ALL_BLOCKS: u32 = (1 << (BLOCKS * BLOCKS)) - 1;

/// Where the sea hides fewer blocks of a tile all are drawn at once, which spares more than these take; so are those of a bed.
const WORTH_HIDING: u32 = 4;

/// Nothing of the land shows on a bed that is farther from the shore than this, metres, or than half a pixel of the flattest sight where that is more: as
/// `SHORE_SAND` of `shaders/lib/ground.wgsl`.
pub const SHORE_SAND_M: f64 = 80.0;
/// Sine by which the flattest sight sinks to the ground: as in `shaders/lib/shore_pixels.wgsl`.
pub const LEAST_SINKING: f64 = 0.02;
/// Of wide pixels, metres, their own rays tell the place, not the tile: as `chords_show` of `shaders/land.wgsl`.
const CHORDS_SHOW_M: f64 = 200.0;

/// Bits of a tile's blocks, row by row, of which `has` is true; it is of a tile if it is of one within it.
pub fn blocks_with(id: TileId, has: &impl Fn(TileId) -> bool) -> u32 {
    let within = |id: TileId| id.children().filter(|_| has(id)).into_iter().flatten();
    let bit = |block: TileId| 1 << (block.y % BLOCKS * BLOCKS + block.x % BLOCKS);
    within(id).flat_map(within).filter(|block| has(*block)).map(bit).sum()
}

/// How a sea hides its bed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hiding {
    /// Depth from which the water lets nothing through, metres.
    pub depth_m: f64,
    /// How wide a cell of the terrain's source is, metres: what shapes the bed near the shore.
    pub resolution_m: f64,
    /// How steeply usual beaches fall, metres per metre.
    pub beach_slope: f64,
}

/// Heights of the ground in a tile: real ones where all of the tile's data are at hand.
fn heights(id: TileId, tiles: &Streaming) -> [f64; 2] {
    let known = id.z >= tiles.deepest(Layer::Terrain, id.projection) && tiles.is_known(Layer::Terrain, id);
    // Vertices look four levels up, where a texel is as wide as a cell of the mesh.
    let metres = if known { tiles.elevations_m(id, id.z.saturating_sub(5)) } else { None };
    // A sharp coast shapes the bed and the land to some least depth and height, and the bed goes down as far as the sea is deep and the land is
    // high together (`model::sea_bed`). Valleys do not reach down to the sea.
    let made = if rugged_m(id, tiles).is_some() { HIGHEST_RELIEF_M } else { 0.0 };
    metres.map_or([-RELIEF_M, RELIEF_M], |metres| {
        let [low, high] = [metres.least.min(0.0), metres.greatest.max(0.0)];
        [(low - high).min(-LEAST_M[0]), high.max(BERM_M) + made]
    })
}

/// Whether a tile reaches the latitudes where islands on shelves are raised.
fn reaches_high_latitudes(id: TileId) -> bool {
    let side = 2f64.powi(-i32::from(id.z));
    let sin_lat = |y: u32| lat_lon_from_map(id.projection, 0.5, f64::from(id.y + y) * side).0.sin().abs();
    id.projection != Projection::Mercator || sin_lat(0).max(sin_lat(1)) > rugged::HIGH_LATITUDES[0]
}

/// Whether a tile reaches the latitudes of towers.
fn reaches_towers(id: TileId) -> bool {
    let side = 2f64.powi(-i32::from(id.z));
    let lat = |y: u32| lat_lon_from_map(id.projection, 0.5, f64::from(id.y + y) * side).0;
    let [south, north] = [lat(1), lat(0)];
    // The tile's latitude that is nearest to the equator.
    id.projection == Projection::Mercator && towers::share(south.max(0.0).max(-north).sin()) > 0.0
}

/// How far the elevations near a tile reach apart where it has dry land, metres: `None` where it has none, or where they are so alike that
/// there is no relief but what the data hold (`model::rugged`). Beside deep water, low on the shelves of high latitudes, and by shores before hills there may be any.
fn rugged_m(id: TileId, tiles: &Streaming) -> Option<f64> {
    rugged(id, tiles).map(|(range_m, _)| range_m)
}

/// As [`rugged_m`], and whether there may be walls: of towers (`model::towers`).
fn rugged(id: TileId, tiles: &Streaming) -> Option<(f64, bool)> {
    let metres = tiles.elevations_m(id, id.z).filter(|_| rugged::is_coarse(tiles.resolution_m()))?;
    let shore_m = tiles.shore_m(id, id.z).filter(|shore_m| shore_m.least < 0.0)?;
    let around = id.ancestor(AROUND).unwrap_or(id);
    let may_be_rocky = metres.least < rugged::KNOWN_M[1] && reaches_high_latitudes(id);
    let sea_m = if may_be_rocky { SHELF_BED_M } else { ISLAND_BED_M };
    let is_island = tiles.elevations_m(around, around.z).is_some_and(|around| around.least < sea_m);
    let range_of = |metres: Range| metres.greatest - metres.least.max(0.0);
    let about = tiles.elevations_m(id, rugged::DROWNED_LEVEL);
    let is_drowned = shore_m.greatest > -DROWNED_TO_M && about.is_some_and(|about| range_of(about) > HILLS_M);
    let (range_m, is_raised) = (range_of(metres), is_island || is_drowned);
    let mean =
        |id| tiles.elevations_m(id, rugged::ISLAND_LEVEL).is_some_and(|mean| mean.greatest > rugged::DROWNED_SEA_M[0]);
    let has_walls = is_drowned && shore_m.greatest > -WALLS_TO_M && reaches_towers(id) && mean(id);
    (is_raised || range_m > FLAT_M).then_some((if is_raised { range_m.max(RUGGED_M) } else { range_m }, has_walls))
}

/// Whether there may be a coral reef in a tile of the ocean (`model::reefs`).
fn may_have_reef(id: TileId, tiles: &Streaming) -> bool {
    let side = 2f64.powi(-i32::from(id.z));
    let lat = |y: u32| lat_lon_from_map(id.projection, 0.5, f64::from(id.y + y) * side).0;
    let [south, north] = [lat(1), lat(0)];
    let is_warm = id.projection == Projection::Mercator && south.max(0.0).max(-north).sin() < reefs::WARM[1];
    let around = id.ancestor(AROUND).unwrap_or(id);
    let is_deep = || tiles.elevations_m(around, around.z).is_none_or(|around| around.least < ISLAND_BED_M);
    let is_near = || tiles.shore_m(id, id.z).is_none_or(|shore_m| shore_m.least < reefs::REACH_M);
    is_warm && reefs::are_in(tiles.resolution_m()) && is_near() && is_deep()
}

/// Whether a tile has a strip of land by the ocean that waves may run up.
pub fn has_beach(id: TileId, tiles: &Streaming) -> bool {
    let shore_m = tiles.shore_m(id, id.z);
    shore_m.is_some_and(|shore_m| shore_m.least < 0.0 && shore_m.greatest > -BEACH_M)
}

impl Hiding {
    /// Whether any ground in a tile is deep enough.
    fn hides_some(self, id: TileId, tiles: &Streaming) -> bool {
        let is_deep = |metres: Range| -metres.least >= self.depth_m;
        tiles.elevations_m(id, id.z).is_some_and(is_deep)
            && tiles.shore_m(id, id.z).is_some_and(|shore_m| shore_m.greatest > 0.0)
    }

    /// Whether the ground in a tile is ocean all over, and deep enough, wherever shaders look at level `coarsest` or a finer one.
    fn hides(self, id: TileId, coarsest: u8, tiles: &Streaming) -> bool {
        let Some(shore_m) = tiles.shore_m(id, coarsest).map(|metres| metres.least) else { return false };
        if shore_m <= 0.0 || may_have_reef(id, tiles) {
            return false;
        }
        let is_trusted = shore_m >= trusted_m(self.resolution_m);
        // Nearer, the bed depends on the cells around, too: over deeper water and beside land it is steeper than this.
        let coast = Coast::new(Grid::level(-self.depth_m), self.resolution_m, 0.0);
        if !is_trusted && self.beach_slope / USUAL_SLOPE * coast.profile_m(shore_m) < self.depth_m {
            return false;
        }
        let coarsest = if is_trusted { coarsest } else { coarsest.min(grid_level(self.resolution_m)) };
        tiles.elevations_m(id, coarsest).is_some_and(|metres| -metres.greatest >= self.depth_m)
    }
}

/// The tiles whose data a picture of `size` pixels needs, each place once, coarse tiles first, none deeper than the archives. They
/// depend on the view alone: if what has come changed what is asked for, two sets of tiles could drive each other out for ever.
pub fn wanted_tiles(camera: &Camera, size: [u32; 2], tiles: &Streaming) -> Vec<TileId> {
    refined(camera, size, |id, _, visibility, b| Judged {
        shows: visibility.sees(b, [-RELIEF_M, RELIEF_M]),
        divisible: id.z < deepest_tiles(&Layer::ALL, id.projection, tiles),
        finer: 1.0,
        is_steep: false,
        ground_m: 0.0,
    })
}

/// Deepest level of the tiles of any of some layers.
fn deepest_tiles(layers: &[Layer], projection: Projection, tiles: &Streaming) -> u8 {
    layers.iter().map(|&layer| tiles.deepest(layer, projection)).max().unwrap_or(0)
}

/// Deepest level of the ground's mesh over what the archives hold of its shape.
pub fn deepest_mesh(projection: Projection, tiles: &Streaming) -> u8 {
    (deepest_tiles(&Layer::SHAPE, projection, tiles) + LEVELS_BELOW).min(DEEPEST_MESH)
}

/// How wide a pixel, or a cell of the mesh, is on the nearest ground that a tile may have, metres.
fn least_pixel_m(b: &Bounds, visibility: &Visibility) -> f64 {
    (b.centre.distance(visibility.eye) - b.radius - RELIEF_M).max(0.0) * visibility.pixel_angle
}

/// How wide a pixel is, metres, where the ground of some tiles would be nearest to an eye above it: right below, as high as it is anywhere.
pub fn nearest_pixel_m(camera: &Camera, size: [u32; 2], drawn: &[DrawnTile], tiles: &Streaming) -> f64 {
    let highest_m = drawn.iter().map(|tile| heights(tile.id, tiles)[1]).fold(0.0, f64::max);
    (camera.altitude_m - highest_m).max(0.0) * Visibility::new(camera, size).pixel_angle
}

/// The tiles of the ground to draw in a picture of `size` pixels, each place once, coarse tiles first, given what `tiles` at hand say of
/// the ground, and how the sea hides its bed, if it does. Cells are `wider` times as wide as usual. `foot_m` is the elevation of the dry ground at
/// the eye's foot, metres, where that is known.
pub fn drawn_tiles(
    camera: &Camera,
    size: [u32; 2],
    tiles: &Streaming,
    hiding: Option<Hiding>,
    wider: f64,
    foot_m: Option<f64>,
) -> Vec<DrawnTile> {
    let visibility = Visibility::new(camera, size);
    let foot = WGS84.ecef_from_geodetic(Geodetic { lat: camera.lat, lon: camera.lon, height: 0.0 });
    let is_rugged = |id| least_pixel_m(&bounds(id), &visibility) < WIDEST_M && rugged_m(id, tiles).is_some();
    // Gentle ground is no wider in a coarse picture, whose cells all are.
    let gentle = |id, b: &Bounds| fineness(id, b, tiles, hiding).min(1.0 / wider);
    let ids = refined(camera, size, |id, far_m, visibility, b| {
        let shows = visibility.sees(b, heights(id, tiles))
            && !hiding.is_some_and(|h| h.hides(id, coarsest_level(id, b, far_m, visibility), tiles));
        let usual = deepest_mesh(id.projection, tiles);
        // Where no cell is narrow enough for any of the relief the data alone shape the mesh.
        let is_held = shows && wider * CELL_PIXELS * least_pixel_m(b, visibility) < WIDEST_M;
        let Some((range_m, has_walls)) = rugged(id, tiles).filter(|(range_m, _)| is_held && *range_m >= RUGGED_M)
        else {
            return Judged { shows, divisible: id.z < usual, finer: gentle(id, b), is_steep: false, ground_m: 0.0 };
        };
        let ground_m = tiles.elevations_m(id, id.z).map_or(0.0, |m| 0.7 * m.least.max(0.0) + 0.3 * m.greatest);
        // On the way from the eye's foot slopes lead no farther up or down than they are wide, but for walls.
        let reach_m = (b.centre.distance(foot) - b.radius).max(0.0);
        let ground_m =
            foot_m.map_or(ground_m, |foot_m| ground_m.clamp((foot_m - reach_m).max(0.0), foot_m.max(0.0) + reach_m));
        let is_steep = range_m > STEEP_M;
        let finer = if is_steep {
            2.0 / wider
        } else if has_walls {
            1.0 / wider
        } else {
            gentle(id, b) * if id.z < usual { 1.0 } else { 0.5 }
        };
        Judged { shows, divisible: id.z < DEEPEST_RUGGED, finer, is_steep, ground_m }
    });
    let shown = |id| {
        let Some(hiding) = hiding.filter(|h| h.hides_some(id, tiles)) else { return ALL_BLOCKS };
        let b = bounds(id);
        let coarsest = coarsest_level(id, &b, b.centre.distance(visibility.eye) + b.radius, &visibility);
        let shown = blocks_with(id, &|block| block == id || !hiding.hides(block, coarsest, tiles));
        if (ALL_BLOCKS ^ shown).count_ones() < WORTH_HIDING { ALL_BLOCKS } else { shown }
    };
    let bed = |id| {
        let b = bounds(id);
        let far_m = b.centre.distance(visibility.eye) + b.radius;
        let pixel_m = far_m * visibility.pixel_angle;
        if pixel_m > CHORDS_SHOW_M {
            return 0;
        }
        let coarsest = coarsest_level(id, &b, far_m, &visibility);
        // Distances rise by the root of two at most where a spline smooths them.
        let apart_m = SHORE_SAND_M.max(std::f64::consts::SQRT_2 * 0.5 * pixel_m / LEAST_SINKING);
        let has_land = |id| {
            let known = tiles.shore_m(id, coarsest).zip(tiles.elevations_m(id, coarsest));
            known.is_none_or(|(shore_m, metres)| {
                // A sight meets the sea's surface so far before the bed that it sees, and shaders look there as well.
                let seen_m = hiding.map_or(-metres.least, |h| h.depth_m.min(-metres.least));
                let before_m = seen_m * far_m / camera.altitude_m.max(1.0);
                shore_m.least < apart_m + before_m.max(0.0)
            })
        };
        ALL_BLOCKS ^ blocks_with(id, &has_land)
    };
    let drawn = |id| {
        let shown = shown(id);
        let bed = shown & bed(id);
        let bed = if bed.count_ones() < WORTH_HIDING { 0 } else { bed };
        DrawnTile { id, is_rugged: is_rugged(id), shown, bed }
    };
    ids.into_iter().map(drawn).collect()
}

/// How many times finer than usual the cells of a tile have to be for its slope: gentle ones look in wider cells as they do in usual ones, and take much less time.
fn fineness(id: TileId, b: &Bounds, tiles: &Streaming, hiding: Option<Hiding>) -> f64 {
    let known = tiles.elevations_m(id, id.z).zip(tiles.shore_m(id, id.z)).filter(|_| id.z >= GENTLE_LEVEL);
    let Some((metres, shore_m)) = known else { return 1.0 };
    // The range is that of the archive's texels about it.
    let texel_m = texel_size_m(id.projection, id.z.min(tiles.deepest(Layer::Terrain, id.projection)), b.lat);
    let width_m = (texel_size_m(id.projection, id.z, b.lat) * TILE_TEXELS as f64).max(4.0 * texel_m);
    // The sea hides what is deeper.
    let seen_m = |metres: f64| hiding.map_or(metres, |h| metres.max(-h.depth_m));
    let slope = (seen_m(metres.greatest) - seen_m(metres.least)) / width_m;
    let has_shore = shore_m.least < SHORE_SHAPED_M && shore_m.greatest > -SHORE_SHAPED_M;
    if has_shore { 1.0 } else { (slope / GENTLE_SLOPE).clamp(GENTLEST, 1.0) }
}

/// The coarsest level that shaders look at in a tile with these bounds, `far_m` from the eye where it is farthest.
fn coarsest_level(id: TileId, b: &Bounds, far_m: f64, visibility: &Visibility) -> u8 {
    // Texels are as wide as pixels, and no more than 16 tiles of a level lie between the eye and a place that looks at it.
    let texel_m = far_m * visibility.pixel_angle.max(1.0 / (16.0 * TILE_TEXELS as f64));
    // Texels are narrowest towards a pole; a bounding radius spans half of that much latitude at most.
    let lat = (b.lat.abs() + 2.0 * b.radius / WGS84.b).min(std::f64::consts::FRAC_PI_2);
    let whole_m = texel_size_m(id.projection, 0, if id.projection == Projection::South { -lat } else { lat });
    (whole_m / texel_m.max(1.0)).log2().floor().clamp(0.0, 24.0) as u8
}
