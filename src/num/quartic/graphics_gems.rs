//! The quartic solver that the course document prints a call of, kept for what it loses.

use super::{Roots, distinct};
use std::f64::consts::PI;

/// What counts as zero, whatever the scale: the historical value.
const ABSOLUTE_ZERO: f64 = 1e-9;

fn is_zero(x: f64) -> bool {
    x > -ABSOLUTE_ZERO && x < ABSOLUTE_ZERO
}

/// Real roots by Cardano's and Ferrari's formulas, with an absolute epsilon, as published.
///
/// ```text
/// x = y − a₃/4:       y⁴ + p y² + q y + r
/// resolvent:          z³ − (p/2) z² − r z + (r p/2 − q²/8) = 0
/// two quadratics:     y² ± v y + z ∓ sign(q) u = 0,   u² = z² − r,   v² = 2z − p
/// ```
///
/// Correct algebra; but it takes any number below `10⁻⁹` for zero, takes whatever root of the
/// resolvent comes first, gives up when rounding makes `u²` or `v²` negative, and never polishes. It serves as
/// the historical contestant: use [`super::adaptive`].
///
/// - Accuracy: none promised: small roots vanish, close pairs appear and disappear.
/// - NaN: overflow gives no roots.
/// - Source: Schwarze, *Cubic and Quartic Roots*, Graphics Gems (1990), pp. 404–407 and 738–786; called
///   by [A §5.4.4, ill. 59].
pub fn graphics_gems_as_printed(a3: f64, a2: f64, a1: f64, a0: f64) -> Roots {
    let sq = a3 * a3;
    let p = -3.0 / 8.0 * sq + a2;
    let q = 1.0 / 8.0 * sq * a3 - 1.0 / 2.0 * a3 * a2 + a1;
    let r = -3.0 / 256.0 * sq * sq + 1.0 / 16.0 * sq * a2 - 1.0 / 4.0 * a3 * a1 + a0;
    let mut roots = Roots::new();
    if is_zero(r) {
        roots.extend(cubic(0.0, p, q).into_iter().chain([Some(0.0)]).flatten());
    } else {
        let resolvent = cubic(-0.5 * p, -r, 0.5 * r * p - 1.0 / 8.0 * q * q);
        let Some(z) = resolvent[0] else { return roots };
        let (Some(u), Some(v)) = (root_or_give_up(z * z - r), root_or_give_up(2.0 * z - p)) else {
            return roots;
        };
        let signed = if q < 0.0 { -v } else { v };
        let pairs = quadratic(signed, z - u).into_iter().chain(quadratic(-signed, z + u));
        roots.extend(pairs.flatten());
    }
    roots = roots.into_iter().map(|y| y - 0.25 * a3).filter(|x| x.is_finite()).collect();
    distinct(roots)
}

/// `√x`, or nothing if `x` is negative by more than the absolute epsilon.
fn root_or_give_up(x: f64) -> Option<f64> {
    if is_zero(x) { Some(0.0) } else { (x > 0.0).then(|| x.sqrt()) }
}

/// Roots of `x² + b x + c`.
fn quadratic(b: f64, c: f64) -> [Option<f64>; 2] {
    let half = b / 2.0;
    let d = half * half - c;
    if is_zero(d) {
        [Some(-half), None]
    } else if d < 0.0 {
        [None, None]
    } else {
        [Some(d.sqrt() - half), Some(-d.sqrt() - half)]
    }
}

/// Roots of `x³ + a x² + b x + c`.
fn cubic(a: f64, b: f64, c: f64) -> [Option<f64>; 3] {
    let sq = a * a;
    let p = 1.0 / 3.0 * (-1.0 / 3.0 * sq + b);
    let q = 1.0 / 2.0 * (2.0 / 27.0 * a * sq - 1.0 / 3.0 * a * b + c);
    let p3 = p * p * p;
    let d = q * q + p3;
    let roots = if is_zero(d) {
        if is_zero(q) {
            [Some(0.0), None, None]
        } else {
            let u = (-q).cbrt();
            [Some(2.0 * u), Some(-u), None]
        }
    } else if d < 0.0 {
        let phi = 1.0 / 3.0 * (-q / (-p3).sqrt()).acos();
        let t = 2.0 * (-p).sqrt();
        [Some(t * phi.cos()), Some(-t * (phi + PI / 3.0).cos()), Some(-t * (phi - PI / 3.0).cos())]
    } else {
        let root = d.sqrt();
        [Some((root - q).cbrt() - (root + q).cbrt()), None, None]
    };
    roots.map(|x| x.map(|x| x - 1.0 / 3.0 * a))
}
