//! The eye over the moving water: its altitude counted from the surface at its place instead of from the ellipsoid.
//!
//! A ride asks for one place in every frame, so the waves are summed there one by one, each as the linear interpolation
//! between its tile's samples leaves it: the drawn surface without the transforms of [`super::surface_sample`].

use std::sync::{Arc, Mutex, PoisonError};

use glam::{DVec2, DVec3};

use super::camera::Camera;
use super::moved_water::{Motion, Place, between_samples};
use super::sea::SeaTables;
use super::settings::Settings;
use super::view_state::ViewState;
use crate::model::fft::{Complex, mul};
use crate::model::surface::{evolve, gain_of, phase_at};
use crate::model::waves::{self, Cascade, Tile};

/// Waves lower than this share of the significant height do not lift the eye.
const NOTICED: f64 = 5e-5;

/// A wave and its mirror −k, which make a real wave together.
struct Wave {
    /// Column and row in the tile.
    at: [usize; 2],
    k: DVec2,
    h0: Complex,
    h0_mirror: Complex,
    cycles_per_tick: u64,
}

/// The waves of a cascade that move an eye noticeably.
struct Lift {
    n: usize,
    patch_m: f64,
    /// e^{2πi/n} to the power 0…n − 1.
    turns: Vec<Complex>,
    waves: Vec<Wave>,
}

impl Lift {
    fn new(tables: &SeaTables, index: usize, cascade: &Cascade) -> Self {
        let (tile, n) = (Tile::from(cascade), cascade.n);
        let h0 = waves::initial_amplitudes(&tables.sea, index, cascade);
        let omegas = tables.frequencies(cascade);
        let noticed = NOTICED * tables.sea.hs_m;
        let size = |i: usize| h0[i][0].hypot(h0[i][1]);
        let big = (0..tile.count()).filter(|&i| i < tile.mirror(i) && size(i) + size(tile.mirror(i)) > noticed);
        let sharpened = |i: usize| h0[i].map(|part| part * gain_of(tile, i));
        let waves = big.map(|i| Wave {
            at: [i % n, i / n],
            k: tile.wave_vector(i).into(),
            h0: sharpened(i),
            h0_mirror: sharpened(tile.mirror(i)),
            cycles_per_tick: waves::cycles_per_tick(omegas[i]),
        });
        let turn = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
            [cos, sin]
        };
        Self { n, patch_m: cascade.patch_m, turns: (0..n).map(turn).collect(), waves: waves.collect() }
    }

    /// H(k) of every wave at a tick.
    fn evolved(&self, ticks: u64) -> Vec<Complex> {
        let h = |w: &Wave| evolve(w.h0, w.h0_mirror, 0.0, phase_at(w.cycles_per_tick, ticks)).0;
        self.waves.iter().map(h).collect()
    }

    /// e^{ikx} for every wave number of an axis, linearly between the samples around coordinate `at`, m.
    fn factors(&self, at: f64) -> Vec<Complex> {
        let (low, way) = between_samples(at, self.patch_m, self.n);
        let mix = |i: usize| {
            let (a, b) = (self.turns[i * low % self.n], self.turns[i * (low + 1) % self.n]);
            [a[0] + way * (b[0] - a[0]), a[1] + way * (b[1] - a[1])]
        };
        (0..self.n).map(mix).collect()
    }

    /// The motion at tile coordinates `at`, m, from the waves' H(k).
    fn motion(&self, evolved: &[Complex], at: DVec2) -> Motion {
        let (along_x, along_y) = (self.factors(at.x), self.factors(at.y));
        let mut sum = Motion::default();
        for (wave, h) in self.waves.iter().zip(evolved) {
            let turned = mul(*h, mul(along_x[wave.at[0]], along_y[wave.at[1]]));
            // Twice the real part, for the mirrored wave too.
            let (re, im) = (2.0 * turned[0], 2.0 * turned[1]);
            let (k, unit) = (wave.k, wave.k.normalize());
            sum += Motion {
                height: re,
                shift: -im * unit,
                slope: -im * k,
                stretch: -re * DVec3::new(k.x * unit.x, k.y * unit.y, k.x * unit.y),
            };
        }
        sum
    }
}

/// Height in metres of the drawn surface over the ellipsoid under the eye.
pub fn surface_height(settings: &Settings, camera: &Camera, unix_seconds: f64) -> f64 {
    type Kept = (Arc<SeaTables>, Vec<Lift>);
    static LAST: Mutex<Option<Kept>> = Mutex::new(None);
    let tables = SeaTables::of(settings);
    if tables.sea.hs_m == 0.0 {
        return 0.0;
    }
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    let (_, lifts) = match last.take().filter(|(kept, _)| *kept == tables) {
        Some(kept) => last.insert(kept),
        None => {
            let lift = |(index, cascade)| Lift::new(&tables, index, cascade);
            let lifts = tables.cascades.iter().enumerate().map(lift).collect();
            last.insert((tables.clone(), lifts))
        }
    };
    let ticks = waves::ticks_from_unix(unix_seconds);
    let evolved: Vec<_> = lifts.iter().map(|lift| lift.evolved(ticks)).collect();
    let place = Place::new(settings, &tables, camera.lat, camera.lon);
    let tile = |index: usize, at| lifts[index].motion(&evolved[index], at);
    place.invert(tables.sea.chop, tile).1.height - tables.chop_level_m
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
