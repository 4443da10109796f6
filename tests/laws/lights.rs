//! Lights without size: what arrives from them, near, far, and at the edges of their cones; and shadows that do not
//! depend on what is remembered.

use glam::{DVec3, dvec3};
use lightbench::color::Rgb;
use lightbench::film::Image;
use lightbench::integrator::{Local, Memory};
use lightbench::light::as_printed::{attenuation_as_printed, hides_as_printed, light_ray_as_printed};
use lightbench::light::{Attenuation, DirectionalLight, Light, LightError, PointLight, SpotLight};
use lightbench::measure::agrees;
use lightbench::num::quadrature::integrate;
use lightbench::num::{U, gamma};
use lightbench::ray::{RayKind, Tally};
use lightbench::render::{Control, Picture, render, render_with};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

fn law(a: f64, b: f64, c: f64) -> Attenuation {
    Attenuation::polynomial([a, b, c]).expect("a law")
}

#[test]
fn attenuation_has_its_edge_values() {
    let (zero, far) = (0.0, f64::INFINITY);
    for (law, near, there, beyond) in [
        (Attenuation::None, 1.0, 1.0, 1.0),
        (Attenuation::None.capped(0.5), 1.0, 1.0, 1.0),
        (Attenuation::InverseSquare, far, 1.0, 0.0),
        (Attenuation::InverseSquare.capped(3.0), 3.0, 1.0, 0.0),
        (law(0.0, 1.0, 0.0), far, 1.0, 0.0),
        (law(2.0, 0.0, 0.0), 0.5, 0.5, 0.5),
        (law(1.0, 2.0, 1.0), 1.0, 0.25, 0.0),
        (law(1.0, 2.0, 1.0).capped(0.125), 0.125, 0.125, 0.0),
        (law(5e-324, 0.0, 0.0), far, far, far),
        (law(f64::MAX, f64::MAX, f64::MAX), 1.0 / f64::MAX, 0.0, 0.0),
    ] {
        assert_eq!([zero, 1.0, far].map(|d| law.factor(d)), [near, there, beyond], "{law:?}");
        assert!(law.factor(f64::NAN).is_nan() || law.factor(f64::NAN) == law.factor(1.0), "{law:?}");
    }
    for bad in [[0.0; 3], [-0.0; 3]] {
        assert_eq!(Attenuation::polynomial(bad), Err(LightError::NoAttenuation));
    }
    for bad in [[-1.0, 2.0, 3.0], [1.0, f64::NAN, 0.0], [0.0, 0.0, f64::INFINITY]] {
        assert!(matches!(Attenuation::polynomial(bad), Err(LightError::Negative { .. })), "{bad:?}");
    }
}

/// The printed code is the law with a cap of 1, so that it is the inverse square from 1 on, and too dark before.
#[test]
fn the_printed_attenuation_is_capped_at_one() {
    for d in [0.0, 1e-9, 0.1, 0.5, 0.999, 1.0, 1.5, 8.0, 1e9] {
        let printed = attenuation_as_printed([0.0, 0.0, 1.0], d);
        // Two products, two sums and a quotient, once by Horner's form.
        assert!(agrees(printed, law(0.0, 0.0, 1.0).capped(1.0).factor(d), gamma(10) * printed), "{d}");
        if d >= 1.0 {
            assert!(agrees(printed, Attenuation::InverseSquare.factor(d), gamma(10) * printed), "{d}");
        } else {
            assert_eq!(printed, 1.0, "{d}");
        }
    }
    assert_eq!(attenuation_as_printed([0.0; 3], 7.0), 1.0);
    assert_eq!(light_ray_as_printed(dvec3(1.0, 2.0, 4.0), 0.5, 0.25, false), dvec3(0.125, 0.25, 0.5));
    assert_eq!(light_ray_as_printed(Rgb::ONE, 0.5, 0.25, true), Rgb::ZERO);
}

/// The printed shadow test has a length of 10⁻⁶ built in: it sees no blocker in a small scene, and none is near the
/// place in any scene.
#[test]
fn the_printed_shadow_test_depends_on_the_scenes_size() {
    for (size, is_seen) in [(1.0, true), (1e-3, true), (1e-6, false), (1e-9, false)] {
        assert_eq!(hides_as_printed(1.0 * size, 1.5 * size), is_seen, "{size}");
    }
    assert!(!hides_as_printed(2.0, 2.0) && hides_as_printed(2e16, 2e16 + 4.0));
}

fn direction(u: f64, v: f64) -> DVec3 {
    uniform_sphere(glam::dvec2(u, v))
}

