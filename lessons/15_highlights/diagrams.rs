//! Diagrams of lesson 15: the vectors of a highlight, its spread, the half vector.

use glam::{DVec2, dvec2};
use lightbench::bsdf::highlight::power;
use lightbench_kit::figure::{Diagram, Figure, Light};
use lightbench_kit::lesson::{Lesson, Result};

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("vectors", vectors())?;
    lesson.save("spread", spread())?;
    lesson.save("half_vector", half_vector())?;
    lesson.save("half_angle", half_angle())
}

/// A direction of the section at an angle [degrees] from the vertical, to the right.
fn at(degrees: f64) -> DVec2 {
    dvec2(degrees.to_radians().sin(), degrees.to_radians().cos())
}

fn section() -> Diagram {
    Diagram::new(dvec2(-1.45, -0.12), dvec2(1.45, 1.12)).ground(DVec2::ZERO, DVec2::Y)
}

/// [C fig. 26].
fn vectors() -> Figure {
    let o = DVec2::ZERO;
    let (l, r, v) = (at(-42.0), at(42.0), at(66.0));
    let diagram = section()
        .ray(Light::Incident, o, l)
        .name_end("L")
        .normal(o, DVec2::Y)
        .name_end("N")
        .ray(Light::Reflected, o, r)
        .name_end("R")
        .ray(Light::Other, o, v)
        .name_end("V")
        .angle_at(o, l, DVec2::Y, 110.0)
        .name("θ")
        .angle_at(o, DVec2::Y, r, 110.0)
        .name("θ")
        .angle_at(o, r, v, 170.0)
        .name("φ")
        .lamp(l * 1.22)
        .eye(v * 1.22, -v)
        .point(o)
        .title("R = 2 (N·L) N − L stands as far on the other side; the highlight asks how far V is from it")
        .subtitle("drawn: θ = 42°, φ = 24°; all vectors are unit, and point away from the surface")
        .alt("From a point on a floor: L to a lamp at the left, the normal N upwards, R at the same angle θ to the right, V to an eye, 24° lower than R, the angle φ between them.");
    Figure::from(diagram).caption(
        "The vectors of Phong's model, after C, figure 26. A mirror sends light to V only where φ = 0; Phong's surface sends cosⁿ φ of it.",
    )
}

/// [C fig. 27]: polar plots.
fn spread() -> Figure {
    let (shiny, matt) = (200.0, 6.0);
    let half = |n: f64| 0.5f64.powf(1.0 / n).acos().to_degrees();
    let mut diagram = Diagram::new(dvec2(-2.4, -0.12), dvec2(2.4, 1.3)).ground(DVec2::ZERO, DVec2::Y);
    for (x, n, words) in [(-1.2, shiny, "shiny, n = 200"), (1.2, matt, "matt, n = 6")] {
        let o = dvec2(x, 0.0);
        let lobe = |d: f64| {
            let versine = 1.0 - (d - 45.0f64).to_radians().cos();
            o + at(d) * power(versine, n)
        };
        let points: Vec<DVec2> = (-450..=900).map(|k| lobe(f64::from(k) * 0.1)).collect();
        diagram = diagram
            .region(Light::Reflected, &points)
            .path(Light::Reflected, &points)
            .ray(Light::Incident, o + at(-45.0), o + at(-45.0) * 0.06)
            .ray(Light::Reflected, o, o + at(45.0) * 1.12)
            .name_end("R")
            .hidden(&[o, o + at(45.0 - half(n)) * 1.0])
            .hidden(&[o, o + at(45.0 + half(n)) * 1.0])
            .point(o)
            .note(o + dvec2(-0.35, 1.12), words);
    }
    let diagram = diagram
        .title(&format!(
            "Half of the peak is left at {:.1}° from R on the shiny surface, at {:.1}° on the matt one",
            half(shiny),
            half(matt)
        ))
        .subtitle("the distance from the point is cosⁿ φ in that direction; dashed: where it is ½; light at 45°")
        .alt("Two polar plots about the mirror direction: a needle for n = 200, a broad leaf for n = 6, with dashed lines where half is left.");
    Figure::from(diagram).caption(
        "Ranges of dispersion, after C, figure 27: the larger the exponent, the nearer the surface is to a mirror.",
    )
}

/// [C fig. 29].
fn half_vector() -> Figure {
    let o = DVec2::ZERO;
    let (l, v) = (at(-58.0), at(22.0));
    let h = (l + v).normalize();
    let diagram = Diagram::new(dvec2(-1.6, -0.12), dvec2(1.2, 1.62))
        .ground(o, DVec2::Y)
        .hidden(&[l, l + v])
        .hidden(&[v, l + v])
        .ray(Light::Incident, o, l)
        .name_end("L")
        .ray(Light::Other, o, v)
        .name_end("V")
        .ray(Light::Reflected, o, h)
        .name_end("H")
        .normal(o, DVec2::Y * 0.8)
        .name_end("N")
        .angle_at(o, l, h, 100.0)
        .name("40°")
        .angle_at(o, h, v, 130.0)
        .name("40°")
        .spot(Light::Normal, l + v)
        .word("L + V")
        .lamp(l * 1.2)
        .eye(v * 1.2, -v)
        .point(o)
        .title("H is the direction of L + V: half-way between them, wherever the normal points")
        .subtitle("drawn: L at 58°, V at 22°; a facet that faces H would mirror the lamp into the eye")
        .alt("L to a lamp at the left, V to an eye at the right of the normal; the sum of both, at the far corner of a rhombus, gives the direction H.");
    Figure::from(diagram).caption("The half vector, after C, figure 29.")
}

/// [C fig. 30].
fn half_angle() -> Figure {
    let o = DVec2::ZERO;
    let (l, r, v) = (at(-50.0), at(50.0), at(18.0));
    let h = at(-16.0);
    let diagram = section()
        .ray(Light::Incident, o, l)
        .name_end("L")
        .normal(o, DVec2::Y)
        .name_end("N")
        .ray(Light::Reflected, o, r)
        .name_end("R")
        .ray(Light::Other, o, v)
        .name_end("V")
        .ray(Light::Transmitted, o, h)
        .name_end("H")
        .angle_at(o, h, DVec2::Y, 250.0)
        .name("β")
        .angle_at(o, v, r, 150.0)
        .name("φ")
        .angle_at(o, l, DVec2::Y, 90.0)
        .name("θ")
        .angle_at(o, DVec2::Y, r, 90.0)
        .name("θ")
        .point(o)
        .title("V turns by φ from R, and H by half of that from N: φ = 2β, as long as all lie in one plane")
        .subtitle("drawn: θ = 50°, φ = 32°, β = 16°. If V steps out of the page by a small angle δ, H does by δ/(2 cos θ): φ = δ, and β is more than its half")
        .alt("L at 50° left of the normal N, R at 50° right of it, V at 18°; H between L and V stands 16° left of N.");
    Figure::from(diagram).caption(
        "β and φ, after C, figure 30. The sum of L and R is 2 cos θ long, and the same step of V turns a shorter vector by more: across the plane of \
         incidence Blinn's highlight is narrower, by cos θ.",
    )
}
