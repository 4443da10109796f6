//! A method's line: its points in the chart's quantities, and its colour, mark and dash.

use super::Quantity;
use crate::figure::drawing::{Drawing, Fill, Stroke};
use crate::figure::font;
use crate::figure::ink::{Hue, Ink, METHOD_HUES};
use crate::measure::{Failures, Method, Point, Role, Series, Spread};
use glam::{DVec2, dvec2};
use std::f64::consts::{FRAC_PI_2, TAU};

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Line and marks.
    Marked,
    /// A line alone.
    Smooth,
    /// Marks alone.
    Dots,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mark {
    Circle,
    Square,
    Triangle,
    Diamond,
    Wedge,
    Hexagon,
    Cross,
}

/// Colour, mark, dash and weight of a method.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    pub hue: Hue,
    mark: Mark,
    dash: &'static [f64],
    pub width: f64,
}

const STYLES: [(Mark, &[f64]); 6] = [
    (Mark::Circle, &[]),
    (Mark::Square, &[14.0, 4.0]),
    (Mark::Triangle, &[3.0, 3.5]),
    (Mark::Diamond, &[14.0, 4.0, 3.0, 4.0]),
    (Mark::Wedge, &[22.0, 5.0]),
    (Mark::Hexagon, &[6.0, 3.0]),
];

impl Look {
    /// The look of a method: its own style, or the free one it is offered. The default is a whole, heavier line.
    pub fn of(method: &Method, free: usize) -> Self {
        if method.role == Role::AsPrinted {
            return Look { hue: Hue::Vermillion, mark: Mark::Cross, dash: &[9.0, 6.0], width: 2.5 };
        }
        let style = method.style.unwrap_or(free);
        let (mark, dash) = STYLES[style % STYLES.len()];
        let is_default = method.role == Role::Default;
        let (width, dash): (f64, &[f64]) = if is_default { (4.0, &[]) } else { (2.5, dash) };
        // A second round keeps the colours apart from the dashes of the first.
        let hue = METHOD_HUES[(style + style / STYLES.len()) % METHOD_HUES.len()];
        Look { hue, mark, dash, width }
    }
    pub fn is_printed(&self) -> bool {
        self.mark == Mark::Cross
    }
    pub fn stroke(&self) -> Stroke {
        Stroke::new(Ink::Line(self.hue), self.width).dashed(self.dash)
    }
    /// The mark, 9 px wide and rimmed by the ground so that it stands off the lines.
    pub fn draw_mark(&self, drawing: &mut Drawing, at: DVec2) {
        let radius = 3.6 + 0.45 * self.width;
        let fill = Some(Fill::new(Ink::Line(self.hue)));
        let rim = Some(Stroke::new(Ink::Ground, 1.4));
        let corners = |n: usize, start: f64, r: f64| -> Vec<DVec2> {
            (0..n).map(|i| at + r * DVec2::from_angle(start + TAU * i as f64 / n as f64)).collect()
        };
        match self.mark {
            Mark::Circle => drawing.circle(at, radius, fill, rim),
            Mark::Square => drawing.polygon(&corners(4, FRAC_PI_2 / 2.0, radius * 1.25), fill, rim),
            Mark::Triangle => drawing.polygon(&corners(3, -FRAC_PI_2, radius * 1.4), fill, rim),
            Mark::Diamond => drawing.polygon(&corners(4, 0.0, radius * 1.35), fill, rim),
            Mark::Wedge => drawing.polygon(&corners(3, FRAC_PI_2, radius * 1.4), fill, rim),
            Mark::Hexagon => drawing.polygon(&corners(6, 0.0, radius * 1.1), fill, rim),
            Mark::Cross => {
                let arm = radius * 0.95;
                for side in [dvec2(arm, arm), dvec2(arm, -arm)] {
                    drawing.line(at - side, at + side, Stroke::new(Ink::Ground, 5.2));
                }
                for side in [dvec2(arm, arm), dvec2(arm, -arm)] {
                    drawing.line(at - side, at + side, Stroke::new(Ink::Line(self.hue), 2.8));
                }
            }
        }
    }
}

