//! The Menger sponge: a cube cut into 27, of which the middle one and those at the middles of the faces are taken away;
//! and so again with each of the 20 that are left, down to a depth [E §2.3].
//!
//! In units of the finest cells the sponge of depth `n` is a grid of `3ⁿ` cells a side, and a cell is solid unless two of
//! its three coordinates have the digit 1 at the same place to the base 3. From this follow two ways to meet it:
//!
//! - The grid (`walk`): from the cube to its 27 parts and into those that are solid, in the order in which the ray meets
//!   them. All cells that share a plane share its `t`, bit for bit, so that no ray slips between two of them.
//! - The field: the distance to the cube, cut by bars of every size. With `aᵢ` the distance of coordinate `i` from the
//!   middle third of its period,
//!
//! ```text
//! f = max( d(cube), −median(a₁) , −median(a₂), … )                                       (1)
//! ```
//!
//! for a point is in one of the three crossing bars if two of its `aᵢ` are negative. It bounds the distance (`L = 1`), and is 0 on the
//! surface only. [`super::FieldShape`] marches it.
//!
//! The numbers of lesson 08 choose the grid; the nodes that a ray visits are all that is ever computed.

mod walk;

use super::DistanceField;
use super::primitive::box_distance;
use crate::bounds::Aabb;
use crate::num::gamma;
use crate::ray::{Crossing, Hit, Ray, Span};
use crate::shape::{Shape, ShapeError, Solid};
use glam::{DVec2, DVec3};
use std::ops::ControlFlow;

/// Faces of a cell, in the order of [`crate::shape::cuboid::Cuboid`].
const FACES: u32 = 6;

/// A Menger sponge: closed, its cells solid.
///
/// Faces: 0: −x, 1: +x, 2: −y, 3: +y, 4: −z, 5: +z of the cube, and `6 k` more for a wall that lies `k` cells deeper. Texture
/// coordinates are those of the cube's faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Menger {
    center: DVec3,
    edge: f64,
    depth: u32,
    /// Cells along an edge, `3^depth`, and half the edge of one.
    cells: u32,
    half_cell: f64,
    cube: Aabb,
}

impl Menger {
    /// Deepest sponge: 531 441 cells along an edge. A ray along a wall visits them all.
    pub const MOST_DEPTH: u32 = 12;

    /// The sponge about `center` of that edge \[m\]; depth 0 is the whole cube.
    ///
    /// - Errors: numbers that are not finite, an edge that is not positive, a depth above [`Menger::MOST_DEPTH`], cells that rounding
    ///   loses so far from the origin.
    pub fn new(center: DVec3, edge: f64, depth: u32) -> Result<Self, ShapeError> {
        let center = ShapeError::finite("centre of a sponge", center)?;
        let edge = ShapeError::positive("edge of a sponge", edge)?;
        if depth > Self::MOST_DEPTH {
            return Err(ShapeError::TooDeep { allowed: Self::MOST_DEPTH, found: depth });
        }
        let cells = 3u32.pow(depth);
        let cell = edge / f64::from(cells);
        // A plane errs by 3 roundings; cells ten times as thick as that stay apart, and rays between them.
        let least = gamma(64) * (center.abs().max_element() + edge);
        if !(cell > least) {
            return Err(ShapeError::TooFine { least, found: cell });
        }
        ShapeError::finite("corner of a sponge", center.abs() + edge)?;
        let half_cell = edge / f64::from(2 * cells);
        let half = half_cell * f64::from(cells);
        Ok(Menger { center, edge, depth, cells, half_cell, cube: Aabb::new(center - half, center + half) })
    }

    pub fn center(&self) -> DVec3 {
        self.center
    }

    pub fn edge(&self) -> f64 {
        self.edge
    }

    pub fn depth(&self) -> u32 {
        self.depth
    }

    /// Where plane `i` of `0..=cells` lies along an axis; never falls as `i` grows.
    #[inline]
    fn plane(&self, axis: usize, i: u32) -> f64 {
        let from_middle = f64::from(2 * i) - f64::from(self.cells);
        self.center[axis] + self.half_cell * from_middle
    }

    /// The cells along an axis that hold a coordinate: none, one, or two that share its plane.
    fn cells_at(&self, axis: usize, x: f64) -> std::ops::Range<u32> {
        let guess = ((x - self.plane(axis, 0)) / (2.0 * self.half_cell)).floor();
        // A cast keeps to the range of the type; the guess errs by a cell at most, the planes decide.
        let guess = (guess as u32).min(self.cells - 1);
        let holds = |i: &u32| self.plane(axis, *i) <= x && x <= self.plane(axis, i + 1);
        let near = guess.saturating_sub(1)..(guess + 2).min(self.cells);
        let first = near.clone().find(holds).unwrap_or(near.end);
        let last = near.clone().rev().find(holds).map_or(first, |i| i + 1);
        first..last
    }

