//! Boxes that bound things.

use glam::DVec3;

/// An axis-aligned box, closed; empty if some `min` exceeds its `max`. Faces may be infinitely far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    pub min: DVec3,
    pub max: DVec3,
}

impl Aabb {
    /// The box that holds nothing: the neutral element of [`Aabb::union`].
    pub const EMPTY: Aabb = Aabb { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
    /// The box that holds everything.
    pub const EVERYTHING: Aabb = Aabb { min: DVec3::NEG_INFINITY, max: DVec3::INFINITY };

    pub fn new(min: DVec3, max: DVec3) -> Self {
        Aabb { min, max }
    }

    pub fn of_points(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Aabb { min: b.min.min(p), max: b.max.max(p) })
    }

    pub fn union(&self, other: &Aabb) -> Self {
        Aabb { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    pub fn center(&self) -> DVec3 {
        self.min + (self.max - self.min) * 0.5
    }

    pub fn contains(&self, p: DVec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// Do the closed boxes share a point?
    #[inline]
    pub fn overlaps(&self, other: &Aabb) -> bool {
        self.min.cmple(other.max).all() && self.max.cmpge(other.min).all()
    }

    /// The stretch `[t0, t1]` of the line `origin + t d`, given `1/d`, in the box by slabs, clipped to `[t_min, t_max]`.
    ///
    /// A ray parallel to a slab and inside it gives −∞…∞ there; on the slab's face `0·∞ = NaN` would
    /// arise, and such a ray counts as inside: the comparisons below discard NaN in the ray's
    /// favour, so that a bound never loses a hit. Roundings may shave the ends, so the exit is
    /// widened by 2γ₃ of itself (three roundings in each `(x − o)·(1/d)`), also where it lies behind the origin.
    ///
    /// - Source: Ize, *Robust BVH Ray Traversal*, JCGT 2(2) (2013).
    #[inline]
    pub fn slab(&self, origin: DVec3, inv_direction: DVec3, t_min: f64, t_max: f64) -> Option<(f64, f64)> {
        const WIDEN: f64 = 2.0 * crate::num::gamma(3);
        let (mut t0, mut t1) = (t_min, t_max);
        for axis in 0..3 {
            let a = (self.min[axis] - origin[axis]) * inv_direction[axis];
            let b = (self.max[axis] - origin[axis]) * inv_direction[axis];
            let (near, far) = if inv_direction[axis] < 0.0 { (b, a) } else { (a, b) };
            if near > t0 {
                t0 = near;
            }
            let far = far + far.abs() * WIDEN;
            if far < t1 {
                t1 = far;
            }
            // Most boxes are missed by their first slab or two.
            if !(t0 <= t1) {
                return None;
            }
        }
        Some((t0, t1))
    }
}
