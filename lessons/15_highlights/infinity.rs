//! Light and viewer taken as endlessly far: L, V and H are constant [C §1.8.3 C].

use glam::DVec3;
use lightbench::bsdf::highlight::{Match, power};
use lightbench::measure::{Method, Point, Series, Slope, Spread, log_slope, log_spaced, time_each};
use lightbench::num::counted::{Counted, count};
use lightbench::num::real::{Triple, dot};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};

const N: f64 = 50.0;

/// A unit ball with light and viewer at distance `d` from its middle.
#[derive(Clone, Copy)]
struct Stage {
    light: DVec3,
    viewer: DVec3,
    to_light: DVec3,
    to_viewer: DVec3,
    h: DVec3,
}

impl Stage {
    fn new(light: f64, viewer: f64) -> Stage {
        let to_light = DVec3::new(0.62, 0.55, 0.56).normalize();
        let to_viewer = DVec3::new(-0.25, 0.2, 0.95).normalize();
        let h = (to_light + to_viewer).normalize();
        Stage { light: to_light * light, viewer: to_viewer * viewer, to_light, to_viewer, h }
    }
    #[inline]
    fn near(&self, n: DVec3) -> (DVec3, DVec3) {
        ((self.light - n).normalize(), (self.viewer - n).normalize())
    }
}

#[inline]
fn phong(n: DVec3, l: DVec3, v: DVec3) -> f64 {
    let r = n * (2.0 * n.dot(l)) - l;
    power(0.5 * (r - v).length_squared(), N)
}

#[inline]
fn blinn(n: DVec3, h: DVec3, m: f64) -> f64 {
    power(0.5 * (n - h).length_squared(), m)
}

/// Places of the ball that the far light reaches and the far viewer sees; on a unit ball at 0 they are their normals.
fn places(count: u32, seed: u64) -> Vec<DVec3> {
    let s = Stage::new(1.0, 1.0);
    let all = (0..count).map(|i| uniform_sphere(Sampler::new(seed, 7, i).next_2d()));
    all.filter(|n| n.dot(s.to_light) > 0.3 && n.dot(s.to_viewer) > 0.3).collect()
}

/// Root mean square of the difference, in units of the true highlight.
fn relative(places: &[DVec3], found: impl Fn(DVec3) -> f64, truth: impl Fn(DVec3) -> f64) -> Spread {
    let errors: Vec<f64> = places.iter().map(|n| found(*n) - truth(*n)).collect();
    let truths: Vec<f64> = places.iter().map(|n| truth(*n)).collect();
    let scale = Spread::rms(&truths).map_or(f64::NAN, |s| s.mid);
    Spread::rms(&errors).map_or(Spread::exact(f64::NAN), |e| e.times(1.0 / scale))
}

pub struct Contest {
    /// Each assumption's error over the distance.
    pub lines: Vec<(Method, Series)>,
    /// Each formula's time, with the errors of the constant ones at some distances.
    pub times: Vec<(Method, Series)>,
}

pub fn contest(count: u32, points: usize, seed: u64) -> Contest {
    let (places, m) = (places(count, seed), Match::LeastSquares.exponent(N));
    let far = 1.0e12; // where the light of the half that is near stands, if the other is not
    let distances = log_spaced(3.0, 3.0e5, points);
    let over =
        |f: &dyn Fn(f64) -> Spread| Series::over(&distances, |d| Point { error: Some(f(d)), ..Point::at(d) });
    let exact = |s: Stage| {
        move |n: DVec3| {
            let (l, v) = s.near(n);
            blinn(n, (l + v).normalize(), m)
        }
    };
    let constant_h = |s: Stage| move |n: DVec3| blinn(n, s.h, m);
    let constant_r = |s: Stage| move |n: DVec3| phong(n, s.to_light, s.to_viewer);
    let exact_r = |s: Stage| {
        move |n: DVec3| {
            let (l, v) = s.near(n);
            phong(n, l, v)
        }
    };
    let both = over(&|d| relative(&places, constant_h(Stage::new(d, d)), exact(Stage::new(d, d))));
    let phongs = over(&|d| relative(&places, constant_r(Stage::new(d, d)), exact_r(Stage::new(d, d))));
    let lines = vec![
        (Method::new("H constant, both at d").styled(1), both.clone()),
        (
            Method::new("H constant, only the light at d").styled(2),
            over(&|d| relative(&places, constant_h(Stage::new(d, far)), exact(Stage::new(d, far)))),
        ),
        (
            Method::new("H constant, only the viewer at d").styled(3),
            over(&|d| relative(&places, constant_h(Stage::new(far, d)), exact(Stage::new(far, d)))),
        ),
        (Method::new("L and V constant in R·V, both at d").styled(4), phongs.clone()),
    ];
    let s = std::hint::black_box(Stage::new(10.0, 10.0));
    let time = |f: &dyn Fn() -> f64| time_each(places.len(), f);
    let zero = |time: Spread| Series::new(vec![Point::at(0.0).erred(Spread::exact(0.0)).timed(time)]);
    let ladder = |series: &Series, time: Spread| {
        // One measurement for the whole ladder: its spread is drawn once.
        let last = series.points.len().saturating_sub(1) / 2 * 2;
        let of = |i: usize| if i == last { time } else { Spread::exact(time.mid) };
        Series::new(
            series.points.iter().enumerate().step_by(2).map(|(i, p)| p.clone().timed(of(i))).collect(),
        )
    };
    let times = vec![
        (
            Method::new("H at every place").styled(0),
            zero(time(&|| places.iter().map(|n| exact(s)(*n)).sum())),
        ),
        (
            Method::new("R at every place").styled(5),
            zero(time(&|| places.iter().map(|n| exact_r(s)(*n)).sum())),
        ),
        (
            Method::new("H constant").styled(1),
            ladder(&both, time(&|| places.iter().map(|n| constant_h(s)(*n)).sum())),
        ),
        (
            Method::new("R, with L and V constant").styled(4),
            ladder(&phongs, time(&|| places.iter().map(|n| constant_r(s)(*n)).sum())),
        ),
    ];
    Contest { lines, times }
}

