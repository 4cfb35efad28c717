//! The world is there wherever the eye is: tiles, land, ground under the eye, and an end to loading.

use std::time::{Duration, Instant};

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::streaming::Streaming;
use ocean_globe::data::tile::MapPoint;
use ocean_globe::model::optics;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{Frame, Output};
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;
use ocean_globe::scene::view::map_tiles::{RELIEF_M, drawn_tiles};
use ocean_globe::scene::view::state::ViewState;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

#[test]
fn an_eye_that_looks_down_sees_the_tile_below_it() {
    for (lat, lon) in (-18..=18).flat_map(|i| (-36..36).map(move |j| (5.0 * f64::from(i), 5.0 * f64::from(j)))) {
        for altitude in [1.0, 2_000.0, 300_000.0, 2e7] {
            let camera = Camera::from_degrees(lat, lon, altitude, 0.0, 0.0);
            let foot = MapPoint::from_lat_lon(camera.lat, camera.lon);
            let tiles = drawn_tiles(&camera, [640, 360], &Streaming::default(), None, 1.0, None);
            assert!(
                tiles.iter().any(|tile| foot.tile(tile.id.z) == tile.id),
                "{lat},{lon} from {altitude} m: {} tiles",
                tiles.len()
            );
        }
    }
}

#[test]
fn land_is_land_on_every_side_of_the_globe() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let size = [9, 9];
    for (name, place, class) in [
        ("Fuji", "35.36,138.73,8000", 0.0),
        ("Denver", "39.7,-104.9,5000", 0.0),
        ("Sydney's hinterland", "-33.8,150.3,5000", 0.0),
        ("Hawaii", "19.6,-155.5,9000", 0.0),
        ("South Pole", "-90,0,5000", 0.0),
        ("Lake Superior", "47.7,-87.5,2000", 2.0),
        ("Tasman Sea", "-40,160,2000", 1.0),
        ("North Pole", "90,0,2000", 1.0),
    ] {
        let state = render::parse_state(&format!("#view={place}&clouds=0&time=2026-06-21T12:00:00Z")).unwrap();
        let seen = render::measure(&mut renderer, &state, size, LayerName::Class).unwrap();
        assert!(seen.values.iter().all(|value| *value == class), "{name}: {:?}", seen.values);
    }
}

/// Far fjords: triangles of the ground are coarser there than the map of their shores.
#[test]
fn no_deep_sea_bed_lies_bare_where_the_ground_is_coarser_than_its_shore() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let view = "view=61.2,6.5,3000,250,75&clouds=0&bft=1&time=2026-06-21T21:00:00Z";
    let state = render::parse_state(view).unwrap();
    let [classes, heights, opacities] = [LayerName::Class, LayerName::Height, LayerName::Mask]
        .map(|layer| render::measure(&mut renderer, &state, [1280, 720], layer).unwrap().values);
    let sea: Vec<[f64; 2]> = classes
        .iter()
        .zip(heights.into_iter().zip(opacities))
        .filter(|(class, _)| **class == 1.0)
        .map(|(_, (height, opacity))| [height, opacity])
        .collect();
    assert!(sea.len() > 10_000, "{} pixels of sea", sea.len());
    // 20 m of water hide their bed, and no trough is as deep.
    let deep = sea.iter().filter(|[height, _]| *height < -20.0).count();
    let shallow = sea.iter().filter(|[height, opacity]| *height >= -20.0 && *opacity == 0.0).count();
    println!("of {} pixels of sea {deep} show a deep bed, {shallow} a shallow one without water", sea.len());
    assert_eq!(deep, 0, "pixels of bare bed, of {}", sea.len());
    // Water of no depth, on the very shore, has no opacity: a few pixels in ten thousand, where coarse triangles bared 138.
    assert!(shallow <= 12, "{shallow} pixels of a shallow bed without water, of {}", sea.len());
}

/// Where a picture's globe begins depends on the summits in view.
#[test]
fn the_globe_of_a_picture_begins_without_a_change() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let size = [320, 180];
    for place in ["30,85", "47,10", "-80,40", "82,-40", "-20,-68", "10,-30"] {
        let mut state =
            render::parse_state(&format!("#view={place},1e6,20,15&clouds=0&time=2026-06-21T09:00:00Z")).unwrap();
        let mut ends = [0.8e6, 3e6];
        while ends[1] / ends[0] > 1.00002 {
            state.camera.altitude_m = 0.5 * (ends[0] + ends[1]);
            let is_globe = renderer.frame(&state.settings, &state.camera, 0.0, size).is_globe();
            ends[usize::from(is_globe)] = state.camera.altitude_m;
        }
        let [near, far] = ends.map(|altitude_m| {
            state.camera.altitude_m = altitude_m;
            render::measure(&mut renderer, &state, size, LayerName::Luminance).unwrap().values
        });
        let change = near.iter().zip(&far).map(|(a, b)| (a - b).abs()).sum::<f64>() / far.iter().sum::<f64>();
        println!("{place}: from {:.0} m on the globe, whose luminance is {change:.5} off", ends[1]);
        assert!(change < 2e-3, "{place}: {change}");
    }
}

