//! The tables of the air that the eye sees against steps along each ray, from the deck to space, from noon to night. Each test
//! compares these tables, over many eyes and suns.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::pass::air_table::AirTable;
use ocean_globe::pass::sky_table::SkyTable;
use ocean_globe::pass::sky_view::SkyView;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{Kernel, frame_group, frame_layout};

/// Of a ray: what the tables say of it and what 256 steps along it do, radiance and transmittance.
const KERNEL: &str = "#import air
#import scattering
@group(1) @binding(9) var transmittances: texture_2d<f32>;
@group(1) @binding(10) var multiples: texture_2d<f32>;
@group(2) @binding(0) var<storage, read> rays: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> seen: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> seen_through: array<vec4f>;
@group(2) @binding(3) var<storage, read_write> stepped_through: array<vec4f>;
@group(2) @binding(4) var<storage, read_write> steps: array<vec4f>;
@compute @workgroup_size(64)
fn compare(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&rays) { return; }
    let direction = rays[id.x].xyz;
    let distance = rays[id.x].w;
    let ray = eye_ray(direction);
    let air = shell_hits(ray, TOP);
    var wanted = NOTHING_MET;
    if air.y > max(air.x, 0.0) {
        let sight = sight_along(ray, direction, frame.quadric_gradient, quadric_times(direction), frame.light);
        let sink = frame.air_sink * select(1.0, 0.5, distance > 1e8);
        wanted = scatter(sight, max(air.x, 0.0), min(air.y, distance), 256u, sink);
    }
    steps[id.x] = vec4f(wanted.radiance, 1.0);
    stepped_through[id.x] = vec4f(wanted.through, 1.0);
    if distance > 1e8 {
        seen[id.x] = vec4f(sky_seen(direction), surface_hit(ray));
        seen_through[id.x] = stepped_through[id.x];
    } else {
        let found = haze(direction, distance);
        let hit = surface_hit(ray);
        seen[id.x] = vec4f(found.radiance, select(-1.0, 1.0, hit >= 0.0 && distance > 1.001 * hit + 10.0));
        seen_through[id.x] = vec4f(found.transmittance, 1.0);
    }
}";

/// Farther than any surface: the sky.
const SKY: f32 = 1e9;

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Ray {
    direction: [f32; 3],
    distance: f32,
}

/// Evenly spread numbers, 0…1: the fractions of multiples of irrational numbers.
fn spread<const N: usize>(index: usize) -> [f64; N] {
    // The plastic number's kin in N dimensions.
    let mut root = 1.5f64;
    for _ in 0..50 {
        root = (1.0 + root).powf(1.0 / (N as f64 + 1.0));
    }
    std::array::from_fn(|i| (0.5 + index as f64 * root.powi(-(i as i32) - 1)).fract())
}

/// The tables of the air as the drawing passes have them, and a kernel that reads them.
pub struct Air<const N: usize> {
    gpu: Gpu,
    kernel: Kernel<N>,
    frame_layout: wgpu::BindGroupLayout,
    air: AirTable,
    sky: SkyTable,
    view: SkyView,
    tables: wgpu::BindGroup,
}

impl<const N: usize> Air<N> {
    pub fn new(source: &str, entry: &str) -> Self {
        use wgpu::TextureViewDimension::{D2, D3};
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let frame_layout = frame_layout(&gpu);
        let air = AirTable::new(&gpu, &frame_layout);
        let sky = SkyTable::new(&gpu, &frame_layout, &air.layout);
        let view = SkyView::new(&gpu, &frame_layout, &air.layout);
        // The drawing passes' bind group 1, as far as the air is concerned, and what the tables are made with.
        let mut binds = [Bind::Texture(D2); 11];
        (binds[5], binds[8]) = (Bind::Texture(D3), Bind::Texture(D3));
        let layout = gpu.layout("tables", wgpu::ShaderStages::COMPUTE, &binds);
        let mut views = [&air.transmittance; 11];
        (views[5], views[6]) = (&sky.radiance, &sky.irradiance);
        (views[7], views[8], views[10]) = (&view.sky, &view.haze, &air.multiple);
        let tables = gpu.bind("tables", &layout, &views.map(wgpu::BindingResource::TextureView));
        let kernel = Kernel::new(&gpu, &shader::composed(source, ""), entry, &[&frame_layout, &layout]);
        Self { gpu, kernel, frame_layout, air, sky, view, tables }
    }

