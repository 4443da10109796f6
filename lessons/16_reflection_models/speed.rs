//! Ways to sample a lobe, and fast forms against exact ones.

use super::models::{GLASS, GOLD};
use glam::DVec3;
use lightbench::bsdf::{
    Brdf, CookTorrance, Directions, Distribution, FacetSampling, Model, OrenNayar, OrenNayarForm,
    ParameterError, Shadowing, mirror,
};
use lightbench::fresnel::{Fresnel, normal_incidence};
use lightbench::measure::{Method, Point, Series, Spread, time_each};
use lightbench::num::statistics::Moments;
use lightbench::sample::{
    Sampler, cosine_hemisphere, cosine_hemisphere_pdf, point2, uniform_hemisphere, uniform_hemisphere_pdf,
};

/// Four ways to sample one lobe of facets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampler4 {
    Uniform,
    Cosine,
    AllFacets,
    VisibleFacets,
}

impl Sampler4 {
    pub const ALL: [Sampler4; 4] =
        [Sampler4::Uniform, Sampler4::Cosine, Sampler4::AllFacets, Sampler4::VisibleFacets];

    pub fn method(self) -> Method {
        match self {
            Sampler4::Uniform => Method::new("uniform").styled(5),
            Sampler4::Cosine => Method::new("cosine").styled(1),
            Sampler4::AllFacets => Method::new("all facets").styled(2),
            Sampler4::VisibleFacets => Method::default_of("facets that are seen").styled(0),
        }
    }
    pub fn facets(self) -> FacetSampling {
        if self == Sampler4::AllFacets { FacetSampling::All } else { FacetSampling::Visible }
    }

    /// `f cos/pdf` of one sample; 0 where the lobe dips below the horizon.
    fn weight(self, model: &CookTorrance, wo: DVec3, u: glam::DVec2) -> f64 {
        let blind = |wi: DVec3, pdf: f64| model.eval(wi, wo) * wi.z / pdf;
        match self {
            Sampler4::Uniform => {
                let wi = uniform_hemisphere(u);
                blind(wi, uniform_hemisphere_pdf(wi))
            }
            Sampler4::Cosine => {
                let wi = cosine_hemisphere(u);
                blind(wi, cosine_hemisphere_pdf(wi))
            }
            _ => model.sample(wo, u).map_or(0.0, |made| made.weight),
        }
    }

    /// The albedo, estimated.
    pub fn mean(self, model: &CookTorrance, wo: DVec3, samples: u32, seed: u64, run: u32) -> f64 {
        let sum: f64 = (0..samples).map(|i| self.weight(model, wo, point2(seed, run, i))).sum();
        sum / f64::from(samples)
    }

    /// Standard deviation of one sample.
    fn deviation(self, model: &CookTorrance, wo: DVec3, (samples, seed): (u32, u64)) -> Option<f64> {
        let moments: Moments = (0..samples).map(|i| self.weight(model, wo, point2(seed, 0, i))).collect();
        moments.variance().map(f64::sqrt)
    }
}

/// Standard deviation of one sample over the mean, by each way, over the roughness.
pub fn scatter(widths: &[f64], batch: (u32, u64)) -> super::Contest {
    let wo = super::view(super::GRAZING);
    let lobes: Vec<(f64, Option<(CookTorrance, f64)>)> = widths
        .iter()
        .map(|width| {
            let lobe = CookTorrance::ggx(*width, super::WHITE).ok();
            (*width, lobe.map(|lobe| (lobe, lobe.albedo(wo).value)))
        })
        .collect();
    let point = |way: Sampler4, (width, lobe): &(f64, Option<(CookTorrance, f64)>)| {
        let relative = |(lobe, truth): &(CookTorrance, f64)| {
            Some(way.deviation(&lobe.sampled(way.facets()), wo, batch)? / truth)
        };
        let error = lobe.as_ref().and_then(relative).map(Spread::exact);
        Point { error, ..Point::at(*width) }
    };
    Sampler4::ALL
        .map(|way| (way.method(), Series::new(lobes.iter().map(|lobe| point(way, lobe)).collect())))
        .into()
}

