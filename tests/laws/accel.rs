//! Every structure answers as no structure does, to the bit.

use glam::{DAffine3, DQuat, DVec3};
use lightbench::accel::{Ball, Bvh, Facets, Hull, Hulls, Octree, Splitting, as_printed_nearest};
use lightbench::bounds::Aabb;
use lightbench::mesh::{Mesh, Polygons};
use lightbench::num::vectors::Vectors;
use lightbench::ray::{Crossing, Ray, Silent, Tally};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::fan::{Ends, Fan};
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::{PreparedRay, Triangle, icosphere};
use proptest::prelude::*;
use proptest::test_runner::Config;
use std::sync::Arc;

fn config() -> Config {
    Config { cases: 300, failure_persistence: None, ..Config::default() }
}

/// The answer without a structure: every item, in order; a tie keeps the earlier one.
fn scan(shapes: &[Box<dyn Shape>], ray: &Ray, t_min: f64, t_max: f64) -> Option<(u32, Crossing)> {
    let mut best: Option<(u32, Crossing)> = None;
    for (item, shape) in (0..).zip(shapes) {
        let limit = best.map_or(t_max, |(_, c)| c.t);
        if let Some(c) = shape.nearest(ray, t_min, limit) {
            best = Some((item, c));
        }
    }
    best
}

/// Coordinates on a coarse grid meet each other's faces and corners; others lie anywhere, near and far.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-8i32..=8).prop_map(|i| f64::from(i) * 0.25),
        4 => -2.0..2.0,
        1 => Just(-0.0),
        1 => Just(1e-300),
        1 => -1e6..1e6,
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    [number(), number(), number()].prop_map(DVec3::from_array)
}

/// Directions along axes, in planes, almost so, and anywhere; of any length.
fn direction() -> impl Strategy<Value = DVec3> {
    let lengths = prop_oneof![Just(1.0), Just(1e-3), Just(1e8)];
    (point(), lengths).prop_map(|(d, length)| d * length).prop_filter("no direction", |d| *d != DVec3::ZERO)
}

fn ray() -> impl Strategy<Value = Ray> {
    let far = prop_oneof![4 => Just(0.0), 1 => Just(1e9), 1 => Just(1e20)];
    (point(), direction(), far).prop_map(|(o, d, away)| Ray::new(o - d * away, d))
}

fn shape() -> impl Strategy<Value = Option<Box<dyn Shape>>> {
    let triangle = [point(), point(), point()]
        .prop_map(|[a, b, c]| Triangle::new(a, b, c).ok().map(|t| Box::new(t) as Box<dyn Shape>));
    let sphere = (point(), 0.01..2.0f64)
        .prop_map(|(c, r)| Sphere::new(c, r).ok().map(|s| Box::new(s) as Box<dyn Shape>));
    prop_oneof![3 => triangle, 1 => sphere]
}

/// Up to sixty shapes, some of them several times.
fn shapes() -> impl Strategy<Value = Vec<Box<dyn Shape>>> {
    proptest::collection::vec(shape(), 0..60).prop_map(|s| s.into_iter().flatten().collect())
}

fn boxes(shapes: &[Box<dyn Shape>]) -> Vec<Aabb> {
    shapes.iter().map(|s| s.bounds()).collect()
}

#[test]
fn bvh_answers_as_no_structure() {
    proptest!(config(), |(shapes in shapes(), rays in proptest::collection::vec(ray(), 20))| {
        let bvh = Bvh::build(&boxes(&shapes));
        let baseline = bvh.clone().with_vectors(Vectors::Baseline);
        for ray in &rays {
            let truth = scan(&shapes, ray, 0.0, f64::INFINITY);
            let mut counts = [Tally::default(); 2];
            for (bvh, count) in [&bvh, &baseline].into_iter().zip(&mut counts) {
                let found = bvh.nearest(ray, 0.0, f64::INFINITY, count, |i, limit| {
                    shapes[i as usize].nearest(ray, 0.0, limit)
                });
                prop_assert_eq!(found, truth, "{:?}", ray);
            }
            prop_assert_eq!(counts[0], counts[1]);
            let blocker = bvh.any(ray, 0.0, 1.0, &mut counts[0], |i| shapes[i as usize].blocks(ray, 1.0));
            prop_assert_eq!(blocker.is_some(), shapes.iter().any(|s| s.blocks(ray, 1.0)));
        }
    });
}

