//! A straight beach: pictures of its water from above at many instants, taken apart into the trains that make it. It faces east, so that pictures
//! whose top is south have the sea on their left.

use std::f64::consts::TAU;

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::world::World;
use ocean_globe::model::wave_trains::{TRAINS, Train, trains};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::sea::Seas;

use crate::small_world::{self, Folder};

/// Longitude of the small world's eastern shore, degrees: at 60, by the whole 32nd of a texel that distances are stored in.
pub const SHORE_DEG: f64 = 60.001_831_05;
/// Metres on the ground of a degree of longitude at the equator.
pub const DEGREE_M: f64 = 111_319.491;
/// How far from the shore its bed is looked up, m.
const KNOWN_M: usize = 6_000;
/// Middle between two windows' edges, and such an edge, latitude.
pub const WITHIN_DEG: f64 = 0.021_97;
/// See [`WITHIN_DEG`].
pub const EDGE_DEG: f64 = 0.043_945;
/// Seconds that instants are spread over: trains differ by 0.003 rad/s at least, which makes ten turns.
const OVER_S: f64 = 20_000.0;

/// A view straight down: the latitude and the depth of its middle, and the eye's height, degrees and metres.
#[derive(Clone, Copy)]
pub struct View {
    pub lat_deg: f64,
    pub depth_m: f64,
    pub altitude_m: f64,
    pub size: [usize; 2],
}

impl View {
    /// Width of a pixel, m.
    pub fn pixel_m(&self) -> f64 {
        self.altitude_m * 2.0 * (TAU / 16.0).tan() / self.size[1] as f64
    }
}

/// The beach with who draws it.
pub struct Beach {
    pub renderer: Renderer,
    /// By the metre from the shore on, m.
    depths_m: Vec<f64>,
    _folder: Folder,
}

impl Beach {
    pub fn new(name: &str) -> Self {
        let folder = small_world::baked(name);
        let path = folder.path().to_str().unwrap();
        let mut world = World::open(path);
        let depth_m = |way_m: usize| {
            let lon = SHORE_DEG + way_m as f64 / DEGREE_M;
            let place = world.sample_blocking(WITHIN_DEG.to_radians(), lon.to_radians()).unwrap();
            place.depth_m.unwrap_or(0.0)
        };
        let depths_m = (0..KNOWN_M).map(depth_m).collect();
        Self { renderer: render::headless(path, Radiance::Single).unwrap(), depths_m, _folder: folder }
    }

    /// Metres from the shore to water of a depth.
    fn way_m(&self, depth_m: f64) -> f64 {
        let beyond = self.depths_m.iter().position(|&depth| depth > depth_m).unwrap();
        let [near, far] = [beyond - 1, beyond].map(|way| self.depths_m[way]);
        (beyond - 1) as f64 + (depth_m - near) / (far - near)
    }

    /// A layer of a view of the sea that a link's part says, so many seconds after midnight.
    pub fn layer(&mut self, view: &View, sea: &str, second: f64, layer: LayerName) -> Vec<f64> {
        let lon = SHORE_DEG + self.way_m(view.depth_m) / DEGREE_M;
        let link = format!("#view={},{lon},{},180,0&{sea}&clouds=0", view.lat_deg, view.altitude_m);
        let mut state = render::parse_state(&link).unwrap();
        state.time = ocean_globe::scene::time::SceneTime::At(1_782_000_000.0 + second);
        render::measure(&mut self.renderer, &state, view.size.map(|side| side as u32), layer).unwrap().values
    }

    /// Heights at so many instants, each with its time in seconds.
    pub fn heights(&mut self, view: &View, sea: &str, instants: u32) -> Vec<(f64, Vec<f64>)> {
        let times = (0..instants).map(|i| OVER_S * (f64::from(i) * 0.618_034).fract());
        times.map(|second| (second, self.layer(view, sea, second, LayerName::Height))).collect()
    }
}

/// The trains of a sea whose wind blows to the shore: their directions are those from its normal.
pub fn trains_of(sea: &str) -> [Train; TRAINS] {
    let settings = render::parse_state(&format!("#{sea}")).unwrap().settings;
    trains(&Seas::default().tables(&settings)).unwrap()
}

/// x of Ax = b for the columns of many b, by elimination.
fn solved(mut matrix: Vec<Vec<f64>>, mut right: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = matrix.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| matrix[a][i].abs().total_cmp(&matrix[b][i].abs())).unwrap();
        for rows in [&mut matrix, &mut right] {
            rows.swap(i, pivot);
        }
        for row in (0..n).filter(|&row| row != i) {
            let factor = matrix[row][i] / matrix[i][i];
            for rows in [&mut matrix, &mut right] {
                let from = rows[i].clone();
                rows[row].iter_mut().zip(from).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    right.iter().enumerate().map(|(i, row)| row.iter().map(|x| x / matrix[i][i]).collect()).collect()
}

/// Each train's a e^{iφ} in each pixel, of a cos(ωt + φ), by least squares over the instants.
pub fn taken_apart(pictures: &[(f64, Vec<f64>)], trains: &[Train]) -> Vec<Vec<DVec2>> {
    let waves = |(t, _): &(f64, Vec<f64>)| -> Vec<f64> {
        trains.iter().map(|train| (train.omega * t).sin_cos()).flat_map(|(sin, cos)| [cos, -sin]).collect()
    };
    let basis: Vec<_> = pictures.iter().map(waves).collect();
    let n = 2 * trains.len();
    let squares = (0..n).map(|i| (0..n).map(|j| basis.iter().map(|row| row[i] * row[j]).sum()).collect()).collect();
    let weights = solved(squares, (0..n).map(|i| basis.iter().map(|row| row[i]).collect()).collect());
    let at =
        |weights: &[f64], pixel: usize| weights.iter().zip(pictures).map(|(w, (_, heights))| w * heights[pixel]).sum();
    let both = |pair: &[Vec<f64>]| {
        (0..pictures[0].1.len()).map(|pixel| DVec2::new(at(&pair[0], pixel), at(&pair[1], pixel))).collect()
    };
    weights.chunks(2).map(both).collect()
}
