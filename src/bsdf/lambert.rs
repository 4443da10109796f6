//! Matt surfaces: the same radiance in every direction [A §4.2.1].

use super::{Brdf, Geometry, ParameterError, Sampled, above, reflectance};
use crate::num::quadrature::Integral;
use crate::sample::{cosine_hemisphere, cosine_hemisphere_pdf};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_1_PI, PI};

/// Lambert's surface, `f = ρ/π`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert {
    rho: f64,
}

impl Lambert {
    /// - Errors: a reflectance outside `[0,1]`.
    pub fn new(rho: f64) -> Result<Self, ParameterError> {
        Ok(Lambert { rho: reflectance("rho", rho)? })
    }
}

impl Brdf for Lambert {
    #[inline]
    fn value<G: Geometry>(&self, _: &G) -> f64 {
        self.rho * FRAC_1_PI
    }
    #[inline]
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        sample_cosine(wo, u, |_| self.rho)
    }
    #[inline]
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        cosine_pdf(wi, wo)
    }
    fn albedo(&self, wo: DVec3) -> Integral {
        if wo.z <= 0.0 { Integral::default() } else { Integral::exact(self.rho) }
    }
    fn conserves_energy(&self) -> bool {
        true
    }
}

/// A direction with cosine density, and `π f` as its weight.
#[inline]
pub(super) fn sample_cosine(wo: DVec3, u: DVec2, pi_f: impl Fn(DVec3) -> f64) -> Option<Sampled> {
    let wi = cosine_hemisphere(u);
    above(wi, wo).then(|| Sampled { wi, weight: pi_f(wi), pdf: cosine_hemisphere_pdf(wi) })
}

#[inline]
pub(super) fn cosine_pdf(wi: DVec3, wo: DVec3) -> f64 {
    if wo.z <= 0.0 { 0.0 } else { cosine_hemisphere_pdf(wi) }
}

/// [A (4.6)] taken for the BRDF that it is called: `f = cos θᵢ`. **Wrong**: the cosine is Lambert's law, which the
/// transport applies already; as a BRDF it is not reciprocal, and returns `2π/3` of the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CosinePrinted;

impl Brdf for CosinePrinted {
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        super::as_printed::phong_as_printed(g.cos_i())
    }
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        sample_cosine(wo, u, |wi| PI * wi.z)
    }
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        cosine_pdf(wi, wo)
    }
    /// `∫ cos²θ dω = 2π/3`.
    fn albedo(&self, wo: DVec3) -> Integral {
        if wo.z <= 0.0 { Integral::default() } else { Integral::exact(2.0 * PI / 3.0) }
    }
    fn is_reciprocal(&self) -> bool {
        false
    }
    fn conserves_energy(&self) -> bool {
        false
    }
}
