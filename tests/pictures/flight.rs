//! `render --flight`: numbered pictures of a flight, that can be stopped and taken up again.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::SystemTime;

use ocean_globe::model::earth;
use ocean_globe::scene::view::named::VIEWS;

/// With foam, which has a history, and a clock that stands still, so that the last frame shows the second view as it is.
const SEA: &str = "bft=8&quality=low&time=2026-11-20T12:00:00Z&rate=0";
const COAST: &str = "#view=28.8545,-13.792,560,253,71&clouds=0";
const ABOVE: &str = "#view=28.9,-13.9,30000,184,56&clouds=0";

fn program(args: &[&str]) -> Output {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let output =
        Command::new(env!("CARGO_BIN_EXE_ocean-globe")).arg("render").args(args).args(["--data", data]).output();
    output.expect("a program")
}

/// What the program prints; it must succeed.
fn printed(args: &[&str]) -> String {
    let output = program(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// What the program complains about; it must fail.
fn complaint(args: &[&str]) -> String {
    let output = program(args);
    assert!(!output.status.success(), "{args:?} should fail");
    String::from_utf8(output.stderr).unwrap()
}

/// An empty folder's name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

fn modified(path: &Path) -> SystemTime {
    std::fs::metadata(path).unwrap().modified().unwrap()
}

#[test]
fn a_flight_can_be_taken_up_again_and_ends_at_its_views() {
    let folder = folder("flight");
    let (out, size) = (folder.to_str().unwrap(), "96x54");
    let [from, to] = [COAST, ABOVE].map(|view| format!("{view}&{SEA}"));
    let flight = ["--flight", &from, &to, "--frames", "5", "--size", size, "-o", out];
    assert!(printed(&flight).contains("5 frames drawn, 0 were there"));
    let frame = |index: usize| folder.join(format!("{index:05}.png"));
    let read = |index: usize| std::fs::read(frame(index)).unwrap();
    let first: Vec<_> = (0..5).map(read).collect();

    // The ends are the pictures that `render` makes of the views.
    for (state, index) in [(&from, 0), (&to, 4)] {
        let still = folder.with_extension("png");
        printed(&["--state", state, "--size", size, "-o", still.to_str().unwrap()]);
        assert!(std::fs::read(still).unwrap() == first[index], "frame {index} is not the picture of {state}");
    }
    assert!((0..4).all(|index| first[index] != first[index + 1]), "frames follow each other");

    // One frame is missing, one lacks its end, and one was being written: they are drawn as they were, though other frames come before
    // them now; the rest stays as it is.
    std::fs::remove_file(frame(1)).unwrap();
    std::fs::write(frame(2), &first[2][..first[2].len() - 20]).unwrap();
    std::fs::write(frame(1).with_added_extension("part"), &first[1][..100]).unwrap();
    let times: Vec<_> = [0, 3, 4].map(|index| modified(&frame(index))).into();
    assert!(printed(&flight).contains("2 frames drawn, 3 were there"));
    assert_eq!(times, [0, 3, 4].map(|index| modified(&frame(index))));
    for (index, first) in first.iter().enumerate() {
        assert!(read(index) == *first, "frame {index} changed");
    }
    assert!(!frame(1).with_added_extension("part").exists());

    // Another flight in the same folder is refused, and nothing is touched.
    let with = |place: usize, value: &'static str| {
        let mut args: Vec<&str> = flight.to_vec();
        args[place] = value;
        complaint(&args)
    };
    assert!(with(4, "6").contains("another number of frames"));
    assert!(with(6, "64x36").contains("another size"));
    assert!(with(2, "coast").contains("another second view"));
    assert_eq!(times, [0, 3, 4].map(|index| modified(&frame(index))));
}

#[test]
fn a_frame_does_not_depend_on_those_before_it() {
    let folder = folder("foam");
    let view = |alt_m: u32| {
        format!("#view=35.6812,-14.25,{alt_m},253,70&clouds=0&bft=9&quality=low&time=2026-11-20T12:00:00Z")
    };
    let (from, to) = (view(20), view(30));
    let out = folder.to_str().unwrap();
    let flight = ["--flight", &from, &to, "--frames", "3", "--fps", "1", "--size", "128x72", "-o", out];
    printed(&flight);
    let frame = folder.join("00001.png");
    let first = std::fs::read(&frame).unwrap();
    assert!(first != std::fs::read(folder.join("00000.png")).unwrap());
    std::fs::remove_file(&frame).unwrap();
    printed(&flight);
    assert!(std::fs::read(&frame).unwrap() == first, "the foam differs");
}

/// Over a lake finer tiles come than a picture of its continent wants: had they a say in it, what was seen before would.
#[test]
fn a_picture_does_not_depend_on_what_was_seen_before() {
    let folder = folder("from-a-lake");
    let out = folder.to_str().unwrap();
    let [lake, continent] = ["45.72,10.07,40,150,84", "38,-2,3000000"]
        .map(|view| format!("#view={view}&clouds=0&rate=0&time=2026-11-20T12:00:00Z"));
    printed(&["--flight", &lake, &continent, "--frames", "2", "--size", "320x180", "-o", out]);
    let fresh = folder.with_extension("png");
    printed(&["--state", &continent, "--size", "320x180", "-o", fresh.to_str().unwrap()]);
    assert!(std::fs::read(folder.join("00001.png")).unwrap() == std::fs::read(fresh).unwrap());
}

#[test]
fn what_cannot_be_a_flight_is_refused() {
    let folder = folder("no-flight");
    let out = folder.to_str().unwrap();
    let unknown = complaint(&["--flight", "globe", "galle", "-o", out]);
    assert!(unknown.contains("galle") && unknown.contains("hurricane"), "{unknown}");
    assert!(complaint(&["--flight", "globe", "#view=91x", "-o", out]).contains("view"));
    assert!(complaint(&["--flight", "globe", "-o", out]).contains("--flight"));
    assert!(complaint(&["--flight", "globe", "gale", "--frames", "1", "-o", out]).contains("--frames"));
    assert!(complaint(&["--flight", "globe", "gale", "--fps", "0", "-o", out]).contains("fps"));
    assert!(complaint(&["--flight", "globe", "gale", "--layer", "depth", "-o", out]).contains("--layer"));
    assert!(complaint(&["--frames", "10", "-o", "x.png"]).contains("--flight"));
    assert!(complaint(&["--flight", "globe", "gale", "-o", "flight.png"]).contains("folder"));
    assert!(!folder.exists(), "a refused flight makes no folder");

    // Pictures that nobody knows are not counted as frames.
    std::fs::create_dir(&folder).unwrap();
    std::fs::write(folder.join("00003.png"), b"somebody's").unwrap();
    assert!(complaint(&["--flight", "globe", "gale", "-o", out]).contains("flight.json"));
    assert_eq!(std::fs::read(folder.join("00003.png")).unwrap(), b"somebody's");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
}

#[test]
fn every_flight_between_named_views_rises_and_falls_once() {
    use ocean_globe::scene::view::flight::Flight;
    let mut arcs = 0;
    for from in &VIEWS {
        for to in VIEWS.iter().filter(|to| *to != from) {
            let [a, b] = [from, to].map(|view| view.state().camera);
            let flight = Flight::new(a, b);
            let heights: Vec<_> =
                (0..=200).map(|i| flight.at(flight.duration_s() * f64::from(i) / 200.0).altitude_m).collect();
            let top = (0..=200).max_by(|&i, &j| heights[i].total_cmp(&heights[j])).unwrap();
            // Room for the last bits of a height that stays as it is.
            let level = |height: f64| 1e-9 * height.abs();
            assert!(
                heights[..=top].is_sorted_by(|a, b| *a <= b + level(*b)),
                "{} to {}: sinks while rising",
                from.id,
                to.id
            );
            assert!(
                heights[top..].is_sorted_by(|a, b| a + level(*a) >= *b),
                "{} to {}: rises while sinking",
                from.id,
                to.id
            );
            let ground_m = earth::normal(a.lat, a.lon).angle_between(earth::normal(b.lat, b.lon)) * earth::WGS84.a;
            // High enough to see both ends: half of the way between them, of which the samples may miss the very top.
            assert!(heights[top] >= 0.49 * ground_m, "{} to {}: {} m for {ground_m} m", from.id, to.id, heights[top]);
            arcs += usize::from(heights[top] > 1.01 * a.altitude_m.max(b.altitude_m));
        }
    }
    assert!(arcs > 8, "only {arcs} flights rise above their ends");
}
