//! A line seen from its closest approach to the torus's centre, and its certified roots.
//!
//! With the origin `m` at the closest approach (`m · d = 0`) the quartic has no cubic term, and its
//! coefficients are of order one whatever the distance of the ray's origin:
//!
//! ```text
//! D² s⁴ + (2D(M + a² − b²) − 4a²(dx² + dy²)) s² + 8a² mz dz s + (M + a² − b²)² − 4a²(mx² + my²)
//! M = m·m,  D = d·d,  m = d × (o × d)/D,  t = s − o·d/D
//! ```
//!
//! The products in `o × d` are error-free, so that `m` is as good as `u |m|`, not only `u |o|`.

use super::first::{First, Quartic, Start};
use super::{Meeting, Meetings, Scaled};
use crate::num::U;
use crate::num::double_double::{DoubleDouble, difference_of_products};
use crate::num::polynomial::{Bracket, Polynomial, Sign, exponent, isolate, refine, times_power_of_two};
use crate::num::real::Real;
use crate::ray::Ray;
use glam::DVec3;

/// Rounding of the quartic's value, in roundoffs of `2(|p|² + a²)²`.
///
/// [`crate::num::polynomial::DOUBT`] covers evaluation and the place of the stationary points (96). The
/// coefficients add: `M`, `D` and `m` err by 12 u relative (9 in the cross products and the quotient, 3
/// in the sum), `|p|²` by as much plus the neglected `2 s m·d ≤ 9 u |p|²`: 21; squared 42, the second
/// term of (2) the like: 42 + 42 + 8 roundings of the sums, and half of it all by the factor 2 in the
/// weight: 46. Together 142.
pub(super) const DOUBT: f64 = 160.0;

pub(super) struct Line<'a> {
    pub torus: &'a Scaled,
    /// Origin and direction, both in exactly scaled units; the direction's largest component is in [1, 2).
    pub o: DVec3,
    pub d: DVec3,
    /// Closest approach, and where it is: `t = s + middle`.
    m: DVec3,
    pub d2: f64,
    pub middle: f64,
    /// `t` of the ray is `2ˢʰⁱᶠᵗ` times `t` of the line.
    shift: i32,
}

/// Rays from beyond this many radii see nothing: their products would overflow.
const FARTHEST: f64 = 1e250;

impl<'a> Line<'a> {
    /// Nothing for a line that clearly passes by the bounding sphere, or crosses it without the slab
    /// |z| ≤ b, or has no direction.
    pub fn new(torus: &'a Scaled, unit: i32, ray: &Ray) -> Option<Self> {
        let size = ray.direction.abs().max_element();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let length = exponent(size);
        let o = scaled(ray.origin, -unit);
        let d = scaled(ray.direction, -length);
        let far = o.x.abs() + o.y.abs() + o.z.abs();
        if !(far < FARTHEST) {
            return None;
        }
        let d2 = d.length_squared();
        // The plain cross product errs by less than 4 u |o| |d|.
        let reach = torus.a + torus.b + 4.0 * U * far;
        if o.cross(d).length_squared() > reach * reach * d2 * (1.0 + 16.0 * U) {
            return None;
        }
        let cross = DVec3::new(
            difference_of_products(o.y, d.z, o.z, d.y),
            difference_of_products(o.z, d.x, o.x, d.z),
            difference_of_products(o.x, d.y, o.y, d.x),
        );
        let m = d.cross(cross) / d2;
        // Where the test above overflowed, this one still tells; a + b < 4 in the torus's unit.
        if m.abs().max_element() > 4.0 {
            return None;
        }
        let line = Line { torus, o, d, m, d2, middle: -o.dot(d) / d2, shift: unit - length };
        (!line.passes_by()).then_some(line)
    }

    /// Does the line stay away from the slab |z| ≤ b within the bounding sphere?
    fn passes_by(&self) -> bool {
        // Rounding is a few u; the bounds are widened by far more.
        const WIDE: f64 = 1.0 + 1e-9;
        let (reach, b) = ((self.torus.a + self.torus.b) * WIDE, self.torus.b + 1e-9 * self.torus.a);
        let half = (reach * reach - self.m.length_squared()).max(0.0) / self.d2;
        // The slab is reached at s = (±b − mz)/dz; the nearest to the closest approach must be in the sphere.
        let lift = self.m.z.abs() - b;
        lift > 0.0 && lift * lift > half * self.d.z * self.d.z
    }

