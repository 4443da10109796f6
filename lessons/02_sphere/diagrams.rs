//! Diagrams of lesson 02: what the words mean; the examples of [C] are drawn to scale.

use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::num::real::{Triple, dot};
use lightbench::shape::sphere::method::{algebraic, algebraic_first, in_front, robust};
use lightbench_kit::figure::{Diagram, Figure, Light, Space, Table, short};
use lightbench_kit::lesson::{Lesson, Result};

fn captioned(diagram: Diagram, caption: &str, alt: &str) -> Figure {
    Figure::from(diagram.alt(alt)).caption(caption)
}

/// The documents' drawings: what a sphere is, what a ray is, where the origin may be, the projection; and an example
/// that is worked out in print.
pub fn of_the_documents(lesson: &Lesson) -> Result {
    lesson.figure("sphere", || Ok(definition().stacked(parametric())))?;
    lesson.figure("ray", || Ok(ray().stacked(projection())))?;
    lesson.figure("origins", || Ok(outside().stacked(inside()).stacked(surface())))?;
    lesson.figure("entering", || Ok(entering()))?;
    lesson.table("worked_examples", || Ok(worked_examples()))
}

fn definition() -> Figure {
    let space = Space::axonometric(30.0, 22.0);
    let rim = dvec3(0.80, 0.52, 0.30).normalize();
    let diagram = Diagram::fitted()
        .ball(&space, DVec3::ZERO, 1.0, DVec3::Y)
        .thin(&[space.at(DVec3::ZERO), space.at(rim)])
        .name("r")
        .point(space.at(DVec3::ZERO))
        .name("c")
        .point(space.at(rim))
        .name("p")
        .title("A centre and a radius say all about a sphere")
        .subtitle("every point p with |p − c| = r; four numbers, and no error of shape");
    captioned(
        diagram,
        "The sphere by its centre c and radius r: four numbers where a mesh needs thousands (after Sancho, illustration 7).",
        "A ball with its equator; a point c in the middle, a point p on the surface, the line between them is named r.",
    )
}

fn parametric() -> Figure {
    let space = Space::axonometric(28.0, 20.0);
    // [B §6.2] has z as the pole; here the pole points up the page.
    let on = |theta: f64, phi: f64| dvec3(theta.sin() * phi.sin(), theta.cos(), theta.sin() * phi.cos());
    let (theta, phi) = (1.0, 0.95);
    let arc = |from: f64, to: f64, at: &dyn Fn(f64) -> DVec3| -> Vec<DVec2> {
        (0..=32).map(|k| space.at(at(from + (to - from) * f64::from(k) / 32.0))).collect()
    };
    let (o, p) = (space.at(DVec3::ZERO), space.at(on(theta, phi)));
    let foot = space.at(on(theta, phi) * dvec3(1.0, 0.0, 1.0));
    let mut diagram = Diagram::fitted().ball(&space, DVec3::ZERO, 1.0, DVec3::Y);
    for (axis, letter) in [(DVec3::Z, "x"), (DVec3::X, "y"), (DVec3::Y, "z")] {
        diagram = diagram.ray(Light::Normal, o, space.at(axis * 1.35)).name_end(letter);
    }
    let diagram = diagram
        .thin(&arc(0.0, std::f64::consts::FRAC_PI_2, &|t| on(t, phi)))
        .path(Light::Incident, &[o, p])
        .name("r")
        .hidden(&[o, foot, p])
        .path(Light::Other, &arc(0.0, theta, &|t| on(t, phi) * 0.42))
        .name("θ")
        .path(Light::Transmitted, &arc(0.0, phi, &|t| on(std::f64::consts::FRAC_PI_2, t) * 0.6))
        .name("φ")
        .spot(Light::Incident, p)
        .name("p(θ, φ)")
        .title("Two angles reach every point of a sphere")
        .subtitle("x = r sin θ cos φ,  y = r sin θ sin φ,  z = r cos θ,  with 0 ≤ θ ≤ π and 0 ≤ φ < 2π");
    captioned(
        diagram,
        "The sphere by two angles: θ from the pole, φ around it (after Anguera, figure 6.1). They serve as texture coordinates later.",
        "A ball with axes x, y and z; a point p on it; angle theta between the z axis and the radius to p, angle phi in \
         the equator from the x axis to the foot of p.",
    )
}

