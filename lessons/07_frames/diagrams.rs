//! Diagrams of lesson 07: frames, rotations, the camera's axes, a change of space.

use glam::{DAffine2, DQuat, DVec2, DVec3, dvec2, dvec3};
use lightbench::frame::Frame;
use lightbench_kit::figure::{Diagram, Figure, Light, Space, short};
use lightbench_kit::lesson::{Lesson, Result};
use std::f64::consts::{FRAC_PI_2, TAU};

pub fn save(lesson: &Lesson) -> Result {
    lesson.save("two_frames", two_frames())?;
    lesson.save("handedness", handedness())?;
    lesson.save("normal_from_tangents", normal_from_tangents())?;
    lesson.save("quarter_turn", quarter_turn())?;
    lesson.save("sine_and_cosine", sine_and_cosine())?;
    lesson.save("clockwise", clockwise())?;
    lesson.save("from_to", from_to())?;
    lesson.save("right_up_forward", right_up_forward())?;
    lesson.save("forward", forward())?;
    lesson.save("one_plane", one_plane())?;
    lesson.save("change_of_space", change_of_space())
}

fn told(d: Diagram, caption: &str) -> Figure {
    Figure::from(d).caption(caption)
}

/// B, figure 4.1: the printed coordinates hold for the frame drawn here.
fn two_frames() -> Figure {
    // Origin (6, 12) and unit axes along the first frame's: p − o = (2, −4).
    let (origin, p) = (dvec2(6.0, 12.0), dvec2(8.0, 8.0));
    let second = p - origin;
    let d = Diagram::new(dvec2(-1.2, -1.2), dvec2(14.6, 14.6))
        .ray(Light::Incident, DVec2::ZERO, dvec2(13.6, 0.0)).name_end("x")
        .ray(Light::Incident, DVec2::ZERO, dvec2(0.0, 13.8)).name_end("y")
        .ray(Light::Shadow, origin, origin + dvec2(7.6, 0.0)).name_end("x′")
        .ray(Light::Shadow, origin, origin + dvec2(0.0, 2.3)).name_end("y′")
        .hidden(&[dvec2(p.x, 0.0), p, dvec2(0.0, p.y)])
        .hidden(&[dvec2(p.x, origin.y), p, dvec2(origin.x, p.y), origin])
        .point(DVec2::ZERO).name("o")
        .point(origin).name("o′")
        .spot(Light::Other, p).name(&format!("p = ({}, {}) = ({}, {})′", p.x, p.y, second.x, second.y).replace('-', "−"))
        .title("One point, two frames: (8, 8) in one is (2, −4) in the other")
        .subtitle("p − o′ in the second frame, whose origin lies at (6, 12) of the first")
        .alt("Two pairs of axes with different origins and one point p; dashed lines show its coordinates in each.");
    told(d, "Coordinates belong to a frame, the point does not (after B, figure 4.1).")
}

/// B, figure 4.2.
fn handedness() -> Figure {
    let space = Space::axonometric(28.0, 22.0);
    let mut d = Diagram::fitted();
    for (at, z, name) in [
        (DVec3::ZERO, DVec3::NEG_Z, "left-handed: x × y = −z"),
        (dvec3(2.65, 0.0, -1.41), DVec3::Z, "right-handed: x × y = z"),
    ] {
        let p = |v: DVec3| space.at(at + v);
        d = d
            .ray(Light::Incident, p(DVec3::ZERO), p(DVec3::X))
            .name_end("x")
            .ray(Light::Transmitted, p(DVec3::ZERO), p(DVec3::Y))
            .name_end("y")
            .ray(Light::Reflected, p(DVec3::ZERO), p(z * 1.1))
            .name_end("z")
            .note(p(dvec3(0.2, -0.75, 0.0)), name);
    }
    let d = d
        .title("The hand decides where z points: into the page, or out of it")
        .subtitle("x to the right, y up; this library and B's cameras are right-handed, so that a camera looks along −z")
        .alt("Two sets of axes with x to the right and y up; on the left z points away from the viewer, on the right towards.");
    told(d, "Left- and right-handed axes (after B, figure 4.2).")
}

