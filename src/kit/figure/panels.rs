//! Rendered pictures side by side, of equal size, with a line under each.

use super::drawing::{Anchor, Drawing, Face, Fill, Pixels, Rect, Stroke, Text};
use super::heading::{HEIGHT, Heading, MARGIN, SIZE, WIDTH, short};
use super::ink::Ink;
use super::map::{Bar, Shades, draw_bar};
use super::{Figure, font};
use glam::{DVec2, dvec2};

/// Space between pictures, and under each for its line [px].
const GAP: f64 = 16.0;
const LINE: f64 = 34.0;

/// The error of a picture, one value a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorPanel {
    pub width: usize,
    pub height: usize,
    /// Row 0 on top.
    pub values: Vec<f64>,
    pub shades: Shades,
    /// Name and unit: "|error| of radiance".
    pub name: String,
    /// Root mean square, said under the panel.
    pub rmse: f64,
    pub range: Option<(f64, f64)>,
}

#[derive(Clone, Debug, PartialEq)]
enum Panel {
    Picture { pixels: Pixels, label: String },
    Error(ErrorPanel),
}

/// Pictures in a grid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panels {
    heading: Heading,
    panels: Vec<Panel>,
    columns: Option<usize>,
    /// Column, row, width, height of the part that every picture shows magnified [pixels].
    zoom: Option<[usize; 4]>,
    alt: String,
}

