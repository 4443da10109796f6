//! The tile loop: threads, progress, interruption. And one pixel again, slowly, with everything it did.
//!
//! Pixels are independent functions of (scene, seed, pixel), and each is written by one thread only: the
//! picture is the same byte for byte whatever the number of threads and their order.

mod replay;

pub use replay::{Recorder, Traced};

use crate::color::Rgb;
use crate::film::Image;
use crate::integrator::Integrator;
use crate::ray::{Silent, Tally, Trace};
use crate::sample::Sampler;
use crate::scene::Scene;
use glam::DVec2;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Pixels along a tile's side: large enough to keep a thread busy, small enough to share a picture fairly.
const TILE: usize = 16; // tuned: 8 costs 2 % in overhead, 64 leaves threads idle at the end of small pictures

/// What picture to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picture {
    pub width: usize,
    pub height: usize,
    /// Camera rays a pixel.
    pub samples: u32,
    pub seed: u64,
}

impl Picture {
    fn tiles(&self) -> usize {
        self.width.div_ceil(TILE) * self.height.div_ceil(TILE)
    }

    /// Where in the pixel sample `s` lies: the cell centres of a square grid when the number of samples is a
    /// square, as for D's 1, 4 and 16 [D §3.3.6], else a low-discrepancy set.
    pub fn offset(&self, s: u32) -> DVec2 {
        let side = self.samples.isqrt();
        if side * side == self.samples {
            DVec2::new(f64::from(s % side) + 0.5, f64::from(s / side) + 0.5) / f64::from(side)
        } else {
            crate::sample::r2(0, s)
        }
    }

    /// [`Picture::offset`] of every sample.
    fn offsets(&self) -> Vec<DVec2> {
        (0..self.samples).map(|s| self.offset(s)).collect()
    }
}

/// How to make it.
#[derive(Clone, Copy)]
pub struct Control<'a> {
    /// Number of threads; 0 for as many as there are cores.
    pub threads: usize,
    /// Set to stop at the next pixel.
    pub stop: &'a AtomicBool,
    /// Called now and then, from any thread, with the share of the picture that is done, in [0,1].
    pub progress: &'a (dyn Fn(f64) + Sync),
}

/// A picture and what it took.
#[derive(Clone, Debug)]
pub struct Rendered {
    pub image: Image,
    pub tally: Tally,
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    #[error("interrupted: no picture was written")]
    Interrupted,
    #[error("threads could not be started: {0}")]
    Threads(String),
}

/// Renders a picture with as many threads as there are cores, without progress or interruption.
pub fn render<I: Integrator>(scene: &Scene, integrator: &I, picture: Picture) -> Rendered {
    let control = Control { threads: 0, stop: &AtomicBool::new(false), progress: &|_| {} };
    match render_with(scene, integrator, picture, control) {
        Ok(rendered) => rendered,
        Err(_) => unreachable!("the global thread pool needs no starting, and nobody interrupts"),
    }
}

/// Renders a picture under control.
///
/// - Errors: interrupted, or the operating system refuses threads.
pub fn render_with<I: Integrator>(
    scene: &Scene,
    integrator: &I,
    picture: Picture,
    control: Control,
) -> Result<Rendered, RenderError> {
    if control.threads == 0 {
        return render_tiles(scene, integrator, picture, control);
    }
    // A thread without a tile would only be started and stopped.
    let threads = control.threads.min(picture.tiles().max(1));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|e| RenderError::Threads(e.to_string()))?;
    pool.install(|| render_tiles(scene, integrator, picture, control))
}

fn render_tiles<I: Integrator>(
    scene: &Scene,
    integrator: &I,
    picture: Picture,
    control: Control,
) -> Result<Rendered, RenderError> {
    let Picture { width, height, .. } = picture;
    let columns = width.div_ceil(TILE);
    let tiles = picture.tiles();
    let done = AtomicU64::new(0);
    let offsets = picture.offsets();
    let work = |tile: usize| {
        let (x0, y0) = (tile % columns * TILE, tile / columns * TILE);
        let mut tally = Tally::default();
        let mut scratch = integrator.scratch(scene);
        let mut pixels = Vec::with_capacity(TILE * TILE);
        for y in y0..(y0 + TILE).min(height) {
            for x in x0..(x0 + TILE).min(width) {
                if control.stop.load(Ordering::Relaxed) {
                    return None;
                }
                pixels.push(pixel(scene, integrator, (picture, &offsets), (x, y), &mut scratch, &mut tally));
            }
        }
        let done = 1 + done.fetch_add(1, Ordering::Relaxed);
        (control.progress)(done as f64 / tiles as f64);
        Some((pixels, tally))
    };
    let finished: Option<Vec<_>> = (0..tiles).into_par_iter().with_max_len(1).map(work).collect();
    let finished = finished.ok_or(RenderError::Interrupted)?;
    let mut image = Image::new(width, height);
    let mut tally = Tally::default();
    for (tile, (pixels, tile_tally)) in finished.iter().enumerate() {
        tally.add(tile_tally);
        let (x0, y0) = (tile % columns * TILE, tile / columns * TILE);
        let across = TILE.min(width - x0);
        for (i, value) in pixels.iter().enumerate() {
            image.set(x0 + i % across, y0 + i / across, *value);
        }
    }
    Ok(Rendered { image, tally })
}

/// Radiance of one pixel: the mean over its samples, added in their order; `offsets` are [`Picture::offsets`].
fn pixel<I: Integrator, T: Trace>(
    scene: &Scene,
    integrator: &I,
    (picture, offsets): (Picture, &[DVec2]),
    (x, y): (usize, usize),
    scratch: &mut I::Scratch,
    trace: &mut T,
) -> Rgb {
    let mut sum = Rgb::ZERO;
    for (s, &offset) in (0..).zip(offsets) {
        let raster = DVec2::new(x as f64, y as f64) + offset;
        let ray = scene.camera.ray(raster, picture.width, picture.height);
        let index = (y * picture.width + x) as u64;
        let mut sampler = Sampler::new(picture.seed, index, s);
        sum += integrator.radiance(scene, &ray, &mut sampler, scratch, trace);
    }
    sum / f64::from(picture.samples)
}

/// Renders one pixel again and returns its value with every ray, hit and weight on the way.
pub fn replay<I: Integrator>(
    scene: &Scene,
    integrator: &I,
    picture: Picture,
    at: (usize, usize),
) -> (Rgb, Vec<Traced>) {
    let offsets = picture.offsets();
    let mut recorder = Recorder::default();
    let value =
        pixel(scene, integrator, (picture, &offsets), at, &mut integrator.scratch(scene), &mut recorder);
    debug_assert_eq!(
        value,
        pixel(scene, integrator, (picture, &offsets), at, &mut integrator.scratch(scene), &mut Silent)
    );
    (value, recorder.into_rays())
}
