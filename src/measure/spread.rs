//! A number with its scatter.

/// A central value and the interval that its repetitions span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Median, or root mean square.
    pub mid: f64,
    /// Lower end: first quartile, or the root mean square less its standard error.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// How many repetitions stand behind it.
    pub runs: usize,
}

impl Spread {
    /// A value that was not repeated, or does not scatter.
    pub fn exact(value: f64) -> Self {
        Spread { mid: value, low: value, high: value, runs: 1 }
    }

    /// Median with first and third quartile (linear between order statistics). NaN values are left out; `None` if
    /// nothing is left.
    ///
    /// - Source: Hyndman & Fan, *Sample quantiles in statistical packages* (1996), type 7.
    pub fn median(values: &[f64]) -> Option<Self> {
        let mut sorted: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
        if sorted.is_empty() {
            return None;
        }
        sorted.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let position = share * (sorted.len() - 1) as f64;
            let (below, above) = (sorted[position.floor() as usize], sorted[position.ceil() as usize]);
            let fraction = position.fract();
            if fraction == 0.0 { below } else { below + (above - below) * fraction }
        };
        Some(Spread { mid: at(0.5), low: at(0.25), high: at(0.75), runs: sorted.len() })
    }

    /// Root mean square of errors, with its standard error on either side. NaN values are left out.
    ///
    /// ```text
    /// rms = √(Σ e²/n),    σ(rms) ≈ s(e²) / (2 rms √n)
    /// ```
    ///
    /// For normal errors `σ(rms) = rms / √(2n)`. The errors are scaled by the largest first, so that neither
    /// 10^−200 nor 10^200 leaves the range when squared.
    ///
    /// - Source: the delta method on the mean of squares.
    pub fn rms(errors: &[f64]) -> Option<Self> {
        let kept: Vec<f64> = errors.iter().map(|e| e.abs()).filter(|e| !e.is_nan()).collect();
        let scale = kept.iter().copied().fold(0.0, f64::max);
        if kept.is_empty() {
            return None;
        }
        if scale == 0.0 || scale.is_infinite() {
            return Some(Spread { runs: kept.len(), ..Spread::exact(scale) });
        }
        let n = kept.len() as f64;
        let squares = kept.iter().map(|e| (e / scale).powi(2));
        let mean = squares.clone().sum::<f64>() / n;
        let variance =
            if n > 1.0 { squares.map(|s| (s - mean).powi(2)).sum::<f64>() / (n - 1.0) } else { 0.0 };
        let rms = mean.sqrt();
        let sigma = (variance / n).sqrt() / (2.0 * rms);
        let low = (rms - sigma).max(0.0);
        Some(Spread { mid: rms * scale, low: low * scale, high: (rms + sigma) * scale, runs: kept.len() })
    }

    /// The same spread of a quantity `factor` times as large, `factor > 0`.
    pub fn times(&self, factor: f64) -> Self {
        Spread { mid: self.mid * factor, low: self.low * factor, high: self.high * factor, runs: self.runs }
    }
}
