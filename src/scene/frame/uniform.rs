//! What the GPU reads of a frame: plain memory, declared here once for Rust and for the shaders (`#import frame_memory`).
//!
//! Local frame: metres, origin at the eye, x east, y north, z along the geodetic normal of the eye's foot point.
//! Map squares: 0 Mercator, 1 north stereographic, 2 south stereographic; fixed point, 2^32 = one side, x right, y down.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec3, Vec4};

use crate::model::wave_domain::PATCHES;
use crate::scene::sea::foam;

/// Distance of the near plane, metres; equals `NEAR` in `shaders/lib/frame.wgsl`. There is no far plane.
pub const NEAR_M: f64 = 0.1;

/// Bits of [`FrameUniform::layers`].
pub const SHOWS_LAND: u32 = 1;
/// See [`SHOWS_LAND`].
pub const SHOWS_SEA: u32 = 2;
/// See [`SHOWS_LAND`].
pub const SHOWS_SKY: u32 = 4;
/// Land is so near that water mirrors it, as only the world knows.
pub const MIRRORS_LAND: u32 = 8;
/// See [`SHOWS_LAND`]: towns' lamps.
pub const SHOWS_LIGHTS: u32 = 16;

/// What each pixel reports. The numbers are those of `shaders/lib/output.wgsl`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Output {
    /// The picture.
    #[default]
    Picture = 0,
    /// Degrees of longitude and latitude relative to the eye's foot; distance.
    LonLat = 1,
    /// Depth of the water in metres.
    Depth = 2,
    /// Opacity of the water, 0 on land.
    Mask = 3,
    /// Height of the surface over the ellipsoid in metres.
    Height = 4,
    /// Unit normal, east, north, up at the eye.
    Normal = 5,
    /// 0 land, 1 ocean, 2 lake, 3 river.
    Class = 6,
    /// Weight of the Perlin field in the mix.
    PerlinWeight = 7,
    /// Linear albedo of the ground, 0 where the sea covers it.
    Albedo = 8,
}