/// Triangles of any kind, without area too, some of them several times.
fn triangles() -> impl Strategy<Value = Vec<[DVec3; 3]>> {
    let small = (point(), [point(), point(), point()])
        .prop_map(|(at, corners)| corners.map(|v| at + v.clamp(DVec3::NEG_ONE, DVec3::ONE) * 0.25));
    let triangle = prop_oneof![1 => [point(), point(), point()], 3 => small];
    (proptest::collection::vec(triangle, 0..80), 0usize..3).prop_map(|(mut triangles, twice)| {
        triangles.extend_from_within(..triangles.len().min(twice * 4));
        triangles
    })
}

/// At corners, edges and inner points, or past everything.
fn aimed(triangles: &[[DVec3; 3]], ray: &Ray, k: usize) -> Ray {
    let Some(&[a, b, c]) = triangles.get(k * 7 % triangles.len().max(1)) else { return *ray };
    let target = [a, (a + b) * 0.5, (a + b + c) / 3.0, b * 0.25 + c * 0.75][k % 4];
    let d = target - ray.origin;
    if k % 5 == 4 || d == DVec3::ZERO { *ray } else { Ray::new(ray.origin, d) }
}

#[test]
fn facets_answer_as_no_structure() {
    proptest!(config(), |(triangles in triangles(), rays in proptest::collection::vec(ray(), 20))| {
        let facets = Facets::build(triangles.len(), |i| triangles[i as usize]);
        let baseline = facets.clone().with_vectors(Vectors::Baseline);
        for (k, ray) in rays.iter().enumerate() {
            let ray = aimed(&triangles, ray, k);
            let prepared = PreparedRay::new(&ray);
            let meet = |i: u32, limit: f64| {
                prepared.meet(triangles[i as usize]).map(|m| m.t).filter(|&t| 0.0 < t && t < limit)
            };
            let mut truth: Option<(u32, f64)> = None;
            for i in 0..triangles.len() as u32 {
                truth = meet(i, truth.map_or(f64::INFINITY, |(_, t)| t)).map(|t| (i, t)).or(truth);
            }
            let mut counts = [Tally::default(); 2];
            for (facets, count) in [&facets, &baseline].into_iter().zip(&mut counts) {
                prop_assert_eq!(facets.nearest(&ray, 0.0, f64::INFINITY, count, meet), truth, "{:?}", ray);
            }
            prop_assert_eq!(counts[0], counts[1]);
            let all: Vec<u32> = (0..triangles.len() as u32).filter(|&i| meet(i, 1.0).is_some()).collect();
            let mut met = Vec::new();
            facets.each(&ray, 0.0, 1.0, &mut Silent, |i| met.extend(meet(i, 1.0).map(|_| i)));
            met.sort_unstable();
            prop_assert_eq!(&met, &all);
            let blocker = facets.any(&ray, 0.0, 1.0, &mut Silent, |i| meet(i, 1.0).is_some());
            prop_assert_eq!(blocker.is_some(), !all.is_empty());
        }
    });
}

