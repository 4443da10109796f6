//! Bytes to pictures.

use super::FileError;
use crate::color::{Rgb, srgb_decode};
use crate::film::Image;
use image::codecs::hdr::HdrDecoder;
use image::{DynamicImage, ImageFormat, ImageReader};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Reads a picture as linear colours: PNG, JPEG and TGA through the sRGB curve, EXR and HDR as stored.
///
/// The content decides about the format, the ending only where the content says nothing (TGA).
/// Integers are taken as sRGB whatever a file's gamma or profile says; grey becomes three equal
/// channels; opacity is dropped. An HDR file's `EXPOSURE` is divided out.
pub fn read(path: &Path) -> Result<Image, FileError> {
    let io = |source| FileError::Io { path: path.to_path_buf(), action: "read it", source };
    let file = BufReader::new(File::open(path).map_err(io)?);
    let mut reader = ImageReader::new(file);
    if let Ok(format) = ImageFormat::from_path(path) {
        reader.set_format(format);
    }
    let reader = reader.with_guessed_format().map_err(io)?;
    let known =
        [ImageFormat::Png, ImageFormat::OpenExr, ImageFormat::Hdr, ImageFormat::Jpeg, ImageFormat::Tga];
    let Some(format) = reader.format().filter(|f| known.contains(f)) else {
        return Err(FileError::Ending { path: path.to_path_buf(), known: ".png, .exr, .hdr, .jpg, .tga" });
    };
    let picture = reader.decode().map_err(|e| match e {
        image::ImageError::IoError(source) if source.kind() != std::io::ErrorKind::UnexpectedEof => {
            io(source)
        }
        e => FileError::Decode { path: path.to_path_buf(), source: Box::new(e) },
    })?;
    let exposure = if format == ImageFormat::Hdr { hdr_exposure(path).map_err(io)? } else { 1.0 };
    Ok(linear(&picture, exposure))
}

/// What an HDR file says its numbers were multiplied by.
fn hdr_exposure(path: &Path) -> std::io::Result<f64> {
    let header = HdrDecoder::new(BufReader::new(File::open(path)?));
    let exposure = header.ok().and_then(|h| h.metadata().exposure).map_or(1.0, f64::from);
    Ok(if exposure > 0.0 && exposure.is_finite() { exposure } else { 1.0 })
}

fn linear(picture: &DynamicImage, exposure: f64) -> Image {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let pixels = match picture {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            colours(picture.to_rgb32f().as_raw(), |x| f64::from(x) / exposure)
        }
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => {
            colours(picture.to_rgb16().as_raw(), |x| srgb_decode(f64::from(x) / 65535.0))
        }
        _ => {
            let table: Vec<f64> = (0..=255).map(|level| srgb_decode(f64::from(level) / 255.0)).collect();
            colours(picture.to_rgb8().as_raw(), |x| table[usize::from(x)])
        }
    };
    Image::from_pixels(width, height, pixels)
}

fn colours<T: Copy>(samples: &[T], channel: impl Fn(T) -> f64) -> Vec<Rgb> {
    samples.chunks_exact(3).map(|c| Rgb::new(channel(c[0]), channel(c[1]), channel(c[2]))).collect()
}
