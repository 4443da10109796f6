//! The capsule: everything within a radius of a segment. It has no formula of its own among the shapes; it is met by
//! marching.

use super::{DistanceField, grown};
use crate::bounds::Aabb;
use crate::shape::ShapeError;
use glam::DVec3;

/// All points within `radius` of the segment from `a` to `b`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    a: DVec3,
    along: DVec3,
    radius: f64,
}

impl Capsule {
    /// - Errors: ends that are not finite, a radius that is not positive and finite. Equal ends make a sphere.
    pub fn new(a: DVec3, b: DVec3, radius: f64) -> Result<Self, ShapeError> {
        let a = ShapeError::finite("end of a capsule", a)?;
        let along =
            ShapeError::finite("length of a capsule", ShapeError::finite("end of a capsule", b)? - a)?;
        Ok(Capsule { a, along, radius: ShapeError::positive("radius of a capsule", radius)? })
    }

    pub fn radius(&self) -> f64 {
        self.radius
    }

    pub fn ends(&self) -> (DVec3, DVec3) {
        (self.a, self.a + self.along)
    }
}

/// `|p − nearest point of the segment| − r`.
impl DistanceField for Capsule {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        let w = p - self.a;
        let square = self.along.length_squared();
        let share = if square > 0.0 { (w.dot(self.along) / square).clamp(0.0, 1.0) } else { 0.0 };
        (w - self.along * share).length() - self.radius
    }
    fn bounds(&self, level: f64) -> Aabb {
        let (a, b) = self.ends();
        grown(&Aabb::of_points([a, b]), self.radius + level)
    }
    fn scale(&self) -> f64 {
        let (a, b) = self.ends();
        a.abs().max(b.abs()).element_sum() + self.radius
    }
    fn detail(&self) -> f64 {
        self.radius
    }
}
