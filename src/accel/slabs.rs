//! A ray against boxes in `f64`, one at a time, and against balls.

use crate::bounds::Aabb;
use crate::ray::Ray;
use glam::DVec3;

/// A ray prepared for boxes: whatever they are, and wherever it runs, none that it meets is missed.
///
/// ```text
/// near = max (x₀ − o)/d,   far = min (x₁ − o)/d        over the three axes
/// ```
///
/// A ray in a face of a box would make `0/0`, and one parallel to it `±∞`: so coordinates of the direction are at
/// least `2⁻⁶⁰` of the largest, which moves no ray farther than its origin is displaced to cover all roundings.
///
/// - Source: Ize, *Robust BVH ray traversal*, JCGT 2(2) (2013), for the widening.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slabs {
    near_origin: DVec3,
    far_origin: DVec3,
    inverse: DVec3,
}

/// Share of the largest coordinate by which the origin is displaced: more than `γ` of any shape's test.
const DISPLACED: f64 = 1.0 / (1u64 << 48) as f64;
const STEEPEST: f64 = 1.0 / (1u64 << 60) as f64;
/// Tests may err in `t` by this share of the way.
pub(super) const LENGTHENED: f64 = 1.0 / (1u64 << 40) as f64;

impl Slabs {
    /// For boxes within `whole`.
    pub fn new(ray: &Ray, whole: &Aabb) -> Self {
        let d = ray.direction;
        let least = d.abs().max_element() * STEEPEST;
        let steep = |x: f64| if x.abs() < least { least.copysign(x) } else { x };
        let inverse = DVec3::new(1.0 / steep(d.x), 1.0 / steep(d.y), 1.0 / steep(d.z));
        let far = whole.min.abs().max(whole.max.abs()).max_element();
        let back = inverse.signum() * ((ray.origin.abs().max_element() + far) * DISPLACED);
        Slabs { near_origin: ray.origin + back, far_origin: ray.origin - back, inverse }
    }

    /// Where the ray enters the box, if it does so before `t_max` and leaves it after `t_min`.
    #[inline]
    pub fn enter(&self, b: &Aabb, t_min: f64, t_max: f64) -> Option<f64> {
        let (mut near, mut far) = (t_min - t_min.abs() * LENGTHENED, t_max + t_max.abs() * LENGTHENED);
        for i in 0..3 {
            let (first, last) =
                if self.inverse[i] < 0.0 { (b.max[i], b.min[i]) } else { (b.min[i], b.max[i]) };
            // `max` and `min` disregard NaN, which infinities could still make: the box then counts as met.
            near = near.max((first - self.near_origin[i]) * self.inverse[i]);
            far = far.min((last - self.far_origin[i]) * self.inverse[i]);
        }
        (near <= far + far.abs() * LENGTHENED).then_some(near)
    }
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub center: DVec3,
    pub radius: f64,
}

impl Ball {
    /// The ball round a box.
    pub fn around(b: &Aabb) -> Self {
        let half = (b.max - b.min) * 0.5;
        // Rounded up: three products, two sums, a root, and the centre's own two roundings.
        let radius = half.length() * (1.0 + LENGTHENED) + b.center().abs().max_element() * DISPLACED;
        Ball { center: b.center(), radius }
    }

    /// May the ray meet the ball between `t_min` and `t_max`? A "no" is certain.
    #[inline]
    pub fn may_meet(&self, ray: &Ray, t_min: f64, t_max: f64) -> bool {
        let to = self.center - ray.origin;
        let d2 = ray.direction.length_squared();
        let t = to.dot(ray.direction) / d2;
        let reach = self.radius + (ray.origin.abs() + self.center.abs()).max_element() * (8.0 * DISPLACED);
        let aside = (to - ray.direction * t).length_squared();
        let along = reach / d2.sqrt();
        let slack = LENGTHENED * (t.abs() + along);
        // A NaN is no "no".
        !(aside > reach * reach || t - along - slack > t_max || t + along + slack < t_min)
    }
}
