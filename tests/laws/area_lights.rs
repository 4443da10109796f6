//! Lights with a surface, and reflection models, as local illumination sums them up.

use crate::support::mean_matches;
use glam::{DVec2, DVec3, dvec2, dvec3};
use lightbench::bsdf::{Lafortune, Lobes, Phong};
use lightbench::color::Rgb;
use lightbench::integrator::Local;
use lightbench::light::{
    AreaLight, Attenuation, Emission, Emitter, Light, Measure, PointLight, Rectangle, polygon_irradiance,
    sphere_irradiance,
};
use lightbench::num::gamma;
use lightbench::ray::{Ray, Silent};
use lightbench::render::{Picture, render};
use lightbench::sample::{Cells, Pattern, bits, point2};
use lightbench::scene::{Camera, FieldOfView, Material, Met, Object, Scene};
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::triangle::Triangle;
use std::f64::consts::{FRAC_1_PI, PI};

const EYE: DVec3 = dvec3(2.0, 4.0, -9.0);
const ALBEDO: Rgb = dvec3(0.5, 0.25, 0.75);
/// Estimates of one mean. A ray to a sphere's area is wasted with probability ½; sums of 16 have a skewness under ¼, and
/// (40 · ¼)² = 100 would do.
const RUNS: usize = 1600;

/// A floor seen along one line, which the pixels of a row share but for 10⁻⁹ rad.
fn floor(material: Material, light: Light) -> Scene {
    let camera = Camera::new(EYE, DVec3::ZERO, DVec3::Y, FieldOfView::Horizontal(1.0e-9)).expect("a camera");
    let mut scene = Scene::new(camera);
    scene.materials.push(material);
    let plane = Plane::new(DVec3::ZERO, DVec3::Y).expect("a plane");
    scene.objects.push(Object::new("floor", Box::new(plane), 0));
    scene.lights.push(light);
    scene
}

fn matt() -> Material {
    Material { diffuse: ALBEDO, ..Material::default() }
}

fn emitters() -> [(&'static str, Emitter); 3] {
    let rectangle = Rectangle::facing(dvec3(-1.0, 2.0, 0.5), dvec3(0.4, -1.0, -0.1), 0.3, dvec2(1.5, 0.8));
    let triangle = Triangle::new(dvec3(1.0, 1.5, 0.2), dvec3(0.2, 2.5, 1.4), dvec3(-0.8, 1.1, 0.9));
    [
        ("rectangle", rectangle.expect("a rectangle").into()),
        ("triangle", triangle.expect("a triangle").into()),
        ("sphere", Sphere::new(dvec3(0.7, 1.9, -0.6), 0.8).expect("a sphere").into()),
    ]
}

/// The light's front is turned to the origin.
fn facing_origin(emitter: Emitter) -> Emitter {
    match emitter {
        Emitter::Triangle(t) if !emitter.faces(DVec3::ZERO) => {
            let [a, b, c] = t.corners();
            Triangle::new(a, c, b).expect("a triangle").into()
        }
        _ => emitter,
    }
}

fn closed_form(emitter: &Emitter) -> f64 {
    match emitter {
        Emitter::Rectangle(r) => polygon_irradiance(&r.corners(), DVec3::ZERO, DVec3::Y),
        Emitter::Triangle(t) => polygon_irradiance(&t.corners(), DVec3::ZERO, DVec3::Y),
        Emitter::Sphere(s) => sphere_irradiance(s.center(), s.radius(), DVec3::ZERO, DVec3::Y),
    }
}

#[test]
fn every_pattern_and_measure_has_the_closed_form_for_its_mean() {
    for (name, emitter) in emitters() {
        let emitter = facing_origin(emitter);
        let truth = ALBEDO * (closed_form(&emitter) * 3.0 * FRAC_1_PI);
        for pattern in Pattern::ALL.into_iter().filter(|p| p.is_unbiased()) {
            for measure in [Measure::Area, Measure::SolidAngle] {
                let light = AreaLight::new(emitter, Emission::diffuse(Rgb::splat(3.0)));
                let scene = floor(matt(), light.sampled(16, pattern).by(measure).into());
                let picture = Picture { width: RUNS, height: 1, samples: 1, seed: 5 };
                let image = render(&scene, &Local::default(), picture).image;
                let label = format!("{name}, {}, {measure:?}", pattern.name());
                mean_matches(&label, truth.x, image.pixels().iter().map(|p| p.x));
                let tinted = image.pixels()[0] / truth;
                assert!((tinted - tinted.x).abs().max_element() <= gamma(8) * tinted.x, "{label}: {tinted}");
            }
        }
    }
}

/// The part of a convex polygon where `m·v ≤ 0`.
fn cut(corners: &[DVec3], m: DVec3) -> Vec<DVec3> {
    let mut kept = Vec::new();
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let (da, db) = (m.dot(*a), m.dot(*b));
        if da <= 0.0 {
            kept.push(*a);
        }
        if da * db < 0.0 {
            kept.push(*a + (*b - *a) * (da / (da - db)));
        }
    }
    kept
}

