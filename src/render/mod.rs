//! The tile loop: threads, progress, interruption. And one pixel again, slowly, with everything it did.
//!
//! Pixels are independent functions of (scene, seed, pixel), and each is written by one thread only: the
//! picture is the same byte for byte whatever the number of threads and their order.

mod replay;
mod shade;

pub use replay::{Recorder, Traced};
pub use shade::shade;

use crate::color::Rgb;
use crate::film::Image;
use crate::integrator::{Integrator, Local};
use crate::ray::{Ray, Silent, Tally, Trace};
use crate::sample::Sampler;
use crate::scene::{Scene, View};
use arrayvec::ArrayVec;
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
}

/// How to make it.
#[derive(Clone, Copy)]
pub struct Control<'a> {
    /// Number of threads; 0 for as many as there are cores.
    pub threads: usize,
    /// Set to stop at the next pixel.
    pub stop: &'a AtomicBool,
    /// Called now and then, from any thread, with the share of the picture that is done, in `[0,1]`.
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

/// [`render`] by local illumination, compiled in this crate: one that is compiled without optimisation calls it at full speed.
pub fn render_local(scene: &Scene, local: &Local, picture: Picture) -> Rendered {
    render(scene, local, picture)
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
    let done = AtomicU64::new(0);
    let job = Job::new(scene, integrator, picture);
    let mut image = Image::new(picture.width, picture.height);
    let tiles = tiles_of(&mut image);
    let count = tiles.len() as f64;
    let work = |tile: Tile| {
        let mut tally = Tally::default();
        let mut scratch = integrator.scratch(scene);
        let (x, y) = tile.corner;
        for (y, row) in (y..).zip(tile.rows) {
            if control.stop.load(Ordering::Relaxed) {
                return None;
            }
            job.row((x, y), row, &mut scratch, &mut tally);
        }
        let done = 1 + done.fetch_add(1, Ordering::Relaxed);
        (control.progress)(done as f64 / count);
        Some(tally)
    };
    let tallies = tiles.into_par_iter().with_max_len(1).map(work);
    let tally =
        tallies.try_reduce(Tally::default, |a, b| Some(a.plus(&b))).ok_or(RenderError::Interrupted)?;
    Ok(Rendered { image, tally })
}

/// What all pixels of a picture share.
struct Job<'a, I> {
    scene: &'a Scene,
    integrator: &'a I,
    picture: Picture,
    view: View,
    /// [`Picture::offset`] of every sample.
    offsets: Vec<DVec2>,
}

impl<'a, I: Integrator> Job<'a, I> {
    fn new(scene: &'a Scene, integrator: &'a I, picture: Picture) -> Self {
        let offsets = (0..picture.samples).map(|s| picture.offset(s)).collect();
        Job { scene, integrator, picture, view: scene.camera.view(picture.width, picture.height), offsets }
    }

    /// Adds up the radiance of a tile's row from `(x, y)` on: each pixel the mean over its samples, in their order.
    ///
    /// The rays of a row are made together, so that the processor overlaps their roots and quotients.
    fn row<T: Trace>(
        &self,
        (x, y): (usize, usize),
        row: &mut [Rgb],
        scratch: &mut I::Scratch,
        trace: &mut T,
    ) {
        for (s, &offset) in (0..).zip(&self.offsets) {
            let raster = |x: usize| DVec2::new(x as f64, y as f64) + offset;
            let rays: ArrayVec<Ray, TILE> = (x..x + row.len()).map(|x| self.view.ray(raster(x))).collect();
            for ((x, sum), ray) in (x..).zip(&mut *row).zip(&rays) {
                let index = (y * self.picture.width + x) as u64;
                let mut sampler = Sampler::new(self.picture.seed, index, s);
                *sum += self.integrator.radiance(self.scene, ray, &mut sampler, scratch, trace);
            }
        }
        for sum in row {
            *sum /= f64::from(self.picture.samples);
        }
    }

    /// One pixel.
    fn pixel<T: Trace>(&self, at: (usize, usize), trace: &mut T) -> Rgb {
        let mut value = [Rgb::ZERO];
        self.row(at, &mut value, &mut self.integrator.scratch(self.scene), trace);
        value[0]
    }
}

/// Renders one pixel again and returns its value with every ray, hit and weight on the way.
pub fn replay<I: Integrator>(
    scene: &Scene,
    integrator: &I,
    picture: Picture,
    at: (usize, usize),
) -> (Rgb, Vec<Traced>) {
    let (job, mut recorder) = (Job::new(scene, integrator, picture), Recorder::default());
    let value = job.pixel(at, &mut recorder);
    let bits = |value: Rgb| value.to_array().map(f64::to_bits); // NaN is the same as NaN here
    debug_assert_eq!(bits(value), bits(job.pixel(at, &mut Silent)));
    (value, recorder.into_rays())
}

/// A square of the picture: its corner, and its rows in the image.
struct Tile<'a> {
    corner: (usize, usize),
    rows: ArrayVec<&'a mut [Rgb], TILE>,
}

/// The picture in tiles, row by row.
fn tiles_of(image: &mut Image) -> Vec<Tile<'_>> {
    let width = image.width().max(1); // without pixels there are no tiles
    let mut tiles: Vec<Tile> = Vec::new();
    for (i, band) in image.pixels_mut().chunks_mut(width * TILE).enumerate() {
        let first = tiles.len();
        let corners = (0..width).step_by(TILE).map(|x| (x, i * TILE));
        tiles.extend(corners.map(|corner| Tile { corner, rows: ArrayVec::new() }));
        for row in band.chunks_mut(width) {
            for (tile, part) in tiles[first..].iter_mut().zip(row.chunks_mut(TILE)) {
                tile.rows.push(part);
            }
        }
    }
    tiles
}
