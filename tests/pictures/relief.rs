//! The relief that shades the land, against the elevations that it stands for.

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName, headless, parse_state};
use ocean_globe::data::tile::Projection;
use ocean_globe::data::world::World;
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::view::camera::Camera;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [48, 48];
/// Half the way over which a slope is taken from the elevations, m: half a texel of the deepest terrain tiles, about. A quadratic B-spline
/// rises at a place by what the texels, joined by straight lines, rise from half a texel before it to half a texel behind.
const STEP_M: f64 = 2_250.0;

/// Mountains in each of the map's squares, at longitudes all round the pole.
const MOUNTAINS: [&str; 6] = ["-33,-70", "46,8", "-84.9,-165", "-85.6,-80", "-86.3,-150", "-84.6,165"];

/// Slope east and north at a place of a normal along the axes of the eye.
fn slope_of(normal: DVec3, eye: &Camera, [lat, lon]: [f64; 2]) -> DVec2 {
    let up = earth::ecef_from_enu(lat, lon).transpose() * (earth::ecef_from_enu(eye.lat, eye.lon) * normal);
    DVec2::new(-up.x, -up.y) / up.z
}

#[test]
fn slopes_are_those_of_the_ground_to_the_east_and_north() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    for place in MOUNTAINS {
        // Pixels of 4 km show what the data tell, and nothing of what is made up between them.
        let state = parse_state(&format!("#view={place},235000&clouds=0&time=2026-12-21T12:00:00Z")).unwrap();
        let mut measured = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
        let (places, normals) = (measured(LayerName::Lonlat), measured(LayerName::Normal));
        let (mut products, mut drawn_power, mut true_power, mut counted) = (0.0, 0.0, 0.0, 0);
        for (place, normal) in places.chunks_exact(2).zip(normals.chunks_exact(3)) {
            let (lat, lon) = (place[1].to_radians(), place[0].to_radians());
            // Mercator's texels are a kilometre wide at the end of its square: the step is too long for them.
            if Projection::for_latitude(lat) != Projection::for_latitude(state.camera.lat) {
                continue;
            }
            // Nor do they show how land is shaped to lakes of the table.
            let lake_m = world.sample_blocking(lat, lon).unwrap().lake_distance_m;
            if lake_m.is_some_and(|distance_m| distance_m > -2.0 * STEP_M) {
                continue;
            }
            counted += 1;
            let mut elevation = |north: f64, east: f64| {
                let (lat, lon) = (lat + north / WGS84.a, lon + east / (WGS84.a * lat.cos()));
                world.sample_blocking(lat, lon).unwrap().elevation_measured_m
            };
            let rise = DVec2::new(
                elevation(0.0, STEP_M) - elevation(0.0, -STEP_M),
                elevation(STEP_M, 0.0) - elevation(-STEP_M, 0.0),
            );
            let slope = rise / (2.0 * STEP_M);
            let drawn = slope_of(DVec3::from_slice(normal), &state.camera, [lat, lon]);
            products += drawn.dot(slope);
            drawn_power += drawn.length_squared();
            true_power += slope.length_squared();
        }
        let (alike, size) = (products / (drawn_power * true_power).sqrt(), (drawn_power / true_power).sqrt());
        let steepness = (true_power / f64::from(counted)).sqrt();
        println!("{place}: slopes of {steepness:.4} are drawn {size:.3} times as steep, correlation {alike:.4}");
        assert!(steepness > 0.005, "{place}: {steepness} is no mountain");
        assert!(counted > 1_000, "{place}: only {counted} places");
        // The spline smooths across the slope as well, and polar texels are narrower than the step: some hundredths. Axes of the map taken
        // for east and north turn them by the longitude.
        assert!(alike > 0.98 && (0.95..1.1).contains(&size), "{place}: {alike}, {size}");
    }
}

/// Mountains and islands, places over which the eye stands, and its height over the ground there, metres.
const MADE: [[f64; 2]; 6] =
    [[46.52, 8.05], [-17.6, -149.5], [61.3, 7.0], [27.95, 86.8], [38.46, -28.40], [62.12, -7.1]];

