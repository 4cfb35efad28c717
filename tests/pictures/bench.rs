//! `bench`: what its record says of a frame is what the frame is made of.

use std::path::Path;
use std::process::Command;

use ocean_globe::cli::render::{draw, headless, parse_state};
use ocean_globe::gpu::texture;
use ocean_globe::pass::ocean::grid_cells;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{Output, cell_pixels};
use ocean_globe::scene::sea::shores::SLOTS;
use ocean_globe::scene::settings::Quality;
use serde_json::Value;

/// The record of a view, measured once in 96x64.
fn record(name: &str, view: &str) -> Value {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let output = Command::new(env!("CARGO_BIN_EXE_ocean-globe"))
        .args(["bench", "--frames", "1", "--size", "96x64", "--data", data, "--state", view, "-o"])
        .arg(&path)
        .output()
        .expect("a program");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let record = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    println!("{}{record:#}", String::from_utf8_lossy(&output.stdout));
    record
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {value}"))
}

#[test]
fn the_record_of_a_height_is_that_of_its_frames() {
    let view = "#view=35.68,-14.25,560,262,75&clouds=0&bft=8&time=2026-11-20T12:00:00Z&quality=low&mesh=bisect,12,4000";
    let record = record("bench.json", view);
    let [view, grid, bisect] = [&record["views"][0], &record["heights"][0], &record["heights"][1]];
    assert_eq!((&grid["mesh"], &bisect["mesh"]), (&"grid".into(), &"bisect".into()));
    assert_eq!(number(view, "samples"), 128.0);

    // A vertex at each corner of the 24 by 16 cells that four pixels make.
    assert_eq!(number(grid, "vertices"), 25.0 * 17.0);
    assert_eq!(number(grid, "triangles"), 2.0 * 24.0 * 16.0);
    // The first table draws the mesh that the view asks for; it is at rest there, and the second has come a little farther.
    let [drawn, at_rest] = [number(bisect, "triangles"), number(view, "triangles")];
    assert_eq!(number(bisect, "vertices"), 3.0 * drawn);
    assert!(at_rest > 300.0 && at_rest <= 4000.0, "{at_rest}");
    assert!((drawn / at_rest - 1.0).abs() < 0.1, "{drawn} triangles, {at_rest} at rest");
    // Far from any shore the sea hides its bed, but for two tiles on the horizon so wide that they reach to a coast, whose mountains
    // may rise two kilometres over the data; otherwise there were dozens. Each is a grid of 16 cells a side and one more all around, most
    // of which is sea.
    let tiles = number(view, "map_tiles");
    assert!(tiles <= 2.0, "{tiles} map tiles");
    let [land, whole] = [number(view, "land_triangles"), 2.0 * 18.0 * 18.0 * tiles];
    assert!(land <= 0.5 * whole && (land > 0.0) == (tiles > 0.0), "{land} triangles of {whole}");

    // Rows and columns; five levels below 128 samples, four in a dispatch, of three textures; the noise, six levels below its 256;
    // a step of the foam. Then two updates of six, and the two tables of the air that an eye sees which has moved.
    let waves = 2.0 + 2.0 * 3.0 + (1.0 + 2.0) + 1.0;
    assert_eq!(number(grid, "dispatches"), waves);
    assert_eq!(number(bisect, "dispatches"), waves + 12.0 + 2.0);
    for height in [grid, bisect] {
        assert!(number(height, "frame_ms") > 0.0);
        assert!((number(height, "altitude_m") - 560.0).abs() < 1.0);
        for share in ["tessellation", "noise"] {
            assert!(number(height, share) > -1.0);
        }
    }
    assert!(grid["updates"].is_null() && number(bisect, "updates") > -1.0);

    assert_eq!(record["shores"], Value::Array(Vec::new()), "no shore is near");
    // What low quality, noon and a gale have of the effects, and what they do not.
    let shares = &record["effects"][0]["shares"];
    for has in ["sky", "foam", "spray"] {
        assert!((-20.0..1.0).contains(&number(shares, has)), "{has}: {shares}");
    }
    for lacks in ["stars", "lights", "fine", "edges"] {
        assert!(shares[lacks].is_null(), "{lacks}: {shares}");
    }
}

