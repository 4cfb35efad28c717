//! The sea as one field over the whole earth: wavelengths and directions true, no seam, no period, the same variance everywhere.

use std::f64::consts::TAU;

use glam::{DMat2, DVec2, DVec3};
use ocean_globe::model::drawn_patches::DrawnPatches;
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::model::moved_water::{Motion, Place};
use ocean_globe::model::sea_bed::smoothstep;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::model::wave_domain::{self, PATCHES, PERLIN_PATCH, Plane};
use ocean_globe::model::{noise, perlin, waves};
use ocean_globe::pass::fft::Precision;
use ocean_globe::scene::frame::{Frame, MIX_FAR_M};
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::{Quality, Settings};
use ocean_globe::scene::view::camera::Camera;

use crate::water::{Drawn, Ensemble, Water, Waves, place, reseeded};

/// 2026-11-20T12:00:00Z.
const NOON: f64 = 1_795_176_000.0;

fn blowing(beaufort: u8) -> Settings {
    Settings { beaufort: Some(beaufort), chop: 0.0, quality: Quality::Low, ..Settings::default() }
}

fn patches_m(tables: &SeaTables) -> [f64; PATCHES] {
    std::array::from_fn(|patch| tables.cascades.get(patch).map_or(tables.perlin.patch_m, |cascade| cascade.patch_m))
}

/// Places evenly over the sphere, radians.
fn spread(count: usize) -> impl Iterator<Item = (f64, f64)> {
    (0..count).map(|n| {
        let [u, v] = noise::bits(4, 2, n as i32, 0).map(|bits| (bits >> 11) as f64 / (1u64 << 53) as f64);
        ((2.0 * u - 1.0).asin(), TAU * v - TAU / 2.0)
    })
}

#[test]
fn waves_are_as_long_and_go_where_they_should_up_to_100_km_from_the_poles() {
    let settings = blowing(12);
    let patches_m = patches_m(&SeaTables::of(&settings));
    let from = settings.wind_from();
    let toward = DVec2::new(-from.sin(), -from.cos());
    // 100 km of a meridian's 10,002 km at the pole, 111,694 m a degree; from there out ever sparser, then everywhere.
    let nearest_deg = 100.0 / 111.694;
    let polar = (0..2_000).map(|n| {
        let lat = (90.0 - nearest_deg - 3.0 * (n as f64 / 2_000.0).powi(2)).to_radians();
        (if n % 2 == 0 { lat } else { -lat }, 2.399_963 * n as f64)
    });
    let highest = (90.0 - nearest_deg).to_radians();
    let everywhere = spread(4_000).filter(|(lat, _)| lat.abs() < highest);
    let (mut longest, mut turned) = (0.0f64, [0.0f64; PATCHES]);
    for (lat, lon) in polar.chain(everywhere) {
        let enu = earth::ecef_from_enu(lat, lon);
        let foot = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
        let cells = wave_domain::cells_near(lat, lon);
        let serving = wave_domain::blend(&cells, foot);
        assert!(serving.len() <= 4);
        for (patch, patch_m) in patches_m.into_iter().enumerate() {
            // Sums over whatever serves, by energy.
            let (mut direction, mut stretch, mut energy) = (DVec2::ZERO, 0.0, 0.0);
            for &(cell, share) in &serving {
                let plane = Plane::new(cell, settings.seed, from);
                for here in plane.placements(patch, patch_m, plane.point(foot)) {
                    // The place in the patch a metre on, east and north, by the same vertex.
                    let step = |axis: DVec3| {
                        let point = plane.point(foot + axis) - plane.point(foot);
                        DVec2::new(point.dot(here.axes[0]), point.dot(here.axes[1]))
                    };
                    let patch_from_level = DMat2::from_cols(step(enu.x_axis), step(enu.y_axis));
                    // The wave vector of a unit wave along the patch's x.
                    let wave = patch_from_level.transpose() * DVec2::X;
                    let weight = (share * here.weight).powi(2);
                    direction += weight * wave.normalize();
                    stretch += weight * (patch_from_level.determinant().abs().sqrt() - 1.0).abs();
                    longest = longest.max((wave.length() - 1.0).abs());
                    energy += weight;
                }
            }
            assert!((energy - 1.0).abs() < 1e-12);
            assert!(stretch < 0.01);
            turned[patch] = turned[patch].max(direction.angle_to(toward).abs().to_degrees());
        }
    }
    println!("wavelengths within {:.4} %, directions within {turned:.3?} deg", 100.0 * longest);
    assert!(longest < 0.01, "{longest}");
    assert!(turned.into_iter().all(|angle| angle < 1.0), "{turned:?} deg");
}

