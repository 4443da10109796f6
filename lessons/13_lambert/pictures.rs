//! Pictures: the simplifications one by one, ambient light, laws as printed.

use super::model::{Eyesight, MIST, Made, SIMPLIFIED, scene, two_spheres};
use super::study::{Study, TRUTH, given_up, shoot};
use lightbench::bsdf::as_printed::{lambertian_as_printed, phong_as_printed};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::film::metric::compare;
use lightbench::integrator::{Local, Stage};
use lightbench::ray::{Ray, Silent};
use lightbench::render::{Picture, render, shade};
use lightbench::scene::Scene;
use lightbench_kit::figure::{ErrorPanel, Figure, Panels, Pixels, Shades, short};
use lightbench_kit::lesson::{Lesson, Result};

/// Points along a lamp's side in the panels, whose pictures are small.
const SIDE: u32 = 3;

/// Mean over the channels of `a − b`.
fn difference(name: &str, a: &Image, b: &Image, range: f64) -> ErrorPanel {
    let mean = |(p, q): (&Rgb, &Rgb)| (*p - *q).element_sum() / 3.0;
    ErrorPanel {
        width: a.width(),
        height: a.height(),
        values: a.pixels().iter().zip(b.pixels()).map(mean).collect(),
        shades: Shades::Signed,
        name: name.to_string(),
        rmse: compare(a, b).rmse,
        range: Some((-range, range)),
    }
}

/// Each simplification made alone.
pub fn alone(study: &Study, picture: Picture) -> Result<Figure> {
    let label = |name: &str, made: Made| format!("{name}: {}", short(study.of(made).rmse));
    let shot = |made: Made| shoot(made, SIDE, picture).map(|image| Pixels::from(&image));
    let mut panels = Panels::new()
        .columns(4)
        .title("Every simplification shows, but for the tenth: in a vacuum nothing is lost on the way to the eye")
        .subtitle("each made alone, with its error (RMSE); the tenth is exact, and the last picture shows what it would leave out in mist")
        .alt("Twelve pictures of a red and a clear green sphere on a chequered floor: the truth, C's model, and each simplification made alone. The lamp at the eye flattens everything, parallel light makes the far floor bright, the last one is veiled by mist.")
        .picture(shot(Made::NONE)?, "everything on");
    for (k, name) in (1..).zip(&SIMPLIFIED[..9]) {
        let made = Made::NONE.with(k);
        panels = panels.picture(shot(made)?, &label(&format!("{k} {name}"), made));
    }
    let misty = Eyesight { mist: MIST, ..Eyesight::new(Made::NONE) };
    let seen = render(&scene(Made::NONE, SIDE)?, &misty, picture).image;
    panels = panels
        .picture(Pixels::from(&seen), &format!("10 loss on the way: mist, {:.0} % a metre", 100.0 * MIST))
        .picture(shot(Made::ALL)?, &label("1–9, C's model", Made::ALL));
    Ok(Figure::from(panels).caption(
        "C's ten simplifications on A's two spheres. Every lamp that replaces another brings the same irradiance to the middle of \
         the scene, so that nothing is merely darker. Highlights, transparency and texture are plain versions of what lessons 15, 20 and 21 do properly."))
}

/// C's model, and one simplification less from picture to picture.
pub fn ladder(study: &Study, picture: Picture) -> Result<Figure> {
    let order = study.best_order();
    let (truth, first) = (shoot(Made::NONE, TRUTH / 2, picture)?, shoot(Made::ALL, SIDE, picture)?);
    let names: Vec<String> = order.windows(2).map(|s| given_up(s[0], s[1]).to_string()).collect();
    let mut panels = Panels::new()
        .columns(4)
        .title(&format!("From C's model to the truth: given up in the order {}", names.join(", ")))
        .subtitle("each step lowers the error most; under each picture what is new, and the error (RMSE) left")
        .alt("Twelve pictures of two spheres: first flat and shadowless under parallel light from the eye, then step by step lit from the side, by two lamps, chequered, with shadows, clear and shiny; last the error of the first picture, which is too bright far away and too dark near by.")
        .picture(Pixels::from(&first), &format!("C's model: {}", short(study.of(Made::ALL).rmse)));
    for step in order.windows(2) {
        let k = given_up(step[0], step[1]);
        let words = [
            "more lamps",
            "lamps with size",
            "lamps aside",
            "shadows",
            "attenuation",
            "transmission",
            "texture",
            "highlights",
            "light from near",
        ];
        let image = shoot(step[1], SIDE, picture)?;
        panels = panels.picture(
            Pixels::from(&image),
            &format!("{k} {}: {}", words[k - 1], short(study.of(step[1]).rmse)),
        );
    }
    let error = difference("error of C's model", &first, &truth, 0.5);
    Ok(Figure::from(panels.picture(Pixels::from(&truth), "lamps of 64 points each").error(error)).caption(
        "Giving up C's simplifications one by one, the most useful first. The first five steps cost hardly any time."))
}

/// A's pictures with colour only, and with ambient colour.
pub fn documents(lesson: &Lesson, picture: Picture) -> Result {
    let fine = Picture { samples: lesson.flags().spp.map_or(4, u32::from), ..picture };
    let [plain, summed] = [None, Some(0.2)].map(|ambient| ambient_scene(ambient, true));
    let colour = render(&plain?, &Local::default(), fine).image;
    let caption = "Two spheres with a colour and nothing else, under one lamp (A, illustration 18).";
    lesson.save_picture("colour", &colour, caption, "A red and a green matt sphere on a grey floor under a blue sky; where the lamp does not reach they are black.")?;
    let ambient = render(&summed?, &Local::default(), fine).image;
    let caption = "The same with an ambient colour of (0.2, 0.2, 0.2), added to the colour as A says (A, illustration 19).";
    lesson.save_picture(
        "ambient",
        &ambient,
        caption,
        "The same two spheres; their dark sides are now an even grey, and the lit sides paler.",
    )
}

