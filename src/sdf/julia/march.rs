//! The first change of sign along a line, for certain.
//!
//! Stretches about four places at a time ([`super::reach`]) push the stretch behind the ray that is known to hold no
//! change. Where a place with the other sign turns up, Newton's steps find a root before it, and what lies between
//! is looked at in the same way, down to a stretch on which `|q|` is monotone. Nothing is stepped over.

use super::grid::Grid;
use super::lanes::{LANES, Lanes};
use super::line::Line;
use super::reach::{Stretches, stretches};
use super::set::Set;
use crate::num::U;

/// Looks at four places before a search gives up and takes the place it has reached for the surface: a ray that creeps
/// along a fractal more closely than rounding can tell. (Of 10⁷ random rays none took 1000.)
const MOST_LOOKS: usize = 100_000;
/// Length of the window that is looked at first [cells of the grid], for the first change and for any. Tuned: with 2 the first of
/// two looks finds nothing, and after 5 the place that is found is too rough; whether there is one, distant places tell.
const WINDOW: f64 = 3.5;
const WINDOW_ANY: f64 = 7.0;
/// The same where the search begins at the surface itself, as shadow rays do. Tuned: at 0.9 and at 3.6 they take more looks.
const WINDOW_FRESH: f64 = 1.8;

/// Shares of the width at which places are looked at: evenly; towards a root; from a start on.
static EVEN: [f64; LANES] = [0.125, 0.375, 0.625, 0.875];
static TOWARDS: [f64; LANES] = [0.25, 0.6, 0.85, 0.96];
static AWAY: [f64; LANES] = [0.07, 0.23, 0.48, 0.82];
static FRESH: [f64; LANES] = [0.0, 0.11, 0.44, 1.0];
/// Width of four places by the reach of one. Each covers two reaches, so 8 would leave no overlap; tuned.
const SPREAD: f64 = 6.0;
/// The same where each reaches farther than the one before.
const SPREAD_AWAY: f64 = 10.0;
/// A root is near if the first of the places towards it is within reach: a quarter of half a width.
const NEAR: f64 = 0.5;

/// What is asked.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Ask {
    /// Where the first change is.
    First,
    /// Whether there is one.
    Any,
}

/// Where a search begins, and what is known there.
#[derive(Clone, Copy)]
pub(super) enum Begin {
    /// The sign is the search's.
    Known(f64),
    /// The sign is still to be seen.
    Unseen(f64),
    /// A change, found before, to the search's sign.
    Behind(f64),
}

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Found {
    Nothing,
    At(f64),
    /// The start has the other sign.
    OtherSide,
}

/// A search along a line.
pub(super) struct Search<'a> {
    pub set: &'a Set,
    pub grid: &'a Grid,
    pub line: &'a Line,
    /// Is the search inside the solid?
    pub inside: bool,
    pub ask: Ask,
}

/// The state of a search.
struct Front {
    /// No change up to here.
    clear: f64,
    /// How far beyond it the next four places reach.
    width: f64,
    end: f64,
    /// A root with the other sign behind it.
    root: Option<f64>,
    /// Does the line lead away from the surface, so that each place reaches farther than the one before?
    away: bool,
    /// Has nothing been looked at yet?
    fresh: bool,
}

