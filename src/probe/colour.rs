//! Topics about colour.

use super::{Cell, Row, RowError, Topic};
use crate::color::{srgb_decode, srgb_encode};

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
