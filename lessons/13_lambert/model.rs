//! C's local model of light with each of its ten simplifications as a switch, on A's two spheres.
//!
//! What is not simplified stands here in its plainest form, to have a picture to compare with. Later lessons do it
//! properly: highlights (15), transparency (20), textures (21), areas of light (19).

use glam::{DMat3, DVec2, DVec3, dvec3};
use lightbench::bsdf::{Blinn, Lambert, Lobes, ParameterError};
use lightbench::color::Rgb;
use lightbench::integrator::Integrator;
use lightbench::light::{DirectionalLight, Light, PointLight};
use lightbench::ray::{Hit, Ray, RayKind, Trace, Work};
use lightbench::sample::{Cells, Sampler, uniform_disc};
use lightbench::scene::Scene;
use lightbench_kit::lesson::{LessonError, Result};
use lightbench_kit::scene_file::{Color, read};
use std::f64::consts::{FRAC_1_PI, PI};
use std::fmt::Display;

const TWO_SPHERES: &str = include_str!("../../scenes/a18_two_spheres.scene");
/// Where all lamps bring the same irradiance, whatever is simplified: what the camera looks at [m].
pub const MIDDLE: DVec3 = dvec3(0.1, 0.85, 0.0);
/// A lamp's centre [m], and its colour: a facing surface of reflectance ρ at the middle shows ρ times it.
pub const LAMPS: [(DVec3, Rgb); 2] =
    [(dvec3(3.5, 6.0, 4.5), dvec3(0.78, 0.72, 0.62)), (dvec3(-6.0, 3.0, 3.5), dvec3(0.14, 0.18, 0.26))];
pub const RADIUS: f64 = 0.8; // m, of both lamps
pub const AMBIENT: Rgb = dvec3(0.13, 0.14, 0.16); // W/(m² sr)
const OPACITY: f64 = 0.45; // of each of the green sphere's two surfaces
const HIGHLIGHT: (f64, f64) = (60.0, 0.08); // exponent; share of the light
const CHECKER: [f64; 2] = [1.4, 0.6]; // times the floor's colour: their mean is the plain floor
const SQUARE: f64 = 1.6; // m
pub const MIST: f64 = 0.05; // share of the light that 1 m of mist takes, about

/// C's simplifications by their numbers [C §1.7–1.8].
pub const SIMPLIFIED: [&str; 10] = [
    "one lamp",
    "lamp without size",
    "lamp at the eye",
    "no shadows",
    "no attenuation",
    "no transmission",
    "no textures",
    "no highlights",
    "parallel light",
    "no loss on the way",
];

/// Which of the first nine simplifications are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Made(pub u16);

impl Made {
    /// Everything as it is: the truth.
    pub const NONE: Made = Made(0);
    /// C's model.
    pub const ALL: Made = Made(0x1ff);

    /// The simplification with C's number `k`.
    pub fn has(self, k: usize) -> bool {
        self.0 >> (k - 1) & 1 == 1
    }
    pub fn with(self, k: usize) -> Made {
        Made(self.0 | 1 << (k - 1))
    }
    pub fn without(self, k: usize) -> Made {
        Made(self.0 & !(1 << (k - 1)))
    }
    pub fn count(self) -> usize {
        self.0.count_ones() as usize
    }
}

pub fn other(e: impl Display) -> LessonError {
    LessonError(e.to_string())
}

/// A's scene as its file has it.
pub fn two_spheres() -> Result<Scene> {
    Ok(read(TWO_SPHERES, "two spheres").map_err(|e| LessonError(e.render(Color::Never)))?.scene)
}

/// The scene under those simplifications; a lamp with size is `side²` points.
pub fn scene(made: Made, side: u32) -> Result<Scene> {
    let mut scene = two_spheres()?;
    scene.ambient = AMBIENT;
    for material in &mut scene.materials {
        let is_sphere = material.name != "floor";
        if is_sphere && !made.has(8) {
            material.model = Some(shiny(material.diffuse).map_err(other)?);
        }
        if material.name == "green" && !made.has(6) {
            material.opacity = OPACITY;
        }
    }
    scene.lights = lamps(made, side, scene.camera.position());
    Ok(scene)
}

fn shiny(diffuse: Rgb) -> std::result::Result<Lobes, ParameterError> {
    let (exponent, share) = HIGHLIGHT;
    Lobes::new([(diffuse, Lambert::new(1.0)?.into()), (Rgb::splat(share), Blinn::new(exponent)?.into())])
}

/// The lamps as points or directions, each with its part of the irradiance at the middle.
pub fn lamps(made: Made, side: u32, eye: DVec3) -> Vec<Light> {
    let both = [(LAMPS[0].0, LAMPS[0].1 + LAMPS[1].1)];
    let lamps: &[(DVec3, Rgb)] = if made.has(1) { &both } else { &LAMPS };
    let mut lights = Vec::new();
    for &(place, color) in lamps {
        let center = if made.has(3) { eye } else { place };
        let cells = Cells::grid(if made.has(2) { 1 } else { side }, if made.has(2) { 1 } else { side });
        let share = color * PI / f64::from(cells.len());
        for cell in cells.iter() {
            let p = on_disc(center, uniform_disc(cell.center()));
            let way = MIDDLE - p;
            lights.push(if made.has(9) {
                DirectionalLight::new(way, share).expect("a lamp away from the middle").into()
            } else if made.has(5) {
                PointLight { strength: share, ..PointLight::of_color(p, Rgb::ZERO) }.into()
            } else {
                PointLight::of_intensity(p, share * way.length_squared()).into()
            });
        }
    }
    lights
}

