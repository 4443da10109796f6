//! Charts of lesson 09; their numbers come from the lesson.

use super::{MOST, PLAIN, TRUTH};
use glam::DVec4;
use lightbench::measure::{Method, Series, log_spaced};
use lightbench::num::double_double::DoubleDouble;
use lightbench::sdf::julia::orbit::{escape, quaternion, safe_step};
use lightbench::sdf::julia::{JuliaMethod, March};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide};

/// Ways with their measurements.
pub type Contest<const N: usize> = [(Method, Series); N];

/// A way to the first hit, and the tolerance of a march [m].
#[derive(Clone, Copy, PartialEq)]
pub enum Way {
    Certified,
    AsPrinted(f64),
    Estimate(f64),
    AtLeast(f64),
    Ball(f64),
}

impl Way {
    /// The contestants over steps, the default first.
    pub const ALL: [Way; 4] =
        [Way::Certified, Way::AsPrinted(1e-4), Way::Estimate(1e-4), Way::Estimate(1e-2)];
    /// The marches, the printed one first.
    pub const MARCHES: [Way; 4] =
        [Way::AsPrinted(1e-4), Way::Estimate(1e-4), Way::AtLeast(1e-4), Way::Ball(1e-4)];

    /// The same way with another tolerance.
    pub fn within(self, tolerance: f64) -> Self {
        match self {
            Way::Certified => self,
            Way::AsPrinted(_) => Way::AsPrinted(tolerance),
            Way::Estimate(_) => Way::Estimate(tolerance),
            Way::AtLeast(_) => Way::AtLeast(tolerance),
            Way::Ball(_) => Way::Ball(tolerance),
        }
    }

    pub fn julia_method(self) -> JuliaMethod {
        let march = |tolerance| March { tolerance, most: MOST };
        match self {
            Way::Certified => JuliaMethod::Certified,
            Way::AsPrinted(x) => JuliaMethod::AsPrinted(march(x)),
            Way::Estimate(x) => JuliaMethod::Estimate(march(x)),
            Way::AtLeast(x) => JuliaMethod::AtLeast(march(x)),
            Way::Ball(x) => JuliaMethod::Ball(march(x)),
        }
    }

    /// The style that it keeps in every chart of the lesson.
    pub fn method(self) -> Method {
        match self {
            Way::Certified => Method::default_of("certified").styled(0),
            Way::AsPrinted(_) => Method::as_printed("step and bisect, as printed"),
            Way::Estimate(x) if x > 1e-3 => Method::new("estimate, to 10⁻²").styled(4),
            Way::Estimate(_) => Method::new("estimate, to 10⁻⁴").styled(2),
            Way::AtLeast(_) => Method::new("steps of at least 1/20").styled(3),
            Way::Ball(_) => Method::new("safe balls").styled(5),
        }
    }
}

/// The same ways where the tolerance is the axis: no number in their names.
fn unnumbered(contest: &Contest<4>) -> impl Iterator<Item = (Method, &Series)> {
    contest.iter().map(|(method, series)| {
        let name = method.name.split(',').next().unwrap_or_default().to_string();
        (Method { name, ..method.clone() }, series)
    })
}

/// The headline: steps of the iteration and the tolerance of a march, as time and distance.
pub fn speed(contest: &Contest<4>, rays: usize) -> Figure {
    let chart = Chart::speed_accuracy("distance of the hit from the endless set's (median)")
        .x(Axis::time("time per ray, first hit"))
        .title("Steps, not tolerance, bring the hit to the endless set")
        .subtitle(&format!(
            "2, 3, 4, 6, 8, 11 and 14 steps along each line; {rays} rays, c = −0.2 + 0.6 i + 0.2 j + 0.2 k; truth: {TRUTH} steps"
        ));
    let chart = contest.iter().fold(chart, |chart, (method, series)| chart.line(method.clone(), series));
    Figure::from(chart).caption(
        "Time against distance from the hit on the set of 30 steps, over the number of steps of the iteration. The certified march ends \
         on the surface of its N; an estimate ends its tolerance before the endless set, whatever N.",
    )
}

pub fn tolerance(contest: &Contest<4>, rays: usize) -> Figure {
    let axis = Axis::log("tolerance of the march, m").range(0.6e-8, 4.0);
    let chart = Chart::error_over(axis, "error of the hit, m (median)")
        .title("A tolerance is no error bound, and no promise to hit")
        .subtitle(&format!("{rays} rays, {PLAIN} steps; against the certified hits of the same surface; below: hits lost and invented"));
    let chart = unnumbered(contest).fold(chart, |chart, (method, series)| chart.line(method, series));
    Figure::from(chart).caption(
        "Error of the first hit over the tolerance at which a march ends. The estimate aims at the endless set inside the surface of 8 \
         steps; bisection between two places finds the surface, if no arm was stepped over; safe balls only creep up to it.",
    )
}

pub fn work(contest: &Contest<4>) -> Figure {
    let axis = Axis::log("tolerance of the march, m").range(0.6e-8, 4.0);
    let chart = Chart::work_over(axis, "places looked at per ray")
        .title("The surer the step, the shorter: what marches pay for their tolerance")
        .subtitle("orbits followed per ray, hits and misses; the certified march looks at four places at a time and is not counted here");
    let chart = unnumbered(contest).fold(chart, |chart, (method, series)| chart.line(method, series));
    Figure::from(chart).caption("Orbits per ray over the tolerance of four marches.")
}

/// The step over the true distance, for the two sets with an exact one.
pub fn step() -> Figure {
    let distances = log_spaced(1e-6, 1e6, 121);
    let share = |c: DVec4, place: fn(f64) -> DVec4, step: fn(DVec4, DVec4) -> f64| -> Vec<(f64, f64)> {
        distances.iter().map(|&d| (d, step(place(d), c) / d)).collect()
    };
    let printed = |q, c| {
        let end = escape::<f64>(quaternion(q), quaternion(c), 100_000, 4.0);
        end.estimate().unwrap_or(0.0)
    };
    let bound = |q, c| safe_step::<DoubleDouble>(q, c);
    let ball: fn(f64) -> DVec4 = |d| DVec4::new(1.0 + d, 0.0, 0.0, 0.0);
    let segment: fn(f64) -> DVec4 = |d| DVec4::new(0.7, d, 0.0, 0.0);
    let (zero, two) = (DVec4::ZERO, DVec4::X * -2.0);
    let chart = Chart::new(
        Axis::log("distance from the set, m").range(1e-6, 1e6),
        Axis::log("step / distance").range(0.1, 12.0),
    )
    .title("Close by, the estimate is half the distance; far away it passes the set")
    .subtitle(
        "c = 0: the unit ball, along an axis; c = −2: the segment from −2 to 2, from the side; bailout 4",
    )
    .guide(Guide::level(1.0, "the set"))
    .function(Method::as_printed("estimate, c = 0"), &share(zero, ball, printed))
    .function(Method::new("estimate, c = −2").styled(4), &share(two, segment, printed))
    .function(Method::default_of("bound, c = 0").styled(0), &share(zero, ball, bound))
    .function(Method::new("bound, c = −2").styled(2), &share(two, segment, bound));
    Figure::from(chart).caption(
        "Hart's estimate ½ |q| ln |q| / |q'| and the bound by backward balls, over the exact distance. The estimate exceeds it from a \
         distance of 3.9 on (c = 0); the bound never does, and far away it is nearly the whole way.",
    )
}
