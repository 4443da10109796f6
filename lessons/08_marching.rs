//! Lesson 08. When may a ray leap, how far, and what does it miss?
//!
//! Builds on:  02 (a ray meets a sphere), 05 (a surface of degree four), 06 (cylinders and cones).
//! New here:   distance fields and their Lipschitz bound; marching, its strides and its tolerance; the Menger sponge.
//! Notation:   f field [m], L its steepest slope, r = |f|/L radius of the free ball; τ tolerance, ε accuracy as printed [m].
//! Predict:    a field is twice as steep as a distance, and a ray leaps by all of it. What share of the pixels is wrong?
//! Figure:     08_marching_speed_accuracy_time.svg

use lightbench::measure::{Failures, Method, Point, Series, Spread, log_spaced, time_each};
use lightbench::ray::Ray;
use lightbench_kit::figure::{grouped, short};
use lightbench_kit::lesson::{Lesson, Result};

#[path = "08_marching/contestant.rs"]
mod contestant;
#[path = "08_marching/figures.rs"]
mod figures;
#[path = "08_marching/general.rs"]
mod general;
#[path = "08_marching/pictures.rs"]
mod pictures;
#[path = "08_marching/sponge.rs"]
mod sponge;
#[path = "08_marching/spread.rs"]
mod spread;
#[path = "08_marching/stage.rs"]
mod stage;
#[path = "08_marching/trouble.rs"]
mod trouble;
use contestant::{Contestant, is_wrong};
use stage::Stage;

/// Every method with its measurements.
type Contest = Vec<(Method, Series)>;

const FAR: f64 = 40.0; // m; no ray is followed farther
const MOST_STEPS: u32 = 256; // of the printed march
const WRONG: f64 = 1.0e-3; // share of the distance by which a pixel may be off: a third of a pixel's width
const STEEP: std::ops::Range<f64> = 0.005..0.2; // m; amplitudes of the ripples
const RIPPLES: f64 = 20.0; // rad/m

fn main() -> Result {
    let lesson = Lesson::without_essay(8)?;
    let width = lesson.pick([24, 72, 120, 200]);

    // 1. The truth: the same shapes by their formulas.
    let stage = Stage::new(stage::HOME);
    let rays = stage.view(width, stage::FROM_ABOVE);
    let truth: Vec<_> = rays.iter().map(|r| stage.by_formula(r)).collect();
    lesson.save("steps", figures::steps())?;
    general::show(&lesson)?;

    // 2. The contestants: the march as printed and three strides, over what they call near enough.
    let accuracies = log_spaced(1.0e-1, 1.0e-7, lesson.pick([3, 7, 7, 13]));
    let contest: Contest = Contestant::ALL
        .iter()
        .map(|c| {
            let point = |x| measured(&rays, &truth, x, |r| c.ask(&stage.field, r, x));
            (c.method(), Series::over(&accuracies, point))
        })
        .collect();
    let formula = measured(&rays, &truth, 1.0, |r| (stage.by_formula(r), 1));
    let trouble = trouble::Trouble::measured(&lesson);
    let sponge = sponge::contest(&lesson);

    // 3. The figures.
    lesson.save("speed_accuracy", figures::speed(&contest, &formula, rays.len()))?;
    lesson.save("work_accuracy", figures::work(&contest, rays.len()))?;
    trouble.show(&lesson)?;
    spread::show(&lesson)?;
    sponge::show(&lesson, &sponge)?;
    pictures::show(&lesson)?;

    // 4. What the figures show, checked.
    let best = |k: usize| contest[k].1.points.last().cloned().unwrap_or_default();
    let (printed, plain, enhanced) = (best(0), best(1), best(3));
    lesson.claim(
        &format!(
            "At the finest tolerance the three strides answer {} of {} pixels as the formulas do.",
            grouped(enhanced.failures.of - enhanced.failures.total()),
            grouped(enhanced.failures.of)
        ),
        (1..4).all(|k| best(k).failures.total() == 0),
    );
    let ([leapt, divided], of) = trouble.steepest();
    lesson.claim(
        &format!("Leaping by the whole of a field five times too steep loses {leapt} of {of} pixels; divided by its bound, {divided}."),
        divided == 0 && leapt > 0,
    );
    lesson.claim(
        &format!(
            "Walked through its grid or marched through its field, the sponge is the same in all {} rays.",
            sponge.of()
        ),
        sponge.wrong() == 0,
    );
    let work = |p: &Point| p.work.unwrap_or(f64::NAN);
    lesson.answer(&format!(
        "by the distance over the steepest slope, safely; by more if the free balls are seen to touch: {:.1} evaluations a ray \
         by enhanced strides, {:.1} by plain ones and {:.1} as printed, which gets {} of {} pixels wrong for want of steps; \
         what it misses is shallower than the tolerance of {} m. Where there is a formula, it takes {} of the time.",
        work(&enhanced),
        work(&plain),
        work(&printed),
        printed.failures.total(),
        printed.failures.of,
        short(enhanced.parameter),
        figures::ratio(&formula, &enhanced),
    ))
}

/// Share of wrong pixels, evaluations and time per ray.
fn measured(
    rays: &[Ray],
    truth: &[Option<f64>],
    parameter: f64,
    ask: impl Fn(&Ray) -> (Option<f64>, u32),
) -> Point {
    let mut failures = Failures { of: rays.len() as u64, ..Failures::default() };
    let mut evaluations = 0u64;
    for (ray, truth) in rays.iter().zip(truth) {
        let (found, steps) = ask(ray);
        evaluations += u64::from(steps);
        let wrong = u64::from(is_wrong(found, *truth));
        if found.is_some() { failures.false_hits += wrong } else { failures.missed += wrong }
    }
    let some: Vec<Ray> = rays.iter().step_by(rays.len().div_ceil(128)).copied().collect();
    let time = time_each(some.len(), || some.iter().filter(|r| ask(r).0.is_some()).count());
    let point = Point::at(parameter).timed(time).worked(evaluations as f64 / rays.len() as f64);
    Point { failures, ..point.erred(Spread::exact(failures.share())) }
}
