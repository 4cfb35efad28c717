//! `bake` on a small synthetic world, and what reads its archives: round trips, repetition, damage.

use crate::small_world::{self, Folder, baked, run};
use ocean_globe::cli::sample::{SampleArgs, sample};
use ocean_globe::data::TileTexels;
use ocean_globe::data::tile::{Layer, Projection, TileId};
use ocean_globe::data::world::{Arrival, Outcome, World, archive_name};
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

fn archives() -> Vec<String> {
    let maps = Layer::SHAPE.into_iter().flat_map(|layer| Projection::ALL.map(|map| archive_name(layer, map)));
    maps.collect()
}

fn mercator(z: u8, x: u32, y: u32) -> TileId {
    TileId::new(Projection::Mercator, z, x, y).unwrap()
}

/// Asks for tiles and waits for all answers.
fn load(world: &mut World, wishes: &[(Layer, TileId)]) -> Vec<Arrival> {
    wishes.iter().for_each(|(layer, id)| world.request(*layer, *id));
    let deadline = Instant::now() + Duration::from_secs(60);
    let mut arrivals = Vec::new();
    while arrivals.len() < wishes.len() {
        assert!(Instant::now() < deadline, "{} answers of {}", arrivals.len(), wishes.len());
        arrivals.extend(world.poll());
        std::thread::sleep(Duration::from_millis(2));
    }
    arrivals
}

fn outcome(arrivals: &[Arrival], layer: Layer, id: TileId) -> &Outcome {
    &arrivals.iter().find(|a| a.layer == layer && a.id == id).unwrap().outcome
}

#[test]
fn the_same_input_gives_the_same_bytes_and_nothing_else_is_left() {
    let (first, second) = (baked("same-1"), baked("same-2"));
    for name in archives() {
        let bytes = fs::read(first.path().join(&name)).unwrap();
        assert!(bytes.len() > 200, "{name}");
        assert_eq!(bytes, fs::read(second.path().join(&name)).unwrap(), "{name}");
    }
    let mut left: Vec<_> =
        fs::read_dir(first.path()).unwrap().map(|f| f.unwrap().file_name().into_string().unwrap()).collect();
    left.retain(|name| !name.ends_with(".nc"));
    left.sort();
    let mut expected = archives();
    expected.sort();
    assert_eq!(left, expected);
}

#[test]
fn the_baked_world_says_what_was_put_in() {
    let folder = baked("contents");
    let data = folder.path().to_str().unwrap();
    let at =
        |place: &str| sample(&SampleArgs { at: place.into(), data: data.into(), ..SampleArgs::default() }).unwrap();
    // Place, class, elevation: the continent is 500 m high, the basin inland -100 m, the sea 3,000 m deep.
    for (place, class, metres) in [
        ("10,10", "land", 500.0),
        ("30,30", "lake", 500.0),
        ("30.5,30.5", "island", 500.0),
        ("0,30", "land", -100.0),
        ("0,-90", "ocean", -3000.0),
        ("0,180", "ocean", -3000.0),
        ("90,0", "ocean", -3000.0),
        ("-90,0", "land", 500.0),
    ] {
        let found = at(place);
        assert_eq!(found["class"], class, "{place}: {found}");
        // Steps of 32 m, hence ±16 m.
        assert!((found["elevation_m"].as_f64().unwrap() - metres).abs() <= 16.0, "{place}: {found}");
    }
    // The west coast runs along longitude 0, between columns of cells: one degree is 111.3 km on the equator.
    for degrees in [-1.0, -0.4, -0.1, 0.1, 0.4, 1.0f64] {
        let found = at(&format!("0,{degrees}"))["shore_distance_m"].as_f64().unwrap();
        let texel_m = 40_075_017.0 / 256.0 / 16.0;
        assert!((found + degrees * 111_319.0).abs() < 0.15 * texel_m, "{degrees}: {found}");
    }
    // The coast is sunk and shallow beside the shore, whatever the grid says.
    let beside = at("0,-0.05");
    assert!(beside["depth_m"].as_f64().unwrap() < 200.0, "{beside}");
    assert!(at("-10,0.05")["elevation_m"].as_f64().unwrap() >= -7.0);
}

