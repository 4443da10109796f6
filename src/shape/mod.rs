//! Surfaces: where a ray meets them, and what is there. One file per surface.

pub mod cuboid;
pub mod fan;
pub mod instance;
pub mod sphere;
pub mod torus;

use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray, Span};
use fan::Fan;
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

    /// Could the shape stand in the way of some segment of the fan? A "no" is certain.
    fn may_block(&self, fan: &Fan) -> bool {
        self.bounds().overlaps(&fan.hull)
    }

    /// Puts 0 into `lit[i]` for every segment `i` of the fan that the shape [blocks](Shape::blocks).
    /// `lit` has the fan's padded length.
    fn shade(&self, fan: &Fan, lit: &mut [f64]) {
        for (i, lit) in lit.iter_mut().enumerate().take(fan.len()) {
            if *lit != 0.0 && self.blocks(&Ray::new(fan.origin, fan.direction(i)), 1.0) {
                *lit = 0.0;
            }
        }
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

/// Why there is no such shape.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    #[error("{what} must be positive and finite, found {found}")]
    NotPositive { what: &'static str, found: f64 },
    #[error("{what} must be finite, found {found}")]
    NotFinite { what: &'static str, found: DVec3 },
    #[error("{what} must not be degenerate: {why}")]
    Degenerate { what: &'static str, why: &'static str },
}

impl ShapeError {
    fn check_positive(what: &'static str, found: f64) -> Result<(), Self> {
        if found > 0.0 && found.is_finite() { Ok(()) } else { Err(Self::NotPositive { what, found }) }
    }

    fn check_finite(what: &'static str, found: DVec3) -> Result<(), Self> {
        if found.is_finite() { Ok(()) } else { Err(Self::NotFinite { what, found }) }
    }
}

/// The span between two crossings; `None` where they touch, for a touch encloses nothing.
fn span_of_pair(enter: Crossing, leave: Crossing) -> Option<Span> {
    (enter.t < leave.t).then_some(Span { enter, leave })
}
