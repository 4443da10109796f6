//! The torus: a circle of radius `b` (the tube) swept around a circle of radius `a` (the ring), about
//! the z axis.
//!
//! ```text
//! (ρ − a)² + z² = b²,    ρ = √(x² + y²)                              (1) distance form
//! (x² + y² + z² + a² − b²)² = 4 a² (x² + y²)                          (2) quartic form [A §2.3.2]
//! ```
//!
//! A line meets it in up to four points, the roots of a quartic. Expanded at the ray's origin, as
//! printed in [A §5.4.4], the coefficients grow with the fourth power of the distance and bury the torus under
//! rounding errors. [`TorusMethod`] lists ways out; [`TorusMethod::Adaptive`] is the one that the
//! numbers choose.

mod contestants;
mod first;
mod line;

use super::{Shape, ShapeError, Solid};
use crate::bounds::Aabb;
use crate::num::double_double::DoubleDouble;
use crate::num::polynomial::{Sign, exponent, times_power_of_two};
use crate::num::{gamma, quartic};
use crate::ray::{Crossing, Hit, Ray, Span};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};
use line::Line;
use std::f64::consts::TAU;

/// How a torus finds the roots of its quartic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TorusMethod {
    /// Moved to the closest approach; brackets with certified signs, else double-double; polished on the
    /// surface.
    #[default]
    Adaptive,
    /// The quartic expanded at the ray's origin, solved by the historical solver, as the document prints it.
    AsPrinted,
    /// The historical solver after moving the origin to the closest approach and scaling to order 1.
    Recentred,
    /// Moved and scaled; Ferrari's factors with Newton steps.
    Ferrari,
    /// Moved and scaled; Newton and bisection between stationary points.
    Bracketed,
    /// Moved and scaled; Algorithm 1010.
    Algorithm1010,
    /// Moved and scaled; Sturm's chain and bisection.
    Sturm,
    /// Steps of the exact distance to the surface.
    Marching,
}

impl TorusMethod {
    /// All methods, the default first.
    pub const ALL: [TorusMethod; 8] = [
        TorusMethod::Adaptive,
        TorusMethod::AsPrinted,
        TorusMethod::Recentred,
        TorusMethod::Ferrari,
        TorusMethod::Bracketed,
        TorusMethod::Algorithm1010,
        TorusMethod::Sturm,
        TorusMethod::Marching,
    ];

    /// The name that the command line uses.
    pub fn name(self) -> &'static str {
        match self {
            TorusMethod::Adaptive => "adaptive",
            TorusMethod::AsPrinted => "as_printed",
            TorusMethod::Recentred => "recentred",
            TorusMethod::Ferrari => "ferrari",
            TorusMethod::Bracketed => "bracketed",
            TorusMethod::Algorithm1010 => "algorithm_1010",
            TorusMethod::Sturm => "sturm",
            TorusMethod::Marching => "marching",
        }
    }

    /// The solver of the moved quartic, for the methods that are one.
    fn solver(self) -> Option<quartic::Solver> {
        match self {
            TorusMethod::Recentred => Some(quartic::graphics_gems_as_printed),
            TorusMethod::Ferrari => Some(quartic::ferrari),
            TorusMethod::Bracketed => Some(quartic::bracketed),
            TorusMethod::Algorithm1010 => Some(quartic::algorithm_1010),
            TorusMethod::Sturm => Some(quartic::sturm),
            TorusMethod::Adaptive | TorusMethod::AsPrinted | TorusMethod::Marching => None,
        }
    }
}

/// A ring torus around the z axis, centred at the origin.
#[derive(Clone, Copy, Debug)]
pub struct Torus {
    ring: f64,
    tube: f64,
    method: TorusMethod,
    /// Lengths are divided by `2ᵘⁿⁱᵗ`, after which `1 ≤ a < 2`.
    unit: i32,
    scaled: Scaled,
}

/// The torus in its own unit of length.
#[derive(Clone, Copy, Debug)]
struct Scaled {
    a: f64,
    b: f64,
    /// `a²` and `a² − b²`, to 106 bits.
    a2: DoubleDouble,
    gap: DoubleDouble,
}

/// A root of the torus on a line: where, and the sign outside (+) or inside (−) before and after it.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    t: f64,
    before: Sign,
    after: Sign,
}

type Meetings = ArrayVec<Meeting, 4>;

impl Torus {
    /// A torus with ring radius `ring` (`a`) and tube radius `tube` (`b`).
    ///
    /// - Domain: `a > b > 0`, `a + b` finite; else [`ShapeError::NotARing`]: without a hole the surface would meet itself.
    pub fn new(ring: f64, tube: f64) -> Result<Self, ShapeError> {
        if !(ring > tube && tube > 0.0 && (ring + tube).is_finite()) {
            return Err(ShapeError::NotARing { ring, tube });
        }
        let unit = exponent(ring);
        let (a, b) = (times_power_of_two(ring, -unit), times_power_of_two(tube, -unit));
        let gap = DoubleDouble::sum(a, -b) * DoubleDouble::sum(a, b);
        let scaled = Scaled { a, b, a2: DoubleDouble::product(a, a), gap };
        Ok(Torus { ring, tube, method: TorusMethod::Adaptive, unit, scaled })
    }

    /// The same torus, intersected by another method.
    pub fn with_method(self, method: TorusMethod) -> Self {
        Torus { method, ..self }
    }

    /// Radius of the ring.
    pub fn ring(&self) -> f64 {
        self.ring
    }

