//! Tangents: where texture coordinates grow [D §5.6.2, by Lengyel's method].

use super::{NONE, Polygons};
use crate::frame::{basis, unit};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// A tangent of a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent {
    /// Unit vector along growing `u`, perpendicular to the corner's normal.
    pub direction: DVec3,
    /// The bitangent is this times `n × direction`: −1 where the texture is mirrored, else +1.
    pub handedness: f64,
}

/// Tangents that corners share.
#[derive(Clone, Debug, PartialEq)]
pub struct Tangents {
    pub values: Vec<Tangent>,
    /// As many as the polygons have corners.
    pub corners: Vec<u32>,
    /// Faces whose texture coordinates are missing or without area: their corners take others' tangents, or any.
    pub undetermined: usize,
}

impl Tangents {
    /// The tangents of triangles with these normals and texture coordinates.
    ///
    /// ```text
    /// e₁ = Δu₁ T + Δv₁ B,   e₂ = Δu₂ T + Δv₂ B   ⇒   T = (Δv₂ e₁ − Δv₁ e₂) / (Δu₁Δv₂ − Δu₂Δv₁)
    /// ```
    ///
    /// At a corner the `T` of its faces are summed, as far as they agree in handedness, and made perpendicular to the normal.
    ///
    /// - Domain: triangles. Only the direction of `T` counts here, so the division is left out but for its sign.
    /// - NaN: none; what has no direction takes [`basis`]'.
    /// - Source: Lengyel, *Mathematics for 3D Game Programming and Computer Graphics* (2012) §7.8.
    pub fn of(mesh: &Polygons) -> Self {
        let mut sums: HashMap<_, usize> = HashMap::new();
        let mut found: Vec<(DVec3, DVec3, f64)> = Vec::new();
        let mut corners = vec![NONE; mesh.corner_count()];
        let mut undetermined = 0;
        for face in 0..mesh.len() {
            let flat = unit(mesh.area_vector(face)).unwrap_or(DVec3::Z);
            let along = along_u(mesh, face);
            undetermined += usize::from(along.is_none());
            let (along, handedness) = along.unwrap_or((DVec3::ZERO, 1.0));
            // Corners without a normal belong to their face alone, and have one tangent.
            let mut of_face = None;
            for c in mesh.range(face) {
                let mut new = |sum, n| {
                    found.push((sum, n, handedness));
                    found.len() - 1
                };
                let place = if let Some(n) = mesh.normals.get(c) {
                    let key = (mesh.corner(c), handedness < 0.0);
                    let place = *sums.entry(key).or_insert_with(|| new(DVec3::ZERO, n));
                    found[place].0 += along;
                    place
                } else {
                    *of_face.get_or_insert_with(|| new(along, flat))
                };
                corners[c] = place as u32;
            }
        }
        let value = |(sum, n, handedness): (DVec3, DVec3, f64)| Tangent {
            direction: unit(sum - n * sum.dot(n)).unwrap_or_else(|| basis(n).0),
            handedness,
        };
        Tangents { values: found.into_iter().map(value).collect(), corners, undetermined }
    }
}

/// The direction along which `u` grows in a triangle, as a unit vector, and the handedness of its texture.
fn along_u(mesh: &Polygons, face: usize) -> Option<(DVec3, f64)> {
    let range = mesh.range(face);
    let [a, b, c] = [range.start, range.start + 1, range.start + 2].map(|c| mesh.uvs.get(c));
    let (d1, d2): (DVec2, DVec2) = (b? - a?, c? - a?);
    let area = d1.x * d2.y - d2.x * d1.y;
    let p: Vec<DVec3> = mesh.outline(face).collect();
    let direction = unit((p[1] - p[0]) * d2.y - (p[2] - p[0]) * d1.y)?;
    // Below the rounding of its two products the sign of the area is noise.
    let noise = 4.0 * crate::num::U * (d1.x * d2.y).abs().max((d2.x * d1.y).abs());
    (area.abs() > noise).then(|| (direction * 1f64.copysign(area), 1f64.copysign(area)))
}
