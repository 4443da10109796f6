//! Randomness against published vectors, tables and closed forms.

use crate::support::chi2::{chi2, chi2_uniform};
use crate::support::table::Row;
use crate::support::{Table, mean_matches, seed};
use glam::{DVec2, DVec3};
use lightbench::num::gamma;
use lightbench::sample::*;
use std::f64::consts::{FRAC_1_PI, PI, TAU};

#[test]
fn philox_passes_the_known_answer_tests() {
    // Random123's kat_vectors: zeros, ones, digits of π.
    let known = [
        ([0; 4], [0; 2], [0x6627_E8D5, 0xE169_C58D, 0xBC57_AC4C, 0x9B00_DBD8]),
        ([u32::MAX; 4], [u32::MAX; 2], [0x408F_276D, 0x41C8_3B0E, 0xA20B_C7C6, 0x6D54_51FD]),
        (
            [0x243F_6A88, 0x85A3_08D3, 0x1319_8A2E, 0x0370_7344],
            [0xA409_3822, 0x299F_31D0],
            [0xD16C_FE09, 0x94FD_CCEB, 0x5001_E420, 0x2412_6EA1],
        ),
    ];
    for (counter, key, words) in known {
        assert_eq!(philox4x32(counter, key), words);
    }
}

#[test]
fn directions_have_the_moments_of_their_lobe() {
    let points = |name: &str| {
        let s = seed(name);
        (0..400_000).map(move |i| point2(s, 0, i))
    };
    mean_matches("sphere, cos²", 1.0 / 3.0, points("a").map(|u| uniform_sphere(u).z.powi(2)));
    mean_matches("sphere, cos", 0.0, points("b").map(|u| uniform_sphere(u).z));
    mean_matches("hemisphere, cos", 0.5, points("c").map(|u| uniform_hemisphere(u).z));
    mean_matches("cosine, cos", 2.0 / 3.0, points("d").map(|u| cosine_hemisphere(u).z));
    for n in [0.0, 2.0, 50.0] {
        let truth = (n + 1.0) / (n + 2.0);
        mean_matches("power cosine, cos", truth, points("e").map(|u| power_cosine(u, n).z));
    }
    mean_matches("disc, r²", 0.5, points("f").map(|u| uniform_disc(u).length_squared()));
    // The mistakes: latitude uniform, E[cos²] = 1/2 (the printed constants shift it by 1e-6); the ball, E[cos] = 4/5.
    mean_matches("as printed, cos²", 0.5, points("g").map(|u| sphere_as_printed(u).z.powi(2)));
    let ball = (0..400_000).map(|i| {
        let mut s = Sampler::new(seed("h"), 0, i);
        (DVec3::Z + uniform_sphere(s.next_2d()) * s.next_1d().cbrt()).normalize().z
    });
    mean_matches("normal plus ball, cos", 0.8, ball);
}

/// Latitude and longitude uniform, with exact constants: what [A ill. 46] means to do.
fn latitude_longitude(u: DVec2) -> DVec3 {
    let ((sin, cos), (y, x)) = ((PI * u.x).sin_cos(), (TAU * u.y).sin_cos());
    DVec3::new(sin * x, sin * y, cos)
}

/// Counts in cells of equal area, `bins = [bins_z, bins_phi]`.
fn histogram(bins: [usize; 2], samples: impl Iterator<Item = DVec3>) -> Vec<u64> {
    let mut counts = vec![0; bins[0] * bins[1]];
    let at = |x: f64, n: usize| ((x * n as f64) as usize).min(n - 1);
    for w in samples {
        let turn = if bins[1] > 1 { (w.y.atan2(w.x) / TAU).rem_euclid(1.0) } else { 0.0 };
        counts[at(0.5 * (w.z + 1.0), bins[0]) * bins[1] + at(turn, bins[1])] += 1;
    }
    counts
}

fn bins(row: Row) -> [usize; 2] {
    [row.f64("bins_z") as usize, row.f64("bins_phi") as usize]
}

