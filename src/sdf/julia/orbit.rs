//! One orbit: how long it stays, its derivative, and what both say about distances.
//!
//! Outside the set of the endless iteration the potential `G = lim 2⁻ⁿ ln |q_n|` grows from 0, and `G/2|∇G|` is half the
//! distance of a smooth boundary, up to a factor of at most 2. Stopped at a large `|q|` it reads `½ |q| ln |q| / |q'|`: (2) of
//! [`super`]. Far away `G ≈ ln |p|`, and the estimate `½ |p| ln |p|` exceeds the distance `|p|` from |p| = 7.4 on.

use crate::num::U;
use crate::num::real::Real;
use glam::DVec4;

/// A quaternion by its factors of 1, i, j, k.
pub type Quaternion<R> = [R; 4];

/// The factors of 1, i, j, k in another arithmetic.
pub fn quaternion<R: Real>(q: DVec4) -> Quaternion<R> {
    q.to_array().map(R::from_f64)
}

/// `q² + c`.
///
/// ```text
/// (x + v)² = x² − |v|² + 2 x v
/// ```
///
/// - Accuracy: each coordinate to 6 roundings of `|q|² + |c|`.
pub fn squared_plus<R: Real>([x, i, j, k]: Quaternion<R>, c: Quaternion<R>) -> Quaternion<R> {
    let twice = x + x;
    [x * x - i * i - j * j - k * k + c[0], twice * i + c[1], twice * j + c[2], twice * k + c[3]]
}

/// `|q|²`.
pub fn norm<R: Real>([x, i, j, k]: Quaternion<R>) -> R {
    x * x + i * i + j * j + k * k
}

/// `|q|`, also where its square under- or overflows.
pub fn length<R: Real>(q: Quaternion<R>) -> R {
    let n = norm(q);
    if (1.0e-270..1.0e270).contains(&n.to_f64()) {
        return n.sqrt();
    }
    // By powers of two, which round nothing.
    let up = 2f64.powi(if n.to_f64() < 1.0 { 600 } else { -600 });
    let (up, down) = (R::from_f64(up), R::from_f64(1.0 / up));
    norm(q.map(|x| x * up)).sqrt() * down
}

/// The least radius from which no orbit returns: `r² − |c| = r`.
///
/// ```text
/// (1 + √(1 + 4 |c|)) / 2
/// ```
pub fn escape_radius(c: DVec4) -> f64 {
    0.5 * (1.0 + (1.0 + 4.0 * c.length()).sqrt())
}

/// Hart's estimate of the distance \[m\] from `|q|` and `|q'|` of an orbit that has left: (2) of [`super`].
///
/// - Domain: `size` > 1; below it the logarithm is negative.
/// - NaN: where both are infinite: an orbit needs a bailout.
pub fn estimate(size: f64, derivative: f64) -> f64 {
    0.5 * size * size.ln() / derivative
}

/// The end of an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Escape<R> {
    /// Has it left?
    pub escaped: bool,
    /// After how many steps; those that were asked for if it has not.
    pub steps: u32,
    /// The last iterate, and its length.
    pub q: Quaternion<R>,
    pub size: R,
    /// `|q'|`, the product of all `2|q_n|`.
    pub derivative: R,
}

/// Follows an orbit until `|q| > bailout`, which is asked before each step, or for `most` steps.
///
/// - Accuracy: errors grow with `|q'|`. In `f64` the last digit of `|q|` is lost at `|q'|` = 10¹⁶, in
///   double-double at 10³¹.
pub fn escape<R: Real>(mut q: Quaternion<R>, c: Quaternion<R>, most: u32, bailout: f64) -> Escape<R> {
    let mut derivative = R::from_f64(1.0);
    for steps in 0.. {
        let size = length(q);
        let escaped = size > R::from_f64(bailout);
        if escaped || steps == most {
            return Escape { escaped, steps, q, size, derivative };
        }
        derivative = (size + size) * derivative;
        q = squared_plus(q, c);
    }
    unreachable!("an orbit ends after `most` steps")
}

impl<R: Real> Escape<R> {
    /// Hart's estimate \[m\]; `None` inside, and where the derivative vanishes.
    pub fn estimate(&self) -> Option<f64> {
        let derivative = self.derivative.to_f64();
        (self.escaped && derivative > 0.0).then(|| estimate(self.size.to_f64(), derivative))
    }
}

/// The estimate after exactly `steps`, whether the orbit has left or not: (2) without a bailout, as it is often printed.
///
/// - NaN: `∞/∞` as soon as `|q'|` overflows: with `f32` after some nine steps, with `f64` after some twelve.
pub fn as_printed_estimate<R: Real>(mut q: Quaternion<R>, c: Quaternion<R>, steps: u32) -> f64 {
    let mut derivative = R::from_f64(1.0);
    for _ in 0..steps {
        derivative = R::from_f64(2.0) * norm(q).sqrt() * derivative;
        q = squared_plus(q, c);
    }
    estimate(norm(q).sqrt().to_f64(), derivative.to_f64())
}

/// Steps after which an orbit counts as one that stays.
const MOST_STEPS: usize = 100_000;
/// How far an orbit is followed, in escape radii: the bound of each step is the best of all on the way.
const FAR: f64 = 1.0e3;

/// A length \[m\] that leads from `q` to no point of the set of the endless iteration, in any of four directions; 0 inside.
///
/// A ball of radius `r` about `q_n` comes from a ball about `q_{n−1}` of at least
///
/// ```text
/// √(|q_{n−1}|² + r) − |q_{n−1}|
/// ```
///
/// because squares move by at most `2|q| h + h²`. So the ball about any `q_n` that stays beyond the escape radius
/// leads back to a ball about `q`. Where `|q'|` is long the step is about `(|q_n| − R)/|q'_n|`; far away, where the
/// estimate overshoots, it is `|q| − R`.
///
/// - Domain: any finite `q` and `c`. Orbits that stay for 10⁵ steps count as inside.
/// - Accuracy: a bound, less all roundings, which are counted in the arithmetic `R` of the orbit.
/// - Source: the inverse of the triangle inequality; compare Hart, Sandin & Kauffman (1989), §4.
pub fn safe_step<R: Real>(q: DVec4, c: DVec4) -> f64 {
    let radius = escape_radius(c) * (1.0 + 8.0 * U);
    let (mut q, c_size, c) = (quaternion::<R>(q), c.length(), quaternion::<R>(c));
    let (mut sizes, mut error, mut best) = (Vec::new(), 0.0, 0.0f64);
    while sizes.len() < MOST_STEPS {
        let size = length(q).to_f64();
        let gap = size * (1.0 - 2.0 * U) - error - radius;
        if gap > 0.0 {
            let back = |r: f64, size: &f64| r / ((size * size + r).sqrt() + size);
            let rounded = 1.0 - 8.0 * U * (sizes.len() + 1) as f64;
            best = best.max(sizes.iter().rev().fold(gap, back) * rounded);
        }
        if !(size < FAR * radius) {
            break;
        }
        error = 2.0 * size * error + error * error + 16.0 * R::ROUNDOFF * (size * size + c_size);
        sizes.push(size);
        q = squared_plus(q, c);
    }
    best
}
