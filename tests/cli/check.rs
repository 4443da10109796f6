//! `check`: right and wrong scene files.

use crate::bench::{Bench, root};

#[test]
fn right_files_on_stdout_wrong_ones_on_stderr() {
    let bench = Bench::with_scene("check");
    bench.write("wrong.scene", b"Camera { POV 0 0 5 }\nSphere { Radius x }\nSphare { }\n");
    let right = bench.line("check s.scene").done();
    assert!(right.out.contains("s.scene: right") && right.out.contains("1 object"), "{}", right.out);
    assert_eq!(right.err, "");
    let both = bench.line("check wrong.scene s.scene missing.scene");
    assert_eq!(both.code, Some(2));
    assert!(both.out.contains("s.scene: right") && !both.out.contains("wrong"));
    for word in
        ["wrong.scene:2:17: error", "wrong.scene:3:1: error", "Sphere", "missing.scene: cannot be read"]
    {
        assert!(both.err.contains(word), "`{word}` is not in\n{}", both.err);
    }
    let quiet = bench.line("check wrong.scene s.scene --quiet");
    assert!(quiet.code == Some(2) && quiet.out.is_empty() && quiet.err.contains("wrong.scene:2:17: error"));
    assert_eq!(bench.files(), ["s.scene", "wrong.scene"], "checking writes nothing");
}

/// The scene that the reference begins with can be pasted into a file as it is.
#[test]
fn the_references_first_scene_renders_as_pasted() {
    let path = root().join("SCENE_FORMAT.md");
    let text = std::fs::read_to_string(path).expect("SCENE_FORMAT.md");
    let block = text.split("```").nth(1).expect("a block of code");
    let scene = block.split_once('\n').expect("the scene begins on the next line").1;
    let bench = Bench::new("check_first_scene");
    assert!(bench.line("check --list").done().out.contains(scene), "`check --list` shows it too");
    bench.write("first.scene", scene.as_bytes());
    let ran = bench.line("render first.scene --quality smoke").done();
    assert_eq!(ran.out, "out/first.png\n");
    assert_eq!(ran.err.lines().count(), 1, "one line about the work, no notes:\n{}", ran.err);
    bench.line("render first.scene --quality smoke --integrator visibility --name seen").done();
    assert_ne!(bench.read("out/first.png"), bench.read("out/seen.png"), "it is lit");
}

#[test]
fn the_projects_own_scenes_are_right() {
    let folder = root().join("scenes");
    let bench = Bench::new("check_own");
    let mut all = 0;
    for entry in std::fs::read_dir(folder).expect("scenes").flatten() {
        let path = entry.path().display().to_string();
        if path.ends_with(".scene") {
            let ran = bench.run(&["check", &path]).done();
            for word in ["note", "warning"] {
                assert!(!ran.out.contains(word), "{path} asks for what has no effect:\n{}", ran.out);
            }
            assert_eq!(bench.run(&["check", "--quiet", &path]).done().out, "");
            all += 1;
        }
    }
    assert!(all > 0);
}

#[test]
fn a_wrong_mesh_is_told_where_it_stands() {
    let bench = Bench::new("check_mesh");
    bench.write("bad.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    let scene = b"Camera { POV 0 0 5 }\nMaterial { Name m }\nMesh { Material m Source \"bad.obj\" }\nPointLight { }\n";
    bench.write("s.scene", scene);
    for command in ["check s.scene", "render s.scene"] {
        let told = bench.line(command);
        assert_eq!(told.code, Some(2), "{command}");
        for word in ["bad.obj:4:7: error", "expected 1 to 3", "s.scene:3:26: error"] {
            assert!(told.err.contains(word), "`{word}` is not in\n{}", told.err);
        }
    }
    assert_eq!(bench.files(), ["bad.obj", "s.scene"], "nothing is written");
}