#[test]
fn chi_square_of_the_sphere_has_the_tabulated_mean() {
    // Chi² has skewness √(8/dof): as many runs as `mean_matches` asks for, and a thousand.
    for row in Table::read("chi2_sphere.csv").rows().filter(|row| row.f64("N") == 1000.0) {
        let runs = 1000 + (1600.0 * 8.0 / row.f64("dof")) as u32;
        let bins = bins(row);
        for (column, warp) in [
            ("E_chi2_uniform", uniform_sphere as fn(DVec2) -> DVec3),
            ("E_chi2_latlong", latitude_longitude as fn(DVec2) -> DVec3),
        ] {
            let s = seed(column);
            let statistics = (0..runs).map(|run| {
                let counts = histogram(bins, (0..1000).map(|i| warp(point2(s, run, i))));
                chi2_uniform(&counts).statistic
            });
            let name = format!("{column} {} × {}", row.text("bins_z"), row.text("bins_phi"));
            mean_matches(&name, row.f64(column), statistics);
        }
    }
}

#[test]
fn chi_square_tells_the_sphere_from_latitude_and_longitude() {
    for row in Table::read("chi2_sphere.csv").rows() {
        let (n, critical) = (row.f64("N") as u32, row.f64("chi2_crit_p1e6"));
        let judge = |warp: fn(DVec2) -> DVec3| {
            let counts = histogram(bins(row), (0..n).map(|i| warp(point2(seed("judge"), 0, i))));
            chi2(&counts, &vec![row.f64("expected_per_bin"); counts.len()])
        };
        let uniform = judge(uniform_sphere);
        assert!(uniform.passes(), "{uniform:?}");
        assert_eq!(f64::from(uniform.dof), row.f64("dof"));
        // Where twice the critical value is expected: two hemispheres see no difference, nor do a few samples.
        if row.f64("E_chi2_latlong") > 2.0 * critical {
            for warp in [latitude_longitude, sphere_as_printed] {
                let crowded = judge(warp);
                assert!(crowded.statistic > critical && !crowded.passes(), "{crowded:?}");
            }
        }
    }
}

#[test]
fn densities_agree_with_the_table_of_latitude_and_longitude() {
    for row in Table::read("latlong_bias.csv").rows() {
        let (sin, cos) = row.f64("theta").sin_cos();
        let w = DVec3::new(sin * 0.6, sin * 0.8, cos);
        let crowded = row.f64("pdf_solid_angle_latlong");
        // Six roundings; near θ = π the sine of the rounded θ is that of the table, whose input it is.
        assert!((sphere_as_printed_pdf(w) - crowded).abs() <= gamma(8) * crowded);
        let uniform = row.f64("pdf_solid_angle_uniform");
        assert!((uniform_sphere_pdf() - uniform).abs() <= gamma(2) * uniform);
        let ratio = row.f64("ratio");
        assert!((sphere_as_printed_pdf(w) / uniform_sphere_pdf() - ratio).abs() <= gamma(12) * ratio);
    }
    // The distribution of the angle from the pole, at the table's angles.
    for row in Table::read("latlong_bias.csv").rows() {
        let theta = row.f64("theta");
        let below = |warp: fn(DVec2) -> DVec3, name: &str| {
            let s = seed(name);
            (0..20_000).map(move |i| f64::from(u8::from(warp(point2(s, 1, i)).z > theta.cos())))
        };
        // Rarely seen angles would need more samples than 1600/q.
        for (column, warp) in [
            ("cdf_theta_uniform", uniform_sphere as fn(DVec2) -> DVec3),
            ("cdf_theta_latlong", latitude_longitude),
        ] {
            let share = row.f64(column);
            if share.min(1.0 - share) > 1600.0 / 20_000.0 {
                mean_matches(&format!("{column} at {theta}"), share, below(warp, column));
            }
        }
    }
}

