//! The quick ways to meet a ray with a triangle, each rounded as it comes.

use super::{Facing, Meeting};
use crate::ray::Ray;
use crate::shape::Sides;
use glam::DVec3;

/// Solves `o + t d = v₀ + b₁ e₁ + b₂ e₂` by Cramer's rule, sharing cross products.
///
/// ```text
/// s = d × e₂,  q = (o − v₀) × e₁,  D = e₁·s:    b₁ = (o − v₀)·s / D,  b₂ = d·q / D,  t = e₂·q / D
/// ```
///
/// - Domain: any sign of `t`. `D = 0` (parallel, or no area) is a miss.
/// - Accuracy: none promised at edges, which two triangles round differently.
/// - Source: Möller & Trumbore, *Fast, minimum storage ray/triangle intersection*, JGT 2(1) (1997).
pub fn moller_trumbore(ray: &Ray, [v0, v1, v2]: [DVec3; 3]) -> Option<Meeting> {
    let (e1, e2) = (v1 - v0, v2 - v0);
    let s = ray.direction.cross(e2);
    let det = e1.dot(s);
    let inverse = 1.0 / det;
    let from = ray.origin - v0;
    let b1 = from.dot(s) * inverse;
    if det == 0.0 || !(0.0..=1.0).contains(&b1) {
        return None;
    }
    let q = from.cross(e1);
    let b2 = ray.direction.dot(q) * inverse;
    let t = e2.dot(q) * inverse;
    if b2 >= 0.0 && b1 + b2 <= 1.0 && t.is_finite() { Some(meeting(t, b1, b2, det)) } else { None }
}

/// The same with the tolerances of 10⁻⁶ that A prints, whatever the size of the scene.
///
/// A triangle seen face on with edges of 10⁻³ has `D = 8.7·10⁻⁷`, and vanishes.
///
/// - Source: [A ill. 56], its `<` signs restored; `testcull` is [`Sides::Front`].
pub fn as_printed(ray: &Ray, [v0, v1, v2]: [DVec3; 3], sides: Sides) -> Option<Meeting> {
    const PRINTED: f64 = 1e-6;
    let (e1, e2) = (v1 - v0, v2 - v0);
    let s = ray.direction.cross(e2);
    let det = e1.dot(s);
    let too_small = match sides {
        Sides::Front => det < PRINTED,
        Sides::Both => det.abs() < PRINTED,
    };
    if too_small {
        return None;
    }
    let from = ray.origin - v0;
    let b1 = from.dot(s) / det;
    let q = from.cross(e1);
    let b2 = ray.direction.dot(q) / det;
    let t = e2.dot(q) / det;
    let wide = -PRINTED..=1.0 + PRINTED;
    let outside = !wide.contains(&b1) || b2 < -PRINTED || b1 + b2 > 1.0 + PRINTED;
    (!outside && t >= PRINTED).then(|| meeting(t, b1, b2, det))
}

/// `e₁ · (d × e₂) = −d · (e₁ × e₂)` is positive for a ray that runs against the normal.
fn meeting(t: f64, b1: f64, b2: f64, det: f64) -> Meeting {
    let facing = if det > 0.0 { Facing::Front } else { Facing::Back };
    Meeting { t, b: [1.0 - b1 - b2, b1, b2], facing }
}

/// First the plane, then the areas of the three triangles that the point makes with the edges, in the
/// coordinate plane where the triangle is largest.
///
/// - Domain: any sign of `t`. A plane parallel to the ray, or no area, is a miss.
/// - Source: [D §5.9.1.5]; Badouel, *An efficient ray-polygon intersection*, Graphics Gems (1990) p. 390.
pub fn plane_and_areas(ray: &Ray, [v0, v1, v2]: [DVec3; 3]) -> Option<Meeting> {
    let normal = (v1 - v0).cross(v2 - v0);
    let facing = normal.dot(ray.direction);
    let t = normal.dot(v0 - ray.origin) / facing;
    if facing == 0.0 || !t.is_finite() {
        return None;
    }
    let p = ray.at(t);
    let axis = largest_axis(normal);
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let area = |a: DVec3, b: DVec3| (a[i] - p[i]) * (b[j] - p[j]) - (b[i] - p[i]) * (a[j] - p[j]);
    let b = [area(v1, v2), area(v2, v0), area(v0, v1)].map(|a| a / normal[axis]);
    let facing = if facing < 0.0 { Facing::Front } else { Facing::Back };
    b.iter().all(|&b| b >= 0.0).then_some(Meeting { t, b, facing })
}

/// The axis along which `v` is longest.
pub(crate) fn largest_axis(v: DVec3) -> usize {
    let v = v.abs();
    if v.x >= v.y && v.x >= v.z {
        0
    } else if v.y >= v.z {
        1
    } else {
        2
    }
}
