//! A receiver in the plane of the polygon, perhaps on it.

use super::{cross, rounded, seen_from};
use crate::num::double_double::DoubleDouble;
use crate::num::real::{Triple, dot};
use glam::DVec3;
use std::f64::consts::PI;

/// The share of its terms that a sum of plain products may lose and no more: above it the sign is known.
const CLEAR: f64 = 1.0 / (1u64 << 40) as f64;
/// The same with 106 bits: a few dozen roundings of 2⁻¹⁰³.
const CLEAR_IN_DOUBLE_DOUBLE: f64 = CLEAR * CLEAR / 65536.0; // 2⁻⁹⁶

/// The irradiance of a receiver in the polygon's plane; `None` if it is not there.
///
/// Beside the polygon it is 0. On it, the limit from `p + ε n`: all that is left of the polygon is its cone of directions at `p`, all
/// directions in its interior, half of them on an edge, a wedge at a vertex. Let `α` be the angle in the plane, from its
/// horizon (`n·d = 0`) on; the cone's directions `α₁…α₂` above the horizon bound, with verticals, which count nothing, and
/// the horizon itself, what is seen. Lambert's formula has two terms left:
///
/// ```text
/// 2E = [atan2(c sin α, cos α) − c α] from α₁ to α₂,    c = |n·N|
/// ```
///
/// - Domain: unit `n`. No area: 0.
pub(super) fn in_its_plane(vertices: &[DVec3], p: DVec3, n: DVec3, unit: f64) -> Option<f64> {
    if clearly_outside(vertices, p, unit) {
        return None;
    }
    let from_p = |i: usize| seen_from(vertices[i % vertices.len()], p, unit);
    let nearest = (0..vertices.len()).min_by(|&i, &j| {
        let square = |i| rounded(from_p(i)).length_squared();
        square(i).total_cmp(&square(j))
    })?;
    let anchor = from_p(nearest);
    let edge = |i: usize| seen_from(vertices[i % vertices.len()], vertices[nearest], unit);
    let mut normal = [DoubleDouble::ZERO; 3];
    let mut terms = DVec3::ZERO;
    for i in 0..vertices.len() {
        let (a, b) = (edge(i), edge(i + 1));
        normal = std::array::from_fn(|k| normal[k] + cross(a, b)[k]);
        let (a, b) = (rounded(a).abs(), rounded(b).abs());
        terms += DVec3::new(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x);
    }
    let height = dot(normal, anchor).value();
    if height.abs() > CLEAR_IN_DOUBLE_DOUBLE * terms.dot(rounded(anchor).abs()) {
        return None;
    }
    let size = rounded(normal).abs().max_element();
    if size == 0.0 {
        return Some(0.0);
    }
    let up = (rounded(normal) / size).normalize();
    Some(Cone::at(|i| from_p(i), vertices.len(), normal, up, n).map_or(0.0, |cone| cone.irradiance()))
}

/// Is `p` off the plane by more than roundings can make of nothing?
fn clearly_outside(vertices: &[DVec3], p: DVec3, unit: f64) -> bool {
    let anchor = vertices[0] / unit;
    let to_p = p / unit - anchor;
    let (mut normal, mut terms) = (DVec3::ZERO, 0.0);
    for w in vertices[1..].windows(2) {
        let (a, b) = (w[0] / unit - anchor, w[1] / unit - anchor);
        normal += a.cross(b);
        terms += a.length() * b.length();
    }
    normal.dot(to_p).abs() > CLEAR * terms * to_p.length()
}

/// The directions `low ≤ α ≤ high` in which a polygon's plane is lit, as seen from a point of the polygon.
struct Cone {
    cosine: f64,
    low: f64,
    high: f64,
}

impl Cone {
    /// `None` beside the polygon, or if its plane is the horizon.
    fn at(
        corner: impl Fn(usize) -> Triple<DoubleDouble>,
        count: usize,
        normal: Triple<DoubleDouble>,
        up: DVec3,
        n: DVec3,
    ) -> Option<Cone> {
        let x = n.cross(up);
        let sine = x.length();
        let lies_flat = sine == 0.0;
        let x = if lies_flat { up.any_orthonormal_vector() } else { x / sine };
        let y = up.cross(x);
        let mut cone = Cone { cosine: n.dot(up).abs().min(1.0), low: 0.0, high: PI };
        for i in 0..count {
            let (a, b) = (corner(i), corner(i + 1));
            let side = dot(normal, cross(a, b)).value();
            let size = rounded(normal).length() * rounded(a).length() * rounded(b).length();
            if side.abs() > CLEAR_IN_DOUBLE_DOUBLE * size {
                if side < 0.0 {
                    return None;
                }
                continue;
            }
            // The edge passes through p; the inside is to its left.
            let along = rounded(std::array::from_fn(|k| b[k] - a[k]));
            if along == DVec3::ZERO {
                continue;
            }
            let alpha = along.dot(y).atan2(along.dot(x));
            if alpha >= 0.0 {
                cone.low = cone.low.max(alpha);
            } else {
                cone.high = cone.high.min(alpha + PI);
            }
        }
        (!lies_flat && cone.low < cone.high).then_some(cone)
    }

    fn irradiance(&self) -> f64 {
        let to = |alpha: f64| (self.cosine * alpha.sin()).atan2(alpha.cos()) - self.cosine * alpha;
        (0.5 * (to(self.high) - to(self.low))).max(0.0)
    }
}