/// The set of the table's row: `n` strata along one axis, or `n × n` cells.
fn cells(row: Row) -> Cells {
    let n = row.f64("n") as u32;
    if row.text("kind") == "step_1d" { Cells::grid(n, 1) } else { Cells::grid(n, n) }
}

#[test]
fn jitter_has_the_tabulated_variance() {
    for row in Table::read("mc_jitter.csv").rows() {
        let (cells, mean) = (cells(row), row.f64("mean"));
        let n = cells.len();
        assert_eq!(f64::from(n), row.f64("N_samples"));
        let runs = (640_000 / u64::from(n)).min(40_000);
        let seed = seed("jitter");
        let (slope, x0) = (row.optional("slope"), row.f64("x0"));
        let edge = |p: DVec2| slope.map_or(p.x < x0, |slope| p.y < x0 + slope * p.x);
        let estimate = |set: PointSet| set.iter().filter(|&p| edge(p)).count() as f64 / f64::from(n);
        let jittered: Vec<f64> =
            (0..runs).map(|run| estimate(PointSet::Jittered { cells, seed: seed + run })).collect();
        let random = (0..runs).map(|run| estimate(PointSet::Random { n, seed: seed + run }));
        let squares = |estimate: f64| (estimate - mean).powi(2);
        let name = format!("{} {} at {}", row.text("kind"), row.text("n"), row.text("x0"));
        mean_matches(&name, mean, jittered.iter().copied());
        mean_matches(&name, row.f64("var_jittered"), jittered.iter().copied().map(squares));
        mean_matches(&name, row.f64("var_random"), random.map(squares));
    }
}

/// The radiance of the table's row, as a function of the direction.
fn radiance(row: Row) -> Box<dyn Fn(DVec3) -> f64> {
    let p = row.optional("p0").unwrap_or(0.0);
    let one_if = |yes: bool| f64::from(u8::from(yes));
    match row.text("radiance") {
        "constant_1" => Box::new(|_| 1.0),
        "cos^m" => Box::new(move |w| w.z.powf(p)),
        "cap_theta<t0" => Box::new(move |w| one_if(w.z > p.cos())),
        "ring_theta>t0" => Box::new(move |w| one_if(w.z < p.cos())),
        "1+a*sin*cosphi" => Box::new(move |w| 1.0 + p * w.x),
        other => panic!("radiance {other} in the table"),
    }
}

#[test]
fn estimators_of_irradiance_have_the_tabulated_mean_and_variance() {
    for row in Table::read("mc_variance.csv").rows() {
        let (integral, radiance) = (row.f64("integral"), radiance(row));
        let uniform = |u| {
            let w = uniform_hemisphere(u);
            radiance(w) * w.z / uniform_hemisphere_pdf(w)
        };
        let cosine = |u| {
            let w = cosine_hemisphere(u);
            radiance(w) * w.z / cosine_hemisphere_pdf(w)
        };
        let name = format!("{} {}", row.text("radiance"), row.text("p0"));
        let s = seed(&name);
        for (column, estimator) in
            [("var_uniform_hemi", &uniform as &dyn Fn(DVec2) -> f64), ("var_cosine_hemi", &cosine)]
        {
            let estimates = || (0..400_000).map(|i| estimator(point2(s, 0, i)));
            mean_matches(&format!("{name}, mean"), integral, estimates());
            let squares = estimates().map(|e| (e - integral).powi(2));
            if row.f64(column) > 0.0 {
                mean_matches(&format!("{name}, {column}"), row.f64(column), squares);
            } else {
                // Cosine times constant over its own density: π each time, but for three roundings.
                assert!(squares.into_iter().all(|s| s.sqrt() <= gamma(4) * integral), "{name}");
            }
        }
    }
}

#[test]
fn the_cosine_density_is_the_reciprocal_of_its_estimator() {
    // cos θ / pdf = π wherever the sample lies.
    for i in 0..1000 {
        let w = cosine_hemisphere(point2(1, 2, i));
        assert!((w.z / cosine_hemisphere_pdf(w) * FRAC_1_PI - 1.0).abs() <= gamma(5));
    }
}
