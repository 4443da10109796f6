//! The contestants, and how often each is wrong.

use super::bodies::{Body, Lamp, Start, Truth, VECTORISED, bodies, certain, lamps};
use glam::DVec3;
use lightbench::measure::Method;
use lightbench::ray::Ray;
use lightbench::ray::leaving::{Departure, Leaving};
use lightbench::sample::Sampler;
use lightbench::shape::fan::{Ends, Fan, Vectors};
use lightbench_kit::lesson::{LessonError, Result};
use rayon::prelude::*;

/// A rule for rays that leave a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    Leave(Leaving),
    /// Ahead by a share of the object's size [C §1.6.3].
    AheadBySize(f64),
    /// The object is not tested at all [A §5.4.7]: **wrong** wherever it stands in its own light.
    NaiveSkip,
}

/// A contestant.
#[derive(Clone)]
pub struct Way {
    pub method: Method,
    pub rule: Rule,
}

/// The contestants, the default first.
pub fn ways() -> Vec<Way> {
    let way = |method: Method, style: usize, rule| Way { method: method.styled(style), rule };
    let leave = Rule::Leave;
    vec![
        way(Method::default_of("error bound"), 0, leave(Leaving::ErrorBound)),
        way(Method::new("pbrt, rounded away"), 1, leave(Leaving::RoundedAway)),
        way(Method::new("256 last places"), 2, leave(Leaving::Integer)),
        way(Method::new("C: 10⁻⁶ sizes ahead"), 3, Rule::AheadBySize(1.0e-6)),
        way(Method::new("A: 10⁻⁶ m ahead"), 6, leave(Leaving::Ahead(1.0e-6))),
        way(Method::new("B: 10⁻⁴ m along n"), 4, leave(Leaving::AlongNormal(1.0e-4))),
        way(Method::new("D: 10⁻⁴ m back"), 5, leave(Leaving::Back(1.0e-4))),
        way(Method::new("A: 0.01 m ahead"), 7, leave(Leaving::Ahead(0.01))),
        way(Method::new("A: object skipped"), 8, Rule::NaiveSkip),
        way(Method::new("no remedy"), 9, leave(Leaving::OnTheSpot)),
    ]
}

/// Wrong answers, and questions asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Lights above the tangent plane that a shadow was found for.
    pub false_shadows: u64,
    /// Lights below it that shone through the body.
    pub leaks: u64,
    /// Shadow rays, half of either kind.
    pub shadow_rays: u64,
    /// Rays into the body that met its surface again at once, or not at all.
    pub lost: u64,
    pub inward_rays: u64,
    /// Shape tests of the shadow rays.
    pub tests: u64,
}

impl Score {
    fn plus(self, other: Score) -> Score {
        Score {
            false_shadows: self.false_shadows + other.false_shadows,
            leaks: self.leaks + other.leaks,
            shadow_rays: self.shadow_rays + other.shadow_rays,
            lost: self.lost + other.lost,
            inward_rays: self.inward_rays + other.inward_rays,
            tests: self.tests + other.tests,
        }
    }

    /// Of several cells together.
    pub fn sum(cells: &[Score]) -> Score {
        cells.iter().fold(Score::default(), |sum, cell| sum.plus(*cell))
    }

    /// Two experiments in the same cells together.
    pub fn both(one: &[Score], other: &[Score]) -> Vec<Score> {
        one.iter().zip(other).map(|(a, b)| a.plus(*b)).collect()
    }

    pub fn wrong(&self) -> u64 {
        self.false_shadows + self.leaks
    }

    /// Wrong shadow rays of all.
    pub fn share(&self) -> f64 {
        self.wrong() as f64 / self.shadow_rays.max(1) as f64
    }

    /// False shadows, of the lights above.
    pub fn shadows(&self) -> (u64, u64) {
        (self.false_shadows, self.shadow_rays / 2)
    }

    /// Leaks, of the lights below.
    pub fn lights_below(&self) -> (u64, u64) {
        (self.leaks, self.shadow_rays / 2)
    }

    /// Both.
    pub fn all(&self) -> (u64, u64) {
        (self.wrong(), self.shadow_rays)
    }
}

impl Rule {
    /// The ray from a start towards a light or into the body; `None` if the rule asks nothing.
    pub fn ray(self, body_size: f64, start: &Start, way: &Departure) -> Option<Ray> {
        let leaving = match self {
            Rule::Leave(leaving) => leaving,
            Rule::AheadBySize(share) => Leaving::Ahead(share * body_size),
            Rule::NaiveSkip => return None,
        };
        Some(Ray::new(leaving.origin(&start.hit, way), way.leaving))
    }

    fn asks(self, body: &Body, start: &Start, light: DVec3, truth: Truth, score: &mut Score) {
        let leaving = light - start.hit.point;
        let way = Departure { arriving: start.arriving, side: start.side, leaving };
        let segment = self.ray(body.size, start, &way).map(|r| Ray::new(r.origin, light - r.origin));
        score.shadow_rays += 1;
        score.tests += u64::from(segment.is_some());
        match (segment.is_some_and(|s| body.shape.blocks(&s, 1.0)), truth) {
            (true, Truth::Lit) => score.false_shadows += 1,
            (false, Truth::Dark) => score.leaks += 1,
            _ => {}
        }
    }

