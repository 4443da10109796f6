//! Local illumination, shadow fans, the tile loop.

use glam::{DVec2, DVec3};
use lightbench::color::Rgb;
use lightbench::integrator::{Local, Stage};
use lightbench::light::{AreaLight, Emission, Light, PointLight};
use lightbench::num::gamma;
use lightbench::ray::{Ray, RayKind};
use lightbench::render::{Control, Picture, RenderError, render, render_with, replay};
use lightbench::sample::{Cells, Pattern};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::fan::{Ends, Fan, Vectors};
use lightbench::shape::sphere::Sphere;
use lightbench::shape::{Shape, Solid};
use proptest::prelude::*;
use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

const PICTURE: Picture = Picture { width: 45, height: 37, samples: 2, seed: 7 };

fn room(pattern: Pattern) -> Scene {
    let camera = Camera::new(
        DVec3::new(0.0, 5.0, 15.0),
        DVec3::new(0.0, 5.0, 0.0),
        DVec3::Y,
        FieldOfView::Vertical(45f64.to_radians()),
    )
    .expect("a camera");
    let mut scene = Scene::new(camera);
    scene.materials.push(Material { diffuse: Rgb::new(0.9, 0.8, 0.7), ..Material::default() });
    for y in [1.0, 3.0, 5.0] {
        let sphere = Sphere::new(DVec3::new(0.0, y, 0.0), 1.0).expect("a sphere");
        scene.objects.push(Object::new("sphere", Box::new(sphere), 0));
    }
    for (min, max) in [([-5.0, -1.0, -5.0], [5.0, 0.0, 5.0]), ([-5.0, 0.0, -6.0], [5.0, 10.0, -5.0])] {
        let wall = Cuboid::new(DVec3::from_array(min), DVec3::from_array(max)).expect("a box");
        scene.objects.push(Object::new("wall", Box::new(wall), 0));
    }
    let (center, size) = (DVec3::new(3.0, 5.0, 8.0), DVec2::splat(2.0));
    let light =
        AreaLight::rectangle(center, DVec3::NEG_Z, 0.3, size, Emission::even(Rgb::ONE)).expect("a light");
    scene.lights.push(Light::Area(light.subdivided(5, 5, pattern)));
    let position = DVec3::new(-3.0, 8.0, 4.0);
    scene.lights.push(PointLight::of_intensity(position, Rgb::splat(20.0)).into());
    scene
}

#[test]
fn every_number_of_threads_gives_the_same_bytes() {
    let scene = room(Pattern::Jittered);
    let picture = |threads| {
        let control = Control { threads, stop: &AtomicBool::new(false), progress: &|_| {} };
        render_with(&scene, &Local::default(), PICTURE, control).expect("a picture")
    };
    let (one, two, seven) = (picture(1), picture(2), picture(7));
    assert!(one.image.pixels().iter().any(|p| *p != Rgb::ZERO));
    assert_eq!(one.image, two.image);
    assert_eq!(one.image, seven.image);
    assert_eq!(one.tally, seven.tally);
}

#[test]
fn wide_and_narrow_vectors_give_the_same_bits() {
    let scene = room(Pattern::Centres);
    let picture = |vectors| render(&scene, &Local { vectors, ..Local::default() }, PICTURE).image;
    assert_eq!(picture(Vectors::Widest), picture(Vectors::Baseline));
}

#[test]
fn another_seed_gives_other_bytes() {
    let scene = room(Pattern::Jittered);
    let picture = |seed| render(&scene, &Local::default(), Picture { seed, ..PICTURE }).image;
    assert_ne!(picture(7), picture(8));
}

#[test]
fn an_interrupted_picture_is_no_picture() {
    let control = Control { threads: 2, stop: &AtomicBool::new(true), progress: &|_| {} };
    let done = render_with(&room(Pattern::Centres), &Local::default(), PICTURE, control);
    assert_eq!(done.err(), Some(RenderError::Interrupted));
}

