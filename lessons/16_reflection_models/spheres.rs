//! Spheres under a window: each model in the light, and in the white furnace.

use super::models::{GLASS, GOLD, WHITE, contestants, view};
use glam::{DVec2, DVec3, dvec3};
use lightbench::bsdf::{
    Blinn, Brdf, CookTorrance, Distribution, Lafortune, Lambert, Lobes, Model, OrenNayar, OrenNayarForm,
    ParameterError, Phong, Shadowing,
};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::frame::basis;
use lightbench::fresnel::Fresnel;
use lightbench::measure::Method;
use lightbench::sample::{Sampler, r2};
use lightbench_kit::figure::{Figure, Panels, Pixels};
use lightbench_kit::lesson::{Lesson, LessonError};
use rayon::prelude::*;

/// Half sides of the window, in the plane at distance 1; its bars; its radiance and the sky's.
const WINDOW: DVec2 = DVec2::new(0.42, 0.52);
const BAR: f64 = 0.03;
const SHINE: f64 = 7.0;
const SKY: f64 = 0.42;

/// The window's axis and sides.
fn window() -> [DVec3; 3] {
    let axis = dvec3(-0.62, 0.72, 0.62).normalize();
    let right = DVec3::Y.cross(axis).normalize();
    [axis, right, axis.cross(right)]
}

/// Place on the window of a direction.
fn on_window(w: DVec3) -> Option<DVec2> {
    let [axis, right, up] = window();
    let depth = w.dot(axis);
    let p = DVec2::new(w.dot(right), w.dot(up)) / depth;
    (depth > 0.0 && p.abs().cmple(WINDOW).all()).then_some(p)
}

/// Density [sr⁻¹] of directions to uniform points of the window.
fn window_pdf(w: DVec3) -> f64 {
    let cos = w.dot(window()[0]);
    if on_window(w).is_none() { 0.0 } else { 1.0 / (4.0 * WINDOW.x * WINDOW.y * cos * cos * cos) }
}

/// Radiance of the surroundings: a window in a soft sky above a tiled floor, darkened round the sphere's foot.
fn surroundings(from: DVec3, w: DVec3) -> Rgb {
    if w.y < -1.0e-3 {
        let p = from + w * ((-1.0 - from.y) / w.y);
        let distance2 = p.x * p.x + p.z * p.z;
        let tile =
            if ((p.x * 0.9).floor() + (p.z * 0.9).floor()).rem_euclid(2.0) < 0.5 { 0.50 } else { 0.24 };
        // A sphere of radius 1 that stands there covers (1 + d²)^(−3/2) of the floor's sky.
        let open = 1.0 - (1.0 + distance2).powf(-1.5);
        let near = (-distance2 / 160.0).exp();
        return dvec3(1.0, 0.94, 0.86) * (tile * open * near + 0.36 * (1.0 - near));
    }
    if let Some(p) = on_window(w) {
        let framed = p.x.abs() < BAR || p.y.abs() < BAR;
        return if framed { Rgb::splat(0.3) } else { dvec3(1.0, 0.97, 0.9) * SHINE };
    }
    let height = w.y.clamp(0.0, 1.0).sqrt();
    dvec3(0.86, 0.88, 0.92).lerp(dvec3(0.45, 0.62, 0.9), height) * SKY
}

/// Light that a point of the sphere sends to the eye: one sample of the material and one of the window, each weighted by its
/// share of both densities (Veach's balance heuristic).
fn reflected(material: &Lobes, n: DVec3, to_eye: DVec3, [u, v]: [DVec2; 2]) -> Rgb {
    let (x, y) = basis(n);
    let local = |w: DVec3| DVec3::new(w.dot(x), w.dot(y), w.dot(n));
    let wo = local(to_eye);
    let mut sum = Rgb::ZERO;
    if let Some(made) = material.sample(wo, u) {
        let w = x * made.wi.x + y * made.wi.y + n * made.wi.z;
        let share = if made.pdf == f64::INFINITY { 1.0 } else { made.pdf / (made.pdf + window_pdf(w)) };
        sum += made.weight * surroundings(n, w) * share;
    }
    let (u, [axis, right, up]) = (v * 2.0 - 1.0, window());
    let w = (axis + right * (u.x * WINDOW.x) + up * (u.y * WINDOW.y)).normalize();
    let (wi, pdf) = (local(w), window_pdf(w));
    if wi.z > 0.0 && pdf > 0.0 {
        let f = material.eval(wi, wo) * wi.z;
        sum += f * surroundings(n, w) / (pdf + material.pdf(wi, wo));
    }
    sum
}

/// How a picture is taken.
#[derive(Clone, Copy)]
struct Shot {
    size: usize,
    samples: u32,
    seed: u64,
    /// Radiance `1/exposure` comes out at 63 % of white.
    exposure: f64,
}

