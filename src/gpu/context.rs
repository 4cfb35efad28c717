//! The device: one per program, from a window's host or without any window.

use std::sync::Arc;

use super::pipeline::Made;
use super::timing::Stages;
use crate::error::{Error, Result};

/// A device with its queue, and what it calls itself.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// Makes resources.
    pub device: wgpu::Device,
    /// Takes work.
    pub queue: wgpu::Queue,
    /// Name and kind of the adapter, for messages and records.
    pub adapter: String,
    /// Whether the processor stands in for a graphics card.
    pub software: bool,
    /// Rewrites the text of a shader, by its pipeline's label, before it is compiled: for measurements.
    pub instrument: Option<fn(&str, &str) -> String>,
    /// Every pipeline of the device, once.
    pub(super) made: Arc<Made>,
}

/// What is used where an adapter has it.
const BETTER: wgpu::Features =
    wgpu::Features::FLOAT32_FILTERABLE.union(wgpu::Features::FLOAT32_BLENDABLE).union(Stages::FEATURES);

/// What is asked of any device: the WebGPU defaults, and of what is beyond them only what the adapter has: filtering and blending of 32-bit
/// floats, and timestamps for measurements.
pub fn device_descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
    wgpu::DeviceDescriptor {
        label: Some("ocean-globe"),
        required_features: adapter.features() & BETTER,
        required_limits: wgpu::Limits {
            max_texture_dimension_2d: adapter.limits().max_texture_dimension_2d.clamp(8192, 16384),
            ..wgpu::Limits::default()
        },
        ..Default::default()
    }
}

fn described(info: &wgpu::AdapterInfo) -> String {
    format!("{} ({:?}, {:?})", info.name, info.device_type, info.backend)
}

impl Gpu {
    /// A device of the host's (window or page).
    pub fn new(adapter: &wgpu::Adapter, device: wgpu::Device, queue: wgpu::Queue) -> Self {
        let info = adapter.get_info();
        let software = info.device_type == wgpu::DeviceType::Cpu;
        Self { device, queue, adapter: described(&info), software, instrument: None, made: Arc::default() }
    }

    /// A device without a window: the best adapter there is, a software one included.
    ///
    /// # Errors
    /// [`Error::Gpu`] when there is no adapter or it refuses the default limits of WebGPU.
    pub async fn headless() -> Result<Self> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = instance.request_adapter(&options).await.map_err(|e| {
            Error::gpu(
                format!("no graphics adapter: {e}"),
                "install a Vulkan driver (Debian: apt install mesa-vulkan-drivers libvulkan1, which runs without a GPU)",
            )
        })?;
        let (device, queue) = adapter.request_device(&device_descriptor(&adapter)).await.map_err(|e| {
            Error::gpu(format!("{}: {e}", described(&adapter.get_info())), "update the graphics driver")
        })?;
        Ok(Self::new(&adapter, device, queue))
    }

    /// Runs `work` and returns what the device's own validation says of it.
    ///
    /// # Errors
    /// [`Error::Gpu`] with the device's message.
    pub async fn validated<T>(&self, work: impl FnOnce() -> T) -> Result<T> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let made = work();
        match scope.pop().await {
            None => Ok(made),
            Some(e) => {
                Err(Error::gpu(e, "this is a fault of the program or of the driver: report it with this message"))
            }
        }
    }
}
