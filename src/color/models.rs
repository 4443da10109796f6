//! Other coordinates in the RGB cube: inks, and the painter's hue, tint and shade [C §1.7.5 E–F].
//!
//! CMY counts from white what RGB counts from black. HSV and HLS see the cube along its grey diagonal, where its
//! outline is a hexagon: hue runs round it, red, yellow, green, cyan, blue, magenta.
//!
//! ```text
//! max, min: largest and smallest channel;  c = max − min
//! hue = (g − b)/c,  2 + (b − r)/c  or  4 + (r − g)/c   where red, green or blue is the largest
//! HSV: S = c/max,  V = max
//! HLS: L = (max + min)/2,  S = c/(max + min) below L = ½,  c/((1 − max) + (1 − min)) above
//! ```

use super::Rgb;
use glam::{DVec3, dvec3};

/// Sides of the hexagon of hues; [`Hsv::hue`] and [`Hls::hue`] count them.
pub const SIDES: f64 = 6.0;

/// A colour as a painter names it: a pure hue, thinned with white and darkened with black.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hsv {
    /// Place on the hexagon, in its sides, [0,6): 0 red, 1 yellow, 2 green, 3 cyan, 4 blue, 5 magenta; 0 for greys.
    pub hue: f64,
    /// 0 grey, 1 without any white.
    pub saturation: f64,
    /// The largest channel.
    pub value: f64,
}

/// The same with black and white as equal ends: full hues lie half way between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hls {
    /// As [`Hsv::hue`].
    pub hue: f64,
    /// Mean of the largest and the smallest channel: 0 black, 1 white.
    pub lightness: f64,
    /// Chroma as a share of the most that this lightness allows.
    pub saturation: f64,
}

/// A hue in degrees, [0,360).
pub fn degrees(hue: f64) -> f64 {
    60.0 * hue
}

/// Shares of cyan, magenta and yellow that leave a colour of white light.
///
/// - Domain: `[0,1]³`; finite numbers outside stay finite.
/// - Accuracy: one rounding.
/// - NaN goes through.
/// - Source: [C §1.7.5 F].
pub fn cmy_from_rgb(rgb: Rgb) -> DVec3 {
    1.0 - rgb
}

/// The colour that inks leave of white light: the inverse of [`cmy_from_rgb`], and the same formula.
pub fn rgb_from_cmy(cmy: DVec3) -> Rgb {
    1.0 - cmy
}

/// The colour across the cube's centre: what it lacks to white.
///
/// - Accuracy: one rounding; twice gives the colour back to one rounding of 1.
/// - Source: [C §1.7.5 F].
pub fn complement(rgb: Rgb) -> Rgb {
    1.0 - rgb
}

/// Place on the hexagon of hues \[sides\], in [0,6); `None` for greys, which have none.
///
/// - Domain: finite. A hue just under 6 stays under 6: a red with a breath of blue is no yellowish red.
/// - Accuracy: `γ₄` for a channel difference of exact inputs; but inputs that are known to `e` leave the hue
///   uncertain by about `e / (max − min)` sides, without bound near grey.
/// - NaN: `None`.
/// - Source: Smith, *Color gamut transform pairs* (SIGGRAPH 1978).
pub fn hue(rgb: Rgb) -> Option<f64> {
    let (max, min) = extent(rgb);
    // Differences of huge channels of both signs overflow, those of their halves do not.
    let part = if (max - min).is_finite() { 1.0 } else { 0.5 };
    let (rgb, chroma) = (rgb * part, max * part - min * part);
    if !(chroma > 0.0 && chroma.is_finite()) {
        return None;
    }
    let Rgb { x: r, y: g, z: b } = rgb;
    let sides = if r >= g && r >= b {
        (g - b) / chroma
    } else if g >= b {
        2.0 + (b - r) / chroma
    } else {
        4.0 + (r - g) / chroma
    };
    // −10⁻²⁰ + 6 rounds to 6, which is no hue: the last number below is the nearest.
    Some(if sides < 0.0 { (sides + SIDES).min(SIDES.next_down()) } else { sides })
}

