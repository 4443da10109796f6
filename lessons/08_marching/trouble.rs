//! Where marching fails: steep fields, rays along surfaces, scenes far from the origin.

use super::contestant::{Contestant, is_wrong};
use super::stage::{FROM_THE_FLOOR, Stage};
use super::{Contest, FAR, RIPPLES, STEEP};
use glam::{DVec3, dvec3};
use lightbench::measure::{Failures, Method, Point, Series, log_spaced};
use lightbench::ray::Ray;
use lightbench::sdf::combine::Rippled;
use lightbench::sdf::general::{bisection, brackets};
use lightbench::sdf::printed::AsPrinted;
use lightbench::sdf::{March, Stride};
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure};
use lightbench_kit::lesson::{Lesson, Result};

const AWAY: std::ops::Range<f64> = 1.0..1.0e12; // m; distance of the stage from the world's origin
const NEAR_ENOUGH: std::ops::Range<f64> = 1.0e-9..1.0e-1; // m; ε

/// A unit sphere with ripples.
pub type Planet = Rippled<Sphere>;

pub fn planet(amplitude: f64) -> Planet {
    Rippled::new(Sphere::new(DVec3::ZERO, 1.0).expect("a radius"), amplitude, RIPPLES).expect("ripples")
}

/// A ball with the whole planet in it, and whatever a march calls near enough: a ray that misses it misses the planet, and need not
/// be followed to where the sines of large numbers are slow.
pub fn hull(amplitude: f64) -> Sphere {
    Sphere::new(DVec3::ZERO, 1.001 + amplitude).expect("a radius")
}

pub struct Trouble {
    steep: Contest,
    grazing: Contest,
    away: [FailureMap; 2],
}

fn share(found: impl Iterator<Item = (Option<f64>, Option<f64>)>, parameter: f64) -> Point {
    let mut failures = Failures::default();
    for (found, truth) in found {
        failures.of += 1;
        let wrong = u64::from(is_wrong(found, truth));
        if found.is_some() { failures.false_hits += wrong } else { failures.missed += wrong }
    }
    Point { failures, ..Point::at(parameter) }
}

impl Trouble {
    pub fn measured(lesson: &Lesson) -> Self {
        Trouble { steep: steep(lesson), grazing: grazing(lesson), away: away(lesson) }
    }

    /// Wrong pixels at the steepest field, by whole leaps and by the default; and how many were asked.
    pub fn steepest(&self) -> ([u64; 2], u64) {
        let last = |k: usize| self.steep[k].1.points.last().map(|p| p.failures).unwrap_or_default();
        ([last(0).total(), last(3).total()], last(0).of)
    }

    pub fn show(&self, lesson: &Lesson) -> Result {
        lesson.save("steep", self.steep_chart())?;
        lesson.save("grazing", self.grazing_chart())?;
        let words = ["as printed", "the default"];
        for (map, (word, file)) in self.away.iter().zip(words.iter().zip(["away_as_printed", "away"])) {
            let share = 100.0 * map.failing_share();
            let title = match *word {
                "as printed" => format!("As printed: pixels are wrong on {share:.0} % of the map"),
                _ => {
                    format!("The default: right on {:.0} % of the map, whatever the distance", 100.0 - share)
                }
            };
            let map = map.clone().title(&title).subtitle(
                "hatched: at least one of 96 pixels is wrong. The eye stands before the stage; the world's origin is far away",
            );
            lesson.save(file, Figure::from(map).caption(&format!(
                "Wrong pixels {word}, over the distance of eye and stage from the world's origin and the accuracy asked for."
            )))?;
        }
        Ok(())
    }

    fn steep_chart(&self) -> Figure {
        let axis = Axis::log("amplitude of the ripples, m (steepest slope: 1 + 20 × that)");
        let ([leapt, _], of) = self.steepest();
        let chart = Chart::failures_over(axis, "wrong pixels")
            .title(&format!(
                "Leaping by the whole of a field of slope 5 loses {leapt} of {of} pixels; divided by its bound none"
            ))
            .subtitle("unit sphere + A sin 20x sin 20y sin 20z; ε = 10⁻⁴ m; truth: signs at 3000 places a ray, bisected");
        Figure::from(lines(chart, &self.steep)).caption(
            "Share of wrong pixels over the height of the ripples. As printed, a step is the field's value, and a field steeper than one \
             is leapt through; programs live with it by walking a share of each step, and hope. Divided by its Lipschitz \
             bound 1 + 20 A the field is safe at any height.",
        )
    }

    fn grazing_chart(&self) -> Figure {
        let chart = Chart::failures_over(Axis::log("most steps a ray may take"), "wrong pixels")
            .title("Seen from the floor, a bound on the steps makes holes; a tolerance that doubles does not")
            .subtitle("the still life from 2 cm above the floor; ε = 10⁻⁵ m; the default takes the steps as its patience");
        Figure::from(lines(chart, &self.grazing)).caption(
            "Share of wrong pixels over the number of steps after which the printed march gives up, and the default doubles its \
             shortest step. Rays along the floor draw near it slowly: each step is a small share of the way.",
        )
    }
}

