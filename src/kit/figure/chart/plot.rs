//! The plot: axes, lines, bands and dots in their rectangle.

use super::line::{Line, Shape};
use super::{Chart, GuideKind, Quantity, names, strips};
use crate::figure::axis::{Ruler, Scale};
use crate::figure::drawing::{Anchor, Drawing, Face, Fill, Rect, Stroke, Text};
use crate::figure::font;
use crate::figure::heading::{MARGIN, SIZE};
use crate::figure::ink::Ink;
use crate::figure::label::Placer;
use crate::measure::{Spread, pareto};
use glam::{DVec2, dvec2};

/// A chart laid out in a rectangle of the canvas.
pub struct Plot<'a> {
    pub chart: &'a Chart,
    /// Where the lines run.
    pub area: Rect,
    pub x: Ruler,
    pub y: Ruler,
    /// Height of the middle of the strip of zero errors.
    pub exact: Option<f64>,
    /// Top of the rows of failures, and of the axis below everything.
    pub failed: f64,
    pub base: f64,
    pub outer: Rect,
}

const EXACT_STRIP: f64 = 34.0;

/// Small multiples write the numbers once for a row or column of panels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ticks {
    Written,
    Bare,
}

impl<'a> Plot<'a> {
    pub fn layout(chart: &'a Chart, drawing: &Drawing, top: f64) -> Self {
        let outer = Rect::new(chart.left(), top, drawing.width - MARGIN, drawing.height - MARGIN + 12.0);
        Plot::within(chart, outer, names::margin(chart))
    }

    /// Lays out inside `outer`, with `margin` pixels on the right for the labels of lines.
    pub fn within(chart: &'a Chart, outer: Rect, margin: f64) -> Self {
        let any_zero =
            chart.y.scale == Scale::Log && chart.lines.iter().any(|l| l.points.iter().any(is_exact));
        let rows = chart.lines.iter().filter(|l| !l.failures.is_empty()).count() as f64;
        let failures = if rows > 0.0 { rows * strips::ROW + 12.0 } else { 0.0 };
        let base = outer.max.y - 2.6 * SIZE;
        let bottom = base - failures - if any_zero { EXACT_STRIP + 8.0 } else { 0.0 };
        let area_top = outer.min.y + 1.6 * SIZE;
        let y_values = || chart.lines.iter().flat_map(|l| l.points.iter().map(|p| p.1)).flat_map(ends);
        let raw_y = chart.lines.iter().flat_map(|l| l.raw.iter().map(|r| r.1));
        let levels = chart.guides.iter().filter_map(|g| match g.kind {
            GuideKind::Level(y) => Some(y),
            _ => None,
        });
        let y = chart.y.ruler(y_values().chain(raw_y).chain(levels), bottom, area_top);
        let widest = y.ticks().iter().map(|t| font::width(&t.1, Face::Regular, SIZE)).fold(0.0, f64::max);
        let strip_names =
            if any_zero || rows > 0.0 { font::width("exact", Face::Regular, SIZE) } else { 0.0 };
        let left = outer.min.x + widest.max(strip_names) + 14.0;
        let x_values = || chart.lines.iter().flat_map(|l| l.points.iter().map(|p| p.0)).flat_map(ends);
        let raw_x = chart.lines.iter().flat_map(|l| l.raw.iter().map(|r| r.0));
        let upright = chart.guides.iter().filter_map(|g| match g.kind {
            GuideKind::Upright(x) => Some(x),
            _ => None,
        });
        let right = outer.max.x - margin;
        let x = chart.x.ruler(x_values().chain(raw_x).chain(upright), left, right);
        let area = Rect::new(left, area_top, right, bottom);
        let exact = any_zero.then_some(bottom + 8.0 + EXACT_STRIP / 2.0);
        let failed = bottom + if any_zero { EXACT_STRIP + 8.0 } else { 0.0 } + 8.0;
        Plot { chart, area, x, y, exact, failed, base, outer }
    }

