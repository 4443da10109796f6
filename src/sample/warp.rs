//! From the unit square to directions and surfaces, with the density of what comes out.
//!
//! A warp `x(u)` maps uniform points `u` of [0,1)² to points `x` whose density is `x_pdf`; the
//! determinant of the map is its reciprocal. All maps are total: edges and corners of the square are
//! fine, and every direction is unit to within `γ₆` (`num::gamma(6)`), as the comments derive.
//! Directions stand in a local frame whose pole is `z`.
//!
//! Directions are made from `h = 1 − cos θ`, never from `cos θ`:
//!
//! ```text
//! cos θ = 1 − h,    sin θ = √(h (2 − h)),    cos²θ + sin²θ = 1 for every h, rounded or not       (1)
//! ```
//!
//! so that a narrow cone keeps all its digits. Rounding in (1): one in `cos θ`; `2 − h`, the product and the
//! root leave `2u` in `sin θ`, times `cos φ` (an ulp, `2u`, of the mathematical library) and
//! one more product: `5u` in each coordinate, hence in the length, and `γ₆` with the second-order terms.

use super::LARGEST_BELOW_ONE;
use crate::num::gamma;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// A direction, uniform over the sphere: `z` is uniform in [−1, 1] (Archimedes).
///
/// ```text
/// z = 1 − 2 u_x,    φ = 2π u_y
/// ```
///
/// - Domain: `u` in `[0,1]²`. `u_x = 0` is the north pole, `u_x = 1` the south pole.
/// - Accuracy: unit to `γ₆`.
/// - Source: Archimedes, *On the Sphere and Cylinder*; against [A ill. 46], see [`sphere_as_printed`].
#[inline]
pub fn uniform_sphere(u: DVec2) -> DVec3 {
    uniform_cone(u, 2.0)
}

/// Density of [`uniform_sphere`] [sr⁻¹]: `1/4π` everywhere.
#[inline]
pub const fn uniform_sphere_pdf() -> f64 {
    FRAC_1_PI / 4.0
}

/// A direction, uniform over the hemisphere about `z`.
///
/// - Domain: `u` in [0,1)²; then `0 < z ≤ 1`, so a sample never lies in the horizon.
/// - Accuracy: unit to `γ₆`.
#[inline]
pub fn uniform_hemisphere(u: DVec2) -> DVec3 {
    uniform_cone(u, 1.0)
}

/// Density of [`uniform_hemisphere`] [sr⁻¹]: `1/2π` above the horizon, 0 in it and below.
#[inline]
pub fn uniform_hemisphere_pdf(w: DVec3) -> f64 {
    if w.z > 0.0 { FRAC_1_PI / 2.0 } else { 0.0 }
}

/// A direction, uniform in the cone of half angle `θ_max` about `z`; `versine = 1 − cos θ_max`.
///
/// ```text
/// 1 − cos θ = versine · u_x,    φ = 2π u_y
/// ```
///
/// The versine, `sin²θ_max / (1 + cos θ_max)` for narrow cones, is asked for because a cosine near 1
/// has no digits left for the angle: a lamp that covers 10⁻⁸ rad has cosine 1.
///
/// - Domain: `0 ≤ versine ≤ 2`, `u` in `[0,1]²`. Versine 0 is the pole alone, 1 the hemisphere, 2 the sphere.
/// - Accuracy: unit to `γ₆`; `sin θ` relative to `γ₃`.
/// - NaN in, NaN out.
#[inline]
pub fn uniform_cone(u: DVec2, versine: f64) -> DVec3 {
    debug_assert!(!(versine < 0.0 || versine > 2.0), "versine {versine} outside [0, 2]");
    let h = versine * u.x;
    polar((h * (2.0 - h)).sqrt(), 1.0 - h, TAU * u.y)
}

/// Density of [`uniform_cone`] [sr⁻¹]: `1/(2π versine)` inside, 0 outside.
///
/// - Domain: `0 < versine ≤ 2`; versine 0 is a point mass, its density `+∞` at the pole.
/// - Accuracy: the rim is widened by `γ₁₆` of the versine, so that no direction made by the warp counts as
///   outside: five roundings in each coordinate, doubled by squares, and six here.
#[inline]
pub fn uniform_cone_pdf(w: DVec3, versine: f64) -> f64 {
    if versine_of(w) <= versine * (1.0 + gamma(16)) { FRAC_1_PI / 2.0 / versine } else { 0.0 }
}

/// `1 − cos θ` of a unit vector, without cancellation on the upper side.
#[inline]
fn versine_of(w: DVec3) -> f64 {
    if w.z > 0.0 { (w.x * w.x + w.y * w.y) / (1.0 + w.z) } else { 1.0 - w.z }
}

