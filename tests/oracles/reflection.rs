//! Reflection models and Fresnel's equations against their tables.

use super::support::Table;
use super::truth::{Record, all_right, columns};
use lightbench::fresnel::{conductor, cos_transmitted, dielectric};
use lightbench::num::U;

/// Relative error 1e-9: 10⁷ roundings, for values down to e^−640, whose logarithm alone multiplies errors by 640. Below 1e-290
/// subnormals take over.
fn value(row: &Record, answer: &Record) -> Option<f64> {
    let (want, got) = (row.number("f")?, answer.number("f")?);
    if got == want {
        return Some(0.0);
    }
    Some((got - want).abs() / want.abs().max(1e-290) / 1e-9)
}

#[test]
fn values_agree_with_their_table() {
    all_right("brdf_values", include_str!("../data/brdf_values.csv"), value);
}

/// Exponents to 10⁶, roughness from 10⁻⁴, angles to 10⁻⁹ from grazing, from the normal, from the mirror.
#[test]
fn values_agree_with_their_nasty_table() {
    all_right("brdf_values", include_str!("../data/brdf_values_nasty.csv"), value);
}

#[test]
fn albedos_agree_with_their_table() {
    all_right("brdf_albedo", include_str!("../data/brdf_albedo.csv"), columns(&["albedo"], 1e-7));
}

/// The same script's quadrature is good to 2e-7 where a power ends in a root.
#[test]
fn albedos_agree_with_their_nasty_table() {
    all_right("brdf_albedo", include_str!("../data/brdf_albedo_nasty.csv"), columns(&["albedo"], 1e-6));
}

/// `abscond_R` is the error of R for a relative error 1 of the inputs; 16 roundings.
#[test]
fn clear_boundaries_agree_with_their_table() {
    for row in Table::read("fresnel.csv").rows() {
        let (i, t, cos) = (row.f64("eta_i"), row.f64("eta_t"), row.f64("cos_i"));
        let tir = row.text("tir") == "1";
        if row.optional("margin").is_some_and(|m| m < 1e-12) || (i == t && cos == 0.0) {
            continue; // decided by the last digits of the inputs
        }
        assert_eq!(cos_transmitted(i, t, cos).is_none(), tir, "{i} {t} {cos}");
        let found = dielectric(i, t, cos);
        let tolerance = 16.0 * U * row.f64("abscond_R").max(1.0);
        for (name, ours) in [("Rs", found.s), ("Rp", found.p), ("R", found.mean())] {
            assert!((ours - row.f64(name)).abs() <= tolerance, "{name} of {i} {t} {cos}: {ours}");
        }
    }
}

/// All terms are moduli: 64 roundings of 1, and of the value where indices are nearly 1.
#[test]
fn metals_agree_with_their_table() {
    for row in Table::read("fresnel_conductor.csv").rows() {
        let i = row.f64("eta_i");
        let found = conductor(row.f64("eta") / i, row.f64("k") / i, row.f64("cos_i"));
        for (name, ours) in [("Rs", found.s), ("Rp", found.p), ("R", found.mean())] {
            assert!((ours - row.f64(name)).abs() <= 64.0 * U, "{name}: {ours} {}", row.f64(name));
        }
    }
}
