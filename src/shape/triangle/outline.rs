//! Outlines as a ray sees them: which way they wind about it.

use super::textbook::largest_axis;
use super::watertight::PreparedRay;
use crate::num::U;
use crate::num::expansion::Expansion;
use crate::ray::Ray;
use glam::DVec3;

/// A ray sheared onto the axis along which it is longest: corners are seen in two coordinates.
///
/// - Source: Woop, Benthin & Wald, *Watertight ray/triangle intersection*, JCGT 2(1) (2013).
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRay {
    ray: PreparedRay,
    /// Axes permuted so that the direction is longest along the last.
    axes: [usize; 3],
    shear: [f64; 2],
}

/// A corner as the ray sees it: sideways offsets.
#[derive(Clone, Copy, Debug)]
struct Seen {
    x: f64,
    y: f64,
    /// Sum of what was added up for `x` and `y`: their rounding errors are at most `4 u size` each.
    size: f64,
}

impl ShearedRay {
    /// Prepares a ray whose direction is not zero.
    pub fn new(ray: &Ray) -> Self {
        let ray = PreparedRay::new(ray);
        let d = ray.direction;
        let last = largest_axis(d);
        let (mut i, mut j) = ((last + 1) % 3, (last + 2) % 3);
        if d[last] < 0.0 {
            // Mirror two axes, so that orientations stay as they are.
            (i, j) = (j, i);
        }
        ShearedRay { ray, axes: [i, j, last], shear: [d[i] / d[last], d[j] / d[last]] }
    }

    /// Roundings: the difference `v − o` (1), the shear (1), their product (1), the last subtraction (1).
    fn see(&self, v: DVec3) -> Seen {
        let from = v - self.ray.origin;
        let [a, b, depth] = self.axes.map(|axis| from[axis]);
        let size = a.abs().max(b.abs()) + depth.abs();
        Seen { x: a - self.shear[0] * depth, y: b - self.shear[1] * depth, size }
    }

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
        let part = |axis: usize| Expansion::difference(v[axis], self.ray.origin[axis]);
        let number = |x: f64| Expansion::difference(x, 0.0);
        let minor = Expansion::determinant(
            &part(j),
            &number(self.ray.direction[last]),
            &part(last),
            &number(self.ray.direction[j]),
        );
        // Offset times the last coordinate of the direction, which may be negative.
        let sign = if self.ray.direction[last] < 0.0 { -minor.sign() } else { minor.sign() };
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
        self.ray.exact_side(a, b) > 0
    }
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
