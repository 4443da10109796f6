//! Charts, tables and pictures of lesson 02; their numbers come from the lesson.

use super::asides::Cost;
use glam::{DVec3, dvec3};
use lightbench::measure::{Method, Series};
use lightbench::num::real::Triple;
use lightbench::shape::sphere::method::{Pair, algebraic, in_front, robust};
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Panels, Pixels, Table, short};

type Contest = [(Method, Series)];

/// Root-mean-square error of a contestant at a distance of `10^exponent` radii.
pub fn error_at(series: &Series, exponent: i32) -> f64 {
    let point = series.points.iter().find(|p| p.parameter == 10f64.powi(exponent));
    point.and_then(|p| p.error).map_or(f64::NAN, |e| e.mid)
}

/// `[low, high]` of the distances.
pub fn between(series: &Series, low: f64, high: f64) -> Series {
    Series::new(series.points.iter().filter(|p| p.parameter >= low && p.parameter <= high).cloned().collect())
}

/// The headline: error of t against time.
pub fn speed(contest: &Contest, costs: &[Cost; 5], rays: u32) -> Figure {
    // Measured seconds stay out of the words, which must repeat from run to run; the axis has them.
    let gain = error_at(&contest[2].1, 6) / error_at(&contest[0].1, 6);
    let price = costs[4].operations / costs[0].operations;
    let mut chart = Chart::speed_accuracy("error of t_{0}, radii (root mean square)")
        .x(Axis::time("time per ray"))
        .title(&format!("At 10⁶ radii robust is {} × as accurate as algebraic, for {price:.1} × its operations", short(gain)))
        .subtitle(&format!(
            "up each line: distance/radius 10², 10⁴, 10⁶; {rays} rays each within 0.9 r; median time of 101 runs over all"
        ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Speed against accuracy: three methods in two precisions, each at three distances. On each line the lowest \
         point is 10² radii away, the next 10⁴, the highest 10⁶. Time is the median of 101 runs with quartiles; operations are \
         counted from 100 radii, every second ray missing; an error of 1 radius means that the sphere is lost.",
    )
}

pub fn stability(contest: &Contest, rays: u32) -> Figure {
    let axis = Axis::log("distance / radius").range(1.0, 1.3e8);
    let mut chart = Chart::error_over(axis, "error of t_{0}, radii (root mean square)")
        .title("Robust loses one rounding of the distance, the others one of its square")
        .subtitle(&format!(
            "{rays} rays a point, aimed within 0.9 r; truth from cross products and two-part sums"
        ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    for (u, name) in [(f64::EPSILON / 2.0, "u D, f64"), (f64::from(f32::EPSILON) / 2.0, "u D, f32")] {
        chart = chart.guide(Guide::slope_through(1.0, 1.0, u, name));
    }
    Figure::from(chart).caption(
        "Error of the nearer root over the distance. The dotted lines are one rounding of the distance, u D with u = 2⁻⁵³ in f64 \
         and 2⁻²⁴ in f32, for scale: robust runs along them; the other two climb twice as steeply until the sphere is lost. Below: rays answered wrongly, of those asked; the truth is that of the ray as it is stored, which in f32 may itself stray from the sphere.",
    )
}

pub fn failure_words(map: FailureMap, name: &str, nearest: f64) -> Figure {
    let title = format!("{name} in f32 loses its first ray within 0.9 r at {} radii", short(nearest));
    let map = map.failing("lost").title(&title).subtitle(
        "sixteen rays a cell, median error; hatched: one of them missed, falsely hit, or off by a radius; above 1: rightly no hit",
    );
    Figure::from(map).caption(&format!(
        "Where {name} fails in f32 (geometric fails as algebraic does): distance from left to right, impact parameter upwards; the edge of the sphere \
         is at 1. Darkest above it: rays that rightly hit nothing."
    ))
}

/// Two methods in f32 as cameras: the same sphere in the same field of view from farther and farther away.
pub fn normals(size: usize) -> Figure {
    let distances = [100.0, 1000.0, 3000.0, 10000.0];
    type Solve = fn(Triple<f32>, Triple<f32>, f32) -> Pair<f32>;
    let mut panels = Panels::new()
        .columns(4)
        .title("At 1000 radii the quadratic frays, at 3000 it is lost; robust is not")
        .subtitle(
            "normals as colours, f32, field of view matched to the distance; above: algebraic, below: robust",
        );
    for (name, solve) in [("algebraic", algebraic as Solve), ("robust", robust as Solve)] {
        for distance in distances {
            let label = format!("{name}, {distance} r");
            panels = panels.picture(telephoto(size, distance, solve), &label);
        }
    }
    Figure::from(panels.alt(
        "Eight pictures of a ball coloured by its normals. The lower row, robust, is the same smooth disc at 100, 1000, 3000 and \
         10000 radii. The upper row, algebraic, is smooth at 100, frayed along the rim at 1000, a haze beyond the rim at 3000, and no disc at all at 10000.",
    ))
    .caption("A sphere coloured by its normals, through longer and longer lenses, in f32: what each method leaves of it.")
}

/// The normals that a solver finds, seen from `distance` radii, red to the right, green up, blue towards the eye.
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

pub fn savings(costs: &[Cost; 5]) -> Figure {
    let mut table = Table::new(&["First meeting by", "operations", "square roots", "ns per ray", "quartiles", "time, ratio"])
        .timed()
        .title(&format!(
            "C's exit saves {:.1} of {:.1} operations a ray, B's test {:.1} of {:.1} roots",
            costs[0].operations - costs[1].operations,
            costs[0].operations,
            costs[2].roots - costs[3].roots,
            costs[2].roots
        ))
        .subtitle("f64, 1024 rays from 100 radii, every second one misses; counts repeat, times are medians of 101 runs");
    for (i, cost) in costs.iter().enumerate() {
        let ns = |s: f64| format!("{:.2}", s * 1.0e9);
        let against = [0, 0, 2, 2, 0][i];
        table = table.row(&[
            cost.name,
            &format!("{:.2}", cost.operations),
            &format!("{:.2}", cost.roots),
            &ns(cost.time.mid),
            &format!("{} to {}", ns(cost.time.low), ns(cost.time.high)),
            &format!("{:.2}", cost.time.mid / costs[against].time.mid),
        ]);
    }
    Figure::from(table.marked()).caption(
        "What two early exits save. Operations are sums, products, quotients and roots. The ratio of times is to both roots at \
         once, and for the geometric pair to comparing d itself.",
    )
}

pub fn as_printed(losses: &[(&str, [usize; 4], u32)]) -> Figure {
    let rays = losses.first().map_or(0, |l| l.2);
    let mut table = Table::new(&[
        "As printed",
        "sphere of 1 m",
        "of 0.1 mm",
        "inside, centre behind",
        "tangent",
    ])
    .title("Each printed listing loses a case that the default keeps")
    .subtitle(&format!(
        "rays lost of {rays} that hit; from 10 radii, inside from half a radius; f64, unit of length 1 m"
    ));
    for (name, lost, _) in losses {
        let cells = lost.map(|n| n.to_string());
        table = table.row(&[name, &cells[0], &cells[1], &cells[2], &cells[3]]);
    }
    Figure::from(table.marked()).caption(
        "The three listings exactly as printed (after A, illustration 57; B, section 6.2.1; C, section 1.6.1) against the default: \
         a threshold with a unit in it, a test that forgets the inside, a tangent thrown away.",
    )
}
