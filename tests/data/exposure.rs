//! What stands in the sea's way, on a made-up map and at real islands.

use std::cell::RefCell;
use std::collections::HashSet;
use std::sync::Arc;

use ocean_globe::cli::sample::{SampleArgs, sample};
use ocean_globe::data::TileTexels;
use ocean_globe::data::exposure::{Found, ShoreTiles, Water, cos_lat};
use ocean_globe::data::tile::{EQUATOR_M, TILE_TEXELS, TileId, texels_across};
use ocean_globe::data::water::{packed, unpacked};
use ocean_globe::model::sea::{Sea, Swell};
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::sheltered_sea::{DIRECTIONS, FARTHEST_M, bearing};
use ocean_globe::scene::sea::shelter::Shelter;

/// A round island in an ocean without any other land, on the equator.
const ISLAND: (f64, f64) = (0.37, 0.5);
const RADIUS_M: f64 = 20_000.0;

/// Its tile.
fn tile(id: TileId) -> Found {
    let side = texels_across(id.z);
    let texel = |index: usize| {
        let (x, y) = id.texel_centre((index % TILE_TEXELS) as f64, (index / TILE_TEXELS) as f64);
        // Near the equator Mercator's map is level within a thousandth.
        let way_m = EQUATOR_M * cos_lat(y) * (x - ISLAND.0).hypot(y - ISLAND.1);
        let texels = (way_m - RADIUS_M) / (EQUATOR_M * cos_lat(y)) * side;
        packed([(32.0 * texels) as i32, -8191], 0)
    };
    Found::Tile(Arc::new(TileTexels::Water((0..TILE_TEXELS * TILE_TEXELS).map(texel).collect())))
}

/// The same with a long lake in its middle, which no table has.
fn tile_with_lake(id: TileId) -> Found {
    let Found::Tile(texels) = tile(id) else { unreachable!() };
    let TileTexels::Water(texels) = &*texels else { unreachable!() };
    let side = texels_across(id.z);
    let with_lake = texels.iter().enumerate().map(|(index, texel)| {
        let (x, y) = id.texel_centre((index % TILE_TEXELS) as f64, (index / TILE_TEXELS) as f64);
        let metres = EQUATOR_M * cos_lat(y);
        let lake_m = 0.9 * RADIUS_M - metres * (x - ISLAND.0).hypot(6.0 * (y - ISLAND.1));
        packed([unpacked(*texel).0[0], (32.0 * lake_m / metres * side) as i32], 0)
    });
    Found::Tile(Arc::new(TileTexels::Water(with_lake.collect())))
}

#[test]
fn a_round_island_hides_what_a_circle_hides() {
    let (mut tiles, mut look) = (ShoreTiles::default(), tile);
    let mut shores = tiles.looking(&mut look);
    // Sixty kilometres west of its middle.
    let away_m = 60_000.0;
    let at = (ISLAND.0 - away_m / EQUATOR_M, ISLAND.1);
    for direction in 0..DIRECTIONS {
        let found = shores.exposure(at, direction, Water::Ocean, 8).unwrap();
        let (along, across) = (away_m * bearing(direction).sin(), away_m * bearing(direction).cos().abs());
        let length_m = 100.0;
        if along <= 0.0 {
            // What lies behind takes nothing: its least clearance is the way to it over the root of that.
            assert!(found.passed(length_m) > 0.999, "{direction}: {found:?}");
        } else if across < RADIUS_M {
            let hit_m = along - (RADIUS_M * RADIUS_M - across * across).sqrt();
            println!("{direction}: shore at {:.0} m, a circle's at {hit_m:.0} m", found.fetch_m);
            // A twenty-fourth of the way is a step, the last of which ends a little beyond the shore.
            assert!((found.fetch_m - hit_m).abs() < 0.04 * hit_m, "{direction}: {found:?}, {hit_m}");
            assert!(found.passed(length_m) < 0.01);
        } else {
            // The clearance is the least of d/√r along the ray.
            let least = (1..6000).map(|step| 50.0 * f64::from(step)).map(|r| {
                let (x, y) = (r * bearing(direction).sin() - away_m, r * bearing(direction).cos());
                (x.hypot(y) - RADIUS_M) / r.sqrt()
            });
            let least = least.fold(f64::INFINITY, f64::min);
            println!("{direction}: clears by {:.2}, a circle by {least:.2}", found.clearance);
            // Steps of nine tenths of the distance pass beside the closest place.
            assert!(
                found.clearance >= 0.98 * least && found.clearance < 1.15 * least,
                "{direction}: {found:?} {least}"
            );
        }
    }
    // Far out all is open.
    let far = shores.exposure((0.1, 0.5), 6, Water::Ocean, 8).unwrap();
    assert!(far.fetch_m > 0.9 * FARTHEST_M && far.passed(400.0) > 0.999, "{far:?}");
}

