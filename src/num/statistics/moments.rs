//! Means, variances and quantiles of samples.

/// Number, mean and variance of a sample, in one pass (Welford).
///
/// ```text
/// n += 1,    δ = x − mean,    mean += δ/n,    m₂ += δ (x − mean)
/// ```
///
/// - Domain: finite samples whose squares do not overflow.
/// - Accuracy: relative error of the variance about `n κ u`, `κ = √(1 + mean²/variance)`; the textbook `Σx² − (Σx)²/n`
///   loses `n κ² u` (Chan, Golub & LeVeque 1983).
/// - Source: Welford (1962); merging: Chan, Golub & LeVeque (1979).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    n: u64,
    mean: f64,
    m2: f64,
}

impl Moments {
    /// Takes in one sample.
    #[inline]
    pub fn add(&mut self, x: f64) {
        self.n += 1;
        let delta = x - self.mean;
        self.mean += delta / self.n as f64;
        self.m2 += delta * (x - self.mean);
    }

    /// Takes in another sample's moments; in a fixed order of merges the result is reproducible.
    pub fn merge(&mut self, other: &Moments) {
        if other.n == 0 {
            return;
        }
        let n = self.n + other.n;
        let share = other.n as f64 / n as f64;
        let delta = other.mean - self.mean;
        self.mean += delta * share;
        self.m2 += other.m2 + delta * delta * self.n as f64 * share;
        self.n = n;
    }

    /// How many samples came in.
    pub fn count(&self) -> u64 {
        self.n
    }

    /// The mean, or `None` of nothing.
    pub fn mean(&self) -> Option<f64> {
        (self.n > 0).then_some(self.mean)
    }

    /// The unbiased variance `m₂ / (n − 1)`, or `None` of fewer than two.
    pub fn variance(&self) -> Option<f64> {
        (self.n > 1).then(|| self.m2 / (self.n - 1) as f64)
    }

    /// The standard error of the mean, `√(variance / n)`, or `None` of fewer than two.
    pub fn standard_error(&self) -> Option<f64> {
        self.variance().map(|v| (v / self.n as f64).sqrt())
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(samples: I) -> Self {
        let mut moments = Moments::default();
        for x in samples {
            moments.add(x);
        }
        moments
    }
}

/// The `p`-quantile of a sample: between its order statistics, linearly.
///
/// ```text
/// h = (n − 1) p,    q = x₍⌊h⌋₎ + (h − ⌊h⌋) (x₍⌊h⌋₊₁₎ − x₍⌊h⌋₎)
/// ```
///
/// - Domain: `0 ≤ p ≤ 1`; 0 gives the least, 1 the greatest. `None` of nothing.
/// - Accuracy: `γ₃` of the larger neighbour.
/// - NaN: a sample that holds NaN gives NaN.
/// - Source: Hyndman & Fan (1996), type 7.
pub fn quantile(samples: &[f64], p: f64) -> Option<f64> {
    sorted(samples).map(|s| quantile_of_sorted(&s, p))
}

/// The middle of a sample (the mean of the two middle ones of an even number); see [`quantile`].
pub fn median(samples: &[f64]) -> Option<f64> {
    quantile(samples, 0.5)
}

/// The quantiles at 1/4, 1/2 and 3/4; see [`quantile`].
pub fn quartiles(samples: &[f64]) -> Option<[f64; 3]> {
    sorted(samples).map(|s| [0.25, 0.5, 0.75].map(|p| quantile_of_sorted(&s, p)))
}

fn sorted(samples: &[f64]) -> Option<Vec<f64>> {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    (!sorted.is_empty()).then_some(sorted)
}

fn quantile_of_sorted(sorted: &[f64], p: f64) -> f64 {
    debug_assert!((0.0..=1.0).contains(&p), "quantile at {p}");
    // The total order puts negative NaN first and positive NaN last.
    let last = sorted.len() - 1;
    if sorted[0].is_nan() || sorted[last].is_nan() {
        return f64::NAN;
    }
    let place = last as f64 * p.clamp(0.0, 1.0);
    let low = place as usize;
    let (a, b) = (sorted[low], sorted[(low + 1).min(last)]);
    let t = place - low as f64;
    // Weights instead of a difference: a and b of ±10³⁰⁸ do not overflow, and equal infinities are no NaN.
    if t == 0.0 || a == b { a } else { a * (1.0 - t) + b * t }
}