/// A straight edge hides a part of a flat light; what it leaves is a polygon, which has a closed form.
#[test]
fn behind_an_edge_the_mean_is_that_of_the_polygon_that_is_left() {
    const HEIGHT: f64 = 0.5;
    let (across, along) = (dvec3(-0.95, 0.0, 0.3).normalize(), dvec3(0.3, 0.0, 0.95).normalize());
    for (name, emitter) in emitters() {
        let emitter = facing_origin(emitter);
        let corners = match &emitter {
            Emitter::Rectangle(r) => r.corners().to_vec(),
            Emitter::Triangle(t) => t.corners().to_vec(),
            Emitter::Sphere(_) => continue,
        };
        // The edge passes before the middle; blocked is what lies beyond it, away from the camera.
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let edge = across * (middle * (HEIGHT / middle.y)).dot(across);
        let left = cut(&corners, across - DVec3::Y * (edge.dot(across) / HEIGHT));
        let truth = ALBEDO.x * polygon_irradiance(&left, DVec3::ZERO, DVec3::Y) * 3.0 * FRAC_1_PI;
        let whole = ALBEDO.x * closed_form(&emitter) * 3.0 * FRAC_1_PI;
        assert!((0.2..0.8).contains(&(truth / whole)), "{name}: {truth} of {whole}");
        let at = edge + DVec3::Y * HEIGHT;
        for pattern in Pattern::ALL.into_iter().filter(|p| p.is_unbiased()) {
            for measure in [Measure::Area, Measure::SolidAngle] {
                let light = AreaLight::new(emitter, Emission::diffuse(Rgb::splat(3.0)));
                let mut scene = floor(matt(), light.sampled(16, pattern).by(measure).into());
                let sheet = Triangle::new(at - along * 50.0, at + along * 50.0, at + across * 50.0);
                scene.objects.push(Object::new("sheet", Box::new(sheet.expect("a triangle")), 0));
                let picture = Picture { width: RUNS, height: 1, samples: 1, seed: 6 };
                let image = render(&scene, &Local::default(), picture).image;
                let label = format!("{name}, {}, {measure:?}", pattern.name());
                mean_matches(&label, truth, image.pixels().iter().map(|p| p.x));
            }
        }
    }
}

/// Half shadows of edges along the sides of a square light of `n × n` cells, at a random place: a fixed grid is off by a
/// uniform share of a column, `1/12n²`. Of jittered points the `n` cells of one column err by chance, each by
/// `f (1 − f)` with a uniform `f`: `n/6N² = 1/6n³`.
#[test]
fn edges_along_the_cells_leave_a_grid_steps_and_jittered_points_chance() {
    for n in [2u32, 5, 10] {
        for (pattern, variance) in [
            (Pattern::Centres, 1.0 / (12.0 * f64::from(n * n))),
            (Pattern::Jittered, 1.0 / (6.0 * f64::from(n * n * n))),
        ] {
            // Squares of errors that n cells make have a kurtosis below 10; (40 · √10)² = 16 000.
            let squares = (0..16_000u32).map(|run| {
                let edge = point2(11, run, 0).x;
                let seen =
                    pattern.points(n * n, bits(12, run.into(), 0, 0)).iter().filter(|u| u.x < edge).count();
                (seen as f64 / f64::from(n * n) - edge).powi(2)
            });
            mean_matches(&format!("{} of {n} × {n}", pattern.name()), variance, squares);
        }
    }
}

