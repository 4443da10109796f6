//! Root diagrams.

use super::{Cell, Row, RowError, Topic, cells_of};
use crate::csg::as_printed::as_printed;
use crate::csg::{Csg, Operation, Side, Tree};
use crate::ray::{Crossing, Ray};
use crate::shape::cuboid::Cuboid;
use crate::shape::cylinder::Cylinder;
use crate::shape::sphere::Sphere;
use crate::shape::{Shape, ShapeError, Solid};
use glam::DVec3;

pub(super) const CSG: Topic = Topic {
    name: "csg",
    about: "the whole line o + t d against a solid such as (diff (sphere cx cy cz r) (box x0 y0 z0 x1 y1 z1)); \
            also (cyl p0 p1 r), (union a b ...), (inter a b ...)",
    methods: &[
        ("root_diagram", "operands merged side by side, ties as the surfaces' errors allow"),
        (
            "as_printed",
            "pairs of neighbours deleted by their marks, as [D 5.9.1.6] prints it; spans for t > 0",
        ),
    ],
    inputs: &[
        ("expr", "lengths"),
        ("ox", "length"),
        ("oy", "length"),
        ("oz", "length"),
        ("dx", "any length but zero"),
        ("dy", "any length but zero"),
        ("dz", "any length but zero"),
    ],
    outputs: &[
        ("spans", "enter:leave of each, lengths of d"),
        ("first_hit", "first t > 0, lengths of d"),
        ("nx", "outward unit normal there"),
        ("ny", "outward unit normal there"),
        ("nz", "outward unit normal there"),
    ],
    answer: csg,
};

fn csg(row: &Row, method: &str) -> Result<Vec<Cell>, RowError> {
    let ray = row.ray()?;
    let mut words = Words { rest: row.text("expr") };
    let wrong = |expected: String| row.error("expr", &expected);
    let tree = words.tree(0).map_err(wrong)?;
    if !words.rest.trim().is_empty() {
        return Err(wrong("one solid and nothing after it".to_string()));
    }
    let (spans, first, normal) = match method {
        "as_printed" => printed(&tree, &ray),
        _ => merged(&Csg::new(tree).map_err(|e| wrong(format!("a solid ({e})")))?, &ray),
    };
    let spans: Vec<String> = spans.iter().map(|(a, b)| format!("{a}:{b}")).collect();
    let mut cells = vec![Cell::Text(spans.join(";")), first.into()];
    cells.extend(cells_of(normal));
    Ok(cells)
}

type Answer = (Vec<(f64, f64)>, Option<f64>, Option<DVec3>);

fn merged(solid: &Csg, ray: &Ray) -> Answer {
    let mut spans = Vec::new();
    solid.spans(ray, &mut spans);
    let first = solid.nearest(ray, 0.0, f64::INFINITY);
    let normal = first.map(|c| solid.hit(ray, &c).ng);
    (spans.iter().map(|s| (s.enter.t, s.leave.t)).collect(), first.map(|c| c.t), normal)
}

fn printed(tree: &Tree, ray: &Ray) -> Answer {
    let marks = as_printed(tree, ray);
    let mut leaves = Vec::new();
    number(tree, &mut leaves);
    let spans = marks.windows(2).filter(|w| w[0].to == Side::In && w[1].to == Side::Out);
    let normal = marks.first().map(|m| {
        let n = leaves[m.crossing.part as usize].hit(ray, &Crossing { part: 0, ..m.crossing }).ng;
        if m.turned { -n } else { n }
    });
    let spans = spans.map(|w| (w[0].crossing.t, w[1].crossing.t)).collect();
    (spans, marks.first().map(|m| m.crossing.t), normal)
}

/// The leaves as written.
fn number<'a>(tree: &'a Tree, leaves: &mut Vec<&'a dyn Solid>) {
    match tree {
        Tree::Leaf(solid) => leaves.push(&**solid),
        Tree::Node(_, pair) => pair.iter().for_each(|tree| number(tree, leaves)),
    }
}

/// What is left to read of an expression.
struct Words<'a> {
    rest: &'a str,
}

/// Most parentheses inside one another.
const DEEPEST: usize = 4096;

impl<'a> Words<'a> {
    /// The next parenthesis, or everything up to the next parenthesis or space; empty at the end.
    fn next(&mut self) -> &'a str {
        let text = self.rest.trim_start();
        let end = match text.find(|c: char| c.is_whitespace() || c == '(' || c == ')') {
            Some(0) => 1,
            Some(n) => n,
            None => text.len(),
        };
        let (word, rest) = text.split_at(end);
        self.rest = rest;
        word
    }

    fn is_next(&self, word: char) -> bool {
        self.rest.trim_start().starts_with(word)
    }

    fn expect(&mut self, word: &str) -> Result<(), String> {
        if self.next() == word { Ok(()) } else { Err(format!("`{word}` in the expression")) }
    }

    fn number(&mut self) -> Result<f64, String> {
        let word = self.next();
        word.parse()
            .ok()
            .filter(|x: &f64| x.is_finite())
            .ok_or_else(|| format!("a number in place of `{word}`"))
    }

    fn vector(&mut self) -> Result<DVec3, String> {
        Ok(DVec3::new(self.number()?, self.number()?, self.number()?))
    }

    fn tree(&mut self, depth: usize) -> Result<Tree, String> {
        if depth > DEEPEST {
            return Err(format!("at most {DEEPEST} parentheses inside one another"));
        }
        self.expect("(")?;
        let solid = |e: ShapeError| format!("a solid ({e})");
        let tree = match self.next() {
            "sphere" => Tree::leaf(Sphere::new(self.vector()?, self.number()?).map_err(solid)?),
            "box" => Tree::leaf(Cuboid::new(self.vector()?, self.vector()?).map_err(solid)?),
            "cyl" => {
                Tree::leaf(Cylinder::new(self.vector()?, self.vector()?, self.number()?).map_err(solid)?)
            }
            "union" => self.operands(Operation::Union, depth)?,
            "inter" => self.operands(Operation::Intersection, depth)?,
            "diff" => self.operands(Operation::Difference, depth)?,
            other => return Err(format!("sphere, box, cyl, union, inter or diff in place of `{other}`")),
        };
        self.expect(")")?;
        Ok(tree)
    }

    fn operands(&mut self, operation: Operation, depth: usize) -> Result<Tree, String> {
        let mut operands = Vec::new();
        while self.is_next('(') {
            operands.push(self.tree(depth + 1)?);
        }
        Tree::all(operation, operands).ok_or_else(|| "at least one operand of each operation".to_string())
    }
}
