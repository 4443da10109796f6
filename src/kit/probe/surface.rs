//! Where rays meet triangles, discs, cylinders, cones and quadrics.

use super::{Cell, Row, RowError, Topic};
use crate::ray::{Crossing, Ray};
use crate::shape::cylinder::FarEnd;
use crate::shape::quadric::{Coefficients, Quadric};
use crate::shape::triangle::{Facing, Meeting, PreparedRay, Triangle};
use crate::shape::{Shape, ShapeError, Sides, cone, cylinder, disc, quadric, triangle};
use glam::DVec3;

const ROBUST: (&str, &str) =
    ("robust", "certified: in f64 where its rounding bound decides, else in 106 bits");

/// `ox oy oz dx dy dz` after the given columns, with `length` the unit of a length.
macro_rules! with_ray {
    ($(($column:literal, $unit:literal)),* $(,)?) => {
        &[
            $(($column, $unit),)*
            ("ox", "length"), ("oy", "length"), ("oz", "length"),
            ("dx", "any length but zero"), ("dy", "any length but zero"), ("dz", "any length but zero"),
        ]
    };
}

pub const RAY_TRIANGLE: Topic = Topic {
    name: "ray_triangle",
    about: "the ray o + t d against the triangle v0 v1 v2, edges included",
    methods: &[
        ("watertight", "Woop, Benthin & Wald with exact signs at edges"),
        ("moller_trumbore", "Moeller & Trumbore, each step rounded"),
        ("plane_and_areas", "plane, then areas (Badouel)"),
        ("as_printed", "Moeller & Trumbore with tolerances of 1e-6, as [A ill. 56] prints it"),
    ],
    inputs: with_ray![
        ("v0x", "length"),
        ("v0y", "length"),
        ("v0z", "length"),
        ("v1x", "length"),
        ("v1y", "length"),
        ("v1z", "length"),
        ("v2x", "length"),
        ("v2y", "length"),
        ("v2z", "length"),
    ],
    outputs: &[
        ("hit", "0 or 1, for t > 0"),
        ("t", "lengths of d; of the plane's point on a miss"),
        ("b0", "barycentric"),
        ("b1", "barycentric"),
        ("b2", "barycentric"),
        ("front", "1 if d runs against (v1 - v0) x (v2 - v0)"),
    ],
    answer: ray_triangle,
};

fn ray_triangle(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let corners = [row.vector("v0")?, row.vector("v1")?, row.vector("v2")?];
    let ray = ray(row)?;
    let found = match method {
        "moller_trumbore" => triangle::moller_trumbore(&ray, corners),
        "plane_and_areas" => triangle::plane_and_areas(&ray, corners),
        "as_printed" => triangle::as_printed(&ray, corners, Sides::Both),
        _ => {
            let shape = match Triangle::new(corners[0], corners[1], corners[2]) {
                Ok(shape) => shape,
                Err(ShapeError::NoArea { .. }) => return Ok(meeting_cells(false, None)),
                Err(e) => return Err(rejected(row, "v0x", e)),
            };
            let sheared = PreparedRay::new(&ray);
            match shape.meet(&sheared) {
                Some(m) => Some(m),
                None => return Ok(meeting_cells(false, sheared.meet_plane(corners))),
            }
        }
    };
    Ok(meeting_cells(found.is_some_and(|m| m.t > 0.0), found))
}

fn meeting_cells(hit: bool, found: Option<Meeting>) -> Vec<Cell> {
    let mut cells = vec![Cell::Count(i64::from(hit))];
    match found {
        Some(m) => {
            cells.extend([m.t, m.b[0], m.b[1], m.b[2]].map(Cell::Number));
            cells.push(Cell::Count(i64::from(m.facing == Facing::Front)));
        }
        None => cells.extend(vec![Cell::Blank; 5]),
    }
    cells
}

