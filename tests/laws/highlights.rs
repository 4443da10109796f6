//! Laws of highlights: exponents that answer each other, stand-ins for the power, the printed code.

use crate::support::{nasty, seed};
use glam::DVec3;
use lightbench::bsdf::highlight::{Match, grazing_coefficient, lyon_power, mismatch, power, schlick_power};
use lightbench::bsdf::{Blinn, BlinnScale, Brdf, Phong, PhongScale, as_printed, mirror};
use lightbench::color::Rgb;
use lightbench::num::gamma;
use lightbench::sample::{Sampler, uniform_hemisphere};
use proptest::prelude::*;

const EXPONENTS: [f64; 8] = [0.3, 1.0, 2.5, 10.0, 50.0, 1e3, 1e5, 1e7];

/// `m → 4n + offset`; the next term falls as 1/n, with a factor under 2 (n = 1 shows 0.82, 0.16, 0.84, 1.1 of it).
#[test]
fn exponents_come_to_four_n_and_an_offset() {
    let offsets = [0.0, std::f64::consts::LN_2, 1.5, 2.0];
    for (way, offset) in Match::ALL.into_iter().zip(offsets) {
        for n in EXPONENTS.into_iter().filter(|n| *n >= 10.0) {
            let found = way.exponent(n) - 4.0 * n;
            // Least squares stands on its quadrature, the others on the rounding of m.
            let rounding = gamma(16) * 4.0 * n + 1e-6 * (1.0 + 1e-8 * n);
            assert!((found - offset).abs() <= 2.0 / n + rounding, "{way:?} {n}: 4n + {found}");
        }
    }
}

/// `cosᵐ(φ/2) = ½` where `cosⁿ φ = ½`, with φ from the inverse cosine where that has its digits.
#[test]
fn half_widths_are_equal() {
    for n in EXPONENTS.into_iter().filter(|n| *n <= 1e3) {
        let phi = 0.5f64.powf(1.0 / n).acos();
        let half = (0.5 * phi).cos().powf(Match::HalfWidth.exponent(n));
        // The inverse cosine errs by u/φ, φ² = 2 ln 2/n, and m φ/4 times that enters the logarithm: n u; the power adds 4n u.
        assert!((half - 0.5).abs() <= gamma(64) * (1.0 + n), "{n}: {half}");
    }
}

/// Against the albedos of the models, which stand on another quadrature.
#[test]
fn energies_are_equal() {
    for n in EXPONENTS.into_iter().filter(|n| *n <= 1e5) {
        let m = Match::Energy.exponent(n);
        let phong = Phong::new(n).unwrap().scaled(PhongScale::OverCosine).albedo(DVec3::Z);
        let blinn = Blinn::new(m).unwrap().scaled(BlinnScale::OverCosine).albedo(DVec3::Z);
        let tolerance = phong.error + blinn.error + 1e-12 * phong.value;
        assert!((phong.value - blinn.value).abs() <= tolerance, "{n}, {m}: {phong:?} {blinn:?}");
    }
}

#[test]
fn least_squares_is_least() {
    for n in EXPONENTS.into_iter().filter(|n| *n <= 1e5) {
        let m = Match::LeastSquares.exponent(n);
        let least = mismatch(n, m);
        // The square grows by (δ/0.61)² of itself: 0.03 is two hundredths of a per cent, quadrature is good to 10⁻⁸.
        for other in [m - 0.03, m + 0.03].into_iter().chain(Match::ALL.map(|way| way.exponent(n))) {
            let worse = mismatch(n, other);
            assert!(worse >= least * (1.0 - 1e-7), "{n}: {worse} at {other}, {least} at {m}");
            assert!(other == m || (other - m).abs() < 0.02 || worse > least, "{n}: no curvature at {m}");
        }
        // 0.153/n for sharp lobes: √(3/8)/4.
        assert!(n < 50.0 || (least * n - 0.375f64.sqrt() / 4.0).abs() < 1.0 / n, "{n}: {}", least * n);
    }
}

/// Brute force: the midpoint rule over φ, whose error is the square of the step, 10⁻⁷ of the narrowest lobe here.
#[test]
fn the_mismatch_is_what_a_sum_says() {
    for (n, m) in [(1.0, 1.0), (5.0, 20.0), (50.0, 50.0), (50.0, 201.5), (10.0, 50.0)] {
        let steps = 200_000;
        let (mut square, mut all) = (0.0, 0.0);
        for i in 0..steps {
            let phi = std::f64::consts::FRAC_PI_2 * (f64::from(i) + 0.5) / f64::from(steps);
            let (p, b) = (phi.cos().powf(n), (0.5 * phi).cos().powf(m));
            square += (p - b) * (p - b) * phi.sin();
            all += p * p * phi.sin();
        }
        let (sum, found) = ((square / all).sqrt(), mismatch(n, m));
        assert!((sum - found).abs() <= 1e-6 * sum, "{n}, {m}: {found}, {sum}");
    }
}

