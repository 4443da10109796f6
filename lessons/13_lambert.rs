//! Lesson 13. What does each simplification of local light cost the picture, and what does it save?
//!
//! Builds on:  03 (a light, a shadow and a first picture).
//! New here:   C's ten simplifications as switches; Lambert's law in its formulas and misprints; ambient light; two ways to
//!             bring too much light into range.
//! Notation:   N, L unit normal and direction to the lamp; θ between them; Iᵢ, Iₐ light of lamps and of everywhere; K, ρ reflectance.
//! Predict:    C's model makes nine inexact simplifications. Give up one of them: does the picture always get better?
//! Figure:     13_lambert_alone.svg, 13_lambert_trade_time.svg, 13_lambert_orders.svg, 13_lambert_clamp_map.svg

#[path = "13_lambert/diagrams.rs"]
mod diagrams;
#[path = "13_lambert/edges.rs"]
mod edges;
#[path = "13_lambert/lamps.rs"]
mod lamps;
#[path = "13_lambert/model.rs"]
mod model;
#[path = "13_lambert/overexposed.rs"]
mod overexposed;
#[path = "13_lambert/pictures.rs"]
mod pictures;
#[path = "13_lambert/study.rs"]
mod study;

use lightbench::render::Picture;
use lightbench_kit::lesson::{Lesson, Result};
use model::{Made, SIMPLIFIED};
use overexposed::{Way, turns};
use study::{Study, given_up};

fn main() -> Result {
    let lesson = Lesson::without_essay(13)?;
    let [width, rounds, shown, big] =
        lesson.pick([[24, 1, 24, 48], [64, 5, 200, 512], [96, 5, 280, 800], [160, 9, 560, 1280]]);
    let sized = |width: usize| Picture { width, height: width * 5 / 8, samples: 1, seed: lesson.seed() };

    // 1. The truth: all simplifications given up, lamps of 256 points. 2. The contestants: all 512 sets of nine.
    let study = Study::run(sized(width), rounds as u32)?;
    let vacuum = edges::vacuum()?;

    // 3. The figures.
    diagrams::save(&lesson)?;
    pictures::documents(&lesson, sized(big))?;
    lamps::sphere(&lesson, sized(big))?;
    lesson.save("alone", pictures::alone(&study, sized(shown))?)?;
    lesson.save("ladder", pictures::ladder(&study, sized(shown))?)?;
    lesson.save("trade", study::trade(&study, true))?;
    lesson.save("trade_tests", study::trade(&study, false))?;
    lesson.save("orders", study::orders(&study))?;
    lesson.save("prices", study::prices(&study))?;
    lesson.save("ambient_over_albedo", pictures::ambient(sized(big))?)?;
    lesson.save("laws", pictures::laws(sized(big))?)?;
    let (at_the_eye, changed) = lamps::at_the_eye(sized(big))?;
    lesson.save("at_the_eye", at_the_eye)?;
    lesson.save("near_and_far", lamps::near_and_far(sized(big))?)?;
    lesson.save("parallel", edges::parallel())?;
    lesson.save("vacuum", vacuum.chart())?;
    lesson.save("overexposed", overexposed::panels(sized(shown * 3 / 2))?)?;
    lesson.save("examples", overexposed::examples()?)?;
    let cells = lesson.pick([12, 120, 180, 240]);
    lesson.save("clamp_map", overexposed::clamp_map(cells))?;
    lesson.save("printed_map", overexposed::printed_map(cells))?;
    lesson.save("hot_pixel", overexposed::hot_pixel(sized(width))?)?;
    lesson.save("horizon", edges::horizon(lesson.pick([4, 64, 256, 1024]), lesson.seed()))?;
    lesson.save("cases", edges::cases())?;

    // 4. What the figures show, checked.
    let difference = study::against_the_library(sized(width))?;
    debug_assert!(
        difference < 1.0e-14,
        "this lesson's integrator differs from the library's by {difference}"
    );
    lesson.say(&format!(
        "Where the library can do as much (2, 6 and 7 made), its picture differs from this lesson's by {difference:.0e} at most."
    ));
    let (image, _) = overexposed::pictures(sized(width))?;
    let [clamp, channels, one] = Way::ALL.map(|way| turns(&image, &way.apply(&image)));
    lesson.claim(
        &format!(
            "shadow rays to a lamp at the eye change {} pixels, to one half a metre beside it {}, to one aside {}: simplification 3 pays for 4",
            changed[1], changed[2], changed[0]
        ),
        changed[1] == 0 && changed[0] > 0,
    );
    lesson.claim(
        &format!(
            "in a vacuum nothing is lost on the way to the eye: a million times as far, the radiance changes by {:.0e}, less than rounding of the place explains",
            vacuum.worst()
        ),
        vacuum.holds() && vacuum.worst() < 1.0e-6,
    );
    lesson.claim(
        &format!(
            "three times overexposed, the clamp turns {:.0} % of the coloured pixels' hues by over 5°, division by own maxima {:.0} %, by one maximum none ({:.0e}° at most)",
            100.0 * clamp.2,
            100.0 * channels.2,
            one.1
        ),
        clamp.2 > 0.1 && channels.2 > 0.1 && one.1 < 1.0e-9,
    );
    lesson.answer(&answer(&study))
}

fn answer(study: &Study) -> String {
    let order = study.best_order();
    let of = |made: Made| study.of(made);
    let (all, eight, none) = (of(Made::ALL), of(order[8]), of(Made::NONE));
    let worst = study.worst_alone();
    let (worse, cases) = study.setbacks();
    format!(
        "Made alone, “{}” costs most, an error (RMSE) of {:.3}; “{}” saves most, {:.0} % of {:.0} shape tests a pixel. C's model needs {:.0} \
         tests and errs by {:.3}. Given up in the best order, eight of nine leave {:.4} for {:.1} tests; the ninth, “{}”, leaves {:.4} for {:.0}. \
         In {worse} of {cases} cases giving one up makes the picture worse. The tenth is exact in a vacuum.",
        SIMPLIFIED[worst - 1],
        of(Made::NONE.with(worst)).rmse,
        SIMPLIFIED[study.cheapest_alone() - 1],
        100.0 * (1.0 - of(Made::NONE.with(study.cheapest_alone())).tests / none.tests),
        none.tests,
        all.tests,
        all.rmse,
        eight.rmse,
        eight.tests,
        SIMPLIFIED[given_up(order[8], order[9]) - 1],
        none.rmse,
        none.tests
    )
}
