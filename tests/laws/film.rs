//! Laws of the sRGB curve, of images, tone maps and metrics.

use lightbench::color::{LUMINANCE, Rgb, luminance, srgb_decode, srgb_encode};
use lightbench::film::Image;
use lightbench::film::error_picture::{diverging, signed_error};
use lightbench::film::metric::{Comparison, compare};
use lightbench::film::tone::{ToneMap, divide_by_channel_maxima_as_printed, filmic};
use lightbench::num::gamma;
use lightbench::num::sum::pairwise;
use proptest::prelude::*;

/// Cases from a fixed seed, and no files of failures.
pub fn config() -> ProptestConfig {
    ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(14),
        ..ProptestConfig::with_cases(256)
    }
}

/// Numbers of [0,1] that are hard on the curve: tiny ones, the knee's neighbours, the rest.
fn unit() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.0..=1.0f64,
        0.00313..0.003132f64,
        0.0404..0.0405f64,
        (-320.0..0.0f64).prop_map(|e| 10f64.powf(e)),
        Just(0.0),
        Just(-0.0),
        Just(1.0),
        Just(5e-324),
    ]
}

/// Radiances from nothing to far too much, negative ones among them.
fn radiance() -> impl Strategy<Value = f64> + Clone {
    let scaled = (-1.0..1.0f64, -150.0..150.0f64).prop_map(|(m, e)| m * 10f64.powf(e));
    prop_oneof![4 => 0.0..4.0f64, 1 => scaled, 1 => Just(0.0), 1 => Just(-0.0), 1 => Just(1.0)]
}

