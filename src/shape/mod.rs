//! Surfaces: where a ray meets them, and what is there. One file per surface.

pub mod cone;
pub mod cove;
pub mod cuboid;
pub mod cylinder;
pub mod disc;
pub mod fan;
pub mod instance;
pub mod plane;
pub mod polygon;
pub mod polyhedron;
pub mod quadric;
pub mod sphere;
pub mod torus;
pub mod triangle;

use crate::bounds::Aabb;
use crate::frame::{basis, unit};
use crate::ray::{Crossing, Hit, Ray, Span};
use fan::Fan;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use std::fmt::Debug;
use std::sync::Arc;

/// Why a surface cannot be made from these numbers.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    #[error("{what}: expected a finite number, found {found}")]
    NotFinite { what: &'static str, found: f64 },
    #[error("{what}: expected a length above 0, found {found}")]
    NotPositive { what: &'static str, found: f64 },
    #[error("{what}: expected a length of at least 0, found {found}")]
    Negative { what: &'static str, found: f64 },
    #[error("{what}: expected a vector with a direction, found one of length 0")]
    NoDirection { what: &'static str },
    #[error("{what}: expected an area above 0, found vertices on one line")]
    NoArea { what: &'static str },
    #[error("{what}: expected at least one coefficient other than 0 beside the constant, found none")]
    NoEquation { what: &'static str },
    #[error("{what}: expected a map that keeps space three-dimensional, found one that squashes it flat")]
    Flat { what: &'static str },
    #[error("torus: expected ring radius > tube radius > 0, found ring {ring} and tube {tube}")]
    NotARing { ring: f64, tube: f64 },
    #[error("{what}: expected half-spaces with a common volume, found none")]
    NoVolume { what: &'static str },
    #[error("{what}: expected half-spaces that enclose a bounded volume, found one that runs to infinity")]
    Unbounded { what: &'static str },
    #[error("{what}: expected {allowed}, found {found}")]
    OutOfRange { what: &'static str, allowed: &'static str, found: f64 },
    #[error("polygon: expected at least 3 vertices, found {found}")]
    TooFewVertices { found: usize },
    #[error("menger: expected a depth of at most {allowed}, found {found}")]
    TooDeep { allowed: u32, found: u32 },
    #[error(
        "menger: expected cells of at least {least} m, which rounding can tell apart there, found {found} m"
    )]
    TooFine { least: f64, found: f64 },
    #[error("polygon: expected vertices within {allowed} of one plane, found one at {found}")]
    NotFlat { allowed: f64, found: f64 },
}

impl ShapeError {
    /// `v`, if its coordinates are finite.
    pub(crate) fn finite(what: &'static str, v: DVec3) -> Result<DVec3, ShapeError> {
        match v.to_array().into_iter().find(|x| !x.is_finite()) {
            Some(found) => Err(ShapeError::NotFinite { what, found }),
            None => Ok(v),
        }
    }

    /// `x`, if it is finite and above 0.
    pub(crate) fn positive(what: &'static str, x: f64) -> Result<f64, ShapeError> {
        if !x.is_finite() {
            Err(ShapeError::NotFinite { what, found: x })
        } else if x <= 0.0 {
            Err(ShapeError::NotPositive { what, found: x })
        } else {
            Ok(x)
        }
    }

    /// The unit vector along `v`, if `v` is finite and not zero.
    pub fn direction(what: &'static str, v: DVec3) -> Result<DVec3, ShapeError> {
        unit(Self::finite(what, v)?).ok_or(ShapeError::NoDirection { what })
    }
}

/// From which sides a flat surface is met.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sides {
    #[default]
    Both,
    /// Only where the ray runs against the normal: `testcull` of [A ill. 56].
    Front,
}

impl Sides {
    /// Is a surface with this normal met by a ray in this direction?
    #[inline]
    pub(crate) fn admit(self, direction: DVec3, normal: DVec3) -> bool {
        self == Sides::Both || direction.dot(normal) < 0.0
    }
}

/// The angle of `(x, y)` as a share of the full turn, in [0, 1); 0 at the pole.
pub(crate) fn turn(x: f64, y: f64) -> f64 {
    let share = y.atan2(x) / TAU;
    // −10⁻³⁰ + 1 rounds to 1: the end of the turn is its beginning.
    if share >= 0.0 { share } else { (share + 1.0) % 1.0 }
}

/// The unit vector along the part of `v` that is perpendicular to the unit vector `n`, else any perpendicular one.
pub(crate) fn perpendicular_part(v: DVec3, n: DVec3) -> DVec3 {
    unit(v - n * v.dot(n)).unwrap_or_else(|| basis(n).0)
}

/// The first of ascending crossings with `t_min < t < t_max`.
#[inline]
pub(crate) fn first_between(
    crossings: impl IntoIterator<Item = Crossing>,
    t_min: f64,
    t_max: f64,
) -> Option<Crossing> {
    crossings.into_iter().find(|c| t_min < c.t && c.t < t_max)
}

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

    /// How many parts its crossings name, from 0 on: the leaves of a compound, else one.
    fn parts(&self) -> u32 {
        1
    }

    /// Does something stand in the way for some `0 < t < t_max`?
    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        self.nearest(ray, 0.0, t_max).is_some()
    }

    /// Is a look at the box that bounds it cheaper than a test of the shape, so that it comes first?
    fn is_costly(&self) -> bool {
        true
    }

    /// Where light is gathered that a shape's smooth normals `n` (on the side that is seen) let it show: the hit's point, or a
    /// place near it from which a coarse shape does not stand in its own light.
    fn lifted(&self, hit: &Hit, _n: DVec3) -> DVec3 {
        hit.point
    }

    /// Could the shape stand in the way of some segment of a fan whose hull overlaps its bounds? A "no" is certain.
    fn may_block(&self, _fan: &Fan) -> bool {
        true
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

    /// A box that holds the solid: the [bounds](Shape::bounds) of its surface, unless the solid runs on beyond.
    fn hull(&self) -> Aabb {
        self.bounds()
    }

    /// Is the point inside or on the surface?
    fn contains(&self, p: DVec3) -> bool;
}

/// The span between two crossings; `None` where they touch, for a touch encloses nothing.
fn span_of_pair(enter: Crossing, leave: Crossing) -> Option<Span> {
    (enter.t < leave.t).then_some(Span { enter, leave })
}

/// A shape that several owners share: the instances of one mesh.
impl<S: Shape + ?Sized> Shape for Arc<S> {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        (**self).nearest(ray, t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        (**self).crossings(ray, out);
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        (**self).hit(ray, crossing)
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        (**self).point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        (**self).bounds()
    }

    fn parts(&self) -> u32 {
        (**self).parts()
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        (**self).blocks(ray, t_max)
    }

    fn is_costly(&self) -> bool {
        (**self).is_costly()
    }

    fn lifted(&self, hit: &Hit, n: DVec3) -> DVec3 {
        (**self).lifted(hit, n)
    }

    fn may_block(&self, fan: &Fan) -> bool {
        (**self).may_block(fan)
    }

    fn shade(&self, fan: &Fan, lit: &mut [f64]) {
        (**self).shade(fan, lit);
    }
}

impl<S: Solid + ?Sized> Solid for Arc<S> {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        (**self).spans(ray, out);
    }

    fn hull(&self) -> Aabb {
        (**self).hull()
    }

    fn contains(&self, p: DVec3) -> bool {
        (**self).contains(p)
    }
}
