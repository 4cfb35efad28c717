//! What a rough sea mirrors, against figures of spectral models, plane water and chance.

use ocean_globe::model::optics::{WATER_INDEX, cox_munk_mss, fresnel};
use ocean_globe::model::rough_water::{self, MeanReflection, mean_reflection};

#[test]
fn a_breeze_mirrors_as_much_as_exact_facets_do() {
    let slopes = cox_munk_mss(7.0);
    // Depression of the view, degrees; reflectance looking along the wind and across it; elevation of what is mirrored, degrees.
    let exact = [
        (45.0, [0.032, 0.031], 39.0),
        (20.0, [0.133, 0.136], 17.0),
        (10.0, [0.246, 0.267], 14.0),
        (5.0, [0.316, 0.349], 13.5),
        (2.0, [0.358, 0.400], 14.0),
        (1.0, [0.373, 0.416], 14.4),
    ];
    for (depression, reflectances, elevation) in exact {
        for (variance, wanted) in [slopes.up, slopes.cross].into_iter().zip(reflectances) {
            let found = mean_reflection(f64::sin(f64::to_radians(depression)), variance.sqrt());
            println!(
                "{depression} degrees: {:.4} of {wanted}, {:.1}",
                found.reflectance,
                found.sine.asin().to_degrees()
            );
            // Half of the last figure that is given, and the slopes across the view, which here are those along it: 1 % at most.
            assert!((found.reflectance - wanted).abs() < 0.0005 + 0.03 * wanted, "{depression}: {found:?}");
            // Here it is the direction of the mean vector. The mean of sines is smaller by half of the spread's square: 3 degrees of 45 at 17.
            assert!((found.sine.asin().to_degrees() - elevation).abs() < 3.5, "{depression}: {found:?}");
        }
    }
}

#[test]
fn smooth_water_is_a_mirror() {
    for cosine in [0.05, 0.1, 0.3, 0.7, 1.0] {
        let found = mean_reflection(cosine, 1e-4);
        let plane = fresnel(cosine, 1.0, WATER_INDEX).unpolarised();
        // Fresnel's second derivative is 100 at most here, times half of the variance; the facets' weight shifts by variance over cosine.
        assert!((found.reflectance - plane).abs() < 2e-6, "{cosine}: {found:?}, {plane}");
        assert!((found.sine - cosine).abs() < 1e-6, "{cosine}: {found:?}");
    }
    // A plane that faces away shows facets edge on.
    let away = mean_reflection(-0.2, 1e-3);
    assert!(away.reflectance > 0.98 && away.sine < 0.6, "{away:?}");
}

#[test]
fn the_mean_is_that_of_facets_drawn_by_chance() {
    // Halton's sequence through the normal distribution by Box and Muller.
    let radical = |mut n: u32, base: u32| {
        let (mut value, mut digit) = (0.0, 1.0);
        while n > 0 {
            digit /= f64::from(base);
            value += digit * f64::from(n % base);
            n /= base;
        }
        value
    };
    const FACETS: u32 = 200_000;
    for (cosine, sigma) in [(0.5, 0.25), (0.1, 0.12), (0.02, 0.05), (-0.05, 0.1), (0.9, 0.4)] {
        let view = [f64::sqrt(1.0 - cosine * cosine), cosine];
        let [mut area, mut mirrored, mut out, mut up] = [0.0; 4];
        for n in 1..=FACETS {
            let (radius, turn) = ((-2.0 * radical(n, 2).ln()).sqrt(), std::f64::consts::TAU * radical(n, 3));
            let slope = [sigma * radius * turn.cos(), sigma * radius * turn.sin()];
            let length = (1.0 + slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
            let shown = (view[1] - view[0] * slope[0]).max(0.0);
            let cos_facet = shown / length;
            let weight = shown * fresnel(cos_facet, 1.0, WATER_INDEX).unpolarised();
            area += shown;
            mirrored += weight;
            out += weight * (view[0] + 2.0 * cos_facet * slope[0] / length);
            up += weight * (2.0 * cos_facet / length - view[1]).abs();
        }
        let found = mean_reflection(cosine, sigma);
        let chance = MeanReflection { reflectance: mirrored / area, sine: up / f64::hypot(up, out) };
        println!("{cosine} {sigma}: {found:.4?}, by chance {chance:.4?}");
        // Chance leaves a root of 200,000 with Halton's points less: under 0.3 %; at −0.05 one facet in five is seen.
        assert!((found.reflectance / chance.reflectance - 1.0).abs() < 0.005, "{cosine} {sigma}");
        assert!((found.sine - chance.sine).abs() < 0.005, "{cosine} {sigma}");
    }
}

#[test]
fn the_table_is_read_between_its_texels() {
    let table = rough_water::table();
    let (columns, rows) = (rough_water::COSINES, rough_water::DEVIATIONS);
    let at = |column: usize, row: usize| table[row * columns + column];
    let mut worst = [0.0f64; 2];
    for step in 0..400 {
        let [x, y] = [0.754_877_666, 0.569_840_291].map(|part| (part * f64::from(step)).fract());
        let [x, y] = [x * (columns - 1) as f64, y * (rows - 1) as f64];
        let (i, j, fx, fy) = (x as usize, y as usize, x.fract(), y.fract());
        let mix = |of: fn(MeanReflection) -> f64| {
            let line = |j| of(at(i, j)) * (1.0 - fx) + of(at(i + 1, j)) * fx;
            line(j) * (1.0 - fy) + line(j + 1) * fy
        };
        let root = -0.5 + 1.5 * x / (columns - 1) as f64;
        let sigma = 0.6 * (y / (rows - 1) as f64).powi(2);
        let exact = mean_reflection(root * root.abs(), sigma);
        let off = [mix(|m| m.reflectance) - exact.reflectance, mix(|m| m.sine) - exact.sine].map(f64::abs);
        worst = [0, 1].map(|part| worst[part].max(off[part]));
    }
    println!("worst between texels: {worst:.4?}");
    assert!(worst[0] < 0.006 && worst[1] < 0.01, "{worst:?}");
}
