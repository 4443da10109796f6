//! `.csg` files: written as read, equal to what stands inside a scene, and no panic on anything.

use glam::DVec3;
use lightbench::ray::Ray;
use lightbench_command::check::check;
use lightbench_kit::scene_file::{Color, SceneFile, csg, read, read_file};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

const FILE: &str = include_str!("../../scenes/d03_csg.csg");
const HEAD: &str = "Camera { }\nMaterial { Name white }\nMaterial { Name red }\nPointLight { }\n";

#[test]
fn what_is_written_reads_back_as_the_same_tree() {
    let file = csg::read(FILE, "a.csg");
    let text = csg::write(&file.tree().expect("a right file")).expect("two operands each");
    let again = csg::read(&text, "b.csg");
    assert!(again.is_right(), "{}", again.remarks.render(Color::Never));
    assert_eq!((again.outline(), again.counts()), (file.outline(), (4, 5)));
    assert_eq!(csg::write(&again.tree().expect("a right file")).as_deref(), Ok(text.as_str()));
}

/// Both ways to count operations: each of its own kind, or all in one list.
#[test]
fn operations_count_by_their_kind_or_all_together() {
    let text = |last: &str| {
        format!(
            "Box {{ }} Sphere {{ }} Torus {{ }}\nUnion {{ LeftType Box LeftIndex 0 RightType Sphere RightIndex 0 }}\n\
             Difference {{ LeftType {last} RightType Torus RightIndex 0 }}\n"
        )
    };
    let [a, b] = ["Union LeftIndex 0", "Operation LeftIndex 0"].map(|last| csg::read(&text(last), "t.csg"));
    assert!(a.is_right() && b.is_right());
    assert_eq!(a.outline(), b.outline());
}

/// A node that is named twice stands twice; doublings of doublings are refused before they fill the memory.
#[test]
fn doublings_are_refused() {
    let doubled = |times: usize| {
        let union = |i: usize| {
            let from = if i == 0 { "Sphere".to_string() } else { "Union".to_string() };
            let n = i.saturating_sub(1);
            format!("Union {{ LeftType {from} LeftIndex {n} RightType {from} RightIndex {n} }}\n")
        };
        "Sphere { }\n".to_string() + &(0..times).map(union).collect::<String>()
    };
    assert!(csg::read(&doubled(10), "t.csg").is_right());
    for times in [20, 100, 400] {
        let file = csg::read(&doubled(times), "t.csg");
        assert!(file.remarks.render(Color::Never).contains("at most 65536 solids"), "{times}");
    }
}

#[test]
fn leaves_have_their_own_materials_and_transformations() {
    let block = "CSG { Material white  Translation 0 0 1\n  Difference { Scale 2 2 2\n    Box { Material red }\n    \
                 Sphere { Radius 0.3 Translation 0.5 0 0 } } }";
    let file =
        read(&format!("{HEAD}{block}"), "t.scene").unwrap_or_else(|d| panic!("{}", d.render(Color::Never)));
    let (object, names) = (&file.scene.objects[0], ["white", "red"]);
    // The box has edges of 2 about (0, 0, 1), its +x face a bowl of radius 0.6.
    let met = |from: DVec3, d: DVec3| {
        let ray = Ray::new(from, d);
        let c = object.shape().nearest(&ray, 0.0, f64::INFINITY).expect("a hit");
        (c.t, names[object.material(c.part)])
    };
    assert_eq!(met(DVec3::new(-5.0, 0.0, 1.0), DVec3::X), (4.0, "red"));
    let (t, name) = met(DVec3::new(5.0, 0.0, 1.0), DVec3::NEG_X);
    assert!((t - 4.6).abs() < 1e-14 && name == "white", "{t} {name}");
}

