//! Charts: one quantity against another, a line for each method.
//!
//! The title is the finding. Every method keeps its colour, mark and dash; labels stand at the lines' ends; raw runs are
//! faint dots, spreads are bands; zero errors lie on a strip named "exact" and failures are counted on one of their
//! own; theory is a dotted line with its name.

mod line;
mod multiples;
mod names;
mod plot;
mod strips;

pub(super) use line::Look;
use line::{Line, Shape};

use super::axis::Axis;
use super::heading::{HEIGHT, Heading, MARGIN, WIDTH};
use super::{Data, Drawing, Figure, Repeats};
use crate::measure::{Method, Point, Series, counts_csv, times_csv};
use plot::Plot;

/// Lines in one plot; more become small multiples.
const MOST_LINES: usize = 6;

/// What a chart takes from a [`Point`] of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    Time,
    Work,
    Parameter,
    Error,
    FailureShare,
}

/// What theory says.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    kind: GuideKind,
    label: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum GuideKind {
    Level(f64),
    Upright(f64),
    Slope { slope: f64, through: Option<(f64, f64)> },
}

impl Guide {
    /// A horizontal line: machine epsilon, one pixel.
    pub fn level(y: f64, label: &str) -> Self {
        Guide { kind: GuideKind::Level(y), label: label.to_string() }
    }
    /// A vertical line.
    pub fn upright(x: f64, label: &str) -> Self {
        Guide { kind: GuideKind::Upright(x), label: label.to_string() }
    }
    /// `y ∝ x^slope` on logarithmic axes (`y = slope · x + …` on linear ones), a little below the data.
    pub fn slope(slope: f64, label: &str) -> Self {
        Guide { kind: GuideKind::Slope { slope, through: None }, label: label.to_string() }
    }
    /// The same through a given point.
    pub fn slope_through(slope: f64, x: f64, y: f64, label: &str) -> Self {
        Guide { kind: GuideKind::Slope { slope, through: Some((x, y)) }, label: label.to_string() }
    }
}

/// A chart under construction.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    heading: Heading,
    x: Axis,
    y: Axis,
    sources: (Quantity, Quantity),
    /// Which way is better, in words, if the chart has such a way.
    better: Option<String>,
    lines: Vec<Line>,
    guides: Vec<Guide>,
    /// Words beside single places.
    notes: Vec<(f64, f64, String)>,
    series: Vec<(Method, Series)>,
}

impl Chart {
    /// Error against measured time: the headline chart.
    pub fn speed_accuracy(error: &str) -> Self {
        let mut chart =
            Chart::with(Axis::time("time per answer"), Axis::log(error), Quantity::Time, Quantity::Error);
        chart.better = Some("↙ faster and more accurate".to_string());
        chart
    }
    /// Error against counted work: rays, evaluations, visits.
    pub fn work_accuracy(work: &str, error: &str) -> Self {
        let mut chart = Chart::with(Axis::log(work), Axis::log(error), Quantity::Work, Quantity::Error);
        chart.better = Some("↙ less work, more accurate".to_string());
        chart
    }
    /// Error over the swept parameter, the axis of difficulty.
    pub fn error_over(parameter: Axis, error: &str) -> Self {
        Chart::with(parameter, Axis::log(error), Quantity::Parameter, Quantity::Error)
    }
    /// Time over the swept parameter.
    pub fn time_over(parameter: Axis, time: &str) -> Self {
        Chart::with(parameter, Axis::time(time), Quantity::Parameter, Quantity::Time)
    }
    /// Counted work over the swept parameter.
    pub fn work_over(parameter: Axis, work: &str) -> Self {
        Chart::with(parameter, Axis::log(work), Quantity::Parameter, Quantity::Work)
    }
    /// Share of failures over the swept parameter.
    pub fn failures_over(parameter: Axis, share: &str) -> Self {
        Chart::with(parameter, Axis::percent(share), Quantity::Parameter, Quantity::FailureShare)
    }
    /// Any two axes, for curves and dots.
    pub fn new(x: Axis, y: Axis) -> Self {
        Chart::with(x, y, Quantity::Parameter, Quantity::Error)
    }

    fn with(x: Axis, y: Axis, from: Quantity, to: Quantity) -> Self {
        Chart {
            heading: Heading::default(),
            x,
            y,
            sources: (from, to),
            better: None,
            lines: Vec::new(),
            guides: Vec::new(),
            notes: Vec::new(),
            series: Vec::new(),
        }
    }

    /// The finding, in one short sentence.
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    /// What was measured, on what, with which seed.
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    /// Replaces the horizontal axis.
    pub fn x(mut self, axis: Axis) -> Self {
        self.x = axis;
        self
    }
    /// Replaces the vertical axis.
    pub fn y(mut self, axis: Axis) -> Self {
        self.y = axis;
        self
    }
    /// Says which way is better: "↓ fewer misses".
    pub fn better(mut self, way: &str) -> Self {
        self.better = Some(way.to_string());
        self
    }
    pub fn guide(mut self, guide: Guide) -> Self {
        self.guides.push(guide);
        self
    }