/// From space neither tiles nor the sea's mesh are drawn, but the globe in one pass: nothing changes where it begins.
#[test]
fn the_globe_from_space_is_that_of_the_tiles_and_the_sea() {
    use LayerName::{Depth, Height, Lonlat, Luminance, Mask, Normal};
    const LAYERS: [LayerName; 6] = [Luminance, Depth, Mask, Height, Normal, Lonlat];
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let size = [320, 180];
    for place in ["30,85", "47,10", "-80,40", "82,-40", "-20,-68"] {
        let mut state =
            render::parse_state(&format!("#view={place},1e6,20,15&clouds=0&time=2026-06-21T09:00:00Z")).unwrap();
        let pixel_angle = f64::from(renderer.frame(&state.settings, &state.camera, 0.0, size).uniform.pixel_angle);
        let seen = [0.99999, 1.00001].map(|side| {
            state.camera.altitude_m = side * RELIEF_M / pixel_angle;
            let mut measured = |layer| render::measure(&mut renderer, &state, size, layer).unwrap().values;
            let layers = LAYERS.map(&mut measured);
            (measured(LayerName::Class), layers, renderer.cost().unwrap())
        });
        let [(near, near_layers, of_tiles), (far, far_layers, from_space)] = seen;
        assert!(of_tiles.map_tiles > 0 && from_space.map_tiles == 0, "{place}: {of_tiles:?} {from_space:?}");
        let land = near.iter().filter(|class| **class == 0.0).count();
        let other = near.iter().zip(&far).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
        println!("{place}: {land} pixels of land, {other} of another class");
        assert!(land > 1000, "{place}: {land} pixels of land");
        // What lies between them moves the picture's edge by a five-hundredth of a pixel; a shore turns a few over.
        assert!(other <= 14, "{place}: {other} pixels");
        for (layer, (near, far)) in LAYERS.iter().zip(near_layers.iter().zip(&far_layers)) {
            let both = || near.iter().zip(far).filter(|(a, b)| a.is_finite() && b.is_finite());
            let change = both().map(|(a, b)| (a - b).abs()).sum::<f64>() / both().map(|(_, b)| b.abs()).sum::<f64>();
            println!("{place}: {layer:?} changes by {change:.5}");
            assert!(change < 2e-3, "{place}: {layer:?} changes by {change}");
        }
    }
}

#[test]
fn the_eye_stays_over_the_ground_and_the_waves() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut eye = |fragment: &str| {
        let state = render::parse_state(fragment).unwrap();
        // A measured layer: it needs no foam.
        render::draw(&mut renderer, &state, [8, 8], Output::Class).unwrap();
        renderer.eye(&state, render::instant(&state)).altitude_m
    };
    let pole = eye("#view=-89.99,0,500,0,80&clouds=0");
    assert!((2_760.0..2_870.0).contains(&pole), "the South Pole stands 2,810 m high: {pole}");
    // Somewhere within ten minutes a crest of a hurricane passes higher than 1 m; the eye goes up with it, never down.
    let heights: Vec<f64> = (0..10)
        .map(|minute| eye(&format!("#view=0,-20,1,90,85&clouds=0&bft=12&time=2026-03-20T12:0{minute}:00Z")))
        .collect();
    assert!(heights.iter().all(|h| *h >= 1.0) && heights.iter().any(|h| *h > 2.0), "{heights:?}");
    assert_eq!(eye("#view=0,-20,-10,90,85&clouds=0&bft=3&time=2026-03-20T12:00:00Z"), -10.0);
    let bed = eye("#view=0,-20,-11000,90,85&clouds=0&bft=3&time=2026-03-20T12:00:00Z");
    assert!((-8_000.0..-2_000.0).contains(&bed), "{bed}");
}

/// By the shore of the Dead Sea, 400 m under the ocean's level: no water is there to look through.
#[test]
fn an_eye_in_a_dry_depression_is_in_the_air() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut light = |altitude_m: f64, tilt_deg: f64| {
        let state = render::parse_state(&format!(
            "#view=31.5,35.45,{altitude_m},0,{tilt_deg}&clouds=0&haze=0&time=2026-06-21T08:00:00Z"
        ))
        .unwrap();
        // The picture itself, as an eye at the water has two: colour by colour.
        let seen = render::picture(&mut renderer, &state, [64, 36]).unwrap();
        let mean = |channel: usize| {
            seen.iter().skip(channel).step_by(4).map(|byte| f64::from(*byte)).sum::<f64>() / (64.0 * 36.0)
        };
        [mean(0), mean(1), mean(2)]
    };
    // Water and sky. 300 m under the water there is neither red nor much else; what is left is the light of the air, which below the ocean's level is
    // taken to be up to a quarter brighter than it is above.
    for tilt_deg in [0.0, 130.0] {
        let (below, above) = (light(-300.0, tilt_deg), light(5.0, tilt_deg));
        println!("tilted by {tilt_deg}: {below:.1?} below the ocean's level, {above:.1?} above it");
        let alike = |channel: usize| (below[channel] - above[channel]).abs() < 0.3 * above[channel].max(20.0);
        assert!((0..3).all(alike), "tilted by {tilt_deg}: {below:?}, {above:?}");
    }
}

