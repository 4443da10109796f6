//! The marks of a ray diagram, from world coordinates to the canvas.

use super::{Light, View};
use crate::figure::drawing::{Chain, Drawing, Ends, Fill, Item, Rect, Stroke, arc};
use crate::figure::ink::{Hue, Ink};
use glam::{DVec2, dvec2};
use std::f64::consts::{PI, TAU};

/// How a region is filled and bounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Area {
    /// A surface: light grey with a dark outline.
    Solid,
    Hatched,
    /// A faint tint without outline.
    Lit(Light),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    Surface,
    Thin,
    Hidden,
    Lit(Light),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head {
    End,
    Middle,
}

/// One thing in the world.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    Area {
        points: Vec<DVec2>,
        area: Area,
    },
    /// Beyond the line through `p` with unit normal `n`, so many pixels deep.
    Band {
        p: DVec2,
        n: DVec2,
        depth: f64,
    },
    Curve {
        points: Vec<DVec2>,
        line: Line,
    },
    Ray {
        light: Light,
        a: DVec2,
        b: DVec2,
        head: Head,
    },
    Dot {
        p: DVec2,
        light: Option<Light>,
    },
    Lamp {
        p: DVec2,
    },
    Eye {
        p: DVec2,
        towards: DVec2,
    },
    Angle {
        vertex: DVec2,
        from: DVec2,
        to: DVec2,
        radius: f64,
    },
    RightAngle {
        vertex: DVec2,
        from: DVec2,
        to: DVec2,
    },
    Dimension {
        a: DVec2,
        b: DVec2,
        offset: f64,
    },
    Nothing {
        p: DVec2,
    },
}

/// The pen of a kind of light.
pub fn pen(light: Light) -> Stroke {
    match light {
        Light::Incident => Stroke::new(Ink::Line(Hue::Blue), 2.6),
        Light::Reflected => Stroke::new(Ink::Line(Hue::Orange), 2.6),
        Light::Transmitted => Stroke::new(Ink::Line(Hue::Green), 2.6),
        Light::Shadow => Stroke::new(Ink::Line(Hue::Grey), 2.2).dashed(&[8.0, 6.0]),
        Light::Normal => Stroke::new(Ink::Text, 1.7),
        Light::Other => Stroke::new(Ink::Line(Hue::Purple), 2.6),
    }
}

/// The colour of a mark's letter.
pub fn letter_ink(mark: &Mark) -> Ink {
    let of = |light: Light| match pen(light).ink {
        Ink::Line(hue) => Ink::Label(hue),
        ink => ink,
    };
    match mark {
        Mark::Ray { light, .. } | Mark::Dot { light: Some(light), .. } => of(*light),
        Mark::Curve { line: Line::Lit(light), .. } | Mark::Area { area: Area::Lit(light), .. } => of(*light),
        Mark::Nothing { .. } => Ink::Muted,
        _ => Ink::Text,
    }
}

/// Draws all marks, surfaces and curves in the order they were added, rays above them, points last.
pub fn draw(marks: &[Mark], view: &View, window: &Rect, drawing: &mut Drawing) {
    let rank = |mark: &Mark| match mark {
        // What stands behind is added first.
        Mark::Area { .. } | Mark::Band { .. } | Mark::Curve { .. } => 0,
        Mark::Dimension { .. } | Mark::Angle { .. } | Mark::RightAngle { .. } => 1,
        Mark::Ray { .. } => 2,
        _ => 3,
    };
    for level in 0..=3 {
        let level_marks = marks.iter().filter(|m| rank(m) == level);
        drawing.clipped(window.grown(3.0), |d| level_marks.for_each(|m| one(m, view, d)));
    }
}

