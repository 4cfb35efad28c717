//! One frame as the GPU sees it. The only place that narrows positions: the eye is subtracted in f64, then f32 begins.

use std::sync::Arc;

use glam::{DMat3, DVec2, DVec3, DVec4, Mat4, Vec2, Vec4};

use crate::data::tile::{MERCATOR_LATITUDE_LIMIT, MapPoint, Projection};
use crate::model::clouds::{self, Weather};
use crate::model::earth::{self, WGS84};
use crate::model::sea_tables::SeaTables;
use crate::model::wave_domain::{self, MAX_CELLS};
use crate::model::{moon, sea_state, spray, sun, waves};
use crate::scene::frame::bisection::Bisection;
use crate::scene::layers::Layer;
use crate::scene::sea::Seas;
use crate::scene::sea::foam::{self, FoamEye, Whitecaps};
use crate::scene::settings::{Foam, FoamRule, Mesh, Quality, Settings};
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};
use crate::scene::view::map_tiles::RELIEF_M;
use exposure::exposure;
use uniform::{FoamLevel, SHOWS_LAND, SHOWS_SEA, SHOWS_SKY, WaveCell};
pub use uniform::{FrameUniform, NEAR_M, Output};

pub mod bisection;
mod exposure;
mod night;
pub mod uniform;
mod wave_cells;

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
    /// Where the eye is in the foam map.
    pub foam_eye: FoamEye,
    /// The sea's whitecaps.
    pub whitecaps: Whitecaps,
    /// Lifetime of foam, seconds; `None` where the picture shows no foam map.
    pub foam_lifetime_s: Option<f64>,
    /// Whether stars may show: it is dark at the eye, or it is in space.
    pub shows_stars: bool,
    /// Whether city lights may show: it is evening at the eye, or it is in space.
    pub shows_city_lights: bool,
    /// The clouds' weather, where there are clouds.
    pub weather: Option<Weather>,
    /// How much the picture may cost.
    pub quality: Quality,
    /// Where the bisected mesh shall be refined, when it is drawn.
    pub bisection: Option<Bisection>,
    /// The block for the GPU.
    pub uniform: FrameUniform,
    /// The wave cells around the eye.
    pub wave_cells: [WaveCell; MAX_CELLS],
}

/// Nearer than this the FFT alone makes the waves, metres.
pub const MIX_NEAR_M: f64 = 2_000.0;
/// Farther than this the Perlin field alone does.
pub const MIX_FAR_M: f64 = 16_000.0;
/// Pixels so wide show no lace, metres: 128 texels of its widest rows (`lace_at` of `shaders/lib/lace.wgsl`), of whose variance the tile then
/// keeps a thirtieth.
const LACE_BLURRED_M: f32 = 64.0;
/// Sine of the sun's elevation from which on no star is seen from the ground.
const STARS_BELOW: f32 = -0.03;
/// And from which on no lamp is lit as far as an eye sees that is not in space.
const LIGHTS_BELOW: f32 = 0.07;
/// From here on stars are seen by day, metres: where the sky is dark.
const STARS_ABOVE_M: f32 = 20_000.0;
/// Over which the air thins out by a factor of e, metres.
const AIR_HEIGHT_M: f64 = 8_000.0;
/// Farther than anything, metres.
const NEVER_M: f32 = 1e30;

/// Pixels of the largest picture whose pixels have several samples, 48 bytes each. Larger ones have pixels enough.
const MOST_SMOOTH: u64 = 2560 * 1600;

/// Cells along a side of the projected grid, at most: with two triangles each two million of them.
const MOST_CELLS: u32 = 1024;

/// Pixels along a cell of the projected grid of a picture of `size` pixels.
pub fn cell_pixels(quality: Quality, size: [u32; 2]) -> u32 {
    let wished = if quality == Quality::Extreme { 2 } else { 4 };
    wished.max(size[0].max(size[1]).div_ceil(MOST_CELLS))
}

