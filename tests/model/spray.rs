//! Spray hides as much as the Beaufort scale says.

use ocean_globe::model::spray;

#[test]
fn spray_hides_as_much_as_the_beaufort_scale_says() {
    // Koschmieder's law, by speeds in the middle of grades 4, 7, 8, 9, 11 and where 12 begins.
    let visibility_km = |speed: f64| 3.912e-3 / spray::extinction_per_m(speed);
    let seen = [6.7, 15.5, 19.0, 22.6, 30.5, 32.7].map(visibility_km);
    println!("{seen:.1?}");
    // Not by spray in a breeze; little in a gale; up to what mariners call moderate (2 to 5 miles) in grade 9, poor (under 2) in 11, and
    // very poor (under half a mile) in 12.
    assert!(seen[0] > 1000.0 && seen[1] > 40.0 && seen[2] > 10.0, "{seen:?}");
    assert!((3.7..9.3).contains(&seen[3]) && seen[4] < 3.7 && seen[5] < 0.93, "{seen:?}");
    assert_eq!(spray::extinction_per_m(0.0), 0.0);
    // Beyond what has been seen it stays as it is.
    assert_eq!(spray::extinction_per_m(60.0), spray::extinction_per_m(80.0));
}
