//! Rivers in pictures: where the data have them, and water.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::water::WaterClass;
use ocean_globe::data::world::World;
use ocean_globe::renderer::{Radiance, Renderer};

use crate::light::DATA;

const SIZE: [u32; 2] = [320, 180];

fn measured(renderer: &mut Renderer, view: &str, hour: u32, layer: LayerName) -> Vec<f64> {
    let link = format!("#view={view}&clouds=0&wind=4@250&time=2026-06-21T{hour:02}:00:00Z");
    render::measure(renderer, &render::parse_state(&link).unwrap(), SIZE, layer).unwrap().values
}

/// Mean and deviation of the green of some pixels.
fn green(radiance: &[f64], pixels: &[usize]) -> [f64; 2] {
    let count = pixels.len() as f64;
    let mean = pixels.iter().map(|i| radiance[3 * i + 1]).sum::<f64>() / count;
    let square = pixels.iter().map(|i| (radiance[3 * i + 1] - mean).powi(2)).sum::<f64>() / count;
    [mean, square.sqrt()]
}

#[test]
fn from_3_km_rivers_are_level_water_where_samples_have_them() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    // The Rhine at Cologne, and the Danube at Budapest, straight down and out of the sun's glitter; the pictures are 4.4 km wide.
    for view in ["50.94,6.968,3000,0,0", "47.5,19.05,3000,0,0"] {
        let [classes, places, radiance] = [LayerName::Class, LayerName::Lonlat, LayerName::Radiance]
            .map(|layer| measured(&mut renderer, view, 8, layer));
        let ([mut river, mut land], mut wrong) = ([Vec::new(), Vec::new()], Vec::new());
        for (i, class) in classes.iter().enumerate() {
            let (lon, lat) = (places[2 * i], places[2 * i + 1]);
            let found = world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
            let from_bank_m = found.lake_distance_m.unwrap().abs();
            // A pixel is 14 m wide.
            if (*class == 3.0) != (found.class == WaterClass::River) && from_bank_m > 15.0 {
                wrong.push((lat, lon, found.class));
            }
            if from_bank_m > 15.0 {
                let pixels = if *class == 3.0 { &mut river } else { &mut land };
                pixels.push(i);
            }
        }
        assert!(wrong.is_empty(), "{} pixels, the first {:?}", wrong.len(), wrong[0]);
        let found = river.len() as f64 / classes.len() as f64;
        let [[water, ripples], [ground, detail]] = [river, land].map(|pixels| green(&radiance, &pixels));
        println!("{view}: {found:.3} is river of {water:.4} +- {ripples:.4} on ground of {ground:.4} +- {detail:.4}");
        assert!(found > 0.05, "{view}: {found}");
        // Silty water sends back half of what such ground does, the air before them adds to both; from so high no ripple shows.
        assert!(water < 0.75 * ground && ripples < 0.6 * detail, "{view}: {water} {ripples}, {ground} {detail}");
    }
}

/// Of a mean of squares of vectors right and up its longer axis, degrees from right to up, and how many times longer than the other it is.
fn axis([xx, yy, xy]: [f64; 3]) -> (f64, f64) {
    let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    (0.5 * (2.0 * xy).atan2(xx - yy).to_degrees(), ((mean + half) / (mean - half)).sqrt())
}

/// How many of a square's pixels have vectors, their mean, and the mean of their squares about that.
fn spread(seen: impl Fn(usize) -> Option<[f64; 2]>) -> (usize, [f64; 2], [f64; 3]) {
    let [width, height] = SIZE.map(|side| side as usize);
    let columns = (width - height) / 2..(width + height) / 2;
    let all: Vec<[f64; 2]> =
        (0..height).flat_map(|row| columns.clone().map(move |column| row * width + column)).filter_map(seen).collect();
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| all.iter().map(of).sum::<f64>() / all.len() as f64;
    let middle = [mean(&|v| v[0]), mean(&|v| v[1])];
    let about = |a: usize, b: usize| mean(&|v| (v[a] - middle[a]) * (v[b] - middle[b]));
    (all.len(), middle, [about(0, 0), about(1, 1), about(0, 1)])
}

#[test]
fn ripples_of_rivers_are_drawn_out_along_their_course() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let width = SIZE[0] as usize;
    // The Nile, the Danube at Budapest, the Rhine at Cologne.
    for place in ["25.375,32.552", "47.5,19.05", "50.94,6.968"] {
        let mut at = |place: &str, altitude_m: u32, hour, layer| {
            measured(&mut renderer, &format!("{place},{altitude_m},0,0"), hour, layer)
        };
        let of_river =
            |classes: &[f64]| spread(|i| (classes[i] == 3.0).then(|| [(i % width) as f64, -((i / width) as f64)]));
        // From there to its middle, and its course by what is water about that.
        let (_, middle, _) = of_river(&at(place, 1_500, 8, LayerName::Class));
        let places = at(place, 1_500, 8, LayerName::Lonlat);
        let pixel = -middle[1].round() as usize * width + middle[0].round() as usize;
        let place = format!("{},{}", places[2 * pixel + 1], places[2 * pixel]);
        let (wet, _, water) = of_river(&at(&place, 1_000, 8, LayerName::Class));
        let (course, longer) = axis(water);
        // How steeply its light rises, by two suns, as slopes along one's light are told better.
        let mut slopes = [0.0; 3];
        for hour in [5, 8] {
            let light = at(&place, 150, hour, LayerName::Luminance);
            let (_, _, found) = spread(|i| {
                let known = i >= width && i + 1 < light.len();
                known.then(|| [light[i + 1] / light[i], light[i - width] / light[i]].map(f64::ln))
            });
            slopes = std::array::from_fn(|i| slopes[i] + found[i] / (found[0] + found[1]));
        }
        let (across, steeper) = axis(slopes);
        let off = (across - course).rem_euclid(180.0) - 90.0;
        println!(
            "{place}: {wet} pixels, {longer:.2} times as long at {course:.0}°; {steeper:.2} times as steep at {across:.0}°: {off:.0}° off"
        );
        assert!(wet > 10_000 && longer > 1.5, "{place}: {wet} {longer}");
        // The course is that of 700 m of river, which may bend by 15 degrees from the 130 m in the middle.
        assert!(off.abs() < 15.0 && steeper > 1.3, "{place}: {off} {steeper}");
    }
}