fn colour(channel: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Rgb> {
    (channel.clone(), channel.clone(), channel).prop_map(|(r, g, b)| Rgb::new(r, g, b))
}

pub fn picture(channel: impl Strategy<Value = f64> + Clone, side: usize) -> impl Strategy<Value = Image> {
    let size = (1..=side, 1..=side);
    size.prop_flat_map(move |(w, h)| {
        prop::collection::vec(colour(channel.clone()), w * h).prop_map(move |p| Image::from_pixels(w, h, p))
    })
}

/// A picture of pseudo-random channels in [0,1), without a generator's state.
pub fn speckle(width: usize, height: usize, salt: u64) -> Image {
    let channel = |i: u64| {
        let mut z = (i ^ salt.rotate_left(32)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    };
    Image::from_fn(width, height, |x, y| {
        let i = 3 * (y * width + x) as u64;
        Rgb::new(channel(i), channel(i + 1), channel(i + 2))
    })
}

/// On the gap of the published constants, 0.0031308 < l with a code ≤ 0.04045, decoding goes along
/// the straight piece what encoding went along the power. The power is the flatter of the two there, so that
/// they are farthest apart at the gap's end, where the code is 0.04045: by 2.33e-9.
fn gap(linear: f64) -> f64 {
    if linear > 0.0031308 && srgb_encode(linear) <= 0.04045 {
        ((0.04045f64 + 0.055) / 1.055).powf(2.4) - 0.04045 / 12.92
    } else {
        0.0
    }
}

proptest! {
    #![proptest_config(config())]

    /// Encoding errs by γ₁₂; decoding's slope is at most 2.275 (at 1) and adds γ₁₆ of its own.
    #[test]
    fn decoding_undoes_encoding(linear in unit()) {
        let error = (srgb_decode(srgb_encode(linear)) - linear).abs();
        // Absolute errors of encoding exist on the power piece alone; the straight one is relative.
        let bound = if linear <= 0.0031308 { gamma(2) * linear + 5e-324 } else { 2.275 * gamma(12) + gamma(16) };
        prop_assert!(error <= bound + gap(linear), "{linear}: {error:e} > {bound:e}");
    }

    /// Both pieces are monotone, up to the errors of two values; only the knee's gap falls.
    #[test]
    fn encoding_is_monotone_on_either_side_of_the_knee(a in unit(), b in unit()) {
        let (low, high) = (a.min(b), a.max(b));
        prop_assume!((low <= 0.0031308) == (high <= 0.0031308));
        prop_assert!(srgb_encode(low) <= srgb_encode(high) + 2.0 * gamma(12));
    }

    #[test]
    fn luminance_is_linear(p in colour(0.0..10.0f64), q in colour(0.0..10.0f64), s in 0.0..10.0f64) {
        let (left, right) = (luminance(p * s + q), luminance(p) * s + luminance(q));
        // Four roundings in a luminance, two each in the combinations around it.
        prop_assert!((left - right).abs() <= gamma(12) * right);
    }

    #[test]
    fn every_tone_map_of_finite_numbers_lies_in_the_unit_interval(image in picture(radiance(), 4)) {
        for map in ToneMap::ALL {
            for p in map.apply(&image).pixels() {
                prop_assert!(p.min_element() >= 0.0 && p.max_element() <= 1.0, "{}: {p}", map.name());
            }
        }
    }

    #[test]
    fn clamping_twice_is_clamping_once(image in picture(radiance(), 4)) {
        let once = ToneMap::Clamp.apply(&image);
        prop_assert_eq!(ToneMap::Clamp.apply(&once), once);
    }

    /// One divisor: r/g of the picture stays r/g of the map. Two quotients, two divisions: γ₄.
    #[test]
    fn dividing_by_the_maximum_keeps_ratios(image in picture(1e-3..50.0f64, 4)) {
        let mapped = ToneMap::DivideByMaximum.apply(&image);
        let peak = image.pixels().iter().fold(0.0f64, |m, p| m.max(p.max_element()));
        let mapped_peak = mapped.pixels().iter().fold(0.0f64, |m, p| m.max(p.max_element()));
        prop_assert_eq!(mapped_peak, peak.min(1.0));
        for (p, q) in image.pixels().iter().zip(mapped.pixels()) {
            prop_assert!((p.x / p.y - q.x / q.y).abs() <= gamma(4) * (p.x / p.y));
            prop_assert!((p.z / p.y - q.z / q.y).abs() <= gamma(4) * (p.z / p.y));
        }
    }

    /// Monotone but for the 9 roundings of each of two values, which are at most 1.
    #[test]
    fn filmic_never_falls(a in radiance(), b in radiance()) {
        prop_assert!(filmic(a.min(b)) <= filmic(a.max(b)) + 2.0 * gamma(9));
    }

    #[test]
    fn comparing_a_picture_with_itself_finds_nothing(image in picture(radiance(), 14)) {
        let c = compare(&image, &image);
        let nothing = Comparison {
            rmse: 0.0, signed_mean: 0.0, relative_mse: 0.0, psnr: f64::INFINITY, ssim: 1.0, max_error: 0.0,
            ..c
        };
        prop_assert_eq!(c, nothing);
        prop_assert_eq!(c.not_finite, 0);
    }

    /// Swapping the pictures keeps every symmetric number, to the last bit, and turns the signs.
    #[test]
    fn swapping_pictures_keeps_symmetric_metrics(a in picture(radiance(), 6), salt in 0u64..1000) {
        let b = speckle(a.width(), a.height(), salt);
        let (ab, ba) = (compare(&a, &b), compare(&b, &a));
        prop_assert_eq!((ab.rmse, ab.psnr, ab.ssim), (ba.rmse, ba.psnr, ba.ssim));
        prop_assert_eq!((ab.signed_mean, ab.max_error, ab.max_at), (-ba.signed_mean, -ba.max_error, ba.max_at));
        prop_assert!(ab.rmse <= ab.max_error.abs() * (1.0 + gamma(80)));
        prop_assert!(ab.signed_mean.abs() <= ab.rmse * (1.0 + gamma(160)));
        prop_assert!((-1.0..=1.0).contains(&ab.ssim) && !ab.relative_mse.is_nan());
    }

    /// Powers of two scale exactly, so watts and 2^k watts have the very same relative error.
    #[test]
    fn relative_mse_does_not_depend_on_the_unit(k in -400..400i32, salt in 0u64..1000) {
        let (a, b) = (speckle(5, 4, salt), speckle(5, 4, salt + 1));
        let scale = 2f64.powi(k);
        let scaled = compare(&a.map(|p| p * scale), &b.map(|p| p * scale));
        let plain = compare(&a, &b);
        // hypot may round differently at another scale: 1 ulp in each ratio, squared, and summed.
        prop_assert!((scaled.relative_mse - plain.relative_mse).abs() <= gamma(80) * plain.relative_mse);
        prop_assert_eq!(scaled.rmse, plain.rmse * scale);
    }

    #[test]
    fn the_error_picture_is_white_where_there_is_no_error(image in picture(radiance(), 5)) {
        let drawn = signed_error(&image, &image);
        prop_assert_eq!((drawn.full_scale, drawn.saturated), (0.0, 0));
        prop_assert!(drawn.image.pixels().iter().all(|p| *p == Rgb::ONE));
    }

    /// Lightness falls from white to both ends; red and blue tell the sides apart.
    #[test]
    fn diverging_colours_darken_away_from_white(s in 0.0..1.0f64, t in 0.0..1.0f64) {
        let (small, large) = (s.min(t), s.max(t));
        for sign in [-1.0, 1.0] {
            let (near, far) = (luminance(diverging(sign * small)), luminance(diverging(sign * large)));
            prop_assert!(far <= near + gamma(64));
        }
        let (blue, red) = (diverging(-large), diverging(large));
        prop_assert!(blue.z >= blue.x && red.x >= red.z);
    }
}

#[test]
fn the_srgb_curve_takes_every_number() {
    for curve in [srgb_encode as fn(f64) -> f64, srgb_decode] {
        assert!(curve(f64::NAN).is_nan());
        assert_eq!(curve(f64::INFINITY), f64::INFINITY);
        assert_eq!(curve(f64::NEG_INFINITY), f64::NEG_INFINITY);
        assert_eq!(curve(0.0), 0.0);
        assert!(curve(4.0) > 1.0);
    }
    assert_eq!(srgb_encode(-0.5), 12.92 * -0.5);
    assert_eq!(srgb_decode(-0.5), -0.5 / 12.92);
    // The gap that the constants leave at the knee, as the standard's own numbers give it.
    let fall = srgb_encode(0.0031308) - srgb_encode(0.0031308f64.next_up());
    assert!(fall > 2.8e-8 && fall < 2.9e-8, "{fall:e}");
    // White has luminance 1: three rounded weights and two sums.
    assert!((luminance(Rgb::ONE) - 1.0).abs() <= gamma(4));
    assert!((LUMINANCE - Rgb::new(0.2126, 0.7152, 0.0722)).abs().max_element() < 5e-5);
}

/// 90 000 pixels are above the size from which threads share a sum.
#[test]
fn a_sum_has_the_same_bits_on_every_number_of_threads() {
    let image = speckle(300, 300, 7);
    let other = speckle(300, 300, 8);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| (image.sum(), compare(&image, &other)))
    };
    let alone = run(1);
    for threads in [2, 3, 8] {
        assert_eq!(run(threads), alone, "{threads} threads");
    }
}

