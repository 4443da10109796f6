//! Kinds of light, and the shadows they throw.

use glam::{DVec2, dvec2};
use lightbench_kit::figure::{Diagram, Figure, Light};
use std::f64::consts::{PI, TAU};

const UP: DVec2 = DVec2::Y;

/// Where a line through `from` along `d` meets the floor, y = 0.
fn floor(from: DVec2, d: DVec2) -> DVec2 {
    from - d * (from.y / d.y)
}

/// The two rays from a lamp that touch a circle: where they touch it, and where they meet the floor.
fn rim(lamp: DVec2, center: DVec2, radius: f64) -> [(DVec2, DVec2); 2] {
    let to = center - lamp;
    let (sin, length) = (radius / to.length(), (to.length_squared() - radius * radius).sqrt());
    [-1.0, 1.0].map(|side| {
        let d = DVec2::from_angle(side * sin.asin()).rotate(to.normalize());
        let touch = lamp + d * length;
        (touch, floor(touch, d))
    })
}

fn shadow(d: Diagram, [a, b]: [(DVec2, DVec2); 2], center: DVec2) -> Diagram {
    d.region(Light::Shadow, &[a.0, a.1, b.1, b.0, center])
}

/// A, illustrations 35 and 40.
pub fn kinds() -> Figure {
    let (lamp, sun) = (dvec2(-3.4, 0.0), dvec2(3.2, 0.0));
    let mut d = Diagram::fitted();
    for k in 0..16 {
        let out = DVec2::from_angle(TAU * (f64::from(k) + 0.5) / 16.0);
        d = d.ray(Light::Incident, lamp + out * 0.35, lamp + out * 1.9);
    }
    d = d.lamp(lamp).note(lamp - UP * 2.8, "omnidirectional: a place, and every direction alike");
    let along = dvec2(1.0, -1.0).normalize();
    for k in -3..=3 {
        let from = sun + along.perp() * (0.52 * f64::from(k)) - along * 1.7;
        d = d.ray(Light::Incident, from, from + along * 3.4);
        if k == 3 {
            d = d.name_end("ω");
        }
    }
    d = d.note(sun - UP * 2.8, "directional: no place, one direction everywhere");
    Figure::from(d
        .title("A point light has a place, a directional light only a direction")
        .subtitle("after A, ill. 35 and 40")
        .alt("Left, a lamp with sixteen arrows in all directions. Right, seven parallel arrows to the lower right, without a lamp."))
        .caption("An omnidirectional light (A, illustration 35) is a place; the direction to it, and how far light has thinned out, differ \
                  from place to place. A directional light (A, illustration 40) comes from nowhere: it has neither place nor fall-off.")
}

/// A, illustrations 36 and 37; D, figure 18.
pub fn omni_shadows() -> Figure {
    let mut d = Diagram::fitted().ground(DVec2::ZERO, UP);
    let (ball, radius) = (dvec2(-4.0, 1.5), 0.75);
    let lamp = dvec2(-2.6, 4.2);
    let edge = rim(lamp, ball, radius);
    d = shadow(d, edge, ball);
    for (touch, end) in edge {
        d = d.path(Light::Incident, &[lamp, touch]).path(Light::Shadow, &[touch, end]);
    }
    d = d.beam(Light::Incident, lamp, dvec2(-1.6, 0.0)).circle(ball, radius).lamp(lamp);
    d = d.note(dvec2((edge[0].1.x + edge[1].1.x) * 0.5, -0.55), "shadow: no light");
    d = d.note(dvec2(-1.6, -0.55), "lit");
    let ball = dvec2(4.0, 1.5);
    let lamps = [dvec2(2.7, 4.2), dvec2(5.1, 4.2)];
    let edges = lamps.map(|l| rim(l, ball, radius));
    for edge in edges {
        d = shadow(d, edge, ball);
    }
    for (lamp, edge) in lamps.into_iter().zip(edges) {
        for (touch, end) in edge {
            d = d.path(Light::Incident, &[lamp, touch]).path(Light::Shadow, &[touch, end]);
        }
        d = d.lamp(lamp);
    }
    d = d.circle(ball, radius);
    let mut xs: Vec<f64> = edges.iter().flatten().map(|e| e.1.x).collect();
    xs.sort_by(f64::total_cmp);
    for (i, words) in [(0, "one lamp"), (1, "none"), (2, "one lamp")] {
        d = d.note(dvec2((xs[i] + xs[i + 1]) * 0.5, -0.55), words);
    }
    Figure::from(d
        .title("Each lamp has its own shadow; it is dark only where all of them overlap")
        .subtitle("after A, ill. 36 and 37, and D, fig. 18")
        .alt("Left, a lamp over a ball over a floor; two lines from the lamp touch the ball and bound its shadow on the floor. Right, \
              two lamps over a ball: their shadows overlap in the middle, where no lamp is seen."))
        .caption("The shadow of one point light (A, illustration 36; D, figure 18): its edge is sharp, for a place sees the lamp or does not. \
                  With several lights (A, illustration 37) each is asked on its own.")
}

