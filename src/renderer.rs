//! Floor 5: owns the passes. [`Renderer::render`] is one frame, in order, the same in browser, window and headless.

use crate::data::tile::{Layer, Projection, TileId};
use crate::data::world::World;
use crate::error::Result;
use crate::gpu::Gpu;
use crate::gpu::pipeline::Bind;
use crate::gpu::texture::{self, Shape};
use crate::pass::fft::{Fft, Precision, WaveData};
use crate::pass::foam::Foam;
use crate::pass::frame_group::FrameGroup;
use crate::pass::land::Land;
use crate::pass::ocean::Ocean;
use crate::pass::perlin::Perlin;
use crate::pass::sky::Sky;
use crate::pass::sky_table::SkyTable;
use crate::pass::tonemap::Tonemap;
use crate::pass::world_tiles::WorldTiles;
use crate::scene::camera::{Camera, LOWEST_M};
use crate::scene::foam::Whitecaps;
use crate::scene::frame::Frame;
use crate::scene::navigate::above_ground;
use crate::scene::ride::surface_height;
use crate::scene::sea::SeaTables;
use crate::scene::tiles::visible_tiles;
use crate::scene::view_state::ViewState;
use std::sync::Arc;

/// Format of the target that [`Renderer::render`] draws into: display (gamma) values.
pub const TARGET_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Steps of a foam replay that a frame may take, of a moving picture and of a still one: the rest follows in the next frames.
const REPLAY_STEPS: [usize; 2] = [2, 13];
const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// What the scene's radiance is stored in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radiance {
    /// 16-bit floats, for pictures.
    Half,
    /// 32-bit floats, for measured layers.
    Single,
}

impl Radiance {
    fn format(self) -> wgpu::TextureFormat {
        match self {
            Self::Half => wgpu::TextureFormat::Rgba16Float,
            Self::Single => wgpu::TextureFormat::Rgba32Float,
        }
    }
}

/// The textures whose size is the picture's.
struct Targets {
    size: [u32; 2],
    /// Sky and land, as the sea sees them.
    scene: wgpu::Texture,
    scene_depth: wgpu::TextureView,
    /// Everything.
    radiance: wgpu::Texture,
    depth: wgpu::TextureView,
}

impl Targets {
    fn new(gpu: &Gpu, size: [u32; 2], format: wgpu::TextureFormat) -> Self {
        use wgpu::TextureUsages as T;
        let picture = Shape::picture(size[0], size[1]);
        let usage = T::RENDER_ATTACHMENT | T::COPY_SRC | T::COPY_DST;
        let depth = |label| texture::view(&gpu.texture(label, picture, DEPTH_FORMAT, T::RENDER_ATTACHMENT));
        Self {
            size,
            scene: gpu.texture("scene", picture, format, usage),
            scene_depth: depth("scene depth"),
            radiance: gpu.texture("radiance", picture, format, usage),
            depth: depth("depth"),
        }
    }
}

/// Draws frames of one world.
pub struct Renderer {
    gpu: Gpu,
    world: World,
    radiance_format: wgpu::TextureFormat,
    tiles: WorldTiles,
    frame_group: FrameGroup,
    sky_table: SkyTable,
    fft: Fft,
    perlin: Perlin,
    surface_layout: wgpu::BindGroupLayout,
    /// One for each foam map.
    surface_groups: [wgpu::BindGroup; 2],
    foam: Foam,
    sky: Sky,
    land: Land,
    ocean: Ocean,
    tonemap: Tonemap,
    targets: Option<Targets>,
    sea: Option<Arc<SeaTables>>,
    whitecaps: Option<Whitecaps>,
    foam_complete: bool,
    moving: bool,
    visible: Vec<TileId>,
    complete: bool,
}

impl Renderer {
    /// A renderer for pictures.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device refuses a shader or a pipeline.
    pub async fn new(gpu: Gpu, world: World) -> Result<Self> {
        Self::with_radiance(gpu, world, Radiance::Half).await
    }