#[test]
fn hulls_and_octrees_answer_as_no_structure() {
    let splittings = [
        Splitting { threshold: 3, depth: 6 },
        Splitting::D,
        Splitting::to_depth(4),
        Splitting { threshold: 0, depth: 0 },
    ];
    proptest!(config(), |(shapes in shapes(), rays in proptest::collection::vec(ray(), 10))| {
        let boxes = boxes(&shapes);
        let hulls = [Hull::Box, Hull::Ball].map(|hull| Hulls::build(&boxes, hull));
        let octrees = splittings.map(|s| Octree::build(&boxes, s));
        for ray in &rays {
            let truth = scan(&shapes, ray, 0.0, f64::INFINITY);
            let test = |i: u32, limit: f64| shapes[i as usize].nearest(ray, 0.0, limit);
            for hulls in &hulls {
                prop_assert_eq!(hulls.nearest(ray, 0.0, f64::INFINITY, &mut Silent, test), truth, "{:?}", ray);
            }
            for octree in &octrees {
                let found = octree.nearest(ray, 0.0, f64::INFINITY, &mut Silent, &mut Vec::new(), test);
                prop_assert_eq!(found, truth, "{:?}", ray);
                let mut met = false;
                octree.each(ray, 0.0, f64::INFINITY, &mut Silent, |i| met |= Some(i) == truth.map(|t| t.0));
                prop_assert_eq!(met, truth.is_some());
            }
        }
    });
}

/// More polygons than the threshold in one point, or everywhere: D's rule never ends.
#[test]
fn octrees_end_where_no_cube_is_small_enough() {
    let point = Aabb::new(DVec3::splat(0.3), DVec3::splat(0.3));
    let far = Aabb::new(DVec3::ONE, DVec3::ONE);
    let mut fan = vec![point; 301];
    fan.extend([Aabb::new(DVec3::ZERO, DVec3::ZERO), far]);
    let octree = Octree::build(&fan, Splitting::D);
    assert_eq!(octree.cubes().iter().map(|c| c.level).max(), Some(16));
    // At most the eight around the point on each level.
    assert!(octree.cubes().len() <= 8 * 16 + 1, "{}", octree.cubes().len());
    // Everything everywhere: splitting only copies.
    let whole = vec![Aabb::new(DVec3::ZERO, DVec3::ONE); 1000];
    let octree = Octree::build(&whole, Splitting { threshold: 10, depth: 100 });
    let held: usize = octree.cubes().iter().map(|c| octree.held(c).len()).sum();
    assert!(held <= 33 * 1000, "{held}");
    // A single point has no eighths.
    assert_eq!(Octree::build(&[point; 400], Splitting::D).cubes().len(), 1);
}

#[test]
fn boxes_hold_their_children_and_items() {
    let corners = icosphere(4);
    let items: Vec<Aabb> = corners.iter().map(|c| Aabb::of_points(*c)).collect();
    let boxes = Bvh::build(&items).boxes();
    let mut seen = vec![false; items.len()];
    let holds = |a: &Aabb, b: &Aabb| a.union(b) == *a;
    for (k, (level, outer, item)) in boxes.iter().enumerate() {
        match item {
            Some(item) => {
                assert!(holds(outer, &items[*item as usize]));
                assert!(!std::mem::replace(&mut seen[*item as usize], true));
            }
            // Some node above holds it: of those before, one of the level below is the parent.
            None if *level > 0 => {
                assert!(boxes[..k].iter().any(|(l, b, i)| l + 1 == *level && i.is_none() && holds(b, outer)));
            }
            None => {}
        }
    }
    assert!(seen.iter().all(|s| *s));
}

#[test]
fn the_stack_has_room_for_every_tree() {
    // Boxes that halve again and again make the heuristic cut off one at a time.
    let chain: Vec<Aabb> = (0..1000)
        .map(|i| Aabb::new(DVec3::ZERO, DVec3::splat(0.5f64.powi(i % 120) * f64::from(1 + i / 120))))
        .collect();
    let soup: Vec<Aabb> = icosphere(5).iter().map(|c| Aabb::of_points(*c)).collect();
    let same = vec![Aabb::new(DVec3::ONE, DVec3::ONE); 5000];
    for boxes in [chain, soup, same] {
        let (worst, room) = Bvh::build(&boxes).stack();
        assert!(0 < worst && worst <= room, "{worst} of {room}");
    }
}

