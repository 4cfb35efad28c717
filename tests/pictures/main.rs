//! Whole pictures, the commands that make them, and the window.

mod any_view;
mod bench;
mod clouds;
mod edges;
mod flight;
mod geoid;
mod hidden_window;
mod horizon;
mod imagery;
mod light;
mod luminance;
mod meshes;
mod night;
mod own_world;
mod relief;
mod ride;
mod sheets;
mod shore;
mod shore_settings;
mod sweep;
mod tone;
mod under_water;
mod views;
mod water_colour;
mod window;
mod world_in_view;
