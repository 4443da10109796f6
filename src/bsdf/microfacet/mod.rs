//! Surfaces of small mirrors [D §5.3]: Cook & Torrance's model, with its parts to choose from.
//!
//! ```text
//! f = D F G / (4 cos θᵢ cos θₒ)
//! ```
//!
//! `D` says how the facets are tilted ([`Distribution`]), `F` what a facet reflects ([`Fresnel`]), `G` what share of them
//! is neither hidden nor in shadow ([`Shadowing`]). `G` vanishes with either cosine; the models compute the quotient
//! `G / (4 cos θᵢ cos θₒ)`, in which nothing is left to divide by at grazing angles.

mod distribution;
mod shadowing;

pub use distribution::Distribution;
pub use shadowing::Shadowing;

use super::{
    Brdf, Directions, Geometry, Half, ParameterError, Sampled, above, checked, mirror, reflectance, sin_theta,
};
use crate::fresnel::Fresnel;
use crate::num::U;
use crate::num::quadrature::{Integral, integrate};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};
use shadowing::Facing;
use std::cell::Cell;
use std::f64::consts::{FRAC_1_PI, PI};

/// Under this roughness the surface is a mirror. Directions are rounded to a few `u`, and their half vectors with
/// them; a lobe 128 `u` wide would be made of those roundings.
pub const MIRROR_BELOW: f64 = 128.0 * U;

/// Accuracy of the albedo's quadrature over a ring of facets, and over all rings.
const RING_TOLERANCE: f64 = 1.0e-9;
const TOLERANCE: f64 = 1.0e-8;

/// Which facets are sampled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FacetSampling {
    /// All of them, seen or not, by their area seen along the normal.
    All,
    /// Those that the viewer sees: known in closed form for GGX; Beckmann's takes all.
    #[default]
    Visible,
}

/// Cook & Torrance's model.
///
/// - Domain: finite roughness ≥ 0, the slope at which facets become rare (Cook & Torrance's `m`, Walter's `α`). Under
///   [`MIRROR_BELOW`] it is the perfect mirror: `eval` and `pdf` are 0, and `sample` makes the one direction there is.
/// - Accuracy: relative, a few `u` times `1 + tan²θₕ/m²`, the logarithm of the value itself; with vectors that are rounded,
///   `u/m` times that.
/// - Source: Cook & Torrance, *A Reflectance Model for Computer Graphics* (1982), with the 4 instead of π that
///   Walter et al. derive: *Microfacet Models for Refraction through Rough Surfaces* (2007), (20).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CookTorrance {
    roughness: f64,
    distribution: Distribution,
    shadowing: Shadowing,
    fresnel: Fresnel,
    sampling: FacetSampling,
}

impl CookTorrance {
    /// - Errors: a roughness that is negative or not finite, an `f0` outside `[0,1]`, an index that is not positive.
    pub fn new(
        roughness: f64,
        distribution: Distribution,
        shadowing: Shadowing,
        fresnel: Fresnel,
    ) -> Result<Self, ParameterError> {
        let roughness = checked("roughness", roughness, "finite and not negative", |x| x >= 0.0)?;
        let index = |name, found| checked(name, found, "a positive index of refraction", |x| x > 0.0);
        match fresnel {
            Fresnel::Schlick { f0 } => reflectance("f0", f0).map(drop)?,
            Fresnel::Dielectric { ior } => index("ior", ior).map(drop)?,
            Fresnel::Conductor { eta, k } => {
                index("eta", eta)?;
                checked("k", k, "finite and not negative", |x| x >= 0.0)?;
            }
        }
        Ok(CookTorrance { roughness, distribution, shadowing, fresnel, sampling: FacetSampling::default() })
    }

    /// GGX with Smith's shadowing: the default, exact in both and quick.
    pub fn ggx(roughness: f64, fresnel: Fresnel) -> Result<Self, ParameterError> {
        Self::new(roughness, Distribution::Ggx, Shadowing::Smith, fresnel)
    }

    pub fn sampled(self, sampling: FacetSampling) -> Self {
        CookTorrance { sampling, ..self }
    }

    fn is_mirror(&self) -> bool {
        self.roughness < MIRROR_BELOW
    }
    fn sees_visible(&self) -> bool {
        self.sampling == FacetSampling::Visible && self.distribution == Distribution::Ggx
    }
    /// Density of [`Brdf::sample`] by the half vector.
    #[inline]
    fn density(&self, half: &Half, cos_o: f64, sin_o: f64) -> f64 {
        let d = self.distribution.density(self.roughness, half);
        if self.sees_visible() {
            d * shadowing::ggx_seen(self.roughness, cos_o, sin_o)
        } else {
            d * half.cos_h / (4.0 * half.cos_d)
        }
    }

    /// Share that a facet under `h` sends from a ring of half vectors on: everything but `D`.
    fn facet(&self, h: DVec3, co: f64, so: f64, cos_d: f64) -> f64 {
        let ci = 2.0 * cos_d * h.z - co;
        if !(ci > 0.0) {
            return 0.0;
        }
        let si = ((1.0 - ci) * (1.0 + ci)).max(0.0).sqrt();
        let facing = Facing { cos_i: ci, sin_i: si, cos_o: co, sin_o: so, cos_h: h.z, cos_d };
        let f = self.fresnel.reflectance(cos_d.min(1.0), (1.0 - cos_d).max(0.0));
        f * self.shadowing.quotient(self.distribution, self.roughness, &facing) * 4.0 * ci * cos_d / h.z
    }

