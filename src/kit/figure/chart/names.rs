//! Direct labels: every line's name beside it, in its colour.

use super::line::{Line, Shape};
use super::plot::Plot;
use super::{Chart, GuideKind};
use crate::figure::axis::Scale;
use crate::figure::drawing::{Drawing, Face, Rect, Stroke, Text};
use crate::figure::font;
use crate::figure::heading::SIZE;
use crate::figure::ink::Ink;
use crate::figure::label::{Candidate, Placer, pushed_apart};
use glam::{DVec2, dvec2};

/// Widest label that gets a margin of its own [px].
const WIDEST: f64 = 200.0;
/// Space between a line's end and its name [px].
const GAP: f64 = 20.0;

/// Room to the right of the plot: as wide as the names, if most lines end at the right edge.
pub fn margin(chart: &Chart) -> f64 {
    let ends: Vec<f64> = chart.lines.iter().filter_map(|l| last_share(chart, l)).collect();
    let at_edge = ends.iter().filter(|e| **e > 0.8).count();
    let widest = chart.lines.iter().flat_map(|l| folded(&l.name)).map(|n| width(&n)).fold(0.0, f64::max);
    if at_edge * 2 >= ends.len().max(1) { widest + GAP + 12.0 } else { 24.0 }
}

/// How far right a line ends, as a share of what all lines span.
fn last_share(chart: &Chart, line: &Line) -> Option<f64> {
    let map = |v: f64| if chart.x.scale == Scale::Log { v.log10() } else { v };
    let xs = |l: &Line| l.points.iter().map(|p| map(p.0.mid)).filter(|v| v.is_finite()).collect::<Vec<_>>();
    let all: Vec<f64> = chart.lines.iter().flat_map(xs).collect();
    let (low, high) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
    let last = xs(line).into_iter().reduce(f64::max)?;
    Some(if high > low { (last - low) / (high - low) } else { 1.0 })
}

/// A name on as many lines as the margin asks for.
fn folded(name: &str) -> Vec<String> {
    font::wrapped(name, Face::Regular, SIZE, WIDEST)
}

fn width(name: &str) -> f64 {
    font::width(name, Face::Regular, SIZE)
}

/// Writes the names of lines and guides.
pub fn draw(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer, front: &[DVec2]) {
    let (dots, joined): (Vec<&Line>, Vec<&Line>) =
        plot.chart.lines.iter().partition(|l| l.shape == Shape::Dots);
    for line in joined {
        let points = plot.points_of(line);
        placer.avoid(&points, line.look.width + 4.0);
        if line.shape == Shape::Marked {
            points.iter().for_each(|p| placer.keep_clear(Rect { min: *p - 6.0, max: *p + 6.0 }));
        }
    }
    for guide in &plot.chart.guides {
        placer.avoid(&plot.guide_points(guide.kind), 2.0);
    }
    // A note belongs close to its place, even among dots.
    notes(plot, drawing, placer);
    for p in dots.into_iter().flat_map(|line| plot.points_of(line)) {
        placer.keep_clear(Rect { min: p - 3.0, max: p + 3.0 });
    }
    guide_names(plot, drawing, placer);
    line_names(plot, drawing, placer);
    front_name(plot, drawing, placer, front);
}

fn line_names(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer) {
    let mut outside: Vec<(&Line, DVec2)> = Vec::new();
    let mut missing: Vec<&Line> = Vec::new();
    let has_margin = plot.outer.max.x - plot.area.max.x > 60.0;
    for line in &plot.chart.lines {
        let points = plot.points_of(line);
        let Some(end) = points.iter().copied().reduce(|a, b| if b.x > a.x { b } else { a }) else {
            missing.push(line);
            continue;
        };
        if has_margin && end.x > plot.area.max.x - 0.2 * plot.area.width() {
            outside.push((line, end));
        }
    }
    beside(plot, drawing, placer, &outside);
    for line in &plot.chart.lines {
        let is_outside = outside.iter().any(|(l, _)| std::ptr::eq(*l, line));
        let is_missing = missing.iter().any(|l| std::ptr::eq(*l, line));
        if !is_outside && !is_missing {
            among(plot, drawing, placer, line);
        }
    }
    for (i, line) in missing.iter().enumerate() {
        let at = dvec2(plot.area.min.x + 16.0, plot.area.min.y + 24.0 + i as f64 * SIZE * 1.3);
        let text = format!("{}: nothing to show", line.name);
        drawing.text(Text::new(at, text, SIZE, Ink::Label(line.look.hue)).halo(3.5));
    }
}

