//! Map tiles in view: what the sea hides is deep ocean all over, wherever one looks closer.

use std::time::{Duration, Instant};

use ocean_globe::data::streaming::Streaming;
use ocean_globe::data::tile::{MapPoint, Projection, TileId, lat_lon_from_map};
use ocean_globe::data::world::World;
use ocean_globe::model::earth::{Geodetic, WGS84};
use ocean_globe::model::optics::{OPAQUE_ALPHA, opaque_depth_m, water_alpha};
use ocean_globe::model::relief::WIDEST_M;
use ocean_globe::pass::land::GRID;
use ocean_globe::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};
use ocean_globe::scene::view::map_tiles::{
    BLOCKS, DrawnTile, Hiding, SHORE_SAND_M, deepest_mesh, drawn_tiles, wanted_tiles,
};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [640, 360];

/// Loads all that a view needs.
fn load(streaming: &mut Streaming, world: &mut World, camera: &Camera) {
    let start = Instant::now();
    loop {
        streaming.receive(world);
        let wanted = wanted_tiles(camera, SIZE, streaming);
        if streaming.want(world, &wanted, camera.geodetic()) {
            return;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "still loading after a minute");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Whether one of two tiles holds the other.
fn overlap(a: TileId, b: TileId) -> bool {
    a.ancestor(b.z) == Some(b) || b.ancestor(a.z) == Some(a)
}

/// Places in a tile: its corners and some between, pulled in by a hair.
fn places(id: TileId) -> impl Iterator<Item = (f64, f64)> {
    let side = 2f64.powi(-i32::from(id.z));
    let steps = (0..9).map(|i| f64::from(i).mul_add(0.124, 0.004));
    steps
        .clone()
        .flat_map(move |x| steps.clone().map(move |y| (x, y)))
        .map(move |(x, y)| lat_lon_from_map(id.projection, (f64::from(id.x) + x) * side, (f64::from(id.y) + y) * side))
}

/// The tiles that a view draws.
fn drawn_ids(camera: &Camera, streaming: &Streaming, hiding: Option<Hiding>) -> Vec<TileId> {
    drawn_tiles(camera, SIZE, streaming, hiding, 1.0, None).into_iter().map(|tile| tile.id).collect()
}

#[test]
fn more_tiles_than_there_is_room_for_are_loaded_as_far_as_there_is() {
    let (mut streaming, mut world) = (Streaming::default(), World::open(DATA));
    // The roots of all maps have been seen, and stay.
    let roots = Projection::ALL.map(|projection| TileId { projection, z: 0, x: 0, y: 0 });
    let eye = Geodetic { lat: 0.8, lon: 0.15, height: 100.0 };
    let home = MapPoint::from_lat_lon(eye.lat, eye.lon);
    let deep = home.tile(7);
    let many: Vec<_> = (0..400).map(|i| TileId { x: deep.x - 10 + i % 20, y: deep.y - 10 + i / 20, ..deep }).collect();
    let start = Instant::now();
    for tiles in [&roots[..], &many[..]] {
        loop {
            streaming.receive(&mut world);
            if streaming.want(&mut world, tiles, eye) {
                break;
            }
            assert!(start.elapsed() < Duration::from_secs(60), "still loading {} tiles after a minute", tiles.len());
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}

#[test]
fn relief_is_made_where_pixels_are_narrow_enough_for_it() {
    let (mut streaming, mut world) = (Streaming::default(), World::open(DATA));
    let mut tiles_of = |altitude_m: f64| {
        let camera = Camera::from_degrees(46.5, 9.0, altitude_m, 0.0, 0.0);
        load(&mut streaming, &mut world, &camera);
        drawn_tiles(&camera, SIZE, &streaming, None, 1.0, None)
    };
    // Over the Alps. Pixels of a picture of 360 rows that shows 45 degrees are 2.2 mm wide a metre of distance; those of 4,096 m and more show no relief.
    let mut rugged = |altitude_m: f64| {
        let tiles = tiles_of(altitude_m);
        println!("{altitude_m} m: {} of {} tiles", tiles.iter().filter(|tile| tile.is_rugged).count(), tiles.len());
        tiles.iter().any(|tile| tile.is_rugged)
    };
    let widest_m = WIDEST_M / (2.0 * (FIELD_OF_VIEW_Y / 2.0).tan() / f64::from(SIZE[1]));
    assert_eq!([0.1, 0.5, 0.9, 3.0].map(|part| part * widest_m).map(&mut rugged), [true, true, true, false]);
}

#[test]
fn tiles_with_cells_twice_as_wide_are_those_above_the_usual_ones() {
    let (mut streaming, mut world) = (Streaming::default(), World::open(DATA));
    // Over the Alps, and a coast.
    for (lat, lon, altitude_m) in [(46.5, 9.0, 30_000.0), (28.8545, -13.792, 560.0)] {
        let camera = Camera::from_degrees(lat, lon, altitude_m, 253.0, 71.0);
        load(&mut streaming, &mut world, &camera);
        let [usual, wide] = [1.0, 2.0].map(|wider| drawn_tiles(&camera, SIZE, &streaming, None, wider, None));
        println!("{lat}, {lon}: {} tiles, {} with wide cells", usual.len(), wide.len());
        // Nothing is left out, and what has relief keeps it.
        assert!(3 * wide.len() < 2 * usual.len(), "{} of {}", wide.len(), usual.len());
        for tile in &usual {
            let holds = |other: &&DrawnTile| tile.id.ancestor(other.id.z) == Some(other.id);
            let over = wide.iter().find(holds).unwrap_or_else(|| panic!("nothing over {}", tile.id));
            assert!(over.is_rugged >= tile.is_rugged, "{} over {}", over.id, tile.id);
        }
    }
}

/// How far the data's ground is off the chords of a tile's cells, pixels as an eye would see it from the side: in the middle of some.
fn chords_off_pixels(id: TileId, camera: &Camera, world: &mut World) -> Vec<f64> {
    let eye = camera.eye_ecef();
    let pixel_angle = 2.0 * (FIELD_OF_VIEW_Y / 2.0).tan() / f64::from(SIZE[1]);
    let side = 2f64.powi(-i32::from(id.z));
    let mut place = |column: f64, row: f64| {
        let at =
            [(f64::from(id.x) + column / f64::from(GRID)) * side, (f64::from(id.y) + row / f64::from(GRID)) * side];
        let (lat, lon) = lat_lon_from_map(id.projection, at[0], at[1]);
        let found = world.sample_blocking(lat, lon).unwrap();
        let ground = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
        let shore_m = found.shore_distance_m.unwrap_or(f64::NEG_INFINITY);
        (
            found.elevation_measured_m,
            ground.distance(eye),
            shore_m < -500.0 && found.lake_distance_m.is_none_or(|m| m < 0.0),
        )
    };
    let mut off = Vec::new();
    let some = || (1..GRID).step_by(3).map(f64::from);
    for row in some() {
        for column in some() {
            let [a, b, middle] = [0.0, 1.0, 0.5].map(|part| place(column + part, row + part));
            if a.2 && b.2 && middle.2 {
                off.push((middle.0 - 0.5 * (a.0 + b.0)).abs() / (middle.1 * pixel_angle));
            }
        }
    }
    off
}

#[test]
fn cells_are_wide_where_slopes_are_gentle_and_no_pixel_off_the_ground() {
    let (mut streaming, mut world) = (Streaming::default(), World::open(DATA));
    // From one height over the plain of the Pannonian basin, the Sahara, hills of Umbria, and the Alps, whose ridges are steeper than cells are narrow.
    let places = [(47.0, 20.5, true), (23.0, 10.0, true), (43.0, 12.5, true), (46.5, 9.0, false)];
    let [plain, desert, hills, alps] = places.map(|(lat, lon, is_gentle)| {
        let camera = Camera::from_degrees(lat, lon, 3_000.0, 253.0, 71.0);
        load(&mut streaming, &mut world, &camera);
        let tiles = drawn_tiles(&camera, SIZE, &streaming, None, 1.0, None);
        if !is_gentle {
            return tiles.len();
        }
        let mut off: Vec<f64> = tiles.iter().flat_map(|tile| chords_off_pixels(tile.id, &camera, &mut world)).collect();
        off.sort_by(f64::total_cmp);
        let [most, usual] = [off.len() - 1, off.len() * 99 / 100].map(|at| off[at]);
        println!("{lat}, {lon}: {} tiles; chords {usual:.2} pixels off, at most {most:.2}", tiles.len());
        // Half a pixel by slopes over whole tiles; hills may be narrower than tiles, and the archive's elevations are whole metres.
        assert!(usual < 0.5 && most < 1.0, "{usual} and {most}");
        tiles.len()
    });
    assert!(2 * plain < alps && plain < hills && desert < hills, "{plain}, {desert}, {hills}, {alps}");
}

#[test]
fn what_the_sea_hides_is_deep_ocean_and_a_bed_alone_is_ocean() {
    let (mut streaming, mut world) = (Streaming::default(), World::open(DATA));
    let (mut judged, mut hidden_blocks, mut bed_blocks) = (0, 0, 0);
    // Coasts with islets, an archipelago, a shelf sea, the antimeridian, both polar maps; water of three densities.
    for (place, rho) in [
        ([28.8545, -13.792, 560.0, 253.0, 71.0], 0.2),
        ([28.8545, -13.792, 30_000.0, 253.0, 20.0], 0.1),
        ([-17.6, 179.9, 2_000.0, 90.0, 80.0], 0.3),
        ([54.5, 3.0, 300.0, 180.0, 75.0], 0.2),
        ([60.2, 21.0, 5_000.0, 200.0, 60.0], 0.2),
        ([35.68, -14.25, 2.0, 262.0, 83.0], 0.1),
        ([86.0, 20.0, 20_000.0, 10.0, 60.0], 0.2),
        ([-76.5, 170.0, 20_000.0, 180.0, 60.0], 0.2),
        ([29.0, -14.0, 300_000.0, 0.0, 0.0], 0.2),
        ([16.0, -25.0, 3e7, 0.0, 0.0], 0.2),
    ] {
        let [lat, lon, altitude_m, heading, tilt] = place;
        let camera = Camera::from_degrees(lat, lon, altitude_m, heading, tilt);
        let hiding = Hiding { depth_m: opaque_depth_m(rho), resolution_m: 9_277.0, beach_slope: 0.03 };
        load(&mut streaming, &mut world, &camera);
        let all = drawn_ids(&camera, &streaming, None);
        let parts = drawn_tiles(&camera, SIZE, &streaming, Some(hiding), 1.0, None);
        let drawn: Vec<_> = parts.iter().map(|tile| tile.id).collect();
        let whole = all.into_iter().filter(|id| !drawn.iter().any(|other| overlap(*id, *other)));
        let blocks = parts.iter().flat_map(|tile| {
            let block = |x: u32, y: u32| TileId {
                z: tile.id.z + 2,
                x: tile.id.x * BLOCKS + x,
                y: tile.id.y * BLOCKS + y,
                ..tile.id
            };
            let is_shown = |x: u32, y: u32| tile.shown >> (y * BLOCKS + x) & 1 != 0;
            let all = (0..BLOCKS).flat_map(|y| (0..BLOCKS).map(move |x| (x, y)));
            all.filter(move |(x, y)| !is_shown(*x, *y)).map(move |(x, y)| block(x, y))
        });
        let blocks: Vec<_> = blocks.collect();
        hidden_blocks += blocks.len();
        let hidden: Vec<_> = whole.chain(blocks.iter().copied()).collect();
        for id in &hidden {
            for (lat, lon) in places(*id) {
                let sample = world.sample_blocking(lat, lon).unwrap();
                let depth_m = sample.depth_m.unwrap_or_else(|| panic!("{id} of {place:?} holds land at {lat}, {lon}"));
                // Half a texel's mix at the edge of a tile, and the rounding of distances, move the depth near the threshold.
                let alpha = water_alpha(rho, depth_m);
                assert!(alpha > OPAQUE_ALPHA - 0.002, "{id} of {place:?}: {depth_m} m deep at {lat}, {lon}");
                judged += 1;
            }
        }
        // A bed alone has nothing of the land, nor of its shore's sand.
        for tile in &parts {
            for block in (0..BLOCKS * BLOCKS).filter(|block| tile.bed >> block & 1 != 0) {
                let [x, y] = [block % BLOCKS, block / BLOCKS];
                let id = TileId { z: tile.id.z + 2, x: tile.id.x * BLOCKS + x, y: tile.id.y * BLOCKS + y, ..tile.id };
                for (lat, lon) in places(id) {
                    let sample = world.sample_blocking(lat, lon).unwrap();
                    let shore_m = sample.shore_distance_m.unwrap_or(f64::INFINITY);
                    assert!(sample.depth_m.is_some() && shore_m >= SHORE_SAND_M, "{id}: {shore_m} m at {lat}, {lon}");
                }
                bed_blocks += 1;
            }
        }
        println!(
            "{place:?}: {} drawn but for {} blocks, {} hidden",
            drawn.len(),
            blocks.len(),
            hidden.len() - blocks.len()
        );
    }
    assert!(bed_blocks > 300, "only {bed_blocks} blocks of a bed alone");
    // 81 places in each.
    assert!(
        judged > 81 * (hidden_blocks + 50) && hidden_blocks > 300,
        "only {judged} places judged, {hidden_blocks} blocks"
    );
}

#[test]
fn over_the_open_ocean_no_bed_is_drawn_and_under_an_eye_in_it_all_of_it() {
    let (mut streaming, mut world) = (Streaming::default(), World::open(DATA));
    let camera = Camera::from_degrees(35.6812, -14.25, 2.0, 262.0, 83.0);
    let hiding = Hiding { depth_m: opaque_depth_m(0.2), resolution_m: 9_277.0, beach_slope: 0.03 };
    load(&mut streaming, &mut world, &camera);
    let [all, drawn] = [None, Some(hiding)].map(|hiding| drawn_ids(&camera, &streaming, hiding));
    assert!(drawn.is_empty(), "{drawn:?}");
    // Shores are known down to level 13, more finely than any mesh is: its cells are 76 m wide at the equator, 16 of them to a tile.
    assert_eq!(deepest_mesh(Projection::Mercator, &streaming), 15);
    assert_eq!(all.iter().map(|id| id.z).max(), Some(15), "{all:?}");
}
