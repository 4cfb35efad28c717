//! Rivers of the whole world as lines, read from what `gmt pscoast -Df -I1 -I2 -M` lists of the CIA's World Data Bank II:
//!
//! ```text
//! > River Bin # 6222, Level 1       a line, cut where GMT's bins meet; only the ranks of `Stream` are taken
//! 103 72.2554665446                 its points, degrees east and north
//! ```

use super::shorelines::place;
use super::simplify::simplified_line;
use crate::data::coast::Stream;
use crate::error::{Error, Result};
use std::path::Path;

/// The greatest rank of the data bank.
const RANKS: u8 = 10;
/// Levels from which on rivers are in the tiles: there they are a twelfth and an eighth of a texel wide.
const FROM_LEVEL: [u8; Stream::ALL.len()] = [5, 7];

/// A line in units of the whole map, see [`super::shorelines::BITS`].
pub struct Course {
    pub stream: Stream,
    pub points: Vec<[i32; 2]>,
}

impl Course {
    /// Whether tiles of a level hold it; the deepest one's do, as all below are made of them.
    pub fn is_at(&self, z: u8, deepest: bool) -> bool {
        deepest || z >= FROM_LEVEL[self.stream.index()]
    }

    /// With fewer points, none of which left out is farther away than `tolerance` says.
    pub fn simplified(self, tolerance: impl Fn([i32; 2]) -> f64) -> Self {
        Self { points: simplified_line(&self.points, tolerance), ..self }
    }
}

/// Reads the listing.
///
/// # Errors
/// A file that is missing, or is none of rivers: a line without a rank, with a point that is none or outside of the world, of less than two points.
pub fn read(path: &Path) -> Result<Vec<Course>> {
    let hint = "make it with scripts/make-world.sh";
    let text = std::fs::read_to_string(path).map_err(|e| Error::io(path.display().to_string(), e, hint))?;
    let bad = |number: usize, why: &str| Error::bad_data(format!("{} line {number}", path.display()), why, hint);
    let mut courses = Vec::new();
    let mut open: Option<(usize, u8, Vec<[f64; 2]>)> = None;
    for (number, line) in text.lines().enumerate().map(|(at, line)| (at + 1, line.trim())) {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        if let Some(head) = line.strip_prefix('>') {
            let rank = head.rsplit_once("Level").and_then(|(_, rank)| rank.trim().parse::<u8>().ok());
            let rank = rank.filter(|rank| *rank <= RANKS).ok_or_else(|| bad(number, "has no `Level` from 0 to 10"))?;
            if let Some((at, ..)) = open.take_if(|(_, _, points)| points.len() < 2) {
                return Err(bad(at, "begins a river of less than two points"));
            }
            courses.extend(open.replace((number, rank, Vec::new())).and_then(course));
            continue;
        }
        let numbers: Vec<_> = line.split_whitespace().map(|word| word.parse::<f64>().unwrap_or(f64::NAN)).collect();
        let ([lon, lat], Some((_, _, points))) = (&numbers[..], &mut open) else {
            return Err(bad(number, "is no point of a river: longitude and latitude after a line that begins with >"));
        };
        if !(-180.0..=360.0).contains(lon) || !(-90.0..=90.0).contains(lat) {
            return Err(bad(number, "has a point outside of the world"));
        }
        points.push([*lon, *lat]);
    }
    if let Some((at, ..)) = open.as_ref().filter(|(_, _, points)| points.len() < 2) {
        return Err(bad(*at, "begins a river of less than two points"));
    }
    courses.extend(open.and_then(course));
    Ok(courses)
}

/// `None` of a rank that is left out, and of a line that is shorter than a unit.
fn course((_, rank, mut line): (usize, u8, Vec<[f64; 2]>)) -> Option<Course> {
    let stream = Stream::ALL.into_iter().find(|stream| *stream as u8 == rank)?;
    // All of it on one side of the antimeridian, where bins meet, too.
    if line.iter().any(|[lon, _]| *lon > 180.0) {
        line.iter_mut().for_each(|point| point[0] -= 360.0);
    }
    let mut points: Vec<_> = line.iter().map(|[lon, lat]| place(*lon, *lat)).collect();
    points.dedup();
    (points.len() > 1).then_some(Course { stream, points })
}
