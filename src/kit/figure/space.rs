//! Three dimensions on paper: a parallel or a central projection to the plane of a diagram.

use super::diagram::{Diagram, Light};
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::TAU;

/// A projection of space to the plane of a diagram, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    right: DVec3,
    up: DVec3,
    /// Towards the viewer.
    back: DVec3,
    eye: DVec3,
    /// Distance of the picture plane from the eye; none for a parallel projection.
    focus: Option<f64>,
}

impl Space {
    /// Parallel projection, seen from `yaw` degrees round the y axis (0: from +z, 90: from +x) and `pitch` above.
    pub fn axonometric(yaw: f64, pitch: f64) -> Self {
        let (yaw, pitch) = (yaw.to_radians(), pitch.to_radians());
        let back = dvec3(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
        let right = dvec3(yaw.cos(), 0.0, -yaw.sin());
        Space { right, up: back.cross(right), back, eye: DVec3::ZERO, focus: None }
    }

    /// Central projection from `eye` towards `target`; lengths at the target keep their size.
    pub fn perspective(eye: DVec3, target: DVec3) -> Self {
        let back = (eye - target).normalize_or(DVec3::Z);
        // Looking straight up or down, the top of the picture points to −z.
        let right = DVec3::Y.cross(back).normalize_or(DVec3::X);
        Space { right, up: back.cross(right), back, eye, focus: Some(eye.distance(target)) }
    }

    /// Where a point of space lies on paper; points behind the eye of a central projection give NaN.
    pub fn at(&self, p: DVec3) -> DVec2 {
        let p = p - self.eye;
        let flat = dvec2(p.dot(self.right), p.dot(self.up));
        match self.focus {
            None => flat,
            Some(focus) => {
                let depth = -p.dot(self.back);
                if depth > 0.0 { flat * (focus / depth) } else { DVec2::NAN }
            }
        }
    }

    /// Does a face with that point and outward normal show itself?
    fn sees(&self, point: DVec3, normal: DVec3) -> bool {
        let towards = if self.focus.is_some() { self.eye - point } else { self.back };
        towards.dot(normal) > 0.0
    }
}

impl Diagram {
    /// A box: its visible faces filled, its hidden edges dashed.
    pub fn solid_box(mut self, space: &Space, min: DVec3, max: DVec3) -> Self {
        let corner = |i: usize| {
            let pick = |bit: usize, a: f64, b: f64| if i >> bit & 1 == 1 { b } else { a };
            dvec3(pick(0, min.x, max.x), pick(1, min.y, max.y), pick(2, min.z, max.z))
        };
        let faces = [
            (DVec3::NEG_X, [0, 4, 6, 2]),
            (DVec3::X, [1, 3, 7, 5]),
            (DVec3::NEG_Y, [0, 1, 5, 4]),
            (DVec3::Y, [2, 6, 7, 3]),
            (DVec3::NEG_Z, [0, 2, 3, 1]),
            (DVec3::Z, [4, 5, 7, 6]),
        ];
        let (seen, hidden): (Vec<_>, Vec<_>) = faces.iter().partition(|(n, f)| space.sees(corner(f[0]), *n));
        for (_, face) in seen {
            self = self.polygon(&face.map(|i| space.at(corner(i))));
        }
        // An edge is hidden if both its faces are.
        for (k, (_, a)) in hidden.iter().enumerate() {
            for (_, b) in &hidden[k + 1..] {
                let shared: Vec<usize> = a.iter().copied().filter(|i| b.contains(i)).collect();
                if let [p, q] = shared[..] {
                    self = self.hidden(&[space.at(corner(p)), space.at(corner(q))]);
                }
            }
        }
        self
    }

    /// Axes x, y, z of that length from `origin`, with their names.
    pub fn axes(mut self, space: &Space, origin: DVec3, length: f64) -> Self {
        for (axis, name) in [(DVec3::X, "x"), (DVec3::Y, "y"), (DVec3::Z, "z")] {
            self = self.ray(Light::Normal, space.at(origin), space.at(origin + axis * length)).name_end(name);
        }
        self
    }

    /// A parallelogram from `corner` along `u` and `v`, ruled into `columns × rows` pixels.
    pub fn pixel_grid(
        mut self,
        space: &Space,
        corner: DVec3,
        u: DVec3,
        v: DVec3,
        columns: u32,
        rows: u32,
    ) -> Self {
        self = self.polygon(&[corner, corner + u, corner + u + v, corner + v].map(|p| space.at(p)));
        for i in 1..columns {
            let p = corner + u * (f64::from(i) / f64::from(columns));
            self = self.thin(&[space.at(p), space.at(p + v)]);
        }
        for j in 1..rows {
            let p = corner + v * (f64::from(j) / f64::from(rows));
            self = self.thin(&[space.at(p), space.at(p + u)]);
        }
        self
    }

    /// Thin edges from an apex to every corner of a base: the pyramid of view.
    pub fn pyramid(mut self, space: &Space, apex: DVec3, base: &[DVec3]) -> Self {
        for &corner in base {
            self = self.thin(&[space.at(apex), space.at(corner)]);
        }
        self
    }

    /// A sphere: its outline, and the circle round its `axis`, dashed behind.
    pub fn ball(mut self, space: &Space, center: DVec3, radius: f64, axis: DVec3) -> Self {
        let axis = axis.normalize_or(DVec3::Y);
        let across = axis.any_orthonormal_vector();
        let on = |t: f64| (across * t.cos() + axis.cross(across) * t.sin()) * radius;
        self = self.circle(space.at(center), radius);
        let steps = 96;
        let seen = |k: usize| space.sees(center + on(TAU * k as f64 / 96.0), on(TAU * k as f64 / 96.0));
        // Start where the visible half begins, so that each half is one chain.
        let start = (0..steps).find(|&k| seen(k) && !seen((k + steps - 1) % steps)).unwrap_or(0);
        let chain = |front: bool| -> Vec<DVec2> {
            let mut ks: Vec<usize> =
                (0..steps).map(|i| start + i).filter(|k| seen(k % steps) == front).collect();
            ks.extend(ks.last().map(|k| k + 1).filter(|_| ks.len() < steps));
            ks.iter().map(|&k| space.at(center + on(TAU * k as f64 / 96.0))).collect()
        };
        let (front, behind) = (chain(true), chain(false));
        self = self.thin(&front);
        if behind.len() > 1 { self.hidden(&behind) } else { self }
    }
}
