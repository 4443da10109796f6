//! The chromaticity diagram as a sheet to draw on.

use glam::{DVec2, dvec2};
use lightbench::color::dominant::Locus;
use lightbench::color::gamut::IntoGamut;
use lightbench::color::spectrum::Matching;
use lightbench::color::xyz::{Xyy, rgb_from_xyz, xyz_from_xyy};
use lightbench::color::{Rgb, srgb_encode};
use lightbench_kit::figure::drawing::{
    Anchor, Chain, Drawing, Ends, Face, Fill, Item, Pixels, Rect, Stroke, Text,
};
use lightbench_kit::figure::ink::{Hue, Ink};

/// What of the plane is shown: x from 0 to 0.78, y from 0 to 0.88.
const EXTENT: DVec2 = dvec2(0.78, 0.88);

/// Where a diagram lies on the canvas.
pub struct Horseshoe {
    place: Rect,
    size: f64,
}

/// How the rim is labelled.
#[derive(Clone, Copy, PartialEq)]
pub enum Rim {
    /// Wavelengths, ticks and axes.
    Ruled,
    /// A few wavelengths.
    Sparse,
}

/// A colour of that chromaticity, as bright as a screen shows it; what it cannot is mixed with white.
///
/// Divided by a norm between the sum and the largest channel: the one is dark where channels mix, the other shows its kinks.
pub fn shown(xy: DVec2) -> Rgb {
    let Some(xyz) = xyz_from_xyy(Xyy { xy, luminance: 1.0 }) else { return Rgb::ZERO };
    let rgb = IntoGamut::Desaturate.apply(rgb_from_xyz(xyz));
    let norm = rgb.to_array().map(|c| c.powi(5)).iter().sum::<f64>().powf(0.2);
    if norm > 0.0 { rgb / norm } else { Rgb::ZERO }
}

