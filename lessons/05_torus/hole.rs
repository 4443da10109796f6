//! The ray–quartic code of [A §5.4.4] as printed, on rays from the hole of the torus (2, 0.6).

use super::RING;
use super::rays::crossings;
use glam::DVec3;
use lightbench::num::quartic::graphics_gems_as_printed;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::torus::Torus;

/// What [A §5.4.4] makes of a ray along x from the middle of the hole of the torus (2, 0.6).
pub struct Hole {
    /// All roots of the document's program, of (5.23) as it is numbered, and those ahead.
    pub roots: Vec<f64>,
    pub reversed: Vec<f64>,
    pub truth: Vec<f64>,
    pub culled: Option<f64>,
    pub unculled: Option<f64>,
}

pub fn from_the_hole() -> Hole {
    let ray = Ray::new(DVec3::ZERO, DVec3::X);
    let a = coefficients_as_printed(&ray);
    let roots = graphics_gems_as_printed(a[3] / a[4], a[2] / a[4], a[1] / a[4], a[0] / a[4]).to_vec();
    let reversed = graphics_gems_as_printed(a[1] / a[0], a[2] / a[0], a[3] / a[0], a[4] / a[0]).to_vec();
    let torus = Torus::new(RING, 0.6).expect("0 < b < a");
    let truth = crossings(&torus, &ray).iter().map(|c| c.t).collect();
    Hole {
        culled: with_testcull(&roots),
        unculled: roots.iter().copied().find(|t| *t > 1e-6),
        roots,
        reversed,
        truth,
    }
}

/// (5.18) to (5.22) for the torus (2, 0.6): `a[i]` multiplies `tⁱ`, as in the document's program.
fn coefficients_as_printed(ray: &Ray) -> [f64; 5] {
    let (o, d, a2, b2) = (ray.origin, ray.direction, RING * RING, 0.6 * 0.6);
    let (dd, od, e) = (d.dot(d), o.dot(d), o.dot(o) - (a2 + b2));
    let a2_term = 2.0 * dd * e + 4.0 * od * od + 4.0 * a2 * d.z * d.z;
    [
        e * e - 4.0 * a2 * (b2 - o.z * o.z),
        4.0 * od * e + 8.0 * a2 * o.z * d.z,
        a2_term,
        4.0 * od * dd,
        dd * dd,
    ]
}

/// The loop of [A ill. 59] with `testcull`: one negative root among them, and the ray is said to start inside.
fn with_testcull(roots: &[f64]) -> Option<f64> {
    let threshold = 0.000001;
    if roots.iter().any(|t| *t < -threshold) { None } else { roots.iter().copied().find(|t| *t > threshold) }
}

/// Hits that the printed `testcull` loses, and hits in all, of rays in any direction from the middle of the hole.
pub fn lost_by_testcull(seed: u64, rays: u32) -> [usize; 2] {
    let torus = Torus::new(RING, 0.6).expect("0 < b < a");
    let from = |i| Ray::new(DVec3::ZERO, uniform_sphere(Sampler::new(seed, 59, i).next_2d()));
    let hits: Vec<Ray> = (0..rays).map(from).filter(|r| torus.blocks(r, f64::INFINITY)).collect();
    let kept = |r: &&Ray| {
        let a = coefficients_as_printed(r);
        with_testcull(&graphics_gems_as_printed(a[3] / a[4], a[2] / a[4], a[1] / a[4], a[0] / a[4])).is_some()
    };
    [hits.len() - hits.iter().filter(kept).count(), hits.len()]
}
