//! What of the sea shows in a picture.

use super::kind::Kind;
use crate::scene::frame::Frame;

/// What shaders of the sea know of a picture when they are compiled: its kind, and what of the sea shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Look {
    /// The picture's.
    pub kind: Kind,
    /// Some of the wave patches show.
    pub waves: bool,
    /// The far sea's noise shows.
    pub noise: bool,
    /// The foam's map or its lace show.
    pub foam: bool,
    /// Shores may be so near that their surf shows.
    pub surf: bool,
    /// Places may be seen that have coral reefs.
    pub reefs: bool,
    /// Storms have drawn foam out along the wind.
    pub storm: bool,
    /// It is a lake's surface, not the sea's.
    pub lake: bool,
}

impl Look {
    /// Every one.
    pub fn all() -> impl Iterator<Item = Self> {
        let lakes = Kind::all().filter(|kind| kind.meshes_lakes() && !kind.spray).map(Self::of_lake);
        let seas = Kind::all().flat_map(|kind| {
            let looks = if kind.shows_surf() { 16 } else { 8 };
            (0..looks).map(move |bits: u8| {
                let [waves, noise, foam, surf] = [1, 2, 4, 8].map(|bit| bits & bit != 0);
                // What there are reefs and storms for is written once: either way of both is among these.
                Self { kind, waves, noise, foam, surf, reefs: kind.clouds, storm: kind.spray, lake: false }
            })
        });
        seas.chain(lakes)
    }

    /// That of a frame of some kind, with shores nearby or without.
    pub fn of(frame: &Frame, kind: Kind, shows_surf: bool) -> Self {
        let surf = shows_surf && kind.shows_surf();
        Self {
            kind,
            waves: frame.has_waves(),
            noise: frame.has_noise(),
            foam: frame.has_foam(),
            surf,
            reefs: frame.has_reefs(),
            storm: frame.has_streaks(),
            lake: false,
        }
    }

    /// That of a lake with waves, over which no spray stands: that of the sea is at the sea.
    pub fn of_lake(kind: Kind) -> Self {
        let kind = Kind { spray: false, ..kind };
        Self { kind, waves: true, noise: false, foam: true, surf: false, reefs: true, storm: true, lake: true }
    }

    /// What shaders of the sea's mesh are told.
    pub fn definitions(self) -> String {
        let Self { kind, waves, noise, surf, reefs, storm, lake, .. } = self;
        let shown =
            [("WAVES", waves), ("NOISE", noise), ("SURF", surf), ("REEFS", reefs), ("STORM", storm), ("LAKE", lake)];
        kind.definitions() + &shown.map(|(name, value)| format!("const {name}: bool = {value};\n")).concat()
    }
}
