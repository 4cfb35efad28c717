//! Lakes of the table, and the ground at their shores.

use ocean_globe::model::lakes::{LAKES, SHORE_M, at, shaped, usual_depth_m};

fn level_m(lat_deg: f64, lon_deg: f64) -> Option<f64> {
    at(lat_deg.to_radians(), lon_deg.to_radians()).map(|lake| lake.level_m)
}

#[test]
fn lakes_are_found_where_they_are() {
    for (lat, lon, level) in [
        (42.0, 50.5, -28.0),
        (47.7, -87.5, 183.0),
        (44.8, -82.4, 176.0),
        (43.0, -87.0, 176.0),
        (42.2, -81.2, 174.0),
        (46.45, 6.5, 372.0),
        // Lakes beside each other, and the arms of two.
        (46.69, 7.72, 558.0),
        (46.73, 7.97, 564.0),
        (47.075, 8.43, 434.0),
        (47.08, 8.48, 413.0),
        (46.03, 9.11, 271.0),
        (45.95, 9.16, 198.0),
        (-15.8, -69.4, 3812.0),
        (31.5, 35.48, -430.0),
        (-45.2, 167.8, 202.0),
        (-1.0, 33.0, 1134.0),
        (61.0, 31.5, 5.0),
    ] {
        assert_eq!(level_m(lat, lon), Some(level), "{lat} {lon}");
        assert_eq!(level_m(lat, lon + 360.0), Some(level), "{lat} {lon}, once around");
    }
    assert_eq!([level_m(0.0, 0.0), level_m(90.0, 0.0), level_m(35.0, -20.0)], [None; 3]);
    assert!(LAKES.iter().all(|lake| lake.depth_m > 0.0 && lake.margin_m > 0.0 && lake.level_m < 4000.0));
    // Victoria has 68,800 km2 and is 40 m deep; the rule is good to a factor of five.
    assert!((usual_depth_m(68_800.0) / 40.0 - 1.0).abs() < 4.0);
}

#[test]
fn the_ground_meets_the_lake_at_its_level() {
    let (level, margin) = (372.0, 5_000.0);
    for data in [100.0, 371.0, 380.0, 1500.0] {
        assert_eq!(shaped(data, 300.0, level, margin), level);
        // Not a step at the shore, nor where the lake's reach ends: 4 cm to the metre at most, as 1,500 m come up in 2 km.
        let ground: Vec<f64> = (0..5000).map(|metre| shaped(data, -f64::from(metre), level, margin)).collect();
        assert!((ground[0] - level).abs() < 1e-9, "{data}: {}", ground[0]);
        assert_eq!(ground[SHORE_M as usize + 1], data);
        let steepest = ground.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        assert!(steepest < 0.02 + 1.5 * (data - level).abs() / SHORE_M, "{data}: {steepest}");
        if data > level + 2.0 {
            assert!(ground.iter().skip(1).all(|ground| *ground > level), "{data}");
        }
    }
    // A pond up in the hills is not the lake in the valley.
    assert_eq!(shaped(300.0, 50.0, 183.0, 60.0), 300.0);
    assert!((shaped(300.0, -50.0, 183.0, 60.0) - 300.0).abs() < 1e-9);
}
