//! `bake --bed` and `--coast` with files of one's own.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;
use ocean_globe::cli::bake::{BakeArgs, bake};
use ocean_globe::data::water::WaterClass;
use ocean_globe::data::world::World;
use ocean_globe::error::Result;

use crate::own_files::{
    CORNER, MIDDLE, RADIUS_DEG, SIDE, STEP_DEG, cone_m, flatgeobuf, geojson, geotiff, grid, keys, shapefile,
    shapefile_of, tiled,
};
use crate::small_world::{Folder, baked as small_world_of, nothing};

fn write(folder: &Folder, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    path
}

fn run(bed: &Path, coast: &Path, output: &Path) -> Result<()> {
    let (bed, coast) = (Some(bed.into()), Some(coast.into()));
    bake(&BakeArgs { bed, coast, coast_zoom: 8, bed_zoom: Some(9), ..nothing(output) })
}

/// The island's world, of a GeoTIFF and GeoJSON.
fn island(name: &str) -> Folder {
    let folder = Folder::new(name);
    let bed = write(&folder, "bed.tif", geotiff(&grid(), &keys(2, 4326), None));
    let coast = write(&folder, "coast.geojson", geojson());
    run(&bed, &coast, folder.path()).unwrap();
    folder
}

#[test]
fn an_island_of_ones_own_is_where_it_was_put_and_as_high() {
    let folder = island("own-island");
    let mut world = World::open(folder.path().to_str().unwrap());
    let mut at = |lat: f64, lon: f64| world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
    let degree_m = 110_600.0;
    let mut worst = [0.0f64; 2];
    for i in 0..48 {
        let (sin, cos) = (f64::from(i) * 2.4).sin_cos();
        let out = RADIUS_DEG * (0.35 + 1.5 * f64::from(i) / 48.0);
        let (lat, lon) = (MIDDLE[0] + out * sin, MIDDLE[1] + out * cos / MIDDLE[0].to_radians().cos());
        let found = at(lat, lon);
        let wanted_m = (out - RADIUS_DEG) * degree_m;
        let off_m = (found.shore_distance_m.unwrap() - wanted_m).abs();
        // The tolerance of 50 m, bends of some 25 m, and what a degree on the map's sphere and on the ellipsoid differ by, 0.7 %; texels
        // that are as wide as the distance allows take 2 %.
        assert!(off_m < 90.0 + 0.03 * wanted_m.abs(), "{lat} {lon}: {off_m} m off");
        worst[0] = worst[0].max(off_m);
        if wanted_m.abs() > 500.0 {
            assert_eq!(found.class, if wanted_m > 0.0 { WaterClass::Ocean } else { WaterClass::Land }, "{lat} {lon}");
            // Steps of the archive are a sixteenth of the height or less, texels of level 9 as wide as nodes: a slope of 400 m in 8.9 km.
            let off_m = (found.elevation_measured_m - cone_m(lat, lon)).abs();
            assert!(off_m < 4.0 + cone_m(lat, lon).abs() / 32.0, "{lat} {lon}: {off_m} m off in height");
            worst[1] = worst[1].max(off_m);
        }
    }
    println!("shores within {:.0} m, heights within {:.1} m", worst[0], worst[1]);
    // Its lake, and the rest of the world.
    assert_eq!(at(MIDDLE[0], MIDDLE[1]).class, WaterClass::Lake);
    for (lat, lon) in [(0.0, 100.0), (45.0, -60.0), (89.0, 0.0), (-88.0, 5.0)] {
        let found = at(lat, lon);
        assert_eq!(found.class, WaterClass::Ocean, "{lat} {lon}");
        assert!((found.depth_m.unwrap() - 4000.0).abs() < 200.0, "{lat} {lon}: {found:?}");
    }
}

