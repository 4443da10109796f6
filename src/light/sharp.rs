//! Lights without size: their shadows are hard.

use super::{Attenuation, LightError};
use crate::color::Rgb;
use crate::frame::unit;
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, PI};

/// What one ray brings from a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// From the place that is lit to the light, or towards it if it is endlessly far.
    pub to: DVec3,
    /// The same, unit.
    pub wi: DVec3,
    /// The shadow ray's length in lengths of `to`: 1, or without end.
    pub t_max: f64,
    /// Irradiance [W m⁻²] of a surface that faces the light.
    pub irradiance: Rgb,
}

/// A point that shines alike in all directions [A §4.3.1, B §7.3.2, D §4.10.1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    pub position: DVec3,
    /// Irradiance of a facing surface where the attenuation's factor is 1 [W m⁻², times the law's unit].
    pub strength: Rgb,
    pub attenuation: Attenuation,
}

impl PointLight {
    /// D's light: a facing surface of reflectance ρ shows the radiance `ρ color`, at any distance.
    pub fn of_color(position: DVec3, color: Rgb) -> Self {
        PointLight { position, strength: color * PI, attenuation: Attenuation::None }
    }

    /// A light of that radiant intensity [W sr⁻¹]: `E = I/d²`.
    pub fn of_intensity(position: DVec3, intensity: Rgb) -> Self {
        PointLight { position, strength: intensity, attenuation: Attenuation::InverseSquare }
    }

    /// B's light, of that flux \[W\] in all directions: `E = Φ/(4π d²)` [B §7.3.2].
    pub fn of_flux(position: DVec3, flux: Rgb) -> Self {
        Self::of_intensity(position, flux * (FRAC_1_PI / 4.0))
    }

    pub fn with_attenuation(self, attenuation: Attenuation) -> Self {
        PointLight { attenuation, ..self }
    }

    /// What arrives at `p`; a place in the light itself has no direction to it, and `wi` is NaN there.
    ///
    /// - Domain: a finite difference of the two places. One whose powers might leave the range of numbers is counted along a unit vector,
    ///   so that a light at 10³⁰⁰ m shines as parallel light does.
    #[inline]
    pub fn arriving(&self, p: DVec3) -> Arrival {
        let to = self.position - p;
        let distance = to.length();
        if !(MODERATE.0..=MODERATE.1).contains(&distance) {
            return self.arriving_from_extremes(to);
        }
        Arrival { to, wi: to / distance, t_max: 1.0, irradiance: self.thinned(distance) }
    }

    #[cold]
    fn arriving_from_extremes(&self, to: DVec3) -> Arrival {
        let Some(wi) = unit(to) else {
            return Arrival { to, wi: DVec3::NAN, t_max: 1.0, irradiance: self.thinned(to.length()) };
        };
        let distance = to.abs().max_element() / wi.abs().max_element();
        Arrival { to: wi, wi, t_max: distance, irradiance: self.thinned(distance) }
    }

    /// Irradiance at a distance. What overflows ends at the largest number, so that no `0·∞` makes NaN of it.
    #[inline]
    fn thinned(&self, distance: f64) -> Rgb {
        let irradiance = self.strength * self.attenuation.factor(distance);
        if irradiance.is_finite() {
            return irradiance;
        }
        let factor = self.attenuation.factor(distance).min(f64::MAX);
        (self.strength.min(Rgb::splat(f64::MAX)) * factor).min(Rgb::splat(f64::MAX))
    }
}

/// Lengths [m] of which shapes may take the fourth power, as a torus does, and still have 10⁶⁰ to spare: 2^∓200.
const MODERATE: (f64, f64) = (6.223_015_277_861_142e-61, 1.606_938_044_258_990_3e60);

/// A point light in a shade that lets a cone of light out.
///
/// ```text
/// share(θ) = s²(3 − 2s),    s = (cos θ − cos θ_edge) / (cos θ_full − cos θ_edge) in [0,1]
/// ```
///
/// `θ` is the angle with the axis: all of it up to `θ_full`, none from `θ_edge` on.
///
/// - Accuracy: two unit vectors leave an angle uncertain by some roundings δ ≤ 13 u, and so a share by
///   `3δ/(θ_edge − θ_full)` at most. From the cosines it would be about `u/(θ_edge² − θ_full²)`: nothing is left at 10⁻⁸.
/// - Source: the smooth step is that of Pharr, Jakob & Humphreys, *Physically Based Rendering* (2023) §12.2.2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLight {
    point: PointLight,
    axis: DVec3,
    /// `1 − cos` of both angles: cosines of narrow cones have no digits left.
    full: f64,
    edge: f64,
}

