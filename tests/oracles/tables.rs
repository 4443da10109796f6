//! Each topic of `probe` against its table.

use super::truth::{
    all_right, columns, csg_spans, faces, quartic_roots, sphere_roots, torus_roots, wrong_rows,
};

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

#[test]
fn tori_agree_with_their_table() {
    all_right("ray_torus", include_str!("../data/ray_torus.csv"), torus_roots);
}

/// The table tells methods apart, and the more the less is done about rounding.
#[test]
fn the_table_catches_other_ways_to_meet_a_torus() {
    let least =
        [("as_printed", 200), ("recentred", 80), ("ferrari", 10), ("bracketed", 10), ("marching", 20)];
    for (method, least) in least {
        let (_, wrong) =
            wrong_rows("ray_torus", Some(method), include_str!("../data/ray_torus.csv"), torus_roots);
        assert!(wrong.len() >= least, "{method}: only {} rows wrong", wrong.len());
    }
}

/// More rows, with distances to 10⁶ ring radii, scales from 1e-9 to 1e9 and tangents of every kind.
#[test]
fn tori_agree_with_their_nasty_table() {
    all_right("ray_torus", include_str!("../data/ray_torus_nasty.csv"), torus_roots);
}

/// Spans of the whole line, and the first hit with its normal.
#[test]
fn trees_of_solids_agree_with_their_table() {
    all_right("csg", include_str!("../data/csg.csv"), csg_spans);
}

#[test]
fn the_table_catches_the_printed_pair_rules() {
    let (_, wrong) = wrong_rows("csg", Some("as_printed"), include_str!("../data/csg.csv"), csg_spans);
    assert!(wrong.len() >= 30, "only {} rows wrong", wrong.len());
}

/// Exact fractions, cell by cell. A plane errs by 3 roundings of the size, its parameter by 2 more; the normal is an axis.
#[test]
fn sponges_agree_with_their_table() {
    use lightbench::num::U;
    all_right("ray_menger", include_str!("../data/ray_menger.csv"), |row, answer| {
        if !row.is_judged() {
            return None;
        }
        if answer.number("n_pos") != row.number("n_pos") {
            return Some(f64::INFINITY);
        }
        let mut worst: f64 = 0.0;
        for (t, cond) in [("tp0", "cond_tp0"), ("tp1", "cond_tp1")] {
            if let Some(truth) = row.number(t) {
                let allowed = 8.0 * U * truth * row.number(cond)?.max(1.0);
                worst = worst.max((answer.number(t)? - truth).abs() / allowed);
            }
        }
        let square = ["nx", "ny", "nz"].iter().all(|c| answer.number(c) == row.number(c));
        // Through an edge or corner two or three normals are right.
        let exact_tie = row.number("ox").is_some_and(|x| (2.0 * x).fract() == 0.0);
        Some(if square || exact_tie { worst } else { f64::INFINITY })
    });
}

#[test]
fn quartics_agree_with_their_table() {
    all_right("quartic_roots", include_str!("../data/quartic_roots.csv"), quartic_roots);
    let (_, wrong) = wrong_rows(
        "quartic_roots",
        Some("as_printed"),
        include_str!("../data/quartic_roots.csv"),
        quartic_roots,
    );
    assert!(wrong.len() >= 80, "only {} rows wrong", wrong.len());
}

/// Roots spread over 140 orders of magnitude, clusters, scales from 1e-240 to 1e240.
#[test]
fn quartics_agree_with_their_nasty_table() {
    all_right("quartic_roots", include_str!("../data/quartic_roots_nasty.csv"), quartic_roots);
}

/// A product sums four terms (γ₄); the unit rotation and the slerp round some 30 times relative to their size, the
/// slerp's weights `sin(tθ)/sin θ` once more by `1/sin θ`.
#[test]
fn quaternions_agree_with_their_table() {
    use glam::{DQuat, DVec3};
    use lightbench::num::gamma;
    let table = super::support::table::Table::read("quaternions.csv");
    for row in table.rows() {
        let of = |w, x, y, z| DQuat::from_xyzw(row.f64(x), row.f64(y), row.f64(z), row.f64(w));
        let vector = |x, y, z| DVec3::new(row.f64(x), row.f64(y), row.f64(z));
        let (a, b) = (of("aw", "ax", "ay", "az"), of("bw", "bx", "by", "bz"));
        let (v, size) = (vector("vx", "vy", "vz"), a.length() * b.length());
        assert!((a * b - of("pw", "px", "py", "pz")).length() <= gamma(8) * size, "{a} {b}");
        let (a, b) = (a.normalize(), b.normalize());
        assert!((a * v - vector("rx", "ry", "rz")).length() <= gamma(40) * v.length(), "{a} {v}");
        let (axis, angle) = a.to_axis_angle();
        let ours = lightbench::frame::rotation_about(axis, angle).expect("a unit axis");
        // The angle from acos is known to u / sin(θ/2) only.
        let turned = gamma(80) * v.length() / a.xyz().length();
        assert!((ours * v - vector("rx", "ry", "rz")).length() <= turned, "{axis} {angle}");
        let (slerped, sine) = (a.slerp(b, row.f64("slerp_t")), (1.0 - a.dot(b).powi(2)).sqrt());
        assert!((slerped - of("sw", "sx", "sy", "sz")).length() <= gamma(60) / sine, "{a} {b}");
    }
}
