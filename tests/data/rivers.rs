//! Rivers: lines of a listing as GMT prints them, baked into a small world and into the bundled one.

use crate::bake_coast::{polygons, rectangle};
use crate::small_world::{Folder, baked, coast};
use ocean_globe::cli::bake::{BakeArgs, bake};
use ocean_globe::data::TileTexels;
use ocean_globe::data::coast::Stream;
use ocean_globe::data::tile::{Layer, MapPoint, TILE_TEXELS, TileId};
use ocean_globe::data::water::{BY_RIVER, WaterClass, unpacked};
use ocean_globe::data::world::World;
use std::fs;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// A degree of the equator, metres.
const DEGREE_M: f64 = 111_319.5;
/// Noise moves lines by less than this but for one in a hundred places, and their points are true to a unit of the tiles; metres.
const MOVED_M: f64 = 150.0;

fn arguments(folder: &Folder) -> BakeArgs {
    BakeArgs { rivers: Some(folder.path().join("rivers.txt")), coast_zoom: 7, ..coast(folder.path()) }
}

/// A square of land with a lake; a great river from the south into the lake, one of its tributaries, and one that is too small.
fn made(name: &str) -> Folder {
    let folder = baked(name);
    let square = |level, west_east, south_north| (level, "x", rectangle(west_east, south_north));
    polygons(folder.path(), &[square(1, [0.0, 4.0], [-2.0, 2.0]), square(2, [1.0, 2.0], [0.5, 1.5])]);
    fs::write(folder.path().join("ponds.txt"), "").unwrap();
    let line = |rank: u8, points: &[[f64; 2]]| {
        let points: String = points.iter().map(|[lon, lat]| format!("{lon}\t{lat}\n")).collect();
        format!("> River Bin # 1, Level {rank}\n{points}")
    };
    let rivers = [
        line(1, &[[1.5, -1.5], [1.5, -0.6], [1.5, 0.6]]),
        line(2, &[[3.0, -0.5], [2.2, -0.5], [1.5, -0.5]]),
        line(3, &[[3.5, -1.0], [3.5, 1.0]]),
    ];
    fs::write(folder.path().join("rivers.txt"), rivers.concat()).unwrap();
    bake(&arguments(&folder)).unwrap();
    folder
}

/// Places every 5 m across a line that goes north or east through a place, and what covers them.
fn across(world: &mut World, [lat, lon]: [f64; 2], northward: bool) -> Vec<(f64, WaterClass)> {
    let steps = (-160..=160).map(|i| 5.0 * f64::from(i));
    let place = |metres: f64| {
        let away = metres / DEGREE_M;
        if northward { [lat, lon + away] } else { [lat + away, lon] }
    };
    let class = |[lat, lon]: [f64; 2]| world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap().class;
    steps.clone().zip(steps.map(place).map(class)).collect()
}

#[test]
fn rivers_are_as_wide_as_their_rank_and_run_into_lakes() {
    let folder = made("rivers-width");
    let mut world = World::open(folder.path().to_str().unwrap());
    for (stream, at, northward) in [
        (Stream::River, [-1.2, 1.5], true),
        (Stream::River, [-0.3, 1.5], true),
        (Stream::River, [0.2, 1.5], true),
        (Stream::Tributary, [-0.5, 2.0], false),
        (Stream::Tributary, [-0.5, 2.7], false),
    ] {
        let wet: Vec<f64> = across(&mut world, at, northward)
            .into_iter()
            .filter_map(|(metres, class)| (class == WaterClass::River).then_some(metres))
            .collect();
        let (first, last) = (wet[0], wet[wet.len() - 1]);
        println!("{stream:?} at {at:?}: from {first} to {last} m");
        assert_eq!((last - first) / 5.0, wet.len() as f64 - 1.0, "{at:?} has land in it");
        // A bend by noise makes a cut across it longer, steps cut 10 m off.
        let width = (last - first) / stream.width_m();
        assert!((0.92..1.15).contains(&width), "{at:?} is {width} of its width");
        assert!((0.5 * (first + last)).abs() < MOVED_M, "{at:?} is off by {first} to {last}");
    }
    // Into the lake without land between; what is left out is land.
    for step in 0..60 {
        let at = [0.44 + 0.002 * f64::from(step), 1.5];
        let wet = across(&mut world, at, true).into_iter().filter(|(_, class)| class.is_wet()).count();
        assert!(wet > 70, "{wet} wet places at {at:?}");
    }
    let mut class = |lat: f64, lon: f64| world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap().class;
    assert_eq!(class(1.0, 1.5), WaterClass::Lake);
    assert_eq!(class(-1.0, 2.5), WaterClass::Land);
    assert_eq!(class(-0.9, -0.1), WaterClass::Ocean);
    assert!(across(&mut world, [0.0, 3.5], true).iter().all(|(_, class)| *class == WaterClass::Land));
    assert!(world.sample_blocking(0.0, 3f64.to_radians()).unwrap().lake_distance_m.unwrap() < 0.0);
}

