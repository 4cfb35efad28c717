//! The bundled towns stand where maps have them, and nowhere else; what the shader is told of them is the same from everywhere.

use ocean_globe::data::towns::{Town, towns};
use ocean_globe::scene::towns::{SHIFTS, SIDE, TownMap, units};

/// Middles of cities as atlases give them, degrees north and east, and the least radius that so many people need, km.
const CITIES: [(&str, f64, f64, f64); 10] = [
    ("Tokyo", 35.69, 139.69, 5.0),
    ("Lagos", 6.45, 3.40, 5.0),
    ("Sydney", -33.87, 151.21, 5.0),
    ("Reykjavik", 64.15, -21.94, 2.0),
    ("Ushuaia", -54.80, -68.30, 1.0),
    ("Honolulu", 21.31, -157.86, 2.0),
    ("Suva", -18.14, 178.44, 1.5),
    ("Murmansk", 68.97, 33.08, 2.0),
    ("Valparaiso", -33.05, -71.62, 2.0),
    ("Venice", 45.44, 12.33, 1.0),
];
/// Where nobody lives for 50 km around: oceans, ice, deserts, the Amazon.
const NOWHERE: [(f64, f64); 7] =
    [(0.0, -140.0), (72.0, -40.0), (23.0, 12.0), (-80.0, 90.0), (-25.0, 125.0), (-1.5, -68.0), (60.0, -30.0)];

/// Of a town from a place, km.
fn away(town: &Town, lat_deg: f64, lon_deg: f64) -> f64 {
    let (lat, lon) = (lat_deg.to_radians(), lon_deg.to_radians());
    let cosine = lat.sin() * town.lat.sin() + lat.cos() * town.lat.cos() * (lon - town.lon).cos();
    6_371.0 * cosine.clamp(-1.0, 1.0).acos()
}

#[test]
fn towns_stand_where_maps_have_them() {
    let all: Vec<Town> = towns().collect();
    println!("{} towns", all.len());
    assert!(all.len() > 60_000);
    assert!(all.windows(2).all(|pair| pair[0].lat >= pair[1].lat), "from north to south");
    assert!(all.iter().all(|town| town.lat.abs() < 1.45 && town.lon.abs() <= std::f64::consts::PI));
    assert!(all.iter().all(|town| (100.0..30_000.0).contains(&town.radius_m)));
    for (name, lat, lon, least_km) in CITIES {
        let here = |town: &&Town| away(town, lat, lon) < 1e-3 * town.radius_m + 1.0;
        let widest = all.iter().filter(here).map(|town| 1e-3 * town.radius_m).fold(0.0, f64::max);
        println!("{name}: {widest:.1} km");
        assert!(widest >= least_km, "{name}: {widest}");
    }
    for (lat, lon) in NOWHERE {
        let nearest = all.iter().map(|town| away(town, lat, lon)).fold(f64::INFINITY, f64::min);
        assert!(nearest > 50.0, "a town {nearest} km from {lat}, {lon}");
    }
}

#[test]
fn windows_tell_the_same_from_everywhere() {
    let map = TownMap::bundled();
    // The second eye looks at Tokyo from the south-west; the last one has the antimeridian in its window.
    for (index, shift) in SHIFTS.iter().enumerate() {
        let [first, second] = [(35.68f64, 139.7f64), (35.4, 139.2)]
            .map(|(lat, lon)| map.window(index, units(lat.to_radians(), lon.to_radians())));
        let moved = [0, 1].map(|axis| (first.corner[axis].wrapping_sub(second.corner[axis]) as i32) >> shift);
        assert!(index == 1 || moved != [0, 0], "the eyes have one window");
        let (mut same, mut inside) = (0, 0);
        for y in 0..SIDE {
            for x in 0..SIDE {
                let there = [x, y].map(|at| at as i32);
                let there = [0, 1].map(|axis| there[axis] + moved[axis]);
                if there.iter().all(|at| (0..SIDE as i32).contains(at)) {
                    let told = first.texels[y * SIDE + x];
                    assert_eq!(told, second.texels[there[1] as usize * SIDE + there[0] as usize], "{x}, {y}");
                    same += 1;
                    inside += u32::from(told > 64);
                }
            }
        }
        println!("window {index}: {same} texels told twice, {inside} of them in towns");
        assert!(same > 100_000 && inside > 2_000);
    }
    // Suva, from beyond the antimeridian.
    let window = map.window(1, units((-18.1f64).to_radians(), (-179.6f64).to_radians()));
    let suva = units((-18.14f64).to_radians(), 178.44f64.to_radians());
    let [x, y] = [0, 1].map(|axis| (suva[axis].wrapping_sub(window.corner[axis]) >> SHIFTS[1]) as usize);
    assert!((1..SIDE - 1).contains(&x) && (1..SIDE - 1).contains(&y), "{x}, {y}");
    // A texel of 2.3 km may have its middle beside a town of 1.5 km.
    let told = (0..9).map(|i| window.texels[(y + i / 3 - 1) * SIDE + x + i % 3 - 1]).max();
    assert!(told > Some(32), "{told:?} at {x}, {y}");
}
