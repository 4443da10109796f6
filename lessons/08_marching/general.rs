//! The general method: roots of F along a ray, a condition on them, and four ways to find the roots.

use super::contestant::is_wrong;
use glam::{DVec3, dvec3};
use lightbench::measure::Method;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::sdf::general::{bisection, brackets, first, newton};
use lightbench::sdf::{DistanceField, March};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table};
use lightbench_kit::lesson::{Lesson, Result};
use std::cell::Cell;

const PLACES: u32 = 64; // where the scan looks for a sign

pub fn show(lesson: &Lesson) -> Result {
    lesson.save("condition", condition())?;
    lesson.save("general_methods", methods(lesson))
}

/// A bowl: a sphere where y < 0.2.
fn condition() -> Figure {
    let ball = Sphere::new(DVec3::ZERO, 1.0).expect("a radius");
    let ray = Ray::new(dvec3(-1.9, 1.25, 0.0), dvec3(1.0, -0.6, 0.0).normalize());
    let implicit = |t: f64| ray.at(t).length_squared() - 1.0;
    let roots: Vec<f64> = ball.roots(&ray).map_or(Vec::new(), |(a, b)| vec![a, b]);
    let met = first(roots.iter().copied(), |t| ray.at(t).y < 0.2).unwrap_or(f64::NAN);
    let along = |f: &dyn Fn(f64) -> f64| {
        (0..=240).map(|i| f64::from(i) * 4.2 / 240.0).map(|t| (t, f(t))).collect::<Vec<_>>()
    };
    let chart = Chart::new(Axis::linear("distance along the ray t, m"), Axis::linear("field"))
        .title(&format!(
            "Of the roots {:.2} and {:.2} the condition leaves the second: the ray falls into the bowl",
            roots[0], roots[1]
        ))
        .subtitle("a unit sphere cut open above y = 0.2: F(o + tv) = 0 and C(p): y < 0.2")
        .function(Method::new("F = p·p − 1").styled(2), &along(&implicit))
        .function(Method::new("signed distance").styled(0), &along(&|t| ball.distance(ray.at(t))))
        .dots(Method::new("root with C").styled(1), &[(met, 0.0)])
        .dots(Method::new("root without C").styled(4), &[(roots[0], 0.0)])
        .guide(Guide::level(0.0, ""));
    Figure::from(chart).caption(
        "The general method of E: the roots of the implicit equation along the ray, of which the least that meets the condition is the hit. \
         Both fields have the same roots; the signed distance also says how far the surface is.",
    )
}

/// A ray at the torus, by turns through it and grazing it.
fn ray(torus: &Torus, seed: u64, i: u32) -> Ray {
    let mut sampler = Sampler::new(seed, 77, i);
    let p = torus.point_at(0, sampler.next_2d());
    let n = torus.gradient(p).normalize_or(DVec3::X);
    let way = uniform_sphere(sampler.next_2d());
    let tangent = (way - n * n.dot(way)).normalize_or(DVec3::Z);
    let depth = 10f64.powf(-6.0 * sampler.next_1d());
    let (through, direction) = if i.is_multiple_of(2) { (p, way) } else { (p - n * (0.2 * depth), tangent) };
    Ray::new(through - direction * 4.0, direction)
}

fn methods(lesson: &Lesson) -> Figure {
    let torus = Torus::new(0.8, 0.25).expect("a ring");
    let count = lesson.pick([64, 1000, 4000, 20_000]);
    let rays: Vec<Ray> = (0..count).map(|i| ray(&torus, lesson.seed(), i)).collect();
    let mut table =
        Table::new(&["Method", "evaluations per ray", "misses", "wrong root", "false hits", "of"])
            .title("Without a bound on the field, roots are lost in pairs; the march loses none")
            .subtitle("torus (0.8, 0.25) m; every second ray dives 0.2 m to 0.2 µm deep along the surface");
    let evaluations = Cell::new(0u64);
    let f = |r: &Ray, t: f64| {
        evaluations.set(evaluations.get() + 1);
        torus.distance(r.at(t))
    };
    let slope = |r: &Ray, t: f64| (f(r, t), torus.gradient(r.at(t)).dot(r.direction));
    type Way<'a> = (&'a str, Box<dyn Fn(&Ray) -> Option<f64> + 'a>);
    let ways: [Way; 4] = [
        (
            "signs at 64 places, bisected",
            Box::new(|r| {
                let roots: Vec<f64> =
                    brackets(|t| f(r, t), 0.0, 8.0, PLACES).map(|b| bisection(|t| f(r, t), b)).collect();
                first(roots, |_| true)
            }),
        ),
        ("Newton from the origin", Box::new(|r| newton(|t| slope(r, t), 0.0, 1e-9, 60).filter(|t| *t > 0.0))),
        ("direct: the quartic's formula", Box::new(|r| torus.nearest(r, 0.0, f64::INFINITY).map(|c| c.t))),
        (
            "marching, enhanced",
            Box::new(|r| {
                let done = March::through(&torus).first(&torus, r, 0.0, 8.0);
                evaluations.set(evaluations.get() + u64::from(done.steps + done.polish));
                done.distance
            }),
        ),
    ];
    for (name, way) in &ways {
        evaluations.set(0);
        let (mut missed, mut other, mut invented) = (0, 0, 0);
        for r in &rays {
            let truth = torus.nearest(r, 0.0, f64::INFINITY).map(|c| c.t);
            match (way(r), truth) {
                (None, Some(_)) => missed += 1,
                (Some(_), None) => invented += 1,
                (found, truth) => other += u64::from(is_wrong(found, truth)),
            }
        }
        let per_ray = evaluations.get() as f64 / f64::from(count);
        let cells = [missed.to_string(), other.to_string(), invented.to_string(), count.to_string()];
        let work = if per_ray > 0.0 { format!("{per_ray:.1}") } else { "–".to_string() };
        table = table.row(&[name, &work, &cells[0], &cells[1], &cells[2], &cells[3]]);
    }
    Figure::from(table.marked()).caption(
        "Direct and iterative ways to the least root, after E, slide 77. Newton settles on whichever root it happens on or none; the scan \
         cannot see two roots between two places; the march knows how far it may leap. Truth: the certified quartic.",
    )
}
