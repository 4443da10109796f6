//! A tolerance that grows with the way, as a pixel does: what it saves, and what it costs.

use super::FAR;
use super::contestant::is_wrong;
use super::stage::{self, Stage};
use glam::DVec3;
use lightbench::measure::{Failures, Method, Point, Series, log_spaced};
use lightbench::sdf::{March, Stride};
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Guide, grouped, short};
use lightbench_kit::lesson::{Lesson, Result};

/// Shortest step at the eye [m].
const TOLERANCE: f64 = 1.0e-5;
/// Spreads of the chart and of the map [pixels].
const SPREADS: std::ops::Range<f64> = 1.0e-4..1.0e2;
const MAPPED: std::ops::Range<f64> = 1.0e-3..1.0e2;
/// The eyes of the chart: name, height above the floor [m], style.
const EYES: [(&str, f64, usize); 3] =
    [("2 cm above the floor", 0.02, 1), ("20 cm", 0.2, 3), ("2.55 m", 2.55, 0)];
/// Heights of the map [m].
const HEIGHTS: std::ops::Range<f64> = 3.0e-3..3.0;

/// Rays of one eye with their truths.
struct View {
    rays: Vec<lightbench::ray::Ray>,
    truth: Vec<Option<f64>>,
    /// Width of a pixel at distance 1.
    pixel: f64,
}

impl View {
    fn from_height(stage: &Stage, height: f64, width: usize) -> Self {
        let from = DVec3::new(stage::FROM_ABOVE.x, stage::FLOOR + height, stage::FROM_ABOVE.z);
        let rays = stage.view(width, from);
        let truth = rays.iter().map(|r| stage.by_formula(r)).collect();
        let pixel = 2.0 * (0.5 * stage::ANGLE).tan() / (width * 2 / 3) as f64;
        View { rays, truth, pixel }
    }

    /// Evaluations a ray and wrong pixels, for a spread in pixels; and how many of the evaluations polish roots.
    fn measured(&self, stage: &Stage, spread: f64) -> (Point, f64) {
        let march = March::through(&stage.field)
            .with_stride(Stride::ALL[2])
            .with_tolerance(TOLERANCE)
            .with_spread(spread * self.pixel);
        let mut failures = Failures { of: self.rays.len() as u64, ..Failures::default() };
        let (mut steps, mut polish) = (0, 0);
        for (ray, truth) in self.rays.iter().zip(&self.truth) {
            let done = march.first(&stage.field, ray, 0.0, FAR);
            (steps, polish) = (steps + done.steps, polish + done.polish);
            let wrong = u64::from(is_wrong(done.distance, *truth));
            if done.distance.is_some() { failures.false_hits += wrong } else { failures.missed += wrong }
        }
        let a_ray = |count: u32| f64::from(count) / self.rays.len() as f64;
        (Point { failures, ..Point::at(spread).worked(a_ray(steps + polish)) }, a_ray(polish))
    }
}

/// Evaluations per ray without a spread and with one of a pixel, how many of them polish roots, and that pixel's failures.
struct Pixel {
    all: [f64; 2],
    polish: [f64; 2],
    failures: Failures,
}

pub fn show(lesson: &Lesson) -> Result {
    let stage = Stage::new(stage::HOME);
    let width = lesson.pick([18, 72, 120, 200]);
    let spreads = log_spaced(SPREADS.start, SPREADS.end, lesson.pick([7, 19, 37, 61]));
    let mut lines = Vec::new();
    for (name, height, style) in EYES {
        let view = View::from_height(&stage, height, width);
        let [(none, a), (one, b)] = [0.0, 1.0].map(|spread| view.measured(&stage, spread));
        let all = [&none, &one].map(|p| p.work.unwrap_or(f64::NAN));
        let pixel = Pixel { all, polish: [a, b], failures: one.failures };
        let mut series = Series::over(&spreads, |x| view.measured(&stage, x).0);
        series.points.insert(0, none);
        lines.push((Method::new(name).styled(style), series, pixel));
    }
    lesson.save("spread", chart(&lines, width))?;
    lesson.save("spread_wrong", map(lesson, &stage))
}

