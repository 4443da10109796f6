//! What has no place on a logarithm: errors of exactly zero, and answers that were none.

use super::line::Line;
use super::plot::{Plot, Ticks};
use crate::figure::drawing::{Anchor, Drawing, Fill, Rect, Text};
use crate::figure::heading::{SIZE, grouped, percent};
use crate::figure::ink::Ink;
use crate::figure::label::{Candidate, Placer};
use glam::{DVec2, dvec2};

/// Height of a method's row of failures [px].
pub const ROW: f64 = 27.0;

/// The ground of the strip of zero errors, and its name.
pub fn exact(plot: &Plot, drawing: &mut Drawing, middle: f64, ticks: Ticks) {
    let strip = Rect::new(plot.area.min.x, middle - 17.0, plot.area.max.x, middle + 17.0);
    drawing.rect(strip, Some(Fill::new(Ink::Surface).faint(0.55)), None);
    let at = dvec2(plot.area.min.x - 10.0, middle + SIZE * 0.35);
    if ticks == Ticks::Written {
        drawing.text(Text::new(at, "exact", SIZE, Ink::Muted).anchor(Anchor::End));
    }
}

/// A row for each method that failed: bars where it did, as strong as the share, and the counts in words.
pub fn failures(plot: &Plot, drawing: &mut Drawing) {
    let failing: Vec<&Line> = plot.chart.lines.iter().filter(|l| !l.failures.is_empty()).collect();
    for (i, line) in failing.iter().enumerate() {
        let y = plot.failed + i as f64 * ROW;
        let row = Rect::new(plot.area.min.x, y + 2.0, plot.area.max.x, y + ROW - 2.0);
        if i == 0 {
            let at = dvec2(plot.area.min.x - 10.0, y + ROW / 2.0 + SIZE * 0.35);
            drawing.text(Text::new(at, "failed", SIZE, Ink::Muted).anchor(Anchor::End));
        }
        drawing.rect(row, Some(Fill::new(Ink::Surface).faint(0.35)), None);
        let mut placer = Placer::new(Rect { max: dvec2(plot.outer.max.x, row.max.y), ..row });
        for (cell, share) in cells(plot, line, &row) {
            let opacity = 0.25 + 0.75 * share.sqrt();
            drawing.rect(cell, Some(Fill::new(Ink::Line(line.look.hue)).faint(opacity)), None);
            placer.keep_clear(cell);
        }
        summary(plot, line, &row, &mut placer, drawing);
    }
}

/// The counts in words, in the freest part of the row.
fn summary(plot: &Plot, line: &Line, row: &Rect, placer: &mut Placer, drawing: &mut Drawing) {
    let size = SIZE * 0.9;
    let ink = Ink::Label(line.look.hue);
    // In full where it fits between the bars, else shorter.
    let mut candidates = Vec::new();
    let mut texts = Vec::new();
    for (i, words) in counts(line).into_iter().enumerate() {
        let width = Text::new(DVec2::ZERO, &words, size, ink).bounds().width();
        let room = (plot.outer.max.x - row.min.x - width - 6.0).max(0.0);
        for k in 0..=40 {
            let at = dvec2(row.min.x + 6.0 + room * f64::from(k) / 40.0, row.center().y + size * 0.35);
            let text = Text::new(at, &words, size, ink).halo(3.0);
            let place = Rect::new(at.x - 3.0, row.min.y + 1.0, at.x + width + 3.0, row.max.y - 1.0);
            candidates.push(Candidate { place, penalty: 1000.0 * i as f64 });
            texts.push(text);
        }
    }
    if let Some((best, _)) = placer.best(&candidates) {
        drawing.text(texts.swap_remove(best));
    }
}

/// "as printed: 812 missed, 3 false of 60 000 (1.4 %)", and shorter ways to say it.
fn counts(line: &Line) -> [String; 3] {
    let f = line.total_failures();
    let kinds = [(f.missed, "missed"), (f.false_hits, "false"), (f.nan, "NaN")];
    let words: Vec<String> =
        kinds.iter().filter(|k| k.0 > 0).map(|(n, kind)| format!("{} {kind}", grouped(*n))).collect();
    let (name, words, share) = (&line.name, words.join(", "), percent(f.share()));
    [
        format!("{name}: {words} of {} ({share})", grouped(f.of)),
        format!("{words} of {} ({share})", grouped(f.of)),
        format!("{words} ({share})"),
    ]
}

/// The stretch of the row that belongs to each point with failures: halfway to its neighbours.
fn cells(plot: &Plot, line: &Line, row: &Rect) -> Vec<(Rect, f64)> {
    let all: Vec<f64> = line.points.iter().filter_map(|p| plot.x.inside(p.0.mid)).collect();
    line.failures
        .iter()
        .filter_map(|(x, failures)| {
            let x = plot.x.inside(*x)?;
            let below = all.iter().copied().filter(|&o| o < x - 0.5).fold(f64::NEG_INFINITY, f64::max);
            let above = all.iter().copied().filter(|&o| o > x + 0.5).fold(f64::INFINITY, f64::min);
            let reach = |gap: f64| if gap.is_finite() { (gap / 2.0).clamp(3.0, 24.0) } else { 12.0 };
            let (a, b) = (x - reach(x - below) + 0.5, x + reach(above - x) - 0.5);
            let cell = Rect::new(a.max(row.min.x), row.min.y, b.min(row.max.x), row.max.y);
            Some((cell, failures.share()))
        })
        .collect()
}