/// A direction about `z` with density proportional to its cosine: the lobe of a diffuse surface.
///
/// A uniform point of the disc is lifted onto the hemisphere (Malley):
///
/// ```text
/// (x, y) = r (cos φ, sin φ) = uniform_disc(u),    z = √((1 − r)(1 + r))
/// ```
///
/// - Domain: `u` in `[0,1]²`; `r` ends at `1 − 2⁻⁵³`, so that `z ≥ 1.4e-8`: a sample never lies in the
///   horizon, where its density would be 0. (Only the outermost points move, by half an ulp.)
/// - Accuracy: unit to `γ₆`: three roundings in `x`, `y` beside the library's, four in `z`.
/// - Source: Malley (1988); disc by Shirley & Chiu (1997).
#[inline]
pub fn cosine_hemisphere(u: DVec2) -> DVec3 {
    let (r, phi) = concentric(u);
    let r = r.clamp(-LARGEST_BELOW_ONE, LARGEST_BELOW_ONE);
    polar(r, ((1.0 - r) * (1.0 + r)).sqrt(), phi)
}

/// Density of [`cosine_hemisphere`] [sr⁻¹]: `cos θ / π` above the horizon, 0 in it and below.
#[inline]
pub fn cosine_hemisphere_pdf(w: DVec3) -> f64 {
    w.z.max(0.0) * FRAC_1_PI
}

/// A point, uniform over the unit disc; squares about the centre become circles.
///
/// ```text
/// a = 2u_x − 1,  b = 2u_y − 1;    r = a, φ = π/4 · b/a  if |a| > |b|,   else  r = b, φ = π/2 − π/4 · a/b
/// ```
///
/// Neighbours stay neighbours and cells stay compact, so that stratified sets stay stratified: the
/// polar map `r = √u_x` cuts the disc into long slivers.
///
/// - Domain: `u` in `[0,1]²`. The centre of the square is the centre, its boundary the boundary circle.
/// - Accuracy: within the disc of radius `1 + γ₃`.
/// - Source: Shirley & Chiu, *A low distortion map between disk and square*, JGT 2(3) (1997).
#[inline]
pub fn uniform_disc(u: DVec2) -> DVec2 {
    let (r, phi) = concentric(u);
    let (sin, cos) = phi.sin_cos();
    DVec2::new(r * cos, r * sin)
}

/// Density of [`uniform_disc`] [per area]: `1/π` in the unit disc, 0 outside.
///
/// - Accuracy: the rim is widened by `γ₁₀`: three roundings in each coordinate, doubled by squares, and two here.
#[inline]
pub fn uniform_disc_pdf_area(p: DVec2) -> f64 {
    if p.length_squared() <= 1.0 + gamma(10) { FRAC_1_PI } else { 0.0 }
}

/// Polar coordinates of the concentric map; `r` in [−1, 1] carries the side, `φ` lies in [−π/4, 3π/4].
#[inline]
fn concentric(u: DVec2) -> (f64, f64) {
    let (a, b) = (2.0 * u.x - 1.0, 2.0 * u.y - 1.0);
    if a.abs() > b.abs() {
        (a, FRAC_PI_4 * (b / a))
    } else if b != 0.0 {
        (b, FRAC_PI_2 - FRAC_PI_4 * (a / b))
    } else {
        (a + b, 0.0) // the centre, or NaN
    }
}

/// Barycentric coordinates of a point, uniform over a triangle.
///
/// ```text
/// s = √u_x,    (b₀, b₁, b₂) = (1 − s, s (1 − u_y), s u_y)
/// ```
///
/// - Domain: `u` in `[0,1]²`; no coordinate is negative.
/// - Accuracy: the coordinates sum to 1 within `γ₄`.
/// - Source: Turk, *Generating random points in triangles*, Graphics Gems (1990).
#[inline]
pub fn uniform_triangle(u: DVec2) -> DVec3 {
    let s = u.x.sqrt();
    DVec3::new(1.0 - s, s * (1.0 - u.y), s * u.y)
}