pub const RAY_DISC: Topic = Topic {
    name: "ray_disc",
    about: "the ray o + t d against the disc about c, square to n, of radius r, rim included",
    methods: &[ROBUST, ("as_printed", "plane, then distance, each step rounded, as [B 6.4.1] prints it")],
    inputs: with_ray![
        ("cx", "length"),
        ("cy", "length"),
        ("cz", "length"),
        ("nx", "any length but zero"),
        ("ny", "any length but zero"),
        ("nz", "any length but zero"),
        ("r", "length"),
    ],
    outputs: &[("hit", "0 or 1, for t > 0"), ("t", "lengths of d")],
    answer: ray_disc,
};

fn ray_disc(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (center, normal, radius, ray) = (row.vector("c")?, row.vector("n")?, row.number("r")?, ray(row)?);
    let t = match method {
        "as_printed" => disc::as_printed(center, normal, radius, &ray),
        _ => {
            let shape = disc::Disc::new(center, normal, radius).map_err(|e| rejected(row, "r", e))?;
            shape.meeting(&ray).filter(|&t| t > 0.0)
        }
    };
    Ok(vec![Cell::Count(i64::from(t.is_some())), t.into()])
}

const CAPPED_OUTPUTS: &[(&str, &str)] = &[
    ("n_pos", "crossings with t > 0"),
    ("tp0", "lengths of d"),
    ("face0", "0 side, 1 cap at p0, 2 cap at p1"),
    ("tp1", "lengths of d"),
    ("face1", "0 side, 1 cap at p0, 2 cap at p1"),
    ("nx", "outward unit normal at tp0"),
    ("ny", "outward unit normal at tp0"),
    ("nz", "outward unit normal at tp0"),
];

pub const RAY_CYLINDER: Topic = Topic {
    name: "ray_cylinder",
    about: "the ray o + t d against the capped cylinder of radius r from p0 to p1",
    methods: &[
        ROBUST,
        ("textbook", "[B 6.5.1] with its misprint corrected, each step rounded"),
        ("as_printed", "[B 6.5.1] as printed: side hits beyond both ends"),
    ],
    inputs: with_ray![
        ("p0x", "length"),
        ("p0y", "length"),
        ("p0z", "length"),
        ("p1x", "length"),
        ("p1y", "length"),
        ("p1z", "length"),
        ("r", "length"),
    ],
    outputs: CAPPED_OUTPUTS,
    answer: ray_cylinder,
};

fn ray_cylinder(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (p0, p1, r, ray) = (row.vector("p0")?, row.vector("p1")?, row.number("r")?, ray(row)?);
    let shape = cylinder::Cylinder::new(p0, p1, r).map_err(|e| rejected(row, "r", e))?;
    let found = match method {
        "textbook" => cylinder::textbook(p0, p1, r, FarEnd::Corrected, &ray),
        "as_printed" => cylinder::textbook(p0, p1, r, FarEnd::AsPrinted, &ray),
        _ => positive(&shape, &ray),
    };
    Ok(capped_cells(&shape, &ray, &found))
}

pub const RAY_CONE: Topic = Topic {
    name: "ray_cone",
    about: "the ray o + t d against the capped cone or frustum, radius r0 at p0 and r1 at p1",
    methods: &[ROBUST, ("textbook", "the quadratic at the ray's origin, each step rounded")],
    inputs: with_ray![
        ("p0x", "length"),
        ("p0y", "length"),
        ("p0z", "length"),
        ("p1x", "length"),
        ("p1y", "length"),
        ("p1z", "length"),
        ("r0", "length"),
        ("r1", "length"),
    ],
    outputs: CAPPED_OUTPUTS,
    answer: ray_cone,
};

fn ray_cone(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (p0, p1, ray) = (row.vector("p0")?, row.vector("p1")?, ray(row)?);
    let (r0, r1) = (row.number("r0")?, row.number("r1")?);
    let shape = cone::Cone::new(p0, p1, r0, r1).map_err(|e| rejected(row, "r0", e))?;
    let found = match method {
        "textbook" => cone::textbook(p0, p1, r0, r1, &ray),
        _ => positive(&shape, &ray),
    };
    Ok(capped_cells(&shape, &ray, &found))
}