    pub fn draw(&self, drawing: &mut Drawing) {
        self.axes(drawing);
        self.titles(drawing);
        let floor = self.exact.map_or(self.area.max.y - 2.0, |y| y + 17.0);
        let room = Rect::new(self.area.min.x + 6.0, self.area.min.y + 4.0, self.outer.max.x, floor);
        let mut placer = Placer::new(room);
        self.guides(drawing);
        drawing.clipped(self.area.grown(1.0), |d| self.bands(d));
        let front = self.front(drawing, &mut placer);
        for line in &self.chart.lines {
            self.line(drawing, line);
        }
        for line in &self.chart.lines {
            self.marks(drawing, line);
        }
        strips::failures(self, drawing);
        names::draw(self, drawing, &mut placer, &front);
    }

    /// The pixel of a point; zero errors lie on their strip.
    pub fn at(&self, x: f64, y: f64) -> Option<DVec2> {
        let px = self.x.inside(x)?;
        if y == 0.0 && self.exact.is_some() {
            return Some(dvec2(px, self.exact?));
        }
        Some(dvec2(px, self.y.inside(y)?))
    }

    pub fn axes(&self, drawing: &mut Drawing) {
        self.vertical(drawing, Ticks::Written);
        self.horizontal(drawing, Ticks::Written);
    }

    pub fn vertical(&self, drawing: &mut Drawing, ticks: Ticks) {
        let grid = || Stroke::new(Ink::Grid, 1.2);
        let axis = || Stroke::new(Ink::Outline, 1.4);
        for (value, label) in self.y.ticks() {
            let Some(y) = self.y.inside(value) else { continue };
            drawing.line(dvec2(self.area.min.x, y), dvec2(self.area.max.x, y), grid());
            let at = dvec2(self.area.min.x - 10.0, y + SIZE * 0.35);
            if ticks == Ticks::Written {
                drawing.text(Text::new(at, label, SIZE, Ink::Muted).anchor(Anchor::End));
            }
        }
        for value in self.y.minor() {
            let Some(y) = self.y.inside(value) else { continue };
            drawing.line(dvec2(self.area.min.x - 3.5, y), dvec2(self.area.min.x, y), axis());
        }
        drawing.line(
            dvec2(self.area.min.x, self.area.min.y),
            dvec2(self.area.min.x, self.area.max.y),
            axis(),
        );
        if let Some(y) = self.exact {
            strips::exact(self, drawing, y, ticks);
        }
    }

    pub fn horizontal(&self, drawing: &mut Drawing, ticks: Ticks) {
        let grid = || Stroke::new(Ink::Grid, 1.2);
        let axis = || Stroke::new(Ink::Outline, 1.4);
        let mut written = f64::NEG_INFINITY;
        for (value, label) in self.x.ticks() {
            let Some(x) = self.x.inside(value) else { continue };
            drawing.line(dvec2(x, self.area.min.y), dvec2(x, self.base), grid());
            drawing.line(dvec2(x, self.base), dvec2(x, self.base + 6.0), axis());
            let at = dvec2(x, self.base + 8.0 + SIZE * 0.85);
            let text = Text::new(at, label, SIZE, Ink::Muted).anchor(Anchor::Middle);
            if ticks == Ticks::Written && text.bounds().min.x > written + 8.0 {
                written = text.bounds().max.x;
                drawing.text(text);
            }
        }
        for value in self.x.minor() {
            let Some(x) = self.x.inside(value) else { continue };
            drawing.line(dvec2(x, self.base), dvec2(x, self.base + 3.5), axis());
        }
        drawing.line(dvec2(self.area.min.x, self.base), dvec2(self.area.max.x, self.base), axis());
    }

    /// The vertical axis' title above it, where it reads level; the horizontal one's below its right end.
    fn titles(&self, drawing: &mut Drawing) {
        let y = self.outer.min.y + SIZE * 0.75;
        drawing.text(Text::new(dvec2(self.outer.min.x, y), &self.chart.y.title, SIZE, Ink::Text));
        let at = dvec2(self.area.max.x, self.outer.max.y);
        drawing.text(Text::new(at, &self.chart.x.title, SIZE, Ink::Text).anchor(Anchor::End));
        if let Some(way) = &self.chart.better {
            // In the corner it points to, below the axis: nothing is ever drawn there.
            let at = dvec2(self.area.min.x, self.outer.max.y);
            let text = Text::new(at, way, SIZE, Ink::Muted);
            let title = font::width(&self.chart.x.title, Face::Regular, SIZE);
            if text.bounds().max.x + 20.0 < self.area.max.x - title {
                drawing.text(text);
            }
        }
    }

