//! What a compute pass costs on the device itself, where the device can say so.

use super::Gpu;
use crate::error::Result;

/// Browsers round timestamps to this, so that pages cannot spy on each other: such an answer says nothing of a short pass.
const QUANTUM_NS: f64 = 100_000.0;

/// Timestamps at the beginning and end of some passes of one submission.
pub struct Timer {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read: wgpu::Buffer,
    passes: u32,
    tick_ns: f64,
}

impl Timer {
    /// A timer for `passes` passes; None where the device has no timestamps, or is a program: such a one does not wait for its own
    /// threads (Mesa's llvmpipe calls 5 ms of work 11 µs).
    pub fn new(gpu: &Gpu, passes: u32) -> Option<Self> {
        let software = gpu.device.adapter_info().device_type == wgpu::DeviceType::Cpu;
        if software || !gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            return None;
        }
        let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("timer"),
            ty: wgpu::QueryType::Timestamp,
            count: 2 * passes,
        });
        let bytes = u64::from(2 * passes) * 8;
        let resolved =
            gpu.empty_buffer("timer", wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC, bytes);
        let read = gpu.empty_buffer("times", wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ, bytes);
        let tick_ns = f64::from(gpu.queue.get_timestamp_period());
        Some(Self { queries, resolved, read, passes, tick_ns })
    }

    /// Where pass number `pass` writes its times: for the descriptor that begins it.
    pub fn writes(&self, pass: u32) -> wgpu::ComputePassTimestampWrites<'_> {
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(2 * pass),
            end_of_pass_write_index: Some(2 * pass + 1),
        }
    }

    /// To be recorded after the last pass.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..2 * self.passes, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.read, 0, self.read.size());
    }

    /// Milliseconds of each pass of the last submission; None for an answer that cannot be believed.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device is lost meanwhile.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<Option<f64>>> {
        let bytes = gpu.read_buffer(&self.read)?;
        let word = |at: usize| u64::from_le_bytes(std::array::from_fn(|i| bytes[8 * at + i]));
        Ok((0..self.passes as usize)
            .map(|pass| milliseconds(word(2 * pass), word(2 * pass + 1), self.tick_ns))
            .collect())
    }
}

/// The time between two timestamps; None where they are missing, run backwards or have been rounded to the browsers' quantum.
pub fn milliseconds(begin: u64, end: u64, tick_ns: f64) -> Option<f64> {
    let elapsed_ns = end.checked_sub(begin).filter(|&ticks| ticks > 0)? as f64 * tick_ns;
    let rounded = elapsed_ns % QUANTUM_NS == 0.0;
    (begin > 0 && !rounded).then_some(elapsed_ns * 1e-6)
}

#[cfg(test)]
mod tests {
    use super::milliseconds;

    #[test]
    fn only_times_that_can_be_true_are_given() {
        assert_eq!(milliseconds(1_000, 251_000, 1.0), Some(0.25));
        assert_eq!(milliseconds(1_000, 2_000, 40.96).map(|ms| (ms * 1e6).round()), Some(40_960.0));
        for (begin, end) in [(0, 0), (0, 500), (500, 500), (500, 400), (100_000, 300_000)] {
            assert_eq!(milliseconds(begin, end, 1.0), None, "{begin} {end}");
        }
    }
}
