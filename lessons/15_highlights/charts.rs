//! Charts of lesson 15: the family of powers, W(θ), exponents that answer each other, attenuation.

use super::off_plane::Sky;
use lightbench::bsdf::highlight::{Match, grazing_coefficient, mismatch};
use lightbench::light::{Attenuation, LightError};
use lightbench::measure::{Method, log_spaced};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, grouped};
use std::f64::consts::{LN_2, PI};

fn over(count: u32, low: f64, high: f64, f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let at = |k: u32| low + (high - low) * f64::from(k) / f64::from(count);
    (0..=count).map(|k| (at(k), f(at(k)))).collect()
}

fn angle(title: &str) -> Axis {
    Axis::linear(title).range(0.0, 90.0).every(15.0)
}

/// Degrees from the peak where half is left.
fn half_width(n: f64) -> f64 {
    0.5f64.powf(1.0 / n).acos().to_degrees()
}

/// [C fig. 28].
pub fn family() -> Figure {
    let mut chart =
        Chart::new(angle("angle φ between V and R, degrees"), Axis::linear("cosⁿ φ").range(0.0, 1.1))
            .title(&format!(
                "Half of the peak is left at 60° for n = 1, at {:.1}° for n = 20, at {:.1}° for n = 1000",
                half_width(20.0),
                half_width(1000.0)
            ))
            .subtitle("every hundredfold exponent makes a highlight a tenth as wide: φ½ ≈ √(2 ln 2/n)")
            .guide(Guide::level(0.5, "half"));
    for (style, n) in [1.0, 5.0, 20.0, 100.0, 1000.0].into_iter().enumerate() {
        let points = over(900, 0.0, 90.0, |d| d.to_radians().cos().max(0.0).powf(n));
        chart = chart.function(Method::new(&format!("n = {n}")).styled(style), &points);
    }
    Figure::from(chart).caption("The behaviour of cosⁿ φ, after C, figure 28.")
}

/// [C (23)]: a coefficient that depends on the angle, and a constant with the same mean.
pub fn coefficient() -> Figure {
    const LEAST: f64 = 0.04;
    // ∫ (1 − cos θ)^p 2 cos θ sin θ dθ = 2/((p + 1)(p + 2)).
    let mean = |p: f64| LEAST + (1.0 - LEAST) * 2.0 / ((p + 1.0) * (p + 2.0));
    let w = |p: f64| move |d: f64| grazing_coefficient(LEAST, p, d.to_radians().cos());
    let constant = mean(5.0);
    let chart = Chart::new(angle("angle of incidence θ, degrees"), Axis::percent("share of the light in the highlight's peak").range(0.0, 1.05))
        .title(&format!(
            "A constant with the right mean is {:.1} times W(θ) from the front, and {:.0} times too small at 85°",
            constant / w(5.0)(0.0),
            w(5.0)(85.0) / constant
        ))
        .subtitle(&format!("W = 0.04 + 0.96 (1 − cos θ)^{{p}}; the constant Kₑ = {constant:.4} is the mean of p = 5 over a sky of even light"))
        .function(Method::new("W(θ), p = 5: like glass").styled(0), &over(360, 0.0, 90.0, w(5.0)))
        .function(Method::new("W(θ), p = 2").styled(2), &over(360, 0.0, 90.0, w(2.0)))
        .function(Method::new("Kₑ: constant").styled(1), &over(2, 0.0, 90.0, |_| constant));
    Figure::from(chart).caption(
        "C's (23) lets the highlight grow towards grazing light by a function W(θ), from near 0 to 1 for glass, and (24) replaces it by a constant \
         Kₑ. The text gives no W; this one is ours. Metals come closer to a constant.",
    )
}

