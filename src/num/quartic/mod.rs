//! Real roots of quartics: six methods for one question.
//!
//! Each method takes the coefficients of `x⁴ + a₃ x³ + a₂ x² + a₁ x + a₀` and answers with the
//! distinct real roots, ascending. They differ in what they do to the digits:
//!
//! | method | how | loses |
//! |---|---|---|
//! | [`adaptive`] | brackets between stationary points, every sign certified, else double-double | nothing |
//! | [`bracketed`] | the same brackets in plain `f64` | pairs closer than √u |
//! | [`algorithm_1010`] | two quadratic factors from an LDLᵀ decomposition | the like |
//! | [`ferrari`] | two quadratic factors from the largest root of the resolvent | digits of small roots, close pairs |
//! | [`sturm`] | sign changes in Sturm's chain, then bisection | time |
//! | [`graphics_gems_as_printed`] | Cardano and Ferrari with an absolute epsilon | small, large and close roots |

mod algorithm_1010;
mod ferrari;
mod graphics_gems;
mod sturm;

pub use algorithm_1010::algorithm_1010;
pub use ferrari::ferrari;
pub use graphics_gems::graphics_gems_as_printed;
pub use sturm::sturm;

use super::polynomial::{self, Polynomial, isolate, refine};
use arrayvec::ArrayVec;

/// Distinct real roots, ascending.
pub type Roots = ArrayVec<f64, 4>;

/// A method: `(a₃, a₂, a₁, a₀)` to the roots of the monic quartic.
pub type Solver = fn(f64, f64, f64, f64) -> Roots;

/// Real roots with certified count: the default.
///
/// Brackets between stationary points in `f64`; each sign that decides the count is compared with its rounding
/// error, and a quartic with a doubtful sign is solved in double-double. Roots are polished with
/// a residual in double-double.
///
/// - Domain: finite. Newton's polygon splits the roots by magnitude, so that neither `10³⁰⁰` nor
///   `10⁻³⁰⁰`, nor both in one quartic, over- or underflow before a root does.
/// - Accuracy: each root to 2 u relative; a multiple root counts once. See [`polynomial::real_roots`].
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: brackets: Yuksel, HPG (2022); two precisions: in the manner of Shewchuk's adaptive
///   predicates (1997).
pub fn adaptive(a3: f64, a2: f64, a1: f64, a0: f64) -> Roots {
    polynomial::real_roots([a0, a1, a2, a3, 1.0])
}

/// Real roots between stationary points, in plain `f64`.
///
/// - Domain: finite; scaled by a power of two such that all roots are in `[−4, 4]`; roots below
///   `10⁻⁸⁰` of the largest are lost to underflow.
/// - Accuracy: backward stable for each root; pairs closer than about `√u` relative may be taken for
///   none, and a touch for a pair or nothing: the sign at the stationary point is rounding.
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: Yuksel, *High-Performance Polynomial Root Finding for Graphics*, HPG (2022).
pub fn bracketed(a3: f64, a2: f64, a1: f64, a0: f64) -> Roots {
    with_scaled_roots([a0, a1, a2, a3], |c| {
        let p = Polynomial::new([c[0], c[1], c[2], c[3], 1.0]);
        isolate(&p, -4.0, 4.0, 0.0).brackets.iter().map(|b| refine(&p, b)).collect()
    })
}

/// Runs `solve` on the quartic of `x/2ˢ`, whose coefficients are at most 2 and roots at most 4 in magnitude.
fn with_scaled_roots(c: [f64; 4], solve: impl Fn([f64; 4]) -> Roots) -> Roots {
    if c.iter().any(|x| !x.is_finite()) {
        return Roots::new();
    }
    let shift_for = |k: usize| -(-polynomial::exponent(c[k])).div_euclid(4 - k as i32);
    let Some(shift) = (0..4).filter(|&k| c[k] != 0.0).map(shift_for).max() else {
        return Roots::from_iter([0.0]);
    };
    let mut scaled = c;
    for (k, x) in scaled.iter_mut().enumerate() {
        *x = polynomial::times_power_of_two(*x, -(4 - k as i32) * shift);
    }
    let mut roots: Roots =
        solve(scaled).into_iter().map(|y| polynomial::times_power_of_two(y, shift)).collect();
    roots.retain(|x| x.is_finite());
    distinct(roots)
}

/// Ascending, equal values once.
fn distinct(mut roots: Roots) -> Roots {
    roots.sort_unstable_by(f64::total_cmp);
    let mut out = Roots::new();
    for x in roots {
        if out.last() != Some(&x) {
            out.push(x);
        }
    }
    out
}
