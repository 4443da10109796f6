//! The figures of the lesson.

use super::experiment::{AMBIENT, AREA, Line, Measured, mid, neighbours, other, rmse, room, shoot, soft};
use super::{D_SECONDS, POINT, RUNS, SIDES, SIZES, TRUTH, WAYS};
use glam::{DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::film::metric::compare;
use lightbench::integrator::{Local, Stage};
use lightbench::measure::{Method, Point, Series};
use lightbench::ray::Ray;
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern::Centres;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{
    self, Axis, Chart, Diagram, ErrorPanel, Figure, Guide, Panels, Pixels, Shades, Table,
};
use lightbench_kit::lesson::{Lesson, Result};

pub const ERROR: &str = "error of radiance, RMSE [W m⁻² sr⁻¹]";

pub fn after_the_hit() -> Result<Figure> {
    let (eye, lamp) = (dvec3(-2.6, 1.25, 0.0), dvec3(0.75, 2.3, 0.0));
    let sphere = Sphere::new(DVec3::ZERO, 1.0).map_err(other)?;
    let ray = Ray::new(eye, (dvec3(-0.6, 0.75, 0.0) - eye).normalize());
    let Some(crossing) = sphere.nearest(&ray, 0.0, f64::INFINITY) else {
        return Err(other("the ray misses"));
    };
    let hit = sphere.hit(&ray, &crossing);
    let [eye, lamp, p, n, d] = [eye, lamp, hit.point, hit.ng, ray.direction].map(DVec3::truncate);
    let o = p + n * 0.15;
    let diagram = Diagram::fitted()
        .title("After the hit all that is local is known; only the way to the light is not")
        .subtitle(&format!("drawn: t = {:.3}, p = (−{:.3}, {:.3}, 0) on the unit sphere", hit.t, p.x.abs(), p.y))
        .circle(dvec2(0.0, 0.0), 1.0)
        .note(dvec2(0.1, -0.1), "object and material")
        .eye(eye, d)
        .ray(figure::Light::Incident, eye, p)
        .name("t")
        .lamp(lamp)
        .ray(figure::Light::Shadow, o, lamp)
        .word("is this way free?")
        .normal(p, n * 0.9)
        .name_end("n")
        .ray(figure::Light::Normal, p, p - n.perp() * 0.75)
        .word("tangent")
        .angle_at(o, n, lamp - o, 60.0)
        .name("θ")
        .point(p)
        .name("p")
        .spot(figure::Light::Other, o)
        .name("o")
        .alt("A ray from an eye meets a sphere at the point p after the distance t. The normal n and a tangent start \
              there. From o, a little off the sphere along n, a dashed ray runs to a lamp, at the angle θ from n.");
    Ok(Figure::from(diagram).caption(
        "What is known after an intersection (A, illustration 64): the ray parameter t, the point p and a bound on its \
         rounding error, the normal n, a tangent with texture coordinates, the object and its material. The ray to \
         the light starts at o, off the surface by that bound, drawn far too large."))
}

/// The documents' pictures: a sphere by visibility only, scene 1 with its area light and with its point light.
pub fn documents(lesson: &Lesson, picture: Picture) -> Result {
    let view = FieldOfView::Vertical(0.7);
    let mut scene =
        Scene::new(Camera::new(dvec3(0.0, 0.0, 4.0), DVec3::ZERO, DVec3::Y, view).map_err(other)?);
    scene.background = Rgb::new(0.55, 0.7, 0.85);
    scene.materials.push(Material { diffuse: Rgb::new(0.75, 0.16, 0.08), ..Material::default() });
    let sphere = Sphere::new(DVec3::ZERO, 1.0).map_err(other)?;
    scene.objects.push(Object::new("sphere", Box::new(sphere), 0));
    let seen = Local { stage: Stage::Visibility, ..Local::default() };
    let fine = Picture { samples: lesson.flags().spp.map_or(16, u32::from), ..picture };
    let disc = render(&scene, &seen, fine).image;
    let caption =
        "A sphere by visibility alone (B, illustration 7.1): without light nothing tells it from a disc.";
    lesson.save_picture(
        "sphere_visibility",
        &disc,
        caption,
        "A plain red disc on pale blue, without any shading.",
    )?;
    let area = render(&room(AREA)?, &Local::default(), picture).image;
    let caption =
        "Scene 1 under a square of 10 × 10 light points (D, figure 40): the shadows' edges are soft.";
    lesson.save_picture("area_light", &area, caption,
        "A room open to the front, red wall left, green wall right, with five white spheres one above the other. Their \
         shadows on the back wall have soft edges. At the right edge stands the square light.")?;
    let point = render(&room(POINT)?, &Local::default(), picture).image;
    let caption = "Scene 1 under a point light of Color 0.9 (D, figure 41): the shadows' edges are hard.";
    lesson.save_picture(
        "point_light",
        &point,
        caption,
        "The same room and spheres, a little darker; the shadows on the back wall have sharp edges.",
    )
}

pub fn panels(picture: Picture) -> Result<Figure> {
    let truth = shoot(&soft(31, Centres), picture)?;
    let mut panels = Panels::new().columns(3);
    for way in &WAYS[..4] {
        panels = panels.picture(Pixels::from(&shoot(way, picture)?), way.0);
    }
    let hard = shoot(&WAYS[2], picture)?;
    let errors = hard.pixels().iter().zip(truth.pixels()).map(|(a, b)| (*a - *b).element_sum() / 3.0);
    let error = ErrorPanel {
        width: picture.width,
        height: picture.height,
        values: errors.collect(),
        shades: Shades::Signed,
        name: "error of the hard shadows".to_string(),
        rmse: compare(&hard, &truth).rmse,
        range: Some((-0.5, 0.5)),
    };
    let panels = panels
        .picture(Pixels::from(&truth), "soft, 31 × 31 grid: the truth")
        .error(error)
        .title("Each stage buys one thing: what, how lit, what is in the way")
        .subtitle(&format!(
            "scene 1 of D, {} × {} pixels, ambient light {AMBIENT} W/(m² sr)", picture.width, picture.height
        ))
        .alt("Six pictures of a room with five spheres: flat colours, white spheres lost before a white wall; shaded \
              without shadows; with hard shadows; with soft shadows of 100 points; the truth, which looks the same; \
              and the error of the hard shadows: bands along every shadow's edge, too bright outside and too dark \
              inside.");
    Ok(Figure::from(panels).caption(
        "Scene 1 of D, stage by stage. White before white cannot be told apart until light comes in; spheres float \
         until shadows tie them to the wall; ten by ten light points already look like the truth."))
}

/// Counts, errors and times, and D's times below them.
pub fn costs(stages: &[Measured], picture: Picture) -> Table {
    let time = |i: usize| 1.0e9 * mid(stages, i) / (picture.width * picture.height) as f64;
    let tests = stages[3].1 / stages[2].1;
    let head =
        ["stage", "rays a pixel", "shape tests a pixel", "RMSE", "time a pixel [ns]", "time, hard = 1"];
    let mut table = Table::new(&head)
        .title(&format!("A hundred shadow rays need only {tests:.1} times the shape tests of one"))
        .subtitle(&format!(
            "scene 1 of D, {} × {} pixels, medians of {RUNS} runs; last, D's own times, 512 × 512 pixels on a GTX 560",
            picture.width, picture.height
        ))
        .timed();
    let mut row = |name: &str, rays: String, tests: String, error: String, time: f64, unit: f64| {
        let (time, ratio) = (format!("{time:.0}"), format!("{:.2}", time / unit));
        table = table.clone().row(&[name, &rays, &tests, &error, &time, &ratio]);
    };
    for (i, (way, (point, tests))) in WAYS.iter().zip(stages).enumerate() {
        let rays = format!("{:.2}", point.work.unwrap_or(0.0));
        row(way.0, rays, format!("{tests:.1}"), format!("{:.4}", rmse(point)), time(i), time(2));
    }
    let [point, area] = D_SECONDS.map(|s| s * 1.0e9 / (512.0 * 512.0));
    row("D, figure 41: point light", "2".into(), "–".into(), "–".into(), point, point);
    row("D, figure 40: 10 × 10 points", "101".into(), "–".into(), "–".into(), area, point);
    table
}

pub fn shadows(chart: Chart, [grid, jittered]: &[Series; 2], x: fn(&Point) -> f64) -> Figure {
    let (one, rest) = grid.points.split_at(1);
    let (first, last) = (&jittered.points[0], &grid.points[SIDES.len() - 1]);
    let chart = chart
        .subtitle(&format!(
            "scene 1 of D with N = 1, 4, 9, 25, 100, 400 light points, {RUNS} runs; truth: {TRUTH}² points"
        ))
        .line(Method::new("1 point: hard shadow").styled(5), &Series::new(one.to_vec()))
        .line(Method::default_of("n × n grid").styled(0), &Series::new(rest.to_vec()))
        .line(Method::new("n × n jittered").styled(1), jittered)
        .guide(Guide::slope_through(-0.75, x(last), 0.6 * rmse(last), "slope −¾"))
        .guide(Guide::slope_through(-0.5, x(first), rmse(first), "slope −½: independent points"));
    Figure::from(chart).caption(
        "Error of the shadows of scene 1 against cost. A shadow's edge crosses some n of the n × n cells, and each of \
         those errs by chance: n^(1/2)/n² = N^(−3/4) (for a grid and a curved edge: Kendall, 1948). The grid's points \
         are the same for every pixel, hence cheap; that its errors are steps, no such number shows.")
}

pub fn grid_or_jittered([grid, jittered]: &[Series; 2]) -> String {
    let ratio = rmse(&jittered.points[4]) / rmse(&grid.points[4]);
    format!("At 100 light points the grid errs {ratio:.1} times less than jittered points")
}

pub fn penumbra(errors: &[Line; 2]) -> Figure {
    let [steps, noise] = errors.each_ref().map(|e| neighbours(e).0);
    let chart = Chart::new(
        Axis::linear("place on the back wall, x [m]"),
        Axis::linear("error of radiance [W m⁻² sr⁻¹]"),
    )
    .title("In the penumbra a grid draws steps, jittered points draw noise")
    .subtitle(&format!(
        "5 × 5 light points; errors of neighbours correlate by {steps:.2} (grid) and {noise:.2} (jittered)"
    ))
    .dots(Method::new("jittered").styled(1), &errors[1])
    .function(Method::default_of("grid").styled(0), &errors[0])
    .guide(Guide::level(0.0, "the truth"));
    Figure::from(chart).caption(
        "Error along a level line across the shadow of the middle sphere: each column of light points vanishes at \
         once behind the sphere's edge, and the grid's error jumps. An eye sees the steps as bands.")
}

pub fn sizes(changes: &[[(f64, f64); 2]]) -> Table {
    let head = [
        "size of room",
        "bound: largest change [10⁻¹⁵]",
        "pixels changed",
        "bias: largest change",
        "pixels changed",
    ];
    let table = Table::new(&head)
        .title("A rounding bound fits every room; a fixed bias of 10⁻⁴\u{a0}m fits some")
        .subtitle("shadow rays start off the surface by the one or the other; scene 1 of D, all lengths multiplied; change of radiance");
    SIZES.iter().zip(changes).fold(table, |table, ((size, _), [ours, naive])| {
        let share = |x: f64| format!("{:.2} %", 100.0 * x);
        let cells =
            [format!("{:.1}", ours.0 * 1.0e15), share(ours.1), format!("{:.2}", naive.0), share(naive.1)];
        table.row(&[size, &cells[0], &cells[1], &cells[2], &cells[3]])
    })
}
