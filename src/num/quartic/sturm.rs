//! Sturm's chain counts the roots in any interval; bisection finds them.

use super::{Roots, with_scaled_roots};
use crate::num::double_double::DoubleDouble;
use crate::num::polynomial::{Bracket, Polynomial, middle, polish, refine};
use crate::num::real::Real;
use arrayvec::ArrayVec;

/// Real roots by Sturm's theorem: the sign changes in the chain at `x` minus those at `y` count the
/// distinct roots in `(x, y]`.
///
/// ```text
/// p₀ = p,  p₁ = p′,  p_{k+1} = −(p_{k−1} mod p_k)
/// ```
///
/// The chain is kept in double-double: its remainders cancel, and in `f64` they lose the count of close
/// pairs. A remainder within its rounding error is zero, and the chain then ends with the common
/// divisor of `p` and `p′`: multiple roots count once. Intervals are halved until each holds one root.
///
/// - Domain: finite; scaled by a power of two first.
/// - Accuracy: 2 u relative for simple roots, one spacing of `f64` for multiple ones; remainders lose about
///   twice the digits that the discriminant does, so that close pairs merge long before their roots agree in
///   `f64`, and roots below about `10⁻³⁰` of the largest are lost.
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: Sturm (1829); as a graphics algorithm: Hook & McAree, Graphics Gems (1990).
pub fn sturm(a3: f64, a2: f64, a1: f64, a0: f64) -> Roots {
    with_scaled_roots([a0, a1, a2, a3], |c| {
        let p = Polynomial::new([c[0], c[1], c[2], c[3], 1.0]);
        let chain = chain(&p);
        let mut out = Roots::new();
        // Scaled roots are in [−4, 4].
        search(&p, &chain, [(-8.0, changes(&chain, -8.0)), (8.0, changes(&chain, 8.0))], &mut out);
        out
    })
}

type Chain = ArrayVec<Polynomial<DoubleDouble>, 5>;

fn chain(p: &Polynomial<f64>) -> Chain {
    let exact = Polynomial::new(p.c.map(DoubleDouble::of));
    let mut chain = Chain::from_iter([exact, exact.derivative()]);
    while chain.len() < 5 {
        let next = negative_remainder(&chain[chain.len() - 2], &chain[chain.len() - 1]);
        match next {
            Some(next) => chain.push(next),
            None => break,
        }
    }
    chain
}

/// `−(a mod b)`, or nothing if that is zero up to rounding. The weights carry the size of all that was
/// added up.
fn negative_remainder(
    a: &Polynomial<DoubleDouble>,
    b: &Polynomial<DoubleDouble>,
) -> Option<Polynomial<DoubleDouble>> {
    // Four levels of the chain, at most two steps of two operations each, doubled for the errors of both
    // operands.
    const DOUBT: f64 = 32.0;
    let mut r = *a;
    if b.degree == 0 {
        return None;
    }
    for shift in (0..=a.degree - b.degree).rev() {
        let q = r.c[shift + b.degree] / b.c[b.degree];
        // A small leading coefficient multiplies what it is uncertain by.
        let q_size = (r.w[shift + b.degree] + q.high.abs() * b.w[b.degree]) / b.c[b.degree].high.abs();
        for k in 0..b.degree {
            r.c[shift + k] = r.c[shift + k] - q * b.c[k];
            r.w[shift + k] += q_size * b.c[k].high.abs() + q.high.abs() * b.w[k];
        }
    }
    let sure = |k: &usize| r.c[*k].high.abs() > DOUBT * DoubleDouble::ROUNDOFF * r.w[*k];
    let degree = (0..b.degree).rev().find(sure)?;
    // A power of two keeps the chain in range.
    let unit = 2f64.powi(-crate::num::polynomial::exponent(r.c[degree].high).clamp(-500, 500));
    let mut out = Polynomial { degree, c: [DoubleDouble::default(); 5], w: [0.0; 5] };
    for k in 0..=degree {
        out.c[k] = -r.c[k].shift(unit);
        out.w[k] = r.w[k] * unit;
    }
    Some(out)
}

/// Sign changes in the chain at `x`, zeros skipped.
fn changes(chain: &Chain, x: f64) -> usize {
    let mut count = 0;
    let mut last = 0.0;
    for p in chain {
        let value = p.eval(DoubleDouble::of(x)).0.high;
        if value != 0.0 {
            count += usize::from(last * value.signum() < 0.0);
            last = value.signum();
        }
    }
    count
}

/// Appends the roots in `(lo, hi]`, each end given with its count of changes.
fn search(
    p: &Polynomial<f64>,
    chain: &Chain,
    [(lo, at_lo), (hi, at_hi)]: [(f64, usize); 2],
    out: &mut Roots,
) {
    let roots = at_lo.saturating_sub(at_hi);
    if roots == 0 || out.is_full() {
        return;
    }
    let m = middle(lo, hi);
    let sign = |x: f64| chain[0].eval(DoubleDouble::of(x)).0.high;
    let (f_lo, f_hi) = (sign(lo), sign(hi));
    if m <= lo || m >= hi || (roots == 1 && f_hi == 0.0) {
        // The ends are neighbours, or the root is found.
        out.push(hi);
        return;
    }
    if roots == 1 && f_lo * f_hi < 0.0 {
        let before = if f_lo > 0.0 { 1 } else { -1 };
        let bracket = Bracket { lo, hi, before, after: -before };
        out.push(polish(p, refine(p, &bracket), &bracket));
        return;
    }
    let at_m = changes(chain, m);
    search(p, chain, [(lo, at_lo), (m, at_m)], out);
    search(p, chain, [(m, at_m), (hi, at_hi)], out);
}
