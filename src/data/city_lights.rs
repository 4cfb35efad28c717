//! The lights of towns and ships' fires by night, from the bundled picture of them (`scripts/make-lights.sh`; credits: `NOTICE`).

/// Columns and rows of the picture, a cylindrical one of the whole globe.
pub const TEXELS: [u32; 2] = [2048, 1024];
/// Row by row from the north-west: texels from the last one that is lit to the next (base 128, little-endian), and its value.
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
    let [columns, rows] = TEXELS;
    let mut bytes = PICTURE.iter().copied();
    let mut next = 0;
    std::iter::from_fn(move || {
        let mut gap = 0;
        for shift in (0..).step_by(7) {
            let byte = bytes.next()?;
            gap |= u32::from(byte & 127) << shift;
            if byte < 128 {
                break;
            }
        }
        let value = f64::from(bytes.next()?) / 255.0;
        let texel = next + gap;
        next = texel + 1;
        let [x, y] = [texel % columns, texel / columns].map(|i| f64::from(i) + 0.5);
        Some(CityLight {
            lat: (0.5 - y / f64::from(rows)) * std::f64::consts::PI,
            lon: (x / f64::from(columns) - 0.5) * std::f64::consts::TAU,
            radiance: value * value,
        })
    })
}
