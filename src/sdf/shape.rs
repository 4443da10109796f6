//! A field as a shape: met by marching, in any scene.

use super::march::{Change, March, Walk};
use super::{DistanceField, grown};
use crate::bounds::Aabb;
use crate::frame::unit;
use crate::num::gamma;
use crate::ray::{Crossing, Hit, Ray, Span};
use crate::shape::{Shape, ShapeError, Solid};
use glam::{DVec2, DVec3};

/// The solid where a field is at most 0.
///
/// Faces tell from where the surface is seen: 0: −x, 1: +x, 2: −y, 3: +y, 4: −z, 5: +z, whichever axis the normal is
/// nearest to. Texture coordinates are the other two of the point, as shares of the bounds; places that hide behind one
/// another along the axis share them.
#[derive(Clone, Copy, Debug)]
pub struct FieldShape<F> {
    field: F,
    bounds: Aabb,
    /// The bounds and a margin, in which the march runs: it begins outside the solid.
    around: Aabb,
    march: March,
}

impl<F: DistanceField> FieldShape<F> {
    /// - Errors: a field whose solid is not bounded.
    pub fn new(field: F) -> Result<Self, ShapeError> {
        let bounds = field.bounds(0.0);
        for corner in [bounds.min, bounds.max] {
            ShapeError::finite("corner of a distance field's bounds", corner)?;
        }
        let march = March::through(&field);
        // The margin exceeds the tolerance, and the rounding of the field there.
        let margin = 4.0 * march.tolerance + 4.0 * field.rounding(bounds.min.abs().max(bounds.max.abs()));
        Ok(FieldShape { bounds, around: grown(&bounds, margin), march, field })
    }

    /// The same solid, marched another way.
    pub fn with_march(self, march: March) -> Self {
        FieldShape { march, ..self }
    }

    pub fn field(&self) -> &F {
        &self.field
    }

    pub fn march(&self) -> &March {
        &self.march
    }

    /// The march along a ray from distance `start` on [m], as far as the bounds reach.
    fn walk(&self, ray: &Ray, start: f64) -> Option<Walk<'_, F>> {
        let direction = unit(ray.direction)?;
        let (from, to) = self.around.slab(ray.origin, direction.recip(), start, f64::INFINITY)?;
        Walk::new(&self.field, self.march, ray, from, to)
    }

    /// Parameters of the changes of sign in front of the origin.
    fn ahead(&self, ray: &Ray) -> impl Iterator<Item = Crossing> {
        let walk = self.walk(ray, 0.0);
        let speed = walk.as_ref().map_or(1.0, |w| w.speed());
        let found = walk.into_iter().flatten().map(move |c: Change| Crossing::new(c.s / speed, 0));
        found.filter(|c| c.t > 0.0 && c.t.is_finite())
    }
}

/// The axis nearest to a direction, and the face that shows it.
fn face_of(n: DVec3) -> u32 {
    let a = n.abs();
    let axis = if a.x >= a.y && a.x >= a.z {
        0
    } else if a.y >= a.z {
        1
    } else {
        2
    };
    2 * axis + u32::from(n[axis as usize] > 0.0)
}

impl<F: DistanceField> Shape for FieldShape<F> {
    /// The march always begins at the bounds or the origin, so that every question is answered from one list of crossings.
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        self.ahead(ray).find(|c| c.t > t_min).filter(|c| c.t < t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.ahead(ray));
    }

    /// - Accuracy: `point_error`: the sign changes within that of the point, by the rounding of the ray, of the root and of the
    ///   field.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let point = ray.at(crossing.t);
        let along = ray.origin.abs().element_sum() + (ray.direction * crossing.t).abs().element_sum();
        let ng = unit(self.field.gradient(point)).or(unit(-ray.direction)).unwrap_or(DVec3::Y);
        let face = face_of(ng);
        let axis = (face / 2) as usize;
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let share = (point - self.bounds.min) / (self.bounds.max - self.bounds.min);
        let towards = DVec3::AXES[u];
        let tangent = unit(towards - ng * ng.dot(towards)).unwrap_or(towards);
        Hit {
            t: crossing.t,
            point,
            point_error: gamma(32) * along + 4.0 * self.field.rounding(point),
            ng,
            n: ng,
            tangent,
            uv: DVec2::new(share[u], share[v]),
            face,
            part: crossing.part,
        }
    }

    /// The first point that is seen along the face's axis from outside; where nothing is seen, the point of the bounds.
    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let axis = (face / 2 % 3) as usize;
        let size = self.bounds.max - self.bounds.min;
        let mut from = self.bounds.min;
        from[(axis + 1) % 3] += size[(axis + 1) % 3] * uv.x;
        from[(axis + 2) % 3] += size[(axis + 2) % 3] * uv.y;
        let mut inwards = DVec3::AXES[axis];
        from[axis] = self.around.min[axis];
        if face % 2 == 1 {
            from[axis] = self.around.max[axis];
            inwards = -inwards;
        }
        let ray = Ray::new(from, inwards);
        self.nearest(&ray, 0.0, f64::INFINITY).map_or(from, |c| ray.at(c.t))
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }
}

impl<F: DistanceField> Solid for FieldShape<F> {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        let Some(walk) = self.walk(ray, f64::NEG_INFINITY) else { return };
        let speed = walk.speed();
        let mut inside = walk.is_inside();
        let mut enter = None;
        for change in walk {
            let here = Crossing::new(change.s / speed, 0);
            inside = !inside;
            if inside {
                enter = Some(here);
            } else if let Some(enter) = enter.take()
                && enter.t < here.t
            {
                out.push(Span { enter, leave: here });
            }
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        self.field.distance(p) <= 0.0
    }
}
