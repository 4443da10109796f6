//! The mesh as a surface: triangles in a hierarchy of boxes.

use super::{Attribute, Corner, MeshError, Polygons, Tangents, Topology};
use crate::accel::Facets;
use crate::bounds::Aabb;
use crate::num::certified::power_of_two_below;
use crate::ray::{Crossing, Hit, Ray, Silent};
use crate::shape::triangle::{Facing, Meeting, PreparedRay, Triangle, interpolated_normal, terminator_point};
use crate::shape::{Shape, ShapeError};
use glam::{DVec2, DVec3};

/// What was changed on the way from polygons to a mesh; no change moves a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// Points that were equal to another one, and are it now.
    pub welded: usize,
    /// Triangles without area, left out.
    pub flat: usize,
    /// Faces whose outline crosses itself.
    pub crossed: usize,
    /// Was a closed surface inside out? Then all its faces are turned round.
    pub inside_out: bool,
}

/// Triangles met without gaps [D §5.4.8, §5.9.1.4].
///
/// Triangles are kept in an order of their own, near ones together. Texture coordinates are those of the polygons, or, where
/// a corner has none, the barycentric `(b₁, b₂)` of each triangle.
#[derive(Debug)]
pub struct Mesh {
    /// What a ray is tested against, in the order in which a tree's leaves lie about.
    pub(super) corners: Vec<[DVec3; 3]>,
    pub(super) bvh: Facets,
    /// The triangles with everything else: face `i` is triangle `i`.
    pub(super) triangles: Polygons,
    /// Nothing without texture coordinates.
    tangents: Option<Tangents>,
    /// For each triangle the face of the polygons that it comes from.
    origin: Vec<u32>,
    pub(super) bounds: Aabb,
    topology: Topology,
    repairs: Repairs,
}

