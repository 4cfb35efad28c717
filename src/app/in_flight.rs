//! The picture that the device is drawing. There is at most one: what waited behind it would only make the answer to a hand late.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering::Relaxed};

use crate::data::fetch::now_s;
use crate::gpu::Gpu;

#[derive(Debug, Default)]
struct Shared {
    busy: AtomicBool,
    finished: AtomicU32,
    /// Bits of the milliseconds that the last picture took.
    ms: AtomicU64,
}

/// What becomes of submitted pictures.
#[derive(Debug, Default)]
pub struct InFlight {
    shared: Arc<Shared>,
    /// Pictures whose time has been asked for.
    told: u32,
}

impl InFlight {
    /// Gives the device a picture; `wake` is called when it is finished.
    pub fn submit(&self, gpu: &Gpu, encoder: wgpu::CommandEncoder, wake: impl FnOnce() + Send + 'static) {
        self.shared.busy.store(true, Relaxed);
        let (shared, from_s) = (self.shared.clone(), now_s());
        gpu.queue.submit([encoder.finish()]);
        gpu.queue.on_submitted_work_done(move || {
            shared.ms.store(((now_s() - from_s) * 1000.0).to_bits(), Relaxed);
            shared.finished.fetch_add(1, Relaxed);
            shared.busy.store(false, Relaxed);
            wake();
        });
    }

    /// Whether the device is still at it. Natively nobody else asks the device, so this does.
    pub fn is_busy(&self, gpu: &Gpu) -> bool {
        // A lost device reports itself elsewhere.
        let _ = gpu.device.poll(wgpu::PollType::Poll);
        self.shared.busy.load(Relaxed)
    }

    /// Pictures that are finished.
    pub fn finished(&self) -> u32 {
        self.shared.finished.load(Relaxed)
    }

    /// Milliseconds from submission to completion of a picture that has been finished since the last call.
    pub fn news(&mut self) -> Option<f64> {
        let finished = self.finished();
        (std::mem::replace(&mut self.told, finished) != finished).then(|| f64::from_bits(self.shared.ms.load(Relaxed)))
    }
}
