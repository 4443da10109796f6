//! Building: boxes are split in two, again and again, where the surface area heuristic finds it cheapest.
//!
//! ```text
//! cost of a split = visit + (A₁ n₁ + A₂ n₂) / A · test
//! ```
//!
//! `A` are the areas of boxes: the share of random rays that meet the whole and the parts. Cuts are tried between the
//! bins of a grid over the boxes' centres, on all three axes.
//!
//! - Source: MacDonald & Booth (1990); Wald, *On fast construction of SAH-based bounding volume hierarchies* (2007).

use super::frame::Box32;

/// A box, and whose it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub bounds: Box32,
    pub id: u32,
}

/// A binary tree's node; `parts` are two nodes, or the range of items of a leaf.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split {
    pub bounds: Box32,
    pub parts: Parts,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Parts {
    Two(u32, u32),
    Items(u32, u32),
}

/// Items that fit into a leaf are split all the same if the parts' areas sum to less than this share of the whole's. Tuned:
/// at 1.05 a mesh's leaves are half empty, and it takes twice the memory; at 0.75 loose triangles are found 15 % more slowly.
const TOGETHER: f32 = 0.85;
const BINS: usize = 16;
/// From this depth on halves are taken, whatever they cost: no tree of up to 2³¹ items is deeper than 40 + 31.
const DEEPEST_SEARCH: usize = 40;
/// Levels of a tree of 2³¹ items.
pub(super) const DEPTH: usize = DEEPEST_SEARCH + 31;

impl Box32 {
    pub const EMPTY: Box32 = Box32 { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    #[inline(always)]
    pub fn grow(&mut self, other: &Box32) {
        for i in 0..3 {
            self.min[i] = if other.min[i] < self.min[i] { other.min[i] } else { self.min[i] };
            self.max[i] = if other.max[i] > self.max[i] { other.max[i] } else { self.max[i] };
        }
    }

    /// Half the area; 0 of an empty box.
    #[inline(always)]
    pub fn area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|i| (self.max[i] - self.min[i]).max(0.0));
        x * y + y * z + z * x
    }

    /// Twice the centre.
    #[inline(always)]
    fn center2(&self, axis: usize) -> f32 {
        self.min[axis] + self.max[axis]
    }
}

/// Splits items into leaves of at most `most`, which reorders them; the root is the first node.
pub(super) fn split(items: &mut [Item], most: usize) -> Vec<Split> {
    let mut nodes = Vec::with_capacity(2 * items.len() / most + 1);
    if !items.is_empty() {
        Splitter { nodes: &mut nodes, most }.node(items, 0, 0);
    }
    nodes
}

struct Splitter<'a> {
    nodes: &'a mut Vec<Split>,
    most: usize,
}

impl Splitter<'_> {
    fn node(&mut self, items: &mut [Item], first: usize, depth: usize) -> u32 {
        let mut bounds = Box32::EMPTY;
        let mut centers = Box32::EMPTY;
        for item in items.iter() {
            bounds.grow(&item.bounds);
            let center = [0, 1, 2].map(|i| item.bounds.center2(i));
            centers.grow(&Box32 { min: center, max: center });
        }
        let at = self.nodes.len();
        self.nodes.push(Split { bounds, parts: Parts::Items(first as u32, items.len() as u32) });
        if let Some(middle) = self.cut(items, &bounds, &centers, depth) {
            let (left, right) = items.split_at_mut(middle);
            let left = self.node(left, first, depth + 1);
            let right = self.node(right, first + middle, depth + 1);
            self.nodes[at].parts = Parts::Two(left, right);
        }
        at as u32
    }

    /// Reorders the items for a cut, and says how many lie before it: neither none nor all. `None` for a leaf.
    fn cut(&self, items: &mut [Item], bounds: &Box32, centers: &Box32, depth: usize) -> Option<usize> {
        let half = items.len() / 2;
        let fits = items.len() <= self.most;
        if items.len() == 1 || fits && depth >= DEEPEST_SEARCH {
            return None;
        }
        if depth >= DEEPEST_SEARCH {
            let spread = |axis: &usize| centers.max[*axis] - centers.min[*axis];
            let axis = (0..3).max_by(|a, b| spread(a).total_cmp(&spread(b))).unwrap_or(0);
            let key = |i: &Item| (i.bounds.center2(axis), i.id);
            items.select_nth_unstable_by(half, |a, b| {
                let (a, b) = (key(a), key(b));
                a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
            });
            return Some(half);
        }
        let grid = Grid::new(centers, items.len());
        let Some((cost, axis, bin)) = grid.best(items, self.most) else { return (!fits).then_some(half) };
        if fits && cost >= TOGETHER * bounds.area() {
            return None;
        }
        let mut before = 0;
        for i in 0..items.len() {
            if grid.bin(&items[i], axis) <= bin {
                items.swap(i, before);
                before += 1;
            }
        }
        Some(before)
    }
}

/// Bins over the centres of boxes.
struct Grid {
    origin: [f32; 3],
    scale: [f32; 3],
    bins: usize,
}

#[derive(Clone, Copy)]
struct Bin {
    bounds: Box32,
    count: u32,
}

impl Grid {
    fn new(centers: &Box32, items: usize) -> Self {
        let bins = if items < 4 * BINS { BINS / 2 } else { BINS };
        let scale = [0, 1, 2].map(|i| {
            // A little less than the number of bins, so that the last centre falls into the last bin.
            let scale = bins as f32 * (1.0 - 4.0 * f32::EPSILON) / (centers.max[i] - centers.min[i]);
            if scale.is_finite() { scale } else { 0.0 }
        });
        Grid { origin: centers.min, scale, bins }
    }

    #[inline(always)]
    fn bin(&self, item: &Item, axis: usize) -> usize {
        let x = (item.bounds.center2(axis) - self.origin[axis]) * self.scale[axis];
        (x as i32 as usize).min(BINS - 1)
    }

    /// The cheapest cut: what it costs, and after which bin of which axis. `None` if all centres are the same.
    fn best(&self, items: &[Item], most: usize) -> Option<(f32, usize, usize)> {
        let mut bins = [[Bin { bounds: Box32::EMPTY, count: 0 }; BINS]; 3];
        for item in items {
            for axis in 0..3 {
                let bin = &mut bins[axis][self.bin(item, axis)];
                bin.bounds.grow(&item.bounds);
                bin.count += 1;
            }
        }
        let mut best = None;
        let mut least = f32::INFINITY;
        let blocks = |n: u32| n.div_ceil(most as u32) as f32;
        for axis in 0..3 {
            if self.scale[axis] == 0.0 {
                continue;
            }
            let bins = &bins[axis][..self.bins];
            let mut above = [0f32; BINS];
            let (mut sum, mut count) = (Box32::EMPTY, 0);
            for i in (1..self.bins).rev() {
                sum.grow(&bins[i].bounds);
                count += bins[i].count;
                above[i] = if count == 0 { f32::INFINITY } else { sum.area() * blocks(count) };
            }
            let (mut sum, mut count) = (Box32::EMPTY, 0);
            for i in 0..self.bins - 1 {
                sum.grow(&bins[i].bounds);
                count += bins[i].count;
                let cost = sum.area() * blocks(count) + above[i + 1];
                if count > 0 && cost < least {
                    (least, best) = (cost, Some((cost, axis, i)));
                }
            }
        }
        best
    }
}
