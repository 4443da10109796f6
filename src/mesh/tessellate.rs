//! Round things cut into flat faces [A §2.1, ill. 3].
//!
//! All surfaces are closed, have outward fronts, the true surface's normals, and corners on it. Faces are quadrilaterals
//! and polygons; a mesh makes triangles of them. Sizes are 1; [`Polygons::transformed`] gives others.

use super::{Attribute, Corner, NONE, Polygons};
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::{PI, TAU};

/// `(cos, sin)` of the `i`-th of `n` parts of a turn; of eighths of it exactly, so that a circle comes back to its beginning.
fn on_circle(i: u32, n: u32) -> DVec2 {
    let (i, n) = (u64::from(i % n), u64::from(n));
    let (quarter, rest) = (4 * i / n, 4 * i % n);
    let angle = TAU / 4.0 * rest as f64 / n as f64;
    // Beyond an eighth the cosine is the sine from the other side.
    let (s, c) = match 2 * rest > n {
        true => (TAU / 4.0 * (n - rest) as f64 / n as f64).sin_cos(),
        false => angle.sin_cos(),
    };
    let (s, c) = if 2 * rest > n { (c, s) } else { (s, c) };
    match quarter {
        0 => dvec2(c, s),
        1 => dvec2(-s, c),
        2 => dvec2(-c, -s),
        _ => dvec2(s, -c),
    }
}

/// A patch of `columns × rows` quadrilaterals: `at(i, j)` is the point and normal at their corners, counter-clockwise
/// from outside if `i` grows to the right and `j` upwards. Corners at equal points become one.
fn patch(columns: u32, rows: u32, at: impl Fn(u32, u32) -> (DVec3, DVec3)) -> Polygons {
    let wide = columns + 1;
    let nodes: Vec<(u32, u32)> = (0..=rows).flat_map(|j| (0..wide).map(move |i| (i, j))).collect();
    let (points, normals): (Vec<DVec3>, Vec<DVec3>) = nodes.iter().map(|&(i, j)| at(i, j)).unzip();
    let share =
        |(i, j): &(u32, u32)| dvec2(f64::from(*i) / f64::from(columns), f64::from(*j) / f64::from(rows));
    let mut mesh = Polygons::of_points(points);
    mesh.uvs = Attribute { values: nodes.iter().map(share).collect(), corners: Vec::new() };
    mesh.normals = Attribute { values: normals, corners: Vec::new() };
    let corner = |i: u32, j: u32| Corner { point: i + j * wide, uv: i + j * wide, normal: i + j * wide };
    for j in 0..rows {
        for i in 0..columns {
            mesh.push(&[corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)], 0);
        }
    }
    mesh.welded()
}

/// The unit sphere about the origin, poles on the y axis, in `columns` of longitude and `rows` of latitude.
///
/// - Domain: `columns ≥ 3, rows ≥ 2`; fewer count as those.
pub fn sphere(columns: u32, rows: u32) -> Polygons {
    let (columns, rows) = (columns.max(3), rows.max(2));
    patch(columns, rows, |i, j| {
        let around = on_circle(i, columns);
        // Half a turn from pole to pole.
        let height = on_circle(j, 2 * rows);
        let p = dvec3(height.y * around.x, -height.x, -height.y * around.y);
        (p + 0.0, p + 0.0)
    })
}

/// The unit sphere in `20 · 4^levels` nearly equal triangles; texture coordinates are left out.
///
/// - Domain: levels up to 12 fit any machine.
pub fn icosphere(levels: u32) -> Polygons {
    let mut mesh = Polygons::of_triangles(&crate::shape::triangle::icosphere(levels)).welded();
    mesh.normals.values = mesh.points.clone();
    mesh.normals.corners = mesh.faces().flatten().copied().collect();
    mesh
}

/// The torus about the z axis: a circle of radius `tube` swept along one of radius `ring`, in `columns` along the ring and
/// `rows` around the tube.
///
/// - Domain: `ring > tube > 0`; at least 3 columns and rows.
pub fn torus(ring: f64, tube: f64, columns: u32, rows: u32) -> Polygons {
    let (columns, rows) = (columns.max(3), rows.max(3));
    patch(columns, rows, |i, j| {
        let (along, around) = (on_circle(i, columns), on_circle(j, rows));
        let n = dvec3(around.x * along.x, around.x * along.y, around.y);
        (dvec3(ring * along.x, ring * along.y, 0.0) + n * tube, n)
    })
}

/// The solid of revolution about the y axis between two flat ends, radius `bottom` at y = 0 and `top` at y = 1: `sides` faces
/// around, and a polygon of as many corners for each end that is not a point. Fewer than 3 sides count as 3.
///
/// - Domain: radii ≥ 0, not both 0.
pub fn frustum(bottom: f64, top: f64, sides: u32) -> Polygons {
    let n = sides.max(3);
    let slant = dvec2(1.0, bottom - top).normalize();
    let mut mesh = patch(n, 1, |i, j| {
        // Against the turn of x to z, so that outside is seen counter-clockwise.
        let way = on_circle(i, n);
        let (x, z) = (way.x, -way.y);
        let r = if j == 0 { bottom } else { top };
        (dvec3(r * x, f64::from(j), r * z) + 0.0, dvec3(slant.x * x, slant.y, slant.x * z))
    });
    for (radius, y, normal) in [(bottom, 0.0, DVec3::NEG_Y), (top, 1.0, DVec3::Y)] {
        if radius > 0.0 {
            cap(&mut mesh, radius, y, normal, n);
        }
    }
    mesh.welded()
}

