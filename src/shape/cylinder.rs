//! The cylinder between two points [B §6.5, D §4.7.3, §5.9.1.3, E problem 5.3], solid or an open tube.
//!
//! ```text
//! |(p − p₀) × â| = r,    0 ≤ (p − p₀) · â ≤ |p₁ − p₀|
//! ```
//!
//! It is the [`Cone`] whose radius does not change. Faces: 0 the side, 1 the cap at `p₀`, 2 the cap at `p₁`.

use super::cone::{Cone, Ends};
use super::{Shape, ShapeError, Solid};
use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray, Span};
use glam::{DVec2, DVec3};

/// A cylinder of one radius around the segment from `p0` to `p1`.
///
/// Texture coordinates: on the side `u` the angle as a share of the turn, `v` the height as a share of the
/// axis; on the caps `u` the angle, `v` the distance from the axis over the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder(Cone);

impl Cylinder {
    /// The capped cylinder around the segment from `p0` to `p1`.
    pub fn new(p0: DVec3, p1: DVec3, radius: f64) -> Result<Self, ShapeError> {
        let radius = ShapeError::positive("radius of a cylinder", radius)?;
        Ok(Cylinder(Cone::new(p0, p1, radius, radius)?))
    }

    /// The cylinder of a given height above its base [D §4.7.3]; `axis` may have any length but zero.
    pub fn upon(base: DVec3, axis: DVec3, height: f64, radius: f64) -> Result<Self, ShapeError> {
        let height = ShapeError::positive("height of a cylinder", height)?;
        Self::new(base, base + ShapeError::direction("axis of a cylinder", axis)? * height, radius)
    }

    pub fn with_ends(self, ends: Ends) -> Self {
        Cylinder(self.0.with_ends(ends))
    }

    pub fn p0(&self) -> DVec3 {
        self.0.p0()
    }

    pub fn p1(&self) -> DVec3 {
        self.0.p1()
    }

    /// The unit vector from `p0` to `p1`.
    pub fn axis(&self) -> DVec3 {
        self.0.axis()
    }

    /// Distance from `p0` to `p1`.
    pub fn height(&self) -> f64 {
        self.0.height()
    }

    pub fn radius(&self) -> f64 {
        self.0.r0()
    }

    /// The stretch of the ray's whole line inside the capped cylinder; of length 0 for a touch.
    pub fn span(&self, ray: &Ray) -> Option<Span> {
        self.0.span(ray)
    }
}

impl Shape for Cylinder {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        self.0.nearest(ray, t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        self.0.crossings(ray, out);
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        self.0.hit(ray, crossing)
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        self.0.point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        self.0.bounds()
    }
}

impl Solid for Cylinder {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        self.0.spans(ray, out);
    }

    fn contains(&self, p: DVec3) -> bool {
        self.0.contains(p)
    }
}

/// Where the ray enters or first meets the side or a cap, by the formulas that B prints.
///
/// ```text
/// A t² + B t + C = 0,  A = |v − (v·vₐ)vₐ|²,  B = 2 (v − (v·vₐ)vₐ)·(Δp − (Δp·vₐ)vₐ),  C = |Δp − (Δp·vₐ)vₐ|² − r²
/// ```
///
/// - Domain: `None` is a miss; faces as of [`Cylinder`].
/// - Accuracy: loses all digits at distance/radius 10⁸.
/// - Source: [B §6.5.1], with either reading of its condition at the far end.
pub fn textbook(p0: DVec3, p1: DVec3, radius: f64, far_end: FarEnd, ray: &Ray) -> Vec<Crossing> {
    let axis = (p1 - p0).normalize_or_zero();
    let across = |v: DVec3| v - axis * v.dot(axis);
    let (v, dp) = (across(ray.direction), across(ray.origin - p0));
    let (a, b, c) = (v.dot(v), 2.0 * v.dot(dp), dp.dot(dp) - radius * radius);
    let root = (b * b - 4.0 * a * c).sqrt();
    let mut found = Vec::new();
    for t in [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)] {
        let q = ray.at(t);
        let past_far_end = axis.dot(q - p1);
        let kept = match far_end {
            FarEnd::AsPrinted => past_far_end > 0.0,
            FarEnd::Corrected => past_far_end < 0.0,
        };
        if t > 0.0 && axis.dot(q - p0) > 0.0 && kept {
            found.push(Crossing::new(t, 0));
        }
    }
    for (face, center) in [(1, p0), (2, p1)] {
        let t = (center - ray.origin).dot(axis) / ray.direction.dot(axis);
        let away = ray.at(t) - center;
        if t > 0.0 && away.dot(away) < radius * radius {
            found.push(Crossing::new(t, face));
        }
    }
    found.sort_by(|a, b| a.t.total_cmp(&b.t));
    found
}

/// Which sign B's condition `(vₐ, q − p₂)` has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FarEnd {
    /// `> 0`: keeps what lies beyond both ends.
    AsPrinted,
    /// `< 0`.
    Corrected,
}
