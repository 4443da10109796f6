//! Irradiance from area lights against its tables.

use super::truth::{Record, all_right};
use lightbench::num::U;

/// Four roundings per edge of unit scale; 1e-12 and 1e-11 of the value allow a thousand times that.
fn absolute(row: &Record, answer: &Record) -> Option<f64> {
    let (want, got) = (row.number("irradiance")?, answer.number("irradiance").unwrap_or(f64::NAN));
    Some((got - want).abs() / (1e-12 + 1e-11 * want))
}

/// 16 roundings of what a light that small sends from straight above, `scale`, and of 1 else; four times that for a first corner
/// that is not the nearest one, for clipped slivers and for the roundings of the sphere's quotients.
fn by_scale(row: &Record, answer: &Record) -> Option<f64> {
    let (want, got) = (row.number("irradiance")?, answer.number("irradiance").unwrap_or(f64::NAN));
    let error = (got - want).abs();
    if error == 0.0 { Some(0.0) } else { Some(error / (64.0 * U * row.number("scale")?)) }
}

#[test]
fn area_lights_agree_with_their_table() {
    all_right("area_light", include_str!("../data/area_light.csv"), absolute);
}

/// Lights 1e-12 rad wide, edges in the horizon and next to it, receivers in the plane, on an edge, on a vertex, scales from
/// 1e-300 to 1e306, offsets to 1e8, slivers.
#[test]
fn area_lights_agree_with_their_nasty_table() {
    all_right("area_light", include_str!("../data/area_light_nasty.csv"), absolute);
    all_right("area_light", include_str!("../data/area_light_nasty.csv"), by_scale);
}
