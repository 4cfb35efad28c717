//! Levels of lakes and rivers that the table does not hold, against what maps say.

use ocean_globe::data::tile::{Layer, Projection, TileId, map_from_lat_lon};
use ocean_globe::data::water::WaterClass;
use ocean_globe::data::world::{LINES_LEVEL, World};
use ocean_globe::model::lakes;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// Heights of the bundled world are rounded to so much in mountains, metres.
const ROUNDED_M: f64 = 16.0;
/// Width of its source's cells, degrees.
const CELL: f64 = 1.0 / 12.0;

/// Places in a lake, its published level, metres.
#[rustfmt::skip]
const LAKES: [(&str, [[f64; 2]; 2], f64); 15] = [
    ("Inari", [[69.00, 27.80], [69.003, 27.80]], 118.0),
    ("Lake of the Woods", [[49.10, -94.90], [49.103, -94.903]], 323.0),
    ("Khövsgöl", [[51.10, 100.50], [51.103, 100.503]], 1645.0),
    ("Iseo", [[45.72, 10.07], [45.7230, 10.067]], 186.0),
    ("Neuchâtel", [[46.90, 6.85], [46.9030, 6.847]], 429.0),
    ("Ohrid", [[41.05, 20.72], [41.0530, 20.717]], 693.0),
    ("Chiemsee", [[47.88, 12.45], [47.8830, 12.447]], 518.0),
    ("Towada", [[40.47, 140.88], [40.473, 140.877]], 400.0),
    ("Yellowstone", [[44.45, -110.35], [44.4530, -110.353]], 2357.0),
    ("Lough Neagh", [[54.60, -6.40], [54.6030, -6.403]], 12.0),
    ("Siljan", [[60.90, 14.80], [60.9003, 14.80]], 161.0),
    ("Mývatn", [[65.60, -16.98], [65.6003, -16.98]], 277.0),
    ("Lake Nipigon", [[49.80, -88.50], [49.8030, -88.503]], 260.0),
    ("Beyşehir", [[37.75, 31.50], [37.7530, 31.497]], 1121.0),
    ("Uvs", [[50.30, 92.75], [50.3030, 92.747]], 759.0),
];

#[test]
fn lakes_beyond_the_table_are_level_and_as_high_as_the_terrain_can_tell() {
    let mut world = World::open(DATA);
    let mut errors = Vec::new();
    for (name, places, true_m) in LAKES {
        let [here, there] = places.map(|[lat, lon]| {
            assert!(lakes::at(lat.to_radians(), lon.to_radians()).is_none(), "{name} is in the table");
            world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap()
        });
        assert_eq!([here.class, there.class], [WaterClass::Lake; 2], "{name}: {here:?} {there:?}");
        let level_m = here.inland_level_m.unwrap_or_else(|| panic!("{name} has no level"));
        assert_eq!([here.elevation_m, there.elevation_m, there.inland_level_m.unwrap()], [level_m; 3], "{name}");
        // As far as the land within a cell of the lake differs: half of what such a cell holds may be mountain.
        let around = [-1.0, 0.0, 1.0].into_iter().flat_map(|i| [-1.0, 0.0, 1.0].map(|j| [i * CELL, j * CELL]));
        let heights: Vec<f64> = places
            .into_iter()
            .flat_map(|place| around.clone().map(move |off| [place[0] + off[0], place[1] + 1.4 * off[1]]))
            .map(|[lat, lon]| world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap())
            // Water at the level in question allows nothing.
            .filter(|sample| sample.class != WaterClass::Lake)
            .map(|sample| sample.elevation_measured_m)
            .collect();
        let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let allowed_m = ROUNDED_M + 0.5 * (greatest - least).max(0.0);
        println!("{name}: {level_m} m, published {true_m} m, allowed {allowed_m:.0} m");
        assert!(
            (level_m - true_m).abs() < allowed_m,
            "{name}: {level_m} m instead of {true_m} m, {allowed_m:.0} m allowed"
        );
        errors.push((level_m - true_m).abs());
    }
    errors.sort_by(f64::total_cmp);
    // All but two: of the terrain that it has been rounded to, and half of a step more.
    assert!(errors[12] < 1.5 * ROUNDED_M, "{errors:?}");
}

