//! The tables.

use std::time::Instant;

use ocean_globe::cli::render::{draw, headless};
use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture::{self, Shape};
use ocean_globe::model::perlin::TEXELS;
use ocean_globe::pass::fft::Precision;
use ocean_globe::pass::perlin::Perlin;
use ocean_globe::renderer::{Radiance, TARGET_FORMAT};
use ocean_globe::scene::frame::{Frame, Output};
use ocean_globe::scene::view::named::VIEWS;
use serde_json::{Value, json};
use wgpu::BufferUsages as B;

use crate::cpu::{self, CpuSea};
use crate::measure::{Work, finish, median, pass_ms, ratio, shown, wall_ms};
use crate::peers::{Peer, Stages, Transposed};
use crate::{ours, peers};

/// Seconds that one measurement may take, if a frame does not take longer.
const BUDGET_S: f64 = 0.3;
/// Sizes of the paper's table and its milliseconds on a GTX 450.
const SIZES: [(usize, f64); 4] = [(128, 4.01), (512, 7.50), (1024, 10.57), (2048, 18.30)];
/// The picture of the paper's whole frame.
const PICTURE: [u32; 2] = [1920, 1080];
const ROUNDS: usize = 5;
const PATCHES: usize = 4;
/// Bytes of an element of the drawn form that must move, by count: amplitude 8 and frequency 8 in, halfway 16 out and in, three texels
/// of 8 out. The mirrored amplitude, read a second time, is taken to come from a cache.
const BYTES: u64 = 8 + 8 + 16 + 16 + 3 * 8;

/// The view whose sea is the far sea of the measurements.
fn near_sea() -> Frame {
    let state = VIEWS.iter().find(|view| view.id == "gale").expect("a view of a gale").state();
    let noon = 1_795_608_000.0;
    Frame::new(&state.settings, &state.camera, noon, PICTURE)
}

fn perlin(gpu: &Gpu, texels: u32) -> Perlin {
    let perlin = Perlin::with_texels(gpu, texels);
    perlin.prepare(gpu, &near_sea());
    perlin
}

pub fn verified(gpu: &Gpu) -> Value {
    for n in [64, 128, 256, 512, 1024] {
        ours::verify_gpu(gpu, n);
    }
    ours::verify_cpu(128);
    println!("our transforms of 64 to 1024 samples and the CPU's agree with the f64 model to 1e-5 of the RMS");
    json!("64 to 1024 samples and the CPU's: 1e-5 of the RMS")
}

/// The best of a few runs on the CPU, ms.
fn cpu_ms(n: usize) -> f64 {
    let (cascade, h0, omegas) = ours::white(n);
    let mut sea = CpuSea::new(&cascade, &h0, &omegas);
    let mut run = |step: u32| {
        let start = Instant::now();
        sea.waves(u64::from(step) << 20);
        sea.perlin(step as f32 / 16.0);
        start.elapsed().as_secs_f64() * 1e3
    };
    median((0..if n > 512 { 3 } else { 9 }).map(&mut run).collect())
}

pub fn heights_and_normals(gpu: &Gpu) -> Value {
    println!("Heights and normals of FFT and Perlin together, one patch, ms per update");
    println!(
        "CPU: {} threads, rustfft, heights and slopes; GPU: these, displacements, gradients and products",
        cpu::THREADS
    );
    println!(
        "{:>6} {:>10} {:>10} {:>14} {:>9} {:>10}",
        "size", "CPU", "GPU wall", "GPU timestamps", "CPU/GPU", "GTX 450"
    );
    let row = |&(n, paper): &(usize, f64)| {
        let (fft, perlin) = (ours::fft(gpu, n, 1, Precision::Half), perlin(gpu, n as u32));
        let both: Work = &|pass| {
            fft.dispatch(pass);
            perlin.dispatch(pass);
        };
        let (on_cpu, wall) = (cpu_ms(n), wall_ms(gpu, BUDGET_S, both));
        let stamped = pass_ms(gpu, &[both])[0];
        let times = on_cpu / wall;
        println!("{n:>6} {on_cpu:>10.2} {wall:>10.2} {:>14} {times:>9.2} {paper:>10.2}", shown(stamped));
        json!({ "size": n, "cpu_ms": on_cpu, "gpu_wall_ms": wall, "gpu_timestamps_ms": stamped, "published_gtx450_ms": paper })
    };
    SIZES.iter().map(row).collect()
}

