//! The palette: every colour by its role, on a light and on a dark ground.

/// 8-bit sRGB.
pub type Srgb = [u8; 3];

/// The colours of methods: Okabe & Ito's, told apart by colour-blind readers too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Hue {
    Blue,
    Vermillion,
    Green,
    Purple,
    Orange,
    Sky,
    Grey,
}

/// Hues in the order in which methods receive them. Vermillion is kept for formulas as printed.
pub const METHOD_HUES: [Hue; 6] = [Hue::Blue, Hue::Green, Hue::Purple, Hue::Orange, Hue::Sky, Hue::Grey];

/// A colour by what it is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ink {
    /// The page.
    Ground,
    /// Titles, marks that carry the meaning.
    Text,
    /// Subtitles, axis labels.
    Muted,
    /// Gridlines.
    Grid,
    /// Axes, outlines of surfaces, the Pareto front.
    Outline,
    /// The inside of surfaces.
    Surface,
    /// A line or a mark.
    Line(Hue),
    /// Writing in the colour of a line, dark enough to read.
    Label(Hue),
    /// A data colour, the same on every ground.
    Fixed(Srgb),
}

impl Ink {
    /// The colour on white.
    pub fn light(self) -> Srgb {
        match self {
            Ink::Ground => [255, 255, 255],
            Ink::Text => [27, 31, 39],
            Ink::Muted => [91, 98, 110],
            Ink::Grid => [226, 229, 234],
            Ink::Outline => [62, 68, 78],
            Ink::Surface => [231, 234, 238],
            Ink::Line(hue) => hue.light(),
            Ink::Label(hue) => hue.label_on_light(),
            Ink::Fixed(rgb) => rgb,
        }
    }

    /// The colour on a dark page.
    pub fn dark(self) -> Srgb {
        match self {
            Ink::Ground => [21, 24, 29],
            Ink::Text => [232, 234, 238],
            Ink::Muted => [163, 170, 181],
            Ink::Grid => [46, 51, 59],
            Ink::Outline => [180, 187, 197],
            Ink::Surface => [45, 50, 58],
            Ink::Line(hue) | Ink::Label(hue) => hue.dark(),
            Ink::Fixed(rgb) => rgb,
        }
    }

    /// Name of the style class in SVG; data colours have none.
    pub fn class(self) -> Option<&'static str> {
        Some(match self {
            Ink::Ground => "ground",
            Ink::Text => "text",
            Ink::Muted => "muted",
            Ink::Grid => "grid",
            Ink::Outline => "outline",
            Ink::Surface => "surface",
            Ink::Line(hue) => hue.names().0,
            Ink::Label(hue) => hue.names().1,
            Ink::Fixed(_) => return None,
        })
    }
}

/// Every ink that has a class.
pub const ROLES: [Ink; 20] = [
    Ink::Ground,
    Ink::Text,
    Ink::Muted,
    Ink::Grid,
    Ink::Outline,
    Ink::Surface,
    Ink::Line(Hue::Blue),
    Ink::Line(Hue::Vermillion),
    Ink::Line(Hue::Green),
    Ink::Line(Hue::Purple),
    Ink::Line(Hue::Orange),
    Ink::Line(Hue::Sky),
    Ink::Line(Hue::Grey),
    Ink::Label(Hue::Blue),
    Ink::Label(Hue::Vermillion),
    Ink::Label(Hue::Green),
    Ink::Label(Hue::Purple),
    Ink::Label(Hue::Orange),
    Ink::Label(Hue::Sky),
    Ink::Label(Hue::Grey),
];

impl Hue {
    fn light(self) -> Srgb {
        match self {
            Hue::Blue => [0x00, 0x72, 0xB2],
            Hue::Vermillion => [0xD5, 0x5E, 0x00],
            Hue::Green => [0x00, 0x9E, 0x73],
            Hue::Purple => [0xCC, 0x79, 0xA7],
            Hue::Orange => [0xE6, 0x9F, 0x00],
            Hue::Sky => [0x56, 0xB4, 0xE9],
            Hue::Grey => [0x66, 0x66, 0x66],
        }
    }
    /// The hue darkened until small writing reads on white (contrast at least 4.5).
    fn label_on_light(self) -> Srgb {
        match self {
            Hue::Blue => [0x00, 0x63, 0x9C],
            Hue::Vermillion => [0xB0, 0x4A, 0x00],
            Hue::Green => [0x00, 0x75, 0x55],
            Hue::Purple => [0xA0, 0x45, 0x78],
            Hue::Orange => [0x8F, 0x60, 0x00],
            Hue::Sky => [0x1C, 0x71, 0xA6],
            Hue::Grey => [0x55, 0x58, 0x5C],
        }
    }
    fn dark(self) -> Srgb {
        match self {
            Hue::Blue => [0x4A, 0x9F, 0xE0],
            Hue::Vermillion => [0xEE, 0x70, 0x30],
            Hue::Green => [0x2F, 0xBF, 0x93],
            Hue::Purple => [0xDD, 0x94, 0xBC],
            Hue::Orange => [0xF2, 0xBC, 0x3C],
            Hue::Sky => [0x86, 0xCC, 0xF5],
            Hue::Grey => [0xA0, 0xA4, 0xAA],
        }
    }
    fn names(self) -> (&'static str, &'static str) {
        match self {
            Hue::Blue => ("blue", "blue-label"),
            Hue::Vermillion => ("vermillion", "vermillion-label"),
            Hue::Green => ("green", "green-label"),
            Hue::Purple => ("purple", "purple-label"),
            Hue::Orange => ("orange", "orange-label"),
            Hue::Sky => ("sky", "sky-label"),
            Hue::Grey => ("grey", "grey-label"),
        }
    }
}

/// Contrast of two colours, 1 to 21: `(L₁ + 0.05) / (L₂ + 0.05)` of their relative luminances.
///
/// - Source: W3C, *Web Content Accessibility Guidelines* 2.1 (2018).
pub fn contrast(a: Srgb, b: Srgb) -> f64 {
    let (la, lb) = (luminance(a), luminance(b));
    (la.max(lb) + 0.05) / (la.min(lb) + 0.05)
}

fn luminance(rgb: Srgb) -> f64 {
    let linear = |c: u8| {
        let v = f64::from(c) / 255.0;
        if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2])
}
