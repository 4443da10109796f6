//! Outlines of any shape on paper, found by tracing: where the shape ends, hides itself, or has an edge.
//!
//! The paper is ruled into cells, and a ray goes through each corner of a cell, square to the paper. Two corners that differ
//! (one ray hits and the other misses, or the hits are far apart in depth or in normal) have an outline between them,
//! which bisection finds: a jump that is real stays while the interval shrinks, and a slope or a bend does not. The points of
//! a cell are joined, and the joints of neighbouring cells make lines.

use crate::bounds::Aabb;
use crate::figure::Space;
use crate::ray::Ray;
use crate::shape::Shape;
use glam::{DVec2, DVec3, dvec2};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Cells along a side of the shape's frame on paper, at least and at most. Tuned: 16 leave a ring whole, 240 are finer than
/// the lines that are drawn.
const CELLS: (f64, f64) = (16.0, 240.0);
/// Times that an interval is halved: to 1/256, finer than any pen.
const HALVINGS: u32 = 8;
/// Depth between neighbours [distance of their rays], and 1 less the cosine between their normals (20°), from which on a jump is
/// looked for.
const STEEP: f64 = 0.5;
const BENT: f64 = 0.06;
/// Share of a jump that is left after all halvings if it is real. Of a slope 1/256 is left, of the root at a smooth rim 1/16.
const LEFT: f64 = 0.25;
/// Shares of neighbours on the surface with a jump between them from which on the lines are dense, as of a fractal, and from
/// which on they are mere noise: then only where the shape ends is drawn. Tuned: a Menger sponge of depth 4 has 0.44, a
/// Julia set 0.08.
const DENSE: f64 = 0.2;
const NOISE: f64 = 0.6;

/// The lines of a shape.
#[derive(Clone, Debug, Default)]
pub struct Outlines {
    pub lines: Vec<Vec<DVec2>>,
    /// Do they stand so close that a broad pen would fill the shape?
    pub are_dense: bool,
}

/// The paper, and what of space is drawn on it.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    right: DVec3,
    up: DVec3,
    /// Towards the viewer.
    back: DVec3,
    /// What lies outside is cut off.
    room: Aabb,
}

/// Where the ray through a point of the paper hits.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// Distance from the plane of the paper that the ray starts from.
    depth: f64,
    /// Unit, of the side that is seen; smooth where the shape is shaded as smooth.
    normal: DVec3,
}

/// A point of the paper, and what is seen there.
type Corner = (DVec2, Option<Seen>);

/// A point between two neighbouring corners, by the corner of the smaller index and whether the other is the next one along
/// x or along y; or the middle of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Joint {
    Across(usize, usize),
    Along(usize, usize),
    Middle(usize, usize),
}

impl Paper {
    /// The paper of a parallel projection.
    pub fn new(space: &Space, room: Aabb) -> Self {
        let [x, y, z] = DVec3::AXES.map(|axis| space.at(axis));
        let (right, up) = (DVec3::new(x.x, y.x, z.x), DVec3::new(x.y, y.y, z.y));
        Paper { right, up, back: right.cross(up), room }
    }

    /// The frame of a box on paper.
    fn frame(&self, of: &Aabb) -> (DVec2, DVec2) {
        let corners = (0..8).map(|i| {
            let pick = |bit: usize, a: f64, b: f64| if i >> bit & 1 == 1 { b } else { a };
            let p = DVec3::new(
                pick(0, of.min.x, of.max.x),
                pick(1, of.min.y, of.max.y),
                pick(2, of.min.z, of.max.z),
            );
            dvec2(p.dot(self.right), p.dot(self.up))
        });
        corners.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
    }

