//! Ways to ask whether a shadow ray is free, and what they cost.

use glam::DVec2;
use lightbench::measure::Spread;
use lightbench::ray::{Ray, Silent, Tally, Trace, Work};
use lightbench::render::Picture;
use lightbench::scene::Scene;
use std::time::Instant;

/// Side of the squares that a picture is rendered in [pixels].
pub const TILE: usize = 16;

/// A question: is the way to light number `light` free?
#[derive(Clone, Copy)]
pub struct Question {
    pub light: usize,
    pub segment: Ray,
    pub t_max: f64,
}

/// What is done to answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The nearest hit, and whether it lies before the light: one function for all rays [B §7.4].
    Nearest,
    /// The first blocker that is found.
    First,
    /// The object that hid this light from the place before; forgotten as soon as the light is seen.
    UntilLit,
    /// The same, never forgotten.
    ForGood,
}

/// Where blockers are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Among {
    /// One object after the other.
    List,
    /// A hierarchy, where the scene has one.
    Hierarchy,
}

/// The shadow rays of one tile, in the order of its pixels. Memory begins anew with each tile, as it does in pictures.
pub type Tile = Vec<Question>;

/// Every shadow ray of a picture, one sample a pixel.
pub fn questions(scene: &Scene, picture: Picture) -> Vec<Tile> {
    let mut tiles = Vec::new();
    for top in (0..picture.height).step_by(TILE) {
        for left in (0..picture.width).step_by(TILE) {
            let mut all = Vec::new();
            for y in top..(top + TILE).min(picture.height) {
                for x in left..(left + TILE).min(picture.width) {
                    let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                    ask(scene, &scene.camera.ray(at, picture.width, picture.height), &mut all);
                }
            }
            tiles.push(all);
        }
    }
    tiles
}

/// Number of questions.
pub fn count(tiles: &[Tile]) -> usize {
    tiles.iter().map(Vec::len).sum()
}

fn ask(scene: &Scene, ray: &Ray, all: &mut Vec<Question>) {
    let Some((object, crossing)) = scene.nearest(ray, f64::INFINITY, &mut Silent) else { return };
    let hit = scene.hit(ray, object, &crossing);
    let n = if ray.direction.dot(hit.ng) > 0.0 { -hit.ng } else { hit.ng };
    let origin = hit.origin_towards(n);
    for (light, shines) in scene.lights.iter().enumerate() {
        let Some(arrival) = shines.arriving(origin) else { continue };
        if arrival.wi.dot(n) > 0.0 {
            all.push(Question { light, segment: Ray::new(origin, arrival.to), t_max: arrival.t_max });
        }
    }
}

/// The number of questions whose answer is "no".
pub fn blocked<T: Trace>(scene: &Scene, tiles: &[Tile], way: Way, among: Among, trace: &mut T) -> usize {
    tiles.iter().map(|tile| blocked_in(scene, tile, way, among, trace)).sum()
}

fn blocked_in<T: Trace>(scene: &Scene, tile: &Tile, way: Way, among: Among, trace: &mut T) -> usize {
    let mut last = vec![None; scene.lights.len()];
    let mut count = 0;
    for Question { light, segment, t_max } in tile {
        let last: &mut Option<usize> = &mut last[*light];
        if let (Way::UntilLit | Way::ForGood, Some(i)) = (way, *last)
            && scene.objects[i].blocks(segment, *t_max, trace)
        {
            count += 1;
            continue;
        }
        let found = match (way, among) {
            (Way::Nearest, Among::List) => nearest(scene, segment, *t_max, trace),
            (Way::Nearest, Among::Hierarchy) => scene.nearest(segment, *t_max, trace).map(|(i, _)| i),
            (_, Among::List) => first(scene, segment, *t_max, trace),
            (_, Among::Hierarchy) => scene.blocker(segment, *t_max, trace),
        };
        count += usize::from(found.is_some());
        if way == Way::UntilLit || found.is_some() {
            *last = found;
        }
    }
    count
}

fn nearest<T: Trace>(scene: &Scene, segment: &Ray, mut t_max: f64, trace: &mut T) -> Option<usize> {
    let mut found = None;
    trace.count(Work::ShapeTest, scene.objects.len() as u64);
    for (i, object) in scene.objects.iter().enumerate() {
        if let Some(crossing) = object.shape().nearest(segment, 0.0, t_max) {
            t_max = crossing.t;
            found = Some(i);
        }
    }
    found
}

fn first<T: Trace>(scene: &Scene, segment: &Ray, t_max: f64, trace: &mut T) -> Option<usize> {
    scene.objects.iter().position(|object| object.blocks(segment, t_max, trace))
}

/// What a way costs for a ray.
#[derive(Clone, Copy)]
pub struct Cost {
    pub blocked: usize,
    /// Shape tests, and visits of nodes.
    pub tests: f64,
    pub visits: f64,
    /// [s].
    pub time: Option<Spread>,
}

impl Cost {
    pub fn looks(&self) -> f64 {
        self.tests + self.visits
    }

    /// Median time [s].
    pub fn seconds(&self) -> f64 {
        self.time.map_or(f64::NAN, |t| t.mid)
    }
}

/// Counted, and not timed.
pub fn counted(scene: &Scene, tiles: &[Tile], way: Way, among: Among) -> Cost {
    let mut tally = Tally::default();
    let blocked = blocked(scene, tiles, way, among, &mut tally);
    let each = |n: u64| n as f64 / count(tiles).max(1) as f64;
    Cost { blocked, tests: each(tally.shape_tests), visits: each(tally.node_visits), time: None }
}

/// Counted and timed. Each tile is timed by itself, all ways in turn, and the medians of its runs are added: a busy moment of
/// the machine spoils a run of one tile only. Some tiles from the middle are enough for ways that look at every object.
pub fn costs(scene: &Scene, tiles: &[Tile], ways: &[(Way, Among)], runs: usize) -> Vec<Cost> {
    let mut costs: Vec<Cost> = ways.iter().map(|(way, among)| counted(scene, tiles, *way, *among)).collect();
    let few = (PATIENCE / (scene.objects.len() * TILE * TILE)).clamp(1, tiles.len());
    let middle = (tiles.len() - few) / 2..(tiles.len() + few) / 2;
    let mut sums = vec![(Spread { runs, ..Spread::exact(0.0) }, 0); ways.len()];
    for (i, tile) in tiles.iter().enumerate() {
        let asked = |among: Among| among == Among::Hierarchy || middle.contains(&i);
        let mut times = vec![Vec::new(); ways.len()];
        for _ in 0..runs {
            for ((way, among), times) in ways.iter().zip(&mut times).filter(|((_, among), _)| asked(*among)) {
                let start = Instant::now();
                std::hint::black_box(blocked_in(scene, tile, *way, *among, &mut Silent));
                times.push(start.elapsed().as_secs_f64());
            }
        }
        for ((sum, rays), times) in sums.iter_mut().zip(&times) {
            if let Some(t) = Spread::median(times) {
                (sum.low, sum.mid, sum.high) = (sum.low + t.low, sum.mid + t.mid, sum.high + t.high);
                *rays += tile.len();
            }
        }
    }
    for (cost, (sum, rays)) in costs.iter_mut().zip(sums) {
        cost.time = (rays > 0).then(|| sum.times(1.0 / rays as f64));
    }
    costs
}

/// Tests that one timed run may cost before fewer rays have to do.
const PATIENCE: usize = 1_000_000;