fn ray() -> Figure {
    let (o, d) = (dvec2(0.0, 0.0), dvec2(0.9578, 0.2873));
    let mut diagram = Diagram::new(dvec2(-1.6, -0.75), dvec2(4.4, 1.75))
        .hidden(&[o - d * 1.5, o])
        .word("t < 0: behind")
        .ray(Light::Incident, o, o + d * 4.1)
        .name_end("o + t d");
    for t in [1.0, 2.0, 3.0] {
        diagram = diagram.spot(Light::Incident, o + d * t).name(&format!("t = {t}"));
    }
    let diagram = diagram
        .point(o)
        .name("o")
        .ray(Light::Normal, o - dvec2(-0.08, 0.28), o + d - dvec2(-0.08, 0.28))
        .name("d")
        .title("A ray is an origin and a direction")
        .subtitle("p(t) = o + t d with t > 0; d has length 1, so t is a distance");
    captioned(
        diagram,
        "A ray: all points o + t d with t > 0 (after Anguera, figure 4.4). A hit at a negative t lies behind the origin.",
        "An arrow from a point o to the right; dots at t = 1, 2, 3 along it; the part behind o is dashed and named t < 0.",
    )
}

/// The plane of a ray and a centre: the ray runs along +x from the origin, the centre lies below its line.
struct Plane {
    center: DVec2,
    r: f64,
    t: (f64, f64),
}

/// [C]'s examples: f, unnormalised direction, radius.
const EXAMPLES: [([f64; 3], [f64; 3], f64); 2] =
    [([-2.0, -2.0, -6.0], [1.0, 2.0, 4.0], 3.0), ([-1.0, -3.0, -1.0], [1.0, 2.0, 3.0], 4.0)];

fn unit(d: [f64; 3]) -> [f64; 3] {
    DVec3::from(d).normalize().to_array()
}

impl Plane {
    /// Of an example of [C §1.6.1].
    fn of((f, d, r): ([f64; 3], [f64; 3], f64)) -> Plane {
        let d = unit(d);
        let closest = -dot(f, d);
        let below = (dot(f, f) - closest * closest).max(0.0).sqrt();
        Plane { center: dvec2(closest, -below), r, t: robust(f, d, r).unwrap_or((f64::NAN, f64::NAN)) }
    }
    fn at(&self, t: f64) -> DVec2 {
        dvec2(t, 0.0)
    }
    fn normal(&self, t: f64) -> DVec2 {
        (self.at(t) - self.center) / self.r
    }
}

fn outside() -> Figure {
    let p = Plane::of(EXAMPLES[0]);
    let (i0, i1) = (p.at(p.t.0), p.at(p.t.1));
    let diagram = Diagram::fitted()
        .circle(p.center, p.r)
        .ray(Light::Incident, DVec2::ZERO, i0)
        .name(&format!("t_{{0}} = {:.3}", p.t.0))
        .hidden(&[i0, i1])
        .ray(Light::Shadow, i1, i1 + dvec2(2.0, 0.0))
        .normal(i0, p.normal(p.t.0) * 1.6)
        .name_end("n")
        .point(DVec2::ZERO)
        .name("R_{0}")
        .point(i0)
        .name("i_{0}")
        .point(i1)
        .name(&format!("i_{{1}}, t_{{1}} = {:.3}", p.t.1))
        .point(p.center)
        .name("S_{c}")
        .title("From outside, the smaller root is visible")
        .subtitle("the plane of ray and centre, to scale: S_{r} = 3");
    captioned(
        diagram,
        "Origin outside: both roots are positive, and i₀ at the smaller one is visible (after Ramos, figure 5, to scale).",
        "A ray from R0 on the left meets a circle at i0 and i1; the normal n at i0 points back to the left; both parameters \
         are written beside the points.",
    )
}

fn inside() -> Figure {
    let p = Plane::of(EXAMPLES[1]);
    let (i0, i1) = (p.at(p.t.0), p.at(p.t.1));
    let diagram = Diagram::fitted()
        .circle(p.center, p.r)
        .hidden(&[i0 - dvec2(1.5, 0.0), DVec2::ZERO])
        .ray(Light::Incident, DVec2::ZERO, i1)
        .name(&format!("t_{{1}} = {:.3}", p.t.1))
        .normal(i1, -p.normal(p.t.1) * 1.6)
        .name_end("−n")
        .point(i0)
        .name(&format!("i_{{0}}, t_{{0}} = −{:.3}", -p.t.0))
        .point(DVec2::ZERO)
        .name("R_{0}")
        .point(i1)
        .name("i_{1}")
        .point(p.center)
        .name("S_{c}")
        .title("From inside, one root lies behind the eye")
        .subtitle("the plane of ray and centre, to scale: S_{r} = 4");
    captioned(
        diagram,
        "Origin inside: t₀ is negative, the ray hits the sphere at i₁ only, and the normal is turned to face it (after Ramos, figure 7, to scale).",
        "A ray starts at R0 inside a circle near its left rim and leaves at i1 on the right; the point i0 behind the origin \
         is on the dashed backward line; the normal at i1 points into the circle.",
    )
}