/// Behind its back a diffuse light sends nothing, whatever is asked of it.
#[test]
fn the_back_of_a_diffuse_light_is_dark() {
    for (name, emitter) in emitters() {
        let turned: Emitter = match facing_origin(emitter) {
            Emitter::Rectangle(r) => {
                let size = 2.0 * dvec2(r.half_width().length(), r.half_height().length());
                Rectangle::facing(r.center(), -r.normal(), 0.0, size).expect("a rectangle").into()
            }
            Emitter::Triangle(t) => {
                let [a, b, c] = t.corners();
                Triangle::new(a, c, b).expect("a triangle").into()
            }
            Emitter::Sphere(_) => {
                Sphere::new(DVec3::Y * 0.5, 30.0).expect("a sphere around everything").into()
            }
        };
        for measure in [Measure::Area, Measure::SolidAngle] {
            let light = AreaLight::new(turned, Emission::diffuse(Rgb::ONE));
            let scene = floor(matt(), light.sampled(9, Pattern::Jittered).by(measure).into());
            let picture = Picture { width: 40, height: 1, samples: 1, seed: 1 };
            let dark = render(&scene, &Local::default(), picture).image;
            assert!(dark.pixels().iter().all(|p| *p == Rgb::ZERO), "{name}, {measure:?}");
        }
    }
}

/// The documents' lights are means over their points, by the plain formula; the order of the sum makes the difference.
#[test]
fn an_even_light_is_the_mean_of_its_points() {
    let law = Attenuation::polynomial([0.2, 0.1, 0.3]).expect("a law").capped(0.9);
    for (name, emitter) in emitters() {
        for attenuation in [Attenuation::None, law] {
            let cells = Cells::equal_areas(50);
            let light = AreaLight::new(emitter, Emission::Even { color: Rgb::splat(2.0), attenuation });
            let scene = floor(matt(), light.sampled(50, Pattern::Centres).into());
            let picture = Picture { width: 1, height: 1, samples: 1, seed: 0 };
            let shown = render(&scene, &Local::default(), picture).image.get(0, 0).x;
            let one = |p: DVec3| p.y / p.length() * attenuation.factor(p.length());
            let mean: f64 = cells.iter().map(|c| one(emitter.point(c.center()))).sum::<f64>() / 50.0;
            // The place is off the origin by the rounding of a hit 10 m away, some 10 u, so the ways of 1 m change by as much.
            let truth = ALBEDO.x * 2.0 * mean;
            assert!((shown - truth).abs() <= gamma(200) * truth, "{name}: {shown} {truth}");
        }
    }
}

fn shiny() -> Lobes {
    let pulled = Lafortune::new(dvec3(-0.9, -0.4, 0.7), 6.0, 1.0).expect("a lobe");
    let parts =
        [(Rgb::new(0.2, 0.5, 0.3), Phong::new(20.0).expect("a lobe").into()), (ALBEDO, pulled.into())];
    Lobes::new(parts).expect("lobes")
}

/// What the floor shows of light from `wi` that brings `e` to a facing surface: `f e cos θ`, in the plane's own frame.
fn formula(lobes: &Lobes, scene: &Scene, wi: DVec3, e: f64) -> Rgb {
    let ray = Ray::new(EYE, -EYE.normalize());
    let Some(Met::Object(i, crossing)) = scene.first_met(&ray, &mut Silent) else { panic!("a floor") };
    let hit = scene.hit(&ray, i, &crossing);
    let (x, z) = (hit.tangent, hit.ng);
    let local = |v: DVec3| dvec3(v.dot(x), v.dot(z.cross(x)), v.dot(z));
    lobes.eval(local(wi), local(EYE.normalize())) * (e * wi.y)
}

