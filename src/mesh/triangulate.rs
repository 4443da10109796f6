//! From polygons to triangles.
//!
//! The outline is looked at along the axis its normal is nearest to, so that corners keep their coordinates to the bit
//! and every turn has an exact sign. Convex outlines are halved again and again; others lose one ear after the other
//! (Meisters 1975).

use super::Polygons;
use crate::num::U;
use crate::num::expansion::Expansion;
use crate::shape::ShapeError;
use crate::shape::triangle::largest_axis;
use glam::{DVec2, DVec3};
use std::collections::VecDeque;

/// Most corners of an outline that is not convex: finding ears takes their number squared.
pub const MOST_CONCAVE: usize = 4096;

/// What a face's outline turned out to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outline {
    /// It encloses an area, and the triangles fill it.
    Simple,
    /// It crosses or touches itself, or has no area: the triangles fill what an outline that does so can fill.
    Crossed,
    /// It is not convex and has more than [`MOST_CONCAVE`] corners; no triangles were made.
    TooLong,
}

/// Appends the triangles of a polygon, `n − 2` of them, as places in its outline, all turning as the outline does.
///
/// - Domain: corners on one straight line give triangles without area; fewer than three corners give none.
/// - Accuracy: flat outlines are filled exactly. Of others the projection along the axis nearest to the normal is.
/// - Source: Meisters, *Polygons have ears* (1975); O'Rourke, *Computational Geometry in C* (1998) §1.4.
pub fn triangulate(outline: &[DVec3], out: &mut Vec<[u32; 3]>) -> Outline {
    let n = outline.len();
    if n <= 3 {
        out.extend((n == 3).then_some([0, 1, 2]));
        return Outline::Simple;
    }
    let flat = projected(outline);
    if is_strictly_convex(&flat) {
        halve(0, n as u32 - 1, out);
        return Outline::Simple;
    }
    if n > MOST_CONCAVE {
        return Outline::TooLong;
    }
    Ears::new(&flat).clip(out)
}

/// The triangles of a convex outline between two of its corners: one with the corner half way, and those of both sides.
///
/// No line meets more than `2 log₂ n` of them. A fan from one corner is made of needles, all of which lie along each other.
fn halve(from: u32, to: u32, out: &mut Vec<[u32; 3]>) {
    if to - from >= 2 {
        let middle = (from + to).div_ceil(2);
        out.push([from, middle, to]);
        halve(from, middle, out);
        halve(middle, to, out);
    }
}

/// The outline along the axis its normal is nearest to, turning counter-clockwise.
fn projected(outline: &[DVec3]) -> Vec<DVec2> {
    // Scaled, so that no product overflows or vanishes: a power of two changes no sign.
    let size = outline.iter().map(|v| (*v / 2.0 - outline[0] / 2.0).abs().max_element()).fold(0.0, f64::max);
    let scale = 1.0 / crate::num::certified::power_of_two_below(size);
    let arm = |v: DVec3| (v * 0.5 - outline[0] * 0.5) * scale;
    let sum = |s: DVec3, w: &[DVec3]| s + arm(w[0]).cross(arm(w[1]));
    let normal = outline.windows(2).fold(DVec3::ZERO, sum);
    let axis = largest_axis(normal);
    let (mut i, mut j) = ((axis + 1) % 3, (axis + 2) % 3);
    if normal[axis] < 0.0 {
        (i, j) = (j, i);
    }
    outline.iter().map(|v| DVec2::new(v[i], v[j])).collect()
}

/// The sign of the turn a → b → c, exactly: +1 counter-clockwise, 0 straight on (or straight back).
///
/// - Source: Shewchuk (1997), `orient2d` with its first filter, `(3 + 16 u) u` of the sum of both products.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> i8 {
    let (left, right) = ((b.x - a.x) * (c.y - a.y), (b.y - a.y) * (c.x - a.x));
    let (det, size) = (left - right, left.abs() + right.abs());
    // Below 10⁻²⁸⁰ a product may have lost digits to underflow.
    if det.abs() > 4.0 * U * size && size > 1e-280 && size < f64::INFINITY {
        return if det > 0.0 { 1 } else { -1 };
    }
    let span = (b - a).abs().max((c - a).abs()).max_element();
    let unit = crate::num::certified::power_of_two_below(span);
    let arm = |p: DVec2, axis: usize| Expansion::difference(p[axis] / unit, a[axis] / unit);
    Expansion::determinant(&arm(b, 0), &arm(c, 1), &arm(b, 1), &arm(c, 0)).sign()
}

/// Does the outline turn left at every corner, and once round in all?
fn is_strictly_convex(flat: &[DVec2]) -> bool {
    let n = flat.len();
    let at = |i: usize| flat[i % n];
    let all_left = (0..n).all(|i| turn(at(i), at(i + 1), at(i + 2)) > 0);
    // Once round: along x it goes forth once and back once.
    let forth = |i: usize| {
        let (a, b) = (at(i), at(i + 1));
        if a.x == b.x { b.y > a.y } else { b.x > a.x }
    };
    all_left && (0..n).filter(|&i| forth(i) != forth(i + 1)).count() == 2
}

