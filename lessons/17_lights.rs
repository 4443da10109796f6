//! Lesson 17. What does each kind of light ask of a shadow ray, and what does remembering the last blocker save?
//!
//! Builds on:  03 (a light, a shadow and a first picture), 13 (Lambert's law).
//! New here:   points, spots, parallel light; irradiance as their one unit; the first blocker, and the last one remembered.
//! Notation:   d distance [m], E irradiance [W/m²], I intensity [W/sr], Φ flux [W]; a look is a shape test or a node visit.
//! Predict:    what hid the light from one pixel is asked first at the next. How many looks does that save, and where none?
//! Figure:     17_lights_shadow_rays_time.svg, 17_lights_memory_map.svg

#[path = "17_lights/charts.rs"]
mod charts;
#[path = "17_lights/cones.rs"]
mod cones;
#[path = "17_lights/contest.rs"]
mod contest;
#[path = "17_lights/diagrams.rs"]
mod diagrams;
#[path = "17_lights/limits.rs"]
mod limits;
#[path = "17_lights/pictures.rs"]
mod pictures;
#[path = "17_lights/stage.rs"]
mod stage;

use charts::{Row, Sweep, row};
use lightbench::measure::{Method, Series};
use lightbench::num::U;
use lightbench::render::Picture;
use lightbench_kit::lesson::{Lesson, Result};
use stage::{OMNI, knot, omni, ring_of_lights, room, sphere_on_floor, swarm};

const FAR: [f64; 26] = [
    1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.5, 8.5, 9.5, 10.5, 11.5, 12.0, 13.5, 14.5, 15.5, 16.5,
    18.0, 19.0, 20.0, 24.0, 153.0, 155.0, 300.0,
]; // log₁₀ of distances [m]

fn main() -> Result {
    let lesson = Lesson::without_essay(17)?;
    let seed = lesson.seed();
    let [wide, small] = [lesson.pick([32, 120, 240, 320]), lesson.pick([24, 64, 96, 128])];
    let tiles = lesson.pick([4, 48, 96, 192]);
    let picture = |width: usize| Picture { width, height: 3 * width / 4, samples: 1, seed };

    // 1. The truth: what the lights say, in one unit; whether a ray is blocked, by the nearest hit of all.
    lesson.save("units", limits::units()?)?;
    for (name, figure) in [
        ("kinds", diagrams::kinds()),
        ("omni_shadows", diagrams::omni_shadows()),
        ("directional_shadow", diagrams::directional_shadow()),
        ("shadow_ray", diagrams::shadow_ray()),
        ("light_ray", diagrams::light_ray()),
        ("spreading", diagrams::spreading()),
        ("sun", diagrams::sun()),
        ("sources", diagrams::sources()),
    ] {
        lesson.save(name, figure)?;
    }

    // 2. The contestants: nearest, first and last blocker, in lists and hierarchies; four tests of a cone.
    let sweep = Sweep::new(&charts::sizes(lesson.pick([30.0, 1000.0, 1000.0, 10_000.0])), seed, tiles)?;
    let scenes = [
        ("A's sphere, one light", sphere_on_floor(vec![omni(OMNI[0], 0.95)])?),
        ("a sphere under 12 lights", ring_of_lights(12)?),
        ("D's room, five spheres", room()?),
        ("300 spheres, 40 % covered", swarm(300, 0.4, seed)?),
        ("300 spheres, 90 % covered", swarm(300, 0.9, seed)?),
        ("3000 spheres, 40 % covered", swarm(lesson.pick([100, 3000, 3000, 3000]), 0.4, seed)?),
        ("a knot of 5760 triangles", knot()?),
    ];
    let rows: Vec<Row> = scenes.iter().map(|(name, scene)| row(name, scene, picture(wide))).collect();
    let cells = lesson.pick([(6, 4), (24, 16), (36, 24), (48, 32)]);
    let (map, failing, worst) = charts::map(tiles / 3, cells, seed)?;
    let cones = cones::sweep(seed, lesson.pick([10, 37, 73, 73]))?;
    let far = limits::far(picture(small), &FAR)?;

    // 3. The figures.
    lesson.save("shadow_rays", sweep.time())?;
    lesson.save("shadow_rays_looks", sweep.work())?;
    lesson.save("memory_map", map)?;
    lesson.save("memory_policies", charts::policies(tiles, seed)?)?;
    lesson.save("memory_scenes", charts::table(&rows))?;
    lesson.save("cone_tests", cones::contest(seed)?)?;
    lesson.save("cone_errors", cones::errors(&cones))?;
    lesson.save("far", far.figure())?;
    lesson.save("far_table", far.table())?;
    lesson.save("odd_places", limits::odd_places(picture(lesson.pick([40, 160, 320, 320])))?)?;
    lesson.save("as_printed", limits::printed()?)?;
    lesson.save("as_printed_shadows", limits::printed_shadows(lesson.pick([20, 120, 200, 400]))?)?;
    pictures::save(&lesson)?;

    // 4. What the figures show, checked.
    lesson.claim(
        &format!("Nearest hit, first blocker and last blocker answer alike: on {} swarms and {} scenes not one pixel differs.", sweep.sizes.len(), rows.len()),
        sweep.agree() && rows.iter().all(|r| r.same),
    );
    let (lost, kept) = (error_at(&cones[0], 1.0e-8), error_at(&cones[3], 1.0e-8));
    lesson.claim(
        &format!("Of a spot of 10⁻⁸ rad cosines get the light wrong by {lost:.1}, the difference of directions by {kept:.0e}."),
        lost > 0.5 && kept < cones::BOUND * U / 1.0e-8,
    );
    let beyond = far.worst_beyond(17.0);
    lesson.claim(
        &format!("From 10¹⁷ to 10³⁰⁰ m a point light draws the directional light's picture to {beyond:.0e} of radiance."),
        beyond < 64.0 * U,
    );
    lesson.answer(&answer(&sweep, failing, worst))
}

/// The worst error at the half angle next to that one; no number at all is as wrong as can be.
fn error_at((_, series): &(Method, Series), edge: f64) -> f64 {
    let off = |p: &&lightbench::measure::Point| (p.parameter / edge).ln().abs();
    let nearest = series.points.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    let point = nearest.filter(|p| p.failures.total() == 0);
    point.and_then(|p| p.error).map_or(1.0, |e| e.mid)
}

fn answer(sweep: &Sweep, failing: f64, worst: f64) -> String {
    let (n, last) = (sweep.sizes[sweep.sizes.len() - 1], sweep.last());
    format!(
        "a point light asks for a segment, a directional one for an endless ray, a spot first for an angle, which cosines cannot tell below 10⁻⁸ \
         rad. Among {n} spheres the nearest hit takes {:.0} looks in a list and {:.1} in a hierarchy, the first blocker {:.1}, the last one \
         remembered {:.1}. Remembering costs more, by {:.0} % at most, on {:.0} % of the map: where blockers are narrower than the rays' distance; \
         no pixel changes.",
        last[0].looks(),
        last[3].looks(),
        last[4].looks(),
        last[5].looks(),
        100.0 * (worst - 1.0),
        100.0 * failing,
    )
}
