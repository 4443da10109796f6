//! The letters of a ray diagram, each set beside its mark where nothing crosses it.

use super::marks::{self, Mark};
use super::{Diagram, View};
use crate::figure::drawing::{Anchor, Drawing, Face, Rect, Stroke, Text, head_size};
use crate::figure::heading::{MARGIN, SIZE};
use crate::figure::ink::Ink;
use crate::figure::label::{Candidate, Placer};
use glam::{DVec2, dvec2};
use std::f64::consts::TAU;

/// Size of the letters of formulas [px].
const LETTER: f64 = 28.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    Formula,
    Words,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Where {
    Beside,
    AtEnd,
    Here,
}

/// A name and the mark it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Letter {
    pub mark: usize,
    pub text: String,
    pub style: Style,
    pub place: Where,
}

impl Letter {
    fn set(&self, mark: &Mark) -> Text {
        let ink = marks::letter_ink(mark);
        match self.style {
            Style::Formula => Text::new(DVec2::ZERO, &self.text, LETTER, ink).face(Face::Italic).halo(4.0),
            Style::Words => Text::new(DVec2::ZERO, &self.text, SIZE * 1.05, ink).halo(4.0),
        }
    }
}

pub fn draw(diagram: &Diagram, view: &View, window: &Rect, drawing: &mut Drawing) {
    let edge = MARGIN * 0.4;
    let bounds = Rect::new(edge, window.min.y - edge, drawing.width - edge, drawing.height - edge * 0.5);
    let mut placer = Placer::new(bounds);
    for mark in &diagram.marks {
        marks::lines(mark, view).iter().for_each(|chain| placer.avoid(chain, 5.0));
        marks::sign(mark, view).into_iter().for_each(|sign| placer.keep_clear(sign));
        if let Mark::Ray { light, a, b, head: marks::Head::End } = mark {
            let tip = view.at(*b);
            let (reach, half) = head_size(marks::pen(*light).width);
            let back = tip - (tip - view.at(*a)).normalize_or_zero() * reach * 0.6;
            placer.keep_clear(Rect { min: back - half, max: back + half });
        }
    }
    // Marks with few places choose first: points and angles before lines, lines before areas.
    let mut order: Vec<&Letter> = diagram.letters.iter().collect();
    order.sort_by_key(|l| freedom(&diagram.marks[l.mark]));
    let mut texts = Vec::new();
    for letter in order {
        let mark = &diagram.marks[letter.mark];
        let text = letter.set(mark);
        let (mut candidates, anchors) = places(mark, letter, view, window, &text);
        if matches!(mark, Mark::Band { .. }) {
            // The ground ends at the window, and its name with it.
            let inside = Rect { min: window.min + dvec2(8.0, 0.0), max: window.max - dvec2(8.0, -30.0) };
            candidates.iter_mut().filter(|c| !inside.covers(&c.place)).for_each(|c| c.penalty += 1000.0);
        }
        let Some((best, cost)) = placer.place(&candidates) else { continue };
        // Where nothing is near, a rim would only show as a patch on grey.
        let text = Text { halo: if cost > 0.0 { text.halo } else { 0.0 }, ..text };
        let place = candidates[best].place;
        leader(anchors[best], &place, drawing);
        let at = dvec2(place.center().x, place.center().y + text.size * 0.27);
        texts.push(Text { at, anchor: Anchor::Middle, ..text });
    }
    texts.into_iter().for_each(|t| drawing.text(t));
}

fn freedom(mark: &Mark) -> u8 {
    match mark {
        Mark::Nothing { .. } => 0,
        Mark::Angle { .. } | Mark::RightAngle { .. } => 1,
        Mark::Dot { .. } | Mark::Lamp { .. } | Mark::Eye { .. } | Mark::Dimension { .. } => 2,
        Mark::Ray { .. } | Mark::Curve { .. } => 3,
        Mark::Area { .. } | Mark::Band { .. } => 4,
    }
}

