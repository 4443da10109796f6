//! Pictures of lamps at the eye, near and far, and of a sphere under one.

use super::model::{AMBIENT, LAMPS, other, two_spheres};
use glam::{DVec3, dvec3};
use lightbench::color::Rgb;
use lightbench::integrator::{Local, Stage};
use lightbench::light::{DirectionalLight, Light, PointLight};
use lightbench::render::{Picture, render};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Figure, Panels, Pixels, grouped};
use lightbench_kit::lesson::{Lesson, Result};

/// C fig. 9: a lamp at the eye shows no shadow. Also, how many pixels shadows change.
pub fn at_the_eye(picture: Picture) -> Result<(Figure, [usize; 4])> {
    let mut scene = two_spheres()?;
    scene.ambient = AMBIENT;
    let (eye, color) = (scene.camera.position(), Rgb::splat(0.85));
    let along = scene.camera.frame().forward;
    let beside = eye + scene.camera.frame().right * 0.5;
    let lamps: [(&str, Light); 4] = [
        ("lamp aside", PointLight::of_color(LAMPS[0].0, color).into()),
        ("lamp at the eye", PointLight::of_color(eye, color).into()),
        ("lamp 0.5 m beside the eye", PointLight::of_color(beside, color).into()),
        ("parallel to the view", DirectionalLight::of_color(along, color).map_err(other)?.into()),
    ];
    let mut changed = [0; 4];
    let mut shown = Vec::new();
    for ((name, lamp), changed) in lamps.into_iter().zip(&mut changed) {
        scene.lights = vec![lamp];
        let [with, without] = [Stage::Shadowed, Stage::Unshadowed]
            .map(|stage| render(&scene, &Local { stage, ..Local::default() }, picture).image);
        *changed = with.pixels().iter().zip(without.pixels()).filter(|(p, q)| p != q).count();
        shown.push((Pixels::from(&with), format!("{name}: {} pixels change", grouped(*changed as u64))));
    }
    let mut panels = Panels::new()
        .columns(2)
        .title(&format!(
            "A lamp at the eye shows no shadow: shadow rays change {} of {} pixels; half a metre beside it, {}",
            changed[1],
            grouped((picture.width * picture.height) as u64),
            grouped(changed[2] as u64)
        ))
        .subtitle(&format!(
            "two spheres, {} × {} pixels, one ray each; under each picture, how many pixels shadows change",
            picture.width, picture.height
        ))
        .alt("Four pictures of two spheres: with a lamp aside both throw shadows; with the lamp at the eye there are none and everything looks flat; half a metre beside it, and under light parallel to the view, thin shadows show beside the spheres.");
    for (pixels, label) in shown {
        panels = panels.picture(pixels, &label);
    }
    let caption = "Simplification 3 pays for simplification 4 (C, figure 9): what the eye sees, a lamp in its place lights. C also allows a lamp near the eye, and with simplification 9 one that only has its direction: both throw shadows that are seen.";
    Ok((Figure::from(panels).caption(caption), changed))
}

/// C fig. 24: a near and a far lamp, and parallel light.
pub fn near_and_far(picture: Picture) -> Result<Figure> {
    let mut scene = Scene::new(
        Camera::new(dvec3(0.0, 5.2, 6.4), dvec3(0.0, -0.1, 0.0), DVec3::Y, FieldOfView::Vertical(0.4))
            .map_err(other)?,
    );
    let matt = |diffuse| Material { diffuse, ..Material::default() };
    scene.materials = vec![matt(Rgb::splat(0.8)), matt(dvec3(0.75, 0.32, 0.1))];
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).map_err(other)?;
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    for (x, z) in (-2..=2).flat_map(|x| (-1..=1).map(move |z| (f64::from(x), f64::from(z)))) {
        let ball = Sphere::new(dvec3(x * 0.9, 0.16, z * 0.9), 0.16).map_err(other)?;
        scene.objects.push(Object::new("ball", Box::new(ball), 1));
    }
    scene.ambient = Rgb::splat(0.06);
    let mut panels = Panels::new()
        .columns(3)
        .title("A near lamp's rays fan out, a far one's are as good as parallel")
        .subtitle("the same irradiance in the middle of the floor; inverse square; balls 0.9 m apart")
        .alt("Three pictures of rows of balls on a floor: under a near lamp a pool of light with shadows that point outwards; under a far lamp an even floor with equal shadows; under parallel light the same.");
    let straight = dvec3(0.35, 1.0, 0.15).normalize();
    for distance in [1.4, 14.0, f64::INFINITY] {
        let (light, label): (Light, _) = if distance.is_finite() {
            let at = straight * distance;
            (
                PointLight::of_intensity(at, Rgb::splat(2.6 * distance * distance)).into(),
                format!("lamp at {distance} m"),
            )
        } else {
            let light = DirectionalLight::new(-straight, Rgb::splat(2.6)).map_err(other)?;
            (light.into(), "parallel light".to_string())
        };
        scene.lights = vec![light];
        panels = panels.picture(Pixels::from(&render(&scene, &Local::default(), picture).image), &label);
    }
    Ok(Figure::from(panels).caption(
        "A near and a far source (C, figure 24), and what the far one is replaced by in simplification 9.",
    ))
}

/// B 7.12: a sphere under one lamp.
pub fn sphere(lesson: &Lesson, picture: Picture) -> Result {
    let view = FieldOfView::Vertical(0.56);
    let mut scene =
        Scene::new(Camera::new(dvec3(0.0, 0.0, 4.4), DVec3::ZERO, DVec3::Y, view).map_err(other)?);
    scene.background = Rgb::splat(0.9);
    scene.materials.push(Material { diffuse: dvec3(0.82, 0.68, 0.5), ..Material::default() });
    scene.objects.push(Object::new("sphere", Box::new(Sphere::new(DVec3::ZERO, 1.0).map_err(other)?), 0));
    scene.lights.push(DirectionalLight::of_color(dvec3(-0.5, -1.0, -0.45), Rgb::ONE).map_err(other)?.into());
    scene.ambient = Rgb::splat(0.05);
    let fine = Picture { samples: lesson.flags().spp.map_or(4, u32::from), ..picture };
    let caption =
        "A sphere's brightness falls as its normal turns away from the light (B, illustration 7.12).";
    lesson.save_picture(
        "sphere",
        &render(&scene, &Local::default(), fine).image,
        caption,
        "A pale brown sphere lit from above right; brightness falls evenly towards a dark lower left edge.",
    )
}
