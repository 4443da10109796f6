//! What a series says: its slope, and which points nothing beats.

use super::{Series, Z};

/// Slope of `log error` over `log parameter`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The slope: −½ for a mean of independent samples.
    pub value: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Points that entered.
    pub points: usize,
}

impl Slope {
    /// Is the slope `expected`, within [`Z`] standard deviations? NaN never agrees.
    pub fn agrees_with(&self, expected: f64) -> bool {
        (self.value - expected).abs() <= Z * self.sigma
    }
}

/// Least-squares slope of the series' errors, each a root mean square over `repetitions` runs.
///
/// ```text
/// slope = Σ (x − x̄) ln e / Σ (x − x̄)²,   x = ln parameter,    σ = σ(ln e) / √Σ (x − x̄)²
/// ```
///
/// Normal errors give `σ(ln rms) = 1/√(2 n)`; where the spread of a point says more, the root mean square of the
/// spreads is used instead. Points with an error that is 0 or not finite are left out.
///
/// - NaN: fewer than two such points, or all at one parameter, give a NaN slope, which agrees with nothing.
pub fn log_slope(series: &Series, repetitions: u32) -> Slope {
    let kept: Vec<(f64, f64, f64)> = series.points.iter().filter_map(|p| logs(p, repetitions)).collect();
    let n = kept.len() as f64;
    let mean = kept.iter().map(|k| k.0).sum::<f64>() / n;
    let sxx: f64 = kept.iter().map(|k| (k.0 - mean).powi(2)).sum();
    if kept.len() < 2 || sxx == 0.0 {
        return Slope { value: f64::NAN, sigma: f64::NAN, points: kept.len() };
    }
    let sxy: f64 = kept.iter().map(|k| (k.0 - mean) * k.1).sum();
    let variance = kept.iter().map(|k| k.2 * k.2).sum::<f64>() / n;
    Slope { value: sxy / sxx, sigma: (variance / sxx).sqrt(), points: kept.len() }
}

/// `(ln parameter, ln error, σ(ln error))` of a point that has all three.
fn logs(point: &super::Point, repetitions: u32) -> Option<(f64, f64, f64)> {
    let error = point.error?;
    let usable =
        point.parameter > 0.0 && point.parameter.is_finite() && error.mid > 0.0 && error.mid.is_finite();
    let normal = 1.0 / (2.0 * f64::from(repetitions.max(1))).sqrt();
    usable.then(|| {
        (point.parameter.ln(), error.mid.ln(), normal.max((error.high - error.low) / (2.0 * error.mid)))
    })
}

/// Indices of the points `(cost, error)` that no other beats in both, by growing cost.
///
/// Of equal points the first stays. Points that are not finite are left out.
pub fn pareto(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|&i| points[i].0.is_finite() && points[i].1.is_finite()).collect();
    order.sort_by(|&a, &b| {
        points[a].0.total_cmp(&points[b].0).then(points[a].1.total_cmp(&points[b].1)).then(a.cmp(&b))
    });
    let mut best = f64::INFINITY;
    order.retain(|&i| {
        let better = points[i].1 < best;
        if better {
            best = points[i].1;
        }
        better
    });
    order
}
