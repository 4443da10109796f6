//! Solids from solids: minima and maxima of fields, smooth minima, shells and ripples.
//!
//! ```text
//! union         min(f, g)                              L = max(L_f, L_g)
//! intersection  max(f, g)                              L = max(L_f, L_g)
//! difference    max(f, −g)                             L = max(L_f, L_g)
//! smooth union  min(f, g) − h² k/4,  h = max(k − |f − g|, 0)/k        the same L
//! ```
//!
//! Signs come out right and bound (1) of [`super`] holds, but outside a union of overlapping solids only is the distance
//! exact: beside the edge of an intersection the maximum of two distances to planes is less than the distance to the edge.
//!
//! - Source: Ricci (1973); Hart (1996) §3; Quilez, *Smooth minimum* (2013).

use super::DistanceField;
use crate::bounds::Aabb;
use crate::num::gamma;
use crate::shape::ShapeError;
use glam::DVec3;

/// Inside either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Union<A, B>(pub A, pub B);

/// Inside both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intersection<A, B>(pub A, pub B);

/// Inside the first and not inside the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference<A, B>(pub A, pub B);

/// What two fields have in common, whatever is made of their values.
macro_rules! of_two {
    () => {
        fn lipschitz(&self) -> f64 {
            self.0.lipschitz().max(self.1.lipschitz())
        }
        fn scale(&self) -> f64 {
            self.0.scale().max(self.1.scale())
        }
        fn detail(&self) -> f64 {
            self.0.detail().min(self.1.detail())
        }
        fn rounding(&self, p: DVec3) -> f64 {
            self.0.rounding(p).max(self.1.rounding(p))
        }
    };
}

impl<A: DistanceField, B: DistanceField> DistanceField for Union<A, B> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        self.0.distance(p).min(self.1.distance(p))
    }
    fn bounds(&self, level: f64) -> Aabb {
        self.0.bounds(level).union(&self.1.bounds(level))
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        if self.0.distance(p) <= self.1.distance(p) { self.0.gradient(p) } else { self.1.gradient(p) }
    }
    of_two!();
}

impl<A: DistanceField, B: DistanceField> DistanceField for Intersection<A, B> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        self.0.distance(p).max(self.1.distance(p))
    }
    fn bounds(&self, level: f64) -> Aabb {
        let (a, b) = (self.0.bounds(level), self.1.bounds(level));
        Aabb::new(a.min.max(b.min), a.max.min(b.max))
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        if self.0.distance(p) >= self.1.distance(p) { self.0.gradient(p) } else { self.1.gradient(p) }
    }
    of_two!();
}

impl<A: DistanceField, B: DistanceField> DistanceField for Difference<A, B> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        self.0.distance(p).max(-self.1.distance(p))
    }
    fn bounds(&self, level: f64) -> Aabb {
        self.0.bounds(level)
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        if self.0.distance(p) >= -self.1.distance(p) { self.0.gradient(p) } else { -self.1.gradient(p) }
    }
    of_two!();
}

/// The smooth minimum of two values: at most `k/4` below the smaller, which it is where they differ by more than `k`.
///
/// - Domain: `k > 0`.
#[inline]
pub fn smooth_min(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0);
    a.min(b) - h * (h / k) * 0.25
}

/// Inside either, with a fillet where they meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothUnion<A, B>(A, B, f64);

impl<A: DistanceField, B: DistanceField> SmoothUnion<A, B> {
    /// Fields that differ by less than `k` \[m\] are blended.
    ///
    /// - Errors: a `k` that is not positive and finite.
    pub fn new(a: A, b: B, k: f64) -> Result<Self, ShapeError> {
        Ok(SmoothUnion(a, b, ShapeError::positive("reach of a smooth union", k)?))
    }
}

