//! Tone mapping: from unbounded radiance to the `[0,1]` of a display, once, at the end.

use super::Image;
use crate::color::Rgb;

/// How values out of `[0,1]` come into range. Below 0 every map gives 0, NaN stays NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ToneMap {
    /// Whatever exceeds 1 becomes 1: values in range are kept, highlights lose their hue [C §1.8.2].
    #[default]
    Clamp,
    /// Division by the one largest value of all pixels and channels, if that exceeds 1: ratios
    /// and hues are kept, and one highlight darkens the whole picture [C §1.8.2, put right].
    DivideByMaximum,
    /// The curve [`filmic`] on each channel: highlights bend instead of breaking off.
    Filmic,
}

impl ToneMap {
    /// Every map, in the order of the lesson.
    pub const ALL: [ToneMap; 3] = [ToneMap::Clamp, ToneMap::DivideByMaximum, ToneMap::Filmic];

    /// The name on a command line and in metadata.
    pub fn name(self) -> &'static str {
        match self {
            ToneMap::Clamp => "clamp",
            ToneMap::DivideByMaximum => "divide-by-maximum",
            ToneMap::Filmic => "filmic",
        }
    }

    /// The mapped picture, linear, each channel in `[0,1]` or NaN; +∞ becomes 1.
    pub fn apply(self, image: &Image) -> Image {
        match self {
            ToneMap::Clamp => image.map(clamp),
            ToneMap::DivideByMaximum => {
                // A correctly rounded quotient of x ≤ m never exceeds 1.
                let divisor = largest_finite(image).max(1.0);
                image.map(|p| clamp(p / divisor))
            }
            ToneMap::Filmic => image.map(|p| p.map(filmic)),
        }
    }
}

/// Each channel limited to [0,1]; NaN stays NaN.
fn clamp(rgb: Rgb) -> Rgb {
    rgb.map(|x| x.clamp(0.0, 1.0))
}

/// The filmic curve: a linear channel to `[0,1]`.
///
/// ```text
/// f(x) = x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14),    at most 1
/// ```
///
/// - Domain: all numbers. `f = 0` for `x ≤ 0`; it reaches 1 at 7.2417, and stays there. It grows
///   monotonely in between, as `f' ∝ 1.408 x² + 0.7028 x + 0.0042 > 0`.
/// - Accuracy: `num::gamma(9)`, relative; all terms are positive.
/// - NaN in, NaN out.
/// - Source: Narkowicz, *ACES Filmic Tone Mapping Curve* (2016), a fit to the ACES reference
///   rendering; to match its exposure as well, multiply by 0.6 first.
pub fn filmic(x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    // Beyond f = 1, and before the squares of both polynomials overflow to ∞/∞.
    if x >= 8.0 {
        return 1.0;
    }
    let f = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    if f > 1.0 { 1.0 } else { f }
}

/// Where [`shoulder`] begins to bend.
pub const KNEE: f64 = 0.7;

/// The shoulder: a linear channel to [0,1), unchanged up to [`KNEE`], then bent so that highlights roll off.
///
/// ```text
/// f(x) = x,                                        x ≤ k = 0.7
/// f(x) = k + (1 − k)(1 − exp(−(x − k)/(1 − k))),    x > k
/// ```
///
/// Slope 1 on both sides of the knee, so that no edge is drawn there; what lies below keeps its ratios and hues.
///
/// - Domain: all numbers. `f ≤ 0` for `x ≤ 0`; `f(0.8) = 0.785`, `f(1) = 0.890`, `f(2) = 0.996`; `f(+∞) = 1`.
/// - Accuracy: `num::gamma(4)`, relative to 1: the exponential is at most 1 and damps its argument's error.
/// - NaN in, NaN out.
pub fn shoulder(x: f64) -> f64 {
    if x > KNEE { KNEE - (1.0 - KNEE) * (-(x - KNEE) / (1.0 - KNEE)).exp_m1() } else { x }
}

/// Division of each channel by its own maximum, as [C §1.8.2 D] prints it: **wrong**, because the
/// three divisors differ and shift every hue; a grey object under a red lamp turns out grey.
/// A channel without positive values stays as it is.
pub fn divide_by_channel_maxima_as_printed(image: &Image) -> Image {
    let start = Rgb::splat(f64::NEG_INFINITY);
    let maxima = image.pixels().iter().fold(start, |m, p| m.max(finite_or_lowest(*p)));
    let divisors = maxima.map(|m| if m > 0.0 { m } else { 1.0 });
    image.map(|p| p / divisors)
}

/// The largest finite value of all pixels and channels; −∞ if there is none.
fn largest_finite(image: &Image) -> f64 {
    image.pixels().iter().fold(f64::NEG_INFINITY, |m, p| m.max(finite_or_lowest(*p).max_element()))
}

fn finite_or_lowest(rgb: Rgb) -> Rgb {
    rgb.map(|x| if x.is_finite() { x } else { f64::NEG_INFINITY })
}