/// A point of the lamp's disc, which faces the middle.
fn on_disc(center: DVec3, u: DVec2) -> DVec3 {
    let (x, y) = lightbench::frame::basis((MIDDLE - center).normalize());
    center + (x * u.x + y * u.y) * RADIUS
}

/// The integrator: C's equation (22), and what the simplifications leave out.
#[derive(Clone, Copy, Debug)]
pub struct Eyesight {
    pub made: Made,
    /// Absorption and airlight [1/m]: 0 in a vacuum, where simplification 10 is exact.
    pub mist: f64,
}

impl Eyesight {
    pub fn new(made: Made) -> Self {
        Eyesight { made, mist: 0.0 }
    }

    /// Radiance of the light that a place sends back along `ray`: C's (22), with `Kₐ = K_d = ρ`.
    fn reflected<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        hit: &Hit,
        material: usize,
        trace: &mut T,
    ) -> Rgb {
        let material = &scene.materials[material];
        let n = if ray.direction.dot(hit.ng) > 0.0 { -hit.n } else { hit.n };
        let origin = hit.origin_towards(n);
        let is_floor = material.model.is_none() && material.name == "floor";
        let texture = if is_floor && !self.made.has(7) { checker(hit.point) } else { 1.0 };
        let local = DMat3::from_cols(hit.tangent, n.cross(hit.tangent), n).transpose();
        let mut sum = material.diffuse * texture * scene.ambient;
        for light in &scene.lights {
            let Some(arrival) = light.arriving(origin) else { continue };
            let cos_theta = n.dot(arrival.wi);
            if !(cos_theta > 0.0) {
                continue;
            }
            let f = match &material.model {
                None => material.diffuse * texture * FRAC_1_PI,
                Some(lobes) => lobes.eval(local * arrival.wi, local * -ray.direction),
            };
            let brought = f * arrival.irradiance * cos_theta;
            sum += if self.made.has(4) {
                brought
            } else {
                brought * self.passing(scene, Ray::new(origin, arrival.to), arrival.t_max, trace)
            };
        }
        sum
    }

    /// Share of a lamp's light that passes everything on its way.
    fn passing<T: Trace>(&self, scene: &Scene, segment: Ray, t_max: f64, trace: &mut T) -> f64 {
        trace.count(Work::Ray(RayKind::Shadow), 1);
        if self.made.has(6) {
            return if scene.blocker(&segment, t_max, trace).is_some() { 0.0 } else { 1.0 };
        }
        let (mut ray, mut left, mut share) = (segment, t_max, 1.0);
        while let Some((i, crossing)) = scene.nearest(&ray, left, trace) {
            let hit = scene.hit(&ray, i, &crossing);
            share *= 1.0 - scene.materials[scene.objects[i].material(hit.part)].opacity;
            if share == 0.0 {
                break;
            }
            left -= crossing.t;
            ray = Ray::new(hit.origin_towards(ray.direction), ray.direction);
        }
        share
    }
}

/// Squares, one sample each: lesson 21 does textures properly.
fn checker(p: DVec3) -> f64 {
    CHECKER[((p.x / SQUARE).floor() + (p.z / SQUARE).floor()).rem_euclid(2.0) as usize]
}

impl Integrator for Eyesight {
    type Scratch = ();
    fn scratch(&self, _: &Scene) {}

    fn radiance<T: Trace>(
        &self,
        scene: &Scene,
        ray: &Ray,
        _: &mut Sampler,
        _: &mut (),
        trace: &mut T,
    ) -> Rgb {
        trace.count(Work::Ray(RayKind::Camera), 1);
        let (mut ray, mut weight, mut sum) = (*ray, 1.0, Rgb::ZERO);
        let (eye, mut way) = (ray.origin, f64::INFINITY);
        while weight > 0.0 {
            let Some((i, crossing)) = scene.nearest(&ray, f64::INFINITY, trace) else {
                sum += weight * scene.background;
                break;
            };
            let hit = scene.hit(&ray, i, &crossing);
            way = way.min(eye.distance(hit.point));
            let material = scene.objects[i].material(hit.part);
            let opacity = if self.made.has(6) { 1.0 } else { scene.materials[material].opacity };
            sum += weight * opacity * self.reflected(scene, &ray, &hit, material, trace);
            weight *= 1.0 - opacity;
            if weight > 0.0 {
                trace.count(Work::Ray(RayKind::Refracted), 1);
                ray = Ray::new(hit.origin_towards(ray.direction), ray.direction);
            }
        }
        if self.mist == 0.0 {
            return sum;
        }
        let kept = (-self.mist * way).exp();
        sum * kept + scene.background * (1.0 - kept)
    }
}
