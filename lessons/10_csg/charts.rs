//! Speed against accuracy, over the size of the tree.

use super::contestants::{Way, agree, truth};
use super::solids::{EYE, ball, camera, cube, rays, rod, solid, sponge};
use glam::{DAffine3, DVec3, dvec3};
use lightbench::csg::Tree;
use lightbench::measure::{Method, Point, Series, Spread, Tally, time_each};
use lightbench::ray::Ray;
use lightbench_kit::figure::{Axis, Chart, Figure};

/// Method, and a point for each tree.
pub type Contest = [(Method, Series); 4];

/// Trees of growing size. Each has something that a naive way stumbles over: rods that overlap, holes that pierce, a pocket
/// flush with its rim.
fn trees() -> [Tree; 4] {
    // Its top lies in the cube's, by another path.
    let pocket = || {
        let map = DAffine3::from_translation(dvec3(0.0, 1.2, 0.0))
            * DAffine3::from_rotation_y(0.4)
            * DAffine3::from_scale(dvec3(0.8, 0.3, 0.8));
        cube().moved(map * DAffine3::from_scale(DVec3::splat(1.0 / 1.5))).expect("a map of space")
    };
    let rods = || rod(DVec3::X).union(rod(DVec3::Y)).union(rod(DVec3::Z));
    [
        cube().difference(pocket()),
        cube().intersection(ball(DVec3::ZERO, 2.0)).difference(rods()),
        sponge(3).difference(pocket()),
        sponge(5).difference(pocket()),
    ]
}

fn method(way: Way) -> Method {
    match way {
        Way::Diagram => Method::default_of("root diagram, front to back").styled(0),
        Way::Lists => Method::new("whole lists at every node").styled(1),
        Way::Tested => Method::new("every end tested").styled(2),
        Way::AsPrinted => Method::as_printed("as printed [D]"),
    }
}

pub fn contest(size: usize, timed: usize) -> Contest {
    let rays: Vec<Ray> = rays(&camera(EYE), size);
    let sets: Vec<_> = trees().into_iter().zip(trees()).map(|(tree, made)| (tree, solid(made))).collect();
    let truths: Vec<Vec<Option<f64>>> =
        sets.iter().map(|(tree, _)| rays.iter().map(|r| truth(tree, r)).collect()).collect();
    // Rays through the middle of the picture, for the clock: all of them meet the solid's bounds.
    let middle: Vec<Ray> = self::rays(&camera(EYE), timed * 2)
        .into_iter()
        .enumerate()
        .filter(|(n, _)| {
            (n % (2 * timed)).abs_diff(timed) < timed / 2 && (n / (2 * timed)).abs_diff(timed) < timed / 2
        })
        .map(|(_, ray)| ray)
        .collect();
    Way::ALL.map(|way| {
        let point = |((tree, made), truths): (&(Tree, _), &Vec<Option<f64>>)| {
            let (mut tally, mut wrong) = (Tally::new(), 0usize);
            for (ray, right) in rays.iter().zip(truths) {
                let found = way.first(tree, made, ray);
                let fails = !agree(found, *right);
                wrong += usize::from(fails);
                tally.answer(found.filter(|_| !(fails && right.is_some())), *right);
            }
            let time =
                time_each(middle.len(), || middle.iter().filter_map(|r| way.first(tree, made, r)).count());
            let share = wrong as f64 / rays.len() as f64;
            Point { parameter: tree.leaves() as f64, failures: tally.failures(), ..Point::default() }
                .timed(time)
                .erred(Spread::exact(share))
        };
        (method(way), Series::new(sets.iter().zip(&truths).map(point).collect()))
    })
}

pub fn wrong(contest: &Contest, way: usize) -> u64 {
    contest[way].1.points.iter().map(|p| p.failures.total()).sum()
}

/// How many times as long whole lists take for the largest tree.
pub fn quotient(contest: &Contest) -> f64 {
    let time = |way: usize| contest[way].1.points.last().and_then(|p| p.time).map_or(f64::NAN, |t| t.mid);
    time(1) / time(0)
}

fn ordinal(n: f64) -> String {
    match n.round() as u64 {
        2 => "half".to_string(),
        3 => "third".to_string(),
        n => format!("{n}th"),
    }
}

pub fn speed(contest: &Contest, size: usize) -> Figure {
    let sizes: Vec<String> = contest[0].1.points.iter().map(|p| format!("{}", p.parameter)).collect();
    let mut chart = Chart::speed_accuracy("wrong pixels, share of the picture")
        .x(Axis::time("time per ray through the solid, first hit"))
        .title(&format!(
            "Front to back, {} leaves take a {} of the time of whole lists, and no pixel is wrong",
            sizes.last().map_or("", String::as_str),
            ordinal(quotient(contest))
        ))
        .subtitle(&format!(
            "trees of {} leaves, from left to right on each line; {size} × {size} rays each, the truth by all leaves at once",
            sizes.join(", ")
        ));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Speed against accuracy over the size of the tree: box less pocket, D's tree, and boxes with 27 and 125 round holes and a \
         pocket flush with the rim. Time: first hit, median of nine runs with quartiles. The lower strip counts missing and \
         false hits; a hit elsewhere counts as missing.",
    )
}