/// A unit vector at that angle to `axis`.
fn tilted(axis: DVec3, angle: f64, around: f64) -> DVec3 {
    let (x, y) = axis.any_orthonormal_pair();
    axis * angle.cos() + (x * around.cos() + y * around.sin()) * angle.sin()
}

fn spot(axis: DVec3, full: f64, edge: f64) -> SpotLight {
    SpotLight::new(PointLight::of_intensity(DVec3::ZERO, Rgb::ONE), axis, full, edge).expect("a cone")
}

/// The formula of the share, from the angle itself.
fn share(angle: f64, full: f64, edge: f64) -> f64 {
    let versine = |angle: f64| 2.0 * (0.5 * angle).sin().powi(2);
    let s = (versine(edge) - versine(angle)) / (versine(edge) - versine(full));
    if s <= 0.0 {
        0.0
    } else if s >= 1.0 {
        1.0
    } else {
        s * s * (3.0 - 2.0 * s)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 512, ..ProptestConfig::default() })]

    /// From cones of a hundredth of a second of arc to the whole sphere. A unit vector's angle to the axis errs by δ: the
    /// vector's own three roundings, those of the frame it is made in (4), of the axis (4) and of the two
    /// differences (2); the share's slope over the angle is 1.5 sin θ/(cos θ_full − cos θ_edge) ≤ 3/(θ_edge − θ_full) for
    /// cones up to 90°, and twice that beyond, where the rim is at the other pole.
    #[test]
    fn shares_are_their_formula(
        u in 0.0..1.0f64, v in 0.0..1.0f64, around in 0.0..TAU, exponent in -8.0..0.4971f64, inner in 0.0..0.95f64,
        at in 0.0..1.5f64,
    ) {
        let (axis, edge) = (direction(u, v), 10f64.powf(exponent).min(PI));
        let (full, angle) = (inner * edge, (at * edge).min(PI));
        let found = spot(axis, full, edge).share(tilted(axis, angle, around));
        let expected = share(angle, full, edge);
        let tolerance = 6.0 * 13.0 * U / (edge - full) + gamma(16);
        // Towards the opposite pole the sine, and with it the slope per difference of versines, vanishes; so does what the
        // difference from the axis tells of the angle: the bound holds.
        prop_assert!(agrees(found, expected, tolerance), "{found} {expected} ± {tolerance}");
        prop_assert!((0.0..=1.0).contains(&found));
    }

    /// All inside, nothing outside, falling between; hard rims have nothing between.
    #[test]
    fn shares_fall_from_the_axis_outwards(
        u in 0.0..1.0f64, v in 0.0..1.0f64, around in 0.0..TAU, edge in 1e-3..3.0f64, inner in 0.0..=1.0f64,
    ) {
        let axis = direction(u, v);
        let (light, hard) = (spot(axis, inner * edge, edge), spot(axis, edge, edge));
        prop_assert_eq!(light.share(axis), 1.0);
        let mut last = 1.0;
        for k in 0..=40 {
            let angle = (f64::from(k) * edge / 32.0).min(PI);
            let towards = tilted(axis, angle, around);
            let found = light.share(towards);
            prop_assert!(found <= last, "{} after {}", found, last);
            if angle < 0.999 * inner * edge {
                prop_assert_eq!(found, 1.0);
            }
            if angle > 1.001 * edge {
                prop_assert_eq!(found, 0.0);
            }
            if (angle / edge - 1.0).abs() > 1e-3 {
                prop_assert_eq!(hard.share(towards), if angle < edge { 1.0 } else { 0.0 });
            }
            last = found;
        }
    }

    /// A light at 10^k times the scene's size is parallel light, but for the scene's size over its distance, up to the last
    /// distances that numbers have.
    #[test]
    fn far_points_shine_as_parallel_light(u in 0.0..1.0f64, v in 0.0..1.0f64, exponent in 1.0..307.0f64) {
        let (wi, distance) = (direction(u, v), 10f64.powf(exponent));
        let parallel = DirectionalLight::of_color(-wi, Rgb::ONE).expect("a direction").arriving();
        let far = PointLight::of_color(wi * distance, Rgb::ONE);
        for p in [DVec3::ZERO, DVec3::ONE, dvec3(-1.0, 0.5, 0.0)] {
            let arrival = far.arriving(p);
            // |p|/d is the angle's tangent; both are unit vectors of a few roundings.
            let tolerance = 1.1 * p.length() / distance + 16.0 * U;
            prop_assert!((arrival.wi - parallel.wi).length() <= tolerance, "{}", arrival.wi);
            prop_assert_eq!(arrival.irradiance, parallel.irradiance);
            let reached = arrival.to * arrival.t_max;
            prop_assert!(reached.is_finite() && (reached.length_squared() == f64::INFINITY
                || agrees(reached.length(), distance, 1.1 * p.length() + 8.0 * U * distance)));
        }
    }
}