#[test]
fn the_order_in_which_tiles_come_changes_nothing() {
    let tables = Arc::new(SeaTables::new(Sea::from_wind(12.0, 1, 1.0), 128));
    let wind_from = 1.2;
    let eye = (-0.001f64, (ISLAND.0 - 0.5) * std::f64::consts::TAU - 0.005, 50.0);
    let settled = |mut look: &mut dyn FnMut(TileId) -> Found| {
        let mut shelter = Shelter::default();
        for _ in 0..20_000 {
            if shelter.advance((&tables, wind_from), eye, 0.001, &mut look) {
                return shelter.packed();
            }
        }
        panic!("never there");
    };
    let at_once = settled(&mut tile);
    // Every tile is asked for thrice before it comes; later ones first.
    let asked = RefCell::new(Vec::<TileId>::new());
    let late = settled(&mut |id| {
        let mut asked = asked.borrow_mut();
        asked.push(id);
        let times = asked.iter().filter(|known| **known == id).count();
        if times > 3 + usize::from(id.z % 2 == 0) { tile(id) } else { Found::Coming }
    });
    assert!(asked.borrow().iter().collect::<HashSet<_>>().len() > 5);
    assert_eq!(at_once.0, late.0);
    assert_eq!(at_once.1, late.1);
    // Half open, half hidden: there is something to compare.
    let calm = at_once.1.iter().filter(|node| node[0] & 0xffff < 0x2000).count();
    assert!(calm > 100 && calm < 4000, "{calm}");
}

#[test]
fn seas_and_eyes_before_this_one_change_nothing() {
    let tables = |n, swell| Arc::new(SeaTables::new(Sea { swell, ..Sea::from_wind(8.0, 1, 1.0) }, n));
    let [sea, finer] = [128, 256].map(|n| tables(n, None));
    let swell = tables(128, Some(Swell { height_m: 3.0, period_s: 12.0, toward: 2.5 }));
    let lon = (ISLAND.0 - 0.5) * std::f64::consts::TAU;
    // From the deck, and from so high that windows reach beyond what land hides.
    let eyes = [50.0, 2e6].map(|altitude_m| [(-0.001, lon - 0.005, altitude_m), (-0.1, lon - 0.2, altitude_m)]);
    let bring = |shelter: &mut Shelter, (tables, wind_from), eye| {
        while !shelter.advance((tables, wind_from), eye, 1.0, &mut tile_with_lake) {}
    };
    let winds = [250f64, 0.0, 100.0].map(f64::to_radians);
    let mut begun = 0;
    for ([here, there], wind_from) in eyes.into_iter().flat_map(|eyes| winds.map(|wind_from| (eyes, wind_from))) {
        let mut fresh = Shelter::default();
        bring(&mut fresh, (&sea, wind_from), here);
        let mut old = Shelter::default();
        bring(&mut old, (&swell, 4.0), here);
        bring(&mut old, (&finer, wind_from), here);
        bring(&mut old, (&sea, wind_from), here);
        let differ = |other: &Shelter| fresh.packed().1.iter().zip(other.packed().1).filter(|(a, b)| **a != *b).count();
        assert_eq!(fresh.packed().0, old.packed().0);
        assert_eq!(differ(&old), 0, "wind from {wind_from}");
        // Another window that is only begun.
        old.advance((&sea, wind_from), there, 0.0, &mut tile_with_lake);
        begun += differ(&old);
        bring(&mut old, (&sea, wind_from), here);
        assert_eq!(differ(&old), 0, "wind from {wind_from}, another eye between");
    }
    assert!(begun > 0, "no other window was begun");
}

