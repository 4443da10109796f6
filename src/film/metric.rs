//! How far one picture is from another.
//!
//! Errors are measured on linear radiance, `d = a − b` with `b` the reference. What an eye would say is
//! asked of *display values*: radiance clamped to `[0,1]` and sent through the sRGB curve.

use super::{Image, ssim};
use crate::color::{luminance, srgb_encode};
use crate::num::sum::pairwise;

/// The distance of a picture from its reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// Root of the mean squared error over pixels and channels [unit of the pictures].
    ///
    /// ```text
    /// rmse = √( mean d² )
    /// ```
    pub rmse: f64,
    /// Mean error over pixels and channels: the bias [unit of the pictures].
    ///
    /// ```text
    /// mean d
    /// ```
    pub signed_mean: f64,
    /// Mean squared error relative to the reference \[1\].
    ///
    /// ```text
    /// mean( d² / (b² + δ) ),    δ = (0.01 Ȳ)²,    Ȳ = mean of Y(|b|)
    /// ```
    ///
    /// δ keeps dark pixels from dominating. It is tied to the mean luminance of the reference, so that
    /// the number is the same for pictures in W and in mW. Exposed so that Ȳ shows as middle grey
    /// (0.18), 0.01 Ȳ is level 6 of 255: what a display shows as black.
    /// 0 for identical pictures, ∞ if only the reference is black.
    pub relative_mse: f64,
    /// Peak signal-to-noise ratio of the display values \[dB\], peak 1; ∞ if they are identical.
    ///
    /// ```text
    /// psnr = −10 log₁₀( mean (s_a − s_b)² ),    s = srgb(clamp(x, 0, 1))
    /// ```
    pub psnr: f64,
    /// Structural similarity of the display luminances, in [−1,1]: see [`ssim::ssim`].
    pub ssim: f64,
    /// The error of largest magnitude, with its sign [unit of the pictures].
    pub max_error: f64,
    /// Where that is: the first such place, row by row.
    pub max_at: Place,
    /// Pixels at which one picture is NaN or infinite. NaN spoils every number above, and
    /// ∞ those of the error (a display shows it as white): nothing is left out in silence.
    pub not_finite: usize,
}

/// One channel of one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    pub x: usize,
    pub y: usize,
    /// 0 red, 1 green, 2 blue.
    pub channel: usize,
}

/// Compares `a` with the reference `b`: each number is defined at its field of [`Comparison`].
///
/// - Domain: two pictures of one size, with at least one pixel.
/// - Accuracy: means by [`pairwise`], `num::gamma(64 + ⌈log₂(n/64)⌉)` relative to the mean of
///   magnitudes. Squares are taken of scaled numbers: neither 1e-200 nor 1e200 is lost.
/// - NaN goes through, and is counted.
/// - Source: SSIM by Wang, Bovik, Sheikh & Simoncelli (2004); relative MSE with a floor as in
///   Rousselle, Knaus & Zwicker (2011), whose floor is an absolute constant.
pub fn compare(a: &Image, b: &Image) -> Comparison {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()), "pictures of one size");
    assert!(!a.pixels().is_empty(), "pictures with pixels");
    let (max_error, max_at) = largest_error(a, b);
    let finite = |(p, q): &(&crate::color::Rgb, &crate::color::Rgb)| p.is_finite() && q.is_finite();
    Comparison {
        rmse: rmse(a, b, max_error.abs()),
        signed_mean: mean(a, &|i| (a.pixels()[i] - b.pixels()[i]).element_sum()) / 3.0,
        relative_mse: relative_mse(a, b),
        psnr: psnr(a, b),
        ssim: ssim::ssim(a, b),
        max_error,
        max_at,
        not_finite: a.pixels().len() - a.pixels().iter().zip(b.pixels()).filter(finite).count(),
    }
}

/// Mean over pixels of a number made from each one's index.
fn mean(image: &Image, number: &(impl Fn(usize) -> f64 + Sync)) -> f64 {
    pairwise(0..image.pixels().len(), number) / image.pixels().len() as f64
}

/// `m √(mean (d/m)²)` with the largest error `m`, so that squares neither overflow nor vanish.
fn rmse(a: &Image, b: &Image, largest: f64) -> f64 {
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let square = |i: usize| ((a.pixels()[i] - b.pixels()[i]) / largest).length_squared();
    largest * (mean(a, &square) / 3.0).sqrt()
}

fn relative_mse(a: &Image, b: &Image) -> f64 {
    let floor = 0.01 * mean(b, &|i| luminance(b.pixels()[i].abs()));
    let term = |i: usize| {
        let (d, reference) = (a.pixels()[i] - b.pixels()[i], b.pixels()[i]);
        let ratio = |channel: usize| match d[channel] {
            0.0 => 0.0,
            d => d / reference[channel].hypot(floor),
        };
        (0..3).map(|c| ratio(c) * ratio(c)).sum::<f64>()
    };
    mean(a, &term) / 3.0
}

fn psnr(a: &Image, b: &Image) -> f64 {
    let display = |p: crate::color::Rgb| p.map(|x| srgb_encode(x.clamp(0.0, 1.0)));
    let square = |i: usize| (display(a.pixels()[i]) - display(b.pixels()[i])).length_squared();
    -10.0 * (mean(a, &square) / 3.0).log10()
}

/// The error of largest magnitude, or the first NaN, and its place.
fn largest_error(a: &Image, b: &Image) -> (f64, Place) {
    let (mut largest, mut at) = (0.0_f64, Place::default());
    for (i, (p, q)) in a.pixels().iter().zip(b.pixels()).enumerate() {
        for channel in 0..3 {
            let error = p[channel] - q[channel];
            if error.is_nan() || error.abs() > largest.abs() {
                let (x, y) = a.place(i);
                (largest, at) = (error, Place { x, y, channel });
            }
            if error.is_nan() {
                return (largest, at);
            }
        }
    }
    (largest, at)
}
