//! A comparison as CSV: what repeats in one file, what a clock said in another.

use super::{Method, Series, Spread};

/// Everything about the series that repeats to the bit: parameters, counted work, errors, failures.
///
/// Numbers are printed in the shortest form that reads back exactly; what was not measured stays empty.
pub fn counts_csv(series: &[(&Method, &Series)]) -> String {
    let mut text =
        String::from("method,parameter,work,error,error_low,error_high,runs,missed,false_hits,nan,of\n");
    for (method, series) in series {
        for p in &series.points {
            let f = &p.failures;
            let error = spread(p.error);
            let runs = p.error.map_or(String::new(), |e| e.runs.to_string());
            let head = [cell(&method.name), number(p.parameter), p.work.map_or(String::new(), number)];
            text += &format!(
                "{},{error},{runs},{},{},{},{}\n",
                head.join(","),
                f.missed,
                f.false_hits,
                f.nan,
                f.of
            );
        }
    }
    text
}

/// The times \[s\] of the series: they change from run to run, and live in a file of their own.
pub fn times_csv(series: &[(&Method, &Series)]) -> String {
    let mut text = String::from("method,parameter,time_s,time_q1_s,time_q3_s,runs\n");
    for (method, series) in series {
        for p in series.points.iter().filter(|p| p.time.is_some()) {
            let runs = p.time.map_or(0, |t| t.runs);
            let (name, at) = (cell(&method.name), number(p.parameter));
            text += &format!("{name},{at},{},{runs}\n", spread(p.time));
        }
    }
    text
}

fn spread(value: Option<Spread>) -> String {
    value.map_or(",,".to_string(), |s| format!("{},{},{}", number(s.mid), number(s.low), number(s.high)))
}

fn number(x: f64) -> String {
    let plain = x == 0.0 || (1.0e-4..1.0e7).contains(&x.abs());
    if plain { format!("{x}") } else { format!("{x:e}") }
}

/// A cell, in quotes if it needs them (RFC 4180).
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_string()
    }
}