#[test]
fn a_view_that_wants_more_tiles_than_there_is_room_for_comes_to_rest() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let camera = Camera::from_degrees(20.0, -30.0, 2e7, 0.0, 0.0);
    let frame = Frame::new(&Settings::default(), &camera, 0.0, [8192, 8192]);
    let start = Instant::now();
    while !renderer.load(&frame) {
        assert!(start.elapsed() < Duration::from_secs(60), "still loading after a minute");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn a_picture_without_a_world_is_refused() {
    let folder = std::env::temp_dir().join(format!("ocean-globe-no-world-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut renderer = render::headless(folder.to_str().unwrap(), Radiance::Half).unwrap();
    let state = render::parse_state("#view=20,-30,2e7&clouds=0&time=2026-06-21T12:00:00Z").unwrap();
    let error = render::picture(&mut renderer, &state, [16, 9]).unwrap_err().to_string();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(error.contains("terrain.pmtiles"), "{error}");
}

#[test]
fn an_eye_that_rides_through_a_trough_sees_the_sky() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // The lowest water of a hundred places, 11 m apart; the eye 2 m above it, then 3 m deep.
    let view = |lon: f64, altitude_m: f64| {
        let link = format!("#view=35.6812,{lon},{altitude_m},235,84&clouds=0&ride=1&bft=12&time=2026-11-20T12:00:00Z");
        render::parse_state(&link).unwrap()
    };
    let mut seas = Seas::default();
    let mut height = |state: &ViewState| seas.surface_height(&state.settings, &state.camera, render::instant(state));
    let lons = (0..100).map(|i| -14.25 + 1.2e-4 * f64::from(i));
    let trough = lons.min_by(|a, b| height(&view(*a, 0.0)).total_cmp(&height(&view(*b, 0.0)))).unwrap();
    for (altitude_m, above) in [(2.0, true), (-3.0, false)] {
        let state = view(trough, altitude_m);
        let eye = renderer.eye(&state, render::instant(&state));
        assert!(eye.altitude_m < -1.0, "no trough: {}", eye.altitude_m);
        let seen = render::measure(&mut renderer, &state, [16, 9], LayerName::Class).unwrap();
        let sky = seen.values.iter().take(16).filter(|class| class.is_nan()).count();
        assert_eq!(sky == 16, above, "{altitude_m} m: {:?}", &seen.values[..16]);
    }
}

/// Mean luminance that foam adds where the water is less than 3 m deep and where it is deeper, straight down on a shore of Lanzarote.
fn whitened(renderer: &mut Renderer, wind: &str) -> [f64; 2] {
    let mut layer = |name, layers: &str| {
        let link =
            format!("#view=28.8545,-13.792,4000&wind={wind}&clouds=0&quality=medium&time=2026-11-20T13:00:00Z{layers}");
        render::measure(renderer, &render::parse_state(&link).unwrap(), [160, 90], name).unwrap().values
    };
    let [with, without] = ["", "&layers=-foam"].map(|layers| layer(LayerName::Luminance, layers));
    let opacities = layer(LayerName::Mask, "");
    let mut found = [(0.0, 0.0); 2];
    for (opacity, added) in opacities.iter().zip(with.iter().zip(without).map(|(with, without)| with - without)) {
        // 0 is land.
        let deep = usize::from(*opacity > optics::water_alpha(0.2, 3.0));
        if *opacity > 0.0 {
            found[deep].0 += added;
            found[deep].1 += 1.0;
        }
    }
    assert!(found[0].1 > 100.0 && found[1].1 > 1000.0, "{found:?}");
    found.map(|(sum, count)| sum / count)
}

#[test]
fn surf_whitens_the_shore_that_waves_run_up_to() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let [onshore, offshore] = ["12@170", "12@350"].map(|wind| whitened(&mut renderer, wind));
    println!(
        "in shallow and in deep water foam adds {onshore:.4?} with the wind from the sea, {offshore:.4?} from the land"
    );
    // Waves of 2.6 m break in 4 m: half of the water is white or more. What comes round into the lee is 6 % as high and breaks in decimetres.
    assert!(onshore[0] > 4.0 * onshore[1] && onshore[0] > 4.0 * offshore[0], "{onshore:?} {offshore:?}");
}
