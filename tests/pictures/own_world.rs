//! A world of one's own, baked of an island's elevations (netCDF-4) and its shore (GeoJSON), as it is drawn.

use std::fs;

use clap::Parser;
use glam::DVec2;
use ocean_globe::cli::bake::{BakeArgs, bake};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::Radiance;

/// The island's middle, latitude and longitude, its radius, degrees of latitude, and its height, metres: a cone.
const MIDDLE: [f64; 2] = [10.3, -20.2];
const RADIUS_DEG: f64 = 0.08;
const HEIGHT_M: f64 = 400.0;
const SIZE: [u32; 2] = [128, 96];

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    bake: BakeArgs,
}

#[test]
fn an_island_of_ones_own_is_drawn_where_it_was_put() {
    let folder = std::env::temp_dir().join(format!("ocean-globe-own-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let narrow = MIDDLE[0].to_radians().cos();
    let points: Vec<[f64; 2]> = (0..=120)
        .map(|i| (std::f64::consts::TAU * f64::from(i % 120) / 120.0).sin_cos())
        .map(|(sin, cos)| [MIDDLE[1] + RADIUS_DEG * cos / narrow, MIDDLE[0] + RADIUS_DEG * sin])
        .collect();
    let coast = folder.join("coast.geojson");
    fs::write(&coast, serde_json::json!({ "type": "Polygon", "coordinates": [points] }).to_string()).unwrap();
    let bed = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/oracles/bed_nc4.nc");
    let (coast, data) = (coast.to_str().unwrap(), folder.to_str().unwrap());
    let line = Line::try_parse_from(["bake", "--bed", bed, "--coast", coast, "-o", data]).unwrap();
    bake(&line.bake).unwrap();
    let mut renderer = render::headless(data, Radiance::Single).unwrap();
    let state = render::parse_state("#view=10.3,-20.2,40000,0,0&clouds=0&time=2026-11-20T12:00:00Z").unwrap();
    let mut layer = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
    let [places, classes, heights] = [LayerName::Lonlat, LayerName::Class, LayerName::Height].map(&mut layer);
    let _ = fs::remove_dir_all(&folder);
    let (mut land, mut wrong, mut worst_m) = (0, 0, 0.0f64);
    for (pixel, place) in places.chunks_exact(2).enumerate() {
        let out = DVec2::new((place[0] - MIDDLE[1]) * narrow, place[1] - MIDDLE[0]).length() / RADIUS_DEG;
        land += usize::from(classes[pixel] == 0.0);
        wrong += usize::from((out < 1.0) != (classes[pixel] == 0.0));
        // Inside of the tip, which nodes of 1.4 km and the mesh's cells cut off.
        if (0.3..0.9).contains(&out) {
            worst_m = worst_m.max((heights[pixel] - HEIGHT_M * (1.0 - out)).abs());
        }
    }
    println!("{land} pixels of land, {wrong} on the wrong side, heights within {worst_m:.1} m");
    // Pixels are 345 m wide: a circle of 163 of them, with the coast known to 50 m and bent by 40 m, has a third of these on the other side.
    assert!((1_900..2_200).contains(&land) && wrong < 60, "{land} {wrong}");
    // A sixteenth of 400 m at most by the archive's steps, and a slope of 1 in 22 over half a pixel.
    assert!(worst_m < 25.0, "{worst_m} m");
}
