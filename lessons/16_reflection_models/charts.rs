//! Charts and tables of lesson 16.

use super::speed::Rival;
use super::{Contest, view};
use lightbench::bsdf::{Brdf, CookTorrance, Model, ParameterError, Phong, PhongScale, as_printed, mirror};
use lightbench::fresnel::{conductor, dielectric, normal_incidence, schlick, schlick_between};
use lightbench::measure::{Method, Series};
use lightbench::sample::{Sampler, uniform_hemisphere};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};
use std::f64::consts::FRAC_1_PI;

type Curve = (Method, Vec<(f64, f64)>);

fn angle(title: &str) -> Axis {
    Axis::linear(title).range(0.0, 90.0).every(15.0)
}

/// The headline: what comes back of a white sky.
pub fn furnace(curves: &[Curve]) -> Figure {
    let at = |k: usize, near: f64| {
        let (_, points) = &curves[k];
        points
            .iter()
            .min_by(|a, b| (a.0 - near).abs().total_cmp(&(b.0 - near).abs()))
            .map_or(f64::NAN, |p| 100.0 * p.1)
    };
    let mut chart = Chart::new(angle("angle of view θₒ, degrees"), Axis::percent("albedo: share of a white sky that comes back").range(0.0, 1.3))
        .title(&format!(
            "Lobes lose light towards grazing (Phong's keeps {:.0} % at 75°), facets between each other; (n + 8)/8π creates {:.0} %",
            at(1, 75.0),
            at(2, 0.0) - 100.0
        ))
        .subtitle("white surfaces in a white furnace, by adaptive quadrature to 10⁻⁸")
        .guide(Guide::level(1.0, "all of it"));
    for (method, points) in curves {
        chart = chart.function(method.clone(), points);
    }
    Figure::from(chart).caption(
        "Albedo over the angle of view: a white sky, and nothing absorbed. Where a line exceeds 100 % the model creates light; where it \
         falls short light has been lost below the horizon (lobes) or between facets, which send it to each other. The facets never create.",
    )
}

/// [A (4.7)] over angle and exponent.
pub fn cosine_lobe(degrees: &[f64]) -> Result<Figure, ParameterError> {
    let mut chart =
        Chart::new(angle("angle of incidence, degrees"), Axis::percent("albedo").range(0.0, 1.15))
            .subtitle("f = (n + 2)/2π · cosⁿ a, A (4.7); it was meant to return all light at every angle")
            .guide(Guide::level(1.0, "as meant"));
    let ten = |d: f64| Phong::new(10.0).map(|p| 100.0 * p.albedo(view(d)).value);
    for (style, n) in [1.0, 10.0, 100.0, 1000.0, 1.0e6].into_iter().enumerate() {
        let lobe = Phong::new(n)?;
        let points: Vec<(f64, f64)> = degrees.iter().map(|d| (*d, lobe.albedo(view(*d)).value)).collect();
        chart = chart.function(Method::new(&format!("n = {}", short(n))).styled(style), &points);
    }
    let title = format!(
        "A's cosine lobe keeps its energy at normal incidence only: n = 10 returns {:.1} % at 60°, {:.0} % at 89°",
        ten(60.0)?,
        ten(89.0)?
    );
    Ok(Figure::from(chart.title(&title)).caption(
        "Energy of the normalised cosine lobe. It is scaled for a lobe about the normal; tilted, part of it falls below the horizon, and the \
         rest meets a smaller cosine. A sharp lobe follows the cosine itself.",
    ))
}

/// [A (4.5), (4.6)]: what leaves a surface under a lamp, as printed and right.
pub fn as_printed(degrees: &[f64]) -> Figure {
    let over = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        degrees.iter().map(|d| (*d, f(d.to_radians().cos()))).collect()
    };
    let chart = Chart::new(
        angle("angle of the light with the normal, degrees"),
        Axis::linear("radiance that leaves, W/(m² sr)").range(0.0, 1.1),
    )
    .title("A's “Lambertian” lacks the cosine, its “Phong” lacks ρ/π; matt is their product")
    .subtitle("ρ = c₁ = 1; a lamp that gives 1 W/m² to a facing surface")
    .function(Method::as_printed("as printed, (4.6): cos(u, n)"), &over(&as_printed::phong_as_printed))
    .function(
        Method::as_printed("as printed, (4.5): c₁/π"),
        &over(&|_| as_printed::lambertian_as_printed(1.0)),
    )
    .function(Method::default_of("ρ/π · cos θ").styled(0), &over(&|c| FRAC_1_PI * c));
    Figure::from(chart).caption(
        "A's first two formulas. (4.5) is the BRDF of a matt surface and no intensity: the cosine belongs to the transport. (4.6) is that \
         cosine, called Phong; taken for a BRDF it would return 2π/3 = 209 % of the light.",
    )
}

