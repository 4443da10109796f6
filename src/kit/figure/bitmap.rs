//! A drawing as pixels, on white, and the PNG file of them.

use super::drawing::{
    Anchor, Drawing, Ends, Fill, HATCH_PERIOD, HATCH_WIDTH, Item, Pattern, Pixels, Rect, Stroke, Text,
};
use super::ink::{Ink, Srgb};
use super::raster::{Coverage, coverage};
use super::{font, stroke};
use crate::color::{srgb_decode, srgb_encode};
use glam::{DVec2, dvec2};
use std::sync::LazyLock;

/// Draws on white.
pub fn render(drawing: &Drawing) -> Pixels {
    let (width, height) = (drawing.width.round() as usize, drawing.height.round() as usize);
    let mut canvas =
        Canvas { pixels: Pixels::new(width, height, vec![255; 3 * width * height]), clip: drawing.bounds() };
    canvas.items(&drawing.items);
    canvas.pixels
}

/// A PNG file with text chunks `(keyword, text)`; the same pixels give the same bytes.
pub fn png(pixels: &Pixels, texts: &[(&str, &str)]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width as u32, pixels.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_compression(png::Compression::Balanced);
    // Line art packs best unfiltered; noisy renders do, too.
    encoder.set_filter(png::Filter::NoFilter);
    for (keyword, text) in texts.iter().filter(|(_, text)| !text.is_empty()) {
        // tEXt holds Latin-1 only; anything else goes into iTXt.
        if text.chars().all(|c| (c as u32) < 256) {
            encoder.add_text_chunk(keyword.to_string(), text.to_string())?;
        } else {
            encoder.add_itxt_chunk(keyword.to_string(), text.to_string())?;
        }
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels.rgb)?;
    writer.finish()?;
    Ok(bytes)
}

struct Canvas {
    pixels: Pixels,
    clip: Rect,
}

impl Canvas {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Path { chains, fill, stroke } => {
                    let inside: Vec<Vec<DVec2>> = chains.iter().map(|c| c.points.clone()).collect();
                    self.shape(&inside, fill.as_ref());
                    if let Some(line) = stroke {
                        let edge: Vec<Vec<DVec2>> =
                            chains.iter().flat_map(|c| stroke::outline(c, line.width, &line.dash)).collect();
                        self.edge(&edge, line);
                    }
                }
                Item::Circle { center, radius, fill, stroke } => {
                    let points = stroke::circle(*center, *radius);
                    self.shape(std::slice::from_ref(&points), fill.as_ref());
                    if let Some(line) = stroke {
                        let chain = super::drawing::Chain { points, ends: Ends::Closed };
                        self.edge(&stroke::outline(&chain, line.width, &line.dash), line);
                    }
                }
                Item::Text(text) => self.text(text),
                Item::Image { place, pixels } => self.image(place, pixels),
                Item::Clipped { to, items } => {
                    let outer = self.clip;
                    self.clip = Rect { min: outer.min.max(to.min), max: outer.max.min(to.max) };
                    self.items(items);
                    self.clip = outer;
                }
            }
        }
    }

    fn shape(&mut self, polygons: &[Vec<DVec2>], fill: Option<&Fill>) {
        let Some(fill) = fill else { return };
        let mut mask = coverage(polygons, self.pixels.width, self.pixels.height);
        if fill.pattern == Pattern::Hatched {
            hatch(&mut mask);
        }
        self.blend(&mask, fill.ink, fill.opacity);
    }

    fn edge(&mut self, polygons: &[Vec<DVec2>], line: &Stroke) {
        let mask = coverage(polygons, self.pixels.width, self.pixels.height);
        self.blend(&mask, line.ink, line.opacity);
    }

    fn text(&mut self, text: &Text) {
        let width = font::width(&text.text, text.face, text.size);
        let start = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -width / 2.0,
            Anchor::End => -width,
        };
        let place = |p: DVec2| text.at + dvec2(start + p.x, p.y);
        let letters: Vec<Vec<DVec2>> = font::outlines(&text.text, text.face, text.size)
            .into_iter()
            .map(|contour| contour.into_iter().map(place).collect())
            .collect();
        if text.halo > 0.0 {
            let mask = coverage(&letters, self.pixels.width, self.pixels.height);
            self.blend(&mask.widened(text.halo, self.pixels.width, self.pixels.height), Ink::Ground, 1.0);
        }
        self.shape(&letters, Some(&Fill::new(text.ink)));
    }

    /// Lays the colour over the pixels, as browsers do: in sRGB values, by coverage × opacity.
    fn blend(&mut self, mask: &Coverage, ink: Ink, opacity: f64) {
        if mask.width == 0 {
            return;
        }
        let rgb = ink.light();
        for (i, &value) in mask.values.iter().enumerate() {
            if value <= 0.0 {
                continue;
            }
            let (x, y) = (mask.x0 + i % mask.width, mask.y0 + i / mask.width);
            let alpha = f64::from(value).min(1.0) * opacity * self.clip_share(x, y);
            self.lay(x, y, rgb, alpha);
        }
    }

    /// The share of a pixel inside the clip.
    fn clip_share(&self, x: usize, y: usize) -> f64 {
        let low = dvec2(x as f64, y as f64);
        Rect { min: low, max: low + 1.0 }.overlap(&self.clip)
    }

    fn lay(&mut self, x: usize, y: usize, rgb: Srgb, alpha: f64) {
        let i = 3 * (y * self.pixels.width + x);
        if alpha == 1.0 {
            self.pixels.rgb[i..i + 3].copy_from_slice(&rgb);
            return;
        }
        for (channel, &c) in rgb.iter().enumerate() {
            let old = f64::from(self.pixels.rgb[i + channel]);
            self.pixels.rgb[i + channel] = (old + (f64::from(c) - old) * alpha).round() as u8;
        }
    }

    fn image(&mut self, place: &Rect, source: &Pixels) {
        let scale = dvec2(source.width as f64 / place.width(), source.height as f64 / place.height());
        let low = place.min.max(self.clip.min).max(DVec2::ZERO).round();
        let high = place.max.min(self.clip.max).round();
        for y in low.y as usize..(high.y.max(0.0) as usize).min(self.pixels.height) {
            for x in low.x as usize..(high.x.max(0.0) as usize).min(self.pixels.width) {
                let from = (dvec2(x as f64, y as f64) - place.min) * scale;
                self.lay(x, y, averaged(source, from, from + scale), 1.0);
            }
        }
    }
}

