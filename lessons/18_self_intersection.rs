//! Lesson 18. How far off its surface must a ray start, so that it meets no shadow of its own and lets no light leak?
//!
//! Builds on:  02 (a ray meets a sphere), 03 (shadow rays start on surfaces), 17 (lights and hard shadows).
//! New here:   false shadows and leaks counted against known answers; an error bound instead of a bias; which side.
//! Notation:   p computed point, e bound on its error [m], n geometric normal, u unit roundoff; sizes: lengths in that of
//!             the object, so that a sphere of 1 mm that stands 1 km from the world's origin is 10⁶ sizes away.
//! Predict:    64-bit numbers instead of 32: does the share of false shadows without a remedy fall?
//! Figure:     18_self_intersection_speed_time.svg

use lightbench::render::Picture;
use lightbench_kit::figure::grouped;
use lightbench_kit::lesson::{Lesson, Result};

#[path = "18_self_intersection/bodies.rs"]
mod bodies;
#[path = "18_self_intersection/charts.rs"]
mod charts;
#[path = "18_self_intersection/contest.rs"]
mod contest;
#[path = "18_self_intersection/diagrams.rs"]
mod diagrams;
#[path = "18_self_intersection/heights.rs"]
mod heights;
#[path = "18_self_intersection/maps.rs"]
mod maps;
#[path = "18_self_intersection/pictures.rs"]
mod pictures;
#[path = "18_self_intersection/plain.rs"]
mod plain;
#[path = "18_self_intersection/single.rs"]
mod single;
use contest::{Axes, Budget, Rule, Score, Way, contest, default_in_fans, ways};
use maps::Panel;

const DISTANCES: [f64; 5] = [0.0, 1.0, 1.0e3, 1.0e6, 1.0e9]; // sizes
const SINGLE: [f64; 5] = [0.0, 1.0, 1.0e1, 1.0e2, 1.0e3]; // sizes, as far as 24 bits know a surface

