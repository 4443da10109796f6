//! How far from a point, along a line or all around, the sign of `|q_N| − B` is certain not to change.
//!
//! Let `A_n` be the iterates of the point, `α_n = |A_n|`, and let the point move by `h`. Quaternions multiply lengths,
//! so the iterates move by at most `m_n`, where
//!
//! ```text
//! m₀ = h,   m_{n+1} = 2 α_n m_n + m_n²  =  (α_n + m_n)² − α_n²                                  (1)
//! ```
//!
//! To first order `m_n = β_n h` with `β_{n+1} = 2 α_n β_n`, which is Hart's `|q'|`. What `m_n` exceeds that by bounds
//! everything in `q_n` that is not linear in the step. With `κ_{n+1} = β_n² + 2 α_n κ_n`, `L = κ/β` and `x = L h`:
//!
//! ```text
//! m_n ≤ β_n h / (1 − x),   x < 1                                                                   (2)
//! ```
//!
//! For the ratio `y_n = m_n/β_n h` obeys `y_{n+1} = y_n (1 + x_n y_n)` with `x_n = β_n h/2α_n`, so `1/y_{n+1} ≥ 1/y_n − x_n`, and
//! the `x_n` add up to `x`, because `κ/β` grows by `β_n/2α_n` a step.
//!
//! Along a line `δ = d|q_n|/dh`, and since a norm is convex,
//!
//! ```text
//! |q_n(h)| ≥ α + δ h − κ h²/(1 − x)                                                               (3)
//! |q_n(h)| ≤ α + δ h + (κ + β²/2α) h²/(1 − x)                                                     (4)
//! ```
//!
//! (3) above the threshold of its level is certainly outside, (4) below that of the last is certainly inside. Times `1 − x`
//! both are quadratic equations for `h`, whose least positive solution lies before `x = 1`.

use super::lanes::{LANES, Lanes, Plain};
use super::set::{Reduced, Set};
use glam::DVec3;

/// Least `4 α²` that counts, so that the products of a hundred steps stay numbers: `β² ≥ LEAST¹⁰⁰ = 10⁻²⁷¹`. A larger `α` makes all
/// bounds shorter, hence still right: by 1/4000 a step where `α` = 1.
const LEAST: f64 = 1.0 / 512.0;

/// What the iteration of four places starts with: the coordinates (2) of [`super::set`] and their derivatives along a line.
#[derive(Clone, Copy)]
pub(super) struct Start<V> {
    pub x: V,
    pub y: V,
    pub z: V,
    pub dx: V,
    pub dy: V,
    /// Half the derivative of `z`.
    pub half_dz: V,
    /// `β₀`: the length of the line's direction; `h` counts such lengths.
    pub beta: V,
}

/// The iterates at which four places are decided.
#[derive(Clone, Copy)]
struct Iterates<V> {
    /// `(2α)²`, and half its derivative along the line.
    n: V,
    half_dn: V,
    beta: V,
    kappa: V,
    /// Threshold of the level at which the place was decided.
    threshold: V,
}

/// Iterates four places until each is far enough outside to be decided, or to the last level.
#[inline(always)]
fn iterate<V: Lanes>(set: &Set, start: Start<V>) -> Iterates<V> {
    let Start { mut x, mut y, mut z, mut dx, mut dy, mut half_dz, mut beta } = start;
    let (half, c0, k, least) =
        (V::splat(0.5), V::splat(set.c0_twice), V::splat(set.k_twice), V::splat(LEAST));
    let (zero, mut kappa) = (V::splat(0.0), V::splat(0.0));
    let mut out = Iterates { n: zero, half_dn: zero, beta, kappa, threshold: zero };
    let mut open = half.above(zero);
    for (i, level) in set.levels.iter().enumerate() {
        let (x2, rest, xdx, across) = (x * x, y.mul_add(y, z), x * dx, y.mul_add(dy, half_dz));
        let n = x2 + rest;
        // At the last level what is still open is decided, before it what has gone far enough.
        let last = i + 1 == set.levels.len();
        let decided = if last { open } else { open.and(n.above(V::splat(level.stop))) };
        if decided.any() {
            out.n = decided.pick(n, out.n);
            out.half_dn = decided.pick(xdx + across, out.half_dn);
            out.beta = decided.pick(beta, out.beta);
            out.kappa = decided.pick(kappa, out.kappa);
            out.threshold = decided.pick(V::splat(level.threshold), out.threshold);
            open = open.without(decided);
            if !open.any() {
                break;
            }
        }
        let twice = (n + least).sqrt();
        kappa = beta.mul_add(beta, twice * kappa);
        beta = twice * beta;
        let next_dx = xdx - across;
        dy = x.mul_add(dy, y * dx);
        dx = next_dx;
        half_dz = xdx.mul_add(z, x2 * half_dz);
        y = x.mul_add(y, k);
        x = half.mul_add(x2 - rest, c0);
        z = x2 * z;
    }
    out
}

