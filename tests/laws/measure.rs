//! Laws of measuring: quartiles, roots of mean squares, slopes, fronts, tolerances, CSV.

use lightbench::measure::{
    Failures, Method, Point, ROUNDS, Ratio, Run, Series, Spread, Tally, Z, agrees, counts_csv, interleaved,
    log_slope, log_spaced, pareto, promised, quantised, rounding, statistical, sweep, time, time_each,
    times_csv, truncation,
};
use lightbench::num::{U, gamma};
use proptest::prelude::*;
use std::cmp::Ordering::{Greater, Less};

fn config() -> ProptestConfig {
    ProptestConfig { failure_persistence: None, cases: 256, ..ProptestConfig::default() }
}

/// A number in [0,1) from two counters, by a mixing function (Steele et al. 2014): fixed, and independent enough.
fn random(run: u32, i: u32) -> f64 {
    let mut z = (u64::from(run) << 32 | u64::from(i)).wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn quartiles_enclose_the_median_and_count_their_runs(values in prop::collection::vec(-1.0e300..1.0e300f64, 1..40)) {
        let spread = Spread::median(&values).expect("values");
        let below = values.iter().filter(|v| **v <= spread.mid).count();
        let above = values.iter().filter(|v| **v >= spread.mid).count();
        prop_assert!(spread.low <= spread.mid && spread.mid <= spread.high);
        prop_assert!(2 * below >= values.len() && 2 * above >= values.len());
        prop_assert_eq!(spread.runs, values.len());
    }

    #[test]
    fn rms_scales_with_its_errors_at_any_magnitude(
        errors in prop::collection::vec(0.1..10.0f64, 1..30), exponent in -200i32..200
    ) {
        let unit = 2f64.powi(exponent);
        let scaled: Vec<f64> = errors.iter().map(|e| e * unit).collect();
        let (a, b) = (Spread::rms(&errors).expect("errors"), Spread::rms(&scaled).expect("errors"));
        // A power of two scales every step without rounding.
        prop_assert_eq!(a.mid * unit, b.mid);
        prop_assert_eq!(a.low * unit, b.low);
        let naive = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        // Either sum has at most n + 4 roundings, halved by the root; both differ from the truth by that.
        prop_assert!(agrees(a.mid, naive, 2.0 * rounding(errors.len() as u32 + 4, naive)));
    }

    #[test]
    fn nothing_beats_a_point_of_the_front_and_something_beats_every_other(
        points in prop::collection::vec((0u8..12, 0u8..12), 0..40)
    ) {
        let points: Vec<(f64, f64)> = points.iter().map(|&(c, e)| (f64::from(c), f64::from(e))).collect();
        let front = pareto(&points);
        let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
        for (i, &p) in points.iter().enumerate() {
            let beaten = points.iter().any(|&q| beats(q, p));
            let twin = front.iter().any(|&k| points[k] == p);
            prop_assert_eq!(!beaten, twin, "point {} at {:?}", i, p);
        }
        prop_assert!(front.windows(2).all(|w| points[w[0]].0 < points[w[1]].0 && points[w[0]].1 > points[w[1]].1));
    }

    #[test]
    fn a_tally_counts_every_question_once(
        answers in prop::collection::vec((prop::option::of(-2.0..2.0f64), prop::option::of(-2.0..2.0f64)), 0..60)
    ) {
        let mut tally = Tally::new();
        answers.iter().for_each(|(found, truth)| tally.answer(*found, *truth));
        let f = tally.failures();
        let both = answers.iter().filter(|a| a.0.is_some() && a.1.is_some()).count();
        let neither = answers.iter().filter(|a| a.0.is_none() && a.1.is_none()).count() as u64;
        prop_assert_eq!(tally.errors().len(), both);
        prop_assert_eq!(f.of, answers.len() as u64);
        prop_assert_eq!(f.total() + both as u64 + neither, f.of);
    }
}

#[test]
fn a_mean_of_independent_samples_falls_with_slope_one_half() {
    let budgets: Vec<u32> = (4..=12).map(|k| 1 << k).collect();
    let series =
        sweep(&budgets, 64, 0.5, |n, run| (0..n).map(|i| random(run, i)).sum::<f64>() / f64::from(n));
    let slope = log_slope(&series, 64);
    assert_eq!(slope.points, budgets.len());
    assert!(slope.agrees_with(-0.5), "{slope:?}");
    // Nine octaves and 64 runs tell −½ from −1 and from 0 by many standard deviations.
    assert!(!slope.agrees_with(-1.0) && !slope.agrees_with(0.0), "{slope:?}");
}

#[test]
fn the_slope_of_a_power_law_is_its_exponent() {
    let point = |k: i32| Point::at(2f64.powi(k)).erred(Spread::exact(3.0 * 2f64.powi(-2 * k)));
    let slope = log_slope(&Series::new((0..10).map(point).collect()), 10);
    // Ten logarithms below 20, each rounded once, and two sums of ten products: under γ₄₀ of the slope.
    assert!(agrees(slope.value, -2.0, rounding(40, 2.0 * 20.0)), "{slope:?}");
}