/// B, figure 4.3.
fn normal_from_tangents() -> Figure {
    let space = Space::axonometric(30.0, 30.0);
    // z = f(x, y) with y up on paper: a hill.
    let hill = |x: f64, z: f64| dvec3(x, 0.55 * (-(x * x + z * z) / 1.6).exp(), z);
    let (x, z) = (0.45, 0.35);
    let slope = |along: DVec3| {
        let h = 1.0e-6;
        (hill(x + along.x * h, z + along.z * h) - hill(x - along.x * h, z - along.z * h)) / (2.0 * h)
    };
    let (t, b) = (slope(DVec3::Z).normalize(), slope(DVec3::X).normalize());
    let n = t.cross(b).normalize();
    let p = hill(x, z);
    let at = |v: DVec3| space.at(v);
    let rim: Vec<DVec2> = [(-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5), (-1.5, -1.5)]
        .windows(2)
        .flat_map(|w| {
            (0..24)
                .map(move |k| f64::from(k) / 24.0)
                .map(move |s| (w[0].0 + (w[1].0 - w[0].0) * s, w[0].1 + (w[1].1 - w[0].1) * s))
        })
        .map(|(x, z)| at(hill(x, z)))
        .collect();
    let mut d = Diagram::fitted().polygon(&rim);
    for k in 1..12 {
        let c = -1.5 + 0.25 * f64::from(k);
        let line = |f: &dyn Fn(f64) -> DVec3| -> Vec<DVec2> {
            (0..=48).map(|i| at(f(-1.5 + f64::from(i) / 16.0))).collect()
        };
        d = d.thin(&line(&|s| hill(c, s))).thin(&line(&|s| hill(s, c)));
    }
    let d = d
        .ray(Light::Incident, at(p), at(p + t * 0.95))
        .name_end("T")
        .ray(Light::Transmitted, at(p), at(p + b * 0.95))
        .name_end("B")
        .ray(Light::Reflected, at(p), at(p + n * 0.95))
        .name_end("N = T × B")
        .point(at(p))
        .name("p")
        .title("Two tangents span the plane that touches; N stands on it")
        .subtitle(&format!(
            "here |N·T| = {}, |N·B| = {}: zero but for rounding",
            short(n.dot(t).abs()),
            short(n.dot(b).abs())
        ))
        .alt(
            "A hilly surface with a grid; at a point two tangents T and B, and the normal N square to both.",
        );
    told(d, "The normal as the cross product of two tangents (after B, figure 4.3).")
}

fn circle_with_axes(mut d: Diagram) -> Diagram {
    let ring: Vec<DVec2> = (0..=120).map(|k| DVec2::from_angle(TAU * f64::from(k) / 120.0)).collect();
    d = d.thin(&ring);
    d.ray(Light::Normal, dvec2(-1.35, 0.0), dvec2(1.5, 0.0))
        .name_end("x")
        .ray(Light::Normal, dvec2(0.0, -1.3), dvec2(0.0, 1.4))
        .name_end("y")
}

fn swing(d: Diagram, from: f64, to: f64, name: &str) -> Diagram {
    let way: Vec<DVec2> = (0..=40)
        .map(|k| from + (to - from) * f64::from(k) / 40.0)
        .map(|a| 0.62 * DVec2::from_angle(a))
        .collect();
    d.path(Light::Other, &way[..39]).ray(Light::Other, way[38], way[40]).name(name)
}

fn turned(v: DVec2, angle: f64) -> DVec2 {
    (DQuat::from_rotation_z(angle) * v.extend(0.0)).truncate()
}

fn pair(v: DVec2) -> String {
    let text = |x: f64| {
        format!("{:.4}", if x.abs() < 1.0e-12 { 0.0 } else { x })
            .trim_end_matches('0')
            .trim_end_matches('.')
            .replace('-', "−")
    };
    format!("({}, {})", text(v.x), text(v.y))
}

/// B, figure 4.5.
fn quarter_turn() -> Figure {
    let (p, q) = (DVec2::X, turned(DVec2::X, FRAC_PI_2));
    let half = turned(p, FRAC_PI_2 / 2.0);
    let d = swing(circle_with_axes(Diagram::fitted()), 0.0, FRAC_PI_2, "90°")
        .ray(Light::Incident, DVec2::ZERO, p).ray(Light::Reflected, DVec2::ZERO, q).hidden(&[DVec2::ZERO, half])
        .spot(Light::Incident, p).name(&format!("P = {}", pair(p)))
        .spot(Light::Reflected, q).name(&format!("P_{{T}} = {}", pair(q)))
        .point(half).name(&format!("45°: {}", pair(half)))
        .title(&format!("A quarter turn takes {} to {}", pair(p), pair(q)))
        .subtitle("counter-clockwise about z, by quaternion; the matrix agrees")
        .alt("A unit circle; the point P on the x axis is turned by 90 degrees counter-clockwise to P_T on the y axis.");
    told(d, "Rotation by 90° counter-clockwise (after B, figure 4.5), and by 45° on the way.")
}

