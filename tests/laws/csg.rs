//! Solids made of solids: the algebra of sets on spans and on points, ties, bounds, parts, and no memory taken.

use crate::shapes::{self, Inside, Member, Pose, rays};
use glam::{DAffine3, DMat3, DVec3};
use lightbench::csg::as_printed::as_printed;
use lightbench::csg::{Csg, CsgError, Operation, Side, Tree};
use lightbench::num::U;
use lightbench::ray::{Ray, Span};
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::quadric::Ellipsoid;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench::shape::{Shape, Solid};
use proptest::prelude::*;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// Counts what this thread asks of the heap.
struct Counting;

thread_local! {
    static ASKED: Cell<u64> = const { Cell::new(0) };
}

// Hands everything on to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = ASKED.try_with(|n| n.set(n.get() + 1));
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static HEAP: Counting = Counting;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn spans(solid: &dyn Solid, ray: &Ray) -> Vec<Span> {
    let mut out = Vec::new();
    solid.spans(ray, &mut out);
    out
}

fn ends(tree: Tree, ray: &Ray) -> Vec<(f64, f64)> {
    let solid = Csg::new(tree).expect("a small tree");
    spans(&solid, ray).iter().map(|s| (s.enter.t, s.leave.t)).collect()
}

/// A leaf as a value, so that the same may be built often.
#[derive(Clone, Copy, Debug)]
enum Leaf {
    Ball(DVec3, f64),
    Block(DVec3, DVec3),
    Rod(DVec3, DVec3, f64),
    Peak(DVec3, DVec3, f64),
    Ring(DVec3, f64),
    Egg(DVec3, DVec3),
    Half(DVec3, DVec3),
}

impl Leaf {
    fn solid(self) -> Box<dyn Solid> {
        match self {
            Leaf::Ball(c, r) => Box::new(Sphere::new(c, r).expect("a sphere")),
            Leaf::Block(a, b) => Box::new(Cuboid::new(a, b).expect("a box")),
            Leaf::Rod(a, b, r) => Box::new(Cylinder::new(a, b, r).expect("a cylinder")),
            Leaf::Peak(a, b, r) => Box::new(Cone::new(a, b, r, 0.3 * r).expect("a cone")),
            Leaf::Ring(c, turn) => {
                let map = DAffine3::from_translation(c) * DAffine3::from_rotation_x(turn);
                let torus = Torus::new(0.8, 0.3).expect("a torus");
                Box::new(Instance::new(Box::new(torus), map).expect("a map of space"))
            }
            Leaf::Egg(c, axes) => Box::new(Ellipsoid::new(c, axes).expect("an ellipsoid")),
            Leaf::Half(p, n) => Box::new(Plane::new(p, n).expect("a plane")),
        }
    }
}

/// A tree as a value.
#[derive(Clone, Debug)]
enum Plan {
    Leaf(Leaf),
    Node(Operation, Box<[Plan; 2]>),
}

impl Plan {
    fn tree(&self) -> Tree {
        match self {
            Plan::Leaf(leaf) => Tree::Leaf(leaf.solid()),
            Plan::Node(operation, pair) => Tree::node(*operation, pair[0].tree(), pair[1].tree()),
        }
    }

    /// The table on what is inside of each leaf, apart from all walking.
    fn side(&self, inside: &dyn Fn(&Leaf) -> bool) -> Side {
        match self {
            Plan::Leaf(leaf) => {
                if inside(leaf) {
                    Side::In
                } else {
                    Side::Out
                }
            }
            Plan::Node(o, pair) => o.combine(pair[0].side(inside), pair[1].side(inside)),
        }
    }

    fn leaves(&self, out: &mut Vec<Leaf>) {
        match self {
            Plan::Leaf(leaf) => out.push(*leaf),
            Plan::Node(_, pair) => pair.iter().for_each(|p| p.leaves(out)),
        }
    }
}

/// On a coarse grid, so that faces coincide and edges meet, and off it.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![2 => (-4..=4i32).prop_map(|n| 0.5 * f64::from(n)), 1 => -2.0..2.0f64]
}

