//! Floor 5: owns the passes. [`Renderer::render`] is one frame, in order, the same in browser, window and headless.
//!
//! It is long, but one thing: whoever follows a frame reads it here from top to bottom; what hangs on its size, its surface, its mesh or on
//! water before the eye, and what it needs of the world before it can be drawn, has files of its own below.

use crate::data::streaming::Streaming;
use crate::data::tile::{Layer, Projection};
use crate::data::world::World;
use crate::error::Result;
use crate::gpu::drawing::{DepthUse, begin, begin_places, resume};
use crate::gpu::timing::Stages;
use crate::gpu::{Gpu, texture};
use crate::model::optics::DEEP_REFLECTANCE;
use crate::pass::air_table::AirTable;
use crate::pass::city_lights::CityLights;
use crate::pass::cloud_light::{self, CloudLight};
use crate::pass::cloud_map::CloudMap;
use crate::pass::clouds::{Clouds, Look as CloudLook};
use crate::pass::frame_group::FrameGroup;
use crate::pass::globe::Globe;
use crate::pass::land::{Beach, GROWTH_M, Ground, Land, Near};
use crate::pass::look::Look;
use crate::pass::ocean::{Ocean, Shading};
use crate::pass::rough_table;
use crate::pass::sky::Sky;
use crate::pass::sky_table::SkyTable;
use crate::pass::sky_view::SkyView;
use crate::pass::spindrift::{self, Spindrift};
use crate::pass::stars::Stars;
use crate::pass::towns::Towns;
use crate::pass::world_tiles::WorldTiles;
use crate::scene::frame::Frame;
use crate::scene::frame::uniform::{SHOWS_LAND, SHOWS_SEA, SHOWS_SKY};
use crate::scene::sea::Seas;
use crate::scene::sea::shores::Shores;
use crate::scene::settings::{self, Settings};
use crate::scene::view::camera::Camera;
use crate::scene::view::map_tiles::{DrawnTile, has_beach, nearest_pixel_m};

mod below;
mod cost;
mod mesh;
mod needs;
mod side;
mod surface;
mod targets;

use below::Below;
pub use cost::Cost;
use mesh::Mesh;
use side::Side;
use surface::Surface;
use targets::{DEPTH_FORMAT, PICTURE_FORMAT, Passes, SAMPLES, Targets};
pub use targets::{Radiance, TARGET_FORMAT};

/// Tiles of coarser levels are drawn as if each had inland waters: those that their pixels show may lie in other tiles.
const OWN_INLAND_LEVEL: u8 = 7;
/// Steps of a foam replay that a frame may take, of a moving picture and of a still one: the rest follows in the next frames.
const REPLAY_STEPS: [usize; 2] = [2, 13];
/// Updates of the bisected mesh in a frame, of a moving picture and of a still one.
const MESH_UPDATES: [u32; 2] = [2, 16];

