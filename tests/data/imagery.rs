//! The land's imagery: what the bundled archives hold against their source, and what `bake` makes of a picture whose colours are known.

use std::fs;
use std::path::Path;

use ocean_globe::cli::bake::bake;
use ocean_globe::data::fetch::Source;
use ocean_globe::data::imagery;
use ocean_globe::data::pmtiles::Archive;
use ocean_globe::data::tile::{Layer, MapPoint, Projection, TILE_TEXELS, TileId, lat_lon_from_map};
use ocean_globe::data::world::{World, archive_name};

use crate::small_world::{self, Folder};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

fn archive(folder: &str, projection: Projection) -> Archive<Source> {
    let path = Path::new(folder).join(archive_name(Layer::Imagery, projection));
    pollster::block_on(Archive::open(Source::new(path.to_str().unwrap()))).unwrap()
}

fn texels(archive: &Archive<Source>, id: TileId) -> Option<Vec<[u8; 4]>> {
    let bytes = pollster::block_on(archive.tile(id.z, id.x, id.y)).unwrap()?;
    Some(imagery::decode(&id.to_string(), &bytes).unwrap())
}

/// The texel of the finest tile that holds a place.
fn colour_at(lat: f64, lon: f64) -> [u8; 3] {
    let point = MapPoint::from_lat_lon(lat, lon);
    let archive = archive(DATA, point.projection);
    let deepest = archive.header().max_zoom;
    let (z, texels) = (0..=deepest).rev().find_map(|z| Some((z, texels(&archive, point.tile(z))?))).unwrap();
    let (column, row) = point.texel(z);
    let [r, g, b, _] = texels[row as usize % TILE_TEXELS * TILE_TEXELS + column as usize % TILE_TEXELS];
    [r, g, b]
}

#[test]
fn forty_places_have_the_colours_of_the_source() {
    let text = include_str!("../oracles/imagery.json");
    let oracle: serde_json::Value = serde_json::from_str(text).unwrap();
    let places = oracle["places"].as_array().unwrap();
    assert_eq!(places.len(), 40);
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
    };
    let mut worst = 0.0f64;
    for place in places {
        let degrees = |key: &str| place[key].as_f64().unwrap();
        let found = colour_at(degrees("lat").to_radians(), degrees("lon").to_radians());
        let (srgb, spread) = (numbers(&place["srgb"]), numbers(&place["spread"]));
        for ((found, srgb), spread) in found.into_iter().zip(srgb).zip(spread) {
            // The place is the middle of nine pixels; a texel lies up to half a pixel beside it. Six steps: the JPEG's, at quality 90.
            let error = (f64::from(found) - srgb).abs() - spread / 2.0;
            worst = worst.max(error);
            assert!(error <= 6.0, "{}: {found} against {srgb} ± {}", place["name"], spread / 2.0);
        }
    }
    println!("beyond half of what the pixels around differ by, steps of 255: {worst:.1} at most");
}

#[test]
fn the_bundle_stays_small_and_says_whose_it_is() {
    let sizes: Vec<(String, u64)> = fs::read_dir(DATA)
        .unwrap()
        .map(|file| file.unwrap())
        .map(|file| (file.file_name().into_string().unwrap(), file.metadata().unwrap().len()))
        .collect();
    let sum = |part: &str| sizes.iter().filter(|(name, _)| name.starts_with(part)).map(|(_, size)| size).sum::<u64>();
    println!("{} bytes, {} of them imagery", sum(""), sum("imagery"));
    assert!(sum("") <= 48_000_000 && sum("imagery") <= 8_000_000, "{sizes:?}");
    for projection in Projection::ALL {
        let archive = archive(DATA, projection);
        assert_eq!(archive.header().tile_type, 3, "JPEG");
        assert!(archive.metadata()["attribution"].as_str().unwrap().contains("NASA"));
    }
}

#[test]
fn a_bundled_tile_decodes_to_the_bytes_that_every_platform_gets() {
    let texels = texels(&archive(DATA, Projection::Mercator), TileId::root(Projection::Mercator)).unwrap();
    let hash = texels
        .as_flattened()
        .iter()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3));
    assert_eq!(hash, HASH, "{hash:#018x}");
}

/// FNV-1a of the root tile's texels; it changes with the archive, and must not with the decoder.
const HASH: u64 = 0xc87b_10ea_a4ef_8843;

const LAND: [u8; 3] = [200, 120, 60];
const WATER: [u8; 3] = [10, 40, 160];

