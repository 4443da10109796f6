//! The hierarchy over triangles: eight to a leaf, sifted eight at a time before the caller's test.

use super::Along;
use super::bvh::Best;
use super::frame::LocalRay;
use super::node::{Eight, WIDTH};
use super::pack::Pack;
use super::tree::{AsTheyCome, ENOUGH, Job, NearestFirst, Order, STACK, Tree, dispatch};
use crate::bounds::Aabb;
use crate::num::vectors::Vectors;
use crate::ray::{Ray, Trace, Work};
use glam::DVec3;

/// A hierarchy over triangles that are known by their index.
///
/// Besides boxes it keeps the triangles in `f32`, with bounds on all errors, so that on the average little more than
/// one triangle a ray is handed to the caller's test, whatever that is; the answers are those of testing every
/// triangle, to the bit.
///
/// - Domain: finite corners within 10¹⁵⁰ of each other's; others are tested by every ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Facets {
    tree: Tree,
    packs: Vec<Pack>,
    /// Triangles too large for boxes, ascending.
    unbounded: Vec<u32>,
}

impl Facets {
    /// Builds the tree over `count` triangles with these corners.
    pub fn build(count: usize, corners: impl Fn(u32) -> [DVec3; 3]) -> Self {
        let mut unbounded = Vec::new();
        let mut bounded = Vec::with_capacity(count);
        for item in 0..count as u32 {
            let bounds = Aabb::of_points(corners(item));
            if corners(item).iter().all(|v| v.is_finite()) && super::bvh::is_near(&bounds) {
                bounded.push((bounds, item));
            } else {
                unbounded.push(item);
            }
        }
        let mut packs = Vec::with_capacity(count / 4);
        let tree = Tree::build(&bounded, WIDTH, |frame, items| {
            packs.push(Pack::new(frame, items, &corners));
            packs.len() as u32 - 1
        });
        Facets { tree, packs, unbounded }
    }

    /// The same tree, with these instructions; its answers and counts are the same.
    pub fn with_vectors(mut self, vectors: Vectors) -> Self {
        self.tree.vectors = vectors;
        self
    }

    /// The nearest crossing with `t_min < t < t_max`, and whose it is; of equally near ones that of the lowest index.
    ///
    /// `test(item, limit)` answers with the triangle's crossing if `t_min < t < limit`.
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
            let visit = |item: u32, limit: f32| {
                tests += 1;
                if best.offer(item, &mut test) { ray.limit(best.t) } else { limit }
            };
            visits = dispatch(self.tree.vectors, self.walk(&ray, limit, NearestFirst, visit));
        }
        trace.count(Work::NodeVisit, visits);
        trace.count(Work::ShapeTest, tests);
        best.found
    }

    /// A triangle that stands in the way between `t_min` and `t_max`: the first that is found.
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
            let visit = |item: u32, limit: f32| if ends(item) { ENOUGH } else { limit };
            visits = dispatch(self.tree.vectors, self.walk(&ray, limit, AsTheyCome, visit));
        }
        trace.count(Work::NodeVisit, visits);
        trace.count(Work::ShapeTest, tests);
        found
    }

    /// Every triangle that the ray may meet between `t_min` and `t_max`, in no particular order; each once.
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

    /// Children that wait on the worst of all ways through the tree, and how many there is room for.
    pub fn stack(&self) -> (usize, usize) {
        (self.tree.deepest_stack(), STACK)
    }

    /// Memory of tree and packs \[bytes\].
    pub fn bytes(&self) -> usize {
        self.tree.bytes() + self.packs.len() * size_of::<Pack>() + self.unbounded.len() * size_of::<u32>()
    }

    #[inline(always)]
    fn walk<'a, O: Order, F: FnMut(u32, f32) -> f32>(
        &'a self,
        ray: &'a LocalRay,
        limit: f32,
        _order: O,
        visit: F,
    ) -> Walk<'a, O, F> {
        Walk { facets: self, ray, limit, visit, order: std::marker::PhantomData }
    }
}

/// A ray's way through the tree; counts nodes and packs.
struct Walk<'a, O, F> {
    facets: &'a Facets,
    ray: &'a LocalRay,
    limit: f32,
    visit: F,
    order: std::marker::PhantomData<O>,
}

impl<O: Order, F: FnMut(u32, f32) -> f32> Job for Walk<'_, O, F> {
    type Answer = u64;

    #[inline(always)]
    fn run<E: Eight>(mut self) -> u64 {
        let Facets { tree, packs, .. } = self.facets;
        let mut sifted = 0;
        let visits = tree.walk::<E, O>(self.ray, self.limit, |leaf, mut limit| {
            sifted += 1;
            let pack = &packs[leaf as usize];
            // SAFETY: `E` is an instruction set of this processor: see `dispatch`.
            let mut left = unsafe { E::sift(pack, self.ray, limit) };
            while left != 0 {
                let lane = left.trailing_zeros() as usize;
                left &= left - 1;
                limit = (self.visit)(pack.id[lane], limit);
                if limit < 0.0 {
                    break;
                }
            }
            limit
        });
        visits + sifted
    }
}
