//! The light of a picture: a clear day's sky, what the sea mirrors of it, foam.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::daylight;
use ocean_globe::model::optics;
use ocean_globe::renderer::{Radiance, Renderer};

pub const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// On the equator in the Atlantic, the sun 40 degrees high in the west.
const AT_40_DEG: &str = "wind=7@90&time=2026-03-20T17:27:30Z&layers=-foam&water=open";
/// Share of the daylight that is the sky's, about.
const SKYLIGHT: f64 = 0.2;
const OPEN: &str = "&layers=-foam&water=open";

const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

pub fn luminance(rgb: [f64; 3]) -> f64 {
    rgb.iter().zip(LUMINANCE).map(|(part, share)| part * share).sum()
}

/// CIE 1931 x and y of linear sRGB.
fn chromaticity([r, g, b]: [f64; 3]) -> [f64; 2] {
    let x = 0.4124 * r + 0.3576 * g + 0.1805 * b;
    let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let z = 0.0193 * r + 0.1192 * g + 0.9505 * b;
    [x / (x + y + z), y / (x + y + z)]
}

/// Radiance in the middle of a picture.
fn seen(renderer: &mut Renderer, view: &str) -> [f64; 3] {
    let state = render::parse_state(&format!("#view={view}&clouds=0&{AT_40_DEG}")).unwrap();
    let measured = render::measure(renderer, &state, [9, 9], LayerName::Radiance).unwrap();
    assert_eq!(measured.shape, [9, 9, 3]);
    std::array::from_fn(|part| measured.values[3 * 40 + part])
}

#[test]
fn the_sky_is_that_of_a_clear_day() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // A quarter turn from the sun.
    let mut sky = |elevation: f64| seen(&mut renderer, &format!("0,-30,10,0,{}", 90.0 + elevation));
    let zenith = sky(89.9);
    let [high, low] = [10.0, 1.0].map(&mut sky);
    let [near_top, at_10, at_1] =
        [zenith, high, low].map(|rgb| (luminance(rgb) / luminance(zenith), chromaticity(rgb)));
    println!("zenith {zenith:.5?}: {near_top:.3?}, at 10 degrees {at_10:.3?}, at 1 degree {at_1:.3?}");
    // Of spectral models of an ocean's air (optical depth of the aerosol 0.08): 2.4 and 2.6, in bands of cloudless days.
    assert!((1.7..2.8).contains(&at_10.0) && (1.8..3.2).contains(&at_1.0), "{at_10:?} {at_1:?}");
    let near = |found: [f64; 2], wanted: [f64; 2], by: f64| found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < by);
    assert!(near(near_top.1, [0.255, 0.257], 0.012), "zenith {near_top:?}");
    assert!(near(at_1.1, [0.300, 0.312], 0.015), "at 1 degree {at_1:?}");
    // No green skies by day.
    for elevation in [1.0, 3.0, 6.0, 10.0, 20.0, 35.0, 60.0, 89.0] {
        let [_, g, b] = sky(elevation);
        assert!(g < b, "{elevation} degrees: {g} {b}");
    }
    // Looking towards the sun it is brighter than away from it: the aerosol scatters forward.
    let [towards, away] = [270, 90].map(|heading| luminance(seen(&mut renderer, &format!("0,-30,10,{heading},110"))));
    assert!(towards > 4.0 * away, "{towards} towards the sun, {away} away from it");
}

/// Mean radiance of the sea at a depression, degrees, from 15 m: of a band a tenth of that high, over so many places so many degrees apart.
fn sea(renderer: &mut Renderer, depression: f64, hour: &str, (places, apart): (i32, f64)) -> [f64; 3] {
    let size = [160, 90];
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for place in 0..places {
        let lon = -30.0 + apart * f64::from(place);
        let state = format!("#view=0,{lon},15,0,{}&clouds=0&{hour}", 90.0 - depression);
        let measured =
            render::measure(renderer, &render::parse_state(&state).unwrap(), size, LayerName::Radiance).unwrap();
        // The picture is 60 degrees high.
        let half = (depression / 20.0 * 1.5).round().max(1.0) as usize;
        for row in 45 - half..45 + half {
            for column in 40..120 {
                let pixel = 3 * (row * 160 + column);
                sum = std::array::from_fn(|part| sum[part] + measured.values[pixel + part]);
                count += 1.0;
            }
        }
    }
    sum.map(|part| part / count)
}

