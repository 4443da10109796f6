//! Ways to raise a cosine: time, error, counted work; and where each loses its digits.

use super::off_plane::filled;
use glam::DVec3;
use lightbench::bsdf::highlight::{lyon_power, power, schlick_power};
use lightbench::frame::basis;
use lightbench::measure::{Method, Point, Series, Spread, log_spaced, time_each};
use lightbench::num::U;
use lightbench::num::counted::{Counted, count};
use lightbench::num::real::dot;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, short};
use std::f64::consts::TAU;
use std::hint::black_box;

/// A mirror direction, a viewer, and the power by the angle between them.
pub struct Pair {
    r: DVec3,
    v: DVec3,
    truth: f64,
}

impl Pair {
    fn new(s: &mut Sampler, angle: f64, n: f64) -> Pair {
        let r = uniform_sphere(s.next_2d());
        let (x, y) = basis(r);
        let (sin, cos) = (TAU * s.next_1d()).sin_cos();
        let v = (r * angle.cos() + (x * cos + y * sin) * angle.sin()).normalize();
        let half = (0.5 * angle).sin();
        Pair { r, v, truth: power(2.0 * half * half, n) }
    }
    #[inline]
    fn cos(&self) -> f64 {
        self.r.dot(self.v).max(0.0)
    }
    #[inline]
    fn versine(&self) -> f64 {
        0.5 * (self.r - self.v).length_squared()
    }
    fn versine_single(&self) -> f32 {
        0.5 * (self.r.as_vec3() - self.v.as_vec3()).length_squared()
    }
    fn cos_single(&self) -> f32 {
        self.r.as_vec3().dot(self.v.as_vec3()).max(0.0)
    }
}

/// Pairs as the lobe itself spreads them.
fn pairs(n: f64, count: u32, seed: u64) -> Vec<Pair> {
    let pair = |i: u32| {
        let mut s = Sampler::new(seed, n.to_bits(), i);
        let versine = -((-s.next_1d()).ln_1p() / (n + 1.0)).exp_m1();
        Pair::new(&mut s, 2.0 * (0.5 * versine).sqrt().asin(), n)
    };
    (0..count).map(pair).collect()
}

/// Error of a formula: root mean square over the pairs, where the peak is 1.
fn error(pairs: &[Pair], f: &impl Fn(&Pair) -> f64) -> Option<Spread> {
    Spread::rms(&pairs.iter().map(|p| f(p) - p.truth).collect::<Vec<_>>())
}

/// Operations from the two vectors on: of the feature, of the power, and elementary functions, one each.
fn work(from_cosine: bool, power: impl FnOnce(Counted) -> Counted, elementary: u64) -> f64 {
    let (a, b) = ([0.6, 0.48, 0.64].map(Counted), [0.48, 0.6, 0.64].map(Counted));
    let feature = || {
        if from_cosine {
            return dot(a, b);
        }
        let d = [0, 1, 2].map(|i| a[i] - b[i]);
        Counted(0.5) * dot(d, d)
    };
    let operations = count(feature).0.total() + count(|| power(Counted(0.01))).0.total();
    (operations + elementary) as f64
}

fn squared(x: Counted, mut n: u32) -> Counted {
    let (mut base, mut product) = (x, Counted(1.0));
    while n > 0 {
        if n & 1 == 1 {
            product = product * base;
        }
        base = base * base;
        n >>= 1;
    }
    product
}

