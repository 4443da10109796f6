//! Lesson 02. Which of three ways to meet a sphere survives distance, and what does it cost?
//!
//! Builds on:  01 (a pixel becomes a ray).
//! New here:   the sphere by three formulas; errors measured against a truth; speed against accuracy.
//! Notation:   f from the centre to the ray's origin [m], d unit direction, r radius [m], D = |f|;
//!             t ray parameter [m], t_ca the closest point's, d also its distance from the centre in [B].
//! Predict:    a sphere of 1 m is seen from 1000 km, in f64. How wrong is t, by the school formula?
//! Figure:     02_sphere_speed_accuracy_time.svg

use glam::DVec3;
use lightbench::kit::figure::{Axis, Chart, FailureMap, Guide};
use lightbench::kit::lesson::{Lesson, Result};
use lightbench::measure::{Method, Point, Series, Spread, Tally, log_slope, time_each};
use lightbench::num::counted::{Counted, count};
use lightbench::num::gamma;
use lightbench::num::real::{Real, Triple};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::sphere::method::{self, Pair, algebraic, geometric, in_front, robust};
use lightbench::shape::sphere::{as_printed, reference::Meeting};

#[path = "02_sphere/figures.rs"]
mod figures;
use figures::sci;

const RADIUS: f64 = 1.0; // m
const WIDEST: f64 = 0.9; // largest impact parameter [radii]: nearer the rim the question itself is ill-conditioned
const HALF_DECADES: std::ops::RangeInclusive<i32> = 1..=16; // distance/radius = 10^(k/2)
const TIMED: [f64; 3] = [1.0e2, 1.0e4, 1.0e6]; // distance/radius
const MAP: std::ops::Range<f64> = 1.0..1.0e8; // distance/radius
type Line<R> = (Triple<R>, Triple<R>); // f and d

fn main() -> Result {
    let lesson = Lesson::open(2)?;

    // 1. The truth: what the words mean, two examples by hand, and lines whose meeting is known beyond f64.
    figures::diagrams(&lesson)?;
    figures::worked_examples(&lesson)?;
    let rays = lesson.pick([64, 512, 4096, 16384]);
    let sets: Vec<(f64, Vec<Line<f64>>)> = HALF_DECADES
        .map(|k| 10f64.powi(k / 2) * if k % 2 == 0 { 1.0 } else { 10f64.sqrt() })
        .map(|distance| (distance, lines(lesson.seed(), rays, distance, WIDEST)))
        .collect();

    // 2. The contestants: three formulas in two precisions.
    let contest = [
        (Method::default_of("robust, f64").styled(0), measured(&sets, robust::<f64>)),
        (Method::new("geometric, f64").styled(1), measured(&sets, geometric::<f64>)),
        (Method::new("algebraic, f64").styled(2), measured(&sets, algebraic::<f64>)),
        (Method::new("robust, f32").styled(4), measured(&sets, robust::<f32>)),
        (Method::new("geometric, f32").styled(3), measured(&sets, geometric::<f32>)),
        (Method::new("algebraic, f32").styled(5), measured(&sets, algebraic::<f32>)),
    ];

    // 3. The figures.
    lesson.save("speed_accuracy", figures::speed(&contest, rays))?;
    lesson.save("stability", figures::stability(&contest, rays))?;
    lesson.save("failures_algebraic", failure_map(&lesson, "algebraic", algebraic::<f32>))?;
    lesson.save("failures_robust", failure_map(&lesson, "robust", robust::<f32>))?;
    lesson.save("normals", figures::normals(lesson.pick([48, 320, 640, 640])))?;
    let savings = savings(lesson.seed());
    lesson.save("savings", figures::savings(&savings))?;
    lesson.save("as_printed", figures::as_printed(&losses(lesson.seed(), rays)))?;

    // 4. What the figures show, checked.
    claims(&lesson, &contest, &savings);
    lesson.answer(&answer(&contest))
}

/// Rays towards a sphere at the origin, at random places of a disc of `widest` radii across them.
fn lines(seed: u64, count: u32, distance: f64, widest: f64) -> Vec<Line<f64>> {
    let line = |i| {
        let mut sampler = Sampler::new(seed, distance.to_bits(), i);
        let (direction, [share, turn]) = (uniform_sphere(sampler.next_2d()), sampler.next_2d().to_array());
        line_at(direction, distance, widest * share.sqrt(), turn)
    };
    (0..count).map(line).collect()
}

/// A ray along `direction` from `distance` radii away that passes the centre `impact` radii off.
fn line_at(direction: DVec3, distance: f64, impact: f64, turn: f64) -> Line<f64> {
    let (right, up) = direction.any_orthonormal_pair();
    let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
    let back = (distance * distance - impact * impact).max(0.0).sqrt();
    let f = (right * cos + up * sin) * impact - direction * back;
    ((f * RADIUS).to_array(), direction.to_array())
}