#[test]
fn the_ground_that_is_drawn_is_the_one_that_is_sampled_from_any_eye() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    for [lat_deg, lon_deg] in MADE {
        let ground_m = world.sample_blocking(lat_deg.to_radians(), lon_deg.to_radians()).unwrap().elevation_m;
        // Pixels of 8 to 9 m beneath the eye: finer waves are not in a sample. The second eye stands 150 m to the side, the third lower and
        // aslant.
        for (north, over_m, tilt) in [(0.0, 480.0, 0.0), (0.0015, 480.0, 0.0), (-0.003, 350.0, 30.0)] {
            let view = format!("{},{lon_deg},{},0,{tilt}", lat_deg + north, ground_m + over_m);
            let state = parse_state(&format!("#view={view}&time=2026-06-21T12:00:00Z")).unwrap();
            let mut measured = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
            let (places, heights) = (measured(LayerName::Lonlat), measured(LayerName::Height));
            let eye = renderer.eye(&state, 0.0);
            let extent = DVec2::from(SIZE.map(f64::from));
            let (mut worst, mut off, mut sum, mut made, mut seen) = (0.0f64, Vec::new(), 0.0, 0.0f64, 0);
            for (index, (place, height)) in places.chunks_exact(2).zip(&heights).enumerate() {
                let pixel = DVec2::new((index % 48) as f64 + 0.5, (index / 48) as f64 + 0.5);
                let (lat, lon) = (place[1].to_radians(), place[0].to_radians());
                let sample = world.sample_blocking(lat, lon).unwrap();
                let distance_m = (WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: sample.elevation_m })
                    - eye.eye_ecef())
                .length();
                // Farther pixels are wider, and show less than a sample holds.
                if sample.depth_m.is_some() || distance_m > 560.0 {
                    continue;
                }
                let error = (sample.elevation_m - height).abs();
                (worst, sum, made, seen) =
                    (worst.max(error), sum + error, made.max(sample.relief_made_m.abs()), seen + 1);
                let at = Geodetic { lat, lon, height: sample.elevation_m };
                off.extend(eye.project(at, extent).map(|at| at.distance(pixel)));
            }
            off.sort_by(f64::total_cmp);
            let off = off.get(off.len() * 9 / 10).copied().unwrap_or(f64::MAX);
            let mean = sum / f64::from(seen.max(1));
            println!(
                "{view}: {seen} pixels, {made:.0} m made, off by {mean:.2} m in the mean and {worst:.2} m at most, drawn {off:.2} pixels off"
            );
            assert!(seen > 100 && made > 20.0, "{view}: {seen} pixels, {made} m made");
            // Pixels interpolate the data's slope, which turns the gullies a little: tenths of a metre in the mean.
            assert!(mean < 0.5 && worst < 3.0, "{view}: {mean}, {worst}");
            // Cells are 8 to 16 pixels wide, and gullies of less than four cells are seen as shading alone: 30 m of height, which is two
            // pixels of 8 m at the picture's edge and three aslant.
            assert!(off < 3.5, "{view}: {off} pixels");
        }
    }
}

/// The first kilometre inland, seen from the water, in tiles that hold no ground farther from the shore.
#[test]
fn islands_are_raised_in_tiles_by_the_shore_as_in_those_behind() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    let state = parse_state("#view=21.268,-157.828,15,30,84&quality=high&time=2026-07-10T20:00:00Z").unwrap();
    let mut measured = |layer| render::measure(&mut renderer, &state, [640, 360], layer).unwrap().values;
    let (places, heights) = (measured(LayerName::Lonlat), measured(LayerName::Height));
    let (mut worst, mut raised) = (0.0f64, 0);
    for (place, height) in places.chunks_exact(2).zip(&heights).filter(|(place, _)| place[0].is_finite()) {
        let sample = world.sample_blocking(place[1].to_radians(), place[0].to_radians()).unwrap();
        let inland_m = -sample.shore_distance_m.unwrap();
        if (50.0..1_000.0).contains(&inland_m) {
            worst = worst.max((sample.elevation_m - height).abs());
            raised += usize::from(sample.relief_made_m > 5.0);
        }
    }
    println!("{raised} pixels of raised ground, off by {worst:.2} m at most");
    // Pixels of 1.5 to 9 m hide the relief's waves that are narrower than some of them, a few tenths of a metre high.
    assert!(raised > 3_000 && worst < 2.0, "{raised}, {worst}");
}

/// Slopes of drowned hills as they are sampled, by places so far on to each side, metres.
const AHEAD_M: f64 = 12.0;

