//! OBJ and MTL files: what is read, and what is told about what cannot be.

use glam::{DVec3, dvec3};
use lightbench::mesh::{Mesh, NONE, Polygons, Topology, tessellate};
use lightbench::shape::Shape;
use lightbench_kit::scene_file::obj::{Library, ObjFile, read, write};
use lightbench_kit::scene_file::{Color, Severity};
use proptest::prelude::*;
use proptest::test_runner::Config;

fn no_library(_: &str) -> Library {
    None
}

fn right(text: &str) -> ObjFile {
    let file = read(text, "t.obj", &no_library);
    assert_eq!(file.errors(), 0, "{}", file.remarks.render(Color::Never));
    file
}

/// Three points, a texture coordinate and a normal in lines 1 to 5; the line under test is the sixth.
const HEAD: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";

/// Lines, the column of the error, and words of the message: what was expected, what was found.
const HOSTILE: &[(&str, usize, &[&str])] = &[
    ("v 1 2", 1, &["wrong number of values", "3 coordinates", "found 2"]),
    ("v", 1, &["wrong number of values", "found 0"]),
    ("v 1 2 3 4 5", 1, &["wrong number", "found 5"]),
    ("v 1 2 3 4 5 6 7 8", 17, &["wrong number", "found 8"]),
    ("v 1 two 3", 5, &["`two` is not a number", "expected a finite number"]),
    ("v 1 2 nan", 7, &["`nan` is not finite"]),
    ("v 1 -inf 3", 5, &["`-inf` is not finite"]),
    ("v 1e999 0 0", 3, &["`1e999` is not finite"]),
    ("v 1,5 0 0", 3, &["`1,5` is not a number"]),
    ("v 1 2 3 0", 9, &["weight", "other than 0"]),
    ("v 1e300 2 3 1e-300", 1, &["infinitely far"]),
    ("vt", 1, &["wrong number of values", "2 coordinates"]),
    ("vt 1 2 3 4", 10, &["found 4"]),
    ("vt a b", 4, &["`a` is not a number"]),
    ("vn 1 2", 1, &["3 coordinates", "found 2"]),
    ("vn 1 2 x", 8, &["`x` is not a number"]),
    ("f", 1, &["too few corners", "found 0"]),
    ("f 1 2", 1, &["too few corners", "at least 3", "found 2"]),
    ("f 1 2 4", 7, &["no point 4", "expected 1 to 3", "found `4`"]),
    ("f 0 1 2", 3, &["no point 0", "1 to 3"]),
    ("f 1 2 -4", 7, &["no point -4", "-1 to -3"]),
    ("f 1 2 -9223372036854775808", 7, &["no point -9223372036854775808"]),
    ("f 1 2 9223372036854775807", 7, &["no point 9223372036854775807"]),
    ("f 1 2 99999999999999999999", 7, &["is not the index of a point", "a whole number"]),
    ("f 1 2 3.0", 7, &["`3.0` is not the index of a point"]),
    ("f 1/1 2/1 3/2", 13, &["no texture coordinate 2", "1 to 1"]),
    ("f 1//1 2//1 3//-2", 16, &["no normal -2", "-1 to -1"]),
    ("f 1/1 2 3", 7, &["corners of a face are not alike", "as in `1/1`", "found `2`"]),
    ("f 1/1/1/1 2 3", 3, &["too many parts", "v/vt/vn"]),
    ("f /1 2 3", 3, &["names no point"]),
    ("f 1 2 3 # and\nf 1 2 x", 7, &["`x` is not the index"]),
    ("f 1 2 \\\n 5", 2, &["no point 5"]),
    ("usemtl", 1, &["names no material"]),
    ("mtllib", 1, &["names no file"]),
    ("f a\u{301}\u{1F600} 2 3", 3, &["is not the index"]),
    ("f 1 2 3\u{0}", 7, &["is not the index"]),
];

/// 3ds Max and Assimp call materials `Material #25`, and some exporters begin a name with `#`.
#[test]
fn a_name_may_hold_and_begin_with_a_number_sign() {
    let library =
        "newmtl Material #1\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0 # green\nnewmtl #3\nKd 0 0 1\n";
    let find = |name: &str| (name == "a #1.mtl").then(|| Ok((name.to_string(), library.to_string())));
    let faces = "usemtl Material #1\nf 1 2 3\nusemtl Material #25\nf 1 2 3 # a comment\nusemtl #3\nf 1 2 3\n";
    let file = read(&format!("mtllib a #1.mtl\n{HEAD}{faces}"), "t.obj", &find);
    assert!(file.remarks.is_empty(), "{}", file.remarks.render(Color::Never));
    let names: Vec<&str> = file.materials.iter().map(|m| &m.name[..]).collect();
    assert_eq!(names, ["Material #1", "Material #25", "#3"]);
    assert_eq!(file.polygons.parts, [1, 2, 3]);
}

