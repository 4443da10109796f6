//! Laws of sums, moments, quantiles and distribution functions.

use crate::support::nasty;
use lightbench::num::statistics::*;
use lightbench::num::sum::{Sum, pairwise};
use lightbench::num::{U, gamma};
use proptest::prelude::*;

/// Terms `k 2ᵉ` whose sum is known exactly as an integer.
fn exact_terms() -> impl Strategy<Value = (Vec<f64>, i128)> {
    let term = (-(1i64 << 52)..1 << 52, 0u32..60).prop_map(|(k, e)| i128::from(k) << e);
    // Every other list is followed by its own negatives in another order: its sum is tiny.
    (prop::collection::vec(term, 1..400), any::<bool>()).prop_map(|(mut terms, cancelling)| {
        if cancelling {
            let negatives: Vec<i128> = terms.iter().skip(1).rev().map(|t| -t).collect();
            terms.extend(negatives);
        }
        let floats = terms.iter().map(|&t| t as f64).collect();
        (floats, terms.iter().sum())
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn compensated_sums_keep_their_bound((terms, exact) in exact_terms()) {
        let n = terms.len() as u32;
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        let sum: Sum = terms.iter().copied().collect();
        // The exact sum may need more digits than f64 has: compare in integers; the floats are integers too.
        let error = (sum.value() as i128 - exact) as f64;
        // Proposition 4.5, and one rounding of the comparison's size.
        let bound = (U * exact as f64).abs() + gamma(n - 1).powi(2) * size * (1.0 + gamma(n));
        prop_assert!(error.abs() <= bound.max(U), "{} > {}", error, bound);
    }

    #[test]
    fn pairwise_sums_keep_their_bound((terms, exact) in exact_terms()) {
        let depth = (terms.len() as f64 / 64.0).log2().ceil().max(0.0) as u32;
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        let error = (pairwise(0..terms.len(), &|i| terms[i]) as i128 - exact) as f64;
        prop_assert!(error.abs() <= gamma(64 + depth) * size * (1.0 + gamma(400)));
    }

    #[test]
    fn joined_sums_are_sums((terms, exact) in exact_terms(), cut in 0.0..1.0f64) {
        let (low, high) = terms.split_at((cut * terms.len() as f64) as usize);
        let mut sum: Sum = low.iter().copied().collect();
        sum += high.iter().copied().collect::<Sum>();
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        let error = (sum.value() as i128 - exact) as f64;
        let bound = (U * exact as f64).abs() + gamma(terms.len() as u32 + 1).powi(2) * size * (1.0 + gamma(800));
        prop_assert!(error.abs() <= bound.max(U));
    }

    #[test]
    fn merged_moments_are_moments_of_all(
        a in prop::collection::vec(-1e3..1e3f64, 0..50),
        b in prop::collection::vec(-1e3..1e3f64, 0..50),
    ) {
        let mut merged: Moments = a.iter().copied().collect();
        merged.merge(&b.iter().copied().collect());
        let all: Vec<f64> = a.iter().chain(&b).copied().collect();
        let n = all.len() as f64;
        prop_assert_eq!(merged.count(), all.len() as u64);
        let Some(mean) = merged.mean() else { return Ok(()) };
        // 100 updates of 3 roundings each, of numbers up to 10³; squares up to 4·10⁶ in the variance.
        prop_assert!((mean - pairwise(0..all.len(), &|i| all[i]) / n).abs() <= gamma(400) * 1e3);
        let Some(variance) = merged.variance() else { return Ok(()) };
        let squares: Vec<f64> = all.iter().map(|x| (x - mean).powi(2)).collect();
        prop_assert!((variance - pairwise(0..squares.len(), &|i| squares[i]) / (n - 1.0)).abs() <= gamma(800) * 4e6);
        prop_assert!(variance >= 0.0);
    }

    #[test]
    fn quantiles_grow_and_stay_between_the_extremes(
        samples in prop::collection::vec(nasty::number(), 1..40), p in 0.0..=1.0f64, q in 0.0..=1.0f64,
    ) {
        let least = samples.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let at = |p| quantile(&samples, p).unwrap();
        prop_assert_eq!(at(0.0), least);
        prop_assert_eq!(at(1.0), greatest);
        let (low, high) = (at(p.min(q)), at(p.max(q)));
        // Interpolation rounds three times.
        let slack = gamma(4) * least.abs().max(greatest.abs());
        prop_assert!(least - slack <= low && low <= high + slack && high <= greatest + slack);
        prop_assert_eq!(median(&samples), quartiles(&samples).map(|q| q[1]));
    }

    #[test]
    fn normal_quantile_inverts_the_distribution(e in -300.0..-0.302f64) {
        let p = 10f64.powf(e);
        let z = normal_quantile(p);
        // d ln Φ = (|z| + 1/|z|) dz at most (Mills): 1e-15 |z| in z, and Φ's own error.
        let slack = 1e-15 * (z * z).max(1.0) * 2.0 + z * z * U + 20.0 * U;
        prop_assert!((normal_cdf(z) / p - 1.0).abs() <= slack, "{} {}", z, normal_cdf(z) / p - 1.0);
    }

    #[test]
    fn tails_add_up_to_one(a in 0.1..200.0f64, x in 0.0..400.0f64) {
        // One of the two is computed as one minus the other.
        prop_assert!((gamma_p(a, x) + gamma_q(a, x) - 1.0).abs() <= gamma(1));
        prop_assert!((0.0..=1.0).contains(&gamma_p(a, x)));
    }

    #[test]
    fn beta_is_symmetric(a in 0.1..50.0f64, b in 0.1..50.0f64, x in 0.0..=1.0f64) {
        let total = beta_inc(a, b, x, 1.0 - x) + beta_inc(b, a, 1.0 - x, x);
        prop_assert!((total - 1.0).abs() <= gamma(2));
    }
}

#[test]
fn sums_at_the_edges_of_their_domain() {
    assert_eq!(pairwise(0..0, &|_| 0.0f64).to_bits(), 0.0f64.to_bits());
    assert_eq!(Sum::ZERO.value(), 0.0);
    let of = |terms: &[f64]| terms.iter().copied().collect::<Sum>().value();
    assert_eq!(of(&[1.0, 1e100, 1.0, -1e100]), 2.0); // Neumaier's example; Kahan's own sum gives 0
    assert_eq!(of(&[f64::INFINITY, 1.0]), f64::INFINITY);
    assert_eq!(of(&[f64::MAX, f64::MAX]), f64::INFINITY);
    assert!(of(&[f64::INFINITY, f64::NEG_INFINITY]).is_nan());
    assert!(of(&[f64::NAN, 1.0]).is_nan());
}

#[test]
fn statistics_of_nothing_are_none() {
    assert_eq!(median(&[]), None);
    assert_eq!(quartiles(&[]), None);
    let one: Moments = [3.0].into_iter().collect();
    assert_eq!((one.mean(), one.variance(), one.standard_error()), (Some(3.0), None, None));
    assert_eq!(Moments::default().mean(), None);
}

#[test]
fn quantiles_at_the_edges_of_their_domain() {
    assert_eq!(quartiles(&[4.0, 1.0, 3.0, 2.0, 5.0]), Some([2.0, 3.0, 4.0]));
    assert_eq!(median(&[1.0, 2.0]), Some(1.5));
    assert_eq!(median(&[f64::INFINITY; 2]), Some(f64::INFINITY));
    assert_eq!(median(&[-f64::MAX, f64::MAX]), Some(0.0));
    assert!(median(&[1.0, f64::NAN, 2.0]).unwrap().is_nan());
    assert!(median(&[1.0, -f64::NAN, 2.0]).unwrap().is_nan());
}

#[test]
fn distributions_at_the_edges_of_their_domain() {
    assert_eq!((erf(0.0), erf(f64::INFINITY), erf(f64::NEG_INFINITY)), (0.0, 1.0, -1.0));
    assert_eq!((erfc(0.0), erfc(f64::INFINITY), erfc(f64::NEG_INFINITY)), (1.0, 0.0, 2.0));
    assert_eq!(erfc(1e300), 0.0);
    assert_eq!((normal_quantile(0.0), normal_quantile(1.0)), (f64::NEG_INFINITY, f64::INFINITY));
    assert!(normal_quantile(f64::from_bits(1)).is_finite());
    assert_eq!((gamma_p(2.0, 0.0), gamma_q(2.0, 0.0)), (0.0, 1.0));
    assert_eq!((gamma_p(2.0, f64::INFINITY), gamma_q(2.0, f64::INFINITY)), (1.0, 0.0));
    assert_eq!(chi2_survival(0.0, 5.0), 1.0);
    assert_eq!((beta_inc(2.0, 3.0, 0.0, 1.0), beta_inc(2.0, 3.0, 1.0, 0.0)), (0.0, 1.0));
    assert_eq!(student_t_two_sided(0.0, 5.0), 1.0);
    assert_eq!(student_t_two_sided(f64::INFINITY, 5.0), 0.0);
    assert_eq!(student_t_two_sided(1e200, 5.0), 0.0);
    assert_eq!(student_t_cdf(0.0, 5.0), 0.5);
    assert_eq!((ln_gamma(0.0), ln_gamma(f64::INFINITY)), (f64::INFINITY, f64::INFINITY));
    for nan in [
        erf(f64::NAN),
        erfc(f64::NAN),
        normal_quantile(f64::NAN),
        gamma_p(f64::NAN, 1.0),
        gamma_q(1.0, f64::NAN),
    ] {
        assert!(nan.is_nan());
    }
    assert!(student_t_two_sided(f64::NAN, 5.0).is_nan());
}

#[test]
fn one_test_keeps_its_significance_and_many_share_it() {
    assert!((sidak(1e-6, 1) / 1e-6 - 1.0).abs() <= gamma(4));
    // (1 − α₁)ᵐ = 1 − α.
    let each = sidak(0.05, 200);
    assert!(((1.0 - each).powi(200) - 0.95).abs() <= gamma(400));
}
