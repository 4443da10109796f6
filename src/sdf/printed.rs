//! The march as [E §2.2] prints it: INTERSECCIONESDF.
//!
//! ```text
//! p = o, d = 0
//! repeat  p = p + d v,  d = min Fᵢ(p)  until |d| ≤ ε, or too many times
//! ```
//!
//! It is the heart of the matter in five lines, and leaves open what [`super::march`] settles: an ε that does not know the
//! scene's size is missed by rounding far from the origin, and met at once by a ray that leaves a surface; the number of
//! steps bounds the work and makes holes where rays graze; inside a solid `d` is negative and the ray walks
//! backwards; and a field steeper than 1 is leapt through.

use super::DistanceField;
use crate::ray::Ray;

/// The printed march and its two numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AsPrinted {
    /// ε: where the field is smaller there is said to be a surface \[m\].
    pub accuracy: f64,
    /// After so many steps there is said to be none.
    pub most_steps: u32,
    /// Share of `d` that is walked: 1 as printed; less is how programs live with steep fields.
    pub share: f64,
}

impl AsPrinted {
    pub fn new(accuracy: f64, most_steps: u32) -> Self {
        AsPrinted { accuracy, most_steps, share: 1.0 }
    }

    pub fn with_share(self, share: f64) -> Self {
        AsPrinted { share, ..self }
    }

    /// Distance along the ray \[m\] and index of the field that is met, and the steps it took; the ray's direction is a unit vector.
    pub fn intersect(&self, fields: &[&dyn DistanceField], ray: &Ray) -> (Option<(f64, usize)>, u32) {
        let (mut p, mut along, mut d) = (ray.origin, 0.0, 0.0);
        for step in 1..=self.most_steps {
            p += ray.direction * (self.share * d);
            along += self.share * d;
            let mut i = 0;
            d = f64::INFINITY;
            for (k, field) in fields.iter().enumerate() {
                let here = field.distance(p);
                if here < d {
                    (d, i) = (here, k);
                }
            }
            if d.abs() <= self.accuracy {
                return (Some((along, i)), step);
            }
        }
        (None, self.most_steps)
    }
}
