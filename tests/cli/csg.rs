//! Trees of solids from the command: checked and shown, rendered, and every mistake at its place.

use crate::bench::{Bench, Ran};

const BALLS: &str = "Sphere { Center -1 0 0 }\nSphere { Center 1 0 0 }\n";
const SCENE: &str = "Camera { POV 0 0 5 POI 0 0 0 }\nMaterial { Name m }\nPointLight { Position 3 4 5 }\n";

fn check(name: &str, file: &str, text: &str) -> Ran {
    let bench = Bench::new(name);
    bench.write(file, text.as_bytes());
    bench.line(&format!("check {file}"))
}

#[test]
fn a_right_tree_is_shown() {
    let text = format!(
        "{BALLS}Box {{ }}\nUnion {{ LeftType Sphere LeftIndex 0 RightType Sphere RightIndex 1 }}\n\
         Difference {{ LeftType Union LeftIndex 0 RightType Box RightIndex 0 }}\n"
    );
    let ran = check("csg_right", "t.csg", &text).done();
    for line in [
        "t.csg: right",
        "2 operations, 3 solids",
        "  Difference 0",
        "  ├─ Union 0",
        "  │  └─ Sphere 1",
        "  └─ Box 0",
    ] {
        assert!(ran.out.lines().any(|l| l.contains(line)), "`{line}` is not in\n{}", ran.out);
    }
}

#[test]
fn every_problem_of_a_tree_is_told_at_its_place() {
    let union = |left: &str, right: &str| format!("Union {{ LeftType {left} RightType {right} }}\n");
    let sphere = "Sphere LeftIndex 0";
    let cases: [(&str, String, &[&str]); 9] = [
        (
            "missing",
            union(sphere, "Sphere RightIndex 2"),
            &["t.csg:3:", "Sphere 2 does not exist", "from 0 to 1", "found 2", "(missing)"],
        ),
        ("none", union(sphere, "Box RightIndex 0"), &["t.csg:3:", "Box 0 does not exist", "found none"]),
        (
            "unset",
            union(sphere, "Sphere"),
            &["t.csg:3:1: error", "has no `RightIndex`", "an operand is missing"],
        ),
        (
            "circle",
            union(sphere, "Union RightIndex 0"),
            &["t.csg:3:1: error", "Union 0 holds itself", "(holds itself)"],
        ),
        ("type", union(sphere, "Ball RightIndex 0"), &["t.csg:3:", "no choice `Ball`"]),
        (
            "number",
            union(sphere, "Sphere RightIndex x"),
            &["t.csg:3:", "not a number", "expected a whole number ≥ 0, found `x`"],
        ),
        (
            "roots",
            union(sphere, "Sphere RightIndex 1") + &union(sphere, "Sphere RightIndex 1"),
            &["t.csg:4:1: error", "Union 0 and Union 1 are held by none", "expected one whole"],
        ),
        ("camera", "Camera { }\n".to_string(), &["t.csg:3:1: error", "`Camera` is no part of a tree"]),
        (
            "inside",
            "Union { Box { } Box { } }\n".to_string(),
            &["t.csg:3:9: error", "`Box` stands inside of `Union`", "LeftType"],
        ),
    ];
    for (name, text, words) in cases {
        let ran = check(&format!("csg_{name}"), "t.csg", &format!("{BALLS}{text}"));
        assert_eq!(ran.code, Some(2), "{name}");
        for word in words {
            assert!(ran.err.contains(word), "{name}: `{word}` is not in\n{}", ran.err);
        }
    }
    let empty = check("csg_empty", "t.csg", "# nothing\n");
    assert!(empty.code == Some(2) && empty.err.contains("holds no tree"), "{}", empty.err);
}

