//! The claim that 95 % of the time goes into intersections [C §1.6].

use glam::{DVec2, DVec3, dvec3};
use lightbench::color::Rgb;
use lightbench::integrator::{Integrator, Local};
use lightbench::light::{Light, PointLight};
use lightbench::measure::timed;
use lightbench::mesh::{Mesh, tessellate::bumpy_knot};
use lightbench::ray::{Ray, RayKind, Silent, Trace};
use lightbench::sample::{Sampler, uniform_sphere};
use lightbench::scene::{Camera, FieldOfView, Material, Object, Scene};
use lightbench::shape::plane::Plane;
use lightbench::shape::sphere::Sphere;
use lightbench_kit::figure::{Figure, Table, grouped};

/// Every ray of a picture.
#[derive(Default)]
struct Rays(Vec<(RayKind, Ray, f64)>);

impl Trace for Rays {
    fn enter(&mut self, kind: RayKind, ray: &Ray, t_max: f64, _: Rgb) {
        self.0.push((kind, *ray, t_max));
    }
}

/// Seconds a pixel.
struct Shares {
    name: String,
    whole: f64,
    search: f64,
    /// The search without a structure.
    scan: f64,
}

fn stage() -> Scene {
    let (eye, field) = (dvec3(0.0, 2.0, 9.0), FieldOfView::Vertical(0.75));
    let mut scene =
        Scene::new(Camera::new(eye, DVec3::ZERO, DVec3::Y, field).expect("a camera in its place"));
    scene.materials.push(Material::default());
    let floor = Plane::new(dvec3(0.0, -3.0, 0.0), DVec3::Y).expect("a floor");
    scene.objects.push(Object::new("floor", Box::new(floor), 0));
    let lamp = PointLight::of_color(dvec3(6.0, 9.0, 8.0), DVec3::ONE);
    scene.lights.push(Light::Point(lamp));
    scene
}

fn spheres(count: u32) -> Scene {
    let mut scene = stage();
    for k in 0..count {
        let mut s = Sampler::new(12, 50, k);
        let center = uniform_sphere(s.next_2d()) * (2.6 * s.next_1d().cbrt());
        let sphere = Sphere::new(center, 2.0 / f64::from(count + 1).sqrt()).expect("a sphere");
        scene.objects.push(Object::new("sphere", Box::new(sphere), 0));
    }
    scene
}

fn knot(columns: u32, rows: u32) -> Option<Scene> {
    let mut scene = stage();
    scene.objects.push(Object::new("knot", Box::new(Mesh::new(&bumpy_knot(columns, rows)).ok()?), 0));
    Some(scene)
}

fn shares(name: &str, scene: &Scene, side: usize) -> Shares {
    let (integrator, mut rays) = (Local::default(), Rays::default());
    let mut scratch = integrator.scratch(scene);
    let pixels = side * side;
    let ray = |k: usize| {
        let at = DVec2::new((k % side) as f64 + 0.5, (k / side) as f64 + 0.5);
        scene.camera.ray(at, side, side)
    };
    let mut sampler = Sampler::new(1, 0, 0);
    for k in 0..pixels {
        integrator.radiance(scene, &ray(k), &mut sampler, &mut scratch, &mut rays);
    }
    let mut whole = || {
        let picture =
            (0..pixels).map(|k| integrator.radiance(scene, &ray(k), &mut sampler, &mut scratch, &mut Silent));
        picture.sum::<Rgb>().element_sum() as usize
    };
    let mut search = || {
        let met = |(kind, ray, t_max): &&(RayKind, Ray, f64)| match kind {
            RayKind::Shadow => scene.blocker(ray, *t_max, &mut Silent).is_some(),
            _ => scene.first_met(ray, &mut Silent).is_some(),
        };
        rays.0.iter().filter(met).count()
    };
    // As if the scene had no structure: every object by every ray, shadow rays until the first that blocks.
    let mut scan = || {
        let met = |(kind, ray, t_max): &&(RayKind, Ray, f64)| match kind {
            RayKind::Shadow => scene.objects.iter().any(|o| o.shape().blocks(ray, *t_max)),
            _ => {
                let mut limit = *t_max;
                for object in scene.objects.iter() {
                    limit = object.shape().nearest(ray, 0.0, limit).map_or(limit, |c| c.t);
                }
                limit < *t_max
            }
        };
        rays.0.iter().filter(met).count()
    };
    let [whole, search, scan] =
        quickest([&mut whole, &mut search, &mut scan]).map(|seconds| seconds / pixels as f64);
    // Few objects are a list anyway.
    let scan = if scene.objects.hierarchy().is_some() { scan } else { search };
    Shares { name: name.to_string(), whole, search, scan }
}

/// Seconds of the quickest of seven runs each, in turn: what else the machine does only adds.
fn quickest(works: [&mut dyn FnMut() -> usize; 3]) -> [f64; 3] {
    let mut least = [f64::INFINITY; 3];
    let mut works = works;
    for _ in 0..7 {
        for (least, work) in least.iter_mut().zip(&mut works) {
            *least = timed(work).0.min(*least);
        }
    }
    least
}

pub fn figure(side: usize) -> Figure {
    let mut all = vec![shares("5 spheres", &spheres(5), side), shares("100 spheres", &spheres(100), side)];
    if side > 8 {
        all.push(shares("1000 spheres", &spheres(1000), side));
    }
    let (columns, rows) = if side > 8 { (1000, 35) } else { (100, 10) };
    if let Some(scene) = knot(columns, rows) {
        let name = format!("mesh of {} triangles", grouped(u64::from(2 * columns * rows)));
        all.push(shares(&name, &scene, side));
    }
    let percent = |part: f64, whole: f64| format!("{:.0} %", 100.0 * (part / whole).min(1.0));
    let without = |s: &Shares| percent(s.scan, s.whole - s.search + s.scan);
    let mut table = Table::new(&["scene", "µs a pixel", "search", "share", "search, no structure", "share"])
        .title(&format!(
            "“About 95 %” of the time in intersections: {} for 5 spheres, {} for 100; with a structure {}",
            without(&all[0]),
            without(&all[1]),
            percent(all[1].search, all[1].whole)
        ))
        .subtitle(&format!(
            "{side} × {side} pixels, one point light, local illumination; the search is the same rays again without anything else; quickest of seven runs. \
             A mesh has its own hierarchy in both"
        ))
        .timed();
    for s in &all {
        let micro = |t: f64| format!("{:.2}", t * 1.0e6);
        table = table.row(&[
            &s.name,
            &micro(s.whole),
            &micro(s.search),
            &percent(s.search, s.whole),
            &micro(s.scan),
            &without(s),
        ]);
    }
    Figure::from(table).caption(
        "C (section 1.6) puts the search for intersections at about 95 % of a ray tracer's time. It depends on the scene: hardly any objects \
         leave more to shading, many without a structure bring it beyond, and a structure takes most of it away again.",
    )
}