pub const RAY_QUADRIC: Topic = Topic {
    name: "ray_quadric",
    about: "the ray o + t d against A x2 + E y2 + H z2 + 2Bxy + 2Fyz + 2Cxz + 2Dx + 2Gy + 2Iz + J = 0",
    methods: &[
        ROBUST,
        ("textbook", "[A (5.12)-(5.17)] at the ray's origin, each step rounded"),
        ("as_printed", "the first hit with tolerances of 1e-6, as [A ill. 58] prints it"),
    ],
    inputs: with_ray![
        ("A", "any"),
        ("B", "any"),
        ("C", "any"),
        ("D", "any"),
        ("E", "any"),
        ("F", "any"),
        ("G", "any"),
        ("H", "any"),
        ("I", "any"),
        ("J", "any"),
    ],
    outputs: &[
        ("n_pos", "distinct roots t > 0"),
        ("tp0", "lengths of d"),
        ("tp1", "lengths of d"),
        ("gx", "unit gradient at tp0; blank where it vanishes"),
        ("gy", "unit gradient at tp0; blank where it vanishes"),
        ("gz", "unit gradient at tp0; blank where it vanishes"),
    ],
    answer: ray_quadric,
};

fn ray_quadric(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let n = |column| row.number(column);
    let coefficients = Coefficients {
        a: n("A")?,
        b: n("B")?,
        c: n("C")?,
        d: n("D")?,
        e: n("E")?,
        f: n("F")?,
        g: n("G")?,
        h: n("H")?,
        i: n("I")?,
        j: n("J")?,
    };
    let ray = ray(row)?;
    let shape = match Quadric::new(coefficients) {
        Ok(shape) => shape,
        // All of space or none of it: no ray meets a surface.
        Err(ShapeError::NoEquation { .. }) => return Ok(quadric_cells(&[], None)),
        Err(e) => return Err(rejected(row, "A", e)),
    };
    let roots: Vec<f64> = match method {
        "textbook" => quadric::textbook(&coefficients, &ray),
        "as_printed" => quadric::as_printed(&coefficients, &ray).into_iter().collect(),
        _ => shape.line(&ray).iter().map(|c| c.t).collect(),
    };
    let roots: Vec<f64> = roots.into_iter().filter(|&t| t > 0.0).collect();
    let gradient = roots.first().and_then(|&t| {
        let hit = shape.hit(&ray, &Crossing::new(t, 0));
        shape.gradient(hit.point)
    });
    Ok(quadric_cells(&roots, gradient))
}

fn quadric_cells(roots: &[f64], gradient: Option<DVec3>) -> Vec<Cell> {
    let mut cells = vec![Cell::Count(roots.len() as i64)];
    cells.extend([roots.first().copied().into(), roots.get(1).copied().into()]);
    cells.extend(vector_cells(gradient));
    cells
}

fn vector_cells(v: Option<DVec3>) -> [Cell; 3] {
    v.map_or([Cell::Blank, Cell::Blank, Cell::Blank], |v| v.to_array().map(Cell::Number))
}

fn ray(row: &Row) -> Result<Ray, RowError> {
    let ray = Ray::new(row.vector("o")?, row.vector("d")?);
    for axis in ["x", "y", "z"] {
        for column in [format!("o{axis}"), format!("d{axis}")] {
            if !row.number(&column)?.is_finite() {
                return Err(row.error(&column, "a finite number"));
            }
        }
    }
    if ray.direction == DVec3::ZERO { Err(row.error("dx", "a direction other than 0 0 0")) } else { Ok(ray) }
}

fn rejected(row: &Row, column: &str, e: ShapeError) -> RowError {
    row.error(column, &format!("a surface ({e})"))
}

fn positive(shape: &dyn Shape, ray: &Ray) -> Vec<Crossing> {
    let mut found = Vec::new();
    shape.crossings(ray, &mut found);
    found
}

fn capped_cells(shape: &dyn Shape, ray: &Ray, found: &[Crossing]) -> Vec<Cell> {
    let mut cells = vec![Cell::Count(found.len() as i64)];
    for i in 0..2 {
        cells.push(found.get(i).map(|c| c.t).into());
        cells.push(found.get(i).map_or(Cell::Blank, |c| Cell::Count(i64::from(c.face))));
    }
    cells.extend(vector_cells(found.first().map(|c| shape.hit(ray, c).ng)));
    cells
}
