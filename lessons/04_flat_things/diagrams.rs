//! The documents' drawings of flat things.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::ray::Ray;
use lightbench::shape::disc::Disc;
use lightbench::shape::triangle::{Meeting, PreparedRay};
use lightbench_kit::figure::{Diagram, Light, Space};
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use std::f64::consts::TAU;

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("orientation", orientation())?;
    lesson.save("plane_and_polygon", plane_and_polygon())?;
    lesson.save("ray_plane", ray_plane())?;
    lesson.save("ray_disc", ray_disc()?)?;
    lesson.save("problem_disc", problem_disc()?)?;
    lesson.save("areas", areas())
}

fn other(e: impl std::fmt::Display) -> LessonError {
    LessonError(e.to_string())
}

/// A quad, the normals of its corners and its own, and its winding.
fn orientation() -> Diagram {
    let space = Space::axonometric(20.0, 24.0);
    let corners =
        [dvec3(-1.6, 0.0, 1.1), dvec3(1.6, 0.0, 1.1), dvec3(1.6, 0.0, -1.1), dvec3(-1.6, 0.0, -1.1)];
    let mut d = Diagram::fitted().polygon(&corners.map(|v| space.at(v))).name("P_{0}");
    for (i, v) in corners.into_iter().enumerate() {
        let lean = (DVec3::Y + v * 0.22).normalize() * 0.8;
        d = d.ray(Light::Other, space.at(v), space.at(v + lean)).name_end(&format!("n_{{{i}}}"));
        d = d.point(space.at(v)).name(&format!("V_{{{i}}}"));
    }
    d = d.normal(space.at(DVec3::ZERO), space.at(DVec3::Y) - space.at(DVec3::ZERO)).name_end("n");
    for (i, a) in corners.into_iter().enumerate() {
        let b = corners[(i + 1) % 4];
        let inset = |v: DVec3| space.at(v * 0.72);
        d = d.ray(Light::Incident, inset(a.lerp(b, 0.1)), inset(a.lerp(b, 0.9)));
    }
    d.title("The corners' order says which side is the front")
        .subtitle("seen from its front the quad winds counter-clockwise; its corners have normals of their own; after A, ill. 4")
}

/// A plane by point and normal, and a polygon cut out of it.
fn plane_and_polygon() -> Diagram {
    let space = Space::axonometric(24.0, 32.0);
    let sheet = [dvec3(-2.6, 0.0, 1.5), dvec3(2.6, 0.0, 1.5), dvec3(2.6, 0.0, -1.5), dvec3(-2.6, 0.0, -1.5)];
    let outline = [(0.1, 0.9), (1.5, 0.95), (2.1, -0.1), (1.3, -1.0), (0.2, -0.7)];
    let outline = outline.map(|(x, z)| dvec3(x, 0.0, z));
    let p = dvec3(-1.5, 0.0, 0.2);
    let mut d = Diagram::fitted().polygon(&sheet.map(|v| space.at(v)));
    d = d.region(Light::Incident, &outline.map(|v| space.at(v)));
    let closed: Vec<DVec2> = outline.iter().chain(&outline[..1]).map(|v| space.at(*v)).collect();
    d = d.path(Light::Incident, &closed);
    for (i, v) in outline.into_iter().enumerate() {
        d = d.point(space.at(v)).name(&format!("V_{{{i}}}"));
    }
    d.ray(Light::Normal, space.at(p), space.at(p + DVec3::Y * 1.2))
        .name_end("n")
        .point(space.at(p))
        .name("p")
        .title("A plane is a point and a normal; a polygon is a plane within its corners")
        .subtitle("plane (p, n), polygon V₀ … V₄; after A, ill. 8")
}

/// The plane in section, a ray that meets it and one that never does.
fn ray_plane() -> Diagram {
    let (n, p0) = (dvec2(0.0, 1.0), dvec2(-2.2, 0.0));
    let (origin, p) = (dvec2(-1.6, 2.2), dvec2(1.6, 0.0));
    Diagram::fitted()
        .ground(dvec2(-3.2, 0.0), n)
        .ray(Light::Incident, origin, p)
        .name("l_{0} + t l")
        .point(origin)
        .name("l_{0}")
        .ray(Light::Normal, p0, p0 + n * 1.2)
        .name_end("n")
        .thin(&[p0, p])
        .right_angle(p0, n, p - p0)
        .point(p0)
        .name("p_{0}")
        .point(p)
        .name("p")
        .ray(Light::Shadow, dvec2(0.6, 2.3), dvec2(3.3, 2.3))
        .name("l · n = 0: no t")
        .note(dvec2(0.1, -0.42), "(p − p₀) · n = 0")
        .title("A ray meets a plane once, or it is parallel")
        .subtitle("t = (p₀ − l₀) · n / l · n; a parallel ray has no t, also if it runs inside the plane; after B, ill. 6.4")
}

fn circle(space: &Space, c: DVec3, n: DVec3, r: f64) -> Vec<DVec2> {
    let u = n.any_orthonormal_vector();
    let v = n.cross(u);
    (0..=96)
        .map(|i| TAU * f64::from(i) / 96.0)
        .map(|t| space.at(c + (u * t.cos() + v * t.sin()) * r))
        .collect()
}