    /// A renderer whose scene radiance has the given precision.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub async fn with_radiance(gpu: Gpu, world: World, radiance: Radiance) -> Result<Self> {
        let device = gpu.clone();
        device.validated(move || Self::build(gpu, world, radiance.format())).await
    }

    fn build(gpu: Gpu, world: World, radiance: wgpu::TextureFormat) -> Self {
        use wgpu::TextureViewDimension::{D2, D2Array, D3};
        let tiles = WorldTiles::new(&gpu);
        let (atlases, pages) = tiles.bindings();
        let frame_group = FrameGroup::new(&gpu, &atlases, pages);
        let frame = &frame_group.layout;
        let sky_table = SkyTable::new(&gpu, frame);
        let fft = Fft::new(&gpu, 256, crate::model::waves::CASCADES, Precision::Half).sharpened(true);
        let perlin = Perlin::new(&gpu);
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT | wgpu::ShaderStages::COMPUTE;
        let mut binds = [D2Array, D2Array, D2Array, D2, D2, D3, D2].map(Bind::Texture);
        // The foam map is read texel by texel.
        binds[4] = Bind::Texels(D2);
        let surface_layout = gpu.layout("surface", stages, &binds);
        let foam = Foam::new(&gpu, frame, &surface_layout);
        let surface_groups = surface_groups(&gpu, &surface_layout, &fft, &perlin, &foam, &sky_table);
        Self {
            sky: Sky::new(&gpu, frame, &surface_layout, radiance),
            land: Land::new(&gpu, frame, &surface_layout, radiance, DEPTH_FORMAT),
            ocean: Ocean::new(&gpu, frame, &surface_layout, radiance, DEPTH_FORMAT),
            tonemap: Tonemap::new(&gpu, TARGET_FORMAT),
            radiance_format: radiance,
            tiles,
            frame_group,
            sky_table,
            fft,
            perlin,
            surface_layout,
            surface_groups,
            foam,
            targets: None,
            sea: None,
            whitecaps: None,
            foam_complete: true,
            moving: false,
            visible: Vec::new(),
            complete: false,
            gpu,
            world,
        }
    }

    /// Asks for the tiles that a frame needs; true when all have come (or will never come).
    pub fn load(&mut self, frame: &Frame) -> bool {
        self.visible = visible_tiles(&frame.camera, frame.size);
        self.complete = self.tiles.update(&self.gpu, &mut self.world, &frame.camera, &self.visible);
        self.complete
    }

    /// Replays the foam's history for a frame, all but the step that the frame itself makes: a still picture needs it.
    pub fn settle(&mut self, frame: &Frame) {
        self.take_sea(frame);
        self.upload(frame);
        self.replay_foam(frame, usize::MAX);
    }

    /// Forgets what came before: the next picture is that of a renderer that has just been made.
    pub fn forget(&mut self) {
        self.foam.reset();
    }

    /// One frame into `target`, a view of [`TARGET_FORMAT`] of the frame's size. Records; the caller submits.
    pub fn render(&mut self, encoder: &mut wgpu::CommandEncoder, frame: &Frame, target: &wgpu::TextureView) {
        self.load(frame);
        self.fit(frame.size);
        self.take_sea(frame);
        self.upload(frame);
        self.replay_foam(frame, REPLAY_STEPS[usize::from(!self.moving)]);
        let foam_step = self.prepare_foam(frame);
        let Some(targets) = &self.targets else { return };
        self.fft.set_time(&self.gpu, frame.ticks());
        self.perlin.prepare(&self.gpu, frame);
        self.land.set_tiles(&self.gpu, &self.visible);
        let frame_group = &self.frame_group.group;

        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.sky_table.dispatch(&mut pass, frame_group);
            self.fft.dispatch(&mut pass);
            self.perlin.dispatch(&mut pass);
            self.fft.dispatch_mips(&mut pass);
            self.perlin.dispatch_mips(&mut pass);
            if foam_step {
                let surface = &self.surface_groups[self.foam.current()];
                self.foam.dispatch(&mut pass, frame_group, surface);
            }
        }
        let surface = &self.surface_groups[self.foam.current()];
        let (scene, radiance) = (texture::view(&targets.scene), texture::view(&targets.radiance));
        let layers = frame.uniform.layers;
        {
            let mut pass = begin(encoder, "scene", &scene, wgpu::LoadOp::Clear(wgpu::Color::BLACK), None);
            if layers & 4 != 0 {
                self.sky.draw(&mut pass, frame_group, surface);
            }
        }
        {
            let depth = Some(&targets.scene_depth);
            let mut pass = begin(encoder, "land", &scene, wgpu::LoadOp::Load, depth);
            if layers & 1 != 0 {
                self.land.draw(&mut pass, frame_group, surface);
            }
        }
        encoder.copy_texture_to_texture(
            targets.scene.as_image_copy(),
            targets.radiance.as_image_copy(),
            targets.scene.size(),
        );
        {
            let mut pass = begin(encoder, "sea", &radiance, wgpu::LoadOp::Load, Some(&targets.depth));
            if layers & 2 != 0 {
                self.ocean.draw(&mut pass, frame_group, surface);
            }
        }
        let mut pass = begin(encoder, "tonemap", target, wgpu::LoadOp::Clear(wgpu::Color::BLACK), None);
        self.tonemap.draw(&mut pass);
    }

    /// Hands the frame to the GPU.
    fn upload(&mut self, frame: &Frame) {
        let resolution = self.world.resolution_m(Layer::Terrain, Projection::Mercator).unwrap_or(9_277.0);
        let (lat, lon) = (frame.camera.lat, frame.camera.lon);
        let over_ocean = self.world.sample_resident(lat, lon).is_some_and(|place| place.depth_m.is_some());
        self.frame_group.upload(&self.gpu, frame, resolution, over_ocean);
    }

    /// Brings the foam map towards the frame's instant, by at most `budget` steps of the past, each a submission of its own.
    fn replay_foam(&mut self, frame: &Frame, mut budget: usize) {
        self.foam_complete = true;
        let Some(lifetime_s) = frame.foam_lifetime_s else { return self.foam.reset() };
        let (ticks, eye) = (frame.ticks(), &frame.foam_eye);
        while let Some(instant) = self.foam.next_instant(ticks, eye, lifetime_s).filter(|instant| *instant != ticks) {
            if budget == 0 {
                self.foam_complete = false;
                return;
            }
            budget -= 1;
            self.foam.prepare(&self.gpu, instant, eye, lifetime_s);
            self.fft.set_time(&self.gpu, instant);
            let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
            {
                let mut pass = encoder.begin_compute_pass(&Default::default());
                self.fft.dispatch(&mut pass);
                self.fft.dispatch_stretch_mips(&mut pass);
                let surface = &self.surface_groups[self.foam.current()];
                self.foam.dispatch(&mut pass, &self.frame_group.group, surface);
            }
            self.gpu.queue.submit([encoder.finish()]);
        }
    }

    /// Prepares the foam's last step, which the frame itself makes from its own waves; false where there is none to make.
    fn prepare_foam(&mut self, frame: &Frame) -> bool {
        let Some(lifetime_s) = frame.foam_lifetime_s.filter(|_| self.foam_complete) else { return false };
        let (ticks, eye) = (frame.ticks(), &frame.foam_eye);
        let due = self.foam.next_instant(ticks, eye, lifetime_s).is_some();
        if due {
            self.foam.prepare(&self.gpu, ticks, eye, lifetime_s);
        }
        due
    }

    /// Makes the textures of the picture's size.
    fn fit(&mut self, size: [u32; 2]) {
        if self.targets.as_ref().is_some_and(|targets| targets.size == size) {
            return;
        }
        let targets = Targets::new(&self.gpu, size, self.radiance_format);
        self.ocean.set_scene(&self.gpu, size, &texture::view(&targets.scene), &targets.scene_depth);
        self.tonemap.set_scene(&self.gpu, &texture::view(&targets.radiance));
        self.targets = Some(targets);
    }

    /// Makes the waves of a sea that is not the last one.
    fn take_sea(&mut self, frame: &Frame) {
        if self.whitecaps != Some(frame.whitecaps) {
            self.whitecaps = Some(frame.whitecaps);
            self.foam.reset();
        }
        let sea = &frame.sea;
        if self.sea.as_ref().is_some_and(|kept| kept == sea) {
            return;
        }
        let n = sea.cascades[0].n;
        if n != self.fft.samples() {
            self.fft = Fft::new(&self.gpu, n, sea.cascades.len(), Precision::Half).sharpened(true);
            self.surface_groups =
                surface_groups(&self.gpu, &self.surface_layout, &self.fft, &self.perlin, &self.foam, &self.sky_table);
        }
        self.fft.set_waves(&self.gpu, &sea.cascades, &WaveData::of(sea));
        self.foam.reset();
        self.sea = Some(sea.clone());
    }

    /// The eye that a state asks for, where it can be: a metre over the ground and the waves, or, for a negative altitude over
    /// the ocean, in the water above its bed.
    pub fn eye(&mut self, state: &ViewState, unix_seconds: f64) -> Camera {
        let asked = state.camera;
        let Some(place) = self.world.sample_resident(asked.lat, asked.lon) else { return state.eye(unix_seconds) };
        let Some(depth_m) = place.depth_m else { return above_ground(&asked, place.elevation_m) };
        let ridden = state.eye(unix_seconds);
        let crest_m = 1.2 * SeaTables::of(&state.settings).sea.hs_m;
        let lowest_m = if !state.ride && (0.0..crest_m + LOWEST_M).contains(&asked.altitude_m) {
            surface_height(&state.settings, &asked, unix_seconds) + LOWEST_M
        } else {
            0.5 - depth_m
        };
        Camera { altitude_m: ridden.altitude_m.max(lowest_m), ..ridden }
    }

    /// The world, for readouts and credits.
    pub fn world_mut(&mut self) -> &mut World {
        &mut self.world
    }

    /// Whether more tiles are on their way, or the foam's history is being replayed, so that another frame would look different.
    pub fn needs_redraw(&self) -> bool {
        !self.complete || self.is_replaying()
    }

    /// Tells whether the next frames follow each other: a moving picture must not wait for its foam.
    pub fn set_moving(&mut self, moving: bool) {
        self.moving = moving;
    }

    /// Whether the foam's history is being replayed: that needs frames, and nothing from outside.
    pub fn is_replaying(&self) -> bool {
        !self.foam_complete
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The scene's radiance, or the measured layer, of the last frame.
    pub fn radiance(&self) -> Option<&wgpu::Texture> {
        self.targets.as_ref().map(|targets| &targets.radiance)
    }
}

/// Bind group 1 with either foam map.
fn surface_groups(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    fft: &Fft,
    perlin: &Perlin,
    foam: &Foam,
    sky: &SkyTable,
) -> [wgpu::BindGroup; 2] {
    foam.maps.each_ref().map(|map| {
        let views = [
            texture::array_view(&fft.displacements),
            texture::array_view(&fft.slopes),
            texture::array_view(&fft.stretches),
            texture::view(&perlin.texture),
            map.clone(),
            sky.radiance.clone(),
            sky.irradiance.clone(),
        ];
        gpu.bind("surface", layout, &views.each_ref().map(wgpu::BindingResource::TextureView))
    })
}

fn begin<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    colour: &wgpu::TextureView,
    load: wgpu::LoadOp<wgpu::Color>,
    depth: Option<&wgpu::TextureView>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: colour,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
        })],
        depth_stencil_attachment: depth.map(|view| wgpu::RenderPassDepthStencilAttachment {
            view,
            // Reversed depth: 0 is infinitely far.
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}
