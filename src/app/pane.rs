//! The panel's ground: one colour over a rectangle of the window.
//!
//! egui's own shader reads a texture and converts colours for each pixel. A processor that stands in for a graphics card feels that: it
//! took four hundredths of a picture in a drag. This one does nothing.

use egui::{Color32, Rect, Rgba, Shape};
use egui_wgpu::{CallbackResources, CallbackTrait, wgpu};

use crate::gpu::pipeline::Drawing;
use crate::gpu::{Gpu, shader};

/// What paints it.
pub struct Pane {
    pipeline: Drawing,
}

/// The composed shader of a colour on a target that gamma-encodes what it is given, or takes encoded values as they are.
pub fn source(colour: Color32, target_encodes: bool) -> String {
    let [r, g, b, a] = if target_encodes {
        Rgba::from(colour).to_array()
    } else {
        colour.to_array().map(|part| f32::from(part) / 255.0)
    };
    let definitions = format!("const COLOUR = vec4f({r:?}, {g:?}, {b:?}, {a:?});");
    shader::composed(include_str!("../../shaders/pane.wgsl"), &definitions)
}

impl Pane {
    /// A pane of one colour on targets of a format.
    pub fn new(gpu: &Gpu, target_format: wgpu::TextureFormat, colour: Color32) -> Self {
        let source = source(colour, target_format.is_srgb());
        let blend = Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        let target = wgpu::ColorTargetState { blend, ..target_format.into() };
        Self { pipeline: gpu.drawing("pane", (&source, "vertex"), &[], &[], target, None) }
    }

    /// What egui paints: the colour over `rect`, points.
    pub fn shape(&self, rect: Rect) -> Shape {
        Shape::Callback(egui_wgpu::Callback::new_paint_callback(rect, Fill { pipeline: self.pipeline.clone() }))
    }
}

struct Fill {
    pipeline: Drawing,
}

impl CallbackTrait for Fill {
    // The viewport is the rectangle.
    fn paint(&self, _: egui::PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _: &CallbackResources) {
        pass.set_pipeline(&self.pipeline);
        pass.draw(0..3, 0..1);
    }
}