#[test]
fn the_sea_mirrors_the_sky_as_rough_water_does() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let zenith = luminance(seen(&mut renderer, "0,-30,10,0,179.9"));
    // A quarter turn from the sun; over the zenith's luminance, by spectral models of sky, facets and water.
    for (depression, wanted) in [(45.0, 0.097), (20.0, 0.30), (10.0, 0.58), (5.0, 0.78), (2.0, 0.91)] {
        // So many that the waves' own slopes, a tenth or so a place, leave 2 % of the mean to chance.
        let found = luminance(sea(&mut renderer, depression, AT_40_DEG, (25, 0.01))) / zenith;
        println!("{depression} degrees: {found:.3} of {wanted}");
        assert!((found / wanted - 1.0).abs() < 0.15, "{depression} degrees down: {found}, not {wanted}");
    }
}

/// UTC of the day of [`AT_40_DEG`] at which the sun there is so high: it climbs and sinks by 15 degrees an hour.
pub fn with_sun_at(elevation: f64) -> String {
    let seconds = (17.0 * 3600.0 + 27.0 * 60.0 + 30.0 + (40.0 - elevation) * 240.0) as u32;
    format!("time=2026-03-20T{:02}:{:02}:{:02}Z", seconds / 3600, seconds / 60 % 60, seconds % 60)
}

/// Luminance of the sky by elevation (rows of 3 degrees from 1.5 up) and by azimuth from the sun (columns of 30 degrees from 0).
fn sky_luminance(renderer: &mut Renderer, sun: &str) -> Vec<[f64; 7]> {
    const ROWS: u32 = 180;
    let mut columns: [Vec<f64>; 7] = Default::default();
    for (turn, column) in columns.iter_mut().enumerate() {
        // The sun sets in the west. Pictures are 60 degrees high: two of them reach from 1.5 to 89.
        for (middle, elevations) in [(28.0, 0..15), (62.0, 15..30)] {
            let link = format!("#view=0,-30,15,{},{}&clouds=0&wind=7@90&{sun}", 270 - 30 * turn, 90.0 + middle);
            let state = render::parse_state(&link).unwrap();
            let values = render::measure(renderer, &state, [5, ROWS], LayerName::Luminance).unwrap().values;
            for step in elevations {
                let above = 1.5 + 3.0 * f64::from(step) - middle;
                let row = 0.5 * f64::from(ROWS) * (1.0 - above.to_radians().tan() / 30f64.to_radians().tan());
                column.push(values[5 * (row as usize).min(ROWS as usize - 1) + 2]);
            }
        }
    }
    (0..30).map(|row| std::array::from_fn(|turn| columns[turn][row])).collect()
}

/// What a sea mirrors of a sky and a sun of an elevation, seen across both the sun and the wind under an angle of depression: the mean over
/// facets with Cox and Munk's Gaussian slopes, by the area that each shows.
fn mirrored(sky: &[[f64; 7]], wind: f64, elevation: f64, depression: f64) -> f64 {
    let slopes = optics::cox_munk_mss(wind);
    // The sun, and the wind, on the left, at -x; the eye looks along y.
    let deviations = DVec2::new(slopes.up, slopes.cross).map(f64::sqrt);
    let facet = |steps: DVec2| (-steps * deviations).extend(1.0);
    let (sin, cos) = depression.to_radians().sin_cos();
    let to_eye = DVec3::new(0.0, -cos, sin);
    let mirror = |cosine: f64| optics::fresnel(cosine, 1.0, optics::WATER_INDEX).unpolarised();
    let (mut sum, mut area) = (0.0, 0.0);
    let steps = (-24..=24).map(|i| f64::from(i) / 6.0);
    for (a, b) in steps.clone().flat_map(|a| steps.clone().map(move |b| (a, b))) {
        let facet = facet(DVec2::new(a, b));
        let weight = (-0.5 * (a * a + b * b)).exp() * to_eye.dot(facet).max(0.0);
        let normal = facet.normalize();
        let cosine = normal.dot(to_eye).max(0.0);
        let out = 2.0 * cosine * normal - to_eye;
        let row = (out.z.abs().min(1.0).asin().to_degrees() / 3.0 - 0.5).clamp(0.0, 29.0);
        let turn = (out.truncate().angle_to(DVec2::NEG_X).abs().to_degrees() / 30.0).min(6.0);
        let (low, left) = ((row as usize).min(28), (turn as usize).min(5));
        let (y, x) = (row - low as f64, turn - left as f64);
        let at = |row: usize| sky[row][left] * (1.0 - x) + sky[row][left + 1] * x;
        sum += weight * (at(low) * (1.0 - y) + at(low + 1) * y) * mirror(cosine);
        area += weight;
    }
    // The sun itself, in the facets that stand half way between it and the eye.
    let (up, out) = elevation.to_radians().sin_cos();
    let half = (DVec3::new(-out, 0.0, up) + to_eye).normalize();
    let steps = half.truncate() / half.z / deviations;
    let density = (-0.5 * steps.length_squared()).exp() / (TAU * deviations.x * deviations.y);
    let sun = daylight::irradiance(up) / up * (1.0 - SKYLIGHT);
    sum / area + sun * mirror(half.dot(to_eye)) * density / (4.0 * sin * half.z.powi(4))
}

