//! Lesson 12. How does a ray find the nearest of a million things, and from how many on does it pay to ask?
//!
//! Builds on:  04 (the watertight triangle), 11 (meshes).
//! New here:   bounding volumes, octrees, hierarchies of boxes; tests and visits as counts; the slab test and its NaN.
//! Notation:   n triangles; t ray parameter [lengths of the direction]; d/r distance over size.
//! Predict:    a mesh grows from a thousand triangles to a million. By what factor does a ray slow down?
//! Figure:     12_nearest_of_many_scaling_time.svg

use lightbench::measure::{Method, log_spaced};
use lightbench_kit::figure::grouped;
use lightbench_kit::lesson::{Lesson, Result};

#[path = "12_nearest_of_many/charts.rs"]
mod charts;
#[path = "12_nearest_of_many/contest.rs"]
mod contest;
#[path = "12_nearest_of_many/diagrams.rs"]
mod diagrams;
#[path = "12_nearest_of_many/hostile.rs"]
mod hostile;
#[path = "12_nearest_of_many/pictures.rs"]
mod pictures;
#[path = "12_nearest_of_many/share.rs"]
mod share;
#[path = "12_nearest_of_many/threshold.rs"]
mod threshold;
#[path = "12_nearest_of_many/trees.rs"]
mod trees;
use contest::{Kind, Outcome};

fn main() -> Result {
    let lesson = Lesson::without_essay(12)?;
    let (seed, most) = (lesson.seed(), lesson.pick([1.0e3f64, 1.0e5, 1.0e6, 1.0e6]));

    // 1. The truth: every triangle tested by every ray. Structures may only leave out what changes nothing.
    lesson.save("hulls", diagrams::hulls()?)?;
    lesson.save("quadtree", trees::quadtree())?;
    lesson.save("flattened", trees::flattened())?;

    // 2. The contestants: from nothing to a hierarchy, over hills of ten to a million triangles.
    let contest = [
        (Method::default_of("hierarchy, eight triangles a leaf").styled(0), Kind::Facets),
        (Method::new("hierarchy, one box each").styled(4), Kind::Bvh),
        (Method::new("octree, D's 300 a cube").styled(1), Kind::Threshold),
        (Method::as_printed("octree and search as A prints them"), Kind::Printed),
        (Method::new("a box round each").styled(2), Kind::Hulls),
        (Method::new("nothing").styled(5), Kind::Nothing),
    ];
    let decades = most.log10() as usize;
    let sizes: Vec<usize> = log_spaced(10.0, most, decades).iter().map(|n| n.round() as usize).collect();
    let outcomes: Vec<(Method, Vec<Outcome>)> =
        contest.map(|(m, kind)| (m, contest::sweep(seed, &sizes, kind))).into();

    // 3. The figures.
    lesson.save("scaling", charts::scaling(&outcomes))?;
    lesson.save("work", charts::work(&outcomes))?;
    lesson.save("build", charts::build(&outcomes))?;
    lesson.save("memory", charts::memory(&outcomes))?;
    let table = threshold::measure(lesson.pick([(100, 10), (1000, 35), (1000, 35), (1000, 35)]));
    lesson.save("table1", threshold::table(&table))?;
    lesson.save("threshold_cubes", threshold::cubes(&table))?;
    lesson.save("threshold", threshold::time(&table))?;
    lesson.save("share", share::figure(lesson.pick([8, 64, 96, 128])))?;
    lesson.save("printed_search", hostile::printed_search(seed, lesson.pick([50, 400, 2000, 10_000])))?;
    let slabs = hostile::slabs(seed, lesson.pick([500, 5_000, 50_000, 500_000]));
    lesson.save("slabs", hostile::table(&slabs))?;
    lesson.save("failures", hostile::map(seed, lesson.pick([(12, 16), (48, 256), (72, 256), (96, 512)])))?;
    pictures::save(&lesson)?;

    // 4. What the figures show, checked.
    let wrong = |k: usize| outcomes[k].1.iter().map(|o| o.wrong).sum::<usize>();
    let asked = outcomes[0].1.iter().map(|o| o.asked).sum::<usize>();
    lesson.claim(
        &format!(
            "Of {} answers hierarchy, octree and boxes change none, to the bit.",
            grouped(4 * asked as u64)
        ),
        [0, 1, 2, 4].into_iter().all(|k| wrong(k) == 0),
    );
    let [first, last] = [0, sizes.len() - 1].map(|i| outcomes[0].1[i].looks);
    lesson.claim(
        &format!(
            "{} × the triangles cost {:.1} × the looks, boxes and triangles together.",
            grouped((outcomes[0].1[sizes.len() - 1].n / outcomes[0].1[0].n) as u64),
            last / first
        ),
        last < first * (1.0 + (most / 10.0).log2()),
    );
    let (ours, naive) = slabs.iter().fold((0, 0), |(a, b), s| (a + s.lost[2], b + s.lost[0]));
    lesson.claim(
        &format!("Of hostile rays the careless slab test loses {naive} boxes, ours none."),
        ours == 0 && naive > 0,
    );
    lesson.answer(&answer(&outcomes))
}

fn answer(outcomes: &[(Method, Vec<Outcome>)]) -> String {
    let at = outcomes[0].1.len() - 1;
    let n = grouped(outcomes[0].1[at].n as u64);
    let ns = |k: usize| outcomes[k].1[at].time.map_or(f64::NAN, |t| t.mid * 1.0e9);
    let looks = |k: usize| outcomes[k].1[at].looks;
    format!(
        "by a hierarchy of boxes: among {} triangles a ray looks at {:.1} boxes and triangles instead of {}, and takes {:.0} ns \
         (an octree with D's threshold {:.0} ns, {:.0} looks); five spheres need none, and get none",
        n,
        looks(0),
        n,
        ns(0),
        ns(2),
        looks(2),
    )
}
