//! The field of clouds: as much as is asked for, the same for every eye and every footprint, without a seam.

use glam::{DVec3, Vec3, Vec4};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::clouds::{self as model, weather};
use ocean_globe::model::earth::{self, WGS84};
use ocean_globe::model::overcast;
use ocean_globe::pass::cloud_map::CloudMap;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

/// 2026-11-20T12:00:00Z.
const NOON: f64 = 1_795_176_000.0;
const DAY: f64 = 86_400.0;
/// Degrees of latitude: the tropics' belt, the subtropics, the tracks of storms.
const BELTS: [std::ops::RangeInclusive<f32>; 3] = [3.0..=9.0, 18.0..=26.0, 52.0..=62.0];

const KERNEL: &str = "#import clouds
#import ice_clouds
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;   // a place and a footprint
@group(2) @binding(1) var<storage, read_write> levels: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> places: array<vec4f>;
@compute @workgroup_size(64)
fn look(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let level = cloud_level(a.xyz, a.w, 0.0);
    levels[id.x] = vec4f(level, in_cloud(level, 0.0).share, ice_optical_depth(a.xyz, a.w));
    // The same numbers, taken for a place of the local frame.
    places[id.x] = vec4f(cloud_place(a.xyz), 0.0);
}";

/// A column of clouds that the sun's light goes through to a place of the local frame, and what the shadow there is taken to be.
const SHADOWS: &str = "#import clouds
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> columns: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> lights: array<vec4f>;
@compute @workgroup_size(64)
fn look(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let at = asked[id.x].xyz;
    let overhead = cloud_place(at + frame.light * (CLOUD_SHADOW / frame.light.z));
    let weather = cloud_weather(overhead);
    columns[id.x] = vec4f(cloud_level_of(weather, overhead, 150.0, 0.0, 0.0), weather.x, frame.light.z);
    let shadow = cloud_shadow(at, vec3f(0.0, 0.0, 1.0), 10.0);
    lights[id.x] = vec4f(shadow.left, shadow.cover, shadow.disc, 0.0);
}";

/// A sky with clouds.
struct Sky {
    gpu: Gpu,
    map: CloudMap,
    layouts: [wgpu::BindGroupLayout; 2],
    kernel: Kernel<2>,
}

impl Sky {
    fn new() -> Self {
        Self::asked_by(KERNEL)
    }

    fn asked_by(kernel: &str) -> Self {
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let entry = wgpu::BindGroupLayoutEntry {
            binding: 12,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only: true },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries: &[entry] };
        let layouts = [kernel::frame_layout(&gpu), gpu.device.create_bind_group_layout(&descriptor)];
        let kernel = Kernel::new(&gpu, &shader::composed(kernel, ""), "look", &layouts.each_ref());
        Self { map: CloudMap::new(&gpu), layouts, kernel, gpu }
    }

    /// Levels at places of a frame with footprints, and the places that these would be in the local frame.
    fn at(&mut self, frame: &Frame, asked: &[Vec4]) -> [Vec<[f32; 4]>; 2] {
        let Self { gpu, map, layouts, kernel } = self;
        map.prepare(gpu, weather(frame.unix_seconds));
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        map.dispatch(&mut encoder.begin_compute_pass(&Default::default()));
        gpu.queue.submit([encoder.finish()]);
        let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let entry = wgpu::BindGroupEntry { binding: 12, resource: map.levels.as_entire_binding() };
        let descriptor = wgpu::BindGroupDescriptor { label: None, layout: &layouts[1], entries: &[entry] };
        let clouds = gpu.device.create_bind_group(&descriptor);
        let groups = [kernel::frame_group(gpu, &layouts[0], &uniform, &frame.wave_cells), clouds];
        kernel.run(gpu, &groups.each_ref(), &asked.iter().map(Vec4::to_array).collect::<Vec<_>>())
    }
}

fn frame(cover: f64, [lat, lon, altitude]: [f64; 3], unix_seconds: f64) -> Frame {
    let settings = Settings { clouds: Some(cover), ..Settings::default() };
    Frame::new(&settings, &Camera::from_degrees(lat, lon, altitude, 0.0, 0.0), unix_seconds, [64; 2])
}