/// Phong's lobe of exponent 20 turns rounding of the directions, some 20 u, into 20 times as much.
#[test]
fn a_model_shows_f_times_irradiance_times_cosine() {
    let material = Material { model: Some(shiny()), ..matt() };
    let picture = Picture { width: 1, height: 1, samples: 1, seed: 0 };
    let at = dvec3(-5.0, 8.0, 3.0);
    let scene = floor(material.clone(), PointLight::of_intensity(at, Rgb::splat(7.0)).into());
    let shown = render(&scene, &Local::default(), picture).image.get(0, 0);
    let truth = formula(&shiny(), &scene, at.normalize(), 7.0 / at.length_squared());
    assert!((shown - truth).abs().max_element() <= gamma(1000) * truth.max_element(), "{shown} {truth}");

    let (_, emitter) = emitters()[0];
    let light = AreaLight::new(emitter, Emission::diffuse(Rgb::splat(7.0)));
    let scene = floor(material, light.subdivided(5, 3, Pattern::Centres).into());
    let shown = render(&scene, &Local::default(), picture).image.get(0, 0);
    let normal = emitter.flat_normal().expect("a normal");
    let share = 7.0 * emitter.area() / 15.0;
    let of = |p: DVec3| {
        let wi = p.normalize();
        formula(&shiny(), &scene, wi, share * -normal.dot(wi) / p.length_squared())
    };
    let truth: Rgb = Cells::grid(5, 3).iter().map(|c| of(emitter.point(c.center()))).sum();
    assert!((shown - truth).abs().max_element() <= gamma(1000) * truth.max_element(), "{shown} {truth}");
}

/// A picture does not depend on the unit of length, though `d⁴` has a range: areas of 10⁻³⁰⁰ m² too.
#[test]
fn area_sampling_depends_on_no_scale() {
    let picture = Picture { width: 1, height: 1, samples: 1, seed: 0 };
    for (name, emitter) in [
        (
            "triangle",
            Emitter::Triangle(
                Triangle::new(dvec3(-1.0, 2.0, -1.0), dvec3(1.0, 2.0, -1.0), dvec3(0.0, 2.0, 1.0))
                    .expect("a triangle"),
            ),
        ),
        (
            "rectangle",
            Rectangle::facing(DVec3::Y * 2.0, DVec3::NEG_Y, 0.0, DVec2::ONE).expect("a rectangle").into(),
        ),
        ("sphere", Sphere::new(DVec3::Y * 2.0, 0.5).expect("a sphere").into()),
    ] {
        let shown = |scale: f64| {
            let emitter: Emitter = match emitter {
                Emitter::Triangle(t) => {
                    let [a, b, c] = t.corners().map(|p| p * scale);
                    Triangle::new(a, b, c).expect("a triangle").into()
                }
                Emitter::Rectangle(_) => {
                    Rectangle::facing(DVec3::Y * 2.0 * scale, DVec3::NEG_Y, 0.0, DVec2::splat(scale))
                        .expect("a rectangle")
                        .into()
                }
                Emitter::Sphere(_) => {
                    Sphere::new(DVec3::Y * 2.0 * scale, 0.5 * scale).expect("a sphere").into()
                }
            };
            let light = AreaLight::new(emitter, Emission::diffuse(Rgb::ONE)).sampled(64, Pattern::Centres);
            let mut scene = floor(matt(), light.into());
            scene.camera =
                Camera::new(dvec3(0.0, scale, 0.0), DVec3::ZERO, DVec3::Z, FieldOfView::Vertical(1e-5))
                    .expect("a camera");
            render(&scene, &Local::default(), picture).image.get(0, 0).x
        };
        let one = shown(1.0);
        assert!(one > 0.01, "{name} {one}");
        for scale in [1e-150, 1e-100, 1e-80, 1e80, 1e100, 1e150] {
            let found = shown(scale);
            assert!((found - one).abs() <= gamma(1000) * one, "{name} {scale:e}: {found} for {one}");
        }
    }
}

