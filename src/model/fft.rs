//! The inverse Fourier transform in f64 that the GPU's is checked against: plain and exact before fast.
//!
//! Convention: `x[m] = Σ X[n] e^{+2πi nm/N}`, with no 1/N. Radix 2, decimation in time
//! ([Cooley and Tukey](crate::bibliography::CooleyTukey1965)); error about 1e-16 log₂N of the RMS.

/// A complex number, [re, im].
pub type Complex = [f64; 2];

/// a · b.
pub fn mul(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// e^{+2πi n/N} for n < N/2, each from its own sine and cosine.
fn twiddles(n: usize) -> Vec<Complex> {
    let turn = |i: usize| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / n as f64);
        [cos, sin]
    };
    (0..n / 2).map(turn).collect()
}

fn inverse_with(data: &mut [Complex], twiddles: &[Complex]) {
    let n = data.len();
    let bits = n.trailing_zeros();
    for i in 0..n {
        let j = i.reverse_bits() >> (usize::BITS - bits);
        if i < j {
            data.swap(i, j);
        }
    }
    let mut half = 1;
    while half < n {
        let stride = n / (2 * half);
        for block in data.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            for (i, (a, b)) in low.iter_mut().zip(high).enumerate() {
                let t = mul(*b, twiddles[i * stride]);
                (*a, *b) = ([a[0] + t[0], a[1] + t[1]], [a[0] - t[0], a[1] - t[1]]);
            }
        }
        half *= 2;
    }
}

/// Inverse transform in place.
///
/// # Panics
/// If the length is not a power of two of at least 2: lengths come from the program, not from users.
pub fn inverse(data: &mut [Complex]) {
    assert!(data.len() >= 2 && data.len().is_power_of_two(), "length {} is not a power of two", data.len());
    let twiddles = twiddles(data.len());
    inverse_with(data, &twiddles);
}

/// Two-dimensional inverse transform in place of rows of `n`, element (i, j) at j·n + i; there may be more or fewer rows.
///
/// # Panics
/// If n or the number of rows is not a power of two of at least 2.
pub fn inverse_2d(data: &mut [Complex], n: usize) {
    let m = data.len() / n.max(1);
    let usable = |side: usize| side >= 2 && side.is_power_of_two();
    assert!(usable(n) && usable(m) && data.len() == n * m, "grid of {} is not {n} x {m}", data.len());
    let along = twiddles(n);
    for row in data.chunks_exact_mut(n) {
        inverse_with(row, &along);
    }
    let along = twiddles(m);
    let mut column = vec![[0.0; 2]; m];
    for i in 0..n {
        for (j, value) in column.iter_mut().enumerate() {
            *value = data[j * n + i];
        }
        inverse_with(&mut column, &along);
        for (j, value) in column.iter().enumerate() {
            data[j * n + i] = *value;
        }
    }
}