fn vector() -> impl Strategy<Value = DVec3> {
    [number(), number(), number()].prop_map(DVec3::from_array)
}

fn size() -> impl Strategy<Value = f64> {
    prop_oneof![(1..=4i32).prop_map(|n| 0.5 * f64::from(n)), 0.1..2.0f64]
}

fn direction() -> impl Strategy<Value = DVec3> {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
    prop_oneof![prop::sample::select(axes.to_vec()), vector().prop_filter("none", |v| v.length() > 0.1)]
}

fn leaf() -> impl Strategy<Value = Leaf> {
    prop_oneof![
        (vector(), size()).prop_map(|(c, r)| Leaf::Ball(c, r)),
        (vector(), size(), size(), size()).prop_map(|(a, x, y, z)| Leaf::Block(a, a + DVec3::new(x, y, z))),
        (vector(), direction(), size()).prop_map(|(a, d, r)| Leaf::Rod(a, a + d, r)),
        (vector(), direction(), size()).prop_map(|(a, d, r)| Leaf::Peak(a, a + d, r)),
        (vector(), -3.0..3.0f64).prop_map(|(c, turn)| Leaf::Ring(c, turn)),
        (vector(), size(), size(), size()).prop_map(|(c, x, y, z)| Leaf::Egg(c, DVec3::new(x, y, z))),
        (vector(), direction()).prop_map(|(p, n)| Leaf::Half(p, n)),
    ]
}

fn operation() -> impl Strategy<Value = Operation> {
    prop::sample::select(Operation::ALL.to_vec())
}

fn plan() -> impl Strategy<Value = Plan> {
    leaf().prop_map(Plan::Leaf).prop_recursive(5, 24, 2, |inner| {
        (operation(), inner.clone(), inner).prop_map(|(o, a, b)| Plan::Node(o, Box::new([a, b])))
    })
}

/// From near, far, inside, and along the axes, hence along faces and tangent to what stands on the grid.
fn looks() -> impl Strategy<Value = Ray> {
    let distance = prop_oneof![Just(0.0), Just(3.0), Just(8.0), 0.0..20.0f64, Just(1.0e4)];
    (vector(), direction(), distance).prop_map(|(at, d, far)| Ray::new(at - d * far, d))
}

/// Ends of leaves closer than this stand for one place; coordinates are a few units, origins up to 10⁴ · 4 away, so that
/// an end is right to 64 u · 10⁵ ≈ 10⁻⁹ over the sine of the angle to its surface.
const CLOSE: f64 = 1.0e-6;

#[test]
fn spans_are_what_the_table_makes_of_the_leaves() {
    proptest!(config(1200), |(plan in plan(), ray in looks())| {
        let solid = Csg::new(plan.tree()).expect("a small tree");
        let found = spans(&solid, &ray);
        let stops: Vec<f64> = found.iter().flat_map(|s| [s.enter.t, s.leave.t]).collect();
        prop_assert!(stops.windows(2).all(|w| w[0] < w[1]), "{stops:?}");
        let mut leaves = Vec::new();
        plan.leaves(&mut leaves);
        let mut all: Vec<f64> = leaves.iter().flat_map(|l| spans(&*l.solid(), &ray)).flat_map(|s| [s.enter.t, s.leave.t]).collect();
        all.retain(|t| t.is_finite());
        all.extend([-1.0e6, 1.0e6]);
        all.sort_by(f64::total_cmp);
        for w in all.windows(2) {
            // In the middle between two ends of leaves no leaf's surface is near, and all must agree.
            let (middle, length) = (0.5 * (w[0] + w[1]), w[1] - w[0]);
            if length < CLOSE * (1.0 + ray.origin.length()) {
                continue;
            }
            let inside = |leaf: &Leaf| spans(&*leaf.solid(), &ray).iter().any(|s| s.enter.t < middle && middle < s.leave.t);
            let expected = plan.side(&inside) == Side::In;
            let is = found.iter().any(|s| s.enter.t < middle && middle < s.leave.t);
            prop_assert_eq!(is, expected, "at {} of {:?}", middle, all);
            // And no span without length hides there.
            let hidden = stops.iter().filter(|t| **t > w[0] + 0.1 * length && **t < w[1] - 0.1 * length);
            prop_assert_eq!(hidden.count(), 0);
        }
    });
}

