//! The half shadow of a straight edge: the share of a square light that is seen is exact, whatever the edge's angle.
//!
//! Seen from a place of the half shadow the edge cuts the light along a line; as the place moves across, the line sweeps
//! over the light at an even pace. So a random place is a random line of its direction.

use super::place::{mid, seed_of, signed};
use glam::{DVec2, dvec2};
use lightbench::measure::{Method, Point, Series, Slope, Spread, log_slope};
use lightbench::sample::{Pattern, Sampler};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, short};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// D's own: 10 × 10 fixed points [D fig. 31].
pub const GRID: u32 = 100;
pub const FEW: u32 = 25;

/// A line across the unit square: the side `u·n < c` of it is seen.
#[derive(Clone, Copy)]
struct Edge {
    n: DVec2,
    c: f64,
}

impl Edge {
    /// At an angle to the light's sides, at the share `t` of the half shadow.
    fn at(angle: f64, t: f64) -> Self {
        let n = DVec2::from_angle(angle);
        let heights = [0.0, n.x, n.y, n.x + n.y];
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Edge { n, c: low + (high - low) * t }
    }

    /// Area of the part that is seen: a polygon.
    fn share(&self) -> f64 {
        let corners = [dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(1.0, 1.0), dvec2(0.0, 1.0)];
        let depth = |p: DVec2| self.c - p.dot(self.n);
        let mut kept: Vec<DVec2> = Vec::with_capacity(6);
        for k in 0..4 {
            let (a, b) = (corners[k], corners[(k + 1) % 4]);
            let (da, db) = (depth(a), depth(b));
            if da > 0.0 {
                kept.push(a);
            }
            if da * db < 0.0 {
                kept.push(a + (b - a) * (da / (da - db)));
            }
        }
        let cross = |k: usize| kept[k].perp_dot(kept[(k + 1) % kept.len()]);
        (0..kept.len()).map(cross).sum::<f64>() / 2.0
    }

    fn error(&self, pattern: Pattern, n: u32, seed: u64) -> f64 {
        let seen = pattern.points(n, seed).iter().filter(|u| u.dot(self.n) < self.c).count();
        seen as f64 / f64::from(n) - self.share()
    }
}

/// Which way the edge runs.
#[derive(Clone, Copy)]
pub enum Angle {
    Fixed(f64),
    /// Parallel to the width or to the height, in turn.
    Sides,
    Random,
}

/// RMS error of the share that is seen, over `places` of the half shadow.
pub fn rms(pattern: Pattern, n: u32, angle: Angle, places: u32, seed: u64) -> Spread {
    let errors: Vec<f64> = (0..places)
        .map(|run| {
            let mut random = Sampler::new(seed, 7, run);
            let u = random.next_2d();
            // Evenly spread over the half shadow, so that few places do.
            let t = (f64::from(run) + u.x) / f64::from(places);
            let turn = match angle {
                Angle::Fixed(angle) => angle,
                Angle::Sides => f64::from(run % 2) * FRAC_PI_2,
                Angle::Random => u.y * FRAC_PI_2,
            };
            Edge::at(turn, t).error(pattern, n, seed_of(seed, run))
        })
        .collect();
    Spread::rms(&errors).unwrap_or(Spread::exact(f64::NAN))
}

/// Correlation of the errors of neighbours on a way across the half shadow of an edge at 20°: 0 of noise, near 1 of bands.
fn neighbours(pattern: Pattern, places: u32, seed: u64) -> f64 {
    let edge = |k: u32| Edge::at(20f64.to_radians(), (f64::from(k) + 0.5) / f64::from(places));
    let errors: Vec<f64> = (0..places).map(|k| edge(k).error(pattern, FEW, seed_of(seed, k))).collect();
    let products: f64 = errors.windows(2).map(|w| w[0] * w[1]).sum();
    products / errors.iter().map(|e| e * e).sum::<f64>()
}

pub struct Penumbra {
    pub places: u32,
    /// By pattern, edges along the light's sides and at random angles.
    pub series: [Vec<Series>; 2],
    /// By pattern, error over the angle [degrees].
    over_angle: Vec<(Method, Vec<(f64, f64)>)>,
    /// How the errors of neighbours correlate, of 5 × 5 fixed points and of jittered ones.
    pub bands: [f64; 2],
}

/// Squares, so that the grid is one; 25, 36 and 100 among them.
const BUDGETS: [u32; 11] = [1, 4, 9, 16, 25, 36, 49, 100, 196, 400, 1024];

fn named(pattern: Pattern) -> Method {
    let k = Pattern::ALL.iter().position(|p| *p == pattern).unwrap_or(0);
    match pattern {
        Pattern::Centres => Method::new("fixed grid (D)").styled(0),
        Pattern::Sobol => Method::default_of("sobol").styled(k),
        Pattern::Jittered => Method::new("jittered").styled(1),
        _ => Method::new(pattern.name()).styled(k),
    }
}

