//! Where a ray meets a Menger sponge, and how far from it a point is.

use super::{Cell, Row, RowError, Topic, cells_of};
use crate::sdf::{FieldShape, Menger};
use crate::shape::Shape;

pub(super) const RAY_MENGER: Topic = Topic {
    name: "ray_menger",
    about: "positive crossings of a ray with a Menger sponge, and the outward normal at the first",
    methods: &[
        ("walked", "through the grid of its cells, from coarse to fine"),
        ("marched", "by changes of sign of its distance bound"),
    ],
    inputs: &[
        ("cx", "length"),
        ("cy", "length"),
        ("cz", "length"),
        ("edge", "length"),
        ("depth", ""),
        ("ox", "length"),
        ("oy", "length"),
        ("oz", "length"),
        ("dx", ""),
        ("dy", ""),
        ("dz", ""),
    ],
    outputs: &[("n_pos", ""), ("tp0", "|d|"), ("tp1", "|d|"), ("nx", ""), ("ny", ""), ("nz", "")],
    answer: ray_menger,
};

fn ray_menger(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let allowed = format!("a whole number from 0 to {}", Menger::MOST_DEPTH);
    let depth = row.text("depth").parse::<u32>().ok().filter(|d| *d <= Menger::MOST_DEPTH);
    let depth = depth.ok_or_else(|| row.error("depth", &allowed))?;
    let sponge = Menger::new(row.vector("c")?, row.number("edge")?, depth)
        .map_err(|e| row.error("edge", &e.to_string()))?;
    let ray = row.ray()?;
    let marched = FieldShape::new(sponge).map_err(|e| row.error("edge", &e.to_string()))?;
    let shape: &dyn Shape = if method == "marched" { &marched } else { &sponge };
    let mut crossings = Vec::new();
    shape.crossings(&ray, &mut crossings);
    let mut cells = vec![Cell::Count(crossings.len() as i64)];
    cells.extend((0..2).map(|i| Cell::from(crossings.get(i).map(|c| c.t))));
    cells.extend(cells_of(crossings.first().map(|c| shape.hit(&ray, c).ng)));
    Ok(cells)
}
