//! Triangles without gaps: a ray at a shared edge or corner never slips between neighbours.
//!
//! The ray is sheared onto the axis along which it is longest, and each corner is seen from it in two
//! coordinates. On which side of an edge the ray passes is the sign of
//!
//! ```text
//! d · ((a − o) × (b − o))                                                   (1)
//! ```
//!
//! evaluated with a bound on its rounding error; where the bound does not decide, in 106 bits, and last
//! exactly. Two triangles that share an edge so get opposite signs, or both zero, and a zero
//! belongs to both: the answer is that of exact arithmetic on the given numbers.
//!
//! - Source: Woop, Benthin & Wald, *Watertight ray/triangle intersection*, JCGT 2(1) (2013) for the shear;
//!   Shewchuk (1997) for the exact sign.

use super::textbook::largest_axis;
use super::{Facing, Meeting};
use crate::num::U;
use crate::num::certified::{Scalar, Vector, power_of_two_below};
use crate::num::double_double::DoubleDouble;
use crate::num::expansion::Expansion;
use crate::ray::Ray;
use glam::DVec3;

/// A ray prepared for many triangles: axes permuted so that the direction is longest along the last.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    origin: DVec3,
    /// The direction times a power of two, so that its largest coordinate is in [1, 2).
    direction: DVec3,
    /// What the direction was multiplied by; `t` is too.
    stretch: f64,
    axes: [usize; 3],
    shear: [f64; 2],
    per_depth: f64,
}

/// A corner as the ray sees it: sideways offsets, and depth along the last axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    x: f64,
    y: f64,
    depth: f64,
    /// Sum of what was added up for `x` and `y`: their rounding errors are at most `4 u size` each.
    size: f64,
}

impl ShearedRay {
    /// Prepares a ray whose direction is not zero.
    pub fn new(ray: &Ray) -> Self {
        let last = largest_axis(ray.direction);
        let stretch = 1.0 / power_of_two_below(ray.direction[last].abs());
        let d = ray.direction * stretch;
        let (mut i, mut j) = ((last + 1) % 3, (last + 2) % 3);
        if d[last] < 0.0 {
            // Mirror two axes, so that orientations stay as they are.
            (i, j) = (j, i);
        }
        let shear = [d[i] / d[last], d[j] / d[last]];
        let per_depth = 1.0 / d[last];
        ShearedRay { origin: ray.origin, direction: d, stretch, axes: [i, j, last], shear, per_depth }
    }

    /// Roundings: the difference `v − o` (1), the shear (1), their product (1), the last subtraction (1).
    #[inline]
    pub(crate) fn see(&self, v: DVec3) -> Seen {
        let from = v - self.origin;
        // A fourth place and a mask: the compiler sees that no index is out of range.
        let from = [from.x, from.y, from.z, 0.0];
        let [a, b, depth] = self.axes.map(|axis| from[axis & 3]);
        let size = a.abs().max(b.abs()) + depth.abs();
        Seen { x: a - self.shear[0] * depth, y: b - self.shear[1] * depth, depth, size }
    }

    /// Where the line of the ray meets a triangle, at any sign of `t`; edges and corners belong to it.
    ///
    /// - Domain: a triangle in one plane with the ray, or without area, is missed.
    /// - Accuracy: hit or miss as exact arithmetic decides; `t` within `2¹⁰ u |t|`, usually a few `u`.
    #[inline]
    pub fn meet(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let [a, b, c] = corners.map(|v| self.see(v));
        let size = a.size.max(b.size).max(c.size);
        // Products of three lengths must neither vanish nor overflow.
        if !(2e-90..2e90).contains(&size) {
            return self.meet_scaled(corners, size);
        }
        let edges = [c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x];
        let bound = edge_bound(size, widest(a).max(widest(b)).max(widest(c)));
        let (mut above, mut below, mut unsure) = (false, false, false);
        for e in edges {
            above |= e > bound;
            below |= e < -bound;
            unsure |= e.abs() <= bound;
        }
        if above && below {
            return None;
        }
        if unsure {
            return self.meet_carefully(corners);
        }
        let det = edges[0] + edges[1] + edges[2];
        let inverse = 1.0 / det;
        let weights = edges.map(|e| e * inverse);
        let depths = [a.depth, b.depth, c.depth];
        let depth = weights[0] * depths[0] + weights[1] * depths[1] + weights[2] * depths[2];
        // An error in a weight counts by how far its corner's depth is from the answer.
        let spread: f64 = depths.iter().map(|z| (z - depth).abs()).sum();
        if spread * bound > 1024.0 * U * depth.abs() * det.abs() {
            return self.meet_carefully(corners);
        }
        let facing = if det > 0.0 { Facing::Front } else { Facing::Back };
        Some(Meeting { t: depth * self.per_depth * self.stretch, b: weights, facing })
    }

