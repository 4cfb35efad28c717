//! Foam's lace: the share that it is told to cover is covered, and means do not depend on how wide pixels are.

use bytemuck::{Pod, Zeroable};
use glam::DVec2;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::{Gpu, shader, texture};
use ocean_globe::model::{foam, noise, sea_state};
use ocean_globe::pass;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import lace
struct Asked { at: vec2f, share: f32, young: f32, footprint: f32, texels: f32, finer: i32, coarse: u32 }
struct Found { covered: f32, white: f32, mean_white: f32, open: f32, foam: f32, dense: f32, plume: f32, mean_plume: f32, film: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn foamy(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let own = asked[id.x];
    // Ways along the rows of the middle net's tile, which lies turned to the wind.
    let wind = wave_cells[0].wind;
    let way = frame.foam_levels[0].side * own.texels * inverseSqrt(17.0) * vec2f(4.0, 1.0);
    let seen = lace_at(own.at + vec2f(wind.y * way.y - wind.x * way.x, -wind.y * way.x - wind.x * way.y), own.footprint, own.finer, own.coarse == 0u);
    let dense = dense_from(own.young);
    let foam = foam_of(own.share, dense, 1.0, seen, true);
    let mean = mean_foam(own.share, dense, 1.0, true);
    found[id.x] = Found(covered(excess(own.share, seen.level.x), seen.hidden.x), foam.white, mean.white, foam.open, seen.level.x, seen.level.z,
        foam.plume, mean.plume, seen.level.y);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [f32; 2],
    share: f32,
    young: f32,
    footprint: f32,
    /// Texels of the lace from there along the middle net's tile.
    texels: f32,
    /// How many times smaller the lace is.
    finer: i32,
    /// 1: as at `quality=low` and on beaches.
    coarse: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Found {
    covered: f32,
    white: f32,
    /// Opacity where pixels hide the lace.
    mean_white: f32,
    open: f32,
    /// Levels of all foam and of dense foam.
    foam: f32,
    dense: f32,
    /// Share of the water below that is full of bubbles, and where pixels hide the lace.
    plume: f32,
    mean_plume: f32,
    /// Level of the film.
    film: f32,
}

/// Shares of the water that break: of a breeze, whose foam has neither rows nor a film, and of a storm.
const BREEZE: f32 = 0.005;
const STORM: f32 = 0.2;
const SHARES: [f32; 6] = [0.01, 0.03, 0.1, 0.3, 0.6, 0.9];
const POINTS: i32 = 131_072;

/// Layouts and bind groups of a kernel that reads the frame and the lace.
pub fn lace_groups(gpu: &Gpu, frame: &Frame) -> ([wgpu::BindGroupLayout; 2], [wgpu::BindGroup; 2]) {
    // The lace alone is read of bind group 1, at its last binding.
    let surface = [Bind::Texture(wgpu::TextureViewDimension::D2); 12];
    let layouts = [kernel::frame_layout(gpu), gpu.layout("surface", wgpu::ShaderStages::COMPUTE, &surface)];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let lace = pass::foam::empty_lace(gpu);
    pass::foam::fill_lace(gpu, &lace);
    let tile = texture::view(&lace);
    let groups = [
        kernel::frame_group(gpu, &layouts[0], &uniform, &frame.wave_cells),
        gpu.bind("surface", &layouts[1], &surface.map(|_| wgpu::BindingResource::TextureView(&tile))),
    ];
    (layouts, groups)
}

struct Lace {
    gpu: Gpu,
    groups: [wgpu::BindGroup; 2],
    kernel: Kernel<1>,
    places: Vec<[f32; 2]>,
    wind: [f32; 2],
}

impl Lace {
    fn new(breaking: f32) -> Self {
        Self::around_eye(breaking, [0; 2])
    }

    /// For an eye so many texels farther down the wind and across it.
    fn around_eye(breaking: f32, moved: [i32; 2]) -> Self {
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let camera = Camera::from_degrees(10.0, -30.0, 10.0, 0.0, 0.0);
        let mut frame = Frame::new(&Settings::default(), &camera, 1.7e9, [64; 2]);
        frame.uniform.whitecaps = breaking.min(0.25);
        frame.uniform.film = DVec2::from(foam::film(f64::from(breaking))).as_vec2();
        frame.uniform.lace_texel = [0, 1].map(|axis| frame.uniform.lace_texel[axis] + moved[axis]);
        // As high as a gale's: dense foam lies in its widest masses.
        frame.uniform.wave_height = 6.0;
        let (layouts, groups) = lace_groups(&gpu, &frame);
        let kernel = Kernel::new(&gpu, &shader::composed(KERNEL, ""), "foamy", &layouts.each_ref());
        // Over ten kilometres: hundreds of the rows' tiles, which are 128 m by 2 km.
        let place =
            |n| noise::bits(7, 5, n, 0).map(|bits| 10_000.0 * ((bits >> 40) as f32 / (1u32 << 24) as f32 - 0.5));
        let wind = [frame.wave_cells[0].wind.x, frame.wave_cells[0].wind.y];
        Self { gpu, groups, kernel, places: (0..POINTS).map(place).collect(), wind }
    }

    fn found(&self, asked: impl Fn([f32; 2]) -> Asked) -> Vec<Found> {
        let asked: Vec<_> = self.places.iter().map(|&at| asked(at)).collect();
        let [found] = self.kernel.run::<_, Found>(&self.gpu, &self.groups.each_ref(), &asked);
        found
    }

    /// What lies at all places, of foam that was born when it covered everything.
    fn aged(&self, share: f32, footprint: f32) -> Vec<Found> {
        let young = share.powf((foam::LIFETIME_S / foam::YOUNG_S) as f32);
        self.found(|at| Asked { at, share, young, footprint, texels: 0.0, finer: 1, coarse: 0 })
    }

    /// Means over all places of what is covered and of the opacity, and what the opacity is where pixels hide the lace.
    fn of(&self, share: f32, footprint: f32) -> [f64; 3] {
        let found = self.aged(share, footprint);
        [|f: &Found| f.covered, |f: &Found| f.white, |f: &Found| f.mean_white]
            .map(|part| found.iter().map(|f| f64::from(part(f))).sum::<f64>() / found.len() as f64)
    }

    /// Correlations of the levels of all foam and of dense foam with those so many texels farther on along the middle net's tile.
    fn correlations(&self, texels: f32) -> [f64; 2] {
        let [foam, dense, _] = self.correlated([0.0; 2], texels);
        [foam, dense]
    }

    /// Correlation of the level of all foam with that so many metres down the wind and across it.
    fn correlation_along(&self, way: [f32; 2]) -> f64 {
        self.correlations_along(way)[0]
    }

    /// As `correlation_along`, of all foam, of dense foam and of the film.
    fn correlations_along(&self, [down, across]: [f32; 2]) -> [f64; 3] {
        let [x, y] = self.wind;
        self.correlated([-x * down + y * across, -y * down - x * across], 0.0)
    }

    /// Correlations with the levels at places moved by metres of the map and texels of the lace.
    fn correlated(&self, moved: [f32; 2], texels: f32) -> [f64; 3] {
        let levels = |moved: [f32; 2], texels| {
            self.found(|[x, y]| Asked {
                at: [x + moved[0], y + moved[1]],
                share: 0.1,
                young: 0.1,
                footprint: 0.02,
                texels,
                finer: 1,
                coarse: 0,
            })
        };
        let (here, there) = (levels([0.0; 2], 0.0), levels(moved, texels));
        [|f: &Found| f64::from(f.foam), |f: &Found| f64::from(f.dense), |f: &Found| f64::from(f.film)].map(|level| {
            let product = |a: &[Found], b: &[Found]| a.iter().zip(b).map(|(a, b)| level(a) * level(b)).sum::<f64>();
            product(&here, &there) / (product(&here, &here) * product(&there, &there)).sqrt()
        })
    }
}

#[test]
fn lace_covers_its_share_whatever_pixels_are_wide() {
    for whitecaps in [BREEZE, STORM] {
        let lace = Lace::new(whitecaps);
        for footprint in (0..=22).map(|n| 0.005 * 2f32.powf(n as f32 * 0.75)) {
            let found = SHARES.map(|share| (share, lace.of(share, footprint)));
            println!(
                "{whitecaps}, {footprint:.3} m: {:.3?}",
                found.map(|(share, [covered, ..])| covered / f64::from(share))
            );
            println!("    opacity {:.3?}", found.map(|(_, [_, white, mean])| white / mean));
            for (share, [covered, white, mean]) in found {
                // Levels have 254 steps, and what pixels leave of them has somewhat shorter tails than a normal number: found are 3 %
                // at a share of 3 %, 6 % at one of 1 %, and 1 % from 10 % on.
                let allowed = if share < 0.02 { 0.065 } else { 0.035 };
                let share = f64::from(share);
                assert!((covered / share - 1.0).abs() < allowed, "{whitecaps}, {footprint} m: {covered} of {share}");
                assert!(
                    (white / mean - 1.0).abs() < allowed,
                    "{whitecaps}, {footprint} m: {white} for {mean} at {share}"
                );
            }
        }
    }
}

/// Opacity of the water of a Beaufort grade by all foam and film on it, from so high up that no pixel shows single ones, and the greatest anywhere.
fn whiteness(grade: u8) -> [f64; 2] {
    let speed = sea_state::speed_from_beaufort(f64::from(grade));
    let (share, lace) =
        (sea_state::whitecap_fraction(speed) as f32, Lace::new(sea_state::breaking_fraction(speed) as f32));
    let greatest = |share| lace.aged(share, 0.05).iter().map(|f| f64::from(f.white)).fold(0.0, f64::max);
    [lace.of(share, 1e4)[2], greatest(share).max(greatest(0.9))]
}

#[test]
fn seas_are_as_white_as_the_beaufort_scale_says() {
    let found = [4, 6, 8, 10, 12].map(whiteness);
    println!("opacity of grades 4 to 12 and the greatest anywhere: {found:.3?}");
    let [breeze, strong, gale, storm, hurricane] = found.map(|[mean, _]| mean);
    // Fairly frequent white horses; white crests everywhere; well-marked streaks; the surface as a whole is white; it is completely white. Water sends a
    // twentieth of dense foam's light back: where foam covers a quarter, most of the light is its own.
    assert!(breeze < 0.02 && strong < 0.06 && gale < 0.2, "{found:?}");
    assert!(storm > 2.0 * gale && storm > 0.25 && hurricane > 1.2 * storm, "{found:?}");
    assert!(found.iter().all(|[_, greatest]| *greatest <= 1.0 + 1e-5), "{found:?}");
}

#[test]
fn whitecaps_reflect_what_is_measured_over_their_lives() {
    let lace = Lace::new(BREEZE);
    // Foam that decays exponentially covers as much at any share as at any other.
    const AGES: usize = 50;
    let shares = (0..AGES).map(|k| (k as f32 + 0.5) / AGES as f32);
    let mean = shares.map(|share| 0.55 * lace.of(share, 1e4)[2] / f64::from(share)).sum::<f64>() / AGES as f64;
    println!("{mean:.3}");
    // P. Koepke 1984: 0.22 with 0.11 either way.
    assert!((0.11..0.33).contains(&mean), "{mean}");
}

/// Texels of the lace along a tile of its middle net: 31 m.
const TILE: f32 = 512.0 / 4.123_105_6;

#[test]
fn the_lace_does_not_repeat_with_its_tile() {
    let lace = Lace::new(BREEZE);
    let found = [1.0, 2.0, 3.0].map(|tiles| lace.correlations(tiles * TILE));
    println!("{found:.3?}");
    for [foam, dense] in found {
        // Where the nets lay still it would be the middle net's part of the variance: 0.42, and of dense foam 0.4 or more.
        assert!(foam.abs() < 0.2 && dense.abs() < 0.2, "{foam} and {dense}");
    }
}

#[test]
fn dense_foam_lies_in_masses_wider_than_the_lace() {
    let lace = Lace::new(BREEZE);
    // Four texels are 1 m: as wide as the meshes of old foam.
    let [foam, dense] = lace.correlations(4.0);
    println!("{foam:.3} and {dense:.3}");
    assert!(dense > foam + 0.07, "{dense} and {foam}");
}

#[test]
fn storms_draw_foam_out_along_the_wind() {
    // What is left of the level 3 m on: farther than the meshes of old foam are wide. In a breeze the nets are drawn out by two, in a storm streaks by 32, and rows.
    let [breeze, storm] =
        [BREEZE, STORM].map(Lace::new).map(|lace| [[3.0, 0.0], [0.0, 3.0]].map(|way| lace.correlation_along(way)));
    println!("down the wind and across it: breeze {breeze:.3?}, storm {storm:.3?}");
    assert!(storm[0] - storm[1] > 0.2 && storm[0] > 0.5, "{storm:?}");
    assert!((breeze[0] - breeze[1]).abs() < 0.1, "{breeze:?}");
}

#[test]
fn creases_of_dense_foam_are_dark_but_take_no_light_from_the_whole() {
    let lace = Lace::new(BREEZE);
    for footprint in [0.01, 0.05, 0.25] {
        let found = lace.found(|at| Asked { at, share: 0.7, young: 0.6, footprint, texels: 0.0, finer: 1, coarse: 0 });
        let white: f64 = found.iter().map(|f| f64::from(f.white)).sum();
        let mean = found.iter().map(|f| f64::from(f.white * f.open)).sum::<f64>() / white;
        let spread = found.iter().map(|f| f64::from(f.white) * (f64::from(f.open) - mean).powi(2)).sum::<f64>() / white;
        println!("{footprint} m: {mean:.3}, deviation {:.3}", spread.sqrt());
        // Levels of the nets, each normal, are not quite so together.
        assert!((mean - 1.0).abs() < 0.03, "{footprint} m: {mean}");
        if footprint < 0.02 {
            assert!(spread.sqrt() > 0.1, "flat: {}", spread.sqrt());
        }
    }
}

#[test]
fn streaks_of_storms_wind_and_end() {
    let storm = Lace::new(STORM);
    // The film is nearly all streaks; straight ones leave 0.47 after 12 m, and these 0.40.
    let found = [3.0, 6.0, 12.0, 25.0, 50.0].map(|down| storm.correlations_along([down, 0.0])[2]);
    println!("down the wind: {found:.3?}");
    assert!(found[2] < 0.43 && found[0] > 0.5, "{found:?}");
}

#[test]
fn dense_foam_of_storms_has_heaps_that_are_seen_from_afar() {
    let light = |breaking, footprint| {
        let found = Lace::new(breaking).found(|at| Asked {
            at,
            share: 0.9,
            young: 0.85,
            footprint,
            texels: 0.0,
            finer: 1,
            coarse: 0,
        });
        let white: f64 = found.iter().map(|f| f64::from(f.white)).sum();
        let mean = found.iter().map(|f| f64::from(f.white * f.open)).sum::<f64>() / white;
        let squares = found.iter().map(|f| f64::from(f.white) * (f64::from(f.open) - mean).powi(2)).sum::<f64>();
        [mean, (squares / white).sqrt()]
    };
    for footprint in [0.02, 0.1, 0.25, 0.7, 1.5] {
        let [mean, storm] = light(STORM, footprint);
        let [_, breeze] = light(BREEZE, footprint);
        println!("{footprint} m: {mean:.3}, deviation {storm:.3}; in a breeze {breeze:.3}");
        assert!((mean - 1.0).abs() < 0.03, "{footprint} m: {mean}");
        // As long as pixels are a hundred metres off, or so, which hide what a breeze has, 4 m wide at most.
        if footprint == 0.7 {
            assert!(storm > 0.1 && storm > 2.0 * breeze, "{storm} {breeze}");
        }
    }
}

#[test]
fn what_covers_the_sea_in_storms_is_not_flat_where_nothing_breaks() {
    let found = Lace::new(STORM).found(|at| Asked {
        at,
        share: 0.5,
        young: 1e-4,
        footprint: 0.02,
        texels: 0.0,
        finer: 1,
        coarse: 0,
    });
    let covered: Vec<_> = found.iter().filter(|f| f.white > 0.8).map(|f| f64::from(f.open)).collect();
    let mean = covered.iter().sum::<f64>() / covered.len() as f64;
    let deviation = (covered.iter().map(|open| (open - mean).powi(2)).sum::<f64>() / covered.len() as f64).sqrt();
    println!("{} of {POINTS} places white: light {mean:.3}, deviation {deviation:.3}", covered.len());
    assert!(covered.len() > 1000 && deviation > 0.1 && (mean - 1.0).abs() < 0.05, "{mean} {deviation}");
}

#[test]
fn storms_stir_bubbles_into_the_water_between_their_foam() {
    let between = |breaking| {
        let lace = Lace::new(breaking);
        let found = lace.aged(0.05, 0.05);
        let clear = found.iter().filter(|f| f.white < 0.05);
        let least = clear.map(|f| f.plume).fold(f32::MAX, f32::min);
        [least, lace.aged(0.05, 1e4)[0].mean_plume]
    };
    let ([breeze, _], [storm, from_afar]) = (between(BREEZE), between(STORM));
    // As the film covers 1 - exp(-3 of what breaks) of a storm's sea.
    let film = 1.0 - (-3.0 * STORM).exp();
    println!(
        "of a plume's bubbles in dark water: breeze {breeze:.3}, storm {storm:.3}, from afar {from_afar:.3}; film {film:.3}"
    );
    assert!(breeze < 0.05 && storm > 0.5 * film && from_afar >= storm, "{breeze} {storm} {from_afar}");
}

#[test]
fn the_lace_stays_in_its_place_when_the_eye_goes_on() {
    // Texels of 0.25 m; beaches have a lace four times as small.
    const MOVED: [i32; 2] = [371, -226];
    const TEXEL_M: f32 = 0.25;
    let (here, there) = (Lace::new(STORM), Lace::around_eye(STORM, MOVED));
    let way = MOVED.map(|texels| TEXEL_M * texels as f32);
    let [x, y] = here.wind;
    // The way on the map, of one along the wind and across it.
    let moved = [-x * way[0] + y * way[1], -y * way[0] - x * way[1]];
    for (finer, coarse) in [(1, 0), (1, 1), (4, 1)] {
        let ask = |lace: &Lace, from: [f32; 2]| {
            lace.found(|at| Asked {
                // Within 100 m, whose coordinates lose less than a hundred-thousandth of a texel.
                at: [0, 1].map(|axis| 0.01 * at[axis] - from[axis]),
                share: 0.3,
                young: 0.1,
                footprint: 0.02,
                texels: 0.0,
                finer,
                coarse,
            })
        };
        let (before, after) = (ask(&here, [0.0; 2]), ask(&there, moved));
        let off = before.iter().zip(&after).map(|(a, b)| (a.foam - b.foam).abs()).fold(0.0, f32::max);
        println!("{finer} times as small: levels change by {off}");
        // A sampler knows places to a 256th of a texel, along which a level rises by one at most; weights of the four nets add up to two at most, and
        // each of both looks errs. As much again for coordinates in 32 bits. The lace of another place is off by several.
        assert!(off < 2.0 * 2.0 * 2.0 / 256.0 + 0.01, "{finer} times as small, coarse {coarse}: {off}");
    }
}
