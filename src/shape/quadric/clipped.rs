//! The part of a quadric inside a box, to draw unbounded ones.

use super::Quadric;
use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray};
use crate::shape::{Shape, first_between};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// A quadric cut off at the faces of a box; open there. (For a closed body, intersect solids.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClippedQuadric {
    pub quadric: Quadric,
    pub clip: Aabb,
}

impl ClippedQuadric {
    fn line(&self, ray: &Ray) -> ArrayVec<Crossing, 2> {
        let inside = |c: &Crossing| self.clip.contains(ray.at(c.t));
        self.quadric.line(ray).into_iter().filter(inside).collect()
    }
}

impl Shape for ClippedQuadric {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        if t_min >= 0.0 && self.quadric.is_behind_or_beside(ray) {
            return None;
        }
        first_between(self.line(ray), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.line(ray).into_iter().filter(|c| c.t > 0.0));
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        self.quadric.hit(ray, crossing)
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        self.quadric.point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        self.clip
    }
}
