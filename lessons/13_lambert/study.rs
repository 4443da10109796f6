//! All 512 sets of simplifications: their errors, their work, their times, and in which order to give them up.

use super::model::{Eyesight, Made, SIMPLIFIED, other, scene};
use lightbench::film::Image;
use lightbench::film::metric::compare;
use lightbench::integrator::Local;
use lightbench::measure::{Method, Point, Series, Spread, timed};
use lightbench::render::{Picture, render};
use lightbench_kit::figure::{Axis, Chart, Figure, Table, short};
use lightbench_kit::lesson::Result;

pub const SIDE: u32 = 4; // points along a lamp's side
pub const TRUTH: u32 = 16; // the same of the truth
pub const ERROR: &str = "error of radiance, RMSE [W m⁻² sr⁻¹]";

/// One set of simplifications, measured.
#[derive(Clone, Debug)]
pub struct Measured {
    pub rmse: f64,
    /// Rays and shape tests a pixel.
    pub rays: f64,
    pub tests: f64,
    /// Per pixel [s].
    pub time: Spread,
}

/// Every set, by the bits of [`Made`].
pub struct Study {
    pub sets: Vec<Measured>,
    pub picture: Picture,
}

pub fn shoot(made: Made, side: u32, picture: Picture) -> Result<Image> {
    Ok(render(&scene(made, side)?, &Eyesight::new(made), picture).image)
}

/// The largest difference from the library's picture where that can do as much: points, opaque, plain, with highlights.
pub fn against_the_library(picture: Picture) -> Result<f64> {
    let made = Made::NONE.with(2).with(6).with(7);
    let theirs = render(&scene(made, 1)?, &Local::default(), picture).image;
    Ok(compare(&shoot(made, 1, picture)?, &theirs).max_error.abs())
}

impl Study {
    /// One thread renders all sets in turn, and those that are named `rounds` times over, so that a busy moment of the machine
    /// favours none.
    pub fn run(picture: Picture, rounds: u32) -> Result<Self> {
        let truth = shoot(Made::NONE, TRUTH, picture)?;
        let pixels = (picture.width * picture.height) as f64;
        let all = || (0..=Made::ALL.0).map(Made);
        let scenes = all().map(|made| scene(made, SIDE)).collect::<Result<Vec<_>>>()?;
        let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(other)?;
        let shoot = |made: Made| {
            let (scene, eye) = (&scenes[usize::from(made.0)], Eyesight::new(made));
            let (seconds, done) = one.install(|| timed(|| render(scene, &eye, picture)));
            (seconds / pixels, done)
        };
        let measured = |made: Made| {
            let (seconds, done) = shoot(made);
            let measured = Measured {
                rmse: compare(&done.image, &truth).rmse,
                rays: done.tally.total_rays() as f64 / pixels,
                tests: done.tally.shape_tests as f64 / pixels,
                time: Spread::exact(seconds),
            };
            (measured, vec![seconds])
        };
        let (sets, mut seconds): (Vec<Measured>, Vec<Vec<f64>>) = all().map(measured).unzip();
        let mut study = Study { sets, picture };
        let named: Vec<Made> =
            study.best_order().into_iter().chain((1..=9).map(|k| Made::NONE.with(k))).collect();
        for made in (1..rounds).flat_map(|_| &named) {
            seconds[usize::from(made.0)].push(shoot(*made).0);
        }
        for (set, seconds) in study.sets.iter_mut().zip(&seconds) {
            set.time = Spread::median(seconds).unwrap_or(set.time);
        }
        Ok(study)
    }

    pub fn of(&self, made: Made) -> &Measured {
        &self.sets[usize::from(made.0)]
    }

    /// From C's model to the truth, giving up in each step the simplification that leaves the least error.
    pub fn best_order(&self) -> Vec<Made> {
        let mut order = vec![Made::ALL];
        let mut made = Made::ALL;
        while made != Made::NONE {
            let next = (1..=9).filter(|k| made.has(*k)).map(|k| made.without(k));
            let best = next.min_by(|a, b| self.of(*a).rmse.total_cmp(&self.of(*b).rmse));
            made = best.unwrap_or(Made::NONE);
            order.push(made);
        }
        order
    }

