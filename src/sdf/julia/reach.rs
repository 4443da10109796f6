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
//! Along a line with unit direction, `δ = d|q_n|/dh`, and since a norm is convex,
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

/// Points and directions of four places: what the iteration starts with, in the coordinates of [`Set`].
#[derive(Clone, Copy)]
pub(super) struct Start<V> {
    pub a: V,
    pub u: V,
    pub p: V,
    pub da: V,
    pub du: V,
    /// Half the derivative of `p`.
    pub hp: V,
}

/// The iterates at which four places are decided.
#[derive(Clone, Copy)]
pub(super) struct Iterates<V> {
    /// `α²`, half its derivative along the line, `β` and `κ`.
    pub n: V,
    pub half_dn: V,
    pub beta: V,
    pub kappa: V,
    /// Threshold of the level at which the place was decided.
    pub threshold: V,
}

/// Iterates four places until each is far enough outside to be decided, or to the last level.
#[inline(always)]
pub(super) fn iterate<V: Lanes>(set: &Set, start: Start<V>) -> Iterates<V> {
    let Start { mut a, mut u, mut p, mut da, mut du, mut hp } = start;
    let (two, four, c0, k) = (V::splat(2.0), V::splat(4.0), V::splat(set.c0), V::splat(set.k));
    let least = V::splat(LEAST);
    let (mut beta, mut kappa) = (V::splat(1.0), V::splat(0.0));
    let zero = V::splat(0.0);
    let mut out = Iterates { n: zero, half_dn: zero, beta, kappa, threshold: zero };
    let mut open = two.above(zero);
    for (i, level) in set.levels.iter().enumerate() {
        let (a2, u2, ada, udu) = (a * a, u * u, a * da, u * du);
        let (n, half_dn) = (a2 + u2 + p, ada + udu + hp);
        let last = i + 1 == set.levels.len();
        // At the last level what is still open is decided, before it what has gone far enough.
        let decided = if last { open } else { open.and(n.above(V::splat(level.stop2))) };
        if decided.any() {
            out.n = decided.pick(n, out.n);
            out.half_dn = decided.pick(half_dn, out.half_dn);
            out.beta = decided.pick(beta, out.beta);
            out.kappa = decided.pick(kappa, out.kappa);
            out.threshold = decided.pick(V::splat(level.threshold), out.threshold);
            open = open.without(decided);
            if !open.any() {
                break;
            }
        }
        let twice = (four * n + least).sqrt();
        kappa = beta * beta + twice * kappa;
        beta = twice * beta;
        let ta = a + a;
        let next_da = two * (ada - udu - hp);
        du = ta * du + (u + u) * da;
        da = next_da;
        hp = four * (ada * p + a2 * hp);
        a = (a2 - u2) - (p - c0);
        u = ta * u + k;
        p = four * (a2 * p);
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
    let alpha = it.n.sqrt();
    let outside = alpha.above(it.threshold);
    let (delta, l) = (it.half_dn / alpha, it.kappa / it.beta);
    let gap = alpha - it.threshold;
    let (mut back, mut ahead);
    let inside = outside.pick(zero, V::splat(1.0));
    if inside.above(zero).any() {
        // (4): the signs of gap and slope change, and κ grows; where |q| nearly vanishes, (1) tells more.
        let gap = outside.pick(gap, zero - gap);
        let slope = outside.pick(delta, alpha.above(zero).pick(zero - delta, zero));
        let kappa = outside.pick(it.kappa, it.kappa + it.beta * it.beta / (alpha + alpha));
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
    ball(it.n.sqrt() - it.threshold, it.beta, it.kappa / it.beta)
}

/// Radius of a ball about a point that holds no point of the surface.
pub(super) fn free(set: &Set, at: DVec3) -> f64 {
    let Reduced { a, u, across } = set.reduced(at, set.w());
    let still = Plain::splat(0.0);
    let (a, u, p) = (Plain::splat(a), Plain::splat(u), Plain::splat(across.length_squared()));
    let it = iterate(set, Start { a, u, p, da: still, du: still, hp: still });
    let gap = it.n.sqrt() - it.threshold;
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