/// The rim belongs to the full cone, also where rounded unit vectors lie more than 2 apart.
#[test]
fn a_full_cone_of_180_degrees_is_a_point_light() {
    let mut sampler = Sampler::new(11, 0, 0);
    for _ in 0..1000 {
        let axis = uniform_sphere(sampler.next_2d());
        let whole = spot(axis, PI, PI);
        for direction in [axis, -axis, whole.axis(), -whole.axis(), uniform_sphere(sampler.next_2d())] {
            assert_eq!(whole.share(direction), 1.0, "{axis:?} {direction:?}");
        }
    }
    let hard = spot(DVec3::X, PI / 2.0, PI / 2.0);
    assert_eq!(hard.share(-DVec3::X), 0.0);
}

#[test]
fn cones_that_cannot_be() {
    let point = PointLight::of_color(DVec3::ZERO, Rgb::ONE);
    assert_eq!(SpotLight::new(point, DVec3::ZERO, 0.1, 0.2), Err(LightError::NoDirection));
    for (full, edge) in [(0.0, 0.0), (0.3, 0.2), (-0.1, 0.2), (0.0, 3.15), (f64::NAN, 1.0), (0.0, f64::NAN)] {
        let made = SpotLight::new(point, DVec3::X, full, edge);
        assert!(matches!(made, Err(LightError::Angle { .. })), "{full} {edge}");
    }
    assert_eq!(DirectionalLight::new(DVec3::ZERO, Rgb::ONE), Err(LightError::NoDirection));
    assert!(spot(DVec3::X, 0.1, 0.2).share(DVec3::NAN).is_nan());
}

/// The flux of a point light through a closed surface is 4π I, wherever in it the light stands.
#[test]
fn the_flux_through_any_enclosing_sphere_is_that_of_the_light() {
    for (radius, off) in [(1.0, 0.0), (1.0, 0.5), (3.0, 2.9), (1e6, 1.0)] {
        for light in [
            PointLight::of_intensity(DVec3::new(0.0, off, 0.0), Rgb::ONE),
            PointLight::of_flux(DVec3::new(0.0, off, 0.0), Rgb::splat(4.0 * PI)),
        ] {
            let through = |theta: f64| {
                let n = dvec3(theta.sin(), theta.cos(), 0.0);
                let arrival = light.arriving(n * radius);
                arrival.irradiance.x * -n.dot(arrival.wi) * TAU * radius * radius * theta.sin()
            };
            let flux = integrate(through, &[0.0, 0.1, PI], 1e-12);
            // The point next to a light 0.1 away carries 10³ times the rounding of the place's length 3.
            let tolerance = flux.error + 4.0 * PI * gamma(64) * radius / (radius - off);
            assert!(agrees(flux.value, 4.0 * PI, tolerance), "{radius} {off}: {flux:?}");
        }
    }
}

#[test]
fn the_flux_of_a_spot_is_its_closed_form() {
    for (full, edge) in [(0.0, 0.3), (0.2, 0.3), (0.3, 0.3), (0.0, PI), (1.0, 2.5), (PI, PI), (1e-7, 2e-7)] {
        let light = spot(DVec3::Z, full, edge);
        let through = |angle: f64| {
            let arrival = light.arriving(2.0 * dvec3(angle.sin(), 0.0, angle.cos()));
            arrival.irradiance.x * 4.0 * TAU * angle.sin()
        };
        let flux =
            integrate(through, &[0.0, 0.5 * full, full, 0.5 * (full + edge), edge], 1e-13 * edge * edge);
        let expected = light.solid_angle();
        // The rim itself is smeared over the rounding of an angle, some u, out of the cone.
        let tolerance = flux.error + expected * (gamma(40) + 40.0 * U / edge);
        assert!(agrees(flux.value, expected, tolerance), "{full} {edge}: {flux:?} {expected}");
    }
}

/// A picture of a floor with things on it.
struct Stage {
    name: &'static str,
    things: fn() -> Vec<Box<dyn Shape>>,
}

fn few() -> Vec<Box<dyn Shape>> {
    let sphere = Sphere::new(dvec3(0.0, 1.0, 0.0), 1.0).expect("a sphere");
    vec![Box::new(sphere)]
}

