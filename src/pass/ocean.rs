//! The sea: a grid projected from the screen onto the ellipsoid, or the bisected mesh, over the scene that land and sky have left; and a lake, by
//! the same grid on a surface that is higher.
//!
//! Its pixels are dear and its triangles a few pixels wide, of which hardware shades whole squares. So where a pixel has one sample the mesh only
//! leaves its place in each, and one triangle over the picture shades them: [`Shading`].

use std::collections::HashMap;

use super::look::Look;
use crate::gpu::mesh::grid_triangles;
use crate::gpu::pipeline::{Bind, Depth, DepthTest, Drawing};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::earth::WGS84;
use crate::model::sea_bed::smoothstep;
use crate::scene::frame::uniform::FrameUniform;
use crate::scene::settings::Mesh;

/// What shades the sea.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shading {
    /// The mesh itself, so many samples of each pixel.
    OfMesh(u32),
    /// A pass over the places that the mesh has left in the pixels, which have one sample. Only fine pictures from above that show no lake's mesh:
    /// what is no sea hides what lies behind it there.
    OfPlaces,
}

impl Shading {
    /// Whether the sea of a look may be shaded by its places.
    pub fn of_places(look: Look) -> bool {
        look.kind.fine && !look.kind.measured && !look.kind.under_water && !look.lake
    }
}

fn definitions(look: Look) -> String {
    look.definitions() + &format!("const FOAM: bool = {};\n", look.foam)
}

/// The composed shader, shading the mesh.
pub fn source(look: Look) -> String {
    if look.lake {
        return shader::composed(include_str!("../../shaders/lake.wgsl"), &look.definitions());
    }
    shader::composed(include_str!("../../shaders/ocean.wgsl"), &definitions(look))
}

/// The composed shaders that leave places and shade them.
pub fn sources_of_places(look: Look) -> [String; 2] {
    [include_str!("../../shaders/sea_places.wgsl"), include_str!("../../shaders/sea_of_places.wgsl")]
        .map(|source| shader::composed(source, &definitions(look)))
}

/// The pass.
pub struct Ocean {
    layouts: [wgpu::BindGroupLayout; 4],
    /// Of the scene and the places.
    places_layout: wgpu::BindGroupLayout,
    formats: [wgpu::TextureFormat; 2],
    pipelines: HashMap<(Mesh, Look, Shading), Drawing>,
    /// What shades places.
    shades: HashMap<Look, Drawing>,
    places: Option<Places>,
    scene: Option<wgpu::BindGroup>,
    /// What stands in its place for an eye in the water.
    below: Option<wgpu::BindGroup>,
    cells: [u32; 2],
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
}

/// Of two texels of a pixel, see `shaders/lib/places.wgsl`: as much as the default limits let a pass write.
const PLACES_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// Where the mesh is in each pixel.
struct Places {
    views: [wgpu::TextureView; 2],
    /// With the scene.
    group: wgpu::BindGroup,
}

/// Columns and rows of the grid of a picture of `size` pixels.
pub fn grid_cells(size: [u32; 2], cell_pixels: u32) -> [u32; 2] {
    size.map(|pixels| pixels.div_ceil(cell_pixels).max(16))
}

/// Share of the grid below the lower edge, in calm water and among waves that reach into the screen. As `shaders/lib/projected_grid.wgsl`.
pub const LOW_RIM: [f32; 2] = [0.02, 0.35];
/// How far the even part of the grid reaches, in device units, and how much farther above.
pub const EDGE: f32 = 1.02;
/// See [`EDGE`].
pub const EDGE_ABOVE: f32 = 0.03;
const ROWS_BY_HORIZON: [f64; 2] = [0.85, 2.0];
const HORIZON_BAND: [f64; 2] = [0.25, 0.06];
const LEAST_ROWS: f64 = 0.02;
const SEEN_FROM_M: [f64; 2] = [300.0, 3_000.0];

/// Device coordinate of a row of the even part of the grid, a share of all from the lowest; as `row_at` of `shaders/lib/projected_grid.wgsl`, which has
/// the reasons.
fn row_at(u: &FrameUniform, share: f32) -> f32 {
    let [lowest, uppermost] = [-EDGE, EDGE + EDGE_ABOVE].map(f64::from);
    let height = f64::from(u.eye_altitude + u.projector_rise).max(0.0);
    let [from, to] = SEEN_FROM_M.map(f64::ln);
    let seen = 1.0 - smoothstep(from, to, (height + 1.0).ln());
    let below = -f64::from(u.ray_forward.z).clamp(-1.0, 1.0).asin() - (2.0 * height / WGS84.b).sqrt();
    let horizon = below.clamp(-1.5, 1.5).tan() / f64::from(u.ray_up.length());
    let [first, last] =
        [horizon - HORIZON_BAND[0], horizon + HORIZON_BAND[1]].map(|device| device.clamp(lowest, uppermost));
    let near = seen * (last - first) / (HORIZON_BAND[0] + HORIZON_BAND[1]);
    let rows = ROWS_BY_HORIZON.map(|rows| 1.0 + near * (rows - 1.0));
    let [before, band] = [rows[0] * (first - lowest), rows[1] * (last - first)];
    let sky = (uppermost - lowest - before - band).max(LEAST_ROWS * (uppermost - last));
    let row = f64::from(share) * (before + band + sky);
    let above = (row - before - band).max(0.0) / sky.max(1e-6) * (uppermost - last);
    (lowest + row.min(before) / rows[0] + (row - before).clamp(0.0, band) / rows[1] + above) as f32
}

