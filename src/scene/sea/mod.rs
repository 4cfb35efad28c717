//! The sea of the settings: its tables, its foam, and its surface at a place.

pub mod foam;
pub mod foam_history;
pub mod ride;
pub mod seas;
pub mod shelter;
pub mod shores;
pub mod surface_sample;
pub mod tables;
pub mod thresholds;

pub use seas::Seas;