    /// Radius of the tube.
    pub fn tube(&self) -> f64 {
        self.tube
    }

    /// Every root on the whole line, ascending.
    fn meetings(&self, ray: &Ray) -> Meetings {
        match self.method {
            TorusMethod::Adaptive => self.line(ray).map(|l| l.meetings()).unwrap_or_default(),
            TorusMethod::AsPrinted => contestants::as_printed(self, ray),
            TorusMethod::Marching => self.line(ray).map(|l| contestants::marching(&l)).unwrap_or_default(),
            _ => {
                let solver = self.method.solver().unwrap_or(quartic::adaptive);
                self.line(ray).map(|l| contestants::recentred(&l, solver)).unwrap_or_default()
            }
        }
    }

    /// The ray's line in the torus's unit, unless it clearly passes by.
    fn line(&self, ray: &Ray) -> Option<Line<'_>> {
        Line::new(&self.scaled, self.unit, ray)
    }

    /// Directions at the surface point nearest to the ray's point at `t`.
    fn frame(&self, ray: &Ray, t: f64) -> Frame {
        let p = line::point(self.unit, ray, t);
        let rho = (p.x * p.x + p.y * p.y).sqrt(); // of order 1 in this unit
        let around = if rho > 0.0 { DVec2::new(p.x, p.y) / rho } else { DVec2::X };
        let out = DVec2::new(rho - self.scaled.a, p.z);
        let length = out.length();
        let out = if length > 0.0 { out / length } else { DVec2::X };
        Frame { around, out }
    }
}

/// Directions at a point of the torus.
struct Frame {
    /// From the axis, in the plane of the ring (x, y).
    around: DVec2,
    /// From the tube's centre, in the half plane of the axis (ρ, z).
    out: DVec2,
}

/// The turn of a direction, in `[0, 1)`.
fn turn(v: DVec2) -> f64 {
    let turn = v.y.atan2(v.x) / TAU;
    // −tiny + 1 rounds to 1, which is 0.
    let turn = if turn < 0.0 { turn + 1.0 } else { turn };
    if turn < 1.0 { turn } else { 0.0 }
}

impl Shape for Torus {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let t = match self.method {
            TorusMethod::Adaptive => self.line(ray)?.nearest(t_min, t_max)?,
            _ => {
                let accepted = |t: &f64| *t > t_min.max(contestants::least_t(self.method)) && *t < t_max;
                self.meetings(ray).iter().map(|m| m.t).find(accepted)?
            }
        };
        Some(Crossing::new(t, 0))
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        match self.method {
            TorusMethod::Adaptive => self.line(ray).is_some_and(|l| l.blocks(t_max)),
            _ => self.nearest(ray, 0.0, t_max).is_some(),
        }
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        let least = contestants::least_t(self.method);
        out.extend(self.meetings(ray).iter().filter(|m| m.t > least).map(|m| Crossing::new(m.t, 0)));
    }

    /// The point is put back on the surface: along the ray, rounding grows with the distance; here it does not.
    ///
    /// - Accuracy: `point_error` = γ₁₂ (a + b): six roundings in the unit vector around the axis (its
    ///   length errs by 3), as many in the one around the tube, of which a length error of 3 u moves the
    ///   point by 3 u b; three more in `a + b·out` and its product.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let Frame { around, out } = self.frame(ray, crossing.t);
        let reach = self.ring + self.tube * out.x;
        let n = DVec3::new(around.x * out.x, around.y * out.x, out.y);
        Hit {
            t: crossing.t,
            point: DVec3::new(around.x * reach, around.y * reach, self.tube * out.y),
            point_error: gamma(12) * (self.ring + self.tube),
            ng: n,
            n,
            tangent: DVec3::new(-around.y, around.x, 0.0),
            uv: DVec2::new(turn(around), turn(out)),
            face: crossing.face,
            part: crossing.part,
        }
    }

    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        let (around, out) = (DVec2::from_angle(TAU * uv.x), DVec2::from_angle(TAU * uv.y));
        let reach = self.ring + self.tube * out.x;
        DVec3::new(around.x * reach, around.y * reach, self.tube * out.y)
    }

    fn bounds(&self) -> Aabb {
        let r = (self.ring + self.tube).next_up();
        Aabb::new(DVec3::new(-r, -r, -self.tube), DVec3::new(r, r, self.tube))
    }
}

impl Solid for Torus {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        let mut enter = None;
        for m in self.meetings(ray) {
            if m.before > 0 && m.after < 0 {
                enter = Some(Crossing::new(m.t, 0));
            } else if m.before < 0
                && m.after > 0
                && let Some(enter) = enter.take()
            {
                out.push(Span { enter, leave: Crossing::new(m.t, 0) });
            }
        }
    }

    /// - Accuracy: decided in double-double: wrong only closer to the surface than `2⁻⁹⁵ a²/b`.
    fn contains(&self, p: DVec3) -> bool {
        let p = line::scaled(p, -self.unit);
        let reach = 4.0; // a + b < 4 in the torus's unit
        p.abs().cmple(DVec3::splat(reach)).all()
            && self.scaled.quartic(p.to_array().map(DoubleDouble::of)).high <= 0.0
    }
}

impl Scaled {
    /// Equation (2) at a point: positive outside, negative inside.
    fn quartic(&self, [x, y, z]: [DoubleDouble; 3]) -> DoubleDouble {
        let rho2 = x.square() + y.square();
        let sum = rho2 + z.square() + self.gap;
        sum.square() - (self.a2 * rho2).shift(4.0)
    }
}
