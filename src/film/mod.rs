//! Film: linear floating-point images, their files, their comparison.

use crate::color::Rgb;

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
    pub fn width(&self) -> usize {
        self.width
    }
    pub fn height(&self) -> usize {
        self.height
    }
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }
    pub fn get(&self, x: usize, y: usize) -> Rgb {
        self.pixels[y * self.width + x]
    }
    pub fn set(&mut self, x: usize, y: usize, value: Rgb) {
        self.pixels[y * self.width + x] = value;
    }
}
