//! One frame as the GPU sees it. The only place that narrows positions: the eye is subtracted in f64, then f32 begins.
//!
//! It is long, but one thing: what a frame holds, how it is made of a view, and what passes ask of it; how its numbers come about has files of its own below.

use std::iter;
use std::sync::Arc;

use glam::DMat3;

use crate::data::exposure::Water;
use crate::model::sea_tables::SeaTables;
use crate::model::wave_domain::MAX_CELLS;
use crate::model::{earth, highest, lakes, moon, reefs, waves};
use crate::scene::frame::bisection::Bisection;
use crate::scene::sea::Seas;
use crate::scene::sea::foam::{self, FoamEye, Whitecaps};
use crate::scene::sea::shores::ShoreWaves;
use crate::scene::sea::surface_sample::allowed_by_depth;
use crate::scene::settings::{FoamRule, Mesh, Quality, Settings};
use crate::scene::view::camera::Camera;
use crate::scene::view::map_tiles::RELIEF_M;
pub use clouds::Clouds;
pub use place::BED_SIDE_M;
use sky_filter::SkyFilter;
pub use uniform::{FrameUniform, NEAR_M, Output};
use uniform::{SHOWS_LAND, SHOWS_SEA, SHOWS_SKY, WaveCell};

pub mod bisection;
pub mod clouds;
pub mod constants;
mod exposure;
mod light;
mod night;
mod place;
mod rim;
pub mod sky_filter;
pub mod uniform;
mod water;
mod wave_cells;

/// Share of the surface under whitecaps up to which no storm draws foam out: that of `STREAKED_IN` in `shaders/lib/lace.wgsl`.
const STREAKED_FROM: f32 = 0.05;

/// Everything that one call of `Renderer::render` draws.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The eye.
    pub camera: Camera,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// UTC, seconds since 1970.
    pub unix_seconds: f64,
    /// The sea and its patches.
    pub sea: Arc<SeaTables>,
    /// Bearing that the wind comes from, radians.
    pub wind_from: f64,
    /// Where the eye is in the foam map.
    pub foam_eye: FoamEye,
    /// The sea's whitecaps.
    pub whitecaps: Whitecaps,
    /// Lifetime of foam, seconds; `None` where the picture shows no foam map.
    pub foam_lifetime_s: Option<f64>,
    /// Height of the water at the eye's place over the ellipsoid, metres, where it is deep and the eye among the waves; elsewhere 0.
    pub surface_m: f64,
    /// Significant height of the waves at the eye's place, where land may stand in their way, metres.
    pub local_height_m: f64,
    /// Metres that no ground is higher than which an eye in space may see; nearer to the ground, than any is.
    pub highest_in_view_m: f64,
    /// Whether stars may show: it is dark at the eye, or it is in space.
    pub shows_stars: bool,
    /// Whether waves by shores are drawn as trains, where they show. For measurements.
    pub shows_trains: bool,
    /// Whether city lights may show: it is evening at the eye, or it is in space.
    pub shows_city_lights: bool,
    /// Its clouds, where there are any.
    pub clouds: Option<Clouds>,
    /// What darkens its sky.
    pub sky_filter: SkyFilter,
    /// The pixels that show any of the sky but stars to an eye in space, or of the sky beside land and sea to one that is nearer: left, top, width, height.
    pub sky_area: [u32; 4],
    /// How much the picture may cost.
    pub quality: Quality,
    /// Where the bisected mesh shall be refined, when it is drawn.
    pub bisection: Option<Bisection>,
    /// The block for the GPU.
    pub uniform: FrameUniform,
    /// And what the surface of the lake around the eye is drawn with, where pixels show its waves.
    pub lake: Option<LakeSurface>,
    /// The wave cells around the eye.
    pub wave_cells: [WaveCell; MAX_CELLS],
}

/// The block and the wave cells for a lake's surface.
#[derive(Clone, Debug)]
pub struct LakeSurface {
    /// Whose ellipsoid is the lake's level.
    pub uniform: FrameUniform,
    /// The cells about an eye that is as high over the ellipsoid as over the lake: waves are functions of places on the ellipsoid.
    pub wave_cells: [WaveCell; MAX_CELLS],
}