    /// A measured method; its points are joined in the order of the parameter, whatever the axes measure.
    pub fn line(self, method: impl Into<Method>, series: &Series) -> Self {
        let mut ordered = series.clone();
        ordered.points.sort_by(|a, b| a.parameter.total_cmp(&b.parameter));
        self.measured(method.into(), &ordered, |line| line)
    }
    /// All methods of a comparison.
    pub fn lines<'a>(self, all: impl IntoIterator<Item = (&'a Method, &'a Series)>) -> Self {
        all.into_iter().fold(self, |chart, (method, series)| chart.line(method.clone(), series))
    }
    /// A measured method whose points follow each other in the order given, wherever that leads.
    pub fn steps(self, method: impl Into<Method>, series: &Series) -> Self {
        self.measured(method.into(), series, |line| line)
    }
    /// A measured method whose points have no order: dots that are not joined.
    pub fn scatter(self, method: impl Into<Method>, series: &Series) -> Self {
        self.measured(method.into(), series, |line| Line { shape: Shape::Dots, ..line })
    }
    fn measured(mut self, method: Method, series: &Series, finish: fn(Line) -> Line) -> Self {
        let (from, to) = self.sources;
        self.lines.push(finish(Line::measured(&method, series, from, to, self.next_style())));
        self.series.push((method, series.clone()));
        self
    }
    /// Words beside a place of the plot.
    pub fn note(mut self, x: f64, y: f64, words: &str) -> Self {
        self.notes.push((x, y, words.to_string()));
        self
    }
    /// Plain points, joined by a line with marks.
    pub fn curve(mut self, method: impl Into<Method>, points: &[(f64, f64)]) -> Self {
        self.lines.push(Line::plain(&method.into(), points, Shape::Marked, self.next_style()));
        self
    }
    /// A function: a line without marks.
    pub fn function(mut self, method: impl Into<Method>, points: &[(f64, f64)]) -> Self {
        self.lines.push(Line::plain(&method.into(), points, Shape::Smooth, self.next_style()));
        self
    }
    /// Plain points, not joined.
    pub fn dots(mut self, method: impl Into<Method>, points: &[(f64, f64)]) -> Self {
        self.lines.push(Line::plain(&method.into(), points, Shape::Dots, self.next_style()));
        self
    }

    /// The next free style; those as printed have theirs.
    fn next_style(&self) -> usize {
        self.lines.iter().filter(|l| !l.look.is_printed()).count()
    }

    /// Draws the chart.
    pub fn draw(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let top = self.heading.draw(&mut drawing);
        if self.lines.len() > MOST_LINES {
            multiples::draw(self, &mut drawing, top);
        } else {
            Plot::layout(self, &drawing, top).draw(&mut drawing);
        }
        drawing
    }

    /// What the chart shows, in words.
    fn alt(&self) -> String {
        let names: Vec<&str> = self.lines.iter().map(|l| l.name.as_str()).collect();
        let lines = if names.is_empty() { "no lines".to_string() } else { names.join("; ") };
        format!("{}. Chart of {} against {}: {lines}.", self.heading.sentence(), self.y.title, self.x.title)
    }

    fn data(&self) -> Vec<Data> {
        let series: Vec<(&Method, &Series)> = self.series.iter().map(|(m, s)| (m, s)).collect();
        let any_time = |p: &Point| p.time.is_some();
        let mut data = Vec::new();
        if !series.is_empty() {
            data.push(Data { repeats: Repeats::Always, csv: counts_csv(&series) });
        }
        if series.iter().any(|(_, s)| s.points.iter().any(any_time)) {
            data.push(Data { repeats: Repeats::Timed, csv: times_csv(&series) });
        }
        let plain: Vec<&Line> = self.lines.iter().filter(|l| !l.is_measured).collect();
        if series.is_empty() && !plain.is_empty() {
            data.push(Data { repeats: Repeats::Always, csv: line::plain_csv(&plain) });
        }
        data
    }

    fn left(&self) -> f64 {
        MARGIN
    }
}

impl From<Chart> for Figure {
    fn from(chart: Chart) -> Figure {
        let mut figure = Figure::new(chart.draw(), &chart.heading.title, &chart.alt());
        figure.caption = chart.heading.caption();
        figure.data = chart.data();
        let timed = chart.sources.0 == Quantity::Time || chart.sources.1 == Quantity::Time;
        figure.repeats = if timed && !chart.series.is_empty() { Repeats::Timed } else { Repeats::Always };
        figure
    }
}
