//! Rivers in pictures: where the data have them, and water.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::water::WaterClass;
use ocean_globe::data::world::World;
use ocean_globe::renderer::{Radiance, Renderer};

use crate::light::DATA;

const SIZE: [u32; 2] = [320, 180];

fn measured(renderer: &mut Renderer, view: &str, layer: LayerName) -> Vec<f64> {
    let link = format!("#view={view}&clouds=0&wind=4@250&time=2026-06-21T08:00:00Z");
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
            .map(|layer| measured(&mut renderer, view, layer));
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
