//! The world's archives, the links, the eye, and the commands that draw nothing.

mod bake;
mod bake_coast;
mod camera;
mod cloud_area;
mod coast;
mod exposure;
mod geoid;
mod highest;
mod hostile_coast;
mod hostile_data;
mod imagery;
mod lakes;
mod map_tiles;
mod own_files;
mod own_world;
mod relief;
mod rivers;
mod sample;
mod serve;
mod small_world;
mod towns;
mod url;
mod url_any;
