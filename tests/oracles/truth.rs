//! The high-precision tables of `tests/data`, held against `probe`, so that the command and the library
//! are tested in one.
//!
//! The tables were computed at 30 digits and more, each checked by a second method; their inputs are exactly
//! the `f64` printed. `margin` is the smallest relative change of the inputs that changes a discrete
//! answer: rows under 1e-12 (10⁴ roundings) are decided by the inputs' last digits, and not judged.
//! `cond` is the relative condition number of a root: a stable method errs by a few `u cond`, and 64
//! are allowed.

use lightbench::num::U;
use lightbench_kit::probe;
use std::collections::HashMap;

/// One row: names to texts.
pub struct Record(HashMap<String, String>);

impl Record {
    pub fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", |s| s.as_str())
    }
    pub fn number(&self, column: &str) -> Option<f64> {
        let text = self.text(column);
        if text.is_empty() { None } else { Some(text.parse().unwrap_or_else(|_| panic!("{column}: {text}"))) }
    }
    /// The inputs decide the discrete answer.
    pub fn is_judged(&self) -> bool {
        self.text("degenerate") != "1" && self.number("margin").is_none_or(|m| m >= 1e-12)
    }
    fn largest(&self, columns: &[&str]) -> f64 {
        columns.iter().filter_map(|c| self.number(c)).fold(0.0, |m, x| m.max(x.abs()))
    }
}

