//! Maps of a value over two axes: where a method fails, and how badly.

use super::axis::{Axis, Ruler};
use super::colormap::{diverging, viridis};
use super::drawing::{Anchor, Chain, Drawing, Ends, Face, Fill, Item, Pixels, Rect, Stroke, Text};
use super::heading::{HEIGHT, Heading, MARGIN, SIZE, WIDTH, percent};
use super::ink::{Ink, Srgb};
use super::label::{Candidate, Placer};
use super::{Data, Figure, Repeats, font};
use glam::{DVec2, dvec2};

/// How values become colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shades {
    /// Magnitude on a logarithm: viridis, in decades.
    Decades,
    /// Magnitude: viridis.
    Linear,
    /// Signed error: blue, white at 0, vermillion.
    Signed,
}

/// A map: cells over two axes, and the region where the method fails outlined and hatched.
#[derive(Clone, Debug, PartialEq)]
pub struct FailureMap {
    heading: Heading,
    x: Axis,
    y: Axis,
    /// Name and unit of the value.
    value: String,
    shades: Shades,
    range: Option<(f64, f64)>,
    columns: usize,
    rows: usize,
    /// Row by row, the lowest row first.
    cells: Vec<f64>,
    failed: Vec<bool>,
    failing: String,
}

impl FailureMap {
    /// A map over two axes with given ranges, of `columns × rows` cells. `cell(x, y)` gives the value in the middle of
    /// each cell, or `None` where the method fails; NaN is no value, and is drawn as failing too.
    ///
    /// # Panics
    /// In debug builds, if an axis has no range.
    pub fn new(
        x: Axis,
        y: Axis,
        value: &str,
        (columns, rows): (usize, usize),
        mut cell: impl FnMut(f64, f64) -> Option<f64>,
    ) -> Self {
        let across = x.ruler(std::iter::empty(), 0.0, columns as f64);
        let up = y.ruler(std::iter::empty(), 0.0, rows as f64);
        let mut cells = Vec::with_capacity(columns * rows);
        for j in 0..rows {
            for i in 0..columns {
                let at = cell(across.value(i as f64 + 0.5), up.value(j as f64 + 0.5));
                cells.push(at.unwrap_or(f64::NAN));
            }
        }
        let failed = cells.iter().map(|v| v.is_nan()).collect();
        FailureMap {
            heading: Heading::default(),
            x,
            y,
            value: value.to_string(),
            shades: Shades::Decades,
            range: None,
            columns,
            rows,
            cells,
            failed,
            failing: "fails".to_string(),
        }
    }
    pub fn title(mut self, title: &str) -> Self {
        self.heading.title = title.to_string();
        self
    }
    pub fn subtitle(mut self, subtitle: &str) -> Self {
        self.heading.subtitle = subtitle.to_string();
        self
    }
    pub fn shades(mut self, shades: Shades) -> Self {
        self.shades = shades;
        self
    }
    /// The values at the ends of the colour bar.
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }
    /// Also fails where the value exceeds this; `word` says so in the region: "misses".
    pub fn failing_above(mut self, threshold: f64, word: &str) -> Self {
        for (failed, value) in self.failed.iter_mut().zip(&self.cells) {
            *failed = value.is_nan() || value.abs() > threshold;
        }
        self.failing = word.to_string();
        self
    }
    /// What the failing region is called.
    pub fn failing(mut self, word: &str) -> Self {
        self.failing = word.to_string();
        self
    }
    /// Share of the map that fails, in `[0,1]`.
    pub fn failing_share(&self) -> f64 {
        let failed = self.failed.iter().filter(|f| **f).count();
        failed as f64 / self.failed.len().max(1) as f64
    }

    pub fn draw(&self) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, HEIGHT);
        let top = self.heading.draw(&mut drawing);
        let area_top = top + 1.6 * SIZE;
        let bottom = HEIGHT - MARGIN - 1.9 * SIZE;
        let probe = self.y.ruler(std::iter::empty(), bottom, area_top);
        let widest = probe.ticks().iter().map(|t| font::width(&t.1, Face::Regular, SIZE)).fold(0.0, f64::max);
        let area = Rect::new(MARGIN + widest + 18.0, area_top, WIDTH - MARGIN - 190.0, bottom);
        let x = self.x.ruler(std::iter::empty(), area.min.x, area.max.x);
        drawing.text(Text::new(dvec2(MARGIN, top + SIZE * 0.75), &self.y.title, SIZE, Ink::Text));
        let under = dvec2(area.max.x, HEIGHT - MARGIN + 14.0);
        drawing.text(Text::new(under, &self.x.title, SIZE, Ink::Text).anchor(Anchor::End));
        let bar = self.bar(&area);
        drawing.image(area, self.pixels(&bar));
        self.region(&area, &mut drawing);
        ticks(&x, &probe, &area, &mut drawing);
        draw_bar(&bar, &self.value, self.shades, &mut drawing);
        drawing
    }

    fn bar(&self, area: &Rect) -> Bar {
        let place = Rect::new(area.max.x + 34.0, area.min.y, area.max.x + 60.0, area.max.y);
        Bar::over(self.cells.iter().copied(), self.shades, self.range, place)
    }

    fn pixels(&self, bar: &Bar) -> Pixels {
        let cells = (0..self.rows).rev().flat_map(|j| (0..self.columns).map(move |i| j * self.columns + i));
        let rgb = cells.flat_map(|k| bar.color(self.cells[k])).collect();
        Pixels::new(self.columns, self.rows, rgb)
    }

    /// The failing region: hatched, outlined, with its share in the freest part of it.
    fn region(&self, area: &Rect, drawing: &mut Drawing) {
        let share = self.failing_share();
        if share == 0.0 {
            return;
        }
        let size = dvec2(area.width() / self.columns as f64, area.height() / self.rows as f64);
        let corner =
            |i: usize, j: usize| dvec2(area.min.x + i as f64 * size.x, area.max.y - j as f64 * size.y);
        let at = |i: usize, j: usize| self.failed[j * self.columns + i];
        let mut runs = Vec::new();
        for j in 0..self.rows {
            let mut i = 0;
            while i < self.columns {
                let start = i;
                while i < self.columns && at(i, j) {
                    i += 1;
                }
                if i > start {
                    let (low, high) = (corner(start, j), corner(i, j + 1));
                    let box_of = Rect::new(low.x, high.y, high.x, low.y);
                    runs.push(Chain { points: box_of.corners().to_vec(), ends: Ends::Closed });
                }
                i += 1;
            }
        }
        let fill = Some(Fill::hatched(Ink::Fixed([255, 255, 255])).faint(0.6));
        drawing.items.push(Item::Path { chains: runs, fill, stroke: None });
        let edges = self.edges(&corner);
        let dark = Some(Stroke::new(Ink::Fixed([20, 22, 28]), 2.4));
        drawing.items.push(Item::Path { chains: edges, fill: None, stroke: dark });
        self.share_label(share, area, size, drawing);
    }

    /// The borders between cells that fail and cells that do not.
    fn edges(&self, corner: &impl Fn(usize, usize) -> DVec2) -> Vec<Chain> {
        let at = |i: usize, j: usize| self.failed[j * self.columns + i];
        let mut chains = Vec::new();
        let mut push = |a: DVec2, b: DVec2| chains.push(Chain { points: vec![a, b], ends: Ends::Open });
        for j in 0..self.rows {
            for i in 0..self.columns {
                if i + 1 < self.columns && at(i, j) != at(i + 1, j) {
                    push(corner(i + 1, j), corner(i + 1, j + 1));
                }
                if j + 1 < self.rows && at(i, j) != at(i, j + 1) {
                    push(corner(i, j + 1), corner(i + 1, j + 1));
                }
            }
        }
        chains
    }

    /// "misses: 12 %", as far inside the region as it goes.
    fn share_label(&self, share: f64, area: &Rect, size: DVec2, drawing: &mut Drawing) {
        let text = format!("{}: {}", self.failing, percent(share));
        let text = Text::new(DVec2::ZERO, text, SIZE * 1.1, Ink::Fixed([20, 22, 28]))
            .face(Face::Bold)
            .anchor(Anchor::Middle);
        let half = dvec2(text.bounds().width() / 2.0 + 12.0, SIZE * 0.95);
        let mut placer = Placer::new(*area);
        for (k, failed) in self.failed.iter().enumerate() {
            let low = dvec2(area.min.x, area.max.y)
                + dvec2((k % self.columns) as f64, -((k / self.columns) as f64) - 1.0) * size;
            if !failed {
                placer.keep_clear(Rect { min: low, max: low + size });
            }
        }
        let candidates: Vec<Candidate> = (0..400)
            .map(|k| {
                let share = dvec2((k % 20) as f64 + 0.5, (k / 20) as f64 + 0.5) / 20.0;
                let center = area.min + half + share * (area.max - area.min - half * 2.0);
                // Where the region is wide, the middle of it: its surroundings should be free as well.
                let reach = Rect {
                    min: (center - half * 1.8).max(area.min),
                    max: (center + half * 1.8).min(area.max),
                };
                Candidate {
                    place: Rect { min: center - half, max: center + half },
                    penalty: 0.3 * placer.cost(&reach).min(1.0e5),
                }
            })
            .collect();
        if let Some((best, _)) = placer.best(&candidates) {
            let place = candidates[best].place;
            drawing.rect(place, Some(Fill::new(Ink::Fixed([255, 255, 255])).faint(0.92)), None);
            drawing.text(Text { at: place.center() + dvec2(0.0, SIZE * 0.38), ..text });
        }
    }

    fn csv(&self) -> String {
        let x = self.x.ruler(std::iter::empty(), 0.0, self.columns as f64);
        let y = self.y.ruler(std::iter::empty(), 0.0, self.rows as f64);
        let mut text = String::from("x,y,value,fails\n");
        for (k, value) in self.cells.iter().enumerate() {
            let at = (x.value((k % self.columns) as f64 + 0.5), y.value((k / self.columns) as f64 + 0.5));
            let cell = if value.is_nan() { String::new() } else { format!("{value:e}") };
            text += &format!("{:e},{:e},{cell},{}\n", at.0, at.1, u8::from(self.failed[k]));
        }
        text
    }
}

