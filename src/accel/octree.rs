//! Space cut into eight, again and again [A §5.6.2, D §5.4.8].
//!
//! D splits a cube while more polygons than a threshold reach into it. Where more than that meet in a point, or coincide,
//! no cube is ever small enough, so there are limits: to the depth, and to what all leaves hold together. A splits
//! everything down to a fixed depth: a threshold of 0. Cubes lie in one list, children side by side [D figs. 22, 23].

use super::Along;
use super::bvh::{Best, is_near};
use super::slabs::{LENGTHENED, Slabs};
use crate::bounds::Aabb;
use crate::ray::{Ray, Trace, Work};
use glam::DVec3;
use std::collections::VecDeque;

/// When a cube is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Splitting {
    /// More items than this in a cube split it: D's "umbral".
    pub threshold: usize,
    /// Cubes on this level are not split; the root is on level 0.
    pub depth: usize,
}

impl Splitting {
    /// What D settles for, with a depth that ends it: cubes of 2⁻¹⁶ of the whole.
    pub const D: Splitting = Splitting { threshold: 300, depth: 16 };

    /// A's octree: everything that is not empty, down to a depth.
    pub fn to_depth(depth: usize) -> Self {
        Splitting { threshold: 0, depth }
    }
}

/// A cube of an octree, in the list of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube {
    pub bounds: Aabb,
    pub level: u32,
    /// Where its children stand in the list of cubes, or its items in the list of items.
    pub first: u32,
    pub count: u32,
    pub is_leaf: bool,
}

/// An octree over items that are known by their index.
#[derive(Clone, Debug, PartialEq)]
pub struct Octree {
    cubes: Vec<Cube>,
    items: Vec<u32>,
    whole: Aabb,
    unbounded: Vec<u32>,
}

/// All leaves together hold at most this many times as many items as there are: a mesh has 2 to 3, a heap of things that
/// all reach everywhere 8 to the power of the depth.
const SHARED: usize = 32;

impl Octree {
    /// Splits level by level. Items that reach into several cubes are held by each of them.
    pub fn build(bounds: &[Aabb], splitting: Splitting) -> Self {
        let mut held: Vec<u32> = Vec::with_capacity(bounds.len());
        let mut unbounded = Vec::new();
        for (item, b) in (0..).zip(bounds) {
            match is_near(b) {
                true if b.is_empty() => {}
                true => held.push(item),
                false if b.min.is_nan() || b.max.is_nan() || !b.is_empty() => unbounded.push(item),
                false => {}
            }
        }
        let whole = held.iter().fold(Aabb::EMPTY, |sum, &i| sum.union(&bounds[i as usize]));
        let mut tree = Octree { cubes: Vec::new(), items: Vec::new(), whole, unbounded };
        if held.is_empty() {
            return tree;
        }
        let mut room = SHARED * held.len();
        tree.cubes.push(Cube { bounds: cube_around(&whole), level: 0, first: 0, count: 0, is_leaf: true });
        let mut waiting = VecDeque::from([(0, held)]);
        while let Some((at, held)) = waiting.pop_front() {
            let Cube { bounds: cube, level, .. } = tree.cubes[at];
            let is_full = held.len() > splitting.threshold && (level as usize) < splitting.depth;
            let parts = if is_full { parts(&cube, &held, bounds) } else { Vec::new() };
            let added = parts.iter().map(|(_, held)| held.len()).sum::<usize>().saturating_sub(held.len());
            if parts.is_empty() || added > room {
                tree.cubes[at].first = tree.items.len() as u32;
                tree.cubes[at].count = held.len() as u32;
                tree.items.extend(held);
                continue;
            }
            room -= added;
            let first = tree.cubes.len();
            tree.cubes[at] =
                Cube { first: first as u32, count: parts.len() as u32, is_leaf: false, ..tree.cubes[at] };
            for (bounds, held) in parts {
                waiting.push_back((tree.cubes.len(), held));
                tree.cubes.push(Cube { bounds, level: level + 1, first: 0, count: 0, is_leaf: true });
            }
        }
        tree
    }

    /// The cubes, the root first, each parent before its children.
    pub fn cubes(&self) -> &[Cube] {
        &self.cubes
    }

    /// The items that reach into a leaf.
    pub fn held(&self, leaf: &Cube) -> &[u32] {
        if leaf.is_leaf { &self.items[leaf.first as usize..(leaf.first + leaf.count) as usize] } else { &[] }
    }