impl Mesh {
    /// A mesh of polygons of any number of corners, flat or not quite, convex or not.
    ///
    /// Points equal to the bit become one, so that faces that only look joined are joined.
    ///
    /// - Errors: a point that is not finite; no area at all; an outline that is too long (see [`triangulate`](super::triangulate)).
    pub fn new(polygons: &Polygons) -> Result<Self, MeshError> {
        for p in &polygons.points {
            ShapeError::finite("point of a mesh", *p)?;
        }
        let mut welded = polygons.welded();
        let topology = Topology::of(&welded);
        let inside_out = topology.is_closed() && scaled(&welded).volume() < 0.0;
        if inside_out {
            welded.turn_round();
        }
        let cut = welded.triangulated()?;
        let (triangles, origin, flat) = with_area(&cut.mesh, &cut.origin);
        if triangles.is_empty() {
            return Err(ShapeError::NoArea { what: "mesh" }.into());
        }
        let repairs = Repairs {
            welded: polygons.points.len() - welded.points.len(),
            flat,
            crossed: cut.crossed,
            inside_out,
        };
        let corners: Vec<[DVec3; 3]> = (0..triangles.len()).map(|f| corners(&triangles, f)).collect();
        let bounds = Aabb::of_points(corners.iter().flatten().copied());
        let bvh = Facets::build(corners.len(), |face| corners[face as usize]);
        let tangents = (!triangles.uvs.values.is_empty()).then(|| Tangents::of(&triangles));
        Ok(Mesh { corners, bvh, triangles, tangents, origin, bounds, topology, repairs })
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The corners of a triangle.
    pub fn triangle(&self, face: usize) -> [DVec3; 3] {
        self.corners[face]
    }

    /// The face of the polygons that a triangle comes from, counted without those that welding left fewer than three corners.
    pub fn polygon(&self, face: usize) -> usize {
        self.origin[face] as usize
    }

    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    pub fn repairs(&self) -> Repairs {
        self.repairs
    }

    /// The hierarchy over [`Mesh::triangle`]s.
    pub fn bvh(&self) -> &Facets {
        &self.bvh
    }

    /// The first crossing with `t_min < t < t_max` by testing every triangle; of equally near ones that of the lowest index.
    pub fn nearest_by_scan(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let prepared = PreparedRay::new(ray);
        let mut nearest: Option<Crossing> = None;
        for face in 0..self.len() as u32 {
            let limit = nearest.map_or(t_max, |c| c.t);
            nearest = self.meet(&prepared, face, t_min, limit).or(nearest);
        }
        nearest
    }

    #[inline]
    fn meet(&self, ray: &PreparedRay, face: u32, t_min: f64, t_max: f64) -> Option<Crossing> {
        let m = ray.meet(self.corners[face as usize])?;
        (t_min < m.t && m.t < t_max).then(|| self.crossing(m.t, face))
    }

    pub(super) fn crossing(&self, t: f64, face: u32) -> Crossing {
        Crossing { t, face, part: self.triangles.parts[face as usize] }
    }

    /// The three values of a triangle's corners, if all have one.
    fn values<T: Copy>(&self, attribute: &Attribute<T>, face: u32) -> Option<[T; 3]> {
        let start = 3 * face as usize;
        Some([attribute.get(start)?, attribute.get(start + 1)?, attribute.get(start + 2)?])
    }

    /// Normals of a triangle's corners, on the side of its front.
    fn normals(&self, face: u32, front: DVec3) -> Option<[DVec3; 3]> {
        let normals = self.values(&self.triangles.normals, face)?;
        // A file may wind its faces one way and point its normals the other: what is drawn is the winding's front.
        let sum = normals[0] + normals[1] + normals[2];
        Some(if sum.dot(front) < 0.0 { normals.map(|n| -n) } else { normals })
    }

    fn tangent(&self, face: u32, b: [f64; 3], ng: DVec3) -> Option<DVec3> {
        self.values(&self.triangles.uvs, face)?;
        let tangents = self.tangents.as_ref()?;
        let t = |k: usize| tangents.values[tangents.corners[3 * face as usize + k] as usize].direction * b[k];
        let along = t(0) + t(1) + t(2);
        crate::frame::unit(along - ng * along.dot(ng))
    }

    /// +1, or −1 where the texture of a triangle is mirrored; see [`Tangents`].
    pub fn handedness(&self, face: usize) -> f64 {
        self.tangents.as_ref().map_or(1.0, |t| t.values[t.corners[3 * face] as usize].handedness)
    }

    /// Weights of a triangle's corners at a point in its plane.
    fn weights(&self, face: u32, p: DVec3) -> [f64; 3] {
        let [v0, v1, v2] = self.corners[face as usize];
        let (e1, e2, from) = (v1 - v0, v2 - v0, p - v0);
        let n = e1.cross(e2);
        let [b1, b2] = [from.cross(e2).dot(n) / n.dot(n), e1.cross(from).dot(n) / n.dot(n)];
        match b1.is_finite() && b2.is_finite() {
            true => [1.0 - b1 - b2, b1, b2],
            false => [1.0 / 3.0; 3],
        }
    }
}

/// The corners of a face that is a triangle.
fn corners(mesh: &Polygons, face: usize) -> [DVec3; 3] {
    let range = mesh.range(face);
    [0, 1, 2].map(|k| mesh.points[mesh.corner(range.start + k).point as usize])
}

/// The polygons with lengths counted in a power of two, so that volumes neither vanish nor overflow.
fn scaled(mesh: &Polygons) -> Polygons {
    let size = mesh.points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let mut out = mesh.clone();
    let unit = power_of_two_below(size);
    out.points.iter_mut().for_each(|p| *p /= unit);
    out
}

/// The triangles that have area, near ones together, with their origins; and how many have none.
fn with_area(cut: &Polygons, origin: &[u32]) -> (Polygons, Vec<u32>, usize) {
    let bounds = Aabb::of_points(cut.points.iter().copied());
    let mut order: Vec<(u64, usize)> = (0..cut.len())
        .filter(|&f| {
            let [a, b, c] = corners(cut, f);
            Triangle::new(a, b, c).is_ok()
        })
        .map(|f| (along_curve(&bounds, corners(cut, f)), f))
        .collect();
    order.sort_unstable();
    let mut out = Polygons::of_points(cut.points.clone());
    (out.uvs.values, out.normals.values) = (cut.uvs.values.clone(), cut.normals.values.clone());
    for &(_, f) in &order {
        let start = cut.range(f).start;
        let face: [Corner; 3] = [start, start + 1, start + 2].map(|c| cut.corner(c));
        out.push(&face, cut.parts[f]);
    }
    let origin = order.iter().map(|&(_, f)| origin[f]).collect();
    (out, origin, cut.len() - order.len())
}

/// Place of a triangle's middle on Morton's curve through the bounds, 2²¹ steps along each axis.
fn along_curve(bounds: &Aabb, [a, b, c]: [DVec3; 3]) -> u64 {
    let size = bounds.max * 0.5 - bounds.min * 0.5;
    let middle = (a * 0.5 + b * 0.25 + c * 0.25) - bounds.min * 0.5 - bounds.min * 0.5;
    let step = |axis: usize| {
        let share = middle[axis] * 0.5 / size[axis];
        if share.is_finite() { (share * 2_097_151.0) as u64 } else { 0 }
    };
    // Bits in halves of halves, moved apart until two zeros stand between each and the next.
    const APART: [(u32, u64); 5] = [
        (32, 0x001f_0000_0000_ffff),
        (16, 0x001f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ];
    let spread = |x: u64| APART.iter().fold(x, |x, (by, mask)| (x | x << by) & mask);
    spread(step(0)) | spread(step(1)) << 1 | spread(step(2)) << 2
}

impl Shape for Mesh {
    #[inline]
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let mut prepared = None;
        let test = |face, limit| {
            self.meet(prepared.get_or_insert_with(|| PreparedRay::new(ray)), face, t_min, limit)
        };
        Some(self.bvh.nearest(ray, t_min, t_max, &mut Silent, test)?.1)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        super::line::crossings(self, ray, out);
    }

    /// The normal to shade by is interpolated where the corners have normals.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let [v0, v1, v2] = self.corners[crossing.face as usize];
        let triangle = Triangle::new(v0, v1, v2).expect("only triangles with area were kept");
        let third = Meeting { t: crossing.t, b: [1.0 / 3.0; 3], facing: Facing::Front };
        let m = PreparedRay::new(ray).meet([v0, v1, v2]).unwrap_or(third);
        let hit = triangle.describe(&m, crossing);
        let face = crossing.face;
        let n = self.normals(face, hit.ng).and_then(|n| interpolated_normal(m.b, n)).unwrap_or(hit.ng);
        let uv = self
            .values(&self.triangles.uvs, face)
            .map_or(hit.uv, |uv| uv[0] * m.b[0] + uv[1] * m.b[1] + uv[2] * m.b[2]);
        let tangent = self.tangent(face, m.b, hit.ng).unwrap_or(hit.tangent);
        Hit { n, uv, tangent, ..hit }
    }

