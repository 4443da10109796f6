//! Where estimates fail: near a light, at grazing angles, and far away.

use super::naive::naive_map;
use super::place::{Place, mid, other, seed_of};
use glam::{DVec3, dvec2};
use lightbench::light::{Emitter, Measure, Rectangle};
use lightbench::measure::{Method, Series, Spread, Tally, log_spaced};
use lightbench::num::U;
use lightbench::sample::{Pattern, Sampler, uniform_sphere};
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::Triangle;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, short};
use lightbench_kit::lesson::Result;

const SAMPLES: u32 = 16;
/// An error of half the light.
const USELESS: f64 = 0.5;

/// Relative RMSE of 16 jittered points on a unit square, over the distance of its centre and the height above its plane.
pub struct Near {
    axes: [Axis; 2],
    size: (usize, usize),
    runs: u32,
    seed: u64,
}

impl Near {
    pub fn new(size: (usize, usize), runs: u32, seed: u64) -> Self {
        let axes = [
            Axis::log("distance of the light’s centre, in sides of the light").range(1.0e-3, 1.0e3),
            Axis::log("angle above the light’s plane, degrees").range(0.01, 90.0),
        ];
        Near { axes, size, runs, seed }
    }

    fn error(&self, light: &Emitter, measure: Measure, distance: f64, degrees: f64) -> f64 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        // Off the diagonal and off the axes of the square; turned to its centre.
        let way = DVec3::new(cos * 0.8, cos * 0.6, sin);
        let place = Place { p: way * distance, n: -way };
        let truth = place.truth(light);
        let one = |run| {
            let set = Pattern::Jittered.points(SAMPLES, seed_of(self.seed, run));
            place.estimate(light, measure, set) / truth - 1.0
        };
        let errors: Vec<f64> = (0..self.runs).map(one).collect();
        Spread::rms(&errors).map_or(f64::NAN, |s| s.mid)
    }

    /// The map, the share of it that fails, and the largest error.
    pub fn map(&self, measure: Measure) -> Result<(Figure, f64, f64)> {
        let light: Emitter =
            Rectangle::facing(DVec3::ZERO, DVec3::Z, 0.0, dvec2(1.0, 1.0)).map_err(other)?.into();
        let [x, y] = self.axes.clone();
        let mut worst: f64 = 0.0;
        let map = FailureMap::new(x, y, "relative RMSE", self.size, |distance, degrees| {
            let error = self.error(&light, measure, distance, degrees);
            worst = worst.max(error);
            Some(error.max(1.0e-7))
        })
        .range(1.0e-7, 1.0e2)
        .failing_above(USELESS, "error above 50 %");
        let share = map.failing_share();
        let subtitle = format!(
            "irradiance of a place turned to the centre of a square light, {SAMPLES} jittered points, {} runs a cell",
            self.runs
        );
        let map = map.subtitle(&subtitle);
        let (map, caption) = match measure {
            Measure::Area => (
                map.title("Close to a light, points spread over its area miss the little that is near"),
                "Relative error of 16 points spread evenly over the light's area. Where the light is nearer than its points stand apart, all that counts is a spot of the size of the distance: \
                 mostly no point is there, and when one is it counts 1/d² times too much.",
            ),
            Measure::SolidAngle => (
                map.title(&format!(
                    "Points spread over what is seen never err by more than {}",
                    super::place_percent(worst)
                )),
                "The same light, the same number of points, spread evenly over the solid angle: cos θₗ/d² is no longer left to chance, only the cosine at the receiver is.",
            ),
        };
        Ok((Figure::from(map).caption(caption), share, worst))
    }
}

/// A light 1 m wide at the origin, turned at random, and a receiver at a distance: rectangle, triangle, sphere.
fn turned(kind: usize, distance: f64, seed: u64, run: u32) -> Result<(Emitter, Place)> {
    let mut random = Sampler::new(seed, 3, run);
    let way = uniform_sphere(random.next_2d());
    let lean = |w: DVec3, by: DVec3| (w + by * 0.6).normalize();
    let (a, b) = (uniform_sphere(random.next_2d()), uniform_sphere(random.next_2d()));
    let facing = lean(-way, a);
    let (x, y) = facing.any_orthonormal_pair();
    let emitter = match kind {
        0 => Rectangle::facing(DVec3::ZERO, facing, 0.4, dvec2(1.0, 0.7)).map_err(other)?.into(),
        1 => Triangle::new(x * -0.5, x * 0.5, y * 0.8).map_err(other)?.into(),
        _ => Emitter::from(Sphere::new(DVec3::ZERO, 0.5).map_err(other)?),
    };
    Ok((emitter, Place { p: way * -distance, n: lean(way, b) }))
}

