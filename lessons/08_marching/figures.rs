//! Charts of the contest, and the steps of one ray as a drawing.

use super::{Contest, MOST_STEPS};
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::measure::{Method, Point, Series};
use lightbench::ray::Ray;
use lightbench::sdf::combine::Union;
use lightbench::sdf::{DistanceField, March, Stride};
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Axis, Chart, Diagram, Figure, Light as Pen};
use std::f64::consts::TAU;

/// How many times as long the second takes: `1/7`.
pub fn ratio(formula: &Point, marched: &Point) -> String {
    let of = |p: &Point| p.time.map_or(f64::NAN, |t| t.mid);
    format!("1/{:.0}", of(marched) / of(formula))
}

pub fn speed(contest: &Contest, formula: &Point, rays: usize) -> Figure {
    let best = contest[3].1.points.last().cloned().unwrap_or_default();
    let mut chart = Chart::speed_accuracy("share of wrong pixels")
        .x(Axis::time("time per ray"))
        .title(&format!(
            "Marching gets every pixel right in {} times the time of the formulas",
            ratio(formula, &best).trim_start_matches("1/")
        ))
        .subtitle(&format!(
            "{rays} rays at six shapes; ε or τ from 10⁻¹ to 10⁻⁷ m; wrong: hit or miss, or off by 10⁻³ of the distance"
        ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    let exact = Series::new(vec![formula.clone()]);
    Figure::from(chart.line(Method::new("formulas, each shape by its own").styled(4), &exact)).caption(&format!(
        "Wrong pixels against time, for accuracies that grow from left to right. As printed, a hit is a small value, and a ray ends \
         after {MOST_STEPS} steps; the others look for a change of sign with no step shorter than τ.",
    ))
}

pub fn work(contest: &Contest, rays: usize) -> Figure {
    let at = |k: usize| contest[k].1.points.last().and_then(|p| p.work).unwrap_or(f64::NAN);
    let mut chart = Chart::work_accuracy("evaluations of the field per ray", "share of wrong pixels")
        .title(&format!(
            "Enhanced strides save {:.0} % of the evaluations and lose no pixel",
            100.0 * (1.0 - at(3) / at(1))
        ))
        .subtitle(&format!(
            "{rays} rays; ε or τ from 10⁻¹ to 10⁻⁷ m; steps taken back and the polishing of roots included"
        ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(&format!(
        "The same in counted work: {:.1} evaluations a ray by plain strides, {:.1} by over-relaxed and {:.1} by enhanced ones at the finest \
         tolerance. An over-relaxed step is 1.6 radii of the free ball until one fails, an enhanced one nearly what a flat surface would \
         allow; both are taken back where the balls do not touch.",
        at(1),
        at(2),
        at(3)
    ))
}

/// [E slide 79]: a ray past one solid to another, in the plane.
pub fn steps() -> Figure {
    let ball = Sphere::new(dvec3(0.2, -1.35, 0.0), 0.9).expect("a radius");
    let cube = Cuboid::new(dvec3(2.4, -0.9, -2.0), dvec3(4.2, 1.1, 2.0)).expect("a box");
    let field = Union(ball, cube);
    let ray = Ray::new(dvec3(-3.2, 0.55, 0.0), dvec3(1.0, -0.145, 0.0).normalize());
    let trail = |stride| March::through(&field).with_stride(stride).trail(&field, &ray, 0.0, 9.0);
    let [plain, _, enhanced] = Stride::ALL.map(trail);
    let at = |s: f64| ray.at(s).truncate();
    let circle = |c: DVec2, r: f64| -> Vec<DVec2> {
        (0..=120).map(|i| c + r * DVec2::from_angle(TAU * f64::from(i) / 120.0)).collect()
    };
    let corner = |x: f64, y: f64| dvec2(x, y);
    let mut diagram = Diagram::new(dvec2(-4.4, -2.3), dvec2(4.3, 2.3))
        .circle(ball.center().truncate(), ball.radius())
        .word("sphere")
        .polygon(&[corner(2.4, -0.9), corner(4.2, -0.9), corner(4.2, 1.1), corner(2.4, 1.1)])
        .word("box");
    for step in plain.iter().filter(|s| s.radius > 0.03) {
        diagram = diagram.thin(&circle(at(step.distance), step.radius));
    }
    let end = plain.last().map_or(0.0, |s| s.distance);
    diagram = diagram.ray(Pen::Incident, at(0.0), at(end)).point(at(0.0)).name("o");
    for step in &plain[1..] {
        diagram = diagram.spot(Pen::Incident, at(step.distance));
    }
    // The nearest surface of a step in the middle of the way: what the ball touches.
    if let Some(step) = plain.get(2) {
        let p = ray.at(step.distance);
        let foot = p - field.gradient(p).normalize_or(DVec3::X) * step.radius;
        diagram = diagram.dimension(p.truncate(), foot.truncate(), 0.0).name("|f(p)|");
    }
    Figure::from(
        diagram
            .title(&format!("Each step leaps to the edge of an empty ball: {} steps to the box", plain.len()))
            .subtitle(&format!(
                "section through a sphere and a box; plain strides, as traced; enhanced strides take {}",
                enhanced.len()
            ))
            .alt("A ray runs past a sphere to a box; circles along it touch the nearest surface and shrink beside the sphere."),
    )
    .caption("The steps of one ray, after E, slide 79 (Hart): the radius is the least of the distances to all objects.")
}
