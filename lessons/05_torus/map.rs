//! Where each method fails, over distance and thickness.

use super::rays::{Question, question, turns};
use super::{CLOSE, DISTANCE, RATIO, figures, measured};
use lightbench::shape::torus::TorusMethod;
use lightbench_kit::figure::{Axis, FailureMap, Figure};
use lightbench_kit::lesson::Lesson;

/// Columns, rows, and the questions of each cell, row by row.
pub type Cells = ((usize, usize), Vec<Vec<Question>>);

fn axes() -> [Axis; 2] {
    let across = Axis::log("distance of the origin D/a").range(DISTANCE.start, DISTANCE.end);
    [across, Axis::log("thickness b/a").range(RATIO.start, RATIO.end)]
}

pub fn cells(lesson: &Lesson) -> Cells {
    let size = lesson.pick([(8, 6), (32, 22), (80, 56), (120, 84)]);
    let (mut questions, [across, up]) = (Vec::new(), axes());
    let ask = |distance, ratio| {
        (0..8).map(|i| question(lesson.seed(), i, (ratio, distance), turns(i, CLOSE))).collect()
    };
    FailureMap::new(across, up, "", size, |distance, ratio| {
        questions.push(ask(distance, ratio));
        None
    });
    (size, questions)
}

pub fn failures((size, questions): &Cells, method: TorusMethod) -> Figure {
    let (mut of_cells, [across, up]) = (questions.iter(), axes());
    let cell = |_, _| {
        let point = measured(of_cells.next()?, method, 1.0);
        (point.failures.total() == 0).then_some(point.error.map_or(0.0, |e| e.mid))
    };
    figures::failure_words(FailureMap::new(across, up, "error of t, in a", *size, cell), method)
}
