//! Time, measured so that the clock's grain does not show.

use super::Spread;
use std::hint::black_box;
use std::time::Instant;

/// Runs behind each median.
const RUNS: usize = 9;
/// A run is long enough when the clock's grain (some 10⁻⁸ s) and a call of the clock are below 10⁻⁴ of it [s].
const SHORTEST_RUN: f64 = 1.0e-3;

/// Runs once, and returns the seconds with the result.
pub fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = black_box(work());
    (start.elapsed().as_secs_f64(), result)
}

/// Time of one call \[s\]: the median of nine runs with its quartiles, each run repeating the call until it
/// lasts a millisecond. The result of the call is kept from the optimiser.
pub fn time<T>(mut work: impl FnMut() -> T) -> Spread {
    let mut calls = 1u64;
    loop {
        let seconds = repeat(calls, &mut work);
        if seconds >= SHORTEST_RUN || calls >= 1 << 40 {
            break;
        }
        // Aim a fifth beyond the goal, and at most a hundredfold at a time: the first run is the least certain.
        let wanted = calls as f64 * 1.2 * SHORTEST_RUN / seconds.max(1.0e-9);
        calls = (wanted.ceil() as u64).clamp(calls + 1, calls * 100);
    }
    let runs: Vec<f64> = (0..RUNS).map(|_| repeat(calls, &mut work) / calls as f64).collect();
    Spread::median(&runs).unwrap_or(Spread::exact(0.0))
}

/// Time per item of a batch of `items` that one call works through \[s\].
pub fn time_each<T>(items: usize, work: impl FnMut() -> T) -> Spread {
    time(work).times(1.0 / items.max(1) as f64)
}

fn repeat<T>(calls: u64, work: &mut impl FnMut() -> T) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        black_box(work());
    }
    start.elapsed().as_secs_f64()
}
