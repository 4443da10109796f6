//! The light ray of [A ill. 67] as printed, for lessons; what holds is [`super::Attenuation`] and a scene's blocker.

use crate::color::Rgb;

/// The tolerance of A's shadow test, in whatever unit the scene has.
pub const LAMBDA: f64 = 0.000_001;

/// Its attenuation: `min(1, 1/(a₀ + a₁ d + a₂ d²))`.
///
/// The cap hides that the law diverges at the light: with `a₂ = 1` alone all places nearer than 1, of whatever unit, are
/// lit alike. Coefficients that are all 0 give 1 everywhere.
pub fn attenuation_as_printed([a0, a1, a2]: [f64; 3], d: f64) -> f64 {
    let attenuation = 1.0 / (a0 + a1 * d + a2 * d * d);
    if attenuation > 1.0 { 1.0 } else { attenuation }
}

/// Its shadow test: does an object that the light ray meets at `blocker` from the light hide a place at `place` from it?
///
/// [`LAMBDA`] is a length without the scene's size: in a scene of 10⁻⁶ nothing throws a shadow, and in one of 10¹¹ it is
/// lost in rounding, so that surfaces hide themselves (which A avoids by skipping the object that is lit).
pub fn hides_as_printed(blocker: f64, place: f64) -> bool {
    blocker < place - LAMBDA
}

/// Its answer, "how much light or colour arrives": `color · intensity · attenuation`, or nothing in shadow.
///
/// Neither an irradiance nor a radiance: the reflection model that it is multiplied by decides.
pub fn light_ray_as_printed(color: Rgb, intensity: f64, attenuation: f64, is_shadowed: bool) -> Rgb {
    let shadow = if is_shadowed { 0.0 } else { 1.0 };
    color * (attenuation * shadow * intensity)
}
