//! Answers set against the truth, one by one.

use super::{Failures, Point, Run, Spread};

/// Collects the answers of one method to a batch of questions.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    runs: Vec<Run>,
    failures: Failures,
}

impl Tally {
    pub fn new() -> Self {
        Tally::default()
    }

    /// An answer, or none, against the truth, or none. Two answers are compared by their relative error.
    pub fn answer(&mut self, found: Option<f64>, truth: Option<f64>) {
        self.failures.of += 1;
        match (found, truth) {
            (Some(x), _) if !x.is_finite() => self.failures.nan += 1,
            (Some(x), Some(t)) => self.runs.push(Run { time: None, error: Some(relative(x, t)) }),
            (None, Some(_)) => self.failures.missed += 1,
            (Some(_), None) => self.failures.false_hits += 1,
            (None, None) => {}
        }
    }

    /// An error that the caller knows already; NaN and infinities count as failures.
    pub fn error(&mut self, error: f64) {
        self.failures.of += 1;
        if error.is_finite() {
            self.runs.push(Run { time: None, error: Some(error.abs()) });
        } else {
            self.failures.nan += 1;
        }
    }

    /// One timed estimate of `truth`, of which only a number counts.
    pub fn timed_answer(&mut self, seconds: f64, found: f64, truth: f64) {
        self.failures.of += 1;
        let error = found.is_finite().then(|| relative(found, truth));
        if error.is_none() {
            self.failures.nan += 1;
        }
        self.runs.push(Run { time: Some(seconds), error });
    }

    pub fn failures(&self) -> Failures {
        self.failures
    }

    /// The errors of the answers that could be compared.
    pub fn errors(&self) -> Vec<f64> {
        self.runs.iter().filter_map(|r| r.error).collect()
    }

    /// The largest error; `None` if nothing could be compared.
    pub fn worst(&self) -> Option<f64> {
        self.errors().into_iter().reduce(f64::max)
    }

    /// The point of a series whose error is the root mean square over the answers.
    pub fn rms_at(self, parameter: f64) -> Point {
        let error = Spread::rms(&self.errors());
        self.point(parameter, error)
    }

    /// The point of a series whose error is the median of the answers.
    pub fn median_at(self, parameter: f64) -> Point {
        let error = Spread::median(&self.errors());
        self.point(parameter, error)
    }

    /// The point of a series whose error is the worst of the answers; its spread starts at the median.
    pub fn worst_at(self, parameter: f64) -> Point {
        let error = match (self.worst(), Spread::median(&self.errors())) {
            (Some(worst), Some(median)) => {
                Some(Spread { mid: worst, low: median.mid, high: worst, runs: median.runs })
            }
            _ => None,
        };
        self.point(parameter, error)
    }

    fn point(self, parameter: f64, error: Option<Spread>) -> Point {
        let seconds: Vec<f64> = self.runs.iter().filter_map(|r| r.time).collect();
        let time = Spread::median(&seconds);
        // Answers of a batch are not repetitions: they stay out of the raw runs unless they were timed.
        let runs = if time.is_some() { self.runs } else { Vec::new() };
        Point { parameter, time, work: None, error, failures: self.failures, runs }
    }
}

/// `|x − truth| / |truth|`, or `|x − truth|` if the truth is 0.
fn relative(x: f64, truth: f64) -> f64 {
    let difference = (x - truth).abs();
    if truth == 0.0 || difference == 0.0 { difference } else { difference / truth.abs() }
}
