//! Small multiples: more lines than a plot can hold, one panel each, on the same axes.

use super::Chart;
use super::plot::{Plot, Ticks};
use crate::figure::drawing::{Anchor, Drawing, Face, Rect, Stroke, Text};
use crate::figure::heading::{MARGIN, SIZE, percent};
use crate::figure::ink::Ink;
use glam::dvec2;

/// Draws a panel for each line; the others stand behind it in grey.
pub fn draw(chart: &Chart, drawing: &mut Drawing, top: f64) {
    let count = chart.lines.len();
    let columns = columns(count);
    let rows = count.div_ceil(columns);
    let whole = Rect::new(MARGIN, top, drawing.width - MARGIN, drawing.height - MARGIN + 12.0);
    let scales = Plot::within(chart, whole, 10.0);
    let titles = 1.6 * SIZE;
    let cell = dvec2(whole.width() / columns as f64, (whole.height() - 2.0 * titles) / rows as f64);
    drawing.text(Text::new(dvec2(whole.min.x, top + SIZE * 0.75), &chart.y.title, SIZE, Ink::Text));
    let below = dvec2(whole.max.x, whole.max.y);
    drawing.text(Text::new(below, &chart.x.title, SIZE, Ink::Text).anchor(Anchor::End));
    for i in 0..count {
        let corner =
            dvec2(whole.min.x, top + titles) + cell * dvec2((i % columns) as f64, (i / columns) as f64);
        panel(chart, &scales, i, Rect { min: corner, max: corner + cell }, drawing);
    }
}

fn columns(count: usize) -> usize {
    (count as f64).sqrt().ceil().max(3.0) as usize
}

fn panel(chart: &Chart, scales: &Plot, index: usize, cell: Rect, drawing: &mut Drawing) {
    let inset = scales.area.min.x - scales.outer.min.x;
    let floor = cell.max.y - 30.0;
    let exact = scales.exact.map(|_| floor - 16.0);
    let bottom = floor - if exact.is_some() { 38.0 } else { 0.0 };
    let area = Rect::new(cell.min.x + inset, cell.min.y + 30.0, cell.max.x - 22.0, bottom);
    let mut x = scales.x;
    let mut y = scales.y;
    (x.start, x.end, y.start, y.end) = (area.min.x, area.max.x, area.max.y, area.min.y);
    let plot = Plot { chart, area, x, y, exact, failed: floor, base: floor, outer: cell };
    let columns = columns(chart.lines.len());
    let written = |is_outer: bool| if is_outer { Ticks::Written } else { Ticks::Bare };
    plot.vertical(drawing, written(index.is_multiple_of(columns)));
    plot.horizontal(drawing, written(index + columns >= chart.lines.len()));
    for other in chart.lines.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, l)| l) {
        drawing.chain(&plot.points_of(other), Stroke::new(Ink::Muted, 1.2).faint(0.4));
    }
    let line = &chart.lines[index];
    let points = plot.points_of(line);
    drawing.chain(&points, line.look.stroke());
    points.iter().for_each(|p| line.look.draw_mark(drawing, *p));
    let failures = line.total_failures();
    let failed = if failures.total() > 0 {
        format!(" · {} failed", percent(failures.share()))
    } else {
        String::new()
    };
    let name = format!("{}{failed}", line.name);
    let at = dvec2(area.min.x, cell.min.y + 20.0);
    let width = crate::figure::font::width(&name, Face::Bold, SIZE * 0.9);
    let size = SIZE * 0.9 * ((cell.max.x - at.x) / width).min(1.0);
    drawing.text(Text::new(at, name, size, Ink::Label(line.look.hue)).face(Face::Bold));
}
