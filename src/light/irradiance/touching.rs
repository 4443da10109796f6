//! Where a receiver stands to the plane of the polygon: on a side, or in it and perhaps on the polygon.

use super::{cross, height, rounded, seen_from};
use crate::num::double_double::DoubleDouble;
use crate::num::real::{Triple, dot};
use glam::DVec3;
use std::f64::consts::PI;

/// The share of its terms that a sum of a few products may lose to rounding, and no more: above it the sign is known.
const CLEAR: f64 = 1.0 / (1u64 << 40) as f64;
/// The same with 106 bits: a few dozen roundings of 2⁻¹⁰³.
const CLEAR_IN_DOUBLE_DOUBLE: f64 = CLEAR * CLEAR / 65536.0; // 2⁻⁹⁶

/// Where `p` stands.
pub(super) enum Standing {
    /// Off the plane; the sign of `N·r`: 1 if the corners run to the left, seen from `p`.
    Beside(f64),
    /// In the plane, and what it receives there.
    Within(f64),
}

/// Where `p` stands to the plane of a polygon.
///
/// In the plane, beside the polygon, the irradiance is 0. On it, it is the limit from `p + ε n`: all that is left of the polygon
/// is its cone of directions `d` at `p`, all directions of the plane in its interior, half of them on an edge, a wedge at a
/// vertex. What is seen lies between the polygon's plane at infinity, the horizon, and verticals, which count nothing:
///
/// ```text
/// 2E = [φ − |n·N| α] from d₁ to d₂,     tan α = d·n / d·(n×N),    tan φ = |n·N| tan α
/// ```
///
/// with unit `n` and `N`; `d₁`, `d₂` are the ends of the cone that is left above the horizon; there `0 ≤ α, φ ≤ π`, angles in the polygon's
/// plane and between projections on the horizon. Where `n` lies in the plane, `|n·N|` is taken to 0 from above.
///
/// - Domain: finite, at least three corners, `n ≠ 0`. No area: nothing arrives.
pub(super) fn standing(vertices: &[DVec3], p: DVec3, n: DVec3, unit: f64) -> Standing {
    if let Some(side) = clear_side(vertices, p, unit) {
        return Standing::Beside(side);
    }
    let from_p = |i: usize| seen_from(vertices[i % vertices.len()], p, unit);
    let mut nearest = (0, f64::INFINITY);
    for i in 0..vertices.len() {
        let square = rounded(from_p(i)).length_squared();
        if square < nearest.1 {
            nearest = (i, square);
        }
    }
    let anchor = from_p(nearest.0);
    let edge = |i: usize| seen_from(vertices[i % vertices.len()], vertices[nearest.0], unit);
    let mut normal = [DoubleDouble::ZERO; 3];
    let mut terms = DVec3::ZERO;
    for i in 0..vertices.len() {
        let (a, b) = (edge(i), edge(i + 1));
        let c = cross(a, b);
        normal = std::array::from_fn(|k| normal[k] + c[k]);
        terms += cross_terms(rounded(a), rounded(b));
    }
    let above = dot(normal, anchor).value();
    if above.abs() > CLEAR_IN_DOUBLE_DOUBLE * terms.dot(rounded(anchor).abs()) {
        return Standing::Beside(above.signum());
    }
    let irradiance = Cone::at(from_p, vertices.len(), normal, n).map_or(0.0, |cone| cone.irradiance());
    Standing::Within(irradiance)
}

/// The sign of `N·r` where plain `f64` knows it.
fn clear_side(vertices: &[DVec3], p: DVec3, unit: f64) -> Option<f64> {
    let anchor = vertices[0] / unit;
    let r = anchor - p / unit;
    let (mut normal, mut terms) = (DVec3::ZERO, 0.0);
    for w in vertices[1..].windows(2) {
        let (a, b) = (w[0] / unit - anchor, w[1] / unit - anchor);
        normal += a.cross(b);
        terms += a.length() * b.length();
    }
    let above = normal.dot(r);
    (above.abs() > CLEAR * terms * r.length()).then(|| above.signum())
}

/// The sums of the moduli of what [`cross`] subtracts.
fn cross_terms(a: DVec3, b: DVec3) -> DVec3 {
    let (a, b) = (a.abs(), b.abs());
    DVec3::new(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x)
}

/// A direction in the polygon's plane, by its angles `α` and `φ`.
#[derive(Clone, Copy)]
struct Bearing {
    alpha: f64,
    phi: f64,
}

/// The directions above the horizon into which a polygon extends from one of its points.
struct Cone {
    /// `|n·N|`
    cosine: f64,
    low: Bearing,
    high: Bearing,
}

impl Cone {
    /// `None` beside the polygon, if nothing of it is above the horizon, or if its plane is the horizon.
    fn at(
        corner: impl Fn(usize) -> Triple<DoubleDouble>,
        count: usize,
        normal: Triple<DoubleDouble>,
        n: DVec3,
    ) -> Option<Cone> {
        let n_length = n.length();
        let exact_n = n.to_array().map(DoubleDouble::of);
        let area = rounded(normal).length();
        let horizon = cross(exact_n, normal);
        let lies_flat = rounded(horizon) == DVec3::ZERO;
        let over = height(n, normal).value().abs() / n_length; // |n·N| |N|
        let cosine = (over / area).min(1.0);
        let (low, high) = (Bearing { alpha: 0.0, phi: 0.0 }, Bearing { alpha: PI, phi: PI });
        let mut cone = Cone { cosine, low, high };
        for i in 0..count {
            let (a, b) = (corner(i), corner(i + 1));
            let side = dot(normal, cross(a, b)).value();
            let terms = rounded(normal).abs().dot(cross_terms(rounded(a), rounded(b)));
            if side.abs() > CLEAR_IN_DOUBLE_DOUBLE * terms {
                if side < 0.0 {
                    return None;
                }
                continue;
            }
            // The edge passes through p; the inside is to its left.
            let along: Triple<DoubleDouble> = std::array::from_fn(|k| b[k] - a[k]);
            let (up, across) = (height(n, along).value(), dot(along, horizon).value());
            if rounded(along) == DVec3::ZERO || lies_flat {
                continue;
            }
            // Below the horizon the other end of the edge's line is above it.
            let falls = up < 0.0;
            let (up, across) = if falls { (-up, -across) } else { (up, across) };
            let bearing = Bearing {
                alpha: (up * area).atan2(across),
                phi: (up * over.max(f64::MIN_POSITIVE)).atan2(across),
            };
            if falls && bearing.alpha < cone.high.alpha {
                cone.high = bearing;
            } else if !falls && bearing.alpha > cone.low.alpha {
                cone.low = bearing;
            }
        }
        (!lies_flat && area > 0.0 && cone.low.alpha < cone.high.alpha).then_some(cone)
    }

    fn irradiance(&self) -> f64 {
        let turn = self.high.alpha - self.low.alpha;
        (0.5 * (self.high.phi - self.low.phi - self.cosine * turn)).max(0.0)
    }
}
