//! Where the wave patches lie: on the GPU to a millimetre, anywhere on earth and from any eye, against arithmetic with 106 bits.

use std::sync::Mutex;

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::model::noise;
use ocean_globe::model::wave_domain::{self, LEAST_SHARE, MAX_CELLS, PATCHES};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::frame::uniform::WaveCell;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::exact::{Exact, PI};

const KERNEL: &str = "#import domain
struct Found { at: vec2f, weight: f32, unused: f32, vertex: vec2i, unused_i: vec2i }
@group(1) @binding(0) var<storage, read> points: array<vec4f>;    // local, cell
@group(1) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn locate(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let plane = plane_of(u32(points[id.x].w));
    for (var index = 0u; index < PATCHES; index++) {
        let spacing = select(frame.spacings[index & 3u], frame.perlin_spacing, index == PERLIN_PATCH);
        let patch_length = select(frame.patches[index & 3u], frame.perlin_patch, index == PERLIN_PATCH);
        let triangle = lattice_triangle(plane, index, spacing, in_plane(plane, points[id.x].xyz));
        for (var k = 0u; k < 3u; k++) {
            let placed = placement(plane, index, spacing, patch_length, triangle, k);
            let down = select(0, 1, triangle.down);
            let which = vec2i(i32(triangle.order[k] == 1u), i32(triangle.order[k] == 2u));
            let vertex = triangle.corner + select(which, vec2i(1) - which, triangle.down);
            found[(id.x * PATCHES + index) * 3u + k] = Found(placed.at, triangle.weights[k], 0.0, vertex, vec2i(down));
        }
    }
}";

/// A patch at a vertex on the GPU; `at` in patch lengths.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Found {
    at: [f32; 2],
    weight: f32,
    unused: f32,
    vertex: [i32; 2],
    unused_i: [i32; 2],
}

struct Domain {
    gpu: Gpu,
    layouts: [wgpu::BindGroupLayout; 2],
    pipeline: ocean_globe::gpu::pipeline::Compute,
}

impl Domain {
    fn new() -> Self {
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let stages = wgpu::ShaderStages::COMPUTE;
        let layouts = [
            gpu.layout("frame", stages, &[Bind::Uniform, Bind::Uniform]),
            gpu.layout("points", stages, &[Bind::Storage, Bind::StorageWrite]),
        ];
        let [pipeline] = gpu.compute("locate", &shader::composed(KERNEL, ""), &layouts.each_ref(), ["locate"]);
        Self { gpu, layouts, pipeline }
    }

    /// The patches under points (local to their cell's eye, cell), three vertices of each.
    fn locate(
        &self,
        frame: &Frame,
        wave_cells: &[WaveCell; MAX_CELLS],
        points: &[[f32; 4]],
    ) -> Vec<[[Found; 3]; PATCHES]> {
        use wgpu::BufferUsages as B;
        let gpu = &self.gpu;
        let uniform = gpu.buffer("frame", B::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let wave_cells = gpu.buffer("wave_cells", B::UNIFORM, bytemuck::cast_slice(wave_cells));
        let input = gpu.buffer("points", B::STORAGE, bytemuck::cast_slice(points));
        let size = (points.len() * PATCHES * 3 * size_of::<Found>()) as u64;
        let output = gpu.empty_buffer("found", B::STORAGE | B::COPY_SRC, size);
        let copy = gpu.empty_buffer("found", B::MAP_READ | B::COPY_DST, size);
        let groups = [
            gpu.bind("frame", &self.layouts[0], &[uniform.as_entire_binding(), wave_cells.as_entire_binding()]),
            gpu.bind("points", &self.layouts[1], &[input.as_entire_binding(), output.as_entire_binding()]),
        ];
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &groups[0], &[]);
            pass.set_bind_group(1, &groups[1], &[]);
            pass.dispatch_workgroups((points.len() as u32).div_ceil(64), 1, 1);
        }
        encoder.copy_buffer_to_buffer(&output, 0, &copy, 0, size);
        gpu.queue.submit([encoder.finish()]);
        let bytes = gpu.read_buffer(&copy).unwrap();
        let vertices: Vec<Found> = bytes.chunks_exact(size_of::<Found>()).map(bytemuck::pod_read_unaligned).collect();
        let patch = |k: usize| [vertices[k], vertices[k + 1], vertices[k + 2]];
        (0..points.len()).map(|p| std::array::from_fn(|t| patch((p * PATCHES + t) * 3))).collect()
    }
}

