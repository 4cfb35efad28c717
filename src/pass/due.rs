//! Tables that are made when a frame needs others than there are.

/// What tables of a pass were last made of, and whether that must be done again.
#[derive(Debug)]
pub struct Due<T> {
    made: Option<T>,
    due: bool,
}

impl<T> Default for Due<T> {
    fn default() -> Self {
        Self { made: None, due: false }
    }
}

impl<T: PartialEq> Due<T> {
    /// Looks whether tables of `wanted` are others than there are.
    pub fn look(&mut self, wanted: T) {
        self.due = self.made.as_ref() != Some(&wanted);
        self.made = Some(wanted);
    }

    /// How many of a pass's dispatches are to be made: all of `count`, or none.
    pub fn dispatches(&self, count: usize) -> usize {
        if self.due { count } else { 0 }
    }

    /// Whether to make them now: once after a look that found them missing.
    pub fn take(&mut self) -> bool {
        std::mem::take(&mut self.due)
    }
}
