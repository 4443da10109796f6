//! Where the cosine fails: at the horizon, in the lamp, with normals that are not unit; and what distance does not do.

use super::model::{Eyesight, MIST, Made, other, scene};
use glam::{DVec3, dvec3};
use lightbench::color::Rgb;
use lightbench::integrator::Integrator;
use lightbench::light::PointLight;
use lightbench::measure::{Method, log_spaced};
use lightbench::ray::{Ray, Silent};
use lightbench::sample::{Sampler, point2, uniform, uniform_sphere};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};
use lightbench_kit::lesson::Result;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, TAU};

/// Relative change of a surface's radiance with the eye's distance: in a vacuum, its bound, in mist, and as if light thinned out.
pub struct Vacuum {
    pub change: Vec<f64>,
    /// Of the eye [m].
    pub distance: Vec<f64>,
    pub bound: Vec<f64>,
}

pub fn vacuum() -> Result<Vacuum> {
    let times = log_spaced(1.0, 1.0e6, 25);
    let seen = times.iter().map(|t| seen_from(*t)).collect::<Result<Vec<_>>>()?;
    let near = seen[0][0];
    Ok(Vacuum {
        change: seen.iter().map(|s| (s[0] - near).abs() / near).collect(),
        bound: seen.iter().map(|s| s[1]).collect(),
        distance: seen.iter().map(|s| s[2]).collect(),
    })
}

impl Vacuum {
    pub fn chart(&self) -> Figure {
        let line = |from: usize, y: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
            (from..self.distance.len()).map(|i| (self.distance[i], y(i))).collect()
        };
        let further = |i: usize| self.distance[i] - self.distance[0];
        let mist = Method::new(&format!("mist of {:.0} % a metre", 100.0 * MIST)).styled(2);
        let chart = Chart::new(
            Axis::log("distance of the eye [m]"),
            Axis::log("relative change of radiance"),
        )
        .title(&format!(
            "A million times as far away a surface is as bright as before, to {}",
            short(self.worst())
        ))
        .subtitle(
            "one place of the red sphere, seen along one line; what changes is where rounding puts the place",
        )
        .function(mist, &line(1, &|i| -(-MIST * further(i)).exp_m1()))
        .function(
            Method::new("if the eye saw 1/d²").styled(3),
            &line(1, &|i| 1.0 - (self.distance[0] / self.distance[i]).powi(2)),
        )
        .function(Method::new("bound from the place's rounding").styled(5), &line(0, &|i| self.bound[i]))
        .curve(Method::new("vacuum: simplification 10").styled(0), &line(0, &|i| self.change[i]))
        .guide(Guide::level(f64::EPSILON, "machine epsilon"));
        Figure::from(chart).caption(
            "Simplification 10, no loss on the way to the eye, is exact in a vacuum: radiance stays the same along a ray. The surface \
             covers fewer pixels from afar, which is where 1/d² goes.")
    }

    /// Does every change stay under its bound?
    pub fn holds(&self) -> bool {
        self.change.iter().zip(&self.bound).all(|(c, b)| c <= b)
    }

    pub fn worst(&self) -> f64 {
        self.change.iter().copied().fold(0.0, f64::max)
    }
}

/// The radiance of one place of the red sphere, seen from `times` as far along the same line: ours, and a bound on what
/// rounding of the place may change, relative; and the distance [m].
fn seen_from(times: f64) -> Result<[f64; 3]> {
    let made = Made::NONE.with(8).with(6);
    let scene = scene(made, 1)?;
    let eye = scene.camera.position();
    let target = dvec3(-1.15, 1.0, 0.35);
    let first = Ray::new(eye, (target - eye).normalize());
    let met = |ray: &Ray| scene.nearest(ray, f64::INFINITY, &mut Silent).map(|(i, c)| scene.hit(ray, i, &c));
    let Some(near) = met(&first) else { return Err(other("the ray misses")) };
    let ray = Ray::new(near.point - first.direction * (times * near.t), first.direction);
    let Some(far) = met(&ray) else { return Err(other("the ray misses from afar")) };
    let value = Eyesight::new(made).radiance(&scene, &ray, &mut Sampler::new(0, 0, 0), &mut (), &mut Silent);
    // The place moves by its own error and by that of the origin; the normal turns by as much over the radius, 1 m, the way to
    // the lamps, over 3 m long, by less; cos θ > ¼.
    let moved = far.point_error + near.point_error + far.point.distance(near.point);
    Ok([value.x, 8.0 * moved + 64.0 * f64::EPSILON, times * near.t])
}

