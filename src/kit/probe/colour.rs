//! Topics about colour.

use super::{Cell, Row, RowError, Topic};
use crate::color::dominant::{Locus, Rim};
use crate::color::models::{cmy_from_rgb, degrees, hls_from_rgb, hsv_from_rgb};
use crate::color::spectrum::Matching;
use crate::color::xyz::xyz_from_rgb;
use crate::color::{Rgb, srgb_decode, srgb_encode};
use glam::dvec2;

/// The sRGB curve and its inverse.
pub const SRGB_TRANSFER: Topic = Topic {
    name: "srgb_transfer",
    about: "the sRGB transfer curve, from linear to stored values and back",
    methods: &[("piecewise", "straight piece and power, IEC 61966-2-1")],
    inputs: &[("direction", "encode or decode"), ("input", "linear or stored channel, white is 1")],
    outputs: &[("output", "stored or linear channel, white is 1")],
    answer: srgb_transfer,
};

fn srgb_transfer(row: &Row, _method: &str) -> Result<Vec<Cell>, RowError> {
    let curve = match row.text("direction") {
        "encode" => srgb_encode,
        "decode" => srgb_decode,
        _ => return Err(row.error("direction", "`encode` or `decode`")),
    };
    Ok(vec![Cell::Number(curve(row.number("input")?))])
}

/// A linear colour in the other models.
pub const COLOUR_CONVERT: Topic = Topic {
    name: "colour_convert",
    about: "a linear sRGB colour as CMY, HSV, HLS, XYZ and stored sRGB",
    methods: &[],
    inputs: &[("r", "linear, [0,1]"), ("g", "linear, [0,1]"), ("b", "linear, [0,1]")],
    outputs: &[
        ("c", "[0,1]"),
        ("m", "[0,1]"),
        ("y", "[0,1]"),
        ("hsv_h", "degrees, 0 for greys"),
        ("hsv_s", "[0,1]"),
        ("hsv_v", "[0,1]"),
        ("hls_h", "degrees, 0 for greys"),
        ("hls_l", "[0,1]"),
        ("hls_s", "[0,1]"),
        ("X", "white has Y = 1"),
        ("Y", "white has Y = 1"),
        ("Z", "white has Y = 1"),
        ("srgb_r", "stored channel, white is 1"),
        ("srgb_g", "stored channel, white is 1"),
        ("srgb_b", "stored channel, white is 1"),
    ],
    answer: colour_convert,
};

fn colour_convert(row: &Row, _method: &str) -> Result<Vec<Cell>, RowError> {
    let channel = |column| match row.number(column)? {
        x if (0.0..=1.0).contains(&x) => Ok(x),
        _ => Err(row.error(column, "a number in [0,1]")),
    };
    let rgb = Rgb::new(channel("r")?, channel("g")?, channel("b")?);
    let (hsv, hls) = (hsv_from_rgb(rgb), hls_from_rgb(rgb));
    let painters =
        [[degrees(hsv.hue), hsv.saturation, hsv.value], [degrees(hls.hue), hls.lightness, hls.saturation]];
    let stored = rgb.map(srgb_encode).to_array();
    let numbers =
        [cmy_from_rgb(rgb).to_array(), painters[0], painters[1], xyz_from_rgb(rgb).to_array(), stored];
    Ok(numbers.into_iter().flatten().map(Cell::Number).collect())
}

/// Dominant wavelength and purity.
pub const DOMINANT_WAVELENGTH: Topic = Topic {
    name: "dominant_wavelength",
    about: "dominant wavelength and purity of a chromaticity as seen from a white",
    methods: &[
        ("1nm", "the standard's table, linear between its rows"),
        ("5nm", "every fifth row of the table"),
        ("multi_lobe", "Wyman, Sloan & Shirley's fit, 400 to 640 nm"),
    ],
    inputs: &[
        ("x", "chromaticity"),
        ("y", "chromaticity"),
        ("xw", "chromaticity of the white"),
        ("yw", "chromaticity of the white"),
    ],
    outputs: &[
        ("dominant_nm", "nm; minus the complementary wavelength for purples; blank for the white itself"),
        ("purity", "share of the way from white to the rim"),
        ("complementary", "1 for purples, else 0"),
    ],
    answer: dominant_wavelength,
};

fn dominant_wavelength(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let matching = match method {
        "5nm" => Matching::Table5nm,
        "multi_lobe" => Matching::MultiLobe,
        _ => Matching::Table1nm,
    };
    let (xy, white) =
        (dvec2(row.number("x")?, row.number("y")?), dvec2(row.number("xw")?, row.number("yw")?));
    let Some(wheel) = Locus::of(matching).wheel(white) else {
        return Ok(vec![Cell::Blank; 3]); // from outside the curve of the spectrum nothing is a white
    };
    Ok(match wheel.dominant(xy) {
        Some(dominant) => {
            let (wavelength, purple) = match dominant.rim {
                Rim::Spectral(wavelength) => (wavelength, 0),
                Rim::Purple(complementary) => (-complementary, 1),
            };
            vec![Cell::Number(wavelength), Cell::Number(dominant.purity), Cell::Count(purple)]
        }
        // White has no hue.
        None => vec![Cell::Blank, Cell::Number(0.0), Cell::Count(0)],
    })
}
