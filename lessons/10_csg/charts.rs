//! Speed against accuracy, over the size of the tree.

use super::contestants::{Way, agree, truth};
use super::solids::{EYE, ball, camera, cube, rays, rod, solid, sponge};
use glam::{DAffine3, DVec3, dvec3};
use lightbench::csg::Tree;
use lightbench::measure::{Method, Point, Ratio, Series, Spread, Tally, time_each};
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
        Way::AsPrinted => Method::as_printed("as printed"),
    }
}

pub fn contest(size: usize, timed: usize) -> Contest {
    let rays: Vec<Ray> = rays(&camera(EYE), size);
    let sets: Vec<_> = trees().into_iter().zip(trees()).map(|(tree, made)| (tree, solid(made))).collect();
    let truths: Vec<Vec<Option<f64>>> =
        sets.iter().map(|(tree, _)| rays.iter().map(|r| truth(tree, r)).collect()).collect();
    let middle = middle(timed);
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

/// Rays that a way answers wrongly, over all trees.
pub fn wrong(contest: &Contest, way: &str) -> u64 {
    contest.iter().filter(|(method, _)| method.name == way).map(|(_, series)| series.failures().total()).sum()
}

/// Rays that each way answers, over all trees.
pub fn asked(contest: &Contest) -> u64 {
    contest[0].1.failures().of
}

/// Leaves of the largest tree.
pub fn largest(contest: &Contest) -> f64 {
    contest[0].1.points.last().map_or(0.0, |p| p.parameter)
}

/// Rays through the middle of the picture, all of which hit the solid's bounds.
fn middle(size: usize) -> Vec<Ray> {
    let near = |i: usize| i.abs_diff(size) < size / 2;
    let all = rays(&camera(EYE), size * 2).into_iter().enumerate();
    all.filter(|(n, _)| near(n % (2 * size)) && near(n / (2 * size))).map(|(_, ray)| ray).collect()
}

/// How many times as long merging whole lists takes as walking front to back, for the largest tree.
pub fn slower() -> Ratio {
    let [.., tree] = trees();
    let [.., made] = trees();
    let (made, rays) = (solid(made), middle(6));
    let hits = |way: Way| rays.iter().filter_map(|r| way.first(&tree, &made, r)).count();
    Ratio::measured(|| hits(Way::Lists), || hits(Way::Diagram))
}

/// Error against time, over the size of the tree.
pub fn speed(contest: &Contest, size: usize) -> Figure {
    let sizes: Vec<String> = contest[0].1.points.iter().map(|p| format!("{}", p.parameter)).collect();
    let mut chart = Chart::speed_accuracy("wrong pixels, fraction of the picture")
        .x(Axis::time("time per ray through the solid, first hit"))
        .title("Root diagrams leave no pixel wrong")
        .subtitle(&format!("trees of {} leaves; {size} × {size} rays each", sizes.join(", ")));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Each line joins four trees, the largest on the right. Time: median of nine runs with quartiles. The lower strip \
         counts missing and false hits; a hit elsewhere counts as missing.",
    )
}
