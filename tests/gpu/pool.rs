//! The bisected mesh alone, without a picture: a pool, a frame to refine it for, and the checks that every mesh must pass.

use std::collections::{HashMap, HashSet};

use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::model::cuboid::{Point, Triangle, UNIT};
use ocean_globe::pass::bisect::{Bisect, Bisector, State, drawn_layout, source};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::frame::bisection::Bisection;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::{Mesh, Settings, Triangles, Wind};
use ocean_globe::scene::view::camera::Camera;

/// Base, left and right edge, as their ends.
pub fn edges([apex, left, right]: Triangle) -> [[Point; 2]; 3] {
    [[left, right], [apex, left], [right, apex]]
}

pub fn middle([a, b]: [Point; 2]) -> Point {
    std::array::from_fn(|i| ((u64::from(a[i]) + u64::from(b[i])) / 2) as u32)
}

pub struct Pool {
    pub gpu: Gpu,
    pub bisect: Bisect,
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
}

pub fn settings(pixels: f64, budget: u32) -> Settings {
    Settings {
        mesh: Mesh::Bisect,
        triangles: Triangles { pixels, budget },
        wind: Wind { speed_mps: 8.0, from_deg: 250.0 },
        ..Settings::default()
    }
}

pub fn frame(seas: &mut Seas, settings: &Settings, camera: &Camera) -> Frame {
    Frame::of(seas, settings, camera, 1_795_176_000.0, [640, 360])
}

impl Pool {
    pub fn new(capacity: u32) -> Self {
        Self::edited(capacity, |text| text)
    }

    /// A pool whose shader is changed.
    pub fn edited(capacity: u32, edit: impl Fn(String) -> String) -> Self {
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let layout = gpu.layout("frame", wgpu::ShaderStages::COMPUTE, &[Bind::Uniform]);
        let uniform = gpu.empty_buffer(
            "frame",
            wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            size_of::<ocean_globe::scene::frame::FrameUniform>() as u64,
        );
        let group = gpu.bind("frame", &layout, &[uniform.as_entire_binding()]);
        let drawn = drawn_layout(&gpu);
        let bisect = Bisect::of_shader(&gpu, &layout, &drawn, capacity, &edit(source()));
        Self { gpu, bisect, uniform, group }
    }

    /// `updates` updates for a frame.
    pub fn update(&self, frame: &Frame, updates: u32) {
        self.gpu.queue.write_buffer(&self.uniform, 0, bytemuck::bytes_of(&frame.uniform));
        self.bisect.prepare(&self.gpu, &frame.bisection.expect("a frame with a bisected mesh"));
        self.dispatch(updates);
    }

    pub fn update_with(&self, bisection: &Bisection, updates: u32) {
        self.bisect.prepare(&self.gpu, bisection);
        self.dispatch(updates);
    }

    fn dispatch(&self, updates: u32) {
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            for _ in 0..updates {
                self.bisect.dispatch(&mut pass, &self.group);
            }
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    pub fn state(&self) -> State {
        self.bisect.read_state(&self.gpu).unwrap()
    }

    /// The mesh, after the checks that every mesh must pass.
    pub fn mesh(&self) -> Vec<Bisector> {
        let mesh = self.bisect.read_mesh(&self.gpu).unwrap();
        check(&mesh);
        assert_eq!(self.state().live as usize, mesh.len(), "the sums differ from the bits");
        mesh
    }
}

pub fn triangles(mesh: &[Bisector]) -> HashSet<Triangle> {
    mesh.iter().map(|bisector| bisector.corners).collect()
}

/// Twice the area of a triangle on its face, and which face.
fn area(corners: Triangle) -> (usize, i128) {
    let end = |axis: usize| [0, 2 * UNIT].into_iter().find(|&end| corners.iter().all(|corner| corner[axis] == end));
    let (axis, end) = (0..3).find_map(|axis| Some((axis, end(axis)?))).expect("all corners on one face");
    let at = |corner: usize, a: usize| i128::from(corners[corner][(axis + a) % 3]);
    let side = |corner: usize| [1, 2].map(|a| at(corner, a) - at(0, a));
    let ([ux, uy], [vx, vy]) = (side(1), side(2));
    let outward = if end == 0 { -1 } else { 1 };
    (2 * axis + usize::from(end == 0), outward * (ux * vy - uy * vx))
}

/// Every edge belongs to exactly two triangles that know each other, so that no corner lies inside an edge; every triangle lies on a
/// face with its outside out, and together they are as large as the cuboid: no hole, no overlap.
pub fn check(mesh: &[Bisector]) {
    let at: HashMap<u32, &Bisector> = mesh.iter().map(|bisector| (bisector.slot, bisector)).collect();
    let mut owners: HashMap<[Point; 2], u32> = HashMap::new();
    let mut faces = [0i128; 6];
    for b in mesh {
        for edge in edges(b.corners) {
            assert!(owners.insert(edge, b.slot).is_none(), "two triangles on the same side of {edge:?}");
        }
        let (face, twice) = area(b.corners);
        assert!(twice > 0, "turned over: {b:?}");
        assert_eq!(twice, (1 << 61) >> b.depth, "depth of {b:?}");
        faces[face] += twice;
    }
    for b in mesh {
        for (edge, link) in edges(b.corners).into_iter().zip(b.links) {
            let across = owners.get(&[edge[1], edge[0]]);
            assert_eq!(across, Some(&link), "across {edge:?} of {b:?}, whose link is {:?}", at.get(&link));
        }
    }
    // A face is a square of side 2^31.
    assert_eq!(faces, [1 << 63; 6], "holes or overlaps");
}