/// B, figure 4.6.
fn sine_and_cosine() -> Figure {
    let angle = 0.61f64;
    let p = DVec2::from_angle(angle);
    let foot = dvec2(p.x, 0.0);
    let d = circle_with_axes(Diagram::fitted())
        .ray(Light::Incident, DVec2::ZERO, p).name("1")
        .path(Light::Transmitted, &[DVec2::ZERO, foot]).name("cos θ")
        .path(Light::Reflected, &[foot, p]).name("sin θ")
        .right_angle(foot, dvec2(-1.0, 0.0), DVec2::Y)
        .angle_at(DVec2::ZERO, DVec2::X, p, 70.0).name("θ")
        .spot(Light::Incident, p).name(&pair(p))
        .title("On the unit circle a point's coordinates are the cosine and the sine of its angle")
        .subtitle(&format!("θ = {:.1}°: cos θ = {:.4}, sin θ = {:.4}", angle.to_degrees(), p.x, p.y))
        .alt("A unit circle with a right triangle: the horizontal leg is cos theta, the vertical leg sin theta.");
    told(d, "Sine and cosine as coordinates (after B, figure 4.6).")
}

/// B, figure 4.7: the caption says 40°, the text 90°.
fn clockwise() -> Figure {
    let (p, q) = (DVec2::Y, turned(DVec2::Y, -FRAC_PI_2));
    let forty = turned(DVec2::Y, -40f64.to_radians());
    // B's matrix before its last, row vectors: x' = y sin θ for P = (0, 1).
    let printed = dvec2((-FRAC_PI_2).sin(), (-FRAC_PI_2).cos());
    let d = swing(circle_with_axes(Diagram::fitted()), FRAC_PI_2, 0.0, "−90°")
        .ray(Light::Incident, DVec2::ZERO, p).ray(Light::Reflected, DVec2::ZERO, q).ray(Light::Shadow, DVec2::ZERO, printed)
        .hidden(&[DVec2::ZERO, forty])
        .spot(Light::Incident, p).name(&format!("P = {}", pair(p)))
        .spot(Light::Reflected, q).name(&format!("P_{{T}} = {}", pair(q)))
        .point(forty).name("−40°")
        .point(printed).name(&format!("as printed: {}", pair(printed)))
        .title("Clockwise, the sine's sign matters: as first printed, (0, 1) goes the wrong way")
        .subtitle("B's first matrix has +sin twice; only the last one, with −sin in the second row, is a rotation")
        .alt("A unit circle; P on the y axis is turned clockwise by 90 degrees to the x axis; the matrix as first printed sends it to minus x.");
    told(
        d,
        "Clockwise rotation (after B, figure 4.7, whose caption says 40° and whose text computes 90°; both are marked).",
    )
}

const EYE: DVec3 = dvec3(2.2, 1.7, 2.6);

/// B, figure 5.7.
fn from_to() -> Figure {
    let space = Space::axonometric(-28.0, 20.0);
    let (from, to) = (space.at(EYE), space.at(DVec3::ZERO));
    let d = Diagram::fitted()
        .axes(&space, dvec3(-2.0, 0.0, 0.0), 1.0)
        .solid_box(&space, dvec3(-0.4, 0.0, -0.4), dvec3(0.4, 0.8, 0.4))
        .ray(Light::Incident, from, space.at(EYE * 0.25))
        .hidden(&[from, space.at(EYE * dvec3(1.0, 0.0, 1.0)), to])
        .point(space.at(EYE * dvec3(1.0, 0.0, 1.0)))
        .eye(from, to - from)
        .name("from")
        .point(to)
        .name("to")
        .title("Two points say where a camera stands and what it looks at")
        .subtitle(&format!(
            "from = ({}, {}, {}), to = (0, 0, 0), {:.3} apart",
            EYE.x,
            EYE.y,
            EYE.z,
            EYE.length()
        ))
        .alt("An eye named from, above and in front of a box, looks at the point named to under the box.");
    told(d, "From and to (after B, figure 5.7).")
}

fn camera_axes(d: Diagram, space: &Space, frame: &Frame, at: DVec3) -> Diagram {
    d.ray(Light::Incident, space.at(at), space.at(at + frame.right))
        .name_end("right")
        .ray(Light::Transmitted, space.at(at), space.at(at + frame.up))
        .name_end("up")
        .ray(Light::Reflected, space.at(at), space.at(at + frame.forward))
        .name_end("forward")
}

fn frame_of_the_eye() -> Frame {
    Frame::look_at(EYE, DVec3::ZERO, DVec3::Y).expect("two different points")
}

/// B, figure 5.8.
fn right_up_forward() -> Figure {
    let space = Space::axonometric(-12.0, 24.0);
    let frame = frame_of_the_eye();
    let d = camera_axes(Diagram::fitted(), &space, &frame, DVec3::ZERO)
        .point(space.at(DVec3::ZERO))
        .name("from")
        .title("Right, up and forward: the camera's own axes")
        .subtitle(&format!(
            "unit and square to each other: |right·up| = {}, |up·forward| = {}",
            short(frame.right.dot(frame.up).abs()),
            short(frame.up.dot(frame.forward).abs())
        ))
        .alt("Three arrows from one point, named right, up and forward, square to each other.");
    told(
        d,
        "The axes of a camera (after B, figure 5.8). Here forward is where it looks; B's forward axis runs from the target to the camera, so that the frame is right-handed.",
    )
}

