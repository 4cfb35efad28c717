//! The bundled world's coast against GSHHG's own shoreline points, islands and lakes, and its tiles against each other.

use std::collections::HashMap;
use std::sync::Mutex;

use ocean_globe::data::TileTexels;
use ocean_globe::data::coast::{self, Ring, field::field};
use ocean_globe::data::fetch::Source;
use ocean_globe::data::pmtiles::Archive;
use ocean_globe::data::tile::{
    Layer, MapPoint, Projection, TILE_TEXELS, TileId, map_from_lat_lon, texel_size_m, texels_across,
};
use ocean_globe::data::water::{OwnShores, WaterClass, unpacked};
use ocean_globe::data::world::{DEEPEST_SHORES, World};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
/// How far from a coast point the made shore is looked for, metres.
const LOOKED_M: f64 = 1000.0;
/// Steps of that search, metres; also what the answer may be too large by.
const STEP_M: f64 = 5.0;

fn world() -> World {
    World::open(DATA)
}

/// Rows of numbers.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    rows.map(|row| row.split(',').map(|number| number.parse().unwrap()).collect()).collect()
}

/// Water tiles from the archive's shores alone: what is within eight texels of a shore does not need the tiles above.
struct Shores {
    archive: Archive<Source>,
    made: HashMap<TileId, Option<OwnShores>>,
}

impl Shores {
    fn open() -> Self {
        let source = Source::new(format!("{DATA}/water.pmtiles"));
        Self { archive: pollster::block_on(Archive::open(source)).unwrap(), made: HashMap::new() }
    }

    /// What the tile's texel around a place says, and those beside it, as weights of steps to the ocean's shore, and its class.
    fn at(&mut self, lat: f64, lon: f64, z: u8) -> Option<(f64, u8)> {
        let (x, y) = map_from_lat_lon(Projection::Mercator, lat, lon);
        let across = texels_across(z);
        let (column, row) = (x * across - 0.5, y * across - 0.5);
        let (fx, fy) = (column - column.floor(), row - row.floor());
        let mut steps = 0.0;
        let mut class = 0;
        for (i, j, weight) in
            [(0, 0, (1.0 - fx) * (1.0 - fy)), (1, 0, fx * (1.0 - fy)), (0, 1, (1.0 - fx) * fy), (1, 1, fx * fy)]
        {
            let texel = [column, row].map(|at| at.floor() as i64);
            let [column, row] = [(texel[0] + i).rem_euclid(across as i64), texel[1] + j];
            let id = TileId::new(Projection::Mercator, z, (column >> 8) as u32, (row >> 8) as u32)?;
            let at = (row & 255) as usize * TILE_TEXELS + (column & 255) as usize;
            let own = self.tile(id)?;
            steps += weight * f64::from(own.steps[at][0]);
            if weight >= 0.25 {
                class = own.classes[at];
            }
        }
        Some((steps, class))
    }

    fn tile(&mut self, id: TileId) -> Option<&OwnShores> {
        if self.made.len() > 64 {
            self.made.clear();
        }
        let archive = &self.archive;
        let made = self.made.entry(id).or_insert_with(|| {
            let from = id.ancestor(8.min(id.z))?;
            let bytes = pollster::block_on(archive.tile(from.z, from.x, from.y)).unwrap()?;
            field(id, from.z, &coast::Shores::decode("tile", &bytes).unwrap())
        });
        made.as_ref()
    }
}

/// What each row gives, by as many threads as there are processors.
fn each<T: Send>(rows: &[Vec<f64>], of: impl Fn(&mut Shores, &[f64]) -> T + Sync) -> Vec<T> {
    let found = Mutex::new(Vec::new());
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(8);
    std::thread::scope(|scope| {
        for part in rows.chunks(rows.len().div_ceil(threads)) {
            let (found, of) = (&found, &of);
            scope.spawn(move || {
                let mut shores = Shores::open();
                let part: Vec<T> = part.iter().map(|row| of(&mut shores, row)).collect();
                found.lock().unwrap().extend(part);
            });
        }
    });
    found.into_inner().unwrap()
}

