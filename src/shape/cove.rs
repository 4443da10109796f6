//! The cove of a photographer's studio: a floor and a wall joined by a quarter of a cylinder, so that no edge is seen.
//!
//! ```text
//! s distance from the wall, h height over the floor:    floor h = 0, s ≥ r;    wall s = 0, h ≥ r
//! quarter cylinder (s − r)² + (h − r)² = r²,  s < r, h < r
//! ```
//!
//! The air is convex: a line passes through it on one stretch, whose ends are those between floor and wall, moved to the
//! cylinder where they lie in the corner. No ray can slip between two pieces, however it grazes their joints.
//! Faces: 0 the floor, 1 the quarter cylinder, 2 the wall.

use super::fan::Fan;
use super::plane::Plane;
use super::{Shape, ShapeError, first_between};
use crate::bounds::Aabb;
use crate::frame::unit;
use crate::num::{U, gamma};
use crate::ray::{Crossing, Hit, Ray};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// A floor and a wall without end, square to each other, and their rounded corner.
///
/// Normals point into the air. Texture coordinates: `u` the length along the corner; `v` on the floor the distance from
/// the wall, on the wall the height, on the quarter cylinder the angle \[rad\] from the floor's end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cove {
    floor: Plane,
    wall: Plane,
    /// Along the corner, unit.
    along: DVec3,
    radius: f64,
}

impl Cove {
    /// The cove whose floor and wall would join at `corner` without rounding. `up` is the floor's normal; of `front`, the
    /// wall's, the part square to `up` counts. Either may have any length but zero.
    ///
    /// - Errors: numbers that are not finite, a radius that is not positive, parallel normals.
    pub fn new(corner: DVec3, up: DVec3, front: DVec3, radius: f64) -> Result<Self, ShapeError> {
        let radius = ShapeError::positive("radius of a cove", radius)?;
        let floor = Plane::new(corner, up)?;
        let front = ShapeError::direction("front of a cove", front)?;
        let across = ShapeError::direction("front of a cove, across its up", front.cross(floor.normal()))?;
        let wall = Plane::new(corner, floor.normal().cross(across))?;
        Ok(Cove { floor, wall, along: across, radius })
    }

    /// Distance from the wall and height over the floor, `(s, h)`.
    #[inline]
    fn section(&self, p: DVec3) -> DVec2 {
        let from = p - self.floor.point();
        DVec2::new(from.dot(self.wall.normal()), from.dot(self.floor.normal()))
    }

    /// Does the cylinder stand before both planes here?
    #[inline]
    fn is_in_corner(&self, p: DVec3) -> bool {
        self.section(p).max_element() < self.radius
    }

    /// Does the point certainly lie in the air?
    ///
    /// A coordinate of the section has three products, two sums and a unit normal behind it, 8 u of the absolute terms
    /// together; along an axis that leaves the sign of one difference, which is exact. Squared distances from the axis have
    /// less than 64 u of `r²`.
    #[inline]
    fn is_in_air(&self, p: DVec3) -> bool {
        let from = p - self.floor.point();
        let sure = |n: DVec3| {
            let terms = from * n;
            let (sum, doubt) = (terms.element_sum(), 8.0 * U * terms.abs().element_sum());
            (sum, sum > doubt)
        };
        let ((s, off_wall), (h, off_floor)) = (sure(self.wall.normal()), sure(self.floor.normal()));
        let r = self.radius;
        let before_joint =
            s.max(h) >= r || (DVec2::new(s, h) - r).length_squared() < (1.0 - 64.0 * U) * r * r;
        off_wall && off_floor && before_joint
    }

    /// Both ends of the stretch of the line in the air, either of which may be infinite.
    #[inline]
    fn span(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        let (mut enter, mut leave) = (Crossing::new(f64::NEG_INFINITY, 0), Crossing::new(f64::INFINITY, 0));
        for (plane, face) in [(&self.floor, 0), (&self.wall, 2)] {
            let along = ray.direction.dot(plane.normal());
            match plane.meeting(ray) {
                Some(t) if along > 0.0 && t > enter.t => enter = Crossing::new(t, face),
                Some(t) if along < 0.0 && t < leave.t => leave = Crossing::new(t, face),
                Some(_) => {}
                None if (ray.origin - plane.point()).dot(plane.normal()) < 0.0 => return None,
                None => {}
            }
        }
        if !(enter.t <= leave.t) {
            return None;
        }
        let in_corner = |c: &Crossing| c.t.is_finite() && self.is_in_corner(ray.at(c.t));
        let moved = [in_corner(&enter), in_corner(&leave)];
        if moved == [false; 2] {
            return Some([enter, leave]);
        }
        let Some([near, far]) = self.on_cylinder(ray) else {
            // Behind the cylinder all the way; or past one of its joints by less than rounding, where the plane stays.
            return (moved != [true; 2]).then_some([enter, leave]);
        };
        let pick = |moved, there: Crossing, t| if moved { Crossing::new(t, 1) } else { there };
        Some([pick(moved[0], enter, near), pick(moved[1], leave, far)])
    }

