//! Frames, rotations, normals, cameras.

use glam::{DMat3, DVec2, DVec3};
use lightbench::frame::{Frame, basis, duff, frisvad, rotation_about, transform_normal, unit};
use lightbench::num::U;
use lightbench::num::gamma;
use lightbench::num::real::{Real, Triple};
use lightbench::scene::{
    Camera, FieldOfView, camera_from_screen, ndc_from_raster, obscura_from_camera, screen_from_ndc,
};
use proptest::prelude::*;

fn vector() -> impl Strategy<Value = DVec3> {
    let axis = prop_oneof![-1.0..1.0f64, Just(0.0), Just(-0.0), Just(1.0e-150), Just(1.0e150), Just(-1.0)];
    (axis.clone(), axis.clone(), axis).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn is_orthonormal(frame: &Frame) -> bool {
    let (r, u, f) = (frame.right, frame.up, frame.forward);
    // Each vector is normalised by its length (5 roundings), and products of two such add 3 more.
    let close = |x: f64, to: f64| (x - to).abs() <= gamma(16);
    // Two unit vectors whose angle is θ give a cross product known to u/sin θ; look_at guards sin θ > 1e-8,
    // but both crosses are renormalised, so that perpendicularity itself holds to rounding.
    close(r.length(), 1.0)
        && close(u.length(), 1.0)
        && close(f.length(), 1.0)
        && r.dot(u).abs() <= gamma(16)
        && u.dot(f).abs() <= gamma(16)
        && (r.cross(u) + f).length() <= 1e-7
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn look_at_is_orthonormal_whatever_up_is(eye in vector(), target in vector(), up in vector()) {
        if let Ok(frame) = Frame::look_at(eye, target, up) {
            prop_assert!(is_orthonormal(&frame), "{frame:?}");
        } else {
            prop_assert!(eye == target || (target * 0.5 - eye * 0.5) == DVec3::ZERO);
        }
    }

    #[test]
    fn frames_around_any_direction_are_orthonormal(v in vector()) {
        if let Some(forward) = unit(v) {
            prop_assert!(is_orthonormal(&Frame::around(forward)));
        }
    }

    #[test]
    fn rotations_keep_lengths_and_their_axis(axis in vector(), angle in -1.0e3..1.0e3f64, v in vector()) {
        if let (Some(m), Some(v), Some(a)) = (rotation_about(axis, angle), unit(v), unit(axis)) {
            prop_assert!(((m * v).length() - 1.0).abs() <= gamma(40)); // 8 u an entry, three entries a sum
            prop_assert!((m * a - a).length() <= gamma(40));
        }
    }

    #[test]
    fn transformed_normals_stay_perpendicular(
        x in vector(), y in vector(), z in vector(), n in vector(), side in vector(),
    ) {
        let m = DMat3::from_cols(x, y, z);
        let (Some(n), Some(side)) = (unit(n), unit(side)) else { return Ok(()) };
        let tangent = side - n * side.dot(n);
        let size = x.length().max(y.length()).max(z.length());
        // A map that flattens by more than 1e-3 magnifies the rounding of t·n; others stay within 1e-11.
        let well_conditioned = m.determinant().abs() > 1e-3 * size.powi(3) && size < 1e100 && size > 1e-100;
        if let (true, Some(mapped)) = (well_conditioned, transform_normal(&m, n)) {
            let moved = m * tangent / size;
            prop_assert!(mapped.dot(moved).abs() <= 1e-11, "{}", mapped.dot(moved));
        }
    }
}

/// 1 … 9 is singular; the nearest numbers to 0.1 … 0.9 are not: their determinant is 4.2·10⁻¹⁸ exactly, so that the
/// rounded one may have either sign. Powers of two scale nothing away.
#[test]
fn normals_take_the_sign_of_the_exact_determinant() {
    let rows = |r: [f64; 9]| DMat3::from_cols_array(&r).transpose();
    let whole = rows([1., 2., 3., 4., 5., 6., 7., 8., 9.]);
    assert_eq!(transform_normal(&whole, DVec3::Z), None);
    let tenths = rows([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]);
    let found = transform_normal(&tenths, DVec3::Z).expect("determinant 4.2e-18");
    // The cofactors of the last column: −3, 6, −3 hundredths, each to a few roundings of products up to 0.48.
    let expected = DVec3::new(-1.0, 2.0, -1.0) / 6f64.sqrt();
    assert!((found - expected).length() <= gamma(8) * 0.5 / 0.03, "{found}");
    assert_eq!(transform_normal(&rows([1., 0., 0., 0., 1., 0., 0., 0., 0.]), DVec3::Z), None);
    let stretch = DMat3::from_diagonal(DVec3::new(1e200, 1e-200, 1.0));
    assert_eq!(transform_normal(&stretch, DVec3::new(1.0, 1.0, 0.0)), Some(DVec3::Y));
    let mirror = DMat3::from_diagonal(DVec3::new(1e-300, 1e-300, -1e-300));
    assert_eq!(transform_normal(&mirror, DVec3::Z), Some(-DVec3::Z));
}

#[test]
fn up_parallel_to_the_view_still_gives_a_frame() {
    for up in [DVec3::Y, DVec3::NEG_Y, DVec3::ZERO, DVec3::new(1e-12, 1.0, 0.0)] {
        let frame = Frame::look_at(DVec3::ZERO, DVec3::NEG_Y * 3.0, up).expect("a frame");
        assert!(is_orthonormal(&frame));
    }
}

#[test]
fn rotations_by_right_angles_turn_counter_clockwise() {
    let m = rotation_about(DVec3::Z * 7.0, std::f64::consts::FRAC_PI_2).expect("an axis");
    // cos(π/2) as f64 is 6e-17, hence a rounding's worth of slack.
    assert!((m * DVec3::X - DVec3::Y).length() <= gamma(8));
}

/// The example of [B §5.2]: 7 × 5 pixels, 90° upwards, the image plane at distance 1.
#[test]
fn the_camera_chain_maps_the_corners_of_b_s_picture() {
    let size = DVec2::new(7.0, 5.0);
    let fov = FieldOfView::Vertical(std::f64::consts::FRAC_PI_2);
    let screen = |raster| screen_from_ndc(ndc_from_raster(raster, size), 7.0 / 5.0, fov);
    assert!((screen(DVec2::ZERO) - DVec2::new(-1.4, 1.0)).length() <= gamma(8));
    assert!((screen(size) - DVec2::new(1.4, -1.0)).length() <= gamma(8));
    assert!((camera_from_screen(screen(size * 0.5)) - DVec3::NEG_Z).length() <= gamma(8));
}

#[test]
fn the_camera_obscura_inverts_both_axes() {
    let film = obscura_from_camera(DVec3::new(2.0, 3.0, -4.0), 1.0).expect("in front of the hole");
    assert_eq!(film, DVec2::new(-0.5, -0.75));
    assert_eq!(obscura_from_camera(DVec3::new(0.0, 0.0, 1.0), 1.0), None);
}

#[test]
fn impossible_cameras_are_refused() {
    let angle = |degrees: f64| FieldOfView::Vertical(degrees.to_radians());
    let camera = |target, degrees| Camera::new(DVec3::ZERO, target, DVec3::Y, angle(degrees));
    assert!(camera(DVec3::NEG_Z, 45.0).is_ok());
    assert!(camera(DVec3::ZERO, 45.0).is_err());
    for degrees in [0.0, -1.0, 180.0, 360.0, f64::NAN, f64::INFINITY] {
        assert!(camera(DVec3::NEG_Z, degrees).is_err(), "{degrees}");
    }
}

/// How far three vectors are from orthonormal, in `f64`.
fn defect<R: Real>(x: Triple<R>, y: Triple<R>, n: Triple<R>) -> f64 {
    let v = [x, y, n].map(|v| DVec3::from_array(v.map(R::to_f64)));
    let off = |i: usize, j: usize| (v[i].dot(v[j]) - if i == j { 1.0 } else { 0.0 }).abs();
    (0..3).flat_map(|i| (i..3).map(move |j| (i, j))).map(|(i, j)| off(i, j)).fold(0.0, f64::max)
}

/// `z = −1 + gap`, at that turn about the axis.
fn near_the_pole<R: Real>(gap: f64, turn: f64) -> Triple<R> {
    let (sin, cos) = turn.sin_cos();
    let out = (gap * (2.0 - gap)).sqrt();
    [out * cos, out * sin, gap - 1.0].map(R::from_f64)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// A rounded direction has a length within 2 u of 1, which the basis inherits a few times.
    #[test]
    fn duffs_basis_is_orthonormal_at_every_pole(exponent in -20.0..0.3f64, turn in 0.0..std::f64::consts::TAU) {
        let n: Triple<f32> = near_the_pole(10f64.powf(exponent), turn);
        let (x, y) = duff(n);
        prop_assert!(defect(x, y, n) <= 16.0 * f32::ROUNDOFF);
        let n: Triple<f64> = near_the_pole(10f64.powf(exponent), turn);
        let (x, y) = duff(n);
        prop_assert!(defect(x, y, n) <= 16.0 * U);
        prop_assert_eq!(basis(n.into()), (x.into(), y.into()));
    }

    /// On the half without the pole both are the same formula.
    #[test]
    fn frisvads_basis_is_duffs_on_the_upper_half(v in vector()) {
        if let Some(n) = unit(v).filter(|n| n.z >= 0.0 && n.z.is_sign_positive()) {
            let (a, b) = (frisvad(n.to_array()), duff(n.to_array()));
            prop_assert!((DVec3::from(a.0) - DVec3::from(b.0)).length() <= 4.0 * U);
            prop_assert!((DVec3::from(a.1) - DVec3::from(b.1)).length() <= 4.0 * U);
        }
    }

    /// `n` of length `1 + e` gives a defect of about `2 e/(1 + z)`; `e` is 2 u and the fraction rounds some more.
    #[test]
    fn frisvads_basis_errs_by_u_over_the_gap(exponent in -6.5..0.0f64, turn in 0.0..std::f64::consts::TAU) {
        let gap = 10f64.powf(exponent);
        let n: Triple<f64> = near_the_pole(gap, turn);
        let (x, y) = frisvad(n);
        prop_assert!(defect(x, y, n) <= 16.0 * U / gap);
    }
}

/// In `f32`, just before Frisvad's patch, hardly a digit is left.
#[test]
fn frisvads_basis_loses_its_digits_at_the_pole() {
    type Basis = fn(Triple<f32>) -> (Triple<f32>, Triple<f32>);
    let worst = |basis: Basis| {
        let each = |k: i32| near_the_pole(1.5e-7, f64::from(k) * 0.01);
        (0..628).map(|k| (each(k), basis(each(k)))).map(|(n, (x, y))| defect(x, y, n)).fold(0.0, f64::max)
    };
    assert!(worst(frisvad) > 0.1 && worst(duff) < 1e-6);
}