/// Nearer than this the FFT alone makes the waves, metres.
pub const MIX_NEAR_M: f64 = 2_000.0;
/// Farther than this the Perlin field alone does.
pub const MIX_FAR_M: f64 = 16_000.0;
/// Pixels so wide show no lace, metres: 256 texels of its widest rows (`lace_at` of `shaders/lib/lace.wgsl`), of whose variance the tile then
/// keeps less than a thirtieth.
const LACE_BLURRED_M: f32 = 64.0;
/// How far the lens is before an eye at the surface, metres: nearer water does not show.
pub const LENS_M: f64 = 0.2;
/// An eye that is nearer to the surface than this, metres, sees it cut through the picture: it reaches as far as the lens in the corners of a
/// wide picture, and the waves rise as much from there.
pub const CUT_M: f64 = 0.3;
/// From so high up, metres, an eye sees no net of light on the bed.
pub const CAUSTICS_HIGHEST_M: f64 = 40.0;
/// And none where the bed at its foot is so far below the water, metres, and no shore near: no bed about it is taken to be shallow.
const CAUSTICS_DEEPEST_M: f64 = 40.0;
/// Surf that is farther away than this, metres, and twice the eye's height, does not show.
pub const SURF_SEEN_M: f64 = 10_000.0;
/// From so high up none does, metres.
pub const SURF_HIGHEST_M: f64 = 20_000.0;
/// Farther than anything, metres.
const NEVER_M: f32 = 1e30;

/// Pixels of the largest picture whose pixels have several samples, 48 bytes each. Larger ones have pixels enough.
const MOST_SMOOTH: u64 = 2560 * 1600;
/// And of the largest whose pixels keep the place of the sea's mesh, 32 bytes each: as much memory.
const MOST_PLACED: u64 = MOST_SMOOTH * 48 / 32;

/// Cells along a side of the projected grid, at most: with two triangles each two million of them.
const MOST_CELLS: u32 = 1024;

/// Cells along the longer side of a picture, at least: the strip of them that stands on the horizon needs room at the picture's edges.
const LEAST_CELLS: u32 = 80;

/// Width of the nearest pixels, metres, from which on the sea's mesh is coarse in any picture: no wave shows, and pixels' own rays tell where
/// the sea is.
const COARSE_SEA_FROM_M: f64 = 200.0;

/// And the ground's: no mountain is much higher.
const COARSE_GROUND_FROM_M: f64 = 6_000.0;

/// How wide a camera's nearest pixels are, m.
fn nearest_pixel_m(uniform: &FrameUniform, camera: &Camera) -> f64 {
    camera.altitude_m * f64::from(uniform.pixel_angle)
}

/// Pixels along a cell of the projected grid of a picture of `size` pixels.
pub fn cell_pixels(quality: Quality, size: [u32; 2]) -> u32 {
    let wished = match quality {
        Quality::Low => (size[0].max(size[1]) / LEAST_CELLS).clamp(4, 8),
        Quality::Extreme => 2,
        _ => 4,
    };
    wished.max(size[0].max(size[1]).div_ceil(MOST_CELLS))
}

/// The globe is one disc from this height on, metres: the limb is then well below the horizon.
const LOWEST_GLOBE_M: f64 = 500_000.0;
/// And from pixels of this width on at the nadir, metres: narrower ones show more of the ground than it does.
const GLOBE_FROM_M: f64 = 0.67 * RELIEF_M;
/// How much wider than summits are high pixels are then: those are of data that have lost their tips.
const SUMMITS: f64 = 1.25;
/// So far over a lake, metres, an eye sees land mirrored in it, be it as calm as it may: only its mesh mirrors land.
const LAKE_MIRRORS_M: f64 = 400.0;

impl Frame {
    /// The frame that `camera` sees at a UTC instant, `size` in pixels, in a sea made for it alone.
    pub fn new(settings: &Settings, camera: &Camera, unix_seconds: f64, size: [u32; 2]) -> Self {
        Self::of(&mut Seas::default(), settings, camera, unix_seconds, size)
    }