/// Places all over the earth, evenly: a spiral of Fibonacci's.
fn all_over(count: usize) -> Vec<Vec3> {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let place = |index: usize| {
        let z = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
        let (sin, cos) = (golden * index as f64).sin_cos();
        let across = (1.0 - z * z).sqrt();
        (DVec3::new(across * cos, across * sin, z) * (WGS84.a + 1_000.0)).as_vec3()
    };
    (0..count).map(place).collect()
}

fn mean(values: impl ExactSizeIterator<Item = f32>) -> f64 {
    let count = values.len() as f64;
    values.map(f64::from).sum::<f64>() / count
}

#[test]
fn clouds_cover_as_much_as_is_asked_for_at_any_footprint() {
    let mut sky = Sky::new();
    let places = all_over(20_000);
    for cover in [0.1, 0.45, 0.7] {
        // The mean of several weathers: a single one's is off by what a few dozen storms leave.
        let mut shares = [0.0; 4];
        let mut belts = BELTS.map(|_| 0.0);
        let days = [0.0, 30.0, 60.0, 90.0];
        for day in days {
            let frame = frame(cover, [0.0, 0.0, 1e7], NOON + day * DAY);
            for (share, footprint) in shares.iter_mut().zip([20.0, 2_000.0, 20_000.0, 200_000.0]) {
                let asked: Vec<Vec4> = places.iter().map(|place| place.extend(footprint)).collect();
                let [levels, _] = sky.at(&frame, &asked);
                *share += mean(levels.iter().map(|level| level[2])) / days.len() as f64;
                if footprint < 100.0 {
                    for (belt, lats) in belts.iter_mut().zip(BELTS) {
                        let within = |place: &Vec3| lats.contains(&(place.z / place.length()).asin().to_degrees());
                        let here = places.iter().zip(&levels).filter(|(place, _)| within(place));
                        let here: Vec<f32> = here.map(|(_, level)| level[2]).collect();
                        *belt += mean(here.into_iter()) / days.len() as f64;
                    }
                }
            }
        }
        // What the model says of the middle of each belt, over which its level changes by less than a fifth.
        let wanted = BELTS.map(|lats| {
            let middle = f64::from(0.5 * (lats.start() + lats.end())).to_radians();
            0.5 * libm::erfc(-(model::belts(middle) + model::shift(cover)) / std::f64::consts::SQRT_2)
        });
        println!("{cover} asked for, found {shares:.3?}; belts {belts:.3?}, wanted {wanted:.3?}");
        // A belt holds a few weathers of some thousand kilometres a day.
        assert!(belts.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 0.08), "{belts:?} {wanted:?}");
        assert!((shares[0] - cover).abs() < 0.03, "{cover}: {shares:?}");
        // What pixels hide is normal only nearly: a sum of eight corners' gradients.
        assert!(shares.iter().all(|share| (share - shares[0]).abs() < 0.01), "{cover}: {shares:?}");
    }
}

#[test]
fn the_model_has_the_weather_of_the_map() {
    let mut sky = Sky::new();
    // In the middle between two weathers, at middles of the map's texels.
    let frame = frame(0.4, [0.0, 0.0, 1e7], NOON + 1.6 * DAY);
    let side = f64::from(model::MAP_TEXELS);
    let texel = |index: u32| {
        let [x, y] = [index * 7919 % model::MAP_TEXELS, index * 104_729 % model::MAP_TEXELS];
        let [x, y] = [x, y].map(|i| (f64::from(i) + 0.5) / side * 2.0 - 1.0);
        let z = 1.0 - x.abs() - y.abs();
        let folded = |a: f64, b: f64| if z < 0.0 { (1.0 - b.abs()) * a.signum() } else { a };
        DVec3::new(folded(x, y), folded(y, x), z).normalize()
    };
    let places: Vec<DVec3> = (0..400).map(texel).collect();
    let asked: Vec<Vec4> = places.iter().map(|place| (*place * WGS84.a).as_vec3().extend(1e6)).collect();
    let [levels, _] = sky.at(&frame, &asked);
    let weather = weather(frame.unix_seconds);
    let wanted = places.iter().map(|place| overcast::level(*place, &weather) + model::shift(0.4));
    let off = levels.iter().zip(wanted).map(|(found, wanted)| (f64::from(found[0]) - wanted).abs());
    let worst = off.fold(0.0, f64::max);
    println!("levels differ by {worst:.5} at most");
    // Single precision, and sines and exponentials as GPUs have them (2^-11 at worst), through 28 turns about storms; of two parts in a
    // thousand of a texel the steepest slope makes as much.
    assert!(worst < 0.03, "{worst}");
}

