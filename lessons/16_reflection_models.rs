//! Lesson 16. Which reflection models create or lose light, where, and what does the exact one cost?
//!
//! Builds on:  03 (a light, a shadow and a first picture).
//! New here:   the BRDF with its sampler and its density; albedo and the white furnace; Fresnel's equations.
//! Notation:   wi, wo directions to light and viewer, n normal, h half vector; f the BRDF [1/sr]; α, m roughness; n exponent.
//! Predict:    A's cosine lobe with exponent 10 returns all light at normal incidence. How much at 60°, how much at 89°?
//! Figure:     16_reflection_models_furnace.svg, 16_reflection_models_spheres.svg

use lightbench::bsdf::{Blinn, BlinnScale, Brdf, CookTorrance, ParameterError, Phong};
use lightbench::measure::{Method, Series, log_spaced, sweep};
use lightbench_kit::lesson::{Lesson, LessonError, Result};

#[path = "16_reflection_models/charts.rs"]
mod charts;
#[path = "16_reflection_models/diagrams.rs"]
mod diagrams;
#[path = "16_reflection_models/dip.rs"]
mod dip;
#[path = "16_reflection_models/maps.rs"]
mod maps;
#[path = "16_reflection_models/models.rs"]
mod models;
#[path = "16_reflection_models/naive.rs"]
mod naive;
#[path = "16_reflection_models/speed.rs"]
mod speed;
#[path = "16_reflection_models/spheres.rs"]
mod spheres;
use models::{WHITE, contestants, view};
use speed::Sampler4;

const GRAZING: f64 = 75.0; // degrees: where sampling is compared
const ROUGHNESS: f64 = 0.2;
const REPETITIONS: u32 = 32; // an RMS over 32 runs scatters by 1/√64 ≈ 12 %

/// Every way to sample, with its measurements.
type Contest = Vec<(Method, Series)>;

fn main() -> Result {
    let lesson = Lesson::without_essay(16)?;
    let wrong = |e: ParameterError| LessonError(e.to_string());

    // 1. The truth: albedos by quadrature, with their error.
    let contestants = contestants().map_err(wrong)?;
    let steps = lesson.pick([9, 90, 180, 360]);
    let degrees: Vec<f64> = (0..=steps).map(|k| 89.9 * f64::from(k) / f64::from(steps)).collect();
    let furnace: Vec<(Method, Vec<(f64, f64)>)> = contestants
        .iter()
        .map(|(name, model)| {
            (name.clone(), degrees.iter().map(|d| (*d, model.albedo(view(*d)).value)).collect())
        })
        .collect();

    // 2. The contestants: four ways to sample one lobe; the fast forms against the exact ones; naive formulas.
    let lobe = CookTorrance::ggx(ROUGHNESS, WHITE).map_err(wrong)?;
    let (wo, truth) = (view(GRAZING), lobe.albedo(view(GRAZING)).value);
    let budgets = lesson.budgets(4..=12);
    let sampled: Contest = Sampler4::ALL
        .map(|way| {
            let model = lobe.sampled(way.facets());
            let mean = |samples: u32, run: u32| way.mean(&model, wo, samples, lesson.seed(), run);
            (way.method(), sweep(&budgets, REPETITIONS, truth, mean))
        })
        .into();
    let batch = (lesson.pick([2048, 16_384, 65_536, 262_144]), lesson.seed());
    let widths = log_spaced(0.01, 1.0, lesson.pick([3, 9, 13, 17]));
    let spread = speed::scatter(&widths, batch);
    let rivals = speed::rivals(lesson.pick([(64, 1), (512, 12), (1024, 18), (1024, 18)]), lesson.seed())
        .map_err(wrong)?;
    let cells = maps::naive_against_default(lesson.pick([10, 40, 80, 120]));

    // 3. The figures.
    diagrams::save(&lesson)?;
    lesson.save("furnace", charts::furnace(&furnace))?;
    lesson.save("cosine_lobe", charts::cosine_lobe(&degrees).map_err(wrong)?)?;
    lesson.save("as_printed", charts::as_printed(&degrees))?;
    lesson.save("fresnel", charts::fresnel())?;
    lesson.save("reciprocity", charts::reciprocity(&contestants, lesson.seed()))?;
    for (name, map) in maps::furnaces(lesson.pick([4, 36, 72, 120])).map_err(wrong)? {
        lesson.save(name, map)?;
    }
    dip::save(&lesson)?;
    lesson.save("sampling", charts::sampling(&sampled, &lobe))?;
    lesson.save("scatter", charts::scatter(&spread))?;
    lesson.save("approximations", charts::approximations(&rivals))?;
    lesson.save("approximations_table", charts::approximations_table(&rivals))?;
    lesson.save("naive", cells.naive_map())?;
    lesson.save("naive_default", cells.default_map())?;
    lesson.save("exponent", charts::exponent(&naive::over_exponents()))?;
    spheres::save(&lesson)?;

    // 4. What the figures show, checked.
    claims(&lesson, &cells).map_err(wrong)?;
    lesson.answer(&answer(&furnace, &spread))
}

