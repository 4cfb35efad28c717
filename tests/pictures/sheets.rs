//! Contact sheets: twelve places at five heights by both meshes, in `target/sheets` to look at. Every picture is whole: lit water,
//! no NaN, no black, and the same by either mesh.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Output;
use ocean_globe::scene::view::state::ViewState;
use serde_json::Value;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const VIEWS: &str = include_str!("../sheets/views.json");
const SIZE: [u32; 2] = [160, 90];

/// The state of a place at a height.
fn state(sea: &str, place: &Value, height: &Value, mesh: &str) -> ViewState {
    let link = format!(
        "#view={},{},{},{},{}&{sea}&time={}&mesh={mesh}",
        place["lat"],
        place["lng"],
        height["altitude_m"],
        height["heading"],
        height["tilt"],
        place["time"].as_str().unwrap(),
    );
    render::parse_state(&link).unwrap()
}

/// Number of pixels of ocean, and their mean luminance; refuses a picture that is not whole. Then the picture.
fn ocean(renderer: &mut Renderer, state: &ViewState, what: &str) -> (usize, f64, Vec<u8>) {
    let class = render::measure(renderer, state, SIZE, LayerName::Class).unwrap().values;
    // One drawing gives the picture and its luminance.
    let (frame, target) = render::draw(renderer, state, SIZE, Output::Picture).unwrap();
    let [picture, radiance] =
        [&target, renderer.radiance().unwrap()].map(|texture| renderer.gpu().read_texture(texture, 0, 0).unwrap());
    let exposure = f64::from(frame.uniform.exposure);
    let luminance: Vec<f64> = radiance
        .chunks_exact(16)
        .map(|texel| bytemuck::pod_read_unaligned::<[f32; 4]>(texel).map(f64::from))
        .map(|[r, g, b, _]| (0.2126 * r + 0.7152 * g + 0.0722 * b) / exposure)
        .collect();
    assert_eq!(luminance.len(), class.len());
    for (at, (luminance, class)) in luminance.iter().zip(&class).enumerate() {
        assert!(luminance.is_finite(), "{what}: {luminance} at pixel {at}");
        assert!(*luminance > 0.0 || class.is_nan(), "{what}: black at pixel {at}");
    }
    let water: Vec<_> = luminance.iter().zip(&class).filter(|(_, class)| **class == 1.0).map(|(l, _)| *l).collect();
    (water.len(), water.iter().sum::<f64>() / water.len() as f64, picture)
}

#[test]
fn every_place_at_every_height_is_whole_and_the_same_by_both_meshes() {
    let views: Value = serde_json::from_str(VIEWS).unwrap();
    let list = |name: &str| views[name].as_array().unwrap();
    let (places, heights) = (list("places"), list("heights"));
    let sea = views["sea"].as_str().unwrap();
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let [w, h] = SIZE.map(|side| side as usize);
    let sheet_size = [places.len() * w, heights.len() * h];
    let mut sheets = [(); 2].map(|()| vec![0; 4 * sheet_size[0] * sheet_size[1]]);
    let mut faults = Vec::new();
    for (column, place) in places.iter().enumerate() {
        for (row, height) in heights.iter().enumerate() {
            let what = format!("{} from {} m", place["name"], height["altitude_m"]);
            let seen = ["grid", "bisect,8,10000"].map(|mesh| {
                let state = state(sea, place, height, mesh);
                let (count, mean, picture) = ocean(&mut renderer, &state, &format!("{what} by {mesh}"));
                let sheet = &mut sheets[usize::from(mesh != "grid")];
                for (y, pixels) in picture.chunks_exact(4 * w).enumerate() {
                    let at = 4 * ((row * h + y) * sheet_size[0] + column * w);
                    sheet[at..at + 4 * w].copy_from_slice(pixels);
                }
                (count, mean)
            });
            let [(count, mean), (count_bisected, mean_bisected)] = seen;
            println!(
                "{what}: {count} and {count_bisected} pixels of ocean, luminance {mean:.5} and {mean_bisected:.5}"
            );
            // Antarctica is land.
            let ocean_wanted = if place["name"] == "south_pole" { 0 } else { 300 };
            if count < ocean_wanted {
                faults.push(format!("{what}: {count} pixels of ocean"));
            }
            // A crest on the horizon may differ by a pixel in every column. At the deck the meshes hide the backs of waves as finely
            // as they are themselves: triangles of 2 pixels show 4 % less of the bright ones than those of 6, and those 4 % less than
            // the grid. From higher up the fragments' slopes are all that is seen.
            let bound = if height["altitude_m"].as_f64() < Some(100.0) { 0.05 } else { 0.01 };
            if count.abs_diff(count_bisected) > w || (count > 0 && (mean_bisected / mean - 1.0).abs() > bound) {
                faults.push(format!("{what}: {count} pixels of {mean:.5}, {count_bisected} of {mean_bisected:.5}"));
            }
        }
    }
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("sheets");
    std::fs::create_dir_all(&folder).unwrap();
    for (mesh, sheet) in ["grid", "bisect"].iter().zip(&sheets) {
        render::write_png(&folder.join(format!("{mesh}.png")), sheet_size.map(|side| side as u32), sheet).unwrap();
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
