//! What the program needs of the page or window around it.

/// The surroundings: an address with a fragment and a history in the browser, nothing of that in a window.
pub trait Page {
    /// The fragment, without `#`, when somebody else has changed it since the last call: a link, back, forward.
    fn new_fragment(&mut self) -> Option<String>;

    /// Sets the fragment; `push`: as a new entry of the history, else in place of the present one.
    fn set_fragment(&mut self, fragment: &str, push: bool);

    /// The whole link of a fragment.
    fn link(&self, fragment: &str) -> String;

    /// Publishes a fact about the program under a name, for the page's scripts and for tests.
    fn publish(&mut self, name: &str, value: &str);
}

/// A window without an address.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoPage;

impl Page for NoPage {
    fn new_fragment(&mut self) -> Option<String> {
        None
    }

    fn set_fragment(&mut self, _fragment: &str, _push: bool) {}

    fn link(&self, fragment: &str) -> String {
        format!("#{fragment}")
    }

    fn publish(&mut self, _name: &str, _value: &str) {}
}
