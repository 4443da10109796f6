//! Marching: how a ray finds where a field changes sign.
//!
//! With `r = |f(p)|/L` the ball of radius `r` around `p` is free of surface, so that a step of `r` passes over
//! nothing (Hart). Longer steps are taken on trust and looked at afterwards: if the balls at both ends touch, the
//! segment between lies in their union and is free too; if not, the step is taken back.
//!
//! ```text
//! plain         r
//! over-relaxed  ω r,  1 < ω < 2                                    Keinert et al. (2014) §3.1
//! enhanced      (1 − ω) r + ω 2r/(1 + s),  s = (r_before − r)/step      Bálint & Valasek (2018)
//! ```
//!
//! The last one expects a flat surface, of which the ray draws nearer at the slope `s`: then `2r/(1 + s)` is the step
//! after which the new ball just touches the old one.
//!
//! No step is shorter than the tolerance `τ`, so that the ray does not crawl where it grazes; and a hit is a change of sign,
//! not a small value. Together:
//!
//! - A ray that dives deeper than `τ L` into the solid (in the field's units) is never missed: where `f ≤ −τL` the field is
//!   negative for `τ` to either side, and a step that leaps over the surface is at most `τ` long.
//! - A hit is no guess: the field changes sign within [`Marched::within`] of it, however flat it is.
//! - A ray that leaves the surface outwards finds it only where it comes back: there is nothing to skip.
//!
//! Where a ray runs along a surface, the number of steps is bounded all the same: after every [`March::patience`] steps
//! the tolerance doubles, and the answer says which one held ([`Marched::tolerance`]).

use super::DistanceField;
use crate::num::{U, gamma};
use crate::ray::Ray;
use glam::DVec3;

/// How long a step is, given the radius of the free ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stride {
    /// The radius.
    Plain,
    /// `omega` radii, in (1, 2).
    OverRelaxed { omega: f64 },
    /// Towards the step that a flat surface would allow, by a share `omega` in (0, 1).
    Enhanced { omega: f64 },
}

impl Stride {
    /// The three, with the parameters that their authors use.
    pub const ALL: [Stride; 3] =
        [Stride::Plain, Stride::OverRelaxed { omega: 1.6 }, Stride::Enhanced { omega: 0.9 }];

    pub fn name(self) -> &'static str {
        match self {
            Stride::Plain => "plain",
            Stride::OverRelaxed { .. } => "over-relaxed",
            Stride::Enhanced { .. } => "enhanced",
        }
    }
}

/// How to march.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct March {
    pub stride: Stride,
    /// Shortest step at the ray's origin \[m\].
    pub tolerance: f64,
    /// Growth of the shortest step per length of the way: the width of a pixel at distance 1, or 0.
    pub spread: f64,
    /// Steps after which the shortest step doubles.
    pub patience: u32,
}

/// Tuned: of the camera rays of lesson 08 most end within 64 steps, and should not feel it; with 1024 a ray that runs along a plane at
/// 10⁻⁷ of the way takes 1024 · log₂ 10⁷, some 24 000 steps.
const PATIENCE: u32 = 128;

/// The share of a field's detail that a ray may dive unseen: 10⁻⁷ of what is there to see.
const UNSEEN: f64 = 1.0 / (1u64 << 23) as f64;

impl March {
    /// Marching to a tolerance far below the field's detail, by the stride that the counts choose.
    pub fn through(field: &(impl DistanceField + ?Sized)) -> Self {
        let size = field.detail().min(field.scale());
        March { stride: Stride::ALL[2], tolerance: size * UNSEEN, spread: 0.0, patience: PATIENCE }
    }

    pub fn with_stride(self, stride: Stride) -> Self {
        March { stride, ..self }
    }

    pub fn with_tolerance(self, tolerance: f64) -> Self {
        March { tolerance, ..self }
    }

    /// The shortest step grows by `spread` per length of the way, as a pixel does.
    pub fn with_spread(self, spread: f64) -> Self {
        March { spread, ..self }
    }

    /// The first change of sign between two distances `from ≤ to` \[m\] along a ray, and what it took.
    pub fn first<F: DistanceField + ?Sized>(&self, field: &F, ray: &Ray, from: f64, to: f64) -> Marched {
        let Some(mut walk) = Walk::new(field, *self, ray, from, to) else { return Marched::nothing(*self) };
        let found = walk.next();
        walk.marched(found)
    }

    /// The places where the march stands on its way to the first change of sign, that of the change last.
    pub fn trail<F: DistanceField + ?Sized>(&self, field: &F, ray: &Ray, from: f64, to: f64) -> Vec<Step> {
        let Some(mut walk) = Walk::new(field, *self, ray, from, to) else { return Vec::new() };
        let stand = |at: Stand| Step { distance: at.s, radius: at.r.abs() };
        let mut trail = vec![stand(walk.at)];
        while walk.at.s < walk.to {
            let before = walk.at;
            let changed = walk.step(before);
            trail.push(stand(walk.at));
            if changed || !(walk.at.s > before.s) {
                break;
            }
        }
        trail
    }
}

