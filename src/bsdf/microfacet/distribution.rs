//! How facets are tilted.

use super::super::Half;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_1_PI, TAU};

/// Beyond this `tan²θₕ/m²` Beckmann's density is 0: `e^(−745.2)` is the last number that is not. Where
/// `cos⁻⁴θₕ` could still make something of it, at `cos θₕ < 10⁻⁴`, the exponent is `10⁸/m²`.
const LAST_EXPONENT: f64 = 745.2;

/// Density of facets over tilts, so that `∫ D cos θₕ dωₕ = 1`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Distribution {
    /// Slopes follow a normal distribution: `D = e^(−tan²θ/m²) / (π m² cos⁴θ)`.
    Beckmann,
    /// `D = α² / (π (α² cos²θ + sin²θ)²)`: the same peak, a longer tail.
    #[default]
    Ggx,
}

impl Distribution {
    /// Density of facets [sr⁻¹].
    ///
    /// - Domain: roughness over 10⁻¹⁴ (under it the surface is a mirror). A half vector in the horizon gives 0 with
    ///   Beckmann, `α²/π` with GGX.
    /// - Accuracy: relative, a few `u` times `1 + tan²θ/m²` (Beckmann), a few `u` (GGX: both terms are positive, where the
    ///   usual `cos²θ (α² − 1) + 1` cancels to nothing at `α² < u`).
    /// - Source: Beckmann & Spizzichino (1963); Trowbridge & Reitz (1975), Walter et al. (2007).
    #[inline]
    pub fn density(self, roughness: f64, half: &Half) -> f64 {
        let cos2 = half.cos_h * half.cos_h;
        match self {
            Distribution::Beckmann => {
                let tangent = half.sin2_h / cos2 / roughness / roughness;
                if tangent > LAST_EXPONENT {
                    return 0.0;
                }
                let width = roughness * cos2;
                (-tangent).exp() * FRAC_1_PI / (width * width)
            }
            Distribution::Ggx => {
                let q = roughness / (roughness * roughness * cos2 + half.sin2_h);
                FRAC_1_PI * q * q
            }
        }
    }

    /// `tan²θₕ` under which the share `q` of the facets (by area along the normal) is tilted.
    #[inline]
    fn tan2(self, roughness: f64, q: f64) -> f64 {
        let m2 = roughness * roughness;
        match self {
            Distribution::Beckmann => -m2 * (-q).ln_1p(),
            Distribution::Ggx => m2 * (q / (1.0 - q)),
        }
    }

    /// Share of the facets that are tilted more than `tan2`.
    pub(super) fn share_beyond(self, roughness: f64, tan2: f64) -> f64 {
        let x = tan2 / roughness / roughness;
        match self {
            Distribution::Beckmann => (-x).exp(),
            Distribution::Ggx => 1.0 / (1.0 + x),
        }
    }

    /// Cosine and sine of the tilt that the share `r` of the facets exceeds; `None` at the horizon.
    pub(super) fn tilt_exceeded_by(self, roughness: f64, r: f64) -> Option<(f64, f64)> {
        let m2 = roughness * roughness;
        tilt(match self {
            Distribution::Beckmann => -m2 * r.ln(),
            Distribution::Ggx => m2 * ((1.0 - r) / r),
        })
    }

    /// A half vector with density `D cos θₕ`.
    ///
    /// - Source: Walter et al. (2007), (28), (35).
    #[inline]
    pub(super) fn sample(self, roughness: f64, u: DVec2) -> DVec3 {
        // u_x ends before 1, so that the tangent is finite.
        let (cos, sin) = tilt(self.tan2(roughness, u.x)).unwrap_or((0.0, 1.0));
        let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
        DVec3::new(sin * cos_phi, sin * sin_phi, cos)
    }
}

/// Cosine and sine of a tilt; `None` at the horizon.
#[inline]
fn tilt(tan2: f64) -> Option<(f64, f64)> {
    let found = ((1.0 + tan2).sqrt().recip(), (tan2 / (1.0 + tan2)).sqrt());
    tan2.is_finite().then_some(found)
}

/// A half vector among the facets of GGX that are seen from `wo`, with density `G₁ cos d D / cos θₒ`.
///
/// Stretched to roughness 1 the facets are those of a hemisphere; what is seen of it reflects `wo` uniformly into a cap of the
/// sphere.
///
/// - Source: Heitz, *Sampling the GGX Distribution of Visible Normals* (2018); cap: Dupuy & Benyoub (2023).
pub(super) fn ggx_visible(roughness: f64, wo: DVec3, u: DVec2) -> DVec3 {
    let stretched = DVec3::new(roughness * wo.x, roughness * wo.y, wo.z).normalize();
    // The cap reaches from the pole down to −z of the view.
    let h = u.x * (1.0 + stretched.z);
    let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
    let r = (h * (2.0 - h)).max(0.0).sqrt();
    let facet = DVec3::new(r * cos_phi, r * sin_phi, 1.0 - h) + stretched;
    DVec3::new(roughness * facet.x, roughness * facet.y, facet.z.max(0.0)).normalize_or(DVec3::Z)
}
