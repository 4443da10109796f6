//! Lesson 19. How many shadow rays does a soft shadow need, and where on the light should they end?
//!
//! Builds on:  17 (lights and hard shadows), 18 (where shadow rays start).
//! New here:   points on rectangle, triangle and sphere; even by area or by solid angle; grid, jitter, low discrepancy.
//! Notation:   N shadow rays from a place; θ, θₗ angles at receiver and light; d their distance; Ω solid angle [sr].
//! Predict:    100 rays end on a fixed grid of 10 × 10 points. How many well-placed rays make as good a half shadow?
//! Figure:     19_area_lights_shadows_time.svg, 19_area_lights_penumbra.svg, 19_area_lights_marked.svg

#[path = "19_area_lights/contest.rs"]
mod contest;
#[path = "19_area_lights/diagrams.rs"]
mod diagrams;
#[path = "19_area_lights/maps.rs"]
mod maps;
#[path = "19_area_lights/naive.rs"]
mod naive;
#[path = "19_area_lights/penumbra.rs"]
mod penumbra;
#[path = "19_area_lights/pictures.rs"]
mod pictures;
#[path = "19_area_lights/place.rs"]
mod place;

use contest::Contest;
use diagrams::Bias;
use lightbench::light::Measure;
use lightbench::measure::Z;
use lightbench::render::Picture;
use lightbench::sample::Pattern;
use lightbench_kit::lesson::{Lesson, Result};
use maps::{Far, Near};
use penumbra::{FEW, GRID, Penumbra};
use pictures::Marked;
use place::{Fold, Unoccluded};

/// A largest error in words.
fn place_percent(error: f64) -> String {
    format!("{:.0} %", (100.0 * error).ceil())
}

fn main() -> Result {
    let lesson = Lesson::without_essay(19)?;
    let seed = lesson.seed();
    let flags = lesson.flags();
    let (w, h) = lesson.pick([(48, 30), (640, 400), (640, 400), (1280, 800)]);
    let samples = flags.spp.map_or(1, u32::from);
    let size = |given: Option<u16>, usual| given.map_or(usual, usize::from);
    let shown = Picture { width: size(flags.width, w), height: size(flags.height, h), samples, seed };

    // 1. The truth: closed forms of what arrives unhindered, polygons behind an edge, Sobol' points in thousands else.
    let small = lesson.pick([24, 48, 96, 160]);
    let picture = Picture { width: small, height: small * 2 / 3 + 1, samples: 1, seed };
    let truth_rays = lesson.pick([256, 1800, 8192, 16_384]);

    // 2. The contestants: patterns and measures, unhindered, behind an edge, in a picture; maps as printed.
    let runs = lesson.pick([40, 64, 256, 1024]);
    let free = Unoccluded::measured(&[4, 16, 64, 256, 1024], runs, seed)?;
    let fold = Fold::measured(&[4, 16, 64, 256, 1024], runs, seed)?;
    let places = lesson.pick([400, 1000, 4000, 16_000]);
    let half = Penumbra::measured(places, lesson.pick([9, 90, 180, 180]), seed);
    let far = Far::measured(lesson.pick([7, 25, 25, 49]), lesson.pick([4, 32, 64, 256]), seed)?;
    let near =
        Near::new(lesson.pick([(12, 8), (48, 36), (84, 60), (120, 90)]), lesson.pick([8, 24, 48, 96]), seed);
    let bias = Bias::measured(lesson.pick([24, 160, 192, 256]), lesson.pick([6, 30, 45, 90]));
    let contest = Contest::measured(picture, truth_rays, lesson.pick([1, 3, 9, 15]))?;

    // 3. The figures.
    lesson.save("shadows", contest.headline())?;
    lesson.save("shadow_rays", contest.counted())?;
    lesson.save("defaults", contest.table())?;
    lesson.save("penumbra", half.chart(false))?;
    lesson.save("penumbra_random", half.chart(true))?;
    lesson.save("penumbra_angles", half.angles())?;
    lesson.save("unoccluded", free.chart())?;
    lesson.save("patterns", free.table())?;
    let (by_area, failing, _) = near.map(Measure::Area)?;
    let (by_solid_angle, _, worst) = near.map(Measure::SolidAngle)?;
    lesson.save("near_area", by_area)?;
    lesson.save("near_solid_angle", by_solid_angle)?;
    lesson.save("far", far.chart())?;
    lesson.save("fold", fold.chart())?;
    lesson.save("sphere_printed", bias.chart())?;
    diagrams::save(&lesson, fold.ratios())?;
    pictures::save(&lesson, shown)?;
    let marked = pictures::marked(shown)?;
    lesson.save("marked", marked.figure.clone())?;

    // 4. What the figures show, checked.
    claims(&lesson, &half, &free, &marked);
    lesson.say(&format!(
        "Of the map of near and grazing places, points even by area are useless (RMSE above 50 %) on {:.0} %; by solid angle they err by \
         {} at most. The printed solid-angle maps are off by more than 1 % from {:.0e} (rectangle), {:.0e} (triangle), {:.0e} (sphere) sizes on; \
         ours by {:.0e} beyond 10⁸.",
        100.0 * failing, place_percent(worst), far.fails_from(0, 0.01), far.fails_from(1, 0.01), far.fails_from(2, 0.01), far.ours_beyond(1.0e8)
    ));
    lesson.answer(&answer(&half, &contest))
}

