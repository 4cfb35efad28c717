//! What each stage of a frame costs on the device itself, by the device's own clock.

use super::{STEP_S, frame_ms, median};
use crate::error::Result;
use crate::renderer::Renderer;
use crate::scene::frame::Frame;

/// Stages of a view's frame in order, with their milliseconds.
pub type Times = Vec<(&'static str, f64)>;

/// The times of a picture whose time goes on, medians of `frames` frames; empty where the device's clock cannot be read.
///
/// # Errors
/// [`crate::error::Error::Gpu`] when the device is lost.
pub fn measure(renderer: &mut Renderer, frame: &mut Frame, target: &wgpu::TextureView, frames: u16) -> Result<Times> {
    renderer.measure_stages(true);
    let mut rounds = Vec::new();
    for _ in 0..frames {
        frame.unix_seconds += STEP_S;
        frame_ms(renderer, frame, target)?;
        rounds.push(renderer.stage_times()?);
    }
    renderer.measure_stages(false);
    let of_stage = |name: &'static str| {
        let times: Vec<f64> =
            rounds.iter().flatten().filter(|(stage, _)| *stage == name).filter_map(|(_, ms)| *ms).collect();
        (!times.is_empty()).then(|| (name, median(times)))
    };
    Ok(rounds[0].iter().filter_map(|(name, _)| of_stage(name)).collect())
}

/// A table of the views' stages, a row each.
pub fn table(views: &[(&str, Times)]) -> String {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in views.iter().flat_map(|(_, times)| times) {
        if !names.contains(name) {
            names.push(name);
        }
    }
    if names.is_empty() {
        return "stage ms: not measured, this device has no timestamps between commands\n".into();
    }
    let head: String = names.iter().map(|name| format!(" {name:>12}")).collect();
    let row = |(view, times): &(&str, Times)| {
        let time = |name| times.iter().find(|(stage, _)| *stage == name).map(|(_, ms)| *ms);
        let cells: String = names
            .iter()
            .map(|name| time(*name).map_or_else(|| format!(" {:>12}", "-"), |ms| format!(" {ms:>12.3}")))
            .collect();
        let whole: f64 = times.iter().map(|(_, ms)| ms).sum();
        format!("{view:<12}{cells} {whole:>12.3}\n")
    };
    format!("{:<12}{head} {:>12}\n{}", "stage ms", "whole", views.iter().map(row).collect::<String>())
}

/// The record of some views' stages.
pub fn json(views: &[(&str, Times)]) -> serde_json::Value {
    let of_view = |(view, times): &(&str, Times)| {
        let times: serde_json::Map<_, _> = times.iter().map(|(name, ms)| ((*name).into(), (*ms).into())).collect();
        serde_json::json!({ "view": view, "ms": times })
    };
    views.iter().map(of_view).collect()
}
