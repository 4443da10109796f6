//! Randomness: numbers, points in the square, and the warps that carry them to directions and surfaces.
//!
//! Three steps, each a pure function, lead from a seed to a sample:
//!
//! 1. **Numbers.** [`uniform`] answers the question "what is random number `dimension` of sample
//!    `sample` of pixel or photon `index`?" directly: no generator is passed around, no thread
//!    sees another's state, and one pixel can be replayed alone. [`Sampler`] is a cursor over
//!    the dimensions of one sample.
//! 2. **Points.** A [`PointSet`] gives the `i`-th of `n` points of the unit square: cell
//!    centres, jittered cells, independent points, Owen-scrambled Sobol' or R₂.
//! 3. **Warps.** [`uniform_sphere`], [`cosine_hemisphere`], … map a point `u` of the square to
//!    directions or surfaces, and each comes with the density of what it makes.
//!
//! Local directions have their pole along `z`.

mod cells;
mod counter;
mod permutation;
mod point_set;
mod sequence;
mod warp;

pub use cells::{Cell, Cells};
pub use counter::{Sampler, bits, philox4x32, point2, uniform, unit_from_bits};
pub use permutation::Permutation;
pub use point_set::{Pattern, PointSet};
pub use sequence::{ScrambledSobol, r2, sobol, sobol_scrambled};
pub use warp::*;

/// The largest number a generator hands out, `1 − 2⁻⁵³`: the neighbour of 1 from below.
pub const LARGEST_BELOW_ONE: f64 = 1.0 - crate::num::U;
