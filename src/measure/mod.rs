//! Measuring: what a method costs, and how far its answers lie from a named truth.
//!
//! An experiment is methods × a parameter. For each method a sweep over the parameter yields a [`Series`]; each of its
//! [`Point`]s knows the time and the counted work, the error against the truth, and the failures, which are
//! no errors: an answer that is missing cannot be averaged. Speed is kept in two currencies, because seconds change
//! from run to run and counts do not; the CSV writers in [`record`](counts_csv) keep them in separate files.

mod clock;
mod ratio;
mod record;
mod spread;
mod tally;
mod tolerance;
mod trend;

pub use clock::{time, time_each, timed};
pub use ratio::{Interleaved, ROUNDS, Ratio, interleaved};
pub use record::{counts_csv, times_csv};
pub use spread::Spread;
pub use tally::Tally;
pub use tolerance::{Z, agrees, promised, quantised, rounding, statistical, truncation};
pub use trend::{Slope, log_slope, pareto};

/// What a method is in a comparison; the figures draw each role its own way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// The method the library uses unless told otherwise.
    Default,
    /// A formula exactly as a document prints it, errata and all.
    AsPrinted,
    /// Any other contestant.
    #[default]
    Other,
}

/// A contestant: its name, its role, and the style it keeps in every figure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Method {
    pub name: String,
    pub role: Role,
    /// Which colour, mark and dash of the palette; `None` takes the next free one in the figure.
    pub style: Option<usize>,
}

impl Method {
    pub fn new(name: &str) -> Self {
        Method { name: name.to_string(), role: Role::Other, style: None }
    }
    /// The library's own choice: drawn heavier, and named "(default)".
    pub fn default_of(name: &str) -> Self {
        Method { role: Role::Default, ..Method::new(name) }
    }
    /// A formula as a document prints it: always dashed vermillion.
    pub fn as_printed(name: &str) -> Self {
        Method { role: Role::AsPrinted, ..Method::new(name) }
    }
    /// The same method in its fixed style.
    pub fn styled(mut self, style: usize) -> Self {
        self.style = Some(style);
        self
    }
}

impl From<&str> for Method {
    fn from(name: &str) -> Self {
        Method::new(name)
    }
}

/// Answers that cannot be averaged, out of `of` questions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Failures {
    /// The truth has an answer and the method gave none.
    pub missed: u64,
    /// The truth has none and the method gave one.
    pub false_hits: u64,
    /// The method answered NaN or an infinity.
    pub nan: u64,
    /// Questions asked.
    pub of: u64,
}

impl Failures {
    /// All failures together.
    pub fn total(&self) -> u64 {
        self.missed + self.false_hits + self.nan
    }
    /// Failures per question, in `[0,1]`; 0 if nothing was asked.
    pub fn share(&self) -> f64 {
        if self.of == 0 { 0.0 } else { self.total() as f64 / self.of as f64 }
    }
    pub fn plus(&self, other: &Failures) -> Failures {
        Failures {
            missed: self.missed + other.missed,
            false_hits: self.false_hits + other.false_hits,
            nan: self.nan + other.nan,
            of: self.of + other.of,
        }
    }
}

/// One repetition: what it took, and how wrong it was.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Run {
    /// Time of this repetition \[s\].
    pub time: Option<f64>,
    /// Error of this repetition, in the unit of the series.
    pub error: Option<f64>,
}

/// A method at one value of the parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// The value of the swept parameter: samples, distance over radius, …
    pub parameter: f64,
    /// Time per answer \[s\].
    pub time: Option<Spread>,
    /// Counted work per answer: rays, evaluations, visits.
    pub work: Option<f64>,
    /// Error against the truth.
    pub error: Option<Spread>,
    pub failures: Failures,
    /// The repetitions behind the medians.
    pub runs: Vec<Run>,
}

impl Point {
    pub fn at(parameter: f64) -> Self {
        Point { parameter, ..Point::default() }
    }
    pub fn timed(mut self, time: Spread) -> Self {
        self.time = Some(time);
        self
    }
    pub fn worked(mut self, work: f64) -> Self {
        self.work = Some(work);
        self
    }
    pub fn erred(mut self, error: Spread) -> Self {
        self.error = Some(error);
        self
    }
}

/// A method's cost and error along the parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    pub points: Vec<Point>,
}

impl Series {
    pub fn new(points: Vec<Point>) -> Self {
        Series { points }
    }
    /// One point for each value of the parameter.
    pub fn over(parameters: &[f64], point: impl FnMut(f64) -> Point) -> Self {
        Series { points: parameters.iter().copied().map(point).collect() }
    }
    /// The point at exactly this value of the parameter.
    pub fn at(&self, parameter: f64) -> Option<&Point> {
        self.points.iter().find(|p| p.parameter == parameter)
    }
    /// The points from `low` to `high` of the parameter, both included.
    pub fn between(&self, low: f64, high: f64) -> Series {
        Series::new(self.points.iter().filter(|p| (low..=high).contains(&p.parameter)).cloned().collect())
    }
    /// The failures of all points together.
    pub fn failures(&self) -> Failures {
        self.points.iter().fold(Failures::default(), |sum, p| sum.plus(&p.failures))
    }
}

/// `count` parameters from `low` to `high`, evenly spaced on a logarithm; both ends are exact.
///
/// - Domain: `0 < low`, `0 < high`, both finite; one parameter is `low`.
pub fn log_spaced(low: f64, high: f64, count: usize) -> Vec<f64> {
    debug_assert!(low > 0.0 && high > 0.0 && (low * high).is_finite(), "from {low} to {high}");
    let last = count.saturating_sub(1);
    let at = |i: usize| match i {
        0 => low,
        i if i == last => high,
        i => low * (high / low).powf(i as f64 / last as f64),
    };
    (0..count).map(at).collect()
}

/// Runs an estimator `repetitions` times at each budget, and measures its time and its error against `truth`.
///
/// The error of one run is `|x − truth| / |truth|`, or `|x − truth|` if the truth is 0. A point's error is the root
/// mean square over its runs, with the standard error of that root as spread; its time is the median with its
/// quartiles; its counted work is the budget. A run that answers NaN or an infinity is counted as a failure.
///
/// - Domain: `estimate(budget, run)` is a function of its arguments, so that the errors repeat.
pub fn sweep<B: Copy + Into<f64>>(
    budgets: &[B],
    repetitions: u32,
    truth: f64,
    mut estimate: impl FnMut(B, u32) -> f64,
) -> Series {
    let mut points = Vec::with_capacity(budgets.len());
    for &budget in budgets {
        let mut tally = Tally::new();
        for run in 0..repetitions {
            let (seconds, answer) = timed(|| estimate(budget, run));
            tally.timed_answer(seconds, answer, truth);
        }
        let mut point = tally.rms_at(budget.into());
        point.work = Some(budget.into());
        points.push(point);
    }
    Series { points }
}
