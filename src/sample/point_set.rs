//! Sets of `n` points of the square, by value.

use super::cells::Cells;
use super::counter::point2;
use super::sequence::{r2, sobol_scrambled};
use glam::DVec2;

/// How points are spread: the choice a light or a pixel makes before it knows number and seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pattern {
    /// The centres of equal cells: no randomness, hence regular errors (stepped shadows) [D fig. 30].
    Centres,
    /// One random point in each of `n` cells of equal area [D fig. 30].
    Jittered,
    /// Independent random points [A ill. 45].
    Random,
    /// The Owen-scrambled Sobol' sequence.
    Sobol,
    /// The R₂ sequence with a random shift.
    R2,
}

impl Pattern {
    pub const ALL: [Pattern; 5] =
        [Pattern::Centres, Pattern::Jittered, Pattern::Random, Pattern::Sobol, Pattern::R2];

    /// The name in legends and flags.
    pub fn name(self) -> &'static str {
        match self {
            Pattern::Centres => "centres",
            Pattern::Jittered => "jittered",
            Pattern::Random => "random",
            Pattern::Sobol => "sobol",
            Pattern::R2 => "r2",
        }
    }

    /// The pattern of that [`Pattern::name`].
    pub fn from_name(name: &str) -> Option<Pattern> {
        Pattern::ALL.into_iter().find(|p| p.name() == name)
    }

    /// Is the mean over the points unbiased? Only for [`Pattern::Centres`] it is not.
    pub fn is_unbiased(self) -> bool {
        self != Pattern::Centres
    }

    /// `n` points of this pattern; the seed has no effect on [`Pattern::Centres`].
    #[inline]
    pub fn points(self, n: u32, seed: u64) -> PointSet {
        match self {
            Pattern::Centres => PointSet::Centres(Cells::equal_areas(n)),
            Pattern::Jittered => PointSet::Jittered { cells: Cells::equal_areas(n), seed },
            Pattern::Random => PointSet::Random { n, seed },
            Pattern::Sobol => PointSet::Sobol { n, seed },
            Pattern::R2 => PointSet::R2 { n, seed },
        }
    }
}

/// `n` points of [0,1)²; each is computed when asked for, nothing is stored.
///
/// Two sets with different seeds are independent. A set whose points pair up with those of another
/// (lens and light, say) should be read in the order of a [`super::Permutation`], unless it is
/// `Random` or `Sobol`, whose order is random already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointSet {
    /// The centres of the cells.
    Centres(Cells),
    /// One uniform point in each cell.
    Jittered { cells: Cells, seed: u64 },
    /// Independent uniform points; with `seed` and `i` they are `point2(seed, 0, i)`.
    Random { n: u32, seed: u64 },
    /// See [`sobol_scrambled`]. Powers of two are its best numbers.
    Sobol { n: u32, seed: u64 },
    /// See [`r2`].
    R2 { n: u32, seed: u64 },
}

impl PointSet {
    /// The number of points.
    pub fn len(&self) -> u32 {
        match *self {
            PointSet::Centres(cells) | PointSet::Jittered { cells, .. } => cells.len(),
            PointSet::Random { n, .. } | PointSet::Sobol { n, .. } | PointSet::R2 { n, .. } => n,
        }
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The `i`-th point, in [0,1)², never 1.
    ///
    /// # Panics
    /// If `i ≥ n`, as a slice does.
    #[inline]
    pub fn point(&self, i: u32) -> DVec2 {
        assert!(i < self.len(), "point {i} of {}", self.len());
        match *self {
            PointSet::Centres(cells) => cells.cell(i).center(),
            PointSet::Jittered { cells, seed } => cells.jittered(seed, i),
            PointSet::Random { seed, .. } => point2(seed, 0, i),
            PointSet::Sobol { seed, .. } => sobol_scrambled(seed, i),
            PointSet::R2 { seed, .. } => r2(seed, i),
        }
    }

    /// All points in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = DVec2> + use<> {
        let set = *self;
        (0..set.len() as usize).map(move |i| set.point(i as u32))
    }
}
