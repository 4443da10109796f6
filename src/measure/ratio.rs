//! Time as a ratio: pieces of work run in turn, so that a busy machine slows all of them alike.

use super::{Spread, timed};
use std::cmp::Ordering;
use std::fmt;
use std::hint::black_box;

/// Rounds behind a ratio.
pub const ROUNDS: usize = 41;
/// A run is this long at least, so that the clock's grain does not show \[s\].
const SHORTEST_RUN: f64 = 5.0e-4;

/// Times of several pieces of work that took turns.
#[derive(Clone, Debug, PartialEq)]
pub struct Interleaved {
    /// Of each piece of work, its seconds a call in every round.
    pub seconds: Vec<Vec<f64>>,
}

/// Runs all pieces of work once a round, in their order and in the next round backwards, so that neither a busy moment nor
/// a slow drift of the machine favours one of them.
///
/// Each is repeated until a run lasts half a millisecond, the same number of times in every round. What a piece of work
/// computes must go through [`black_box`]: the compiler leaves out what nobody uses.
pub fn interleaved(works: &mut [&mut dyn FnMut()], rounds: usize) -> Interleaved {
    let calls: Vec<usize> = works
        .iter_mut()
        .map(|work| (SHORTEST_RUN / timed(&mut **work).0.max(1.0e-9)).ceil().clamp(1.0, 1.0e7) as usize)
        .collect();
    let mut seconds = vec![Vec::with_capacity(rounds); works.len()];
    for round in 0..rounds {
        for k in 0..works.len() {
            let i = if round % 2 == 0 { k } else { works.len() - 1 - k };
            let run = timed(|| (0..calls[i]).for_each(|_| works[i]())).0;
            seconds[i].push(run / calls[i] as f64);
        }
    }
    Interleaved { seconds }
}

impl Interleaved {
    /// Seconds a call of one piece of work: median and quartiles over the rounds; `None` without rounds.
    pub fn time(&self, work: usize) -> Option<Spread> {
        Spread::median(&self.seconds[work])
    }

    /// How many times as long the one takes as the other; `None` without a round of positive times.
    pub fn ratio(&self, work: usize, reference: usize) -> Option<Ratio> {
        let pairs = self.seconds[work].iter().copied().zip(self.seconds[reference].iter().copied());
        Ratio::of_pairs(&pairs.collect::<Vec<_>>())
    }
}

/// How many times as long one piece of work takes as another: median and quartiles of the quotients of paired times.
///
/// Displayed as `2.6 to 3.1 times`: the quartiles. The quotient of one round compares two runs that follow each other, so
/// that a load which lasts for some rounds cancels in it; the median and the quartiles ignore the rounds in which a load
/// came or went. A finding asks for a quartile beyond the threshold, that is, for three quarters of the rounds on one side
/// of it. With equally fast pieces of work that happens by chance as often as a coin falls alike 31 times or more of 41,
/// once in 1379 on either side; with fewer than [`Ratio::FEWEST`] rounds it is no finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratio(pub Spread);

impl Ratio {
    /// Rounds that a finding needs at least: of 16, twelve alike come by chance once in 26 on either side.
    pub const FEWEST: usize = 16;

    /// The ratio of paired times \[s\]; `None` without a pair of positive times.
    pub fn of_pairs(pairs: &[(f64, f64)]) -> Option<Ratio> {
        let quotients: Vec<f64> =
            pairs.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| p.0 / p.1).collect();
        Spread::median(&quotients).map(Ratio)
    }

    /// Runs `work` and `reference` in turn and compares each pair; see [`interleaved`].
    pub fn measured<A, B>(mut work: impl FnMut() -> A, mut reference: impl FnMut() -> B) -> Ratio {
        let (mut work, mut reference) = (|| drop(black_box(work())), || drop(black_box(reference())));
        let times = interleaved(&mut [&mut work, &mut reference], ROUNDS);
        times.ratio(0, 1).unwrap_or(Ratio(Spread { runs: 0, ..Spread::exact(f64::NAN) }))
    }

    /// Whether the ratio is greater or less than `threshold`; `None` if the machine was too busy, or too little was
    /// measured, to tell.
    pub fn finding(&self, threshold: f64) -> Option<Ordering> {
        match self.0.runs {
            runs if runs < Self::FEWEST => None,
            _ if self.0.low > threshold => Some(Ordering::Greater),
            _ if self.0.high < threshold => Some(Ordering::Less),
            _ => None,
        }
    }

    /// Is there a [`Ratio::finding`]?
    pub fn tells(&self, threshold: f64) -> bool {
        self.finding(threshold).is_some()
    }

    /// `2.6 to 3.1 times`; and that the machine was too busy to tell, unless it is more or less than `threshold`.
    pub fn words(&self, threshold: f64) -> String {
        if self.tells(threshold) {
            self.to_string()
        } else {
            format!("{self} (this machine was too busy to tell)")
        }
    }

    /// `2.6 to 3.1 times` if it differs from 1, else "this machine was too busy to tell": the end of a sentence.
    pub fn times_or_busy(&self) -> String {
        if self.tells(1.0) { self.to_string() } else { "this machine was too busy to tell".to_string() }
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = |x: f64| match x {
            x if x >= 10.0 => format!("{x:.0}"),
            x if x < 1.0 => format!("{x:.2}"),
            x => format!("{x:.1}"),
        };
        let (low, high) = (digits(self.0.low), digits(self.0.high));
        if low == high { write!(f, "{low} times") } else { write!(f, "{low} to {high} times") }
    }
}
