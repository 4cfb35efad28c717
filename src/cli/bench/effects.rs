//! What each effect of light takes of a frame: the share that goes when it is switched off.
//!
//! Each frame is timed beside the same one without the effect, forwards and backwards in turn, and the median of their ratios counts:
//! other load on the machine weighs on both sides.

use super::{frame_ms, median};
use crate::cli::render::{draw, instant};
use crate::data::world::World;
use crate::error::Result;
use crate::gpu::Gpu;
use crate::renderer::{Radiance, Renderer};
use crate::scene::frame::{Frame, Output};
use crate::scene::layers::Layer;
use crate::scene::settings::Quality;
use crate::scene::view::state::ViewState;

/// Scene seconds from one timed frame to the next.
const STEP_S: f64 = 0.1;

/// Something of a picture that can be left out of it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Effect {
    /// The sky behind land and sea.
    Sky,
    /// Map, lace, bubbles and light of the foam.
    Foam,
    /// White air over a stormy sea, and the plumes in it.
    Spray,
    /// These plumes, which blow off its crests.
    Spindrift,
    Clouds,
    Stars,
    CityLights,
    /// All that low quality does without: sparkle, light through crests, blooms, glow, faint cities.
    Fine,
    /// Several samples a pixel along the edges of waves.
    SmoothEdges,
}

impl Effect {
    const ALL: [(Self, &'static str); 9] = [
        (Self::Sky, "sky"),
        (Self::Foam, "foam"),
        (Self::Spray, "spray"),
        (Self::Spindrift, "spindrift"),
        (Self::Clouds, "clouds"),
        (Self::Stars, "stars"),
        (Self::CityLights, "lights"),
        (Self::Fine, "fine"),
        (Self::SmoothEdges, "edges"),
    ];

    /// A state and its frame without the effect; `None` where the frame does not have it.
    fn left_out(self, renderer: &mut Renderer, state: &ViewState, frame: &Frame) -> Option<Frame> {
        let software = renderer.gpu().software;
        let mut without = frame.clone();
        let has = match self {
            Self::Sky | Self::Foam => {
                let layer = if self == Self::Sky { Layer::Sky } else { Layer::Foam };
                let mut settings = state.settings.clone();
                settings.layers.set(layer, false);
                without = renderer.frame(&settings, &frame.camera, frame.unix_seconds, frame.size);
                // From space the whole globe is drawn at once, with all of its layers.
                state.settings.layers.shows(layer) && without.is_globe() == frame.is_globe()
            }
            Self::Spray => std::mem::take(&mut without.uniform.spray) > 0.0,
            Self::Spindrift => frame.has_spindrift() && std::mem::take(&mut without.uniform.spindrift) > 0.0,
            Self::Clouds => without.clouds.take().is_some(),
            Self::Stars => std::mem::take(&mut without.shows_stars),
            Self::CityLights => std::mem::take(&mut without.shows_city_lights),
            Self::Fine => {
                without.quality = Quality::Low;
                frame.is_fine() && !frame.has_smooth_edges(software)
            }
            Self::SmoothEdges => {
                without.quality = Quality::Medium;
                frame.has_smooth_edges(software) && !frame.is_globe()
            }
        };
        has.then_some(without)
    }
}

/// Renderers for [`Effects::measure`]: of whole frames, of those that lack an effect, and of those that lack the foam, whose history
/// a renderer keeps from frame to frame.
pub struct Effects {
    renderers: [Renderer; 3],
    target: wgpu::TextureView,
    size: [u32; 2],
}

impl Effects {
    /// Over the world in the folder `data`, for pictures of `size` into `target`.
    ///
    /// # Errors
    /// As [`Renderer::with_radiance`].
    pub fn new(gpu: &Gpu, data: &str, target: wgpu::TextureView, size: [u32; 2]) -> Result<Self> {
        let one = || pollster::block_on(Renderer::with_radiance(gpu.clone(), World::open(data), Radiance::Half));
        Ok(Self { renderers: [one()?, one()?, one()?], target, size })
    }

    /// The share that each effect takes of a view's frame, in `rounds`; `None` where the view does not have it.
    ///
    /// # Errors
    /// As [`draw`], or a lost device.
    pub fn measure(&mut self, state: &ViewState, rounds: u16) -> Result<Vec<(&'static str, Option<f64>)>> {
        let mut foamless = state.clone();
        foamless.settings.layers.set(Layer::Foam, false);
        let [whole, lacking, without_foam] = &mut self.renderers;
        for (renderer, state) in [(&mut *whole, state), (&mut *lacking, state), (&mut *without_foam, &foamless)] {
            draw(renderer, state, self.size, Output::Picture)?;
        }
        let mut clock_s = instant(state);
        let mut shares = Vec::new();
        for (effect, name) in Effect::ALL {
            let other = if effect == Effect::Foam { &mut *without_foam } else { &mut *lacking };
            let mut ratios = Vec::new();
            // The first pair makes pipelines.
            for round in 0..=rounds {
                clock_s += STEP_S;
                let eye = whole.eye(state, clock_s);
                let frame = whole.frame(&state.settings, &eye, clock_s, self.size);
                let Some(without) = effect.left_out(other, state, &frame) else { break };
                let mut with_ms = 0.0;
                if round % 2 == 0 {
                    with_ms = frame_ms(whole, &frame, &self.target)?[0];
                }
                let without_ms = frame_ms(other, &without, &self.target)?[0];
                if round % 2 == 1 {
                    with_ms = frame_ms(whole, &frame, &self.target)?[0];
                }
                if round > 0 {
                    ratios.push(without_ms / with_ms);
                }
            }
            shares.push((name, (!ratios.is_empty()).then(|| 1.0 - median(ratios))));
        }
        Ok(shares)
    }

    /// Heads of [`Effects::row`]'s columns.
    pub fn head() -> String {
        format!("{:<12}{}", "effects", Effect::ALL.map(|(_, name)| format!(" {name:>8}")).concat())
    }

    /// A row of the table.
    pub fn row(view: &str, shares: &[(&str, Option<f64>)]) -> String {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let cells = shares.iter().map(|(_, share)| format!(" {:>8}", share.map_or_else(|| "-".into(), percent)));
        format!("{view:<12}{}", cells.collect::<String>())
    }

    /// The record of a view.
    pub fn json(view: &str, shares: &[(&str, Option<f64>)]) -> serde_json::Value {
        let shares: serde_json::Map<_, _> =
            shares.iter().map(|(name, share)| ((*name).into(), (*share).into())).collect();
        serde_json::json!({ "view": view, "shares": shares })
    }
}
