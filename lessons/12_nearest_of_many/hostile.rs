//! Rays that break careless searches: in faces of boxes, along axes, from far away, among tiny things.

use glam::{DVec3, dvec3};
use lightbench::accel::{Ball, as_printed_nearest};
use lightbench::bounds::Aabb;
use lightbench::measure::Method;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::PreparedRay;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Shades, Table, grouped};

/// `1/d` times the distances of the planes, smaller and larger by comparison, as it is often written: is the box met, and
/// did a NaN arise?
fn naive_slab(b: &Aabb, ray: &Ray) -> (bool, bool) {
    let (mut enter, mut leave, mut nan) = (0.0, f64::INFINITY, false);
    for axis in 0..3 {
        let inverse = 1.0 / ray.direction[axis];
        let p = (b.min[axis] - ray.origin[axis]) * inverse;
        let q = (b.max[axis] - ray.origin[axis]) * inverse;
        nan |= p.is_nan() || q.is_nan();
        let (near, far) = if p < q { (p, q) } else { (q, p) };
        enter = if enter > near { enter } else { near };
        leave = if leave < far { leave } else { far };
    }
    (enter <= leave, nan)
}

/// The same with `min` and `max` that drop a NaN, and nothing against roundings.
fn guarded_slab(b: &Aabb, ray: &Ray) -> bool {
    let (mut enter, mut leave) = (0.0f64, f64::INFINITY);
    for axis in 0..3 {
        let inverse = 1.0 / ray.direction[axis];
        let p = (b.min[axis] - ray.origin[axis]) * inverse;
        let q = (b.max[axis] - ray.origin[axis]) * inverse;
        enter = enter.max(p.min(q));
        leave = leave.min(p.max(q));
    }
    enter <= leave
}

fn our_slab(b: &Aabb, ray: &Ray) -> bool {
    b.slab(ray.origin, ray.direction.recip(), 0.0, f64::INFINITY).is_some()
}

/// What became of rays of one kind that all meet their box.
pub struct Hostile {
    kind: &'static str,
    rays: u32,
    nan: u32,
    /// By the careless test, by one that drops NaN, by ours.
    pub lost: [u32; 3],
}

/// A point of a box, on some of its faces by chance, and a ray to it.
type Case = fn(&mut Sampler) -> (Aabb, Ray);

/// A box on a grid of quarters, so that sums are exact; sometimes without thickness.
fn grid_box(s: &mut Sampler) -> Aabb {
    let mut whole = |n: f64| (s.next_1d() * n).floor() * 0.25;
    let low = dvec3(whole(16.0), whole(16.0), whole(16.0));
    Aabb::new(low, low + dvec3(whole(4.0), whole(4.0), whole(4.0)))
}

fn along_axis(s: &mut Sampler, on_face: bool, zero: f64) -> (Aabb, Ray) {
    let b = grid_box(s);
    let axis = (s.next_1d() * 3.0) as usize % 3;
    let mut target = b.min + (b.max - b.min) * DVec3::from_array([0; 3].map(|_| s.next_1d()));
    if on_face {
        target[(axis + 1) % 3] = b.min[(axis + 1) % 3];
    }
    let mut direction = DVec3::splat(zero);
    direction[axis] = 1.0;
    (b, Ray::new(target - direction * 8.0, direction))
}

const CASES: [(&str, Case); 5] = [
    ("along an axis, through a box", |s| along_axis(s, false, 0.0)),
    ("along an axis, in a face", |s| along_axis(s, true, 0.0)),
    ("the same with zeros −0", |s| along_axis(s, true, -0.0)),
    ("in the plane of a face, askew", |s| {
        let b = grid_box(s);
        let target = dvec3(b.min.x, (b.min.y + b.max.y) * 0.5, (b.min.z + b.max.z) * 0.5);
        let mut whole = || (s.next_1d() * 16.0).floor() - 7.5;
        let direction = dvec3(0.0, whole(), whole());
        (b, Ray::new(target - direction, direction))
    }),
    ("to the corner of a triangle, from 10⁶ sizes", |s| {
        loop {
            let (ray, corners) = to_a_corner(s, 1.0e6, 1.0e-12);
            if PreparedRay::new(&ray).meet(corners).is_some_and(|m| m.t > 0.0) {
                break (Aabb::of_points(corners), ray);
            }
        }
    }),
];

