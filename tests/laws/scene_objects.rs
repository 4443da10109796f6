//! Surfaces in scene files: defaults, mistakes, transformations beside shapes made by hand, and the printed reference.

use glam::{DAffine3, DVec3};
use lightbench::bounds::Aabb;
use lightbench::integrator::Local;
use lightbench::ray::Ray;
use lightbench::render::{Picture, render};
use lightbench::scene::{Object, Scene};
use lightbench::sdf::Menger;
use lightbench::shape::cone::Cone;
use lightbench::shape::cylinder::Cylinder;
use lightbench::shape::disc::Disc;
use lightbench::shape::instance::Instance;
use lightbench::shape::plane::Plane;
use lightbench::shape::quadric::{ClippedQuadric, Coefficients, Ellipsoid, Quadric};
use lightbench::shape::sphere::Sphere;
use lightbench::shape::torus::Torus;
use lightbench::shape::triangle::Triangle;
use lightbench::shape::{Shape, Sides};
use lightbench_kit::scene_file::{Color, SceneFile, read, read_file, reference};
use std::f64::consts::FRAC_PI_2;
use std::path::Path;

/// A right scene without objects, on four lines; the tests add theirs from line 5 on.
const STAGE: &str = "SceneSettings { RenderWidth 48 RenderHeight 48 IndirectQuality 0 }\n\
                     Camera { POV 1 3 7 POI 0 0.5 0 }\n\
                     Material { Name m Roughness 0 SpecularColor 0 0 0 }\n\
                     PointLight { Position 2 6 5 } AreaLight { Position -4 5 4 Direction 4 -5 -4 }\n";

fn right(objects: &str) -> SceneFile {
    match read(&format!("{STAGE}{objects}"), "t.scene") {
        Ok(file) => file,
        Err(d) => panic!("{}", d.render(Color::Never)),
    }
}

/// The only object of a file, as it is made.
fn made(object: &str) -> String {
    format!("{:?}", right(object).scene.objects[0].shape())
}

fn same(object: &str, shape: impl Shape) {
    assert_eq!(made(object), format!("{shape:?}"), "{object}");
}

const O: DVec3 = DVec3::ZERO;
const X: DVec3 = DVec3::X;
const Y: DVec3 = DVec3::Y;
const Z: DVec3 = DVec3::Z;

#[test]
fn defaults_are_those_of_the_reference() {
    same("Cylinder { Material m }", Cylinder::new(O, Y, 1.0).unwrap());
    same("Cone { Material m }", Cone::new(O, Y, 1.0, 0.0).unwrap());
    same("Ellipsoid { Material m SemiAxes 1 2 3 }", Ellipsoid::new(O, DVec3::new(1.0, 2.0, 3.0)).unwrap());
    same("Ellipsoid { Material m }", Sphere::new(O, 1.0).unwrap());
    same("Plane { Material m }", Plane::new(O, Y).unwrap());
    same("Disc { Material m }", Disc::new(O, Y, 1.0).unwrap());
    same("Torus { Material m Axis 0 0 1 }", Torus::new(1.0, 0.25).unwrap());
    assert_eq!(made("Torus { Material m }"), made("Torus { Material m Axis 0 7 0 Center 0 0 0 Minor 0.25 }"));
    same("Menger { Material m }", Menger::new(O, 1.0, 3).unwrap());
    let slope = Coefficients { g: 0.5, ..Coefficients::default() };
    same("Quadric { Material m G 0.5 }", Quadric::new(slope).unwrap());
}

