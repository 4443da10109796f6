//! Rays through, past and along tori; and where they truly meet them.

use super::{DISTANCE, GRAZE, RATIO, RING};
use glam::DVec2;
use lightbench::measure::Tally;
use lightbench::num::double_double::DoubleDouble;
use lightbench::num::polynomial::real_roots;
use lightbench::ray::{Crossing, Ray};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::shape::Shape;
use lightbench::shape::torus::Torus;

/// How a line is laid through the torus.
#[derive(Clone, Copy)]
pub enum Aim {
    /// In any direction through a place between the tube's centre and a tenth of b above its surface.
    Through,
    /// In a tangential direction, by turns so many b under and above the surface.
    Grazing(f64),
}

/// A ray, and all its roots, ascending.
pub struct Question {
    pub torus: Torus,
    pub ray: Ray,
    pub truth: Vec<f64>,
}

pub fn question(seed: u64, index: u32, (ratio, distance): (f64, f64), aim: Aim) -> Question {
    let torus = Torus::new(RING, RING * ratio).expect("0 < b < a");
    let mut sampler = Sampler::new(seed, ratio.to_bits() ^ distance.to_bits(), index);
    let uv = sampler.next_2d();
    let surface = torus.point_at(0, uv);
    let flat = DVec2::from_angle(std::f64::consts::TAU * uv.x);
    let n = (surface - (flat * RING).extend(0.0)) / torus.tube();
    let (depth, direction) = match aim {
        Aim::Through => (1.1 * sampler.next_1d() - 0.1, uniform_sphere(sampler.next_2d())),
        Aim::Grazing(depth) => {
            let (right, up) = n.any_orthonormal_pair();
            let turn = DVec2::from_angle(std::f64::consts::TAU * sampler.next_1d());
            (if index.is_multiple_of(2) { depth } else { -depth }, right * turn.x + up * turn.y)
        }
    };
    let target = surface - n * (depth * torus.tube());
    let ray = Ray::new(target - direction * (distance * RING), direction);
    let truth = truth(&torus, &ray);
    Question { torus, ray, truth }
}

/// By turns two rays through the tube and two that graze.
pub fn turns(index: u32, depth: f64) -> Aim {
    if index % 4 < 2 { Aim::Through } else { Aim::Grazing(depth) }
}

/// All difficulties at once, each evenly on a logarithm; every second ray grazes.
pub fn mixed(seed: u64, index: u32) -> Question {
    let mut sampler = Sampler::new(seed, 5, index);
    let mut within = |r: std::ops::Range<f64>| r.start * (r.end / r.start).powf(sampler.next_1d());
    let (ratio, distance, depth) = (within(RATIO), within(DISTANCE), within(GRAZE));
    question(seed, index, (ratio, distance), turns(index, depth))
}

pub fn crossings(torus: &Torus, ray: &Ray) -> Vec<Crossing> {
    let mut out = Vec::new();
    torus.crossings(ray, &mut out);
    out
}

impl Question {
    /// Sets the answers against the truth, in order; a root off by more than a tenth of b is missed, and false.
    pub fn judge(&self, tally: &mut Tally, found: &[Crossing]) {
        let reach = 0.1 * self.torus.tube();
        let mut found = found.iter().map(|c| c.t).peekable();
        for &truth in &self.truth {
            while let Some(t) = found.next_if(|t| *t < truth - reach) {
                tally.answer(Some(t), None);
            }
            match found.next_if(|t| *t <= truth + reach) {
                Some(t) => tally.error((t - truth) / RING),
                None => tally.answer(None, Some(truth)),
            }
        }
        found.for_each(|t| tally.answer(Some(t), None));
    }
}

/// All roots, slowly: signs of (2.9) with 106 bits, then bisection to neighbouring numbers.
///
/// No quartic is expanded: only where to look for a sign is told by the stationary points along the ray,
/// and there an error does not matter, for the value hardly changes near them.
fn truth(torus: &Torus, ray: &Ray) -> Vec<f64> {
    let mut marks = stationary_points(torus, ray);
    let (middle, reach) = (-ray.origin.dot(ray.direction), 2.0 * RING);
    marks.insert(0, middle - reach);
    marks.push(middle + reach);
    let brackets = marks.windows(2).filter(|w| outside(torus, ray, w[0]) != outside(torus, ray, w[1]));
    brackets.map(|w| bisect(torus, ray, w[0], w[1])).collect()
}

/// Parameters [m] of the points between which the quartic is monotone, of a ray with a unit direction.
fn stationary_points(torus: &Torus, ray: &Ray) -> Vec<f64> {
    let middle = -ray.origin.dot(ray.direction);
    let (m, d, a2) = (ray.at(middle), ray.direction, torus.ring() * torus.ring());
    let gap = (torus.ring() - torus.tube()) * (torus.ring() + torus.tube());
    let linear = 8.0 * a2 * m.z * d.z;
    let square = 2.0 * (m.length_squared() + gap) - 4.0 * a2 * d.truncate().length_squared();
    real_roots([linear, 2.0 * square, 0.0, 4.0, 0.0]).into_iter().map(|s| middle + s).collect()
}

/// Is the exact point `o + t d` outside? By the quartic form (2.9), with 106 bits.
fn outside(torus: &Torus, ray: &Ray, t: f64) -> bool {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    let p = [0, 1, 2].map(|k| DoubleDouble::product(t, d[k]) + DoubleDouble::of(o[k]));
    let (a, b) = (torus.ring(), torus.tube());
    let flat = p[0].square() + p[1].square();
    let sum = flat + p[2].square() + DoubleDouble::sum(a, -b) * DoubleDouble::sum(a, b);
    (sum.square() - (flat * DoubleDouble::product(a, a)).shift(4.0)).high > 0.0
}

fn bisect(torus: &Torus, ray: &Ray, mut lo: f64, mut hi: f64) -> f64 {
    let at_lo = outside(torus, ray, lo);
    loop {
        let m = 0.5 * (lo + hi);
        if m <= lo || m >= hi {
            return m;
        }
        if outside(torus, ray, m) == at_lo { lo = m } else { hi = m }
    }
}