/// Relative error of N · L towards the horizon, in both precisions, and by the length of a normal.
pub fn horizon(runs: u32, seed: u64) -> Figure {
    let gaps = log_spaced(1.0e-15, FRAC_PI_2, 46);
    let worst = |error: &dyn Fn(f64, DVec3, DVec3) -> f64| {
        gaps.iter()
            .map(|&gap| {
                let of = |run: u32| {
                    let n = uniform_sphere(point2(seed, 13, run));
                    let (x, y) = lightbench::frame::basis(n);
                    let phi = TAU * uniform(seed, 14, run, 0);
                    error(gap, n, x * phi.cos() + y * phi.sin())
                };
                (gap, (0..runs).map(of).fold(0.0, f64::max))
            })
            .collect::<Vec<_>>()
    };
    // The vectors that a program has are rounded: L from its angle above the horizon, in the plane of N and t.
    let relative = |found: f64, gap: f64| ((found - gap.sin()) / gap.sin()).abs();
    let double = worst(&|gap, n, t| relative(n.dot(t * gap.cos() + n * gap.sin()), gap));
    let single = worst(&|gap, n, t| {
        let l = (t * gap.cos() + n * gap.sin()).as_vec3();
        relative(f64::from(n.as_vec3().dot(l)), gap)
    });
    let long = worst(&|gap, n, t| relative((n * 1.01).dot(t * gap.cos() + n * gap.sin()), gap));
    let chart = Chart::new(Axis::log("angle between light and horizon, 90° − θ [rad]"), Axis::log("largest relative error of N · L"))
        .title("Towards the horizon N · L loses a digit for each digit of the angle; what is lost is dark anyway")
        .subtitle(&format!("{runs} pairs of rounded vectors for each angle; relative to a facing surface the error is some roundings at most"))
        .function(Method::new("64 bits").styled(0), &double)
        .function(Method::new("32 bits").styled(2), &single)
        .function(Method::new("64 bits, |N| = 1.01").styled(3), &long)
        .guide(Guide::slope_through(-1.0, 1.0e-6, 2.0e-10, "slope −1: 2u / (90° − θ)"))
        .guide(Guide::level(1.0, "wrong by all of it"));
    Figure::from(chart).caption(
        "The dot product errs by a rounding of 1, whatever it comes to. That is a large share of a small cosine, and never more than \
         a rounding of the brightest light. A normal that is 1 % too long makes everything 1 % too bright.")
}

/// Lambert's law typed as C prints it, Iᵢ K (N · L) with L = to/|to|: no guard.
fn naive_cosine(n: DVec3, lamp: DVec3, p: DVec3) -> f64 {
    let to = lamp - p;
    n.dot(to / to.length())
}

/// The library's: what arrives, times the cosine where there is one.
fn guarded(n: DVec3, lamp: DVec3, p: DVec3) -> f64 {
    let arrival = PointLight::of_color(lamp, Rgb::ONE).arriving(p);
    let cos_theta = n.dot(arrival.wi);
    if cos_theta > 0.0 { cos_theta * arrival.irradiance.x * FRAC_1_PI } else { 0.0 }
}

/// Odd places for a lamp.
pub fn cases() -> Table {
    let up = DVec3::Y;
    let far = |d: f64| dvec3(0.0, d, 0.0);
    let cases = [
        ("lamp straight above, 1 m", up, far(1.0), "1"),
        ("lamp in the horizon", up, dvec3(1.0, 0.0, 0.0), "0"),
        ("lamp behind, at 120°", up, dvec3(0.75f64.sqrt(), -0.5, 0.0), "0"),
        ("lamp in the place itself", up, DVec3::ZERO, "0"),
        ("|N| = 2, lamp above", up * 2.0, far(1.0), "1"),
        ("N = 0: a normal that was lost", DVec3::ZERO, far(1.0), "none"),
        ("lamp at 10⁻¹⁰⁰ m", up, far(1.0e-100), "1"),
        ("lamp at 10⁻²⁰⁰ m", up, far(1.0e-200), "1"),
        ("lamp at 10¹⁵⁰ m", up, far(1.0e150), "1"),
        ("lamp at 10²⁰⁰ m", up, far(1.0e200), "1"),
    ];
    let mut table = Table::new(&["case", "cos θ, true", "as printed, (N · L)", "ours"])
        .title("Typed as printed the cosine turns negative, NaN, or 2; a test for > 0 settles all but lengths")
        .subtitle("light of colour 1 without attenuation on a white surface; a facing surface shows 1; L is the way to the lamp over its length");
    for (name, n, lamp, truth) in cases {
        let [printed, ours] = [naive_cosine(n, lamp, DVec3::ZERO), guarded(n, lamp, DVec3::ZERO)];
        table = table.row(&[name, truth, &short(printed), &short(ours)]);
    }
    table
}

/// What parallel light gets wrong under a lamp at a distance: closed form.
pub fn parallel() -> Figure {
    let distances = log_spaced(0.3, 1000.0, 60);
    let line = |f: fn(f64) -> f64| distances.iter().map(|&h| (h, f(h))).collect::<Vec<_>>();
    let at = |h: f64| 1.0 - (1.0 + 1.0 / (h * h)).powf(-1.5);
    let chart = Chart::new(Axis::log("distance of the lamp over half the surface's width"), Axis::log("largest error"))
        .title(&format!(
            "Ten times as far as the surface reaches, parallel light errs by {:.1} %, a hundred times by {:.3} %",
            100.0 * at(10.0),
            100.0 * at(100.0)
        ))
        .subtitle("a lamp over the middle of a disc, at its edge: irradiance 1 − (1 + 1/h²)^(−3/2), relative to the middle; angle of incidence arctan 1/h")
        .function(Method::new("irradiance, relative").styled(0), &line(|h| {
            // 1 − (1 + x)^(−3/2) without cancellation.
            -(-1.5 * (1.0 / (h * h)).ln_1p()).exp_m1()
        }))
        .function(Method::new("angle of incidence [rad]").styled(2), &line(|h| (1.0 / h).atan()))
        .guide(Guide::level(1.0 / 255.0, "a level of 255"));
    Figure::from(chart).caption("When simplification 9 may be made: the irradiance converges with the square of the distance, the direction, and with it shadows and highlights, only with the distance itself.")
}