/// Declares memory that Rust and the shaders share: a struct, its text in WGSL, and its members with their offsets, which a test
/// compares with those that WGSL's layout rules give.
macro_rules! gpu_struct {
    ($(#[$doc:meta])* pub struct $name:ident as $wgsl:literal {
        $($(#[$member_doc:meta])* $member:ident: $rust:ty = $type:literal,)*
    }) => {
        $(#[$doc])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
        pub struct $name { $($(#[$member_doc])* pub $member: $rust,)* }

        impl $name {
            /// The struct's declaration in WGSL.
            pub const WGSL: &str = concat!("struct ", $wgsl, " {\n", $("    ", stringify!($member), ": ", $type, ",\n",)* "}\n");
            /// Name and offset of every member, bytes.
            pub const MEMBERS: &[(&str, usize)] = &[$((stringify!($member), std::mem::offset_of!($name, $member))),*];
        }
    };
}

gpu_struct! {
    /// A level of the foam map; its texels are fixed in the plane of the first wave cell.
    pub struct FoamLevel as "FoamLevel" {
        /// That the eye is in.
        texel: [i32; 2] = "vec2i",
        /// Of a texel from its corner to the eye.
        fraction: [f32; 2] = "vec2f",
        /// Of a texel.
        side: f32 = "Metres",
        /// Smaller eigenvalue of the chop's gradient below which whitecaps begin.
        threshold: f32 = "f32",
        /// How far below it a texel breaks as a whole.
        softness: f32 = "f32",
        /// Width of what breaks as one, metres: waves shorter than that are left out.
        breaking: f32 = "f32",
    }
}

gpu_struct! {
    /// Where the lattice of a patch lies: a vertex near the eye, and the way from it to the eye in the cell's plane, metres.
    pub struct WaveAnchor as "WaveAnchor" {
        /// Vertex.
        vertex: [i32; 2] = "vec2i",
        /// Eye.
        eye: Vec2 = "vec2f",
    }
}

gpu_struct! {
    /// One cell of the wave domain: its plane about the eye, and the patches' lattices in it. North at (x, y) metres from its centre is
    /// along (-x turn, cos_lat - y turn).
    pub struct WaveCell as "WaveCell" {
        /// Its centre, local.
        origin: Vec3 = "vec3f",
        /// Cos lat.
        cos_lat: f32 = "f32",
        /// Local; east at the centre.
        axis_x: Vec3 = "vec3f",
        /// Turn.
        turn: f32 = "f32",
        /// North at the centre.
        axis_y: Vec3 = "vec3f",
        /// Random bits.
        key: u32 = "u32",
        /// Sine and cosine of the bearing that the wind comes from.
        wind: Vec2 = "vec2f",
        /// Direction that stands for north at a pole.
        polar_north: Vec2 = "vec2f",
        /// Anchors.
        anchors: [WaveAnchor; PATCHES] = "array<WaveAnchor, PATCHES>",
    }
}

gpu_struct! {
    /// Bind group 0's block.
    pub struct FrameUniform as "Frame" {
        /// Clip from local.
        clip_from_local: Mat4 = "mat4x4f",
        /// A ray through normalised device coordinates (x, y): ray_forward + x * ray_right + y * ray_up (not unit).
        ray_right: Vec3 = "vec3f",
        /// Eye altitude.
        eye_altitude: f32 = "Metres",
        /// Ray up.
        ray_up: Vec3 = "vec3f",
        /// Semi major.
        semi_major: f32 = "Metres",
        /// Ray forward.
        ray_forward: Vec3 = "vec3f",
        /// Of the water that a mesh is of, over the ellipsoid: 0, or a lake's.
        water_level: f32 = "Metres",
        /// The ellipsoid as a quadric about the eye: F(P) = C + 2 g.P + P'QP in metres; F = 0 on it, F ~ height near it.
        quadric_diagonal: Vec3 = "vec3f",
        /// Quadric constant.
        quadric_constant: f32 = "Metres",
        /// The eye, metres from the earth's middle along axes that drift with the clouds; those of its meridian: cosine and sine.
        cloud_eye: Vec3 = "vec3f",
        /// By how many deviations clouds are more than where they cover half of the sky.
        cloud_shift: f32 = "f32",
        /// See cloud_eye.
        cloud_meridian: Vec2 = "vec2f",
        /// The eye's foot on the square of the bed's pattern, see `shaders/lib/sea_bed.wgsl`: metres.
        bed_origin: Vec2 = "vec2f",
        /// The eye's foot in the lattices of the relief; `model::relief::place`.
        relief_eye: [u32; 3] = "vec3u",
        /// Nodes of the net of `shaders/lib/cloud_light.wgsl`: across in the low half, down in the high one.
        cloud_net: u32 = "u32",
        /// Xy, xz, yz.
        quadric_mixed: Vec3 = "vec3f",
        /// The projected grid is cast from this far above the eye.
        projector_rise: f32 = "Metres",
        /// Quadric gradient.
        quadric_gradient: Vec3 = "vec3f",
        /// Projector constant.
        projector_constant: f32 = "Metres",
        /// Projector gradient.
        projector_gradient: Vec3 = "vec3f",
        /// How far the chop may bring water into the screen; 0 where that is less than pixels.
        rim_reach: f32 = "Metres",
        /// Geodetic trigonometry of the eye's foot.
        sin_lat: f32 = "f32",
        /// Cos lat.
        cos_lat: f32 = "f32",
        /// Sqrt(a^2 cos^2 + b^2 sin^2).
        foot_nu: f32 = "Metres",
        /// Sine of the latitude of the Mercator reference point.
        mercator_sin: f32 = "f32",
        /// Stereographic coordinates of the polar reference points.
        north_point: Vec2 = "vec2f",
        /// South point.
        south_point: Vec2 = "vec2f",
        /// Normal at the eye's foot minus normal at the reference point, earth axes turned to the eye's meridian.
        north_delta: Vec3 = "vec3f",
        /// Sin_lat - mercator_sin.
        mercator_sin_delta: f32 = "f32",
        /// South delta.
        south_delta: Vec3 = "vec3f",
        /// Share of the surface under whitecaps.
        whitecaps: f32 = "f32",
        /// Mercator fixed.
        mercator_fixed: [u32; 2] = "vec2u",
        /// North fixed.
        north_fixed: [u32; 2] = "vec2u",
        /// South fixed.
        south_fixed: [u32; 2] = "vec2u",
        /// The eye's place in the map of gusts.
        gust_origin: [u32; 2] = "vec2u",
        /// Unit vector along the wind on the Mercator square, x east, y south.
        gust_axis: Vec2 = "vec2f",
        /// The clearest and the most turbid kind of water that is drawn; see `water_types.wgsl`.
        water_kinds: [f32; 2] = "vec2f",
        /// Low bits of the instant, ticks of 2^-20 s.
        clock: u32 = "u32",
        /// How much denser the air is at sea level than at the eye, 0 to 1: the more, the more of a ray's air lies at its far end.
        air_sink: f32 = "f32",
        /// How much spindrift shows, of a hurricane's to an eye near the water; 0: none.
        spindrift: f32 = "f32",
        /// Extinction of spray in the air at the water, per metre.
        spray: f32 = "f32",
        /// Light of the night over what is drawn with the sun's: more where the unit of light is the moon's.
        night: f32 = "f32",
        /// Share of it that falls on the ground of the dark side.
        night_ground: f32 = "f32",
        /// Cosine and sine of the eye's longitude.
        meridian: Vec2 = "vec2f",
        /// Unit vector towards what lights the picture: the sun, or in its night the moon.
        light: Vec3 = "vec3f",
        /// Exposure.
        exposure: f32 = "f32",
        /// Unit vector towards the moon, as the eye sees it.
        moon: Vec3 = "vec3f",
        /// Radiance of a full moon's disc.
        moon_radiance: f32 = "f32",
        /// Unit vector towards the sun.
        sun: Vec3 = "vec3f",
        /// 1 where the sun lights the picture, 0 where the moon does.
        by_day: f32 = "f32",
        /// Pixels.
        viewport: Vec2 = "vec2f",
        /// Radians per pixel at the centre.
        pixel_angle: f32 = "f32",
        /// Rho of alpha = 1 - exp(-rho depth), per metre.
        water_density: f32 = "f32",
        /// Velocity of the wind, m/s, east and north at the eye.
        wind: Vec2 = "vec2f",
        /// Significant height Hs.
        wave_height: f32 = "Metres",
        /// Chop.
        chop: f32 = "f32",
        /// The FFT's own distance, and the Perlin field's.
        mix_near: f32 = "Metres",
        /// Mix far.
        mix_far: f32 = "Metres",
        /// 0 where the chop folds, 1 on high water.
        foam_rule: u32 = "u32",
        /// Perlin patch.
        perlin_patch: f32 = "Metres",
        /// Waves that break on shores: their period where no trains have one, s; for how many seconds their fronts are dense; their height over the depth that they break
        /// in; in how many seconds their white water fades.
        surf: Vec4 = "vec4f",
        /// How steeply usual beaches fall, metres per metre; width of the surf over the usual one.
        shore: Vec2 = "vec2f",
        /// Share of the water under the film of old foam, and its opacity.
        film: Vec2 = "vec2f",
        /// Patch lengths of the cascades, metres.
        patches: Vec4 = "vec4f",
        /// Spacings of their lattices.
        spacings: Vec4 = "vec4f",
        /// Of the eye in the foam's lace, which is aligned with the wind, and the way into it.
        lace_texel: [i32; 2] = "vec2i",
        /// Lace fraction.
        lace_fraction: [f32; 2] = "vec2f",
        /// Perlin spacing.
        perlin_spacing: f32 = "Metres",
        /// Along a cell of the projected grid.
        cell_pixels: f32 = "f32",
        /// The deepest levels that page tables reach: Mercator's in the lowest byte, then the north's and the south's.
        deepest_pages: u32 = "u32",
        /// Optical depth of the air's aerosol at 550 nm.
        haze: f32 = "f32",
        /// Wave cells that may serve what is seen.
        wave_cell_count: u32 = "u32",
        /// Bit 0 land, 1 sea, 2 sky; 3 where land is so near that water mirrors it.
        layers: u32 = "u32",
        /// 0 the picture, else a measured layer.
        output: u32 = "u32",
        /// Depth of the sea at the eye's place.
        eye_depth: f32 = "Metres",
        /// Terrain resolution.
        terrain_resolution: f32 = "Metres",
        /// The highest crest to expect.
        crest_height: f32 = "Metres",
        /// Water above the first carries foam, above the second nothing else (rule 1), metres.
        foam_heights: Vec2 = "vec2f",
        /// Slope variances along the wind and across it: of the waves that no cascade holds, of each cascade's (two in a row).
        below_slopes: Vec2 = "vec2f",
        /// Where the water may cut through the picture: what is nearer than this to the eye does not show. Elsewhere 0.
        lens: f32 = "Metres",
        /// Mean level of the choppy FFT patches, at most 0; what is drawn has it subtracted.
        chop_level: f32 = "Metres",
        /// Share of it that each cascade makes.
        cascade_levels: Vec4 = "vec4f",
        /// Share of the waves' energy that each cascade holds.
        cascade_shares: Vec4 = "vec4f",
        /// Cascade slopes.
        cascade_slopes: [Vec4; 2] = "array<vec4f, 2>",
        /// What the Perlin patch does not hold, then its own.
        perlin_slopes: Vec4 = "vec4f",
        /// Foam levels.
        foam_levels: [FoamLevel; foam::LEVELS] = "array<FoamLevel, FOAM_LEVELS>",
    }
}