/// Exponent and versine of a highlight: all sizes of both, near and far from the peak.
fn places() -> impl Strategy<Value = (f64, f64)> {
    let decades = |low: f64, high: f64| (low..high).prop_map(|e| 10f64.powf(e));
    prop_oneof![
        (0.0..2.0f64, 1.0..1e3f64),
        (decades(-12.0, 0.0), decades(0.0, 8.0)),
        decades(0.0, 8.0).prop_flat_map(|n| (0.0..6.0f64).prop_map(move |x| (x / n, n))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    /// Bernoulli: `(1/t)ⁿ ≥ 1 + n (1/t − 1)`. The peak's own rounding is that of the power: its logarithm's.
    #[test]
    fn schlick_is_never_below_and_at_most_a_fifth_above((v, n) in places()) {
        let (truth, found) = (power(v, n), schlick_power(v, n));
        prop_assert!(found >= truth * (1.0 - gamma(16) * (1.0 - truth.max(1e-300).ln())), "{found} {truth}");
        // max 1/(1 + x) − e⁻ˣ = 0.20363 at x = 2.513; a finite n stays below.
        prop_assert!(found - truth <= 0.20364, "{found} {truth}");
    }

    /// `(1 − x)^(n/g) ≥ 1 − (n/g) x` for n ≥ g, and `e⁻ˣ − (1 − x/g)^g ≤ x² e⁻ˣ/g ≤ 4 e⁻²/g`.
    #[test]
    fn lyon_is_never_above_and_at_most_half_a_g_th_below((v, n) in places(), k in 0u32..10) {
        let g = f64::from(1u32 << k);
        prop_assume!(n >= g);
        let (truth, found) = (power(v, n), lyon_power(v, n, k));
        // A factor's rounding counts g times, and n v/g of it is lost where the factor is small.
        let rounding = gamma(8) * (1.0 + g);
        prop_assert!(found <= truth * (1.0 + gamma(16) * (1.0 - truth.max(1e-300).ln())) + rounding, "{found} {truth}");
        prop_assert!(truth - found <= 4.0 * (-2.0f64).exp() / g + rounding, "{found} {truth}");
    }

    #[test]
    fn stand_ins_are_exact_at_their_exponents(v in 0.0..1.0f64, k in 0u32..6) {
        let g = 1u32 << k;
        // One subtraction, then g products: relative γ of the power, which the truth has as well.
        let truth = (1.0 - v).powi(g as i32);
        prop_assert!((lyon_power(v, f64::from(g), k) - truth).abs() <= gamma(4 * g) * truth);
        prop_assert!((schlick_power(v, 1.0) - (1.0 - v)).abs() <= gamma(4) * (1.0 - v));
    }

    /// The printed code is Phong's power about the viewer's mirror direction: for unit vectors that of the light's as well.
    #[test]
    fn the_printed_highlight_is_phongs(l in nasty::unit_vector(), v in nasty::unit_vector()) {
        let found = as_printed::highlight_as_printed(l, DVec3::Z, v, 6.0, 0.5);
        let cos = l.dot(mirror(v));
        // Two forms of one cosine, each within γ₁₆ of it, to the sixth.
        prop_assert!((found - 0.5 * cos.max(0.0).powi(6)).abs() <= gamma(128));
        prop_assert!(as_printed::highlight_as_worded(l, l, 6.0, 0.5) >= 0.5 * (1.0 - gamma(64)), "not retro-reflective");
    }
}

/// Every edge that the docs give.
#[test]
fn edges_of_the_stand_ins() {
    for n in [0.0, 1.0, 20.0] {
        for versine in [1.0, 1.5, 2.0] {
            let found = [power(versine, n), schlick_power(versine, n), lyon_power(versine, n, 4)];
            assert_eq!(found, [0.0; 3], "{versine} {n}");
        }
        assert_eq!([power(0.0, n), schlick_power(0.0, n), lyon_power(0.0, n, 4)], [1.0; 3], "the peak");
    }
    for (v, n) in [(f64::NAN, 2.0), (0.2, f64::NAN)] {
        assert!(power(v, n).is_nan() && schlick_power(v, n).is_nan() && lyon_power(v, n, 3).is_nan());
    }
    assert!(Match::ALL.iter().all(|way| way.exponent(f64::NAN).is_nan()));
    assert_eq!((grazing_coefficient(0.04, 5.0, 1.0), grazing_coefficient(0.04, 5.0, 0.0)), (0.04, 1.0));
    assert!(grazing_coefficient(0.04, 5.0, f64::NAN).is_nan());
}

/// FAILURES of A: what ill. 68 adds is there in full shadow, has the material's colour, and ambient light counts the lamps.
#[test]
fn the_printed_sum_shines_in_shadow() {
    let (red, dark) = (Rgb::new(0.8, 0.1, 0.1), Rgb::ZERO);
    let shadow = as_printed::reflected_light_as_printed(red, dark, dark, 1.0, 0.9);
    assert_eq!(shadow, red * 0.9);
    let ambient = Rgb::splat(0.2);
    let lamps: Rgb =
        (0..3).map(|_| as_printed::reflected_light_as_printed(red, ambient, dark, 1.0, 0.0)).sum();
    assert!((lamps - red * ambient * 3.0).abs().max_element() <= gamma(8));
}

/// Blinn's highlight is narrower across than along: `n·h` of a viewer beside the mirror direction falls as if it stood
/// `1/cos θ` times as far off.
#[test]
fn half_vectors_stretch_highlights_by_the_cosine() {
    for i in 0..200 {
        let mut s = Sampler::new(seed("stretch"), 0, i);
        let l = uniform_hemisphere(s.next_2d());
        if l.z < 0.1 || l.z > 0.99 {
            continue;
        }
        let across = DVec3::Z.cross(l).normalize();
        let step = 1e-4;
        let v = (mirror(l) + across * step).normalize();
        let h = l + v;
        let tilt = h.truncate().length() / h.z;
        // Of tan β = step/(2 cos θ) the next terms are of the order of step² / cos²θ.
        assert!((tilt * 2.0 * l.z / step - 1.0).abs() <= 10.0 * (step / l.z).powi(2) + 1e-10, "{l}: {tilt}");
    }
}