/// A, illustration 41.
pub fn directional_shadow() -> Figure {
    let along = dvec2(1.0, -1.0).normalize();
    let (ball, radius, block) =
        (dvec2(-1.6, 1.9), 0.8, [dvec2(2.0, 0.9), dvec2(3.2, 0.9), dvec2(3.2, 1.9), dvec2(2.0, 1.9)]);
    let mut d = Diagram::fitted().ground(DVec2::ZERO, UP);
    let across = along.perp() * radius;
    let edges = [[ball - across, ball + across], [block[0], block[2]]];
    for edge in edges {
        d = d.region(Light::Shadow, &[edge[0], floor(edge[0], along), floor(edge[1], along), edge[1]]);
    }
    for touch in edges.into_iter().flatten() {
        d = d.path(Light::Shadow, &[touch, floor(touch, along)]);
        d = d.beam(Light::Incident, touch - along * 1.9, touch);
    }
    let free = dvec2(-1.0, 3.2);
    d = d.ray(Light::Incident, free, floor(free, along));
    d = d.circle(ball, radius).polygon(&block);
    d = d.note(dvec2(floor(ball, along).x, -0.45), "as wide wherever it falls").dimension(
        floor(edges[0][0], along),
        floor(edges[0][1], along),
        -14.0,
    );
    Figure::from(d
        .title("In parallel light a shadow is the projection of the shape along the light")
        .subtitle("after A, ill. 41: light along (1, −1)")
        .alt("Parallel arrows come down to the right past a ball and a box; dashed lines of the same direction carry their outlines to the floor."))
        .caption("Shadows of a directional light (A, illustration 41). All shadow rays are parallel and endless: anything on their way hides the light.")
}

/// B, illustration 3.5.
pub fn shadow_ray() -> Figure {
    let (eye, lamp) = (dvec2(-4.6, 2.6), dvec2(3.0, 4.0));
    let (hidden, seen) = (dvec2(-1.2, 0.0), dvec2(1.4, 0.0));
    let (ball, radius) = (dvec2(0.35, 1.5), 0.6);
    let towards = (lamp - hidden).normalize();
    let from = ball - hidden;
    let at = from.dot(towards);
    let met = hidden + towards * (at - (radius * radius - (from.length_squared() - at * at)).max(0.0).sqrt());
    let d = Diagram::fitted()
        .ground(DVec2::ZERO, UP)
        .circle(ball, radius)
        .eye(eye, hidden - eye)
        .ray(Light::Incident, eye, hidden)
        .word("camera ray")
        .ray(Light::Incident, eye, seen)
        .ray(Light::Other, hidden, met)
        .word("stops here: shadow")
        .hidden(&[met, lamp])
        .ray(Light::Shadow, seen, lamp)
        .word("reaches the light")
        .lamp(lamp)
        .point(hidden)
        .name("p")
        .point(seen)
        .name("q");
    Figure::from(d
        .title("A shadow ray asks only whether anything stands before the light")
        .subtitle("after B, ill. 3.5")
        .alt("Two rays from an eye reach the floor. From one place a ray towards the lamp ends at a ball, from the other it reaches the lamp."))
        .caption("After the nearest hit of the camera ray a second ray goes from there towards the light (B, illustration 3.5). Which blocker it \
                  meets, and where, does not matter: the first that is found ends the search.")
}