fn lines(mut chart: Chart, contest: &Contest) -> Chart {
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    chart
}

fn steep(lesson: &Lesson) -> Contest {
    let amplitudes = log_spaced(STEEP.start, STEEP.end, lesson.pick([3, 7, 9, 13]));
    let side = lesson.pick([12, 28, 64, 128]);
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(side) * 2.6 - 1.3;
    let rays: Vec<Ray> =
        (0..side * side).map(|i| Ray::new(dvec3(at(i % side), at(i / side), 4.0), DVec3::NEG_Z)).collect();
    let truths: Vec<Vec<Option<f64>>> =
        amplitudes.iter().map(|a| rays.iter().map(|r| safe(&hull(*a), &planet(*a), r)).collect()).collect();
    let mut contest: Contest =
        [("as printed", 1.0, 0), ("0.7 of each step", 0.7, 3), ("half of each step", 0.5, 2)]
            .map(|(name, part, style)| {
                let method =
                    if part < 1.0 { Method::new(name).styled(style) } else { Method::as_printed(name) };
                let printed = AsPrinted::new(1.0e-4, 1000).with_share(part);
                let point = |(a, truth): (&f64, &Vec<Option<f64>>)| {
                    let field = planet(*a);
                    let found = rays
                        .iter()
                        .map(|r| printed.intersect(&[&field], r).0.map(|h| h.0).filter(|t| *t < FAR));
                    share(found.zip(truth.iter().copied()), *a)
                };
                (method, Series::new(amplitudes.iter().zip(&truths).map(point).collect()))
            })
            .into();
    let point = |(a, truth): (&f64, &Vec<Option<f64>>)| {
        let field = planet(*a);
        let found = rays.iter().map(|r| March::through(&field).first(&field, r, 0.0, FAR).distance);
        share(found.zip(truth.iter().copied()), *a)
    };
    let ours = Series::new(amplitudes.iter().zip(&truths).map(point).collect());
    contest.push((Method::default_of("divided by its bound").styled(0), ours));
    contest
}

/// A long and safe march: signs at places 0.9 mm apart, and the first change bisected.
fn safe(hull: &Sphere, field: &Planet, ray: &Ray) -> Option<f64> {
    use lightbench::sdf::DistanceField;
    let f = |t: f64| field.distance(ray.at(t));
    hull.nearest(ray, 0.0, FAR)?;
    brackets(f, 2.6, 5.4, 3000).next().map(|b| bisection(f, b))
}

fn grazing(lesson: &Lesson) -> Contest {
    let stage = Stage::new(super::stage::HOME);
    let rays = stage.view(lesson.pick([12, 60, 120, 200]), FROM_THE_FLOOR);
    let truth: Vec<_> = rays.iter().map(|r| stage.by_formula(r)).collect();
    let caps = log_spaced(8.0, 1024.0, lesson.pick([4, 8, 8, 15]));
    let ask = |most: f64, of: &dyn Fn(&Ray, u32) -> Option<f64>| {
        share(rays.iter().map(|r| of(r, most as u32)).zip(truth.iter().copied()), most)
    };
    let printed = |r: &Ray, most| {
        AsPrinted::new(1.0e-5, most).intersect(&[&stage.field], r).0.map(|h| h.0).filter(|t| *t < FAR)
    };
    let patient = |r: &Ray, patience| {
        let march = March { patience, ..March::through(&stage.field).with_tolerance(1.0e-5) };
        march.first(&stage.field, r, 0.0, FAR).distance
    };
    vec![
        (Contestant::Printed.method(), Series::over(&caps, |c| ask(c, &printed))),
        (Contestant::Marching(Stride::ALL[2]).method(), Series::over(&caps, |c| ask(c, &patient))),
    ]
}

fn away(lesson: &Lesson) -> [FailureMap; 2] {
    let size = lesson.pick([(4, 3), (24, 16), (36, 24), (48, 32)]);
    [Contestant::Printed, Contestant::Marching(Stride::ALL[2])].map(|contestant| {
        let across = Axis::log("distance from the world's origin, m").range(AWAY.start, AWAY.end);
        let up = Axis::log("accuracy asked for, m").range(NEAR_ENOUGH.start, NEAR_ENOUGH.end);
        let map = FailureMap::new(across, up, "wrong pixels", size, |distance, accuracy| {
            let stage = Stage::new(dvec3(0.6, -0.64, 0.48) * distance);
            let rays = stage.view(12, super::stage::FROM_ABOVE);
            let found =
                rays.iter().map(|r| (contestant.ask(&stage.field, r, accuracy).0, stage.by_formula(r)));
            Some(share(found, 1.0).failures.share())
        });
        map.shades(lightbench_kit::figure::Shades::Linear).range(0.0, 1.0).failing_above(0.0, "wrong pixels")
    })
}
