//! All meetings of a line with a mesh, each counted once.
//!
//! A line through an edge meets the triangles on both sides, one through a corner those all around. Which of them share
//! a meeting is known exactly: the line has exact sides (see [`PreparedRay`]), so the edge or corner that it
//! passes through has a name. Which way it crosses there is the sum of half-open windings, in which each edge
//! belongs to one side: over a closed mesh they cancel, whatever the line hits.

use super::Mesh;
use crate::num::certified::power_of_two_below;
use crate::ray::{Crossing, Ray, Silent, Span};
use crate::shape::triangle::{Facing, PreparedRay, ShearedRay};
use glam::DVec3;

/// A meeting of the line with the surface.
#[derive(Clone, Copy, Debug)]
struct Met {
    t: f64,
    face: u32,
    /// The ends of the edge that the line passes through, or twice the corner; nothing inside a triangle.
    at: Option<[u32; 2]>,
    /// How many more faces are entered than left.
    entered: i32,
}

/// Weights below this make a look at exact sides worth while; they err by 10⁻¹³ at most, wherever the test was sure.
const NEAR_EDGE: f64 = 1e-6;

/// One line among the triangles.
struct Line<'a> {
    mesh: &'a Mesh,
    prepared: PreparedRay,
    /// Lengths times this are about 1, so that exact products neither vanish nor overflow: a power of two.
    scale: f64,
    /// The ray in that measure, for sides and windings.
    exact: PreparedRay,
    sheared: ShearedRay,
    met: Vec<Met>,
}

impl<'a> Line<'a> {
    fn new(mesh: &'a Mesh, ray: &Ray) -> Self {
        let b = mesh.bounds;
        let size = b.min.abs().max(b.max.abs()).max(ray.origin.abs()).max_element();
        let scale = 1.0 / power_of_two_below(size);
        let along = power_of_two_below(ray.direction.abs().max_element());
        let exact = Ray::new(ray.origin * scale, ray.direction / along);
        Line {
            mesh,
            prepared: PreparedRay::new(ray),
            scale,
            exact: PreparedRay::new(&exact),
            sheared: ShearedRay::new(&exact),
            met: Vec::new(),
        }
    }

    fn meet(&mut self, face: u32) {
        let corners = self.mesh.corners[face as usize];
        let Some(m) = self.prepared.meet(corners).filter(|m| m.t.is_finite()) else { return };
        let through = if m.facing == Facing::Front { 1 } else { -1 };
        let mut met = Met { t: m.t, face, at: None, entered: through };
        if m.b.iter().any(|b| *b < NEAR_EDGE) {
            let [a, b, c] = corners.map(|v| v * self.scale);
            let side = |a, b| self.exact.exact_side(a, b) == 0;
            let point = |k: usize| self.mesh.triangles.corner(3 * face as usize + k % 3).point;
            // Side i lies opposite corner i.
            met.at = match [side(b, c), side(c, a), side(a, b)] {
                [true, true, _] => Some([point(2); 2]),
                [true, _, true] => Some([point(1); 2]),
                [_, true, true] => Some([point(0); 2]),
                [false, false, false] => None,
                on => (0..3).find(|&i| on[i]).map(|i| [point(i + 1), point(i + 2)]),
            };
            met.at = met.at.map(|[a, b]| [a.min(b), a.max(b)]);
            if met.at.is_some() {
                // What the ray enters shows its front, counter-clockwise to one who looks along the ray, in coordinates
                // whose third runs along the ray: there it turns the other way.
                let step = |a, b| self.sheared.winding_step(b, a);
                met.entered = step(a, b) + step(b, c) + step(c, a);
            }
        }
        self.met.push(met);
    }

    /// Makes one of the meetings at each edge and corner, the nearest of them standing for all; then sorts by `t`.
    fn merged(mut self) -> Vec<Met> {
        self.met.sort_unstable_by(|a, b| {
            (a.at, a.t, a.face).partial_cmp(&(b.at, b.t, b.face)).unwrap_or(std::cmp::Ordering::Equal)
        });
        self.met.dedup_by(|next, kept| {
            let is_same = next.at.is_some() && next.at == kept.at;
            if is_same {
                kept.entered += next.entered;
            }
            is_same
        });
        // Where surfaces touch, the solid goes on: enter before leaving.
        self.met.sort_unstable_by(|a, b| {
            a.t.total_cmp(&b.t).then(b.entered.cmp(&a.entered)).then(a.face.cmp(&b.face))
        });
        self.met
    }
}

/// Appends the crossings with `t > 0`, ascending.
pub fn crossings(mesh: &Mesh, ray: &Ray, out: &mut Vec<Crossing>) {
    let mut line = Line::new(mesh, ray);
    mesh.bvh.each(ray, 0.0, f64::INFINITY, &mut Silent, |face| line.meet(face));
    line.met.retain(|m| m.t > 0.0);
    let mut found: Vec<Crossing> = line.merged().iter().map(|m| mesh.crossing(m.t, m.face)).collect();
    found.sort_unstable_by(|a, b| a.t.total_cmp(&b.t).then(a.face.cmp(&b.face)));
    out.append(&mut found);
}

/// Appends the stretches of the whole line that lie inside a closed mesh.
///
/// Inside is where more faces were entered than left. Of two faces so close that rounding swaps them, what lies between is lost.
pub fn spans(mesh: &Mesh, ray: &Ray, out: &mut Vec<Span>) {
    let mut line = Line::new(mesh, ray);
    let mut faces = Vec::new();
    mesh.bvh.each(ray, 0.0, f64::INFINITY, &mut Silent, |face| faces.push(face));
    let back = Ray::new(ray.origin, -ray.direction);
    mesh.bvh.each(&back, 0.0, f64::INFINITY, &mut Silent, |face| faces.push(face));
    faces.sort_unstable();
    faces.dedup();
    faces.into_iter().for_each(|face| line.meet(face));
    let start = out.len();
    let mut depth = 0;
    let mut enter: Option<Crossing> = None;
    for m in line.merged() {
        let before = depth;
        depth += m.entered;
        if before <= 0 && depth > 0 {
            enter = Some(mesh.crossing(m.t, m.face));
        } else if before > 0 && depth <= 0 {
            let leave = mesh.crossing(m.t, m.face);
            let Some(enter) = enter.take().filter(|e| e.t < leave.t) else { continue };
            match out[start..].last_mut() {
                // The same place, left and entered at once.
                Some(last) if last.leave.t >= enter.t => last.leave = leave,
                _ => out.push(Span { enter, leave }),
            }
        }
    }
}

/// Is the point inside a closed mesh, or on it?
///
/// Ahead of a point inside, the surface is left once more than it is entered.
pub fn contains(mesh: &Mesh, p: DVec3) -> bool {
    let ray = Ray::new(p, ASKEW);
    let mut line = Line::new(mesh, &ray);
    mesh.bvh.each(&ray, 0.0, f64::INFINITY, &mut Silent, |face| line.meet(face));
    if line.met.iter().any(|m| m.t == 0.0) {
        return true;
    }
    line.met.iter().filter(|m| m.t > 0.0).map(|m| m.entered).sum::<i32>() < 0
}

/// A direction along no axis, diagonal or other plane that meshes are likely to have faces in.
const ASKEW: DVec3 = DVec3::new(0.537_912_340_1, 0.318_764_901_3, 0.780_423_117_9);
