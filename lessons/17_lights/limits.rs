//! Where lights fail: endlessly far, in a surface, under the floor, inside things.

use super::stage::{OMNI, omni, other, parallel, sphere_on_floor};
use glam::{DVec3, Vec3, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::integrator::Local;
use lightbench::light::Light;
use lightbench::light::as_printed::{LAMBDA, attenuation_as_printed, hides_as_printed};
use lightbench::light::{Attenuation, PointLight};
use lightbench::measure::{Method, Point, Series, Spread};
use lightbench::ray::{Ray, Silent};
use lightbench::render::{Picture, render, shade};
use lightbench::scene::Scene;
use lightbench::shape::Shape;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};
use lightbench_kit::lesson::Result;
use std::f64::consts::FRAC_1_PI;

/// Towards the light that moves away.
const TOWARDS: DVec3 = dvec3(0.6, 0.7, 0.4);

/// Lambert and a hard shadow of one point light, its direction computed without care: **wrong** far away.
struct Naive {
    place: DVec3,
    /// In 24 bits, as in the documents' programs, or 53.
    single: bool,
}

impl Naive {
    fn radiance(&self, ray: &Ray, scene: &Scene) -> Rgb {
        let Some((object, crossing)) = scene.nearest(ray, f64::INFINITY, &mut Silent) else {
            return scene.background;
        };
        let hit = scene.hit(ray, object, &crossing);
        let origin = hit.origin_towards(hit.ng);
        let (to, wi) = if self.single {
            let to = self.place.as_vec3() - origin.as_vec3();
            let length: f32 = (to.x * to.x + to.y * to.y + to.z * to.z).sqrt();
            let wi: Vec3 = to / length;
            (to.as_dvec3(), wi.as_dvec3())
        } else {
            let to = self.place - origin;
            (to, to / (to.x * to.x + to.y * to.y + to.z * to.z).sqrt())
        };
        let material = &scene.materials[scene.objects[object].material(hit.part)];
        let cos = hit.ng.dot(wi);
        let lit = cos > 0.0 && scene.blocker(&Ray::new(origin, to), 1.0, &mut Silent).is_none();
        let direct = if lit { cos } else { 0.0 };
        material.diffuse * (scene.ambient + Rgb::splat(direct))
    }
}

fn difference(image: &Image, truth: &Image) -> f64 {
    let each = image.pixels().iter().zip(truth.pixels()).map(|(a, b)| (*a - *b).abs().max_element());
    each.fold(0.0, |m, d| if d.is_nan() { d } else { f64::max(m, d) })
}

/// What becomes of a light that moves away.
pub struct Far {
    pub exponents: Vec<f64>,
    /// Largest difference from the directional picture: the library's, that of careless 53 bits, that of 24 bits.
    pub errors: [Vec<f64>; 3],
}

pub fn far(picture: Picture, exponents: &[f64]) -> Result<Far> {
    let wi = TOWARDS.normalize();
    let sun = sphere_on_floor(vec![parallel(-wi, 1.0)?])?;
    let truth = render(&sun, &Local::default(), picture).image;
    let mut errors = [Vec::new(), Vec::new(), Vec::new()];
    for k in exponents {
        let place = wi * 10f64.powf(*k);
        let scene = sphere_on_floor(vec![omni(place, 1.0)])?;
        let [wide, single] = [false, true]
            .map(|single| Naive { place, single })
            .map(|n| shade(&scene, picture, |r, s| n.radiance(r, s)));
        let ours = render(&scene, &Local::default(), picture).image;
        for (errors, image) in errors.iter_mut().zip([ours, wide, single]) {
            errors.push(difference(&image, &truth));
        }
    }
    Ok(Far { exponents: exponents.to_vec(), errors })
}

/// Up to there the chart goes; beyond, the table.
const CHARTED: f64 = 24.0;

impl Far {
    /// The largest error of the library's pictures from a distance on.
    pub fn worst_beyond(&self, exponent: f64) -> f64 {
        let far = self.exponents.iter().zip(&self.errors[0]).filter(|(k, _)| **k >= exponent);
        far.map(|(_, e)| *e).fold(0.0, f64::max)
    }

    pub fn figure(&self) -> Figure {
        let chart = Chart::error_over(Axis::log("distance of the light [m]"), "largest change of radiance [W m⁻² sr⁻¹]")
            .title("A light moved away becomes the sun; in 24 bits it goes out at 10¹⁹ m")
            .subtitle("a sphere of 1 m on a floor under a point light without attenuation, against parallel light from there")
            .guide(Guide::slope_through(-1.0, 1.0e3, 2.0e-3, "size/distance"));
        let methods = [
            Some(Method::default_of("53 bits").styled(0)),
            None, // as the library's up to there
            Some(Method::new("24 bits, to/|to|").styled(1)),
        ];
        let chart = methods.into_iter().zip(&self.errors).fold(chart, |chart, (method, errors)| {
            let near = self.exponents.iter().zip(errors).filter(|(k, _)| **k <= CHARTED);
            let points = near.map(|(k, e)| Point::at(10f64.powf(*k)).erred(Spread::exact(*e))).collect();
            match method {
                Some(method) => chart.line(method, &Series::new(points)),
                None => chart,
            }
        });
        Figure::from(chart).caption(
            "Rays from a far light are parallel but for the scene's size over its distance; no shadow's edge moves by a pixel any more from \
             10⁴ m on. In the documents' 24 bits the squares in |to| overflow at 1.8·10¹⁹ m: the direction becomes 0, and all is dark.")
    }

