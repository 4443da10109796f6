//! How large and how fine a picture of the stage is.

use crate::flags::Quality;
use crate::render::Picture;

/// A picture's pixels and what is spent on them.
///
/// | quality | hero | panel | cells a pixel |
/// |---|---|---|---|
/// | smoke | 160 × 100 | 96 × 72 | 1 |
/// | draft | 800 × 500 | 400 × 300 | 2 × 2 |
/// | standard | 1600 × 1000 | 800 × 600 | 4 × 4 |
/// | final | 1600 × 1000 | 800 × 600 | 8 × 8 |
///
/// A pixel is the mean over a camera ray through the centre of each of its `cells × cells` equal squares: a box filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderSize {
    pub width: usize,
    pub height: usize,
    /// Camera rays along a pixel's side.
    pub cells: u32,
    pub seed: u64,
}

impl RenderSize {
    /// A picture across the page.
    pub fn hero(quality: Quality, seed: u64) -> Self {
        let (width, height) = [(160, 100), (800, 500), (1600, 1000), (1600, 1000)][quality as usize];
        RenderSize { width, height, cells: cells(quality), seed }
    }

    /// One of two or three pictures side by side.
    pub fn panel(quality: Quality, seed: u64) -> Self {
        let (width, height) = [(96, 72), (400, 300), (800, 600), (800, 600)][quality as usize];
        RenderSize { width, height, cells: cells(quality), seed }
    }

    /// The same for another shape of picture: as many pixels in all, `aspect` times as wide as high.
    pub fn shaped(self, aspect: f64) -> Self {
        let height = ((self.width * self.height) as f64 / aspect).sqrt().round().max(1.0);
        RenderSize { width: (height * aspect).round().max(1.0) as usize, height: height as usize, ..self }
    }

    /// What the tile loop makes of it.
    pub fn picture(&self) -> Picture {
        let samples = self.cells.max(1).pow(2);
        Picture { width: self.width, height: self.height, samples, seed: self.seed }
    }

    /// Points on a light for each camera ray; with all rays of a pixel `pixel` of them at least.
    pub(super) fn points(&self, pixel: u32) -> u32 {
        pixel.div_ceil(self.picture().samples).next_power_of_two()
    }
}

fn cells(quality: Quality) -> u32 {
    [1, 2, 4, 8][quality as usize]
}