type Vector = [Exact; 3];

fn dot(a: Vector, b: Vector) -> Exact {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn ex(x: f64) -> Exact {
    Exact::from(x)
}

/// A place of the ellipsoid from its normal, `height` above it, with east, north and up.
fn place(normal: Vector, height: Exact) -> (Vector, [Vector; 3]) {
    let [x, y, z] = normal;
    let (a, b) = (ex(WGS84.a), ex(WGS84.b));
    let r = (x * x + y * y).sqrt();
    let n = (a * a * (x * x + y * y) + b * b * z * z).sqrt();
    let at = [(a * a / n + height) * x, (a * a / n + height) * y, (b * b / n + height) * z];
    (at, [[-y / r, x / r, ex(0.0)], [-z * x / r, -z * y / r, r], normal])
}

/// A cell's centre and axes from its address, and north near a place of its plane.
struct Frame106 {
    centre: Vector,
    axes: [Vector; 3],
    radius: Exact,
    side: f64,
}

impl Frame106 {
    fn new([face, i, j]: [i32; 3]) -> Self {
        let tan = |k: i32| {
            let (sin, cos) =
                (PI * ex(f64::from(2 * k + 1 - wave_domain::CELLS)) / ex(f64::from(4 * wave_domain::CELLS))).sin_cos();
            sin / cos
        };
        let out = ex(if face % 2 == 0 { 1.0 } else { -1.0 });
        let (x, y) = (tan(i), tan(j));
        let v = match face / 2 {
            0 => [out, x, y],
            1 => [x, out, y],
            _ => [x, y, out],
        };
        let length = dot(v, v).sqrt();
        let normal = v.map(|x| x / length);
        let (centre, axes) = place(normal, ex(0.0));
        let (a, b) = (ex(WGS84.a), ex(WGS84.b));
        let [x, y, z] = normal;
        let radius = a * a / (a * a * (x * x + y * y) + b * b * z * z).sqrt();
        Self { centre, axes, radius, side: z.0.signum() }
    }

    fn north(&self, x: Exact, y: Exact) -> [Exact; 2] {
        let (sin, cos) = (self.axes[2][2], self.axes[1][2]);
        let v = [-x * sin / self.radius, cos - y * sin / self.radius];
        let length = (v[0] * v[0] + v[1] * v[1]).sqrt();
        let north = v.map(|c| c / length);
        if length.0 >= wave_domain::POLAR_REACH {
            return north;
        }
        // Near a pole towards the prime meridian's.
        let t = length / ex(wave_domain::POLAR_REACH);
        let t = t * t * (ex(3.0) - t - t);
        let polar = [self.axes[0][0], self.axes[1][0]].map(|c| c * ex(-self.side));
        let mixed = [0, 1].map(|c| polar[c] + (north[c] - polar[c]) * t);
        let length = (mixed[0] * mixed[0] + mixed[1] * mixed[1]).sqrt();
        mixed.map(|c| c / length)
    }
}

/// PCG3D's first word, written anew from its paper.
fn word(p: [u32; 3]) -> u32 {
    let mut v = p.map(|x| ((u64::from(x) * 1_664_525 + 1_013_904_223) & 0xFFFF_FFFF) as u32);
    let add = |a: u32, b: u32, c: u32| ((u64::from(a) + u64::from(b) * u64::from(c)) & 0xFFFF_FFFF) as u32;
    v[0] = add(v[0], v[1], v[2]);
    v[1] = add(v[1], v[2], v[0]);
    v[2] = add(v[2], v[0], v[1]);
    for x in &mut v {
        *x ^= *x >> 16;
    }
    add(v[0], v[1], v[2])
}

/// A point seen from an eye, its cell, and the sea around it.
struct Sight<'a> {
    settings: &'a Settings,
    patches_m: [f64; PATCHES],
    address: [i32; 3],
    camera: Camera,
    local: [f32; 3],
}

