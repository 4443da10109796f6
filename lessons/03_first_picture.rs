//! Lesson 03. What does each stage of a first picture cost, and what does it buy?
//!
//! Builds on:  01 (a pixel becomes a ray), 02 (a ray meets a sphere).
//! New here:   what is known after a hit; Lambert's law; shadow rays; a light of n × n points; a safe origin.
//! Notation:   N = n² points on the light; RMSE: root mean square error of radiance [W m⁻² sr⁻¹].
//! Predict:    100 shadow rays a pixel instead of one: how much longer does it take, how much better is it?
//! Figure:     03_first_picture_shadow_error_time.svg

use glam::{DVec3, dvec2, dvec3};
use lightbench::color::{Rgb, srgb_encode};
use lightbench::film::{Image, metric::compare};
use lightbench::integrator::{Integrator, Local, Stage};
use lightbench::kit::figure::{
    self, Axis, Chart, Diagram, ErrorPanel, Figure, Guide, Panels, Pixels, Shades, Table,
};
use lightbench::kit::lesson::{Lesson, LessonError, Result};
use lightbench::light::{Light, Placement, Placement::Grid, Placement::Jittered};
use lightbench::measure::{Method, Point, Series, Slope, Tally, Z, log_slope, quantised, timed};
use lightbench::ray::{Ray, Silent, Trace};
use lightbench::render::{Picture, render};
use lightbench::sample::Sampler;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::scene_file::{Color, read};
use lightbench::shape::{Shape, sphere::Sphere};
use std::fmt::Display;

const AREA: &str = include_str!("../scenes/d01_boxes_spheres.scene");
const POINT: &str = include_str!("../scenes/d01_point_light.scene");
const D_SECONDS: [f64; 2] = [0.1981, 0.5203]; // point light, 10 × 10 points; 512 × 512 pixels, GTX 560 [D §6]
const AMBIENT: f64 = 0.05; // W/(m² sr), in every picture but D's own
const RUNS: u32 = 5; // of each timed picture, each with its own seed
const SIDES: [u32; 6] = [1, 2, 3, 5, 10, 20]; // points along the light's side
const TRUTH: u32 = 71; // the same of the truth: a prime, so that few of its points are a contestant's
const SIZES: [(&str, f64); 9] = [
    ("10⁻¹²", 1.0e-12),
    ("10⁻⁶", 1.0e-6),
    ("10⁻⁴", 1.0e-4),
    ("10⁻³", 1.0e-3),
    ("10⁻²", 1.0e-2),
    ("1", 1.0),
    ("10⁶", 1.0e6),
    ("10¹²", 1.0e12),
    ("10¹³", 1.0e13),
];
const BIAS: f64 = 1.0e-4; // m
const ERROR: &str = "error of radiance, RMSE [W m⁻² sr⁻¹]";