/// A place where a march has stood: distance along the ray, and radius of the free ball there \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    pub distance: f64,
    pub radius: f64,
}

/// What a march found, and what it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marched {
    /// Where the field changes sign: distance along the ray \[m\].
    pub distance: Option<f64>,
    /// The change of sign lies no farther than this from `distance`, along the ray \[m\].
    pub within: f64,
    /// Shortest step at the end \[m\]: what a ray may have dived unseen.
    pub tolerance: f64,
    /// Evaluations of the field on the way to the surface, steps taken back among them.
    pub steps: u32,
    /// Evaluations that pinned down the root.
    pub polish: u32,
}

impl Marched {
    fn nothing(march: March) -> Self {
        Marched { distance: None, within: 0.0, tolerance: march.tolerance, steps: 0, polish: 0 }
    }
}

/// A ray's line through a field, in units of length.
#[derive(Clone, Copy, Debug)]
struct Line<'a, F: ?Sized> {
    field: &'a F,
    origin: DVec3,
    direction: DVec3,
    per_lipschitz: f64,
}

impl<F: DistanceField + ?Sized> Line<'_, F> {
    fn at(&self, s: f64) -> DVec3 {
        self.origin + self.direction * s
    }
    /// The field at a distance along the ray, over its Lipschitz bound: the signed radius of the free ball.
    #[inline]
    fn radius(&self, s: f64) -> f64 {
        self.field.distance(self.at(s)) * self.per_lipschitz
    }
}

/// A march under way, from one change of sign to the next.
#[derive(Clone, Copy, Debug)]
pub struct Walk<'a, F: ?Sized> {
    line: Line<'a, F>,
    march: March,
    /// Lengths of the ray's direction per length.
    speed: f64,
    at: Stand,
    /// The step before, and the radius where it began, for the enhanced stride.
    before: Option<(f64, f64)>,
    /// Has an over-relaxed step been taken back? Then the rest of the way is plain, as Keinert et al. have it: where one step fails
    /// the ray is running at a surface, and the next would fail too.
    sobered: bool,
    to: f64,
    least: f64,
    /// What rounding hides of the radius, anywhere on the way.
    hidden: f64,
    steps: u32,
    polish: u32,
}

/// A place on the line: distance, and signed radius of the free ball there.
#[derive(Clone, Copy, Debug)]
struct Stand {
    s: f64,
    r: f64,
}

impl Stand {
    fn is_inside(self) -> bool {
        self.r <= 0.0
    }
}

/// A change of sign: where, and how well that is known \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    pub s: f64,
    pub within: f64,
}

impl<'a, F: DistanceField + ?Sized> Walk<'a, F> {
    /// A march along a ray between two distances \[m\]. `None` for a ray without direction, or numbers that are not finite.
    pub fn new(field: &'a F, march: March, ray: &Ray, from: f64, to: f64) -> Option<Self> {
        let largest = ray.direction.abs().max_element();
        let direction = crate::frame::unit(ray.direction)?;
        let speed = (ray.direction / largest).length() * largest;
        if !(ray.origin.is_finite() && from.is_finite() && to.is_finite() && from <= to) {
            return None;
        }
        let line = Line { field, origin: ray.origin, direction, per_lipschitz: 1.0 / field.lipschitz() };
        // Both grow away from the origin, at the ends of the way the most: `o + s d` rounds twice, `d` itself by 4 u.
        let along = |s: f64| gamma(8) * (ray.origin.abs().element_sum() + s.abs());
        let blur = |s: f64| field.rounding(line.at(s)) * line.per_lipschitz + along(s);
        let hidden = blur(from).max(blur(to));
        let r = line.radius(from);
        let (at, before) = (Stand { s: from, r }, None);
        let least = march.tolerance.max(2.0 * hidden);
        Some(Walk { line, march, speed, at, before, sobered: false, to, least, hidden, steps: 1, polish: 0 })
    }

    /// Lengths of the ray's direction per length: `t = s / speed`.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// How far the march has come \[m\].
    pub fn reached(&self) -> f64 {
        self.at.s
    }

    /// Is the ray in the solid where the march stands?
    pub fn is_inside(&self) -> bool {
        self.at.is_inside()
    }

    /// What rounding hides of the distance anywhere on the way \[m\].
    pub fn hidden(&self) -> f64 {
        self.hidden
    }

    fn marched(&self, found: Option<Change>) -> Marched {
        Marched {
            distance: found.map(|c| c.s),
            within: found.map_or(0.0, |c| c.within),
            tolerance: self.shortest(),
            steps: self.steps,
            polish: self.polish,
        }
    }

