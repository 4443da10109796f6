//! Ray diagrams in the plane.
//!
//! World coordinates, y up; lines and letters keep their size in pixels whatever the window. Each mark may get a name
//! ([`Diagram::name`]), which finds its own place beside the mark where it covers nothing.

mod letters;
mod marks;

use super::drawing::Rect;
use super::heading::{HEIGHT, Heading, MARGIN, WIDTH};
use super::{Drawing, Figure};
use glam::{DVec2, dvec2};
use letters::Letter;
use marks::{Area, Mark};
use std::f64::consts::TAU;

/// What a line of light is, and hence its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Light {
    /// Blue.
    Incident,
    /// Orange.
    Reflected,
    /// Green.
    Transmitted,
    /// Grey, dashed.
    Shadow,
    /// Thin and dark: normals, axes.
    Normal,
    /// Purple: anything that must stand out from those.
    Other,
}

/// A diagram under construction.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagram {
    heading: Heading,
    alt: String,
    /// What is shown; all marks, if nothing is said.
    window: Option<(DVec2, DVec2)>,
    marks: Vec<Mark>,
    letters: Vec<Letter>,
}

impl Diagram {
    /// A diagram that shows the world between two corners.
    pub fn new(min: DVec2, max: DVec2) -> Self {
        let ok = min.is_finite() && max.is_finite() && max.cmpgt(min).all();
        debug_assert!(ok, "a window from {min} to {max}");
        Diagram { window: ok.then_some((min, max)), ..Diagram::fitted() }
    }
    /// A diagram that shows all its marks, with a little air.
    pub fn fitted() -> Self {
        let heading = Heading::default();
        Diagram { heading, alt: String::new(), window: None, marks: Vec::new(), letters: Vec::new() }
    }
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    /// What the diagram shows, for those who do not see it.
    pub fn alt(mut self, alt: &str) -> Self {
        self.alt = alt.to_string();
        self
    }

    fn add(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }

    /// A filled disk with its outline: a sphere in section.
    pub fn circle(self, center: DVec2, radius: f64) -> Self {
        let points =
            (0..180).map(|i| center + radius * DVec2::from_angle(TAU * f64::from(i) / 180.0)).collect();
        self.add(Mark::Area { points, area: Area::Solid })
    }
    /// A filled polygon with its outline.
    pub fn polygon(self, points: &[DVec2]) -> Self {
        self.add(Mark::Area { points: points.to_vec(), area: Area::Solid })
    }
    /// A region without outline: a beam of light, a shadow.
    pub fn region(self, light: Light, points: &[DVec2]) -> Self {
        self.add(Mark::Area { points: points.to_vec(), area: Area::Lit(light) })
    }
    /// A hatched polygon with its outline: what is shut off, cut away, or fails.
    pub fn hatched(self, points: &[DVec2]) -> Self {
        self.add(Mark::Area { points: points.to_vec(), area: Area::Hatched })
    }
    /// Everything on the far side of a line through `p` with normal `n`: a medium.
    pub fn half_plane(self, p: DVec2, n: DVec2) -> Self {
        self.add(Mark::Band { p, n: n.normalize_or(DVec2::Y), depth: f64::INFINITY })
    }
    /// A floor or wall: a band under the line through `p` with normal `n`.
    pub fn ground(self, p: DVec2, n: DVec2) -> Self {
        self.add(Mark::Band { p, n: n.normalize_or(DVec2::Y), depth: 36.0 })
    }
    /// An outline without inside: a curved surface, an open contour.
    pub fn curve(self, points: &[DVec2]) -> Self {
        self.add(Mark::Curve { points: points.to_vec(), line: marks::Line::Surface })
    }
    /// An arc of an outline from angle `a` to `b` \[rad\].
    pub fn arc(self, center: DVec2, radius: f64, a: f64, b: f64) -> Self {
        let points = (0..=96)
            .map(|i| a + (b - a) * f64::from(i) / 96.0)
            .map(|t| center + radius * DVec2::from_angle(t));
        let points: Vec<DVec2> = points.collect();
        self.curve(&points)
    }
    /// A thin dark line: construction, pixel grids.
    pub fn thin(self, points: &[DVec2]) -> Self {
        self.add(Mark::Curve { points: points.to_vec(), line: marks::Line::Thin })
    }
    /// A thin dashed line: hidden edges, prolonged rays.
    pub fn hidden(self, points: &[DVec2]) -> Self {
        self.add(Mark::Curve { points: points.to_vec(), line: marks::Line::Hidden })
    }
    /// A line of light without a head.
    pub fn path(self, light: Light, points: &[DVec2]) -> Self {
        self.add(Mark::Curve { points: points.to_vec(), line: marks::Line::Lit(light) })
    }
    /// An arrow from `a` to `b`.
    pub fn ray(self, light: Light, a: DVec2, b: DVec2) -> Self {
        self.add(Mark::Ray { light, a, b, head: marks::Head::End })
    }
    /// A line from `a` to `b` with its head in the middle: light under way between two places.
    pub fn beam(self, light: Light, a: DVec2, b: DVec2) -> Self {
        self.add(Mark::Ray { light, a, b, head: marks::Head::Middle })
    }
    /// The normal `n` at `p`, drawn as an arrow of `n`'s length.
    pub fn normal(self, p: DVec2, n: DVec2) -> Self {
        self.ray(Light::Normal, p, p + n)
    }
    pub fn point(self, p: DVec2) -> Self {
        self.add(Mark::Dot { p, light: None })
    }
    /// A point in the colour of a light: a sample, a photon.
    pub fn spot(self, light: Light, p: DVec2) -> Self {
        self.add(Mark::Dot { p, light: Some(light) })
    }
    /// A small lamp at `p`.
    pub fn lamp(self, p: DVec2) -> Self {
        self.add(Mark::Lamp { p })
    }
    /// An eye at `p`, looking along `towards`.
    pub fn eye(self, p: DVec2, towards: DVec2) -> Self {
        self.add(Mark::Eye { p, towards })
    }
    /// The angle at `vertex` between two directions, the shorter way round.
    pub fn angle(self, vertex: DVec2, from: DVec2, to: DVec2) -> Self {
        self.angle_at(vertex, from, to, 46.0)
    }
    /// The same at another distance from the vertex \[px\], where two angles would coincide.
    pub fn angle_at(self, vertex: DVec2, from: DVec2, to: DVec2, radius: f64) -> Self {
        self.add(Mark::Angle { vertex, from, to, radius })
    }
    /// A right angle at `vertex` between two directions.
    pub fn right_angle(self, vertex: DVec2, from: DVec2, to: DVec2) -> Self {
        self.add(Mark::RightAngle { vertex, from, to })
    }
    /// The length from `a` to `b`, with an end stroke on both, moved `offset` pixels to the left of `a → b`.
    pub fn dimension(self, a: DVec2, b: DVec2, offset: f64) -> Self {
        self.add(Mark::Dimension { a, b, offset })
    }