#[test]
fn every_format_makes_the_same_world() {
    let folder = island("own-formats");
    let archive = |folder: &Folder, name: &str| fs::read(folder.path().join(name)).unwrap();
    let [water, terrain] = ["water.pmtiles", "terrain.pmtiles"].map(|name| archive(&folder, name));
    let other = Folder::new("own-formats-2");
    let bed = write(&other, "tiled.tif", tiled(&grid()));
    for (name, bytes) in [("coast.shp", shapefile()), ("coast.fgb", flatgeobuf(4326)), ("coast2.fgb", flatgeobuf(0))] {
        run(&bed, &write(&other, name, bytes), other.path()).unwrap();
        assert!(archive(&other, "water.pmtiles") == water, "{name} gives another coast");
        assert!(archive(&other, "terrain.pmtiles") == terrain, "{name}: tiles give another bed than strips");
    }
    // The same formula by others: netCDF-4, in deflated chunks, by GMT, on nodes five times as wide: straight lines between them are some metres
    // off at the cone's tip and foot alone. And a Cloud-optimised GeoTIFF by GDAL, with overviews of the means, rounded to whole metres.
    for name in ["bed_nc4.nc", "bed_cog.tif"] {
        let bed = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/oracles")).join(name);
        run(&bed, &other.path().join("coast.shp"), other.path()).unwrap();
        let mut world = World::open(other.path().to_str().unwrap());
        for (lat, lon) in [(10.35f64, -20.2f64), (10.3, -20.15), (10.21, -20.28), (10.4, -20.2), (10.5, -20.4)] {
            let found = world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
            let off_m = (found.elevation_measured_m - cone_m(lat, lon)).abs();
            assert!(off_m < 6.0 + cone_m(lat, lon).abs() / 32.0, "{name}, {lat} {lon}: {off_m} m off");
        }
        // As high on one side as on the other: half a node's way aside made 12 m of difference of GDAL's pixels.
        for [north, east] in [[1.0, 0.0], [0.0, 1.0 / MIDDLE[0].to_radians().cos()]] {
            let mut at = |out: f64| {
                let place = [MIDDLE[0] + out * north, MIDDLE[1] + out * east].map(f64::to_radians);
                world.sample_blocking(place[0], place[1]).unwrap().elevation_measured_m
            };
            let sides: Vec<f64> = (30..=130).map(|i| f64::from(i) * 1e-3).map(|out| at(out) - at(-out)).collect();
            let mean = sides.iter().sum::<f64>() / sides.len() as f64;
            println!("{name}: sides differ by {mean:.2} m in the mean");
            assert!(mean.abs() < 4.0, "{name}: {mean} m from side to side");
        }
    }
}

#[test]
fn gaps_are_filled_from_around_them() {
    let folder = Folder::new("own-gaps");
    let coast = write(&folder, "coast.shp", shapefile());
    let mut values = grid();
    for row in 20..40 {
        values[row * SIDE + 30..row * SIDE + 60].fill(-32768.0);
    }
    let bed = write(&folder, "bed.tif", geotiff(&values, &keys(2, 4326), Some("-32768")));
    run(&bed, &coast, folder.path()).unwrap();
    let mut world = World::open(folder.path().to_str().unwrap());
    let [lat, lon] = [CORNER[0] - 30.0 * STEP_DEG, CORNER[1] + 45.0 * STEP_DEG];
    let found = world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
    assert!((found.elevation_measured_m + 250.0).abs() < 10.0, "{found:?}");
}

#[test]
fn beds_that_cannot_be_used_are_refused_with_what_where_and_a_remedy() {
    let folder = Folder::new("own-refused");
    let coast = write(&folder, "good.geojson", geojson());
    let bytes = geotiff(&grid(), &keys(2, 4326), None);
    let mut with_nan = grid();
    with_nan[5 * SIDE + 7] = f32::NAN;
    let mut high = grid();
    high[0] = 40_000.0;
    // Another value in the list of tags, which the encoder writes last: number, 16 or 32 bits, one of them, value.
    let tagged = |number: u16, value: u32| {
        let mut bytes = bytes.clone();
        let is_tag = |w: &[u8]| w[..2] == number.to_le_bytes() && [3, 4].contains(&w[2]) && w[3..8] == [0, 1, 0, 0, 0];
        let at = bytes.windows(8).rposition(is_tag).unwrap();
        bytes[at + 8..at + 12].copy_from_slice(&value.to_le_bytes());
        bytes
    };
    // Whole numbers of four bits, two in a byte.
    let mut nibbles = tiled(&grid());
    for (tag, value) in [(258u16, 4u8), (339, 1)] {
        let at = nibbles.windows(4).position(|w| w == [&tag.to_le_bytes()[..], &[3, 0]].concat()).unwrap();
        nibbles[at + 8] = value;
    }
    let good = |model, system| geotiff(&grid(), &keys(model, system), None);
    let none = geotiff(&vec![-9999.0; SIDE * SIDE], &keys(2, 4326), Some("-9999"));
    for (name, bytes, part) in [
        ("cut.tif", bytes[..bytes.len() / 2].to_vec(), "get it again"),
        ("head.tif", bytes[..5].to_vec(), "get it again"),
        ("text.tif", b"no tiff at all".to_vec(), "is no TIFF"),
        ("utm.tif", good(1, 32_628), "EPSG:32628; bring it to degrees of WGS84: `gdalwarp"),
        ("datum.tif", good(2, 4314), "EPSG:4314"),
        ("plain.tif", geotiff(&grid(), &[], None), "without GeoTIFF's keys"),
        ("nan.tif", geotiff(&with_nan, &keys(2, 4326), None), "NaN at row 5, column 7"),
        ("feet.tif", geotiff(&high, &keys(2, 4326), None), "40000 at row 0, column 0"),
        ("none.tif", none, "has no values"),
        ("bomb.tif", tagged(256, 2_000_000_000), "2000000000 x 201 pixels"),
        ("zstd.tif", tagged(259, 50_000), "COMPRESS=DEFLATE"),
        ("hdf.nc", b"\x89HDF\r\n\x1a\n".to_vec(), "nccopy"),
        ("bed.asc", b"ncols 4".to_vec(), "`asc`"),
        ("nibbles.tif", nibbles, "2048 values for 64 x 64 pixels in the piece at row 0, column 0"),
    ] {
        let error = run(&write(&folder, name, bytes), &coast, folder.path()).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains(name), "{name}: {error}");
    }
}

