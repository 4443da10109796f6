//! Structural similarity of two pictures.

use super::Image;
use crate::color::{luminance, srgb_encode};
use crate::num::sum::pairwise;

/// Side of the window [pixels] and width of its Gaussian [pixels].
const WINDOW: usize = 11;
const SIGMA: f64 = 1.5;
/// Stabilisers `(K₁ L)²` and `(K₂ L)²` for the dynamic range `L = 1` of display values.
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// Mean structural similarity of two pictures, in [−1,1]; 1 if they look the same.
///
/// ```text
/// SSIM = mean over windows of  (2 μ_a μ_b + C₁)(2 σ_ab + C₂) / ((μ_a² + μ_b² + C₁)(σ_a² + σ_b² + C₂))
/// C₁ = 0.01²,  C₂ = 0.03²,  on s = srgb(clamp(Y, 0, 1)),  Y of the clamped channels
/// ```
///
/// Means, variances and covariance are weighted by a Gaussian of σ = 1.5 over 11 × 11 pixels;
/// only windows that lie inside the picture count. Along a side shorter than 11 the window
/// is as long as the side.
///
/// - Domain: two pictures of one size, with at least one pixel.
/// - Accuracy: absolute, a few hundred u: variances are differences of numbers up to 1 that carry
///   `num::gamma(2·11 + 2)` each, over a denominator of at least `C₂`.
/// - NaN goes through. Symmetric to the last bit; exactly 1 for identical pictures.
/// - Source: Wang, Bovik, Sheikh & Simoncelli, *Image Quality Assessment: From Error Visibility to
///   Structural Similarity* (2004), eq. 13–16.
pub fn ssim(a: &Image, b: &Image) -> f64 {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()), "pictures of one size");
    assert!(!a.pixels().is_empty(), "pictures with pixels");
    let (s_a, s_b) = (display_luminance(a), display_luminance(b));
    let window = |product: &dyn Fn(usize) -> f64| {
        let field: Vec<f64> = (0..s_a.len()).map(product).collect();
        weighted_means(&field, a.width(), a.height())
    };
    let (mean_a, mean_b) = (window(&|i| s_a[i]), window(&|i| s_b[i]));
    let (square_a, square_b) = (window(&|i| s_a[i] * s_a[i]), window(&|i| s_b[i] * s_b[i]));
    let product = window(&|i| s_a[i] * s_b[i]);
    let similarity = |i: usize| {
        let (m_a, m_b) = (mean_a[i], mean_b[i]);
        let (var_a, var_b) = (square_a[i] - m_a * m_a, square_b[i] - m_b * m_b);
        let cov = product[i] - m_a * m_b;
        (2.0 * m_a * m_b + C1) * (2.0 * cov + C2) / ((m_a * m_a + m_b * m_b + C1) * (var_a + var_b + C2))
    };
    pairwise(0..mean_a.len(), &similarity) / mean_a.len() as f64
}

fn display_luminance(image: &Image) -> Vec<f64> {
    let display = |p: &crate::color::Rgb| srgb_encode(luminance(p.map(|x| x.clamp(0.0, 1.0))));
    image.pixels().iter().map(display).collect()
}

/// Gaussian means of a field over all windows inside it, row by row.
fn weighted_means(field: &[f64], width: usize, height: usize) -> Vec<f64> {
    let (across, down) = (gaussian(width.min(WINDOW)), gaussian(height.min(WINDOW)));
    let columns = width + 1 - across.len();
    let rows: Vec<f64> = (0..height * columns)
        .map(|i| {
            let start = i / columns * width + i % columns;
            across.iter().zip(&field[start..]).map(|(weight, x)| weight * x).sum()
        })
        .collect();
    (0..(height + 1 - down.len()) * columns)
        .map(|i| down.iter().zip(rows[i..].iter().step_by(columns)).map(|(weight, x)| weight * x).sum())
        .collect()
}

/// Gaussian weights around the middle of `length` pixels, of sum 1.
fn gaussian(length: usize) -> Vec<f64> {
    let middle = (length - 1) as f64 / 2.0;
    let weight = |i: usize| (-0.5 * ((i as f64 - middle) / SIGMA).powi(2)).exp();
    let weights: Vec<f64> = (0..length).map(weight).collect();
    let total: f64 = weights.iter().sum();
    weights.iter().map(|w| w / total).collect()
}