    pub fn table(&self) -> Table {
        let mut table = Table::new(&["distance [m]", "the library", "to/|to| in 53 bits", "to/|to| in 24 bits"])
            .title("Carelessly computed, a light goes out at 10¹⁵⁵ m; the library's shines to the end of numbers")
            .subtitle("largest change of radiance against parallel light; dark: the sum of squares has overflowed, and the direction is 0");
        for (i, k) in
            self.exponents.iter().enumerate().filter(|(_, k)| k.fract() == 0.0 && (**k == 6.0 || **k >= 12.0))
        {
            let cell = |errors: &[f64]| match errors[i] {
                0.0 => "0".to_string(),
                e if e > 0.1 || e.is_nan() => "dark".to_string(),
                e => short(e),
            };
            let cells = self.errors.each_ref().map(|e| cell(e));
            table = table.row(&[&short(10f64.powf(*k)), &cells[0], &cells[1], &cells[2]]);
        }
        table
    }
}

/// Lights in odd places, and what they light.
pub fn odd_places(picture: Picture) -> Result<Table> {
    let mut table =
        Table::new(&["where the light is", "pixels of floor lit", "of the sphere", "NaN", "what holds"])
            .title("Lights in surfaces, under floors, inside things: no speckles, no NaN")
            .subtitle(&format!(
                "A's sphere on a floor, {} × {} pixels; a point light of 1 W/sr at each place",
                picture.width, picture.height
            ));
    let eye = sphere_on_floor(Vec::new())?;
    let target = |x: usize, y: usize| {
        let ray =
            eye.camera.ray(glam::DVec2::new(x as f64 + 0.5, y as f64 + 0.5), picture.width, picture.height);
        let met = eye.nearest(&ray, f64::INFINITY, &mut Silent);
        met.map(|(i, crossing)| (i, eye.hit(&ray, i, &crossing).point))
    };
    let on_sphere = target(picture.width / 2, picture.height / 2).map_or(DVec3::Y, |t| t.1);
    for (name, place, holds) in [
        ("2 m over the floor", dvec3(2.5, 2.0, 2.0), "floor but for its shadow, half of the sphere"),
        ("10⁻⁹ m over the floor", dvec3(2.5, 1.0e-9, 2.0), "floor at a grazing angle, the sphere from below"),
        (
            "in the floor",
            dvec3(2.5, 0.0, 2.0),
            "no floor; the sphere, unhidden by the floor that carries the light",
        ),
        ("10⁻⁹ m under the floor", dvec3(2.5, -1.0e-9, 2.0), "nothing"),
        ("in the sphere's surface, where a ray meets it", on_sphere, "what lies over the tangent plane"),
        ("inside the sphere", dvec3(0.2, 1.1, 0.1), "nothing: its own sphere hides all"),
        ("in the camera", eye.camera.position(), "all that is seen: no shadow shows"),
    ] {
        let mut scene = sphere_on_floor(vec![PointLight::of_intensity(place, Rgb::ONE).into()])?;
        scene.ambient = Rgb::ZERO;
        let image = render(&scene, &Local::default(), picture).image;
        let (mut lit, mut seen, mut nan) = ([0u32; 2], [0u32; 2], 0);
        for y in 0..picture.height {
            for x in 0..picture.width {
                let Some((object, _)) = target(x, y) else { continue };
                let value = image.get(x, y);
                seen[object] += 1;
                lit[object] += u32::from(value.max_element() > 0.0);
                nan += u32::from(!value.is_finite());
            }
        }
        let share = |i: usize| format!("{:.1} %", 100.0 * f64::from(lit[i]) / f64::from(seen[i].max(1)));
        table = table.row(&[name, &share(0), &share(1), &nan.to_string(), holds]);
    }
    Ok(table)
}

/// A's attenuation against the law that it caps.
pub fn printed() -> Result<Table> {
    let law = Attenuation::polynomial([0.0, 0.0, 1.0]).map_err(other)?;
    let mut table = Table::new(&["distance [m]", "1/d²", "A ill. 67", "share of the light"])
        .title("A's cap of 1 keeps 1 % of the light at 0.1 m")
        .subtitle("attenuation 1/(a + b d + c d²) with a = b = 0 and c = 1, cut off at 1 as printed");
    for d in [1.0e-3, 0.01, 0.1, 0.5, 1.0, 2.0, 10.0] {
        let (holds, printed) = (law.factor(d), attenuation_as_printed([0.0, 0.0, 1.0], d));
        let share = format!("{:.4} %", 100.0 * printed / holds);
        table = table.row(&[&format!("{d}"), &short(holds), &short(printed), &share]);
    }
    Ok(table)
}