/// Rows above the horizon that are drawn, in cells: the strip on it and the way back down (`STRIP_ROWS`), and as many again for the
/// ellipsoid's flattening and for the 16 pixels beyond the limb.
const ROWS_ABOVE: f32 = 12.0;

/// How many of the grid's `rows`, counted from the lowest, hold any sea: those far above the horizon all lie on it.
pub fn rows_to_draw(u: &FrameUniform, rows: u32, under_water: bool) -> u32 {
    if under_water {
        return rows;
    }
    let low_rim = LOW_RIM[usize::from(u.rim_reach > 0.0)];
    let height = (u.eye_altitude + u.projector_rise).max(0.0);
    let dip = (u.semi_major / (u.semi_major + height)).acos();
    // From space the horizon of an ellipsoid is up to 1/298 rad off that of a sphere.
    let least = (ROWS_ABOVE * 1.05 * u.cell_pixels * u.pixel_angle / (1.0 - low_rim) + 0.004 * dip.min(1.0)) - dip;
    let above = |row: &u32| {
        let y = *row as f32 / rows as f32;
        let device = row_at(u, ((y - low_rim) / (1.0 - low_rim)).max(0.0));
        let elevation = |x: f32| (u.ray_forward + x * u.ray_right + device * u.ray_up).normalize().z.asin();
        y > low_rim && elevation(0.0).min(elevation(EDGE)).min(elevation(-EDGE)) > least
    };
    // The first row that lies too high is the upper edge of the last that does not.
    let kept = rows - (0..rows).rev().take_while(above).count() as u32;
    (kept + 1).min(rows)
}

fn mesh([columns, rows]: [u32; 2]) -> (Vec<[f32; 2]>, Vec<u32>) {
    let at = |i: u32, n: u32| 2.0 * i as f32 / n as f32 - 1.0;
    let row = |j: u32| (0..=columns).map(move |i| [at(i, columns), at(j, rows)]);
    ((0..=rows).flat_map(row).collect(), grid_triangles(columns, rows))
}

