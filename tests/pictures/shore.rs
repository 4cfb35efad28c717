//! Waves by a shore: what `sample` tells of the water is what is drawn.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::cli::sample::{SampleArgs, sample};
use ocean_globe::data::world::World;
use ocean_globe::model::waves;
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::sea::shores::Shores;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

#[test]
fn samples_by_a_shore_are_what_is_drawn() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let (mut world, mut shores) = (World::open(DATA), Shores::default());
    let (mut highest, mut shallowest, mut worst, mut breaking) = (0.0f64, f64::INFINITY, [0.0f64; 2], 0);
    // From the beach of Holland to 860 m before it, at instants that show crests and troughs.
    for (place, second) in [
        [52.0963, 4.2560],
        [52.0965, 4.2557],
        [52.0967, 4.2553],
        [52.0977, 4.2530],
        [52.0990, 4.2490],
        [52.1005, 4.2450],
        [52.3720, 4.5223],
        [52.3722, 4.5225],
        [52.3722, 4.5222],
        [52.3722, 4.5210],
    ]
    .into_iter()
    .flat_map(|place| [(place, 0), (place, 2), (place, 5)])
    {
        let sea = format!("wind=9@310&swell=1.2,9,320&clouds=0&time=2026-06-21T11:00:0{second}Z");
        let [lat, lng]: [f64; 2] = place;
        let at = (lat.to_radians(), lng.to_radians());
        let args = SampleArgs {
            at: format!("{lat},{lng}"),
            state: format!("#{sea}"),
            data: DATA.into(),
            ..Default::default()
        };
        let found = sample(&args).unwrap();
        let Some(wanted) = found["surface"]["height_m"].as_f64() else { panic!("{lat},{lng} is no sea: {found}") };
        let depth = found["depth_m"].as_f64().unwrap();
        let state = render::parse_state(&format!("#view={lat},{lng},5,0,0&{sea}")).unwrap();
        let drawn =
            render::measure(&mut renderer, &state, [129, 129], LayerName::Height).unwrap().values[64 * 129 + 64];
        let tables = renderer.seas_mut().tables(&state.settings);
        while !shores.prepare_at(&mut world, (&tables, state.settings.wind_from()), at.0, at.1) {
            world.poll();
        }
        let water = world.sample_blocking(at.0, at.1).unwrap().shallows().unwrap();
        let ticks = waves::ticks_from_unix(state.time.unix_seconds(0.0));
        let wave = shores.waves_at(at, water, ticks).map_or_else(Default::default, |waves| waves.wave);
        let (off, shore_m, bore) = ((wanted - drawn).abs(), water.d, wave.bore);
        let steep = wave.slope[0].hypot(wave.slope[1]);
        println!(
            "{lat},{lng}, {shore_m:.0} m off, {depth:.2} m deep, second {second}, bore {bore:.2}, slope {steep:.2}: sample {wanted:.3} m, drawn {drawn:.3} m, {off:.4}"
        );
        let part = usize::from(bore > 0.0);
        breaking += part;
        worst[part] = worst[part].max(off);
        highest = highest.max(wanted.abs());
        shallowest = shallowest.min(depth);
    }
    println!("worst {worst:.4?} m outside of breaking crests and in them");
    // Cells of 0.15 m on crests with a radius of a metre make 3 mm, and heights are told to 0.1 mm. Both parts have the same bound: a bore is steep
    // along its front, but the water is as high there for either.
    assert!(worst[0] < 0.02 && worst[1] < 0.02, "{worst:?}");
    assert!(
        highest > 0.5 && shallowest < 0.5 && breaking > 5,
        "waves of {highest} m, down to {shallowest} m of depth, {breaking} breaking"
    );
}

#[test]
fn a_calm_sea_by_a_shore_is_finite() {
    // Without a wave there is no frequency that a train of them could have. Shallows of the Bahamas, and the Dutch coast.
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for place in ["24.31,-76.561", "52.0967,4.2553"] {
        let link = format!("#view={place},10,120,80&wind=0@0&clouds=0&time=2026-06-21T11:00:00Z");
        let state = render::parse_state(&link).unwrap();
        let measured = render::measure(&mut renderer, &state, [64, 36], LayerName::Radiance).unwrap();
        let broken = measured.values.iter().filter(|value| !value.is_finite()).count();
        assert_eq!(broken, 0, "{place}: of {} values", measured.values.len());
    }
}

/// Pixels of 5 cm, between texels of 17 m.
#[test]
fn the_shore_at_ones_feet_is_drawn_where_samples_have_it() {
    const SIZE: [u32; 2] = [320, 180];
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    let (mut near, mut compared) = (0, 0);
    for [lat, lon] in [[-22.9881, -43.1898], [-22.9879, -43.1899], [52.3722, 4.52312]] {
        let state =
            render::parse_state(&format!("#view={lat},{lon},12,0,0&wind=0@0&time=2026-06-20T12:00:00Z")).unwrap();
        let mut layer = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
        let (places, classes) = (layer(LayerName::Lonlat), layer(LayerName::Class));
        for (place, class) in places.chunks_exact(2).zip(&classes) {
            let sample = world.sample_blocking(place[1].to_radians(), place[0].to_radians()).unwrap();
            let shore_m = sample.shore_distance_m.unwrap();
            near += usize::from(shore_m.abs() < 2.0);
            // Of a place that a pixel tells in 32 bits and that is three metres above the ground on a beach.
            if shore_m.abs() > 0.1 {
                compared += 1;
                assert_eq!(*class == 1.0, shore_m > 0.0, "{place:?}: class {class}, {shore_m} m from the shore");
            }
        }
    }
    println!("{compared} pixels, {near} of them within 2 m of the shore");
    assert!(compared > 100_000 && near > 5_000, "{compared}, {near}");
}
