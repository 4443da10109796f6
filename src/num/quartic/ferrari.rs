//! Ferrari's two quadratics, in the order that cancels least.

use super::{Roots, with_scaled_roots};
use crate::num::{cubic, quadratic};

/// Real roots by Ferrari's factorisation from the largest root of the resolvent, then two Newton steps.
///
/// ```text
/// x = y − a₃/4:   y⁴ + p y² + q y + r = (y² + e y + f)(y² − e y + g)
/// resolvent:      m³ + 2p m² + (p² − 4r) m − q² = 0,   e = √m,  m its largest root
/// f, g = (p + m ∓ q/e)/2, the smaller one as r over the larger
/// ```
///
/// - Domain: finite; scaled by a power of two first.
/// - Accuracy: the shift by `a₃/4` costs small roots their digits, Newton's steps restore those of simple
///   roots; pairs closer than about `√u` of the largest root may appear or disappear.
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: Ferrari in Cardano, *Ars Magna* (1545); order of operations after Herbison-Evans,
///   *Solving Quartics and Cubics for Graphics* (1995).
pub fn ferrari(a3: f64, a2: f64, a1: f64, a0: f64) -> Roots {
    with_scaled_roots([a0, a1, a2, a3], |[a0, a1, a2, a3]| {
        let h = 0.25 * a3;
        let p = a2 - 6.0 * h * h;
        let q = a1 - 2.0 * a2 * h + 8.0 * h * h * h;
        let r = a0 - h * (a1 - h * (a2 - 3.0 * h * h));
        let m = cubic::largest_root(2.0 * p, p * p - 4.0 * r, -q * q).max(0.0);
        let e = m.sqrt();
        let (f, g) = factors(p, q, r, m, e);
        let mut roots = Roots::new();
        for y in quadratic::real_roots(1.0, e, f).into_iter().chain(quadratic::real_roots(1.0, -e, g)) {
            roots.push(newton([a0, a1, a2, a3], y - h));
        }
        roots
    })
}

/// The constant terms of the two quadratics.
fn factors(p: f64, q: f64, r: f64, m: f64, e: f64) -> (f64, f64) {
    if e == 0.0 {
        // Biquadratic with no room between the halves: y² = −p/2 ± √(p²/4 − r).
        let d = (0.25 * p * p - r).max(0.0).sqrt();
        return (0.5 * p - d, 0.5 * p + d);
    }
    let (sum, difference) = (0.5 * (p + m), 0.5 * q / e);
    let (f, g) = (sum - difference, sum + difference);
    if f.abs() < g.abs() {
        (r / g, g)
    } else if f == 0.0 {
        (0.0, g)
    } else {
        (f, r / f)
    }
}

/// Newton's steps while the residual falls.
fn newton(c: [f64; 4], mut x: f64) -> f64 {
    let value = |x: f64| (((x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
    let mut f = value(x);
    for _ in 0..2 {
        let next = x - f / (((4.0 * x + 3.0 * c[3]) * x + 2.0 * c[2]) * x + c[1]);
        let f_next = value(next);
        if f_next.abs() < f.abs() {
            (x, f) = (next, f_next);
        }
    }
    x
}