/// An outline that loses its ears.
struct Ears<'a> {
    flat: &'a [DVec2],
    before: Vec<usize>,
    after: Vec<usize>,
    alive: Vec<bool>,
    /// Corners that may stand in the way of an ear: those that do not turn left.
    reflex: Vec<usize>,
    left: usize,
}

impl<'a> Ears<'a> {
    fn new(flat: &'a [DVec2]) -> Self {
        let n = flat.len();
        let mut ears = Ears {
            flat,
            before: (0..n).map(|i| (i + n - 1) % n).collect(),
            after: (0..n).map(|i| (i + 1) % n).collect(),
            alive: vec![true; n],
            reflex: Vec::new(),
            left: n,
        };
        ears.reflex = (0..n).filter(|&i| ears.turn_at(i) <= 0).collect();
        ears
    }

    fn turn_at(&self, i: usize) -> i8 {
        turn(self.flat[self.before[i]], self.flat[i], self.flat[self.after[i]])
    }

    /// Can the corner be cut off: does it turn left, and is no other corner in the triangle or on its rim?
    fn is_ear(&self, i: usize) -> bool {
        if !self.alive[i] || self.turn_at(i) <= 0 {
            return false;
        }
        let [a, b, c] = [self.before[i], i, self.after[i]].map(|k| self.flat[k]);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        !self.reflex.iter().any(|&r| {
            let p = self.flat[r];
            self.alive[r]
                && p.cmpge(low).all()
                && p.cmple(high).all()
                && p != a
                && p != b
                && p != c
                && turn(a, b, p) >= 0
                && turn(b, c, p) >= 0
                && turn(c, a, p) >= 0
        })
    }

    fn cut(&mut self, i: usize, out: &mut Vec<[u32; 3]>) -> [usize; 2] {
        let (a, c) = (self.before[i], self.after[i]);
        out.push([a, i, c].map(|k| k as u32));
        (self.after[a], self.before[c]) = (c, a);
        self.alive[i] = false;
        self.left -= 1;
        [a, c]
    }

    /// Cuts ears in the order in which they were found; looking again at a cut's two neighbours suffices, and where it does
    /// not, all are looked at again, a few times at most, so that no outline takes more than its length squared.
    fn clip(mut self, out: &mut Vec<[u32; 3]>) -> Outline {
        const LOOKS: usize = 8;
        for _ in 0..LOOKS {
            let mut ears: VecDeque<usize> = (0..self.flat.len()).filter(|&i| self.is_ear(i)).collect();
            if ears.is_empty() {
                break;
            }
            while let Some(i) = ears.pop_front() {
                if self.left <= 3 {
                    break;
                }
                if self.is_ear(i) {
                    let neighbours = self.cut(i, out);
                    ears.extend(neighbours.into_iter().filter(|&k| self.is_ear(k)));
                }
            }
        }
        // Only an outline that is not simple has more than three corners and no ear.
        let outline = if self.left > 3 { Outline::Crossed } else { Outline::Simple };
        while self.left > 3 {
            let first = self.alive.iter().position(|&alive| alive).unwrap_or(0);
            let mut i = first;
            while self.left > 3 {
                let [_, next] = self.cut(i, out);
                i = self.after[next];
            }
        }
        let last = self.alive.iter().position(|&alive| alive).unwrap_or(0);
        let outline = if self.turn_at(last) > 0 { outline } else { Outline::Crossed };
        self.cut(last, out);
        outline
    }
}

/// Why polygons make no mesh.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    #[error(transparent)]
    Shape(#[from] ShapeError),
    #[error(
        "face {face}: expected at most {} corners where an outline is not convex, found {corners}",
        MOST_CONCAVE
    )]
    TooLong { face: usize, corners: usize },
}

impl Polygons {
    /// The polygons with every face cut into triangles, which keep their corners' attributes.
    ///
    /// - Errors: a concave outline of more than [`MOST_CONCAVE`] corners.
    pub fn triangulated(&self) -> Result<Cut, MeshError> {
        let mut mesh = Polygons::of_points(self.points.clone());
        (mesh.uvs.values, mesh.normals.values) = (self.uvs.values.clone(), self.normals.values.clone());
        let mut cut = Cut { mesh, origin: Vec::new(), crossed: 0 };
        let (mut outline, mut triangles) = (Vec::new(), Vec::new());
        for f in 0..self.len() {
            outline.clear();
            triangles.clear();
            outline.extend(self.outline(f));
            match triangulate(&outline, &mut triangles) {
                Outline::TooLong => {
                    return Err(MeshError::TooLong { face: f, corners: outline.len() });
                }
                Outline::Crossed => cut.crossed += 1,
                Outline::Simple => {}
            }
            let start = self.range(f).start;
            for t in &triangles {
                cut.mesh.push(&t.map(|k| self.corner(start + k as usize)), self.parts[f]);
                cut.origin.push(f as u32);
            }
        }
        Ok(cut)
    }
}

/// Polygons cut into triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    pub mesh: Polygons,
    /// For each triangle the face it comes from.
    pub origin: Vec<u32>,
    /// Faces whose outline crosses itself or has no area.
    pub crossed: usize,
}