/// A thin line from a mark to a letter that had to stand off.
fn leader(anchor: Option<DVec2>, place: &Rect, drawing: &mut Drawing) {
    let Some(anchor) = anchor else { return };
    let near = anchor.clamp(place.min, place.max);
    if anchor.distance(near) > 34.0 {
        let ahead = (near - anchor).normalize_or_zero();
        drawing.line(anchor + ahead * 8.0, near - ahead * 3.0, Stroke::new(Ink::Muted, 1.1));
    }
}

/// Places for a letter, each with the point of the mark it stands beside.
fn places(
    mark: &Mark,
    letter: &Letter,
    view: &View,
    window: &Rect,
    text: &Text,
) -> (Vec<Candidate>, Vec<Option<DVec2>>) {
    // Letters seldom fill the line's height: the box is that of the letters.
    let size = text.bounds();
    let half = dvec2(size.width() / 2.0 + 2.0, text.size * 0.42);
    let mut candidates = Vec::new();
    let mut points = Vec::new();
    let mut push = |center: DVec2, penalty: f64, anchor: Option<DVec2>| {
        candidates.push(Candidate { place: Rect { min: center - half, max: center + half }, penalty });
        points.push(anchor);
    };
    for anchor in anchors(mark, letter, view, window) {
        if anchor.on_it {
            push(anchor.at, anchor.penalty, None);
            continue;
        }
        for (step, near) in
            [(0.0, 0.0), (6.0, 4.0), (14.0, 12.0), (26.0, 26.0), (42.0, 60.0), (64.0, 120.0), (90.0, 200.0)]
        {
            for k in 0..24 {
                let way = DVec2::from_angle(TAU * f64::from(k) / 24.0);
                let off = anchor.clear + step;
                let center = anchor.at + way * off + way * half;
                let against = anchor.way.map_or(0.0, |w| 14.0 * (1.0 - way.dot(w)));
                push(center, anchor.penalty + near + against, Some(anchor.at));
            }
        }
    }
    (candidates, points)
}

struct At {
    at: DVec2,
    /// Where the letter should rather stand.
    way: Option<DVec2>,
    /// Distance that the mark itself takes up [px].
    clear: f64,
    penalty: f64,
    /// The letter may stand on the very point.
    on_it: bool,
}

fn anchors(mark: &Mark, letter: &Letter, view: &View, window: &Rect) -> Vec<At> {
    let beside = |at: DVec2, way: Option<DVec2>, clear: f64, penalty: f64| At {
        at,
        way,
        clear,
        penalty,
        on_it: false,
    };
    let on = |at: DVec2, penalty: f64| At { at, way: None, clear: 0.0, penalty, on_it: true };
    match mark {
        Mark::Nothing { p } => vec![on(view.at(*p), 0.0)],
        Mark::Dot { p, .. } => vec![beside(view.at(*p), Some(dvec2(0.7, -0.7)), 8.0, 0.0)],
        Mark::Lamp { p } => vec![beside(view.at(*p), Some(DVec2::X), 24.0, 0.0)],
        Mark::Eye { p, towards } => vec![beside(view.at(*p), Some(-view.way(*towards)), 26.0, 0.0)],
        Mark::Angle { vertex, from, to, radius } => {
            let (start, turn) = marks::sweep(*from, *to);
            let middle = start + turn / 2.0;
            let way = dvec2(middle.cos(), -middle.sin());
            let inside = on(
                view.at(*vertex) + way * radius * 0.62,
                if turn.abs() * radius < 70.0 { 1.0e6 } else { 6.0 },
            );
            vec![beside(view.at(*vertex) + way * *radius, Some(way), 4.0, 0.0), inside]
        }
        Mark::RightAngle { vertex, .. } => vec![beside(view.at(*vertex), None, 20.0, 0.0)],
        Mark::Dimension { a, b, offset } => {
            let (c, d) = marks::moved(view.at(*a), view.at(*b), *offset);
            let along = (d - c).normalize_or(DVec2::X);
            let left = dvec2(along.y, -along.x) * if *offset < 0.0 { -1.0 } else { 1.0 };
            [0.5, 0.42, 0.58, 0.33, 0.67]
                .iter()
                .map(|&s| beside(c.lerp(d, s), Some(left), 5.0, 10.0 * (s - 0.5f64).abs()))
                .collect()
        }
        Mark::Ray { a, b, .. } => along(&[view.at(*a), view.at(*b)], letter.place),
        Mark::Curve { points, .. } => along(&view.all(points), letter.place),
        Mark::Band { p, n, depth } => band(view.at(*p), view.way(*n), *depth, window),
        Mark::Area { points, .. } => area(&view.all(points)),
    }
}

