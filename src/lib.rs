//! A living ocean on the whole WGS84 globe: one core for the browser, a window, and pictures without any window.
//!
//! The crate is a house of floors; a file uses lower floors only (a test keeps this true). See `ARCHITECTURE.md`.
//!
//! | floor | module | what |
//! |---|---|---|
//! | 0 | [`model`] | science in f64 and SI units: earth, sun, waves, light; also the reference of the shaders |
//! | 1 | [`data`] | foreign bytes become typed grids |
//! | 2 | [`scene`] | what to draw, as plain data |
//! | 3 | [`gpu`] | how to speak wgpu |
//! | 4 | [`pass`] | one file per pass |
//! | 5 | [`renderer`] | owns the passes; one frame, readable top to bottom |
//! | 6 | `app`, `panel`, `web`, `cli` | the window, the page, the command line |

pub mod app;
pub mod bibliography;
#[cfg(not(target_arch = "wasm32"))]
pub mod cli;
pub mod data;
pub mod error;
pub mod gpu;
pub mod model;
pub mod panel;
pub mod pass;
pub mod renderer;
pub mod scene;
#[cfg(target_arch = "wasm32")]
pub mod web;

pub use error::{Error, Result};
