//! Laws of the sphere's methods: they agree where none of them suffers, and robust keeps its promise everywhere.

use crate::support::nasty;
use glam::DVec3;
use lightbench::num::counted::{Counted, count};
use lightbench::num::gamma;
use lightbench::shape::sphere::as_printed;
use lightbench::shape::sphere::method::{
    algebraic, algebraic_first, geometric, geometric_by_length, in_front, robust,
};
use lightbench::shape::sphere::reference::Meeting;
use proptest::prelude::*;

fn config() -> ProptestConfig {
    ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() }
}

/// A line that passes the centre of the unit sphere at `impact`, from `distance` away, and its direction.
fn line(d: DVec3, turn: f64, distance: f64, impact: f64) -> ([f64; 3], [f64; 3]) {
    let (right, up) = d.any_orthonormal_pair();
    let back = (distance * distance - impact * impact).max(0.0).sqrt();
    (((right * turn.cos() + up * turn.sin()) * impact - d * back).to_array(), d.to_array())
}

fn lines(farthest: f64) -> impl Strategy<Value = ([f64; 3], [f64; 3])> {
    (nasty::unit_vector(), 0.0..6.3, 0.0..farthest, 0.0..0.95)
        .prop_map(|(d, turn, decades, impact)| line(d, turn, 10f64.powf(decades) * 1.01, impact))
}

proptest! {
    #![proptest_config(config())]

    /// `t₀`: 11 u D of f·f, q and the quotient; √12 u D across the line becomes b/h ≤ 0.95/0.31 times as much
    /// along it. `t₁ = q/a` has fewer roundings.
    #[test]
    fn robust_errs_by_roundings_of_the_distance((f, d) in lines(9.0)) {
        let truth = Meeting::of(f, d, 1.0);
        let distance = DVec3::from(f).length();
        prop_assume!(truth.impact < 0.951);
        // Across the line D u may exceed the rim's margin: no promise beyond.
        prop_assume!(distance < 1.0e12);
        let (t0, t1) = robust(f, d, 1.0).expect("a hit well inside the rim");
        let bound = gamma(22) * (distance + 1.0);
        prop_assert!(truth.behind_first(t0).expect("a hit").abs() <= bound, "{:?} {bound}", truth.behind_first(t0));
        prop_assert!(truth.behind_second(t1).expect("a hit").abs() <= bound, "{:?} {bound}", truth.behind_second(t1));
    }

    /// The others err by as many roundings of the square of the distance, over the half chord: h ≥ 0.31.
    #[test]
    fn the_others_err_by_roundings_of_its_square((f, d) in lines(3.0)) {
        let truth = Meeting::of(f, d, 1.0);
        let square = DVec3::from(f).length_squared() + 1.0;
        // f·d: 4 roundings, squared 9; f·f − r²: 5; their difference and |d|² ≠ 1: 10 more. δh = δ(h²) / 2h.
        let bound = gamma(24) * square / (2.0 * 0.31) + gamma(8) * square.sqrt();
        for roots in [algebraic(f, d, 1.0), geometric(f, d, 1.0)] {
            let (t0, t1) = roots.expect("a hit far from the rim");
            prop_assert!(truth.behind_first(t0).expect("a hit").abs() <= bound);
            prop_assert!(truth.behind_second(t1).expect("a hit").abs() <= bound);
        }
    }

    /// An early exit changes the work, not the answer.
    #[test]
    fn early_exits_change_nothing((f, d) in lines(6.0), r in 0.1..2.0) {
        prop_assert_eq!(algebraic_first(f, d, r), in_front(algebraic(f, d, r)));
        // √ is monotone: d > r in rounded lengths only if d² > r² in rounded squares, up to the last place.
        if let Some(roots) = geometric_by_length(f, d, r) {
            prop_assert!(geometric(f, d, r).is_none_or(|g| g == roots));
        }
    }

    /// Units of length do not matter: a power of two scales every answer exactly.
    #[test]
    fn robust_knows_no_unit((f, d) in lines(6.0), exponent in -60i32..60) {
        let scale = 2f64.powi(exponent);
        let scaled = robust(f.map(|x| x * scale), d, scale);
        prop_assert_eq!(scaled, robust(f, d, 1.0).map(|(a, b)| (a * scale, b * scale)));
    }

    /// Counting changes no bit.
    #[test]
    fn counted_numbers_compute_the_same((f, d) in lines(6.0)) {
        let (done, counted) = count(|| robust(f.map(Counted), d.map(Counted), Counted(1.0)));
        prop_assert_eq!(counted.map(|(a, b)| (a.0, b.0)), robust(f, d, 1.0));
        prop_assert_eq!((done.roots, done.quotients), (1, 3));
    }
}

/// A root that is formed costs two operations: what C's early exit saves on a ray from outside that hits.
#[test]
fn the_early_exits_save_what_the_lesson_says() {
    let (f, d) = ([0.0, 0.5, -10.0].map(Counted), [0.0, 0.0, 1.0].map(Counted));
    let r = Counted(1.0);
    let total = |work: &dyn Fn() -> bool| count(work).0;
    let (both, first) =
        (total(&|| algebraic(f, d, r).is_some()), total(&|| algebraic_first(f, d, r).is_some()));
    assert_eq!((both.sums - first.sums, both.quotients - first.quotients), (1, 1));
    let (length, square) =
        (total(&|| geometric_by_length(f, d, r).is_some()), total(&|| geometric(f, d, r).is_some()));
    assert_eq!((length.roots, square.roots), (2, 1));
}

#[test]
fn the_listings_lose_what_the_errata_say() {
    let (ahead, d) = ([0.0, 0.5, -10.0], [0.0, 0.0, 1.0]);
    // Four times the half chord squared, 3e-8, is below A's 1e-6.
    assert_eq!(as_printed::with_fixed_epsilon(ahead.map(|x| x * 1.0e-4), d, 1.0e-4), None);
    assert!(as_printed::with_fixed_epsilon(ahead, d, 1.0).is_some());
    let behind = [0.0, 0.0, 0.5];
    assert_eq!(as_printed::with_centre_in_front(behind, d, 1.0), None);
    let tangent = [0.0, 1.0, -10.0];
    assert_eq!(as_printed::without_tangent(tangent, d, 1.0), None);
    for f in [ahead, behind, tangent] {
        assert!(in_front(robust(f, d, 1.0)).is_some(), "{f:?}");
    }
}
