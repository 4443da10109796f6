//! The unit square cut into cells of equal area.

use super::counter::{Purpose, block, unit_from_bits};
use glam::DVec2;

/// One cell: the half-open rectangle from `min` to `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    pub min: DVec2,
    pub max: DVec2,
}

impl Cell {
    pub fn center(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// The point at the place `u` in [0,1)² of the cell.
    ///
    /// Rounding could carry it onto the far edge, into the neighbour or to 1; it is kept one step
    /// before that edge.
    pub fn at(&self, u: DVec2) -> DVec2 {
        let p = self.min + (self.max - self.min) * u;
        p.min(DVec2::new(self.max.x.next_down(), self.max.y.next_down()))
    }
}

/// Rows of cells of equal area, counted along `x`, then up `y`.
///
/// Any number of cells is possible: with `r = round(√n)` rows, `n mod r` of them (the lowest)
/// get one cell more than the others, and a row is as high as its share of the cells:
///
/// ```text
/// cells in row j:  c_j = ⌊n/r⌋ + [j < n mod r],    height of row j:  c_j / n,    area of a cell:  1/n
/// ```
///
/// Because all areas are equal, the plain mean over one point per cell is unbiased for every `n`, and
/// its variance never exceeds that of independent points. If `n` is a square this is the square grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cells {
    n: u32,
    rows: u32,
    columns: u32,
    longer_rows: u32,
}

impl Cells {
    /// `n` cells of equal area, nearly square.
    pub fn equal_areas(n: u32) -> Self {
        // At least one row: an empty set divides by nothing.
        let rows = f64::from(n).sqrt().round().max(1.0) as u32;
        Cells { n, rows, columns: n / rows, longer_rows: n % rows }
    }

    /// `columns × rows` equal rectangles.
    ///
    /// # Panics
    /// If there are more than 2³² − 1 cells.
    pub fn grid(columns: u32, rows: u32) -> Self {
        let n = columns.checked_mul(rows);
        let n = n.unwrap_or_else(|| panic!("{columns} × {rows} cells are more than 2³² − 1"));
        Cells { n, rows, columns, longer_rows: 0 }
    }

    /// The number of cells.
    pub fn len(&self) -> u32 {
        self.n
    }

    pub fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// The `i`-th cell. Neighbours share their edges to the last bit.
    ///
    /// # Panics
    /// If `i ≥ n`, as a slice does.
    pub fn cell(&self, i: u32) -> Cell {
        assert!(i < self.n, "cell {i} of {}", self.n);
        let in_longer = self.longer_rows * (self.columns + 1);
        let (row, column, columns) = if i < in_longer {
            (i / (self.columns + 1), i % (self.columns + 1), self.columns + 1)
        } else {
            let beyond = i - in_longer;
            (self.longer_rows + beyond / self.columns, beyond % self.columns, self.columns)
        };
        let share = |k: u32, of: u32| f64::from(k) / f64::from(of);
        let before = |r: u32| r * self.columns + r.min(self.longer_rows);
        Cell {
            min: DVec2::new(share(column, columns), share(before(row), self.n)),
            max: DVec2::new(share(column + 1, columns), share(before(row + 1), self.n)),
        }
    }

    /// All cells in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Cell> + use<> {
        let cells = *self;
        (0..cells.n as usize).map(move |i| cells.cell(i as u32))
    }

    /// A random point of the `i`-th cell.
    ///
    /// # Panics
    /// If `i ≥ n`, as a slice does.
    pub fn jittered(&self, seed: u64, i: u32) -> DVec2 {
        let [x, y] = block(seed, 0, i, Purpose::Cell, 0);
        self.cell(i).at(DVec2::new(unit_from_bits(x), unit_from_bits(y)))
    }
}
