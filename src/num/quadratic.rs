//! Real roots of quadratics, without cancellation and without overflow.

use super::double_double::difference_of_products;
use super::polynomial::{exponent, times_power_of_two};
use arrayvec::ArrayVec;

/// The distinct real roots of `a x² + b x + c`, ascending.
///
/// ```text
/// D = (b/2)² − a c,    q = −(b/2 + sign(b) √D),    x = q/a and c/q
/// ```
///
/// The schoolbook formula subtracts `√D` from `b/2` when `c` is small, and the subtraction in `D`
/// can lose everything. Here `D` comes from error-free products, and powers of two keep all
/// terms in range.
///
/// - Domain: finite. `a = 0` leaves a line, `a = b = 0` has no list of roots; a double root
///   (`D = 0` exactly) is listed once.
/// - Accuracy: relative error of each root ≤ `num::gamma(5)`, unless it leaves the range of normal
///   numbers: `D` errs by at most 3 u, its root by half of that and one rounding, `q` (a sum of
///   terms of one sign) by one more, the quotient by one: 4.5 in all.
/// - NaN: NaN or infinite coefficients give no roots.
/// - Source: W. Kahan, *On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic* (2004).
pub fn real_roots(a: f64, b: f64, c: f64) -> ArrayVec<f64, 2> {
    if !(a.is_finite() && b.is_finite() && c.is_finite()) || (a == 0.0 && b == 0.0) {
        return ArrayVec::new();
    }
    if a == 0.0 {
        return line(b, c).into_iter().collect();
    }
    if c == 0.0 {
        return [0.0].into_iter().chain(line(a, b)).collect::<ArrayVec<_, 2>>().sorted();
    }
    if b == 0.0 && (a > 0.0) == (c > 0.0) {
        return ArrayVec::new();
    }
    // x = 2ˢ y makes a and c alike; then 2⁻ᵐ brings both near 1, and b wherever that leaves it.
    let (ea, ec) = (exponent(a), exponent(c));
    let s = (ec - ea).div_euclid(2);
    let m = ea + 2 * s;
    let (a2, c2) = (times_power_of_two(a, -ea), times_power_of_two(c, -m));
    let half = if b == 0.0 { 0.0 } else { times_power_of_two(b, s - m - 1) };
    // Beyond 2⁶⁴ the other terms are below a rounding of (b/2)², and the roots of a line each.
    let root = if half.abs() > 2f64.powi(64) {
        half.abs()
    } else {
        let d = difference_of_products(half, half, a2, c2);
        if d < 0.0 {
            return ArrayVec::new();
        }
        if d == 0.0 {
            return [times_power_of_two(-half / a2, s)].into_iter().collect();
        }
        d.sqrt()
    };
    let q = -(half + root.copysign(half));
    let roots = [q / a2, c2 / q].map(|y| times_power_of_two(y, s));
    roots.into_iter().filter(|x| x.is_finite()).collect::<ArrayVec<_, 2>>().sorted()
}

/// The root of `a x + b`, unless it overflows.
fn line(a: f64, b: f64) -> Option<f64> {
    let x = -b / a;
    x.is_finite().then_some(x + 0.0)
}

/// Ascending and distinct.
trait Sorted {
    fn sorted(self) -> Self;
}

impl Sorted for ArrayVec<f64, 2> {
    fn sorted(mut self) -> Self {
        self.sort_unstable_by(f64::total_cmp);
        if self.len() == 2 && self[0] == self[1] {
            self.pop();
        }
        self
    }
}
