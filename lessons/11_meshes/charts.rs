//! Charts and tables of lesson 11; their numbers come from the lesson.

use super::broken::{Case, Cracks};
use super::queries::Stored;
use super::silhouette::{Formula, Solid, Sweep};
use lightbench::measure::{Method, Point, Series, Spread};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, grouped, short};

fn name(solid: Solid) -> Method {
    match solid {
        Solid::Cylinder => Method::new("cylinder of n sides").styled(1),
        Solid::Sphere => Method::new("sphere of n × n/2").styled(2),
    }
}

pub fn silhouette(cylinder: &Sweep, sphere: &Sweep) -> Figure {
    let last = cylinder.over_triangles.points.last();
    let (most, error) = last.map_or((0.0, f64::NAN), |p| (p.parameter, p.error.map_or(f64::NAN, |e| e.mid)));
    let axis = Axis::log("number of triangles");
    let chart = Chart::error_over(axis, "the outline falls short by, in radii (worst)")
        .title(&format!(
            "{} triangles still leave the cylinder {} of its radius too thin",
            grouped(most as u64),
            short(error)
        ))
        .subtitle("256 random views of radius 1 m, each halved 60 times between a ray that meets the mesh and one that misses")
        .guide(below(cylinder, -2.0, "slope −2"))
        .guide(below(sphere, -1.0, "slope −1"))
        .guide(Guide::level(f64::EPSILON / 2.0, "f64 sees no difference"));
    let chart = [cylinder, sphere].into_iter().fold(chart, |c, s| c.line(name(s.solid), &s.over_triangles));
    Figure::from(chart).caption(
        "How far the outline of a mesh stays behind that of the true shape, over its number of triangles. A cylinder is curved \
         one way: n sides take 4n − 4 triangles, and the gap π²/2n² falls with their square. A sphere is curved both ways, needs \
         n² triangles, and gains in proportion only. (After A §2.1: the more polygons, the nearer to reality.)",
    )
}

/// A guide a little below the last point of a sweep.
fn below(sweep: &Sweep, slope: f64, label: &str) -> Guide {
    let last = sweep.over_triangles.points.last();
    let (x, y) = last.map_or((1.0, 1.0), |p| (p.parameter, p.error.map_or(1.0, |e| e.mid)));
    Guide::slope_through(slope, x, 0.25 * y, label)
}

pub fn nanoseconds(time: Spread) -> String {
    format!("{:.0} ns a ray", time.mid * 1e9)
}

pub fn speed(cylinder: &Sweep, sphere: &Sweep, formulas: &[Formula; 2]) -> Figure {
    let formula = |f: &Formula| Series::new(vec![Point::at(1.0).erred(Spread::exact(f.error)).timed(f.time)]);
    let mut chart = Chart::speed_accuracy("the outline falls short by, in radii (worst)")
        .x(Axis::time("time per ray, nearest hit"))
        .title("A formula is exact for the price of a mesh of a few triangles")
        .subtitle("meshes from 4 sides on, doubling, against shape::Cylinder and shape::Sphere; rays at the cube that holds them")
        .line(Method::default_of("cylinder, formula").styled(0), &formula(&formulas[0]))
        .line(Method::new("sphere, formula").styled(5), &formula(&formulas[1]));
    for sweep in [cylinder, sphere] {
        chart = chart.line(name(sweep.solid), &sweep.over_triangles);
    }
    Figure::from(chart).caption(
        "Speed against accuracy. Through the hierarchy of boxes a ray pays for the logarithm of the number of triangles, and for \
         memory that no longer fits the caches. The formulas stand in the strip of what is exact to the last digits.",
    )
}

const WAYS: [&str; 3] = ["polygons (A, ill. 5)", "edge list (A, ill. 6)", "half-edges"];

