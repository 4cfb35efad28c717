//! The science on its own: nothing here opens a file of the world or asks for a device.

#[path = "../shared/battjes_janssen.rs"]
mod battjes_janssen;
mod beach;
mod clouds;
mod dispersion;
mod ensemble;
mod floors;
mod foam;
mod geodesy;
mod lakes;
mod mistakes;
mod mistakes_surface;
mod modes;
mod moon;
mod noise;
mod optics;
mod oracle_sea;
mod reefs;
mod rough_water;
mod same_sea;
mod sea_bed;
mod sea_state;
mod seas;
mod sheltered_sea;
mod shore_waves;
mod spectra_oracles;
mod spectrum;
mod spray;
mod stalls;
#[path = "../shared/summed.rs"]
mod summed;
mod sun;
mod surf;
mod swash;
mod towers;
mod valleys;
mod wave_trains;
mod waves;
