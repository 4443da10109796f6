//! The documents' diagrams: where the computed point lies, and what the ray from it meets. Errors are drawn far too large.

use glam::{DVec2, DVec3, dvec2};
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Diagram, Figure, Light, short};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

pub fn all(lesson: &Lesson) -> Result {
    lesson.save("precision", precision())?;
    lesson.save("below", below())?;
    lesson.save("on_the_surface", on_the_surface()?)?;
    lesson.save("back", back())?;
    lesson.save("bound", bound())
}

fn captioned(diagram: Diagram, caption: &str, alt: &str) -> Figure {
    Figure::from(diagram.alt(alt)).caption(caption)
}

/// On the circle of radius 1 about the origin.
fn on(degrees: f64, radius: f64) -> DVec2 {
    radius * DVec2::from_angle(degrees.to_radians())
}

/// Where a line from inside or near the unit circle leaves it ahead.
fn ahead(p: DVec2, d: DVec2) -> DVec2 {
    let d = d.normalize();
    let b = p.dot(d);
    let root = (b * b - p.dot(p) + 1.0).max(0.0).sqrt();
    let near = -b - root;
    p + d * if near > 1.0e-9 { near } else { root - b }
}

/// An arrow to a lamp ends beside it.
fn short_of(from: DVec2, lamp: DVec2) -> DVec2 {
    lamp - (lamp - from).normalize() * 0.18
}

/// [A ill. 63].
fn precision() -> Figure {
    let far = dvec2(3.4, 0.0);
    let (low, high) = (on(115.0, 0.86), on(115.0, 1.14));
    let lamp = dvec2(-0.9, 2.3);
    let inward = dvec2(0.46, -1.0);
    let again = ahead(high, inward);
    let diagram = Diagram::fitted()
        .circle(dvec2(0.0, 0.0), 1.0)
        .ray(Light::Incident, low + dvec2(-1.55, 1.05), low)
        .ray(Light::Shadow, low, short_of(low, lamp))
        .lamp(lamp)
        .spot(Light::Other, ahead(low, lamp - low))
        .word("meets it from inside: shadow")
        .point(low)
        .name("p")
        .note(dvec2(0.05, -0.25), "p too low")
        .circle(far, 1.0)
        .ray(Light::Incident, far + high + dvec2(-1.2, 1.3), far + high)
        .ray(Light::Transmitted, far + high, far + high + inward * 1.45)
        .spot(Light::Other, far + again)
        .word("meets it once more: refracted twice")
        .point(far + high)
        .name("p")
        .note(far + dvec2(-0.35, -0.25), "p too high")
        .title("A point too low spoils shadows, one too high refraction")
        .subtitle("computed points p, their errors drawn far too large; after A, illustration 63");
    captioned(
        diagram,
        "Problems of precision (A, illustration 63). Left, p lies behind the surface, and the ray to the light or in a mirror's direction \
         meets the surface from inside. Right, p lies before it, and the refracted ray meets the surface that it has just passed. A remedy \
         must know on which side the ray goes on.",
        "Two circles. In the left one a computed point lies inside; a dashed ray to a lamp crosses the circle on its way. At the right one the \
         point lies outside; a refracted ray enters the circle again.",
    )
}

/// [B 7.22].
fn below() -> Figure {
    let (p, lamp) = (dvec2(0.0, -0.32), dvec2(1.9, 1.7));
    let meets = p + (lamp - p) * (0.32 / (lamp.y - p.y));
    let eye = dvec2(-2.3, 1.35);
    let diagram = Diagram::new(dvec2(-2.7, -1.0), dvec2(2.6, 2.0))
        .half_plane(dvec2(0.0, 0.0), DVec2::Y)
        .eye(eye, p - eye)
        .ray(Light::Incident, eye, p)
        .lamp(lamp)
        .ray(Light::Shadow, p, meets)
        .hidden(&[meets, lamp])
        .spot(Light::Other, meets)
        .word("a shadow of its own")
        .point(p)
        .name("p")
        .dimension(p, dvec2(0.0, 0.0), -190.0)
        .word("rounding")
        .title("A computed point under the surface lies in the surface's own shadow")
        .subtitle("the error is drawn far too large; after B, figure 7.22");
    captioned(
        diagram,
        "Why there is acne (B, figure 7.22): rounding has put p under the surface, and the first thing between p and the lamp is the \
         surface itself.",
        "A ray from an eye ends in a point p a little under a flat surface. The dashed ray from p to a lamp meets the surface from below.",
    )
}

/// Where rays from computed points of the unit sphere meet it again, as computed: the first such t below 0, at 0 and above.
fn beginnings() -> Result<[f64; 3]> {
    let sphere = Sphere::new(DVec3::ZERO, 1.0).map_err(|e| LessonError(e.to_string()))?;
    let mut found = [None; 3];
    for i in 0..1000 {
        let mut sampler = Sampler::new(0, 0, i);
        let n = uniform_sphere(sampler.next_2d());
        let ray = Ray::new(n * 4.0, -n + 0.2 * n.any_orthonormal_vector());
        let Some(crossing) = sphere.nearest(&ray, 0.0, f64::INFINITY) else { continue };
        let hit = sphere.hit(&ray, &crossing);
        let leaving = Ray::new(hit.point, (hit.ng + 0.5 * hit.tangent).normalize());
        let Some((a, b)) = sphere.roots(&leaving) else { continue };
        let t = if a.abs() < b.abs() { a } else { b };
        let kind = if t < 0.0 { 0 } else { 1 + usize::from(t > 0.0) };
        found[kind].get_or_insert(t);
    }
    Ok(found.map(|t| t.unwrap_or(0.0)))
}

