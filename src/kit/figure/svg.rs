//! A drawing as SVG: text stays text, colours follow the reader's light or dark ground.

use super::drawing::{
    Anchor, Chain, Drawing, Ends, Face, Fill, HATCH_PERIOD, HATCH_WIDTH, Item, Pattern, Pixels, Rect, Stroke,
    Text,
};
use super::font::{self, Level};
use super::ink::{Ink, ROLES, Srgb};
use std::fmt::Write;

/// The words that accompany a drawing.
pub struct Words<'a> {
    pub title: &'a str,
    pub description: &'a str,
    /// Pairs of keyword and text for `<metadata>`.
    pub metadata: &'a [(&'a str, &'a str)],
}

/// The drawing as an SVG file without a ground of its own.
pub fn render(drawing: &Drawing, words: &Words) -> String {
    let mut svg = Svg { text: String::new(), clips: 0 };
    let (w, h) = (number(drawing.width), number(drawing.height));
    let _ = writeln!(
        svg.text,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" role=\"img\" xml:space=\"preserve\">"
    );
    let _ = writeln!(svg.text, "<title>{}</title>", escaped(words.title));
    let _ = writeln!(svg.text, "<desc>{}</desc>", escaped(words.description));
    let pairs: Vec<String> = words
        .metadata
        .iter()
        .filter(|(_, text)| !text.is_empty())
        .map(|(key, text)| format!("{}: {}", escaped(key), escaped(text)))
        .collect();
    let _ = writeln!(svg.text, "<metadata>{}</metadata>", pairs.join("\n"));
    svg.text.push_str(&style());
    svg.text.push_str(&hatches(drawing));
    svg.items(&drawing.items);
    svg.text.push_str("</svg>\n");
    svg.text
}

/// One class a role, for filling (`f-…`) and for lines (`s-…`); the attributes of each mark say the light colours
/// again for readers without style sheets.
fn style() -> String {
    let mut light = String::new();
    let mut dark = String::new();
    for ink in ROLES {
        let name = ink.class().unwrap_or_default();
        let rule = |c: Srgb| format!(".f-{name}{{fill:{0}}}.s-{name}{{stroke:{0}}}", hex(c));
        light.push_str(&rule(ink.light()));
        dark.push_str(&rule(ink.dark()));
    }
    let fonts = ".sans{font-family:'DejaVu Sans Condensed','Helvetica Neue',Helvetica,Arial,'Liberation Sans',sans-serif}\
                 .math{font-family:'DejaVu Serif Condensed','STIX Two Text',Georgia,'Times New Roman',serif;font-style:italic}";
    format!("<style>{fonts}{light}@media (prefers-color-scheme:dark){{{dark}}}</style>\n")
}

/// A pattern for each ink that hatches.
fn hatches(drawing: &Drawing) -> String {
    fn inks(items: &[Item], found: &mut Vec<Ink>) {
        for item in items {
            match item {
                Item::Path { fill: Some(f), .. } | Item::Circle { fill: Some(f), .. }
                    if f.pattern == Pattern::Hatched && !found.contains(&f.ink) =>
                {
                    found.push(f.ink)
                }
                Item::Clipped { items, .. } => inks(items, found),
                _ => {}
            }
        }
    }
    let mut found = Vec::new();
    inks(&drawing.items, &mut found);
    let patterns: String = found
        .iter()
        .map(|ink| {
            format!(
                "<pattern id=\"{}\" width=\"{p}\" height=\"{p}\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
                 <path d=\"M{m} 0V{p}\"{} stroke-width=\"{HATCH_WIDTH}\"/></pattern>",
                hatch_id(*ink),
                ink_attribute("stroke", *ink),
                p = HATCH_PERIOD,
                m = HATCH_PERIOD / 2.0,
            )
        })
        .collect();
    if patterns.is_empty() { patterns } else { format!("<defs>{patterns}</defs>\n") }
}

fn hatch_id(ink: Ink) -> String {
    format!("hatch-{}", ink.class().map_or_else(|| hex(ink.light())[1..].to_string(), str::to_string))
}

struct Svg {
    text: String,
    clips: usize,
}