/// Linear light of each 8-bit sRGB level.
static LIGHT: LazyLock<[f64; 256]> =
    LazyLock::new(|| std::array::from_fn(|level| srgb_decode(level as f64 / 255.0)));

/// Mean light of the source over a rectangle of it, so that a half-covered edge sends half the light; the pixel under
/// its centre where the rectangle is smaller than one.
fn averaged(source: &Pixels, from: DVec2, to: DVec2) -> Srgb {
    let last = dvec2(source.width as f64 - 1.0, source.height as f64 - 1.0);
    let middle = ((from + to) * 0.5).floor().clamp(DVec2::ZERO, last);
    if (to - from).max_element() <= 1.0 {
        return source.get(middle.x as usize, middle.y as usize);
    }
    let (low, high) = (from.floor().clamp(DVec2::ZERO, last), (to.ceil() - 1.0).clamp(DVec2::ZERO, last));
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    for y in low.y as usize..=high.y as usize {
        let across = (to.y.min(y as f64 + 1.0) - from.y.max(y as f64)).max(1.0e-9);
        for x in low.x as usize..=high.x as usize {
            let weight = across * (to.x.min(x as f64 + 1.0) - from.x.max(x as f64)).max(1.0e-9);
            total += weight;
            for (s, c) in sum.iter_mut().zip(source.get(x, y)) {
                *s += weight * LIGHT[usize::from(c)];
            }
        }
    }
    sum.map(|s| (srgb_encode((s / total).clamp(0.0, 1.0)) * 255.0).round() as u8)
}

/// Keeps of a mask only lines at 45°, with soft edges a pixel wide.
fn hatch(mask: &mut Coverage) {
    for (i, value) in mask.values.iter_mut().enumerate() {
        let (x, y) = (mask.x0 + i % mask.width, mask.y0 + i / mask.width);
        let across = ((x + y) as f64 + 1.0) * std::f64::consts::FRAC_1_SQRT_2;
        let off = (across.rem_euclid(HATCH_PERIOD) - HATCH_PERIOD / 2.0).abs();
        *value *= (HATCH_WIDTH / 2.0 + 0.5 - off).clamp(0.0, 1.0) as f32;
    }
}
