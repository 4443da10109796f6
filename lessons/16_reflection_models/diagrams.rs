//! Diagrams of lesson 16: the vectors, facets, light inside a material, and the lobes.

use super::models::{GOLD, WHITE};
use glam::{DVec2, DVec3, dvec2};
use lightbench::bsdf::{
    Angles, Blinn, Brdf, CookTorrance, Distribution, Lafortune, Lambert, Model, OrenNayar, OrenNayarForm,
    ParameterError, Phong, Shadowing, as_printed,
};
use lightbench::sample::uniform;
use lightbench_kit::figure::{Diagram, Figure, Light};
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use std::f64::consts::{FRAC_PI_2, PI};

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("vectors", vectors())?;
    lesson.save("facets", facets())?;
    lesson.save("scattering", scattering(lesson.seed()))?;
    let wrong = |e: ParameterError| LessonError(e.to_string());
    lesson.save("lobes_matt", matt_lobes().map_err(wrong)?)?;
    lesson.save("lobes_glossy", glossy_lobes().map_err(wrong)?)?;
    lesson.save("lobe_printed", printed_lobe().map_err(wrong)?)
}

/// A direction of the section at an angle [degrees] from the vertical, to the right.
fn at(degrees: f64) -> DVec2 {
    dvec2(degrees.to_radians().sin(), degrees.to_radians().cos())
}

/// [A ill. 34].
fn vectors() -> Figure {
    let o = DVec2::ZERO;
    let (u, v, r) = (at(-50.0), at(22.0), at(50.0));
    let lobe: Vec<DVec2> = polar(|degrees| 0.9 * (degrees - 50.0f64).to_radians().cos().max(0.0).powi(12));
    let diagram = Diagram::new(dvec2(-1.5, -0.15), dvec2(1.5, 1.42))
        .ground(o, DVec2::Y)
        .region(Light::Reflected, &lobe)
        .ray(Light::Incident, o, u * 1.15)
        .name_end("u")
        .ray(Light::Normal, o, DVec2::Y * 1.1)
        .name_end("n")
        .ray(Light::Reflected, o, v * 1.15)
        .name_end("v")
        .ray(Light::Shadow, o, r * 1.1)
        .name_end("refl(−u, n)")
        .angle_at(o, DVec2::Y, u, 120.0)
        .name("θ")
        .angle_at(o, DVec2::Y, r, 150.0)
        .name("θ")
        .angle_at(o, v, r, 230.0)
        .name("a")
        .lamp(u * 1.3)
        .eye(v * 1.32, -v)
        .point(o)
        .title("A BRDF weighs three directions: to the light, the normal, to the viewer")
        .subtitle("u and v leave the surface; a is the angle between viewer and mirrored light, on which the cosine lobe depends");
    Figure::from(diagram).caption("The vectors of a reflection model, after A, ill. 34; shaded: a cosine lobe about the mirrored light.")
}

/// [B 7.9].
fn facets() -> Figure {
    let slopes = [0.18, -0.32, 0.42, -0.12, 0.25, -0.45, 0.36, -0.2, 0.1, -0.3, 0.4, -0.22];
    let width = 0.25;
    let mut points = vec![dvec2(-1.5, 0.0)];
    for slope in slopes {
        let last = points[points.len() - 1];
        points.push(last + dvec2(width, width * slope));
    }
    let mut body = points.clone();
    body.extend([dvec2(1.5, -0.3), dvec2(-1.5, -0.3)]);
    let mut diagram = Diagram::new(dvec2(-1.55, -0.25), dvec2(1.55, 0.8)).polygon(&body);
    let down = dvec2(0.55, -1.0).normalize();
    for i in [1, 3, 5, 7, 9] {
        let (p, along) = ((points[i] + points[i + 1]) * 0.5, (points[i + 1] - points[i]).normalize());
        let n = along.perp();
        let out = down - n * (2.0 * down.dot(n));
        diagram = diagram.ray(Light::Incident, p - down * 0.72, p).normal(p, n * 0.26).ray(
            Light::Reflected,
            p,
            p + out * 0.6,
        );
    }
    let diagram = diagram
        .title("A rough surface is a broken mirror: each facet reflects about its own normal")
        .subtitle("parallel light, facets tilted by −24° to 23°; incident blue, reflected orange, the facets' normals thin");
    Figure::from(diagram).caption(
        "A glossy or matt surface as a broken mirror, after B, 7.9. The distribution of tilts, D(h), is all that Cook and Torrance's model \
         remembers of the facets, with the share of them that is neither hidden nor in shadow.",
    )
}

