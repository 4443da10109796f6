//! Diagrams of lesson 06: what a cylinder is made of, and where its normals come from.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::ray::{Crossing, Ray};
use lightbench::shape::Shape;
use lightbench::shape::cone::{Cone, Ends};
use lightbench::shape::cylinder::Cylinder;
use lightbench_kit::figure::{Diagram, Figure, Light, Space};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::TAU;

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("two_points", two_points())?;
    lesson.save("names", names())?;
    lesson.save("normal", normal())?;
    lesson.save("base_axis_height", base_axis_height())?;
    lesson.save("side_normal", side_normal())?;
    lesson.save("unit_bodies", unit_bodies())
}

const STEPS: usize = 120;

/// A body with round ends: its outline, the end that shows itself, and the hidden half of the other dashed.
fn body(mut d: Diagram, space: &Space, [p0, p1]: [DVec3; 2], [r0, r1]: [f64; 2]) -> Diagram {
    let axis = (p1 - p0).normalize_or(DVec3::Y);
    let x = axis.any_orthonormal_vector();
    let y = axis.cross(x);
    let ring = |p: DVec3, r: f64| -> Vec<DVec2> {
        let on = |k: usize| DVec2::from_angle(TAU * k as f64 / STEPS as f64) * r;
        (0..STEPS).map(|k| space.at(p + x * on(k).x + y * on(k).y)).collect()
    };
    let rings = [ring(p0, r0), ring(p1, r1)];
    let outline = hull(rings.concat());
    d = d.polygon(&outline);
    // Counter-clockwise on paper: the end at p1 shows its outside; the one at p0 then does not.
    let area: f64 = (0..STEPS).map(|k| rings[1][k].perp_dot(rings[1][(k + 1) % STEPS])).sum::<f64>()
        + (0..STEPS).map(|k| rings[0][k].perp_dot(rings[0][(k + 1) % STEPS])).sum::<f64>();
    let (seen, other) = if area > 0.0 { (1, 0) } else { (0, 1) };
    if [r0, r1][other] > 0.0 {
        let inside = |k: usize| !outline.contains(&rings[other][k % STEPS]);
        let start = (0..STEPS).find(|k| inside(*k) && !inside(k + STEPS - 1)).unwrap_or(0);
        let chain: Vec<DVec2> =
            (start..start + STEPS).take_while(|k| inside(*k)).map(|k| rings[other][k % STEPS]).collect();
        d = d.hidden(&chain);
    }
    if [r0, r1][seen] > 0.0 { d.polygon(&rings[seen]) } else { d }
}

/// The convex hull, counter-clockwise (Andrew's monotone chain).
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..] {
                if (b - a).perp_dot(p - b) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let lower = half(&mut points.clone().into_iter());
    [lower, half(&mut points.into_iter().rev())].concat()
}

fn told(d: Diagram, caption: &str) -> Figure {
    Figure::from(d).caption(caption)
}

const VIEW: (f64, f64) = (24.0, 20.0); // degrees: yaw, pitch
const P: [DVec3; 2] = [dvec3(-1.6, -0.75, 0.0), dvec3(1.7, 0.75, 0.0)];
const R: f64 = 0.8;

/// B, figure 6.6.
fn two_points() -> Figure {
    let space = Space::axonometric(VIEW.0, VIEW.1);
    let axis = (P[1] - P[0]).normalize();
    let [a, b] = P.map(|p| space.at(p));
    let d = body(Diagram::fitted(), &space, P, [R, R])
        .hidden(&[a, b])
        .path(Light::Other, &[b, space.at(P[1] + axis.cross(DVec3::Z).normalize() * -R)])
        .name("r")
        .point(a).name("p_{1}")
        .point(b).name("p_{2}")
        .title("Two points and a radius: seven numbers for a cylinder of finite length")
        .subtitle(&format!("height |p₂ − p₁| = {:.2}, radius {R}: the cylinder ends where its points are", P[0].distance(P[1])))
        .alt("A capped cylinder lying aslant; the centres p1 and p2 of its ends are joined by a dashed axis, the radius r is drawn on the near cap.");
    told(
        d,
        "A cylinder by two points and a radius (after B, figure 6.6). D writes base, axis and height instead.",
    )
}

