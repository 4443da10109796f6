//! Error-free transformations, and double-double numbers built on them.
//!
//! A sum or a product of two `f64` is exactly the sum of two `f64`: the rounded result and its
//! rounding error. A double-double keeps both, and so computes with about 106 bits; it decides
//! what `f64` cannot (does this polynomial touch zero or miss it?) at about ten times the cost.
//!
//! Products are split by Veltkamp and Dekker: `f64::mul_add` would be one instruction with FMA
//! hardware, but on the default target it is a call into the C library, or a slow emulation.

use super::U;
use super::real::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `a + b = s + e` exactly: the rounded sum and its error.
///
/// - Domain: no overflow.
/// - Source: Knuth, *The Art of Computer Programming* 2 (1969), §4.2.2.
#[inline]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let bb = s - a;
    (s, (a - (s - bb)) + (b - bb))
}

/// `a + b = s + e` exactly, for `|a| ≥ |b|` or `a = 0`.
///
/// - Source: Dekker, *A floating-point technique for extending the available precision* (1971).
#[inline]
pub fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// `a b = p + e` exactly: the rounded product and its error.
///
/// - Domain: `|a|, |b| < 2⁹⁹⁶` and `|a b| < 2¹⁰²²`; the error is exact while `|a b| ≥ 2⁻⁹⁶⁸`.
/// - Source: Dekker (1971), with Veltkamp's split.
#[inline]
pub fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

/// Upper and lower half of the significand: `a = h + l`, 26 bits each.
#[inline]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let c = SPLITTER * a;
    let h = c - (c - a);
    (h, a - h)
}

/// `a b − c d` with a relative error of at most `3 u`, however much of it cancels.
///
/// - Domain: that of [`two_prod`] for both products.
/// - Source: W. Kahan's algorithm; bound by Jeannerod, Louvet & Muller (2013), here without FMA:
///   both products exact, three roundings, of which the last two cannot cancel.
#[inline]
pub fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (p, pe) = two_prod(a, b);
    let (q, qe) = two_prod(c, d);
    let (s, se) = two_sum(p, -q);
    s + (se + (pe - qe))
}

/// A double-double number: the unevaluated sum `hi + lo`, `hi` being the sum rounded to `f64`.
///
/// - Accuracy: relative error per operation, in `u²`: sum 3, product 7, quotient 15, square
///   root 8; all are covered by [`Real::ROUNDOFF`] `= 16 u² = 2⁻¹⁰²`.
/// - Source: Joldes, Muller & Popescu, *Tight and rigorous error bounds for basic building blocks
///   of double-word arithmetic*, ACM TOMS 44(2) (2017), algorithms 6, 10 and 17.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Dd {
    pub hi: f64,
    pub lo: f64,
}

impl Dd {
    #[inline]
    pub const fn new(x: f64) -> Self {
        Dd { hi: x, lo: 0.0 }
    }

    /// `a + b`, exactly.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Dd { hi, lo }
    }

    /// `a b`, exactly.
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_prod(a, b);
        Dd { hi, lo }
    }

    #[inline]
    pub fn square(self) -> Self {
        let (p, e) = two_prod(self.hi, self.hi);
        let (hi, lo) = fast_two_sum(p, e + 2.0 * (self.hi * self.lo));
        Dd { hi, lo }
    }

    /// Times an `f64`.
    #[inline]
    pub fn scale(self, by: f64) -> Self {
        let (p, e) = two_prod(self.hi, by);
        let (hi, lo) = fast_two_sum(p, e + self.lo * by);
        Dd { hi, lo }
    }

    /// Times a power of two, exactly (barring underflow).
    #[inline]
    pub fn shift(self, power_of_two: f64) -> Self {
        Dd { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }
}

impl From<f64> for Dd {
    fn from(x: f64) -> Self {
        Dd::new(x)
    }
}

impl Neg for Dd {
    type Output = Dd;
    #[inline]
    fn neg(self) -> Dd {
        Dd { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for Dd {
    type Output = Dd;
    #[inline]
    fn add(self, o: Dd) -> Dd {
        let (s, e) = two_sum(self.hi, o.hi);
        let (t, f) = two_sum(self.lo, o.lo);
        let (s, e) = fast_two_sum(s, e + t);
        let (hi, lo) = fast_two_sum(s, e + f);
        Dd { hi, lo }
    }
}

impl Sub for Dd {
    type Output = Dd;
    #[inline]
    fn sub(self, o: Dd) -> Dd {
        self + -o
    }
}

impl Mul for Dd {
    type Output = Dd;
    #[inline]
    fn mul(self, o: Dd) -> Dd {
        let (p, e) = two_prod(self.hi, o.hi);
        let (hi, lo) = fast_two_sum(p, e + (self.hi * o.lo + self.lo * o.hi));
        Dd { hi, lo }
    }
}

impl Div for Dd {
    type Output = Dd;
    #[inline]
    fn div(self, o: Dd) -> Dd {
        let q = self.hi / o.hi;
        let rest = self - o.scale(q);
        let (hi, lo) = fast_two_sum(q, rest.hi / o.hi);
        Dd { hi, lo }
    }
}

impl Real for Dd {
    const ZERO: Self = Dd::new(0.0);
    const ROUNDOFF: f64 = 16.0 * U * U;
    #[inline]
    fn from_f64(x: f64) -> Self {
        Dd::new(x)
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.hi
    }
    /// One Newton step from the `f64` root doubles its digits (Karp & Markstein, 1997).
    fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Dd::new(f64::sqrt(self.hi));
        }
        let root = self.hi.sqrt();
        let rest = self - Dd::product(root, root);
        let (hi, lo) = fast_two_sum(root, rest.hi / (2.0 * root));
        Dd { hi, lo }
    }
    fn with_sign_of(self, sign: Self) -> Self {
        if self.hi.is_sign_negative() == sign.hi.is_sign_negative() { self } else { -self }
    }
}
