//! Floor 2: what to draw, as plain data: the settings, the view, the sea, their form as a link, and all of it as a frame.
//!
//! Nothing here knows a graphics device or a widget. Angles are radians except where a name ends in `_deg`.
//!
//! | room | what |
//! |---|---|
//! | [`view`] | where the eye is and how it moves, and which map tiles it sees |
//! | [`sea`] | the sea of the settings: its tables, foam, surface at a place |
//! | [`link`] | a view as a link's fragment and back |
//! | [`towns`] | where the ground about an eye is built up |
//! | [`frame`] | everything that one picture is drawn from, narrowed to the GPU's numbers |

pub mod frame;
pub mod layers;
pub mod link;
pub mod measured_place;
pub mod sea;
pub mod settings;
pub mod time;
pub mod towns;
pub mod view;
