//! Levels of lakes and rivers that the table does not hold, against what maps say.

use ocean_globe::data::tile::{Projection, map_from_lat_lon};
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
    ("Annecy", [[45.86, 6.17], [45.8630, 6.167]], 447.0),
    ("Zürich", [[47.25, 8.70], [47.248, 8.703]], 406.0),
    ("Lugano", [[45.98, 8.97], [45.9830, 8.967]], 271.0),
    ("Iseo", [[45.72, 10.07], [45.7230, 10.067]], 186.0),
    ("Neuchâtel", [[46.90, 6.85], [46.9030, 6.847]], 429.0),
    ("Ohrid", [[41.05, 20.72], [41.0530, 20.717]], 693.0),
    ("Chiemsee", [[47.88, 12.45], [47.8830, 12.447]], 518.0),
    ("Crater Lake", [[42.94, -122.10], [42.9430, -122.103]], 1883.0),
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
            .map(|sample| sample.elevation_measured_m)
            .collect();
        let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let allowed_m = ROUNDED_M + 0.5 * (greatest - least);
        println!("{name}: {level_m} m, published {true_m} m, allowed {allowed_m:.0} m");
        assert!(
            (level_m - true_m).abs() < allowed_m,
            "{name}: {level_m} m instead of {true_m} m, {allowed_m:.0} m allowed"
        );
        errors.push((level_m - true_m).abs());
    }
    errors.sort_by(f64::total_cmp);
    // Half of them lie where land is flat, where rounding is all there is.
    assert!(errors[errors.len() / 2] < 2.0 * ROUNDED_M, "{errors:?}");
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
    let mut before: Option<(f64, [f64; 2])> = None;
    for line in include_str!("../oracles/nile.csv").lines().filter(|line| !line.starts_with('#')) {
        let (lat, lon) = line.split_once(',').unwrap();
        let place: [f64; 2] = [lat, lon].map(|text| text.parse::<f64>().unwrap());
        let found = world.sample_blocking(place[0].to_radians(), place[1].to_radians()).unwrap();
        let Some(level_m) = found.inland_level_m else { continue };
        if let Some((last_m, last)) = before {
            let way_m = 111_000.0 * (place[0] - last[0]).hypot(0.9 * (place[1] - last[1]));
            assert!(
                (level_m - last_m).abs() < 2.0 + 0.02 * way_m,
                "{place:?}: {last_m} m, then {level_m} m in {way_m} m"
            );
        }
        before = Some((level_m, place));
    }
    assert!(before.is_some());
}
