//! `cargo bench --bench accesses [-- FILE]`: what a pixel of the near sea reads, counted by the very shader that is drawn.

mod counting;

use counting::{MARK, Reads, counting};
use ocean_globe::cli::render::{draw, headless};
use ocean_globe::data::world::World;
use ocean_globe::gpu::Gpu;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{MIX_NEAR_M, Output};
use ocean_globe::scene::view::named::VIEWS;
use serde_json::{Value, json};

const DEFAULT_FILE: &str = "target/bench/accesses.json";
const SIZE: [u32; 2] = [640, 360];

/// Bytes of a texel, and how many of them a sample mixes: four in a picture, eight in two mip levels or in a volume.
const TEXTURES: [(&str, f64, f64); 13] = [
    ("displacements", 8.0, 8.0),
    ("slopes", 8.0, 8.0),
    ("stretches", 8.0, 8.0),
    ("perlin", 8.0, 8.0),
    ("foam_map", 16.0, 4.0),
    ("sky_radiance", 8.0, 8.0),
    ("sky_irradiance", 8.0, 4.0),
    ("sky_view", 8.0, 4.0),
    ("haze_view", 8.0, 8.0),
    ("transmittances", 8.0, 4.0),
    ("terrain_tiles", 4.0, 4.0),
    ("water_tiles", 4.0, 4.0),
    ("scene_colour", 16.0, 4.0),
];

/// The same counted by the same means in the shaders of commit 0d38c63, which stepped through the air in each pixel and looked up both tile layers on their own: samples,
/// texels, loads, bytes.
const BEFORE: [(&str, [f64; 4]); 5] = [
    ("coast", [22.91, 10.66, 11.0, 1541.0]),
    ("calm", [31.80, 16.04, 11.0, 2196.0]),
    ("breeze", [31.91, 15.97, 11.0, 2201.0]),
    ("gale", [32.52, 15.60, 11.0, 2235.0]),
    ("hurricane", [32.25, 15.94, 11.0, 2223.0]),
];

fn texture_bytes(name: &str) -> [f64; 2] {
    let known = TEXTURES.iter().find(|(known, ..)| *known == name);
    let (_, texel, mixed) = known.unwrap_or_else(|| panic!("what texels has {name}?"));
    [texel * mixed, *texel]
}

fn pixels(renderer: &Renderer) -> Vec<[f32; 4]> {
    let texture = renderer.radiance().expect("a picture");
    let bytes = renderer.gpu().read_texture(texture, 0, 0).expect("its pixels");
    bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned).collect()
}

fn main() {
    let path = std::env::args().skip(1).find(|a| !a.starts_with('-')).unwrap_or_else(|| DEFAULT_FILE.into());
    let mut gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    gpu.instrument = Some(|label, source| match label {
        "ocean" => counting(source, &texture_bytes),
        _ => source.to_owned(),
    });
    let counted = Renderer::with_radiance(gpu, World::open("www/data"), Radiance::Single);
    let mut counted = pollster::block_on(counted).expect("a renderer");
    let mut plain = headless("www/data", Radiance::Single).expect("a renderer");
    println!("What a pixel of the sea nearer than {MIX_NEAR_M} m reads, on average; bytes without caches");
    println!("{:<12}{:>10}{:>10}{:>10}{:>10}{:>10}", "view", "pixels", "samples", "texels", "loads", "bytes");
    let mut rows: Vec<Value> = Vec::new();
    for view in &VIEWS {
        let state = view.state();
        draw(&mut plain, &state, SIZE, Output::Depth).expect("distances");
        let distances = pixels(&plain);
        draw(&mut counted, &state, SIZE, Output::Picture).expect("counts");
        let near = pixels(&counted)
            .into_iter()
            .zip(distances)
            .filter(|(reads, [_, distance, ..])| reads[3] == MARK && (0.0..MIX_NEAR_M).contains(&f64::from(*distance)));
        let (mut sum, mut count) = (Reads::default(), 0);
        for (pixel, _) in near {
            sum += Reads::from_pixel(pixel);
            count += 1;
        }
        if count == 0 {
            continue;
        }
        let [samples, texels, loads, bytes] =
            [sum.samples, sum.texels, sum.loads, sum.bytes].map(|total| total / f64::from(count));
        println!("{:<12}{count:>10}{samples:>10.2}{texels:>10.2}{loads:>10.2}{bytes:>10.0}", view.id);
        let mut row = json!({
            "view": view.id, "pixels": count, "samples": samples, "texels": texels, "loads": loads, "bytes": bytes,
        });
        if let Some((_, [samples, texels, loads, bytes])) = BEFORE.iter().find(|(id, _)| *id == view.id) {
            println!("{:<22}{samples:>10.2}{texels:>10.2}{loads:>10.2}{bytes:>10.0}", "  before");
            row["before"] = json!({ "samples": samples, "texels": texels, "loads": loads, "bytes": bytes });
        }
        rows.push(row);
    }
    let path = std::path::Path::new(&path);
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).expect("a folder for the record");
    }
    std::fs::write(path, format!("{:#}\n", json!({ "size": SIZE, "views": rows }))).expect("a file for the record");
    println!("saved as {}", path.display());
}