/// A fast form and the exact one that it stands for.
pub struct Rival {
    pub method: Method,
    pub series: Series,
    /// Whom it is held against.
    pub exact: &'static str,
    /// Largest difference of the albedos over all angles.
    pub albedo: f64,
}

/// Times and errors: each fast form against its exact one, which errs by nothing.
pub fn rivals((pairs, angles): (u32, u32), seed: u64) -> Result<Vec<Rival>, ParameterError> {
    let pairs: Vec<Directions> = (0..pairs).map(|i| pair(seed, i)).collect();
    let facets = |s, f| CookTorrance::new(0.4, Distribution::Beckmann, s, f).map(Model::from);
    let ggx = |f| CookTorrance::ggx(0.4, f).map(Model::from);
    let matt = |form| OrenNayar::new(0.8, 0.5, form).map(Model::from);
    let schlick = Fresnel::Schlick { f0: normal_incidence(1.0, 1.5) };
    let (fresnel, full, smith) = (ggx(GLASS)?, matt(OrenNayarForm::Full)?, facets(Shadowing::Smith, GOLD)?);
    let all = [
        ("Fresnel, exact", 0, fresnel.clone(), fresnel.clone(), "itself"),
        ("Fresnel by Schlick", 1, ggx(schlick)?, fresnel, "Fresnel, exact"),
        ("Oren–Nayar, full", 2, full.clone(), full.clone(), "itself"),
        ("Oren–Nayar, short", 3, matt(OrenNayarForm::Qualitative)?, full, "Oren–Nayar, full"),
        ("Beckmann, Smith", 4, smith.clone(), smith.clone(), "itself"),
        ("Beckmann, V-cavity", 5, facets(Shadowing::VCavity, GOLD)?, smith.clone(), "Beckmann, Smith"),
        (
            "Beckmann, Smith by Walter's fit",
            6,
            facets(Shadowing::SmithRational, GOLD)?,
            smith,
            "Beckmann, Smith",
        ),
    ];
    Ok(all
        .into_iter()
        .map(|(name, style, model, exact, other)| {
            rival(name, style, &model, (&exact, other), (&pairs, angles))
        })
        .collect())
}

fn rival(
    name: &str,
    style: usize,
    model: &Model,
    (exact, other): (&Model, &'static str),
    (pairs, angles): (&[Directions], u32),
) -> Rival {
    let relative = |g: &Directions| {
        let (found, truth) = (model.value(g), exact.value(g));
        if truth == 0.0 { 0.0 } else { (found - truth).abs() / truth }
    };
    let errors: Vec<f64> = pairs.iter().map(relative).collect();
    let time = time_each(pairs.len(), || pairs.iter().map(|g| model.value(g)).sum::<f64>());
    let point = Point { error: Spread::rms(&errors), ..Point::at(1.0) }.timed(time);
    let albedo = |m: &Model, degrees: f64| m.albedo(super::view(degrees)).value;
    let off = |degrees: f64| (albedo(model, degrees) - albedo(exact, degrees)).abs();
    let angles = if model == exact { 0 } else { angles };
    Rival {
        method: Method::new(name).styled(style),
        series: Series::new(vec![point]),
        exact: other,
        albedo: (0..angles).map(|k| off(90.0 * f64::from(k) / f64::from(angles))).fold(0.0, f64::max),
    }
}

/// A pair of directions: every second one near each other's mirror direction, where highlights are.
fn pair(seed: u64, i: u32) -> Directions {
    let mut s = Sampler::new(seed, 1, i);
    let (wo, any) = (uniform_hemisphere(s.next_2d()), uniform_hemisphere(s.next_2d()));
    let wi = if i.is_multiple_of(2) { (mirror(wo) + any * 0.5).normalize() } else { any };
    Directions { wi, wo }
}