    /// The kernel's outputs for a frame, whose tables are made first.
    pub fn run<In: Pod>(&mut self, frame: &Frame, inputs: &[In]) -> [Vec<[f32; 4]>; N] {
        let uniform = self.gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let group = frame_group(&self.gpu, &self.frame_layout, &uniform, &frame.wave_cells);
        self.air.prepare(&frame.uniform);
        self.sky.prepare(&frame.uniform);
        self.view.prepare(&frame.uniform);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.air.dispatch(&mut pass, &group);
            self.sky.dispatch(&mut pass, &group, &self.air.group);
            self.view.dispatch(&mut pass, &group, &self.air.group);
        }
        self.gpu.queue.submit([encoder.finish()]);
        self.kernel.run(&self.gpu, &[&group, &self.tables], inputs)
    }
}

/// An eye 2 m to 38,000 km high over any place, at any hour of a day.
fn eye(index: usize) -> (Camera, f64) {
    let [lat, lon, height, hour] = spread::<4>(index);
    let camera = Camera::from_degrees(
        (2.0 * lat - 1.0).asin().to_degrees(),
        360.0 * lon - 180.0,
        2.0 * 1.9e7f64.powf(height),
        0.0,
        80.0,
    );
    (camera, 1_795_176_000.0 + 86_400.0 * hour)
}

/// Rays from an eye to the sky, and to places of the sea and of land up to 5 km high.
fn rays(camera: &Camera, count: usize) -> Vec<Ray> {
    let local = earth::ecef_from_enu(camera.lat, camera.lon).transpose();
    let position = camera.eye_ecef();
    let height = camera.altitude_m;
    // Angles from the zenith, on a sphere, of the horizon and of the limb 100 km above it.
    let tangent = |lift: f64| {
        let sine = (WGS84.a + lift) / (WGS84.a + height);
        if sine < 1.0 { std::f64::consts::PI - sine.asin() } else { 0.0 }
    };
    let [horizon, top] = [tangent(0.0), tangent(1e5)];
    let mut rays = Vec::new();
    for index in 0..count {
        let [azimuth, x, y] = spread::<3>(index);
        let (sin, cos) = (std::f64::consts::TAU * azimuth).sin_cos();
        let sky = index % 2 == 0;
        let (direction, distance) = if sky {
            let zenith = horizon + (top - horizon) * x * x;
            (DVec3::new(zenith.sin() * sin, zenith.sin() * cos, zenith.cos()), f64::from(SKY))
        } else {
            // As far as the horizon of the eye, and of a mountain on the other side of it.
            let summit = if index % 4 == 1 { 0.0 } else { 5_000.0 * y * y };
            let reach = [height, summit].map(|h| (WGS84.a / (WGS84.a + h)).acos()).iter().sum::<f64>();
            let arc = reach * (1.0 - x * x).max(1e-9 * f64::from(u32::from(height < 1e3)));
            let turned = DVec3::new(arc.sin() * sin, arc.sin() * cos, arc.cos());
            let on = WGS84.geodetic_from_ecef(local.transpose() * turned * WGS84.a).unwrap();
            let point = WGS84.ecef_from_geodetic(Geodetic { height: summit, ..on });
            let way = local * (point - position);
            (way.normalize(), way.length())
        };
        rays.push(Ray { direction: direction.as_vec3().to_array(), distance: distance as f32 });
    }
    rays
}

/// The value that a share of the values do not exceed.
fn quantile(values: &mut [f32], share: f64) -> f32 {
    values.sort_by(f32::total_cmp);
    values[(share * (values.len() - 1) as f64).round() as usize]
}

