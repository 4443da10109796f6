//! Reflection models: their values and their albedos.

use super::{Cell, Row, RowError, Topic};
use crate::bsdf::{
    Angles, Blinn, BlinnScale, Brdf, CookTorrance, Distribution, Lambert, Model, OrenNayar, OrenNayarForm,
    ParameterError, Phong, Shadowing,
};
use crate::fresnel::Fresnel;
use std::f64::consts::FRAC_PI_2;

const ABOUT_MODELS: &str = "lambert (p0 ρ), phong_mod, blinn_n8, blinn_exact (p0 n), oren_nayar_qual, oren_nayar_full (p0 ρ, p1 σ), \
                            cook_torrance_schlick (p0 m, p1 F0), cook_torrance_fresnel (p0 m, p1 η, p2 k)";

pub(super) const BRDF_VALUES: Topic = Topic {
    name: "brdf_values",
    about: "value of a reflection model for a pair of directions; the mirror direction lies at dphi = π",
    methods: &[
        ("angles", "half vector and mirror angle from half angles, where nothing cancels"),
        ("vectors", "from unit vectors, as rays have them"),
    ],
    inputs: &[
        ("model", ABOUT_MODELS),
        ("p0", ""),
        ("p1", ""),
        ("p2", ""),
        ("p3", ""),
        ("theta_i", "rad"),
        ("theta_o", "rad"),
        ("dphi", "rad"),
    ],
    outputs: &[("f", "1/sr")],
    answer: values,
};

pub(super) const BRDF_ALBEDO: Topic = Topic {
    name: "brdf_albedo",
    about: "share of the light from a uniform sky that a reflection model returns towards theta_o, by quadrature",
    methods: &[],
    inputs: &[("model", ABOUT_MODELS), ("p0", ""), ("p1", ""), ("p2", ""), ("theta_o", "rad")],
    outputs: &[("albedo", "")],
    answer: albedo,
};

/// The model of a row.
fn model(row: &Row) -> Result<Model, RowError> {
    let at = |error: ParameterError| {
        let column = match error.name {
            "sigma" | "f0" | "eta" => "p1",
            "k" => "p2",
            _ => "p0",
        };
        row.error(column, error.expected)
    };
    let (p0, p1) = (|| row.number("p0"), || row.number("p1"));
    let facets = |fresnel| {
        let made = CookTorrance::new(p0()?, Distribution::Beckmann, Shadowing::VCavity, fresnel);
        made.map(Model::from).map_err(at)
    };
    match row.text("model") {
        "lambert" => Lambert::new(p0()?).map(Model::from).map_err(at),
        "phong_mod" => Phong::new(p0()?).map(Model::from).map_err(at),
        "blinn_n8" => Blinn::new(p0()?).map(|b| b.scaled(BlinnScale::Eighth).into()).map_err(at),
        "blinn_exact" => Blinn::new(p0()?).map(Model::from).map_err(at),
        "oren_nayar_qual" => {
            OrenNayar::new(p0()?, p1()?, OrenNayarForm::Qualitative).map(Model::from).map_err(at)
        }
        "oren_nayar_full" => OrenNayar::new(p0()?, p1()?, OrenNayarForm::Full).map(Model::from).map_err(at),
        "cook_torrance_schlick" => facets(Fresnel::Schlick { f0: p1()? }),
        "cook_torrance_fresnel" => facets(Fresnel::Conductor { eta: p1()?, k: row.number("p2")? }),
        _ => Err(row.error("model", &format!("one of: {ABOUT_MODELS}"))),
    }
}

/// An angle with the normal.
fn theta(row: &Row, column: &str) -> Result<f64, RowError> {
    let theta = row.number(column)?;
    let good = (0.0..=FRAC_PI_2).contains(&theta);
    if good { Ok(theta) } else { Err(row.error(column, "an angle from 0 to π/2")) }
}

fn values(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (model, dphi) = (model(row)?, row.number("dphi")?);
    let angles = Angles::new(theta(row, "theta_i")?, theta(row, "theta_o")?, dphi);
    let f = if method == "vectors" { model.value(&angles.directions()) } else { model.value(&angles) };
    Ok(vec![Cell::Number(f)])
}

fn albedo(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let model = model(row)?;
    let (sin, cos) = theta(row, "theta_o")?.sin_cos();
    Ok(vec![Cell::Number(model.albedo(glam::DVec3::new(sin, 0.0, cos)).value)])
}