/// Heights of each patch at a place at rest, metres.
fn heights(
    settings: &Settings,
    tables: &SeaTables,
    patches: &DrawnPatches,
    lat: f64,
    lon: f64,
) -> [f64; waves::CASCADES] {
    let place = Place::new(tables, settings.wind_from(), lat, lon);
    std::array::from_fn(|wanted| {
        let only = |patch: usize, at| if patch == wanted { patches.motion(patch, at) } else { Motion::default() };
        place.motion(DVec2::ZERO, only).height
    })
}

#[test]
fn there_is_no_seam_on_the_earth() {
    const STEP_M: f64 = 0.25;
    let settings = blowing(8);
    let tables = SeaTables::of(&settings);
    let patches = Seas::default().patches(&tables, waves::ticks_from_unix(NOON));
    let corner = (1.0f64 / 3.0f64.sqrt()).asin().to_degrees();
    let mut lines: Vec<(String, f64, f64)> = [
        ("equator", 0.0, 12.3),
        ("equator and prime meridian", 0.0, 0.0),
        ("antimeridian", -20.0, 180.0),
        ("north pole", 90.0, 0.0),
        ("south pole", -90.0, 0.0),
        ("edge of the cube", 10.0, 45.0),
        ("upper edge of the cube", 45.0, 0.0),
        ("corner of the cube", corner, 45.0),
        ("lower corner of the cube", -corner, -135.0),
    ]
    .map(|(name, lat, lon)| (name.to_owned(), f64::to_radians(lat), f64::to_radians(lon)))
    .into();
    for (n, (lat, lon)) in spread(6).enumerate() {
        // Where two cells are as near, and where the farther one ends to serve.
        let cell = wave_domain::cells_near(lat, lon)[0];
        let next = wave_domain::cells_near(cell.lat, cell.lon)[1];
        let apart = cell.centre.distance(next.centre);
        for (name, way) in [("border", 0.5), ("end of a border", 0.5 - 0.5 * wave_domain::BLEND_WIDTH_M / apart)] {
            let at = WGS84.geodetic_from_ecef(cell.centre.lerp(next.centre, way)).unwrap();
            lines.push((format!("{name} {n}"), at.lat, at.lon));
        }
        lines.push((format!("inside {n}"), cell.lat, cell.lon));
    }
    // Of neighbouring heights of a patch: the spectrum's slopes along the wind are the greatest, over a step of a quarter of a metre;
    // what blending adds is less than 1 %.
    let bound = tables.cascade_slopes.map(|[x, y]| 1.01 * x.max(y).sqrt() * STEP_M);
    let mut worst = [("", 0.0f64); waves::CASCADES];
    for (name, lat, lon) in &lines {
        let (foot, enu) = (
            WGS84.ecef_from_geodetic(Geodetic { lat: *lat, lon: *lon, height: 0.0 }),
            earth::ecef_from_enu(*lat, *lon),
        );
        for heading in [0.3f64, 1.9] {
            let along = enu * DVec3::new(heading.sin(), heading.cos(), 0.0);
            let mut last = None;
            for step in 0..=800 {
                let at = WGS84.geodetic_from_ecef(foot + (f64::from(step) - 400.0) * STEP_M * along).unwrap();
                let here = heights(&settings, &tables, &patches, at.lat, at.lon);
                if let Some(last) = last.replace(here) {
                    for patch in 0..waves::CASCADES {
                        let jump = (here[patch] - last[patch]).abs() / bound[patch];
                        if jump > worst[patch].1 {
                            worst[patch] = (name, jump);
                        }
                    }
                }
            }
        }
    }
    println!("greatest steps in standard deviations: {worst:.2?}");
    // Of 43,200 Gaussian steps one in thousands of lines passes 6 deviations; a border without blending makes steps of the waves' height,
    // 60 deviations and more in the two longest patches.
    for (patch, (name, jump)) in worst.into_iter().enumerate() {
        assert!(jump < 6.0, "patch {patch}, {name}: {jump} deviations");
    }
}

