//! A picture of where, and to which side, one picture errs.

use super::Image;
use crate::color::{Rgb, srgb_decode};

/// The signed error of a picture, drawn around white.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorPicture {
    /// Blue where the picture is too dark, red where it is too bright, white where it is right.
    pub image: Image,
    /// The error of full blue (−) and full red (+) [unit of the pictures]; 0 if there is no error.
    pub full_scale: f64,
    /// Pixels beyond full scale, drawn in its colour.
    pub saturated: usize,
}

/// Share of the pixels whose error is within full scale. Tuned: at 1 one firefly bleaches all the rest, at
/// 0.9 a tenth of every picture is saturated.
const WITHIN_SCALE: f64 = 0.99;

/// Draws `a − b`, in each pixel that of the channel with the largest magnitude, by [`diverging`].
///
/// Full scale is the 99 % quantile of the magnitudes, or the largest one if that quantile is 0. Pixels
/// without a finite error are black.
pub fn signed_error(a: &Image, b: &Image) -> ErrorPicture {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()), "pictures of one size");
    let errors: Vec<f64> = a.pixels().iter().zip(b.pixels()).map(|(p, q)| leading(*p - *q)).collect();
    let full_scale = full_scale(&errors);
    let colour = |error: f64| match error {
        e if !e.is_finite() => Rgb::ZERO,
        0.0 => diverging(0.0),
        e => diverging(e / full_scale),
    };
    let pixels = errors.iter().map(|e| colour(*e)).collect();
    let saturated = errors.iter().filter(|e| e.is_finite() && e.abs() > full_scale).count();
    ErrorPicture { image: Image::from_pixels(a.width(), a.height(), pixels), full_scale, saturated }
}

/// The channel of largest magnitude, with its sign; NaN if one is NaN.
fn leading(d: Rgb) -> f64 {
    let larger = |a: f64, b: f64| if b.is_nan() || b.abs() > a.abs() { b } else { a };
    larger(larger(d.x, d.y), d.z)
}

fn full_scale(errors: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = errors.iter().map(|e| e.abs()).filter(|e| e.is_finite()).collect();
    if sizes.is_empty() {
        return 0.0;
    }
    sizes.sort_unstable_by(f64::total_cmp);
    let rank = (WITHIN_SCALE * sizes.len() as f64).ceil() as usize;
    let largest = sizes[sizes.len() - 1];
    match sizes[rank.clamp(1, sizes.len()) - 1] {
        0.0 => largest,
        quantile => quantile,
    }
}

/// A linear colour for `t` in [−1,1]: from blue over white to red, safe for colour-blind eyes.
///
/// Straight lines between five stored colours, `#0571b0 #92c5de #ffffff #f4a582 #ca0020`; lightness
/// falls on both sides of white. Beyond the ends the end colours stay; NaN is black.
///
/// - Source: ColorBrewer 2.0, RdBu (Brewer & Harrower), with pure white in the middle.
pub fn diverging(t: f64) -> Rgb {
    const STOPS: [[f64; 3]; 5] = [
        [5.0, 113.0, 176.0],
        [146.0, 197.0, 222.0],
        [255.0, 255.0, 255.0],
        [244.0, 165.0, 130.0],
        [202.0, 0.0, 32.0],
    ];
    if t.is_nan() {
        return Rgb::ZERO;
    }
    let position = (t.clamp(-1.0, 1.0) + 1.0) * 2.0;
    let low = (position as usize).min(3);
    let share = position - low as f64;
    let stored = Rgb::from(STOPS[low]) * (1.0 - share) + Rgb::from(STOPS[low + 1]) * share;
    (stored / 255.0).map(srgb_decode)
}
