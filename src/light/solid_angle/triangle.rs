//! What is seen of a triangle.

use super::half_difference;
use crate::num::certified::power_of_two_below;
use crate::sample::uniform_triangle;
use glam::{DVec2, DVec3};

/// A triangle as seen from a point: its solid angle, and its points uniform by solid angle.
///
/// With unit `vᵢ` towards the corners and `cᵢⱼ = vᵢ·vⱼ`, the great circle from `v₁` to a point `x` of the arc `v₀v₂` cuts off a
/// triangle `v₀ v₁ x`. It has the solid angle `S = u_x Ω` for
///
/// ```text
/// tan Ω/2 = G / D,    G = |det(v₀, v₁, v₂)|,   D = 1 + c₀₁ + c₁₂ + c₀₂                          (1)
/// x ∝ γ (γ + 2β) v₀ + 2β (γ + β (1 + c₀₂)) v₂,                                                   (2)
///     β = (1 + c₀₁) sin S/2,   γ = √(G² + D²) sin (Ω − S)/2
/// 1 − cos ∠(v₁, ω) = u_y (1 − cos ∠(v₁, x))                                                      (3)
/// ```
///
/// `ω`, on the arc from `v₁` to `x`, is the direction. Every weight is a sum of positive terms, so that `ω` is a positive
/// combination of the `vᵢ`; divided by the corners' distances, the weights are the point's barycentric coordinates.
///
/// - Accuracy: `Ω` relative, about `16 u |r|/h` with `h` the distance from the plane and `r` from the nearest corner, times the
///   aspect ratio for slivers. Barycentric coordinates ~16 u, absolute, however small the triangle.
/// - Source: (1) Van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983); (2) Peters, *BRDF importance sampling for
///   polygonal lights*, ACM TOG 40(4) (2021), with its differences replaced; (3) Arvo, *Stratified sampling of spherical
///   triangles*, SIGGRAPH (1995).
#[derive(Clone, Copy, Debug)]
pub struct SphericalTriangle {
    vertices: [DVec3; 3],
    solid_angle: f64,
    /// `vᵢ`
    towards: [DVec3; 3],
    /// `1 + c₀₁`, `1 + c₁₂`, `1 + c₀₂`
    sums: [f64; 3],
    /// `√(G² + D²)`
    modulus: f64,
    over_distance: [f64; 3],
}

impl SphericalTriangle {
    /// The triangle as seen from `p`.
    ///
    /// - Domain: finite. In the triangle's plane, also on the triangle, and without area: solid angle 0.
    pub fn new(vertices: [DVec3; 3], p: DVec3) -> Self {
        let r = vertices.map(|v| half_difference(v, p));
        let largest = r[0].abs().max(r[1].abs()).max(r[2].abs()).max_element();
        let scale = power_of_two_below(largest).recip(); // exact
        let r = r.map(|r| r * scale);
        let normal = (half_difference(vertices[1], vertices[0]) * scale)
            .cross(half_difference(vertices[2], vertices[0]) * scale);
        let distance = r.map(DVec3::length);
        let nearest = (0..3).fold(0, |n, i| if distance[i] < distance[n] { i } else { n });
        let over_distance = distance.map(f64::recip);
        let v: [DVec3; 3] = std::array::from_fn(|i| r[i] * over_distance[i]);
        let sums = [v[0] + v[1], v[1] + v[2], v[0] + v[2]].map(|s| 0.5 * s.length_squared());
        let g = normal.dot(r[nearest]).abs() * over_distance[0] * over_distance[1] * over_distance[2];
        let d = sums[0] + sums[1] + sums[2] - 2.0;
        let whole = 2.0 * g.atan2(d);
        // A corner at p makes NaN.
        let solid_angle = if g > 0.0 && whole.is_finite() { whole } else { 0.0 };
        SphericalTriangle {
            vertices,
            solid_angle,
            towards: v,
            sums,
            modulus: (g * g + d * d).sqrt(),
            over_distance,
        }
    }

    /// \[sr\], from 0 to 2π.
    pub fn solid_angle(&self) -> f64 {
        self.solid_angle
    }

    /// The point of the triangle for a point `u` of the square: uniform by solid angle; by area where there is none.
    #[inline]
    pub fn point(&self, u: DVec2) -> DVec3 {
        let b = if self.solid_angle > 0.0 { self.barycentric(u) } else { uniform_triangle(u) };
        self.vertices[0] * b.x + self.vertices[1] * b.y + self.vertices[2] * b.z
    }

    fn barycentric(&self, u: DVec2) -> DVec3 {
        let [s01, s12, s02] = self.sums;
        let beta = s01 * (0.5 * u.x * self.solid_angle).sin();
        let gamma = self.modulus * (0.5 * (1.0 - u.x) * self.solid_angle).sin();
        // Only their ratio counts; it may not underflow.
        let sum = beta + gamma;
        if !(sum > 0.0) {
            return uniform_triangle(u);
        }
        let (beta, gamma) = (beta / sum, gamma / sum);
        let x0 = gamma * (gamma + 2.0 * beta);
        let x2 = 2.0 * beta * (gamma + beta * s02);
        let square = gamma * gamma + 2.0 * beta * s02 * (gamma + beta);
        let (x0, x2) = (x0 / square, x2 / square);
        // 1 + v₁·x; where p is close to the triangle, the sum of the vectors knows what the cosine has lost.
        let mut s1x = 1.0 + x0 * (s01 - 1.0) + x2 * (s12 - 1.0);
        if s1x < 0.25 {
            let [v0, v1, v2] = self.towards;
            s1x = 0.5 * (v1 + v0 * x0 + v2 * x2).length_squared();
        }
        let s1x = s1x.clamp(f64::MIN_POSITIVE, 2.0);
        // On the arc from v₁ to x: t = sin ∠(v₁, ω)/sin ∠(v₁, x).
        let t = (u.y * (2.0 * (1.0 - u.y) + u.y * s1x) / s1x).sqrt();
        let middle = 1.0 - u.y * (2.0 - s1x) + t * (1.0 - s1x);
        let weight = DVec3::new(t * x0, middle.max(0.0), t * x2) * DVec3::from_array(self.over_distance);
        let sum = weight.element_sum();
        if sum > 0.0 && sum < f64::INFINITY { weight / sum } else { uniform_triangle(u) }
    }
}