    /// Where the line crosses the whole cylinder; `None` if it passes it.
    ///
    /// ```text
    /// q from the axis, e the direction, both across it:  l = q − e (q·e)/(e·e),  t = (−q·e ∓ √(e·e (r² − l·l)))/(e·e)
    /// ```
    ///
    /// The root nearer to the origin is the quotient of `q·q − r²` by the other's numerator, which cancels nothing.
    fn on_cylinder(&self, ray: &Ray) -> Option<[f64; 2]> {
        let q = self.section(ray.origin) - self.radius;
        let e = DVec2::new(ray.direction.dot(self.wall.normal()), ray.direction.dot(self.floor.normal()));
        let size = e.abs().max_element();
        let e = e / size; // neither squared to 0 nor to infinity
        let (a, b) = (e.dot(e), q.dot(e));
        let l = q - e * (b / a);
        let (r, closest) = (self.radius, l.length());
        let root = (a * (r - closest) * (r + closest)).sqrt();
        let outside = q.length();
        let c = (outside - r) * (outside + r);
        let far = -b - root.copysign(b);
        let (first, second) = (far / a, if far == 0.0 { 0.0 } else { c / far });
        let (near, far) = (first.min(second) / size, first.max(second) / size);
        (closest <= r && near.is_finite() && far.is_finite()).then_some([near, far])
    }

    fn ends(&self, ray: &Ray) -> ArrayVec<Crossing, 2> {
        let ends = self.span(ray).into_iter().flatten();
        ends.filter(|c| c.t.is_finite() && ray.at(c.t).is_finite()).collect()
    }

    /// A hit of the cylinder, brought back onto it across its axis.
    ///
    /// Rounding bound: `s` and `h` have 5 roundings each and 8 of the unit normals, the distance from the axis 3 more, the
    /// shift 3 and 8 again, all relative to the distance from the corner and the radius; and `2 u |p|` of the point itself.
    fn rounded_hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let p = ray.at(crossing.t);
        let q = self.section(p) - self.radius;
        let inward = unit(DVec3::new(-q.x, -q.y, 0.0)).map_or(DVec2::Y, |v| v.truncate());
        let turned = self.wall.normal() * inward.x + self.floor.normal() * inward.y;
        let ng = unit(turned).unwrap_or(self.floor.normal());
        let point = p + ng * (q.length() - self.radius);
        let spread = (p - self.floor.point()).abs().element_sum() + self.radius;
        Hit {
            t: crossing.t,
            point,
            point_error: gamma(32) * spread + 2.0 * U * point.abs().max_element(),
            ng,
            n: ng,
            tangent: super::perpendicular_part(self.along, ng),
            uv: DVec2::new((point - self.floor.point()).dot(self.along), inward.x.atan2(inward.y)),
            face: 1,
            part: crossing.part,
        }
    }
}

impl Shape for Cove {
    fn is_costly(&self) -> bool {
        false
    }

    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        first_between(self.ends(ray), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.ends(ray).into_iter().filter(|c| c.t > 0.0));
    }

    /// Not if all of the hull lies before the quarter cylinder and over the floor.
    fn may_block(&self, fan: &Fan) -> bool {
        let (low, high) = (fan.hull.min - self.floor.point(), fan.hull.max - self.floor.point());
        let least = |n: DVec3| {
            let terms = (low * n).min(high * n);
            (terms.element_sum(), 8.0 * U * terms.abs().element_sum())
        };
        let ((s, doubt_s), (h, doubt_h)) = (least(self.wall.normal()), least(self.floor.normal()));
        !(s - doubt_s >= self.radius && h > doubt_h)
    }

    /// The air is convex: nothing stands between two of its points.
    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        let is_free = self.is_in_air(ray.origin) && self.is_in_air(ray.at(t_max));
        !is_free && self.nearest(ray, 0.0, t_max).is_some()
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let plane = match crossing.face {
            0 => &self.floor,
            2 => &self.wall,
            _ => return self.rounded_hit(ray, crossing),
        };
        let hit = plane.flat_hit(ray, crossing);
        let from = hit.point - plane.point();
        let other = if crossing.face == 0 { &self.wall } else { &self.floor };
        let tangent = super::perpendicular_part(self.along, hit.ng);
        Hit { tangent, uv: DVec2::new(from.dot(self.along), from.dot(other.normal())), ..hit }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let r = self.radius;
        let (s, h) = match face {
            0 => (uv.y, 0.0),
            2 => (0.0, uv.y),
            _ => (r * (1.0 - uv.y.sin()), r * (1.0 - uv.y.cos())),
        };
        self.floor.point() + self.along * uv.x + self.wall.normal() * s + self.floor.normal() * h
    }

    fn bounds(&self) -> Aabb {
        Aabb::new(DVec3::NEG_INFINITY, DVec3::INFINITY)
    }
}
