//! Charts, tables, diagrams and pictures of lesson 05; their numbers come from the lesson.

use super::hole::Hole;
use super::{Contest, RING};
use glam::{DAffine3, DMat3, DVec2, DVec3, dvec2, dvec3};
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::measure::{Method, Spread};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::instance::Instance;
use lightbench::shape::torus::{Torus, TorusMethod};
use lightbench_kit::figure::{
    Axis, Bars, Chart, Diagram, FailureMap, Figure, Guide, Light as Pen, Panels, Pixels, Table, short,
};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

/// A method with the style that it keeps in every chart of the lesson.
pub fn method(method: TorusMethod) -> Method {
    match method {
        TorusMethod::Adaptive => Method::default_of("adaptive").styled(0),
        TorusMethod::AsPrinted => Method::as_printed("as printed"),
        TorusMethod::Recentred => Method::new("printed solver, recentred").styled(5),
        TorusMethod::Ferrari => Method::new("Ferrari").styled(1),
        TorusMethod::Bracketed => Method::new("bracketed").styled(2),
        TorusMethod::Algorithm1010 => Method::new("Algorithm 1010").styled(3),
        TorusMethod::Sturm => Method::new("Sturm").styled(4),
        TorusMethod::Marching => Method::new("marching").styled(6),
    }
}

fn lines(mut chart: Chart, contest: &Contest) -> Chart {
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    chart
}

fn failed(contest: &Contest, k: usize) -> u64 {
    contest[k].1.failures().total()
}

/// The headline: error and failures against time.
pub fn speed(contest: &Contest, rays: u32) -> Figure {
    let of = contest[0].1.failures().of;
    let chart = Chart::speed_accuracy("error of t, in a (root mean square)")
        .x(Axis::time("time per ray, nearest root"))
        .title(&format!(
            "The certified solver keeps all {of} roots; as printed fails {} times",
            failed(contest, 1)
        ))
        .subtitle(&format!(
            "{rays} rays: b/a 10⁻⁴ to 0.99, distance 4 a to 10⁴ a, every second one grazes as close as 10⁻¹² b; a = 2 m"
        ));
    let chart = contest[..6].iter().fold(chart, |chart, (method, series)| chart.line(method.clone(), series));
    Figure::from(chart).caption(
        "Speed against accuracy on rays that hold all difficulties at once. Time: to the nearest root, median of nine runs with \
         quartiles. Error: of all roots found. Below: roots missed, and roots that do not exist. Who gives up early is quick: time \
         and failures must be read together. Sturm's chain and marching are too slow for this chart; the table has them.",
    )
}

/// The same numbers of all eight.
pub fn contest(contest: &Contest) -> Figure {
    let mut table = Table::new(&["Method", "missed", "false", "error of t, a", "ns per ray", "quartiles"])
        .timed()
        .title(&format!("Of eight ways to {} roots one keeps them all", contest[0].1.failures().of))
        .subtitle(
            "the rays of the chart of speed against accuracy; error: root mean square of the roots found",
        );
    for (method, series) in contest.iter().rev() {
        let p = &series.points[0];
        let ns = |s: f64| format!("{:.0}", s * 1.0e9);
        let (error, time) = (p.error.map_or(f64::NAN, |e| e.mid), p.time.unwrap_or(Spread::exact(f64::NAN)));
        let (missed, invented) = (p.failures.missed.to_string(), p.failures.false_hits.to_string());
        let quartiles = format!("{} to {}", ns(time.low), ns(time.high));
        table = table.row(&[&method.name, &missed, &invented, &short(error), &ns(time.mid), &quartiles]);
    }
    Figure::from(table.marked()).caption("All eight methods on the same rays; the default stands last.")
}