#[test]
fn few_strange_and_no_items_work() {
    let ray = Ray::new(DVec3::new(0.0, 0.0, -5.0), DVec3::Z);
    let infinite = f64::INFINITY;
    let strange = [
        Aabb::EMPTY,
        Aabb::EVERYTHING,
        Aabb::new(DVec3::splat(-1e300), DVec3::splat(1e300)),
        Aabb::new(DVec3::splat(-1e-300), DVec3::splat(1e-300)),
        Aabb::new(DVec3::ZERO, DVec3::ZERO),
        Aabb::new(DVec3::new(-1.0, -1.0, 2.0), DVec3::new(1.0, 1.0, infinite)),
        Aabb::new(DVec3::splat(f64::NAN), DVec3::splat(f64::NAN)),
        Aabb::new(DVec3::splat(3.0), DVec3::splat(4.0)),
    ];
    for count in 0..=strange.len() {
        let bvh = Bvh::build(&strange[..count]);
        let octree = Octree::build(&strange[..count], Splitting::to_depth(3));
        for found in [true, false] {
            let mut met = Vec::new();
            match found {
                true => bvh.each(&ray, 0.0, infinite, &mut Silent, |i| met.push(i)),
                false => octree.each(&ray, 0.0, infinite, &mut Silent, |i| met.push(i)),
            }
            met.sort_unstable();
            met.dedup();
            let wanted: Vec<u32> = (1..7).filter(|&i| (i as usize) < count).collect();
            // Items that are not on the ray may be named, but none that is on it may be left out.
            assert!(wanted.iter().all(|i| met.contains(i)), "{met:?} of {count}");
            assert!(!met.contains(&0));
        }
    }
    let rays = [
        Ray::new(DVec3::splat(1e308), DVec3::NEG_ONE),
        Ray::new(DVec3::ZERO, DVec3::splat(5e-324)),
        Ray::new(DVec3::ZERO, DVec3::splat(1e308)),
    ];
    for ray in rays {
        let mut met = 0;
        Bvh::build(&strange).each(&ray, 0.0, infinite, &mut Silent, |i| met += u32::from(i == 4));
        assert_eq!(met, 1, "{ray:?}");
    }
}

/// Lines in faces and edges of a lattice of boxes, from near and far, with −0: each box that is touched is named.
#[test]
fn rays_in_faces_lose_no_box() {
    let unit = |i: i32| Aabb::new(cell(i), cell(i) + DVec3::new(1.0, 1.0, f64::from(i % 2)));
    fn cell(i: i32) -> DVec3 {
        DVec3::new(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16 % 4))
    }
    let boxes: Vec<Aabb> = (0..64).map(unit).collect();
    let (bvh, octree) = (Bvh::build(&boxes), Octree::build(&boxes, Splitting { threshold: 4, depth: 5 }));
    for away in [1.0, 1e3, 1e15] {
        for (axis, y, z) in (0..3).flat_map(|a| (0..5).flat_map(move |y| (0..5).map(move |z| (a, y, z)))) {
            let mut origin = DVec3::ZERO;
            origin[(axis + 1) % 3] = f64::from(y);
            origin[(axis + 2) % 3] = f64::from(z);
            origin[axis] = -away;
            let mut direction = DVec3::splat(-0.0);
            direction[axis] = 1.0;
            let ray = Ray::new(origin, direction);
            let touched = |b: &Aabb| {
                let on = |i: usize| b.min[i] <= origin[i] && origin[i] <= b.max[i];
                on((axis + 1) % 3) && on((axis + 2) % 3)
            };
            let (mut by_bvh, mut by_octree) = ([false; 64], [false; 64]);
            bvh.each(&ray, 0.0, f64::INFINITY, &mut Silent, |i| by_bvh[i as usize] = true);
            octree.each(&ray, 0.0, f64::INFINITY, &mut Silent, |i| by_octree[i as usize] = true);
            for (i, b) in boxes.iter().enumerate().filter(|(_, b)| touched(b)) {
                assert!(by_bvh[i] && by_octree[i], "{ray:?} {b:?}");
                let slab = b.slab(ray.origin, ray.direction.recip(), 0.0, f64::INFINITY);
                assert!(slab.is_some(), "{ray:?} {b:?}");
            }
        }
    }
}

