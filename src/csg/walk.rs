//! The root diagram of one ray, drawn from front to back and no farther than somebody looks.
//!
//! Every node keeps the side on which the ray is now, and what it knows of its next boundary: a value of `t` before
//! which there is none (where the ray enters the bounds), or the boundary itself. A node merges the boundaries of its
//! two operands in their order by the table of A's ill. 61. An operand that decides alone (an empty factor, a filled
//! summand) is followed, and the other one brought up to it without looking at what lies between: so leaves behind
//! the first hit, and leaves whose bounds the ray misses, are never intersected.
//!
//! **Ties.** Boundaries of the two operands that cannot be told apart count as one event: both sides change at once, so
//! that coincident faces cancel or merge (regularised set operations), and the surface is that of the leaf written first.
//! Boundaries `a`, `b` are the same if
//!
//! ```text
//! |t_a − t_b| ≤ e_a/|d·n_a| + e_b/|d·n_b|,    e = error of the surface's point + γ₆₄ (|o| + |t d|)
//! ```
//!
//! where a shape vouches for the error of its points, and every shape finds `t` to within 64 roundings of the ray's reach,
//! measured along the normal.

use super::{Csg, Operation, Side, What};
use crate::num::gamma;
use crate::ray::{Crossing, Ray, Span};
use glam::DVec3;
use std::cell::RefCell;

/// Boundaries farther apart than this share of `|o|/|d| + |t|` are no tie, and nobody looks closer.
///
/// It covers slants down to 64 u / 2⁻²⁰ ≈ 10⁻⁸ rad; more grazing coincident faces are one pixel in 10¹⁰.
const COARSE: f64 = 1.0 / (1u64 << 20) as f64;

/// Memory that a thread keeps from ray to ray.
#[derive(Default)]
struct Scratch {
    states: Vec<State>,
    spans: Vec<Span>,
    /// Walks so far: states of earlier ones are void.
    walks: u64,
}

thread_local! {
    /// As many as there are trees inside one another.
    static SCRATCH: RefCell<Vec<Scratch>> = const { RefCell::new(Vec::new()) };
}

/// What a node knows of its next boundary.
#[derive(Clone, Copy, Debug)]
enum Ahead {
    NotBefore(f64),
    At(Crossing),
    Never,
}

impl Ahead {
    #[inline]
    fn time(&self) -> f64 {
        match self {
            Ahead::NotBefore(t) => *t,
            Ahead::At(c) => c.t,
            Ahead::Never => f64::INFINITY,
        }
    }
}

/// A node on the way along the ray.
#[derive(Clone, Copy, Debug)]
struct State {
    walk: u64,
    /// Where the ray is, up to the next boundary.
    side: Side,
    ahead: Ahead,
    /// Where the ray leaves the bounds.
    until: f64,
    /// Of a leaf: its next end among all ends of spans, and the one after its last.
    next: u32,
    end: u32,
}

/// One ray on its way through one tree.
pub(super) struct Walk<'a> {
    csg: &'a Csg,
    ray: &'a Ray,
    inv_direction: DVec3,
    /// Nobody asks for boundaries before `low` or after `high`.
    low: f64,
    high: f64,
    /// `|o|/|d|`.
    reach: f64,
    scratch: &'a mut Scratch,
}

/// Lets `look` walk along the ray; boundaries are right from `t_min` to `t_max`.
pub(super) fn walk<T>(csg: &Csg, ray: &Ray, t_min: f64, t_max: f64, look: impl FnOnce(&mut Walk) -> T) -> T {
    let mut scratch = SCRATCH.with_borrow_mut(Vec::pop).unwrap_or_default();
    scratch.spans.clear();
    scratch.walks += 1;
    if scratch.states.len() < csg.nodes.len() {
        let void =
            State { walk: 0, side: Side::Out, ahead: Ahead::Never, until: f64::INFINITY, next: 0, end: 0 };
        scratch.states.resize(csg.nodes.len(), void);
    }
    let reach = ray.origin.abs().max_element() / ray.direction.abs().max_element();
    let mut walk = Walk {
        csg,
        ray,
        inv_direction: ray.direction.recip(),
        low: t_min,
        high: t_max,
        reach,
        scratch: &mut scratch,
    };
    walk.low -= walk.slack(t_min);
    walk.high += walk.slack(t_max);
    let found = look(&mut walk);
    SCRATCH.with_borrow_mut(|all| all.push(scratch));
    found
}

