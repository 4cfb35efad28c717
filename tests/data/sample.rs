//! `sample` at known places of the bundled world.
//!
//! Heights: what a map says, with room for ETOPO5's cells of 9 km, which lower peaks and fill trenches.

use ocean_globe::cli::sample::{SampleArgs, sample};
use ocean_globe::data::world::World;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::waves;
use ocean_globe::scene::link::fragment::parse_state;
use ocean_globe::scene::measured_place::Question;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::sea::shores::Shores;
use ocean_globe::scene::sea::surface_sample::allowed_by_depth;
use ocean_globe::scene::settings::Settings;
use serde_json::Value;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

fn at(place: &str) -> Value {
    sample(&arguments(place, "", None)).unwrap()
}

fn arguments(place: &str, state: &str, time: Option<&str>) -> SampleArgs {
    SampleArgs { at: place.into(), state: state.into(), time: time.map(str::to_owned), data: DATA.into() }
}

#[test]
fn known_places_have_their_class_and_height() {
    // Name, place, class, elevation from … to, metres.
    let places = [
        ("Mount Everest", "27.99,86.93", "land", 4500.0, 8849.0),
        ("Challenger Deep", "11.35,142.2", "ocean", -11_000.0, -6500.0),
        ("Middle of the Atlantic", "35.6812,-14.25", "ocean", -5500.0, -2000.0),
        ("North Pole", "90,0", "ocean", -4340.0, -4240.0),
        ("South Pole", "-90,0", "land", 2760.0, 2860.0),
        ("Dead Sea", "31.5,35.48", "lake", -450.0, -150.0),
        ("West of the Dead Sea", "31.6,35.2", "land", -400.0, 1100.0),
        ("Jericho", "31.86,35.46", "land", -600.0, -100.0),
        ("Behind Nice, whose heights ETOPO5 has lost", "43.9,7.3", "land", 300.0, 1500.0),
        ("Death Valley", "36.25,-116.83", "land", -86.0, 1500.0),
        ("Caspian Sea", "42,50.5", "lake", -1100.0, -26.0),
        ("Caspian lowland", "47.3,50.5", "land", -32.0, -5.0),
        ("Qattara Depression", "29.6,27.3", "land", -134.0, -10.0),
        ("Flevoland", "52.45,5.6", "land", -7.5, 20.0),
        ("Lake Victoria", "-1,33", "lake", 1000.0, 1300.0),
        ("Lake Superior", "47.7,-87.5", "lake", -250.0, 400.0),
        ("Manitoulin Island", "45.75,-82.3", "island", 150.0, 400.0),
        ("Hudson Bay", "60,-86", "ocean", -300.0, -20.0),
        ("The Great Bahama Bank by the Exumas, which ETOPO5 has lost", "24.2,-76.8", "ocean", -25.0, -1.0),
        ("The Great Bahama Bank west of Andros", "24.5,-78.9", "ocean", -25.0, -1.0),
        ("The Great Bahama Bank's south, lost as well", "23.0,-77.9", "ocean", -25.0, -1.0),
        ("The Tongue of the Ocean beside it", "24.3,-77.5", "ocean", -2500.0, -500.0),
        ("Exuma Sound", "24.5,-76.2", "ocean", -2500.0, -1000.0),
        ("The Florida Strait", "25.5,-79.7", "ocean", -1000.0, -300.0),
        ("Black Sea", "43,34", "ocean", -2300.0, -1500.0),
        ("Baltic Sea", "58,19.8", "ocean", -460.0, -30.0),
        ("Sahara", "23,10", "land", 200.0, 2000.0),
        ("Greenland's ice", "72,-40", "land", 2500.0, 3300.0),
        ("East Antarctica", "-75,100", "land", 2500.0, 3800.0),
        ("Ross Ice Shelf", "-81,180", "land", 20.0, 100.0),
        ("Pacific on the date line", "0,180", "ocean", -6500.0, -3500.0),
        ("Viti Levu, Fiji", "-17.8,178", "land", 2.0, 1330.0),
        ("São Miguel, Azores", "37.78,-25.5", "land", 2.0, 1105.0),
    ];
    let mut known = 0;
    for (name, place, class, from, to) in places {
        let found = at(place);
        assert_eq!(found["class"], class, "{name}: {found}");
        let elevation_m = found["elevation_m"].as_f64().unwrap();
        assert!((from..=to).contains(&elevation_m), "{name}: {found}");
        match class {
            "ocean" => assert_eq!(found["depth_m"].as_f64().unwrap(), -elevation_m, "{name}"),
            _ => assert!(found["depth_m"].is_null(), "{name}"),
        }
        // A distance beyond what the coarsest tile can tell is null: no number at all rather than a wrong one.
        let positive = |key: &str| found[key].as_f64().map(|distance| distance > 0.0);
        known += usize::from(positive("shore_distance_m").is_some());
        assert_eq!(positive("shore_distance_m").unwrap_or(class == "ocean"), class == "ocean", "{name}: {found}");
        assert_eq!(positive("lake_distance_m").unwrap_or(class == "lake"), class == "lake", "{name}: {found}");
    }
    assert!(known >= 18, "only {known} shore distances are known");
    assert!(at("90,0")["shore_distance_m"].is_null() && at("-90,0")["shore_distance_m"].is_null());
}

