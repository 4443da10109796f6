//! Lesson 11. How many triangles is a round thing worth, and what breaks a mesh?
//!
//! Builds on:  04 (a ray meets a triangle), 06 (a ray meets a cylinder).
//! New here:   polygons that share points; edges and half-edges; closed or not; tessellation; smooth normals.
//! Notation:   n sides around, V E F numbers of vertices, edges and faces, χ = V − E + F; radius 1 m.
//! Predict:    a cylinder of 1000 sides is 0.005 ‰ too thin. How many sides until f64 sees no difference?
//! Figure:     11_meshes_silhouette.svg, 11_meshes_speed_accuracy_time.svg, 11_meshes_cracks.svg

use lightbench::mesh::{HalfEdges, Topology, tessellate};
use lightbench::num::U;
use lightbench_kit::figure::{grouped, short};
use lightbench_kit::lesson::{Lesson, Result};

#[path = "11_meshes/broken.rs"]
mod broken;
#[path = "11_meshes/charts.rs"]
mod charts;
#[path = "11_meshes/diagrams.rs"]
mod diagrams;
#[path = "11_meshes/pictures.rs"]
mod pictures;
#[path = "11_meshes/queries.rs"]
mod queries;
#[path = "11_meshes/silhouette.rs"]
mod silhouette;
use lightbench::measure::log_slope;
use silhouette::Solid;

/// From four sides to what the quality allows, doubling.
const FEWEST: u32 = 2; // as a power of two
const DIRECTIONS: u32 = 256; // from which a silhouette is looked at

fn main() -> Result {
    let lesson = Lesson::without_essay(11)?;
    let seed = lesson.seed();

    // 1. The truth: the cylinder and the sphere by their formulas.
    lesson.save("hierarchy_polygons", diagrams::polygons())?;
    lesson.save("hierarchy_edges", diagrams::edges())?;
    pictures::cylinders(&lesson)?;

    // 2. The contestants: the same as meshes, finer and finer; and three ways to store one.
    let (most, finest) = lesson.pick([(7, 6), (13, 9), (16, 10), (18, 11)]);
    let sweep = |solid: Solid, most: u32| silhouette::sweep(solid, seed, FEWEST..=most);
    let (cylinder, sphere) = (sweep(Solid::Cylinder, most), sweep(Solid::Sphere, finest));
    let formulas = [Solid::Cylinder, Solid::Sphere].map(|solid| silhouette::formula(solid, seed));
    let stored = queries::compare(&lesson);
    let rays = lesson.pick([2_000, 20_000, 200_000, 1_000_000]);
    let cracks = broken::cracks(seed, rays);
    let cases = broken::cases(seed, rays);

    // 3. The figures.
    lesson.save("silhouette", charts::silhouette(&cylinder, &sphere))?;
    lesson.save("speed_accuracy", charts::speed(&cylinder, &sphere, &formulas))?;
    lesson.save("storage", charts::storage(&stored))?;
    lesson.save("queries", charts::queries(&stored))?;
    lesson.save("cracks", charts::cracks(&cracks, rays))?;
    lesson.save("broken", charts::broken(&cases, rays))?;
    pictures::knot(&lesson)?;

    // 4. What the figures show, checked.
    let slopes = [&cylinder, &sphere].map(|sweep| log_slope(&silhouette::tail(&sweep.over_triangles), 1));
    lesson.claim(
        "Twice the triangles: a quarter of the cylinder's error, half of the sphere's.",
        // Exactly −2 and −1 but for terms of 1/n², and 4 triangles less than 4n, which from n = 16 to 128, the shortest
        // sweep, make it 2 ln(16/15)/ln 8 = 0.062 flatter at most; a sphere's n² − 2n make it ln(8/7)/ln 16 = 0.048.
        (slopes[0].value + 2.0).abs() < 0.07 && (slopes[1].value + 1.0).abs() < 0.1,
    );
    let [shared, split] = cracks.leaks;
    lesson.claim(
        &format!(
            "Through faces that share their points no ray of {} gets out; through torn ones {split} do.",
            cracks.of
        ),
        shared == 0 && split > 0 && cases.iter().all(|c| c.is_survived()),
    );
    let mesh = tessellate::bumpy_knot(60, 8);
    let (topology, half) = (Topology::of(&mesh), HalfEdges::of(&mesh));
    let agree = half.is_ok_and(|h| {
        h.euler() == topology.euler() && h.is_closed() && h.polygons().faces().eq(mesh.faces())
    });
    lesson.claim(
        "Half-edges hold what polygons hold, answer for less than a permille of the reads, and take more memory.",
        agree && topology.genus() == Some(1) && stored.half_edges_pay(),
    );
    let sides = std::f64::consts::PI / (2.0 * U).sqrt();
    let last = cylinder.over_triangles.points.last();
    lesson.answer(&format!(
        "{} triangles still leave a cylinder {} of its radius too thin; f64 would see no difference from {} on. The formula has \
         that for {}. What breaks a mesh are faces that do not share their points: {} of {} rays leak, and none where they do.",
        grouped(last.map_or(0.0, |p| p.parameter) as u64),
        short(last.and_then(|p| p.error).map_or(f64::NAN, |e| e.mid)),
        short(4.0 * sides),
        charts::nanoseconds(formulas[0].time),
        grouped(split),
        grouped(cracks.of),
    ))
}
