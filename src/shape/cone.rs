//! The cone or frustum between two points [E problem 5.3, A §2.3.1], solid or an open shell.
//!
//! With `a = p₁ − p₀`, `w = p − p₀` and the height `S = w · a`, which runs from 0 to `a²`, the radius is
//! `ρ = r₀ + κ S`, `κ = (r₁ − r₀)/a²`, and the side is where
//!
//! ```text
//! |w × a|² = a² ρ²                                                          (1)
//! ```
//!
//! A line meets the infinite double cone (1) in a quadratic equation and the slab between the ends
//! in two planes; what is inside both is one stretch. The origin is moved along the ray to its closest
//! approach to the middle of the body, and the whole is computed with error bounds, again in 106
//! bits where these do not decide ([`crate::num::certified`]).

use super::disc::round_bounds;
use super::{Shape, ShapeError, Solid, basis, first_between, turn};
use crate::bounds::Aabb;
use crate::num::certified::{
    Bounded, Roots, Scalar, Uncertain, Vector, no_root_ahead, power_of_two_below, solve_quadratic,
};
use crate::num::double_double::DoubleDouble;
use crate::num::{U, gamma};
use crate::ray::{Crossing, Hit, Ray, Span};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The side.
const SIDE: u32 = 0;
/// The cap at `p0`, and the cap at `p1`.
const CAPS: [u32; 2] = [1, 2];

/// What closes a cylinder or cone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Ends {
    #[default]
    Capped,
    /// A tube: only the side is met. Its spans remain those of the capped body.
    Open,
}

/// A cone around the segment from `p0` to `p1`, of radius `r0` at `p0` and `r1` at `p1`; one of them may be 0.
///
/// Faces: 0 the side, 1 the cap at `p0`, 2 the cap at `p1`. Texture coordinates: on the side `u` the
/// angle as a share of the turn, `v` the height as a share of the axis; on the caps `u` the angle,
/// `v` the distance from the axis over the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    p0: DVec3,
    p1: DVec3,
    radii: [f64; 2],
    ends: Ends,
    /// Power of two near the body's size: the lengths below are counted in it.
    unit: f64,
    quick: Body<Bounded>,
    slow: Body<DoubleDouble>,
    /// Along the axis; its length in the scene.
    axis: DVec3,
    height: f64,
    x: DVec3,
    y: DVec3,
}

/// The body in one arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Body<T> {
    p0: DVec3,
    axis: Vector<T>,
    axis2: T,
    r0: T,
    /// `κ`.
    slope: T,
    /// Where the ray's closest approach is taken to: the apex, else the middle of the axis.
    focus: DVec3,
}

/// One end of the stretch.
#[derive(Clone, Copy, Debug)]
struct End<T> {
    t: T,
    face: u32,
}

/// A stretch of the line; `None` is infinitely far.
type Stretch<T> = (Option<End<T>>, Option<End<T>>);

/// The line about its closest approach: heights `s0 + s1 τ`, and (1) as `a τ² + 2 b τ + c`.
struct Line<T> {
    t: T,
    s0: T,
    s1: T,
    rho1: T,
    abc: [T; 3],
}

impl<T: Scalar> Body<T> {
    fn new(p0: DVec3, p1: DVec3, radii: [f64; 2]) -> Self {
        let axis = Vector::difference(p1, p0);
        let axis2 = axis.dot(axis);
        let slope = T::difference(radii[1], radii[0]) / axis2;
        let focus = match radii {
            [0.0, _] => p0,
            [_, 0.0] => p1,
            _ => p0 + (p1 - p0) * 0.5,
        };
        Body { p0, axis, axis2, r0: T::of(radii[0]), slope, focus }
    }

    /// The line of `o + t d`, expanded near its closest approach to the focus.
    fn line(&self, o: DVec3, d: DVec3) -> Line<T> {
        let t = (self.focus - o).dot(d) / d.dot(d);
        let w = Vector::difference(o, self.p0) + Vector::along(d, t);
        let d = Vector::of(d);
        let (s0, s1) = (w.dot(self.axis), d.dot(self.axis));
        let (rho0, rho1) = (self.r0 + self.slope * s0, self.slope * s1);
        let (c0, c1) = (w.cross(self.axis), d.cross(self.axis));
        let (g0, g1) = (self.axis2 * rho0, self.axis2 * rho1);
        let abc = [c1.dot(c1) - g1 * rho1, c0.dot(c1) - g1 * rho0, c0.dot(c0) - g0 * rho0];
        Line { t: T::of(t), s0, s1, rho1, abc }
    }

