//! Renders of lesson 15: A's two spheres, a wet floor, floors under each attenuation.

use super::charts::laws;
use super::printed::{Formula, Printed};
use glam::dvec3;
use lightbench::bsdf::highlight::Match;
use lightbench::bsdf::{Blinn, BlinnScale, Lambert, Lobes, Model, ParameterError, Phong, PhongScale};
use lightbench::color::{Rgb, luminance};
use lightbench::film::Image;
use lightbench::film::metric::compare;
use lightbench::integrator::Local;
use lightbench::light::{Attenuation, Light, PointLight};
use lightbench::render::{Picture, render, shade};
use lightbench::scene::{Object, Scene};
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{ErrorPanel, Figure, Panels, Pixels, Shades};
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use lightbench_kit::scene_file;
use std::f64::consts::FRAC_1_PI;
use std::fmt::Display;

/// Exponent and coefficient of the spheres.
pub const N: f64 = 30.0;
pub const SPECULAR: f64 = 0.6;

fn other(e: impl Display) -> LessonError {
    LessonError(e.to_string())
}

fn scene(text: &str) -> Result<Scene> {
    scene_file::read(text, "scene of lesson 15").map(|file| file.scene).map_err(|e| other(format!("{e:?}")))
}

/// A's two spheres with a highlight.
fn spheres(highlight: &Model) -> Result<Scene> {
    let mut scene = scene(include_str!("../../scenes/a18_two_spheres.scene"))?;
    for material in scene.materials.iter_mut().filter(|m| m.name != "floor") {
        material.model = Some(shiny(material.diffuse, SPECULAR, highlight).map_err(other)?);
    }
    Ok(scene)
}

/// A matt colour under a colourless highlight. The documents' lamps bring π times their colour.
fn shiny(diffuse: Rgb, specular: f64, highlight: &Model) -> std::result::Result<Lobes, ParameterError> {
    let matt = Model::from(Lambert::new(1.0)?);
    Lobes::new([(diffuse, matt), (Rgb::splat(specular * FRAC_1_PI), highlight.clone())])
}

fn phong(n: f64) -> Result<Model> {
    Phong::new(n).map(|p| p.scaled(PhongScale::OverCosine).into()).map_err(other)
}

fn blinn(n: f64) -> Result<Model> {
    Blinn::new(n).map(|b| b.scaled(BlinnScale::OverCosine).into()).map_err(other)
}

fn shot(scene: &Scene, picture: Picture) -> Image {
    render(scene, &Local::default(), picture).image
}

fn difference(a: &Image, b: &Image, name: &str, most: f64) -> ErrorPanel {
    let values = a.pixels().iter().zip(b.pixels()).map(|(a, b)| luminance(*a) - luminance(*b)).collect();
    ErrorPanel {
        width: a.width(),
        height: a.height(),
        values,
        shades: Shades::Signed,
        name: name.to_string(),
        rmse: compare(a, b).rmse,
        range: Some((-most, most)),
    }
}

pub fn save(lesson: &Lesson) -> Result {
    let samples = lesson.flags().spp.map_or(lesson.pick([1, 4, 16, 64]), u32::from);
    let picture = |(width, height): (usize, usize)| Picture { width, height, samples, seed: lesson.seed() };
    let specular =
        shot(&spheres(&phong(N)?)?, picture(lesson.pick([(48, 30), (640, 400), (960, 600), (1280, 800)])));
    lesson.save_picture(
        "specular",
        &specular,
        "Material with a specular highlight (A, illustration 20): Phong's cosⁿ φ, n = 30, coefficient 0.6, over the matt colours.",
        "A red and a green sphere on a grey floor, each with a soft white spot of light at its upper right.",
    )?;
    let panel = picture(lesson.pick([(40, 25), (520, 325), (640, 400), (640, 400)]));
    lesson.save("same_exponent", same_exponent(panel)?)?;
    lesson.save("printed", printed(panel)?)?;
    lesson.save(
        "wet_floor",
        wet_floor(picture(lesson.pick([(32, 24), (364, 273), (480, 360), (480, 360)])))?,
    )?;
    lesson.save("floors", floors(picture(lesson.pick([(44, 15), (552, 190), (552, 190), (1104, 380)])))?)
}

