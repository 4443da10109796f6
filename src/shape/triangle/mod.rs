//! The triangle: flat, three corners [A §5.4.1, D §5.9.1.5].
//!
//! Three ways to meet a ray with it: [`watertight`] (the default), [`moller_trumbore()`], [`plane_and_areas()`].
//! All answer with barycentric coordinates, `p = b₀v₀ + b₁v₁ + b₂v₂`, `b₀ + b₁ + b₂ = 1`.

mod icosphere;
mod outline;
mod shading;
mod textbook;
pub mod watertight;

pub use icosphere::icosphere;
pub(crate) use outline::ShearedRay;
pub use shading::{interpolated_normal, terminator_point};
pub(crate) use textbook::largest_axis;
pub use textbook::{as_printed, moller_trumbore, plane_and_areas};
pub use watertight::PreparedRay;

use super::{Shape, ShapeError, Sides, perpendicular_part, unit};
use crate::bounds::Aabb;
use crate::num::certified::{Bounded, Vector, power_of_two_below};
use crate::num::expansion::Expansion;
use crate::num::gamma;
use crate::ray::{Crossing, Hit, Ray};
use glam::{DVec2, DVec3};

/// Where a line meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Ray parameter [lengths of the direction].
    pub t: f64,
    /// Barycentric coordinates of the three corners; they sum to 1.
    pub b: [f64; 3],
    pub facing: Facing,
}

/// Which side of a flat surface a ray sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Facing {
    /// The ray runs against the normal `(v₁ − v₀) × (v₂ − v₀)`: corners appear counter-clockwise.
    Front,
    Back,
}

impl Sides {
    pub(crate) fn admit_facing(self, facing: Facing) -> bool {
        self == Sides::Both || facing == Facing::Front
    }
}

/// A triangle, its edges and corners included.
///
/// Texture coordinates are the barycentric coordinates `(b₁, b₂)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    corners: [DVec3; 3],
    normal: DVec3,
    sides: Sides,
}

impl Triangle {
    /// The triangle with these corners; its front shows them counter-clockwise.
    pub fn new(v0: DVec3, v1: DVec3, v2: DVec3) -> Result<Self, ShapeError> {
        let corners = [v0, v1, v2];
        for v in corners {
            ShapeError::finite("corner of a triangle", v)?;
        }
        let normal = exact_normal(corners).ok_or(ShapeError::NoArea { what: "triangle" })?;
        Ok(Triangle { corners, normal, sides: Sides::Both })
    }

    pub fn with_sides(self, sides: Sides) -> Self {
        Triangle { sides, ..self }
    }

    pub fn corners(&self) -> [DVec3; 3] {
        self.corners
    }

    /// The geometric normal, a unit vector.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Where the ray meets the triangle, at any sign of `t`. Many triangles share one `ray`.
    #[inline]
    pub fn meet(&self, ray: &PreparedRay) -> Option<Meeting> {
        ray.meet(self.corners).filter(|m| self.sides.admit_facing(m.facing))
    }

    /// The hit that [`Triangle::meet`] found.
    ///
    /// The point is `Σ bᵢvᵢ`, inside the triangle whatever the distance the ray came from. The `bᵢ` sum to
    /// `1 ± γ₄`, and three products and two sums are rounded: `γ₈ Σ|bᵢvᵢ|`.
    pub fn describe(&self, m: &Meeting, crossing: &Crossing) -> Hit {
        let [v0, v1, v2] = self.corners;
        let [p0, p1, p2] = [v0 * m.b[0], v1 * m.b[1], v2 * m.b[2]];
        Hit {
            t: crossing.t,
            point: p0 + p1 + p2,
            point_error: gamma(8) * (p0.abs() + p1.abs() + p2.abs()).length(),
            ng: self.normal,
            n: self.normal,
            tangent: perpendicular_part(v1 / 2.0 - v0 / 2.0, self.normal),
            uv: DVec2::new(m.b[1], m.b[2]),
            face: crossing.face,
            part: crossing.part,
        }
    }
}

/// The unit vector along `(v₁ − v₀) × (v₂ − v₀)`, however thin the triangle; `None` for one without area.
///
/// In `f64` if its error is small beside its length (else each coordinate is settled exactly).
fn exact_normal(corners: [DVec3; 3]) -> Option<DVec3> {
    let largest = corners.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    let [v0, v1, v2] = corners.map(|v| v / power_of_two_below(largest));
    let [e1, e2] = [v1, v2].map(|v| Vector::<Bounded>::difference(v, v0));
    let normal = e1.cross(e2);
    let length = normal.value().abs().max_element();
    if normal.0.iter().all(|x| x.error() <= 2f64.powi(-40) * length) {
        return unit(normal.value());
    }
    let size = (v1 - v0).abs().max((v2 - v0).abs()).max_element();
    let scaled = [v0, v1, v2].map(|v| v / power_of_two_below(size));
    let edge = |i: usize, axis: usize| Expansion::difference(scaled[i][axis], scaled[0][axis]);
    let minor = |a: usize, b: usize| {
        Expansion::determinant(&edge(1, a), &edge(2, b), &edge(1, b), &edge(2, a)).value()
    };
    unit(DVec3::new(minor(1, 2), minor(2, 0), minor(0, 1)))
}

impl Shape for Triangle {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let m = self.meet(&PreparedRay::new(ray))?;
        (t_min < m.t && m.t < t_max).then(|| Crossing::new(m.t, 0))
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, 0.0, f64::INFINITY));
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let third = 1.0 / 3.0;
        let lost = Meeting { t: crossing.t, b: [third; 3], facing: Facing::Front };
        let m = PreparedRay::new(ray).meet(self.corners).unwrap_or(lost);
        self.describe(&m, crossing)
    }

    fn point_at(&self, _face: u32, uv: DVec2) -> DVec3 {
        let [v0, v1, v2] = self.corners;
        v0 * (1.0 - uv.x - uv.y) + v1 * uv.x + v2 * uv.y
    }

    fn bounds(&self) -> Aabb {
        Aabb::of_points(self.corners)
    }
}