/// A solid of any kind, with its own material now and then. Its numbers are such that moving and stretching it by powers of
/// two rounds nothing: then both ways to write a tree multiply out to the same bits.
fn solid() -> impl Strategy<Value = String> {
    let kinds = [
        "Sphere { Radius 1.25",
        "Box { Scale 2 1 2",
        "Cylinder { Height 2 Radius 0.5 Axis 1 0 0",
        "Cone { Height 2 Radius 1 TopRadius 0.25",
        "Ellipsoid { SemiAxes 1 0.5 2",
        "Torus { Major 1 Minor 0.5",
        "Julia { Iterations 3",
        "Plane { Normal 0 1 0",
        "Quadric { A 1 E 1 H 1 J -1",
        "Menger { Depth 2 Edge 2",
        "Mesh { Source \"tetra #1.obj\"",
    ];
    let own = prop_oneof![3 => Just(""), 1 => Just(" Material red"), 1 => Just(" Material \"a{b\"")];
    (prop::sample::select(kinds.to_vec()), own, moves())
        .prop_map(|(kind, own, moves)| format!("{kind}{own}{moves} }}"))
}

fn moves() -> impl Strategy<Value = String> {
    let quarter = |n: i32| f64::from(n) / 4.0;
    let moved = (-4..5, -4..5, -4..5)
        .prop_map(move |(x, y, z)| format!(" Translation {} {} {}", quarter(x), quarter(y), quarter(z)));
    let stretched = prop::sample::select(vec![" Scale 2 1 1", " Scale 0.5 0.5 0.5", " Scale 1 -1 1"]);
    let one = prop_oneof![moved, stretched.prop_map(str::to_owned)];
    prop::collection::vec(one, 0..3).prop_map(|moves| moves.concat())
}

/// A solid, an operation of several, or a `CSG` inside the tree.
fn tree() -> impl Strategy<Value = String> {
    solid().prop_recursive(3, 24, 4, |inner| {
        let operations = prop::sample::select(vec!["Union", "Difference", "Intersection"]);
        let own = prop_oneof![3 => Just(""), 1 => Just(" Material red")];
        prop_oneof![
            4 => (operations, prop::collection::vec(inner.clone(), 2..5), own.clone(), moves())
                .prop_map(|(name, inner, own, moves)| format!("{name} {{{own} {}{moves} }}", inner.join(" "))),
            1 => (inner, moves()).prop_map(|(inner, moves)| format!("CSG {{ Material red {inner}{moves} }}")),
        ]
    })
}

/// Every way in which a ray of a bundle meets the first object: where, which part, and what it is made of.
fn met(file: &SceneFile) -> Vec<Option<(f64, u32, String)>> {
    let object = &file.scene.objects[0];
    let rays = (0..81).map(|k| {
        let (x, y) = (f64::from(k % 9) - 4.1, f64::from(k / 9) - 3.9);
        Ray::new(DVec3::new(x, y, 9.0), DVec3::new(-0.11 * x, -0.1 * y, -1.0))
    });
    rays.map(|ray| {
        let c = object.shape().nearest(&ray, 0.0, f64::INFINITY)?;
        Some((c.t, c.part, file.scene.materials[object.material(c.part)].name.clone()))
    })
    .collect()
}

fn read_right(path: &Path) -> SceneFile {
    read_file(path).unwrap_or_else(|e| panic!("{}", e.render(Color::Never)))
}

/// Whatever is converted is read back as right, and rays meet the same.
fn converts(folder: &Path, tree: &str) -> usize {
    let head = format!("{HEAD}Material {{ Name \"a{{b\" }}\n");
    let (scene, file) = (folder.join("a.scene"), folder.join("a.csg"));
    std::fs::write(&scene, format!("{head}CSG {{ Material white {tree} }}\n")).expect("a scene");
    let texts =
        csg::of_scene_file(&scene, folder).unwrap_or_else(|e| panic!("{}\n{tree}", e.render(Color::Never)));
    std::fs::write(&file, &texts[0]).expect("a tree");
    let checked = check(&file, Color::Never);
    assert_eq!(checked.problems, 0, "{}\n{tree}\n{}", checked.text, texts[0]);
    let other = folder.join("b.scene");
    std::fs::write(&other, format!("{head}CSG {{ Material white Source \"a.csg\" }}\n")).expect("a scene");
    let (a, b) = (met(&read_right(&scene)), met(&read_right(&other)));
    assert!(a == b, "{tree}\n{}\n{a:?}\n{b:?}", texts[0]);
    a.iter().flatten().count()
}

/// A fresh folder that holds the corner of a cube as a mesh.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    let tetra = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::fs::write(folder.join("tetra #1.obj"), tetra).expect("a mesh");
    folder
}