/// A, illustration 66; E, slide 69.
pub fn light_ray() -> Figure {
    let p = dvec2(0.0, 0.0);
    let lamps = [dvec2(-4.2, 2.1), dvec2(-1.1, 3.6), dvec2(4.2, 2.1)];
    let (ball, radius) = (dvec2(-0.65, 2.0), 0.5);
    let mut d = Diagram::fitted().ground(DVec2::ZERO, UP).circle(ball, radius);
    d = d.ray(Light::Shadow, p, lamps[0]).name("V(p, q_{1}) = 1");
    let towards = (lamps[1] - p).normalize();
    let at = ball.dot(towards);
    let met = towards * (at - (radius * radius - (ball.length_squared() - at * at)).max(0.0).sqrt());
    d = d.ray(Light::Other, p, met).name("V(p, q_{2}) = 0").hidden(&[met, lamps[1]]);
    d = d.ray(Light::Shadow, p, lamps[2]).name("V(p, q_{3}) = 1");
    for (lamp, name) in lamps.into_iter().zip(["q_{1}", "q_{2}", "q_{3}"]) {
        d = d.lamp(lamp).name(name);
    }
    let d = d.normal(p, UP * 0.95).name_end("n").angle(p, UP, lamps[2]).name("θ_{3}").point(p).name("p");
    Figure::from(d
        .title("What arrives is a sum over the lights that are seen: V(p, q) is 1 or 0")
        .subtitle("after A, ill. 66, and E, slide 69")
        .alt("From a place p on a floor rays go to three lamps; the middle one is hidden by a ball, and its V is 0. To the right one the \
              angle with the normal is marked."))
        .caption("The light ray of A (illustration 66), the visibility V of E (slide 69): the sum over all lights of f E(d) cos θ V. A light \
                  below the horizon is not asked at all.")
}

/// B, illustrations 7.16 and 7.17.
pub fn spreading() -> Figure {
    let (lamp, p) = (dvec2(-4.4, 2.2), dvec2(-2.4, 0.0));
    let n = dvec2(-0.3, 1.0).normalize();
    let mut d = Diagram::fitted()
        .polygon(&[
            p + n.perp() * 1.2,
            p - n.perp() * 1.2,
            p - n.perp() * 1.2 - n * 0.25,
            p + n.perp() * 1.2 - n * 0.25,
        ])
        .ray(Light::Shadow, p, lamp)
        .name("L − P")
        .normal(p, n * 1.3)
        .name_end("n")
        .angle(p, n, lamp - p)
        .name("θ")
        .lamp(lamp)
        .name("L")
        .point(p)
        .name("P");
    let (center, r) = (dvec2(2.0, 1.0), 1.15);
    let half = 0.2;
    for radius in [r, 2.0 * r] {
        let ring: Vec<DVec2> =
            (0..=120).map(|k| center + DVec2::from_angle(TAU * f64::from(k) / 120.0) * radius).collect();
        d = d.thin(&ring);
        let patch: Vec<DVec2> =
            (-8..=8).map(|k| center + DVec2::from_angle(half * f64::from(k) / 8.0) * radius).collect();
        d = d.path(Light::Reflected, &patch).name(if radius == r { "A" } else { "4A" });
    }
    for side in [-half, half] {
        d = d.path(Light::Incident, &[center, center + DVec2::from_angle(side) * 2.0 * r]);
    }
    for k in 1..12 {
        let out = DVec2::from_angle(0.2 + (TAU - 0.4) * f64::from(k) / 12.0);
        d = d.ray(Light::Incident, center + out * 0.25, center + out * 0.62);
    }
    let slant = DVec2::from_angle(0.62 * PI);
    d = d.dimension(center, center + slant * 2.0 * r, 0.0).name("2r").lamp(center);
    Figure::from(d
        .title("The direction is a difference of places; the flux spreads over 4π r²")
        .subtitle("after B, ill. 7.16 and 7.17: twice as far, the same light falls on four times the area")
        .alt("Left, a place P on a tilted surface, its normal, and the arrow to a lamp L. Right, a lamp in two circles, one twice as large; the \
              same cone cuts out an area of A from the one and of 4A from the other."))
        .caption("To shade P, a line is drawn to the light (B, illustration 7.16). Its flux spreads over spheres (B, illustration 7.17): B writes \
                  it as L = intensity · colour/(4π r²); what it divides is a flux [W], and what arrives is an irradiance [W/m²].")
}

