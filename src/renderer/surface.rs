//! The water's surface as all passes read it (bind group 1): waves, far sea, foam and skylight, kept up to the frame's sea and
//! instant.

use std::sync::Arc;

use crate::gpu::Gpu;
use crate::gpu::pipeline::Bind;
use crate::gpu::texture;
use crate::model::foam::Fold;
use crate::model::sea_tables::SeaTables;
use crate::model::waves::CASCADES;
use crate::pass::fft::{Fft, Precision};
use crate::pass::foam::{self, Foam};
use crate::pass::perlin::Perlin;
use crate::pass::shore_trains::ShoreTrains;
use crate::scene::frame::Frame;
use crate::scene::sea::Seas;
use crate::scene::sea::foam::Whitecaps;
use crate::scene::sea::foam_history::{FoamStep, History};
use crate::scene::sea::shelter::{LEVELS, SIDE, Window};
use crate::scene::sea::shores::Shores;

/// Views of the tables of light, in the order of the bindings.
pub(super) type Light = [wgpu::TextureView; 6];

/// Samples along a side of the patches until the first sea says otherwise.
const SAMPLES: usize = 256;

/// The passes that make the surface, and whose it is.
pub(super) struct Surface {
    fft: Fft,
    perlin: Perlin,
    foam: Foam,
    trains: ShoreTrains,
    history: History,
    moving: bool,
    /// The light: skylight's radiance and irradiance, the air that the eye sees before the sky and before surfaces, transmittance; what a rough
    /// sea mirrors.
    light: Light,
    /// The clouds' weather, what they do to the light of the picture, and where land stands in the sea's way.
    storage: [wgpu::Buffer; 3],
    /// Of [`Shelter::revision`](crate::scene::sea::shelter::Shelter::revision) that the buffer holds.
    sheltered: u64,
    /// Layout of bind group 1.
    pub(super) layout: wgpu::BindGroupLayout,
    /// One for each foam map.
    groups: [wgpu::BindGroup; 2],
    sea: Option<Arc<SeaTables>>,
    whitecaps: Option<Whitecaps>,
    /// Whether the frame itself makes the foam's last step.
    foam_step: bool,
    replaying: bool,
    /// Dispatches of the last [`Surface::replay`].
    replayed: usize,
    /// Whether the frame makes the waves and the far sea's noise: they are seen, and not there yet.
    due: [bool; 2],
    /// Instants of the waves and the noise that the textures hold, ticks.
    made: [Option<u64>; 2],
}