    /// The outlines of a shape, as lines of the paper; `pen` is the width of a cell that a pen could fill.
    pub fn outlines(&self, shape: &dyn Shape, pen: f64) -> Outlines {
        let bounds = shape.bounds();
        let part = Aabb::new(bounds.min.max(self.room.min), bounds.max.min(self.room.max));
        let (low, high) = self.frame(&part);
        let drawable =
            pen > 0.0 && pen.is_finite() && (high - low).min_element() > 0.0 && (high - low).is_finite();
        if part.is_empty() || !drawable {
            return Outlines::default();
        }
        let cells = ((high - low) / pen).clamp(DVec2::splat(CELLS.0), DVec2::splat(CELLS.1)).ceil();
        // A cell of air on every side, so that outlines close.
        let step = (high - low) / cells;
        let grid = Grid {
            paper: self,
            shape,
            room: Aabb::new(part.min - pen, part.max + pen),
            low: low - step,
            step,
            size: (cells.x as usize + 3, cells.y as usize + 3),
        };
        grid.outlines()
    }
}

/// The corners of all cells.
struct Grid<'a> {
    paper: &'a Paper,
    shape: &'a dyn Shape,
    room: Aabb,
    low: DVec2,
    step: DVec2,
    size: (usize, usize),
}

impl Grid<'_> {
    fn corner(&self, i: usize, j: usize) -> DVec2 {
        self.low + self.step * dvec2(i as f64, j as f64)
    }

    fn seen(&self, p: DVec2) -> Option<Seen> {
        let Paper { right, up, back, .. } = *self.paper;
        let center = self.room.center();
        let far = center.dot(back) + (self.room.max - self.room.min).length();
        let ray = Ray::new(right * p.x + up * p.y + back * far, -back);
        let (enter, leave) = self.room.slab(ray.origin, ray.direction.recip(), 0.0, f64::INFINITY)?;
        let crossing = self.shape.nearest(&ray, enter, leave)?;
        let normal = self.shape.hit(&ray, &crossing).n;
        Some(Seen { depth: crossing.t, normal: if normal.dot(back) < 0.0 { -normal } else { normal } })
    }

    fn outlines(&self) -> Outlines {
        let (columns, rows) = self.size;
        let seen: Vec<Option<Seen>> = (0..columns * rows)
            .into_par_iter()
            .map(|k| self.seen(self.corner(k % columns, k / columns)))
            .collect();
        let between = |(i, j): (usize, usize), (k, l): (usize, usize)| {
            let (a, b) = (seen[j * columns + i], seen[l * columns + k]);
            let found = self.between((self.corner(i, j), a), (self.corner(k, l), b));
            found.map(|p| (p, a.is_some() && b.is_some()))
        };
        let pairs: Vec<(Joint, Option<(DVec2, bool)>)> = (0..columns * rows)
            .into_par_iter()
            .flat_map_iter(|k| {
                let (i, j) = (k % columns, k / columns);
                let across = (i + 1 < columns).then(|| (Joint::Across(i, j), between((i, j), (i + 1, j))));
                let along = (j + 1 < rows).then(|| (Joint::Along(i, j), between((i, j), (i, j + 1))));
                across.into_iter().chain(along)
            })
            .collect();
        let inside = pairs.iter().filter(|(_, found)| found.is_some_and(|(_, inside)| inside)).count();
        let surface = 2 * seen.iter().flatten().count();
        let share = inside as f64 / (surface as f64).max(1.0);
        let points = pairs.into_iter().filter_map(|(joint, found)| {
            found.filter(|(_, inside)| !(share > NOISE && *inside)).map(|(p, _)| (joint, p))
        });
        Outlines { lines: self.lines(points.collect()), are_dense: share > DENSE }
    }

    /// Where between two points of the paper an outline passes; none if nothing jumps there.
    fn between(&self, a: Corner, b: Corner) -> Option<DVec2> {
        let apart = jump(a.1, b.1);
        if apart.depth > STEEP * a.0.distance(b.0) {
            let (p, left) = self.halved(a, b, |jump| jump.depth);
            if left == f64::INFINITY || left > LEFT * apart.depth {
                return Some(p);
            }
        }
        if apart.bend < BENT {
            return None;
        }
        let (p, left) = self.halved(a, b, |jump| jump.bend);
        (left > LEFT * apart.bend).then_some(p)
    }

    /// Goes after the larger jump; where that leads, and what is left of it.
    fn halved(&self, mut a: Corner, mut b: Corner, size: impl Fn(Jump) -> f64) -> (DVec2, f64) {
        for _ in 0..HALVINGS {
            let middle = a.0.lerp(b.0, 0.5);
            let m = (middle, self.seen(middle));
            let first = size(jump(a.1, m.1)) >= size(jump(m.1, b.1));
            *(if first { &mut b } else { &mut a }) = m;
        }
        (a.0.lerp(b.0, 0.5), size(jump(a.1, b.1)))
    }

    /// Joins the points of each cell, and the joints of all cells to lines.
    fn lines(&self, points: BTreeMap<Joint, DVec2>) -> Vec<Vec<DVec2>> {
        let mut places = points;
        let mut next: BTreeMap<Joint, Vec<Joint>> = BTreeMap::new();
        let mut join = |a: Joint, b: Joint| {
            next.entry(a).or_default().push(b);
            next.entry(b).or_default().push(a);
        };
        for j in 0..self.size.1 - 1 {
            for i in 0..self.size.0 - 1 {
                let sides = [
                    Joint::Across(i, j),
                    Joint::Along(i + 1, j),
                    Joint::Across(i, j + 1),
                    Joint::Along(i, j),
                ];
                let found: Vec<Joint> = sides.into_iter().filter(|s| places.contains_key(s)).collect();
                match found[..] {
                    [] | [_] => {}
                    [a, b] => join(a, b),
                    _ => {
                        let middle = Joint::Middle(i, j);
                        let sum: DVec2 = found.iter().map(|joint| places[joint]).sum();
                        places.insert(middle, sum / found.len() as f64);
                        found.into_iter().for_each(|joint| join(joint, middle));
                    }
                }
            }
        }
        chains(next).into_iter().map(|chain| chain.iter().map(|joint| places[joint]).collect()).collect()
    }
}

