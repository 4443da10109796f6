//! A drawing: the list of marks on a canvas, from the back to the front. Two writers read it, SVG and PNG.

use super::ink::{Ink, Srgb};
use crate::color::srgb_encode;
use crate::film::Image;
use glam::{DVec2, dvec2};

/// An upright rectangle on the canvas \[px\], y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    pub min: DVec2,
    pub max: DVec2,
}

impl Rect {
    pub fn new(x0: f64, y0: f64, x1: f64, y1: f64) -> Self {
        Rect { min: dvec2(x0, y0), max: dvec2(x1, y1) }
    }
    pub fn width(&self) -> f64 {
        self.max.x - self.min.x
    }
    pub fn height(&self) -> f64 {
        self.max.y - self.min.y
    }
    pub fn center(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }
    pub fn grown(&self, by: f64) -> Rect {
        Rect { min: self.min - by, max: self.max + by }
    }
    pub fn shifted(&self, by: DVec2) -> Rect {
        Rect { min: self.min + by, max: self.max + by }
    }
    pub fn holds(&self, p: DVec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }
    pub fn covers(&self, other: &Rect) -> bool {
        self.holds(other.min) && self.holds(other.max)
    }
    /// Area that the two share \[px²\].
    pub fn overlap(&self, other: &Rect) -> f64 {
        let size = self.max.min(other.max) - self.min.max(other.min);
        size.x.max(0.0) * size.y.max(0.0)
    }
    pub fn corners(&self) -> [DVec2; 4] {
        [self.min, dvec2(self.max.x, self.min.y), self.max, dvec2(self.min.x, self.max.y)]
    }
}

/// A chain of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    pub points: Vec<DVec2>,
    pub ends: Ends,
}

/// How a chain ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    Open,
    Closed,
}

/// The inside of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fill {
    pub ink: Ink,
    pub opacity: f64,
    pub pattern: Pattern,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    Solid,
    /// Thin lines at 45°.
    Hatched,
}

/// Hatching: period across the lines and their width \[px\].
pub const HATCH_PERIOD: f64 = 9.0;
pub const HATCH_WIDTH: f64 = 1.6;

/// The edge of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    pub ink: Ink,
    pub width: f64,
    pub opacity: f64,
    /// Lengths of dash and gap in turn \[px\]; empty for a whole line.
    pub dash: Vec<f64>,
}

impl Stroke {
    pub fn new(ink: Ink, width: f64) -> Self {
        Stroke { ink, width, opacity: 1.0, dash: Vec::new() }
    }
    pub fn dashed(mut self, dash: &[f64]) -> Self {
        self.dash = dash.to_vec();
        self
    }
    pub fn faint(mut self, opacity: f64) -> Self {
        self.opacity = opacity;
        self
    }
}

impl Fill {
    pub fn new(ink: Ink) -> Self {
        Fill { ink, opacity: 1.0, pattern: Pattern::Solid }
    }
    pub fn hatched(ink: Ink) -> Self {
        Fill { ink, opacity: 1.0, pattern: Pattern::Hatched }
    }
    pub fn faint(mut self, opacity: f64) -> Self {
        self.opacity = opacity;
        self
    }
}

/// Which letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    Regular,
    Bold,
    /// For the letters of formulas.
    Italic,
}

/// Where a text hangs on its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// One line of text on a baseline; `_{…}` and `^{…}` are set lower and higher.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    pub at: DVec2,
    pub text: String,
    /// Font size \[px\].
    pub size: f64,
    pub face: Face,
    pub ink: Ink,
    pub anchor: Anchor,
    /// Width of the ground-coloured rim round the letters \[px\].
    pub halo: f64,
}

impl Text {
    pub fn new(at: DVec2, text: impl Into<String>, size: f64, ink: Ink) -> Self {
        Text { at, text: text.into(), size, face: Face::Regular, ink, anchor: Anchor::Start, halo: 0.0 }
    }
    pub fn face(mut self, face: Face) -> Self {
        self.face = face;
        self
    }
    pub fn anchor(mut self, anchor: Anchor) -> Self {
        self.anchor = anchor;
        self
    }
    pub fn halo(mut self, width: f64) -> Self {
        self.halo = width;
        self
    }
    /// The box round the letters: as wide as the text is set, from ascender to descender.
    pub fn bounds(&self) -> Rect {
        let (width, rise, fall) =
            (super::font::width(&self.text, self.face, self.size), self.size * 0.78, self.size * 0.24);
        let start = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -width / 2.0,
            Anchor::End => -width,
        };
        Rect::new(start, -rise, start + width, fall).shifted(self.at)
    }
}