impl Sight<'_> {
    /// The patches of the GPU against exact ones: the worst error of a patch's place, metres, and of a weight in metres of way.
    fn errors(&self, found: &[[Found; 3]; PATCHES]) -> (f64, f64) {
        let (sin_lat, cos_lat) = ex(self.camera.lat).sin_cos();
        let (sin_lon, cos_lon) = ex(self.camera.lon).sin_cos();
        let (eye, enu) = place([cos_lat * cos_lon, cos_lat * sin_lon, sin_lat], ex(self.camera.altitude_m));
        let local = self.local.map(|x| ex(f64::from(x)));
        let frame = Frame106::new(self.address);
        let away: Vector = std::array::from_fn(|c| {
            eye[c] - frame.centre[c] + local[0] * enu[0][c] + local[1] * enu[1][c] + local[2] * enu[2][c]
        });
        let q = [dot(away, frame.axes[0]), dot(away, frame.axes[1])];
        let (wind_sin, wind_cos) = (ex(self.settings.wind.from_deg) * PI / ex(180.0)).sin_cos();
        let [face, i, j] = self.address;
        let key = (noise::bits(self.settings.seed, 1_000, face * 65_536 + i * 256 + j, 0)[0] >> 32) as u32;
        let (mut place_m, mut weight_m) = (0.0f64, 0.0f64);
        for (patch, vertices) in found.iter().enumerate() {
            let (length, spacing) = (self.patches_m[patch], wave_domain::spacing_m(self.patches_m[patch]));
            let mut shares = [0.0; 3];
            for (share, found) in shares.iter_mut().zip(vertices) {
                let [i, j] = found.vertex.map(f64::from);
                let vertex = [ex(spacing * (i + 0.5 * j)), ex(spacing * 0.875 * j)];
                let arm = [q[0] - vertex[0], q[1] - vertex[1]];
                let north = frame.north(vertex[0], vertex[1]);
                let level = [arm[0] * north[1] - arm[1] * north[0], arm[0] * north[0] + arm[1] * north[1]];
                let along = -wind_sin * level[0] - wind_cos * level[1];
                let left = wind_cos * level[0] - wind_sin * level[1];
                let bits = word([
                    found.vertex[0] as u32,
                    found.vertex[1] as u32,
                    key.wrapping_add((patch as u32).wrapping_mul(0x9E37_79B9)),
                ]);
                let offset =
                    [f64::from(bits >> 16), f64::from(bits & 0xFFFF)].map(|x| ex((x / 65_536.0 - 0.5) * length));
                for (got, want) in found.at.into_iter().zip([along + offset[0], left + offset[1]]) {
                    let error = (ex(f64::from(got) * length) - want).0;
                    // Vertices that do not serve may be farther off than a patch.
                    if found.weight > 0.0 {
                        place_m = place_m.max(error.abs());
                    }
                }
                // The lattice's own hat function: one less the hexagonal distance.
                let v = (arm[1] / ex(0.875 * spacing)).0;
                let u = (arm[0] / ex(spacing)).0 - 0.5 * v;
                *share = (1.0 - u.abs().max(v.abs()).max((u + v).abs()) - LEAST_SHARE).max(0.0);
            }
            let norm = shares.iter().map(|s| s * s).sum::<f64>().sqrt();
            for (share, found) in shares.into_iter().zip(vertices) {
                weight_m = weight_m.max(spacing * (share / norm - f64::from(found.weight)).abs());
            }
        }
        (place_m, weight_m)
    }
}

