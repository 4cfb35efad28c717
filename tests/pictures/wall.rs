//! Waves behind a wall in deep water, as they are drawn: against the diffraction of waves at the edge of a half plane.

use std::f64::consts::TAU;
use std::fs;

use ocean_globe::cli::bake::{BakeArgs, bake};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::sea::Seas;

use crate::small_world::{self, Folder, nothing};

/// The wall's eastern end, degrees; it runs 300 km to the west.
const TIP: [f64; 2] = [0.0, -60.0];
/// Two texels of the tiles that lees are found from.
const WIDE_DEG: f64 = 0.011;
const DEGREE_M: f64 = 111_319.491;

fn headless(folder: &Folder) -> Renderer {
    render::headless(folder.path().to_str().unwrap(), Radiance::Single).unwrap()
}

#[test]
fn drawn_waves_behind_a_wall_are_as_high_as_diffraction_theory_has_them() {
    let open = small_world::baked("no-wall");
    let walled = small_world::baked("wall");
    let [lat, lon] = TIP;
    let (west, north) = (lon - 3.0, lat + WIDE_DEG);
    let ring = [[lon, lat], [lon, north], [west, north], [west, lat], [lon, lat]];
    let coast = walled.path().join("wall.geojson");
    fs::write(&coast, serde_json::json!({ "type": "Polygon", "coordinates": [ring] }).to_string()).unwrap();
    bake(&BakeArgs { coast: Some(coast), coast_zoom: 8, ..nothing(walled.path()) }).unwrap();
    let [mut open, mut walled] = [open, walled].map(|folder| (headless(&folder), folder));
    // Wind from the north on to the wall, waves so long that nodes of 1.2 km tell their lee; a steep bed, so that none feels it here.
    const SEA: &str = "wind=35@0&fetch=5000&clouds=0&surf=1,0.3&time=2026-06-21T12:00:00Z";
    let settings = render::parse_state(&format!("#{SEA}")).unwrap().settings;
    let length_m = TAU / Seas::default().tables(&settings).sea.spectrum().wind.peak_wavenumber();
    // Ten lengths behind the end, at angles from the edge of the shadow, positive in it: H over H₀ by Sommerfeld's solution, its energy summed
    // over the directions of a wind sea (s = 10).
    for (angle_deg, expected) in [(-40.0f64, 0.97), (-20.0, 0.88), (0.0, 0.70), (20.0, 0.46), (40.0, 0.25)] {
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        let [east, north] = [-sin, -cos].map(|way| 10.0 * length_m * way / DEGREE_M);
        let rms = |renderer: &mut Renderer| {
            let link = format!(
                "#view={},{},1000,0,0&{SEA}",
                lat + north + if angle_deg < 0.0 { WIDE_DEG } else { 0.0 },
                lon + east
            );
            let heights =
                render::measure(renderer, &render::parse_state(&link).unwrap(), [128, 128], LayerName::Height)
                    .unwrap()
                    .values;
            (heights.iter().map(|height| height * height).sum::<f64>() / heights.len() as f64).sqrt()
        };
        let (behind, before) = (rms(&mut walled.0), rms(&mut open.0));
        let ratio = behind / before;
        println!("{angle_deg} deg: {behind:.2} m where {before:.2} m are without a wall, {ratio:.3} for {expected}");
        // The same waves with a wall and without, so that nothing is left to chance. V is within 0.04 of the solution.
        assert!((ratio - expected).abs() < 0.04, "{angle_deg}: {ratio}");
    }
}
