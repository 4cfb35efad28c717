//! The lee of land: its numbers against published formulas and against a wall's diffraction.

use std::f64::consts::TAU;

use ocean_globe::model::sea::{Sea, SpectrumKind, Swell};
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::sheltered_sea::{
    DIRECTIONS, Exposure, LocalSea, LocalWaves, RINGS, SPREADS, bearing, rings, weights, young_verhagen,
};
use ocean_globe::model::spectrum::DirectionalSpectrum;

#[test]
fn a_fetch_limited_sea_has_the_height_and_the_period_of_young_and_verhagen() {
    // (U, F, h) -> Hs, Tp, evaluated apart from this program.
    for (u, fetch_m, depth_m, hs_m, tp_s) in
        [(10.0, 5e3, 5.0, 0.3379, 2.466), (15.0, 20e3, 10.0, 0.9636, 4.236), (10.0, 50e3, 2.0, 0.4535, 2.769)]
    {
        let (height, period) = young_verhagen(u, fetch_m, depth_m);
        println!("{u} m/s, {fetch_m} m, {depth_m} m: {height:.4} m, {period:.4} s");
        // The values are given to four digits.
        assert!((height / hs_m - 1.0).abs() < 3e-4 && (period / tp_s - 1.0).abs() < 3e-4, "{height} {period}");
    }
    let (deep, _) = young_verhagen(10.0, 20e3, f64::INFINITY);
    assert!((deep / young_verhagen(10.0, 20e3, 1e4).0 - 1.0).abs() < 1e-9, "{deep}");
    assert_eq!(young_verhagen(0.0, 1e3, 10.0), (0.0, 0.0));
}

/// Exposure of a place behind a thin wall that reaches from its tip at (0, 0) to the west, to waves from the north: `place` is in metres.
fn behind_wall([x, y]: [f64; 2], direction: usize) -> Exposure {
    let (sin, cos) = libm::sincos(bearing(direction));
    // How far along the ray the tip is, and how far to the east of the tip the ray passes.
    let (along, east) = (-x * sin - y * cos, x * cos - y * sin);
    if along <= 0.0 {
        return Exposure::OPEN;
    }
    let crosses = cos > 0.0 && east < 0.0;
    let clearance = if crosses { -east.abs() } else { east.abs() } / along.sqrt();
    Exposure { fetch_m: along, clearance }
}

#[test]
fn waves_behind_a_wall_are_as_high_as_diffraction_theory_has_them() {
    // Ten lengths behind the tip, at angles from the edge of the shadow, positive in it: Sommerfeld's solution, its energy summed over
    // the directions of a wind sea.
    let length_m: f64 = 60.0;
    let shares = weights(0.0, SPREADS[0]);
    for (angle_deg, expected) in [(-40.0f64, 0.97), (-20.0, 0.88), (0.0, 0.70), (20.0, 0.46), (40.0, 0.25)] {
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        let place = [-10.0 * length_m * sin, -10.0 * length_m * cos];
        let energy: f64 = (0..DIRECTIONS).map(|i| shares[i] * behind_wall(place, i).passed(length_m)).sum();
        println!("{angle_deg} deg: {:.3}, expected {expected}", energy.sqrt());
        // Within what the 24 directions leave: with many more it is 0.683 straight behind the tip.
        assert!((energy.sqrt() - expected).abs() < 0.04, "{angle_deg}: {}", energy.sqrt());
    }
}

#[test]
fn a_thin_wall_hides_as_much_as_a_thick_one() {
    // Tiles tell of a place in a wall how far its nearer face is: 20 m at most, however far its end.
    let tables = SeaTables::new(Sea::from_wind(15.0, 1, 1.0), 256);
    let local = LocalSea::new(&tables, 0.0, f64::INFINITY);
    for angle_deg in [-40.0f64, -20.0, 0.0, 20.0, 40.0] {
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        let place = [-2_000.0 * sin, -2_000.0 * cos];
        let thick: [Exposure; DIRECTIONS] = std::array::from_fn(|i| behind_wall(place, i));
        let thin = std::array::from_fn(|i| {
            let fetch_m = if thick[i].clearance < 0.0 { -place[1] / bearing(i).cos() } else { thick[i].fetch_m };
            Some(Exposure { fetch_m, clearance: thick[i].clearance.max(-20.0 / fetch_m.sqrt()) })
        });
        let [thick, thin] = [thick.map(Some), thin].map(|exposures| local.gains(&exposures)[0]);
        println!("{angle_deg} deg: {thin:.3} behind a thin wall, {thick:.3} behind a thick one");
        // Its end is known to a part of the 15 degrees between two directions, and a length is the peak's.
        assert!((thin - thick).abs() < 0.04, "{angle_deg}: {thin} {thick}");
    }
}

/// Energy that a sea with these gains has, over the open sea's, by the rings that have gains.
fn energy(tables: &SeaTables, gains: [f64; RINGS]) -> f64 {
    let spectrum = tables.sea.spectrum();
    let open = rings(&tables.cascades, |k| spectrum.omnidirectional(k));
    (0..RINGS).map(|ring| gains[ring] * gains[ring] * open[ring]).sum::<f64>()
}