/// Names in the right margin, pushed apart, with a leader where they had to move.
fn beside(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer, lines: &[(&Line, DVec2)]) {
    let wanted: Vec<f64> = lines.iter().map(|(_, end)| end.y).collect();
    let folds: Vec<Vec<String>> = lines.iter().map(|(l, _)| folded(&l.name)).collect();
    let heights: Vec<f64> = folds.iter().map(|f| SIZE * (0.1 + 1.15 * f.len() as f64)).collect();
    let (low, high) = (plot.area.min.y - SIZE * 0.5, plot.base);
    let centers = pushed_apart(&wanted, &heights, low, high);
    for (((line, end), y), fold) in lines.iter().zip(centers).zip(folds) {
        let moved = (y - end.y).abs() > SIZE * 0.45;
        let from_edge = plot.area.max.x - end.x;
        let at = dvec2(plot.area.max.x + GAP, y);
        if moved || from_edge > 14.0 {
            let start = *end + dvec2(if line.shape == Shape::Marked { 8.0 } else { 3.0 }, 0.0);
            let stroke = Stroke::new(Ink::Line(line.look.hue), 1.1).faint(0.75);
            drawing.chain(&[start, at - dvec2(4.0, 0.0)], stroke);
        }
        let first = y - SIZE * 1.15 * (fold.len() as f64 - 1.0) / 2.0 + SIZE * 0.35;
        for (i, words) in fold.into_iter().enumerate() {
            let baseline = dvec2(at.x, first + SIZE * 1.15 * i as f64);
            let text = Text::new(baseline, words, SIZE, Ink::Label(line.look.hue)).halo(3.0);
            placer.keep_clear(text.bounds());
            drawing.text(text);
        }
    }
}

/// A name inside the plot, beside its line where nothing else is; with a leader if it stands off.
fn among(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer, line: &Line) {
    let points = plot.points_of(line);
    let (w, h) = (width(&line.name), SIZE);
    let last = points.len().saturating_sub(1);
    let mut candidates = Vec::new();
    let mut anchors = Vec::new();
    for (i, p) in points.iter().enumerate() {
        // Ends are read first; the middle of a line is the next best place.
        let from_end = if i == last {
            0.0
        } else if i == 0 {
            12.0
        } else {
            20.0
        };
        for (near, distance) in [(0.0, 13.0), (14.0, 26.0), (45.0, 48.0), (90.0, 80.0), (150.0, 120.0)] {
            for step in 0..16 {
                let way = DVec2::from_angle(std::f64::consts::TAU * f64::from(step) / 16.0);
                // The box touches a circle round the point: half its size beyond the distance.
                let center = *p + way * distance + dvec2(way.x * w / 2.0, way.y * h / 2.0);
                let half = dvec2(w / 2.0, h / 2.0);
                let place = Rect { min: center - half, max: center + half }.grown(2.0);
                let aside = if way.y.abs() < 0.1 { 0.0 } else { 3.0 };
                candidates.push(Candidate { place, penalty: from_end + near + aside });
                anchors.push(*p);
            }
        }
    }
    let Some((best, _)) = placer.place(&candidates) else { return };
    let place = candidates[best].place;
    let anchor = anchors[best];
    let near = anchor.clamp(place.min, place.max);
    if anchor.distance(near) > 16.0 {
        let ahead = (near - anchor).normalize_or_zero();
        drawing.line(
            anchor + ahead * 8.0,
            near - ahead * 2.0,
            Stroke::new(Ink::Line(line.look.hue), 1.1).faint(0.75),
        );
    }
    let at = dvec2(place.min.x + 2.0, place.center().y + SIZE * 0.35);
    drawing.text(Text::new(at, &line.name, SIZE, Ink::Label(line.look.hue)).halo(3.5));
}

