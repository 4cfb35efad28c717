//! The time of the scene: the clock's, or a given instant; ISO 8601 UTC at the user's edge.

use jiff::{Timestamp, civil, tz};

/// First instant that a scene can have: 1900-01-01T00:00:00Z, seconds since 1970.
pub const FIRST_S: f64 = -2_208_988_800.0;

/// Last instant that a scene can have: 2200-12-31T23:59:59Z, seconds since 1970.
pub const LAST_S: f64 = 7_289_654_399.0;

/// When the scene starts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum SceneTime {
    /// The clock of the machine.
    #[default]
    Now,
    /// UTC seconds since 1970-01-01, leap seconds not counted, [`FIRST_S`] to [`LAST_S`].
    At(f64),
}

impl SceneTime {
    /// The instant, given the clock's, both UTC seconds since 1970.
    pub fn unix_seconds(self, now_s: f64) -> f64 {
        match self {
            Self::Now => now_s,
            Self::At(seconds) => seconds,
        }
    }

    /// Reads `now` or an ISO 8601 instant; one without a zone is UTC. Years outside 1900 to 2200 are clamped.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        if text.eq_ignore_ascii_case("now") {
            return Some(Self::Now);
        }
        let seconds = |stamp: Timestamp| stamp.as_millisecond() as f64 / 1000.0;
        let utc = |local: civil::DateTime| tz::Offset::UTC.to_timestamp(local).ok();
        let stamp = text.parse::<Timestamp>().ok().or_else(|| utc(text.parse::<civil::DateTime>().ok()?))?;
        Some(Self::At(seconds(stamp).clamp(FIRST_S, LAST_S)))
    }
}

impl std::fmt::Display for SceneTime {
    /// `now`, or the instant to a millisecond, e.g. `2026-11-20T12:00:00Z`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Now => f.write_str("now"),
            Self::At(seconds) => {
                let milliseconds = (seconds.clamp(FIRST_S, LAST_S) * 1000.0).round() as i64;
                let stamp = Timestamp::from_millisecond(milliseconds).unwrap_or(Timestamp::UNIX_EPOCH);
                write!(f, "{stamp}")
            }
        }
    }
}
