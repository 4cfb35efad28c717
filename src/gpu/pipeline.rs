//! Pipelines declared in a line: a shader, its entry points and its bind kinds. All boilerplate lives here.
//!
//! A pipeline is made when it is first used, and the same one is never made twice on a device: a compiler takes up to seconds for one,
//! and a picture from orbit uses half of them.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher as _};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use super::Gpu;

/// Something that is made when it is first used.
type Lazy<T> = LazyLock<T, Box<dyn FnOnce() -> T + Send>>;
/// A compute pipeline that is made when it is first used.
pub type Compute = Arc<Lazy<wgpu::ComputePipeline>>;
/// A drawing pipeline that is made when it is first used.
pub type Drawing = Arc<Lazy<wgpu::RenderPipeline>>;

/// The pipelines of a device, by a hash of their declarations.
#[derive(Debug, Default)]
pub struct Made {
    compute: Mutex<HashMap<u64, Compute>>,
    drawing: Mutex<HashMap<u64, Drawing>>,
    /// How many have been used, and so compiled.
    compiled: Arc<AtomicUsize>,
}

/// The pipeline of a declaration: the one that is there, or a new one from `make`.
fn once<T>(
    kept: &Mutex<HashMap<u64, Arc<Lazy<T>>>>,
    declaration: impl Hash,
    make: impl FnOnce() -> T + Send + 'static,
) -> Arc<Lazy<T>> {
    let mut hasher = DefaultHasher::new();
    declaration.hash(&mut hasher);
    let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
    kept.entry(hasher.finish()).or_insert_with(|| Arc::new(Lazy::new(Box::new(make)))).clone()
}

/// What a binding holds.
#[derive(Clone, Copy, Debug)]
pub enum Bind {
    /// A uniform block.
    Uniform,
    /// A read-only storage buffer.
    Storage,
    /// A storage buffer that shaders write.
    StorageWrite,
    /// A texture of whole numbers, read texel by texel.
    Words(wgpu::TextureViewDimension),
    /// A texture read through a filtering sampler.
    Texture(wgpu::TextureViewDimension),
    /// A texture read texel by texel.
    Texels(wgpu::TextureViewDimension),
    /// A depth texture read texel by texel.
    Depth,
    /// A texture that shaders write.
    Write(wgpu::TextureFormat, wgpu::TextureViewDimension),
    /// A filtering sampler.
    Sampler,
}

/// Which fragments a drawing pipeline lets through. Depth is reversed: greater is nearer, 0 is where nothing has been drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthTest {
    /// Those nearer than what is there; their depth is written.
    Nearest,
    /// Those nearer than what is there, whose depth stays.
    Before,
    /// Those of depth 0, where nothing has been drawn.
    Undrawn,
    /// Those of depth 0, where something has been drawn.
    Drawn,
}

/// The depth that a drawing pipeline goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Depth {
    /// Of the depth's texture.
    pub format: wgpu::TextureFormat,
    /// The test.
    pub test: DepthTest,
    /// Samples of a pixel, of depth and colour alike.
    pub samples: u32,
}

impl Depth {
    /// One sample of each pixel.
    pub fn single(format: wgpu::TextureFormat, test: DepthTest) -> Self {
        Self { format, test, samples: 1 }
    }
}

impl Bind {
    fn binding_type(self) -> wgpu::BindingType {
        use wgpu::{BindingType as T, BufferBindingType as B, TextureSampleType as S};
        let buffer = |ty| T::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
        let texture = |sample_type, view_dimension| T::Texture { sample_type, view_dimension, multisampled: false };
        match self {
            Self::Uniform => buffer(B::Uniform),
            Self::Storage => buffer(B::Storage { read_only: true }),
            Self::StorageWrite => buffer(B::Storage { read_only: false }),
            Self::Texture(view) => texture(S::Float { filterable: true }, view),
            Self::Texels(view) => texture(S::Float { filterable: false }, view),
            Self::Words(view) => texture(S::Uint, view),
            Self::Depth => texture(S::Depth, wgpu::TextureViewDimension::D2),
            Self::Write(format, view_dimension) => {
                T::StorageTexture { access: wgpu::StorageTextureAccess::WriteOnly, format, view_dimension }
            }
            Self::Sampler => T::Sampler(wgpu::SamplerBindingType::Filtering),
        }
    }
}

