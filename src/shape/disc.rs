//! The disc: a plane cut off at a distance from its centre [B §6.4, E problem 5.1].

use super::plane::Plane;
use super::{Shape, ShapeError, Sides, first_between, perpendicular_part, turn};
use crate::bounds::Aabb;
use crate::num::U;
use crate::num::certified::{Bounded, Scalar, Uncertain, Vector};
use crate::num::double_double::DoubleDouble;
use crate::ray::{Crossing, Hit, Ray};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A disc with its rim.
///
/// Texture coordinates: `u` the angle as a share of the turn, `v` the distance from the centre over the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    plane: Plane,
    radius: f64,
}

impl Disc {
    /// The disc about `center`, perpendicular to `normal` (of any length but zero).
    pub fn new(center: DVec3, normal: DVec3, radius: f64) -> Result<Self, ShapeError> {
        let radius = ShapeError::positive("radius of a disc", radius)?;
        Ok(Disc { plane: Plane::new(center, normal)?, radius })
    }

    pub fn with_sides(self, sides: Sides) -> Self {
        Disc { plane: self.plane.with_sides(sides), ..self }
    }

    pub fn center(&self) -> DVec3 {
        self.plane.point()
    }

    pub fn normal(&self) -> DVec3 {
        self.plane.normal()
    }

    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Where the line of the ray crosses the disc, at any sign of `t`.
    pub fn meeting(&self, ray: &Ray) -> Option<f64> {
        let t = self.plane.meeting(ray)?;
        within::<Bounded>(self, ray, t)
            .or_else(|Uncertain| within::<DoubleDouble>(self, ray, t))
            .ok()?
            .then_some(t)
    }
}

/// Is the point at `t` within the radius? `t` was rounded, so `n·(p − c) / n·d` more is to go along the ray.
fn within<T: Scalar>(disc: &Disc, ray: &Ray, t: f64) -> Result<bool, Uncertain> {
    let d = Vector::<T>::of(ray.direction);
    let n = Vector::of(disc.plane.across());
    let p = Vector::difference(ray.origin, disc.center()) + Vector::along(ray.direction, t);
    let p = p - d.scaled(n.dot(p) / n.dot(d));
    Ok((p.dot(p) - T::product(disc.radius, disc.radius)).sign()? <= 0)
}

/// The disc test as a course prints it: plane, then distance against radius, each rounded as it comes.
///
/// - Domain: any; parallel rays divide by zero, and answer `None`.
/// - Source: [B §6.4.1]
pub fn as_printed(center: DVec3, normal: DVec3, radius: f64, ray: &Ray) -> Option<f64> {
    let t = (center - ray.origin).dot(normal) / ray.direction.dot(normal);
    let away = ray.at(t) - center;
    (t > 0.0 && t.is_finite() && away.dot(away).sqrt() <= radius).then_some(t)
}

impl Shape for Disc {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        first_between(self.meeting(ray).map(|t| Crossing::new(t, 0)), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, 0.0, f64::INFINITY));
    }

    /// The point is pulled back inside the rim if rounding carried it outside.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let mut hit = self.plane.flat_hit(ray, crossing);
        let distance = hit.uv.length();
        if distance > self.radius {
            hit.point = self.center() + (hit.point - self.center()) * (self.radius / distance);
            hit.point_error += 4.0 * U * (self.radius + hit.point.abs().max_element());
        }
        let across = self.plane.tangent() * -hit.uv.y + self.plane.bitangent() * hit.uv.x;
        hit.tangent =
            if distance > 0.0 { perpendicular_part(across, hit.ng) } else { self.plane.bitangent() };
        hit.uv = DVec2::new(turn(hit.uv.x, hit.uv.y), (distance / self.radius).min(1.0));
        hit
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let (sin, cos) = (uv.x * TAU).sin_cos();
        self.plane.point_at(face, DVec2::new(cos, sin) * (uv.y * self.radius))
    }

    fn bounds(&self) -> Aabb {
        round_bounds(self.center(), self.normal(), self.radius)
    }
}

/// The box about a circle: its half extent along an axis is `r √(1 − nᵢ²)`, a point where the circle is flat.
///
/// The unit normal is known to 4 u in each coordinate, which moves an extent by up to `√(8u) r` where
/// `nᵢ ≈ 1`; so the extent is taken from the other two coordinates, where the error is relative.
pub(super) fn round_bounds(center: DVec3, normal: DVec3, radius: f64) -> Aabb {
    let half = DVec3::from_array([0, 1, 2].map(|i: usize| {
        let side = normal[(i + 1) % 3].hypot(normal[(i + 2) % 3]);
        radius * side * (1.0 + 16.0 * U)
    }));
    let outwards = |x: f64, step: f64| if step < 0.0 { x.next_down() } else { x.next_up() };
    let (low, high) = (center - half, center + half);
    Aabb::new(
        DVec3::new(outwards(low.x, -1.0), outwards(low.y, -1.0), outwards(low.z, -1.0)),
        DVec3::new(outwards(high.x, 1.0), outwards(high.y, 1.0), outwards(high.z, 1.0)),
    )
}
