//! Rough matt surfaces: V-shaped grooves of Lambert facets [D §5.3].

use super::lambert::{cosine_pdf, sample_cosine};
use super::{
    ALBEDO_TOLERANCE, Brdf, Directions, Geometry, ParameterError, Sampled, checked, reflectance, sin_theta,
};
use crate::num::quadrature::{Integral, integrate};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, PI, TAU};

/// How much of the paper's model is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OrenNayarForm {
    /// The short one, with two constants and no light between facets; D's [D §5.3, ShaderX²].
    #[default]
    Qualitative,
    /// The fitted integral, with a third term and light that is reflected twice.
    Full,
}

/// Grooves whose slopes have the standard deviation `σ` \[rad\].
///
/// With `α` the larger and `β` the smaller of the two angles, `s = σ²`:
///
/// ```text
/// short   ρ/π (A + B max(0, cos φ) sin α tan β),    A = 1 − ½ s/(s + 0.33),  B = 0.45 s/(s + 0.09)
/// full    ρ/π (A + cos φ C₂ tan β + (1 − |cos φ|) C₃ tan((α + β)/2))
///           + 0.17 ρ²/π · s/(s + 0.13) · (1 − cos φ (2β/π)²)
///         C₂ = B (sin α − [cos φ < 0] (2β/π)³),   C₃ = 0.125 s/(s + 0.09) (4αβ/π²)²
/// ```
///
/// `sin α tan β = sin θᵢ sin θₒ / max(cos θᵢ, cos θₒ)` and `tan((α + β)/2) = (sin θᵢ + sin θₒ)/(cos θᵢ + cos θₒ)`: the short
/// form needs no trigonometry.
///
/// - Domain: `ρ` in `[0,1]`, finite `σ ≥ 0`; σ = 0 is Lambert.
/// - Accuracy: a few `u`, relative; all large terms are positive.
/// - It claims no conservation: with ρ = 1 a little more than everything comes back near grazing.
/// - The full form's fit dips below 0 where dark surfaces with steep slopes (σ > 0.66 as ρ → 0) are lit and seen at grazing angles
///   from opposite sides: `value` gives the published number, `eval` and `sample` end at 0, the albedo counts the dip.
/// - Source: Oren & Nayar, *Generalization of Lambert's Reflectance Model* (1994), (27)–(30).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrenNayar {
    rho: f64,
    sigma: f64,
    form: OrenNayarForm,
}

impl OrenNayar {
    /// - Errors: a reflectance outside `[0,1]`, a negative σ.
    pub fn new(rho: f64, sigma: f64, form: OrenNayarForm) -> Result<Self, ParameterError> {
        let sigma = checked("sigma", sigma, "finite and not negative", |x| x >= 0.0)?;
        Ok(OrenNayar { rho: reflectance("rho", rho)?, sigma, form })
    }

    /// `s/(s + c)`; 1 for slopes whose square overflows.
    fn saturated(&self, c: f64) -> f64 {
        let s = self.sigma * self.sigma;
        if s.is_finite() { s / (s + c) } else { 1.0 }
    }
    fn a(&self) -> f64 {
        1.0 - 0.5 * self.saturated(0.33)
    }
    fn b(&self) -> f64 {
        0.45 * self.saturated(0.09)
    }

    fn full<G: Geometry>(&self, g: &G) -> f64 {
        let (ci, co, si, so) = (g.cos_i(), g.cos_o(), g.sin_i(), g.sin_o());
        let (ti, to) = (g.theta_i(), g.theta_o());
        let (alpha, beta, cos_phi) = (ti.max(to) * FRAC_2_PI, ti.min(to) * FRAC_2_PI, g.cos_phi());
        let tan_beta = si.min(so) / ci.max(co);
        // sin α − (2β/π)³ is multiplied by tan β, so that near 90° it is put together from what is missing to 1.
        let c2 = self.b()
            * if cos_phi < 0.0 {
                let lacks = ci.max(co).atan2(si.min(so)) * FRAC_2_PI;
                lacks * (1.0 + beta + beta * beta) - ci.min(co) * ci.min(co) / (1.0 + si.max(so))
            } else {
                si.max(so)
            };
        let c3 = 0.125 * self.saturated(0.09) * (alpha * beta) * (alpha * beta);
        let across = g.sin2_phi() / (1.0 + cos_phi.abs());
        let once = self.a() + cos_phi * c2 * tan_beta + across * c3 * ((si + so) / (ci + co));
        let twice = 0.17 * self.rho * self.saturated(0.13) * (1.0 - cos_phi * beta * beta);
        self.rho * FRAC_1_PI * (once + twice)
    }

    /// The full form's azimuths integrate in closed form; `∫|cos φ| dφ = 4`, and what is odd cancels.
    fn full_albedo(&self, co: f64, so: f64) -> Integral {
        let theta_o = so.atan2(co);
        let over = |theta_i: f64| {
            let (si, ci) = theta_i.sin_cos();
            let (alpha, beta) = (theta_i.max(theta_o) * FRAC_2_PI, theta_i.min(theta_o) * FRAC_2_PI);
            let tan_beta = si.min(so) / ci.max(co);
            let c3 = 0.125 * self.saturated(0.09) * (alpha * beta) * (alpha * beta);
            let once = TAU * self.a()
                + 2.0 * self.b() * beta * beta * beta * tan_beta
                + (TAU - 4.0) * c3 * ((si + so) / (ci + co));
            (once + TAU * 0.17 * self.rho * self.saturated(0.13)) * ci * si
        };
        integrate(over, &[0.0, theta_o, 0.5 * PI], ALBEDO_TOLERANCE).times(self.rho * FRAC_1_PI)
    }

    /// `ρ (A + 2B/π (½ sin θ (θ − sin θ cos θ) + tan θ (1 − sin³θ)/3))`, the last without its pole.
    fn qualitative_albedo(&self, co: f64, so: f64) -> Integral {
        let below = 0.5 * so * (so.atan2(co) - so * co);
        let beyond = so * co * (1.0 + so + so * so) / (3.0 * (1.0 + so));
        Integral::exact(self.rho * (self.a() + self.b() * FRAC_2_PI * (below + beyond)))
    }
}

impl Brdf for OrenNayar {
    #[inline]
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        match self.form {
            OrenNayarForm::Qualitative => {
                let along = g.product().truncate().element_sum();
                let along = if along < 0.0 { 0.0 } else { along };
                self.rho * FRAC_1_PI * (self.a() + self.b() * (along / g.cos_i().max(g.cos_o())))
            }
            OrenNayarForm::Full => self.full(g),
        }
    }
    #[inline]
    fn eval(&self, wi: DVec3, wo: DVec3) -> f64 {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return 0.0;
        }
        match self.value(&Directions { wi, wo }) {
            f if f < 0.0 => 0.0,
            f => f,
        }
    }
    #[inline]
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        sample_cosine(wo, u, |wi| PI * self.eval(wi, wo))
    }
    #[inline]
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        cosine_pdf(wi, wo)
    }
    fn albedo(&self, wo: DVec3) -> Integral {
        let (co, so) = (wo.z, sin_theta(wo));
        match self.form {
            _ if co <= 0.0 => Integral::default(),
            OrenNayarForm::Qualitative => self.qualitative_albedo(co, so),
            OrenNayarForm::Full => self.full_albedo(co, so),
        }
    }
    fn conserves_energy(&self) -> bool {
        self.sigma == 0.0
    }
}