impl Surface {
    /// A surface without a sea; `frame` is the layout of bind group 0.
    pub(super) fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, light: Light, clouds: [&wgpu::Buffer; 2]) -> Self {
        use wgpu::TextureViewDimension::{D2, D2Array, D3};
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT | wgpu::ShaderStages::COMPUTE;
        let mut binds = [D2Array, D2Array, D2Array, D2, D2, D3, D2, D2, D3, D2, D2, D2].map(Bind::Texture).to_vec();
        // The foam map is read texel by texel.
        binds[4] = Bind::Texels(D2);
        binds.extend([Bind::Storage; 4]);
        // No pixel looks up where the water has moved: that leaves the sea's shader room for the places of its mesh, the last of 16 textures that are allowed.
        let visible = |binding| if binding == 0 { stages - wgpu::ShaderStages::FRAGMENT } else { stages };
        let layout = gpu.layout_by_stages("surface", binds.into_iter().enumerate().map(|(i, bind)| (bind, visible(i))));
        let fft = Fft::new(gpu, SAMPLES, CASCADES, Precision::Half).sharpened(true);
        let perlin = Perlin::new(gpu);
        let foam = Foam::new(gpu, frame, &layout);
        let size = (size_of::<[Window; LEVELS]>() + LEVELS * SIDE * SIDE * size_of::<[u32; 4]>()) as u64;
        let shelter = gpu.empty_buffer("shelter", wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST, size);
        let [weather, net] = clouds.map(Clone::clone);
        let storage = [weather, net, shelter];
        let trains = ShoreTrains::new(gpu);
        let groups = groups(gpu, &layout, (&fft, &perlin, &foam, &trains), &light, &storage);
        Self {
            fft,
            perlin,
            foam,
            trains,
            history: History::default(),
            moving: false,
            light,
            storage,
            sheltered: 0,
            layout,
            groups,
            sea: None,
            whitecaps: None,
            foam_step: false,
            replaying: false,
            replayed: 0,
            due: [true; 2],
            made: [None; 2],
        }
    }

    /// Bind group 1 with the present foam map.
    pub(super) fn group(&self) -> &wgpu::BindGroup {
        &self.groups[self.foam.current()]
    }

    /// `moving`: the picture has a history of its own, which better thresholds for the same foam go on with, and so do finer levels of the map.
    pub(super) fn set_moving(&mut self, moving: bool) {
        self.moving = moving;
    }

    /// Forgets the waves and the foam's history.
    pub(super) fn forget(&mut self) {
        self.made = [None; 2];
        self.history.reset();
    }

    /// Takes the waves of a sea that is not the last one from `seas`.
    pub(super) fn take(&mut self, gpu: &Gpu, frame: &Frame, seas: &mut Seas) {
        if self.sheltered != seas.shelter.revision() {
            self.sheltered = seas.shelter.revision();
            let (windows, nodes) = seas.shelter.packed();
            let words = windows.map(|window| [window.middle[0], window.middle[1], window.bits, window.state]);
            gpu.queue.write_buffer(&self.storage[2], 0, bytemuck::cast_slice(&words));
            gpu.queue.write_buffer(&self.storage[2], size_of_val(&words) as u64, bytemuck::cast_slice(&nodes));
        }
        let sea = &frame.sea;
        let is_same = self.sea.as_ref().is_some_and(|kept| Arc::ptr_eq(kept, sea) || kept == sea);
        if self.whitecaps != Some(frame.whitecaps) {
            let is_refined = is_same && self.whitecaps.is_some_and(|kept| kept.share == frame.whitecaps.share);
            if !(self.moving && is_refined) {
                self.history.reset();
            }
            self.whitecaps = Some(frame.whitecaps);
        }
        if is_same {
            return;
        }
        let n = sea.cascades[0].n;
        if n != self.fft.samples() {
            self.fft = Fft::new(gpu, n, sea.cascades.len(), Precision::Half).sharpened(true);
            self.bind(gpu);
        }
        self.fft.set_waves(gpu, &sea.cascades, &seas.waves(sea));
        self.made = [None; 2];
        self.history.reset();
        self.sea = Some(sea.clone());
    }

    /// Windows of these on the device, and bytes of their buffer.
    pub(super) fn trains_held(&self) -> (usize, u64) {
        (self.trains.windows(), self.trains.buffer.size())
    }

    /// Takes the trains of waves near the shores around the frame's eye.
    pub(super) fn take_trains(&mut self, gpu: &Gpu, frame: &Frame, shores: &Shores) {
        if self.trains.prepare(gpu, shores, frame, self.moving) {
            self.bind(gpu);
        }
    }

    fn bind(&mut self, gpu: &Gpu) {
        let made = (&self.fft, &self.perlin, &self.foam, &self.trains);
        self.groups = groups(gpu, &self.layout, made, &self.light, &self.storage);
    }

    /// Brings the foam map towards the frame's instant, by at most `budget` steps of the past, each a submission of its own.
    /// `frame_group` is bind group 0 with the frame.
    pub(super) fn replay(&mut self, gpu: &Gpu, frame: &Frame, frame_group: &wgpu::BindGroup, mut budget: usize) {
        (self.replaying, self.replayed) = (false, 0);
        if !frame.has_light() {
            return;
        }
        let Some(lifetime_s) = frame.foam_lifetime_s else { return self.history.reset() };
        let (ticks, eye) = (frame.ticks(), &frame.foam_eye);
        while let Some(instant) =
            self.history.next_instant(ticks, eye, lifetime_s, self.moving).filter(|instant| *instant != ticks)
        {
            if budget == 0 {
                self.replaying = true;
                return;
            }
            budget -= 1;
            self.replayed += self.fft.stretch_dispatches() + foam::DISPATCHES;
            self.foam.prepare(gpu, &step(&mut self.history, frame, instant, lifetime_s));
            self.fft.set_time(gpu, instant);
            self.made[0] = None;
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            {
                let mut pass = encoder.begin_compute_pass(&Default::default());
                self.fft.dispatch_stretches(&mut pass);
                self.foam.dispatch(&mut pass, frame_group, &self.groups[self.foam.current()]);
            }
            gpu.queue.submit([encoder.finish()]);
        }
    }

    /// Sets the frame's instant, for waves, far sea and the foam's last step.
    pub(super) fn prepare(&mut self, gpu: &Gpu, frame: &Frame) {
        if frame.has_light() && frame.has_foam() {
            self.foam.make_lace(gpu);
        }
        let (ticks, eye) = (frame.ticks(), &frame.foam_eye);
        let lifetime_s = frame.foam_lifetime_s.filter(|_| frame.has_light() && !self.replaying);
        let due =
            lifetime_s.filter(|&lifetime_s| self.history.next_instant(ticks, eye, lifetime_s, self.moving).is_some());
        if let Some(lifetime_s) = due {
            self.foam.prepare(gpu, &step(&mut self.history, frame, ticks, lifetime_s));
        }
        self.foam_step = due.is_some();
        let seen = [frame.has_waves(), frame.has_noise()];
        self.due = [0, 1].map(|i| seen[i] && self.made[i] != Some(ticks));
        for (made, _) in self.made.iter_mut().zip(self.due).filter(|(_, due)| *due) {
            *made = Some(ticks);
        }
        self.fft.set_time(gpu, ticks);
        self.perlin.prepare(gpu, frame);
    }

    /// Records what the frame needs of waves, far sea and their mip levels, and the foam's last step.
    pub(super) fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame_group: &wgpu::BindGroup) {
        let [waves, noise] = self.due;
        if waves {
            self.fft.dispatch(pass);
        }
        if noise {
            self.perlin.dispatch(pass);
        }
        if waves {
            self.fft.dispatch_mips(pass);
        }
        if noise {
            self.perlin.dispatch_mips(pass);
        }
        if self.foam_step {
            self.foam.dispatch(pass, frame_group, &self.groups[self.foam.current()]);
        }
    }

    /// Dispatches of the frame, those of its replay included.
    pub(super) fn dispatches(&self) -> usize {
        let waves = if self.due[0] { self.fft.dispatches() + self.fft.mip_dispatches() } else { 0 };
        let noise = if self.due[1] { self.perlin.dispatches() } else { 0 };
        let foam = if self.foam_step { foam::DISPATCHES } else { 0 };
        self.replayed + waves + noise + foam
    }

    /// Whether the foam's history is being replayed: that needs frames, and nothing from outside.
    pub(super) fn is_replaying(&self) -> bool {
        self.replaying
    }
}

