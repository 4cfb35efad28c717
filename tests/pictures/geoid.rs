//! The sea on the geoid, as measured layers have it.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::geoid::height_m;
use ocean_globe::renderer::Radiance;

const WORLD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

fn at(lat_deg: f64, lon_deg: f64) -> f64 {
    height_m(lat_deg.to_radians(), lon_deg.to_radians())
}

#[test]
fn land_and_sea_rise_together_by_the_geoid() {
    let mut renderer = render::headless(WORLD, Radiance::Single).unwrap();
    // Flores in the Azores from the south-east; the second eye is as high over the geoid as the first over the ellipsoid.
    let rest_m = at(39.3, -31.1);
    let mut layers = |link: String, layer| {
        let state = render::parse_state(&(link + "&clouds=0&bft=6&time=2026-11-20T12:00:00Z")).unwrap();
        render::measure(&mut renderer, &state, [96, 64], layer).unwrap().values
    };
    let low = "#view=39.3,-31.1,2000,315,75".to_owned();
    let high = format!("#view=39.3,-31.1,{},315,75&datum=geoid", 2000.0 + rest_m);
    let [places, raised_places] = [&low, &high].map(|link| layers(link.clone(), LayerName::Lonlat));
    let [heights, raised] = [&low, &high].map(|link| layers(link.clone(), LayerName::Height));
    let (mut land, mut sea) = (0, 0);
    for (pixel, (height_m, raised_m)) in heights.iter().zip(&raised).enumerate() {
        let [lon, lat] = [places[2 * pixel], places[2 * pixel + 1]];
        if !height_m.is_finite() {
            assert!(!raised_m.is_finite());
            continue;
        }
        // A link's centimetre moves a slanting sight by a few: waves and slopes make less than that of it, but for edges.
        let rise = raised_m - height_m;
        if (raised_places[2 * pixel + 1] - lat).abs() < 1e-6 {
            assert!((rise - at(lat, lon)).abs() < 0.1, "{lat} {lon}: {rise} of {}", at(lat, lon));
            if *height_m > 20.0 { land += 1 } else { sea += 1 }
        }
    }
    println!("{land} pixels of land, {sea} of the sea");
    assert!(land > 20 && sea > 1_000, "{land} {sea}");
}
