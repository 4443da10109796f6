//! What an area light of radiance 1 sends to a point: closed forms of the irradiance [W m⁻²].
//!
//! ```text
//! E = ∫ max(0, n·ω) dω   over the directions ω in which the light is seen                       (1)
//! ```
//!
//! The light shines alike in all directions and from both sides, and nothing stands in its way; a light of
//! radiance `L` sends `L E`. The whole hemisphere sends `π`. What lies below the receiver's horizon, the plane
//! through `p` across `n`, is cut off exactly.
//!
//! Differences of coordinates, products and sums of the geometry are done with 106 bits, so that neither an offset of
//! the whole scene nor a receiver that touches an edge costs digits; only roots and angles are plain `f64`.
//!
//! A receiver on the light itself has no one answer: it depends on the side. It is taken to stand on the side to which `n`
//! points: the answer is the limit of (1) from `p + ε n`, `ε → 0`.

mod polygon;
mod sphere;
mod touching;

pub use polygon::polygon_irradiance;
pub use sphere::sphere_irradiance;

use crate::num::certified::power_of_two_below;
use crate::num::double_double::DoubleDouble;
use crate::num::real::Triple;
use glam::DVec3;

/// `v − p` to 106 bits, in a unit of length in which neither over- nor underflows.
#[inline]
fn seen_from(v: DVec3, p: DVec3, unit: f64) -> Triple<DoubleDouble> {
    let (v, p) = (v / unit, p / unit);
    [
        DoubleDouble::difference(v.x, p.x),
        DoubleDouble::difference(v.y, p.y),
        DoubleDouble::difference(v.z, p.z),
    ]
}

/// `n·r`.
#[inline]
fn height(n: DVec3, r: Triple<DoubleDouble>) -> DoubleDouble {
    r[0].scale(n.x) + r[1].scale(n.y) + r[2].scale(n.z)
}

#[inline]
fn square(r: Triple<DoubleDouble>) -> DoubleDouble {
    r[0].square() + r[1].square() + r[2].square()
}

#[inline]
fn cross(a: Triple<DoubleDouble>, b: Triple<DoubleDouble>) -> Triple<DoubleDouble> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
fn rounded(r: Triple<DoubleDouble>) -> DVec3 {
    DVec3::new(r[0].value(), r[1].value(), r[2].value())
}

/// `|v|`, however small.
#[inline]
fn length(v: DVec3) -> f64 {
    let scale = power_of_two_below(v.abs().max_element());
    (v / scale).length() * scale
}
