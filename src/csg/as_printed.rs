//! The list of intersections as D processes it: right for two convex solids that overlap, and wrong beyond.
//!
//! D sorts the ends of both operands into one list, each marked IN or OUT (turned for what is taken away), drops those behind
//! the ray's origin, gives up on an odd count, and deletes pairs of neighbours by a rule for each operation. The rules
//! look at marks and never at whose they are; the root diagram looks at both sides at once
//! ([`Operation::combine`](super::Operation::combine)).

use super::{Operation, Side, Tree};
use crate::ray::{Crossing, Ray};

/// An intersection in D's list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Its `part` is the number of the leaf, as written.
    pub crossing: Crossing,
    /// What the ray does there: comes `In`, or goes `Out`.
    pub to: Side,
    /// Was the normal turned?
    pub turned: bool,
}

/// The list that D keeps for the whole tree; its first mark is what the ray meets.
///
/// - Domain: every leaf gives both ends of each span, also those behind the origin.
/// - Source: [D §5.9.1.6], with each deletion repeated until no such pair is left.
pub fn as_printed(tree: &Tree, ray: &Ray) -> Vec<Mark> {
    let mut list = node(tree, ray, &mut 0);
    list.retain(|m| m.crossing.t > 0.0); // a leaf alone goes through no node
    list
}

fn node(tree: &Tree, ray: &Ray, leaves: &mut u32) -> Vec<Mark> {
    let (operation, [left, right]) = match tree {
        Tree::Leaf(solid) => {
            let mut spans = Vec::new();
            solid.spans(ray, &mut spans);
            let part = *leaves;
            *leaves += 1;
            let mark = |c: Crossing, to| Mark { crossing: Crossing { part, ..c }, to, turned: false };
            return spans.iter().flat_map(|s| [mark(s.enter, Side::In), mark(s.leave, Side::Out)]).collect();
        }
        Tree::Node(operation, pair) => (*operation, &**pair),
    };
    let mut list = node(left, ray, leaves);
    let mut other = node(right, ray, leaves);
    if operation == Operation::Difference {
        other.iter_mut().for_each(|m| (m.to, m.turned) = (m.to.other(), !m.turned));
    }
    match (list.is_empty(), other.is_empty(), operation) {
        (false, false, _) => {}
        (_, true, Operation::Union | Operation::Difference) => return list,
        (true, _, Operation::Union) => return other,
        _ => return Vec::new(),
    }
    list.append(&mut other);
    list.sort_by(|a, b| a.crossing.t.total_cmp(&b.crossing.t));
    list.retain(|m| m.crossing.t > 0.0);
    if list.len() % 2 == 1 {
        return Vec::new();
    }
    while delete_a_pair(operation, &mut list) {}
    list
}

/// Applies the first rule that fits; is there anything left to do?
fn delete_a_pair(operation: Operation, list: &mut Vec<Mark>) -> bool {
    use Side::{In, Out};
    for i in 1..list.len() {
        let gone = match (operation, list[i - 1].to, list[i].to) {
            (Operation::Union, In, In) | (Operation::Intersection, Out, Out) => i..i + 1,
            (Operation::Union, Out, Out) | (Operation::Intersection, In, In) => i - 1..i,
            (Operation::Difference, Out, In) => i - 1..i + 1,
            _ => continue,
        };
        list.drain(gone);
        return true;
    }
    false
}
