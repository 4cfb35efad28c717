//! What the bisected mesh needs to know of a frame: where on the cuboid the eye is, and how fine the triangles shall be.

use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec3, UVec3, Vec3};

use crate::model::cuboid::{UNIT, cube_from_ecef};
use crate::model::earth::{self, WGS84};
use crate::scene::settings::Triangles;
use crate::scene::view::camera::Camera;

/// The block for the GPU; mirrors `Bisection` in `shaders/lib/cuboid.wgsl`, which documents the members.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct Bisection {
    pub foot: UVec3,
    pub target_pixels: f32,
    pub fraction: Vec3,
    pub budget: u32,
    pub point: Vec3,
    pub inverse_length: f32,
    pub local_from_x: Vec3,
    pub unused_a: u32,
    pub local_from_y: Vec3,
    pub unused_b: u32,
    pub local_from_z: Vec3,
    pub unused_c: u32,
}

impl Bisection {
    /// For an eye and a wish.
    pub fn new(camera: &Camera, triangles: &Triangles) -> Self {
        let foot = cube_from_ecef(Camera { altitude_m: 0.0, ..*camera }.eye_ecef());
        let exact = (foot + DVec3::ONE) * f64::from(UNIT);
        let whole = exact.floor();
        let scaled = DMat3::from_diagonal(DVec3::new(WGS84.a, WGS84.a, WGS84.b));
        let local = earth::ecef_from_enu(camera.lat, camera.lon).transpose() * scaled;
        Self {
            foot: whole.as_uvec3(),
            target_pixels: triangles.pixels as f32,
            fraction: (exact - whole).as_vec3(),
            budget: triangles.budget,
            point: foot.as_vec3(),
            inverse_length: foot.length().recip() as f32,
            local_from_x: local.x_axis.as_vec3(),
            local_from_y: local.y_axis.as_vec3(),
            local_from_z: local.z_axis.as_vec3(),
            ..Self::default()
        }
    }
}
