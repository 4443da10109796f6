//! The arithmetics under the surfaces.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use lightbench::num::certified::{Bounded, Roots, Scalar, power_of_two_below, solve_quadratic};
use lightbench::num::double_double::{DoubleDouble, two_product, two_sum};
use lightbench::num::expansion::Expansion;
use proptest::prelude::*;
use proptest::test_runner::Config;

type Big = FBig<HalfEven, 2>;

fn big(x: f64) -> Big {
    Big::try_from(x).unwrap().with_precision(2400).value()
}

fn number() -> impl Strategy<Value = f64> {
    (-1.0..1.0f64, -60..60i32).prop_map(|(x, e)| x * 2f64.powi(e))
}

/// `(a b + c) / d − √|e|` in any arithmetic.
fn formula<T: Scalar>([a, b, c, d, e]: [f64; 5]) -> T {
    (T::product(a, b) + T::of(c)) / T::of(d) - T::of(e.abs()).sqrt()
}

proptest! {
    #![proptest_config(Config { cases: 5000, failure_persistence: None, ..Config::default() })]

    #[test]
    fn nothing_is_lost_in_sums_and_products(a in number(), b in number()) {
        let (s, e) = two_sum(a, b);
        prop_assert_eq!(big(a) + big(b), big(s) + big(e));
        let (p, e) = two_product(a, b);
        prop_assert_eq!(big(a) * big(b), big(p) + big(e));
    }

    /// Errors add up: 5 + 3 + 10 + 3 times 2⁻¹⁰⁶ of the largest number on the way.
    #[test]
    fn double_doubles_have_106_bits(x in [number(), number(), number(), number(), number()]) {
        prop_assume!(x[3] != 0.0);
        let [a, b, c, d, e] = x.map(big);
        let size = ((x[0] * x[1]).abs() + x[2].abs()) / x[3].abs() + x[4].abs().sqrt();
        let root = if e > Big::ZERO { e } else { -e };
        let exact = (a * b + c) / d - root.sqrt();
        let found: DoubleDouble = formula(x);
        let off = (big(found.high) + big(found.low) - exact).to_f64().value();
        prop_assert!(off.abs() <= 32.0 * 2f64.powi(-106) * size, "{off} of {size}");
    }

    #[test]
    fn running_bounds_hold_the_error(x in [number(), number(), number(), number(), number()]) {
        prop_assume!(x[3] != 0.0);
        let (quick, slow): (Bounded, DoubleDouble) = (formula(x), formula(x));
        let off = (DoubleDouble::of(quick.value()) - slow).value().abs();
        prop_assert!(off <= quick.error(), "{off} over {}", quick.error());
        if let Ok(sign) = quick.sign() {
            prop_assert_eq!(Ok(sign), slow.sign());
        }
    }

    /// Signs of determinants of differences, nearly singular on purpose.
    #[test]
    fn expansions_are_exact(x in [number(), number(), number()], k in 0..4i32) {
        let [a, b, c] = x;
        let (p, q) = (Expansion::difference(a, b), Expansion::difference(c, a));
        let (r, s) = (Expansion::difference(a.next_up(), b), Expansion::difference(c, a * f64::from(k - 1)));
        let found = Expansion::determinant(&p, &q, &r, &s);
        let exact = (big(a) - big(b)) * (big(c) - big(a))
            - (big(a.next_up()) - big(b)) * (big(c) - big(a * f64::from(k - 1)));
        let sign = if exact > Big::ZERO { 1 } else if exact < Big::ZERO { -1 } else { 0 };
        prop_assert_eq!(found.sign(), sign);
    }

    #[test]
    fn roots_ascend_and_solve(a in number(), r0 in number(), r1 in number()) {
        // a (t − r0)(t − r1), its coefficients in 106 bits.
        let b = DoubleDouble::of(a) * (DoubleDouble::of(r0) + DoubleDouble::of(r1)) * DoubleDouble::of(-0.5);
        let c = DoubleDouble::of(a) * DoubleDouble::product(r0, r1);
        prop_assume!(a != 0.0 && (r0 - r1).abs() > 1e-6 * (r0.abs() + r1.abs()));
        let Ok(Roots::Two(t0, t1)) = solve_quadratic(DoubleDouble::of(a), b, c) else {
            return Err(TestCaseError::fail("two roots"));
        };
        let (low, high) = (r0.min(r1), r0.max(r1));
        // 2⁻¹⁰⁰, divided by the square of the gap.
        prop_assert!((t0.value() - low).abs() <= 1e-15 * low.abs() && (t1.value() - high).abs() <= 1e-15 * high.abs());
    }

    #[test]
    fn powers_of_two_are_below(x in 1e-307..1e307f64) {
        let p = power_of_two_below(x);
        prop_assert!(p <= x && x < 2.0 * p && p.to_bits() << 12 == 0);
    }
}

#[test]
fn zeros_are_certain_only_where_they_are_exact() {
    assert_eq!((Bounded::of(0.5) * Bounded::of(0.0)).sign(), Ok(0));
    let third = Bounded::of(1.0) / Bounded::of(3.0);
    assert!((third * Bounded::of(3.0) - Bounded::of(1.0)).sign().is_err());
    assert!((third / (third - third)).settled().is_err());
    assert_eq!(solve_quadratic(0.0, 0.0, 1.0), Ok(Roots::None));
    assert_eq!(solve_quadratic(0.0, 1.0, -4.0), Ok(Roots::One(2.0)));
    assert_eq!(solve_quadratic(1.0, -1.0, 1.0), Ok(Roots::One(1.0)));
}