impl SpotLight {
    /// `point` seen within the half angle `edge` about `direction`, and wholly within `full` \[rad\].
    ///
    /// - Domain: `0 ≤ full ≤ edge ≤ π`, `edge > 0`; equal angles make a hard rim.
    /// - Errors: others; a direction of length 0.
    pub fn new(point: PointLight, direction: DVec3, full: f64, edge: f64) -> Result<Self, LightError> {
        let axis = unit(direction).ok_or(LightError::NoDirection)?;
        if !(edge > 0.0 && edge <= PI) {
            return Err(LightError::Angle { what: "cone", found: edge, allowed: "above 0°, at most 180°" });
        }
        if !(full >= 0.0 && full <= edge) {
            return Err(LightError::Angle {
                what: "full cone",
                found: full,
                allowed: "from 0° to the cone's",
            });
        }
        let versine = |angle: f64| 2.0 * (0.5 * angle).sin().powi(2);
        Ok(SpotLight { point, axis, full: versine(full), edge: versine(edge) })
    }

    pub fn point(&self) -> &PointLight {
        &self.point
    }

    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Solid angle \[sr\] that all of the light would fill: `∫ share dω`, so that the flux is the intensity times this.
    ///
    /// ```text
    /// Ω = 2π ∫ share d(1 − cos θ) = π ((1 − cos θ_full) + (1 − cos θ_edge))
    /// ```
    ///
    /// The smooth step is one half on average. From no cone at all, 0, to the whole sphere, 4π.
    pub fn solid_angle(&self) -> f64 {
        PI * (self.full + self.edge)
    }

    /// Share of the point's light that is let out in a direction (unit).
    ///
    /// - Domain: unit vectors. The rim of the full cone belongs to it: that of a hard-edged cone has share 1, and
    ///   a full cone of 180° is the whole sphere, its back included.
    /// - NaN in, NaN out.
    pub fn share(&self, direction: DVec3) -> f64 {
        // 1 − cos θ = |direction − axis|²/2 keeps the digits of small angles; rounded unit vectors can exceed 2.
        let versine = 0.5 * (direction - self.axis).length_squared();
        let versine = if versine > 2.0 { 2.0 } else { versine };
        if versine <= self.full {
            1.0
        } else if versine >= self.edge {
            0.0
        } else {
            let s = (self.edge - versine) / (self.edge - self.full);
            s * s * (3.0 - 2.0 * s)
        }
    }

    /// What arrives at `p`.
    #[inline]
    pub fn arriving(&self, p: DVec3) -> Arrival {
        let all = self.point.arriving(p);
        Arrival { irradiance: all.irradiance * self.share(-all.wi), ..all }
    }
}

/// Parallel light from endlessly far away: the same everywhere, without attenuation [A §4.3.3, B §7.3.1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    /// Unit; where the light travels.
    direction: DVec3,
    /// Irradiance [W m⁻²] of a facing surface.
    pub irradiance: Rgb,
}

impl DirectionalLight {
    /// Light that travels along `direction` and brings `irradiance` [W m⁻²] to a facing surface.
    ///
    /// - Errors: a direction of length 0.
    pub fn new(direction: DVec3, irradiance: Rgb) -> Result<Self, LightError> {
        Ok(DirectionalLight { direction: unit(direction).ok_or(LightError::NoDirection)?, irradiance })
    }

    /// In the documents' measure: a facing surface of reflectance ρ shows the radiance `ρ color`.
    pub fn of_color(direction: DVec3, color: Rgb) -> Result<Self, LightError> {
        Self::new(direction, color * PI)
    }

    pub fn direction(&self) -> DVec3 {
        self.direction
    }

    /// What arrives, anywhere.
    #[inline]
    pub fn arriving(&self) -> Arrival {
        let wi = -self.direction;
        Arrival { to: wi, wi, t_max: f64::INFINITY, irradiance: self.irradiance }
    }
}
