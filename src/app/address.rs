//! Keeps the page's fragment in step with the view, and the view with the fragment.
//!
//! Continuous motion replaces the fragment at most every [`PAUSE_S`] seconds (Safari allows 100 changes in 30 s); a jump
//! makes an entry in the history. Time that merely runs does not count as a change.

use super::page::Page;
use crate::scene::time::SceneTime;
use crate::scene::view::state::ViewState;

/// Least time in seconds between two changes of the fragment.
pub const PAUSE_S: f64 = 0.3;

/// What was last written, and when.
#[derive(Debug, Default)]
pub struct Address {
    /// The state that was written, running time left out.
    written: Option<String>,
    written_s: f64,
}

impl Address {
    /// Reads the fragment if somebody else has changed it; `true` if the state is a new one.
    pub fn read(&mut self, page: &mut dyn Page, state: &mut ViewState) -> bool {
        let Some(fragment) = page.new_fragment() else { return false };
        for error in state.apply_fragment(&fragment, None) {
            log::warn!("link: {error}");
        }
        self.written = Some(lasting(state));
        true
    }

    /// Writes the state if it has changed. Returns the seconds after which to call again, if it must wait.
    pub fn write(&mut self, page: &mut dyn Page, state: &ViewState, now_s: f64) -> Option<f64> {
        let lasting = lasting(state);
        if self.written.as_ref() == Some(&lasting) {
            return None;
        }
        let wait_s = self.written_s + PAUSE_S - now_s;
        if self.written.is_some() && wait_s > 0.0 {
            return Some(wait_s);
        }
        // The first state is the one that the page came with, in its shortest form or not: leave it as it is.
        if self.written.replace(lasting).is_some() {
            page.set_fragment(&state.format_fragment(None), false);
            self.written_s = now_s;
        }
        None
    }

    /// Makes an entry in the history for the state that a jump leads to.
    pub fn push(&mut self, page: &mut dyn Page, from: &ViewState, to: &ViewState, now_s: f64) {
        if self.written.as_ref() != Some(&lasting(from)) {
            page.set_fragment(&from.format_fragment(None), false);
        }
        page.set_fragment(&to.format_fragment(None), true);
        self.written = Some(lasting(to));
        self.written_s = now_s;
    }
}

/// The state's text without the time where that runs by itself.
fn lasting(state: &ViewState) -> String {
    let runs = matches!(state.time, SceneTime::At(_)) && state.rate != 0.0;
    let time = if runs { SceneTime::At(0.0) } else { state.time };
    ViewState { time, ..state.clone() }.format_fragment(None)
}
