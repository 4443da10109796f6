//! Real roots of polynomials of degree four at most, isolated between their stationary points.
//!
//! Between neighbouring stationary points a polynomial is monotone, so the signs there tell how
//! many roots there are and where; the stationary points are the roots of the derivative, found the same
//! way (Yuksel, *High-Performance Polynomial Root Finding for Graphics*, HPG 2022). All
//! depends on the signs. [`isolate`] compares each value with a bound on its own rounding error and
//! says whether every sign is certain; [`real_roots`] starts in `f64` and repeats in
//! double-double the few polynomials that `f64` cannot decide. No tolerance is absolute.

use super::double_double::DoubleDouble;
use super::real::Real;
use arrayvec::ArrayVec;

/// A polynomial `Σ c[k] xᵏ`, with the size of its terms `Σ w[k] |x|ᵏ` that rounding errors go by.
#[derive(Clone, Copy, Debug)]
pub struct Polynomial<R> {
    pub degree: usize,
    pub c: [R; 5],
    pub w: [f64; 5],
}

/// Sign of a polynomial between roots, or at a point: −1, 0 (not to be told from zero), 1.
pub type Sign = i8;

/// Exactly one root lies in `[lo, hi]`; where both are equal, the root is there.
#[derive(Clone, Copy, Debug)]
pub struct Bracket<R> {
    pub lo: R,
    pub hi: R,
    /// Sign of the polynomial before and after the root; equal for a touch.
    pub before: Sign,
    pub after: Sign,
}

/// All the roots in an interval, ascending.
#[derive(Clone, Debug)]
pub struct Isolated<R> {
    pub brackets: ArrayVec<Bracket<R>, 4>,
    /// Was every sign larger than its rounding error?
    pub certain: bool,
}

/// What separates a sign from rounding, in units of `R::ROUNDOFF · Σ w|x|ᵏ`.
///
/// Horner's scheme errs by `γ₈`. The sign is wanted at a stationary point `s`, and asked at its
/// computed neighbour `x`; the refinement of `x` ends with a residual slope of at most `20 Σ k w|x|ᵏ⁻¹`
/// roundoffs (8 by its own stop, 12 by the last step of `4 |x|` roundoffs), and even with `|x − s| = |x|`
/// this moves the value by no more than 80. Together 88.
pub const DOUBT: f64 = 96.0;

impl<R: Real> Polynomial<R> {
    /// With exactly known coefficients, constant first.
    pub fn new(c: [R; 5]) -> Self {
        let degree = (0..5).rev().find(|&k| c[k].to_f64() != 0.0).unwrap_or(0);
        Polynomial { degree, c, w: c.map(|x| x.to_f64().abs()) }
    }

    pub(crate) fn derivative(&self) -> Self {
        let (mut c, mut w) = ([R::ZERO; 5], [0.0; 5]);
        for k in 1..=self.degree {
            c[k - 1] = self.c[k] * R::from_f64(k as f64);
            w[k - 1] = self.w[k] * k as f64;
        }
        Polynomial { degree: self.degree.saturating_sub(1), c, w }
    }

    /// Value, slope, and size of the terms.
    #[inline]
    pub fn eval(&self, x: R) -> (R, R, f64) {
        let size = x.to_f64().abs();
        let (mut f, mut df, mut sum) = (self.c[self.degree], R::ZERO, self.w[self.degree]);
        for k in (0..self.degree).rev() {
            df = df * x + f;
            f = f * x + self.c[k];
            sum = sum * size + self.w[k];
        }
        (f, df, sum)
    }

    fn sign(&self, x: R, doubt: f64) -> Sign {
        let (f, _, sum) = self.eval(x);
        let f = f.to_f64();
        if f.abs() > doubt * R::ROUNDOFF * sum { if f > 0.0 { 1 } else { -1 } } else { 0 }
    }
}