/// The sphere, seen from a little above; `at` gives the light of its point with that normal.
fn picture(
    shot: Shot,
    at: impl Fn(DVec3, DVec3, [DVec2; 2]) -> Rgb + Sync,
    behind: impl Fn(DVec3, DVec3) -> Rgb + Sync,
) -> Image {
    let eye = dvec3(0.0, 1.3, 6.4);
    let forward = (dvec3(0.0, -0.02, 0.0) - eye).normalize();
    let right = forward.cross(DVec3::Y).normalize();
    let up = right.cross(forward);
    let pixel = |i: usize| {
        let (column, row) = (i % shot.size, i / shot.size);
        let mut shifts = Sampler::new(shot.seed, i as u64, 0);
        let shifts = [shifts.next_2d(), shifts.next_2d()];
        let mut sum = Rgb::ZERO;
        for k in 0..shot.samples {
            let mut s = Sampler::new(shot.seed, i as u64, k + 1);
            let p = (DVec2::new(column as f64, row as f64) + s.next_2d()) / shot.size as f64 * 2.0 - 1.0;
            let w = (forward + (right * p.x - up * p.y) * 0.185).normalize();
            let (b, c) = (eye.dot(w), eye.length_squared() - 1.0);
            let radiance = match b * b - c {
                d if d < 0.0 => behind(eye, w),
                // An even set of points, shifted in each pixel.
                d => at(
                    (eye - w * (b + d.sqrt())).normalize(),
                    -w,
                    shifts.map(|shift| (r2(0, k) + shift).fract()),
                ),
            };
            // Each sample bent by itself, so that the bright window leaves smooth rims.
            sum += radiance.map(|x| 1.0 - (-shot.exposure * x).exp());
        }
        sum / f64::from(shot.samples)
    };
    Image::from_pixels(shot.size, shot.size, (0..shot.size * shot.size).into_par_iter().map(pixel).collect())
}

fn lit(material: &Lobes, shot: Shot) -> Pixels {
    Pixels::from(&picture(shot, |n, v, u| reflected(material, n, v, u), surroundings))
}

/// One model in one colour.
fn coloured(tint: Rgb, model: impl Into<Model>) -> Result<Lobes, ParameterError> {
    Lobes::new([(tint, model.into())])
}

pub fn save(lesson: &Lesson) -> Result<(), LessonError> {
    let wrong = |e: ParameterError| LessonError(e.to_string());
    let (size, samples) = lesson.pick([(24, 4), (150, 64), (280, 196), (420, 484)]);
    let shot = Shot { size, samples, seed: lesson.seed(), exposure: 1.5 };
    let bright = |m: &Lobes| lit(m, shot);
    let dim = |m: &Lobes| lit(m, Shot { exposure: 0.75, ..shot });
    lesson.save("three_surfaces", three(&bright).map_err(wrong)?)?;
    lesson.save("spheres", all(&bright).map_err(wrong)?)?;
    lesson.save("roughness", roughness(&dim, lesson.pick([15, 5, 5, 5])).map_err(wrong)?)?;
    lesson.save("furnace_spheres", in_furnace(shot, lesson.pick([8, 64, 128, 256])).map_err(wrong)?)
}

/// [B 7.8].
fn three(shot: &dyn Fn(&Lobes) -> Pixels) -> Result<Figure, ParameterError> {
    let silver = dvec3(0.97, 0.96, 0.93);
    let panels = Panels::new()
        .columns(3)
        .title("Mirror, glossy, matt: the same sphere, the same light, three shares of order")
        .subtitle("a window with a cross, a tiled floor; the window's picture blurs, then spreads over the whole side")
        .picture(shot(&coloured(silver, CookTorrance::ggx(0.0, WHITE)?)?), "mirror (roughness 0)")
        .picture(shot(&coloured(silver, CookTorrance::ggx(0.25, WHITE)?)?), "glossy (GGX, roughness 0.25)")
        .picture(shot(&coloured(silver * 0.85, Lambert::new(1.0)?)?), "matt (Lambert)")
        .alt("Three spheres on a tiled floor: a mirror that shows a window with a cross, a glossy one with a blurred window, a matt one, shaded softly.");
    Ok(Figure::from(panels).caption("Mirror, glossy and matt surfaces, after B, 7.8."))
}

