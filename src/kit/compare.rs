//! `compare`: the numbers and the picture of what two picture files differ in.

use crate::file::{self, FileError, Format};
use crate::film::Image;
use crate::film::error_picture::{ErrorPicture, signed_error};
use crate::film::metric::{self, Comparison};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Why two files could not be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    #[error(transparent)]
    File(#[from] FileError),
    #[error(
        "pictures of different sizes: {} has {} × {} pixels, {} has {} × {}",
        a.display(), a_size.0, a_size.1, b.display(), b_size.0, b_size.1
    )]
    Sizes { a: PathBuf, a_size: (usize, usize), b: PathBuf, b_size: (usize, usize) },
}

/// What a comparison found.
#[derive(Debug)]
pub struct Report {
    /// The numbers, as a table for the terminal.
    pub table: String,
    /// The error picture: what its colours mean and its path; or why it could not be written.
    pub picture: Result<String, FileError>,
}

/// Compares the picture in `a` with the reference in `b`.
///
/// With `out`, the signed error goes there as a picture, whose PNG text says what its colours mean.
pub fn compare(a: &Path, b: &Path, out: Option<&Path>) -> Result<Report, CompareError> {
    if let Some(out) = out {
        // A wrong ending is known before any work.
        Format::from_path(out)?;
    }
    let (picture, reference) = (file::read(a)?, file::read(b)?);
    let (a_size, b_size) = (size(&picture), size(&reference));
    if a_size != b_size {
        return Err(CompareError::Sizes { a: a.into(), a_size, b: b.into(), b_size });
    }
    let table = table(a, b, a_size, &metric::compare(&picture, &reference));
    let picture = out.map_or(Ok(String::new()), |out| {
        let drawn = signed_error(&picture, &reference);
        file::write(out, &drawn.image, &legend(a, b, &drawn))?;
        Ok(format!(
            "\nerror picture  blue −{s:.4e}, white 0, red +{s:.4e}; {n} pixel(s) beyond\n{}\n",
            out.display(),
            s = drawn.full_scale,
            n = drawn.saturated,
        ))
    });
    Ok(Report { table, picture })
}

fn size(image: &Image) -> (usize, usize) {
    (image.width(), image.height())
}

fn table(a: &Path, b: &Path, (width, height): (usize, usize), c: &Comparison) -> String {
    const CHANNELS: [&str; 3] = ["red", "green", "blue"];
    let at = c.max_at;
    let place = format!("at column {}, row {}, {}", at.x, at.y, CHANNELS[at.channel]);
    let rows = [
        ("RMSE", format!("{:.4e}", c.rmse), "linear, all channels"),
        ("mean error", format!("{:+.4e}", c.signed_mean), "linear, picture − reference"),
        ("relative MSE", format!("{:.4e}", c.relative_mse), "1, floor at 1 % of the mean luminance"),
        ("PSNR", decibels(c), "dB, display values, peak 1"),
        ("SSIM", format!("{:.6}", c.ssim), "1, display luminance"),
        ("largest error", format!("{:+.4e}", c.max_error), place.as_str()),
    ];
    let mut text = format!("picture        {}\nreference      {}\n", a.display(), b.display());
    let _ = writeln!(text, "pixels         {width} × {height}\n");
    for (name, value, unit) in rows {
        let _ = writeln!(text, "{name:<13} {value:>16}  {unit}");
    }
    if c.not_finite > 0 {
        let _ = writeln!(text, "\nnot finite: {} pixel(s), which spoil the numbers above", c.not_finite);
    }
    text
}

/// Identical on a display is not identical: values out of [0,1] may still differ.
fn decibels(c: &Comparison) -> String {
    match (c.psnr == f64::INFINITY, c.max_error == 0.0) {
        (true, true) => "inf (identical)".to_string(),
        (true, false) => "inf (displayed)".to_string(),
        _ => format!("{:.2}", c.psnr),
    }
}

fn legend(a: &Path, b: &Path, drawn: &ErrorPicture) -> [(&'static str, String); 4] {
    let meaning =
        format!("signed error {} - {}, the channel of largest magnitude, linear", a.display(), b.display());
    let scale = format!(
        "blue {:e}, white 0, red {:e}; {} pixel(s) beyond; black: not finite",
        -drawn.full_scale, drawn.full_scale, drawn.saturated
    );
    [
        ("Title", "signed error".to_string()),
        ("Description", meaning),
        ("Scale", scale),
        ("Software", format!("lightbench {}", env!("CARGO_PKG_VERSION"))),
    ]
}
