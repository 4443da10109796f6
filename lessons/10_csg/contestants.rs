//! Four ways to a first hit, and the truth that judges them.

use lightbench::csg::as_printed::as_printed;
use lightbench::csg::{Csg, Operation, Side, Tree};
use lightbench::ray::{Crossing, Ray, Span};
use lightbench::shape::Shape;

/// A way to find what a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The library's: from front to back, ties as the surfaces' errors allow.
    Diagram,
    /// Every node merges the whole lists of both operands; ends are one only if they are equal to the bit.
    Lists,
    /// Every end of every leaf, with a point tested on either side of it.
    Tested,
    AsPrinted,
}

impl Way {
    pub const ALL: [Way; 4] = [Way::Diagram, Way::Lists, Way::Tested, Way::AsPrinted];

    pub fn first(self, tree: &Tree, solid: &Csg, ray: &Ray) -> Option<f64> {
        match self {
            Way::Diagram => solid.nearest(ray, 0.0, f64::INFINITY).map(|c| c.t),
            Way::Lists => first_of(&naive_lists(tree, ray)),
            Way::Tested => naive_tested(tree, ray),
            Way::AsPrinted => as_printed(tree, ray).first().map(|m| m.crossing.t),
        }
    }
}

/// Two answers farther apart than this are different ones [m]; the solids are 4 m wide.
pub const APART: f64 = 1.0e-6;

pub fn agree(found: Option<f64>, truth: Option<f64>) -> bool {
    match (found, truth) {
        (Some(a), Some(b)) => (a - b).abs() <= APART * (1.0 + b.abs()),
        (a, b) => a == b,
    }
}

/// Every end of every leaf, with the leaf and the side behind it, in order.
fn ends(tree: &Tree, ray: &Ray) -> Vec<(Crossing, usize, Side)> {
    let (mut found, mut spans) = (Vec::new(), Vec::new());
    for (leaf, solid) in leaves(tree).iter().enumerate() {
        spans.clear();
        solid.spans(ray, &mut spans);
        found.extend(spans.iter().flat_map(|s| [(s.enter, leaf, Side::In), (s.leave, leaf, Side::Out)]));
    }
    found.sort_by(|a, b| a.0.t.total_cmp(&b.0.t));
    found
}

pub fn leaves(tree: &Tree) -> Vec<&dyn lightbench::shape::Solid> {
    match tree {
        Tree::Leaf(solid) => vec![&**solid],
        Tree::Node(_, pair) => pair.iter().flat_map(leaves).collect(),
    }
}

/// The table, applied to all leaves at once.
fn whole(tree: &Tree, sides: &mut impl Iterator<Item = Side>) -> Side {
    match tree {
        Tree::Leaf(_) => sides.next().unwrap_or(Side::Out),
        Tree::Node(operation, pair) => {
            let left = whole(&pair[0], sides);
            operation.combine(left, whole(&pair[1], sides))
        }
    }
}

/// The truth: all ends together, those closer than `APART` at once, and the table on the whole tree after each.
pub fn truth(tree: &Tree, ray: &Ray) -> Option<f64> {
    let ends = ends(tree, ray);
    let mut sides = vec![Side::Out; tree.leaves()];
    let mut before = Side::Out;
    let mut i = 0;
    while i < ends.len() {
        let t = ends[i].0.t;
        while i < ends.len() && ends[i].0.t <= t + 0.1 * APART {
            sides[ends[i].1] = ends[i].2;
            i += 1;
        }
        let after = whole(tree, &mut sides.iter().copied());
        if after != before && t > 0.0 {
            return Some(t);
        }
        before = after;
    }
    None
}

/// The textbook's merge: both lists whole, and ends that are equal to the bit change together.
pub fn naive_lists(tree: &Tree, ray: &Ray) -> Vec<Span> {
    let (operation, pair) = match tree {
        Tree::Leaf(solid) => {
            let mut spans = Vec::new();
            solid.spans(ray, &mut spans);
            return spans;
        }
        Tree::Node(operation, pair) => (*operation, pair),
    };
    merge(operation, &naive_lists(&pair[0], ray), &naive_lists(&pair[1], ray))
}

fn merge(operation: Operation, left: &[Span], right: &[Span]) -> Vec<Span> {
    let flat = |spans: &[Span]| -> Vec<(Crossing, Side)> {
        spans.iter().flat_map(|s| [(s.enter, Side::In), (s.leave, Side::Out)]).collect()
    };
    let (left, right) = (flat(left), flat(right));
    let (mut i, mut j, mut sides, mut before) = (0, 0, (Side::Out, Side::Out), Side::Out);
    let (mut spans, mut enter) = (Vec::new(), None);
    while i < left.len() || j < right.len() {
        let t = |list: &[(Crossing, Side)], k: usize| list.get(k).map_or(f64::INFINITY, |e| e.0.t);
        let (l, r) = (t(&left, i), t(&right, j));
        let here = if l <= r { left[i].0 } else { right[j].0 };
        if l <= r {
            sides.0 = left[i].1;
            i += 1;
        }
        if r <= l {
            sides.1 = right[j].1;
            j += 1;
        }
        let after = operation.combine(sides.0, sides.1);
        match (before, after) {
            (Side::Out, Side::In) => enter = Some(here),
            (Side::In, Side::Out) => spans.extend(enter.take().map(|enter| Span { enter, leave: here })),
            _ => {}
        }
        before = after;
    }
    spans
}

pub fn first_of(spans: &[Span]) -> Option<f64> {
    spans.iter().flat_map(|s| [s.enter.t, s.leave.t]).find(|&t| t > 0.0)
}

/// Every end in turn: is the whole on the other side behind it than before it?
fn naive_tested(tree: &Tree, ray: &Ray) -> Option<f64> {
    let leaves = leaves(tree);
    let at = |t: f64| {
        let p = ray.at(t);
        let mut sides = leaves.iter().map(|s| if s.contains(p) { Side::In } else { Side::Out });
        whole(tree, &mut sides)
    };
    let ends: Vec<f64> = ends(tree, ray).iter().map(|e| e.0.t).collect();
    (0..ends.len()).filter(|&i| ends[i] > 0.0).map(|i| (i, ends[i])).find_map(|(i, t)| {
        let before = if i == 0 { t - 1.0 } else { 0.5 * (ends[i - 1] + t) };
        let after = ends.get(i + 1).map_or(t + 1.0, |next| 0.5 * (t + next));
        (at(before) != at(after)).then_some(t)
    })
}
