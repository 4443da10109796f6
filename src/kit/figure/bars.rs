//! Bars: one quantity for named things.

use super::axis::{Axis, Ruler, Scale};
use super::chart::Look;
use super::drawing::{Anchor, Drawing, Face, Fill, Rect, Stroke, Text};
use super::heading::{HEIGHT, Heading, MARGIN, SIZE, WIDTH, short};
use super::ink::Ink;
use super::{Data, Figure, Repeats, font};
use crate::measure::{Method, Role, Spread};
use glam::dvec2;

/// Horizontal bars, one under the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    heading: Heading,
    axis: Axis,
    bars: Vec<(Method, Spread, String)>,
    repeats: Repeats,
}

impl Bars {
    pub fn new(axis: Axis) -> Self {
        Bars { heading: Heading::default(), axis, bars: Vec::new(), repeats: Repeats::Always }
    }
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    pub fn bar(self, method: impl Into<Method>, value: f64) -> Self {
        self.labelled(method, Spread::exact(value), &short(value))
    }
    /// A bar with its spread, and what is written at its end.
    pub fn labelled(mut self, method: impl Into<Method>, value: Spread, label: &str) -> Self {
        self.bars.push((method.into(), value, label.to_string()));
        self
    }
    /// The bars are measured seconds.
    pub fn timed(mut self) -> Self {
        self.repeats = Repeats::Timed;
        self
    }

    pub fn draw(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let top = self.heading.draw(&mut drawing);
        let count = self.bars.len().max(1) as f64;
        let step = ((HEIGHT - top - 3.2 * SIZE - MARGIN) / count).min(58.0);
        let bottom = top + step * count + 6.0;
        drawing.height = (bottom + 3.2 * SIZE + MARGIN * 0.4).ceil().min(HEIGHT);
        let size = SIZE.min(step * 0.8);
        let name = |m: &Method| {
            if m.role == Role::Default { format!("{} (default)", m.name) } else { m.name.clone() }
        };
        let widest =
            self.bars.iter().map(|b| font::width(&name(&b.0), Face::Regular, size)).fold(0.0, f64::max);
        let written = self.bars.iter().map(|b| font::width(&b.2, Face::Regular, size)).fold(0.0, f64::max);
        let left = (MARGIN + widest + 14.0).min(WIDTH * 0.5);
        let right = WIDTH - MARGIN - written - 12.0;
        // Linear bars have a length only from zero.
        let zero = (self.axis.scale == Scale::Linear).then_some(0.0);
        let values = self.bars.iter().flat_map(|b| [b.1.low, b.1.mid, b.1.high]).chain(zero);
        let ruler = self.axis.ruler(values, left, right);
        for (value, label) in ruler.ticks() {
            let Some(x) = ruler.inside(value) else { continue };
            drawing.line(dvec2(x, top), dvec2(x, bottom), Stroke::new(Ink::Grid, 1.2));
            let at = dvec2(x, bottom + SIZE * 1.1);
            drawing.text(Text::new(at, label, SIZE, Ink::Muted).anchor(Anchor::Middle));
        }
        let start = zero.and_then(|z| ruler.inside(z)).unwrap_or(left);
        for (i, bar) in self.bars.iter().enumerate() {
            let y = top + 3.0 + step * (i as f64 + 0.5);
            let at = dvec2(left - 12.0, y + size * 0.35);
            drawing.text(Text::new(at, name(&bar.0), size, Ink::Text).anchor(Anchor::End));
            one(bar, &ruler, start, Row { y, half: step * 0.33, size }, &mut drawing);
        }
        drawing.line(dvec2(start, top), dvec2(start, bottom), Stroke::new(Ink::Outline, 1.4));
        let at = dvec2(right, bottom + SIZE * 2.5);
        drawing.text(Text::new(at, &self.axis.title, SIZE, Ink::Text).anchor(Anchor::End));
        drawing
    }

    fn csv(&self) -> String {
        let quoted = |t: &str| format!("\"{}\"", t.replace('"', "\"\""));
        let line = |(m, s, _): &(Method, Spread, String)| {
            format!("{},{:e},{:e},{:e}\n", quoted(&m.name), s.mid, s.low, s.high)
        };
        self.bars.iter().fold("name,value,low,high\n".to_string(), |text, bar| text + &line(bar))
    }
}

/// Where a bar lies: its middle, half its thickness, the size of its writing [px].
struct Row {
    y: f64,
    half: f64,
    size: f64,
}

/// A bar from `start`, its spread, and what is written at its end.
fn one(
    (method, value, label): &(Method, Spread, String),
    ruler: &Ruler,
    start: f64,
    row: Row,
    drawing: &mut Drawing,
) {
    let Row { y, half, size } = row;
    let end = ruler.at(value.mid).map_or(start, |x| x.clamp(ruler.start, ruler.end));
    let (a, b) = (start.min(end), start.max(end));
    let fill = Fill::new(Ink::Line(Look::of(method, 0).hue));
    drawing.rect(Rect::new(a, y - half, b.max(a + 1.0), y + half), Some(fill), None);
    let mut text_at = b;
    let spread = ruler.inside(value.low).zip(ruler.inside(value.high));
    if let Some((low, high)) = spread.filter(|(low, high)| high - low > 2.0) {
        drawing.line(dvec2(low, y), dvec2(high, y), Stroke::new(Ink::Text, 1.6));
        text_at = text_at.max(high);
    }
    drawing.text(Text::new(dvec2(text_at + 8.0, y + size * 0.35), label, size, Ink::Text));
}

impl From<Bars> for Figure {
    fn from(bars: Bars) -> Figure {
        let values: Vec<String> =
            bars.bars.iter().map(|(m, _, label)| format!("{} {label}", m.name)).collect();
        let alt = format!("{}. Bars of {}: {}.", bars.heading.sentence(), bars.axis.title, values.join("; "));
        let mut figure = Figure::new(bars.draw(), &bars.heading.title, &alt);
        figure.caption = bars.heading.caption();
        figure.repeats = bars.repeats;
        figure.data.push(Data { repeats: bars.repeats, csv: bars.csv() });
        figure
    }
}
