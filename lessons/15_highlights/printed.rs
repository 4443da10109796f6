//! A's highlight as worded and as printed: an integrator, and a table of what each gets wrong.

use glam::DVec3;
use lightbench::bsdf::as_printed::{
    highlight_as_printed, highlight_as_worded, phong_as_printed, reflected_light_as_printed,
};
use lightbench::bsdf::highlight::power;
use lightbench::bsdf::{Directions, Geometry};
use lightbench::color::Rgb;
use lightbench::light::Attenuation;
use lightbench::ray::{Ray, Silent};
use lightbench::scene::{Met, Scene};
use lightbench_kit::figure::{Figure, Table, short};
use std::f64::consts::FRAC_1_PI;

/// What A's highlight is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formula {
    /// §3.3's text.
    Worded,
    /// Ill. 21.
    Code,
}

/// Light reflected by ill. 68, on every object with a model; others are matt.
pub struct Printed {
    pub formula: Formula,
    pub shininess: f64,
    pub specular: f64,
}

impl Printed {
    /// Radiance that a camera ray brings.
    pub fn radiance(&self, ray: &Ray, scene: &Scene) -> Rgb {
        let Some(Met::Object(i, crossing)) = scene.first_met(ray, &mut Silent) else {
            return scene.background;
        };
        let (hit, object) = (scene.hit(ray, i, &crossing), &scene.objects[i]);
        let material = &scene.materials[object.material(hit.part)];
        let v = -ray.direction.normalize();
        let n = if hit.n.dot(v) < 0.0 { -hit.n } else { hit.n };
        let origin = hit.origin_towards(n);
        let specular = if material.model.is_some() { self.specular } else { 0.0 };
        let mut sum = Rgb::ZERO;
        for arrival in scene.lights.iter().filter_map(|light| light.arriving(origin)) {
            let cos = n.dot(arrival.wi).max(0.0);
            let hidden = scene.blocker(&Ray::new(origin, arrival.to), arrival.t_max, &mut Silent).is_some();
            let arrives = if hidden { Rgb::ZERO } else { arrival.irradiance * FRAC_1_PI };
            let highlight = match self.formula {
                Formula::Worded => 0.0,
                Formula::Code => highlight_as_printed(arrival.wi, n, v, self.shininess, specular),
            };
            let matt = phong_as_printed(cos);
            sum += reflected_light_as_printed(material.diffuse, scene.ambient, arrives, matt, highlight);
            if self.formula == Formula::Worded {
                // Nearer to white, says the text.
                sum += Rgb::splat(highlight_as_worded(arrival.wi, v, self.shininess, specular));
            }
        }
        sum
    }
}

/// A direction in the plane of incidence, to the right, at an angle [degrees].
fn at(degrees: f64) -> DVec3 {
    DVec3::new(degrees.to_radians().sin(), 0.0, degrees.to_radians().cos())
}

/// The three formulas, case by case.
pub fn table() -> Figure {
    const N: f64 = 20.0;
    let worded = |l, v| highlight_as_worded(at(l), at(v), N, 1.0);
    let code = |l, v| highlight_as_printed(at(l), DVec3::Z, at(v), N, 1.0);
    let right = |l: f64, v: f64| {
        if l.abs() >= 90.0 {
            return 0.0;
        }
        power(Directions { wi: at(l), wo: at(v) }.mirror_versine(), N)
    };
    let mut table = Table::new(&["Case", "as worded, §3.3", "as printed, ill. 21, 68", "what holds"])
        .title("A's words shine back at the lamp; A's code is Phong's, but deaf to what arrives")
        .subtitle("n = 20, white lamp, coefficient 1, angles from the normal; black matt part");
    for (name, l, v) in [
        ("lamp 40° left, viewer 40° right: the mirror's place", -40.0, 40.0),
        ("lamp and viewer both 40° left", -40.0, -40.0),
        ("lamp 40° left, viewer 25° right", -40.0, 25.0),
        ("lamp 5° below the horizon, viewer 5° above it", -95.0, 85.0),
    ] {
        table = table.row(&[name, &short(worded(l, v)), &short(code(l, v)), &short(right(l, v))]);
    }
    // Ill. 68: the mirror's place, white material but where the colour is the question.
    let shown =
        |color: Rgb, lamp: Rgb| reflected_light_as_printed(color, Rgb::ZERO, lamp, 0.0, code(-40.0, 40.0));
    let rgb = |c: Rgb| c.to_array().map(short).join(" : ");
    let (white, red, lamp) = (Rgb::ONE, Rgb::new(0.8, 0.1, 0.1), Rgb::new(1.0, 0.6, 0.2));
    let quarter = Rgb::splat(Attenuation::InverseSquare.factor(4.0));
    let three: Rgb =
        (0..3).map(|_| reflected_light_as_printed(white, Rgb::splat(0.2), Rgb::ZERO, 0.0, 0.0)).sum();
    for (name, found, holds) in [
        ("the mirror's place, in shadow", short(shown(white, Rgb::ZERO).x), short(0.0)),
        ("the mirror's place, lamp at 4 m under 1/d²", short(shown(white, quarter).x), short(quarter.x)),
        ("red material, yellow lamp: r : g : b", rgb(shown(red, lamp)), rgb(lamp)),
        ("no light but ambient 0.2, three lamps", short(three.x), short(0.2)),
    ] {
        table = table.row(&[name, "", &found, &holds]);
    }
    Figure::from(table).caption(
        "A's highlight, as §3.3 words it and as illustrations 21 and 68 print it. The formula of the code is right; what is wrong stands around it: \
         the highlight is added to the light that arrives instead of being a share of it, and the whole is multiplied by the material's colour, so that \
         it is not “nearer to white”, as the text has it.",
    )
}