/// Of what is in cloud, the share that lies outside the heaps as they are without the lobes on them.
#[test]
fn few_scraps_of_clouds_float_beside_heaps() {
    let mut sky = Sky::new();
    let places = all_over(40_000);
    let frame = frame(0.3, [0.0, 0.0, 1e7], NOON);
    // The second footprint hides cells of lobes, 330 m and less, and hardly any of those before.
    let [fine, heaps] = [20.0, 230.0].map(|footprint| {
        let asked: Vec<Vec4> = places.iter().map(|place| place.extend(footprint)).collect();
        sky.at(&frame, &asked)[0].clone()
    });
    let in_cloud = fine.iter().zip(&heaps).filter(|(fine, _)| fine[0] > 0.0);
    let (all, scraps) =
        in_cloud.fold((0, 0), |(all, scraps), (_, heap)| (all + 1, scraps + i32::from(heap[0] < -0.15)));
    println!("of {all} places in cloud {scraps} are scraps");
    assert!(all > 8_000);
    // With lobes that have no regard to heaps it is .024.
    assert!(f64::from(scraps) < 0.01 * f64::from(all), "{scraps} of {all}");
}

#[test]
fn two_eyes_see_the_same_clouds() {
    let mut sky = Sky::new();
    let there = WGS84.ecef_from_geodetic(earth::Geodetic { lat: 0.62, lon: -0.3, height: 1_500.0 });
    let mut found = Vec::new();
    for eye in [[35.6, -17.1, 3.0], [36.4, -16.0, 2_000.0], [30.0, -30.0, 400_000.0]] {
        let frame = frame(0.4, eye, NOON);
        let camera = frame.camera;
        let local = earth::ecef_from_enu(camera.lat, camera.lon).transpose() * (there - camera.eye_ecef());
        let [_, places] = sky.at(&frame, &[local.as_vec3().extend(0.0)]);
        let [x, y, z, _] = places[0];
        let [levels, _] = sky.at(&frame, &[Vec4::new(x, y, z, 50.0)]);
        found.push((Vec3::new(x, y, z), levels[0]));
    }
    for (place, levels) in &found[1..] {
        // Steps of single precision at the earth's radius are half a metre.
        assert!(place.distance(found[0].0) < 3.0, "{found:?}");
        assert!((0..4).all(|i| (levels[i] - found[0].1[i]).abs() < 0.05), "{found:?}");
    }
    // And the earth turns below them by the drift alone.
    assert!((f64::from(found[0].0.length()) - there.length()).abs() < 2.0);
}

#[test]
fn the_map_of_the_weather_has_no_seam() {
    let mut sky = Sky::new();
    let frame = frame(0.4, [0.0, 0.0, 1e7], NOON);
    // Pairs 10 km apart; those whose sides of the octahedron differ lie on its edges.
    let places = all_over(200_000);
    let pairs = |on_edge: bool| -> Vec<[Vec3; 2]> {
        let moved = |place: &Vec3| {
            let aside = place.normalize().any_orthonormal_vector() * 10_000.0;
            [*place, *place + aside]
        };
        let side = |place: Vec3| [place.x > 0.0, place.y > 0.0, place.z > 0.0];
        places
            .iter()
            .map(moved)
            .filter(|[one, other]| (side(*one) != side(*other)) == on_edge)
            .step_by(if on_edge { 1 } else { 60 })
            .collect()
    };
    let mut deviation = |pairs: Vec<[Vec3; 2]>| {
        assert!(pairs.len() > 200);
        // So wide that only the map shows.
        let asked: Vec<Vec4> = pairs.iter().flatten().map(|place| place.extend(1e6)).collect();
        let [levels, _] = sky.at(&frame, &asked);
        let squares = levels.chunks_exact(2).map(|pair| (pair[1][0] - pair[0][0]).powi(2));
        mean(squares).sqrt()
    };
    let [inside, on_edges] = [deviation(pairs(false)), deviation(pairs(true))];
    println!("over 10 km levels change by {inside:.4}, across edges of the map by {on_edges:.4}");
    // Texels are up to twice as wide in the middle of the octahedron's sides as at its corners.
    assert!(on_edges < 2.0 * inside, "{on_edges} {inside}");
}

