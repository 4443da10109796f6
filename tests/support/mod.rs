//! What the test crates share: statistics for judging samplers and estimators, nasty inputs, tables.
//!
//! A test crate takes it in by `#[path = "../support/mod.rs"] mod support;`.
//!
//! **Significance.** A statistical test rejects a correct program now and then. All of them together, `TESTS`
//! at most, shall do so once in a million suites, so each tests at Šidák's level. Seeds are fixed: a
//! test that passes keeps passing, and one that fails tells that the code changed, not the dice.

// Each crate uses its part.
#![allow(dead_code, unused_imports)]

pub mod chi2;
pub mod domain;
pub mod nasty;
pub mod t_test;
pub mod table;

pub use chi2::sample_matches_pdf;
pub use domain::{Cone, Disc, Domain, Square, Triangle};
pub use t_test::mean_matches;
pub use table::Table;

use lightbench::num::statistics::{normal_quantile, sidak};

/// More statistical decisions than the whole suite will ever make; generous, because the price is small:
/// ten times more move the critical z only from 6.2 to 6.6.
pub const TESTS: u32 = 2000;

/// Probability that a suite of correct code fails.
pub const SUITE_SIGNIFICANCE: f64 = 1e-6;

/// Significance of one test: a p-value below it fails, 5.0e-10.
pub fn significance() -> f64 {
    sidak(SUITE_SIGNIFICANCE, TESTS)
}

/// Standard deviations that one two-sided test allows, 6.2.
pub fn z() -> f64 {
    -normal_quantile(0.5 * significance())
}

/// The fixed seed of a test: its name, hashed (FNV-1a), so that no two tests share their numbers.
pub fn seed(name: &str) -> u64 {
    name.bytes().fold(0xCBF2_9CE4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01B3))
}
