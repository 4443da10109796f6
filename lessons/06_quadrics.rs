//! Lesson 06. When does the general quadric lose to a dedicated shape, in time and in digits?
//!
//! Builds on:  02 (a ray meets a sphere), 03 (a scene, a light, a picture).
//! New here:   ten coefficients for every surface of second degree; cylinders and cones with two ends; errors over
//!             distance, over the angle to an axis, near an apex, and where the quadratic turns into a line.
//! Notation:   A_q t² + B_q t + C_q = 0 along the ray [A (5.12)–(5.14)]; r radius, h half the height, the axis along z;
//!             u = 2⁻⁵³ one rounding; D distance from the ray's origin, and of the shape from the origin of coordinates.
//! Predict:    a pipe of 1 m stands 100 km from the origin of coordinates. How many digits of its radius are in J?
//! Figure:     06_quadrics_speed_accuracy_time.svg, 06_quadrics_surfaces.svg

#[path = "06_quadrics/body.rs"]
mod body;
#[path = "06_quadrics/charts.rs"]
mod charts;
#[path = "06_quadrics/diagrams.rs"]
mod diagrams;
#[path = "06_quadrics/gallery.rs"]
mod gallery;
#[path = "06_quadrics/printed.rs"]
mod printed;

use body::{Body, Kind, Rival};
use glam::DVec3;
use lightbench::measure::{Method, Point, Series, Spread, Tally, log_spaced, time_each};
use lightbench::num::U;
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, Result};

const PLACE: DVec3 = DVec3::new(0.612_372_435_7, 0.643_767_529_1, 0.458_870_231_3); // unit vector to the shape; no round numbers
const DISTANCES: (f64, f64) = (1.0e1, 1.0e8); // radii
const TIMED: [f64; 3] = [1.0e2, 1.0e4, 1.0e6]; // radii
const WORLD: f64 = 1.0e4; // radii: a house in a town, where the answer is given
const PARABOLOID: f64 = 1.0e4; // distance [focal parameters] of the rays almost parallel to its axis

fn main() -> Result {
    let lesson = Lesson::without_essay(6)?;

    // 1. The truth: the quadratic in 106 bits, from the shape's own numbers; and what the words mean, drawn.
    let rays = lesson.pick([64, 512, 4096, 16384]);
    let distances = log_spaced(DISTANCES.0, DISTANCES.1, lesson.pick([8, 15, 29, 29]));
    diagrams::save(&lesson)?;
    lesson.save(
        "surfaces",
        gallery::panels(lesson.pick([48, 160, 320, 480]), lesson.pick([1, 4, 16, 64]), lesson.seed()),
    )?;

    // 2. The contestants: ten coefficients, or a shape of its own; formulas as the documents have them, and ours.
    let place = |distance: f64| PLACE * distance;
    let mut contest: Vec<(Method, Series)> = (0..5)
        .map(|k| {
            let at = |d: &f64| measured(&lesson, &Kind::Cylinder.at(place(*d)), k, *d, rays);
            (
                Kind::Cylinder.at(DVec3::ZERO).rivals()[k].method.clone(),
                Series::new(distances.iter().map(at).collect()),
            )
        })
        .collect();
    let home = |d: &f64| measured(&lesson, &Kind::Cylinder.at(DVec3::ZERO), 2, *d, rays);
    let centred = (
        Method::new("general, ours, pipe at the origin").styled(5),
        Series::new(distances.iter().map(home).collect()),
    );
    let costs: Vec<[(f64, Spread); 2]> = Kind::ALL.map(|kind| costs(&lesson, kind, rays)).into();
    let (straight, near_apex) = (printed::almost_straight(&lesson, rays), charts::apex(&lesson, rays));
    let ends = printed::ends_as_printed(&lesson, rays);

    // 3. The figures.
    lesson.save("speed_accuracy", charts::speed(&contest, rays))?;
    contest.push(centred);
    lesson.save("stability", charts::stability(&contest, rays))?;
    lesson.save("bodies", charts::bodies(&costs))?;
    charts::tube_maps(&lesson)?;
    lesson.save("apex", charts::apex_chart(&near_apex, rays))?;
    lesson.save("almost_straight", printed::straight_chart(&straight, rays))?;
    printed::straight_map(&lesson)?;
    lesson.save("far_end", printed::far_end(&ends))?;

    // 4. What the figures show, checked.
    let worst = |s: &Series| s.points.iter().filter_map(|p| p.error).map(|e| e.mid).fold(0.0, f64::max);
    let dedicated = &contest[0].1;
    // 64 u |t| is promised, and |t| ≤ D + 2.
    let kept = |p: &Point| {
        p.failures.total() == 0 && p.error.is_some_and(|e| e.mid <= 64.0 * U * (p.parameter + 2.0))
    };
    lesson.claim(
        "the dedicated cylinder loses no ray up to 10⁸ radii and keeps every t to 64 roundings",
        dedicated.points.iter().all(kept),
    );
    let general = error_at(&contest[2].1, 1.0e8) / error_at(dedicated, 1.0e8);
    lesson.claim(
        &format!("at 10⁸ radii from the origin of coordinates ten coefficients err {} times as much, or lose the pipe", short(general)),
        !(general < 1.0e6), // NaN: not one ray was answered
    );
    let (printed, ours) = (worst(&straight[0].1), worst(&straight[2].1));
    lesson.claim(
        &format!(
            "A's absolute test of A_q costs up to {} of t; ours keeps it to 64 roundings",
            short(printed)
        ),
        printed > 1.0e-3 && ours <= 64.0 * U && straight[2].1.failures().total() == 0,
    );
    let [gain, price] = [0, 1].map(|i| {
        let [general, dedicated] = costs[2];
        [general.0 / dedicated.0, general.1.mid / dedicated.1.mid][i]
    });
    lesson.answer(&format!(
        "in time by {price:.1} ×, and in digits as soon as the shape stands away from the origin of coordinates: {} radii out \
         the general cylinder errs {} times as much as the dedicated one, because J must hold D² and r² in one number; worth \
         it only for the surfaces that have no shape of their own, paraboloids and hyperboloids.",
        short(WORLD), short(gain)
    ))
}