/// The coloured square behind the diagrams, `width` pixels wide.
pub fn colours(width: usize) -> Pixels {
    let height = (width as f64 * EXTENT.y / EXTENT.x) as usize;
    let place = |i: usize| {
        let (x, y) = ((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
        dvec2(x / width as f64, 1.0 - y / height as f64) * EXTENT
    };
    let byte = |c: f64| (255.0 * srgb_encode(c.clamp(0.0, 1.0))).round() as u8;
    let rgb = (0..width * height).flat_map(|i| shown(place(i)).to_array().map(byte)).collect();
    Pixels::new(width, height, rgb)
}

impl Horseshoe {
    /// Draws the diagram as large as it fits into a rectangle.
    pub fn draw(drawing: &mut Drawing, room: Rect, colours: &Pixels, rim: Rim) -> Horseshoe {
        let scale = (room.width() / EXTENT.x).min(room.height() / EXTENT.y);
        let min = dvec2(room.min.x + (room.width() - EXTENT.x * scale) * 0.5, room.min.y);
        let sheet = Horseshoe { place: Rect { min, max: min + EXTENT * scale }, size: scale };
        let locus = Locus::of(Matching::Table1nm);
        drawing.image(sheet.place, colours.clone());
        // Everything outside the curve is covered by the ground: a frame with a hole wound the other way.
        let mut hole: Vec<DVec2> = locus.points().iter().map(|p| sheet.at(*p)).collect();
        let frame = sheet.place.grown(2.0).corners().to_vec();
        if winding(&hole) * winding(&frame) > 0.0 {
            hole.reverse();
        }
        let chain = |points: &[DVec2]| Chain { points: points.to_vec(), ends: Ends::Closed };
        let chains = vec![chain(&frame), chain(&hole)];
        drawing.items.push(Item::Path { chains, fill: Some(Fill::new(Ink::Ground)), stroke: None });
        if rim == Rim::Ruled {
            sheet.axes(drawing);
        }
        let [violet, red] = locus.purple_line().map(|p| sheet.at(p));
        drawing.line(violet, red, Stroke::new(Ink::Outline, 1.8).dashed(&[8.0, 5.0]));
        let curve: Vec<DVec2> = locus.points().iter().map(|p| sheet.at(*p)).collect();
        drawing.chain(&curve, Stroke::new(Ink::Outline, 2.4));
        sheet.wavelengths(drawing, rim);
        sheet
    }

    /// From a chromaticity to the canvas.
    pub fn at(&self, xy: DVec2) -> DVec2 {
        dvec2(self.place.min.x + xy.x * self.size, self.place.max.y - xy.y * self.size)
    }

    pub fn place(&self) -> Rect {
        self.place
    }

    fn axes(&self, drawing: &mut Drawing) {
        for i in 0..=8 {
            let v = f64::from(i) / 10.0;
            let label = |at, anchor| Text::new(at, format!("{v:.1}"), 18.0, Ink::Muted).anchor(anchor);
            let thin = || Stroke::new(Ink::Muted, 1.0).faint(0.28);
            if v <= EXTENT.x {
                let (low, high) = (self.at(dvec2(v, 0.0)), self.at(dvec2(v, EXTENT.y)));
                drawing.line(low, high, thin());
                drawing.text(label(low + dvec2(0.0, 24.0), Anchor::Middle));
            }
            let (left, right) = (self.at(dvec2(0.0, v)), self.at(dvec2(EXTENT.x, v)));
            drawing.line(left, right, thin());
            drawing.text(label(left + dvec2(-10.0, 6.0), Anchor::End));
        }
        let x = self.at(dvec2(EXTENT.x, 0.0)) + dvec2(4.0, 25.0);
        drawing.text(Text::new(x, "x", 22.0, Ink::Text).face(Face::Italic).anchor(Anchor::Middle));
        let y = self.at(dvec2(0.0, EXTENT.y)) + dvec2(-16.0, 12.0);
        drawing.text(Text::new(y, "y", 22.0, Ink::Text).face(Face::Italic).anchor(Anchor::End));
    }

    fn wavelengths(&self, drawing: &mut Drawing, rim: Rim) {
        let locus = Locus::of(Matching::Table1nm);
        let labels: &[u32] = match rim {
            Rim::Ruled => &[
                460, 470, 480, 490, 500, 510, 520, 530, 540, 550, 560, 570, 580, 590, 600, 610, 620, 640, 700,
            ],
            Rim::Sparse => &[460, 480, 500, 520, 540, 560, 580, 600, 620, 700],
        };
        let size = if rim == Rim::Ruled { 18.0 } else { 16.0 };
        for &nm in labels {
            let w = f64::from(nm);
            let (p, ahead) = (self.at(locus.at(w)), self.at(locus.at(w + 2.0)) - self.at(locus.at(w - 2.0)));
            // Clockwise, so that the outside lies to the left.
            let out = dvec2(ahead.y, -ahead.x).normalize_or(DVec2::Y);
            drawing.line(p - out * 3.0, p + out * 7.0, Stroke::new(Ink::Outline, 1.6));
            let anchor = match out.x {
                x if x < -0.4 => Anchor::End,
                x if x > 0.4 => Anchor::Start,
                _ => Anchor::Middle,
            };
            let drop = if out.y < -0.7 { -2.0 } else { size * 0.36 };
            let at = p + out * 12.0 + dvec2(0.0, drop);
            drawing.text(Text::new(at, nm.to_string(), size, Ink::Muted).anchor(anchor));
        }
    }

    /// A straight line between two chromaticities.
    pub fn line(&self, drawing: &mut Drawing, from: DVec2, to: DVec2) {
        drawing.line(self.at(from), self.at(to), Stroke::new(Ink::Ground, 5.0).faint(0.6));
        drawing.line(self.at(from), self.at(to), Stroke::new(Ink::Text, 2.2));
    }

    /// A dashed one.
    pub fn dashed(&self, drawing: &mut Drawing, from: DVec2, to: DVec2) {
        drawing.line(self.at(from), self.at(to), Stroke::new(Ink::Text, 2.0).dashed(&[7.0, 5.0]));
    }

    /// The gamut of some lamps.
    pub fn gamut(&self, drawing: &mut Drawing, corners: &[DVec2], hue: Option<Hue>) {
        let points: Vec<DVec2> = corners.iter().map(|p| self.at(*p)).collect();
        drawing.polygon(&points, None, Some(Stroke::new(Ink::Ground, 6.0).faint(0.7)));
        drawing.polygon(&points, None, Some(Stroke::new(hue.map_or(Ink::Text, Ink::Line), 3.0)));
    }

    /// A point with its letter, `aside` pixels from it.
    pub fn point(&self, drawing: &mut Drawing, xy: DVec2, letter: &str, aside: DVec2) {
        let at = self.at(xy);
        drawing.circle(at, 6.5, Some(Fill::new(Ink::Text)), Some(Stroke::new(Ink::Ground, 2.0)));
        let anchor = match aside.x {
            x if x < -1.0 => Anchor::End,
            x if x > 1.0 => Anchor::Start,
            _ => Anchor::Middle,
        };
        let text = Text::new(at + aside + dvec2(0.0, 7.0), letter, 25.0, Ink::Text);
        drawing.text(text.face(Face::Italic).anchor(anchor).halo(4.0));
    }
}

/// Twice the signed area of a polygon.
fn winding(points: &[DVec2]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum()
}
