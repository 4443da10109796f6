//! Boxes without thickness, and surfaces without a back.

use super::LEVELS;
use glam::DVec3;
use lightbench::bounds::Aabb;
use lightbench::ray::Ray;
use lightbench::sample::{Sampler, uniform_sphere, uniform_triangle};
use lightbench::shape::triangle::{Facing, PreparedRay, icosphere};
use lightbench_kit::figure::Table;
use lightbench_kit::lesson::{Lesson, Result};

/// Where the scene lies [m]: far away, a fixed pad of 10⁻⁶ is less than a step of an f64.
const PLACES: [f64; 3] = [0.0, 1.0e6, 1.0e12];
const PAD: f64 = 1.0e-6; // m, as many programs have it

type Slab = fn(&Aabb, &Ray) -> bool;

/// Writes the tables; returns how many hits our own slab test lost.
pub fn save(lesson: &Lesson) -> Result<u64> {
    let rays = lesson.pick([2_000, 20_000, 100_000, 400_000]);
    let tests: [(&str, Slab); 4] = [
        ("box as it is, enter < leave", naive_slab),
        ("padded by 10⁻⁶ m, enter < leave", |b, ray| naive_slab(&padded(b), ray)),
        ("box as it is, enter ≤ leave", unguarded_slab),
        ("box as it is, our slab test (default)", our_slab),
    ];
    let mut table = Table::new(&["test", "lost at 0 m", "lost at 10⁶ m", "lost at 10¹² m"])
        .title("A flat thing's box has no thickness: a careless slab test loses it")
        .subtitle(&format!(
            "{rays} rays that hit a level triangle, its corners and edges among them, at three distances from the world's origin"
        ));
    let mut lost_by_ours = 0;
    for (name, slab) in tests {
        let lost = PLACES.map(|place| lost(lesson.seed(), rays, place, slab));
        let cells = lost.map(|n| n.to_string());
        table = table.row(&[name, &cells[0], &cells[1], &cells[2]]);
        lost_by_ours = lost.iter().sum::<u64>();
    }
    lesson.save("bounds", table.marked())?;
    lesson.save("culling", culling(lesson.seed(), rays))?;
    Ok(lost_by_ours)
}

/// A level triangle, a ray that meets it, and its box.
fn lost(seed: u64, rays: u32, place: f64, slab: Slab) -> u64 {
    let [a, b, c] = [(0.0, 0.0), (1.0, 0.25), (0.25, 1.0)].map(|(x, z)| DVec3::new(x, 0.0, z) + place);
    let bounds = Aabb::of_points([a, b, c]);
    let is_lost = |k: u32| {
        let mut sampler = Sampler::new(seed, place.to_bits(), k);
        let (w, mut way) = (uniform_triangle(sampler.next_2d()), uniform_sphere(sampler.next_2d()));
        way.y += 0.01f64.copysign(way.y);
        let target = match k % 4 {
            0 => a,
            1 => a + (b - a) * w.x,
            _ => a * w.x + b * w.y + c * w.z,
        };
        let ray = Ray::new(target - way * 4.0, way);
        PreparedRay::new(&ray).meet([a, b, c]).is_some_and(|m| m.t > 0.0) && !slab(&bounds, &ray)
    };
    (0..rays).filter(|&k| is_lost(k)).count() as u64
}

fn our_slab(bounds: &Aabb, ray: &Ray) -> bool {
    bounds.slab(ray.origin, ray.direction.recip(), 0.0, f64::INFINITY).is_some()
}

/// Enter < leave, as one writes it first.
fn naive_slab(bounds: &Aabb, ray: &Ray) -> bool {
    let (enter, leave) = naive_stretch(bounds, ray);
    enter < leave
}

fn unguarded_slab(bounds: &Aabb, ray: &Ray) -> bool {
    let (enter, leave) = naive_stretch(bounds, ray);
    enter <= leave
}

fn naive_stretch(bounds: &Aabb, ray: &Ray) -> (f64, f64) {
    let (a, b) = ((bounds.min - ray.origin) / ray.direction, (bounds.max - ray.origin) / ray.direction);
    (0..3).fold((0.0, f64::INFINITY), |(enter, leave), axis| {
        let (near, far) = if a[axis] < b[axis] { (a[axis], b[axis]) } else { (b[axis], a[axis]) };
        (if near < enter { enter } else { near }, if far > leave { leave } else { far })
    })
}

fn padded(bounds: &Aabb) -> Aabb {
    Aabb::new(bounds.min - PAD, bounds.max + PAD)
}

/// Faces that a ray meets on a closed mesh, from outside and from inside, by which sides are admitted.
fn culling(seed: u64, rays: u32) -> Table {
    let mesh = icosphere(LEVELS);
    let rays = rays / 10;
    let mut rows = [[0u32; 2]; 3];
    for k in 0..rays {
        let mut sampler = Sampler::new(seed, 11, k);
        let (way, target) = (uniform_sphere(sampler.next_2d()), uniform_sphere(sampler.next_2d()) * 0.5);
        for (place, origin) in [target - way * 4.0, target].into_iter().enumerate() {
            let ray = PreparedRay::new(&Ray::new(origin, way));
            for m in mesh.iter().filter_map(|f| ray.meet(*f)).filter(|m| m.t > 0.0) {
                let is_front = m.facing == Facing::Front;
                let admitted = [true, is_front, !is_front];
                (0..3).for_each(|i| rows[i][place] += u32::from(admitted[i]));
            }
        }
    }
    let names = ["both sides (default)", "front: d·n < 0 (the code of A)", "front: d·n ≥ 0 (the text of A)"];
    let table = Table::new(&["faces admitted", "met per ray, from outside", "met per ray, from inside"])
        .title("Culling keeps the face that looks at the ray; A's text keeps the other")
        .subtitle(&format!("{rays} rays at a closed mesh of 320 triangles; A §5.4.1 and ill. 56 (testcull)"));
    names.iter().zip(rows).fold(table, |table, (name, counts)| {
        let cells = counts.map(|n| format!("{:.3}", f64::from(n) / f64::from(rays)));
        table.row(&[name, &cells[0], &cells[1]])
    })
}
