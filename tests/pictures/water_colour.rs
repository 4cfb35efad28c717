//! The colour of water: of its kinds, by place, and over banks.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::daylight::BALANCE;
use ocean_globe::renderer::{Radiance, Renderer};

use crate::light::DATA;

/// Radiance straight down from 60 m over a place, without foam.
fn water(renderer: &mut Renderer, place: &str, time: &str, kind: &str) -> [f64; 3] {
    let link = format!("#view={place},60,0,0&clouds=0&wind=3@90&layers=-foam&time={time}&water={kind}");
    let state = render::parse_state(&link).unwrap();
    let values = render::measure(renderer, &state, [32, 32], LayerName::Radiance).unwrap().values;
    let pixels = values.len() as f64 / 3.0;
    std::array::from_fn(|part| values.iter().skip(part).step_by(3).sum::<f64>() / pixels)
}

#[test]
fn water_has_the_colour_of_its_kind() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Reflectances of a spectral model (see `deep_reflectance` in `shaders/lib/water_types.wgsl`), linear sRGB.
    let kinds = [
        ("open", [0.0, 0.0043, 0.0265]),
        ("temperate", [0.0, 0.0078, 0.0194]),
        ("shelf", [0.0003, 0.0119, 0.0149]),
        ("coastal", [0.006, 0.024, 0.015]),
        ("turbid", [0.049, 0.083, 0.036]),
    ];
    let gyre = [0.0, 0.0028, 0.0322];
    let mut of = |kind| water(&mut renderer, "0,-30", "2026-03-20T14:00:00Z", kind);
    let clearest = of("gyre");
    // The rest of what is seen is the same for all, so that differences are those of the reflectances.
    let light = (of("turbid")[1] - clearest[1]) / (kinds[4].1[1] - gyre[1]);
    for (kind, reflectance) in kinds {
        let found = of(kind);
        for part in 0..3 {
            let wanted = (reflectance[part] - gyre[part]) * light;
            // The sun is whiter than its light at sea level by up to a seventh in the red and the blue.
            let change = found[part] - clearest[part];
            assert!(
                (change - wanted).abs() < 0.02 * light * 0.083 + 0.15 * wanted.abs(),
                "{kind} {part}: {change}, {wanted}"
            );
        }
    }
}

#[test]
fn cool_shelves_are_green_and_gyres_blue() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut greenness = |place, hour| {
        let [_, g, b] = water(&mut renderer, place, &format!("2026-06-21T{hour}:00:00Z"), "auto");
        g / b
    };
    // The Dutch coast is 15 km from the last place, on the same shelf as the North Sea's middle.
    let places = [("26,-60", "13"), ("54.5,3.5", "09"), ("-5,110", "02"), ("52.4,4.3", "09")];
    let [sargasso, north_sea, java_sea, by_holland] = places.map(|(place, hour)| greenness(place, hour));
    println!(
        "green over blue: Sargasso Sea {sargasso:.2}, North Sea {north_sea:.2} and by Holland {by_holland:.2}, Java Sea {java_sea:.2}"
    );
    assert!(north_sea > 2.0 * sargasso && java_sea < 0.75 * north_sea, "{sargasso} {north_sea} {java_sea}");
    assert!(by_holland > 1.1 * north_sea, "{by_holland} {north_sea}");
}

#[test]
fn rivers_make_warm_coasts_green_where_there_are_any() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Radiance of blue over that of green, straight down from 60 m.
    let mut blueness = |place, hour| {
        let [_, g, b] = water(&mut renderer, place, &format!("2026-06-21T{hour}:00:00Z"), "auto");
        b / g
    };
    // Over pale sand 4 m down: the Bay of Halong, and Dahlak in the dry Red Sea. In the deep bay of Rio, and in a bay of the Azores.
    let [halong, dahlak] = [("20.84,107.14", "05"), ("15.72,40.25", "09")].map(|(place, hour)| blueness(place, hour));
    let [rio, terceira] = [("-22.80,-43.16", "15"), ("38.64,-27.2", "14")].map(|(place, hour)| blueness(place, hour));
    println!("blue over green: Halong {halong:.2}, Dahlak {dahlak:.2}; Rio {rio:.2}, Terceira {terceira:.2}");
    assert!(halong < 0.8 * dahlak && rio < 0.8 * terceira, "{halong} {dahlak} {rio} {terceira}");
}

