//! Signed distances of the shapes: exact, to the nearest point of the surface.
//!
//! Each is a composition of differences, squares and roots; nothing is divided by a small number, so that the error
//! stays below [`DistanceField::rounding`] everywhere.
//!
//! - Source: Hart (1996), appendix A; Quilez, *Distance functions* (2008).

use super::{DistanceField, grown, reach};
use crate::bounds::Aabb;
use crate::shape::Shape;
use crate::shape::cone::Cone;
use crate::shape::cuboid::Cuboid;
use crate::shape::cylinder::Cylinder;
use crate::shape::plane::Plane;
use crate::shape::sphere::Sphere;
use crate::shape::torus::Torus;
use glam::{DVec2, DVec3, dvec2};

/// `|p − c| − r`.
impl DistanceField for Sphere {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        (p - self.center()).length() - self.radius()
    }
    fn bounds(&self, level: f64) -> Aabb {
        grown(&Shape::bounds(self), level)
    }
    fn scale(&self) -> f64 {
        self.center().abs().max_element() + self.radius()
    }
    fn detail(&self) -> f64 {
        self.radius()
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        p - self.center()
    }
}

/// `|max(q, 0)| + min(max q, 0)`, `q` how far the point lies beyond the faces of each axis.
impl DistanceField for Cuboid {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        let b = Shape::bounds(self);
        box_distance(p, &b)
    }
    fn bounds(&self, level: f64) -> Aabb {
        grown(&Shape::bounds(self), level)
    }
    fn scale(&self) -> f64 {
        reach(&Shape::bounds(self))
    }
    fn detail(&self) -> f64 {
        let b = Shape::bounds(self);
        (b.max - b.min).min_element()
    }
}

/// Signed distance to a box.
#[inline]
pub(super) fn box_distance(p: DVec3, b: &Aabb) -> f64 {
    let q = (b.min - p).max(p - b.max);
    q.max(DVec3::ZERO).length() + q.max_element().min(0.0)
}

/// `√((ρ − a)² + z²) − b`, `ρ = √(x² + y²)`.
impl DistanceField for Torus {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        dvec2(p.truncate().length() - self.ring(), p.z).length() - self.tube()
    }
    fn bounds(&self, level: f64) -> Aabb {
        grown(&Shape::bounds(self), level)
    }
    fn scale(&self) -> f64 {
        self.ring() + self.tube()
    }
    fn detail(&self) -> f64 {
        self.tube().min(self.ring() - self.tube())
    }
}

/// `(p − p₀) · n`: below the plane is inside.
impl DistanceField for Plane {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        (p - self.point()).dot(self.normal())
    }
    fn bounds(&self, level: f64) -> Aabb {
        let n = self.normal();
        let mut b = Aabb::EVERYTHING;
        // Along an axis the half-space ends.
        if let Some(axis) = (0..3).find(|&i| n[i].abs() == 1.0) {
            let end = self.point()[axis] + n[axis] * level;
            if n[axis] > 0.0 { b.max[axis] = end.next_up() } else { b.min[axis] = end.next_down() }
        }
        b
    }
    fn scale(&self) -> f64 {
        self.point().abs().element_sum()
    }
    fn detail(&self) -> f64 {
        f64::INFINITY
    }
    fn gradient(&self, _: DVec3) -> DVec3 {
        self.normal()
    }
}

/// Of the capped body, in the half plane of the axis.
impl DistanceField for Cylinder {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        let (rho, y, height) = in_half_plane(p, self.p0(), self.axis(), self.height());
        let q = dvec2(rho - self.radius(), (-y).max(y - height));
        q.max(DVec2::ZERO).length() + q.max_element().min(0.0)
    }
    fn bounds(&self, level: f64) -> Aabb {
        grown(&Shape::bounds(self), level)
    }
    fn scale(&self) -> f64 {
        reach(&Shape::bounds(self))
    }
    fn detail(&self) -> f64 {
        self.radius().min(self.height())
    }
}

/// Of the capped body, in the half plane of the axis: to the nearest of base, top and side.
impl DistanceField for Cone {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        let (rho, y, height) = in_half_plane(p, self.p0(), self.axis(), self.height());
        let (r0, r1) = (self.r0(), self.r1());
        let base = dvec2((rho - r0).max(0.0), y);
        let top = dvec2((rho - r1).max(0.0), y - height);
        // Along the side from (r0, 0) to (r1, height).
        let (way, from) = (dvec2(r1 - r0, height), dvec2(rho - r0, y));
        let share = (from.dot(way) / way.length_squared()).clamp(0.0, 1.0);
        let side = from - way * share;
        let d = base.length_squared().min(top.length_squared()).min(side.length_squared()).sqrt();
        let inside = y >= 0.0 && y <= height && from.perp_dot(way) <= 0.0;
        if inside { -d } else { d }
    }
    fn bounds(&self, level: f64) -> Aabb {
        grown(&Shape::bounds(self), level)
    }
    fn scale(&self) -> f64 {
        reach(&Shape::bounds(self))
    }
    fn detail(&self) -> f64 {
        self.r0().max(self.r1()).min(self.height())
    }
}

/// Distance from the axis, and height above `base`.
#[inline]
fn in_half_plane(p: DVec3, base: DVec3, axis: DVec3, height: f64) -> (f64, f64, f64) {
    let w = p - base;
    let y = w.dot(axis);
    ((w - axis * y).length(), y, height)
}
