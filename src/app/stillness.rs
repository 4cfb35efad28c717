//! For how long a picture stays as it is while time runs: from orbit nothing visibly moves, and an idle page costs nothing.

use crate::model::dispersion;
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// Speed of the terminator at the equator, m/s.
const TERMINATOR_MPS: f64 = 465.0;
/// How fast stars pass the eye of one over the ground, rad/s; from so high on they are seen by day, m.
const STARS: [f64; 2] = [7.292e-5, 20_000.0];
/// The sun's light itself changes by less than a grey level in this time, seconds: in twilight, where it changes most, by a factor of e
/// in some 300 s, which is 1 in 300.
const LIGHT_S: f64 = 1.0;
/// Shares of a pixel that the terminator (or stars) and the waves may move unseen: the first has no edge, crests have contrast.
const UNSEEN: [f64; 2] = [0.5, 0.1];
/// The picture moves, rather than changing now and then, where it must be drawn again within this time, seconds of clock.
pub const SHORTEST_S: f64 = 1.0 / 30.0;

/// Scene seconds in which nothing moves visibly for an eye with `rows` of pixels over a sea whose longest wave is `longest_wave_m`.
pub fn still_s(camera: &Camera, rows: f64, longest_wave_m: f64) -> f64 {
    // No water is nearer than the eye's height.
    let pixel = 2.0 * (FIELD_OF_VIEW_Y / 2.0).tan() / rows.max(1.0);
    let pixel_m = camera.altitude_m.max(0.0) * pixel;
    let light_s = (UNSEEN[0] * pixel_m / TERMINATOR_MPS).max(LIGHT_S);
    let stars_s = if camera.altitude_m > STARS[1] { UNSEEN[0] * pixel / STARS[0] } else { f64::INFINITY };
    // Waves of less than two pixels are not seen one by one.
    let waves_s = if longest_wave_m < 2.0 * pixel_m {
        f64::INFINITY
    } else {
        let k = std::f64::consts::TAU / longest_wave_m;
        UNSEEN[1] * pixel_m / (dispersion::omega_deep(k) / k)
    };
    light_s.min(stars_s).min(waves_s)
}

/// The instant whose picture serves an instant, where nothing moves for `still_s`: the last multiple of it.
pub fn held(unix_seconds: f64, still_s: f64) -> f64 {
    (unix_seconds / still_s).floor() * still_s
}

#[cfg(test)]
mod tests {
    use super::*;

    fn from(altitude_m: f64) -> f64 {
        still_s(&Camera { altitude_m, ..Camera::default() }, 720.0, 300.0)
    }

    #[test]
    fn the_deck_moves_and_orbit_does_not() {
        assert!(from(2.0) < SHORTEST_S && from(560.0) < SHORTEST_S);
        // Some 100 m to a pixel: waves of 300 m at 22 m/s move a tenth of it in half a second.
        assert!((0.2..1.0).contains(&from(100_000.0)), "{}", from(100_000.0));
        // Beyond, waves are less than a pixel; 30 km to a pixel would be half a minute of the terminator, but stars pass half a pixel in a
        // third of that.
        assert_eq!(from(400_000.0), LIGHT_S);
        assert!((5.0..15.0).contains(&from(30_000_000.0)), "{}", from(30_000_000.0));
    }

    #[test]
    fn an_instant_is_held_until_the_next_picture_is_due() {
        let still_s = 32.0;
        let now = 1.8e9 + 5.0;
        let kept = held(now, still_s);
        assert!(kept <= now && now - kept < still_s);
        assert_eq!(held(kept + still_s - 1e-3, still_s), kept);
        assert_eq!(held(kept + still_s + 1e-3, still_s), kept + still_s);
    }
}
