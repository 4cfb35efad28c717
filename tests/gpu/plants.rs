//! What stands on the ground leaves the ground as bright as it is, and stands upright in one place for every eye.

use bytemuck::{Pod, Zeroable};
use ocean_globe::model::noise;
use ocean_globe::pass::land::GROWTH_M;

use crate::kernel;

const KERNEL: &str = "#import plants
const EARTH_TURN: Metres = 40075016.686;
struct Asked { at: vec2u, sight: vec2f, sun: vec2f, share: f32, green: f32, size: u32, unused: u32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<array<f32, 6>>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let lattice = lattice_of(a.size);
    let here = domes(FinePoint(a.at, vec2f(0.0)), lattice, a.share, a.green, a.sight, a.sun, 0.02, false);
    let dome = dome_of(a.at, lattice, a.share, a.green);
    found[id.x] = array(here.cover, here.tone, dome_cover(lattice, a.share, a.green), mean_tone(lattice, a.share, a.green), here.shade, dome.radius);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    sight: [f32; 2],
    sun: [f32; 2],
    share: f32,
    green: f32,
    size: u32,
    unused: u32,
}

impl Asked {
    /// Half the cells of trees on green ground, from above, the sun in the zenith.
    const TREES: Self = Self { at: [0; 2], sight: [0.0; 2], sun: [0.0; 2], share: 0.5, green: 1.0, size: 1, unused: 0 };
}

/// Of each asked place: cover and tone as drawn, cover and tone as their means are said to be, shade, radius of the dome in the cell of that number.
fn answers(asked: &[Asked]) -> Vec<[f32; 6]> {
    kernel::answers(KERNEL, asked)
}

const COUNT: i32 = 50_000;

fn places() -> impl Iterator<Item = [u32; 2]> {
    (0..COUNT).map(|n| noise::bits(3, 1, n, 0)[0]).map(|bits| [bits as u32, (bits >> 32) as u32])
}

/// Means over the plane: cover and tone as drawn, and as they are said to be, and shade.
fn means(like: Asked) -> [f64; 5] {
    let asked: Vec<_> = places().map(|at| Asked { at, ..like }).collect();
    let found = answers(&asked);
    std::array::from_fn(|part| found.iter().map(|f| f64::from(f[part])).sum::<f64>() / f64::from(COUNT))
}

#[test]
fn plants_leave_the_grounds_mean() {
    for (share, green, size) in [(0.1, 0.0, 3), (0.3, 0.5, 1), (0.5, 1.0, 2), (0.4, 0.7, 0), (0.98, 1.0, 4)] {
        let [cover, tone, told_cover, told_tone, _] = means(Asked { share, green, size, ..Asked::TREES });
        println!(
            "share {share}, green {green}: {cover:.4} covered of {told_cover:.4}, tone {tone:.4} of {told_tone:.4}"
        );
        // Numbers of 8 bits are 1/512 off a share, and three deviations of chance are 0.007 of cover and of tone.
        assert!((cover - told_cover).abs() < 0.011, "{cover} for {told_cover}");
        assert!((tone - told_tone).abs() < 0.011, "{tone} for {told_tone}");
    }
}

#[test]
fn slanted_sights_meet_more_of_what_stands_upright() {
    for turn in [[1.0, 0.0], [0.0, -1.0], [-0.6, 0.8]] {
        let cover = [0.0, 1.5, 4.0]
            .map(|far: f32| means(Asked { sight: turn.map(|x: f32| x * far), share: 0.3, size: 2, ..Asked::TREES })[0]);
        println!("along {turn:?}: {cover:.3?} covered");
        // The shadow of a half ball, squeezed to 0.9, in light that goes 1.5 its way aside: an ellipse's half beyond the disc's, 1 and 1.25 of
        // it; 4: 1 and 2.1. Of teeth in the outline a quarter may be missing, and shadows overlap.
        assert!(cover[1] > 1.05 * cover[0] && cover[2] > 1.3 * cover[0], "{cover:?}");
        assert!(cover[1] < 1.5 * cover[0] && cover[2] < 3.2 * cover[0], "{cover:?}");
    }
}

/// Points along a side of a square of 16 by 16 cells of trees, and units of the map between them: a cell is 2^11 units over the square root of 5.
const SIDE: u32 = 512;
const STEP: u32 = 16 * 916 / SIDE;

fn square(like: Asked) -> Vec<[f32; 6]> {
    let place = |i: u32| [i % SIDE, i / SIDE].map(|x| (1 << 30) + x * STEP);
    answers(&(0..SIDE * SIDE).map(|i| Asked { at: place(i), ..like }).collect::<Vec<_>>())
}

