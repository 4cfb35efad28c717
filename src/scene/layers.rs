//! What is drawn: a small set of named layers.

/// One thing that can be shown or hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// The land.
    Land,
    /// The sea.
    Sea,
    /// The foam on the sea.
    Foam,
    /// The sky.
    Sky,
    /// The clouds.
    Clouds,
    /// The stars.
    Stars,
    /// The lights of cities.
    Lights,
    /// The data credits over the picture.
    Credits,
}

impl Layer {
    /// Every layer with its id in links.
    pub const ALL: [(Self, &'static str); 8] = [
        (Self::Land, "land"),
        (Self::Sea, "sea"),
        (Self::Foam, "foam"),
        (Self::Sky, "sky"),
        (Self::Clouds, "clouds"),
        (Self::Stars, "stars"),
        (Self::Lights, "lights"),
        (Self::Credits, "credits"),
    ];

    fn bit(self) -> u32 {
        1 << self as u32
    }
}

/// The set of layers that are shown. The default shows all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layers {
    shown: u32,
}

impl Default for Layers {
    fn default() -> Self {
        Self { shown: Layer::ALL.iter().fold(0, |shown, (layer, _)| shown | layer.bit()) }
    }
}

impl Layers {
    /// Whether a layer is shown.
    pub fn shows(self, layer: Layer) -> bool {
        self.shown & layer.bit() != 0
    }

    /// Shows or hides a layer.
    pub fn set(&mut self, layer: Layer, shown: bool) {
        if shown {
            self.shown |= layer.bit();
        } else {
            self.shown &= !layer.bit();
        }
    }

    /// The set that a list such as `-sea,-sky` makes from the default, and the ids that nobody knows.
    pub fn from_ids(text: &str) -> (Self, Vec<&str>) {
        let mut layers = Self::default();
        let mut unknown = Vec::new();
        for item in text.split(',').map(str::trim).filter(|item| !item.is_empty()) {
            let (id, shown) = item.strip_prefix('-').map_or((item, true), |id| (id, false));
            match Layer::ALL.iter().find(|(_, name)| *name == id) {
                Some(&(layer, _)) => layers.set(layer, shown),
                None => unknown.push(item),
            }
        }
        (layers, unknown)
    }

    /// The list that makes this set from the default; empty where it is the default.
    pub fn to_ids(self) -> String {
        let default = Self::default();
        let differs = |&&(layer, _): &&(Layer, &str)| self.shows(layer) != default.shows(layer);
        let items = Layer::ALL.iter().filter(differs);
        let items: Vec<_> = items.map(|&(l, id)| format!("{}{id}", if self.shows(l) { "" } else { "-" })).collect();
        items.join(",")
    }
}