/// `n` times 0.1: γ of the leaf's 64 additions and the tree's levels.
#[test]
fn a_pairwise_sum_keeps_its_bound() {
    for n in [1usize, 63, 64, 65, 1000, 1 << 20] {
        let levels = (n as f64 / 64.0).log2().max(0.0).ceil() as u32;
        let exact = n as f64 * 0.1;
        let error = (pairwise(0..n, &|_| 0.1) - exact).abs();
        assert!(error <= gamma(64 + levels + 1) * exact, "{n}: {error:e}");
    }
    assert_eq!(Image::new(0, 0).mean(), None);
    assert_eq!(Image::new(3, 2).mean(), Some(Rgb::ZERO));
}

#[test]
fn tone_maps_keep_what_is_in_range_and_show_nan() {
    let inside = Image::from_pixels(2, 1, vec![Rgb::new(0.0, 0.5, 1.0), Rgb::splat(0.25)]);
    assert_eq!(ToneMap::Clamp.apply(&inside), inside);
    assert_eq!(ToneMap::DivideByMaximum.apply(&inside), inside);
    assert_eq!(ToneMap::default(), ToneMap::Clamp);
    let wild = Image::from_pixels(1, 1, vec![Rgb::new(f64::NAN, f64::INFINITY, f64::NEG_INFINITY)]);
    for map in ToneMap::ALL {
        let p = map.apply(&wild).get(0, 0);
        assert!(p.x.is_nan() && p.y == 1.0 && p.z == 0.0, "{}: {p}", map.name());
    }
    assert_eq!(filmic(0.0), 0.0);
    assert!(filmic(7.24) < 1.0 && filmic(7.25) == 1.0);
    assert!([1e155, 1e200, f64::MAX].iter().all(|x| filmic(*x) == 1.0));
}