pub fn frame(gpu: &Gpu) -> Value {
    println!("Whole frame, 256² patches, {} x {}, a gale from 2 m", PICTURE[0], PICTURE[1]);
    let Ok(mut renderer) = headless("www/data", Radiance::Half) else {
        println!("not measured: no world in www/data");
        return json!("not measured");
    };
    let state = VIEWS.iter().find(|view| view.id == "gale").expect("a view of a gale").state();
    let Ok((mut frame, _)) = draw(&mut renderer, &state, PICTURE, Output::Picture) else {
        println!("not measured: the world's tiles did not come");
        return json!("not measured");
    };
    let own = renderer.gpu().clone();
    let picture = Shape::picture(PICTURE[0], PICTURE[1]);
    let target = texture::view(&own.texture("bench", picture, TARGET_FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT));
    let (mut encode, start) = (Vec::new(), Instant::now());
    while encode.len() < 3 || (start.elapsed().as_secs_f64() < 2.0 && encode.len() < 100) {
        frame.unix_seconds += 0.1;
        let begun = Instant::now();
        let mut encoder = own.device.create_command_encoder(&Default::default());
        renderer.render(&mut encoder, &frame, &target);
        let commands = encoder.finish();
        encode.push(begun.elapsed().as_secs_f64() * 1e3);
        own.queue.submit([commands]);
    }
    finish(&own);
    let frames = encode.len();
    let (wall, encode) = (start.elapsed().as_secs_f64() * 1e3 / frames as f64, median(encode));
    println!(
        "{wall:.2} ms per frame over {frames} frames back to back, {encode:.3} ms of it recording ({})",
        gpu.adapter
    );
    json!({ "size": PICTURE, "frames": frames, "wall_ms": wall, "encode_ms": encode })
}

/// Milliseconds and bytes per second of a kernel that copies 64 MiB.
fn copy(gpu: &Gpu) -> (f64, f64) {
    const SIZE: u64 = 64 << 20;
    let [from, to] = ["from", "to"].map(|label| gpu.empty_buffer(label, B::STORAGE, SIZE));
    let layout = gpu.layout("copy", wgpu::ShaderStages::COMPUTE, &[Bind::Storage, Bind::StorageWrite]);
    let [pipeline] = gpu.compute("copy", include_str!("copy.wgsl"), &[&layout], ["copy"]);
    let group = gpu.bind("copy", &layout, &[from.as_entire_binding(), to.as_entire_binding()]);
    let work: Work = &|pass| {
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups((SIZE / 16 / 256) as u32, 1, 1);
    };
    let ms = pass_ms(gpu, &[work])[0].unwrap_or_else(|| wall_ms(gpu, BUDGET_S, work));
    (ms, 2.0 * SIZE as f64 / ms * 1e3)
}

pub fn counts(gpu: &Gpu) -> Value {
    println!("Waves of a frame by count, {PATCHES} patches, drawn form (16-bit floats)");
    println!(
        "{:>6} {:>14} {:>14} {:>10} {:>10} {:>16}",
        "size", "FFT dispatches", "mip dispatches", "FFT MB", "FFT ms", "of a copy's GB/s"
    );
    let (_, copied) = copy(gpu);
    let row = |n: usize| {
        let fft = ours::fft(gpu, n, PATCHES, Precision::Half);
        let bytes = BYTES * (n * n * PATCHES) as u64;
        let work: Work = &|pass| fft.dispatch(pass);
        let ms = pass_ms(gpu, &[work])[0].unwrap_or_else(|| wall_ms(gpu, BUDGET_S, work));
        let share = bytes as f64 / ms * 1e3 / copied;
        let (waves, mips) = (fft.dispatches(), fft.mip_dispatches());
        println!("{n:>6} {waves:>14} {mips:>14} {:>10.1} {ms:>10.3} {share:>16.3}", bytes as f64 * 1e-6);
        assert!(waves <= 6, "{waves} dispatches");
        // Three textures read once; their levels are a third of it.
        let mip_bytes = (n * n * PATCHES) as u64 * 3 * 8 * 4 / 3;
        json!({ "size": n, "patches": PATCHES, "passes": 1, "submits": 1, "fft_dispatches": waves, "mip_dispatches": mips,
            "fft_bytes": bytes, "mip_bytes": mip_bytes, "fft_ms": ms, "traffic_over_copy": share })
    };
    let rows: Vec<Value> = [256, 512, 1024].into_iter().map(row).collect();
    println!("copy kernel: {:.2} GB/s; everything is in one pass of the frame's one submission", copied * 1e-9);
    println!(
        "Perlin: 1 dispatch, mips apart; foam: 1 dispatch, and for a still picture 25 replayed steps of stretches, their mips and foam before it"
    );
    json!({ "copy_bytes_per_s": copied, "sizes": rows })
}

