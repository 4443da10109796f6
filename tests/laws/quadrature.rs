//! Laws of adaptive quadrature.

use lightbench::num::gamma;
use lightbench::num::quadrature::integrate;
use proptest::prelude::*;

/// Kronrod's rule with 15 nodes is exact for polynomials of degree 22, Gauss's with 7 for 13.
#[test]
fn polynomials_are_exact_at_once() {
    for degree in 0..=22 {
        let mut calls = 0;
        let monomial = |x: f64| {
            calls += 1;
            x.powi(degree)
        };
        let found = integrate(monomial, &[0.0, 1.0], 1e-12);
        let truth = 1.0 / f64::from(degree + 1);
        assert!((found.value - truth).abs() <= gamma(64), "{degree}: {found:?}");
        assert!(calls <= 15 || degree > 13, "{degree}: {calls} calls");
    }
}

#[test]
fn hard_integrands_end_within_their_error() {
    type Case = (&'static str, fn(f64) -> f64, f64);
    let cases: [Case; 5] = [
        ("root", f64::sqrt, 2.0 / 3.0),
        ("pole", |x| 1.0 / x.sqrt(), 2.0),
        ("jump", |x| if x < 1.0 / 3.0 { 1.0 } else { 0.0 }, 1.0 / 3.0),
        ("peak", |x| 1e-3 / (x * x + 1e-6), 1e3f64.atan()),
        ("kink", |x| (x - 0.7).abs(), 0.29),
    ];
    for (name, f, truth) in cases {
        let found = integrate(f, &[0.0, 1.0], 1e-9);
        assert!((found.value - truth).abs() <= found.error, "{name}: {found:?}, {truth}");
        assert!(found.error <= 1e-6, "{name}: {found:?}");
    }
}

#[test]
fn edges() {
    assert_eq!(integrate(|x| x, &[1.0, 1.0], 1e-9).value, 0.0);
    assert_eq!(integrate(|_| 0.0, &[0.0, 1.0], 1e-9).error, 0.0);
    assert!(integrate(|_| f64::NAN, &[0.0, 1.0], 1e-9).value.is_nan());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn breaks_do_not_change_the_integral(a in 0.01..0.99f64, b in 0.01..0.99f64, width in 0.05..1.0f64) {
        let f = |x: f64| (-(x - a) * (x - a) / (width * width)).exp();
        let (whole, cut) = (integrate(f, &[0.0, 1.0], 1e-10), integrate(f, &[0.0, b, b, 1.0], 1e-10));
        prop_assert!((whole.value - cut.value).abs() <= whole.error + cut.error);
    }
}
