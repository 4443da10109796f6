//! Which facets are hidden or in shadow.

use super::Distribution;
use crate::num::statistics::erfc;
use std::f64::consts::PI;

/// What the models of shadowing ask for.
#[derive(Clone, Copy, Debug)]
pub struct Facing {
    pub cos_i: f64,
    pub sin_i: f64,
    pub cos_o: f64,
    pub sin_o: f64,
    pub cos_h: f64,
    pub cos_d: f64,
}

/// A model of shadowing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shadowing {
    /// Grooves as long as the surface, each seen across: `G = min(1, 2 cos θₕ cos θₒ/cos d, 2 cos θₕ cos θᵢ/cos d)`.
    VCavity,
    /// Heights without memory, the same for both ways: `G = 1/(1 + Λᵢ + Λₒ)`.
    #[default]
    Smith,
    /// Smith's with Walter's rational fit for Beckmann's Λ, which saves the error function; the same for GGX.
    SmithRational,
}

impl Shadowing {
    /// `G / (4 cos θᵢ cos θₒ)` \[1\], finite for all cosines that are not both 0.
    ///
    /// ```text
    /// V-cavity   min(1/(4 ci co), cos θₕ/(2 cos d max(ci, co)))
    /// GGX        ½ / (co √(ci² + α² si²) + ci √(co² + α² so²))
    /// Beckmann   ¼ / (ci co + co (ci Λᵢ) + ci (co Λₒ))
    /// ```
    ///
    /// - Source: Torrance & Sparrow (1967); Smith (1967), Heitz, *Understanding the Masking-Shadowing Function* (2014),
    ///   (72), (99).
    #[inline]
    pub fn quotient(self, distribution: Distribution, roughness: f64, g: &Facing) -> f64 {
        let both = g.cos_i * g.cos_o;
        match (self, distribution) {
            (Shadowing::VCavity, _) => {
                let open = 0.25 / both;
                open.min(0.5 * g.cos_h / (g.cos_d * g.cos_i.max(g.cos_o)))
            }
            (_, Distribution::Ggx) => {
                let i = ggx_width(roughness, g.cos_i, g.sin_i);
                let o = ggx_width(roughness, g.cos_o, g.sin_o);
                0.5 / (g.cos_o * i + g.cos_i * o)
            }
            (_, Distribution::Beckmann) => {
                let lambda = if self == Shadowing::Smith { beckmann_lambda } else { beckmann_rational };
                let i = lambda(roughness, g.cos_i, g.sin_i);
                let o = lambda(roughness, g.cos_o, g.sin_o);
                0.25 / (both + g.cos_o * i + g.cos_i * o)
            }
        }
    }
}

/// `√(cos² + α² sin²)`: width of GGX's facets seen from there.
#[inline]
fn ggx_width(roughness: f64, cos: f64, sin: f64) -> f64 {
    (cos * cos + roughness * roughness * (sin * sin)).sqrt()
}

/// `G₁ / (4 cos θₒ)` of Smith's shadowing with GGX.
#[inline]
pub fn ggx_seen(roughness: f64, cos: f64, sin: f64) -> f64 {
    0.5 / (cos + ggx_width(roughness, cos, sin))
}

/// `cos θ Λ` for Beckmann's facets: `½ (m sin θ e^(−a²)/√π − cos θ erfc a)`, `a = cos θ/(m sin θ)`.
///
/// - Accuracy: absolute error a few `u` of the larger term; it matters beside `cos θ`, which is as large.
fn beckmann_lambda(roughness: f64, cos: f64, sin: f64) -> f64 {
    let slope = roughness * sin;
    let a = cos / slope;
    // e^(−36) is less than u: nothing is hidden. NaN goes on.
    if a > 6.0 {
        return 0.0;
    }
    (0.5 * (slope * (-a * a).exp() / PI.sqrt() - cos * erfc(a))).max(0.0)
}

/// The same by Walter's fit: relative error of G within 0.35 %.
///
/// - Source: Walter et al. (2007), after (27).
fn beckmann_rational(roughness: f64, cos: f64, sin: f64) -> f64 {
    let slope = roughness * sin;
    let a = cos / slope;
    if a >= 1.6 {
        return 0.0;
    }
    // (1 − 1.259 a + 0.396 a²)/(3.535 a + 2.181 a²), times cos = a · slope
    (slope * (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 + 2.181 * a)).max(0.0)
}
