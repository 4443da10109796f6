//! The rendered pictures.

use super::stage::{
    OMNI, PARALLEL, coloured, evening, omni, parallel, ring_of_lights, sphere_on_floor, spots,
};
use lightbench::integrator::Local;
use lightbench::render::{Picture, render};
use lightbench::scene::Scene;
use lightbench_kit::figure::{Figure, Panels, Pixels};
use lightbench_kit::lesson::{Lesson, Result};

fn shot(lesson: &Lesson, scene: &Scene, [width, height]: [usize; 2]) -> lightbench::film::Image {
    let part = lesson.pick([8, 1, 1, 1]);
    let samples = lesson.flags().spp.map_or(lesson.pick([1, 4, 16, 16]), u32::from);
    let picture = Picture { width: width / part, height: height / part, samples, seed: lesson.seed() };
    render(scene, &Local::default(), picture).image
}

/// A, illustrations 38, 39, 42 and 43: the same sphere under four sets of lights.
pub fn documents(lesson: &Lesson) -> Result<Figure> {
    let lights = [
        ("one point light (A ill. 38)", vec![omni(OMNI[0], 0.95)]),
        ("two point lights (A ill. 39)", OMNI.map(|p| omni(p, 0.55)).to_vec()),
        ("parallel light along (−1, −1, 0) (A ill. 42)", vec![parallel(PARALLEL[0], 0.95)?]),
        (
            "along (−1, −1, 0) and (−1, −1, 1) (A ill. 43)",
            vec![parallel(PARALLEL[0], 0.55)?, parallel(PARALLEL[1], 0.55)?],
        ),
    ];
    let mut panels = Panels::new().columns(2);
    for (name, lights) in lights {
        let image = shot(lesson, &sphere_on_floor(lights)?, [560, 292]);
        panels = panels.picture(Pixels::from(&image), name);
    }
    let panels = panels
        .title("Shadows from a point widen on their way, in parallel light they do not")
        .subtitle("A's sphere on a floor; where two shadows cross, no light arrives but the ambient")
        .alt("Four pictures of a clay-coloured sphere on a grey floor. Under one point light its shadow is an ellipse that widens to \
              the left; under two it has two shadows, darker where they cross. In parallel light the shadow keeps the sphere's width.");
    Ok(Figure::from(panels).caption(
        "Hard shadows of one and two point lights, of one and two directional lights (A, illustrations 38, 39, 42, 43). A gives the \
         directions; the places are ours."))
}

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("four_lights", documents(lesson)?)?;
    let image = shot(lesson, &coloured()?, [720, 460]);
    lesson.save_picture(
        "coloured",
        &image,
        "Red, green and blue light make white together; where one is blocked its complement is left: cyan, magenta, yellow, and the \
         pure colours where two are.",
        "A white ball on a white floor with three shadows in cyan, magenta and yellow, which are red, green and blue where two of \
         them cross, and black under the ball.",
    )?;
    let image = shot(lesson, &spots()?, [720, 370]);
    lesson.save_picture(
        "spots",
        &image,
        "Three spots of the same cone: full light only on its axis, within three quarters of it, and up to its hard rim.",
        "On a dark floor three discs of light: an orange one that fades from its middle, with a ball; a white one with a narrow soft \
         rim, with a cylinder; a blue one with a sharp rim, with a box. Each thing throws a hard shadow.",
    )?;
    let image = shot(lesson, &ring_of_lights(12)?, [600, 400]);
    lesson.save_picture(
        "ring_of_lights",
        &image,
        "A sphere under a ring of 12 point lights (B, illustration 3.8): each throws a shadow of its own; many make a soft one.",
        "A clay ball on a white floor in the middle of a flower of 12 round shadows.",
    )?;
    let image = shot(lesson, &evening()?, [720, 440]);
    lesson.save_picture(
        "cast_shadow",
        &image,
        "The shadow that a sphere casts (B, illustration 7.20), here in a low sun.",
        "A white ball on a floor in warm low light; its long elliptic shadow reaches to the left.",
    )
}