    /// The stretch between the planes of the ends.
    fn slab(&self, line: &Line<T>) -> Result<Option<Stretch<T>>, Uncertain> {
        let way = line.s1.sign()?;
        if way == 0 {
            let inside = line.s0.sign()? > 0 && line.s0.is_below(self.axis2)?;
            return Ok(inside.then_some((None, None)));
        }
        let first = End { t: -line.s0 / line.s1, face: CAPS[0] };
        let last = End { t: (self.axis2 - line.s0) / line.s1, face: CAPS[1] };
        Ok(Some(if way > 0 { (Some(first), Some(last)) } else { (Some(last), Some(first)) }))
    }

    /// The stretch inside the side, on the nappe of positive radius.
    fn side(&self, line: &Line<T>) -> Result<Option<Stretch<T>>, Uncertain> {
        let [a, b, c] = line.abc;
        let end = |t| Some(End { t, face: SIDE });
        let roots = solve_quadratic(a, b, c)?;
        Ok(match (a.sign()?, roots) {
            (1, Roots::Two(t0, t1)) => Some((end(t0), end(t1))),
            (1, Roots::One(t)) => Some((end(t), end(t))),
            // Steeper than the side: inside both nappes, of which the one with growing ρ lies ahead.
            (-1, Roots::Two(t0, t1)) => {
                Some(if line.rho1.sign()? > 0 { (end(t1), None) } else { (None, end(t0)) })
            }
            // Such a line leaves one nappe for the other, so that there are roots; next to the apex rounding may
            // find none.
            (-1, Roots::None) => {
                let t = -(b / a);
                Some(if line.rho1.sign()? > 0 { (end(t), None) } else { (None, end(t)) })
            }
            (-1, Roots::One(t)) => Some(if line.rho1.sign()? > 0 { (end(t), None) } else { (None, end(t)) }),
            // As steep as the side.
            (0, Roots::One(t)) => Some(if b.sign()? > 0 { (None, end(t)) } else { (end(t), None) }),
            (0, _) if c.sign()? < 0 => Some((None, None)),
            _ => None,
        })
    }

    /// The ends of the stretch inside the body: two, or one for a touch.
    fn clip(&self, o: DVec3, d: DVec3) -> Result<ArrayVec<Crossing, 2>, Uncertain> {
        let line = self.line(o, d);
        // The side first: most lines that miss, miss it.
        let Some((side_in, side_out)) = self.side(&line)? else { return Ok(ArrayVec::new()) };
        let Some((slab_in, slab_out)) = self.slab(&line)? else { return Ok(ArrayVec::new()) };
        let enter = match (side_in, slab_in) {
            (Some(a), Some(b)) => Some(if a.t.is_below(b.t)? { b } else { a }),
            (a, b) => a.or(b),
        };
        let leave = match (side_out, slab_out) {
            (Some(a), Some(b)) => Some(if b.t.is_below(a.t)? { b } else { a }),
            (a, b) => a.or(b),
        };
        // Both are there: without the planes the line is square to the axis, and the side closes it.
        let (Some(enter), Some(leave)) = (enter, leave) else { return Ok(ArrayVec::new()) };
        let length = (leave.t - enter.t).sign()?;
        let ends = [enter, leave].into_iter().take((length + 1) as usize);
        ends.map(|e| Ok(Crossing::new((line.t + e.t).settled()?, e.face))).collect()
    }

    /// Crossings with the side alone.
    fn tube(&self, o: DVec3, d: DVec3) -> Result<ArrayVec<Crossing, 2>, Uncertain> {
        let line = self.line(o, d);
        let [a, b, c] = line.abc;
        let roots = match solve_quadratic(a, b, c)? {
            Roots::None => ArrayVec::new(),
            Roots::One(t) => ArrayVec::from_iter([t]),
            Roots::Two(t0, t1) => ArrayVec::from([t0, t1]),
        };
        let mut found = ArrayVec::new();
        for t in roots {
            let height = line.s0 + line.s1 * t;
            if height.sign()? >= 0 && !self.axis2.is_below(height)? {
                found.push(Crossing::new((line.t + t).settled()?, SIDE));
            }
        }
        Ok(found)
    }