#[test]
fn a_place_has_the_same_waves_by_itself_and_around_any_eye() {
    let tables = Arc::new(SeaTables::new(Sea::from_wind(12.0, 1, 1.0), 128));
    let (wind_from, lon) = (1.5, (ISLAND.0 - 0.5) * std::f64::consts::TAU);
    let eyes = [(0.0, lon - 0.004, 20.0), (0.0012, lon - 0.0055, 900.0)];
    let around = eyes.map(|eye| {
        let mut shelter = Shelter::default();
        while !shelter.advance((&tables, wind_from), eye, 1.0, &mut tile) {}
        shelter
    });
    let mut alone = Shelter::default();
    let mut spread = [f64::INFINITY, 0.0f64];
    for i in 0..200 {
        let (lat, lon) = (0.0002 * f64::from(i % 14) - 0.001, lon - 0.0035 - 0.0001 * f64::from(i / 14));
        let own = alone.at((&tables, wind_from), (Water::Ocean, lat, lon), &mut tile).unwrap();
        for shelter in &around {
            assert_eq!(shelter.around(Water::Ocean, lat, lon), own, "{lat} {lon}");
        }
        spread = [spread[0].min(own[1]), spread[1].max(own[1])];
    }
    println!("gains from {:.3} to {:.3}", spread[0], spread[1]);
    assert!(spread[1] > 1.2 * spread[0]);
    // Another wind weighs the same exposures anew, and finds what a shelter of its own does.
    let [mut turned, _] = around;
    while !turned.advance((&tables, 4.0), eyes[0], 1.0, &mut tile) {}
    let own = alone.at((&tables, 4.0), (Water::Ocean, 0.0, lon - 0.004), &mut tile).unwrap();
    assert_eq!(turned.around(Water::Ocean, 0.0, lon - 0.004), own);
    assert!(own[0] > 0.95, "the wind comes from the west, and so does the sea: {own:?}");
}

/// Significant height at a place under a north-easter of 12 m/s, and the gains.
fn here(place: &str) -> (f64, [f64; 4]) {
    let arguments = SampleArgs {
        at: place.into(),
        state: "#wind=12@45".into(),
        time: Some("2026-11-20T12:00:00Z".into()),
        data: concat!(env!("CARGO_MANIFEST_DIR"), "/www/data").into(),
    };
    let surface = sample(&arguments).unwrap()["surface"].clone();
    let gains = [0, 1, 2, 3].map(|i| surface["gains"][i].as_f64().unwrap());
    (surface["hs_here_m"].as_f64().unwrap(), gains)
}

#[test]
fn tenerife_has_a_lee() {
    let tables = SeaTables::new(Sea::from_wind(12.0, 1, 1.0), 256);
    let open_m = tables.sea.hs_m;
    let lee = ["28.0,-16.8", "27.9,-16.9", "27.5,-17.3", "27.0,-17.7"].map(|place| here(place).0);
    let windward = ["28.60,-16.45", "28.75,-16.1"].map(|place| here(place).0);
    println!("open {open_m:.2} m, to windward {windward:.2?}, in the lee 9 to 80 km away {lee:.2?}");
    assert!(windward.iter().all(|height| *height > 0.95 * open_m && *height <= open_m + 1e-9));
    assert!(lee[0] < 0.35 * open_m && lee.is_sorted() && lee[3] > 0.7 * open_m);
    // Heights are those of the gains.
    let (height, gains) = here("28.0,-16.8");
    assert!((tables.height_gain(gains) * open_m / height - 1.0).abs() < 1e-9);
    assert!(gains[0] < gains[1] && gains[1] < gains[2] && gains[3] == 1.0, "{gains:?}");
    // Beyond 84 degrees no shore is looked for.
    assert_eq!(here("87,10").1, [1.0; 4]);
}