    fn polynomial(&self) -> Polynomial<f64> {
        let (a, gap, d2) = (self.torus.a, self.torus.gap.high, self.d2);
        let flat = self.m.x * self.m.x + self.m.y * self.m.y;
        let m2 = flat + self.m.z * self.m.z;
        let a2 = a * a;
        let linear = 8.0 * a2 * self.m.z * self.d.z;
        let square = 2.0 * d2 * (m2 + gap) - 4.0 * a2 * (self.d.x * self.d.x + self.d.y * self.d.y);
        let sum = m2 + gap;
        let c = [sum * sum - 4.0 * a2 * flat, linear, square, 0.0, d2 * d2];
        let size = m2 + a2;
        let w = [2.0 * size * size, 2.0 * linear.abs(), 4.0 * d2 * size, 0.0, 2.0 * d2 * d2];
        Polynomial { degree: 4, c, w }
    }

    /// The same from the exact input, in double-double; with the place of the closest approach.
    fn exact_polynomial(&self) -> (Polynomial<DoubleDouble>, DoubleDouble) {
        let (o, d) = (self.o, self.d);
        let minor =
            |a: f64, b: f64, c: f64, e: f64| DoubleDouble::product(a, b) - DoubleDouble::product(c, e);
        let cross = [minor(o.y, d.z, o.z, d.y), minor(o.z, d.x, o.x, d.z), minor(o.x, d.y, o.y, d.x)];
        let flat2 = DoubleDouble::product(d.x, d.x) + DoubleDouble::product(d.y, d.y);
        let d2 = flat2 + DoubleDouble::product(d.z, d.z);
        let m = [
            (cross[2].scale(d.y) - cross[1].scale(d.z)) / d2,
            (cross[0].scale(d.z) - cross[2].scale(d.x)) / d2,
            (cross[1].scale(d.x) - cross[0].scale(d.y)) / d2,
        ];
        let flat = m[0].square() + m[1].square();
        let m2 = flat + m[2].square();
        let (a2, sum) = (self.torus.a2, m2 + self.torus.gap);
        let linear = (a2 * m[2].scale(d.z)).shift(8.0);
        let square = (d2 * sum).shift(2.0) - (a2 * flat2).shift(4.0);
        let c = [sum.square() - (a2 * flat).shift(4.0), linear, square, DoubleDouble::of(0.0), d2.square()];
        let along = DoubleDouble::product(o.x, d.x)
            + DoubleDouble::product(o.y, d.y)
            + DoubleDouble::product(o.z, d.z);
        (Polynomial { degree: 4, c, w: self.polynomial().w }, -along / d2)
    }

    /// Half the chord of a sphere that lies clear of the torus: the quartic is surely positive there.
    fn half_chord(&self) -> f64 {
        let reach = self.torus.a + self.torus.b;
        ((reach * reach + self.torus.a * self.torus.a - self.m.length_squared()) / self.d2).max(0.0).sqrt()
    }

    /// Every root, ascending.
    pub fn meetings(&self) -> Meetings {
        let p = self.polynomial();
        let half = self.half_chord();
        let found = isolate(&p, -half, half, DOUBT);
        if !found.certain {
            return self.exact_meetings();
        }
        let root = |b: &Bracket<f64>| self.meeting(self.on_surface(refine(&p, b), b), b.before, b.after);
        found.brackets.iter().map(root).filter(|m| m.t.is_finite()).collect()
    }

    fn exact_meetings(&self) -> Meetings {
        let (p, middle) = self.exact_polynomial();
        let half = DoubleDouble::of(self.half_chord());
        let found = isolate(&p, -half, half, DOUBT);
        let root =
            |b: &Bracket<DoubleDouble>| self.meeting((middle + refine(&p, b)).to_f64(), b.before, b.after);
        found.brackets.iter().map(root).filter(|m| m.t.is_finite()).collect()
    }

    pub fn meeting(&self, t: f64, before: i8, after: i8) -> Meeting {
        Meeting { t: times_power_of_two(t, self.shift), before, after }
    }

    /// The first root with `t_min < t < t_max`.
    pub fn nearest(&self, t_min: f64, t_max: f64) -> Option<f64> {
        let search = self.search();
        if search.is_behind(t_min) || search.is_beyond(t_max) {
            return None;
        }
        match search.first(t_min) {
            First::Miss => return None,
            First::Between(b, minimum) => {
                if let Some(s) = search.quartic.root(&b, minimum, search.slack) {
                    let t = times_power_of_two(self.on_surface(s, &b), self.shift);
                    // A root that rounds to the start belongs to the search by rounded roots.
                    if t > t_min {
                        return (t < t_max).then_some(t);
                    }
                }
            }
            First::Unsure => {}
        }
        self.search_all(&search, t_min, t_max)
    }

