//! Diagrams: normals, lamps and angles.

use glam::{DVec2, dvec2};
use lightbench_kit::figure::{Diagram, Figure, Light};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::FRAC_PI_2;

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("brightness", brightness())?;
    lesson.save("sphere_normals", sphere_normals())?;
    lesson.save("eye_lamp", eye_lamp())?;
    lesson.save("balance", balance())?;
    lesson.save("orientation", orientation())?;
    lesson.save("incidence", incidence())?;
    lesson.save("near_far", near_far())?;
    lesson.save("vectors", vectors())
}

/// A direction at an angle [degrees] from the vertical, to the right.
fn at(degrees: f64) -> DVec2 {
    dvec2(degrees.to_radians().sin(), degrees.to_radians().cos())
}

/// B 7.6: three orientations under one direction of light.
fn brightness() -> Figure {
    let mut diagram = Diagram::new(dvec2(-0.8, -0.95), dvec2(6.0, 1.5))
        .title("A surface is as bright as it faces the light: by N · L")
        .subtitle("the same light from straight above, three orientations of a matt surface");
    for (i, tilt) in [0.0, 40.0, 75.0].into_iter().enumerate() {
        let p = dvec2(2.4 * i as f64, 0.0);
        let n = at(tilt);
        let along = n.perp();
        diagram = diagram
            .polygon(&[
                p - along * 0.6,
                p + along * 0.6,
                p + along * 0.6 - n * 0.12,
                p - along * 0.6 - n * 0.12,
            ])
            .ray(Light::Incident, p, p + DVec2::Y * 1.15)
            .name_end("L")
            .normal(p, n * 0.95)
            .name_end("N");
        if tilt > 0.0 {
            diagram = diagram.angle_at(p, DVec2::Y, n, 110.0).name("θ");
        }
        let sum = format!("N · L = cos {tilt}° = {:.3}", DVec2::Y.dot(n));
        diagram = diagram.point(p).note(p + dvec2(0.0, -0.8), &sum);
    }
    Figure::from(diagram.alt("Three short surfaces under light from above: level, tilted by 40° and by 75°. Each has its normal N and the direction to the light L; the cosine of the angle between them is 1, 0.766 and 0.259."))
        .caption("What a point sends back depends on its normal N and the direction L to the light (B, illustration 7.6).")
}

/// B 7.12: the normals of a sphere and what they meet.
fn sphere_normals() -> Figure {
    let to_light = at(35.0);
    let mut diagram = Diagram::new(dvec2(-2.1, -1.6), dvec2(2.1, 1.75))
        .circle(DVec2::ZERO, 1.0)
        .title("On a sphere the normal is the point less the centre, over the radius; its angle to the light does the rest")
        .subtitle("parallel light; at each normal N the share cos θ of the light that a facing surface would send back");
    for k in 0..6 {
        let side = to_light.perp() * (0.9 - 0.36 * f64::from(k));
        let p = side + to_light * (1.0 - side.length_squared()).sqrt();
        let from = side + to_light * 1.85;
        if from.y < 1.72 && from.x < 2.05 {
            diagram = diagram.ray(Light::Incident, from, p);
        }
    }
    for k in 0..12 {
        let degrees = 35.0 + 30.0 * f64::from(k);
        let n = at(degrees);
        let cos = n.dot(to_light);
        diagram = diagram
            .normal(n, n * 0.3)
            .note(n * 1.47, &format!("{:.2}", if cos > 1.0e-9 { cos } else { 0.0 }));
    }
    let p = at(-25.0);
    let diagram = diagram
        .hidden(&[DVec2::ZERO, p])
        .word("radius")
        .point(DVec2::ZERO)
        .name("C")
        .normal(p, p * 0.3)
        .name("N = (P − C)/r")
        .point(p)
        .name("P");
    Figure::from(diagram.alt("A circle with normals every 30°. Light comes from the upper right; the numbers at the normals are 1.00 where they point to the light, 0.87 and 0.50 further round, and 0.00 on the far half."))
        .caption("Normals and shading on a sphere (B, illustration 7.12). Turned away from the light there is none: the cosine would be negative, and counts as 0.")
}

