//! Area lights: the irradiance that they send to a point.

use super::{Cell, Row, RowError, Topic};
use crate::light::{polygon_irradiance, sphere_irradiance};
use glam::DVec3;

const KINDS: &str = "rectangle (v0…v3 in order), triangle (v0…v2), sphere (centre v0, radius)";

pub(super) const AREA_LIGHT: Topic = Topic {
    name: "area_light",
    about: "irradiance at a point from an area light of radiance 1 that emits to both sides, cut at the horizon of n",
    methods: &[],
    inputs: &[
        ("kind", KINDS),
        ("v0x", "length"),
        ("v0y", "length"),
        ("v0z", "length"),
        ("v1x", "length"),
        ("v1y", "length"),
        ("v1z", "length"),
        ("v2x", "length"),
        ("v2y", "length"),
        ("v2z", "length"),
        ("v3x", "length"),
        ("v3y", "length"),
        ("v3z", "length"),
        ("radius", "length"),
        ("px", "length"),
        ("py", "length"),
        ("pz", "length"),
        ("nx", ""),
        ("ny", ""),
        ("nz", ""),
    ],
    outputs: &[("irradiance", "W/m²")],
    answer,
};

fn answer(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let (p, n) = (row.vector("p")?, row.vector("n")?);
    if n == DVec3::ZERO {
        return Err(row.error("nx", "a normal that is not the zero vector"));
    }
    let corner = |i: usize| row.vector(["v0", "v1", "v2", "v3"][i]);
    let irradiance = match row.text("kind") {
        "rectangle" => polygon_irradiance(&[corner(0)?, corner(1)?, corner(2)?, corner(3)?], p, n),
        "triangle" => polygon_irradiance(&[corner(0)?, corner(1)?, corner(2)?], p, n),
        "sphere" => {
            let radius = row.number("radius")?;
            if radius < 0.0 {
                return Err(row.error("radius", "a radius that is not negative"));
            }
            sphere_irradiance(corner(0)?, radius, p, n)
        }
        _ => return Err(row.error("kind", &format!("one of: {KINDS}"))),
    };
    Ok(vec![Cell::Number(irradiance)])
}
