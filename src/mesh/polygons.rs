//! Polygons that share a list of points.

use crate::frame::transform_normal;
use glam::{DAffine3, DVec2, DVec3};
use std::collections::HashMap;
use std::ops::Range;

/// The index of nothing: a corner without a normal, a half-edge without a twin.
pub const NONE: u32 = u32::MAX;

/// Values that corners share, as faces share points: a list, and for every corner its place there, or [`NONE`].
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute<T> {
    pub values: Vec<T>,
    /// As many as the polygons have corners.
    pub corners: Vec<u32>,
}

impl<T: Copy> Attribute<T> {
    /// The value of a corner, if it has one.
    pub fn get(&self, corner: usize) -> Option<T> {
        self.values.get(*self.corners.get(corner)? as usize).copied()
    }

    /// Does every corner have a value?
    pub fn is_complete(&self) -> bool {
        !self.corners.contains(&NONE)
    }
}

/// A corner of a face under construction: indices of its point, texture coordinates and normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Corner {
    pub point: u32,
    pub uv: u32,
    pub normal: u32,
}

impl Corner {
    /// A corner that is nothing but a point.
    pub fn at(point: u32) -> Self {
        Corner { point, uv: NONE, normal: NONE }
    }
}

/// Faces of three corners and more; corners are indices of points [A §2.1, ill. 5].
///
/// A face shows its front where its corners appear counter-clockwise. (A's text says clockwise; its own data do not.)
#[derive(Clone, Debug, PartialEq)]
pub struct Polygons {
    pub points: Vec<DVec3>,
    /// Texture coordinates.
    pub uvs: Attribute<DVec2>,
    /// Unit normals to shade by.
    pub normals: Attribute<DVec3>,
    /// For every face the index of its part, which has a material of its own.
    pub parts: Vec<u32>,
    corners: Vec<u32>,
    /// Where each face's corners end.
    ends: Vec<u32>,
}

impl Polygons {
    /// Points without faces.
    pub fn of_points(points: Vec<DVec3>) -> Self {
        Polygons {
            points,
            uvs: Attribute { values: Vec::new(), corners: Vec::new() },
            normals: Attribute { values: Vec::new(), corners: Vec::new() },
            parts: Vec::new(),
            corners: Vec::new(),
            ends: Vec::new(),
        }
    }

    /// Appends a face.
    ///
    /// # Panics
    /// If an index counts beyond the lists, or 2³² corners do not suffice.
    pub fn push(&mut self, face: &[Corner], part: u32) {
        let within = |i: u32, n: usize| i == NONE || (i as usize) < n;
        for c in face {
            assert!((c.point as usize) < self.points.len(), "point {} of {}", c.point, self.points.len());
            assert!(within(c.uv, self.uvs.values.len()), "uv {} of {}", c.uv, self.uvs.values.len());
            assert!(within(c.normal, self.normals.values.len()), "normal {}", c.normal);
            self.corners.push(c.point);
            self.uvs.corners.push(c.uv);
            self.normals.corners.push(c.normal);
        }
        self.ends.push(u32::try_from(self.corners.len()).expect("fewer than 2³² corners"));
        self.parts.push(part);
    }

    /// Appends a face of bare points.
    ///
    /// # Panics
    /// As [`Polygons::push`].
    pub fn push_points(&mut self, face: &[u32]) {
        let corners: Vec<Corner> = face.iter().map(|&i| Corner::at(i)).collect();
        self.push(&corners, 0);
    }

    /// Triangles that share nothing: each brings its own three points.
    pub fn of_triangles(triangles: &[[DVec3; 3]]) -> Self {
        let mut mesh = Polygons::of_points(triangles.iter().flatten().copied().collect());
        for i in 0..triangles.len() {
            let first = u32::try_from(3 * i).expect("fewer than 2³² corners");
            mesh.push_points(&[first, first + 1, first + 2]);
        }
        mesh
    }

    pub fn len(&self) -> usize {
        self.ends.len()
    }

    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Corners of all faces together.
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// Which corners are those of a face.
    pub fn range(&self, face: usize) -> Range<usize> {
        let start = if face == 0 { 0 } else { self.ends[face - 1] as usize };
        start..self.ends[face] as usize
    }