/// A hit point computed in f32, and how far below the surface it lies: drawn hugely enlarged.
fn surface() -> Figure {
    let (f, d) = ([-2.0f32, -2.0, -6.0], unit([1.0, 2.0, 4.0]).map(|x| x as f32));
    let t = in_front(robust(f, d, 3.0)).unwrap_or(f32::NAN);
    let point: Triple<f32> = [0, 1, 2].map(|i| f[i] + t * d[i]);
    let depth = 3.0 - DVec3::from(point.map(f64::from)).length();
    let place = if depth > 0.0 { "below" } else { "above" };
    let (center, r) = (dvec2(0.0, -8.0), 8.0);
    let (true_point, ray, light) = (DVec2::ZERO, dvec2(0.82, -0.57), dvec2(0.4, 0.92).normalize());
    let found = true_point + ray * 0.8;
    let back = (found - center).extend(0.0).to_array();
    let again = robust(back, light.extend(0.0).to_array(), r).map_or(found, |(_, t)| found + light * t);
    let diagram = Diagram::new(dvec2(-3.0, -1.75), dvec2(3.0, 1.85))
        .circle(center, r)
        .ray(Light::Incident, true_point - ray * 2.7, true_point)
        .name("R_{d}")
        .path(Light::Incident, &[true_point, found])
        .ray(Light::Shadow, found, found + light * 2.4)
        .name_end("to the light")
        .point(true_point)
        .word("true hit")
        .spot(Light::Other, found)
        .word("computed point")
        .spot(Light::Reflected, again)
        .word("false hit, t > 0")
        .title("A rounded point below its surface shades itself")
        .subtitle(&format!(
            "in f32 the point ends {} units {place} the sphere of radius 3; drawn hugely enlarged",
            short(depth.abs())
        ));
    captioned(
        diagram,
        "Origin on the surface: the computed point lies a rounding off it, and a shadow ray that starts below hits its own \
         sphere again at a small positive t (after Ramos, figure 6). Moving the origin by the bound of that rounding cures it; \
         a fixed tolerance does not.",
        "Close-up of a surface: an incoming ray should end on it but the computed point lies below; a dashed shadow ray from \
         there to the light crosses the surface at a third point.",
    )
}

fn entering() -> Figure {
    let p = Plane { center: dvec2(3.6, -0.55), r: 1.6, t: (0.0, 0.0) };
    let half = (p.r * p.r - p.center.y * p.center.y).sqrt();
    let (enter, leave) = (p.at(p.center.x - half), p.at(p.center.x + half));
    let diagram = Diagram::fitted()
        .circle(p.center, p.r)
        .ray(Light::Incident, DVec2::ZERO, leave + dvec2(1.7, 0.0))
        .name_end("ray")
        .normal(enter, p.normal(enter.x) * 0.8)
        .name_end("n")
        .normal(leave, p.normal(leave.x) * 0.8)
        .name_end("n")
        .spot(Light::Transmitted, enter)
        .word("enters: d·n < 0")
        .spot(Light::Reflected, leave)
        .word("leaves: d·n > 0")
        .title("A ray enters against the normal and leaves along it")
        .subtitle("both hits are kept: glass and solids need the stretch between them");
    captioned(
        diagram,
        "A ray enters a sphere and leaves it: the sign of d·n tells them apart (after Tomas, figure 3).",
        "A ray crosses a circle from left to right; at the left point the outward normal opposes the ray and it enters, at the \
         right point it agrees and the ray leaves.",
    )
}

pub fn triangle() -> Figure {
    let (c, r) = (dvec2(5.0, -1.3), 2.2);
    let half = (r * r - c.y * c.y).sqrt();
    let (o, foot, p0, p1) = (DVec2::ZERO, dvec2(5.0, 0.0), dvec2(5.0 - half, 0.0), dvec2(5.0 + half, 0.0));
    let diagram = Diagram::fitted()
        .circle(c, r)
        .ray(Light::Incident, o, dvec2(8.6, 0.0))
        .name_end("ray")
        .path(Light::Normal, &[o, c])
        .name("f")
        .path(Light::Other, &[foot, c])
        .name("d")
        .path(Light::Normal, &[c, p1])
        .name("r")
        .right_angle(foot, dvec2(-1.0, 0.0), dvec2(0.0, -1.0))
        .dimension(o, foot, 92.0)
        .name("t_{ca}")
        .dimension(foot, p1, 92.0)
        .name("t_{hc}")
        .dimension(o, p0, 40.0)
        .name("t_{0} = t_{ca} − t_{hc}")
        .point(o)
        .name("O")
        .point(c)
        .name("C")
        .point(p0)
        .name("P")
        .point(p1)
        .name("P′")
        .title("Two right triangles share the distance d")
        .subtitle(
            "d² = f·f − t_{ca}²  and  t_{hc}² = r² − d²: far away, d² is a small difference of huge squares",
        );
    captioned(
        diagram,
        "f joins centre and origin; d is the distance of the ray from the centre; the two right triangles give the distances \
         along the ray (after Anguera, figure 6.2).",
        "A ray from O crosses a circle with centre C at P and P prime; f joins O to C; d is the perpendicular from C to the \
         ray; t_ca reaches from O to its foot and t_hc from there to P prime.",
    )
}