    /// The height `S` at a point, and `|w × a|² − a² ρ²`: negative inside the double cone (1).
    #[inline]
    fn at(&self, p: DVec3) -> (T, T) {
        let w = Vector::difference(p, self.p0);
        let s = w.dot(self.axis);
        let (c, rho) = (w.cross(self.axis), self.r0 + self.slope * s);
        (s, c.dot(c) - self.axis2 * rho * rho)
    }

    fn contains(&self, p: DVec3) -> Result<bool, Uncertain> {
        let (s, side) = self.at(p);
        Ok(s.sign()? >= 0 && !self.axis2.is_below(s)? && side.sign()? <= 0)
    }
}

impl Cone {
    /// The capped cone around the segment from `p0` to `p1`; not both radii are 0.
    pub fn new(p0: DVec3, p1: DVec3, r0: f64, r1: f64) -> Result<Self, ShapeError> {
        for p in [p0, p1] {
            ShapeError::finite("end of an axis", p)?;
        }
        ShapeError::positive("larger radius of a cone", r0.max(r1))?;
        if r0 < 0.0 || r1 < 0.0 {
            return Err(ShapeError::Negative { what: "radius of a cone", found: r0.min(r1) });
        }
        let axis = ShapeError::direction("axis of a cylinder or cone", p1 - p0)?;
        let unit = power_of_two_below((p1 - p0).abs().max_element().max(r0).max(r1));
        let (q0, q1, radii) = (p0 / unit, p1 / unit, [r0 / unit, r1 / unit]);
        let (x, y) = basis(axis);
        Ok(Cone {
            p0,
            p1,
            radii: [r0, r1],
            ends: Ends::Capped,
            unit,
            quick: Body::new(q0, q1, radii),
            slow: Body::new(q0, q1, radii),
            axis,
            height: ((p1 - p0) / unit).length() * unit,
            x,
            y,
        })
    }

    pub fn with_ends(self, ends: Ends) -> Self {
        Cone { ends, ..self }
    }

    pub fn p0(&self) -> DVec3 {
        self.p0
    }

    pub fn p1(&self) -> DVec3 {
        self.p1
    }

    /// The unit vector from `p0` to `p1`.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Distance from `p0` to `p1`.
    pub fn height(&self) -> f64 {
        self.height
    }

    pub fn r0(&self) -> f64 {
        self.radii[0]
    }

    pub fn r1(&self) -> f64 {
        self.radii[1]
    }

    /// The stretch of the ray's whole line inside the capped body; of length 0 for a touch.
    ///
    /// - Accuracy: ends within `64 u |t|`.
    pub fn span(&self, ray: &Ray) -> Option<Span> {
        let ends = self.ends_of(ray);
        Some(Span { enter: *ends.first()?, leave: *ends.last()? })
    }

