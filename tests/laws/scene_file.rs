//! Scene files: defaults, units, every kind of mistake at its place, and no panic on anything.

use glam::DVec3;
use lightbench::light::{AreaLight, Attenuation, Emission, Emitter, Light, PointLight, Rectangle};
use lightbench::ray::Ray;
use lightbench::sample::{Cells, Pattern};
use lightbench::scene::{FieldOfView, Material};
use lightbench_command::check::check;
use lightbench_kit::scene_file::{
    Color, Diagnostics, ReadError, SceneFile, Settings, Severity, read, read_bytes, read_file, reference,
};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

/// A small right scene on four lines; the tests add theirs from line 5 on.
const BASE: &str = "Camera { }\nMaterial { Name m Roughness 0 SpecularColor 0 0 0 }\n\
                    Sphere { Material m }\nPointLight { Position 0 5 5 }\n";
const ROOM: &str = include_str!("../../scenes/d01_boxes_spheres.scene");

fn right(source: &str) -> SceneFile {
    match read(source, "t.scene") {
        Ok(file) => file,
        Err(d) => panic!("{}", d.render(Color::Never)),
    }
}

fn wrong(source: &str) -> Diagnostics {
    match read(source, "t.scene") {
        Ok(_) => panic!("this was to be wrong:\n{source}"),
        Err(d) => d,
    }
}

fn scene_path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name)
}

fn scene(name: &str) -> SceneFile {
    read_file(&scene_path(name)).unwrap_or_else(|e| panic!("{}", e.render(Color::Never)))
}

fn rectangle(light: &AreaLight) -> Rectangle {
    let Emitter::Rectangle(rectangle) = light.emitter else { panic!("a rectangle") };
    rectangle
}

#[test]
fn defaults_are_the_documents() {
    let file = right(
        "SceneSettings{}Camera{}Material{Name m}Sphere{Material m}PointLight{}AreaLight{}Box{Material m}",
    );
    assert_eq!(file.settings, Settings::default());
    let s = file.settings;
    assert_eq!((s.width, s.height, s.samples), (512, 512, 1));
    assert_eq!((s.reflection_quality, s.reflection_steps, s.indirect_quality), (3, 1, 3));
    assert_eq!(s.color_bleeding, 1.0);
    assert_eq!((file.scene.background, file.scene.ambient), (DVec3::ZERO, DVec3::ZERO));
    let camera = &file.scene.camera;
    assert_eq!(camera.position(), DVec3::new(0.0, 1.0, 1.0));
    assert_eq!(camera.field_of_view(), FieldOfView::Vertical(45f64.to_radians()));
    let down = DVec3::new(0.0, -1.0, -1.0).normalize();
    assert!((camera.frame().forward - down).length() < 4.0 * f64::EPSILON); // three roundings each side
    assert_eq!(file.scene.materials[0], Material { name: "m".into(), ..Material::default() });
    let bounds: Vec<_> = file.scene.objects.iter().map(|o| *o.bounds()).collect();
    assert!(bounds[0].contains(DVec3::ONE) && bounds[1].contains(DVec3::splat(0.5)));
    assert!(!bounds[1].contains(DVec3::splat(0.51)));
    let [Light::Point(point), Light::Area(area)] = &file.scene.lights[..] else { panic!("two lights") };
    assert_eq!(*point, PointLight::of_color(DVec3::ZERO, DVec3::ONE));
    assert_eq!(point.attenuation, Attenuation::None);
    assert_eq!(area.emission, Emission::even(DVec3::ONE));
    assert_eq!((area.cells(), area.pattern()), (Cells::grid(5, 5), Pattern::Centres));
    let rectangle = rectangle(area);
    assert_eq!((rectangle.center(), rectangle.normal()), (DVec3::ZERO, DVec3::NEG_Y));
    assert_eq!((rectangle.half_width().length(), rectangle.half_height().length()), (0.5, 0.5));
}

