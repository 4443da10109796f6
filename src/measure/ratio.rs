//! Time as a ratio: two pieces of work run in turn, so that a busy machine slows both.

use super::{Spread, timed};
use std::fmt;

/// Pairs of runs behind a ratio.
const ROUNDS: usize = 41;
/// A run is this long at least, so that the clock's grain does not show \[s\].
const SHORTEST_RUN: f64 = 5.0e-4;

/// How many times as long one piece of work takes as another, with the quartiles over interleaved pairs of runs.
///
/// Displayed as `2.6 to 3.1 times`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratio(pub Spread);

impl Ratio {
    /// The ratio of paired times \[s\]; `None` without a pair of positive times.
    pub fn of_pairs(pairs: &[(f64, f64)]) -> Option<Ratio> {
        let quotients: Vec<f64> =
            pairs.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| p.0 / p.1).collect();
        Spread::median(&quotients).map(Ratio)
    }

    /// Runs `work` and `reference` in turn and compares each pair: what slows the machine for a while slows both.
    ///
    /// Both are repeated until a run lasts half a millisecond, the same number of times in every pair.
    pub fn measured<A, B>(mut work: impl FnMut() -> A, mut reference: impl FnMut() -> B) -> Ratio {
        fn calls<T>(work: &mut impl FnMut() -> T) -> usize {
            let seconds = timed(&mut *work).0.max(1.0e-9);
            (SHORTEST_RUN / seconds).ceil().clamp(1.0, 1.0e7) as usize
        }
        fn repeat<T>(calls: usize, work: &mut impl FnMut() -> T) -> f64 {
            timed(|| (0..calls).for_each(|_| drop(std::hint::black_box(work())))).0 / calls as f64
        }
        let (a, b) = (calls(&mut work), calls(&mut reference));
        let pairs: Vec<(f64, f64)> =
            (0..ROUNDS).map(|_| (repeat(a, &mut work), repeat(b, &mut reference))).collect();
        Ratio::of_pairs(&pairs).unwrap_or(Ratio(Spread::exact(f64::NAN)))
    }

    /// Does the middle half of the pairs lie on one side of `threshold`? Otherwise the machine was too busy to tell.
    pub fn tells(&self, threshold: f64) -> bool {
        self.0.low > threshold || self.0.high < threshold
    }

    /// `2.6 to 3.1 times`, or that the machine was too busy to tell whether it is more or less than `threshold`.
    pub fn words(&self, threshold: f64) -> String {
        if self.tells(threshold) {
            self.to_string()
        } else {
            format!("{self} (this machine was too busy to tell)")
        }
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = |x: f64| if x >= 10.0 { format!("{x:.0}") } else { format!("{x:.1}") };
        let (low, high) = (digits(self.0.low), digits(self.0.high));
        if low == high { write!(f, "{low} times") } else { write!(f, "{low} to {high} times") }
    }
}
