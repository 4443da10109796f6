//! The closed mesh: a solid.

use super::{Mesh, line};
use crate::bounds::Aabb;
use crate::ray::{Crossing, Hit, Ray, Span};
use crate::shape::{Shape, Solid};
use glam::{DVec2, DVec3};

/// A mesh whose surface has no rim, and so an inside.
///
/// Inside is what the surface winds about: a line in general position enters as often as it leaves, by exact signs. Where the
/// surface crosses itself, what it winds about twice counts once.
#[derive(Debug)]
pub struct ClosedMesh(Mesh);

impl ClosedMesh {
    /// - Errors: the mesh itself, if it is not closed; [`Mesh::topology`] tells how many edges are missing.
    pub fn new(mesh: Mesh) -> Result<Self, Box<Mesh>> {
        if mesh.topology().is_closed() { Ok(ClosedMesh(mesh)) } else { Err(Box::new(mesh)) }
    }

    pub fn mesh(&self) -> &Mesh {
        &self.0
    }
}

impl Shape for ClosedMesh {
    #[inline]
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        self.0.nearest(ray, t_min, t_max)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        self.0.crossings(ray, out);
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        self.0.hit(ray, crossing)
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        self.0.point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        self.0.bounds()
    }

    fn blocks(&self, ray: &Ray, t_max: f64) -> bool {
        self.0.blocks(ray, t_max)
    }

    fn parts(&self) -> u32 {
        self.0.parts()
    }

    fn is_costly(&self) -> bool {
        self.0.is_costly()
    }

    fn lifted(&self, hit: &Hit, n: DVec3) -> DVec3 {
        self.0.lifted(hit, n)
    }
}

impl Solid for ClosedMesh {
    fn spans(&self, ray: &Ray, out: &mut Vec<Span>) {
        line::spans(&self.0, ray, out);
    }

    fn contains(&self, p: DVec3) -> bool {
        self.0.bounds().contains(p) && line::contains(&self.0, p)
    }
}