fn claims(lesson: &Lesson, cells: &maps::Cells) -> std::result::Result<(), ParameterError> {
    let most = |scale: BlinnScale| {
        let all =
            log_spaced(1.0, 1.0e4, 9).into_iter().flat_map(|n| (0..18).map(move |k| (n, f64::from(k) * 5.0)));
        let of =
            |(n, degrees): (f64, f64)| Blinn::new(n).map(|b| b.scaled(scale).albedo(view(degrees)).value);
        all.map(of).try_fold(0.0f64, |m, a| a.map(|a| m.max(a)))
    };
    let (usual, exact) = (most(BlinnScale::Eighth)?, most(BlinnScale::Exact)?);
    lesson.claim(
        &format!("Blinn's lobe times (n + 8)/8π returns up to {:.1} % of the light, times the exact scale never over 100 %, at 162 pairs of exponent and angle.", 100.0 * usual),
        usual > 1.01 && exact <= 1.0 + 1.0e-8,
    );
    let lobe = Phong::new(10.0)?;
    let share = |degrees: f64| 100.0 * lobe.albedo(view(degrees)).value;
    let shares = [share(0.0), share(60.0), share(89.0)];
    lesson.claim(
        &format!(
            "A's cosine lobe, n = 10, returns {:.1} % at 0°, {:.1} % at 60°, {:.1} % at 89°.",
            shares[0], shares[1], shares[2]
        ),
        (shares[0] - 100.0).abs() < 1.0e-6
            && (shares[1] - 50.5).abs() < 0.1
            && (shares[2] - 13.0).abs() < 1.0,
    );
    lesson.claim(
        &format!(
            "GGX typed from the cosine errs by over 1 % on {:.0} % of the map; the default by at most {:.0} roundings of its vectors.",
            100.0 * cells.naive_share(),
            cells.default_roundings()
        ),
        cells.naive_share() > 0.1 && cells.default_roundings() < 32.0,
    );
    Ok(())
}

fn answer(furnace: &[(Method, Vec<(f64, f64)>)], spread: &[(Method, Series)]) -> String {
    let albedos = |k: usize| furnace[k].1.iter().map(|p| p.1);
    let least = |k: usize| 100.0 * albedos(k).fold(f64::INFINITY, f64::min);
    let most = |k: usize| 100.0 * albedos(k).fold(0.0, f64::max);
    let at = |k: usize| spread[k].1.points.first().and_then(|p| p.error).map_or(f64::NAN, |e| e.mid);
    format!(
        "Blinn's usual scale and the rough matt model create light (up to {:.0} % and {:.1} % return); cosine lobes lose all but \
         {:.0} % towards grazing, facets at roughness 0.5 keep {:.0} %. At roughness 0.01 a sample of the facets that are seen \
         scatters by {:.3} of the mean, of all facets by {:.2}, of the cosine by {:.0}.",
        most(2),
        most(0),
        least(1),
        least(4),
        at(3),
        at(2),
        at(1),
    )
}
