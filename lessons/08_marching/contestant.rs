//! Who marches, and what counts as wrong.

use super::{FAR, MOST_STEPS, WRONG};
use lightbench::measure::Method;
use lightbench::ray::Ray;
use lightbench::sdf::printed::AsPrinted;
use lightbench::sdf::{DistanceField, March, Stride};

/// Who marches.
#[derive(Clone, Copy)]
pub enum Contestant {
    Printed,
    Marching(Stride),
}

impl Contestant {
    pub const ALL: [Contestant; 4] = {
        let [plain, relaxed, enhanced] = Stride::ALL;
        [
            Contestant::Printed,
            Contestant::Marching(plain),
            Contestant::Marching(relaxed),
            Contestant::Marching(enhanced),
        ]
    };

    pub fn method(self) -> Method {
        match self {
            Contestant::Printed => Method::as_printed("as printed"),
            Contestant::Marching(s @ Stride::Plain) => Method::new(s.name()).styled(2),
            Contestant::Marching(s @ Stride::OverRelaxed { .. }) => Method::new(s.name()).styled(3),
            Contestant::Marching(s @ Stride::Enhanced { .. }) => Method::default_of(s.name()).styled(0),
        }
    }

    /// Distance to the surface, and evaluations of the field.
    pub fn ask(self, field: &impl DistanceField, ray: &Ray, accuracy: f64) -> (Option<f64>, u32) {
        match self {
            Contestant::Printed => {
                let (hit, steps) = AsPrinted::new(accuracy, MOST_STEPS).intersect(&[field], ray);
                (hit.map(|(t, _)| t).filter(|t| *t < FAR), steps)
            }
            Contestant::Marching(stride) => {
                let march = March::through(field).with_stride(stride).with_tolerance(accuracy);
                let done = march.first(field, ray, 0.0, FAR);
                (done.distance, done.steps + done.polish)
            }
        }
    }
}

/// Is an answer another pixel than the truth?
pub fn is_wrong(found: Option<f64>, truth: Option<f64>) -> bool {
    match (found, truth) {
        (Some(t), Some(truth)) => !((t - truth).abs() <= WRONG * truth),
        (found, truth) => found.is_some() != truth.is_some(),
    }
}
