//! `.csg` files: written as read, equal to what stands inside a scene, and no panic on anything.

use glam::DVec3;
use lightbench::ray::Ray;
use lightbench_kit::scene_file::{Color, csg, read};
use proptest::prelude::*;

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
