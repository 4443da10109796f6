//! The normal distribution.

use super::continued_fraction;
use crate::num::U;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_SQRT_PI, TAU};

/// Where series and continued fraction of the error function meet.
///
/// Tuned: at 1 the fraction takes 90 steps, at 4 the series' 1 − erf has lost all digits; at 2, 30 each and two digits.
const MEET: f64 = 2.0;

/// The error function `erf x = 2/√π ∫₀ˣ e^(−t²) dt`.
///
/// - Domain: every `x`; ±∞ gives ±1.
/// - Accuracy: relative error ≤ `10 u`, as tested.
/// - NaN in, NaN out.
/// - Source: Abramowitz & Stegun (1964) 7.1.6 (series of positive terms), 7.1.14 (fraction).
pub fn erf(x: f64) -> f64 {
    if x.abs() < MEET { erf_by_series(x) } else { (1.0 - erfc_by_fraction(x.abs())).copysign(x) }
}

/// The complementary error function `erfc x = 1 − erf x`, in the tail to full relative accuracy.
///
/// - Domain: every `x`; +∞ gives 0, −∞ gives 2. Below `1e-308` (`x > 26.5`) digits fade into subnormals.
/// - Accuracy: relative error ≤ `10 u` for `x ≤ 1/2` and `x ≥ 2`, ≤ `1000 u` between, as tested: there `1 − erf x` cancels
///   up to `erf 2 / erfc 2 = 213`.
/// - NaN in, NaN out.
pub fn erfc(x: f64) -> f64 {
    if x.abs() < MEET {
        1.0 - erf_by_series(x)
    } else if x < 0.0 {
        2.0 - erfc_by_fraction(-x)
    } else {
        erfc_by_fraction(x)
    }
}

/// `2/√π e^(−x²) Σ 2ⁿ x^(2n+1) / (2n+1)!!`
fn erf_by_series(x: f64) -> f64 {
    let (mut term, mut sum, mut odd) = (x, x, 1.0);
    while term.abs() > U * sum.abs() {
        odd += 2.0;
        term *= 2.0 * x * x / odd;
        sum += term;
    }
    FRAC_2_SQRT_PI * exp_minus_square(x) * sum
}

/// `e^(−x²)/√π · 1/(x + ½/(x + 1/(x + 3/2/(x + …))))`
fn erfc_by_fraction(x: f64) -> f64 {
    if x == f64::INFINITY {
        return 0.0;
    }
    0.5 * FRAC_2_SQRT_PI * exp_minus_square(x) / continued_fraction(x, |k| (0.5 * k, x))
}

/// `e^(−x²)`; the rounding error of the square, `x² u`, would multiply the result's.
fn exp_minus_square(x: f64) -> f64 {
    let square = x * x;
    let lost = x.mul_add(x, -square);
    // An infinite square has lost ∞ − ∞.
    if square.is_finite() { (-square).exp() * (-lost).exp() } else { 0.0 }
}

/// The normal distribution function `Φ(z)`: the probability of a standard normal number below `z`.
///
/// - Domain: every `z`; ±∞ gives 1 or 0.
/// - Accuracy: that of [`erfc`], plus `z² u` relative from rounding `z/√2`.
/// - NaN in, NaN out.
pub fn normal_cdf(z: f64) -> f64 {
    0.5 * erfc(-z * FRAC_1_SQRT_2)
}

/// The normal quantile: the `z` with `Φ(z) = p`.
///
/// A rational guess, off by 4.5e-4 at most, and Halley's steps, which triple its digits, on the smaller tail.
///
/// - Domain: `0 ≤ p ≤ 1`; 0 gives −∞, 1 gives +∞. For the upper tail ask `-normal_quantile(q)` with `q = 1 − p` known
///   by itself: `p` near 1 holds few digits of it.
/// - Accuracy: absolute error ≤ `1e-15 max(1, |z|)` for `p ≥ 1e-300`, as tested.
/// - NaN in, NaN out.
/// - Source: guess by Hastings, in Abramowitz & Stegun (1964) 26.2.23; Halley (1694).
pub fn normal_quantile(p: f64) -> f64 {
    debug_assert!(!(p < 0.0 || p > 1.0), "quantile at {p}");
    if p <= 0.0 {
        return f64::NEG_INFINITY;
    }
    if p >= 1.0 {
        return f64::INFINITY;
    }
    if p > 0.5 {
        return -normal_quantile(1.0 - p);
    }
    let t = (-2.0 * p.ln()).sqrt();
    let numerator = 2.515517 + t * (0.802853 + t * 0.010328);
    let denominator = 1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308));
    let mut z = numerator / denominator - t;
    // 4.5e-4 → its cube, times z² at most: 1e-8 in the far tail → 1e-22.
    for _ in 0..2 {
        // (Φ(z) − p)/Φ′(z); Mills' ratio Φ/Φ′ lies between 1/(|z| + 1/|z|) and √(π/2).
        // The exponential in two halves: beyond |z| = 37.6 it would overflow, and subnormal `p` go there.
        let half = (0.25 * z * z).exp();
        let step = (normal_cdf(z) - p) * half * TAU.sqrt() * half;
        z -= step / (1.0 + 0.5 * z * step);
    }
    z
}
