//! A thing in its hulls.

use glam::{DVec2, dvec2};
use lightbench_kit::figure::{Diagram, Figure, Light};
use lightbench_kit::lesson::Result;

/// A complicated thing: a star.
fn star() -> Vec<DVec2> {
    let corner = |k: u32| {
        let radius = if k.is_multiple_of(2) { 1.5 } else { 0.62 };
        DVec2::from_angle(std::f64::consts::PI * (0.5 + f64::from(k) / 5.0)) * radius
    };
    (0..10).map(corner).collect()
}

/// A, illustration 70: rays that miss the hull need not be tested with the thing; of the others some miss all the same.
pub fn hulls() -> Result<Figure> {
    let star = star();
    let (low, high) =
        star.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
    let center = (low + high) * 0.5;
    let radius = star.iter().map(|p| p.distance(center)).fold(0.0, f64::max);
    let mut d = Diagram::fitted();
    for (shift, name) in [(dvec2(-3.4, 0.0), "a ball"), (dvec2(3.4, 0.0), "a box along the axes")] {
        let at = |p: DVec2| p + shift;
        d = d.polygon(&star.iter().map(|p| at(*p)).collect::<Vec<_>>());
        let hull: Vec<DVec2> = if shift.x < 0.0 {
            (0..=72)
                .map(|k| at(center) + DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 72.0) * radius)
                .collect()
        } else {
            [low, dvec2(high.x, low.y), high, dvec2(low.x, high.y), low].map(at).to_vec()
        };
        d = d.hidden(&hull);
        for (from, light, end) in [
            (dvec2(-2.2, -1.72), Light::Shadow, dvec2(2.1, -1.66)),
            (dvec2(-2.2, 0.55), Light::Reflected, dvec2(0.6, 2.24)),
            (dvec2(-2.2, -0.2), Light::Incident, dvec2(-0.66, -0.02)),
        ] {
            d = d.ray(light, at(from), at(end));
        }
        d = d.note(at(dvec2(0.0, -2.2)), name);
    }
    d = d.note(dvec2(0.0, -1.69), "misses the hull: done");
    d = d.note(dvec2(0.0, 0.55), "meets the hull only");
    d = d.note(dvec2(0.0, -0.2), "meets both");
    Ok(Figure::from(
        d.title("A simple hull answers for a complicated thing: most rays that miss it miss the hull")
            .subtitle("grey: one look at the hull; orange: a look in vain and the test; blue: a look and the test; after A, ill. 70"),
    )
    .caption("A thing in a ball and in a box (after A, illustration 70): the tighter the hull, the fewer looks in vain."))
}
