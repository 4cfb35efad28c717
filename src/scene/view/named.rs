//! The named views: from orbit to the deck and under it, seas and hours. Fixed times, so that each looks the same for everyone.

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

/// All named views, from the highest to the lowest: heights first, then seas, then hours and depths.
pub const VIEWS: [View; 15] = [
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
        id: "mediterranean",
        widget: "viewMediterranean",
        title: "the Mediterranean, 400 km",
        fragment: "view=34,18,400000,0,55&clouds=0.2&time=2026-08-02T14:00:00Z",
    },
    View {
        id: "islands",
        widget: "viewIslands",
        title: "30 km",
        fragment: "view=29.25,-13.78,30000,184,56&time=2026-11-26T12:30:00Z",
    },
    View {
        id: "lagoon",
        widget: "viewLagoon",
        title: "a lagoon, 700 m",
        fragment: "view=24.34,-76.59,700,110,70&wind=7@60&clouds=0.3&time=2026-06-21T16:00:00Z",
    },
    View {
        id: "coast",
        widget: "viewCoast",
        title: "coast, 560 m",
        fragment: "view=28.8545,-13.792,560,253,71&clouds=0.2&time=2026-11-20T15:00:00Z",
    },
    View {
        id: "surf",
        widget: "viewSurf",
        title: "surf, 12 m",
        fragment: "view=52.372,4.5223,12,330,80&wind=9@300&clouds=0.35&time=2026-07-20T17:30:00Z",
    },
    View {
        id: "bridge",
        widget: "viewBridge",
        title: "a storm from the bridge, 7 m",
        fragment: "view=-52,60,7,265,86&ride=1&bft=10&clouds=0.95&time=2026-12-21T03:00:31Z",
    },
    View {
        id: "calm",
        widget: "viewCalm",
        title: "calm",
        fragment: "view=35.6812,-14.25,2,206,84&ride=1&bft=1&clouds=0.2&time=2026-11-20T12:00:00Z",
    },
    View {
        id: "breeze",
        widget: "viewBreeze",
        title: "breeze",
        fragment: "view=35.6812,-14.25,2,206,84&ride=1&bft=4&clouds=0.2&time=2026-11-20T12:00:00Z",
    },
    View {
        id: "gale",
        widget: "viewGale",
        title: "gale",
        fragment: "view=35.6812,-14.25,2,262,83&ride=1&bft=8&clouds=0.25&time=2026-11-26T12:00:00Z",
    },
    View {
        id: "hurricane",
        widget: "viewHurricane",
        title: "hurricane",
        fragment: "view=40,-50,9,60,78&bft=12&clouds=1&time=2026-02-21T15:00:00Z",
    },
    View {
        id: "sunset",
        widget: "viewSunset",
        title: "sunset",
        fragment: "view=-12,-30,4,292,89&bft=4&clouds=0.35&time=2026-06-11T19:24:00Z",
    },
    View {
        id: "moonlit",
        widget: "viewMoonlit",
        title: "moonlight",
        fragment: "view=18,-62.5,4,72,92&bft=3&haze=0.04&clouds=0.25&time=2026-11-24T23:10:00Z",
    },
    View {
        id: "underwater",
        widget: "viewUnderwater",
        title: "under water",
        fragment: "view=24.31,-76.561,-1.6,200,86&bft=3&clouds=0.3&time=2026-06-21T16:30:00Z",
    },
];

/// How far east of the noon meridian the opening view stands, degrees: a strip of evening shows, with lights.
const OPENING_EAST_DEG: f64 = 32.0;
/// And from where it looks, degrees and metres.
const OPENING_LAT_DEG: f64 = 14.0;
const OPENING_ALTITUDE_M: f64 = 1.7e7;

/// What opens where no link says anything: the earth by day at a UTC instant in seconds since 1970, filling the picture.
pub fn opening(unix_seconds: f64) -> ViewState {
    let (_, noon_lon) = sun::subsolar_point(unix_seconds);
    let lon_deg = noon_lon.to_degrees() + OPENING_EAST_DEG;
    let camera = Camera::from_degrees(OPENING_LAT_DEG, lon_deg, OPENING_ALTITUDE_M, 0.0, 0.0).normalized();
    ViewState { camera, ..ViewState::default() }
}

impl View {
    /// The state that the view stands for.
    pub fn state(&self) -> ViewState {
        ViewState::parse_fragment(self.fragment, None).0
    }
}