/// The tree that a replay tells adds up to the pixel it tells about.
#[test]
fn a_replay_is_the_pixel() {
    let scene = room(Pattern::Jittered);
    let image = render(&scene, &Local::default(), PICTURE).image;
    for at in [(0, 0), (22, 20), (30, 30), (44, 36)] {
        let (value, rays) = replay(&scene, &Local::default(), PICTURE, at);
        assert_eq!(value, image.get(at.0, at.1));
        assert_eq!(rays.len(), PICTURE.samples as usize);
        let mut sum = Rgb::ZERO;
        for ray in &rays {
            sum += ray.radiance;
            // A camera ray that met an object brings what its shadow rays bring: 26 terms and their products.
            let brought: Rgb = ray.children.iter().map(|c| c.weight * c.radiance).sum();
            if ray.hit.is_some() {
                assert!((brought - ray.radiance).length() <= gamma(100) * ray.radiance.length(), "{at:?}");
                assert!(ray.children.iter().all(|c| c.kind == RayKind::Shadow));
            }
        }
        assert_eq!(sum / f64::from(PICTURE.samples), value);
    }
}

/// A floor under one light, seen from above; what the middle pixel shows.
fn floor_under(light: Light) -> Rgb {
    let above = FieldOfView::Vertical(1e-3);
    let camera = Camera::new(DVec3::new(0.0, 9.0, 0.0), DVec3::ZERO, DVec3::Z, above).expect("a camera");
    let mut scene = Scene::new(camera);
    scene.materials.push(Material { diffuse: Rgb::splat(0.5), ..Material::default() });
    let floor = Cuboid::new(DVec3::new(-50.0, -1.0, -50.0), DVec3::new(50.0, 0.0, 50.0)).expect("a box");
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    scene.lights.push(light);
    render(&scene, &Local::default(), Picture { width: 1, height: 1, samples: 1, seed: 0 }).image.get(0, 0)
}

#[test]
fn point_lights_follow_their_formulas() {
    let position = DVec3::new(3.0, 4.0, 0.0); // at distance 5, cos θ = 0.8
    let flat = floor_under(PointLight::of_color(position, Rgb::splat(2.0)).into()).x;
    assert!((flat - 0.5 * 2.0 * 0.8).abs() <= gamma(20), "{flat}");
    let radiometric = floor_under(PointLight::of_intensity(position, Rgb::splat(2.0)).into()).x;
    assert!((radiometric - 0.5 / PI * 2.0 * 0.8 / 25.0).abs() <= gamma(20), "{radiometric}");
}

/// A square of radiance L straight above, parallel: four times the closed form for a corner.
///
/// The midpoint rule over n × n cells errs by O(1/n²): against 32 cells, 64 have a quarter of the error.
#[test]
fn a_radiometric_rectangle_converges_to_its_closed_form() {
    let (half, height) = (1.5f64, 2.0f64);
    let x = half / height;
    let s = (1.0 + x * x).sqrt();
    let truth = 0.5 / PI * 3.0 * 4.0 * (x / s) * (x / s).atan(); // ρ/π · L · 4 · π F of a corner
    let error = |n: u32| {
        let center = DVec3::new(0.0, height, 0.0);
        let size = DVec2::splat(2.0 * half);
        let light = AreaLight::rectangle(center, DVec3::NEG_Y, 0.0, size, Emission::diffuse(Rgb::splat(3.0)))
            .expect("a light");
        // The camera looks through the light: its back is not there.
        (floor_under(Light::Area(light.subdivided(n, n, Pattern::Centres))).x - truth).abs()
    };
    let (coarse, fine) = (error(32), error(64));
    assert!(coarse < 1e-3 * truth, "{coarse}");
    assert!((fine / coarse - 0.25).abs() < 0.01, "{fine} {coarse}");
}

/// A light in the plane of the ceiling that carries it is not shadowed by it.
#[test]
fn a_light_may_touch_what_carries_it() {
    for height in [0.1, 1.0 / 3.0, 7.7, 1e6 / 3.0] {
        let center = DVec3::new(0.1, height, 0.7 / 3.0);
        let size = DVec2::splat(0.4 * height);
        let light =
            AreaLight::rectangle(center, DVec3::NEG_Y, 0.1, size, Emission::even(Rgb::ONE)).expect("a light");
        let mut ends = Ends::within(center, size.length());
        ends.place(Cells::grid(10, 10).iter().map(|cell| light.emitter.point(cell.center())));
        let mut fan = Fan::new(Vectors::Widest);
        fan.aim(DVec3::new(0.3, 0.0, 0.2), &ends);
        let top = DVec3::new(9.0 * height, 2.0 * height, 9.0 * height);
        let ceiling = Cuboid::new(DVec3::new(-9.0 * height, height, -9.0 * height), top).expect("a box");
        let mut lit = vec![1.0; fan.padded_len()];
        ceiling.shade(&fan, &mut lit);
        assert!(lit.iter().all(|l| *l == 1.0), "height {height}");
    }
}