#[test]
fn seven_numbers_of_a_point_are_noted() {
    let file = right("v 0 0 0 2 1 0 0\nv 2 0 0 2 1 0 0\nv 0 2 0 2 1 0 0\nf 1 2 3\n");
    let text = file.remarks.render(Color::Never);
    assert_eq!(text.matches("read as x y z w r g b").count(), 1, "{text}");
    assert_eq!(file.polygons.points[1], dvec3(1.0, 0.0, 0.0));
}

/// A byte outside UTF-8 in a comment concerns nobody; in a name it is kept, with a note.
#[test]
fn latin_1_is_read() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("latin_1");
    std::fs::create_dir_all(&folder).expect("a folder");
    let read = |name: &str, head: &[u8]| {
        let path = folder.join(name);
        let text = [head, b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"].concat();
        std::fs::write(&path, text).expect("a file");
        lightbench_kit::scene_file::obj::read_file(&path)
    };
    let comment = read("comment.obj", b"# Gr\xf6\xdfe 1\n").expect("a mesh");
    assert!(comment.remarks.is_empty() && comment.polygons.len() == 1);
    let named = read("name.obj", b"# \xf6\no Gr\xf6\xdfe\n").expect("a mesh");
    let text = named.remarks.render(Color::Never);
    assert!(text.contains("2:3") && text.contains("Latin-1") && named.errors() == 0, "{text}");
    let number = read("number.obj", b"v \xf6 0 0\n").expect("remarks");
    assert_eq!(number.errors(), 1);
    assert!(read("utf16.obj", b"\xff\xfev\0").is_err());
}

#[test]
fn wrong_lines_are_told_with_line_and_column() {
    for (lines, column, words) in HOSTILE {
        let file = read(&format!("{HEAD}{lines}\nf 1 2 3\n"), "t.obj", &no_library);
        let shown = file.remarks.render(Color::Never);
        let error = file.remarks.errors().next().unwrap_or_else(|| panic!("{lines:?} passes: {shown}"));
        assert_eq!(file.remarks.errors().count(), 1, "{lines:?}: {shown}");
        let place = file.remarks.place(error);
        let line = 6 + lines.matches('\n').count();
        assert_eq!((place.line, place.column), (line, *column), "{lines:?}: {shown}");
        assert!(shown.contains(&format!("t.obj:{line}:{column}")), "{lines:?}: {shown}");
        words.iter().for_each(|w| assert!(shown.contains(w), "{lines:?}: `{w}` is not in {shown}"));
        assert!(file.polygons.is_empty(), "nothing of a wrong file is used");
    }
}

#[test]
fn files_without_faces_are_wrong() {
    for text in ["", "\n\n", "# nothing\n", "v 0 0 0\n", "\u{feff}", "garbage\n", "l 1 2\n"] {
        let file = read(text, "t.obj", &no_library);
        assert!(file.remarks.errors().any(|d| d.message.contains("no face")), "{text:?}");
    }
}

#[test]
fn what_cannot_be_used_is_remarked_upon_once() {
    let text = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\ns 1\ns 2\nl 1 2\nl 2 3\np 1\nfoo\nfoo\nmtllib none here.mtl\nusemtl a b\nusemtl a b\nf 1 2 3\n";
    let file = right(text);
    let count = |s| file.remarks.of(s).count();
    assert_eq!(
        (count(Severity::Warning), count(Severity::Note)),
        (4, 4),
        "{}",
        file.remarks.render(Color::Never)
    );
    assert!(file.needs_material());
    assert_eq!(file.polygons.len(), 1, "lines of three points are no triangles");
    assert_eq!(right("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\nf 1 2 3\n").polygons.len(), 1);
}