#[test]
fn listings_that_are_none_are_refused() {
    let folder = made("rivers-refused");
    for (listing, part) in [
        ("10 20\n", "line 1"),
        ("> River\n1 2\n3 4\n", "Level"),
        ("> River Bin # 1, Level 77\n1 2\n3 4\n", "Level"),
        ("> River Bin # 1, Level 1\n1 2\n", "less than two points"),
        ("> River Bin # 1, Level 1\n1 2\n> River Bin # 2, Level 1\n1 2\n3 4\n", "line 1"),
        ("> River Bin # 1, Level 1\n1 2\n3 x\n", "line 3"),
        ("> River Bin # 1, Level 1\n1 2\n3\n", "line 3"),
        ("> River Bin # 1, Level 1\n1 2\n3 4 5\n", "line 3"),
        ("> River Bin # 1, Level 1\n1 2\n3 95\n", "outside of the world"),
        ("> River Bin # 1, Level 1\n1 2\n-190 5\n", "outside of the world"),
        ("> River Bin # 1, Level 1\n1 2\nNaN 5\n", "outside of the world"),
    ] {
        fs::write(folder.path().join("rivers.txt"), listing).unwrap();
        let error = bake(&arguments(&folder)).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("rivers.txt"), "{listing}: {error}");
    }
    fs::write(folder.path().join("rivers.txt"), [0xff, 0xfe, 0x80]).unwrap();
    assert!(bake(&arguments(&folder)).is_err());
}

/// The bundled world with its archives open.
fn bundled() -> World {
    let mut world = World::open(DATA);
    world.sample_blocking(0.0, 0.0).unwrap();
    world
}

/// Steps to inland waters and marks of a tile's texels.
fn texels(world: &mut World, id: TileId) -> Option<Vec<(i32, u8)>> {
    let tile = world.tile_blocking(Layer::Water, id).unwrap()?;
    let TileTexels::Water(texels) = &*tile else { panic!() };
    Some(texels.iter().map(|texel| unpacked(*texel)).map(|([_, inland], marks)| (inland, marks)).collect())
}

/// Where great rivers flow: the Nile, the Rhine, the Mississippi, the Ganges.
const FLOWING: [[f64; 2]; 4] = [[25.7, 32.63], [50.94, 6.965], [29.95, -90.05], [25.3, 83.02]];