/// Lines are tested behind their origin too. On a grid the sums are exact: the point of the box lies on the line.
#[test]
fn slabs_are_wide_behind_the_origin() {
    let grid = || [-8i32..=8, -8..=8, -8..=8].prop_map(|v| DVec3::from_array(v.map(|i| f64::from(i) * 0.25)));
    let direction = grid().prop_filter("no direction", |d| *d != DVec3::ZERO);
    let share = || (0i32..=4).prop_map(|i| f64::from(i) * 0.25);
    proptest!(config(), |(corner in grid(), size in grid(), d in direction, s in [share(), share(), share()])| {
        let b = Aabb::of_points([corner, corner + size]);
        let target = b.min + (b.max - b.min) * DVec3::from_array(s);
        for way in [1.0, -1.0, 3.0, -7.0] {
            let line = b.slab(target - d * way, d.recip(), f64::NEG_INFINITY, f64::INFINITY);
            prop_assert!(line.is_some_and(|(_, leave)| way <= leave));
        }
    });
}

/// Counts change only when the tree or the walk does: then look whether they changed for the better.
#[test]
fn counts_are_pinned() {
    let corners = icosphere(4);
    let boxes: Vec<Aabb> = corners.iter().map(|c| Aabb::of_points(*c)).collect();
    let (bvh, facets) = (Bvh::build(&boxes), Facets::build(corners.len(), |i| corners[i as usize]));
    let octree = Octree::build(&boxes, Splitting { threshold: 30, depth: 16 });
    let mut counts = [Tally::default(); 3];
    for k in 0..1000 {
        let at = |salt: u64| uniform_sphere(Sampler::new(12, salt, k).next_2d()) * 1.5;
        let ray = Ray::new(at(0), at(1) - at(0));
        let prepared = PreparedRay::new(&ray);
        let meet = |i: u32, limit: f64| {
            prepared.meet(corners[i as usize]).map(|m| m.t).filter(|&t| 0.0 < t && t < limit)
        };
        let found = [
            bvh.nearest(&ray, 0.0, f64::INFINITY, &mut counts[0], meet),
            facets.nearest(&ray, 0.0, f64::INFINITY, &mut counts[1], meet),
            octree.nearest(&ray, 0.0, f64::INFINITY, &mut counts[2], &mut Vec::new(), meet),
        ];
        assert!(found[0] == found[1] && found[0] == found[2]);
    }
    let counts = counts.map(|c| (c.node_visits, c.shape_tests));
    assert_eq!(counts, [(4278, 1419), (4395, 507), (6208, 34779)]);
}

/// The printed search returns a farther thing if it is farther by less than 10⁻⁶.
#[test]
fn as_printed_the_last_of_near_things_wins() {
    let ray = Ray::new(DVec3::ZERO, DVec3::Z);
    let hull = |_| Ball { center: DVec3::Z, radius: 2.0 };
    let distances = [1.0, 1.0 + 1e-7, 2.0];
    let found = as_printed_nearest(0..3, hull, &ray, |i| Some(distances[i as usize]));
    assert_eq!(found, Some((1, distances[1])));
}

fn spheres(count: u32) -> Scene {
    let camera =
        Camera::new(DVec3::new(0.0, 0.0, 9.0), DVec3::ZERO, DVec3::Y, FieldOfView::Vertical(0.7)).unwrap();
    let mut scene = Scene::new(camera);
    scene.materials.push(Material::default());
    for i in 0..count {
        let mut sampler = Sampler::new(3, 0, i);
        let center = uniform_sphere(sampler.next_2d()) * 2.5;
        let sphere = Sphere::new(center, 0.2 + 0.3 * sampler.next_1d()).unwrap();
        scene.objects.push(Object::new("sphere", Box::new(sphere), 0));
    }
    scene
}

