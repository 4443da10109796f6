//! A shape somewhere else: moved, turned, scaled [E problem 5.2].

use super::{Shape, ShapeError, Solid};
use crate::bounds::Aabb;
use crate::frame::{normal_matrix, unit};
use crate::num::gamma;
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DAffine3, DMat3, DVec2, DVec3};

/// A shape seen through an affine map.
///
/// The ray goes to the shape's own space with its parameter unchanged: `p = o + t d` maps to
/// `M⁻¹p = M⁻¹o + t M⁻¹d`, whose direction is no unit vector, and need not be.
#[derive(Debug)]
pub struct Instance<S: ?Sized + Shape = dyn Shape> {
    to_world: DAffine3,
    to_local: DAffine3,
    /// Takes normals to the world, but for their length.
    normals: DMat3,
    /// Sum of the magnitudes of each row, the largest: how much the maps stretch a coordinate's error.
    world_stretch: f64,
    local_stretch: f64,
    /// Does the map only scale evenly and move? Then directions stay what they are, and its matrices have one number each.
    upright: bool,
    shape: Box<S>,
}

impl<S: ?Sized + Shape> Instance<S> {
    /// - Errors: a map that is not finite, or that squashes space flat.
    pub fn new(shape: Box<S>, to_world: DAffine3) -> Result<Self, ShapeError> {
        let m = to_world.matrix3;
        for column in [m.x_axis, m.y_axis, m.z_axis, to_world.translation] {
            ShapeError::finite("transformation", column)?;
        }
        let size = m.x_axis.length() * m.y_axis.length() * m.z_axis.length();
        let to_local = to_world.inverse();
        // A determinant below the rounding errors of its own six products is no determinant.
        if !(m.determinant().abs() > gamma(9) * size) || !to_local.is_finite() {
            return Err(ShapeError::Flat { what: "transformation" });
        }
        let normals = normal_matrix(&m).ok_or(ShapeError::Flat { what: "transformation" })?;
        let (world_stretch, local_stretch) = (stretch(&m), stretch(&to_local.matrix3));
        let upright = |m: &DMat3| m.x_axis.x > 0.0 && *m == DMat3::from_diagonal(DVec3::splat(m.x_axis.x));
        let upright = upright(&m) && upright(&to_local.matrix3);
        Ok(Instance { to_world, to_local, normals, world_stretch, local_stretch, upright, shape })
    }

    /// A box round the image of a box.
    fn mapped(&self, b: Aabb) -> Aabb {
        if b.is_empty() || !b.is_finite() {
            return if b.is_empty() { b } else { Aabb::EVERYTHING };
        }
        let corner = |i: usize| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { b.min[axis] } else { b.max[axis] };
            self.to_world.transform_point3(DVec3::new(pick(0), pick(1), pick(2)))
        };
        let mapped = Aabb::of_points((0..8).map(corner));
        let largest = b.min.abs().max(b.max.abs()).max_element();
        let slack = gamma(8) * (self.world_stretch * largest + self.to_world.translation.abs().max_element());
        Aabb::new(mapped.min - slack, mapped.max + slack)
    }

    #[inline]
    fn local(&self, ray: &Ray) -> Ray {
        if self.upright {
            let DAffine3 { matrix3, translation } = self.to_local;
            return Ray::new(ray.origin * matrix3.x_axis.x + translation, ray.direction * matrix3.x_axis.x);
        }
        Ray::new(self.to_local.transform_point3(ray.origin), self.to_local.transform_vector3(ray.direction))
    }
}

fn stretch(m: &DMat3) -> f64 {
    (m.x_axis.abs() + m.y_axis.abs() + m.z_axis.abs()).max_element()
}

impl<S: ?Sized + Shape> Shape for Instance<S> {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        self.shape.nearest(&self.local(ray), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        self.shape.crossings(&self.local(ray), out);
    }

    /// Besides the shape's own error, the way to the world and back rounds 8 times in each coordinate.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let local = self.shape.hit(&self.local(ray), crossing);
        let m = &self.to_world.matrix3;
        let point = self.to_world.transform_point3(local.point);
        let map_back =
            self.local_stretch * (point.abs().max_element() + self.to_world.translation.abs().max_element());
        let point_error = self.world_stretch
            * (local.point_error + gamma(8) * (local.point.abs().max_element() + map_back));
        if self.upright {
            return Hit { point, point_error, ..local };
        }
        let ng = unit(self.normals * local.ng).unwrap_or(local.ng);
        let tangent = unit(*m * local.tangent).unwrap_or(local.tangent);
        Hit {
            point,
            point_error,
            ng,
            n: if local.n == local.ng { ng } else { unit(self.normals * local.n).unwrap_or(ng) },
            tangent: unit(tangent - ng * tangent.dot(ng)).unwrap_or(tangent),
            ..local
        }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        self.to_world.transform_point3(self.shape.point_at(face, uv))
    }

    fn bounds(&self) -> Aabb {
        self.mapped(self.shape.bounds())
    }

    fn parts(&self) -> u32 {
        self.shape.parts()
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        self.shape.blocks(&self.local(ray), t_max)
    }

    fn lifted(&self, hit: &Hit, n: DVec3) -> DVec3 {
        // Normals go back with the transpose of the map, as they came with its inverse.
        let back = |n: DVec3| unit(self.to_world.matrix3.transpose() * n).unwrap_or(n);
        let point = self.to_local.transform_point3(hit.point);
        let local = Hit { point, ng: back(hit.ng), n: back(hit.n), ..*hit };
        let lifted = self.shape.lifted(&local, back(n));
        if lifted == point { hit.point } else { self.to_world.transform_point3(lifted) }
    }
}

impl<S: ?Sized + Solid> Solid for Instance<S> {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        self.shape.spans(&self.local(ray), out);
    }

    fn hull(&self) -> Aabb {
        self.mapped(self.shape.hull())
    }

    fn contains(&self, p: DVec3) -> bool {
        self.shape.contains(self.to_local.transform_point3(p))
    }
}