#[test]
fn rivers_have_no_seam_where_tiles_meet() {
    let mut world = bundled();
    let mut judged = [0; 2];
    for ([lat, lon], z) in FLOWING.into_iter().flat_map(|at| [6, 8, 9, 10, 11, 12, 13].map(|z| (at, z))) {
        let middle = MapPoint::from_lat_lon(f64::to_radians(lat), f64::to_radians(lon)).tile(z);
        for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
            let beside = |x: i32, y: i32| TileId {
                x: middle.x.wrapping_add_signed(dx + x),
                y: middle.y.wrapping_add_signed(dy + y),
                ..middle
            };
            let Some(own) = texels(&mut world, beside(0, 0)) else { continue };
            for (other, is_south) in [(beside(1, 0), false), (beside(0, 1), true)] {
                let Some(other) = texels(&mut world, other) else { continue };
                let last = TILE_TEXELS - 1;
                for i in 0..TILE_TEXELS {
                    let pair =
                        if is_south { [last * TILE_TEXELS + i, i] } else { [i * TILE_TEXELS + last, i * TILE_TEXELS] };
                    let [(a, own_marks), (b, marks)] = [own[pair[0]], other[pair[1]]];
                    // Beyond five texels the parent's distances come in, which know fewer rivers.
                    if a.abs() > 96 || (own_marks | marks) & BY_RIVER == 0 {
                        continue;
                    }
                    judged[usize::from(is_south)] += 1;
                    // A texel farther on a distance differs by one at most, and 1 step of rounding at both; narrow rivers' differ by more where the
                    // share gives way to the distance: by two and a half.
                    let allowed = if a.min(b) < -16 { 84 } else { 34 };
                    assert!((a - b).abs() <= allowed, "{middle} {dx} {dy} {i}: {a} beside {b}");
                }
            }
        }
    }
    assert!(judged.iter().all(|count| *count > 200), "{judged:?} places judged");
}

/// Rows of numbers.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    rows.map(|row| row.split(',').map(|number| number.parse().unwrap()).collect()).collect()
}

#[test]
fn the_data_banks_rivers_flow_where_it_has_them() {
    let mut world = World::open(DATA);
    let (mut dry, mut rivers) = ([Vec::new(), Vec::new()], 0);
    let points = rows(include_str!("../oracles/wdbii_between.csv"));
    for point in &points {
        let found = world.sample_blocking(point[0].to_radians(), point[1].to_radians()).unwrap();
        rivers += usize::from(found.class == WaterClass::River);
        if !found.class.is_wet() {
            dry[point[2] as usize - 1].push((point[0], point[1], found.lake_distance_m));
        }
    }
    println!(
        "{rivers} of {} in rivers; dry: {} of the great ones, {} of others",
        points.len(),
        dry[0].len(),
        dry[1].len()
    );
    // A line is true to 50 m, moved by 20 m as a rule, and 200 m or 75 m from its banks.
    assert!(rivers > 270, "{rivers}");
    assert!(dry[0].len() <= 3, "{:?}", dry[0]);
    assert!(dry[1].len() <= 15, "{:?}", dry[1]);
}

#[test]
fn a_river_narrower_than_texels_neither_breaks_up_nor_swells() {
    let mut world = bundled();
    // Along the Nile by Luxor: texels of 550 m and of 1,100 m, 0.7 and 0.36 of which it covers.
    for (z, covered) in [(8, 400.0 / 551.0), (7, 400.0 / 1_102.0)] {
        let (mut sums, mut judged) = (Vec::new(), 0);
        for point in rows(include_str!("../oracles/nile.csv")) {
            let at = MapPoint::from_lat_lon(point[0].to_radians(), point[1].to_radians());
            let (column, row) = at.texel(z);
            let tile = at.tile(z);
            let Some(texels) = texels(&mut world, tile) else { panic!("no tile {tile}") };
            // The shares of all texels in a square about the place, over the length of the river in it, which its slope tells.
            let [x, y] = [column, row].map(|at| at as usize % TILE_TEXELS);
            if x < 2 || y < 2 || x > 253 || y > 253 {
                continue;
            }
            let share = |x: usize, y: usize| (0.5 + f64::from(texels[y * TILE_TEXELS + x].0) / 32.0).clamp(0.0, 1.0);
            let across = |northward: bool| -> f64 {
                (0..5).map(|i| if northward { share(x + i - 2, y) } else { share(x, y + i - 2) }).sum()
            };
            // Across the river it is the shorter cut.
            sums.push(across(true).min(across(false)) / covered);
            judged += 1;
        }
        let [least, most] = [f64::min, f64::max].map(|of| sums.iter().copied().reduce(of).unwrap());
        println!("level {z}: a cut across holds {least:.2} to {most:.2} of the river, {judged} places");
        // Slanting cuts are up to 1.41 as long; the Gaussian's ends are cut off.
        assert!(judged > 30 && least > 0.7 && most < 1.7, "{z}: {least} {most}");
    }
}
