//! Surf from the air: crests that break are long white lines along the beach, not flecks, and as white from afar as from near.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::world::World;
use ocean_globe::renderer::Radiance;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// Of pixels of 2.3 m, 500 m below the eye, up is along the Dutch coast, with the sea on the left.
const SIZE: [u32; 2] = [320, 180];
/// Columns that surf crosses.
const SURF: std::ops::Range<usize> = 60..230;
/// 60 m along the shore, and how far a line may then have come nearer to it, pixels.
const ALONG: usize = 26;
const ASIDE: usize = 5;
/// A wave's length in shallow water, pixels.
const ACROSS: usize = 19;

#[test]
fn breakers_are_long_lines_along_the_shore() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let (mut all, mut along, mut across) = (0.0, [0.0; 2 * ASIDE + 1], [0.0; ACROSS]);
    for second in ["00", "07", "14"] {
        let link = format!("#view=52.372,4.5175,500,25,0&wind=9@295&time=2026-03-03T12:40:{second}Z&clouds=0");
        let light =
            render::measure(&mut renderer, &render::parse_state(&link).unwrap(), SIZE, LayerName::Luminance).unwrap();
        let [width, rows] = SIZE.map(|side| side as usize);
        // Less than its mean at that distance from the shore, and of land not more than of foam.
        let seen = |i: usize, j: usize| light.values[j * width + i].min(0.06);
        let mean: Vec<f64> = (0..width).map(|i| (0..rows).map(|j| seen(i, j)).sum::<f64>() / rows as f64).collect();
        let at = |i: usize, j: usize| seen(i, j) - mean[i];
        // The mean product of places so many pixels apart, to the right and down.
        let product = |right: usize, down: usize, from: usize, to: usize| {
            let places = (from..to).flat_map(|i| (0..rows - down).map(move |j| (i, j)));
            let count = ((to - from) * (rows - down)) as f64;
            places.map(|(i, j)| at(i, j) * at(i + right - ASIDE, j + down)).sum::<f64>() / count
        };
        all += product(ASIDE, 0, SURF.start, SURF.end);
        (0..).zip(&mut along).for_each(|(k, sum)| *sum += product(k, ALONG, SURF.start + ASIDE, SURF.end - ASIDE));
        (1..).zip(&mut across).for_each(|(k, sum)| *sum += product(ASIDE + k, 0, SURF.start, SURF.end - k));
    }
    let along = along.into_iter().fold(f64::NEG_INFINITY, f64::max) / all;
    let across = across.into_iter().fold(f64::INFINITY, f64::min) / all;
    println!("surf is alike by {along:.3} 60 m along the shore, by {across:.3} between two crests");
    // Flecks have 0.04 and 0.03.
    assert!(along > 0.15 && along > across + 0.1, "{along} along, {across} across");
}

/// Distances from the shore, m, between which waves break.
const BREAKS_M: std::ops::Range<f64> = 10.0..150.0;