/// The roots of `p` in `[lo, hi]`; a sign within `doubt` roundoffs counts as zero.
pub fn isolate<R: Real>(p: &Polynomial<R>, lo: R, hi: R, doubt: f64) -> Isolated<R> {
    let mut marks = ArrayVec::<R, 5>::new();
    marks.push(lo);
    marks.extend(stationary_points(p, lo, hi));
    marks.push(hi);
    let mut found = Isolated { brackets: ArrayVec::new(), certain: true };
    let (mut last, mut before) = (lo, 0);
    let mut at_zero = false; // did the mark before count as zero?
    for x in marks {
        let sign = p.sign(x, doubt);
        if sign == 0 {
            found.certain = false;
            if !at_zero && !found.brackets.is_full() {
                found.brackets.push(Bracket { lo: x, hi: x, before, after: 0 });
            }
        } else {
            if at_zero {
                let touch = found.brackets.last_mut().expect("a zero mark pushed a bracket");
                touch.after = sign;
                touch.before = if touch.before == 0 { -sign } else { touch.before };
            } else if before == -sign {
                found.brackets.push(Bracket { lo: last, hi: x, before, after: sign });
            }
            (last, before) = (x, sign);
        }
        at_zero = sign == 0;
    }
    if let Some(touch) = found.brackets.last_mut().filter(|b| b.after == 0) {
        touch.after = -touch.before;
    }
    found
}

/// Where the slope of `p` vanishes in `[lo, hi]`, ascending.
fn stationary_points<R: Real>(p: &Polynomial<R>, lo: R, hi: R) -> ArrayVec<R, 3> {
    let slope = p.derivative();
    let inside = |x: &R| *x > lo && *x < hi;
    match slope.degree {
        0 => ArrayVec::new(),
        1 => [-slope.c[0] / slope.c[1]].into_iter().filter(inside).collect(),
        2 => near_roots_of_quadratic(&slope).into_iter().filter(inside).collect(),
        _ => {
            let found = isolate(&slope, lo, hi, DOUBT);
            found.brackets.iter().map(|b| refine(&slope, b)).filter(inside).take(3).collect()
        }
    }
}

/// Roots of a quadratic up to rounding; where rounding hides whether there are any, the vertex.
fn near_roots_of_quadratic<R: Real>(p: &Polynomial<R>) -> ArrayVec<R, 2> {
    let (a, b, c) = (p.c[2], p.c[1] * R::from_f64(0.5), p.c[0]);
    let discriminant = b * b - a * c;
    let size = (b * b).to_f64() + (a * c).to_f64().abs();
    let mut out = ArrayVec::new();
    if discriminant.to_f64().abs() <= 8.0 * R::ROUNDOFF * size {
        out.push(-b / a);
    } else if discriminant.to_f64() > 0.0 {
        let root = discriminant.sqrt();
        let q = if b.to_f64() > 0.0 { -b - root } else { root - b };
        let (x, y) = (q / a, c / q);
        out.extend(if x < y { [x, y] } else { [y, x] });
    }
    out
}

