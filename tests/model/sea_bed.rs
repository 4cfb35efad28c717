//! The shape of the ground at a coast: Dean's profile against its inverse, the tables that it comes from, and its corners.

use ocean_globe::model::sand::{grain_mm, sunamura};
use ocean_globe::model::sea_bed::{
    CLIFF_SLOPE, Coast, FACE, Grid, USUAL_SLOPE, grid_level, shaped_elevation, shaped_on, smoothstep,
};
use proptest::prelude::*;

/// Width of a grid cell, m.
const R: f64 = 9_000.0;

/// A coast off which the grid's sea is so deep, with land so high, half of the cells each.
fn coast(sea_m: f64, land_m: f64) -> Coast {
    Coast::new(Grid::between([-sea_m, land_m, -sea_m, land_m], [0.5, 0.3]), R, 0.0)
}

#[test]
fn far_from_the_shore_the_grid_holds() {
    for elevation in [-4290.0, -430.0, -31.0, -5.0, 3.0, 8848.0] {
        let shore = if elevation < 0.0 { 2.0 * R } else { -2.0 * R };
        // Deeper than 4 m and higher than 2 m the grid alone speaks.
        assert_eq!(shaped_elevation(elevation, shore, R), elevation);
    }
    assert_eq!(shaped_elevation(-1.5, 2.0 * R, R), -4.0, "banks have at least 4 m of water");
    assert!(shaped_elevation(200.0, 0.5 * R, R) <= -30.0, "and fjords that the grid does not know 30");
    assert_eq!(shaped_elevation(-430.0, -2.0 * R, R), -430.0, "the Dead Sea stays below the sea, and dry");
}

#[test]
fn a_coast_that_the_grid_has_elsewhere_makes_no_shallows() {
    // Between cells that are 1,400 m deep and 600 m high, a cell and a half from the shore as it is mapped.
    let depths: Vec<f64> = (0..=40)
        .map(|step| {
            let on = 0.9 * f64::from(step) / 40.0;
            let grid = Grid::between([-1400.0, 600.0, -1400.0, 600.0], [on, 0.5]);
            -shaped_on(grid.elevation_m, grid, 1.5 * R, [R, USUAL_SLOPE], 0.0)
        })
        .collect();
    // The sea of the deep cells, as long as they are a quarter; the grid between them is above the water from 0.7 on.
    assert!(depths[..34].iter().all(|depth| *depth > 800.0), "{depths:?}");
    assert!(depths.windows(2).all(|d| (d[0] - d[1]).abs() < 160.0), "{depths:?}");
    // And where all are wet the grid alone speaks, shoals or not.
    let shoal = Grid::between([-1400.0, -6.0, -1400.0, -6.0], [0.9, 0.5]);
    assert!((shaped_on(shoal.elevation_m, shoal, 1.5 * R, [R, USUAL_SLOPE], 0.0) - shoal.elevation_m).abs() < 1e-9);
}

#[test]
fn values_between_a_high_coast_and_the_deep_make_no_shallows() {
    // A texel of land beside three that are 600 m deep, from its middle to theirs, a cell off the shore as it is mapped: between them is the sea's level.
    let depths: Vec<f64> = (0..=40)
        .map(|step| {
            let nearest = Grid::between([500.0, -600.0, -600.0, -600.0], [0.2 + f64::from(step) / 50.0, 0.2]);
            -shaped_on(nearest.elevation_at(R), Grid::level(-600.0), R, [R, USUAL_SLOPE], 0.0)
        })
        .collect();
    assert!(depths.iter().all(|depth| (depth - 600.0).abs() < 1e-9), "{depths:?}");
    // A bank in the same deep is one, and on land a basin stays.
    let bank = Grid::level(-5.0).elevation_at(R);
    assert_eq!(shaped_on(bank, Grid::level(-600.0), R, [R, USUAL_SLOPE], 0.0), -5.0);
    assert_eq!(Grid::between([-400.0, 30.0, -400.0, 30.0], [0.5, 0.5]).elevation_at(-R), -185.0);
    // Where none is wet there is the least of water, as between those of which some are.
    let [dry, nearly] = [0.0, 1e-9].map(|on| Grid::between([500.0, -600.0, 500.0, -600.0], [on, 0.5]).elevation_at(R));
    assert!((dry - nearly).abs() < 1e-5, "{dry} {nearly}");
}

