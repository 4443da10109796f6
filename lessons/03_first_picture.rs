//! Lesson 03. What does each stage of a first picture cost, and what does it buy?
//!
//! Builds on:  01 (a pixel becomes a ray), 02 (a ray meets a sphere).
//! New here:   what is known after a hit; Lambert's law; shadow rays; a light of n × n points; a safe origin.
//! Notation:   N = n² points on the light; RMSE: root mean square error of radiance [W m⁻² sr⁻¹].
//! Predict:    100 shadow rays a pixel instead of one: how much longer does it take, how much better is it?
//! Figure:     03_first_picture_shadow_error_time.svg

#[path = "03_first_picture/experiment.rs"]
mod experiment;
#[path = "03_first_picture/figures.rs"]
mod figures;

use experiment::{Line, Measured, Way, changes, measured, mid, neighbours, rmse, room, shoot, soft, wall};
use figures::{ERROR, after_the_hit, costs, documents, grid_or_jittered, panels, penumbra, shadows, sizes};
use lightbench::integrator::{Local, Stage};
use lightbench::measure::{Point, Series, Slope, Z, log_slope, quantised};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern::{Centres, Jittered};
use lightbench_kit::figure::{Axis, Chart};
use lightbench_kit::lesson::{Lesson, Result};

const POINT: &str = include_str!("../scenes/d01_point_light.scene");
const D_SECONDS: [f64; 2] = [0.1981, 0.5203]; // point light, 10 × 10 points; 512 × 512 pixels, GTX 560 [D §6]
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
const WAYS: [Way; 5] = [
    Way("visibility only", Stage::Visibility, 1, Centres),
    Way("Lambert + ambient", Stage::Unshadowed, 1, Centres),
    Way("hard shadows, 1 point", Stage::Shadowed, 1, Centres),
    Way("soft shadows, 10 × 10 grid", Stage::Shadowed, 10, Centres),
    Way("soft shadows, 10 × 10 jittered", Stage::Shadowed, 10, Jittered),
];

fn main() -> Result {
    let lesson = Lesson::without_essay(3)?;
    let (flags, [big, side]) = (lesson.flags(), lesson.pick([[96, 24], [512, 80], [512, 160], [1024, 240]]));
    let size = |px: Option<u16>| px.map_or(big, usize::from);
    let samples = flags.spp.map_or(1, u32::from);
    let shown =
        Picture { width: size(flags.width), height: size(flags.height), samples, seed: lesson.seed() };
    // One side odd: no pixel's centre lies on a diagonal, where two walls meet and rounding decides.
    let small = Picture { width: side, height: side + 1, samples: 1, ..shown };

    // 1. The truth: soft shadows of 71 × 71 light points, on a picture and on a line; the room in its own size.
    let truth = shoot(&soft(TRUTH, Centres), small)?;
    let exact = wall(&soft(TRUTH, Centres), shown.seed)?;
    let room_truth = render(&room(POINT)?, &Local::default(), small).image;

    // 2. The contestants: five stages, two ways to place light points, two ways to leave a surface.
    let stages = measured(&WAYS, small, &truth)?;
    let ways: Vec<Way> = [Centres, Jittered].iter().flat_map(|p| SIDES.map(|n| soft(n, *p))).collect();
    let points: Vec<Point> = measured(&ways, small, &truth)?.into_iter().map(|m| m.0).collect();
    let sweeps = [0, SIDES.len()].map(|i| Series::new(points[i..i + SIDES.len()].to_vec()));
    let lines = [wall(&soft(5, Centres), shown.seed)?, wall(&soft(5, Jittered), shown.seed)?];
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