/// A's scene with ambient light of 0.2: added to the spheres as A prints it, or times what they reflect.
fn ambient_scene(ambient: Option<f64>, printed: bool) -> Result<Scene> {
    let mut scene = two_spheres()?;
    let Some(ambient) = ambient else { return Ok(scene) };
    if printed {
        for material in scene.materials.iter_mut().filter(|m| m.name != "floor") {
            material.emissive = Rgb::splat(ambient);
        }
    } else {
        scene.ambient = Rgb::splat(ambient);
    }
    Ok(scene)
}

/// Ambient light added or multiplied.
pub fn ambient(picture: Picture) -> Result<Figure> {
    let shot = |ambient, printed| -> Result<Image> {
        Ok(render(&ambient_scene(ambient, printed)?, &Local::default(), picture).image)
    };
    let (sum, product) = (shot(Some(0.2), true)?, shot(Some(0.2), false)?);
    // A shadowed place of the green sphere, by hand: green reflects (0.12, 0.62, 0.16).
    let green =
        two_spheres()?.materials.iter().find(|m| m.name == "green").map_or(Rgb::ZERO, |m| m.diffuse) * 0.2;
    let panels = Panels::new()
        .columns(2)
        .title("Added, ambient light bleaches colours; multiplied by what a surface reflects, it keeps them")
        .subtitle(&format!(
            "ambient light of 0.2; in its shade the green sphere shows (0.2, 0.2, 0.2) or ({:.3}, {:.3}, {:.3})",
            green.x, green.y, green.z
        ))
        .alt("Four pictures of two spheres: without ambient light the shaded sides are black; with A's sum they are grey; with the product they are dark red and dark green; the difference is positive on both spheres and negative on the floor.")
        .picture(Pixels::from(&shot(None, true)?), "no ambient light (A, ill. 18)")
        .picture(Pixels::from(&sum), "added to the spheres' colour, as printed (A, ill. 19)")
        .picture(Pixels::from(&product), "times what a surface reflects, floor too: I = Iₐ Kₐ (C, eq. 20)")
        .error(difference("sum − product", &sum, &product, 0.2));
    Ok(Figure::from(panels).caption(
        "A adds its ambient colour to the material: a black sphere would glow. C multiplies by the reflectance, as light that \
         comes from everywhere must be. Ours is C's, with Kₐ = K_d: what reflects lamps reflects ambient light."))
}

/// A's formulas of light that leaves, as printed: colour times `law(cos θ)` times the light's colour.
fn printed(law: fn(f64) -> f64, ray: &Ray, scene: &Scene) -> Rgb {
    let Some((i, crossing)) = scene.nearest(ray, f64::INFINITY, &mut Silent) else {
        return scene.background;
    };
    let hit = scene.hit(ray, i, &crossing);
    let color = scene.materials[scene.objects[i].material(hit.part)].diffuse;
    let Some(arrival) = scene.lights.first().and_then(|l| l.arriving(hit.point)) else {
        return Rgb::ZERO;
    };
    let colour_of_light = arrival.irradiance / std::f64::consts::PI;
    color * colour_of_light * law(hit.n.dot(arrival.wi))
}

/// (4.5), (4.6), and Lambert's law.
pub fn laws(picture: Picture) -> Result<Figure> {
    let scene = two_spheres()?;
    let flat = shade(&scene, picture, |ray, scene| printed(|_| lambertian_as_printed(1.0), ray, scene));
    let cosine = shade(&scene, picture, |ray, scene| printed(phong_as_printed, ray, scene));
    let unshadowed = Local { stage: Stage::Unshadowed, ..Local::default() };
    let lambert = render(&scene, &unshadowed, picture).image;
    let clamped = cosine.map(|p| p.max(Rgb::ZERO));
    let same = compare(&clamped, &lambert).max_error.abs();
    let negative = cosine.pixels().iter().filter(|p| p.min_element() < 0.0).count();
    let share = 100.0 * negative as f64 / cosine.pixels().len() as f64;
    let panels = Panels::new()
        .columns(2)
        .title("A's “Lambertian” knows no lamp, and A's “Phong” is Lambert's law, but for light below zero")
        .subtitle(&format!(
            "without shadows; where cos θ ≥ 0 (4.6) and Lambert's law differ by at most {}; below zero: {share:.1} % of the pixels",
            short(same)
        ))
        .alt("Four pictures of two spheres: flat discs of even colour; spheres shaded from the lamp; the same again; and their difference, which is negative on the sides away from the lamp and zero elsewhere.")
        .picture(Pixels::from(&flat), "(4.5) “Lambertian diffuse”: I = c₁/π, as printed")
        .picture(Pixels::from(&cosine), "(4.6) “Phong”: I = cos(u, n), as printed")
        .picture(Pixels::from(&lambert), "Lambert: I = max(cos θ, 0)")
        .error(difference("(4.6) − Lambert", &cosine, &lambert, 0.5));
    Ok(Figure::from(panels).caption(
        "A §4.2.1–2. 1/π is the matt surface's BRDF, not its light: the cosine of the transport is missing, and shape with it. The \
         cosine alone is the light that leaves, in units of a facing surface; as printed it turns negative behind the horizon."))
}