pub fn distance(contest: &Contest) -> Figure {
    let axis = Axis::log("distance of the origin D/a").range(3.2, 1.3e4);
    let chart = Chart::error_over(axis, "error of t, in a (root mean square)")
        .title(&format!(
            "Expanded at the ray's origin the quartic drowns: {} of {} roots fail",
            failed(contest, 1),
            contest[1].1.failures().of
        ))
        .subtitle("b/a = 0.3; rays in any direction through the tube, or past it by a tenth of b")
        .guide(Guide::slope_through(1.0, 1.0, f64::EPSILON / 2.0, "u D"));
    Figure::from(lines(chart, contest)).caption(
        "Error over the distance of the ray's origin. Moved to the closest approach, every solver errs by about one rounding of \
         the distance itself; expanded at the origin, coefficients grow as D⁴ and the error with them.",
    )
}

pub fn thin(contest: &Contest) -> Figure {
    let axis = Axis::log("thickness b/a").range(0.8e-4, 1.2);
    let worst = (3..7).max_by_key(|&k| failed(contest, k)).unwrap_or(2);
    let chart = Chart::failures_over(axis, "roots missed or false, of those asked")
        .title(&format!(
            "Thin rings make close pairs: {} fails {} times, the default never",
            contest[worst].0.name,
            failed(contest, worst)
        ))
        .subtitle("distance 10 a; half of the rays graze at 10⁻¹¹ b under or above the surface");
    Figure::from(lines(chart, contest)).caption(
        "Share of roots that a method misses or invents, over the thickness of the ring. The two roots of a tube lie 2b apart or \
         less, and a solver in plain f64 can tell a pair apart only down to about √u.",
    )
}

pub fn grazing(contest: &Contest) -> Figure {
    let axis = Axis::log("depth of the graze, in b").range(0.5e-12, 0.2);
    let chart = Chart::failures_over(axis, "roots missed or false, of those asked")
        .title(&format!(
            "Grazing a thin ring, Ferrari fails {} times of {}, certified signs never",
            failed(contest, 3),
            contest[3].1.failures().of
        ))
        .subtitle("b/a = 10⁻³, distance 10 a; tangential rays, by turns so far under and above the surface");
    Figure::from(lines(chart, contest)).caption(
        "Share of roots missed or invented where rays graze. Under the surface at depth g two roots lie about 2√(2gb) apart; \
         above it there are none. The sign between them is rounding for all who do not ask how large the rounding is.",
    )
}

pub fn failure_words(map: FailureMap, of: TorusMethod) -> Figure {
    let name = method(of).name;
    let share = map.failing_share();
    let title = match share {
        0.0 => format!("{name} keeps every root, near and far, thick and thin"),
        _ => format!("{name} fails on {:.0} % of the map", 100.0 * share),
    };
    let map = map.range(1.0e-16, 1.0e-4).failing("misses or invents roots").title(&title).subtitle(
        "eight rays a cell, half of them graze at 10⁻¹¹ b; root-mean-square error; hatched: a root missed or invented",
    );
    Figure::from(map).caption(&format!(
        "Where {name} fails: distance of the ray's origin from left to right, thickness of the ring upwards; elsewhere its error."
    ))
}

pub fn shadow_rays(cost: &[(Method, (Spread, usize))]) -> Figure {
    let mut bars = Bars::new(Axis::time("time per shadow ray").range(0.0, cost[6].1.0.mid * 1.1))
        .timed()
        .title("Shadow rays need no root: certified signs suffice")
        .subtitle(
            "from lit-side points of the torus (2, 0.6) to a lamp; wrong: answers unlike the default's",
        );
    for (method, (time, wrong)) in cost.iter().filter(|c| c.1.0.mid <= cost[6].1.0.mid) {
        let label = format!("{:.0} ns, {wrong} wrong", time.mid * 1.0e9);
        bars = bars.labelled(method.clone(), *time, &label);
    }
    Figure::from(bars).caption(
        "What it costs to ask whether something stands between a place on the torus and the lamp. The default evaluates the \
         quartic at its stationary points, and computes a root only where the signs leave it open.",
    )
}

/// How far the dimension line stands off the axis [px].
const DIMENSION: f64 = 130.0;