#[test]
fn every_number_arrives_where_it_belongs() {
    let axis = DVec3::new(0.0, 0.0, -2.0);
    same(
        "Cylinder { Material m Radius 3 Height 2 Axis 0 0 -2 Base 1 2 3 }",
        Cylinder::upon(DVec3::new(1.0, 2.0, 3.0), axis, 2.0, 3.0).unwrap(),
    );
    same(
        "Cone { Material m TopRadius 3 Radius 0.5 Height 2 Axis 0 0 -2 Base 1 2 3 }",
        Cone::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, 1.0), 0.5, 3.0).unwrap(),
    );
    same(
        "Plane { Material m Sides front Normal 1 2 3 Point 4 5 6 }",
        Plane::new(DVec3::new(4.0, 5.0, 6.0), DVec3::new(1.0, 2.0, 3.0)).unwrap().with_sides(Sides::Front),
    );
    same(
        "Disc { Material m Sides front Normal 1 2 3 Center 4 5 6 Radius 7 }",
        Disc::new(DVec3::new(4.0, 5.0, 6.0), DVec3::new(1.0, 2.0, 3.0), 7.0)
            .unwrap()
            .with_sides(Sides::Front),
    );
    same(
        "Triangle { Material m V2 0 0 1 V1 0 1 0 V0 1 0 0 Sides both }",
        Triangle::new(X, Y, Z).unwrap().with_sides(Sides::Both),
    );
    same(
        "Menger { Material m Depth 5 Edge 2 Center 1 2 3 Translation 0 0 1 }",
        Menger::new(DVec3::new(1.0, 2.0, 4.0), 2.0, 5).unwrap(),
    );
    let (a, b, c, d, e) = (1.0, 2.0, 3.0, 4.0, 5.0);
    let (f, g, h, i, j) = (6.0, 7.0, 8.0, 9.0, 10.0);
    let quadric = Quadric::new(Coefficients { a, b, c, d, e, f, g, h, i, j }).unwrap();
    same("Quadric { Material m A 1 B 2 C 3 D 4 E 5 F 6 G 7 H 8 I 9 J 10 }", quadric);
    let clip = Aabb::new(DVec3::new(-1.0, -2.0, -3.0), DVec3::INFINITY);
    let text = "Quadric { Material m A 1 B 2 C 3 D 4 E 5 F 6 G 7 H 8 I 9 J 10 ClipMin -1 -2 -3";
    same(&format!("{text} }}"), ClippedQuadric { quadric, clip });
    let clip = Aabb::new(clip.min, DVec3::new(1.0, 2.0, 3.0));
    same(&format!("{text} ClipMax 1 2 3 }}"), ClippedQuadric { quadric, clip });
}

#[test]
fn no_instance_where_the_numbers_can_take_the_map_in() {
    for object in [
        "Sphere { Material m Translation 1 2 3 }",
        "Sphere { Material m Scale 2 2 2 Translation 1 2 3 }",
        "Sphere { Material m Center 1 0 0 Scale 1 2 3 }",
        "Ellipsoid { Material m Scale 1 2 3 }",
        "Cylinder { Material m Translation 1 2 3 }",
        "Cone { Material m Translation 1 2 3 Translation 1 0 0 }",
        "Plane { Material m Translation 1 2 3 }",
        "Disc { Material m Translation 1 2 3 }",
        "Triangle { Material m V0 0 0 0 V1 1 0 0 V2 0 1 0 Translation 1 2 3 }",
        "Quadric { Material m A 1 Scale 1 1 1 }",
    ] {
        assert!(!made(object).starts_with("Instance"), "{object}");
    }
    for object in [
        "Sphere { Material m Scale 1 -1 1 }",
        "Cylinder { Material m Scale 2 2 2 }",
        "Quadric { Material m A 1 Translation 1 0 0 }",
        "Plane { Material m Rotation 0 0 1 1 }",
    ] {
        assert!(made(object).starts_with("Instance"), "{object}");
    }
    same("Sphere { Material m Center 1 0 0 Scale 2 2 2 Translation 0 1 0 }", {
        Sphere::new(DVec3::new(2.0, 1.0, 0.0), 2.0).unwrap()
    });
    same("Sphere { Material m Center 1 0 0 Scale 2 3 4 }", {
        Ellipsoid::new(DVec3::new(2.0, 0.0, 0.0), DVec3::new(2.0, 3.0, 4.0)).unwrap()
    });
}

