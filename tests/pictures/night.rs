//! Night: the moon and the stars stand where an ephemeris has them (PyEphem 4.2.1, for 35.6812 N 14.25 W, without refraction), and light
//! what they should.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::Radiance;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [320, 180];
/// Full to 0.998 parts.
const FULL_MOON: &str = "time=2026-11-24T20:00:00Z";
const MOON: [f64; 2] = [76.6028, 27.0060];
const NO_MOON: &str = "time=2026-11-10T03:00:00Z";

/// A view from 3 m over the sea towards an azimuth and an elevation, degrees.
fn link([azimuth, elevation]: [f64; 2], rest: &str) -> String {
    format!("#view=35.6812,-14.25,3,{azimuth},{}&clouds=0&bft=3&quality=low&{rest}", 90.0 + elevation)
}

fn middle() -> [f64; 2] {
    SIZE.map(|side| f64::from(side) / 2.0)
}

/// The middle of what is given in weights by pixel.
fn centroid(weights: &[f64]) -> [f64; 2] {
    let total: f64 = weights.iter().sum();
    let width = SIZE[0] as usize;
    let sum = |part: fn(usize, usize) -> usize| {
        weights.iter().enumerate().map(|(i, w)| w * (part(i, width) as f64 + 0.5)).sum::<f64>() / total
    };
    [sum(|i, width| i % width), sum(|i, width| i / width)]
}

fn luminance(view: &str) -> Vec<f64> {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    render::measure(&mut renderer, &render::parse_state(view).unwrap(), SIZE, LayerName::Luminance).unwrap().values
}

#[test]
fn the_moon_stands_where_it_should_and_its_path_below_it() {
    let seen = luminance(&link(MOON, FULL_MOON));
    let brightest = seen.iter().copied().fold(0.0, f64::max);
    let disc: Vec<f64> = seen.iter().map(|l| if *l > 0.3 * brightest { *l } else { 0.0 }).collect();
    let [x, y] = centroid(&disc);
    let [mx, my] = middle();
    println!("the moon is at {x:.2}, {y:.2}; {brightest:.3}");
    // A pixel is 0.28 degrees wide, half of the disc.
    assert!((x - mx).abs() < 0.6 && (y - my).abs() < 0.6, "{x}, {y}");
    // The water: brightest under the moon, and there far brighter than where no moon is.
    let path = luminance(&link([MOON[0], -20.0], FULL_MOON));
    let column = |luminance: &[f64], x: usize| {
        let from = SIZE[1] as usize / 2;
        (from..SIZE[1] as usize).map(|y| luminance[y * SIZE[0] as usize + x]).sum::<f64>()
    };
    let columns: Vec<f64> = (0..SIZE[0] as usize).map(|x| column(&path, x)).collect();
    let third = SIZE[0] as usize / 3;
    let [left, mid, right] = [0, 1, 2].map(|i| columns[i * third..(i + 1) * third].iter().sum::<f64>());
    println!("water left of the moon, under it and right of it: {left:.4} {mid:.4} {right:.4}");
    assert!(mid > 3.0 * left && mid > 3.0 * right, "{left} {mid} {right}");
}

#[test]
fn moonlight_is_dimmer_than_day_and_brighter_than_a_night_without() {
    let down = |time: &str| {
        let seen = luminance(&link([330.0, -20.0], time));
        seen.iter().sum::<f64>() / seen.len() as f64
    };
    let [day, moon, none] = ["time=2026-11-24T12:00:00Z", FULL_MOON, NO_MOON].map(down);
    println!("sea by day {day:.3e}, by moonlight {moon:.3e}, without {none:.3e}");
    // The picture's full moon has 0.008 of the sun's light, 0.87 of it six degrees before it is full, a quarter lower than the sun of this
    // pair; a low light is mirrored as the sky of a low sun is, within a third.
    let share = (moon - none) / day;
    assert!((0.004..0.009).contains(&share), "{share}");
    assert!(none > 0.0, "{none}");
}

