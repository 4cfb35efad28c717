//! The house of floors: a file uses lower floors only, passes do not know each other, and wgpu and egui stay where they belong.

use std::fs;
use std::path::{Path, PathBuf};

/// (module, floor); what is not listed (error, bibliography) belongs to all.
const FLOORS: &[(&str, u32)] = &[
    ("model", 0),
    ("data", 1),
    ("scene", 2),
    ("gpu", 3),
    ("pass", 4),
    ("renderer", 5),
    ("app", 6),
    ("panel", 6),
    ("web", 6),
    ("cli", 6),
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The complaints about one file: its path below `src/` and its text.
fn complaints(path: &str, text: &str) -> Vec<String> {
    let module = path.trim_end_matches(".rs").split('/').next().unwrap();
    let Some(&(_, floor)) = FLOORS.iter().find(|(name, _)| *name == module) else { return Vec::new() };
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap();
        let mut complain = |why: String| found.push(format!("{path}:{}: {why}", number + 1));
        for &(name, above) in FLOORS {
            let used = code.contains(&format!("crate::{name}::")) || code.contains(&format!("crate::{name};"));
            if used && above > floor {
                complain(format!("floor {floor} uses `{name}` of floor {above}"));
            }
            if used && name == "pass" && module == "pass" {
                complain("one pass uses another".into());
            }
        }
        if floor < 3 && code.contains("wgpu") {
            complain("wgpu below floor 3".into());
        }
        if floor < 6 && (code.contains("egui") || code.contains("eframe")) {
            complain("egui below floor 6".into());
        }
        if floor == 0 && (code.contains("std::fs") || code.contains("std::net")) {
            complain("the model reads files".into());
        }
    }
    found
}

#[test]
fn every_file_uses_lower_floors_only() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    assert!(files.len() > 40, "only {} sources found", files.len());
    let all: Vec<String> = files
        .iter()
        .flat_map(|path| {
            complaints(path.strip_prefix(&root).unwrap().to_str().unwrap(), &fs::read_to_string(path).unwrap())
        })
        .collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn the_check_sees_what_it_should() {
    assert_eq!(complaints("model/earth.rs", "use crate::scene::view::camera::Camera;").len(), 1);
    assert_eq!(complaints("scene/frame.rs", "fn f(d: &wgpu::Device) {}").len(), 1);
    assert_eq!(complaints("pass/sky.rs", "use crate::pass::land::Land;").len(), 1);
    assert_eq!(complaints("renderer.rs", "use egui::Ui;").len(), 1);
    assert!(complaints("renderer.rs", "use crate::pass::land::Land; // egui").is_empty());
}

#[test]
fn every_file_of_tests_is_compiled_into_one_of_few_programs() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let mut files = Vec::new();
    sources(&root, &mut files);
    for file in &files {
        let (folder, name) = (file.parent().unwrap(), file.file_stem().unwrap().to_str().unwrap());
        assert_ne!(
            folder, root,
            "{name}: a program of its own, which links all that is drawn with; put it in a folder"
        );
        let lines =
            |program: &Path, line: &str| fs::read_to_string(program).unwrap().lines().any(|other| other == line);
        let named = if folder.ends_with("shared") {
            // Of several programs.
            let path = format!("#[path = \"../shared/{name}.rs\"]");
            files.iter().filter(|file| file.ends_with("main.rs") && lines(file, &path)).count() > 1
        } else {
            lines(&folder.join("main.rs"), &format!("mod {name};"))
        };
        assert!(
            named || name == "main",
            "{}: not named in main.rs (if shared, in two), so that it never runs",
            file.display()
        );
    }
    assert!(files.len() > 50, "only {} files", files.len());
}