#[test]
fn shore_distances_are_those_of_the_map() {
    // Name, place, distance to the ocean's shore in metres (positive in the ocean), tolerance: a texel of the level it
    // comes from, and the width of the landmark.
    for (name, place, metres, tolerance) in [
        ("Ponta Delgada's harbour", "37.738,-25.665", 0.0, 1000.0),
        ("Cape Agulhas", "-34.833,20.0", 0.0, 1500.0),
        ("Off Cape St Vincent, 100 km west", "37.02,-10.13", 100_000.0, 5000.0),
        ("Madrid, 300 km inland", "40.42,-3.7", -300_000.0, 20_000.0),
    ] {
        let found = at(place)["shore_distance_m"].as_f64().unwrap();
        assert!((found - metres).abs() < tolerance, "{name}: {found}");
    }
}

#[test]
fn the_date_line_and_the_map_border_at_84_degrees_do_not_show() {
    let mut world = World::open(DATA);
    let mut sample =
        |lat_deg: f64, lon_deg: f64| world.sample_blocking(lat_deg.to_radians(), lon_deg.to_radians()).unwrap();
    for lat_deg in [-60.0, -16.85, 0.0, 52.0, 68.97, 71.1] {
        let (west, east) = (sample(lat_deg, 180.0 - 1e-7), sample(lat_deg, -180.0 + 1e-7));
        assert_eq!(west.class, east.class);
        // One centimetre apart, but perhaps in tiles of two levels: heights are rounded to 32 m, each within 16 m, and the
        // coarser texels smooth a little.
        assert!((west.elevation_m - east.elevation_m).abs() < 40.0, "{lat_deg}: {west:?} {east:?}");
        // The same for distances, which are stored in sixteenths of a texel, 38 m at level 7 on the equator.
        assert_eq!(west.shore_distance_m.is_some(), east.shore_distance_m.is_some());
        if let (Some(d_west), Some(d_east)) = (west.shore_distance_m, east.shore_distance_m) {
            assert!((d_west - d_east).abs() < 20.0 + 0.02 * d_west.abs(), "{lat_deg}: {west:?} {east:?}");
        }
    }
    for lon_deg in [-170.0, -90.0, -40.0, 30.0, 120.0] {
        for lat_deg in [84.0, -84.0] {
            let (north, south) = (sample(lat_deg + 1e-7, lon_deg), sample(lat_deg - 1e-7, lon_deg));
            assert_eq!(north.class, south.class);
            // Two pyramids of texels of 1.6 km and 3.3 km, rounded to 32 m each, on slopes up to 10 %.
            assert!((north.elevation_m - south.elevation_m).abs() < 150.0, "{lat_deg} {lon_deg}: {north:?} {south:?}");
        }
    }
}

