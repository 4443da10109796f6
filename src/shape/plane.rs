//! The plane through a point, perpendicular to a vector [B §6.3, A §2.3].
//!
//! ```text
//! n · (p − p₀) = 0        t = n · (p₀ − o) / n · d
//! ```

use super::{Shape, ShapeError, Sides, Solid, basis, first_between};
use crate::bounds::Aabb;
use crate::num::certified::{Bounded, Scalar, Uncertain, Vector, power_of_two_below};
use crate::num::double_double::DoubleDouble;
use crate::num::{U, gamma};
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DVec2, DVec3};

/// An unbounded plane; as a [`Solid`], everything behind it.
///
/// Texture coordinates are lengths along the tangent and along `ng × tangent` from the plane's point;
/// they are not confined to `[0,1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    point: DVec3,
    /// As given, times a power of two: a ray along integer vectors is exactly parallel or exactly not.
    across: DVec3,
    normal: DVec3,
    tangent: DVec3,
    sides: Sides,
}

impl Plane {
    /// The plane through `point` with the outward `normal`, of any length but zero.
    pub fn new(point: DVec3, normal: DVec3) -> Result<Self, ShapeError> {
        let unit = ShapeError::direction("normal of a plane", normal)?;
        let point = ShapeError::finite("point of a plane", point)?;
        let across = normal / power_of_two_below(normal.abs().max_element());
        Ok(Plane { point, across, normal: unit, tangent: basis(unit).0, sides: Sides::Both })
    }

    pub fn with_sides(self, sides: Sides) -> Self {
        Plane { sides, ..self }
    }

    /// A point of the plane.
    pub fn point(&self) -> DVec3 {
        self.point
    }

    /// The outward normal, a unit vector.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Where the line of the ray crosses the plane, at any sign of `t`; `None` if it is exactly parallel.
    ///
    /// - Accuracy: relative error at most `64 u`, whatever cancels.
    pub fn meeting(&self, ray: &Ray) -> Option<f64> {
        if !self.sides.admit(ray.direction, self.across) {
            return None;
        }
        if let Some(t) = self.plainly(ray) {
            return Some(t);
        }
        quotient::<Bounded>(self.point, self.across, ray)
            .or_else(|Uncertain| quotient::<DoubleDouble>(self.point, self.across, ray))
            .unwrap_or(None)
            .filter(|&t| ray.at(t).is_finite())
    }

    /// `n · (p₀ − o) / n · d` where little cancels: sums of at least an eighth of their absolute terms.
    ///
    /// Three roundings in `n · d` and four in `n · (p₀ − o)` are then at most 24 u and 32 u of them, and the
    /// quotient rounds once: 57 u.
    #[inline]
    fn plainly(&self, ray: &Ray) -> Option<f64> {
        let along = self.across * ray.direction;
        let ahead = self.across * (self.point - ray.origin);
        let (below, above) = (along.element_sum(), ahead.element_sum());
        let clear = (8.0 * below.abs() >= along.abs().element_sum())
            & (8.0 * above.abs() >= ahead.abs().element_sum())
            & (below.abs().min(above.abs()) > f64::MIN_POSITIVE);
        let t = above / below;
        (clear && ray.at(t).is_finite()).then_some(t)
    }

    /// The hit at `t`, with coordinates in the plane: what flat surfaces share.
    ///
    /// `o + t d` is brought back onto the plane. Rounding bound of its distance from the plane: `p − p₀`
    /// (1 rounding), its product with the rounded unit normal (3, and 4 of the normal), times the normal
    /// (1 and 4), all relative to `|p − p₀|`, and the last subtraction, `u |p|` in each coordinate. A plane through the world's
    /// origin, met just there, would have no error at all, and a ray that leaves would start in it: `u²` of the ray's own
    /// origin, which nothing else can see, takes it off.
    pub(crate) fn flat_hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let p = ray.at(crossing.t);
        let from = p - self.point;
        let point = p - self.normal * from.dot(self.normal);
        let from = point - self.point;
        let spread = (p - self.point).abs().element_sum();
        Hit {
            t: crossing.t,
            point,
            point_error: gamma(13) * spread
                + 2.0 * U * point.abs().max_element()
                + U * U * ray.origin.abs().max_element(),
            ng: self.normal,
            n: self.normal,
            tangent: self.tangent,
            uv: DVec2::new(from.dot(self.tangent), from.dot(self.bitangent())),
            face: crossing.face,
            part: crossing.part,
        }
    }

    /// The normal as given, times a power of two.
    pub(crate) fn across(&self) -> DVec3 {
        self.across
    }

    pub(crate) fn tangent(&self) -> DVec3 {
        self.tangent
    }

    pub(crate) fn bitangent(&self) -> DVec3 {
        self.normal.cross(self.tangent)
    }
}

/// `n · (p₀ − o) / n · d`, `None` if the denominator is zero.
fn quotient<T: Scalar>(point: DVec3, across: DVec3, ray: &Ray) -> Result<Option<f64>, Uncertain> {
    let n = Vector::<T>::of(across);
    let along = n.dot(Vector::of(ray.direction));
    if along.sign()? == 0 {
        return Ok(None);
    }
    let ahead = n.dot(Vector::difference(point, ray.origin));
    (ahead / along).settled().map(Some)
}

impl Shape for Plane {
    fn is_costly(&self) -> bool {
        false
    }

    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        first_between(self.meeting(ray).map(|t| Crossing::new(t, 0)), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, 0.0, f64::INFINITY));
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        self.flat_hit(ray, crossing)
    }

    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        self.point + self.tangent * uv.x + self.bitangent() * uv.y
    }

    fn bounds(&self) -> Aabb {
        let (mut min, mut max) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
        for axis in 0..3 {
            // Flat along one axis: the other two coordinates of the normal are exactly zero.
            if self.across[(axis + 1) % 3] == 0.0 && self.across[(axis + 2) % 3] == 0.0 {
                min[axis] = self.point[axis];
                max[axis] = self.point[axis];
            }
        }
        Aabb::new(min, max)
    }
}

impl Solid for Plane {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        let end = |t| Crossing::new(t, 0);
        let (never, always) = (end(f64::NEG_INFINITY), end(f64::INFINITY));
        match self.with_sides(Sides::Both).meeting(ray) {
            Some(t) if ray.direction.dot(self.across) < 0.0 => {
                out.push(Span { enter: end(t), leave: always })
            }
            Some(t) => out.push(Span { enter: never, leave: end(t) }),
            None if self.contains(ray.origin) => out.push(Span { enter: never, leave: always }),
            None => {}
        }
    }

    /// Everything behind the plane, by coordinates if it stands square to an axis.
    fn hull(&self) -> Aabb {
        let flat = self.bounds();
        let (mut min, mut max) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
        for axis in (0..3).filter(|&axis| flat.min[axis] == flat.max[axis]) {
            if self.across[axis] > 0.0 {
                max[axis] = flat.max[axis];
            } else {
                min[axis] = flat.min[axis];
            }
        }
        Aabb::new(min, max)
    }

    fn contains(&self, p: DVec3) -> bool {
        fn side<T: Scalar>(plane: &Plane, p: DVec3) -> Result<i8, Uncertain> {
            Vector::<T>::of(plane.across).dot(Vector::difference(p, plane.point)).sign()
        }
        side::<Bounded>(self, p).or_else(|Uncertain| side::<DoubleDouble>(self, p)).is_ok_and(|s| s <= 0)
    }
}
