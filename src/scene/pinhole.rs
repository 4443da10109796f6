//! Light through a hole: how much passes, and how sharply [A §5.1, B §3, C §1.2].
//!
//! A camera obscura has its hole at the origin of camera space; the scene lies at `z < 0`, the film stands
//! at `z = depth`. All lengths share one unit.

use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Diameter of the first dark ring of a round hole's diffraction pattern, over `λ · depth / hole`.
const AIRY: f64 = 2.0 * 3.831_705_970_207_512 / PI; // the first zero of J₁; 2.44 in round numbers

/// The line of light that ends at `film` and has passed the hole at `hole`, backwards: its origin on
/// the film, and its direction towards the scene, of length `≥ depth`. The inverse of
/// [`super::obscura_from_camera`] for the hole's centre.
///
/// - Domain: finite; `depth > 0`.
pub fn obscura_line(film: DVec2, hole: DVec2, depth: f64) -> (DVec3, DVec3) {
    debug_assert!(depth > 0.0, "depth {depth}");
    (film.extend(depth), (hole - film).extend(-depth))
}

/// Solid angle \[sr\] of a round hole seen from a point on its axis.
///
/// ```text
/// Ω = 2π (1 − cos θ) = 2π tan²θ / (1 + tan²θ + √(1 + tan²θ)),    tan θ = radius / distance
/// ```
///
/// Of an isotropic lamp's photons the share `Ω/4π` passes.
///
/// - Domain: `radius ≥ 0`, `distance ≥ 0`, not both zero; distance 0 sees the half space, `2π`.
/// - Accuracy: relative error ≤ `num::gamma(10)`: nothing is subtracted.
/// - NaN in, NaN out.
pub fn hole_solid_angle(radius: f64, distance: f64) -> f64 {
    if distance <= 0.0 {
        return TAU;
    }
    let tan2 = (radius / distance) * (radius / distance);
    if tan2 == f64::INFINITY { TAU } else { TAU * (tan2 / (1.0 + tan2 + (1.0 + tan2).sqrt())) }
}

/// Share of a matt disc's light that arrives at another disc on the same axis, facing it at `distance`.
///
/// ```text
/// F = 2 b² / (S + √((S − 2ab)(S + 2ab))),   S = a² + b² + h²,   a = from, b = to, h = distance
/// ```
///
/// The irradiance of a film disc by a hole that shows nothing but radiance `L` is `π L F(film → hole)`.
///
/// - Domain: `from > 0`, `to ≥ 0`, `distance > 0`. From a point (`from → 0`) `b²/(b² + h²)` arrive.
/// - Accuracy: relative error ≤ `num::gamma(24)`: in `S − 2ab = (a − b)² + h²` the one subtraction acts on
///   inputs. Lengths are taken relative to the largest, so that no square overflows.
/// - NaN in, NaN out.
/// - Source: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-41.
pub fn coaxial_discs_share(from: f64, to: f64, distance: f64) -> f64 {
    let largest = from.max(to).max(distance);
    let (a, b, h) = (from / largest, to / largest, distance / largest);
    2.0 * b * b / (a * a + b * b + h * h + (a - b).hypot(h) * (a + b).hypot(h))
}

/// Diameter on the film of the spot that a point at `distance` makes through a hole of that diameter.
///
/// ```text
/// blur = hole (1 + depth / distance)
/// ```
///
/// - Domain: `distance > 0`, also infinite: a star's spot is as wide as the hole.
pub fn shadow_blur(hole: f64, depth: f64, distance: f64) -> f64 {
    hole + hole * depth / distance
}

/// Diameter on the film of the first dark ring round a point, spread by diffraction.
///
/// ```text
/// blur = 2.44 λ depth / hole
/// ```
///
/// - Domain: `hole > 0`. Holds where the film is far from the hole: `hole² ≪ λ depth`; beyond, it is small.
/// - Source: Airy, *On the Diffraction of an Object-glass with Circular Aperture* (1835).
pub fn diffraction_blur(hole: f64, depth: f64, wavelength: f64) -> f64 {
    AIRY * wavelength * depth / hole
}

/// Diameter of the spot on the film, shadow and diffraction together: the root of the sum of their squares.
///
/// An estimate: neither spot is a normal distribution, for which squares would add exactly.
pub fn blur(hole: f64, depth: f64, distance: f64, wavelength: f64) -> f64 {
    shadow_blur(hole, depth, distance).hypot(diffraction_blur(hole, depth, wavelength))
}

/// The hole's diameter at which [`blur`] is least: where both spots are equal.
///
/// ```text
/// hole = √(2.44 λ depth / (1 + depth/distance))
/// ```
///
/// - Source: the minimum of `c²h² + k²/h²`; Rayleigh (1891) found `1.9 √(λ depth)` by another criterion.
pub fn sharpest_hole(depth: f64, distance: f64, wavelength: f64) -> f64 {
    (AIRY * wavelength * depth / (1.0 + depth / distance)).sqrt()
}

/// Solid angle \[sr\] per area of the image plane at distance 1, at a point of it.
///
/// ```text
/// dΩ/dA = cos³θ = (1 + x² + y²)^(−3/2)
/// ```
///
/// Pixels of equal area see the less, the farther from the axis.
///
/// - Domain: all numbers; 1 on the axis, 0 at infinity.
/// - Source: a plane element seen at `θ`: `cos θ / r²` with `r = 1/cos θ`. [A §6.3.3.3] prints `cos θ`.
pub fn solid_angle_density(screen: DVec2) -> f64 {
    let r2 = 1.0 + screen.length_squared();
    1.0 / (r2 * r2.sqrt())
}

/// Solid angle \[sr\] of the rectangle between two corners of the image plane at distance 1.
///
/// ```text
/// Ω = G(x₁,y₁) − G(x₀,y₁) − G(x₁,y₀) + G(x₀,y₀),    G(x,y) = atan(x y / √(1 + x² + y²))
/// ```
///
/// - Domain: finite, `min ≤ max` in both coordinates; a growing rectangle tends to `2π`.
/// - Accuracy: absolute error a few roundings of 1; small rectangles far from 0 lose digits to cancellation,
///   and [`solid_angle_density`] serves them.
pub fn rectangle_solid_angle(min: DVec2, max: DVec2) -> f64 {
    let g = |x: f64, y: f64| (x * (y / x.hypot(y).hypot(1.0))).atan();
    (g(max.x, max.y) - g(min.x, max.y)) - (g(max.x, min.y) - g(min.x, min.y))
}
