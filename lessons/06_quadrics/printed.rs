//! The listings as printed: A's ray–quadric code [A ill. 58] and B's condition at a cylinder's far end [B §6.5.1].

use super::PARABOLOID;
use super::body::{Body, FirstOf, first_positive};
use glam::DVec2;
use lightbench::measure::{Failures, Method, Series, Tally, log_spaced};
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_disc};
use lightbench::shape::cylinder::{FarEnd, textbook};
use lightbench::shape::quadric::{self, Quadric};
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Table};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::TAU;

/// Relative error of t on a paraboloid, by the size of A_q: A's listing, A's formulas, ours.
pub fn almost_straight(lesson: &Lesson, rays: u32) -> Vec<(Method, Series)> {
    let body = Body::paraboloid();
    let coefficients = body.coefficients();
    let ours = Quadric::new(coefficients).expect("a paraboloid");
    let ways: [(Method, FirstOf); 3] = [
        (
            Method::as_printed("A, illustration 58"),
            Box::new(move |ray| quadric::as_printed(&coefficients, ray)),
        ),
        (
            Method::new("A's formulas, no tolerance").styled(3),
            Box::new(move |ray| first_positive(quadric::textbook(&coefficients, ray))),
        ),
        (
            Method::default_of("ours").styled(2),
            Box::new(move |ray| first_positive(ours.line(ray).into_iter().map(|c| c.t))),
        ),
    ];
    let sizes = log_spaced(1.0e-16, 1.0, lesson.pick([9, 17, 33, 33]));
    let series = |first: &FirstOf| {
        Series::over(&sizes, |a_q| {
            let mut tally = Tally::new();
            steep_rays(lesson.seed(), rays / 4, a_q, PARABOLOID)
                .iter()
                .for_each(|ray| tally.answer(first(ray), body.truth(ray)));
            tally.worst_at(a_q)
        })
    };
    ways.into_iter().map(|(method, first)| (method, series(&first))).collect()
}

/// Wrong first meetings with B's cylinder: its condition at the far end as printed, put right, and our cylinder.
pub fn ends_as_printed(lesson: &Lesson, rays: u32) -> [Failures; 3] {
    let body = Body::can();
    let rays = body.rays(lesson.seed(), rays, 10.0);
    let (p0, p1) = body.ends();
    let b = |far_end: FarEnd, ray: &Ray| textbook(p0, p1, 1.0, far_end, ray).first().map(|c| c.t);
    let ours = body.dedicated();
    let failures = |first: &dyn Fn(&Ray) -> Option<f64>| {
        let wrong = |(t, truth): (f64, f64)| (t - truth).abs() > 1.0e-6; // radii: far above any rounding at 10 radii
        rays.iter().fold(Failures::default(), |sum, ray| {
            let (found, truth) = (first(ray), ours(ray));
            let missed =
                u64::from(truth.is_some() && (found.is_none() || found.zip(truth).is_some_and(wrong)));
            sum.plus(&Failures {
                missed,
                false_hits: u64::from(truth.is_none() && found.is_some()),
                nan: 0,
                of: 1,
            })
        })
    };
    [
        failures(&|ray| b(FarEnd::AsPrinted, ray)),
        failures(&|ray| b(FarEnd::Corrected, ray)),
        failures(&|ray| body.capped_truth(ray)),
    ]
}

/// Rays down into the paraboloid `z = x² + y²` whose `A_q` is `a_q`: the squared sine of the angle to the axis.
fn steep_rays(seed: u64, count: u32, a_q: f64, distance: f64) -> Vec<Ray> {
    let ray = |i| {
        let mut dice = Sampler::new(seed, a_q.to_bits() ^ distance.to_bits().rotate_left(32), i);
        let (aside, out) =
            (uniform_disc(dice.next_2d()), DVec2::from_angle(TAU * dice.next_1d()) * a_q.sqrt());
        let direction = out.extend(-(1.0 - a_q).max(0.0).sqrt());
        Ray::new(aside.extend(aside.length_squared()) - direction * distance, direction)
    };
    (0..count).map(ray).collect()
}

pub fn straight_chart(contest: &[(Method, Series)], rays: u32) -> Figure {
    let mut chart = Chart::error_over(
        Axis::log("A_{q} = sin² of the angle to the axis"),
        "relative error of t (worst ray)",
    )
    .title("Under 10⁻⁶ A's listing takes the parabola for a straight line, and is wrong by A_{q} t")
    .subtitle(&format!("paraboloid z = x² + y² from {PARABOLOID} away, {} rays a point", rays / 4))
    .guide(Guide::upright(1.0e-6, "A's test: |A_{q}| < 10⁻⁶"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "A's (5.17), t = −C/B, used as its listing does it (illustration 58): with an absolute test of A_{q}. Solving for C/q instead \
         of (−B ± √D)/2A needs no test: the second root goes to infinity on its own.",
    )
}

/// A's listing over the size of A_{q} and of the distance.
pub fn straight_map(lesson: &Lesson) -> Result {
    let body = Body::paraboloid();
    let coefficients = body.coefficients();
    let map = FailureMap::new(
        Axis::log("A_{q}").range(1.0e-12, 1.0),
        Axis::log("distance, focal parameters").range(1.0, 1.0e8),
        "relative error",
        lesson.pick([(8, 6), (36, 24), (72, 48), (96, 64)]),
        |a_q, distance| {
            let mut tally = Tally::new();
            let rays = steep_rays(lesson.seed(), 8, a_q, distance);
            rays.iter()
                .for_each(|ray| tally.answer(quadric::as_printed(&coefficients, ray), body.truth(ray)));
            let lost = tally.failures().total() > 0;
            if lost { None } else { Some(tally.median_at(0.0).error.map_or(0.0, |e| e.mid)) }
        },
    )
    .range(1.0e-16, 1.0)
    .failing_above(1.0e-2, "lost, or off by 1 %");
    let share = 100.0 * map.failing_share();
    let map = map
        .title(&format!("A's listing as printed: {share:.0} % of the map is off by 1 % or lost"))
        .subtitle("paraboloid z = x² + y², eight rays a cell, median error; left of 10⁻⁶ the listing solves B t + C = 0");
    lesson.save("as_printed_map", Figure::from(map).caption(
        "After A, illustration 58, exactly as printed. Left of the step at 10⁻⁶ the square is dropped, which costs A_{q} t of t; on the \
         right the subtraction −B + √D cancels instead, for the same reason that C/q does not.",
    ))
}

/// B's condition at the cylinder's far end.
pub fn far_end(ends: &[Failures; 3]) -> Figure {
    let rays = ends[0].of;
    let mut table = Table::new(&["First meeting by", "lost or wrong", "false", "of"])
        .title(&format!("With > 0 at both ends B's cylinder answers {} of {rays} rays wrongly, with < 0 at the far one {}", ends[0].total(), ends[1].total()))
        .subtitle("capped cylinder of radius 1 and height 4, from 10 away; truth: our cylinder, with which 106 bits agree");
    let names = ["B as printed: (v_{a}, q − p_{2}) > 0", "B corrected: (v_{a}, q − p_{2}) < 0", "106 bits"];
    for (name, f) in names.iter().zip(ends) {
        table = table.row(&[name, &f.missed.to_string(), &f.false_hits.to_string(), &f.of.to_string()]);
    }
    Figure::from(table).caption(
        "B, section 6.5.1 keeps a meeting q with the side if (v_a, q − p₁) > 0 and (v_a, q − p₂) > 0, which holds beyond the far end; \
         between the ends the second must be negative.",
    )
}
