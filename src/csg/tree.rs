//! Trees as they are written, and the flat form in which rays meet them.

use super::{Csg, CsgError, Facing, Leaf, MOST_DEPTH, Node, Operation, What};
use crate::bounds::Aabb;
use crate::shape::instance::Instance;
use crate::shape::{ShapeError, Solid};
use glam::DAffine3;

/// Solids and what is to be made of them [A ill. 17, D fig. 17].
#[derive(Debug)]
pub enum Tree {
    Leaf(Box<dyn Solid>),
    Node(Operation, Box<[Tree; 2]>),
}

impl Tree {
    pub fn leaf(solid: impl Solid + 'static) -> Tree {
        Tree::Leaf(Box::new(solid))
    }

    pub fn node(operation: Operation, left: Tree, right: Tree) -> Tree {
        Tree::Node(operation, Box::new([left, right]))
    }

    /// `self ∪ other`.
    pub fn union(self, other: Tree) -> Tree {
        Tree::node(Operation::Union, self, other)
    }

    /// `self ∩ other`.
    pub fn intersection(self, other: Tree) -> Tree {
        Tree::node(Operation::Intersection, self, other)
    }

    /// `self − other`.
    pub fn difference(self, other: Tree) -> Tree {
        Tree::node(Operation::Difference, self, other)
    }

    /// All of them, one after the other: `a ∪ b ∪ c`, `a ∩ b ∩ c`, `a − b − c`; none of none.
    pub fn all(operation: Operation, operands: impl IntoIterator<Item = Tree>) -> Option<Tree> {
        operands.into_iter().reduce(|left, right| Tree::node(operation, left, right))
    }

    /// The whole under a map: each leaf becomes an instance.
    ///
    /// - Errors: as [`Instance::new`].
    pub fn moved(self, map: DAffine3) -> Result<Tree, ShapeError> {
        Ok(match self {
            Tree::Leaf(solid) => Tree::leaf(Instance::new(solid, map)?),
            Tree::Node(operation, pair) => {
                let [left, right] = *pair;
                Tree::node(operation, left.moved(map)?, right.moved(map)?)
            }
        })
    }

    /// Number of leaves.
    pub fn leaves(&self) -> usize {
        let (mut count, mut open) = (0, vec![self]);
        while let Some(tree) = open.pop() {
            match tree {
                Tree::Leaf(_) => count += 1,
                Tree::Node(_, pair) => open.extend(pair.iter()),
            }
        }
        count
    }
}

/// From how many leaves on a compound's bounds are looked at. Below, its costly leaves look at their own: the bounds of a
/// difference or a small intersection are hardly smaller than those of its first leaf, and the look would be paid twice.
const GUARDED_FROM: usize = 6;

/// The flat form under construction.
#[derive(Default)]
pub(super) struct Builder {
    nodes: Vec<Node>,
    /// Of each node, the number of leaves.
    sizes: Vec<usize>,
    leaves: Vec<Leaf>,
    /// Of each part, the leaf.
    parts: Vec<u32>,
}

impl Builder {
    /// Leaves are numbered as they are written; chains of one operation become balanced trees.
    ///
    /// ```text
    /// (a ∪ b) ∪ c = a ∪ b ∪ c,   (a ∩ b) ∩ c = a ∩ b ∩ c,   (a − b) − c = a − (b ∪ c)
    /// ```
    pub(super) fn build(tree: Tree) -> Result<Csg, CsgError> {
        let found = depth(&tree);
        if found > MOST_DEPTH {
            return Err(CsgError::TooDeep { found });
        }
        let mut builder = Builder::default();
        builder.node(tree, Facing::Outward)?;
        let Builder { nodes, leaves, parts, .. } = builder;
        Ok(Csg { nodes, leaves, parts })
    }

    fn node(&mut self, tree: Tree, facing: Facing) -> Result<usize, CsgError> {
        let (operation, pair) = match tree {
            Tree::Leaf(solid) => return self.leaf(solid, facing),
            Tree::Node(operation, pair) => (operation, pair),
        };
        if operation != Operation::Difference {
            let operands = chain(operation, Tree::Node(operation, pair));
            let nodes = self.operands(operands, facing)?;
            return Ok(self.balanced(operation, nodes));
        }
        let [mut minuend, right] = *pair;
        let mut taken_away = vec![right]; // last first
        while let Tree::Node(Operation::Difference, pair) = minuend {
            let [left, right] = *pair;
            minuend = left;
            taken_away.push(right);
        }
        let left = self.node(minuend, facing)?;
        let flat = taken_away.into_iter().rev().flat_map(|tree| chain(Operation::Union, tree)).collect();
        let nodes = self.operands(flat, facing.turned())?;
        let right = self.balanced(Operation::Union, nodes);
        Ok(self.pair(Operation::Difference, left, right))
    }