#[test]
fn the_formula_at_hand() {
    // 50 m deep off low land: A = 0.1 (50/50 (9277/9000)^⅔)^⅓ = 0.100676, m = 0.0409 + 0.304 A; rock adds (50/774)² = 0.42 %.
    let found = coast(50.0, 0.0);
    assert!(
        (found.a - 0.101_096).abs() < 1e-6 && (found.m - 0.071_506).abs() < 1e-6 && found.cliff == 0.0,
        "{found:?}"
    );
    // 3 m deep after 3/0.071506 + (3/0.101096)^1.5 = 41.9547 + 161.6523 m, nearer than R/10.
    assert!((found.distance_m(3.0) - 203.607).abs() < 1e-3, "{}", found.distance_m(3.0));
    let grid = Grid::between([-50.0, 0.0, -50.0, 0.0], [0.5, 0.3]);
    assert!((shaped_on(-25.0, grid, 203.607, [R, USUAL_SLOPE], 0.0) + 3.0).abs() < 1e-5);
    // Half a cell out, smoothstep(4/9) = 0.416_99: the profile's 43.486 m to that power less than one, and 50 + (25 - 50) 0.386_78 m to it, as of the
    // grid's own value 0.416_99 less its fourth power counts where half of its cells are dry.
    let near = found.profile_m(0.5 * R);
    let w = smoothstep(0.1, 1.0, 0.5);
    let wanted = (near.ln() * (1.0 - w) + (50.0 - 25.0 * (w - w.powi(4))).ln() * w).exp();
    assert!((w - 0.417).abs() < 1e-3 && (shaped_on(-25.0, grid, 0.5 * R, [R, USUAL_SLOPE], 0.0) + wanted).abs() < 1e-9);
    // 300 m inland, 50 m high: smoothstep(0.1) of R/3; and ocean in the mean: stays below zero, nearly at the shore's level.
    assert!((shaped_elevation(50.0, -300.0, R) - 2.0).abs() < 1e-12, "1.4 m by the grid, 2 m by the beach");
    assert!((shaped_elevation(-50.0, -300.0, R) + 1.4).abs() < 1e-12);
    let beach = Coast::new(Grid::level(1.0), R, 0.0).m;
    assert!((shaped_elevation(1.0, -10.0, R) - 10.0 * beach).abs() < 1e-12, "the beach's slope inland at least");
    assert_eq!((smoothstep(0.0, 2.0, 1.0), smoothstep(0.0, 0.0, 0.0), smoothstep(0.0, 0.0, -1.0)), (0.5, 1.0, 0.0));
}

#[test]
fn grains_and_slopes_are_the_tables() {
    // Moore's grains by A, and 0.12 (1 m/(√(9.80665 D) 8 s))^-½ by hand.
    for (a, grain, slope) in [
        (0.063, 0.1, 0.060_062),
        (0.1, 0.2, 0.071_427),
        (0.125, 0.3, 0.079_047),
        (0.145, 0.4, 0.084_941),
        (0.161, 0.5, 0.089_815),
    ] {
        assert!((grain_mm(a) / grain - 1.0).abs() < 1e-12, "{a}: {} mm", grain_mm(a));
        assert!((sunamura(grain) - slope).abs() < 2e-6, "{grain} mm: {}", sunamura(grain));
        // The line's own error.
        assert!(((FACE[0] + FACE[1] * a) / slope - 1.0).abs() < 3e-3, "{a}: {}", FACE[0] + FACE[1] * a);
    }
    // Between rows they grow; beyond them, too.
    let grains = [0.05, 0.063, 0.08, 0.1, 0.11, 0.13, 0.15, 0.17, 0.25].map(grain_mm);
    assert!(grains.windows(2).all(|pair| pair[0] < pair[1]), "{grains:?}");
}

