//! Quadrics by the formulas as courses print them, expanded at the ray's origin in plain `f64`.

use super::Coefficients;
use crate::num::certified::{Roots, solve_quadratic};
use crate::ray::Ray;

/// All roots by (2) at the ray's origin, solved without cancellation.
///
/// - Accuracy: the roots of coefficients that are rounded relative to their largest term; a surface of
///   size 1 at distance 10⁸ is lost.
/// - Source: [A (5.12)–(5.17)].
pub fn textbook(q: &Coefficients, ray: &Ray) -> Vec<f64> {
    let [a, b, c] = q.along::<f64>(ray.origin, ray.direction, 0.0);
    let roots = match solve_quadratic(a, b, c) {
        Ok(Roots::Two(t0, t1)) => vec![t0, t1],
        Ok(Roots::One(t)) => vec![t],
        _ => vec![],
    };
    roots.into_iter().filter(|t| t.is_finite()).collect()
}

/// The first hit with the tolerances of 10⁻⁶ that A prints, whatever the scale of the coefficients.
///
/// `|A_q|` below it counts as a straight line, which loses rays almost parallel to a paraboloid's axis; a
/// discriminant below it is a miss, which loses small surfaces.
///
/// - Source: [A ill. 58].
pub fn as_printed(q: &Coefficients, ray: &Ray) -> Option<f64> {
    const PRINTED: f64 = 1e-6;
    let [a, half_b, c] = q.along::<f64>(ray.origin, ray.direction, 0.0);
    let b = 2.0 * half_b;
    if a.abs() <= PRINTED {
        let t = -c / b;
        return (t > PRINTED && t.is_finite()).then_some(t);
    }
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < PRINTED {
        return None;
    }
    let root = discriminant.sqrt();
    let (t0, t1) = ((-b - root) / (2.0 * a), (-b + root) / (2.0 * a));
    let t = match (t0 > PRINTED, t1 > PRINTED) {
        (true, true) => t0.min(t1),
        (true, false) => t0,
        _ => t1,
    };
    (t > PRINTED && t.is_finite()).then_some(t)
}
