//! Integrals of functions of one variable, with an estimate of their error.
//!
//! Each interval is measured by two rules at once: Gauss's with 7 nodes, and Kronrod's, which adds 8 nodes
//! to them. Their difference says how good the interval already is; the worst interval is halved until
//! the whole is good enough. Kinks, edges and peaks get the nodes that they need, and nothing else does.

use arrayvec::ArrayVec;

/// An integral and an estimate of its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integral {
    pub value: f64,
    /// The estimate is on the safe side wherever the integrand has been seen at all; a peak between
    /// all nodes is not.
    pub error: f64,
}

impl Integral {
    /// A value known to rounding.
    pub fn exact(value: f64) -> Self {
        Integral { value, error: 16.0 * super::U * value.abs() }
    }
    /// The same of an integrand `factor` times as large.
    pub fn times(self, factor: f64) -> Self {
        Integral { value: self.value * factor, error: self.error * factor.abs() }
    }
}

/// Positive nodes of Kronrod's rule on [−1, 1], and the one in the middle; every second is Gauss's.
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_5,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_48,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_56,
    0.104_790_010_322_250_19,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_42,
    0.204_432_940_075_298_89,
    0.209_482_141_084_727_82,
];
const GAUSS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];
/// Intervals at most; a jump halves away half of its error each time, so that 60 leave 2⁻⁵⁰ of it.
const MOST: usize = 96;

#[derive(Clone, Copy)]
struct Panel {
    low: f64,
    high: f64,
    of: Integral,
}

/// `∫ f` over the intervals between neighbours of `breaks`, which stand in order.
///
/// Breaks belong where the integrand has a kink or a jump whose place is known: the rules are exact for
/// polynomials, and converge as fast as those where the integrand is smooth.
///
/// - Domain: finite breaks, at least two; equal ones enclose nothing.
/// - Accuracy: halves intervals until the errors sum to less than `tolerance`, or until rounding
///   (`50 u ∫|f|`) or the number of intervals puts an end to it; `error` says what has been reached.
/// - NaN goes through.
/// - Source: Piessens et al., *QUADPACK* (1983), QAG with the rules G7, K15.
pub fn integrate(mut f: impl FnMut(f64) -> f64, breaks: &[f64], tolerance: f64) -> Integral {
    let mut panels: ArrayVec<Panel, MOST> = ArrayVec::new();
    for ends in breaks.windows(2).filter(|w| w[1] > w[0]).take(MOST / 2) {
        panels.push(Panel { low: ends[0], high: ends[1], of: kronrod(&mut f, ends[0], ends[1]) });
    }
    loop {
        let error: f64 = panels.iter().map(|p| p.of.error).sum();
        let value: f64 = panels.iter().map(|p| p.of.value).sum();
        let worst = (0..panels.len()).max_by(|&i, &j| panels[i].of.error.total_cmp(&panels[j].of.error));
        let Some(worst) = worst.filter(|_| error > tolerance && panels.len() < MOST) else {
            return Integral { value, error };
        };
        let Panel { low, high, .. } = panels[worst];
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return Integral { value, error };
        }
        panels[worst] = Panel { low, high: middle, of: kronrod(&mut f, low, middle) };
        panels.push(Panel { low: middle, high, of: kronrod(&mut f, middle, high) });
    }
}

/// Both rules on one interval.
fn kronrod(f: &mut impl FnMut(f64) -> f64, low: f64, high: f64) -> Integral {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let center = f(middle);
    let (mut fine, mut coarse) = (KRONROD[7] * center, GAUSS[3] * center);
    let mut values = [center; 15];
    for i in 0..7 {
        let (a, b) = (f(middle - half * NODES[i]), f(middle + half * NODES[i]));
        fine += KRONROD[i] * (a + b);
        if i % 2 == 1 {
            coarse += GAUSS[i / 2] * (a + b);
        }
        (values[2 * i], values[2 * i + 1]) = (a, b);
    }
    // How far the integrand strays from its mean, and how large it is.
    let weight = |i: usize| if i == 14 { KRONROD[7] } else { KRONROD[i / 2] };
    let sum = |g: &dyn Fn(f64) -> f64| (0..15).map(|i| weight(i) * g(values[i])).sum::<f64>() * half;
    let strays = sum(&|v| (v - 0.5 * fine).abs());
    let size = sum(&|v: f64| v.abs());
    let difference = ((fine - coarse) * half).abs();
    // Kronrod's error is far smaller than the difference where that is small (QUADPACK's qk15).
    let error = match difference {
        d if d == 0.0 || strays == 0.0 => d,
        d => strays * (200.0 * d / strays).powf(1.5).min(1.0),
    };
    Integral { value: fine * half, error: error.max(50.0 * super::U * size) }
}
