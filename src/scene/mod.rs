//! Floor 2: what to draw, as plain data: the settings, the camera, the time, and their form as a link.
//!
//! Nothing here knows a graphics device or a widget. Angles are radians except where a name ends in `_deg`.

pub mod bisection;
pub mod camera;
pub mod drawn_tiles;
pub mod flight;
pub mod foam;
pub mod foam_history;
pub mod fragment;
pub mod frame;
pub mod inertia;
pub mod layers;
pub mod maplibre;
pub mod moved_water;
pub mod navigate;
pub mod number;
pub mod pair;
pub mod ride;
pub mod sea;
pub mod settings;
pub mod surface_sample;
pub mod tiles;
pub mod time;
pub mod values;
pub mod view_state;
pub mod views;
pub mod wave_domain;
pub mod wave_nodes;