impl From<FailureMap> for Figure {
    fn from(map: FailureMap) -> Figure {
        let alt = format!(
            "{}. Map of {} over {} and {}; {} of it fails.",
            map.heading.sentence(),
            map.value,
            map.x.title,
            map.y.title,
            percent(map.failing_share())
        );
        let mut figure = Figure::new(map.draw(), &map.heading.title, &alt);
        figure.caption = map.heading.caption();
        figure.data.push(Data { repeats: Repeats::Always, csv: map.csv() });
        figure
    }
}

fn ticks(x: &Ruler, y: &Ruler, area: &Rect, drawing: &mut Drawing) {
    let axis = || Stroke::new(Ink::Outline, 1.4);
    for (value, label) in x.ticks() {
        let Some(px) = x.inside(value) else { continue };
        drawing.line(dvec2(px, area.max.y + 2.0), dvec2(px, area.max.y + 8.0), axis());
        let at = dvec2(px, area.max.y + 10.0 + SIZE * 0.85);
        drawing.text(Text::new(at, label, SIZE, Ink::Muted).anchor(Anchor::Middle));
    }
    for (value, label) in y.ticks() {
        let Some(py) = y.inside(value) else { continue };
        drawing.line(dvec2(area.min.x - 8.0, py), dvec2(area.min.x - 2.0, py), axis());
        let at = dvec2(area.min.x - 13.0, py + SIZE * 0.35);
        drawing.text(Text::new(at, label, SIZE, Ink::Muted).anchor(Anchor::End));
    }
}

