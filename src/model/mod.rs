//! Floor 0: the science, in f64 and SI units, with no GPU, no files and no network. It doubles as the reference that the
//! shaders are tested against.
//!
//! Everything that feeds the waves or the numbers of a frame takes its transcendental functions from `libm`, never from the platform, so that
//! a link gives the same sea and the same picture bit for bit natively and in WebAssembly.

pub mod cascade;
pub mod clouds;
pub mod cuboid;
pub mod daylight;
pub mod dispersion;
pub mod drawn_patches;
pub mod earth;
pub mod fft;
pub mod foam;
pub mod geodesic;
pub mod highest;
pub mod lace;
pub mod lakes;
pub mod lift;
pub mod modes;
pub mod moon;
pub mod moved_water;
pub mod noise;
pub mod optics;
pub mod overcast;
pub mod perlin;
pub mod quadrature;
pub mod ragged_shore;
pub mod reefs;
pub mod relief;
pub mod rough_water;
pub mod rugged;
pub mod sand;
pub mod sea;
pub mod sea_bed;
pub mod sea_spectrum;
pub mod sea_state;
pub mod sea_tables;
pub mod sheltered_sea;
pub mod shore_waves;
pub mod spectrum;
pub mod spray;
pub mod spreading;
pub mod sun;
pub mod surf;
pub mod surface;
pub mod swash;
pub mod towers;
pub mod wave_data;
pub mod wave_domain;
pub mod wave_trains;
pub mod waves;

/// Standard gravity, m/s² (CGPM 1901). The sea uses this one value everywhere on the globe.
pub const GRAVITY: f64 = 9.80665;