/// Four stretches of a line about four of its points.
#[derive(Clone, Copy)]
pub(super) struct Stretches {
    /// Is the point inside the solid?
    pub inside: [bool; LANES],
    pub back: [f64; LANES],
    pub ahead: [f64; LANES],
    /// `α`, `δ`, `β`, `κ` of the points.
    pub alpha: [f64; LANES],
    pub delta: [f64; LANES],
    pub beta: [f64; LANES],
    pub kappa: [f64; LANES],
}

/// The least `h > 0` with `gap + slope h = κ h²/(1 − L h)`: (3), where `|slope| ≤ β`, or (4).
#[inline(always)]
fn solve<V: Lanes>(gap: V, slope: V, kappa: V, l: V) -> V {
    let zero = V::splat(0.0);
    let (b, c) = (slope - l * gap, kappa + l * slope);
    let root = (b * b + V::splat(4.0) * (gap * c)).sqrt();
    let rising = b.above(zero);
    let numerator = rising.pick(b + root, gap + gap);
    let denominator = rising.pick(c + c, root - b);
    // Nothing bends at level 0, and where |slope| is β but for a rounding c may vanish: then (2) ends the stretch.
    let endless = gap.above(zero).pick(V::splat(1.0) / l, zero);
    denominator.above(zero).pick(numerator / denominator, endless)
}

/// The stretches about four places of a line on which the sign is that of the place itself.
#[inline(always)]
pub(super) fn stretches<V: Lanes>(set: &Set, start: Start<V>) -> Stretches {
    let it = iterate(set, start);
    let zero = V::splat(0.0);
    let twice = it.n.sqrt();
    let alpha = V::splat(0.5) * twice;
    let outside = alpha.above(it.threshold);
    let (delta, l) = (V::splat(0.5) * it.half_dn / twice, it.kappa / it.beta);
    let gap = alpha - it.threshold;
    let (mut back, mut ahead);
    let inside = outside.pick(zero, V::splat(1.0));
    if inside.above(zero).any() {
        // (4): the signs of gap and slope change, and κ grows; where |q| nearly vanishes, (1) tells more.
        let gap = outside.pick(gap, zero - gap);
        let slope = outside.pick(delta, alpha.above(zero).pick(zero - delta, zero));
        let kappa = outside.pick(it.kappa, it.kappa + it.beta * it.beta / twice);
        back = solve(gap, zero - slope, kappa, l);
        ahead = solve(gap, slope, kappa, l);
        let ball = ball(gap, it.beta, l);
        // Where α vanishes, (4) gives no number, and the ball stands.
        back = outside.pick(back, back.above(ball).pick(back, ball));
        ahead = outside.pick(ahead, ahead.above(ball).pick(ahead, ball));
    } else {
        back = solve(gap, zero - delta, it.kappa, l);
        ahead = solve(gap, delta, it.kappa, l);
    }
    Stretches {
        inside: inside.array().map(|x| x != 0.0),
        back: back.array(),
        ahead: ahead.array(),
        alpha: alpha.array(),
        delta: delta.array(),
        beta: it.beta.array(),
        kappa: it.kappa.array(),
    }
}

/// The largest `h` with `β h/(1 − L h) ≤ gap`, by (2); 0 for no gap.
#[inline(always)]
fn ball<V: Lanes>(gap: V, beta: V, l: V) -> V {
    let zero = V::splat(0.0);
    gap.above(zero).pick(gap / (beta + l * gap), zero)
}

/// Radii of balls about four places that hold no point of the solid; 0 inside.
#[inline(always)]
pub(super) fn balls<V: Lanes>(set: &Set, start: Start<V>) -> V {
    let it = iterate(set, start);
    ball(V::splat(0.5) * it.n.sqrt() - it.threshold, it.beta, it.kappa / it.beta)
}

/// Radius of a ball about a point that holds no point of the surface.
pub(super) fn free(set: &Set, at: DVec3) -> f64 {
    let at = Reduced::doubled(set.reduced(at, set.w()));
    let still = Plain::splat(0.0);
    let [x, y, z] = at.map(Plain::splat);
    let it = iterate(set, Start { x, y, z, dx: still, dy: still, half_dz: still, beta: Plain::splat(1.0) });
    let gap = Plain::splat(0.5) * it.n.sqrt() - it.threshold;
    let gap = gap.above(still).pick(gap, still - gap);
    ball(gap, it.beta, it.kappa / it.beta).array()[0]
}

impl Stretches {
    /// Does `|q|` certainly fall (or, for `rising`, rise) from point `i` on, all the way to a distance `h`?
    ///
    /// `½ d|q|²/dh = (A + B h + E)·(B + E')`, where by (2) `|A + B h + E| ≤ α + m`, `|E| ≤ m − β h`; and since
    /// `m'_{n+1} = 2 (α_n + m_n) m'_n`, `|E'| ≤ β (Π (1 + x_n y_n)² − 1) ≤ β (y² − 1)`.
    pub fn is_monotone(&self, i: usize, h: f64) -> bool {
        let (alpha, beta) = (self.alpha[i], self.beta[i]);
        let x = h * self.kappa[i] / beta;
        if !(x < 1.0) {
            return false;
        }
        let y = 1.0 / (1.0 - x);
        let moved = beta * h / alpha * y;
        self.delta[i].abs() / beta > moved + (1.0 + moved) * (y * y - 1.0)
    }
}
