//! Triangles without gaps: a ray at a shared edge or corner never slips between neighbours.
//!
//! On which side of an edge the ray passes is the sign of
//!
//! ```text
//! d · ((a − o) × (b − o))                                                   (1)
//! ```
//!
//! Cramer's rule [`moller_trumbore`](super::moller_trumbore) computes these three numbers on its way; here they come
//! with a bound on their rounding errors. Where the bound does not decide, 106 bits do, and last exact
//! arithmetic. Two triangles that share an edge so get opposite signs, or both zero, and a zero belongs to both:
//! the answer is that of exact arithmetic on the given numbers.
//!
//! - Source: Möller & Trumbore (1997) for the order of the products; Shewchuk, *Adaptive precision floating-point
//!   arithmetic* (1997) for the filter and the exact sign; Woop, Benthin & Wald, *Watertight ray/triangle
//!   intersection*, JCGT 2(1) (2013) for the question.

use super::{Facing, Meeting};
use crate::num::U;
use crate::num::certified::{Scalar, Vector, power_of_two_below};
use crate::num::double_double::DoubleDouble;
use crate::num::expansion::Expansion;
use crate::ray::Ray;
use glam::DVec3;

/// A ray prepared for many triangles.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay {
    pub(super) origin: DVec3,
    /// The direction times a power of two, so that its largest coordinate is in [1, 2).
    pub(super) direction: DVec3,
    /// What the direction was multiplied by; `t` is too.
    stretch: f64,
    /// `d / d·d`: its product with a way along the ray is how far that is.
    along: DVec3,
    /// Bound on the error of a triple product of `d` with two vectors, per product of their lengths `|x|+|y|+|z|`.
    noise: f64,
}

/// Roundings that reach (1): each edge is a difference (1 + 1), a product and a difference make the cross product
/// (2), a product and two sums the scalar product (3), so `γ₇ Σ|dᵢ||aⱼ||bₖ| ≤ γ₇ max|dᵢ| Σ|aⱼ| Σ|bₖ|`. The third
/// number is a difference of the others, with 2 more; 1 for the rounding of the bound itself.
const ROUNDINGS: f64 = 10.0;

/// Between these neither a product of two lengths and `d` vanishes or overflows, nor a part of it that counts:
/// if no length exceeds 10⁵⁰ and the product of three is above 10⁻¹⁸⁰, two of them make at least 10⁻²³⁰, and
/// what underflow takes, 3·10⁻³²⁴ · 10⁵⁰, is far below the bound `10 u · 10⁻²³⁰`.
const FARTHEST: f64 = 1e50;
const SMALLEST: f64 = 1e-180;