/// The root in a bracket, to the rounding of `R`: Newton's steps, bisection where they do not halve the
/// bracket.
pub fn refine<R: Real>(p: &Polynomial<R>, bracket: &Bracket<R>) -> R {
    let (mut lo, mut hi) = (bracket.lo, bracket.hi);
    if lo == hi {
        return lo;
    }
    let falling = bracket.before > bracket.after;
    let mut x = middle(lo, hi);
    let mut step_before = (hi - lo).to_f64();
    // Bisection of the bit pattern takes at most 64 steps to adjacent numbers per 53 bits, Newton's
    // steps at worst double that: the bound is never met.
    for _ in 0..256 {
        let (f, df, sum) = p.eval(x);
        if f.to_f64().abs() <= 8.0 * R::ROUNDOFF * sum {
            return x - f_over_slope(f, df, x, lo, hi);
        }
        if (f.to_f64() > 0.0) == falling {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - f / df;
        let step = (newton - x).to_f64().abs();
        let next =
            if newton > lo && newton < hi && 2.0 * step <= step_before { newton } else { middle(lo, hi) };
        step_before = (next - x).to_f64().abs();
        if step_before <= 4.0 * R::ROUNDOFF * next.to_f64().abs() || next == lo || next == hi {
            return next;
        }
        x = next;
    }
    x
}

/// A last Newton step, if it stays in the bracket.
fn f_over_slope<R: Real>(f: R, df: R, x: R, lo: R, hi: R) -> R {
    let step = f / df;
    let next = x - step;
    if next >= lo && next <= hi { step } else { R::ZERO }
}

/// A point between: the mean, or where the numbers differ by orders of magnitude, the middle of their
/// bit patterns.
pub(crate) fn middle<R: Real>(lo: R, hi: R) -> R {
    let (a, b) = (lo.to_f64(), hi.to_f64());
    if a < 0.0 && b > 0.0 {
        return R::ZERO;
    }
    let (small, large) = if a.abs() < b.abs() { (a.abs(), b.abs()) } else { (b.abs(), a.abs()) };
    if large > 8.0 * small {
        // A zero end stands for what is smaller than any root that matters beside it.
        let small = if small == 0.0 { large * 2f64.powi(-64) } else { small };
        let bits = small.to_bits() / 2 + large.to_bits() / 2;
        return R::from_f64(f64::from_bits(bits).copysign(if a < 0.0 || b < 0.0 { -1.0 } else { 1.0 }));
    }
    (lo + hi) * R::from_f64(0.5)
}

/// The distinct real roots of `Σ c[k] xᵏ`, constant coefficient first, ascending.
///
/// - Domain: finite coefficients; leading zeros lower the degree, the zero polynomial has no list.
/// - Accuracy: of the exact polynomial with these `f64` coefficients, each root to 2 u relative, as long as
///   its condition number stays below `2⁴⁶` (the residual is known to `2⁻⁹⁹` of its terms). A multiple root counts once; roots count as one where the
///   polynomial between them stays below `2⁻⁹⁵` of its terms. Roots beyond `f64::MAX` are not listed.
/// - NaN: NaN or infinite coefficients give no roots.
pub fn real_roots(c: [f64; 5]) -> ArrayVec<f64, 4> {
    let mut out = ArrayVec::new();
    if c.iter().any(|x| !x.is_finite()) || c[1..].iter().all(|x| *x == 0.0) {
        return out;
    }
    let zeros = c.iter().take_while(|x| **x == 0.0).count();
    let mut reduced = [0.0; 5];
    reduced[..5 - zeros].copy_from_slice(&c[zeros..]);
    if zeros > 0 {
        out.push(0.0);
    }
    for piece in Piece::all(&reduced) {
        piece.roots(&reduced, &mut out);
    }
    out.retain(|x| x.is_finite());
    out.sort_unstable_by(f64::total_cmp);
    out
}

/// The roots of some order of magnitude: with `x = 2ᵏ y`, those with `2^low ≤ |y| ≤ 16`.
///
/// The upper convex hull of the points `(k, log₂|c[k]|)`, Newton's polygon, tells the magnitudes of all
/// the roots within a small factor. Edges closer than 64 bits share a piece.
#[derive(Clone, Copy, Debug)]
struct Piece {
    shift: i32,
    top: usize,
    low: Option<i32>,
}

impl Piece {
    fn all(c: &[f64; 5]) -> ArrayVec<Piece, 4> {
        let mut out = ArrayVec::<Piece, 4>::new();
        let mut top = (0..5).rev().find(|&k| c[k] != 0.0).unwrap_or(0);
        let mut last_slope = f64::INFINITY;
        while top > 0 {
            let slope_to = |k: usize| f64::from(exponent(c[k]) - exponent(c[top])) / (top - k) as f64;
            let (next, slope) = (0..top)
                .filter(|&k| c[k] != 0.0)
                .map(|k| (k, slope_to(k)))
                .fold((0, f64::NEG_INFINITY), |best, s| if s.1 > best.1 { s } else { best });
            if last_slope - slope > 64.0 {
                if let Some(above) = out.last_mut() {
                    above.low = Some(last_slope as i32 - 16 - above.shift);
                }
                out.push(Piece { shift: slope.ceil() as i32, top, low: None });
            }
            last_slope = slope;
            top = next;
        }
        out
    }

    fn roots(&self, c: &[f64; 5], out: &mut ArrayVec<f64, 4>) {
        let level = exponent(c[self.top]) + self.top as i32 * self.shift;
        let mut scaled = [0.0; 5];
        for k in 0..5 {
            scaled[k] = times_power_of_two(c[k], k as i32 * self.shift - level);
        }
        const FAR: f64 = 16.0;
        let sides = match self.low.map(|l| times_power_of_two(1.0, l)) {
            Some(low) => [Some((-FAR, -low)), Some((low, FAR))],
            None => [Some((-FAR, FAR)), None],
        };
        for (lo, hi) in sides.into_iter().flatten() {
            for y in roots_between(scaled, lo, hi) {
                if !out.is_full() {
                    out.push(times_power_of_two(y, self.shift));
                }
            }
        }
    }
}

/// Roots in `[lo, hi]` of a polynomial with moderate exponents: in `f64` if that can decide, else in
/// double-double.
pub(super) fn roots_between(c: [f64; 5], lo: f64, hi: f64) -> ArrayVec<f64, 4> {
    let p = Polynomial::new(c);
    let found = isolate(&p, lo, hi, DOUBT);
    if found.certain {
        return found.brackets.iter().map(|b| polish(&p, refine(&p, b), b)).collect();
    }
    let p = Polynomial::new(c.map(DoubleDouble::of));
    let found = isolate(&p, DoubleDouble::of(lo), DoubleDouble::of(hi), DOUBT);
    found.brackets.iter().map(|b| refine(&p, b).to_f64()).collect()
}

/// Newton steps with the residual in double-double: what is left is the rounding of the root itself.
pub(crate) fn polish(p: &Polynomial<f64>, mut x: f64, bracket: &Bracket<f64>) -> f64 {
    for _ in 0..3 {
        let mut f = DoubleDouble::of(p.c[p.degree]);
        for k in (0..p.degree).rev() {
            f = f.scale(x) + DoubleDouble::of(p.c[k]);
        }
        let next = x - f.high / p.eval(x).1;
        if !(next >= bracket.lo && next <= bracket.hi) {
            return x;
        }
        let step = (next - x).abs();
        x = next;
        // Newton's error after a step this small is below a rounding, unless the root is
        // worse conditioned than 2²⁴; then the next step tells.
        if step <= f64::EPSILON * 256.0 * x.abs() {
            return x;
        }
    }
    x
}

/// `⌊log₂|x|⌋` for finite `x ≠ 0`, subnormal ones too.
pub(crate) fn exponent(x: f64) -> i32 {
    let biased = ((x.to_bits() >> 52) & 0x7ff) as i32;
    if biased > 0 { biased - 1023 } else { exponent(x * 2f64.powi(64)) - 64 }
}

/// `x 2ⁿ`, exact unless the result is subnormal or overflows.
#[inline]
pub(crate) fn times_power_of_two(x: f64, n: i32) -> f64 {
    if (-1022..=1023).contains(&n) {
        return x * f64::from_bits(((n + 1023) as u64) << 52);
    }
    times_extreme_power_of_two(x, n)
}

/// In steps that neither overflow nor underflow before the result does.
#[cold]
fn times_extreme_power_of_two(mut x: f64, mut n: i32) -> f64 {
    while n > 1000 && x != 0.0 && x.is_finite() {
        x *= 2f64.powi(1000);
        n -= 1000;
    }
    while n < -1000 && x != 0.0 {
        x *= 2f64.powi(-1000);
        n += 1000;
    }
    x * 2f64.powi(n.clamp(-1000, 1000))
}
