//! The formulas of [A §4.2] as printed, for lessons; what holds is [`super::Lambert`] and [`super::Phong`].

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
