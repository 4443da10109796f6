//! Numbers of 106 bits: unevaluated sums of two `f64`, and the error-free steps they are made of.
//!
//! A rounded sum or product loses a remainder that is itself an `f64`; keeping it costs a few more
//! roundings. Here a predicate goes when plain `f64` cannot decide it (see [`super::certified`]).

use super::U;
use super::real::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `a + b = s + e` exactly, `s` the rounded sum.
///
/// - Source: Knuth, *The Art of Computer Programming* vol. 2 (1969), §4.2.2 theorem B.
#[inline]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let b_seen = s - a;
    (s, (a - (s - b_seen)) + (b - b_seen))
}

/// As [`two_sum`], where `|a| ≥ |b|` or `a = 0`.
#[inline]
pub fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// `a = high + low` exactly, each of at most 26 bits, so that products of halves are exact.
#[inline]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1: half of the 53 bits
    let c = SPLITTER * a;
    let high = c - (c - a);
    (high, a - high)
}

/// `a · b = p + e` exactly, `p` the rounded product.
///
/// Splitting is used rather than a fused multiply-add: the portable target has none in hardware, and a call
/// into the mathematics library costs more than the 17 operations here, which inline.
///
/// - Domain: `|a|, |b| < 2⁹⁹⁰`, and `|a b|` above `2⁻⁹⁶⁰` or zero; callers scale by powers of two.
/// - Source: Dekker, *A floating-point technique for extending the available precision* (1971).
#[inline]
pub fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

/// `a b − c d` with a relative error of at most `3 u`, however much of it cancels.
///
/// - Domain: that of [`two_product`] for both products.
/// - Source: W. Kahan's algorithm; bound by Jeannerod, Louvet & Muller (2013), here without FMA:
///   both products exact, three roundings, of which the last two cannot cancel.
#[inline]
pub fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (p, pe) = two_product(a, b);
    let (q, qe) = two_product(c, d);
    let (s, se) = two_sum(p, -q);
    s + (se + (pe - qe))
}

/// `high + low`, with `|low|` at most half a unit in the last place of `high`.
///
/// - Accuracy: relative error of a sum at most `3·2⁻¹⁰⁶`, of a product `5·2⁻¹⁰⁶`, of a quotient `10·2⁻¹⁰⁶`.
/// - Source: Joldes, Muller & Popescu, *Tight and rigorous error bounds for basic building blocks of
///   double-word arithmetic*, ACM TOMS 44(2) (2017).
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    pub high: f64,
    pub low: f64,
}

impl DoubleDouble {
    pub const ZERO: Self = DoubleDouble { high: 0.0, low: 0.0 };

    #[inline]
    pub const fn of(x: f64) -> Self {
        DoubleDouble { high: x, low: 0.0 }
    }

    /// `a + b`, exactly.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, b);
        DoubleDouble { high, low }
    }

    /// `a − b`, exactly.
    #[inline]
    pub fn difference(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, -b);
        DoubleDouble { high, low }
    }

    /// `a · b`, exactly (in the domain of [`two_product`]).
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        let (high, low) = two_product(a, b);
        DoubleDouble { high, low }
    }

    #[inline]
    pub fn square(self) -> Self {
        let (p, e) = two_product(self.high, self.high);
        let (high, low) = quick_two_sum(p, e + 2.0 * (self.high * self.low));
        DoubleDouble { high, low }
    }

    /// Times an `f64`.
    #[inline]
    pub fn scale(self, by: f64) -> Self {
        let (p, e) = two_product(self.high, by);
        let (high, low) = quick_two_sum(p, e + self.low * by);
        DoubleDouble { high, low }
    }

    /// Times a power of two, exactly (barring underflow).
    #[inline]
    pub fn shift(self, power_of_two: f64) -> Self {
        DoubleDouble { high: self.high * power_of_two, low: self.low * power_of_two }
    }

    /// The nearest `f64`.
    #[inline]
    pub fn value(self) -> f64 {
        self.high + self.low
    }

    /// Square root of a number `≥ 0`, by one Newton step from the `f64` root.
    pub fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::ZERO;
        }
        let root = self.high.sqrt();
        let rest = self - Self::product(root, root);
        let (high, low) = quick_two_sum(root, rest.high / (2.0 * root));
        DoubleDouble { high, low }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.high, other.high);
        let (t, f) = two_sum(self.low, other.low);
        let (s, e) = quick_two_sum(s, e + t);
        let (high, low) = quick_two_sum(s, e + f);
        DoubleDouble { high, low }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        DoubleDouble { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.high, other.high);
        let (high, low) = quick_two_sum(p, e + (self.high * other.low + self.low * other.high));
        DoubleDouble { high, low }
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let q = self.high / other.high;
        if !q.is_finite() {
            return Self::of(q);
        }
        let rest = self - other.scale(q);
        let (high, low) = quick_two_sum(q, rest.high / other.high);
        DoubleDouble { high, low }
    }
}

impl Real for DoubleDouble {
    const ZERO: Self = DoubleDouble::ZERO;
    const ROUNDOFF: f64 = 16.0 * U * U; // covers every operation above: a quotient errs by 10 u² at most
    #[inline]
    fn from_f64(x: f64) -> Self {
        DoubleDouble::of(x)
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.high
    }
    #[inline]
    fn sqrt(self) -> Self {
        DoubleDouble::sqrt(self)
    }
    fn with_sign_of(self, sign: Self) -> Self {
        if self.high.is_sign_negative() == sign.high.is_sign_negative() { self } else { -self }
    }
}