#[test]
fn every_way_to_write_a_face_means_the_same() {
    let plain = right(&format!("{HEAD}f 1/1/1 2/1/1 3/1/1\n")).polygons;
    for text in [
        "f -3/-1/-1 -2/-1/-1 -1/-1/-1\n",
        "f 1/1/1 2/1/1 \\\n3/1/1",
        "  f\t1/1/1   2/1/1 3/1/1 # comment\r\n",
        "g a b\no c\nf 1/1/1 2/1/1 3/1/1\n",
        "fo 1/1/1 2/1/1 3/1/1\n",
    ] {
        assert_eq!(right(&format!("{HEAD}{text}")).polygons, plain, "{text:?}");
    }
    assert_eq!(right(&format!("f 1/1/1 2/1/1 3/1/1\n{HEAD}")).polygons, plain, "points below their face");
    assert_eq!(right(&format!("{HEAD}f 1/1/1 2/1/1 3/1/1\n").replace('\n', "\r")).polygons, plain);
}

/// tobj repeats the last index where there is none; here there is none.
#[test]
fn missing_texture_coordinates_and_normals_stay_missing() {
    let mesh =
        right(&format!("{HEAD}f 1/1/1 2/1/1 3/1/1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\n")).polygons;
    let has = |f: usize| {
        let c = mesh.corner(mesh.range(f).start);
        (c.uv != NONE, c.normal != NONE)
    };
    assert_eq!([0, 1, 2, 3].map(has), [(true, true), (false, false), (true, false), (false, true)]);
    let filled = mesh.with_smooth_normals(0.5);
    assert!((0..filled.corner_count()).all(|c| filled.normals.get(c) == Some(DVec3::Z)));
    let zero = right("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n").polygons;
    assert_eq!(zero.corner(0).normal, NONE);
}

const LIBRARY: &str = "newmtl red one\nKd 0.8 0.1 0.1\nNs 14\nTr 0.25\nKs 0.5\nmap_Kd wood.png\nnewmtl grey\nKd 0.5\nNi 1.5\nd -halo 0.5\n";

fn library(name: &str) -> Library {
    (name == "colours and more.mtl").then(|| Ok((name.to_string(), LIBRARY.to_string())))
}

#[test]
fn materials_reach_the_faces() {
    let text = format!(
        "mtllib colours and more.mtl\n{HEAD}f 1 2 3\nusemtl red one\nf 1 2 3\nusemtl grey\nf 1 2 3\nusemtl blue\nf 1 2 3\n"
    );
    let file = read(&text, "t.obj", &library);
    assert_eq!(file.errors(), 0, "{}", file.remarks.render(Color::Never));
    assert_eq!(file.polygons.parts, [0, 1, 2, 0]);
    let [red, grey] = &file.materials[..] else { panic!("{:?}", file.materials) };
    assert_eq!((red.name.as_str(), red.diffuse), ("red one", Some(dvec3(0.8, 0.1, 0.1))));
    assert_eq!((red.shininess, red.opacity, red.specular), (Some(14.0), Some(0.75), Some(DVec3::splat(0.5))));
    assert_eq!((grey.diffuse, grey.ior, grey.opacity), (Some(DVec3::splat(0.5)), Some(1.5), Some(0.5)));
    assert!(file.remarks.warnings().any(|d| d.message.contains("`blue`")));
}

#[test]
fn wrong_libraries_are_told_with_line_and_column() {
    for (text, place, words) in [
        ("newmtl\n", (1, 1), &["names no material"][..]),
        ("Kd 1 0 0\n", (1, 1), &["before any `newmtl`"]),
        ("newmtl a\nKd 1 0\n", (2, 1), &["3 numbers", "found 2"]),
        ("newmtl a\nKd 1 0 2\n", (2, 8), &["out of range", "[0, 1]", "found `2`"]),
        ("newmtl a\nKd spectral a.rfl\n", (2, 4), &["`Kd` in `spectral` cannot be read"]),
        ("newmtl a\nKd\n", (2, 1), &["found 0"]),
        ("newmtl a\nd x\n", (2, 3), &["`x` is not a number"]),
        ("newmtl a\nNi -1\n", (2, 4), &["out of range", "≥ 0"]),
        ("newmtl a\nKe 1e999 0 0\n", (2, 4), &["not finite"]),
    ] {
        let find = |_: &str| Some(Ok(("m.mtl".to_string(), text.to_string())));
        let file = read(&format!("mtllib m.mtl\n{HEAD}usemtl a\nf 1 2 3\n"), "t.obj", &find);
        let shown = file.remarks.render(Color::Never);
        let errors: Vec<_> = file.remarks.files[0].errors().collect();
        let [error] = errors[..] else { panic!("{text:?}: {shown}") };
        let at = file.remarks.files[0].place(error);
        assert_eq!((at.line, at.column), place, "{text:?}: {shown}");
        words.iter().for_each(|w| assert!(shown.contains(w), "{text:?}: `{w}` is not in {shown}"));
        assert_eq!(file.errors(), 1);
    }
}

