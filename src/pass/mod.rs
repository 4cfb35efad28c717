//! Floor 4: one file per pass; a pass owns its pipelines, textures and bind groups, and knows no other pass.

pub mod air_table;
pub mod backdrop;
pub mod bisect;
pub mod bloom;
pub mod city_lights;
pub mod cloud_map;
pub mod clouds;
pub mod due;
pub mod fft;
pub mod foam;
pub mod frame_group;
pub mod globe;
pub mod kind;
pub mod land;
pub mod ocean;
pub mod perlin;
pub mod points;
pub mod rough_table;
pub mod sky;
pub mod sky_table;
pub mod sky_view;
pub mod stars;
pub mod tonemap;
pub mod world_tiles;