    /// The plane of the triangle where the ray crosses it, inside the triangle or not.
    ///
    /// - Domain: `None` if the plane is parallel to the ray, or there is no area.
    pub fn meet_plane(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let (ray, corners, unit) = self.rescaled(corners)?;
        self.restored(ray.solve(corners)?.0, unit)
    }

    #[cold]
    fn meet_scaled(&self, corners: [DVec3; 3], size: f64) -> Option<Meeting> {
        if size == 0.0 {
            return None;
        }
        let (ray, corners, unit) = self.rescaled(corners)?;
        self.restored(ray.meet_carefully(corners)?, unit)
    }

    /// Lengths counted in a power of two, so that the corners are about 1 away from the origin.
    fn rescaled(&self, corners: [DVec3; 3]) -> Option<(Self, [DVec3; 3], f64)> {
        let far =
            corners.iter().map(|v| (*v / 2.0 - self.origin / 2.0).abs().max_element()).fold(0.0, f64::max);
        let unit = power_of_two_below(far);
        let scaled = ShearedRay { origin: self.origin / unit, stretch: 1.0, ..*self };
        (far > 0.0).then(|| (scaled, corners.map(|v| v / unit), unit))
    }

    fn restored(&self, scaled: Meeting, unit: f64) -> Option<Meeting> {
        let t = scaled.t * unit * self.stretch;
        t.is_finite().then_some(Meeting { t, ..scaled })
    }

    /// As [`ShearedRay::meet`], with every sign exact and the rest in 106 bits.
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
    fn exact_side(&self, a: DVec3, b: DVec3) -> i8 {
        exact_triple(self.direction, self.origin, a, self.origin, b)
    }

    /// Is the direction exactly parallel to the triangle's plane?
    #[cold]
    fn runs_along(&self, [v0, v1, v2]: [DVec3; 3]) -> bool {
        exact_triple(self.direction, v0, v1, v0, v2) == 0
    }
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

/// The larger sideways offset of a corner.
#[inline]
fn widest(s: Seen) -> f64 {
    s.x.abs().max(s.y.abs())
}

/// Bound on the rounding error of `c.x b.y − c.y b.x`.
///
/// Offsets err by `4 u size`: four such errors times an offset up to `width`, two products and a difference
/// of size `2 width²` at most (`width ≤ size`), and the square of the errors.
#[inline]
fn edge_bound(size: f64, width: f64) -> f64 {
    (16.0 + 4.0 + 1.0) * U * size * width + 33.0 * U * U * size * size
}

impl ShearedRay {
    /// Does the edge from `a` to `b` cross the half line to the right of the ray, and on the way up (+1) or down (−1)?
    ///
    /// The sum over a closed outline is its winding number about the ray. A corner level with the ray
    /// counts as below it, so that each crossing belongs to exactly one of two edges that meet there.
    pub(crate) fn winding_step(&self, a: DVec3, b: DVec3) -> i32 {
        let (below_a, below_b) = (self.is_below(a), self.is_below(b));
        if below_a == below_b {
            return 0;
        }
        // The ray is left of an upward edge if it sees a, b turn counter-clockwise.
        let (low, high, way) = if below_a { (a, b, 1) } else { (b, a, -1) };
        if self.turns_left(low, high) { way } else { 0 }
    }

    /// Is the second sideways offset at most 0?
    fn is_below(&self, v: DVec3) -> bool {
        let seen = self.see(v);
        if seen.y.abs() > 4.0 * U * seen.size {
            return seen.y < 0.0;
        }
        let [_, j, last] = self.axes;
        let part = |axis: usize| Expansion::difference(v[axis], self.origin[axis]);
        let number = |x: f64| Expansion::difference(x, 0.0);
        let minor = Expansion::determinant(
            &part(j),
            &number(self.direction[last]),
            &part(last),
            &number(self.direction[j]),
        );
        // Offset times the last coordinate of the direction, which may be negative.
        let sign = if self.direction[last] < 0.0 { -minor.sign() } else { minor.sign() };
        sign <= 0
    }

    /// Is the turn from `a` to `b` about the ray counter-clockwise in the sheared offsets?
    fn turns_left(&self, a: DVec3, b: DVec3) -> bool {
        let (p, q) = (self.see(a), self.see(b));
        let turn = p.x * q.y - p.y * q.x;
        let bound = edge_bound(p.size.max(q.size), widest(p).max(widest(q)));
        if turn.abs() > bound {
            return turn > 0.0;
        }
        // (1) is the last coordinate of the direction times the turn, mirrored with the axes: see `new`.
        self.exact_side(a, b) > 0
    }
}