    /// The shortest step here.
    fn shortest(&self) -> f64 {
        let doubled = (self.steps / self.march.patience.max(1)).min(1000);
        let grown = self.least + self.march.spread * self.at.s.max(0.0);
        grown * f64::from(doubled).exp2()
    }

    /// The step that the stride wants, at least `safe`.
    fn wanted(&self, radius: f64, safe: f64) -> f64 {
        match self.march.stride {
            Stride::Plain => safe,
            Stride::OverRelaxed { omega } if !self.sobered => (omega * radius).max(safe),
            Stride::OverRelaxed { .. } => safe,
            Stride::Enhanced { omega } => {
                let Some((step, before)) = self.before else { return safe };
                // The slope of a 1-Lipschitz field lies in [−1, 1]; seen edge-on, no step is more than ten radii.
                let slope = ((before - radius) / step).clamp(-0.8, 1.0);
                (radius * (1.0 + omega * (1.0 - slope) / (1.0 + slope))).max(safe)
            }
        }
    }

    fn look(&mut self, s: f64) -> Stand {
        self.steps += 1;
        Stand { s, r: self.line.radius(s) }
    }

    /// One step. True if the sign changed in it.
    fn step(&mut self, from: Stand) -> bool {
        let radius = from.r.abs();
        let safe = radius.max(self.shortest());
        let wanted = self.wanted(radius, safe);
        // Where the number does not grow, the way is at its end.
        let mut there = self.look((from.s + wanted).min(self.to));
        let trusted = there.s - from.s <= safe || there.s - from.s <= radius + there.r.abs();
        self.before = Some((there.s - from.s, radius));
        if !trusted {
            there = self.look((from.s + safe).min(self.to));
            // The next step is plain: the surface is not what it seemed.
            (self.before, self.sobered) = (None, true);
        }
        self.at = there;
        there.is_inside() != from.is_inside()
    }

    /// The root of the radius in a bracket, to the last digits that rounding leaves.
    ///
    /// The false position, in its Illinois form, bisected whenever three steps have not halved the bracket. Once the radius is no
    /// more than rounding, the places that far to either side are asked: as a rule their signs differ, and the bracket is done.
    fn pin_down(&mut self, mut a: Stand, mut b: Stand) -> Change {
        let inside_at_a = a.is_inside();
        let (mut width, mut slow) = (b.s - a.s, 0);
        // Each weight is halved while the other end stands still.
        let (mut wa, mut wb) = (1.0, 1.0);
        for _ in 0..200 {
            let grain = 4.0 * U * a.s.abs().max(b.s.abs());
            if b.s - a.s <= grain {
                break;
            }
            slow += 1;
            let share = a.r.abs() * wa / (a.r.abs() * wa + b.r.abs() * wb);
            let share = if slow < 3 && share > 0.0 && share < 1.0 { share } else { 0.5 };
            // Beside an end the root may be nearer than the next number: half a grain on, the bracket still shrinks.
            let s = (a.s + (b.s - a.s) * share).clamp(a.s + 0.5 * grain, b.s - 0.5 * grain);
            let m = self.polished(s);
            if m.r.abs() <= self.hidden {
                let near = (2.0 * self.hidden).max(grain);
                let (l, h) = (self.polished((m.s - near).max(a.s)), self.polished((m.s + near).min(b.s)));
                if l.is_inside() == inside_at_a && h.is_inside() != inside_at_a {
                    let share = l.r.abs() / (l.r.abs() + h.r.abs()).max(f64::MIN_POSITIVE);
                    return Change { s: l.s + (h.s - l.s) * share, within: h.s - l.s };
                }
            }
            if m.is_inside() == inside_at_a {
                (a, wa, wb) = (m, 1.0, wb * 0.5);
            } else {
                (b, wb, wa) = (m, 1.0, wa * 0.5);
            }
            if b.s - a.s <= 0.5 * width {
                (width, slow) = (b.s - a.s, 0);
            }
        }
        Change { s: a.s + (b.s - a.s) * 0.5, within: b.s - a.s }
    }

    fn polished(&mut self, s: f64) -> Stand {
        self.polish += 1;
        Stand { s, r: self.line.radius(s) }
    }
}

/// The changes of sign, one after the other.
impl<F: DistanceField + ?Sized> Iterator for Walk<'_, F> {
    type Item = Change;

    fn next(&mut self) -> Option<Change> {
        while self.at.s < self.to {
            let from = self.at;
            if self.step(from) {
                let there = self.at;
                (self.before, self.sobered) = (None, false);
                return Some(self.pin_down(from, there));
            }
            if !(self.at.s > from.s) {
                return None; // NaN, or a way that rounding ends
            }
        }
        None
    }
}