#[test]
fn great_rivers_carry_silt_into_the_sea() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Radiance of red and of blue over that of green, straight down from 60 m.
    let mut tint = |(place, hour)| {
        let [r, g, b] = water(&mut renderer, place, &format!("2026-06-21T{hour}:00:00Z"), "auto");
        [r / g, b / g]
    };
    // Off the mouths of the Amazon, the Mississippi and the Plate; out at sea beyond the first, and before Florida, which has no such river.
    let [amazon, mississippi, plate] = [("0.3,-49.6", "18"), ("29.0,-89.3", "14"), ("-35,-57", "14")].map(&mut tint);
    let [atlantic, florida] = [("4,-43", "18"), ("25.3,-83", "14")].map(&mut tint);
    println!("red and blue over green: {amazon:.2?}, {mississippi:.2?}, {plate:.2?}; {atlantic:.2?}, {florida:.2?}");
    // Silt sends back more red than blue (`SILTY_REFLECTANCE`), clear water next to none.
    for [red, blue] in [amazon, mississippi, plate] {
        assert!(red > 0.5 && blue < 0.9, "{red} {blue}");
    }
    for [red, blue] in [atlantic, florida] {
        assert!(red < 0.5 && blue > 1.1, "{red} {blue}");
    }
}

/// Green over blue of what the bed of the Great Bahama Bank, 10 m down, adds to the open sea's light.
#[test]
fn banks_shine_through_ten_metres_of_water() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // No seagrass at low quality, no grain of sand, and no wind: the data's 10 m over all of the picture; and 1,500 m.
    let mut seen = |place: &str| {
        let link = format!("#view={place},300&clouds=0&wind=0.5@90&water=open&quality=low&time=2026-03-20T16:00:00Z");
        let state = render::parse_state(&link).unwrap();
        let values = render::measure(&mut renderer, &state, [32, 18], LayerName::Radiance).unwrap().values;
        let mut sums = [0.0; 3];
        values.chunks_exact(3).for_each(|rgb| (0..3).for_each(|part| sums[part] += rgb[part]));
        sums
    };
    let (bank, deep) = (seen("24.2,-78.6"), seen("24.8,-77.6"));
    let added: Vec<f64> = (0..3).map(|part| bank[part] - deep[part]).collect();
    // Sand that is as dark as 10 m down (`bed_colour`), twice 10 m of water of type IB, what is sent back below the surface; in water's stead.
    let [albedo, lost, water] = [[0.326, 0.244], [0.068, 0.030], [0.0043, 0.0265]];
    let back = 1.0 - 0.934 / (1.333 * 1.333);
    let wanted: Vec<f64> = (0..2)
        .map(|part| {
            let kept = f64::exp(-20.0 * lost[part]);
            let lit = albedo[part] * kept * (1.0 - back) / (1.0 - back * albedo[part] * kept);
            lit - water[part] / 0.98 * kept
        })
        .collect();
    // Daylight is whiter than the balance by its inverse.
    let light = BALANCE[2] / BALANCE[1];
    let (found, expected) = (added[1] / added[2], wanted[0] / wanted[1] * light);
    println!(
        "green over blue {found:.3}, wanted {expected:.3}; green {:.2} times that of the deep sea",
        bank[1] / deep[1]
    );
    assert!((found / expected - 1.0).abs() < 0.1, "{found} {expected}");
    assert!(bank[1] > 2.0 * deep[1], "{bank:?} {deep:?}");
}

/// Of the lowest rows the refracted sight meets the bed below the picture: the last row that is there must not be drawn out for it.
#[test]
fn a_bed_below_the_picture_is_no_streaks() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let link =
        "#view=-22.99,-43.185,60,300,80&clouds=0&wind=2@150&layers=-foam&quality=medium&time=2026-02-10T14:00:00Z";
    let (width, height) = (320, 180);
    let values =
        render::measure(&mut renderer, &render::parse_state(link).unwrap(), [320, 180], LayerName::Luminance).unwrap();
    // Seagrass on sand; how much changes from a row to the next.
    let change = |rows: std::ops::Range<usize>| {
        let at = rows.clone().flat_map(|row| row * width..row * width + width / 2);
        let sum: f64 = at.map(|at| (values.values[at + width] - values.values[at]).abs()).sum();
        sum / rows.len() as f64
    };
    let [lowest, above] = [height - 6..height - 1, height - 40..height - 20].map(change);
    println!("from row to row {:.3} of what it is above", lowest / above);
    // Where it is mirrored it turns: there half is left. Drawn out, a quarter is, by the waves on the water.
    assert!(lowest > 0.38 * above, "{lowest} for {above}");
}