/// B, figure 6.7: the names in the equation.
fn names() -> Figure {
    let space = Space::axonometric(VIEW.0, VIEW.1);
    let axis = (P[1] - P[0]).normalize();
    let ray = Ray::new(dvec3(-2.2, 1.55, 2.4), (dvec3(0.15, 0.45, 0.0) - dvec3(-2.2, 1.55, 2.4)).normalize());
    let cylinder = Cylinder::new(P[0], P[1], R).expect("a cylinder");
    let hit = cylinder.nearest(&ray, 0.0, f64::INFINITY);
    let q = hit.map_or(DVec3::ZERO, |c| ray.at(c.t));
    let foot = P[0] + axis * (q - P[0]).dot(axis);
    let d = body(Diagram::fitted(), &space, P, [R, R])
        .hidden(&[space.at(P[0]), space.at(P[1] + axis * 0.7)])
        .ray(Light::Incident, space.at(ray.origin), space.at(q)).name("p + v t")
        .ray(Light::Normal, space.at(P[0]), space.at(P[0] + axis)).name("v_{a}")
        .path(Light::Other, &[space.at(foot), space.at(q)]).name("r")
        .right_angle(space.at(foot), space.at(foot - axis) - space.at(foot), space.at(q) - space.at(foot))
        .point(space.at(P[0])).name("p_{a}")
        .point(space.at(ray.origin)).name("p")
        .spot(Light::Incident, space.at(q)).name("q")
        .point(space.at(foot))
        .title(&format!("q lies on the side if it is r = {} away from the axis: |q − p_{{a}} − (v_{{a}}·(q − p_{{a}})) v_{{a}}| = r", R))
        .subtitle(&format!("here v_{{a}}·(q − p_{{a}}) = {:.3} of the height {:.3}, and t = {:.3}", (q - P[0]).dot(axis), P[0].distance(P[1]), hit.map_or(f64::NAN, |c| c.t)))
        .alt("A cylinder with its axis from p_a along the unit vector v_a; a ray from p meets the side at q; the perpendicular from q to the axis has length r.");
    told(
        d,
        "The names in the cylinder's equation (after B, figure 6.7). What lies along the axis is taken off q − p_a; the rest has length r.",
    )
}

/// B, figure 7.13: three parts, three normals, each as the library answers.
fn normal() -> Figure {
    let space = Space::axonometric(VIEW.0, VIEW.1);
    let cylinder = Cylinder::new(P[0], P[1], R).expect("a cylinder");
    let axis = (P[1] - P[0]).normalize();
    let across = axis.cross(DVec3::Z).normalize() * -1.0;
    let aims = [
        (P[0] + axis * 1.9 + across * 3.0, -across),
        (P[1] + axis * 2.0 + across * 0.25, -axis),
        (P[0] - axis * 2.0 + across * 0.1, axis),
    ];
    let mut d = body(Diagram::fitted(), &space, P, [R, R]).hidden(&[space.at(P[0]), space.at(P[1])]);
    let names = ["side: q − p_{a}, less its part along v_{a}", "far cap: v_{a}", "near cap: −v_{a}"];
    for ((origin, direction), name) in aims.into_iter().zip(names) {
        let ray = Ray::new(origin, direction);
        let Some(hit) = cylinder.nearest(&ray, 0.0, f64::INFINITY).map(|c: Crossing| cylinder.hit(&ray, &c))
        else {
            continue;
        };
        d = d
            .ray(Light::Reflected, space.at(hit.point), space.at(hit.point + hit.ng * 0.9))
            .word(name)
            .spot(Light::Incident, space.at(hit.point));
    }
    let d = d
        .point(space.at(P[0])).name("p_{a}")
        .title("One normal fans out around the side, two stand on the caps")
        .subtitle("arrows are the library's answers at three hits; all point outwards")
        .alt("A capped cylinder with three arrows: one square to the side, one along the axis out of each cap.");
    told(
        d,
        "Normals of a cylinder (after B, figure 7.13). B tells the caps apart by |q − p₁| < r, which also takes side points near \
             the rim of a flat cylinder for the cap; a hit that knows its face needs no such test.",
    )
}

/// D, figure 15.
fn base_axis_height() -> Figure {
    let space = Space::axonometric(VIEW.0, VIEW.1);
    let (base, height, radius) = (DVec3::ZERO, 2.2, 0.9);
    let top = base + DVec3::Y * height;
    let (rim, out) = (dvec3(1.0, 0.0, 0.0) * radius, dvec3(-1.0, 0.0, 0.0) * radius);
    let d = body(Diagram::fitted(), &space, [base, top], [radius, radius])
        .hidden(&[space.at(base), space.at(top)])
        .ray(Light::Incident, space.at(top), space.at(top + DVec3::Y * 0.85)).name_end("Axis")
        .path(Light::Other, &[space.at(top), space.at(top + rim)]).name("Radius")
        .dimension(space.at(base + out), space.at(top + out), 42.0).name("Height")
        .point(space.at(base)).name("Base")
        .point(space.at(top))
        .title("Base, Axis, Height, Radius: D's eight numbers for the same body")
        .subtitle("the axis may have any length; the second point is Base + Height · Axis/|Axis|")
        .alt("An upright capped cylinder: a point Base in the middle of its bottom, an arrow Axis out of the top, its height and radius.");
    told(d, "The cylinder's parameters in D (after D, figure 15), with D's default axis (0, 1, 0).")
}

