//! Lesson 10. How do spans along a ray make solids out of solids, and when do the documents' rules break?
//!
//! Builds on:  03 (a scene, a light, a picture), 04 (rays along faces), 07 (a shape under a map).
//! New here:   trees of solids; root diagrams and their table; ties; rules that look at marks alone.
//! Notation:   t ray parameter [m]; ∪, ∩, − union, intersection, difference; IN and OUT the sides of a surface.
//! Predict:    a pocket ends exactly in the top of a plate. What share of the rays into it sees a lid?
//! Figure:     10_csg_speed_accuracy_time.svg, 10_csg_coincident.svg, 10_csg_roots.svg

use lightbench::integrator::Local;
use lightbench::render::{Picture, render};
use lightbench_kit::figure::{Figure, Panels, Pixels, short};
use lightbench_kit::lesson::{Lesson, LessonError, Result};
use lightbench_kit::scene_file::{Color, read_file};
use std::path::Path;

#[path = "10_csg/cases.rs"]
mod cases;
#[path = "10_csg/charts.rs"]
mod charts;
#[path = "10_csg/contestants.rs"]
mod contestants;
#[path = "10_csg/diagrams.rs"]
mod diagrams;
#[path = "10_csg/printed.rs"]
mod printed;
#[path = "10_csg/solids.rs"]
mod solids;
#[path = "10_csg/stability.rs"]
mod stability;

/// D's scene 3, with either of its lights.
const SCENES: [(&str, &str); 2] = [
    ("scenes/d03_csg.scene", "a light of 10 × 10 points (fig. 47)"),
    ("scenes/d03_point_light.scene", "a point (fig. 48)"),
];

fn main() -> Result {
    let lesson = Lesson::without_essay(10)?;
    let (seed, size) = (lesson.seed(), lesson.pick([24, 96, 256, 512]));
    let (small, samples) = (lesson.pick([20, 130, 300, 420]), lesson.pick([1, 4, 16, 16]));

    // 1. The truth: all ends of all leaves in one list, and the table on the whole tree after each.
    lesson.save("table", diagrams::table())?;
    lesson.save("tree", diagrams::tree(small, samples))?;
    lesson.save("operations", diagrams::operations(2 * small, samples))?;
    lesson.save("roots", diagrams::roots(3 * small, samples))?;

    // 2. The contestants: root diagrams, whole lists, tested points, and the printed rules.
    let cases = cases::cases(size);
    let rays = lesson.pick([16, 48, 128, 256]);
    let contest = charts::contest(rays, lesson.pick([6, 10, 24, 48]));
    let turns = lesson.pick([48, 600, 4000, 16000]);
    let coincident = stability::over_distance(seed, turns);

    // 3. The figures.
    lesson.save("speed_accuracy", charts::speed(&contest, rays))?;
    lesson.save("lists", diagrams::lists())?;
    lesson.save("pair_rules", cases::pictures(&cases, small, samples))?;
    lesson.save("wrong_pixels", cases::table(&cases, size))?;
    lesson.save("coincident", stability::chart(&coincident, turns))?;
    lesson.save("cap", stability::pictures(seed, 2 * small, samples))?;
    lesson.save("scene_3", scene_3(2 * small)?)?;

    // 4. What the figures show, checked.
    let false_caps = coincident.each_ref().map(|(_, series)| series.failures());
    lesson.claim(
        &format!("Of 5 solids D's rules break {}; root diagrams draw all of them right.", broken(&cases)),
        cases.iter().all(|c| c.diagram == 0 && c.printed > 0),
    );
    lesson.claim(
        &format!("In trees of up to 127 leaves the default has {} wrong pixels.", charts::wrong(&contest, 0)),
        charts::wrong(&contest, 0) == 0 && charts::wrong(&contest, 3) > 0,
    );
    lesson.claim(
        &format!(
            "Of {} rays into a flush pocket, {} see a lid where ties are exact, {} where they are derived.",
            false_caps[0].of,
            false_caps[1].total(),
            false_caps[0].total()
        ),
        false_caps[0].total() == 0 && false_caps[1].total() > 0,
    );
    lesson.answer(&answer(&cases, &contest, false_caps[1].share()))
}

fn broken(cases: &[cases::Case]) -> usize {
    cases.iter().filter(|c| c.printed > 0).count()
}

/// [D figures 47, 48].
fn scene_3(size: usize) -> Result<Figure> {
    let mut panels = Panels::new()
        .columns(2)
        .title("D's scene 3: the solid of figure 17 in the open room")
        .subtitle("after D, fig. 47 and 48; its tree is read from a .csg file")
        .alt("Two pictures of a white rounded box with tunnels that floats in a red and green room, with a soft and a hard shadow.");
    for (path, label) in SCENES {
        let whole = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
        let file = read_file(&whole).map_err(|e| LessonError(e.render(Color::Never)))?;
        let picture = Picture { width: size, height: size, samples: 1, seed: 0 };
        let image = render(&file.scene, &Local::default(), picture).image;
        panels = panels.picture(Pixels::from(&image), label);
    }
    Ok(Figure::from(panels).caption(
        "After D, figures 47 and 48: scene 3 with its area light and with its point light. D's sizes of the solids are not printed; \
         these are ours.",
    ))
}

fn answer(cases: &[cases::Case], contest: &charts::Contest, lids: f64) -> String {
    let time = |way: usize, tree: usize| contest[way].1.points[tree].time.map_or(f64::NAN, |t| t.mid * 1e9);
    format!(
        "each solid gives its sorted spans, and a node merges two lists by the table, which for D's tree takes {:.0} ns a ray; looked \
         at from front to back, a tree of 127 leaves is {} times as quick as merging whole lists. Rules that delete neighbours \
         by their marks break {} of 5 solids, and ties decided to the bit put a lid on {:.0} % of a flush pocket.",
        time(0, 1),
        short((10.0 * charts::quotient(contest)).round() / 10.0),
        broken(cases),
        100.0 * lids
    )
}
