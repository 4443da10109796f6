//! Where Oren and Nayar's full model is negative, and what ending at 0 adds.

use super::view;
use lightbench::bsdf::{Angles, Brdf, OrenNayar, OrenNayarForm, ParameterError};
use lightbench::measure::Method;
use lightbench::num::quadrature::integrate;
use lightbench_kit::figure::{Axis, Chart, FailureMap, Figure, Shades, short};
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use std::f64::consts::{FRAC_PI_2, PI};

/// Reflectance of dark matter: charcoal.
const DARK: f64 = 0.05;
/// Standard deviations of slopes [rad]: of the map, and of the chart's lines.
const SLOPES: std::ops::Range<f64> = 0.0..1.5;
const LINES: [f64; 4] = [0.75, 1.0, 1.25, 1.5];
/// The largest angle of the chart [degrees].
const LAST: f64 = 89.9;

fn dark(sigma: f64) -> std::result::Result<OrenNayar, ParameterError> {
    OrenNayar::new(DARK, sigma, OrenNayarForm::Full)
}

/// What ending at 0 adds to the albedo towards `degrees`.
///
/// Behind the normal, where cos φ < 0, the model is `p + q cos φ`. Where `q > p > 0` it is negative for azimuths from
/// `φ₀ = acos(−p/q)` to `2π − φ₀`, and misses 0 there by `2 (q sin φ₀ − p (π − φ₀))` in all.
fn added(model: &OrenNayar, degrees: f64) -> f64 {
    let theta_o = degrees.to_radians();
    let at = |theta_i: f64, phi: f64| model.value(&Angles::new(theta_i, theta_o, phi));
    let below = |theta_i: f64| {
        let p = at(theta_i, FRAC_PI_2);
        let q = p - at(theta_i, PI);
        if q <= p {
            return 0.0;
        }
        let from = (-p / q).acos();
        let (sin, cos) = theta_i.sin_cos();
        2.0 * (q * from.sin() - p * (PI - from)) * sin * cos
    };
    integrate(below, &[0.0, theta_o, FRAC_PI_2], 1.0e-10).value
}

pub fn save(lesson: &Lesson) -> Result {
    let wrong = |e: ParameterError| LessonError(e.to_string());
    lesson.save("dip", map(lesson.pick([12, 60, 90, 120])))?;
    lesson.save("dip_clamped", clamped(lesson.pick([18, 60, 120, 240])).map_err(wrong)?)
}

/// How far the model lies below 0, seen from as low as the light stands, on the other side.
fn map(columns: usize) -> Figure {
    let angle =
        Axis::linear("angle of light and of view with the normal, degrees").range(45.0, 90.0).every(15.0);
    let slopes = Axis::linear("standard deviation of slopes σ, rad").range(SLOPES.start, SLOPES.end);
    let mut least = 0.0f64;
    let below = |degrees: f64, sigma: f64| {
        let theta = degrees.to_radians();
        let value = dark(sigma).ok()?.value(&Angles::new(theta, theta, PI)) * PI / DARK;
        least = least.min(value);
        Some(if value < 0.0 { -value } else { 0.0 })
    };
    let map = FailureMap::new(angle, slopes, "below 0, of ρ/π", (columns, columns * 3 / 4), below)
        .shades(Shades::Linear)
        .failing_above(0.0, "negative");
    let title = format!(
        "Oren and Nayar's full model is negative on {:.0} % of the map, down to {:.2} of a matt surface's value",
        100.0 * map.failing_share(),
        least
    )
    .replace('-', "−");
    let map = map.title(&title).subtitle(&format!(
        "dark matter, ρ = {DARK}; light and view opposite each other; how far the published number lies below 0"
    ));
    Figure::from(map).caption(
        "The published fit subtracts (2β/π)³ from sin α behind the normal. Towards grazing that difference falls as the tangent \
         beside it grows, and the product ends at 6/π times B: more than A from σ = 0.66 on. Light that is reflected twice \
         lifts bright matter over 0, but not dark.",
    )
}

/// What ending at 0 adds to the albedo, over the angle of view.
fn clamped(steps: u32) -> std::result::Result<Figure, ParameterError> {
    let mut chart = Chart::new(
        Axis::linear("angle of view θₒ, degrees").range(0.0, 90.0).every(15.0),
        Axis::percent("share of the albedo that ending at 0 adds"),
    );
    let mut most = (0.0, 0.0, 0.0);
    for (style, sigma) in LINES.into_iter().enumerate() {
        let model = dark(sigma)?;
        let share = |k: u32| {
            let degrees = LAST * f64::from(k) / f64::from(steps);
            (degrees, added(&model, degrees) / model.albedo(view(degrees)).value)
        };
        let points: Vec<(f64, f64)> = (0..=steps).map(share).collect();
        for (degrees, share) in &points {
            if *share > most.0 {
                most = (*share, *degrees, sigma);
            }
        }
        chart = chart.function(Method::new(&format!("σ = {}", short(sigma))).styled(style), &points);
    }
    let title = format!(
        "Ended at 0 the dark model returns at most {:.2} % more light than published, at σ = {} and {:.0}°",
        100.0 * most.0,
        short(most.2),
        most.1
    );
    Ok(Figure::from(chart.title(&title).subtitle(&format!(
        "full model, ρ = {DARK}; added light over the albedo of the published number, by quadrature"
    )))
    .caption(
        "The published number below 0 takes light away that never came. A renderer cannot draw it and ends at 0; the albedo by \
         formula counts the dip, and is less than what is drawn by this share.",
    ))
}
