//! Root diagrams: the stretches of a ray inside solids, as bars on a line [A ill. 62, D figures 27–29].

use super::drawing::{Anchor, Drawing, Face, Fill, Pixels, Rect, Stroke, Text};
use super::heading::{HEIGHT, Heading, MARGIN, SIZE, WIDTH};
use super::ink::{Hue, Ink};
use super::{Figure, font};
use glam::{DVec2, dvec2};

/// One bar, with the solids whose surfaces end it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    pub from: f64,
    pub to: f64,
    /// Colours of the two ends.
    pub ends: [Hue; 2],
}

impl Bar {
    /// A bar of one solid.
    pub fn of(hue: Hue, from: f64, to: f64) -> Self {
        Bar { from, to, ends: [hue; 2] }
    }
}

/// What a row shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Row {
    /// A solid by itself.
    Operand(Hue),
    /// What is made of those above.
    Result,
    /// A result that is not what holds.
    Wrong,
}

#[derive(Clone, Debug, PartialEq)]
struct Line {
    name: String,
    row: Row,
    bars: Vec<Bar>,
    /// Letters at places of the line.
    letters: Vec<(f64, String)>,
}

#[derive(Clone, Debug, PartialEq)]
struct Group {
    name: String,
    lines: Vec<Line>,
}

/// Root diagrams, in one column beside a picture or in several without.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Roots {
    heading: Heading,
    alt: String,
    /// With its marks: shares of width and height, and a letter.
    picture: Option<(Pixels, Vec<(DVec2, String)>)>,
    groups: Vec<Group>,
    columns: usize,
}

/// Height of a row and of a bar in it [px].
const ROW: f64 = 33.0;
const BAR: f64 = 15.0;
/// Under the rows of a group [px].
const FOOT: f64 = 24.0;

impl Roots {
    pub fn new() -> Self {
        Roots { columns: 1, ..Roots::default() }
    }
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    /// What the figure shows, for those who do not see it.
    pub fn alt(mut self, alt: &str) -> Self {
        self.alt = alt.to_string();
        self
    }
    /// A picture on the left, with letters where the rays go.
    pub fn picture(mut self, pixels: Pixels, marks: Vec<(DVec2, String)>) -> Self {
        self.picture = Some((pixels, marks));
        self
    }
    /// Diagrams side by side.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = columns.max(1);
        self
    }
    /// Begins the diagram of another ray.
    pub fn ray(mut self, name: &str) -> Self {
        self.groups.push(Group { name: name.to_string(), lines: Vec::new() });
        self
    }
    /// A solid's own spans.
    pub fn operand(self, name: &str, hue: Hue, spans: &[(f64, f64)]) -> Self {
        let bars = spans.iter().map(|&(from, to)| Bar::of(hue, from, to)).collect();
        self.line(name, Row::Operand(hue), bars)
    }
    /// What is made of those above; its ends in the colours of the surfaces on which they lie.
    pub fn result(self, name: &str, bars: Vec<Bar>) -> Self {
        self.line(name, Row::Result, bars)
    }
    /// A result that is not what holds.
    pub fn wrong(self, name: &str, bars: Vec<Bar>) -> Self {
        self.line(name, Row::Wrong, bars)
    }
    fn line(mut self, name: &str, row: Row, bars: Vec<Bar>) -> Self {
        if let Some(group) = self.groups.last_mut() {
            group.lines.push(Line { name: name.to_string(), row, bars, letters: Vec::new() });
        }
        self
    }
    /// Letters on the last line.
    pub fn letters(mut self, letters: Vec<(f64, String)>) -> Self {
        if let Some(line) = self.groups.last_mut().and_then(|g| g.lines.last_mut()) {
            line.letters = letters;
        }
        self
    }

    pub fn draw(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let top = self.heading.draw(&mut drawing);
        let left = match &self.picture {
            Some((pixels, marks)) => {
                let side = 470.0;
                let height = side * pixels.height as f64 / pixels.width as f64;
                let place = Rect::new(MARGIN, top, MARGIN + side, top + height);
                draw_picture(&mut drawing, place, pixels, marks);
                place.max.x + 44.0
            }
            None => MARGIN,
        };
        let bottom = self.draw_groups(&mut drawing, dvec2(left, top));
        let picture = self.picture.as_ref().map_or(0.0, |(p, _)| 470.0 * p.height as f64 / p.width as f64);
        drawing.height = (bottom.max(top + picture) + MARGIN * 0.7).ceil();
        drawing
    }

    fn draw_groups(&self, drawing: &mut Drawing, corner: DVec2) -> f64 {
        let gap = 46.0;
        let width = (WIDTH - MARGIN - corner.x - gap * (self.columns - 1) as f64) / self.columns as f64;
        let names = self.groups.iter().flat_map(|g| &g.lines);
        let label = names.map(|l| font::width(&l.name, Face::Italic, SIZE)).fold(0.0, f64::max) + 16.0;
        let mut y = corner.y;
        for groups in self.groups.chunks(self.columns) {
            let mut lowest = y;
            for (i, group) in groups.iter().enumerate() {
                let x = corner.x + (width + gap) * i as f64;
                lowest = lowest.max(draw_group(drawing, group, Rect::new(x, y, x + width, y), label));
            }
            y = lowest + FOOT;
        }
        y - FOOT
    }
}