    /// As [`Frame::new`], in the sea that is drawn.
    pub fn of(seas: &mut Seas, settings: &Settings, camera: &Camera, unix_seconds: f64, size: [u32; 2]) -> Self {
        let size = size.map(|side| side.max(1));
        let sea = seas.drawn(settings);
        let mut uniform = FrameUniform::default();
        place::set_view(&mut uniform, camera, size);
        place::set_earth(&mut uniform, camera, sea.sea.hs_m, sea.sea.chop);
        place::set_map(&mut uniform, camera);
        light::set_light(&mut uniform, settings.haze, camera, unix_seconds);
        water::set_sea(&mut uniform, settings, &sea);
        water::set_gusts(&mut uniform, settings.wind_from());
        let (clouds, sky_filter) = clouds::set_clouds(&mut uniform, settings, camera, unix_seconds, size);
        let is_coarse = nearest_pixel_m(&uniform, camera) > COARSE_SEA_FROM_M;
        uniform.cell_pixels = cell_pixels(if is_coarse { Quality::Low } else { settings.quality }, size) as f32;
        let (wave_cells, count, foam_eye) = wave_cells::around(&uniform, settings, camera, &sea);
        uniform.wave_cell_count = count;
        // In a trough the eye may be below the ellipsoid and over the water.
        let among_waves = camera.altitude_m.abs() < sea.crest_m() + CUT_M;
        let surface_m = if among_waves { seas.surface_height(settings, camera, unix_seconds) } else { 0.0 };
        let local_height_m =
            seas.left_by_reefs(camera.lat, camera.lon) * seas.shelter.hs_m(&sea, Water::Ocean, camera.lat, camera.lon);
        let wanted = settings.shown_foam();
        let may_show = wanted.rule == FoamRule::Folding && camera.altitude_m < foam::HIGHEST_M;
        let whitecaps = seas.whitecaps(wanted, &sea, may_show);
        let foam_lifetime_s = water::set_foam(&mut uniform, wanted, camera, &whitecaps, &foam_eye);
        uniform.clock = waves::ticks_from_unix(unix_seconds) as u32;
        (uniform.lace_texel, uniform.lace_fraction) = foam_eye.lace(settings.wind_from());
        let lake = lake(&uniform, seas, &sea, settings, camera);
        let bisection = (settings.mesh == Mesh::Bisect).then(|| Bisection::new(camera, &settings.triangles));
        let mut frame = Self {
            camera: *camera,
            size,
            unix_seconds,
            sea,
            wind_from: settings.wind_from(),
            foam_eye,
            whitecaps,
            foam_lifetime_s,
            surface_m,
            local_height_m,
            highest_in_view_m: if camera.altitude_m > LOWEST_GLOBE_M {
                highest::highest_in_view_m(camera.lat, camera.lon, camera.altitude_m)
            } else {
                RELIEF_M
            },
            shows_stars: light::stars_show(&uniform, settings),
            shows_trains: true,
            shows_city_lights: light::city_lights_show(&uniform, settings),
            clouds,
            sky_filter,
            sky_area: rim::of_sky(&uniform, camera, size),
            quality: settings.quality,
            bisection,
            uniform,
            lake,
            wave_cells,
        };
        if !frame.is_globe() {
            frame.sky_area = rim::beside_limb(&frame.uniform, camera, size);
        }
        frame
    }

    /// Whether the picture has its small and faint effects, too: all but the quality made for slow machines.
    pub fn is_fine(&self) -> bool {
        self.quality.is_fine()
    }

    /// How much wider than usual the cells of the ground's mesh are.
    pub fn wider_ground(&self) -> f64 {
        if self.is_fine() && nearest_pixel_m(&self.uniform, &self.camera) < COARSE_GROUND_FROM_M { 1.0 } else { 2.0 }
    }

    /// Whether the picture may have what a graphics card draws with ease and a software rasteriser does not.
    fn is_rich(&self, software: bool) -> bool {
        match self.quality {
            Quality::Auto => !software,
            Quality::Low | Quality::Medium => false,
            Quality::High | Quality::Ultra | Quality::Extreme => true,
        }
    }

    /// Whether the edges of waves are smooth: pixels have several samples. To a software rasteriser these cost nearly as much as the
    /// picture does without, as triangles are few pixels wide.
    pub fn has_smooth_edges(&self, software: bool) -> bool {
        self.is_rich(software) && self.has_light() && self.pixels() <= MOST_SMOOTH
    }

    /// Whether pixels of one sample keep the place of the sea's mesh, so that each is shaded once.
    pub fn keeps_places(&self) -> bool {
        self.is_fine() && self.has_light() && self.pixels() <= MOST_PLACED
    }

