//! The picture of an eye in the sea, and of one that the surface cuts through.

use super::side::Side;
use super::targets::{DEPTH_FORMAT, Passes, Targets};
use crate::gpu::drawing::{DepthUse, begin, resume};
use crate::gpu::{Gpu, texture};
use crate::pass::bed_light::BedLight;
use crate::pass::caustics::{Caustics, Rays};
use crate::pass::deep::Deep;
use crate::pass::kind::Kind;
use crate::pass::waterline::Waterline;
use crate::scene::frame::Frame;

/// The passes under water.
pub(super) struct Below {
    pub(super) caustics: Caustics,
    /// What an eye over the water sees of the caustics, where the radiance has what is blended.
    bed_light: Option<BedLight>,
    deep: Deep,
    /// Where the radiance has what is blended.
    waterline: Option<Waterline>,
}

impl Below {
    /// `frame` and `surface` are the layouts of bind groups 0 and 1, `radiance` the scene's format, `blends` whether the radiance has what is blended.
    pub(super) fn new(
        gpu: &Gpu,
        [frame, surface]: [&wgpu::BindGroupLayout; 2],
        radiance: wgpu::TextureFormat,
        blends: bool,
    ) -> Self {
        let caustics = Caustics::new(gpu, frame, surface);
        Self {
            deep: Deep::new(gpu, frame, surface, &caustics.map, [radiance, DEPTH_FORMAT]),
            caustics,
            bed_light: blends.then(|| BedLight::new(gpu, [frame, surface], radiance)),
            waterline: blends.then(|| Waterline::new(gpu, frame, surface, radiance)),
        }
    }

    /// Gets ready for a picture; returns what the one from below is drawn into where the water cuts through, else `None`.
    pub(super) fn prepare(&mut self, gpu: &Gpu, side: &Side, size: [u32; 2]) -> Option<wgpu::TextureView> {
        let below = side.below();
        if side.lights_bed || below.is_some() {
            self.caustics.prepare(gpu);
        }
        below?;
        self.waterline.as_mut().filter(|_| side.is_cut).map(|waterline| waterline.below(gpu, size))
    }

    /// Takes the scene that an eye over the water sees the bed in.
    pub(super) fn set_scene(&mut self, gpu: &Gpu, targets: &Targets) {
        if let Some(bed_light) = &mut self.bed_light {
            bed_light.set_scene(gpu, &targets.scene_depth, &texture::view(&self.caustics.map));
        }
    }

    /// Lights the bed of a scene with land and bed for an eye over the water. `groups` are bind groups 0 and 1.
    pub(super) fn light_bed(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        side: &Side,
        targets: &Targets,
        [frame, surface]: [&wgpu::BindGroup; 2],
    ) {
        if let Some(bed_light) = &self.bed_light {
            let rays = Rays::FromAbove { surf: side.shows_surf };
            self.caustics.draw(encoder, rays, frame, surface);
            bed_light.draw(&mut resume(encoder, "bed light", &targets.scene), side.kind, frame, surface);
        }
    }

    /// Draws the picture from below into `into`, or what the targets hold; `sea` draws the surface. `groups` are bind groups 0 and 1.
    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        (frame, kind): (&Frame, Kind),
        (passes, targets): (&Passes, &Targets),
        [frame_group, surface]: [&wgpu::BindGroup; 2],
        (into, clear): (Option<&wgpu::TextureView>, wgpu::Color),
        sea: impl FnOnce(&mut wgpu::RenderPass),
    ) {
        let is_even = !frame.is_fine() || frame.sea.sea.hs_m == 0.0;
        let rays = if is_even { Rays::Even } else { Rays::InWater };
        self.caustics.draw(encoder, rays, frame_group, surface);
        {
            let depth = Some(DepthUse::Begun(&targets.scene_depth, wgpu::StoreOp::Store));
            let mut pass = begin(encoder, "deep", &targets.scene, clear, depth);
            self.deep.draw(&mut pass, kind, frame_group, surface);
        }
        let radiance = texture::view(&targets.radiance);
        {
            let depth = Some(DepthUse::Begun(&targets.depth, wgpu::StoreOp::Discard));
            let mut pass = begin(encoder, "sea from below", targets.sea(into.unwrap_or(&radiance)), clear, depth);
            sea(&mut pass);
            passes.draw_backdrop(&mut pass, targets);
        }
        if let Some(waterline) = self.waterline.as_ref().filter(|_| into.is_some()) {
            waterline.draw(&mut resume(encoder, "waterline", &radiance), frame_group, surface);
        }
    }
}