#[test]
fn no_plant_is_a_smooth_disc() {
    let found = square(Asked { share: 0.3, ..Asked::TREES });
    let covered = |x: u32, y: u32| found[(y * SIDE + x) as usize][0] > 0.5;
    let area = found.iter().filter(|f| f[0] > 0.5).count();
    let changes = (0..SIDE)
        .flat_map(|a| (1..SIDE).map(move |b| (a, b)))
        .map(|(a, b)| u32::from(covered(b, a) != covered(b - 1, a)) + u32::from(covered(a, b) != covered(a, b - 1)))
        .sum::<u32>();
    // A disc of radius r has 8 r such changes; n of them with that area together have the most where they are alike. Chance puts a tenth
    // more or fewer domes into 256 cells.
    let most = 8.0 * (1.1 * 0.3 * 256.0 * area as f64 / std::f64::consts::PI).sqrt();
    println!("{area} points of {} covered, {changes} changes, discs have {most:.0}", SIDE * SIDE);
    assert!(f64::from(changes) > 1.2 * most, "{changes} changes for {most}");
}

#[test]
fn plants_cast_shadows_away_from_the_sun() {
    // Light that goes two right on the map while it sinks by one: the sun stands on the left, 27° high.
    let found = square(Asked { sun: [2.0, 0.0], share: 0.3, ..Asked::TREES });
    // So far is a dome's middle from the middle of its shadow, as a rule.
    let way = SIDE / 16 * 3 / 8;
    let dark = (0..SIDE * SIDE).filter(|i| (way..SIDE - way).contains(&(i % SIDE)) && found[*i as usize][4] > 0.5);
    let (mut left, mut right, mut all) = (0, 0, 0);
    for i in dark {
        left += u32::from(found[(i - way) as usize][0] > 0.5);
        right += u32::from(found[(i + way) as usize][0] > 0.5);
        all += 1;
    }
    println!("{all} points in shadow, {left} with a plant on the left, {right} on the right");
    assert!(f64::from(all) > 0.02 * f64::from(SIDE * SIDE) && left > 2 * right && 2 * left > all);
}

/// Radii of the domes of 64 by 64 cells of trees.
fn radii() -> Vec<f32> {
    let cells = (0..64 * 64).map(|i| Asked { at: [1_000 + i % 64, 5_000 + i / 64], share: 0.3, ..Asked::TREES });
    answers(&cells.collect::<Vec<_>>()).iter().map(|f| f[5]).collect()
}

#[test]
fn trees_stand_in_groups_and_most_are_small() {
    let radii = radii();
    let counts: Vec<f64> = (0..32 * 32)
        .map(|b| {
            let first = b % 32 * 2 + b / 32 * 2 * 64;
            [0, 1, 64, 65].iter().filter(|away| radii[first + *away] > 0.0).count() as f64
        })
        .collect();
    let mean = counts.iter().sum::<f64>() / counts.len() as f64;
    let variance = counts.iter().map(|n| (n - mean).powi(2)).sum::<f64>() / counts.len() as f64;
    // Were each cell's chance its own: the binomial distribution's variance, which 1,024 groups tell within a tenth.
    let single = mean * (1.0 - mean / 4.0);
    let mut stand: Vec<f32> = radii.iter().copied().filter(|r| *r > 0.0).collect();
    stand.sort_unstable_by(f32::total_cmp);
    let [median, large] = [50, 95].map(|percent| stand[percent * stand.len() / 100]);
    println!(
        "{mean:.2} of 4 cells, variance {variance:.2} for {single:.2}; radii {median:.3}, of a twentieth {large:.3}"
    );
    assert!(variance > 1.2 * single, "{variance} for {single}");
    assert!(large > 1.5 * median, "{median} and {large}");
}

const FIELDS: &str = "#import fields
const EARTH_TURN: Metres = 40075016.686;
@group(2) @binding(0) var<storage, read> asked: array<vec2u>;
@group(2) @binding(1) var<storage, read_write> found: array<array<f32, 3>>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let here = fields_at(asked[id.x], vec2f(0.0), 1.0);
    found[id.x] = array(here.tone, here.ripe, here.hedge);
}";

#[test]
fn fields_and_hedges_leave_the_grounds_mean() {
    let asked: Vec<[u32; 2]> = places().collect();
    let found: Vec<[f32; 3]> = kernel::answers(FIELDS, &asked);
    let sums = |of: fn(f64) -> f64| {
        [0, 1, 2].map(|part| found.iter().map(|f| of(f64::from(f[part]))).sum::<f64>() / f64::from(COUNT))
    };
    let (means, squares) = (sums(|x| x), sums(|x| x * x));
    println!("tone, ripe, hedge: means {means:.4?}, squares {squares:.4?}");
    // Uniform numbers from -1 to 1 have a square of a third, so that four deviations of chance are 0.0103 of either; of hedges, on
    // 0.07 0.5 1.625 = 0.057 of the land, 0.0041, and their crossings, 0.0008, are counted once instead of twice.
    for (part, bound) in [0.0103, 0.0103, 0.0049].into_iter().enumerate() {
        assert!(means[part].abs() < bound, "{means:?}");
    }
    // They are there.
    assert!((squares[0] - 1.0 / 3.0).abs() < 0.01 && (squares[2] - 0.0536).abs() < 0.01, "{squares:?}");
}