/// Exact reflectances and Schlick's.
pub fn fresnel() -> Figure {
    let over = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=360).map(|k| f64::from(k) * 0.25).map(|d| (d, f(d.to_radians().cos()))).collect()
    };
    let f0 = normal_incidence(1.5, 1.0);
    let gold = conductor(0.143, 3.983, 1.0).mean();
    let inner = 40f64.to_radians().cos();
    let (exact, wrong) = (dielectric(1.5, 1.0, inner).mean(), schlick(f0, 1.0 - inner));
    let chart = Chart::new(angle("angle of incidence, degrees"), Axis::percent("reflectance").range(0.0, 1.1))
        .title(&format!(
            "Schlick's curve is close, but leaving glass it must take the outer angle: at 40° inside {:.1} % instead of {:.1} %",
            100.0 * wrong,
            100.0 * exact
        ))
        .subtitle("light without polarisation; glass 1.5, gold 0.143 + 3.983 i (red)")
        .function(Method::default_of("into glass").styled(0), &over(&|c| dielectric(1.0, 1.5, c).mean()))
        .function(
            Method::new("Schlick, by the angle on this side").styled(1),
            &over(&|c| schlick(f0, 1.0 - c)),
        )
        .function(Method::new("out of glass").styled(2), &over(&|c| dielectric(1.5, 1.0, c).mean()))
        .function(Method::new("out of glass, Schlick by the outer angle").styled(5), &over(&|c| schlick_between(1.5, 1.0, c)))
        .function(Method::new("gold").styled(4), &over(&|c| conductor(0.143, 3.983, c).mean()))
        .function(Method::new("gold, Schlick").styled(3), &over(&|c| schlick(gold, 1.0 - c)));
    Figure::from(chart).caption(
        "Fresnel's reflectances and Schlick's approximation. Inside the denser medium the angle that counts is the one outside: then Schlick is \
         within a few per cent, and total reflection begins where it should, at 41.8°.",
    )
}

/// Largest and typical differences between there and back.
pub fn reciprocity(contestants: &[(Method, Model)], seed: u64) -> Figure {
    let printed: [(Method, Model); 2] = [
        (Method::as_printed("(4.6) as printed, as a BRDF"), lightbench::bsdf::CosinePrinted.into()),
        (Method::new("Phong of 1975, over the cosine"), over_cosine()),
    ];
    let pairs: Vec<_> = (0..4000u32)
        .map(|i| {
            let mut s = Sampler::new(seed, 2, i);
            let (wo, any) = (uniform_hemisphere(s.next_2d()), uniform_hemisphere(s.next_2d()));
            (if i.is_multiple_of(2) { (mirror(wo) + any * 0.5).normalize() } else { any }, wo)
        })
        .collect();
    let mut table = Table::new(&["Model", "claims", "largest difference", "median"])
        .subtitle("|f(wi, wo) − f(wo, wi)| over the larger; 4000 pairs, every second one in the highlight");
    let mut worst: f64 = 0.0;
    for (method, model) in printed.iter().chain(contestants) {
        let mut found: Vec<f64> = pairs
            .iter()
            .map(|(wi, wo)| (model.eval(*wi, *wo), model.eval(*wo, *wi)))
            .map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() / a.max(b) })
            .collect();
        found.sort_by(f64::total_cmp);
        worst = if model.is_reciprocal() { worst.max(found[found.len() - 1]) } else { worst };
        let claims = if model.is_reciprocal() { "reciprocal" } else { "nothing" };
        table = table.row(&[
            &method.name,
            claims,
            &short(found[found.len() - 1]),
            &short(found[found.len() / 2]),
        ]);
    }
    let how = if worst == 0.0 { "to the last bit".to_string() } else { format!("to {}", short(worst)) };
    let table = table.title(&format!("All models but two read the same both ways, {how}"));
    Figure::from(table).caption(
        "Helmholtz's reciprocity: light may be traced backwards only if a model reads the same both ways. A's (4.6) and Phong's formula of 1975 \
         do not, once they are read as BRDFs.",
    )
}

/// Phong's shading without cosine; a fixed exponent cannot fail.
fn over_cosine() -> Model {
    let lobe = Phong::new(10.0).map(|p| Model::from(p.scaled(PhongScale::OverCosine)));
    lobe.unwrap_or(lightbench::bsdf::CosinePrinted.into())
}

fn lines(mut chart: Chart, contest: &Contest) -> Chart {
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    chart
}

fn last_error(series: &Series) -> f64 {
    series.points.last().and_then(|p| p.error).map_or(f64::NAN, |e| e.mid)
}

