//! Normals for corners that have none.

use super::topology::Pieces;
use super::{Attribute, EdgeList, NONE, Polygons};
use crate::frame::unit;
use glam::DVec3;

impl Polygons {
    /// The same with normals for every corner that has none: the mean of the faces around its point, each by its angle
    /// there, as far as one gets from face to face without crossing an edge that bends by more than `crease` \[rad\].
    ///
    /// - Domain: `crease` 0 makes facets; π smooths every edge with two faces. Faces without area get and give nothing.
    /// - Source: Thürmer & Wüthrich, *Computing Vertex Normals from Polygonal Facets*, JGT 3(1) (1998).
    pub fn with_smooth_normals(mut self, crease: f64) -> Self {
        if self.normals.is_complete() {
            return self;
        }
        let faces: Vec<Option<DVec3>> = (0..self.len()).map(|f| unit(self.area_vector(f))).collect();
        let mut fans = self.fans(&faces, crease.cos());
        let mut sums = vec![DVec3::ZERO; self.corner_count()];
        for (f, normal) in faces.iter().enumerate() {
            for (corner, angle) in self.range(f).zip(self.angles(f)) {
                sums[fans.root(corner)] += normal.unwrap_or(DVec3::ZERO) * angle;
            }
        }
        let mut place = vec![NONE; self.corner_count()];
        for (f, normal) in faces.iter().enumerate() {
            for corner in self.range(f) {
                if self.normals.corners[corner] != NONE {
                    continue;
                }
                let fan = fans.root(corner);
                if place[fan] == NONE
                    && let Some(n) = unit(sums[fan]).or(*normal)
                {
                    place[fan] = self.normals.values.len() as u32;
                    self.normals.values.push(n);
                }
                self.normals.corners[corner] = place[fan];
            }
        }
        self
    }

    /// The same without normals: every face flat.
    pub fn facetted(mut self) -> Self {
        self.normals = Attribute { values: Vec::new(), corners: vec![NONE; self.corner_count()] };
        self
    }

    /// Corners at one point, joined over the edges that bend little: two faces, and their normals' cosine at least this.
    fn fans(&self, faces: &[Option<DVec3>], least_cosine: f64) -> Pieces {
        let list = EdgeList::of(self);
        let mut owner = vec![[NONE; 2]; list.edges.len()];
        let mut branching = vec![false; list.edges.len()];
        let mut face_of = vec![0u32; self.corner_count()];
        for f in 0..self.len() {
            for corner in self.range(f) {
                face_of[corner] = f as u32;
                let side = list.sides[corner] as usize;
                let place = &mut owner[side / 2][side % 2];
                branching[side / 2] |= *place != NONE;
                *place = corner as u32;
            }
        }
        let mut fans = Pieces::of(self.corner_count());
        for (edge, [a, b]) in owner.into_iter().enumerate() {
            if a == NONE || b == NONE || branching[edge] {
                continue;
            }
            let (a, b) = (a as usize, b as usize);
            let (f, g) = (face_of[a] as usize, face_of[b] as usize);
            let (Some(nf), Some(ng)) = (faces[f], faces[g]) else { continue };
            if nf.dot(ng) >= least_cosine {
                // Each side begins where the other ends.
                fans.join(a, self.after(g, b));
                fans.join(b, self.after(f, a));
            }
        }
        fans
    }

    /// The corner after this one in its face.
    fn after(&self, face: usize, corner: usize) -> usize {
        let range = self.range(face);
        if corner + 1 == range.end { range.start } else { corner + 1 }
    }

    /// The angle of a face at each of its corners [rad].
    fn angles(&self, face: usize) -> Vec<f64> {
        let outline: Vec<DVec3> = self.outline(face).collect();
        let n = outline.len();
        let way = |from: usize, to: usize| unit(outline[to % n] - outline[from % n]);
        let at = |i: usize| match (way(i, i + 1), way(i, i + n - 1)) {
            (Some(a), Some(b)) => a.cross(b).length().atan2(a.dot(b)),
            _ => 0.0,
        };
        (0..n).map(at).collect()
    }
}