const STANDING: &str = "#import plants
const EARTH_TURN: Metres = 40075016.686;
@group(2) @binding(0) var<storage, read> footprints: array<f32>;
@group(2) @binding(1) var<storage, read_write> found: array<array<f32, 4>>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&footprints) { return; }
    let at = FinePoint(vec2u(1000000u, 2000000u) + 40000u * vec2u(id.x % 16u, id.x / 16u), vec2f(0.0));
    let stands = plants(at, 0.5, 0.5, 1.0, vec4f(0.5), 0.0, 1.0, vec2f(1.0), vec2f(1.0), 30000.0, footprints[id.x], footprints[id.x]);
    found[id.x] = array(stands.tone, length(stands.rise), stands.cover, stands.shade);
}";

/// Pictures whose pixels are all so wide are drawn without what grows: nothing may be missing there, and what is barely narrower must show
/// some, or the bound is farther off than it need be.
#[test]
fn nothing_that_grows_shows_in_pixels_that_leave_it_out() {
    let seen = |footprint: f64| {
        let found: Vec<[f32; 4]> = kernel::answers(STANDING, &[footprint as f32; 256]);
        found.into_iter().flatten().fold(0.0_f32, |most, part| most.max(part.abs()))
    };
    let [left_out, narrower] = [GROWTH_M, 0.8 * GROWTH_M].map(seen);
    println!("{left_out} is seen where pixels are {GROWTH_M} m wide, {narrower:.4} where they are four fifths of that");
    assert_eq!(left_out, 0.0);
    assert!(narrower > 0.01);
}

const FARMED: &str = "#import fields
const EARTH_TURN: Metres = 40075016.686;
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let at = asked[id.x];
    // As green and as bright as meadows, where nothing but slope and climate keeps farmers away.
    found[id.x] = farmed(vec3f(0.06, 0.09, 0.03), 1.0, at.z, at.y, at.x, 1.0);
}";

#[test]
fn farms_are_where_it_is_level_and_neither_too_high_nor_too_cold() {
    // Degrees north, metres high, slope: Skåne, Kansas, Castile, Anatolia, the highlands of Ethiopia, by Calgary and by Idaho Falls; the mountains of the Gobi, pastures of the Alps, Tibet,
    // fells of Norway, a valley's side in Umbria, the tundra of Yamal.
    let farms = [
        (55.6, 50.0, 0.0),
        (38.5, 600.0, 0.01),
        (41.6, 850.0, 0.01),
        (38.0, 1_000.0, 0.02),
        (9.0, 2_400.0, 0.02),
        (51.0, 1_030.0, 0.0),
        (43.5, 1_430.0, 0.0),
    ];
    let wild = [
        (43.5, 2_300.0, 0.03),
        (46.6, 2_000.0, 0.04),
        (33.0, 4_500.0, 0.02),
        (61.0, 1_100.0, 0.02),
        (43.0, 400.0, 0.2),
        (70.0, 20.0, 0.0),
    ];
    let share = |places: &[(f64, f64, f64)]| -> Vec<f32> {
        let asked: Vec<[f32; 4]> = places
            .iter()
            .map(|(lat, m, slope)| [lat.to_radians().sin() as f32, *m as f32, *slope as f32, 0.0])
            .collect();
        kernel::answers(FARMED, &asked)
    };
    let [farms, wild] = [share(&farms), share(&wild)];
    println!("farms {farms:.2?}, wild {wild:.2?}");
    assert!(farms.iter().all(|share| *share == 1.0) && wild.iter().all(|share| *share == 0.0), "{farms:?}, {wild:?}");
}

const TILLAGE: &str = "#import imagery
@group(2) @binding(0) var<storage, read> asked: array<vec2u>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let meadow = vec3f(0.06, 0.09, 0.03);
    found[id.x] = vec2f(farmed(meadow, 1.0, 0.0, 0.0, 0.7, ground_detail(asked[id.x], 1.0).tillage), farmed(meadow, 1.0, 0.0, 0.0, 0.7, NO_DETAIL.tillage));
}";

/// Pictures whose pixels are too wide for any of the ground's detail have as much farmland as the mean of those that show where it lies.
#[test]
fn there_is_as_much_farmland_from_space_as_from_near() {
    let asked: Vec<[u32; 2]> = (0..16_384).map(|i| [noise::hash([i, 1, 7]), noise::hash([i, 2, 7])]).collect();
    let found: Vec<[f32; 2]> = kernel::answers(TILLAGE, &asked);
    let mean = |which: usize| found.iter().map(|one| f64::from(one[which])).sum::<f64>() / found.len() as f64;
    let [near, space] = [0, 1].map(mean);
    println!("farms cover {near:.3} of meadows near, {space:.3} from space");
    // Shares deviate by less than a half: the mean of so many by 0.004.
    assert!((near - space).abs() < 0.016, "{near} and {space}");
}