/// Errors of radiance, relative, and of transmittance, absolute, over 96 eyes; the largest of the three colours'.
fn errors(kind: fn(&Ray) -> bool) -> [Vec<f32>; 2] {
    let mut air = Air::<4>::new(KERNEL, "compare");
    let mut errors = [Vec::new(), Vec::new()];
    for index in 0..96 {
        let (camera, unix_seconds) = eye(index);
        let frame = Frame::new(&Settings::default(), &camera, unix_seconds, [640, 360]);
        let rays: Vec<Ray> = rays(&camera, 1024).into_iter().filter(kind).collect();
        // Radiance and transmittance of the tables, then of the steps.
        let [seen, through, stepped_through, steps] = air.run(&frame, &rays);
        for at in (0..rays.len()).filter(|&at| seen[at][3] < 0.0) {
            let most = |error: &dyn Fn(usize) -> f32| (0..3).map(error).fold(0.0, f32::max);
            // A thousandth of sunlight is darker than any picture of the day shows.
            errors[0].push(most(&|i| (seen[at][i] - steps[at][i]).abs() / (steps[at][i] + 1e-3)));
            errors[1].push(most(&|i| (through[at][i] - stepped_through[at][i]).abs()));
        }
    }
    errors
}

// One of 255 levels of a display is 2 % of a middling radiance (gamma 2.2), and pictures may be off by 8.

#[test]
fn the_table_of_the_sky_is_what_steps_along_its_rays_are() {
    let [mut radiance, _] = errors(|ray| ray.distance == SKY);
    let [half, most] = [0.5, 0.99].map(|share| quantile(&mut radiance, share));
    println!("{} rays: half within {half:.4}, 99 % within {most:.4}", radiance.len());
    assert!(radiance.len() > 40_000, "only {} rays", radiance.len());
    // A quarter of a level, and four where the sun is down or behind the limb.
    assert!(half < 0.005 && most < 0.08, "{half} {most}");
}

#[test]
fn the_table_of_the_haze_is_what_steps_along_its_rays_are() {
    let [mut radiance, mut transmittance] = errors(|ray| ray.distance != SKY);
    let [half, most] = [0.5, 0.99].map(|share| quantile(&mut radiance, share));
    let [through, all_through] = [0.99, 1.0].map(|share| quantile(&mut transmittance, share));
    println!("{} rays: half within {half:.4}, 99 % within {most:.4}", radiance.len());
    println!("transmittance: 99 % within {through:.4}, all within {all_through:.4}");
    assert!(radiance.len() > 40_000, "only {} rays", radiance.len());
    // A level, and five at the limb and beyond the terminator.
    assert!(half < 0.02 && most < 0.1, "{half} {most}");
    // One and two levels of white.
    assert!(through < 0.02 && all_through < 0.05, "{through} {all_through}");
}

#[test]
fn a_turning_head_and_a_stopped_clock_need_no_other_tables() {
    let mut air = Air::<4>::new(KERNEL, "compare");
    let (camera, unix_seconds) = eye(5);
    let mut dispatches = |camera: Camera, unix_seconds: f64| {
        let frame = Frame::new(&Settings::default(), &camera, unix_seconds, [640, 360]);
        air.view.prepare(&frame.uniform);
        air.view.dispatches()
    };
    assert_eq!(dispatches(camera, unix_seconds), 2);
    assert_eq!(dispatches(camera, unix_seconds), 0);
    assert_eq!(dispatches(Camera { heading: 2.0, tilt: 1.0, ..camera }, unix_seconds), 0);
    assert_eq!(dispatches(Camera { altitude_m: 1.1 * camera.altitude_m, ..camera }, unix_seconds), 2);
    let hazy = Frame::new(&Settings { haze: 0.2, ..Settings::default() }, &camera, unix_seconds, [640, 360]);
    for looked in 0..2 {
        air.air.prepare(&hazy.uniform);
        air.sky.prepare(&hazy.uniform);
        // Tables that are made but for the haze: made for it once.
        let wanted = if looked == 0 { 2 } else { 0 };
        assert_eq!([air.air.dispatches(), air.sky.dispatches()], [wanted; 2]);
    }
    // The sun moves by a degree in four minutes.
    assert_eq!(dispatches(Camera { altitude_m: 1.1 * camera.altitude_m, ..camera }, unix_seconds + 240.0), 2);
}

