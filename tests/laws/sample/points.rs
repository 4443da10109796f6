//! Laws of the point sets.

use crate::support::{Square, mean_matches, sample_matches_pdf, seed};
use glam::{DVec2, UVec2};
use lightbench::num::gamma;
use lightbench::sample::{Cells, Pattern, PointSet, Sampler, r2, sobol, sobol_scrambled};
use proptest::prelude::*;

/// Does every rectangle `2⁻ᵃ × 2^(a−k)` hold exactly one of the 2ᵏ points, for every `a`?
fn is_net(points: &[DVec2]) -> bool {
    let k = points.len().trailing_zeros();
    (0..=k).all(|a| {
        let (columns, rows) = (1usize << a, 1usize << (k - a));
        let mut seen = vec![false; points.len()];
        points.iter().all(|p| {
            let cell = (p.x * columns as f64) as usize * rows + (p.y * rows as f64) as usize;
            !std::mem::replace(&mut seen[cell], true)
        })
    })
}

fn unit(p: UVec2) -> DVec2 {
    p.as_dvec2() / 2f64.powi(32)
}

#[test]
fn sobol_blocks_are_nets() {
    for k in 0..=12 {
        for aligned in [0u32, 1, 5, (1 << (32 - k.max(1))) - 1] {
            let block = (0..1 << k).map(|i| unit(sobol((aligned << k) + i)));
            assert!(is_net(&block.collect::<Vec<_>>()), "block {aligned} of 2^{k}");
        }
    }
}

#[test]
fn scrambled_sobol_blocks_are_nets() {
    for k in 0..=12 {
        for s in 0..8 {
            let s = seed("net") + s;
            let block: Vec<_> = (3 << k..4 << k).map(|i| sobol_scrambled(s, i)).collect();
            assert!(is_net(&block), "2^{k} points, seed {s}");
        }
    }
}

#[test]
fn the_net_test_can_fail() {
    assert!(!is_net(&Pattern::Random.points(16, 1).iter().collect::<Vec<_>>()));
    assert!(!is_net(&Pattern::Jittered.points(16, 1).iter().collect::<Vec<_>>()));
}

#[test]
fn sobol_is_the_recursion_of_its_direction_numbers() {
    // v₀ = ½ and v₀ = ½, v_{k+1} = v_k ⊕ v_k/2 (Joe & Kuo 2008, polynomials 1 and x + 1).
    for i in (0..4096).chain([u32::MAX, 0x8000_0001, 0xDEAD_BEEF]) {
        let (mut x, mut y, mut v) = (0u32, 0u32, 1u32 << 31);
        for k in 0..32 {
            if i >> k & 1 == 1 {
                x ^= 1 << (31 - k);
                y ^= v;
            }
            v ^= v >> 1;
        }
        assert_eq!(sobol(i), UVec2::new(x, y));
    }
}

#[test]
fn sets_with_different_seeds_pair_up_at_random() {
    // Coordinates of one sample's two sets: (x of the one, x of the other) fills the square.
    sample_matches_pdf(
        "sobol pairs",
        &Square,
        |s| {
            let i = (s.next_bits() % 16) as u32;
            Some(DVec2::new(sobol_scrambled(s.next_bits(), i).x, sobol_scrambled(s.next_bits(), i).x))
        },
        |_| 1.0,
    );
}

/// Each point of a randomised set, and so any of them, is uniform in the square over seeds.
fn points_are_uniform(pattern: Pattern, n: u32) {
    let point = |s: &mut Sampler| {
        let i = (s.next_1d() * f64::from(n)) as u32;
        Some(pattern.points(n, s.next_bits()).point(i))
    };
    sample_matches_pdf(&format!("{} {n}", pattern.name()), &Square, point, |_| 1.0);
}

#[test]
fn randomised_sets_are_uniform() {
    for pattern in Pattern::ALL.into_iter().filter(|p| p.is_unbiased()) {
        for n in [1, 7, 16, 1000] {
            points_are_uniform(pattern, n);
        }
    }
}

#[test]
fn each_single_point_of_a_shifted_or_scrambled_sequence_is_uniform() {
    for (name, sequence) in [("r2", r2 as fn(u64, u32) -> DVec2), ("sobol", sobol_scrambled)] {
        for i in [0, 1, 2, 7, 1 << 20, u32::MAX] {
            let name = format!("{name} point {i}");
            sample_matches_pdf(&name, &Square, |s| Some(sequence(s.next_bits(), i)), |_| 1.0);
        }
    }
}

