//! The waves' random numbers: their moments, their independence, and that neighbours in the key are strangers.

use ocean_globe::model::noise::{bits, gaussian_pair};

const SIDE: i32 = 256;

fn sample() -> Vec<[f64; 2]> {
    let half = SIDE / 2;
    (-half..half).flat_map(|j| (-half..half).map(move |i| gaussian_pair(42, 1, i, j))).collect()
}

#[test]
fn moments_are_normal() {
    let all: Vec<f64> = sample().into_iter().flatten().collect();
    let n = all.len() as f64;
    let moment = |p: i32| all.iter().map(|x| x.powi(p)).sum::<f64>() / n;
    // Standard errors of the first four moments of a normal sample: sqrt(1, 2, 15, 96 over n); 4 of them.
    for (p, want, variance) in [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
        let tolerance = 4.0 * f64::sqrt(variance / n);
        assert!((moment(p) - want).abs() < tolerance, "moment {p}: {} against {want} ± {tolerance}", moment(p));
    }
    // 1.349898e-3 of a normal sample lies beyond 3: a binomial count.
    let beyond = all.iter().filter(|&&x| x > 3.0).count() as f64;
    let want = 1.349_898e-3 * n;
    assert!((beyond - want).abs() < 4.0 * want.sqrt(), "{beyond} beyond 3 sigma, want {want}");
    assert!(all.iter().all(|x| x.abs() < 8.58));
}

#[test]
fn neighbours_are_strangers() {
    let base = |i, j| gaussian_pair(7, 0, i, j);
    type Other = fn(i32, i32) -> [f64; 2];
    let others: [(&str, Other); 7] = [
        ("next column", |i, j| gaussian_pair(7, 0, i + 1, j)),
        ("next row", |i, j| gaussian_pair(7, 0, i, j + 1)),
        ("transposed", |i, j| gaussian_pair(7, 0, j, i)),
        ("opposite wave", |i, j| gaussian_pair(7, 0, -i, -j)),
        ("next cascade", |i, j| gaussian_pair(7, 1, i, j)),
        ("next seed", |i, j| gaussian_pair(8, 0, i, j)),
        ("its own partner", |i, j| {
            let [a, b] = gaussian_pair(7, 0, i, j);
            [b, a]
        }),
    ];
    for (name, other) in others {
        let (mut plain, mut squares, mut n) = (0.0, 0.0, 0.0);
        for (i, j) in (1..200).flat_map(|j| (1..200).map(move |i| (i, j))).filter(|(i, j)| i != j) {
            let (a, b) = (base(i, j)[0], other(i, j)[0]);
            plain += a * b;
            squares += (a * a - 1.0) * (b * b - 1.0);
            n += 1.0;
        }
        // Correlation of n independent products: 1/sqrt(n), of the squares 2/sqrt(n). "transposed" meets each pair twice, so √2.
        let sigma = f64::sqrt(2.0 / n);
        assert!((plain / n).abs() < 4.0 * sigma, "{name}: correlation {}", plain / n);
        assert!((squares / n).abs() < 8.0 * sigma, "{name}: correlation of squares {}", squares / n);
    }
}

#[test]
fn every_key_bit_counts() {
    let base = bits(0x1234_5678, 2, 77, -5);
    let flips = (0..32).flat_map(|bit| {
        let one = 1u32 << bit;
        [
            bits(0x1234_5678 ^ one, 2, 77, -5),
            bits(0x1234_5678, 2 ^ one, 77, -5),
            bits(0x1234_5678, 2, 77 ^ one as i32, -5),
            bits(0x1234_5678, 2, 77, -5 ^ one as i32),
        ]
    });
    let mut total = 0.0;
    for (index, flipped) in flips.enumerate() {
        let changed = (base[0] ^ flipped[0]).count_ones() + (base[1] ^ flipped[1]).count_ones();
        // 128 fair coins: 64 ± 5.7; six sigma over 128 draws.
        assert!((30..=98).contains(&changed), "flip {index} changes {changed} of 128 bits");
        total += f64::from(changed);
    }
    // The mean of 128 such counts: 64 ± 0.5.
    assert!((total / 128.0 - 64.0).abs() < 2.0, "{}", total / 128.0);
}
