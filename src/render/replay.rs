//! One pixel's rays as a tree.

use crate::color::Rgb;
use crate::ray::{Hit, Ray, RayKind, Trace};
use crate::scene::Scene;
use std::fmt::Write;

/// A ray that was traced, and the rays it caused.
#[derive(Clone, Debug)]
pub struct Traced {
    pub kind: RayKind,
    pub ray: Ray,
    /// Where its search ended at the latest [lengths of the direction]; 1 for a shadow segment.
    pub t_max: f64,
    /// What its radiance is multiplied by in its parent.
    pub weight: Rgb,
    /// The object it met, and how.
    pub hit: Option<(usize, Hit)>,
    /// The object that blocks a shadow segment.
    pub blocker: Option<usize>,
    /// What it brought.
    pub radiance: Rgb,
    pub children: Vec<Traced>,
}

/// The tracer that keeps everything.
#[derive(Debug, Default)]
pub struct Recorder {
    finished: Vec<Traced>,
    open: Vec<Traced>,
}

impl Recorder {
    /// The rays without a parent, in the order they were shot.
    pub fn into_rays(self) -> Vec<Traced> {
        self.finished
    }
}

impl Trace for Recorder {
    fn enter(&mut self, kind: RayKind, ray: &Ray, t_max: f64, weight: Rgb) {
        let (hit, blocker, radiance) = (None, None, Rgb::ZERO);
        self.open.push(Traced {
            kind,
            ray: *ray,
            t_max,
            weight,
            hit,
            blocker,
            radiance,
            children: Vec::new(),
        });
    }

    fn hit(&mut self, object: usize, hit: &Hit) {
        if let Some(ray) = self.open.last_mut() {
            ray.hit = Some((object, *hit));
        }
    }

    fn blocked(&mut self, object: usize) {
        if let Some(ray) = self.open.last_mut() {
            ray.blocker = Some(object);
        }
    }

    fn leave(&mut self, radiance: Rgb) {
        if let Some(mut ray) = self.open.pop() {
            ray.radiance = radiance;
            match self.open.last_mut() {
                Some(parent) => parent.children.push(ray),
                None => self.finished.push(ray),
            }
        }
    }
}

impl Traced {
    /// The tree as text, a ray a line, children indented.
    pub fn text(&self, scene: &Scene) -> String {
        let mut out = String::new();
        self.write(scene, 0, &mut out);
        out
    }

    fn write(&self, scene: &Scene, depth: usize, out: &mut String) {
        let indent = "  ".repeat(depth);
        let (o, d) = (self.ray.origin, self.ray.direction);
        let name = |i: usize| &scene.objects[i].name;
        let end = match (&self.hit, self.blocker) {
            (Some((i, hit)), _) => {
                let (p, n) = (hit.point, hit.ng);
                format!("hits {} at t = {:.6}, point {p:.6}, normal {n:.6}", name(*i), hit.t)
            }
            (None, Some(i)) => format!("blocked by {}", name(i)),
            (None, None) if self.kind == RayKind::Shadow => "reaches the light".to_string(),
            (None, None) => "hits no object".to_string(),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "{indent}{} ray from {o:.6} along {d:.6}: {end}; weight {:.6}, brings {:.6}",
            self.kind.name(),
            self.weight,
            self.radiance
        );
        for child in &self.children {
            child.write(scene, depth + 1, out);
        }
    }
}
