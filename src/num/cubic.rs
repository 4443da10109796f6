//! Real roots of cubics.

use super::polynomial;
use arrayvec::ArrayVec;

/// The distinct real roots of `a x³ + b x² + c x + d`, ascending.
///
/// Isolated between the stationary points, refined by Newton and bisection, polished with the residual in
/// double-double; where `f64` cannot count the roots, all is done in double-double.
///
/// - Domain: finite. `a = 0` leaves a quadratic; the zero polynomial has no list of roots.
/// - Accuracy: each root to 2 u relative, see [`polynomial::real_roots`].
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: Yuksel, *High-Performance Polynomial Root Finding for Graphics*, HPG (2022).
pub fn real_roots(a: f64, b: f64, c: f64, d: f64) -> ArrayVec<f64, 3> {
    polynomial::real_roots([d, c, b, a, 0.0]).into_iter().take(3).collect()
}

/// The largest real root of `x³ + a x² + b x + c`, in plain `f64`: what resolvents need.
///
/// ```text
/// x = y − a/3,  Q = (a² − 3b)/9,  R = (2a³ − 9ab + 27c)/54
/// three roots (R² < Q³):  y = −2√Q cos((θ ± 2π)/3),  cos θ = R/√Q³
/// one root:               y = A + Q/A,  A = −sign(R) ∛(|R| + √(R² − Q³))
/// ```
///
/// - Domain: coefficients between `10⁻⁵⁰` and `10⁵⁰` or zero.
/// - Accuracy: two Newton steps follow the closed form; the residual is a few u of the terms.
/// - Source: Press et al., *Numerical Recipes* (1992), §5.6.
pub(super) fn largest_root(a: f64, b: f64, c: f64) -> f64 {
    let q = (a * a - 3.0 * b) / 9.0;
    let r = (a * (2.0 * a * a - 9.0 * b) + 27.0 * c) / 54.0;
    let q3 = q * q * q;
    let y = if r * r < q3 {
        let theta = (r / q3.sqrt()).clamp(-1.0, 1.0).acos();
        -2.0 * q.sqrt() * ((theta + std::f64::consts::TAU) / 3.0).cos()
    } else {
        let s = -(r.abs() + (r * r - q3).max(0.0).sqrt()).cbrt().copysign(r);
        if s == 0.0 { 0.0 } else { s + q / s }
    };
    let mut x = y - a / 3.0;
    for _ in 0..2 {
        let f = ((x + a) * x + b) * x + c;
        let df = (3.0 * x + 2.0 * a) * x + b;
        let next = x - f / df;
        if next.is_finite() {
            x = next;
        }
    }
    x
}