#[test]
fn coasts_differ_by_their_sea_and_land() {
    // A goes with the cube root of the depth: eight times as deep, twice the A, within what rock adds, (100/774)².
    let [shallow, deep] = [12.5, 100.0].map(|sea_m| coast(sea_m, 0.0));
    assert!((deep.a / shallow.a / 2.0 - 1.0).abs() < 0.02, "{shallow:?} {deep:?}");
    // Bounds of sand.
    assert!((coast(1.0, 0.0).a - 0.05).abs() < 1e-6 && coast(500.0, 0.0).a > 0.2);
    // High land is a cliff, and so is a front of ice in the far south alone.
    let fjord = Coast::new(Grid::level(800.0), R, 0.87);
    assert!(fjord.cliff == 1.0 && fjord.m == CLIFF_SLOPE && fjord.profile_m(100.0) > 10.0, "{fjord:?}");
    let at_latitude = |lat: f64| Coast::new(Grid::level(-300.0), R, lat.to_radians().sin()).cliff;
    assert_eq!([-78.0, -62.0, 0.0, 78.0].map(at_latitude), [1.0, 0.0, 0.0, 0.0]);
    // Of a usual grid cells are texels of level 4, of a fine one of its own.
    assert_eq!((grid_level(9_277.0), grid_level(90.0)), (4, 10));
}

proptest! {
    #[test]
    fn profiles_are_the_inverse_of_their_distance(d in 1e-3f64..1e5, sea in 0.0f64..6e3, land in 0.0f64..3e3, sin_lat in -1.0f64..1.0) {
        let coast = Coast::new(Grid::between([-sea, land, -sea, land], [0.4, 0.7]), R, sin_lat);
        let found = coast.distance_m(coast.profile_m(d));
        prop_assert!((found / d - 1.0).abs() < 1e-6, "{found} for {d}, {coast:?}");
    }

    #[test]
    fn the_shore_is_at_zero_and_water_has_depth(elevation in -1e4f64..9e3, d in 0.0f64..5e4, r in 10.0f64..2e4) {
        let ocean = shaped_elevation(elevation, d, r);
        let land = shaped_elevation(elevation, -d, r);
        let coast = Coast::new(Grid::level(elevation), r, 0.0);
        prop_assert!(d == 0.0 || ocean < 0.0, "water has depth");
        prop_assert!(-ocean <= coast.profile_m(d).max(-elevation).max(30.0) * (1.0 + 1e-9), "never deeper than the grid or the profile");
        prop_assert!(if elevation >= 0.0 { land >= 0.0 } else { land <= 0.0 }, "land keeps its side");
        prop_assert!(land.abs() <= elevation.abs().max(2.0));
        // Continuous at the shore: a step of 1 mm changes the ground by far less than 1 m even in a 10 m cell.
        prop_assert!(shaped_elevation(elevation, 1e-3, r).abs() < 0.01 && shaped_elevation(elevation, -1e-3, r).abs() < 0.01);
    }

    #[test]
    fn nothing_jumps_from_cell_to_cell(values in proptest::array::uniform6(-3e3f64..2e3), x in 0.0f64..2.0, y in 0.0f64..1.0) {
        // Three columns of cells, two rows; places a millionth of a cell apart, most of them beside one border or the other.
        let at = |x: f64| {
            let (column, x) = if x < 1.0 { (0, x) } else { (1, x - 1.0) };
            let [a, b, c, d] = [0, 1, 3, 4].map(|value| values[column + value]);
            Coast::new(Grid::between([a, b, c, d], [x, y]), R, 0.0)
        };
        for x in [x, 1.0 - 5e-7] {
            let (here, there) = (at(x), at((x + 1e-6).min(2.0 - 1e-9)));
            // Depths and heights off the coast differ by 4 · 5e3 · 1e-6 = 0.02 m; A of sand by a third of that over at least 6 m, of rock by twice
            // that over at least 700 m, and of a cliff's foot by four times 1.5 · 2 · 0.02 m/(0.06 · 9 km).
            for (name, a, b) in [("A", here.a, there.a), ("m", here.m, there.m)] {
                prop_assert!((a / b - 1.0).abs() < 2e-3, "{name} at {x}: {here:?}, {there:?}");
            }
        }
    }

    #[test]
    fn beaches_fall_as_the_user_says(d in 1.0f64..800.0, slope in 0.01f64..0.3, sea in 40.0f64..4e3) {
        // Nearer than the grid has a say all depths of the profile go with the slope, down to the depth off the coast.
        let at = |slope: f64| shaped_on(-sea, Grid::level(-sea), d, [R, slope], 0.0);
        let wanted = (at(USUAL_SLOPE) * slope / USUAL_SLOPE).max(-sea);
        prop_assert!((at(slope) / wanted - 1.0).abs() < 1e-9, "{slope}: {} for {wanted}", at(slope));
        prop_assert_eq!(shaped_on(-3000.0, Grid::level(-3000.0), 1.5 * R, [R, slope], 0.0), -3000.0, "where the grid is trusted it stays");
    }
}