#[test]
fn deeper_tiles_are_only_where_a_coast_is_and_their_parents_serve_elsewhere() {
    let folder = baked("levels");
    let mut world = World::open(folder.path().to_str().unwrap());
    let coast = mercator(4, 8, 7);
    let open_sea = mercator(4, 2, 7);
    let arrivals = load(
        &mut world,
        &[
            (Layer::Water, coast),
            (Layer::Water, open_sea),
            (Layer::Water, mercator(0, 0, 0)),
            (Layer::Water, mercator(9, 0, 0)),
            (Layer::Terrain, mercator(1, 0, 0)),
        ],
    );
    assert!(
        matches!(outcome(&arrivals, Layer::Water, coast), Outcome::Tile(_)),
        "{:?}",
        outcome(&arrivals, Layer::Water, coast)
    );
    assert!(matches!(outcome(&arrivals, Layer::Water, open_sea), Outcome::Absent));
    assert!(matches!(outcome(&arrivals, Layer::Water, mercator(9, 0, 0)), Outcome::Absent));
    let Outcome::Tile(texels) = outcome(&arrivals, Layer::Terrain, mercator(1, 0, 0)) else { panic!() };
    assert!(matches!(&**texels, TileTexels::Terrain(metres) if metres.len() == 65_536));
    assert_eq!((world.pending(), world.progress()), (0, 1.0));
    assert_eq!(world.max_zoom(Layer::Water, Projection::Mercator), Some(4));
    assert_eq!(world.resolution_m(Layer::Water, Projection::Mercator), Some(111_319.0));
    assert_eq!(world.credits(), ["somebody's heights", "somebody's coasts"]);
    // From the cache only, with the parent of the missing tile.
    let (lat, lon) = (5f64.to_radians(), -120f64.to_radians());
    let resident = world.sample_resident(lat, lon).unwrap();
    assert_eq!((resident.terrain_level, resident.water_level), (1, Some(0)));
    let blocking = world.sample_blocking(lat, lon).unwrap();
    assert_eq!((blocking.terrain_level, blocking.class), (1, resident.class));
    // Asking again brings the tile again, from the cache.
    assert!(matches!(load(&mut world, &[(Layer::Water, coast)])[0].outcome, Outcome::Tile(_)));
}

#[test]
fn a_broken_archive_does_not_take_down_the_others() {
    let folder = baked("broken");
    // The tiles of one archive are zeroed, another one is cut short, a third one is gone.
    let water = folder.path().join("water.pmtiles");
    let mut bytes = fs::read(&water).unwrap();
    let data = u64::from_le_bytes(bytes[56..64].try_into().unwrap()) as usize;
    bytes[data..].fill(0);
    fs::write(&water, bytes).unwrap();
    let north = folder.path().join("terrain-north.pmtiles");
    fs::write(&north, &fs::read(&north).unwrap()[..90]).unwrap();
    fs::remove_file(folder.path().join("water-north.pmtiles")).unwrap();
    let mut world = World::open(folder.path().to_str().unwrap());
    let root = TileId::root;
    let arrivals = load(
        &mut world,
        &[
            (Layer::Water, root(Projection::Mercator)),
            (Layer::Terrain, root(Projection::North)),
            (Layer::Water, root(Projection::North)),
            (Layer::Terrain, root(Projection::Mercator)),
            (Layer::Water, root(Projection::South)),
        ],
    );
    for (layer, map, part) in [
        (Layer::Water, Projection::Mercator, "water tile mercator 0/0/0: cannot be read as PNG"),
        (Layer::Terrain, Projection::North, "ends after 90 bytes"),
        (Layer::Water, Projection::North, "water-north.pmtiles"),
    ] {
        let Outcome::Failed(error) = outcome(&arrivals, layer, root(map)) else { panic!("{layer:?} {map:?}") };
        assert!(error.to_string().contains(part), "{error}");
    }
    for (layer, map) in [(Layer::Terrain, Projection::Mercator), (Layer::Water, Projection::South)] {
        assert!(matches!(outcome(&arrivals, layer, root(map)), Outcome::Tile(_)), "{layer:?} {map:?}");
    }
}

#[test]
fn unsuitable_input_is_refused_with_a_remedy_and_leaves_no_archive() {
    let folder = Folder::new("refused");
    let write = |name: &str, bytes: &[u8]| {
        fs::write(folder.path().join(name), bytes).unwrap();
        folder.path().join(name)
    };
    let [mask, elevation] = small_world::inputs(folder.path());
    let (good_mask, good_elevation) = (fs::read(&mask).unwrap(), fs::read(&elevation).unwrap());
    let southern_half = small_world::mask_rows(0..90);
    let hdf5 = b"\x89HDF\r\n\x1a\n".to_vec();
    for (name, bad_mask, bytes, part) in [
        ("text.nc", true, b"no netCDF at all".to_vec(), "is no netCDF file"),
        ("hdf5.nc", false, hdf5, "nccopy -k classic"),
        ("header.nc", true, good_mask[..60].to_vec(), "ends within its header"),
        ("cut.nc", true, good_mask[..good_mask.len() / 2].to_vec(), "ends before the values"),
        ("half.nc", true, southern_half, "pole to pole"),
        ("swapped.nc", true, good_elevation, "not as bytes"),
        ("empty.nc", false, Vec::new(), "is no netCDF file"),
    ] {
        let bad = write(name, &bytes);
        let (mask, elevation) = if bad_mask { (&bad, &elevation) } else { (&mask, &bad) };
        let error = run(mask, elevation, folder.path()).unwrap_err().to_string();
        assert!(error.contains(part), "{name}: {error}");
        assert!(!folder.path().join("terrain.pmtiles").exists(), "{name}");
    }
    let error = run(Path::new("no-such.nc"), &elevation, folder.path()).unwrap_err().to_string();
    assert!(error.contains("no-such.nc"), "{error}");
}
