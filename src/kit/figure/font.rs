//! Letters: widths for the layout and outlines for the bitmap, from the embedded DejaVu fonts.

use super::drawing::Face;
use ab_glyph::{Font, FontRef, OutlineCurve};
use glam::{DVec2, dvec2};
use std::sync::LazyLock;

static REGULAR: LazyLock<FontRef<'static>> = LazyLock::new(|| load(dejavu::sans_condensed::regular()));
static BOLD: LazyLock<FontRef<'static>> = LazyLock::new(|| load(dejavu::sans_condensed::bold()));
static ITALIC: LazyLock<FontRef<'static>> = LazyLock::new(|| load(dejavu::serif_condensed::italic()));

fn load(bytes: &'static [u8]) -> FontRef<'static> {
    FontRef::try_from_slice(bytes).expect("the embedded fonts are whole")
}

fn font(face: Face) -> &'static FontRef<'static> {
    match face {
        Face::Regular => &REGULAR,
        Face::Bold => &BOLD,
        Face::Italic => &ITALIC,
    }
}

/// A stretch of text at one height.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    pub text: String,
    pub level: Level,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    Base,
    Sub,
    Super,
}

impl Level {
    /// Size as a share of the base, and rise above the baseline in sizes of the base.
    pub fn scale_and_rise(self) -> (f64, f64) {
        match self {
            Level::Base => (1.0, 0.0),
            Level::Sub => (0.7, -0.2),
            Level::Super => (0.7, 0.36),
        }
    }
}

/// Splits a text at `_{…}` and `^{…}`; anything else stays as it is, unclosed braces too.
pub fn runs(text: &str) -> Vec<Run> {
    let mut out: Vec<Run> = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let opening = ["_{", "^{"].iter().filter_map(|m| rest.find(m)).min();
        let found = opening.and_then(|start| rest[start..].find('}').map(|end| (start, start + end)));
        let Some((start, end)) = found else {
            out.push(Run { text: rest.to_string(), level: Level::Base });
            break;
        };
        if start > 0 {
            out.push(Run { text: rest[..start].to_string(), level: Level::Base });
        }
        let level = if rest[start..].starts_with('_') { Level::Sub } else { Level::Super };
        if end > start + 2 {
            out.push(Run { text: rest[start + 2..end].to_string(), level });
        }
        rest = &rest[end + 1..];
    }
    out
}

/// A text without its markup, for readers that only take plain text.
pub fn plain(text: &str) -> String {
    runs(text).into_iter().map(|r| r.text).collect()
}

/// Width of a line of text \[px\].
pub fn width(text: &str, face: Face, size: f64) -> f64 {
    runs(text).iter().map(|r| run_width(&r.text, face, size * r.level.scale_and_rise().0)).sum()
}

/// Width of a stretch at one height \[px\].
pub fn run_width(text: &str, face: Face, size: f64) -> f64 {
    let font = font(face);
    let scale = size / f64::from(font.units_per_em().unwrap_or(2048.0));
    let glyphs: Vec<_> = text.chars().map(|c| font.glyph_id(c)).collect();
    let advance: f64 = glyphs.iter().map(|&g| f64::from(font.h_advance_unscaled(g))).sum();
    let kerning: f64 = glyphs.windows(2).map(|w| f64::from(font.kern_unscaled(w[0], w[1]))).sum();
    (advance + kerning) * scale
}

/// Closed outlines of a line of text whose baseline starts at the origin, y downwards \[px\].
pub fn outlines(text: &str, face: Face, size: f64) -> Vec<Vec<DVec2>> {
    let mut contours = Vec::new();
    let mut x = 0.0;
    for run in runs(text) {
        let (scale, rise) = run.level.scale_and_rise();
        let start = dvec2(x, -rise * size);
        run_outlines(&run.text, face, size * scale, start, &mut contours);
        x += run_width(&run.text, face, size * scale);
    }
    contours
}

fn run_outlines(text: &str, face: Face, size: f64, start: DVec2, into: &mut Vec<Vec<DVec2>>) {
    let font = font(face);
    let scale = size / f64::from(font.units_per_em().unwrap_or(2048.0));
    let mut pen = start;
    let mut before = None;
    for c in text.chars() {
        let glyph = font.glyph_id(c);
        if let Some(before) = before {
            pen.x += f64::from(font.kern_unscaled(before, glyph)) * scale;
        }
        if let Some(outline) = font.outline(glyph) {
            let place = |p: ab_glyph::Point| pen + dvec2(f64::from(p.x), -f64::from(p.y)) * scale;
            contours(&outline.curves, place, into);
        }
        pen.x += f64::from(font.h_advance_unscaled(glyph)) * scale;
        before = Some(glyph);
    }
}

/// Chains the curves of a glyph into closed polygons; a curve becomes a few chords (under 0.05 px off at 30 px).
fn contours(curves: &[OutlineCurve], place: impl Fn(ab_glyph::Point) -> DVec2, into: &mut Vec<Vec<DVec2>>) {
    const CHORDS: usize = 5;
    let mut current: Vec<DVec2> = Vec::new();
    for curve in curves {
        let (first, last) = match curve {
            OutlineCurve::Line(a, b) => (place(*a), place(*b)),
            OutlineCurve::Quad(a, _, c) => (place(*a), place(*c)),
            OutlineCurve::Cubic(a, _, _, d) => (place(*a), place(*d)),
        };
        if current.last().is_none_or(|p| p.distance_squared(first) > 1.0e-6) {
            into.extend((current.len() > 2).then(|| std::mem::take(&mut current)));
            current = vec![first];
        }
        for i in 1..CHORDS {
            let t = i as f64 / CHORDS as f64;
            match curve {
                OutlineCurve::Line(..) => {}
                OutlineCurve::Quad(a, b, c) => {
                    let (a, b, c) = (place(*a), place(*b), place(*c));
                    current.push(a.lerp(b, t).lerp(b.lerp(c, t), t));
                }
                OutlineCurve::Cubic(a, b, c, d) => {
                    let (a, b, c, d) = (place(*a), place(*b), place(*c), place(*d));
                    let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
                    current.push(ab.lerp(bc, t).lerp(bc.lerp(cd, t), t));
                }
            }
        }
        current.push(last);
    }
    into.extend((current.len() > 2).then_some(current));
}

/// Breaks a text into lines no wider than `max_width` \[px\]; a single longer word stands alone.
pub fn wrapped(text: &str, face: Face, size: f64, max_width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), face, size) <= max_width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_string()),
        }
    }
    lines
}