    fn pixels(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1])
    }

    /// Metres of the eye over the water of a depth in metres, which holds waves up to a part of that; by a shore, over that of the trains with as
    /// much of the rest as they leave in the mean.
    pub fn over_water_m(&self, depth_m: f64, shore: Option<&ShoreWaves>) -> f64 {
        let (level, rise_m) = shore.map_or((1.0, 0.0), |shore| (shore.level, shore.wave.rise));
        self.camera.altitude_m
            - allowed_by_depth(depth_m, level * self.local_height_m) * level * self.surface_m
            - rise_m
    }

    /// The same frame, reporting a measured layer instead of the picture.
    pub fn measuring(mut self, output: Output) -> Self {
        for block in self.blocks() {
            block.output = output as u32;
        }
        self
    }

    /// The same frame without the Perlin field: the patches make the waves at any distance. For measurements.
    pub fn without_noise(mut self) -> Self {
        for block in self.blocks() {
            (block.mix_near, block.mix_far) = (NEVER_M, 2.0 * NEVER_M);
        }
        self
    }

    /// Draws the water with cells of its grid so many pixels wide.
    pub fn set_cell_pixels(&mut self, cell_pixels: f32) {
        for block in self.blocks() {
            block.cell_pixels = cell_pixels;
        }
    }

    fn blocks(&mut self) -> impl Iterator<Item = &mut FrameUniform> {
        iter::once(&mut self.uniform).chain(self.lake.as_mut().map(|lake| &mut lake.uniform))
    }

    /// Whether light is seen, and with it foam and air: measured layers tell of shapes and places alone.
    pub fn has_light(&self) -> bool {
        self.uniform.output == Output::Picture as u32
    }

    /// Whether anything of the wave patches can be seen: not from where the Perlin field alone makes the sea, nor where a pixel hides all.
    pub fn has_waves(&self) -> bool {
        self.nearest_sea_m() < self.uniform.mix_far && self.resolves_waves()
    }

    /// Whether anything of the Perlin field can be seen.
    pub fn has_noise(&self) -> bool {
        self.uniform.mix_near < NEVER_M && self.resolves_waves()
    }

    /// Whether more is seen of foam than the share that the wind asks for: its map, or its lace.
    pub fn has_foam(&self) -> bool {
        self.nearest_sea_m() < foam::HIGHEST_M as f32
            || self.nearest_sea_m() * self.uniform.pixel_angle < LACE_BLURRED_M
    }

    /// Whether spray is seen.
    pub fn has_spray(&self) -> bool {
        self.uniform.spray > 0.0
    }

    /// Whether places may be seen that are so near to the equator that coral reefs may be made up there.
    pub fn has_reefs(&self) -> bool {
        let over = |height_m: f64| libm::acos(earth::WGS84.b / (earth::WGS84.b + height_m.max(0.0)));
        let seen = over(self.camera.altitude_m) + over(RELIEF_M) + rim::MARGIN;
        libm::sin((self.camera.lat.abs() - seen).max(0.0)) < reefs::WARM[1]
    }

    /// Whether storms have drawn foam out along the wind.
    pub fn has_streaks(&self) -> bool {
        self.uniform.whitecaps > STREAKED_FROM
    }

    /// Whether spindrift is seen, which stands over the foam map's breaking crests.
    pub fn has_spindrift(&self) -> bool {
        let is_drawn = self.is_fine() && self.has_light() && self.uniform.layers & SHOWS_SEA != 0;
        is_drawn
            && self.uniform.spindrift > 0.0
            && self.has_spray()
            && self.has_waves()
            && self.foam_lifetime_s.is_some()
    }

    /// Whether the whole globe is seen from space: below the eye the picture's middle pixel would be wider than the highest summit in view is high,
    /// the ellipsoid is all of its shape, and no layer is left out. A wide picture's corners have pixels half as wide. Measured layers, which tell heights, change
    /// where pixels are wider than any summit is high.
    pub fn is_globe(&self) -> bool {
        let all = SHOWS_LAND | SHOWS_SEA | SHOWS_SKY;
        let highest_m = if self.has_light() { (SUMMITS * self.highest_in_view_m).max(GLOBE_FROM_M) } else { RELIEF_M };
        self.uniform.layers & all == all
            && self.camera.altitude_m > LOWEST_GLOBE_M
            && nearest_pixel_m(&self.uniform, &self.camera) > highest_m
    }

    /// Whether clouds are drawn as on the whole globe: where pixels are wider than any summit is high.
    pub fn has_clouds_of_globe(&self) -> bool {
        self.is_globe() && nearest_pixel_m(&self.uniform, &self.camera) > RELIEF_M
    }

    /// Whether surf may show, with the nearest shore so far from the eye's foot, metres: none does that is farther away than
    /// [`SURF_SEEN_M`] and twice the eye's height, nor from [`SURF_HIGHEST_M`] on, where shaders let it go.
    pub fn shows_surf(&self, shore_m: f64) -> bool {
        // A calm sea has no frequency to break with.
        if self.sea.sea.hs_m == 0.0 {
            return false;
        }
        let altitude_m = self.camera.altitude_m.max(0.0);
        altitude_m < SURF_HIGHEST_M && shore_m < SURF_SEEN_M + 2.0 * altitude_m
    }

    /// Whether an eye over the water may see the net of light that waves gather on the bed, which is so deep at its foot if there is any, and so far
    /// from a shore, both in metres. A software rasteriser takes a third of a picture's time for the net.
    pub fn lights_bed(&self, software: bool, depth_m: Option<f64>, shore_m: f64) -> bool {
        let is_shallow = depth_m.is_some_and(|depth_m| depth_m < CAUSTICS_DEEPEST_M);
        let is_near = self.camera.altitude_m < CAUSTICS_HIGHEST_M && (is_shallow || shore_m < 5.0 * CAUSTICS_HIGHEST_M);
        let both = SHOWS_LAND | SHOWS_SEA;
        let is_wanted = self.is_rich(software) && self.has_light() && self.uniform.layers & both == both;
        is_near && is_wanted && self.has_waves() && self.sea.sea.hs_m > 0.0 && self.uniform.light.z > 0.05
    }

    /// A distance that no water is nearer than, metres.
    fn nearest_sea_m(&self) -> f32 {
        self.uniform.eye_altitude - self.uniform.crest_height
    }

    /// What `any_resolvable` of `shaders/lib/wave_patches.wgsl` says where the water is nearest: a pixel as wide as 0.4 of the longest
    /// patch shows none of it.
    fn resolves_waves(&self) -> bool {
        let longest = self.uniform.patches.x.max(self.uniform.perlin_patch);
        self.nearest_sea_m() * self.uniform.pixel_angle < 0.4 * longest
    }

    /// From equatorial axes of J2000.0 to the frame's east, north and up: where stars stand.
    pub fn from_j2000(&self) -> DMat3 {
        earth::ecef_from_enu(self.camera.lat, self.camera.lon).transpose() * moon::ecef_from_j2000(self.unix_seconds)
    }

    /// The frame's instant in ticks of the wave clock, see [`crate::model::waves::TICKS_PER_SECOND`].
    pub fn ticks(&self) -> u64 {
        waves::ticks_from_unix(self.unix_seconds)
    }
}

