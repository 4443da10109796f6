//! Pictures of lesson 07: a flattened ball with two kinds of normals, and every surface so far.

use glam::{DAffine3, DMat3, DQuat, DVec3, dvec2, dvec3};
use lightbench::bounds::Aabb;
use lightbench::film::Image;
use lightbench::frame::unit;
use lightbench::integrator::Local;
use lightbench::light::{AreaLight, Emission, Light};
use lightbench::render::{Picture, render};
use lightbench::sample::Pattern;
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::Shape;
use lightbench::shape::cone::Cone;
use lightbench::shape::cuboid::Cuboid;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::disc::Disc;
use lightbench::shape::instance::Instance;
use lightbench::shape::polygon::Polygon;
use lightbench::shape::polyhedron::{ConvexPolyhedron, HalfSpace};
use lightbench::shape::quadric::{ClippedQuadric, Ellipsoid, Quadric};
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench::shape::triangle::Triangle;
use lightbench_kit::figure::{ErrorPanel, Figure, Panels, Pixels, Shades};

/// A ball under `stretch`, lit by its right normals and by M n, and the angle between them.
pub fn normals(stretch: DVec3, size: usize) -> Figure {
    let map = DAffine3 { matrix3: DMat3::from_diagonal(stretch), translation: DVec3::ZERO };
    let ball = Sphere::new(DVec3::ZERO, 1.0).expect("a unit sphere");
    let shape = Instance::new(Box::new(ball), map).expect("a map that keeps space");
    let camera =
        Camera::new(dvec3(0.0, 1.1, 4.4), DVec3::ZERO, DVec3::Y, FieldOfView::Vertical(28f64.to_radians()))
            .expect("a camera");
    let light = dvec3(-0.5, 0.75, 0.6).normalize();
    let height = size * 3 / 4;
    let mut tilts = vec![0.0; size * height];
    let mut picture = |kind: usize| {
        Image::from_fn(size, height, |i, j| {
            let ray = camera.ray(dvec2(i as f64, j as f64) + 0.5, size, height);
            let Some(crossing) = shape.nearest(&ray, 0.0, f64::INFINITY) else { return DVec3::splat(0.90) };
            let hit = shape.hit(&ray, &crossing);
            // The sphere's own normal is the point itself, before the map.
            let wrong = unit(map.matrix3 * (hit.point / stretch)).unwrap_or(hit.ng);
            let n = [hit.ng, wrong][kind];
            tilts[j * size + i] = hit.ng.angle_between(wrong).to_degrees();
            dvec3(0.85, 0.46, 0.24) * (0.12 + 0.88 * n.dot(light).max(0.0))
        })
    };
    let (right, wrong) = (picture(0), picture(1));
    let largest = tilts.iter().copied().fold(0.0, f64::max);
    let rmse = (tilts.iter().map(|t| t * t).sum::<f64>()
        / tilts.iter().filter(|t| **t > 0.0).count().max(1) as f64)
        .sqrt();
    let error = ErrorPanel {
        width: size,
        height,
        values: tilts,
        shades: Shades::Linear,
        name: "tilt, degrees".into(),
        rmse,
        range: Some((0.0, largest)),
    };
    Figure::from(
        Panels::new()
            .columns(3)
            .title(&format!("Normals sent through M light a ball that is not there: up to {largest:.0}° off"))
            .subtitle(&format!("unit ball flattened to {} of its height, Lambert, one lamp from the upper left", stretch.y))
            .alt("Two pictures of a flattened ball: with right normals the light falls off over the flat top; with wrong ones it looks like a tall ball. A map shows the tilt.")
            .picture(Pixels::from(&right), "n ↦ M⁻ᵀ n")
            .picture(Pixels::from(&wrong), "n ↦ M n")
            .error(error),
    )
    .caption("A flattened ball with the normals of the inverse transpose, and with normals treated as displacements.")
}

/// A, illustration 123: every kind of surface so far.
pub fn all_surfaces(width: usize, samples: u32, seed: u64) -> Figure {
    let height = width * 9 / 16;
    let scene = gathering();
    let count = scene.objects.len() - 1;
    let image = render(&scene, &Local::default(), Picture { width, height, samples, seed }).image;
    Figure::from(
        Panels::new()
            .title(&format!("{count} surfaces: each stands where it does by a point, an axis or a map"))
            .subtitle("sphere, ellipsoid, cylinder, cone, torus, boxes, polyhedron, triangle, disc, polygon, paraboloid, hyperboloids")
            .alt("Solids and flat surfaces of many colours on a pale floor, in three rows, under a soft lamp.")
            .picture(Pixels::from(&image), ""),
    )
    .caption("All kinds of surfaces so far (after A, illustration 123, which adds meshes and mirrors).")
}

fn gathering() -> Scene {
    let camera = Camera::new(
        dvec3(0.0, 6.4, 12.0),
        dvec3(0.0, 0.55, 0.1),
        DVec3::Y,
        FieldOfView::Vertical(28.5f64.to_radians()),
    );
    let mut scene = Scene::new(camera.expect("a camera in its place"));
    let matt = |diffuse| Material { diffuse, specular: DVec3::ZERO, ..Material::default() };
    let colours = [
        dvec3(0.80, 0.30, 0.16),
        dvec3(0.16, 0.42, 0.66),
        dvec3(0.75, 0.52, 0.12),
        dvec3(0.20, 0.55, 0.36),
        dvec3(0.62, 0.34, 0.52),
        dvec3(0.28, 0.52, 0.68),
    ];
    scene.materials = std::iter::once(DVec3::splat(0.82)).chain(colours).map(matt).collect();
    let floor = Cuboid::new(dvec3(-80.0, -0.2, -80.0), dvec3(80.0, 0.0, 80.0)).expect("a floor");
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    for (i, shape) in surfaces().into_iter().enumerate() {
        scene.objects.push(Object::new(format!("surface {i}"), shape, 1 + i % colours.len()));
    }
    let at = dvec3(-5.0, 9.0, 6.0);
    let lamp = AreaLight::rectangle(
        at,
        dvec3(0.0, 0.5, 0.0) - at,
        0.0,
        dvec2(2.6, 2.6),
        Emission::even(DVec3::splat(0.86)),
    )
    .expect("a lamp");
    scene.lights = vec![Light::Area(lamp.subdivided(2, 2, Pattern::Jittered))];
    scene.ambient = DVec3::splat(0.22);
    scene.background = DVec3::splat(0.9);
    scene
}

