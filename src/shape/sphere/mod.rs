//! The sphere [A §2.3, B §6.2, C §1.6, D §4.7.1].

pub mod as_printed;
pub mod method;
pub mod reference;

use super::fan::{Fan, LANES, Lanes, vectorised};
use super::{Shape, ShapeError, Solid, span_of_pair};
use crate::bounds::Aabb;
use crate::frame::Frame;
use crate::num::gamma;
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// All points at `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    center: DVec3,
    radius: f64,
}

/// Squares stay far from overflow and underflow while magnitudes lie between these.
const COMFORTABLE: std::ops::Range<f64> = 1.0e-70..1.0e70; // (1e70)⁴ < f64::MAX

impl Sphere {
    /// - Errors: a radius that is not positive and finite, a centre that is not finite.
    pub fn new(center: DVec3, radius: f64) -> Result<Self, ShapeError> {
        let (center, radius) =
            (ShapeError::finite("centre", center)?, ShapeError::positive("radius", radius)?);
        Ok(Sphere { center, radius })
    }

    pub fn center(&self) -> DVec3 {
        self.center
    }

    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Both meetings of the whole line with the sphere, ascending, by [`method::robust`].
    #[inline]
    pub fn roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        let f = ray.origin - self.center;
        let d = ray.direction;
        let size = f.abs().max_element().max(self.radius);
        let speed = d.abs().max_element();
        if COMFORTABLE.contains(&size) && COMFORTABLE.contains(&speed) {
            return method::robust(f.to_array(), d.to_array(), self.radius);
        }
        self.roots_rescaled(f, d, size, speed)
    }

    /// The same in units of the largest length, for magnitudes whose squares would overflow.
    #[cold]
    fn roots_rescaled(&self, f: DVec3, d: DVec3, size: f64, speed: f64) -> Option<(f64, f64)> {
        if speed == 0.0 || !(size.is_finite() && speed.is_finite()) {
            return None;
        }
        let (t0, t1) = method::robust((f / size).to_array(), (d / speed).to_array(), self.radius / size)?;
        let back = |t: f64| t * size / speed;
        let (t0, t1) = (back(t0), back(t1));
        (!t0.is_nan() && !t1.is_nan()).then_some((t0, t1))
    }
}

impl Shape for Sphere {
    fn is_costly(&self) -> bool {
        false
    }

    #[inline]
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let (t0, t1) = self.roots(ray)?;
        let t = if t0 > t_min { t0 } else { t1 };
        (t > t_min && t < t_max).then(|| Crossing::new(t, 0))
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        if let Some((t0, t1)) = self.roots(ray) {
            out.extend([t0].iter().filter(|t| **t > 0.0).map(|t| Crossing::new(*t, 0)));
            out.extend([t1].iter().filter(|t| **t > 0.0 && **t > t0).map(|t| Crossing::new(*t, 0)));
        }
    }

    /// The point is put back on the sphere along the radius.
    ///
    /// Its error: the unit radius is off by ≤ 4 u, times `r` and added to `c` with one rounding each; and
    /// the ray that leaves subtracts `c` again and compares squares, 4 roundings. In all ≤ 12 u (r + |c|).
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let radial = (ray.origin - self.center) + ray.direction * crossing.t;
        let n = crate::frame::unit(radial).unwrap_or(DVec3::Y);
        // Longitude from +x towards −z, latitude from the south pole: u and v grow to the right and up.
        let longitude = (-n.z).atan2(n.x);
        let uv = DVec2::new((longitude / TAU).rem_euclid(1.0), n.y.clamp(-1.0, 1.0).asin() / PI + 0.5);
        let around = DVec3::new(n.z, 0.0, -n.x);
        Hit {
            t: crossing.t,
            point: self.center + n * self.radius,
            point_error: gamma(12) * (self.radius + self.center.abs().max_element()),
            ng: n,
            n,
            tangent: crate::frame::unit(around).unwrap_or_else(|| Frame::around(n).right),
            uv,
            face: 0,
            part: crossing.part,
        }
    }

    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        let (sin_u, cos_u) = (uv.x * TAU).sin_cos();
        let (sin_v, cos_v) = ((uv.y - 0.5) * PI).sin_cos();
        self.center + DVec3::new(cos_v * cos_u, sin_v, -cos_v * sin_u) * self.radius
    }

    fn bounds(&self) -> Aabb {
        let reach = self.radius + gamma(2) * (self.radius + self.center.abs().max_element());
        Aabb::new(self.center - reach, self.center + reach)
    }

    fn may_block(&self, fan: &Fan) -> bool {
        let w = self.center - fan.origin;
        let w2 = w.length_squared();
        let along = w.dot(fan.axis);
        if w2 > self.radius * self.radius {
            // Outside and moving away: cos∠(w, every segment) ≤ 0 when w·axis ≤ −|w| sin α.
            let distance = w2.sqrt();
            if along <= -distance * fan.sin_spread {
                return false;
            }
            // The cones of segments and of the sphere are apart: ∠(w, axis) > α + β.
            let sin_beta = self.radius / distance;
            let cos_beta = (1.0 - sin_beta * sin_beta).max(0.0).sqrt();
            let cos_sum = fan.cos_spread * cos_beta - fan.sin_spread * sin_beta;
            let slack = gamma(16) * distance;
            return along >= distance * cos_sum - slack;
        }
        true
    }

    fn shade(&self, fan: &Fan, lit: &mut [f64]) {
        let f = fan.origin - self.center;
        let args =
            SphereFan { f, c: f.length_squared() - self.radius * self.radius, r2: self.radius * self.radius };
        shade_sphere(fan.vectors, &args, fan, lit);
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        matches!(self.roots(ray), Some((t0, t1)) if (t0 > 0.0 && t0 < t_max) || (t0 <= 0.0 && t1 > 0.0 && t1 < t_max))
    }
}

struct SphereFan {
    f: DVec3,
    c: f64,
    r2: f64,
}

vectorised! {
    /// [`method::robust`] for eight segments at once, reduced to the question whether a root lies in (0, 1).
    fn shade_sphere(sphere: &SphereFan, fan: &Fan, lit: &mut [f64]) {
        let SphereFan { f, c, r2 } = *sphere;
        for (lanes, lit) in fan.lanes().zip(lit.chunks_exact_mut(LANES)) {
            let Lanes { x, y, z } = lanes;
            for i in 0..LANES {
                let a = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
                let b = -(f.x * x[i] + f.y * y[i] + f.z * z[i]);
                let k = b / a;
                let (lx, ly, lz) = (f.x + k * x[i], f.y + k * y[i], f.z + k * z[i]);
                let discriminant = r2 - (lx * lx + ly * ly + lz * lz);
                let s = (a * discriminant.max(0.0)).sqrt();
                // Outside (c > 0) the nearer root c/(b + s) lies in (0, 1); inside the farther one (b + s)/a does.
                let outside = (b > 0.0) & (c < b + s) & (c > 0.0);
                let inside = (c <= 0.0) & (b + s < a) & (b + s > 0.0);
                let blocked = (discriminant > 0.0) & (outside | inside);
                lit[i] = if blocked { 0.0 } else { lit[i] };
            }
        }
    }
}

impl Solid for Sphere {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        out.extend(
            self.roots(ray).and_then(|(t0, t1)| span_of_pair(Crossing::new(t0, 0), Crossing::new(t1, 0))),
        );
    }

    fn contains(&self, p: DVec3) -> bool {
        (p - self.center).length_squared() <= self.radius * self.radius
    }
}