/// A picture of 8-bit sRGB pixels, row 0 on top.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixels {
    pub width: usize,
    pub height: usize,
    /// `3 · width · height` bytes.
    pub rgb: Vec<u8>,
}

impl Pixels {
    /// # Panics
    /// If the number of bytes is not `3 · width · height`.
    pub fn new(width: usize, height: usize, rgb: Vec<u8>) -> Self {
        assert_eq!(rgb.len(), 3 * width * height, "a picture of {width} × {height} pixels");
        Pixels { width, height, rgb }
    }
    pub fn get(&self, x: usize, y: usize) -> Srgb {
        let i = 3 * (y * self.width + x);
        [self.rgb[i], self.rgb[i + 1], self.rgb[i + 2]]
    }
    /// The part from column `x` and row `y` on; what lies outside is left out.
    pub fn cropped(&self, x: usize, y: usize, width: usize, height: usize) -> Pixels {
        let (x1, y1) = ((x + width).min(self.width), (y + height).min(self.height));
        let (x, y) = (x.min(x1), y.min(y1));
        let rgb = (y..y1).flat_map(|row| (x..x1).flat_map(move |col| self.get(col, row))).collect();
        Pixels { width: x1 - x, height: y1 - y, rgb }
    }
}

/// A linear picture as a display shows it: cut off at 1, sRGB, 8 bits.
impl From<&Image> for Pixels {
    fn from(image: &Image) -> Self {
        let byte = |x: f64| (srgb_encode(x.clamp(0.0, 1.0)) * 255.0).round() as u8;
        let rgb = image.pixels().iter().flat_map(|p| p.to_array().map(byte)).collect();
        Pixels::new(image.width(), image.height(), rgb)
    }
}

/// One mark.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    Path {
        chains: Vec<Chain>,
        fill: Option<Fill>,
        stroke: Option<Stroke>,
    },
    Circle {
        center: DVec2,
        radius: f64,
        fill: Option<Fill>,
        stroke: Option<Stroke>,
    },
    Text(Text),
    /// Pixels stay squares where the picture is magnified, and are averaged where it shrinks.
    Image {
        place: Rect,
        pixels: Pixels,
    },
    /// Marks of which only the part inside the rectangle shows.
    Clipped {
        to: Rect,
        items: Vec<Item>,
    },
}

/// The marks on a canvas.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// \[px\].
    pub width: f64,
    pub height: f64,
    pub items: Vec<Item>,
    /// The heading at the top: down to where it reaches \[px\], and how many of the first items it is.
    pub heading: (f64, usize),
}

