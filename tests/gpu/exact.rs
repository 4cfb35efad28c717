//! Arithmetic with 106 bits: a number as the sum of two doubles that do not overlap (T. J. Dekker 1971, D. E. Knuth 1969).

use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug)]
pub struct Exact(pub f64, pub f64);

pub const PI: Exact = Exact(std::f64::consts::PI, 1.224_646_799_147_353_2e-16);

/// a + b and what its rounding has lost.
fn sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let c = s - a;
    (s, (a - (s - c)) + (b - c))
}

impl From<f64> for Exact {
    fn from(x: f64) -> Self {
        Self(x, 0.0)
    }
}

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (s, e) = sum(self.0, other.0);
        let (t, f) = sum(self.1, other.1);
        let (s, e) = sum(s, e + t);
        let (s, e) = sum(s, e + f);
        Self(s, e)
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let p = self.0 * other.0;
        let e = self.0.mul_add(other.0, -p) + (self.0 * other.1 + self.1 * other.0);
        let (p, e) = sum(p, e);
        Self(p, e)
    }
}

impl Div for Exact {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let q = Self::from(self.0 / other.0);
        let q = q + Self::from((self - q * other).0 / other.0);
        q + Self::from((self - q * other).0 / other.0)
    }
}

impl Exact {
    pub fn sqrt(self) -> Self {
        let root = Self::from(self.0.sqrt());
        root + (self - root * root) / (root + root)
    }

    /// Sine and cosine: Taylor's series of a sixteenth of the angle, doubled four times.
    pub fn sin_cos(self) -> (Self, Self) {
        let x = self * Self::from(1.0 / 16.0);
        let square = x * x;
        let (mut sin, mut less, mut term) = (x, Self::from(0.0), Self::from(1.0));
        let mut power = x;
        for n in 1..16 {
            let n = f64::from(2 * n);
            term = -term * square / Self::from((n - 1.0) * n);
            power = -power * square / Self::from(n * (n + 1.0));
            less = less + term;
            sin = sin + power;
        }
        // 1 − cos keeps its bits where the cosine is near one.
        let mut less = -less;
        for _ in 0..4 {
            let cos = Self::from(1.0) - less;
            (sin, less) = (Self::from(2.0) * sin * cos, Self::from(2.0) * sin * sin);
        }
        (sin, Self::from(1.0) - less)
    }
}
