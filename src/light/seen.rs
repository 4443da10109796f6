//! A light's surface as one place sees it.

use super::{Emitter, SphericalCap, SphericalRectangle, SphericalTriangle};
use glam::{DVec2, DVec3};

/// The surface of a light, spread over the directions in which a place sees it.
#[derive(Clone, Debug)]
pub enum Seen {
    Rectangle(SphericalRectangle),
    Triangle(SphericalTriangle),
    Sphere(SphericalCap),
}

impl Emitter {
    /// The surface as `p` sees it.
    pub fn seen_from(&self, p: DVec3) -> Seen {
        match self {
            Emitter::Rectangle(r) => {
                Seen::Rectangle(SphericalRectangle::new(r.center(), r.half_width(), r.half_height(), p))
            }
            Emitter::Triangle(t) => Seen::Triangle(SphericalTriangle::new(t.corners(), p)),
            Emitter::Sphere(s) => Seen::Sphere(SphericalCap::new(s.center(), s.radius(), p)),
        }
    }
}

impl Seen {
    /// Solid angle \[sr\].
    pub fn solid_angle(&self) -> f64 {
        match self {
            Seen::Rectangle(seen) => seen.solid_angle(),
            Seen::Triangle(seen) => seen.solid_angle(),
            Seen::Sphere(seen) => seen.solid_angle(),
        }
    }

    /// The point that belongs to `u` of the unit square: equal areas of the square are equal solid angles.
    pub fn point(&self, u: DVec2) -> DVec3 {
        match self {
            Seen::Rectangle(seen) => seen.point(u),
            Seen::Triangle(seen) => seen.point(u),
            Seen::Sphere(seen) => seen.point(u),
        }
    }
}