#[test]
fn places_that_are_none_are_refused() {
    for place in ["", "1", "1;2", "91,0", "nan,0", "1,inf", "1,2,3", "x,y"] {
        let error = sample(&arguments(place, "", None)).unwrap_err().to_string();
        assert!(error.contains("--at") && error.contains("35.68"), "{error}");
    }
    let error =
        sample(&SampleArgs { data: "no/such/folder".into(), ..arguments("1,2", "", None) }).unwrap_err().to_string();
    assert!(error.contains("no/such/folder/terrain.pmtiles"), "{error}");
}

#[test]
fn the_surface_of_the_sea_is_told_where_there_is_sea() {
    let noon = Some("2026-11-20T12:00:00Z");
    let surface = |place, state, time| sample(&arguments(place, state, time)).unwrap()["surface"].clone();
    assert!(surface("28,87", "#bft=8", noon).is_null(), "no sea on land");
    let calm = surface("35.68,-14.25", "#bft=0", noon);
    assert_eq!((&calm["height_m"], &calm["hs_m"]), (&0.0.into(), &0.0.into()));
    assert_eq!(calm["normal_enu"], serde_json::json!([0.0, 0.0, 1.0]));
    let gale = surface("35.68,-14.25", "#bft=8", noon);
    assert!((gale["hs_m"].as_f64().unwrap() - 5.5).abs() < 0.055 && gale["tp_s"].as_f64().unwrap() > 8.0, "{gale}");
    assert_eq!(gale["time"], "2026-11-20T12:00:00Z");
    // The same sea by a link that says the time; another one a minute later.
    assert_eq!(gale, surface("35.68,-14.25", "#bft=8&time=2026-11-20T12:00:00Z", None));
    assert_ne!(gale["height_m"], surface("35.68,-14.25", "#bft=8", Some("2026-11-20T12:01:00Z"))["height_m"]);
    // And the same as the page's function finds, which takes the water for deep.
    let mut seas = Seas::default();
    let asked = Question::of_script("#bft=8", -14.25, 35.68, "2026-11-20T12:00:00Z", 0.0);
    let linked = asked.unwrap().open_sea(&mut seas);
    assert_eq!(gale["height_m"], linked.height_m);
    let up = gale["normal_enu"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap().powi(2)).sum::<f64>();
    assert!((up - 1.0).abs() < 1e-12 && linked.height_m.abs() < 5.5);
    for bad in ["tomorrow", "", "2026-13-01T00:00:00Z"] {
        let error = sample(&arguments("1,2", "", Some(bad))).unwrap_err().to_string();
        assert!(error.contains("time") && error.contains("2026-11-20T12:00:00Z"), "{error}");
    }
    assert!(sample(&arguments("1,2", "#wind=fast", noon)).unwrap_err().to_string().contains("wind"));
}

/// Young and Verhagen's curves over deep water, written anew: significant height, m, and period of the peak, s, over a fetch in metres.
fn raised(speed_mps: f64, fetch_m: f64) -> [f64; 2] {
    let chi = 9.80665 * fetch_m / (speed_mps * speed_mps);
    let energy = 3.64e-3 * (3.13e-3 * chi.powf(0.57)).tanh().powf(1.74);
    let rate = 0.133 * (5.215e-4 * chi.powf(0.73)).tanh().powf(-0.37);
    [4.0 * energy.sqrt() * speed_mps * speed_mps / 9.80665, speed_mps / (9.80665 * rate)]
}