/// Renders a scene as its file says.
fn picture(scene: &Scene) -> Vec<DVec3> {
    let picture = Picture { width: 48, height: 48, samples: 1, seed: 1 };
    render(scene, &Local::default(), picture).image.pixels().to_vec()
}

/// Share of pixels in which two scenes differ by more than `tolerance`.
fn differing(a: &Scene, b: &Scene, tolerance: f64) -> f64 {
    let (a, b) = (picture(a), picture(b));
    assert!(a.iter().any(|p| *p != DVec3::ZERO), "a black picture proves nothing");
    let differ = a.iter().zip(&b).filter(|(a, b)| (**a - **b).abs().max_element() > tolerance).count();
    differ as f64 / a.len() as f64
}

/// Transformed in the file and by hand, a shape gives the same picture.
///
/// Both put the surface within some hundred u of each other. Radiance is smooth in that but for pixels on an outline or
/// on a shadow's edge, where a ray may fall to either side: with centres in general position none of the 2304.
#[test]
fn transformations_are_those_of_instances() {
    let map = DAffine3::from_translation(DVec3::new(0.3, 0.2, -0.4))
        * DAffine3::from_rotation_z(0.5)
        * DAffine3::from_scale(DVec3::new(1.1, 0.7, 1.3));
    let lines = "Scale 1.1 0.7 1.3 Rotation 0 0 2 0.5 Translation 0.3 0.2 -0.4";
    let saddle = Coefficients { a: 1.0, h: -1.0, g: -0.5, ..Coefficients::default() };
    let clip = Aabb::new(DVec3::splat(-1.0), DVec3::ONE);
    let upright = |s: Torus| Instance::new(Box::new(s), DAffine3::from_rotation_x(-FRAC_PI_2)).unwrap();
    let shapes: Vec<(&str, Box<dyn Shape>)> = vec![
        ("Sphere", Box::new(Sphere::new(O, 1.0).unwrap())),
        ("Cylinder", Box::new(Cylinder::new(O, Y, 1.0).unwrap())),
        ("Cone", Box::new(Cone::new(O, Y, 1.0, 0.0).unwrap())),
        ("Ellipsoid", Box::new(Sphere::new(O, 1.0).unwrap())),
        ("Torus", Box::new(upright(Torus::new(1.0, 0.25).unwrap()))),
        ("Plane", Box::new(Plane::new(O, Y).unwrap())),
        ("Disc", Box::new(Disc::new(O, Y, 1.0).unwrap())),
        ("Triangle V0 0 0 0 V1 2 0 0 V2 0 2 0", Box::new(Triangle::new(O, X * 2.0, Y * 2.0).unwrap())),
        (
            "Quadric A 1 H -1 G -0.5 ClipMin -1 -1 -1 ClipMax 1 1 1",
            Box::new(ClippedQuadric { quadric: Quadric::new(saddle).unwrap(), clip }),
        ),
    ];
    for (text, shape) in shapes {
        let (name, rest) = text.split_once(' ').unwrap_or((text, ""));
        let file = right(&format!("{name} {{ Material m {rest} {lines} }}"));
        let mut by_hand = right("Sphere { Material m }").scene;
        by_hand.objects =
            vec![Object::new("by hand", Box::new(Instance::new(shape, map).unwrap()), 0)].into();
        // A rounding of 2⁻⁵³ through some hundred operations, on radiances below 2.
        let tolerance = 1e3 * f64::EPSILON;
        assert_eq!(differing(&file.scene, &by_hand, tolerance), 0.0, "{text}");
    }
}