/// How far two neighbours are apart.
#[derive(Clone, Copy, Debug)]
struct Jump {
    depth: f64,
    /// 1 less the cosine between the normals.
    bend: f64,
}

/// The jump between two neighbours: without bound if only one ray hits, and none if neither does.
fn jump(a: Option<Seen>, b: Option<Seen>) -> Jump {
    match (a, b) {
        (None, None) => Jump { depth: 0.0, bend: 0.0 },
        (Some(a), Some(b)) => Jump { depth: (a.depth - b.depth).abs(), bend: 1.0 - a.normal.dot(b.normal) },
        _ => Jump { depth: f64::INFINITY, bend: f64::INFINITY },
    }
}

/// The lines of a graph: from each end or crossing to the next, then what is left, which closes.
fn chains(mut next: BTreeMap<Joint, Vec<Joint>>) -> Vec<Vec<Joint>> {
    let ends: Vec<Joint> = next.iter().filter(|(_, n)| n.len() != 2).map(|(joint, _)| *joint).collect();
    let mut lines = Vec::new();
    for start in ends.iter().copied().chain(next.keys().copied().collect::<Vec<_>>()) {
        while let Some(first) = next.get(&start).and_then(|n| n.last().copied()) {
            let mut line = vec![start];
            let mut to = Some(first);
            while let Some(joint) = to {
                let from = line[line.len() - 1];
                for (a, b) in [(from, joint), (joint, from)] {
                    if let Some(list) = next.get_mut(&a) {
                        list.iter().position(|n| *n == b).map(|at| list.swap_remove(at));
                    }
                }
                line.push(joint);
                to = if ends.contains(&joint) {
                    None
                } else {
                    next.get(&joint).and_then(|n| n.last().copied())
                };
            }
            lines.push(line);
        }
    }
    lines
}
