//! Colour against its tables: conversions, matrices, dominant wavelengths, the matching functions.

use super::support::table::Table;
use super::truth::{Record, all_right, columns, wrong_rows};
use glam::{DMat3, DVec3, dvec3};
use lightbench::color::dominant::Locus;
use lightbench::color::gamut::area;
use lightbench::color::spectrum::{Matching, VISIBLE, cones};
use lightbench::color::xyz::{SRGB, xyy_from_xyz};
use lightbench::num::{U, gamma};

/// Everything here lies in [0, 1.1]: γ₂₀ · 6 for XYZ, which bounds the others, and half an ulp of the table.
#[test]
fn conversions_agree_with_their_table() {
    let table = include_str!("../data/colour_convert.csv");
    let shares =
        &["c", "m", "y", "hsv_s", "hsv_v", "hls_l", "hls_s", "X", "Y", "Z", "srgb_r", "srgb_g", "srgb_b"];
    all_right("colour_convert", table, columns(shares, 6.0 * 1.1 * gamma(20) + U));
    // A hue is a sum of a whole number and a quotient of differences of exact inputs: γ₄ of 6 sides of 60 degrees.
    all_right("colour_convert", table, columns(&["hsv_h", "hls_h"], 360.0 * gamma(4)));
}

/// A wavelength is known to the rounding of the table's chromaticities, γ₄, and of the difference from white over the
/// angle that a step of the table covers, and so is a purity.
fn dominant(nm: &'static str, purity: &'static str) -> impl Fn(&Record, &Record) -> Option<f64> {
    move |row, answer| {
        let wavelength = row.number(nm);
        if wavelength.is_none() {
            return Some(if answer.number("dominant_nm").is_none() { 0.0 } else { f64::INFINITY });
        }
        if answer.text("complementary") != row.text("complementary") {
            return Some(f64::INFINITY);
        }
        let white = glam::dvec2(row.number("xw")?, row.number("yw")?);
        let locus = Locus::of(Matching::Table1nm);
        let place = wavelength?.abs();
        // Of the steps on either side the narrower, as an angle.
        let step = |a: f64| (locus.at(a) - white).angle_to(locus.at(a + 1.0) - white).abs();
        let turn = step(place - 1.0).min(step(place.floor())).min(step(place));
        let digits = gamma(60) / turn;
        let error = (answer.number("dominant_nm")? - wavelength?).abs() / digits;
        let (found, known) = (answer.number("purity")?, row.number(purity)?);
        let relative = if found == known { 0.0 } else { (found - known).abs() / known };
        Some(error.max(relative / gamma(100)))
    }
}

#[test]
fn dominant_wavelengths_agree_with_their_table() {
    let table = include_str!("../data/dominant_wavelength.csv");
    all_right("dominant_wavelength", table, dominant("dominant_nm_1nm", "purity_1nm"));
    let coarse = dominant("dominant_nm_5nm", "purity_5nm");
    let (judged, wrong) = wrong_rows("dominant_wavelength", Some("5nm"), table, coarse);
    assert!(judged == 240 && wrong.is_empty(), "{}", wrong.join("\n"));
    // The table tells methods apart: 5 nm and 1 nm differ by up to 0.2 nm.
    let (_, wrong) =
        wrong_rows("dominant_wavelength", Some("5nm"), table, dominant("dominant_nm_1nm", "purity_1nm"));
    assert!(wrong.len() > 200, "only {} rows wrong", wrong.len());
}

/// Next to the white, far from it, on the line of purples, at the ends of the number range.
#[test]
fn dominant_wavelengths_agree_with_their_nasty_table() {
    let table = include_str!("../data/dominant_wavelength_nasty.csv");
    all_right("dominant_wavelength", table, dominant("dominant_nm", "purity"));
}

