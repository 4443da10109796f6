//! Does an estimator have the mean that it should? Student's t-test.

use super::significance;
use lightbench::num::gamma;
use lightbench::num::statistics::{Moments, student_t_two_sided};

/// The law: independent `samples` have mean `truth`.
///
/// To test a variance against a closed form, give the squared deviations from the *known* mean.
///
/// The t-distribution assumes that the mean of all samples is nearly normal 6 standard deviations out. With skewness `g`,
/// the tail is off by the factor `exp(g z³/(6√n))` (Cramér 1938): take `n ≥ (40 g)²` samples, which keeps it
/// below `e`. A value that appears with probability `q` has `g ≈ 1/√q`: it should appear 1600 times.
pub fn mean_matches(name: &str, truth: f64, samples: impl IntoIterator<Item = f64>) {
    if let Err(why) = check_mean(truth, samples) {
        panic!("{name}: {why}");
    }
}

/// What [`mean_matches`] asserts, as a value: the p-value of an estimator that passes.
pub fn check_mean(truth: f64, samples: impl IntoIterator<Item = f64>) -> Result<f64, String> {
    let moments: Moments = samples.into_iter().collect();
    let (Some(mean), Some(error)) = (moments.mean(), moments.standard_error()) else {
        return Err("fewer than two samples".to_string());
    };
    // An estimator without variance still rounds: 16 operations, or the accumulation of the mean.
    if (mean - truth).abs() <= gamma(16) * truth.abs() {
        return Ok(1.0);
    }
    let t = (mean - truth) / error;
    let p_value = student_t_two_sided(t, (moments.count() - 1) as f64);
    if p_value >= significance() {
        Ok(p_value)
    } else {
        Err(format!("mean {mean} ± {error:.2e} should be {truth}: t = {t:.2}, p = {p_value:.1e}"))
    }
}
