//! What each way does to a picture.

use super::contest::Rule;
use super::plain::Plain;
use glam::{DAffine3, DMat3, DQuat, DVec3, dvec2, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::measure::quantised;
use lightbench::ray::Silent;
use lightbench::ray::leaving::Leaving;
use lightbench::render::{Picture, render};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench_kit::figure::heading::percent;
use lightbench_kit::figure::{Figure, Panels};
use lightbench_kit::lesson::{LessonError, Result};
use std::fmt::Display;

fn other(e: impl Display) -> LessonError {
    LessonError(e.to_string())
}

/// A scene with its lamp.
struct Stage {
    scene: Scene,
    lamp: DVec3,
    check: f64,
}

impl Stage {
    fn new(eye: DVec3, target: DVec3, degrees: f64, lamp: DVec3, check: f64) -> Result<Self> {
        let view = FieldOfView::Vertical(degrees.to_radians());
        let mut scene = Scene::new(Camera::new(eye, target, DVec3::Y, view).map_err(other)?);
        scene.background = Rgb::new(0.52, 0.66, 0.82);
        Ok(Stage { scene, lamp, check })
    }

    fn with(mut self, shape: impl Shape + 'static, name: &str, diffuse: [f64; 3], ior: f64) -> Self {
        let [r, g, b] = diffuse;
        let material = Material { name: name.into(), diffuse: Rgb::new(r, g, b), ior, ..Material::default() };
        self.scene.materials.push(material);
        let index = self.scene.materials.len() - 1;
        self.scene.objects.push(Object::new(name, Box::new(shape), index));
        self
    }

    /// With the lamp at full `power`, or off.
    fn shot(&self, rule: Rule, picture: Picture, power: f64) -> Image {
        render(&self.scene, &Plain { rule, lamp: self.lamp, power, check: self.check }, picture).image
    }

    /// Share of the pixels on objects that are not as the default's; of those that it lights, how many are not.
    fn wrong(&self, image: &Image, right: &Image, picture: Picture) -> (f64, f64) {
        let dark = self.shot(Rule::Leave(Leaving::ErrorBound), picture, 0.0);
        let (mut seen, mut lit) = ((0, 0), (0, 0));
        let pixels = image.pixels().iter().zip(right.pixels()).zip(dark.pixels());
        for (k, ((pixel, right), dark)) in pixels.enumerate() {
            let at = dvec2((k % picture.width) as f64, (k / picture.width) as f64) + 0.5;
            let ray = self.scene.camera.ray(at, picture.width, picture.height);
            let visible = |a: &Rgb, b: &Rgb| u32::from((*a - *b).abs().max_element() > quantised() / 255.0);
            let on_object = u32::from(self.scene.nearest(&ray, f64::INFINITY, &mut Silent).is_some());
            let (is_lit, is_wrong) = (on_object * visible(right, dark), on_object * visible(pixel, right));
            seen = (seen.0 + is_wrong, seen.1 + on_object);
            lit = (lit.0 + is_wrong * is_lit, lit.1 + is_lit);
        }
        let share = |(wrong, of): (u32, u32)| f64::from(wrong) / f64::from(of.max(1));
        (share(seen), share(lit))
    }

    /// A picture for each rule, the default last; and the share of lit pixels that each gets wrong.
    fn panels(&self, rules: &[(&str, Rule)], picture: Picture) -> (Panels, Vec<f64>) {
        let right = self.shot(Rule::Leave(Leaving::ErrorBound), picture, 1.0);
        let (mut panels, mut wrong) = (Panels::new(), Vec::new());
        for (label, rule) in rules {
            let image = self.shot(*rule, picture, 1.0);
            let (share, of_lit) = self.wrong(&image, &right, picture);
            panels = panels.picture((&image).into(), &format!("{label}: {} of pixels wrong", percent(share)));
            wrong.push(of_lit);
        }
        (panels.picture((&right).into(), "error bound (default)"), wrong)
    }
}

const GREY: [f64; 3] = [0.72, 0.72, 0.70];
const RED: [f64; 3] = [0.78, 0.24, 0.16];
const BLUE: [f64; 3] = [0.22, 0.42, 0.74];
const YELLOW: [f64; 3] = [0.88, 0.68, 0.22];
const NO_REMEDY: Rule = Rule::Leave(Leaving::OnTheSpot);

fn floor(normal: DVec3) -> Result<Plane> {
    Plane::new(DVec3::ZERO, normal).map_err(other)
}

/// [B 7.21].
pub fn acne(picture: Picture) -> Result<(Figure, f64)> {
    let turned = DAffine3::from_rotation_translation(DQuat::from_rotation_x(-0.95), dvec3(0.15, 0.62, 1.25));
    let torus = Torus::new(0.62, 0.2).map_err(other)?;
    let stage = Stage::new(dvec3(0.2, 2.3, 6.4), dvec3(0.0, 0.75, 0.0), 34.0, dvec3(-4.0, 6.0, 5.0), 1.0)?
        .with(floor(dvec3(0.03, 1.0, 0.02))?, "floor", GREY, 1.0)
        .with(Sphere::new(dvec3(-1.25, 1.03, -0.2), 1.0).map_err(other)?, "sphere", RED, 1.0)
        .with(
            Cone::new(dvec3(1.35, 0.0, -0.5), dvec3(1.35, 1.9, -0.5), 0.8, 0.0).map_err(other)?,
            "cone",
            BLUE,
            1.0,
        )
        .with(Instance::new(Box::new(torus), turned).map_err(other)?, "torus", YELLOW, 1.0);
    let (panels, wrong) = stage.panels(&[("no remedy", NO_REMEDY)], picture);
    let panels = panels
        .title(&format!("Without a remedy {} of what is lit turns black", percent(wrong[0])))
        .subtitle("shadow rays start in the computed points, in double precision; after B, figure 7.21")
        .alt("A sphere, a cone and a ring on a floor, twice. Left all lit surfaces are covered with black dots; right they are clean.");
    let caption = "Self-intersection (B, figure 7.21). The computed point lies a little under the true surface about every other \
        time, and the shadow ray from there meets the surface at once: black dots, called acne. 64-bit numbers do not cure it: half of \
        the points are on the wrong side however small the error is.";
    Ok((Figure::from(panels).caption(caption), wrong[0]))
}

/// [B 7.23].
pub fn detached(picture: Picture) -> Result<Figure> {
    let stage = Stage::new(
        dvec3(0.012, 0.085, 0.2),
        dvec3(0.004, 0.014, 0.002),
        19.0,
        dvec3(-0.25, 0.16, 0.06),
        0.02,
    )?
    .with(floor(DVec3::Y)?, "floor", GREY, 1.0)
    .with(Sphere::new(dvec3(-0.035, 0.02, 0.0), 0.02).map_err(other)?, "ball", RED, 1.0)
    .with(
        Cylinder::new(dvec3(0.025, 0.0, 0.02), dvec3(0.025, 0.004, 0.02), 0.017).map_err(other)?,
        "coin",
        YELLOW,
        1.0,
    )
    .with(
        Cuboid::new(dvec3(0.03, 0.0, -0.04), dvec3(0.05, 0.034, -0.02)).map_err(other)?,
        "box",
        BLUE,
        1.0,
    );
    let rules = [
        ("0.01 m along the normal", Rule::Leave(Leaving::AlongNormal(0.01))),
        ("A: 0.01 m ahead", Rule::Leave(Leaving::Ahead(0.01))),
        ("B: 10⁻⁴ m along n", Rule::Leave(Leaving::AlongNormal(1.0e-4))),
    ];
    let (panels, _) = stage.panels(&rules, picture);
    let panels = panels
        .columns(2)
        .title("A bias made for rooms moves the shadows of a coin, or loses them")
        .subtitle("a ball of 4 cm, a coin 4 mm thick and a box, one lamp; after B, figure 7.23")
        .alt("A ball, a coin and a box on a floor, four times. With a bias of a centimetre the coin has no shadow and the \
              ball's shadow is detached from it; with a tenth of a millimetre and with the error bound all shadows touch their things.");
    let caption = "Too large a bias (B, figure 7.23). Shadow rays of the floor start a centimetre above it: over the coin, which then throws no \
        shadow, and within the reach of the light that passes under the ball. The shadows no longer touch the things that throw them. \
        The edges of light on the ball itself are wrong as well: raised points see over its horizon.";
    Ok(Figure::from(panels).caption(caption))
}

/// [B 7.33], and the two rules that lose a transmitted ray.
pub fn glass(picture: Picture) -> Result<Figure> {
    let stage = Stage::new(dvec3(0.0, 1.7, 5.2), dvec3(0.0, 0.85, 0.0), 32.0, dvec3(-4.0, 6.0, 4.0), 0.5)?
        .with(floor(DVec3::Y)?, "checks", GREY, 1.0)
        .with(Sphere::new(dvec3(0.0, 1.001, 0.0), 1.0).map_err(other)?, "glass", [0.0; 3], 1.5)
        .with(Sphere::new(dvec3(-1.7, 0.5, -1.6), 0.5).map_err(other)?, "red", RED, 1.0)
        .with(Sphere::new(dvec3(1.6, 0.6, -1.2), 0.6).map_err(other)?, "blue", BLUE, 1.0);
    let rules = [
        ("no remedy", NO_REMEDY),
        ("D: 10⁻⁴ m back", Rule::Leave(Leaving::Back(1.0e-4))),
        ("A: object skipped", Rule::NaiveSkip),
    ];
    let (panels, _) = stage.panels(&rules, picture);
    let panels = panels
        .columns(2)
        .title("D's correction never gets into the glass, A's never comes out")
        .subtitle("a ball of glass, index 1.5; only refraction is traced; after B, figure 7.33")
        .alt("A ball of glass on a checked floor before two coloured balls, four times. Without a remedy it is full of wrong dots; with D's rule \
              it is black; with A's it hardly bends what is behind it; with the error bound it shows the scene upside down.");
    let caption = "Self-intersection of refracted rays (B, figure 7.33). Without a remedy part of the rays meet the surface again that they have just \
        passed. D shifts each point back along the ray: what was bent into the glass starts outside, and enters again and again until it \
        is given up. A skips the object that the ray left: the far side of the ball is never met. The default starts on the side to which \
        the ray goes.";
    Ok(Figure::from(panels).caption(caption))
}

/// A thing that stands in its own light.
pub fn skipped(picture: Picture) -> Result<Figure> {
    // The lamp stands in the plane of the ring, so that the near arc hides it from the far one.
    let leaning = DMat3::from_rotation_z(-0.38) * DMat3::from_rotation_x(-1.05);
    let leaning = DAffine3::from_mat3_translation(leaning, dvec3(0.0, 1.1, 0.0));
    let torus = Torus::new(1.15, 0.42).map_err(other)?;
    let stage = Stage::new(dvec3(0.6, 3.9, 6.4), dvec3(0.3, 0.75, 0.0), 33.0, dvec3(-6.0, 3.8, 0.0), 1.0)?
        .with(floor(DVec3::Y)?, "floor", GREY, 1.0)
        .with(Instance::new(Box::new(torus), leaning).map_err(other)?, "ring", YELLOW, 1.0)
        .with(Sphere::new(dvec3(-1.9, 0.35, 1.0), 0.35).map_err(other)?, "ball", BLUE, 1.0);
    let (panels, _) = stage.panels(&[("A: object skipped", Rule::NaiveSkip)], picture);
    let panels = panels
        .title("A ring throws a shadow on itself; who skips the object loses it")
        .subtitle("a ring and a ball, one lamp on the left; after the rule of A §5.4.7")
        .alt("A ring and a ball on a floor, twice. Left the far inner side of the ring is lit although the near side stands before the lamp; right it lies in shadow.");
    let caption = "A §5.4.7 leaves out the object that a ray starts from, because it could not be met again. A convex body cannot; a ring, any \
        solid with a hole or a dent, and any mesh that is one object can. The near arc of the ring should shade the far one.";
    Ok(Figure::from(panels).caption(caption))
}

/// The ground as a sphere as large as a planet, seen near the world's origin.
pub fn planet(picture: Picture) -> Result<Figure> {
    const RADIUS: f64 = 6.4e6; // m
    let stage = Stage::new(dvec3(0.0, 1.5, 5.0), dvec3(0.0, 0.6, 0.0), 32.0, dvec3(-4.0, 5.0, 3.0), 1.0)?
        .with(Sphere::new(dvec3(0.0, -RADIUS, 0.0), RADIUS).map_err(other)?, "ground", GREY, 1.0)
        .with(Sphere::new(dvec3(-0.7, 0.6, 0.0), 0.6).map_err(other)?, "ball", RED, 1.0)
        .with(Sphere::new(dvec3(0.9, 0.35, 0.5), 0.35).map_err(other)?, "ball", BLUE, 1.0);
    let rules = [("256 last places", Rule::Leave(Leaving::Integer))];
    let (panels, _) = stage.panels(&rules, picture);
    let panels = panels
        .title("A planet for a floor: the point's own digits do not know its error")
        .subtitle("the ground is a sphere of 6400 km; the scene stands at the world's origin")
        .alt(
            "Two balls on a grey ground, twice. Left the ground is sprinkled with black; right it is clean.",
        );
    let caption = "The integer offset moves each coordinate by 256 of its own last places, 10⁻¹⁴ m near the world's origin. The ground's centre lies \
        6400 km below, and its points are known to 10⁻⁹ m. The error bound belongs to the shape, which knows its numbers.";
    Ok(Figure::from(panels).caption(caption))
}
