//! The sRGB curve against its table, tone mapping against document C's example, metrics against closed
//! forms and brute force.

use lightbench::color::{Rgb, luminance, srgb_decode, srgb_encode};
use lightbench::film::Image;
use lightbench::film::metric::compare;
use lightbench::film::ssim::ssim;
use lightbench::film::tone::{ToneMap, divide_by_channel_maxima_as_printed, filmic};
use lightbench::num::gamma;

/// 216 rows, correctly rounded from more than 30 digits, the knee's neighbours among them.
#[test]
fn srgb_transfer_agrees_with_its_table() {
    let table = include_str!("../data/srgb_transfer.csv");
    let mut rows = 0;
    for line in table.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().expect("a number");
        let (curve, input, truth) = (cells[0], number(1), number(2));
        // The documented bounds, and half an ulp of the table: both far below the 1e-14 asked for.
        let (answer, bound) = match curve {
            "encode" => (srgb_encode(input), gamma(13)),
            _ => (srgb_decode(input), gamma(17) * truth),
        };
        assert!((answer - truth).abs() <= bound, "{line}: {answer} is off by {:e}", answer - truth);
        assert!(bound <= 1e-14);
        rows += 1;
    }
    assert_eq!(rows, 216);
}

/// The example of [C §1.8.2 D]: ambient 0.5 and direct 1 on a red surface give (1.5, 0, 0).
#[test]
fn the_documents_colour_example_comes_into_range() {
    let image = Image::from_pixels(1, 1, vec![Rgb::new(0.5 * 1.0 + 1.0 * 1.0, 0.0, 0.0)]);
    let red = Image::from_pixels(1, 1, vec![Rgb::new(1.0, 0.0, 0.0)]);
    assert_eq!(ToneMap::Clamp.apply(&image), red);
    assert_eq!(ToneMap::DivideByMaximum.apply(&image), red);
    assert_eq!(divide_by_channel_maxima_as_printed(&image), red);
}

/// f(1) = 2.54 / 3.16 and f(x) = 1 at x = (0.56 + √0.3584) / 0.16, by hand.
#[test]
fn filmic_passes_through_computed_points() {
    assert!((filmic(1.0) - 2.54 / 3.16).abs() <= gamma(10));
    let end = (0.56 + 0.3584f64.sqrt()) / 0.16;
    assert!((filmic(end) - 1.0).abs() <= gamma(20) && (end - 7.2417).abs() < 5e-5);
}

/// A grey picture g and one brighter by c: every metric has a closed form.
#[test]
fn metrics_of_a_constant_offset_have_closed_forms() {
    let (g, c) = (0.25, 0.0625);
    let b = Image::from_fn(16, 13, |_, _| Rgb::splat(g));
    let a = b.map(|p| p + c);
    let m = compare(&a, &b);
    assert_eq!((m.rmse, m.signed_mean, m.max_error), (c, c, c), "powers of two, equal terms");
    let floor = 0.01 * g;
    let relative = c * c / (g * g + floor * floor);
    // Sums of 208 pixels (γ₆₆), twice, and a dozen roundings in each term.
    assert!((m.relative_mse - relative).abs() <= gamma(150) * relative);
    let (s_a, s_b) = (srgb_encode(g + c), srgb_encode(g));
    let psnr = -20.0 * (s_a - s_b).log10();
    // The same differences of display values; mean and logarithm: dB change by 4.35 times a relative error.
    assert!((m.psnr - psnr).abs() <= 4.35 * gamma(80) + gamma(4) * psnr);
    // No variance: the contrast term is 1, and what remains compares the means. The variances
    // are differences of roundings γ₂₄ over C₂ = 9e-4, once below and once above the line.
    let similarity = (2.0 * s_a * s_b + 1e-4) / (s_a * s_a + s_b * s_b + 1e-4);
    assert!((m.ssim - similarity).abs() <= 4.0 * gamma(24) / 9e-4);
}

