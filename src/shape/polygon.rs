//! The polygon: flat, any number of corners, convex or not [A §2.2, §2.3].
//!
//! Seen along the ray, the outline winds about it or not. The winding is counted with exact signs, corner by
//! corner, so that of two polygons on the two sides of a shared edge exactly one is met.

use super::plane::Plane;
use super::triangle::ShearedRay;
use super::{Shape, ShapeError, Sides, basis, first_between, perpendicular_part, unit};
use crate::bounds::Aabb;
use crate::num::certified::power_of_two_below;
use crate::ray::{Crossing, Hit, Ray};
use glam::{DVec2, DVec3};

/// A flat polygon; where an outline crosses itself, what it winds about an odd number of times is inside.
///
/// Texture coordinates run over the rectangle around the outline, along its first edge and across.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    corners: Vec<DVec3>,
    plane: Plane,
    /// Lowest corner of the rectangle, in lengths from the plane's point along tangent and bitangent.
    low: DVec2,
    size: DVec2,
    tangent: DVec3,
}

/// How far corners may lie from their plane, per size of the polygon. Tuned: files print 6 digits of slanted
/// corners, which miss their plane by 10⁻⁶; a corner moved by a hundredth of the size is a mistake.
const FLATNESS: f64 = 1e-5;

impl Polygon {
    /// The polygon with these corners in order; its front shows a convex one counter-clockwise.
    pub fn new(corners: Vec<DVec3>) -> Result<Self, ShapeError> {
        if corners.len() < 3 {
            return Err(ShapeError::TooFewVertices { found: corners.len() });
        }
        for &v in &corners {
            ShapeError::finite("corner of a polygon", v)?;
        }
        let (normal, extent) = area_vector(&corners)?;
        let center = corners.iter().fold(DVec3::ZERO, |sum, &v| sum + v / corners.len() as f64);
        let plane = Plane::new(center, normal)?;
        let away = corners.iter().map(|&v| (v - center).dot(plane.normal()).abs()).fold(0.0, f64::max);
        let allowed = FLATNESS * extent;
        if away > allowed {
            return Err(ShapeError::NotFlat { allowed, found: away });
        }
        let first = corners.iter().map(|&v| v - corners[0]).find(|e| *e != DVec3::ZERO);
        let tangent = perpendicular_part(first.unwrap_or(basis(normal).0), plane.normal());
        let mut polygon = Polygon { corners, plane, low: DVec2::ZERO, size: DVec2::ONE, tangent };
        let (low, high) =
            polygon.corners.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), &v| {
                let flat = polygon.flat(v);
                (l.min(flat), h.max(flat))
            });
        (polygon.low, polygon.size) = (low, high - low);
        Ok(polygon)
    }

    pub fn with_sides(self, sides: Sides) -> Self {
        Polygon { plane: self.plane.with_sides(sides), ..self }
    }

    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// The geometric normal, a unit vector.
    pub fn normal(&self) -> DVec3 {
        self.plane.normal()
    }

    /// Where the line of the ray meets the polygon, at any sign of `t`.
    pub fn meeting(&self, ray: &Ray) -> Option<f64> {
        let t = self.plane.meeting(ray)?;
        let sheared = ShearedRay::new(ray);
        let next = self.corners.iter().cycle().skip(1);
        let winding: i32 = self.corners.iter().zip(next).map(|(&a, &b)| sheared.winding_step(a, b)).sum();
        (winding % 2 != 0).then_some(t)
    }

    fn flat(&self, p: DVec3) -> DVec2 {
        let from = p - self.plane.point();
        DVec2::new(from.dot(self.tangent), from.dot(self.plane.normal().cross(self.tangent)))
    }
}

/// Unit vector along the sum of the areas that the outline sweeps about its first corner, and the outline's size.
///
/// - Domain: an error if no area is left beside rounding (`n` cross products of size at most `extent²`).
/// - Source: Newell's method; Sutherland, Sproull & Schumacker (1974).
fn area_vector(corners: &[DVec3]) -> Result<(DVec3, f64), ShapeError> {
    let extent = corners.iter().map(|&v| (v - corners[0]).abs().max_element()).fold(0.0, f64::max);
    let scale = power_of_two_below(extent);
    let arm = |v: DVec3| (v - corners[0]) / scale;
    let sum = corners.windows(2).fold(DVec3::ZERO, |sum, w| sum + arm(w[0]).cross(arm(w[1])));
    let rounding = 16.0 * crate::num::U * corners.len() as f64;
    match unit(sum) {
        Some(n) if extent > 0.0 && sum.abs().max_element() > rounding => Ok((n, extent)),
        _ => Err(ShapeError::NoArea { what: "polygon" }),
    }
}

impl Shape for Polygon {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        first_between(self.meeting(ray).map(|t| Crossing::new(t, 0)), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, 0.0, f64::INFINITY));
    }

    /// `point_error` is the distance from the plane of best fit.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let hit = self.plane.flat_hit(ray, crossing);
        let uv = ((self.flat(hit.point) - self.low) / self.size).clamp(DVec2::ZERO, DVec2::ONE);
        Hit { tangent: self.tangent, uv, ..hit }
    }

    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        let flat = self.low + uv * self.size;
        let bitangent = self.plane.normal().cross(self.tangent);
        self.plane.point() + self.tangent * flat.x + bitangent * flat.y
    }

    /// Hit points lie on the plane of best fit, so the box is widened by how far the corners are off it.
    fn bounds(&self) -> Aabb {
        let off = |v: &DVec3| (*v - self.plane.point()).dot(self.plane.normal());
        let feet = self.corners.iter().map(|v| *v - self.plane.normal() * off(v));
        Aabb::of_points(self.corners.iter().copied().chain(feet))
    }
}
