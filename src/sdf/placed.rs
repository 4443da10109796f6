//! A field somewhere else: turned, moved, and scaled alike in all directions. Stretching one axis more than another
//! would spoil the distances.

use super::DistanceField;
use crate::bounds::Aabb;
use crate::num::gamma;
use crate::shape::ShapeError;
use glam::{DMat3, DVec3};

/// A field under a rotation, a scale and a shift: `p = R (s q) + m`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed<A> {
    field: A,
    turn: DMat3,
    back: DMat3,
    scale: f64,
    shift: DVec3,
}

impl<A: DistanceField> Placed<A> {
    /// - Errors: numbers that are not finite, a scale that is not positive, a matrix that is no rotation.
    pub fn new(field: A, turn: DMat3, scale: f64, shift: DVec3) -> Result<Self, ShapeError> {
        let scale = ShapeError::positive("scale", scale)?;
        let shift = ShapeError::finite("translation", shift)?;
        let back = turn.transpose();
        // A matrix of rounded unit columns turns back within six roundings of each entry.
        let off = turn * back - DMat3::IDENTITY;
        let far = off.to_cols_array().into_iter().any(|x| !(x.abs() <= gamma(16)));
        if far {
            Err(ShapeError::Flat { what: "rotation" })
        } else {
            Ok(Placed { field, turn, back, scale, shift })
        }
    }
}

impl<A: DistanceField> DistanceField for Placed<A> {
    #[inline]
    fn distance(&self, p: DVec3) -> f64 {
        self.field.distance(self.back * (p - self.shift) / self.scale) * self.scale
    }
    /// The rounded rotation stretches by γ₁₆ at most.
    fn lipschitz(&self) -> f64 {
        self.field.lipschitz() * (1.0 + gamma(32))
    }
    fn bounds(&self, level: f64) -> Aabb {
        let b = self.field.bounds(level / self.scale);
        if b.is_empty() || !b.is_finite() {
            return if b.is_empty() { b } else { Aabb::EVERYTHING };
        }
        let (middle, half) = (b.center(), (b.max - b.min) * (0.5 + gamma(4)));
        let m = self.turn;
        let reach =
            (m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z) * self.scale;
        let middle = m * middle * self.scale + self.shift;
        let slack = gamma(16) * (reach.max_element() + self.scale() + level);
        Aabb::new(middle - reach - slack, middle + reach + slack)
    }
    fn scale(&self) -> f64 {
        self.field.scale() * self.scale + self.shift.abs().element_sum()
    }
    fn detail(&self) -> f64 {
        self.field.detail() * self.scale
    }
    /// The field's own, and eight roundings of the way to it.
    fn rounding(&self, p: DVec3) -> f64 {
        let q = (p - self.shift).abs().element_sum();
        let way =
            gamma(8) * self.field.lipschitz() * (p.abs().element_sum() + self.shift.abs().element_sum());
        self.field.rounding(DVec3::splat(q / self.scale)) * self.scale + way
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        self.turn * self.field.gradient(self.back * (p - self.shift) / self.scale)
    }
}