/// Error, failures and (at three distances) time of a cylinder's rival, on rays from `distance` radii away.
fn measured(lesson: &Lesson, body: &Body, rival: usize, distance: f64, rays: u32) -> Point {
    let Rival { first, .. } = &body.rivals()[rival];
    let rays = body.rays(lesson.seed(), rays, distance);
    let mut tally = Tally::new();
    rays.iter().for_each(|ray| judge(&mut tally, first(ray), body.truth(ray)));
    let point = tally.rms_at(distance);
    let timed = TIMED.iter().any(|t| (distance / t - 1.0).abs() < 1.0e-9); // logarithms round
    if timed {
        point.timed(time_each(rays.len(), || rays.iter().filter_map(first).sum::<f64>()))
    } else {
        point
    }
}

/// Both have an answer: the difference counts, in radii; else the answer that is missing or too many.
fn judge(tally: &mut Tally, found: Option<f64>, truth: Option<f64>) {
    match (found, truth) {
        (Some(t), Some(true_t)) => tally.error(t - true_t),
        _ => tally.answer(found, truth),
    }
}

/// Error [radii] and time of the general and the dedicated way to one kind of body, 10⁴ radii out.
fn costs(lesson: &Lesson, kind: Kind, rays: u32) -> [(f64, Spread); 2] {
    let body = kind.at(PLACE * WORLD);
    let rays = body.rays(lesson.seed(), rays, WORLD);
    [2, 0].map(|k| {
        let Rival { first, .. } = &body.rivals()[k];
        let mut tally = Tally::new();
        rays.iter().for_each(|ray| judge(&mut tally, first(ray), body.truth(ray)));
        let error = tally.rms_at(WORLD).error.map_or(f64::NAN, |e| e.mid);
        (error, time_each(rays.len(), || rays.iter().filter_map(first).sum::<f64>()))
    })
}

fn error_at(series: &Series, distance: f64) -> f64 {
    let point = series.points.iter().find(|p| (p.parameter / distance - 1.0).abs() < 1.0e-9);
    point.and_then(|p| p.error).map_or(f64::NAN, |e| e.mid)
}
