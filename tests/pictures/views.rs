//! Pictures measured: mask, opacity and mix follow their formulas; the named views look as they did.

use std::path::{Path, PathBuf};

use ocean_globe::cli::render::{self, LayerName, Measured};
use ocean_globe::data::world::World;
use ocean_globe::gpu::texture;
use ocean_globe::model::optics;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{MIX_FAR_M, MIX_NEAR_M, Output};
use ocean_globe::scene::view::named;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

fn measuring() -> Renderer {
    render::headless(DATA, Radiance::Single).unwrap()
}

fn measured(renderer: &mut Renderer, fragment: &str, size: [u32; 2], layer: LayerName) -> Measured {
    render::measure(renderer, &render::parse_state(fragment).unwrap(), size, layer).unwrap()
}

fn named(id: &str) -> String {
    let view = named::VIEWS.iter().find(|view| view.id == id).unwrap_or_else(|| panic!("no view {id}"));
    format!("#{}", view.fragment)
}

#[test]
fn the_mask_of_the_coast_views_is_the_water_class() {
    let (mut renderer, mut world) = (measuring(), World::open(DATA));
    let (mut land, mut sea) = (0, 0);
    // From 560 m, and from 30 km, where more land lies farther from the shore than two texels.
    for id in ["coast", "islands"] {
        let view = named(id);
        let mask = measured(&mut renderer, &view, [160, 90], LayerName::Mask);
        let lonlat = measured(&mut renderer, &view, [160, 90], LayerName::Lonlat);
        let (mut agree, mut judged) = (0, 0);
        for (pixel, alpha) in mask.values.iter().enumerate() {
            let (lon, lat) = (lonlat.values[2 * pixel], lonlat.values[2 * pixel + 1]);
            if lon.is_nan() {
                continue;
            }
            let sample = world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
            // Two texels of the deepest water level (7): 2.1 km at this latitude, so 1.1 km each.
            if sample.shore_distance_m.is_some_and(|d| d.abs() < 2_140.0) {
                continue;
            }
            judged += 1;
            *(if sample.depth_m.is_some() { &mut sea } else { &mut land }) += 1;
            agree += usize::from((*alpha > 0.0) == sample.depth_m.is_some());
        }
        println!("{id}: {agree} of {judged} pixels agree");
        assert!(judged > 1_000, "{id}: only {judged} pixels to judge");
        assert!(agree as f64 >= 0.99 * judged as f64, "{id}: {agree} of {judged}");
    }
    assert!(sea > 300 && land > 300, "the views should show both: {sea} of sea, {land} of land");
}

#[test]
fn opacity_and_mix_follow_their_formulas() {
    let mut renderer = measuring();
    let size = [64, 128];
    let coast = named("coast");
    let (depth, mask) =
        [LayerName::Depth, LayerName::Mask].map(|layer| measured(&mut renderer, &coast, size, layer)).into();
    let mut compared = 0;
    for (depth, alpha) in depth.values.iter().zip(&mask.values).filter(|(depth, _)| **depth > 0.0) {
        // f32 exp: 1e-6.
        assert!((optics::water_alpha(0.2, *depth) - alpha).abs() < 1e-5, "{depth} m: {alpha}");
        compared += 1;
    }
    assert!(compared > 500, "only {compared} pixels of water");

    let deck = "#view=35.68,-14.25,400,180,84&clouds=0&bft=5&time=2026-11-20T12:00:00Z";
    let weight = measured(&mut renderer, deck, size, LayerName::PerlinWeight);
    let lonlat = measured(&mut renderer, deck, size, LayerName::Lonlat);
    let camera = render::parse_state(deck).unwrap().camera;
    let (mut between, column) = (0, 32);
    for row in 0..128 {
        let pixel = row * 64 + column;
        if weight.values[pixel].is_nan() {
            continue;
        }
        let place = ocean_globe::model::earth::Geodetic {
            lat: lonlat.values[2 * pixel + 1].to_radians(),
            lon: lonlat.values[2 * pixel].to_radians(),
            height: 0.0,
        };
        let distance = ocean_globe::model::earth::WGS84.ecef_from_geodetic(place).distance(camera.eye_ecef());
        let want = optics::mix_weights(distance, MIX_NEAR_M, MIX_FAR_M).perlin;
        between += usize::from(want > 0.02 && want < 0.98);
        // The distance is the moved surface's, up to 2 m off in 2 km along a ray: the weight changes by 1.5/14000 per metre.
        assert!((want - weight.values[pixel]).abs() < 0.01, "at {distance} m: {} against {want}", weight.values[pixel]);
    }
    assert!(between > 5, "only {between} pixels lie in the mix");
}

#[test]
fn a_measured_layer_waits_for_no_foam_and_leaves_the_picture_its_own() {
    let mut renderer = measuring();
    let state =
        render::parse_state("#view=35,-30,12,270,80&clouds=0&bft=7&quality=low&time=2026-06-21T12:30:00Z").unwrap();
    let size = [64, 36];
    let picture = render::picture(&mut renderer, &state, size).unwrap();
    for begin_anew in [false, true] {
        let (frame, target) = render::draw(&mut renderer, &state, size, Output::Height).unwrap();
        if begin_anew {
            renderer.forget();
        }
        let gpu = renderer.gpu().clone();
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        renderer.render(&mut encoder, &frame, &texture::view(&target));
        gpu.queue.submit([encoder.finish()]);
        // The waves, the noise and their mips; each step of a replay has as many.
        let dispatches = renderer.cost().unwrap().dispatches;
        assert!(dispatches <= 12, "{dispatches} dispatches of a measured layer");
        let again = render::picture(&mut renderer, &state, size).unwrap();
        assert!(again == picture, "the picture after a measured layer is another one; begun anew: {begin_anew}");
    }
}

fn snapshot(id: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/snapshots/{id}.png"))
}

fn read_png(path: &Path) -> ([u32; 2], Vec<u8>) {
    let file = std::fs::File::open(path)
        .unwrap_or_else(|e| panic!("{}: {e}; make it with UPDATE_SNAPSHOTS=1 and look at it", path.display()));
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    ([info.width, info.height], bytes)
}

#[test]
fn the_named_views_look_as_they_did() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let size = [480, 270];
    let ids = ["globe", "ocean", "islands", "coast", "breeze", "gale"];
    let mut failures = Vec::new();
    for id in ids {
        let state = render::parse_state(&named(id)).unwrap();
        let got = render::picture(&mut renderer, &state, size).unwrap();
        if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
            render::write_png(&snapshot(id), size, &got).unwrap();
        }
        let (kept_size, want) = read_png(&snapshot(id));
        assert_eq!(kept_size, size);
        assert_eq!(want.len(), got.len());
        let differences: Vec<u32> = want.iter().zip(&got).map(|(a, b)| u32::from(a.abs_diff(*b))).collect();
        let mean = f64::from(differences.iter().sum::<u32>()) / differences.len() as f64;
        let far = differences.chunks(4).filter(|pixel| pixel.iter().any(|d| *d > 8)).count() as f64
            / (differences.len() / 4) as f64;
        println!("{id}: mean difference {mean:.3}, {:.3} % of pixels off by more than 8", far * 100.0);
        // Drivers differ in the last bits of exp and pow, which the glitter amplifies at single pixels.
        if mean > 1.0 || far > 0.005 {
            let seen = std::env::temp_dir().join(format!("ocean-globe-{id}.png"));
            render::write_png(&seen, size, &got).unwrap();
            failures.push(format!("{id}: mean {mean:.3}, {:.2} % far; see {}", far * 100.0, seen.display()));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
