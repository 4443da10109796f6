//! Colour maps: perceptual for magnitude, diverging for signed values.

use super::ink::Srgb;
use crate::color::srgb_encode;
use crate::film::error_picture;

/// Viridis at `t` in `[0,1]`: dark blue to yellow, of evenly growing lightness.
///
/// A polynomial of degree 6 per channel, fitted to the table; at most about 0.01 off.
///
/// - NaN: grey.
/// - Source: van der Walt & Smith, matplotlib (2015), public domain table; fit by Zucker (2018), public domain.
pub fn viridis(t: f64) -> Srgb {
    const C: [[f64; 3]; 7] = [
        [0.2777273272234177, 0.005407344544966578, 0.3340998053353061],
        [0.1050930431085774, 1.404613529898575, 1.384590162594685],
        [-0.3308618287255563, 0.214847559468213, 0.09509516302823659],
        [-4.634230498983486, -5.799100973351585, -19.33244095627987],
        [6.228269936347081, 14.17993336680509, 56.69055260068105],
        [4.776384997670288, -13.74514537774601, -65.35303263337234],
        [-5.435455855934631, 4.645852612178535, 26.3124352495832],
    ];
    if t.is_nan() {
        return MISSING;
    }
    let t = t.clamp(0.0, 1.0);
    let channel = |i: usize| C.iter().rev().fold(0.0, |sum, c| sum * t + c[i]);
    [level(channel(0)), level(channel(1)), level(channel(2))]
}

/// Blue over white to red, as the error pictures of [`error_picture`] have it: `t` in [−1,1], white at 0.
///
/// - NaN: grey.
pub fn diverging(t: f64) -> Srgb {
    if t.is_nan() { MISSING } else { error_picture::diverging(t).to_array().map(|x| level(srgb_encode(x))) }
}

/// The colour of cells without a value.
pub const MISSING: Srgb = [196, 200, 206];

fn level(x: f64) -> u8 {
    (x.clamp(0.0, 1.0) * 255.0).round() as u8
}
