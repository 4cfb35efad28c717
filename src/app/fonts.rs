//! The one font of panel, readouts and credits, cut down to Latin, Greek and the signs that they use (scripts/make-font.sh). What it lacks, a
//! page's browser may draw.

use std::sync::Arc;

use egui::{FontData, FontDefinitions, FontFamily};

const NAME: &str = "panel";

/// The font for text of every family.
pub fn definitions() -> FontDefinitions {
    let data = FontData::from_static(include_bytes!("../../fonts/panel.ttf"));
    let families = [FontFamily::Proportional, FontFamily::Monospace];
    FontDefinitions {
        font_data: [(NAME.to_owned(), Arc::new(data))].into(),
        families: families.map(|family| (family, vec![NAME.to_owned()])).into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::world::World;
    use crate::scene::view::named::VIEWS;

    /// What the program may write: the texts of its own modules, names from others, and the credits of the bundled world.
    fn texts() -> Vec<String> {
        let folder =
            |path: &str| std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()).collect::<Vec<_>>();
        let mut files = [folder("src/app"), folder("src/panel")].concat();
        files.extend(
            ["src/app.rs", "src/panel.rs", "src/model/sea_state.rs", "src/scene/layers.rs", "src/scene/settings.rs"]
                .map(Into::into),
        );
        let mut texts: Vec<String> = VIEWS.iter().map(|view| view.title.to_owned()).collect();
        for file in files {
            let source = std::fs::read_to_string(&file).unwrap();
            // Comments may say what they like.
            let code = source.lines().filter(|line| !line.trim_start().starts_with("//"));
            texts.extend(code.map(str::to_owned));
        }
        let mut world = World::open("www/data");
        while !world.settled() {
            world.poll();
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        assert!(!world.credits().is_empty());
        texts.extend(world.credits());
        texts
    }

    #[test]
    fn every_character_that_the_program_writes_has_a_glyph() {
        let context = egui::Context::default();
        context.set_fonts(definitions());
        let texts = texts();
        let mut missing = std::collections::BTreeSet::new();
        let mut seen = 0;
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            ui.fonts_mut(|fonts| {
                for family in [FontFamily::Proportional, FontFamily::Monospace] {
                    let font = egui::FontId::new(12.0, family);
                    for letter in texts.iter().flat_map(|text| text.chars()) {
                        seen += 1;
                        if !fonts.has_glyph(&font, letter) {
                            missing.insert(letter);
                        }
                    }
                }
            });
        });
        // No texture is made of the glyphs here.
        output.textures_delta.clear();
        assert!(seen > 10_000, "only {seen} characters were looked up");
        assert!(missing.is_empty(), "no glyph for {missing:?}");
    }
}
