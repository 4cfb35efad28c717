//! Towers of limestone on their own.

use ocean_globe::model::towers;

/// Along a line of 20 km, a place each 4 m, in units of the map.
fn heights() -> Vec<f64> {
    (0..5_000u32).map(|i| towers::height([3_000_000_000 + 429 * i, 1_900_000_000 + 37 * i])).collect()
}

#[test]
fn towers_are_of_all_heights_with_low_ground_between_and_steep_walls() {
    let heights = heights();
    let share = |is: &dyn Fn(f64) -> bool| heights.iter().filter(|&&x| is(x)).count() as f64 / heights.len() as f64;
    let (low, high) = (share(&|x| x < 0.1), share(&|x| x > 0.6));
    let ground: Vec<_> = heights.iter().map(|&towers| towers::ground_m(500.0, towers)).collect();
    let steep = ground.windows(2).filter(|pair| (pair[1] - pair[0]).abs() > 4.0).count() as f64 / ground.len() as f64;
    let highest = ground.iter().fold(0.0f64, |a, &b| a.max(b));
    println!("{low:.2} is low, {high:.2} high, {steep:.2} steeper than 45 degrees, the highest {highest:.0} m");
    assert!(heights.iter().all(|x| (0.0..1.2).contains(x)));
    assert!((0.02..0.6).contains(&low) && (0.05..0.6).contains(&high) && steep > 0.15, "{low} {high} {steep}");
}

#[test]
fn they_end_at_the_shore_and_beyond_the_tropics() {
    assert_eq!(towers::ground_m(0.0, 1.0), 0.0);
    assert_eq!(towers::share(20.9f64.to_radians().sin()), 1.0);
    assert_eq!(towers::share(-22.97f64.to_radians().sin()), 0.0);
    // Walls: a place 30 m inland of a high tower stands higher than that.
    assert!(towers::ground_m(30.0, 1.0) > 100.0);
}