impl PreparedRay {
    /// Prepares a ray whose direction is not zero.
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let largest = ray.direction.abs().max_element();
        let stretch = 1.0 / power_of_two_below(largest);
        let d = ray.direction * stretch;
        let along = d * (1.0 / d.dot(d));
        PreparedRay {
            origin: ray.origin,
            direction: d,
            stretch,
            along,
            noise: ROUNDINGS * U * largest * stretch,
        }
    }

    /// Where the line of the ray meets a triangle, at any sign of `t`; edges and corners belong to it.
    ///
    /// - Domain: a triangle in one plane with the ray, or without area, is missed.
    /// - Accuracy: hit or miss as exact arithmetic decides; `t` within `2¹⁰ u |t|`, usually a few `u`.
    #[inline]
    pub fn meet(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let [v0, v1, v2] = corners;
        let (e1, e2, from) = (v1 - v0, v2 - v0, self.origin - v0);
        let (size1, size2, away) = (sum(e1), sum(e2), sum(from));
        let (noise1, noise2) = (self.noise * size1, self.noise * size2);
        // A NaN is in neither range.
        let is_plain = size1 + size2 + away < FARTHEST && size1 * size2 * away > SMALLEST;
        if !is_plain {
            return self.meet_scaled(corners);
        }
        let s = self.direction.cross(e2);
        let det = e1.dot(s);
        // Turned so that the triangle faces the ray: in it, all three are positive.
        let (size, side1) = (det.abs(), from.dot(s) * 1f64.copysign(det));
        let (unsure, unsure1) = (noise2 * size1, noise2 * away);
        if size > unsure && (side1 < -unsure1 || side1 - size > unsure1 + unsure) {
            return None;
        }
        let side2 = self.direction.dot(from.cross(e1)) * 1f64.copysign(det);
        let unsure2 = noise1 * away;
        let (side0, unsure0) = (size - side1 - side2, unsure + unsure1 + unsure2);
        if size > unsure && (side2 < -unsure2 || side0 < -unsure0) {
            return None;
        }
        let is_inside = side0 > unsure0 && side1 > unsure1 && side2 > unsure2;
        let inverse = 1.0 / size;
        let [b1, b2] = [side1, side2].map(|side| side * inverse);
        let (along1, along2) = (e1.dot(self.along), e2.dot(self.along));
        let t = b1 * along1 + b2 * along2 - from.dot(self.along);
        // An error in a weight counts by how far its edge runs along the ray; sums of up to 8 roundings.
        let leaning = along1.abs() + along2.abs();
        let error = unsure0 * leaning + 8.0 * U * size * (leaning + away * self.along.abs().max_element());
        if !(is_inside && error <= 1000.0 * U * size * t.abs()) {
            return self.meet_rarely(corners, [side0, side1, side2], [unsure0, unsure1, unsure2]);
        }
        let facing = if det > 0.0 { Facing::Front } else { Facing::Back };
        Some(Meeting { t: t * self.stretch, b: [side0 * inverse, b1, b2], facing })
    }

    /// The ray is almost in the triangle's plane, or passes an edge closely, or meets the triangle close to its origin.
    #[cold]
    fn meet_rarely(&self, corners: [DVec3; 3], sides: [f64; 3], unsure: [f64; 3]) -> Option<Meeting> {
        let is_above = (0..3).any(|i| sides[i] > unsure[i]);
        let is_below = (0..3).any(|i| sides[i] < -unsure[i]);
        if is_above && is_below { None } else { self.meet_carefully(corners) }
    }

    /// The plane of the triangle where the ray crosses it, inside the triangle or not.
    ///
    /// - Domain: `None` if the plane is parallel to the ray, or there is no area.
    pub fn meet_plane(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let (ray, corners, unit) = self.rescaled(corners)?;
        self.restored(ray.solve(corners)?.0, unit)
    }

    #[cold]
    fn meet_scaled(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let (ray, corners, unit) = self.rescaled(corners)?;
        self.restored(ray.meet_carefully(corners)?, unit)
    }

    /// Lengths counted in a power of two, so that the corners are about 1 away from the origin.
    fn rescaled(&self, corners: [DVec3; 3]) -> Option<(Self, [DVec3; 3], f64)> {
        let far =
            corners.iter().map(|v| (*v / 2.0 - self.origin / 2.0).abs().max_element()).fold(0.0, f64::max);
        let unit = power_of_two_below(far);
        let scaled = PreparedRay { origin: self.origin / unit, stretch: 1.0, ..*self };
        (far > 0.0).then(|| (scaled, corners.map(|v| v / unit), unit))
    }

    fn restored(&self, scaled: Meeting, unit: f64) -> Option<Meeting> {
        let t = scaled.t * unit * self.stretch;
        t.is_finite().then_some(Meeting { t, ..scaled })
    }

    /// As [`PreparedRay::meet`], with every sign exact and the rest in 106 bits.
    #[cold]
    fn meet_carefully(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let (meeting, edges) = self.solve(corners)?;
        let [v0, v1, v2] = corners;
        let signs = [self.side(edges[0], v1, v2), self.side(edges[1], v2, v0), self.side(edges[2], v0, v1)];
        let inside = !(signs.contains(&1) && signs.contains(&-1));
        inside.then_some(meeting)
    }

    /// The plane's meeting and the three edge functions (1), in 106 bits.
    ///
    /// Both are written with differences of corners, which stay small however far the ray's origin is:
    /// `(a − o) × (b − o) = (a − o) × (b − a)`.
    fn solve(&self, corners: [DVec3; 3]) -> Option<(Meeting, [DoubleDouble; 3])> {
        let [v0, v1, v2] = corners;
        let d = Vector::of(self.direction);
        let across = |a, b| {
            let arm = Vector::<DoubleDouble>::difference(a, self.origin);
            d.dot(arm.cross(Vector::difference(b, a)))
        };
        let edges = [across(v1, v2), across(v2, v0), across(v0, v1)];
        let normal = Vector::<DoubleDouble>::difference(v1, v0).cross(Vector::difference(v2, v0));
        let along = d.dot(normal);
        let reach = (v1 - v0).abs().max_element() * (v2 - v0).abs().max_element();
        let parallel = along.value().abs() <= NOISE * reach && self.runs_along(corners);
        let t = (normal.dot(Vector::difference(v0, self.origin)) / along).value() * self.stretch;
        if parallel || along.sign() == Ok(0) || !t.is_finite() {
            return None;
        }
        let facing = if along.value() < 0.0 { Facing::Front } else { Facing::Back };
        Some((Meeting { t, b: edges.map(|e| (e / along).value()), facing }, edges))
    }

    /// The sign of (1), given its value in 106 bits.
    fn side(&self, value: DoubleDouble, a: DVec3, b: DVec3) -> i8 {
        let reach = (a - self.origin).abs().max_element() * (b - a).abs().max_element();
        if value.value().abs() > NOISE * reach {
            return if value.value() > 0.0 { 1 } else { -1 };
        }
        self.exact_side(a, b)
    }

    /// The sign of (1), exactly.
    #[cold]
    pub(crate) fn exact_side(&self, a: DVec3, b: DVec3) -> i8 {
        exact_triple(self.direction, self.origin, a, self.origin, b)
    }

    /// Is the direction exactly parallel to the triangle's plane?
    #[cold]
    fn runs_along(&self, [v0, v1, v2]: [DVec3; 3]) -> bool {
        exact_triple(self.direction, v0, v1, v0, v2) == 0
    }
}

/// `|x| + |y| + |z|`
#[inline]
fn sum(v: DVec3) -> f64 {
    v.abs().element_sum()
}

/// 106 bits: (1) sums 18 products of numbers up to `2 reach`, each step rounded to `2⁻¹⁰⁴`: below `2⁻⁹⁵ reach`.
const NOISE: f64 = 2.5e-29;

/// The sign of `d · ((a − o) × (b − q))`, exactly.
fn exact_triple(d: DVec3, o: DVec3, a: DVec3, q: DVec3, b: DVec3) -> i8 {
    let [x, y, z] = [0, 1, 2].map(|i| (Expansion::difference(a[i], o[i]), Expansion::difference(b[i], q[i])));
    let minors = [(&y, &z), (&z, &x), (&x, &y)].map(|(p, q)| Expansion::determinant(&p.0, &q.1, &q.0, &p.1));
    let mut sum = Expansion::default();
    for (minor, d) in minors.iter().zip(d.to_array()) {
        sum.add_product(minor, &Expansion::difference(d, 0.0));
    }
    sum.sign()
}
