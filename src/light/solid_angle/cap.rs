//! What is seen of a sphere.

use super::half_difference;
use crate::frame::basis;
use crate::num::certified::power_of_two_below;
use crate::sample::uniform_sphere;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A sphere as seen from a point: its solid angle, and its points uniform by solid angle.
///
/// From outside, the directions fill a cone of half angle `σ`; let `s = sin σ = R/D` and `k = cos σ`. The direction for `u` makes an angle
/// `θ` with the axis, and the point where it meets the sphere is `α` from the nearest one, seen from the centre:
///
/// ```text
/// Ω = 2π v,   v = 1 − k = s²/(1 + k)
/// 1 − cos θ = u_x v,        sin θ = s q,
/// q² = u_x (2 − u_x v)/(1 + k),   1 − q² = (1 − u_x)(1 + k − u_x v)/(1 + k)
/// α = asin q − θ                                                              (law of sines)
/// ```
///
/// Nothing cancels: a sphere 10⁻¹⁵⁰ rad wide has a point for each `u`, and the rim is met, not missed.
///
/// - Accuracy: `Ω` relative, 8 u but for the cosine next to the surface: `u D/(D − R)`. Points lie on the sphere to 8 u of the
///   radius, and half an ulp of their coordinates.
/// - Source: Shirley, Wang & Zimmerman, *Monte Carlo techniques for direct lighting calculations*, ACM TOG 15(1) (1996).
#[derive(Clone, Copy, Debug)]
pub struct SphericalCap {
    center: DVec3,
    radius: f64,
    /// From the sphere's centre towards the viewer, and across.
    axes: [DVec3; 3],
    /// Of half the angle covered, seen from outside.
    cone: Option<Cone>,
    /// Of a viewer inside: the way to the centre, in radii.
    inside: DVec3,
    solid_angle: f64,
}

#[derive(Clone, Copy, Debug)]
struct Cone {
    sin: f64,
    cos: f64,
    versine: f64,
}

impl SphericalCap {
    /// The sphere as seen from `p`.
    ///
    /// - Domain: finite, `radius ≥ 0`. On the sphere `2π`, from outside; inside `4π`, uniform in all directions. Radius 0: solid angle
    ///   0, and the centre.
    pub fn new(center: DVec3, radius: f64, p: DVec3) -> Self {
        let to_center = half_difference(center, p);
        let half_radius = 0.5 * radius.max(0.0);
        let scale = power_of_two_below(to_center.abs().max_element().max(half_radius)).recip(); // exact
        let (d, r) = (to_center * scale, half_radius * scale);
        let distance = d.length();
        let mut cap = SphericalCap {
            center,
            radius: radius.max(0.0),
            axes: [DVec3::Z, DVec3::X, DVec3::Y],
            cone: None,
            inside: DVec3::ZERO,
            solid_angle: 0.0,
        };
        if !(r > 0.0) {
            return cap;
        }
        if distance < r {
            cap.inside = d / r;
            cap.solid_angle = 2.0 * TAU;
            return cap;
        }
        let axis = d * -distance.recip();
        let (x, y) = basis(axis);
        cap.axes = [axis, x, y];
        let sin = r / distance;
        let cos = (((distance - r) / distance) * (1.0 + sin)).sqrt();
        let versine = sin * sin / (1.0 + cos);
        cap.cone = Some(Cone { sin, cos, versine });
        cap.solid_angle = TAU * versine;
        cap
    }

    /// \[sr\], from 0 to 2π; 4π from inside.
    pub fn solid_angle(&self) -> f64 {
        self.solid_angle
    }

    /// The point of the sphere for a point `u` of the square: uniform by solid angle. `u_x` runs from the centre of what is seen
    /// to its rim.
    #[inline]
    pub fn point(&self, u: DVec2) -> DVec3 {
        let Some(Cone { sin, cos, versine }) = self.cone else {
            return self.center + self.exit_along(uniform_sphere(u)) * self.radius;
        };
        let (h, wide) = (u.x * versine, 1.0 + cos);
        let q = (u.x * (2.0 - h) / wide).sqrt();
        let p = ((1.0 - u.x) * (wide - h) / wide).sqrt();
        let (sin_theta, cos_theta) = (sin * q, 1.0 - h);
        let cos_alpha = p * cos_theta + q * sin_theta;
        let sin_alpha = q * cos_theta - p * sin_theta;
        let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
        let [axis, x, y] = self.axes;
        let outward = axis * cos_alpha + (x * cos_phi + y * sin_phi) * sin_alpha;
        self.center + outward * self.radius
    }

    /// The unit vector from the centre to where `w`, from a viewer inside, meets the sphere.
    fn exit_along(&self, w: DVec3) -> DVec3 {
        if self.radius == 0.0 {
            return DVec3::ZERO;
        }
        let along = w.dot(self.inside);
        let aside = self.inside - w * along;
        // The line's closest approach lies at −aside from the centre.
        let half_chord = (1.0 - aside.length_squared()).max(0.0).sqrt();
        (w * half_chord - aside).normalize()
    }
}
