//! Film: linear floating-point images, their files, their comparison.
//!
//! An [`Image`] holds radiance, unbounded and linear. What is out of a file's range is dealt with
//! once, at the end: [`tone`] maps the picture, [`file`] stores it, [`metric`] compares two.

pub mod accumulator;
pub mod error_picture;
pub mod file;
pub mod metric;
pub mod ssim;
pub mod tone;

pub use accumulator::Accumulator;

use crate::color::Rgb;
use std::ops::{Add, Range};

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

    /// Sum of all pixels, in the fixed order of [`pairwise_sum`].
    pub fn sum(&self) -> Rgb {
        pairwise_sum(0..self.pixels.len(), &|i| self.pixels[i])
    }

    /// Mean of all pixels; `None` without pixels.
    pub fn mean(&self) -> Option<Rgb> {
        (!self.pixels.is_empty()).then(|| self.sum() / self.pixels.len() as f64)
    }

    /// Column and row of the `index`-th pixel.
    pub(crate) fn place(&self, index: usize) -> (usize, usize) {
        (index % self.width, index / self.width)
    }
}

/// Terms that a leaf of [`pairwise_sum`] adds one after the other.
const LEAF: usize = 64;
/// Terms from which halves are worth a thread each. Tuned: from 2¹² a join (up to 10 µs) costs what it
/// saves, from 2²⁰ a usual picture is never shared; 2¹⁵ terms of three channels take about 0.1 ms.
const FORK: usize = 1 << 15;

/// `Σ term(i)` over a range, in an order that depends on the range alone: halves are summed apart
/// and then added, however many threads help.
///
/// - Accuracy: `num::gamma(64 + ⌈log₂(n/64)⌉)` relative to `Σ |term|`: a million pixels lose
///   at most 1e-14, so that nothing is won by compensation.
/// - NaN goes through.
/// - Source: Higham, *Accuracy and Stability of Numerical Algorithms* (2002) §4.2.
pub fn pairwise_sum<T>(range: Range<usize>, term: &(impl Fn(usize) -> T + Sync)) -> T
where
    T: Add<Output = T> + Default + Send,
{
    let count = range.len();
    if count <= LEAF {
        return range.fold(T::default(), |sum, i| sum + term(i));
    }
    let middle = range.start + count / 2;
    let low = || pairwise_sum(range.start..middle, term);
    let high = || pairwise_sum(middle..range.end, term);
    let (low, high) = if count >= FORK { rayon::join(low, high) } else { (low(), high()) };
    low + high
}
