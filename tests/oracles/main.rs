//! Oracles: closed forms, brute force, chi-square, and tables of high precision.

#[path = "../support/mod.rs"]
mod support;

mod area_light;
mod colour;
mod film;
mod julia;
mod pinhole;
mod reflection;
mod sample;
mod sphere;
mod statistics;
mod surfaces;
mod tables;
mod truth;
