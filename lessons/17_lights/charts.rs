//! What shadow rays cost: over the number of objects, over the share of shadow, and scene by scene.

use super::contest::{Among, Cost, Way, blocked, costs, count, counted, questions};
use super::stage::{places, radius_of, swarm};
use lightbench::integrator::{Local, Memory};
use lightbench::measure::{Method, Point, Series, log_spaced};
use lightbench::ray::Tally;
use lightbench::render::{Picture, render};
use lightbench::scene::Scene;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, Shades, Table, grouped};
use lightbench_kit::lesson::Result;

/// Share of the floor that lies in shadow where the number of objects is swept.
const SHARE: f64 = 0.4;
const RUNS: usize = 11;
/// Floor places between which a shadow of the swarm is sampled [m].
const STEP: f64 = 0.02;
/// Spheres in a swarm, at least: there is always a hierarchy.
const LEAST: usize = 300;

pub const WAYS: [(Way, Among); 6] = [
    (Way::Nearest, Among::List),
    (Way::First, Among::List),
    (Way::UntilLit, Among::List),
    (Way::Nearest, Among::Hierarchy),
    (Way::First, Among::Hierarchy),
    (Way::UntilLit, Among::Hierarchy),
];

fn methods() -> [Method; 6] {
    [
        Method::new("nearest hit, list").styled(1),
        Method::new("first blocker, list").styled(4),
        Method::new("last blocker first, list").styled(3),
        Method::new("nearest hit, hierarchy").styled(5),
        Method::new("first blocker, hierarchy").styled(2),
        Method::default_of("last blocker first, hierarchy").styled(0),
    ]
}

/// Costs of all ways on swarms of growing numbers.
pub struct Sweep {
    pub sizes: Vec<usize>,
    /// By size, then by way.
    pub costs: Vec<[Cost; 6]>,
    /// Share of the rays that are blocked, by size.
    pub shares: Vec<f64>,
}

impl Sweep {
    pub fn new(sizes: &[usize], seed: u64, tiles: u32) -> Result<Self> {
        let (mut all, mut shares) = (Vec::new(), Vec::new());
        let asked = places(tiles, STEP, seed);
        for &n in sizes {
            let scene = swarm(n, SHARE, seed)?;
            let found = costs(&scene, &asked, &WAYS, RUNS);
            shares.push(found[0].blocked as f64 / count(&asked).max(1) as f64);
            all.push([0, 1, 2, 3, 4, 5].map(|i| found[i]));
        }
        Ok(Sweep { sizes: sizes.to_vec(), costs: all, shares })
    }

    pub fn last(&self) -> &[Cost; 6] {
        &self.costs[self.costs.len() - 1]
    }

    /// Do all ways answer alike?
    pub fn agree(&self) -> bool {
        self.costs.iter().all(|ways| ways.iter().all(|c| c.blocked == ways[0].blocked))
    }

    fn draw(&self, chart: Chart, point: impl Fn(f64, &Cost) -> Point) -> Chart {
        methods().into_iter().enumerate().fold(chart, |chart, (way, method)| {
            // Below a dozen objects there is no hierarchy, and its lines would be those of the list.
            let from = if way < 3 { 0 } else { 12 };
            let sizes = self.sizes.iter().zip(&self.costs).filter(|(n, _)| **n >= from);
            let points = sizes.map(|(n, costs)| point(*n as f64, &costs[way])).collect();
            chart.line(method, &Series::new(points))
        })
    }

    fn subtitle(&self) -> String {
        let [low, high] =
            [f64::min, f64::max].map(|f| 100.0 * self.shares.iter().copied().reduce(f).unwrap_or(0.0));
        format!(
            "places of a floor, 2 cm apart, under spheres in parallel light; {low:.0}–{high:.0} % in shadow; {RUNS} runs each"
        )
    }

