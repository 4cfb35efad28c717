//! The light of a picture: a clear day's sky, the tone of the display, foam that can be taken away.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::daylight::{self, BALANCE};
use ocean_globe::model::optics;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{Frame, Output};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// On the equator in the Atlantic, the sun 40 degrees high in the west.
const AT_40_DEG: &str = "wind=7@90&time=2026-03-20T17:27:30Z&layers=-foam&water=open";
/// Share of the daylight that is the sky's, about.
const SKYLIGHT: f64 = 0.2;
const OPEN: &str = "&layers=-foam&water=open";

const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

fn luminance(rgb: [f64; 3]) -> f64 {
    rgb.iter().zip(LUMINANCE).map(|(part, share)| part * share).sum()
}

/// CIE 1931 x and y of linear sRGB.
fn chromaticity([r, g, b]: [f64; 3]) -> [f64; 2] {
    let x = 0.4124 * r + 0.3576 * g + 0.1805 * b;
    let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let z = 0.0193 * r + 0.1192 * g + 0.9505 * b;
    [x / (x + y + z), y / (x + y + z)]
}

/// Display values, 0…1, of exposed radiance by AgX, in f64: B. Wrensch's matrices and polynomial, white at 2^2.8, contrast 1.55.
pub fn displayed(exposed: [f64; 3]) -> [f64; 3] {
    const INSET: [[f64; 3]; 3] = [
        [0.842479062253094, 0.0784335999999992, 0.0792237451477643],
        [0.0423282422610123, 0.878468636469772, 0.0791661274605434],
        [0.0423756549057051, 0.0784336, 0.879142973793104],
    ];
    const OUTSET: [[f64; 3]; 3] = [
        [1.19687900512017, -0.0980208811401368, -0.0990297440797205],
        [-0.0528968517574562, 1.15190312990417, -0.0989611768448433],
        [-0.0529716355144438, -0.0980434501171241, 1.15107367264116],
    ];
    let times = |rows: [[f64; 3]; 3], v: [f64; 3]| rows.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum::<f64>());
    let curve = |x: f64| {
        let powers = [-0.00232, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5];
        powers.iter().rev().fold(0.0, |sum, factor| sum * x + factor).max(0.0).powf(1.55)
    };
    let balanced = std::array::from_fn(|part| BALANCE[part] * exposed[part]);
    let toned = times(INSET, balanced)
        .map(|part| curve(((part.max(1e-10).log2() + 12.47393) / (12.47393 + 2.8)).clamp(0.0, 1.0)));
    times(OUTSET, toned).map(|part| part.clamp(0.0, 1.0))
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

/// Mean radiance of the sea at a depression, degrees, from 15 m: of a band a tenth of that high, over five places so many degrees apart.
fn sea(renderer: &mut Renderer, depression: f64, hour: &str, apart: f64) -> [f64; 3] {
    let size = [160, 90];
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for place in 0..5 {
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
        let found = luminance(sea(&mut renderer, depression, AT_40_DEG, 0.01)) / zenith;
        println!("{depression} degrees: {found:.3} of {wanted}");
        assert!((found / wanted - 1.0).abs() < 0.15, "{depression} degrees down: {found}, not {wanted}");
    }
}

/// UTC of the day of [`AT_40_DEG`] at which the sun there is so high: it climbs and sinks by 15 degrees an hour.
fn with_sun_at(elevation: f64) -> String {
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
                let found = luminance(sea(&mut renderer, depression, &format!("wind={wind}@90&{sun}{OPEN}"), 0.2));
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
fn no_pixel_is_black_or_burnt_but_in_the_glint() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for elevation in [20.0, 40.0, 60.0] {
        for wind in [3, 7, 12] {
            // Away from the sun and across it, foam and sky with it.
            for heading in [90, 0] {
                let link = format!("#view=0,-30,15,{heading},84&clouds=0&wind={wind}@90&{}", with_sun_at(elevation));
                let state = render::parse_state(&link).unwrap();
                let values = render::measure(&mut renderer, &state, [160, 90], LayerName::Radiance).unwrap().values;
                let camera = state.camera;
                let exposure =
                    Frame::new(&state.settings, &camera, render::instant(&state), [160, 90]).uniform.exposure;
                for (pixel, rgb) in values.chunks_exact(3).enumerate() {
                    let shown = displayed(std::array::from_fn(|part| f64::from(exposure) * rgb[part]));
                    let here =
                        || format!("sun {elevation}, {wind} m/s, heading {heading}, pixel {pixel}: {rgb:?} {shown:?}");
                    assert!(rgb.iter().all(|part| part.is_finite() && *part >= 0.0), "{}", here());
                    assert!(shown.iter().all(|part| *part < 0.98) && luminance(shown) > 0.02, "{}", here());
                }
            }
        }
    }
}

