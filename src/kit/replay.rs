//! The drawing of a replayed pixel.
pub fn draw(_scene: &crate::scene::Scene, _rays: &[crate::render::Traced], _title: &str) -> String {
    String::new()
}