/// Three rows of surfaces, from the back to the front.
fn surfaces() -> Vec<Box<dyn Shape>> {
    let moved = |shape: Box<dyn Shape>, axis: DVec3, angle: f64, scale: DVec3, to: DVec3| -> Box<dyn Shape> {
        let map = DAffine3::from_scale_rotation_translation(
            scale,
            DQuat::from_axis_angle(axis.normalize(), angle),
            to,
        );
        Box::new(Instance::new(shape, map).expect("a map that keeps space"))
    };
    // The named quadrics stand along z: a quarter turn puts them upright.
    let upright = |q: Quadric, to: DVec3| {
        let clip = Aabb::new(dvec3(-0.75, -0.75, -0.7), dvec3(0.75, 0.75, 0.7));
        moved(
            Box::new(ClippedQuadric { quadric: q, clip }),
            DVec3::X,
            -std::f64::consts::FRAC_PI_2,
            DVec3::ONE,
            to + DVec3::Y * 0.7,
        )
    };
    let (o, x) = (DVec3::ZERO, [-4.0, -2.4, -0.8, 0.8, 2.4, 4.0]);
    let at = |i: usize, y: f64, z: f64| dvec3(x[i], y, z);
    let [back, middle, front] = [-2.3, 0.2, 2.5];
    let cube = || Box::new(Cuboid::new(-DVec3::splat(0.5), DVec3::splat(0.5)).expect("a cube"));
    let octahedron: Vec<HalfSpace> = (0..8)
        .map(|i| dvec3([1.0, -1.0][i & 1], [1.0, -1.0][i >> 1 & 1], [1.0, -1.0][i >> 2]))
        .map(|normal| HalfSpace { point: at(5, 0.75, middle) + normal * 0.25, normal })
        .collect();
    let pentagon = (0..5)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 5.0)
        .map(|a| at(3, 0.6, front) + dvec3(0.6 * a.sin(), 0.6 * a.cos() * 0.94, 0.6 * a.cos() * -0.34));
    let saddle = Quadric::hyperbolic_paraboloid(o, 0.75, 0.75).expect("a saddle");
    vec![
        upright(Quadric::paraboloid(-DVec3::Z * 0.7, 0.55, 0.55).expect("a paraboloid"), at(0, 0.0, back)),
        upright(
            Quadric::hyperboloid_of_one_sheet(o, dvec3(0.32, 0.32, 0.4)).expect("a hyperboloid"),
            at(1, 0.0, back),
        ),
        upright(
            Quadric::hyperboloid_of_two_sheets(o, dvec3(0.24, 0.24, 0.24)).expect("a hyperboloid"),
            at(2, 0.0, back),
        ),
        upright(saddle, at(3, 0.0, back)),
        upright(Quadric::cone(o, 0.9).expect("a double cone"), at(4, 0.0, back)),
        upright(Quadric::cylinder(o, 0.5).expect("a tube"), at(5, 0.0, back)),
        Box::new(Sphere::new(at(0, 0.65, middle), 0.65).expect("a sphere")),
        Box::new(Ellipsoid::new(at(1, 0.8, middle), dvec3(0.5, 0.8, 0.5)).expect("an ellipsoid")),
        Box::new(Cylinder::new(at(2, 0.0, middle), at(2, 1.2, middle), 0.5).expect("a cylinder")),
        Box::new(Cone::new(at(3, 0.0, middle), at(3, 1.35, middle), 0.65, 0.0).expect("a cone")),
        Box::new(Cone::new(at(4, 0.0, middle), at(4, 0.9, middle), 0.65, 0.3).expect("a frustum")),
        Box::new(ConvexPolyhedron::new(&octahedron).expect("an octahedron")),
        moved(
            Box::new(Torus::new(0.5, 0.2).expect("a torus")),
            dvec3(1.0, 0.12, 0.0),
            1.15,
            DVec3::ONE,
            at(0, 0.48, front),
        ),
        moved(cube(), DVec3::Y, 0.6, DVec3::splat(1.0), at(1, 0.5, front)),
        moved(cube(), dvec3(0.3, 1.0, 0.4), 0.8, dvec3(1.0, 0.5, 0.8), at(2, 0.62, front)),
        Box::new(Polygon::new(pentagon.collect()).expect("a pentagon")),
        Box::new(Disc::new(at(4, 0.6, front), dvec3(-0.2, 0.5, 1.0), 0.6).expect("a disc")),
        Box::new(
            Triangle::new(
                at(5, 0.0, front) + dvec3(-0.6, 0.0, 0.2),
                at(5, 0.0, front) + dvec3(0.6, 0.0, 0.2),
                at(5, 1.1, front) - dvec3(0.0, 0.0, 0.3),
            )
            .expect("a triangle"),
        ),
    ]
}
