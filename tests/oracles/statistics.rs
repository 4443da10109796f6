//! Distribution functions against tables and closed forms.

use crate::support::Table;
use lightbench::num::statistics::*;
use lightbench::num::{U, gamma};

/// What the documentation of each function promises; relative error, but for the last two.
fn promised(function: &str, truth: f64) -> f64 {
    match function {
        "erf" => 10.0 * U * truth,
        "erfc" => 20.0 * U * truth,
        // The larger tail is one minus the smaller one: its error is absolute.
        "gamma_p" | "gamma_q" | "beta_inc" | "student_t_two_sided" => 1e-13 * truth,
        "ln_gamma" => 8.0 * U * truth.abs().max(1.0),
        "normal_quantile" => 1e-15 * truth.abs().max(1.0),
        other => panic!("{other} in the table"),
    }
}

#[test]
fn special_functions_agree_with_fifty_digits() {
    let mut wrong = Vec::new();
    for row in Table::read("special_functions.csv").rows() {
        let (name, a, b, x) = (row.text("function"), row.f64("a"), row.f64("b"), row.f64("x"));
        let answer = match name {
            "erf" => erf(x),
            "erfc" => erfc(x),
            "ln_gamma" => ln_gamma(x),
            "gamma_p" => gamma_p(a, x),
            "gamma_q" => gamma_q(a, x),
            "beta_inc" => beta_inc(a, b, x, 1.0 - x),
            "student_t_two_sided" => student_t_two_sided(x, a),
            _ => normal_quantile(x),
        };
        let truth = row.f64("value");
        let error = (answer - truth).abs();
        // The table's own rounding.
        let tolerance = promised(name, truth) + U * truth.abs();
        if !(error <= tolerance) {
            wrong.push(format!(
                "{name}({a:e}, {b:e}, {x:e}) = {answer:e}, not {truth:e}: off by {:.1} u",
                error / truth / U
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn chi_square_critical_values_agree_with_the_table() {
    for row in Table::read("chi2_sphere.csv").rows() {
        for (column, p) in [("chi2_crit_p01", 0.01), ("chi2_crit_p001", 0.001), ("chi2_crit_p1e6", 1e-6)] {
            let (critical, dof) = (row.f64(column), row.f64("dof"));
            let answer = chi2_survival(critical, dof);
            // d ln Q / d ln x is at most x/2 in the tail: the table's value is rounded (u), to 5e-16 (its second method).
            let tolerance = 1e-13 + 0.5 * critical * (U + 5e-16);
            assert!((answer / p - 1.0).abs() <= tolerance, "{dof} at {critical}: {answer} for {p}");
        }
    }
}

#[test]
fn two_degrees_of_freedom_are_an_exponential() {
    for x in [1e-3, 0.5, 2.0, 30.0, 500.0] {
        let truth = (-0.5f64 * x).exp();
        assert!((chi2_survival(x, 2.0) - truth).abs() <= 1e-13 * truth);
    }
}

#[test]
fn one_degree_of_freedom_is_cauchy() {
    // P(|T| ≥ t) = 1 − 2/π atan t = 2/π atan(1/t).
    for t in [1e-3, 0.5, 1.0, 6.0, 1e8] {
        let truth = std::f64::consts::FRAC_2_PI * (1.0f64 / t).atan();
        assert!((student_t_two_sided(t, 1.0) - truth).abs() <= 1e-13 * truth, "{t}");
        assert!((student_t_cdf(-t, 1.0) - 0.5 * truth).abs() <= 1e-13 * truth);
        assert!((student_t_cdf(t, 1.0) - (1.0 - 0.5 * truth)).abs() <= 1e-13);
    }
}

#[test]
fn log_gamma_of_integers_is_the_log_factorial() {
    let mut factorial = 1.0f64;
    for n in 1..=18 {
        // Exact up to 18! < 2⁵³; the logarithm rounds once.
        let truth = factorial.ln();
        let x = f64::from(n);
        assert!((ln_gamma(x) - truth).abs() <= 8.0 * U * truth.max(1.0) + U * truth);
        factorial *= x;
    }
}

#[test]
fn variance_survives_a_large_mean() {
    // Three numbers about 10⁹: κ = 10⁹; Welford loses n κ u = 3e-7, Σx² − (Σx)²/n everything (n κ² u = 330).
    let moments: Moments = [1e9 - 1.0, 1e9, 1e9 + 1.0].into_iter().collect();
    assert_eq!(moments.mean(), Some(1e9));
    assert!((moments.variance().unwrap() - 1.0).abs() <= gamma(3) * 1e9);
}
