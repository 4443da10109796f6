//! Laws of colour: round trips, the edges of every model, dominant wavelengths, gamuts.

use crate::film::config;
use crate::support::nasty::{number, unit_interval};
use glam::{DVec2, DVec3, dvec2};
use lightbench::color::dominant::{Dominant, Locus, Rim, Wheel, purity_as_printed};
use lightbench::color::gamut::{IntoGamut, area, in_triangle, largest_triangle};
use lightbench::color::models::*;
use lightbench::color::spectrum::{Matching, black_body};
use lightbench::color::xyz::*;
use lightbench::color::{LUMINANCE, Rgb, luminance};
use lightbench::num::{U, gamma};
use proptest::prelude::*;

/// A channel of the cube: anything in [0,1], also 0, 1 and their neighbours.
fn channel() -> impl Strategy<Value = f64> + Clone {
    let near_white = (0u32..40).prop_map(|k| 1.0 - f64::from(k) * U);
    prop_oneof![4 => 0.0..=1.0f64, 2 => unit_interval(), 1 => near_white, 1 => Just(1.0), 1 => Just(0.5)]
        .boxed()
}

/// Colours of the cube, half of them grey but for a few roundings.
fn cube() -> impl Strategy<Value = Rgb> {
    let anywhere = (channel(), channel(), channel()).prop_map(|(r, g, b)| Rgb::new(r, g, b));
    let greyish =
        (channel(), 0.0..8.0f64, 0.0..8.0f64, 0usize..3, any::<bool>()).prop_map(|(v, a, b, k, small)| {
            let unit = if small { U } else { 1e-9 };
            let mut rgb = Rgb::splat(v);
            rgb[k] = (v - a.floor() * unit).max(0.0);
            rgb[(k + 1) % 3] = (v - b.floor() * unit).max(0.0);
            rgb
        });
    prop_oneof![anywhere, greyish]
}

fn wild() -> impl Strategy<Value = Rgb> {
    (number(), number(), number()).prop_map(|(x, y, z)| Rgb::new(x, y, z))
}

fn daylight() -> Wheel<'static> {
    Locus::of(Matching::Table1nm).wheel(D65).expect("daylight lies inside")
}

fn line(wavelength: f64) -> DVec2 {
    Locus::of(Matching::Table1nm).at(wavelength)
}

fn wavelength(found: Option<Dominant>) -> f64 {
    match found.map(|d| d.rim) {
        Some(Rim::Spectral(w)) => w,
        Some(Rim::Purple(w)) => -w,
        None => f64::NAN,
    }
}