    pub fn time(&self) -> Figure {
        let (last, n) = (self.last(), self.sizes[self.sizes.len() - 1]);
        let chart = Chart::time_over(Axis::log("number of spheres"), "time per shadow ray").title(&format!(
            "Among {} spheres a shadow ray takes {:.0} ns; nearest hits in a list take {:.0} times as long",
            grouped(n as u64),
            1.0e9 * last[5].seconds(),
            last[0].seconds() / last[5].seconds()
        ));
        let chart = self.draw(chart.subtitle(&self.subtitle()), |n, c| Point {
            time: c.time,
            ..Point::at(n).worked(c.looks())
        });
        Figure::from(chart).caption(
            "B's function for all rays looks for the nearest hit; a shadow ray may stop at the first one. In a list that saves \
             part of the tests of blocked rays; in a hierarchy next to nothing, for few other boxes lie on their way. What saves looks \
             there is to ask the object that hid the last place before all others.")
    }

    pub fn work(&self) -> Figure {
        let (last, n) = (self.last(), self.sizes[self.sizes.len() - 1]);
        let chart =
            Chart::work_over(Axis::log("number of spheres"), "shape tests and node visits per shadow ray");
        let chart = chart.title(&format!(
            "Among {} spheres: {:.1} looks for the nearest hit, {:.1} for the first blocker, {:.1} with memory",
            grouped(n as u64),
            last[3].looks(),
            last[4].looks(),
            last[5].looks()
        ));
        let chart = self.draw(chart.subtitle(&self.subtitle()), |n, c| Point::at(n).worked(c.looks()));
        Figure::from(chart).caption(
            "The same in counts, which repeat on every machine. A visit of a node looks at eight boxes at once. As the spheres shrink \
             towards the distance of neighbouring rays, the last blocker is less often the next one.")
    }
}

/// Looks with memory over looks without, and the share of blocked rays: under a swarm whose spheres' radius is that many
/// distances of neighbouring rays.
fn ratio(tiles: u32, radius: f64, share: f64, seed: u64, way: Way) -> Result<(f64, f64)> {
    // So many that the tiles of the finest spheres lie under the swarm too.
    let wanted = radius_of(1, share) / (MOST_STEP * radius);
    let n = (wanted * wanted).ceil().max(LEAST as f64) as usize;
    let scene = swarm(n, share, seed)?;
    let asked = places(tiles, radius_of(n, share) / radius, seed);
    let [with, without] = [way, Way::First].map(|w| counted(&scene, &asked, w, Among::Hierarchy));
    Ok((with.looks() / without.looks(), with.blocked as f64 / count(&asked) as f64))
}

/// Floor places are at most so far apart [m] that a tile of them lies under the swarm.
const MOST_STEP: f64 = 0.2;

/// Where remembering pays: over the size of blockers and the share of shadow.
pub fn map(tiles: u32, cells: (usize, usize), seed: u64) -> Result<(Figure, f64, f64)> {
    let (mut worst, mut broken) = (0.0f64, None);
    let map = FailureMap::new(
        Axis::log("radius of the blockers, in distances of neighbouring rays").range(0.3, 30.0),
        Axis::percent("share of the floor that they cover").range(0.0, 1.0),
        "ratio of looks",
        cells,
        |radius, share| match ratio(tiles, radius, share, seed, Way::UntilLit) {
            Ok((ratio, _)) => {
                worst = worst.max(ratio);
                Some(ratio)
            }
            Err(e) => {
                broken = Some(e);
                None
            }
        },
    );
    if let Some(e) = broken {
        return Err(e);
    }
    let map = map.shades(Shades::Linear).range(0.0, 1.2).failing_above(1.0, "memory costs more");
    let share = map.failing_share();
    let map = map
        .title(&format!("Wide shadows are worth remembering; crumbs cost up to {:.0} % more", 100.0 * (worst - 1.0)))
        .subtitle(&format!(
            "shape tests and node visits with the last blocker remembered, over those without; {tiles} tiles of 16 × 16 places a cell"
        ));
    let figure = Figure::from(map).caption(
        "Where a blocker is wider than a few rays and much of the floor lies in shadow, the object that hid the last place hides this \
         one too, and is the only one asked. Where it is narrower than the rays' distance, it is asked in vain once for every blocked ray.");
    Ok((figure, share, worst))
}