    /// The same in the order in which C numbers them.
    pub fn numbered_order(&self) -> Vec<Made> {
        (0..=9).map(|k| (1..=k).fold(Made::ALL, Made::without)).collect()
    }

    /// In how many cases, of how many, does giving up one simplification make the error larger by over 1 %?
    pub fn setbacks(&self) -> (usize, usize) {
        let cases =
            (0..=Made::ALL.0).map(Made).flat_map(|m| (1..=9).filter(move |k| m.has(*k)).map(move |k| (m, k)));
        let worse = |(m, k): &(Made, usize)| self.of(m.without(*k)).rmse > 1.01 * self.of(*m).rmse;
        (cases.clone().filter(worse).count(), cases.count())
    }

    /// Least and largest error of all sets of `count` simplifications.
    fn extremes(&self, count: usize) -> (f64, f64) {
        let of_size = (0..=Made::ALL.0).map(Made).filter(|m| m.count() == count).map(|m| self.of(m).rmse);
        of_size.fold((f64::INFINITY, 0.0), |(a, b), e| (a.min(e), b.max(e)))
    }

    /// The most costly simplification made alone.
    pub fn worst_alone(&self) -> usize {
        let alone = |k: &usize| self.of(Made::NONE.with(*k)).rmse;
        (1..=9).max_by(|a, b| alone(a).total_cmp(&alone(b))).unwrap_or(1)
    }

    /// The simplification that saves most shape tests alone.
    pub fn cheapest_alone(&self) -> usize {
        let alone = |k: &usize| self.of(Made::NONE.with(*k)).tests;
        (1..=9).min_by(|a, b| alone(a).total_cmp(&alone(b))).unwrap_or(1)
    }

    fn point(&self, made: Made, work: f64) -> Point {
        let m = self.of(made);
        Point::at(f64::from(made.0)).timed(m.time).worked(work).erred(Spread::exact(m.rmse))
    }

    fn series(&self, sets: impl Iterator<Item = Made>) -> Series {
        Series::new(sets.map(|m| self.point(m, self.of(m).tests)).collect())
    }
}

/// The number of the simplification that the second set lacks.
pub fn given_up(before: Made, after: Made) -> usize {
    (1..=9).find(|k| before.has(*k) && !after.has(*k)).unwrap_or(0)
}

/// All sets, those of one simplification, and the best order, on either cost axis.
pub fn trade(study: &Study, timed: bool) -> Figure {
    let order = study.best_order();
    let cost = |m: Made| if timed { study.of(m).time.mid } else { study.of(m).tests };
    let chart = if timed {
        Chart::speed_accuracy(ERROR).x(Axis::time("time per pixel, one thread"))
    } else {
        Chart::work_accuracy("shape tests a pixel", ERROR)
    };
    let (all, none) = (study.of(Made::ALL), study.of(Made::NONE));
    let (eight, last) = (study.of(order[8]), given_up(order[8], order[9]));
    let price = |m: &Measured, than: &Measured| {
        if timed { m.time.mid / than.time.mid } else { m.tests / than.tests }
    };
    let title = format!(
        "Eight of nine given up: {:.1} times C's {}, {:.0} times less error; the ninth, “{}”, takes {:.0} times as much again",
        price(eight, all),
        if timed { "time" } else { "shape tests" },
        all.rmse / eight.rmse,
        SIMPLIFIED[last - 1],
        price(none, eight)
    );
    let mut chart = chart
        .title(&title)
        .subtitle(&format!(
            "all 512 sets of C's simplifications 1–9, {} × {} pixels; a number tells which simplification was given up last",
            study.picture.width, study.picture.height
        ))
        .scatter(Method::new("all sets").styled(5), &study.series((0..=Made::ALL.0).map(Made)))
        .steps(Method::new("given up in the best order").styled(0), &study.series(order.iter().copied()));
    chart = chart.note(cost(Made::ALL), all.rmse, "C's model");
    for step in order.windows(2) {
        chart = chart.note(cost(step[1]), study.of(step[1]).rmse, &given_up(step[0], step[1]).to_string());
    }
    Figure::from(chart).caption(
        "Every dot is a picture of the two spheres under some of C's nine inexact simplifications. What is left at the end is the \
         error of 16 points on each lamp against 256. Several simplifications save no time at all: they are wrong for nothing. Dots were timed once, the named sets several times.")
}