#[test]
fn points_inside_are_what_the_table_makes_of_the_leaves() {
    proptest!(config(1200), |(plan in plan(), p in [-3.0..3.0f64, -3.0..3.0, -3.0..3.0])| {
        let p = DVec3::from_array(p);
        let solid = Csg::new(plan.tree()).expect("a small tree");
        let expected = plan.side(&|leaf| leaf.solid().contains(p));
        prop_assert_eq!(solid.contains(p), expected == Side::In);
        if solid.contains(p) {
            prop_assert!(solid.bounds().contains(p));
        }
    });
}

#[test]
fn the_nearest_is_the_first_crossing_from_wherever() {
    proptest!(config(800), |(plan in plan(), ray in looks(), from in -2.0..20.0f64)| {
        let solid = Csg::new(plan.tree()).expect("a small tree");
        let all: Vec<_> = spans(&solid, &ray).iter().flat_map(|s| [s.enter, s.leave]).filter(|c| c.t.is_finite()).collect();
        let mut ahead = Vec::new();
        solid.crossings(&ray, &mut ahead);
        let expected: Vec<_> = all.iter().filter(|c| c.t > 0.0).copied().collect();
        prop_assert_eq!(&ahead, &expected);
        for from in [from, 0.0] {
            let first = all.iter().find(|c| c.t > from).copied();
            prop_assert_eq!(solid.nearest(&ray, from, f64::INFINITY), first);
            if let Some(first) = first {
                prop_assert_eq!(solid.nearest(&ray, from, first.t), None);
                prop_assert_eq!(solid.nearest(&ray, from, first.t.next_up()), Some(first));
                prop_assert_eq!(solid.blocks(&ray, first.t.next_up()), ahead.first().is_some_and(|c| c.t <= first.t));
            }
        }
    });
}

/// `a − a` and the like are exact: the same leaf gives the same ends.
#[test]
fn the_algebra_of_sets_holds_on_spans() {
    proptest!(config(600), |(a in plan(), b in plan(), c in plan(), ray in looks())| {
        let [ta, tb, tc] = [&a, &b, &c].map(|p| move || p.tree());
        prop_assert_eq!(ends(ta().difference(ta()), &ray), vec![]);
        prop_assert_eq!(ends(ta().union(ta()), &ray), ends(ta(), &ray));
        prop_assert_eq!(ends(ta().intersection(ta()), &ray), ends(ta(), &ray));
        let close = |left: Tree, right: Tree| {
            let (left, right) = (ends(left, &ray), ends(right, &ray));
            // Slivers as long as their own rounding may come and go.
            let room = CLOSE * (1.0 + ray.origin.length());
            let seen = |all: &[(f64, f64)], t: f64| all.iter().any(|s| s.0 - room <= t && t <= s.1 + room);
            let long = |all: Vec<(f64, f64)>| all.into_iter().filter(|s| s.1 - s.0 > 8.0 * room).collect::<Vec<_>>();
            let middles = |all: Vec<(f64, f64)>| all.into_iter().map(|s| 0.5 * (s.0.max(-1e9) + s.1.min(1e9))).collect::<Vec<_>>();
            middles(long(left.clone())).iter().all(|t| seen(&right, *t)) && middles(long(right)).iter().all(|t| seen(&left, *t))
        };
        prop_assert!(close(ta().union(tb()), tb().union(ta())));
        prop_assert!(close(ta().intersection(tb()), tb().intersection(ta())));
        prop_assert!(close(ta().difference(tb().union(tc())), ta().difference(tb()).intersection(ta().difference(tc()))));
        prop_assert!(close(ta().difference(tb().intersection(tc())), ta().difference(tb()).union(ta().difference(tc()))));
        prop_assert!(close(ta().intersection(tb().union(tc())), ta().intersection(tb()).union(ta().intersection(tc()))));
        prop_assert!(close(ta().union(tb().intersection(tc())), ta().union(tb()).intersection(ta().union(tc()))));
    });
}