    /// The points of a face, by index.
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.range(face)]
    }

    /// All faces, each with its points by index.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|f| self.face(f))
    }

    /// The indices of one corner.
    pub fn corner(&self, corner: usize) -> Corner {
        let [uv, normal] = [self.uvs.corners[corner], self.normals.corners[corner]];
        Corner { point: self.corners[corner], uv, normal }
    }

    /// The points of a face.
    pub fn outline(&self, face: usize) -> impl ExactSizeIterator<Item = DVec3> {
        self.face(face).iter().map(|&i| self.points[i as usize])
    }

    /// Half the sum of the cross products around a face: its normal, as long as its area \[m²\]; Newell's method.
    pub fn area_vector(&self, face: usize) -> DVec3 {
        let outline: Vec<DVec3> = self.outline(face).collect();
        let Some(&first) = outline.first() else { return DVec3::ZERO };
        outline.windows(2).fold(DVec3::ZERO, |sum, w| sum + (w[0] - first).cross(w[1] - first)) * 0.5
    }

    /// Area of flat faces \[m²\].
    pub fn area(&self) -> f64 {
        (0..self.len()).map(|f| self.area_vector(f).length()).sum()
    }

    /// Volume inside a closed surface \[m³\], negative if the faces show their fronts to the inside.
    ///
    /// ```text
    /// V = ∮ p·n dA / 3 = Σ a·(b × c) / 6    over triangles, from any common origin
    /// ```
    ///
    /// - Domain: what is not closed, or not flat, has no volume; the sum then depends on the origin, which is the first point.
    pub fn volume(&self) -> f64 {
        let Some(&origin) = self.points.first() else { return 0.0 };
        let of_face = |f: usize| {
            let arms: Vec<DVec3> = self.outline(f).map(|p| p - origin).collect();
            let fan = arms.windows(2).skip(1);
            fan.map(|w| arms[0].dot(w[0].cross(w[1]))).sum::<f64>() / 6.0
        };
        (0..self.len()).map(of_face).sum()
    }

    /// The polygons under a map. A map that mirrors turns every outline round, so that fronts stay fronts.
    pub fn transformed(&self, map: &DAffine3) -> Self {
        let mut out = self.clone();
        out.points.iter_mut().for_each(|p| *p = map.transform_point3(*p));
        for n in &mut out.normals.values {
            *n = transform_normal(&map.matrix3, *n).unwrap_or(*n);
        }
        if map.matrix3.determinant() < 0.0 {
            out.turn_round();
        }
        out
    }

    /// Lets every face show its other side; normals stay as they are.
    pub fn turn_round(&mut self) {
        for face in 0..self.len() {
            let range = self.range(face);
            self.corners[range.clone()].reverse();
            self.uvs.corners[range.clone()].reverse();
            self.normals.corners[range].reverse();
        }
    }

    /// The same faces, with points that are equal to the bit made one (0 and −0 are one); a face loses a corner that
    /// repeats the one before it, and vanishes with fewer than three.
    pub fn welded(&self) -> Self {
        let mut index = HashMap::with_capacity(self.points.len());
        let mut points = Vec::new();
        let place: Vec<u32> = self
            .points
            .iter()
            .map(|p| {
                *index.entry(p.to_array().map(|x| (x + 0.0).to_bits())).or_insert_with(|| {
                    points.push(*p);
                    points.len() as u32 - 1 // no more than there were
                })
            })
            .collect();
        let mut out = Polygons::of_points(points);
        (out.uvs.values, out.normals.values) = (self.uvs.values.clone(), self.normals.values.clone());
        let mut face = Vec::new();
        for f in 0..self.len() {
            face.clear();
            for c in self.range(f) {
                let corner = self.corner(c);
                face.push(Corner { point: place[corner.point as usize], ..corner });
            }
            face.dedup_by_key(|c| c.point);
            while face.len() > 1 && face[0].point == face[face.len() - 1].point {
                face.pop();
            }
            if face.len() >= 3 {
                out.push(&face, self.parts[f]);
            }
        }
        out
    }

    /// Memory of points and faces without attributes \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.points[..]) + size_of_val(&self.corners[..]) + size_of_val(&self.ends[..])
    }

    /// The faces that have this point among their corners, found by looking at all of them.
    pub fn faces_around(&self, point: u32) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(move |&f| self.face(f).contains(&point))
    }
}