/// Error over the number of simplifications still made.
pub fn orders(study: &Study) -> Figure {
    let line = |sets: &[Made]| sets.iter().map(|m| (m.count() as f64, study.of(*m).rmse)).collect::<Vec<_>>();
    let extreme = |pick: fn((f64, f64)) -> f64| -> Vec<(f64, f64)> {
        (0..=9).map(|n| (n as f64, pick(study.extremes(n)))).collect()
    };
    let (worse, of) = study.setbacks();
    let best = study.best_order();
    let found = best.iter().filter(|m| study.of(**m).rmse == study.extremes(m.count()).0).count();
    let axis = Axis::linear("simplifications still made").range(-0.2, 9.2).every(1.0);
    let chart = Chart::new(axis, Axis::log(ERROR))
        .title(&format!("Errors hide behind each other: {worse} of {of} times one simplification less makes it worse"))
        .subtitle(&format!(
            "C's model on the right, everything on the left; the best order meets the best of all sets at {found} of 10 sizes"
        ))
        .function(Method::new("worst set of so many").styled(4), &extreme(|e| e.1))
        .curve(Method::new("as C numbers them").styled(2), &line(&study.numbered_order()))
        .curve(Method::new("best order").styled(0), &line(&best))
        .dots(Method::new("best set of so many").styled(3), &extreme(|e| e.0));
    Figure::from(chart).caption(
        "Giving up simplifications one by one. A lamp that stays at the eye makes a second lamp, shadows and the lamps' size \
         useless; only when it has moved do they count.")
}

/// What each simplification costs and saves.
pub fn prices(study: &Study) -> Table {
    let none = study.of(Made::NONE);
    let k = study.cheapest_alone();
    let alone = |k: usize| study.of(Made::NONE.with(k));
    let head = [
        "",
        "simplification",
        "RMSE, it alone",
        "RMSE, all but it",
        "it adds, mean",
        "rays",
        "shape tests",
        "time",
    ];
    let row = |table: Table, number: &str, name: &str, errors: [String; 3], m: &Measured| {
        let [rays, tests] = [m.rays, m.tests].map(|x| format!("{x:.1}"));
        let time = format!("{:.3}", m.time.mid / none.time.mid);
        table.row(&[number, name, &errors[0], &errors[1], &errors[2], &rays, &tests, &time])
    };
    let mut table = Table::new(&head)
        .title(&format!(
            "“{}” saves most, {:.0} % of the shape tests; “{}” costs most, an error of {:.3}",
            SIMPLIFIED[k - 1],
            100.0 * (1.0 - alone(k).tests / none.tests),
            SIMPLIFIED[study.worst_alone() - 1],
            alone(study.worst_alone()).rmse
        ))
        .subtitle(&format!(
            "two spheres, {} × {} pixels; error with it alone, with all others, and what it adds to 256 sets of others; counts per pixel and time (none = 1) with it alone",
            study.picture.width, study.picture.height
        ))
        .timed();
    let dash = || "–".to_string();
    table = row(table, "", "none: everything on", [format!("{:.4}", none.rmse), dash(), dash()], none);
    for k in 1..=9 {
        let pairs = (0..=Made::ALL.0).map(Made).filter(|m| m.has(k));
        let added = pairs.map(|m| study.of(m).rmse - study.of(m.without(k)).rmse).sum::<f64>() / 256.0;
        let errors = [alone(k).rmse, study.of(Made::ALL.without(k)).rmse].map(|e| format!("{e:.4}"));
        let [a, b] = errors;
        let sign = if added < 0.0 { "−" } else { "+" };
        table = row(
            table,
            &k.to_string(),
            SIMPLIFIED[k - 1],
            [a, b, format!("{sign}{:.4}", added.abs())],
            alone(k),
        );
    }
    let all = study.of(Made::ALL);
    table = row(
        table,
        "10",
        SIMPLIFIED[9],
        [format!("{} (exact)", short(0.0)), format!("{:.4}", all.rmse), "0".into()],
        none,
    );
    row(table, "1–9", "all: C's model", [format!("{:.4}", all.rmse), dash(), dash()], all)
}