impl Gpu {
    /// The layout of one bind group: bindings 0, 1, 2… visible to `stages`.
    pub fn layout(&self, label: &str, stages: wgpu::ShaderStages, binds: &[Bind]) -> wgpu::BindGroupLayout {
        self.layout_by_stages(label, binds.iter().map(|bind| (*bind, stages)))
    }

    /// As [`Gpu::layout`], each binding visible to stages of its own.
    pub fn layout_by_stages(
        &self,
        label: &str,
        binds: impl Iterator<Item = (Bind, wgpu::ShaderStages)>,
    ) -> wgpu::BindGroupLayout {
        let entries: Vec<_> = binds
            .enumerate()
            .map(|(binding, (bind, visibility))| wgpu::BindGroupLayoutEntry {
                binding: binding as u32,
                visibility,
                ty: bind.binding_type(),
                count: None,
            })
            .collect();
        self.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
    }

    /// A bind group with resources for bindings 0, 1, 2…
    pub fn bind(
        &self,
        label: &str,
        layout: &wgpu::BindGroupLayout,
        resources: &[wgpu::BindingResource],
    ) -> wgpu::BindGroup {
        let entries: Vec<_> = resources
            .iter()
            .enumerate()
            .map(|(binding, resource)| wgpu::BindGroupEntry { binding: binding as u32, resource: resource.clone() })
            .collect();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
    }

    /// Pipelines that have been compiled so far.
    pub fn pipelines_made(&self) -> usize {
        self.made.compiled.load(Relaxed)
    }