impl Search<'_> {
    /// The first change of sign between a beginning and `end`.
    #[inline(always)]
    pub fn run<V: Lanes>(&self, begin: Begin, end: f64) -> Found {
        let (from, fresh) = match begin {
            Begin::Known(s) => (s, false),
            Begin::Unseen(s) => (s, true),
            Begin::Behind(root) => match self.behind::<V>(root, end) {
                Some(s) => (s, true),
                None => return Found::Nothing,
            },
        };
        let cell = self.grid.cell() * self.line.per_length;
        let window = cell * if self.ask == Ask::Any { WINDOW_ANY } else { WINDOW };
        let grain = self.grain();
        let path = self.grid.path(self.line);
        let mut front = Front {
            clear: from,
            width: if fresh { cell * WINDOW_FRESH } else { window },
            end,
            root: None,
            away: false,
            fresh,
        };
        for _ in 0..MOST_LOOKS {
            if front.root.is_none() && !self.inside && !front.fresh {
                let next = self.grid.skip(&path, front.clear, end);
                if next > front.clear {
                    (front.clear, front.width, front.away) = (next, window, false);
                }
            }
            if !(front.clear < front.stop()) {
                return front.root.map_or(Found::Nothing, Found::At);
            }
            // Four numbers written one by one are not at hand as a vector for a while.
            let (shares, width) = front.places();
            let places = V::splat(front.clear) + V::of(*shares) * V::splat(width);
            let look = stretches(self.set, self.line.start::<V>(places));
            let places = places.array();
            if front.fresh && look.inside[0] != self.inside {
                return Found::OtherSide;
            }
            front.fresh = false;
            if let Some(found) = self.judge(&mut front, &places, &look, grain) {
                return found;
            }
        }
        Found::At(front.clear)
    }

    /// Moves the front by what four places tell.
    #[inline(always)]
    fn judge(&self, front: &mut Front, places: &[f64; LANES], look: &Stretches, grain: f64) -> Option<Found> {
        let before = front.clear;
        let (mut reach, mut last) = (None, None);
        for i in 0..LANES {
            let s = places[i];
            if look.inside[i] != self.inside {
                if self.ask == Ask::Any {
                    return Some(Found::At(s));
                }
                let before = if i > 0 { places[i - 1] } else { front.clear };
                front.root = Some(self.root([before, s], self.guess(look, places, i), grain));
                break;
            }
            if reach.is_none() {
                if s - look.back[i] <= front.clear {
                    front.clear = front.clear.max(s + look.ahead[i]);
                    last = Some(i);
                } else {
                    reach = Some(look.back[i]);
                }
            }
        }
        if let (Some(root), Some(i)) = (front.root, last)
            && (front.clear >= root
                || (look.delta[i] > 0.0) == self.inside && look.is_monotone(i, root - places[i]))
        {
            return Some(Found::At(root));
        }
        let ahead = last.map_or(f64::INFINITY, |i| look.ahead[i]);
        front.away = reach.is_none() && last.is_some_and(|i| (look.delta[i] > 0.0) != self.inside);
        let spread = if front.away { SPREAD_AWAY } else { SPREAD };
        let width = spread * ahead.min(reach.unwrap_or(f64::INFINITY));
        // Where nothing was gained, the places move together, down to what rounding can tell apart.
        front.width = if front.clear > before { width } else { width.min(0.5 * front.width) };
        if front.width < grain {
            front.clear += grain;
        }
        None
    }

    /// The next place behind a root where the sign is that of the search, if there is one before `end`; seen by the same
    /// roundings as all places are.
    #[inline(always)]
    fn behind<V: Lanes>(&self, root: f64, end: f64) -> Option<f64> {
        let mut step = self.grain();
        loop {
            let places = V::splat(root) + V::of([1.0, 2.0, 4.0, 8.0]) * V::splat(step);
            let look = stretches(self.set, self.line.start::<V>(places));
            for (s, inside) in places.array().into_iter().zip(look.inside) {
                if !(s < end) {
                    return None;
                }
                if inside == self.inside {
                    return Some(s);
                }
            }
            step *= 16.0;
        }
    }

    /// `(2B)²`, what [`Line::value`] is at the surface.
    #[inline(always)]
    fn level(&self) -> f64 {
        4.0 * self.set.bailout() * self.set.bailout()
    }

    /// Two places closer than this are one: their coordinates differ by roundings only. A line's middle and half its chord together are
    /// at most `√2` of the ball's radius.
    #[inline(always)]
    fn grain(&self) -> f64 {
        6.0 * U * self.grid.radius * self.line.per_length
    }

    /// Where Newton's step leads from place `i`, which has the other sign, or from the one before it, whichever is nearer to the surface.
    #[inline(always)]
    fn guess(&self, look: &Stretches, places: &[f64; LANES], i: usize) -> f64 {
        let b2 = self.level();
        let log = |i: usize| {
            let n = 4.0 * look.alpha[i] * look.alpha[i];
            (n - b2) / (n + b2)
        };
        let from = if i > 0 && log(i - 1).abs() < log(i).abs() { i - 1 } else { i };
        places[from] - log(from) * look.alpha[from] / look.delta[from]
    }

    /// A root between two places of different sign, by Newton's steps on `ln |q|`, and bisection where they leave or do not
    /// get shorter.
    ///
    /// `|q_N|` grows like an exponential, its logarithm almost evenly; `½ ln z = (z − 1)/(z + 1) + O((z − 1)³)` is
    /// near enough close to the root. A step of Newton's from an error `e` leaves `C e²`. So the step after it is `C e²` long, which
    /// tells `C`, and leaves `C (C e²)² = step³/last²`.
    #[inline(always)]
    fn root(&self, [mut before, mut behind]: [f64; 2], guess: f64, grain: f64) -> f64 {
        let b2 = self.level();
        let mut s = if before < guess && guess < behind { guess } else { 0.5 * (before + behind) };
        let (mut last, mut by_newton) = (behind - before, false);
        while behind - before > grain {
            let (n, half_dn) = self.line.value(self.set, s);
            if (n > b2) != self.inside {
                before = s;
            } else {
                behind = s;
            }
            let step = (n - b2) / (n + b2) * n / half_dn;
            let (next, step) = (s - step, step.abs());
            let shorter = step < 0.5 * last;
            if by_newton && shorter && step * step * step <= grain * last * last {
                return next.clamp(before, behind);
            }
            by_newton = shorter && before < next && next < behind;
            (s, last) =
                if by_newton { (next, step) } else { (0.5 * (before + behind), 0.5 * (behind - before)) };
        }
        behind
    }
}

impl Front {
    /// Where the search ends.
    #[inline(always)]
    fn stop(&self) -> f64 {
        self.root.unwrap_or(self.end)
    }

    /// Four places to look at next, as shares of a width: about the middles of quarters; denser towards a root; from the very
    /// start on where its sign is to be seen.
    #[inline(always)]
    fn places(&self) -> (&'static [f64; LANES], f64) {
        let rest = self.stop() - self.clear;
        let width = self.width.min(rest);
        if self.fresh {
            (&FRESH, width)
        } else if self.root.is_some() && rest <= NEAR * self.width {
            (&TOWARDS, rest)
        } else if self.away {
            (&AWAY, width)
        } else {
            (&EVEN, width)
        }
    }
}
