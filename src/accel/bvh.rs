//! The hierarchy of boxes over anything that has bounds.

use super::Along;
use super::frame::{FARTHEST, LocalRay};
use super::node::{Eight, LEAF};
use super::tree::{AsTheyCome, ENOUGH, Job, NearestFirst, STACK, Tree, dispatch};
use crate::bounds::Aabb;
use crate::num::vectors::Vectors;
use crate::ray::{Ray, Trace, Work};
use glam::DVec3;

/// A bounding volume hierarchy over items that are known by their index alone: the default structure.
///
/// A tree of boxes, eight children to a node, built by the surface area heuristic. What an item is, and where a ray meets
/// it, only the caller knows; the answers are those of testing every item, to the bit.
///
/// - Domain: any boxes. Unbounded items (or NaN) are tested by every ray, empty ones by none.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh {
    tree: Tree,
    /// Items too large for boxes, ascending.
    unbounded: Vec<u32>,
}

impl Bvh {
    /// Builds the tree over `bounds[item]`.
    pub fn build(bounds: &[Aabb]) -> Self {
        let mut unbounded = Vec::new();
        let mut bounded = Vec::with_capacity(bounds.len());
        for (item, b) in (0u32..).zip(bounds) {
            if is_near(b) {
                if !b.is_empty() {
                    bounded.push((*b, item));
                }
            } else if b.min.is_nan() || b.max.is_nan() || !b.is_empty() {
                unbounded.push(item);
            }
        }
        let tree = Tree::build(&bounded, 1, |_, items| items[0].id);
        Bvh { tree, unbounded }
    }

    /// The same tree, with these instructions; its answers and counts are the same.
    pub fn with_vectors(mut self, vectors: Vectors) -> Self {
        self.tree.vectors = vectors;
        self
    }

    /// The nearest crossing with `t_min < t < t_max`, and whose it is; of equally near ones that of the lowest index.
    ///
    /// `test(item, limit)` answers with the item's first crossing with `t_min < t < limit`.
    #[inline]
    pub fn nearest<H: Along, T: Trace>(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: f64,
        trace: &mut T,
        mut test: impl FnMut(u32, f64) -> Option<H>,
    ) -> Option<(u32, H)> {
        let mut best = Best { t: t_max, found: None };
        let mut tests = self.unbounded.len() as u64;
        for &item in &self.unbounded {
            best.offer(item, &mut test);
        }
        let mut visits = 0;
        if let Some((ray, limit)) = self.tree.enter(ray, t_min, best.t) {
            let leaf = |item: u32, limit: f32| {
                tests += 1;
                if best.offer(item, &mut test) { ray.limit(best.t) } else { limit }
            };
            visits = dispatch(self.tree.vectors, Nearest { tree: &self.tree, ray: &ray, limit, leaf });
        }
        trace.count(Work::NodeVisit, visits);
        trace.count(Work::ShapeTest, tests);
        best.found
    }

    /// An item that stands in the way between `t_min` and `t_max`: the first that is found.
    #[inline]
    pub fn any<T: Trace>(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: f64,
        trace: &mut T,
        mut blocks: impl FnMut(u32) -> bool,
    ) -> Option<u32> {
        let mut found = None;
        let mut tests = 0;
        let mut ends = |item: u32| {
            tests += 1;
            let blocks = blocks(item);
            if blocks {
                found = Some(item);
            }
            blocks
        };
        let mut visits = 0;
        if !self.unbounded.iter().any(|&item| ends(item))
            && let Some((ray, limit)) = self.tree.enter(ray, t_min, t_max)
        {
            let leaf = |item: u32, limit: f32| if ends(item) { ENOUGH } else { limit };
            visits = dispatch(self.tree.vectors, Each { tree: &self.tree, ray: &ray, limit, leaf });
        }
        trace.count(Work::NodeVisit, visits);
        trace.count(Work::ShapeTest, tests);
        found
    }