#[test]
fn planes_shade_and_are_shaded_without_bounds() {
    let file = right(
        "Plane { Material m } Sphere { Material m Center 0 1 0 } Plane { Material m Normal 1 9 1 Point 0 -2 0 }",
    );
    let scene = &file.scene;
    assert!(!scene.objects[0].bounds().is_finite() && scene.objects[2].bounds() == &Aabb::EVERYTHING);
    let far = Ray::new(DVec3::new(1e12, 1.0, 0.0), DVec3::NEG_Y);
    assert_eq!(
        scene.nearest(&far, f64::INFINITY, &mut lightbench::ray::Silent).map(|(i, c)| (i, c.t)),
        Some((0, 1.0))
    );
    // Just behind the sphere as the point light sees it, the floor is dark of that light; the area light alone remains.
    let picture = picture(scene);
    assert!(picture.iter().all(|p| p.is_finite()));
    assert!(picture.iter().any(|p| p.x > 0.0 && p.x < 0.3) && picture.iter().any(|p| p.x > 0.8));
}

/// What a box in front of a shape rejects, the shape rejects too.
#[test]
fn boxes_change_no_picture() {
    let objects =
        "Torus { Material m Rotation 1 0 0 0.7 } Cone { Material m Base 1.5 0 0 } Plane { Material m }
                   Cylinder { Material m Base -2 0 0 Radius 0.5 } Disc { Material m Center 0 1.6 0 }";
    let scene = right(objects).scene;
    let mut met = 0;
    for i in 0..48 * 48 {
        let ray = scene.camera.ray(glam::DVec2::new((i % 48) as f64 + 0.5, (i / 48) as f64 + 0.5), 48, 48);
        let found = scene.nearest(&ray, f64::INFINITY, &mut lightbench::ray::Silent);
        let all = scene.objects.iter().enumerate();
        let plain = all.filter_map(|(i, o)| Some((i, o.shape().nearest(&ray, 0.0, f64::INFINITY)?)));
        let plain = plain.min_by(|a, b| a.1.t.total_cmp(&b.1.t));
        assert_eq!(found, plain);
        met += usize::from(found.is_some());
    }
    assert!(met > 500);
}