/// The foam map's step to an instant: time passes only on levels whose waves fold at all, the others have the wind's share.
fn step(history: &mut History, frame: &Frame, instant: u64, lifetime_s: f64) -> FoamStep {
    let mut step = history.step(instant, &frame.foam_eye, lifetime_s, &frame.whitecaps.breaking_m);
    for (level, _) in frame.whitecaps.folds.iter().enumerate().filter(|(_, fold)| **fold == Fold::NEVER) {
        step.due &= !(1 << level);
    }
    step
}

/// Bind group 1 with either foam map.
fn groups(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    (fft, perlin, foam, trains): (&Fft, &Perlin, &Foam, &ShoreTrains),
    light: &Light,
    storage: &[wgpu::Buffer; 3],
) -> [wgpu::BindGroup; 2] {
    foam.maps.each_ref().map(|map| {
        let waves = [&fft.displacements, &fft.slopes, &fft.stretches].map(texture::array_view);
        let [noise, lace] = [&perlin.texture, &foam.lace].map(texture::view);
        let views: Vec<_> = waves
            .iter()
            .chain([&noise, map])
            .chain(light)
            .chain([&lace])
            .map(wgpu::BindingResource::TextureView)
            .chain(storage.iter().chain([&trains.buffer]).map(wgpu::Buffer::as_entire_binding))
            .collect();
        gpu.bind("surface", layout, &views)
    })
}