    fn module(&self, label: &str, source: &str) -> Arc<Lazy<wgpu::ShaderModule>> {
        let source = self.instrument.map_or_else(|| source.to_owned(), |rewrite| rewrite(label, source));
        let (device, label) = (self.device.clone(), label.to_owned());
        Arc::new(Lazy::new(Box::new(move || {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(&label),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            })
        })))
    }

    fn pipeline_layout(&self, label: &str, groups: &[&wgpu::BindGroupLayout]) -> wgpu::PipelineLayout {
        let groups: Vec<_> = groups.iter().copied().map(Some).collect();
        self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(label),
            bind_group_layouts: &groups,
            immediate_size: 0,
        })
    }

    /// Compute pipelines for the `entries` of one composed source; a source always goes with the same kinds of `groups`.
    pub fn compute<const N: usize>(
        &self,
        label: &str,
        source: &str,
        groups: &[&wgpu::BindGroupLayout],
        entries: [&str; N],
    ) -> [Compute; N] {
        let module = self.module(label, source);
        let layout = self.pipeline_layout(label, groups);
        entries.map(|entry| {
            let (device, module, layout) = (self.device.clone(), module.clone(), layout.clone());
            let (name, compiled) = (entry.to_owned(), self.made.compiled.clone());
            once(&self.made.compute, (label, source, entry), move || {
                compiled.fetch_add(1, Relaxed);
                device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(&name),
                    layout: Some(&layout),
                    module: &module,
                    entry_point: Some(&name),
                    // No shader reads workgroup memory that it has not written; browsers clear it all the same.
                    compilation_options: wgpu::PipelineCompilationOptions {
                        zero_initialize_workgroup_memory: false,
                        ..Default::default()
                    },
                    cache: None,
                })
            })
        })
    }

    /// A drawing pipeline from a source with its entry for vertices, and `fragment`, into a target's format, with a blend or without, and
    /// through a depth where there is one.
    pub fn drawing(
        &self,
        label: &str,
        (source, vertex): (&str, &str),
        groups: &[&wgpu::BindGroupLayout],
        buffers: &[wgpu::VertexBufferLayout],
        target: impl Into<wgpu::ColorTargetState>,
        depth: Option<Depth>,
    ) -> Drawing {
        self.drawing_into(
            label,
            (source, vertex),
            groups,
            buffers,
            &[target.into()],
            depth,
            depth.map_or(1, |d| d.samples),
        )
    }

    /// As [`Gpu::drawing`], into any number of targets with so many samples of a pixel, as many as the depth has.
    #[expect(clippy::too_many_arguments, reason = "those of `drawing` and one more")]
    pub fn drawing_into(
        &self,
        label: &str,
        (source, vertex): (&str, &str),
        groups: &[&wgpu::BindGroupLayout],
        buffers: &[wgpu::VertexBufferLayout],
        targets: &[wgpu::ColorTargetState],
        depth: Option<Depth>,
        samples: u32,
    ) -> Drawing {
        let module = self.module(label, source);
        let layout = self.pipeline_layout(label, groups);
        // Lent attributes become owned ones, since they are needed later.
        let buffers: Vec<_> = buffers.iter().map(|b| (b.array_stride, b.step_mode, b.attributes.to_vec())).collect();
        let (device, name, entry) = (self.device.clone(), label.to_owned(), vertex.to_owned());
        let compiled = self.made.compiled.clone();
        let targets: Vec<_> = targets.iter().cloned().map(Some).collect();
        once(&self.made.drawing, (label, source, vertex, targets.clone(), depth, samples), move || {
            compiled.fetch_add(1, Relaxed);
            let buffers: Vec<_> = buffers
                .iter()
                .map(|(array_stride, step_mode, attributes)| {
                    Some(wgpu::VertexBufferLayout { array_stride: *array_stride, step_mode: *step_mode, attributes })
                })
                .collect();
            device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(&name),
                layout: Some(&layout),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some(&entry),
                    compilation_options: Default::default(),
                    buffers: &buffers,
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: depth.map(|Depth { format, test, .. }| wgpu::DepthStencilState {
                    format,
                    depth_write_enabled: Some(test == DepthTest::Nearest),
                    depth_compare: Some(match test {
                        DepthTest::Nearest | DepthTest::Before => wgpu::CompareFunction::Greater,
                        DepthTest::Undrawn => wgpu::CompareFunction::GreaterEqual,
                        DepthTest::Drawn => wgpu::CompareFunction::Less,
                    }),
                    stencil: Default::default(),
                    bias: Default::default(),
                }),
                multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some("fragment"),
                    compilation_options: Default::default(),
                    targets: &targets,
                }),
                multiview_mask: None,
                cache: None,
            })
        })
    }

    /// A buffer with `contents`.
    pub fn buffer(&self, label: &str, usage: wgpu::BufferUsages, contents: &[u8]) -> wgpu::Buffer {
        let size = (contents.len() as u64).next_multiple_of(4).max(4);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size,
            usage: usage | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.queue.write_buffer(&buffer, 0, contents);
        buffer
    }

    /// An uninitialised (zero) buffer of `size` bytes.
    pub fn empty_buffer(&self, label: &str, usage: wgpu::BufferUsages, size: u64) -> wgpu::Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size,
            usage,
            mapped_at_creation: false,
        })
    }

    /// A sampler that filters linearly. Between mip levels it does so only if told: a software rasteriser samples twice for it, even
    /// where there is but one level.
    pub fn sampler(&self, label: &str, address: wgpu::AddressMode, mips: wgpu::MipmapFilterMode) -> wgpu::Sampler {
        self.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some(label),
            address_mode_u: address,
            address_mode_v: address,
            address_mode_w: address,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: mips,
            ..Default::default()
        })
    }
}