    /// Where texture coordinates repeat, the one place that this triangle gives them.
    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let face = face.min(self.len() as u32 - 1);
        let [v0, v1, v2] = self.corners[face as usize];
        let (b1, b2) = match self.values(&self.triangles.uvs, face) {
            None => (uv.x, uv.y),
            Some([a, b, c]) => {
                let (d1, d2, d) = (b - a, c - a, uv - a);
                let area = d1.perp_dot(d2);
                if area == 0.0 {
                    (1.0 / 3.0, 1.0 / 3.0)
                } else {
                    (d.perp_dot(d2) / area, d1.perp_dot(d) / area)
                }
            }
        };
        v0 * (1.0 - b1 - b2) + v1 * b1 + v2 * b2
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        let mut prepared = None;
        let blocks = |face| {
            self.meet(prepared.get_or_insert_with(|| PreparedRay::new(ray)), face, 0.0, t_max).is_some()
        };
        self.bvh.any(ray, 0.0, t_max, &mut Silent, blocks).is_some()
    }

    fn parts(&self) -> u32 {
        self.triangles.parts.iter().max().map_or(1, |part| part + 1)
    }

    /// The hierarchy looks at its own bounds first.
    fn is_costly(&self) -> bool {
        false
    }

    /// Lifted to the surface that the corners' normals suggest: see [`terminator_point`].
    fn lifted(&self, hit: &Hit, n: DVec3) -> DVec3 {
        let Some(normals) = self.normals(hit.face, hit.ng).filter(|_| hit.n != hit.ng) else {
            return hit.point;
        };
        let seen = if n.dot(hit.ng) < 0.0 { normals.map(|n| -n) } else { normals };
        terminator_point(self.weights(hit.face, hit.point), self.corners[hit.face as usize], seen)
    }
}
