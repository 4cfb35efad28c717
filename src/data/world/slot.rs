//! One archive on its way to being open.

use super::{ATTEMPTS, wait_s};
use crate::data::fetch::{Source, now_s};
use crate::data::pmtiles::Archive;
use crate::error::Result;
use std::sync::Arc;

/// How far the opening has come.
pub(super) enum Opening {
    /// Nothing of it has been asked for yet; then it is opened, and may turn out not to exist.
    Unasked,
    /// To be opened from this time on, seconds.
    At(f64),
    /// On its way.
    Started,
    /// Open.
    Open(Arc<Archive<Source>>),
    /// Given up, and why.
    Failed(String),
}

/// An archive, by its path or URL.
pub(super) struct Slot {
    pub(super) name: String,
    pub(super) opening: Opening,
    tried: u32,
    optional: bool,
}

impl Slot {
    /// An archive that is opened at once.
    pub(super) fn new(name: String) -> Self {
        Self { name, opening: Opening::At(f64::NEG_INFINITY), tried: 0, optional: false }
    }

    /// An archive that a world may lack: it is opened when something of it is asked for, and not looked for again where there is none.
    pub(super) fn unasked(name: String) -> Self {
        Self { name, opening: Opening::Unasked, tried: 0, optional: true }
    }

    /// Something of the archive is asked for.
    pub(super) fn ask(&mut self) {
        if let Opening::Unasked = self.opening {
            self.opening = Opening::At(f64::NEG_INFINITY);
        }
    }

    /// The archive, once open.
    pub(super) fn archive(&self) -> Option<&Arc<Archive<Source>>> {
        if let Opening::Open(archive) = &self.opening { Some(archive) } else { None }
    }

    /// Why it was given up, if it was.
    pub(super) fn failure(&self) -> Option<String> {
        if let Opening::Failed(why) = &self.opening { Some(why.clone()) } else { None }
    }

    /// True once each time that the archive is to be opened.
    pub(super) fn should_open(&mut self, now: f64) -> bool {
        let due = matches!(self.opening, Opening::At(time) if time <= now);
        if due {
            self.opening = Opening::Started;
        }
        due
    }

    /// Takes in the result of an opening.
    pub(super) fn opened(&mut self, result: Result<Archive<Source>>) {
        if self.archive().is_some() {
            return;
        }
        self.tried += 1;
        self.opening = match result {
            Ok(archive) => Opening::Open(Arc::new(archive)),
            Err(error) if self.optional && error.is_missing() => {
                log::info!("the world goes without an archive: {error}");
                Opening::Failed(error.to_string())
            }
            Err(_) if self.tried < ATTEMPTS => Opening::At(now_s() + wait_s(self.tried)),
            Err(error) => {
                log::warn!("an archive is given up: {error}");
                Opening::Failed(format!("the archive cannot be opened ({error})"))
            }
        };
    }
}
