//! Julia sets against their tables.
//!
//! `julia_escape`: orbits at 120 digits and more (`julia_escape_nasty.csv`: by `julia_nasty.py`). `julia_hit`: level sets, with a
//! bracket of the first crossing that interval arithmetic has proven. `julia_distance`: exact for c = 0 and −2; else brackets by
//! Koebe's theorem.

use super::truth::{Record, all_right, wrong_rows};
use lightbench::num::U;

const ESCAPE: &str = include_str!("../data/julia_escape.csv");
const NASTY: &str = include_str!("../data/julia_escape_nasty.csv");
const HIT: &str = include_str!("../data/julia_hit.csv");
const DISTANCE: &str = include_str!("../data/julia_distance.csv");

/// Relative error over a tolerance; both blank is right.
fn relative(row: &Record, answer: &Record, column: &str, tolerance: f64) -> f64 {
    match (answer.number(column), row.number(column)) {
        (None, None) => 0.0,
        (Some(got), Some(want)) if got == want => 0.0,
        (Some(got), Some(want)) => (got - want).abs() / (want.abs().max(1e-290) * tolerance),
        _ => f64::INFINITY,
    }
}

/// The inputs' last bits decide nothing, and 106 bits hold the rest: 25 digits of growth leave six.
fn orbit(row: &Record, answer: &Record) -> Option<f64> {
    if !row.is_judged() {
        return None;
    }
    if answer.text("n_escape") != row.text("n_escape") {
        return Some(f64::INFINITY);
    }
    let errors = [("qmag", 1e-9), ("dmag", 1e-9), ("de", 1e-8)].map(|(c, t)| relative(row, answer, c, t));
    Some(errors.into_iter().fold(0.0, f64::max))
}

fn hit(row: &Record, answer: &Record) -> Option<f64> {
    if answer.text("hit") != row.text("hit") {
        return Some(f64::INFINITY);
    }
    let Some(truth) = row.number("t") else { return Some(0.0) };
    let slope = row.number("dlogq_dt")?.abs();
    // 13 steps round |q| some 10² times; the slope of ln |q| makes a place of it.
    let allowed = 1024.0 * U * (1.0 + truth) * (1.0 + 1.0 / slope) + 1e3 * U * slope.max(1.0);
    Some(answer.number("t").map_or(f64::INFINITY, |t| (t - truth).abs() / allowed))
}

/// Never beyond the set, but for the rounding of the table; at least a quarter of the lower bound.
fn distance(row: &Record, answer: &Record) -> Option<f64> {
    let upper = row.number("dist_exact").or(row.number("dist_upper"))?;
    let lower = row.number("dist_lower").unwrap_or(upper);
    let size =
        ["px", "py", "pz"].map(|c| row.number(c).unwrap_or(0.0)).iter().map(|x| x * x).sum::<f64>().sqrt();
    let step = answer.number("safe_step")?;
    let right = step <= upper * (1.0 + 1e-12) + 16.0 * U * (1.0 + size) && step >= 0.25 * lower;
    Some(if right { 0.0 } else { f64::INFINITY })
}

#[test]
fn orbits_agree_with_their_table() {
    all_right("julia_escape", ESCAPE, orbit);
}

#[test]
fn orbits_agree_with_their_nasty_table() {
    all_right("julia_escape", NASTY, orbit);
}

/// In plain f64 |q'| uses up the digits.
#[test]
fn the_nasty_table_catches_plain_orbits() {
    let (_, wrong) = wrong_rows("julia_escape", Some("f64"), NASTY, orbit);
    assert!(wrong.len() >= 10, "only {} rows wrong", wrong.len());
    let (_, wrong) = wrong_rows("julia_escape", Some("as_printed"), ESCAPE, orbit);
    assert!(wrong.len() >= 200, "only {} rows wrong", wrong.len());
}

#[test]
fn hits_agree_with_their_table() {
    all_right("julia_hit", HIT, hit);
}

/// The ways of the books stop early, or beyond.
#[test]
fn the_table_catches_other_ways_to_meet_a_julia_set() {
    for method in ["as_printed", "estimate", "at_least", "ball"] {
        let (_, wrong) = wrong_rows("julia_hit", Some(method), HIT, hit);
        assert!(wrong.len() >= 100, "{method}: only {} rows wrong", wrong.len());
    }
}

#[test]
fn steps_agree_with_their_table() {
    all_right("julia_distance", DISTANCE, distance);
}

#[test]
fn the_table_catches_the_plain_estimate() {
    let (_, wrong) = wrong_rows("julia_distance", Some("as_printed"), DISTANCE, distance);
    assert!(wrong.len() >= 20, "only {} rows wrong", wrong.len());
}
