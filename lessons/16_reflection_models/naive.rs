//! The formulas as they are usually typed, from cosines alone: wrong where cosines have no digits left.

use glam::DVec3;
use lightbench::bsdf::{Angles, Brdf, Phong, mirror};
use lightbench::measure::{Method, Point, Series, Tally, log_spaced};
use std::f64::consts::{PI, TAU};

/// GGX with Smith's shadowing, `F = 1`, from the unit half vector's cosines.
///
/// ```text
/// D = α² / (π (c² (α² − 1) + 1)²),    Λ = ½ (√(1 + α² (1 − c²)/c²) − 1),    f = D / ((1 + Λᵢ + Λₒ) 4 cᵢ cₒ)
/// ```
pub fn naive_ggx(roughness: f64, wi: DVec3, wo: DVec3) -> f64 {
    let (a2, ch) = (roughness * roughness, (wi + wo).normalize().z);
    let base = ch * ch * (a2 - 1.0) + 1.0;
    let lambda = |c: f64| 0.5 * ((1.0 + a2 * (1.0 - c * c) / (c * c)).sqrt() - 1.0);
    let shadowing = 1.0 / (1.0 + lambda(wi.z) + lambda(wo.z));
    a2 / (PI * base * base) * shadowing / (4.0 * wi.z * wo.z)
}

/// Phong's lobe by `powf`.
pub fn naive_phong(n: f64, wi: DVec3, wo: DVec3) -> f64 {
    (n + 2.0) / TAU * mirror(wo).dot(wi).max(0.0).powf(n)
}

/// Errors over the exponent, at the angle where the lobe has fallen by a factor e, of the naive and of the default.
pub fn over_exponents() -> [(Method, Series); 2] {
    let exponents = log_spaced(1.0, 1.0e15, 31);
    let series = |f: &dyn Fn(f64, DVec3, DVec3) -> f64| {
        Series::over(&exponents, |n| {
            let mut tally = Tally::new();
            for k in 0..24 {
                let theta = 0.1 + 0.05 * f64::from(k);
                // cosⁿ a = 1/e at a ≈ √(2/n)
                let g = Angles::new((theta + (2.0 / n).sqrt()).min(1.5), theta, PI);
                let pair = g.directions();
                let truth = Phong::new(n).map_or(f64::NAN, |p| p.value(&g));
                tally.answer(Some(f(n, pair.wi, pair.wo)), Some(truth));
            }
            let point: Point = tally.rms_at(n);
            point
        })
    };
    let ours = |n: f64, wi: DVec3, wo: DVec3| Phong::new(n).map_or(f64::NAN, |p| p.eval(wi, wo));
    [
        (Method::default_of("from 1 − cos a").styled(0), series(&ours)),
        (Method::new("powf(cos a, n)").styled(1), series(&naive_phong)),
    ]
}