    /// Every item whose box the ray meets between `t_min` and `t_max`, in no particular order; each once.
    #[inline]
    pub fn each<T: Trace>(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: f64,
        trace: &mut T,
        mut visit: impl FnMut(u32),
    ) {
        self.any(ray, t_min, t_max, trace, |item| {
            visit(item);
            false
        });
    }

    /// Calls `visit` for every item whose box shares a point with `bounds`; rounding may add some.
    pub fn overlapping(&self, bounds: &Aabb, mut visit: impl FnMut(u32)) {
        self.unbounded.iter().for_each(|&item| visit(item));
        self.tree.overlapping(bounds, &mut visit);
    }

    /// The boxes, parents before their children, each with its level and, of leaves, the item.
    pub fn boxes(&self) -> Vec<(u32, Aabb, Option<u32>)> {
        self.tree.boxes()
    }

    /// Children that wait on the worst of all ways through the tree, and how many there is room for.
    pub fn stack(&self) -> (usize, usize) {
        (self.tree.deepest_stack(), STACK)
    }

    /// Memory of the tree \[bytes\].
    pub fn bytes(&self) -> usize {
        self.tree.bytes() + self.unbounded.len() * size_of::<u32>()
    }
}

/// Is no coordinate too large to count with?
pub(super) fn is_near(b: &Aabb) -> bool {
    let is_near = |p: DVec3| p.abs().cmplt(DVec3::splat(FARTHEST)).all();
    is_near(b.min) && is_near(b.max)
}

/// The nearest crossing so far.
pub(super) struct Best<H> {
    pub t: f64,
    pub found: Option<(u32, H)>,
}

impl<H: Along> Best<H> {
    /// Takes the item's crossing if it is nearer, or as near and of a lower index. Has `t` changed?
    #[inline(always)]
    pub fn offer(&mut self, item: u32, test: &mut impl FnMut(u32, f64) -> Option<H>) -> bool {
        // Equally near is near enough for an item of a lower index.
        let limit = match &self.found {
            Some((held, _)) if item < *held => self.t.next_up(),
            _ => self.t,
        };
        let Some(hit) = test(item, limit) else { return false };
        let t = hit.t();
        let is_nearer = t < self.t;
        self.t = t;
        self.found = Some((item, hit));
        is_nearer
    }
}

struct Nearest<'a, F> {
    tree: &'a Tree,
    ray: &'a LocalRay,
    limit: f32,
    leaf: F,
}

impl<F: FnMut(u32, f32) -> f32> Job for Nearest<'_, F> {
    type Answer = u64;

    #[inline(always)]
    fn run<E: Eight>(self) -> u64 {
        self.tree.walk::<E, NearestFirst>(self.ray, self.limit, self.leaf)
    }
}

struct Each<'a, F> {
    tree: &'a Tree,
    ray: &'a LocalRay,
    limit: f32,
    leaf: F,
}

impl<F: FnMut(u32, f32) -> f32> Job for Each<'_, F> {
    type Answer = u64;

    #[inline(always)]
    fn run<E: Eight>(self) -> u64 {
        self.tree.walk::<E, AsTheyCome>(self.ray, self.limit, self.leaf)
    }
}

impl Tree {
    fn overlapping(&self, bounds: &Aabb, visit: &mut impl FnMut(u32)) {
        let wanted = self.frame.hold(bounds);
        let mut waiting: Vec<u32> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(node) = waiting.pop() {
            let node = &self.nodes[node as usize];
            for slot in 0..node.len() {
                let b = node.bounds(slot);
                if (0..3).all(|i| b.min[i] <= wanted.max[i] && b.max[i] >= wanted.min[i]) {
                    match node.child[slot] {
                        leaf if leaf & LEAF != 0 => visit(leaf & !LEAF),
                        inner => waiting.push(inner),
                    }
                }
            }
        }
    }
}