    fn operands(&mut self, trees: Vec<Tree>, facing: Facing) -> Result<Vec<usize>, CsgError> {
        trees.into_iter().map(|tree| self.node(tree, facing)).collect()
    }

    fn leaf(&mut self, solid: Box<dyn Solid>, facing: Facing) -> Result<usize, CsgError> {
        let (bounds, solid_is_costly) = (solid.hull(), solid.is_costly());
        let (leaf, first_part) = (self.leaves.len() as u32, self.parts.len());
        let parts = first_part + solid.parts() as usize;
        if parts > u32::MAX as usize {
            return Err(CsgError::TooManyParts);
        }
        self.parts.resize(parts, leaf);
        self.leaves.push(Leaf { solid, first_part: first_part as u32, facing });
        let guarded = solid_is_costly && bounds.is_finite();
        Ok(self.push(Node { bounds, guarded, what: What::Leaf(leaf) }, 1))
    }

    fn pair(&mut self, operation: Operation, left: usize, right: usize) -> usize {
        let (a, b) = (self.nodes[left].bounds, self.nodes[right].bounds);
        let bounds = match operation {
            Operation::Union => a.union(&b),
            Operation::Intersection => Aabb::new(a.min.max(b.min), a.max.min(b.max)),
            Operation::Difference => a,
        };
        let size = self.sizes[left] + self.sizes[right];
        let guarded = size >= GUARDED_FROM && bounds.is_finite();
        self.push(Node { bounds, guarded, what: What::Pair(operation, left as u32, right as u32) }, size)
    }

    fn push(&mut self, node: Node, size: usize) -> usize {
        self.nodes.push(node);
        self.sizes.push(size);
        self.nodes.len() - 1
    }

    /// The nodes under one operation in as few levels as can be; a union's neighbours in space stay together.
    fn balanced(&mut self, operation: Operation, mut nodes: Vec<usize>) -> usize {
        if operation == Operation::Union {
            let endless = |builder: &Self, node: usize| !builder.nodes[node].bounds.is_finite();
            let (far, near): (Vec<_>, Vec<_>) = nodes.into_iter().partition(|&n| endless(self, n));
            if far.is_empty() || near.is_empty() {
                nodes = if far.is_empty() { near } else { far };
            } else {
                let (far, near) =
                    (self.halved(operation, &mut { far }), self.halved(operation, &mut { near }));
                return self.pair(operation, far, near);
            }
        }
        self.halved(operation, &mut nodes)
    }

    fn halved(&mut self, operation: Operation, nodes: &mut [usize]) -> usize {
        if let [node] = *nodes {
            return node;
        }
        if operation == Operation::Union && nodes.len() > 2 {
            let center = |n: &usize| self.nodes[*n].bounds.center();
            let spread = Aabb::of_points(nodes.iter().map(center));
            let size = spread.max - spread.min;
            let axis = (0..3).fold(0, |best, i| if size[i] > size[best] { i } else { best });
            nodes.sort_by(|a, b| center(a)[axis].total_cmp(&center(b)[axis]));
        }
        let (first, second) = nodes.split_at_mut(nodes.len() / 2);
        let (left, right) = (self.halved(operation, first), self.halved(operation, second));
        self.pair(operation, left, right)
    }
}

/// Operations inside one another, each chain of one operation counted once.
fn depth(tree: &Tree) -> usize {
    let (mut deepest, mut open) = (0, vec![(tree, None, 0)]);
    while let Some((tree, chain, depth)) = open.pop() {
        let Tree::Node(operation, pair) = tree else { continue };
        let depth = if chain == Some(*operation) { depth } else { depth + 1 };
        deepest = deepest.max(depth);
        // What is taken away from what is taken away begins a chain of its own.
        let right = Some(*operation).filter(|o| *o != Operation::Difference);
        open.extend([(&pair[0], Some(*operation), depth), (&pair[1], right, depth)]);
    }
    deepest
}

/// The operands of a chain of one operation that joins freely, as they are written.
fn chain(operation: Operation, tree: Tree) -> Vec<Tree> {
    let (mut operands, mut open) = (Vec::new(), vec![tree]);
    while let Some(tree) = open.pop() {
        match tree {
            Tree::Node(found, pair) if found == operation => {
                let [left, right] = *pair;
                open.extend([right, left]);
            }
            other => operands.push(other),
        }
    }
    operands
}