#[test]
fn a_slope_without_two_points_agrees_with_nothing() {
    let zero = Point::at(1.0).erred(Spread::exact(0.0));
    let one = Point::at(1.0).erred(Spread::exact(1.0));
    for points in [vec![], vec![one.clone()], vec![one.clone(), one], vec![zero.clone(), zero]] {
        let slope = log_slope(&Series::new(points), 8);
        assert!(slope.value.is_nan() && !slope.agrees_with(-0.5) && !slope.agrees_with(f64::NAN));
    }
}

#[test]
fn a_sweep_repeats_its_errors_and_counts_nan_as_failure() {
    let run = || sweep(&[1u32, 2, 4], 8, 2.0, |n, run| if run == 3 { f64::NAN } else { 2.0 + f64::from(n) });
    let (a, b) = (run(), run());
    for (p, q) in a.points.iter().zip(&b.points) {
        assert_eq!(p.error, q.error);
        assert_eq!(p.failures, Failures { nan: 1, of: 8, ..Failures::default() });
        assert_eq!(p.error.map(|e| e.mid), Some(p.parameter / 2.0));
        assert_eq!(p.work, Some(p.parameter));
    }
}

#[test]
fn the_allowance_makes_the_suite_err_once_in_a_million() {
    // Upper tail of the normal distribution by its continued fraction (Laplace): Q(z) = φ(z)/(z+1/(z+2/(z+…))).
    let fraction = (1..200).rev().fold(Z, |f, k| Z + f64::from(k) / f);
    let tail = 2.0 * (-Z * Z / 2.0).exp() / (2.0 * std::f64::consts::PI).sqrt() / fraction;
    let wanted = 1.0 - (1.0f64 - 1.0e-6).powf(1.0 / 1000.0);
    assert!(tail <= wanted && tail > 0.98 * wanted, "{tail:e} for {wanted:e}");
}

#[test]
fn tolerances_are_what_they_say() {
    assert_eq!(rounding(3, -2.0), 2.0 * gamma(3));
    assert!(rounding(1, 1.0) >= U);
    assert_eq!((promised(-1.0e-9), truncation(-0.25), quantised()), (1.0e-9, 0.25, 0.5));
    assert_eq!(statistical(2.0, 4), Z);
    assert!(agrees(1.0, 1.5, 0.5) && !agrees(1.0, 1.6, 0.5));
    assert!(agrees(f64::INFINITY, f64::INFINITY, 0.0) && !agrees(f64::NAN, f64::NAN, f64::INFINITY));
}

#[test]
fn parameters_are_spaced_evenly_on_a_logarithm() {
    let spaced = log_spaced(1.0e-3, 1.0e3, 7);
    assert_eq!((spaced[0], spaced[6]), (1.0e-3, 1.0e3));
    // A power of 10⁶ and a product: the power's exponent of at most ln 10⁶ = 14 carries its rounding.
    assert!(spaced.windows(2).all(|w| agrees(w[1] / w[0], 10.0, rounding(40, 10.0))), "{spaced:?}");
    assert_eq!(log_spaced(2.0, 8.0, 1), [2.0]);
    assert!(log_spaced(2.0, 8.0, 0).is_empty());
}

#[test]
fn no_values_have_no_spread_and_equal_values_none_to_speak_of() {
    assert_eq!(Spread::median(&[]), None);
    assert_eq!(Spread::median(&[f64::NAN]), None);
    assert_eq!(Spread::rms(&[]), None);
    assert_eq!(Spread::rms(&[0.0, 0.0]).map(|s| (s.low, s.mid, s.high)), Some((0.0, 0.0, 0.0)));
    assert_eq!(Spread::median(&[3.0; 5]), Some(Spread { runs: 5, ..Spread::exact(3.0) }));
}

#[test]
fn a_clock_gives_ordered_positive_times() {
    let mut n = 0u64;
    let spread = time(|| {
        n = n.wrapping_mul(3).wrapping_add(1);
        n
    });
    assert!(
        0.0 <= spread.low && spread.low <= spread.mid && spread.mid <= spread.high && spread.high.is_finite()
    );
    assert!(spread.runs > 1);
    assert!(time_each(0, || 1).mid.is_finite());
}

#[test]
fn counts_and_times_stay_in_files_of_their_own() {
    let method = Method::as_printed("as printed, \"[B 6.3]\"");
    let mut point = Point::at(0.1).timed(Spread::exact(1.25e-7)).worked(3.0).erred(Spread::exact(1.0 / 3.0));
    point.failures = Failures { missed: 4, false_hits: 2, nan: 1, of: 9 };
    point.runs = vec![Run { time: Some(1.0), error: Some(1.0) }];
    let mut later = point.clone();
    later.time = Some(Spread::exact(9.0));
    let (a, b) = (Series::new(vec![point]), Series::new(vec![later]));
    assert_eq!(counts_csv(&[(&method, &a)]), counts_csv(&[(&method, &b)]), "seconds leak into the counts");
    assert_ne!(times_csv(&[(&method, &a)]), times_csv(&[(&method, &b)]));
    let text = counts_csv(&[(&method, &a)]);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let row = reader.records().next().expect("a row").expect("well formed");
    assert_eq!(&row[0], method.name);
    assert_eq!(row[3].parse::<f64>(), Ok(1.0 / 3.0));
    assert_eq!(row.iter().skip(7).collect::<Vec<_>>(), ["4", "2", "1", "9"]);
}

