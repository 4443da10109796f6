//! D's Table 1 again: how many polygons a cube of an octree should hold.

use super::contest::{Face, boxes};
use glam::DVec3;
use lightbench::accel::{Octree, Splitting};
use lightbench::measure::{Method, Point, Series, Spread, time_each};
use lightbench::mesh::tessellate::bumpy_knot;
use lightbench::ray::{Ray, Silent};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::triangle::PreparedRay;
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, grouped};

/// Threshold, cubes, bytes, seconds as D prints them (a graphics card, 2 or so million rays).
const PRINTED: [(usize, usize, usize, f64); 5] = [
    (100, 2791, 212_116, 8.7404),
    (200, 765, 58_140, 8.7492),
    (300, 416, 31_616, 8.7527),
    (400, 337, 25_612, 8.7699),
    (500, 261, 19_836, 8.7795),
];
const THRESHOLDS: [usize; 11] = [1, 3, 10, 30, 100, 200, 300, 400, 500, 1000, 3000];
const DEPTH: usize = 16;
const RAYS: u32 = 128;

/// An octree of one threshold.
pub struct Row {
    threshold: usize,
    cubes: usize,
    bytes: usize,
    /// Seconds a ray, from near to far, and as D visits all cubes that a ray meets.
    ordered: Spread,
    all: Spread,
}

pub struct Measured {
    triangles: usize,
    rows: Vec<Row>,
}

pub fn faces((columns, rows): (u32, u32)) -> Vec<Face> {
    let knot = bumpy_knot(columns, rows);
    let cut = knot.triangulated().map(|cut| cut.mesh).unwrap_or(knot);
    let corners = |f: usize| {
        let mut outline = cut.outline(f);
        [0; 3].map(|_| outline.next().unwrap_or(DVec3::ZERO))
    };
    (0..cut.len()).map(corners).collect()
}

/// Chords of the sphere round the knot.
fn chords() -> Vec<Ray> {
    let end = |k: u32, salt: u64| uniform_sphere(Sampler::new(12, salt, k).next_2d()) * 3.7;
    (0..RAYS).map(|k| Ray::new(end(k, 0), (end(k, 1) - end(k, 0)).normalize_or(DVec3::X))).collect()
}

pub fn measure(size: (u32, u32)) -> Measured {
    let (mesh, rays) = (faces(size), chords());
    let boxes = boxes(&mesh);
    let row = |threshold: usize| {
        let octree = Octree::build(&boxes, Splitting { threshold, depth: DEPTH });
        let mut waiting = Vec::new();
        let test = |ray: &PreparedRay, i: u32, limit: f64| {
            ray.meet(mesh[i as usize]).map(|m| m.t).filter(|&t| 0.0 < t && t < limit)
        };
        let mut ordered = |ray: &Ray| {
            let prepared = PreparedRay::new(ray);
            let test = |i: u32, limit: f64| test(&prepared, i, limit);
            octree.nearest(ray, 0.0, f64::INFINITY, &mut Silent, &mut waiting, test).is_some()
        };
        let all = |ray: &Ray| {
            let (prepared, mut best) = (PreparedRay::new(ray), f64::INFINITY);
            octree.each(ray, 0.0, f64::INFINITY, &mut Silent, |i| {
                best = test(&prepared, i, best).unwrap_or(best);
            });
            best.is_finite()
        };
        Row {
            threshold,
            cubes: octree.cubes().len(),
            bytes: octree.bytes(),
            ordered: time_each(rays.len(), || rays.iter().filter(|r| ordered(r)).count()),
            all: time_each(rays.len(), || rays.iter().filter(|r| all(r)).count()),
        }
    };
    Measured { triangles: mesh.len(), rows: THRESHOLDS.into_iter().map(row).collect() }
}

impl Measured {
    fn quickest(&self) -> &Row {
        let mid = |r: &&Row| r.ordered.mid;
        self.rows.iter().min_by(|a, b| mid(a).total_cmp(&mid(b))).unwrap_or(&self.rows[0])
    }