/// A's shadow test in scenes of many sizes: places of the floor that are hidden by the sphere, and that it finds so.
pub fn printed_shadows(side: usize) -> Result<Table> {
    let mut table = Table::new(&["length of the scene's metre [m]", "places in shadow", "A ill. 67 finds", "lost"])
        .title("A's tolerance of 10⁻⁶ loses every shadow of a scene of 10⁻⁷ m")
        .subtitle(&format!(
            "A's sphere over {side} × {side} places of its floor, all lengths multiplied; hidden if d < D − {LAMBDA}, measured from the light"
        ));
    for size in [1.0e-8, 1.0e-7, 3.0e-7, 1.0e-6, 1.0e-3, 1.0, 1.0e6] {
        let sphere = Sphere::new(DVec3::Y * size, size).map_err(other)?;
        let lamp = OMNI[0] * size;
        let (mut holds, mut printed) = (0, 0);
        for k in 0..side * side {
            let at = |i: usize| 5.0 * (i as f64 + 0.5) / side as f64;
            let place = dvec3(at(k % side) - 4.0, 0.0, at(k / side) - 2.5) * size;
            let to = place - lamp;
            let met = sphere.nearest(&Ray::new(lamp, to), 0.0, f64::INFINITY).map(|c| c.t * to.length());
            holds += usize::from(sphere.blocks(&Ray::new(place, -to), 1.0));
            printed += usize::from(met.is_some_and(|d| hides_as_printed(d, to.length())));
        }
        let lost = 100.0 * (1.0 - printed as f64 / holds as f64);
        table = table.row(&[&short(size), &holds.to_string(), &printed.to_string(), &format!("{lost:.1} %")]);
    }
    Ok(table)
}

/// The measures of the documents and the library: irradiance of a facing surface.
pub fn units() -> Result<Table> {
    let law = |a: f64, b: f64, c: f64| Attenuation::polynomial([a, b, c]).map_err(other);
    let shine =
        |attenuation| Light::from(PointLight::of_color(DVec3::ZERO, Rgb::ONE).with_attenuation(attenuation));
    let one = |f: fn(DVec3, Rgb) -> PointLight, amount: f64| Light::from(f(DVec3::ZERO, Rgb::splat(amount)));
    let spot = lightbench::light::SpotLight::new(
        PointLight::of_intensity(DVec3::ZERO, Rgb::ONE),
        DVec3::X,
        0.1,
        0.3,
    );
    let sun = lightbench::light::DirectionalLight::new(DVec3::NEG_X, Rgb::ONE).map_err(other)?;
    let rows = [
        ("D §4.10", "Color 1, no fall-off", "π c", shine(Attenuation::None)),
        ("A §4.3.3", "direction, intensity 1", "π I", parallel(DVec3::NEG_X, 1.0)?),
        ("A (4.1)", "I/d", "π I/d", shine(law(0.0, 1.0, 0.0)?)),
        ("A (4.2), C §1.8.3", "I/d²", "π I/d²", shine(Attenuation::InverseSquare)),
        ("A (4.3), C §1.8.3", "I/(1 + d/2 + d²/4)", "π I/(a + b d + c d²)", shine(law(1.0, 0.5, 0.25)?)),
        ("C §1.8.3", "I/(d + 1)", "π I/(d + d₀)", shine(law(1.0, 1.0, 0.0)?)),
        ("A ill. 67", "min(1, 1/d²)", "π I min(1, 1/d²)", shine(Attenuation::InverseSquare.capped(1.0))),
        ("B §7.3.2", "flux 4π W", "Φ/(4π d²)", one(PointLight::of_flux, 4.0 / FRAC_1_PI)),
        ("ours", "Intensity 1 W/sr", "I/d²", one(PointLight::of_intensity, 1.0)),
        ("ours", "the same in a cone, on its axis", "I share/d²", spot.map_err(other)?.into()),
        ("ours", "Irradiance 1 W/m², parallel", "E", sun.into()),
    ];
    let mut table = Table::new(&["source", "the light says", "irradiance of a facing surface", "at 0.5 m", "1 m", "2 m", "4 m"])
        .title("One unit for all lights: irradiance [W/m²]; only 1/d² is how light thins out")
        .subtitle("ρ/π times this times cos θ is the radiance of a matt surface; colours and intensities 1, computed by the library");
    for (source, says, formula, light) in rows {
        let value = |d: f64| light.arriving(DVec3::NEG_X * -d).map_or(f64::NAN, |a| a.irradiance.x);
        let cells = [0.5, 1.0, 2.0, 4.0].map(|d| format!("{:.4}", value(d)));
        table = table.row(&[source, says, formula, &cells[0], &cells[1], &cells[2], &cells[3]]);
    }
    Ok(table)
}
