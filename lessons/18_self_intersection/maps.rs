//! Maps of wrong answers over size and distance, side by side.

use super::contest::{Axes, Score};
use glam::{DVec2, dvec2};
use lightbench_kit::figure::colormap::viridis;
use lightbench_kit::figure::drawing::{Anchor, Chain, Ends, Face, Fill, Item, Rect, Stroke, Text};
use lightbench_kit::figure::heading::{HEIGHT, Heading, MARGIN, SIZE, WIDTH, percent, power_of_ten};
use lightbench_kit::figure::ink::Ink;
use lightbench_kit::figure::{Drawing, Figure, Pixels, font};

/// One method's map: share of wrong answers, cell by cell as [`Axes::cells`] has them.
pub struct Panel {
    pub label: String,
    pub wrong: Vec<u64>,
    /// Asked in each cell.
    pub of: Vec<u64>,
}

impl Panel {
    pub fn new(label: &str, scores: &[Score], count: impl Fn(&Score) -> (u64, u64)) -> Self {
        let (wrong, of) = scores.iter().map(count).unzip();
        Panel { label: label.to_string(), wrong, of }
    }

    fn share(&self, cell: usize) -> f64 {
        self.wrong[cell] as f64 / self.of[cell].max(1) as f64
    }

    /// Share of the cells in which anything is wrong.
    pub fn failing(&self) -> f64 {
        self.wrong.iter().filter(|w| **w > 0).count() as f64 / self.wrong.len().max(1) as f64
    }
}

/// Words above and below a figure of maps.
pub struct Words {
    title: &'static str,
    subtitle: &'static str,
    caption: &'static str,
    /// What a wrong answer is called.
    wrong: &'static str,
}

pub const SHADOWS: Words = Words {
    title: "False shadows: a fixed length is too short for large things and far ones",
    subtitle: "lights above the tangent plane of eight shapes, half of them near its horizon; share for which a shadow was found",
    caption: "Where the surface shadows itself, over the size of the object and its distance from the world's origin. Rounding errors grow \
        to the upper right; a fixed length does not. A start ahead along the ray rises least where light grazes, hence the many false shadows \
        of such rules. To skip the object finds no shadow at all, here rightly: these shapes cannot stand in their own light.",
    wrong: "false shadows",
};

pub const LEAKS: Words = Words {
    title: "Leaks: the same length is too long for small things",
    subtitle: "lights below the tangent plane, as bumpy normals ask for, half of them near its horizon; share that came through",
    caption: "Where light comes through the body. A start that is raised by much sees over the horizon, and past the whole object where \
        it is small. Rules that go ahead along the ray also pass every open surface: plane, disc and triangle are three of the eight shapes. \
        The integer offset leaks where its coordinates lie below 1/32 m, for there it has a fixed length too.",
    wrong: "leaks",
};

pub const SINGLE: Words = Words {
    title: "32 bits: the integer offset holds from metres on, the error bound everywhere",
    subtitle: "a sphere in single precision, false shadows and leaks together; farther away 24 bits do not know the surface",
    caption: "Single precision throughout, as on graphics cards. The published offset of 256 units in the last place knows no unit of length where \
        coordinates are large; below 1/32 m it becomes 2⁻¹⁶ m, and leaks. The bound of double precision with its own u is never wrong. The \
        window in which a fixed bias works is a stripe, a decade or two wide, and wanders with the distance.",
    wrong: "wrong answers",
};

/// Colours from one wrong answer in 10⁴ to all.
const DECADES: f64 = 4.0;
/// No wrong answer at all: its own colour.
const ZERO: Ink = Ink::Surface;
const DARK: Ink = Ink::Fixed([20, 22, 28]);
const WHITE: Ink = Ink::Fixed([255, 255, 255]);

