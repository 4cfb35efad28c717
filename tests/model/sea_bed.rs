//! The shape of the ground at a coast, by its definition's corners.

use ocean_globe::model::sea_bed::{shaped_elevation, shaped_on, smoothstep};
use proptest::prelude::*;

/// Width of a grid cell, m.
const R: f64 = 9_000.0;

#[test]
fn far_from_the_shore_the_grid_holds() {
    for elevation in [-4290.0, -430.0, -31.0, -5.0, 3.0, 8848.0] {
        let shore = if elevation < 0.0 { 2.0 * R } else { -2.0 * R };
        // 1 % of 18 km is more than 4 m: deeper than that, and higher than 2 m, the grid alone speaks.
        assert_eq!(shaped_elevation(elevation, shore, R), elevation);
    }
    assert_eq!(shaped_elevation(-1.5, 2.0 * R, R), -4.0, "banks have at least 4 m of water");
    assert_eq!(shaped_elevation(200.0, 0.5 * R, R), -30.0, "and fjords that the grid does not know 30");
    assert_eq!(shaped_elevation(-430.0, -2.0 * R, R), -430.0, "the Dead Sea stays below the sea, and dry");
}

#[test]
fn the_formula_at_hand() {
    // 900 m out, raw 300 m: near = 27, smoothstep(0.1) = 0.028; 27 + 273·0.028 = 34.644.
    assert!((shaped_elevation(-300.0, 900.0, R) + 34.644).abs() < 1e-12);
    // Land in the cell's mean, ocean by the shoreline: at least 1 %.
    assert_eq!(shaped_elevation(120.0, 900.0, R), -9.0);
    // 300 m inland, 50 m high: smoothstep(0.1) of R/3; and ocean in the mean: stays below zero, nearly at the shore's level.
    assert!((shaped_elevation(50.0, -300.0, R) - 2.0).abs() < 1e-12, "1.4 m by the grid, 2 m by the least rise");
    assert!((shaped_elevation(-50.0, -300.0, R) + 1.4).abs() < 1e-12);
    assert_eq!(shaped_elevation(1.0, -50.0, R), 0.5, "1 % inland at least");
    assert_eq!((smoothstep(0.0, 2.0, 1.0), smoothstep(0.0, 0.0, 0.0), smoothstep(0.0, 0.0, -1.0)), (0.5, 1.0, 0.0));
}

proptest! {
    #[test]
    fn the_shore_is_at_zero_and_water_has_depth(elevation in -1e4f64..9e3, d in 0.0f64..5e4, r in 10.0f64..2e4) {
        let ocean = shaped_elevation(elevation, d, r);
        let land = shaped_elevation(elevation, -d, r);
        prop_assert!(d == 0.0 || ocean < 0.0, "water has depth");
        prop_assert!(ocean >= -(-elevation).max((0.01 * d).min(30.0)) - 1e-9, "never deeper than the grid or 1 %");
        prop_assert!(if elevation >= 0.0 { land >= 0.0 } else { land <= 0.0 }, "land keeps its side");
        prop_assert!(land.abs() <= elevation.abs().max(2.0));
        // Continuous at the shore: a step of 1 mm changes the ground by far less than 1 m even in a 10 m cell.
        prop_assert!(shaped_elevation(elevation, 1e-3, r).abs() < 0.01 && shaped_elevation(elevation, -1e-3, r).abs() < 0.01);
    }
}

#[test]
fn beaches_fall_as_the_user_says() {
    for slope in [0.01, 0.03, 0.1, 0.3] {
        // Close to the shore of a deep coarse bed: the cell's own depth counts as the smooth step has it, 3 t².
        let t = 100.0 / R;
        let wanted = slope * 100.0 + (3000.0 - slope * 100.0) * t * t * (3.0 - 2.0 * t);
        assert!((shaped_on(-3000.0, 100.0, R, slope) + wanted).abs() < 1e-9, "{slope}");
        assert_eq!(shaped_on(-3000.0, 1.5 * R, R, slope), -3000.0, "where the grid is trusted it stays");
    }
    // Where the grid takes the water for land, a third of the slope.
    assert!((shaped_on(5.0, 90.0, R, 0.1) + 3.0).abs() < 1e-12);
    assert_eq!(shaped_on(-50.0, 1000.0, R, 0.03), shaped_elevation(-50.0, 1000.0, R));
}