/// B, figure 5.9.
fn forward() -> Figure {
    let space = Space::axonometric(-28.0, 20.0);
    let frame = frame_of_the_eye();
    let (from, to) = (EYE, DVec3::ZERO);
    let d = Diagram::fitted()
        .hidden(&[space.at(from), space.at(to)])
        .ray(Light::Reflected, space.at(from), space.at(from + frame.forward)).name("forward")
        .ray(Light::Shadow, space.at(from), space.at(from - frame.forward)).name("B's forward")
        .point(space.at(from)).name("from")
        .point(space.at(to)).name("to")
        .title("Forward is to − from, made one long")
        .subtitle(&format!("(to − from)/|to − from| = ({:.3}, {:.3}, {:.3}); B takes from − to, and looks along its negative", frame.forward.x, frame.forward.y, frame.forward.z).replace('-', "−"))
        .alt("The points from and to joined by a dashed line; a unit arrow forward lies on it, and B's forward points the other way.");
    told(d, "The forward axis (after B, figure 5.9).")
}

/// B, figure 5.10.
fn one_plane() -> Figure {
    let space = Space::axonometric(62.0, 20.0);
    let frame = frame_of_the_eye();
    let level = (frame.forward * dvec3(1.0, 0.0, 1.0)).normalize();
    let sheet = [(-0.35, -0.75), (1.2, -0.75), (1.2, 1.25), (-0.35, 1.25)]
        .map(|(a, b)| space.at(level * a + DVec3::Y * b));
    let d = camera_axes(Diagram::fitted().polygon(&sheet), &space, &frame, DVec3::ZERO)
        .ray(Light::Other, space.at(DVec3::ZERO), space.at(DVec3::Y)).name_end("(0, 1, 0)")
        .point(space.at(DVec3::ZERO))
        .title("(0, 1, 0), forward and up share a plane, and right stands on it")
        .subtitle(&format!("(0, 1, 0)·right = {}; looking straight up or down the plane is lost, and with it right", short(frame.right.y.abs())))
        .alt("A vertical plane that holds the arrows forward, up and (0,1,0); the arrow right is square to it.");
    told(d, "Why any picture's right is square to (0, 1, 0) (after B, figure 5.10).")
}

/// E, slide 84: problem 5.2.
fn change_of_space() -> Figure {
    let (center, r) = (dvec2(3.4, 1.1), 1.6);
    let map = DAffine2 { matrix2: glam::DMat2::from_diagonal(DVec2::splat(r)), translation: center };
    let (o, way) = (dvec2(0.2, 2.7), dvec2(0.93, -0.3676).normalize());
    let back = map.inverse();
    let (o_unit, way_unit) = (back.transform_point2(o), back.transform_vector2(way));
    let b = o_unit.dot(way_unit);
    let t = (-b - (b * b - way_unit.length_squared() * (o_unit.length_squared() - 1.0)).sqrt())
        / way_unit.length_squared();
    let shift = dvec2(9.0, 1.1);
    let (hit, hit_unit) = (o + way * t, o_unit + way_unit * t);
    let d = Diagram::fitted()
        .circle(center, r)
        .ray(Light::Incident, o, hit).name("d")
        .point(o).name("o").point(center).name("c").spot(Light::Incident, hit).name("p")
        .path(Light::Other, &[center, center + dvec2(0.0, r)]).name(&format!("r = {r}"))
        .ray(Light::Normal, dvec2(5.5, 1.1), dvec2(6.4, 1.1)).name("(p − c)/r")
        .circle(shift, 1.0)
        .ray(Light::Incident, shift + o_unit, shift + hit_unit).name("d/r")
        .point(shift + o_unit).name("o′").point(shift).name("0").spot(Light::Incident, shift + hit_unit).name("p′")
        .path(Light::Other, &[shift, shift + DVec2::Y]).name("1")
        .title("Move the ray, not the sphere: in the unit sphere's space t is the same")
        .subtitle(&format!("t = {t:.4} in both; the direction's length there is 1/r = {:.4}, and must not be normalised", way_unit.length()))
        .alt("Left a circle of radius 1.6 met by a ray; right the unit circle met by the same ray moved and shrunk; an arrow between them is named (p − c)/r.");
    told(d, "Problem 5.2 (after E, slide 84): any sphere is the unit sphere after a change of space.")
}
