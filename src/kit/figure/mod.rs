//! Figures: charts, failure maps, ray diagrams, panels of pictures, tables.
//!
//! Every kind is a plain description that becomes a [`Drawing`], a list of marks on a canvas; two writers turn the
//! drawing into SVG (text as text, light and dark) and PNG (white ground, embedded font). The same description
//! gives the same bytes. A [`Figure`] is a drawing with its words: title, caption, alternative text, provenance.
//!
//! ```
//! use lightbench_kit::figure::{Chart, Figure, Guide};
//! let chart = Chart::speed_accuracy("relative error of t")
//!     .title("One Newton step gains eight digits")
//!     .curve("plain", &[(20.0, 1.0e-8), (40.0, 1.0e-9)])
//!     .guide(Guide::level(f64::EPSILON, "machine epsilon"));
//! let figure = Figure::from(chart);
//! assert!(figure.svg().starts_with("<svg"));
//! ```

mod axis;
mod bars;
pub mod bitmap;
mod chart;
pub mod colormap;
mod diagram;
pub mod drawing;
pub mod font;
pub mod heading;
pub mod ink;
pub mod label;
mod map;
mod panels;
mod raster;
mod roots;
mod space;
mod stroke;
pub mod svg;
mod table;

pub use axis::{Axis, Scale};
pub use bars::Bars;
pub use chart::{Chart, Guide};
pub use diagram::{Diagram, Light};
pub use drawing::{Drawing, Pixels};
pub use heading::{grouped, percent, short};
pub use map::{FailureMap, Shades};
pub use panels::{ErrorPanel, Panels};
pub use roots::{Bar, Roots};
pub use space::Space;
pub use table::Table;

/// Where a figure comes from: enough to draw it again. No date, so that the bytes repeat.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Provenance {
    /// The canonical command, without `--out`, `--threads`, `--quiet`.
    pub command: String,
    /// Parameters in words: `rays = 10000, R = 1 m`.
    pub parameters: String,
    pub seed: Option<u64>,
    pub version: String,
}

/// Does a figure come out the same from run to run?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeats {
    /// Same seed, same bytes.
    #[default]
    Always,
    /// It shows seconds that a clock has measured; its files are named `*_time.*`.
    Timed,
}

/// Data of a figure, to stand beside it as CSV.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Data {
    /// Measured seconds stay in a file of their own.
    pub repeats: Repeats,
    pub csv: String,
}

/// A drawing with its words.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    pub drawing: Drawing,
    /// The finding, in one sentence.
    pub title: String,
    /// What stands under the figure on the page.
    pub caption: String,
    /// What the figure shows, for those who do not see it.
    pub alt: String,
    pub provenance: Provenance,
    pub repeats: Repeats,
    pub data: Vec<Data>,
}

impl Figure {
    /// A figure of any drawing; its caption is empty until [`Figure::caption`] says what the title does not.
    pub fn new(drawing: Drawing, title: &str, alt: &str) -> Self {
        let plain = font::plain(title);
        Figure {
            drawing,
            title: plain,
            caption: String::new(),
            alt: font::plain(alt),
            provenance: Provenance::default(),
            repeats: Repeats::Always,
            data: Vec::new(),
        }
    }
    pub fn caption(mut self, caption: &str) -> Self {
        self.caption = caption.to_string();
        self
    }
    pub fn alt(mut self, alt: &str) -> Self {
        self.alt = alt.to_string();
        self
    }
    pub fn provenance(mut self, provenance: Provenance) -> Self {
        self.provenance = provenance;
        self
    }

    /// The figure without the heading drawn in it: for slides, and for pages that have the heading as text.
    pub fn without_heading(mut self) -> Self {
        self.drawing = self.drawing.without_heading();
        self
    }
    /// The figure with other drawings below it, each with its own heading: what belongs together on one sheet.
    pub fn stacked<F: Into<Figure>>(mut self, below: F) -> Self {
        let below = below.into();
        self.drawing = self.drawing.above(below.drawing);
        self.alt = format!("{} {}", self.alt, below.alt);
        self.data.extend(below.data);
        self
    }

    /// The SVG file.
    pub fn svg(&self) -> String {
        let seed = self.seed();
        let metadata = self.metadata(&seed);
        svg::render(
            &self.drawing,
            &svg::Words { title: &self.title, description: &self.alt, metadata: &metadata },
        )
    }

    /// The PNG file, on white.
    pub fn png(&self) -> Vec<u8> {
        let seed = self.seed();
        let mut texts = vec![("Title", self.title.as_str()), ("Description", self.alt.as_str())];
        texts.extend(self.metadata(&seed));
        bitmap::png(&bitmap::render(&self.drawing), &texts).unwrap_or_default()
    }

    fn seed(&self) -> String {
        self.provenance.seed.map_or(String::new(), |s| s.to_string())
    }

    fn metadata<'a>(&'a self, seed: &'a str) -> [(&'static str, &'a str); 5] {
        let p = &self.provenance;
        [
            ("Caption", &self.caption),
            ("Command", &p.command),
            ("Parameters", &p.parameters),
            ("Seed", seed),
            ("Version", &p.version),
        ]
    }
}