/// The whole is empty just outside of a hit, along its normal, and full just inside; edges aside.
#[test]
fn normals_point_out_of_the_whole() {
    proptest!(config(800), |(plan in plan(), ray in looks())| {
        let solid = Csg::new(plan.tree()).expect("a small tree");
        for s in spans(&solid, &ray) {
            for (c, way) in [(s.enter, -1.0), (s.leave, 1.0)] {
                if !c.t.is_finite() {
                    continue;
                }
                let hit = solid.hit(&ray, &c);
                prop_assert!(hit.ng.is_finite() && hit.point.is_finite() && hit.point_error.is_finite());
                // Entering runs against the normal, leaving along it; a graze is decided by rounding.
                let along = way * hit.ng.dot(ray.direction.normalize());
                prop_assert!(along > -1.0e-3, "{hit:?} {along}");
            }
        }
    });
}

/// Faces in one plane by two chains of maps: no cap, wherever the plate stands and however it is turned.
#[test]
fn coincident_faces_cancel_on_any_path() {
    let map = ([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], -3.0..3.0f64, 0.0..7.0f64, 0.5..2.0f64);
    proptest!(config(1200), |((axis, turn, far, stretch) in map, x in -0.8..0.8f64, z in -0.8..0.8f64, lean in [-0.7..0.7f64, -0.7..0.7])| {
        let axis = DVec3::from_array(axis).try_normalize().unwrap_or(DVec3::Y);
        let home = DAffine3::from_mat3_translation(DMat3::from_axis_angle(axis, turn) * stretch, axis * 10f64.powf(far));
        let cube = |map| Tree::leaf(Instance::new(Box::new(Cuboid::new(DVec3::NEG_ONE, DVec3::ONE).expect("a cube")), map).expect("a map"));
        let lift = DAffine3::from_translation(DVec3::Y * 0.25);
        let tool = home * (DAffine3::from_scale(DVec3::new(0.9, 0.8, 0.9)) * lift);
        let solid = Csg::new(cube(home).difference(cube(tool))).expect("two leaves");
        let top = DVec3::new(x, 1.0, z);
        let from = home.transform_point3(top + DVec3::new(lean[0], 3.0, lean[1]));
        let ray = Ray::new(from, home.transform_point3(top) - from);
        let first = solid.nearest(&ray, 0.0, f64::INFINITY).expect("the bottom or a wall");
        prop_assert!(first.t > 1.0 + 1.0e-3 || first.part == 1, "{first:?}");
        // And what leaves the bottom of the pocket for the viewer is not stopped by a cap.
        let hit = solid.hit(&ray, &first);
        let to = from - hit.point;
        prop_assert!(!solid.blocks(&Ray::new(hit.origin_towards(to), to), 1.0));
    });
}

#[test]
fn a_hit_names_its_leaf_and_a_hole_is_seen_from_inside() {
    let ball = |r| Tree::leaf(Sphere::new(DVec3::ZERO, r).expect("a sphere"));
    let solid = Csg::new(ball(2.0).difference(ball(1.0))).expect("two leaves");
    let ray = Ray::new(DVec3::ZERO, DVec3::X);
    let first = solid.nearest(&ray, 0.0, f64::INFINITY).expect("the inner wall");
    let hit = solid.hit(&ray, &first);
    assert_eq!((first.t, hit.part, hit.ng), (1.0, 1, DVec3::NEG_X));
    let next = solid.nearest(&ray, 1.0, f64::INFINITY).expect("the outer wall");
    let hit = solid.hit(&ray, &next);
    assert_eq!((next.t, hit.part, hit.ng), (2.0, 0, DVec3::X));
}

