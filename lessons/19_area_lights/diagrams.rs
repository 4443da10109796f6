//! Diagrams: rays from a light, umbra and penumbra in section, a light's parameters, points on triangle and sphere.

use super::place::{Place, other};
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::light::{Rectangle, sphere_irradiance};
use lightbench::measure::Method;
use lightbench::sample::{
    Cells, Pattern, sphere_as_printed, uniform_sphere, uniform_triangle, uniform_triangle_fold,
};
use lightbench_kit::figure::{Axis, Chart, Diagram, Figure, Guide, Light, Space, short};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::PI;

pub fn save(lesson: &Lesson, ratios: [f64; 2]) -> Result {
    lesson.save("many_rays", many_rays())?;
    lesson.save("umbra", umbra())?;
    lesson.save("parameters", parameters()?)?;
    lesson.save("triangle_points", triangle_points(lesson.seed(), ratios))?;
    lesson.save("sphere_points", sphere_points(lesson.seed()))
}

/// [A ill. 44].
fn many_rays() -> Figure {
    let p = dvec2(0.5, 0.0);
    let (a, b) = (dvec2(-1.6, 2.1), dvec2(0.7, 2.55));
    let nl = (b - a).perp().normalize() * -1.0;
    let mut diagram = Diagram::new(dvec2(-2.6, -0.3), dvec2(2.6, 2.95)).ground(p, DVec2::Y);
    let points: Vec<DVec2> = (0..7).map(|k| a.lerp(b, (f64::from(k) + 0.5) / 7.0)).collect();
    for (k, &q) in points.iter().enumerate() {
        diagram = if k == 2 {
            diagram.ray(Light::Reflected, q, p).name("d")
        } else {
            diagram.ray(Light::Incident, q, p)
        };
    }
    let q = points[2];
    let up = nl * -0.11;
    diagram = diagram.polygon(&[a, b, b + up, a + up]).word("light");
    for &q in &points {
        diagram = diagram.point(q);
    }
    let diagram = diagram
        .normal(q, nl * 0.75)
        .name_end("nₗ")
        .angle_at(q, nl, p - q, 70.0)
        .name("θₗ")
        .normal(p, DVec2::Y * 0.95)
        .name_end("n")
        .angle_at(p, DVec2::Y, q - p, 90.0)
        .name("θ")
        .point(p)
        .name("p")
        .title("Light comes from every point of an area: each counts cos θ cos θₗ / d²")
        .subtitle("seven of infinitely many ways; A sends alike in all directions, a matt emitter follows the cosine at the light too")
        .alt("A slanted bar, the light, with seven points; a ray runs from each to one point p of the ground. One ray is marked with the angles θ at p and θₗ at the light.");
    Figure::from(diagram).caption(
        "Why an area light is hard (A, illustration 44): its light is an integral over its surface. A finite number of rays stands for it. The emitter's own cosine, which A leaves out, is what makes it \
         look equally bright from all sides.")
}

/// Where the line through `a` and `b` meets the ground.
fn on_ground(a: DVec2, b: DVec2) -> DVec2 {
    a + (b - a) * (a.y / (a.y - b.y))
}

