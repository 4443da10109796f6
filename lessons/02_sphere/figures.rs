//! Charts, tables and pictures of lesson 02; their numbers come from the lesson.

use super::work::{Costs, Loss};
use glam::{DVec3, dvec3};
use lightbench::measure::{Method, Point, Series};
use lightbench::num::real::Triple;
use lightbench::shape::sphere::method::{Pair, algebraic, in_front, robust};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Panels, Pixels, Table, short};

pub type Contest = Vec<(Method, Series)>;

/// The series of a contestant by its name; an empty one if there is no such contestant.
pub fn of<'a>(contest: &'a Contest, name: &str) -> &'a Series {
    static NONE: Series = Series { points: Vec::new() };
    contest.iter().find(|(method, _)| method.name == name).map_or(&NONE, |(_, series)| series)
}

/// Root-mean-square error of a contestant at a distance of `10^exponent` radii.
pub fn error_at(series: &Series, exponent: i32) -> f64 {
    let point = series.points.iter().find(|p| p.parameter == 10f64.powi(exponent));
    point.and_then(|p| p.error).map_or(f64::NAN, |e| e.mid)
}

/// The part of a series between two distances.
pub fn between(series: &Series, low: f64, high: f64) -> Series {
    Series::new(series.points.iter().filter(|p| p.parameter >= low && p.parameter <= high).cloned().collect())
}

/// The smallest distance at which a ray was answered wrongly [radii].
pub fn first_failure(series: &Series) -> String {
    let failed = |p: &&Point| p.failures.total() > 0;
    series.points.iter().find(failed).map_or("no distance".to_string(), |p| short(p.parameter))
}

/// Error over distance: where each formula breaks.
pub fn stability(contest: &Contest, rays: u32) -> Figure {
    let axis = Axis::log("distance / radius").range(1.0, 1.3e8);
    let mut chart = Chart::error_over(axis, "error of the hit, radii")
        .title("The robust formula keeps the sphere to 10⁸ radii")
        .subtitle(&format!("root mean square over {rays} rays a point, each within 0.9 radii of the centre"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    for (u, name) in [(f64::EPSILON / 2.0, "u D, f64"), (f64::from(f32::EPSILON) / 2.0, "u D, f32")] {
        chart = chart.guide(Guide::slope_through(1.0, 1.0, u, name));
    }
    Figure::from(chart).caption(
        "Dotted: one rounding of the distance. The robust formula follows it. The other two climb twice as steeply, \
         and lie on each other. Below the axis: rays answered wrongly, of all that were asked.",
    )
}

/// Error against counted work, at one distance.
pub fn speed_accuracy(contest: &Contest, costs: &Costs) -> Figure {
    let mut chart = Chart::work_accuracy("operations per ray", "error of the hit, radii")
        .x(Axis::linear("operations per ray").range(10.0, 35.0))
        .title("Half as many operations again buy six digits")
        .subtitle("from 10⁶ radii away; operations are counted");
    let work = |name: &str| match name {
        n if n.starts_with("robust") => costs.robust.operations,
        n if n.starts_with("closest") => costs.closest.operations,
        _ => costs.quadratic.operations,
    };
    for (method, series) in contest {
        let shown = series.points.iter().filter(|p| p.parameter == 1.0e6);
        let points =
            shown.map(|p| Point { failures: Default::default(), ..p.clone().worked(work(&method.name)) });
        chart = chart.scatter(method.clone(), &Series::new(points.collect()));
    }
    Figure::from(chart)
        .caption("Three formulas in two precisions. An error of 1 radius means that the sphere is lost.")
}

/// Two formulas in f32 as cameras: the same sphere in the same field of view from farther and farther away.
pub fn normals(size: usize) -> Figure {
    type Solve = fn(Triple<f32>, Triple<f32>, f32) -> Pair<f32>;
    let mut panels = Panels::new()
        .columns(4)
        .title("At 1000 radii the quadratic formula frays")
        .subtitle("surface normals as colours, single precision, field of view matched to the distance");
    for (name, solve) in [("quadratic", algebraic as Solve), ("robust", robust as Solve)] {
        for distance in [100.0, 1000.0, 3000.0, 10000.0] {
            panels = panels.picture(telephoto(size, distance, solve), &format!("{name}, {distance} radii"));
        }
    }
    Figure::from(panels.alt(
        "Eight pictures of a ball coloured by its normals. The lower row, robust, is the same smooth disc at 100, 1000, 3000 and \
         10000 radii. The upper row, quadratic, is smooth at 100, frayed along the rim at 1000, a haze beyond the rim at 3000, and no disc at all at 10000.",
    ))
    .caption("One sphere through longer and longer lenses. Upper row: quadratic formula. Lower row: robust formula.")
}

/// The normals that a formula finds, seen from `distance` radii, red to the right, green up, blue towards the eye.
fn telephoto(
    size: usize,
    distance: f64,
    solve: impl Fn(Triple<f32>, Triple<f32>, f32) -> Pair<f32>,
) -> Pixels {
    let towards = dvec3(-0.48, -0.36, -0.8).normalize();
    let right = towards.cross(DVec3::Y).normalize();
    let up = right.cross(towards);
    let eye = towards * -distance;
    let mut rgb = Vec::with_capacity(3 * size * size);
    for k in 0..size * size {
        let place = |i: usize| 1.12 * ((2 * i + 1) as f64 / size as f64 - 1.0);
        let d = (right * place(k % size) - up * place(k / size) - eye).normalize();
        let (f, d) = (eye.to_array().map(|x| x as f32), d.to_array().map(|x| x as f32));
        let colour = in_front(solve(f, d, 1.0)).map(|t| {
            let p = DVec3::from(f.map(f64::from)) + DVec3::from(d.map(f64::from)) * f64::from(t);
            let n = p.normalize_or(DVec3::Y);
            dvec3(n.dot(right), n.dot(up), -n.dot(towards)) * 0.5 + 0.5
        });
        let bytes = colour.unwrap_or(DVec3::splat(0.955)) * 255.0;
        rgb.extend(bytes.to_array().map(|x| x.round().clamp(0.0, 255.0) as u8));
    }
    Pixels::new(size, size, rgb)
}

/// Counted work.
pub fn costs(costs: &Costs) -> Table {
    let mut table = Table::new(&["formula", "operations", "square roots"]).title("What a ray costs");
    for cost in [&costs.quadratic, &costs.quadratic_with_exit, &costs.closest, &costs.robust] {
        table = table.row(&[cost.name, &format!("{:.1}", cost.operations), &format!("{:.2}", cost.roots)]);
    }
    table.subtitle("Sums, products, quotients and square roots per ray; every second ray misses.").marked()
}

/// What the printed listings lose.
pub fn as_printed(losses: &[Loss]) -> Table {
    let mut table =
        Table::new(&["listing as printed", "plain", "sphere of 0.1 mm", "origin inside", "tangent"])
            .title("Each printed listing loses a case that the default keeps");
    for loss in losses {
        let cells = loss.lost.map(|n| n.to_string());
        table = table.row(&[loss.name, &cells[0], &cells[1], &cells[2], &cells[3]]);
    }
    let rays = losses.first().map_or(0, |l| l.rays);
    table.subtitle(&format!("Rays lost of {rays} that hit, in double precision.")).marked()
}