#[test]
fn waves_of_lakes_have_periods_of_their_own() {
    // The height that is told and the period, against each other, by the fetch that makes this height; and against the lake's length, m.
    for (lake, place, from_deg, length_m) in [
        ("Geneva", "46.45,6.6", 250, 73e3),
        ("Superior", "47.7,-87.5", 300, 563e3),
        ("Constance", "47.6,9.4", 300, 63e3),
    ] {
        let found = sample(&arguments(place, &format!("#wind=17@{from_deg}"), Some("2026-11-20T12:00:00Z"))).unwrap();
        let number = |value: &Value| value.as_f64().unwrap_or_else(|| panic!("{lake}: {found}"));
        let surface = &found["surface"];
        let [period, open, height] = [&surface["tp_s"], &surface["open_sea"]["tp_s"], &found["lake_hs_m"]].map(number);
        let (mut low, mut high) = (10.0, 1e7);
        for _ in 0..60 {
            let fetch_m = 0.5 * (low + high);
            if raised(17.0, fetch_m)[0] < height { low = fetch_m } else { high = fetch_m }
        }
        let wanted = raised(17.0, low)[1];
        println!("{lake}: {height:.3} m, {period:.3} s, by the height {wanted:.3} s; the open sea's {open:.3} s");
        assert_eq!(found["lake_tp_s"], surface["tp_s"]);
        // The longest fetches make the peak, while shorter ones take of the height; a twentieth besides for what waves between nodes lose.
        assert!((0.95..1.25).contains(&(period / wanted)), "{lake}: {period} s, by the height {wanted} s");
        assert!(period < raised(17.0, length_m)[1] && open > 9.0, "{lake}: {period} s, the open sea's {open} s");
    }
    // Where nothing is in its way the sea has the open one's.
    let atlantic = &sample(&arguments("35.68,-14.25", "#wind=17@250", None)).unwrap()["surface"];
    assert_eq!(atlantic["tp_s"], atlantic["open_sea"]["tp_s"]);
}

#[test]
fn the_height_told_on_a_beach_is_that_of_the_waves_there() {
    // A swell with hardly a wind, so that the trains have next to all of it, from beyond them to the beach of Holland.
    const SWELL: &str = "#wind=2@300&swell=2,10,300";
    let state = parse_state(SWELL).unwrap();
    let sea = Seas::default().tables(&state.settings);
    let (mut world, mut shores, mut compared) = (World::open(DATA), Shores::default(), 0);
    for lng_deg in [4.40, 4.50, 4.515, 4.519, 4.521, 4.522, 4.5222, 4.5223, 4.5224] {
        let (lat, lon) = (52.372f64.to_radians(), f64::to_radians(lng_deg));
        let place = world.sample_blocking(lat, lon).unwrap();
        let (Some(water), Some(depth_m)) = (place.shallows(), place.depth_m) else { continue };
        while !shores.prepare_at(&mut world, (&sea, state.settings.wind_from()), lat, lon) {
            world.poll();
        }
        let found = sample(&arguments(&format!("52.372,{lng_deg}"), SWELL, None)).unwrap();
        let told = found["surface"]["hs_here_m"].as_f64().unwrap();
        // Of the water's height over an hour at instants of its own.
        let instants = (0..4000)
            .filter_map(|i| shores.waves_at((lat, lon), water, waves::ticks_from_unix(1.8e9 + 0.9 * f64::from(i))));
        let instants: Vec<_> = instants.collect();
        let square = instants.iter().map(|waves| waves.wave.rise.powi(2)).sum::<f64>() / instants.len().max(1) as f64;
        let (of_trains, of_all) = (4.0 * square.sqrt(), instants.first().map_or(0.0, |waves| waves.hs_m));
        println!("{depth_m:.2} m deep: told {told:.3} m, trains {of_trains:.3} m, by their energy {of_all:.3} m");
        assert!(told < 0.9 * depth_m, "{told} m in {depth_m} m");
        // A swell of 2 m and 10 s (156 m long in deep water) that breaks 1 to 3 m high on a bed that rises by 1/100 to 1/20.
        let breakers = &found["surface"]["breakers"];
        if let Some(number) = breakers["iribarren"].as_f64() {
            assert!((0.005..0.05).contains(&(number * f64::sqrt(2.0 / 156.0))), "{breakers}");
            assert_eq!(breakers["kind"], if number < 0.4 { "spilling" } else { "plunging" }, "{breakers}");
        }
        assert_eq!(breakers.is_object(), shores.waves_at((lat, lon), water, 0).is_some(), "{breakers}");
        if of_all > 0.0 {
            // The breeze's own ripples are 0.2 m high, and a tenth of the swell's short waves are not the trains'.
            assert!(told >= of_all && told < of_all.hypot(0.3), "{told} m, the trains are {of_all} m high");
            compared += 1;
            // Eight trains make lower groups than a sea without end does.
            assert!((of_all / of_trains - 1.0).abs() < 0.05, "{of_all} m, the trains are {of_trains} m high");
        }
    }
    assert!(compared >= 5, "{compared} places with trains");
}