impl Drawing {
    pub fn new(width: f64, height: f64) -> Self {
        Drawing { width, height, items: Vec::new(), heading: (0.0, 0) }
    }
    pub fn bounds(&self) -> Rect {
        Rect::new(0.0, 0.0, self.width, self.height)
    }
    /// The drawing without its heading, the room closed up: for a slide or a page that has the heading as text.
    pub fn without_heading(mut self) -> Self {
        let (height, count) = self.heading;
        self.items.drain(..count.min(self.items.len()));
        shift(&mut self.items, dvec2(0.0, -height));
        self.height -= height;
        self.heading = (0.0, 0);
        self
    }
    /// The drawing with another below it.
    pub fn above(mut self, mut below: Drawing) -> Self {
        shift(&mut below.items, dvec2(0.0, self.height));
        self.items.append(&mut below.items);
        self.height += below.height;
        self.width = self.width.max(below.width);
        self
    }
    /// Size of the smallest text \[px\]; `None` if there is none.
    pub fn smallest_text(&self) -> Option<f64> {
        fn sizes(items: &[Item], smallest: &mut f64) {
            for item in items {
                match item {
                    Item::Text(text) => *smallest = smallest.min(text.size),
                    Item::Clipped { items, .. } => sizes(items, smallest),
                    _ => {}
                }
            }
        }
        let mut smallest = f64::INFINITY;
        sizes(&self.items, &mut smallest);
        smallest.is_finite().then_some(smallest)
    }
    pub fn line(&mut self, a: DVec2, b: DVec2, stroke: Stroke) {
        self.chain(&[a, b], stroke);
    }
    pub fn chain(&mut self, points: &[DVec2], stroke: Stroke) {
        if points.len() < 2 || points.iter().any(|p| !p.is_finite()) {
            return;
        }
        let chains = vec![Chain { points: points.to_vec(), ends: Ends::Open }];
        self.items.push(Item::Path { chains, fill: None, stroke: Some(stroke) });
    }
    pub fn polygon(&mut self, points: &[DVec2], fill: Option<Fill>, stroke: Option<Stroke>) {
        if points.len() < 3 || points.iter().any(|p| !p.is_finite()) {
            return;
        }
        let chains = vec![Chain { points: points.to_vec(), ends: Ends::Closed }];
        self.items.push(Item::Path { chains, fill, stroke });
    }
    pub fn rect(&mut self, rect: Rect, fill: Option<Fill>, stroke: Option<Stroke>) {
        self.polygon(&rect.corners(), fill, stroke);
    }
    pub fn circle(&mut self, center: DVec2, radius: f64, fill: Option<Fill>, stroke: Option<Stroke>) {
        if center.is_finite() && radius.is_finite() && radius > 0.0 {
            self.items.push(Item::Circle { center, radius, fill, stroke });
        }
    }
    pub fn text(&mut self, text: Text) {
        if !text.text.is_empty() && text.at.is_finite() {
            self.items.push(Item::Text(text));
        }
    }
    pub fn image(&mut self, place: Rect, pixels: Pixels) {
        if pixels.width > 0 && pixels.height > 0 {
            self.items.push(Item::Image { place, pixels });
        }
    }
    /// Adds what `draw` draws, cut to a rectangle.
    pub fn clipped(&mut self, to: Rect, draw: impl FnOnce(&mut Drawing)) {
        let mut inner = Drawing::new(self.width, self.height);
        draw(&mut inner);
        if !inner.items.is_empty() {
            self.items.push(Item::Clipped { to, items: inner.items });
        }
    }
    /// A line with a small filled head at `b`.
    pub fn arrow(&mut self, a: DVec2, b: DVec2, stroke: Stroke) {
        let length = a.distance(b);
        if length.is_nan() || length < 1.0e-6 {
            return;
        }
        let ahead = (b - a) / length;
        let (reach, half) = head_size(stroke.width);
        let (reach, half) = (reach.min(length), half.min(length * 0.5));
        let side = dvec2(-ahead.y, ahead.x) * half;
        // The notch: the shaft ends inside the head, which tapers backwards.
        let back = b - ahead * reach;
        let notch = b - ahead * (reach * 0.78);
        let fill = Fill { ink: stroke.ink, opacity: stroke.opacity, pattern: Pattern::Solid };
        self.line(a, notch, stroke);
        self.polygon(&[b, back + side, notch, back - side], Some(fill), None);
    }
    /// Every text in the drawing, also the clipped ones.
    pub fn texts(&self) -> Vec<&Text> {
        fn collect<'a>(items: &'a [Item], into: &mut Vec<&'a Text>) {
            for item in items {
                match item {
                    Item::Text(text) => into.push(text),
                    Item::Clipped { items, .. } => collect(items, into),
                    _ => {}
                }
            }
        }
        let mut texts = Vec::new();
        collect(&self.items, &mut texts);
        texts
    }
}

/// Length and half width of an arrow's head for a line of that width \[px\].
pub fn head_size(width: f64) -> (f64, f64) {
    (8.0 + 4.0 * width, 2.4 + 1.75 * width)
}

/// Points of a circular arc from angle `a` to `b` [rad, counterclockwise on paper], about 3 px apart.
pub fn arc(center: DVec2, radius: f64, a: f64, b: f64) -> Vec<DVec2> {
    let n = (((b - a).abs() * radius / 3.0).ceil() as usize).clamp(8, 720);
    (0..=n)
        .map(|i| a + (b - a) * i as f64 / n as f64)
        .map(|t| center + radius * dvec2(t.cos(), -t.sin()))
        .collect()
}

/// Moves marks \[px\].
fn shift(items: &mut [Item], by: DVec2) {
    for item in items {
        match item {
            Item::Path { chains, .. } => chains.iter_mut().flat_map(|c| &mut c.points).for_each(|p| *p += by),
            Item::Circle { center, .. } => *center += by,
            Item::Text(text) => text.at += by,
            Item::Image { place, .. } => *place = place.shifted(by),
            Item::Clipped { to, items } => {
                *to = to.shifted(by);
                shift(items, by);
            }
        }
    }
}
