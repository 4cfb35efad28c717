//! What a height costs with either mesh, and the shares of the mesh's work and of the far sea's noise in it.
//!
//! A moving picture makes its mesh anew in every frame: the grid is cast, the bisected triangles are updated as often as in the
//! window. Each frame is timed against others of the same round:
//! ```text
//!  tessellation  the frame / that on a grid of a sixteenth of the vertices, less 1
//!  updates       the frame / that of the same triangles at rest, less 1
//!  noise         the frame / that whose patches make the far waves as well, less 1
//! ```
//! Rounds run forwards and backwards in turn, and the median of their ratios counts: other load on the machine weighs on both sides.

use std::time::Duration;

use super::{STEP_S, frame_ms, median};
use crate::cli::render::{draw, instant};
use crate::data::world::World;
use crate::error::Result;
use crate::gpu::Gpu;
use crate::model::earth::WGS84;
use crate::renderer::{Cost, Radiance, Renderer};
use crate::scene::frame::{Frame, Output};
use crate::scene::sea::Seas;
use crate::scene::settings::{Mesh, Settings};
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

/// How many times as wide as the grid's the coarse grid's cells are.
const COARSER: f32 = 4.0;
/// Way of the eye in a round, altitudes: the bisected mesh has to follow.
const WAY: f64 = 0.01;

/// How a frame is made.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// On the grid.
    Grid,
    /// On the grid, the noise left out.
    GridAlone,
    /// On the grid of a sixteenth of the vertices.
    Coarse,
    /// On bisected triangles that follow the eye.
    Bisect,
    /// On bisected triangles at rest.
    AtRest,
    /// On bisected triangles at rest, the noise left out.
    AtRestAlone,
}

impl Way {
    const ALL: [Self; 6] = [Self::Grid, Self::GridAlone, Self::Coarse, Self::Bisect, Self::AtRest, Self::AtRestAlone];

    /// Which of the renderers draws it: each keeps its own mesh and foam.
    fn renderer(self) -> usize {
        match self {
            Self::Grid | Self::GridAlone => 0,
            Self::Coarse => 1,
            Self::Bisect | Self::AtRest | Self::AtRestAlone => 2,
        }
    }

    fn frame(self, seas: &mut Seas, state: &ViewState, eye: &Camera, unix_seconds: f64, size: [u32; 2]) -> Frame {
        let mesh = if self.renderer() == 2 { Mesh::Bisect } else { Mesh::Grid };
        let settings = Settings { mesh, ..state.settings.clone() };
        let mut frame = Frame::of(seas, &settings, eye, unix_seconds, size);
        if self == Self::Coarse {
            frame.set_cell_pixels(COARSER * frame.uniform.cell_pixels);
        }
        if matches!(self, Self::GridAlone | Self::AtRestAlone) { frame.without_noise() } else { frame }
    }
}

/// What a height costs on one mesh. Shares are of the frame without what they are of.
pub struct Height {
    /// The mesh's name in links.
    pub mesh: &'static str,
    /// Altitude that the view asks for, metres.
    pub altitude_m: f64,
    /// Work of a frame.
    pub cost: Cost,
    /// Time of a frame, milliseconds.
    pub frame_ms: f64,
    /// The mesh against a coarse one.
    pub tessellation: f64,
    /// The mesh's updates alone; `None` for the grid, which has none.
    pub updates: Option<f64>,
    /// The far sea's noise.
    pub noise: f64,
}

/// Renderers for [`Height`]s: of the grid, of the coarse grid, of the bisected mesh.
pub struct Heights {
    renderers: [Renderer; 3],
    target: wgpu::TextureView,
    size: [u32; 2],
}

impl Heights {
    /// Over the world in the folder `data`, for pictures of `size` into `target`.
    ///
    /// # Errors
    /// As [`Renderer::with_radiance`].
    pub fn new(gpu: &Gpu, data: &str, target: wgpu::TextureView, size: [u32; 2]) -> Result<Self> {
        let one = || pollster::block_on(Renderer::with_radiance(gpu.clone(), World::open(data), Radiance::Half));
        let mut renderers = [one()?, one()?, one()?];
        renderers.iter_mut().for_each(|renderer| renderer.set_moving(true));
        Ok(Self { renderers, target, size })
    }

