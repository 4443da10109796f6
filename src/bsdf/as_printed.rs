//! The formulas of [A §3.3, §4.2] as printed, for lessons; what holds is [`super::Lambert`] and [`super::Phong`].

use crate::color::Rgb;
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, TAU};

/// [A (4.5)], "Lambertian diffuse": `I = c₁/π`, called an intensity.
///
/// It is the BRDF of a matt surface; taken for the light that leaves, as printed, it lacks the cosine: a
/// surface lit at a grazing angle would shine like one lit from above.
pub fn lambertian_as_printed(c1: f64) -> f64 {
    c1 * FRAC_1_PI
}

/// [A (4.6)], "Phong": `I = cos(u, n)`.
///
/// It is Lambert's cosine law without `ρ/π`; Phong's own model is a highlight, and looks at the viewer.
pub fn phong_as_printed(cos_theta_i: f64) -> f64 {
    cos_theta_i
}

/// [A (4.7)], "cosine lobe": `I = (refl(−u, n) · v)^c₁ (c₁ + 2)/2π`.
///
/// The product is not cut off at 0: behind the lobe an odd exponent makes light negative, an even one
/// makes a second lobe, and one with a fraction makes NaN. Above, its energy is exact at normal incidence only.
pub fn cosine_lobe_as_printed(u: DVec3, n: DVec3, v: DVec3, c1: f64) -> f64 {
    let reflected = n * (2.0 * u.dot(n)) - u;
    reflected.dot(v).powf(c1) * (c1 + 2.0) / TAU
}

/// [A ill. 21], the code of the highlight: the viewer's direction is mirrored, and its cosine with the light's raised.
///
/// It is Phong's power, and right as far as it goes; it asks neither whether the light stands above the surface, nor how
/// much of it arrives.
pub fn highlight_as_printed(
    to_light: DVec3,
    n: DVec3,
    to_viewer: DVec3,
    shininess: f64,
    specular: f64,
) -> f64 {
    let mirrored = n * (2.0 * to_viewer.dot(n)) - to_viewer;
    match to_light.dot(mirrored) {
        cos if cos > 0.0 => cos.powf(shininess) * specular,
        _ => 0.0,
    }
}

/// [A §3.3] as worded: the product of the directions to light and viewer, raised.
///
/// The normal does not enter. It shines where light and viewer stand side by side, on whatever surface.
pub fn highlight_as_worded(to_light: DVec3, to_viewer: DVec3, shininess: f64, specular: f64) -> f64 {
    match to_light.dot(to_viewer) {
        cos if cos > 0.0 => cos.powf(shininess) * specular,
        _ => 0.0,
    }
}

/// [A ill. 68], the light that is reflected towards the viewer: `color (ambient + power brdf + highlight)`.
///
/// `power` is what arrives, shadow and attenuation included; the highlight is not multiplied by it, so that it shines in
/// shadows, whatever the lamp's colour and distance. It takes the colour of the material instead, and ambient
/// light comes once for each lamp, since the sum runs over the lamps.
pub fn reflected_light_as_printed(color: Rgb, ambient: Rgb, power: Rgb, brdf: f64, highlight: f64) -> Rgb {
    color * (ambient + power * brdf + highlight)
}