/// A triangle with a corner in a corner of its box, and a ray from `distance` to a point that is `inside` away from there.
fn to_a_corner(s: &mut Sampler, distance: f64, inside: f64) -> (Ray, [DVec3; 3]) {
    let corners = [dvec3(0.5, 0.1, 0.5), dvec3(1.5, 0.4, 0.5), dvec3(0.5, 0.7, 1.5)];
    let share = inside * (0.5 + s.next_1d());
    let (along, across) = ((corners[1] - corners[0]) * share, (corners[2] - corners[0]) * share);
    let target = corners[0] + along * s.next_1d() + across * s.next_1d();
    let way = uniform_sphere(s.next_2d());
    (Ray::new(target - way * distance, way), corners)
}

pub fn slabs(seed: u64, rays: u32) -> Vec<Hostile> {
    let judge = |(n, (kind, case)): (usize, (&'static str, Case))| {
        let mut found = Hostile { kind, rays, nan: 0, lost: [0; 3] };
        for k in 0..rays {
            let (b, ray) = case(&mut Sampler::new(seed, 20 + n as u64, k));
            let (is_met, nan) = naive_slab(&b, &ray);
            found.nan += u32::from(nan);
            found.lost[0] += u32::from(!is_met);
            found.lost[1] += u32::from(!guarded_slab(&b, &ray));
            found.lost[2] += u32::from(!our_slab(&b, &ray));
        }
        found
    };
    CASES.into_iter().enumerate().map(judge).collect()
}

pub fn table(slabs: &[Hostile]) -> Figure {
    let nan: u32 = slabs.iter().map(|s| s.nan).sum();
    let mut table = Table::new(&[
        "rays that meet a box",
        "rays",
        "NaN",
        "lost, careless",
        "lost, NaN dropped",
        "lost, ours",
    ])
    .title(&format!(
        "0 · ∞ is no number: it arises in {} of {} rays, and boxes are lost",
        grouped(u64::from(nan)),
        grouped(slabs.iter().map(|s| u64::from(s.rays)).sum())
    ))
    .subtitle("boxes on a grid, a quarter of them without thickness on some axis; every ray meets its box");
    for s in slabs {
        let cells = [s.rays, s.nan, s.lost[0], s.lost[1], s.lost[2]].map(|n| grouped(u64::from(n)));
        table = table.row(&[s.kind, &cells[0], &cells[1], &cells[2], &cells[3], &cells[4]]);
    }
    Figure::from(table).caption(
        "A ray that runs in a face makes (x − o)/d = 0 · ∞ = NaN. Careless comparisons let it decide; dropping it keeps these rays, but not those \
         whose entry and exit are rounded apart (Ize, 2013).",
    )
}

/// Share of hits that a slab test loses, over the distance of the origin and that of the hit from the box's corner.
pub fn map(seed: u64, (side, tries): (usize, u32)) -> Figure {
    let mut ours = 0;
    let map = FailureMap::new(
        Axis::log("distance of the ray's origin, in sizes of the triangle").range(1.0, 1.0e16),
        Axis::log("distance of the hit from a corner of the box, in sizes").range(1.0e-20, 1.0),
        "share of hits lost",
        (side, side),
        |distance, inside| {
            let (mut lost, mut asked) = (0, 0);
            for k in 0..tries {
                let mut s = Sampler::new(seed, distance.to_bits() ^ inside.to_bits().rotate_left(9), k);
                let (ray, corners) = to_a_corner(&mut s, distance, inside);
                if PreparedRay::new(&ray).meet(corners).is_some_and(|m| m.t > 0.0) {
                    let b = Aabb::of_points(corners);
                    asked += 1;
                    lost += u32::from(!guarded_slab(&b, &ray));
                    ours += u32::from(!our_slab(&b, &ray));
                }
            }
            // Where every ray is rounded past the triangle nobody is asked.
            Some(if asked == 0 { 0.0 } else { f64::from(lost) / f64::from(asked) })
        },
    )
    .shades(Shades::Linear)
    .range(0.0, 0.5)
    .failing_above(0.0, "loses hits");
    let share = map.failing_share();
    Figure::from(
        map.title(&format!(
            "Near the edges of a box a plain slab test loses hits to rounding: in {:.0} % of the map; ours loses {ours}",
            100.0 * share
        ))
        .subtitle(&format!(
            "slab test without widening on the box of a triangle; {tries} rays a cell, of which those count that the watertight test meets"
        )),
    )
    .caption(
        "Entry and exit are rounded separately. Where a ray cuts a corner they are closer than that, cross, and the box is said to be missed: \
         below the line where the distance to the corner is that of a rounding of the ray. Our test moves the exit by the bound of its roundings.",
    )
}

/// A's printed search over the size of the scene: how often it returns the wrong sphere.
pub fn printed_search(seed: u64, rays: u32) -> Figure {
    let mut wrong = Vec::new();
    for k in 0..=20 {
        let size = 10f64.powf(-10.0 + f64::from(k) * 0.5);
        let sphere = |k: u32| {
            let mut s = Sampler::new(seed, 40, k);
            let center = uniform_sphere(s.next_2d()) * s.next_1d().cbrt();
            (center * size, 0.5 * size)
        };
        let balls: Vec<(DVec3, f64)> = (0..60).map(sphere).collect();
        let spheres: Vec<Sphere> = balls.iter().filter_map(|(c, r)| Sphere::new(*c, *r).ok()).collect();
        let t = |i: u32, ray: &Ray| spheres[i as usize].nearest(ray, 0.0, f64::INFINITY).map(|c| c.t);
        let hull = |i: u32| Ball { center: balls[i as usize].0, radius: balls[i as usize].1 };
        let is_wrong = |k: u32| {
            let mut s = Sampler::new(seed, 41, k);
            let [a, b] = [0; 2].map(|_| uniform_sphere(s.next_2d()) * (2.0 * size));
            let ray = Ray::new(a, (b - a).normalize_or(DVec3::X));
            let all = 0..spheres.len() as u32;
            let truth = all.clone().filter_map(|i| Some((i, t(i, &ray)?))).min_by(|a, b| a.1.total_cmp(&b.1));
            as_printed_nearest(all, hull, &ray, |i| t(i, &ray)) != truth
        };
        let count = (0..rays).filter(|&k| is_wrong(k)).count();
        wrong.push((size, count as f64 / f64::from(rays)));
    }
    let worst = wrong.iter().map(|w| w.1).fold(0.0, f64::max);
    Figure::from(
        Chart::new(
            Axis::log("radius of the scene [m]"),
            Axis::percent("rays that are given a wrong sphere"),
        )
        .title(&format!(
            "With DELTA = 10⁻⁶ the printed search takes the wrong of near things: {:.1} % of rays in a small scene",
            100.0 * worst
        ))
        .subtitle(&format!("60 spheres in a ball, {rays} chords a point; a later crossing wins if it is less than DELTA farther"))
        .guide(Guide::upright(1.0e-6, "DELTA"))
        .curve(Method::as_printed("as A prints it"), &wrong)
        .curve(Method::default_of("ties to the lower index").styled(0), &wrong.iter().map(|w| (w.0, 0.0)).collect::<Vec<_>>()),
    )
    .caption("After A, illustration 72: a constant with a unit decides which of two objects is nearer.")
}
