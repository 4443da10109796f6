//! Where nothing is: a grid of cells, each with its distance to the nearest cell that may hold a part of the solid.
//!
//! A cell is empty if balls of [`super::reach`] cover it: that is a proof, so a ray leaps across empty cells without
//! losing anything. Only cells near the surface are looked at one by one; the others are proven empty eight,
//! or 64, or 512 at a time.

use super::lanes::{LANES, Lanes};
use super::reach::{Start, balls};
use super::set::Set;
use crate::bounds::Aabb;
use glam::DVec3;

/// Cells along an edge. Tuned: with 32 rays look longer at cells that may hold something, with 64 they leap over more cells, and the
/// grid takes three times as long to make.
const SIDE: usize = 48;
/// Cells along an edge with the border of empty ones.
const PADDED: usize = SIDE + 2;
/// Blocks of so many cells' edges are looked at first.
const COARSEST: usize = 8;
/// A cell and the rounding of its faces: rays that change cells may overstep by as much.
const MARGIN: f64 = 1.0 + 1.0 / (1 << 20) as f64;

/// The grid over the cube that holds the solid.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// Half the edge of the cube, edge of a cell, and its reciprocal.
    half: f64,
    cell: f64,
    per_cell: f64,
    /// Steps (along axes and diagonals) to the nearest cell that may hold something.
    distance: Box<[u8]>,
    /// Radius of the ball about the origin that holds all such cells, and the box that does.
    pub radius: f64,
    pub bounds: Aabb,
}

/// A block of `size` half cells along each edge.
#[derive(Clone, Copy)]
struct Block {
    at: [usize; 3],
    size: usize,
}

struct Survey<'a> {
    set: &'a Set,
    grid: Grid,
}

#[inline(always)]
fn index(x: usize, y: usize, z: usize) -> usize {
    ((z + 1) * PADDED + y + 1) * PADDED + x + 1
}

impl Grid {
    /// Surveys a solid that lies within the ball of `radius` about the origin.
    #[inline(always)]
    pub fn new<V: Lanes>(set: &Set, radius: f64) -> Self {
        let cell = 2.0 * radius / SIDE as f64;
        let distance = vec![u8::MAX; PADDED * PADDED * PADDED].into_boxed_slice();
        let grid =
            Grid { half: radius, cell, per_cell: 1.0 / cell, distance, radius: 0.0, bounds: Aabb::EMPTY };
        let mut survey = Survey { set, grid };
        let step = 2 * COARSEST;
        for z in (0..2 * SIDE).step_by(step) {
            for y in (0..2 * SIDE).step_by(step) {
                for x in (0..2 * SIDE).step_by(step) {
                    survey.look::<V>(Block { at: [x, y, z], size: step });
                }
            }
        }
        let mut grid = survey.grid;
        grid.measure(radius);
        grid
    }

    /// Edge of a cell.
    pub fn cell(&self) -> f64 {
        self.cell
    }

    /// Ball, box and distances, from the cells that may hold something.
    fn measure(&mut self, radius: f64) {
        let (pad, edge) = (self.cell * (MARGIN - 1.0), DVec3::splat(self.cell));
        let (mut farthest, mut bounds) = (0.0f64, Aabb::EMPTY);
        for z in 0..SIDE {
            for y in 0..SIDE {
                let row = &self.distance[index(0, y, z)..][..SIDE];
                // The first and the last of a row are its farthest.
                let (Some(first), Some(last)) =
                    (row.iter().position(|d| *d == 0), row.iter().rposition(|d| *d == 0))
                else {
                    continue;
                };
                for x in [first, last] {
                    let min = DVec3::new(x as f64, y as f64, z as f64) * self.cell - self.half;
                    farthest = farthest.max(min.abs().max((min + edge).abs()).length_squared());
                    bounds = bounds.union(&Aabb::new(min - pad, min + edge + pad));
                }
            }
        }
        (self.radius, self.bounds) = ((farthest.sqrt() * MARGIN).min(radius), bounds);
        for _ in 0..2 {
            sweep(&mut self.distance);
            self.distance.reverse();
        }
    }

    /// A line in cells.
    #[inline(always)]
    pub fn path(&self, middle: DVec3, direction: DVec3) -> Path {
        let axis = |middle: f64, direction: f64| {
            let (start, speed) = ((middle + self.half) * self.per_cell, direction * self.per_cell);
            // A line along an axis never leaves a cell across it; 1/speed is a number from 10⁻³⁰⁰ on.
            let still = speed.abs() < 1.0e-300;
            let (to_middle, per_cell) =
                if still { (f64::INFINITY, 0.0) } else { ((0.5 - start) / speed, 1.0 / speed) };
            PathAxis { start, speed, to_middle, per_cell }
        };
        Path { axes: [axis(middle.x, direction.x), axis(middle.y, direction.y), axis(middle.z, direction.z)] }
    }

