//! The sea is the same in a window and in a page: the wave amplitudes have the bits that tests/browser asks the page for too.

use ocean_globe::model::waves::{Sea, cascades, hash, initial_amplitudes};
use serde_json::Value;

#[test]
fn the_amplitudes_have_the_bits_that_the_browser_finds() {
    let oracle: Value = serde_json::from_str(include_str!("../oracles/same_sea.json")).unwrap();
    let cases = oracle["cases"].as_array().unwrap();
    assert!(!cases.is_empty());
    let mut wrong = Vec::new();
    for case in cases {
        let seed = u32::try_from(case["seed"].as_u64().unwrap()).unwrap();
        let speed_mps = case["speed_mps"].as_f64().unwrap();
        let sea = Sea::from_wind(speed_mps, seed, 1.0);
        let patches = cascades(256);
        let all: Vec<_> =
            patches.iter().enumerate().flat_map(|(index, patch)| initial_amplitudes(&sea, index, patch)).collect();
        let found = format!("{:016x}", hash(&all));
        if found != case["hash"] {
            wrong.push(format!("{case}: {found}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