#[test]
fn written_values_arrive_in_their_units() {
    let file = right(
        "SceneSettings { Antialiasing 16 RenderHeight 20 RenderWidth 30 BackgroundColor 1 2 3 AmbientLight 4 5 6
           ReflectionQuality 7 ReflectionSteps 8 IndirectQuality 2 ColorBleeding 0.25 }
         Camera { POV 1 2 3 POI 1 2 -4 Up 1 0 0 FOV 90 }
         Material { Name m DiffuseColor .1 .2 .3 SpecularColor .4 .5 .6 EmissiveColor 7 8 9 Roughness .1 Opacity .5
           RefractionIndex 1.5 ReflectionAngle 90 ReflectionAmount .25 }
         Sphere { Radius 2e0 Center 1 -2 +3 Material m }
         PointLight { Intensity 1 2 3 Position 4 5 6 }
         AreaLight { Radiance 1 2 3 Width 2 Height 4 RollAngle 1.5707963267948966 Direction 0 0 -2 Subdivision 2 3
           Placement jittered }",
    );
    let s = file.settings;
    assert_eq!((s.width, s.height, s.samples, s.color_bleeding), (30, 20, 16, 0.25));
    assert_eq!((s.reflection_quality, s.reflection_steps, s.indirect_quality), (7, 8, 2));
    assert_eq!(file.scene.background, DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(file.scene.ambient, DVec3::new(4.0, 5.0, 6.0));
    assert_eq!(file.scene.camera.frame().up, DVec3::X);
    assert_eq!(file.scene.camera.field_of_view(), FieldOfView::Vertical(90f64.to_radians()));
    let m = &file.scene.materials[0];
    assert_eq!((m.diffuse, m.specular), (DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.4, 0.5, 0.6)));
    assert_eq!((m.emissive, m.roughness, m.opacity, m.ior), (DVec3::new(7.0, 8.0, 9.0), 0.1, 0.5, 1.5));
    assert_eq!((m.reflection_angle, m.reflection_amount), (90f64.to_radians(), 0.25));
    let [Light::Point(point), Light::Area(area)] = &file.scene.lights[..] else { panic!("two lights") };
    let power = DVec3::new(1.0, 2.0, 3.0);
    assert_eq!(*point, PointLight::of_intensity(DVec3::new(4.0, 5.0, 6.0), power));
    assert_eq!(area.emission, Emission::diffuse(power));
    assert_eq!((area.cells(), area.pattern()), (Cells::grid(2, 3), Pattern::Jittered));
    // A quarter turn, in radians: what ran horizontally runs vertically, up to cos(π/2) = 6e-17 and 8 roundings.
    let half_width = rectangle(area).half_width();
    assert!(half_width.x.abs() < 1.0e-15 && (half_width.y.abs() - 1.0).abs() < 1.0e-15);
    assert_eq!(file.rays_per_pixel(), 16 * (1 + 1 + 6));
    assert_eq!(file.scene.objects[0].name, "Sphere (line 6)");
}

#[test]
fn the_documents_first_scene_is_whole() {
    let file = scene("d01_boxes_spheres.scene");
    assert_eq!((file.scene.objects.len(), file.scene.materials.len(), file.scene.lights.len()), (10, 3, 1));
    let Light::Area(light) = &file.scene.lights[0] else { panic!("an area light") };
    assert_eq!((light.cells(), light.emission), (Cells::grid(10, 10), Emission::even(DVec3::ONE)));
    assert_eq!(file.rays_per_pixel(), 101);
    assert_eq!(file.remarks.warnings().count(), 0);
    assert_eq!(file.remarks.notes().count(), 0, "it asks for nothing that has no effect yet");
    // The walls touch: floor top at 0, ceiling at 10, sides at ±5, back at −5.
    let inside = lightbench::bounds::Aabb::new(DVec3::new(-5.0, 0.0, -5.0), DVec3::new(5.0, 10.0, 5.0));
    for object in &file.scene.objects[5..] {
        assert!(format!("{:?}", object.shape()).starts_with("Cuboid"), "{object:?}");
        assert!(object.bounds().overlaps(&inside));
    }
}

#[test]
fn the_rooms_differ_in_their_light_only() {
    let point = scene("d01_point_light.scene");
    let Light::Point(light) = &point.scene.lights[0] else { panic!("a point light") };
    assert_eq!(*light, PointLight::of_color(DVec3::new(3.0, 5.0, 8.0), DVec3::splat(0.9)));
    assert_eq!(point.rays_per_pixel(), 2);
    let radiometric = scene("d01_radiometric.scene");
    let Light::Area(light) = &radiometric.scene.lights[0] else { panic!("an area light") };
    assert_eq!((light.cells(), light.emission), (Cells::grid(10, 10), Emission::diffuse(DVec3::splat(50.0))));
    let rectangle = rectangle(light);
    assert_eq!((rectangle.center(), rectangle.normal()), (DVec3::new(3.0, 5.0, 8.0), DVec3::NEG_Z));
    assert_eq!(light.emitter.area(), 4.0);
    let area = scene("d01_boxes_spheres.scene");
    for other in [&point, &radiometric] {
        assert_eq!(other.settings, area.settings);
        assert_eq!(other.scene.materials, area.scene.materials);
        assert_eq!(other.scene.camera, area.scene.camera);
        let bounds =
            |f: &SceneFile| f.scene.objects.iter().map(|o| (*o.bounds(), o.material(0))).collect::<Vec<_>>();
        assert_eq!(bounds(other), bounds(&area));
    }
}

