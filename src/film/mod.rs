//! Film: linear floating-point images, their files, their comparison.
//!
//! An [`Image`] holds radiance, unbounded and linear. What is out of a file's range is dealt with
//! once, at the end: [`tone`] maps the picture, the kit stores it, [`metric`] compares two.

pub mod error_picture;
pub mod metric;
pub mod ssim;
pub mod tone;

use crate::color::Rgb;
use crate::num::sum::pairwise;

/// A linear image. Row 0 is the top; pixels stand row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    width: usize,
    height: usize,
    pixels: Vec<Rgb>,
}

impl Image {
    /// A black image.
    pub fn new(width: usize, height: usize) -> Self {
        Image { width, height, pixels: vec![Rgb::ZERO; width * height] }
    }

    /// An image from a function of (column, row).
    pub fn from_fn(width: usize, height: usize, mut pixel: impl FnMut(usize, usize) -> Rgb) -> Self {
        let pixels = (0..width * height).map(|i| pixel(i % width, i / width)).collect();
        Image { width, height, pixels }
    }

    /// An image from its pixels, row by row from the top.
    pub fn from_pixels(width: usize, height: usize, pixels: Vec<Rgb>) -> Self {
        assert_eq!(pixels.len(), width * height, "pixels of a {width} × {height} image");
        Image { width, height, pixels }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn height(&self) -> usize {
        self.height
    }

    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    pub fn pixels_mut(&mut self) -> &mut [Rgb] {
        &mut self.pixels
    }

    pub fn get(&self, x: usize, y: usize) -> Rgb {
        self.pixels[y * self.width + x]
    }

    pub fn set(&mut self, x: usize, y: usize, value: Rgb) {
        self.pixels[y * self.width + x] = value;
    }

    /// The image with every pixel replaced by a function of it.
    pub fn map(&self, pixel: impl Fn(Rgb) -> Rgb) -> Image {
        Image { pixels: self.pixels.iter().map(|p| pixel(*p)).collect(), ..*self }
    }

    /// Sum of all pixels, in the fixed order of [`pairwise`].
    pub fn sum(&self) -> Rgb {
        pairwise(0..self.pixels.len(), &|i| self.pixels[i])
    }

    /// Mean of all pixels; `None` without pixels.
    pub fn mean(&self) -> Option<Rgb> {
        (!self.pixels.is_empty()).then(|| self.sum() / self.pixels.len() as f64)
    }

    /// Column and row of the `index`-th pixel.
    pub fn place(&self, index: usize) -> (usize, usize) {
        (index % self.width, index / self.width)
    }
}
