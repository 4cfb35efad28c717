//! The eye over the moving water: its altitude counted from the surface at its place instead of from the ellipsoid.

use glam::{DVec2, DVec3};

use super::camera::Camera;
use super::sea::SeaTables;
use super::settings::Settings;
use super::view_state::ViewState;
use super::wave_domain::{blend, cells_near};
use crate::model::fft::{Complex, mul};
use crate::model::waves::{self, Cascade};
use std::sync::{Arc, Mutex};

/// Waves lower than this share of the significant height do not lift the eye.
const NOTICED: f64 = 2e-4;

/// Steps of the inversion of the chop; each leaves the local stretch, some 0.3, of the error before.
const ITERATIONS: usize = 5;

struct Wave {
    kx: f64,
    ky: f64,
    h0: Complex,
    h0_mirror: Complex,
    cycles_per_tick: u64,
}

/// The waves that move an eye noticeably, one list per cascade.
struct Lift {
    tables: Arc<SeaTables>,
    waves: Vec<Vec<Wave>>,
}

impl Lift {
    fn new(tables: Arc<SeaTables>) -> Self {
        let noticed = NOTICED * tables.sea.hs_m;
        let list = |(index, cascade): (usize, &Cascade)| {
            let h0 = waves::initial_amplitudes(&tables.sea, index, cascade);
            let omegas = waves::angular_frequencies(cascade, f64::INFINITY);
            let n = cascade.n;
            let mirror = |i: usize| ((n - i / n) % n) * n + (n - i % n) % n;
            let vectors = cascade.wave_vectors().enumerate();
            let big =
                vectors.filter(|&(i, _)| h0[i][0].hypot(h0[i][1]) + h0[mirror(i)][0].hypot(h0[mirror(i)][1]) > noticed);
            big.map(|(i, (kx, ky))| Wave {
                kx,
                ky,
                h0: h0[i],
                h0_mirror: h0[mirror(i)],
                cycles_per_tick: waves::cycles_per_tick(omegas[i]),
            })
            .collect()
        };
        let waves = tables.cascades.iter().enumerate().map(list).collect();
        Self { tables, waves }
    }

    /// Height and horizontal displacement of cascade `index` at rest coordinates `at`.
    fn cascade(&self, index: usize, at: DVec2, ticks: u64) -> (f64, DVec2) {
        let (mut height, mut shift) = (0.0, DVec2::ZERO);
        for wave in &self.waves[index] {
            let phase =
                f64::from(waves::phase_u32(wave.cycles_per_tick, ticks)) / 4_294_967_296.0 * std::f64::consts::TAU;
            let (sin, cos) = phase.sin_cos();
            let forward = mul(wave.h0, [cos, -sin]);
            let backward = mul([wave.h0_mirror[0], -wave.h0_mirror[1]], [cos, sin]);
            let h = [forward[0] + backward[0], forward[1] + backward[1]];
            let (sin, cos) = (wave.kx * at.x + wave.ky * at.y).sin_cos();
            let turned = mul(h, [cos, sin]);
            let k = wave.kx.hypot(wave.ky);
            height += turned[0];
            // D = i k/|k| H: the real part of i·turned is −Im.
            shift -= DVec2::new(wave.kx, wave.ky) / k * turned[1];
        }
        (height, shift)
    }
}

/// Height in metres of the wave tiles' surface over the ellipsoid under the eye.
pub fn surface_height(settings: &Settings, camera: &Camera, unix_seconds: f64) -> f64 {
    static LAST: Mutex<Option<Lift>> = Mutex::new(None);
    let tables = SeaTables::of(settings);
    if tables.sea.hs_m == 0.0 {
        return 0.0;
    }
    let mut last = LAST.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let lift = match last.take().filter(|kept| kept.tables == tables) {
        Some(kept) => last.insert(kept),
        None => last.insert(Lift::new(tables.clone())),
    };
    let cells = cells_near(camera.lat, camera.lon);
    let foot = Camera { altitude_m: 0.0, ..*camera }.eye_ecef();
    let serving = blend(&cells, foot);
    let wind_from = settings.wind.from_deg.to_radians();
    let ticks = waves::ticks_from_unix(unix_seconds);
    // The rest point whose chop carries it under the eye: r + λ D(r) = foot, by iteration.
    let mut rest = foot;
    let mut height = 0.0;
    for _ in 0..ITERATIONS {
        let mut shift = DVec3::ZERO;
        height = 0.0;
        for &(cell, weight) in &serving {
            let (x, y) = cell.axes(wind_from);
            let away = rest - cell.centre;
            let place = DVec2::new(away.dot(x), away.dot(y));
            for (index, cascade) in tables.cascades.iter().enumerate() {
                let at = place + cell.offset(settings.seed, index as u32, cascade.patch_m);
                let (h, d) = lift.cascade(index, at, ticks);
                height += weight * h;
                shift += weight * (d.x * x + d.y * y);
            }
        }
        rest = foot - settings.chop * shift;
    }
    height
}

impl ViewState {
    /// The eye at an instant: the camera, lifted onto the moving surface when it rides.
    pub fn eye(&self, unix_seconds: f64) -> Camera {
        if !self.ride {
            return self.camera;
        }
        let lift = surface_height(&self.settings, &self.camera, unix_seconds);
        Camera { altitude_m: self.camera.altitude_m + lift, ..self.camera }
    }
}