/// Share of a picture towards a low sun that is all but white, were it exposed `factor` times as long as it is.
fn burnt(renderer: &mut Renderer, elevation: f64, factor: f64) -> f64 {
    let link = format!("#view=0,-30,6,270,89&clouds=0&bft=4&quality=low&{}", with_sun_at(elevation));
    let state = render::parse_state(&link).unwrap();
    let values = render::measure(renderer, &state, [160, 90], LayerName::Radiance).unwrap().values;
    let frame = Frame::new(&state.settings, &state.camera, render::instant(&state), [160, 90]);
    let exposure = factor * f64::from(frame.uniform.exposure);
    let white = |rgb: &&[f64]| displayed([exposure * rgb[0], exposure * rgb[1], exposure * rgb[2]])[1] > 250.0 / 255.0;
    values.chunks_exact(3).filter(white).count() as f64 / (160.0 * 90.0)
}

#[test]
fn a_low_sun_does_not_burn_the_sky_about_it() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for elevation in [5.0, 10.0] {
        // 2.2: as a picture with the sun behind it is exposed.
        let [share, away] = [1.0, 2.2].map(|factor| burnt(&mut renderer, elevation, factor));
        println!(
            "sun at {elevation} degrees: {share:.4} of the picture is white, {away:.4} as exposed away from the sun"
        );
        // The disc with its glow, some 10 degrees across, has a fiftieth of the picture, its path on the sea as much.
        assert!(share < 0.04 && share < 0.5 * away, "{share} {away}");
    }
}

#[test]
fn the_horizon_is_a_step_that_grows_with_the_wind() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let sky = luminance(seen(&mut renderer, "0,-30,15,0,91"));
    let found = [3, 7, 12].map(|wind| {
        let link = format!("wind={wind}@90&time=2026-03-20T17:27:30Z{OPEN}");
        luminance(sea(&mut renderer, 1.0, &link, 0.01)) / sky
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
    let dark = luminance(sea(&mut renderer, 45.0, AT_40_DEG, 0.01));
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

#[test]
fn the_display_has_the_tone_of_agx() {
    // A grey card in the light that the exposure is metered for.
    let card = 255.0 * displayed([0.18 * 2f64.powf(0.7); 3])[1];
    println!("grey card {card:.1}");
    assert!((card - 141.0).abs() < 5.0, "{card}");
    // Ever brighter, up to white.
    let ramp: Vec<f64> = (-120..=28).map(|step| displayed([2f64.powf(f64::from(step) / 10.0); 3])[0]).collect();
    assert!(ramp.windows(2).all(|pair| pair[1] > pair[0]) && ramp[0] < 0.01 && ramp[ramp.len() - 1] > 0.98);
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let size = [64, 36];
    for view in ["36.5,-9.5,15,290,86&bft=3&time=2026-06-21T19:50:00Z", "20,-40,9e6&time=2026-06-21T14:30:00Z"] {
        let state = render::parse_state(&format!("#view={view}&clouds=0&quality=low&rate=0")).unwrap();
        let measured = render::measure(&mut renderer, &state, size, LayerName::Radiance).unwrap();
        let (frame, target) = render::draw(&mut renderer, &state, size, Output::Picture).unwrap();
        let bytes = renderer.gpu().read_texture(&target, 0, 0).unwrap();
        let mut darkest = 255;
        for (pixel, (rgba, radiance)) in bytes.chunks_exact(4).zip(measured.values.chunks_exact(3)).enumerate() {
            let exposed = std::array::from_fn(|part| radiance[part] * f64::from(frame.uniform.exposure));
            for (byte, wanted) in rgba.iter().zip(displayed(exposed)) {
                // Half a step of noise, half a step of rounding, and what 32 bits lose in the curve.
                assert!((f64::from(*byte) - 255.0 * wanted).abs() < 1.1, "{view}, {pixel}: {byte} of {wanted}");
            }
            darkest = darkest.min(*rgba[..3].iter().max().unwrap());
        }
        println!("{view}: exposure {:.2}, darkest pixel {darkest}", frame.uniform.exposure);
    }
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
