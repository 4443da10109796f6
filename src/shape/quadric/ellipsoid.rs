//! The ellipsoid with axes along the coordinates, as a sphere in coordinates of its own [A (2.6)].

use crate::bounds::Aabb;
use crate::num::certified::{
    Bounded, Roots, Scalar, Uncertain, Vector, no_root_ahead, power_of_two_below, solve_quadratic,
};
use crate::num::double_double::DoubleDouble;
use crate::num::{U, gamma};
use crate::ray::{Crossing, Hit, Ray, Span};
use crate::shape::{Shape, ShapeError, Solid, first_between, perpendicular_part, turn, unit};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// `(x−l)²/a² + (y−m)²/b² + (z−n)²/c² = 1`, a closed solid.
///
/// Texture coordinates: `u` the angle about +y from +x towards −z as a share of the turn, `v` the angle from
/// the pole at −y as a share of the half turn, both on the sphere that is stretched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    center: DVec3,
    semi_axes: DVec3,
}

impl Ellipsoid {
    pub fn new(center: DVec3, semi_axes: DVec3) -> Result<Self, ShapeError> {
        for axis in semi_axes.to_array() {
            ShapeError::positive("semi-axis of an ellipsoid", axis)?;
        }
        Ok(Ellipsoid { center: ShapeError::finite("center of an ellipsoid", center)?, semi_axes })
    }

    pub fn center(&self) -> DVec3 {
        self.center
    }

    pub fn semi_axes(&self) -> DVec3 {
        self.semi_axes
    }

    /// All crossings on the line, ascending; one for a touch.
    ///
    /// - Accuracy: `t` within `64 u |t|`.
    pub fn line(&self, ray: &Ray) -> ArrayVec<Crossing, 2> {
        let unit = power_of_two_below(self.semi_axes.max_element());
        let length = power_of_two_below(ray.direction.abs().max_element());
        let small = Ellipsoid { center: self.center / unit, semi_axes: self.semi_axes / unit };
        let (o, d) = (ray.origin / unit, ray.direction / length);
        let roots = small.roots::<Bounded>(o, d).or_else(|Uncertain| small.roots::<DoubleDouble>(o, d));
        let scaled = roots.unwrap_or_default().into_iter().map(|t| t * unit / length);
        scaled.filter(|t| t.is_finite()).map(|t| Crossing::new(t, 0)).collect()
    }

    /// Does the ray certainly not meet the surface at any `t > 0`?
    ///
    /// In `d/a` and `(o−l)/a` stand 1 and 2 roundings a coordinate, in the three products with their sums 3 more, in
    /// the last difference one: 9 u of the sums of the absolute values at most.
    fn is_behind_or_beside(&self, ray: &Ray) -> bool {
        let unit = power_of_two_below(self.semi_axes.max_element());
        let length = power_of_two_below(ray.direction.abs().max_element());
        let (w, d) =
            ((ray.origin - self.center) / self.semi_axes, ray.direction / (self.semi_axes / unit) / length);
        let bounded = |value: f64, size: f64| Bounded::within(value, gamma(9) * size);
        let (a, c) = (d.length_squared(), w.length_squared());
        let abc = [bounded(a, a), bounded(w.dot(d), w.abs().dot(d.abs())), bounded(c - 1.0, c + 1.0)];
        no_root_ahead(abc, || side::<DoubleDouble>(ray.origin, self).unwrap_or(0))
    }

    fn roots<T: Scalar>(&self, o: DVec3, d: DVec3) -> Result<ArrayVec<f64, 2>, Uncertain> {
        let per_axis = self.semi_axes.to_array().map(|a| T::of(1.0) / T::of(a));
        let squeezed =
            |v: Vector<T>| Vector([v.0[0] * per_axis[0], v.0[1] * per_axis[1], v.0[2] * per_axis[2]]);
        let (rough_o, rough_d) = ((o - self.center) / self.semi_axes, d / self.semi_axes);
        let t = -rough_o.dot(rough_d) / rough_d.dot(rough_d);
        let t = if t.is_finite() { t } else { 0.0 };
        let w = squeezed(Vector::difference(o, self.center) + Vector::along(d, t));
        let d = squeezed(Vector::of(d));
        let middle = T::of(t);
        let mut found = ArrayVec::new();
        match solve_quadratic(d.dot(d), w.dot(d), w.dot(w) - T::of(1.0))? {
            Roots::None => {}
            Roots::One(t) => found.push((middle + t).settled()?),
            Roots::Two(t0, t1) => found.extend([(middle + t0).settled()?, (middle + t1).settled()?]),
        }
        Ok(found)
    }
}

impl Shape for Ellipsoid {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        if t_min >= 0.0 && self.is_behind_or_beside(ray) {
            return None;
        }
        first_between(self.line(ray), t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.line(ray).into_iter().filter(|c| c.t > 0.0));
    }

    /// The point is put back onto the sphere that is stretched: a unit vector errs by 4 u in each coordinate.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let w = (ray.origin - self.center) + ray.direction * crossing.t;
        let on_sphere = unit(w / self.semi_axes).unwrap_or(DVec3::Y);
        let point = self.center + on_sphere * self.semi_axes;
        let ng = unit(on_sphere / self.semi_axes).unwrap_or(on_sphere);
        let around = DVec3::new(on_sphere.z * self.semi_axes.x, 0.0, -on_sphere.x * self.semi_axes.z);
        let u = turn(on_sphere.x, -on_sphere.z);
        let v = on_sphere.x.hypot(on_sphere.z).atan2(-on_sphere.y) / PI;
        Hit {
            t: crossing.t,
            point,
            point_error: gamma(6) * self.semi_axes.length() + 2.0 * U * point.abs().max_element(),
            ng,
            n: ng,
            tangent: perpendicular_part(around, ng),
            uv: DVec2::new(u, v.clamp(0.0, 1.0)),
            face: crossing.face,
            part: crossing.part,
        }
    }

    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        let ((sin_u, cos_u), (sin_v, cos_v)) = ((uv.x * TAU).sin_cos(), (uv.y * PI).sin_cos());
        self.center + self.semi_axes * DVec3::new(sin_v * cos_u, -cos_v, -sin_v * sin_u)
    }

    fn bounds(&self) -> Aabb {
        let (low, high) = (self.center - self.semi_axes, self.center + self.semi_axes);
        Aabb::new(
            DVec3::from_array(low.to_array().map(f64::next_down)),
            DVec3::from_array(high.to_array().map(f64::next_up)),
        )
    }
}

impl Solid for Ellipsoid {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        if let [enter, leave] = self.line(ray)[..]
            && enter.t < leave.t
        {
            out.push(Span { enter, leave });
        }
    }

    fn contains(&self, p: DVec3) -> bool {
        side::<Bounded>(p, self)
            .or_else(|Uncertain| side::<DoubleDouble>(p, self))
            .is_ok_and(|side| side <= 0)
    }
}

/// −1 inside, 0 on the surface, 1 outside.
fn side<T: Scalar>(p: DVec3, ellipsoid: &Ellipsoid) -> Result<i8, Uncertain> {
    let (w, a) = (Vector::<T>::difference(p, ellipsoid.center).0, ellipsoid.semi_axes.to_array().map(T::of));
    let w = Vector([w[0] / a[0], w[1] / a[1], w[2] / a[2]]);
    (w.dot(w) - T::of(1.0)).sign()
}
