//! The trains that stand for a sea by a shore have its energy, its periods and its directions.

use std::f64::consts::TAU;

use ocean_globe::model::sea::{Sea, SpectrumKind, Swell};
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::wave_trains::{TAKEN, taken_m2, trains};

#[test]
fn trains_and_what_they_leave_are_the_sea() {
    for (speed, swell) in
        [(5.0, None), (9.0, None), (20.0, None), (6.0, Some(Swell { height_m: 2.0, period_s: 14.0, toward: 1.0 }))]
    {
        let tables = SeaTables::new(Sea::new(speed, SpectrumKind::Jonswap, None, swell, 7, 1.0), 128);
        let spectrum = tables.sea.spectrum();
        let found = trains(&tables).unwrap();
        let energy: f64 = found.iter().map(|train| 0.5 * train.amplitude_m * train.amplitude_m).sum();
        assert!((energy / taken_m2(&tables) - 1.0).abs() < 1e-12);
        use ocean_globe::model::spectrum::DirectionalSpectrum;
        let left: f64 = tables
            .cascades
            .iter()
            .zip(TAKEN)
            .map(|(cascade, taken)| (1.0 - taken * taken) * spectrum.variance_between(cascade.k_min, cascade.k_max))
            .sum();
        let m0 = tables.sea.hs_m * tables.sea.hs_m / 16.0;
        // The patches end at ripples, which have no height.
        assert!(((energy + left) / m0 - 1.0).abs() < 0.01, "{speed} m/s: {energy} and {left} of {m0}");
        // The mean period is that of half the energy, within a part of it.
        let mut periods: Vec<f64> = found.iter().map(|train| TAU / train.omega).collect();
        periods.sort_by(f64::total_cmp);
        let peak = tables.peak_period_s;
        println!("{speed} m/s: {periods:.1?} of a peak of {peak:.1} s");
        assert!(periods[0] > 0.4 * peak.min(9.0) && periods[7] < 1.4 * peak, "{periods:?}");
        // A wind sea runs downwind on both sides, the swell its own way.
        let toward =
            |low: f64, high: f64| found.iter().filter(|train| train.toward > low && train.toward < high).count();
        if swell.is_some() {
            assert!(toward(0.8, 1.2) >= 4, "{found:?}");
        } else {
            assert!(toward(-1.0, 0.0) == 4 && toward(0.0, 1.0) == 4, "{found:?}");
        }
    }
    assert!(trains(&SeaTables::new(Sea::from_wind(0.0, 1, 1.0), 128)).is_none(), "a calm");
}
