//! Waves by a shore as the drawing shaders have them, against the model in f64: the formulas of breakers, and the sum of the trains at places
//! of real coasts.

use std::collections::HashSet;

use bytemuck::{Pod, Zeroable};
use ocean_globe::data::tile::{MapPoint, Projection};
use ocean_globe::data::world::World;
use ocean_globe::gpu::Gpu;
use ocean_globe::model::shore_waves::Shallows;
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::model::wave_trains::taken_m2;
use ocean_globe::model::{GRAVITY, dispersion, surf};
use ocean_globe::pass::shore_trains::{COMES_S, ShoreTrains};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::shores::{SLOTS, Shores};
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::beside_shore::{Asker, made, places};
use crate::kernel;

const BREAKERS: &str = "#import breakers
struct Found { first: vec4f, second: vec4f }
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let k_deep = a.y * a.y / GRAVITY;
    let y = depth_number(k_deep * a.z);
    let gamma = breaker_index(a.w, a.x, a.y);
    let breaks = breaking_depth(a.x, k_deep, gamma);
    let turn = sine_cosine(1.9);
    let surface = wave_surface(wave_shape(a.x, y, a.z, 0.3, 1.0), vec2f(turn.cosine, turn.sine));
    found[id.x] = Found(vec4f(y, shoaling(y), gamma, breaks), vec4f(broken_height(0.6, a.w, gamma), surface, 0.0));
}";

#[test]
fn breakers_are_those_of_the_model() {
    let mut asked = Vec::new();
    for height in [0.2f32, 1.0, 3.0] {
        for period in [4.0f32, 8.0, 16.0] {
            for depth in [0.1f32, 0.7, 3.0, 12.0, 60.0] {
                asked.extend(
                    [0.01f32, 0.03, 0.06, 0.1].map(|slope| [height, std::f32::consts::TAU / period, depth, slope]),
                );
            }
        }
    }
    let found = kernel::answers::<_, [f32; 8]>(BREAKERS, &asked);
    for (asked, found) in asked.iter().zip(&found) {
        let [height, omega, depth, slope] = asked.map(f64::from);
        let k = dispersion::wavenumber(omega, depth);
        let gamma = surf::breaker_index(slope, height, omega);
        let [rise, tilt] = surf::Shape::new(height, k, depth, 0.3, 1.0).surface(1.9);
        let wanted = [
            k * depth,
            dispersion::shoaling(k, depth),
            gamma,
            surf::breaking_depth(height, omega * omega / GRAVITY, gamma),
            surf::broken(0.6, slope, gamma),
            rise,
            tilt,
        ];
        for (what, (wanted, found)) in wanted.iter().zip(found).enumerate() {
            // One step of Newton's leaves 2e-3 of kh, of which the Ursell number takes the square.
            let error = (f64::from(*found) - wanted).abs() / wanted.abs().max(0.3);
            assert!(error < 6e-3, "{what}: {found} for {wanted}, {asked:?}");
        }
    }
}

/// On a way along a coast, with windows as they come and step by step.
#[test]
fn windows_take_no_more_than_64_mb() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let (mut world, mut shores, mut trains) = (World::open("www/data"), Shores::default(), ShoreTrains::new(&gpu));
    let settings = Settings { wind: Wind { speed_mps: 9.0, from_deg: 310.0 }, ..Settings::default() };
    let (mut seen, mut most, mut making) = (HashSet::new(), 0, 0);
    for stop in 0..12 {
        // South to north along Holland, 7 km from stop to stop.
        let way = f64::from(stop) / 11.0;
        let camera = Camera::from_degrees(52.0 + 0.75 * way, 4.2 + 0.45 * way, 30.0, 0.0, 60.0);
        let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
        // No time is one step.
        let seconds = if stop % 3 == 0 { 0.0 } else { f64::INFINITY };
        while !shores.prepare(&mut world, &frame, (true, true), seconds) {
            world.poll();
            // Whatever is more than nodes of windows is being made.
            let ready: usize = shores.ready().map(|(_, nodes)| size_of_val(&nodes[..])).sum();
            making = making.max(shores.bytes() - ready);
            most = most.max(shores.bytes());
        }
        trains.prepare(&gpu, &shores, &frame, false);
        let ready: Vec<_> = shores.ready().collect();
        assert_eq!(trains.windows(), ready.len(), "all that are wanted are on the device");
        let nodes: usize = ready.iter().map(|(_, nodes)| size_of_val(&nodes[..])).sum();
        assert!(shores.bytes() >= nodes, "{} bytes, {nodes} of them nodes", shores.bytes());
        seen.extend(ready.iter().map(|(tile, _)| *tile));
        most = most.max(shores.bytes());
    }
    let device = trains.buffer.size() as usize;
    println!("{} windows, {most} bytes at most, {device} on the device", seen.len());
    assert!(seen.len() > SLOTS && making > 1 << 20, "{} windows, {making} bytes being made", seen.len());
    assert!(most + device < 64_000_000, "{most} bytes in the program, {device} on the device");
}