pub fn figure(panels: &[Panel], axes: &Axes, columns: usize, words: &Words) -> Figure {
    let mut drawing = Drawing::new(WIDTH, HEIGHT);
    let heading = Heading { title: words.title.to_string(), subtitle: words.subtitle.to_string() };
    let top = heading.draw(&mut drawing);
    let rows = panels.len().div_ceil(columns);
    let (left, right) = (MARGIN + 52.0, WIDTH - MARGIN - 116.0);
    let (above, bottom) = (top + 1.5 * SIZE, HEIGHT - MARGIN - 1.3 * SIZE);
    drawing.text(Text::new(
        dvec2(MARGIN, top + SIZE * 0.6),
        "distance from the origin, sizes",
        SIZE,
        Ink::Text,
    ));
    let under = dvec2(right - 20.0, HEIGHT - MARGIN + 20.0);
    drawing.text(Text::new(under, "size of the object, m", SIZE, Ink::Text).anchor(Anchor::End));
    let step = dvec2((right - left) / columns as f64, (bottom - above) / rows as f64);
    for (k, panel) in panels.iter().enumerate() {
        let at = (k % columns, k / columns);
        let corner = dvec2(left, above) + step * dvec2(at.0 as f64, at.1 as f64);
        let area = Rect { min: corner + dvec2(0.0, 30.0), max: corner + step - dvec2(20.0, 12.0) };
        one(panel, axes, &area, &mut drawing);
        if at.0 == 0 {
            up(axes, &area, &mut drawing);
        }
        if k + columns >= panels.len() {
            across(axes, &area, &mut drawing);
        }
    }
    bar(words.wrong, above + 30.0, bottom - 12.0, &mut drawing);
    let told: Vec<String> = panels
        .iter()
        .map(|p| format!("{}: {} of the cells fail", font::plain(&p.label), percent(p.failing())))
        .collect();
    let alt = format!(
        "{}. Maps of {} over size and distance. {}.",
        heading.sentence(),
        words.wrong,
        told.join("; ")
    );
    let mut figure = Figure::new(drawing, words.title, &alt).caption(words.caption);
    figure.data.push(lightbench_kit::figure::Data { repeats: Default::default(), csv: csv(panels, axes) });
    figure
}

fn color(share: f64) -> Ink {
    if share == 0.0 { ZERO } else { Ink::Fixed(viridis(1.0 + share.log10() / DECADES)) }
}

fn one(panel: &Panel, axes: &Axes, area: &Rect, drawing: &mut Drawing) {
    let (columns, rows) = (axes.sizes.len(), axes.distances.len());
    let size = dvec2(area.width() / columns as f64, area.height() / rows as f64);
    let corner = |i: usize, j: usize| dvec2(area.min.x, area.max.y) + size * dvec2(i as f64, -(j as f64));
    let place = |i: usize, j: usize| Rect { min: corner(i, j + 1).min(corner(i, j)), max: corner(i + 1, j) };
    let mut failed = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            let cell = place(i, j);
            let share = panel.share(j * columns + i);
            drawing.rect(cell, Some(Fill::new(color(share))), None);
            if share > 0.0 {
                failed.push(Chain { points: cell.corners().to_vec(), ends: Ends::Closed });
            }
        }
    }
    let fill = Some(Fill::hatched(WHITE).faint(0.35));
    drawing.items.push(Item::Path { chains: failed, fill, stroke: None });
    let fails = |i: usize, j: usize| panel.wrong[j * columns + i] > 0;
    let mut edges = Vec::new();
    let mut edge = |a: DVec2, b: DVec2| edges.push(Chain { points: vec![a, b], ends: Ends::Open });
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        if i + 1 < columns && fails(i, j) != fails(i + 1, j) {
            edge(corner(i + 1, j), corner(i + 1, j + 1));
        }
        if j + 1 < rows && fails(i, j) != fails(i, j + 1) {
            edge(corner(i, j + 1), corner(i + 1, j + 1));
        }
    }
    drawing.items.push(Item::Path { chains: edges, fill: None, stroke: Some(Stroke::new(DARK, 2.4)) });
    drawing.rect(*area, None, Some(Stroke::new(Ink::Outline, 1.2)));
    let at = area.min - dvec2(0.0, 9.0);
    drawing.text(Text::new(at, &panel.label, SIZE * 0.85, Ink::Text).face(Face::Bold));
    share_label(panel, area, drawing);
}