/// D, figure 25: the side's normal in a section square to the axis, and along it.
fn side_normal() -> Figure {
    let (r, angle) = (1.0, 0.62f64);
    let e = DVec2::from_angle(angle);
    let (c, right) = (DVec2::ZERO, dvec2(3.6, -0.9));
    let (height, h) = (1.9, 1.15);
    let wall = right + dvec2(r, h);
    let d = Diagram::new(dvec2(-1.7, -1.55), dvec2(6.6, 1.85))
        .circle(c, r)
        .thin(&[c, dvec2(1.5, 0.0)])
        .path(Light::Other, &[c, e * r]).name("r")
        .ray(Light::Reflected, e * r, e * (r + 0.75)).name_end("N")
        .angle_at(c, DVec2::X, e, 60.0).name("φ")
        .spot(Light::Incident, e * r).name("P")
        .point(c).name("C")
        .polygon(&[right + dvec2(-r, 0.0), right + dvec2(r, 0.0), right + dvec2(r, height), right + dvec2(-r, height)])
        .ray(Light::Incident, right + dvec2(0.0, -0.25), right + dvec2(0.0, height + 0.45)).name_end("Axis")
        .path(Light::Other, &[right, wall]).name("P − Base")
        .dimension(right, right + dvec2(0.0, h), 30.0).name("s")
        .thin(&[right + dvec2(0.0, h), wall])
        .right_angle(right + dvec2(0.0, h), dvec2(0.0, -1.0), DVec2::X)
        .ray(Light::Reflected, wall, wall + dvec2(0.75, 0.0)).name_end("N")
        .point(right).name("Base")
        .point(right + dvec2(0.0, h)).name("C")
        .spot(Light::Incident, wall).name("P")
        .note(dvec2(0.0, -1.35), "seen along the axis")
        .note(right + dvec2(0.0, -0.45), "seen from the side")
        .title("N = (P − C)/r, where C = Base + s Axis is the foot of P on the axis: no angle is needed")
        .subtitle(&format!("s = (P − Base)·Axis; N = (cos φ, sin φ) = ({:.3}, {:.3}) at φ = {:.1}°", e.x, e.y, angle.to_degrees()))
        .alt("Left, a circle seen along the axis with the radius from C to P and the normal N prolonging it. Right, the cylinder from the side: P minus Base is split into s along the axis and the normal across it.");
    told(d, "The normal of a cylinder's side (after D, figure 25), in the two views that explain it.")
}

/// E, slide 85: problem 5.3.
fn unit_bodies() -> Figure {
    let space = Space::axonometric(22.0, 18.0);
    let shift = dvec3(3.1, 0.0, 0.0);
    let tube = Cylinder::new(DVec3::ZERO, DVec3::Y, 1.0).expect("a cylinder").with_ends(Ends::Open);
    let cone = Cone::new(DVec3::ZERO, DVec3::Y, 1.0, 0.0).expect("a cone").with_ends(Ends::Open);
    let ray = Ray::new(dvec3(-1.75, 1.05, 0.9), dvec3(1.75, -0.62, -0.85).normalize());
    let mut d = Diagram::fitted();
    let shapes: [(&dyn Shape, DVec3, f64); 2] = [(&tube, DVec3::ZERO, 1.0), (&cone, shift, 0.0)];
    let mut found = Vec::new();
    for (shape, at, top) in shapes {
        d = body(d, &space, [at, at + DVec3::Y], [1.0, top]);
        let mut crossings = Vec::new();
        shape.crossings(&ray, &mut crossings);
        let ts: Vec<f64> = crossings.iter().map(|c| c.t).collect();
        let p = |t: f64| space.at(ray.at(t) + at);
        if let [first, .., last] = ts[..] {
            d = d.ray(Light::Incident, p(0.0), p(first)).hidden(&[p(first), p(last)]).ray(
                Light::Shadow,
                p(last),
                p(last + 0.7),
            );
            d = d.spot(Light::Incident, p(first)).name("t_{0}").point(p(last)).name("t_{1}");
        }
        found.push(ts);
        d = d
            .point(space.at(at))
            .name("o")
            .ray(Light::Normal, space.at(at + DVec3::Y * top), space.at(at + DVec3::Y * 1.5))
            .name_end("z");
    }
    let told_ts = |ts: &[f64]| ts.iter().map(|t| format!("{t:.3}")).collect::<Vec<_>>().join(", ");
    let d = d
        .note(space.at(dvec3(0.0, -0.75, 0.0)), "x² + y² − 1 = 0")
        .note(space.at(shift - DVec3::Y * 0.75), "x² + y² − (1 − z)² = 0")
        .title("Two scalar fields and a height: the roots with 0 ≤ z ≤ 1 are the meetings")
        .subtitle(&format!("the same ray meets the cylinder at t = {}, the cone at t = {}", told_ts(&found[0]), told_ts(&found[1])))
        .alt("A cylinder and a cone of height 1 and radius 1, each met twice by the same ray; under each stands its scalar field.");
    told(
        d,
        "Problem 5.3 (after E, slide 85): cylinder and cone of unit size, without caps. The field's zeros reach beyond the \
             ends; the height decides.",
    )
}