const TRAINS: &str = "#import shore_trains
struct Asked { at: vec2u, depth: f32, plain: f32, left: f32, shore: f32, face: f32, unused: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
struct Told { waves: vec4f, left: vec4f }
@group(2) @binding(1) var<storage, read_write> found: array<Told>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let waves = shore_waves_at(MapPoint(MERCATOR, a.at), a.depth, a.plain, a.left, a.shore, a.face, 0.0, 0.0, 0.0);
    let left = left_by_trains(OPEN_SEA, waves.share);
    found[id.x] = Told(vec4f(waves.rise, waves.slope, waves.share), vec4f(left.gains.xyz, left.height));
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    depth: f32,
    plain: f32,
    left: f32,
    shore: f32,
    face: f32,
    unused: f32,
}

fn asked_at(&(lat, lon, water): &(f64, f64, Shallows)) -> Asked {
    let point = MapPoint::on(Projection::Mercator, lat, lon);
    let [depth, plain, left, shore, face] = [water.h, water.plain_h, water.left, water.d, water.m].map(|x| x as f32);
    Asked { at: [point.u, point.v], depth, plain, left, shore, face, unused: 0.0 }
}

#[test]
fn windows_of_a_moving_picture_come_by_and_by() {
    let mut world = World::open("www/data");
    let camera = Camera::from_degrees(52.0986, 4.2520, 30.0, 0.0, 60.0);
    let settings = Settings { wind: Wind { speed_mps: 9.0, from_deg: 310.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
    let asked: Vec<_> = places(&mut world, &camera, 23.0).iter().map(asked_at).collect();
    let shores = made(&mut world, &frame);
    // The share of the sea's energy that the trains have, summed over the places.
    let share = |asker: &mut Asker| -> f64 {
        asker.found::<_, [f32; 8]>(&shores, &frame, &asked).iter().map(|found| f64::from(found[3])).sum()
    };
    let whole = share(&mut Asker::new(TRAINS));
    let mut moving = Asker::new(TRAINS);
    moving.moving = true;
    let first = share(&mut moving);
    std::thread::sleep(std::time::Duration::from_secs_f64(COMES_S));
    let last = share(&mut moving);
    println!("{first} of {whole} at once, {last} after {COMES_S} s");
    assert!(whole > 30.0 && first == 0.0 && last == whole, "{first}, {last} of {whole}");
    // A picture that stands still has no time to wait.
    let mut stands = Asker::new(TRAINS);
    stands.moving = true;
    share(&mut stands);
    stands.moving = false;
    assert_eq!(share(&mut stands), whole);
}

#[test]
fn trains_at_places_are_those_of_the_cpu() {
    let mut world = World::open("www/data");
    let camera = Camera::from_degrees(52.0986, 4.2520, 30.0, 0.0, 60.0);
    let settings = Settings { wind: Wind { speed_mps: 9.0, from_deg: 310.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
    // Opens the archives. Deeper water than there is has the trains give the waves back to the patches, and a coral reef has less of it and of the waves.
    let mut places = places(&mut world, &camera, 23.0);
    for (i, (.., water)) in places.iter_mut().enumerate() {
        let deeper = |times: f64| Shallows { h: times * water.h, ..*water };
        *water = match i % 4 {
            3 => Shallows { h: 1.2, plain_h: 15.0, left: 0.5, ..*water },
            part => deeper([1.0, 3.0, 6.0][part]),
        };
    }
    let places = places;
    let shores = made(&mut world, &frame);
    let asked: Vec<_> = places.iter().map(asked_at).collect();
    let found = Asker::new(TRAINS).found::<_, [f32; 8]>(&shores, &frame, &asked);
    let (mut seen, mut squares, mut heights, mut shared, mut reefs) = (0, [0.0; 2], 0.0, 0, 0);
    let (spectrum, m0) = (frame.sea.sea.spectrum(), frame.sea.sea.hs_m.powi(2) / 16.0);
    let of_patches: Vec<f64> =
        frame.sea.cascades.iter().map(|patch| spectrum.variance_between(patch.k_min, patch.k_max)).collect();
    for (place, found) in places.iter().zip(&found) {
        let &(lat, lon, water) = place;
        let Some(wanted) = shores.waves_at((lat, lon), water, frame.ticks()) else {
            assert_eq!(found[3], 0.0, "{place:?}");
            continue;
        };
        assert!((f64::from(found[3]) - wanted.share).abs() < 1e-4, "{found:?} {wanted:?}");
        // Whatever the share, what the trains have and what they leave of each patch is the sea; shoaling and lees come after.
        let left: [f64; 4] = [found[4], found[5], found[6], 1.0].map(f64::from);
        let energy = f64::from(found[3]) * taken_m2(&frame.sea)
            + left.iter().zip(&of_patches).map(|(left, patch)| left * left * patch).sum::<f64>();
        assert!((energy / m0 - 1.0).abs() < 0.01, "{energy} m² of {m0}, {found:?}");
        assert!((1.0 - f64::from(found[7]).powi(2) - f64::from(found[3]) * taken_m2(&frame.sea) / m0).abs() < 0.01);
        assert!((0..3).all(|patch| (left[patch] - wanted.patches[patch]).abs() < 1e-4), "{found:?} {wanted:?}");
        reefs += usize::from(water.left < 1.0 && found[3] > 0.05);
        shared += usize::from((0.05..0.95).contains(&found[3]));
        squares[0] += (f64::from(found[0]) - wanted.wave.rise).powi(2);
        squares[1] +=
            (f64::from(found[1]) - wanted.wave.slope[0]).powi(2) + (f64::from(found[2]) - wanted.wave.slope[1]).powi(2);
        heights += wanted.wave.rise.powi(2);
        seen += 1;
    }
    let [rise, slope] = squares.map(|square| (square / f64::from(seen)).sqrt());
    let height = (heights / f64::from(seen)).sqrt();
    println!("{seen} places, waves of {height:.3} m rms: off by {rise:.5} m and {slope:.5}");
    assert!(seen > 150 && height > 0.1 && shared > 30 && reefs > 20, "{shared} in both, {reefs} behind reefs");
    // Phases of hundreds of radians in 32 bits, and the fronts of bores, which 1e-3 of a radian move by a centimetre.
    assert!(rise < 0.01 * height && slope < 0.01, "{rise} {slope}");
}

#[test]
fn windows_of_waves_hand_over_their_energy() {
    // Off the Dutch coast, across the edges of windows, over 400 instants: variance of the trains over what they have taken and shoaling makes of
    // it, at places beside edges and away from them.
    let mut world = World::open("www/data");
    let camera = Camera::from_degrees(52.105, 4.235, 30.0, 0.0, 60.0);
    let settings = Settings { wind: Wind { speed_mps: 6.0, from_deg: 310.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
    let places = places(&mut world, &camera, 190.0);
    let shores = made(&mut world, &frame);
    // Another eye finds the same waves where both see them.
    let other = Camera::from_degrees(52.099, 4.226, 300.0, 0.0, 60.0);
    let others = made(&mut world, &Frame::new(&settings, &other, 0.0, [64; 2]));
    for (lat, lon, water) in &places {
        let waves = [&shores, &others].map(|shores| shores.waves_at((*lat, *lon), *water, frame.ticks()));
        assert_eq!(waves[0], waves[1]);
    }
    let mut sums = [[0.0f64; 2]; 2];
    for (lat, lon, water) in places.into_iter().filter(|place| place.2.d > 900.0 && place.2.d < 2_300.0) {
        let point = MapPoint::on(Projection::Mercator, lat, lon);
        let inside = [point.u, point.v].map(|at| f64::from(at << 13) / 4_294_967_296.0);
        let beside = usize::from(inside.iter().any(|at| (at - 0.5).abs() > 0.42));
        for instant in 0..400 {
            let ticks = frame.ticks() + instant * 7_340_033;
            // As deep everywhere, so that waves are as high: only their phases and their ways differ.
            let Some(waves) = shores.waves_at((lat, lon), Shallows::new(8.0, water.d, water.m), ticks) else {
                continue;
            };
            sums[beside][0] += waves.wave.rise * waves.wave.rise;
            sums[beside][1] += waves.share;
        }
    }
    let [away, beside] = sums.map(|[square, share]| square / share);
    println!(
        "variance {away:.4} m² away from edges, {beside:.4} m² beside them, of {} and {} samples",
        sums[0][1], sums[1][1]
    );
    assert!(sums[1][1] > 300.0, "edges were met");
    // Thousands of samples each, of eight trains at four hundred instants; the trains' lees differ from place to place.
    assert!((beside / away - 1.0).abs() < 0.03, "{beside} beside edges, {away} away from them");
}
