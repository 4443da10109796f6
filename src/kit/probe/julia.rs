//! Quaternion Julia sets: orbits, distances, and rays that meet the solid.

use super::{Cell, Row, RowError, Topic};
use crate::num::double_double::DoubleDouble;
use crate::num::real::Real;
use crate::sdf::julia::orbit::{as_printed_estimate, escape, quaternion, safe_step};
use crate::sdf::julia::{Julia, JuliaMethod, LARGEST_C, MOST_ITERATIONS, March};
use crate::shape::Shape;
use glam::DVec4;

pub(super) const JULIA_ESCAPE: Topic = Topic {
    name: "julia_escape",
    about: "orbit of x + y i + z j under q² + c: steps until |q| > bailout (−1: none of N), |q|, |q'|, and Hart's distance",
    methods: &[
        ("double_double", "the orbit with 106 bits"),
        ("f64", "the orbit with 53 bits, which |q'| uses up"),
        ("as_printed", "the distance after all N steps, without a bailout"),
    ],
    inputs: &[
        ("c0", ""),
        ("c1", ""),
        ("c2", ""),
        ("c3", ""),
        ("px", ""),
        ("py", ""),
        ("pz", ""),
        ("N", ""),
        ("bailout", ""),
    ],
    outputs: &[("n_escape", ""), ("qmag", ""), ("dmag", ""), ("de", "length")],
    answer: julia_escape,
};

pub(super) const JULIA_HIT: Topic = Topic {
    name: "julia_hit",
    about: "first crossing of a ray with the level set |q_N| = bailout",
    methods: &[
        ("certified", "bounds by majorants, a grid of empty cells, Newton's steps"),
        ("as_printed", "step by the estimate, go back by halves from inside [A §5.4.5]"),
        ("estimate", "steps of the estimate from the bounding ball on"),
        ("at_least", "the same, no step shorter than 1/20, then bisection"),
        ("ball", "steps that are never too long"),
    ],
    inputs: &[
        ("c0", ""),
        ("c1", ""),
        ("c2", ""),
        ("c3", ""),
        ("N", ""),
        ("bailout", ""),
        ("ox", "length"),
        ("oy", "length"),
        ("oz", "length"),
        ("dx", ""),
        ("dy", ""),
        ("dz", ""),
    ],
    outputs: &[("hit", ""), ("t", "|d|")],
    answer: julia_hit,
};

pub(super) const JULIA_DISTANCE: Topic = Topic {
    name: "julia_distance",
    about: "a step from x + y i + z j that leads to no point of the set of the endless iteration",
    methods: &[
        ("double_double", "a bound, never beyond the set; the orbit with 106 bits"),
        ("f64", "the same with 53 bits"),
        ("as_printed", "Hart's estimate, with bailout 100: too long far away"),
    ],
    inputs: &[
        ("c0", ""),
        ("c1", ""),
        ("c2", ""),
        ("c3", ""),
        ("px", "length"),
        ("py", "length"),
        ("pz", "length"),
    ],
    outputs: &[("safe_step", "length")],
    answer: julia_distance,
};

/// Steps of the estimate that `julia_distance` prints.
const STEPS: u32 = 10_000;

fn c(row: &Row) -> Result<DVec4, RowError> {
    Ok(DVec4::new(row.number("c0")?, row.number("c1")?, row.number("c2")?, row.number("c3")?))
}

/// The point as a quaternion.
fn point(row: &Row) -> Result<DVec4, RowError> {
    Ok(row.vector("p")?.extend(0.0))
}

fn iterations(row: &Row) -> Result<u32, RowError> {
    row.text("N").parse().map_err(|_| row.error("N", "a whole number of steps, at least 0"))
}

fn bailout(row: &Row) -> Result<f64, RowError> {
    let bailout = row.number("bailout")?;
    if bailout > 0.0 { Ok(bailout) } else { Err(row.error("bailout", "a number above 0")) }
}

fn julia_escape(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (q, c, most, bailout) = (point(row)?, c(row)?, iterations(row)?, bailout(row)?);
    let mut cells = match method {
        "double_double" => escape_cells::<DoubleDouble>(q, c, most, bailout),
        _ => escape_cells::<f64>(q, c, most, bailout),
    };
    if method == "as_printed" {
        let printed = as_printed_estimate::<f64>(quaternion(q), quaternion(c), most);
        cells[3] = printed.is_finite().then_some(printed).into();
    }
    Ok(cells)
}

fn escape_cells<R: Real>(q: DVec4, c: DVec4, most: u32, bailout: f64) -> Vec<Cell> {
    let end = escape::<R>(quaternion(q), quaternion(c), most, bailout);
    let finite = |x: f64| Cell::from(x.is_finite().then_some(x));
    vec![
        Cell::Count(if end.escaped { i64::from(end.steps) } else { -1 }),
        finite(end.size.to_f64()),
        finite(end.derivative.to_f64()),
        end.estimate().filter(|x| x.is_finite()).into(),
    ]
}

/// Where a march stops, and when it gives up.
const MARCH: March = March { tolerance: 1.0e-7, most: 100_000 };

fn julia_hit(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (c, n, b) = (c(row)?, iterations(row)?, bailout(row)?);
    let julia = Julia::new(c, n, b, 0.0).map_err(|e| {
        let column = [("c0", c.length() > LARGEST_C), ("N", n > MOST_ITERATIONS)].into_iter().find(|x| x.1);
        row.error(column.map_or("bailout", |x| x.0), &e.to_string())
    })?;
    let julia = julia.with_method(match method {
        "as_printed" => JuliaMethod::AsPrinted(MARCH),
        "estimate" => JuliaMethod::Estimate(MARCH),
        "at_least" => JuliaMethod::AtLeast(MARCH),
        "ball" => JuliaMethod::Ball(MARCH),
        _ => JuliaMethod::Certified,
    });
    let t = julia.nearest(&row.ray()?, 0.0, f64::INFINITY).map(|crossing| crossing.t);
    Ok(vec![Cell::Count(i64::from(t.is_some())), t.into()])
}

fn julia_distance(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let (q, c) = (point(row)?, c(row)?);
    let step = match method {
        "double_double" => safe_step::<DoubleDouble>(q, c),
        "f64" => safe_step::<f64>(q, c),
        _ => {
            let end = escape::<f64>(quaternion(q), quaternion(c), STEPS, 100.0);
            end.estimate().unwrap_or(0.0)
        }
    };
    Ok(vec![Cell::Number(step)])
}