/// Forgetting where it is light against remembering for good.
pub fn policies(tiles: u32, seed: u64) -> Result<Figure> {
    let shares = [0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98];
    let mut chart = Chart::new(
        Axis::percent("shadow rays that are blocked").range(0.0, 1.0),
        Axis::linear("looks, over those without memory").range(0.0, 1.5),
    );
    let mut most = 0.0f64;
    for (name, way, radius) in [
        ("forgets in the light, 20 rays", Way::UntilLit, 20.0),
        ("forgets, 1 ray", Way::UntilLit, 1.0),
        ("never forgets, 20 rays", Way::ForGood, 20.0),
        ("never forgets, 1 ray", Way::ForGood, 1.0),
    ] {
        let mut points = Vec::new();
        for share in shares {
            let (ratio, blocked) = ratio(tiles, radius, share, seed, way)?;
            points.push((blocked, ratio));
        }
        if way == Way::ForGood {
            most = points.iter().map(|p| p.1).fold(most, f64::max);
        }
        let style = if way == Way::UntilLit { 0 } else { 1 };
        let method =
            if (way, radius) == (Way::UntilLit, 20.0) { Method::default_of(name) } else { Method::new(name) };
        chart = chart.curve(method.styled(if radius > 5.0 { style } else { style + 2 }), &points);
    }
    let chart = chart
        .title(&format!("Never to forget costs up to {:.0} % more looks in the light", 100.0 * (most - 1.0)))
        .subtitle("shape tests and node visits per shadow ray, spheres over a floor; blockers' radius in distances of neighbouring rays")
        .guide(Guide::level(1.0, "no memory"));
    Ok(Figure::from(chart).caption(
        "The library forgets the last blocker as soon as a place is lit: it is asked in vain only where a shadow ends. What is never \
         forgotten is asked in vain at every lit place."))
}

/// One scene under both rules.
pub struct Row {
    pub name: &'static str,
    pub objects: usize,
    pub share: f64,
    /// Looks and seconds per shadow ray without and with memory.
    pub costs: [Cost; 2],
    pub same: bool,
}

pub fn row(name: &'static str, scene: &Scene, picture: Picture) -> Row {
    let asked = questions(scene, picture);
    let found =
        costs(scene, &asked, &[(Way::First, Among::Hierarchy), (Way::UntilLit, Among::Hierarchy)], RUNS);
    let ways = [Memory::Nothing, Memory::LastBlocker].map(|memory| Local { memory, ..Local::default() });
    let [plain, remembered] = ways.map(|way| render(scene, &way, picture).image);
    let blocked = blocked(scene, &asked, Way::ForGood, Among::Hierarchy, &mut Tally::default());
    Row {
        name,
        objects: scene.objects.len(),
        share: found[0].blocked as f64 / count(&asked).max(1) as f64,
        costs: [found[0], found[1]],
        same: plain == remembered && found.iter().all(|c| c.blocked == blocked),
    }
}

pub fn table(rows: &[Row]) -> Table {
    let head = ["scene", "objects", "in shadow", "looks a ray", "with memory", "ns a ray", "with memory"];
    let gains = rows.iter().filter(|r| r.costs[1].seconds() < r.costs[0].seconds()).count();
    let table = Table::new(&head)
        .title(&format!("The last blocker remembered shortens the rays of {gains} of {} scenes", rows.len()))
        .subtitle(
            "shape tests and node visits, and time, per shadow ray that stops at its first blocker; medians",
        )
        .timed();
    rows.iter().fold(table, |table, r| {
        let [plain, with] = r.costs;
        table.row(&[
            r.name,
            &grouped(r.objects as u64),
            &format!("{:.0} %", 100.0 * r.share),
            &format!("{:.2}", plain.looks()),
            &format!("{:.2}", with.looks()),
            &format!("{:.0}", 1.0e9 * plain.seconds()),
            &format!("{:.0}", 1.0e9 * with.seconds()),
        ])
    })
}

/// Sizes of swarms.
pub fn sizes(most: f64) -> Vec<usize> {
    log_spaced(1.0, most, 2 * most.log10().round() as usize + 1).iter().map(|n| n.round() as usize).collect()
}
