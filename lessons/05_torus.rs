//! Lesson 05. Which quartic solver should a torus use?
//!
//! Builds on:  02 (moving the origin saves the quadratic), 03 (shadow rays start on surfaces).
//! New here:   the torus; the quartic and its solvers; missed and false roots as results; certified signs.
//! Notation:   a radius of the ring, b of the tube [m]; D distance of the ray's origin; t ray parameter [m].
//! Predict:    a ring is seen from 3000 ring radii. What share of its roots does the printed quartic keep?
//! Figure:     05_torus_speed_accuracy_time.svg

use lightbench::measure::{Method, Point, Series, Tally, log_spaced, time_each};
use lightbench::num::U;
use lightbench::shape::Shape;
use lightbench::shape::torus::TorusMethod;
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, Result};

#[path = "05_torus/figures.rs"]
mod figures;
#[path = "05_torus/hole.rs"]
mod hole;
#[path = "05_torus/map.rs"]
mod map;
#[path = "05_torus/rays.rs"]
mod rays;
#[path = "05_torus/shadows.rs"]
mod shadows;
use rays::{Aim, Question, crossings, mixed, question, turns};

/// Every method with its measurements.
type Contest = [(Method, Series); 8];

const RING: f64 = 2.0; // m; the printed solver has thresholds with units, so the scale is part of the question
const RATIO: std::ops::Range<f64> = 1.0e-4..0.99; // b/a
const DISTANCE: std::ops::Range<f64> = 4.0..1.0e4; // D/a: outside the torus, which ends before 2 a
const GRAZE: std::ops::Range<f64> = 1.0e-12..0.1; // depth of a ray that grazes [b]
const CLOSE: f64 = 1.0e-11; // depth [b] of grazing rays in the map and over b/a
const PLAIN: (f64, f64) = (0.3, 10.0); // b/a and D/a where another parameter is swept

fn main() -> Result {
    let lesson = Lesson::without_essay(5)?;
    let (seed, rays) = (lesson.seed(), lesson.pick([48, 512, 2048, 8192]));

    // 1. The truth: signs with 106 bits and bisection, slow and apart from all contestants.
    lesson.save("cross_section", figures::cross_section())?;
    let hard: Vec<Question> = (0..rays).map(|i| mixed(seed, i)).collect();

    // 2. The contestants: eight ways to the roots of one quartic.
    let contest = TorusMethod::ALL.map(|m| (figures::method(m), m));
    let speed =
        contest.clone().map(|(name, m)| (name, Series::new(vec![timed(measured(&hard, m, 1.0), &hard, m)])));
    let over = |values: &[f64], ask: &dyn Fn(u32, f64) -> Question| -> Contest {
        let set = |x: &f64| (*x, (0..rays / 2).map(|i| ask(i, *x)).collect());
        let sets: Vec<(f64, Vec<Question>)> = values.iter().map(set).collect();
        let series = |m| Series::new(sets.iter().map(|(x, set)| measured(set, m, *x)).collect());
        contest.clone().map(|(name, m)| (name, series(m)))
    };
    let steps = |r: std::ops::Range<f64>| log_spaced(r.start, r.end, 8);
    let far = over(&steps(DISTANCE), &|i, x| question(seed, i, (PLAIN.0, x), Aim::Through));
    let thin = over(&steps(RATIO), &|i, x| question(seed, i, (x, PLAIN.1), turns(i, CLOSE)));
    let graze = over(&steps(GRAZE), &|i, x| question(seed, i, (1.0e-3, PLAIN.1), Aim::Grazing(x)));

    // 3. The figures.
    lesson.save("speed_accuracy", figures::speed(&speed, rays))?;
    lesson.save("contest", figures::contest(&speed))?;
    lesson.save("distance", figures::distance(&far))?;
    lesson.save("thin", figures::thin(&thin))?;
    lesson.save("grazing", figures::grazing(&graze))?;
    let cells = map::cells(&lesson);
    for method in TorusMethod::ALL {
        lesson.save(&format!("failures_{}", method.name()), map::failures(&cells, method))?;
    }
    let segments = shadows::segments(seed, rays);
    let cost: Vec<_> = contest.iter().map(|(name, m)| (name.clone(), shadows::time(&segments, *m))).collect();
    lesson.save("shadow_rays", figures::shadow_rays(&cost))?;
    let hole = hole::from_the_hole();
    let lost = hole::lost_by_testcull(seed, rays);
    lesson.save("testcull", figures::testcull(&hole))?;
    lesson.save("as_printed", figures::as_printed(&hole, lost))?;
    figures::pictures(&lesson)?;

    // 4. What the figures show, checked.
    claims(&lesson, [&speed, &far, &thin, &graze], &hole, lost);
    lesson.answer(&answer(&speed))
}

fn measured(questions: &[Question], method: TorusMethod, parameter: f64) -> Point {
    let mut tally = Tally::new();
    questions.iter().for_each(|q| q.judge(&mut tally, &crossings(&q.torus.with_method(method), &q.ray)));
    tally.rms_at(parameter)
}

/// With the time to the nearest root of all of them, which is what a picture asks for.
fn timed(point: Point, questions: &[Question], method: TorusMethod) -> Point {
    let tori: Vec<_> = questions.iter().take(256).map(|q| (q.torus.with_method(method), q.ray)).collect();
    point.timed(time_each(tori.len(), || {
        tori.iter().filter_map(|(t, r)| t.nearest(r, 0.0, f64::INFINITY)).count()
    }))
}

fn claims(lesson: &Lesson, sweeps: [&Contest; 4], hole: &hole::Hole, lost: [usize; 2]) {
    let all = |k: usize| sweeps.map(|s| s[k].1.failures());
    let sum = |k: usize| all(k).iter().fold((0, 0), |(n, of), f| (n + f.total(), of + f.of));
    lesson.claim(
        &format!(
            "Of {} roots the default misses none and invents none; as printed fails {} times.",
            sum(0).1,
            sum(1).0
        ),
        sum(0).0 == 0 && sum(1).0 > 0,
    );
    // The truth is one of two neighbours of the root; the default promises two roundings, u each, of t ≤ D + 2 a.
    let near = |p: &Point| p.error.is_some_and(|e| e.mid <= 4.0 * U * (p.parameter + 2.0));
    lesson.claim(
        "From every distance D the default errs by less than 4 roundings of D + 2 a.",
        sweeps[1][0].1.points.iter().all(near),
    );
    lesson.claim(
        &format!(
            "From the hole of the torus (2, 0.6) the printed testcull loses {} of {} hits.",
            lost[0], lost[1]
        ),
        hole.culled.is_none() && hole.truth.len() == 2 && lost[0] > 0,
    );
}

fn answer(speed: &Contest) -> String {
    let said = |k: usize| {
        let p = &speed[k].1.points[0];
        (p.time.map_or(f64::NAN, |t| t.mid * 1e9), p.failures.total(), p.error.map_or(f64::NAN, |e| e.mid))
    };
    let others = 1..8;
    let fastest = others.min_by(|&i, &j| said(i).0.total_cmp(&said(j).0)).unwrap_or(1);
    let ((time, failures, error), (other, lost, off)) = (said(0), said(fastest));
    format!(
        "the certified one: {failures} roots missed or false and an error of {} a for {time:.0} ns a ray; the fastest of \
         the others, {}, takes {other:.0} ns, fails {lost} times and errs by {} a. The difference buys every root.",
        short(error),
        TorusMethod::ALL[fastest].name(),
        short(off)
    )
}
