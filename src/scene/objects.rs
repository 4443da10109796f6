//! The objects of a scene, and the structure that finds the nearest of many.

use crate::accel::Bvh;
use crate::bounds::Aabb;
use crate::ray::{Crossing, Ray, Trace, Work};
use crate::shape::Shape;
use crate::shape::fan::Fan;
use glam::DVec3;
use std::ops::Deref;
use std::sync::OnceLock;

/// A shape made of a material, or of several by its parts.
#[derive(Debug)]
pub struct Object {
    /// What messages call it: `Sphere` and where it was declared, or the name a lesson gives it.
    pub name: String,
    /// Of each part, an index into [`Scene::materials`](super::Scene::materials); if there is one only, it is that of all
    /// parts.
    materials: Vec<usize>,
    shape: Box<dyn Shape>,
    bounds: Aabb,
    /// Does a ray look at the bounds before it is tested against the shape?
    guarded: bool,
}

impl Object {
    /// An object of one material, by its index in [`Scene::materials`](super::Scene::materials).
    pub fn new(name: impl Into<String>, shape: Box<dyn Shape>, material: usize) -> Self {
        Self::of_parts(name, shape, vec![material])
    }

    /// An object whose parts, the leaves of a tree, each have their own material.
    pub fn of_parts(name: impl Into<String>, shape: Box<dyn Shape>, materials: Vec<usize>) -> Self {
        assert!(!materials.is_empty(), "an object without a material");
        let bounds = shape.bounds();
        let guarded = shape.is_costly() && bounds.is_finite();
        Object { name: name.into(), materials, shape, bounds, guarded }
    }

    /// The material where a ray met it, by [`Hit::part`](crate::ray::Hit::part), as an index into
    /// [`Scene::materials`](super::Scene::materials).
    #[inline]
    pub fn material(&self, part: u32) -> usize {
        let one = self.materials[0];
        if part == 0 { one } else { self.materials.get(part as usize).copied().unwrap_or(one) }
    }

    /// Does the ray certainly miss the object? `inv_direction` is `1/d`.
    #[inline]
    fn is_passed_by(&self, ray: &Ray, inv_direction: DVec3, t_max: f64) -> bool {
        self.guarded && self.bounds.slab(ray.origin, inv_direction, 0.0, t_max).is_none()
    }

    pub fn shape(&self) -> &dyn Shape {
        &*self.shape
    }

    /// Does it stand between the ends of a segment, `0 < t < t_max`? A shape that is costly to test is asked only
    /// if the segment meets its bounds.
    #[inline]
    pub fn blocks<T: Trace>(&self, segment: &Ray, t_max: f64, trace: &mut T) -> bool {
        if self.guarded && self.is_passed_by(segment, segment.direction.recip(), t_max) {
            return false;
        }
        trace.count(Work::ShapeTest, 1);
        self.shape.blocks(segment, t_max)
    }

    pub fn bounds(&self) -> &Aabb {
        &self.bounds
    }
}

/// Objects from which on a hierarchy is built. Tuned on spheres of random places (bench `bvh`, group `scene`): the list
/// is quicker for 10 (81 ns a ray against 85), the hierarchy for 12 (91 against 97); 11 are a tie.
const MANY: usize = 12;

/// The objects of a scene, in order of declaration: a list that only grows.
///
/// The first ray that meets many builds a hierarchy over them; few are looked at one by one. Unbounded objects stay in
/// a list of their own. A mesh brings its own hierarchy, and instances of it share that one: two levels.
#[derive(Debug, Default)]
pub struct Objects {
    list: Vec<Object>,
    hierarchy: OnceLock<Option<Bvh>>,
}

impl Objects {
    pub fn push(&mut self, object: Object) {
        self.hierarchy = OnceLock::new();
        self.list.push(object);
    }

    /// The hierarchy, built now if no ray has asked for it yet; `None` for few objects.
    #[inline]
    pub fn hierarchy(&self) -> Option<&Bvh> {
        if self.list.len() < MANY {
            return None;
        }
        let build = || {
            let bounds: Vec<Aabb> = self.list.iter().map(|o| o.bounds).collect();
            let bounded = bounds.iter().filter(|b| b.is_finite()).count();
            (bounded >= MANY).then(|| Bvh::build(&bounds))
        };
        self.hierarchy.get_or_init(build).as_ref()
    }

    #[inline]
    pub(super) fn nearest<T: Trace>(
        &self,
        ray: &Ray,
        mut t_max: f64,
        trace: &mut T,
    ) -> Option<(usize, Crossing)> {
        if let Some(hierarchy) = self.hierarchy() {
            let found = hierarchy.nearest(ray, 0.0, t_max, trace, |i, limit| {
                self.list[i as usize].shape.nearest(ray, 0.0, limit)
            });
            return found.map(|(i, crossing)| (i as usize, crossing));
        }
        let inv_direction = ray.direction.recip();
        let mut nearest = None;
        let mut tests = 0;
        for (i, object) in self.list.iter().enumerate() {
            if object.is_passed_by(ray, inv_direction, t_max) {
                continue;
            }
            tests += 1;
            if let Some(crossing) = object.shape.nearest(ray, 0.0, t_max) {
                t_max = crossing.t;
                nearest = Some((i, crossing));
            }
        }
        trace.count(Work::ShapeTest, tests);
        nearest
    }

    pub(super) fn blocker<T: Trace>(&self, segment: &Ray, t_max: f64, trace: &mut T) -> Option<usize> {
        if let Some(hierarchy) = self.hierarchy().filter(|_| !T::ACTIVE) {
            let blocks = |i: u32| self.list[i as usize].shape.blocks(segment, t_max);
            return hierarchy.any(segment, 0.0, t_max, trace, blocks).map(|i| i as usize);
        }
        let inv_direction = segment.direction.recip();
        let mut tests = 0;
        let blocker = self.list.iter().position(|object| {
            if object.is_passed_by(segment, inv_direction, t_max) {
                return false;
            }
            tests += 1;
            object.shape.blocks(segment, t_max)
        });
        trace.count(Work::ShapeTest, tests);
        blocker
    }

    pub(super) fn shade<T: Trace>(&self, fan: &Fan, lit: &mut [f64], trace: &mut T) {
        let mut shade = |object: &Object| {
            if object.bounds.overlaps(&fan.hull) && object.shape.may_block(fan) {
                trace.count(Work::ShapeTest, fan.len() as u64);
                object.shape.shade(fan, lit);
            }
        };
        match self.hierarchy() {
            Some(hierarchy) => hierarchy.overlapping(&fan.hull, |i| shade(&self.list[i as usize])),
            None => self.list.iter().for_each(shade),
        }
    }
}

impl From<Vec<Object>> for Objects {
    fn from(list: Vec<Object>) -> Self {
        Objects { list, hierarchy: OnceLock::new() }
    }
}

impl FromIterator<Object> for Objects {
    fn from_iter<I: IntoIterator<Item = Object>>(objects: I) -> Self {
        Vec::from_iter(objects).into()
    }
}

impl Deref for Objects {
    type Target = [Object];

    fn deref(&self) -> &[Object] {
        &self.list
    }
}
