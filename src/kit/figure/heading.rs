//! The words above a figure: the finding, and what was measured.

use super::drawing::{Drawing, Face, Text};
use super::font;
use super::ink::Ink;
use glam::dvec2;

/// Canvas of a figure \[px\].
pub const WIDTH: f64 = 1200.0;
pub const HEIGHT: f64 = 800.0;
/// Clear space at the canvas' edge \[px\].
pub const MARGIN: f64 = 40.0;
/// Size of ordinary writing \[px\]: still legible at half the size.
pub const SIZE: f64 = 20.0;

const TITLE: f64 = 30.0;

/// Title and subtitle of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heading {
    pub title: String,
    pub subtitle: String,
}

impl Heading {
    /// Draws both from the top left, the title on two lines at most (smaller if it must), and returns the height
    /// at which the picture may begin.
    pub fn draw(&self, drawing: &mut Drawing) -> f64 {
        let room = drawing.width - 2.0 * MARGIN;
        let (size, lines) = fitted(&self.title, Face::Bold, TITLE, room);
        let mut y = MARGIN - 20.0;
        for line in lines {
            y += size * 1.2;
            drawing.text(Text::new(dvec2(MARGIN, y), line, size, Ink::Text).face(Face::Bold));
        }
        let (size, lines) = fitted(&self.subtitle, Face::Regular, SIZE, room);
        y += if lines.is_empty() { 0.0 } else { 4.0 };
        for line in lines {
            y += size * 1.3;
            drawing.text(Text::new(dvec2(MARGIN, y), line, size, Ink::Muted));
        }
        drawing.heading = (y + 8.0, drawing.items.len());
        y + 26.0
    }

    /// What a caption says of itself: the subtitle, since the title stands beside it.
    pub fn caption(&self) -> String {
        font::plain(&self.subtitle)
    }

    /// Title and subtitle as one text.
    pub fn sentence(&self) -> String {
        match (self.title.is_empty(), self.subtitle.is_empty()) {
            (_, true) => font::plain(&self.title),
            (true, _) => font::plain(&self.subtitle),
            _ => format!("{}. {}", font::plain(&self.title), font::plain(&self.subtitle)),
        }
    }
}

/// The text on two lines at most, as large as it fits, at most at `size`.
fn fitted(text: &str, face: Face, size: f64, room: f64) -> (f64, Vec<String>) {
    let mut size = size;
    loop {
        let lines = font::wrapped(text, face, size, room);
        let wide = lines.iter().any(|l| font::width(l, face, size) > room);
        if (lines.len() <= 2 && !wide) || size <= 12.0 {
            return (size, lines);
        }
        size *= 0.94;
    }
}

/// An integer with thin spaces between the thousands: 10 000.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    if digits.len() <= 4 {
        return digits;
    }
    let mut out = String::new();
    for (i, c) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push('\u{202F}');
        }
        out.push(c);
    }
    out
}

/// A share in per cent, to two figures, never rounded to "0 %" or "100 %" from elsewhere.
pub fn percent(share: f64) -> String {
    let p = share * 100.0;
    let text = match p {
        p if p <= 0.0 || p >= 100.0 => format!("{p:.0}"),
        p if p < 0.01 => "<0.01".to_string(),
        p if p < 1.0 => format!("{p:.2}"),
        p if p < 10.0 => format!("{p:.1}"),
        p if p > 99.5 => format!("{:.1}", p.min(99.9)),
        p => format!("{p:.0}"),
    };
    format!("{text}\u{202F}%")
}

/// A number to about three figures, with a power of ten where decimals would be many.
pub fn short(x: f64) -> String {
    if x.is_nan() {
        return "NaN".to_string();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞" } else { "−∞" }.to_string();
    }
    let sign = if x < 0.0 { "−" } else { "" };
    let size = x.abs();
    if size == 0.0 {
        return "0".to_string();
    }
    if (1.0e-3..1.0e5).contains(&size) {
        let decimals = (2 - size.log10().floor() as i32).clamp(0, 5) as usize;
        let text = format!("{size:.decimals$}");
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        return format!("{sign}{text}");
    }
    // The formatter rounds and carries: 9.96e-5 is "1.0e-4".
    let text = format!("{size:.1e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let power = power_of_ten(exponent.parse().unwrap_or(0));
    match mantissa.trim_end_matches(".0") {
        "1" => format!("{sign}{power}"),
        mantissa => format!("{sign}{mantissa}·{power}"),
    }
}

/// `10ⁿ` in Unicode.
pub fn power_of_ten(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if exponent < 0 { "⁻" } else { "" };
    let digits: String = exponent
        .unsigned_abs()
        .to_string()
        .chars()
        .map(|c| RAISED[c.to_digit(10).unwrap_or(0) as usize])
        .collect();
    format!("10{sign}{digits}")
}