fn claims(lesson: &Lesson, half: &Penumbra, free: &Unoccluded, marked: &Marked) {
    let ratio = |p, n, random| half.at(p, n, random) / half.at(Pattern::Centres, GRID, random);
    let of = |random| [Pattern::Sobol, Pattern::Jittered, Pattern::R2].map(|p| ratio(p, FEW, random));
    let (along, across, more) = (of(false), of(true), ratio(Pattern::Jittered, 36, false));
    lesson.claim(
        &format!(
            "where the blocker's edge runs parallel to the light's sides, 25 Sobol' points have {:.2} times the RMSE of a fixed 10 × 10 grid, 25 jittered ones {:.2} (36: {more:.2}), \
             25 of R₂ {:.2}; at random angles they do not match it: {:.1}, {:.1} and {:.1} times",
            along[0], along[1], along[2], across[0], across[1], across[2]
        ),
        along[0] < 1.0 && along[1] < 1.5 && more < 1.15 && across.iter().all(|x| *x > 1.5),
    );
    let [random, jitter, low] = [2, 1, 3].map(|k| free.slope(0, 0, k));
    let steeper = |s: &lightbench::measure::Slope, than: f64| s.value + Z * s.sigma < than;
    lesson.claim(
        &format!(
            "unhindered light: errors fall as N to the {} at random, {} jittered, {} by Sobol's points; behind an edge along the sides {}",
            place::signed(random.value), place::signed(jitter.value), place::signed(low.value), half.slopes_text()
        ),
        random.agrees_with(-0.5) && steeper(&jitter, -0.6) && steeper(&low, -0.9),
    );
    lesson.claim(
        &format!(
            "the drawn lines are the shadow's: of {} pixels of umbra and {} of full light on the floor, {} disagree with 16 shadow rays",
            marked.checked[0], marked.checked[1], marked.wrong
        ),
        marked.wrong == 0 && marked.checked.iter().all(|n| *n > 0),
    );
}

fn answer(half: &Penumbra, contest: &Contest) -> String {
    let grid = half.at(Pattern::Centres, GRID, false);
    let gain = |light| contest.by_solid_angle(light);
    format!(
        "Along the light's sides 25 Sobol' points (RMSE {:.4}) do what a fixed grid of 100 does ({grid:.4}), jittered ones need 36 ({:.4}); at random angles the grid \
         keeps its lead ({:.4} against {:.4}), but draws bands (errors of neighbours correlate by {:.2}, of jittered points by {}). In a picture 16 Sobol' points err {:.1} times \
         less than jittered ones. On a sphere they should lie on what is seen: even by solid angle they err {:.0} times less than by area; on flat lights some widths away {:.1} and \
         {:.1} times, but nearer than a width points even by area fail.",
        half.at(Pattern::Sobol, FEW, false),
        half.at(Pattern::Jittered, 36, false),
        half.at(Pattern::Centres, GRID, true),
        half.at(Pattern::Sobol, FEW, true),
        half.bands[0],
        place::signed(half.bands[1]),
        contest.by_sobol(),
        gain(2),
        gain(0),
        gain(1)
    )
}