/// The line as a machine of type `R` holds it: this, not the line that was meant, is what a method answers for.
fn rounded<R: Real>((f, d): &Line<f64>) -> Line<R> {
    (f.map(R::from_f64), d.map(R::from_f64))
}

/// The answer and the truth about one line: none of both, one of both, or the error of t₀ [radii].
fn judge<R: Real>(tally: &mut Tally, (f, d): Line<R>, found: Option<R>) {
    let truth = Meeting::of(f.map(R::to_f64), d.map(R::to_f64), RADIUS);
    let found = found.map(R::to_f64);
    match found.and_then(|t| truth.behind_first(t)) {
        Some(behind) => tally.error(behind / RADIUS),
        None => tally.answer(found, truth.half_chord),
    }
}

/// Error, failures and (at three distances) time of one method over all sets of lines.
fn measured<R: Real>(
    sets: &[(f64, Vec<Line<f64>>)],
    solve: impl Fn(Triple<R>, Triple<R>, R) -> Pair<R>,
) -> Series {
    let r = R::from_f64(RADIUS);
    let point = |(distance, lines): &(f64, Vec<Line<f64>>)| -> Point {
        let lines: Vec<Line<R>> = lines.iter().map(rounded).collect();
        let mut tally = Tally::new();
        lines.iter().for_each(|&(f, d)| judge(&mut tally, (f, d), in_front(solve(f, d, r))));
        let point = tally.rms_at(*distance);
        if !TIMED.contains(distance) {
            return point;
        }
        let first = |sum: R, &(f, d): &Line<R>| in_front(solve(f, d, r)).map_or(sum, |t| sum + t);
        point.timed(time_each(lines.len(), || lines.iter().fold(R::ZERO, first)))
    };
    Series::new(sets.iter().map(point).collect())
}

/// Where a method in f32 fails, and how far off it is elsewhere: eight rays a cell.
fn failure_map(
    lesson: &Lesson,
    name: &str,
    solve: impl Fn(Triple<f32>, Triple<f32>, f32) -> Pair<f32>,
) -> FailureMap {
    let mut nearest = f64::INFINITY;
    let cell = |distance: f64, impact: f64| {
        let mut tally = Tally::new();
        for i in 0..8 {
            let mut sampler = Sampler::new(lesson.seed(), distance.to_bits() ^ impact.to_bits(), i);
            let (direction, turn) = (uniform_sphere(sampler.next_2d()), sampler.next_1d());
            let (f, d) = rounded::<f32>(&line_at(direction, distance, impact, turn));
            judge(&mut tally, (f, d), in_front(solve(f, d, RADIUS as f32)));
        }
        if tally.failures().total() > 0 {
            nearest = if impact < WIDEST { nearest.min(distance) } else { nearest };
            return None;
        }
        Some(Spread::median(&tally.errors()).map_or(0.0, |error| error.mid))
    };
    let across = Axis::log("distance / radius").range(MAP.start, MAP.end);
    let up = Axis::linear("distance of the line from the centre / radius").range(0.0, 1.4);
    let cells = lesson.pick([(24, 14), (80, 56), (160, 112), (320, 224)]);
    let map = FailureMap::new(across, up, "error of t_0, radii", cells, cell).range(1.0e-8, 1.0);
    figures::failure_words(map, name, nearest)
}

/// What a way to the first meeting costs per ray.
pub struct Cost {
    name: &'static str,
    operations: f64,
    roots: f64,
    time: Spread,
}

/// Counted work and time, on rays every second of which misses.
fn savings(seed: u64) -> [Cost; 5] {
    let lines = lines(seed, 1024, 100.0, std::f64::consts::SQRT_2);
    let n = lines.len() as f64;
    let cost = |name, counted: fn(Line<Counted>) -> Option<Counted>, plain: &dyn Fn() -> f64| {
        let (done, _) = count(|| lines.iter().filter_map(|l| counted(rounded(l))).count());
        Cost {
            name,
            operations: done.total() as f64 / n,
            roots: done.roots as f64 / n,
            time: time_each(lines.len(), plain),
        }
    };
    macro_rules! way {
        ($name:literal, $solve:expr) => {
            cost($name, |(f, d)| $solve(f, d, Counted(RADIUS)), &|| {
                lines.iter().filter_map(|&(f, d)| $solve(f, d, RADIUS)).sum()
            })
        };
    }
    [
        way!("algebraic, both roots at once", |f, d, r| in_front(algebraic(f, d, r))),
        way!("algebraic, second root if needed [C]", method::algebraic_first),
        way!("geometric, d against r", |f, d, r| in_front(method::geometric_by_length(f, d, r))),
        way!("geometric, d² against r² [B]", |f, d, r| in_front(geometric(f, d, r))),
        way!("robust (default)", |f, d, r| in_front(robust(f, d, r))),
    ]
}