/// Draws frames of one world.
pub struct Renderer {
    gpu: Gpu,
    world: World,
    seas: Seas,
    shores: Shores,
    radiance_format: wgpu::TextureFormat,
    /// Whether the radiance has what is blended with surfaces and air, too.
    blends: bool,
    streaming: Streaming,
    tiles: WorldTiles,
    towns: Towns,
    frame_group: FrameGroup,
    /// The same with the block of the lake around the eye.
    lake_group: FrameGroup,
    air_table: AirTable,
    sky_table: SkyTable,
    sky_view: SkyView,
    cloud_map: CloudMap,
    cloud_light: CloudLight,
    surface: Surface,
    mesh: Mesh,
    sky: Sky,
    /// These four where the radiance has what is blended.
    stars: Option<Stars>,
    city_lights: Option<CityLights>,
    clouds: Option<Clouds>,
    spindrift: Option<Spindrift>,
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
    visible: Option<Vec<DrawnTile>>,
    complete: bool,
    /// How long pictures take, seconds; 0 where nobody has told.
    picture_s: f64,
    /// Whether the last eye that was asked for knows the level of the water below it.
    knows_ground: bool,
    stages: Stages,
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
        device.validated(move || Self::build(gpu, world, radiance)).await
    }

    fn build(gpu: Gpu, world: World, radiance: Radiance) -> Self {
        let blends = radiance.blends();
        let radiance = radiance.format(&gpu);
        let towns = Towns::new(&gpu);
        let tiles = WorldTiles::new(&gpu, &towns.buffer);
        let (atlases, pages) = tiles.bindings();
        let [frame_group, lake_group] = [(); 2].map(|()| FrameGroup::new(&gpu, &atlases, pages));
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
        Self {
            cloud_light: CloudLight::new(&gpu, frame, layout, cloud_net),
            sky: Sky::new(&gpu, frame, layout, [radiance, DEPTH_FORMAT]),
            stars: blends.then(|| Stars::new(&gpu, frame, layout, [radiance, DEPTH_FORMAT])),
            city_lights: blends.then(|| CityLights::new(&gpu, frame, layout, [radiance, DEPTH_FORMAT])),
            clouds: blends.then(|| Clouds::new(&gpu, frame, layout, radiance)),
            spindrift: blends.then(|| Spindrift::new(&gpu, [frame, layout], [radiance, DEPTH_FORMAT])),
            globe: Globe::new(&gpu, [frame, layout, &tiles.imagery_layout], [radiance, DEPTH_FORMAT]),
            below: Below::new(&gpu, [frame, layout], radiance, blends),
            land: Land::new(&gpu, [frame, layout, &tiles.imagery_layout], [radiance, DEPTH_FORMAT]),
            ocean: Ocean::new(&gpu, frame, layout, &mesh.layout, [radiance, DEPTH_FORMAT]),
            passes: Passes::new(&gpu, radiance),
            radiance_format: radiance,
            blends,
            streaming: Streaming::default(),
            tiles,
            towns,
            frame_group,
            lake_group,
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
            picture_s: 0.0,
            knows_ground: true,
            stages: Stages::default(),
            gpu,
            world,
            seas: Seas::default(),
            shores: Shores::default(),
        }
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
        let look = Look::of(frame, kind, side.shows_surf);
        let shows_spindrift =
            self.spindrift.is_some() && self.visible.is_some() && frame.has_spindrift() && !kind.under_water;
        let ground_kind = (kind, self.world.has(Layer::Imagery, Projection::Mercator));
        if let Some(tiles) = &self.visible {
            self.ocean.set_grid(&self.gpu, frame.size, frame.uniform.cell_pixels as u32);
            let mesh = self.mesh.drawn().map_or(settings::Mesh::Grid, |_| settings::Mesh::Bisect);
            let samples = self.targets.as_ref().map_or(1, Targets::samples);
            for kind in [Some(kind), side.below()].into_iter().flatten() {
                let look = Look::of(frame, kind, side.shows_surf);
                self.ocean.prepare(&self.gpu, mesh, look, self.shading(&side, look));
            }
            if side.meshes_lake {
                self.ocean.prepare(&self.gpu, settings::Mesh::Grid, Look::of_lake(kind), Shading::OfMesh(samples));
            }
            if let Some(spindrift) = self.spindrift.as_mut().filter(|_| shows_spindrift) {
                spindrift.prepare(&self.gpu, look, samples);
            }
            // Coarse tiles are far ones.
            let shows_beaches = side.shows_surf && kind.shows_lakes();
            let beach = |id| shows_beaches && has_beach(id, &self.streaming);
            let near = if side.shows_lakes && !side.is_amid_lake {
                Near::Lakes
            } else if nearest_pixel_m(&frame.camera, frame.size, tiles, &self.streaming) < GROWTH_M {
                Near::Growth
            } else {
                Near::Nothing
            };
            self.towns.prepare(&self.gpu, frame);
            // A graphics card skips what a pixel does not have: fewer pipelines are compiled for it.
            let software = self.gpu.software;
            let reefs = !software || frame.has_reefs();
            let ground = |DrawnTile { id, is_rugged: rugged, .. }, bed| {
                // Wide pixels show what is where their own ray meets the earth, which may lie in another tile.
                let has_inland = self.streaming.has_inland(id);
                let inland = !software || has_inland || id.z < OWN_INLAND_LEVEL;
                let near = if near == Near::Lakes && !has_inland { Near::Growth } else { near };
                let town = self.towns.are_on(id);
                let usual = Ground { near, beach: Beach::Absent, rugged, town, inland, reefs, bed };
                if bed { Ground { near: Near::Nothing, town: false, inland: false, ..usual } } else { usual }
            };
            let known_bed = |tile: &DrawnTile| DrawnTile { bed: if software { tile.bed } else { 0 }, ..*tile };
            self.land.set_tiles(&self.gpu, ground_kind, tiles.iter().rev().map(known_bed), ground, beach);
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
        let mirrors_clouds = frame.is_fine() && self.visible.is_some();
        self.cloud_light.prepare(seen_clouds.map(|clouds| (clouds.net, mirrors_clouds)));
        self.dispatches = self.air_table.dispatches()
            + self.cloud_map.dispatches()
            + self.cloud_light.dispatches()
            + self.sky_table.dispatches()
            + self.sky_view.dispatches()
            + self.surface.dispatches()
            + self.mesh.dispatches()
            + if shows_spindrift { spindrift::DISPATCHES } else { 0 };
        let from_below = self.below.prepare(&self.gpu, &side, frame.size);
        let Some(targets) = &self.targets else { return };
        let is_seen = frame.has_light() && !kind.under_water;
        let stars = self.stars.as_mut().filter(|_| is_seen && frame.shows_stars);
        let stars = stars.map(|stars| stars.prepare(&self.gpu, frame));
        let city_lights = self.city_lights.as_mut().filter(|_| is_seen && frame.shows_city_lights);
        let city_lights = city_lights.map(|lights| lights.prepare(&self.gpu, frame, ground_kind.1));
        let points: Vec<_> = stars.into_iter().flatten().chain(city_lights).collect();
        let mut stages = std::mem::take(&mut self.stages);
        stages.begin(encoder);

        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.air_table.dispatch(&mut pass, frame_group);
            self.sky_table.dispatch(&mut pass, frame_group, &self.air_table.group);
            self.sky_view.dispatch(&mut pass, frame_group, &self.air_table.group);
            stages.end(&mut pass, "air");
            self.cloud_map.dispatch(&mut pass);
            self.cloud_light.dispatch(&mut pass, frame_group, self.surface.group());
            stages.end(&mut pass, "weather");
            self.surface.dispatch(&mut pass, frame_group);
            stages.end(&mut pass, "surface");
            self.mesh.dispatch(&mut pass, &self.frame_group.block_group);
            stages.end(&mut pass, "mesh");
        }
        self.cloud_light.hand_over(encoder);
        let surface = self.surface.group();
        let spindrift = self.spindrift.as_ref().filter(|_| shows_spindrift);
        if let Some(spindrift) = spindrift {
            // In the light under the clouds, which has just been handed over.
            let mut pass = encoder.begin_compute_pass(&Default::default());
            spindrift.dispatch(&mut pass, look, [frame_group, surface]);
            stages.end(&mut pass, "spindrift");
        }
        let cloud_look = CloudLook::of(frame.has_clouds_of_globe(), frame.is_fine());
        if let Some((pass, clouds)) = self.clouds.as_mut().zip(frame.clouds).filter(|_| is_seen) {
            pass.sketch(&self.gpu, encoder, (cloud_look, frame.size, clouds.area), [frame_group, surface]);
            stages.end(encoder, "clouds");
        }
        let clouds = self.clouds.as_ref().zip(frame.clouds).filter(|_| is_seen);
        let ground_groups = [frame_group, surface, &self.tiles.imagery];
        let layers = frame.uniform.layers;
        let clear = self.clear.unwrap_or_else(|| clear_colour(frame));
        let radiance = texture::view(&targets.radiance);
        if self.visible.is_none() {
            let depth = Some(DepthUse::Begun(&targets.depth, wgpu::StoreOp::Discard));
            // Beside the air the sky is black; where a clear colour shall tell what is not drawn, and where something is measured, it is drawn.
            let area = Some(frame.sky_area).filter(|_| self.clear.is_none() && frame.has_light());
            let clear = if area.is_some() { wgpu::Color::BLACK } else { clear };
            let mut pass = begin(encoder, "globe", &radiance, clear, depth);
            self.globe.draw(&mut pass, ground_kind, ground_groups);
            if let Some([x, y, width, height]) = area {
                pass.set_scissor_rect(x, y, width, height);
            }
            self.sky.draw(&mut pass, kind, frame_group, surface);
            pass.set_scissor_rect(0, 0, frame.size[0], frame.size[1]);
            points.into_iter().for_each(|points| points.draw(&mut pass, frame_group, surface));
            drop(pass);
            if !frame.has_clouds_of_globe() {
                // Nothing stands before its clouds.
                drop(begin(
                    encoder,
                    "scene",
                    &targets.scene,
                    clear,
                    Some(DepthUse::Begun(&targets.scene_depth, wgpu::StoreOp::Store)),
                ));
            }
            stages.end(encoder, "globe");
        } else if kind.measured || !kind.under_water {
            let depth = Some(DepthUse::Begun(&targets.scene_depth, wgpu::StoreOp::Store));
            let mut pass = begin(encoder, "scene", &targets.scene, clear, depth);
            if layers & SHOWS_LAND != 0 {
                self.land.draw(&mut pass, ground_groups);
            }
            if layers & SHOWS_SKY != 0 {
                // Shaders leave out what lies lower, but only once a pixel has been shaded.
                let covered = SHOWS_LAND | SHOWS_SEA;
                let [width, height] = frame.size;
                let may_cover = layers & covered == covered && frame.has_light();
                let area = if may_cover { frame.sky_area } else { [0, 0, width, height] };
                if area[3] > 0 {
                    pass.set_scissor_rect(area[0], area[1], area[2], area[3]);
                    self.sky.draw(&mut pass, kind, frame_group, surface);
                    pass.set_scissor_rect(0, 0, width, height);
                }
            }
            points.into_iter().for_each(|points| points.draw(&mut pass, frame_group, surface));
            drop(pass);
            stages.end(encoder, "land, sky");
            if side.lights_bed {
                self.below.light_bed(encoder, &side, targets, [frame_group, surface]);
                stages.end(encoder, "caustics");
            }
            // Waves stand before clouds that are above the eye.
            if let Some((pass, clouds)) = clouds.filter(|(_, clouds)| !clouds.are_below) {
                pass.draw(&mut resume(encoder, "clouds", &targets.scene), clouds.area, [frame_group, surface]);
                stages.end(encoder, "drawn clouds");
            }
            let is_placed = side.shows_ocean && self.shading(&side, look) == Shading::OfPlaces;
            let places = self.ocean.places().filter(|_| is_placed);
            let mut depth = DepthUse::Begun(&targets.depth, wgpu::StoreOp::Discard);
            if let Some(places) = places {
                self.draw_sea(
                    &mut begin_places(encoder, "places", places, &targets.depth),
                    frame,
                    look,
                    Shading::OfPlaces,
                );
                depth = DepthUse::Found(&targets.depth);
            }
            let mut pass = begin(encoder, "sea", targets.sea(&radiance), clear, Some(depth));
            if places.is_some() {
                self.ocean.shade(&mut pass, look, frame_group, surface);
            } else if side.shows_ocean {
                self.draw_sea(&mut pass, frame, look, Shading::OfMesh(targets.samples()));
            }
            if let Some(lake) = frame.lake.as_ref().filter(|_| side.meshes_lake) {
                let lake = (&lake.uniform, Look::of_lake(kind), Shading::OfMesh(targets.samples()));
                self.ocean.draw(&mut pass, lake, &self.lake_group.group, surface, None);
            }
            self.passes.draw_backdrop(&mut pass, targets);
            if let Some(spindrift) = spindrift {
                spindrift.draw(&mut pass, targets.samples(), [frame_group, surface]);
            }
            drop(pass);
            stages.end(encoder, "sea");
        }
        if let Some((pass, clouds)) = clouds.filter(|(_, clouds)| clouds.are_below) {
            pass.draw(&mut resume(encoder, "clouds", &radiance), clouds.area, [frame_group, surface]);
            stages.end(encoder, "drawn clouds");
        }
        if let Some(kind) = side.below() {
            let look = Look::of(frame, kind, false);
            let shading = Shading::OfMesh(targets.samples());
            let sea = |pass: &mut wgpu::RenderPass| self.draw_sea(pass, frame, look, shading);
            let groups = [frame_group, surface];
            let pictures = (&self.passes, targets);
            self.below.draw(encoder, (frame, kind), pictures, groups, (from_below.as_ref(), clear), sea);
            stages.end(encoder, "under water");
        }
        self.passes.filter(&self.gpu, &frame.sky_filter);
        self.passes.draw_tone(encoder, targets, frame.is_fine(), target);
        stages.end(encoder, "tone");
        stages.resolve(encoder);
        self.stages = stages;
    }

    /// What shades the sea of a look.
    fn shading(&self, side: &Side, look: Look) -> Shading {
        if self.ocean.places().is_some() && Shading::of_places(look) && !side.meshes_lake {
            return Shading::OfPlaces;
        }
        Shading::OfMesh(self.targets.as_ref().map_or(1, Targets::samples))
    }

    /// Draws the sea's mesh of a look, where the frame shows it.
    fn draw_sea(&self, pass: &mut wgpu::RenderPass, frame: &Frame, look: Look, shading: Shading) {
        if frame.uniform.layers & SHOWS_SEA == 0 {
            return;
        }
        let (frame_group, surface) = (&self.frame_group.group, self.surface.group());
        self.ocean.draw(pass, (&frame.uniform, look, shading), frame_group, surface, self.mesh.drawn());
    }

    /// Hands the frame to the GPU. Returns where its eye is.
    fn upload(&mut self, frame: &Frame) -> Side {
        let side = self.side(frame);
        let deepest = self.streaming.pages.deepest();
        let water = (side.depth_m.unwrap_or(0.0), side.is_cut, side.mirrors_land);
        let world = (self.resolution_m(), deepest);
        self.frame_group.upload(&self.gpu, (&frame.uniform, &frame.wave_cells), world, water);
        if let Some(lake) = frame.lake.as_ref().filter(|_| side.meshes_lake) {
            self.lake_group.upload(&self.gpu, (&lake.uniform, &lake.wave_cells), world, (0.0, false, true));
        }
        side
    }

    /// Makes the textures of the picture's size.
    fn fit(&mut self, frame: &Frame) {
        // From space there are no edges but the limb's, which its own shader makes smooth.
        let is_picture = self.visible.is_some() && self.radiance_format == PICTURE_FORMAT;
        let smooth = is_picture && frame.has_smooth_edges(self.gpu.software);
        let samples = if smooth { SAMPLES } else { 1 };
        let places = (is_picture && !smooth && frame.keeps_places()).then_some(frame.size);
        let fits = |targets: &Targets| (targets.size, targets.samples()) == (frame.size, samples);
        if self.targets.as_ref().is_some_and(fits) && self.ocean.places().is_some() == places.is_some() {
            return;
        }
        let targets = Targets::new(&self.gpu, frame.size, self.radiance_format, samples, &self.passes);
        let caustics = texture::view(&self.below.caustics.map);
        self.ocean.set_scene(&self.gpu, [&targets.scene, &caustics, &targets.scene_depth], places);
        self.below.set_scene(&self.gpu, &targets);
        if let Some(clouds) = &mut self.clouds {
            clouds.set_scene(&targets.scene_depth);
        }
        if let Some(spindrift) = &mut self.spindrift {
            spindrift.set_scene(&self.gpu, &targets.scene_depth);
        }
        self.targets = Some(targets);
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

    /// Tells how long pictures take, seconds: what shores need is made in a share of that.
    pub fn set_picture_s(&mut self, picture_s: f64) {
        self.picture_s = picture_s;
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

    /// Says whether the next frames shall tell what their stages cost, see [`Renderer::stage_times`].
    pub fn measure_stages(&mut self, measured: bool) {
        self.stages = if measured { Stages::measured(&self.gpu) } else { Stages::default() };
    }

    /// The last frame's stages in order and their milliseconds on the device, see [`Stages::read`]. Waits for the device.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device is lost.
    pub fn stage_times(&self) -> Result<Vec<(&'static str, Option<f64>)>> {
        self.stages.read(&self.gpu)
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The map of caustics of the last frame that showed any, see `shaders/lib/caustic_map.wgsl`.
    pub fn caustics(&self) -> &wgpu::Texture {
        &self.below.caustics.map
    }

    /// The plumes of the last frame that showed spindrift, see [`spindrift::Plume`]; `None` where the radiance has nothing that is blended.
    pub fn plumes(&self) -> Option<&wgpu::Buffer> {
        self.spindrift.as_ref().map(Spindrift::plumes)
    }

    /// The scene's radiance, or the measured layer, of the last frame.
    pub fn radiance(&self) -> Option<&wgpu::Texture> {
        self.targets.as_ref().map(|targets| &targets.radiance)
    }

    /// Where the sea's mesh is in each pixel of the last frame that was shaded by that, two layers, see `shaders/lib/places.wgsl`.
    pub fn places(&self) -> Option<&wgpu::Texture> {
        self.ocean.places().map(|[first, _]| first.texture())
    }
}

/// What stands where neither land nor sea covers a pixel that one of them should: the light of a deep sea, as faint as it is seen
/// through the surface; its alpha of 0 says that there is no air before it, see `shaders/backdrop.wgsl`. Black where a layer is left out or measured.
fn clear_colour(frame: &Frame) -> wgpu::Color {
    let u = &frame.uniform;
    let all = SHOWS_LAND | SHOWS_SEA | SHOWS_SKY;
    if u.layers & all != all || !frame.has_light() {
        return wgpu::Color::BLACK;
    }
    let [r, g, b] = DEEP_REFLECTANCE.map(|share| 0.25 * f64::from(u.exposure) * share);
    wgpu::Color { r, g, b, a: 0.0 }
}