/// How much of the map fails, in the middle of it.
fn share_label(panel: &Panel, area: &Rect, drawing: &mut Drawing) {
    let words = match panel.failing() {
        0.0 => "0 wrong".to_string(),
        share => format!("fails: {}", percent(share)),
    };
    let text = Text::new(area.center() + dvec2(0.0, 6.0), words, SIZE * 0.85, DARK).anchor(Anchor::Middle);
    let text = text.face(Face::Bold);
    let half = dvec2(text.bounds().width() / 2.0 + 8.0, SIZE * 0.72);
    let place = Rect { min: area.center() - half, max: area.center() + half };
    drawing.rect(place, Some(Fill::new(WHITE).faint(0.92)), None);
    drawing.text(text);
}

fn up(axes: &Axes, area: &Rect, drawing: &mut Drawing) {
    let step = area.height() / axes.distances.len() as f64;
    for (j, distance) in axes.distances.iter().enumerate() {
        let at = dvec2(area.min.x - 8.0, area.max.y - (j as f64 + 0.5) * step + SIZE * 0.3);
        drawing.text(Text::new(at, written(*distance), SIZE * 0.85, Ink::Muted).anchor(Anchor::End));
    }
}

fn across(axes: &Axes, area: &Rect, drawing: &mut Drawing) {
    let step = area.width() / axes.sizes.len() as f64;
    // Every other one: 10⁻⁶, 10⁻², …
    for (i, size) in axes.sizes.iter().enumerate().filter(|(i, _)| i % 3 == 0) {
        let at = dvec2(area.min.x + (i as f64 + 0.5) * step, area.max.y + SIZE * 1.1);
        drawing.text(Text::new(at, written(*size), SIZE * 0.85, Ink::Muted).anchor(Anchor::Middle));
    }
}

fn written(x: f64) -> String {
    if [0.0, 1.0, 10.0].contains(&x) { format!("{x}") } else { power_of_ten(x.log10().round() as i32) }
}

/// The scale of colours.
fn bar(wrong: &str, top: f64, bottom: f64, drawing: &mut Drawing) {
    const STEPS: usize = 128;
    let place = Rect::new(WIDTH - MARGIN - 92.0, top + 44.0, WIDTH - MARGIN - 66.0, bottom - 40.0);
    let shade = |k: usize| viridis(1.0 - k as f64 / (STEPS - 1) as f64);
    drawing.image(place, Pixels::new(1, STEPS, (0..STEPS).flat_map(shade).collect()));
    let mut y = top + 6.0;
    for line in font::wrapped(&format!("share of {wrong}"), Face::Regular, SIZE * 0.85, 120.0) {
        drawing.text(Text::new(dvec2(place.min.x, y), line, SIZE * 0.85, Ink::Text));
        y += SIZE;
    }
    for decade in 0..=DECADES as i32 {
        let y = place.min.y + place.height() * f64::from(decade) / DECADES;
        let stroke = Stroke::new(Ink::Outline, 1.4);
        drawing.line(dvec2(place.max.x, y), dvec2(place.max.x + 5.0, y), stroke);
        let label = written(10f64.powi(-decade));
        drawing.text(Text::new(dvec2(place.max.x + 10.0, y + SIZE * 0.3), label, SIZE * 0.85, Ink::Muted));
    }
    let zero = Rect::new(place.min.x, bottom - 22.0, place.max.x, bottom);
    drawing.rect(zero, Some(Fill::new(ZERO)), Some(Stroke::new(Ink::Outline, 1.2)));
    drawing.text(Text::new(dvec2(zero.max.x + 10.0, bottom - 5.0), "none", SIZE * 0.85, Ink::Muted));
}

fn csv(panels: &[Panel], axes: &Axes) -> String {
    let mut text = String::from("method,size_m,distance_sizes,wrong,of\n");
    for panel in panels {
        let places = axes.distances.iter().flat_map(|d| axes.sizes.iter().map(move |s| (s, d)));
        for ((size, distance), (wrong, of)) in places.zip(panel.wrong.iter().zip(&panel.of)) {
            text += &format!("{},{size:e},{distance:e},{wrong},{of}\n", font::plain(&panel.label));
        }
    }
    text
}
