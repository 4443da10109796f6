//! Lafortune's generalised cosine lobe.

use super::phong::{about, lobe_integral};
use super::{
    Brdf, Directions, Geometry, ParameterError, Sampled, above, checked, exponent, positive_part, reflectance,
};
use crate::frame::unit;
use crate::num::quadrature::Integral;
use crate::sample::power_cosine;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A lobe about any linear image of the view:
///
/// ```text
/// f = ρ (n + 2)/2π · max(0, Cx ix ox + Cy iy oy + Cz iz oz)ⁿ
/// ```
///
/// `C = (−1, −1, 1)` is Phong's mirror lobe, `(1, 1, 1)` sends light back where it came from, `|Cz| < |Cx|` pulls the
/// lobe towards the horizon as rough surfaces do, `Cx ≠ Cy` brushes the surface. Real materials are sums of a few
/// ([`super::Lobes`]).
///
/// - Domain: no coefficient exceeds 1 in size (a larger one belongs into ρ); finite `n ≥ 0`.
/// - Accuracy: relative, `n u`.
/// - Source: Lafortune, Foo, Torrance & Greenberg, *Non-Linear Approximation of Reflectance Functions* (1997) [A, ref. 7].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lafortune {
    c: DVec3,
    exponent: f64,
    rho: f64,
}

impl Lafortune {
    /// - Errors: a coefficient, exponent or reflectance outside its domain.
    pub fn new(c: DVec3, n: f64, rho: f64) -> Result<Self, ParameterError> {
        for found in c.to_array() {
            checked("C", found, "from -1 to 1", |x| x.abs() <= 1.0)?;
        }
        Ok(Lafortune { c, exponent: exponent(n)?, rho: reflectance("rho", rho)? })
    }
    fn factor(&self) -> f64 {
        self.rho * (self.exponent + 2.0) / TAU
    }
    /// The lobe's axis, and its length to the power n; `None` for the view along a direction without coefficient.
    fn axis(&self, wo: DVec3) -> Option<(DVec3, f64)> {
        let v = self.c * wo;
        Some((unit(v)?, self.power(v.length())))
    }
    #[inline]
    fn power(&self, base: f64) -> f64 {
        if base > 0.0 { (self.exponent * base.ln()).exp() } else { 0.0 }
    }
}

impl Brdf for Lafortune {
    #[inline]
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        self.factor() * self.power(self.c.dot(g.product()))
    }
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        let (axis, scale) = self.axis(wo)?;
        let wi = about(axis, power_cosine(u, self.exponent));
        above(wi, wo).then(|| Sampled {
            wi,
            weight: self.factor() * scale * TAU / (self.exponent + 1.0) * wi.z,
            pdf: self.pdf(wi, wo),
        })
    }
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        let Some((axis, _)) = self.axis(wo).filter(|_| above(wi, wo)) else { return 0.0 };
        let versine = 0.5 * (wi - axis).length_squared();
        (self.exponent + 1.0) / TAU * super::phong::power(versine, || wi.dot(axis), self.exponent)
    }
    fn albedo(&self, wo: DVec3) -> Integral {
        let Some((axis, scale)) = self.axis(wo).filter(|_| wo.z > 0.0) else { return Integral::default() };
        let sin = Directions { wi: axis, wo }.sin_i();
        lobe_integral(axis.z, sin, self.exponent, positive_part).times(self.factor() * scale)
    }
    /// `|C∘wo| ≤ 1` and `ρ ≤ 1`: no more than Phong's lobe about the same axis.
    fn conserves_energy(&self) -> bool {
        true
    }
}
