//! Statistics: moments of samples, and the distributions that judge them.
//!
//! - [`Moments`]: mean and variance in one pass; [`median`], [`quartiles`], [`quantile`] of a slice.
//! - [`gamma_p`], [`gamma_q`], [`beta_inc`]: the incomplete functions behind every test.
//! - [`chi2_survival`], [`student_t_two_sided`], [`normal_quantile`]: p-values and critical values.
//! - [`sidak`]: how strict one test of many must be.
//!
//! Tests live in the tails, so each tail is computed by itself, never as one minus the other.

mod beta;
mod gamma;
mod moments;
mod normal;

pub use beta::{beta_inc, student_t_cdf, student_t_two_sided};
pub use gamma::{chi2_survival, gamma_p, gamma_q, ln_gamma};
pub use moments::{Moments, median, quantile, quartiles};
pub use normal::{erf, erfc, normal_cdf, normal_quantile};

/// Significance of each of `tests` independent tests such that all together err with probability `significance`.
///
/// ```text
/// α₁ = 1 − (1 − α)^(1/tests)
/// ```
///
/// - Domain: `0 ≤ significance < 1`, `tests ≥ 1`. One test keeps the significance.
/// - Accuracy: a few ulps; logarithm and exponential are taken near 0, where they keep their digits.
/// - Source: Šidák (1967).
pub fn sidak(significance: f64, tests: u32) -> f64 {
    -((-significance).ln_1p() / f64::from(tests)).exp_m1()
}

/// `ln(1 + x) − x`, which cancels its first order away.
///
/// ```text
/// r = x/(2 + x):    ln(1 + x) − x = −x r + 2 (r³/3 + r⁵/5 + …)
/// ```
///
/// - Domain: `x > −1`; −1 gives −∞.
/// - Accuracy: relative error about `20 u`: for |x| ≤ 1/2 the two terms differ by a factor of 4 or more in size;
///   beyond, the difference is at least a fifth of `ln(1 + x)`.
fn ln_1p_minus(x: f64) -> f64 {
    if x.abs() > 0.5 {
        return x.ln_1p() - x;
    }
    let r = x / (2.0 + x);
    let r2 = r * r;
    // r² ≤ 1/9 at x = −1/2: seventeen terms leave 9⁻¹⁷/37 < u/10 of the first.
    let tail = (1..=17).rev().fold(0.0, |s, k| s * r2 + 1.0 / f64::from(2 * k + 1));
    2.0 * r * r2 * tail - x * r
}

/// The part of Stirling's formula that is small: `δ(a) = ln Γ(a) − (a − ½) ln a + a − ½ ln 2π`.
///
/// - Domain: `a > 0`.
/// - Accuracy: absolute error about `4 u` for `a ≥ 10`, where seven terms of the series leave `2e-16`; below, the
///   recurrence `δ(a) = δ(a + 1) + (a + ½) ln(1 + 1/a) − 1` climbs there in at most ten steps.
/// - Source: Abramowitz & Stegun (1964) 6.1.40; as a correction: Loader (2000).
fn stirling_error(a: f64) -> f64 {
    // B₂ₖ / (2k (2k − 1)).
    const SERIES: [f64; 7] = [
        1.0 / 12.0,
        -1.0 / 360.0,
        1.0 / 1260.0,
        -1.0 / 1680.0,
        1.0 / 1188.0,
        -691.0 / 360_360.0,
        1.0 / 156.0,
    ];
    let (mut a, mut climbed) = (a, 0.0);
    while a < 10.0 {
        climbed += (a + 0.5) * (1.0 / a).ln_1p() - 1.0;
        a += 1.0;
    }
    let inverse2 = 1.0 / (a * a);
    climbed + SERIES.iter().rev().fold(0.0, |s, c| s * inverse2 + c) / a
}

/// Lentz's evaluation of `b₀ + a₁/(b₁ + a₂/(b₂ + …))`, to the last digit.
///
/// `term(k)` gives `(aₖ, bₖ)` for `k ≥ 1`. Ends when a factor is 1 to rounding; a NaN ends it at once.
///
/// - Source: Thompson & Barnett (1986), modified Lentz method.
fn continued_fraction(b0: f64, term: impl Fn(f64) -> (f64, f64)) -> f64 {
    // Stands for 0 in a denominator; it drops out of the product of two steps.
    let nonzero = |x: f64| if x == 0.0 { f64::MIN_POSITIVE } else { x };
    let (mut value, mut k) = (nonzero(b0), 0.0);
    let (mut c, mut d) = (value, 0.0);
    loop {
        k += 1.0;
        let (a, b) = term(k);
        d = 1.0 / nonzero(b + a * d);
        c = nonzero(b + a / c);
        let factor = c * d;
        value *= factor;
        let settled = (factor - 1.0).abs() <= 2.0 * crate::num::U;
        if settled || factor.is_nan() {
            return value;
        }
    }
}
