//! The panel's ground: one colour over a rectangle of the window.
//!
//! egui's own shader reads a texture and converts colours for each pixel, which a processor that stands in for a graphics card feels: of a
//! picture in a drag it took a seventh. This one does nothing.

use std::sync::Arc;

use egui::{Color32, Rect, Rgba, Shape};
use egui_wgpu::{CallbackResources, CallbackTrait, wgpu};

/// What paints it.
pub struct Pane {
    pipeline: Arc<wgpu::RenderPipeline>,
}

/// The composed shader of a colour on a target that takes gamma-encoded values as they are, or encodes them itself (`is_srgb`).
pub fn source(colour: Color32, is_srgb: bool) -> String {
    let [r, g, b, a] =
        if is_srgb { Rgba::from(colour).to_array() } else { colour.to_array().map(|part| f32::from(part) / 255.0) };
    let text = include_str!("../../shaders/pane.wgsl");
    format!("const COLOUR = vec4f({r:?}, {g:?}, {b:?}, {a:?});\n{text}")
}

impl Pane {
    /// A pane of one colour on targets of a format.
    pub fn new(device: &wgpu::Device, target_format: wgpu::TextureFormat, colour: Color32) -> Self {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("pane"),
            source: wgpu::ShaderSource::Wgsl(source(colour, target_format.is_srgb()).into()),
        });
        let target = wgpu::ColorTargetState {
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            ..target_format.into()
        };
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("pane"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("whole_viewport"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fill"),
                compilation_options: Default::default(),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline: Arc::new(pipeline) }
    }

    /// What egui paints: the colour over `rect`, points.
    pub fn shape(&self, rect: Rect) -> Shape {
        Shape::Callback(egui_wgpu::Callback::new_paint_callback(rect, Fill { pipeline: self.pipeline.clone() }))
    }
}

struct Fill {
    pipeline: Arc<wgpu::RenderPipeline>,
}

impl CallbackTrait for Fill {
    // The viewport is the rectangle.
    fn paint(&self, _: egui::PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _: &CallbackResources) {
        pass.set_pipeline(&self.pipeline);
        pass.draw(0..3, 0..1);
    }
}
