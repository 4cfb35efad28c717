//! `cargo bench --bench waves [-- FILE]`: what the waves cost here, on the CPU and on the GPU, beside what others do, and saved as
//! JSON. Whatever is timed has been checked against the f64 model first.

mod cpu;
mod measure;
mod ours;
mod peers;
mod sections;

use ocean_globe::gpu::Gpu;
use serde_json::{Map, Value};

const DEFAULT_FILE: &str = "target/bench/waves.json";

/// Prints a table and returns it for the record.
type Section = fn(&Gpu) -> Value;

fn main() {
    // cargo passes --bench; what is no option is the file.
    let path = std::env::args().skip(1).find(|a| !a.starts_with('-')).unwrap_or_else(|| DEFAULT_FILE.into());
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    println!("{}\n", gpu.adapter);
    let mut record = Map::new();
    record.insert("adapter".into(), gpu.adapter.clone().into());
    let sections: [(&str, Section); 6] = [
        ("verified", sections::verified),
        ("heights_and_normals", sections::heights_and_normals),
        ("frame", sections::frame),
        ("counts", sections::counts),
        ("passes", sections::passes),
        ("peers", sections::peers),
    ];
    for (name, section) in sections {
        let start = std::time::Instant::now();
        record.insert(name.into(), section(&gpu));
        println!("({:.0} s)\n", start.elapsed().as_secs_f64());
    }
    let path = std::path::Path::new(&path);
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).expect("a folder for the record");
    }
    std::fs::write(path, format!("{:#}\n", Value::Object(record))).expect("a file for the record");
    println!("saved as {}", path.display());
}