fn patches_m(frame: &Frame) -> [f64; PATCHES] {
    let tables = &frame.sea;
    std::array::from_fn(|patch| tables.cascades.get(patch).map_or(tables.perlin.patch_m, |cascade| cascade.patch_m))
}

/// Places evenly over the sphere, degrees, after those where a careless globe breaks.
fn places(count: usize) -> impl Iterator<Item = [f64; 2]> {
    let special = [
        [0.0, 0.0],
        [0.0, 180.0],
        [-33.0, -180.0],
        [90.0, 0.0],
        [-90.0, 0.0],
        [89.999_999, 77.0],
        [-89.3, 123.0],
        [89.2, 180.0],
        [35.264_389_682_754_65, 45.0],
        [-35.264_389_682_754_65, 135.0],
        [0.0, 45.0],
        [45.0, 0.0],
        [-45.0, 90.0],
    ];
    let spread = (0..count).map(|n| {
        let [u, v] = noise::bits(9, 1, n as i32, 0).map(|bits| (bits >> 11) as f64 / (1u64 << 53) as f64);
        [(2.0 * u - 1.0).asin().to_degrees(), 360.0 * v - 180.0]
    });
    special.into_iter().chain(spread)
}

#[test]
fn sines_and_roots_have_more_than_a_hundred_bits() {
    // Of mpmath with 50 digits: sin 2.5, cos 2.5, sqrt 7, each less its double.
    let (sin, cos) = ex(2.5).sin_cos();
    for (got, high, low) in [
        (sin, 0.598_472_144_103_956_5, -5.521403334082375e-17),
        (cos, -0.801_143_615_546_933_7, -1.8674742705085553e-17),
        (ex(7.0).sqrt(), 2.645_751_311_064_590_6, -1.2566948082017735e-16),
    ] {
        let error = got - Exact(high, low);
        assert!(error.0.abs() < 2f64.powi(-100), "{error:?}");
    }
}

/// The program keeps the tables of one sea: tests that take turns do not make them anew for every frame.
static TURN: Mutex<()> = Mutex::new(());

#[test]
fn patches_lie_to_a_millimetre_at_ten_thousand_places() {
    let _turn = TURN.lock();
    let domain = Domain::new();
    let (mut worst, mut worst_weight, mut seen) = (0.0f64, 0.0f64, 0);
    let mut seas = Seas::default();
    // The far sea's patch is longest in a hurricane.
    for (beaufort, count) in [(8, 10_000), (12, 2_000)] {
        let settings = Settings { beaufort: Some(beaufort), seed: 5, ..Settings::default() };
        let all: Vec<[f64; 2]> = places(count).collect();
        // Each place has a cell of its own: as many share a dispatch as a frame has room for.
        for group in all.chunks(MAX_CELLS) {
            let mut wave_cells = [WaveCell::default(); MAX_CELLS];
            let (mut points, mut sights, mut frame) = (Vec::new(), Vec::new(), None);
            for (slot, [lat, lon]) in group.iter().enumerate() {
                let camera = Camera::from_degrees(*lat, *lon, 5.0, 0.0, 0.0);
                let here = Frame::of(&mut seas, &settings, &camera, 0.0, [64, 64]);
                wave_cells[slot] = here.wave_cells[0];
                let turn = 2.4 * sights.len() as f64;
                for out in [0.0, 20.0, 300.0] {
                    let local = [(out * turn.cos()) as f32, (out * turn.sin()) as f32, -5.0];
                    let address = here.foam_eye.frame.0;
                    points.push([local[0], local[1], local[2], slot as f32]);
                    sights.push(Sight { settings: &settings, patches_m: patches_m(&here), address, camera, local });
                }
                frame = Some(here);
            }
            for (sight, found) in sights.iter().zip(domain.locate(&frame.unwrap(), &wave_cells, &points)) {
                let (error, weight) = sight.errors(&found);
                assert!(error < 1e-3, "{:?}: {error} m", sight.camera);
                worst = worst.max(error);
                worst_weight = worst_weight.max(weight);
                seen += 1;
            }
        }
    }
    println!("{seen} points: patches within {:.3} mm, weights within {:.3} mm of way", 1e3 * worst, 1e3 * worst_weight);
    // A weight changes by up to 3.5 per spacing; of a point whose f32 place is off by up to a millimetre, with the
    // weights' own rounding of 2^-23 of a spacing of up to 6.4 km on top.
    assert!(worst_weight < 8e-3, "{worst_weight} m");
}