/// The derived matrices to γ₁₆ times the primaries' condition (below 10), the standard's forward one to its 4 digits.
#[test]
fn matrices_agree_with_the_standard() {
    let table = Table::read("rgb_xyz_matrices.csv");
    let matrix = |name: &str| {
        let row = table.rows().find(|r| r.text("name") == name).expect("a matrix");
        let entry = |i: usize, j: usize| row.f64(&format!("m{i}{j}"));
        DMat3::from_cols_array_2d(&[0, 1, 2].map(|j| [0, 1, 2].map(|i| entry(i, j))))
    };
    let largest = |m: DMat3| m.to_cols_array().iter().fold(0.0f64, |a, x| a.max(x.abs()));
    let forward = matrix("srgb_to_xyz_derived_D65_0.3127_0.3290");
    assert!(largest(SRGB.xyz_from_rgb - forward) <= 10.0 * gamma(16));
    assert!(largest(SRGB.rgb_from_xyz - matrix("xyz_to_srgb_derived")) <= 3.3 * 10.0 * gamma(16));
    assert!(largest(SRGB.xyz_from_rgb - matrix("srgb_to_xyz_IEC61966_4digit")) <= 0.5e-4);
    // Its inverse was made from the rounded matrix: 3 digits remain, and there and back again is off by 4e-5.
    let printed = matrix("xyz_to_srgb_IEC_published_4digit");
    assert!(largest(SRGB.rgb_from_xyz - printed) < 5e-4);
    let round_trip = largest(printed * matrix("srgb_to_xyz_IEC61966_4digit") - DMat3::IDENTITY);
    assert!(round_trip > 4e-5 && round_trip < 4.1e-5, "{round_trip:e}");
    assert!(largest(SRGB.rgb_from_xyz * SRGB.xyz_from_rgb - DMat3::IDENTITY) <= 60.0 * gamma(16));
}

/// The standard's own sums over 360 to 830 nm are 106.865, 106.857, 106.892 (CIE 018:2019, 3 decimals).
#[test]
fn the_matching_functions_have_their_known_sums() {
    let sum = |m: Matching, step: usize| -> DVec3 {
        (VISIBLE.0 as i32..=VISIBLE.1 as i32).step_by(step).map(|w| m.at(f64::from(w))).sum()
    };
    let known = dvec3(106.865, 106.857, 106.892);
    assert!(
        (sum(Matching::Table1nm, 1) - known).abs().max_element() < 0.6e-3,
        "{}",
        sum(Matching::Table1nm, 1)
    );
    let rows = Table::read("../../src/color/cie1931.csv");
    assert_eq!(rows.rows().count(), 471);
    for row in rows.rows() {
        let listed = dvec3(row.f64("xbar"), row.f64("ybar"), row.f64("zbar"));
        let w = row.f64("wavelength_nm");
        assert_eq!(Matching::Table1nm.at(w), listed);
        if w % 5.0 == 0.0 && (380.0..=780.0).contains(&w) {
            assert_eq!(Matching::Table5nm.at(w), listed);
        }
    }
    let e = xyy_from_xyz(Matching::Table1nm.xyz(|_| 1.0, 1.0)).expect("a white");
    assert!((e.luminance - 1.0).abs() <= gamma(480) && (e.xy - 1.0 / 3.0).length() < 1e-4);
}

/// What the fits promise: their largest error over the spectrum, and what they keep of the integrals.
#[test]
fn fits_follow_the_table() {
    let worst = |m: Matching| {
        (360..=830)
            .map(f64::from)
            .map(|w| (m.at(w) - Matching::Table1nm.at(w)).abs().max_element())
            .fold(0.0, f64::max)
    };
    let (multi, single) = (worst(Matching::MultiLobe), worst(Matching::SingleLobe));
    assert!(multi > 0.02 && multi < 0.06, "{multi}");
    assert!(single > 0.08 && single < 0.20, "{single}");
}

/// Peaks of the cones, energy at the cornea: 566 and 543 nm (DeMarco, Pokorny & Smith 1992); the short-wave cone of
/// the unrevised table follows z̄, which peaks at 446 nm.
#[test]
fn cones_peak_where_they_do() {
    let peak = |k: usize| {
        (380..=700)
            .max_by(|a, b| cones(f64::from(*a))[k].total_cmp(&cones(f64::from(*b))[k]))
            .expect("a peak")
    };
    assert_eq!([0, 1, 2].map(peak), [566, 543, 446]);
}

/// The diagram's area, by the trapezia of its outline.
#[test]
fn the_area_of_the_diagram_is_its_outline_s() {
    let points = Locus::of(Matching::Table1nm).points();
    let next = points.iter().cycle().skip(1);
    let trapezia: f64 = points.iter().zip(next).map(|(a, b)| (b.x - a.x) * (a.y + b.y) / 2.0).sum();
    assert!((area(points) - trapezia.abs()).abs() <= gamma(410), "{} {trapezia}", area(points));
}