/// All ways at one exponent, timed.
pub fn contest(n: u32, count: u32, seed: u64) -> Vec<(Method, Series)> {
    let pairs = pairs(f64::from(n), count, seed);
    let (whole, real) = (n as i32, f64::from(n));
    let one =
        |name: &str, style, f: &dyn Fn() -> Point| (Method::new(name).styled(style), Series::new(vec![f()]));
    let cosine = |elementary| move || work(true, |x| x, elementary);
    let mut all = vec![
        one("powf", 1, &|| timed(&pairs, |p| p.cos().powf(black_box(real)), cosine(1)())),
        one("exp(n ln cos)", 5, &|| {
            timed(&pairs, |p| (black_box(real) * p.cos().ln()).exp(), cosine(2)() + 1.0)
        }),
        one("repeated squaring", 2, &|| {
            timed(&pairs, |p| p.cos().powi(black_box(whole)), work(true, |x| squared(x, n), 0))
        }),
        one("Schlick's quotient", 4, &|| {
            let of = |x| schlick_power(x, Counted(real));
            timed(&pairs, |p| schlick_power(p.versine(), black_box(real)), work(false, of, 0))
        }),
    ];
    let lyon = [1, 2, 3, 4, 5].map(|k| {
        let of = |x| lyon_power(x, Counted(real), k);
        let point = timed(&pairs, |p| lyon_power(p.versine(), black_box(real), k), work(false, of, 0));
        Point { parameter: f64::from(1u32 << k), ..point }
    });
    all.push((Method::new("Lyon, 2 … 32 factors").styled(3), Series::new(lyon.into())));
    let ours = timed(&pairs, |p| power(p.versine(), black_box(real)), work(false, |x| x, 2) + 1.0);
    all.insert(0, (Method::default_of("from 1 − cos φ").styled(0), Series::new(vec![ours])));
    all
}

fn timed(pairs: &[Pair], f: impl Fn(&Pair) -> f64, work: f64) -> Point {
    let time = time_each(pairs.len(), || pairs.iter().map(&f).sum::<f64>());
    Point { error: error(pairs, &f), work: Some(work), ..Point::at(1.0) }.timed(time)
}