    /// Memory of cubes and lists \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.cubes[..]) + size_of_val(&self.items[..]) + size_of_val(&self.unbounded[..])
    }

    /// The nearest crossing with `t_min < t < t_max`, and whose it is; of equally near ones that of the lowest index.
    ///
    /// Cubes are visited from near to far, and those that begin behind the nearest crossing not at all. `waiting` is
    /// the caller's memory.
    pub fn nearest<H: Along, T: Trace>(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: f64,
        trace: &mut T,
        waiting: &mut Vec<(f64, u32)>,
        mut test: impl FnMut(u32, f64) -> Option<H>,
    ) -> Option<(u32, H)> {
        let mut best = Best { t: t_max, found: None };
        let (mut visits, mut tests) = (0, self.unbounded.len() as u64);
        self.unbounded.iter().for_each(|&item| {
            best.offer(item, &mut test);
        });
        let slabs = Slabs::new(ray, &self.whole);
        waiting.clear();
        waiting.extend(self.enter_root(&slabs, t_min, best.t));
        while let Some((near, at)) = waiting.pop() {
            // As `Slabs::enter` lengthens what it compares with.
            if near > best.t + best.t.abs() * LENGTHENED {
                continue;
            }
            visits += 1;
            let cube = &self.cubes[at as usize];
            for &item in self.held(cube) {
                tests += 1;
                best.offer(item, &mut test);
            }
            let base = waiting.len();
            for child in self.children(cube) {
                if let Some(near) = slabs.enter(&self.cubes[child as usize].bounds, t_min, best.t) {
                    waiting.push((near, child));
                }
            }
            waiting[base..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        }
        trace.count(Work::NodeVisit, visits);
        trace.count(Work::ShapeTest, tests);
        best.found
    }

    /// Every item in the leaves that the ray meets, in the order of the list, some of them several times: D's search
    /// [D §5.9.1.4], which visits all children and keeps the best of everything, and A's list of candidates.
    pub fn each<T: Trace>(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: f64,
        trace: &mut T,
        mut visit: impl FnMut(u32),
    ) {
        self.unbounded.iter().for_each(|&item| visit(item));
        let slabs = Slabs::new(ray, &self.whole);
        let (mut visits, mut tests) = (0, self.unbounded.len() as u64);
        let mut waiting: Vec<u32> =
            self.enter_root(&slabs, t_min, t_max).map(|(_, at)| at).into_iter().collect();
        while let Some(at) = waiting.pop() {
            visits += 1;
            let cube = &self.cubes[at as usize];
            tests += self.held(cube).len() as u64;
            self.held(cube).iter().for_each(|&item| visit(item));
            let met = |child: &u32| slabs.enter(&self.cubes[*child as usize].bounds, t_min, t_max).is_some();
            waiting.extend(self.children(cube).rev().filter(met));
        }
        trace.count(Work::NodeVisit, visits);
        trace.count(Work::ShapeTest, tests);
    }

    fn enter_root(&self, slabs: &Slabs, t_min: f64, t_max: f64) -> Option<(f64, u32)> {
        Some((slabs.enter(&self.cubes.first()?.bounds, t_min, t_max)?, 0))
    }

    fn children(&self, cube: &Cube) -> std::ops::Range<u32> {
        if cube.is_leaf { 0..0 } else { cube.first..cube.first + cube.count }
    }
}

/// The cube round a box.
fn cube_around(b: &Aabb) -> Aabb {
    let half = DVec3::splat((b.max * 0.5 - b.min * 0.5).max_element());
    let center = b.min * 0.5 + b.max * 0.5;
    // The centre's rounding could leave a face of the box outside.
    Aabb::new((center - half).min(b.min), (center + half).max(b.max))
}

/// The eighths of a cube that hold something, and what; none if the cube is too small to be cut.
fn parts(cube: &Aabb, held: &[u32], bounds: &[Aabb]) -> Vec<(Aabb, Vec<u32>)> {
    let center = cube.min * 0.5 + cube.max * 0.5;
    let is_smaller = (0..3).any(|i| cube.min[i] < center[i] && center[i] < cube.max[i]);
    if !is_smaller {
        return Vec::new();
    }
    let part = |eighth: usize| {
        let high = |axis: usize| eighth >> axis & 1 == 1;
        let side = |axis: usize| if high(axis) { (center, cube.max) } else { (cube.min, center) };
        let pick = |axis: usize| (side(axis).0[axis], side(axis).1[axis]);
        let [x, y, z] = [0, 1, 2].map(pick);
        let bounds_of = Aabb::new(DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1));
        let inside = held.iter().copied().filter(|&i| bounds[i as usize].overlaps(&bounds_of)).collect();
        (bounds_of, inside)
    };
    (0..8).map(part).filter(|(_, inside): &(Aabb, Vec<u32>)| !inside.is_empty()).collect()
}