impl Svg {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Path { chains, fill, stroke } => {
                    let data: String = chains.iter().map(path_data).collect();
                    let look = look(fill.as_ref(), stroke.as_ref());
                    let _ = writeln!(self.text, "<path d=\"{data}\"{look}/>");
                }
                Item::Circle { center, radius, fill, stroke } => {
                    let (x, y, r) = (number(center.x), number(center.y), number(*radius));
                    let look = look(fill.as_ref(), stroke.as_ref());
                    let _ = writeln!(self.text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{look}/>");
                }
                Item::Text(text) => self.words(text),
                Item::Image { place, pixels } => self.image(place, pixels),
                Item::Clipped { to, items } => {
                    self.clips += 1;
                    let (id, data) = (self.clips, path_data(&closed(to)));
                    let _ = writeln!(
                        self.text,
                        "<clipPath id=\"clip-{id}\"><path d=\"{data}\"/></clipPath>\n<g clip-path=\"url(#clip-{id})\">"
                    );
                    self.items(items);
                    self.text.push_str("</g>\n");
                }
            }
        }
    }

    fn words(&mut self, text: &Text) {
        let anchor = match text.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let (x, y) = (number(text.at.x), number(text.at.y));
        let width = font::width(&text.text, text.face, text.size);
        let (class, weight) = match text.face {
            Face::Regular => ("sans", ""),
            Face::Bold => ("sans", " font-weight=\"bold\""),
            Face::Italic => ("math", ""),
        };
        // The width that the layout reckoned with holds whatever font the reader has.
        let length = if text.text.chars().count() > 2 {
            format!(" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", number(width))
        } else {
            String::new()
        };
        let (fill, rim) = match (text.ink.class(), text.halo > 0.0) {
            (Some(ink), true) => (format!(" f-{ink}"), " s-ground"),
            (Some(ink), false) => (format!(" f-{ink}"), ""),
            (None, true) => (String::new(), " s-ground"),
            (None, false) => (String::new(), ""),
        };
        let halo = if text.halo > 0.0 {
            format!(
                " stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                hex(Ink::Ground.light()),
                number(2.0 * text.halo)
            )
        } else {
            String::new()
        };
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" class=\"{class}{fill}{rim}\" fill=\"{}\"{weight}{anchor}{length}{halo}>{}</text>",
            number(text.size),
            hex(text.ink.light()),
            spans(text)
        );
    }

    fn image(&mut self, place: &Rect, pixels: &Pixels) {
        // Encoding into memory fails only beyond 2³¹ pixels a side.
        let bytes = super::bitmap::png(pixels, &[]).unwrap_or_default();
        let (x, y) = (number(place.min.x), number(place.min.y));
        let (w, h) = (number(place.width()), number(place.height()));
        let grain =
            if pixels.width as f64 <= place.width() { " style=\"image-rendering:pixelated\"" } else { "" };
        let _ = writeln!(
            self.text,
            "<image x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" preserveAspectRatio=\"none\"{grain} href=\"data:image/png;base64,{}\"/>",
            base64(&bytes)
        );
    }
}

/// The stretches of a text, lowered or raised ones as `<tspan>`s that shift and shift back.
fn spans(text: &Text) -> String {
    let mut out = String::new();
    let mut height = 0.0;
    for run in font::runs(&text.text) {
        let (scale, rise) = run.level.scale_and_rise();
        let shift = (height - rise) * text.size;
        height = rise;
        if run.level == Level::Base && shift == 0.0 {
            out.push_str(&escaped(&run.text));
            continue;
        }
        let size = number(text.size * scale);
        let _ = write!(
            out,
            "<tspan dy=\"{}\" font-size=\"{size}\">{}</tspan>",
            number(shift),
            escaped(&run.text)
        );
    }
    out
}

fn closed(rect: &Rect) -> Chain {
    Chain { points: rect.corners().to_vec(), ends: Ends::Closed }
}

fn path_data(chain: &Chain) -> String {
    let mut data = String::new();
    for (i, p) in chain.points.iter().enumerate() {
        let _ = write!(data, "{}{} {}", if i == 0 { 'M' } else { 'L' }, number(p.x), number(p.y));
    }
    if chain.ends == Ends::Closed {
        data.push('Z');
    }
    data
}

/// Attributes of fill and stroke.
fn look(fill: Option<&Fill>, stroke: Option<&Stroke>) -> String {
    let mut classes = Vec::new();
    let mut attributes = String::new();
    match fill {
        None => attributes.push_str(" fill=\"none\""),
        Some(f) if f.pattern == Pattern::Hatched => {
            let _ = write!(attributes, " fill=\"url(#{})\"", hatch_id(f.ink));
        }
        Some(f) => {
            let _ = write!(attributes, " fill=\"{}\"", hex(f.ink.light()));
            classes.extend(f.ink.class().map(|c| format!("f-{c}")));
        }
    }
    if let Some(f) = fill.filter(|f| f.opacity < 1.0) {
        let _ = write!(attributes, " fill-opacity=\"{}\"", number(f.opacity));
    }
    if let Some(s) = stroke {
        let cap = if s.dash.is_empty() { "round" } else { "butt" };
        let _ = write!(
            attributes,
            " stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"{cap}\"",
            hex(s.ink.light()),
            number(s.width)
        );
        classes.extend(s.ink.class().map(|c| format!("s-{c}")));
        if s.opacity < 1.0 {
            let _ = write!(attributes, " stroke-opacity=\"{}\"", number(s.opacity));
        }
        if !s.dash.is_empty() {
            let dash: Vec<String> = s.dash.iter().map(|d| number(*d)).collect();
            let _ = write!(attributes, " stroke-dasharray=\"{}\"", dash.join(" "));
        }
    }
    if classes.is_empty() { attributes } else { format!(" class=\"{}\"{attributes}", classes.join(" ")) }
}

fn ink_attribute(name: &str, ink: Ink) -> String {
    let class = ink.class().map_or(String::new(), |c| format!(" class=\"{}-{c}\"", &name[..1]));
    format!("{class} {name}=\"{}\"", hex(ink.light()))
}

fn hex(c: Srgb) -> String {
    format!("#{:02x}{:02x}{:02x}", c[0], c[1], c[2])
}

/// A coordinate to a hundredth of a pixel, as short as it gets.
fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// Text for XML: markup escaped, characters that XML forbids replaced.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => out.push(c),
            c if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') => out.push('\u{FFFD}'),
            c => out.push(c),
        }
    }
    out
}

/// RFC 4648.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let word = chunk.iter().enumerate().fold(0u32, |w, (i, &b)| w | u32::from(b) << (16 - 8 * i));
        for i in 0..4 {
            let digit = DIGITS[(word >> (18 - 6 * i)) as usize & 63] as char;
            out.push(if i <= chunk.len() { digit } else { '=' });
        }
    }
    out
}