#[test]
fn of_coincident_surfaces_the_leaf_written_first_is_met() {
    let block = |from: f64, to: f64| {
        Tree::leaf(Cuboid::new(DVec3::new(from, -1.0, -1.0), DVec3::new(to, 1.0, 1.0)).expect("a box"))
    };
    let ray = Ray::new(DVec3::new(-5.0, 0.0, 0.0), DVec3::X);
    for operation in [Operation::Union, Operation::Intersection] {
        let solid = Csg::new(Tree::node(operation, block(0.0, 1.0), block(0.0, 2.0))).expect("two leaves");
        assert_eq!(solid.nearest(&ray, 0.0, f64::INFINITY).map(|c| c.part), Some(0));
    }
    assert_eq!(ends(block(0.0, 1.0).union(block(1.0, 2.0)), &ray), [(5.0, 7.0)], "no wall inside");
    assert_eq!(ends(block(0.0, 1.0).intersection(block(1.0, 2.0)), &ray), [], "no sheet");
    assert_eq!(ends(block(0.0, 1.0).difference(block(1.0, 2.0)), &ray), [(5.0, 6.0)]);
}

#[test]
fn trees_inside_trees_keep_their_parts() {
    let ball = |x: f64| Tree::leaf(Sphere::new(DVec3::X * x, 0.4).expect("a sphere"));
    let inner = || Csg::new(ball(1.0).union(ball(2.0))).expect("two leaves");
    let moved = Tree::leaf(inner()).moved(DAffine3::from_translation(DVec3::X * 4.0)).expect("a map");
    let solid = Csg::new(ball(0.0).union(Tree::leaf(inner())).union(moved)).expect("a small tree");
    let ray = Ray::new(DVec3::X * -3.0, DVec3::X);
    let parts: Vec<u32> = spans(&solid, &ray).iter().map(|s| s.enter.part).collect();
    assert_eq!((parts, solid.parts()), (vec![0, 1, 2, 3, 4], 5));
    for s in spans(&solid, &ray) {
        let hit = solid.hit(&ray, &s.enter);
        assert!((hit.point.x + 3.0 - s.enter.t).abs() <= 64.0 * U * 8.0 && hit.ng == DVec3::NEG_X, "{hit:?}");
    }
}

/// Long chains are balanced, deep alternations refused, and neither overflows the stack.
#[test]
fn deep_trees_are_balanced_or_refused() {
    let ball = |i: i32| Tree::leaf(Sphere::new(DVec3::X * f64::from(i), 0.25).expect("a sphere"));
    let ray = Ray::new(DVec3::X * -5.0, DVec3::X);
    for operation in Operation::ALL {
        let chain = Tree::all(operation, (0..3000).map(ball)).expect("some");
        let found = ends(chain, &ray).len();
        let expected = match operation {
            Operation::Union => 3000,
            Operation::Intersection => 0,
            Operation::Difference => 1,
        };
        assert_eq!(found, expected);
    }
    let deep = (0..2500).fold(ball(0), |tree, i| {
        let operation = if i % 2 == 0 { Operation::Union } else { Operation::Intersection };
        Tree::node(operation, tree, ball(i))
    });
    assert!(matches!(Csg::new(deep), Err(CsgError::TooDeep { found: 2500 })));
}

#[test]
fn no_ray_takes_memory_once_the_first_has_passed() {
    let ball = |i: i32| {
        Tree::leaf(Sphere::new(DVec3::new(f64::from(i % 5), f64::from(i / 5), 0.0), 0.6).expect("a sphere"))
    };
    let rod = Cylinder::new(DVec3::new(-1.0, 1.0, 0.0), DVec3::new(6.0, 1.0, 0.0), 0.4).expect("a cylinder");
    let ring = Torus::new(2.0, 0.5).expect("a torus");
    let tree = Tree::all(Operation::Union, (0..25).map(ball))
        .expect("some")
        .difference(Tree::leaf(rod))
        .union(Tree::leaf(ring));
    let solid = Csg::new(tree).expect("a small tree");
    let rays: Vec<Ray> = (0..400)
        .map(|i| {
            Ray::new(
                DVec3::new(-6.0, f64::from(i % 20) * 0.25, 0.3),
                DVec3::new(8.0, f64::from(i / 20) * 0.2 - 2.0, -0.3),
            )
        })
        .collect();
    let look = || {
        rays.iter().filter(|r| solid.nearest(r, 0.0, f64::INFINITY).is_some() | solid.blocks(r, 1.0)).count()
    };
    let hits = look();
    let before = ASKED.get();
    assert_eq!(look(), hits);
    assert_eq!(ASKED.get() - before, 0);
    assert!(hits > 100, "{hits}");
}

