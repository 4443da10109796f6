//! A replayed pixel as a drawing: its rays in space, and the objects they met or were blocked by.

use super::figure::{Diagram, Figure, Light, Space};
use crate::ray::RayKind;
use crate::render::Traced;
use crate::scene::Scene;
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;

/// Degrees round the vertical axis and above the ground from which the drawing is seen.
const VIEW: (f64, f64) = (35.0, 20.0);
/// How far a ray that meets nothing is drawn [share of the scene's extent].
const BEYOND: f64 = 0.3;
/// Rays to lights farther than this [extents] are drawn as if they met nothing: the scene would shrink to a dot.
const FAR: f64 = 10.0;

/// Draws the rays of one pixel.
///
/// Camera rays are blue, reflected ones orange, refracted ones green; shadow rays are grey and dashed where they
/// reach the light, purple where an object blocks them. Objects appear as the boxes that bound them.
pub fn draw(scene: &Scene, rays: &[Traced], title: &str) -> Figure {
    let space = Space::axonometric(VIEW.0, VIEW.1);
    let mut met = BTreeSet::new();
    let mut points = Vec::new();
    for ray in rays {
        visit(ray, &mut |r| {
            met.extend(r.hit.map(|(i, _)| i).into_iter().chain(r.blocker));
            points.push(r.ray.origin);
        });
    }
    let mut diagram = Diagram::fitted().title(title).subtitle(
        "camera rays blue, reflected orange, refracted green; shadow rays grey, blocked ones purple",
    );
    let mut names = BTreeSet::new();
    for i in met {
        let bounds = scene.objects[i].bounds();
        if bounds.is_finite() {
            diagram = wireframe(diagram, &space, bounds.min, bounds.max);
            if names.insert(&scene.objects[i].name) {
                diagram = diagram.name(&scene.objects[i].name);
            }
            points.extend([bounds.min, bounds.max]);
        }
    }
    let extent = points.iter().fold(0.0f64, |m, p| m.max(p.distance(points[0])));
    for ray in rays {
        visit(ray, &mut |r| {
            let drawn = std::mem::replace(&mut diagram, Diagram::fitted());
            diagram = one_ray(drawn, &space, scene, r, extent);
        });
    }
    Figure::from(diagram.alt(&format!("{title}: {} rays from the camera, and what they caused", rays.len())))
}

fn visit(ray: &Traced, see: &mut impl FnMut(&Traced)) {
    see(ray);
    for child in &ray.children {
        visit(child, see);
    }
}

fn one_ray(diagram: Diagram, space: &Space, scene: &Scene, traced: &Traced, extent: f64) -> Diagram {
    let light = match (traced.kind, traced.blocker) {
        (RayKind::Shadow, None) => Light::Shadow,
        (RayKind::Shadow, Some(_)) => Light::Other,
        (RayKind::Reflected, _) => Light::Reflected,
        (RayKind::Refracted, _) => Light::Transmitted,
        _ => Light::Incident,
    };
    let blocked_at = |i: usize| scene.objects[i].shape().nearest(&traced.ray, 0.0, traced.t_max).map(|c| c.t);
    let end = match (&traced.hit, traced.blocker.and_then(blocked_at)) {
        (Some((_, hit)), _) => hit.point,
        (None, Some(t)) => traced.ray.at(t),
        (None, None) if traced.t_max * traced.ray.direction.length() <= FAR * extent => {
            traced.ray.at(traced.t_max)
        }
        (None, None) => traced.ray.origin + traced.ray.direction.normalize_or_zero() * (extent * BEYOND),
    };
    let [a, b] = [traced.ray.origin, end].map(|p| space.at(p));
    if a.distance(b) > 0.0 { diagram.ray(light, a, b) } else { diagram }
}

fn wireframe(mut diagram: Diagram, space: &Space, min: DVec3, max: DVec3) -> Diagram {
    let corner = |x: usize, y: usize, z: usize| -> DVec2 {
        let pick = |upper: usize, a: f64, b: f64| if upper == 1 { b } else { a };
        space.at(DVec3::new(pick(x, min.x, max.x), pick(y, min.y, max.y), pick(z, min.z, max.z)))
    };
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        diagram = diagram
            .thin(&[corner(0, i, j), corner(1, i, j)])
            .thin(&[corner(i, 0, j), corner(i, 1, j)])
            .thin(&[corner(i, j, 0), corner(i, j, 1)]);
    }
    diagram
}
