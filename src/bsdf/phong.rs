//! Phong's highlight: a power of the cosine about the mirror direction [A §4.2.3].

use super::{
    ALBEDO_TOLERANCE, Brdf, Geometry, ParameterError, Sampled, above, exponent, mirror, positive_part,
    sin_theta,
};
use crate::frame::basis;
use crate::num::quadrature::{Integral, integrate};
use crate::sample::power_cosine;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// What the power is multiplied by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PhongScale {
    /// `(n + 2)/2π`: the whole light comes back at normal incidence [A (4.7)].
    #[default]
    Normalised,
    /// Nothing: `2π/(n + 2)` comes back at normal incidence, 209 % at n = 1, 6 % at n = 100.
    Raw,
    /// `1/cos θᵢ`: the shading formula of 1975, which has no cosine, read as a BRDF. Not reciprocal, and without
    /// bound towards grazing light.
    OverCosine,
}

/// The lobe `f = C cosⁿ a`, `a` the angle between `wi` and the mirror direction of `wo`.
///
/// ```text
/// cosⁿ a = exp(n ln(1 − v)),    v = 1 − cos a, near the mirror's direction
/// ```
///
/// - Domain: finite `n ≥ 0`; `a ≥ 90°` gives 0, also for n = 0.
/// - Accuracy: relative, `n ln(1/cos a)` times a few `u`: about that of the value's own logarithm. A plain
///   `powf(cos a, n)` loses `n u`.
/// - Source: Phong (1975); scale: Lafortune & Willems, *Using the Modified Phong Reflectance Model* (1994).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    exponent: f64,
    scale: PhongScale,
}

impl Phong {
    /// The normalised lobe.
    ///
    /// - Errors: an exponent that is negative or not finite.
    pub fn new(n: f64) -> Result<Self, ParameterError> {
        Ok(Phong { exponent: exponent(n)?, scale: PhongScale::default() })
    }
    pub fn scaled(self, scale: PhongScale) -> Self {
        Phong { scale, ..self }
    }
    fn factor(&self) -> f64 {
        match self.scale {
            PhongScale::Normalised => (self.exponent + 2.0) / TAU,
            PhongScale::Raw | PhongScale::OverCosine => 1.0,
        }
    }
}

impl Brdf for Phong {
    #[inline]
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        let f = self.factor() * lobe(g, self.exponent);
        if self.scale == PhongScale::OverCosine { f / g.cos_i() } else { f }
    }
    #[inline]
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        let wi = about(mirror(wo), power_cosine(u, self.exponent));
        if !above(wi, wo) {
            return None;
        }
        let cos = if self.scale == PhongScale::OverCosine { 1.0 } else { wi.z };
        let weight = self.factor() * TAU / (self.exponent + 1.0) * cos;
        Some(Sampled { wi, weight, pdf: self.pdf(wi, wo) })
    }
    #[inline]
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        if !above(wi, wo) {
            return 0.0;
        }
        (self.exponent + 1.0) / TAU * lobe(&super::Directions { wi, wo }, self.exponent)
    }
    fn albedo(&self, wo: DVec3) -> Integral {
        if wo.z <= 0.0 {
            return Integral::default();
        }
        let part: fn(f64, f64) -> f64 = match self.scale {
            PhongScale::OverCosine => share_above,
            _ => positive_part,
        };
        lobe_integral(wo.z, sin_theta(wo), self.exponent, part).times(self.factor())
    }
    fn is_reciprocal(&self) -> bool {
        self.scale != PhongScale::OverCosine
    }
    fn conserves_energy(&self) -> bool {
        match self.scale {
            PhongScale::Normalised => true,
            PhongScale::Raw => self.exponent >= TAU - 2.0,
            PhongScale::OverCosine => self.exponent >= TAU - 1.0,
        }
    }
}

/// `cosⁿ a`; 0 from 90° on.
#[inline]
fn lobe<G: Geometry>(g: &G, n: f64) -> f64 {
    power(g.mirror_versine(), || g.mirror_cosine(), n)
}

/// `cosⁿ a`, from `1 − cos a` where that is small, else from the cosine; 0 from 90° on.
#[inline]
pub(super) fn power(versine: f64, cos: impl Fn() -> f64, n: f64) -> f64 {
    if versine < 0.5 {
        return (n * (-versine).ln_1p()).exp();
    }
    match cos() {
        cos if cos <= 0.0 => 0.0,
        cos => (n * cos.ln()).exp(),
    }
}

/// The direction `w`, given about `z`, about `axis`.
#[inline]
pub(super) fn about(axis: DVec3, w: DVec3) -> DVec3 {
    let (x, y) = basis(axis);
    x * w.x + y * w.y + axis * w.z
}

/// Measure of the azimuths where `a + b cos φ` is positive.
fn share_above(a: f64, b: f64) -> f64 {
    if a >= b {
        TAU
    } else if a <= -b {
        0.0
    } else {
        2.0 * (-a / b).acos()
    }
}

/// `∫ cosⁿ a · part dω` over the lobe about an axis that stands at an angle `(cos_r, sin_r)` with the normal.
///
/// The height of a direction of the lobe is `A + B cos φ` with `A = cos a cos r`, `B = sin a sin r`; `part(A, B)` is the
/// integral over φ. What remains is smooth in `q = 1 − cosⁿ⁺¹ a`, which spreads the lobe evenly whatever its width,
/// but for the angle `a = 90° − r` where it first touches the horizon.
pub(super) fn lobe_integral(cos_r: f64, sin_r: f64, n: f64, part: fn(f64, f64) -> f64) -> Integral {
    let over = |q: f64| {
        let log_cos = (-q).ln_1p() / (n + 1.0);
        let (cos, sin) = (log_cos.exp(), (-(2.0 * log_cos).exp_m1()).max(0.0).sqrt());
        part(cos * cos_r, sin * sin_r)
    };
    // cos a = sin r there; 1 − sinⁿ⁺¹ r from cos²r.
    let touch = -(0.5 * (n + 1.0) * (-cos_r * cos_r).ln_1p()).exp_m1();
    let breaks = [0.0, if cos_r > 0.0 { touch.clamp(0.0, 1.0) } else { 0.0 }, 1.0];
    integrate(over, &breaks, ALBEDO_TOLERANCE).times(1.0 / (n + 1.0))
}
