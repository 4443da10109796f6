//! Files of pictures: PNG with the sRGB curve, OpenEXR and Radiance HDR with linear numbers.
//!
//! | format | stores | error of a stored channel |
//! |---|---|---|
//! | `Png8`, `Png16` | `[0,1]`, sRGB curve, nearest level, no dithering | half a level: 1/510, 1/131070 after the curve |
//! | `Exr` | any number, `f32` | 2⁻²⁴ of itself (a value beyond 3.4e38 is refused) |
//! | `Hdr` | 0 … 1.7e38, three 8-bit mantissas and one exponent | 2⁻⁸ of the pixel's largest channel |
//!
//! A value that a format cuts off is counted in [`Written::clipped`]; one that it cannot hold at all
//! (NaN and ∞, except in `Exr`) is an error that names the pixel, and no file is written.
//! Files appear whole or not at all: [`write_atomically`].

mod atomic;
mod decode;
mod encode;

pub use atomic::write_atomically;
pub use decode::read;
pub use encode::encode;

use crate::film::Image;
use std::path::{Path, PathBuf};

/// A format that pictures are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// PNG with 8 bits per channel: `.png`.
    Png8,
    /// PNG with 16 bits per channel; has no ending of its own.
    Png16,
    /// OpenEXR, 32-bit floating-point red, green, blue, compressed without loss: `.exr`.
    Exr,
    /// Radiance RGBE: `.hdr`.
    Hdr,
}

impl Format {
    /// The format that a file's ending asks for, in small or capital letters.
    pub fn from_path(path: &Path) -> Result<Format, FileError> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        match ending.as_str() {
            "png" => Ok(Format::Png8),
            "exr" => Ok(Format::Exr),
            "hdr" => Ok(Format::Hdr),
            _ => Err(FileError::Ending { path: path.to_path_buf(), known: ".png, .exr, .hdr" }),
        }
    }

    /// The ending of its files, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Png8 | Format::Png16 => "png",
            Format::Exr => "exr",
            Format::Hdr => "hdr",
        }
    }

    /// What it is called in messages, and what it can hold.
    fn description(self) -> &'static str {
        match self {
            Format::Png8 | Format::Png16 => "PNG holds finite numbers only (.exr holds all)",
            Format::Exr => "OpenEXR holds magnitudes up to 3.4e38",
            Format::Hdr => "Radiance HDR holds finite numbers below 1.7e38 (.exr holds all)",
        }
    }
}

/// What became of a picture on its way into a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Pixels with a channel that was cut off at an end of the format's range: `[0,1]` of PNG, 0 of HDR.
    pub clipped: usize,
}

/// Why a file could not be written or read: which, and what failed.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    #[error("{}: no picture in a known format; known are {known}", path.display())]
    Ending { path: PathBuf, known: &'static str },
    #[error("{}: cannot {action}: {source}", path.display())]
    Io { path: PathBuf, action: &'static str, source: std::io::Error },
    #[error("{}: {width} × {height} pixels are no picture that a file can hold", path.display())]
    Size { path: PathBuf, width: usize, height: usize },
    #[error(
        "{}: {count} pixel(s) cannot be stored, the first at column {x}, row {y}: {value}; {holds}",
        path.display()
    )]
    Value { path: PathBuf, count: usize, x: usize, y: usize, value: String, holds: &'static str },
    #[error("{}: cannot encode the picture: {source}", path.display())]
    Encode { path: PathBuf, source: Box<dyn std::error::Error + Send + Sync> },
    #[error("{}: cannot decode the picture: {source}", path.display())]
    Decode { path: PathBuf, source: Box<dyn std::error::Error + Send + Sync> },
}

/// Writes a picture in the format of its ending, atomically, with provenance.
///
/// `metadata` are keys (1–79 Latin letters) and values: text chunks of a PNG, comment lines of an HDR.
/// The EXR writer stores none.
pub fn write(path: &Path, image: &Image, metadata: &[(&str, String)]) -> Result<Written, FileError> {
    write_as(path, image, Format::from_path(path)?, metadata)
}

/// As [`write()`], in a given format.
pub fn write_as(
    path: &Path,
    image: &Image,
    format: Format,
    metadata: &[(&str, String)],
) -> Result<Written, FileError> {
    let (bytes, written) = encode(path, image, format, metadata)?;
    write_atomically(path, &bytes)?;
    Ok(written)
}