    /// Does the ray certainly not meet the body at any `t > 0`: because it stays outside the double cone (1), or sets out
    /// before or behind both ends and comes no closer?
    ///
    /// In plain `f64`, with errors relative to the sums of absolute terms that `W = |w|₁`, `D = |d|₁`, `L = |a|₁`
    /// and `R = r₀ + |κ| L W` or `|κ| L D` bound. Behind a height stand 5 roundings (2 in `w` and `a`, 3 in the
    /// product), behind `ρ` 14 (7 of `κ`, the height, 2), behind a cross product 4, behind (1) at most
    /// 2·14 + 5 (of `a²`) + 3 (its products and difference): 36 u, and one for the sizes' own.
    fn is_behind_or_beside(&self, ray: &Ray) -> bool {
        let (o, d, _) = self.scaled(ray);
        let Body { p0, axis, axis2, r0, slope, .. } = &self.quick;
        let (axis, axis2, r0, slope) = (axis.value(), axis2.value(), r0.value(), slope.value());
        let w = o - *p0;
        let (s0, s1) = (w.dot(axis), d.dot(axis));
        let [wide, fast, long] = [w, d, axis].map(|v| v.abs().element_sum());
        let height = |s: f64, size: f64| Bounded::within(s, gamma(6) * size * long).sign();
        let exactly = |s: DoubleDouble| s.sign().unwrap_or(0);
        let past_an_end = match height(s1, fast) {
            Ok(-1) => height(s0, wide).unwrap_or_else(|Uncertain| exactly(self.slow.at(o).0)) <= 0,
            Ok(1) => {
                let above = || exactly(self.slow.at(o).0 - self.slow.axis2);
                height(s0 - axis2, wide + long).unwrap_or_else(|Uncertain| above()) >= 0
            }
            _ => false,
        };
        if past_an_end {
            return true;
        }
        let (rho0, rho1) = (r0 + slope * s0, slope * s1);
        let (c0, c1) = (w.cross(axis), d.cross(axis));
        let (reach0, reach1) = (r0 + slope.abs() * long * wide, slope.abs() * long * fast);
        let area = long * long;
        let bounded = |value: f64, size: f64| Bounded::within(value, gamma(37) * area * size);
        let abc = [
            bounded(c1.dot(c1) - axis2 * rho1 * rho1, fast * fast + reach1 * reach1),
            bounded(c0.dot(c1) - axis2 * rho0 * rho1, wide * fast + reach0 * reach1),
            bounded(c0.dot(c0) - axis2 * rho0 * rho0, wide * wide + reach0 * reach0),
        ];
        // Inside both nappes all the way (`a < 0`) a ray may still meet the caps.
        abc[0].sign() == Ok(1) && no_root_ahead(abc, || exactly(self.slow.at(o).1))
    }

    fn ends_of(&self, ray: &Ray) -> ArrayVec<Crossing, 2> {
        let (o, d, stretch) = self.scaled(ray);
        let found = self.quick.clip(o, d).or_else(|Uncertain| self.slow.clip(o, d)).unwrap_or_default();
        stretched(found, stretch)
    }

    /// Origin and direction in the body's unit, and what `t` is then to be multiplied by.
    fn scaled(&self, ray: &Ray) -> (DVec3, DVec3, f64) {
        let length = power_of_two_below(ray.direction.abs().max_element());
        (ray.origin / self.unit, ray.direction / length, self.unit / length)
    }

    /// All crossings on the line, ascending.
    fn all(&self, ray: &Ray) -> ArrayVec<Crossing, 2> {
        match self.ends {
            Ends::Capped => self.ends_of(ray),
            Ends::Open => {
                let (o, d, stretch) = self.scaled(ray);
                let found =
                    self.quick.tube(o, d).or_else(|Uncertain| self.slow.tube(o, d)).unwrap_or_default();
                stretched(found, stretch)
            }
        }
    }

    /// Bound on the distance between a point put at a height and radius in `f64`, and the surface.
    ///
    /// Unit axis and radial vector err by 4 u in each coordinate, their multiples round once more, the
    /// radial vector is square to the axis to within 4 u of `|w|`, and the sum rounds twice; a shift
    /// along the axis counts by the slope, which is at most `max(r)/height`.
    fn rounding(&self, reach: f64, point: DVec3) -> f64 {
        let widest = self.radii[0].max(self.radii[1]);
        gamma(16) * (reach + widest) * (1.0 + widest / self.height) + 2.0 * U * point.abs().max_element()
    }
}

/// In the scene's lengths; nothing if that overflows.
fn stretched(mut found: ArrayVec<Crossing, 2>, stretch: f64) -> ArrayVec<Crossing, 2> {
    for c in &mut found {
        c.t *= stretch;
    }
    if found.iter().all(|c| c.t.is_finite()) { found } else { ArrayVec::new() }
}

