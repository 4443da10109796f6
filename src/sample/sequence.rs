//! Sequences of points that fill the square evenly, however many are taken.
//!
//! A *(0,2)-sequence* in base 2 has this property: of any aligned `2ᵏ` consecutive points, each of
//! the `k + 1` ways to cut the square into `2ᵏ` equal rectangles of sides `2⁻ᵃ × 2⁻ᵇ` finds exactly one
//! point in every rectangle. [`sobol`] is such a sequence; [`sobol_scrambled`] randomises it
//! without losing the property. [`r2`] has no such proof, and one line of code.

use super::counter::{Purpose, block, unit_from_bits};
use super::permutation::mix;
use crate::num::U;
use glam::{DVec2, UVec2};

/// The `i`-th point of Sobol's sequence in the square, in units of 2⁻³².
///
/// ```text
/// x = Σ_k i_k 2^(31−k)  (bits reversed: van der Corput),    y_j = ⊕_k C(k, j) i_k mod 2,  y reversed likewise
/// ```
///
/// The second matrix is Pascal's triangle mod 2. `C(k, j)` is odd when the bits of `j` are among those
/// of `k` (Lucas), so the sum runs over supersets, and five masked shifts do it.
///
/// - Domain: every `i`; after 2³² points the sequence would end.
/// - Source: Sobol' (1967); the matrices as in Joe & Kuo (2008), dimensions 1 and 2.
#[inline]
pub fn sobol(i: u32) -> UVec2 {
    let mut y = i;
    y ^= (y >> 1) & 0x5555_5555;
    y ^= (y >> 2) & 0x3333_3333;
    y ^= (y >> 4) & 0x0F0F_0F0F;
    y ^= (y >> 8) & 0x00FF_00FF;
    y ^= (y >> 16) & 0x0000_FFFF;
    UVec2::new(i.reverse_bits(), y.reverse_bits())
}

/// The `i`-th point of the Owen-scrambled and shuffled Sobol' sequence that belongs to a seed.
///
/// Scrambling flips every binary digit by a random function of the digits before it: each point
/// becomes uniform in the square (so means are unbiased), while every aligned block of `2ᵏ` points
/// keeps one in each elementary rectangle. The order is scrambled the same way, which sends aligned blocks to aligned
/// blocks, so that two sets for two dimensions of one sample can be used side by side. Digits
/// beyond the 32nd are hashed.
///
/// - Domain: every `i` and seed. In [0,1)², never 1.
/// - Accuracy: the scrambling is a hash, not the ideal random tree; the tests find its means unbiased.
/// - Source: Owen (1995); Burley, *Practical hash-based Owen scrambling*, JCGT 9(4) (2020); the hash
///   is Vegdahl's (2021) improvement of Laine & Karras (2011).
#[inline]
pub fn sobol_scrambled(seed: u64, i: u32) -> DVec2 {
    ScrambledSobol::new(seed).point(i)
}

/// The sequence of [`sobol_scrambled`] for one seed, its keys made once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScrambledSobol {
    order: u32,
    key_x: u32,
    key_y: u32,
    rest: u32,
}

impl ScrambledSobol {
    #[inline]
    pub fn new(seed: u64) -> Self {
        let [a, b] = block(seed, 0, 0, Purpose::Sequence, 0);
        ScrambledSobol { order: a as u32, key_x: (a >> 32) as u32, key_y: b as u32, rest: (b >> 32) as u32 }
    }

    /// The `i`-th point, in [0,1)².
    #[inline]
    pub fn point(&self, i: u32) -> DVec2 {
        let p = sobol(scramble(i, self.order));
        let finish = |x: u32, key: u32| {
            let x = scramble(x, key);
            (u64::from(x) << 21 | u64::from(mix(x ^ key ^ self.rest) >> 11)) as f64 * U
        };
        DVec2::new(finish(p.x, self.key_x), finish(p.y, self.key_y))
    }
}

/// Flips each bit by a function of the higher ones: a nested uniform scramble in base 2.
#[inline]
fn scramble(x: u32, seed: u32) -> u32 {
    // Each step lets a bit depend on itself and lower bits only; reversed, on higher ones.
    let mut x = x.reverse_bits();
    x ^= x.wrapping_mul(0x3D20_ADEA);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6C56);
    x ^= x.wrapping_mul(0x53A2_2864);
    x.reverse_bits()
}

/// `2⁶⁴/φ₂` and `2⁶⁴/φ₂²`, rounded; `φ₂ = 1.3247179572447460…` solves `x³ = x + 1`.
const R2_STEPS: [u64; 2] = [0xC13F_A9A9_02A6_328F, 0x91E1_0DA5_C79E_7B1D];

/// The `i`-th point of the R₂ sequence, shifted around the torus by a random vector.
///
/// ```text
/// p = frac(s + i (1/φ₂, 1/φ₂²)),    φ₂³ = φ₂ + 1
/// ```
///
/// Computed in 64-bit fixed point, so that large `i` loses nothing.
///
/// - Domain: every `i` and seed. In [0,1)², never 1.
/// - Accuracy: the steps are rounded to 2⁻⁶⁵, so the `i`-th point is off by `i · 2⁻⁶⁵` at most, plus 2⁻⁵³ of truncation.
/// - Source: Roberts, *The unreasonable effectiveness of quasirandom sequences* (2018); the random shift:
///   Cranley & Patterson (1976).
#[inline]
pub fn r2(seed: u64, i: u32) -> DVec2 {
    let shift = block(seed, 0, 1, Purpose::Sequence, 0);
    let at =
        |axis: usize| unit_from_bits(shift[axis].wrapping_add(R2_STEPS[axis].wrapping_mul(u64::from(i))));
    DVec2::new(at(0), at(1))
}