/// Places in a region, and round its edge.
fn area(chain: &[DVec2]) -> Vec<At> {
    let middle = chain.iter().copied().sum::<DVec2>() / chain.len().max(1) as f64;
    let reach = chain.iter().map(|p| p.distance(middle)).fold(f64::INFINITY, f64::min);
    let within = (0..8).map(|k| middle + DVec2::from_angle(TAU * f64::from(k) / 8.0) * reach * 0.55);
    let within = within.map(|at| At { at, way: None, clear: 0.0, penalty: 5.0, on_it: true });
    let center = At { at: middle, way: None, clear: 0.0, penalty: 0.0, on_it: true };
    let step = chain.len().div_ceil(16).max(1);
    let outside = chain.iter().step_by(step).map(|p| {
        let way = Some((*p - middle).normalize_or(DVec2::X));
        At { at: *p, way, clear: 6.0, penalty: 30.0, on_it: false }
    });
    std::iter::once(center).chain(within).chain(outside).collect()
}

/// Places along a chain: beside its middle, or at its end.
fn along(chain: &[DVec2], place: Where) -> Vec<At> {
    let (Some(&first), Some(&last)) = (chain.first(), chain.last()) else { return Vec::new() };
    if place == Where::AtEnd {
        let before = chain[chain.len().saturating_sub(2)];
        let way = (last - before).normalize_or(DVec2::X);
        return vec![At { at: last, way: Some(way), clear: 6.0, penalty: 0.0, on_it: false }];
    }
    let lengths: Vec<f64> = chain.windows(2).map(|w| w[0].distance(w[1])).collect();
    let total: f64 = lengths.iter().sum();
    let at = |share: f64| {
        let mut left = share * total;
        for (pair, length) in chain.windows(2).zip(&lengths) {
            if left <= *length && *length > 0.0 {
                return pair[0].lerp(pair[1], left / length);
            }
            left -= length;
        }
        last
    };
    let across = dvec2(last.y - first.y, first.x - last.x).normalize_or(DVec2::Y);
    let up = if across.y > 0.0 { -across } else { across };
    [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82]
        .iter()
        .map(|&s| At {
            at: at(s),
            way: Some(up),
            clear: 5.0,
            penalty: 30.0 * (s - 0.5f64).abs(),
            on_it: false,
        })
        .collect()
}

/// Places inside a medium or floor, along its edge: none beyond the window.
fn band(p: DVec2, n: DVec2, depth: f64, window: &Rect) -> Vec<At> {
    let along = dvec2(-n.y, n.x);
    let foot = p + along * (window.center() - p).dot(along);
    let mut out = Vec::new();
    for deep in [18.0, 60.0, 110.0, 170.0].into_iter().filter(|d| *d < depth) {
        for k in -50..=50 {
            let at = foot + along * f64::from(k) * 20.0 - n * deep;
            let from_edge = (at - window.min).min(window.max - at).min_element();
            if from_edge > 10.0 || depth.is_finite() && window.holds(at) {
                // Near the left or right end, so that the middle stays free.
                let central = (1.0 - f64::from(k).abs() * 20.0 / (window.width() / 2.0)).max(0.15) * 20.0;
                out.push(At { at, way: None, clear: 0.0, penalty: deep * 0.1 + central, on_it: true });
            }
        }
    }
    out
}
