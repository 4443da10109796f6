//! Where the estimate oversteps, and where orbits without a bailout overflow.

use super::{BAILOUT, PLAIN, VIEWED};
use glam::DVec4;
use lightbench::num::double_double::DoubleDouble;
use lightbench::num::real::Real;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::sdf::julia::Julia;
use lightbench::sdf::julia::orbit::{as_printed_estimate, escape, quaternion, safe_step};
use lightbench::shape::Shape;
use lightbench_kit::figure::{Axis, FailureMap, Figure, Shades};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

/// Rays that each cell of a map asks.
const ASKED: u32 = 6;

/// A share in words.
fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

/// The maps of steps, and the shares of cells in which one passes a hit: estimate, bound.
pub struct Overshoot {
    pub estimate: Figure,
    pub bound: Figure,
    pub shares: [f64; 2],
}

/// The largest step of a cell over the way to the first hit, of rays through the middle.
fn cell(lesson: &Lesson, julia: &Julia, distance: f64, step: &dyn Fn(DVec4, DVec4) -> f64) -> Option<f64> {
    let ratio = |i| {
        let out = uniform_sphere(Sampler::new(lesson.seed(), 90, i).next_2d());
        let ray = Ray::new(out * distance, -out);
        let hit = julia.nearest(&ray, 0.0, f64::INFINITY)?.t;
        Some(step(ray.origin.extend(0.0), julia.c()) / hit)
    };
    (0..ASKED).filter_map(ratio).reduce(f64::max)
}

pub fn overshoot(lesson: &Lesson) -> Result<Overshoot> {
    let size = lesson.pick([(8, 5), (40, 20), (80, 40), (120, 60)]);
    let far = || Axis::log("distance of the place from the middle, m").range(1.7, 1e4);
    let scale = || Axis::linear("c as a share of −0.2 + 0.6 i + 0.2 j + 0.2 k").range(0.0, 1.1);
    let made = |share: f64| Julia::new(VIEWED * share, 4 * PLAIN, BAILOUT, 0.0);
    made(1.0).map_err(|e| LessonError(e.to_string()))?;
    let map = |step: &dyn Fn(DVec4, DVec4) -> f64| {
        let mut last: Option<(f64, Julia)> = None;
        FailureMap::new(far(), scale(), "longest step / way to the first hit", size, |distance, share| {
            if last.as_ref().is_none_or(|(s, _)| *s != share) {
                last = made(share).ok().map(|julia| (share, julia));
            }
            cell(lesson, &last.as_ref()?.1, distance, step)
        })
        .shades(Shades::Decades)
        .range(0.1, 10.0)
        .failing_above(1.0, "passes the first hit")
        .subtitle("the longest of six steps towards the middle; the set after 32 steps")
    };
    let printed = map(&|q, c| {
        let end = escape::<f64>(quaternion(q), quaternion(c), 4 * PLAIN, 4.0);
        end.estimate().unwrap_or(0.0)
    });
    let bound = map(&|q, c| safe_step::<DoubleDouble>(q, c));
    let shares = [printed.failing_share(), bound.failing_share()];
    let title =
        format!("Too far away to be true: the estimate passes the set on {} of the map", percent(shares[0]));
    let estimate = Figure::from(printed.title(&title)).caption(
        "Hart's estimate over the way to the first hit, by distance and by how much is added. Far away |q'| is still 1 and the \
         estimate is ½ |q| ln |q|, more than the whole way.",
    );
    let bound = Figure::from(bound.title("The bound never passes the set, near or far")).caption(
        "The bound by backward balls on the same places: far away it is the distance of the ball that holds all orbits that stay.",
    );
    Ok(Overshoot { estimate, bound, shares })
}

/// The printed estimate after exactly N steps, without a bailout, against the one that stops at 100.
pub fn overflow<R: Real>(lesson: &Lesson, name: &str) -> Figure {
    let size = lesson.pick([(10, 8), (40, 30), (80, 60), (120, 90)]);
    let steps = Axis::linear("steps").range(0.0, 16.0);
    let far = Axis::log("distance of the place from the middle, m").range(0.8, 1e3);
    let map = FailureMap::new(steps, far, "relative change of the estimate", size, |n, distance| {
        let q = DVec4::new(0.6, 0.48, 0.64, 0.0) * distance;
        let with = escape::<f64>(quaternion(q), quaternion(VIEWED), n as u32, 100.0);
        let printed = as_printed_estimate::<R>(quaternion(q), quaternion(VIEWED), n as u32);
        let Some(right) = with.estimate() else { return printed.is_finite().then_some(1e-16) };
        printed.is_finite().then(|| ((printed - right) / right).abs().max(1e-16))
    });
    let share = map.failing_share();
    let title = format!("Without a bailout {name} overflows on {} of the map", percent(share));
    let map = map.range(1e-16, 1.0).failing("∞/∞").title(&title).subtitle(
        "½ |q| ln |q| / |q'| after exactly so many steps, against the same orbit stopped at |q| = 100",
    );
    Figure::from(map).caption(&format!(
        "Where squares overflow if nothing stops an orbit that has left, in {name}: |q| and |q'| are infinite and their quotient is no number. \
         With a bailout no such square is ever formed. Darkest: the orbit stays within 100, and both are the same."
    ))
}