fn axis(range: std::ops::Range<f64>) -> Axis {
    Axis::log("growth of the shortest step with the way, in widths of a pixel").range(range.start, range.end)
}

fn chart(lines: &[(Method, Series, Pixel)], width: usize) -> Figure {
    let [along, _, above] = [0, 1, 2].map(|k| &lines[k].2);
    let title = format!(
        "A shortest step of one pixel saves {:.0} % of the evaluations along the floor, and costs {:.2} % of the pixels",
        100.0 * (1.0 - along.all[1] / along.all[0]),
        100.0 * along.failures.share()
    );
    let mut chart = Chart::work_over(axis(SPREADS), "")
        .y(Axis::linear("evaluations of the field per ray").range(0.0, 1.1 * along.all[0]))
        .title(&title)
        .subtitle(&format!(
            "the still life by {} rays from each height; enhanced strides, {} m at the eye; failed: hit or miss, or off by 10⁻³",
            grouped((width * (width * 2 / 3)) as u64),
            short(TOLERANCE)
        ))
        .guide(Guide::upright(1.0, "one pixel"))
        .guide(Guide::level(along.all[0], "from 2 cm, without growth"));
    for (method, series, _) in lines {
        chart = chart.line(method.clone(), series);
    }
    let steps = |p: &Pixel, k: usize| p.all[k] - p.polish[k];
    Figure::from(chart).caption(&format!(
        "Evaluations and wrong pixels over the growth of the shortest step. From 2 cm above the floor one pixel takes the steps from {:.1} \
         to {:.1} a ray, the polishing of the root from {:.1} to {:.1}, for a longer last step leaves more of it; {} of {} pixels are wrong, \
         where a ray cuts a rim more thinly than its step. From {} m no ray crawls, and nothing is saved: {:.1} evaluations become {:.1}.",
        steps(along, 0),
        steps(along, 1),
        along.polish[0],
        along.polish[1],
        along.failures.total(),
        grouped(along.failures.of),
        EYES[2].1,
        above.all[0],
        above.all[1]
    ))
}

/// Share of wrong pixels that is too much.
const TOO_MANY: f64 = 0.01;

fn map(lesson: &Lesson, stage: &Stage) -> Figure {
    let (width, size) = lesson.pick([(12, (5, 3)), (36, (30, 18)), (72, (50, 30)), (96, (80, 48))]);
    let up = Axis::log("height of the eye above the floor, m").range(HEIGHTS.start, HEIGHTS.end);
    // Row by row: each height's truth is found once.
    let mut view: Option<(f64, View)> = None;
    let (mut within, mut of) = (0.0f64, 0);
    let cell = |spread: f64, height: f64| {
        if view.as_ref().is_none_or(|(of, _)| *of != height) {
            view = Some((height, View::from_height(stage, height, width)));
        }
        let failures = view.as_ref()?.1.measured(stage, spread).0.failures;
        of = failures.of;
        within = within.max(if spread <= 1.0 { failures.share() } else { 0.0 });
        Some(failures.share())
    };
    let map = FailureMap::new(axis(MAPPED), up, "wrong pixels", size, cell)
        .range(1.0e-3, 1.0)
        .failing_above(TOO_MANY, "over 1 % wrong");
    let title = format!(
        "Up to a pixel at most {:.1} % of the pixels are wrong, however low the eye; {:.0} % of the map loses over 1 %",
        100.0 * within,
        100.0 * map.failing_share()
    );
    let map = map.title(&title).subtitle(&format!(
        "{} rays a cell at the still life; wrong: hit or miss, or off by 10⁻³ of the distance; darkest: none",
        grouped(of)
    ));
    Figure::from(map).caption(
        "Wrong pixels over the growth of the shortest step and the height of the eye. The limit is the picture's and not the angle's: a \
         step of several pixels leaps over what several pixels show.",
    )
}