/// What the errors say and what the outline shows are the same: who holds itself, and what is not used.
#[test]
fn circles_and_their_outline_agree() {
    let union = |left: &str, right: &str| {
        let operand = |side: &str, of: &str| {
            let (name, index) = of.split_once(' ').expect("a type and an index");
            format!("{side}Type {name} {side}Index {index} ")
        };
        format!("Union {{ {}{} }}\n", operand("Left", left), operand("Right", right))
    };
    let own = union("Sphere 0", "Union 0");
    let two = union("Union 1", "Sphere 1") + &union("Sphere 0", "Union 0");
    let held =
        two.clone() + "Difference { LeftType Union LeftIndex 1 RightType Box RightIndex 0 }\nBox { }\n";
    let twice = union("Union 0", "Union 0");
    for (name, text, circles, unused) in [
        ("own", own, &["Union 0"][..], "Sphere 1"),
        ("two", two, &["Union 0"], ""),
        ("held", held, &["Union 1"], ""),
        ("twice", twice, &["Union 0"], "Sphere"),
    ] {
        let ran = check(&format!("csg_circle_{name}"), "t.csg", &format!("{BALLS}{text}"));
        assert_eq!(ran.code, Some(2), "{name}");
        let told: Vec<&str> = ran.err.lines().filter(|l| l.contains(" holds itself: ")).collect();
        assert_eq!(told.len(), circles.len(), "{name}:\n{}", ran.err);
        for circle in circles {
            assert!(
                told.iter().any(|l| l.contains(&format!("error: {circle} holds itself"))),
                "{name}:\n{}",
                ran.err
            );
        }
        for line in ran.err.lines().filter(|l| l.contains("(holds itself)")) {
            assert!(circles.iter().any(|c| line.contains(c)), "{name}: `{line}` is no error:\n{}", ran.err);
        }
        for line in ran.err.lines().filter(|l| l.contains("(not used)")) {
            assert!(!unused.is_empty() && line.contains(unused), "{name}: `{line}` is used:\n{}", ran.err);
        }
    }
}

#[test]
fn an_unused_solid_is_a_warning() {
    let text =
        format!("{BALLS}Box {{ }}\nUnion {{ LeftType Sphere LeftIndex 0 RightType Sphere RightIndex 1 }}\n");
    let ran = check("csg_unused", "t.csg", &text).done();
    assert!(
        ran.out.contains("t.csg:3:1: warning: Box 0 is not used") && ran.out.contains("Box 0 (not used)"),
        "{}",
        ran.out
    );
}

#[test]
fn wrong_csg_blocks_are_told_at_their_place() {
    let cases: [(&str, &str, &[&str]); 9] = [
        ("empty", "CSG { Material m }", &["4:1: error", "the `CSG` is empty", "Source"]),
        (
            "two",
            "CSG { Material m Box { } Sphere { } }",
            &["4:26: error", "several solids", "found 2 of them"],
        ),
        (
            "both",
            "CSG { Material m Source \"t.csg\" Box { } }",
            &["4:33: error", "both a `Source` and solids"],
        ),
        (
            "few",
            "CSG { Material m Union { Box { } } }",
            &["4:18: error", "too few solids", "expected two or more, found 1"],
        ),
        (
            "flat",
            "CSG { Material m Union { Box { } Disc { } } }",
            &["4:34: error", "`Disc` encloses nothing", "expected a solid"],
        ),
        (
            "number",
            "CSG { Material m Union { Box { } Sphere { Radius x } } }",
            &["4:50: error", "`x` is not a number"],
        ),
        (
            "material",
            "CSG { Material m Union { Box { Material oak } Sphere { } } }",
            &["4:41: error", "material `oak` is not declared"],
        ),
        (
            "named",
            "CSG { Material m Union { LeftType Box Box { } Sphere { } } }",
            &["4:26: error", "`LeftType` has no place here"],
        ),
        ("alone", "Union { Box { } Sphere { } }", &["4:1: error", "stands outside of any `CSG`"]),
    ];
    for (name, block, words) in cases {
        let ran = check(&format!("csg_block_{name}"), "t.scene", &format!("{SCENE}{block}\n"));
        assert_eq!(ran.code, Some(2), "{name}: {}", ran.out);
        for word in words {
            assert!(ran.err.contains(word), "{name}: `{word}` is not in\n{}", ran.err);
        }
    }
}

#[test]
fn a_mistake_in_the_named_file_is_told_there_and_nothing_is_written() {
    let bench = Bench::new("csg_named_file");
    bench.write("parts/t.csg", format!("{BALLS}Union {{ LeftType Sphere LeftIndex 0 }}\n").as_bytes());
    bench.write("t.scene", format!("{SCENE}CSG {{ Material m Source \"parts/t.csg\" }}\n").as_bytes());
    let ran = bench.line("render t.scene --width 8 --height 8");
    assert_eq!(ran.code, Some(2));
    for word in
        ["t.scene:4:25: error", "parts/t.csg has 2 errors", "parts/t.csg:3:1: error", "has no `RightType`"]
    {
        assert!(ran.err.contains(word), "`{word}` is not in\n{}", ran.err);
    }
    assert_eq!(bench.files(), ["parts/t.csg", "t.scene"]);
}

#[test]
fn blocks_too_deep_inside_one_another_are_refused() {
    let deep = "Union { Box { } ".repeat(100_000);
    let ran = check("csg_deep", "t.scene", &format!("{SCENE}CSG {{ Material m {deep}"));
    assert!(
        ran.code == Some(2) && ran.err.contains("at most 256 blocks inside one another"),
        "{}",
        &ran.err[..400.min(ran.err.len())]
    );
}

