//! One place and one light, nothing between: estimates of the irradiance against its closed form.

use glam::{DVec3, dvec2, dvec3};
use lightbench::light::{Emitter, Measure, Rectangle, polygon_irradiance, sphere_irradiance};
use lightbench::measure::{Method, Point, Series, Slope, Tally, log_slope};
use lightbench::sample::{Pattern, PointSet, bits};
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::Triangle;
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};
use lightbench_kit::lesson::{LessonError, Result};

pub const MEASURES: [(Measure, &str); 2] = [(Measure::Area, "area"), (Measure::SolidAngle, "solid angle")];

pub fn other(e: impl std::fmt::Display) -> LessonError {
    LessonError(e.to_string())
}

/// The seed of one run of one experiment.
pub fn seed_of(seed: u64, run: u32) -> u64 {
    bits(seed, run.into(), 19, 0)
}

/// Where light is gathered: a point and the unit normal there.
#[derive(Clone, Copy)]
pub struct Place {
    pub p: DVec3,
    pub n: DVec3,
}

impl Place {
    pub const ORIGIN: Place = Place { p: DVec3::ZERO, n: DVec3::Y };

    /// Irradiance from a light of radiance 1, in closed form.
    pub fn truth(&self, emitter: &Emitter) -> f64 {
        match emitter {
            Emitter::Rectangle(r) => polygon_irradiance(&r.corners(), self.p, self.n),
            Emitter::Triangle(t) => polygon_irradiance(&t.corners(), self.p, self.n),
            Emitter::Sphere(s) => sphere_irradiance(s.center(), s.radius(), self.p, self.n),
        }
    }

    /// `cos θ cos θₗ / d²` of a point `x` of the light, where its normal is `nl`.
    pub fn by_area(&self, x: DVec3, nl: DVec3) -> f64 {
        let to = x - self.p;
        let d2 = to.length_squared();
        self.n.dot(to).max(0.0) * (-nl.dot(to)).max(0.0) / (d2 * d2)
    }

    /// `cos θ` of a point `x` of the light.
    pub fn cosine(&self, x: DVec3) -> f64 {
        self.n.dot((x - self.p).normalize_or_zero()).max(0.0)
    }

    /// The mean over a set of points.
    pub fn estimate(&self, emitter: &Emitter, measure: Measure, set: PointSet) -> f64 {
        let share = 1.0 / f64::from(set.len());
        match measure {
            Measure::Area => {
                let one = |x: DVec3| self.by_area(x, normal_at(emitter, x));
                emitter.area() * share * set.iter().map(|u| one(emitter.point(u))).sum::<f64>()
            }
            Measure::SolidAngle => {
                let seen = emitter.seen_from(self.p);
                seen.solid_angle() * share * set.iter().map(|u| self.cosine(seen.point(u))).sum::<f64>()
            }
        }
    }
}

fn normal_at(emitter: &Emitter, x: DVec3) -> DVec3 {
    match emitter {
        Emitter::Sphere(s) => (x - s.center()) / s.radius(),
        flat => flat.flat_normal().unwrap_or(DVec3::ZERO),
    }
}

