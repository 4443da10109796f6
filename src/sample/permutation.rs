//! Shuffles without lists.

use super::counter::{Purpose, block};

/// Up to this many elements a shuffle is stored, and exactly uniform.
const STORED: usize = 16;
/// Rounds of the Feistel network; four make it a strong permutation (Luby & Rackoff 1988) when the
/// halves are wide, small halves need more (tuned: with 4, the position chi² of 17 elements fails;
/// 8 use up two blocks of keys, and pass).
const ROUNDS: usize = 8;

/// A random order of `0..n`, evaluated element by element in constant memory.
///
/// Stratified sets need shuffles where two of them meet: the third area-light cell must not always go
/// with the third cell of the pixel. Up to 16 elements the order is a stored Fisher–Yates
/// shuffle; all `n!` orders are equally likely up to `n · 2⁻⁶⁴` per draw. Beyond, it is a Feistel
/// network on the next power of two, walked along its cycle until it comes back into `0..n`
/// (at most twice on average).
///
/// - Domain: any `n`.
/// - Source: Fisher & Yates (1938); Luby & Rackoff (1988); cycle walking: Black & Rogaway, *Ciphers
///   with arbitrary finite domains* (2002).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Permutation {
    n: u32,
    order: Order,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    Stored([u8; STORED]),
    Feistel { keys: [u32; ROUNDS], low_bits: u32, high_bits: u32 },
}

impl Permutation {
    /// The shuffle of `0..n` that belongs to a seed.
    pub fn new(n: u32, seed: u64) -> Self {
        let order = if n as usize <= STORED { stored(n, seed) } else { feistel(n, seed) };
        Permutation { n, order }
    }

    /// How many elements are shuffled.
    pub fn len(&self) -> u32 {
        self.n
    }

    pub fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// The element at position `i`.
    ///
    /// # Panics
    /// If `i ≥ n`, as a slice does.
    #[inline]
    pub fn at(&self, i: u32) -> u32 {
        assert!(i < self.n, "position {i} of a permutation of {} elements", self.n);
        match &self.order {
            Order::Stored(order) => u32::from(order[i as usize]),
            Order::Feistel { keys, low_bits, high_bits } => {
                // The network is a bijection, so the walk from an element below n returns below n.
                let mut x = i;
                loop {
                    x = encipher(x, keys, *low_bits, *high_bits);
                    if x < self.n {
                        return x;
                    }
                }
            }
        }
    }
}

fn stored(n: u32, seed: u64) -> Order {
    let mut order: [u8; STORED] = std::array::from_fn(|i| i as u8);
    for last in (1..n as usize).rev() {
        let random = block(seed, u64::from(n), last as u32, Purpose::Permutation, 0)[0];
        order.swap(last, below(random, last as u64 + 1) as usize);
    }
    Order::Stored(order)
}

/// A number in `0..n` from 64 random bits; each has probability `1/n` up to `2⁻⁶⁴`.
fn below(random: u64, n: u64) -> u64 {
    ((u128::from(random) * u128::from(n)) >> 64) as u64
}

fn feistel(n: u32, seed: u64) -> Order {
    let bits = u32::BITS - (n - 1).leading_zeros();
    let mut keys = [0; ROUNDS];
    for (i, pair) in keys.chunks_exact_mut(2).enumerate() {
        let random = block(seed, u64::from(n), (i / 2) as u32, Purpose::Permutation, 0)[i % 2];
        pair.copy_from_slice(&[random as u32, (random >> 32) as u32]);
    }
    Order::Feistel { keys, low_bits: bits / 2, high_bits: bits - bits / 2 }
}

/// Eight alternating rounds on a word of two unequal halves: each is invertible whatever `mix` does.
#[inline]
fn encipher(x: u32, keys: &[u32; ROUNDS], low_bits: u32, high_bits: u32) -> u32 {
    let (low_mask, high_mask) = ((1 << low_bits) - 1, (1 << high_bits) - 1);
    let (mut low, mut high) = (x & low_mask, x >> low_bits);
    for k in keys.chunks_exact(2) {
        low ^= mix(high ^ k[0]) & low_mask;
        high ^= mix(low ^ k[1]) & high_mask;
    }
    high << low_bits | low
}

/// Spreads every input bit over all output bits; a bijection.
///
/// - Source: the finaliser of MurmurHash3, Appleby (2011).
#[inline]
pub(super) fn mix(mut x: u32) -> u32 {
    x = (x ^ (x >> 16)).wrapping_mul(0x85EB_CA6B);
    x = (x ^ (x >> 13)).wrapping_mul(0xC2B2_AE35);
    x ^ (x >> 16)
}