pub fn records(csv_text: &str) -> Vec<Record> {
    let mut reader = csv::Reader::from_reader(csv_text.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let rows = reader.records().map(|r| r.expect("a row"));
    rows.map(|r| Record(header.iter().map(str::to_string).zip(r.iter().map(str::to_string)).collect()))
        .collect()
}

/// Runs a topic over its table and lists the rows that `judge` (error in units of its tolerance) finds wrong.
pub fn wrong_rows(
    topic: &str,
    method: Option<&str>,
    table: &str,
    judge: impl Fn(&Record, &Record) -> Option<f64>,
) -> (usize, Vec<String>) {
    let topic = probe::topic(topic).expect("a topic");
    let answers = probe::run(topic, method, table.as_bytes()).expect("answers");
    let (truth, answers) = (records(table), records(&answers));
    assert_eq!(truth.len(), answers.len());
    let mut judged = 0;
    let mut wrong = Vec::new();
    for (i, (row, answer)) in truth.iter().zip(&answers).enumerate() {
        let Some(error) = judge(row, answer) else { continue };
        judged += 1;
        if !(error <= 1.0) {
            wrong.push(format!("line {}: {error:e} tolerances; answer {:?}", i + 2, answer.0));
        }
    }
    (judged, wrong)
}

/// Every judged row of a topic's table is right.
pub fn all_right(topic: &str, table: &str, judge: impl Fn(&Record, &Record) -> Option<f64>) {
    let (judged, wrong) = wrong_rows(topic, None, table, judge);
    assert!(judged > 0);
    assert!(wrong.is_empty(), "{topic}: {} of {judged} rows wrong\n{}", wrong.len(), wrong.join("\n"));
}

fn relative(got: Option<f64>, want: Option<f64>) -> f64 {
    match (got, want) {
        (Some(g), Some(w)) if g == w => 0.0,
        (Some(g), Some(w)) => (g - w).abs() / w.abs(),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}

/// Columns with an absolute tolerance.
pub fn columns(names: &'static [&'static str], tolerance: f64) -> impl Fn(&Record, &Record) -> Option<f64> {
    move |row, answer| {
        let error = |c: &&str| match (answer.number(c), row.number(c)) {
            (Some(g), Some(w)) => (g - w).abs() / tolerance,
            (None, None) => 0.0,
            _ => f64::INFINITY,
        };
        row.is_judged().then(|| names.iter().map(error).fold(0.0, f64::max))
    }
}

/// Positive roots with condition numbers, and the normal at the first.
///
/// A point is known to `64 u (|o| + t)`, the normal to that over the radius of curvature `curvature` names.
pub fn sphere_roots(row: &Record, answer: &Record) -> Option<f64> {
    if !row.is_judged() {
        return None;
    }
    let size = row.largest(&["ox", "oy", "oz", "cx", "cy", "cz", "r"]);
    // An origin on the surface up to rounding: the inputs do not say whether that root is positive.
    let undecided = 1e-12 * size;
    let roots = |r: &Record| ["tp0", "tp1"].map(|c| r.number(c)).into_iter().flatten().collect::<Vec<_>>();
    let near = roots(row).iter().chain(&roots(answer)).any(|t| *t < undecided);
    let keep = |r: &Record| roots(r).into_iter().filter(|t| *t >= undecided).collect::<Vec<_>>();
    let (want, got) = (keep(row), keep(answer));
    if want.len() != got.len() {
        return Some(f64::INFINITY);
    }
    let mut worst: f64 = 0.0;
    for (g, w) in got.iter().zip(&want) {
        let at = if row.number("tp0") == Some(*w) { "cond_tp0" } else { "cond_tp1" };
        let cond = row.number(at).unwrap_or(1.0).max(1.0);
        if cond > 1e10 {
            return None;
        }
        worst = worst.max((g - w).abs() / (w * 64.0 * U * cond));
    }
    if let (Some(t), false) = (want.first(), near) {
        let cond = row.number("cond_tp0").unwrap_or(1.0).max(1.0);
        let r = row.number("r")?;
        let tolerance = (64.0 * U * (size + t) / r).max(1e-12) * cond;
        for c in ["nx", "ny", "nz"] {
            worst = worst.max((answer.number(c)? - row.number(c)?).abs() / tolerance);
        }
    }
    Some(worst)
}

/// Positive roots with faces, of capped solids: errors grow with √margin near tangency and at edges.
pub fn faces(row: &Record, answer: &Record) -> Option<f64> {
    if !row.is_judged() || row.text("tangent") == "1" {
        return None;
    }
    if answer.number("n_pos") != row.number("n_pos") {
        return Some(f64::INFINITY);
    }
    let margin = row.number("margin").unwrap_or(1.0).clamp(1e-12, 1.0);
    let mut worst: f64 = 0.0;
    for i in 0..row.number("n_pos")? as usize {
        let (t, face) = (format!("tp{i}"), format!("face{i}"));
        worst = worst.max(relative(answer.number(&t), row.number(&t)) / (1e-13 / margin.sqrt()));
        if margin > 1e-9 && answer.text(&face) != row.text(&face) {
            return Some(f64::INFINITY);
        }
    }
    Some(worst)
}

/// Roots of one sort, each with a condition number; `None` if a cluster leaves even their count to the
/// last bits.
fn conditioned(row: &Record, answer: &Record, prefix: &str, from: f64) -> Option<f64> {
    let column = |name: &str, i: usize| format!("{name}{i}");
    let listed = |r: &Record| (0..4).filter_map(|i| r.number(&column(prefix, i))).collect::<Vec<_>>();
    let conds = (0..4).filter_map(|i| row.number(&column("cond", i)));
    let want: Vec<_> = listed(row).into_iter().zip(conds).filter(|(t, _)| *t >= from).collect();
    let got: Vec<_> = listed(answer).into_iter().filter(|t| *t >= from).collect();
    if want.iter().any(|(_, cond)| !(*cond <= 1e10)) {
        return None;
    }
    if want.len() != got.len() {
        return Some(f64::INFINITY);
    }
    let error = |(g, (w, cond)): (&f64, &(f64, f64))| match g == w {
        true => 0.0,
        false => (g - w).abs() / (w.abs() * 64.0 * U * cond.max(1.0)),
    };
    Some(got.iter().zip(&want).map(error).fold(0.0, f64::max))
}

/// Real roots of a quartic.
pub fn quartic_roots(row: &Record, answer: &Record) -> Option<f64> {
    row.is_judged().then(|| conditioned(row, answer, "r", f64::NEG_INFINITY)).flatten()
}

/// Positive roots of a torus, and the normal at the first: a point is known to `64 u (|o| + t)`, the
/// normal to that over the tube's radius.
pub fn torus_roots(row: &Record, answer: &Record) -> Option<f64> {
    if !row.is_judged() {
        return None;
    }
    let size = row.largest(&["ox", "oy", "oz"]).max(row.number("a")? + row.number("b")?);
    // An origin on the surface up to rounding: the inputs do not say whether that root is positive.
    let from = 1e-12 * size;
    let mut worst = conditioned(row, answer, "t", from)?;
    let firsts = (row.number("t0"), answer.number("t0"));
    if let (Some(t), Some(g)) = firsts
        && t >= from
        && g >= from
        && row.number("cond0")? < 1e6
    {
        let tolerance = (64.0 * U * (size + t) / row.number("b")?).max(1e-12) * row.number("cond0")?.max(1.0);
        for c in ["nx", "ny", "nz"] {
            worst = worst.max((answer.number(c)? - row.number(c)?).abs() / tolerance);
        }
    }
    Some(worst)
}

/// Spans `enter:leave;…`, as numbers.
fn spans(text: &str) -> Vec<[f64; 2]> {
    let number = |t: &str| t.parse().unwrap_or_else(|_| panic!("{text}"));
    let span = |s: &str| s.split_once(':').map(|(a, b)| [number(a), number(b)]);
    text.split(';').filter_map(span).collect()
}

/// Ends to 64 u of the reach of the ray (some 10) over a slant of 10⁻⁴ or more: 10⁻⁹. Rows in which only rounding decides
/// whether a solid is touched are not judged; of faces that coincide, which is met is a rule of ours.
pub fn csg_spans(row: &Record, answer: &Record) -> Option<f64> {
    const ALLOWED: f64 = 1e-9;
    let coincident = row.text("coincident") == "1";
    let decided = row.number("margin").is_none_or(|m| m >= 1e-12) || coincident;
    if row.text("degenerate") == "1" || row.text("tangent") == "1" || !decided {
        return None;
    }
    let (want, got) = (spans(row.text("spans")), spans(answer.text("spans")));
    if want.len() != got.len() {
        return Some(f64::INFINITY);
    }
    let ends = want.iter().flatten().zip(got.iter().flatten());
    let mut worst = ends.map(|(w, g)| (w - g).abs() / w.abs().max(1.0) / ALLOWED).fold(0.0, f64::max);
    if !coincident {
        worst = worst.max(relative(answer.number("first_hit"), row.number("first_hit")) / ALLOWED);
        for axis in ["nx", "ny", "nz"] {
            if let Some(n) = row.number(axis) {
                let got = answer.number(axis).unwrap_or(f64::NAN);
                // Normals of curved faces turn with the point: 10⁻⁹ over radii of 0.1 and more.
                worst =
                    if got.is_nan() { f64::INFINITY } else { worst.max((got - n).abs() / (1e3 * ALLOWED)) };
            }
        }
    }
    Some(worst)
}
