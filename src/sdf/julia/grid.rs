//! Where nothing is: a grid of cells, each with the largest cubes of empty cells that begin with it, one for each octant of directions.
//!
//! A cell is empty if balls of [`super::reach`] cover it: that is a proof, so a ray leaps across empty cells without
//! losing anything. Only cells near the surface are looked at one by one; the others are proven empty eight,
//! or 64, or 512 at a time.

use super::lanes::{LANES, Lanes};
use super::line::Line;
use super::reach::{Start, balls};
use super::set::Set;
use crate::bounds::Aabb;
use glam::DVec3;

/// Cells along an edge. Tuned: with 32 rays look longer at cells that may hold something, with 64 they leap over more cells, and the
/// grid takes three times as long to make.
const SIDE: usize = 48;
/// Cells along an edge with the border of empty ones.
const PADDED: usize = SIDE + 2;
/// Cells of the grid with its border.
const CELLS: usize = PADDED * PADDED * PADDED;
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
    /// Of each octant and cell, the edge of the cube that is empty; 0 if the cell may hold something. See [`octants`].
    edges: Box<[u8]>,
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
        let edges = vec![u8::MAX; CELLS].into_boxed_slice();
        let grid = Grid { half: radius, cell, per_cell: 1.0 / cell, edges, radius: 0.0, bounds: Aabb::EMPTY };
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

    /// Ball, box and empty cubes, from the cells that may hold something.
    fn measure(&mut self, radius: f64) {
        let (pad, edge) = (self.cell * (MARGIN - 1.0), DVec3::splat(self.cell));
        let (mut farthest, mut bounds) = (0.0f64, Aabb::EMPTY);
        for z in 0..SIDE {
            for y in 0..SIDE {
                let row = &self.edges[index(0, y, z)..][..SIDE];
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
        self.edges = octants(&self.edges);
    }

    /// A line in cells.
    #[inline(always)]
    pub fn path(&self, line: &Line) -> Path {
        let (middle, direction) = (line.middle, line.direction);
        let nudge = self.cell * line.per_length * (0.5 * (MARGIN - 1.0));
        let axis = |middle: f64, direction: f64| {
            // Half a cell more: the nearest whole number is then that of the cell, counted with the border.
            let (start, speed) = ((middle + self.half) * self.per_cell + 0.5, direction * self.per_cell);
            // A line along an axis never leaves a cell across it; 1/speed is a number from 10⁻³⁰⁰ on.
            if speed.abs() < 1.0e-300 {
                return PathAxis { start, speed, leave: f64::INFINITY, per_cell: 0.0 };
            }
            let per_cell = 1.0 / speed;
            PathAxis { start, speed, leave: nudge - start * per_cell - 0.5 * per_cell.abs(), per_cell }
        };
        let octant = (0..3).filter(|i| direction[*i] < 0.0).map(|i| 1 << i).sum::<usize>();
        Path {
            axes: [axis(middle.x, direction.x), axis(middle.y, direction.y), axis(middle.z, direction.z)],
            octant: octant * CELLS,
            least: 2.0 * nudge,
        }
    }

    /// Where the line next enters a cell that may hold something, from `s` on; `end` if there is none before.
    ///
    /// A cell of edge `n` begins a cube of `n` empty ones along each axis, the way the line goes, and the line leaves that next. It takes half
    /// as many leaps as a cube about the cell.
    #[inline(always)]
    pub fn skip(&self, path: &Path, mut s: f64, end: f64) -> f64 {
        // Added to a number, this rounds it to the nearest whole one, and leaves that in the lowest bits.
        const ROUND: f64 = (1u64 << 52) as f64;
        let edges = &self.edges[path.octant..][..CELLS];
        let last = CELLS - 1;
        while s < end {
            let [x, y, z] = path.axes.map(|a| a.start + a.speed * s + ROUND);
            let [i, j, k] = [x, y, z].map(|x| x.to_bits() as usize & 0xffff);
            let edge = edges[(k * (PADDED * PADDED) + j * PADDED + i).min(last)];
            if edge == 0 {
                return s;
            }
            let edge = f64::from(edge);
            let leave = |a: &PathAxis, x: f64| a.leave + ((x - ROUND) * a.per_cell + edge * a.per_cell.abs());
            let [a, b, c] = &path.axes;
            let (tx, ty, tz) = (leave(a, x), leave(b, y), leave(c, z));
            let t = if tx < ty { tx } else { ty };
            let t = if tz < t { tz } else { t };
            s = if t > s { t } else { s + path.least };
        }
        end
    }
}

/// A line in cells, axis by axis.
#[derive(Clone, Copy)]
pub(super) struct Path {
    axes: [PathAxis; 3],
    /// Where the table of its octant begins.
    octant: usize,
    /// The shortest leap, where rounding would allow none.
    least: f64,
}

#[derive(Clone, Copy)]
struct PathAxis {
    /// Cells at `s = 0`, and per unit of `s`.
    start: f64,
    speed: f64,
    /// Where a cube of edge 0 about cell 0 ends, and what a cell adds.
    leave: f64,
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
                        self.grid.edges[index(x, y, z)] = 0;
                    } else {
                        open.push(*part);
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn start<V: Lanes>(&self, blocks: &[Block; LANES]) -> Start<V> {
        let (mut x, mut y, mut z) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for (i, block) in blocks.iter().enumerate() {
            let middle = |axis: usize| {
                (block.at[axis] as f64 + 0.5 * block.size as f64) * (0.5 * self.grid.cell) - self.grid.half
            };
            let at = self.set.reduced(DVec3::new(middle(0), middle(1), middle(2)), self.set.w());
            [x[i], y[i], z[i]] = at.doubled();
        }
        let still = V::splat(0.0);
        Start {
            x: V::of(x),
            y: V::of(y),
            z: V::of(z),
            dx: still,
            dy: still,
            half_dz: still,
            beta: V::splat(1.0),
        }
    }
}

/// For each octant of directions, of every cell the edge of the largest cube of empty cells that begins with it and lies
/// that way; 0 for cells that may hold something.
///
/// ```text
/// edge = 1 + the least edge of the seven neighbours that way
/// ```
///
/// The solid lies within the grid: beyond it there is nothing, however far. A ray that enters may, by its rounding, still be in the border, from
/// where it leaps one cell.
fn octants(occupied: &[u8]) -> Box<[u8]> {
    let mut out = vec![u8::MAX; 8 * CELLS].into_boxed_slice();
    for (octant, d) in out.chunks_exact_mut(CELLS).enumerate() {
        let backwards = [0, 1, 2].map(|axis| octant >> axis & 1 == 1);
        // Far cells come first.
        let order = |axis: usize| (1..=SIDE).map(move |i| if backwards[axis] { i } else { SIDE + 1 - i });
        let ahead = |axis: usize, i: usize| if backwards[axis] { i - 1 } else { i + 1 };
        for z in order(2) {
            for y in order(1) {
                let row = |y: usize, z: usize| (z * PADDED + y) * PADDED;
                let rows = [row(ahead(1, y), z), row(y, ahead(2, z)), row(ahead(1, y), ahead(2, z))];
                let rows = rows.map(|at| &d[at..][..PADDED]);
                let best: [u8; PADDED] = std::array::from_fn(|x| rows[0][x].min(rows[1][x]).min(rows[2][x]));
                let at = row(y, z);
                let (here, occupied) = (&mut d[at..][..PADDED], &occupied[at..][..PADDED]);
                let mut last = u8::MAX;
                for x in order(0) {
                    let least = best[x].min(best[ahead(0, x)]).min(last);
                    last = if occupied[x] == 0 { 0 } else { least.saturating_add(1) };
                    here[x] = last;
                }
            }
        }
        for (i, row) in d.chunks_exact_mut(PADDED).enumerate() {
            if [i % PADDED, i / PADDED].into_iter().any(|x| x == 0 || x == PADDED - 1) {
                row.fill(1);
            } else {
                (row[0], row[PADDED - 1]) = (1, 1);
            }
        }
    }
    out
}