/// Roundings of a chromaticity, some tens, over the angle that the table's step at a wavelength covers [nm].
fn sharpness(wavelength: f64) -> f64 {
    let step = |a: f64| (line(a) - D65).angle_to(line(a + 1.0) - D65).abs();
    gamma(60) / step(wavelength.floor()).min(step(wavelength - 1.0)).min(step(wavelength))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn hsv_round_trips(rgb in cube()) {
        let back = rgb_from_hsv(hsv_from_rgb(rgb));
        // Subnormal channels round to whole steps instead.
        let tolerance = gamma(12) * rgb.max_element() + 4.0 * f64::from_bits(1);
        prop_assert!((back - rgb).abs().max_element() <= tolerance, "{rgb} {back}");
    }

    #[test]
    fn hls_round_trips(rgb in cube()) {
        let back = rgb_from_hls(hls_from_rgb(rgb));
        prop_assert!((back - rgb).abs().max_element() <= gamma(14), "{rgb} {back}");
    }

    #[test]
    fn cmy_round_trips(rgb in cube()) {
        prop_assert!((rgb_from_cmy(cmy_from_rgb(rgb)) - rgb).abs().max_element() <= U);
        prop_assert_eq!(complement(rgb), cmy_from_rgb(rgb));
    }

    /// Two products of three terms; the entries of the matrices and their inverses multiply to 6 at most.
    #[test]
    fn xyz_round_trips(rgb in cube()) {
        let back = rgb_from_xyz(xyz_from_rgb(rgb));
        prop_assert!((back - rgb).abs().max_element() <= 6.0 * 6.0 * gamma(20), "{rgb} {back}");
    }

    /// x, y err by γ₃, and Z = (1 − x − y) Y/y loses their sizes over its own.
    #[test]
    fn xyy_round_trips(rgb in cube()) {
        let xyz = xyz_from_rgb(rgb);
        match xyy_from_xyz(xyz) {
            None => prop_assert_eq!(xyz.element_sum(), 0.0),
            Some(seen) => {
                let back = xyz_from_xyy(seen).expect("a colour of the cube has Y > 0");
                // Subnormal luminances have fewer digits.
                prop_assume!(xyz.y > 1e-290);
                prop_assert!((back - xyz).abs().max_element() <= gamma(12) * xyz.element_sum(), "{xyz} {back}");
            }
        }
    }

    #[test]
    fn saturations_and_hues_keep_their_ranges(rgb in cube()) {
        let (hsv, hls) = (hsv_from_rgb(rgb), hls_from_rgb(rgb));
        prop_assert!((0.0..=1.0).contains(&hsv.saturation) && (0.0..=1.0).contains(&hls.saturation));
        prop_assert!((0.0..=1.0).contains(&hls.lightness) && hsv.value == rgb.max_element());
        prop_assert!((0.0..SIDES).contains(&hsv.hue) && hsv.hue == hls.hue && degrees(hsv.hue) < 360.0);
    }

    #[test]
    fn greys_have_no_hue_and_no_saturation(v in channel()) {
        let grey = Rgb::splat(v);
        prop_assert_eq!(hue(grey), None);
        prop_assert_eq!(hsv_from_rgb(grey), Hsv { hue: 0.0, saturation: 0.0, value: v });
        prop_assert_eq!(hls_from_rgb(grey), Hls { hue: 0.0, lightness: v, saturation: 0.0 });
    }

    /// Exposure is no colour: powers of two change neither hue nor saturation by a bit.
    #[test]
    fn hue_and_saturation_do_not_depend_on_exposure(rgb in cube(), k in -60..60i32) {
        prop_assume!(rgb.to_array().iter().all(|c| *c == 0.0 || *c > 1e-280));
        let (a, b) = (hsv_from_rgb(rgb), hsv_from_rgb(rgb * 2f64.powi(k)));
        prop_assert_eq!((a.hue, a.saturation, a.value * 2f64.powi(k)), (b.hue, b.saturation, b.value));
    }

    /// Two channels change places: the hue is mirrored. Three go round: it turns by a third.
    #[test]
    fn hues_turn_with_the_channels(rgb in cube()) {
        let Some(h) = hue(rgb) else { return Ok(()) };
        let turned = hue(Rgb::new(rgb.z, rgb.x, rgb.y)).expect("no grey");
        let mirrored = hue(Rgb::new(rgb.x, rgb.z, rgb.y)).expect("no grey");
        let apart = |a: f64, b: f64| { let d = (a - b).rem_euclid(SIDES); d.min(SIDES - d) };
        prop_assert!(apart(turned, h + 2.0) <= 6.0 * gamma(4) && apart(mirrored, -h) <= 6.0 * gamma(4));
    }

    /// The complement lies opposite, half the hexagon away. 1 − x rounds by U, which counts over the chroma.
    #[test]
    fn complements_have_the_opposite_hue(rgb in cube()) {
        if let (Some(a), Some(b)) = (hue(rgb), hue(complement(rgb))) {
            let chroma = rgb.max_element() - rgb.min_element();
            let apart = ((a - b).abs() - 3.0).abs();
            prop_assert!(apart <= 6.0 * gamma(8) + 8.0 * U / chroma, "{rgb}: {a} and {b}");
        }
    }

    /// max = 1 − m u, min = 1 − n u: the saturation is (n − m)/(n + m) in whole numbers, and one quotient rounds.
    #[test]
    fn hls_keeps_its_digits_next_to_white(m in 0u64..1 << 40, more in 1u64..1 << 40) {
        let n = m + more;
        let rgb = Rgb::new(1.0 - m as f64 * U, 1.0 - n as f64 * U, 1.0 - n as f64 * U);
        let exact = more as f64 / (n + m) as f64;
        prop_assert!((hls_from_rgb(rgb).saturation - exact).abs() <= gamma(3) * exact);
    }

    /// Finite numbers of any size and sign give numbers.
    #[test]
    fn no_conversion_makes_nan(rgb in wild()) {
        let (hsv, hls) = (hsv_from_rgb(rgb), hls_from_rgb(rgb));
        for x in [hsv.hue, hsv.saturation, hsv.value, hls.hue, hls.lightness, hls.saturation] {
            prop_assert!(!x.is_nan(), "{rgb} {hsv:?} {hls:?}");
        }
        prop_assert!((0.0..SIDES).contains(&hsv.hue));
        if rgb.abs().max_element() < 1e300 {
            prop_assert!(!xyz_from_rgb(rgb).is_nan() && !rgb_from_xyz(rgb).is_nan());
            for way in IntoGamut::ALL {
                let shown = way.apply(rgb);
                prop_assert!(shown.min_element() >= 0.0, "{rgb} {shown}");
            }
        }
        for xyy in [xyy_from_xyz(rgb)].into_iter().flatten() {
            prop_assert!(xyy.xy.is_finite());
        }
        if let Some(found) = daylight().dominant(rgb.truncate()) {
            prop_assert!(found.purity > 0.0 && (380.0..=780.0).contains(&wavelength(Some(found)).abs()));
        }
    }

    #[test]
    fn extreme_sizes_of_both_signs_give_numbers(r in -1.0..1.0f64, g in -1.0..1.0f64, b in -1.0..1.0f64) {
        let rgb = Rgb::new(r, g, b) * f64::MAX;
        let (hsv, hls) = (hsv_from_rgb(rgb), hls_from_rgb(rgb));
        let all = [hsv.hue, hsv.saturation, hls.hue, hls.saturation, hls.lightness];
        prop_assert!(all.iter().all(|x| !x.is_nan()), "{hsv:?} {hls:?}");
    }

    /// A line of the spectrum has its own wavelength and purity 1, and keeps the wavelength mixed with white.
    #[test]
    fn spectral_colours_have_their_wavelength(w in 380.0..698.0f64, part in 1e-3..1.0f64) {
        let wheel = daylight();
        let pure = wheel.dominant(line(w)).expect("a line");
        prop_assert!((wavelength(Some(pure)) - w).abs() <= sharpness(w), "{w}: {pure:?}");
        prop_assert!((pure.purity - 1.0).abs() <= gamma(100));
        let mixed = wheel.dominant(D65.lerp(line(w), part)).expect("a colour");
        // The mixture is rounded at the size of white.
        prop_assert!((wavelength(Some(mixed)) - w).abs() <= sharpness(w) / part);
        prop_assert!((mixed.purity - part).abs() <= gamma(100));
    }

    /// Mixtures of lines lie inside, but for the table: its curve is not quite convex, and a mixture of 589 and 603 nm lies
    /// beyond it by 6e-5. The convex hull of its points lies at most 2.93e-4 of the way beyond it (at 394 nm, seen from D65).
    #[test]
    fn purities_of_light_lie_in_the_unit_interval(
        lines in prop::collection::vec((380.0..780.0f64, 0.0..1.0f64), 1..6),
    ) {
        let xyz: Xyz = lines.iter().map(|(w, power)| Matching::Table1nm.at(*w) * *power).sum();
        let Some(seen) = xyy_from_xyz(xyz) else { return Ok(()) };
        if let Some(found) = daylight().dominant(seen.xy) {
            prop_assert!(found.purity > 0.0 && found.purity <= 1.0 + 2.93e-4 + gamma(100), "{found:?}");
        }
    }

    #[test]
    fn the_complementary_of_the_complementary_is_the_first(w in 380.0..698.0f64) {
        let wheel = daylight();
        match wheel.complementary(w) {
            // Only greens have none: opposite them lie the purples.
            None => prop_assert!((490.0..570.0).contains(&w), "{w}"),
            Some(partner) => {
                prop_assume!(partner < 698.0);
                let back = wheel.complementary(partner).expect("there is the way back");
                // Both ways err by an angle of γ₆₀ each, there and back, which at the end counts in wavelengths at w.
                prop_assert!((back - w).abs() <= 4.0 * sharpness(w), "{w} {partner} {back}");
                // And white lies between them.
                let (a, b) = (line(w) - D65, line(partner) - D65);
                prop_assert!(a.dot(b) < 0.0 && a.perp_dot(b).abs() <= gamma(100));
            }
        }
    }

    /// Halving searches what a scan over all segments finds.
    #[test]
    fn searching_agrees_with_a_scan(x in -0.2..1.0f64, y in -0.2..1.0f64) {
        let (wheel, locus, d) = (daylight(), Locus::of(Matching::Table1nm), dvec2(x, y) - D65);
        let scan = locus.points().windows(2).enumerate().find_map(|(i, p)| {
            let (a, b) = ((p[0] - D65).perp_dot(d), (p[1] - D65).perp_dot(d));
            let met = a < 0.0 && b >= 0.0 && (p[0] - D65).dot(d) > 0.0;
            met.then(|| locus.wavelength(i) + a / (a - b))
        });
        match (wheel.dominant(dvec2(x, y)).map(|d| d.rim), scan) {
            (Some(Rim::Spectral(found)), Some(w)) => prop_assert!((found - w).abs() <= 2.0 * sharpness(w)),
            (Some(Rim::Purple(_)), None) => {}
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// The direction alone decides: from 2⁻¹ to 2⁻⁴⁰ of the way, exactly scaled, the wavelength is the same to the bit.
    #[test]
    fn nearness_to_white_costs_no_digit(i in -4096i32..4096, j in -4096i32..4096, k in 0i32..26) {
        let white = dvec2(0.3125, 0.328125);
        let wheel = Locus::of(Matching::Table1nm).wheel(white).expect("a white");
        let step = dvec2(f64::from(i), f64::from(j)) / 16384.0;
        let (far, near) = (wheel.dominant(white + step), wheel.dominant(white + step * 2f64.powi(-k)));
        prop_assert_eq!(far.map(|d| d.rim), near.map(|d| d.rim));
        prop_assert_eq!(far.map(|d| d.purity), near.map(|d| d.purity * 2f64.powi(k)));
        prop_assert_eq!(far.is_none(), i == 0 && j == 0);
    }

    #[test]
    fn the_line_of_purples_is_purple_and_pure(share in 0.01..0.99f64) {
        let [violet, red] = Locus::of(Matching::Table1nm).purple_line();
        let found = daylight().dominant(violet.lerp(red, share)).expect("a purple");
        prop_assert!(matches!(found.rim, Rim::Purple(w) if (490.0..570.0).contains(&w)), "{found:?}");
        prop_assert!((found.purity - 1.0).abs() <= gamma(100));
    }

    /// In the gamut nothing changes; outside, desaturating keeps luminance and dominant wavelength.
    #[test]
    fn desaturating_keeps_luminance_and_hue(w in 385.0..690.0f64, purity in 0.01..1.0f64) {
        let (wheel, xy) = (daylight(), D65.lerp(line(w), purity));
        let rgb = rgb_from_xyz(xyz_from_xyy(Xyy { xy, luminance: 1.0 }).expect("a colour"));
        let shown = IntoGamut::default().apply(rgb);
        let size = rgb.abs().max_element();
        prop_assert!(shown.min_element() >= 0.0);
        prop_assert!((luminance(shown) - 1.0).abs() <= size * gamma(60), "{rgb} {shown}");
        if rgb.min_element() >= 0.0 {
            prop_assert_eq!(shown, rgb);
            prop_assert_eq!(IntoGamut::Clip.apply(rgb), rgb);
        } else {
            prop_assert_eq!(shown.min_element(), 0.0);
            let seen = xyy_from_xyz(xyz_from_rgb(shown)).expect("light");
            let found = wheel.dominant(seen.xy).expect("a colour");
            // Two matrices and a mixture: some hundreds of roundings, over the purity that is left.
            let tolerance = 20.0 * size * sharpness(w) / found.purity.min(purity);
            prop_assert!((wavelength(Some(found)) - w).abs() <= tolerance, "{w}: {found:?}");
            // Clipping adds the light that the negative channel took.
            let added = -LUMINANCE.dot(rgb.min(Rgb::ZERO));
            prop_assert!((luminance(IntoGamut::Clip.apply(rgb)) - 1.0 - added).abs() <= size * gamma(60));
        }
    }

    /// Light adds: a mixture lies on the line between its parts.
    #[test]
    fn mixtures_lie_between_their_parts(a in cube(), b in cube()) {
        let (p, q) = (xyy_from_xyz(xyz_from_rgb(a)), xyy_from_xyz(xyz_from_rgb(b)));
        let (Some(p), Some(q), Some(m)) = (p, q, xyy_from_xyz(xyz_from_rgb(a + b))) else { return Ok(()) };
        prop_assume!(a.max_element().min(b.max_element()) > 1e-280);
        prop_assert!((q.xy - p.xy).perp_dot(m.xy - p.xy).abs() <= gamma(200));
        prop_assert!(in_triangle(Primaries::REC_709.corners().map(|c| D65 + (c - D65) * (1.0 + 1e-12)), m.xy));
    }
}

#[test]
fn the_corners_of_the_cube_are_exact() {
    let corners = [(1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1), (1, 0, 1)];
    for (side, (r, g, b)) in corners.into_iter().enumerate() {
        let rgb = Rgb::new(f64::from(r), f64::from(g), f64::from(b));
        let (hsv, hls) = (hsv_from_rgb(rgb), hls_from_rgb(rgb));
        assert_eq!((hsv.hue, hsv.saturation, hsv.value), (side as f64, 1.0, 1.0));
        assert_eq!((hls.hue, hls.lightness, hls.saturation), (side as f64, 0.5, 1.0));
        assert_eq!((rgb_from_hsv(hsv), rgb_from_hls(hls)), (rgb, rgb));
        assert_eq!(complement(complement(rgb)), rgb);
        // Any number of turns round the hexagon comes back.
        assert_eq!(rgb_from_hsv(Hsv { hue: hsv.hue - 12.0, ..hsv }), rgb);
    }
    assert_eq!(rgb_from_hls(Hls { hue: 4.2, lightness: 1.0, saturation: 1.0 }), Rgb::ONE);
    assert_eq!(rgb_from_hsv(Hsv { hue: 4.2, saturation: 1.0, value: 0.0 }), Rgb::ZERO);
}

#[test]
fn a_red_with_a_breath_of_blue_stays_under_six() {
    for breath in [1e-3, U, 1e-20, 5e-324] {
        let h = hue(Rgb::new(1.0, 0.0, breath)).expect("a red");
        assert!(h < SIDES && h >= SIDES - 1.1e-3, "{h}");
    }
    assert_eq!(hue(Rgb::new(1.0, 0.0, 1e-20)), Some(SIDES.next_down()));
    assert_eq!(hue(Rgb::NAN), None);
    assert!(hsv_from_rgb(Rgb::NAN).saturation.is_nan() && hls_from_rgb(Rgb::NAN).lightness.is_nan());
    assert_eq!(hsv_from_rgb(Rgb::new(0.0, -1.0, 0.0)).saturation, f64::INFINITY);
}

/// As documented: the textbook's divisor loses what (1 − max) + (1 − min) keeps.
#[test]
fn the_textbook_saturation_fails_next_to_white() {
    let rgb = Rgb::new(1.0 - U, 1.0 - 2.0 * U, 1.0 - 2.0 * U);
    assert_eq!(hls_from_rgb(rgb).saturation, 1.0 / 3.0);
    assert_eq!(hls_saturation_textbook(rgb), 0.5);
}

#[test]
fn matrices_come_from_the_primaries() {
    let p = Primaries::REC_709;
    for (i, xy) in [p.red, p.green, p.blue].into_iter().enumerate() {
        let seen = xyy_from_xyz(xyz_from_rgb(DVec3::AXES[i])).expect("a lamp");
        assert!((seen.xy - xy).abs().max_element() <= gamma(16), "{seen:?}");
        assert_eq!(seen.luminance, LUMINANCE[i]);
    }
    let white = xyy_from_xyz(xyz_from_rgb(Rgb::ONE)).expect("white");
    assert!((white.xy - D65).length() <= 6.0 * gamma(20) && (white.luminance - 1.0).abs() <= 6.0 * gamma(20));
    // The imaginary primaries X, Y, Z of the standard observer have the identity as their matrix.
    let xyz = Primaries {
        red: dvec2(1.0, 0.0),
        green: dvec2(0.0, 1.0),
        blue: dvec2(0.0, 0.0),
        white: EQUAL_ENERGY,
    };
    let identity = xyz.space().expect("a space").xyz_from_rgb - glam::DMat3::IDENTITY;
    assert!(identity.to_cols_array().iter().all(|x| x.abs() <= gamma(8)));
    assert_eq!(Primaries { green: p.red, ..p }.space(), None);
    assert_eq!(Primaries { white: dvec2(0.3, 0.0), ..p }.space(), None);
    assert_eq!(Primaries { white: p.red, ..p }.space(), None);
    assert_eq!(Primaries { red: DVec2::NAN, ..p }.space(), None);
}

#[test]
fn black_has_no_chromaticity() {
    assert_eq!(xyy_from_xyz(Xyz::ZERO), None);
    assert_eq!(xyy_from_xyz(Xyz::NAN), None);
    assert_eq!(xyz_from_xyy(Xyy { xy: dvec2(0.3, 0.0), luminance: 0.0 }), Some(Xyz::ZERO));
    assert_eq!(xyz_from_xyy(Xyy { xy: dvec2(0.3, 0.0), luminance: 1.0 }), None);
    let huge = xyy_from_xyz(Xyz::splat(f64::MAX)).expect("a chromaticity");
    assert!((huge.xy - 1.0 / 3.0).abs().max_element() <= U);
}

#[test]
fn white_has_no_dominant_wavelength() {
    let (wheel, locus) = (daylight(), Locus::of(Matching::Table1nm));
    assert_eq!(wheel.dominant(D65), None);
    assert_eq!(wheel.dominant(DVec2::NAN), None);
    assert_eq!(wheel.dominant(dvec2(f64::INFINITY, 0.0)), None);
    assert!(
        wheel.dominant(dvec2(0.0, 1.0)).is_some_and(|d| d.purity > 1.0),
        "imaginary colours lie beyond the rim"
    );
    for outside in [dvec2(0.8, 0.8), dvec2(0.5, 0.1), dvec2(-0.1, 0.3), DVec2::NAN] {
        assert!(locus.wheel(outside).is_none() && !locus.contains(outside));
    }
    for inside in [D65, EQUAL_ENERGY, dvec2(0.05, 0.3), dvec2(0.7, 0.27), dvec2(0.2, 0.05)] {
        assert!(locus.contains(inside), "{inside}");
    }
    // Right above the white, where a slope would divide by nothing.
    assert!((540.0..570.0).contains(&wavelength(wheel.dominant(dvec2(D65.x, 0.6)))));
}

/// Where the table's points curl within 1e-7, a colour still has a wavelength of the red end.
#[test]
fn the_red_end_stays_red() {
    for w in 690..=780 {
        let found = wavelength(daylight().dominant(line(f64::from(w))));
        assert!(found > 689.0 && found <= f64::from(w) + 1e-6, "{w}: {found}");
    }
}

#[test]
fn no_triangle_covers_the_diagram() {
    let locus = Locus::of(Matching::Table1nm);
    let corners = largest_triangle(Locus::of(Matching::Table5nm)).map(line);
    let share = area(&corners) / area(locus.points());
    assert!(share > 0.7 && share < 0.75, "{share}");
    assert!(area(&Primaries::REC_709.corners()) < area(&corners));
    assert!(!in_triangle(corners, line(500.0)) && in_triangle(corners, D65));
    assert_eq!(area(&[]), 0.0);
    assert_eq!(area(&[D65, EQUAL_ENERGY]), 0.0);
}

/// Document C's rule against the diagram, and its luminance against Y.
#[test]
fn printed_statements_fail_where_they_are_said_to() {
    let wheel = Locus::of(Matching::Table1nm).wheel(EQUAL_ENERGY).expect("a white");
    let (a, b) = (line(490.0), line(600.0));
    let share = (EQUAL_ENERGY - a).dot(b - a) / (b - a).length_squared();
    assert!(wheel.dominant(a.lerp(b, share)).is_none_or(|d| d.purity < 1e-3));
    assert_eq!((purity_as_printed(1), purity_as_printed(2)), (1.0, 0.5));
    let blue = Matching::Table1nm.at(450.0);
    assert!(luminance_as_printed(blue) > 50.0 * blue.y);
}

#[test]
fn spectra_outside_the_table_are_dark() {
    for m in [Matching::Table1nm, Matching::Table5nm] {
        for w in [-1.0, 0.0, 300.0, 830.5, 1e300, f64::INFINITY] {
            assert_eq!(m.at(w), Xyz::ZERO, "{} at {w}", m.name());
        }
    }
    for m in Matching::ALL {
        assert!(m.at(f64::NAN).is_nan(), "{}", m.name());
    }
    // Hot bodies are bluish, cold ones reddish, and all lie inside.
    let x = |kelvin: f64| {
        let seen = xyy_from_xyz(Matching::Table1nm.xyz(|w| black_body(w, kelvin), 5.0)).expect("light");
        assert!(Locus::of(Matching::Table1nm).contains(seen.xy));
        seen.xy.x
    };
    assert!(x(2000.0) > x(4000.0) && x(4000.0) > x(10000.0));
    // Illuminant A, 2856 K with today's c₂: (0.4476, 0.4074) to its 4 digits.
    let a = xyy_from_xyz(Matching::Table1nm.xyz(|w| black_body(w, 2855.5), 1.0)).expect("light").xy;
    assert!((a - dvec2(0.44758, 0.40745)).length() < 1e-4, "{a}");
}