/// [A ill. 15].
pub fn cross_section() -> Figure {
    let (a, b) = (RING, 0.6);
    let diagram = Diagram::fitted()
        .circle(dvec2(-a, 0.0), b)
        .circle(dvec2(a, 0.0), b)
        .ray(Pen::Normal, dvec2(-3.1, 0.0), dvec2(3.3, 0.0))
        .name_end("ρ")
        .ray(Pen::Normal, dvec2(0.0, -1.0), dvec2(0.0, 1.3))
        .name_end("z")
        .point(dvec2(a, 0.0))
        .dimension(dvec2(0.0, 0.0), dvec2(a, 0.0), DIMENSION)
        .name("a")
        .path(Pen::Incident, &[dvec2(a, 0.0), dvec2(a, 0.0) + b * DVec2::from_angle(0.9)])
        .name("b")
        .title("Two radii make a torus: the ring's a and the tube's b")
        .subtitle("(ρ − a)² + z² = b², ρ² = x² + y²; squared once: (ρ² + z² + a² − b²)² = 4 a² ρ²: a quartic")
        .alt("Two circles of radius b left and right of the z axis, their centres at distance a from it.");
    Figure::from(diagram).caption(
        "Cross-section of the torus through its axis (after A, illustration 15); here a = 2 and b = 0.6.",
    )
}

pub fn testcull(hole: &Hole) -> Figure {
    let mut diagram = Diagram::fitted()
        .circle(dvec2(-RING, 0.0), 0.6)
        .circle(dvec2(RING, 0.0), 0.6)
        .hidden(&[dvec2(0.0, 0.0), dvec2(-3.2, 0.0)])
        .ray(Pen::Incident, dvec2(0.0, 0.0), dvec2(3.4, 0.0))
        .point(dvec2(0.0, 0.0))
        .name("o");
    for t in &hole.roots {
        let pen = if *t > 0.0 { Pen::Transmitted } else { Pen::Reflected };
        diagram = diagram.spot(pen, dvec2(*t, 0.0)).name(&format!("{t:.1}").replace('-', "−"));
    }
    let diagram = diagram
        .title("Roots behind the origin do not put it inside: from the hole there are two on each side")
        .subtitle("green: roots ahead; orange: roots behind, at which the printed testcull answers \"no hit\"")
        .alt("The section of the torus with a ray from the middle of its hole: two roots ahead of it, two behind.");
    Figure::from(diagram).caption(
        "A ray from the middle of the hole of the torus (2, 0.6): its line meets the torus at four places (after A, illustration 59).",
    )
}

pub fn as_printed(hole: &Hole, [lost, hits]: [usize; 2]) -> Figure {
    let list = |roots: &[f64]| {
        roots.iter().map(|t| format!("{t:.4}").replace('-', "−")).collect::<Vec<_>>().join(", ")
    };
    let hit = |t: Option<f64>| t.map_or("no hit".to_string(), |t| format!("{t:.4}"));
    let first = |roots: &[f64]| hit(roots.iter().copied().find(|t| *t > 0.0));
    let table = Table::new(&["From the hole of the torus (2, 0.6), along x", "roots", "hit at t"])
        .title(&format!("The printed testcull loses {lost} of {hits} hits seen from the hole"))
        .subtitle(
            "counted over random directions; the table shows the ray along x, which meets the surface at 1.4 and 2.6",
        )
        .row(&["(5.23) as numbered: a₀ multiplies t⁴", &list(&hole.reversed), &first(&hole.reversed)])
        .row(&["ill. 59 with testcull", &list(&hole.roots), &hit(hole.culled)])
        .row(&["ill. 59 without testcull", &list(&hole.roots), &hit(hole.unculled)])
        .row(&["adaptive (default), roots ahead", &list(&hole.truth), &first(&hole.truth)])
        .marked();
    Figure::from(table).caption(
        "The ray–quartic code as printed (after A, illustration 59). Equation (5.23) numbers the coefficients in reverse, whose \
         roots are 1/t; the program has them right. With testcull any root behind the origin counts as \"inside\", and the hit is \
         thrown away.",
    )
}

