//! A picture of the whole world, equirectangular, in linear light: where it shows land it is kept, and that land's colour is continued over
//! the water (push-pull: S. J. Gortler and others 1996, doi:10.1145/237170.237200), so that nothing bleeds from the water into a coast.

use std::path::Path;

use super::land::Land;
use crate::data::imagery::decode_jpeg;
use crate::error::{Error, Result};

/// Longest side accepted, pixels.
const LONGEST: usize = 43_200;
const REMEDY: &str =
    "give an 8-bit RGB picture of the world, JPEG or PNG, twice as wide as high, north up, from 180 degrees west";

/// Pixels inland from which on a pixel shows land, and from which on it shows land alone, whatever its colour: a picture's compression mixes
/// colours over two pixels and more, and coasts of two sources lie half a pixel apart.
const INLAND: [[f32; 2]; 2] = [[-0.3, 1.5], [2.0, 5.0]];
/// How much bluer than its other colours a pixel is that shows water: none, all, as a share, near a shore and far from it. Ice in shadow has
/// less.
const BLUE: [[f32; 2]; 2] = [[0.02, 0.10], [0.06, 0.18]];
/// By how much less blue soil and plants are near a shore where nothing of the water is mixed into them, and ice is not.
const BROWN: f32 = 0.28;
/// The least of a pixel's colours that snow and ice have: none, all.
const WHITE: [f32; 2] = [0.45, 0.65];

