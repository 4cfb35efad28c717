//! The relief that is made up for the data's coarseness, at known places of the bundled world.

use ocean_globe::data::sample::Sample;
use ocean_globe::data::tile::{MapPoint, Projection, lat_lon_from_map};
use ocean_globe::data::world::{SHORE_LEVEL, SHORE_SIDE, World};
use ocean_globe::model::rugged::DROWNED_RISE;
use ocean_globe::model::sea_bed::trusted_m;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

/// Islands in a deep sea: Tahiti, Madeira, and Faial and Pico, which the data have no higher than 2 m.
const ISLANDS: [[f64; 2]; 3] = [[-17.6, -149.5], [32.7, -17.0], [38.5, -28.5]];
/// A coast that ice has shaped, of whose outer islands the data know nothing.
const FJORDS: [f64; 2] = [61.1, 5.6];
/// A coast of hills with islands before it.
const RIO: [f64; 2] = [-23.0, -43.4];

/// Samples on a square about a place, degrees, `side_m` wide.
fn around(world: &mut World, [lat_deg, lon_deg]: [f64; 2], side_m: f64, steps: i32) -> Vec<Sample> {
    let at = |i: i32| (f64::from(i) / f64::from(steps - 1) - 0.5) * side_m / 111_195.0;
    (0..steps * steps)
        .map(|k| {
            let (lat, lon) = (lat_deg + at(k / steps), lon_deg + at(k % steps) / lat_deg.to_radians().cos());
            world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap()
        })
        .collect()
}

