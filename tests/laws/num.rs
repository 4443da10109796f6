//! Polynomials: exact answers where they exist, bounds elsewhere, and nothing undefined anywhere.

use lightbench::num::double_double::{DoubleDouble, difference_of_products, two_product, two_sum};
use lightbench::num::quartic::{self, Solver};
use lightbench::num::{U, cubic, gamma, quadratic};
use proptest::prelude::*;

const SOLVERS: [(&str, Solver); 6] = [
    ("adaptive", quartic::adaptive),
    ("bracketed", quartic::bracketed),
    ("algorithm_1010", quartic::algorithm_1010),
    ("ferrari", quartic::ferrari),
    ("sturm", quartic::sturm),
    ("as_printed", quartic::graphics_gems_as_printed),
];

/// Zeros, subnormals, extremes, neighbours of one, and ordinary numbers.
fn nasty() -> impl Strategy<Value = f64> {
    let special =
        vec![0.0, -0.0, 5e-324, -1e-310, f64::MIN_POSITIVE, 1e-150, -1e150, 1e300, f64::MAX, 1.0, -1.0];
    prop_oneof![
        3 => prop::sample::select(special),
        1 => Just(1.0 + f64::EPSILON),
        4 => -10.0f64..10.0,
        4 => (-150.0f64..150.0, any::<bool>()).prop_map(|(e, neg)| 10f64.powf(e) * if neg { -1.0 } else { 1.0 }),
    ]
}

/// Coefficients `a₃, a₂, a₁, a₀` of `Π (x − rᵢ)` for integers: exact.
fn from_integer_roots(r: [i64; 4]) -> [f64; 4] {
    let mut c = [0i64; 5];
    c[0] = 1;
    for x in r {
        for k in (1..5).rev() {
            c[k] -= x * c[k - 1];
        }
    }
    [c[1], c[2], c[3], c[4]].map(|x| x as f64)
}

fn sorted_distinct(mut r: Vec<i64>) -> Vec<f64> {
    r.sort_unstable();
    r.dedup();
    r.into_iter().map(|x| x as f64).collect()
}

/// Value of a polynomial (highest coefficient first) in double-double, and its slope.
fn value_and_slope(c: &[f64], x: f64) -> (f64, f64) {
    let (mut f, mut df) = (DoubleDouble::of(0.0), 0.0);
    for &k in c {
        df = df * x + f.high;
        f = f * DoubleDouble::of(x) + DoubleDouble::of(k);
    }
    (f.high, df)
}

