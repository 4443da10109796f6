//! Side questions of lesson 02: where each method fails, what early exits save, what the printed listings lose.

use super::{Line, RADIUS, WIDEST, figures, line_at, lines};
use lightbench::measure::{Spread, Tally, timed};
use lightbench::num::counted::{Counted, count};
use lightbench::num::real::{Real, Triple};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::sphere::as_printed;
use lightbench::shape::sphere::method::{self, Pair, algebraic, geometric, in_front, robust};
use lightbench::shape::sphere::reference::Meeting;
use lightbench_kit::figure::{Axis, FailureMap, Figure};
use lightbench_kit::lesson::Lesson;
use std::hint::black_box;

const MAP: std::ops::Range<f64> = 1.0..1.0e8; // distance/radius

/// Where a method in f32 fails, and how far off it is elsewhere: sixteen rays a cell.
pub fn failure_map(
    lesson: &Lesson,
    name: &str,
    solve: impl Fn(Triple<f32>, Triple<f32>, f32) -> Pair<f32>,
) -> Figure {
    let mut nearest = f64::INFINITY;
    let cell = |distance: f64, impact: f64| {
        let mut tally = Tally::new();
        for i in 0..16 {
            let mut sampler = Sampler::new(lesson.seed(), distance.to_bits() ^ impact.to_bits(), i);
            let (direction, turn) = (uniform_sphere(sampler.next_2d()), sampler.next_1d());
            let (f, d) = rounded::<f32>(&line_at(direction, distance, impact, turn));
            judge(&mut tally, (f, d), in_front(solve(f, d, RADIUS as f32)));
        }
        if tally.failures().total() > 0 || tally.worst().is_some_and(|error| error > 1.0) {
            nearest = if impact < WIDEST { nearest.min(distance) } else { nearest };
            return None;
        }
        Some(Spread::median(&tally.errors()).map_or(0.0, |error| error.mid))
    };
    let across = Axis::log("distance / radius").range(MAP.start, MAP.end);
    let up = Axis::linear("distance of the line from the centre / radius").range(0.0, 1.4);
    let cells = lesson.pick([(24, 14), (80, 56), (160, 112), (320, 224)]);
    let map = FailureMap::new(across, up, "error of t_{0}, radii", cells, cell).range(1.0e-8, 1.0);
    figures::failure_words(map, name, nearest)
}

/// Time per ray [s]: median and quartiles of 101 runs, each long enough for the clock and too short to be interrupted often.
pub fn time_per_ray<T>(rays: usize, work: impl Fn() -> T) -> Spread {
    let repeats = 4096 / rays.max(1) + 1;
    let run = |_| timed(|| (0..repeats).for_each(|_| drop(black_box(work())))).0 / (repeats * rays) as f64;
    Spread::median(&(0..101).map(run).collect::<Vec<f64>>()).unwrap_or(Spread::exact(0.0))
}

/// What a way to the first meeting costs per ray.
pub struct Cost {
    pub name: &'static str,
    /// Sums, products, quotients and roots.
    pub operations: f64,
    pub roots: f64,
    pub time: Spread,
}

/// Counted work and time, on rays every second of which misses.
pub fn savings(seed: u64) -> [Cost; 5] {
    let lines = lines(seed, 1024, 100.0, std::f64::consts::SQRT_2);
    let n = lines.len() as f64;
    let cost = |name, counted: fn(Line<Counted>) -> Option<Counted>, plain: &dyn Fn() -> f64| {
        let (done, _) = count(|| lines.iter().filter_map(|l| counted(rounded(l))).count());
        Cost {
            name,
            operations: done.total() as f64 / n,
            roots: done.roots as f64 / n,
            time: time_per_ray(lines.len(), plain),
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

/// Rays lost, of `rays` that all hit, by the listings as printed: plain, small sphere, centre behind, tangent.
pub fn losses(seed: u64, rays: u32) -> Vec<(&'static str, [usize; 4], u32)> {
    let plain = lines(seed, rays, 10.0, WIDEST);
    let away = |(f, d): Line<f64>| (f.map(|x| -x), d);
    let inside: Vec<Line<f64>> = lines(seed, rays, 0.5, 0.5).into_iter().map(away).collect();
    let tangent: Vec<Line<f64>> = (1..=rays).map(|k| ([0.0, 1.0, -f64::from(k)], [0.0, 0.0, 1.0])).collect();
    type First = fn(Triple<f64>, Triple<f64>, f64) -> Option<f64>;
    let ways: [(&str, First); 4] = [
        ("[A ill. 57] D < 10⁻⁶ is a miss", as_printed::with_fixed_epsilon),
        ("[B §6.2.1] t_{ca} < 0 is a miss", |f, d, r| in_front(as_printed::with_centre_in_front(f, d, r))),
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

/// The line as a machine of type `R` holds it: this, not the line that was meant, is what a method answers for.
pub fn rounded<R: Real>((f, d): &Line<f64>) -> Line<R> {
    (f.map(R::from_f64), d.map(R::from_f64))
}

/// The answer and the truth about one line: none of both, one of both, or the error of t₀ [radii].
pub fn judge<R: Real>(tally: &mut Tally, (f, d): Line<R>, found: Option<R>) {
    let truth = Meeting::of(f.map(R::to_f64), d.map(R::to_f64), RADIUS);
    let found = found.map(R::to_f64);
    match found.and_then(|t| truth.behind_first(t)) {
        Some(behind) => tally.error(behind / RADIUS),
        None => tally.answer(found, truth.half_chord),
    }
}
