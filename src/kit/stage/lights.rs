//! The lights of the stage, and the meter that sets their strength.

use super::{BRIGHTEST, RenderSize, Stage, colour};
use crate::color::Rgb;
use crate::light::{AreaLight, Emission, Light, Rectangle, polygon_irradiance};
use crate::sample::Pattern;
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::PI;

/// A rectangle of light: where its centre stands (right, up, front from the subject's foot), its size, and what it brings
/// to a surface at the subject's centre that faces it, in parts of the key light.
struct Panel {
    at: [f64; 3],
    size: DVec2,
    brings: Rgb,
    /// Shadow rays a pixel, at least.
    points: u32,
}

const PANELS: [Panel; 4] = [
    // The key: 45° above, a little in front.
    Panel { at: [-6.4, 8.4, 3.8], size: dvec2(5.5, 5.5), brings: Rgb::new(1.0, 0.965, 0.91), points: 8 },
    // The fill, from the other side, low: it stands for what a room sends back.
    Panel { at: [5.0, 1.7, 7.5], size: dvec2(9.0, 3.2), brings: Rgb::new(0.19, 0.21, 0.24), points: 4 },
    // The rim, behind and above, out of view.
    Panel { at: [4.2, 6.5, -4.6], size: dvec2(5.0, 2.0), brings: Rgb::new(0.33, 0.35, 0.37), points: 4 },
    // The ceiling, for whatever the others leave dark.
    Panel { at: [1.0, 10.0, 3.0], size: dvec2(14.0, 14.0), brings: Rgb::new(0.46, 0.46, 0.455), points: 8 },
];
/// All lights of a stage, at the strength that its meter asks for.
pub fn lights(stage: &Stage, size: &RenderSize) -> Vec<Light> {
    let panels = PANELS.each_ref().map(|p| rectangle(stage, p));
    let strength = BRIGHTEST / brightest(stage, &panels);
    let light = |(panel, (rectangle, radiance)): (&Panel, (Rectangle, Rgb))| {
        let light = AreaLight::new(rectangle, Emission::diffuse(radiance * strength));
        light.sampled(size.points(panel.points), Pattern::Sobol).into()
    };
    PANELS.iter().zip(panels).map(light).collect()
}

/// The panel turned to the subject, and its radiance for what it brings.
fn rectangle(stage: &Stage, panel: &Panel) -> (Rectangle, Rgb) {
    let [right, up, front] = panel.at;
    let at = stage.at(right, up, front);
    let towards = stage.center - at;
    let rectangle =
        Rectangle::facing(at, towards, 0.0, panel.size * stage.radius).expect("a panel in its place");
    let of_one = polygon_irradiance(&rectangle.corners(), stage.center, -towards.normalize());
    (rectangle, panel.brings / of_one)
}

/// Radiance of the brightest place of a ball of paper instead of the subject, and of a ground of paper up to three radii
/// round it, if the lights have their strength in parts and nothing stands in their way.
fn brightest(stage: &Stage, panels: &[(Rectangle, Rgb); 4]) -> f64 {
    let lit = |p: DVec3, n: DVec3| {
        let panels = panels.iter().map(|(r, radiance)| *radiance * polygon_irradiance(&r.corners(), p, n));
        (panels.sum::<Rgb>() * colour::PAPER).max_element() / PI
    };
    let ball = (0..METERED).map(spiral).map(|n| lit(stage.center + n * stage.radius, n));
    let ground = (0..METERED).map(|i| {
        let [x, z] = [i % 32, i / 32].map(|k| 6.0 * (f64::from(k) + 0.5) / 32.0 - 3.0);
        lit(stage.at(x, 0.0, z), DVec3::Y)
    });
    ball.chain(ground).fold(0.0, f64::max)
}

/// Places at which each of the two is metered.
const METERED: u32 = 1024;

/// Directions that are spread evenly: the Fibonacci lattice.
fn spiral(i: u32) -> DVec3 {
    let (height, turn) =
        (1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(METERED), f64::from(i) * 0.618_033_988_749_895);
    let flat = ((1.0 - height) * (1.0 + height)).sqrt();
    let (sin, cos) = (turn * 2.0 * PI).sin_cos();
    DVec3::new(flat * cos, height, flat * sin)
}