/// What D's rules keep of the cases in the list of errata.
#[test]
fn the_printed_rules_fail_as_the_errata_say() {
    let slab = |a: f64, b: f64| {
        Tree::leaf(Cuboid::new(DVec3::new(a, -1.0, -1.0), DVec3::new(b, 1.0, 1.0)).expect("a box"))
    };
    let from = |x: f64| Ray::new(DVec3::X * x, DVec3::X);
    let kept =
        |tree: &Tree, ray: &Ray| as_printed(tree, ray).iter().map(|m| m.crossing.t).collect::<Vec<_>>();
    assert_eq!(kept(&slab(1.0, 3.0).intersection(slab(2.0, 4.0)), &from(0.0)), [2.0, 3.0]);
    assert_eq!(kept(&slab(1.0, 2.0).intersection(slab(3.0, 4.0)), &from(0.0)), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(kept(&slab(1.0, 4.0).difference(slab(2.0, 3.0)), &from(0.0)), [1.0, 4.0]);
    assert_eq!(kept(&slab(-1.0, 4.0).union(slab(2.0, 3.0)), &from(0.0)), Vec::<f64>::new());
}

/// A rounded box with tunnels, about as large as the other shapes under the laws.
fn tunnels(pose: &Pose) -> Csg {
    let (s, o) = (pose.scale, pose.point(DVec3::ZERO));
    let half = DVec3::splat(0.75 * s);
    let rod = |v: DVec3| {
        Tree::leaf(Cylinder::new(o - pose.vector(v) * s, o + pose.vector(v) * s, 0.5 * s).expect("a rod"))
    };
    let block = Tree::leaf(Cuboid::new(o - half, o + half).expect("a box"));
    let ball = Tree::leaf(Sphere::new(o, s).expect("a ball"));
    let rods = rod(DVec3::X).union(rod(DVec3::Y)).union(rod(DVec3::Z));
    Csg::new(block.intersection(ball).difference(rods)).expect("five leaves")
}

const TUNNELS: Member = Member {
    make: |pose| Box::new(tunnels(pose)),
    solid: Some(|pose| Box::new(tunnels(pose))),
    near: |_, _, _| true,
    uv_slope: |_| 1.0,
    inside: Inside::Any,
};

#[test]
fn the_laws_of_shapes_hold() {
    shapes::crossings_ascend_and_nearest_is_the_first(&TUNNELS);
    shapes::normals_and_tangents_are_unit_and_square(&TUNNELS);
    // Of ends that the leaves' errors cannot tell apart the nearer counts: γ₁₆ of a size of 4.
    shapes::moved_together_stays_within(&TUNNELS, 64.0 * U);
    shapes::t_counts_lengths_of_the_direction(&TUNNELS);
    shapes::finite_input_never_makes_nan(&TUNNELS);
    shapes::entering_and_leaving_alternate(&TUNNELS);
    shapes::normals_point_outwards(&TUNNELS);
}

/// Texture coordinates lead back through the leaf that a part belongs to.
#[test]
fn texture_coordinates_lead_back_through_the_leaf() {
    let solid = tunnels(&Pose::HOME);
    proptest!(config(500), |(ray in rays())| {
        if let Some(c) = solid.nearest(&ray, 0.0, f64::INFINITY) {
            let hit = solid.hit(&ray, &c);
            let back = solid.leaf(hit.part).1.point_at(hit.face, hit.uv);
            prop_assert!((back - hit.point).length() <= 256.0 * U * (1.0 + hit.point.length()), "{hit:?}");
        }
    });
}
