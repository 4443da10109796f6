//! Shadow segments that start on the torus.

use super::rays::{Aim, question};
use super::{PLAIN, RING};
use glam::DVec3;
use lightbench::measure::{Spread, time_each};
use lightbench::ray::Ray;
use lightbench::shape::Shape;
use lightbench::shape::torus::{Torus, TorusMethod};

const LAMP: DVec3 = DVec3::new(3.0, 9.0, 8.0); // m

/// From places of the torus (2, 0.6) that face the lamp, to the lamp at t = 1.
pub fn segments(seed: u64, rays: u32) -> Vec<Ray> {
    let torus = Torus::new(RING, 0.6).expect("0 < b < a");
    let segment = |i| {
        let q = question(seed, i, (0.3, PLAIN.1), Aim::Through);
        let hit = torus.hit(&q.ray, &torus.nearest(&q.ray, 0.0, f64::INFINITY)?);
        let from = hit.origin_towards(LAMP - hit.point);
        (hit.ng.dot(LAMP - hit.point) > 0.0).then_some(Ray::new(from, LAMP - from))
    };
    (0..rays).filter_map(segment).collect()
}

/// Time per segment, and answers unlike the default's.
pub fn time(segments: &[Ray], method: TorusMethod) -> (Spread, usize) {
    let torus = Torus::new(RING, 0.6).expect("0 < b < a").with_method(method);
    let blocked = || segments.iter().take(256).filter(|r| torus.blocks(r, 1.0)).count();
    let truth = torus.with_method(TorusMethod::Adaptive);
    let wrong = segments.iter().filter(|r| torus.blocks(r, 1.0) != truth.blocks(r, 1.0)).count();
    let some = segments.len().min(256);
    (time_each(some, blocked), wrong)
}