/// Pairs of times that a machine measured, some of them disturbed: the quartiles leave the disturbed ones out.
#[test]
fn a_ratio_of_interleaved_times_has_its_quartiles_and_words() {
    let of = |quotients: &[f64], times: usize| {
        let pairs: Vec<(f64, f64)> = quotients.iter().map(|q| (q * 0.25, 0.25)).collect();
        Ratio::of_pairs(&pairs.repeat(times)).expect("pairs")
    };
    let ratio = of(&[2.0, 3.0, 2.5, 90.0, 2.5], 4);
    assert_eq!((ratio.0.low, ratio.0.mid, ratio.0.high, ratio.0.runs), (2.5, 2.5, 3.0, 20));
    assert_eq!(ratio.to_string(), "2.5 to 3.0 times");
    assert_eq!(ratio.times_or_busy(), "2.5 to 3.0 times");
    assert_eq!([1.0, 2.7, 3.5].map(|x| ratio.finding(x)), [Some(Greater), None, Some(Less)]);
    assert!(ratio.tells(1.0) && !ratio.tells(2.7));
    assert!(ratio.words(2.7).contains("too busy to tell") && !ratio.words(1.0).contains("busy"));
    // The same quotients from 15 rounds are no finding, though their quartiles are.
    assert_eq!(of(&[2.0, 3.0, 2.5, 90.0, 2.5], 3).finding(1.0), None);
    assert_eq!(of(&[0.9, 1.1], 20).times_or_busy(), "this machine was too busy to tell");
    assert_eq!(of(&[0.414], 16).to_string(), "0.41 times");
    assert_eq!(of(&[12.3, 25.4], 10).to_string(), "12 to 25 times");
    assert!(Ratio::of_pairs(&[(0.0, 1.0), (1.0, 0.0), (f64::NAN, 1.0)]).is_none());
}

/// The chance that Ratio's words give: three quarters of the tosses of a fair coin alike.
#[test]
fn a_finding_between_equals_is_as_rare_as_its_words_say() {
    let tail = |n: u32, least: u32| {
        let term = |k: u32| (0..k).fold(1.0, |c, i| c * f64::from(n - i) / f64::from(i + 1));
        (least..=n).map(term).sum::<f64>() / 2f64.powi(n as i32)
    };
    assert_eq!(ROUNDS, 41);
    assert_eq!((1.0 / tail(41, 31)).round(), 1379.0);
    assert_eq!((1.0 / tail(Ratio::FEWEST as u32, 12)).round(), 26.0);
    // 31 of 41 above the threshold are a finding, 30 are none.
    let above = |k: usize| {
        let quotient = |i: usize| if i < k { (1.5, 1.0) } else { (0.5, 1.0) };
        Ratio::of_pairs(&(0..41).map(quotient).collect::<Vec<_>>()).expect("pairs").finding(1.0)
    };
    assert_eq!((above(31), above(30)), (Some(Greater), None));
}

#[test]
fn interleaved_works_take_turns_there_and_back() {
    let order = std::cell::RefCell::new(Vec::new());
    let slow = || std::thread::sleep(std::time::Duration::from_millis(1));
    let (mut a, mut b, mut c) = (
        || (order.borrow_mut().push('a'), slow()).1,
        || (order.borrow_mut().push('b'), slow()).1,
        || (order.borrow_mut().push('c'), slow()).1,
    );
    let times = interleaved(&mut [&mut a, &mut b, &mut c], 3);
    // One call each to learn how long it takes, more than half a millisecond; then three rounds.
    assert_eq!(order.borrow().iter().collect::<String>(), "abcabccbaabc");
    assert!(times.seconds.iter().all(|s| s.len() == 3 && s.iter().all(|t| *t >= 1.0e-3)));
    assert_eq!(times.time(2).map(|t| t.runs), Some(3));
    assert_eq!(times.ratio(0, 1).map(|r| r.0.runs), Some(3));
    assert_eq!(interleaved(&mut [&mut || {}], 0).time(0), None);
}

#[test]
fn a_series_is_read_by_its_parameter() {
    let series = Series::new([1.0, 2.0, 4.0, 8.0].map(Point::at).to_vec());
    assert_eq!(series.at(4.0).map(|p| p.parameter), Some(4.0));
    assert_eq!(series.at(3.0), None);
    assert_eq!(series.between(2.0, 4.0).points.len(), 2);
}