/// Enough for a hierarchy.
fn many() -> Vec<Box<dyn Shape>> {
    let ball = |k: u32| -> Box<dyn Shape> {
        let mut sampler = Sampler::new(3, k.into(), 0);
        let (a, b) = (sampler.next_2d(), sampler.next_2d());
        let center = dvec3(6.0 * a.x - 3.0, 0.3 + 2.0 * b.x, 6.0 * a.y - 3.0);
        Box::new(Sphere::new(center, 0.1 + 0.3 * b.y).expect("a sphere"))
    };
    (0..60).map(ball).collect()
}

/// Costly ones, which are asked only where their bounds are met.
fn rings() -> Vec<Box<dyn Shape>> {
    let ring = |k: i32| -> Box<dyn Shape> {
        let frame = glam::DAffine3::from_translation(dvec3(f64::from(k) - 1.0, 0.6, f64::from(k)))
            * glam::DAffine3::from_rotation_x(0.7 * f64::from(k));
        let torus = Box::new(Torus::new(0.5, 0.1).expect("a torus"));
        Box::new(lightbench::shape::instance::Instance::new(torus, frame).expect("a map"))
    };
    (0..3).map(ring).collect()
}

fn floor_with(things: Vec<Box<dyn Shape>>, lights: Vec<Light>) -> Scene {
    let view = FieldOfView::Vertical(0.7);
    let camera = Camera::new(dvec3(0.0, 4.0, 9.0), dvec3(0.0, 0.7, 0.0), DVec3::Y, view).expect("a camera");
    let mut scene = Scene::new(camera);
    scene.materials.push(Material { diffuse: Rgb::new(0.9, 0.8, 0.7), ..Material::default() });
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).expect("a plane");
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    for thing in things {
        scene.objects.push(Object::new("thing", thing, 0));
    }
    scene.lights = lights;
    scene
}

fn all_sharp_lights() -> Vec<Light> {
    let cone = PointLight::of_color(dvec3(-3.0, 5.0, 3.0), Rgb::new(0.2, 0.3, 0.9));
    vec![
        PointLight::of_intensity(dvec3(3.0, 5.0, 2.0), Rgb::splat(20.0)).into(),
        SpotLight::new(cone, dvec3(3.0, -4.5, -3.0), 0.2, 0.3).expect("a cone").into(),
        DirectionalLight::of_color(dvec3(-1.0, -1.0, 1.0), Rgb::new(0.5, 0.4, 0.1)).expect("a sun").into(),
    ]
}

const PICTURE: Picture = Picture { width: 49, height: 35, samples: 2, seed: 7 };

#[test]
fn memory_never_changes_a_picture() {
    for Stage { name, things } in [
        Stage { name: "few", things: few },
        Stage { name: "many", things: many },
        Stage { name: "rings", things: rings },
    ] {
        let scene = floor_with(things(), all_sharp_lights());
        let picture = |memory, threads| {
            let control = Control { threads, stop: &AtomicBool::new(false), progress: &|_| {} };
            render_with(&scene, &Local { memory, ..Local::default() }, PICTURE, control).expect("a picture")
        };
        let plain = picture(Memory::Nothing, 1);
        for memory in [Memory::Nothing, Memory::LastBlocker] {
            let runs = [1, 2, 5].map(|threads| picture(memory, threads));
            assert!(runs.iter().all(|r| r.image == plain.image), "{name}: {memory:?} changes the picture");
            // Counts too are those of one thread: tiles begin without memory.
            assert!(runs.iter().all(|r| r.tally == runs[0].tally), "{name}: {memory:?}");
        }
        let remembered = picture(Memory::LastBlocker, 1).tally;
        assert_eq!(remembered.rays(RayKind::Shadow), plain.tally.rays(RayKind::Shadow));
        if name == "many" {
            let looks = |t: &Tally| t.shape_tests + t.node_visits;
            assert!(looks(&remembered) < looks(&plain.tally), "{name}: remembering saves nothing");
        }
    }
}

fn picture_of(lights: Vec<Light>) -> Image {
    render(&floor_with(few(), lights), &Local::default(), PICTURE).image
}

