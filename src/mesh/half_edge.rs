//! Half-edges: every edge once for each of its two faces, each knowing its twin.

use super::{EdgeList, NONE, Polygons};
use glam::DVec3;

/// One side of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Half {
    /// The point where it begins.
    pub origin: u32,
    /// The same edge, run along the other way by the neighbouring face; [`NONE`] on a boundary.
    pub twin: u32,
    /// The next side of the same face.
    pub next: u32,
    pub face: u32,
}

/// Why polygons have no half-edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotAManifold {
    #[error("the edge between points {from} and {to}: expected at most one face on each side, found more")]
    Edge { from: u32, to: u32 },
    #[error("point {point}: expected one fan of faces around it, found several that touch only there")]
    Point { point: u32 },
}

/// Polygons with their neighbourhoods [Mäntylä, *An Introduction to Solid Modeling* (1988)].
#[derive(Clone, Debug, PartialEq)]
pub struct HalfEdges {
    pub points: Vec<DVec3>,
    /// Sides of all faces, face by face in order: the first side of a face follows the last of the face before.
    pub halves: Vec<Half>,
    /// A side that begins at each point, [`NONE`] for a point without faces; on a boundary the one no turn leads to.
    pub outgoing: Vec<u32>,
    /// The first side of each face.
    pub first: Vec<u32>,
}

impl HalfEdges {
    /// - Errors: an edge with two faces on one side, or a point where only corners touch.
    pub fn of(mesh: &Polygons) -> Result<Self, NotAManifold> {
        let list = EdgeList::of(mesh);
        let mut halves = Vec::with_capacity(mesh.corner_count());
        let mut first = Vec::with_capacity(mesh.len());
        let mut owner = vec![[NONE; 2]; list.edges.len()];
        for (f, face) in mesh.faces().enumerate() {
            let start = halves.len();
            first.push(start as u32);
            for (i, &origin) in face.iter().enumerate() {
                let side = list.sides[start + i] as usize;
                let place = &mut owner[side / 2][side % 2];
                if *place != NONE {
                    return Err(NotAManifold::Edge { from: origin, to: face[(i + 1) % face.len()] });
                }
                *place = (start + i) as u32;
                let next = if i + 1 == face.len() { start } else { start + i + 1 };
                halves.push(Half { origin, twin: NONE, next: next as u32, face: f as u32 });
            }
        }
        for (half, side) in halves.iter_mut().zip(&list.sides) {
            half.twin = owner[*side as usize / 2][1 - *side as usize % 2];
        }
        let outgoing = vec![NONE; mesh.points.len()];
        let mut mesh = HalfEdges { points: mesh.points.clone(), halves, outgoing, first };
        mesh.choose_outgoing()?;
        Ok(mesh)
    }

    fn choose_outgoing(&mut self) -> Result<(), NotAManifold> {
        let mut leaving = vec![0u32; self.points.len()];
        for h in 0..self.halves.len() {
            let half = self.halves[h];
            leaving[half.origin as usize] += 1;
            let out = &mut self.outgoing[half.origin as usize];
            // The side whose predecessor has no twin is the one that no turn reaches.
            if *out == NONE {
                *out = h as u32;
            }
            if half.twin == NONE {
                let end = self.halves[half.next as usize].origin;
                self.outgoing[end as usize] = half.next;
            }
        }
        let lost = (0..self.points.len()).find(|&v| self.around(v as u32).count() as u32 != leaving[v]);
        lost.map_or(Ok(()), |v| Err(NotAManifold::Point { point: v as u32 }))
    }

    /// The sides that begin at a point, turning about it against their faces' sense.
    pub fn around(&self, point: u32) -> impl Iterator<Item = u32> {
        let start = self.outgoing[point as usize];
        let mut at = start;
        std::iter::from_fn(move || {
            let this = at;
            if this == NONE {
                return None;
            }
            let twin = self.halves[this as usize].twin;
            at = if twin == NONE { NONE } else { self.halves[twin as usize].next };
            if at == start {
                at = NONE;
            }
            Some(this)
        })
    }

    /// The points at the other ends of the edges of a point: its one-ring.
    pub fn one_ring(&self, point: u32) -> impl Iterator<Item = u32> {
        let end = |h: u32| self.halves[self.halves[h as usize].next as usize].origin;
        let start = self.outgoing[point as usize];
        // On a boundary one neighbour is only arrived from.
        let from_there = (start != NONE).then(|| self.before(start)).filter(|b| self.twin(*b).is_none());
        self.around(point).map(end).chain(from_there.map(|b| self.halves[b as usize].origin))
    }

    /// The side before this one in its face.
    pub fn before(&self, half: u32) -> u32 {
        let mut at = half;
        loop {
            let next = self.halves[at as usize].next;
            if next == half {
                return at;
            }
            at = next;
        }
    }

    /// The other side of the edge, if a face is there.
    pub fn twin(&self, half: u32) -> Option<u32> {
        Some(self.halves[half as usize].twin).filter(|t| *t != NONE)
    }

    /// The sides of a face.
    pub fn sides(&self, face: u32) -> impl Iterator<Item = u32> {
        let start = self.first[face as usize];
        let mut at = Some(start);
        std::iter::from_fn(move || {
            let this = at?;
            at = Some(self.halves[this as usize].next).filter(|n| *n != start);
            Some(this)
        })
    }

    /// The faces across the edges of a face.
    pub fn neighbours(&self, face: u32) -> impl Iterator<Item = u32> {
        self.sides(face).filter_map(|h| self.twin(h)).map(|t| self.halves[t as usize].face)
    }

    /// The sides without a twin, as closed loops, each in its faces' sense.
    pub fn boundary(&self) -> Vec<Vec<u32>> {
        let mut seen = vec![false; self.halves.len()];
        let mut loops = Vec::new();
        for h in 0..self.halves.len() as u32 {
            if seen[h as usize] || self.twin(h).is_some() {
                continue;
            }
            let mut at = h;
            let mut rim = Vec::new();
            while !seen[at as usize] {
                seen[at as usize] = true;
                rim.push(at);
                // The boundary goes on where the end's fan begins.
                let end = self.halves[self.halves[at as usize].next as usize].origin;
                at = self.around(end).last().unwrap_or(at);
            }
            loops.push(rim);
        }
        loops
    }

    pub fn is_closed(&self) -> bool {
        self.halves.iter().all(|h| h.twin != NONE)
    }

    /// Euler's characteristic `V − E + F`.
    pub fn euler(&self) -> i64 {
        let vertices = self.outgoing.iter().filter(|o| **o != NONE).count() as i64;
        let alone = self.halves.iter().filter(|h| h.twin == NONE).count() as i64;
        let edges = (self.halves.len() as i64 + alone) / 2;
        vertices - edges + self.first.len() as i64
    }

    /// The faces as lists of points again, attributes left out.
    pub fn polygons(&self) -> Polygons {
        let mut out = Polygons::of_points(self.points.clone());
        for f in 0..self.first.len() as u32 {
            let face: Vec<u32> = self.sides(f).map(|h| self.halves[h as usize].origin).collect();
            out.push_points(&face);
        }
        out
    }

    /// Memory of sides, faces and points' sides, without that of the points \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.halves[..]) + size_of_val(&self.outgoing[..]) + size_of_val(&self.first[..])
    }
}
