//! Cost against wrong answers, and the table of all ways.

use super::bodies::bodies;
use super::contest::{Rule, Score, Way};
use glam::DVec3;
use lightbench::measure::{Point, Series, Spread, time_each};
use lightbench::ray::leaving::Departure;
use lightbench::sample::Sampler;
use lightbench_kit::figure::heading::percent;
use lightbench_kit::figure::{Axis, Chart, Figure, Table, grouped};
use lightbench_kit::lesson::{LessonError, Result};

/// What a start costs, and what it spoils.
pub struct Cost {
    pub time: Spread,
    pub score: Score,
}

/// Time of one start [s] on hits of all bodies, 1 m large and 1000 m away.
pub fn costs(seed: u64, ways: &[Way], totals: &[Score]) -> Result<Vec<Cost>> {
    let bodies = bodies(1.0, 1.0e3).map_err(|e| LessonError(e.to_string()))?;
    let starts: Vec<_> = bodies
        .iter()
        .flat_map(|b| (0..12).filter_map(|i| b.start(&mut Sampler::new(seed, 0, i))))
        .map(|s| {
            let leaving = s.side + s.arriving.any_orthonormal_vector();
            let way = Departure { arriving: s.arriving, side: s.side, leaving };
            (s, way)
        })
        .collect();
    let time = |rule: Rule| {
        time_each(starts.len(), || {
            let rays = starts.iter().filter_map(|(start, way)| rule.ray(1.0, start, way));
            rays.fold(DVec3::ZERO, |sum, ray| sum + ray.origin)
        })
    };
    Ok(ways.iter().zip(totals).map(|(w, score)| Cost { time: time(w.rule), score: *score }).collect())
}

/// As many as one plot holds; the table has all.
const CHARTED: [usize; 6] = [0, 1, 2, 3, 5, 6];

pub fn speed(ways: &[Way], costs: &[Cost]) -> Figure {
    let [ours, bias] = [0, 5].map(|k| costs[k].time.mid * 1.0e9);
    let chart = Chart::speed_accuracy("wrong shadow rays, share over the whole map")
        .x(Axis::time("time per start of a ray"))
        .title(&format!(
            "Only the error bounds are never wrong: {ours:.1} ns a start, where a fixed bias takes {bias:.1} ns"
        ))
        .subtitle(&format!(
            "{} shadow rays each, from eight shapes of 10⁻⁶ m to 10⁶ m, up to 10⁹ sizes away",
            grouped(costs[0].score.shadow_rays)
        ));
    let point = |k: usize| {
        let Cost { time, score } = &costs[k];
        let tests = score.tests as f64 / score.shadow_rays.max(1) as f64;
        Point::at(1.0).timed(*time).erred(Spread::exact(score.share())).worked(tests)
    };
    let chart = CHARTED
        .iter()
        .fold(chart, |chart, k| chart.line(ways[*k].method.clone(), &Series::new(vec![point(*k)])));
    Figure::from(chart).caption(
        "What it costs to choose the origin, without the test of the shape that follows, against the \
         share of shadow rays that are then answered wrongly. Half of the lights stand above the tangent plane, half below. A rule \
         with a fixed length fails in part of the map however it is chosen. Nothing is gained by a cheaper rule.",
    )
}

/// All ways, and what each gets wrong.
pub fn table(ways: &[Way], costs: &[Cost]) -> Figure {
    let head = ["way to leave a surface", "false shadows", "leaks", "lost inside", "ns per start"];
    let right = costs.iter().filter(|c| c.score.wrong() + c.score.lost == 0).count();
    let mut table = Table::new(&head)
        .timed()
        .title(&format!("{right} of {} ways answer every ray: those that know the error of the point", ways.len()))
        .subtitle(
            "shares over the whole map; lost inside: rays into the body that met its surface again at once, or never left",
        );
    for (way, Cost { time, score }) in ways.iter().zip(costs).rev() {
        let share = |n: u64, of: u64| percent(n as f64 / of.max(1) as f64);
        let half = score.shadow_rays / 2;
        let [shadows, leaks] = [score.false_shadows, score.leaks].map(|n| share(n, half));
        let lost = share(score.lost, score.inward_rays);
        let time =
            if way.rule == Rule::NaiveSkip { "–".to_string() } else { format!("{:.1}", time.mid * 1e9) };
        table = table.row(&[&way.method.name, &shadows, &leaks, &lost, &time]);
    }
    Figure::from(table.marked()).caption(
        "The same rays for all. False shadows: of lights above the tangent plane. Leaks: of lights below it, which smooth or bumpy \
         normals ask for. A bias on the viewer's side, along the normal or back along the ray, starts every transmitted ray outside. A \
         bias along the ray lets light through anything thin, and at grazing angles it hardly rises. The rule of A that skips the object \
         is right only where nothing is asked of the object.",
    )
}
