//! Floor 6: the native command line; one file per command.

pub mod render;
pub mod serve;
