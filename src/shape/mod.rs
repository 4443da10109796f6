//! Surfaces: where a ray meets them, and what is there. One file per surface.

pub mod torus;

use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DVec2, DVec3};
use std::fmt::Debug;

/// A surface that rays meet.
///
/// Directions may have any length but zero; `t` counts their lengths. For finite input no answer holds NaN.
pub trait Shape: Debug + Send + Sync {
    /// The first crossing with `t_min < t < t_max`.
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing>;

    /// Appends every crossing with `t > 0`, in ascending order; a touch without crossing counts once.
    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>);

    /// Describes a crossing that this shape reported for this ray.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit;

    /// The point with texture coordinates `uv` on a face; the inverse of [`Hit::uv`].
    fn point_at(&self, face: u32, uv: DVec2) -> DVec3;

    /// A box that holds the surface, rounded outwards; infinite for unbounded surfaces.
    fn bounds(&self) -> Aabb;

    /// Does something stand in the way for some `0 < t < t_max`?
    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        self.nearest(ray, 0.0, t_max).is_some()
    }
}

/// A surface that encloses a solid.
pub trait Solid: Shape {
    /// Appends the stretches of the whole line (any sign of `t`) that lie inside, sorted and
    /// disjoint. A tangent touch is no stretch.
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>);

    /// Is the point inside or on the surface?
    fn contains(&self, p: DVec3) -> bool;
}