#[test]
fn gains_of_the_rings_add_up_to_the_energy_of_the_rule() {
    let tables = SeaTables::new(Sea::from_wind(10.0, 1, 1.0), 256);
    let local = LocalSea::new(&tables, 0.0, f64::INFINITY);
    assert_eq!(local.gains(&[Some(Exposure::OPEN); DIRECTIONS]).map(|gain| (1e6 * gain).round()), [1e6; RINGS]);
    let mut heights = Vec::new();
    for fetch_m in [1e3, 5e3, 20e3, 80e3] {
        let blocked = Exposure { fetch_m, clearance: -1e3 };
        let gains = local.gains(&[Some(blocked); DIRECTIONS]);
        let (hs_m, _) = young_verhagen(10.0, fetch_m, f64::INFINITY);
        let height = 4.0 * energy(&tables, gains).sqrt();
        println!("{fetch_m} m: {gains:.3?}, {height:.3} m, Young and Verhagen {hs_m:.3} m");
        // The table between fetches a fifth apart, waves shorter than the rings', and short waves' slopes, which are not JONSWAP's.
        assert!((height / hs_m - 1.0).abs() < 0.06, "{fetch_m}: {height} {hs_m}");
        heights.push(height);
    }
    assert!(heights.is_sorted() && heights[3] < tables.sea.hs_m);
    // Half of the directions open, by symmetry half of the energy, but for what the wind raises anew.
    let half =
        |i: usize| if i <= DIRECTIONS / 2 { Exposure::OPEN } else { Exposure { fetch_m: 10.0, clearance: -1e3 } };
    let share = energy(&tables, local.gains(&std::array::from_fn(|i| Some(half(i))))) * 16.0 / tables.sea.hs_m.powi(2);
    // The direction that the wind comes from is one of the open ones, and holds a fifth or less.
    assert!((0.5..0.62).contains(&share), "{share}");
}

#[test]
fn a_swell_has_a_lee_of_its_own() {
    let swell = Swell { height_m: 2.0, period_s: 14.0, toward: -TAU / 4.0 };
    let sea = Sea::new(6.0, SpectrumKind::Jonswap, None, Some(swell), 1, 1.0);
    let tables = SeaTables::new(sea, 256);
    // Wind from the north; the swell travels to the right of downwind, so to the west: it comes from the east.
    let local = LocalSea::new(&tables, 0.0, f64::INFINITY);
    let blocked_from = |from: f64| {
        let exposure = |i: usize| {
            let is_hidden = (bearing(i) - from).cos() > 0.3;
            if is_hidden { Exposure { fetch_m: 1e3, clearance: -1e3 } } else { Exposure::OPEN }
        };
        local.gains(&std::array::from_fn(|i| Some(exposure(i))))[0]
    };
    let (north, east) = (blocked_from(0.0), blocked_from(TAU / 4.0));
    println!("longest waves: {north:.3} with land to the north, {east:.3} with land to the east");
    assert!(north > 0.9 && east < 0.3, "{north} {east}");
}

#[test]
fn waves_that_the_wind_raises_anew_have_the_period_of_young_and_verhagen() {
    // (U, F, h) -> Tp, evaluated apart from this program.
    for (u, fetch_m, depth_m, peak_s) in [
        (10.0, 30e3, f64::INFINITY, 4.0292),
        (12.0, 8e3, 154.0, 3.0769),
        (20.0, 120e3, 147.0, 8.0451),
        (15.0, 40e3, 8.0, 4.7104),
    ] {
        let tables = SeaTables::new(Sea::from_wind(u, 1, 1.0), 256);
        let local = LocalSea::new(&tables, 1.0, depth_m);
        let mut waves = LocalWaves::default();
        waves.add(1.0, &local, &[Some(Exposure { fetch_m, clearance: f64::NEG_INFINITY }); DIRECTIONS]);
        let found = waves.peak_period(&tables.sea.spectrum());
        println!("{u} m/s, {fetch_m} m, {depth_m} m: {found:.4} s, open sea {:.4} s", tables.peak_period_s);
        // The values are given to five digits.
        assert!((found / peak_s - 1.0).abs() < 3e-5, "{found} for {peak_s}");
        let mut open = LocalWaves::default();
        open.add(1.0, &local, &[Some(Exposure::OPEN); DIRECTIONS]);
        assert_eq!(open.peak_period(&tables.sea.spectrum()), tables.peak_period_s);
    }
}

#[test]
fn the_peak_of_a_lee_is_that_of_the_higher_part() {
    let swell = Swell { height_m: 1.5, period_s: 14.0, toward: -TAU / 4.0 };
    let sea = Sea::new(12.0, SpectrumKind::Jonswap, None, Some(swell), 1, 1.0);
    let tables = SeaTables::new(sea, 256);
    let (spectrum, local) = (tables.sea.spectrum(), LocalSea::new(&tables, 0.0, f64::INFINITY));
    // Wind from the north, the swell from the east; a shore 6 km away hides one or the other.
    let peak = |hidden_from: f64| {
        let exposure = |i: usize| {
            let is_hidden = (bearing(i) - hidden_from).cos() > 0.3;
            if is_hidden { Exposure { fetch_m: 6e3, clearance: -1e3 } } else { Exposure::OPEN }
        };
        let mut waves = LocalWaves::default();
        waves.add(1.0, &local, &std::array::from_fn(|i| Some(exposure(i))));
        waves.peak_period(&spectrum)
    };
    let [no_wind, no_swell, neither] = [peak(0.0), peak(TAU / 4.0), {
        let mut waves = LocalWaves::default();
        waves.add(1.0, &local, &[Some(Exposure { fetch_m: 6e3, clearance: -1e3 }); DIRECTIONS]);
        waves.peak_period(&spectrum)
    }];
    println!("{no_wind} s without the wind's waves, {no_swell} s without the swell, {neither} s behind both");
    assert!((no_wind - 14.0).abs() < 1e-9 && no_swell == spectrum.wind.peak_period());
    assert!((neither - young_verhagen(12.0, 6e3, f64::INFINITY).1).abs() < 1e-9);
}