/// The deepest level, towards the poles one whose texels are as wide.
fn level(lat: f64) -> u8 {
    (0..=DEEPEST_SHORES).rev().find(|z| texel_size_m(Projection::Mercator, *z, lat) > 9.0).unwrap()
}

/// Distance from a place to the nearest place on the other side of the made zero line, metres. Walking outwards in 24
/// directions finds the line itself: what the tiles state as distance is not trusted.
fn distance_to_zero_line_m(shores: &mut Shores, lat: f64, lon: f64) -> f64 {
    let z = level(lat);
    let mut in_ocean = |north_m: f64, east_m: f64| {
        let radius_m = 6_378_137.0;
        let (lat2, lon2) = (lat + north_m / radius_m, lon + east_m / (radius_m * lat.cos()));
        shores.at(lat2, lon2, z).map(|(steps, _)| steps > 0.0)
    };
    let here = in_ocean(0.0, 0.0);
    let mut radius_m = STEP_M;
    while radius_m < LOOKED_M && here.is_some() {
        for direction in 0..24 {
            let (sin, cos) = (f64::from(direction) * std::f64::consts::TAU / 24.0).sin_cos();
            if in_ocean(radius_m * cos, radius_m * sin).is_some_and(|there| Some(there) != here) {
                return radius_m;
            }
        }
        radius_m += STEP_M;
    }
    LOOKED_M
}

#[test]
fn half_of_the_coast_points_lie_within_40_m_of_the_drawn_shore_and_nearly_all_within_150_m() {
    let points = rows(include_str!("../oracles/gshhg_between.csv"));
    assert_eq!(points.len(), 2000);
    let mut errors_m =
        each(&points, |shores, at| distance_to_zero_line_m(shores, at[0].to_radians(), at[1].to_radians()));
    errors_m.sort_by(f64::total_cmp);
    let quantile = |q: f64| errors_m[(q * (errors_m.len() - 1) as f64).round() as usize];
    println!(
        "coast error: median {} m, 75 % {} m, 90 % {} m, 95 % {} m, 99 % {} m, largest {} m",
        quantile(0.5),
        quantile(0.75),
        quantile(0.9),
        quantile(0.95),
        quantile(0.99),
        quantile(1.0)
    );
    assert!(quantile(0.5) <= 40.0, "half within {} m", quantile(0.5));
    assert!(quantile(0.95) <= 150.0, "19 of 20 within {} m", quantile(0.95));
}

#[test]
fn no_small_island_or_lake_is_lost() {
    let places = rows(include_str!("../oracles/gshhg_small.csv"));
    assert_eq!(places.len(), 400);
    let lost: Vec<_> = each(&places, |shores, row| {
        let (lat, lon) = (row[1].to_radians(), row[2].to_radians());
        // The deepest level whose distances reach that far.
        let class = (0..=level(lat)).rev().find_map(|z| Some(shores.at(lat, lon, z)?.1));
        let class = class.and_then(WaterClass::from_byte);
        let wanted = [WaterClass::Land, WaterClass::Lake, WaterClass::Island][row[0] as usize - 1];
        (class != Some(wanted)).then(|| format!("{row:?} is {class:?}"))
    })
    .into_iter()
    .flatten()
    .collect();
    assert!(lost.is_empty(), "{} of 400: {lost:?}", lost.len());
}

/// Coasts of many islands, of fjords and lagoons.
const RAGGED: [[f64; 2]; 6] =
    [[45.43, 12.34], [20.9, 107.1], [24.3, -76.2], [59.4, 18.9], [-50.5, -75.0], [68.2, 14.5]];

