//! Where the eye is, how it moves, and which map tiles it sees.

pub mod camera;
pub mod flight;
pub mod inertia;
pub mod map_tiles;
pub mod named;
pub mod navigate;
mod quadtree;
pub mod state;