/// [D fig. 19].
fn umbra() -> Figure {
    let (l0, l1) = (dvec2(-0.75, 3.0), dvec2(0.75, 3.0));
    let (b0, b1) = (dvec2(-0.85, 1.35), dvec2(0.95, 1.35));
    let (left, right) = (on_ground(l1, b0), on_ground(l0, b1));
    let (inner_left, inner_right) = (on_ground(l0, b0), on_ground(l1, b1));
    let (full, half) = (inner_right.x - inner_left.x, right.x - inner_right.x);
    let thick = DVec2::Y * 0.1;
    let diagram = Diagram::new(dvec2(-3.4, -0.45), dvec2(3.6, 3.35))
        .region(Light::Shadow, &[b0, left, inner_left])
        .region(Light::Shadow, &[b1, right, inner_right])
        .hatched(&[b0, b1, inner_right, inner_left])
        .ground(DVec2::ZERO, DVec2::Y)
        .ray(Light::Incident, l0, inner_left)
        .ray(Light::Incident, l1, inner_right)
        .ray(Light::Incident, l0, right)
        .ray(Light::Incident, l1, left)
        .polygon(&[l0, l1, l1 + thick, l0 + thick])
        .note(dvec2(1.1, 3.05), "light")
        .polygon(&[b0, b1, b1 - thick, b0 - thick])
        .note(dvec2(1.5, 1.32), "blocker")
        .dimension(left, inner_left, -40.0)
        .name("penumbra")
        .dimension(inner_left, inner_right, -40.0)
        .name("umbra")
        .dimension(inner_right, right, -40.0)
        .name("penumbra")
        .note(dvec2(2.95, 0.75), "full light")
        .title(&format!("An area light sees round an edge: umbra {full:.2} m wide, penumbra {half:.2} m beside it"))
        .subtitle(&format!("a light of 1.5 m, 3 m up, a blocker of 1.8 m, {:.2} m up; the half shadow's width is light × height / distance to the light", b0.y))
        .alt("A short light above a blocker above the ground. Lines from both ends of the light past both ends of the blocker mark the umbra in the middle and a penumbra on either side.");
    Figure::from(diagram).caption(
        "Umbra and penumbra of an area light (D, figure 19). From the umbra nothing of the light is seen, from the penumbra a part. All lines are drawn from the ends of the light past the ends of the blocker.")
}

/// [D fig. 20].
fn parameters() -> Result<Figure> {
    let space = Space::axonometric(-28.0, 16.0);
    let (width, height, roll) = (2.4, 1.5, 0.35);
    let direction = dvec3(0.25, -0.3, 0.9);
    let light = Rectangle::facing(DVec3::ZERO, direction, roll, dvec2(width, height)).map_err(other)?;
    let level = Rectangle::facing(DVec3::ZERO, direction, 0.0, dvec2(width, height)).map_err(other)?;
    let (w, h) = (light.half_width(), light.half_height());
    let at = |p: DVec3| space.at(p);
    let mut diagram = Diagram::fitted();
    let corner = -w - h;
    diagram = diagram.pixel_grid(&space, corner, w * 2.0, h * 2.0, 5, 5);
    for cell in Cells::grid(5, 5).iter() {
        let u = cell.center() * 2.0 - 1.0;
        diagram = diagram.point(at(w * u.x + h * u.y));
    }
    let (end, rolled) = (level.half_width() * -1.75, w * -1.75);
    let [c0, c1, c2, _] = light.corners();
    let diagram = diagram
        .ray(Light::Normal, DVec2::ZERO, at(end))
        .name_end("level")
        .ray(Light::Normal, DVec2::ZERO, at(rolled))
        .angle_at(at(DVec3::ZERO), at(end), at(rolled), 330.0)
        .name("RollAngle")
        .ray(Light::Reflected, DVec2::ZERO, at(light.normal() * 1.5))
        .name_end("Direction")
        .spot(Light::Other, DVec2::ZERO)
        .name("Position")
        .dimension(at(c0), at(c1), 34.0)
        .name("Width")
        .dimension(at(c1), at(c2), 34.0)
        .name("Height")
        .title("Seven parameters of D’s area light: two of them place its points")
        .subtitle(&format!("Width {width} m, Height {height} m, RollAngle {roll} rad, Subdivision 5 5: one shadow ray to the middle of each cell"))
        .alt("A rectangle in space with five by five cells and a point in each; an arrow, its direction, leaves the centre; an angle marks how far it is rolled from level.");
    Ok(Figure::from(diagram).caption(
        "The parameters of a rectangular light (D, figure 20). It faces Direction, is turned about it by RollAngle, counter-clockwise, and Subdivision cuts it into cells."))
}

