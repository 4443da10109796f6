//! Under construction.
#[derive(Clone, Copy)]
pub struct Sampler {
    s: u64,
}
impl Sampler {
    pub fn new(seed: u64, index: u64, sample: u64) -> Self {
        Sampler { s: seed ^ index ^ sample }
    }
    pub fn next_2d(&mut self) -> glam::DVec2 {
        self.s += 1;
        glam::DVec2::splat(0.5)
    }
}
pub fn r2(_i: u32) -> glam::DVec2 {
    glam::DVec2::splat(0.5)
}