fn config() -> ProptestConfig {
    ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(41),
        ..ProptestConfig::with_cases(2000)
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn error_free_transformations_are_exact(a in -(1i64 << 53)..(1i64 << 53), b in -(1i64 << 53)..(1i64 << 53)) {
        let (s, e) = two_sum(a as f64, b as f64);
        prop_assert_eq!(s as i128 + e as i128, i128::from(a) + i128::from(b));
        let (p, e) = two_product(a as f64, b as f64);
        prop_assert_eq!(p as i128 + e as i128, i128::from(a) * i128::from(b));
    }

    /// `ab − cd` for integers, against exact arithmetic: 3 u.
    #[test]
    fn differences_of_products_do_not_cancel(a in 1i64 << 50..1 << 53, b in 1i64 << 50..1 << 53, near in -4i64..4) {
        let (c, d) = (a + near, b - near);
        let exact = i128::from(a) * i128::from(b) - i128::from(c) * i128::from(d);
        let got = difference_of_products(a as f64, b as f64, c as f64, d as f64);
        prop_assert!((got - exact as f64).abs() <= 4.0 * U * (exact as f64).abs(), "{} for {}", got, exact);
    }

    /// The promised γ₅ of each root moves the value by `|f′| γ₅|r|` and by `|a|(γ₅ r)²`. The value is
    /// computed to 2⁻¹⁰² of terms that are at most 3 |a r²| + 3 |c|.
    #[test]
    fn roots_of_quadratics_keep_their_promise(a in -10.0f64..10.0, b in -1e4f64..1e4, c in -10.0f64..10.0, e in -30i32..30) {
        let c = c * 2f64.powi(e);
        prop_assume!(a != 0.0);
        for r in quadratic::real_roots(a, b, c) {
            let (f, df) = value_and_slope(&[a, b, c], r);
            let moved = gamma(5) * r.abs();
            let terms = (a * r * r).abs() + (b * r).abs() + c.abs();
            let allowed = df.abs() * moved + a.abs() * moved * moved + 16.0 * U * U * 3.0 * terms;
            prop_assert!(f.abs() <= allowed, "residual {f:e} at {r:e}, allowed {allowed:e}");
        }
    }

    #[test]
    fn quadratics_with_integer_roots_are_solved_exactly(p in -1000i64..1000, q in -1000i64..1000, lead in 1i64..100, e in -400i32..400) {
        let c = [lead, -lead * (p + q), lead * p * q].map(|x| x as f64);
        let scale = 2f64.powi(e);
        let got = quadratic::real_roots(c[0], c[1] * scale, c[2] * scale * scale);
        let want: Vec<f64> = sorted_distinct(vec![p, q]).into_iter().map(|x| x * scale).collect();
        prop_assert_eq!(got.to_vec(), want);
    }

    #[test]
    fn cubics_with_integer_roots_are_solved_exactly(r in prop::array::uniform3(-500i64..500)) {
        let [p, q, s] = r;
        let c = [-(p + q + s), p * q + q * s + s * p, -p * q * s].map(|x| x as f64);
        prop_assert_eq!(cubic::real_roots(1.0, c[0], c[1], c[2]).to_vec(), sorted_distinct(r.to_vec()));
    }

    /// Multiple roots, which small ranges make frequent, count once; and powers of two change nothing.
    #[test]
    fn quartics_with_integer_roots_are_solved_exactly(
        r in prop_oneof![prop::array::uniform4(-3i64..4), prop::array::uniform4(-4000i64..4000)], e in -200i32..200,
    ) {
        let [a3, a2, a1, a0] = from_integer_roots(r);
        let k = 2f64.powi(e);
        let got = quartic::adaptive(a3 * k, a2 * k * k, a1 * k * k * k, a0 * k * k * k * k);
        let want: Vec<f64> = sorted_distinct(r.to_vec()).into_iter().map(|x| x * k).collect();
        prop_assert_eq!(got.to_vec(), want);
    }

    /// Far apart roots are easy for every method but the printed one: 64 u of the condition number. Beside a root
    /// 0, whose condition number is 0, what counts is the size of the others.
    #[test]
    fn solvers_agree_on_separate_roots(r in prop::array::uniform4(-100i64..100)) {
        let want = sorted_distinct(r.to_vec());
        prop_assume!(want.len() == 4);
        let [a3, a2, a1, a0] = from_integer_roots(r);
        for (name, solve) in &SOLVERS[..5] {
            let got = solve(a3, a2, a1, a0);
            prop_assert_eq!(got.len(), 4, "{}: {:?} for {:?}", name, got, want);
            for (g, w) in got.iter().zip(&want) {
                let terms = [w.powi(4), a3 * w.powi(3), a2 * w * w, a1 * w, a0].map(f64::abs).iter().sum::<f64>();
                let slope = want.iter().filter(|x| *x != w).map(|x| (w - x).abs()).product::<f64>();
                let size = if *w == 0.0 { want.iter().fold(0.0, |m: f64, x| m.max(x.abs())) } else { w.abs() };
                prop_assert!((g - w).abs() <= 64.0 * U * (terms / slope + size), "{name}: {g} for {w}");
            }
        }
    }

    #[test]
    fn mirrored_quartics_have_mirrored_roots(c in prop::array::uniform4(-5.0f64..5.0)) {
        let roots = quartic::adaptive(c[3], c[2], c[1], c[0]);
        let mut mirrored = quartic::adaptive(-c[3], c[2], -c[1], c[0]).into_iter().map(|x| -x).collect::<Vec<_>>();
        mirrored.reverse();
        prop_assert_eq!(roots.len(), mirrored.len());
        for (x, y) in roots.iter().zip(&mirrored) {
            // Both within 2 u of the same number.
            prop_assert!((x - y).abs() <= 4.0 * U * x.abs(), "{x} {y}");
        }
    }

    /// Products of two quadratics without real roots have none, however close to the axis theirs are.
    #[test]
    fn sums_of_squares_have_no_roots(p in -8i64..8, q in -8i64..8, e in 1i32..20) {
        // ((x − p)² + h)((x − q)² + h) with h = 2⁻ᵉ: coefficients are exact in 12 + 2 · 19 bits.
        let h = 2f64.powi(-e);
        let (p, q) = (p as f64, q as f64);
        let (b, c) = (p * p + h, q * q + h);
        let got = quartic::adaptive(-2.0 * (p + q), b + c + 4.0 * p * q, -2.0 * (p * c + q * b), b * c);
        prop_assert!(got.is_empty(), "{:?}", got);
    }

    #[test]
    fn no_solver_invents_undefined_numbers(c in prop::array::uniform4(nasty())) {
        for (name, solve) in SOLVERS {
            let roots = solve(c[3], c[2], c[1], c[0]);
            prop_assert!(roots.iter().all(|x| x.is_finite()), "{}: {:?}", name, roots);
            prop_assert!(roots.windows(2).all(|w| w[0] <= w[1]), "{}: {:?}", name, roots);
        }
        prop_assert!(quadratic::real_roots(c[0], c[1], c[2]).iter().all(|x| x.is_finite()));
        prop_assert!(cubic::real_roots(c[0], c[1], c[2], c[3]).iter().all(|x| x.is_finite()));
    }

    /// Where the values of an extreme quartic can be told from zero, they change sign at each root.
    #[test]
    fn roots_far_apart_are_all_found(e in prop::array::uniform4(-70i32..70), negative in prop::array::uniform4(any::<bool>())) {
        let mut e = e;
        e.sort_unstable();
        prop_assume!(e.windows(2).all(|w| w[1] - w[0] >= 2));
        let r = [0, 1, 2, 3].map(|i| 10f64.powi(e[i]) * if negative[i] { -1.0 } else { 1.0 });
        let mut c = [1.0, 0.0, 0.0, 0.0, 0.0];
        for x in r {
            for k in (1..5).rev() {
                c[k] -= x * c[k - 1];
            }
        }
        prop_assume!(c.iter().all(|x: &f64| x.is_finite()));
        let mut want = r.to_vec();
        want.sort_by(f64::total_cmp);
        let got = quartic::adaptive(c[1], c[2], c[3], c[4]);
        prop_assert_eq!(got.len(), 4);
        for (g, w) in got.iter().zip(&want) {
            // Coefficients to γ₈ (no sum of ratio 100 cancels more than 1 %), root conditions below 5.
            prop_assert!((g - w).abs() <= 5.0 * gamma(9) * w.abs(), "{g:e} for {w:e}");
        }
    }
}

