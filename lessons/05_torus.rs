//! Lesson 05. Which quartic solver should a torus use?
//!
//! Builds on:  02 (moving the origin saves the quadratic), 03 (shadow rays start on surfaces).
//! New here:   the torus; the quartic and its solvers; missed and false roots as results; certified signs.
//! Notation:   a radius of the ring, b of the tube [m]; D distance of the ray's origin; t ray parameter [m].
//! Predict:    a ring is seen from 3000 ring radii. What share of its roots does the printed quartic keep?
//! Figure:     05_torus_speed_accuracy_time.svg

use glam::DVec3;
use lightbench::kit::figure::{Axis, FailureMap, Figure};
use lightbench::kit::lesson::{Lesson, Result};
use lightbench::measure::{Method, Point, Series, Spread, Tally, log_spaced, time_each};
use lightbench::num::U;
use lightbench::ray::Ray;
use lightbench::shape::Shape;
use lightbench::shape::torus::{Torus, TorusMethod};

#[path = "05_torus/figures.rs"]
mod figures;
#[path = "05_torus/hole.rs"]
mod hole;
#[path = "05_torus/rays.rs"]
mod rays;
use figures::sci;
use rays::{Aim, Question, crossings, mixed, question, turns};

/// Every method with its measurements.
type Contest = [(Method, Series); 8];

const RING: f64 = 2.0; // m; the printed solver has thresholds with units, so the scale is part of the question
const RATIO: std::ops::Range<f64> = 1.0e-4..0.99; // b/a
const DISTANCE: std::ops::Range<f64> = 4.0..1.0e4; // D/a: outside the torus, which ends before 2 a
const GRAZE: std::ops::Range<f64> = 1.0e-12..0.1; // depth of a ray that grazes [b]
const CLOSE: f64 = 1.0e-11; // depth [b] of grazing rays in the map and over b/a
const PLAIN: (f64, f64) = (0.3, 10.0); // b/a and D/a where another parameter is swept
const LAMP: DVec3 = DVec3::new(3.0, 9.0, 8.0); // m

fn main() -> Result {
    let lesson = Lesson::open(5)?;
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
    let cells = map_cells(&lesson);
    for method in TorusMethod::ALL {
        lesson.save(&format!("failures_{}", method.name()), failure_map(&cells, method))?;
    }
    let shadows = shadow_segments(seed, rays);
    let cost: Vec<_> = contest.iter().map(|(name, m)| (name.clone(), shadow_time(&shadows, *m))).collect();
    lesson.save("shadow_rays", figures::shadow_rays(&cost))?;
    let hole = hole::from_the_hole();
    let lost = hole::lost_by_testcull(seed, rays);
    lesson.save("testcull", figures::testcull(&hole))?;
    lesson.save("as_printed", figures::as_printed(&hole, lost))?;
    figures::pictures(&lesson)?;

    // 4. What the figures show, checked.
    let all = |k: usize| [&speed, &far, &thin, &graze].map(|s| s[k].1.failures());
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
        far[0].1.points.iter().all(near),
    );
    lesson.claim(
        &format!(
            "From the hole of the torus (2, 0.6) the printed testcull loses {} of {} hits.",
            lost[0], lost[1]
        ),
        hole.culled.is_none() && hole.truth.len() == 2 && lost[0] > 0,
    );
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

/// Columns, rows, and the questions of each cell, row by row.
type Cells = ((usize, usize), Vec<Vec<Question>>);

fn axes() -> [Axis; 2] {
    let across = Axis::log("distance of the origin D/a").range(DISTANCE.start, DISTANCE.end);
    [across, Axis::log("thickness b/a").range(RATIO.start, RATIO.end)]
}

fn map_cells(lesson: &Lesson) -> Cells {
    let size = lesson.pick([(8, 6), (32, 22), (80, 56), (120, 84)]);
    let (mut questions, [across, up]) = (Vec::new(), axes());
    let ask = |distance, ratio| {
        (0..8).map(|i| question(lesson.seed(), i, (ratio, distance), turns(i, CLOSE))).collect()
    };
    FailureMap::new(across, up, "", size, |distance, ratio| {
        questions.push(ask(distance, ratio));
        None
    });
    (size, questions)
}

fn failure_map((size, questions): &Cells, method: TorusMethod) -> Figure {
    let (mut of_cells, [across, up]) = (questions.iter(), axes());
    let cell = |_, _| {
        let point = measured(of_cells.next()?, method, 1.0);
        (point.failures.total() == 0).then_some(point.error.map_or(0.0, |e| e.mid))
    };
    figures::failure_words(FailureMap::new(across, up, "error of t, in a", *size, cell), method)
}

/// From places of the torus (2, 0.6) that face the lamp, to the lamp at t = 1.
fn shadow_segments(seed: u64, rays: u32) -> Vec<Ray> {
    let torus = Torus::new(RING, 0.6).expect("0 < b < a");
    let segment = |i| {
        let q = question(seed, i, PLAIN, Aim::Through);
        let hit = torus.hit(&q.ray, &torus.nearest(&q.ray, 0.0, f64::INFINITY)?);
        let from = hit.origin_towards(LAMP - hit.point);
        (hit.ng.dot(LAMP - hit.point) > 0.0).then_some(Ray::new(from, LAMP - from))
    };
    (0..rays).filter_map(segment).collect()
}

fn shadow_time(segments: &[Ray], method: TorusMethod) -> (Spread, usize) {
    let torus = Torus::new(RING, 0.6).expect("0 < b < a").with_method(method);
    let blocked = || segments.iter().take(256).filter(|r| torus.blocks(r, 1.0)).count();
    let truth = torus.with_method(TorusMethod::Adaptive);
    let wrong = segments.iter().filter(|r| torus.blocks(r, 1.0) != truth.blocks(r, 1.0)).count();
    let some = segments.len().min(256);
    (time_each(some, blocked), wrong)
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
        sci(error),
        TorusMethod::ALL[fastest].name(),
        sci(off)
    )
}