#[test]
fn the_record_of_a_shore_is_that_of_its_windows() {
    let record = record(
        "bench-shore.json",
        "#view=52.372,4.52,30,120,75&clouds=0&wind=8@300&time=2026-06-21T11:00:00Z&quality=medium&mesh=grid",
    );
    let shore = &record["shores"][0];
    let windows = number(shore, "windows");
    assert!((2.0..=SLOTS as f64).contains(&windows), "{windows} windows");
    // 128 by 128 nodes of eight trains of eight bytes are kept of each; the device has room for all that may come, and a table.
    let window = f64::from(128 * 128 * 8 * 8);
    assert_eq!(number(shore, "kept_bytes"), windows * window);
    assert_eq!(number(shore, "gpu_bytes"), SLOTS as f64 * window + 1024.0);
    assert_eq!(number(shore, "dispatches"), 0.0);
    // Trains are a part of a frame, and what they are made of takes the processor some time.
    assert!((-1.0..0.9).contains(&number(shore, "share")), "{shore}");
    for of in ["frame_ms", "without_ms", "window_ms", "node_ms", "tile_ms"] {
        assert!(number(shore, of) > 0.0, "{of}: {shore}");
    }
    assert!(number(shore, "node_ms") < number(shore, "window_ms"), "{shore}");
}

/// Weight of the noise in each pixel, and the frame's dispatches.
fn noise_of(renderer: &Renderer) -> (Vec<f32>, usize) {
    let texels = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let weights = texels.chunks_exact(16).map(|texel| bytemuck::pod_read_unaligned::<[f32; 4]>(texel)[0]);
    (weights.collect(), renderer.cost().unwrap().dispatches)
}

#[test]
fn a_frame_without_noise_neither_shows_nor_makes_it() {
    let mut renderer = headless("www/data", Radiance::Single).unwrap();
    let state = parse_state("#view=35.68,-14.25,30000&clouds=0&bft=8&time=2026-11-20T12:00:00Z&quality=low").unwrap();
    let (frame, target) = draw(&mut renderer, &state, [32, 32], Output::PerlinWeight).unwrap();
    let (weights, dispatches) = noise_of(&renderer);
    assert!(weights.iter().all(|weight| *weight == 1.0), "beyond 16 km the noise is alone");
    let mut encoder = renderer.gpu().device.create_command_encoder(&Default::default());
    renderer.render(&mut encoder, &frame.without_noise(), &texture::view(&target));
    renderer.gpu().queue.submit([encoder.finish()]);
    let (weights, fewer) = noise_of(&renderer);
    assert!(weights.iter().all(|weight| *weight == 0.0));
    // First two tables each of the air and of skylight, and the noise, which is all that is seen of the sea; then the waves in its place.
    // A measured layer shows no air: it needs no tables of what this eye sees of it.
    assert_eq!((dispatches, fewer), (2 + 2 + 3, 2 + 2 * 3));
}

#[test]
fn the_low_quality_has_a_quarter_of_the_seas_triangles() {
    let mut renderer = headless("www/data", Radiance::Single).unwrap();
    let mut cost = |view: &str, size: [u32; 2], quality: &str| {
        let link = format!("#view={view}&clouds=0&time=2026-11-20T15:00:00Z&quality={quality}");
        // A measured layer: it needs no foam.
        draw(&mut renderer, &parse_state(&link).unwrap(), size, Output::Class).unwrap();
        renderer.cost().unwrap()
    };
    let [low, usual] = ["low", "medium"].map(|quality| cost("28.8545,-13.792,560,253,71", [640, 128], quality));
    assert_eq!(4 * low.triangles, usual.triangles);
    assert!(low.land_triangles < usual.land_triangles, "{} of {}", low.land_triangles, usual.land_triangles);
    // From so far that neither has a height which shows, both have as many: with the Himalaya in view, without which one pass draws the globe.
    let [low, usual] = ["low", "medium"].map(|quality| cost("20,86,3000000,180,18", [640, 360], quality));
    assert!(low.triangles > 0 && low.land_triangles > 0);
    assert_eq!((low.triangles, low.land_triangles), (usual.triangles, usual.land_triangles));
}

#[test]
fn the_extreme_quality_has_more_than_a_million_triangles_in_full_hd() {
    let [columns, rows] = grid_cells([1920, 1080], cell_pixels(Quality::Extreme, [1920, 1080]));
    assert!(2 * columns * rows > 1_000_000, "{columns} by {rows}");
    // What a picture of any size asks for stays within WebGPU's smallest buffer, 256 MiB, at 24 bytes of indices a cell.
    let [columns, rows] = grid_cells([8192, 8192], cell_pixels(Quality::Extreme, [8192, 8192]));
    assert!(24 * columns * rows <= 256 << 20, "{columns} by {rows}");
}
