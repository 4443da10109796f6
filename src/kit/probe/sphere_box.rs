//! Where a ray meets a sphere or an axis-aligned box.

use super::{Cell, Row, RowError, Topic, cells_of};
use crate::ray::{Crossing, Ray};
use crate::shape::Shape;
use crate::shape::cuboid::Cuboid;
use crate::shape::sphere::{Sphere, method};

pub(super) const RAY_SPHERE: Topic = Topic {
    name: "ray_sphere",
    about: "positive roots of a ray with a sphere, and the outward normal at the first",
    methods: &[
        ("robust", "closest approach measured, roots without cancellation (Haines et al. 2019)"),
        ("algebraic", "the textbook's quadratic [C §1.6]"),
        ("geometric", "closest approach subtracted [B §6.2.1, corrected]"),
    ],
    inputs: &[
        ("cx", "length"),
        ("cy", "length"),
        ("cz", "length"),
        ("r", "length"),
        ("ox", "length"),
        ("oy", "length"),
        ("oz", "length"),
        ("dx", ""),
        ("dy", ""),
        ("dz", ""),
    ],
    outputs: &[("n_pos", ""), ("tp0", "|d|"), ("tp1", "|d|"), ("nx", ""), ("ny", ""), ("nz", "")],
    answer: ray_sphere,
};

fn ray_sphere(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let sphere =
        Sphere::new(row.vector("c")?, row.number("r")?).map_err(|e| row.error("r", &e.to_string()))?;
    let ray = row.ray()?;
    let (f, d, r) = ((ray.origin - sphere.center()).to_array(), ray.direction.to_array(), sphere.radius());
    let roots = match method {
        "algebraic" => method::algebraic(f, d, r),
        "geometric" => method::geometric(f, d, r),
        _ => sphere.roots(&ray),
    };
    let mut crossings = Vec::new();
    if let Some((t0, t1)) = roots {
        crossings.extend([t0, t1].iter().filter(|t| **t > 0.0).map(|t| Crossing::new(*t, 0)));
        crossings.dedup_by_key(|c| c.t);
    }
    Ok(answer(&sphere, &ray, &crossings, Faces::Hidden))
}

pub(super) const RAY_BOX: Topic = Topic {
    name: "ray_box",
    about: "positive roots of a ray with an axis-aligned box; faces 0: -x, 1: +x, 2: -y, 3: +y, 4: -z, 5: +z",
    methods: &[],
    inputs: &[
        ("x0", "length"),
        ("y0", "length"),
        ("z0", "length"),
        ("x1", "length"),
        ("y1", "length"),
        ("z1", "length"),
        ("ox", "length"),
        ("oy", "length"),
        ("oz", "length"),
        ("dx", ""),
        ("dy", ""),
        ("dz", ""),
    ],
    outputs: &[
        ("n_pos", ""),
        ("tp0", "|d|"),
        ("face0", ""),
        ("tp1", "|d|"),
        ("face1", ""),
        ("nx", ""),
        ("ny", ""),
        ("nz", ""),
    ],
    answer: ray_box,
};

fn ray_box(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let corner = |i| -> Result<glam::DVec3, RowError> {
        let n = |axis| row.number(&format!("{axis}{i}"));
        Ok(glam::DVec3::new(n("x")?, n("y")?, n("z")?))
    };
    let cuboid = Cuboid::new(corner(0)?, corner(1)?).map_err(|e| row.error("x1", &e.to_string()))?;
    let ray = row.ray()?;
    let mut crossings = Vec::new();
    cuboid.crossings(&ray, &mut crossings);
    Ok(answer(&cuboid, &ray, &crossings, Faces::Shown))
}

/// Does a topic print which face was met?
#[derive(PartialEq)]
enum Faces {
    Shown,
    Hidden,
}

/// Count, up to two crossings (with faces where the topic has them), normal at the first.
fn answer(shape: &dyn Shape, ray: &Ray, crossings: &[Crossing], faces: Faces) -> Vec<Cell> {
    let mut cells = vec![Cell::Count(crossings.len() as i64)];
    for i in 0..2 {
        cells.push(crossings.get(i).map(|c| c.t).into());
        if faces == Faces::Shown {
            cells.push(crossings.get(i).map_or(Cell::Blank, |c| Cell::Count(i64::from(c.face))));
        }
    }
    cells.extend(cells_of(crossings.first().map(|c| shape.hit(ray, c).ng)));
    cells
}