/// [A ill. 45], and the other map.
fn triangle_points(seed: u64, ratios: [f64; 2]) -> Figure {
    let corners = [dvec2(0.0, 0.0), dvec2(2.2, 0.0), dvec2(0.75, 1.9)];
    let cells = 8u32;
    let points = Pattern::Jittered.points(cells * cells, seed);
    let mut diagram = Diagram::new(dvec2(-0.15, -0.62), dvec2(5.15, 2.15));
    for (map, shift) in
        [(uniform_triangle_fold as fn(DVec2) -> DVec3, 0.0), (uniform_triangle as fn(DVec2) -> DVec3, 2.8)]
    {
        let place = |u: DVec2| {
            let w = map(u);
            corners[0] * w.x + corners[1] * w.y + corners[2] * w.z + dvec2(shift, 0.0)
        };
        diagram = diagram.polygon(&corners.map(|c| c + dvec2(shift, 0.0)));
        let steps = 24;
        let line = |from: DVec2, to: DVec2| -> Vec<DVec2> {
            (0..=steps).map(|k| place(from.lerp(to, f64::from(k) / f64::from(steps)))).collect()
        };
        for k in 1..cells {
            let t = f64::from(k) / f64::from(cells);
            let end = if shift == 0.0 { 1.0 - t } else { 1.0 };
            diagram = diagram.thin(&line(dvec2(t, 0.0), dvec2(t, end)));
            diagram = diagram.thin(&line(dvec2(0.0, t), dvec2(end, t)));
        }
        for u in points.iter() {
            let light = if shift == 0.0 && u.x + u.y > 1.0 { Light::Reflected } else { Light::Incident };
            diagram = diagram.spot(light, place(u));
        }
    }
    let diagram = diagram
        .note(dvec2(1.1, -0.2), "as printed: if (a + b > 1) { a = 1 − a; b = 1 − b }")
        .note(dvec2(1.1, -0.42), "orange: what was folded over")
        .note(dvec2(3.95, -0.2), "s = √u,  (1 − s,  s (1 − v),  s v)")
        .note(dvec2(3.95, -0.42), "one point in each piece")
        .title(&format!(
            "The fold puts two cells on each piece, and holes appear: jittered points err {:.1} times as much", ratios[0]
        ))
        .subtitle("64 jittered points, one in each cell of 8 × 8, on a triangle: by A’s fold, and by the square root")
        .alt("Two triangles with 64 points each. On the left the grid of cells covers the triangle twice, blue and orange points clump; on the right each piece holds one point.");
    Figure::from(diagram).caption(
        "A random point in a triangle (A, illustration 45) and the map by a square root (Turk 1990). Both are uniform; only the second keeps what was planned in the square.")
}

/// [A ill. 46], and Archimedes' map.
fn sphere_points(seed: u64) -> Figure {
    let points = Pattern::Random.points(1000, seed);
    let mut diagram = Diagram::new(dvec2(-1.25, -1.6), dvec2(3.85, 1.2));
    let mut near = [0u32; 2];
    for (k, map) in [sphere_as_printed as fn(DVec2) -> DVec3, uniform_sphere].into_iter().enumerate() {
        let shift = dvec2(2.6 * k as f64, 0.0);
        diagram = diagram.circle(shift, 1.0);
        for u in points.iter() {
            let p = map(u);
            near[k] += u32::from(p.z.abs() > 0.75f64.sqrt());
            if p.y < 0.0 {
                let light = if k == 0 { Light::Other } else { Light::Incident };
                diagram = diagram.spot(light, dvec2(p.x, p.z) + shift);
            }
        }
    }
    let share = near.map(|n| 100.0 * f64::from(n) / 1000.0);
    let diagram = diagram
        .note(dvec2(0.0, -1.25), "as printed: a = π u − 1.57,  b = 6.28 v")
        .note(dvec2(0.0, -1.47), "(cos a cos b,  cos a sin b,  sin a)")
        .note(dvec2(2.6, -1.25), "z = 1 − 2u,  φ = 2π v")
        .note(dvec2(2.6, -1.47), "(√(1 − z²) cos φ,  √(1 − z²) sin φ,  z)")
        .title(&format!(
            "As printed the poles are crowded: {:.0} % of the points within 30° of one, where {:.0} % belong", share[0], 100.0 * (1.0 - 0.75f64.sqrt())
        ))
        .subtitle(&format!("1000 random points, the half in front; counted by the other map: {:.0} %", share[1]))
        .alt("Two discs full of points: on the left they crowd at top and bottom, on the right they are even, denser only towards the rim.");
    Figure::from(diagram).caption(
        "A random point on a sphere (A, illustration 46): a uniform latitude crowds the points at the poles, with density 1/(2π² sin θ) instead of 1/4π. Archimedes: the height is uniform.")
}

