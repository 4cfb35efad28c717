//! The table of the highest ground against the world's own elevation.

use std::time::{Duration, Instant};

use ocean_globe::data::TileTexels;
use ocean_globe::data::tile::{Layer, Projection, TileId, lat_lon_from_map};
use ocean_globe::data::world::{Outcome, World};
use ocean_globe::model::highest::{HIGHEST_HM, highest_in_view_m};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// Level whose texels are as wide as the data's.
const LEVEL: u8 = 4;

/// The highest texels of cells of 10 degrees, metres.
fn highest() -> [[f32; 36]; 18] {
    let mut world = World::open(DATA);
    let side = 1u32 << LEVEL;
    for projection in Projection::ALL {
        for at in 0..side * side {
            world.request(Layer::Terrain, TileId::new(projection, LEVEL, at % side, at / side).unwrap());
        }
    }
    let mut left = 3 * side * side;
    let mut highest = [[0.0f32; 36]; 18];
    let start = Instant::now();
    while left > 0 {
        assert!(start.elapsed() < Duration::from_secs(120), "{left} tiles are not there after two minutes");
        for arrival in world.poll() {
            left -= 1;
            let Outcome::Tile(texels) = arrival.outcome else { continue };
            let TileTexels::Terrain(metres) = &*texels else { panic!("no elevation") };
            for (i, metres) in metres.iter().enumerate() {
                let at = |tile: u32, texel: usize| (f64::from(tile) + (texel as f64 + 0.5) / 256.0) / f64::from(side);
                let (x, y) = (at(arrival.id.x, i % 256), at(arrival.id.y, i / 256));
                let (lat, lon) = lat_lon_from_map(arrival.id.projection, x, y);
                let [row, column] =
                    [90.0 - lat.to_degrees(), 180.0 + lon.to_degrees()].map(|deg| (deg / 10.0) as usize);
                let cell = &mut highest[row.min(17)][column % 36];
                *cell = cell.max(*metres);
            }
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    highest
}

#[test]
fn no_ground_is_higher_than_the_table_has_it() {
    let found = highest();
    for row in &found {
        println!("    [{}],", row.map(|metres| format!("{}", (metres / 100.0).ceil())).join(", "));
    }
    for (found, told) in found.iter().flatten().zip(HIGHEST_HM.iter().flatten()) {
        let told = 100.0 * f32::from(*told);
        assert!(*found <= told && told - *found <= 200.0, "{found} m, {told} in the table");
    }
}

#[test]
fn eyes_see_the_summits_that_are_within_their_horizons() {
    let at = |lat: f64, lon: f64, km: f64| highest_in_view_m(lat.to_radians(), lon.to_radians(), 1e3 * km);
    // The southern Pacific with Tahiti at the rim of its cells, Hawaii from afar, the Alps, the Himalaya, and from so high that half of the earth is seen.
    for (lat, lon, km, range) in [
        (-30.0, -120.0, 500.0, 0.0..1_300.0),
        (0.0, -140.0, 500.0, 2_000.0..4_300.0),
        (46.0, 8.0, 500.0, 3_000.0..5_000.0),
        (28.0, 86.0, 500.0, 6_500.0..9_000.0),
        (0.0, -140.0, 1e6, 4_000.0..7_500.0),
    ] {
        let metres = at(lat, lon, km);
        println!("{lat} {lon} from {km} km: {metres} m");
        assert!(range.contains(&metres), "{lat} {lon} from {km} km: {metres} m");
    }
}
