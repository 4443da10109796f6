//! Sums that keep their digits.
//!
//! Adding `n` numbers one after the other may lose `γₙ₋₁ Σ|x|`: the ten-millionth sample of a pixel meets a
//! sum so large that most of its digits fall off. Two cures: carry the lost digits along
//! ([`Sum`]), or add in pairs ([`pairwise`]).

use std::ops::{Add, AddAssign, Range};

/// A running sum that carries its rounding errors along (Neumaier's variant of Kahan's sum).
///
/// ```text
/// t = s + x;    e += (s − t) + x  if |s| ≥ |x|,  else  (x − t) + s;    s = t;    value = s + e
/// ```
///
/// - Domain: finite terms whose partial sums do not overflow; else the value is what plain addition
///   gives (±∞, or NaN where +∞ meets −∞ or NaN goes in).
/// - Accuracy: `|value − Σx| ≤ u |Σx| + γₙ₋₁² Σ|x|`: as if computed with twice the digits, and then rounded.
/// - Source: Neumaier (1974); bound: Ogita, Rump & Oishi, *Accurate sum and dot product* (2005), Prop. 4.5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sum {
    sum: f64,
    error: f64,
}

impl Sum {
    pub const ZERO: Sum = Sum { sum: 0.0, error: 0.0 };

    /// The sum so far.
    pub fn value(&self) -> f64 {
        // Once the sum is infinite its error is ∞ − ∞.
        if self.sum.is_finite() { self.sum + self.error } else { self.sum }
    }
}

impl AddAssign<f64> for Sum {
    #[inline]
    fn add_assign(&mut self, x: f64) {
        let total = self.sum + x;
        self.error += if self.sum.abs() >= x.abs() { (self.sum - total) + x } else { (x - total) + self.sum };
        self.sum = total;
    }
}

/// Joins two sums; in a fixed order of joins the result is reproducible.
impl AddAssign<Sum> for Sum {
    fn add_assign(&mut self, other: Sum) {
        *self += other.sum;
        self.error += other.error;
    }
}

impl FromIterator<f64> for Sum {
    fn from_iter<I: IntoIterator<Item = f64>>(terms: I) -> Self {
        let mut sum = Sum::ZERO;
        for x in terms {
            sum += x;
        }
        sum
    }
}

/// Terms that a leaf of [`pairwise`] adds one after the other.
const LEAF: usize = 64;
/// Terms from which halves are worth a thread each. Tuned: from 2¹² a join (up to 10 µs) costs what it
/// saves, from 2²⁰ a usual picture is never shared; 2¹⁵ terms of three channels take about 0.1 ms.
const FORK: usize = 1 << 15;

/// `Σ term(i)` over a range, in an order that depends on the range alone: halves are summed apart
/// and then added, however many threads help.
///
/// - Accuracy: `super::gamma(64 + ⌈log₂(n/64)⌉)` relative to `Σ |term|`: a million pixels lose
///   at most 1e-14, so that nothing is won by compensation.
/// - NaN goes through.
/// - Source: Higham, *Accuracy and Stability of Numerical Algorithms* (2002) §4.2.
pub fn pairwise<T>(range: Range<usize>, term: &(impl Fn(usize) -> T + Sync)) -> T
where
    T: Add<Output = T> + Default + Send,
{
    let count = range.len();
    if count <= LEAF {
        return range.fold(T::default(), |sum, i| sum + term(i));
    }
    let middle = range.start + count / 2;
    let low = || pairwise(range.start..middle, term);
    let high = || pairwise(middle..range.end, term);
    let (low, high) = if count >= FORK { rayon::join(low, high) } else { (low(), high()) };
    low + high
}
