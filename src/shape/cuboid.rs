//! The axis-aligned box [D §4.7.2]: three slabs.
//!
//! Faces are numbered 0: −x, 1: +x, 2: −y, 3: +y, 4: −z, 5: +z.

use super::fan::{Fan, LANES, Lanes, vectorised};
use super::{Shape, ShapeError, Solid, span_of_pair};
use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DVec2, DVec3};

/// The solid `min ≤ p ≤ max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    min: DVec3,
    max: DVec3,
}

impl Cuboid {
    /// - Errors: corners that are not finite, an extent that is not positive.
    pub fn new(min: DVec3, max: DVec3) -> Result<Self, ShapeError> {
        let (min, max) = (ShapeError::finite("corner", min)?, ShapeError::finite("corner", max)?);
        for extent in (max - min).to_array() {
            ShapeError::positive("extent", extent)?;
        }
        Ok(Cuboid { min, max })
    }

    /// Where the whole line enters and leaves, with the faces.
    ///
    /// ```text
    /// t = (x_face − o)/d for each face;  enter = max of the three near ones, leave = min of the far ones
    /// ```
    ///
    /// - A line parallel to a slab lies in it or misses; in a face counts as inside. No `0/0` arises.
    /// - Accuracy: relative error of each `t` ≤ γ₂: one subtraction, one quotient.
    /// - Source: Kay & Kajiya, SIGGRAPH 1986.
    #[inline]
    pub fn roots(&self, ray: &Ray) -> Option<(Crossing, Crossing)> {
        let mut enter = Crossing::new(f64::NEG_INFINITY, 0);
        let mut leave = Crossing::new(f64::INFINITY, 0);
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            if d == 0.0 {
                if !(self.min[axis] <= o && o <= self.max[axis]) {
                    return None;
                }
                continue;
            }
            let (a, b) = ((self.min[axis] - o) / d, (self.max[axis] - o) / d);
            let upper = u32::from(d < 0.0); // which of the two faces is met first
            let (near, far) = if d > 0.0 { (a, b) } else { (b, a) };
            let face = 2 * axis as u32;
            if near > enter.t {
                enter = Crossing::new(near, face + upper);
            }
            if far < leave.t {
                leave = Crossing::new(far, face + 1 - upper);
            }
        }
        (enter.t <= leave.t && leave.t.is_finite()).then_some((enter, leave))
    }
}

impl Shape for Cuboid {
    #[inline]
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let (enter, leave) = self.roots(ray)?;
        let first = if enter.t > t_min { enter } else { leave };
        (first.t > t_min && first.t < t_max).then_some(first)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        if let Some((enter, leave)) = self.roots(ray) {
            out.extend([enter].iter().filter(|c| c.t > 0.0));
            out.extend([leave].iter().filter(|c| c.t > 0.0 && c.t > enter.t));
        }
    }

    /// The point lies exactly in its face: that coordinate is copied, hence no error along the normal.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let face = crossing.face;
        let axis = (face / 2) as usize;
        let mut point = ray.at(crossing.t).clamp(self.min, self.max);
        point[axis] = if face.is_multiple_of(2) { self.min[axis] } else { self.max[axis] };
        let (n, u, v) = axes_of_face(face);
        let share = (point - self.min) / (self.max - self.min);
        let along =
            |axis: DVec3| if axis.element_sum() > 0.0 { share.dot(axis) } else { 1.0 + share.dot(axis) };
        Hit {
            t: crossing.t,
            point,
            point_error: 0.0,
            ng: n,
            n,
            tangent: u,
            uv: DVec2::new(along(u), along(v)),
            face,
            part: crossing.part,
        }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let (n, u, v) = axes_of_face(face);
        let from = |axis: DVec3, x: f64| if axis.element_sum() > 0.0 { axis * x } else { axis * (x - 1.0) };
        let share = from(u, uv.x) + from(v, uv.y) + n.max(DVec3::ZERO);
        self.min + (self.max - self.min) * share
    }

    fn bounds(&self) -> Aabb {
        Aabb::new(self.min, self.max)
    }

    fn shade(&self, fan: &Fan, lit: &mut [f64]) {
        shade_box(fan.vectors, self.min - fan.origin, self.max - fan.origin, fan, lit);
    }
}

/// Outward normal, and the directions of growing `u` and `v`, seen from outside to the right and up.
fn axes_of_face(face: u32) -> (DVec3, DVec3, DVec3) {
    match face {
        0 => (DVec3::NEG_X, DVec3::Z, DVec3::Y),
        1 => (DVec3::X, DVec3::NEG_Z, DVec3::Y),
        2 => (DVec3::NEG_Y, DVec3::X, DVec3::Z),
        3 => (DVec3::Y, DVec3::X, DVec3::NEG_Z),
        4 => (DVec3::NEG_Z, DVec3::NEG_X, DVec3::Y),
        _ => (DVec3::Z, DVec3::X, DVec3::Y),
    }
}

vectorised! {
    /// [`Cuboid::roots`] for eight segments at once, reduced to the question whether a root lies in (0, 1).
    ///
    /// With `d = 0` the quotients are ±∞, or NaN for an origin in the face; a comparison with NaN keeps the other
    /// bound, as `roots` does by skipping the axis.
    fn shade_box(min: DVec3, max: DVec3, fan: &Fan, lit: &mut [f64]) {
        let (min, max) = (min.to_array(), max.to_array());
        for (Lanes { x, y, z }, lit) in fan.lanes().zip(lit.chunks_exact_mut(LANES)) {
            for i in 0..LANES {
                let d = [x[i], y[i], z[i]];
                let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
                for axis in 0..3 {
                    let (a, b) = (min[axis] / d[axis], max[axis] / d[axis]);
                    let (near, far) = if d[axis] < 0.0 { (b, a) } else { (a, b) };
                    enter = if near > enter { near } else { enter };
                    leave = if far < leave { far } else { leave };
                }
                let first = if enter > 0.0 { enter } else { leave };
                let blocked = (enter <= leave) & (first > 0.0) & (first < 1.0);
                lit[i] = if blocked { 0.0 } else { lit[i] };
            }
        }
    }
}

impl Solid for Cuboid {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        out.extend(self.roots(ray).and_then(|(enter, leave)| span_of_pair(enter, leave)));
    }

    fn contains(&self, p: DVec3) -> bool {
        Aabb::new(self.min, self.max).contains(p)
    }
}
