//! The quick answer to the most frequent questions: does a ray hit, and where first?
//!
//! In `c₄ s⁴ + c₂ s² + c₁ s + c₀` the stationary points are the roots of the depressed cubic
//! `s³ + p s + q`, `p = c₂/2c₄`, `q = c₁/4c₄`, which has formulas. From a start whose sign is certain, the
//! signs at the stationary points ahead, held against their rounding errors, tell a miss from a hit;
//! whatever they cannot tell is left to the certified search.
//!
//! A stationary point is known to some error only, and may be taken for ahead of the start when it lies behind. That
//! does no harm: within that error its sign is certain, so the start next to it has the same, and no root
//! is seen between them.

use super::line::{DOUBT, Line};
use crate::num::U;
use crate::num::polynomial::{Bracket, Polynomial, Sign};
use arrayvec::ArrayVec;

/// Where the search begins, and the certain sign of the quartic there.
#[derive(Clone, Copy)]
pub(super) struct Start {
    pub s: f64,
    pub sign: Sign,
}

/// What the signs say about the first root.
pub(super) enum First {
    Miss,
    /// Where the first root is alone, and a minimum next to it.
    Between(Bracket<f64>, f64),
    Unsure,
}

/// The quartic on the stretch up to `half`, where it is positive.
pub(super) struct Quartic<'a> {
    c: [f64; 4],
    half: f64,
    line: &'a Line<'a>,
}

impl<'a> Quartic<'a> {
    pub fn new(line: &'a Line, poly: &Polynomial<f64>, half: f64) -> Self {
        Quartic { c: [poly.c[0], poly.c[1], poly.c[2], poly.c[4]], half, line }
    }

    /// The first change of sign beyond the start.
    pub fn first(&self, start: Start) -> First {
        let Some(marks) = self.stationary_points() else { return First::Unsure };
        let (mut lo, mut minimum) = (start.s, marks[0]);
        let sign = start.sign;
        for (k, &mark) in marks.iter().chain([&self.half]).enumerate() {
            // Minima and maxima alternate, and the end is a maximum of its own.
            let is_minimum = k % 2 == 0 && k < marks.len();
            if is_minimum {
                minimum = mark;
            }
            if !(mark > start.s) {
                continue;
            }
            // Only a minimum can end a positive stretch, only a maximum a negative one.
            if is_minimum == (sign > 0) {
                let here = if k == marks.len() { 1 } else { self.sign(mark) };
                if here == 0 {
                    return First::Unsure;
                }
                if here != sign {
                    return First::Between(Bracket { lo, hi: mark, before: sign, after: here }, minimum);
                }
            }
            lo = mark;
        }
        if sign > 0 { First::Miss } else { First::Unsure }
    }

    /// Minimum, maximum, minimum; or the one minimum; or nothing where rounding hides which.
    fn stationary_points(&self) -> Option<ArrayVec<f64, 3>> {
        let (p3, q2) = (-self.c[2] / (6.0 * self.c[3]), self.c[1] / (8.0 * self.c[3]));
        let cube = p3 * p3 * p3;
        if p3 > 0.0 && q2 * q2 < 0.998 * cube {
            // s = r t with t³ − 3t + 2k = 0; |k| < 0.999 keeps the minima apart from the maximum.
            let r = p3.sqrt();
            let k = q2 / (p3 * r);
            let (left, right) = (r * leftmost(k), -r * leftmost(-k));
            Some(ArrayVec::from([left, -(left + right), right]))
        } else if q2 * q2 > 1.002 * cube {
            let s = -cube_root(q2.abs() + (q2 * q2 - cube).sqrt()).copysign(q2);
            Some(ArrayVec::from_iter([if s == 0.0 { 0.0 } else { s + p3 / s }]))
        } else {
            None
        }
    }

    fn value(&self, s: f64) -> f64 {
        ((self.c[3] * s * s + self.c[2]) * s + self.c[1]) * s + self.c[0]
    }

    fn slope(&self, s: f64) -> f64 {
        (4.0 * self.c[3] * s * s + 2.0 * self.c[2]) * s + self.c[1]
    }

    pub fn sign(&self, s: f64) -> Sign {
        let f = self.value(s);
        let size = self.line.size(s);
        if f.abs() > DOUBT * U * 2.0 * size * size { if f > 0.0 { 1 } else { -1 } } else { 0 }
    }

    /// The root in a bracket, left or right of the minimum next to it; nothing if Newton's steps leave the bracket
    /// by more than `slack`.
    ///
    /// Starts where the parabola at the minimum is zero; on the convex side that lies beyond
    /// the root, and Newton's steps come back from there.
    pub fn root(&self, bracket: &Bracket<f64>, minimum: f64, slack: f64) -> Option<f64> {
        let (lo, hi) = (bracket.lo - slack, bracket.hi + slack);
        let curvature = 12.0 * self.c[3] * minimum * minimum + 2.0 * self.c[2];
        let reach = (-2.0 * self.value(minimum) / curvature).sqrt();
        let guess = if bracket.before > 0 { minimum - reach } else { minimum + reach };
        let mut s = if guess > lo && guess < hi { guess } else { 0.5 * (lo + hi) };
        for _ in 0..16 {
            let step = self.value(s) / self.slope(s);
            s -= step;
            if !(s >= lo && s <= hi) {
                return None;
            }
            // What this step leaves is of the order of its square.
            if step.abs() <= 1e-9 * self.half {
                return Some(s);
            }
        }
        None
    }
}

/// The cube root of a positive number, to 10⁻¹⁰: at a minimum the value does not feel more than `√u`.
///
/// A third of the exponent, from the bits, is right to 6 %; each of Halley's steps leaves about the cube of that.
fn cube_root(x: f64) -> f64 {
    if x < f64::MIN_POSITIVE {
        return x.cbrt(); // without a leading one the bits say less
    }
    /// Two thirds of the exponent's bias, less what makes the errors on both sides equal.
    const BIAS: u64 = 715_094_163 << 32;
    let mut r = f64::from_bits(x.to_bits() / 3 + BIAS);
    for _ in 0..2 {
        let cube = r * r * r;
        r *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    r
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
