//! Each topic of `probe` against its table.

use super::truth::{all_right, columns, faces, sphere_roots, wrong_rows};

#[test]
fn spheres_agree_with_their_table() {
    all_right("ray_sphere", include_str!("../data/ray_sphere.csv"), sphere_roots);
}

/// The table tells methods apart: the textbook's loses distant spheres.
#[test]
fn the_table_catches_the_textbook_sphere() {
    for method in ["algebraic", "geometric"] {
        let (_, wrong) =
            wrong_rows("ray_sphere", Some(method), include_str!("../data/ray_sphere.csv"), sphere_roots);
        assert!(wrong.len() >= 50, "{method}: only {} rows wrong", wrong.len());
    }
}

#[test]
fn boxes_agree_with_their_table() {
    all_right("ray_box", include_str!("../data/ray_box.csv"), faces);
}

/// Three normalised products and two quotients: a few u, far under 1e-12.
#[test]
fn pinhole_rays_agree_with_their_table() {
    all_right("pinhole", include_str!("../data/pinhole.csv"), columns(&["dx", "dy", "dz"], 1e-12));
}

/// The condition is 1/sin∠(f, up): rows under 1e-6 lose more than 1e-9, and are not judged.
#[test]
fn look_at_agrees_with_its_table() {
    let judge = columns(&["rx", "ry", "rz", "vx", "vy", "vz", "fx", "fy", "fz"], 1e-9);
    all_right("lookat", include_str!("../data/lookat.csv"), |row, answer| {
        if row.number("sin_up_angle")? > 1e-6 { judge(row, answer) } else { None }
    });
}

/// 8 u ≈ 9e-16 is promised.
#[test]
fn rotations_agree_with_their_table() {
    let entries = &["m00", "m01", "m02", "m10", "m11", "m12", "m20", "m21", "m22"];
    all_right("rotations", include_str!("../data/rotations.csv"), columns(entries, 1e-14));
}

#[test]
fn transformed_normals_agree_with_their_table() {
    all_right(
        "normal_transform",
        include_str!("../data/normal_transform.csv"),
        columns(&["tnx", "tny", "tnz"], 1e-9),
    );
}