    /// Is there a root with `0 < t < t_max`? Where signs decide, no root is computed.
    pub fn blocks(&self, t_max: f64) -> bool {
        let search = self.search();
        if search.is_behind(0.0) || search.is_beyond(t_max) {
            return false;
        }
        match search.first(0.0) {
            First::Miss => false,
            First::Between(b, _) if search.ends_before(b.hi, t_max) => true,
            First::Between(b, _) if search.starts_after(b.lo, t_max) => false,
            _ => self.nearest(0.0, t_max).is_some(),
        }
    }

    fn search(&self) -> Search<'_> {
        let (poly, half) = (self.polynomial(), self.half_chord());
        // The middle errs by 4 u |o|: what ends closer than this to a bound is not decided by it.
        let slack = 8.0 * U * self.o.abs().element_sum() + 8.0 * U;
        Search { quartic: Quartic::new(self, &poly, half), poly, half, slack, line: self }
    }

    /// By brackets around all roots.
    fn search_all(&self, search: &Search, t_min: f64, t_max: f64) -> Option<f64> {
        let inside = |t: &f64| *t > t_min && *t < t_max;
        let found = isolate(&search.poly, -search.half, search.half, DOUBT);
        if !found.certain {
            return self.exact_meetings().iter().map(|m| m.t).find(inside);
        }
        for b in &found.brackets {
            if search.ends_before(b.hi, t_min) {
                continue;
            }
            if search.starts_after(b.lo, t_max) {
                return None;
            }
            let t = times_power_of_two(self.on_surface(refine(&search.poly, b), b), self.shift);
            if inside(&t) && t.is_finite() {
                return Some(t);
            }
        }
        None
    }

    /// The sign of (2) at the ray's point at `t` (of the line), from the exact input; 0 where even double-double
    /// does not tell.
    fn sign_at(&self, t: f64) -> Sign {
        if t == 0.0 {
            let flat = self.o.x * self.o.x + self.o.y * self.o.y;
            let (o2, a) = (flat + self.o.z * self.o.z, self.torus.a);
            let sum = o2 + self.torus.gap.high;
            let (f, size) = (sum * sum - 4.0 * a * a * flat, o2 + a * a);
            // γ₄ in the sum, γ₉ in its square, γ₅ in the second term, one in the difference; both ≤ size².
            if f.abs() > 16.0 * U * size * size {
                return if f > 0.0 { 1 } else { -1 };
            }
        }
        let along = |o: f64, d: f64| DoubleDouble::product(t, d) + DoubleDouble::of(o);
        let p = [along(self.o.x, self.d.x), along(self.o.y, self.d.y), along(self.o.z, self.d.z)];
        let f = self.torus.quartic(p).high;
        let size = p.iter().map(|x| x.high * x.high).sum::<f64>() + self.torus.a * self.torus.a;
        // As above with one rounding more in each coordinate: 16 + 4.
        if f.abs() > 20.0 * DoubleDouble::ROUNDOFF * size * size { if f > 0.0 { 1 } else { -1 } } else { 0 }
    }

    /// Newton's steps from `s` on the distance form, with the surface evaluated in double-double at `o + t
    /// d`: the `t` of the line that belongs to the exact input.
    ///
    /// ```text
    /// h = (ρ − a)² + z² − b²,    h k = equation (2),    k = (ρ + a)² + z² − b²
    /// h′ = 2 ((ρ − a)(x dx + y dy)/ρ + z dz),           ρ − a = (ρ² − a²)/(ρ + a)
    /// ```
    fn on_surface(&self, s: f64, bracket: &Bracket<f64>) -> f64 {
        let Scaled { a, b, a2, .. } = *self.torus;
        let mut t = self.middle + s;
        let slack = 8.0 * U * self.o.abs().element_sum();
        let (lo, hi) = (self.middle + bracket.lo - slack, self.middle + bracket.hi + slack);
        for _ in 0..4 {
            let along = |o: f64, d: f64| DoubleDouble::product(t, d) + DoubleDouble::of(o);
            let p = [along(self.o.x, self.d.x), along(self.o.y, self.d.y), along(self.o.z, self.d.z)];
            let rho2 = p[0].square() + p[1].square();
            let rho = rho2.high.sqrt();
            let (x, y, z) = (p[0].high, p[1].high, p[2].high);
            let off = (rho2 - a2).high / (rho + a);
            let k = (rho + a) * (rho + a) + (z - b) * (z + b);
            let h = self.torus.quartic(p).high / k;
            let slope = 2.0 * (off * (x * self.d.x + y * self.d.y) / rho + z * self.d.z);
            // From inside the tube a step overshoots, and next to the bracket's end it may leave it.
            let next = (t - h / slope).clamp(lo, hi);
            if next.is_nan() {
                break;
            }
            let step = next - t;
            t = next;
            // What Newton's step leaves is step² h″/2h′ with h″ ≤ 2 D.
            if step * step * self.d2 <= 0.5 * U * (t * slope).abs() {
                break;
            }
        }
        t
    }

    /// Size of the terms of (2) at `s`: `|p|² + a²`, of which the bound on the rounding takes twice the square.
    pub fn size(&self, s: f64) -> f64 {
        self.m.length_squared() + self.d2 * s * s + self.torus.a * self.torus.a
    }

    /// Where the polynomial's coefficients stand, for methods that solve it by themselves.
    pub fn monic(&self) -> [f64; 3] {
        let p = self.polynomial();
        [p.c[2] / p.c[4], p.c[1] / p.c[4], p.c[0] / p.c[4]]
    }

    /// Signed distance [the torus's unit] from the point at `s` to the surface.
    pub fn distance(&self, s: f64) -> f64 {
        let p = self.m + self.d * s;
        let rho = p.x.hypot(p.y);
        (rho - self.torus.a).hypot(p.z) - self.torus.b
    }

    /// Half the chord within the bounding sphere.
    pub fn reach(&self) -> f64 {
        let reach = self.torus.a + self.torus.b;
        ((reach * reach - self.m.length_squared()) / self.d2).max(0.0).sqrt()
    }
}

