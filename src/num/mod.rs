//! Numbers: rounding bounds, polynomial roots, sums.

pub mod certified;
pub mod counted;
pub mod cubic;
pub mod double_double;
pub mod expansion;
pub mod polynomial;
pub mod quadratic;
pub mod quadrature;
pub mod quartic;
pub mod real;
pub mod statistics;
pub mod sum;
pub mod vectors;

/// Unit roundoff `u = 2⁻⁵³` of `f64`: the largest relative error of one rounding to nearest.
pub const U: f64 = f64::EPSILON / 2.0;

/// `γₙ = n u / (1 − n u)`: bound on the relative error of `n` successive roundings.
///
/// - Domain: `n u < 1`.
/// - Source: Higham, *Accuracy and Stability of Numerical Algorithms* (2002), Lemma 3.1.
pub const fn gamma(n: u32) -> f64 {
    let nu = n as f64 * U;
    nu / (1.0 - nu)
}