    /// Names the last mark with a letter or formula, in italics: `t_{ca}`.
    pub fn name(self, letter: &str) -> Self {
        self.lettered(letter, letters::Style::Formula, letters::Where::Beside)
    }
    /// Names the last ray or curve at its end.
    pub fn name_end(self, letter: &str) -> Self {
        self.lettered(letter, letters::Style::Formula, letters::Where::AtEnd)
    }
    /// Describes the last mark in upright words.
    pub fn word(self, words: &str) -> Self {
        self.lettered(words, letters::Style::Words, letters::Where::Beside)
    }
    /// Words at a place, centred, that belong to no mark.
    pub fn note(mut self, p: DVec2, words: &str) -> Self {
        self.marks.push(Mark::Nothing { p });
        self.lettered(words, letters::Style::Words, letters::Where::Here)
    }
    fn lettered(mut self, text: &str, style: letters::Style, place: letters::Where) -> Self {
        if let Some(mark) = self.marks.len().checked_sub(1) {
            self.letters.push(Letter { mark, text: text.to_string(), style, place });
        }
        self
    }

    /// Draws the diagram; its height follows the window's shape.
    pub fn draw(&self) -> Drawing {
        let (min, max) = self.window.unwrap_or_else(|| marks::extent(&self.marks));
        let size = max - min;
        let mut sketch = Drawing::new(WIDTH, HEIGHT);
        let top =
            self.heading.draw(&mut sketch) - if self.heading == Heading::default() { 20.0 } else { 0.0 };
        let room = dvec2(WIDTH - 2.0 * MARGIN, HEIGHT - top - MARGIN);
        let scale = (room / size).min_element();
        let height = (top + size.y * scale + MARGIN).clamp(420.0, HEIGHT);
        let mut drawing = Drawing { height: height.ceil(), ..sketch };
        let frame = Rect::new(MARGIN, top, WIDTH - MARGIN, drawing.height - MARGIN);
        let center = (min + max) * 0.5;
        let view = View { scale, center, middle: frame.center() };
        let half = size * scale * 0.5;
        let window = Rect { min: view.middle - half, max: view.middle + half };
        marks::draw(&self.marks, &view, &window, &mut drawing);
        letters::draw(self, &view, &window, &mut drawing);
        drawing
    }
}

/// From the world to the canvas.
struct View {
    /// Pixels per unit.
    scale: f64,
    center: DVec2,
    middle: DVec2,
}

impl View {
    fn at(&self, p: DVec2) -> DVec2 {
        let q = (p - self.center) * self.scale;
        self.middle + dvec2(q.x, -q.y)
    }
    fn all(&self, points: &[DVec2]) -> Vec<DVec2> {
        points.iter().map(|p| self.at(*p)).collect()
    }
    /// A direction of the world as a unit vector on the canvas.
    fn way(&self, d: DVec2) -> DVec2 {
        dvec2(d.x, -d.y).normalize_or(DVec2::X)
    }
}

impl From<Diagram> for Figure {
    fn from(diagram: Diagram) -> Figure {
        let names: Vec<&str> = diagram.letters.iter().map(|l| l.text.as_str()).collect();
        let alt = if diagram.alt.is_empty() {
            format!("{}. Diagram with {}.", diagram.heading.sentence(), names.join(", "))
        } else {
            diagram.alt.clone()
        };
        let mut figure = Figure::new(diagram.draw(), &diagram.heading.title, &alt);
        figure.caption = diagram.heading.caption();
        figure
    }
}
