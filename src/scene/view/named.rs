//! The named views: from orbit to the deck, and the sea in four winds. Fixed times, so that each looks the same for everyone.

use crate::model::sun;
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

/// A view with a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// Short id, for files and links.
    pub id: &'static str,
    /// Name of its button among the panel's widgets.
    pub widget: &'static str,
    /// Title for people.
    pub title: &'static str,
    /// The state as a fragment.
    pub fragment: &'static str,
}

/// All named views, from the highest to the lowest.
pub const VIEWS: [View; 8] = [
    View {
        id: "globe",
        widget: "viewGlobe",
        title: "30,000 km",
        fragment: "view=16,-25,30000000&time=2026-11-20T14:20:00Z",
    },
    View {
        id: "ocean",
        widget: "viewOcean",
        title: "3,000 km",
        fragment: "view=26,-21,3000000,180,18&clouds=0.35&time=2026-11-20T13:00:00Z",
    },
    View {
        id: "islands",
        widget: "viewIslands",
        title: "30 km",
        fragment: "view=29.25,-13.78,30000,184,56&clouds=0.3&time=2026-11-26T12:30:00Z",
    },
    View {
        id: "coast",
        widget: "viewCoast",
        title: "coast, 560 m",
        fragment: "view=28.8545,-13.792,560,253,71&clouds=0.2&time=2026-11-20T15:00:00Z",
    },
    View {
        id: "calm",
        widget: "viewCalm",
        title: "calm",
        fragment: "view=35.6812,-14.25,2,206,84&ride=1&bft=1&clouds=0.3&time=2026-11-20T12:00:00Z",
    },
    View {
        id: "breeze",
        widget: "viewBreeze",
        title: "breeze",
        fragment: "view=35.6812,-14.25,2,206,84&ride=1&bft=4&clouds=0.4&time=2026-11-20T12:00:00Z",
    },
    View {
        id: "gale",
        widget: "viewGale",
        title: "gale",
        fragment: "view=35.6812,-14.25,2,262,83&ride=1&bft=8&clouds=0.5&time=2026-11-20T12:00:00Z",
    },
    View {
        id: "hurricane",
        widget: "viewHurricane",
        title: "hurricane",
        fragment: "view=35.6812,-14.25,3,262,82&ride=1&bft=12&clouds=0.9&time=2026-11-20T12:00:00Z",
    },
];

/// What opens where no link says anything: the default view, turned to the side of the earth that has day at a UTC instant in
/// seconds since 1970.
pub fn opening(unix_seconds: f64) -> ViewState {
    let (_, noon_lon) = sun::subsolar_point(unix_seconds);
    let default = ViewState::default();
    ViewState { camera: Camera { lon: noon_lon + 0.5, ..default.camera }.normalized(), ..default }
}

impl View {
    /// The state that the view stands for.
    pub fn state(&self) -> ViewState {
        ViewState::parse_fragment(self.fragment, None).0
    }
}
