//! Bounding volumes without a hierarchy: a simple shape round each thing is looked at first [A §5.6.1].

use super::Along;
use super::bvh::{Best, is_near};
use super::slabs::{Ball, Slabs};
use crate::bounds::Aabb;
use crate::ray::{Ray, Trace, Work};

/// Which simple shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hull {
    Box,
    Ball,
}

/// A list of items, each in its hull [A ill. 70].
///
/// A hull that the ray misses, or that begins behind the nearest crossing so far, saves the test of what is in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Hulls {
    boxes: Vec<Aabb>,
    balls: Vec<Ball>,
    whole: Aabb,
}

impl Hulls {
    pub fn build(bounds: &[Aabb], hull: Hull) -> Self {
        let whole = bounds.iter().filter(|b| is_near(b)).fold(Aabb::EMPTY, |sum, b| sum.union(b));
        match hull {
            Hull::Box => Hulls { boxes: bounds.to_vec(), balls: Vec::new(), whole },
            Hull::Ball => {
                Hulls { boxes: Vec::new(), balls: bounds.iter().map(Ball::around).collect(), whole }
            }
        }
    }

    /// The nearest crossing with `t_min < t < t_max`, and whose it is; of equally near ones that of the lowest index.
    pub fn nearest<H: Along, T: Trace>(
        &self,
        ray: &Ray,
        t_min: f64,
        t_max: f64,
        trace: &mut T,
        mut test: impl FnMut(u32, f64) -> Option<H>,
    ) -> Option<(u32, H)> {
        let mut best = Best { t: t_max, found: None };
        let mut tests = 0;
        let slabs = Slabs::new(ray, &self.whole);
        for (item, b) in (0..).zip(&self.boxes) {
            if !is_near(b) && !b.is_empty() || slabs.enter(b, t_min, best.t).is_some() {
                tests += 1;
                best.offer(item, &mut test);
            }
        }
        for (item, ball) in (0..).zip(&self.balls) {
            if ball.may_meet(ray, t_min, best.t) {
                tests += 1;
                best.offer(item, &mut test);
            }
        }
        trace.count(Work::NodeVisit, (self.boxes.len() + self.balls.len()) as u64);
        trace.count(Work::ShapeTest, tests);
        best.found
    }

    /// Memory of the hulls \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.boxes[..]) + size_of_val(&self.balls[..])
    }
}

/// The search as A prints it, over the items that an octree returned, or all of them.
///
/// A hull is skipped if `|centre − origin| − radius` is not below the best distance. But a crossing that is farther by
/// less than `DELTA = 10⁻⁶` replaces the best one, whatever the size of the scene: the last of several near things wins.
///
/// - Domain: a unit direction; `test` answers with a distance above 0.
/// - Source: [A ill. 72], without the object that is skipped by name.
pub fn as_printed_nearest(
    items: impl IntoIterator<Item = u32>,
    hull: impl Fn(u32) -> Ball,
    ray: &Ray,
    mut test: impl FnMut(u32) -> Option<f64>,
) -> Option<(u32, f64)> {
    const DELTA: f64 = 0.000001;
    let mut best = None;
    let mut nearest = f64::INFINITY;
    for item in items {
        let Ball { center, radius } = hull(item);
        if (center - ray.origin).length() - radius < nearest
            && let Some(t) = test(item)
            && t - DELTA < nearest
        {
            nearest = t;
            best = Some((item, t));
        }
    }
    best
}
