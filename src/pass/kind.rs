//! What kind of picture it is. Shaders know it when they are compiled, so that no pixel pays for another kind: software rasterisers run
//! both sides of every branch.

use crate::scene::frame::Frame;

/// The kind of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Kind {
    /// Pixels report a measured layer.
    pub measured: bool,
    /// The eye is in the sea.
    pub under_water: bool,
}

impl Kind {
    /// Every one.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..4).map(|bits: u8| Self { measured: bits & 1 != 0, under_water: bits & 2 != 0 })
    }

    /// That of a frame; `over_ocean`: there is ocean at the eye's place, as only the world knows.
    pub fn of(frame: &Frame, over_ocean: bool) -> Self {
        let u = &frame.uniform;
        Self { measured: u.output != 0, under_water: over_ocean && u.under_water != 0 }
    }

    /// What a shader is told.
    pub fn definitions(self) -> String {
        let Self { measured, under_water } = self;
        format!("const MEASURED: bool = {measured};\nconst UNDER_WATER: bool = {under_water};\n")
    }
}