    /// Is a cell left?
    pub fn is_solid(&self, cell: [u32; 3]) -> bool {
        let mut rest = cell;
        for _ in 0..self.depth {
            if walk::is_hole(rest.map(|i| i % 3)) {
                return false;
            }
            rest = rest.map(|i| i / 3);
        }
        true
    }

    /// The plane that a face number names.
    fn plane_of(&self, face: u32) -> f64 {
        let (side, deep) = (face % FACES, (face / FACES).min(self.cells));
        let i = if side.is_multiple_of(2) { deep } else { self.cells - deep };
        self.plane((side / 2) as usize, i)
    }
}

/// Axis across a face, and those of `u` and `v`.
fn axes_of(face: u32) -> [usize; 3] {
    let axis = (face % FACES / 2) as usize;
    [axis, (axis + 1) % 3, (axis + 2) % 3]
}

impl Shape for Menger {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let mut found = None;
        let mut last = f64::NEG_INFINITY;
        let _ = walk::stretches(self, ray, (t_min, t_max), &mut |span: Span| {
            if last < span.enter.t && last > t_min {
                return ControlFlow::Break(()); // the stretch before ended behind t_min
            }
            if last < span.enter.t && span.enter.t > t_min {
                found = Some(span.enter);
                return ControlFlow::Break(());
            }
            last = span.leave.t;
            found = Some(span.leave);
            ControlFlow::Continue(())
        });
        found.filter(|c| c.t > t_min && c.t < t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        let first = out.len();
        let _ = walk::stretches(self, ray, (0.0, f64::INFINITY), &mut |span: Span| {
            match out.get(first..).and_then(<[Crossing]>::last) {
                Some(end) if end.t >= span.enter.t => {
                    out.pop();
                }
                _ => out.push(span.enter),
            }
            out.push(span.leave);
            ControlFlow::Continue(())
        });
        let mut i = 0;
        out.retain(|c| {
            i += 1;
            i <= first || (c.t > 0.0 && c.t.is_finite())
        });
    }

    /// The point lies exactly in its plane: that coordinate is copied. The plane itself errs by three roundings.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let [axis, u, v] = axes_of(crossing.face);
        let cube = self.cube;
        let mut point = ray.at(crossing.t).clamp(cube.min, cube.max);
        point[axis] = self.plane_of(crossing.face);
        let share = (point - cube.min) / (cube.max - cube.min);
        let outwards = if crossing.face.is_multiple_of(2) { -DVec3::AXES[axis] } else { DVec3::AXES[axis] };
        Hit {
            t: crossing.t,
            point,
            point_error: gamma(4) * (self.center.abs().max_element() + self.edge),
            ng: outwards,
            n: outwards,
            tangent: DVec3::AXES[u],
            uv: DVec2::new(share[u], share[v]),
            face: crossing.face,
            part: crossing.part,
        }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        let [axis, u, v] = axes_of(face);
        let cube = self.cube;
        let mut point = cube.min;
        point[u] += (cube.max[u] - cube.min[u]) * uv.x;
        point[v] += (cube.max[v] - cube.min[v]) * uv.y;
        point[axis] = self.plane_of(face);
        point
    }

    fn bounds(&self) -> Aabb {
        self.cube
    }
}

impl Solid for Menger {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        let first = out.len();
        let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
        let _ = walk::stretches(self, ray, everywhere, &mut |span: Span| {
            match out.get_mut(first..).and_then(<[Span]>::last_mut) {
                Some(last) if last.leave.t >= span.enter.t => last.leave = span.leave,
                _ => out.push(span),
            }
            ControlFlow::Continue(())
        });
    }

    fn contains(&self, p: DVec3) -> bool {
        let [xs, ys, zs] = [0, 1, 2].map(|axis| self.cells_at(axis, p[axis]));
        xs.flat_map(|x| ys.clone().map(move |y| (x, y)))
            .any(|(x, y)| zs.clone().any(|z| self.is_solid([x, y, z])))
    }
}

/// Equation (1). The bars of one size fill all space periodically; outside the cube its own distance decides.
impl DistanceField for Menger {
    fn distance(&self, p: DVec3) -> f64 {
        let mut d = box_distance(p, &self.cube);
        let mut period = self.edge;
        let from_corner = p - self.cube.min;
        for _ in 0..self.depth {
            let share = from_corner / period;
            let a = ((share - share.floor() - 0.5).abs() - 1.0 / 6.0) * period;
            // The median: the smallest of the three pairwise maxima, one for each bar.
            let bars = a.x.max(a.y).min(a.y.max(a.z)).min(a.x.max(a.z));
            d = d.max(-bars);
            period /= 3.0;
        }
        d
    }
    fn bounds(&self, level: f64) -> Aabb {
        super::grown(&self.cube, level)
    }
    fn scale(&self) -> f64 {
        self.center.abs().max_element() + self.edge
    }
    fn detail(&self) -> f64 {
        2.0 * self.half_cell
    }
}
