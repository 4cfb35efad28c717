//! Waves by a shore are the same for every eye, whatever it has seen before, and as high beside the edges of windows as between them.

use glam::DVec2;
use ocean_globe::cli::render::LayerName;

use crate::plane_beach::{Beach, EDGE_DEG, View, WITHIN_DEG, taken_apart, trains_of};

/// So long that the patches keep 0.2 % of its energy.
const SWELL: &str = "wind=0@90&swell=0.2,15,60";
const SEA: &str = "wind=0@90&swell=0.6,11,60";

#[test]
fn two_eyes_see_the_same_waves_by_a_shore() {
    let [mut first, mut second] = ["seams-1", "seams-2"].map(Beach::new);
    // Across the edge of a window, waves of 0.2 m rms.
    let view = View { lat_deg: EDGE_DEG, depth_m: 5.0, altitude_m: 40.0, size: [80, 48] };
    // The other one comes from along the shore, an hour later, from another sea.
    for (lat_deg, altitude_m, sea, time) in
        [(0.3, 900.0, SEA, 5_000.0), (0.08, 300.0, "wind=12@110", 3_600.0), (0.05, 120.0, SEA, -86_400.0)]
    {
        second.layer(&View { lat_deg, altitude_m, depth_m: 20.0, size: [32, 32] }, sea, time, LayerName::Height);
    }
    for time in [7.0, 1e6] {
        let [a, b] = [&mut first, &mut second].map(|beach| beach.layer(&view, SEA, time, LayerName::Height));
        assert_eq!(a, b, "the same view, {time} s");
        // An eye elsewhere, half as high again.
        let other = View { lat_deg: EDGE_DEG + 8e-5, depth_m: 5.2, altitude_m: 60.0, size: [160, 96] };
        let [places, heights] =
            [LayerName::Lonlat, LayerName::Height].map(|name| second.layer(&other, SEA, time, name));
        let own = first.layer(&view, SEA, time, LayerName::Lonlat);
        let at = |places: &[f64], pixel: usize| DVec2::new(places[2 * pixel], places[2 * pixel + 1]);
        let step = (at(&places, other.size[0] * other.size[1] - 1) - at(&places, 0)) / DVec2::new(159.0, 95.0);
        let (mut off, mut all, mut count) = (0.0, 0.0, 0.0);
        for (pixel, height) in a.iter().enumerate() {
            let to = (at(&own, pixel) - at(&places, 0)) / step;
            if to.min_element() < 0.0 || to.x >= 158.0 || to.y >= 94.0 {
                continue;
            }
            let (low, f) = (to.floor(), to - to.floor());
            let value = |dx: usize, dy: usize| heights[(low.y as usize + dy) * 160 + low.x as usize + dx];
            let top = value(0, 0) * (1.0 - f.x) + value(1, 0) * f.x;
            let bottom = value(0, 1) * (1.0 - f.x) + value(1, 1) * f.x;
            off += (top * (1.0 - f.y) + bottom * f.y - height).powi(2);
            all += height.powi(2);
            count += 1.0;
        }
        let [off, all] = [off, all].map(|square: f64| (square / count).sqrt());
        println!("{count} places, {all:.3} m rms: {off:.4} m from one eye to the other");
        // Cells of 2.8 m and of 2.1 m: either has waves too low by (kΔ)²/12 between its vertices, at most 1 % of those of 8 s.
        assert!(count > 3_000.0 && all > 0.04 && off < 0.01 * all, "{off} of {all} m");
    }
}

#[test]
fn waves_are_as_high_at_the_edges_of_windows() {
    let mut beach = Beach::new("edges");
    let trains = trains_of(SWELL);
    let mut square = |lat_deg: f64| {
        let view = View { lat_deg, depth_m: 10.0, altitude_m: 40.0, size: [80, 48] };
        let parts = taken_apart(&beach.heights(&view, SWELL, 72), &trains);
        let pixels = (view.size[0] * view.size[1]) as f64;
        parts.iter().map(|part| part.iter().map(|wave| wave.length_squared()).sum::<f64>() / pixels).sum::<f64>()
    };
    let [within, edge] = [WITHIN_DEG, EDGE_DEG].map(&mut square);
    println!("variance at an edge {:.4} of that between edges", edge / within);
    assert!((edge / within - 1.0).abs() < 0.03, "{edge} {within}");
}