/// The decisions of [`Shape::shade`] and [`Shape::blocks`] differ at most where a segment is tangent or ends on
/// the surface, and [`Shape::may_block`] never says no to a segment that is blocked.
fn fan_agrees_with_rays(
    shape: &dyn Shape,
    origin: DVec3,
    center: DVec3,
    radius: f64,
) -> Result<(), TestCaseError> {
    let mut ends = Ends::within(center, radius);
    let spiral = |i: u32| {
        let (sin, cos) = (f64::from(i) * 2.4).sin_cos();
        center + DVec3::new(cos, 0.3 * sin, sin) * (radius * 0.9 * f64::from(i) / 21.0)
    };
    ends.place((0..21).map(spiral));
    let mut fan = Fan::new(Vectors::Widest);
    fan.aim(origin, &ends);
    let mut lit = vec![1.0; fan.padded_len()];
    shape.shade(&fan, &mut lit);
    for (i, lit) in lit.iter().enumerate().take(fan.len()) {
        let segment = Ray::new(origin, fan.direction(i));
        prop_assert_eq!(*lit == 0.0, shape.blocks(&segment, 1.0), "segment {}", i);
        if *lit == 0.0 {
            prop_assert!(
                fan.hull.overlaps(&shape.bounds()) && shape.may_block(&fan),
                "segment {} is culled",
                i
            );
        }
    }
    Ok(())
}

fn point(size: f64) -> impl Strategy<Value = DVec3> {
    (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn fans_decide_as_rays_do(origin in point(4.0), center in point(6.0), radius in 0.01..2.0f64) {
        let sphere = Sphere::new(DVec3::new(0.3, -0.2, 0.1), 1.7).expect("a sphere");
        fan_agrees_with_rays(&sphere, origin, center, radius)?;
        let cuboid = Cuboid::new(DVec3::new(-1.0, -2.0, -0.5), DVec3::new(1.5, 0.5, 1.0)).expect("a box");
        fan_agrees_with_rays(&cuboid, origin, center, radius)?;
    }

    /// Rays that leave a convex solid from its surface never meet it again, at any scale and any place.
    #[test]
    fn convex_solids_never_shade_themselves(
        exponent in -6i32..=6, place in point(1.0), aim in point(1.0), away in point(1.0), far in 0.0..1.0e6f64,
    ) {
        let scale = 10f64.powi(exponent);
        let center = place * (far * scale);
        let sphere = Sphere::new(center, scale).expect("a sphere");
        let cuboid = Cuboid::new(center - scale, center + scale).expect("a box");
        let eye = center + DVec3::new(3.0, 4.0, 5.0) * scale;
        let target = center + aim * (0.9 * scale);
        let ray = Ray::new(eye, (target - eye).normalize());
        let solids: [&dyn Solid; 2] = [&sphere, &cuboid];
        for solid in solids {
            let Some(crossing) = solid.nearest(&ray, 0.0, f64::INFINITY) else { continue };
            let hit = solid.hit(&ray, &crossing);
            let outward = if away.dot(hit.ng) < 0.0 { -away } else { away };
            // Directions within rounding of the tangent plane may graze the sphere.
            if outward.dot(hit.ng) < 1e-6 * outward.length() {
                continue;
            }
            let leaving = Ray::new(hit.origin_towards(outward), outward);
            prop_assert!(!solid.blocks(&leaving, f64::INFINITY), "{solid:?} shades itself at {}", hit.point);
            // And towards the inside it meets the other side: the origin did not move past anything.
            let entering = Ray::new(hit.origin_towards(-hit.ng), -hit.ng);
            prop_assert!(solid.blocks(&entering, f64::INFINITY), "{solid:?} leaks at {}", hit.point);
        }
    }
}

/// The stages add up: shadows take light away, and only light.
#[test]
fn shadows_only_darken() {
    let scene = room(Pattern::Centres);
    let picture = |stage| render(&scene, &Local { stage, ..Local::default() }, PICTURE).image;
    let (open, shadowed) = (picture(Stage::Unshadowed), picture(Stage::Shadowed));
    let darker = |(a, b): (&Rgb, &Rgb)| b.cmple(*a).all();
    assert!(open.pixels().iter().zip(shadowed.pixels()).all(darker));
    assert_ne!(open, shadowed);
}
