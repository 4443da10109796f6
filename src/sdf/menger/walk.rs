//! The way of a ray through the cells of a sponge, from coarse to fine.
//!
//! A node is a cube of the grid. The ray's way through it is cut by the two inner planes of each axis into at most seven
//! pieces, one for each of its 27 parts that the ray meets; the solid ones are entered in turn. The parameter of a plane
//! is a function of axis and index alone,
//!
//! ```text
//! t = (x_plane − o)/d,
//! ```
//!
//! and never falls along the ray: where one cell ends the next begins, exactly. A cell that the ray only touches, `enter = leave`,
//! is no part of its way. A ray in the plane between two cells is in both, so that it is walked on either side and the
//! stretches are joined: closed like the cells themselves.

use super::{FACES, Menger};
use crate::ray::{Crossing, Ray, Span};
use glam::DVec3;
use std::ops::ControlFlow;

/// Are two of three digits 1: one of the seven parts taken away?
#[inline]
pub fn is_hole(digits: [u32; 3]) -> bool {
    digits.iter().filter(|d| **d == 1).count() >= 2
}

/// Reports the ray's stretches in solid cells, ascending, each at most one cell long unless joined; neighbours share their
/// ends bit for bit. Cells that end before the range or begin behind it are left out.
pub fn stretches(
    sponge: &Menger,
    ray: &Ray,
    range: (f64, f64),
    visit: &mut impl FnMut(Span) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let (o, d) = (ray.origin, ray.direction);
    if d == DVec3::ZERO || !o.is_finite() || !d.is_finite() {
        return ControlFlow::Continue(());
    }
    // Along an axis in which the ray does not move it stays in one layer of cells, or between two.
    let layers = [0, 1, 2].map(|axis| if d[axis] == 0.0 { sponge.cells_at(axis, o[axis]) } else { 0..1 });
    let sides = layers.iter().map(ExactSizeIterator::len).product::<usize>();
    let line = |layer: [u32; 3]| Line { sponge, o, d, layer, range };
    match sides {
        0 => ControlFlow::Continue(()),
        1 => line([layers[0].start, layers[1].start, layers[2].start]).all(visit),
        _ => {
            let mut spans = Vec::new();
            let [xs, ys, zs] = layers;
            for x in xs {
                for (y, z) in ys.clone().flat_map(|y| zs.clone().map(move |z| (y, z))) {
                    let _ = line([x, y, z]).all(&mut |span| {
                        spans.push(span);
                        ControlFlow::Continue(())
                    });
                }
            }
            joined(spans).into_iter().try_for_each(visit)
        }
    }
}

/// The union of spans, sorted and disjoint.
fn joined(mut spans: Vec<Span>) -> Vec<Span> {
    spans.sort_by(|a, b| a.enter.t.total_cmp(&b.enter.t));
    let mut out: Vec<Span> = Vec::new();
    for span in spans {
        match out.last_mut() {
            Some(last) if last.leave.t >= span.enter.t => {
                if span.leave.t > last.leave.t {
                    last.leave = span.leave;
                }
            }
            _ => out.push(span),
        }
    }
    out
}

/// A ray in the sponge's grid, its cells counted along the ray's direction.
struct Line<'a> {
    sponge: &'a Menger,
    o: DVec3,
    d: DVec3,
    /// The layer in which the ray stays, for each axis along which it does not move.
    layer: [u32; 3],
    range: (f64, f64),
}

/// A cube of the grid: its first cell, its cells along an edge, and where its near and far planes are met.
#[derive(Clone, Copy)]
struct Node {
    first: [u32; 3],
    size: u32,
    near: [f64; 3],
    far: [f64; 3],
}

impl Line<'_> {
    /// Where plane `i`, counted along the ray, is met. A mirrored sponge is the same sponge.
    #[inline]
    fn t(&self, axis: usize, i: u32) -> f64 {
        let (o, d) = (self.o[axis], self.d[axis]);
        if d > 0.0 {
            (self.sponge.plane(axis, i) - o) / d
        } else if d < 0.0 {
            (self.sponge.plane(axis, self.sponge.cells - i) - o) / d
        } else if i <= self.layer[axis] {
            f64::NEG_INFINITY
        } else {
            f64::INFINITY
        }
    }

    fn all(&self, visit: &mut impl FnMut(Span) -> ControlFlow<()>) -> ControlFlow<()> {
        let size = self.sponge.cells;
        let [near, far] = [0, size].map(|i| [0, 1, 2].map(|axis| self.t(axis, i)));
        let node = Node { first: [0; 3], size, near, far };
        if smallest(far).0 < self.range.0 { ControlFlow::Continue(()) } else { self.visit(&node, visit) }
    }

    /// The solid cells of a node that the ray passes through.
    fn visit(&self, node: &Node, visit: &mut impl FnMut(Span) -> ControlFlow<()>) -> ControlFlow<()> {
        let (enter, leave) = (largest(node.near), smallest(node.far));
        if !(enter.0 < leave.0) {
            return ControlFlow::Continue(());
        }
        if enter.0 >= self.range.1 {
            return ControlFlow::Break(());
        }
        if node.size == 1 {
            return visit(Span {
                enter: self.crossing(enter, node.first[enter.1], 0),
                leave: self.crossing(leave, node.first[leave.1] + 1, 1),
            });
        }
        let third = node.size / 3;
        // The planes of each axis, and in which third the ray enters.
        let planes = [0, 1, 2].map(|axis| {
            let inner = |k: u32| self.t(axis, node.first[axis] + k * third);
            [node.near[axis], inner(1), inner(2), node.far[axis]]
        });
        let mut digit = planes.map(|p| usize::from(p[1] <= enter.0) + usize::from(p[2] <= enter.0));
        loop {
            let far = [0, 1, 2].map(|axis| planes[axis][digit[axis] + 1]);
            let (next, _) = smallest(far);
            if next >= self.range.0 && !is_hole(digit.map(|k| k as u32)) {
                let near = [0, 1, 2].map(|axis| planes[axis][digit[axis]]);
                let first = [0, 1, 2].map(|axis| node.first[axis] + digit[axis] as u32 * third);
                self.visit(&Node { first, size: third, near, far }, visit)?;
            }
            if !(next < leave.0) {
                return ControlFlow::Continue(());
            }
            for (axis, digit) in digit.iter_mut().enumerate() {
                *digit += usize::from(far[axis] == next);
            }
        }
    }

    /// The crossing of plane `i`, counted along the ray, into (`out` 0) or out of (1) a cell.
    fn crossing(&self, (t, axis): (f64, usize), i: u32, out: u32) -> Crossing {
        let cells = self.sponge.cells;
        let (side, plane) = if self.d[axis] > 0.0 { (out, i) } else { (1 - out, cells - i) };
        let deep = if side == 0 { plane } else { cells - plane };
        Crossing::new(t, FACES * deep + 2 * axis as u32 + side)
    }
}

/// The largest of three and its index.
#[inline]
fn largest(t: [f64; 3]) -> (f64, usize) {
    let (a, i) = if t[1] > t[0] { (t[1], 1) } else { (t[0], 0) };
    if t[2] > a { (t[2], 2) } else { (a, i) }
}

/// The smallest of three and its index.
#[inline]
fn smallest(t: [f64; 3]) -> (f64, usize) {
    let (a, i) = if t[1] < t[0] { (t[1], 1) } else { (t[0], 0) };
    if t[2] < a { (t[2], 2) } else { (a, i) }
}
