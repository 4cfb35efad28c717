//! What the GPU computes, pass by pass and shader by shader, without a picture.

mod accesses;
mod air;
mod bisection;
mod bloom;
mod ensemble;
mod exact;
mod far_sea;
mod fft;
mod foam_coverage;
mod foam_history;
mod foam_lace;
mod foam_map;
mod glitter;
mod gusts;
mod kernel;
mod pool;
mod precision;
mod shaders;
mod slope_moments;
mod sparkle;
mod spray;
mod surface_sample;
mod translucence;
mod water;
mod wave_anchors;
mod wave_domain;
