//! A view as a link's fragment and back.

pub mod fragment;
pub mod maplibre;
pub mod number;
pub mod pair;
pub mod values;