fn one(mark: &Mark, view: &View, drawing: &mut Drawing) {
    match mark {
        Mark::Area { points, area } => fill(&view.all(points), *area, drawing),
        Mark::Band { p, n, depth } => {
            let points = band(view.at(*p), view.way(*n), *depth);
            drawing.polygon(&points, Some(Fill::new(Ink::Surface)), None);
            drawing.chain(&points[..2], Stroke::new(Ink::Outline, 2.2));
        }
        Mark::Curve { points, line } => drawing.chain(&view.all(points), line_pen(*line)),
        Mark::Ray { light, a, b, head } => ray(view.at(*a), view.at(*b), *light, *head, drawing),
        Mark::Dot { p, light } => {
            let ink = light.map_or(Ink::Text, |l| pen(l).ink);
            let rim = Some(Stroke::new(Ink::Ground, 1.5));
            drawing.circle(view.at(*p), 5.5, Some(Fill::new(ink)), rim);
        }
        Mark::Lamp { p } => lamp(view.at(*p), drawing),
        Mark::Eye { p, towards } => eye(view.at(*p), view.way(*towards), drawing),
        Mark::Dimension { .. } | Mark::Angle { .. } | Mark::RightAngle { .. } => {
            for chain in lines(mark, view) {
                drawing.chain(&chain, Stroke::new(Ink::Outline, 1.5));
            }
            if let Mark::Dimension { a, b, offset } = mark {
                let (a, b) = moved(view.at(*a), view.at(*b), *offset);
                let middle = (a + b) * 0.5;
                drawing.arrow(middle, a, Stroke::new(Ink::Outline, 1.2));
                drawing.arrow(middle, b, Stroke::new(Ink::Outline, 1.2));
            }
        }
        Mark::Nothing { .. } => {}
    }
}

/// The corners of a band on the canvas, the edge first; it reaches past any canvas.
pub fn band(p: DVec2, n: DVec2, depth: f64) -> [DVec2; 4] {
    const FAR: f64 = 3000.0;
    let along = dvec2(-n.y, n.x) * FAR;
    let deep = n * depth.min(FAR);
    [p - along, p + along, p + along - deep, p - along - deep]
}

/// The window that holds all marks with a little air.
pub fn extent(marks: &[Mark]) -> (DVec2, DVec2) {
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let points = marks.iter().flat_map(|mark| match mark {
        Mark::Area { points, .. } | Mark::Curve { points, .. } => points.clone(),
        Mark::Ray { a, b, .. } | Mark::Dimension { a, b, .. } => vec![*a, *b],
        Mark::Dot { p, .. } | Mark::Lamp { p } | Mark::Eye { p, .. } | Mark::Nothing { p } => vec![*p],
        Mark::Angle { vertex, .. } | Mark::RightAngle { vertex, .. } => vec![*vertex],
        Mark::Band { p, .. } => vec![*p],
    });
    for p in points.filter(|p| p.is_finite()) {
        low = low.min(p);
        high = high.max(p);
    }
    if low.x > high.x {
        return (DVec2::NEG_ONE, DVec2::ONE);
    }
    let air = ((high - low).max_element() * 0.06).max(f64::MIN_POSITIVE);
    // A single point still needs a window round it.
    let air = if high == low { low.length().max(1.0) } else { air };
    (low - air, high + air)
}

fn fill(points: &[DVec2], area: Area, drawing: &mut Drawing) {
    let outline = || Stroke::new(Ink::Outline, 2.2);
    match area {
        Area::Solid => drawing.polygon(points, Some(Fill::new(Ink::Surface)), Some(outline())),
        Area::Hatched => drawing.polygon(points, Some(Fill::hatched(Ink::Muted)), Some(outline())),
        Area::Lit(light) => drawing.polygon(points, Some(Fill::new(pen(light).ink).faint(0.22)), None),
    }
}

fn line_pen(line: Line) -> Stroke {
    match line {
        Line::Surface => Stroke::new(Ink::Outline, 2.2),
        Line::Thin => Stroke::new(Ink::Outline, 1.2),
        Line::Hidden => Stroke::new(Ink::Muted, 1.3).dashed(&[6.0, 5.0]),
        Line::Lit(light) => pen(light),
    }
}

fn ray(a: DVec2, b: DVec2, light: Light, head: Head, drawing: &mut Drawing) {
    match head {
        Head::End => drawing.arrow(a, b, pen(light)),
        Head::Middle => {
            let tip = a.lerp(b, 0.5) + (b - a).normalize_or_zero() * 8.0;
            drawing.line(a, b, pen(light));
            drawing.arrow(a.lerp(tip, 0.95), tip, Stroke { dash: Vec::new(), ..pen(light) });
        }
    }
}

