//! How faces hang together: edges counted by sorting them.

use super::{EdgeList, Polygons};

/// What can be known of polygons without looking at lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Topology {
    /// Points that a face uses.
    pub vertices: usize,
    pub edges: usize,
    pub faces: usize,
    /// Edges of one face only.
    pub boundary_edges: usize,
    /// Edges that faces run along more often one way than the other, those of the boundary among them.
    pub unbalanced_edges: usize,
    /// Edges of more than two faces.
    pub branching_edges: usize,
    /// Pieces that share no vertex.
    pub components: usize,
}

impl Topology {
    /// Counts vertices, edges and faces; takes `n log n` for `n` corners.
    pub fn of(mesh: &Polygons) -> Self {
        let list = EdgeList::of(mesh);
        let uses = list.uses();
        let mut used = vec![false; mesh.points.len()];
        let mut pieces = Pieces::of(mesh.points.len());
        for face in mesh.faces() {
            for &v in face {
                used[v as usize] = true;
                pieces.join(v as usize, face[0] as usize);
            }
        }
        let vertices = used.iter().filter(|u| **u).count();
        let roots = (0..used.len()).filter(|&v| used[v] && pieces.root(v) == v).count();
        Topology {
            vertices,
            edges: list.edges.len(),
            faces: mesh.len(),
            boundary_edges: uses.iter().filter(|u| u.iter().sum::<u32>() == 1).count(),
            unbalanced_edges: uses.iter().filter(|u| u[0] != u[1]).count(),
            branching_edges: uses.iter().filter(|u| u.iter().sum::<u32>() > 2).count(),
            components: roots,
        }
    }

    /// Euler's characteristic `V − E + F`: 2 for what can be blown up to a ball, 0 for a torus, 1 for a disc.
    pub fn euler(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.faces as i64
    }

    /// Is the surface the rim of a solid: do faces run along every edge as often one way as the other?
    ///
    /// Then the signed number of faces that any line in general position passes is 0, whatever the mesh looks like.
    pub fn is_closed(&self) -> bool {
        self.faces > 0 && self.unbalanced_edges == 0
    }

    /// Number of handles of closed pieces whose edges all have two faces: `χ = 2 (pieces − handles)`.
    pub fn genus(&self) -> Option<i64> {
        let plain = self.is_closed() && self.branching_edges == 0;
        plain.then(|| self.components as i64 - self.euler() / 2)
    }
}

/// Sets that grow together (union–find with path halving).
pub(super) struct Pieces(Vec<u32>);

impl Pieces {
    pub fn of(n: usize) -> Self {
        Pieces((0..n as u32).collect())
    }

    pub fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] as usize != i {
            self.0[i] = self.0[self.0[i] as usize];
            i = self.0[i] as usize;
        }
        i
    }

    /// The smaller index becomes the root, so that the outcome does not depend on the order.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b) as u32;
    }
}
