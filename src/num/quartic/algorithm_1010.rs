//! Two quadratic factors from an LDLᵀ decomposition.

use super::{Roots, with_scaled_roots};
use crate::num::{U, quadratic};

/// Real roots by Algorithm 1010.
///
/// The quartic is the quadratic form `(x², x, 1) M (x², x, 1)ᵀ` for a whole family of symmetric `M`;
/// the dominant root `φ` of a cubic picks one with `det M = 0`, and its decomposition `M = L D Lᵀ` reads off
/// two quadratic factors. Every quantity that can be computed in several ways is computed in the one
/// that reproduces the coefficients best, and Newton's method on the factors ends it.
///
/// ```text
/// l₁ = a/2,  l₃ = b/6 + φ/2,  d₂ = 2b/3 − φ − l₁²,  l₂ = (c − a l₃)/(2 d₂)
/// d₂ < 0:  x² + (l₁ ± γ) x + (l₃ ± γ l₂),  γ = √−d₂;   d₂ > 0: no real roots
/// ```
///
/// - Domain: finite; scaled by a power of two first.
/// - Accuracy: backward stable in the factors; a pair closer than about `√u` may appear or disappear.
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: Orellana & De Michele, *Algorithm 1010: Boosting Efficiency in Solving Quartic Equations with No
///   Compromise in Accuracy*, ACM TOMS 46(2) (2020).
pub fn algorithm_1010(a3: f64, a2: f64, a1: f64, a0: f64) -> Roots {
    with_scaled_roots([a0, a1, a2, a3], |[d, c, b, a]| {
        let q = Quartic { a, b, c, d };
        let Some(f) = q.factors() else { return Roots::new() };
        let f = q.improve(f);
        let pair = |[alpha, beta]: [f64; 2]| quadratic::real_roots(1.0, alpha, beta);
        pair(f[0]).into_iter().chain(pair(f[1])).collect()
    })
}

/// `x⁴ + a x³ + b x² + c x + d`.
#[derive(Clone, Copy)]
struct Quartic {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
}

/// `(x² + α₁ x + β₁)(x² + α₂ x + β₂)` as `[[α₁, β₁], [α₂, β₂]]`.
type Factors = [[f64; 2]; 2];

/// Relative to the target unless that is zero.
fn mismatch(got: f64, want: f64) -> f64 {
    if want == 0.0 { got.abs() } else { ((got - want) / want).abs() }
}

impl Quartic {
    /// Real factors, unless the factors are complex and with them all roots.
    fn factors(&self) -> Option<Factors> {
        let phi = self.phi();
        let (l1, l3) = (self.a / 2.0, self.b / 6.0 + phi / 2.0);
        let (d2, l2) = self.d2_l2(phi, l1, l3);
        let first = (d2 < 0.0).then(|| self.real_factors(l1, l3, d2, l2));
        let negligible = 2.0 * U * (2.0 * self.b / 3.0).abs().max(phi.abs()).max(l1 * l1);
        if d2.abs() > negligible {
            return first;
        }
        // d₂ = 0: M has rank one but for d₃, and the factors differ in their constants only.
        let d3 = self.d - l3 * l3;
        let complex_error = |d2: f64, l2: f64| self.decomposition_error(l1, l3, d2, l2);
        let second = (d3 <= 0.0).then(|| {
            let (p, m) = (l3 + (-d3).sqrt(), l3 - (-d3).sqrt());
            let (p, m) = if m.abs() < p.abs() {
                (p, self.d / p)
            } else if p.abs() < m.abs() {
                (self.d / m, m)
            } else {
                (p, m)
            };
            [[l1, p], [l1, m]]
        });
        let first_error = match first {
            Some(f) => self.error(f),
            None if d2 == 0.0 => f64::INFINITY,
            None => complex_error(d2, l2),
        };
        let second_error = match second {
            Some(f) => self.error(f),
            None => {
                mismatch(2.0 * l3 + l1 * l1, self.b)
                    + mismatch(2.0 * l1 * l3, self.c)
                    + mismatch(l3 * l3 + d3, self.d)
            }
        };
        if second_error < first_error { second } else { first }
    }

    /// Dominant root of the cubic that makes `det M = 0`, shifted to where it cancels least.
    fn phi(&self) -> f64 {
        let Quartic { a, b, c, d } = *self;
        let under_root = 9.0 * a * a - 24.0 * b;
        let s =
            if under_root > 0.0 { -2.0 * b / (3.0 * a + under_root.sqrt().copysign(a)) } else { -a / 4.0 };
        let aq = a + 4.0 * s;
        let bq = b + 3.0 * s * (a + 2.0 * s);
        let cq = c + s * (2.0 * b + s * (3.0 * a + 4.0 * s));
        let dq = d + s * (c + s * (b + s * (a + s)));
        let (squared, mixed) = (bq * bq / 9.0, aq * cq);
        let g = mixed - 4.0 * dq - 3.0 * squared;
        let h = (8.0 * dq + mixed - 2.0 * squared) * bq / 3.0 - cq * cq - dq * aq * aq;
        refined_root(g, h, dominant_root(g, h))
    }

