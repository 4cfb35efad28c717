//! The trains at a place, in f64: what `shaders/lib/shore_trains.wgsl` finds there, from the same nodes.

use std::f64::consts::TAU;

use glam::DVec2;

use super::{HANDOVER, SHORES_END_M, Shores, Window, rates};
use crate::data::tile::{MapPoint, Projection};
use crate::data::world::{SHORE_LEVEL, SHORE_SIDE};
use crate::model::sea_bed::smoothstep;
use crate::model::shore_waves::{SHALLOWEST_M, Shallows, regular};
use crate::model::surf::{self, SurfWave, TrainSum};
use crate::model::wave_trains::{TAKEN, TRAINS};
use crate::model::{GRAVITY, noise, surface, waves};

/// The waves of the trains at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShoreWaves {
    /// The water, slopes east and north.
    pub wave: SurfWave,
    /// Significant height of the trains, m.
    pub hs_m: f64,
    /// Iribarren's number of their breakers ([`surf::similarity`]).
    pub similarity: f64,
    /// Share of the trains' energy that is theirs here.
    pub share: f64,
    /// What they leave of the height of each patch, and of the mean level's.
    pub patches: [f64; 4],
    /// See `patches`.
    pub level: f64,
}

impl Shores {
    /// The waves of the trains at geodetic `lat`, `lon` (radians) at a tick, in such water: what the
    /// shader finds there near the eye, from the same numbers. `None` where there are none.
    pub fn waves_at(&self, (lat, lon): (f64, f64), water: Shallows, ticks: u64) -> Option<ShoreWaves> {
        let (depth_m, shore_m) = (water.h, water.d);
        let trains = self.trains.as_ref().filter(|_| !self.wanted.is_empty())?;
        let (sea, _) = self.sea.as_ref()?;
        let rates = rates(trains);
        let u = rates.mean * rates.mean * depth_m.max(0.0) / GRAVITY;
        let wanted = (1.0 - smoothstep(HANDOVER[0], HANDOVER[1], u))
            * (1.0 - smoothstep(0.6 * SHORES_END_M, SHORES_END_M, shore_m))
            * smoothstep(-0.5, 0.0, shore_m);
        if wanted <= 0.0 || Projection::for_latitude(lat) != Projection::Mercator {
            return None;
        }
        let across = 1i64 << SHORE_LEVEL;
        let point = MapPoint::on(Projection::Mercator, lat, lon);
        let at = [point.u, point.v].map(|at| f64::from(at) / 4_294_967_296.0 * across as f64);
        let [x, y] = at.map(|at| at.floor() as i64);
        let inside = [at[0] - x as f64, at[1] - y as f64];
        let beyond = inside.map(|at| smoothstep(0.4, 0.6, (at - 0.5).abs()));
        let step = inside.map(|at| if at > 0.5 { 1 } else { -1 });
        let share = |side: i64, beyond: f64| if side == 1 { beyond } else { 1.0 - beyond };
        let windows: Vec<_> = [[0, 0], [1, 0], [0, 1], [1, 1]]
            .into_iter()
            .filter_map(|[i, j]| {
                let energy = share(i, beyond[0]) * share(j, beyond[1]);
                let tile = [(x + i * step[0]).rem_euclid(across) as u32, (y + j * step[1]).rem_euclid(across) as u32];
                let Window::Ready(nodes) = self.windows.get(&tile).filter(|_| energy > 0.0)? else { return None };
                let place = [inside[0] - (i * step[0]) as f64 + 0.5, inside[1] - (j * step[1]) as f64 + 0.5];
                let place = place.map(|at| (at * SHORE_SIDE as f64 / 2.0).clamp(0.0, SHORE_SIDE as f64 - 1.001));
                Some((tile, nodes, place, energy))
            })
            .collect();
        let found: f64 = windows.iter().map(|window| window.3).sum();
        let (mut sum, mut energy_m2) = (TrainSum::default(), 0.0);
        for (index, train) in trains.iter().enumerate() {
            let now = surface::phase_at(waves::cycles_per_tick(train.omega), ticks);
            let (mut wave, mut way, mut energies) = (DVec2::ZERO, DVec2::ZERO, 0.0);
            for (tile, nodes, place, energy) in &windows {
                let [rest, east, south] = between(nodes, index, *place);
                let chance = f64::from(noise::hash([tile[0], tile[1], index as u32]) >> 8) / 16_777_216.0;
                let (sin, cos) = libm::sincos(now - rest - regular(train.omega, water) + TAU * chance);
                let size = libm::hypot(east, south);
                wave += libm::sqrt(*energy) * size * DVec2::new(cos, sin);
                way += energy * size * DVec2::new(east, -south);
                energies += energy * size * size;
            }
            energy_m2 += train.amplitude_m * train.amplitude_m * energies;
            let h = depth_m.max(SHALLOWEST_M);
            let u = train.omega * train.omega * h / GRAVITY;
            let drawn = train.amplitude_m * libm::sqrt(energies) / wave.length().max(1e-6) * wave;
            let steep = u / (h * libm::sqrt(libm::tanh(u))) / way.length().max(1e-9) * way;
            for axis in 0..2 {
                sum.z[axis] += drawn[axis];
                sum.cosines[axis] += steep[axis] * drawn.x;
                sum.sines[axis] += steep[axis] * drawn.y;
            }
        }
        let share = wanted * found;
        let taken = self.taken_share(sea);
        let left = |taken: f64| libm::sqrt((1.0 - taken * share).max(0.0));
        // A wave is twice as high as the sum is long, whose square has the trains' energy for a mean.
        let rms_deep_m = 2.0 * water.left * libm::sqrt(wanted * energy_m2);
        let patches = TAKEN.map(|part| left(part * part));
        (found > 0.0).then(|| ShoreWaves {
            wave: sum.wave(rates, water, wanted, sea.sea.chop),
            hs_m: surf::significant_height(rates, water, rms_deep_m),
            similarity: surf::usual_similarity(rates, water, rms_deep_m),
            share,
            patches,
            level: left(taken),
        })
    }
}

/// R and the way of a train at a place between the nodes of a window.
fn between(nodes: &[[u32; 2]], train: usize, [x, y]: [f64; 2]) -> [f64; 3] {
    let (i, j) = (x as usize, y as usize);
    let (f, g) = (x - i as f64, y - j as f64);
    let node = |i: usize, j: usize| {
        let [rest, way] = nodes[(j * SHORE_SIDE + i) * TRAINS + train];
        let part = |bits: u32| 2.0 * f64::from(bits as u16 as i16) / 32_767.0;
        [f64::from(f32::from_bits(rest)), part(way), part(way >> 16)]
    };
    let corners = [node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)];
    let weights = [(1.0 - f) * (1.0 - g), f * (1.0 - g), (1.0 - f) * g, f * g];
    std::array::from_fn(|part| corners.iter().zip(weights).map(|(corner, weight)| weight * corner[part]).sum())
}
