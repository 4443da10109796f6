//! Three ways to meet a sphere, each for any arithmetic: [C §1.6], [B §6.2], and Haines et al.
//!
//! With `f = o − c` (from the centre to the origin), the ray meets the sphere where
//!
//! ```text
//! |f + t d|² = r²     ⇔     (d·d) t² + 2 (f·d) t + (f·f − r²) = 0
//! ```
//!
//! They agree in exact arithmetic, and differ in what rounding takes from them when the origin
//! is far away (`|f| ≫ r`) or close to the surface.

use crate::num::real::{Real, Triple, along, dot};

/// Both roots of the line, ascending; `None` if the line misses. A tangent gives two equal roots.
pub type Pair<R> = Option<(R, R)>;

/// The textbook's quadratic.
///
/// ```text
/// B = 2 (f·d),  C = f·f − r²,  D = B² − 4C,   t = (−B ± √D)/2
/// ```
///
/// - Domain: `d` a unit vector.
/// - Accuracy: `D` is the difference of two numbers of size `|f|²`: at `|f|/r = 1/√u` nothing of the
///   sphere is left in it. The root nearer to 0 loses digits when the origin is near the surface.
/// - Source: [C §1.6], with the tangent counted as a hit (see the errata).
pub fn algebraic<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Pair<R> {
    let two = R::from_f64(2.0);
    let b = two * dot(f, d);
    let c = dot(f, f) - r * r;
    let discriminant = b * b - two * two * c;
    if !(discriminant >= R::ZERO) {
        return None;
    }
    let root = discriminant.sqrt();
    Some(((-b - root) / two, (-b + root) / two))
}

/// The triangle between origin, centre and the point of closest approach.
///
/// ```text
/// t_ca = −f·d,   d² = f·f − t_ca²,   t_hc = √(r² − d²),   t = t_ca ∓ t_hc
/// ```
///
/// - Domain: `d` a unit vector. Origins inside the sphere too: the test `t_ca < 0` that [B §6.2.1]
///   prints as a miss comes with a condition it forgot, that the origin is outside.
/// - Accuracy: `d²` is the difference of two numbers of size `|f|²`, like `D` in [`algebraic`].
/// - Source: [B §6.2.1], corrected.
pub fn geometric<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Pair<R> {
    let to_closest = -dot(f, d);
    let d2 = dot(f, f) - to_closest * to_closest;
    let half_chord2 = r * r - d2;
    if !(half_chord2 >= R::ZERO) {
        return None;
    }
    let half_chord = half_chord2.sqrt();
    Some((to_closest - half_chord, to_closest + half_chord))
}

/// The default: the distance of the line from the centre is measured, not subtracted.
///
/// ```text
/// b = −f·d,  a = d·d,   l = f + (b/a) d,   Δ = r² − l·l
/// q = b + sign(b) √(a Δ),   t = { (f·f − r²)/q,  q/a }
/// ```
///
/// `l` is the vector from the centre to the closest point of the line; its error is `|f|` roundings,
/// not `|f|²`. The second line adds numbers of one sign only, so neither root cancels.
///
/// - Domain: any `d ≠ 0`; squares of the inputs must not overflow (see `Sphere::nearest`).
/// - Accuracy: relative error of the roots ≤ a few u times the condition number of the root itself.
/// - Source: Haines, Günther & Akenine-Möller, *Precision Improvements for Ray/Sphere Intersection*,
///   Ray Tracing Gems (2019), ch. 7.
#[inline(always)]
pub fn robust<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Pair<R> {
    let a = dot(d, d);
    let b = -dot(f, d);
    let l = along(f, b / a, d);
    let discriminant = r * r - dot(l, l);
    if !(discriminant >= R::ZERO) {
        return None;
    }
    let q = b + (a * discriminant).sqrt().with_sign_of(b);
    let (near_zero, other) = ((dot(f, f) - r * r) / q, q / a);
    if q == R::ZERO {
        return Some((R::ZERO, R::ZERO)); // tangent with the origin at the point of contact
    }
    Some(if near_zero < other { (near_zero, other) } else { (other, near_zero) })
}

/// The first root in front of the origin.
#[inline(always)]
pub fn in_front<R: Real>(roots: Pair<R>) -> Option<R> {
    let (t0, t1) = roots?;
    if t0 > R::ZERO { Some(t0) } else { (t1 > R::ZERO).then_some(t1) }
}

/// [`algebraic`] with an early exit: the second root is formed only if the first lies behind the origin.
///
/// - Source: [C §1.6.1, steps 3 and 4].
pub fn algebraic_first<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Option<R> {
    let two = R::from_f64(2.0);
    let b = two * dot(f, d);
    let c = dot(f, f) - r * r;
    let discriminant = b * b - two * two * c;
    if !(discriminant >= R::ZERO) {
        return None;
    }
    let root = discriminant.sqrt();
    let t0 = (-b - root) / two;
    if t0 > R::ZERO {
        return Some(t0);
    }
    let t1 = (-b + root) / two;
    (t1 > R::ZERO).then_some(t1)
}

/// [`geometric`] with the distance of the line itself compared with the radius: a square root that every ray
/// pays, and that comparing `d²` with `r²` saves.
///
/// - Source: [B §6.2.1], before its own improvement.
pub fn geometric_by_length<R: Real>(f: Triple<R>, d: Triple<R>, r: R) -> Pair<R> {
    let to_closest = -dot(f, d);
    let d2 = dot(f, f) - to_closest * to_closest;
    // Rounding may leave a square below zero: the line goes through the centre.
    let distance = if d2 > R::ZERO { d2.sqrt() } else { R::ZERO };
    if !(distance <= r) {
        return None;
    }
    // The root may round down to the radius from a square that is beyond it.
    let half_chord2 = r * r - d2;
    let half_chord = if half_chord2 > R::ZERO { half_chord2.sqrt() } else { R::ZERO };
    Some((to_closest - half_chord, to_closest + half_chord))
}
