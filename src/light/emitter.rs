//! The surfaces that lights may have [A §4.3.5, D §4.10.2].

use super::LightError;
use crate::frame::{Frame, rotation_about, unit};
use crate::ray::Ray;
use crate::sample::{uniform_sphere, uniform_triangle};
use crate::shape::Shape;
use crate::shape::sphere::Sphere;
use crate::shape::triangle::Triangle;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// A flat rectangle with a front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    center: DVec3,
    half_width: DVec3,
    half_height: DVec3,
    normal: DVec3,
}

impl Rectangle {
    /// A rectangle `size` (width, height) about `center` that faces `direction`, turned by `roll` \[rad\]
    /// counter-clockwise about it [D §4.10.2].
    ///
    /// Without roll the width runs horizontally and the height upwards (for one that faces
    /// straight up or down: along x and z), as for a camera that looks along `direction`.
    ///
    /// - Errors: a side that is not positive and finite, a direction of length 0.
    pub fn facing(center: DVec3, direction: DVec3, roll: f64, size: DVec2) -> Result<Self, LightError> {
        for (what, found) in [("width", size.x), ("height", size.y)] {
            if !(found > 0.0 && found.is_finite()) {
                return Err(LightError::NotPositive { what, found });
            }
        }
        let normal = unit(direction).ok_or(LightError::NoDirection)?;
        let up = if normal.x == 0.0 && normal.z == 0.0 { DVec3::Z } else { DVec3::Y };
        let frame = Frame::look_at(DVec3::ZERO, normal, up).map_err(|_| LightError::NoDirection)?;
        let turn = rotation_about(normal, roll).ok_or(LightError::NoDirection)?;
        let (half_width, half_height) =
            (turn * frame.right * (0.5 * size.x), turn * frame.up * (0.5 * size.y));
        Ok(Rectangle { center, half_width, half_height, normal })
    }

    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// From the centre to the middle of an edge across the width.
    pub fn half_width(&self) -> DVec3 {
        self.half_width
    }

    /// From the centre to the middle of an edge across the height.
    pub fn half_height(&self) -> DVec3 {
        self.half_height
    }

    /// The direction it faces, unit.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// The corners, in order around the rectangle.
    pub fn corners(&self) -> [DVec3; 4] {
        let (c, w, h) = (self.center, self.half_width, self.half_height);
        [c - w - h, c + w - h, c + w + h, c - w + h]
    }

    fn point(&self, u: DVec2) -> DVec3 {
        self.center + self.half_width * (2.0 * u.x - 1.0) + self.half_height * (2.0 * u.y - 1.0)
    }

    fn crossing(&self, ray: &Ray) -> Option<f64> {
        let to = self.center - ray.origin;
        let t = to.dot(self.normal) / ray.direction.dot(self.normal);
        if !(t > 0.0 && t.is_finite()) {
            return None;
        }
        let p = ray.direction * t - to;
        let inside = |half: DVec3| p.dot(half).abs() <= half.length_squared();
        (inside(self.half_width) && inside(self.half_height)).then_some(t)
    }
}

/// The surface of an area light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emitter {
    Rectangle(Rectangle),
    /// Its front shows the corners counter-clockwise.
    Triangle(Triangle),
    Sphere(Sphere),
}

impl Emitter {
    /// Area \[m²\].
    pub fn area(&self) -> f64 {
        self.area_scaled(1.0)
    }

    /// Area of the surface enlarged `scale` times: `scale² area`, also where the area itself is out of range.
    pub fn area_scaled(&self, scale: f64) -> f64 {
        match self {
            Emitter::Rectangle(r) => 4.0 * (r.half_width * scale).length() * (r.half_height * scale).length(),
            Emitter::Triangle(t) => {
                let [a, b, c] = t.corners();
                0.5 * ((b - a) * scale).cross((c - a) * scale).length()
            }
            Emitter::Sphere(s) => 4.0 * PI * (s.radius() * scale) * (s.radius() * scale),
        }
    }

    /// The point that belongs to `u` of the unit square: equal areas of the square are equal areas of the surface.
    #[inline]
    pub fn point(&self, u: DVec2) -> DVec3 {
        match self {
            Emitter::Rectangle(r) => r.point(u),
            Emitter::Triangle(t) => {
                let ([a, b, c], weights) = (t.corners(), uniform_triangle(u));
                a * weights.x + b * weights.y + c * weights.z
            }
            Emitter::Sphere(s) => s.center() + uniform_sphere(u) * s.radius(),
        }
    }

    /// The normal of a flat surface, unit, on its front; none of a sphere.
    #[inline]
    pub fn flat_normal(&self) -> Option<DVec3> {
        match self {
            Emitter::Rectangle(r) => Some(r.normal),
            Emitter::Triangle(t) => Some(t.normal()),
            Emitter::Sphere(_) => None,
        }
    }

    /// A ball that holds the surface.
    pub fn ball(&self) -> (DVec3, f64) {
        match self {
            Emitter::Rectangle(r) => (r.center, (r.half_width + r.half_height).length()),
            Emitter::Triangle(t) => {
                let corners = t.corners();
                let center = corners.iter().map(|c| *c / 3.0).sum();
                (center, corners.iter().map(|c: &DVec3| (*c - center).length()).fold(0.0, f64::max))
            }
            Emitter::Sphere(s) => (s.center(), s.radius()),
        }
    }

    /// Where a ray meets the surface first, if at some `t > 0`.
    pub fn crossing(&self, ray: &Ray) -> Option<f64> {
        match self {
            Emitter::Rectangle(r) => r.crossing(ray),
            Emitter::Triangle(t) => t.nearest(ray, 0.0, f64::INFINITY).map(|c| c.t),
            Emitter::Sphere(s) => s.nearest(ray, 0.0, f64::INFINITY).map(|c| c.t),
        }
    }

    /// Is the front turned to `p`: does light by Lambert's law reach it at all?
    pub fn faces(&self, p: DVec3) -> bool {
        match self {
            Emitter::Rectangle(r) => (p - r.center).dot(r.normal) > 0.0,
            Emitter::Triangle(t) => (p - t.corners()[0]).dot(t.normal()) > 0.0,
            Emitter::Sphere(s) => (p - s.center()).length() > s.radius(),
        }
    }
}

impl From<Rectangle> for Emitter {
    fn from(rectangle: Rectangle) -> Self {
        Emitter::Rectangle(rectangle)
    }
}

impl From<Triangle> for Emitter {
    fn from(triangle: Triangle) -> Self {
        Emitter::Triangle(triangle)
    }
}

impl From<Sphere> for Emitter {
    fn from(sphere: Sphere) -> Self {
        Emitter::Sphere(sphere)
    }
}
