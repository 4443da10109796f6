//! Coincident faces on two paths: a pocket whose rim lies in the top of a plate, both placed by maps of their own.

use super::contestants::naive_lists;
use super::printed::ByLists;
use super::solids::{COLOURS, portrait, solid};
use glam::{DAffine3, DMat3, DVec3, dvec3};
use lightbench::csg::Tree;
use lightbench::measure::{Method, Point, Series, Tally, log_spaced};
use lightbench::ray::{Ray, Span};
use lightbench::sample::uniform;
use lightbench::shape::Solid;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::instance::Instance;
use lightbench_kit::figure::{Axis, Chart, Figure, Panels, short};
use std::f64::consts::TAU;

/// Half the plate's edge and half its thickness [m].
const HALF: DVec3 = DVec3::new(1.5, 0.5, 1.5);
/// Half the pocket's edge, and its depth [m].
const POCKET: DVec3 = DVec3::new(0.9, 0.4, 0.9);
/// A fixed least length of a span [m].
const FIXED: f64 = 1.0e-9;

/// What is done about faces that coincide.
#[derive(Clone, Copy, PartialEq)]
pub enum Care {
    /// The library's: as the surfaces' errors allow.
    Derived,
    /// Ends are one if they are equal bit for bit.
    Exact,
    /// Spans shorter than 10⁻⁹ m are dropped.
    FixedLength,
    /// The tool is made a thousandth longer.
    LongerTool,
}

impl Care {
    pub const ALL: [Care; 4] = [Care::Derived, Care::Exact, Care::FixedLength, Care::LongerTool];

    fn method(self) -> Method {
        match self {
            Care::Derived => Method::default_of("ties by rounding bounds").styled(0),
            Care::Exact => Method::new("equal bit for bit").styled(1),
            Care::FixedLength => Method::new("spans under 10⁻⁹ m dropped").styled(2),
            Care::LongerTool => Method::new("tool 0.1 % longer").styled(3),
        }
    }
}

fn number(seed: u64, i: u32, k: u32) -> f64 {
    uniform(seed, u64::from(i), 0, k) - 0.5
}

/// A random place `distance` away, and a turn about a random axis by up to ± `most` half turns.
fn home(seed: u64, i: u32, most: f64, distance: f64) -> DAffine3 {
    let vector = |k: u32| dvec3(number(seed, i, k), number(seed, i, k + 1), number(seed, i, k + 2));
    let turn = DMat3::from_axis_angle(vector(0).normalize_or(DVec3::Y), TAU * most * number(seed, i, 3));
    DAffine3::from_mat3_translation(turn, vector(4).normalize_or(DVec3::X) * distance)
}

/// A plate with a pocket, under a map. The tool is lifted first and then stretched: its top comes to the plate's, but
/// for rounding; or above it, if it is made longer.
fn tree(home: DAffine3, longer: f64) -> Tree {
    let cube = |map| {
        let cube = Cuboid::new(DVec3::NEG_ONE, DVec3::ONE).expect("a cube");
        Tree::leaf(Instance::new(Box::new(cube), map).expect("a map of space"))
    };
    let depth = POCKET.y * (1.0 + longer);
    let lift = DAffine3::from_translation(DVec3::Y * ((HALF.y - POCKET.y) / depth + longer));
    let path = home * (DAffine3::from_scale(dvec3(POCKET.x, depth, POCKET.z)) * lift);
    cube(home * DAffine3::from_scale(HALF)).difference(cube(path))
}

/// Looks into the pocket from `height` above it; does the ray see a cap where the pocket is open?
fn sees_a_cap(seed: u64, i: u32, distance: f64, care: Care) -> bool {
    let longer = if care == Care::LongerTool { 1.0e-3 } else { 0.0 };
    let home = home(seed, i, 1.0, distance);
    let tree = tree(home, longer);
    let (x, z) = (1.6 * number(seed, i, 7) * POCKET.x, 1.6 * number(seed, i, 8) * POCKET.z);
    let from = dvec3(x + 0.4 * number(seed, i, 9), HALF.y + 4.0, z + 0.4 * number(seed, i, 10));
    let (from, to) = (home.transform_point3(from), home.transform_point3(dvec3(x, HALF.y, z)));
    let ray = Ray::new(from, to - from); // the rim's plane lies at t = 1, the bottom of the pocket at 1.2
    let mut spans = Vec::new();
    match care {
        Care::Derived => solid(tree).spans(&ray, &mut spans),
        _ => spans = naive_lists(&tree, &ray),
    }
    if care == Care::FixedLength {
        spans.retain(|s: &Span| (s.leave.t - s.enter.t) * ray.direction.length() >= FIXED);
    }
    spans.first().is_none_or(|s| s.enter.t < 1.1)
}

pub fn over_distance(seed: u64, rays: u32) -> [(Method, Series); 4] {
    let distances = log_spaced(1.0, 1.0e8, 9);
    Care::ALL.map(|care| {
        let point = |distance: f64| {
            let mut tally = Tally::new();
            for i in 0..rays {
                tally.answer(sees_a_cap(seed, i, distance, care).then_some(1.0), None);
            }
            Point { parameter: distance, failures: tally.failures(), ..Point::default() }
        };
        (care.method(), Series::over(&distances, point))
    })
}

/// The series of a way by its name; an empty one if there is no such way.
pub fn of<'a>(contest: &'a [(Method, Series); 4], name: &str) -> &'a Series {
    static NONE: Series = Series { points: Vec::new() };
    contest.iter().find(|(method, _)| method.name == name).map_or(&NONE, |(_, series)| series)
}

/// The distance at which the first ray sees a lid [m].
pub fn first_lid(series: &Series) -> String {
    let failed = series.points.iter().find(|p| p.failures.total() > 0);
    failed.map_or("no distance".to_string(), |p| short(p.parameter))
}

pub fn chart(contest: &[(Method, Series)], rays: u32) -> Figure {
    let axis = Axis::log("distance of the plate from the origin of space, m").range(0.7, 1.5e8);
    let mut chart = Chart::failures_over(axis, "rays into the pocket that see a lid")
        .title("Only exact ties close the pocket at every distance")
        .subtitle(&format!("a plate of 3 m with a pocket flush with its top; {rays} random turns a point"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "A fixed least length of a span works while rounding is smaller than it. A longer tool works, and makes another solid. \
         Rounding bounds work at every distance.",
    )
}

/// The same plate twice: ends that are one only if equal bit for bit, and as the surfaces' errors allow.
pub fn pictures(seed: u64, size: usize, samples: u32) -> Figure {
    let colours = [COLOURS[1], COLOURS[3]];
    let exact = portrait(Box::new(ByLists(tree(home(seed, 3, 0.04, 0.0), 0.0))), &colours, size, samples);
    let derived = portrait(Box::new(solid(tree(home(seed, 3, 0.04, 0.0), 0.0))), &colours, size, samples);
    Figure::from(
        Panels::new()
            .columns(2)
            .title("Rounding puts a lid on an open pocket")
            .subtitle("the same solid and the same rays; the rule for coincident faces differs")
            .picture(exact, "equal bit for bit")
            .picture(derived, "by rounding bounds (default)")
            .alt("Two pictures of a blue plate with a square pocket: in the left one the pocket is closed by a speckled sheet, in \
                  the right one it is open."),
    )
    .caption("Where the tool's face comes out a rounding lower than the plate's, the ray hits a sheet without thickness.")
}