/// The small world with imagery: land of one colour, water of another.
fn painted(name: &str) -> Folder {
    let folder = small_world::baked(name);
    let (width, height) = (720u32, 360u32);
    let pixels = (0..width * height).flat_map(|at| {
        let lat = 90.0 - (f64::from(at / width) + 0.5) / 2.0;
        let lon = (f64::from(at % width) + 0.5) / 2.0 - 180.0;
        if matches!(small_world::class(lat, lon), 1 | 3) { LAND } else { WATER }
    });
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().unwrap().write_image_data(&pixels.collect::<Vec<u8>>()).unwrap();
    let path = folder.path().join("picture.png");
    fs::write(&path, bytes).unwrap();
    bake(&small_world::imagery(&path, folder.path())).unwrap();
    folder
}

#[test]
fn no_water_bleeds_into_the_land_and_the_open_sea_has_no_tiles() {
    let folder = painted("imagery");
    let data = folder.path().to_str().unwrap();
    let mut tiles = 0;
    for projection in Projection::ALL {
        let archive = archive(data, projection);
        for z in 0..=archive.header().max_zoom {
            for (x, y) in (0..1u32 << z).flat_map(|x| (0..1u32 << z).map(move |y| (x, y))) {
                let id = TileId { projection, z, x, y };
                let Some(texels) = texels(&archive, id) else { continue };
                tiles += 1;
                for (at, texel) in texels.iter().enumerate() {
                    let off = texel.iter().zip(LAND).map(|(a, b)| a.abs_diff(b)).max().unwrap();
                    // A flat JPEG is off by the rounding of its means.
                    assert!(off <= 2, "{id} texel {at}: {texel:?}");
                }
            }
        }
    }
    assert!(tiles > 20, "{tiles} tiles");
    let mercator = archive(data, Projection::Mercator);
    let at = |z, lat: f64, lon: f64| MapPoint::from_lat_lon(lat.to_radians(), lon.to_radians()).tile(z);
    for (lat, lon, there) in [(10.0, 10.0, true), (10.0, -100.0, false), (-20.0, 170.0, false)] {
        assert_eq!(texels(&mercator, at(3, lat, lon)).is_some(), there, "{lat}, {lon}");
    }
    // Nothing of the world's shape is touched, and the same picture gives the same bytes.
    let again = painted("imagery-again");
    for layer in Layer::ALL {
        let name = archive_name(layer, Projection::Mercator);
        let [first, second] = [&folder, &again].map(|folder| fs::read(folder.path().join(&name)).unwrap());
        assert!(first == second, "{name}");
    }
}

#[test]
fn a_world_may_lack_imagery() {
    let folder = small_world::baked("no-imagery");
    let mut world = World::open(folder.path().to_str().unwrap());
    assert!(world.has(Layer::Imagery, Projection::Mercator), "nobody has looked yet");
    world.request(Layer::Imagery, TileId::root(Projection::Mercator));
    let start = std::time::Instant::now();
    while world.pending() > 0 || !world.settled() {
        world.poll();
        // A file that is missing is not waited for: the second look at one that cannot be read comes after a second.
        assert!(start.elapsed().as_secs_f64() < 0.9, "still waiting for imagery that is not there");
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    assert!(!world.has(Layer::Imagery, Projection::Mercator) && world.has(Layer::Water, Projection::Mercator));
    assert_eq!(world.failure(), None);
    assert_eq!(world.credits(), ["somebody's heights", "somebody's coasts"]);
}

#[test]
fn the_whole_square_has_colours_where_the_sea_is_too() {
    // Filters of the coast look over it: the fill leaves no hole.
    let texels = texels(&archive(DATA, Projection::Mercator), TileId::root(Projection::Mercator)).unwrap();
    let blue = texels.iter().enumerate().filter(|(_, [r, g, b, _])| i32::from(*b) > 20 + i32::from(*r.max(g)));
    let mut places: Vec<_> = blue
        .map(|(at, _)| {
            let centre = |index: usize| (index as f64 + 0.5) / TILE_TEXELS as f64;
            let place = lat_lon_from_map(Projection::Mercator, centre(at % TILE_TEXELS), centre(at / TILE_TEXELS));
            [place.0.to_degrees().round(), place.1.to_degrees().round()]
        })
        .collect();
    // Beyond 84 degrees the polar squares serve.
    places.retain(|[lat, _]| lat.abs() < 84.0);
    assert!(places.is_empty(), "{} texels are bluer than anything dry, e.g. {:?}", places.len(), places.first());
}