impl Shape for Cone {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        if t_min >= 0.0 && self.is_behind_or_beside(ray) {
            return None;
        }
        first_between(self.all(ray), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.all(ray).into_iter().filter(|c| c.t > 0.0));
    }

    /// The point is put back onto the side at its height, or onto the cap's plane and inside its rim.
    ///
    /// At the apex, where the side has no normal, it is the one at angle 0.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let w = (ray.origin - self.p0) + ray.direction * crossing.t;
        let (flat, s) = (DVec2::new(w.dot(self.x), w.dot(self.y)), w.dot(self.axis));
        let distance = flat.length();
        let out = if distance > 0.0 { flat / distance } else { DVec2::X };
        let radial = self.x * out.x + self.y * out.y;
        let around = self.y * out.x - self.x * out.y;
        let [r0, r1] = self.radii;
        let u = turn(out.x, out.y);
        let (point, normal, v) = if crossing.face == SIDE {
            let v = (s / self.height).clamp(0.0, 1.0);
            let point = self.p0 + self.axis * (v * self.height) + radial * (r0 + (r1 - r0) * v);
            (point, side_normal(radial, self.axis, self.height, r1 - r0), v)
        } else {
            let (center, radius, normal) =
                if crossing.face == CAPS[0] { (self.p0, r0, -self.axis) } else { (self.p1, r1, self.axis) };
            let v = if radius > 0.0 { (distance / radius).min(1.0) } else { 0.0 };
            (center + radial * (v * radius), normal, v)
        };
        Hit {
            t: crossing.t,
            point,
            point_error: self.rounding((point - self.p0).length(), point),
            ng: normal,
            n: normal,
            tangent: around,
            uv: DVec2::new(u, v),
            face: crossing.face,
            part: crossing.part,
        }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let (sin, cos) = (uv.x * TAU).sin_cos();
        let radial = self.x * cos + self.y * sin;
        let [r0, r1] = self.radii;
        match face {
            1 => self.p0 + radial * (uv.y * r0),
            2 => self.p1 + radial * (uv.y * r1),
            _ => self.p0 + self.axis * (uv.y * self.height) + radial * (r0 + (r1 - r0) * uv.y),
        }
    }

    fn bounds(&self) -> Aabb {
        let rim = |p, r| if r > 0.0 { round_bounds(p, self.axis, r) } else { Aabb::of_points([p]) };
        rim(self.p0, self.radii[0]).union(&rim(self.p1, self.radii[1]))
    }
}

/// `radial − (Δr/h) axis`, as a unit vector.
fn side_normal(radial: DVec3, axis: DVec3, height: f64, growth: f64) -> DVec3 {
    let length = height.hypot(growth);
    radial * (height / length) - axis * (growth / length)
}

impl Solid for Cone {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        out.extend(self.span(ray).filter(|s| s.enter.t < s.leave.t));
    }

    fn contains(&self, p: DVec3) -> bool {
        let p = p / self.unit;
        self.quick.contains(p).or_else(|Uncertain| self.slow.contains(p)).unwrap_or(false)
    }
}

/// Where the ray crosses side and caps, by the plain quadratic of (1) at the ray's origin.
///
/// - Domain: faces as of [`Cone`].
/// - Accuracy: loses all digits at distance/radius 10⁸.
/// - Source: [E problem 5.3], from the scalar field `x² + y² − (1 − z)²` and its height.
pub fn textbook(p0: DVec3, p1: DVec3, r0: f64, r1: f64, ray: &Ray) -> Vec<Crossing> {
    let height = (p1 - p0).length();
    let axis = (p1 - p0) / height;
    let slope = (r1 - r0) / height;
    let w = ray.origin - p0;
    let (s0, s1) = (w.dot(axis), ray.direction.dot(axis));
    let (across, from) = (ray.direction - axis * s1, w - axis * s0);
    let (rho0, rho1) = (r0 + slope * s0, slope * s1);
    let a = across.dot(across) - rho1 * rho1;
    let b = across.dot(from) - rho0 * rho1;
    let c = from.dot(from) - rho0 * rho0;
    let root = (b * b - a * c).sqrt();
    let side = if a == 0.0 { [-c / (2.0 * b), f64::NAN] } else { [(-b - root) / a, (-b + root) / a] };
    let mut found = Vec::new();
    for t in side {
        if t > 0.0 && (0.0..=height).contains(&(s0 + s1 * t)) {
            found.push(Crossing::new(t, SIDE));
        }
    }
    for (t, radius, face) in [(-s0 / s1, r0, CAPS[0]), ((height - s0) / s1, r1, CAPS[1])] {
        if t > 0.0 && (from + across * t).length_squared() < radius * radius {
            found.push(Crossing::new(t, face));
        }
    }
    found.sort_by(|a, b| a.t.total_cmp(&b.t));
    found
}
