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

use super::{Csg, Node, Operation, Side, What};
use crate::num::gamma;
use crate::ray::{Crossing, Ray, Span};
use glam::DVec3;
use std::cell::RefCell;

/// Boundaries farther apart than this share of `|o|/|d| + |t|` are no tie, and nobody looks closer.
///
/// At the error of γ₆₄ it covers slants down to 64 u / 2⁻²⁰ ≈ 10⁻⁸ rad.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ahead {
    /// There is none before `State::next`.
    NotBefore,
    /// It is `State::next`.
    At,
    /// There is none: `State::next` is infinite.
    Never,
}

/// A node on the way along the ray.
#[derive(Clone, Copy, Debug)]
struct State {
    walk: u64,
    next: Crossing,
    /// Where the ray leaves the bounds.
    until: f64,
    /// Of a leaf: its next end among all ends of spans, and the one after its last.
    end: u32,
    last: u32,
    ahead: Ahead,
    /// Where the ray is, up to the next boundary.
    side: Side,
}

impl State {
    const VOID: State = State {
        walk: 0,
        next: Crossing { t: f64::INFINITY, face: 0, part: 0 },
        until: f64::NEG_INFINITY,
        end: 0,
        last: 0,
        ahead: Ahead::Never,
        side: Side::Out,
    };

    #[inline]
    fn set(&mut self, ahead: Ahead, t: f64) {
        (self.ahead, self.next.t) = (ahead, t);
    }

