//! Random numbers as a function of their place.
//!
//! A stateful generator answers "the next number, please", so that whoever asks first gets it:
//! the picture then depends on the order of threads, and one pixel cannot be redrawn alone. A
//! counter-based generator enciphers the *place* of the number,
//!
//! ```text
//! key     = seed                                            64 bits
//! counter = (index, sample, purpose | dimension / 2)        64 + 32 + 32 bits
//! words   = Philox4x32-10(counter, key)                     two numbers of 53 bits
//! ```
//!
//! and needs no memory, no seeding, and no skipping ahead. The price is arithmetic: ten rounds
//! of two multiplications give two numbers, where a stateful generator such as PCG or xoshiro
//! makes one in one or two steps. Against a ray's journey through a scene neither is visible.
//!
//! Source of cipher and test vectors: Salmon, Moraes, Dror & Shaw, *Parallel random numbers: as
//! easy as 1, 2, 3*, SC 2011.

use crate::num::U;
use glam::DVec2;

/// Multipliers of the two halves of the cipher's state (Salmon et al. 2011, found there by search
/// for the fastest avalanche).
const MULTIPLIERS: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];
/// Steps of the round keys: the golden ratio and √3 − 1, both in units of 2⁻³².
const KEY_STEPS: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];
/// The fewest rounds known to pass every test is 7; the authors recommend 10.
const ROUNDS: u32 = 10;

/// Four words that look random: the block cipher Philox4x32-10.
///
/// For a fixed key the map of counters to words is a bijection, so that `2¹²⁸` blocks follow
/// before one repeats.
///
/// - Domain: everything.
/// - Source: Salmon et al. (2011), §4.3.
#[inline]
pub fn philox4x32(counter: [u32; 4], key: [u32; 2]) -> [u32; 4] {
    let (mut c, mut k) = (counter, key);
    for _ in 0..ROUNDS {
        let p0 = u64::from(MULTIPLIERS[0]) * u64::from(c[0]);
        let p1 = u64::from(MULTIPLIERS[1]) * u64::from(c[2]);
        c = [(p1 >> 32) as u32 ^ c[1] ^ k[0], p1 as u32, (p0 >> 32) as u32 ^ c[3] ^ k[1], p0 as u32];
        k = [k[0].wrapping_add(KEY_STEPS[0]), k[1].wrapping_add(KEY_STEPS[1])];
    }
    c
}

/// What a block of random words is for; blocks of different purposes never coincide.
#[derive(Clone, Copy)]
#[repr(u32)]
pub(super) enum Purpose {
    Dimension = 0,
    Permutation = 1 << 31,
    Cell = (1 << 31) | 1,
    Sequence = (1 << 31) | 2,
}

/// Two times 64 random bits at a place; `slot < 2³¹` counts blocks of the purpose `Dimension`.
#[inline]
pub(super) fn block(seed: u64, index: u64, sample: u32, purpose: Purpose, slot: u32) -> [u64; 2] {
    let counter = [index as u32, (index >> 32) as u32, sample, purpose as u32 | slot];
    let w = philox4x32(counter, [seed as u32, (seed >> 32) as u32]);
    [u64::from(w[0]) << 32 | u64::from(w[1]), u64::from(w[2]) << 32 | u64::from(w[3])]
}

/// 64 random bits; their arguments are those of [`uniform`].
///
/// The same place gives the number of [`uniform`] by [`unit_from_bits`], so a dimension serves
/// either as bits (a seed for something else) or as a number, not as both.
#[inline]
pub fn bits(seed: u64, index: u64, sample: u32, dimension: u32) -> u64 {
    block(seed, index, sample, Purpose::Dimension, dimension >> 1)[(dimension & 1) as usize]
}

