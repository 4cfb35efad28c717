//! The bundled world's coast against GSHHG's own shoreline points.

use ocean_globe::data::world::World;

/// How far from a coast point the drawn shore is looked for, metres.
const LOOKED_M: f64 = 5000.0;
/// Steps of that search, metres; also what the answer may be too large by.
const STEP_M: f64 = 50.0;

/// Shoreline points of GSHHG, (latitude, longitude) in radians.
fn oracle() -> Vec<(f64, f64)> {
    let text = include_str!("../oracles/gshhg_coast.csv");
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    rows.map(|row| {
        let (lat, lon) = row.split_once(',').unwrap();
        (lat.parse::<f64>().unwrap().to_radians(), lon.parse::<f64>().unwrap().to_radians())
    })
    .collect()
}

/// Distance from a place to the nearest place on the other side of the drawn zero line, metres. Walking outwards in 24
/// directions finds the line itself: what the tiles state as distance is not trusted.
fn distance_to_zero_line_m(world: &mut World, lat: f64, lon: f64) -> f64 {
    let mut in_ocean = |north_m: f64, east_m: f64| {
        let radius_m = 6_378_137.0;
        let (lat2, lon2) = (lat + north_m / radius_m, lon + east_m / (radius_m * lat.cos()));
        world.sample_blocking(lat2, lon2).unwrap().shore_distance_m.unwrap() > 0.0
    };
    let here = in_ocean(0.0, 0.0);
    let mut radius_m = STEP_M;
    while radius_m < LOOKED_M {
        for direction in 0..24 {
            let (sin, cos) = (f64::from(direction) * std::f64::consts::TAU / 24.0).sin_cos();
            if in_ocean(radius_m * cos, radius_m * sin) != here {
                return radius_m;
            }
        }
        radius_m += STEP_M;
    }
    LOOKED_M
}

#[test]
fn nine_of_ten_coast_points_lie_within_a_kilometre_of_the_drawn_shore() {
    let mut world = World::open(concat!(env!("CARGO_MANIFEST_DIR"), "/www/data"));
    let points = oracle();
    assert_eq!(points.len(), 2000);
    let mut errors_m: Vec<f64> =
        points.iter().map(|(lat, lon)| distance_to_zero_line_m(&mut world, *lat, *lon)).collect();
    errors_m.sort_by(f64::total_cmp);
    let quantile = |q: f64| errors_m[(q * (errors_m.len() - 1) as f64).round() as usize];
    println!(
        "coast error: median {} m, 75 % {} m, 90 % {} m, 95 % {} m, 99 % {} m, largest {} m",
        quantile(0.5),
        quantile(0.75),
        quantile(0.9),
        quantile(0.95),
        quantile(0.99),
        quantile(1.0)
    );
    assert!(quantile(0.9) <= 1000.0, "nine of ten within {} m", quantile(0.9));
    // Half a texel of level 7 in middle latitudes.
    assert!(quantile(0.5) <= 400.0, "half within {} m", quantile(0.5));
}
