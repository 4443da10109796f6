//! Blinn's highlight: a power of the cosine between normal and half vector.

use super::{
    ALBEDO_TOLERANCE, Brdf, Directions, Geometry, Half, ParameterError, Sampled, above, exponent, sin_theta,
};
use crate::num::quadrature::{Integral, integrate};
use crate::sample::power_cosine;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// What the power is multiplied by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BlinnScale {
    /// `(n + 2)(n + 4) / (8π (2^(−n/2) + n))`: the whole light comes back at normal incidence.
    #[default]
    Exact,
    /// `(n + 8)/8π`, the usual fit to the exact one; it exceeds it at every `n`, and creates light.
    Eighth,
    /// Nothing.
    Raw,
    /// `1/cos θᵢ`: the shading formula of 1977, which has no cosine [C (28)], read as a BRDF. Not reciprocal, and without
    /// bound towards grazing light.
    OverCosine,
}

/// The lobe `f = C (n·h)ⁿ`.
///
/// ```text
/// (n·h)ⁿ = exp(n ln cos θₕ),    ln cos θₕ = ½ ln(1 − sin²θₕ) near the normal
/// ```
///
/// - Domain: finite `n ≥ 0`; n = 0 is matt.
/// - Accuracy: relative, a few `u` times the value's logarithm.
/// - Source: Blinn (1977); exact scale: Akenine-Möller et al., *Real-Time Rendering* (2008) §7.6 for the fit,
///   Giesen (2009) for the integral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blinn {
    exponent: f64,
    scale: BlinnScale,
}

impl Blinn {
    /// The lobe that is exact at normal incidence.
    ///
    /// - Errors: an exponent that is negative or not finite.
    pub fn new(n: f64) -> Result<Self, ParameterError> {
        Ok(Blinn { exponent: exponent(n)?, scale: BlinnScale::default() })
    }
    pub fn scaled(self, scale: BlinnScale) -> Self {
        Blinn { scale, ..self }
    }
    fn factor(&self) -> f64 {
        let n = self.exponent;
        match self.scale {
            BlinnScale::Exact => (n + 2.0) / (8.0 * PI) * ((n + 4.0) / ((-0.5 * n).exp2() + n)),
            BlinnScale::Eighth => (n + 8.0) / (8.0 * PI),
            BlinnScale::Raw | BlinnScale::OverCosine => 1.0,
        }
    }
    /// `(n·h)ⁿ`; 0⁰ is 1.
    #[inline]
    fn power(&self, half: &Half) -> f64 {
        if self.exponent == 0.0 { 1.0 } else { (self.exponent * half.log_cos_h()).exp() }
    }
}

impl Brdf for Blinn {
    #[inline]
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        let f = self.factor() * self.power(&g.half());
        if self.scale == BlinnScale::OverCosine { f / g.cos_i() } else { f }
    }
    #[inline]
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        let h = power_cosine(u, self.exponent);
        let cos_d = wo.dot(h);
        let wi = h * (2.0 * cos_d) - wo;
        if !(cos_d > 0.0) || !above(wi, wo) {
            return None;
        }
        let cos_i = if self.scale == BlinnScale::OverCosine { 1.0 } else { wi.z };
        let weight = self.factor() * TAU / (self.exponent + 1.0) * 4.0 * cos_d * cos_i;
        Some(Sampled { wi, weight, pdf: self.pdf(wi, wo) })
    }
    #[inline]
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        if !above(wi, wo) {
            return 0.0;
        }
        let half = Directions { wi, wo }.half();
        (self.exponent + 1.0) / TAU * self.power(&half) / (4.0 * half.cos_d)
    }
    /// In half vectors, `dω = 4 cos d dωₕ` and `cos θᵢ = 2 cos d cos θₕ − cos θₒ`, so that azimuths integrate in closed form.
    fn albedo(&self, wo: DVec3) -> Integral {
        let (co, so, n) = (wo.z, sin_theta(wo), self.exponent);
        if co <= 0.0 {
            return Integral::default();
        }
        let over = |q: f64| {
            let log_cos = (-q).ln_1p() / (n + 1.0);
            let [power, without_cosine] =
                azimuths(log_cos.exp(), (-(2.0 * log_cos).exp_m1()).max(0.0).sqrt(), co, so);
            if self.scale == BlinnScale::OverCosine { without_cosine } else { power }
        };
        // Half vectors at (90° − θₒ)/2 first reflect into the horizon, those at (90° + θₒ)/2 all do.
        let at = |cos2_h: f64| (-(0.5 * (n + 1.0) * cos2_h.ln()).exp_m1()).clamp(0.0, 1.0);
        let breaks = [0.0, at(0.5 * (1.0 + so)), at(0.5 * co * co / (1.0 + so)), 1.0];
        integrate(over, &breaks, ALBEDO_TOLERANCE).times(self.factor() / (n + 1.0))
    }
    fn is_reciprocal(&self) -> bool {
        self.scale != BlinnScale::OverCosine
    }
    fn conserves_energy(&self) -> bool {
        match self.scale {
            // 8π (1 − 2^(−n/2 − 1))/(n + 2) comes back at normal incidence, less elsewhere.
            BlinnScale::OverCosine => self.exponent >= 8.0 * PI - 2.0,
            BlinnScale::Exact => true,
            BlinnScale::Eighth => false,
            // The exact scale is then the larger one.
            BlinnScale::Raw => Blinn { scale: BlinnScale::Exact, ..*self }.factor() >= 1.0,
        }
    }
}

/// `∫ 4 cos d cos θᵢ dφ` and `∫ 4 cos d dφ` over the azimuths with `cos θᵢ = 2 cos d cos θₕ − cos θₒ > 0`, that is, with
/// `cos d = A + B cos φ` above `K = cos θₒ / (2 cos θₕ)`.
fn azimuths(ch: f64, sh: f64, co: f64, so: f64) -> [f64; 2] {
    if ch == 0.0 {
        return [0.0; 2];
    }
    let (a, b, k) = (co * ch, so * sh, 0.5 * co / ch);
    let edge = match k - a {
        gap if gap >= b => return [0.0; 2],
        gap if gap <= -b => PI,
        gap => (gap / b).acos(),
    };
    let (sin, cos) = edge.sin_cos();
    // ∫₀^edge of cos d and cos²d
    let first = a * edge + b * sin;
    let second = a * a * edge + 2.0 * a * b * sin + 0.5 * b * b * (edge + sin * cos);
    [8.0 * (2.0 * ch * second - co * first), 8.0 * first].map(|integral| integral.max(0.0))
}
