//! What the steps look like: heat maps, holes, and normals.

use super::contestant::Contestant;
use super::stage::{FROM_ABOVE, HOME, Stage, picture};
use super::trouble::{hull, planet};
use super::{FAR, STEEP};
use glam::{DVec2, DVec3, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::measure::{Method, log_spaced};
use lightbench::ray::Ray;
use lightbench::sample::r2;
use lightbench::scene::{Camera, FieldOfView};
use lightbench::sdf::printed::AsPrinted;
use lightbench::sdf::{DistanceField, March, Stride, central_difference};
use lightbench::shape::Shape;
use lightbench::shape::torus::Torus;
use lightbench_kit::figure::colormap::viridis;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Panels, Pixels, Shades, short};
use lightbench_kit::lesson::{Lesson, Result};

/// Ends of the colour scale [evaluations].
const FEW: f64 = 4.0;
const MANY: f64 = 160.0;

pub fn show(lesson: &Lesson) -> Result {
    let width = lesson.pick([24, 240, 420, 840]);
    heat(lesson, width)?;
    strides(lesson, width)?;
    holes(lesson, lesson.pick([15, 180, 300, 600]))?;
    lesson.save("normals", normals(lesson))
}

/// Evaluations of each ray of the still life.
fn counts(stage: &Stage, width: usize, stride: Stride) -> Vec<f64> {
    let ask = |r: &Ray| Contestant::Marching(stride).ask(&stage.field, r, 1.0e-5).1;
    stage.view(width, FROM_ABOVE).iter().map(|r| f64::from(ask(r))).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The default's steps with a scale.
fn heat(lesson: &Lesson, width: usize) -> Result {
    let (stage, height) = (Stage::new(HOME), width * 2 / 3);
    let counts = counts(&stage, width, Stride::Plain);
    let axis = |word: &str, n: usize| Axis::linear(word).range(0.0, n as f64);
    let cell = |x: f64, y: f64| {
        let (column, row) = (x as usize, height - 1 - (y as usize).min(height - 1));
        counts.get(row * width + column).copied()
    };
    let map = FailureMap::new(
        axis("column, pixels", width),
        axis("row, pixels", height),
        "evaluations",
        (width, height),
        cell,
    )
    .shades(Shades::Decades)
    .range(FEW, MANY)
    .title(&format!(
        "Rays that graze take the steps: {:.0} on average, {:.0} at most",
        mean(&counts),
        max(&counts)
    ))
    .subtitle("evaluations of the field for each camera ray of the still life; plain strides, τ = 10⁻⁵ m");
    lesson.save("heat", Figure::from(map).alt(
        "Heat map of a still life: sphere, ring, box, cylinder and cone are dark; their outlines and the far floor glow.",
    ).caption(
        "Steps of each ray. Where a ray passes close to an edge the free balls are small, and every outline glows; towards the horizon \
         the floor comes near too slowly.",
    ))
}

fn max(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn strides(lesson: &Lesson, width: usize) -> Result {
    let stage = Stage::new(HOME);
    let all = Stride::ALL.map(|s| (s, counts(&stage, width, s)));
    let mut panels = Panels::new()
        .columns(3)
        .title(&format!(
            "Enhanced strides need {:.0} evaluations where plain ones need {:.0}",
            mean(&all[2].1),
            mean(&all[0].1)
        ))
        .subtitle(&format!(
            "evaluations of the field a ray, on a logarithm from dark ({FEW}) to yellow ({MANY})"
        ));
    for (stride, counts) in &all {
        let shade = |n: &f64| viridis((n / FEW).ln() / (MANY / FEW).ln());
        let pixels = Pixels::new(width, width * 2 / 3, counts.iter().flat_map(shade).collect());
        panels = panels.picture(pixels, &format!("{}, {:.1} a ray", stride.name(), mean(counts)));
    }
    let alt =
        "Three heat maps of the same still life; outlines glow in all, the floor darkens from left to right.";
    lesson.save("strides", Figure::from(panels.alt(alt)).caption(
        "The same rays by plain, over-relaxed and enhanced strides, polishing of the root included. The pixels' colours are the same.",
    ))
}

/// A planet with ripples, lit from the upper left; `found` is the distance to its surface.
fn lit(width: usize, amplitude: f64, found: impl Fn(&Ray) -> Option<f64>) -> Pixels {
    let (field, hull) = (planet(amplitude), hull(amplitude));
    let camera = Camera::new(dvec3(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, FieldOfView::Vertical(0.54));
    let rays = picture(&camera.expect("an eye and another point"), width);
    let light = dvec3(-0.5, 0.7, 0.6).normalize();
    let near = |ray: &Ray| hull.nearest(ray, 0.0, FAR).and_then(|_| found(ray)).filter(|t| *t < FAR);
    let shade = |ray: &Ray| match near(ray) {
        None => dvec3(0.80, 0.86, 0.92),
        Some(t) => {
            let p = ray.at(t);
            let n = field.gradient(p).normalize_or(DVec3::Y);
            // A place that is no surface has the colour of nothing that is on the planet.
            let off = field.distance(p).abs() > 0.01;
            let albedo: Rgb = if off { dvec3(0.75, 0.05, 0.25) } else { dvec3(0.75, 0.52, 0.28) };
            albedo * (0.18 + 0.82 * n.dot(light).max(0.0))
        }
    };
    Pixels::from(&Image::from_pixels(width, width * 2 / 3, rays.iter().map(shade).collect()))
}

fn holes(lesson: &Lesson, width: usize) -> Result {
    let amplitude = STEEP.end;
    let field = planet(amplitude);
    let printed = |part: f64| {
        let march = AsPrinted::new(1.0e-4, 1000).with_share(part);
        lit(width, amplitude, |r| march.intersect(&[&field], r).0.map(|h| h.0))
    };
    let ours = lit(width, amplitude, |r| March::through(&field).first(&field, r, 0.0, FAR).distance);
    let shots = [
        ("as printed", printed(1.0)),
        ("half of each step", printed(0.5)),
        ("divided by its bound", ours.clone()),
    ];
    let mut panels = Panels::new()
        .columns(3)
        .title("A field of slope 5 is divided by 5, or leapt through")
        .subtitle(&format!(
            "unit sphere + {} sin 20x sin 20y sin 20z; percentages: pixels unlike the last picture's",
            short(amplitude)
        ))
        .alt("Three pictures of a knobbly sphere: the first torn to a lattice, the second with frayed knobs, the third whole.");
    for (name, pixels) in shots {
        let unlike = pixels.rgb.chunks(3).zip(ours.rgb.chunks(3)).filter(|(a, b)| differ(a, b)).count();
        let share = 100.0 * unlike as f64 / (ours.width * ours.height) as f64;
        panels = panels.picture(pixels, &format!("{name}: {share:.1} %"));
    }
    lesson.save("holes", Figure::from(panels).caption(
        "What a field does that is steeper than a distance. Whole steps leap into and through the knobs; half steps, on trust, lose some; \
         divided by the Lipschitz bound every knob is there.",
    ))
}

/// Do two colours differ by more than what an accuracy of 0.1 mm does to the normal: a tenth of the scale?
fn differ(a: &[u8], b: &[u8]) -> bool {
    a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 25)
}

/// Error of the normal over the step of the difference.
fn normals(lesson: &Lesson) -> Figure {
    let torus = Torus::new(0.8, 0.25).expect("a ring");
    let places = lesson.pick([64, 500, 2000, 8000]);
    let error = |h: f64| {
        let each = (0..places).map(|i| {
            let p = torus.point_at(0, r2(lesson.seed(), i));
            let rho = DVec2::new(p.x, p.y).length();
            let truth = (p - dvec3(p.x, p.y, 0.0) * (0.8 / rho)).normalize_or(DVec3::X);
            (central_difference(&torus, p, h).normalize_or(DVec3::X) - truth).length()
        });
        each.fold(0.0, f64::max)
    };
    let steps = log_spaced(1.0e-14, 1.0e-1, lesson.pick([14, 53, 105, 209]));
    let points: Vec<(f64, f64)> = steps.iter().map(|h| (*h, error(*h))).collect();
    let ours = 4.8e-6 * torus.detail();
    let chart =
        Chart::new(Axis::log("step h of the difference, m"), Axis::log("error of the normal, rad (worst)"))
            .title(&format!(
                "Between truncation and rounding a central difference keeps {:.0} digits",
                -error(ours).log10()
            ))
            .subtitle(
                "torus (0.8, 0.25) m; (f(p + h) − f(p − h))/2h along each axis; truth: the normal's formula",
            )
            .function(Method::default_of("central difference").styled(0), &points)
            .guide(Guide::upright(ours, "h = ∛u · detail"))
            .guide(Guide::slope_through(2.0, 1.0e-2, 0.5 * (1.0e-2f64 / 0.25).powi(2), "h²"))
            .guide(Guide::slope_through(-1.0, 1.0e-12, f64::EPSILON / 1.0e-12, "u/h"));
    Figure::from(chart).caption(
        "Normals by the gradient of the field: long steps see the curvature, short ones the rounding of the field's values.",
    )
}