#[test]
fn the_sea_mirrors_its_sky_whatever_sun_and_wind() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for elevation in [20.0, 40.0, 60.0] {
        let sun = with_sun_at(elevation);
        let sky = sky_luminance(&mut renderer, &sun);
        // What comes out of the water: the open ocean's reflectance, through the surface once more.
        let water = 0.0058 * daylight::irradiance(f64::sin(f64::to_radians(elevation))) / std::f64::consts::PI;
        for wind in [3.0, 7.0, 12.0] {
            for depression in [45.0, 20.0, 10.0] {
                // A patch of gusts is up to 15 km long, and one of them would stand for all.
                let found = luminance(sea(&mut renderer, depression, &format!("wind={wind}@90&{sun}{OPEN}"), (5, 0.2)));
                let wanted = mirrored(&sky, wind, elevation, depression) + water;
                println!(
                    "sun {elevation}, {wind} m/s, {depression} down: {found:.4} of {wanted:.4}, {:.3}",
                    found / wanted
                );
                // Wanted are 15 %, which the gradient of a low sun's sky about the mean direction of what is mirrored, gusts' thicker
                // tails and waves that hide behind each other in a light wind leave room for ten more.
                assert!((found / wanted - 1.0).abs() < 0.25, "sun {elevation}, {wind} m/s, {depression} degrees down");
            }
        }
    }
}

#[test]
fn the_horizon_is_a_step_that_grows_with_the_wind() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let sky = luminance(seen(&mut renderer, "0,-30,15,0,91"));
    let found = [3, 7, 12].map(|wind| {
        let link = format!("wind={wind}@90&time=2026-03-20T17:27:30Z{OPEN}");
        luminance(sea(&mut renderer, 1.0, &link, (5, 0.01))) / sky
    });
    // Of spectral models, sea over sky at one degree, and the haze of the 860 m between: 0.933 of it is left, and 0.067 of the sky's added.
    for ((found, wanted), wind) in found.iter().zip([0.47, 0.36, 0.30]).zip([3, 7, 12]) {
        let wanted = 0.933 * wanted + 0.067;
        println!("{wind} m/s: {found:.3} of {wanted:.3}");
        assert!((found / wanted - 1.0).abs() < 0.15, "{wind} m/s: {found}, not {wanted}");
    }
    assert!(found[0] > found[1] && found[1] > found[2], "{found:?}");
    // From 300 m the air before the last of the sea, tens of kilometres of it, leaves next to nothing of the step.
    let [above, below] = [89.9, 89.2].map(|tilt| luminance(seen(&mut renderer, &format!("0,-30,300,0,{tilt}"))));
    println!("from 300 m {:.3}", below / above);
    assert!((below / above - 1.0).abs() < 0.15, "{below} under the horizon, {above} over it");
}

