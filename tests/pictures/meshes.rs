//! Both meshes draw the same sea, without a crack: nothing else is drawn, so that a hole shows nothing.

use ocean_globe::cli::render::{LayerName, headless, measure, parse_state, picture};
use ocean_globe::renderer::{Radiance, Renderer};

const SIZE: [u32; 2] = [160, 90];
/// The default triangles; a budget of 200,000 would only make their pool larger, as small a picture does not use it up.
const BISECTED: &str = "bisect,6,20000";

#[test]
fn the_bisected_mesh_covers_what_the_grid_covers_without_a_hole() {
    let mut renderer = headless("www/data", Radiance::Single).unwrap();
    // Open ocean at the equator and the zero meridian, the antimeridian, an edge and a corner of the cuboid; deck to orbit.
    for view in [
        "view=35.68,-14.25,2,206,84&clouds=0&bft=8",
        "view=0,0,560,90,70&clouds=0&bft=6",
        "view=-40,180,30000,45,60&clouds=0&bft=8",
        "view=35.26,-135,3000,0,75&clouds=0&bft=5",
        "view=20,-45,3000000,0,0&clouds=0",
        "view=16,-25,30000000&clouds=0",
    ] {
        let mut layer = |mesh: &str, layer| {
            let state =
                parse_state(&format!("#{view}&time=2026-11-20T14:00:00Z&foam=0&quality=low&layers=-land&mesh={mesh}"))
                    .unwrap();
            measure(&mut renderer, &state, SIZE, layer).unwrap().values
        };
        let [grid, bisected] = ["grid", BISECTED].map(|mesh| layer(mesh, LayerName::Class));
        let [w, h] = SIZE.map(|side| side as usize);
        let near_sky = |at: usize| {
            let (x, y) = (at % w, at / w);
            let rows = y.saturating_sub(2)..(y + 3).min(h);
            rows.flat_map(|y| (x.saturating_sub(2)..(x + 3).min(w)).map(move |x| y * w + x)).any(|at| grid[at].is_nan())
        };
        let ocean = grid.iter().filter(|class| **class == 1.0).count();
        // A crest may stand a pixel or two higher or lower on the horizon: the meshes' corners differ. Nowhere else may they.
        let holes =
            (0..w * h).filter(|&at| grid[at].total_cmp(&bisected[at]).is_ne() && !grid[at].is_nan() && !near_sky(at));
        let holes = holes.count();
        println!("{view}: {ocean} pixels of ocean, {holes} differ");
        assert!(ocean > 500, "{view}: no ocean to compare");
        assert_eq!(holes, 0, "{view}");
        let dark = layer(BISECTED, LayerName::Luminance);
        assert!(
            dark.iter().zip(&bisected).all(|(l, c)| l.is_finite() && (c.is_nan() || *l > 0.0)),
            "{view}: black or NaN"
        );
    }
}

/// Where waves are smaller than pixels these look where their own rays meet the sea, whatever the triangles are: the same, but for the rounding of
/// what pixels keep of them. There the bisected mesh is lifted off the water, which is no wave that foam lies on.
#[test]
fn far_water_looks_alike_by_both_meshes() {
    let mut renderer = headless("www/data", Radiance::Half).unwrap();
    let mut pixels = |mesh: &str| {
        let view =
            "view=35.68,-30,3000,206,70&clouds=0&bft=7&foam=1,10,height&time=2026-11-20T14:00:00Z&quality=medium";
        picture(&mut renderer, &parse_state(&format!("#{view}&layers=-land&mesh={mesh}")).unwrap(), SIZE).unwrap()
    };
    let [grid, bisected] = ["grid", BISECTED].map(&mut pixels);
    let apart: u64 = grid.iter().zip(&bisected).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    let mean = apart as f64 / grid.len() as f64;
    println!("mean difference {mean:.3} of 255");
    // Half a step of 255 where values round otherwise.
    assert!(mean < 0.5, "{mean} of 255");
}

/// A mesh at rest sleeps. Whatever changes the wish wakes it: it comes to the mesh that it would come to from its beginning.
#[test]
fn whatever_is_seen_anew_wakes_a_sleeping_mesh() {
    let mut renderer = headless("www/data", Radiance::Single).unwrap();
    let vertices = |renderer: &mut Renderer, (view, sea, mesh, size): (&str, &str, &str, [u32; 2])| {
        let link =
            format!("#view={view}&clouds=0&{sea}&mesh={mesh}&time=2026-11-20T14:00:00Z&quality=low&layers=-land");
        measure(renderer, &parse_state(&link).unwrap(), size, LayerName::Class).unwrap();
        renderer.cost().unwrap().vertices
    };
    let mut last = None;
    // Each differs from the one before by one thing alone: heading, tilt, altitude, place, wind, wished pixels, size of the picture.
    for seen in [
        ("35.68,-14.25,300,206,70", "bft=5", "bisect,12,6000", SIZE),
        ("35.68,-14.25,300,250,70", "bft=5", "bisect,12,6000", SIZE),
        ("35.68,-14.25,300,250,50", "bft=5", "bisect,12,6000", SIZE),
        ("35.68,-14.25,900,250,50", "bft=5", "bisect,12,6000", SIZE),
        ("-35.68,20.5,900,250,50", "bft=5", "bisect,12,6000", SIZE),
        ("-35.68,20.5,900,250,50", "bft=11", "bisect,12,6000", SIZE),
        ("-35.68,20.5,900,250,50", "bft=11", "bisect,14,6000", SIZE),
        ("-35.68,20.5,900,250,50", "bft=11", "bisect,14,6000", [160, 120]),
    ] {
        let woken = vertices(&mut renderer, seen);
        renderer.forget();
        let scratch = vertices(&mut renderer, seen);
        println!("{seen:?}: {woken} vertices, from the beginning {scratch}");
        assert!(woken == scratch, "{seen:?}: {woken} vertices instead of {scratch}");
        assert!(last != Some(woken), "{seen:?}: {woken} vertices as before");
        last = Some(woken);
    }
}