/// [C fig. 31], rendered.
fn same_exponent(picture: Picture) -> Result<Figure> {
    let take = |model: Result<Model>| Ok::<_, LessonError>(shot(&spheres(&model?)?, picture));
    let best = Match::LeastSquares.exponent(N);
    let (r, same, four) = (take(phong(N))?, take(blinn(N))?, take(blinn(best))?);
    let zoom = |share: f64| (share * picture.width as f64).round() as usize;
    let [before, after] = [&same, &four].map(|image| compare(image, &r).rmse);
    let panels = Panels::new()
        .columns(2)
        .title(&format!("With the same n the half vector doubles the highlight; 4n + 3/2 takes {:.0} % of the difference away", 100.0 * (1.0 - after / before)))
        .subtitle("A's two spheres; highlight 0.6 of a lamp of 0.95; C, figure 31, rendered")
        .picture(Pixels::from(&r), "(R·V)³⁰")
        .picture(Pixels::from(&same), "(N·H)³⁰")
        .picture(Pixels::from(&four), &format!("(N·H)^{{{best:.1}}}"))
        .error(difference(&four, &r, "the third less the first", 0.05))
        .zoom(zoom(0.27), zoom(0.19), zoom(0.154), zoom(0.138))
        .alt("Two spheres three times: with small highlights, with highlights twice as wide, with small ones again; then the difference of the last and the first, faint.");
    Ok(Figure::from(panels).caption(
        "Compensating the exponent, after C, figure 31. What remains stands beside the plane of incidence: Blinn's highlight is a little narrower across.",
    ))
}

/// [A §3.3, ill. 21, ill. 68] as worded and as printed.
fn printed(picture: Picture) -> Result<Figure> {
    let lamp = dvec3(3.5, 6.0, 4.5);
    let mut scene = spheres(&phong(N)?)?;
    scene.lights = vec![PointLight::of_color(lamp, Rgb::new(1.0, 0.8, 0.45)).into()];
    // A small ball in the air, before the red sphere's highlight.
    let (highlight, share) = (dvec3(-0.758, 1.447, 1.154), 0.42);
    let ball = Sphere::new(highlight.lerp(lamp, share), 0.2).map_err(other)?;
    scene.objects.push(Object::new("ball", Box::new(ball), 0));
    let printed = |formula, scene: &Scene| {
        let printed = Printed { formula, shininess: N, specular: SPECULAR };
        shade(scene, picture, |ray, scene| printed.radiance(ray, scene))
    };
    let right = shot(&scene, picture);
    let code = printed(Formula::Code, &scene);
    let worded = printed(Formula::Worded, &scene);
    let mut beside = spheres(&phong(N)?)?;
    beside.lights = vec![PointLight::of_color(dvec3(1.2, 3.4, 8.0), Rgb::splat(0.95)).into()];
    let right_beside = shot(&beside, picture);
    let worded_beside = printed(Formula::Worded, &beside);
    let panels = Panels::new()
        .columns(3)
        .title("As printed A's highlight shines in the shadow, in the matt colour; as worded it is nowhere, or everywhere")
        .subtitle("left: a yellow lamp, and a ball out of view that throws its shadow on the red sphere's highlight; last two: a lamp beside the viewer")
        .picture(Pixels::from(&right), "(R·V)ⁿ times what arrives")
        .picture(Pixels::from(&code), "as printed, ill. 21 and 68")
        .error(difference(&code, &right, "second less first", 0.25))
        .picture(Pixels::from(&worded), "as worded: (L·V)ⁿ")
        .picture(Pixels::from(&right_beside), "(R·V)ⁿ, lamp beside the viewer")
        .picture(Pixels::from(&worded_beside), "as worded, lamp beside the viewer")
        .alt("Two spheres five times and a difference: a yellowish highlight, the other hidden by a round shadow; the same with a red glow inside the shadow; no highlight at all; two white highlights; two spheres under an even white veil.");
    Ok(Figure::from(panels).caption(
        "A's code and A's words. The words multiply the directions to light and viewer, which hardly change over a sphere: instead of a spot there is a \
         veil, or nothing. The code mirrors the viewer and is Phong's; but it adds the highlight beside the light that arrives, so that neither shadow \
         nor distance nor the lamp's colour touch it, and multiplies it by the colour of the matt surface.",
    ))
}

const STREET: &str = "
Camera { POV 0 1.6 6  POI 0 0.55 0  FOV 34 }
SceneSettings { BackgroundColor 0.02 0.03 0.06 }
Material { Name floor  DiffuseColor 0.035 0.04 0.05  SpecularColor 0 0 0  Roughness 0 }
Plane { Material floor  Point 0 0 0  Normal 0 1 0 }
PointLight { Position -1.6 2.2 -14  Color 1 0.82 0.5 }
PointLight { Position 1.5 1.2 -7  Color 0.9 0.4 0.3 }
";