/// The text from line 5 on, the place of the mistake, words of its message.
const MISTAKES: &[(&str, (usize, usize), &[&str])] = &[
    ("Plane { Material m Normal 0 0 0 }", (5, 27), &["`Normal` has no direction"]),
    ("Plane { Material m Sides back }", (5, 26), &["no choice `back`", "both or front"]),
    ("Plane { Material m Radius 1 }", (5, 20), &["`Plane` has no parameter `Radius`"]),
    ("Plane { Material m Point 0 0 }", (5, 20), &["2 of its 3 values"]),
    ("Disc { Material m Radius 0 }", (5, 26), &["`Radius` is out of range", "a number > 0"]),
    ("Disc { Material m Centre 0 0 0 }", (5, 19), &["did you mean `Center`"]),
    ("Disc { Material m Normal 0 0 0 }", (5, 26), &["no direction"]),
    ("Triangle { Material m V0 0 0 0 V1 1 0 0 }", (5, 1), &["`Triangle` has no `V2`", "3 numbers"]),
    ("Triangle { Material m V0 0 0 0 V1 1 1 1 V2 2 2 2 }", (5, 1), &["this is no Triangle", "on one line"]),
    ("Cylinder { Material m Height -1 }", (5, 30), &["`Height` is out of range"]),
    ("Cylinder { Material m Axis 0 0 0 }", (5, 28), &["`Axis` has no direction"]),
    ("Cylinder { Material m Base 1e308 0 0 Axis 1 0 0 Height 1e308 }", (5, 1), &["no Cylinder", "finite"]),
    ("Cylinder { Material m TopRadius 1 }", (5, 23), &["no parameter `TopRadius`"]),
    ("Cone { Material m Radius -1 }", (5, 26), &["`Radius` is out of range", "≥ 0"]),
    ("Cone { Material m Radius 0 }", (5, 26), &["both radii", "one of them above 0"]),
    ("Cone { Material m TopRadius 0\nRadius 0 }", (6, 8), &["both radii"]),
    ("Torus { Material m Minor 0 }", (5, 26), &["`Minor` is out of range"]),
    ("Torus { Material m Major 0.25 }", (5, 26), &["no hole", "`Major` above `Minor`", "Minor 0.25"]),
    ("Torus { Material m Major 2 Minor 3 }", (5, 34), &["no hole", "Major 2 and Minor 3"]),
    ("Torus { Material m Axis 0 0 0 }", (5, 25), &["no direction"]),
    ("Ellipsoid { Material m SemiAxes 1 0 1 }", (5, 35), &["`SemiAxes` is out of range", "> 0"]),
    ("Ellipsoid { Material m Radius 1 }", (5, 24), &["no parameter `Radius`"]),
    ("Quadric { Material m }", (5, 1), &["this is no Quadric", "coefficient"]),
    ("Quadric { Material m J 3 }", (5, 1), &["this is no Quadric"]),
    ("Quadric { Material m A 1 K 3 }", (5, 26), &["no parameter `K`"]),
    ("Quadric { Material m A x }", (5, 24), &["not a number"]),
    ("Quadric { Material m A 1 ClipMin 0 0 0 ClipMax 1 0 1 }", (5, 48), &["clip box is empty", "below"]),
    ("Quadric { Material m A 1 ClipMin 0 0 }", (5, 26), &["2 of its 3 values"]),
    ("Menger { Material m Depth 13 }", (5, 27), &["`Depth` is out of range", "a whole number from 0 to 12"]),
    ("Menger { Material m Depth 1.5 }", (5, 27), &["whole number"]),
    ("Menger { Material m Edge 0 }", (5, 26), &["`Edge` is out of range"]),
    ("Menger { Material m Center 1e9 0 0 Edge 1e-8 }", (5, 1), &["this is no Menger", "cells of at least"]),
    ("Sphere { Material m Scale 1 1 0 }", (5, 31), &["other than 0"]),
    ("Torus { Material m Scale 1e-200 1 1 Scale 1e-200 1 1 }", (5, 1), &["this is no Torus", "flat"]),
    ("Cone { Material m Scale 1e200 1 1 Scale 1e200 1 1 }", (5, 1), &["this is no Cone", "finite"]),
];

#[test]
fn every_mistake_is_told_in_its_place() {
    let mut astray = Vec::new();
    for &(text, at, words) in MISTAKES {
        let Err(d) = read(&format!("{STAGE}{text}"), "t.scene") else {
            astray.push(format!("taken for right: {text}"));
            continue;
        };
        let rendered = d.render(Color::Never);
        // A scene whose only object is wrong still has one.
        let places: Vec<_> = d.errors().map(|e| (d.place(e).line, d.place(e).column)).collect();
        if places != [at] || !words.iter().all(|word| rendered.contains(word)) {
            astray.push(format!("{text}: expected one error at {at:?} with {words:?}, found\n{rendered}"));
        }
    }
    assert!(astray.is_empty(), "{}", astray.join("\n"));
}

#[test]
fn the_projects_scenes_of_surfaces_are_right() {
    for (name, objects) in [("a123_all_surfaces", 15), ("p_torus", 2), ("p_shapes", 6), ("e94_menger", 2)] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.scene"));
        let file = read_file(&path).unwrap_or_else(|e| panic!("{}", e.render(Color::Never)));
        assert!(file.remarks.is_empty(), "{}", file.remarks.render(Color::Never));
        let report = lightbench_command::check::check(&path, Color::Never);
        assert!(report.text.contains(&format!("{objects} objects")), "{}", report.text);
        assert_eq!(report.problems, 0);
    }
}

#[test]
fn the_committed_reference_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("SCENE_FORMAT.md");
    let text = format!("# Scene files\n\n{}", reference());
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, &text).expect("SCENE_FORMAT.md can be written");
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == text, "SCENE_FORMAT.md is not what `reference` prints: BLESS=1 rewrites it");
}
