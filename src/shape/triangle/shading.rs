//! Smooth shading of flat triangles: interpolated normals, and where shadow rays start from.

use crate::shape::unit;
use glam::DVec3;

/// The normal `Σ bᵢnᵢ` between those of the corners, a unit vector [D §5.9.1.5].
///
/// - Domain: `None` if the sum vanishes (opposite normals).
pub fn interpolated_normal(b: [f64; 3], [n0, n1, n2]: [DVec3; 3]) -> Option<DVec3> {
    unit(n0 * b[0] + n1 * b[1] + n2 * b[2])
}

/// Where shadow rays leave a smooth-shaded triangle: the point lifted to the surface that the normals suggest.
///
/// A flat facet shadows itself where its interpolated normal still sees the light. Each corner's
/// tangent plane lies above the facet; the point is moved to its projections on the three planes,
/// weighted like the corners. Planes below the facet (concave places) leave it in place.
///
/// ```text
/// p' = p + Σ bᵢ max(0, (vᵢ − p)·nᵢ) nᵢ
/// ```
///
/// - Domain: unit normals on the side of the facet that is seen.
/// - Source: Hanika, *Hacking the shadow terminator*, Ray Tracing Gems II (2021) ch. 4.
pub fn terminator_point(b: [f64; 3], corners: [DVec3; 3], normals: [DVec3; 3]) -> DVec3 {
    let p = corners[0] * b[0] + corners[1] * b[1] + corners[2] * b[2];
    let lift = |i: usize| normals[i] * (b[i] * (corners[i] - p).dot(normals[i]).max(0.0));
    p + lift(0) + lift(1) + lift(2)
}
