//! The light of sun and sky on level ground, from noon to the end of twilight: what the tables hold, what the meter reads, what was measured.

use ocean_globe::model::daylight;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::air::Air;

/// Of a sun's zenith cosine: light of sun and sky on level ground.
const METER: &str = "#import light
@group(2) @binding(0) var<storage, read> suns: array<f32>;
@group(2) @binding(1) var<storage, read_write> lit: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> skies: array<vec4f>;
@compute @workgroup_size(64)
fn meter(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&suns) { return; }
    let light = daylight_at(suns[id.x]);
    lit[id.x] = vec4f(light.sun * max(suns[id.x], 0.0), 1.0);
    skies[id.x] = vec4f(light.sky, 1.0);
}";

/// Irradiances of level ground by sun and sky, as luminance, for sines of the sun's elevation.
fn daylight_of_the_tables(settings: &Settings, suns: &[f32]) -> Vec<[f64; 2]> {
    let luminance = |[r, g, b]: [f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    colours_of_the_tables(settings, suns).into_iter().map(|parts| parts.map(luminance)).collect()
}

/// As red, green and blue.
fn colours_of_the_tables(settings: &Settings, suns: &[f32]) -> Vec<[[f64; 3]; 2]> {
    // At noon: by night the unit of light would be the moon's.
    let frame = Frame::new(settings, &Camera::from_degrees(0.0, 0.0, 10.0, 0.0, 0.0), 43_200.0, [64, 64]);
    let [lit, skies] = Air::new(METER, "meter").run(&frame, suns);
    let rgb = |[r, g, b, _]: [f32; 4]| [r, g, b].map(f64::from);
    lit.into_iter().zip(skies).map(|(sun, sky)| [rgb(sun), rgb(sky)]).collect()
}

#[test]
fn the_light_of_day_is_balanced_to_white() {
    let suns = [30.0f32, 45.0, 60.0].map(|deg| deg.to_radians().sin());
    let shown = colours_of_the_tables(&Settings::default(), &suns).into_iter().map(|[sun, sky]| {
        let balanced: [f64; 3] = std::array::from_fn(|part| daylight::BALANCE[part] * (sun[part] + sky[part]));
        balanced.map(|part| part / balanced[1])
    });
    let [low, middle, high]: [[f64; 3]; 3] = shown.collect::<Vec<_>>().try_into().unwrap();
    println!("at 30, 45 and 60 degrees {low:.3?}, {middle:.3?}, {high:.3?}");
    // Factors have three figures.
    assert!((middle[0] - 1.0).abs() < 0.002 && (middle[2] - 1.0).abs() < 0.002, "{middle:?}");
    // A lower sun is warmer.
    assert!(low[0] > high[0] && low[2] < high[2], "{low:?}, {high:?}");
    let [r, g, b] = daylight::BALANCE;
    assert!((0.2126 * r + 0.7152 * g + 0.0722 * b - 1.0).abs() < 0.001);
}

#[test]
fn the_meter_reads_what_the_tables_hold() {
    let suns: Vec<f32> =
        [-12.0f32, -6.0, -3.0, 0.0, 2.0, 5.0, 10.0, 20.0, 40.0, 60.0, 90.0].map(|deg| deg.to_radians().sin()).into();
    let found = daylight_of_the_tables(&Settings::default(), &suns);
    for (mu, [sun, sky]) in suns.iter().zip(&found) {
        let metered = daylight::irradiance(f64::from(*mu));
        println!(
            "sun at {:.1} deg: {sun:.4} + {sky:.4} = {:.4}, metered {metered:.4}",
            mu.asin().to_degrees(),
            sun + sky
        );
        // By day a sixth of a stop; then half of one, and the night has its own light.
        if *mu > 0.17 {
            assert!((metered / (sun + sky) - 1.0).abs() < 0.12, "{mu}: {metered} of {}", sun + sky);
        } else if *mu > -0.06 {
            let light = sun + sky;
            assert!((metered.hypot(0.03) / light.hypot(0.03) - 1.0).abs() < 0.4, "{mu}: {metered} of {light}");
        }
    }
    // With the sun at 40 degrees the clear sky over an ocean gives 0.18 of the light (a spectral model's 0.15 to 0.21).
    let [sun, sky] = found[8];
    assert!((sky / (sun + sky) - 0.18).abs() < 0.03, "{}", sky / (sun + sky));
    // Haze takes light from the beam and gives most of it to the sky.
    let [hazy_sun, hazy_sky] = daylight_of_the_tables(&Settings { haze: 0.2, ..Settings::default() }, &suns)[8];
    println!("in haze {hazy_sun:.4} + {hazy_sky:.4}");
    assert!((hazy_sun / sun / (-0.12f64 / 0.643).exp() - 1.0).abs() < 0.02, "{hazy_sun} of {sun}");
    assert!(hazy_sky > 1.4 * sky && hazy_sun + hazy_sky < sun + sky, "{hazy_sky} of {sky}");
}

/// Horizontal illuminance under a clear sky, lux, by the sun's elevation in degrees: P. Janiczek and J. DeYoung 1987, "Computer programs for
/// sun and moon illuminance", US Naval Observatory Circular 171.
fn naval_observatory_lux(elevation_deg: f64) -> f64 {
    let fits = [
        (20.0, [3.74, 3.97, -4.07, 1.47]),
        (5.0, [3.05, 13.28, -45.98, 64.33]),
        (-0.8, [2.88, 22.26, -207.64, 1034.30]),
        (-5.0, [2.88, 21.81, -258.11, -858.36]),
        (-12.0, [2.70, 12.17, -431.69, -1899.83]),
    ];
    let (_, factors) = fits.into_iter().find(|(from, _)| elevation_deg >= *from).expect("no deeper twilight");
    let x = elevation_deg / 90.0;
    10f64.powf(factors.iter().rev().fold(0.0, |sum, factor| sum * x + factor))
}

#[test]
fn day_fades_into_twilight_as_it_is_measured() {
    let elevations = [40.0, 60.0, 20.0, 10.0, 5.0, 2.0, 0.0, -2.0, -4.0, -6.0, -18.0];
    let suns = elevations.map(|deg: f64| deg.to_radians().sin() as f32);
    let found: Vec<f64> =
        daylight_of_the_tables(&Settings::default(), &suns).into_iter().map(|[sun, sky]| sun + sky).collect();
    // Pictures have a light of the night of their own, which is there by day, too.
    let night = found[10];
    for (deg, light) in elevations.iter().zip(&found).skip(1).take(9) {
        let ours = (light - night) / (found[0] - night);
        let measured = naval_observatory_lux(*deg) / naval_observatory_lux(40.0);
        println!(
            "sun at {deg} degrees: {ours:.6} of the light at 40, measured {measured:.6}, {:.2} of it",
            ours / measured
        );
        // Clear days differ by a quarter. At the end of twilight most light has been scattered more than once, and the tables take it to come
        // from everywhere alike, not from a bright arch: another fifth.
        let most = if *deg < -5.0 { 1.5 } else { 1.25 };
        assert!((1.0 / most..most).contains(&(ours / measured)), "{deg} degrees: {ours}, measured {measured}");
    }
}