/// Own correlation of the spectrum's waves of a patch at lags along the wind and across it, m: of heights, slopes along, slopes across.
fn own_correlation(spectrum: &dyn DirectionalSpectrum, k: [f64; 2], lag: DVec2) -> [f64; 3] {
    // A plane-filling sequence over wave numbers and angles: 2^16 terms that turn many times err by 1/256.
    const TERMS: usize = 1 << 16;
    let (mut sums, mut totals) = ([0.0; 3], [0.0; 3]);
    for term in 0..TERMS {
        let [u, v] = place(term, 1.0);
        let size = k[0] * (k[1] / k[0]).powf(u);
        let (sin, cos) = (TAU * v).sin_cos();
        let wave = size * DVec2::new(cos, sin);
        // Area of a step: k dk dθ = k² d(ln k) dθ.
        let energy = spectrum.density(wave.x, wave.y) * size * size;
        for (index, part) in [1.0, wave.x * wave.x, wave.y * wave.y].into_iter().enumerate() {
            sums[index] += energy * part * wave.dot(lag).cos();
            totals[index] += energy * part;
        }
    }
    std::array::from_fn(|index| sums[index] / totals[index])
}

#[test]
fn no_patch_shows_its_period() {
    const FRAMES: u32 = 90;
    const POINTS: usize = 64;
    let mut water = Water::new(128, Precision::Single, |source| source);
    let settings = blowing(8);
    let tables = SeaTables::of(&settings);
    let (all, spectrum) = (Waves::of(&tables), tables.sea.spectrum());
    let mut seas = Seas::default();
    let patches_m = patches_m(&tables);
    // Multiples of the patch's length along the wind, across it, and both.
    let lags = [1.0, 2.0, 3.0].map(|m| [[m, 0.0], [0.0, m], [m, m], [m, -m]]).concat();
    let from = settings.wind_from();
    let axes = [DVec2::new(-from.sin(), -from.cos()), DVec2::new(from.cos(), -from.sin())];
    for (patch, patch_m) in patches_m.into_iter().enumerate() {
        let mut energies = all.energies.clone();
        for (index, energies) in energies.iter_mut().enumerate() {
            if index != patch {
                energies.fill(0.0);
            }
        }
        let alone = Waves { patches: all.patches, energies, omegas: all.omegas.clone() };
        let distance = if patch == PERLIN_PATCH { MIX_FAR_M as f32 } else { 0.0 };
        // Products at each lag, of height and both slopes, over the products at none.
        let mut found = vec![[Ensemble::default(); 3]; lags.len()];
        let mut squares = [0.0; 3];
        for (seed, (lat, lon)) in (0..FRAMES).zip(spread(FRAMES as usize)) {
            let camera = Camera { lat: lat * 0.9, lon, ..Camera::from_degrees(0.0, 0.0, 3.0, 0.0, 0.0) };
            let frame =
                reseeded(&Frame::of(&mut seas, &settings, &camera, NOON, [64, 64]), seed, NOON + 1e4 * f64::from(seed));
            // What has no weight at a place is made once: it would be seen there.
            if patch != PERLIN_PATCH || seed == 0 {
                water.set_waves(&alone.patches, &alone.data(seed), frame.ticks());
            }
            if patch == PERLIN_PATCH || seed == 0 {
                water.set_noise(&frame);
            }
            let mut places = Vec::new();
            for point in 0..POINTS {
                let start = DVec2::from(place(point + POINTS * seed as usize, 2.0 * patch_m)) - patch_m;
                for lag in [[0.0; 2]].iter().chain(&lags) {
                    let at = start + patch_m * (lag[0] * axes[0] + lag[1] * axes[1]);
                    places.push([at.x as f32, at.y as f32, distance, 0.0]);
                }
            }
            let mut sums = vec![[0.0; 3]; lags.len()];
            for drawn in water.at(&frame, &places).chunks_exact(1 + lags.len()) {
                let values = |d: &Drawn| [d.height, d.slope[0], d.slope[1]];
                let here = values(&drawn[0]);
                for (square, x) in squares.iter_mut().zip(here) {
                    *square += x * x / (FRAMES as usize * POINTS) as f64;
                }
                for (sums, there) in sums.iter_mut().zip(&drawn[1..]) {
                    for ((sum, a), b) in sums.iter_mut().zip(here).zip(values(there)) {
                        *sum += a * b / POINTS as f64;
                    }
                }
            }
            for (ensembles, sums) in found.iter_mut().zip(sums) {
                for (ensemble, sum) in ensembles.iter_mut().zip(sums) {
                    ensemble.push(sum);
                }
            }
        }
        let k = match tables.cascades.get(patch) {
            Some(cascade) => [cascade.k_min.max(1e-3), cascade.k_max],
            // The noise's cells share no lattice gradient from two cells on: at a patch's length it has no correlation of its own.
            None => [0.0; 2],
        };
        let (mut worst, mut error) = (0.0f64, 0.0f64);
        for (lag, ensembles) in lags.iter().zip(&found) {
            let own = if patch == PERLIN_PATCH {
                [0.0; 3]
            } else {
                own_correlation(&spectrum, k, patch_m * DVec2::from(*lag))
            };
            for ((ensemble, square), own) in ensembles.iter().zip(squares).zip(own) {
                worst = worst.max((ensemble.mean() / square - own).abs());
                error = error.max(ensemble.error() / square);
            }
        }
        println!("patch {patch} of {patch_m:.2} m: correlation within {worst:.3} of the spectrum's own, ± {error:.3}");
        assert!(error < 0.02, "patch {patch}: ± {error} tells too little");
        assert!(worst < 0.1, "patch {patch}: {worst} at a multiple of its length");
    }
}