/// From a place to the nearest side of rings that are moved to the right, all in units of the rings.
fn nearest(rings: &[Ring], right: i32, at: [f64; 2]) -> f64 {
    let sides =
        rings.iter().flat_map(|ring| ring.points.iter().zip(ring.points.iter().skip(1).chain(&ring.points[..1])));
    let distance = |(a, b): (&[i32; 2], &[i32; 2])| {
        let [a, b] = [a, b].map(|point| [f64::from(point[0] + right) - at[0], f64::from(point[1]) - at[1]]);
        let way = [b[0] - a[0], b[1] - a[1]];
        let along = -(a[0] * way[0] + a[1] * way[1]) / (way[0] * way[0] + way[1] * way[1]).max(1.0);
        let along = along.clamp(0.0, 1.0);
        (a[0] + along * way[0]).hypot(a[1] + along * way[1])
    };
    sides.map(distance).fold(f64::INFINITY, f64::min)
}

#[test]
fn neighbours_know_the_same_shores_about_their_border() {
    let shores = Shores::open();
    let stored = |id: TileId| {
        let bytes = pollster::block_on(shores.archive.tile(id.z, id.x, id.y)).unwrap()?;
        Some(coast::Shores::decode("tile", &bytes).unwrap())
    };
    let mut judged = 0;
    for [lat_deg, lon_deg] in RAGGED {
        let tile = MapPoint::from_lat_lon(lat_deg.to_radians(), lon_deg.to_radians()).tile(8);
        let east = TileId { x: tile.x + 1, ..tile };
        let (Some(west), Some(east)) = (stored(tile), stored(east)) else { panic!("{tile} lacks a neighbour") };
        // As far as both reach, but for the sides along the end of their buffers.
        let known = f64::from(9 * west.extent / 256);
        for i in 0..400 {
            let at = [f64::from(west.extent), (f64::from(i) + 0.5) / 400.0 * f64::from(west.extent)];
            let found = [nearest(&west.rings, 0, at), nearest(&east.rings, west.extent, at)];
            if found[0] < known && at[1] > known && at[1] < f64::from(west.extent) - known {
                judged += 1;
                // A side that crosses the end of a buffer ends there at a whole unit, 19 m at the equator: it is off by half at most.
                assert!((found[0] - found[1]).abs() <= 0.75, "{tile} {at:?}: {found:?}");
            }
        }
    }
    assert!(judged > 200, "only {judged} places judged");
}

#[test]
fn a_tile_made_of_its_ancestors_shores_agrees_with_its_parent() {
    let mut world = world();
    let mut near = 0;
    for [lat_deg, lon_deg] in RAGGED {
        world.sample_blocking(lat_deg.to_radians(), lon_deg.to_radians()).unwrap();
        for z in 9..=DEEPEST_SHORES {
            let id = MapPoint::from_lat_lon(lat_deg.to_radians(), lon_deg.to_radians()).tile(z);
            let Some(tile) = world.tile_blocking(Layer::Water, id).unwrap() else { continue };
            let parent = world.tile_blocking(Layer::Water, id.parent().unwrap()).unwrap().unwrap();
            let (TileTexels::Water(texels), TileTexels::Water(above)) = (&*tile, &*parent) else { panic!() };
            for (at, texel) in texels.iter().enumerate() {
                let half = |at: usize, tile: u32| at / 2 + (tile & 1) as usize * TILE_TEXELS / 2;
                let [column, row] = [half(at % TILE_TEXELS, id.x), half(at / TILE_TEXELS, id.y)];
                let (own, _) = unpacked(*texel);
                let (coarse, _) = unpacked(above[row * TILE_TEXELS + column]);
                for (shore, (own, coarse)) in own.into_iter().zip(coarse).enumerate() {
                    near += usize::from(own.abs() < 64);
                    // Coarse levels lack small lakes, so that the distance to the nearest one rises steeply where it is of no use.
                    if shore == 0 || own.abs() < 160 {
                        // A texel of the parent's near the shore, in steps; beyond, coarse levels know fewer islands.
                        let allowed = 64 + if own.abs() < 160 { 0 } else { own.abs() / 8 };
                        assert!((own - 2 * coarse).abs() <= allowed, "{id} {at} {shore}: {own} {coarse}");
                    }
                }
            }
        }
    }
    assert!(near > 10_000, "only {near} texels near shores");
}