#[test]
fn five_spheres_build_nothing_and_many_do_when_asked() {
    assert!(spheres(5).objects.hierarchy().is_none());
    let mut scene = spheres(30);
    assert!(scene.objects.hierarchy().is_some());
    // Unbounded things are no reason for one.
    let planes =
        (0..30).map(|_| Object::new("plane", Box::new(Plane::new(DVec3::ZERO, DVec3::Y).unwrap()), 0));
    scene.objects = planes.collect();
    assert!(scene.objects.hierarchy().is_none());
}

#[test]
fn a_hierarchy_changes_no_answer_of_a_scene() {
    let mut scene = spheres(200);
    scene.objects.push(Object::new("floor", Box::new(Plane::new(DVec3::NEG_Y, DVec3::Y).unwrap()), 0));
    let mut met = 0;
    for k in 0..2000 {
        let at = |salt: u64| uniform_sphere(Sampler::new(5, salt, k).next_2d()) * 4.0;
        let ray = Ray::new(at(0), at(1) - at(0));
        let found = scene.nearest(&ray, f64::INFINITY, &mut Silent);
        let all = scene.objects.iter().enumerate();
        let plain = all.filter_map(|(i, o)| Some((i, o.shape().nearest(&ray, 0.0, f64::INFINITY)?)));
        // Of equal ones `min_by` keeps the first.
        assert_eq!(found, plain.min_by(|a, b| a.1.t.total_cmp(&b.1.t)));
        met += usize::from(found.is_some());
        let blocks = scene.objects.iter().any(|o| o.shape().blocks(&ray, 0.7));
        assert_eq!(scene.blocker(&ray, 0.7, &mut Silent).is_some(), blocks);
    }
    assert!(met > 500);
    let mut ends = Ends::within(DVec3::new(0.0, 6.0, 0.0), 1.0);
    ends.place((0..64).map(|k| DVec3::new(0.0, 6.0, 0.0) + uniform_sphere(Sampler::new(6, 0, k).next_2d())));
    for k in 0..50 {
        let mut fan = Fan::new(Vectors::Widest);
        fan.aim(uniform_sphere(Sampler::new(7, 0, k).next_2d()) * 3.0, &ends);
        let (mut lit, mut plain) = (vec![1.0; fan.padded_len()], vec![1.0; fan.padded_len()]);
        scene.shade(&fan, &mut lit, &mut Silent);
        scene.objects.iter().for_each(|o| o.shape().shade(&fan, &mut plain));
        assert_eq!(lit[..fan.len()], plain[..fan.len()]);
    }
}

/// Two levels: a hierarchy over instances of a mesh, which has a hierarchy of its own, and exists once.
#[test]
fn instances_share_a_mesh() {
    let mesh = Arc::new(Mesh::new(&Polygons::of_triangles(&icosphere(2))).unwrap());
    let place = |i: u32| {
        let mut sampler = Sampler::new(8, 0, i);
        let turn = DQuat::from_rotation_x(sampler.next_1d() * 6.0);
        DAffine3::from_scale_rotation_translation(
            DVec3::splat(0.2 + 0.3 * sampler.next_1d()),
            turn,
            uniform_sphere(sampler.next_2d()) * 3.0,
        )
    };
    let maps: Vec<DAffine3> = (0..40).map(place).collect();
    let shapes: Vec<Box<dyn Shape>> = maps
        .iter()
        .map(|m| Box::new(Instance::new(Box::new(mesh.clone()), *m).unwrap()) as Box<dyn Shape>)
        .collect();
    assert_eq!(Arc::strong_count(&mesh), 41);
    let bvh = Bvh::build(&boxes(&shapes));
    for k in 0..500 {
        let at = |salt: u64| uniform_sphere(Sampler::new(9, salt, k).next_2d()) * 4.0;
        let ray = Ray::new(at(0), at(1) - at(0));
        let found = bvh.nearest(&ray, 0.0, f64::INFINITY, &mut Silent, |i, limit| {
            shapes[i as usize].nearest(&ray, 0.0, limit)
        });
        assert_eq!(found, scan(&shapes, &ray, 0.0, f64::INFINITY));
    }
}