/// One wrong pixel of 2 × 2, by hand: d² = 0.25 in one channel of twelve.
#[test]
fn metrics_of_one_wrong_channel_are_computed_by_hand() {
    let b = Image::from_fn(2, 2, |_, _| Rgb::ONE);
    let mut a = b.clone();
    a.set(1, 0, Rgb::new(1.0, 1.0, 0.5));
    let m = compare(&a, &b);
    assert!((m.rmse - (0.25f64 / 12.0).sqrt()).abs() <= gamma(10) * m.rmse);
    assert!((m.signed_mean + 0.5 / 12.0).abs() <= gamma(10) * 0.5 / 12.0);
    assert!((m.relative_mse - 0.25 / 12.0 / 1.0001).abs() <= gamma(20) * m.relative_mse);
    assert_eq!((m.max_error, m.max_at.x, m.max_at.y, m.max_at.channel), (-0.5, 1, 0, 2));
}

/// The definition, word by word: every window, two passes, centred moments, a two-dimensional Gaussian.
fn ssim_by_definition(a: &Image, b: &Image) -> f64 {
    let display =
        |i: &Image, x: usize, y: usize| srgb_encode(luminance(i.get(x, y).clamp(Rgb::ZERO, Rgb::ONE)));
    let (w, h) = (a.width().min(11), a.height().min(11));
    let weight = |i: usize, j: usize| {
        let (x, y) = (i as f64 - (w - 1) as f64 / 2.0, j as f64 - (h - 1) as f64 / 2.0);
        (-(x * x + y * y) / (2.0 * 1.5 * 1.5)).exp()
    };
    let cells: Vec<(usize, usize)> = (0..h).flat_map(|j| (0..w).map(move |i| (i, j))).collect();
    let total: f64 = cells.iter().map(|c| weight(c.0, c.1)).sum();
    let (mut sum, mut windows) = (0.0, 0.0);
    for y in 0..=a.height() - h {
        for x in 0..=a.width() - w {
            let mean = |f: &dyn Fn(usize, usize) -> f64| -> f64 {
                cells.iter().map(|c| weight(c.0, c.1) / total * f(x + c.0, y + c.1)).sum()
            };
            let (m_a, m_b) = (mean(&|i, j| display(a, i, j)), mean(&|i, j| display(b, i, j)));
            let var_a = mean(&|i, j| (display(a, i, j) - m_a).powi(2));
            let var_b = mean(&|i, j| (display(b, i, j) - m_b).powi(2));
            let cov = mean(&|i, j| (display(a, i, j) - m_a) * (display(b, i, j) - m_b));
            sum += (2.0 * m_a * m_b + 1e-4) * (2.0 * cov + 9e-4)
                / ((m_a * m_a + m_b * m_b + 1e-4) * (var_a + var_b + 9e-4));
            windows += 1.0;
        }
    }
    sum / windows
}

#[test]
fn ssim_agrees_with_its_definition() {
    for (width, height) in [(1, 1), (2, 1), (5, 17), (11, 11), (12, 3), (20, 16)] {
        let wave = |x: usize, y: usize, k: f64| {
            let phase = k * (x as f64 * 0.7 + y as f64 * 1.3);
            Rgb::new(0.5 + 0.6 * phase.sin(), 0.4 + 0.4 * phase.cos(), 0.3)
        };
        let a = Image::from_fn(width, height, |x, y| wave(x, y, 1.0));
        let b = Image::from_fn(width, height, |x, y| wave(x, y, 1.1));
        let (fast, slow) = (ssim(&a, &b), ssim_by_definition(&a, &b));
        // One-pass moments: γ₂₄ of numbers ≤ 1 in each variance, over C₂; two passes: γ₁₂₁ of themselves.
        let bound = 4.0 * (gamma(24) + gamma(121)) / 9e-4;
        assert!((fast - slow).abs() <= bound, "{width} × {height}: {fast} against {slow}");
    }
}