#[test]
fn surf_is_as_white_from_10_km_as_from_120_m() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    let mut whites = Vec::new();
    // Straight down on the same beach, in pixels of half a metre, 2.6 m and 46 m; in the middle of the surf and where 10 km are in view.
    for (lon, altitude_m, instants) in [(4.5212, 120, 4), (4.5181, 560, 2), (4.5181, 10_000, 1)] {
        let (mut white, mut dark, mut count) = (0.0, 0.0, 0);
        for instant in 0..instants {
            let link = format!(
                "#view=52.372,{lon},{altitude_m},25,0&wind=9@295&time=2026-03-03T12:40:{:02}Z&clouds=0",
                7 * instant
            );
            let mut green = |layers: &str, name| {
                let state = render::parse_state(&format!("{link}{layers}")).unwrap();
                render::measure(&mut renderer, &state, SIZE, name).unwrap().values
            };
            let places = green("", LayerName::Lonlat);
            let [foam, bare] = ["", "&layers=-foam"].map(|layers| green(layers, LayerName::Radiance));
            for (pixel, place) in places.chunks_exact(2).enumerate().step_by(3) {
                let found = world.sample_blocking(place[1].to_radians(), place[0].to_radians()).unwrap();
                if found.shore_distance_m.is_some_and(|away_m| BREAKS_M.contains(&away_m)) {
                    white += foam[3 * pixel + 1] - bare[3 * pixel + 1];
                    dark += bare[3 * pixel + 1];
                    count += 1;
                }
            }
        }
        // What the air before it takes: molecules and a sea's aerosol, 8 and 1.5 km high.
        let height_m = f64::from(altitude_m);
        let through = (-0.10 * (1.0 - (-height_m / 8e3).exp()) - 0.08 * (1.0 - (-height_m / 1.5e3).exp())).exp();
        white /= through;
        println!(
            "{altitude_m} m: {count} pixels, {:.4} without foam, {:.4} more with it",
            dark / f64::from(count),
            white / f64::from(count)
        );
        whites.push([white / f64::from(count), white / dark]);
    }
    // Four instants of 100 m of shore are a few waves: a tenth more or less. A pixel from 10 km holds two or three of them.
    for [white, _] in &whites {
        assert!((white / whites[1][0] - 1.0).abs() < 0.15, "{whites:?}");
    }
    assert!(whites[2][1] > 0.2, "a white seam: {whites:?}");
}

#[test]
fn crests_on_a_far_beach_are_no_rows_of_dots() {
    const SIZE: [u32; 2] = [640, 360];
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // A swell off the Landes from 500 m: near the shore its crests lie a few pixels behind each other, and nearly along the rows.
    let link = "#view=44.2,-1.335,500,60,62&wind=0@310&swell=2,13,310&clouds=0&time=2026-09-21T15:00:00Z";
    let state = render::parse_state(link).unwrap();
    let [classes, radiance] = [LayerName::Class, LayerName::Radiance]
        .map(|layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values);
    let green = |row: usize, column: usize| radiance[3 * (row * 640 + column) + 1];
    let is_sea = |row: usize, column: usize| classes[row * 640 + column] == 1.0;
    let places = (40..100).flat_map(|row| (441..629).map(move |column| (row, column)));
    let bends: Vec<f64> = places
        .filter(|&(row, column)| (column - 1..=column + 1).all(|at| is_sea(row, at)))
        .map(|(row, at)| ((green(row, at - 1) + green(row, at + 1)) / green(row, at) - 2.0).abs())
        .collect();
    let dots = bends.iter().filter(|bend| **bend > 0.2).count() as f64 / bends.len() as f64;
    println!("{dots:.4} of {} pixels stand out from those beside them by a tenth", bends.len());
    // Where fronts are narrower than pixels 0.029 did.
    assert!(bends.len() > 8000 && dots < 0.005, "{dots} of {}", bends.len());
}

#[test]
fn waves_that_run_along_a_headland_are_no_comb() {
    const WHOLE: [u32; 2] = [640, 360];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let link = "#view=36.4,25.35,400,40,75&clouds=0&time=2026-06-11T10:00:00Z";
    let pixels = render::picture(&mut renderer, &render::parse_state(link).unwrap(), WHOLE).unwrap();
    // Of red, which the water takes: it is foam's.
    let white = |columns: std::ops::Range<u32>, rows: std::ops::Range<u32>| {
        let is_white = |x: u32, y: u32| pixels[(4 * (y * WHOLE[0] + x)) as usize] > 130;
        let count = rows.len() * columns.len();
        rows.flat_map(|y| columns.clone().map(move |x| (x, y))).filter(|(x, y)| is_white(*x, *y)).count() as f64
            / count as f64
    };
    // Off the tip, past which waves come by, and along the beach that faces them.
    let [off_tip, on_beach] = [white(232..292, 215..262), white(20..180, 296..330)];
    println!("of the water off the headland {off_tip:.4} is white, along its beach {on_beach:.4}");
    assert!(on_beach > 0.2, "{on_beach}");
    // 0.076 where crests break whichever way they go: rows of them, one behind the other, out from the land.
    assert!(off_tip < 0.02, "{off_tip}");
}
