//! The sphere exactly as three documents print it, errata and all: first meeting in front of the origin, or none.

use super::method::Pair;
use crate::num::real::{Real, Triple, dot};

/// The listing of [A ill. 57]: a discriminant or a root below 10⁻⁶ is no hit, whatever the unit of length.
///
/// - Errata: spheres of a radius below 5·10⁻⁴ units are invisible (`D = 4 h² < 10⁻⁶`).
pub fn with_fixed_epsilon<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Option<R> {
    let (two, epsilon) = (R::from_f64(2.0), R::from_f64(1.0e-6));
    let b = two * dot(f, d);
    let c = dot(f, f) - r * r;
    let discriminant = b * b - two * two * c;
    if discriminant < epsilon {
        return None;
    }
    let root = discriminant.sqrt();
    let half = R::from_f64(0.5);
    let (t0, t1) = ((-b - root) * half, (-b + root) * half);
    [t0, t1].into_iter().find(|t| *t > epsilon)
}

/// The steps of [B §6.2.1]: a centre behind the origin is a miss.
///
/// - Errata: an origin inside the sphere with the centre behind it sees nothing; the text's `d < 0` tests nothing.
pub fn with_centre_in_front<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Pair<R> {
    let to_closest = -dot(f, d);
    if to_closest < R::ZERO {
        return None;
    }
    let d2 = dot(f, f) - to_closest * to_closest;
    if d2 > r * r {
        return None;
    }
    let half_chord = (r * r - d2).sqrt();
    Some((to_closest - half_chord, to_closest + half_chord))
}

/// The six steps of [C §1.6.1]: the second root only if the first is not positive.
///
/// - Errata: `D ≤ 0` is printed as a miss; at `D = 0` the same section describes a tangent that hits.
pub fn without_tangent<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Option<R> {
    let two = R::from_f64(2.0);
    let b = two * dot(f, d);
    let c = dot(f, f) - r * r;
    let discriminant = b * b - two * two * c;
    if !(discriminant > R::ZERO) {
        return None;
    }
    let root = discriminant.sqrt();
    let t0 = (-b - root) / two;
    if t0 > R::ZERO {
        return Some(t0);
    }
    let t1 = (-b + root) / two;
    (t1 >= R::ZERO).then_some(t1)
}