/// A rectangle, a triangle and a sphere, about 1 m wide, one above [`Place::ORIGIN`], seen at once by all of it.
pub fn lights() -> Result<[(&'static str, Emitter); 3]> {
    let rectangle = Rectangle::facing(dvec3(0.5, 1.0, 0.3), dvec3(-0.2, -1.0, 0.1), 0.3, dvec2(1.2, 0.8));
    let [a, b, c] = [dvec3(0.9, 1.1, -0.3), dvec3(0.1, 0.8, 0.9), dvec3(-0.4, 1.0, -0.2)];
    let triangle = Triangle::new(a, b, c).map_err(other)?;
    let facing = Emitter::from(triangle).faces(DVec3::ZERO);
    let triangle = if facing { triangle } else { Triangle::new(a, c, b).map_err(other)? };
    let sphere = Sphere::new(dvec3(0.4, 1.0, -0.3), 0.5).map_err(other)?;
    Ok([
        ("rectangle", rectangle.map_err(other)?.into()),
        ("triangle", triangle.into()),
        ("sphere", sphere.into()),
    ])
}

/// Relative errors of `runs` estimates at each number of points.
pub fn sweep(
    budgets: &[u32],
    runs: u32,
    seed: u64,
    truth: f64,
    estimate: impl Fn(u32, u64) -> f64,
) -> Series {
    let point = |&n: &u32| {
        let mut tally = Tally::new();
        for run in 0..runs {
            tally.answer(Some(estimate(n, seed_of(seed, run))), Some(truth));
        }
        tally.rms_at(n.into()).worked(n.into())
    };
    Series::new(budgets.iter().map(point).collect())
}

/// All patterns and measures on all lights.
pub struct Unoccluded {
    pub runs: u32,
    /// By light, measure, pattern.
    pub series: Vec<(&'static str, Vec<Vec<Series>>)>,
}

impl Unoccluded {
    pub fn measured(budgets: &[u32], runs: u32, seed: u64) -> Result<Self> {
        let place = Place::ORIGIN;
        let of = |emitter: &Emitter, measure, pattern: Pattern| {
            let one = |n, seed| place.estimate(emitter, measure, pattern.points(n, seed));
            sweep(budgets, runs, seed, place.truth(emitter), one)
        };
        let by_measure = |e: &Emitter| MEASURES.map(|m| Pattern::ALL.map(|p| of(e, m.0, p)).into()).into();
        Ok(Unoccluded { runs, series: lights()?.iter().map(|(name, e)| (*name, by_measure(e))).collect() })
    }

    pub fn slope(&self, light: usize, measure: usize, pattern: usize) -> Slope {
        log_slope(&self.series[light].1[measure][pattern], self.runs)
    }

    /// The rectangle by area, five patterns; and by solid angle, the best of them.
    pub fn chart(&self) -> Figure {
        let [area, solid] = [0, 1].map(|m| &self.series[0].1[m]);
        let last = |s: &Series| s.points.last().map_or((f64::NAN, f64::NAN), |p| (p.parameter, mid(p)));
        let slopes = [0, 1, 2, 3, 4].map(|p| self.slope(0, 0, p).value);
        let title = format!(
            "With nothing in the way every plan beats chance: errors fall as N to the {} at random, {} jittered, {} by Sobol’s points",
            signed(slopes[2]),
            signed(slopes[1]),
            signed(slopes[3])
        );
        let mut chart = Chart::work_accuracy("shadow rays N", "error of irradiance, relative RMSE")
            .title(&title)
            .subtitle(&format!(
                "a rectangle of 1.2 × 0.8 m, 1.2 m away, against its closed form; {} runs each",
                self.runs
            ));
        for (k, pattern) in Pattern::ALL.iter().enumerate() {
            chart = chart.line(method(*pattern, Measure::Area), &area[k]);
        }
        let at = |s: &Series| s.points.first().map_or((1.0, 1.0), |p| (p.parameter, mid(p)));
        let (x0, y0) = at(&area[2]);
        let (x, y) = last(&area[3]);
        let chart = chart
            .line(Method::new("sobol, solid angle").styled(5), &solid[3])
            .guide(Guide::slope_through(-0.5, x0, 1.25 * y0, "−½"))
            .guide(Guide::slope_through(-1.0, last(&area[1]).0, 1.6 * last(&area[1]).1, "−1"))
            .guide(Guide::slope_through(-1.5, x, 0.6 * y, "−3/2"));
        Figure::from(chart).caption(
            "Relative error of the irradiance of one place over the number of points on a rectangular light, nothing between. Smooth integrands reward order: \
             one point in each of N cells errs as 1/N, scrambled Sobol’ points nearly as N^(−3/2), independent points as N^(−1/2).")
    }

    /// Error at the largest N and slope, for each light, measure and pattern.
    pub fn table(&self) -> Table {
        let mut head = vec!["light, points even by"];
        head.extend(Pattern::ALL.iter().map(|p| p.name()));
        let last = self.series[0].1[0][0].points.last().map_or(0.0, |p| p.parameter);
        let mut table = Table::new(&head).subtitle(&format!(
            "relative RMSE of the irradiance at {last} points, in brackets the slope over N; {} runs; truth: closed forms", self.runs
        ));
        let mut gain: f64 = 0.0;
        for (l, (name, by_measure)) in self.series.iter().enumerate() {
            for (m, series) in by_measure.iter().enumerate() {
                let cell = |p: usize| {
                    let error = series[p].points.last().map_or(f64::NAN, mid);
                    // Rounding has no slope.
                    let slope =
                        if error < 1.0e-12 { "–".into() } else { signed(self.slope(l, m, p).value) };
                    format!("{} ({slope})", short(error))
                };
                let cells: Vec<String> = (0..5).map(cell).collect();
                let mut row = vec![format!("{name}, {}", MEASURES[m].1)];
                row.extend(cells);
                table = table.row(&row.iter().map(String::as_str).collect::<Vec<_>>());
            }
            let at = |m: usize| by_measure[m][3].points.last().map_or(f64::NAN, mid);
            gain = gain.max(at(0) / at(1));
        }
        table.title(&format!(
            "Half a sphere looks away: points on what is seen of it err up to {gain:.0} times less"
        ))
    }
}

pub fn mid(p: &Point) -> f64 {
    p.error.map_or(f64::NAN, |e| e.mid)
}

pub fn signed(x: f64) -> String {
    format!("{x:.2}").replace('-', "−")
}

/// A pattern's look in every chart of the lesson; Sobol's points by area are the default of our own flat lights.
pub fn method(pattern: Pattern, measure: Measure) -> Method {
    let k = Pattern::ALL.iter().position(|p| *p == pattern).unwrap_or(0);
    match (pattern, measure) {
        (Pattern::Sobol, Measure::Area) => Method::default_of("sobol").styled(k),
        (Pattern::Jittered, Measure::Area) => Method::new("jittered").styled(1),
        (Pattern::Centres, Measure::Area) => Method::new("fixed grid").styled(0),
        (_, Measure::Area) => Method::new(pattern.name()).styled(k),
        _ => Method::new(&format!("{}, solid angle", pattern.name())),
    }
}

/// Fold against square root: a triangular light under both maps [A ill. 45].
pub struct Fold {
    pub series: Vec<(Method, Series)>,
}

impl Fold {
    pub fn measured(budgets: &[u32], runs: u32, seed: u64) -> Result<Self> {
        use lightbench::sample::{uniform_triangle, uniform_triangle_fold};
        let (_, emitter) = lights()?[1];
        let Emitter::Triangle(triangle) = emitter else { return Err(other("a triangle")) };
        let ([a, b, c], place) = (triangle.corners(), Place::ORIGIN);
        let truth = place.truth(&emitter);
        let of = |pattern: Pattern, map: fn(glam::DVec2) -> DVec3| {
            let one = |n: u32, seed| {
                let at = |u| {
                    let w = map(u);
                    place.by_area(a * w.x + b * w.y + c * w.z, triangle.normal())
                };
                emitter.area() * pattern.points(n, seed).iter().map(at).sum::<f64>() / f64::from(n)
            };
            sweep(budgets, runs, seed, truth, one)
        };
        let series = vec![
            (Method::as_printed("fold, jittered"), of(Pattern::Jittered, uniform_triangle_fold)),
            (Method::default_of("square root, jittered").styled(1), of(Pattern::Jittered, uniform_triangle)),
            (Method::new("fold, sobol").styled(4), of(Pattern::Sobol, uniform_triangle_fold)),
            (Method::new("square root, sobol").styled(3), of(Pattern::Sobol, uniform_triangle)),
            (Method::new("either, random").styled(2), of(Pattern::Random, uniform_triangle)),
        ];
        Ok(Fold { series })
    }

    /// Errors of the fold over those of the square root at the largest N: jittered and Sobol'.
    pub fn ratios(&self) -> [f64; 2] {
        let at = |k: usize| self.series[k].1.points.last().map_or(f64::NAN, mid);
        [at(0) / at(1), at(2) / at(3)]
    }

    pub fn chart(&self) -> Figure {
        let [jittered, sobol] = self.ratios();
        let last = self.series[0].1.points.last().map_or(0.0, |p| p.parameter);
        let mut chart = Chart::error_over(Axis::log("points N"), "error of irradiance, relative RMSE")
            .title(&format!(
                "The fold tears neighbours apart: at {last} points it errs {jittered:.1} times as much jittered, {sobol:.0} times by Sobol’s points"
            ))
            .subtitle("a triangular light, nothing in the way, against its closed form; A’s map and Turk’s");
        for (method, series) in &self.series {
            chart = chart.line(method.clone(), series);
        }
        let at = |k: usize| self.series[k].1.points.first().map_or((1.0, 1.0), |p| (p.parameter, mid(p)));
        let (x, y) = at(4);
        Figure::from(chart.guide(Guide::slope_through(-0.5, x, 1.3 * y, "−½"))).caption(
            "Two uniform maps from the square to a triangle. Both are right for independent points. The fold (A, ill. 45) lays half of the square on the other: two cells \
             share each piece of the triangle, and what was smooth jumps across the diagonal, so that evenly spread points lose most of what they gain.")
    }
}
