//! Two naive ways as shapes, so that their pictures can be rendered.

use super::contestants::{leaves, naive_lists};
use glam::{DVec2, DVec3};
use lightbench::bounds::Aabb;
use lightbench::csg::Tree;
use lightbench::csg::as_printed::as_printed;
use lightbench::ray::{Crossing, Hit, Ray};
use lightbench::shape::Shape;

/// A tree whose first hit is found as [D §5.9.1.6] prints it.
#[derive(Debug)]
pub struct AsPrinted(pub Tree);

impl Shape for AsPrinted {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let first = as_printed(&self.0, ray).first()?.crossing;
        (first.t > t_min && first.t < t_max).then_some(first)
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(as_printed(&self.0, ray).iter().map(|m| m.crossing));
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let mark = as_printed(&self.0, ray).into_iter().find(|m| m.crossing == *crossing);
        let hit = leaves(&self.0)[crossing.part as usize].hit(ray, &Crossing { part: 0, ..*crossing });
        let turn = if mark.is_some_and(|m| m.turned) { -1.0 } else { 1.0 };
        Hit { ng: hit.ng * turn, n: hit.n * turn, part: crossing.part, ..hit }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        leaves(&self.0)[0].point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        leaves(&self.0).iter().fold(Aabb::EMPTY, |all, s| all.union(&s.bounds()))
    }

    fn parts(&self) -> u32 {
        self.0.leaves() as u32
    }
}

/// A tree whose lists are merged whole, with ties to the bit; its leaves name no parts of their own.
#[derive(Debug)]
pub struct ByLists(pub Tree);

impl ByLists {
    /// The leaf on whose surface an end lies, by its number.
    fn leaf_at(&self, ray: &Ray, t: f64) -> usize {
        let mut spans = Vec::new();
        let ends_at = |solid: &&dyn lightbench::shape::Solid| {
            spans.clear();
            solid.spans(ray, &mut spans);
            spans.iter().any(|s| s.enter.t == t || s.leave.t == t)
        };
        leaves(&self.0).iter().position(ends_at).unwrap_or(0)
    }
}

impl Shape for ByLists {
    fn nearest(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Crossing> {
        let spans = naive_lists(&self.0, ray);
        let mut ends = spans.iter().flat_map(|s| [s.enter, s.leave]);
        let first = ends.find(|c| c.t > t_min && c.t < t_max)?;
        Some(Crossing { part: self.leaf_at(ray, first.t) as u32, ..first })
    }

    fn crossings(&self, ray: &Ray, out: &mut Vec<Crossing>) {
        out.extend(naive_lists(&self.0, ray).iter().flat_map(|s| [s.enter, s.leave]).filter(|c| c.t > 0.0));
    }

    fn hit(&self, ray: &Ray, crossing: &Crossing) -> Hit {
        let hit = leaves(&self.0)[crossing.part as usize].hit(ray, &Crossing { part: 0, ..*crossing });
        let turn = if crossing.part > 0 { -1.0 } else { 1.0 }; // of a difference: the first stays, the others go
        Hit { ng: hit.ng * turn, n: hit.n * turn, part: crossing.part, ..hit }
    }

    fn point_at(&self, face: u32, uv: DVec2) -> DVec3 {
        leaves(&self.0)[0].point_at(face, uv)
    }

    fn bounds(&self) -> Aabb {
        leaves(&self.0)[0].bounds()
    }

    fn parts(&self) -> u32 {
        self.0.leaves() as u32
    }
}
