//! What passes and the stages of a frame cost on the device itself, where the device can say so.

use super::Gpu;
use crate::error::Result;

/// Browsers round timestamps to this, so that pages cannot spy on each other: such an answer says nothing of a short pass.
const QUANTUM_NS: f64 = 100_000.0;

/// Room for some timestamps of a submission, and the way back to the program.
struct Stamps {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read: wgpu::Buffer,
    tick_ns: f64,
}

impl Stamps {
    /// Room for `count`; None where the device lacks `features`.
    fn new(gpu: &Gpu, count: u32, features: wgpu::Features) -> Option<Self> {
        if !gpu.device.features().contains(features) {
            return None;
        }
        let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("timer"),
            ty: wgpu::QueryType::Timestamp,
            count,
        });
        let bytes = u64::from(count) * 8;
        let resolved =
            gpu.empty_buffer("timer", wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC, bytes);
        let read = gpu.empty_buffer("times", wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ, bytes);
        let tick_ns = f64::from(gpu.queue.get_timestamp_period());
        Some(Self { queries, resolved, read, tick_ns })
    }

    /// To be recorded after the last of the `count` timestamps that are wanted.
    fn resolve(&self, encoder: &mut wgpu::CommandEncoder, count: u32) {
        encoder.resolve_query_set(&self.queries, 0..count, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.read, 0, self.read.size());
    }

    /// Milliseconds from the first to the second of each of some pairs of timestamps of the last submission.
    fn read(&self, gpu: &Gpu, pairs: impl Iterator<Item = [usize; 2]>) -> Result<Vec<Option<f64>>> {
        let bytes = gpu.read_buffer(&self.read)?;
        let word = |at: usize| u64::from_le_bytes(std::array::from_fn(|i| bytes[8 * at + i]));
        Ok(pairs.map(|[begin, end]| milliseconds(word(begin), word(end), self.tick_ns)).collect())
    }
}

/// Timestamps at the beginning and end of some passes of one submission.
pub struct Timer {
    stamps: Stamps,
    passes: u32,
}

impl Timer {
    /// A timer for `passes` passes; None where the device has no timestamps, or is a program: such a one does not wait for its own
    /// threads at the end of a pass (Mesa's llvmpipe calls 5 ms of work 11 µs).
    pub fn new(gpu: &Gpu, passes: u32) -> Option<Self> {
        if gpu.software {
            return None;
        }
        let stamps = Stamps::new(gpu, 2 * passes, wgpu::Features::TIMESTAMP_QUERY)?;
        Some(Self { stamps, passes })
    }

    /// Where pass number `pass` writes its times: for the descriptor that begins it.
    pub fn writes(&self, pass: u32) -> wgpu::ComputePassTimestampWrites<'_> {
        wgpu::ComputePassTimestampWrites {
            query_set: &self.stamps.queries,
            beginning_of_pass_write_index: Some(2 * pass),
            end_of_pass_write_index: Some(2 * pass + 1),
        }
    }

    /// To be recorded after the last pass.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        self.stamps.resolve(encoder, 2 * self.passes);
    }

    /// Milliseconds of each pass of the last submission; None for an answer that cannot be believed.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device is lost meanwhile.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<Option<f64>>> {
        self.stamps.read(gpu, (0..self.passes as usize).map(|pass| [2 * pass, 2 * pass + 1]))
    }
}

/// What a timestamp can be written between the commands of.
pub trait Stamped {
    /// Writes timestamp number `index` once the commands before are done.
    fn stamp(&mut self, queries: &wgpu::QuerySet, index: u32);
}

impl Stamped for wgpu::CommandEncoder {
    fn stamp(&mut self, queries: &wgpu::QuerySet, index: u32) {
        self.write_timestamp(queries, index);
    }
}

impl Stamped for wgpu::ComputePass<'_> {
    fn stamp(&mut self, queries: &wgpu::QuerySet, index: u32) {
        self.write_timestamp(queries, index);
    }
}

/// Stages of a frame at most.
const MOST_STAGES: u32 = 15;

/// Timestamps between the stages of a frame; unless it is measured, nothing.
#[derive(Default)]
pub struct Stages {
    stamps: Option<Stamps>,
    names: Vec<&'static str>,
}

impl Stages {
    /// What such timestamps take beyond the WebGPU defaults.
    pub const FEATURES: wgpu::Features = wgpu::Features::TIMESTAMP_QUERY
        .union(wgpu::Features::TIMESTAMP_QUERY_INSIDE_ENCODERS)
        .union(wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES);

    /// Measures where the device has such timestamps, else nothing. Between commands a program waits for its threads, too: on Mesa's
    /// llvmpipe the stages' times add up to the frame's.
    pub fn measured(gpu: &Gpu) -> Self {
        Self { stamps: Stamps::new(gpu, 1 + MOST_STAGES, Self::FEATURES), names: Vec::new() }
    }

    /// The frame begins.
    pub fn begin(&mut self, encoder: &mut wgpu::CommandEncoder) {
        self.names.clear();
        if let Some(stamps) = &self.stamps {
            encoder.stamp(&stamps.queries, 0);
        }
    }

    /// A stage has been recorded.
    pub fn end(&mut self, commands: &mut impl Stamped, name: &'static str) {
        if let Some(stamps) = &self.stamps {
            self.names.push(name);
            commands.stamp(&stamps.queries, self.names.len() as u32);
        }
    }

    /// The frame has been recorded.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        if let Some(stamps) = &self.stamps {
            stamps.resolve(encoder, 1 + self.names.len() as u32);
        }
    }

    /// Names of the last frame's stages and their milliseconds, None for a time that cannot be believed; empty unless measured.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device is lost meanwhile.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<(&'static str, Option<f64>)>> {
        let Some(stamps) = &self.stamps else { return Ok(Vec::new()) };
        let times = stamps.read(gpu, (0..self.names.len()).map(|stage| [stage, stage + 1]))?;
        Ok(self.names.iter().copied().zip(times).collect())
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
