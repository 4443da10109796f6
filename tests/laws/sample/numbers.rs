//! Laws of the counter-based generator and its shuffles.

use crate::support::chi2::chi2_uniform;
use crate::support::seed;
use glam::DVec2;
use lightbench::sample::{LARGEST_BELOW_ONE, Permutation, Sampler, bits, point2, uniform, unit_from_bits};
use proptest::prelude::*;

#[test]
fn no_bits_make_one() {
    // In single precision, or with rounding, the highest values would.
    assert_eq!(unit_from_bits(u64::MAX), LARGEST_BELOW_ONE);
    assert_eq!(LARGEST_BELOW_ONE.next_up(), 1.0);
    assert_eq!(unit_from_bits(0), 0.0);
    assert_eq!(unit_from_bits(1 << 63), 0.5);
    for dropped in 0..64 {
        let u = unit_from_bits(u64::MAX ^ ((1 << dropped) - 1));
        assert!(u < 1.0, "{u}");
    }
}

/// A place, moved `i` steps along one of the four arguments, at a start that tests high words too.
fn place(axis: usize, i: u32) -> (u64, u64, u32, u32) {
    let (s, index, sample, dimension) = (seed("place"), (1 << 40) + 7, 3, 2);
    match axis {
        0 => (s + u64::from(i), index, sample, dimension),
        1 => (s, index + u64::from(i), sample, dimension),
        2 => (s, index, sample + i, dimension),
        _ => (s, index, sample, dimension + i),
    }
}

#[test]
fn every_byte_is_uniform_along_every_argument() {
    for axis in 0..4 {
        let mut counts = [[0u64; 256]; 8];
        for i in 0..200_000 {
            let (s, index, sample, dimension) = place(axis, i);
            for (byte, count) in bits(s, index, sample, dimension).to_le_bytes().into_iter().zip(&mut counts)
            {
                count[usize::from(byte)] += 1;
            }
        }
        for (byte, count) in counts.iter().enumerate() {
            let result = chi2_uniform(count);
            assert!(result.passes(), "argument {axis}, byte {byte}: {result:?}");
        }
    }
}

#[test]
fn neighbours_are_independent() {
    // Pairs of adjacent seeds, pixels, samples, dimensions fill the square; the pairs are disjoint.
    for axis in 0..4 {
        for distance in [1, 2, 1 << 16] {
            let mut counts = [0u64; 32 * 32];
            for i in 0..200_000u32 {
                let i = i % distance + (i / distance) * 2 * distance;
                let number = |i| {
                    let (s, index, sample, dimension) = place(axis, i);
                    uniform(s, index, sample, dimension)
                };
                let (a, b) = ((number(i) * 32.0) as usize, (number(i + distance) * 32.0) as usize);
                counts[a * 32 + b] += 1;
            }
            let result = chi2_uniform(&counts);
            assert!(result.passes(), "argument {axis}, distance {distance}: {result:?}");
        }
    }
}

#[test]
fn adjacent_pixels_do_not_correlate() {
    // The sample correlation of n independent pairs has mean 0 and deviation 1/√n.
    let n = 400_000;
    let s = seed("correlation");
    let sum: f64 =
        (0..n).map(|i| (uniform(s, 2 * i, 0, 0) - 0.5) * (uniform(s, 2 * i + 1, 0, 0) - 0.5)).sum();
    let correlation = 12.0 * sum / n as f64;
    assert!(correlation.abs() <= crate::support::z() / (n as f64).sqrt(), "{correlation}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn numbers_lie_in_the_half_open_interval(s: u64, index: u64, sample: u32, dimension: u32) {
        let u = uniform(s, index, sample, dimension);
        prop_assert!((0.0..1.0).contains(&u));
        prop_assert_eq!(u, unit_from_bits(bits(s, index, sample, dimension)));
    }

    #[test]
    fn a_sampler_reads_the_dimensions_in_order(s: u64, index: u64, sample: u32, skip in 0u32..9) {
        let mut sampler = Sampler::new(s, index, sample);
        sampler.skip(skip);
        let replay = sampler;
        prop_assert_eq!(sampler.next_1d(), uniform(s, index, sample, skip));
        let pair = (skip + 1).next_multiple_of(2);
        let point = DVec2::new(uniform(s, index, sample, pair), uniform(s, index, sample, pair + 1));
        prop_assert_eq!(sampler.next_2d(), point);
        prop_assert_eq!(sampler.next_bits(), bits(s, index, sample, pair + 2));
        prop_assert_eq!(sampler.dimension(), pair + 3);
        prop_assert_eq!(replay.dimension(), skip);
    }

    #[test]
    fn point2_is_the_first_pair_of_its_sample(s: u64, run: u32, i: u32) {
        prop_assert_eq!(point2(s, run, i), Sampler::new(s, run.into(), i).next_2d());
    }

    #[test]
    fn a_permutation_is_a_bijection(n in 1u32..3000, s: u64) {
        let order = Permutation::new(n, s);
        let mut seen = vec![false; n as usize];
        for i in 0..n {
            prop_assert!(!std::mem::replace(&mut seen[order.at(i) as usize], true), "{} twice", order.at(i));
        }
    }
}

#[test]
fn dimensions_wrap_around_at_the_end() {
    let mut sampler = Sampler::new(1, 2, 3);
    sampler.skip(u32::MAX);
    assert_eq!(sampler.next_2d(), Sampler::new(1, 2, 3).next_2d());
    assert_eq!(sampler.dimension(), 2);
}

#[test]
fn permutations_at_the_edges_of_their_domain() {
    assert!(Permutation::new(0, 5).is_empty());
    assert_eq!(Permutation::new(1, 5).at(0), 0);
    let largest = Permutation::new(u32::MAX, 5);
    let images = [0, 1, 1 << 31, u32::MAX - 1].map(|i| largest.at(i));
    assert!(images.iter().all(|&x| x < u32::MAX));
    assert!((1..4).all(|i| !images[..i].contains(&images[i])));
}

#[test]
fn all_orders_of_four_are_equally_likely() {
    let mut counts = [0u64; 256];
    for s in 0..48_000 {
        let order = Permutation::new(4, s);
        counts[(0..4).fold(0, |code, i| 4 * code + order.at(i) as usize)] += 1;
    }
    let orders: Vec<u64> = counts.into_iter().filter(|&c| c > 0).collect();
    assert_eq!(orders.len(), 24);
    let result = chi2_uniform(&orders);
    assert!(result.passes(), "{result:?}");
}

#[test]
fn pairs_of_places_of_a_permutation_are_equally_likely() {
    // Stored up to 16, a network from 17 on; 33 walks far outside its range.
    for n in [16, 17, 33] {
        for (a, b) in [(0, 1), (0, n - 1), (n / 2, n / 2 + 1)] {
            let mut counts = vec![0u64; (n * n) as usize];
            for s in 0..100 * u64::from(n * n) {
                let order = Permutation::new(n, s);
                counts[(order.at(a) * n + order.at(b)) as usize] += 1;
            }
            let distinct: Vec<u64> =
                (0..n * n).filter(|i| i / n != i % n).map(|i| counts[i as usize]).collect();
            let result = chi2_uniform(&distinct);
            assert!(result.passes(), "{n} elements, places {a}, {b}: {result:?}");
        }
    }
}
