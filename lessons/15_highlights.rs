//! Lesson 15. Which formula for a highlight is worth its time, and what do the others get wrong?
//!
//! Builds on:  13 (Lambert's law and ambient light).
//! New here:   Phong's and Blinn's highlights; exponents that answer each other; W(θ); light and viewer at infinity; fast
//!             powers; the laws of attenuation.
//! Notation:   N normal, L to the light, V to the viewer, R mirror direction of L, H half-way between L and V; φ between V and
//!             R, β between N and H, θ of the light with N; n exponent of R·V, m that of N·H.
//! Predict:    H turns half as fast as R. By what factor must the exponent grow, so that the highlight keeps its size?
//! Figure:     15_highlights_powers_time.svg, 15_highlights_residual.svg, 15_highlights_infinity.svg

use lightbench::bsdf::highlight::{Match, mismatch};
use lightbench::light::LightError;
use lightbench::measure::{Method, Series};
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, LessonError, Result};

#[path = "15_highlights/charts.rs"]
mod charts;
#[path = "15_highlights/diagrams.rs"]
mod diagrams;
#[path = "15_highlights/infinity.rs"]
mod infinity;
#[path = "15_highlights/off_plane.rs"]
mod off_plane;
#[path = "15_highlights/pictures.rs"]
mod pictures;
#[path = "15_highlights/powers.rs"]
mod powers;
#[path = "15_highlights/printed.rs"]
mod printed;

const EXPONENT: u32 = 50; // of the contest between powers
const ASIDE: f64 = 60.0; // degrees, where the shapes of the highlights are compared

/// Ways to raise a cosine, with their measurements.
type Contest = Vec<(Method, Series)>;

fn main() -> Result {
    let lesson = Lesson::without_essay(15)?;
    let wrong = |e: LightError| LessonError(e.to_string());
    let seed = lesson.seed();

    // 1. The truth: for a power, the angle between V and R; for N·H, R·V; for constant vectors, those of each place.
    // 2. The contestants: ways to raise a cosine, exponents of N·H, constant H.
    let contest = powers::contest(EXPONENT, lesson.pick([256, 2048, 8192, 8192]), seed);
    let over = lesson.pick([(64, 6), (1024, 22), (4096, 43), (16_384, 85)]);
    let exponents = powers::over_exponents(over.0, over.1, seed);
    let side = lesson.pick([12, 48, 64, 96]);
    let skies = charts::skies(side);
    let infinity =
        infinity::contest(lesson.pick([400, 4000, 20_000, 20_000]), lesson.pick([6, 21, 21, 41]), seed);
    let maps = powers::maps(lesson.pick([12, 96, 144, 192]), seed);

    // 3. The figures: the vectors, the family, what exponents can do and cannot, time, failures, pictures.
    diagrams::save(&lesson)?;
    lesson.save("family", charts::family())?;
    lesson.save("coefficient", charts::coefficient())?;
    lesson.save("compensation", charts::compensation())?;
    lesson.save("exponents", charts::exponents())?;
    lesson.save("residual", charts::residual(&skies))?;
    lesson.save(
        "off_plane",
        off_plane::difference(ASIDE, f64::from(EXPONENT), lesson.pick([16, 100, 160, 240])),
    )?;
    lesson.save("off_plane_least", off_plane::least(lesson.pick([8, 40, 64, 96]), side.min(32)))?;
    lesson.save("powers", powers::speed(&contest, EXPONENT))?;
    lesson.save("powers_exponent", powers::exponents(&exponents))?;
    for (name, map, _) in &maps {
        lesson.save(name, map.clone())?;
    }
    lesson.save("infinity", infinity.error())?;
    lesson.save("infinity_saved", infinity.speed())?;
    lesson.save("infinity_work", infinity.work())?;
    lesson.save("attenuation", charts::attenuation().map_err(wrong)?)?;
    lesson.save("inverse_square", charts::inverse_square())?;
    lesson.save("printed_table", printed::table())?;
    pictures::save(&lesson)?;

    // 4. What the figures show, checked.
    let aside = claims(&lesson, &infinity, side);
    lesson.answer(&answer(&contest, &infinity, aside))
}

/// Checks the claims; the share that the best exponent leaves of a highlight at [`ASIDE`].
fn claims(lesson: &Lesson, infinity: &infinity::Contest, side: usize) -> f64 {
    let n = f64::from(EXPONENT);
    let best = Match::LeastSquares.exponent(n);
    let [same, four, least] = [n, 4.0 * n, best].map(|m| mismatch(n, m));
    lesson.claim(
        &format!(
            "in the plane of light and normal the exponent {best:.1} = 4n + {:.2} of N·H leaves {:.2} % of the highlight n = {n}, 4n leaves {:.2} %, n itself {:.0} %",
            best - 4.0 * n,
            100.0 * least,
            100.0 * four,
            100.0 * same
        ),
        (best - 4.0 * n - 1.5).abs() < 0.02 && least < four && least < 0.005 && same > 0.5,
    );
    let (m, aside) = off_plane::Sky::new(ASIDE, n, side).best();
    lesson.claim(
        &format!(
            "with light at {ASIDE:.0}° the best exponent, {:.2} n, leaves {:.0} %: the shapes differ",
            m / n,
            100.0 * aside
        ),
        aside > 0.2 && m < 4.0 * n,
    );
    let slope = infinity.slope();
    lesson.claim(
        &format!("a constant H errs as 1/distance: slope {:.3} from 30 radii on", slope.value),
        (slope.value + 1.0).abs() < 0.05,
    );
    aside
}

fn answer(contest: &Contest, infinity: &infinity::Contest, aside: f64) -> String {
    let error = |k: usize| contest[k].1.points[0].error.map_or(f64::NAN, |e| e.mid);
    let (d, constant) = infinity.at(30.0);
    format!(
        "Phong's power, from 1 − cos φ: error {}, where a quotient errs by {:.0} % of the peak. N·H needs the exponent 4n + 3/2, and has another shape \
         for slanting light ({:.0} % at 60°, whatever the exponent); taken as constant it errs by {:.0} % from {d:.0} radii away. A's words shine back at \
         the lamp; its code shines in shadows.",
        short(error(0)),
        100.0 * error(4),
        100.0 * aside,
        100.0 * constant,
    )
}