#[test]
fn dense_foam_outshines_the_sea_and_the_sky_at_the_horizon() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let dark = luminance(sea(&mut renderer, 45.0, AT_40_DEG, (5, 0.01)));
    let sky = luminance(seen(&mut renderer, "0,-30,10,0,91"));
    // The brightest thousandth of a sea full of whitecaps, too calm for spray, without sparkles, where a great crest breaks before the eye.
    let link = "#view=0,-29.7,15,0,45&clouds=0&wind=14@90&foam=3&quality=low&time=2026-03-20T17:27:30Z&water=open";
    let state = render::parse_state(link).unwrap();
    let mut values = render::measure(&mut renderer, &state, [320, 180], LayerName::Luminance).unwrap().values;
    values.sort_by(f64::total_cmp);
    let dense = values[values.len() * 999 / 1000];
    println!("dense foam {:.1} times the sea, {:.2} times the sky at the horizon", dense / dark, dense / sky);
    // 63 and 2.5 for level foam of the albedo 0.55. Foam that leans by 15 degrees towards the sun or away from it is a quarter brighter or
    // darker, and this is the brightest.
    assert!((63.0 * 0.8..63.0 * 1.35).contains(&(dense / dark)), "{}", dense / dark);
    assert!((2.5 * 0.8..2.5 * 1.35).contains(&(dense / sky)), "{}", dense / sky);
}

#[test]
fn the_ocean_from_space_is_as_bright_as_it_is() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Straight down, far from the glint.
    let found = seen(&mut renderer, "0,-30,20000000,0,0");
    // Reflectance factors of a spectral model: what a white surface in the same sun, 40 degrees high beyond the air, would be one of.
    let white = 40f64.to_radians().sin() / std::f64::consts::PI;
    let [r, g, b] = found.map(|part| part / white);
    println!("{r:.4} {g:.4} {b:.4}, green over blue {:.3}, red over blue {:.3}", g / b, r / b);
    for (found, wanted) in [(r, 0.03), (g, 0.06), (b, 0.14)] {
        // Wanted to one or two figures.
        assert!((found / wanted - 1.0).abs() < 0.17, "{found}, not {wanted}");
    }
    assert!((0.40..0.48).contains(&(g / b)) && (0.20..0.27).contains(&(r / b)), "{found:?}");
}

#[test]
fn foam_can_be_taken_away() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut mean = |layers: &str| {
        let link = format!("#view=45,-30,60,70,40&clouds=0&bft=9&quality=low&time=2026-06-21T14:00:00Z{layers}");
        let measured =
            render::measure(&mut renderer, &render::parse_state(&link).unwrap(), [64, 36], LayerName::Luminance);
        let values = measured.unwrap().values;
        values.iter().sum::<f64>() / values.len() as f64
    };
    let [with, without, with_again] = ["", "&layers=-foam", ""].map(&mut mean);
    println!("with foam {with:.5}, without {without:.5}");
    assert!(without < 0.7 * with, "{without} of {with}");
    assert_eq!(with, with_again);
}

#[test]
fn the_higher_ground_is_the_less_air_is_before_it_seen_from_space() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Forests on the eastern slope of the Andes, where pixels' own rays tell the place.
    let state = render::parse_state("#view=-12.5,-72,600000,0,0&clouds=0&time=2026-06-21T16:30:00Z").unwrap();
    let mut layer = |layer| render::measure(&mut renderer, &state, [320, 180], layer).unwrap().values;
    let (light, heights) = (layer(LayerName::Radiance), layer(LayerName::Height));
    let blue = |low: f64| {
        let of_band = heights.iter().zip(light.chunks_exact(3)).filter(|(h, _)| (low..low + 300.0).contains(*h));
        let (count, sum) = of_band.fold((0, 0.0), |(count, sum), (_, light)| (count + 1, sum + light[2]));
        println!("{low} m: {count} pixels, {:.5}", sum / f64::from(count));
        assert!(count > 100);
        sum / f64::from(count)
    };
    let [low, high] = [200.0, 1_400.0].map(blue);
    println!("1,200 m higher there is {:.3} of it", high / low);
    // The molecules' air is less by exp(-1.2 / 8), 0.861, and what forests send back, a third of this light, is somewhat more. With as much air it is 1.074.
    assert!((0.86..1.0).contains(&(high / low)), "{}", high / low);
}
