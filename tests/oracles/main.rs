//! Oracles: closed forms, brute force, high-precision tables.

mod film;
mod tables;
mod truth;