/// [C fig. 31], as a chart.
pub fn compensation() -> Figure {
    let n = 10.0;
    let best = Match::LeastSquares.exponent(n);
    let of = |m: f64, share: f64| over(360, 0.0, 90.0, move |d| (d.to_radians() * share).cos().powf(m));
    let at = |m: f64, share: f64| (40f64.to_radians() * share).cos().powf(m);
    let chart = Chart::new(angle("angle φ between V and R, degrees"), Axis::linear("highlight, peak 1").range(0.0, 1.1))
        .title(&format!(
            "At 40°, n = 10, the half vector makes {:.3} where Phong has {:.3}; with 4n it makes {:.3}, with {best:.1} {:.3}",
            at(n, 0.5),
            at(n, 1.0),
            at(4.0 * n, 0.5),
            at(best, 0.5)
        ))
        .subtitle("light, viewer and normal in one plane; C prints (cos φ/2)ⁿ < (cos φ)ⁿ, which is the other way round")
        .guide(Guide::upright(40.0, ""))
        .function(Method::new("(R·V)ⁿ").styled(0), &of(n, 1.0))
        .function(Method::new("(N·H)ⁿ").styled(4), &of(n, 0.5))
        .function(Method::new("(N·H)⁴ⁿ").styled(2), &of(4.0 * n, 0.5))
        .function(Method::new(&format!("(N·H)^{{{best:.1}}}: least squares")).styled(3), &of(best, 0.5));
    Figure::from(chart).caption(
        "Compensating the exponent, after C, figure 31. The half vector turns half as fast, so that the same exponent makes a highlight twice as wide. \
         The exponent must be about four times as large: C says larger, not how much.",
    )
}

/// How far from 4n four answers are.
pub fn exponents() -> Figure {
    let ns = log_spaced(0.1, 1.0e4, 61);
    let mut chart = Chart::new(
        Axis::log("exponent n of R·V").range(0.1, 1.0e4),
        Axis::linear("exponent of N·H, less 4n").range(-0.25, 2.5),
    )
    .title(
        "All answers are 4n and something: 0 by curvature, ln 2 by half width, 3/2 by squares, 2 by energy",
    )
    .subtitle(
        "light along the normal, where φ = 2β for every viewer; half width: m = n ln cos φ½ / ln cos(φ½/2)",
    );
    let names = ["same curvature", "same half width", "least squares", "same energy"];
    for (k, (way, name)) in Match::ALL.into_iter().zip(names).enumerate() {
        let points: Vec<_> = ns.iter().map(|n| (*n, way.exponent(*n) - 4.0 * n)).collect();
        chart = chart.function(Method::new(name).styled([1, 5, 0, 2][k]), &points);
    }
    for (level, name) in [(LN_2, "ln 2"), (1.5, "3/2"), (2.0, "2")] {
        chart = chart.guide(Guide::level(level, name));
    }
    let apart = Match::Energy.exponent(10.0) / Match::Peak.exponent(10.0) - 1.0;
    Figure::from(chart).caption(&format!(
        "Which exponent of the half vector answers n. What is left out of 4n is the same constant for all sharp highlights, and matters for blunt \
         ones only: at n = 10 the ways are {:.0} % apart.",
        100.0 * apart
    ))
}

/// What no exponent mends.
pub fn residual(skies: &[(f64, Vec<(f64, f64)>)]) -> Figure {
    let ns = log_spaced(1.0, 1.0e4, 41);
    let of = |m: &dyn Fn(f64) -> f64| ns.iter().map(|n| (*n, mismatch(*n, m(*n)))).collect::<Vec<_>>();
    let best = |n: f64| Match::LeastSquares.exponent(n);
    let last = |k: usize| skies[k].1.last().map_or(f64::NAN, |p| p.1);
    let mut chart = Chart::new(
        Axis::log("exponent n of R·V").range(1.0, 1.0e4),
        Axis::log("difference of the lobes, relative (root mean square)").range(1.0e-5, 4.0),
    )
    .title(&format!(
        "In the plane the difference falls as 1/n; off it {:.0} % stay at 45° and {:.0} % at 75°, whatever the exponent",
        100.0 * last(0),
        100.0 * last(1)
    ))
    .subtitle("over the solid angle about R, in units of the lobe of R·V; “in the plane”: light along the normal")
    .guide(Guide::slope_through(-1.0, 1.0e3, 0.375f64.sqrt() / 4.0e3, "0.153/n"))
    .function(Method::new("same exponent n").styled(4), &of(&|n| n))
    .function(Method::new("4n, in the plane").styled(2), &of(&|n| 4.0 * n))
    .function(Method::new("best, in the plane").styled(0), &of(&best));
    for (k, (degrees, points)) in skies.iter().enumerate() {
        let method = Method::new(&format!("best, light at {degrees:.0}°")).styled([3, 1][k % 2]);
        chart = chart.function(method, points);
    }
    Figure::from(chart).caption(
        "What is left between Phong's and Blinn's highlight when the exponent has been compensated. With light, viewer and normal in one plane the \
         shapes agree for sharp lobes. Out of the plane φ = 2β does not hold: the highlight is narrower across, by cos θ, and no exponent turns an \
         ellipse into a circle.",
    )
}

