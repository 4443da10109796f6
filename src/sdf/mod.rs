//! Distance fields, and rays that march through them [E §2.2].
//!
//! A field `f` gives each point of space a number: positive outside a solid, negative inside, 0 on its surface. If it
//! nowhere changes faster than `L` times the distance walked (Lipschitz), the ball of radius `|f(p)|/L`
//! around `p` holds no point of the surface, and a ray may leap to the edge of that ball without looking:
//!
//! ```text
//! |f(p) − f(q)| ≤ L |p − q|     ⇒     distance from p to the surface ≥ |f(p)|/L              (1)
//! ```
//!
//! The exact signed distance has `L = 1` and equality in (1). Minima and maxima of fields keep the larger
//! of their `L`, so that solids combine ([`combine`]); the distances they give are bounds, no longer exact.
//!
//! The shapes of [`crate::shape`] are fields too: [`primitive`] gives them their distances. So the same object is met by
//! its formula and by marching, and one is measured against the other.
//!
//! - Source: Hart, *Sphere tracing*, The Visual Computer 12 (1996).

pub mod capsule;
pub mod combine;
pub mod general;
pub mod julia;
pub mod march;
pub mod menger;
pub mod placed;
pub mod primitive;
pub mod printed;
pub mod shape;

pub use march::{March, Marched, Stride};
pub use menger::Menger;
pub use shape::FieldShape;

use crate::bounds::Aabb;
use crate::num::gamma;
use glam::DVec3;
use std::fmt::Debug;

/// A scalar field, positive outside a solid and negative inside, that changes at most at a known rate.
pub trait DistanceField: Debug + Send + Sync {
    /// The field at a point \[m\]; for an exact field the signed distance to the surface.
    fn distance(&self, p: DVec3) -> f64;

    /// `L` of (1): 1 for distances and whatever is made of them by minima and maxima.
    fn lipschitz(&self) -> f64 {
        1.0
    }

    /// A box that holds every point where the field is at most `level` ≥ 0: at 0 the solid itself.
    fn bounds(&self, level: f64) -> Aabb;

    /// Largest length or coordinate \[m\] that goes into the field's numbers: what its rounding errors are measured by.
    fn scale(&self) -> f64;

    /// The smallest length \[m\] on which the surface has features.
    fn detail(&self) -> f64;

    /// Bound on the error of [`DistanceField::distance`] at `p` by rounding \[m\].
    ///
    /// The fields of this module round at most 32 times, relative to the largest of their terms.
    fn rounding(&self, p: DVec3) -> f64 {
        gamma(32) * self.lipschitz() * (p.abs().element_sum() + self.scale())
    }

    /// The direction of growing distance, of any length, by central differences.
    ///
    /// ```text
    /// gᵢ = (f(p + h eᵢ) − f(p − h eᵢ)) / 2h,    h = ∛u · detail
    /// ```
    ///
    /// - Accuracy: truncation `h² f‴/6` and rounding `u · scale / h` meet at about `∛u²`, 10 digits, when scale and
    ///   detail are alike. At an edge it is a mean of the sides.
    fn gradient(&self, p: DVec3) -> DVec3 {
        central_difference(self, p, DIFFERENCE * self.detail())
    }
}

/// `∛u`, the share of the surface's detail at which truncation and rounding of a central difference meet.
const DIFFERENCE: f64 = 4.8e-6;

/// The gradient by central differences at a step `h` \[m\].
///
/// The steps that were really made, `(x + h) − (x − h)`, divide: far from the origin `h` itself is rounded.
pub fn central_difference(field: &(impl DistanceField + ?Sized), p: DVec3, h: f64) -> DVec3 {
    let slope = |axis: usize| {
        let (mut ahead, mut behind) = (p, p);
        ahead[axis] += h;
        behind[axis] -= h;
        let step = ahead[axis] - behind[axis];
        if step > 0.0 { (field.distance(ahead) - field.distance(behind)) / step } else { 0.0 }
    };
    DVec3::new(slope(0), slope(1), slope(2))
}

/// What points at a field is one.
macro_rules! of_the_pointed {
    ($pointer:ty) => {
        impl<F: DistanceField + ?Sized> DistanceField for $pointer {
            fn distance(&self, p: DVec3) -> f64 {
                (**self).distance(p)
            }
            fn lipschitz(&self) -> f64 {
                (**self).lipschitz()
            }
            fn bounds(&self, level: f64) -> Aabb {
                (**self).bounds(level)
            }
            fn scale(&self) -> f64 {
                (**self).scale()
            }
            fn detail(&self) -> f64 {
                (**self).detail()
            }
            fn rounding(&self, p: DVec3) -> f64 {
                (**self).rounding(p)
            }
            fn gradient(&self, p: DVec3) -> DVec3 {
                (**self).gradient(p)
            }
        }
    };
}

of_the_pointed!(&F);
of_the_pointed!(Box<F>);

/// A box with all its faces moved outwards by `by`, and rounded outwards.
fn grown(b: &Aabb, by: f64) -> Aabb {
    let size = |x: f64| if x.is_finite() { gamma(4) * (x.abs() + by) } else { 0.0 };
    Aabb::new(
        DVec3::from_array(b.min.to_array().map(|x| x - by - size(x))),
        DVec3::from_array(b.max.to_array().map(|x| x + by + size(x))),
    )
}

/// The largest finite coordinate of a box.
fn reach(b: &Aabb) -> f64 {
    let all = b.min.to_array().into_iter().chain(b.max.to_array());
    all.filter(|x| x.is_finite()).map(f64::abs).fold(0.0, f64::max)
}