/// The number in [0,1) whose 53 binary digits are the high ones of `bits`.
///
/// ```text
/// u = ⌊bits / 2¹¹⌋ · 2⁻⁵³
/// ```
///
/// Both steps are exact, so the largest value is `1 − 2⁻⁵³`, **never 1**. (Dividing all the bits by
/// their range rounds the highest ones up to 1: with 32 bits in single precision for 128 values.)
///
/// - Domain: everything. All bits set: `1 − 2⁻⁵³`.
#[inline]
pub fn unit_from_bits(bits: u64) -> f64 {
    (bits >> 11) as f64 * U
}

/// A random number, uniform in [0,1): a pure function of its place.
///
/// `index` counts pixels or photons, `sample` the samples of one, `dimension` the numbers that one
/// sample consumes.
///
/// - Domain: everything; two places that differ share no number but by chance.
/// - Accuracy: a multiple of 2⁻⁵³; never 1.
/// - Source: Philox4x32-10, Salmon et al. (2011).
#[inline]
pub fn uniform(seed: u64, index: u64, sample: u32, dimension: u32) -> f64 {
    unit_from_bits(bits(seed, index, sample, dimension))
}

/// The `i`-th random point of the unit square in repetition `run` of an experiment.
///
/// It holds dimensions 0 and 1 of sample `i` of index `run`; see [`uniform`].
#[inline]
pub fn point2(seed: u64, run: u32, i: u32) -> DVec2 {
    pair(seed, u64::from(run), i, 0)
}

#[inline]
fn pair(seed: u64, index: u64, sample: u32, slot: u32) -> DVec2 {
    let [x, y] = block(seed, index, sample, Purpose::Dimension, slot);
    DVec2::new(unit_from_bits(x), unit_from_bits(y))
}

/// A cursor over the random numbers of one sample of one pixel or photon.
///
/// A copy replays the same numbers. Numbers come in pairs, and a point always takes a whole pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampler {
    seed: u64,
    index: u64,
    sample: u32,
    dimension: u32,
}

impl Sampler {
    /// The numbers of sample `sample` of the pixel or photon `index`, from dimension 0 on.
    #[inline]
    pub fn new(seed: u64, index: u64, sample: u32) -> Self {
        Sampler { seed, index, sample, dimension: 0 }
    }

    /// The dimension that [`Sampler::next_1d`] would read. After 2³² numbers they repeat.
    #[inline]
    pub fn dimension(&self) -> u32 {
        self.dimension
    }

    /// A uniform number in [0,1).
    #[inline]
    pub fn next_1d(&mut self) -> f64 {
        unit_from_bits(self.next_bits())
    }

    /// A uniform point of the unit square: the next whole pair of dimensions, from one block.
    ///
    /// An odd dimension is left out, so that a point costs one block, not two.
    #[inline]
    pub fn next_2d(&mut self) -> DVec2 {
        let slot = self.dimension.div_ceil(2) & (u32::MAX >> 1);
        self.dimension = slot.wrapping_add(1) << 1;
        pair(self.seed, self.index, self.sample, slot)
    }

    /// 64 random bits: the seed of a [`super::PointSet`] or [`super::Permutation`] of this sample's own.
    #[inline]
    pub fn next_bits(&mut self) -> u64 {
        let b = bits(self.seed, self.index, self.sample, self.dimension);
        self.dimension = self.dimension.wrapping_add(1);
        b
    }

    /// The seed of a sequence that all samples of this pixel read on, and how many of them came before this one.
    ///
    /// Sample `s` takes the points from `s n` to `(s + 1) n` of a sequence, so that the points of a whole pixel are as even
    /// as those of one sample. For sample 0 the seed is [`Sampler::next_bits`].
    #[inline]
    pub fn next_sequence(&mut self) -> (u64, u32) {
        let seed = bits(self.seed, self.index, 0, self.dimension);
        self.dimension = self.dimension.wrapping_add(1);
        (seed, self.sample)
    }

    /// Passes over `dimensions` numbers, at no cost.
    ///
    /// A branch of a path that may consume any number up to `k` should advance by `k` in all, so that
    /// later decisions keep their dimensions.
    #[inline]
    pub fn skip(&mut self, dimensions: u32) {
        self.dimension = self.dimension.wrapping_add(dimensions);
    }
}