/// Six lines: three maps as printed, three of the library.
pub struct Far {
    pub lines: Vec<(Method, Series)>,
}

impl Far {
    pub fn measured(steps: usize, runs: u32, seed: u64) -> Result<Self> {
        let names = ["rectangle (Ureña 2013)", "triangle (Arvo 1995)", "sphere (1 − cos)"];
        let distances = log_spaced(2.0, 1.0e10, steps);
        let mut lines = Vec::new();
        for (kind, name) in names.iter().enumerate() {
            let [mut theirs, mut ours] = [Vec::new(), Vec::new()];
            for &distance in &distances {
                let [mut naive, mut robust] = [Tally::new(), Tally::new()];
                for run in 0..runs {
                    let (light, place) = turned(kind, distance, seed, run)?;
                    let truth = Some(place.truth(&light));
                    let set = Pattern::Sobol.points(SAMPLES, seed_of(seed, run));
                    let one = |u| {
                        let (area, w) = naive_map(&light, place.p, u);
                        area * place.n.dot(w).max(0.0)
                    };
                    let sum: f64 = set.iter().map(one).sum();
                    naive.answer(Some(sum / f64::from(SAMPLES)), truth);
                    robust.answer(Some(place.estimate(&light, Measure::SolidAngle, set)), truth);
                }
                theirs.push(naive.rms_at(distance));
                ours.push(robust.rms_at(distance));
            }
            let short_name = name.split(' ').next().unwrap_or(name);
            lines.push((Method::new(name).styled(kind), Series::new(theirs)));
            lines.push((Method::default_of(short_name).styled(kind + 3), Series::new(ours)));
        }
        Ok(Far { lines })
    }

    /// The smallest distance from which on the printed map of a light (0 rectangle, 1 triangle, 2 sphere) errs above a limit.
    pub fn fails_from(&self, kind: usize, limit: f64) -> f64 {
        let points = &self.lines[2 * kind].1.points;
        let good = points.iter().rposition(|p| p.failures.total() == 0 && mid(p) <= limit);
        points.get(good.map_or(0, |i| i + 1)).map_or(f64::INFINITY, |p| p.parameter)
    }

    /// The largest error of ours beyond a distance.
    pub fn ours_beyond(&self, distance: f64) -> f64 {
        let points = [1, 3, 5].into_iter().flat_map(|k| &self.lines[k].1.points);
        points.filter(|p| p.parameter >= distance).map(mid).fold(0.0, f64::max)
    }

    pub fn chart(&self) -> Figure {
        let from = [0, 1, 2].map(|k| self.fails_from(k, 0.01)).into_iter().fold(f64::INFINITY, f64::min);
        let mut chart = Chart::error_over(
            Axis::log("distance of the light, in its size"),
            "error of irradiance, relative RMSE",
        )
        .title(&format!(
            "Angles less π lose a far light: from {} sizes on by more than 1 %; points on the light keep it to {}",
            short(from), short(self.ours_beyond(1.0e8))
        ))
        .subtitle("16 Sobol’ points even by solid angle, lights turned at random, against closed forms with 106 bits");
        for (method, series) in &self.lines {
            chart = chart.line(method.clone(), series);
        }
        let chart = chart
            .guide(Guide::level(2.0 * U, "machine epsilon"))
            .guide(Guide::slope_through(2.0, 1.0e3, 3.0e-11, "ε d²"));
        Figure::from(chart).caption(
            "Maps by solid angle as printed, and the library's. A far light covers some 1/d² sr, which the printed maps take as a sum of angles less π or 2π, or as 1 − cos: rounding of the \
             large terms is all that is left beyond 10⁸ sizes. From there on their answer is nothing or nonsense. The error that ours shows near by is the sampling's.")
    }
}