/// Mean and standard deviation.
fn moments(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let n = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / n;
    [mean, (values.map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt()]
}

/// What is made on the land of a square 20 km wide.
fn made(world: &mut World, place: [f64; 2]) -> Vec<Sample> {
    around(world, place, 20_000.0, 41).into_iter().filter(|sample| sample.depth_m.is_none()).collect()
}

#[test]
fn mountains_have_the_relief_of_mountains() {
    let mut world = World::open(DATA);
    // Name, place, deviation from … to in metres. Real heights deviate within 20 km by 400 to 700 m in high mountains and by 50 to 200 m in
    // low ones; the data hold a part of that, what is made should hold about the rest.
    for (name, place, from, to) in [
        ("Khumbu, Himalaya", [27.9, 86.8], 120.0, 500.0),
        ("Bernese Alps", [46.5, 8.1], 120.0, 500.0),
        ("Andes", [-33.0, -70.0], 100.0, 400.0),
        ("Jotunheimen, Norway", [61.5, 8.2], 80.0, 300.0),
        ("Sognefjord, Norway", [61.1, 6.0], 60.0, 300.0),
        ("Tahiti", [-17.63, -149.47], 100.0, 400.0),
        ("Madeira", [32.75, -17.0], 100.0, 400.0),
        // Of these the data know next to nothing.
        ("Streymoy, Faroes", [62.12, -7.1], 50.0, 250.0),
        ("Mainland, Shetland", [60.25, -1.3], 20.0, 150.0),
        ("Scottish Highlands", [56.8, -5.0], 40.0, 200.0),
        ("Appalachians", [37.5, -80.5], 30.0, 150.0),
        ("Queen Maud Mountains, Antarctica", [-84.9, -165.0], 50.0, 300.0),
    ] {
        let land = made(&mut world, place);
        let [mean, rms] = moments(land.iter().map(|sample| sample.relief_made_m));
        let highest = land.iter().map(|sample| sample.elevation_m).fold(f64::MIN, f64::max);
        let of_data = land.iter().map(|sample| sample.elevation_measured_m).fold(f64::MIN, f64::max);
        println!("{name}: {mean:.0} +- {rms:.0} m made, the highest {highest:.0} m where the data have {of_data:.0} m");
        assert!((from..to).contains(&rms), "{name}: {rms}");
        assert!(highest > of_data + 0.5 * rms, "{name}: no summit stands over the data's: {highest}, {of_data}");
    }
}

#[test]
fn plains_and_ice_are_left_as_they_are() {
    let mut world = World::open(DATA);
    for (name, place) in [
        ("Ganges plain", [26.0, 83.0]),
        ("Amazonia", [-4.0, -62.0]),
        ("West Siberia", [62.0, 75.0]),
        ("Western Sahara", [23.6, -15.0]),
        ("Holland", [52.15, 4.75]),
        ("Noordoostpolder", [52.7, 5.75]),
        ("Texel", [53.08, 4.82]),
        ("Sylt", [54.9, 8.34]),
        ("Gotland's north", [57.5, 18.6]),
        ("East Antarctica", [-75.0, 100.0]),
        ("Antarctica's slope", [-69.0, 100.0]),
        ("Greenland's ice", [72.0, -40.0]),
        ("Greenland's slope", [69.5, -48.0]),
    ] {
        let worst = made(&mut world, place).iter().map(|s| s.relief_made_m.abs()).fold(0.0, f64::max);
        println!("{name}: {worst:.2} m made at most");
        assert!(worst < 2.0, "{name}: {worst}");
    }
}

#[test]
fn raised_ground_rises_without_walls_and_is_no_higher_than_hills() {
    let mut world = World::open(DATA);
    // On shelves of high latitudes, also where the data know higher ground beside it: Greenland's north, Labrador, the Canadian Arctic, the Faroes.
    for (name, [lat_deg, lon_deg]) in [
        ("Greenland's north", [82.85, -48.74]),
        ("Labrador", [60.09, -64.82]),
        ("Bathurst Island", [76.63, -101.29]),
        ("Ellef Ringnes Island", [78.38, -104.11]),
        ("Mansel Island", [62.0, -80.11]),
        ("Streymoy", [62.12, -7.1]),
    ] {
        let (mut steepest, mut highest) = (0.0f64, 0.0f64);
        for across in [[0.0, 1.0], [1.0, 0.0]] {
            let mut last = None;
            for step in -40..=40 {
                let way = 100.0 * f64::from(step) / 111_195.0;
                let (lat, lon) = (lat_deg + way * across[0], lon_deg + way * across[1] / lat_deg.to_radians().cos());
                let sample = world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
                if sample.elevation_measured_m < 10.0 {
                    highest = highest.max(sample.relief_made_m);
                }
                if let Some(last) = last.replace(sample.elevation_m) {
                    steepest = steepest.max((sample.elevation_m - last).abs());
                }
            }
        }
        println!("{name}: {highest:.0} m made at most where the data have less than 10 m, {steepest:.0} m in 100 m");
        // Raised by 340 m at most, of which relief makes some more in places; slopes of the Alps, 30 degrees.
        assert!(highest < 450.0 && steepest < 58.0, "{name}: {highest} m, {steepest} m in 100 m");
    }
}

#[test]
fn hills_that_the_sea_has_drowned_stand_as_islands() {
    let mut world = World::open(DATA);
    // Of Halong's 2,000 towers of limestone, 50 to 200 m high, the data know nothing.
    // The last has its mainland in the square.
    for (name, place, most) in [("Halong", [20.86, 107.13], 0.6), ("Bai Tu Long", [20.93, 107.30], 0.3)] {
        let land = made(&mut world, place);
        let of_data = land.iter().map(|sample| sample.elevation_measured_m).fold(f64::MIN, f64::max);
        let highest = land.iter().map(|sample| sample.elevation_m).fold(f64::MIN, f64::max);
        // Where the ground is 100 m from the shore and more.
        let inner: Vec<_> = land
            .iter()
            .filter(|sample| sample.shore_distance_m.is_some_and(|m| (-1_000.0..-100.0).contains(&m)))
            .collect();
        let raised = inner.iter().filter(|sample| sample.elevation_m > 30.0).count() as f64 / inner.len() as f64;
        println!(
            "{name}: up to {highest:.0} m where the data have {of_data:.0} m; {raised:.2} of {} places are higher than 30 m",
            inner.len()
        );
        assert!(
            (100.0..400.0).contains(&highest) && raised > most && inner.len() > 20,
            "{name}: {highest} m, {raised}"
        );
    }
    // As broken, and low: lagoons, deltas, marshes, skerries, cays before a deep sea. The last three lie before hills, of which a few metres are made up.
    for (name, place, most_m) in [
        ("Venice", [45.44, 12.33], 1.0),
        ("the Po's delta", [44.95, 12.45], 1.0),
        ("Ten Thousand Islands", [25.85, -81.45], 1.0),
        ("the Sundarbans", [21.9, 89.2], 1.0),
        ("Zeeland", [51.6, 3.9], 1.0),
        ("Stockholm's skerries", [59.3, 18.8], 1.0),
        ("the Bahamas", [24.0, -76.4], 1.0),
        ("San Blas", [9.55, -78.95], 15.0),
        ("Faro's lagoon", [36.99, -7.9], 15.0),
        ("Aveiro's", [40.65, -8.72], 25.0),
    ] {
        let land = made(&mut world, place);
        let worst = land
            .iter()
            .filter(|sample| sample.elevation_measured_m < 20.0)
            .map(|sample| sample.relief_made_m)
            .fold(0.0, f64::max);
        println!("{name}: {worst:.1} m made at most, of {} places", land.len());
        assert!(worst < most_m && land.len() > 5, "{name}: {worst} m");
    }
}

#[test]
fn water_shores_and_land_below_the_sea_have_none() {
    let mut world = World::open(DATA);
    let (mut wet, mut near, mut low, mut reefs) = (0, 0, 0, 0);
    // Steep coasts, fjords, islands, lakes among mountains, the Dead Sea, polders, the Caspian lowland, the Qattara Depression.
    for (place, side_m) in [
        (ISLANDS[0], 60_000.0),
        (FJORDS, 80_000.0),
        (ISLANDS[1], 60_000.0),
        (ISLANDS[2], 80_000.0),
        ([46.2, 6.5], 80_000.0),
        ([31.5, 35.48], 60_000.0),
        ([52.45, 5.4], 80_000.0),
        ([47.3, 50.5], 80_000.0),
        ([29.6, 27.3], 80_000.0),
        (RIO, 60_000.0),
    ] {
        for sample in around(&mut world, place, side_m, 120) {
            let (made_m, data_m) = (sample.relief_made_m, sample.elevation_measured_m);
            assert_eq!(sample.elevation_m, data_m + made_m);
            let is_lake = sample.lake_distance_m.is_some_and(|d| d > 0.0);
            // Where the data know little of islands they have some of them below the sea: there these may be raised.
            let may_rise = place == FJORDS || place == RIO || ISLANDS.contains(&place);
            let is_low = data_m <= 0.0 && !(may_rise && made_m > 0.0);
            if sample.depth_m.is_some() || is_lake || is_low {
                (wet, low) =
                    (wet + usize::from(data_m > 0.0 || sample.depth_m.is_some()), low + usize::from(data_m < 0.0));
                // Reefs alone are made in water, about Tahiti and no farther off than from where on the data are trusted.
                let farthest_m = trusted_m(f64::INFINITY);
                let on_reef =
                    place == ISLANDS[0] && sample.shore_distance_m.is_some_and(|d| (0.0..=farthest_m).contains(&d));
                assert!(made_m == 0.0 || on_reef && sample.elevation_m < 0.0, "{place:?}: {sample:?}");
                reefs += usize::from(made_m != 0.0);
                continue;
            }
            assert!(sample.elevation_m > data_m.min(0.0), "{place:?} sank: {sample:?}");
            let shores = [sample.shore_distance_m, sample.lake_distance_m].into_iter().flatten();
            let from_shore_m = shores.map(f64::abs).fold(f64::MAX, f64::min);
            // What is made rises with the square of the distance: 3 (d / 700 m)² of a kilometre at most; of drowned hills as steeply as the steepest of these.
            if from_shore_m < 60.0 {
                near += 1;
                let from_sea_m = sample.shore_distance_m.map_or(0.0, f64::abs);
                let drowned_m =
                    if place == RIO && from_shore_m == from_sea_m { DROWNED_RISE[1] * from_sea_m } else { 0.0 };
                assert!(made_m.abs() < 22.0 * (from_shore_m / 60.0).powi(2) + drowned_m, "{place:?}: {sample:?}");
            }
        }
    }
    println!("{wet} in water, {reefs} of them on reefs, {near} near a shore, {low} below the sea");
    assert!(wet > 10_000 && reefs > 50 && near > 200 && low > 1_000);
}

#[test]
fn mountains_keep_their_mean() {
    let mut world = World::open(DATA);
    for (name, place) in
        [("Alps", [46.3, 9.0]), ("Himalaya", [28.5, 85.0]), ("Rockies", [39.5, -106.0]), ("Andes", [-14.0, -72.0])]
    {
        let land = around(&mut world, place, 250_000.0, 90);
        let [mean, rms] = moments(land.iter().map(|sample| sample.relief_made_m));
        println!("{name}: {mean:.1} +- {rms:.0} m made");
        // 8,100 samples of ridges some 5 km wide, 2,500 of them independent: 2 % of the deviation. Valleys that are not let down to the sea
        // and summits that are held below 9 km add a few hundredths more.
        assert!(mean.abs() < 0.12 * rms && rms > 80.0, "{name}: {mean} of {rms}");
    }
}

#[test]
fn no_border_of_tiles_or_maps_shows() {
    let mut world = World::open(DATA);
    let mut made = |lat_deg: f64, lon_deg: f64| {
        let sample = world.sample_blocking(lat_deg.to_radians(), lon_deg.to_radians()).unwrap();
        [sample.relief_made_m, sample.elevation_measured_m]
    };
    let mut relief = 0;
    // Borders of tiles of level 4 and 5 in the Alps and the Himalaya, then the antimeridian in Chukotka and in Fiji: a
    // centimetre to either side.
    for (lats, lon_deg) in [([46.0, 47.4], 11.25), ([28.0, 29.5], 90.0), ([65.5, 68.5], 180.0), ([-16.9, -16.6], 180.0)]
    {
        for i in 0..200 {
            let lat_deg = lats[0] + (lats[1] - lats[0]) * f64::from(i) / 200.0;
            let [[west, data_west], [east, data_east]] = [-1e-7, 1e-7].map(|step| made(lat_deg, lon_deg + step));
            relief += usize::from(west.abs() > 5.0);
            // Two centimetres on slopes of three at most; places are whole numbers of 4 mm, which is as much again. The data themselves
            // have steps where tiles of two levels meet, by which the bound on valleys differs. Where the water tiles of one side end at a
            // coarser level, the ridge of the distances to the shore is cut off by up to a seventh of its texel less there: 5 m of some 3 km
            // in Fiji, by which relief fades, 0.3 % of it.
            let allowed = 0.1 + 0.1 * (data_west - data_east).abs() + 0.004 * west.abs();
            assert!((west - east).abs() < allowed, "{lat_deg} {lon_deg}: {west} {east}");
        }
    }
    assert!(relief > 200, "only {relief} places have relief");
    // Beyond 84 degrees another map's data begin, which differ by up to 150 m: nothing is made there.
    for lon_deg in [-178.0, -170.0, -165.0, 165.0, 172.0] {
        for lat_deg in [-84.0 + 1e-7, -84.0 - 1e-7] {
            assert!(made(lat_deg, lon_deg)[0].abs() < 0.01, "{lat_deg} {lon_deg}");
        }
    }
}

/// Depths each 40 m from a place on the way to a bearing, degrees, as far as 4 km off the shore.
fn transect(world: &mut World, [lat_deg, lon_deg]: [f64; 2], bearing_deg: f64) -> Vec<(f64, f64, f64)> {
    let (sin, cos) = bearing_deg.to_radians().sin_cos();
    (0..200)
        .filter_map(|i| {
            let away = 40.0 * f64::from(i) / 111_195.0;
            let (lat, lon) = (lat_deg + away * cos, lon_deg + away * sin / lat_deg.to_radians().cos());
            let sample = world.sample_blocking(lat.to_radians(), lon.to_radians()).unwrap();
            let shore_m = sample.shore_distance_m.filter(|shore_m| (0.0..4_000.0).contains(shore_m))?;
            Some((shore_m, sample.depth_m?, sample.relief_made_m))
        })
        .collect()
}

#[test]
fn reefs_lie_awash_before_high_islands_of_warm_seas() {
    let mut world = World::open(DATA);
    let mut before = |places: &[[f64; 3]]| -> Vec<_> {
        places.iter().map(|&[lat, lon, bearing]| transect(&mut world, [lat, lon], bearing)).collect()
    };
    // Tahiti, Moorea, Rarotonga, Mauritius, each to several sides; some lines run through passes.
    let reefs = before(&[
        [-17.54, -149.45, 0.0],
        [-17.6, -149.33, 60.0],
        [-17.63, -149.6, 270.0],
        [-17.74, -149.53, 200.0],
        [-17.5, -149.83, 0.0],
        [-17.58, -149.83, 180.0],
        [-21.22, -159.78, 0.0],
        [-21.25, -159.78, 180.0],
        [-20.25, 57.75, 90.0],
        [-20.45, 57.33, 240.0],
    ]);
    let awash =
        |line: &Vec<(f64, f64, f64)>| line.iter().any(|&(shore_m, depth_m, _)| shore_m > 150.0 && depth_m < 2.0);
    let deep =
        |line: &Vec<(f64, f64, f64)>| line.iter().any(|&(shore_m, depth_m, _)| shore_m < 3_000.0 && depth_m > 60.0);
    let [crests, deeps] =
        [reefs.iter().filter(|line| awash(line)).count(), reefs.iter().filter(|line| deep(line)).count()];
    println!("{crests} of {} lines have a crest, {deeps} are deep beyond", reefs.len());
    assert!(crests >= 7 && deeps >= 8, "{crests} {deeps}");
    // Madeira, Pico, Isabela of the Galapagos, Santiago of Cape Verde, Gran Canaria, Key Largo, Andros, the Exumas, Halong.
    let none = before(&[
        [32.75, -17.0, 0.0],
        [38.45, -28.3, 180.0],
        [-0.4, -91.1, 270.0],
        [15.1, -23.6, 90.0],
        [28.0, -15.6, 180.0],
        [25.1, -80.4, 135.0],
        [24.7, -78.0, 90.0],
        [24.34, -76.59, 110.0],
        [20.9, 107.1, 135.0],
    ]);
    assert!(none.iter().flatten().count() > 100);
    assert!(none.iter().flatten().all(|(_, _, made_m)| *made_m == 0.0));
}

#[test]
fn waves_come_in_over_the_reefs_that_are_sampled() {
    let mut world = World::open(DATA);
    // The north of Moorea.
    let MapPoint { u, v, .. } = MapPoint::on(Projection::Mercator, (-17.48f64).to_radians(), (-149.83f64).to_radians());
    let tile = [u, v].map(|at| at >> (32 - SHORE_LEVEL));
    let bed = loop {
        if let Some(bed) = world.shore_bed(tile) {
            break bed;
        }
        world.poll();
    };
    let (mut errors, mut made) = (Vec::new(), 0);
    for (j, i) in (0..SHORE_SIDE).step_by(4).flat_map(|j| (0..SHORE_SIDE).step_by(4).map(move |i| (j, i))) {
        let at =
            |tile: u32, i: usize| (f64::from(tile) + (i as f64 * 4.0) / 256.0 - 0.5) / f64::from(1u32 << SHORE_LEVEL);
        let (lat, lon) = lat_lon_from_map(Projection::Mercator, at(tile[0], i), at(tile[1], j));
        let sample = world.sample_blocking(lat, lon).unwrap();
        let Some(depth_m) = sample.depth_m else { continue };
        errors.push((bed.depth_m[j * SHORE_SIDE + i] - depth_m).abs() / (1.0 + 0.1 * depth_m));
        made += usize::from(sample.relief_made_m.abs() > 1.0);
    }
    errors.sort_by(f64::total_cmp);
    let [half, most] = [errors.len() / 2, errors.len() * 95 / 100].map(|at| errors[at]);
    println!("{} nodes, {made} of reefs, off by {half:.3} and {most:.3} m", errors.len());
    assert!(made > 100 && half < 0.01 && most < 0.6, "{made} {half} {most}");
}