#[test]
fn sirius_and_canopus_stand_where_they_should() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Canopus is half a degree over the horizon, in thick air.
    for (name, at, least) in [("Sirius", [154.98546, 33.73580], 100.0), ("Canopus", [170.32609, 0.50718], 1.0)] {
        let mut picture = |layers: &str| {
            let state = render::parse_state(&link(at, &format!("{NO_MOON}{layers}"))).unwrap();
            render::picture(&mut renderer, &state, SIZE).unwrap()
        };
        let [with, without] = [picture(""), picture("&layers=-stars")];
        let difference: Vec<f64> = with
            .chunks_exact(4)
            .zip(without.chunks_exact(4))
            .map(|(a, b)| (0..3).map(|i| f64::from(a[i]) - f64::from(b[i])).sum::<f64>())
            .collect();
        let shown = difference.iter().filter(|d| **d > 9.0).count();
        let [mx, my] = middle();
        let near: Vec<f64> = difference
            .iter()
            .enumerate()
            .map(|(i, d)| {
                let (x, y) = (i % SIZE[0] as usize, i / SIZE[0] as usize);
                let off = (x as f64 + 0.5 - mx).hypot(y as f64 + 0.5 - my);
                if off < 8.0 { d.max(0.0) } else { 0.0 }
            })
            .collect();
        let brightest = near.iter().copied().fold(0.0, f64::max);
        let [x, y] = centroid(&near);
        println!("{name}: {brightest} at {x:.2}, {y:.2}; {shown} pixels have starlight");
        assert!(brightest >= least, "{name}: {brightest}");
        // A pixel is 0.28 degrees, the spot 0.75 pixels wide; aberration is 0.006 degrees.
        assert!((x - mx).abs() < 0.5 && (y - my).abs() < 0.5, "{name} is at {x}, {y}");
        assert!(shown > 20, "{shown}");
    }
}

#[test]
fn by_day_no_star_is_seen_but_from_space() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut changed = |view: &str| {
        let mut picture = |layers: &str| {
            let state = render::parse_state(&format!("{view}&quality=low{layers}")).unwrap();
            render::picture(&mut renderer, &state, SIZE).unwrap()
        };
        let [with, without] = [picture(""), picture("&layers=-stars")];
        with.chunks_exact(4).zip(without.chunks_exact(4)).filter(|(a, b)| a != b).count()
    };
    assert_eq!(changed("#view=35.6812,-14.25,3,155,100&clouds=0&time=2026-11-10T13:00:00Z"), 0);
    // High over a lit sea the sky is bright at the horizon and dark above.
    let space = changed("#view=16,-25,30000000&clouds=0&time=2026-11-20T14:20:00Z");
    assert!(space > 100, "{space}");
}

