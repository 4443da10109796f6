//! The plainest picture that shows what a start does: shadows, and glass.

use super::contest::Rule;
use glam::DVec3;
use lightbench::color::Rgb;
use lightbench::fresnel::cos_transmitted;
use lightbench::integrator::Integrator;
use lightbench::ray::leaving::Departure;
use lightbench::ray::{Hit, Ray, RayKind, Trace, Work};
use lightbench::sample::Sampler;
use lightbench::scene::{Material, Object, Scene};

/// Lambert, one lamp, hard shadows, and clear glass, with any rule for rays that leave.
pub struct Plain {
    pub rule: Rule,
    pub lamp: DVec3,
    /// Of the lamp: 1, or 0 for off.
    pub power: f64,
    /// Length of a check of the floor, in the scene's lengths.
    pub check: f64,
}

const AMBIENT: f64 = 0.12;
/// Surfaces that a ray may pass before it is given up.
const DEPTH: usize = 12;

impl Integrator for Plain {
    type Scratch = ();
    fn scratch(&self, _: &Scene) {}
    fn radiance<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        _: &mut Sampler,
        _: &mut (),
        trace: &mut T,
    ) -> Rgb {
        let (mut ray, mut left) = (*ray, None);
        for _ in 0..DEPTH {
            let Some((object, hit)) = self.first(scene, &ray, left, trace) else { return scene.background };
            let material = &scene.materials[scene.objects[object].material(hit.part)];
            if material.ior == 1.0 {
                return self.lit(scene, &ray, object, &hit, material, trace);
            }
            ray = self.through(&ray, &hit, material.ior);
            left = (self.rule == Rule::NaiveSkip).then_some(object);
        }
        Rgb::ZERO
    }
}

impl Plain {
    /// The nearest object, but for the one that is skipped.
    fn first<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        skipped: Option<usize>,
        trace: &mut T,
    ) -> Option<(usize, Hit)> {
        let (object, crossing) = match skipped {
            None => scene.nearest(ray, f64::INFINITY, trace)?,
            Some(skipped) => {
                let others = scene.objects.iter().enumerate().filter(|(i, _)| *i != skipped);
                let met = others.filter_map(|(i, o)| Some((i, o.shape().nearest(ray, 0.0, f64::INFINITY)?)));
                met.min_by(|a, b| a.1.t.total_cmp(&b.1.t))?
            }
        };
        Some((object, scene.hit(ray, object, &crossing)))
    }

    fn from(&self, hit: &Hit, way: &Departure) -> DVec3 {
        match self.rule {
            Rule::Leave(leaving) => leaving.origin(hit, way),
            _ => hit.point,
        }
    }

    fn lit<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        object: usize,
        hit: &Hit,
        material: &Material,
        trace: &mut T,
    ) -> Rgb {
        let side = if ray.direction.dot(hit.ng) > 0.0 { -hit.ng } else { hit.ng };
        let leaving = self.lamp - hit.point;
        let origin = self.from(hit, &Departure { arriving: ray.direction, side, leaving });
        let segment = Ray::new(origin, self.lamp - origin);
        let cos = side.dot(leaving.normalize_or_zero());
        // Glass is clear: it throws no shadow here.
        let is_in_the_way =
            |o: &Object| scene.materials[o.material(0)].ior == 1.0 && o.shape().blocks(&segment, 1.0);
        let blocked = match self.rule {
            Rule::NaiveSkip => scene.objects.iter().enumerate().any(|(i, o)| i != object && is_in_the_way(o)),
            _ => scene.objects.iter().any(is_in_the_way),
        };
        trace.count(Work::Ray(RayKind::Shadow), 1);
        let light = if cos > 0.0 && !blocked { cos } else { 0.0 };
        let checks = (hit.point / self.check).floor();
        let is_odd = (checks.x + checks.z).rem_euclid(2.0) == 1.0;
        let color =
            if material.name == "checks" && is_odd { material.diffuse * 0.25 } else { material.diffuse };
        color * (AMBIENT + (1.0 - AMBIENT) * self.power * light)
    }

    /// The ray behind a surface of glass, or the reflected one where there is none.
    fn through(&self, ray: &Ray, hit: &Hit, ior: f64) -> Ray {
        let arriving = ray.direction.normalize_or_zero();
        let enters = arriving.dot(hit.ng) < 0.0;
        let n = if enters { hit.ng } else { -hit.ng };
        let (from, to) = if enters { (1.0, ior) } else { (ior, 1.0) };
        let cos = -arriving.dot(n);
        let (side, leaving) = match cos_transmitted(from, to, cos.min(1.0)) {
            Some(cos_t) => (-n, arriving * (from / to) + n * (from / to * cos - cos_t)),
            None => (n, arriving + n * (2.0 * cos)),
        };
        Ray::new(self.from(hit, &Departure { arriving, side, leaving }), leaving)
    }
}