    fn at(&self, threshold: usize) -> &Row {
        self.rows.iter().find(|r| r.threshold == threshold).unwrap_or(&self.rows[0])
    }
}

/// D's table beside ours.
pub fn table(m: &Measured) -> Figure {
    let mut table = Table::new(&[
        "threshold", "cubes", "bytes", "µs a ray", "as D visits", "cubes [D]", "bytes [D]", "seconds [D]",
    ])
    .title(&format!(
        "A threshold of {} is quickest: {:.1} × as fast as D's 300",
        m.quickest().threshold,
        m.at(300).ordered.mid / m.quickest().ordered.mid
    ))
    .subtitle(&format!(
        "octree over {} triangles, depth at most {DEPTH}; D's printed columns are another mesh of 70 064 on a graphics card, one picture",
        grouped(m.triangles as u64)
    ))
    .timed();
    for row in &m.rows {
        let printed = PRINTED.iter().find(|p| p.0 == row.threshold);
        let micro = |s: Spread| format!("{:.2}", s.mid * 1.0e6);
        let cells = [
            row.threshold.to_string(),
            grouped(row.cubes as u64),
            grouped(row.bytes as u64),
            micro(row.ordered),
            micro(row.all),
            printed.map_or(String::new(), |p| grouped(p.1 as u64)),
            printed.map_or(String::new(), |p| grouped(p.2 as u64)),
            printed.map_or(String::new(), |p| format!("{}", p.3)),
        ];
        table = table.row(&cells.each_ref().map(String::as_str));
        if row.threshold == 300 {
            table = table.marked();
        }
    }
    Figure::from(table).caption(
        "After D, Table 1, from which D takes 300 polygons a cube. D's seconds hardly change, since they are those of a whole picture with \
         100 shadow rays a pixel through cubes that are all visited; ours are those of the search alone.",
    )
}

/// D, figure 21, left: cubes.
pub fn cubes(m: &Measured) -> Figure {
    let ours: Vec<(f64, f64)> = m.rows.iter().map(|r| (r.threshold as f64, r.cubes as f64)).collect();
    let theirs = PRINTED.map(|(threshold, cubes, ..)| (threshold as f64, cubes as f64));
    Figure::from(
        Chart::new(Axis::log("threshold: triangles a cube may hold"), Axis::log("cubes"))
            .title("Cubes fall in proportion as the threshold grows")
            .subtitle(&format!(
                "ours over {} triangles, D's as printed over 70 064; after D, fig. 21",
                grouped(m.triangles as u64)
            ))
            .guide(Guide::slope(-1.0, "∝ 1/threshold"))
            .curve(Method::default_of("this octree").styled(1), &ours)
            .curve(Method::as_printed("as D prints it"), &theirs),
    )
    .caption("Number of cubes of an octree over the number of triangles that are allowed in one (after D, figure 21).")
}

/// D, figure 21, right: time.
pub fn time(m: &Measured) -> Figure {
    let series = |of: &dyn Fn(&Row) -> Spread| {
        Series::new(m.rows.iter().map(|r| Point::at(r.threshold as f64).timed(of(r))).collect())
    };
    Figure::from(
        Chart::time_over(Axis::log("threshold: triangles a cube may hold"), "time per ray")
            .title(&format!(
                "The time has its minimum near {}; from near to far it is {:.1} × shorter than by visiting all",
                m.quickest().threshold,
                m.quickest().all.mid / m.quickest().ordered.mid
            ))
            .subtitle(&format!(
                "random chords through {} triangles, nine runs each; after D, fig. 21",
                grouped(m.triangles as u64)
            ))
            .guide(Guide::upright(300.0, "D's choice"))
            .line(Method::default_of("from near to far").styled(1), &series(&|r| r.ordered))
            .line(Method::as_printed("all cubes met, as D"), &series(&|r| r.all)),
    )
    .caption("Time of a ray over the threshold (after D, figure 21).")
}