/// Where a ray from far above meets the box below it.
fn top(lines: &str, x: f64, z: f64) -> Option<f64> {
    let file = right(&format!("{BASE}Box {{ Material m {lines} }}"));
    let ray = Ray::new(DVec3::new(x, 100.0, z), DVec3::NEG_Y);
    let shape = file.scene.objects[1].shape();
    shape.nearest(&ray, 0.0, f64::INFINITY).map(|c| 100.0 - c.t)
}

#[test]
fn transformations_apply_in_written_order() {
    // Scaling comes after moving: it scales the displacement too, and the other way round it does not.
    assert_eq!(top("Scale 1 2 1 Translation 0 3 0", 0.0, 0.0), Some(4.0));
    assert_eq!(top("Translation 0 3 0 Scale 1 2 1", 0.0, 0.0), Some(7.0));
    assert_eq!(top("Translation 0 3 0 Scale 1 -2 1", 0.0, 0.0), Some(-5.0));
    assert_eq!(top("Scale 4 2 2 Scale 2 1 1", 3.9, 0.0), Some(1.0));
    // A quarter turn about y, counter-clockwise seen from above: x goes to −z. Radians.
    let quarter = "Translation 3 0 0 Rotation 0 1 0 1.5707963267948966";
    assert!(top(quarter, 0.0, -3.0).is_some() && top(quarter, 0.0, 3.0).is_none());
    assert_eq!(top(quarter, 3.0, 0.0), None);
    // An eighth of a turn about z raises the edge to 1/√2; 100 bounds the numbers, some 20 roundings.
    let eighth = top("Rotation 0 0 5 0.7853981633974483", 0.0, 0.0).unwrap();
    assert!((eighth - 0.5f64.sqrt()).abs() < 100.0 * 20.0 * f64::EPSILON, "{eighth}");
}

#[test]
fn white_space_comments_and_quotes_are_free() {
    let one_line = "Camera{POV 0 5 15 POI 0 5 0 FOV 45}Material{Name m}Sphere{Material m Center 0 1 0 Radius 1}PointLight{}";
    let spread = "\u{feff}# a comment\r\nCamera # the viewer {\r\n{\r\n  POV 0\r\n 5 15# close\r\nPOI 0 5 0\tFOV 45 }\r\n\
                  Material\r\n{\r\nName\r\n\r\nm\r\n}\r\nSphere { Radius 1 Center 0 1 0 Material \u{201c}m\u{201d} }\r\nPointLight { }";
    let old_mac = one_line.replace('{', "\r{\r# here\r").replace('}', "\r}\r");
    let (a, b, c) = (right(one_line), right(spread), right(&old_mac));
    for other in [&b, &c] {
        assert_eq!(a.scene.camera, other.scene.camera);
        assert_eq!(a.scene.materials, other.scene.materials);
        assert_eq!(a.scene.objects[0].bounds(), other.scene.objects[0].bounds());
    }
    assert!(b.remarks.notes().any(|n| n.message.contains("quotes")), "typographic quotes are told");
    assert_eq!(b.scene.objects[0].name, "Sphere (line 13)");
}

