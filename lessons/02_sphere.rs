//! Lesson 02. Which of three ways to meet a sphere survives distance, and what does it cost?
//!
//! Builds on:  01 (a pixel becomes a ray).
//! New here:   the sphere by three formulas; errors measured against a truth; speed against accuracy.
//! Notation:   f from the centre to the ray's origin [m], d unit direction, r radius [m], D = |f|;
//!             t ray parameter [m], t_ca the closest point's, d also its distance from the centre in [B]; u = 2⁻⁵³.
//!             algebraic [C]  Δ = 4 ((f·d)² − (f·f − r²)),       t = (−2 f·d ∓ √Δ)/2:   D² − r² is rounded by u D²
//!             geometric [B]  d² = f·f − (f·d)²,                 t = −f·d ∓ √(r² − d²): the same subtraction
//!             robust         l = f − (f·d) d,  q = f·d ∓ √(r² − l·l),  t = (f·f − r²)/q and q: l is short, rounded by u D
//! Predict:    a sphere of 1 m is seen from 1000 km, in f64. How wrong is t, by the algebraic formula of school?
//! Figure:     02_sphere_speed_accuracy_time.svg

use glam::DVec3;
use lightbench::measure::{Method, Point, Series, Tally, log_slope};
use lightbench::num::gamma;
use lightbench::num::real::{Real, Triple};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::sphere::method::{Pair, algebraic, geometric, in_front, robust};
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, Result};

#[path = "02_sphere/asides.rs"]
mod asides;
#[path = "02_sphere/diagrams.rs"]
mod diagrams;
#[path = "02_sphere/figures.rs"]
mod figures;
use asides::{Cost, failure_map, judge, losses, rounded, savings, time_per_ray};
use figures::{between, error_at};

const RADIUS: f64 = 1.0; // m
const WIDEST: f64 = 0.9; // largest impact parameter [radii]: nearer the rim the question itself is ill-conditioned
const HALF_DECADES: std::ops::RangeInclusive<i32> = 1..=16; // distance/radius = 10^(k/2)
const TIMED: [f64; 3] = [1.0e2, 1.0e4, 1.0e6]; // distance/radius
type Line<R> = (Triple<R>, Triple<R>); // f and d

fn main() -> Result {
    let lesson = Lesson::without_essay(2)?;

    // 1. The truth: lines whose meeting is known beyond f64.
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
    let costs = savings(lesson.seed());
    lesson.save("speed_accuracy", figures::speed(&contest, &costs, rays))?;
    lesson.save("stability", figures::stability(&contest, rays))?;
    lesson.save("failures_algebraic", failure_map(&lesson, "Algebraic", algebraic::<f32>))?;
    lesson.save("failures_robust", failure_map(&lesson, "Robust", robust::<f32>))?;
    lesson.save("normals", figures::normals(lesson.pick([48, 320, 640, 640])))?;
    lesson.save("savings", figures::savings(&costs))?;
    lesson.save("as_printed", figures::as_printed(&losses(lesson.seed(), rays)))?;

    diagrams::worked_examples(&lesson)?;
    diagrams::all(&lesson)?;

    // 4. What the figures show, checked.
    let [r64, a64, r32, a32] = [0, 2, 3, 5].map(|i| &contest[i].1);
    claims(&lesson, [r64, a64, r32, a32], &costs);
    let [algebraic, geometric, robust] = [0, 3, 4].map(|i| &costs[i]);
    let ratio = |other: &Cost| robust.time.mid / other.time.mid;
    lesson.answer(&format!(
        "robust, in f64: at distance/radius 10⁶ it finds t to {} radii where algebraic and geometric are {} off, since they \
         subtract numbers of size D² to see r²; it costs {:.0} operations a ray instead of {:.0} and {:.0}, and in this run \
         {:.1} and {:.1} times their time ({:.1} ns); in f32 even robust is {} radii off.",
        short(error_at(r64, 6)),
        short(error_at(a64, 6)),
        robust.operations,
        algebraic.operations,
        geometric.operations,
        ratio(algebraic),
        ratio(geometric),
        robust.time.mid * 1.0e9,
        short(error_at(r32, 6)),
    ))
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

/// Error and failures of one method over all sets of lines, and its time over three of the sets together.
fn measured<R: Real>(
    sets: &[(f64, Vec<Line<f64>>)],
    solve: impl Fn(Triple<R>, Triple<R>, R) -> Pair<R>,
) -> Series {
    let r = R::from_f64(RADIUS);
    let timed = |distance: &f64| TIMED.contains(distance);
    let all: Vec<Line<R>> =
        sets.iter().filter(|s| timed(&s.0)).flat_map(|s| s.1.iter().map(rounded)).collect();
    let first = |sum: R, &(f, d): &Line<R>| in_front(solve(f, d, r)).map_or(sum, |t| sum + t);
    let time = time_per_ray(all.len(), || all.iter().fold(R::ZERO, first));
    let point = |(distance, lines): &(f64, Vec<Line<f64>>)| {
        let mut tally = Tally::new();
        for (f, d) in lines.iter().map(rounded) {
            judge(&mut tally, (f, d), in_front(solve(f, d, r)));
        }
        let point = tally.rms_at(*distance);
        if timed(distance) { point.timed(time) } else { point }
    };
    Series::new(sets.iter().map(point).collect())
}

fn claims(lesson: &Lesson, [robust64, algebraic64, robust32, algebraic32]: [&Series; 4], costs: &[Cost; 5]) {
    let slope = |s| log_slope(&between(s, 1.0e2, 1.0e6), 1).value;
    let (gentle, steep) = (slope(robust64), slope(algebraic64));
    // A root mean square over n rays scatters by 1/√(2n) ≤ 0.09; 6 σ at both ends of four decades: 0.083.
    // 4 roundings of f·f, 5 of q, one of the quotient: 11 u D with t's own; and 2√3 u D across the line, 2.06 times
    // as much along it at 0.9 r: 19 u D in all.
    let bound =
        |p: &Point| p.failures.total() == 0 && p.error.is_some_and(|e| e.high <= gamma(19) * p.parameter);
    lesson.claim(
        &format!(
            "In f64 the error of t grows with the distance to the power {gentle:.2} (robust), {steep:.2} (algebraic); up \
             to 10⁸ radii robust loses no ray, and errs by less than 19 roundings of the distance (root mean square)."
        ),
        (gentle - 1.0).abs() < 0.1 && (steep - 2.0).abs() < 0.1 && robust64.points.iter().all(bound),
    );
    let lost = |s| between(s, 1.0, 1.0e5).failures().total();
    lesson.claim(
        &format!(
            "In f32, up to 10⁵ radii, algebraic answers {} rays wrongly, robust {}.",
            lost(algebraic32),
            lost(robust32)
        ),
        lost(algebraic32) > 0 && lost(robust32) == 0,
    );
    lesson.claim(
        "C's early exit saves operations on rays that hit, B's d² test a square root on every ray.",
        costs[1].operations < costs[0].operations && costs[2].roots - costs[3].roots == 1.0,
    );
}
