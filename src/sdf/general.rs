//! The general method [E §2.2]: the roots of an implicit equation along the ray, and a condition that they have to meet.
//!
//! ```text
//! S = { t : F(o + t v) = 0 },    t = min { t ∈ S : t > 0, C(o + t v) }                       (1)
//! ```
//!
//! The roots come from a formula (the shapes of [`crate::shape`]), from brackets that are halved, from Newton's iteration, or,
//! where `F` bounds a distance, from marching. This module holds what needs no more than the values of `F`.

/// (1): the first root in front that meets the condition. The roots come in any order.
pub fn first(roots: impl IntoIterator<Item = f64>, condition: impl Fn(f64) -> bool) -> Option<f64> {
    roots.into_iter().filter(|&t| t > 0.0 && condition(t)).min_by(f64::total_cmp)
}

/// Brackets between equally spaced places where the sign of `f` changes, in ascending order. A pair of roots between
/// two places is missed.
pub fn brackets(f: impl Fn(f64) -> f64, from: f64, to: f64, pieces: u32) -> impl Iterator<Item = (f64, f64)> {
    let at = move |i: u32| from + (to - from) * (f64::from(i) / f64::from(pieces.max(1)));
    let mut last = f(from) < 0.0;
    (0..pieces).filter_map(move |i| {
        let here = f(at(i + 1)) < 0.0;
        let changed = here != last;
        last = here;
        changed.then(|| (at(i), at(i + 1)))
    })
}

/// The change of sign in a bracket, by halving: to neighbouring numbers.
pub fn bisection(f: impl Fn(f64) -> f64, (mut a, mut b): (f64, f64)) -> f64 {
    let before = f(a) < 0.0;
    loop {
        let m = a + (b - a) * 0.5;
        if !(m > a && m < b) {
            return b;
        }
        if (f(m) < 0.0) == before { a = m } else { b = m }
    }
}

/// Newton's iteration from `start`, at most `most` steps; `f` gives value and slope.
///
/// ```text
/// t ← t − f/f′
/// ```
///
/// `None` if it does not settle to within `accuracy`: it may run away where the slope is flat, and it finds whichever root it
/// happens on.
pub fn newton(f: impl Fn(f64) -> (f64, f64), start: f64, accuracy: f64, most: u32) -> Option<f64> {
    let mut t = start;
    for _ in 0..most {
        let (value, slope) = f(t);
        let step = value / slope;
        if !step.is_finite() {
            return (value == 0.0).then_some(t);
        }
        t -= step;
        if step.abs() <= accuracy {
            return Some(t);
        }
    }
    None
}