#[test]
fn a_tree_in_a_file_and_the_same_inside_a_scene_make_the_same_picture() {
    let bench = Bench::new("csg_same");
    let text = format!("{BALLS}Difference {{ LeftType Sphere LeftIndex 0 RightType Sphere RightIndex 1 }}\n");
    bench.write("t.csg", text.as_bytes());
    bench.write("a.scene", format!("{SCENE}CSG {{ Material m Source \"t.csg\" }}\n").as_bytes());
    let inside = "CSG { Material m Difference { Sphere { Center -1 0 0 } Sphere { Center 1 0 0 } } }";
    bench.write("b.scene", format!("{SCENE}{inside}\n").as_bytes());
    bench.line("render a.scene b.scene --width 24 --height 24 --format hdr --out out").done();
    // Behind the header, which tells the command.
    let pixels = |name: &str| {
        let bytes = bench.read(name);
        let at = bytes.windows(6).position(|w| w == b"-Y 24 ").expect("the picture's size");
        bytes[at..].to_vec()
    };
    assert!(pixels("out/a.hdr") == pixels("out/b.hdr"));
}

/// A tree that is written draws what the scene drew, and reads as right.
#[test]
fn a_tree_of_a_scene_becomes_a_file() {
    let bench = Bench::new("csg_convert");
    let tree = "Difference { Sphere { Center -1 0 0 } Sphere { Center 1 0 0 Scale 1 2 1 } Box { } }";
    let moved = format!("{SCENE}CSG {{ Material m {tree} Translation 0.25 0 0 }}\n");
    bench.write("a.scene", moved.as_bytes());
    let ran = bench.line("convert a.scene --out .").done();
    assert_eq!(ran.out.lines().count(), 1);
    let checked = bench.line("check a.csg").done();
    assert!(checked.out.contains("2 operations, 3 solids"), "{}", checked.out);
    bench.write("b.scene", format!("{SCENE}CSG {{ Material m Source \"a.csg\" }}\n").as_bytes());
    bench.line("render a.scene b.scene --width 24 --height 24 --format hdr --out out").done();
    let pixels = |name: &str| {
        let bytes = bench.read(name);
        let at = bytes.windows(6).position(|w| w == b"-Y 24 ").expect("the picture's size");
        bytes[at..].to_vec()
    };
    assert!(pixels("out/a.hdr") == pixels("out/b.hdr"));
}

#[test]
fn what_cannot_be_converted_is_told_and_writes_nothing() {
    let bench = Bench::new("csg_convert_wrong");
    let ball = format!("{SCENE}Sphere {{ Material m }}\n");
    bench.write("ball.scene", ball.as_bytes());
    bench.write(
        "t.csg",
        format!("{BALLS}Union {{ LeftType Sphere LeftIndex 0 RightType Sphere RightIndex 1 }}\n").as_bytes(),
    );
    bench.write("named.scene", format!("{SCENE}CSG {{ Material m Source \"t.csg\" }}\n").as_bytes());
    bench.write(
        "right.scene",
        format!("{SCENE}CSG {{ Material m Union {{ Box {{ }} Sphere {{ }} }} }}\n").as_bytes(),
    );
    let before = bench.files();
    for (line, word) in [
        ("convert", "expected scene files"),
        ("convert right.scene ball.scene", "none of them a `CSG`"),
        ("convert right.scene named.scene", "named.scene:4:1: error: `CSG` comes from another file"),
        ("convert right.scene missing.scene", "missing.scene: cannot be read"),
        ("convert right.scene right.scene", "two trees would be written to out/right.csg"),
    ] {
        let ran = bench.line(line);
        assert_eq!(ran.code, Some(2), "{line}");
        assert!(ran.err.contains(word), "`{word}` is not in\n{}", ran.err);
    }
    assert_eq!(bench.files(), before);
    bench.line("convert right.scene --out trees/a.csg").done();
    bench.line("check trees/a.csg").done();
    let two = "CSG { Material m Box { } } CSG { Material m Sphere { } }";
    bench.write("two.scene", format!("{SCENE}{two}\n").as_bytes());
    bench.line("convert two.scene --out b.csg").refused(2, &["two trees would be written to b.csg"]);
    assert_eq!(bench.line("convert two.scene").done().out, "out/two_1.csg\nout/two_2.csg\n");
    bench.line("convert right.scene --out right.scene").refused(1, &["found the file right.scene"]);
}