#[test]
fn drowned_hills_are_drawn_as_they_are_sampled() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    // Over two of Halong's islands; pixels 3 m wide.
    for place in ["20.8445,107.0915", "20.857,107.185"] {
        let state =
            parse_state(&format!("#view={place},1200,0,0&clouds=0&quality=high&time=2026-06-21T05:00:00Z")).unwrap();
        let mut measured = |layer| render::measure(&mut renderer, &state, [160, 160], layer).unwrap().values;
        let (places, heights, normals) =
            (measured(LayerName::Lonlat), measured(LayerName::Height), measured(LayerName::Normal));
        let (mut sum, mut raised, mut products, mut drawn_power, mut true_power) = (0.0, 0, 0.0, 0.0, 0.0);
        for ((place, height), normal) in places.chunks_exact(2).zip(&heights).zip(normals.chunks_exact(3)) {
            let (lat, lon) = (place[1].to_radians(), place[0].to_radians());
            let mut at = |north: f64, east: f64| {
                let (lat, lon) = (lat + north / WGS84.a, lon + east / (WGS84.a * lat.cos()));
                world.sample_blocking(lat, lon).unwrap()
            };
            let sample = at(0.0, 0.0);
            if sample.relief_made_m < 5.0 || sample.shore_distance_m.is_none_or(|inland_m| inland_m > -50.0) {
                continue;
            }
            (sum, raised) = (sum + (sample.elevation_m - height).abs(), raised + 1);
            let mut elevation = |north, east| at(north, east).elevation_m;
            let rise = DVec2::new(
                elevation(0.0, AHEAD_M) - elevation(0.0, -AHEAD_M),
                elevation(AHEAD_M, 0.0) - elevation(-AHEAD_M, 0.0),
            );
            let slope = rise / (2.0 * AHEAD_M);
            let drawn = slope_of(DVec3::from_slice(normal), &state.camera, [lat, lon]);
            products += drawn.dot(slope);
            drawn_power += drawn.length_squared();
            true_power += slope.length_squared();
        }
        let (off, alike, size) =
            (sum / f64::from(raised), products / (drawn_power * true_power).sqrt(), (drawn_power / true_power).sqrt());
        let steepness = (true_power / f64::from(raised)).sqrt();
        println!(
            "{place}: {raised} pixels, off by {off:.2} m; slopes of {steepness:.2} are drawn {size:.2} times as steep, correlation {alike:.3}"
        );
        assert!(raised > 1_000 && steepness > 0.2, "{place}: {raised} pixels, {steepness}");
        assert!(off < 1.0 && alike > 0.9 && (0.85..1.15).contains(&size), "{place}: {off} m, {alike}, {size}");
    }
}

#[test]
fn an_eye_as_low_as_it_may_be_stands_on_the_ground_that_is_drawn() {
    const SIZE: [u32; 2] = [160, 90];
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    // Slopes by Lake Geneva and in the Stubai Alps, of Tahiti, the Himalaya, the Andes and Norway, each at places 97 m apart.
    let around = |[lat, lng]: [f64; 2]| (0..4).map(move |i| [lat + 8.7e-4 * f64::from(i), lng]);
    let slopes = [[46.4, 6.6], [47.15, 11.0], [-17.65, -149.45], [28.0, 86.9], [-33.0, -70.0], [61.85, 6.87]];
    let mut below = Vec::new();
    for [lat, lng] in slopes.into_iter().flat_map(around) {
        // The ground straight below, and straight above, where there is none but of an eye under the mesh.
        let mut covered = |pitch: f64| {
            let link =
                format!("#view={lat},{lng},0,0,{pitch}&clouds=0&wind=0@0&time=2026-06-21T12:00:00Z&quality=high");
            let heights =
                render::measure(&mut renderer, &parse_state(&link).unwrap(), SIZE, LayerName::Height).unwrap();
            heights.values[45 * 160 + 80].is_finite()
        };
        if !covered(0.0) || covered(180.0) {
            below.push([lat, lng]);
        }
    }
    // Without chords over hollows 1 of them is, without the ground at the eye's foot 2.
    println!("of 24 eyes {} are below the ground: {below:?}", below.len());
    assert!(below.is_empty(), "{below:?}");
    // And along the slope in a picture so large that there is no room for all tiles: its left upper corner is sky. Those at the foot were not divided.
    let link = "#view=46.4,6.6,5,70,86&clouds=0&wind=0@0&time=2026-06-21T12:00:00Z&quality=high";
    let heights =
        render::measure(&mut renderer, &parse_state(link).unwrap(), [1280, 720], LayerName::Height).unwrap().values;
    assert!(heights[100 * 1280 + 100].is_nan() && heights[700 * 1280 + 100].is_finite());
}