#[test]
fn what_is_converted_is_right_and_traces_the_same() {
    let folder = folder("csg_converted");
    let config = ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = prop::test_runner::TestRunner::new_with_rng(
        config,
        prop::test_runner::TestRng::deterministic_rng(prop::test_runner::RngAlgorithm::ChaCha),
    );
    let seen = std::cell::Cell::new(0);
    let done = runner.run(&tree(), |tree| {
        seen.set(seen.get() + converts(&folder, &tree));
        Ok(())
    });
    done.unwrap_or_else(|e| panic!("{e}"));
    assert!(seen.get() > 2000, "only {} rays met anything", seen.get());
    // A list longer than a file is deep.
    let balls: String =
        (0..600).map(|i| format!("Sphere {{ Radius 0.25 Center {} 0 0 }} ", f64::from(i) / 64.0)).collect();
    for operation in ["Union", "Difference", "Intersection"] {
        converts(&folder, &format!("{operation} {{ Box {{ Scale 8 2 2 }} {balls} }}"));
    }
}

/// A tree that no file holds is refused where it stands.
#[test]
fn what_has_no_file_is_refused() {
    let folder = folder("csg_refused");
    let scene = |tree: &str| format!("{HEAD}CSG {{ Material white {tree} }}\n");
    let refused = |tree: &str| {
        let name = folder.join("a.scene").display().to_string();
        csg::of_scene(&scene(tree), &name, &folder).expect_err("no file").render(Color::Never)
    };
    let quoted = folder.join("a\"b");
    std::fs::create_dir_all(&quoted).expect("a folder");
    std::fs::copy(folder.join("tetra #1.obj"), quoted.join("t.obj")).expect("a mesh");
    let name = quoted.join("a.scene").display().to_string();
    let mesh = "Union { Box { } Mesh { Source \"t.obj\" } }";
    let told = csg::of_scene(&scene(mesh), &name, &folder).expect_err("no file").render(Color::Never);
    assert!(told.contains("a.scene:5:52: error: no quotes can stand round this text"), "{told}");
    let leaf = "Union { Box { } Sphere { } }";
    std::fs::write(folder.join("t.csg"), "Box { }").expect("a tree");
    let told = refused(&format!("Union {{ {leaf} CSG {{ Material red Source \"t.csg\" }} }}"));
    assert!(told.contains("comes from another file"), "{told}");
}

#[test]
fn files_are_named_as_the_new_files_folder_sees_them() {
    let folder = folder("csg_renamed");
    let name = folder.join("a.scene").display().to_string();
    let absolute = folder.join("tetra #1.obj").display().to_string();
    for (into, source, expected) in [
        ("", "tetra #1.obj", "tetra #1.obj"),
        ("new", "tetra #1.obj", "../tetra #1.obj"),
        ("new/deeper", "../csg_renamed/tetra #1.obj", "../../tetra #1.obj"),
        ("..", "tetra #1.obj", "csg_renamed/tetra #1.obj"),
        ("new", absolute.as_str(), absolute.as_str()),
    ] {
        let scene =
            format!("{HEAD}CSG {{ Material white Union {{ Box {{ }} Mesh {{ Source \"{source}\" }} }} }}");
        let texts = csg::of_scene(&scene, &name, &folder.join(into))
            .unwrap_or_else(|d| panic!("{}", d.render(Color::Never)));
        assert!(texts[0].contains(&format!("Source \"{expected}\"\n")), "{into}, {source}:\n{}", texts[0]);
    }
}

#[test]
fn no_text_makes_a_reader_panic() {
    let config = ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() };
    let words = [
        "Union",
        "{",
        "}",
        "LeftType",
        "LeftIndex",
        "RightType",
        "RightIndex",
        "Sphere",
        "Operation",
        "0",
        "1",
        "-1",
        "CSG",
        "Material",
        "\n",
        "Box",
    ];
    proptest!(config, |(text in prop::collection::vec(prop::sample::select(words.to_vec()), 0..80), cut in 0..FILE.len())| {
        let text = text.join(" ");
        for text in [text.as_str(), &FILE[..cut], &format!("{FILE}{text}")] {
            let file = csg::read(text, "t.csg");
            let _ = (file.outline(), file.remarks.render(Color::Never), file.tree());
        }
        let _ = read(&format!("{HEAD}CSG {{ Material red {text}"), "t.scene");
    });
}