#[test]
fn what_is_written_reads_back_the_same() {
    for mesh in
        [tessellate::sphere(7, 5), tessellate::cylinder(9), tessellate::cube(2), tessellate::icosphere(1)]
    {
        let back = right(&write(&mesh)).polygons;
        assert_eq!(back.len(), mesh.len());
        for f in 0..mesh.len() {
            assert!(mesh.outline(f).eq(back.outline(f)), "points to the bit");
            for (c, d) in mesh.range(f).zip(back.range(f)) {
                assert_eq!(mesh.uvs.get(c), back.uvs.get(d));
                let (n, m) = (mesh.normals.get(c).expect("given"), back.normals.get(d).expect("read"));
                assert!((n - m).length() <= 1e-15, "normalised once more");
            }
        }
        assert_eq!(Topology::of(&mesh), Topology::of(&back));
        assert_eq!(right(&write(&back)).polygons, back);
    }
}

#[test]
fn odd_faces_are_cut_with_a_note() {
    let text = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 0 0 1\nv 1 0 0.3\nv 0 2 1\nf 1 2 3 4 5\nf 1 2 2\nf 1 3 2 5\nf 1 2 7 6\nf 1 2 3 8\n";
    let file = right(text);
    let notes: Vec<_> =
        file.remarks.notes().map(|d| (file.remarks.place(d).line, d.message.as_str())).collect();
    assert_eq!(
        notes,
        [
            (10, "a face has no area"),
            (11, "the outline of a face crosses itself"),
            (13, "a face is not flat")
        ],
        "{}",
        file.remarks.render(Color::Never)
    );
    // The first is an arrowhead: a ray through its notch passes.
    let mut arrow = Polygons::of_points(file.polygons.points.clone());
    arrow.push_points(file.polygons.face(0));
    let mesh = Mesh::new(&arrow).expect("a mesh");
    let met = |x: f64, y: f64| {
        let ray = lightbench::ray::Ray::new(dvec3(x, y, 1.0), DVec3::NEG_Z);
        mesh.nearest(&ray, 0.0, f64::INFINITY).is_some()
    };
    assert_eq!((met(1.0, 1.0), met(1.0, 0.25), met(0.2, 1.0), met(1.9, 1.5)), (false, true, true, true));
    let comb: String = (0..5000).map(|i| format!("v {i} {} 0\n", i % 2)).collect();
    let face: String = (1..=5000).map(|i| format!(" {i}")).collect();
    let file = read(&format!("{comb}v 2500 -9 0\nf{face} 5001\n"), "t.obj", &no_library);
    let error = file.remarks.errors().next().expect("too long");
    assert_eq!((file.remarks.place(error).line, error.found.as_deref()), (5002, Some("5001")));
}

/// Bytes of the format in any order: no panic, an answer.
#[test]
fn any_text_gets_an_answer() {
    let pieces = prop::sample::select(vec![
        "v",
        "vt",
        "vn",
        "f",
        "usemtl",
        "mtllib",
        "g",
        " ",
        " ",
        "\n",
        "\n",
        "1",
        "2",
        "-1",
        "0",
        "/",
        "//",
        "1e308",
        "nan",
        "#",
        "\\",
        "\r",
        "\u{feff}",
        "é",
        "newmtl",
        "Kd",
        "0.5",
        "v 0 0 0\n",
        "v 1 0 0\n",
        "v 0 1 0\n",
        "f 1 2 3\n",
        "f 1/1/1 2 3",
        "\0",
    ]);
    let find =
        |name: &str| (!name.is_empty()).then(|| Ok((name.to_string(), format!("newmtl {name}\nKd 1\n"))));
    let config = Config { cases: 2000, failure_persistence: None, ..Config::default() };
    proptest!(config, |(pieces in prop::collection::vec(pieces, 0..60))| {
        let file = read(&pieces.concat(), "t.obj", &find);
        file.remarks.render(Color::Never);
        prop_assert_eq!(file.errors() == 0, !file.polygons.is_empty());
        if file.errors() == 0 {
            let _ = Mesh::new(&file.polygons);
        }
    });
}
