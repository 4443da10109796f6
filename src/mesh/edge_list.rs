//! The hierarchy with edges: object → polygons → edges → vertices [A §2.2, ill. 6].

use super::Polygons;

/// Faces that count in a list of edges, and edges that count in the list of points.
///
/// A face names its edges in order, each with the sense in which it runs along it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeList {
    /// The two ends of each edge, the smaller index first; in ascending order.
    pub edges: Vec<[u32; 2]>,
    /// For every corner of the polygons the edge that begins there, twice its index, and 1 more if it runs backwards.
    pub sides: Vec<u32>,
    ends: Vec<u32>,
}

impl EdgeList {
    /// Finds the edges by sorting the sides of all faces.
    pub fn of(mesh: &Polygons) -> Self {
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(mesh.corner_count());
        let mut ends = Vec::with_capacity(mesh.len());
        for face in mesh.faces() {
            for (i, &a) in face.iter().enumerate() {
                let b = face[(i + 1) % face.len()];
                sides.push(([a.min(b), a.max(b)], 2 * sides.len() as u32 + u32::from(a > b)));
            }
            ends.push(sides.len() as u32);
        }
        sides.sort_unstable();
        let mut list = EdgeList { edges: Vec::new(), sides: vec![0; sides.len()], ends };
        for (edge, side) in sides {
            if list.edges.last() != Some(&edge) {
                list.edges.push(edge);
            }
            list.sides[side as usize / 2] = 2 * (list.edges.len() as u32 - 1) + side % 2;
        }
        list
    }

    /// How often faces run along each edge forwards, and how often backwards.
    pub fn uses(&self) -> Vec<[u32; 2]> {
        let mut uses = vec![[0; 2]; self.edges.len()];
        for side in &self.sides {
            uses[*side as usize / 2][*side as usize % 2] += 1;
        }
        uses
    }

    /// The points of a face, by index.
    pub fn face(&self, face: usize) -> impl Iterator<Item = u32> {
        let start = if face == 0 { 0 } else { self.ends[face - 1] as usize };
        let sides = &self.sides[start..self.ends[face] as usize];
        sides.iter().map(|side| self.edges[*side as usize / 2][*side as usize % 2])
    }

    /// Memory of faces and edges, without that of the points \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.edges[..]) + size_of_val(&self.sides[..]) + size_of_val(&self.ends[..])
    }
}