    /// The pair `(d₂, l₂)` that reproduces the coefficients best, of three ways to compute it.
    fn d2_l2(&self, phi: f64, l1: f64, l3: f64) -> (f64, f64) {
        let off = self.c - self.a * l3;
        let d2 = 2.0 * self.b / 3.0 - phi - l1 * l1;
        let rest = self.d - l3 * l3;
        let l2 = 2.0 * rest / off;
        let ways = [(d2, off / (2.0 * d2)), (off / (2.0 * l2), l2), (d2, l2)];
        let mut best = (d2, 0.0);
        let mut least = f64::INFINITY;
        for (d2, l2) in ways {
            let e = self.decomposition_error(l1, l3, d2, l2);
            if e < least {
                (best, least) = ((d2, l2), e);
            }
        }
        best
    }

    fn decomposition_error(&self, l1: f64, l3: f64, d2: f64, l2: f64) -> f64 {
        mismatch(d2 + l1 * l1 + 2.0 * l3, self.b)
            + mismatch(2.0 * (d2 * l2 + l1 * l3), self.c)
            + mismatch(d2 * l2 * l2 + l3 * l3, self.d)
    }

    fn real_factors(&self, l1: f64, l3: f64, d2: f64, l2: f64) -> Factors {
        let gamma = (-d2).sqrt();
        let (mut alpha, mut beta) = ([l1 + gamma, l1 - gamma], [l3 + gamma * l2, l3 - gamma * l2]);
        // The smaller constant from the product, which does not cancel.
        let (large, small) = if beta[0].abs() >= beta[1].abs() { (0, 1) } else { (1, 0) };
        if beta[large] != 0.0 {
            beta[small] = self.d / beta[large];
        }
        // The smaller linear coefficient from whichever equation fits best.
        let (large, small) = if alpha[0].abs() >= alpha[1].abs() { (0, 1) } else { (1, 0) };
        let kept = alpha[large];
        let ways = [
            alpha[small],
            (self.c - kept * beta[small]) / beta[large],
            (self.b - beta[0] - beta[1]) / kept,
            self.a - kept,
        ];
        let mut least = f64::INFINITY;
        for way in ways {
            let e = mismatch(kept * beta[small] + way * beta[large], self.c)
                + mismatch(beta[0] + beta[1] + kept * way, self.b)
                + mismatch(kept + way, self.a);
            if e < least {
                (alpha[small], least) = (way, e);
            }
        }
        [[alpha[0], beta[0]], [alpha[1], beta[1]]]
    }

    fn error(&self, [[p, q], [r, s]]: Factors) -> f64 {
        mismatch(p + r, self.a)
            + mismatch(q + p * r + s, self.b)
            + mismatch(q * r + p * s, self.c)
            + mismatch(q * s, self.d)
    }

    /// Newton's method on the factors while it helps: `A δB + B δA = p − A B`, solved modulo `A`.
    fn improve(&self, mut f: Factors) -> Factors {
        let mut error = self.error(f);
        for _ in 0..8 {
            let [[p, q], [r, s]] = f;
            let rest = [self.d - q * s, self.c - q * r - p * s, self.b - q - p * r - s, self.a - p - r];
            // Rest and B modulo A, by x² = −p x − q.
            let lead = rest[2] - p * rest[3];
            let (r1, r0) = (rest[1] - q * rest[3] - p * lead, rest[0] - q * lead);
            let (e, g) = (r - p, s - q);
            let det = g * (g - e * p) + e * e * q;
            let u = (r1 * g - e * r0) / det;
            let v = ((g - e * p) * r0 + e * q * r1) / det;
            let w = rest[3] - u;
            let next = [[p + u, q + v], [r + w, s + rest[2] - p * w - r * u - v]];
            let e = self.error(next);
            if !(e < error) {
                break;
            }
            (f, error) = (next, e);
        }
        f
    }
}

/// The root of largest magnitude of `x³ + g x + h`, by formula.
fn dominant_root(g: f64, h: f64) -> f64 {
    let (q, r) = (-g / 3.0, 0.5 * h);
    let q3 = q * q * q;
    if r * r < q3 {
        let theta = (r / q3.sqrt()).clamp(-1.0, 1.0).acos();
        let third = if r > 0.0 { theta / 3.0 } else { (theta + std::f64::consts::TAU) / 3.0 };
        -2.0 * q.sqrt() * third.cos()
    } else {
        let s = -(r.abs() + (r * r - q3).sqrt()).cbrt().copysign(r);
        if s == 0.0 { 0.0 } else { s + q / s }
    }
}

/// Newton's steps while the residual falls.
fn refined_root(g: f64, h: f64, mut x: f64) -> f64 {
    let mut f = x * (x * x + g) + h;
    for _ in 0..8 {
        let next = x - f / (3.0 * x * x + g);
        let f_next = next * (next * next + g) + h;
        if !(f_next.abs() < f.abs()) {
            break;
        }
        (x, f) = (next, f_next);
    }
    x
}
