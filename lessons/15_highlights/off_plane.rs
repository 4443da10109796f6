//! Viewers beside the plane of incidence: there no exponent makes the half vector's highlight round.

use glam::DVec3;
use lightbench::bsdf::highlight::power;
use lightbench::bsdf::{Directions, Geometry};
use lightbench_kit::figure::{Axis, FailureMap, Figure, Shades};
use rayon::prelude::*;
use std::cell::RefCell;
use std::f64::consts::PI;

/// Viewers about the mirror direction of light at one angle, with what both formulas ask about them.
pub struct Sky {
    n: f64,
    /// `(R·V)ⁿ`, `ln N·H`, and the solid angle but for a factor.
    viewers: Vec<[f64; 3]>,
}

/// Light at an angle [degrees], and its mirror direction with the directions along and across.
fn stage(degrees: f64) -> [DVec3; 4] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [DVec3::new(-sin, 0.0, cos), DVec3::new(sin, 0.0, cos), DVec3::new(cos, 0.0, -sin), DVec3::Y]
}

impl Sky {
    /// `side²` viewers in the middles of cells that hold the same share of a lobe of exponent n/2.
    pub fn new(degrees: f64, n: f64, side: usize) -> Sky {
        let [l, r, along, across] = stage(degrees);
        let share = |k: usize| (k as f64 + 0.5) / side as f64;
        let viewer = |k: usize| {
            // One half of the sky mirrors the other.
            let (q, psi) = (share(k / side), PI * share(k % side));
            let log_cos = (-q).ln_1p() / (0.5 * n + 1.0);
            let (cos, sin) = (log_cos.exp(), (-(2.0 * log_cos).exp_m1()).sqrt());
            let v = r * cos + (along * psi.cos() + across * psi.sin()) * sin;
            let g = Directions { wi: l, wo: v };
            let seen = [power(g.mirror_versine(), n), g.half().log_cos_h(), (-0.5 * n * log_cos).exp()];
            (v.z > 0.0).then_some(seen)
        };
        Sky { n, viewers: (0..side * side).filter_map(viewer).collect() }
    }

    /// Relative difference for the exponent `m`, as in the library's `mismatch`.
    pub fn mismatch(&self, m: f64) -> f64 {
        let (mut square, mut all) = (0.0, 0.0);
        for [p, log, weight] in &self.viewers {
            let d = p - (m * log).exp();
            square += weight * d * d;
            all += weight * p * p;
        }
        (square / all).sqrt()
    }

    /// The exponent with the least difference, and that: golden section over its logarithm.
    pub fn best(&self) -> (f64, f64) {
        let ratio = 0.5 * (5f64.sqrt() - 1.0);
        let of = |x: f64| self.mismatch(x.exp());
        let (mut a, mut b) = ((0.2 * self.n).ln(), (4.0 * self.n + 4.0).ln());
        let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
        let (mut fc, mut fd) = (of(c), of(d));
        for _ in 0..28 {
            if fc < fd {
                (b, d, fd) = (d, c, fc);
                c = b - ratio * (b - a);
                fc = of(c);
            } else {
                (a, c, fc) = (c, d, fd);
                d = a + ratio * (b - a);
                fd = of(d);
            }
        }
        let x = 0.5 * (a + b);
        (x.exp(), of(x))
    }
}

/// The value of every cell, computed on all cores, then the map.
pub fn filled(
    axes: [Axis; 2],
    value: &str,
    size: (usize, usize),
    cell: impl Fn(f64, f64) -> f64 + Sync,
) -> (FailureMap, Vec<f64>) {
    let [x, y] = axes;
    let places = RefCell::new(Vec::new());
    FailureMap::new(x.clone(), y.clone(), value, size, |x, y| {
        places.borrow_mut().push((x, y));
        None
    });
    let values: Vec<f64> = places.into_inner().into_par_iter().map(|(x, y)| cell(x, y)).collect();
    let mut next = values.iter().copied();
    (FailureMap::new(x, y, value, size, |_, _| next.next()), values)
}

/// The best exponent's difference, over angle and exponent.
pub fn least(columns: usize, side: usize) -> Figure {
    let axes = [
        Axis::linear("angle of the light θ, degrees").range(0.0, 88.0).every(15.0),
        Axis::log("exponent n of R·V").range(1.0, 1.0e4),
    ];
    let (map, values) =
        filled(axes, "difference that the best exponent leaves", (columns, columns * 3 / 4), |d, n| {
            Sky::new(d, n, side).best().1
        });
    let most = values.iter().copied().fold(0.0, f64::max);
    let map = map.shades(Shades::Linear).range(0.0, 1.0).failing_above(0.1, "over 10 %");
    let title = format!(
        "On {:.0} % of the map the best exponent of N·H leaves over 10 % of difference, up to {:.0} %",
        100.0 * map.failing_share(),
        100.0 * most
    );
    let map = map
        .title(&title)
        .subtitle("root mean square over the viewers within 90° of R and above the horizon, in units of the lobe of R·V");
    Figure::from(map).caption(
        "Where C's exchange of R·V for N·H can be compensated: for light within some 35° of the normal. Towards grazing light the highlights have \
         different shapes.",
    )
}

/// Both highlights' difference over the viewers about R.
pub fn difference(degrees: f64, n: f64, columns: usize) -> Figure {
    let [l, r, along, across] = stage(degrees);
    let axis = |title: &str| Axis::linear(title).range(-24.0, 24.0).every(8.0);
    let (map, values) = filled(
        [
            axis("across the plane of incidence, degrees"),
            axis("in the plane, from R towards the horizon, degrees"),
        ],
        "(N·H)⁴ⁿ − (R·V)ⁿ",
        (columns, columns * 3 / 4),
        |x, y| {
            let (x, y) = (x.to_radians(), y.to_radians());
            let v = (r + along * y.tan() + across * x.tan()).normalize();
            let g = Directions { wi: l, wo: v };
            (4.0 * n * g.half().log_cos_h()).exp() - power(g.mirror_versine(), n)
        },
    );
    let least = values.iter().copied().fold(0.0, f64::min);
    let map = map.shades(Shades::Signed).range(-0.6, 0.6).title(&format!(
        "Light at {degrees:.0}°: across the plane the half vector's highlight is {:.2} times as wide, and {:.2} of the peak is missing",
        degrees.to_radians().cos(),
        -least
    ));
    Figure::from(map.subtitle(&format!("n = {n}, exponent 4n; viewers about the mirror direction R; blue: darker than Phong's"))).caption(
        "In the plane of incidence (the vertical line) the two agree; beside it the half vector's highlight falls off sooner: lamps seen in wet \
         streets are drawn out towards the viewer, and Phong's round spot is what does not happen there.",
    )
}