/// The globe is one disc from this height on, metres: the limb is then well below the horizon.
const LOWEST_GLOBE_M: f64 = 500_000.0;

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
        set_view(&mut uniform, camera, size);
        set_earth(&mut uniform, camera, sea.sea.hs_m, sea.sea.chop);
        set_map(&mut uniform, camera);
        set_light(&mut uniform, settings.haze, camera, unix_seconds);
        set_sea(&mut uniform, settings, &sea);
        set_gusts(&mut uniform, settings.wind_from());
        let weather = set_clouds(&mut uniform, settings, camera, unix_seconds);
        uniform.cell_pixels = cell_pixels(settings.quality, size) as f32;
        let (wave_cells, count, foam_eye) = wave_cells::around(&uniform, settings, camera, &sea);
        uniform.wave_cell_count = count;
        // In a trough the eye may be below the ellipsoid and over the water.
        let below = camera.altitude_m < 0.0
            && (camera.altitude_m < -sea.crest_m()
                || camera.altitude_m < seas.surface_height(settings, camera, unix_seconds));
        uniform.under_water = u32::from(below);
        let wanted = settings.shown_foam();
        let may_show = wanted.rule == FoamRule::Folding && camera.altitude_m < foam::HIGHEST_M;
        let whitecaps = seas.whitecaps(wanted, &sea, may_show);
        let foam_lifetime_s = set_foam(&mut uniform, wanted, camera, &whitecaps, &foam_eye);
        uniform.clock = waves::ticks_from_unix(unix_seconds) as u32;
        (uniform.lace_texel, uniform.lace_fraction) = foam_eye.lace(settings.wind_from());
        let bisection = (settings.mesh == Mesh::Bisect).then(|| Bisection::new(camera, &settings.triangles));
        Self {
            camera: *camera,
            size,
            unix_seconds,
            sea,
            foam_eye,
            whitecaps,
            foam_lifetime_s,
            shows_stars: stars_show(&uniform, settings),
            shows_city_lights: city_lights_show(&uniform, settings),
            weather,
            quality: settings.quality,
            bisection,
            uniform,
            wave_cells,
        }
    }

    /// Whether the picture has its small and faint effects, too: all but the quality made for slow machines.
    pub fn is_fine(&self) -> bool {
        self.quality != Quality::Low
    }

    /// Whether the edges of waves are smooth: pixels have several samples. To a software rasteriser these cost nearly as much as the
    /// picture does without, as triangles are few pixels wide.
    pub fn has_smooth_edges(&self, software: bool) -> bool {
        let wanted = match self.quality {
            Quality::Auto => !software,
            Quality::Low | Quality::Medium => false,
            Quality::High | Quality::Ultra | Quality::Extreme => true,
        };
        wanted && self.has_light() && u64::from(self.size[0]) * u64::from(self.size[1]) <= MOST_SMOOTH
    }

    /// The same frame, reporting a measured layer instead of the picture.
    pub fn measuring(mut self, output: Output) -> Self {
        self.uniform.output = output as u32;
        self
    }

    /// The same frame without the Perlin field: the patches make the waves at any distance. For measurements.
    pub fn without_noise(mut self) -> Self {
        (self.uniform.mix_near, self.uniform.mix_far) = (NEVER_M, 2.0 * NEVER_M);
        self
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

    /// Whether clouds may stand before land and sea.
    pub fn is_above_clouds(&self) -> bool {
        self.camera.altitude_m > clouds::BASE_M
    }

    /// Whether spray is seen.
    pub fn has_spray(&self) -> bool {
        self.uniform.spray.x > 0.0
    }

    /// Whether the whole globe is seen from space: below the eye the picture's middle pixel would be wider than the highest summit is high,
    /// the ellipsoid is all of its shape, and no layer is left out. A wide picture's corners have pixels half as wide.
    pub fn is_globe(&self) -> bool {
        let all = SHOWS_LAND | SHOWS_SEA | SHOWS_SKY;
        let pixel_m = self.camera.altitude_m * f64::from(self.uniform.pixel_angle);
        self.uniform.layers & all == all && pixel_m > RELIEF_M && self.camera.altitude_m > LOWEST_GLOBE_M
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

fn set_view(u: &mut FrameUniform, camera: &Camera, size: [u32; 2]) {
    let axes = camera.basis_enu();
    let half = libm::tan(FIELD_OF_VIEW_Y / 2.0);
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    u.ray_right = (axes.right * half * aspect).as_vec3();
    u.ray_up = (axes.up * half).as_vec3();
    u.ray_forward = axes.forward.as_vec3();
    // Reversed depth, infinite far plane: clip = (x / aspect / half, y / half, near, distance along the view axis).
    let (right, up, forward) = (axes.right / (half * aspect), axes.up / half, axes.forward);
    let row = |v: DVec3, w: f64| Vec4::new(v.x as f32, v.y as f32, v.z as f32, w as f32);
    u.clip_from_local =
        Mat4::from_cols(row(right, 0.0), row(up, 0.0), row(DVec3::ZERO, NEAR_M), row(forward, 0.0)).transpose();
    u.viewport = Vec2::new(size[0] as f32, size[1] as f32);
    u.pixel_angle = (2.0 * half / f64::from(size[1])) as f32;
}

/// The ellipsoid as the quadric C + 2 g·P + P'QP about the eye, scaled to metres (F ≈ height near the surface).
fn set_earth(u: &mut FrameUniform, camera: &Camera, hs_m: f64, chop: f64) {
    let (a, b) = (WGS84.a, WGS84.b);
    let enu = earth::ecef_from_enu(camera.lat, camera.lon);
    let scale = 0.5 * a;
    let diagonal = DMat3::from_diagonal(scale / DVec3::new(a * a, a * a, b * b));
    let q = enu.transpose() * diagonal * enu;
    let (sin, cos) = libm::sincos(camera.lat);
    let nu = (a * a * cos * cos + b * b * sin * sin).sqrt();
    // The foot's gradient is exactly along its normal; the height adds Q·h·up. F(eye) follows without cancellation.
    let gradient_at = |h: f64| DVec3::new(0.0, 0.0, scale / nu) + q * DVec3::new(0.0, 0.0, h);
    let constant_at = |h: f64| 2.0 * h * scale / nu + h * h * q.z_axis.z;
    let h = camera.altitude_m;
    let crest = 1.1 * hs_m;
    let above = if h < 40.0 * crest { (1.3 * crest + 0.6 - h).max(0.0) } else { 0.0 };
    // From below, the grid is that of the mirrored eye above the surface.
    let rise = above.max(-2.0 * h);
    u.eye_altitude = h as f32;
    u.air_sink = -libm::expm1(-h.max(0.0) / AIR_HEIGHT_M) as f32;
    u.semi_major = a as f32;
    u.semi_minor = b as f32;
    u.quadric_diagonal = DVec3::new(q.x_axis.x, q.y_axis.y, q.z_axis.z).as_vec3();
    u.quadric_mixed = DVec3::new(q.y_axis.x, q.z_axis.x, q.z_axis.y).as_vec3();
    u.quadric_constant = constant_at(h) as f32;
    u.quadric_gradient = gradient_at(h).as_vec3();
    u.projector_rise = rise as f32;
    u.projector_constant = constant_at(h + rise) as f32;
    u.projector_gradient = gradient_at(h + rise).as_vec3();
    // Horizontal displacements are about as large as crests are high, times λ.
    u.rim_reach = if h < 40.0 * crest { (2.0 * crest * chop.max(0.5)) as f32 } else { 0.0 };
    u.crest_height = crest.max(0.05) as f32;
    u.sin_lat = sin as f32;
    u.cos_lat = cos as f32;
    u.foot_nu = nu as f32;
}

/// The reference points of the three map squares: the eye's foot where the square holds it, else its nearest anchor.
fn set_map(u: &mut FrameUniform, camera: &Camera) {
    let (lat, lon) = (camera.lat, camera.lon);
    let anchor = lat.clamp(-MERCATOR_LATITUDE_LIMIT + 0.01, MERCATOR_LATITUDE_LIMIT - 0.01);
    let fixed = |projection, lat: f64, lon: f64| {
        let p = MapPoint::on(projection, lat, lon);
        [p.u, p.v]
    };
    u.mercator_sin = libm::sin(anchor) as f32;
    u.mercator_sin_delta = (libm::sin(lat) - libm::sin(anchor)) as f32;
    u.mercator_fixed = fixed(Projection::Mercator, anchor, lon);
    u.meridian = DVec2::new(libm::cos(lon), libm::sin(lon)).as_vec2();
    let foot = DVec3::new(libm::cos(lat), 0.0, libm::sin(lat));
    let polar = |side: f64, projection| {
        let near = lat * side > 80f64.to_radians();
        let point = if near { DVec2::new(foot.x / (1.0 + side * foot.z), 0.0) } else { DVec2::ZERO };
        let reference = if near { foot } else { DVec3::new(0.0, 0.0, side) };
        let at = if near { lat } else { side * std::f64::consts::FRAC_PI_2 };
        (point.as_vec2(), (foot - reference).as_vec3(), fixed(projection, at, lon))
    };
    (u.north_point, u.north_delta, u.north_fixed) = polar(1.0, Projection::North);
    (u.south_point, u.south_delta, u.south_fixed) = polar(-1.0, Projection::South);
}

fn set_light(u: &mut FrameUniform, haze: f64, camera: &Camera, unix_seconds: f64) {
    let enu_from_ecef = earth::ecef_from_enu(camera.lat, camera.lon).transpose();
    let sun = enu_from_ecef * sun::sun_direction_ecef(unix_seconds);
    let moon = enu_from_ecef * (moon::position_ecef(unix_seconds) - camera.eye_ecef()).normalize();
    let moonlight = night::moonlight(sun, moon, camera.altitude_m);
    // To 0.007 degrees: what is tabulated for a sun lasts for a second and more of a running clock.
    let steps = f64::from(1 << 13);
    let light = if moonlight.is_some() { moon } else { sun };
    u.light = ((light * steps).round() / steps).normalize().as_vec3();
    // All radiances are of a light of 1; a picture by moonlight is exposed for so much more.
    let unit = moonlight.unwrap_or(1.0);
    u.exposure = (exposure(sun.z, camera.altitude_m) * unit) as f32;
    u.night = (1.0 / unit) as f32;
    u.night_ground = night::ground_share(camera.altitude_m) as f32;
    u.moon = moon.as_vec3();
    u.moon_radiance = (night::disc_radiance(sun.z, camera.altitude_m) / unit) as f32;
    u.sun = sun.as_vec3();
    u.by_day = f32::from(u8::from(moonlight.is_none()));
    u.haze = haze as f32;
}

/// Whether stars are worth drawing.
fn stars_show(u: &FrameUniform, settings: &Settings) -> bool {
    let wanted = [Layer::Sky, Layer::Stars].iter().all(|layer| settings.layers.shows(*layer));
    wanted && (u.sun.z < STARS_BELOW || u.eye_altitude > STARS_ABOVE_M)
}

/// Whether city lights are worth looking for.
fn city_lights_show(u: &FrameUniform, settings: &Settings) -> bool {
    let wanted = [Layer::Land, Layer::Lights].iter().all(|layer| settings.layers.shows(*layer));
    wanted && (u.sun.z < LIGHTS_BELOW || u.eye_altitude > STARS_ABOVE_M)
}

/// The map of gusts is the Mercator square, turned into the wind and pressed along it: as `shaders/lib/gusts.wgsl`.
fn set_gusts(u: &mut FrameUniform, wind_from: f64) {
    const LENGTH: f64 = 3.0;
    let (sin, cos) = libm::sincos(wind_from);
    let (eye, axis) = (DVec2::from(u.mercator_fixed.map(f64::from)), DVec2::new(-sin, cos));
    u.gust_axis = axis.as_vec2();
    u.gust_origin = [axis.dot(eye) / LENGTH, axis.perp_dot(eye)].map(|part| part.rem_euclid(2f64.powi(32)) as u32);
}

/// Where the eye is among the clouds; returns their weather, where there are any.
fn set_clouds(u: &mut FrameUniform, settings: &Settings, camera: &Camera, unix_seconds: f64) -> Option<Weather> {
    let drift = clouds::drift(unix_seconds);
    let (sin, cos) = libm::sincos(drift);
    let eye = camera.eye_ecef();
    u.cloud_eye = DVec3::new(cos * eye.x + sin * eye.y, cos * eye.y - sin * eye.x, eye.z).as_vec3();
    let (sin, cos) = libm::sincos(camera.lon - drift);
    u.cloud_meridian = DVec2::new(cos, sin).as_vec2();
    u.cloud_shift = clouds::shift(settings.clouds) as f32;
    let shown = settings.clouds > 0.0 && settings.layers.shows(Layer::Clouds) && settings.layers.shows(Layer::Sky);
    shown.then(|| clouds::weather(unix_seconds))
}

fn set_sea(u: &mut FrameUniform, settings: &Settings, sea: &SeaTables) {
    let speed = settings.wind_speed_mps();
    let (east, north) = sea_state::wind_components(speed, settings.wind.from_deg.to_radians());
    u.wind = Vec2::new(east as f32, north as f32);
    u.water_kinds = settings.water.kinds().map(|kind| kind as f32);
    u.water_density = settings.water_density_per_m as f32;
    u.wave_height = sea.sea.hs_m as f32;
    let extinction = if settings.shown_foam().amount > 0.0 { spray::extinction_per_m(speed) } else { 0.0 };
    let height = spray::scale_height_m(sea.sea.hs_m);
    u.spray = DVec2::new(extinction * spray::shown(extinction, height, u.eye_altitude.into()), height).as_vec2();
    u.chop = sea.sea.chop as f32;
    u.chop_level = sea.chop_level_m as f32;
    u.mix_near = MIX_NEAR_M as f32;
    u.mix_far = MIX_FAR_M as f32;
    u.perlin_patch = sea.perlin.patch_m as f32;
    u.patches = Vec4::from(sea.cascades.map(|cascade| cascade.patch_m as f32));
    u.spacings = Vec4::from(sea.cascades.map(|cascade| wave_domain::spacing_m(cascade.patch_m) as f32));
    u.perlin_spacing = wave_domain::spacing_m(sea.perlin.patch_m) as f32;
    u.cascade_count = sea.cascades.len() as u32;
    let shows = |layer, bit: u32| if settings.layers.shows(layer) { bit } else { 0 };
    u.layers = shows(Layer::Land, SHOWS_LAND) | shows(Layer::Sea, SHOWS_SEA) | shows(Layer::Sky, SHOWS_SKY);
    let slopes = sea.cascade_slopes.map(|slopes| DVec2::from(slopes).as_vec2());
    u.cascade_slopes = [0, 2].map(|i| Vec4::from((slopes[i], slopes[i + 1])));
    u.below_slopes = DVec2::from(sea.below_slopes).as_vec2();
    let ([x, y], [rough_x, rough_y]) = (sea.perlin.slopes, sea.perlin.rough);
    u.perlin_slopes = DVec4::new(rough_x, rough_y, x, y).as_vec4();
}

/// The foam map's squares; returns the foam's lifetime where the picture shows the map.
fn set_foam(u: &mut FrameUniform, wanted: Foam, camera: &Camera, whitecaps: &Whitecaps, eye: &FoamEye) -> Option<f64> {
    u.whitecaps = whitecaps.share as f32;
    u.foam_heights = DVec2::from(whitecaps.heights_m).as_vec2();
    for (level, slot) in u.foam_levels.iter_mut().enumerate() {
        let (texel, fraction) = eye.texel(level);
        let fold = whitecaps.folds[level];
        let (threshold, softness) = (fold.threshold.max(-1e9) as f32, fold.softness as f32);
        *slot = FoamLevel {
            texel,
            fraction,
            side: foam::TEXELS_M[level] as f32,
            threshold,
            softness,
            breaking: whitecaps.breaking_m[level] as f32,
        };
    }
    let shown = whitecaps.share > 1e-6 && camera.altitude_m < foam::HIGHEST_M;
    // The numbers of `shaders/lib/foam.wgsl`: the map, the height, the share alone.
    u.foam_rule = match wanted.rule {
        FoamRule::Height => 1,
        FoamRule::Folding if shown => 0,
        FoamRule::Folding => 2,
    };
    (u.foam_rule == 0).then_some(wanted.lifetime_s)
}
