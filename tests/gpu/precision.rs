//! Positions on the GPU: relative to the eye, nothing is lost to 32-bit floats anywhere on earth.

use glam::{DVec2, DVec3};
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::tile::{MapPoint, Projection};
use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::shader;
use ocean_globe::model::earth::{self, Geodetic, WGS84};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::Kernel;

/// Places where a careless globe breaks: latitude and longitude, degrees.
const PLACES: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [0.0, 180.0],
    [-0.0001, -179.99999],
    [89.9, 30.0],
    [-89.99, -120.0],
    [83.99, 10.0],
    [51.5, 4.0],
    [-60.0, 179.9999],
];

/// For each local point: its map point (square, u, v), and the local point that comes back from it.
const KERNEL: &str = "#import map
@group(1) @binding(0) var<storage, read> points: array<vec4f>;
@group(1) @binding(1) var<storage, read_write> found: array<vec4u>;
@group(1) @binding(2) var<storage, read_write> back: array<vec4f>;
@compute @workgroup_size(64)
fn locate(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) { return; }
    let point = map_point(normal_delta(points[id.x].xyz));
    found[id.x] = vec4u(point.square, point.at, 0u);
    back[id.x] = vec4f(surface_from_normal_delta(normal_delta_at(point)), 0.0);
}";

struct Located {
    map: [u32; 4],
    back: DVec3,
}

fn located(gpu: &Gpu, frame: &Frame, points: &[DVec3]) -> Vec<Located> {
    let layout = gpu.layout("frame", wgpu::ShaderStages::COMPUTE, &[Bind::Uniform]);
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let group = gpu.bind("frame", &layout, &[uniform.as_entire_binding()]);
    let kernel = Kernel::<2>::new(gpu, &shader::composed(KERNEL, ""), "locate", &[&layout]);
    let list: Vec<[f32; 4]> = points.iter().map(|p| p.as_vec3().extend(0.0).to_array()).collect();
    let [found, back] = kernel.run::<_, [u32; 4]>(gpu, &[&group], &list);
    let local = |[x, y, z, _]: [u32; 4]| DVec3::from([x, y, z].map(|bits| f64::from(f32::from_bits(bits))));
    found.into_iter().zip(back).map(|(map, back)| Located { map, back: local(back) }).collect()
}

#[test]
fn map_coordinates_near_the_eye_are_good_to_centimetres() {
    let gpu = pollster::block_on(Gpu::headless()).unwrap();
    for [lat_deg, lon_deg] in PLACES {
        let camera = Camera::from_degrees(lat_deg, lon_deg, 2.0, 0.0, 80.0);
        let frame = Frame::new(&Settings::default(), &camera, 0.0, [640, 360]);
        let enu = earth::ecef_from_enu(camera.lat, camera.lon);
        // Points of the ellipsoid 1 m to 5 km from the eye, all around; the f32 that the GPU gets is the truth.
        let mut points = Vec::new();
        for (ring, bearing) in (0..8).flat_map(|ring| (0..16).map(move |b| (ring, b))) {
            let (sin, cos) = (f64::from(bearing) * 0.4).sin_cos();
            let out = 3.4f64.powi(ring);
            let level = WGS84.ecef_from_geodetic(Geodetic { lat: camera.lat, lon: camera.lon, height: 0.0 })
                + enu * DVec3::new(out * sin, out * cos, 0.0);
            let on = WGS84.geodetic_from_ecef(level).unwrap();
            let point = WGS84.ecef_from_geodetic(Geodetic { height: 0.0, ..on });
            points.push((enu.transpose() * (point - camera.eye_ecef())).as_vec3().as_dvec3());
        }
        let (mut worst_map, mut worst_back) = (0.0f64, 0.0f64);
        for (p, got) in points.iter().zip(located(&gpu, &frame, &points)) {
            let place = WGS84.geodetic_from_ecef(camera.eye_ecef() + enu * *p).unwrap();
            let projection = Projection::ALL[got.map[0] as usize];
            let want = MapPoint::on(projection, place.lat, place.lon);
            let off = |a: u32, b: u32| f64::from(a.wrapping_sub(b) as i32);
            // In texels of the deepest level that a page table holds (11), 2^13 units each.
            let texels = DVec2::new(off(got.map[1], want.u), off(got.map[2], want.v)).length() / 8192.0;
            worst_map = worst_map.max(texels);
            worst_back = worst_back.max((got.back - *p).length());
        }
        println!("{lat_deg},{lon_deg}: map {worst_map:.2e} texels of level 11, back {worst_back:.4} m");
        // 5 km in f32 is good to 0.3 mm and a map unit is 9 mm: 3 units, that is 4e-4 texels. Towards the end of the Mercator
        // square 1 - sin^2 keeps only 6e-8 / 0.011 of itself, 3 cm in 5 km, where a unit is 1 mm: 4e-3 texels. A tenth of a texel
        // of any level down to 15 would still hold.
        assert!(worst_map < 5e-3, "{lat_deg},{lon_deg}: {worst_map} texels");
        // There and back: up to a unit of each coordinate (9.3 mm at the equator, so 13.2 mm in all), or the 3 cm above.
        assert!(worst_back < 0.03, "{lat_deg},{lon_deg}: {worst_back} m");
    }
}

#[test]
fn lonlat_is_right_to_a_pixel_from_deck_to_orbit() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let mut renderer = render::headless(data, Radiance::Single).unwrap();
    let size = [160u32, 90];
    let extent = DVec2::new(160.0, 90.0);
    let views = [
        "0.5,-20,2,30,80",
        "0,180,2,200,80",
        "89.9,30,2,90,80",
        "35.7,-14,560,0,70",
        "-20,-179.9,30000,90,60",
        "15,-30,3e6,0,10",
        "20,-30,3e7",
        "88,0,3e6",
    ];
    for view in views {
        let state = render::parse_state(&format!("#view={view}&clouds=0&bft=0&time=2026-06-21T12:00:00Z")).unwrap();
        let measured = render::measure(&mut renderer, &state, size, LayerName::Lonlat).unwrap();
        let (mut worst, mut seen, mut missed) = (0.0f64, 0, 0);
        for (y, x) in (0..90usize).flat_map(|y| (0..160usize).map(move |x| (y, x))) {
            let pixel = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
            let index = 2 * (y * 160 + x);
            let (lon, lat) = (measured.values[index], measured.values[index + 1]);
            let hit = state.camera.unproject(pixel, extent);
            if lon.is_nan() != hit.is_none() {
                missed += 1;
            }
            if lon.is_nan() || hit.is_none() {
                continue;
            }
            let place = Geodetic { lat: lat.to_radians(), lon: lon.to_radians(), height: 0.0 };
            let Some(back) = state.camera.project(place, extent) else {
                panic!("{view}: {lat},{lon} is behind the eye")
            };
            worst = worst.max(back.distance(pixel));
            seen += 1;
        }
        println!("{view}: worst {worst:.3} pixels over {seen}, {missed} on the other side of the limb");
        // Land stands above the ellipsoid that `project` assumes: views of land would be off by its parallax, these are at sea
        // or from far. At the limb and the horizon a pixel's centre may fall on either side.
        assert!(seen > 1000, "{view}: only {seen} pixels");
        assert!(worst < 1.0, "{view}: {worst} pixels");
        assert!(missed <= 170, "{view}: {missed}");
    }
}