/// Light from far ahead: the half vector's highlight is drawn out.
fn wet_floor(picture: Picture) -> Result<Figure> {
    let n = 120.0;
    let take = |model: Result<Model>| {
        let mut scene = scene(STREET)?;
        let floor = &mut scene.materials[0];
        floor.model = Some(shiny(floor.diffuse, 0.9, &model?).map_err(other)?);
        Ok::<_, LessonError>(shot(&scene, picture))
    };
    let (r, h) = (take(phong(n))?, take(blinn(Match::LeastSquares.exponent(n)))?);
    let panels = Panels::new()
        .columns(3)
        .title("Lamps ahead on a wet floor: R makes discs, H draws them out towards the viewer, as streets do")
        .subtitle("two lamps, 2.2 m high at 20 m and 1.2 m high at 13 m; n = 120, and 4n + 3/2 for H")
        .picture(Pixels::from(&r), "(R·V)ⁿ")
        .picture(Pixels::from(&h), "(N·H)⁴ⁿ⁺¹·⁵")
        .error(difference(&h, &r, "second less first", 0.5))
        .alt("A dark floor with the reflections of two lamps: round in the first picture, vertical streaks in the second.");
    Ok(Figure::from(panels).caption(
        "Where the exponents cannot answer each other. At grazing light the lobes differ in shape: the half vector's is narrower across by cos θ, and on \
         a rough wet street it is the better likeness.",
    ))
}

const ROW: &str = "
Camera { POV 3.6 3.2 10  POI 3.6 0.12 0  FOV 17 }
SceneSettings { BackgroundColor 0.03 0.035 0.05  AmbientLight 0.02 0.02 0.03 }
Material { Name floor  DiffuseColor 0.62 0.58 0.52  SpecularColor 0 0 0  Roughness 0 }
Material { Name ball  DiffuseColor 0.85 0.85 0.85  SpecularColor 0 0 0  Roughness 0 }
Plane { Material floor  Point 0 0 0  Normal 0 1 0 }
Sphere { Material ball  Center 0.9 0.28 -0.6  Radius 0.28 }
Sphere { Material ball  Center 1.9 0.28 0.1  Radius 0.28 }
Sphere { Material ball  Center 3.3 0.28 -0.6  Radius 0.28 }
Sphere { Material ball  Center 5.1 0.28 1.45  Radius 0.28 }
Sphere { Material ball  Center 7.0 0.28 1.25  Radius 0.28 }
PointLight { Position 0 0.7 0.1  Color 1 1 1 }
";

/// A floor under each law, all of the same light at 1 m.
fn floors(picture: Picture) -> Result<Figure> {
    let mut all = vec![("none [D]", Attenuation::None)];
    // B's law is the inverse square.
    all.extend(laws().map_err(other)?.into_iter().take(5).map(|(name, law, _)| (name, law)));
    let left = |k: usize| 100.0 * all[k].1.factor(7.0) / all[k].1.factor(1.0);
    let mut panels = Panels::new()
        .columns(2)
        .title(&format!(
            "Of the light at 1 m, 1/d² leaves {:.0} % at 7 m, the polynomial leaves {:.0} %, 1/(d + ½) leaves {:.0} %",
            left(2),
            left(4),
            left(5)
        ))
        .subtitle("a lamp 0.7 m over the floor, the same at 1 m for all; balls at 1.1, 1.9, 3.4, 5.3 and 7.1 m; clipped at white");
    for (name, law) in &all {
        let mut scene = scene(ROW)?;
        let color = Rgb::splat(1.6 / law.factor(1.0)); // the same at 1 m
        scene.lights =
            vec![Light::from(PointLight::of_color(dvec3(0.0, 0.7, 0.1), color).with_attenuation(*law))];
        panels = panels.picture(Pixels::from(&shot(&scene, picture)), name);
    }
    let panels = panels.alt("Six pictures of a floor with five balls in a row, lit from a lamp at the left: evenly, and falling off at different rates.");
    Ok(Figure::from(panels).caption(
        "Attenuation laws on a floor. Without attenuation only the slant of the light darkens the far floor. The inverse square is the only one that \
         light follows; A's cap takes the glare at the lamp's foot away, and nothing else.",
    ))
}
