//! What answers are held against, what a formula costs, and what the printed listings lose.

use super::{RADIUS, Ray, WIDEST, aimed};
use lightbench::measure::Tally;
use lightbench::num::counted::{Counted, count};
use lightbench::num::real::{Real, Triple};
use lightbench::shape::sphere::as_printed;
use lightbench::shape::sphere::method::{algebraic, algebraic_first, geometric, in_front, robust};
use lightbench::shape::sphere::reference::Meeting;

/// The ray as a machine of type `R` stores it: this, not the ray that was meant, is what a formula answers for.
pub fn rounded<R: Real>((f, d): &Ray<f64>) -> Ray<R> {
    (f.map(R::from_f64), d.map(R::from_f64))
}

/// An answer against the truth about one ray: a miss, a false hit, or the error of t₀ [radii].
pub fn judge<R: Real>(tally: &mut Tally, (f, d): Ray<R>, found: Option<R>) {
    let truth = Meeting::of(f.map(R::to_f64), d.map(R::to_f64), RADIUS);
    let found = found.map(R::to_f64);
    match found.and_then(|t| truth.behind_first(t)) {
        Some(behind) => tally.error(behind / RADIUS),
        None => tally.answer(found, truth.half_chord),
    }
}

/// Counted work of a ray's first hit.
pub struct Cost {
    pub name: &'static str,
    /// Sums, products, quotients and roots.
    pub operations: f64,
    pub roots: f64,
}

/// The work of each formula, on rays every second of which misses.
pub struct Costs {
    pub quadratic: Cost,
    pub quadratic_with_exit: Cost,
    pub closest: Cost,
    pub robust: Cost,
}

/// Counts the work.
pub fn savings(seed: u64) -> Costs {
    let rays = aimed(seed, 1024, 100.0, std::f64::consts::SQRT_2);
    let cost = |name, solve: fn(Triple<Counted>, Triple<Counted>, Counted) -> Option<Counted>| {
        let (done, _) =
            count(|| rays.iter().map(rounded).filter_map(|(f, d)| solve(f, d, Counted(RADIUS))).count());
        let n = rays.len() as f64;
        Cost { name, operations: done.total() as f64 / n, roots: done.roots as f64 / n }
    };
    Costs {
        quadratic: cost("quadratic formula", |f, d, r| in_front(algebraic(f, d, r))),
        quadratic_with_exit: cost("quadratic formula, second root only if needed", algebraic_first),
        closest: cost("closest approach", |f, d, r| in_front(geometric(f, d, r))),
        robust: cost("robust (default)", |f, d, r| in_front(robust(f, d, r))),
    }
}

/// Rays lost, of `rays` that all hit, by a listing: plain, small sphere, origin inside, tangent.
pub struct Loss {
    pub name: &'static str,
    pub lost: [usize; 4],
    pub rays: u32,
}

/// The documents' listings exactly as printed, and the default.
pub fn losses(seed: u64, rays: u32) -> Vec<Loss> {
    let plain = aimed(seed, rays, 10.0, WIDEST);
    let away = |(f, d): Ray<f64>| (f.map(|x| -x), d);
    let inside: Vec<Ray<f64>> = aimed(seed, rays, 0.5, 0.5).into_iter().map(away).collect();
    let tangent: Vec<Ray<f64>> = (1..=rays).map(|k| ([0.0, 1.0, -f64::from(k)], [0.0, 0.0, 1.0])).collect();
    type First = fn(Triple<f64>, Triple<f64>, f64) -> Option<f64>;
    let ways: [(&str, First); 4] = [
        ("Sancho, ill. 57: discriminant below 10⁻⁶ is a miss", as_printed::with_fixed_epsilon),
        ("Anguera, §6.2.1: centre behind the origin is a miss", |f, d, r| {
            in_front(as_printed::with_centre_in_front(f, d, r))
        }),
        ("Ramos, §1.6.1: discriminant 0 is a miss", as_printed::without_tangent),
        ("robust (default)", |f, d, r| in_front(robust(f, d, r))),
    ];
    let lost = |solve: First, rays: &[Ray<f64>], scale: f64| {
        rays.iter().filter(|(f, d)| solve(f.map(|x| x * scale), *d, RADIUS * scale).is_none()).count()
    };
    let all = |s: First| {
        [lost(s, &plain, 1.0), lost(s, &plain, 1.0e-4), lost(s, &inside, 1.0), lost(s, &tangent, 1.0)]
    };
    ways.into_iter().map(|(name, solve)| Loss { name, lost: all(solve), rays }).collect()
}