    fn guides(&self, drawing: &mut Drawing) {
        drawing.clipped(self.area, |d| {
            for guide in &self.chart.guides {
                d.chain(&self.guide_points(guide.kind), Stroke::new(Ink::Muted, 1.8).dashed(&[2.0, 5.0]));
            }
        });
    }

    /// The ends of a guide on the canvas; nothing if the axes cannot show it.
    pub fn guide_points(&self, kind: GuideKind) -> Vec<DVec2> {
        let (left, right) = (self.area.min.x, self.area.max.x);
        match kind {
            GuideKind::Level(y) => {
                self.y.inside(y).map_or(Vec::new(), |y| vec![dvec2(left, y), dvec2(right, y)])
            }
            GuideKind::Upright(x) => self
                .x
                .inside(x)
                .map_or(Vec::new(), |x| vec![dvec2(x, self.area.min.y), dvec2(x, self.area.max.y)]),
            GuideKind::Slope { slope, through } => self.slope_points(slope, through),
        }
    }

    fn slope_points(&self, slope: f64, through: Option<(f64, f64)>) -> Vec<DVec2> {
        let axis = |scale: Scale, v: f64| if scale == Scale::Log { v.log10() } else { v };
        // Pixels per unit of each axis (per decade on a logarithm).
        let px = (self.area.max.x - self.area.min.x)
            / (axis(self.x.scale, self.x.high) - axis(self.x.scale, self.x.low));
        let py = (self.area.max.y - self.area.min.y)
            / (axis(self.y.scale, self.y.high) - axis(self.y.scale, self.y.low));
        let fall = -slope * py / px;
        let anchor = match through {
            Some((x, y)) => self.x.at(x).zip(self.y.at(y)).map(|(x, y)| dvec2(x, y)),
            None => self.below_the_data(fall),
        };
        let Some(anchor) = anchor else { return Vec::new() };
        let at = |x: f64| dvec2(x, anchor.y + (x - anchor.x) * fall);
        vec![at(self.area.min.x), at(self.area.max.x)]
    }

    /// A point such that the line of that steepness passes just under the longest line of the data.
    fn below_the_data(&self, fall: f64) -> Option<DVec2> {
        let longest = self.chart.lines.iter().rev().max_by_key(|l| l.points.len())?;
        let points = longest.points.iter();
        let shown = points.filter(|p| p.1.mid != 0.0).filter_map(|p| self.at(p.0.mid, p.1.mid));
        let lowest = shown.max_by(|a, b| (a.y - a.x * fall).total_cmp(&(b.y - b.x * fall)))?;
        Some(lowest + dvec2(0.0, 16.0))
    }

    /// Spread of the errors as bands, of the costs as bars; raw runs as faint dots.
    fn bands(&self, drawing: &mut Drawing) {
        for line in &self.chart.lines {
            let ink = Ink::Line(line.look.hue);
            let mut edges: (Vec<DVec2>, Vec<DVec2>) = (Vec::new(), Vec::new());
            for (x, y) in &line.points {
                let Some(px) = self.x.inside(x.mid) else { continue };
                if let Some((low, high)) = self.y.at(y.low.max(self.y.low.min(y.high))).zip(self.y.at(y.high))
                {
                    edges.0.push(dvec2(px, low));
                    edges.1.push(dvec2(px, high));
                }
            }
            let wide = edges.0.iter().zip(&edges.1).any(|(a, b)| (a.y - b.y).abs() > 1.5);
            if wide && line.shape == Shape::Marked {
                edges.0.extend(edges.1.into_iter().rev());
                drawing.polygon(&edges.0, Some(Fill::new(ink).faint(0.16)), None);
            }
            for at in line.raw.iter().filter_map(|r| self.at(r.0, r.1)) {
                drawing.circle(at, 2.2, Some(Fill::new(ink).faint(0.28)), None);
            }
        }
    }