#[test]
fn a_place_has_the_same_patches_for_every_eye() {
    let _turn = TURN.lock();
    let domain = Domain::new();
    let settings = Settings { beaufort: Some(8), ..Settings::default() };
    let (mut worst, mut seas) = (0.0f64, Seas::default());
    for [lat, lon] in places(200) {
        let foot = |camera: &Camera| {
            let geodetic = Geodetic { height: 0.0, ..Camera::from_degrees(lat, lon, 0.0, 0.0, 0.0).geodetic() };
            let enu = earth::ecef_from_enu(camera.lat, camera.lon).transpose();
            (enu * (WGS84.ecef_from_geodetic(geodetic) - camera.eye_ecef())).as_vec3()
        };
        let near = Camera::from_degrees(lat, lon, 5.0, 0.0, 0.0);
        let frame = Frame::of(&mut seas, &settings, &near, 0.0, [64, 64]);
        // An eye has no memory: whatever was seen before, the cells have the same bits.
        let again = Frame::of(&mut seas, &settings, &near, 0.0, [64, 64]);
        assert_eq!(bytemuck::cast_slice::<_, u8>(&frame.wave_cells), bytemuck::cast_slice::<_, u8>(&again.wave_cells));
        let mut seen = |camera: Camera| {
            let frame = Frame::of(&mut seas, &settings, &camera, 0.0, [64, 64]);
            let p = foot(&camera);
            // The cell that is nearest to the place, among the eye's.
            let cells = wave_domain::cells_near(camera.lat, camera.lon);
            let slot =
                cells.iter().position(|cell| cell.address == wave_domain::cells_near(near.lat, near.lon)[0].address);
            let slot = slot.expect("the eye has the cell");
            (patches_m(&frame), domain.locate(&frame, &frame.wave_cells, &[[p.x, p.y, p.z, slot as f32]])[0])
        };
        // Eyes 5 m above the place, 5 km above it, and 5 km beside it.
        let (patches_m, close) = seen(near);
        let beside = Camera {
            altitude_m: 30.0,
            ..Camera::from_degrees((lat - 0.04 * lat.signum()).clamp(-90.0, 90.0), lon, 30.0, 0.0, 0.0)
        };
        for far in [Camera { altitude_m: 5_000.0, ..near }, beside] {
            let (_, far) = seen(far);
            for ((length, close), far) in patches_m.into_iter().zip(close).zip(far) {
                for vertex in close.iter().filter(|vertex| vertex.weight > 0.01) {
                    let same = far.iter().find(|found| found.vertex == vertex.vertex).expect("the same vertices serve");
                    for (a, b) in vertex.at.into_iter().zip(same.at) {
                        worst = worst.max(length * f64::from(a - b).abs());
                    }
                }
            }
        }
    }
    println!("from 5 km away patches lie within {:.3} mm of where they lie from 5 m", 1e3 * worst);
    // A millimetre each for two eyes, and 5 km in f32: each coordinate is rounded by up to 0.25 mm, and so is its share of the plane's axes.
    assert!(worst < 3e-3, "{worst} m");
}
