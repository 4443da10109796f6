//! Camera, frames, rotations, normals.

use super::{Cell, Row, RowError, Topic, cells_of};
use crate::frame::{Frame, rotation_about, transform_normal};
use crate::scene::{Camera, FieldOfView};
use glam::{DMat3, DVec2, DVec3};

const VIEW: [(&str, &str); 9] = [
    ("ex", "length"),
    ("ey", "length"),
    ("ez", "length"),
    ("tx", "length"),
    ("ty", "length"),
    ("tz", "length"),
    ("ux", ""),
    ("uy", ""),
    ("uz", ""),
];

pub(super) const PINHOLE: Topic = Topic {
    name: "pinhole",
    about: "direction of the ray through a pixel's centre",
    methods: &[],
    inputs: &[
        VIEW[0],
        VIEW[1],
        VIEW[2],
        VIEW[3],
        VIEW[4],
        VIEW[5],
        VIEW[6],
        VIEW[7],
        VIEW[8],
        ("fov_deg", "°"),
        ("fov_axis", "v|h"),
        ("width", "px"),
        ("height", "px"),
        ("px", "px"),
        ("py", "px"),
    ],
    outputs: &[("dx", ""), ("dy", ""), ("dz", "")],
    answer: pinhole,
};

fn pinhole(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let angle = row.number("fov_deg")?.to_radians();
    let field_of_view = match row.text("fov_axis") {
        "v" => FieldOfView::Vertical(angle),
        "h" => FieldOfView::Horizontal(angle),
        _ => return Err(row.error("fov_axis", "`v` or `h`")),
    };
    let size = |column| match row.text(column).parse::<u32>() {
        Ok(n) if n > 0 => Ok(n as usize),
        _ => Err(row.error(column, &format!("a whole number of pixels, from 1 to {}", u32::MAX))),
    };
    let camera = Camera::new(row.vector("e")?, row.vector("t")?, row.vector("u")?, field_of_view)
        .map_err(|e| row.error("ex", &format!("a camera ({e})")))?;
    let raster = DVec2::new(row.number("px")? + 0.5, row.number("py")? + 0.5);
    let ray = camera.ray(raster, size("width")?, size("height")?);
    Ok(cells_of(Some(ray.direction)).to_vec())
}

pub(super) const LOOKAT: Topic = Topic {
    name: "lookat",
    about: "right, up and forward of a viewer at e who looks at t",
    methods: &[],
    inputs: &VIEW,
    outputs: &[
        ("rx", ""),
        ("ry", ""),
        ("rz", ""),
        ("vx", ""),
        ("vy", ""),
        ("vz", ""),
        ("fx", ""),
        ("fy", ""),
        ("fz", ""),
    ],
    answer: lookat,
};

fn lookat(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let frame = Frame::look_at(row.vector("e")?, row.vector("t")?, row.vector("u")?)
        .map_err(|e| row.error("tx", &format!("a target ({e})")))?;
    Ok([frame.right, frame.up, frame.forward].iter().flat_map(|v| cells_of(Some(*v))).collect())
}

const MATRIX: [(&str, &str); 9] = [
    ("m00", ""),
    ("m01", ""),
    ("m02", ""),
    ("m10", ""),
    ("m11", ""),
    ("m12", ""),
    ("m20", ""),
    ("m21", ""),
    ("m22", ""),
];

pub(super) const ROTATIONS: Topic = Topic {
    name: "rotations",
    about: "matrix of a counter-clockwise rotation about an axis of any length, for column vectors",
    methods: &[],
    inputs: &[("ax", ""), ("ay", ""), ("az", ""), ("angle_rad", "rad")],
    outputs: &MATRIX,
    answer: rotations,
};

fn rotations(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let m = rotation_about(row.vector("a")?, row.number("angle_rad")?)
        .ok_or_else(|| row.error("ax", "an axis that is not the zero vector"))?;
    Ok(m.transpose().to_cols_array().map(Cell::Number).to_vec())
}

pub(super) const NORMAL_TRANSFORM: Topic = Topic {
    name: "normal_transform",
    about: "unit normal after the linear map m (row by row)",
    methods: &[],
    inputs: &[
        MATRIX[0],
        MATRIX[1],
        MATRIX[2],
        MATRIX[3],
        MATRIX[4],
        MATRIX[5],
        MATRIX[6],
        MATRIX[7],
        MATRIX[8],
        ("nx", ""),
        ("ny", ""),
        ("nz", ""),
    ],
    outputs: &[("tnx", ""), ("tny", ""), ("tnz", "")],
    answer: normal_transform,
};

fn normal_transform(row: &Row, _: &str) -> Result<Vec<Cell>, RowError> {
    let mut rows = [DVec3::ZERO; 3];
    for (i, r) in rows.iter_mut().enumerate() {
        let n = |j: usize| row.number(MATRIX[3 * i + j].0);
        *r = DVec3::new(n(0)?, n(1)?, n(2)?);
    }
    let m = DMat3::from_cols(rows[0], rows[1], rows[2]).transpose();
    Ok(cells_of(transform_normal(&m, row.vector("n")?)).to_vec())
}