    fn line(&self, drawing: &mut Drawing, line: &Line) {
        let ink = Ink::Line(line.look.hue);
        if line.shape == Shape::Dots {
            return;
        }
        let points = self.points_of(line);
        let mut drawn: Vec<DVec2> = Vec::new();
        drawing.clipped(self.outer, |d| {
            for pair in points.windows(2) {
                let strip = self.area.max.y + 4.0;
                if (pair[0].y > strip) == (pair[1].y > strip) {
                    drawn.extend((drawn.is_empty()).then_some(pair[0]));
                    drawn.push(pair[1]);
                    continue;
                }
                // Between a number and exactly zero the line is only a hint.
                d.chain(&drawn, line.look.stroke());
                drawn.clear();
                d.line(pair[0], pair[1], Stroke::new(ink, 1.2).faint(0.45));
            }
            d.chain(&drawn, line.look.stroke());
        });
        for (x, y) in &line.points {
            let (Some(at), Some(low), Some(high)) =
                (self.at(x.mid, y.mid), self.x.inside(x.low), self.x.inside(x.high))
            else {
                continue;
            };
            if high - low > 6.0 {
                drawing.line(dvec2(low, at.y), dvec2(high, at.y), Stroke::new(ink, 1.4));
            }
        }
    }

    fn marks(&self, drawing: &mut Drawing, line: &Line) {
        let points = self.points_of(line);
        match line.shape {
            Shape::Smooth => {}
            Shape::Dots => {
                let (radius, opacity) = if points.len() > 400 { (2.0, 0.5) } else { (3.2, 0.8) };
                for at in points {
                    drawing.circle(
                        at,
                        radius,
                        Some(Fill::new(Ink::Line(line.look.hue)).faint(opacity)),
                        None,
                    );
                }
            }
            // Marks closer than their width would be a rope; the line says enough.
            Shape::Marked => {
                let mut last = DVec2::INFINITY;
                for at in points {
                    if at.distance(last) > 7.0 || !last.is_finite() {
                        line.look.draw_mark(drawing, at);
                        last = at;
                    }
                }
            }
        }
    }

    /// The pixels of a line's points that the axes can show.
    pub fn points_of(&self, line: &Line) -> Vec<DVec2> {
        line.points.iter().filter_map(|(x, y)| self.at(x.mid, y.mid)).collect()
    }

    /// The front of undominated points, as a thin step line.
    fn front(&self, drawing: &mut Drawing, placer: &mut Placer) -> Vec<DVec2> {
        let is_trade = matches!(self.chart.sources, (Quantity::Time | Quantity::Work, Quantity::Error));
        let all: Vec<(f64, f64)> = self
            .chart
            .lines
            .iter()
            .filter(|l| l.is_measured)
            .flat_map(|l| l.points.iter().map(|p| (p.0.mid, p.1.mid)))
            .filter(|p| p.0 > 0.0 && p.1 >= 0.0 && self.at(p.0, p.1).is_some())
            .collect();
        if !is_trade || self.chart.lines.len() < 2 {
            return Vec::new();
        }
        let corners: Vec<DVec2> =
            pareto(&all).into_iter().filter_map(|i| self.at(all[i].0, all[i].1)).collect();
        let (Some(first), Some(last)) = (corners.first(), corners.last()) else { return Vec::new() };
        let mut steps = vec![dvec2(first.x, self.area.min.y)];
        for p in &corners {
            steps.extend(steps.last().map(|before| dvec2(p.x, before.y)));
            steps.push(*p);
        }
        steps.push(dvec2(self.area.max.x, last.y));
        steps.dedup();
        drawing.chain(&steps, Stroke::new(Ink::Outline, 1.3));
        placer.avoid(&steps, 1.3);
        steps
    }
}

fn is_exact(point: &(Spread, Spread)) -> bool {
    point.1.mid == 0.0
}

fn ends(spread: Spread) -> [f64; 3] {
    [spread.low, spread.mid, spread.high]
}