#[test]
fn coasts_that_cannot_be_used_are_refused_with_what_where_and_a_remedy() {
    let folder = Folder::new("own-refused-coast");
    let refused = |name: &str, bytes: &[u8]| {
        let coast = Some(write(&folder, name, bytes));
        bake(&BakeArgs { coast, coast_zoom: 2, ..nothing(folder.path()) }).unwrap_err().to_string()
    };
    let (json, shp, fgb) = (geojson(), shapefile(), flatgeobuf(4326));
    let put = |bytes: &[u8], at: usize, value: &[u8]| {
        let mut bytes = bytes.to_vec();
        bytes[at..at + value.len()].copy_from_slice(value);
        bytes
    };
    let old_crs =
        json.replacen('{', r#"{"crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3857"}},"#, 1);
    // The size of the only feature of a FlatGeobuf says how far the end is.
    let size_of = |at: &usize| u32::from_le_bytes(*fgb[*at..].first_chunk().unwrap()) as usize;
    let feature = (12..fgb.len() - 4).find(|at| size_of(at) == fgb.len() - at - 4).unwrap();
    let text = |text: &str| text.as_bytes().to_vec();
    for (name, bytes, part) in [
        ("cut.geojson", text(&json[..json.len() / 2]), "is no JSON"),
        ("deep.geojson", b"[".repeat(100_000), "recursion"),
        ("crs.geojson", text(&old_crs), "EPSG::3857"),
        ("lines.geojson", text(r#"{"type":"LineString","coordinates":[[0,0],[1,1]]}"#), "no polygons"),
        (
            "metres.geojson",
            text(r#"{"type":"Polygon","coordinates":[[[5e5,0],[5e5,1],[5e5,2],[5e5,0]]]}"#),
            "polygon 1 has a point at 500000, 0",
        ),
        ("two.geojson", text(r#"{"type":"Polygon","coordinates":[[[0,0],[1,1],[0,0]]]}"#), "3 points"),
        ("words.geojson", text(r#"{"type":"Polygon","coordinates":[[["a",0]]]}"#), "no pair of numbers"),
        ("kind.geojson", text(&json.replace(r#""name":"x""#, r#""kind":"sea""#)), "known are"),
        ("cut.shp", shp[..shp.len() - 40].to_vec(), "ends within record 1"),
        ("text.shp", text("no shapes"), "is no Shapefile"),
        ("line.shp", put(&shp, 32, &3i32.to_le_bytes()), "shapes of type 3"),
        ("bomb.shp", put(&shp, 148, &i32::MAX.to_le_bytes()), "broken polygon in record 1"),
        ("parts.shp", put(&shp, 156, &(-5i32).to_le_bytes()), "broken polygon in record 1"),
        ("nan.shp", put(&shp, 176, &f64::NAN.to_le_bytes()), "NaN"),
        ("cut.fgb", fgb[..fgb.len() - 9].to_vec(), "ends before its features do"),
        ("text.fgb", text("no features at all, but long enough"), "is no FlatGeobuf"),
        ("utm.fgb", flatgeobuf(32_628), "EPSG:32628"),
        ("bomb.fgb", put(&fgb, feature, &u32::MAX.to_le_bytes()), "ends before its features do"),
    ] {
        let error = refused(name, &bytes);
        assert!(error.contains(part) && error.contains(name), "{name}: {error}");
    }
    write(&folder, "utm.prj", r#"PROJCS["WGS_1984_UTM_Zone_28N",GEOGCS["GCS_WGS_1984"]]"#);
    let error = refused("utm.shp", &shp);
    assert!(error.contains("WGS_1984_UTM_ZONE_28N"), "{error}");
}

#[test]
fn shapefiles_are_in_the_degrees_that_grids_may_be_in() {
    let folder = Folder::new("own-degrees");
    let baked = |system: &str| {
        write(&folder, "coast.prj", system);
        let coast = Some(write(&folder, "coast.shp", shapefile()));
        bake(&BakeArgs { coast, coast_zoom: 1, ..nothing(folder.path()) })
    };
    // As ESRI, GDAL and ISO write them; a file without a word on it is believed.
    for system in [
        r#"GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]]]"#,
        r#"GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],AUTHORITY["EPSG","4326"]]"#,
        r#"GEOGCRS["WGS 84",ENSEMBLE["World Geodetic System 1984 ensemble",MEMBER["World Geodetic System 1984 (G730)"]]]"#,
        r#"GEOGCS["GCS_ETRS_1989",DATUM["D_ETRS_1989",SPHEROID["GRS_1980",6378137.0,298.257222101]]]"#,
        r#"GEOGCS["NAD83",DATUM["North_American_Datum_1983",SPHEROID["GRS 1980",6378137,298.257222101]]]"#,
        "",
    ] {
        assert!(baked(system).is_ok(), "{system}: {:?}", baked(system));
    }
    for (system, part) in [
        (
            r#"GEOGCS["GCS_North_American_1927",DATUM["D_North_American_1927",SPHEROID["Clarke_1866",6378206.4,294.9787]]]"#,
            "1927",
        ),
        (
            r#"GEOGCS["GCS_European_1950",DATUM["D_European_1950",SPHEROID["International_1924",6378388.0,297.0]]]"#,
            "1950",
        ),
        ("no system at all", "NO SYSTEM"),
    ] {
        let error = baked(system).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("-t_srs EPSG:4326"), "{error}");
    }
}

#[test]
fn holes_find_their_ring_among_very_many() {
    let folder = Folder::new("own-holes");
    let refused = |name: &str, rings: &[Vec<[f64; 2]>]| {
        let coast = Some(write(&folder, name, shapefile_of(rings)));
        bake(&BakeArgs { coast, ..nothing(folder.path()) }).unwrap_err().to_string()
    };
    const MANY: usize = 100_000;
    let hole = |i: usize, lon: f64| {
        let (lat, side) = (-40.0 + 80.0 * i as f64 / MANY as f64, 1e-4);
        vec![[lon, lat], [lon + side, lat], [lon, lat + side], [lon, lat]]
    };
    // What stops the bake once the holes are sorted: no degrees.
    let stop = vec![[1000.0, 0.0], [1000.0, 1.0], [1001.0, 0.0], [1000.0, 0.0]];
    let clockwise = (0..=MANY).map(|i| {
        let (sin, cos) = (-std::f64::consts::TAU * (i % MANY) as f64 / MANY as f64).sin_cos();
        [60.0 * cos, 60.0 * sin]
    });
    let mut rings = vec![clockwise.collect::<Vec<_>>()];
    rings.extend((0..MANY).map(|i| hole(i, 0.0)));
    rings.push(stop.clone());
    // 10^10 pairs of hole and edge, each of which took a nanosecond.
    let error = refused("many.shp", &rings);
    assert!(error.contains("has a point at 1000, 0"), "{error}");
    // And an outline that passes every hole's latitude as often as it has points.
    let mut comb: Vec<_> = (0..MANY).map(|i| [50.0 - i as f64 * 1e-3, if i % 2 == 0 { 50.0 } else { -50.0 }]).collect();
    comb.extend([[-60.0, 60.0], [60.0, 60.0], comb[0]]);
    if comb.windows(2).map(|pair| pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1]).sum::<f64>() > 0.0 {
        comb.reverse();
    }
    rings[0] = comb;
    let error = refused("comb.shp", &rings);
    assert!(error.contains("more holes among more points in record 1") && error.contains("FlatGeobuf"), "{error}");
}

#[test]
fn holes_written_the_wrong_way_round_are_land_of_their_own() {
    // Two islands, the second within the latitudes of the first; a lake in each; a ring in none, that runs as a hole does, with one in it.
    let square = |west: f64, south: f64, side: f64, is_outer: bool| {
        let mut ring =
            vec![[west, south], [west, south + side], [west + side, south + side], [west + side, south], [west, south]];
        if !is_outer {
            ring.reverse();
        }
        ring
    };
    let rings = [
        square(0.0, 0.0, 20.0, true),
        square(30.0, 0.0, 20.0, true),
        square(34.0, 4.0, 8.0, false),
        square(4.0, 4.0, 8.0, false),
        square(60.0, 0.0, 20.0, false),
        square(64.0, 4.0, 8.0, false),
    ];
    let folder = small_world_of("own-wrong-way");
    let coast = Some(write(&folder, "coast.shp", shapefile_of(&rings)));
    bake(&BakeArgs { coast, coast_zoom: 4, ..nothing(folder.path()) }).unwrap();
    let mut world = World::open(folder.path().to_str().unwrap());
    for (lon, class) in [
        (2.0f64, WaterClass::Land),
        (25.0, WaterClass::Ocean),
        (8.0, WaterClass::Lake),
        (32.0, WaterClass::Land),
        (38.0, WaterClass::Lake),
        (55.0, WaterClass::Ocean),
        (62.0, WaterClass::Land),
        (68.0, WaterClass::Lake),
        (85.0, WaterClass::Ocean),
    ] {
        assert_eq!(world.sample_blocking(8f64.to_radians(), lon.to_radians()).unwrap().class, class, "{lon}");
    }
}

#[test]
fn long_json_is_refused_before_it_is_read() {
    let folder = Folder::new("own-long");
    for (name, part) in [
        ("long.geojson", "is 257 MiB long, more than the 256 MiB that are read; give it as FlatGeobuf or Shapefile"),
        ("long.shp", "is no Shapefile"),
    ] {
        let coast = write(&folder, name, "");
        // A hole in the file system's eyes.
        fs::File::options().write(true).open(&coast).unwrap().set_len((256 << 20) + 1).unwrap();
        let error = bake(&BakeArgs { coast: Some(coast), ..nothing(folder.path()) }).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn the_level_bed_lies_at_an_elevation_that_there_is() {
    #[derive(clap::Parser)]
    struct Line {
        #[command(flatten)]
        bake: BakeArgs,
    }
    let parsed = |metres: &str| {
        let given = ["bake", "--bed", "b.tif", "--coast", "c.shp", "--output", "out", "--bed-elsewhere-m", metres];
        Line::try_parse_from(given).map(|line| line.bake.bed_elsewhere_m).map_err(|error| error.to_string())
    };
    assert_eq!((parsed("-12000"), parsed("30.5")), (Ok(-12_000.0), Ok(30.5)));
    for metres in ["nan", "inf", "-inf", "1e30", "-12001"] {
        let error = parsed(metres).unwrap_err();
        assert!(error.contains("--bed-elsewhere-m") && error.contains("from -12000 to 12000"), "{error}");
    }
    assert!(parsed("deep").unwrap_err().contains("invalid float"));
}

#[test]
fn damaged_files_never_end_the_program() {
    let folder = Folder::new("own-damaged");
    // Bytes of the heads are turned over one after another; what is still good may be taken.
    for (name, bytes) in [("x.shp", shapefile()), ("x.fgb", flatgeobuf(4326)), ("x.tif", tiled(&grid()))] {
        for at in (0..600.min(bytes.len())).step_by(23) {
            let mut damaged = bytes.clone();
            damaged[at] ^= 0xFF;
            let path = Some(write(&folder, name, damaged));
            let coast = write(&folder, "good.geojson", geojson());
            let args = match name {
                "x.tif" => BakeArgs { bed: path, coast: Some(coast), ..nothing(folder.path()) },
                _ => BakeArgs { coast: path, ..nothing(folder.path()) },
            };
            if let Err(error) = bake(&BakeArgs { bed_zoom: Some(0), coast_zoom: 1, ..args }) {
                assert!(error.to_string().contains(';'), "{name} at {at}: {error} has no remedy");
            }
        }
    }
}