/// A stage: its name, how far it goes, and n of its n × n light points.
struct Way(&'static str, Stage, u32, Placement);
const WAYS: [Way; 5] = [
    Way("visibility only", Stage::Visibility, 1, Grid),
    Way("Lambert + ambient", Stage::Unshadowed, 1, Grid),
    Way("hard shadows, 1 point", Stage::Shadowed, 1, Grid),
    Way("soft shadows, 10 × 10 grid", Stage::Shadowed, 10, Grid),
    Way("soft shadows, 10 × 10 jittered", Stage::Shadowed, 10, Jittered),
];

/// What a picture took and how far it is off; shape tests a pixel.
type Measured = (Point, f64);
/// Radiance at places on a line.
type Line = Vec<(f64, f64)>;

fn main() -> Result {
    let lesson = Lesson::open(3)?;
    let (flags, [big, side]) = (lesson.flags(), lesson.pick([[96, 24], [512, 80], [512, 160], [1024, 240]]));
    let size = |px: Option<u16>| px.map_or(big, usize::from);
    let samples = flags.spp.map_or(1, u32::from);
    let shown =
        Picture { width: size(flags.width), height: size(flags.height), samples, seed: lesson.seed() };
    // One side odd: no pixel's centre lies on a diagonal, where two walls meet and rounding decides.
    let small = Picture { width: side, height: side + 1, samples: 1, ..shown };

    // 1. The truth: soft shadows of 71 × 71 light points, on a picture and on a line; the room in its own size.
    let truth = shoot(&soft(TRUTH, Grid), small)?;
    let exact = wall(&soft(TRUTH, Grid), shown.seed)?;
    let room_truth = render(&room(POINT)?, &Local::default(), small).image;

    // 2. The contestants: five stages, two ways to place light points, two ways to leave a surface.
    let stages = measured(&WAYS, small, &truth)?;
    let ways: Vec<Way> = [Grid, Jittered].iter().flat_map(|p| SIDES.map(|n| soft(n, *p))).collect();
    let points: Vec<Point> = measured(&ways, small, &truth)?.into_iter().map(|m| m.0).collect();
    let sweeps = [0, SIDES.len()].map(|i| Series::new(points[i..i + SIDES.len()].to_vec()));
    let lines = [wall(&soft(5, Grid), shown.seed)?, wall(&soft(5, Jittered), shown.seed)?];
    let errors = lines.map(|l| l.iter().zip(&exact).map(|(a, b)| (a.0, a.1 - b.1)).collect::<Line>());
    let changes = SIZES.map(|(_, size)| changes(size, small, &room_truth));
    let changes = changes.into_iter().collect::<Result<Vec<_>>>()?;

    // 3. The figures.
    lesson.save("after_the_hit", after_the_hit()?)?;
    documents(&lesson, shown)?;
    lesson.save("stages", panels(Picture { width: 18 * side / 5, height: 3 * side + 1, ..small })?)?;
    lesson.save("costs", costs(&stages, small))?;
    let headline = Chart::speed_accuracy(ERROR).x(Axis::time("time per picture"));
    lesson.save(
        "shadow_error",
        shadows(headline.title(&grid_or_jittered(&sweeps)), &sweeps, |p| p.time.map_or(f64::NAN, |t| t.mid)),
    )?;
    let counted = Chart::error_over(Axis::log("light points N"), ERROR);
    lesson.save(
        "shadow_points",
        shadows(
            counted.title("Errors fall as N to the −¾, where independent points give −½"),
            &sweeps,
            |p| p.parameter,
        ),
    )?;
    lesson.save("penumbra", penumbra(&errors))?;
    lesson.save("sizes", sizes(&changes))?;

    // 4. What the figures show, checked.
    claims(&lesson, &sweeps, &errors, &changes, small);
    lesson.say(&times(&stages));
    lesson.answer(&answer(&stages))
}

fn soft(n: u32, placement: Placement) -> Way {
    Way("", Stage::Shadowed, n, placement)
}

fn room(text: &str) -> Result<Scene> {
    Ok(read(text, "scene 1").map_err(|e| LessonError::Other(e.render(Color::Never)))?.scene)
}

/// Scene 1 under n × n light points, and ambient light.
fn lit(way: &Way) -> Result<Scene> {
    let mut scene = room(AREA)?;
    scene.ambient = Rgb::splat(AMBIENT);
    for light in &mut scene.lights {
        if let Light::Area(area) = light {
            *area = area.subdivided(way.2, way.2, way.3);
        }
    }
    Ok(scene)
}

fn shoot(way: &Way, picture: Picture) -> Result<Image> {
    Ok(render(&lit(way)?, &Local { stage: way.1, ..Local::default() }, picture).image)
}

/// Every run takes all ways in turn, so that a busy moment of the machine favours none.
fn measured(ways: &[Way], picture: Picture, truth: &Image) -> Result<Vec<Measured>> {
    let scenes = ways.iter().map(lit).collect::<Result<Vec<_>>>()?;
    let pixels = (picture.width * picture.height) as f64;
    let mut found = vec![(Tally::new(), 0.0, 0.0); ways.len()];
    for run in 0..RUNS {
        let picture = Picture { seed: picture.seed.wrapping_add(run.into()), ..picture };
        for ((way, scene), (runs, rays, tests)) in ways.iter().zip(&scenes).zip(&mut found) {
            let (seconds, done) =
                timed(|| render(scene, &Local { stage: way.1, ..Local::default() }, picture));
            runs.timed_answer(seconds, compare(&done.image, truth).rmse, 0.0);
            (*rays, *tests) =
                (done.tally.total_rays() as f64 / pixels, done.tally.shape_tests as f64 / pixels);
        }
    }
    let points = ways.iter().zip(found);
    Ok(points
        .map(|(w, (runs, rays, tests))| (runs.rms_at(f64::from(w.2 * w.2)).worked(rays), tests))
        .collect())
}

/// Red radiance over x [m] on the back wall, along a level line across the shadow of the middle sphere.
fn wall(way: &Way, seed: u64) -> Result<Line> {
    let mut scene = lit(way)?;
    let view = FieldOfView::Horizontal(0.085);
    scene.camera =
        Camera::new(scene.camera.position(), dvec3(-3.72, 5.0, -5.0), DVec3::Y, view).map_err(other)?;
    let picture = Picture { width: 400, height: 1, samples: 1, seed };
    let image = render(&scene, &Local::default(), picture).image;
    let place = |i: usize| {
        let ray = scene.camera.ray(dvec2(i as f64 + 0.5, 0.5), picture.width, 1);
        scene.nearest(&ray, f64::INFINITY, &mut Silent).map_or(f64::NAN, |(_, c)| ray.at(c.t).x)
    };
    Ok((0..picture.width).map(|i| (place(i), image.get(i, 0).x)).collect())
}

/// Correlation of the errors of neighbours, and its standard deviation if they are independent.
fn neighbours(errors: &Line) -> (f64, f64) {
    let products = errors.windows(2).map(|w| w[0].1 * w[1].1);
    let squares: f64 = errors.iter().map(|e| e.1 * e.1).sum();
    (products.clone().sum::<f64>() / squares, products.map(|p| p * p).sum::<f64>().sqrt() / squares)
}

/// The largest change of radiance and the share of pixels that change visibly, where every length of the room is
/// multiplied: with the library's origins, and with a fixed bias.
fn changes(size: f64, picture: Picture, truth: &Image) -> Result<[(f64, f64); 2]> {
    const LENGTHS: [&str; 7] = ["POV", "POI", "Center", "Radius", "Scale", "Translation", "Position"];
    let line = |line: &str| match line.trim().split_once(' ') {
        Some((name, numbers)) if LENGTHS.contains(&name) => {
            let number = |x: &str| x.parse().map_or(x.to_string(), |x: f64| format!("{:e}", x * size));
            format!("{name} {}", numbers.split(' ').map(number).collect::<Vec<_>>().join(" "))
        }
        _ => line.to_string(),
    };
    let scene = room(&POINT.lines().map(line).collect::<Vec<_>>().join("\n"))?;
    let change = |image: Image| {
        let visible = |(p, q): &(&Rgb, &Rgb)| (**p - **q).abs().max_element() > quantised() / 255.0;
        let count = image.pixels().iter().zip(truth.pixels()).filter(visible).count();
        (compare(&image, truth).max_error.abs(), count as f64 / image.pixels().len() as f64)
    };
    let ours = render(&scene, &Local::default(), picture).image;
    Ok([change(ours), change(render(&scene, &NaiveBias, picture).image)])
}

/// Hard shadows whose rays start a fixed distance off the surface: **wrong** in rooms of another size.
struct NaiveBias;

impl Integrator for NaiveBias {
    type Scratch = ();
    fn scratch(&self, _: &Scene) {}
    fn radiance<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        _: &mut Sampler,
        _: &mut (),
        trace: &mut T,
    ) -> Rgb {
        let Some((object, crossing)) = scene.nearest(ray, f64::INFINITY, trace) else {
            return scene.background;
        };
        let hit = scene.hit(ray, object, &crossing);
        let origin = hit.point + hit.ng * BIAS;
        let Some(Light::Point(light)) = scene.lights.first() else { return Rgb::ZERO };
        let to = light.position - origin;
        if scene.blocker(&Ray::new(origin, to), 1.0, trace).is_some() {
            return Rgb::ZERO;
        }
        scene.materials[scene.objects[object].material].diffuse
            * light.power
            * (hit.ng.dot(to) / to.length()).max(0.0)
    }
}