/// How much the printed sphere light is off, by the direction from which it is seen.
pub struct Bias {
    /// Far away, diffuse: from a pole, from the equator.
    pub ends: [f64; 2],
    curves: Vec<(Method, Vec<(f64, f64)>)>,
}

impl Bias {
    pub fn measured(side: u32, steps: u32) -> Self {
        let cells = Cells::grid(side, side);
        let curve = |distance: f64, even: bool| -> Vec<(f64, f64)> {
            (0..=steps)
                .map(|k| 90.0 * f64::from(k) / f64::from(steps))
                .map(|degrees| (degrees, bias(&cells, distance, degrees, even)))
                .collect()
        };
        let far = curve(1.0e5, false);
        let ends = [far[0].1, far[far.len() - 1].1];
        let curves = vec![
            (Method::as_printed("matt light, far"), far),
            (Method::new("matt light, 2 radii away").styled(1), curve(2.0, false)),
            (Method::new("A’s light, 2 radii away").styled(3), curve(2.0, true)),
        ];
        Bias { ends, curves }
    }

    pub fn chart(&self) -> Figure {
        let mut chart = Chart::new(
            Axis::linear("place, degrees from the light’s pole").range(0.0, 90.0).every(15.0),
            Axis::percent("irradiance too large by"),
        )
        .title(&format!(
            "The printed sphere light is {:.1} % too bright seen from a pole, {:.1} % too dark from its equator", 100.0 * self.ends[0], -100.0 * self.ends[1]
        ))
        .subtitle("mean of the printed points by midpoints; receivers turned to the centre; against closed form (matt) and even points (A’s)")
        .guide(Guide::level(0.0, "right"));
        for (method, points) in &self.curves {
            chart = chart.function(method.clone(), points);
        }
        Figure::from(chart).caption(&format!(
            "Bias of the irradiance from the sphere of illustration 46. No number of samples cures it. From far away it is 4/π − 1 = {} % along the axis and 8/π² − 1 = {} % across. A's own light, the mean over its \
             points without a cosine at the light, errs less.", short(100.0 * (4.0 / PI - 1.0)), short(100.0 * (8.0 / PI / PI - 1.0))))
    }
}

fn bias(cells: &Cells, distance: f64, degrees: f64, even: bool) -> f64 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let way = dvec3(sin, 0.0, cos);
    let place = Place { p: way * distance, n: -way };
    let n = f64::from(cells.len());
    let mean = |map: fn(DVec2) -> DVec3| {
        let one = |u: DVec2| {
            let x = map(u);
            if even { place.cosine(x) } else { 4.0 * PI * place.by_area(x, x) }
        };
        cells.iter().map(|c| one(c.center())).sum::<f64>() / n
    };
    let truth =
        if even { mean(uniform_sphere) } else { sphere_irradiance(DVec3::ZERO, 1.0, place.p, place.n) };
    mean(sphere_as_printed) / truth - 1.0
}