impl Walk<'_> {
    /// The next boundary of the whole solid; the walk goes on behind it.
    #[inline]
    pub(super) fn next(&mut self) -> Option<Crossing> {
        let root = self.csg.root();
        match self.resolve(root) {
            Ahead::At(crossing) => {
                self.advance(root);
                Some(crossing)
            }
            _ => None,
        }
    }

    /// A distance [t] within which boundaries may be ties.
    #[inline]
    fn slack(&self, t: f64) -> f64 {
        COARSE * (self.reach + t.abs())
    }

    #[inline]
    fn view(&mut self, node: usize) -> (Side, Ahead) {
        let state = &self.scratch.states[node];
        if state.walk == self.scratch.walks { (state.side, state.ahead) } else { self.open(node) }
    }

    /// The first look at a node is at its bounds.
    fn open(&mut self, node: usize) -> (Side, Ahead) {
        let bounds = &self.csg.nodes[node].bounds;
        let (ahead, until) = match bounds.slab(self.ray.origin, self.inv_direction, self.low, self.high) {
            Some((t0, t1)) => (Ahead::NotBefore(t0 - self.slack(t0)), t1 + self.slack(t1)),
            None => (Ahead::Never, f64::NEG_INFINITY),
        };
        let walk = self.scratch.walks;
        self.scratch.states[node] = State { walk, side: Side::Out, ahead, until, next: 0, end: 0 };
        (Side::Out, ahead)
    }

    /// The node's next boundary, or that there is none.
    fn resolve(&mut self, node: usize) -> Ahead {
        let (_, ahead) = self.view(node);
        if !matches!(ahead, Ahead::NotBefore(_)) {
            return ahead;
        }
        let found = match self.csg.nodes[node].what {
            What::Leaf(leaf) => self.intersect(node, leaf),
            What::Pair(operation, left, right) => self.merge(node, operation, left as usize, right as usize),
        };
        self.scratch.states[node].ahead = found;
        found
    }

    /// All ends of a leaf's spans from now on.
    fn intersect(&mut self, node: usize, leaf: u32) -> Ahead {
        let spans = &mut self.scratch.spans;
        let first = spans.len();
        self.csg.leaves[leaf as usize].solid.spans(self.ray, spans);
        let passed = spans[first..].iter().take_while(|span| span.leave.t < self.low).count();
        let state = &mut self.scratch.states[node];
        (state.next, state.end) = (2 * (first + passed) as u32, 2 * spans.len() as u32);
        self.end_of_span(node, leaf)
    }

    /// A leaf's next boundary; the end of an endless span is none.
    #[inline]
    fn end_of_span(&self, node: usize, leaf: u32) -> Ahead {
        let State { next, end, .. } = self.scratch.states[node];
        if next >= end {
            return Ahead::Never;
        }
        let Span { enter, leave } = self.scratch.spans[next as usize / 2];
        let mut crossing = if next % 2 == 0 { enter } else { leave };
        if crossing.t == f64::INFINITY {
            return Ahead::Never;
        }
        crossing.part += self.csg.leaves[leaf as usize].first_part;
        Ahead::At(crossing)
    }

    /// Goes behind the boundary that the node has found.
    fn advance(&mut self, node: usize) {
        let state = &mut self.scratch.states[node];
        state.side = state.side.other();
        state.next += 1;
        let t = state.ahead.time();
        self.scratch.states[node].ahead = match self.csg.nodes[node].what {
            What::Leaf(leaf) => self.end_of_span(node, leaf),
            What::Pair(..) => Ahead::NotBefore(t),
        };
    }

    /// The next place where the operands' sides combine to the other side.
    fn merge(&mut self, node: usize, operation: Operation, left: usize, right: usize) -> Ahead {
        let before = self.scratch.states[node].side;
        loop {
            let ((l_side, l), (r_side, r)) = (self.view(left), self.view(right));
            let decided = (operation.left_decides(l_side), operation.right_decides(r_side));
            // Nothing happens until the operand that decides changes; until both do, if both decide.
            let left_leads = match decided {
                (true, false) => true,
                (false, true) => false,
                (true, true) => l.time() >= r.time(),
                (false, false) => l.time() <= r.time(),
            };
            let (lead, other, ahead) = if left_leads { (left, right, l) } else { (right, left, r) };
            let crossing = match ahead {
                Ahead::Never => return Ahead::Never,
                _ if ahead.time() > self.high => return Ahead::Never,
                Ahead::NotBefore(_) => {
                    self.resolve(lead);
                    continue;
                }
                Ahead::At(crossing) => crossing,
            };
            if decided != (false, false) {
                self.seek(other, &crossing);
            }
            let tie = match self.view(other).1 {
                Ahead::NotBefore(t) if !(t > crossing.t + self.slack(crossing.t)) => {
                    self.resolve(other);
                    continue;
                }
                Ahead::At(also) if self.tied(&crossing, &also) => Some(also),
                _ => None,
            };
            self.advance(lead);
            if tie.is_some() {
                self.advance(other);
            }
            let (l_side, r_side) = (self.scratch.states[left].side, self.scratch.states[right].side);
            if operation.combine(l_side, r_side) != before {
                return Ahead::At(tie.map_or(crossing, |also| one_of(crossing, also)));
            }
        }
    }

    /// Goes over every boundary of the node that lies before `mark` and is no tie with it.
    fn seek(&mut self, node: usize, mark: &Crossing) {
        loop {
            let slack = self.slack(mark.t);
            match self.view(node).1 {
                Ahead::Never => return,
                Ahead::At(found) if found.t < mark.t && !self.tied(&found, mark) => self.advance(node),
                Ahead::At(_) => return,
                Ahead::NotBefore(t) if t > mark.t + slack => return,
                Ahead::NotBefore(_) if self.scratch.states[node].until < mark.t - slack => {
                    let state = &mut self.scratch.states[node];
                    (state.side, state.ahead) = (Side::Out, Ahead::Never);
                    return;
                }
                Ahead::NotBefore(_) => match self.csg.nodes[node].what {
                    What::Leaf(_) => {
                        self.resolve(node);
                    }
                    What::Pair(operation, left, right) => {
                        self.seek_operands(node, operation, [left as usize, right as usize], mark);
                        return;
                    }
                },
            }
        }
    }

    /// Brings the operands, as far as they matter, up to the mark.
    fn seek_operands(&mut self, node: usize, operation: Operation, of: [usize; 2], mark: &Crossing) {
        self.seek(of[0], mark);
        let (l_side, l) = self.view(of[0]);
        let (side, next) = if operation.left_decides(l_side) {
            (operation.combine(l_side, Side::Out), l)
        } else {
            self.seek(of[1], mark);
            let (r_side, r) = self.view(of[1]);
            let right_is_next = operation.right_decides(r_side) || r.time() < l.time();
            (operation.combine(l_side, r_side), if right_is_next { r } else { l })
        };
        let state = &mut self.scratch.states[node];
        state.side = side;
        state.ahead = match next {
            Ahead::Never => Ahead::Never,
            next => Ahead::NotBefore(next.time()),
        };
    }

    /// Are the two boundaries one, for all that the surfaces' errors tell?
    #[inline]
    fn tied(&self, a: &Crossing, b: &Crossing) -> bool {
        let gap = (a.t - b.t).abs();
        a.t == b.t || (gap <= self.slack(a.t) && gap <= self.doubt(a) + self.doubt(b))
    }

    /// How far along the ray [t] the boundary may lie from where the exact surface has it.
    ///
    /// An instance moves ray and surface by its own roundings, which grow with the reach of the ray as the error of its
    /// point grows with the point: hence the factor.
    #[cold]
    fn doubt(&self, crossing: &Crossing) -> f64 {
        let Ray { origin, direction } = *self.ray;
        let reach = origin.abs().max_element() + (direction * crossing.t).abs().max_element();
        let hit = self.csg.hit_of_leaf(self.ray, crossing);
        let far = (reach / hit.point.abs().max_element()).clamp(1.0, MOST_FAR);
        let error = hit.point_error * far + gamma(64) * reach;
        error / direction.dot(hit.ng).abs()
    }
}

/// A point near the origin of space does not make its surface doubtful without bound.
const MOST_FAR: f64 = (1u64 << 20) as f64;

/// Of two boundaries that are one: the nearer place, on the leaf that is written first.
fn one_of(a: Crossing, b: Crossing) -> Crossing {
    let first = if a.part <= b.part { a } else { b };
    Crossing { t: a.t.min(b.t), ..first }
}