#[test]
fn the_variance_is_the_same_everywhere() {
    const FRAMES: u32 = 160;
    const POINTS: usize = 256;
    let mut water = Water::new(128, Precision::Single, |source| source);
    let settings = blowing(8);
    let tables = SeaTables::of(&settings);
    let (all, mut seas) = (Waves::of(&tables), Seas::default());
    let slopes = tables.slopes();
    let m0 = (tables.sea.hs_m / 4.0).powi(2);
    // The waves at hand, then the far sea; anywhere, then where cells meet.
    for (what, distance, borders) in
        [("near", 0.0, false), ("near", 0.0, true), ("far", MIX_FAR_M, false), ("far", MIX_FAR_M, true)]
    {
        let mut found = [Ensemble::default(); 3];
        for (seed, (lat, lon)) in (0..FRAMES).zip(spread(FRAMES as usize)) {
            let (mut lat, mut lon) = (lat, lon);
            if borders {
                let cell = wave_domain::cells_near(lat, lon)[0];
                let next = wave_domain::cells_near(cell.lat, cell.lon)[1];
                let middle = WGS84.geodetic_from_ecef(0.5 * (cell.centre + next.centre)).unwrap();
                (lat, lon) = (middle.lat, middle.lon);
            }
            let camera = Camera { lat, lon, ..Camera::from_degrees(0.0, 0.0, 3.0, 0.0, 0.0) };
            let frame =
                reseeded(&Frame::of(&mut seas, &settings, &camera, NOON, [64, 64]), seed, NOON + 1e4 * f64::from(seed));
            // What has no weight at a place is made once: it would be seen there.
            if what == "near" || seed == 0 {
                water.set_waves(&all.patches, &all.data(seed), frame.ticks());
            }
            if what == "far" || seed == 0 {
                water.set_noise(&frame);
            }
            let places: Vec<[f32; 4]> = (0..POINTS)
                .map(|point| {
                    let [x, y] = place(point + POINTS * seed as usize, 6_000.0);
                    [x as f32 - 3_000.0, y as f32 - 3_000.0, distance as f32, 0.0]
                })
                .collect();
            let drawn = water.at(&frame, &places);
            let mean = |value: &dyn Fn(&Drawn) -> f64| drawn.iter().map(value).sum::<f64>() / POINTS as f64;
            found[0].push(mean(&|d| d.height * d.height) / m0);
            for axis in 0..2 {
                found[1 + axis].push(mean(&|d| d.slope[axis] * d.slope[axis] + d.rough[axis]) / slopes[axis]);
            }
        }
        for (name, ensemble) in ["height", "slope along", "slope across"].into_iter().zip(found) {
            let (mean, error) = (ensemble.mean(), ensemble.error());
            println!("{what}{}: {name} {mean:.4} ± {error:.4}", if borders { " on borders" } else { "" });
            assert!(error < 0.02, "{what} {name}: ± {error} tells too little");
            // The ensemble's own error, and the 1 % that the patches' grids may miss of the spectrum, or that the noise loses between
            // its texels.
            assert!((mean - 1.0).abs() < 3.5 * error + 0.01, "{what} {name}: {mean} ± {error}");
        }
    }
}