#[test]
fn randomised_sets_give_unbiased_means_and_centres_do_not() {
    // A quarter disc, area π/4; ten points, a number that suits none of them.
    let mean = |set: PointSet| set.iter().filter(|p| p.length_squared() < 1.0).count() as f64 / 10.0;
    for pattern in Pattern::ALL.into_iter().filter(|p| p.is_unbiased()) {
        let s = seed("quarter disc");
        let runs = (0..100_000).map(|run| mean(pattern.points(10, s + run)));
        mean_matches(pattern.name(), std::f64::consts::FRAC_PI_4, runs);
    }
    let centres = mean(Pattern::Centres.points(10, 0));
    assert!((centres - std::f64::consts::FRAC_PI_4).abs() > 0.01, "{centres}");
}

#[test]
fn r2_takes_exact_steps_from_any_index() {
    // p(i + 1) − p(i) = (1/φ₂, 1/φ₂²) mod 1, to the two truncations of 2⁻⁵³ and the rounding of the difference.
    let plastic = 1.324_717_957_244_746;
    let step = DVec2::new(1.0 / plastic, 1.0 / (plastic * plastic));
    for i in [0, 1, 1000, u32::MAX - 1] {
        let d = r2(9, i + 1) - r2(9, i) - step;
        let off = (d - d.round()).abs().max_element();
        // The step itself is computed with 3 roundings below.
        assert!(off <= 3.0 * lightbench::num::U + gamma(3), "{off}");
    }
}

#[test]
fn square_numbers_of_cells_make_the_square_grid() {
    for k in 1..40 {
        assert_eq!(Cells::equal_areas(k * k), Cells::grid(k, k));
    }
    let centres: Vec<_> = Pattern::Centres.points(4, 0).iter().collect();
    assert_eq!(centres, [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)].map(DVec2::from));
}

#[test]
fn empty_sets_have_no_points() {
    for pattern in Pattern::ALL {
        assert!(pattern.points(0, 1).is_empty());
        assert_eq!(pattern.points(0, 1).iter().count(), 0);
    }
}

#[test]
fn names_lead_back_to_patterns() {
    for pattern in Pattern::ALL {
        assert_eq!(Pattern::from_name(pattern.name()), Some(pattern));
    }
    assert_eq!(Pattern::from_name("halton"), None);
}

#[test]
fn the_last_point_of_a_cell_stays_inside() {
    // (9 + u)/10 with the largest u below 1 would round to 1.
    let last = Cells::grid(10, 10).cell(99).at(DVec2::splat(1.0 - lightbench::num::U));
    assert!(last.max_element() < 1.0);
    let inner = Cells::grid(10, 10).cell(0);
    assert!(inner.at(DVec2::splat(1.0 - lightbench::num::U)).x < Cells::grid(10, 10).cell(1).min.x);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn cells_have_equal_areas_and_tile_the_square(n in 1u32..2000) {
        let cells = Cells::equal_areas(n);
        let mut corner = DVec2::ZERO;
        for i in 0..n {
            let c = cells.cell(i);
            // Each cell starts where the last one ended, or at the left of the next row.
            prop_assert_eq!(c.min, corner);
            corner = if c.max.x == 1.0 { DVec2::new(0.0, c.max.y) } else { DVec2::new(c.max.x, c.min.y) };
            // Each edge is a rounded quotient; the sides are differences of two: absolute errors 2u, of sides
            // near 1/√n, so relative 2u·√n each, below 3 √n u with the row's unequal share.
            let size = c.max - c.min;
            let area = size.x * size.y * f64::from(n);
            prop_assert!((area - 1.0).abs() <= gamma(8) * f64::from(n).sqrt().max(1.0) * 2.0, "{}", area);
            // Nearly square: between 1/2 and 2, but for the third of 3 cells, which has a row for itself.
            prop_assert!(n == 3 || (0.5..=2.0).contains(&(size.x / size.y)), "{:?}", size);
        }
        prop_assert_eq!(corner, DVec2::new(0.0, 1.0));
    }

    #[test]
    fn jittered_points_lie_one_in_each_cell(n in 1u32..500, s: u64) {
        let cells = Cells::equal_areas(n);
        for (i, p) in Pattern::Jittered.points(n, s).iter().enumerate() {
            let c = cells.cell(i as u32);
            prop_assert!(p.cmpge(c.min).all() && p.cmplt(c.max).all(), "{} outside {:?}", p, c);
        }
    }

    #[test]
    fn points_lie_in_the_half_open_square(n in 1u32..100_000, s: u64, at in 0.0..1.0) {
        for pattern in Pattern::ALL {
            let p = pattern.points(n, s).point((at * f64::from(n)) as u32);
            prop_assert!(p.cmpge(DVec2::ZERO).all() && p.cmplt(DVec2::ONE).all(), "{:?}: {}", pattern, p);
        }
    }
}