/// A number as the shaders of clouds have it.
fn number(name: &str) -> f64 {
    let source = [include_str!("../../shaders/clouds.wgsl"), include_str!("../../shaders/lib/clouds.wgsl")].concat();
    let begin = format!("const {name} = ");
    let rest = source.split(&begin).nth(1).expect(name);
    rest.split(';').next().and_then(|value| value.parse().ok()).expect(name)
}

/// What a column of clouds leaves of the sun's light, whose droplets, as `shaders/clouds.wgsl` draws them, scatter a part of it otherwise than ahead; the
/// level there is normal, of a mean and a variance.
fn left_by([mean, variance, weather, mu]: [f64; 4]) -> f64 {
    let [aside, tall, squash, most, soft, opacity, crisp_from, crisp] =
        ["ASIDE", "CLOUD_TALL", "CLOUD_SQUASH", "CLOUD_SPARE", "CLOUD_SOFT", "CLOUD_OPACITY", "CRISP_FROM", "CRISP"]
            .map(number);
    let smoothstep = |from: f64, to: f64, x: f64| {
        let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    };
    let depth = |level: f64| {
        let layer = |step: i32| {
            let height = (f64::from(step) + 0.5) / 100.0;
            let square = height * height;
            let spare = (weather - most).max(0.0) * smoothstep(0.1, 0.6, height);
            let edge = tall * square / (1.0 - squash * square).max(0.1) + spare;
            let dense = 1.0 + (crisp - 1.0) * smoothstep(0.0, crisp_from, height);
            // A hundredth of 1,200 m.
            opacity * dense * (level - edge).max(0.0) * 12.0
        };
        (0..100).map(layer).sum::<f64>()
    };
    let deviation = (variance + soft * soft).sqrt();
    let (mut sum, mut weights) = (0.0, 0.0);
    for node in -15..=15 {
        let x = f64::from(node) / 5.0;
        let weight = libm::exp(-0.5 * x * x);
        sum += weight * libm::exp(-aside * depth(mean + deviation * x) / mu);
        weights += weight;
    }
    sum / weights
}

#[test]
fn shadows_are_those_of_the_clouds_that_are_drawn() {
    let mut sky = Sky::asked_by(SHADOWS);
    // What is left by the droplets, what the shader says, and whether the clouds are heaps with gaps.
    let mut pairs = Vec::new();
    for lon in (-40..=40).step_by(10) {
        // A square of 40 km; the sun stands 40 degrees high or more.
        let eye = [if lon % 20 == 0 { -15.0 } else { -30.0 }, f64::from(lon), 500.0];
        let place =
            |index: i32| Vec4::new((index % 20 - 10) as f32 * 2_000.0, (index / 20 - 10) as f32 * 2_000.0, 0.0, 0.0);
        let asked: Vec<Vec4> = (0..400).map(place).collect();
        let [columns, lights] = sky.at(&frame(0.4, eye, NOON), &asked);
        let pair = |(column, light): (&[f32; 4], &[f32; 4])| {
            (left_by(column.map(f64::from)), f64::from(light[0]), (-1.0..0.3).contains(&column[1]))
        };
        pairs.extend(columns.iter().zip(&lights).map(pair));
    }
    let heaps: Vec<_> = pairs.iter().filter(|(wanted, _, are_heaps)| *are_heaps && *wanted < 0.6).collect();
    let off = |(wanted, left, _): &(f64, f64, bool)| (left - wanted).abs();
    let [all, shade] = [
        pairs.iter().map(off).sum::<f64>() / pairs.len() as f64,
        heaps.iter().map(|pair| off(pair)).sum::<f64>() / heaps.len() as f64,
    ];
    println!(
        "{} of {} places are in the shade of heaps; what is left is off by {shade:.3} there, by {all:.3} everywhere",
        heaps.len(),
        pairs.len()
    );
    // A height in the mean and one density stand for a column: 0.087 and 0.017. Without heaps' own density it is 0.344 and 0.054.
    assert!(heaps.len() > 200 && shade < 0.1 && all < 0.02, "{shade} {all}");
}
