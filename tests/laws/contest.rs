//! Laws of contests: everything that is asked is counted, results go by name, and lesson 02's contest fits.

use lightbench::measure::{Failures, Method, Point, Tally};
use lightbench::num::real::{Real, Triple};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::sphere::method::{Pair, algebraic, in_front, robust};
use lightbench::shape::sphere::reference::Meeting;
use lightbench_kit::contest::{Contest, Results};
use lightbench_kit::figure::{Axis, Chart, Figure};
use std::cell::Cell;

type Question = (Option<f64>, Option<f64>); // what a method says, and the truth

/// A contest in which one method says what its question holds, one nothing, one NaN.
fn said<'a>() -> Contest<'a, Question, Option<f64>, Option<f64>> {
    Contest::new(|q: &Question| q.1, |_, truth, found, tally| tally.answer(*found, *truth))
        .with(Method::default_of("as told"), |q: &Question| q.0)
        .with("silent", |_| None)
        .with("lost", |_| Some(f64::NAN))
}

#[test]
fn failures_are_counted_over_all_that_was_asked() {
    let questions =
        [(Some(2.0), Some(2.0)), (Some(3.0), Some(2.0)), (None, Some(1.0)), (Some(1.0), None), (None, None)];
    let results = said().at(&questions);
    assert_eq!(results.failures("as told"), Failures { missed: 1, false_hits: 1, nan: 0, of: 5 });
    assert_eq!(results.failures("silent"), Failures { missed: 3, false_hits: 0, nan: 0, of: 5 });
    assert_eq!(results.failures("lost"), Failures { missed: 0, false_hits: 0, nan: 5, of: 5 });
    // Errors 0 and 1/2: the root of their mean square.
    assert_eq!(results.error("as told", 1.0), (0.125f64).sqrt());
    assert!(results.error("silent", 1.0).is_nan());
    assert_eq!(results.point("silent", 1.0).time, None, "not asked for");
    let over = said().over(&[1.0, 2.0, 3.0], |x| questions[..x as usize].to_vec());
    assert_eq!(over.of("silent").points.iter().map(|p| p.failures.of).collect::<Vec<_>>(), [1, 2, 3]);
    assert_eq!(over.failures("silent"), Failures { missed: 6, of: 6, ..Failures::default() });
    assert_eq!(said().at(&[]).failures("lost"), Failures::default());
}

#[test]
fn results_keep_order_and_style_and_go_by_name() {
    let results = said().at(&[(Some(1.0), Some(1.0))]);
    let names: Vec<&str> = results.iter().map(|(m, _)| m.name.as_str()).collect();
    assert_eq!(names, ["as told", "silent", "lost"]);
    let more = results.clone().and(renamed("other").at(&[(Some(1.0), Some(1.0))]));
    assert_eq!(more.of("other").points.len(), 1);
    assert_eq!(more.of("lost"), results.of("lost"));
}

fn renamed<'a>(name: &str) -> Contest<'a, Question, Option<f64>, Option<f64>> {
    Contest::new(|q: &Question| q.1, |_, truth, found, tally: &mut Tally| tally.answer(*found, *truth))
        .with(name, |q: &Question| q.0)
}

#[test]
#[should_panic(expected = "two methods of the name “silent”")]
fn a_name_used_twice_is_an_error() {
    let _ = said().with("silent", |_| None);
}

#[test]
#[should_panic(expected = "two methods of the name “lost”")]
fn a_name_in_two_contests_is_an_error_where_they_are_joined() {
    let _ = said().at(&[]).and(renamed("lost").at(&[]));
}

#[test]
#[should_panic(expected = "no method “robust” among: as told, silent, lost")]
fn an_unknown_name_is_an_error_that_lists_the_known() {
    let _ = said().at(&[]).of("robust");
}

#[test]
fn the_truth_is_found_once_for_all_methods_and_rounds() {
    let asked = Cell::new(0);
    let truth = |x: &u32| {
        asked.set(asked.get() + 1);
        f64::from(*x)
    };
    let judge = |_: &u32, t: &f64, a: &f64, tally: &mut Tally| tally.answer(Some(*a), Some(*t));
    let answered = Cell::new(0);
    let contest = Contest::new(truth, judge).rounds(4).with("right", |x: &u32| f64::from(*x)).with(
        "slow",
        |x: &u32| {
            answered.set(answered.get() + 1);
            std::thread::sleep(std::time::Duration::from_micros(600));
            f64::from(*x)
        },
    );
    let results = contest.at(&[1, 2, 3]);
    assert_eq!(asked.get(), 3);
    // A first call to learn how long a set takes, four rounds, and the answers that are judged: six times three.
    assert_eq!(answered.get(), 18);
    let time = results.point("slow", 1.0).time.expect("a time");
    assert!(time.mid >= 6.0e-4 && time.runs == 4, "{time:?}");
    assert_eq!(results.ratio("slow", "right").map(|r| r.0.runs), Some(4));
    let joined = results.and(contest_of_nothing());
    assert!(joined.ratio("slow", "nothing").is_none());
}