impl Penumbra {
    pub fn measured(places: u32, steps: u32, seed: u64) -> Self {
        let sweep = |pattern, angle| {
            let point =
                |&n: &u32| Point::at(n.into()).worked(n.into()).erred(rms(pattern, n, angle, places, seed));
            Series::new(BUDGETS.iter().map(point).collect())
        };
        let series = [Angle::Sides, Angle::Random].map(|a| Pattern::ALL.map(|p| sweep(p, a)).into());
        let over = |pattern, n| -> Vec<(f64, f64)> {
            (0..=steps)
                .map(|k| f64::from(k) / f64::from(steps) * FRAC_PI_4)
                .map(|a| (a.to_degrees(), rms(pattern, n, Angle::Fixed(a), places / 2, seed).mid))
                .collect()
        };
        let few = |p: Pattern| (Method::new(&format!("{}, {FEW}", p.name())), over(p, FEW));
        let style = |(m, c): (Method, Vec<(f64, f64)>), k| (m.styled(k), c);
        let over_angle = vec![
            (Method::new("fixed grid, 10 × 10 (D)").styled(0), over(Pattern::Centres, GRID)),
            (Method::new("fixed grid, 5 × 5 (D)").styled(5), over(Pattern::Centres, FEW)),
            style(few(Pattern::Jittered), 1),
            style(few(Pattern::Random), 2),
            style(few(Pattern::Sobol), 3),
            style(few(Pattern::R2), 4),
        ];
        let bands = [Pattern::Centres, Pattern::Jittered].map(|p| neighbours(p, places, seed));
        Penumbra { places, series, over_angle, bands }
    }

    /// Error at `n` points of a pattern; `random` or parallel edges.
    pub fn at(&self, pattern: Pattern, n: u32, random: bool) -> f64 {
        let k = Pattern::ALL.iter().position(|p| *p == pattern).unwrap_or(0);
        let points = &self.series[usize::from(random)][k].points;
        points.iter().find(|p| p.parameter == f64::from(n)).map_or(f64::NAN, mid)
    }

    pub fn slope(&self, pattern: usize, random: bool) -> Slope {
        log_slope(&self.series[usize::from(random)][pattern], self.places)
    }

    /// The number the lesson is about.
    pub fn chart(&self, random: bool) -> Figure {
        let grid = self.at(Pattern::Centres, GRID, random);
        let few = |p| self.at(p, FEW, random) / grid;
        let ratios = [Pattern::Jittered, Pattern::Sobol, Pattern::R2].map(few);
        let title = if random {
            format!(
                "At random angles they do not: {FEW} points err {:.1} (jittered), {:.1} (sobol), {:.1} times (r2) as much as the 10 × 10 grid",
                ratios[0], ratios[1], ratios[2]
            )
        } else {
            format!(
                "Along the light’s sides {FEW} Sobol’ points err {:.2} times as much as a fixed 10 × 10 grid, jittered ones {:.2}, R₂’s {:.2}",
                ratios[1], ratios[0], ratios[2]
            )
        };
        let kind = if random { "edges at random angles" } else { "edges parallel to the light’s sides" };
        let mut chart = Chart::work_accuracy("shadow rays N", "error of the share that is seen, RMSE")
            .title(&title)
            .subtitle(&format!(
                "{kind}; {} places across the half shadow; the truth is a polygon’s area",
                self.places
            ));
        for (k, pattern) in Pattern::ALL.iter().enumerate() {
            chart = chart.line(named(*pattern), &self.series[usize::from(random)][k]);
        }
        let first = &self.series[usize::from(random)][2].points;
        let (start, end) = (&first[0], BUDGETS[BUDGETS.len() - 1]);
        let low = self.at(Pattern::Sobol, end, random);
        let three = if random { 0.62 * low } else { 1.45 * self.at(Pattern::Jittered, end, false) };
        chart = chart
            .guide(Guide::level(grid, "the 10 × 10 grid"))
            .guide(Guide::upright(FEW.into(), "25"))
            .guide(Guide::slope_through(-0.5, 1.0, 1.35 * mid(start), "−½"))
            .guide(Guide::slope_through(-0.75, end.into(), three, "−¾"));
        if !random {
            chart = chart.guide(Guide::slope_through(-1.0, end.into(), 0.62 * low, "−1"));
        }
        Figure::from(chart).caption(if random {
            "Error of the half shadow over the number of rays, edges at random angles. The fixed grid gains most: its rows and columns no longer change sides together. All plans but chance \
             follow N^(−3/4): an edge crosses some √N of the N cells, and each errs by itself. 25 points of any kind do not reach 100. But a grid's errors are those of the neighbour too: an eye sees bands."
        } else {
            "Error of the half shadow over the number of rays, edge parallel to the light’s sides. A whole column of the grid appears at once: its n × n rays are worth n, and err as N^(−1/2), \
             as chance does. Jittered points err as N^(−3/4): 36 of them match the grid. Sobol’s points stand at evenly spread places across, and err as 1/N. R₂ has numbers at which its places pair up; 25 is one."
        })
    }

    pub fn angles(&self) -> Figure {
        let grid = &self.over_angle[0].1;
        let (first, last) = (grid[0].1, grid[grid.len() - 1].1);
        let best = grid.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
        let mut chart = Chart::new(
            Axis::linear("angle between the blocker’s edge and the light’s side, degrees").range(0.0, 45.0).every(15.0),
            Axis::log("error of the share that is seen, RMSE"),
        )
        .title(&format!(
            "The fixed grid pays at simple angles: {} along a side, {} along the diagonal, {} where it is best", short(first), short(last), short(best)
        ))
        .subtitle(&format!("{} places across the half shadow at each angle; truth: area of a polygon", self.places / 2));
        for (method, points) in &self.over_angle {
            chart = chart.function(method.clone(), points);
        }
        Figure::from(chart).caption(
            "Error of the half shadow over the direction of the blocker’s edge. Where the edge runs along rows of the grid, 0°, 45° and lesser ratios, whole rows change sides at once: \
             the shadow is stepped. Random points do not mind the angle; low-discrepancy points do, but less.")
    }

    /// Slopes of random, jittered and Sobol' points along the sides.
    pub fn slopes_text(&self) -> String {
        [2, 1, 3].map(|k| signed(self.slope(k, false).value)).join(", ")
    }
}
