//! Lesson 09. How far may a ray leap towards a fractal before it leaps too far?
//!
//! Builds on:  02 (a ray meets a sphere), 05 (certified signs; missed and false hits), 08 (rays that march).
//! New here:   quaternion Julia sets; the distance estimate of Hart, Sandin and Kauffman; bounds instead of estimates.
//! Notation:   q a quaternion, c the one that is added, N steps of q² + c, B bailout; q' the derivative; w the slice.
//! Predict:    a ray starts 10 units from the set of c = 0, the unit ball. How far does the printed estimate send it?
//! Figure:     09_julia_set.png, 09_julia_speed_accuracy_time.svg, 09_julia_overshoot.svg, 09_julia_overflow_f32.svg

use glam::DVec4;
use lightbench::measure::{Point, Series, log_spaced};
use lightbench::num::double_double::DoubleDouble;
use lightbench::ray::Ray;
use lightbench::sdf::julia::JuliaMethod;
use lightbench::sdf::julia::orbit::{estimate, safe_step};
use lightbench_kit::figure::short;
use lightbench_kit::lesson::{Lesson, Result};

#[path = "09_julia/charts.rs"]
mod charts;
#[path = "09_julia/contest.rs"]
mod contest;
#[path = "09_julia/diagrams.rs"]
mod diagrams;
#[path = "09_julia/maps.rs"]
mod maps;
#[path = "09_julia/stage.rs"]
mod stage;
use charts::Way;
use contest::{FROM, hit, missed, moved, rays, set};

/// The set that is viewed, and the bailout of all sets.
const VIEWED: DVec4 = DVec4::new(-0.2, 0.6, 0.2, 0.2);
const BAILOUT: f64 = 2.0;
/// Steps that stand for endless ones: beyond, the surface moves by less than 10⁻⁷.
const TRUTH: u32 = 30;
const STEPS: [f64; 7] = [2.0, 3.0, 4.0, 6.0, 8.0, 11.0, 14.0];
/// Steps where the tolerance is swept, and tolerances [m].
const PLAIN: u32 = 8;
const TOLERANCE: std::ops::Range<f64> = 1.0e-8..1.0e-1;
/// Places a march may look at.
const MOST: u32 = 2000;

fn main() -> Result {
    let lesson = Lesson::without_essay(9)?;
    let rays = rays(lesson.seed(), lesson.pick([32, 400, 1500, 6000]));

    // 1. The truth: the certified first hit of the set after many steps, and of each set with fewer.
    let endless = set(TRUTH, JuliaMethod::Certified)?;
    let truth: Vec<_> = rays.iter().map(|ray| hit(&endless, ray)).collect();

    // 2. The contestants: steps by an estimate, as printed and with care, and steps by a bound.
    let far = Way::ALL.map(|way| (way.method(), Series::over(&STEPS, |n| moved(&rays, &truth, way, n))));
    let tolerances = log_spaced(TOLERANCE.end, TOLERANCE.start, 8);
    let plain: Vec<_> = {
        let julia = set(PLAIN, JuliaMethod::Certified)?;
        rays.iter().map(|ray| hit(&julia, ray)).collect()
    };
    let near = Way::MARCHES
        .map(|way| (way.method(), Series::over(&tolerances, |x| missed(&rays, &plain, way.within(x), x))));

    // 3. The figures.
    stage::set(&lesson)?;
    stage::sets(&lesson)?;
    stage::steps(&lesson)?;
    stage::slices(&lesson)?;
    lesson.save("approach", diagrams::approach()?)?;
    lesson.save("thrown_past", diagrams::thrown_past()?)?;
    lesson.save("speed_accuracy", charts::speed(&far, rays.len()))?;
    lesson.save("tolerance", charts::tolerance(&near, rays.len()))?;
    lesson.save("work", charts::work(&near))?;
    lesson.save("step", charts::step())?;
    let overshoot = maps::overshoot(&lesson)?;
    lesson.save("overshoot", overshoot.estimate)?;
    lesson.save("overshoot_bound", overshoot.bound)?;
    lesson.save("overflow_f32", maps::overflow::<f32>(&lesson, "f32"))?;
    lesson.save("overflow_f64", maps::overflow::<f64>(&lesson, "f64"))?;

    // 4. What the figures show, checked.
    claims(&lesson, &rays, overshoot.shares);
    lesson.answer(&answer(&far, &near))
}

fn claims(lesson: &Lesson, rays: &[Ray], shares: [f64; 2]) {
    let exact = |r: f64| r - 1.0;
    let radii = log_spaced(1.0 + 1e-6, 1e6, 400);
    let bound = |r: f64| safe_step::<DoubleDouble>(DVec4::X * r, DVec4::ZERO);
    let over = |step: &dyn Fn(f64) -> f64| radii.iter().filter(|r| step(**r) > exact(**r)).count();
    let (printed, bounded) = (over(&|r| estimate(r, 1.0)), over(&bound));
    lesson.claim(
        &format!("At {printed} of 400 distances from the unit ball (c = 0) Hart's estimate is too long, the bound at {bounded}."),
        printed > 0 && bounded == 0,
    );
    lesson.claim(
        &format!(
            "On the map the estimate passes the first hit in {:.0} % of the cells, the bound in none.",
            100.0 * shares[0]
        ),
        shares[0] > 0.0 && shares[1] == 0.0,
    );
    let middle = |r: &Ray| Ray::new(r.origin * (100.0 / FROM), -r.origin / FROM);
    let aimed: Vec<Ray> = rays.iter().map(middle).collect();
    let count = |way: Way| {
        set(PLAIN, way.julia_method()).map_or(0, |j| aimed.iter().filter(|r| hit(&j, r).is_some()).count())
    };
    let (kept, all) = (count(Way::AsPrinted(1e-4)), count(Way::Certified));
    lesson.claim(
        &format!(
            "From 100 units away step and bisect as printed keeps {kept} of {all} hits through the middle."
        ),
        kept < all && all == aimed.len(),
    );
}

fn answer(far: &charts::Contest<4>, near: &charts::Contest<4>) -> String {
    let at = |k: usize, i: usize| &far[k].1.points[i];
    let ns = |p: &Point| p.time.map_or(f64::NAN, |t| t.mid * 1e9);
    let off = |p: &Point| p.error.map_or(f64::NAN, |e| e.mid);
    let failed = near[0].1.failures();
    format!(
        "as far as a bound allows, which the estimate is not: as printed a march loses or invents {} of {} hits. The certified steps \
         take {:.0} ns a ray after 8 steps, {} from the endless set; the estimate within 10⁻⁴ takes {:.0} ns and ends {} from it.",
        failed.total(),
        failed.of,
        ns(at(0, 4)),
        short(off(at(0, 4))),
        ns(at(2, 4)),
        short(off(at(2, 4)))
    )
}