fn after_the_hit() -> Result<Figure> {
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

fn other(e: impl Display) -> LessonError {
    LessonError::Other(e.to_string())
}

/// The documents' pictures: a sphere by visibility only, scene 1 with its area light and with its point light.
fn documents(lesson: &Lesson, picture: Picture) -> Result {
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

/// Linear radiance as a display shows it.
fn pixels(image: &Image) -> Pixels {
    let byte = |x: f64| (srgb_encode(x.clamp(0.0, 1.0)) * 255.0).round() as u8;
    let rgb = image.pixels().iter().flat_map(|p| p.to_array().map(byte)).collect();
    Pixels::new(image.width(), image.height(), rgb)
}

fn panels(picture: Picture) -> Result<Figure> {
    let truth = shoot(&soft(31, Grid), picture)?;
    let mut panels = Panels::new().columns(3);
    for way in &WAYS[..4] {
        panels = panels.picture(pixels(&shoot(way, picture)?), way.0);
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
        .picture(pixels(&truth), "soft, 31 × 31 grid: the truth")
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
fn costs(stages: &[Measured], picture: Picture) -> Table {
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

fn rmse(point: &Point) -> f64 {
    point.error.map_or(f64::NAN, |e| e.mid)
}

/// Median time [s].
fn mid(stages: &[Measured], i: usize) -> f64 {
    stages[i].0.time.map_or(f64::NAN, |t| t.mid)
}

fn shadows(chart: Chart, [grid, jittered]: &[Series; 2], x: fn(&Point) -> f64) -> Figure {
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

fn grid_or_jittered([grid, jittered]: &[Series; 2]) -> String {
    let ratio = rmse(&jittered.points[4]) / rmse(&grid.points[4]);
    format!("At 100 light points the grid errs {ratio:.1} times less than jittered points")
}

fn penumbra(errors: &[Line; 2]) -> Figure {
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

fn sizes(changes: &[[(f64, f64); 2]]) -> Table {
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

fn claims(
    lesson: &Lesson,
    sweeps: &[Series; 2],
    errors: &[Line; 2],
    changes: &[[(f64, f64); 2]],
    picture: Picture,
) {
    let independent = RUNS * (picture.width * picture.height) as u32;
    let slopes = sweeps.each_ref().map(|s| log_slope(s, independent));
    let steep = |s: &Slope| s.value + Z * s.sigma < -0.5 && s.value - Z * s.sigma > -1.0;
    let [grid, jittered] = slopes.map(|s| -s.value);
    let sentence = format!(
        "one light point in each cell beats independent points: errors fall as N to the −{grid:.2} on a grid and \
         −{jittered:.2} jittered, faster than −½ and slower than −1"
    );
    lesson.claim(&sentence, slopes.iter().all(steep));
    let [steps, noise] = errors.each_ref().map(neighbours);
    let sentence = format!(
        "the grid's errors are steps, the jittered points' are noise: those of neighbours correlate by {:.2} and {:.2}",
        steps.0, noise.0
    );
    lesson.claim(&sentence, steps.0 > 0.5 && noise.0.abs() <= Z * noise.1);
    let worst = changes.iter().map(|[ours, _]| ours.0).fold(0.0, f64::max);
    let sentence =
        format!("a room 10⁻¹² or 10¹³ times as large looks the same: no radiance changes by {worst:.0e}");
    lesson.claim(&sentence, worst <= quantised() / 255.0);
}

fn times(stages: &[Measured]) -> String {
    let ratio = |i: usize| mid(stages, i) / mid(stages, 2);
    format!(
        "D says that 100 rays more do not cost 100 times the time, and measured {:.1} times. This run: {:.1} times on \
         the grid, {:.1} times jittered, whose points are new for each pixel. Most rays meet no test of their own: a \
         bundle that stays clear of an object is dismissed as one.",
        D_SECONDS[1] / D_SECONDS[0],
        ratio(3),
        ratio(4)
    )
}

fn answer(stages: &[Measured]) -> String {
    let (error, rays) = (|i: usize| rmse(&stages[i].0), |i: usize| stages[i].0.work.unwrap_or(f64::NAN));
    format!(
        "Visibility costs 1 ray and {:.1} shape tests a pixel and leaves an error (RMSE) of {:.2}; Lambert's law and \
         ambient light cost no ray more and leave {:.2}; hard shadows cost {:.2} rays and {:.1} tests in all and \
         leave {:.3}; soft shadows of 10 × 10 light points cost {:.1} rays, yet only {:.1} tests, and leave {:.4}: {:.0} times \
         less error than hard ones for {:.1} times the tests.",
        stages[0].1,
        error(0),
        error(1),
        rays(2),
        stages[2].1,
        error(2),
        rays(3),
        stages[3].1,
        error(3),
        error(2) / error(3),
        stages[3].1 / stages[2].1
    )
}
