//! Whole pictures, the commands that make them, and the window.

mod any_view;
mod beach;
mod bench;
mod clouds;
mod clouds_from_above;
mod edges;
mod fetch;
mod flight;
mod geoid;
mod hidden_window;
mod horizon;
mod imagery;
mod light;
mod luminance;
mod meshes;
mod mirrored_land;
mod night;
mod own_world;
mod plane_beach;
mod reefs;
mod relief;
mod ride;
mod rivers;
mod rollers;
mod seams_of_a_beach;
mod sheets;
mod shore;
mod shore_settings;
mod space;
mod spindrift;
mod surf_lines;
mod swash;
mod sweep;
mod tone;
mod towns;
mod under_water;
mod views;
mod wall;
mod water_colour;
mod waterline;
mod waves_on_a_beach;
mod window;
mod world_in_view;

#[path = "../shared/battjes_janssen.rs"]
mod battjes_janssen;
#[path = "../data/small_world.rs"]
#[allow(dead_code, reason = "one world of several is used here")]
mod small_world;
