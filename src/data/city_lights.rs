//! The lights of towns and ships' fires by night, from the bundled picture of them (`scripts/make-lights.sh`; credits: `NOTICE`).

use super::sparse::cells;

/// Columns and rows of the picture, a cylindrical one of the whole globe.
pub const TEXELS: [u32; 2] = [2048, 1024];
/// Row by row from the north-west, as of [`cells`].
const PICTURE: &[u8] = include_bytes!("city_lights.bin");

/// The light of a texel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CityLight {
    /// Geodetic latitude of the texel's middle, radians.
    pub lat: f64,
    /// Its longitude, radians.
    pub lon: f64,
    /// Mean radiance, 1 for the brightest cities: the square of the picture's value, which was made for displays.
    pub radiance: f64,
}

/// All of them, from north to south.
pub fn city_lights() -> impl Iterator<Item = CityLight> {
    let [columns, rows] = TEXELS.map(u64::from);
    cells(PICTURE).map(move |(texel, value)| {
        let value = f64::from(value) / 255.0;
        let [x, y] = [texel % columns, texel / columns].map(|i| i as f64 + 0.5);
        CityLight {
            lat: (0.5 - y / rows as f64) * std::f64::consts::PI,
            lon: (x / columns as f64 - 0.5) * std::f64::consts::TAU,
            radiance: value * value,
        }
    })
}
