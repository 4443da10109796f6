//! A material in colour: a sum of lobes, each with its tint.

use super::{
    Brdf, CookTorrance, Distribution, Model, OrenNayar, OrenNayarForm, ParameterError, Shadowing, checked,
};
use crate::color::Rgb;
use crate::fresnel::Fresnel;
use crate::num::quadrature::Integral;
use crate::sample::LARGEST_BELOW_ONE;
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// Lobes at most.
const MOST: usize = 4;

/// A sum of models, each multiplied by a colour.
///
/// ```text
/// f = Σ tintₖ fₖ,    pdf = Σ pₖ pdfₖ
/// ```
///
/// One lobe is chosen by its share `pₖ` of the light that is returned at 45°, and the direction weighted by all of them.
/// A coloured metal needs no more: Schlick's `F = F₀ + (1 − F₀) s` is `F₀` times the mirror's lobe (`f0 = 1`) plus
/// `1 − F₀` times the lobe of `s` alone (`f0 = 0`).
#[derive(Clone, Debug, PartialEq)]
pub struct Lobes {
    parts: ArrayVec<Part, MOST>,
}

#[derive(Clone, Debug, PartialEq)]
struct Part {
    tint: Rgb,
    model: Model,
    chance: f64,
}

/// A sampled direction, in colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledRgb {
    pub wi: DVec3,
    /// `f cos θᵢ / pdf` per channel.
    pub weight: Rgb,
    /// Density [sr⁻¹]; +∞ for a mirror's direction.
    pub pdf: f64,
}

impl Lobes {
    /// - Domain: up to four lobes; more are left out in release builds.
    /// - Errors: a tint that is negative or not finite.
    pub fn new(parts: impl IntoIterator<Item = (Rgb, Model)>) -> Result<Self, ParameterError> {
        let wo = DVec3::new(0.5f64.sqrt(), 0.0, 0.5f64.sqrt());
        let mut lobes = Lobes { parts: ArrayVec::new() };
        for (tint, model) in parts {
            for channel in tint.to_array() {
                checked("tint", channel, "finite and not negative", |x| x >= 0.0)?;
            }
            let chance = tint.element_sum() * model.albedo(wo).value;
            let pushed = lobes.parts.try_push(Part { tint, model, chance });
            debug_assert!(pushed.is_ok(), "more than {MOST} lobes");
        }
        let total: f64 = lobes.parts.iter().map(|p| p.chance).sum();
        let count = lobes.parts.len() as f64;
        for part in &mut lobes.parts {
            part.chance = if total > 0.0 { part.chance / total } else { 1.0 / count };
        }
        Ok(lobes)
    }

    /// D's material: Oren & Nayar's short form for the diffuse colour, Cook & Torrance's (Beckmann, V-cavities, Schlick with
    /// the specular colour as `F₀`) for the rest, one roughness for both [D §5.3]. Its text leaves the constants to its
    /// reference; these are ours.
    ///
    /// - Errors: colours or a roughness outside their domains.
    pub fn matt_and_glossy(diffuse: Rgb, specular: Rgb, roughness: f64) -> Result<Self, ParameterError> {
        for channel in specular.to_array() {
            super::reflectance("specular", channel)?;
        }
        let matt = OrenNayar::new(1.0, roughness, OrenNayarForm::Qualitative)?;
        let facets = |fresnel| {
            CookTorrance::new(roughness, Distribution::Beckmann, Shadowing::VCavity, fresnel).map(Model::from)
        };
        Lobes::new([(diffuse, matt.into())].into_iter().chain(Lobes::schlick(specular, facets)?))
    }

    /// The two lobes of a metal with the coloured reflectance `f0` at normal incidence, made by `facets` of their Fresnel
    /// law; none for black.
    ///
    /// - Errors: those of `facets`.
    pub fn schlick(
        f0: Rgb,
        facets: impl Fn(Fresnel) -> Result<Model, ParameterError>,
    ) -> Result<ArrayVec<(Rgb, Model), 2>, ParameterError> {
        let mut parts = ArrayVec::new();
        if f0 != Rgb::ZERO {
            parts.push((f0, facets(Fresnel::Schlick { f0: 1.0 })?));
            parts.push((Rgb::ONE - f0, facets(Fresnel::Schlick { f0: 0.0 })?));
        }
        Ok(parts)
    }

    /// `f` [sr⁻¹] per channel.
    #[inline]
    pub fn eval(&self, wi: DVec3, wo: DVec3) -> Rgb {
        self.parts.iter().map(|p| p.tint * p.model.eval(wi, wo)).sum()
    }

    /// Density [sr⁻¹] of [`Lobes::sample`].
    #[inline]
    pub fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        self.parts.iter().map(|p| p.chance * p.model.pdf(wi, wo)).sum()
    }

    /// A direction made from `u` in [0,1)²; `None` where the chosen lobe dips below the horizon.
    pub fn sample(&self, wo: DVec3, u: DVec2) -> Option<SampledRgb> {
        let (mut x, mut chosen) = (u.x, self.parts.last()?);
        for part in &self.parts {
            if x < part.chance {
                chosen = part;
                break;
            }
            x -= part.chance;
        }
        let u = DVec2::new((x / chosen.chance).clamp(0.0, LARGEST_BELOW_ONE), u.y);
        let one = chosen.model.sample(wo, u)?;
        if one.pdf == f64::INFINITY {
            return Some(SampledRgb {
                wi: one.wi,
                weight: chosen.tint * (one.weight / chosen.chance),
                pdf: one.pdf,
            });
        }
        let pdf = self.pdf(one.wi, wo);
        (pdf > 0.0).then(|| SampledRgb { wi: one.wi, weight: self.eval(one.wi, wo) * (one.wi.z / pdf), pdf })
    }

    /// Albedo per channel, with the error of the least certain one.
    pub fn albedo(&self, wo: DVec3) -> (Rgb, f64) {
        let of = |p: &Part| {
            let Integral { value, error } = p.model.albedo(wo);
            (p.tint * value, p.tint.max_element() * error)
        };
        self.parts.iter().map(of).fold((Rgb::ZERO, 0.0), |(v, e), (value, error)| (v + value, e + error))
    }
}
