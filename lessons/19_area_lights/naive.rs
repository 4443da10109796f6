//! Solid-angle maps as the literature prints them: right, but for what cancels when a light is small or far.

use glam::{DVec2, DVec3};
use lightbench::light::Emitter;
use std::f64::consts::{PI, TAU};

/// Solid angle [sr] of a light seen from `p`, and the unit direction for a point of the square.
pub fn naive_map(emitter: &Emitter, p: DVec3, u: DVec2) -> (f64, DVec3) {
    match emitter {
        Emitter::Rectangle(r) => {
            let (w, h) = (r.half_width() * 2.0, r.half_height() * 2.0);
            naive_urena(r.center() - (w + h) * 0.5 - p, w, h, u)
        }
        Emitter::Triangle(t) => naive_arvo(t.corners().map(|c| c - p), u),
        Emitter::Sphere(s) => naive_cone(s.center() - p, s.radius(), u),
    }
}

/// A triangle: the angles' sum less π, and directions by it (Arvo, *Stratified sampling of spherical triangles*, 1995).
fn naive_arvo(corners: [DVec3; 3], xi: DVec2) -> (f64, DVec3) {
    let [a, b, c] = corners.map(DVec3::normalize);
    let angle = |at: DVec3, p: DVec3, q: DVec3| {
        at.cross(p).normalize().dot(at.cross(q).normalize()).clamp(-1.0, 1.0).acos()
    };
    let (alpha, beta, gamma) = (angle(a, b, c), angle(b, c, a), angle(c, a, b));
    let area = alpha + beta + gamma - PI;
    let (s, t) = (xi.x * area - alpha).sin_cos();
    let (u, v) = (t - alpha.cos(), s + alpha.sin() * a.dot(b));
    let q = ((v * t - u * s) * alpha.cos() - v) / ((v * s + u * t) * alpha.sin());
    let across = |x: DVec3, y: DVec3| (x - y * x.dot(y)).normalize();
    let cut = a * q + across(c, a) * (1.0 - q * q).max(0.0).sqrt();
    let z = 1.0 - xi.y * (1.0 - cut.dot(b));
    (area, b * z + across(cut, b) * (1.0 - z * z).max(0.0).sqrt())
}

/// A rectangle: four angles less 2π (Ureña, Fajardo & King, *An area-preserving parametrization for spherical rectangles*, 2013).
fn naive_urena(corner: DVec3, width: DVec3, height: DVec3, u: DVec2) -> (f64, DVec3) {
    let (x, y) = (width.normalize(), height.normalize());
    let z = x.cross(y);
    let z = if corner.dot(z) > 0.0 { -z } else { z };
    let (x0, y0, z0) = (corner.dot(x), corner.dot(y), corner.dot(z));
    let (x1, y1) = (x0 + width.length(), y0 + height.length());
    let v = |x: f64, y: f64| DVec3::new(x, y, z0);
    let n = |a: DVec3, b: DVec3| a.cross(b).normalize();
    let sides =
        [n(v(x0, y0), v(x1, y0)), n(v(x1, y0), v(x1, y1)), n(v(x1, y1), v(x0, y1)), n(v(x0, y1), v(x0, y0))];
    let g: [f64; 4] = std::array::from_fn(|k| (-sides[k].dot(sides[(k + 1) % 4])).clamp(-1.0, 1.0).acos());
    let (b0, b1, k) = (sides[0].z, sides[2].z, TAU - g[2] - g[3]);
    let area = g[0] + g[1] - k;
    let (sin, cos) = (u.x * area + k).sin_cos();
    let f = (cos * b0 - b1) / sin;
    let cu = (1.0f64.copysign(f) / (f * f + b0 * b0).sqrt()).clamp(-1.0, 1.0);
    let xu = (-(cu * z0) / (1.0 - cu * cu).sqrt()).clamp(x0, x1);
    let d2 = xu * xu + z0 * z0;
    let (h0, h1) = (y0 / (d2 + y0 * y0).sqrt(), y1 / (d2 + y1 * y1).sqrt());
    let h = h0 + u.y * (h1 - h0);
    let yv = if h * h < 1.0 - 1.0e-6 { h * d2.sqrt() / (1.0 - h * h).sqrt() } else { y1 };
    (area, (x * xu + y * yv + z * z0).normalize())
}

/// A sphere: one less a cosine (the common form of a uniform cone).
fn naive_cone(center: DVec3, radius: f64, u: DVec2) -> (f64, DVec3) {
    let axis = center.normalize();
    let sin2 = radius * radius / center.length_squared();
    let cos_most = (1.0 - sin2).sqrt();
    let cos = 1.0 - u.x * (1.0 - cos_most);
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    let (x, y) = axis.any_orthonormal_pair();
    let phi = TAU * u.y;
    (TAU * (1.0 - cos_most), axis * cos + (x * phi.cos() + y * phi.sin()) * sin)
}
