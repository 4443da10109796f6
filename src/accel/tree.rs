//! Eight-wide trees: made from binary ones, and walked by rays.

use super::frame::{Box32, Frame, LocalRay};
use super::node::{Eight, LEAF, Node, Portable, WIDTH};
use super::split::{DEPTH, Item, Parts, Split, split};
use crate::bounds::Aabb;
use crate::num::vectors::Vectors;
use crate::ray::Ray;
use arrayvec::ArrayVec;

/// Children that wait while a ray is in a tree: on each level all but the one that it is in.
///
/// A wide tree is no deeper than the binary one it is made of, whose depth [`DEPTH`] bounds.
pub(super) const STACK: usize = (WIDTH - 1) * (DEPTH + 1) + 1;

/// A tree over leaves that only its owner knows.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tree {
    pub frame: Frame,
    pub root: Box32,
    pub nodes: Vec<Node>,
    pub vectors: Vectors,
}

/// In which order a ray is told of leaves.
pub(super) trait Order {
    const NEAREST_FIRST: bool;
}

pub(super) struct NearestFirst;
pub(super) struct AsTheyCome;

impl Order for NearestFirst {
    const NEAREST_FIRST: bool = true;
}

impl Order for AsTheyCome {
    const NEAREST_FIRST: bool = false;
}

/// A leaf's answer that ends the walk.
pub(super) const ENOUGH: f32 = -1.0;

impl Tree {
    /// A tree over `(bounds, id)`; `leaf` makes a leaf of at most `most` items and returns its number.
    pub fn build(bounds: &[(Aabb, u32)], most: usize, mut leaf: impl FnMut(&Frame, &[Item]) -> u32) -> Self {
        let whole = bounds.iter().fold(Aabb::EMPTY, |sum, (b, _)| sum.union(b));
        let frame = Frame::around(if bounds.is_empty() { &POINT } else { &whole });
        let mut items: Vec<Item> =
            bounds.iter().map(|(b, id)| Item { bounds: frame.hold(b), id: *id }).collect();
        let splits = split(&mut items, most);
        let root = splits.first().map_or(Box32::EMPTY, |s| s.bounds);
        let mut tree = Tree { frame, root, nodes: Vec::new(), vectors: Vectors::Widest };
        if !splits.is_empty() {
            tree.nodes.reserve(splits.len() / (WIDTH - 2) + 1);
            tree.widen(&splits, 0, &mut |first, count| {
                leaf(&frame, &items[first as usize..(first + count) as usize])
            });
        }
        tree
    }

    /// Makes a wide node of a binary one: of its descendants the largest is opened until eight are at hand.
    fn widen(&mut self, splits: &[Split], from: u32, leaf: &mut impl FnMut(u32, u32) -> u32) -> u32 {
        let mut children: ArrayVec<u32, WIDTH> = ArrayVec::new();
        children.push(from);
        while children.len() < WIDTH {
            let area = |c: &u32| match splits[*c as usize].parts {
                Parts::Two(..) => splits[*c as usize].bounds.area(),
                Parts::Items(..) => f32::NEG_INFINITY,
            };
            let largest =
                (0..children.len()).max_by(|&a, &b| area(&children[a]).total_cmp(&area(&children[b])));
            let Some(largest) = largest else { break };
            let Parts::Two(left, right) = splits[children[largest] as usize].parts else { break };
            children[largest] = left;
            children.push(right);
        }
        let at = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        for (slot, &child) in children.iter().enumerate() {
            let split = &splits[child as usize];
            let number = match split.parts {
                Parts::Items(first, count) => leaf(first, count) | LEAF,
                Parts::Two(..) => self.widen(splits, child, leaf),
            };
            self.nodes[at].set(slot, &split.bounds, number);
        }
        at as u32
    }

