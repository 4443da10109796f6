//! Pictures to bytes.

use super::{FileError, Format, Written};
use crate::color::{Rgb, srgb_encode};
use crate::film::Image;
use image::ImageEncoder;
use std::io::Cursor;
use std::path::Path;

/// The bytes of a picture's file; `path` only names it in errors.
pub fn encode(
    path: &Path,
    image: &Image,
    format: Format,
    metadata: &[(&str, String)],
) -> Result<(Vec<u8>, Written), FileError> {
    let (width, height) = size(path, image)?;
    check_values(path, image, format)?;
    let result = match format {
        Format::Png8 => png(image, width, height, png::BitDepth::Eight, metadata),
        Format::Png16 => png(image, width, height, png::BitDepth::Sixteen, metadata),
        Format::Exr => exr(image, width, height),
        Format::Hdr => hdr(image, metadata),
    };
    let bytes = result.map_err(|source| FileError::Encode { path: path.to_path_buf(), source })?;
    Ok((bytes, Written { clipped: image.pixels().iter().filter(|p| is_clipped(**p, format)).count() }))
}

type Encoded = Result<Vec<u8>, Box<dyn std::error::Error + Send + Sync>>;

/// Width and height as files hold them: from 1 to 2³¹ − 1, the limit of PNG.
fn size(path: &Path, image: &Image) -> Result<(u32, u32), FileError> {
    let side = |n: usize| i32::try_from(n).ok().filter(|n| *n > 0).map(i32::unsigned_abs);
    side(image.width()).zip(side(image.height())).ok_or_else(|| FileError::Size {
        path: path.to_path_buf(),
        width: image.width(),
        height: image.height(),
    })
}

fn check_values(path: &Path, image: &Image, format: Format) -> Result<(), FileError> {
    let bad = |p: &Rgb| !p.to_array().iter().all(|x| is_held(*x, format));
    let Some(first) = image.pixels().iter().position(bad) else { return Ok(()) };
    let (x, y) = image.place(first);
    let value = image.get(x, y);
    Err(FileError::Value {
        path: path.to_path_buf(),
        count: image.pixels().iter().filter(|p| bad(p)).count(),
        x,
        y,
        value: format!("({}, {}, {})", value.x, value.y, value.z),
        holds: format.description(),
    })
}

fn is_held(x: f64, format: Format) -> bool {
    match format {
        Format::Png8 | Format::Png16 => x.is_finite(),
        Format::Exr => !x.is_finite() || (x as f32).is_finite(),
        // A mantissa may round up to the next power of two, which must be in range as well.
        Format::Hdr => x.is_finite() && x < power_of_two(RGBE_MAX_EXPONENT) * (1.0 - 1.0 / 512.0),
    }
}

fn is_clipped(p: Rgb, format: Format) -> bool {
    match format {
        Format::Png8 | Format::Png16 => p.min_element() < 0.0 || p.max_element() > 1.0,
        Format::Exr => false,
        Format::Hdr => p.min_element() < 0.0,
    }
}

/// PNG through the sRGB curve, and said to be so in its `sRGB` chunk. The `gAMA` and `cHRM` that the
/// standard recommends beside it help readers that do not know `sRGB`; alone they would be misread by others.
fn png(image: &Image, width: u32, height: u32, depth: png::BitDepth, metadata: &[(&str, String)]) -> Encoded {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(depth);
    encoder.set_source_srgb(png::SrgbRenderingIntent::RelativeColorimetric);
    let scaled = png::ScaledFloat::from_scaled;
    encoder.set_source_gamma(scaled(45455));
    encoder.set_source_chromaticities(png::SourceChromaticities {
        white: (scaled(31270), scaled(32900)),
        red: (scaled(64000), scaled(33000)),
        green: (scaled(30000), scaled(60000)),
        blue: (scaled(15000), scaled(6000)),
    });
    for (key, value) in metadata {
        // tEXt is Latin-1 by the standard, but ASCII is all that readers agree about.
        if value.is_ascii() {
            encoder.add_text_chunk(key.to_string(), value.clone())?;
        } else {
            encoder.add_itxt_chunk(key.to_string(), value.clone())?;
        }
    }
    let stored = image.pixels().iter().flat_map(|p| p.to_array()).map(|x| srgb_encode(x.clamp(0.0, 1.0)));
    let samples: Vec<u8> = match depth {
        png::BitDepth::Sixteen => stored.flat_map(|s| ((s * 65535.0 + 0.5) as u16).to_be_bytes()).collect(),
        _ => stored.map(|s| (s * 255.0 + 0.5) as u8).collect(),
    };
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&samples)?;
    writer.finish()?;
    Ok(bytes)
}

fn exr(image: &Image, width: u32, height: u32) -> Encoded {
    let samples: Vec<u8> =
        image.pixels().iter().flat_map(|p| p.to_array()).flat_map(|x| (x as f32).to_ne_bytes()).collect();
    let mut bytes = Cursor::new(Vec::new());
    let encoder = image::codecs::openexr::OpenExrEncoder::new(&mut bytes);
    encoder.write_image(&samples, width, height, image::ExtendedColorType::Rgb32F)?;
    Ok(bytes.into_inner())
}

fn hdr(image: &Image, metadata: &[(&str, String)]) -> Encoded {
    let pixels: Vec<image::Rgb<f32>> = image.pixels().iter().map(|p| nearest_rgbe(*p)).collect();
    let mut body = Vec::new();
    image::codecs::hdr::HdrEncoder::new(&mut body).encode(&pixels, image.width(), image.height())?;
    // Comments stand between the first line, which is the signature, and the rest of the header.
    let signature = body.iter().position(|b| *b == b'\n').map_or(0, |i| i + 1);
    let mut bytes = body[..signature].to_vec();
    for (key, value) in metadata {
        let line = format!("# {key}: {value}").replace(['\n', '\r'], " ");
        bytes.extend_from_slice(line.as_bytes());
        bytes.push(b'\n');
    }
    bytes.extend_from_slice(&body[signature..]);
    Ok(bytes)
}

/// A pixel below `2^127` has an exponent byte; the library's encoder scales by a `f32`, which ends there.
const RGBE_MAX_EXPONENT: i32 = 127;
/// Pixels below `2^−127` are stored as black: their exponent byte would be 0, the code of black.
const RGBE_MIN_EXPONENT: i32 = -126;

/// The RGBE colour nearest to a pixel: mantissas in multiples of `2^(e−8)`, where the largest channel
/// lies in `[2^(e−1), 2^e)`.
///
/// The library's encoder truncates (every picture would come out darker by 1/512 of its maximum
/// on average); what is rounded beforehand, it keeps.
fn nearest_rgbe(rgb: Rgb) -> image::Rgb<f32> {
    let rgb = rgb.max(Rgb::ZERO);
    let largest = rgb.max_element();
    let mut exponent = binary_exponent(largest);
    if exponent < RGBE_MIN_EXPONENT {
        return image::Rgb([0.0; 3]);
    }
    if (largest / power_of_two(exponent - 8)).round() >= 256.0 {
        exponent += 1;
    }
    let step = power_of_two(exponent - 8);
    image::Rgb((rgb / step).round().to_array().map(|mantissa| (mantissa * step) as f32))
}

/// `e` with `2^(e−1) ≤ x < 2^e`, for a normal positive `x`; −1022 for zero and subnormal numbers.
fn binary_exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1022
}

/// `2^n` exactly, for normal powers (`|n| ≤ 1022`).
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}
