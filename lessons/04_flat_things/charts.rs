//! The charts of the comparison.

use super::{Face, Outcome, RADII, TIMED};
use glam::{DMat3, DVec3};
use lightbench::measure::Method;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_triangle};
use lightbench::shape::triangle::{Meeting, PreparedRay};
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Table};
use lightbench_kit::lesson::Lesson;

/// Leaks against time.
pub fn leaks(results: &[(Method, Outcome); 4], rays: u32) -> Chart {
    let chart = Chart::speed_accuracy("share of rays that leak out, worst radius")
        .x(Axis::time("time per ray–triangle test"))
        .better("↙ faster and tighter")
        .title("Only the watertight test lets no ray out, whatever the size of the mesh")
        .subtitle(&format!(
            "{rays} rays from inside at edges and corners of a sphere of 320 triangles, the worst of radius 1 mm, 1 m, 1 km; \
             time on {TIMED} rays at faces, each against the face and its neighbours"
        ));
    results.iter().fold(chart, |chart, (method, outcome)| chart.line(method.clone(), &outcome.series))
}

/// The same in counts.
pub fn counts(results: &[(Method, Outcome); 4], rays: u32) -> Table {
    let heads = RADII.map(|r| format!("out, r = {} m", number(r)));
    let doubles = RADII.map(|r| format!("twice, {} m", number(r)));
    let columns: Vec<&str> =
        std::iter::once("test").chain(heads.iter().chain(&doubles).map(String::as_str)).collect();
    let table = Table::new(&columns).title("What becomes of rays at shared edges and corners").subtitle(&format!(
        "{rays} rays for each radius: met nothing (out), or more than one triangle (twice); after A, ill. 56"
    ));
    results.iter().enumerate().fold(table, |table, (i, (method, o))| {
        let cells: Vec<String> = o.gaps.iter().chain(&o.twice).map(u64::to_string).collect();
        let row: Vec<&str> =
            std::iter::once(method.name.as_str()).chain(cells.iter().map(String::as_str)).collect();
        let table = table.row(&row);
        if i == 0 { table.marked() } else { table }
    })
}

fn number(r: f64) -> String {
    format!("{r}")
}

const SIZES: (f64, f64) = (1.0e-30, 1.0e30); // m
const ANGLES: (f64, f64) = (1.0e-10, 1.0); // rad
/// Rays in each cell of a map.
const TRIES: u32 = 6;

/// Error of t over the triangle's size and the angle at which the ray grazes it; and the worst error.
pub fn map(lesson: &Lesson, name: &str, test: impl Fn(&Ray, Face) -> Option<Meeting>) -> (Figure, f64) {
    let side = lesson.pick([12, 48, 72, 120]);
    let mut worst = 0.0f64;
    let map = FailureMap::new(
        Axis::log("length of the triangle's edges [m]").range(SIZES.0, SIZES.1),
        Axis::log("angle between ray and triangle [rad]").range(ANGLES.0, ANGLES.1),
        "error of t, relative",
        (side, side),
        |size, angle| {
            let error = cell(lesson.seed(), size, angle, &test);
            worst = worst.max(error.unwrap_or(f64::INFINITY));
            error
        },
    )
    .range(1.0e-17, 1.0e-5)
    .failing("misses");
    let share = map.failing_share();
    let finding = if share > 0.0 {
        format!("{name} loses small triangles, and grazed ones")
    } else if worst > 1.0e-12 {
        format!("{name} meets every triangle, but its t decays at grazing angles")
    } else {
        format!("{name} meets every triangle, t good to the last digits")
    };
    let figure = map.title(&finding).subtitle(&format!(
        "worst of {TRIES} rays at inner points of a triangle, from one edge length away; truth in 106 bits{}",
        if share == 0.0 && worst <= 1.0e-12 {
            ", which the test itself turns to below about 0.1 rad"
        } else {
            ""
        }
    ));
    (figure.into(), worst)
}

/// The worst error of t over some rays of a cell; `None` if one of them misses.
fn cell(seed: u64, size: f64, angle: f64, test: &impl Fn(&Ray, Face) -> Option<Meeting>) -> Option<f64> {
    let mut worst = 0.0f64;
    for k in 0..TRIES {
        let mut sampler = Sampler::new(seed, size.to_bits() ^ angle.to_bits().rotate_left(17), k);
        let turn =
            DMat3::from_rotation_y(sampler.next_1d() * 6.0) * DMat3::from_rotation_x(sampler.next_1d() * 6.0);
        let face = [0.0, 2.0, 4.0]
            .map(|i: f64| turn * DVec3::new((i * 1.047).cos(), (i * 1.047).sin(), 0.0) * (size / 1.732));
        let way = sampler.next_1d() * 6.0;
        let direction = turn * DVec3::new(angle.cos() * way.cos(), angle.cos() * way.sin(), -angle.sin());
        // Away from the edges: there the question is another.
        let w = uniform_triangle(sampler.next_2d()) * 0.7 + 0.1;
        let target = face[0] * w.x + face[1] * w.y + face[2] * w.z;
        let ray = Ray::new(target - direction * size, direction);
        let truth = PreparedRay::new(&ray).meet_plane(face).map_or(f64::NAN, |m| m.t);
        worst = worst.max((test(&ray, face)?.t / truth - 1.0).abs());
    }
    Some(worst)
}
