//! The kit round the mathematics: figures and pages, flags and progress, files of pictures and scenes, probes.
//!
//! `lightbench` holds the formulas; this crate holds what the lessons and the command need beside them. It is
//! compiled without optimisation in development, because hardly any of it runs in a loop.

pub mod compare;
pub mod essay;
pub mod figure;
pub mod file;
pub mod flags;
pub mod lesson;
pub mod page;
pub mod probe;
pub mod progress;
pub mod replay;
pub mod scene_file;
pub mod stage;
pub mod syllabus;

// So that a module of the mathematics is `crate::shape` here as it is there.
use lightbench::{
    bounds, bsdf, color, csg, film, frame, fresnel, light, measure, mesh, num, ray, render, sample, scene,
    sdf, shape,
};