/// [B 7.10].
fn scattering(seed: u64) -> Figure {
    let mut diagram = Diagram::new(dvec2(-0.85, -0.45), dvec2(0.85, 0.45)).half_plane(DVec2::ZERO, DVec2::Y);
    let entry = dvec2(-0.1, 0.0);
    let from = dvec2(-0.38, 0.43);
    diagram = diagram.ray(Light::Incident, from, entry).word("light");
    let (mut left, mut photon) = (0, 0u64);
    while left < 5 && photon < 400 {
        photon += 1;
        let number = |k: u32| uniform(seed, photon, 0, k);
        let mut path = vec![entry];
        let mut way = dvec2(0.45, -1.0).normalize();
        for step in 0..40 {
            let here = path[path.len() - 1];
            let next = here + way * (0.04 - 0.09 * (1.0 - number(2 * step)).ln());
            if next.y >= 0.0 {
                let exit = here + (next - here) * (here.y / (here.y - next.y));
                path.push(exit);
                break;
            }
            path.push(next);
            way = DVec2::from_angle(number(2 * step + 1) * 2.0 * PI);
        }
        let end = path[path.len() - 1];
        let shown = end.y == 0.0
            && (4..14).contains(&path.len())
            && end.x.abs() < 1.2
            && path.iter().all(|p| p.y > -0.68);
        if shown && (end.x - entry.x).abs() > 0.08 {
            left += 1;
            let out = at(150.0 * (uniform(seed, photon, 1, 0) - 0.5));
            diagram = diagram.path(Light::Transmitted, &path).ray(Light::Reflected, end, end + out * 0.3);
        }
    }
    let diagram = diagram
        .note(dvec2(0.6, -0.41), "inside the material")
        .title("In a matt material light wanders, and leaves in a direction that has forgotten how it came")
        .subtitle(&format!(
            "{left} random walks among those that come out in view; the ways out are drawn at random too"
        ));
    Figure::from(diagram).caption("Light scattered inside a diffuse material, after B, 7.10: the reason why Lambert's surface sends the same radiance everywhere.")
}

/// A closed curve `r(angle)`, the angle from the vertical [degrees], from −90° to 90°.
fn polar(r: impl Fn(f64) -> f64) -> Vec<DVec2> {
    (-360..=360).map(|k| f64::from(k) * 0.25).map(|degrees| at(degrees) * r(degrees)).collect()
}

/// The lobe of a model lit from the left at an angle [degrees], in the plane of incidence; its peak is drawn that long.
fn lobe(model: &Model, light: f64, peak: f64, shown: fn(f64, f64) -> f64) -> Vec<DVec2> {
    let value = |degrees: f64| {
        let phi = if degrees > 0.0 { PI } else { 0.0 };
        let theta = degrees.abs().to_radians().min(FRAC_PI_2 - 1.0e-3);
        shown(model.value(&Angles::new(theta, light.to_radians(), phi)), theta.cos())
    };
    let highest = (-360..=360).map(|k| value(f64::from(k) * 0.25)).fold(f64::MIN_POSITIVE, f64::max);
    polar(|degrees| value(degrees) * peak / highest)
}

fn with_lobes(
    mut diagram: Diagram,
    light: f64,
    lobes: &[(&str, Light, Model, f64)],
    shown: fn(f64, f64) -> f64,
) -> Diagram {
    diagram = diagram.ground(DVec2::ZERO, DVec2::Y);
    for (name, pen, model, peak) in lobes {
        let points = lobe(model, light, *peak, shown);
        let far = points.iter().copied().max_by(|a, b| a.length().total_cmp(&b.length())).unwrap_or_default();
        diagram = diagram.path(*pen, &points).spot(*pen, far).word(name);
    }
    diagram.ray(Light::Normal, at(-light) * 1.0, at(-light) * 0.12).name("light").point(DVec2::ZERO)
}

