use super::Emitter;
use glam::{DVec2, DVec3};
pub struct Seen(Emitter);
impl Emitter {
    pub fn seen_from(&self, _p: DVec3) -> Seen {
        Seen(*self)
    }
}
impl Seen {
    pub fn solid_angle(&self) -> f64 {
        0.0
    }
    pub fn point(&self, u: DVec2) -> DVec3 {
        self.0.point(u)
    }
}
