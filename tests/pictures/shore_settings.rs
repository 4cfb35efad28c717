//! Surf, beaches and the water's density as a link says.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [128, 96];

fn layer(renderer: &mut Renderer, settings: &str, layer: LayerName) -> Vec<f64> {
    layer_at(renderer, settings, 0, layer)
}

// So many seconds after noon.
fn layer_at(renderer: &mut Renderer, settings: &str, seconds: u32, layer: LayerName) -> Vec<f64> {
    // Off Portugal, where the wind blows on to a straight beach, and raises waves whose surf ends within the picture.
    let link = format!(
        "#view=39.62,-9.0831,700,0,0&wind=10@285&clouds=0&water=coastal{settings}&time=2026-06-21T12:00:{seconds:02}Z"
    );
    render::measure(renderer, &render::parse_state(&link).unwrap(), SIZE, layer).unwrap().values
}

#[test]
fn surf_is_as_wide_as_the_link_says_and_beaches_are_as_steep() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let classes = layer(&mut renderer, "", LayerName::Class);
    let ocean = || (0..classes.len()).filter(|i| classes[*i] == 1.0);
    assert!(ocean().count() > 4_000 && classes.contains(&0.0), "{} pixels of ocean", ocean().count());
    // White where the water is much brighter than without surf on the same bed, in two instants: each has three or four crests, of which each is
    // broken or not.
    const INSTANTS: [u32; 2] = [0, 23];
    let surfs = ["0.5,0.03", "1,0.03", "2,0.03", "1,0.015", "1,0.06"];
    let white = surfs.map(|surf| {
        let (_, slope) = surf.split_once(',').unwrap();
        let found = INSTANTS.map(|seconds| {
            let [luminance, none] = [surf, &format!("0,{slope}")]
                .map(|surf| layer_at(&mut renderer, &format!("&surf={surf}"), seconds, LayerName::Luminance));
            ocean().filter(|i| luminance[*i] > 1.5 * none[*i]).count()
        });
        println!("{surf}: {found:?}");
        found.iter().sum::<usize>()
    });
    println!("white pixels with half the width, as usual, with twice, on a bed half and twice as steep: {white:?}");
    // On a plane beach the mean width goes with the factor and with one over the slope; the picture ends 300 m from the shore, and more than half of its water is
    // not white.
    let [half, usual, twice, gentle, steep] = white;
    let instants = INSTANTS.len();
    assert!(usual > 100 * instants && half > 0 && twice.max(gentle) < instants * ocean().count() / 2, "{white:?}");
    for (less, more) in [(half, usual), (usual, twice), (usual, gentle), (steep, usual)] {
        assert!(more as f64 > 1.25 * less as f64, "{white:?}");
    }
    // Depths by the shore: the steeper, the deeper, as the beach's slope has it where the grid tells nothing.
    let depths = ["&surf=1,0.01", "&surf=1,0.03"].map(|surf| layer(&mut renderer, surf, LayerName::Depth));
    let sum = |depths: &[f64]| ocean().map(|i| depths[i]).sum::<f64>();
    let ratio = sum(&depths[1]) / sum(&depths[0]);
    println!("a bed three times as steep is {ratio:.2} times as deep");
    assert!((1.5..3.05).contains(&ratio), "{ratio}");
}

#[test]
fn denser_water_hides_the_bed_sooner() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let depths = layer(&mut renderer, "", LayerName::Depth);
    for density in [0.1, 0.2, 0.3] {
        let opacities = layer(&mut renderer, &format!(",{density}"), LayerName::Mask);
        for (depth_m, opacity) in depths.iter().zip(&opacities).filter(|(depth_m, _)| **depth_m > 0.1) {
            // Two roundings to 32 bits, of numbers up to 30 and 1.
            assert!((opacity - (1.0 - (-density * depth_m).exp())).abs() < 1e-4, "{density}: {opacity} at {depth_m} m");
        }
    }
}
