//! The finished picture and its way onto egui's target.
//!
//! The renderer draws into a texture of its own, gamma-encoded. So egui alone can repaint (a tooltip, a slider) without drawing the sea
//! again. As large as the window in physical pixels it is copied texel for pixel, smaller it is stretched.

use std::sync::Arc;

use egui_wgpu::{CallbackResources, CallbackTrait, wgpu};

/// The copying pipeline and the texture it copies from.
pub struct Picture {
    pipeline: Arc<wgpu::RenderPipeline>,
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    texture: wgpu::Texture,
    /// What the renderer draws into.
    pub view: wgpu::TextureView,
    group: Arc<wgpu::BindGroup>,
}

/// Format of the picture: gamma-encoded, 8 bits, no conversion on writing or reading.
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

impl Picture {
    /// A picture of one pixel, to be copied onto a target of egui's format.
    pub fn new(device: &wgpu::Device, target_format: wgpu::TextureFormat) -> Self {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("blit"),
            source: wgpu::ShaderSource::Wgsl(include_str!("../../shaders/blit.wgsl").into()),
        });
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("blit"),
            entries: &[
                wgpu::BindGroupLayoutEntry {
                    binding: 0,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Texture {
                        sample_type: wgpu::TextureSampleType::Float { filterable: true },
                        view_dimension: wgpu::TextureViewDimension::D2,
                        multisampled: false,
                    },
                    count: None,
                },
                wgpu::BindGroupLayoutEntry {
                    binding: 1,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                    count: None,
                },
            ],
        });
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("blit"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        // egui prefers a target that takes gamma-encoded values as they are; an sRGB one encodes what it is given.
        let entry = if target_format.is_srgb() { "copy_decoded" } else { "copy" };
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("blit"),
            layout: Some(&device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("blit"),
                bind_group_layouts: &[Some(&layout)],
                immediate_size: 0,
            })),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("whole_screen"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                targets: &[Some(target_format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let (texture, view, group) = make(device, &layout, &sampler, [1, 1]);
        Self { pipeline: Arc::new(pipeline), layout, sampler, texture, view, group }
    }

    /// Width and height in physical pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.texture.width(), self.texture.height()]
    }

    /// Makes the picture another size; its contents are lost.
    pub fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        if size != self.size() {
            (self.texture, self.view, self.group) = make(device, &self.layout, &self.sampler, size);
        }
    }

    /// What egui paints: this picture over the whole window.
    pub fn callback(&self) -> impl CallbackTrait + use<> {
        Copy { pipeline: self.pipeline.clone(), group: self.group.clone() }
    }
}

fn make(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    sampler: &wgpu::Sampler,
    [width, height]: [u32; 2],
) -> (wgpu::Texture, wgpu::TextureView, Arc<wgpu::BindGroup>) {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("blit"),
        layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(sampler) },
        ],
    });
    (texture, view, Arc::new(group))
}

struct Copy {
    pipeline: Arc<wgpu::RenderPipeline>,
    group: Arc<wgpu::BindGroup>,
}

impl CallbackTrait for Copy {
    fn paint(&self, _: egui::PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _: &CallbackResources) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &*self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