/// Linear red, green and blue, rows from the north, columns from 180 degrees west.
pub struct Picture {
    /// Row by row.
    pub pixels: Vec<[f32; 3]>,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl Picture {
    /// Reads a JPEG or a PNG.
    ///
    /// # Errors
    /// An unreadable file, another kind of picture, another shape.
    pub fn open(path: &Path) -> Result<Self> {
        let name = path.display().to_string();
        let bytes = std::fs::read(path).map_err(|e| Error::io(&name, e, REMEDY))?;
        let ([width, height], texels) = if bytes.starts_with(b"\x89PNG") {
            png_texels(&name, &bytes)?
        } else {
            decode_jpeg(&name, &bytes, LONGEST, REMEDY)?
        };
        if width != 2 * height || height < 2 {
            return Err(Error::bad_data(name, format!("has {width} x {height} pixels"), REMEDY));
        }
        let linear: [f32; 256] = std::array::from_fn(|byte| linear(byte as f64 / 255.0) as f32);
        let pixels = texels.as_chunks().0.iter().map(|pixel: &[u8; 3]| pixel.map(|byte| linear[usize::from(byte)]));
        Ok(Self { pixels: pixels.collect(), width, height })
    }

    /// Degrees of a pixel.
    pub fn step_deg(&self) -> f64 {
        360.0 / self.width as f64
    }

    /// Continues the land's colour over all that is not land.
    pub fn fill_water(&mut self, land: &Land) {
        let weights = self.pixels.iter().zip(land.inland()).map(|(pixel, inland)| trust(*pixel, *inland)).collect();
        let level = Level { pixels: std::mem::take(&mut self.pixels), weights, width: self.width, height: self.height };
        self.pixels = level.filled().pixels;
    }

    /// Linear colour at a place in pixels from the centre of the first one, bicubic (Catmull-Rom): it keeps the picture's sharpness.
    pub fn at(&self, column: f64, row: f64) -> [f32; 3] {
        let (i, j) = (column.floor(), row.floor());
        let (along, down) = (catmull_rom((column - i) as f32), catmull_rom((row - j) as f32));
        let mut sum = [0.0f32; 3];
        for (dj, weight) in down.into_iter().enumerate() {
            // Beyond a pole lies the other side of the same parallel.
            let row = j as i64 + dj as i64 - 1;
            let height = self.height as i64;
            let (row, turn) = match row {
                row if row < 0 => (-1 - row, self.width as i64 / 2),
                row if row >= height => (2 * height - 1 - row, self.width as i64 / 2),
                row => (row, 0),
            };
            for (di, along) in along.into_iter().enumerate() {
                let column = (i as i64 + di as i64 - 1 + turn).rem_euclid(self.width as i64);
                let pixel = self.pixels[row as usize * self.width + column as usize];
                sum.iter_mut().zip(pixel).for_each(|(sum, part)| *sum += weight * along * part);
            }
        }
        sum.map(|part| part.clamp(0.0, 1.0))
    }
}

/// Weights of four pixels at a place between the middle two.
fn catmull_rom(t: f32) -> [f32; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [-0.5 * t + t2 - 0.5 * t3, 1.0 - 2.5 * t2 + 1.5 * t3, 0.5 * t + 2.0 * t2 - 1.5 * t3, 0.5 * (t3 - t2)]
}

/// How much a pixel is to be trusted to show land alone, 0 to 1, so many pixels inland.
fn trust(pixel: [f32; 3], inland: f32) -> f32 {
    let [r, g, b] = pixel.map(|part| display(part) as f32);
    let excess = (b - r.max(g)) / r.max(g).max(b).max(0.04);
    let brown = BROWN * (1.0 - smooth(WHITE, r.min(g).min(b)));
    let near = smooth(INLAND[0], inland) * (1.0 - smooth(BLUE[0], excess + brown));
    let far = smooth(INLAND[1], inland) * (1.0 - smooth(BLUE[1], excess));
    near.max(far)
}

fn smooth([none, all]: [f32; 2], value: f32) -> f32 {
    let t = ((value - none) / (all - none)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Linear light of an sRGB value, both 0 to 1 (IEC 61966-2-1).
pub fn linear(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// The sRGB value of linear light.
pub fn display(light: f32) -> f64 {
    let light = f64::from(light);
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// One level of the pyramid.
struct Level {
    pixels: Vec<[f32; 3]>,
    weights: Vec<f32>,
    width: usize,
    height: usize,
}

impl Level {
    /// The four pixels below a pixel of the level above; the last column and row may have fewer.
    fn below(&self, column: usize, row: usize) -> impl Iterator<Item = usize> {
        let (width, height) = (self.width, self.height);
        let places = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| (2 * column + i, 2 * row + j));
        places.into_iter().filter(move |(i, j)| *i < width && *j < height).map(move |(i, j)| j * width + i)
    }

    /// Means of four pixels each by their weights; what one of them knows of four counts as known.
    fn above(&self) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        let mut above = Self { pixels: Vec::new(), weights: Vec::new(), width, height };
        for (column, row) in (0..height).flat_map(|row| (0..width).map(move |column| (column, row))) {
            let (mut sum, mut weight) = ([0.0; 3], 0.0);
            for at in self.below(column, row) {
                weight += self.weights[at];
                sum.iter_mut().zip(self.pixels[at]).for_each(|(sum, part)| *sum += self.weights[at] * part);
            }
            above.pixels.push(if weight > 0.0 { sum.map(|part| part / weight) } else { sum });
            above.weights.push(weight.min(1.0));
        }
        above
    }

    /// Each pixel as far as it is known, and for the rest what the level above says, bilinearly.
    fn filled(mut self) -> Self {
        if self.width <= 2 && self.height <= 2 {
            return self;
        }
        let above = self.above().filled();
        for row in 0..self.height {
            let y = (row as f32 + 0.5) / 2.0 - 0.5;
            let (j, fy) = (y.floor(), y - y.floor());
            let rows = [j, j + 1.0].map(|j| (j.max(0.0) as usize).min(above.height - 1));
            for column in 0..self.width {
                let at = row * self.width + column;
                let known = self.weights[at];
                if known >= 1.0 {
                    continue;
                }
                let x = (column as f32 + 0.5) / 2.0 - 0.5;
                let (i, fx) = (x.floor(), x - x.floor());
                let columns = [i, i + 1.0].map(|i| (i as i64).rem_euclid(above.width as i64) as usize);
                let pixel = |row: usize, column: usize| above.pixels[row * above.width + column];
                for part in 0..3 {
                    let along = |row| pixel(row, columns[0])[part] * (1.0 - fx) + pixel(row, columns[1])[part] * fx;
                    let around = along(rows[0]) * (1.0 - fy) + along(rows[1]) * fy;
                    self.pixels[at][part] = self.pixels[at][part] * known + around * (1.0 - known);
                }
            }
        }
        self
    }
}

/// Width and height, and red, green and blue of each pixel of a PNG.
fn png_texels(name: &str, bytes: &[u8]) -> Result<([usize; 2], Vec<u8>)> {
    let unreadable = |e: png::DecodingError| Error::bad_data(name, format!("cannot be read as PNG ({e})"), REMEDY);
    let limits = png::Limits { bytes: 4 * LONGEST * LONGEST / 2 };
    let mut reader =
        png::Decoder::new_with_limits(std::io::Cursor::new(bytes), limits).read_info().map_err(unreadable)?;
    let info = reader.info();
    let (size, kind) = ([info.width as usize, info.height as usize], (info.bit_depth, info.color_type));
    let channels = match kind {
        (png::BitDepth::Eight, png::ColorType::Rgb) => 3,
        (png::BitDepth::Eight, png::ColorType::Rgba) => 4,
        _ => return Err(Error::bad_data(name, format!("has {:?} bits of {:?}", kind.0, kind.1), REMEDY)),
    };
    if size[0] > LONGEST || size[1] > LONGEST {
        return Err(Error::bad_data(name, format!("has {} x {} pixels", size[0], size[1]), REMEDY));
    }
    let mut texels = vec![0; size[0] * size[1] * channels];
    reader.next_frame(&mut texels).map_err(unreadable)?;
    Ok((size, texels.chunks_exact(channels).flat_map(|texel| [texel[0], texel[1], texel[2]]).collect()))
}
