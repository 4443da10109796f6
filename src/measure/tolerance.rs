//! Tolerances, one constructor per kind: a test names why it forgives, and how much follows.

use crate::num::gamma;

/// Standard deviations that a statistical test allows.
///
/// The whole suite of `m` such tests shall err once in 10⁶: by Šidák each may err `α = 1 − (1 − 10⁻⁶)^{1/m}`. With
/// `m = 1000`, more than the suite holds, `α = 1.0·10⁻⁹`, two-sided; `2 (1 − Φ(z)) = α` at `z = 6.1094`.
///
/// - Source: Šidák, *Rectangular confidence regions* (1967).
pub const Z: f64 = 6.11;

/// What `n_ops` successive roundings do to a number of size `scale`: `γₙ · scale`.
pub fn rounding(n_ops: u32, scale: f64) -> f64 {
    gamma(n_ops) * scale.abs()
}

/// The error that a method promises.
pub fn promised(accuracy: f64) -> f64 {
    accuracy.abs()
}

/// A series or iteration cut off: the size of the first term left out.
pub fn truncation(next_term: f64) -> f64 {
    next_term.abs()
}

/// Half a level of a quantised value \[levels\].
pub fn quantised() -> f64 {
    0.5
}

/// A mean of `n` independent draws of standard deviation `sigma`: `z σ / √n`, with [`Z`].
pub fn statistical(sigma: f64, n: u64) -> f64 {
    Z * sigma / (n as f64).sqrt()
}

/// Do the two numbers agree within the tolerance? NaN never agrees; equal infinities do.
pub fn agrees(found: f64, expected: f64, tolerance: f64) -> bool {
    found == expected || (found - expected).abs() <= tolerance
}