/// Rays lost, of `rays` that all hit, by the listings as printed: plain, small sphere, origin inside, tangent.
fn losses(seed: u64, rays: u32) -> Vec<(&'static str, [usize; 4], u32)> {
    let (plain, inside) = (lines(seed, rays, 10.0, WIDEST), lines(seed, rays, 0.5, 0.5));
    let tangent: Vec<Line<f64>> = (1..=rays).map(|k| ([0.0, 1.0, -f64::from(k)], [0.0, 0.0, 1.0])).collect();
    type First = fn(Triple<f64>, Triple<f64>, f64) -> Option<f64>;
    let ways: [(&str, First); 4] = [
        ("[A ill. 57] D < 10⁻⁶ is a miss", as_printed::with_fixed_epsilon),
        ("[B §6.2.1] t_ca < 0 is a miss", |f, d, r| in_front(as_printed::with_centre_in_front(f, d, r))),
        ("[C §1.6.1] D ≤ 0 is a miss", as_printed::without_tangent),
        ("robust (default)", |f, d, r| in_front(robust(f, d, r))),
    ];
    let lost = |solve: First, lines: &[Line<f64>], scale: f64| {
        lines.iter().filter(|(f, d)| solve(f.map(|x| x * scale), *d, RADIUS * scale).is_none()).count()
    };
    let sets = |s: First| {
        [lost(s, &plain, 1.0), lost(s, &plain, 1.0e-4), lost(s, &inside, 1.0), lost(s, &tangent, 1.0)]
    };
    ways.into_iter().map(|(name, solve)| (name, sets(solve), rays)).collect()
}

/// Root-mean-square errors of a contestant at a distance of `10^exponent` radii, and its time there.
fn at(series: &Series, exponent: i32) -> (f64, f64) {
    let point = series.points.iter().find(|p| p.parameter == 10f64.powi(exponent));
    point.map_or((f64::NAN, f64::NAN), |p| {
        (p.error.map_or(f64::NAN, |e| e.mid), p.time.map_or(f64::NAN, |t| t.mid))
    })
}

fn claims(lesson: &Lesson, contest: &[(Method, Series)], savings: &[Cost]) {
    let [robust64, _, algebraic64, robust32, _, algebraic32] = [0, 1, 2, 3, 4, 5].map(|i| &contest[i].1);
    let far = |s: &Series| {
        Series::new(
            s.points.iter().filter(|p| p.parameter >= 1.0e2 && p.parameter <= 1.0e6).cloned().collect(),
        )
    };
    let (gentle, steep) = (log_slope(&far(robust64), 1), log_slope(&far(algebraic64), 1));
    lesson.claim(
        &format!(
            "In f64 the error of t grows as the distance to the {:.2} (robust) and to the {:.2} (algebraic).",
            gentle.value, steep.value
        ),
        (gentle.value - 1.0).abs() < 0.1 && (steep.value - 2.0).abs() < 0.1,
    );
    // 4 roundings of f·f, 5 of q, one of the quotient: 11 u D with t's own; and 2√3 u D across the line, 2.06 times
    // as much along it at 0.9 r: 19 u D in all.
    let bound =
        |p: &Point| p.failures.total() == 0 && p.error.is_some_and(|e| e.high <= gamma(19) * p.parameter);
    lesson.claim(
        "In f64 robust loses no ray up to 10⁸ radii, and errs by less than 19 roundings of the distance.",
        robust64.points.iter().all(bound),
    );
    let lost = |s: &Series| {
        s.points.iter().filter(|p| p.parameter <= 1.0e5).map(|p| p.failures.total()).sum::<u64>()
    };
    lesson.claim(
        &format!(
            "In f32, up to 10⁵ radii, algebraic answers {} rays wrongly, robust {}.",
            lost(algebraic32),
            lost(robust32)
        ),
        lost(algebraic32) > 0 && lost(robust32) == 0,
    );
    let saved = [savings[0].operations - savings[1].operations, savings[2].roots - savings[3].roots];
    lesson.claim(
        &format!(
            "C's early exit saves {:.2} of {:.1} operations a ray, B's d² test {:.2} of {:.2} square roots.",
            saved[0], savings[0].operations, saved[1], savings[2].roots
        ),
        saved[0] > 0.0 && saved[1] == 1.0,
    );
}

fn answer(contest: &[(Method, Series)]) -> String {
    let [(robust64, time), (algebraic64, school), (robust32, single)] =
        [0, 2, 3].map(|i| at(&contest[i].1, 6));
    format!(
        "robust, in f64: at distance/radius 10⁶ it puts t within {} radii where the quadratic is {} off (it subtracts two \
         numbers of size D² to find r²), for {:.1} ns a ray instead of {:.1}; in f32 ({:.1} ns) even robust is {} radii off.",
        sci(robust64),
        sci(algebraic64),
        time * 1.0e9,
        school * 1.0e9,
        single * 1.0e9,
        sci(robust32)
    )
}
