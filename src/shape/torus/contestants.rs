//! Other ways to meet a torus, kept to be measured against the default.

use super::line::Line;
use super::{Meeting, Meetings, Torus, TorusMethod};
use crate::num::U;
use crate::num::quartic::{self, Roots, Solver};
use crate::ray::Ray;

/// Roots at or below this are no hits: the document's absolute `0.000001` for its own method, else zero.
pub(super) fn least_t(method: TorusMethod) -> f64 {
    if method == TorusMethod::AsPrinted { 1e-6 } else { 0.0 }
}

/// The quartic expanded at the ray's origin, in the scene's units [A (5.18)–(5.22), ill. 59].
///
/// ```text
/// a₄ = D²,  a₃ = 4 B D,  a₂ = 2 D E + 4 B² + 4 a² dz²,  a₁ = 4 B E + 8 a² oz dz,  a₀ = E² − 4 a² (b² − oz²)
/// D = d·d,  B = o·d,  E = o·o − a² − b²
/// ```
///
/// (5.23) numbers the coefficients in reverse; here `aᵢ` multiplies `tⁱ`, as in the document's program.
pub(super) fn as_printed(torus: &Torus, ray: &Ray) -> Meetings {
    let (o, d) = (ray.origin, ray.direction);
    let (a2, b2) = (torus.ring * torus.ring, torus.tube * torus.tube);
    let (dd, od) = (d.length_squared(), o.dot(d));
    let e = o.length_squared() - (a2 + b2);
    let c4 = dd * dd;
    let c3 = 4.0 * od * dd;
    let c2 = 2.0 * dd * e + 4.0 * (od * od) + 4.0 * a2 * d.z * d.z;
    let c1 = 4.0 * od * e + 8.0 * a2 * o.z * d.z;
    let c0 = e * e - 4.0 * a2 * (b2 - o.z * o.z);
    let roots = quartic::graphics_gems_as_printed(c3 / c4, c2 / c4, c1 / c4, c0 / c4);
    let inside = |t: f64| {
        let p = ray.at(t);
        (p.x.hypot(p.y) - torus.ring).hypot(p.z) < torus.tube
    };
    signed(roots, inside).collect()
}

/// The quartic at the closest approach in the torus's unit, given to a solver.
pub(super) fn recentred(line: &Line, solver: Solver) -> Meetings {
    let [c2, c1, c0] = line.monic();
    let roots = solver(0.0, c2, c1, c0);
    let in_line = signed(roots, |s| line.distance(s) < 0.0);
    in_line.map(|m| line.meeting(line.middle + m.t, m.before, m.after)).filter(|m| m.t.is_finite()).collect()
}

/// Adds the signs between roots, asked at their middles.
fn signed(roots: Roots, inside: impl Fn(f64) -> bool) -> impl Iterator<Item = Meeting> {
    let mut signs = [1; 5];
    for (sign, pair) in signs[1..].iter_mut().zip(roots.windows(2)) {
        *sign = if inside(0.5 * (pair[0] + pair[1])) { -1 } else { 1 };
    }
    roots.into_iter().enumerate().map(move |(i, t)| Meeting { t, before: signs[i], after: signs[i + 1] })
}

/// Tuned, for `a = 2`, `b = 0.6`: lines `0.01 b` deep keep both roots, and the first is found down to `10⁻⁷ b`;
/// what is lost costs 80 µs.
const STEPS: usize = 2000;

/// Steps of the exact distance through the bounding sphere; each change of its sign is bisected.
///
/// A step never passes the surface, only approaches it: within rounding of the surface the step is that
/// rounding, `γ₈` of the size of the torus, and so walks through. Where the line meets the surface at a slope
/// `sin α`, distances shrink and grow by that share per step: about `36 / sin α` steps to each
/// side of each root, and `sin α = √(2g/b)` for a line that grazes at depth `g`. After [`STEPS`] the
/// search ends with what it has.
pub(super) fn marching(line: &Line) -> Meetings {
    let speed = line.d2.sqrt();
    let least = crate::num::gamma(8) * (line.torus.a + line.torus.b) / speed;
    let end = line.reach() + least;
    let (mut s, mut out) = (-end, Meetings::new());
    let mut last = line.distance(s);
    for _ in 0..STEPS {
        if s > end || out.is_full() {
            break;
        }
        let next = s + (last.abs() / speed).max(least).max(2.0 * U * s.abs());
        let here = line.distance(next);
        if (here < 0.0) != (last < 0.0) {
            let root = bisect(line, s, next, last < 0.0);
            let sign = |d: f64| if d < 0.0 { -1 } else { 1 };
            out.push(line.meeting(line.middle + root, sign(last), sign(here)));
        }
        (s, last) = (next, here);
    }
    out.retain(|m| m.t.is_finite());
    out
}

fn bisect(line: &Line, mut lo: f64, mut hi: f64, inside_at_lo: bool) -> f64 {
    loop {
        let m = 0.5 * (lo + hi);
        if m <= lo || m >= hi {
            return hi;
        }
        if (line.distance(m) < 0.0) == inside_at_lo {
            lo = m;
        } else {
            hi = m;
        }
    }
}