fn all(shot: &dyn Fn(&Lobes) -> Pixels) -> Result<Figure, ParameterError> {
    let copper = dvec3(0.95, 0.55, 0.38);
    let gold = |d, s| CookTorrance::new(0.3, d, s, GOLD).map(Model::from);
    let glazed = Lobes::new([
        (dvec3(0.05, 0.25, 0.5), OrenNayar::new(1.0, 0.3, OrenNayarForm::Full)?.into()),
        (Rgb::ONE, CookTorrance::ggx(0.08, GLASS)?.into()),
    ])?;
    let yellow = dvec3(1.0, 0.74, 0.36);
    let panels = Panels::new()
        .columns(4)
        .title("Eight models under one window: matt, lobes, facets")
        .subtitle("each lit through its own sampler and its density, with the window sampled too")
        .picture(shot(&coloured(copper, Lambert::new(0.9)?)?), "Lambert")
        .picture(shot(&coloured(copper, OrenNayar::new(0.9, 0.8, OrenNayarForm::Full)?)?), "Oren–Nayar, σ = 0.8")
        .picture(shot(&coloured(copper, Phong::new(40.0)?)?), "cosine lobe (A 4.7), n = 40")
        .picture(shot(&coloured(copper, Blinn::new(160.0)?)?), "Blinn, n = 160")
        .picture(shot(&coloured(copper, Lafortune::new(dvec3(-1.0, -1.0, 0.95), 20.0, 1.0)?)?), "Lafortune, Cz = 0.95, n = 20")
        .picture(shot(&coloured(yellow, gold(Distribution::Beckmann, Shadowing::VCavity)?)?), "Cook–Torrance, m = 0.3")
        .picture(shot(&coloured(yellow, gold(Distribution::Ggx, Shadowing::Smith)?)?), "GGX, α = 0.3")
        .picture(shot(&glazed), "GGX glass on Oren–Nayar")
        .alt("Eight spheres on a tiled floor under a window: two matt ones, three with soft highlights, two golden ones, one blue and glazed.");
    Ok(Figure::from(panels).caption(
        "Spheres in the light of each model. Oren–Nayar's sphere is flatter than Lambert's; lobes darken towards the rim, where they lose light; \
         facets brighten there; GGX has the longer tail.",
    ))
}

/// [D fig. 46].
fn roughness(shot: &dyn Fn(&Lobes) -> Pixels, every: usize) -> Result<Figure, ParameterError> {
    let (diffuse, specular) = (Rgb::splat(0.9), Rgb::splat(0.8));
    let mut panels = Panels::new().columns(4);
    let mut most: f64 = 0.0;
    for roughness in [0.1, 0.3, 0.6, 1.0] {
        let material = Lobes::matt_and_glossy(diffuse, specular, roughness)?;
        most = (0..90u32)
            .step_by(every)
            .map(|degrees| material.albedo(view(f64::from(degrees))).0.x)
            .fold(most, f64::max);
        panels = panels.picture(shot(&material), &format!("roughness {roughness}"));
    }
    let panels = panels
        .title(&format!("D's white material at four roughnesses: it returns up to {:.0} % of the light", 100.0 * most))
        .subtitle("Oren–Nayar, diffuse 0.9, plus Cook–Torrance, specular 0.8: D's defaults; nothing makes room for the highlight")
        .alt("Four white spheres, the first with a sharp highlight of a window, the last without any.");
    Ok(Figure::from(panels).caption(
        "Roughness on a white material, after D, figure 46. One parameter blurs the highlight and flattens the matt part. The two colours are added \
         as D adds them, so that white surfaces create light; a scene that minds must keep diffuse + specular under 1.",
    ))
}

/// Spheres in a uniform sky: what conserves energy cannot be seen.
fn in_furnace(shot: Shot, steps: usize) -> Result<Figure, ParameterError> {
    let sky = 0.45;
    let mut panels = Panels::new()
        .columns(4)
        .title("In a white furnace a sphere that keeps all light is invisible")
        .subtitle("a uniform sky of 0.45, nothing absorbs: darker is light lost, brighter is light created");
    let mut models = vec![(Method::new("Lambert, ρ = 1"), Model::from(Lambert::new(1.0)?))];
    models.extend(contestants()?);
    models.push((
        Method::new("GGX, Smith, α = 1"),
        CookTorrance::ggx(1.0, Fresnel::Schlick { f0: 1.0 })?.into(),
    ));
    for (method, model) in &models {
        let table: Vec<f64> = (0..=steps)
            .map(|k| model.albedo(view(((k as f64).max(0.25) / steps as f64).acos().to_degrees())).value)
            .collect();
        let at = |cos: f64| {
            let x = cos.clamp(0.0, 1.0) * steps as f64;
            let k = (x as usize).min(steps - 1);
            table[k] + (table[k + 1] - table[k]) * (x - k as f64)
        };
        let image = picture(
            Shot { samples: 16, ..shot },
            |n, v, _| Rgb::splat(sky * at(n.dot(v))),
            |_, _| Rgb::splat(sky),
        );
        panels = panels.picture(Pixels::from(&image), &method.name);
    }
    let panels = panels.alt("Eight grey squares: Lambert's sphere cannot be seen, lobes are dark towards the rim, Blinn's usual scale is bright in the middle.");
    Ok(Figure::from(panels)
        .caption("Spheres of each model in a white furnace, by their albedos; white surfaces."))
}
