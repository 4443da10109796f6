//! Sums that keep their digits.
//!
//! Adding `n` numbers one after the other may lose `γₙ₋₁ Σ|x|`: the ten-millionth sample of a pixel meets a
//! sum so large that most of its digits fall off. Two cures: carry the lost digits along
//! ([`Sum`]), or add in pairs ([`pairwise`]).

use std::ops::AddAssign;

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

/// The largest block that [`pairwise`] adds one after the other.
///
/// Tuned: blocks of 1 cost a function call per term, blocks of 1024 lose the bound; 16 adds 11 roundings
/// to the depth of the tree.
const BLOCK: usize = 16;

/// The sum of a slice, halves added to halves.
///
/// - Domain: every slice; the empty one gives 0.
/// - Accuracy: `|error| ≤ γ_k Σ|x|` with `k = 15 + ⌈log₂(n/16)⌉` (`n > 16`): 35 roundings for a million terms.
/// - NaN in, NaN out.
/// - Source: Higham, *Accuracy and Stability of Numerical Algorithms* (2002), §4.2.
pub fn pairwise(terms: &[f64]) -> f64 {
    if terms.len() <= BLOCK {
        return terms.iter().fold(0.0, |sum, x| sum + x);
    }
    let (low, high) = terms.split_at(terms.len() / 2);
    pairwise(low) + pairwise(high)
}
