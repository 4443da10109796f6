//! The models that the lesson compares, each with the style that it keeps.

use glam::DVec3;
use lightbench::bsdf::{
    Blinn, BlinnScale, CookTorrance, Distribution, Model, OrenNayar, OrenNayarForm, ParameterError, Phong,
    Shadowing,
};
use lightbench::fresnel::Fresnel;
use lightbench::measure::Method;

/// Facets that reflect everything: what is lost is lost by the model.
pub const WHITE: Fresnel = Fresnel::Schlick { f0: 1.0 };
pub const GLASS: Fresnel = Fresnel::Dielectric { ior: 1.5 };
pub const GOLD: Fresnel = Fresnel::Conductor { eta: 0.143, k: 3.983 }; // red light

/// A direction at an angle [degrees] with the normal.
pub fn view(degrees: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    DVec3::new(sin, 0.0, cos)
}

/// The six of the furnace: everything that can be white is.
pub fn contestants() -> Result<Vec<(Method, Model)>, ParameterError> {
    let facets = |d, s| CookTorrance::new(0.5, d, s, WHITE);
    Ok(vec![
        (
            Method::new("Oren–Nayar full, σ = 0.5").styled(4),
            OrenNayar::new(1.0, 0.5, OrenNayarForm::Full)?.into(),
        ),
        (Method::new("Phong (A 4.7), n = 10").styled(1), Phong::new(10.0)?.into()),
        (
            Method::new("Blinn (n + 8)/8π, n = 10").styled(3),
            Blinn::new(10.0)?.scaled(BlinnScale::Eighth).into(),
        ),
        (Method::new("Blinn exact, n = 10").styled(5), Blinn::new(10.0)?.into()),
        (
            Method::default_of("GGX, Smith, α = 0.5").styled(0),
            facets(Distribution::Ggx, Shadowing::Smith)?.into(),
        ),
        (
            Method::new("Beckmann, V-cavity, m = 0.5").styled(2),
            facets(Distribution::Beckmann, Shadowing::VCavity)?.into(),
        ),
    ])
}
