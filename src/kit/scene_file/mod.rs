//! Scene files: the text format of [D §4], read with every mistake reported where it stands.
//!
//! ```text
//! characters ─ token ─▶ words, texts, braces ─ parse, against the table in `blocks` ─▶ blocks with
//! checked values ─ build ─▶ a Scene and its Settings
//! ```
//!
//! Reading never stops at the first mistake; nothing is built from a file that has one.

mod blocks;
mod build;
pub mod csg;
mod declared;
mod diagnostic;
mod format;
pub mod obj;
mod parse;
mod pending;
mod reference;
mod render;
mod source;
mod suggest;
mod token;
mod value;

pub use blocks::MOST_PIXELS;
pub use diagnostic::{Diagnostic, Diagnostics, Place, Severity, Span, quoted, quoted_name};
pub use reference::reference;
pub use render::Color;
pub use source::{LARGEST_FILE, ReadError, read_bytes, read_file};

use crate::scene::Scene;
use std::path::Path;

/// Which settings of the picture a file gives itself; the rest are the document's defaults, which a quality
/// that was asked for may replace.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Given {
    pub width: bool,
    pub height: bool,
    pub samples: bool,
}

/// The picture and its quality [D §4.3].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Width of the picture \[pixels\].
    pub width: u32,
    /// Height of the picture \[pixels\].
    pub height: u32,
    /// Samples in each pixel: 1, 4 or 16.
    pub samples: u32,
    /// n: 2n² rays for each glossy reflection.
    pub reflection_quality: u32,
    /// Most reflections in a row.
    pub reflection_steps: u32,
    /// n: 2n² rays for indirect light, which is computed if n > 2.
    pub indirect_quality: u32,
    /// Multiplies indirect light.
    pub color_bleeding: f64,
    pub given: Given,
}

impl Default for Settings {
    /// The document's defaults.
    fn default() -> Self {
        Settings {
            width: 512,
            height: 512,
            samples: 1,
            reflection_quality: 3,
            reflection_steps: 1,
            indirect_quality: 3,
            color_bleeding: 1.0,
            given: Given::default(),
        }
    }
}

/// What a file describes.
#[derive(Debug)]
pub struct SceneFile {
    pub scene: Scene,
    pub settings: Settings,
    /// Warnings and notes, by place.
    pub remarks: Diagnostics,
}

impl SceneFile {
    /// Most rays that local illumination shoots for one pixel: each sample one from the camera, and from
    /// what it meets one to each point light and to each cell of each area light.
    pub fn rays_per_pixel(&self) -> u64 {
        let shadow: u64 = self.scene.lights.iter().map(|light| u64::from(light.rays())).sum();
        u64::from(self.settings.samples) * (1 + shadow)
    }
}

/// Reads a scene from its text; `name` is what messages call the file, and the files it names are looked for beside it.
///
/// - Errors: everything that is wrong, and the warnings and notes with it.
pub fn read(source: &str, name: &str) -> Result<SceneFile, Diagnostics> {
    let mut log = Vec::new();
    let tokens = token::tokens(source, &mut log);
    let parsed = parse::parse(source, &tokens, &mut log);
    let folder = Path::new(name).parent().unwrap_or(Path::new(""));
    let (built, files) = build::build(source, folder, &parsed, &mut log);
    let remarks = Diagnostics::new(name, source, log).with_files(files);
    match built {
        Some((scene, settings)) if remarks.errors().next().is_none() => {
            Ok(SceneFile { scene, settings, remarks })
        }
        _ => Err(remarks),
    }
}