    /// Measures a view in `rounds`, on the grid and on the bisected mesh.
    ///
    /// # Errors
    /// As [`draw`], or a lost device.
    pub fn measure(&mut self, state: &ViewState, rounds: u16) -> Result<[Height; 2]> {
        let mut clock_s = instant(state);
        let mut eye = state.camera;
        for way in [Way::Grid, Way::Coarse, Way::Bisect] {
            let mut meshed = state.clone();
            meshed.settings.mesh = if way == Way::Bisect { Mesh::Bisect } else { Mesh::Grid };
            eye = draw(&mut self.renderers[way.renderer()], &meshed, self.size, Output::Picture)?.0.camera;
        }
        let mut times = [const { Vec::new() }; Way::ALL.len()];
        let mut costs = [None; Way::ALL.len()];
        for round in 0..rounds {
            let mut order = Way::ALL;
            if round % 2 == 1 {
                order.reverse();
            }
            for way in order {
                clock_s += STEP_S;
                if way == Way::Bisect {
                    eye.lon += WAY * eye.altitude_m.abs() / WGS84.a;
                }
                let renderer = &mut self.renderers[way.renderer()];
                let frame = way.frame(renderer.seas_mut(), state, &eye, clock_s, self.size);
                while !renderer.load(&frame) {
                    std::thread::sleep(Duration::from_millis(2));
                }
                times[way as usize].push(frame_ms(renderer, &frame, &self.target)?[0]);
                costs[way as usize] = Some(renderer.cost()?);
                if way == Way::Bisect {
                    renderer.settle_mesh(&frame);
                }
            }
        }
        let share = |way: Way, without: Way| {
            let ratios = times[way as usize].iter().zip(&times[without as usize]).map(|(a, b)| a / b);
            median(ratios.collect()) - 1.0
        };
        let height = |mesh, way: Way, updates, noise| Height {
            mesh,
            altitude_m: state.camera.altitude_m,
            cost: costs[way as usize].unwrap_or_default(),
            frame_ms: median(times[way as usize].clone()),
            tessellation: share(way, Way::Coarse),
            updates,
            noise,
        };
        Ok([
            height("grid", Way::Grid, None, share(Way::Grid, Way::GridAlone)),
            height("bisect", Way::Bisect, Some(share(Way::Bisect, Way::AtRest)), share(Way::AtRest, Way::AtRestAlone)),
        ])
    }
}

impl Height {
    /// Heads of [`Height::row`]'s columns.
    pub fn head() -> String {
        format!(
            "{:<12} {:<7} {:>10} {:>10} {:>10} {:>10} {:>13} {:>8} {:>7}",
            "height", "mesh", "vertices", "triangles", "dispatches", "frame ms", "tessellation", "updates", "noise"
        )
    }

    /// A row of the table.
    pub fn row(&self) -> String {
        let Cost { vertices, triangles, dispatches, .. } = self.cost;
        let percent = |share: f64| format!("{:+.0} %", 100.0 * share);
        let altitude = match self.altitude_m {
            metres if metres.abs() < 10_000.0 => format!("{metres:.0} m"),
            metres => format!("{:.0} km", 1e-3 * metres),
        };
        format!(
            "{altitude:<12} {:<7} {vertices:>10} {triangles:>10} {dispatches:>10} {:>10.2} {:>13} {:>8} {:>7}",
            self.mesh,
            self.frame_ms,
            percent(self.tessellation),
            self.updates.map_or_else(String::new, percent),
            percent(self.noise),
        )
    }

    /// The record of the view called `view`.
    pub fn json(&self, view: &str) -> serde_json::Value {
        serde_json::json!({
            "view": view,
            "altitude_m": self.altitude_m,
            "mesh": self.mesh,
            "vertices": self.cost.vertices,
            "triangles": self.cost.triangles,
            "dispatches": self.cost.dispatches,
            "frame_ms": self.frame_ms,
            "tessellation": self.tessellation,
            "updates": self.updates,
            "noise": self.noise,
        })
    }
}
