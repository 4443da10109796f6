//! Solids made of solids by union, intersection and difference [A §2.5, §5.4.6, D §4.8, §5.9.1.6].
//!
//! Along a ray every solid is a list of spans; the list of a compound follows from those of its operands by a table of
//! three lines. A's **root diagram** is that list drawn on a line:
//!
//! ```text
//! A      ───┤███████████├──────────
//! B      ────────┤██████████├──────
//! A − B  ───┤████├─────────────────
//! ```
//!
//! [`Tree`] says what is to be made, [`Csg`] is the solid made of it. Leaves keep their surfaces: [`Crossing::part`] tells on
//! which leaf a boundary lies, so that each may have its own material, and normals of what was taken away are turned.

pub mod as_printed;
mod operation;
mod tree;
mod walk;

pub use operation::{Operation, Side};
pub use tree::Tree;

use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray, Span};
use crate::shape::{Shape, Solid};
use glam::{DVec2, DVec3};
use walk::walk;

/// Most operations inside one another, chains of one operation counted once: each is a few hundred bytes of a thread's
/// stack while a ray is on its way.
pub const MOST_DEPTH: usize = 256;

/// Why no solid came out of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CsgError {
    #[error("expected at most {MOST_DEPTH} operations inside one another, found {found}")]
    TooDeep { found: usize },
    #[error("expected at most 2³² − 1 parts, found more")]
    TooManyParts,
}

/// Is a leaf part of the whole, or of what is taken away from it?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Facing {
    Outward,
    /// Its inside is the whole's outside.
    Inward,
}

impl Facing {
    fn turned(self) -> Facing {
        match self {
            Facing::Outward => Facing::Inward,
            Facing::Inward => Facing::Outward,
        }
    }
}

#[derive(Debug)]
struct Leaf {
    solid: Box<dyn Solid>,
    /// What its part 0 is called in the whole.
    first_part: u32,
    facing: Facing,
}

#[derive(Clone, Copy, Debug)]
enum What {
    Leaf(u32),
    Pair(Operation, u32, u32),
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    /// Is a look at the bounds worth it?
    guarded: bool,
    what: What,
}

/// The solid that a tree describes: the closure of its inside (regularised), so that faces which coincide leave neither
/// sheets nor cracks.
#[derive(Debug)]
pub struct Csg {
    /// Operands before what is made of them; the root comes last.
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
    /// Of each part, the leaf.
    parts: Vec<u32>,
}

impl Csg {
    /// - Errors: a tree that is too deep or has too many parts.
    pub fn new(tree: Tree) -> Result<Self, CsgError> {
        tree::Builder::build(tree)
    }

    fn root(&self) -> usize {
        self.nodes.len() - 1
    }

    /// The leaf to which a part belongs, and its number in the order in which leaves are written.
    pub fn leaf(&self, part: u32) -> (usize, &dyn Solid) {
        let leaf = self.parts.get(part as usize).copied().unwrap_or(0) as usize;
        (leaf, &*self.leaves[leaf].solid)
    }

    /// Number of leaves.
    pub fn leaves(&self) -> usize {
        self.leaves.len()
    }

    /// The leaf's own description of a boundary.
    fn hit_of_leaf(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let (leaf, solid) = self.leaf(crossing.part);
        let part = crossing.part.saturating_sub(self.leaves[leaf].first_part);
        solid.hit(ray, &Crossing { part, ..*crossing })
    }
}

impl Shape for Csg {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        walk(self, ray, t_min, t_max, |walk| {
            while let Some(crossing) = walk.next() {
                if crossing.t > t_min {
                    return (crossing.t < t_max).then_some(crossing);
                }
            }
            None
        })
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        walk(self, ray, 0.0, f64::INFINITY, |walk| {
            while let Some(crossing) = walk.next() {
                if crossing.t > 0.0 {
                    out.push(crossing);
                }
            }
        });
    }

    /// What the leaf says, with its normals turned if the leaf is taken away.
    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let hit = self.hit_of_leaf(ray, crossing);
        let (leaf, _) = self.leaf(crossing.part);
        let (ng, n) = match self.leaves[leaf].facing {
            Facing::Outward => (hit.ng, hit.n),
            Facing::Inward => (-hit.ng, -hit.n),
        };
        Hit { ng, n, part: crossing.part, ..hit }
    }

    /// Of the first leaf; those of the others are asked through [`Csg::leaf`].
    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        self.leaf(0).1.point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        self.nodes[self.root()].bounds
    }

    fn parts(&self) -> u32 {
        self.parts.len() as u32
    }
}

impl Solid for Csg {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        walk(self, ray, f64::NEG_INFINITY, f64::INFINITY, |walk| {
            while let Some(enter) = walk.next() {
                let leave = walk.next().unwrap_or(Crossing { t: f64::INFINITY, ..enter });
                out.push(Span { enter, leave });
            }
        });
    }

    /// By the leaves' own word; a point on a surface that is taken away counts as outside.
    fn contains(&self, p: DVec3) -> bool {
        fn side(csg: &Csg, node: usize, p: DVec3) -> Side {
            let Node { bounds, what, .. } = csg.nodes[node];
            match what {
                _ if !bounds.contains(p) => Side::Out,
                What::Leaf(leaf) if csg.leaves[leaf as usize].solid.contains(p) => Side::In,
                What::Leaf(_) => Side::Out,
                What::Pair(operation, left, right) => {
                    let left = side(csg, left as usize, p);
                    if operation.left_decides(left) {
                        return operation.combine(left, Side::Out);
                    }
                    operation.combine(left, side(csg, right as usize, p))
                }
            }
        }
        side(self, self.root(), p) == Side::In
    }
}
