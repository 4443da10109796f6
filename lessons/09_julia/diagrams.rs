//! A ray that approaches the set by the printed estimate, and one that is thrown past it.

use super::{MOST, PLAIN, VIEWED};
use glam::{DVec2, DVec3, dvec2};
use lightbench::ray::Ray;
use lightbench::sdf::julia::{Julia, JuliaMethod, Look, March};
use lightbench_kit::figure::{Diagram, Figure, Light, short};
use lightbench_kit::lesson::{LessonError, Result};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Cells along the edge of the square in which the section's outline is sought.
const FINE: usize = 160;

fn julia(tolerance: f64) -> Result<Julia> {
    let march = March { tolerance, most: MOST };
    let julia = Julia::new(VIEWED, PLAIN - 3, 4.0, 0.0).map_err(|e| LessonError(e.to_string()))?;
    Ok(julia.with_method(JuliaMethod::AsPrinted(march)))
}

/// The outlines of the section z = 0: where ln |q_N| crosses ln B between the corners of cells, joined.
fn outlines(julia: &Julia) -> Vec<Vec<DVec2>> {
    let half = julia.radius() * 1.02;
    let at = |i: usize, j: usize| (dvec2(i as f64, j as f64) / FINE as f64 * 2.0 - 1.0) * half;
    let value = |p: DVec2| match julia.level(p.extend(0.0)) {
        Some((size, _)) => (size / julia.bailout()).ln().min(1.0),
        None => 1.0,
    };
    let values: Vec<Vec<f64>> = (0..=FINE).map(|i| (0..=FINE).map(|j| value(at(i, j))).collect()).collect();
    // An edge of a cell is named by its lower corner and its direction; crossing it, the outline keeps the inside on its left.
    type Edge = (usize, usize, bool);
    let mut next: HashMap<Edge, (DVec2, Edge)> = HashMap::new();
    for i in 0..FINE {
        for j in 0..FINE {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            let edges: [Edge; 4] = [(i, j, false), (i + 1, j, true), (i, j + 1, false), (i, j, true)];
            let v = corners.map(|(i, j)| values[i][j]);
            let crossing = |k: usize| {
                let (a, b) = (corners[k], corners[(k + 1) % 4]);
                let s = v[k] / (v[k] - v[(k + 1) % 4]);
                at(a.0, a.1).lerp(at(b.0, b.1), s)
            };
            // Walking round the cell counter-clockwise: where the inside begins, the outline leaves; where it ends, it enters.
            let begins: Vec<usize> = (0..4).filter(|&k| v[k] > 0.0 && v[(k + 1) % 4] <= 0.0).collect();
            let ends =
                |from: usize| (1..4).map(|d| (from + d) % 4).find(|&k| v[k] <= 0.0 && v[(k + 1) % 4] > 0.0);
            for begin in begins {
                if let Some(end) = ends(begin) {
                    next.insert(edges[end], (crossing(end), edges[begin]));
                }
            }
        }
    }
    let mut loops = Vec::new();
    while let Some(&first) = next.keys().min() {
        let (mut edge, mut points) = (first, Vec::new());
        while let Some((p, to)) = next.remove(&edge) {
            points.push(p);
            edge = to;
        }
        if points.len() > 8 {
            loops.push(points);
        }
    }
    loops
}

/// The section, the places that the march looks at, and the circle of each estimate.
fn walk(julia: &Julia, ray: &Ray, most: usize) -> (Diagram, Vec<Look>) {
    let mut looks = Vec::new();
    julia.walk_by_estimate(ray, |look| looks.push(look));
    let mut diagram = Diagram::fitted();
    for outline in outlines(julia) {
        diagram = diagram.polygon(&outline);
    }
    let flat = |along: f64| ray.at(along).truncate();
    for look in looks.iter().take(most).filter(|look| look.distance > 0.01) {
        let circle: Vec<DVec2> = (0..=72)
            .map(|i| flat(look.along) + look.distance * DVec2::from_angle(TAU * f64::from(i) / 72.0))
            .collect();
        diagram = diagram.thin(&circle);
    }
    (diagram, looks)
}

/// [A ill. 60].
pub fn approach() -> Result<Figure> {
    let julia = julia(1e-3)?;
    let origin = DVec3::new(-0.2, 1.9, 0.0);
    let ray = Ray::new(origin, (DVec3::new(1.0, -0.3, 0.0) - origin).normalize());
    let (mut diagram, looks) = walk(&julia, &ray, 12);
    let flat = |along: f64| ray.at(along).truncate();
    let end = looks.last().map_or(0.0, |look| look.along);
    diagram = diagram.ray(Light::Incident, flat(0.0), flat(end)).point(flat(0.0)).name("o");
    for (i, look) in looks.iter().enumerate().skip(1).take(12) {
        let light = if look.distance == 0.0 { Light::Reflected } else { Light::Transmitted };
        diagram = diagram.spot(light, flat(look.along));
        if i <= 4 {
            diagram = diagram.name(&format!("{i}"));
        }
    }
    let inside = looks.iter().filter(|look| look.distance == 0.0).count();
    let diagram = diagram
        .title("Each step goes as far as the surface seems away")
        .subtitle(&format!(
            "section z = 0 after {} steps; the march looks at {} places, {inside} of them inside, and stops within 10⁻³",
            PLAIN - 3,
            looks.len()
        ))
        .alt("A ray in steps of shrinking circles that approaches a lobed body, until it touches it.");
    Ok(Figure::from(diagram).caption(
        "Steps of a ray that approaches the fractal, each as long as the estimate at the place before (after A, illustration 60); the \
         circles have the estimates as radii. Traced by the printed method.",
    ))
}

/// The same march from farther away.
pub fn thrown_past() -> Result<Figure> {
    let julia = julia(1e-3)?;
    let ray = Ray::new(DVec3::new(-11.0, 0.5, 0.0), DVec3::X);
    let (mut diagram, looks) = walk(&julia, &ray, 1);
    let flat = |along: f64| ray.at(along).truncate();
    let first = looks.first().map_or(0.0, |look| look.distance);
    diagram = diagram
        .ray(Light::Incident, flat(0.0), flat(first))
        .point(flat(0.0))
        .name("o")
        .spot(Light::Reflected, flat(first))
        .name("1");
    let diagram = diagram
        .title("From far away the first step passes the whole set")
        .subtitle(&format!(
            "the estimate at a distance of {} is ½ · {} · ln {} = {}",
            short(ray.origin.length()),
            short(ray.origin.length()),
            short(ray.origin.length()),
            short(first)
        ))
        .alt("A ray whose first step, a large circle about its origin, ends beyond the body: the body lies inside the circle.");
    Ok(Figure::from(diagram).caption("The printed march from 11 units away: there the estimate is longer than the way to the set and through it."))
}