    /// Where the line next enters a cell that may hold something, from `s` on; `end` if there is none before.
    ///
    /// A cell at distance `n` is the middle of a cube of `2n − 1` empty ones along each edge, and the line leaves that next.
    #[inline(always)]
    pub fn skip(&self, path: &Path, mut s: f64, end: f64) -> f64 {
        let nudge = self.cell * 0.5 * (MARGIN - 1.0);
        let last = SIDE as i32 - 1;
        while s < end {
            // What lies outside the grid is looked at in its nearest cell.
            let [x, y, z] = path.axes.map(|a| ((a.start + a.speed * s) as i32).clamp(0, last));
            let distance = self.distance[index(x as usize, y as usize, z as usize)];
            if distance == 0 {
                return s;
            }
            let reach = f64::from(distance) - 0.5;
            let leave =
                |a: &PathAxis, i: i32| a.to_middle + f64::from(i) * a.per_cell + reach * a.per_cell.abs();
            let [a, b, c] = &path.axes;
            let (tx, ty, tz) = (leave(a, x), leave(b, y), leave(c, z));
            let t = if tx < ty { tx } else { ty };
            let t = if tz < t { tz } else { t };
            s = if t > s { t } else { s } + nudge;
        }
        end
    }
}

/// A line in cells, axis by axis.
#[derive(Clone, Copy)]
pub(super) struct Path {
    axes: [PathAxis; 3],
}

#[derive(Clone, Copy)]
struct PathAxis {
    /// Cells at `s = 0`, and per unit of `s`.
    start: f64,
    speed: f64,
    /// `s` at the middle of cell 0, and per cell.
    to_middle: f64,
    per_cell: f64,
}

impl Survey<'_> {
    /// Looks at the eight parts of a block that may hold something.
    #[inline(always)]
    fn look<V: Lanes>(&mut self, top: Block) {
        let mut open = vec![top];
        while let Some(block) = open.pop() {
            let size = block.size / 2;
            let parts: [Block; 8] = std::array::from_fn(|i| Block {
                at: std::array::from_fn(|axis| block.at[axis] + (i >> axis & 1) * size),
                size,
            });
            // From the middle of a part to its corners.
            let reach = 0.25 * size as f64 * self.grid.cell * 3f64.sqrt() * MARGIN;
            for four in parts.as_chunks::<LANES>().0 {
                let free = balls(self.set, self.start::<V>(four)).array();
                for (part, free) in four.iter().zip(free) {
                    if free >= reach {
                        continue;
                    }
                    if size == 1 || (size == 2 && free == 0.0) {
                        let [x, y, z] = part.at.map(|i| i / 2);
                        self.grid.distance[index(x, y, z)] = 0;
                    } else {
                        open.push(*part);
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn start<V: Lanes>(&self, blocks: &[Block; LANES]) -> Start<V> {
        let (mut a, mut u, mut p) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for (i, block) in blocks.iter().enumerate() {
            let middle = |axis: usize| {
                (block.at[axis] as f64 + 0.5 * block.size as f64) * (0.5 * self.grid.cell) - self.grid.half
            };
            let at = self.set.reduced(DVec3::new(middle(0), middle(1), middle(2)), self.set.w());
            (a[i], u[i], p[i]) = (at.a, at.u, at.across.length_squared());
        }
        let still = V::splat(0.0);
        Start { a: V::of(a), u: V::of(u), p: V::of(p), da: still, du: still, hp: still }
    }
}

/// Carries distances forwards, by one step for each of the neighbours that come before; there and back is all of them.
fn sweep(d: &mut [u8]) {
    let mut best = [0u8; PADDED];
    for z in 1..PADDED {
        for y in 1..=SIDE {
            let (before, here) = d.split_at_mut((z * PADDED + y) * PADDED);
            let near = |back: usize| &before[before.len() - back * PADDED..][..PADDED];
            let rows = [near(1), near(PADDED - 1), near(PADDED), near(PADDED + 1)];
            for (x, best) in best.iter_mut().enumerate() {
                *best = rows[0][x].min(rows[1][x]).min(rows[2][x]).min(rows[3][x]);
            }
            let mut last = u8::MAX;
            for (here, three) in here[1..=SIDE].iter_mut().zip(best.windows(3)) {
                let least = three[0].min(three[1]).min(three[2]).min(last).saturating_add(1);
                last = least.min(*here);
                *here = last;
            }
        }
    }
}
