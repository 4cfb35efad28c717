//! The clock of the machine, and the time of the scene that it drives.

use crate::scene::time::{FIRST_S, LAST_S, SceneTime};
use crate::scene::view::state::ViewState;

/// UTC seconds since 1970 by the machine's clock.
#[cfg(not(target_arch = "wasm32"))]
pub fn unix_now_s() -> f64 {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    now.map_or_else(|before| -before.duration().as_secs_f64(), |since| since.as_secs_f64())
}

/// UTC seconds since 1970 by the browser's clock.
#[cfg(target_arch = "wasm32")]
pub fn unix_now_s() -> f64 {
    js_sys::Date::now() / 1000.0
}

/// Moves the scene's time on by some seconds of clock and returns it, UTC seconds since 1970.
///
/// The machine's clock is followed only at its own rate; at any other the scene goes its own way from now on.
pub fn advance(state: &mut ViewState, seconds: f64, now_s: f64) -> f64 {
    state.time = match state.time {
        SceneTime::Now if state.rate == 1.0 => SceneTime::Now,
        SceneTime::Now => SceneTime::At(now_s),
        SceneTime::At(at) => SceneTime::At((at + seconds * state.rate).clamp(FIRST_S, LAST_S)),
    };
    state.time.unix_seconds(now_s)
}