/// A viewer sees the documents' lights from both sides, diffuse ones from the front, nothing from inside a sphere.
#[test]
fn lights_are_seen_from_their_front() {
    let rectangle = Rectangle::facing(DVec3::Y * 4.0, DVec3::NEG_Y, 0.0, DVec2::ONE).expect("a rectangle");
    let below = Ray::new(dvec3(0.1, 1.0, 0.2), DVec3::Y);
    let above = Ray::new(dvec3(0.1, 7.0, 0.2), DVec3::NEG_Y);
    let aside = Ray::new(dvec3(0.6, 1.0, 0.2), DVec3::Y);
    let seen = |emission, ray: &Ray| AreaLight::new(rectangle, emission).met(ray);
    assert_eq!(seen(Emission::even(Rgb::ONE), &below), Some((3.0, Rgb::ONE)));
    assert_eq!(seen(Emission::even(Rgb::ONE), &above), Some((3.0, Rgb::ONE)));
    assert_eq!(seen(Emission::diffuse(Rgb::ONE), &below), Some((3.0, Rgb::ONE)));
    assert_eq!(seen(Emission::diffuse(Rgb::ONE), &above), None);
    assert_eq!(seen(Emission::even(Rgb::ONE), &aside), None);
    let ball = |emission| AreaLight::new(Sphere::new(DVec3::Y * 4.0, 1.0).expect("a sphere"), emission);
    let inside = Ray::new(DVec3::Y * 4.5, DVec3::Y);
    assert!(ball(Emission::diffuse(Rgb::ONE)).met(&above).is_some());
    assert_eq!(ball(Emission::diffuse(Rgb::ONE)).met(&inside), None);
    assert_eq!(ball(Emission::even(Rgb::ONE)).met(&inside), Some((0.5, Rgb::ONE)));
}

/// Of two lights and an object in a row the nearest is met; a light behind a wall is not.
#[test]
fn the_nearest_of_lights_and_objects_is_met() {
    let lamp = |y: f64, radiance: f64| {
        let rectangle = Rectangle::facing(DVec3::Y * y, DVec3::Y, 0.0, DVec2::ONE).expect("a rectangle");
        Light::from(AreaLight::new(rectangle, Emission::even(Rgb::splat(radiance))))
    };
    let mut scene = floor(matt(), lamp(1.0, 0.5));
    scene.lights.extend([lamp(3.0, 0.25), lamp(-1.0, 0.125)]);
    let down = Ray::new(DVec3::Y * 5.0, DVec3::NEG_Y);
    assert_eq!(scene.first_met(&down, &mut Silent), Some(Met::Light(1, Rgb::splat(0.25))));
    let below_both = Ray::new(DVec3::Y * 0.5, DVec3::NEG_Y);
    assert!(matches!(scene.first_met(&below_both, &mut Silent), Some(Met::Object(0, _))));
}

/// A point light of intensity I and a sphere of the same flux, far away, light alike: `π L r² · 4π = 4π I`.
#[test]
fn a_small_sphere_is_a_point() {
    let at = dvec3(30.0, 80.0, -20.0);
    let radius = 1.0e-3;
    let sphere = Sphere::new(at, radius).expect("a sphere");
    let light = AreaLight::new(sphere, Emission::diffuse(Rgb::splat(5.0)));
    let picture = Picture { width: 1, height: 1, samples: 1, seed: 0 };
    let scene = floor(matt(), light.sampled(64, Pattern::Sobol).by(Measure::SolidAngle).into());
    let shown = render(&scene, &Local::default(), picture).image.get(0, 0).x;
    let intensity = 5.0 * PI * radius * radius;
    let scene = floor(matt(), PointLight::of_intensity(at, Rgb::splat(intensity)).into());
    let point = render(&scene, &Local::default(), picture).image.get(0, 0).x;
    // Directions to the sphere's points deviate by r/d = 1.1e-5 at most, hence cosines; distances do not count.
    assert!((shown - point).abs() <= 1.2e-5 * point, "{shown} {point}");
}