/// C fig. 9: an eye and its lamp.
fn eye_lamp() -> Figure {
    let (eye, aside) = (dvec2(-2.6, 0.35), dvec2(-1.0, 2.3));
    let (center, r) = (dvec2(0.0, 0.0), 0.62);
    let wall = 2.3;
    let tangents = |from: DVec2| {
        let way = center - from;
        let half = (r / way.length()).asin();
        [half, -half].map(|a| {
            let direction = DVec2::from_angle(a).rotate(way.normalize());
            let touch = from + direction * (way.length() * half.cos());
            (touch, from + direction * ((wall - from.x) / direction.x))
        })
    };
    let [(a, high), (b, low)] = tangents(eye);
    let mut diagram = Diagram::new(dvec2(-3.1, -2.3), dvec2(2.85, 2.75))
        .region(Light::Shadow, &[a, high, low, b])
        .half_plane(dvec2(wall, 0.0), dvec2(-1.0, 0.0))
        .circle(center, r)
        .ray(Light::Incident, eye, high)
        .ray(Light::Incident, eye, low)
        .note(dvec2(1.62, 0.42), "hidden and unlit")
        .eye(eye + dvec2(-0.12, 0.0), dvec2(1.0, -0.1))
        .word("eye")
        .lamp(eye + dvec2(-0.1, 0.33))
        .word("its lamp");
    let visible = dvec2(wall, low.y - 0.42);
    diagram = diagram
        .lamp(aside)
        .word("a lamp aside")
        .ray(Light::Shadow, visible, visible + (aside - visible) * 0.985)
        .word("blocked")
        .ray(Light::Reflected, visible, eye + (visible - eye) * 0.06)
        .word("seen")
        .point(visible)
        .name("p");
    Figure::from(
        diagram
            .title("What the eye sees, a lamp in its place lights: shadows fall where nobody looks")
            .subtitle("the shaded region is hidden from the eye by the ball, and from the eye's lamp; p is seen, but in the shadow of a lamp aside")
            .alt("An eye with a lamp in its place looks at a ball before a wall. Two rays touch the ball and bound a region behind it which neither sees nor is lit. A second lamp, above, cannot reach a visible point p of the wall because the ball is in the way."),
    )
    .caption("The simplest models put the lamp at the eye (C, figure 9), and need no shadow rays. With a lamp aside p is visible and dark.")
}

/// C fig. 21: where incident light goes.
fn balance() -> Figure {
    let o = DVec2::ZERO;
    let mut diagram = Diagram::new(dvec2(-2.3, -1.45), dvec2(2.3, 1.75))
        .polygon(&[dvec2(-2.0, 0.0), dvec2(2.0, 0.0), dvec2(2.0, -0.7), dvec2(-2.0, -0.7)])
        .ray(Light::Incident, at(-48.0) * 2.0, o)
        .word("incident: 1")
        .ray(Light::Reflected, o, at(48.0) * 1.75)
        .word("reflected like a mirror")
        .path(Light::Transmitted, &[o, dvec2(0.42, -0.7)])
        .ray(Light::Transmitted, dvec2(0.42, -0.7), dvec2(0.42, -0.7) + at(132.0) * 0.85)
        .word("transmitted");
    for degrees in [-75.0, -22.0, 0.0, 22.0, 75.0] {
        diagram = diagram.ray(Light::Other, o, at(degrees) * if degrees == 0.0 { 0.95 } else { 0.8 });
        if degrees == 0.0 {
            diagram = diagram.word("scattered");
        }
    }
    let walk = [o, dvec2(-0.22, -0.17), dvec2(-0.12, -0.4), dvec2(-0.42, -0.3), dvec2(-0.55, -0.52)];
    let diagram = diagram
        .path(Light::Normal, &walk)
        .spot(Light::Normal, walk[4])
        .word("absorbed")
        .point(o)
        .title("All light that falls on a surface goes somewhere: reflected + scattered + absorbed + transmitted = incident")
        .subtitle("C's simple model follows the scattered part alone: opaque (6), without highlights (8); what is absorbed is 1 − K")
        .alt("A ray falls on a slab. Part leaves like a mirror's ray, part is scattered in all directions above, part wanders inside until it is absorbed, part leaves the slab below.");
    Figure::from(diagram).caption("The balance of incident light (C, figure 21). No share is negative, and together they are 1: a model that sends back more has made light.")
}

/// C fig. 22: the same beam on a level and on a tilted surface.
fn orientation() -> Figure {
    let mut diagram = Diagram::new(dvec2(-1.1, -1.3), dvec2(4.6, 1.95))
        .title("Tilted by 60°, a surface spreads the same light over twice the area")
        .subtitle("two equal beams of parallel light of width b; the lit length is b / cos θ, the irradiance E cos θ");
    for (x, tilt) in [(0.0, 0.0), (3.2, 60.0)] {
        let (p, n) = (dvec2(x, 0.0), at(-tilt));
        let along = -n.perp();
        let reach = 0.5 / n.y;
        let hit = |offset: f64| p + along * (offset / along.x);
        diagram = diagram
            .region(Light::Incident, &[hit(-0.5), dvec2(x - 0.5, 1.6), dvec2(x + 0.5, 1.6), hit(0.5)])
            .polygon(&[
                p - along * (reach + 0.25),
                p + along * (reach + 0.25),
                p + along * (reach + 0.25) - n * 0.12,
                p - along * (reach + 0.25) - n * 0.12,
            ]);
        for k in 0..5 {
            let offset = -0.5 + 0.25 * f64::from(k);
            diagram = diagram.ray(Light::Incident, dvec2(x + offset, 1.6), hit(offset));
        }
        diagram = diagram
            .dimension(dvec2(x - 0.5, 1.62), dvec2(x + 0.5, 1.62), 12.0)
            .name("b")
            .normal(p, n * 0.8)
            .name_end("N");
        if tilt > 0.0 {
            diagram = diagram.angle_at(p, DVec2::Y, n, 95.0).name("θ");
            diagram = diagram.dimension(hit(0.5), hit(-0.5), 34.0).name("2 b");
        } else {
            diagram = diagram.dimension(hit(0.5), hit(-0.5), 34.0).name("b");
        }
    }
    Figure::from(diagram.alt("Left a level surface under a beam of width b, lit over the length b. Right a surface tilted by 60° under an equal beam, lit over the length 2 b."))
        .caption("Orientation and illumination (C, figure 22): the reason for Lambert's cosine.")
}