fn contest_of_nothing() -> Results {
    Contest::new(|_: &u32| (), |_, _, _: &(), _| {}).with("nothing", |_| ()).at(&[])
}

#[test]
fn a_map_fails_where_one_answer_of_a_cell_does() {
    let axes = || (Axis::linear("x").range(0.0, 4.0), Axis::linear("y").range(0.0, 2.0));
    // Cells' middles are x = 0.5, 1.5, 2.5, 3.5; beyond 3 the second question of a cell is missed.
    let cell = |x: f64, y: f64| {
        vec![(Some(x + y), Some(x)), ((x < 3.0).then_some(1.0), Some(1.0)), (Some(9.0), Some(9.0))]
    };
    let map = said().map("as told", axes(), "error", (4, 2), cell);
    assert_eq!(map.failing_share(), 0.25);
    assert_eq!(said().map("silent", axes(), "error", (4, 2), cell).failing_share(), 1.0);
    assert_eq!(said().map("silent", axes(), "error", (4, 2), |_, _| vec![]).failing_share(), 0.0);
    let csv = &Figure::from(map).data[0].csv;
    assert!(csv.starts_with("x,y,value,fails\n5e-1,5e-1,0e0,0\n"), "{csv}");
}

// Lesson 02's contest: formulas in two precisions, judged by the ray as each of them holds it.

const RADIUS: f64 = 1.0;
type Line<R> = (Triple<R>, Triple<R>);
type Solve<R> = fn(Triple<R>, Triple<R>, R) -> Pair<R>;

fn lines(distance: f64) -> Vec<Line<f64>> {
    let line = |i| {
        let mut sampler = Sampler::new(0, distance.to_bits(), i);
        let (d, u) = (uniform_sphere(sampler.next_2d()), sampler.next_2d());
        let (right, up) = d.any_orthonormal_pair();
        let (sin, cos) = (u.y * std::f64::consts::TAU).sin_cos();
        let impact = 0.9 * u.x.sqrt();
        let f = (right * cos + up * sin) * impact - d * (distance * distance - impact * impact).sqrt();
        (f.to_array(), d.to_array())
    };
    (0..64).map(line).collect()
}

fn rounded<R: Real>((f, d): &Line<f64>) -> Line<R> {
    (f.map(R::from_f64), d.map(R::from_f64))
}

fn judge<R: Real>(tally: &mut Tally, truth: &Meeting, found: Option<R>) {
    let found = found.map(R::to_f64);
    match found.and_then(|t| truth.behind_first(t)) {
        Some(behind) => tally.error(behind / RADIUS),
        None => tally.answer(found, truth.half_chord),
    }
}

fn contest<R: Real>(methods: [(&'static str, Solve<R>); 2]) -> Results {
    let truth = |q: &Line<f64>| {
        let (f, d) = rounded::<R>(q);
        Meeting::of(f.map(R::to_f64), d.map(R::to_f64), RADIUS)
    };
    let mut contest = Contest::new(truth, |_, truth, found: &Option<R>, tally| judge(tally, truth, *found));
    for (name, solve) in methods {
        contest = contest.with(name, move |q: &Line<f64>| {
            let (f, d) = rounded::<R>(q);
            in_front(solve(f, d, R::from_f64(RADIUS)))
        });
    }
    contest.over(&DISTANCES, lines)
}

const DISTANCES: [f64; 4] = [1.0e1, 1.0e3, 1.0e5, 1.0e7];

#[test]
fn the_contest_of_lesson_02_is_what_its_loops_find() {
    let results = contest::<f64>([("robust", robust::<f64>), ("quadratic formula", algebraic::<f64>)])
        .and(contest::<f32>([("robust, f32", robust::<f32>), ("quadratic formula, f32", algebraic::<f32>)]));
    fn by_hand<R: Real>(solve: Solve<R>) -> Vec<Point> {
        let point = |distance: f64| {
            let mut tally = Tally::new();
            for q in &lines(distance) {
                let (f, d) = rounded::<R>(q);
                let truth = Meeting::of(f.map(R::to_f64), d.map(R::to_f64), RADIUS);
                judge(&mut tally, &truth, in_front(solve(f, d, R::from_f64(RADIUS))));
            }
            tally.rms_at(distance)
        };
        DISTANCES.map(point).to_vec()
    }
    assert_eq!(results.of("robust").points, by_hand(robust::<f64>));
    assert_eq!(results.of("quadratic formula").points, by_hand(algebraic::<f64>));
    assert_eq!(results.of("robust, f32").points, by_hand(robust::<f32>));
    assert_eq!(results.of("quadratic formula, f32").points, by_hand(algebraic::<f32>));
    let lost = |name| results.of(name).between(1.0, 1.0e5).failures().total();
    assert!(lost("quadratic formula, f32") > 0 && lost("robust, f32") == 0);
    assert!(results.error("quadratic formula", 1.0e5) > 1.0e3 * results.error("robust", 1.0e5));
    let chart = Chart::error_over(Axis::log("distance / radius"), "error of t").lines(&results);
    let figure = Figure::from(chart);
    for (method, _) in &results {
        assert!(figure.svg().contains(&method.name), "{}", method.name);
    }
}