/// The scale of colours, laid out beside a picture.
pub struct Bar {
    ruler: Ruler,
    shades: Shades,
    place: Rect,
    has_zero: bool,
}

impl Bar {
    pub fn over(
        values: impl Iterator<Item = f64> + Clone,
        shades: Shades,
        range: Option<(f64, f64)>,
        place: Rect,
    ) -> Bar {
        let has_zero = values.clone().any(|v| v == 0.0);
        let axis = match shades {
            Shades::Decades => Axis::log(""),
            _ => Axis::linear(""),
        };
        let axis = match (range, shades) {
            (Some((low, high)), _) => axis.range(low, high),
            (None, Shades::Signed) => {
                let most = values.clone().filter(|v| v.is_finite()).fold(0.0f64, |m, v| m.max(v.abs()));
                let most = if most > 0.0 { most } else { 1.0 };
                axis.range(-most, most)
            }
            _ => axis,
        };
        let magnitudes = values.map(|v| if shades == Shades::Decades { v.abs() } else { v });
        let ruler = axis.ruler(magnitudes, place.max.y, place.min.y);
        Bar { ruler, shades, place, has_zero }
    }

    /// The colour of a value; zero on a logarithm is the darkest.
    pub fn color(&self, value: f64) -> Srgb {
        let share = |v: f64| {
            let p = self.ruler.at(v)?;
            Some((p - self.ruler.start) / (self.ruler.end - self.ruler.start))
        };
        match self.shades {
            Shades::Decades if value == 0.0 => viridis(0.0),
            Shades::Decades => viridis(share(value.abs()).unwrap_or(f64::NAN)),
            Shades::Linear => viridis(share(value).unwrap_or(f64::NAN)),
            Shades::Signed => diverging(share(value).map_or(f64::NAN, |s| 2.0 * s - 1.0)),
        }
    }
}

