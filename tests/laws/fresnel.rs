//! Laws of Fresnel's equations.

use lightbench::fresnel::{Polarised, conductor, cos_transmitted, dielectric, schlick, schlick_between};
use lightbench::num::{U, gamma};
use proptest::prelude::*;

fn index() -> impl Strategy<Value = f64> {
    let near = (-15.0..0.0f64).prop_map(|e| 1.0 + 10f64.powf(e));
    prop_oneof![Just(1.0), 0.2..4.0, near, (-3.0..3.0f64).prop_map(|e| 10f64.powf(e))]
}

fn cosine() -> impl Strategy<Value = f64> {
    let tiny = (-300.0..0.0f64).prop_map(|e| 10f64.powf(e));
    prop_oneof![Just(0.0), Just(1.0), 0.0..1.0, tiny, (0u32..64).prop_map(|k| 1.0 - f64::from(k) * U)]
}

fn in_range(r: Polarised) -> bool {
    [r.s, r.p, r.mean()].iter().all(|x| (0.0..=1.0).contains(x))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn reflectances_are_shares(i in index(), t in index(), k in prop_oneof![Just(0.0), 0.0..10.0, Just(1e-12), Just(1e3)], cos in cosine()) {
        prop_assert!(in_range(dielectric(i, t, cos)), "{:?}", dielectric(i, t, cos));
        prop_assert!(in_range(conductor(t, k, cos)), "{:?}", conductor(t, k, cos));
    }

    #[test]
    fn grazing_light_comes_back(i in index(), t in index(), k in 0.0..10.0) {
        prop_assert_eq!(dielectric(i, t, 0.0), Polarised::ALL);
        prop_assert_eq!(conductor(t, k, 0.0), Polarised::ALL);
    }

    /// The same share goes back whichever side the light comes from. The cosine of the other side is rounded, and errors of
    /// cosines grow by 1/cos on either side.
    #[test]
    fn both_ways_reflect_alike(i in index(), t in index(), cos in 0.01..1.0f64) {
        let Some(other) = cos_transmitted(i, t, cos).filter(|c| *c > 0.01) else { return Ok(()) };
        let (there, back) = (dielectric(i, t, cos), dielectric(t, i, other));
        // Indices differ by up to 10⁶, and their square comes into g: cond ≤ 10⁶ · 1/cos².
        let tolerance = gamma(64) / (cos * other) * (i / t).max(t / i).powi(2);
        prop_assert!((there.s - back.s).abs() <= tolerance && (there.p - back.p).abs() <= tolerance, "{there:?} {back:?}");
    }

    /// Without extinction a metal is clear. Where the two sides are nearly equal the complex root keeps fewer digits.
    #[test]
    fn a_metal_without_extinction_is_clear(t in 1.05..4.0f64, cos in 0.001..1.0f64) {
        let (metal, clear) = (conductor(t, 0.0, cos), dielectric(1.0, t, cos));
        prop_assert!((metal.s - clear.s).abs() <= gamma(64) && (metal.p - clear.p).abs() <= gamma(64), "{metal:?} {clear:?}");
    }

    #[test]
    fn beyond_the_critical_angle_all_comes_back(i in 1.01..4.0f64, share in 0.0..1.0f64) {
        let critical = (1.0 - 1.0 / (i * i)).sqrt();
        let cos = critical * share * (1.0 - 8.0 * U);
        prop_assert_eq!(dielectric(i, 1.0, cos), Polarised::ALL);
        prop_assert!(cos_transmitted(i, 1.0, cos).is_none());
        prop_assert_eq!(schlick_between(i, 1.0, cos), 1.0);
    }
}

/// Where indices are nearly equal, printed differences cancel: relative to theirs, ours keep all digits.
#[test]
fn equal_indices_reflect_nothing_and_nearly_equal_ones_nearly_nothing() {
    assert_eq!(dielectric(1.3, 1.3, 1e-200), Polarised { s: 0.0, p: 0.0 });
    // At normal incidence R = ((t − i)/(t + i))²; t − i is exact.
    let (i, t) = (1.0, 1.0 + f64::EPSILON);
    let truth = (f64::EPSILON / (2.0 + f64::EPSILON)).powi(2);
    assert!((dielectric(i, t, 1.0).s - truth).abs() <= gamma(16) * truth);
}

/// Schlick's error from air to glass, and the classic mistake on the way out.
#[test]
fn schlick_takes_the_larger_angle() {
    let worst = (0..=1000).map(|k| f64::from(k) / 1000.0).fold(0.0f64, |worst, cos| {
        worst.max((schlick_between(1.0, 1.5, cos) - dielectric(1.0, 1.5, cos).mean()).abs())
    });
    assert!((0.035..0.037).contains(&worst), "{worst}");
    let cos = 40f64.to_radians().cos();
    let (exact, right, wrong) =
        (dielectric(1.5, 1.0, cos).mean(), schlick_between(1.5, 1.0, cos), schlick(0.04, 1.0 - cos));
    for (found, expected) in [(exact, 0.245), (right, 0.246), (wrong, 0.041)] {
        assert!((found - expected).abs() < 0.001, "{found} {expected}");
    }
}