pub fn storage(stored: &Stored) -> Figure {
    let t = stored.topology;
    let columns = ["", WAYS[0], WAYS[1], WAYS[2]];
    let mut table = Table::new(&columns)
        .title(&format!(
            "Edges cost memory: {:.1} times as much as polygons, half-edges {:.1} times",
            stored.bytes[1] as f64 / stored.bytes[0] as f64,
            stored.bytes[2] as f64 / stored.bytes[0] as f64,
        ))
        .subtitle(&format!(
            "a bumpy knot, V = {}, E = {}, F = {}: χ = {}, genus {}; reads: indices looked at for one answer",
            grouped(t.vertices as u64),
            grouped(t.edges as u64),
            grouped(t.faces as u64),
            t.euler(),
            t.genus().map_or("none".to_string(), |g| g.to_string()),
        ));
    let bytes = stored.bytes.map(|b| format!("{:.1}", b as f64 / t.faces as f64));
    table = table.row(&["bytes a triangle, points left out", &bytes[0], &bytes[1], &bytes[2]]);
    for query in &stored.queries {
        let reads = query.reads.map(|r| grouped(r.round() as u64));
        table = table.row(&[query.question, &reads[0], &reads[1], &reads[2]]);
    }
    Figure::from(table).caption(
        "What a mesh takes and what its questions cost, stored in three ways. A §2.2 recommends edges where little storage is \
         needed; they take more of it. What they buy, and half-edges far more, is an answer about neighbours without looking at everything.",
    )
}

pub fn queries(stored: &Stored) -> Figure {
    let mut table = Table::new(&["time for one answer", WAYS[0], WAYS[1], WAYS[2]])
        .timed()
        .title("Neighbours: half-edges answer at once, lists after reading everything")
        .subtitle("median of nine runs");
    for query in &stored.queries {
        let times = query.times.map(|t| seconds(t.mid));
        table = table.row(&[query.question, &times[0], &times[1], &times[2]]);
    }
    Figure::from(table)
        .caption("The same questions in time. To build half-edges means to sort all edges once.")
}

fn seconds(s: f64) -> String {
    match s {
        s if s < 1e-6 => format!("{:.0} ns", s * 1e9),
        s if s < 1e-3 => format!("{:.1} µs", s * 1e6),
        s => format!("{:.1} ms", s * 1e3),
    }
}

pub fn cracks(cracks: &Cracks, rays: u32) -> Figure {
    let axis = Axis::log("points moved by up to, in radii").range(0.7e-17, 1.4e-2);
    let chart = Chart::error_over(axis, "share of rays that leak out")
        .title(&format!(
            "Torn faces leak {} of {} rays, joined ones none",
            grouped(cracks.leaks[1]),
            grouped(cracks.of)
        ))
        .subtitle(&format!(
            "{} rays for each place, from inside a sphere of 320 faces at edges and corners of the faces",
            grouped(u64::from(rays))
        ))
        .line(Method::default_of("faces share their points").styled(0), &cracks.shared)
        .line(Method::new("each has its own").styled(1), &cracks.split);
    Figure::from(chart).caption(
        "The same sphere twice; its points are moved at random. Where faces share their points the surface is dented and stays whole. \
         Where each face has its own, copies that were equal move apart: from one rounding on, rays find the cracks, as many at \
         10⁻¹⁶ as at 10⁻³, for they were aimed at the seam.",
    )
}

pub fn broken(cases: &[Case], rays: u32) -> Figure {
    let mut table =
        Table::new(&["mesh", "edges without partner", "χ", "watertight (default)", "Möller–Trumbore"])
            .title("What is closed by its topology loses no ray; what is not closed does")
            .subtitle(&format!(
                "of {} rays from inside at edges and corners of faces those that met nothing",
                grouped(u64::from(rays))
            ));
    for case in cases {
        let numbers = [
            case.topology.unbalanced_edges.to_string(),
            case.topology.euler().to_string().replace('-', "−"),
            grouped(case.leaks[0]),
            grouped(case.leaks[1]),
        ];
        table = table.row(&[case.name, &numbers[0], &numbers[1], &numbers[2], &numbers[3]]);
    }
    Figure::from(table).caption(
        "Damage and its leaks. Copies that are equal to the bit do no harm: they are made one. Size, distance from the origin and \
         needles do none to exact signs. T-junctions are holes: the middle of an edge, rounded, lies off the edge.",
    )
}