/// A light moved to infinity draws the directional light's picture: the shade changes with the scene's size over the
/// distance, and nothing else does, however far.
#[test]
fn a_light_moved_to_infinity_draws_the_directional_picture() {
    let wi = dvec3(1.0, 2.0, 1.5).normalize();
    let sun = picture_of(vec![DirectionalLight::of_color(-wi, Rgb::ONE).expect("a direction").into()]);
    for exponent in [17, 60, 61, 150, 155, 200, 300] {
        let far = PointLight::of_color(wi * 10f64.powi(exponent), Rgb::ONE);
        let image = picture_of(vec![far.into()]);
        let most = image.pixels().iter().zip(sun.pixels()).map(|(a, b)| (*a - *b).abs().max_element());
        // No edge moves by as much as a rounding of the direction times the picture's size; shades by a few roundings.
        assert!(most.fold(0.0, f64::max) <= gamma(64), "10^{exponent}");
    }
}

/// Where a light has no business shining, nothing shines, and nothing is NaN.
#[test]
fn lights_in_odd_places() {
    let lit = |image: &Image| image.pixels().iter().filter(|p| **p != Rgb::ZERO).count();
    let numbers = |image: &Image| image.pixels().iter().all(|p| p.is_finite());
    let point = |p: DVec3| PointLight::of_intensity(p, Rgb::ONE).into();
    let below = picture_of(vec![point(dvec3(0.0, -2.0, 0.0))]);
    assert!(numbers(&below) && lit(&below) == 0, "a light under an endless floor");
    let sun = DirectionalLight::of_color(DVec3::Y, Rgb::ONE).expect("a direction");
    let below = picture_of(vec![sun.into()]);
    assert!(numbers(&below) && lit(&below) == 0, "a sun below the horizon");
    let inside = picture_of(vec![point(dvec3(0.0, 1.0, 0.0))]);
    assert!(
        numbers(&inside) && lit(&inside) == 0,
        "a light inside a sphere that the camera sees from outside"
    );
    // In the floor: the floor is dark, the sphere is lit from below, without a speckle of rounding.
    let inside = picture_of(vec![point(dvec3(2.0, 0.0, 2.0))]);
    let near = picture_of(vec![point(dvec3(2.0, 1e-9, 2.0))]);
    assert!(numbers(&inside) && lit(&inside) > 0);
    let on_sphere = |image: &Image| image.pixels().iter().filter(|p| p.x > 1e-6).count();
    assert_eq!(on_sphere(&inside), on_sphere(&near), "the floor that carries the light hides it");
}

/// From within a sphere its own inside is lit by the light in its middle, evenly.
#[test]
fn a_light_in_the_middle_lights_the_inside_evenly() {
    let light = PointLight::of_intensity(DVec3::ZERO, Rgb::splat(PI));
    let view = FieldOfView::Vertical(1.0);
    let camera = Camera::new(dvec3(0.0, 0.0, 0.5), DVec3::NEG_Z, DVec3::Y, view).expect("a camera");
    let mut scene = Scene::new(camera);
    scene.materials.push(Material { diffuse: Rgb::splat(0.5), ..Material::default() });
    let sphere = Sphere::new(DVec3::ZERO, 2.0).expect("a sphere");
    scene.objects.push(Object::new("sphere", Box::new(sphere), 0));
    scene.lights.push(light.into());
    let image = render(&scene, &Local::default(), PICTURE).image;
    // ρ/π · I/r² · 1, and some tens of roundings of place and normal.
    assert!(image.pixels().iter().all(|p| agrees(p.x, 0.125, gamma(64))));
}

/// A light exactly in the place that it lights has no direction to it; nothing comes from there, and no NaN.
#[test]
fn a_light_in_the_place_itself_is_dark() {
    for attenuation in [Attenuation::None, Attenuation::InverseSquare, law(0.0, 1.0, 1.0)] {
        let light = PointLight::of_color(DVec3::ONE, Rgb::ONE).with_attenuation(attenuation);
        assert!(light.arriving(DVec3::ONE).wi.is_nan());
        let near = light.arriving(DVec3::ONE + 2.0 * f64::EPSILON);
        assert!(near.wi.is_normalized() && near.t_max == 1.0);
    }
    let tiny = PointLight::of_color(dvec3(0.0, 0.0, 1e-200), Rgb::ONE).arriving(DVec3::ZERO);
    assert_eq!((tiny.wi, tiny.t_max), (DVec3::Z, 1e-200));
    let cuboid = Cuboid::new(DVec3::NEG_ONE, DVec3::ONE).expect("a box");
    let scene =
        floor_with(vec![Box::new(cuboid)], vec![PointLight::of_intensity(DVec3::ONE, Rgb::ONE).into()]);
    let image = render(&scene, &Local::default(), PICTURE).image;
    assert!(image.pixels().iter().all(|p| p.is_finite()), "a light in a corner of a box");
}
