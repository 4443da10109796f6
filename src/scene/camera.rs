//! The camera: from a pixel to a ray, in the four spaces of [B §5].
//!
//! ```text
//! raster (pixels, y down) → NDC ([0,1]²) → screen ([−1,1]² times aspect and tan(fov/2), y up)
//!        → camera (z forward is −1) → world
//! ```

use crate::frame::{Frame, FrameError};
use crate::ray::Ray;
use glam::{DVec2, DVec3};

/// A full opening angle \[rad\], and the image side it spans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldOfView {
    /// From the bottom edge to the top edge: the library's and D's meaning.
    Vertical(f64),
    /// From the left edge to the right edge.
    Horizontal(f64),
}

impl FieldOfView {
    /// `tan(fov/2)`: half the image side at distance 1.
    fn slope(self) -> f64 {
        let (FieldOfView::Vertical(angle) | FieldOfView::Horizontal(angle)) = self;
        (0.5 * angle).tan()
    }

    /// See [`screen_from_ndc`].
    #[inline]
    fn screen(self, ndc: DVec2, aspect: f64, slope: f64) -> DVec2 {
        let centred = DVec2::new(2.0 * ndc.x - 1.0, 1.0 - 2.0 * ndc.y);
        match self {
            FieldOfView::Vertical(_) => centred * slope * DVec2::new(aspect, 1.0),
            FieldOfView::Horizontal(_) => centred * slope * DVec2::new(1.0, 1.0 / aspect),
        }
    }
}

/// Why no camera stands there.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    #[error("the field of view must lie strictly between 0° and 180°, found {0}°")]
    FieldOfView(f64),
    #[error(transparent)]
    Frame(#[from] FrameError),
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    position: DVec3,
    frame: Frame,
    field_of_view: FieldOfView,
    /// Its [`FieldOfView::slope`].
    slope: f64,
}

impl Camera {
    /// A camera at `position` that looks at `target`, with `up` towards the top of the picture.
    ///
    /// If `up` is parallel to the view, the picture's top is chosen by [`Frame::look_at`].
    pub fn new(
        position: DVec3,
        target: DVec3,
        up: DVec3,
        field_of_view: FieldOfView,
    ) -> Result<Self, CameraError> {
        let (FieldOfView::Vertical(angle) | FieldOfView::Horizontal(angle)) = field_of_view;
        if !(angle > 0.0 && angle < std::f64::consts::PI) {
            return Err(CameraError::FieldOfView(angle.to_degrees()));
        }
        let frame = Frame::look_at(position, target, up)?;
        Ok(Camera { position, frame, field_of_view, slope: field_of_view.slope() })
    }

    pub fn position(&self) -> DVec3 {
        self.position
    }

    /// Right, up and forward of the picture.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    pub fn field_of_view(&self) -> FieldOfView {
        self.field_of_view
    }

    /// The camera before a picture of `width × height` square pixels, with what its rays share computed once.
    pub fn view(&self, width: usize, height: usize) -> View {
        let size = DVec2::new(width as f64, height as f64);
        // The same as the chain of the four spaces: (2 ndc − 1) · aspect · slope = (2x − width) · slope/height.
        let half_pixel = match self.field_of_view {
            FieldOfView::Vertical(_) => self.slope / size.y,
            FieldOfView::Horizontal(_) => self.slope / size.x,
        };
        View {
            position: self.position,
            size,
            right: self.frame.right * half_pixel,
            up: self.frame.up * half_pixel,
            forward: self.frame.forward,
        }
    }

    /// The ray through a raster point of a picture; many of one picture share a [`Camera::view`].
    pub fn ray(&self, raster: DVec2, width: usize, height: usize) -> Ray {
        self.view(width, height).ray(raster)
    }

    /// A direction from camera space (x right, y up, −z forward) to the world.
    pub fn world_from_camera(&self, v: DVec3) -> DVec3 {
        self.frame.right * v.x + self.frame.up * v.y - self.frame.forward * v.z
    }
}

/// A camera before one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    position: DVec3,
    /// Of the picture [pixels].
    size: DVec2,
    /// Along half a pixel on the image plane at distance 1.
    right: DVec3,
    up: DVec3,
    forward: DVec3,
}

impl View {
    /// The ray through a raster point: (0,0) is the picture's upper left corner, pixel centres lie at halves.
    ///
    /// The ray through the picture's centre is exactly the forward direction.
    #[inline]
    pub fn ray(&self, raster: DVec2) -> Ray {
        let across = self.right * (2.0 * raster.x - self.size.x) + self.up * (self.size.y - 2.0 * raster.y);
        Ray::new(self.position, (across + self.forward).normalize())
    }
}

/// Normalised device coordinates `[0,1]²` of a raster point [B §5.2].
pub fn ndc_from_raster(raster: DVec2, size: DVec2) -> DVec2 {
    raster / size
}

/// Where on the image plane at distance 1 a point of NDC lies: x right, y up [B §5.2].
///
/// ```text
/// vertical:   x = (2 ndc.x − 1) · aspect · tan(fov/2),   y = (1 − 2 ndc.y) · tan(fov/2)
/// horizontal: x = (2 ndc.x − 1) · tan(fov/2),            y = (1 − 2 ndc.y) · tan(fov/2) / aspect
/// ```
pub fn screen_from_ndc(ndc: DVec2, aspect: f64, field_of_view: FieldOfView) -> DVec2 {
    field_of_view.screen(ndc, aspect, field_of_view.slope())
}

/// The image plane stands at distance 1 in front of the hole, along −z [B §5.2].
pub fn camera_from_screen(screen: DVec2) -> DVec3 {
    DVec3::new(screen.x, screen.y, -1.0)
}

/// Where the camera obscura's film, `depth` behind the hole, receives the light of a point of
/// camera space: both axes are inverted [C §1.4].
///
/// - Domain: points in front of the hole (z < 0), `depth > 0`; `None` for others: their light
///   does not pass the hole.
pub fn obscura_from_camera(p: DVec3, depth: f64) -> Option<DVec2> {
    (p.z < 0.0).then(|| DVec2::new(p.x, p.y) * (depth / p.z))
}