fn draw_picture(drawing: &mut Drawing, place: Rect, pixels: &Pixels, marks: &[(DVec2, String)]) {
    drawing.image(place, pixels.clone());
    let size = place.max - place.min;
    for (share, letter) in marks {
        let at = place.min + *share * size;
        drawing.circle(at, 6.5, Some(Fill::new(Ink::Fixed([255, 255, 255]))), None);
        drawing.circle(at, 4.5, Some(Fill::new(Ink::Fixed([27, 31, 39]))), None);
        let beside = at + dvec2(12.0, -8.0);
        let text = Text::new(beside, letter.clone(), 1.15 * SIZE, Ink::Fixed([27, 31, 39]));
        let rim = |dx: f64, dy: f64| {
            let ink = Ink::Fixed([255, 255, 255]);
            Text { at: beside + dvec2(dx, dy), ink, ..text.clone() }.face(Face::Bold)
        };
        for (dx, dy) in [(-2.0, 0.0), (2.0, 0.0), (0.0, -2.0), (0.0, 2.0), (-1.4, -1.4), (1.4, 1.4)] {
            drawing.text(rim(dx, dy));
        }
        drawing.text(text.face(Face::Bold));
    }
}

/// Draws one ray's lines, and returns where they end.
fn draw_group(drawing: &mut Drawing, group: &Group, place: Rect, label: f64) -> f64 {
    let ends = group.lines.iter().flat_map(|l| &l.bars).flat_map(|b| [b.from, b.to]);
    let (low, high) = ends
        .filter(|t| t.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), t| (low.min(t), high.max(t)));
    let (low, high) = if low < high { (low, high) } else { (0.0, 1.0) };
    let air = 0.07 * (high - low);
    let axis = Rect::new(place.min.x + label, place.min.y, place.max.x, place.min.y);
    let at = |t: f64| {
        let share = (t - low + air) / (high - low + 2.0 * air);
        axis.min.x + share.clamp(0.0, 1.0) * (axis.width() - 22.0)
    };
    let mut y = place.min.y + SIZE;
    if !group.name.is_empty() {
        drawing.text(
            Text::new(dvec2(place.min.x, y - 2.0), group.name.clone(), SIZE, Ink::Text).face(Face::Bold),
        );
        y += 10.0;
    }
    for line in &group.lines {
        let middle = y + 0.5 * ROW;
        draw_line(drawing, line, dvec2(place.min.x, middle), axis.max.x, &at);
        y += ROW;
    }
    y
}

fn draw_line(drawing: &mut Drawing, line: &Line, left: DVec2, right: f64, at: &impl Fn(f64) -> f64) {
    let (ink, face) = match line.row {
        Row::Operand(hue) => (Ink::Label(hue), Face::Italic),
        Row::Result => (Ink::Text, Face::Italic),
        Row::Wrong => (Ink::Label(Hue::Vermillion), Face::Italic),
    };
    let baseline = Stroke::new(Ink::Outline, 1.2).faint(0.6);
    drawing.text(Text::new(left + dvec2(0.0, 0.36 * SIZE), line.name.clone(), SIZE, ink).face(face));
    drawing.arrow(dvec2(at(f64::NEG_INFINITY), left.y), dvec2(right, left.y), baseline);
    for bar in &line.bars {
        let place = Rect::new(at(bar.from), left.y - 0.5 * BAR, at(bar.to), left.y + 0.5 * BAR);
        let fill = match line.row {
            Row::Operand(hue) => Fill::new(Ink::Line(hue)).faint(0.45),
            Row::Result => Fill::new(Ink::Outline).faint(0.75),
            Row::Wrong => Fill::hatched(Ink::Line(Hue::Vermillion)),
        };
        drawing.rect(place, Some(fill), None);
        for (t, hue) in [(bar.from, bar.ends[0]), (bar.to, bar.ends[1])] {
            if t.is_finite() {
                let (a, b) = (dvec2(at(t), place.min.y - 3.0), dvec2(at(t), place.max.y + 3.0));
                drawing.line(a, b, Stroke::new(Ink::Line(hue), 3.6));
            }
        }
    }
    for (t, letter) in &line.letters {
        let text =
            Text::new(dvec2(at(*t), left.y - 0.5 * BAR - 5.0), letter.clone(), 0.66 * SIZE, Ink::Muted);
        drawing.text(text.anchor(Anchor::Middle).halo(3.0));
    }
}

impl From<Roots> for Figure {
    fn from(roots: Roots) -> Figure {
        let names: Vec<&str> = roots.groups.iter().map(|g| g.name.as_str()).collect();
        let alt = if roots.alt.is_empty() {
            format!("{}. Root diagrams: {}.", roots.heading.sentence(), names.join("; "))
        } else {
            roots.alt.clone()
        };
        let mut figure = Figure::new(roots.draw(), &roots.heading.title, &alt);
        figure.caption = roots.heading.caption();
        figure
    }
}