/// Words beside single places, as near as there is room; none outside the axes.
fn notes(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer) {
    let size = SIZE * 0.85;
    for (x, y, words) in &plot.chart.notes {
        let Some(p) = plot.at(*x, *y) else { continue };
        let half = dvec2(font::width(words, Face::Regular, size) / 2.0, size / 2.0);
        let mut candidates = Vec::new();
        for (penalty, distance) in [(0.0, 9.0), (10.0, 16.0), (30.0, 28.0), (60.0, 44.0), (90.0, 64.0)] {
            for step in 0..16 {
                let way = DVec2::from_angle(std::f64::consts::TAU * f64::from(step) / 16.0);
                let center = p + way * (half + distance);
                let place = Rect { min: center - half, max: center + half };
                let beyond = if plot.area.covers(&place) { 0.0 } else { 400.0 };
                candidates.push(Candidate { place, penalty: penalty + beyond });
            }
        }
        let Some((best, _)) = placer.place(&candidates) else { continue };
        let place = candidates[best].place;
        let near = p.clamp(place.min, place.max);
        if p.distance(near) > 16.0 {
            let ahead = (near - p).normalize_or_zero();
            drawing.line(p + ahead * 8.0, near - ahead * 2.0, Stroke::new(Ink::Muted, 1.1).faint(0.75));
        }
        let at = dvec2(place.min.x, place.center().y + size * 0.35);
        drawing.text(Text::new(at, words, size, Ink::Text).halo(3.0));
    }
}

/// Names along the guides, on the first free stretch.
fn guide_names(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer) {
    let size = SIZE * 0.9;
    for guide in &plot.chart.guides {
        let points = plot.guide_points(guide.kind);
        let [a, b] = points[..] else { continue };
        let w = font::width(&guide.label, Face::Italic, size);
        let half = dvec2(w / 2.0, size / 2.0);
        let mut candidates = Vec::new();
        for k in 0..=30 {
            let share = 0.02 + 0.96 * f64::from(k) / 30.0;
            let p = a.lerp(b, if matches!(guide.kind, GuideKind::Upright(_)) { share } else { 1.0 - share });
            let along = (b - a).normalize_or_zero();
            let across = dvec2(along.y, -along.x);
            for side in [1.0, -1.0] {
                let off = across.x.abs() * half.x + across.y.abs() * half.y + 5.0;
                let center = p + across * side * off;
                let place = Rect { min: center - half, max: center + half };
                let beyond = if plot.area.covers(&place) { 0.0 } else { 400.0 };
                candidates.push(Candidate {
                    place,
                    penalty: beyond + share * 20.0 + if side < 0.0 { 2.0 } else { 0.0 },
                });
            }
        }
        if let Some((best, _)) = placer.place(&candidates) {
            let place = candidates[best].place;
            let at = dvec2(place.min.x, place.center().y + size * 0.3);
            drawing.text(Text::new(at, &guide.label, size, Ink::Muted).face(Face::Italic).halo(3.0));
        }
    }
}

/// Says once what the step line is.
fn front_name(plot: &Plot, drawing: &mut Drawing, placer: &mut Placer, front: &[DVec2]) {
    let size = SIZE * 0.8;
    let half = dvec2(font::width("Pareto front", Face::Italic, size) / 2.0, size / 2.0);
    let mut candidates = Vec::new();
    for pair in front.windows(2) {
        for k in 1..8 {
            let p = pair[0].lerp(pair[1], f64::from(k) / 8.0);
            for way in [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y] {
                let center = p + way * (half + 5.0);
                candidates
                    .push(Candidate { place: Rect { min: center - half, max: center + half }, penalty: 0.0 });
            }
        }
    }
    candidates.retain(|c| plot.area.covers(&c.place));
    // A name that would cover something is better left out: the line is the same in every chart.
    let Some((best, cost)) = placer.best(&candidates) else { return };
    if cost < 8.0 {
        let place = candidates[best].place;
        placer.keep_clear(place);
        let at = dvec2(place.min.x, place.center().y + size * 0.3);
        drawing.text(Text::new(at, "Pareto front", size, Ink::Muted).face(Face::Italic).halo(3.0));
    }
}