pub fn speed(contest: &[(Method, Series)], n: u32) -> Figure {
    let point = |k: usize| &contest[k].1.points[0];
    let ns = |k: usize| point(k).time.map_or(f64::NAN, |t| t.mid * 1.0e9);
    let err = |k: usize| point(k).error.map_or(f64::NAN, |e| e.mid);
    let mut chart = Chart::speed_accuracy("error of the highlight, peak 1 (root mean square)")
        .x(Axis::time("time per highlight, from two unit vectors"))
        .y(Axis::log("error of the highlight, peak 1 (root mean square)").range(1.0e-17, 1.0))
        .title(&format!(
            "Squaring takes {:.1} ns where powf takes {:.1} ns, and is as exact; Schlick's {:.1} ns cost {:.0} % of the peak",
            ns(3),
            ns(1),
            ns(4),
            100.0 * err(4)
        ))
        .subtitle(&format!("n = {n}; viewers spread as the lobe spreads light; truth from the angle; median of nine runs"))
        .guide(Guide::level(U, "u, half an ulp of 1"))
        .guide(Guide::level(1.0 / 510.0, "half a level of 255"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Speed against accuracy of one highlight. The library's form goes through 1 − cos φ from the difference of the vectors; Lyon's product starts \
         there too and buys a bit for each squaring; Schlick's quotient has the right peak and too long a tail. Counted operations are in the CSV, an \
         elementary function as one.",
    )
}

/// Errors over the exponent.
pub fn over_exponents(count: u32, points: usize, seed: u64) -> Vec<(Method, Series)> {
    let ns: Vec<f64> = log_spaced(1.0, 1.0e7, points).into_iter().map(f64::round).collect();
    let line = |method: Method, f: &dyn Fn(&Pair, f64) -> f64| {
        let at = |n: f64| {
            let pairs = pairs(n, count, seed);
            Point { error: error(&pairs, &|p: &Pair| f(p, n)), ..Point::at(n) }
        };
        (method, Series::over(&ns, at))
    };
    vec![
        line(Method::default_of("from 1 − cos φ").styled(0), &|p, n| power(p.versine(), n)),
        line(Method::new("powf").styled(1), &|p, n| p.cos().powf(n)),
        line(Method::new("powf, f32").styled(5), &|p, n| f64::from(p.cos_single().powf(n as f32))),
        line(Method::new("repeated squaring").styled(2), &|p, n| p.cos().powi(n as i32)),
        line(Method::new("Schlick's quotient").styled(4), &|p, n| schlick_power(p.versine(), n)),
        line(Method::new("Lyon, 16 factors").styled(3), &|p, n| lyon_power(p.versine(), n, 4)),
    ]
}

pub fn exponents(lines: &[(Method, Series)]) -> Figure {
    let last = |k: usize| lines[k].1.points.last().and_then(|p| p.error).map_or(f64::NAN, |e| e.mid);
    let mut chart = Chart::error_over(
        Axis::log("exponent n"),
        "error of the highlight, peak 1 (root mean square)",
    )
    .title(&format!(
        "By n = 10⁷ the cosine has lost the highlight in f32 (error {}), {} in f64; from 1 − cos φ {}",
        short(last(2)),
        short(last(1)),
        short(last(0))
    ))
    .subtitle(
        &format!("viewers spread as the lobe spreads light; Schlick's quotient settles at {:.2} of the peak, Lyon's product at {:.3}", last(4), last(5)),
    )
    .guide(Guide::slope_through(1.0, 1.0, U, "n u"))
    .guide(Guide::slope_through(0.5, 1.0, U, "√n u: the vectors' own rounding"));
    for (method, series) in lines {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Error over the exponent. A cosine near 1 has no digits left for the angle, and n multiplies what is missing, in powf and in repeated squaring \
         alike. The difference of the two vectors keeps them.",
    )
}

/// A way as a map: name of the figure, title's subject, error in one place.
type Charted = (&'static str, &'static str, fn(&Pair, f64) -> f64);

/// Error over angle and exponent, the worst of eight places a cell.
pub fn maps(columns: usize, seed: u64) -> Vec<(&'static str, Figure, f64)> {
    let ways: [Charted; 3] = [
        ("stability_cosine", "Powf of a cosine in f32", |p, n| f64::from(p.cos_single().powf(n as f32))),
        ("stability_versine", "1 − cos φ from the difference, in f32", |p, n| {
            f64::from((n as f32 * (-p.versine_single()).ln_1p()).exp())
        }),
        ("stability_schlick", "Schlick's quotient, in f64", |p, n| schlick_power(p.versine(), n)),
    ];
    let map = |(name, subject, f): Charted| {
        let axes = [
            Axis::log("angle φ between V and R, rad").range(1.0e-6, 1.0),
            Axis::log("exponent n").range(1.0, 1.0e8),
        ];
        let (map, _) = filled(axes, "error, peak 1", (columns, columns * 3 / 4), |angle, n| {
            let one = |i: u32| {
                let p = Pair::new(&mut Sampler::new(seed, angle.to_bits() ^ n.to_bits(), i), angle, n);
                (f(&p, n) - p.truth).abs()
            };
            (0..8).map(one).fold(1.0e-12, f64::max)
        });
        let map = map.range(1.0e-12, 1.0).failing_above(0.01, "over 1 % of the peak");
        let share = map.failing_share();
        let place =
            if share > 0.0 { format!("on {:.1} % of the map", 100.0 * share) } else { "nowhere".into() };
        let title = format!("{subject}: wrong by over 1 % of the peak {place}");
        let map = map
            .title(&title)
            .subtitle("largest error of eight pairs of unit vectors a cell; truth from the angle");
        let caption = "Where a way to raise the cosine fails. The edge of the highlight runs along n φ² = 2. In single precision the cosine is a step of \
             6·10⁻⁸: from n ≈ 10⁵ on, the size of the sun's image, it shows; the difference of the vectors keeps its digits. Schlick's quotient fails along \
             the flank whatever the precision.";
        (name, Figure::from(map).caption(caption), share)
    };
    ways.into_iter().map(map).collect()
}