/// Barycentric coordinates of a point, uniform over a triangle, by folding the square [A ill. 45].
///
/// ```text
/// (a, b) = u, or (1, 1) − u beyond the diagonal a + b = 1;    (b₀, b₁, b₂) = (a, b, 1 − a − b)
/// ```
///
/// Cheaper than [`uniform_triangle`] by a root, but two far corners of the square land in one place, so
/// that stratified sets lose half their strata.
///
/// - Domain: `u` in `[0,1]²`. The test is `b > 1 − a`, exact for multiples of 2⁻⁵³, where `a + b > 1` rounds:
///   no coordinate is negative.
/// - Accuracy: the coordinates sum to 1 within `γ₄`.
/// - Source: [A ill. 45]; Turk (1990).
#[inline]
pub fn uniform_triangle_fold(u: DVec2) -> DVec3 {
    let (a, b) = if u.y > 1.0 - u.x { (1.0 - u.x, 1.0 - u.y) } else { (u.x, u.y) };
    DVec3::new(a, b, ((1.0 - a) - b).max(0.0))
}

/// Density of [`uniform_triangle`] and [`uniform_triangle_fold`] [per area]: one over the triangle's area.
///
/// - Domain: `area ≥ 0`; a triangle without area has `+∞`.
#[inline]
pub fn uniform_triangle_pdf_area(area: f64) -> f64 {
    1.0 / area
}

/// A direction about `z` with density proportional to `cosⁿ θ`: the lobe of Phong and Blinn.
///
/// ```text
/// cos θ = (1 − u_x)^(1/(n+1)),    φ = 2π u_y
/// ```
///
/// With `L = ln(1 − u_x)/(n+1)`, `cos θ = e^L` and `sin²θ = −expm1(2L)`: a sharp lobe keeps its width.
///
/// - Domain: finite `n ≥ 0`, `u` in [0,1)²; then `0 < z ≤ 1`. `n = 0` is the uniform hemisphere, `n = 1` the
///   cosine.
/// - Accuracy: unit to `γ₆`.
#[inline]
pub fn power_cosine(u: DVec2, n: f64) -> DVec3 {
    debug_assert!(!(n < 0.0), "negative exponent {n}");
    let log_cos = (-u.x).ln_1p() / (n + 1.0);
    polar((-(2.0 * log_cos).exp_m1()).sqrt(), log_cos.exp(), TAU * u.y)
}

/// Density of [`power_cosine`] [sr⁻¹]: `(n + 1)/2π · cosⁿ θ` above the horizon, 0 in it and below.
///
/// - Domain: finite `n ≥ 0`, unit `w`.
/// - Accuracy: relative, about `8 n sin²θ u` above 45° and `2 n u` below: an exponent `n` multiplies the error
///   of the logarithm. Near the pole `ln cos θ = ½ ln(1 − sin²θ)` keeps the digits that `z` has lost.
#[inline]
pub fn power_cosine_pdf(w: DVec3, n: f64) -> f64 {
    if w.z <= 0.0 {
        return 0.0;
    }
    let sin2 = w.x * w.x + w.y * w.y;
    let power = if sin2 < 0.5 { (0.5 * n * (-sin2).ln_1p()).exp() } else { w.z.powf(n) };
    (n + 1.0) * (FRAC_1_PI / 2.0) * power
}

/// A point of the unit sphere as [A ill. 46] prints it: **not uniform**, its points crowd at the poles.
///
/// ```text
/// a = u_x · π − 1.57,    b = u_y · 6.28,    (cos a cos b, cos a sin b, sin a)
/// ```
///
/// The latitude is uniform, but circles of latitude shrink towards the poles: `E[z²]` is 1/2 instead of
/// 1/3. For lessons; everything else takes [`uniform_sphere`].
///
/// - Domain: `u` in `[0,1]²`. The printed 1.57 and 6.28 leave a wedge of 0.0032 rad empty.
#[allow(clippy::approx_constant)] // the printed digits are the subject
pub fn sphere_as_printed(u: DVec2) -> DVec3 {
    // A's own digits.
    const PRINTED_HALF_PI: f64 = 1.57;
    const PRINTED_TAU: f64 = 6.28;
    let (sin_a, cos_a) = (u.x * PI - PRINTED_HALF_PI).sin_cos();
    polar(cos_a, sin_a, u.y * PRINTED_TAU)
}

/// Density of latitude and longitude taken uniformly [sr⁻¹]: `1/(2π² sin θ)`, not `1/4π`.
///
/// It is that of [`sphere_as_printed`] but for its rounded constants (0.05 %, and the empty wedge).
///
/// - Domain: unit `w`; at the poles `+∞`.
pub fn sphere_as_printed_pdf(w: DVec3) -> f64 {
    FRAC_1_PI * FRAC_1_PI / 2.0 / w.x.hypot(w.y)
}

#[inline]
fn polar(sin_theta: f64, cos_theta: f64, phi: f64) -> DVec3 {
    let (sin_phi, cos_phi) = phi.sin_cos();
    DVec3::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
}