impl Ocean {
    /// The pass into `formats` of colour and depth; `frame` and `surface` are the layouts of bind groups 0 and 1, `triangles`
    /// that of the bisected mesh.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        triangles: &wgpu::BindGroupLayout,
        formats: [wgpu::TextureFormat; 2],
    ) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2), Bind::Depth];
        let scene = gpu.layout("scene", wgpu::ShaderStages::FRAGMENT, &binds);
        let [colour, depth] = binds;
        let binds = [colour, depth, Bind::Words(wgpu::TextureViewDimension::D2Array)];
        let places_layout = gpu.layout("places", wgpu::ShaderStages::FRAGMENT, &binds);
        let empty = |usage| gpu.empty_buffer("sea grid", usage, 4);
        Self {
            layouts: [frame.clone(), surface.clone(), scene, triangles.clone()],
            places_layout,
            formats,
            pipelines: Default::default(),
            shades: Default::default(),
            places: None,
            scene: None,
            below: None,
            cells: [0; 2],
            vertices: empty(wgpu::BufferUsages::VERTEX),
            indices: empty(wgpu::BufferUsages::INDEX),
            index_count: 0,
        }
    }

    /// Compiles what a mesh is drawn and shaded with, once: it takes a while, and most pictures need only one of them.
    pub fn prepare(&mut self, gpu: &Gpu, mesh: Mesh, look: Look, shading: Shading) {
        let Self { layouts, places_layout, formats: [colour, depth], pipelines, shades, .. } = self;
        let tested = |test, samples| Some(Depth { format: *depth, test, samples });
        if shading == Shading::OfPlaces {
            shades.entry(look).or_insert_with(|| {
                let [_, source] = sources_of_places(look);
                let groups = [&layouts[0], &layouts[1], &*places_layout];
                gpu.drawing("sea of places", (&source, "vertex"), &groups, &[], *colour, tested(DepthTest::Drawn, 1))
            });
        }
        pipelines.entry((mesh, look, shading)).or_insert_with(|| {
            let attributes = wgpu::vertex_attr_array![0 => Float32x2];
            let grid = wgpu::VertexBufferLayout {
                array_stride: 8,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &attributes,
            };
            let (vertex, groups, buffers) = match mesh {
                Mesh::Grid => ("vertex_of_grid", 3, vec![grid]),
                Mesh::Bisect => ("vertex_of_bisection", 4, Vec::new()),
            };
            let groups: Vec<_> = layouts.iter().take(groups).collect();
            let nearest = |samples| tested(DepthTest::Nearest, samples);
            match shading {
                Shading::OfMesh(samples) => {
                    gpu.drawing("ocean", (&source(look), vertex), &groups, &buffers, *colour, nearest(samples))
                }
                Shading::OfPlaces => {
                    let [source, _] = sources_of_places(look);
                    let targets = [0, 1].map(|_| PLACES_FORMAT.into());
                    gpu.drawing_into("places", (&source, vertex), &groups, &buffers, &targets, nearest(1), 1)
                }
            }
        });
    }

    /// Where places go, where there are any.
    pub fn places(&self) -> Option<&[wgpu::TextureView; 2]> {
        self.places.as_ref().map(|places| &places.views)
    }

    /// Takes the scene's colour and depth, and the map of caustics, which an eye in the water sees in the colour's place; makes places for a picture
    /// of so many pixels, where the sea is shaded by them.
    pub fn set_scene(
        &mut self,
        gpu: &Gpu,
        [colour, caustics, depth]: [&wgpu::TextureView; 3],
        places: Option<[u32; 2]>,
    ) {
        self.places = places.map(|[width, height]| {
            let shape = Shape { depth: 2, ..Shape::picture(width, height) };
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
            let places = gpu.texture("places", shape, PLACES_FORMAT, usage);
            let whole = texture::array_view(&places);
            let group = [colour, depth, &whole].map(wgpu::BindingResource::TextureView);
            let views = [0, 1].map(|layer| texture::picture_view(&places, layer));
            Places { views, group: gpu.bind("places", &self.places_layout, &group) }
        });
        let group =
            |colour| gpu.bind("scene", &self.layouts[2], &[colour, depth].map(wgpu::BindingResource::TextureView));
        (self.scene, self.below) = (Some(group(colour)), Some(group(caustics)));
    }

    /// Makes the grid of a picture of `size` pixels, unless it is there.
    pub fn set_grid(&mut self, gpu: &Gpu, size: [u32; 2], cell_pixels: u32) {
        let cells = grid_cells(size, cell_pixels);
        if cells != self.cells {
            let (vertices, indices) = mesh(cells);
            self.vertices = gpu.buffer("sea grid", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices));
            self.indices = gpu.buffer("sea indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices));
            self.index_count = indices.len() as u32;
            self.cells = cells;
        }
    }

    /// Vertices and triangles of the grid.
    pub fn grid_counts(&self) -> [u32; 2] {
        [self.cells.map(|n| n + 1).iter().product(), self.index_count / 3]
    }

    /// Shades the places that [`Ocean::draw`] has left, one draw.
    pub fn shade(
        &self,
        pass: &mut wgpu::RenderPass,
        look: Look,
        frame_group: &wgpu::BindGroup,
        surface: &wgpu::BindGroup,
    ) {
        let (Some(pipeline), Some(places)) = (self.shades.get(&look), &self.places) else { return };
        pass.set_pipeline(pipeline);
        [frame_group, surface, &places.group]
            .into_iter()
            .zip(0..)
            .for_each(|(group, i)| pass.set_bind_group(i, group, &[]));
        pass.draw(0..3, 0..1);
    }

    /// One draw of the grid, or of `triangles`: their bind group and the arguments of the draw. `frame_group` holds the frame's `block`.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass,
        (block, look, shading): (&FrameUniform, Look, Shading),
        frame_group: &wgpu::BindGroup,
        surface: &wgpu::BindGroup,
        triangles: Option<(&wgpu::BindGroup, &wgpu::Buffer)>,
    ) {
        let mesh = if triangles.is_some() { Mesh::Bisect } else { Mesh::Grid };
        let Some(pipeline) = self.pipelines.get(&(mesh, look, shading)) else { return };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, frame_group, &[]);
        pass.set_bind_group(1, surface, &[]);
        let below = look.kind.under_water && !look.kind.measured;
        pass.set_bind_group(2, if below { &self.below } else { &self.scene }, &[]);
        if let Some((group, arguments)) = triangles {
            pass.set_bind_group(3, group, &[]);
            pass.draw_indirect(arguments, 0);
            return;
        }
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..6 * self.cells[0] * rows_to_draw(block, self.cells[1], look.kind.under_water), 0, 0..1);
    }
}
