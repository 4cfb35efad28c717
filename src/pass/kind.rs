//! What kind of picture it is. Shaders know it when they are compiled, so that no pixel pays for another kind: software rasterisers run
//! both sides of every branch.

use std::collections::HashMap;

use crate::gpu::pipeline::Drawing;
use crate::scene::frame::Frame;

/// The kind of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Kind {
    /// Pixels report a measured layer.
    pub measured: bool,
    /// The eye is in the sea.
    pub under_water: bool,
    /// Spray in the air shows.
    pub spray: bool,
    /// What a coarse picture does without: sparkle, light through crests, blooms in the water.
    pub fine: bool,
    /// There are clouds.
    pub clouds: bool,
}

impl Kind {
    /// Every one.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..32).map(|bits: u8| {
            let [measured, under_water, spray, fine, clouds] = [1, 2, 4, 8, 16].map(|bit| bits & bit != 0);
            Self { measured, under_water, spray, fine, clouds }
        })
    }

    /// Whether the sea is drawn with surf where there are shores.
    pub fn shows_surf(self) -> bool {
        self.fine && !self.under_water
    }

    /// That of a frame whose eye is in the sea or not, as only the world knows.
    pub fn of(frame: &Frame, under_water: bool) -> Self {
        let u = &frame.uniform;
        Self {
            measured: u.output != 0,
            under_water,
            spray: frame.has_spray(),
            fine: frame.is_fine(),
            clouds: frame.clouds.is_some() && u.output == 0,
        }
    }

    /// What a shader that shows the ground is told: also whether there is imagery of it.
    pub fn ground_definitions(self, imagery: bool) -> String {
        self.definitions() + &format!("const IMAGERY: bool = {imagery};\n")
    }

    /// Whether the surface of a lake may have waves in such pictures.
    pub fn meshes_lakes(self) -> bool {
        self.fine && !self.under_water
    }

    /// Whether waves of lakes may show on the land's own surface.
    pub fn shows_lakes(self) -> bool {
        self.meshes_lakes() && !self.measured
    }

    /// What a shader is told.
    pub fn definitions(self) -> String {
        let Self { measured, under_water, spray, fine, clouds } = self;
        [("MEASURED", measured), ("UNDER_WATER", under_water), ("SPRAY", spray), ("FINE", fine), ("CLOUDS", clouds)]
            .map(|(name, value)| format!("const {name}: bool = {value};\n"))
            .concat()
    }
}

/// The pipelines of a pass by the kind of picture; each is compiled when it is first drawn with.
pub struct ByKind(HashMap<Kind, Drawing>);

impl ByKind {
    /// The `pipeline` of each of some kinds.
    pub fn new(kinds: impl Iterator<Item = Kind>, pipeline: impl Fn(Kind) -> Drawing) -> Self {
        Self(kinds.map(|kind| (kind, pipeline(kind))).collect())
    }

    /// Sets the pipeline of a kind with its bind groups 0 and 1; tells whether there is one.
    pub fn set(
        &self,
        pass: &mut wgpu::RenderPass,
        kind: Kind,
        frame: &wgpu::BindGroup,
        surface: &wgpu::BindGroup,
    ) -> bool {
        let Some(pipeline) = self.0.get(&kind) else { return false };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        true
    }
}

/// As [`ByKind`], for what shows the ground: without imagery of it, and with.
pub struct ByGround([ByKind; 2]);

impl ByGround {
    /// The `pipeline` of each of some kinds, without imagery and with.
    pub fn new<I: Iterator<Item = Kind>>(kinds: impl Fn() -> I, pipeline: impl Fn(Kind, bool) -> Drawing) -> Self {
        Self([false, true].map(|imagery| ByKind::new(kinds(), |kind| pipeline(kind, imagery))))
    }

    /// Sets the pipeline of a kind, with imagery or without, with its bind groups; tells whether there is one.
    pub fn set(
        &self,
        pass: &mut wgpu::RenderPass,
        (kind, imagery): (Kind, bool),
        [frame, surface, imagery_group]: [&wgpu::BindGroup; 3],
    ) -> bool {
        pass.set_bind_group(2, imagery_group, &[]);
        self.0[usize::from(imagery)].set(pass, kind, frame, surface)
    }
}
