//! The sea: wind, waves, gusts, foam and spray.

use glam::{DVec2, DVec4, Vec2, Vec4};

use crate::model::sea_bed::smoothstep;
use crate::model::sea_tables::SeaTables;
use crate::model::{self, sea_state, spray, wave_domain};
use crate::scene::frame::uniform::{FoamLevel, FrameUniform, SHOWS_LAND, SHOWS_LIGHTS, SHOWS_SEA, SHOWS_SKY};
use crate::scene::frame::{MIX_FAR_M, MIX_NEAR_M};
use crate::scene::layers::Layer;
use crate::scene::sea::foam::{self, FoamEye, Whitecaps};
use crate::scene::settings::{Foam, FoamRule, Settings};
use crate::scene::view::camera::Camera;

/// Height of a wave over the depth that it breaks in: between those of spilling and of plunging breakers.
const SURF_BREAKS: f64 = 0.6;
/// Lifetime of white water where foam does not show, s.
const NO_FOAM_S: f64 = 1e-3;
/// For how long the front of a breaker is dense, s.
const FRONT_S: f64 = 0.9;

/// Heights of the eye between which spindrift leaves the picture, metres: from above its squares would show.
const SPINDRIFT_TO_M: [f64; 2] = [80.0, 250.0];

/// Wind, waves and their statistics, spray, and which layers show.
pub fn set_sea(u: &mut FrameUniform, settings: &Settings, sea: &SeaTables) {
    let speed = settings.wind_speed_mps();
    let (east, north) = sea_state::wind_components(speed, settings.wind.from_deg.to_radians());
    u.wind = Vec2::new(east as f32, north as f32);
    u.water_kinds = settings.water.kinds().map(|kind| kind as f32);
    u.water_density = settings.water_density_per_m as f32;
    u.wave_height = sea.sea.hs_m as f32;
    // Seas of the wind have a steepness of about 0.04; the shortest waves that are seen to break take two seconds.
    let period_s = (4.0 * libm::sqrt(sea.sea.hs_m)).max(2.0);
    // On a plane beach the width of the surf is the depth that waves break in over the slope.
    let breaks = SURF_BREAKS / settings.surf.width.max(1e-3);
    let white_s = if settings.shown_foam().amount > 0.0 { model::foam::LIFETIME_S } else { NO_FOAM_S };
    u.surf = DVec4::new(period_s, white_s.min(FRONT_S), breaks, white_s).as_vec4();
    (u.shore.x, u.shore.y) = (settings.surf.beach_slope as f32, settings.surf.width as f32);
    let is_foaming = settings.shown_foam().amount > 0.0;
    let extinction = if is_foaming { spray::extinction_per_m(speed) } else { 0.0 };
    let height = spray::scale_height_m(sea.sea.hs_m);
    u.spray = (extinction * spray::shown(extinction, height, u.eye_altitude.into())) as f32;
    let shown = 1.0 - smoothstep(SPINDRIFT_TO_M[0], SPINDRIFT_TO_M[1], u.eye_altitude.into());
    u.spindrift = if is_foaming { (spray::spindrift(speed) * shown) as f32 } else { 0.0 };
    u.chop = sea.sea.chop as f32;
    u.chop_level = sea.chop_level_m as f32;
    u.cascade_levels = Vec4::from(sea.cascade_levels.map(|share| share as f32));
    u.cascade_shares = Vec4::from(sea.cascade_shares.map(|share| share as f32));
    u.mix_near = MIX_NEAR_M as f32;
    u.mix_far = MIX_FAR_M as f32;
    u.perlin_patch = sea.perlin.patch_m as f32;
    u.patches = Vec4::from(sea.cascades.map(|cascade| cascade.patch_m as f32));
    u.spacings = Vec4::from(sea.cascades.map(|cascade| wave_domain::spacing_m(cascade.patch_m) as f32));
    u.perlin_spacing = wave_domain::spacing_m(sea.perlin.patch_m) as f32;
    let shows = |layer, bit: u32| if settings.layers.shows(layer) { bit } else { 0 };
    u.layers = shows(Layer::Land, SHOWS_LAND)
        | shows(Layer::Sea, SHOWS_SEA)
        | shows(Layer::Sky, SHOWS_SKY)
        | shows(Layer::Lights, SHOWS_LIGHTS);
    let slopes = sea.cascade_slopes.map(|slopes| DVec2::from(slopes).as_vec2());
    u.cascade_slopes = [0, 2].map(|i| Vec4::from((slopes[i], slopes[i + 1])));
    u.below_slopes = DVec2::from(sea.below_slopes).as_vec2();
    let ([x, y], [rough_x, rough_y]) = (sea.perlin.slopes, sea.perlin.rough);
    u.perlin_slopes = DVec4::new(rough_x, rough_y, x, y).as_vec4();
}

/// The map of gusts is the Mercator square, turned into the wind and pressed along it: as `shaders/lib/gusts.wgsl`.
pub fn set_gusts(u: &mut FrameUniform, wind_from: f64) {
    const LENGTH: f64 = 3.0;
    let (sin, cos) = libm::sincos(wind_from);
    let (eye, axis) = (DVec2::from(u.mercator_fixed.map(f64::from)), DVec2::new(-sin, cos));
    u.gust_axis = axis.as_vec2();
    u.gust_origin = [axis.dot(eye) / LENGTH, axis.perp_dot(eye)].map(|part| part.rem_euclid(2f64.powi(32)) as u32);
}

/// The foam map's squares; returns the foam's lifetime where the picture shows the map.
pub fn set_foam(
    u: &mut FrameUniform,
    wanted: Foam,
    camera: &Camera,
    whitecaps: &Whitecaps,
    eye: &FoamEye,
) -> Option<f64> {
    u.whitecaps = whitecaps.share as f32;
    u.film = DVec2::from(whitecaps.film).as_vec2();
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