/// A line of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// With "(default)" where that is so.
    pub name: String,
    pub look: Look,
    pub shape: Shape,
    /// By growing x, but for a course that turns back.
    pub points: Vec<(Spread, Spread)>,
    pub raw: Vec<(f64, f64)>,
    /// Failures, where the horizontal axis puts them.
    pub failures: Vec<(f64, Failures)>,
    /// Questions asked over all points, those without a failure too.
    pub asked: u64,
    pub is_measured: bool,
}

impl Line {
    /// A measured method, in the order of its series.
    pub fn measured(method: &Method, series: &Series, from: Quantity, to: Quantity, free: usize) -> Self {
        let taken = |p: &Point| take(p, from).zip(take(p, to));
        let points: Vec<(Spread, Spread)> = series.points.iter().filter_map(taken).collect();
        let raw = series.points.iter().flat_map(|p| {
            p.runs.iter().filter_map(move |run| {
                let of = |q| match q {
                    Quantity::Time => run.time,
                    Quantity::Error => run.error,
                    _ => take(p, q).map(|s| s.mid),
                };
                of(from).zip(of(to))
            })
        });
        let failed = |p: &&Point| p.failures.total() > 0 && to != Quantity::FailureShare;
        let failures =
            series.points.iter().filter(failed).filter_map(|p| Some((take(p, from)?.mid, p.failures)));
        Line {
            name: named(method),
            look: Look::of(method, free),
            shape: Shape::Marked,
            points,
            raw: raw.collect(),
            failures: failures.collect(),
            asked: series.points.iter().map(|p| p.failures.of).sum(),
            is_measured: true,
        }
    }

    pub fn plain(method: &Method, points: &[(f64, f64)], shape: Shape, free: usize) -> Self {
        let points = points.iter().map(|&(x, y)| (Spread::exact(x), Spread::exact(y))).collect();
        Line {
            name: named(method),
            look: Look::of(method, free),
            // A function runs its course in the order given, which may turn back.
            points: if shape == Shape::Marked { sorted(points) } else { points },
            shape,
            raw: Vec::new(),
            failures: Vec::new(),
            asked: 0,
            is_measured: false,
        }
    }

    /// All failures, out of all that was asked.
    pub fn total_failures(&self) -> Failures {
        let failed = self.failures.iter().fold(Failures::default(), |sum, (_, f)| sum.plus(f));
        Failures { of: self.asked, ..failed }
    }
}

fn sorted(mut points: Vec<(Spread, Spread)>) -> Vec<(Spread, Spread)> {
    points.sort_by(|a, b| a.0.mid.total_cmp(&b.0.mid));
    points
}

fn named(method: &Method) -> String {
    let name = if method.name.trim().is_empty() { "unnamed" } else { method.name.trim() };
    match method.role {
        Role::Default if !name.contains("(default)") => format!("{name} (default)"),
        _ => name.to_string(),
    }
}

fn take(point: &Point, quantity: Quantity) -> Option<Spread> {
    match quantity {
        Quantity::Time => point.time,
        Quantity::Work => point.work.map(Spread::exact),
        Quantity::Parameter => Some(Spread::exact(point.parameter)),
        Quantity::Error => point.error,
        Quantity::FailureShare => Some(Spread::exact(point.failures.share())),
    }
}

/// The points of plain curves as CSV.
pub fn plain_csv(lines: &[&Line]) -> String {
    let mut text = String::from("line,x,y\n");
    for line in lines {
        let name = font::plain(&line.name).replace('"', "\"\"");
        for (x, y) in &line.points {
            text += &format!("\"{name}\",{:e},{:e}\n", x.mid, y.mid);
        }
    }
    text
}
