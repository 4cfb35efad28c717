//! Floor 5: owns the passes. [`Renderer::render`] is one frame, in order, the same in browser, window and headless.
//!
//! It is long, but one thing: whoever follows a frame reads it here from top to bottom; what hangs on its size, its surface, its mesh or on
//! water before the eye has files of its own below.

use crate::data::sample::Sample;
use crate::data::streaming::Streaming;
use crate::data::tile::{Layer, Projection, TileId};
use crate::data::world::World;
use crate::error::Result;
use crate::gpu::drawing::{begin, resume};
use crate::gpu::{Gpu, texture};
use crate::model::optics::{DEEP_REFLECTANCE, opaque_depth_m};
use crate::model::waves;
use crate::pass::air_table::AirTable;
use crate::pass::city_lights::CityLights;
use crate::pass::cloud_light::{self, CloudLight};
use crate::pass::cloud_map::CloudMap;
use crate::pass::clouds::{Clouds, Look as CloudLook};
use crate::pass::frame_group::FrameGroup;
use crate::pass::globe::Globe;
use crate::pass::kind::Kind;
use crate::pass::land::Land;
use crate::pass::ocean::{Look, Ocean};
use crate::pass::rough_table;
use crate::pass::sky::Sky;
use crate::pass::sky_table::SkyTable;
use crate::pass::sky_view::SkyView;
use crate::pass::stars::Stars;
use crate::pass::world_tiles::WorldTiles;
use crate::scene::frame::Frame;
use crate::scene::frame::uniform::{SHOWS_LAND, SHOWS_SEA, SHOWS_SKY};
use crate::scene::sea::Seas;
use crate::scene::sea::shores::{ShoreWaves, Shores};
use crate::scene::settings::{self, Settings};
use crate::scene::view::camera::{Camera, LOWEST_M, OVER_BED_M};
use crate::scene::view::map_tiles::{Hiding, drawn_tiles, rugged_m, wanted_tiles};
use crate::scene::view::navigate::above_ground;
use crate::scene::view::state::ViewState;

mod below;
mod cost;
mod mesh;
mod surface;
mod targets;

use below::{Below, Side};
pub use cost::Cost;
use mesh::Mesh;
use surface::Surface;
use targets::{DEPTH_FORMAT, Passes, SAMPLES, Targets};
pub use targets::{Radiance, TARGET_FORMAT};

/// Steps of a foam replay that a frame may take, of a moving picture and of a still one: the rest follows in the next frames.
const REPLAY_STEPS: [usize; 2] = [2, 13];
/// Seconds that a frame may spend on finding where land stands in the sea's way, of a moving picture and of a still one.
const SHELTER_S: [f64; 2] = [0.003, 0.03];
/// For how long a frame of a program may make windows of waves by shores, seconds; a step that has been begun takes as long again.
const SHORE_SECONDS: f64 = 3e-3;
/// Updates of the bisected mesh in a frame, of a moving picture and of a still one.
const MESH_UPDATES: [u32; 2] = [2, 16];

