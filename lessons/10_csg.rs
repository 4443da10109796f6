//! Lesson 10. How does a ray find its way through solids made of solids, and which rules break?
//!
//! Builds on:  03 (a scene, a light, a picture), 04 (rays along faces), 07 (a shape under a map).
//! New here:   trees of solids; spans and root diagrams; coincident faces; rules that look at neighbours alone.
//! Notation:   t ray parameter [m]; ∪, ∩, − union, intersection, difference; IN and OUT the sides of a surface.
//! Read next:  src/csg/walk.rs, src/csg/mod.rs
//! Figure:     10_csg_coincident.svg, 10_csg_roots.svg

use lightbench_kit::figure::{grouped, percent};
use lightbench_kit::lesson::{Lesson, Result};
use lightbench_kit::stage::RenderSize;
use std::cell::LazyCell;

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

fn main() -> Result {
    let lesson = Lesson::open(10, include_str!("10_csg.md"))?;
    let (seed, size) = (lesson.seed(), lesson.pick([24, 96, 256, 512]));
    let (small, samples) = (lesson.pick([20, 90, 210, 420]), lesson.pick([1, 1, 4, 16]));

    // 1. The truth: all ends of all leaves in one list, and the table on the whole tree after each.
    // 2. The contestants: root diagrams, whole lists, tested ends, and the printed rules.
    let cases = LazyCell::new(|| cases::cases(size));
    let rays = lesson.pick([16, 40, 128, 256]);
    let contest = LazyCell::new(|| charts::contest(rays, lesson.pick([6, 8, 24, 48])));
    let turns = lesson.pick([48, 300, 4000, 16000]);
    let coincident = LazyCell::new(|| stability::over_distance(seed, turns));

    // 3. The figures, and the numbers that the essay quotes.
    lesson.figure("operations", || Ok(diagrams::operations(lesson.pick([40, 180, 360, 640]), samples)))?;
    lesson.figure("roots", || Ok(diagrams::roots(lesson.pick([60, 200, 630, 900]), samples)))?;
    lesson.picture("hero", || {
        let usual = RenderSize::hero(lesson.quality(), seed);
        let (width, height) = lesson.size(lesson.pick([(80, 50), (400, 250), (1600, 1000), (1600, 1000)]));
        Ok(solids::hero(&RenderSize { width, height, ..usual }))
    })?;
    lesson.figure("speed_accuracy", || Ok(charts::speed(&contest, rays)))?;
    lesson.figure("cap", || Ok(stability::pictures(seed, lesson.pick([40, 260, 560, 800]), samples)))?;
    lesson.figure("coincident", || Ok(stability::chart(&*coincident, turns)))?;
    lesson.figure("tree", || Ok(diagrams::tree(small, samples)))?;
    lesson.table("table", || Ok(diagrams::table()))?;
    lesson.figure("lists", || Ok(diagrams::lists()))?;
    lesson.figure("pair_rules", || Ok(cases::pictures(&cases, small, samples)))?;
    lesson.figure("scene_3", || solids::scene_3(lesson.pick([40, 180, 500, 800])))?;

    lesson.value("leaves", || charts::largest(&contest));
    lesson.value("wrong_printed", || charts::wrong(&contest, "as printed"));
    lesson.value("wrong_of", || grouped(charts::asked(&contest)));
    lesson.value("time", || charts::slower().words(1.0));
    lesson.value("printed_broken", || format!("{} of {}", broken(&cases), cases.len()));
    lesson.value("pocket_rays", || grouped(stability::of(&coincident, "equal bit for bit").failures().of));
    lesson.value("lids", || percent(stability::of(&coincident, "equal bit for bit").failures().share()));
    lesson.value("lids_default", || stability::of(&coincident, "ties by rounding bounds").failures().total());
    lesson.value("lids_fixed", || {
        stability::first_lid(stability::of(&coincident, "spans under 10⁻⁹ m dropped"))
    });

    // 4. What the figures show, checked.
    lesson.claim("the printed pair rules break every one of five solids, root diagrams none", || {
        cases.iter().all(|c| c.diagram == 0 && c.printed > 0)
    });
    lesson.claim("root diagrams get every pixel right in trees of up to 127 leaves", || {
        charts::wrong(&contest, "root diagram, front to back") == 0
            && charts::wrong(&contest, "as printed") > 0
    });
    lesson.claim("ties decided by rounding bounds put no lid on a flush pocket, exact ties do", || {
        stability::of(&coincident, "ties by rounding bounds").failures().total() == 0
            && stability::of(&coincident, "equal bit for bit").failures().total() > 0
    });
    lesson.close()
}

fn broken(cases: &[cases::Case]) -> usize {
    cases.iter().filter(|c| c.printed > 0).count()
}