/// ⟨Σ |∇w|²⟩ of a blend's weights: over points, by central differences `step` apart.
fn steepness(points: impl Iterator<Item = DVec2>, step: f64, weights: impl Fn(DVec2) -> Vec<([i32; 3], f64)>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for point in points {
        for axis in [DVec2::X, DVec2::Y] {
            let (low, high) = (weights(point - 0.5 * step * axis), weights(point + 0.5 * step * axis));
            let at = |list: &[([i32; 3], f64)], id: [i32; 3]| {
                list.iter().find(|(found, _)| *found == id).map_or(0.0, |(_, w)| *w)
            };
            sum += low.iter().map(|(id, w)| (at(&high, *id) - w).powi(2)).sum::<f64>() / (step * step);
            sum += high.iter().filter(|(id, _)| at(&low, *id) == 0.0).map(|(_, w)| w * w).sum::<f64>() / (step * step);
        }
        count += 1.0;
    }
    sum / count
}

#[test]
fn blending_adds_less_than_a_hundredth_to_the_slopes_of_any_grade() {
    // Of a lattice of unit spacing, which repeats after two rows.
    let points = (0..40_000).map(|n| DVec2::from(place(n, 1.0)) * DVec2::new(1.0, 2.0 * wave_domain::ROW));
    let lattice = steepness(points, 1e-4, |p| wave_domain::around(p).map(|([i, j], w)| ([i, j, 0], w)).to_vec());
    // Of two cells along the line between them, where they blend; the share of the earth where they do only helps.
    let line = (0..2_000).map(|n| DVec2::new((f64::from(n) / 2_000.0 - 0.5) * 2.0 * wave_domain::BLEND_WIDTH_M, 0.0));
    let cells = steepness(line, 1.0, |p| {
        // Distances differ by twice the way.
        let weight = |behind: f64| smoothstep(0.0, 1.0, 1.0 - behind.max(0.0) / wave_domain::BLEND_WIDTH_M);
        let (a, b) = (weight(2.0 * p.x), weight(-2.0 * p.x));
        let norm = a.hypot(b);
        [([0; 3], a / norm), ([1, 0, 0], b / norm)].into_iter().filter(|(_, w)| *w > 0.0).collect()
    });
    println!("lattice: {lattice:.2} per square spacing; cells: {cells:.2e} per square metre");
    // A calm has no waves.
    for grade in 1..=12 {
        let tables = SeaTables::of(&Settings { quality: Quality::Medium, ..blowing(grade) });
        let (spectrum, slopes) = (tables.sea.spectrum(), tables.mean_square_slope());
        let m0 = (tables.sea.hs_m / 4.0).powi(2);
        let each = tables.cascades.map(|c| {
            spectrum.variance_between(c.k_min, c.k_max) * lattice / wave_domain::spacing_m(c.patch_m).powi(2) / slopes
        });
        let near = each.iter().sum::<f64>() + m0 * cells / slopes;
        let far_m0 = tables.perlin.amplitudes_m.iter().map(|a| a * a).sum::<f64>() * perlin::variance();
        let far = far_m0 * (lattice / wave_domain::spacing_m(tables.perlin.patch_m).powi(2) + cells) / slopes;
        println!("grade {grade}: near {:.4} %, far {:.4} %", 100.0 * near, 100.0 * far);
        assert!(near < 0.01 && far < 0.01, "grade {grade}: {near}, {far}");
    }
}
