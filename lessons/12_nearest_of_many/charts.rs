//! Cost over the number of triangles.

use super::contest::Outcome;
use lightbench::measure::{Method, Point, Series, Spread};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, grouped};

type Outcomes = [(Method, Vec<Outcome>)];

fn triangles() -> Axis {
    Axis::log("number of triangles n")
}

/// A line of each method through something of its outcomes.
fn lines(chart: Chart, outcomes: &Outcomes, point: impl Fn(&Outcome) -> Option<Point>) -> Chart {
    outcomes.iter().fold(chart, |chart, (method, outcomes)| {
        let series = Series::new(outcomes.iter().filter_map(&point).collect());
        if series.points.is_empty() { chart } else { chart.line(method.clone(), &series) }
    })
}

fn factor(outcomes: &[Outcome], of: impl Fn(&Outcome) -> f64) -> f64 {
    of(&outcomes[outcomes.len() - 1]) / of(&outcomes[0])
}

/// Time of a ray.
pub fn scaling(outcomes: &Outcomes) -> Figure {
    let all = &outcomes[0].1;
    let mid = |o: &Outcome| o.time.map_or(f64::NAN, |t| t.mid);
    let chart = Chart::time_over(triangles(), "time per ray")
        .title(&format!(
            "{} × the triangles: a ray in a hierarchy takes {:.0} × the time, without a structure {} ×",
            grouped(factor(all, |o| o.n as f64).round() as u64),
            factor(all, mid),
            grouped(factor(&outcomes[5].1, mid).round() as u64)
        ))
        .subtitle("nearest triangle along random chords of a ball with hills across it; watertight test, nine runs each")
        .guide(Guide::slope(1.0, "∝ n"));
    Figure::from(lines(chart, outcomes, |o| Some(Point::at(o.n as f64).timed(o.time?)))).caption(
        "Time to find the nearest triangle over their number. Without a structure, and with a box round each, it is proportional to n; \
         in trees it follows the logarithm, and the caches' sizes.",
    )
}

/// Counted work of a ray.
pub fn work(outcomes: &Outcomes) -> Figure {
    let all = &outcomes[0].1;
    let chart = Chart::work_over(triangles(), "looks at boxes and triangles, per ray")
        .title(&format!(
            "Among {} triangles a ray looks at {:.0} boxes and triangles",
            grouped(all[all.len() - 1].n as u64),
            all[all.len() - 1].looks
        ))
        .subtitle("visits of nodes (eight boxes or eight triangles at once in a hierarchy, one cube of an octree, one hull) and tests of triangles")
        .guide(Guide::slope(1.0, "∝ n"));
    Figure::from(lines(chart, outcomes, |o| Some(Point::at(o.n as f64).worked(o.looks)))).caption(
        "The same in counts, which repeat on every machine. The octree's cubes hold up to 300 triangles each, and all of them are tested.",
    )
}

/// Time to build.
pub fn build(outcomes: &Outcomes) -> Figure {
    let last = |k: usize| {
        let o = &outcomes[k].1[outcomes[k].1.len() - 1];
        (o.n, o.build * 1.0e3)
    };
    let chart = Chart::time_over(triangles(), "time to build")
        .title(&format!(
            "A hierarchy over {} triangles is built in {:.0} ms, D's octree in {:.0} ms",
            grouped(last(0).0 as u64),
            last(0).1,
            last(2).1
        ))
        .subtitle(
            "one thread, one run each; the hierarchy by the surface area heuristic in 16 bins on each axis",
        )
        .guide(Guide::slope(1.0, "∝ n"));
    let point = |o: &Outcome| (o.bytes > 0).then(|| Point::at(o.n as f64).timed(Spread::exact(o.build)));
    Figure::from(lines(chart, outcomes, point))
        .caption("What it costs to have a structure before the first ray.")
}

/// Memory of a triangle.
pub fn memory(outcomes: &Outcomes) -> Figure {
    let last = |k: usize| {
        let o = &outcomes[k].1[outcomes[k].1.len() - 1];
        o.bytes as f64 / o.n as f64
    };
    let mut chart = Chart::new(triangles(), Axis::log("memory of the structure, bytes per triangle"))
        .title(&format!(
            "{:.0} bytes a triangle: corners in 16 bits and boxes in 32 are enough to rule out what is missed",
            last(0)
        ))
        .subtitle("besides the mesh itself, which has 72 bytes a triangle")
        .guide(Guide::level(72.0, "the triangle itself"));
    for (method, outcomes) in outcomes {
        let points: Vec<(f64, f64)> = outcomes
            .iter()
            .filter(|o| o.bytes > 0)
            .map(|o| (o.n as f64, o.bytes as f64 / o.n as f64))
            .collect();
        if !points.is_empty() {
            chart = chart.curve(method.clone(), &points);
        }
    }
    Figure::from(chart)
        .caption("Memory of each structure per triangle; few triangles fill nodes and packs badly.")
}