fn lamp(p: DVec2, drawing: &mut Drawing) {
    for k in 0..8 {
        let way = DVec2::from_angle(TAU * f64::from(k) / 8.0);
        drawing.line(p + way * 14.0, p + way * 21.0, Stroke::new(Ink::Line(Hue::Orange), 2.2));
    }
    let rim = Some(Stroke::new(Ink::Outline, 1.6));
    drawing.circle(p, 9.5, Some(Fill::new(Ink::Line(Hue::Orange)).faint(0.85)), rim);
}

/// Two lids that meet behind the point, and an iris on the side it looks to.
fn eye(p: DVec2, towards: DVec2, drawing: &mut Drawing) {
    let side = dvec2(-towards.y, towards.x);
    let lid = |s: f64| [p + towards * 6.0 + side * s * 13.0, p - towards * 24.0];
    for s in [1.0, -1.0] {
        drawing.chain(&lid(s), Stroke::new(Ink::Outline, 2.2));
    }
    let ahead = (-towards.y).atan2(towards.x);
    drawing.chain(&arc(p - towards * 24.0, 33.0, ahead - 0.42, ahead + 0.42), Stroke::new(Ink::Outline, 2.2));
    let iris: Vec<DVec2> = arc(p + towards * 4.0, 6.0, 0.0, TAU);
    let chains = vec![Chain { points: iris, ends: Ends::Closed }];
    drawing.items.push(Item::Path { chains, fill: Some(Fill::new(Ink::Outline)), stroke: None });
}

/// The two ends moved to the left of the way from `a` to `b`, as seen on the canvas.
pub fn moved(a: DVec2, b: DVec2, offset: f64) -> (DVec2, DVec2) {
    let along = (b - a).normalize_or(DVec2::X);
    let left = dvec2(along.y, -along.x) * offset;
    (a + left, b + left)
}

/// Angles on the canvas (counterclockwise) where the arc begins, and how far it goes, the shorter way.
pub fn sweep(from: DVec2, to: DVec2) -> (f64, f64) {
    let start = from.y.atan2(from.x);
    let turn = (to.y.atan2(to.x) - start + PI).rem_euclid(TAU) - PI;
    (start, turn)
}

/// The lines of a mark on the canvas: what it draws, and what labels keep off.
pub fn lines(mark: &Mark, view: &View) -> Vec<Vec<DVec2>> {
    match mark {
        Mark::Area { area: Area::Lit(_), .. } | Mark::Nothing { .. } => Vec::new(),
        Mark::Band { p, n, depth } => vec![band(view.at(*p), view.way(*n), *depth)[..2].to_vec()],
        Mark::Area { points, .. } => {
            let mut chain = view.all(points);
            chain.extend(chain.first().copied());
            vec![chain]
        }
        Mark::Curve { points, .. } => vec![view.all(points)],
        Mark::Ray { a, b, .. } => vec![view.all(&[*a, *b])],
        Mark::Angle { vertex, from, to, radius } => {
            let (start, turn) = sweep(*from, *to);
            vec![arc(view.at(*vertex), *radius, start, start + turn)]
        }
        Mark::RightAngle { vertex, from, to } => {
            let (p, u, v) = (view.at(*vertex), view.way(*from) * 16.0, view.way(*to) * 16.0);
            vec![vec![p + u, p + u + v, p + v]]
        }
        Mark::Dimension { a, b, offset } => {
            let (p, q) = (view.at(*a), view.at(*b));
            let (c, d) = moved(p, q, *offset);
            let past = |from: DVec2, to: DVec2| to + (to - from).normalize_or_zero() * 7.0;
            let start = |from: DVec2, to: DVec2| from + (to - from).normalize_or_zero() * 6.0;
            vec![vec![start(p, c), past(p, c)], vec![start(q, d), past(q, d)], vec![c, d]]
        }
        Mark::Dot { .. } | Mark::Lamp { .. } | Mark::Eye { .. } => Vec::new(),
    }
}

/// The box of a mark that is a sign rather than a line.
pub fn sign(mark: &Mark, view: &View) -> Option<Rect> {
    let around = |p: DVec2, half: f64| Rect { min: view.at(p) - half, max: view.at(p) + half };
    match mark {
        Mark::Dot { p, .. } => Some(around(*p, 6.0)),
        Mark::Lamp { p } => Some(around(*p, 20.0)),
        Mark::Eye { p, .. } => Some(around(*p, 22.0)),
        _ => None,
    }
}