fn main() -> Result {
    let lesson = Lesson::without_essay(18)?;
    let seed = lesson.seed();
    let sizes: Vec<f64> = (-3..=3).map(|e| 10f64.powi(2 * e)).collect(); // m
    let axes = Axes { sizes: sizes.clone(), distances: DISTANCES.to_vec() };
    let near = Axes { sizes, distances: SINGLE.to_vec() };
    let starts = |n| lesson.pick([n / 64 + 1, n, 4 * n, 16 * n]);
    let width = lesson.pick([60, 500, 760, 1000]);
    let [pair, four] = [1.45, 1.88].map(|aspect| (width as f64 / aspect) as usize);
    let [pair, four] = [pair, four].map(|height| Picture { width, height, samples: 1, seed });

    // 1. The truth: of a convex body, lights above a tangent plane are seen, and lights below it are not.
    diagrams::all(&lesson)?;

    // 2. The contestants: all on the same rays, the default on 10⁶ more in each cell; in 64 bits, and some in 32.
    let (ways, rules): (Vec<Way>, Vec<Rule>) = ways().into_iter().map(|w| (w.clone(), w.rule)).unzip();
    let (many, some) =
        (Budget { starts: starts(261), lights: 128 }, Budget { starts: starts(32), lights: 24 });
    let promised = axes.cells(|size, distance| default_in_fans(seed, size, distance, many))?;
    let found = axes.cells(|size, distance| contest(seed, &rules, size, distance, some))?;
    let of = |k: usize| found.iter().map(|cell| cell[k]).collect::<Vec<Score>>();
    let totals: Vec<Score> = (0..ways.len()).map(|k| Score::sum(&of(k))).collect();
    let some = Budget { starts: starts(400), lights: 32 };
    let single = near.cells(|size, distance| Ok(single::contest(seed, size, distance, some)))?;
    let in_single = |k: usize| single.iter().map(|cell| cell[k]).collect::<Vec<Score>>();
    let hits = lesson.pick([64, 1024, 4096, 16384]);
    let heights = heights::measured(seed, hits)?;
    let costs = charts::costs(seed, &ways, &totals)?;

    // 3. The figures.
    lesson.save("speed", charts::speed(&ways, &costs))?;
    lesson.save("ways", charts::table(&ways, &costs))?;
    let panels = |count: fn(&Score) -> (u64, u64)| -> Vec<Panel> {
        let scores = |k: usize| if k == 0 { Score::both(&of(0), &promised) } else { of(k) };
        ways.iter().enumerate().map(|(k, w)| Panel::new(&w.method.name, &scores(k), count)).collect()
    };
    let (shadows, leaks) = (panels(Score::shadows), panels(Score::lights_below));
    lesson.save("false_shadows", maps::figure(&shadows, &axes, 5, &maps::SHADOWS))?;
    lesson.save("leaks", maps::figure(&leaks, &axes, 5, &maps::LEAKS))?;
    let rules = single::RULES.iter().enumerate();
    let panels: Vec<Panel> = rules.map(|(k, r)| Panel::new(r.0, &in_single(k), Score::all)).collect();
    lesson.save("single", maps::figure(&panels, &near, 3, &maps::SINGLE))?;
    lesson.save("heights", heights::figure(&heights, hits))?;
    let (figure, acne) = pictures::acne(pair)?;
    lesson.save("acne", figure)?;
    lesson.save("detached", pictures::detached(four)?)?;
    lesson.save("glass", pictures::glass(four)?)?;
    lesson.save("skipped", pictures::skipped(pair)?)?;
    lesson.save("planet", pictures::planet(pair)?)?;

    // 4. What the figures show, checked.
    let all = Score::sum(&promised);
    let least = promised.iter().map(|s| s.shadow_rays).min().unwrap_or(0);
    let sentence = format!(
        "the error bound answers {} shadow rays, {} in each of {} cells: {} false shadows, {} leaks",
        grouped(all.shadow_rays),
        grouped(least),
        promised.len(),
        all.false_shadows,
        all.leaks
    );
    lesson.claim(&sentence, all.wrong() + totals[0].wrong() + totals[0].lost == 0);
    let fails =
        |k: usize| shadows[k].wrong.iter().zip(&leaks[k].wrong).filter(|(a, b)| **a + **b > 0).count();
    let fewest = (2..ways.len()).map(fails).min().unwrap_or(0);
    let sentence =
        format!("every way that does not ask the shape fails, in {fewest} of {} cells or more", found.len());
    lesson.claim(&sentence, fewest > 0);
    let margin = heights.iter().map(heights::Heights::margin).fold(f64::INFINITY, f64::min);
    let sentence = format!(
        "the lowest start lies {margin:.1} times as high as the deepest point deep, or higher, at each distance"
    );
    lesson.claim(&sentence, margin > 1.0);
    lesson.say(&against_pbrt(&costs, &heights));
    lesson.answer(&format!(
        "by the bound on the error of its own point, on the side to which it goes: {} wrong answers in {} rays over twelve decades \
         of size, for {:.1} ns a ray. B's 10⁻⁴ m fails in {} of {} cells, A's 0.01 m in {}. Without a remedy {:.0} % of the lit pixels of a \
         picture turn black with 64 bits: more digits make the error smaller, not rarer.",
        all.wrong(),
        grouped(all.shadow_rays),
        costs[0].time.mid * 1.0e9,
        fails(5),
        found.len(),
        fails(7),
        100.0 * acne,
    ))
}

fn against_pbrt(costs: &[charts::Cost], heights: &[heights::Heights]) -> String {
    let over = heights.iter().map(heights::Heights::over_pbrt).fold(0.0, f64::max);
    let [ours, pbrt] = [0, 1].map(|k| costs[k].time.mid * 1.0e9);
    format!(
        "\npbrt offsets by the same rule with an error for each axis, and moves every coordinate to its next neighbour in case the sum rounds \
         back; here the bound is one number, and two roundings of the largest coordinate are added. Both never fail. pbrt's own bound of a \
         sphere is up to {over:.1} times tighter; its neighbours cost {pbrt:.1} ns a start instead of {ours:.1} ns."
    )
}