/// A disc in space, a ray within the radius and one beyond.
fn ray_disc() -> Result<Diagram> {
    let space = Space::axonometric(28.0, 30.0);
    let disc = Disc::new(DVec3::ZERO, DVec3::Y, 1.5).map_err(other)?;
    let mut d = Diagram::fitted()
        .polygon(
            &[(-2.6, 1.9), (2.9, 1.9), (2.9, -1.9), (-2.6, -1.9)].map(|(x, z)| space.at(dvec3(x, 0.0, z))),
        )
        .polygon(&circle(&space, DVec3::ZERO, DVec3::Y, 1.5));
    for (from, to, name) in [
        (dvec3(-1.7, 1.9, 0.0), dvec3(0.7, 0.0, 0.5), "p"),
        (dvec3(1.0, 1.9, 0.0), dvec3(2.3, 0.0, -0.3), "q"),
    ] {
        let met = disc.meeting(&Ray::new(from, to - from)).is_some();
        let light = if met { Light::Incident } else { Light::Shadow };
        d = d.ray(light, space.at(from), space.at(to));
        d = d.thin(&[space.at(DVec3::ZERO), space.at(to)]).point(space.at(to)).name(name);
    }
    let rim = dvec3(-1.5, 0.0, 0.0);
    Ok(d.thin(&[space.at(DVec3::ZERO), space.at(rim)])
        .name("r")
        .ray(Light::Normal, space.at(DVec3::ZERO), space.at(DVec3::Y * 1.3))
        .name_end("n")
        .point(space.at(DVec3::ZERO))
        .name("c")
        .title("A disc is a plane that ends at its radius")
        .subtitle("|p − c| ≤ r is a hit, |q − c| > r is none; after B, ill. 6.5"))
}

/// Problem 5.1 of E with numbers, in section.
fn problem_disc() -> Result<Diagram> {
    let (o, d, c, r) = (dvec3(0.0, 3.0, 0.0), dvec3(0.8, -0.6, 0.0), dvec3(3.0, 0.0, 0.0), 1.5);
    let disc = Disc::new(c, DVec3::Y, r).map_err(other)?;
    let t = disc.meeting(&Ray::new(o, d)).ok_or_else(|| other("the ray of the example misses its disc"))?;
    let p = o + d * t;
    let flat = |v: DVec3| v.truncate();
    Ok(Diagram::fitted()
        .hidden(&[dvec2(-0.4, 0.0), dvec2(5.6, 0.0)])
        .curve(&[dvec2(c.x - r, 0.0), dvec2(c.x + r, 0.0)])
        .ray(Light::Incident, flat(o), flat(p))
        .name(&format!("t = {t}"))
        .ray(Light::Reflected, flat(o), flat(o + d))
        .name_end("d")
        .normal(flat(c), dvec2(0.0, 1.1))
        .name_end("n")
        .dimension(flat(c), dvec2(c.x - r, 0.0), 34.0)
        .name(&format!("r = {r}"))
        .dimension(flat(c), flat(p), -34.0)
        .name(&format!("|p − c| = {}", p.distance(c)))
        .point(flat(o))
        .name("o")
        .point(flat(c))
        .name("c")
        .point(flat(p))
        .name("p")
        .title(&format!("The ray is in the plane at t = {t}, {} from the centre: a hit", p.distance(c)))
        .subtitle("o = (0, 3, 0), d = (0.8, −0.6, 0), c = (3, 0, 0), n = (0, 1, 0), r = 1.5, seen from the side; E, problem 5.1"))
}

/// The three areas that a point makes with the corners.
fn areas() -> Diagram {
    let corners = [dvec3(0.0, 0.0, 0.0), dvec3(4.0, 0.0, 0.0), dvec3(1.2, 2.6, 0.0)];
    let p = dvec3(1.8, 0.8, 0.0);
    let ray = PreparedRay::new(&Ray::new(p + DVec3::Z, DVec3::NEG_Z));
    let b = ray.meet(corners).map_or([f64::NAN; 3], |Meeting { b, .. }| b);
    let flat = corners.map(|v| v.truncate());
    let lights = [Light::Incident, Light::Reflected, Light::Transmitted];
    let mut d = Diagram::fitted().polygon(&flat);
    for i in 0..3 {
        let (next, last) = (flat[(i + 1) % 3], flat[(i + 2) % 3]);
        d = d.region(lights[i], &[p.truncate(), next, last]).thin(&[p.truncate(), flat[i]]);
        let middle = (p.truncate() + next + last) / 3.0;
        d = d.note(middle, &format!("A{} = {:.2} A", ["₀", "₁", "₂"][i], b[i]));
    }
    for (i, v) in flat.into_iter().enumerate() {
        d = d.point(v).name(&format!("v_{{{i}}}"));
    }
    d.point(p.truncate()).name("p").title("A point splits the triangle into its own coordinates").subtitle(
        "bᵢ = Aᵢ / A, the area opposite to corner i; values mix as b₀ x₀ + b₁ x₁ + b₂ x₂; after D, fig. 26",
    )
}
