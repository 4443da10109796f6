//! Charts and tables of lesson 07.

use super::moved::cost;
use glam::{DMat3, DQuat, DVec3};
use lightbench::frame::{Frame, rotation_about};
use lightbench::measure::{Method, Series};
use lightbench::num::U;
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench_kit::figure::{Axis, Chart, Figure, Guide, Table, short};
use std::f64::consts::FRAC_PI_4;

type Contest = [(Method, Series)];

/// The headline: error of t against time.
pub fn speed(contest: &Contest, rays: u32) -> Figure {
    let at = |k: usize| cost(&contest[k].1, 1.0e3);
    let mut chart = Chart::speed_accuracy("error of t, half sides (root mean square)")
        .x(Axis::time("time per ray"))
        .title(&format!(
            "A stretched sphere takes {:.1} × the time of an ellipsoid, a moved cube {:.1} × that of half-spaces",
            at(1).1 / at(0).1, at(2).1 / at(3).1
        ))
        .subtitle(&format!("10, 10³, 10⁵ half sides from origin and eye, upwards along each line; {rays} rays that hit; nine runs each"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Speed against accuracy of E's problem 5.2: the ray goes to the unit shape's space, or the shape is made in its place. D turns \
         its boxes by Haines's planes (D, section 5.9.1.2).",
    )
}

pub fn stability(contest: &Contest, rays: u32) -> Figure {
    let mut chart = Chart::error_over(Axis::log("distance from origin and eye, half sides"), "error of t, half sides (root mean square)")
        .title("A map rounds o − T once more than a shape in its place does, and then all keep pace with the distance")
        .subtitle(&format!("{rays} rays a point, all hit; truth in 106 bits from the map's own numbers"))
        .guide(Guide::slope_through(1.0, 1.0, U, "u D: one rounding of the distance"));
    for (method, series) in contest {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Error of the first meeting over the distance of shape and eye from the origin of coordinates.",
    )
}

pub fn bases(bases: &Contest) -> Figure {
    let worst =
        |k: usize| bases[k].1.points.iter().filter_map(|p| p.error).map(|e| e.mid).fold(0.0, f64::max);
    let mut chart = Chart::error_over(Axis::log("1 + z"), "largest defect of orthonormality")
        .y(Axis::log("largest defect of orthonormality").range(1.0e-17, 1.0e1))
        .title(&format!("Towards z = −1 Frisvad's basis in f32 is off by {}; Duff's keeps every digit", short(worst(0))))
        .subtitle("64 directions a point; largest |xᵢ·xⱼ − δᵢⱼ| of the two vectors and the direction, summed in f64")
        .guide(Guide::upright(1.0e-7, "Frisvad's patch: z < −0.9999999"))
        .guide(Guide::slope_through(-1.0, 1.0, f64::from(f32::EPSILON), "ε/(1 + z), f32"))
        .guide(Guide::slope_through(-1.0, 1.0, f64::EPSILON, "ε/(1 + z), f64"));
    for (method, series) in bases {
        chart = chart.line(method.clone(), series);
    }
    Figure::from(chart).caption(
        "Two bases round a direction. Frisvad (2012) divides by 1 + z, which is all rounding at the south pole, and patches what is \
         nearest; the patch ignores x and y and is off by √(2(1 + z)). Duff et al. (2017) take the sign of z along.",
    )
}

/// B's right axis exactly as printed: (0, 1, 0) × forward, of whatever length that has; the sign is B's own.
fn printed_right(forward: DVec3) -> DVec3 {
    DVec3::Y.cross(forward)
}

/// What B's look-at makes of a field of 90°, looking ever more steeply.
pub fn look_at() -> Figure {
    let field = |right: DVec3| 2.0 * (FRAC_PI_4.tan() * right.length()).atan().to_degrees();
    let row = |below: f64| {
        let a = (90.0 - below).to_radians();
        DVec3::new(0.0, -a.cos(), -a.sin())
    };
    let narrowed = field(printed_right(row(45.0)));
    let mut table = Table::new(&["Looking down by", "|right|, as printed", "field of 90° becomes", "|right|, ours", "right·forward, ours"])
        .title(&format!("As printed, a field of 90° becomes {narrowed:.1}° when the camera looks down by 45°"))
        .subtitle("right = (0, 1, 0) × forward, not normalised [B §5.3.1]; ours normalises, and takes another up at the pole");
    for below in [0.0, 30.0, 45.0, 60.0, 80.0, 89.0, 89.999_999, 90.0] {
        let forward = if below == 90.0 { DVec3::NEG_Y } else { row(below) };
        let printed = printed_right(forward);
        let Ok(ours) = Frame::look_at(DVec3::ZERO, forward, DVec3::Y) else { continue };
        table = table.row(&[
            &format!("{below}°"),
            &short(printed.length()),
            &format!("{}°", short(field(printed))),
            &short(ours.right.length()),
            &short(ours.right.dot(ours.forward).abs()),
        ]);
    }
    Figure::from(table.marked()).caption(
        "B's look-at and its limit (B, sections 5.3.1 and 5.3.2): the cross product with (0, 1, 0) has length sin of the angle between \
         them, which narrows the picture, and vanishes when the camera looks straight down.",
    )
}

pub fn normals(normals: &Contest) -> Figure {
    let closed: Vec<(f64, f64)> = (0..=60)
        .map(|k| 10f64.powf(f64::from(k) / 20.0))
        .map(|s| (s, ((s * s - 1.0) / (s * s + 1.0)).asin().to_degrees()))
        .collect();
    let degrees = |series: &Series| -> Vec<(f64, f64)> {
        series.points.iter().filter_map(|p| p.error.map(|e| (p.parameter, e.mid.to_degrees()))).collect()
    };
    let two = ((4.0f64 - 1.0) / 5.0).asin().to_degrees();
    let mut chart = Chart::new(
        Axis::log("stretch s of the widest against the narrowest axis"),
        Axis::linear("largest tilt of the normal, degrees").range(0.0, 95.0),
    )
    .title(&format!("Twice as wide as high, and M n is off by up to {two:.0}°; M⁻ᵀ n never is"))
    .subtitle("worst of the sampled normals, against the square to two transformed tangents");
    for (method, series) in normals {
        chart = chart.curve(method.clone(), &degrees(series));
    }
    Figure::from(chart.function(Method::new("asin((s² − 1)/(s² + 1))").styled(5), &closed)).caption(
        "A normal is no displacement: sent through the map itself it tilts; sent through the inverse transpose it stays square to the surface.",
    )
}

/// Many small rotations composed: how far the product is from a rotation.
pub fn drift(seed: u64, angle: f64, steps: u32) -> Figure {
    let (mut matrix, mut plain, mut kept) = (DMat3::IDENTITY, DQuat::IDENTITY, DQuat::IDENTITY);
    let (mut a, mut b, mut c) = (Vec::new(), Vec::new(), Vec::new());
    for i in 1..=steps {
        let axis = uniform_sphere(Sampler::new(seed, 11, i).next_2d());
        let step = rotation_about(axis, angle).unwrap_or(DMat3::IDENTITY);
        let turn = DQuat::from_axis_angle(axis.normalize(), angle);
        (matrix, plain, kept) = (step * matrix, turn * plain, (turn * kept).normalize());
        if i.is_power_of_two() {
            let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
            let off = |j: usize, k: usize| (columns[j].dot(columns[k]) - f64::from(u8::from(j == k))).abs();
            let defect =
                (0..3).flat_map(|j| (j..3).map(move |k| (j, k))).map(|(j, k)| off(j, k)).fold(0.0, f64::max);
            a.push((f64::from(i), defect));
            b.push((f64::from(i), (plain.length_squared() - 1.0).abs()));
            c.push((f64::from(i), (kept.length_squared() - 1.0).abs()));
        }
    }
    let last = a.last().map_or(0.0, |p| p.1);
    let chart = Chart::new(Axis::log("rotations composed"), Axis::log("defect"))
        .title(&format!("After {} turns a product of matrices is off by {}; a quaternion is put right by one division", a.last().map_or(0.0, |p| p.0), short(last)))
        .subtitle(&format!("turns of {angle} rad about random axes; defect: of the columns' products, or of the squared length; seed {seed}"))
        .guide(Guide::slope_through(0.5, 1.0, U, "u √n"))
        .guide(Guide::slope_through(1.0, 1.0, U, "u n"))
        .curve(Method::new("matrices").styled(1), &a)
        .curve(Method::new("quaternions").styled(3), &b)
        .curve(Method::default_of("quaternions, normalised").styled(0), &c);
    Figure::from(chart).caption(
        "Composing rotations. Both products leave the rotations slowly; four numbers are normalised more easily than nine.",
    )
}
