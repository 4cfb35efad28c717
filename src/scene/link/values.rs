//! The values of the pairs in a link that have parts or names.

use crate::scene::link::number::{clamped, decimal, decimal_deg, finite, whole, wrapped_deg};
use crate::scene::settings::{Foam, FoamRule, Mesh, Surf, Swell, Triangles, USUAL_WATER_DENSITY_PER_M, Water, Wind};
use crate::scene::view::camera::Camera;

/// Lowest altitude that a link can name, metres: the deepest trench.
pub const LOWEST_VIEW_M: f64 = -11_000.0;

/// Highest altitude that a link can name, metres.
pub const HIGHEST_VIEW_M: f64 = 4e7;

/// Reads `lat,lng,alt[,heading[,tilt]]`, degrees and metres.
pub fn parse_view(text: &str) -> Option<Camera> {
    let parts: Vec<&str> = text.split(',').collect();
    let (&[lat, lon, altitude], rest) = parts.split_first_chunk::<3>()?;
    let (heading, tilt) = match rest {
        [] => ("0", "0"),
        [heading] => (*heading, "0"),
        [heading, tilt] => (*heading, *tilt),
        _ => return None,
    };
    Some(Camera::from_degrees(
        clamped(lat, -90.0..=90.0)?,
        finite(lon)? % 360.0,
        clamped(altitude, LOWEST_VIEW_M..=HIGHEST_VIEW_M)?,
        wrapped_deg(heading)?,
        clamped(tilt, 0.0..=180.0)?,
    ))
}

/// Writes a camera with as many digits as its height over the resting sea needs: wrong by at most 1/1000 of it, or 1 cm. `rest_m` is the
/// resting sea's height over the ellipsoid at a place (radians), m, as it is in the text.
pub fn format_view(camera: &Camera, rest_m: impl Fn(f64, f64) -> f64) -> String {
    /// Length of a degree of latitude, metres, rounded up.
    const DEGREE_M: f64 = 111_700.0;
    let altitude_m = camera.altitude_m.clamp(LOWEST_VIEW_M, HIGHEST_VIEW_M);
    // A power of ten: rounding to it never changes which one it is, so writing what was read gives the same text.
    let step_m = 10f64.powf((unseen_m(altitude_m).log10() + 1e-9).floor());
    let decimals = (-step_m.log10()).round() as i32;
    let unseen_deg = unseen_m(decimal(altitude_m, decimals).parse().unwrap_or(altitude_m)) / DEGREE_M;
    let digits = (-(2.0 * unseen_deg).log10()).ceil().max(0.0) as i32;
    let lat = decimal(camera.lat.to_degrees(), digits);
    let lon = decimal_deg(camera.lon.to_degrees(), -180.0, digits);
    let read = |text: &str, exact: f64| text.parse::<f64>().map_or(exact, f64::to_radians);
    let rest_m = rest_m(read(&lat, camera.lat), read(&lon, camera.lon));
    let altitude = decimal((altitude_m + rest_m).clamp(LOWEST_VIEW_M, HIGHEST_VIEW_M), decimals);
    let heading = decimal_deg(camera.heading.to_degrees(), 0.0, 2);
    let tilt = decimal(camera.tilt.to_degrees(), 2);
    match (heading.as_str(), tilt.as_str()) {
        ("0", "0") => format!("{lat},{lon},{altitude}"),
        (_, "0") => format!("{lat},{lon},{altitude},{heading}"),
        _ => format!("{lat},{lon},{altitude},{heading},{tilt}"),
    }
}

/// A distance in metres that is not seen from a height.
fn unseen_m(altitude_m: f64) -> f64 {
    (altitude_m.abs() * 1e-3).max(0.01)
}

/// Reads `m/s@degrees FROM`; without `@` the direction is the default's.
pub fn parse_wind(text: &str) -> Option<Wind> {
    let (speed, from) = text.split_once('@').map_or((text, None), |(speed, from)| (speed, Some(from)));
    let from_deg = from.map_or(Some(Wind::default().from_deg), wrapped_deg)?;
    Some(Wind { speed_mps: clamped(speed, 0.0..=60.0)?, from_deg })
}

/// Writes a wind, e.g. `13.9@240`.
pub fn format_wind(wind: Wind) -> String {
    format!("{}@{}", decimal(wind.speed_mps, 3), decimal_deg(wind.from_deg, 0.0, 2))
}

/// Reads `height,period,from`.
pub fn parse_swell(text: &str) -> Option<Swell> {
    let parts: Vec<&str> = text.split(',').collect();
    let &[height, period, from] = parts.as_slice() else { return None };
    Some(Swell {
        height_m: clamped(height, 0.0..=20.0)?,
        period_s: clamped(period, 3.0..=30.0)?,
        from_deg: wrapped_deg(from)?,
    })
}

/// Writes a swell, e.g. `2.5,14,310`.
pub fn format_swell(swell: Swell) -> String {
    let from = decimal_deg(swell.from_deg, 0.0, 2);
    format!("{},{},{from}", decimal(swell.height_m, 3), decimal(swell.period_s, 3))
}