    /// The ray in this tree's frame and how far it goes, unless it certainly misses everything.
    #[inline]
    pub fn enter(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<(LocalRay, f32)> {
        if self.nodes.is_empty() { None } else { LocalRay::enter(&self.frame, &self.root, ray, t_min, t_max) }
    }

    /// Calls `leaf(number, limit)` for the leaves whose boxes the ray meets within the limit, which the call returns
    /// anew; [`ENOUGH`] ends the walk. Returns the number of nodes visited.
    #[inline(always)]
    pub fn walk<E: Eight, O: Order>(
        &self,
        ray: &LocalRay,
        mut limit: f32,
        mut leaf: impl FnMut(u32, f32) -> f32,
    ) -> u64 {
        let mut stack: ArrayVec<u64, STACK> = ArrayVec::new();
        let mut visits = 0;
        let mut next = 0u32;
        loop {
            if next & LEAF == 0 {
                let node = &self.nodes[next as usize];
                visits += 1;
                // SAFETY: `E` is an instruction set of this processor: see `dispatch`.
                let entries = unsafe { E::enter(node, ray, limit) };
                let mut met = entries.met;
                if met != 0 {
                    let first = met.trailing_zeros() as usize;
                    met &= met - 1;
                    // The one to go on with does not wait.
                    let mut on = waiting(entries.near[first], node.child[first]);
                    let base = stack.len();
                    while met != 0 {
                        let i = met.trailing_zeros() as usize;
                        met &= met - 1;
                        let entry = waiting(entries.near[i], node.child[i]);
                        if O::NEAREST_FIRST {
                            stack.push(on.max(entry));
                            on = on.min(entry);
                            sink(&mut stack[base..]);
                        } else {
                            stack.push(std::mem::replace(&mut on, entry));
                        }
                    }
                    next = on as u32;
                    continue;
                }
            } else {
                limit = leaf(next & !LEAF, limit);
                if limit < 0.0 {
                    return visits;
                }
            }
            loop {
                let Some(entry) = stack.pop() else { return visits };
                if f32::from_bits((entry >> 32) as u32) <= limit {
                    next = entry as u32;
                    break;
                }
            }
        }
    }

    /// Boxes of all nodes and leaves, parents first, each with its level and, of leaves, the number.
    pub fn boxes(&self) -> Vec<(u32, Aabb, Option<u32>)> {
        let mut found = Vec::new();
        let mut waiting = if self.nodes.is_empty() { vec![] } else { vec![(0, 0)] };
        while let Some((at, level)) = waiting.pop() {
            let node = &self.nodes[at as usize];
            for slot in 0..node.len() {
                let child = node.child[slot];
                let is_leaf = child & LEAF != 0;
                found.push((level, self.frame.release(&node.bounds(slot)), is_leaf.then_some(child & !LEAF)));
                if !is_leaf {
                    waiting.push((child, level + 1));
                }
            }
        }
        found
    }

    /// Length that the stack reaches on the worst of all ways through the tree.
    pub fn deepest_stack(&self) -> usize {
        fn below(tree: &Tree, node: u32) -> usize {
            let node = &tree.nodes[node as usize];
            let len = node.len();
            let inner = node.child[..len].iter().filter(|&&c| c & LEAF == 0);
            inner.map(|&c| len - 1 + below(tree, c)).max().unwrap_or(0).max(len)
        }
        if self.nodes.is_empty() { 0 } else { below(self, 0) }
    }

    /// Memory of the nodes [bytes].
    pub fn bytes(&self) -> usize {
        self.nodes.len() * size_of::<Node>()
    }
}

/// The frame of no item at all.
const POINT: Aabb = Aabb { min: glam::DVec3::ZERO, max: glam::DVec3::ZERO };

/// An entry of the stack. Where a ray enters is not negative, so its bits are ordered as it is.
#[inline(always)]
fn waiting(near: f32, child: u32) -> u64 {
    u64::from(near.to_bits()) << 32 | u64::from(child)
}

/// Moves the last entry down among the others, which are in descending order.
#[inline(always)]
fn sink(entries: &mut [u64]) {
    let mut at = entries.len() - 1;
    let last = entries[at];
    while at > 0 && entries[at - 1] < last {
        entries[at] = entries[at - 1];
        at -= 1;
    }
    entries[at] = last;
}

/// Work that is written once for every instruction set.
pub(super) trait Job {
    type Answer;
    fn run<E: Eight>(self) -> Self::Answer;
}

/// Does it in the widest instruction set that may be used.
#[inline(always)]
pub(super) fn dispatch<J: Job>(vectors: Vectors, job: J) -> J::Answer {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2")]
        fn avx2<J: Job>(job: J) -> J::Answer {
            job.run::<super::node::Avx2>()
        }
        if vectors.has_avx2() {
            // SAFETY: the processor has AVX2.
            return unsafe { avx2(job) };
        }
    }
    let _ = vectors; // read on x86-64 only
    job.run::<Portable>()
}