/// What is drawn of the lake around an eye over it, with `sea`'s waves as land lets them grow there, if it is one whose level is known and they are
/// not much smaller than its nearest pixels, or it is near enough to mirror its shores.
fn lake(u: &FrameUniform, seas: &Seas, sea: &SeaTables, settings: &Settings, camera: &Camera) -> Option<LakeSurface> {
    if !settings.quality.is_fine() {
        return None;
    }
    let level_m = lakes::at(camera.lat, camera.lon).map(|lake| lake.level_m);
    let level_m = level_m.or_else(|| seas.shelter.lake_level_m(camera.lat, camera.lon))?;
    let over_m = camera.altitude_m - level_m;
    let hs_m = seas.shelter.hs_m(sea, Water::Lake, camera.lat, camera.lon);
    // As long as a crest is a quarter of a pixel.
    let is_far = over_m > LAKE_MIRRORS_M && over_m * f64::from(u.pixel_angle) >= 4.0 * hs_m;
    if over_m <= 0.0 || is_far {
        return None;
    }
    let mut uniform = *u;
    place::set_water_level(&mut uniform, camera, level_m, hs_m, sea.sea.chop);
    let lowered = Camera { altitude_m: over_m, ..*camera };
    let (wave_cells, count, foam_eye) = wave_cells::around(&uniform, settings, &lowered, sea);
    uniform.wave_cell_count = count;
    (uniform.lace_texel, uniform.lace_fraction) = foam_eye.lace(settings.wind_from());
    Some(LakeSurface { uniform, wave_cells })
}