/// Error of the albedo against time, for four ways to sample.
pub fn sampling(contest: &Contest, lobe: &CookTorrance) -> Figure {
    let (cosine, seen) = (last_error(&contest[1].1), last_error(&contest[3].1));
    let chart = Chart::speed_accuracy("relative error of the albedo (root mean square)")
        .x(Axis::time("time per estimate"))
        .title(&format!(
            "Sampling the facets that are seen errs {:.0} times less than the cosine with as many samples",
            cosine / seen
        ))
        .subtitle(&format!(
            "GGX, α = 0.2, seen from 75°; 32 runs a budget; truth {:.6} by quadrature",
            lobe.albedo(view(75.0)).value
        ))
        .guide(Guide::slope(-0.5, "slope −½"));
    Figure::from(lines(chart, contest)).caption(
        "Speed against accuracy of Monte Carlo: the albedo of one narrow lobe. All lines fall with the root of the time; what sets them apart is \
         the scatter of one sample, and a sampler that knows the lobe pays its own time back many times over.",
    )
}

/// Scatter of one sample over the roughness.
pub fn scatter(contest: &Contest) -> Figure {
    let first = |k: usize| contest[k].1.points.first().and_then(|p| p.error).map_or(f64::NAN, |e| e.mid);
    let chart = Chart::error_over(Axis::log("roughness α"), "standard deviation of a sample over the mean")
        .title(&format!(
            "At roughness 0.01 blind samples scatter by {:.0} times the mean, facets that are seen by {}",
            first(0),
            short(first(3))
        ))
        .subtitle("GGX from 75°; samples below the horizon count as 0");
    Figure::from(lines(chart, contest)).caption(
        "Sampling efficiency: the standard deviation of one weight f cos/pdf over the albedo. Its square is the number of samples that a relative \
         error of 1 costs.",
    )
}

/// Fast forms against exact ones: time and error.
pub fn approximations(rivals: &[Rival]) -> Figure {
    let ns = |k: usize| rivals[k].series.points[0].time.map_or(f64::NAN, |t| t.mid * 1.0e9);
    let error = |k: usize| rivals[k].series.points[0].error.map_or(f64::NAN, |e| 100.0 * e.mid);
    let mut chart = Chart::speed_accuracy("relative error of f against the exact form (root mean square)")
        .x(Axis::time("time per value"))
        .y(Axis::log("relative error of f against the exact form (root mean square)").range(1.0e-2, 1.0))
        .title(&format!(
            "The short Oren–Nayar saves {:.0} of {:.0} ns and errs by {:.0} %; Schlick saves {:.0} of {:.0} ns and errs by {:.0} %",
            ns(2) - ns(3),
            ns(2),
            error(3),
            ns(0) - ns(1),
            ns(0),
            error(1)
        ))
        .subtitle("glass GGX α = 0.4; matt ρ = 0.8, σ = 0.5; gold Beckmann m = 0.4; half of the pairs in the highlight");
    for rival in &rivals[..6] {
        chart = chart.line(rival.method.clone(), &rival.series);
    }
    Figure::from(chart).caption(
        "What fast forms save and what they cost, per value of f, median of nine runs. The exact forms stand on the strip below. V-cavities are \
         another model of shadowing rather than an approximation of Smith's.",
    )
}

pub fn approximations_table(rivals: &[Rival]) -> Figure {
    let mut table = Table::new(&["Form", "held against", "ns per value", "error of f", "error of albedo"])
        .timed()
        .title("Seven forms of three models: time of one value, and what it is off")
        .subtitle("error of f: relative, root mean square; of albedo: largest over all angles, absolute");
    for rival in rivals {
        let p = &rival.series.points[0];
        let (time, error) = (p.time.map_or(f64::NAN, |t| t.mid * 1.0e9), p.error.map_or(f64::NAN, |e| e.mid));
        table = table.row(&[
            &rival.method.name,
            rival.exact,
            &format!("{time:.0}"),
            &short(error),
            &short(rival.albedo),
        ]);
    }
    Figure::from(table).caption("The numbers behind the chart, with Walter's rational fit to Smith's shadowing, which saves the error function.")
}

/// Errors over the exponent.
pub fn exponent(contest: &[(Method, Series); 2]) -> Figure {
    let worst = contest[1].1.points.iter().filter_map(|p| p.error).map(|e| e.mid).fold(0.0, f64::max);
    let ours = contest[0].1.points.iter().filter_map(|p| p.error).map(|e| e.mid).fold(0.0, f64::max);
    let mut chart = Chart::error_over(Axis::log("exponent n"), "relative error of f (root mean square)")
        .title(&format!(
            "powf(cos a, n) loses a digit for each digit of n, up to {}; from 1 − cos a at most {} is lost",
            short(worst),
            short(ours)
        ))
        .subtitle("24 pairs a point, where the lobe has fallen to 1/e; truth from the angles")
        .guide(Guide::slope_through(1.0, 1.0, lightbench::num::U, "n u"))
        .guide(Guide::slope_through(0.5, 1.0, lightbench::num::U, "√n u: the vectors' own rounding"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Phong's lobe at large exponents. A cosine near 1 has no digits for the angle, and the exponent multiplies what is missing; the squared \
         distance of the two unit vectors has them.",
    )
}
