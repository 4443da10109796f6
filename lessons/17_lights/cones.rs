//! Is a place in the cone of a spot? Four ways to compare angles, from wide cones to needles.

use glam::{DVec2, DVec3};
use lightbench::color::Rgb;
use lightbench::light::{PointLight, SpotLight};
use lightbench::measure::{Method, Point, Series, Spread, Tally, log_spaced, timed};
use lightbench::num::U;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide};
use lightbench_kit::lesson::Result;
use std::f64::consts::TAU;

use super::stage::other;

/// Of the cone's half angle: all light is let out within it.
const FULL: f64 = 2.0 / 3.0;
const DIRECTIONS: u32 = 512;
/// Two unit vectors leave an angle uncertain by 13 u; the share falls within a third of the half angle, at most 3/2 times as
/// steeply as a line, whose slope over the angle is twice that over the versine: 3 · 13 · 3.
pub const BOUND: f64 = 117.0;

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Test {
    /// `cos θ` against the cosines of the two angles.
    Cosines,
    /// `θ = acos(cos θ)`.
    Arccosine,
    /// `θ = atan2(|a × d|, a · d)`.
    Arctangent,
    /// `|d − a|²/2`, the library's.
    Versines,
}

pub const TESTS: [Test; 4] = [Test::Cosines, Test::Arccosine, Test::Arctangent, Test::Versines];

fn method(test: Test) -> Method {
    match test {
        Test::Cosines => Method::new("cosines").styled(1),
        Test::Arccosine => Method::new("arc cosine").styled(4),
        Test::Arctangent => Method::new("arc tangent of cross and dot").styled(2),
        Test::Versines => Method::default_of("squared difference").styled(0),
    }
}

fn smooth(s: f64) -> f64 {
    // NaN goes through: neither comparison holds.
    if s <= 0.0 {
        0.0
    } else if s >= 1.0 {
        1.0
    } else {
        s * s * (3.0 - 2.0 * s)
    }
}

/// The share as a function of the angle's versine, which is exact for an exact angle.
fn share_of_angle(angle: f64, edge: f64) -> f64 {
    let versine = |angle: f64| 2.0 * (0.5 * angle).sin().powi(2);
    let (full, edge, at) = (versine(FULL * edge), versine(edge), versine(angle));
    smooth((edge - at) / (edge - full))
}

/// A cone, and directions about its rim with their true shares.
pub struct Cone {
    edge: f64,
    axis: DVec3,
    light: SpotLight,
    asked: Vec<(DVec3, f64)>,
}

impl Cone {
    pub fn new(edge: f64, seed: u64) -> Result<Self> {
        let mut sampler = Sampler::new(seed, 17, 0);
        let axis = uniform_sphere(sampler.next_2d());
        let point = PointLight::of_intensity(DVec3::ZERO, Rgb::ONE);
        let light = SpotLight::new(point, axis, FULL * edge, edge).map_err(other)?;
        let (x, y) = axis.any_orthonormal_pair();
        let asked = (0..DIRECTIONS).map(|_| {
            let u: DVec2 = sampler.next_2d();
            let angle = 1.2 * edge * u.x;
            let across = x * (TAU * u.y).cos() + y * (TAU * u.y).sin();
            ((axis * angle.cos() + across * angle.sin()).normalize(), share_of_angle(angle, edge))
        });
        let asked = asked.collect();
        Ok(Cone { edge, axis, light, asked })
    }

    #[inline]
    fn share(&self, test: Test, d: DVec3) -> f64 {
        match test {
            Test::Cosines => {
                let (full, edge) = ((FULL * self.edge).cos(), self.edge.cos());
                smooth((d.dot(self.axis) - edge) / (full - edge))
            }
            Test::Arccosine => share_of_angle(d.dot(self.axis).acos(), self.edge),
            Test::Arctangent => {
                share_of_angle(self.axis.cross(d).length().atan2(d.dot(self.axis)), self.edge)
            }
            Test::Versines => self.light.share(d),
        }
    }

    /// The worst error of the share; NaN counts as a failure.
    pub fn errors(&self, test: Test) -> Tally {
        let mut tally = Tally::new();
        for (d, truth) in &self.asked {
            tally.error(self.share(test, *d) - truth);
        }
        tally
    }

    fn worst(&self, test: Test) -> Point {
        let tally = self.errors(test);
        let worst = tally.worst().map(Spread::exact);
        Point { error: worst, ..tally.worst_at(self.edge) }
    }

    /// Time of one share [s]: the median of many short runs, of which a busy machine spoils few.
    fn time(&self, test: Test) -> Spread {
        let sum = || self.asked.iter().map(|(d, _)| self.share(test, *d)).sum::<f64>();
        let runs: Vec<f64> = (0..301).map(|_| timed(sum).0 / f64::from(DIRECTIONS)).collect();
        Spread::median(&runs).unwrap_or(Spread::exact(f64::NAN))
    }
}

/// Worst errors of all tests over the half angle.
pub fn sweep(seed: u64, count: usize) -> Result<Vec<(Method, Series)>> {
    let edges = log_spaced(1.0e-9, 1.0, count);
    let mut all = Vec::new();
    for test in TESTS {
        let mut points = Vec::new();
        for &edge in &edges {
            points.push(Cone::new(edge, seed)?.worst(test));
        }
        all.push((method(test), Series::new(points)));
    }
    Ok(all)
}

pub fn errors(sweep: &[(Method, Series)]) -> Figure {
    let chart =
        Chart::error_over(Axis::log("half angle of the cone [rad]"), "worst error of the share of light")
            .title("Cosines lose a cone of 10⁻⁸ rad; squared differences keep it")
            .subtitle(&format!(
                "{DIRECTIONS} directions up to 1.2 times the half angle, full light within two thirds of it"
            ))
            .guide(Guide::slope_through(-1.0, 1.0e-3, BOUND * U / 1.0e-3, "the library's bound, 117 u/θ"))
            .guide(Guide::slope_through(-2.0, 1.0e-3, 6.0 * U / 1.0e-6, "u/θ²"));
    let chart = sweep.iter().fold(chart, |chart, (method, series)| chart.line(method.clone(), series));
    Figure::from(chart).caption(
        "The cosine of a small angle is 1 − θ²/2: below 10⁻⁸ rad it is 1 for every direction, and the quotient of two differences \
         of cosines is 0/0, which the strip below counts. The difference of two unit vectors has the length of the angle itself.")
}

/// Time and error of all tests, from wide cones to needles.
pub fn contest(seed: u64) -> Result<Figure> {
    let mut chart = Chart::speed_accuracy("worst error of the share of light");
    let mut times = Vec::new();
    for test in TESTS {
        let (mut points, time) = (Vec::new(), Cone::new(1.0e-3, seed)?.time(test));
        for edge in [0.3, 1.0e-2, 1.0e-3, 1.0e-4, 1.0e-6] {
            points.push(Cone::new(edge, seed)?.worst(test).timed(time));
        }
        times.push(time.mid * 1.0e9);
        chart = chart.line(method(test), &Series::new(points));
    }
    let chart = chart
        .x(Axis::time("time per share"))
        .title(&format!(
            "Squared differences err no more than the arc tangent, in {:.1} instead of {:.0} ns",
            times[3], times[2]
        ))
        .subtitle("cones of half angle 0.3, 10⁻², 10⁻³, 10⁻⁴, 10⁻⁶ rad, from below upwards; time of 10⁻³; 512 directions");
    Ok(Figure::from(chart).caption(
        "Time and worst error of four ways to find how much of a spot's light a direction gets. The library's keeps the two versines; \
         the others begin from the angles of the cone each time."))
}