/// Draws frames of one world.
pub struct Renderer {
    gpu: Gpu,
    world: World,
    seas: Seas,
    shores: Shores,
    radiance_format: wgpu::TextureFormat,
    streaming: Streaming,
    tiles: WorldTiles,
    frame_group: FrameGroup,
    air_table: AirTable,
    sky_table: SkyTable,
    sky_view: SkyView,
    cloud_map: CloudMap,
    cloud_light: CloudLight,
    surface: Surface,
    mesh: Mesh,
    sky: Sky,
    /// Where the radiance's format blends.
    stars: Option<Stars>,
    city_lights: Option<CityLights>,
    clouds: Option<Clouds>,
    globe: Globe,
    below: Below,
    land: Land,
    ocean: Ocean,
    passes: Passes,
    targets: Option<Targets>,
    moving: bool,
    clear: Option<wgpu::Color>,
    /// Of the last frame.
    dispatches: usize,
    /// Map tiles of the ground; `None` from space.
    visible: Option<Vec<TileId>>,
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
        let tiles = WorldTiles::new(&gpu);
        let (atlases, pages) = tiles.bindings();
        let frame_group = FrameGroup::new(&gpu, &atlases, pages);
        let frame = &frame_group.layout;
        let air_table = AirTable::new(&gpu, frame);
        let sky_table = SkyTable::new(&gpu, frame, &air_table.layout);
        let sky_view = SkyView::new(&gpu, frame, &air_table.layout);
        let rough = rough_table::view(&gpu);
        let SkyTable { radiance: sky_radiance, irradiance, .. } = &sky_table;
        let light = [sky_radiance, irradiance, &sky_view.sky, &sky_view.haze, &air_table.transmittance, &rough];
        let cloud_map = CloudMap::new(&gpu);
        let cloud_net = cloud_light::net(&gpu);
        let surface = Surface::new(&gpu, frame, light.map(Clone::clone), [&cloud_map.levels, &cloud_net]);
        let layout = &surface.layout;
        let mesh = Mesh::new(&gpu);
        let blends = radiance == Radiance::Half.format();
        Self {
            cloud_light: CloudLight::new(&gpu, frame, layout, cloud_net),
            sky: Sky::new(&gpu, frame, layout, [radiance, DEPTH_FORMAT]),
            stars: blends.then(|| Stars::new(&gpu, frame, layout, [radiance, DEPTH_FORMAT])),
            city_lights: blends.then(|| CityLights::new(&gpu, frame, layout, [radiance, DEPTH_FORMAT])),
            clouds: blends.then(|| Clouds::new(&gpu, frame, layout, radiance)),
            globe: Globe::new(&gpu, [frame, layout, &tiles.imagery_layout], [radiance, DEPTH_FORMAT]),
            below: Below::new(&gpu, frame, layout, radiance),
            land: Land::new(&gpu, [frame, layout, &tiles.imagery_layout], [radiance, DEPTH_FORMAT]),
            ocean: Ocean::new(&gpu, frame, layout, &mesh.layout, [radiance, DEPTH_FORMAT]),
            passes: Passes::new(&gpu, radiance),
            radiance_format: radiance,
            streaming: Streaming::default(),
            tiles,
            frame_group,
            air_table,
            sky_table,
            sky_view,
            cloud_map,
            surface,
            mesh,
            targets: None,
            moving: false,
            clear: None,
            dispatches: 0,
            visible: None,
            complete: false,
            gpu,
            world,
            seas: Seas::default(),
            shores: Shores::default(),
        }
    }

    /// Asks for the tiles that a frame needs; true when all have come (or will never come).
    pub fn load(&mut self, frame: &Frame) -> bool {
        let camera = &frame.camera;
        self.tiles.take_tiles(&self.gpu, &self.streaming.receive(&mut self.world));
        let wanted = wanted_tiles(camera, frame.size, &self.streaming);
        let is_sheltered = self.shelter(frame);
        self.complete = self.streaming.want(&mut self.world, &wanted, camera.lat, camera.lon) && is_sheltered;
        self.tiles.take_pages(&self.gpu, &mut self.streaming.pages);
        let hiding = self.hiding(frame);
        self.visible = (!frame.is_globe()).then(|| drawn_tiles(camera, frame.size, &self.streaming, hiding));
        let side = self.side(frame);
        let shows_trains = side.shows_surf && frame.is_fine() && self.complete;
        let seconds = if self.seas.is_spread() { SHORE_SECONDS } else { f64::INFINITY };
        self.complete &= self.shores.prepare(&mut self.world, frame, shows_trains, seconds);
        self.complete
    }

    /// Finds where land stands in the way of a frame's sea; true when that is known.
    fn shelter(&mut self, frame: &Frame) -> bool {
        let (camera, world) = (&frame.camera, &mut self.world);
        let budget_s = SHELTER_S[usize::from(!self.moving)];
        let mut look = |id| world.look(Layer::Water, id);
        let eye = (camera.lat, camera.lon, camera.altitude_m);
        self.seas.shelter.advance((&frame.sea, frame.wind_from), eye, budget_s, &mut look)
    }

    /// How the sea of a frame hides its bed: not where the sea is not drawn, nor from an eye in it.
    fn hiding(&mut self, frame: &Frame) -> Option<Hiding> {
        let side = self.side(frame);
        let covers = frame.uniform.layers & SHOWS_SEA != 0 && !side.kind.under_water;
        let depth_m = opaque_depth_m(f64::from(frame.uniform.water_density));
        let beach_slope = f64::from(frame.uniform.shore.x);
        covers.then(|| Hiding { depth_m, resolution_m: self.resolution_m(), beach_slope })
    }

    /// How wide a cell of the terrain's source is, metres.
    fn resolution_m(&self) -> f64 {
        self.world.resolution_m(Layer::Terrain, Projection::Mercator).unwrap_or(9_277.0)
    }

    /// Replays the foam's history for a frame, all but the step that the frame itself makes, and lets the bisected mesh come to
    /// rest: a still picture needs both. Waits for the device where the mesh is bisected.
    pub fn settle(&mut self, frame: &Frame) {
        self.surface.take(&self.gpu, frame, &mut self.seas);
        self.upload(frame);
        self.surface.replay(&self.gpu, frame, &self.frame_group.group, usize::MAX);
        self.settle_mesh(frame);
    }

    /// Lets the bisected mesh come to rest. Waits for the device.
    pub fn settle_mesh(&mut self, frame: &Frame) {
        self.upload(frame);
        loop {
            self.mesh.prepare(&self.gpu, frame, &self.frame_group.block_layout, MESH_UPDATES[1]);
            if self.mesh.dispatches() == 0 {
                return;
            }
            let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
            self.mesh.dispatch(&mut encoder.begin_compute_pass(&Default::default()), &self.frame_group.block_group);
            self.gpu.queue.submit([encoder.finish()]);
            self.mesh.stop_if_at_rest(&self.gpu);
        }
    }

    /// Forgets what came before: the next picture is that of a renderer that has just been made.
    pub fn forget(&mut self) {
        self.surface.forget();
        self.mesh.forget(&self.gpu);
    }

    /// One frame into `target`, a view of [`TARGET_FORMAT`] of the frame's size. Records; the caller submits.
    pub fn render(&mut self, encoder: &mut wgpu::CommandEncoder, frame: &Frame, target: &wgpu::TextureView) {
        self.load(frame);
        self.fit(frame);
        self.surface.take(&self.gpu, frame, &mut self.seas);
        self.surface.take_trains(&self.gpu, frame, &self.shores);
        let side = self.upload(frame);
        let kind = side.kind;
        let frame_group = &self.frame_group.group;
        let still = usize::from(!self.moving);
        self.surface.replay(&self.gpu, frame, frame_group, REPLAY_STEPS[still]);
        self.surface.prepare(&self.gpu, frame);
        self.mesh.prepare(&self.gpu, frame, &self.frame_group.block_layout, MESH_UPDATES[still]);
        if let Some(tiles) = &self.visible {
            self.ocean.set_grid(&self.gpu, frame.size, frame.uniform.cell_pixels as u32);
            let mesh = self.mesh.drawn().map_or(settings::Mesh::Grid, |_| settings::Mesh::Bisect);
            let samples = self.targets.as_ref().map_or(1, Targets::samples);
            for kind in [Some(kind), side.below()].into_iter().flatten() {
                self.ocean.prepare(&self.gpu, mesh, Look::of(frame, kind, side.shows_surf), samples);
            }
            // Coarse tiles are far ones.
            let streaming = &self.streaming;
            self.land.set_tiles(&self.gpu, tiles.iter().rev().map(|id| (*id, rugged_m(*id, streaming).is_some())));
        }
        if frame.has_light() {
            self.sky_view.prepare(&frame.uniform);
        }
        self.air_table.prepare(&frame.uniform);
        self.sky_table.prepare(&frame.uniform);
        let seen_clouds = frame.clouds.filter(|_| frame.has_light());
        if let Some(clouds) = seen_clouds {
            self.cloud_map.prepare(&self.gpu, clouds.weather);
        }
        self.cloud_light.prepare(seen_clouds.map(|clouds| (clouds.net, frame.is_fine())));
        self.dispatches = self.air_table.dispatches()
            + self.cloud_map.dispatches()
            + self.cloud_light.dispatches()
            + self.sky_table.dispatches()
            + self.sky_view.dispatches()
            + self.surface.dispatches()
            + self.mesh.dispatches();
        let from_below = self.below.prepare(&self.gpu, &side, frame.size);
        let Some(targets) = &self.targets else { return };
        let is_seen = frame.has_light() && !kind.under_water;
        let stars = self.stars.as_mut().filter(|_| is_seen && frame.shows_stars);
        let stars = stars.map(|stars| stars.prepare(&self.gpu, frame));
        let city_lights = self.city_lights.as_mut().filter(|_| is_seen && frame.shows_city_lights);
        let city_lights = city_lights.map(|lights| lights.prepare(&self.gpu, frame));
        let points: Vec<_> = stars.into_iter().flatten().chain(city_lights).collect();

        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.air_table.dispatch(&mut pass, frame_group);
            self.sky_table.dispatch(&mut pass, frame_group, &self.air_table.group);
            self.sky_view.dispatch(&mut pass, frame_group, &self.air_table.group);
            self.cloud_map.dispatch(&mut pass);
            self.cloud_light.dispatch(&mut pass, frame_group, self.surface.group());
            self.surface.dispatch(&mut pass, frame_group);
            self.mesh.dispatch(&mut pass, &self.frame_group.block_group);
        }
        self.cloud_light.hand_over(encoder);
        let surface = self.surface.group();
        let cloud_look = CloudLook::of(self.visible.is_none(), frame.is_fine());
        if let Some((pass, clouds)) = self.clouds.as_mut().zip(frame.clouds).filter(|_| is_seen) {
            pass.sketch(&self.gpu, encoder, (cloud_look, frame.size, clouds.area), [frame_group, surface]);
        }
        let clouds = self.clouds.as_ref().zip(frame.clouds).filter(|_| is_seen);
        let ground_kind = (kind, self.world.has(Layer::Imagery, Projection::Mercator));
        let ground_groups = [frame_group, surface, &self.tiles.imagery];
        let layers = frame.uniform.layers;
        let clear = self.clear.unwrap_or_else(|| clear_colour(frame));
        let radiance = texture::view(&targets.radiance);
        if self.visible.is_none() {
            let depth = Some((&targets.depth, wgpu::StoreOp::Discard));
            let mut pass = begin(encoder, "globe", &radiance, clear, depth);
            self.globe.draw(&mut pass, ground_kind, ground_groups);
            self.sky.draw(&mut pass, kind, frame_group, surface);
            points.into_iter().for_each(|points| points.draw(&mut pass, frame_group, surface));
        } else if kind.measured || !kind.under_water {
            let depth = Some((&targets.scene_depth, wgpu::StoreOp::Store));
            let mut pass = begin(encoder, "scene", &targets.scene, clear, depth);
            if layers & SHOWS_LAND != 0 {
                self.land.draw(&mut pass, (ground_kind, side.shows_lakes), ground_groups);
            }
            if layers & SHOWS_SKY != 0 {
                self.sky.draw(&mut pass, kind, frame_group, surface);
            }
            points.into_iter().for_each(|points| points.draw(&mut pass, frame_group, surface));
            drop(pass);
            // Waves stand before clouds that are above the eye.
            if let Some((pass, clouds)) = clouds.filter(|(_, clouds)| !clouds.are_below) {
                pass.draw(&mut resume(encoder, "clouds", &targets.scene), clouds.area, [frame_group, surface]);
            }
            let depth = Some((&targets.depth, wgpu::StoreOp::Discard));
            let mut pass = begin(encoder, "sea", targets.sea(&radiance), clear, depth);
            self.draw_sea(&mut pass, frame, (kind, side.shows_surf), targets.samples());
            self.passes.draw_backdrop(&mut pass, targets);
        }
        if let Some((pass, clouds)) = clouds.filter(|(_, clouds)| clouds.are_below) {
            pass.draw(&mut resume(encoder, "clouds", &radiance), clouds.area, [frame_group, surface]);
        }
        if let Some(kind) = side.below() {
            let sea = |pass: &mut wgpu::RenderPass| self.draw_sea(pass, frame, (kind, false), targets.samples());
            let groups = [frame_group, surface];
            let pictures = (&self.passes, targets);
            self.below.draw(encoder, (frame, kind), pictures, groups, (from_below.as_ref(), clear), sea);
        }
        self.passes.draw_tone(encoder, targets, frame.is_fine(), target);
    }

    /// Draws the sea's surface for a kind of picture, where the frame shows it.
    fn draw_sea(&self, pass: &mut wgpu::RenderPass, frame: &Frame, (kind, shows_surf): (Kind, bool), samples: u32) {
        if frame.uniform.layers & SHOWS_SEA == 0 {
            return;
        }
        let (frame_group, surface) = (&self.frame_group.group, self.surface.group());
        let look = Look::of(frame, kind, shows_surf);
        self.ocean.draw(pass, (frame, look, samples), frame_group, surface, self.mesh.drawn());
    }

    /// Hands the frame to the GPU. Returns where its eye is.
    fn upload(&mut self, frame: &Frame) -> Side {
        let side = self.side(frame);
        let deepest = self.streaming.pages.deepest();
        let water = (side.depth_m.unwrap_or(0.0), side.is_cut);
        self.frame_group.upload(&self.gpu, frame, self.resolution_m(), deepest, water);
        side
    }

    /// Where the eye of a frame is.
    fn side(&mut self, frame: &Frame) -> Side {
        let (lat, lon) = (frame.camera.lat, frame.camera.lon);
        let place = self.world.sample_resident(lat, lon);
        let shore = place.as_ref().and_then(|place| self.shore_waves(place, (lat, lon), frame.ticks()));
        Side::of(frame, place.as_ref(), shore.as_ref(), self.radiance_format == Radiance::Half.format())
    }

    /// The trains of waves of a shore at a place, where their windows are there.
    fn shore_waves(&self, place: &Sample, at: (f64, f64), ticks: u64) -> Option<ShoreWaves> {
        self.shores.waves_at(at, place.depth_m?, place.shore_distance_m?, ticks)
    }

    /// Makes the textures of the picture's size.
    fn fit(&mut self, frame: &Frame) {
        // From space there are no edges but the limb's, which its own shader makes smooth.
        let smooth = frame.has_smooth_edges(self.gpu.software)
            && self.visible.is_some()
            && self.radiance_format == Radiance::Half.format();
        let samples = if smooth { SAMPLES } else { 1 };
        if self.targets.as_ref().is_some_and(|targets| (targets.size, targets.samples()) == (frame.size, samples)) {
            return;
        }
        let targets = Targets::new(&self.gpu, frame.size, self.radiance_format, samples, &self.passes);
        let caustics = texture::view(&self.below.caustics.map);
        self.ocean.set_scene(&self.gpu, [&targets.scene, &caustics, &targets.scene_depth]);
        if let Some(clouds) = &mut self.clouds {
            clouds.set_scene(&targets.scene_depth);
        }
        self.targets = Some(targets);
    }

    /// The eye that a state asks for, where it can be: a metre over the ground and the waves, or, for a negative altitude over
    /// the ocean, in the water above its bed.
    pub fn eye(&mut self, state: &ViewState, unix_seconds: f64) -> Camera {
        let asked = state.camera;
        self.world.set_beach_slope(state.settings.surf.beach_slope);
        let Some(place) = self.world.sample_resident(asked.lat, asked.lon) else {
            return self.seas.eye(state, unix_seconds);
        };
        let Some(depth_m) = place.depth_m else { return above_ground(&asked, place.elevation_m) };
        let ridden = self.seas.eye(state, unix_seconds);
        let crest_m = self.seas.drawn(&state.settings).crest_m();
        let lowest_m = if !state.ride && (0.0..crest_m + LOWEST_M).contains(&asked.altitude_m) {
            let shore = self.shore_waves(&place, (asked.lat, asked.lon), waves::ticks_from_unix(unix_seconds));
            let (level, rise_m) = shore.map_or((1.0, 0.0), |shore| (shore.level, shore.wave.rise));
            level * self.seas.surface_height(&state.settings, &asked, unix_seconds) + rise_m + LOWEST_M
        } else {
            OVER_BED_M - depth_m
        };
        Camera { altitude_m: ridden.altitude_m.max(lowest_m), ..ridden }
    }

    /// The frame that `camera` sees at a UTC instant, `size` in pixels, in the sea that is drawn.
    pub fn frame(&mut self, settings: &Settings, camera: &Camera, unix_seconds: f64, size: [u32; 2]) -> Frame {
        Frame::of(&mut self.seas, settings, camera, unix_seconds, size)
    }

    /// The sea that is drawn.
    pub fn seas_mut(&mut self) -> &mut Seas {
        &mut self.seas
    }

    /// The world, for readouts and credits.
    pub fn world_mut(&mut self) -> &mut World {
        &mut self.world
    }

    /// Whether more tiles are on their way, or the sea, its foam or the mesh are still being made: another frame would look different.
    pub fn needs_redraw(&self) -> bool {
        !self.complete || self.is_replaying()
    }

    /// Tells whether the next frames follow each other: a moving picture must not wait for its foam.
    pub fn set_moving(&mut self, moving: bool) {
        self.moving = moving;
        self.surface.set_moving(moving);
    }

    /// Sets what a picture shows where nothing is drawn, as scene radiance: between land, sea and sky a deep sea's blue unless set, black
    /// in place of a layer that is not drawn. A loud colour shows cracks.
    pub fn set_clear_colour(&mut self, clear: wgpu::Color) {
        self.clear = Some(clear);
    }

    /// Whether the sea, its foam or the mesh are still being made: that needs frames, and nothing from outside.
    pub fn is_replaying(&self) -> bool {
        self.seas.is_busy() || self.seas.shelter.is_busy() || self.surface.is_replaying() || self.mesh.is_settling()
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The map of caustics of the last frame whose eye was in the water, see `shaders/lib/caustic_map.wgsl`.
    pub fn caustics(&self) -> &wgpu::Texture {
        &self.below.caustics.map
    }

    /// The scene's radiance, or the measured layer, of the last frame.
    pub fn radiance(&self) -> Option<&wgpu::Texture> {
        self.targets.as_ref().map(|targets| &targets.radiance)
    }
}

/// What stands where neither land nor sea covers a pixel that one of them should: the light of a deep sea, as faint as it is seen
/// through the surface. Black where a layer is left out or measured.
fn clear_colour(frame: &Frame) -> wgpu::Color {
    let u = &frame.uniform;
    let all = SHOWS_LAND | SHOWS_SEA | SHOWS_SKY;
    if u.layers & all != all || !frame.has_light() {
        return wgpu::Color::BLACK;
    }
    let [r, g, b] = DEEP_REFLECTANCE.map(|share| 0.25 * f64::from(u.exposure) * share);
    wgpu::Color { r, g, b, a: 1.0 }
}