#[test]
fn a_lakes_level_is_the_same_from_whichever_tile_it_is_asked_for() {
    for (name, places, _) in LAKES {
        let levels: Vec<_> = [(LINES_LEVEL, 0), (LINES_LEVEL, 1), (7, 0), (6, 1)]
            .into_iter()
            .map(|(z, place)| {
                // A world that knows nothing yet.
                let mut world = World::open(DATA);
                let [lat, lon] = places[place].map(f64::to_radians);
                world.sample_blocking(0.3 - lat, lon + 1.0).unwrap();
                let at = map_from_lat_lon(Projection::Mercator, lat, lon);
                world.stands_by(z, at, World::look_blocking).unwrap().unwrap().unwrap().level_m
            })
            .collect();
        assert!(levels.iter().all(|level_m| *level_m == levels[0]), "{name}: {levels:?}");
    }
}

#[test]
fn the_nile_lies_in_its_valley() {
    let mut world = World::open(DATA);
    // Its level at Luxor is 76 m; the cells there hold more plateau than valley, 208 m in the mean, and down its course 104 m.
    let luxor = world.sample_blocking(25.7f64.to_radians(), 32.635f64.to_radians()).unwrap();
    assert_eq!(luxor.class, WaterClass::River);
    assert!(luxor.elevation_m < 104.0 + ROUNDED_M && luxor.inland_level_m == Some(luxor.elevation_m), "{luxor:?}");
    // It flows without a step, though for 30 km the cells beside it know no valley: their 150 m are spread over the way that they count.
    // So say places every 200 m on the way from each point of the course to the next; pieces of the course begin far from the last one's end.
    let mut before: Option<[f64; 2]> = None;
    let (mut steps, mut greatest) = (0, 0.0f64);
    for line in include_str!("../oracles/nile.csv").lines().filter(|line| !line.starts_with('#')) {
        let (lat, lon) = line.split_once(',').unwrap();
        let place: [f64; 2] = [lat, lon].map(|text| text.parse::<f64>().unwrap());
        let from = before.replace(place).unwrap_or(place);
        let way_m = 111_000.0 * (place[0] - from[0]).hypot(0.9 * (place[1] - from[1]));
        if way_m > 20_000.0 {
            continue;
        }
        let parts = (way_m / 200.0).ceil() as u32;
        let (mut last_m, mut last_step_m) = (None, None);
        for part in 0..=parts {
            let share = f64::from(part) / f64::from(parts.max(1));
            let [lat, lon] = [0, 1].map(|axis| (from[axis] + share * (place[axis] - from[axis])).to_radians());
            let at = map_from_lat_lon(Projection::Mercator, lat, lon);
            let stands = world.stands_by(LINES_LEVEL, at, World::look_blocking).unwrap().unwrap().unwrap();
            assert!(stands.is_river(), "{stands:?} at {lat}, {lon}");
            if let Some(last_m) = last_m.replace(stands.level_m) {
                let step_m = f64::abs(stands.level_m - last_m);
                steps += 1;
                greatest = greatest.max(step_m);
                assert!(step_m < 8.0, "{step_m} m within 200 m at {lat}, {lon}");
                if let Some(last_step_m) = last_step_m.replace(stands.level_m - last_m) {
                    let bend_m = f64::abs(stands.level_m - last_m - last_step_m);
                    assert!(bend_m < 1.5, "{last_step_m} m, then {bend_m} m more or less at {lat}, {lon}");
                }
            }
        }
    }
    println!("{steps} steps, of {greatest} m at most");
    assert!(steps > 1500, "{steps}");
}

#[test]
fn a_passing_look_asks_for_nothing_and_the_table_serves_at_once() {
    let mut world = World::open(DATA);
    let (lat, lon) = (46.45f64.to_radians(), 6.55f64.to_radians());
    let at = map_from_lat_lon(Projection::Mercator, lat, lon);
    for layer in Layer::SHAPE {
        for z in 0..=5 {
            let [x, y] = [at.0, at.1].map(|at| (at * f64::from(1u32 << z)) as u32);
            world.look_blocking(layer, TileId::new(Projection::Mercator, z, x, y).unwrap()).unwrap();
        }
    }
    let table_m = lakes::at(lat, lon).unwrap().level_m;
    let passing = world.sample_passing(lat, lon).unwrap();
    assert_eq!((passing.class, passing.inland_level_m, world.pending()), (WaterClass::Lake, Some(table_m), 0));
    let resident = world.sample_resident(lat, lon).unwrap();
    assert_eq!(resident.inland_level_m, Some(table_m));
    assert!(world.pending() > 0, "its own lines are on their way");
}
