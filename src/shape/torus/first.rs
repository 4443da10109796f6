//! The quick answer to the most frequent question: does a ray from outside hit, and where first?
//!
//! In `c₄ s⁴ + c₂ s² + c₁ s + c₀` the stationary points are the roots of the depressed cubic
//! `s³ + p s + q`, `p = c₂/2c₄`, `q = c₁/4c₄`, which has formulas. The signs at the minima, held against their
//! rounding errors, tell a miss from a hit; whatever they cannot tell is left to the certified search.

use super::line::{DOUBT, Line};
use crate::num::U;
use crate::num::polynomial::{Bracket, Polynomial};

/// What the signs at the minima say about the first root.
pub(super) enum First {
    Miss,
    /// The first root, found in `f64`, and where it is alone.
    Root(f64, Bracket<f64>),
    Unsure,
}

/// The first root beyond `−half`, where the quartic is positive.
pub(super) fn first_root(line: &Line, poly: &Polynomial<f64>, half: f64) -> First {
    let q = Quartic { c: [poly.c[0], poly.c[1], poly.c[2], poly.c[4]], half, line };
    let (p3, q2) = (-q.c[2] / (6.0 * q.c[3]), q.c[1] / (8.0 * q.c[3]));
    let cube = p3 * p3 * p3;
    if p3 > 0.0 && q2 * q2 < 0.998 * cube {
        // Two minima, s = r t with t³ − 3t + 2k = 0; |k| < 0.999 keeps them apart from the maximum.
        let r = p3.sqrt();
        let k = q2 / (p3 * r);
        let left = r * leftmost(k);
        match q.sign(left) {
            -1 => q.descend(-half, left),
            0 => First::Unsure,
            _ => {
                let right = -r * leftmost(-k);
                match q.sign(right) {
                    -1 => q.descend(-(left + right), right),
                    0 => First::Unsure,
                    _ => First::Miss,
                }
            }
        }
    } else if q2 * q2 > 1.002 * cube {
        // One minimum.
        let s = -(q2.abs() + (q2 * q2 - cube).sqrt()).cbrt().copysign(q2);
        let minimum = if s == 0.0 { 0.0 } else { s + p3 / s };
        match q.sign(minimum) {
            -1 => q.descend(-half, minimum),
            0 => First::Unsure,
            _ => First::Miss,
        }
    } else {
        First::Unsure
    }
}

/// The least root of `t³ − 3t + 2k` for `|k| ≤ 1`, to about `√u`: at a minimum the value does not feel more.
///
/// The start is the tangent at `k = 1` to the root as a function of `k`, which is convex: it lies left
/// of the root, where the cubic is concave, and Newton's steps approach from that side.
fn leftmost(k: f64) -> f64 {
    let mut t = -2.0 + 2.0 / 9.0 * (1.0 - k);
    for _ in 0..16 {
        let step = ((t * t - 3.0) * t + 2.0 * k) / (3.0 * (t * t - 1.0));
        t -= step;
        if step.abs() < 1e-5 {
            break;
        }
    }
    t
}

struct Quartic<'a> {
    c: [f64; 4],
    half: f64,
    line: &'a Line<'a>,
}

impl Quartic<'_> {
    fn value(&self, s: f64) -> f64 {
        ((self.c[3] * s * s + self.c[2]) * s + self.c[1]) * s + self.c[0]
    }

    fn slope(&self, s: f64) -> f64 {
        (4.0 * self.c[3] * s * s + 2.0 * self.c[2]) * s + self.c[1]
    }

    fn sign(&self, s: f64) -> i8 {
        let f = self.value(s);
        let size = self.line.size(s);
        if f.abs() > DOUBT * U * 2.0 * size * size { if f > 0.0 { 1 } else { -1 } } else { 0 }
    }

    /// The root between `lo` (positive) and a minimum (negative); the quartic falls in between.
    ///
    /// Starts where the parabola at the minimum is zero; on the convex side that lies beyond
    /// the root, and Newton's steps come back from there.
    fn descend(&self, lo: f64, minimum: f64) -> First {
        let curvature = 12.0 * self.c[3] * minimum * minimum + 2.0 * self.c[2];
        let guess = minimum - (-2.0 * self.value(minimum) / curvature).sqrt();
        let mut s = if guess > lo { guess } else { 0.5 * (lo + minimum) };
        for _ in 0..16 {
            let step = self.value(s) / self.slope(s);
            s -= step;
            if !(s >= lo && s <= minimum) {
                return First::Unsure;
            }
            // What this step leaves is of the order of its square.
            if step.abs() <= 1e-9 * self.half {
                return First::Root(s, Bracket { lo, hi: minimum, before: 1, after: -1 });
            }
        }
        First::Unsure
    }
}