pub fn skies(side: usize) -> Vec<(f64, Vec<(f64, f64)>)> {
    let ns = log_spaced(1.0, 1.0e4, if side < 32 { 4 } else { 17 });
    let best = |degrees: f64, n: f64| Sky::new(degrees, n, side).best().1;
    [45.0, 75.0].map(|d| (d, ns.iter().map(|n| (*n, best(d, *n))).collect())).into()
}

/// Every law of attenuation that the documents print, with its place.
pub fn laws() -> Result<[(&'static str, Attenuation, f64); 6], LightError> {
    let polynomial = Attenuation::polynomial;
    Ok([
        ("1/d [A (4.1)]", polynomial([0.0, 1.0, 0.0])?, 1.0),
        ("1/d² [A (4.2), C]", Attenuation::InverseSquare, 1.0),
        ("min(1, 1/d²) [A ill. 67]", Attenuation::InverseSquare.capped(1.0), 1.0),
        ("1/(1 + d/2 + d²/4) [A (4.3), C]", polynomial([1.0, 0.5, 0.25])?, 1.0),
        ("1/(d + ½) [C]", polynomial([0.5, 1.0, 0.0])?, 1.0),
        ("1/(4π d²) [B §7.3]", Attenuation::InverseSquare, 0.25 / PI),
    ])
}

pub fn attenuation() -> Result<Figure, LightError> {
    let distances = log_spaced(0.05, 50.0, 121);
    let mut chart = Chart::new(
        Axis::log("distance d, m").range(0.05, 50.0),
        Axis::log("factor that the light is multiplied by").range(1.0e-4, 400.0),
    );
    for (k, (name, law, scale)) in laws()?.into_iter().enumerate() {
        let points: Vec<_> = distances.iter().map(|d| (*d, scale * law.factor(*d))).collect();
        chart = chart.function(Method::new(name).styled(k), &points);
    }
    let [near, far] = [0.1, 10.0].map(|d| Attenuation::InverseSquare.factor(d));
    let (polynomial, sum) = (laws()?[3].1, laws()?[4].1);
    let chart = chart
        .title(&format!(
            "Between 0.1 and 10 m light falls {} times; the laws made for the eye, {:.0} and {:.0} times",
            grouped((near / far).round() as u64),
            polynomial.factor(0.1) / polynomial.factor(10.0),
            sum.factor(0.1) / sum.factor(10.0)
        ))
        .subtitle("all laws of A §4.1 and ill. 67, B §7.3.2, C §1.8.3 D, as this library has them; a slope of −2 is what geometry does")
        .guide(Guide::level(1.0, "no attenuation [D]"));
    Ok(Figure::from(chart).caption(
        "Attenuation over distance. Only 1/d² is light that spreads over spheres; B's is the same law with the flux spread over 4π. The sums stay \
         finite at the lamp; so does A's cap, with a kink at 1 m, wherever that is in the scene.",
    ))
}

/// [B 7.19].
pub fn inverse_square() -> Figure {
    let flux = 4.0 * PI; // W: 1 W/m² at 1 m
    let e = |d: f64| flux * 0.25 / PI * Attenuation::InverseSquare.factor(d);
    let (half, tenth) = (2f64.sqrt(), 10f64.sqrt());
    let chart = Chart::new(
        Axis::linear("distance r, m").range(0.0, 6.0).every(1.0),
        Axis::linear("irradiance of a facing surface, W/m²").range(0.0, 4.0),
    )
    .title(&format!(
        "Twice as far is a quarter: from 1 m on half is left at {half:.2} m, a tenth at {tenth:.2} m"
    ))
    .subtitle("E = Φ/(4π r²), Φ = 4π W = 12.57 W, so that 1 W/m² arrives at 1 m")
    .function(Method::new("Φ/(4π r²)").styled(0), &over(600, 0.5, 6.0, e));
    Figure::from(chart).caption("The profile of attenuation by the inverse square, after B, 7.19.")
}