/// C fig. 23: the angle of incidence.
fn incidence() -> Figure {
    let (o, d) = (DVec2::ZERO, at(-38.0));
    let diagram = Diagram::new(dvec2(-1.45, -0.2), dvec2(1.45, 1.3))
        .ground(o, DVec2::Y)
        .ray(Light::Incident, d * 1.35, o)
        .word("incident light")
        .ray(Light::Normal, o, DVec2::Y * 1.1)
        .name_end("normal")
        .right_angle(o, DVec2::X, DVec2::Y)
        .angle_at(o, DVec2::Y, d, 150.0)
        .name("θ")
        .point(o)
        .title("The angle of incidence is measured from the normal, not from the surface")
        .subtitle("drawn: θ = 38°; grazing light has 90°, light from above 0°")
        .alt(
            "Light falls on a level surface; the angle θ is marked between its path and the upright normal.",
        );
    Figure::from(diagram).caption("The angle of incidence (C, figure 23).")
}

/// C fig. 24: a near and a far lamp.
fn near_far() -> Figure {
    let mut diagram = Diagram::new(dvec2(-1.35, -0.75), dvec2(4.85, 1.5))
        .title("Under a near lamp the angle of incidence changes from place to place; under a far one it does not")
        .subtitle("(a) a lamp at 0.8 m over a surface of 2 m; (b) the same lamp so far away that the rays are parallel");
    let lamp = dvec2(0.0, 0.8);
    for x in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let p = dvec2(x, 0.0);
        diagram = diagram.ray(Light::Incident, lamp, p).normal(p, DVec2::Y * 0.32);
        diagram =
            diagram.note(dvec2(x, -0.3), &format!("{:.0}°", (f64::abs(x) / lamp.y).atan().to_degrees()));
        let q = dvec2(3.2 + x, 0.0);
        let way = at(20.0);
        diagram = diagram.ray(Light::Incident, q + way * 1.3, q).normal(q, DVec2::Y * 0.32);
        diagram = diagram.note(dvec2(3.2 + x, -0.3), "20°");
    }
    let diagram = diagram
        .polygon(&[dvec2(-1.2, 0.0), dvec2(1.2, 0.0), dvec2(1.2, -0.1), dvec2(-1.2, -0.1)])
        .polygon(&[dvec2(2.0, 0.0), dvec2(4.4, 0.0), dvec2(4.4, -0.1), dvec2(2.0, -0.1)])
        .lamp(lamp)
        .note(dvec2(0.0, -0.58), "(a)")
        .note(dvec2(3.2, -0.58), "(b)")
        .alt("Left, rays fan out from a lamp close above a surface and meet it at 51°, 32°, 0°, 32° and 51°. Right, parallel rays meet it everywhere at 20°.");
    Figure::from(diagram).caption(
        "A near and a far source (C, figure 24). In simplification 9 all light of a lamp has one direction.",
    )
}

/// C fig. 25: N, L and the cosine between them.
fn vectors() -> Figure {
    let (o, l) = (DVec2::ZERO, at(-40.0));
    let foot = DVec2::Y * l.y;
    let arc: Vec<DVec2> =
        (0..=60).map(|k| DVec2::from_angle(FRAC_PI_2 - 0.35 + f64::from(k) * 0.025)).collect();
    let diagram = Diagram::new(dvec2(-1.5, -0.18), dvec2(1.5, 1.25))
        .ground(o, DVec2::Y)
        .thin(&arc)
        .ray(Light::Incident, o, l)
        .name_end("L")
        .ray(Light::Normal, o, DVec2::Y)
        .name_end("N")
        .hidden(&[l, foot])
        .right_angle(foot, l - foot, -DVec2::Y)
        .dimension(foot, o, 46.0)
        .name("N · L = cos θ")
        .angle_at(o, DVec2::Y, l, 130.0)
        .name("θ")
        .lamp(l * 1.28)
        .point(o)
        .title("Of two unit vectors the dot product is the cosine: L's length along N")
        .subtitle(&format!("drawn: θ = 40°, N · L = {:.3}; |N| = |L| = 1, both away from the surface", l.y))
        .alt("From a point of a level surface start the unit normal N and the unit vector L towards a lamp, 40° apart; L's foot on N is at 0.766.");
    Figure::from(diagram).caption("The vectors of the diffuse component (C, figure 25). If N is longer than 1, all light is brighter by as much.")
}