/// Three divisors turn every colour towards the missing ones: an orange pixel becomes white.
#[test]
fn dividing_by_channel_maxima_shifts_the_hue() {
    let image = Image::from_pixels(2, 1, vec![Rgb::new(2.0, 1.0, 0.5), Rgb::new(0.5, 0.25, 0.125)]);
    let printed = divide_by_channel_maxima_as_printed(&image);
    assert_eq!(printed.get(0, 0), Rgb::ONE);
    assert_eq!(ToneMap::DivideByMaximum.apply(&image).get(0, 0), Rgb::new(1.0, 0.5, 0.25));
    assert_eq!(divide_by_channel_maxima_as_printed(&Image::new(1, 1)), Image::new(1, 1));
}

#[test]
fn the_largest_error_is_found_where_it_is() {
    let b = speckle(7, 5, 3);
    let mut a = b.clone();
    a.set(4, 2, b.get(4, 2) + Rgb::new(0.25, -8.0, 0.0));
    let c = compare(&a, &b);
    assert_eq!((c.max_at.x, c.max_at.y, c.max_at.channel), (4, 2, 1));
    // One subtraction of numbers near 8 and one back: two roundings of at most 8u.
    assert!((c.max_error + 8.0).abs() <= gamma(2) * 8.0);
    a.set(1, 0, Rgb::new(0.0, f64::NAN, 0.0));
    a.set(5, 4, Rgb::splat(f64::INFINITY));
    let c = compare(&a, &b);
    assert_eq!((c.max_at.x, c.max_at.y, c.max_at.channel, c.not_finite), (1, 0, 1, 2));
    assert!(c.rmse.is_nan() && c.signed_mean.is_nan() && c.psnr.is_nan() && c.ssim.is_nan());
}

#[test]
fn relative_error_of_a_black_reference_is_infinite_not_nan() {
    let black = Image::new(3, 3);
    assert_eq!(compare(&speckle(3, 3, 1), &black).relative_mse, f64::INFINITY);
    assert_eq!(compare(&black, &black).relative_mse, 0.0);
}

/// 100 pixels: 98 right, one dark by 1, one a firefly. The scale ignores the firefly alone.
#[test]
fn the_error_picture_ignores_a_firefly_when_it_scales() {
    let b = Image::from_fn(10, 10, |_, _| Rgb::splat(2.0));
    let mut a = b.clone();
    a.set(0, 0, Rgb::new(2.0, 1.0, 2.0));
    a.set(9, 9, Rgb::splat(1000.0));
    let drawn = signed_error(&a, &b);
    assert_eq!((drawn.full_scale, drawn.saturated), (1.0, 1));
    assert_eq!(drawn.image.get(0, 0), diverging(-1.0));
    assert_eq!(drawn.image.get(9, 9), diverging(1.0));
    assert_eq!(drawn.image.get(5, 5), Rgb::ONE);
    // With the firefly alone the quantile is 0, and the scale its own.
    a.set(0, 0, Rgb::splat(2.0));
    assert_eq!(signed_error(&a, &b).full_scale, 998.0);
    a.set(3, 3, Rgb::splat(f64::NAN));
    assert_eq!(signed_error(&a, &b).image.get(3, 3), Rgb::ZERO);
}