fn projection() -> Figure {
    let (a, b) = (dvec2(3.2, 2.2), dvec2(5.6, 0.0));
    let foot = dvec2(a.x, 0.0);
    let diagram = Diagram::fitted()
        .ray(Light::Incident, DVec2::ZERO, b)
        .name_end("b")
        .ray(Light::Reflected, DVec2::ZERO, a)
        .name_end("a")
        .hidden(&[a, foot])
        .right_angle(foot, dvec2(-1.0, 0.0), dvec2(0.0, 1.0))
        .angle_at(DVec2::ZERO, b, a, 90.0)
        .name("θ")
        .dimension(DVec2::ZERO, foot, -34.0)
        .name("|a| cos θ = a·b / |b|")
        .title("A scalar product is a length times a shadow")
        .subtitle("a·b = |a| |b| cos θ; with |b| = 1 it is the projection itself: t_{ca} = L·D");
    captioned(
        diagram,
        "Scalar projection: a·b is the length of b times the shadow of a on it (after Anguera, figure 6.3).",
        "Two arrows a and b from one point with the angle theta between them; a dashed perpendicular from the tip of a to b; \
         the shadow on b is named |a| cos theta.",
    )
}

/// Two examples step by step: what is printed in [C §1.6.1], and what this run finds.
fn worked_examples() -> Table {
    let printed = [
        [
            "[0.218, 0.436, 0.873]",
            "−13.092",
            "35",
            "31.4",
            "3.744",
            "not needed",
            "[1.816, −0.368, 2.269]",
            "[−0.395, −0.123, −0.910]",
        ],
        [
            "[0.267, 0.534, 0.802]",
            "−5.344",
            "−5",
            "48.55",
            "−0.812",
            "6.156",
            "[4.645, 1.290, 6.935]",
            "−[0.161, 0.073, 0.983]",
        ],
    ];
    let origins = [[1.0, -2.0, -1.0], [3.0, -2.0, 2.0]];
    let steps =
        ["R_{d}", "B = 2 R_{d}·f", "C = f·f − S_{r}²", "D = B² − 4C", "t_{0}", "t_{1}", "r_{i}", "r_{n} · N"];
    let found: Vec<[String; 8]> = EXAMPLES.iter().zip(origins).map(|(e, o)| steps_of(*e, o)).collect();
    let mut table = Table::new(&[
        "Step",
        "1, outside: printed",
        "this run",
        "2, inside: printed",
        "this run",
    ])
    .title("Two printed examples, beside this run")
    .subtitle(
        "f = R_{0} − S_{c}; example 1 f = (−2, −2, −6), S_{r} = 3; example 2 f = (−1, −3, −1), S_{r} = 4",
    );
    for (i, step) in steps.iter().enumerate() {
        table = table.row(&[step, printed[0][i], &found[0][i], printed[1][i], &found[1][i]]);
    }
    table
}

fn steps_of((f, d, r): ([f64; 3], [f64; 3], f64), origin: [f64; 3]) -> [String; 8] {
    let d = unit(d);
    let (b, c) = (2.0 * dot(f, d), dot(f, f) - r * r);
    let (t0, t1) = algebraic(f, d, r).unwrap_or((f64::NAN, f64::NAN));
    let t = algebraic_first(f, d, r).unwrap_or(f64::NAN);
    let side = if t0 > 0.0 { 1.0 } else { -1.0 };
    let minus = |x: f64, digits: usize| format!("{x:.digits$}").replace('-', "−");
    let vector = |v: DVec3| format!("[{}, {}, {}]", minus(v.x, 4), minus(v.y, 4), minus(v.z, 4));
    let (at, n) = (DVec3::from(d) * t, (DVec3::from(f) + DVec3::from(d) * t) / r * side);
    let second = if t0 > 0.0 { "not needed".to_string() } else { minus(t1, 6) };
    [
        vector(DVec3::from(d)),
        minus(b, 6),
        minus(c, 0),
        minus(b * b - 4.0 * c, 6),
        minus(t0, 6),
        second,
        vector(DVec3::from(origin) + at),
        vector(n),
    ]
}