#[test]
fn a_level_path_over_the_sea_is_as_hazy_as_an_oceans_air() {
    let mut air = Air::<4>::new(KERNEL, "compare");
    // The sun 40 degrees high.
    let frame = Frame::new(
        &Settings::default(),
        &Camera::from_degrees(0.0, -30.0, 10.0, 0.0, 0.0),
        1_774_027_650.0,
        [640, 360],
    );
    let sun = frame.uniform.light;
    assert!((sun.z.asin().to_degrees() - 40.0).abs() < 0.3, "{sun}");
    let across = glam::Vec3::new(-sun.y, sun.x, 0.0).normalize().to_array();
    let luminance = |[r, g, b, _]: [f32; 4]| f64::from(0.2126 * r + 0.7152 * g + 0.0722 * b);
    let ray = |distance| Ray { direction: across, distance };
    let [seen, through, _, _] = air.run(&frame, &[5e3, 1e4, 2e4, 5e4, SKY].map(ray));
    let horizon = luminance(seen[4]);
    // Of a spectral model of the same air: what is left of a light, and the air's own over the horizon's.
    let wanted = [(5.0, 0.67, 0.32), (10.0, 0.45, 0.54), (20.0, 0.21, 0.78), (50.0, 0.02, 0.96)];
    for ((km, left, added), (seen, through)) in wanted.into_iter().zip(seen.iter().zip(&through)) {
        let found = [luminance(*through), luminance(*seen) / horizon];
        println!("{km} km: {:.3} of {left} left, {:.3} of {added} added", found[0], found[1]);
        assert!((found[0] - left).abs() < 0.05 && (found[1] - added).abs() < 0.06, "{km} km: {found:?}");
    }
}

/// Of rays to the water: the air before it with spray in it, then the air alone, and the optical depth of the spray.
const SPRAYED: &str = "#import spray
const SPRAY = true;
@group(2) @binding(0) var<storage, read> rays: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> with_spray: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> alone: array<vec4f>;
@compute @workgroup_size(64)
fn compare(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&rays) { return; }
    let direction = rays[id.x].xyz;
    let distance = surface_hit(eye_ray(direction));
    let up = normal_delta(direction * distance) + vec3f(0.0, 0.0, 1.0);
    let dark = Daylight(vec3f(0.0), vec3f(0.0), 0.0, 1.0, 1.0, vec3f(0.0));
    let depth = spray_depth(direction.z, distance);
    // Without light of its own: spray_light's share is taken off.
    let seen = through_air(vec3f(0.0), dark, up, direction, distance);
    let air = haze(direction, distance);
    with_spray[id.x] = vec4f(seen - (1.0 - exp(-depth)) * spray_light(dark, up, direction) * air.transmittance, depth);
    alone[id.x] = vec4f(air.radiance, distance);
}";

#[test]
fn spray_far_below_takes_no_air_from_the_sight_of_it() {
    let mut air = Air::<2>::new(SPRAYED, "compare");
    let settings = Settings { beaufort: Some(8), ..Settings::default() };
    for altitude_m in [3e3, 3e4, 5e5] {
        let camera = Camera::from_degrees(0.0, -30.0, altitude_m, 0.0, 0.0);
        let frame = Frame::new(&settings, &camera, 1_774_027_650.0, [640, 360]);
        let rays = [1.0, 0.7, 0.4].map(|sine: f32| [(1.0 - sine * sine).sqrt(), 0.0, -sine, 0.0]);
        let [with_spray, alone] = air.run(&frame, &rays);
        for (found, wanted) in with_spray.iter().zip(&alone) {
            println!("{altitude_m} m, {:.0} m away, spray of {:.4}: {found:.5?}, {wanted:.5?}", wanted[3], found[3]);
            assert!(found[3] > 1e-3, "no spray: {found:?}");
            // Half of the spray's own depth along the sight is the most that its air can be nearer: some metres of many kilometres.
            assert!((0..3).all(|i| (found[i] / wanted[i] - 1.0).abs() < 0.01), "{altitude_m} m: {found:?}, {wanted:?}");
        }
    }
}