/// A mistake: the text from line 5 on, the place, words of the message or its label or help.
type Mistake = (&'static str, (usize, usize), &'static [&'static str]);

const MISTAKES: &[Mistake] = &[
    // Names.
    ("Spere { Material m }", (5, 1), &["unknown block `Spere`", "did you mean `Sphere`"]),
    ("sphere { Material m }", (5, 1), &["unknown block", "did you mean `Sphere`", "capital"]),
    ("Dodecahedron { Material m Foo { } }", (5, 1), &["unknown block", "SceneSettings, Camera"]),
    (
        "Sphere { Material m\n  Raduis 1.0 }",
        (6, 3),
        &["`Sphere` has no parameter `Raduis`", "did you mean `Radius`"],
    ),
    ("Sphere { Material m Wood oak 3 4 Radius 1 }", (5, 21), &["`Wood`", "Material, Center, Radius"]),
    ("Sphere { Material m Height 1 }", (5, 21), &["no parameter `Height`"]),
    ("Sphere { Materail m }", (5, 10), &["`Materail`", "did you mean `Material`"]),
    // Values.
    (
        "Sphere { Material m Center 1 2 }",
        (5, 21),
        &["2 of its 3 values", "3 numbers", "found `}`", "Center x y z"],
    ),
    ("Sphere { Material m Center\nRadius 1 }", (5, 21), &["`Center` has no value", "found `Radius`"]),
    ("Sphere { Material m Radius 1 2 3 }", (5, 30), &["too many values", "a number > 0", "3 values"]),
    ("Sphere { Material m Radius one }", (5, 28), &["`one` is not a number"]),
    ("Sphere { Material m Radius 1,5 }", (5, 28), &["`1,5` is not a number", "write `1.5`"]),
    ("Sphere { Material m Center 0 \u{2212}1 0 }", (5, 30), &["not a number", "write `-1`"]),
    ("Sphere { Material m Radius NaN }", (5, 28), &["must be finite", "found `NaN`"]),
    ("Sphere { Material m Center 0 -inf 0 }", (5, 30), &["must be finite", "`-inf`"]),
    ("Sphere { Material m Radius 1e999 }", (5, 28), &["too large", "1.797"]),
    ("Sphere { Material m Radius \"1\" }", (5, 28), &["takes numbers, not texts"]),
    ("Sphere { Material m Radius 0 }", (5, 28), &["`Radius` is out of range", "a number > 0", "found `0`"]),
    ("Sphere { Material m Radius 1e-999 }", (5, 28), &["`Radius` is out of range"]),
    ("Sphere { Material m Radius -2 }", (5, 28), &["a number > 0", "found `-2`"]),
    ("Material { Name a DiffuseColor 0.9 1.2 0 }", (5, 36), &["`DiffuseColor`", "in [0, 1]", "found `1.2`"]),
    ("Material { Name a EmissiveColor 0 -1 0 }", (5, 35), &["≥ 0", "`-1`"]),
    ("Material { Name a Opacity 2 }", (5, 27), &["`Opacity`", "[0, 1]"]),
    ("Material { Name a RefractionIndex 0 }", (5, 35), &["> 0"]),
    ("Material { Name a ReflecionAngle 91 }", (5, 34), &["`ReflectionAngle`", "[0, 90]"]),
    ("Material { Name \"a b\" }", (5, 17), &["must not hold spaces"]),
    ("Material { Name \"\" }", (5, 17), &["is empty"]),
    ("Box { Material m Scale 1 0 1 }", (5, 26), &["`Scale` is out of range", "other than 0"]),
    ("Box { Material m Rotation 0 0 0 1 }", (5, 27), &["no direction", "zero vector"]),
    ("Box { Material m Rotation 0 1 0 }", (5, 18), &["3 of its 4 values", "x y z angle"]),
    ("Box { Material m Scale 1e200 1 1 Scale 1e200 1 1 }", (5, 1), &["this is no Box", "finite"]),
    ("PointLight { Color -1 1 1 }", (5, 20), &["`Color` is out of range"]),
    ("PointLight { Color 1 1 1 Intensity 1 1 1 }", (5, 26), &["both `Color` and `Intensity`", "the other"]),
    ("AreaLight { Radiance 1 1 1\nColor 1 1 1 }", (6, 1), &["both `Color` and `Radiance`"]),
    ("AreaLight { Width 0 }", (5, 19), &["`Width`", "> 0"]),
    ("AreaLight { Height -1 }", (5, 20), &["`Height`"]),
    ("AreaLight { Direction 0 0 0 }", (5, 23), &["no direction"]),
    ("AreaLight { Subdivision 0 5 }", (5, 25), &["`Subdivision`", "from 1 to 65536", "found `0`"]),
    ("AreaLight { Subdivision 5.5 5 }", (5, 25), &["`5.5` is not a whole number"]),
    ("AreaLight { Subdivision 1000 1000 }", (5, 25), &["1000000 cells", "at most 65536"]),
    (
        "AreaLight { Placement halton }",
        (5, 23),
        &["no choice `halton`", "grid or jittered or random or sobol or r2"],
    ),
    ("Camera { FOV 180 }", (5, 14), &["`FOV`", "strictly between 0 and 180"]),
    ("Camera { FOV 0 }", (5, 14), &["strictly between 0 and 180"]),
    ("Camera { POV 1 2 3 POI 1 2 3 }", (5, 24), &["same point", "(1, 2, 3)"]),
    ("Camera { POV 0 0 0 }", (5, 14), &["same point"]),
    ("Camera { Up 0 0 0 }", (5, 13), &["`Up` has no direction"]),
    ("SceneSettings { RenderWidth 0 }", (5, 29), &["from 1 to 65535"]),
    ("SceneSettings { RenderWidth 65536 }", (5, 29), &["from 1 to 65535"]),
    ("SceneSettings { RenderWidth 99999999999999999999 }", (5, 29), &["`RenderWidth` is out of range"]),
    ("SceneSettings { RenderHeight 512.0 }", (5, 30), &["`512.0` is not a whole number"]),
    ("SceneSettings { RenderWidth 65535 RenderHeight 1025 }", (5, 48), &["67173375 pixels", "67108864"]),
    ("SceneSettings { Antialiasing x }", (5, 30), &["`x` is not a number", "whole number"]),
    ("SceneSettings { ReflectionQuality -1 }", (5, 35), &["from 0 to 1000"]),
    // Names of materials.
    ("Sphere { Material oak }", (5, 19), &["material `oak` is not declared"]),
    (
        "Material { Name marble }\nSphere { Material marbel }",
        (6, 19),
        &["not declared", "did you mean `marble`"],
    ),
    (
        "Sphere { Material z }\nMaterial { Name z }",
        (5, 19),
        &["before it is declared", "move the declaration up"],
    ),
    ("Material { Name m }", (5, 17), &["material `m` is declared twice", "first declared here"]),
    ("Material { }", (5, 1), &["`Material` has no `Name`"]),
    ("Sphere { }", (5, 1), &["`Sphere` has no `Material`"]),
    ("Material { Name a DiffuseTexture oak }", (5, 34), &["texture `oak` is not declared"]),
    // Structure.
    ("Sphere { Material m Radius 1 Radius 2 }", (5, 30), &["`Radius` is given twice", "first given here"]),
    ("Sphere { Material m", (5, 1), &["`Sphere` is never closed", "end of the file"]),
    ("Sphere {\nMaterial { Name z }", (5, 1), &["`Sphere` is never closed", "next block begins here"]),
    ("Sphere { Material m } }", (5, 23), &["closes nothing"]),
    (
        "Sphere { Material m }\nRadius 1 }",
        (6, 1),
        &["`Radius` stands outside of any block", "parameter of `"],
    ),
    ("{ Material m }", (5, 1), &["belongs to no block"]),
    ("Sphere Material m }", (5, 1), &["does not begin", "`{` after it", "found `Material`"]),
    ("Sphere { 3 Material m }", (5, 10), &["`3` belongs to no parameter"]),
    ("Sphere { \"a\" Material m }", (5, 10), &["the text `a` belongs to no parameter"]),
    ("Sphere { Material m { Radius 1 } }", (5, 21), &["`{` belongs to no parameter"]),
    ("CSG { Material m Source tree.csg }", (5, 25), &["needs quotes"]),
    ("CSG { Material m Source \"tree.csg }", (5, 25), &["quote is never closed"]),
    ("hello world 1 2 3", (5, 1), &["`hello` stands outside of any block"]),
    ("\u{1}\u{0}", (5, 1), &["control character U+0001", "byte", "first of 2"]),
    // Blocks to come.
    ("Mesh { Material m Source \"no_such.obj\" Scale 2 2 2 }", (5, 26), &["no_such.obj", "cannot be read"]),
    ("Mesh { Material m }", (5, 1), &["`Mesh` has no `Source`"]),
    ("Mesh { Material m Source \"a.obj\" Normals round }", (5, 42), &["`Normals` has no choice `round`"]),
    ("CSG { Material m Source \"tree.csg\" }", (5, 25), &["tree.csg: cannot be read"]),
    (
        "Texture { Name t Source \"a#b.png\" }\nMaterial { Name a DiffuseTexture t }",
        (5, 1),
        &["`Texture` is not supported"],
    ),
];

#[test]
fn every_mistake_is_told_once_and_in_its_place() {
    for &(text, (line, column), words) in MISTAKES {
        let d = wrong(&format!("{BASE}{text}"));
        let rendered = d.render(Color::Never);
        let planned =
            |m: &str| m.contains("not supported yet") && !words.iter().any(|w| w.contains("not supp"));
        let errors: Vec<_> = d.errors().filter(|e| !planned(&e.message)).collect();
        let place = d.place(errors[0]);
        assert_eq!((place.line, place.column), (line, column), "{text}\n{rendered}");
        assert_eq!(errors.len(), 1, "one mistake, one message: {text}\n{rendered}");
        for word in words {
            assert!(rendered.contains(word), "{text}: no {word:?} in\n{rendered}");
        }
        let heading = format!("t.scene:{line}:{column}: error: ");
        assert!(rendered.lines().any(|l| l.starts_with(&heading)), "no {heading:?} in\n{rendered}");
    }
}

#[test]
fn all_problems_of_a_file_are_told_together_in_order() {
    let d = wrong(
        "Camera { FOV 200 }\nMaterial { Name a Roughness x }\nSphere { Material b Radius -1 }\n\
         Box { Material a Scale 0 1 1 Spin 3 }\nLamp { }\nPointLight { Position 1 2 }\n",
    );
    let places: Vec<_> = d.errors().map(|e| (d.place(e).line, d.place(e).column)).collect();
    assert_eq!(places, [(1, 14), (2, 29), (3, 19), (3, 28), (4, 24), (4, 30), (5, 1), (6, 14)]);
}

#[test]
fn what_a_scene_cannot_do_without() {
    let messages = |s: &str| wrong(s).errors().map(|e| e.message.clone()).collect::<Vec<_>>();
    for empty in ["", " \n\n", "# only words\n", "\u{feff}"] {
        assert_eq!(messages(empty), ["this file holds no scene"]);
    }
    assert_eq!(messages("Camera { }"), ["the scene has no object"]);
    assert_eq!(messages("Material { Name m } Sphere { Material m }"), ["the scene has no camera"]);
    assert_eq!(messages("SceneSettings { }"), ["the scene has no camera", "the scene has no object"]);
    // A mistake elsewhere does not make them missing.
    assert_eq!(messages("Camera { FOV 0 } Sphere { Materail m }").len(), 2);
}

fn remarks(source: &str, severity: Severity) -> Vec<(usize, usize, String)> {
    let file = right(source);
    let d = &file.remarks;
    d.of(severity).map(|r| (d.place(r).line, d.place(r).column, r.message.clone())).collect()
}

#[test]
fn warnings() {
    let warned = |s: &str| remarks(s, Severity::Warning);
    assert_eq!(warned(BASE), []);
    let w = warned(&format!("{BASE}\nCamera {{ POV 7 7 7 }}"));
    assert_eq!((w.len(), w[0].0, w[0].1), (1, 1, 1));
    assert!(w[0].2.contains("line 1") && w[0].2.contains("line 6"), "{}", w[0].2);
    assert_eq!(right(&format!("{BASE}\nCamera {{ POV 7 7 7 }}")).scene.camera.position(), DVec3::splat(7.0));
    let two = format!("{BASE}SceneSettings {{ RenderWidth 5 }}\nSceneSettings {{ RenderHeight 6 }}");
    assert_eq!((warned(&two).len(), warned(&two)[0].0), (1, 5));
    assert_eq!(
        (right(&two).settings.width, right(&two).settings.height),
        (512, 6),
        "the last block alone counts"
    );
    for n in ["2", "0", "-4", "17"] {
        let source = format!("{BASE}SceneSettings {{ Antialiasing {n} }}");
        let w = warned(&source);
        assert_eq!((w.len(), w[0].0, w[0].1), (1, 5, 30));
        assert_eq!(right(&source).settings.samples, 1);
    }
    let dark = "Camera { } Material { Name m } Sphere { Material m }";
    assert!(warned(dark)[0].2.contains("nothing is lit"));
    assert_eq!(warned(&dark.replace("Name m", "Name m EmissiveColor 0 1 0")), []);
    assert_eq!(warned(&format!("{dark} SceneSettings {{ AmbientLight 1 1 1 }}")), []);
}

#[test]
fn one_note_names_all_that_has_no_effect_yet() {
    let noted = |s: &str| remarks(s, Severity::Note);
    let quiet = format!("{BASE}SceneSettings {{ IndirectQuality 2 ColorBleeding 9 }}");
    assert_eq!(noted(&quiet), [], "nothing asks for anything");
    assert_eq!(noted(BASE), [], "a default asks for nothing");
    let asks =
        format!("{quiet}Material {{ Name glass Opacity 0.5 RefractionIndex 1.5 SpecularColor 1 1 1 }}");
    let n = noted(&asks);
    assert_eq!((n.len(), n[0].0, n[0].1), (1, 5, 74));
    assert_eq!(n[0].2, "read, but without effect yet: Opacity (glass); RefractionIndex (glass)");
    for (settings, told) in [
        ("IndirectQuality 3", Some("IndirectQuality 3")),
        ("ColorBleeding 2", Some("ColorBleeding 2")),
        ("IndirectQuality 4 ColorBleeding 2", Some("IndirectQuality 4; ColorBleeding 2")),
        ("RenderWidth 9", None),
    ] {
        let n = noted(&format!("{BASE}SceneSettings {{ {settings} }}"));
        let told = told.map(|told| format!("read, but without effect yet: {told}"));
        assert_eq!(n.first().map(|n| n.2.clone()), told, "{settings}");
    }
    let mirror = asks.replace("Opacity 0.5", "ReflectionAmount 1 ReflecionAngle 5");
    let n = noted(&mirror);
    assert_eq!(n.len(), 2, "the misprint, and the note");
    assert!(
        n[0].2.contains("`ReflecionAngle` is read as `ReflectionAngle`") || n[1].2.contains("ReflecionAngle")
    );
    assert!(n.iter().any(|n| n.2.contains("ReflectionAmount (glass); ReflectionAngle (glass)")));
}

#[test]
fn bytes_that_are_no_text_are_told_by_position() {
    let place = |bytes: &[u8]| {
        let d = read_bytes(bytes, "t.scene").expect_err("no text");
        assert_eq!(d.list.len(), 1);
        (d.place(&d.list[0]).line, d.place(&d.list[0]).column, d.render(Color::Never))
    };
    let (line, column, text) = place(b"# caf\xe9\nCamera { }");
    assert_eq!((line, column), (1, 6));
    assert!(text.starts_with("t.scene:1:6: error: byte 5 is not UTF-8 text\n"), "{text}");
    assert!(text.contains("0xE9"), "{text}");
    assert!(place(b"\xff\xfeC\0a\0").2.contains("UTF-16"));
    assert_eq!(place(b"Camera { }\n\xc3").0, 2);
    let d = wrong("Camera { }\0\0\0");
    assert!(d.errors().any(|e| e.message.contains("U+0000 at byte 10")));
}

#[test]
fn long_lines_and_control_characters_do_not_spoil_the_message() {
    let filler = "Sphere { Material m } ".repeat(400);
    let line = format!("{BASE}{filler}Sphere {{ Material m Radius -1 }} {filler}");
    let text = wrong(&line).render(Color::Never);
    let column = filler.len() + 28;
    assert!(text.starts_with(&format!("t.scene:5:{column}: error: ")), "{text}");
    assert!(text.contains(&format!("[ t.scene:5:{column} ]")), "{text}");
    assert!(text.lines().all(|l| l.chars().count() < 250), "{text}");
    assert!(text.contains("Radius -1"), "{text}");
    let sly = format!("{BASE}\u{1b}[31mSphere\u{202e} {{ }}");
    let d = read(&sly, "a\u{1b}b.scene").expect_err("no such block");
    let text = d.render(Color::Never);
    assert!(!text.contains(['\u{1b}', '\u{202e}']), "{text}");
    assert!(d.render(Color::Always).contains('\u{1b}'), "colours when they are wanted");
}

#[test]
fn garbage_ends_in_few_messages() {
    for garbage in
        ["{".repeat(100_000), "}".repeat(100_000), "Sphere { ".repeat(2_000), "x 1 ".repeat(100_000)]
    {
        let d = wrong(&garbage);
        assert!(!d.is_empty() && d.render(Color::Never).len() < 200_000);
    }
}

#[test]
fn files_that_cannot_be_read() {
    let missing = read_file(&scene_path("no_such.scene")).expect_err("no such file");
    assert!(matches!(missing, ReadError::Unreadable { .. }) && missing.problems() == 1);
    assert!(missing.render(Color::Never).contains("no_such.scene: cannot be read"));
    assert!(read_file(&scene_path("")).is_err(), "a folder is no file");
}

#[test]
fn check_sums_up_a_right_file() {
    let report = check(&scene_path("d01_boxes_spheres.scene"), Color::Never);
    assert_eq!(report.problems, 0);
    for words in ["10 objects", "3 materials", "1 light", "512 × 512 pixels", "1 sample each", "101 rays"] {
        assert!(report.text.contains(words), "no {words} in {}", report.text);
    }
    let report = check(&scene_path("no_such.scene"), Color::Never);
    assert_eq!(report.problems, 1);
}

#[test]
fn the_reference_names_every_block_and_parameter() {
    let text = reference();
    for words in
        ["### `SceneSettings`", "### `Mesh`", "`ReflectionAmount`", "`AmbientLight` †", "| rad |", "512"]
    {
        assert!(text.contains(words), "no {words} in\n{text}");
    }
    // Every row has its five cells.
    assert!(text.lines().filter(|l| l.starts_with("| `")).all(|l| l.matches(" | ").count() == 4), "{text}");
}

/// A character or word that hurts.
fn token() -> impl Strategy<Value = String> {
    const WORDS: &[&str] = &[
        "{",
        "}",
        "\"",
        "#",
        "\n",
        "\r",
        "\0",
        "\u{feff}",
        "\u{201c}",
        "é",
        "\u{202e}",
        "Sphere",
        "Material",
        "Camera {",
        "Radius",
        "Name",
        "NaN",
        "-1",
        "0",
        "1e999",
        "99999999999999999999",
        "Mesh { Source",
        "ReflecionAngle",
        "\t",
    ];
    prop_oneof![prop::sample::select(WORDS).prop_map(str::to_owned), "\\PC{1,4}"]
}

#[derive(Clone, Debug)]
enum Mutation {
    Truncate(prop::sample::Index),
    Insert(prop::sample::Index, String),
    Swap(prop::sample::Index, prop::sample::Index),
    Delete(prop::sample::Index, usize),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<prop::sample::Index>;
    prop_oneof![
        1 => at().prop_map(Mutation::Truncate),
        4 => (at(), token()).prop_map(|(i, t)| Mutation::Insert(i, t)),
        2 => (at(), at()).prop_map(|(i, j)| Mutation::Swap(i, j)),
        2 => (at(), 1..40usize).prop_map(|(i, n)| Mutation::Delete(i, n)),
    ]
}

fn mutated(source: &str, mutations: &[Mutation]) -> String {
    let mut text: Vec<char> = source.chars().collect();
    for mutation in mutations {
        let length = text.len().max(1);
        match mutation {
            Mutation::Truncate(i) => text.truncate(i.index(length)),
            Mutation::Insert(i, token) => {
                let i = i.index(length).min(text.len());
                text.splice(i..i, token.chars());
            }
            Mutation::Swap(i, j) if !text.is_empty() => text.swap(i.index(length), j.index(length)),
            Mutation::Swap(..) => {}
            Mutation::Delete(i, n) => {
                let i = i.index(length).min(text.len());
                text.drain(i..(i + n).min(text.len()));
            }
        }
    }
    text.into_iter().collect()
}

fn holds(source: &str) -> Result<(), TestCaseError> {
    let remarks = match read(source, "t.scene") {
        Ok(file) => file.remarks,
        Err(d) => {
            prop_assert!(d.errors().next().is_some(), "no scene, and no reason");
            d
        }
    };
    for d in &remarks.list {
        let related = d.related.iter().map(|(span, _)| span);
        for span in std::iter::once(&d.span).chain(related) {
            prop_assert!(source.get(span.clone()).is_some(), "{d:?} is outside of {} bytes", source.len());
        }
        let place = remarks.place(d);
        prop_assert!(place.line <= 1 + source.matches(['\n', '\r']).count());
    }
    let mut text = remarks.render(Color::Never);
    text.retain(|c| c != '\n');
    prop_assert!(!text.contains(|c: char| c.is_control() && c != '\t'));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_change_of_a_file_panics(mutations in prop::collection::vec(mutation(), 1..5)) {
        holds(&mutated(ROOM, &mutations))?;
    }

    #[test]
    fn no_change_of_a_small_file_panics(mutations in prop::collection::vec(mutation(), 1..6)) {
        holds(&mutated(BASE, &mutations))?;
    }

    #[test]
    fn no_text_panics(words in prop::collection::vec(token(), 0..40)) {
        holds(&words.join(" "))?;
    }

    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Err(d) = read_bytes(&bytes, "t.scene") {
            prop_assert!(d.list.iter().all(|e| d.source.get(e.span.clone()).is_some()));
            prop_assert!(!d.render(Color::Never).is_empty());
        }
    }
}