pub fn passes(gpu: &Gpu) -> Value {
    let fft = ours::fft(gpu, 256, PATCHES, Precision::Half);
    let perlin = perlin(gpu, TEXELS as u32);
    let works: [(&str, Work); 5] = [
        ("FFT", &|pass| fft.dispatch(pass)),
        ("FFT mips", &|pass| fft.dispatch_mips(pass)),
        ("Perlin", &|pass| perlin.dispatch(pass)),
        ("Perlin mips", &|pass| perlin.dispatch_mips(pass)),
        ("FFT and Perlin", &|pass| {
            fft.dispatch(pass);
            perlin.dispatch(pass);
        }),
    ];
    println!("Passes of {PATCHES} x 256², ms: wall time of each alone, and the device's timestamps");
    let stamped = pass_ms(gpu, &works.map(|(_, work)| work));
    let walls = works.map(|(_, work)| wall_ms(gpu, BUDGET_S, work));
    for (((name, _), wall), stamped) in works.iter().zip(walls).zip(&stamped) {
        println!("{name:<16} {wall:>10.3} {:>14}", shown(*stamped));
    }
    let overlap = walls[4] / (walls[0] + walls[2]);
    println!("FFT and Perlin in one pass over the sum of each alone: {overlap:.2} (wall)");
    let rows = works
        .iter()
        .zip(walls)
        .zip(stamped)
        .map(|(((name, _), wall), stamped)| json!({ "pass": name, "wall_ms": wall, "timestamps_ms": stamped }));
    json!({ "patches": PATCHES, "size": 256, "passes": rows.collect::<Value>(), "overlap_wall": overlap })
}

pub fn peers(gpu: &Gpu) -> Value {
    println!(
        "Peers: four fields of one patch, without evolution and unpacking, which ours includes; {ROUNDS} rounds A B B A"
    );
    println!("{:<44} {:>5} {:>10} {:>9} {:>22}", "", "size", "dispatches", "MB", "time over ours (range)");
    let mut rows = Vec::new();
    for n in [256, 512] {
        let fft = ours::fft(gpu, n, 1, Precision::Half);
        let (stages, transposed) = (Stages::new(gpu, n), Transposed::new(gpu, n));
        let contenders: [(&str, &dyn Peer); 2] = [
            ("one dispatch per butterfly stage, textures", &stages),
            ("radix 2 in workgroup memory, transposes", &transposed),
        ];
        for (name, peer) in contenders {
            peers::verify(gpu, name, n, peer);
            let mut mine = || wall_ms(gpu, BUDGET_S / 3.0, &|pass| fft.dispatch(pass));
            let mut theirs = || wall_ms(gpu, BUDGET_S / 3.0, &|pass| peer.record(pass));
            let [middle, least, greatest] = ratio(ROUNDS, &mut mine, &mut theirs);
            let (dispatches, bytes) = (peer.dispatches(), peer.bytes());
            let range = format!("{middle:.2} ({least:.2} … {greatest:.2})");
            println!("{name:<44} {n:>5} {dispatches:>10} {:>9.1} {range:>22}", bytes as f64 * 1e-6);
            rows.push(json!({ "peer": name, "size": n, "dispatches": dispatches, "bytes": bytes,
                "time_over_ours": { "median": middle, "least": least, "greatest": greatest } }));
        }
        let own = format!("{:.1}", (BYTES * (n * n) as u64) as f64 * 1e-6);
        println!("{:<44} {n:>5} {:>10} {own:>9} {:>22}", "ours", fft.dispatches(), "1");
    }
    println!("cuFFT: not measured");
    rows.push(json!({ "peer": "cuFFT", "time_over_ours": "not measured" }));
    Value::Array(rows)
}