/// The bar with its ticks, and its name above.
pub fn draw_bar(bar: &Bar, name: &str, shades: Shades, drawing: &mut Drawing) {
    const STEPS: usize = 256;
    let at = |k: usize| 1.0 - k as f64 / (STEPS - 1) as f64;
    let color = |t: f64| if shades == Shades::Signed { diverging(2.0 * t - 1.0) } else { viridis(t) };
    drawing.image(bar.place, Pixels::new(1, STEPS, (0..STEPS).flat_map(|k| color(at(k))).collect()));
    for (value, label) in bar.ruler.ticks() {
        let Some(y) = bar.ruler.inside(value) else { continue };
        drawing.line(
            dvec2(bar.place.max.x, y),
            dvec2(bar.place.max.x + 5.0, y),
            Stroke::new(Ink::Outline, 1.4),
        );
        let at = dvec2(bar.place.max.x + 10.0, y + SIZE * 0.35);
        drawing.text(Text::new(at, label, SIZE, Ink::Muted));
    }
    let right = drawing.width - MARGIN * 0.5;
    let lines = font::wrapped(name, Face::Regular, SIZE, right - bar.place.min.x + 60.0);
    let first = bar.place.min.y - 14.0 - (lines.len().max(1) - 1) as f64 * SIZE * 1.2;
    for (i, line) in lines.into_iter().enumerate() {
        let at = dvec2(right, first + i as f64 * SIZE * 1.2);
        drawing.text(Text::new(at, line, SIZE, Ink::Text).anchor(Anchor::End));
    }
    if bar.has_zero && shades == Shades::Decades {
        let at = dvec2(bar.place.min.x, bar.place.max.y + SIZE * 1.2);
        drawing.text(Text::new(at, "exact: darkest", SIZE * 0.85, Ink::Muted));
    }
}