    #[inline]
    fn set_never(&mut self) {
        self.set(Ahead::Never, f64::INFINITY);
    }
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
        scratch.states.resize(csg.nodes.len(), State::VOID);
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
        self.look(root);
        self.resolve(root);
        let State { ahead, next, .. } = self.scratch.states[root];
        (ahead == Ahead::At).then(|| {
            self.advance(root);
            next
        })
    }

    /// A distance [t] within which boundaries may be ties.
    #[inline]
    fn slack(&self, t: f64) -> f64 {
        COARSE * (self.reach + t.abs())
    }

    /// Makes sure that the node's state is of this walk.
    #[inline]
    fn look(&mut self, node: usize) {
        if self.scratch.states[node].walk != self.scratch.walks {
            self.open(node);
        }
    }

    /// The first look at a node is at its bounds, if they are worth it.
    fn open(&mut self, node: usize) {
        let mut state = State { walk: self.scratch.walks, ..State::VOID };
        let Node { bounds, guarded, .. } = &self.csg.nodes[node];
        if !*guarded {
            state.until = f64::INFINITY;
            state.set(Ahead::NotBefore, self.low);
        } else if let Some((t0, t1)) = bounds.slab(self.ray.origin, self.inv_direction, self.low, self.high) {
            state.until = t1 + self.slack(t1);
            state.set(Ahead::NotBefore, t0 - self.slack(t0));
        }
        self.scratch.states[node] = state;
    }

    /// Finds the node's next boundary, or that there is none.
    fn resolve(&mut self, node: usize) {
        if self.scratch.states[node].ahead != Ahead::NotBefore {
            return;
        }
        match self.csg.nodes[node].what {
            What::Leaf(leaf) => self.intersect(node, leaf),
            What::Pair(operation, left, right) => {
                self.merge(node, operation, left as usize, right as usize);
            }
        }
    }

    /// All ends of a leaf's spans from now on.
    fn intersect(&mut self, node: usize, leaf: u32) {
        let spans = &mut self.scratch.spans;
        let first = spans.len();
        self.csg.leaves[leaf as usize].solid.spans(self.ray, spans);
        let passed = spans[first..].iter().take_while(|span| span.leave.t < self.low).count();
        let state = &mut self.scratch.states[node];
        (state.end, state.last) = (2 * (first + passed) as u32, 2 * spans.len() as u32);
        self.end_of_span(node, leaf);
    }

    /// A leaf's next boundary; the end of an endless span is none.
    #[inline]
    fn end_of_span(&mut self, node: usize, leaf: u32) {
        let state = &mut self.scratch.states[node];
        if state.end >= state.last {
            return state.set_never();
        }
        let Span { enter, leave } = self.scratch.spans[state.end as usize / 2];
        let crossing = if state.end.is_multiple_of(2) { enter } else { leave };
        if crossing.t == f64::INFINITY {
            return state.set_never();
        }
        state.ahead = Ahead::At;
        state.next = Crossing { part: crossing.part + self.csg.leaves[leaf as usize].first_part, ..crossing };
    }

    /// Goes behind the boundary that the node has found.
    #[inline]
    fn advance(&mut self, node: usize) {
        let state = &mut self.scratch.states[node];
        state.side = state.side.other();
        match self.csg.nodes[node].what {
            What::Leaf(leaf) => {
                state.end += 1;
                self.end_of_span(node, leaf);
            }
            What::Pair(..) => state.ahead = Ahead::NotBefore,
        }
    }

    /// Finds the next place where the operands' sides combine to the other side.
    fn merge(&mut self, node: usize, operation: Operation, left: usize, right: usize) {
        let before = self.scratch.states[node].side;
        self.look(left);
        self.look(right);
        loop {
            let (l, r) = (&self.scratch.states[left], &self.scratch.states[right]);
            let decided = (operation.left_decides(l.side), operation.right_decides(r.side));
            // Nothing happens until the operand that decides changes; until both do, if both decide.
            let left_leads = match decided {
                (true, false) => true,
                (false, true) => false,
                (true, true) => l.next.t >= r.next.t,
                (false, false) => l.next.t <= r.next.t,
            };
            let (lead, other, ahead) = if left_leads { (left, right, l) } else { (right, left, r) };
            let mark = ahead.next;
            if ahead.ahead == Ahead::Never || mark.t > self.high {
                return self.scratch.states[node].set_never();
            }
            if ahead.ahead == Ahead::NotBefore {
                self.resolve(lead);
                continue;
            }
            if decided != (false, false) {
                self.seek(other, &mark);
            }
            let State { ahead, next: also, .. } = self.scratch.states[other];
            if ahead == Ahead::NotBefore && !(also.t > mark.t + self.slack(mark.t)) {
                self.resolve(other);
                continue;
            }
            let tie = ahead == Ahead::At && self.tied(&mark, &also);
            self.advance(lead);
            if tie {
                self.advance(other);
            }
            let (l_side, r_side) = (self.scratch.states[left].side, self.scratch.states[right].side);
            if operation.combine(l_side, r_side) != before {
                let state = &mut self.scratch.states[node];
                state.ahead = Ahead::At;
                state.next = if tie { one_of(mark, also) } else { mark };
                return;
            }
        }
    }

    /// Goes over every boundary of the node that lies before `mark` and is no tie with it.
    fn seek(&mut self, node: usize, mark: &Crossing) {
        let slack = self.slack(mark.t);
        loop {
            let State { ahead, next, until, .. } = self.scratch.states[node];
            match ahead {
                Ahead::Never => return,
                Ahead::At if next.t < mark.t && !self.tied(&next, mark) => self.advance(node),
                Ahead::At => return,
                Ahead::NotBefore if next.t > mark.t + slack => return,
                Ahead::NotBefore if until < mark.t - slack => {
                    let state = &mut self.scratch.states[node];
                    state.side = Side::Out;
                    return state.set_never();
                }
                Ahead::NotBefore => match self.csg.nodes[node].what {
                    What::Leaf(_) => self.resolve(node),
                    What::Pair(operation, left, right) => {
                        return self.seek_operands(node, operation, [left as usize, right as usize], mark);
                    }
                },
            }
        }
    }

    /// Brings the operands, as far as they matter, up to the mark.
    fn seek_operands(&mut self, node: usize, operation: Operation, of: [usize; 2], mark: &Crossing) {
        self.look(of[0]);
        self.look(of[1]);
        self.seek(of[0], mark);
        let l = self.scratch.states[of[0]];
        let (side, next) = if operation.left_decides(l.side) {
            (operation.combine(l.side, Side::Out), l)
        } else {
            self.seek(of[1], mark);
            let r = self.scratch.states[of[1]];
            let right_is_next = operation.right_decides(r.side) || r.next.t < l.next.t;
            (operation.combine(l.side, r.side), if right_is_next { r } else { l })
        };
        let state = &mut self.scratch.states[node];
        state.side = side;
        let ahead = if next.ahead == Ahead::Never { Ahead::Never } else { Ahead::NotBefore };
        state.set(ahead, next.next.t);
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

/// A point in the origin of space does not make its surface doubtful without bound: rays are trusted from as far as 2²⁰ times
/// its distance from there.
const MOST_FAR: f64 = (1u64 << 20) as f64;

/// Of two boundaries that are one: the nearer place, on the leaf that is written first.
fn one_of(a: Crossing, b: Crossing) -> Crossing {
    let first = if a.part <= b.part { a } else { b };
    Crossing { t: a.t.min(b.t), ..first }
}
