//! Points of a light, chosen uniformly by what is seen of it.
//!
//! A map takes the unit square to points of a light so that the directions in which a receiver at `p` sees them have density
//! `1/Ω` [sr⁻¹], `Ω` the solid angle of the light. Compared with a point uniform by area, the factor `cos θₗ/r²` leaves
//! the integrand: near lamps no longer make rare bright samples.
//!
//! The constructions are those of the literature, written so that nothing cancels: solid angles come from the
//! determinant of edges, never from a sum of angles minus π, and a point is found by its place *on the light*, relative to a
//! corner, never by shooting a direction at it. So a light of 10⁻¹²⁰ sr has the same relative accuracy as one of 1 sr, and
//! no switch to a map by area is needed. That one is taken only where `Ω` is 0.
//!
//! All maps are total: any `u` in [0,1]² gives a finite point of a finite light, whatever `p` is.

mod cap;
mod rectangle;
mod triangle;

pub use cap::SphericalCap;
pub use rectangle::SphericalRectangle;
pub use triangle::SphericalTriangle;

use glam::DVec3;

/// `(a − b)/2`; the difference itself might overflow.
#[inline]
fn half_difference(a: DVec3, b: DVec3) -> DVec3 {
    a * 0.5 - b * 0.5
}