/// Hue, saturation and value.
///
/// - Domain: channels ≥ 0 of any size. Greys have hue 0 and saturation 0, and so has black; at the corners of the
///   cube everything is exact. Negative channels give saturations above 1, or +∞ where the largest is 0.
/// - Accuracy: saturation to `γ₂`, value exact; for the hue see [`hue`].
/// - NaN goes through into value and saturation.
/// - Source: Smith (1978); Foley & van Dam, *Computer Graphics* (1990) §13.3.4.
pub fn hsv_from_rgb(rgb: Rgb) -> Hsv {
    let (value, min) = extent(rgb);
    // A chroma that overflows has a finite half, and so has the value.
    let part = if (value - min).is_finite() { 1.0 } else { 0.5 };
    let saturation = if value == min { 0.0 } else { (value * part - min * part) / (value * part) };
    Hsv { hue: hue(rgb).unwrap_or(0.0), saturation, value }
}

/// Largest and smallest channel; NaN if any is.
fn extent(rgb: Rgb) -> (f64, f64) {
    if rgb.is_nan() { (f64::NAN, f64::NAN) } else { (rgb.max_element(), rgb.min_element()) }
}

/// How far below the largest channel each one lies, as a share of the chroma: a trapezium over the hexagon's sides.
fn below_the_largest(hue: f64) -> DVec3 {
    let share = |offset: f64| {
        let k = (offset + hue).rem_euclid(SIDES);
        k.min(4.0 - k).clamp(0.0, 1.0)
    };
    dvec3(share(5.0), share(3.0), share(1.0))
}

/// The inverse of [`hsv_from_rgb`].
///
/// - Domain: finite; any hue, which is taken round the hexagon.
/// - Accuracy: `γ₁₂ · value` a channel.
/// - NaN goes through.
/// - Source: Smith (1978).
pub fn rgb_from_hsv(hsv: Hsv) -> Rgb {
    let Hsv { hue, saturation, value } = hsv;
    DVec3::splat(value) - value * (saturation * below_the_largest(hue))
}

/// Hue, lightness and saturation.
///
/// - Domain: `[0,1]³`. Greys, black and white have hue 0 and saturation 0. Outside the cube the formulas go on, to
///   +∞ where their divisor vanishes.
/// - Accuracy: lightness `γ₁`; saturation `γ₅`, also next to white, where `2 − max − min` would lose every digit
///   ([`hls_saturation_textbook`]).
/// - NaN goes through into lightness and saturation.
/// - Source: Foley & van Dam (1990) §13.3.5.
pub fn hls_from_rgb(rgb: Rgb) -> Hls {
    let (max, min) = extent(rgb);
    // White and the channels in units in which no sum of two overflows.
    let white = if (max.abs() + min.abs() + 2.0).is_finite() { 1.0 } else { 0.25 };
    let (top, bottom) = (max * white, min * white);
    // 1 − x is exact in [½, 1], so that nothing is lost next to white.
    let room = if top + bottom <= white { top + bottom } else { (white - top) + (white - bottom) };
    let saturation = if max == min { 0.0 } else { (top - bottom) / room };
    Hls { hue: hue(rgb).unwrap_or(0.0), lightness: (top + bottom) * 0.5 / white, saturation }
}

/// The saturation of HLS by the divisor most textbooks print, `2 − max − min`: rounded at 2 when `max` is subtracted, it
/// keeps no digit where white is within a rounding.
///
/// - Source: Foley & van Dam (1990) §13.3.5.
pub fn hls_saturation_textbook(rgb: Rgb) -> f64 {
    let (max, min) = (rgb.max_element(), rgb.min_element());
    let lightness = (max + min) / 2.0;
    if max == min {
        0.0
    } else if lightness <= 0.5 {
        (max - min) / (max + min)
    } else {
        (max - min) / (2.0 - max - min)
    }
}

/// The inverse of [`hls_from_rgb`].
///
/// - Domain: finite; any hue, which is taken round the hexagon.
/// - Accuracy: `γ₁₄` a channel in the cube.
/// - NaN goes through.
/// - Source: Foley & van Dam (1990) §13.3.5.
pub fn rgb_from_hls(hls: Hls) -> Rgb {
    let Hls { hue, lightness, saturation } = hls;
    let most = lightness.min(1.0 - lightness);
    DVec3::splat(lightness) + most * (saturation * (1.0 - 2.0 * below_the_largest(hue)))
}
