//! Lights: where light starts, and how much of it arrives.
//!
//! The documents measure light in different ways; here every light answers with the irradiance `E` that a surface
//! facing it receives, [W m⁻²], and a matt surface of reflectance ρ shows the radiance `ρ E cos θ / π`.
//!
//! | source | says | irradiance of a facing surface at distance d | here |
//! |---|---|---|---|
//! | A §4.1, ill. 67 | intensity `I`, coefficients a, b, c | `π I min(1, 1/(a + b d + c d²))` | [`PointLight::of_color`], [`Attenuation`] |
//! | A §4.3.3 | direction, `I` | `π I` | [`DirectionalLight::of_color`] |
//! | A §4.3.5 | triangle or sphere, `I`, alike in all directions | the mean of its points | [`Emission::Even`] |
//! | B §7.3.2 | flux `Φ` \[W\] | `Φ/(4π d²)` | [`PointLight::of_flux`] |
//! | C §1.8.3 D | `I`, `1/(d + d₀)` or `1/(a₀ + a₁ d + a₂ d²)` | `π I f(d)` | [`PointLight::of_color`], [`Attenuation`] |
//! | D §4.10 | `Color c`, no fall-off | `π c` | [`PointLight::of_color`], [`Emission::Even`] |
//! | ours | intensity `I` [W sr⁻¹] | `I/d²` | [`PointLight::of_intensity`], [`SpotLight`] |
//! | ours | irradiance `E` [W m⁻²] of parallel light | `E` | [`DirectionalLight::new`] |
//! | ours | radiance `L` [W m⁻² sr⁻¹] of a surface | `∫ L cos θₗ / d² dA` | [`Emission::Diffuse`] |

mod area;
pub mod as_printed;
mod attenuation;
mod emitter;
mod irradiance;
mod seen;
mod sharp;
mod solid_angle;

pub use area::{AreaLight, Emission, Measure};
pub use attenuation::Attenuation;
pub use emitter::{Emitter, Rectangle};
pub use irradiance::{polygon_irradiance, sphere_irradiance};
pub use seen::Seen;
pub use sharp::{Arrival, DirectionalLight, PointLight, SpotLight};
pub use solid_angle::{SphericalCap, SphericalRectangle, SphericalTriangle};

use glam::DVec3;

/// Any light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    Point(PointLight),
    Spot(SpotLight),
    Directional(DirectionalLight),
    Area(AreaLight),
}

impl Light {
    /// Shadow rays from each place.
    pub fn rays(&self) -> u32 {
        match self {
            Light::Area(light) => light.samples(),
            _ => 1,
        }
    }

    /// What the one ray to a light without size brings to `p`; none from an area light, which has many.
    #[inline]
    pub fn arriving(&self, p: DVec3) -> Option<Arrival> {
        match self {
            Light::Point(light) => Some(light.arriving(p)),
            Light::Spot(light) => Some(light.arriving(p)),
            Light::Directional(light) => Some(light.arriving()),
            Light::Area(_) => None,
        }
    }
}

impl From<PointLight> for Light {
    fn from(light: PointLight) -> Self {
        Light::Point(light)
    }
}

impl From<SpotLight> for Light {
    fn from(light: SpotLight) -> Self {
        Light::Spot(light)
    }
}

impl From<DirectionalLight> for Light {
    fn from(light: DirectionalLight) -> Self {
        Light::Directional(light)
    }
}

impl From<AreaLight> for Light {
    fn from(light: AreaLight) -> Self {
        Light::Area(light)
    }
}

/// Why no light stands there.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LightError {
    #[error("a light's direction must not be the zero vector")]
    NoDirection,
    #[error("a light's {what} must be positive, found {found}")]
    NotPositive { what: &'static str, found: f64 },
    #[error("a light's {what} must not be negative, found {found}")]
    Negative { what: &'static str, found: f64 },
    #[error("a light's attenuation needs a coefficient above 0, found none")]
    NoAttenuation,
    #[error("a light's {what} must be {allowed}, found {}°", found.to_degrees())]
    Angle { what: &'static str, allowed: &'static str, found: f64 },
}
