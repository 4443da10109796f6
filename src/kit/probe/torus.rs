//! The torus, and the quartics it leads to.

use super::{Cell, Row, RowError, Topic, cells_of};
use crate::num::quartic::{self, Solver};
use crate::shape::Shape;
use crate::shape::torus::{Torus, TorusMethod};

pub(super) const RAY_TORUS: Topic = Topic {
    name: "ray_torus",
    about: "positive roots of a ray with a torus (axis z, centre 0), and the outward normal at the first",
    methods: &[
        (
            "adaptive",
            "moved to the closest approach; certified signs, else double-double; polished on the surface",
        ),
        ("as_printed", "expanded at the origin, Cardano and Ferrari with absolute epsilons [A §5.4.4]"),
        ("recentred", "the printed solver after moving and scaling"),
        ("ferrari", "moved and scaled; Ferrari's factors, Newton"),
        ("bracketed", "moved and scaled; Newton and bisection between stationary points (Yuksel 2022)"),
        ("algorithm_1010", "moved and scaled; LDLᵀ factors (Orellana & De Michele 2020)"),
        ("sturm", "moved and scaled; Sturm's chain, bisection"),
        ("marching", "steps of the exact distance"),
    ],
    inputs: &[
        ("a", "length"),
        ("b", "length"),
        ("ox", "length"),
        ("oy", "length"),
        ("oz", "length"),
        ("dx", ""),
        ("dy", ""),
        ("dz", ""),
    ],
    outputs: &[
        ("n_pos", ""),
        ("t0", "|d|"),
        ("t1", "|d|"),
        ("t2", "|d|"),
        ("t3", "|d|"),
        ("nx", ""),
        ("ny", ""),
        ("nz", ""),
    ],
    answer: ray_torus,
};

fn ray_torus(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let method = TorusMethod::ALL.into_iter().find(|m| m.name() == method).unwrap_or_default();
    let torus = Torus::new(row.number("a")?, row.number("b")?).map_err(|e| row.error("b", &e.to_string()))?;
    let (torus, ray) = (torus.with_method(method), row.ray()?);
    let mut crossings = Vec::new();
    torus.crossings(&ray, &mut crossings);
    let mut cells = vec![Cell::Count(crossings.len() as i64)];
    cells.extend((0..4).map(|i| Cell::from(crossings.get(i).map(|c| c.t))));
    cells.extend(cells_of(crossings.first().map(|c| torus.hit(&ray, c).ng)));
    Ok(cells)
}

pub(super) const QUARTIC_ROOTS: Topic = Topic {
    name: "quartic_roots",
    about: "distinct real roots of x⁴ + a3 x³ + a2 x² + a1 x + a0, ascending",
    methods: &[
        ("adaptive", "brackets with certified signs, else double-double"),
        ("bracketed", "Newton and bisection between stationary points, plain f64 (Yuksel 2022)"),
        ("algorithm_1010", "LDLᵀ factors (Orellana & De Michele 2020)"),
        ("ferrari", "Ferrari's factors from the largest root of the resolvent, Newton"),
        ("sturm", "Sturm's chain in double-double, bisection"),
        ("as_printed", "Cardano and Ferrari with an absolute epsilon (Graphics Gems 1990) [A §5.4.4]"),
    ],
    inputs: &[("a3", ""), ("a2", ""), ("a1", ""), ("a0", "")],
    outputs: &[("n_real_distinct", ""), ("r0", ""), ("r1", ""), ("r2", ""), ("r3", "")],
    answer: quartic_roots,
};

fn quartic_roots(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let solve: Solver = match method {
        "bracketed" => quartic::bracketed,
        "algorithm_1010" => quartic::algorithm_1010,
        "ferrari" => quartic::ferrari,
        "sturm" => quartic::sturm,
        "as_printed" => quartic::graphics_gems_as_printed,
        _ => quartic::adaptive,
    };
    let roots = solve(row.number("a3")?, row.number("a2")?, row.number("a1")?, row.number("a0")?);
    let mut cells = vec![Cell::Count(roots.len() as i64)];
    cells.extend((0..4).map(|i| Cell::from(roots.get(i).copied())));
    Ok(cells)
}