fn matt_lobes() -> std::result::Result<Figure, ParameterError> {
    let rough = |form| OrenNayar::new(1.0, 0.6, form).map(Model::from);
    // One scale for all: 1/π is drawn 0.64 long.
    let peak = |model: &Model| {
        (-360..=360)
            .map(|k| {
                model.value(&Angles::new(
                    (f64::from(k) * 0.2495).abs().to_radians(),
                    60f64.to_radians(),
                    if k > 0 { PI } else { 0.0 },
                ))
            })
            .fold(0.0, f64::max)
            * 2.0
    };
    let (matt, short, full) =
        (Model::from(Lambert::new(1.0)?), rough(OrenNayarForm::Qualitative)?, rough(OrenNayarForm::Full)?);
    let peaks = [peak(&matt), peak(&short), peak(&full)];
    let lobes = [
        ("Lambert", Light::Incident, matt, peaks[0]),
        ("Oren–Nayar, short", Light::Reflected, short, peaks[1]),
        ("Oren–Nayar, full", Light::Transmitted, full, peaks[2]),
    ];
    let diagram = with_lobes(Diagram::new(dvec2(-1.2, -0.1), dvec2(1.2, 0.75)), 60.0, &lobes, |f, _| f)
        .title("Lambert's lobe is a circle; rough matt surfaces send light back where it came from")
        .subtitle("f in the plane of incidence, light at 60°, ρ = 1, slopes σ = 0.6 rad");
    Ok(Figure::from(diagram).caption(
        "Polar plots of matt models: the distance from the point is the value of f in that direction.",
    ))
}

fn glossy_lobes() -> std::result::Result<Figure, ParameterError> {
    let phong = Phong::new(12.0)?;
    let off = Lafortune::new(DVec3::new(-1.0, -1.0, 0.8), 12.0, 1.0)?;
    let beckmann = CookTorrance::new(0.35, Distribution::Beckmann, Shadowing::VCavity, GOLD)?;
    let lobes = [
        ("Phong, n = 12", Light::Incident, phong.into(), 1.0),
        ("Blinn, n = 48", Light::Shadow, Blinn::new(48.0)?.into(), 0.88),
        ("Lafortune, pulled down", Light::Transmitted, off.into(), 0.76),
        ("Cook–Torrance, gold", Light::Reflected, beckmann.into(), 1.12),
        ("GGX, white", Light::Other, CookTorrance::ggx(0.35, WHITE)?.into(), 0.64),
    ];
    let diagram = with_lobes(Diagram::new(dvec2(-0.95, -0.08), dvec2(1.35, 0.82)), 55.0, &lobes, |f, cos| f * cos)
        .title(
            "Round the mirror direction, and beside it: facets lean towards the horizon, Phong's lobe away from it",
        )
        .subtitle(
            "f cos θ in the plane of incidence, light at 55°; peaks set apart to compare shapes",
        );
    Ok(Figure::from(diagram).caption(
        "Polar plots of glossy models with the cosine of the transport, which draws Phong's and Blinn's lobes up towards the normal; the facets' \
         1/cos makes up for it, and more (off-specular reflection). Lafortune's lobe leans by one coefficient.",
    ))
}

/// [A (4.7)] as printed has a second lobe.
fn printed_lobe() -> std::result::Result<Figure, ParameterError> {
    let light = 65.0;
    let u = DVec3::new(-(light * PI / 180.0).sin(), 0.0, (light * PI / 180.0).cos());
    let value = |degrees: f64| {
        let v = at(degrees);
        0.9 * as_printed::cosine_lobe_as_printed(u, DVec3::Z, DVec3::new(v.x, 0.0, v.y), 4.0)
    };
    let cut = lobe(&Phong::new(4.0)?.into(), light, 0.9 * 6.0 / (2.0 * PI), |f, _| f);
    let diagram = Diagram::new(dvec2(-1.1, -0.1), dvec2(1.2, 0.62))
        .ground(DVec2::ZERO, DVec2::Y)
        .path(Light::Transmitted, &cut)
        .spot(Light::Transmitted, at(light) * (0.9 * 6.0 / (2.0 * PI)))
        .word("cut off at zero")
        .path(Light::Other, &polar(|d| if d < light - 90.0 { value(d) } else { 0.0 }))
        .spot(Light::Other, at(-60.0) * value(-60.0))
        .word("as printed: a second lobe")
        .ray(Light::Normal, at(-light) * 1.05, at(-light) * 0.45)
        .name("light")
        .point(DVec2::ZERO)
        .title("As printed, (4.7) shines behind itself: nothing cuts off the power of a negative cosine")
        .subtitle(
            "exponent 4, light at 65°; an odd exponent makes that light negative, one with a fraction NaN",
        );
    Ok(Figure::from(diagram).caption("A's cosine lobe as printed, and cut off at zero as it must be."))
}