/// Appends one flat end as a polygon.
fn cap(mesh: &mut Polygons, radius: f64, y: f64, normal: DVec3, n: u32) {
    let mut face: Vec<Corner> = (0..n)
        .map(|i| {
            let way = on_circle(i, n);
            mesh.points.push(dvec3(radius * way.x, y, -radius * way.y) + 0.0);
            mesh.uvs.values.push(dvec2(0.5 + 0.5 * way.x, 0.5 + 0.5 * way.y * normal.y));
            let [point, uv] = [mesh.points.len() - 1, mesh.uvs.values.len() - 1].map(|k| k as u32);
            Corner { point, uv, normal: mesh.normals.values.len() as u32 }
        })
        .collect();
    if normal.y < 0.0 {
        face.reverse();
    }
    mesh.normals.values.push(normal);
    mesh.push(&face, 0);
}

/// The cylinder of radius 1 about the y axis from y = 0 to 1 [A ill. 3].
pub fn cylinder(sides: u32) -> Polygons {
    frustum(1.0, 1.0, sides)
}

/// The cone about the y axis: base of radius 1 at y = 0, tip at y = 1.
pub fn cone(sides: u32) -> Polygons {
    frustum(1.0, 0.0, sides)
}

/// The cube of edge 1 about the origin, each face in `n × n` squares.
pub fn cube(n: u32) -> Polygons {
    let n = n.max(1);
    let share = |i: u32| if i == n { 0.5 } else { f64::from(i) / f64::from(n) - 0.5 };
    let mut mesh = Polygons::of_points(Vec::new());
    let faces =
        [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z].map(|normal: DVec3| {
            let right = if normal.y == 0.0 { DVec3::Y.cross(normal) } else { DVec3::X };
            let up = normal.cross(right);
            patch(n, n, |i, j| (normal * 0.5 + right * share(i) + up * share(j) + 0.0, normal))
        });
    for face in &faces {
        append(&mut mesh, face);
    }
    mesh.welded()
}

/// Appends all faces of another mesh, with points of their own.
fn append(mesh: &mut Polygons, other: &Polygons) {
    let [points, uvs, normals] =
        [mesh.points.len(), mesh.uvs.values.len(), mesh.normals.values.len()].map(|n| n as u32);
    mesh.points.extend(&other.points);
    mesh.uvs.values.extend(&other.uvs.values);
    mesh.normals.values.extend(&other.normals.values);
    let shifted = |i: u32, by: u32| if i == NONE { NONE } else { i + by };
    for f in 0..other.len() {
        let corner = |c: usize| {
            let c = other.corner(c);
            Corner { point: c.point + points, uv: shifted(c.uv, uvs), normal: shifted(c.normal, normals) }
        };
        let face: Vec<Corner> = other.range(f).map(corner).collect();
        mesh.push(&face, other.parts[f]);
    }
}

/// A bumpy tube along a trefoil knot, in `columns` along the knot and `rows` around the tube; within 3.6 of the origin, 2.8 thick
/// along z. Normals are left out. 1000 × 35 make 70 000 triangles.
///
/// ```text
/// c(s) = ((2 + cos 3s) cos 2s, (2 + cos 3s) sin 2s, sin 3s),   radius 0.36 (1 + 0.14 sin 60s cos 5φ)
/// ```
pub fn bumpy_knot(columns: u32, rows: u32) -> Polygons {
    let (columns, rows) = (columns.max(16), rows.max(3));
    let curve = |s: f64| {
        let (r, turn) = (2.0 + (3.0 * s).cos(), DVec2::from_angle(2.0 * s));
        dvec3(r * turn.x, r * turn.y, (3.0 * s).sin())
    };
    let mut mesh = patch(columns, rows, |i, j| {
        let s = TAU * f64::from(i % columns) / f64::from(columns);
        let phi = TAU * f64::from(j % rows) / f64::from(rows);
        // Along the curve, and across it away from the z axis: a frame that closes.
        let h = PI / 4096.0;
        let ahead = (curve(s + h) - curve(s - h)).normalize_or(DVec3::X);
        let out = curve(s) * dvec3(1.0, 1.0, 0.0);
        let out = (out - ahead * out.dot(ahead)).normalize_or(DVec3::Z);
        let side = ahead.cross(out);
        let radius = 0.36 * (1.0 + 0.14 * (60.0 * s).sin() * (5.0 * phi).cos());
        // Along the curve, then this way round, is counter-clockwise from outside.
        let n = out * phi.cos() - side * phi.sin();
        (curve(s) + n * radius, n)
    });
    mesh.normals = Attribute { values: Vec::new(), corners: vec![NONE; mesh.corner_count()] };
    mesh
}