    /// A transmitted ray: from inside a closed surface it leaves an odd number of times, behind an open one never.
    fn goes_in(self, body: &Body, start: &Start, inward: DVec3, score: &mut Score) {
        let way = Departure { arriving: start.arriving, side: -start.side, leaving: inward };
        let mut crossings = Vec::new();
        if let Some(ray) = self.ray(body.size, start, &way) {
            body.shape.crossings(&ray, &mut crossings);
        }
        score.inward_rays += 1;
        score.lost += u64::from((crossings.len() % 2 == 1) != body.is_closed);
    }
}

/// How much is asked in one cell of the map.
#[derive(Clone, Copy)]
pub struct Budget {
    /// Places on each body.
    pub starts: usize,
    /// Shadow rays from each place.
    pub lights: usize,
}

/// The axes of the map.
pub struct Axes {
    /// Of the bodies [m].
    pub sizes: Vec<f64>,
    /// From the world's origin [sizes].
    pub distances: Vec<f64>,
}

impl Axes {
    /// What `cell` says of each size and distance: row by row, the nearest row first.
    pub fn cells<T: Send>(&self, cell: impl Fn(f64, f64) -> Result<T> + Sync) -> Result<Vec<T>> {
        let places = self.distances.iter().flat_map(|d| self.sizes.iter().map(move |s| (*s, *d)));
        places.collect::<Vec<_>>().into_par_iter().map(|(size, distance)| cell(size, distance)).collect()
    }
}

/// Lamps that all places of a cell share.
const LAMPS: u32 = 1 << 12;

/// One scene, scaled and moved: every cell asks the same of it.
struct Cell {
    bodies: Vec<Body>,
    lamps: Vec<Lamp>,
    size: f64,
    seed: u64,
}

impl Cell {
    fn new(seed: u64, size: f64, distance: f64) -> Result<Self> {
        let bodies = bodies(size, distance).map_err(|e| LessonError(e.to_string()))?;
        Ok(Cell { bodies, lamps: lamps(seed, LAMPS, |truth| certain(distance, truth)), size, seed })
    }

    /// Calls `ask` with every body, a start on it, and the next lamps; some rays miss, or find an edge: the next is taken.
    fn each<'a>(
        &'a self,
        starts: impl Fn(usize) -> usize,
        lights: usize,
        mut ask: impl FnMut(&Body, &Start, &mut dyn Iterator<Item = &'a Lamp>),
    ) {
        for (b, body) in self.bodies.iter().enumerate() {
            let mut lamps = self.lamps.iter().cycle();
            let found = (0u32..).filter_map(|i| body.start(&mut Sampler::new(self.seed, b as u64, i)));
            for start in found.take(starts(b)) {
                ask(body, &start, &mut lamps.by_ref().take(lights));
            }
        }
    }
}

/// The scores of rules in one cell.
pub fn contest(seed: u64, rules: &[Rule], size: f64, distance: f64, budget: Budget) -> Result<Vec<Score>> {
    let cell = Cell::new(seed, size, distance)?;
    let mut scores = vec![Score::default(); rules.len()];
    cell.each(
        |_| budget.starts,
        budget.lights,
        |body, start, lamps| {
            let (frame, mut inward) = (start.frame(), DVec3::ZERO);
            for lamp in lamps {
                let way = lamp.way(frame) * size;
                let light = start.hit.point + way;
                for (rule, score) in rules.iter().zip(&mut scores) {
                    rule.asks(body, start, light, lamp.truth, score);
                }
                inward = if lamp.truth == Truth::Dark { way } else { inward };
            }
            for (rule, score) in rules.iter().zip(&mut scores) {
                rule.goes_in(body, start, inward, score);
            }
        },
    );
    Ok(scores)
}

/// The default in one cell, as area lights ask: all rays of a place in one fan. Bodies that are tested eight rays at a time
/// get twelve times as many starts.
pub fn default_in_fans(seed: u64, size: f64, distance: f64, budget: Budget) -> Result<Score> {
    let cell = Cell::new(seed, size, distance)?;
    let (mut score, mut fan) = (Score::default(), Fan::new(Vectors::default()));
    let (mut truths, mut lit) = (Vec::new(), Vec::new());
    let starts = |b: usize| if b < VECTORISED { 12 * budget.starts } else { budget.starts };
    cell.each(starts, budget.lights, |body, start, lamps| {
        let frame = start.frame();
        truths.clear();
        let mut ends = Ends::within(start.hit.point, 500.0 * cell.size);
        ends.place(lamps.map(|lamp| {
            truths.push(lamp.truth);
            start.hit.point + lamp.way(frame) * cell.size
        }));
        fan.aim(start.hit.origin_towards(start.side), &ends);
        lit.clear();
        lit.resize(fan.padded_len(), 1.0);
        body.shape.shade(&fan, &mut lit);
        for (lit, truth) in lit.iter().zip(&truths) {
            score.false_shadows += u64::from(*truth == Truth::Lit && *lit == 0.0);
            score.leaks += u64::from(*truth == Truth::Dark && *lit != 0.0);
        }
        score.shadow_rays += fan.len() as u64;
        score.tests += fan.len() as u64;
    });
    Ok(score)
}