impl Contest {
    pub fn slope(&self) -> Slope {
        let tail =
            |s: &Series| Series::new(s.points.iter().filter(|p| p.parameter >= 30.0).cloned().collect());
        log_slope(&tail(&self.lines[0].1), 1)
    }
    /// Error of the constant half vector at about a distance.
    pub fn at(&self, distance: f64) -> (f64, f64) {
        let gap = |p: &&Point| (p.parameter / distance).ln().abs();
        let nearest = self.lines[0].1.points.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)));
        nearest.map_or((f64::NAN, f64::NAN), |p| (p.parameter, p.error.map_or(f64::NAN, |e| e.mid)))
    }
    fn ns(&self, k: usize) -> f64 {
        self.times[k].1.points[0].time.map_or(f64::NAN, |t| t.mid * 1.0e9)
    }

    pub fn error(&self) -> Figure {
        let (d, e) = self.at(30.0);
        let mut chart = Chart::error_over(Axis::log("distance d, in radii of the ball"), "error of the highlight, relative (root mean square)")
            .title(&format!(
                "A constant H errs as 1/d: {:.0} % with light and viewer {:.0} radii away; a hundredth takes {} radii",
                100.0 * e,
                d,
                short(d * e / 0.01)
            ))
            .subtitle("a ball of radius 1, n = 50 (half vector: least squares); truth: the same formula with L and V from each place")
            .guide(Guide::slope_through(-1.0, 3.0e3, 0.3 * e * d / 3.0e3, "slope −1"));
        for (method, series) in &self.lines {
            chart = chart.line(method.clone(), series);
        }
        Figure::from(chart).caption(
            "The price of light and viewer at infinity, C §1.8.3 C. The directions err by 1/d, and the highlight stands that far from its place: the sharper it \
             is, the more that counts. With light and viewer on the same side both errors are alike, and here partly cancel.",
        )
    }

    pub fn speed(&self) -> Figure {
        let mut chart = Chart::speed_accuracy("error of the highlight, relative (root mean square)")
            .x(Axis::time("time per highlight"))
            .title(&format!(
                "A constant H takes {:.0} of {:.0} ns; but R at every place takes only {:.0} ns, and with constant L and V {:.0} ns",
                self.ns(2),
                self.ns(0),
                self.ns(1),
                self.ns(3)
            ))
            .subtitle("marks from top to bottom: light and viewer farther and farther, 3 to 300 000 radii; n = 50, the power included");
        for (method, series) in &self.times {
            chart = chart.line(method.clone(), series);
        }
        Figure::from(chart).caption(
            "Time saved against error. The two exact formulas stand on the strip below. What the constant vectors save are three roots and their quotients a \
             place; the power, which all pay, is the rest.",
        )
    }

    /// Operations before the power: C says that H costs less than R.
    pub fn work(&self) -> Figure {
        let [n, l, v] = [[0.0, 0.6, 0.8], [0.48, 0.6, 0.64], [0.8, 0.0, 0.6]].map(|t| t.map(Counted));
        let r_way = |normalised: bool| {
            count(|| {
                let (l, v) = if normalised { (unit(l), unit(v)) } else { (l, v) };
                let k = dot(n, l);
                let k = k + k;
                dot([0, 1, 2].map(|i| k * n[i] - l[i]), v)
            })
            .0
        };
        let h_way = |normalised: bool| {
            count(|| {
                let (l, v) = if normalised { (unit(l), unit(v)) } else { (l, v) };
                dot(n, unit([0, 1, 2].map(|i| l[i] + v[i])))
            })
            .0
        };
        let rows = [
            ("R·V, L and V from the place", r_way(true)),
            ("N·H, L and V from the place", h_way(true)),
            ("R·V, L and V constant", r_way(false)),
            ("N·H, L and V constant, H from them", h_way(false)),
            ("N·H, H constant", count(|| dot(n, v)).0),
        ];
        let mut table =
            Table::new(&["Cosine of the highlight", "sums", "products", "quotients", "roots", "all"]);
        for (name, w) in &rows {
            let cells = [w.sums, w.products, w.quotients, w.roots, w.total()].map(|x| x.to_string());
            let cells: Vec<&str> = std::iter::once(*name).chain(cells.iter().map(String::as_str)).collect();
            table = table.row(&cells);
        }
        let table = table
            .title(&format!(
                "H from given L and V takes {} operations, with a root and three quotients; R takes {}, with neither",
                rows[3].1.total(),
                rows[2].1.total()
            ))
            .subtitle("operations up to the cosine, counted by running the formulas");
        Figure::from(table).caption(
            "C calls H (26) cheaper than R (25). Only a constant H is: computed at a place it costs as many operations, some of them slow ones.",
        )
    }
}

fn unit(a: Triple<Counted>) -> Triple<Counted> {
    use lightbench::num::real::Real;
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}
