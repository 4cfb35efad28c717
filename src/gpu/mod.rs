//! Floor 3: how to speak wgpu. Knows nothing of oceans.

pub mod context;
pub mod drawing;
pub mod full_screen;
pub mod mesh;
pub mod mips;
pub mod pipeline;
pub mod readback;
pub mod shader;
pub mod texture;
pub mod timing;

pub use context::Gpu;