/// B, illustration 7.15.
pub fn sun() -> Figure {
    let (sun, earth) = (dvec2(-4.6, 0.0), dvec2(3.6, 0.0));
    let mut d = Diagram::fitted().circle(sun, 1.5).note(sun, "sun");
    for y in [-0.36, -0.12, 0.12, 0.36] {
        d = d.ray(Light::Incident, dvec2(sun.x + 1.6, y), dvec2(earth.x - 0.5, y));
    }
    for side in [-1.5, 1.5] {
        d = d.hidden(&[sun + UP * side, earth]);
    }
    d = d.circle(earth, 0.42).note(earth - dvec2(0.5, 0.75), "earth, drawn far too large");
    d = d.note(dvec2(0.3, -1.35), "a cone of 0.53°: what a place sees of the sun");
    Figure::from(d
        .title("Over a metre the sun's rays are parallel to 7·10⁻¹² rad; it is 0.53° wide")
        .subtitle("after B, ill. 7.15: radius 6.96·10⁸ m, distance 1.496·10¹¹ m")
        .alt("A large circle, the sun, on the left; parallel arrows to a small circle, the earth. Dashed lines from the sun's rims meet at the earth."))
        .caption("Sunlight as a directional light (B, illustration 7.15). Two places a metre apart see the sun's middle in the same direction, to \
                  7·10⁻¹² rad. But each sees a disc, not a point: one metre behind an edge the true shadow has a rim 9 mm wide.")
}

/// C, figure 8.
pub fn sources() -> Figure {
    let mut d = Diagram::fitted().ground(DVec2::ZERO, UP);
    let places = [dvec2(-4.0, 0.0), dvec2(0.0, 0.0), dvec2(4.2, 0.0)];
    let lamp = dvec2(-4.6, 3.0);
    d = d.ray(Light::Incident, lamp, places[0]).lamp(lamp);
    let tube = [dvec2(-1.3, 3.0), dvec2(1.3, 3.0)];
    d = d.polygon(&[tube[0], tube[1], tube[1] + UP * 0.2, tube[0] + UP * 0.2]);
    for k in 0..=4 {
        let from = tube[0].lerp(tube[1], f64::from(k) / 4.0);
        d = d.ray(Light::Incident, from, places[1]);
    }
    let wall = [dvec2(6.2, 0.0), dvec2(6.5, 0.0), dvec2(6.5, 3.0), dvec2(6.2, 3.0)];
    let (from, at) = (dvec2(3.4, 3.0), dvec2(6.2, 1.6));
    d = d.polygon(&wall).ray(Light::Incident, from, at).ray(Light::Reflected, at, places[2]).lamp(from);
    for (place, words) in places.into_iter().zip(["a point", "distributed: a tube", "reflected: a wall"]) {
        d = d.point(place).note(place - UP * 0.55, words);
    }
    Figure::from(d
        .title("Light comes from points, from surfaces, and from all that reflects it")
        .subtitle("after C, fig. 8; local illumination asks the first two, and has ambient light for the third")
        .alt("Three places on a floor: one lit by a lamp, one by five rays from a tube, one by a ray that a wall has reflected."))
        .caption("Sources by their size and kind (C, figure 8). Small and far is a point; a tube near by is not, and its shadows are soft; walls \
                  shine with light of others.")
}