    /// Mean of [`Self::facet`] over the azimuths of half vectors at one angle `(ch, sh)` with the normal.
    fn ring(&self, (ch, sh): (f64, f64), co: f64, so: f64) -> Integral {
        // cos d = a + b cos φ; reflected light is above the horizon where that exceeds co/(2 ch).
        let (a, b) = (co * ch, so * sh);
        let azimuth = |cos_d: f64| match (cos_d - a) / b {
            x if x >= 1.0 => 0.0,
            x if x > -1.0 => x.acos(),
            _ => PI,
        };
        let end = azimuth(0.5 * co / ch);
        if !(end > 0.0) {
            return Integral::default();
        }
        // Where one facet of a groove begins to hide or shade the other, and where the two take turns.
        let kinks = [co / ch, 2.0 * ch * co, 2.0 * ch * co / (4.0 * ch * ch - 1.0)];
        let mut breaks: ArrayVec<f64, 5> = [0.0, end].into_iter().collect();
        breaks.extend(kinks.map(azimuth).into_iter().filter(|phi| *phi > 0.0 && *phi < end));
        breaks.sort_by(f64::total_cmp);
        let over = |phi: f64| {
            let (sin, cos) = phi.sin_cos();
            self.facet(DVec3::new(sh * cos, sh * sin, ch), co, so, (a + b * cos).max(0.0))
        };
        integrate(over, &breaks, RING_TOLERANCE).times(FRAC_1_PI)
    }
}

impl Brdf for CookTorrance {
    #[inline]
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        if self.is_mirror() {
            return 0.0;
        }
        let half = g.half();
        let d = self.distribution.density(self.roughness, &half);
        let facing = Facing {
            cos_i: g.cos_i(),
            sin_i: g.sin_i(),
            cos_o: g.cos_o(),
            sin_o: g.sin_o(),
            cos_h: half.cos_h,
            cos_d: half.cos_d,
        };
        let quotient = self.shadowing.quotient(self.distribution, self.roughness, &facing);
        d * self.fresnel.reflectance(half.cos_d, half.versine_d) * quotient
    }

    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        if self.is_mirror() {
            let weight = self.fresnel.reflectance(wo.z, (1.0 - wo.z).max(0.0));
            return (wo.z > 0.0).then(|| Sampled { wi: mirror(wo), weight, pdf: f64::INFINITY });
        }
        if wo.z <= 0.0 {
            return None;
        }
        let visible = self.sees_visible();
        let h = match visible {
            true => distribution::ggx_visible(self.roughness, wo, u),
            false => self.distribution.sample(self.roughness, u),
        };
        let cos_d = wo.dot(h);
        let wi = h * (2.0 * cos_d) - wo;
        if !(cos_d > 0.0) || !above(wi, wo) {
            return None;
        }
        let so = sin_theta(wo);
        let mut weight = self.facet(h, wo.z, so, cos_d);
        if visible {
            // D cos θₕ / (4 cos d) gives way to D G₁ / (4 cos θₒ).
            weight *= h.z / (4.0 * cos_d * shadowing::ggx_seen(self.roughness, wo.z, so));
        }
        Some(Sampled { wi, weight, pdf: self.pdf(wi, wo) })
    }

    #[inline]
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        if self.is_mirror() || !above(wi, wo) {
            return 0.0;
        }
        self.density(&Directions { wi, wo }.half(), wo.z, sin_theta(wo))
    }

    /// Over the half vectors: `p⁴` is the share of facets tilted more, which spreads the rings evenly whatever the
    /// roughness, and shows the few steep ones that are hidden as well.
    fn albedo(&self, wo: DVec3) -> Integral {
        let (co, so) = (wo.z, sin_theta(wo));
        if co <= 0.0 {
            return Integral::default();
        }
        if self.is_mirror() {
            return Integral::exact(self.fresnel.reflectance(co, (1.0 - co).max(0.0)));
        }
        let worst_ring = Cell::new(0.0f64);
        let over = |p: f64| {
            let tilt = self.distribution.tilt_exceeded_by(self.roughness, p * p * p * p);
            let Some(h) = tilt.filter(|h| h.0 > 0.0) else { return 0.0 };
            // The few steepest facets shine most, and are counted least: so are the errors of their rings.
            let ring = self.ring(h, co, so).times(4.0 * p * p * p);
            worst_ring.set(worst_ring.get().max(ring.error));
            ring.value
        };
        // Facets at (90° − θₒ)/2 first reflect into the horizon, those at (90° + θₒ)/2 all do.
        let at = |tan2: f64| self.distribution.share_beyond(self.roughness, tan2).sqrt().sqrt();
        let breaks =
            [0.0, at((1.0 + so) / (1.0 - so).max(f64::MIN_POSITIVE)), at((1.0 - so) / (1.0 + so)), 1.0];
        let all = integrate(over, &breaks, TOLERANCE);
        Integral { value: all.value, error: all.error + worst_ring.get() }
    }

    fn conserves_energy(&self) -> bool {
        true
    }
}
