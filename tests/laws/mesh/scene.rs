//! Meshes in scene files.

use glam::{DVec3, dvec3};
use lightbench::mesh::tessellate;
use lightbench::ray::{Ray, Silent};
use lightbench_kit::scene_file::obj::write;
use lightbench_kit::scene_file::{Color, ReadError, SceneFile, read_file};
use std::fs;
use std::path::PathBuf;

/// A folder of its own, gone at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("lightbench_mesh_{name}_{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Folder(path)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("a file");
    }

    fn scene(&self, objects: &str) -> Result<SceneFile, ReadError> {
        let head = "Camera { POV 0 0 5 }\nPointLight { }\nMaterial { Name own DiffuseColor 0.25 0.5 0.75 }\n";
        self.write("s.scene", &format!("{head}{objects}\n"));
        read_file(&self.0.join("s.scene"))
    }

    fn wrong(&self, objects: &str) -> String {
        match self.scene(objects) {
            Ok(_) => panic!("{objects} passes"),
            Err(error) => error.render(Color::Never).replace(&format!("{}/", self.0.display()), ""),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The colour of what a ray along −z meets first.
fn seen(file: &SceneFile, x: f64, y: f64) -> Option<DVec3> {
    let ray = Ray::new(dvec3(x, y, 9.0), DVec3::NEG_Z);
    let (object, crossing) = file.scene.nearest(&ray, f64::INFINITY, &mut Silent)?;
    let hit = file.scene.hit(&ray, object, &crossing);
    Some(file.scene.materials[file.scene.objects[object].material(hit.part)].diffuse)
}

const HALVES: &str = "mtllib h.mtl\nv -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\nusemtl left\nf 1 2 3 4\nusemtl right\nf 2 5 6 3\n";
const LIBRARY: &str = "newmtl left\nKd 0.5 0 0\nnewmtl right\nKd 0 0 0.5\n";

#[test]
fn faces_are_seen_in_their_librarys_colours_or_in_the_blocks() {
    let folder = Folder::new("colours");
    folder.write("h.obj", HALVES);
    folder.write("h.mtl", LIBRARY);
    let file = folder.scene("Mesh { Source \"h.obj\" }").expect("right");
    assert_eq!(seen(&file, -0.5, 0.0), Some(dvec3(0.5, 0.0, 0.0)));
    assert_eq!(seen(&file, 0.5, 0.0), Some(dvec3(0.0, 0.0, 0.5)));
    let file = folder.scene("Mesh { Material own Source \"h.obj\" }").expect("right");
    assert_eq!(seen(&file, -0.5, 0.0), Some(dvec3(0.25, 0.5, 0.75)));
    // Turned by a half about y, then moved: in the order in which it is written.
    let file = folder
        .scene("Mesh { Source \"h.obj\" Rotation 0 1 0 3.14159265358979 Translation 3 0 0 Scale 1 2 1 }");
    let file = file.expect("right");
    assert_eq!(
        (seen(&file, 2.5, 1.9), seen(&file, 3.5, 0.0)),
        (Some(dvec3(0.0, 0.0, 0.5)), Some(dvec3(0.5, 0.0, 0.0)))
    );
    assert_eq!((seen(&file, 0.5, 0.0), seen(&file, 2.5, 2.1)), (None, None));
}

#[test]
fn a_closed_mesh_stands_in_a_csg() {
    let folder = Folder::new("csg");
    folder.write("ball.obj", &write(&tessellate::sphere(24, 12)));
    let tree = "CSG { Material own Difference { Mesh { Source \"ball.obj\" } Cylinder { Base 0 0 -2 Axis 0 0 1 Height 4 Radius 0.5 } } }";
    let file = folder.scene(tree).expect("right");
    assert!(seen(&file, 0.0, 0.0).is_none() && seen(&file, 0.7, 0.0).is_some());
    folder.write("half.obj", HALVES);
    folder.write("h.mtl", LIBRARY);
    let shown = folder.wrong("CSG { Material own Union { Mesh { Source \"half.obj\" } Box { } } }");
    assert!(
        shown.contains("s.scene:4:") && shown.contains("it is not closed") && shown.contains("6 edges"),
        "{shown}"
    );
}

#[test]
fn what_is_wrong_is_told_in_the_scene_and_where_it_stands() {
    let folder = Folder::new("wrong");
    folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 x\n");
    folder.write("h.obj", HALVES);
    folder.write("point.obj", "v 1 1 1\nf 1 1 1\n");
    fs::write(folder.0.join("binary.obj"), [0x80, 0xff, 0]).expect("a file");
    for (block, words) in [
        (
            "Mesh { Material own Source \"bad.obj\" }",
            &[
                "s.scene:4:28: error: bad.obj has 2 errors",
                "bad.obj:4:7: error",
                "expected 1 to 3",
                "bad.obj:5:7: error",
            ][..],
        ),
        ("Mesh { Material own Source \"none.obj\" }", &["s.scene:4:28: error: none.obj: cannot be read"]),
        (
            "Mesh { Material own Source \"binary.obj\" }",
            &["is no word of the format", "binary.obj:1:1", "the file has no face"],
        ),
        (
            "Mesh { Source \"h.obj\" }",
            &[
                "s.scene:4:1: error: the `Mesh` has faces without a material",
                "h.obj:1:8: note: there is no material library",
            ],
        ),
        ("Mesh { Material own Source \"point.obj\" }", &["this is no Mesh", "area above 0"]),
        ("Mesh { Material own Source \"h.obj\" Scale 1 1 0 }", &["s.scene:4:"]),
    ] {
        let shown = folder.wrong(block);
        words.iter().for_each(|w| assert!(shown.contains(w), "{block}: `{w}` is not in\n{shown}"));
    }
}