#[test]
fn a_city_is_lit_where_it_lies_by_night_alone_and_no_sea_is() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut light = |view: &str| {
        let mut picture = |layers: &str| {
            let state = render::parse_state(&format!("{view}{layers}")).unwrap();
            render::picture(&mut renderer, &state, SIZE).unwrap()
        };
        let [with, without] = [picture(""), picture("&layers=-lights")];
        let light = |(a, b): (&[u8], &[u8])| (0..3).map(|i| f64::from(a[i]) - f64::from(b[i])).sum::<f64>();
        with.chunks_exact(4).zip(without.chunks_exact(4)).map(light).collect::<Vec<_>>()
    };
    let [mx, my] = middle();
    let off = |i: usize| ((i % SIZE[0] as usize) as f64 + 0.5 - mx).hypot((i / SIZE[0] as usize) as f64 + 0.5 - my);

    // Madrid, whose middle is the Puerta del Sol, on a dark plain. A pixel is 1.38 km.
    let madrid = "#view=40.4169,-3.7035,300000&clouds=0";
    let night = light(&format!("{madrid}&time=2026-12-10T22:00:00Z"));
    let near: Vec<f64> = night.iter().enumerate().map(|(i, d)| if off(i) < 25.0 { d.max(0.0) } else { 0.0 }).collect();
    let mean = |inside: bool, reach: f64| {
        let of: Vec<f64> =
            night.iter().enumerate().filter(|(i, _)| (off(*i) < reach) == inside).map(|(_, d)| *d).collect();
        of.iter().sum::<f64>() / of.len() as f64
    };
    let [x, y] = centroid(&near);
    println!("Madrid is at {x:.1}, {y:.1}: {:.1} on it, {:.1} about it", mean(true, 10.0), mean(false, 40.0));
    // A texel of the lights is 19.5 km from north to south, 10.8 pixels from west to east: its middle may be half of that off.
    assert!((x - mx).abs() < 5.4 && (y - my).abs() < 7.1, "{x}, {y}");
    assert!(mean(true, 10.0) > 10.0 * mean(false, 40.0));
    assert!(light(&format!("{madrid}&time=2026-12-10T12:00:00Z")).iter().all(|d| *d == 0.0));

    // Oahu in the dark, without the glow of a lens: lamps, and none in the sea but for what a spot reaches.
    let oahu = "#view=21.45,-157.95,120000&clouds=0&time=2026-12-10T09:00:00Z&quality=low";
    let night = light(oahu);
    let mut measuring = render::headless(DATA, Radiance::Single).unwrap();
    let state = render::parse_state(oahu).unwrap();
    let water = render::measure(&mut measuring, &state, SIZE, LayerName::Class).unwrap().values;
    let [width, height] = SIZE.map(|side| side as usize);
    let at_sea = |i: usize| {
        let (x, y) = (i % width, i / width);
        let around = |c: usize, side: usize| c.saturating_sub(4)..(c + 5).min(side);
        around(y, height).all(|y| around(x, width).all(|x| water[y * width + x] == 1.0))
    };
    let lit = night.iter().filter(|d| **d > 30.0).count();
    let at_sea = night.iter().enumerate().filter(|(i, d)| **d > 3.0 && at_sea(*i)).count();
    println!("{lit} pixels of Oahu are lit, {at_sea} of the sea about it");
    assert!(lit > 100 && at_sea == 0, "{lit}, {at_sea}");
}

#[test]
fn the_milky_way_lies_along_the_galaxy() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Half of the pixels in the middle, 15 degrees wide, show no star: their median is what is between stars.
    let mut between_stars = |time: &str| {
        let mut sum = |layers: &str| {
            let view = format!("#view=-28.9,20,3,0,180&clouds=0&bft=3&time={time}&layers={layers}");
            let picture = render::picture(&mut renderer, &render::parse_state(&view).unwrap(), SIZE).unwrap();
            let third = |i: &usize, side: usize| (side / 3..side - side / 3).contains(i);
            let [width, height] = SIZE.map(|side| side as usize);
            let pixels = picture.chunks_exact(4).enumerate();
            let middle = pixels.filter(|(i, _)| third(&(i % width), width) && third(&(i / width), height));
            middle.map(|(_, p)| p[..3].iter().map(|v| i32::from(*v)).sum::<i32>()).collect::<Vec<_>>()
        };
        let [with, without] = [sum("land"), sum("-stars")];
        let mut light: Vec<i32> = with.iter().zip(&without).map(|(a, b)| a - b).collect();
        light.sort_unstable();
        light[light.len() / 2]
    };
    // Sidereal times, by the formula of the Astronomical Almanac, that put the galaxy's middle (17 h 46 min, -28.9 degrees) and its south pole
    // (0 h 51 min, -27.1 degrees) overhead; both nights without a moon.
    let [middle, pole] = ["2026-07-14T20:56:00Z", "2026-11-09T20:17:00Z"].map(&mut between_stars);
    println!("between stars: {middle} towards the middle of the galaxy, {pole} away from it, of 765");
    // Three steps of each colour are seen beside none.
    assert!(middle >= 9 && pole == 0, "{middle}, {pole}");
}

#[test]
fn a_moonless_midnight_has_a_sea() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // The sun 5, 40 and 75 degrees below the horizon, the moon below it, too.
    for time in ["2026-05-15T18:45:00Z", "2026-05-15T21:30:00Z", "2026-05-16T00:00:00Z"] {
        let link = format!("#view=5,0,10,10,80&clouds=0&bft=4&quality=medium&time={time}");
        let state = render::parse_state(&link).unwrap();
        let values = render::measure(&mut renderer, &state, [64, 36], LayerName::Radiance).unwrap().values;
        let missing = values.iter().filter(|value| !value.is_finite()).count();
        assert_eq!(missing, 0, "of {} numbers at {time}", values.len());
    }
}
