//! Writing polygons as an OBJ file.

use crate::mesh::{NONE, Polygons};
use std::fmt::Write;

/// The polygons as the text of an OBJ file, every number so that it reads back exactly. Parts become groups.
pub fn write(mesh: &Polygons) -> String {
    let mut out = String::from("# OBJ, right-handed, y up\n");
    for p in &mesh.points {
        let _ = writeln!(out, "v {} {} {}", p.x, p.y, p.z);
    }
    for uv in &mesh.uvs.values {
        let _ = writeln!(out, "vt {} {}", uv.x, uv.y);
    }
    for n in &mesh.normals.values {
        let _ = writeln!(out, "vn {} {} {}", n.x, n.y, n.z);
    }
    let mut part = None;
    for f in 0..mesh.len() {
        if part.replace(mesh.parts[f]) != Some(mesh.parts[f]) {
            let _ = writeln!(out, "g part{}", mesh.parts[f]);
        }
        // A face has an attribute at all of its corners, or it is written without.
        let has = |all: &[u32]| mesh.range(f).all(|c| all[c] != NONE);
        let (uvs, normals) = (has(&mesh.uvs.corners), has(&mesh.normals.corners));
        out.push('f');
        for c in mesh.range(f) {
            let c = mesh.corner(c);
            let (v, vt, vn) = (u64::from(c.point) + 1, u64::from(c.uv) + 1, u64::from(c.normal) + 1);
            let _ = match (uvs, normals) {
                (true, true) => write!(out, " {v}/{vt}/{vn}"),
                (true, false) => write!(out, " {v}/{vt}"),
                (false, true) => write!(out, " {v}//{vn}"),
                (false, false) => write!(out, " {v}"),
            };
        }
        out.push('\n');
    }
    out
}