/// [C figure 6].
fn on_the_surface() -> Result<Figure> {
    let (p, lamp) = (on(125.0, 1.0), dvec2(0.2, 2.6));
    let eye = p + 3.0 * dvec2(-0.95, 0.32).normalize();
    let [below, zero, above] = beginnings()?;
    let diagram = Diagram::fitted()
        .circle(dvec2(0.0, 0.0), 1.0)
        .eye(eye, p - eye)
        .ray(Light::Incident, eye, p)
        .name("t = 3")
        .ray(Light::Shadow, p, short_of(p, lamp))
        .lamp(lamp)
        .normal(p, p * 0.7)
        .name_end("n")
        .note(dvec2(1.75, 1.75), "the same surface again, at t =")
        .note(dvec2(1.75, 1.5), &format!("{}   or   {}   or   {}", short(below), short(zero), short(above)))
        .point(p)
        .name("p")
        .title("The last digit decides whether a ray meets the surface it leaves")
        .subtitle("exactly t = 0, which t > 0 rules out; the three values were computed on a unit sphere; after C, figure 6");
    Ok(captioned(
        diagram,
        "The origin on the surface (C, figure 6): a ray from p meets the sphere at t = 0 and, as it leaves, nowhere else. Rounding turns the 0 \
         into a small number of either sign. C proposes a flag that says where the ray began, or a tolerance that grows with the sphere: \
         the second has the right idea, but is blind to the distance from the world's origin.",
        "A ray from an eye meets a circle at p. From p a dashed ray runs to a lamp; beside it stand three values of t: below zero, zero, above.",
    ))
}

/// [D figure 39].
fn back() -> Figure {
    let arriving = dvec2(0.86, -0.62).normalize();
    let p = dvec2(-0.1, -0.25);
    let shifted = p - arriving * 0.85;
    let lamp = dvec2(0.75, 1.9);
    let bent = dvec2(0.45, -1.0).normalize();
    let crossing = |from: DVec2, d: DVec2| from + d * (-from.y / d.y);
    let diagram = Diagram::new(dvec2(-2.9, -1.35), dvec2(2.5, 2.05))
        .half_plane(dvec2(0.0, 0.0), DVec2::Y)
        .ray(Light::Incident, p - arriving * 2.9, p)
        .lamp(lamp)
        .ray(Light::Shadow, shifted, short_of(shifted, lamp))
        .ray(Light::Transmitted, shifted, shifted + bent * 1.55)
        .name_end("transmitted")
        .spot(Light::Other, crossing(shifted, bent))
        .word("enters again")
        .point(p)
        .word("computed")
        .spot(Light::Incident, shifted)
        .word("corrected")
        .title("Back along the ray suits shadows, not what goes through")
        .subtitle("the computed point and D's corrected one, too far apart; after D, figure 39");
    captioned(
        diagram,
        "Self-shadow and its correction (D, figure 39): the point found under the surface moves back against the ray that found it, and the way \
         to the lamp is free. A transmitted ray from the corrected point meets the surface that it should have passed.",
        "A ray ends in a computed point under a flat surface. A corrected point lies back along the ray, above it. From there a dashed ray runs to a \
         lamp, and a transmitted ray goes down and crosses the surface.",
    )
}

/// What the default does.
fn bound() -> Figure {
    let p = dvec2(0.25, -0.12);
    let reach = 0.42;
    let (out, inside) = (p + DVec2::Y * reach * 1.4, p - DVec2::Y * reach * 1.4);
    let lamp = dvec2(2.0, 1.75);
    let ball: Vec<DVec2> = (0..=96)
        .map(|k| p + reach * DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 96.0))
        .collect();
    let diagram = Diagram::new(dvec2(-2.5, -1.6), dvec2(2.6, 2.0))
        .half_plane(dvec2(0.0, 0.0), DVec2::Y)
        .hidden(&ball)
        .note(p + dvec2(1.35, -0.28), "the true surface passes in here")
        .ray(Light::Incident, p + dvec2(-2.4, 1.75), p)
        .lamp(lamp)
        .ray(Light::Shadow, out, short_of(out, lamp))
        .ray(Light::Transmitted, inside, inside + dvec2(0.5, -1.0).normalize() * 0.95)
        .point(p)
        .name("p")
        .spot(Light::Shadow, out)
        .name("o")
        .spot(Light::Transmitted, inside)
        .name("o'")
        .dimension(p, out, -90.0)
        .name("(e + 2u |p|) |n|₁")
        .title("The default starts beyond the error, on the side where the ray goes")
        .subtitle("e: bound on the distance of p to the true surface, from the roundings of the shape's own formulas");
    captioned(
        diagram,
        "The default. Every hit brings a bound e on its own error; the start lies beyond it along the geometric normal, outside for shadows \
         and mirrors, inside for refraction. The second term pays for the rounding of the sum itself. No length is chosen, and no object \
         is skipped.",
        "A computed point p under a surface, with a dashed circle of its error round it. Above the circle lies the start o of a dashed ray to a lamp, \
         below it the start o' of a transmitted ray.",
    )
}
