//! Reflection models: how a surface shares out the light that falls on it [A §4.2, D §5.3].
//!
//! A BRDF `f(wi, wo)` [sr⁻¹] is the radiance sent to `wo` per irradiance that comes from `wi`:
//!
//! ```text
//! L(wo) = ∫ f(wi, wo) L(wi) cos θᵢ dω                                                                (1)
//! ρ(wo) = ∫ f(wi, wo) cos θᵢ dω                       the albedo: what a white furnace would show    (2)
//! ```
//!
//! The cosine belongs to the transport (1), not to `f`. Directions are unit vectors in a local frame whose `z` is the
//! normal on the viewer's side, both away from the surface; the model answers 0 for those below.
//!
//! Three functions come together: `eval` is `f`; `sample` turns a point of [0,1)² into a direction `wi`; `pdf` is
//! the density of what it makes. And each model can say what share of the light it returns
//! ([`Brdf::albedo`], by quadrature, with its error), because a model that does not know what it loses cannot
//! be chosen.

pub mod as_printed;
mod blinn;
mod geometry;
pub mod highlight;
mod lafortune;
mod lambert;
mod lobes;
mod microfacet;
mod oren_nayar;
mod phong;

pub use blinn::{Blinn, BlinnScale};
pub use geometry::{Angles, Directions, Geometry, Half, mirror, sin_theta};
pub use lafortune::Lafortune;
pub use lambert::{CosinePrinted, Lambert};
pub use lobes::{Lobes, SampledRgb};
pub use microfacet::{CookTorrance, Distribution, FacetSampling, MIRROR_BELOW, Shadowing};
pub use oren_nayar::{OrenNayar, OrenNayarForm};
pub use phong::{Phong, PhongScale};

use crate::num::quadrature::Integral;
use glam::{DVec2, DVec3};

/// A parameter that a model cannot have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name} must be {expected}, found {found}")]
pub struct ParameterError {
    pub name: &'static str,
    pub expected: &'static str,
    pub found: f64,
}

/// The value, or what is wrong with it.
fn checked(
    name: &'static str,
    found: f64,
    expected: &'static str,
    holds: impl Fn(f64) -> bool,
) -> Result<f64, ParameterError> {
    let good = found.is_finite() && holds(found);
    if good { Ok(found) } else { Err(ParameterError { name, expected, found }) }
}

fn reflectance(name: &'static str, found: f64) -> Result<f64, ParameterError> {
    checked(name, found, "a reflectance from 0 to 1", |x| (0.0..=1.0).contains(&x))
}

/// An exponent: 0 and up.
fn exponent(found: f64) -> Result<f64, ParameterError> {
    checked("exponent", found, "finite and not negative", |x| x >= 0.0)
}

/// A sampled direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    pub wi: DVec3,
    /// `f cos θᵢ / pdf`: what the radiance from there is multiplied by. It is computed from the formulas, so that
    /// neither a density that overflows nor one that vanishes gets in.
    pub weight: f64,
    /// Density [sr⁻¹]; +∞ for the one direction of a mirror.
    pub pdf: f64,
}

/// Accuracy that [`Brdf::albedo`] asks of its quadrature: a thousandth of the last digit that tables are held to.
const ALBEDO_TOLERANCE: f64 = 1.0e-9;

/// A reflection model.
pub trait Brdf {
    /// `f` [sr⁻¹] of a pair of directions above the horizon, however described.
    fn value<G: Geometry>(&self, g: &G) -> f64;

    /// A direction made from `u` in [0,1)², with density [`Brdf::pdf`]; `None` where the lobe dips below the horizon, so
    /// that the density integrates to the probability of `Some`.
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled>;

    /// Density [sr⁻¹] of [`Brdf::sample`]; 0 in the horizon and below.
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64;

    /// Share of the light from all around that leaves towards `wo` (2); equally, of light *from* `wo` that is
    /// returned at all, if the model is reciprocal. 0 for `wo` in the horizon and below.
    fn albedo(&self, wo: DVec3) -> Integral;

    /// Does the model claim `f(wi, wo) = f(wo, wi)` (Helmholtz)?
    fn is_reciprocal(&self) -> bool {
        true
    }

    /// Does the model claim an albedo of at most 1 for every direction?
    fn conserves_energy(&self) -> bool;

    /// `f` [sr⁻¹] of two unit vectors in the local frame; 0 if one lies in the horizon or below.
    #[inline]
    fn eval(&self, wi: DVec3, wo: DVec3) -> f64 {
        if wi.z <= 0.0 || wo.z <= 0.0 { 0.0 } else { self.value(&Directions { wi, wo }) }
    }
}

/// Any of the models, told apart by a jump instead of a pointer.
#[derive(Clone, Debug, PartialEq)]
pub enum Model {
    Lambert(Lambert),
    CosinePrinted(CosinePrinted),
    Phong(Phong),
    Blinn(Blinn),
    Lafortune(Lafortune),
    OrenNayar(OrenNayar),
    CookTorrance(CookTorrance),
}

/// The same expression for whichever model it is.
macro_rules! each {
    ($self:expr, $model:ident => $answer:expr) => {
        match $self {
            Model::Lambert($model) => $answer,
            Model::CosinePrinted($model) => $answer,
            Model::Phong($model) => $answer,
            Model::Blinn($model) => $answer,
            Model::Lafortune($model) => $answer,
            Model::OrenNayar($model) => $answer,
            Model::CookTorrance($model) => $answer,
        }
    };
}

impl Brdf for Model {
    #[inline]
    fn eval(&self, wi: DVec3, wo: DVec3) -> f64 {
        each!(self, m => m.eval(wi, wo))
    }
    #[inline]
    fn value<G: Geometry>(&self, g: &G) -> f64 {
        each!(self, m => m.value(g))
    }
    #[inline]
    fn sample(&self, wo: DVec3, u: DVec2) -> Option<Sampled> {
        each!(self, m => m.sample(wo, u))
    }
    #[inline]
    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        each!(self, m => m.pdf(wi, wo))
    }
    fn albedo(&self, wo: DVec3) -> Integral {
        each!(self, m => m.albedo(wo))
    }
    fn is_reciprocal(&self) -> bool {
        each!(self, m => m.is_reciprocal())
    }
    fn conserves_energy(&self) -> bool {
        each!(self, m => m.conserves_energy())
    }
}

macro_rules! into_model {
    ($($model:ident),*) => {
        $(impl From<$model> for Model {
            fn from(model: $model) -> Model {
                Model::$model(model)
            }
        })*
    };
}
into_model!(Lambert, CosinePrinted, Phong, Blinn, Lafortune, OrenNayar, CookTorrance);

/// Is `wi`, made of `wo` above the horizon, above it too?
#[inline]
fn above(wi: DVec3, wo: DVec3) -> bool {
    wi.z > 0.0 && wo.z > 0.0
}

/// `∫ max(0, a + b cos φ) dφ` over the circle.
///
/// - Domain: `b ≥ 0`.
fn positive_part(a: f64, b: f64) -> f64 {
    use std::f64::consts::TAU;
    if a >= b {
        return TAU * a;
    }
    if a <= -b {
        return 0.0;
    }
    let edge = (-a / b).acos();
    // sin(edge) from (1 − x)(1 + x), which keeps its digits near the ends.
    let sin = ((1.0 - a / b) * (1.0 + a / b)).max(0.0).sqrt();
    (2.0 * (a * edge + b * sin)).max(0.0)
}
