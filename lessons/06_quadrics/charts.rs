//! Charts, maps and tables of lesson 06.

use super::body::{Body, Kind, Rival};
use super::{WORLD, error_at, judge};
use glam::{DVec2, dvec3};
use lightbench::measure::{Method, Series, Spread, Tally, log_spaced};
use lightbench::num::U;
use lightbench::ray::Ray;
use lightbench::sample::Sampler;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Table, short};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::TAU;

type Contest = [(Method, Series)];

/// The headline: error of t against time.
pub fn speed(contest: &Contest, rays: u32) -> Figure {
    let time = |k: usize| {
        let point = contest[k].1.points.iter().find(|p| (p.parameter / WORLD - 1.0).abs() < 1.0e-9);
        point.and_then(|p| p.time).map_or(f64::NAN, |t| t.mid)
    };
    let (gain, price) = (error_at(&contest[2].1, WORLD) / error_at(&contest[0].1, WORLD), time(2) / time(0));
    let mut chart = Chart::speed_accuracy("error of t, radii (root mean square)")
        .x(Axis::time("time per ray"))
        .title(&format!("At 10⁴ radii ten coefficients err {} × as much and take {price:.1} × the time", short(gain)))
        .subtitle(&format!("one cylinder 10², 10⁴, 10⁶ radii from the origin and the eye, upwards along each line; {rays} rays that hit its side"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Speed against accuracy: one infinite cylinder as a general quadric (A, section 5.4.3) and as a shape of its own (B, section \
         6.5; ours). Median of nine runs with quartiles; a line climbs as the cylinder stands farther out.",
    )
}

pub fn stability(contest: &Contest, rays: u32) -> Figure {
    let mut chart = Chart::error_over(
        Axis::log("distance of the cylinder from eye and origin, radii"),
        "error of t, radii (root mean square)",
    )
    .title(
        "Not the arithmetic loses the digits but the ten numbers: at home the general quadric keeps them all",
    )
    .subtitle(&format!(
        "{rays} rays a point, all hit the side; truth in 106 bits from the cylinder's own numbers"
    ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    chart = chart
        .guide(Guide::slope_through(1.0, 1.0, U, "u D: one rounding of the distance"))
        .guide(Guide::slope_through(2.0, 1.0, U, "u D²: one rounding of J"));
    Figure::from(chart).caption(
        "Error of the first meeting over the distance. J holds D² − r²: rounding it is an error of u D² that no arithmetic can \
         take back afterwards. The same robust solver on a cylinder at the origin follows u D. Below: rays lost.",
    )
}

pub fn bodies(costs: &[[(f64, Spread); 2]]) -> Figure {
    let ratios: Vec<f64> = costs.iter().map(|[g, d]| g.1.mid / d.1.mid).collect();
    let (low, high) = ratios.iter().fold((f64::INFINITY, 0.0f64), |(l, h), r| (l.min(*r), h.max(*r)));
    let mut table = Table::new(&["Body", "general, ns", "dedicated, ns", "time ratio", "general error, radii", "dedicated error, radii"])
        .timed()
        .title(&format!("The general quadric takes {low:.1} to {high:.0} times as long, and loses digits"))
        .subtitle("first meeting per ray, both ours; 10⁴ radii from eye and origin; median of nine runs; error root mean square");
    for (kind, ([general, dedicated], ratio)) in Kind::ALL.iter().zip(costs.iter().zip(&ratios)) {
        let ns = |s: &Spread| format!("{:.0}", s.mid * 1.0e9);
        table = table.row(&[
            kind.name(),
            &ns(&general.1),
            &ns(&dedicated.1),
            &format!("{ratio:.1}"),
            &short(general.0),
            &short(dedicated.0),
        ]);
    }
    Figure::from(table).caption(
        "Four bodies as general quadrics and as shapes of their own: time of one ray, and error of its t.",
    )
}

/// Rays that meet the wall of a tube at an angle to its axis, from a distance.
fn grazing(seed: u64, distance: f64, angle: f64, count: u32) -> Vec<Ray> {
    let ray = |i| {
        let mut dice = Sampler::new(seed, distance.to_bits() ^ angle.to_bits().rotate_left(32), i);
        let (wall, out) = (DVec2::from_angle(TAU * dice.next_1d()), DVec2::from_angle(TAU * dice.next_1d()));
        let target = wall.extend(7.2 * dice.next_1d() - 3.6);
        let direction = (out * angle.sin()).extend(angle.cos()).normalize();
        Ray::new(target - direction * distance, direction)
    };
    (0..count).map(ray).collect()
}

/// Distance against the angle to the axis, for three ways to a tube.
pub fn tube_maps(lesson: &Lesson) -> Result {
    let body = Body::tube();
    let cells = lesson.pick([(8, 6), (32, 24), (64, 48), (96, 72)]);
    let ways = [
        (3, "failures_general", "A's quadric", "after A, (5.12) to (5.16)"),
        (1, "failures_document", "B's cylinder", "after B, section 6.5"),
        (0, "failures_ours", "Our cylinder", "the library's default"),
    ];
    for (k, file, name, source) in ways {
        let Rival { first, .. } = &body.rivals()[k];
        let mut worst = 0.0f64;
        let map = FailureMap::new(
            Axis::log("distance, radii").range(1.0, 1.0e10),
            Axis::log("angle between ray and axis, radians").range(1.0e-8, 1.0),
            "error of t, radii",
            cells,
            |distance, angle| {
                let mut tally = Tally::new();
                grazing(lesson.seed(), distance, angle, 8)
                    .iter()
                    .for_each(|ray| judge(&mut tally, first(ray), body.truth(ray)));
                let lost = tally.failures().total() > 0;
                worst = worst.max(tally.worst().unwrap_or(0.0));
                if lost { None } else { Some(tally.median_at(0.0).error.map_or(0.0, |e| e.mid)) }
            },
        )
        .range(1.0e-16, 1.0)
        .failing_above(0.1, "lost, or off by a tenth of the radius");
        let share = 100.0 * map.failing_share();
        let title = if share == 0.0 {
            format!("{name}: nothing is lost, and t errs by {} radii at most", short(worst))
        } else {
            format!("{name}: distance eats the digits, a flat angle hardly; {share:.0} % of the map is lost")
        };
        let map = map.title(&title).subtitle(
            "open tube of radius 1 and height 8; eight rays a cell that end on its wall, median error",
        );
        let caption = format!(
            "The tube seen ever farther away and ever more along its axis: {name} ({source}). Truth in 106 bits."
        );
        lesson.save(file, Figure::from(map).caption(&caption))?;
    }
    Ok(())
}

/// Error near a cone's apex, in units of how near the ray passes.
pub fn apex(lesson: &Lesson, rays: u32) -> Vec<(Method, Series)> {
    let body = Kind::Cone.at(dvec3(0.3, 0.7, 0.2)); // none of them a short binary fraction
    let misses = log_spaced(1.0e-12, 1.0, lesson.pick([7, 13, 25, 25]));
    let series = |first: &dyn Fn(&Ray) -> Option<f64>| {
        Series::over(&misses, |miss| {
            let mut tally = Tally::new();
            let aimed = Body { aim: -2.0 * miss, reach: 0.6 * miss, ..body };
            for ray in aimed.rays(lesson.seed(), rays / 4, 10.0) {
                match (first(&ray), body.truth(&ray)) {
                    (Some(t), Some(truth)) => tally.error((t - truth) / miss),
                    (found, truth) => tally.answer(found, truth),
                }
            }
            tally.median_at(miss)
        })
    };
    body.rivals().into_iter().take(4).map(|r| (r.method, series(&r.first))).collect()
}

pub fn apex_chart(contest: &Contest, rays: u32) -> Figure {
    let lost = |k: usize| contest[k].1.failures();
    let mut chart = Chart::error_over(
        Axis::log("distance of the ray from the apex, base radii"),
        "error of t over that distance (median)",
    )
    .title(&format!(
        "Near the apex the dedicated cone loses {} of {} rays, the general quadric {}",
        lost(0).total(),
        lost(0).of,
        lost(2).total()
    ))
    .subtitle(&format!(
        "cone of slope ½ with its apex at (0.3, 0.7, 0.2), from 10 away; {} rays a point",
        rays / 4
    ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Rays aimed ever closer to a cone's apex. Rounded coefficients describe a hyperboloid whose waist is some 10⁻⁸ wide, so that \
         the general quadric has no apex at all; the dedicated cone keeps its own.",
    )
}