impl Panels {
    pub fn new() -> Self {
        Panels::default()
    }
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    pub fn alt(mut self, alt: &str) -> Self {
        self.alt = alt.to_string();
        self
    }
    /// Pictures in a row; else the grid that shows them largest.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = Some(columns.max(1));
        self
    }
    /// A picture with the line under it.
    pub fn picture(mut self, pixels: Pixels, label: &str) -> Self {
        self.panels.push(Panel::Picture { pixels, label: label.to_string() });
        self
    }
    /// An error picture with its colour bar and root mean square.
    pub fn error(mut self, error: ErrorPanel) -> Self {
        self.panels.push(Panel::Error(error));
        self
    }
    /// Magnifies the same part of every picture, in the corner farthest from it.
    pub fn zoom(mut self, x: usize, y: usize, width: usize, height: usize) -> Self {
        self.zoom = Some([x, y, width.max(1), height.max(1)]);
        self
    }

    pub fn draw(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let top =
            self.heading.draw(&mut drawing) - if self.heading == Heading::default() { 24.0 } else { 6.0 };
        let bar = if self.panels.iter().any(|p| matches!(p, Panel::Error(_))) { 118.0 } else { 0.0 };
        let room = dvec2(WIDTH - 2.0 * MARGIN - bar, HEIGHT - top - MARGIN * 0.6);
        let aspect = self.panels.iter().find_map(aspect_of).unwrap_or(1.5);
        let (columns, size) = self.grid(room, aspect);
        let rows = self.panels.len().div_ceil(columns).max(1);
        let used = dvec2(
            columns as f64 * (size.x + GAP) - GAP + bar,
            rows as f64 * (size.y + LINE) + (rows - 1) as f64 * GAP * 0.5,
        );
        let left = if self.heading == Heading::default() { (WIDTH - used.x) / 2.0 } else { MARGIN };
        drawing.height = (top + used.y + MARGIN * 0.6).ceil().min(HEIGHT);
        for (i, panel) in self.panels.iter().enumerate() {
            let step = dvec2(size.x + GAP, size.y + LINE + GAP * 0.5);
            let corner = dvec2(left, top) + step * dvec2((i % columns) as f64, (i / columns) as f64);
            let place = Rect { min: corner.round(), max: corner.round() + size };
            self.panel(panel, place, &mut drawing);
        }
        drawing
    }

    /// The number of columns that gives the largest pictures, and their size.
    fn grid(&self, room: DVec2, aspect: f64) -> (usize, DVec2) {
        let count = self.panels.len().max(1);
        let size = |columns: usize| {
            let rows = count.div_ceil(columns) as f64;
            let c = columns as f64;
            let width = (room.x - GAP * (c - 1.0)) / c;
            let height = (room.y - rows * LINE - (rows - 1.0) * GAP * 0.5) / rows;
            let width = width.min(height * aspect).max(8.0);
            dvec2(width.floor(), (width / aspect).floor().max(8.0))
        };
        match self.columns {
            Some(columns) => (columns, size(columns)),
            None => (1..=count)
                .map(|c| (c, size(c)))
                .fold((1, DVec2::ZERO), |best, this| if this.1.x > best.1.x { this } else { best }),
        }
    }

    fn panel(&self, panel: &Panel, place: Rect, drawing: &mut Drawing) {
        let label = match panel {
            Panel::Picture { pixels, label } => {
                drawing.image(place, pixels.clone());
                self.inset(pixels, &place, drawing);
                label.clone()
            }
            Panel::Error(error) => {
                let strip =
                    Rect::new(place.max.x + 14.0, place.min.y + 28.0, place.max.x + 32.0, place.max.y);
                let bar = Bar::over(error.values.iter().copied(), error.shades, error.range, strip);
                let pixels = Pixels::new(
                    error.width,
                    error.height,
                    error.values.iter().flat_map(|v| bar.color(*v)).collect(),
                );
                drawing.image(place, pixels.clone());
                self.inset(&pixels, &place, drawing);
                draw_bar(&bar, "", error.shades, drawing);
                format!("{}, RMSE {}", error.name, short(error.rmse))
            }
        };
        let mut size = SIZE;
        while size > 13.0 && font::width(&label, Face::Regular, size) > place.width() {
            size *= 0.95;
        }
        let at = dvec2(place.center().x, place.max.y + 24.0);
        drawing.text(Text::new(at, label, size, Ink::Text).anchor(Anchor::Middle));
    }

    /// The magnified part in a corner, and the frame of where it is.
    fn inset(&self, pixels: &Pixels, place: &Rect, drawing: &mut Drawing) {
        let Some([x, y, w, h]) = self.zoom else { return };
        let part = pixels.cropped(x, y, w, h);
        if part.width == 0 || part.height == 0 {
            return;
        }
        let scale = dvec2(place.width() / pixels.width as f64, place.height() / pixels.height as f64);
        let from = Rect {
            min: place.min + dvec2(x as f64, y as f64) * scale,
            max: place.min + dvec2((x + part.width) as f64, (y + part.height) as f64) * scale,
        };
        let factor =
            (0.42 * place.width() / part.width as f64).min(0.42 * place.height() / part.height as f64);
        let size = dvec2(part.width as f64, part.height as f64) * factor.max(1.0);
        let corner = |low: f64, high: f64, at: f64, size: f64| {
            if at > (low + high) / 2.0 { low + 6.0 } else { high - 6.0 - size }
        };
        let min = dvec2(
            corner(place.min.x, place.max.x, from.center().x, size.x),
            corner(place.min.y, place.max.y, from.center().y, size.y),
        );
        let to = Rect { min: min.round(), max: (min + size).round() };
        let light = || Stroke::new(Ink::Fixed([255, 255, 255]), 2.2);
        let dark = || Stroke::new(Ink::Fixed([20, 22, 28]), 4.0).faint(0.6);
        for frame in [&from, &to] {
            drawing.rect(*frame, None, Some(dark()));
        }
        drawing.rect(to, Some(Fill::new(Ink::Fixed([255, 255, 255]))), None);
        drawing.image(to, part);
        for frame in [&from, &to] {
            drawing.rect(*frame, None, Some(light()));
        }
    }
}

fn aspect_of(panel: &Panel) -> Option<f64> {
    let (w, h) = match panel {
        Panel::Picture { pixels, .. } => (pixels.width, pixels.height),
        Panel::Error(error) => (error.width, error.height),
    };
    (w > 0 && h > 0).then(|| (w as f64 / h as f64).clamp(0.1, 10.0))
}

impl From<Panels> for Figure {
    fn from(panels: Panels) -> Figure {
        let labels: Vec<&str> = panels
            .panels
            .iter()
            .map(|p| match p {
                Panel::Picture { label, .. } => label.as_str(),
                Panel::Error(error) => error.name.as_str(),
            })
            .collect();
        let alt = if panels.alt.is_empty() {
            format!("{}. Pictures: {}.", panels.heading.sentence(), labels.join("; "))
        } else {
            panels.alt.clone()
        };
        let mut figure = Figure::new(panels.draw(), &panels.heading.title, &alt);
        figure.caption = panels.heading.caption();
        figure
    }
}