/// Two linked rings on a floor, from so many ring radii away through a lens that keeps their size.
fn scene(method: TorusMethod, distance: f64) -> Result<Scene> {
    let wrong = |e: &dyn std::fmt::Display| LessonError(e.to_string());
    let target = dvec3(0.45, 2.0, 0.0);
    let towards = dvec3(-0.35, 0.42, 1.0).normalize();
    let eye = target + towards * (distance * RING);
    let field = FieldOfView::Vertical(2.0 * (3.5 / (distance * RING)).atan());
    let camera = Camera::new(eye, target, DVec3::Y, field).map_err(|e| wrong(&e))?;
    let mut scene = Scene::new(camera);
    let paint = |name: &str, diffuse: DVec3| Material {
        name: name.to_string(),
        diffuse,
        specular: DVec3::ZERO,
        ..Default::default()
    };
    scene.materials = vec![
        paint("floor", dvec3(0.72, 0.70, 0.66)),
        paint("red", dvec3(0.78, 0.16, 0.08)),
        paint("teal", dvec3(0.06, 0.42, 0.48)),
    ];
    let far = 400.0;
    let floor = Cuboid::new(dvec3(-far, -1.0, -far), dvec3(far, 0.0, far)).map_err(|e| wrong(&e))?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    let torus = |tube: f64| Torus::new(RING, tube).map(|t| t.with_method(method)).map_err(|e| wrong(&e));
    // Each ring runs through the other's middle, at a right angle.
    let lying = DAffine3::from_mat3_translation(DMat3::from_rotation_x(-1.05), dvec3(-0.6, 2.3, 0.0));
    let standing = DAffine3::from_mat3_translation(DMat3::from_rotation_x(0.52), dvec3(1.4, 2.3, 0.0));
    for (name, tube, place, material) in [("red ring", 0.5, lying, 1), ("teal ring", 0.4, standing, 2)] {
        let ring = Instance::new(Box::new(torus(tube)?), place).map_err(|e| wrong(&e))?;
        scene.objects.push(Object::new(name, Box::new(ring), material));
    }
    let (place, size) = (dvec3(-6.0, 12.0, 7.0), dvec2(3.2, 3.2));
    let lamp = AreaLight::rectangle(place, target - place, 0.0, size, Emission::even(DVec3::splat(0.95)));
    scene.lights.push(Light::Area(lamp.map_err(|e| wrong(&e))?.subdivided(3, 3, Pattern::Jittered)));
    scene.background = dvec3(0.80, 0.86, 0.92);
    scene.ambient = DVec3::splat(0.16);
    Ok(scene)
}

pub fn pictures(lesson: &Lesson) -> Result {
    let (width, samples) = lesson.pick([(48, 1), (360, 1), (560, 4), (1120, 16)]);
    let picture = Picture { width, height: width * 3 / 4, samples, seed: lesson.seed() };
    let shot = |method, distance| {
        Ok::<_, LessonError>(render(&scene(method, distance)?, &Local::default(), picture).image)
    };
    let near = shot(TorusMethod::Adaptive, 10.0)?;
    lesson.save_picture(
        "torus",
        &near,
        "Two linked tori, a = 2, b = 0.5 and 0.4, by the default solver.",
        "A red ring lying askew and a teal ring standing through its middle, on a pale floor with soft shadows.",
    )?;
    let mut panels = Panels::new()
        .columns(3)
        .title("As printed, the rings shade themselves, and fray with distance; the default does neither")
        .subtitle("shadow rays start on the surface, camera rays far away; the lens is lengthened with the distance");
    for (method, distance) in
        [(TorusMethod::AsPrinted, 10.0), (TorusMethod::AsPrinted, 3000.0), (TorusMethod::Adaptive, 3000.0)]
    {
        let label = format!("{}, from {distance} a", self::method(method).name);
        panels = panels.picture(Pixels::from(&shot(method, distance)?), &label);
    }
    let alt = "Three pictures of two linked rings. As printed: half in false shadow from 10 a, frayed too from 3000 a; the last, by the \
               default from 3000 a, is clean.";
    let figure = Figure::from(panels.alt(alt)).caption(
        "The quartic expanded at the ray's origin and solved as printed, from near and far, and the default solver from the far \
         place. As printed, a shadow ray meets the surface that it leaves: its threshold of 10⁻⁶ m is smaller than the error.",
    );
    lesson.save("far_away", figure)
}