impl<A: DistanceField, B: DistanceField> DistanceField for SmoothUnion<A, B> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        smooth_min(self.0.distance(p), self.1.distance(p), self.2)
    }
    /// The slopes of `smin` in its two arguments lie in [0, 1] and sum to 1: `∇` is a mean of both gradients.
    fn lipschitz(&self) -> f64 {
        self.0.lipschitz().max(self.1.lipschitz())
    }
    fn bounds(&self, level: f64) -> Aabb {
        let level = level + 0.25 * self.2;
        self.0.bounds(level).union(&self.1.bounds(level))
    }
    fn scale(&self) -> f64 {
        self.0.scale().max(self.1.scale()).max(self.2)
    }
    fn detail(&self) -> f64 {
        self.0.detail().min(self.1.detail())
    }
    /// Five roundings of numbers below `k`, besides those of the arguments.
    fn rounding(&self, p: DVec3) -> f64 {
        self.0.rounding(p).max(self.1.rounding(p)) + gamma(5) * self.2
    }
}

/// A solid grown (or, for a negative length, shrunk) by a length: the inner corners of its edges are rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Offset<A>(A, f64);

impl<A: DistanceField> Offset<A> {
    /// - Errors: a length that is not finite.
    pub fn new(field: A, by: f64) -> Result<Self, ShapeError> {
        if by.is_finite() {
            Ok(Offset(field, by))
        } else {
            Err(ShapeError::NotFinite { what: "offset", found: by })
        }
    }
}

impl<A: DistanceField> DistanceField for Offset<A> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        self.0.distance(p) - self.1
    }
    fn lipschitz(&self) -> f64 {
        self.0.lipschitz()
    }
    /// A shrunk solid lies in the solid.
    fn bounds(&self, level: f64) -> Aabb {
        self.0.bounds((level + self.1).max(0.0))
    }
    fn scale(&self) -> f64 {
        self.0.scale() + self.1.abs()
    }
    fn detail(&self) -> f64 {
        if self.1 > 0.0 { self.1.min(self.0.detail()) } else { self.0.detail() }
    }
    fn rounding(&self, p: DVec3) -> f64 {
        self.0.rounding(p) + gamma(1) * (self.scale() + p.abs().element_sum())
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        self.0.gradient(p)
    }
}

/// A solid with ripples on its surface: no distance any more, and steeper than one.
///
/// ```text
/// f(p) + A sin kx sin ky sin kz,    L = L_f + A k
/// ```
///
/// The gradient of the product of sines is at most `k` long: with `u = sin²` its square over `k²` is linear in each `u`, and
/// 0 or 1 in the corners of `[0,1]³`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rippled<A> {
    field: A,
    amplitude: f64,
    frequency: f64,
}

impl<A: DistanceField> Rippled<A> {
    /// Waves of height `amplitude` \[m\], `frequency` radians a metre.
    ///
    /// - Errors: an amplitude or frequency that is not positive and finite.
    pub fn new(field: A, amplitude: f64, frequency: f64) -> Result<Self, ShapeError> {
        let amplitude = ShapeError::positive("amplitude of ripples", amplitude)?;
        Ok(Rippled { field, amplitude, frequency: ShapeError::positive("frequency of ripples", frequency)? })
    }
}

impl<A: DistanceField> DistanceField for Rippled<A> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        let waves = (p * self.frequency).to_array().map(f64::sin);
        self.field.distance(p) + self.amplitude * waves[0] * waves[1] * waves[2]
    }
    fn lipschitz(&self) -> f64 {
        self.field.lipschitz() + self.amplitude * self.frequency
    }
    fn bounds(&self, level: f64) -> Aabb {
        self.field.bounds(level + self.amplitude)
    }
    fn scale(&self) -> f64 {
        self.field.scale() + self.amplitude
    }
    fn detail(&self) -> f64 {
        self.field.detail().min(1.0 / self.frequency).min(self.amplitude)
    }
    /// The waves' phase rounds with `k p`, which the sine passes on times `A`; five more roundings.
    fn rounding(&self, p: DVec3) -> f64 {
        let phase = gamma(2) * self.frequency * p.abs().element_sum();
        self.field.rounding(p) + self.amplitude * (phase + gamma(8)) + gamma(1) * self.scale()
    }
}
