//! From blocks to materials.

use crate::bsdf::{
    Blinn, BlinnScale, CookTorrance, Distribution, Lafortune, Lambert, Lobes, Model, OrenNayar,
    OrenNayarForm, ParameterError, Phong, PhongScale, Shadowing,
};
use crate::color::Rgb;
use crate::fresnel::Fresnel;
use crate::scene::Material;
use crate::scene_file::blocks::READ_BY;
use crate::scene_file::diagnostic::Diagnostic;
use crate::scene_file::parse::Block;
use glam::DVec3;

/// The material of a block. What its model does not read is told in warnings.
pub fn material(block: &Block, log: &mut Vec<Diagnostic>) -> Material {
    let color = |name: &str| DVec3::from(block.numbers(name));
    let one = |name: &str| block.numbers::<1>(name)[0];
    let model = block.word("Model").unwrap_or("lambert");
    for (param, models) in READ_BY {
        if let Some(entry) = block.entry(param).filter(|e| e.value.is_some() && !models.contains(&model)) {
            let message = format!("`{param}` has no effect with `Model {model}`");
            let d = Diagnostic::warning(entry.keyword.clone(), message);
            log.push(d.help(format!("it is read by {}", readers(models))));
        }
    }
    let mut material = Material {
        name: block.word("Name").unwrap_or_default().to_owned(),
        diffuse: color("DiffuseColor"),
        specular: color("SpecularColor"),
        emissive: color("EmissiveColor"),
        roughness: one("Roughness"),
        opacity: one("Opacity"),
        ior: one("RefractionIndex"),
        reflection_angle: one("ReflectionAngle").to_radians(),
        reflection_amount: one("ReflectionAmount"),
        model: None,
    };
    if !block.is_broken() && model != "lambert" {
        match lobes(block, model, &material) {
            Ok(lobes) => material.model = Some(lobes),
            Err(error) => log.push(refused(block, &error)),
        }
    }
    material
}

/// Metals have indices from 0.03 on; the powers of those below this leave the range of numbers.
const LEAST_INDEX: f64 = 1.0e-6;

/// The format's ranges are those of the models, but for an index of refraction of 0.
fn refused(block: &Block, error: &ParameterError) -> Diagnostic {
    let [n, k] = block.numbers("FacetIndex");
    if block.entry("FacetIndex").is_none() {
        return Diagnostic::error(block.keyword.clone(), format!("this is no material: {error}"));
    }
    let d = Diagnostic::error(block.span("FacetIndex"), "`FacetIndex` has no index of refraction");
    d.expected("n and k from 0 to 1000000, and n at least 0.000001").found(format!("n = {n} and k = {k}"))
}

/// The models that read a parameter, as a message names them.
fn readers(models: &[&str]) -> String {
    models.iter().filter(|m| **m != "lambert").copied().collect::<Vec<_>>().join(", ")
}

fn lobes(block: &Block, model: &str, m: &Material) -> Result<Lobes, ParameterError> {
    let [exponent] = block.numbers("Exponent");
    let lobe: Model = match model {
        "oren-nayar" => {
            let form = match block.word("Form") {
                Some("full") => OrenNayarForm::Full,
                _ => OrenNayarForm::Qualitative,
            };
            return rough_and_matt(m.diffuse, block.numbers::<1>("Slope")[0].to_radians(), form);
        }
        "phong" => {
            let scale = match block.word("Normalisation") {
                Some("none") => PhongScale::Raw,
                Some("shading") => PhongScale::OverCosine,
                _ => PhongScale::Normalised,
            };
            Phong::new(exponent)?.scaled(scale).into()
        }
        "blinn" => {
            let scale = match block.word("Normalisation") {
                Some("none") => BlinnScale::Raw,
                Some("shading") => BlinnScale::OverCosine,
                _ => BlinnScale::Exact,
            };
            Blinn::new(exponent)?.scaled(scale).into()
        }
        "lafortune" => Lafortune::new(DVec3::from(block.numbers("Lobe")), exponent, 1.0)?.into(),
        "cook-torrance" => return metal(block, m),
        _ => return Lobes::matt_and_glossy(m.diffuse, m.specular, m.roughness),
    };
    Lobes::new([(m.diffuse, Lambert::new(1.0)?.into()), (m.specular, lobe)])
}

/// Oren and Nayar's model in colour: light that is reflected twice is coloured twice, which only the full form knows of.
fn rough_and_matt(diffuse: Rgb, sigma: f64, form: OrenNayarForm) -> Result<Lobes, ParameterError> {
    if form == OrenNayarForm::Qualitative {
        return Lobes::new([(diffuse, OrenNayar::new(1.0, sigma, form)?.into())]);
    }
    let channel = |i: usize| -> Result<(Rgb, Model), ParameterError> {
        Ok((DVec3::AXES[i], OrenNayar::new(diffuse[i], sigma, form)?.into()))
    };
    Lobes::new([channel(0)?, channel(1)?, channel(2)?])
}

/// Lambert's law and small mirrors.
fn metal(block: &Block, m: &Material) -> Result<Lobes, ParameterError> {
    let facets = match block.word("Facets") {
        Some("beckmann") => Distribution::Beckmann,
        _ => Distribution::Ggx,
    };
    let shadowing = match block.word("Shadowing") {
        Some("v-cavity") => Shadowing::VCavity,
        _ => Shadowing::Smith,
    };
    let mirrors = |fresnel| CookTorrance::new(m.roughness, facets, shadowing, fresnel).map(Model::from);
    let matt = (m.diffuse, Lambert::new(1.0)?.into());
    if block.entry("FacetIndex").is_none() {
        return Lobes::new([matt].into_iter().chain(Lobes::schlick(m.specular, mirrors)?));
    }
    let [eta, k] = block.numbers("FacetIndex");
    if eta < LEAST_INDEX {
        let (name, expected) = ("n", "an index of refraction");
        return Err(ParameterError { name, expected, found: eta });
    }
    let tint = if block.entry("SpecularColor").is_some() { m.specular } else { Rgb::ONE };
    Lobes::new([matt, (tint, mirrors(Fresnel::Conductor { eta, k })?)])
}