/// The foam rule's name in links; folding has none, as the default.
const BY_HEIGHT: &str = "height";

/// Reads `amount[,lifetime[,height]]`.
pub fn parse_foam(text: &str) -> Option<Foam> {
    let parts: Vec<&str> = text.split(',').collect();
    let default = Foam::default();
    let (lifetime_s, rule) = match parts[1..] {
        [] => (default.lifetime_s, default.rule),
        [lifetime] => (clamped(lifetime, 0.1..=60.0)?, default.rule),
        [lifetime, BY_HEIGHT] => (clamped(lifetime, 0.1..=60.0)?, FoamRule::Height),
        _ => return None,
    };
    Some(Foam { amount: clamped(parts[0], 0.0..=3.0)?, lifetime_s, rule })
}

/// Writes foam, e.g. `0.5,10`; defaults at the end are left out.
pub fn format_foam(foam: Foam) -> String {
    let [amount, lifetime] = [foam.amount, foam.lifetime_s].map(|number| decimal(number, 3));
    match foam.rule {
        FoamRule::Height => format!("{amount},{lifetime},{BY_HEIGHT}"),
        FoamRule::Folding if lifetime == decimal(Foam::default().lifetime_s, 3) => amount,
        FoamRule::Folding => format!("{amount},{lifetime}"),
    }
}

/// Reads `kind[,density]`, the density of the water's opacity per metre.
pub fn parse_water(text: &str) -> Option<(Water, f64)> {
    let (name, density) = text.split_once(',').map_or((text, None), |(name, density)| (name, Some(density)));
    let density = density.map_or(Some(USUAL_WATER_DENSITY_PER_M), |density| clamped(density, 0.1..=0.3))?;
    Some((named(&Water::ALL, name)?, density))
}

/// Writes water, e.g. `coastal,0.3`; the usual density is left out.
pub fn format_water(water: Water, density_per_m: f64) -> String {
    let (name, density) = (name_of(&Water::ALL, water), decimal(density_per_m, 3));
    if density == decimal(USUAL_WATER_DENSITY_PER_M, 3) { name } else { format!("{name},{density}") }
}

/// Reads `width[,slope]`.
pub fn parse_surf(text: &str) -> Option<Surf> {
    let (width, slope) = text.split_once(',').map_or((text, None), |(width, slope)| (width, Some(slope)));
    let beach_slope = slope.map_or(Some(Surf::default().beach_slope), |slope| clamped(slope, 0.01..=0.3))?;
    Some(Surf { width: clamped(width, 0.0..=3.0)?, beach_slope })
}

/// Writes surf, e.g. `0.5,0.1`; the usual slope is left out.
pub fn format_surf(surf: Surf) -> String {
    let [width, slope] = [surf.width, surf.beach_slope].map(|number| decimal(number, 3));
    if slope == decimal(Surf::default().beach_slope, 3) { width } else { format!("{width},{slope}") }
}

/// Reads `grid` or `bisect[,pixels[,budget]]`.
pub fn parse_mesh(text: &str) -> Option<(Mesh, Triangles)> {
    let parts: Vec<&str> = text.split(',').collect();
    let (mesh, default) = (named(&Mesh::ALL, parts[0])?, Triangles::default());
    let triangles = match parts[1..] {
        [] => default,
        _ if mesh == Mesh::Grid => return None,
        [pixels] => Triangles { pixels: clamped(pixels, 2.0..=64.0)?, ..default },
        [pixels, budget] => {
            Triangles { pixels: clamped(pixels, 2.0..=64.0)?, budget: whole(budget, 1e3..=1e6)? as u32 }
        }
        _ => return None,
    };
    Some((mesh, triangles))
}

/// Writes a mesh, e.g. `bisect,8`; defaults at the end are left out.
pub fn format_mesh(mesh: Mesh, triangles: Triangles) -> String {
    let name = name_of(&Mesh::ALL, mesh);
    let (pixels, default) = (decimal(triangles.pixels, 2), Triangles::default());
    if mesh == Mesh::Grid || (pixels == decimal(default.pixels, 2) && triangles.budget == default.budget) {
        name
    } else if triangles.budget == default.budget {
        format!("{name},{pixels}")
    } else {
        format!("{name},{pixels},{}", triangles.budget)
    }
}

/// The item of a list that has a name.
pub fn named<T: Copy>(all: &[(T, &str)], name: &str) -> Option<T> {
    all.iter().find(|(_, known)| *known == name.trim()).map(|&(item, _)| item)
}

/// The name of an item of a list.
pub fn name_of<T: PartialEq>(all: &[(T, &str)], item: T) -> String {
    all.iter().find(|(known, _)| *known == item).map_or_else(String::new, |(_, name)| (*name).into())
}

/// All names of a list, as a remedy for a name that is not among them.
pub fn names<T>(all: &[(T, &str)]) -> String {
    let names: Vec<&str> = all.iter().map(|&(_, name)| name).collect();
    format!("known are {}", names.join(", "))
}