#[test]
fn the_pages_function_refuses_what_is_no_place() {
    let asked = |fragment, lng, lat, time| Question::of_script(fragment, lng, lat, time, 1.8e9);
    let found = |fragment, lng, lat, time| asked(fragment, lng, lat, time).map(|at| at.open_sea(&mut Seas::default()));
    for (lng, lat) in [(f64::NAN, 0.0), (f64::INFINITY, 0.0), (0.0, 90.1), (0.0, f64::NAN)] {
        let error = found("#bft=5", lng, lat, "now").unwrap_err().to_string();
        assert!(error.contains("tude"), "{error}");
    }
    assert!(found("#bft=5", 0.0, 0.0, "noon").unwrap_err().to_string().contains("2026-11-20T12:00:00Z"));
    assert!(found("#seed=x", 0.0, 0.0, "now").unwrap_err().to_string().contains("seed"));
    // Far east is somewhere; the clock's instant is an instant; the poles are places.
    assert_eq!(
        found("#bft=5", 540.0, 10.0, "now").unwrap().height_m,
        found("#bft=5", 540.0, 10.0, "").unwrap().height_m
    );
    assert!(found("", 0.0, 90.0, "now").unwrap().height_m.is_finite());
}

#[test]
fn shallow_water_holds_no_higher_waves() {
    let settings = Settings { beaufort: Some(10), ..Settings::default() };
    let mut seas = Seas::default();
    let mut at = |depth_m| seas.sample(&settings, 0.6, -0.3, 1.8e9, depth_m);
    let hs = SeaTables::of(&settings).sea.hs_m;
    assert_eq!(at(2.0 * hs), at(f64::INFINITY));
    assert_eq!(at(0.0).height_m, 0.0);
    assert_eq!(allowed_by_depth(0.5 * hs, hs), 0.25);
    // A hundredth of the waves is moved a hundredth as far: heights at nearly the same rest points, linear in the share.
    let (a, b) = (at(0.002 * hs), at(0.004 * hs));
    assert!((b.height_m / a.height_m - 2.0).abs() < 0.1, "{a:?} {b:?}");
}

/// Between the data's texels, which are 19 m wide at the equator, distances to shores are smooth: a shore at one's feet is no polygon.
#[test]
fn shores_have_no_corners_where_texels_meet() {
    const STEP_M: f64 = 0.5;
    let mut world = World::open(DATA);
    let (mut bends, mut sharpest) = (0, 0f64);
    for row in -6..6 {
        let lat = f64::to_radians(-22.988) + f64::from(row) * 11.0 / 6.37e6;
        let way: Vec<f64> = (0..400)
            .map(|step| {
                let lon = f64::to_radians(-43.19) + (f64::from(step) - 200.0) * STEP_M / (6.37e6 * lat.cos());
                world.sample_blocking(lat, lon).unwrap().shore_distance_m.unwrap()
            })
            .collect();
        // How much the slope changes from one step to the next.
        for steps in way.windows(3) {
            let turns = (steps[0] - 2.0 * steps[1] + steps[2]).abs() / STEP_M;
            sharpest = sharpest.max(turns);
            bends += usize::from(turns > 0.01);
        }
    }
    println!("slopes change by {sharpest:.3} within {STEP_M} m at most; {bends} bends");
    // A distance's slope is between -1 and 1; from texel to texel it turns by 2 at most, in a spline within a texel's width, 17.6 m here.
    assert!(bends > 50 && sharpest < 2.0 * STEP_M / 17.6, "{sharpest}, {bends}");
}