/// A search along a line: all that does not depend on where it begins.
struct Search<'a> {
    quartic: Quartic<'a>,
    poly: Polynomial<f64>,
    half: f64,
    slack: f64,
    line: &'a Line<'a>,
}

impl Search<'_> {
    /// What the signs say about the first root beyond `t_min` of the ray.
    fn first(&self, t_min: f64) -> First {
        if self.starts_after(-self.half, t_min) {
            return self.quartic.first(Start { s: -self.half, sign: 1 });
        }
        // From a far origin the start is known too badly to be set against stationary points: a displacement δ
        // changes values there by δ² size, which must stay below their DOUBT.
        if self.slack > 1e-9 * self.half {
            return First::Unsure;
        }
        let t = times_power_of_two(t_min, -self.line.shift);
        match self.line.sign_at(t) {
            0 => First::Unsure,
            sign => self.quartic.first(Start { s: t - self.line.middle, sign }),
        }
    }

    /// Parameter of the ray at the end of `s` plus so many slacks.
    fn ray_t(&self, s: f64, slacks: f64) -> f64 {
        times_power_of_two(self.line.middle + s + slacks * self.slack, self.line.shift)
    }

    fn ends_before(&self, s: f64, t: f64) -> bool {
        self.ray_t(s, 1.0) < t
    }

    fn starts_after(&self, s: f64, t: f64) -> bool {
        self.ray_t(s, -1.0) > t
    }

    /// Is all of the torus before `t_min`?
    fn is_behind(&self, t_min: f64) -> bool {
        self.ends_before(self.half, t_min)
    }

    /// Is all of the torus beyond `t_max`?
    fn is_beyond(&self, t_max: f64) -> bool {
        self.starts_after(-self.half, t_max)
    }
}

/// The ray's point at `t`, in the torus's unit; the direction is brought near 1 first, so that `t d`
/// does not overflow.
pub(super) fn point(unit: i32, ray: &Ray, t: f64) -> DVec3 {
    let length = exponent(ray.direction.abs().max_element());
    scaled(ray.origin, -unit) + scaled(ray.direction, -length) * times_power_of_two(t, length - unit)
}

/// Times a power of two.
pub(super) fn scaled(v: DVec3, n: i32) -> DVec3 {
    DVec3::new(times_power_of_two(v.x, n), times_power_of_two(v.y, n), times_power_of_two(v.z, n))
}