#[test]
fn lines_and_constants_are_no_quadratics_but_answer() {
    assert_eq!(quadratic::real_roots(0.0, 2.0, -3.0).to_vec(), [1.5]);
    assert!(quadratic::real_roots(0.0, 0.0, 1.0).is_empty());
    assert_eq!(quadratic::real_roots(3.0, 0.0, 0.0).to_vec(), [0.0]);
    assert_eq!(quadratic::real_roots(1e300, -3e300, 2e300).to_vec(), [1.0, 2.0]);
    assert_eq!(cubic::real_roots(0.0, 1.0, -3.0, 2.0).to_vec(), [1.0, 2.0]);
    assert!(quadratic::real_roots(f64::NAN, 1.0, 1.0).is_empty());
    assert!(quartic::adaptive(f64::INFINITY, 0.0, 0.0, 0.0).is_empty());
    assert_eq!(quartic::adaptive(0.0, 0.0, 0.0, 0.0).to_vec(), [0.0]);
}

/// `(x² − 2)²`: the double roots are no `f64`, and still two.
#[test]
fn irrational_double_roots_count_once() {
    let roots = quartic::adaptive(0.0, -4.0, 0.0, 4.0);
    assert_eq!(roots.to_vec(), [-std::f64::consts::SQRT_2, std::f64::consts::SQRT_2]);
}

/// Neither a root of 1e150 nor one of 1e-150 is lost to the other.
#[test]
fn extreme_coefficients_keep_both_ends() {
    let roots = quartic::adaptive(1e150, 0.0, 0.0, -1e-150);
    assert_eq!(roots.len(), 2);
    assert_eq!(roots[0], -1e150);
    assert!((roots[1] - 1e-100).abs() <= 4.0 * U * 1e-100, "{}", roots[1]);
}
